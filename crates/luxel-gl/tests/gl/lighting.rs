//! Lighting (section 2.13) against the specification's formula in f64.

use crate::canvas::{gl, pixels};
use luxel_gl::{Configuration, Context};
use proptest::prelude::*;

/// A light as a program sets it, with an identity for the modelview matrix.
#[derive(Clone, Debug)]
struct Light {
    position: [f64; 4],
    ambient: [f64; 3],
    diffuse: [f64; 3],
    specular: [f64; 3],
    attenuation: [f64; 3],
    direction: [f64; 3],
    exponent: f64,
    cutoff: f64,
}

#[derive(Clone, Debug)]
struct Setup {
    lights: Vec<Light>,
    model_ambient: [f64; 3],
    local_viewer: bool,
    separate: bool,
    ambient: [f64; 3],
    diffuse: [f64; 4],
    specular: [f64; 3],
    emission: [f64; 3],
    shininess: f64,
    vertex: [f64; 3],
    normal: [f64; 3],
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    if length > 0.0 { a.map(|component| component / length) } else { a }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The formula of section 2.13.1, clamped, secondary colour added; alpha is the diffuse one's.
fn formula(setup: &Setup) -> [f64; 4] {
    let mut primary: [f64; 3] =
        std::array::from_fn(|at| setup.emission[at] + setup.ambient[at] * setup.model_ambient[at]);
    let mut secondary = [0.0; 3];
    let n = setup.normal;
    for light in &setup.lights {
        let [x, y, z, w] = light.position;
        let (to_light, attenuation) = if w == 0.0 {
            ([x, y, z], 1.0)
        } else {
            let way = minus([x / w, y / w, z / w], setup.vertex);
            let d = dot(way, way).sqrt();
            let [k0, k1, k2] = light.attenuation;
            (way, 1.0 / (k0 + k1 * d + k2 * d * d))
        };
        let l = unit(to_light);
        let spot = if light.cutoff == 180.0 {
            1.0
        } else {
            let cosine = -dot(l, unit(light.direction));
            let inside = cosine >= libm::cos(light.cutoff.to_radians());
            if inside { libm::pow(cosine.max(0.0), light.exponent) } else { 0.0 }
        };
        let view = if setup.local_viewer {
            unit(setup.vertex.map(|component| -component))
        } else {
            [0.0, 0.0, 1.0]
        };
        let half = unit([l[0] + view[0], l[1] + view[1], l[2] + view[2]]);
        let n_dot_l = dot(n, l);
        let f = attenuation * spot;
        for at in 0..3 {
            primary[at] += f * light.ambient[at] * setup.ambient[at];
            primary[at] += f * n_dot_l.max(0.0) * light.diffuse[at] * setup.diffuse[at];
            if n_dot_l > 0.0 {
                let power = libm::pow(dot(n, half).max(0.0), setup.shininess);
                secondary[at] += f * power * light.specular[at] * setup.specular[at];
            }
        }
    }
    let clamp = |value: f64| value.clamp(0.0, 1.0);
    let sum = |at: usize| {
        if setup.separate {
            clamp(clamp(primary[at]) + clamp(secondary[at]))
        } else {
            clamp(primary[at] + secondary[at])
        }
    };
    [sum(0), sum(1), sum(2), clamp(setup.diffuse[3])]
}

/// The colour of a point that is lit so.
fn drawn(setup: &Setup) -> [u8; 4] {
    let mut context = Context::new(Configuration::default());
    context.resize_default(1, 1);
    context.matrix_mode(gl::PROJECTION);
    context.ortho(-9.0, 9.0, -9.0, 9.0, -9.0, 9.0);
    context.matrix_mode(gl::MODELVIEW);
    context.point_size(64.0);
    context.enable(gl::LIGHTING);
    let rgb = |color: [f64; 3]| [color[0] as f32, color[1] as f32, color[2] as f32, 1.0];
    context.light_model(0x0B53, &rgb(setup.model_ambient));
    context.light_model(0x0B51, &[f32::from(u8::from(setup.local_viewer))]);
    context.light_model(0x81F8, &[if setup.separate { 33274.0 } else { 33273.0 }]);
    for (name, light) in (gl::LIGHT0..).zip(&setup.lights) {
        context.enable(name);
        context.light(name, 0x1200, &rgb(light.ambient));
        context.light(name, 0x1201, &rgb(light.diffuse));
        context.light(name, 0x1202, &rgb(light.specular));
        context.light(name, 0x1203, &light.position.map(|value| value as f32));
        context.light(name, 0x1204, &rgb(light.direction));
        context.light(name, 0x1205, &[light.exponent as f32]);
        context.light(name, 0x1206, &[light.cutoff as f32]);
        for (pname, value) in (0x1207..).zip(light.attenuation) {
            context.light(name, pname, &[value as f32]);
        }
    }
    context.material(0x0408, 0x1200, &rgb(setup.ambient));
    context.material(0x0408, 0x1201, &setup.diffuse.map(|value| value as f32));
    context.material(0x0408, 0x1202, &rgb(setup.specular));
    context.material(0x0408, 0x1600, &rgb(setup.emission));
    context.material(0x0408, 0x1601, &[setup.shininess as f32]);
    context.begin(gl::POINTS);
    context.normal(setup.normal.map(|value| value as f32));
    let [x, y, z] = setup.vertex.map(|value| value as f32);
    context.vertex([x, y, z, 1.0]);
    context.end();
    assert_eq!(context.get_error(), gl::NO_ERROR);
    pixels(&mut context)[0]
}

prop_compose! {
    fn color(high: f64)(color in [0.0..high, 0.0..high, 0.0..high]) -> [f64; 3] { color }
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0_f64].prop_filter("a direction", |d| dot(*d, *d) > 0.1)
}

prop_compose! {
    fn light()(
        place in direction(), w in prop_oneof![Just(0.0), 0.2..1.0],
        ambient in color(0.2), diffuse in color(1.0), specular in color(1.0),
        attenuation in [0.5..1.5, 0.0..0.3, 0.0..0.1], direction in direction(),
        exponent in prop_oneof![Just(0.0), 0.0..20.0],
        cutoff in prop_oneof![Just(180.0), Just(180.0), 20.0..89.0],
    ) -> Light {
        let [x, y, z] = place.map(|component| component * 3.0);
        Light { position: [x, y, z, w], ambient, diffuse, specular, attenuation, direction, exponent, cutoff }
    }
}

prop_compose! {
    fn setup()(
        lights in prop::collection::vec(light(), 1..4), model_ambient in color(0.4),
        local_viewer: bool, separate: bool, ambient in color(1.0), diffuse in color(1.0),
        alpha in 0.0..1.0, specular in color(1.0), emission in color(0.2),
        shininess in prop_oneof![Just(0.0), Just(32.0), 0.0..128.0],
        vertex in [-3.0..3.0, -3.0..3.0, -3.0..3.0], normal in direction(),
    ) -> Setup {
        let [r, g, b] = diffuse;
        Setup {
            lights, model_ambient, local_viewer, separate, ambient, diffuse: [r, g, b, alpha], specular,
            emission, shininess: f64::from(shininess as f32), vertex, normal: unit(normal),
        }
    }
}

/// Whether rounding may decide the result: at the edge of a cone, or where N.L is near 0.
fn on_an_edge(setup: &Setup) -> bool {
    setup.lights.iter().any(|light| {
        let [x, y, z, w] = light.position;
        let way = if w == 0.0 { [x, y, z] } else { minus([x / w, y / w, z / w], setup.vertex) };
        let l = unit(way);
        let cosine = -dot(l, unit(light.direction));
        (cosine - libm::cos(light.cutoff.to_radians())).abs() < 1e-4
            || dot(setup.normal, l).abs() < 1e-4
            || dot(way, way) < 1e-2
    })
}

proptest! {
    #[test]
    fn section_2_13_1_colours_are_those_of_the_formula(setup in setup()) {
        prop_assume!(!on_an_edge(&setup));
        let (expected, found) = (formula(&setup), drawn(&setup));
        for at in 0..4 {
            let difference = (f64::from(found[at]) - expected[at] * 255.0).abs();
            prop_assert!(difference < 0.51 + 1e-2, "{:?} instead of {:?}", found, expected.map(|c| c * 255.0));
        }
    }

    #[test]
    fn section_2_13_1_the_back_is_lit_with_the_turned_normal_and_its_own_material(setup in setup()) {
        let turned = setup.normal.map(|component| -component);
        prop_assume!(!on_an_edge(&setup));
        // A clockwise triangle over everything, with constant attributes at the place of the point.
        let mut context = Context::new(Configuration::default());
        context.resize_default(1, 1);
        context.light_model(0x0B52, &[1.0]);
        context.enable(gl::LIGHTING);
        context.enable(gl::LIGHT0);
        let light = &setup.lights[0];
        let [x, y, z, _] = light.position.map(|value| value as f32);
        context.light(gl::LIGHT0, 0x1203, &[x, y, z, 0.0]);
        context.light_model(0x0B53, &[0.0, 0.0, 0.0, 1.0]);
        context.material(0x0404, 0x1201, &[1.0, 0.0, 0.0, 1.0]);
        context.material(0x0405, 0x1201, &[0.0, 1.0, 0.0, 1.0]);
        context.normal(setup.normal.map(|value| value as f32));
        context.begin(gl::TRIANGLES);
        for [x, y] in [[-5.0, -5.0], [0.0, 9.0], [5.0, -5.0]] {
            context.vertex([x, y, 0.0, 1.0]);
        }
        context.end();
        let l = unit([f64::from(x), f64::from(y), f64::from(z)]);
        let cosine = dot(turned, l).max(0.0);
        let [r, g, b, _] = pixels(&mut context)[0];
        prop_assert_eq!([r, b], [0, 0]);
        prop_assert!((f64::from(g) - cosine * 255.0).abs() < 0.52, "{} instead of {}", g, cosine * 255.0);
    }
}

#[test]
fn section_2_10_3_normals_are_scaled_or_brought_to_unit_length() {
    let lit = |scale: f64, capability: Option<u32>| {
        let mut context = Context::new(Configuration::default());
        context.resize_default(1, 1);
        context.enable(gl::LIGHTING);
        context.enable(gl::LIGHT0);
        context.light_model(0x0B53, &[0.0, 0.0, 0.0, 1.0]);
        context.light(gl::LIGHT0, 0x1203, &[0.0, 0.0, 1.0, 0.0]);
        context.material(0x0408, 0x1201, &[0.25, 0.25, 0.25, 1.0]);
        if let Some(capability) = capability {
            context.enable(capability);
        }
        context.scale(scale, scale, scale);
        context.point_size(64.0);
        context.begin(gl::POINTS);
        context.vertex([0.0, 0.0, 0.0, 1.0]);
        context.end();
        pixels(&mut context)[0][0]
    };
    // N is multiplied by the inverse: twice as large an object has half as long normals.
    assert_eq!([lit(1.0, None), lit(2.0, None), lit(0.5, None)], [64, 32, 128]);
    for capability in [0x0BA1, 0x803A] {
        assert_eq!([lit(2.0, Some(capability)), lit(0.5, Some(capability))], [64, 64]);
    }
}

#[test]
fn section_2_13_3_the_current_colour_drives_materials_vertex_by_vertex() {
    let mut context = Context::new(Configuration::default());
    context.resize_default(2, 1);
    context.enable(gl::LIGHTING);
    context.light_model(0x0B53, &[1.0; 4]);
    context.color_material(0x0408, 0x1200);
    context.enable(0x0B57);
    context.begin(gl::POINTS);
    for (x, color) in [(-0.5, [1.0, 0.0, 0.5, 1.0]), (0.5, [0.0, 1.0, 0.25, 1.0])] {
        context.color(color);
        context.vertex([x, 0.0, 0.0, 1.0]);
    }
    context.end();
    assert_eq!(pixels(&mut context), [[255, 0, 128, 255], [0, 255, 64, 255]]);
    assert_eq!(context.get_material(0x0404, 0x1200).unwrap().to_f32(1), 1.0);
    // Materials between vertices.
    context.disable(0x0B57);
    context.begin(gl::POINTS);
    for (x, color) in [(-0.5, [0.0, 0.0, 1.0, 1.0]), (0.5, [1.0, 1.0, 0.0, 1.0])] {
        context.material(0x0404, 0x1200, &color);
        context.vertex([x, 0.0, 0.0, 1.0]);
    }
    context.end();
    assert_eq!(pixels(&mut context), [[0, 0, 255, 255], [255, 255, 0, 255]]);
}
