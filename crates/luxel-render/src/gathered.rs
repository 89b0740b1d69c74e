//! Sixteen triangles made ready for shading at once: where nearly every sample of a block sees another
//! one, as on fine meshes.

use crate::shade::{Batch, Scene16, put_lane};
use crate::surface::Interpolated;
use crate::triangles::Attributes;
use crate::varying::{AtCorners, GatheredExtras, Weights, lanes_of, merge};
use luxel_math::{LANES, Mask, Number, Vec3};
use luxel_scene::Mesh;
use luxel_visibility::{Forms, InstanceSpace, SeenCluster, TriangleId, TriangleOf};

/// What is read of the triangles, lane by lane.
pub(crate) struct Gathered {
    of: [TriangleOf; LANES],
    /// About the mesh's origin.
    positions: AtCorners<3>,
    /// In the mesh's space.
    normals: AtCorners<3>,
    extras: GatheredExtras,
}

impl Gathered {
    pub(crate) fn new() -> Self {
        Self {
            of: [TriangleOf { instance: 0, triangle: 0, part: 0 }; LANES],
            positions: [[[0.0; LANES]; 3]; 3],
            normals: [[[0.0; LANES]; 3]; 3],
            extras: GatheredExtras {
                tangents: [[[0.0; LANES]; 4]; 3],
                uvs: [[[[0.0; LANES]; 2]; 3]; 2],
                colors: [[[0.0; LANES]; 4]; 3],
            },
        }
    }

    /// Interpolates at the places of a batch's samples.
    #[inline(always)]
    pub(crate) fn interpolate<N: Number>(
        &mut self,
        scene: &Scene16<'_>,
        batch: &Batch,
        places: [N::Wide; 2],
        interpolated: &mut Interpolated<N>,
    ) {
        let mut left = 0;
        // Neighbours are often of one cluster.
        let mut open: Option<SeenCluster<'_>> = None;
        for (lane, id) in batch.ids.map(TriangleId).into_iter().enumerate() {
            if id == TriangleId::NONE {
                continue;
            }
            let cluster = match open.take() {
                Some(cluster) if cluster.holds(id) => cluster,
                _ => scene.frame.cluster(id),
            };
            self.of[lane] = cluster.triangle(id);
            let [a, b, c] = cluster.positions(id);
            put(&mut self.positions[0], lane, a);
            put(&mut self.positions[1], lane, b);
            put(&mut self.positions[2], lane, c);
            left |= 1 << lane;
            open = Some(cluster);
        }
        interpolated.seen = left;
        // Nearly always one instance.
        while left != 0 {
            let instance = self.of[left.trailing_zeros() as usize & (LANES - 1)].instance;
            let lanes = self.gather(scene, instance, left, &mut interpolated.materials);
            self.interpolate_instance(scene, batch, places, instance, lanes, interpolated);
            left &= !lanes;
        }
    }

    /// Reads what the triangles of one instance have beside positions; which lanes see it.
    #[inline(always)]
    fn gather(
        &mut self,
        scene: &Scene16<'_>,
        instance: usize,
        of_lanes: u32,
        materials: &mut [u32; LANES],
    ) -> u32 {
        let mesh = scene.frame.instances()[instance].mesh;
        let attribute_corners = mesh.attribute_corners();
        let has = Attributes::of_mesh(mesh);
        let has_more = has != Attributes::default();
        let mut lanes = 0;
        for lane in lanes_of(of_lanes) {
            let lane = lane & (LANES - 1);
            let of = self.of[lane];
            if of.instance != instance {
                continue;
            }
            lanes |= 1 << lane;
            materials[lane] = mesh.parts[of.part].material.0;
            let attributes = attribute_corners[of.triangle as usize].map(|corner| corner as usize);
            for corner in 0..3 {
                if let Some(&normal) = mesh.normals.get(attributes[corner]) {
                    put(&mut self.normals[corner], lane, normal);
                }
            }
            if has_more {
                self.gather_attributes(mesh, &scene.spaces[instance], lane, attributes);
            }
        }
        lanes
    }

    fn gather_attributes(
        &mut self,
        mesh: &Mesh,
        space: &InstanceSpace,
        lane: usize,
        attributes: [usize; 3],
    ) {
        for (corner, attribute) in attributes.into_iter().enumerate() {
            for set in 0..2 {
                if let Some(&uv) = mesh.uvs[set].get(attribute) {
                    put(&mut self.extras.uvs[set][corner], lane, uv);
                }
            }
            if !mesh.tangents.is_empty() {
                put(&mut self.extras.tangents[corner], lane, space.tangent(mesh, attribute));
            }
            if let Some(&color) = mesh.colors.get(attribute) {
                put(&mut self.extras.colors[corner], lane, color);
            }
        }
    }

    #[inline(always)]
    fn interpolate_instance<N: Number>(
        &self,
        scene: &Scene16<'_>,
        batch: &Batch,
        [x, y]: [N::Wide; 2],
        instance: usize,
        lanes: u32,
        interpolated: &mut Interpolated<N>,
    ) {
        let like = interpolated.edge_distance;
        let mask = like.mask_of(lanes);
        let space = &scene.spaces[instance];
        let mesh = scene.frame.instances()[instance].mesh;
        let rays = scene.frame.rays();
        let in_view = space.view_from_local.corners(load(like, &self.positions));
        let forms = Forms::new(rays, in_view);
        let (mut weights, outside) = forms.told(x, y);
        for lane in lanes_of(outside.bits() & lanes) {
            let [x, y] = batch.position(lane);
            let forms = scene.frame.forms(self.of[lane & (LANES - 1)]);
            put_lane(&mut weights, lane, forms.nearest_on_edges(rays, x, y));
        }
        merge(&mut interpolated.weights, weights, mask);

        let in_mesh = if mesh.normals.is_empty() {
            None
        } else {
            let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = load(like, &self.normals);
            Some([Vec3::new(ax, ay, az), Vec3::new(bx, by, bz), Vec3::new(cx, cy, cz)])
        };
        let [a, b, c] = space.facing_normals(&in_view, forms.towards_eye(), in_mesh);
        let normal = a * weights[0] + b * weights[1] + c * weights[2];
        let [a, b, c] = in_view;
        let (a, b, c) = (space.about_eye(a), space.about_eye(b), space.about_eye(c));
        let position = a * weights[0] + b * weights[1] + c * weights[2];
        let varying = &mut interpolated.varying;
        varying.take_places(position, normal, mask);
        let has = Attributes::of_mesh(mesh);
        if has != Attributes::default() {
            let has_uvs = has.uvs[0] | has.uvs[1];
            let [right, below] = if has_uvs { forms.beside(x, y) } else { [weights; 2] };
            let weights = Weights { here: weights, right, below };
            varying.take_gathered(&self.extras, &weights, has, mask);
        }
    }
}

/// Writes a lane's components.
#[inline(always)]
fn put<const C: usize>(values: &mut [[f32; LANES]; C], lane: usize, new: [f32; C]) {
    for component in 0..C {
        values[component][lane & (LANES - 1)] = new[component];
    }
}

#[inline(always)]
fn load<N: Number>(like: N, [a, b, c]: &AtCorners<3>) -> [[N; 3]; 3] {
    [
        [like.of_lanes(&a[0]), like.of_lanes(&a[1]), like.of_lanes(&a[2])],
        [like.of_lanes(&b[0]), like.of_lanes(&b[1]), like.of_lanes(&b[2])],
        [like.of_lanes(&c[0]), like.of_lanes(&c[1]), like.of_lanes(&c[2])],
    ]
}
