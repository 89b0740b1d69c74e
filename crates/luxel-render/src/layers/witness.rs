//! The witness that keeps what layers show, for sixteen pixels.

use crate::context::ShadingContext;
use crate::interpolate::Fragments;
use crate::material::{SurfaceWitness, shading_normal};
use crate::shade::{BlockWitness, MixedLight};
use luxel_lighting::{LightTerms, SurfacePoint, Terms, Witness};
use luxel_math::{LANES, Lanes, Rgb, Vec3};

/// What was heard of a block.
pub(crate) struct LayerWitness<'w, N: Lanes> {
    simd: N,
    /// Whether the normals of normal maps are needed.
    pub(crate) maps_normals: bool,
    /// Whether terms of light are needed.
    pub(crate) hears_terms: bool,
    /// Barycentrics.
    pub(crate) weights: [N; 3],
    /// The texture of the base colour where light was computed elsewhere; 0 in other lanes.
    pub(crate) tint: Rgb<N>,
    pub(crate) position: Vec3<N>,
    /// Of unit length, with normal maps if they are needed.
    pub(crate) normal: Vec3<N>,
    pub(crate) uv: [N; 2],
    /// Along the viewing axis.
    pub(crate) depth: N,
    /// Sums of the terms of all lights, 0 where nothing is seen.
    pub(crate) ambient: Rgb<N>,
    pub(crate) diffuse: Rgb<N>,
    pub(crate) specular: Rgb<N>,
    pub(crate) emission: Rgb<N>,
    pub(crate) environment: Rgb<N>,
    /// (1 - s) I_dc
    pub(crate) fog: Rgb<N>,
    /// s
    pub(crate) fog_factor: N,
    /// Of the first light.
    pub(crate) n_dot_l: N,
    /// Openness.
    pub(crate) openness: N,
    /// By the light's place in the list; empty where no layer shows one light.
    pub(crate) of_lights: &'w mut [LightLanes],
    /// The lanes of the material that is lit.
    mask: N::Mask,
    /// What its lights add, before they are known to be all.
    sums: [Rgb<N>; 3],
}

/// What is kept of one light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightLanes {
    /// The sum of its terms.
    pub(crate) sum: [[f32; LANES]; 3],
    /// V
    pub(crate) visibility: [f32; LANES],
}

impl LightLanes {
    pub(crate) const NOTHING: Self = Self { sum: [[0.0; LANES]; 3], visibility: [1.0; LANES] };
}

impl<'w, N: Lanes> LayerWitness<'w, N> {
    /// Nothing heard yet; `like` selects the lane type. `of_lights` holds [`LightLanes::NOTHING`].
    #[inline(always)]
    pub(crate) fn new(
        simd: N,
        [maps_normals, hears_terms]: [bool; 2],
        of_lights: &'w mut [LightLanes],
    ) -> Self {
        let (zero, black) = (simd.zero(), Rgb::black(simd));
        let nowhere = Vec3::splat(simd, [0.0; 3]);
        Self {
            simd,
            maps_normals,
            hears_terms,
            weights: [zero; 3],
            tint: black,
            position: nowhere,
            normal: nowhere,
            uv: [zero; 2],
            depth: zero,
            ambient: black,
            diffuse: black,
            specular: black,
            emission: black,
            environment: black,
            fog: black,
            fog_factor: simd.one(),
            n_dot_l: zero,
            openness: simd.one(),
            of_lights,
            mask: simd.mask_of(0),
            sums: [black; 3],
        }
    }
}

impl<N: Lanes> LayerWitness<'_, N> {
    /// Takes the terms of a light where it was computed elsewhere, in the lanes that [`BlockWitness::lanes`] says.
    #[inline(always)]
    pub(crate) fn put_light(&mut self, index: usize, light: &MixedLight<N>) {
        let &MixedLight { ambient, diffuse, specular, n_dot_l, visibility } = light;
        self.add(ambient, diffuse, specular);
        if index == 0 {
            n_dot_l.put(self.mask, &mut self.n_dot_l);
        }
        self.keep_light(index, ambient + diffuse + specular, visibility);
    }

    /// Adds the terms of a light, in place: arrays of vectors are copied by calls.
    #[inline(always)]
    fn add(&mut self, ambient: Rgb<N>, diffuse: Rgb<N>, specular: Rgb<N>) {
        self.sums[0] = self.sums[0] + ambient;
        self.sums[1] = self.sums[1] + diffuse;
        self.sums[2] = self.sums[2] + specular;
    }

    /// Keeps the sum of a light's terms, and V.
    #[inline(always)]
    fn keep_light(&mut self, index: usize, sum: Rgb<N>, visibility: Option<N>) {
        let Some(kept) = self.of_lights.get_mut(index) else { return };
        if let Some(visibility) = visibility {
            let mut kept_lanes = self.simd.load(&kept.visibility, 0);
            visibility.put(self.mask, &mut kept_lanes);
            kept_lanes.store(&mut kept.visibility, 0);
        }
        for (kept, channel) in kept.sum.iter_mut().zip([sum.r, sum.g, sum.b]) {
            let mut lanes = self.simd.load(kept, 0);
            channel.put(self.mask, &mut lanes);
            lanes.store(kept, 0);
        }
    }

    /// Keeps the sums of all terms, after those of the lights.
    #[inline(always)]
    pub(crate) fn keep_terms(
        &mut self,
        emission: Rgb<N>,
        scene_ambient: Rgb<N>,
        environment: Rgb<N>,
    ) {
        let (mask, [ambient, diffuse, specular]) = (self.mask, self.sums);
        (scene_ambient + ambient).put(mask, &mut self.ambient);
        diffuse.put(mask, &mut self.diffuse);
        specular.put(mask, &mut self.specular);
        emission.put(mask, &mut self.emission);
        environment.put(mask, &mut self.environment);
    }
}

impl<N: Lanes> Witness<N> for LayerWitness<'_, N> {
    #[inline(always)]
    fn light(&mut self, index: usize, terms: &LightTerms<N>) {
        if !self.hears_terms {
            return;
        }
        self.add(terms.ambient, terms.diffuse, terms.specular);
        if index == 0 {
            terms.n_dot_l.put(self.mask, &mut self.n_dot_l);
        }
        self.keep_light(index, terms.ambient + terms.diffuse + terms.specular, terms.visibility);
    }

    #[inline(always)]
    fn openness(&mut self, openness: N) {
        openness.put(self.mask, &mut self.openness);
    }

    #[inline(always)]
    fn terms(&mut self, terms: &Terms<N>) {
        if !self.hears_terms {
            return;
        }
        self.keep_terms(terms.emission, terms.scene_ambient, terms.environment);
    }

    #[inline(always)]
    fn fog(&mut self, factor: N, color: Rgb<N>) {
        let fog = color * (factor.one() - factor);
        fog.put(self.mask, &mut self.fog);
        factor.put(self.mask, &mut self.fog_factor);
    }
}

impl<N: Lanes> SurfaceWitness<N> for LayerWitness<'_, N> {
    #[inline(always)]
    fn elsewhere(&mut self, _: &SurfacePoint<N>, tint: Rgb<N>, _: Rgb<N>) {
        tint.put(self.mask, &mut self.tint);
    }
}

impl<N: Lanes> BlockWitness<N> for LayerWitness<'_, N> {
    #[inline(always)]
    fn lanes(&mut self, lanes: u32) {
        self.mask = self.simd.mask_of(lanes);
        self.sums = [Rgb::black(self.simd); 3];
    }

    #[inline(always)]
    fn fragments(
        &mut self,
        scene: &ShadingContext<'_>,
        found: &Fragments<N>,
        materials: &[u32; LANES],
        point: &SurfacePoint<N>,
        seen: u32,
    ) {
        self.weights = found.weights;
        self.position = point.position;
        self.depth = point.depth;
        self.normal = point.normal;
        let [here, ..] = found.attributes.uv[0];
        self.uv = here;
        if self.maps_normals {
            let mut left = seen;
            while left != 0 {
                let number = materials[left.trailing_zeros() as usize & (LANES - 1)];
                let lanes = self.simd.eq_mask(materials, number) & left;
                left &= !lanes;
                let attributes = &found.attributes;
                let mapped =
                    shading_normal(scene, attributes, point.normal, number as usize, lanes);
                mapped.put(self.simd.mask_of(lanes), &mut self.normal);
            }
        }
    }
}
