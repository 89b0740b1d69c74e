//! Sixteen triangles made ready for shading at once: where nearly every sample of a block sees another
//! one, as on fine meshes.

use crate::shade::{Batch, Scene16, put_lane};
use crate::triangles::Attributes;
use crate::varying::{GatheredExtras, Weights, lanes_of};
use crate::vertex::plain_light_at;
use luxel_math::{LANES, Mask, Number, Piecewise, Vec3};
use luxel_scene::Mesh;
use luxel_visibility::{Carried, Forms, InstanceSpace, TriangleId};

/// Up to so many triangles a block are made ready one by one, and kept for the next block; with more,
/// sixteen at once.
const FEW: usize = 4;

/// Whether these lanes see more than [`FEW`] triangles.
#[inline(always)]
pub(crate) fn has_many<N: Number>(like: N, ids: &[u32; LANES], mut lanes: u32) -> bool {
    for _ in 0..FEW {
        if lanes == 0 {
            return false;
        }
        let id = ids[lanes.trailing_zeros() as usize & (LANES - 1)];
        lanes &= !like.lanes_equal(ids, id);
    }
    lanes != 0
}

/// What lanes carry that are not looked at.
const NOTHING: Carried = [0.0; 8];

/// What is read of the triangles, lane by lane, and what comes of it.
pub(crate) struct Gathered {
    /// What each corner carries.
    corners: [[Carried; LANES]; 3],
    pub(crate) extras: GatheredExtras,
    /// Each lane's material, by number.
    pub(crate) materials: [u32; LANES],
    pub(crate) met: Met,
}

/// Where the samples' rays meet their triangles, lane by lane.
pub(crate) struct Met {
    pub(crate) weights: Weights<[f32; LANES]>,
    /// About the eye, along the world's axes.
    pub(crate) position: [[f32; LANES]; 3],
    /// In world space, turned to the side that is seen; not of unit length.
    pub(crate) normal: [[f32; LANES]; 3],
    /// Mixed from that of the corners.
    pub(crate) light: [[f32; LANES]; 3],
}

/// What is asked of triangles, beside the places where rays meet them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// Normals, and whatever else they have.
    Everything,
    /// Normals.
    Normals,
    /// The light that was computed at their corners, of plain triangles of one material.
    Lights,
}

/// The lanes that see one instance.
#[derive(Clone, Copy)]
pub(crate) struct OfInstance {
    pub(crate) lanes: u32,
    instance: usize,
    pub(crate) has: Attributes,
}

impl Gathered {
    pub(crate) fn new() -> Self {
        let nothing = [[0.0; LANES]; 3];
        Self {
            corners: [[[0.0; 8]; LANES]; 3],
            extras: GatheredExtras {
                tangents: [[[0.0; LANES]; 4]; 3],
                uvs: [[[[0.0; LANES]; 2]; 3]; 2],
                colors: [[[0.0; LANES]; 4]; 3],
            },
            materials: [0; LANES],
            met: Met {
                weights: Weights { here: nothing, right: nothing, below: nothing },
                position: nothing,
                normal: nothing,
                light: nothing,
            },
        }
    }

    /// Finds what the lowest of these lanes sees, and all others that see the same instance; `None`
    /// if light is asked for and there are several materials.
    #[inline(always)]
    pub(crate) fn meet<N: Number>(
        &mut self,
        like: N,
        scene: &Scene16<'_>,
        batch: &Batch,
        of_lanes: u32,
        wanted: Wanted,
    ) -> Option<OfInstance> {
        let of = self.read(scene, &batch.ids, of_lanes, wanted == Wanted::Everything);
        let mut lit_as = None;
        if wanted == Wanted::Lights {
            let materials = &self.materials;
            let material = materials[of.lanes.trailing_zeros() as usize & (LANES - 1)];
            if like.lanes_equal(materials, material) & of.lanes != of.lanes {
                return None;
            }
            lit_as = Some(material as usize);
        }
        like.piecewise(&mut Meeting { scene, batch, of, lit_as, gathered: self });
        Some(of)
    }

    /// Reads the triangles of one instance.
    #[inline(always)]
    pub(crate) fn read(
        &mut self,
        scene: &Scene16<'_>,
        ids: &[u32; LANES],
        of_lanes: u32,
        extras: bool,
    ) -> OfInstance {
        let id = |lane: usize| TriangleId(ids[lane & (LANES - 1)]);
        let mut cluster = scene.frame.cluster(id(of_lanes.trailing_zeros() as usize));
        let instance = cluster.instance();
        let mesh = scene.frame.instances()[instance].mesh;
        let attribute_corners = mesh.attribute_corners();
        let has = if extras { Attributes::of_mesh(mesh) } else { Attributes::default() };
        let has_more = has != Attributes::default();
        let mut material = mesh.parts[cluster.part()].material.0;
        let mut carried: [[&Carried; 3]; LANES] = [[&NOTHING; 3]; LANES];
        let mut is_carried = true;
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
            }
            lanes |= 1 << lane;
            self.materials[lane & (LANES - 1)] = material;
            if let Some(of_corners) = cluster.carried(id) {
                carried[lane & (LANES - 1)] = of_corners;
            } else {
                // The same for all triangles of a mesh.
                is_carried = false;
            }
            if has_more || !is_carried {
                let attributes = attribute_corners[cluster.triangle(id) as usize];
                if !is_carried {
                    self.read_corners(mesh, lane, cluster.positions(id), attributes);
                }
                if has_more {
                    self.read_extras(mesh, &scene.spaces[instance], lane, attributes);
                }
            }
        }
        if is_carried {
            // All in one go, so that none waits while another is on its way from memory.
            for lane in 0..LANES {
                for corner in 0..3 {
                    self.corners[corner][lane] = *carried[lane][corner];
                }
            }
        }
        OfInstance { lanes, instance, has }
    }

    /// Brings the triangles of one instance, from lane `first` on, before the eye.
    #[inline(always)]
    pub(crate) fn placed<N: Number>(
        &self,
        like: N,
        scene: &Scene16<'_>,
        of: &OfInstance,
        first: usize,
    ) -> Placed<N> {
        let space = &scene.spaces[of.instance];
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
        let in_view = space.view_from_local.corners([[ax, ay, az], [bx, by, bz], [cx, cy, cz]]);
        let forms = Forms::new(scene.frame.rays(), in_view);
        let in_mesh = if scene.frame.instances()[of.instance].mesh.normals.is_empty() {
            None
        } else {
            Some([Vec3::new(anx, any, anz), Vec3::new(bnx, bny, bnz), Vec3::new(cnx, cny, cnz)])
        };
        let normals = space.facing_normals(&in_view, forms.towards_eye(), in_mesh);
        let [a, b, c] = in_view;
        let about_eye = [space.about_eye(a), space.about_eye(b), space.about_eye(c)];
        Placed { forms, about_eye, normals }
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

    fn read_extras(
        &mut self,
        mesh: &Mesh,
        space: &InstanceSpace,
        lane: usize,
        attributes: [u32; 3],
    ) {
        for (corner, attribute) in attributes.into_iter().enumerate() {
            let attribute = attribute as usize;
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
}

/// A triangle for each lane, before the eye.
pub(crate) struct Placed<N: Number> {
    pub(crate) forms: Forms<N::Wide>,
    /// Corners about the eye, along the world's axes.
    pub(crate) about_eye: [Vec3<N>; 3],
    /// The corners' unit normals in world space, turned to the side that is seen.
    pub(crate) normals: [Vec3<N>; 3],
}

/// Rays and triangles on their way to [`Met`]. Corners are f64, of which sixteen lanes fill more
/// registers than there are: done piece by piece.
struct Meeting<'a> {
    scene: &'a Scene16<'a>,
    batch: &'a Batch,
    of: OfInstance,
    /// The material by which corners are lit, if they are.
    lit_as: Option<usize>,
    gathered: &'a mut Gathered,
}

impl Piecewise for Meeting<'_> {
    #[inline(always)]
    fn piece<N: Number>(&mut self, like: N, first: usize) {
        let Self { scene, batch, of, .. } = *self;
        let lanes = of.lanes >> first;
        let rays = scene.frame.rays();
        let [x, y] = batch.places_from(like, first);
        let Placed { forms, about_eye, normals } = self.gathered.placed(like, scene, &of, first);
        let (mut weights, outside) = forms.told(x, y);
        for lane in lanes_of(outside.bits() & lanes) {
            let id = TriangleId(batch.ids[(first + lane) & (LANES - 1)]);
            let Some(triangle) = scene.frame.triangle(id) else { continue };
            let [x, y] = batch.position(first + lane);
            let nearest = scene.frame.forms(triangle).nearest_on_edges(rays, x, y);
            put_lane(&mut weights, lane, nearest);
        }
        let [a, b, c] = about_eye;
        let [na, nb, nc] = normals;
        let position = a * weights[0] + b * weights[1] + c * weights[2];

        let mask = like.mask_of(lanes);
        let met = &mut self.gathered.met;
        store(&mut met.weights.here, weights, mask, first);
        store(&mut met.position, [position.x, position.y, position.z], mask, first);
        if let Some(material) = self.lit_as {
            let light = plain_light_at(scene, &a, &na, material) * weights[0]
                + plain_light_at(scene, &b, &nb, material) * weights[1]
                + plain_light_at(scene, &c, &nc, material) * weights[2];
            store(&mut met.light, [light.r, light.g, light.b], mask, first);
            return;
        }
        let normal = na * weights[0] + nb * weights[1] + nc * weights[2];
        store(&mut met.normal, [normal.x, normal.y, normal.z], mask, first);
        if of.has.uvs[0] | of.has.uvs[1] {
            let [right, below] = forms.beside(x, y);
            store(&mut met.weights.right, right, mask, first);
            store(&mut met.weights.below, below, mask, first);
        }
    }
}

/// Writes values where the mask is true.
#[inline(always)]
fn store<N: Number>(into: &mut [[f32; LANES]; 3], new: [N; 3], mask: N::Mask, first: usize) {
    for (into, new) in into.iter_mut().zip(new) {
        new.select(mask, new.load(into, first)).store(into, first);
    }
}

/// Writes a lane's components.
#[inline(always)]
fn put<const C: usize>(values: &mut [[f32; LANES]; C], lane: usize, new: [f32; C]) {
    for component in 0..C {
        values[component][lane & (LANES - 1)] = new[component];
    }
}

/// Three components from lane `first` on.
#[inline(always)]
pub(crate) fn loaded<N: Number>(like: N, [x, y, z]: &[[f32; LANES]; 3], first: usize) -> [N; 3] {
    [like.load(x, first), like.load(y, first), like.load(z, first)]
}
