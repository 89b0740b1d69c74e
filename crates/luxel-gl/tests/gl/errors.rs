//! Errors (section 2.5) and what is allowed between `glBegin` and `glEnd` (section 2.6.3).

use crate::canvas::{canvas, gl, pixels};
use luxel_gl::Context;

/// A command, by its name in C.
type Case = (&'static str, fn(&mut Context));

/// Commands that aren't allowed between `glBegin` and `glEnd`.
const OUTSIDE_ONLY: &[Case] = &[
    ("glBegin", |c| c.begin(gl::POINTS)),
    ("glMatrixMode", |c| c.matrix_mode(gl::PROJECTION)),
    ("glLoadIdentity", Context::load_identity),
    ("glPushMatrix", Context::push_matrix),
    ("glPopMatrix", Context::pop_matrix),
    ("glRotate", |c| c.rotate(1.0, 1.0, 0.0, 0.0)),
    ("glViewport", |c| c.viewport(0, 0, 1, 1)),
    ("glDepthRange", |c| c.depth_range(0.5, 1.0)),
    ("glEnable", |c| c.enable(gl::BLEND)),
    ("glDisable", |c| c.disable(gl::BLEND)),
    ("glShadeModel", |c| c.shade_model(0x1D00)),
    ("glLight", |c| c.light(gl::LIGHT0, 0x1200, &[0.0; 4])),
    ("glClear", |c| c.clear(gl::COLOR_BUFFER_BIT)),
    ("glClearColor", |c| c.clear_color([1.0; 4])),
    ("glRect", |c| c.rect([0.0; 2], [1.0; 2])),
    ("glRasterPos", |c| c.raster_pos([0.0, 0.0, 0.0, 1.0])),
    ("glPushAttrib", |c| c.push_attrib(gl::ALL_ATTRIB_BITS)),
    ("glNewList", |c| c.new_list(1, gl::COMPILE)),
    ("glFlush", Context::flush),
    ("glBlendFunc", |c| c.blend_func(1, 1)),
    ("glScissor", |c| c.scissor(0, 0, 1, 1)),
    ("glInitNames", Context::init_names),
    ("glIsEnabled", |c| {
        c.is_enabled(gl::BLEND);
    }),
    ("glGet", |c| assert_eq!(c.get(0x0BA2), None)),
    ("glGenLists", |c| assert_eq!(c.gen_lists(1), 0)),
    ("glRenderMode", |c| {
        c.render_mode(gl::RENDER);
    }),
];

#[test]
fn section_2_6_3_no_command_but_those_of_vertices_is_allowed_between_begin_and_end() {
    for (name, command) in OUTSIDE_ONLY {
        let mut context = canvas(4, 4);
        context.begin(gl::POINTS);
        command(&mut context);
        context.end();
        assert_eq!(context.get_error(), gl::INVALID_OPERATION, "{name}");
        assert_eq!(context.get_error(), gl::NO_ERROR, "{name}");
        let mut untouched = canvas(4, 4);
        for pname in [0x0BA0, 0x0BA2, 0x0BE2, 0x0B54, 0x0C22, 0x0C10, 0x0BA6, 0x0B02] {
            assert_eq!(context.get(pname), untouched.get(pname), "{name} changed {pname:#x}");
        }
    }
}

#[test]
fn section_2_6_3_vertices_and_their_attributes_are_allowed_between_begin_and_end() {
    let mut context = canvas(4, 4);
    context.begin(gl::POINTS);
    context.color([1.0; 4]);
    context.secondary_color([0.0; 3]);
    context.normal([0.0, 0.0, 1.0]);
    context.tex_coord(0x84C3, [0.0; 4]);
    context.fog_coord(1.0);
    context.edge_flag(false);
    context.index(3.0);
    context.material(0x0408, 0x1201, &[1.0; 4]);
    context.call_list(99);
    context.end();
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_2_5_arguments_that_are_wrong_have_these_errors() {
    let cases: &[(Case, u32)] = &[
        (("glBegin", |c| c.begin(10)), gl::INVALID_ENUM),
        (("glEnd", Context::end), gl::INVALID_OPERATION),
        (("glEnable", |c| c.enable(1)), gl::INVALID_ENUM),
        (("glMatrixMode", |c| c.matrix_mode(0x1800)), gl::INVALID_ENUM),
        (("glPopMatrix", Context::pop_matrix), gl::STACK_UNDERFLOW),
        (("glPopAttrib", Context::pop_attrib), gl::STACK_UNDERFLOW),
        (("glPopClientAttrib", Context::pop_client_attrib), gl::STACK_UNDERFLOW),
        (("glFrustum", |c| c.frustum(0.0, 1.0, 0.0, 1.0, 0.0, 1.0)), gl::INVALID_VALUE),
        (("glOrtho", |c| c.ortho(1.0, 1.0, 0.0, 1.0, 0.0, 1.0)), gl::INVALID_VALUE),
        (("glViewport", |c| c.viewport(0, 0, -1, 1)), gl::INVALID_VALUE),
        (("glScissor", |c| c.scissor(0, 0, 1, -1)), gl::INVALID_VALUE),
        (("glLight", |c| c.light(gl::LIGHT0 + 8, 0x1200, &[0.0; 4])), gl::INVALID_ENUM),
        (("glLight exponent", |c| c.light(gl::LIGHT0, 0x1205, &[129.0])), gl::INVALID_VALUE),
        (("glLight cutoff", |c| c.light(gl::LIGHT0, 0x1206, &[91.0])), gl::INVALID_VALUE),
        (("glLight attenuation", |c| c.light(gl::LIGHT0, 0x1207, &[-1.0])), gl::INVALID_VALUE),
        (("glLightf of a colour", |c| c.light(gl::LIGHT0, 0x1200, &[1.0])), 0),
        (("glMaterial", |c| c.material(0x0404, 0x1601, &[128.5])), gl::INVALID_VALUE),
        (("glLineWidth", |c| c.line_width(0.0)), gl::INVALID_VALUE),
        (("glPointSize", |c| c.point_size(f32::NAN)), gl::INVALID_VALUE),
        (("glFog density", |c| c.fog(0x0B62, &[-1.0])), gl::INVALID_VALUE),
        (("glDepthFunc", |c| c.depth_func(0x208)), gl::INVALID_ENUM),
        (("glBlendFunc", |c| c.blend_func(1, 0x0308)), gl::INVALID_ENUM),
        (("glClear", |c| c.clear(1)), gl::INVALID_VALUE),
        (("glNewList", |c| c.new_list(0, gl::COMPILE)), gl::INVALID_VALUE),
        (("glNewList mode", |c| c.new_list(1, 0)), gl::INVALID_ENUM),
        (("glEndList", Context::end_list), gl::INVALID_OPERATION),
        (("glCallLists", |c| c.call_lists(1, 0x1234, &[])), gl::INVALID_ENUM),
        (("glGenLists", |c| assert_eq!(c.gen_lists(-1), 0)), gl::INVALID_VALUE),
        (("glDrawBuffer", |c| c.draw_buffer(0x0403)), gl::INVALID_OPERATION),
        (("glReadBuffer", |c| c.read_buffer(0)), gl::INVALID_ENUM),
        (("glPixelStore", |c| c.pixel_store(0x0CF5, 3.0)), gl::INVALID_VALUE),
        (("glReadPixels", |c| c.read_pixels(0, 0, 1, 1, 1, 1, &mut [])), gl::INVALID_ENUM),
        (
            ("glRenderMode", |c| assert_eq!(c.render_mode(gl::SELECT).count, 0)),
            gl::INVALID_OPERATION,
        ),
        (("glGet", |c| assert_eq!(c.get(0), None)), gl::INVALID_ENUM),
        (("glGetString", |c| assert_eq!(c.get_string(0), None)), gl::INVALID_ENUM),
        (("glTexCoord", |c| c.tex_coord(0x84C8, [0.0; 4])), gl::INVALID_ENUM),
    ];
    for ((name, command), error) in cases {
        let mut context = canvas(4, 4);
        command(&mut context);
        assert_eq!(context.get_error(), *error, "{name}");
    }
}

#[test]
fn section_2_5_the_first_error_is_kept_until_it_is_read() {
    let mut context = canvas(4, 4);
    context.pop_matrix();
    context.enable(1);
    assert_eq!(context.get_error(), gl::STACK_UNDERFLOW);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_2_10_2_stacks_overflow_at_their_limits_and_stay_as_they_are() {
    let depth_of = |mode: u32, pname: u32, limit: usize| {
        let mut context = canvas(4, 4);
        context.matrix_mode(mode);
        for _ in 1..limit {
            context.push_matrix();
        }
        assert_eq!(context.get_error(), gl::NO_ERROR);
        context.push_matrix();
        assert_eq!(context.get_error(), gl::STACK_OVERFLOW);
        assert_eq!(context.get(pname).unwrap().to_i32(0), limit as i32);
    };
    depth_of(gl::MODELVIEW, 0x0BA3, 32);
    depth_of(gl::PROJECTION, 0x0BA4, 32);
    depth_of(0x1702, 0x0BA5, 10);
    let mut context = canvas(4, 4);
    for _ in 0..16 {
        context.push_attrib(gl::ALL_ATTRIB_BITS);
        context.push_client_attrib(gl::ALL_ATTRIB_BITS);
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.push_client_attrib(gl::ALL_ATTRIB_BITS);
    assert_eq!(context.get_error(), gl::STACK_OVERFLOW);
    context.push_attrib(gl::ALL_ATTRIB_BITS);
    assert_eq!(context.get_error(), gl::STACK_OVERFLOW);
}

#[test]
fn section_2_10_vertices_that_are_not_numbers_draw_nothing() {
    let mut context = canvas(8, 8);
    // The largest numbers are some: they only have to end.
    for bad in [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, -f32::MAX] {
        for mode in 0..=9 {
            context.clear(gl::COLOR_BUFFER_BIT);
            context.begin(mode);
            for place in [[1.0, 1.0], [bad, 6.0], [5.0, bad], [3.0, 3.0], [bad, bad]] {
                context.vertex([place[0], place[1], 0.0, 1.0]);
            }
            context.end();
            let drawn = pixels(&mut context).iter().filter(|pixel| pixel[0] > 0).count();
            let expected = if mode == gl::POINTS { 2 } else { 0 };
            assert!(
                bad.is_finite() && drawn >= expected || drawn == expected,
                "{bad} in mode {mode}"
            );
        }
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
}
