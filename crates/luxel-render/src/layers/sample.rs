//! Values of single samples: the numbers of what they see, and terms of light that is computed elsewhere.

use crate::context::ShadingContext;
use crate::explain::Lit;
use luxel_lighting::LightTerms;
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_view::Layer;
use luxel_visibility::TriangleId;

/// The numbers of what each lane sees.
pub(crate) struct Triangles {
    pub(crate) seen: u32,
    pub(crate) objects: [u32; LANES],
    pub(crate) triangles: [u32; LANES],
}

/// Direct-mapped cache of object and triangle numbers by id: neighbouring blocks see the same triangles.
pub(crate) struct RecentTriangles {
    /// Id, object and triangle, indexed by the id's low bits.
    entries: Box<[[u32; 3]; Self::COUNT]>,
}

impl RecentTriangles {
    const COUNT: usize = 128;

    pub(crate) fn new() -> Self {
        Self { entries: Box::new([[TriangleId::NONE.0; 3]; Self::COUNT]) }
    }

    /// The object and triangle numbers of an id; `None` if the frame has no such triangle.
    #[inline(always)]
    fn numbers(&mut self, scene: &ShadingContext<'_>, id: u32) -> Option<[u32; 2]> {
        let entry = &mut self.entries[id as usize % Self::COUNT];
        if entry[0] != id {
            let of = scene.frame.triangle(TriangleId(id))?;
            let (object, triangle) = scene.placed.object_of(of.instance, of.triangle);
            *entry = [id, object as u32, triangle.unwrap_or(u32::MAX)];
        }
        let [_, object, triangle] = *entry;
        Some([object, triangle])
    }
}

impl Triangles {
    #[inline(always)]
    pub(crate) fn of<N: Lanes>(
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        recent: &mut RecentTriangles,
    ) -> Self {
        let none = [u32::MAX; LANES];
        let mut found = Self { seen: 0, objects: none, triangles: none };
        let mut left = !simd.eq_mask(ids, TriangleId::NONE.0) & simd.all_lanes();
        while left != 0 {
            let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
            let lanes = simd.eq_mask(ids, id) & left;
            left &= !lanes;
            let Some([object, triangle]) = recent.numbers(scene, id) else { continue };
            found.seen |= lanes;
            for lane in lanes_of(lanes) {
                found.objects[lane & (LANES - 1)] = object;
                found.triangles[lane & (LANES - 1)] = triangle;
            }
        }
        found
    }
}

/// The value of a layer at one sample, of light that is computed elsewhere.
pub(crate) fn term(layer: &Layer, lit: &Lit) -> [f32; 3] {
    let plus = |a: [f32; 3], b: [f32; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let terms = &lit.terms;
    let each = |of: fn(&LightTerms<f32>) -> [f32; 3], first: [f32; 3]| {
        terms.lights.iter().fold(first, |sum, light| plus(sum, of(&light.terms)))
    };
    let (factor, fog) = lit.fog.unwrap_or((1.0, [0.0; 3]));
    let term = match layer {
        Layer::Ambient => each(|terms| terms.ambient.lane(0), terms.scene_ambient),
        Layer::Diffuse => each(|terms| terms.diffuse.lane(0), [0.0; 3]),
        Layer::Specular => each(|terms| terms.specular.lane(0), [0.0; 3]),
        Layer::Emission => terms.emission,
        Layer::Environment => terms.environment,
        Layer::Fog => return fog.map(|channel| channel * (1.0 - factor)),
        Layer::NDotL => return [terms.lights.first().map_or(0.0, |light| light.terms.n_dot_l); 3],
        Layer::Openness => return [lit.openness.unwrap_or(1.0); 3],
        Layer::Shadow(name) => {
            let light = terms.lights.iter().find(|light| light.name == *name);
            return [light.and_then(|light| light.terms.visibility).unwrap_or(1.0); 3];
        }
        Layer::Light(name) => {
            let light = terms.lights.iter().find(|light| light.name == *name);
            light.map_or([0.0; 3], |light| {
                let LightTerms { ambient, diffuse, specular, .. } = &light.terms;
                plus(plus(ambient.lane(0), diffuse.lane(0)), specular.lane(0))
            })
        }
        _ => [0.0; 3],
    };
    term.map(|channel| channel * factor)
}
