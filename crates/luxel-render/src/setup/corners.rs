//! The corners of triangles: read from clusters or meshes, and brought before the eye.

use crate::context::{AttributeMask, ShadingContext};
use crate::setup::{COLOR, TANGENT, UVS, VertexExtras};
use luxel_math::{LANES, Lanes, Vec3, lanes_of};
use luxel_scene::Mesh;
use luxel_visibility::{InstanceSpace, ShadingVertex, TriangleId, WindowRays, sides};

/// Triangles of one instance before the eye, one or one a lane.
#[derive(Clone, Copy)]
pub(crate) struct PlacedCorners<N: Lanes> {
    /// The corners in view space.
    pub(crate) in_view: [[N::F64; 3]; 3],
    /// See [`sides`].
    pub(crate) sides: [Vec3<N>; 2],
    /// See [`WindowRays::towards_eye`].
    pub(crate) towards_eye: N::F64,
}

impl<N: Lanes> PlacedCorners<N> {
    /// Of positions about the mesh's origin.
    #[inline(always)]
    pub(crate) fn new(rays: &WindowRays, space: &InstanceSpace, positions: [[N; 3]; 3]) -> Self {
        let in_view = space.view_from_local.corners(positions);
        Self { in_view, sides: sides(&in_view), towards_eye: rays.towards_eye(&in_view) }
    }

    /// The corners' unit normals in world space, turned to the side that is seen.
    #[inline(always)]
    pub(crate) fn normals(
        &self,
        space: &InstanceSpace,
        in_mesh: Option<[Vec3<N>; 3]>,
    ) -> [Vec3<N>; 3] {
        space.facing_normals(self.sides, self.towards_eye, in_mesh)
    }

    /// The first corner about the eye, along the world's axes, and from there to the others.
    #[inline(always)]
    pub(crate) fn first_and_sides(&self, space: &InstanceSpace) -> [Vec3<N>; 3] {
        let [second, third] = self.sides;
        let first = space.about_eye(self.in_view[0]);
        [first, space.along_world(second), space.along_world(third)]
    }

    /// The corners' positions about the eye.
    #[inline(always)]
    pub(crate) fn positions(&self, space: &InstanceSpace) -> [Vec3<N>; 3] {
        let [first, second, third] = self.first_and_sides(space);
        [first, first + second, first + third]
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
    /// instance. `extras` gets their other attributes, by lane, where shading reads any.
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
                    extras(lane, scene.space(instance), mesh, attributes, reads);
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
    pub(crate) fn placed<N: Lanes>(
        &self,
        simd: N,
        scene: &ShadingContext<'_>,
        of: &ReadLanes,
        first: usize,
    ) -> PlacedCorners<N> {
        let [ax, ay, az, ..] = self.columns(simd, 0, first);
        let [bx, by, bz, ..] = self.columns(simd, 1, first);
        let [cx, cy, cz, ..] = self.columns(simd, 2, first);
        let positions = [[ax, ay, az], [bx, by, bz], [cx, cy, cz]];
        PlacedCorners::new(scene.frame.rays(), scene.space(of.instance), positions)
    }

    /// The normals of the triangles' corners, from lane `first` on; `None` where the mesh has none.
    #[inline(always)]
    pub(crate) fn normals_in_mesh<N: Lanes>(
        &self,
        simd: N,
        scene: &ShadingContext<'_>,
        of: &ReadLanes,
        first: usize,
    ) -> Option<[Vec3<N>; 3]> {
        if scene.frame.instances()[of.instance].mesh.normals.is_empty() {
            return None;
        }
        let [.., ax, ay, az, _, _] = self.columns(simd, 0, first);
        let [.., bx, by, bz, _, _] = self.columns(simd, 1, first);
        let [.., cx, cy, cz, _, _] = self.columns(simd, 2, first);
        Some([Vec3::new(ax, ay, az), Vec3::new(bx, by, bz), Vec3::new(cx, cy, cz)])
    }

    /// What a corner of each triangle carries, from lane `first` on.
    #[inline(always)]
    fn columns<N: Lanes>(&self, simd: N, corner: usize, first: usize) -> [N; 8] {
        let vertices = &self.corners[corner];
        simd.load_transposed(
            #[inline(always)]
            |lane| &vertices[(first + lane) & (LANES - 1)],
        )
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
