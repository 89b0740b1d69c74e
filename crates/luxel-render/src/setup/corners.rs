//! The corners of triangles: read from clusters or meshes, and brought before the eye.

use crate::context::{AttributeMask, ShadingContext};
use crate::setup::{COLOR, TANGENT, UVS, VertexExtras};
use luxel_math::{LANES, Lanes, Vec3, lanes_of};
use luxel_scene::Mesh;
use luxel_visibility::{InstanceSpace, SeenCluster, ShadingVertex, TriangleId, WindowRays, sides};

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

/// What lanes hold that have read nothing yet.
const NOTHING: ShadingVertex = [0.0; 8];

/// Reads the corners of up to sixteen triangles of one instance from memory.
pub(crate) struct CornerReader {
    /// What the corners of each lane's triangle carry: copies, so that lanes are transposed from places
    /// that are known.
    corners: [[ShadingVertex; LANES]; 3],
}

/// The corners of the triangles of one instance.
#[derive(Clone, Copy)]
pub(crate) struct ReadCorners<'c> {
    /// The lanes that hold triangles; others hold triangles that were read before.
    pub(crate) lanes: u32,
    pub(crate) instance: usize,
    /// The attributes of the mesh beside positions and normals.
    has: AttributeMask,
    corners: &'c [[ShadingVertex; LANES]; 3],
}

impl CornerReader {
    pub(crate) fn new() -> Self {
        Self { corners: [[NOTHING; LANES]; 3] }
    }

    /// Reads the triangle of the lowest of these lanes, and those of all others that are of the same
    /// instance; their materials, by number, into `materials`. `extras` gets their other attributes, by
    /// lane, where shading reads any.
    ///
    /// Cluster by cluster: sixteen neighbouring samples see triangles of few clusters, in turns from row
    /// to row. Asking each lane for its cluster took three times the instructions.
    #[inline(always)]
    pub(crate) fn read<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        (ids, of_lanes): (&[u32; LANES], u32),
        materials: &mut [u32; LANES],
        mut extras: impl FnMut(usize, &InstanceSpace, &Mesh, [u32; 3], AttributeMask),
    ) -> ReadCorners<'_> {
        let id = |lane: usize| TriangleId(ids[lane & (LANES - 1)]);
        let frame = scene.frame;
        let instance = frame.instance_of(id(of_lanes.trailing_zeros() as usize));
        let mesh = frame.instances()[instance].mesh;
        let has = AttributeMask::of_mesh(mesh);
        let (mut lanes, mut left) = (0, of_lanes);
        while left != 0 {
            let first = id(left.trailing_zeros() as usize);
            // One value alone compares the first lane only.
            let of_cluster =
                SeenCluster::lanes_of(simd, ids, first) & left | left & left.wrapping_neg();
            left &= !of_cluster;
            let cluster = frame.cluster(first);
            if cluster.instance() != instance {
                continue;
            }
            lanes |= of_cluster;
            let material = mesh.parts[cluster.part()].material.0;
            let reads = has.and(scene.attributes_of_materials[material as usize]);
            let kept = cluster.shading_corners();
            if let Some(kept) = &kept {
                for lane in lanes_of(of_cluster) {
                    let [a, b, c] = kept.of(id(lane));
                    materials[lane] = material;
                    self.corners[0][lane] = *a;
                    self.corners[1][lane] = *b;
                    self.corners[2][lane] = *c;
                }
            }
            if reads.any() || kept.is_none() {
                for lane in lanes_of(of_cluster) {
                    let attributes = mesh.attribute_corners()[cluster.triangle(id(lane)) as usize];
                    if kept.is_none() {
                        materials[lane] = material;
                        self.read_corners(mesh, lane, cluster.positions(id(lane)), attributes);
                    }
                    if reads.any() {
                        extras(lane, scene.space(instance), mesh, attributes, reads);
                    }
                }
            }
        }
        ReadCorners { lanes, instance, has, corners: &self.corners }
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
            self.corners[corner][lane] = [x, y, z, nx, ny, nz, 0.0, 0.0];
        }
    }
}

impl ReadCorners<'_> {
    /// The attributes that shading reads of a triangle, by its material's number.
    #[inline(always)]
    pub(crate) fn reads(&self, scene: &ShadingContext<'_>, material: u32) -> AttributeMask {
        self.has.and(scene.attributes_of_materials[material as usize])
    }

    /// Brings the triangles, from lane `first` on, before the eye; with the normals of their corners, `None`
    /// where the mesh has none.
    #[inline(always)]
    pub(crate) fn placed<N: Lanes>(
        &self,
        simd: N,
        scene: &ShadingContext<'_>,
        first: usize,
    ) -> (PlacedCorners<N>, Option<[Vec3<N>; 3]>) {
        let [ax, ay, az, anx, any, anz, ..] = self.columns(simd, 0, first);
        let [bx, by, bz, bnx, bny, bnz, ..] = self.columns(simd, 1, first);
        let [cx, cy, cz, cnx, cny, cnz, ..] = self.columns(simd, 2, first);
        let positions = [[ax, ay, az], [bx, by, bz], [cx, cy, cz]];
        let placed = PlacedCorners::new(scene.frame.rays(), scene.space(self.instance), positions);
        let has_normals = !scene.frame.instances()[self.instance].mesh.normals.is_empty();
        let normals =
            [Vec3::new(anx, any, anz), Vec3::new(bnx, bny, bnz), Vec3::new(cnx, cny, cnz)];
        (placed, has_normals.then_some(normals))
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
