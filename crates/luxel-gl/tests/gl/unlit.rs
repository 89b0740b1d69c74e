//! Vertices of long draws are lit where something is drawn of them (section 2.13): neither pictures nor feedback show
//! which ones are.

use crate::canvas::{canvas, gl, pixels};
use luxel_gl::{Context, Words};
use std::f32::consts::TAU;

const LIGHT_MODEL_TWO_SIDE: u32 = 0x0b52;
const LIGHT_MODEL_COLOR_CONTROL: u32 = 0x81f8;
const SEPARATE_SPECULAR_COLOR: u32 = 0x81fa;
const FRONT: u32 = 0x0404;
const BACK: u32 = 0x0405;
const CLIP_PLANE0: u32 = 0x3000;
const FRONT_AND_BACK: u32 = 0x0408;
const DIFFUSE: u32 = 0x1201;
const SPECULAR: u32 = 0x1202;
const SHININESS: u32 = 0x1601;
const FLAT: u32 = 0x1d00;
const LINE: u32 = 0x1b01;
const _3D_COLOR: u32 = 0x0602;

/// Rows and columns of a sphere.
const ROWS: usize = 12;

/// Draws a sphere that reaches out of the window, so many quadrilaterals at a time.
fn sphere(context: &mut Context, together: usize) {
    let quads: Vec<[usize; 2]> =
        (0..ROWS).flat_map(|row| (0..ROWS).map(move |column| [row, column])).collect();
    for quads in quads.chunks(together) {
        context.begin(gl::QUADS);
        for &[row, column] in quads {
            for [down, right] in [[0, 0], [1, 0], [1, 1], [0, 1]] {
                let (sin, cos) = libm::sincosf((row + down) as f32 / ROWS as f32 * TAU / 2.0);
                let (y, x) = libm::sincosf((column + right) as f32 / ROWS as f32 * TAU);
                let normal = [sin * x, cos, sin * y];
                context.normal(normal);
                context.vertex([24.0 + 30.0 * normal[0], 24.0 + 30.0 * cos, 0.9 * sin * y, 1.0]);
            }
        }
        context.end();
        // What waits is drawn.
        context.finish();
    }
}

/// The pixels of the sphere, and what feedback has of it.
fn drawn(set: fn(&mut Context), together: usize) -> (Vec<[u8; 4]>, Vec<f32>) {
    let mut context = canvas(48, 40);
    for name in [gl::LIGHTING, gl::LIGHT0, gl::DEPTH_TEST] {
        context.enable(name);
    }
    context.material(FRONT, DIFFUSE, &[0.9, 0.5, 0.2, 1.0]);
    context.material(BACK, DIFFUSE, &[0.1, 0.3, 0.9, 1.0]);
    context.material(FRONT_AND_BACK, SPECULAR, &[0.6, 0.7, 0.8, 1.0]);
    context.material(FRONT_AND_BACK, SHININESS, &[9.0]);
    set(&mut context);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
    sphere(&mut context, together);
    let pixels = pixels(&mut context);
    // In other colours than those that memory may still hold.
    context.material(FRONT_AND_BACK, DIFFUSE, &[0.3, 0.8, 0.6, 1.0]);
    context.feedback_buffer(1 << 16, _3D_COLOR);
    context.render_mode(gl::FEEDBACK);
    sphere(&mut context, together);
    let Words::Feedback(values) = context.render_mode(gl::RENDER).words else {
        panic!("no values")
    };
    assert_eq!(context.get_error(), gl::NO_ERROR);
    (pixels, values)
}

#[test]
fn long_draws_have_the_pixels_and_values_of_short_ones_whatever_faces_away_or_lies_outside() {
    let sets: [fn(&mut Context); 6] = [
        |context| context.enable(gl::CULL_FACE),
        |context| {
            context.enable(gl::CULL_FACE);
            context.cull_face(FRONT);
        },
        |context| {
            context.light_model(LIGHT_MODEL_TWO_SIDE, &[1.0]);
            context.light_model(LIGHT_MODEL_COLOR_CONTROL, &[SEPARATE_SPECULAR_COLOR as f32]);
        },
        |context| {
            context.enable(gl::CULL_FACE);
            context.shade_model(FLAT);
        },
        |context| context.polygon_mode(FRONT_AND_BACK, LINE),
        |context| {
            context.enable(gl::CULL_FACE);
            context.enable(CLIP_PLANE0);
            context.clip_plane(CLIP_PLANE0, [1.0, 0.5, 0.0, -30.0]);
        },
    ];
    for (number, set) in sets.into_iter().enumerate() {
        let (pixels, values) = drawn(set, ROWS * ROWS);
        assert!(pixels.iter().filter(|pixel| pixel[..3] != [0; 3]).count() > 200, "{number}");
        assert!(values.len() > 500, "{number}: {}", values.len());
        assert!((pixels, values) == drawn(set, 10), "{number}");
    }
}
