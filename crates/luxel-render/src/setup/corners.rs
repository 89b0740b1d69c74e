//! The corners of triangles: read from clusters or meshes, and brought before the eye.

use crate::context::{AttributeMask, ShadingContext};
use crate::setup::{COLOR, TANGENT, UVS, VertexExtras};
use luxel_math::{LANES, Number, Vec3, lanes_of};
use luxel_scene::Mesh;
use luxel_visibility::{Forms, InstanceSpace, ShadingVertex, TriangleId, WindowRays};

/// Triangles of one instance before the eye, one or one a lane.
pub(crate) struct PlacedCorners<N: Number> {
    pub(crate) forms: Forms<N::Wide>,
    /// The first corner about the eye, along the world's axes.
    pub(crate) first: Vec3<N>,
    /// From the first corner to the second, and to the third.
    pub(crate) sides: [Vec3<N>; 2],
    /// The corners' unit normals in world space, turned to the side that is seen.
    pub(crate) normals: [Vec3<N>; 3],
}

impl<N: Number> PlacedCorners<N> {
    /// Of positions about the mesh's origin, and the normals that the mesh has.
    #[inline(always)]
    pub(crate) fn new(
        rays: &WindowRays,
        space: &InstanceSpace,
        positions: [[N; 3]; 3],
        normals_in_mesh: Option<[Vec3<N>; 3]>,
    ) -> Self {
        let in_view = space.view_from_local.corners(positions);
        let forms = Forms::new(rays, in_view);
        let normals = space.facing_normals(&in_view, forms.towards_eye(), normals_in_mesh);
        let [a, b, c] = in_view;
        // Differences are taken in f64: small triangles far away keep their digits.
        let sides = [
            space.about_eye([b[0] - a[0], b[1] - a[1], b[2] - a[2]]),
            space.about_eye([c[0] - a[0], c[1] - a[1], c[2] - a[2]]),
        ];
        Self { forms, first: space.about_eye(a), sides, normals }
    }

    /// The corners' positions about the eye.
    #[inline(always)]
    pub(crate) fn positions(&self) -> [Vec3<N>; 3] {
        let [second, third] = self.sides;
        [self.first, self.first + second, self.first + third]
    }
}

/// What lanes hold that read nothing.
const NOTHING: ShadingVertex = [0.0; 8];

/// The corners of up to sixteen triangles of one instance, as they are read from memory.
pub(crate) struct CornerReader {
    corners: [[ShadingVertex; LANES]; 3],
    /// Each lane's material, by number, and the attributes that shading reads of it.
    pub(crate) materials: [u32; LANES],
    pub(crate) reads: [AttributeMask; LANES],
}

/// The lanes that hold triangles of one instance.
#[derive(Clone, Copy)]
pub(crate) struct ReadLanes {
    pub(crate) lanes: u32,
    pub(crate) instance: usize,
}

impl CornerReader {
    pub(crate) fn new() -> Self {
        Self {
            corners: [[NOTHING; LANES]; 3],
            materials: [0; LANES],
            reads: [AttributeMask::NONE; LANES],
        }
    }

    /// Reads the triangle of the lowest of these lanes, and those of all others that are of the same
    /// instance. `extras` gets their other attributes, by lane, where shading reads some of `wanted`.
    #[inline(always)]
    pub(crate) fn read(
        &mut self,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        of_lanes: u32,
        mut extras: impl FnMut(usize, &InstanceSpace, &Mesh, [u32; 3], AttributeMask),
    ) -> ReadLanes {
        let id = |lane: usize| TriangleId(ids[lane & (LANES - 1)]);
        let mut cluster = scene.frame.cluster(id(of_lanes.trailing_zeros() as usize));
        let instance = cluster.instance();
        let mesh = scene.frame.instances()[instance].mesh;
        let attribute_corners = mesh.attribute_corners();
        let has = AttributeMask::of_mesh(mesh);
        let reads_of = |material: u32| has.and(scene.attributes_of_materials[material as usize]);
        let mut material = mesh.parts[cluster.part()].material.0;
        let mut reads = reads_of(material);
        let mut vertices: [[&ShadingVertex; 3]; LANES] = [[&NOTHING; 3]; LANES];
        let mut are_kept = true;
        let mut lanes = 0;
        for lane in lanes_of(of_lanes) {
            let id = id(lane);
            // Neighbours are often of one cluster.
            if !cluster.holds(id) {
                let other = scene.frame.cluster(id);
                if other.instance() != instance {
                    continue;
                }
                cluster = other;
                material = mesh.parts[cluster.part()].material.0;
                reads = reads_of(material);
            }
            lanes |= 1 << lane;
            self.materials[lane & (LANES - 1)] = material;
            self.reads[lane & (LANES - 1)] = reads;
            if let Some(of_corners) = cluster.shading_vertices(id) {
                vertices[lane & (LANES - 1)] = of_corners;
            } else {
                // The same for all triangles of a mesh.
                are_kept = false;
            }
            if reads.any() || !are_kept {
                let attributes = attribute_corners[cluster.triangle(id) as usize];
                if !are_kept {
                    self.read_corners(mesh, lane, cluster.positions(id), attributes);
                }
                if reads.any() {
                    extras(lane, &scene.spaces[instance], mesh, attributes, reads);
                }
            }
        }
        if are_kept {
            // All in one go, so that none waits while another is on its way from memory.
            for lane in 0..LANES {
                for corner in 0..3 {
                    self.corners[corner][lane] = *vertices[lane][corner];
                }
            }
        }
        ReadLanes { lanes, instance }
    }

    #[inline(always)]
    fn read_corners(
        &mut self,
        mesh: &Mesh,
        lane: usize,
        positions: [[f32; 3]; 3],
        attributes: [u32; 3],
    ) {
        for corner in 0..3 {
            let [x, y, z] = positions[corner];
            let normal = mesh.normals.get(attributes[corner] as usize);
            let [nx, ny, nz] = normal.copied().unwrap_or_default();
            self.corners[corner][lane & (LANES - 1)] = [x, y, z, nx, ny, nz, 0.0, 0.0];
        }
    }

    /// Brings the triangles, from lane `first` on, before the eye.
    #[inline(always)]
    pub(crate) fn placed<N: Number>(
        &self,
        like: N,
        scene: &ShadingContext<'_>,
        of: &ReadLanes,
        first: usize,
    ) -> PlacedCorners<N> {
        let [a, b, c] = &self.corners;
        let [ax, ay, az, anx, any, anz, ..] = like.columns(
            #[inline(always)]
            |lane| &a[(first + lane) & (LANES - 1)],
        );
        let [bx, by, bz, bnx, bny, bnz, ..] = like.columns(
            #[inline(always)]
            |lane| &b[(first + lane) & (LANES - 1)],
        );
        let [cx, cy, cz, cnx, cny, cnz, ..] = like.columns(
            #[inline(always)]
            |lane| &c[(first + lane) & (LANES - 1)],
        );
        let positions = [[ax, ay, az], [bx, by, bz], [cx, cy, cz]];
        let normals =
            [Vec3::new(anx, any, anz), Vec3::new(bnx, bny, bnz), Vec3::new(cnx, cny, cnz)];
        let has_normals = !scene.frame.instances()[of.instance].mesh.normals.is_empty();
        let normals = has_normals.then_some(normals);
        PlacedCorners::new(scene.frame.rays(), &scene.spaces[of.instance], positions, normals)
    }
}

impl VertexExtras {
    /// Reads the attributes of a triangle's corners.
    pub(crate) fn read(
        &mut self,
        space: &InstanceSpace,
        mesh: &Mesh,
        attributes: [u32; 3],
        reads: AttributeMask,
    ) {
        let attributes = attributes.map(|attribute| attribute as usize);
        for set in 0..2 {
            let uvs = if reads.has(AttributeMask::UVS[set]) {
                attributes.map(|attribute| mesh.uvs[set][attribute])
            } else {
                [[0.0; 2]; 3]
            };
            self.put(UVS[set], uvs);
        }
        let tangents = if reads.has(AttributeMask::TANGENTS) {
            attributes.map(|attribute| space.tangent(mesh, attribute))
        } else {
            [[0.0; 4]; 3]
        };
        self.put(TANGENT, tangents);
        let colors = if reads.has(AttributeMask::COLORS) {
            attributes.map(|attribute| mesh.colors[attribute])
        } else {
            [[1.0; 4]; 3]
        };
        self.put(COLOR, colors);
    }
}
