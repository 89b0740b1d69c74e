//! The lighting equation a second time, naively and in f64, as an oracle for the tests.

#![allow(dead_code, reason = "each test file uses what it needs")]

use luxel_lighting::{
    Attenuation, Cone, Fog, FogLaw, Light, LightKind, LightingEnvironment, Material, PlacedLight,
    REFLECTION_MODELS, Reflectance, Reflection, SurfacePoint,
};

pub(crate) type V = [f64; 3];

pub(crate) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn times(a: V, k: f64) -> V {
    a.map(|c| c * k)
}

pub(crate) fn plus(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus(a: V, b: V) -> V {
    plus(a, times(b, -1.0))
}

pub(crate) fn product(a: V, b: V) -> V {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

pub(crate) fn unit(a: V) -> V {
    times(a, 1.0 / dot(a, a).sqrt())
}

pub(crate) fn wide(a: [f32; 3]) -> V {
    a.map(f64::from)
}

/// One light's terms.
pub(crate) struct NaiveLight {
    pub(crate) attenuation: f64,
    pub(crate) spot: f64,
    pub(crate) n_dot_l: f64,
    pub(crate) ambient: V,
    pub(crate) diffuse: V,
    pub(crate) specular: V,
}

/// All terms, without an environment.
pub(crate) struct Naive {
    pub(crate) emission: V,
    pub(crate) scene_ambient: V,
    pub(crate) lights: Vec<NaiveLight>,
    pub(crate) color: V,
}

pub(crate) fn equation(
    point: &SurfacePoint<f32>,
    reflectance: &Reflectance<f32>,
    material: &Material,
    lighting: &LightingEnvironment<'_>,
) -> Naive {
    let n = wide(point.normal.lane(0));
    let v = wide(point.view.lane(0));
    let p = wide(point.position.lane(0));
    let k_a = f64::from(material.k_a);
    let o_a = times(wide(reflectance.ambient.lane(0)), k_a * f64::from(reflectance.occlusion));
    let unlit = material.reflection == Reflection::Unlit;
    let emission = if unlit {
        times(wide(reflectance.diffuse.lane(0)), f64::from(material.k_d))
    } else {
        wide(reflectance.emission.lane(0))
    };
    let dark = if unlit { 0.0 } else { 1.0 };
    let scene_ambient = times(product(o_a, wide(lighting.scene_ambient())), dark);
    let mut color = plus(emission, scene_ambient);
    let mut lights = Vec::new();
    for placed in lighting.lights() {
        let light = placed.light();
        let axis = wide(placed.direction());
        let (to_light, attenuation) = if light.kind == LightKind::Directional {
            (times(axis, -1.0), 1.0)
        } else {
            let way = minus(wide(placed.position()), p);
            let d = dot(way, way).sqrt();
            (unit(way), falloff(&light.attenuation, d))
        };
        let spot = match light.kind {
            LightKind::Spot(cone) => brightness(cone, dot(times(to_light, -1.0), axis)),
            _ => 1.0,
        };
        let f = attenuation * spot;
        let (diffuse, specular) =
            bidirectional(&material.reflection, reflectance, material, n, v, to_light);
        let terms = NaiveLight {
            attenuation,
            spot,
            n_dot_l: dot(n, to_light),
            ambient: times(product(o_a, wide(light.ambient)), f * dark),
            diffuse: times(product(diffuse, wide(light.diffuse)), f),
            specular: times(product(specular, wide(light.specular)), f),
        };
        for term in [terms.ambient, terms.diffuse, terms.specular] {
            color = plus(color, term);
        }
        lights.push(terms);
    }
    if let Some(fog) = lighting.fog() {
        let s = fog_factor(fog, f64::from(point.depth));
        color = plus(times(color, s), times(wide(fog.color), 1.0 - s));
    }
    Naive { emission, scene_ambient, lights, color }
}

pub(crate) fn falloff(attenuation: &Attenuation, d: f64) -> f64 {
    let [c1, c2, c3] = wide(attenuation.coefficients);
    let window = match attenuation.range {
        Some(range) => {
            let ratio = d / f64::from(range);
            (1.0 - ratio * ratio * ratio * ratio).clamp(0.0, 1.0)
        }
        None => 1.0,
    };
    window * (1.0 / (c1 + c2 * d + c3 * d * d)).min(f64::from(attenuation.limit))
}

pub(crate) fn brightness(cone: Cone, cosine: f64) -> f64 {
    match cone {
        Cone::Exponent { cos_cutoff, exponent } => {
            if cosine < f64::from(cos_cutoff) {
                0.0
            } else {
                libm::pow(cosine.max(0.0), f64::from(exponent))
            }
        }
        Cone::Smooth { cos_inner, cos_outer } => {
            let t = (cosine - f64::from(cos_outer)) / f64::from(cos_inner - cos_outer);
            let t = t.clamp(0.0, 1.0);
            t * t
        }
    }
}

pub(crate) fn fog_factor(fog: &Fog, z: f64) -> f64 {
    match fog.law {
        FogLaw::DepthCue { near, far, front, back } => {
            let [near, far, front, back] = [near, far, front, back].map(f64::from);
            let t = ((z - near) / (far - near)).clamp(0.0, 1.0);
            front + (back - front) * t
        }
        FogLaw::Exponential { density } => libm::exp(-f64::from(density) * z),
        FogLaw::ExponentialSquared { density } => {
            let way = f64::from(density) * z;
            libm::exp(-way * way)
        }
    }
}

/// The factors of I_d and I_s.
pub(crate) fn bidirectional(
    reflection: &Reflection,
    reflectance: &Reflectance<f32>,
    material: &Material,
    n: V,
    v: V,
    l: V,
) -> (V, V) {
    let n_l = dot(n, l);
    let n_v = dot(n, v);
    let h = unit(plus(l, v));
    let shininess = f64::from(reflectance.shininess);
    let o_d = wide(reflectance.diffuse.lane(0));
    let kd_od = times(o_d, f64::from(material.k_d));
    let ks_os = times(wide(reflectance.specular.lane(0)), f64::from(material.k_s));
    let lambert = times(kd_od, n_l.max(0.0));
    let highlight = |cosine: f64| {
        if n_l > 0.0 { times(ks_os, libm::pow(cosine.max(0.0), shininess)) } else { [0.0; 3] }
    };
    match reflection {
        Reflection::Unlit | Reflection::Mirror => ([0.0; 3], [0.0; 3]),
        Reflection::Lambert => (lambert, [0.0; 3]),
        Reflection::Phong => {
            let r = minus(times(n, 2.0 * n_l), l);
            (lambert, highlight(dot(r, v)))
        }
        Reflection::BlinnPhong => (lambert, highlight(dot(n, h))),
        Reflection::Retro => (lambert, highlight(dot(v, l))),
        Reflection::Toon { steps } => {
            let steps = f64::from(*steps);
            let tone = |x: f64| (steps * x + 0.5).floor() / steps;
            let power = libm::pow(dot(n, h).max(0.0), shininess);
            let lit = if n_l > 0.0 { tone(power) } else { 0.0 };
            (times(kd_od, tone(n_l.clamp(0.0, 1.0))), times(ks_os, lit))
        }
        Reflection::OrenNayar => {
            if n_l <= 0.0 || n_v <= 0.0 {
                return ([0.0; 3], [0.0; 3]);
            }
            // By the angles, as the paper writes it.
            let (theta_i, theta_r) = (libm::acos(n_l), libm::acos(n_v));
            let (alpha, beta) = (theta_i.max(theta_r), theta_i.min(theta_r));
            let (l_flat, v_flat) = (minus(l, times(n, n_l)), minus(v, times(n, n_v)));
            let azimuth =
                dot(l_flat, v_flat) / (dot(l_flat, l_flat) * dot(v_flat, v_flat)).sqrt().max(1e-30);
            let s2 = f64::from(reflectance.roughness) * f64::from(reflectance.roughness);
            let a = 1.0 - 0.5 * s2 / (s2 + 0.33);
            let b = 0.45 * s2 / (s2 + 0.09);
            let slant = a + b * azimuth.max(0.0) * libm::sin(alpha) * libm::tan(beta);
            (times(lambert, slant), [0.0; 3])
        }
        Reflection::Microfacet => {
            if n_l <= 0.0 {
                return ([0.0; 3], [0.0; 3]);
            }
            let n_v = n_v.max(1e-4);
            let n_h = dot(n, h);
            let v_h = dot(v, h);
            let roughness = f64::from(reflectance.roughness);
            let alpha = (roughness * roughness).max(0.002);
            let a2 = alpha * alpha;
            let bell = n_h * n_h * (a2 - 1.0) + 1.0;
            let pi_d = if n_h > 0.0 { a2 / (bell * bell) } else { 0.0 };
            let g_v = n_l * (n_v * n_v * (1.0 - a2) + a2).sqrt();
            let g_l = n_v * (n_l * n_l * (1.0 - a2) + a2).sqrt();
            let visibility = 0.5 / (g_v + g_l);
            let metallic = f64::from(reflectance.metallic);
            let mut diffuse = [0.0; 3];
            let mut specular = [0.0; 3];
            for c in 0..3 {
                let f0 = 0.04 * (1.0 - metallic) + o_d[c] * metallic;
                let fresnel = f0 + (1.0 - f0) * libm::pow(1.0 - v_h, 5.0);
                diffuse[c] = (1.0 - fresnel) * (1.0 - metallic) * kd_od[c] * n_l;
                specular[c] = ks_os[c] * pi_d * visibility * fresnel * n_l;
            }
            (diffuse, specular)
        }
        Reflection::Mixed(parts) => {
            let mut sum = ([0.0; 3], [0.0; 3]);
            for (part, weight) in parts {
                let (d, s) = bidirectional(part, reflectance, material, n, v, l);
                sum.0 = plus(sum.0, times(d, f64::from(*weight)));
                sum.1 = plus(sum.1, times(s, f64::from(*weight)));
            }
            sum
        }
        other => panic!("no formula of its own for {other:?}"),
    }
}

/// Every model, and a mix.
pub(crate) fn models() -> Vec<Reflection> {
    let mixed = Reflection::mixed(vec![
        (Reflection::Phong, 0.3),
        (Reflection::mixed(vec![(Reflection::OrenNayar, 0.5), (Reflection::Retro, 0.25)]), 0.8),
    ]);
    REFLECTION_MODELS.iter().map(|model| model.reflection.clone()).chain([mixed]).collect()
}

/// Those whose light changes steadily, so that rounding changes it little.
pub(crate) fn steady_models() -> Vec<Reflection> {
    let is_toon = |model: &Reflection| matches!(model, Reflection::Toon { .. });
    models().into_iter().filter(|model| !model.models().any(is_toon)).collect()
}

/// A white light of intensity 1 before the surface, along -Z.
pub(crate) fn facing_light() -> PlacedLight {
    PlacedLight::new(Light::new(LightKind::Directional, [1.0; 3]), [0.0; 3], [0.0, 0.0, -1.0])
}
