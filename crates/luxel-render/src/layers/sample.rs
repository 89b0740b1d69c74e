//! Values of single samples: the numbers of what they see, and terms of light that is computed elsewhere.

use crate::context::ShadingContext;
use crate::explain::Lit;
use luxel_lighting::LightTerms;
use luxel_math::LANES;
use luxel_view::Layer;
use luxel_visibility::TriangleId;

/// The numbers of what each lane sees.
pub(crate) struct Triangles {
    pub(crate) seen: u32,
    pub(crate) objects: [u32; LANES],
    pub(crate) triangles: [u32; LANES],
}

impl Triangles {
    #[inline(always)]
    pub(crate) fn of(scene: &ShadingContext<'_>, ids: &[u32; LANES]) -> Self {
        let none = [u32::MAX; LANES];
        let mut found = Self { seen: 0, objects: none, triangles: none };
        let mut last: Option<(u32, u32, u32)> = None;
        for (lane, &id) in ids.iter().enumerate() {
            if id == TriangleId::NONE.0 {
                continue;
            }
            // Neighbours mostly see the same.
            let (object, triangle) = match last {
                Some((of, object, triangle)) if of == id => (object, triangle),
                _ => {
                    let Some(of) = scene.frame.triangle(TriangleId(id)) else { continue };
                    let (object, triangle) = scene.placed.object_of(of);
                    (object as u32, triangle.unwrap_or(u32::MAX))
                }
            };
            last = Some((id, object, triangle));
            found.seen |= 1 << lane;
            found.objects[lane] = object;
            found.triangles[lane] = triangle;
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
