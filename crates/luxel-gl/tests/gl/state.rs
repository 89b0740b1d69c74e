//! State and its defaults (section 6.2), and the stacks that save it (section 6.1.13).

use crate::canvas::gl;
use luxel_gl::{Configuration, Context};

/// Names with what they hold at first, by the tables of section 6.2.
const DEFAULTS: &[(u32, &[f64])] = &[
    (0x0B00, &[1.0, 1.0, 1.0, 1.0]),
    (0x0B02, &[0.0, 0.0, 1.0]),
    (0x0B03, &[0.0, 0.0, 0.0, 1.0]),
    (0x0B07, &[0.0, 0.0, 0.0, 1.0]),
    (0x0B08, &[1.0]),
    (0x0B43, &[1.0]),
    (0x0BA0, &[5888.0]),
    (0x0BA3, &[1.0]),
    (0x0B70, &[0.0, 1.0]),
    (0x0B53, &[0.2, 0.2, 0.2, 1.0]),
    (0x0B51, &[0.0]),
    (0x0B52, &[0.0]),
    (0x0B54, &[7425.0]),
    (0x0B55, &[1032.0]),
    (0x0B56, &[5634.0]),
    (0x0B65, &[2048.0]),
    (0x0B62, &[1.0]),
    (0x0B64, &[1.0]),
    (0x0B66, &[0.0, 0.0, 0.0, 0.0]),
    (0x0B11, &[1.0]),
    (0x0B21, &[1.0]),
    (0x0B25, &[65535.0]),
    (0x0B26, &[1.0]),
    (0x0B45, &[1029.0]),
    (0x0B46, &[2305.0]),
    (0x0B40, &[6914.0, 6914.0]),
    (0x8038, &[0.0]),
    (0x0BC1, &[519.0]),
    (0x0BC2, &[0.0]),
    (0x0B74, &[513.0]),
    (0x0B72, &[1.0]),
    (0x0B73, &[1.0]),
    (0x0B92, &[519.0]),
    (0x0B94, &[7680.0]),
    (0x0BE1, &[1.0]),
    (0x0BE0, &[0.0]),
    (0x8009, &[32774.0]),
    (0x8005, &[0.0, 0.0, 0.0, 0.0]),
    (0x0BF0, &[5379.0]),
    (0x0C23, &[1.0, 1.0, 1.0, 1.0]),
    (0x0C22, &[0.0, 0.0, 0.0, 0.0]),
    (0x0CF5, &[4.0]),
    (0x0D05, &[4.0]),
    (0x0CF2, &[0.0]),
    (0x0B32, &[0.0]),
    (0x0C40, &[7168.0]),
    (0x0BB0, &[0.0]),
    (0x0D70, &[0.0]),
    (0x0C50, &[4352.0]),
    (0x84E0, &[33984.0]),
    (0x8450, &[33874.0]),
    (0x81F8, &[33273.0]),
    (0x8129, &[1.0, 0.0, 0.0]),
];

#[test]
fn section_6_2_every_state_begins_with_its_default() {
    let mut context = Context::new(Configuration::default());
    for (name, expected) in DEFAULTS {
        let values = context.get(*name).unwrap_or_else(|| panic!("{name:#x} isn't known"));
        assert_eq!(values.len(), expected.len(), "{name:#x}");
        for (at, expected) in expected.iter().enumerate() {
            assert!((values.to_f64(at) - expected).abs() < 1e-7, "{name:#x}: {values:?}");
        }
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn table_2_10_lights_and_materials_begin_with_their_defaults() {
    let mut context = Context::new(Configuration::default());
    let light = |context: &mut Context, number: u32, pname: u32| -> Vec<f32> {
        let values = context.get_light(gl::LIGHT0 + number, pname).unwrap();
        (0..values.len()).map(|at| values.to_f32(at)).collect()
    };
    assert_eq!(light(&mut context, 0, 0x1201), [1.0; 4]);
    assert_eq!(light(&mut context, 1, 0x1201), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(light(&mut context, 7, 0x1203), [0.0, 0.0, 1.0, 0.0]);
    assert_eq!(light(&mut context, 7, 0x1204), [0.0, 0.0, -1.0]);
    assert_eq!(light(&mut context, 7, 0x1206), [180.0]);
    for face in [0x0404, 0x0405] {
        let values = context.get_material(face, 0x1201).unwrap();
        assert_eq!([0, 3].map(|at| values.to_f32(at)), [0.8, 1.0]);
        assert_eq!(context.get_material(face, 0x1601).unwrap().to_f32(0), 0.0);
    }
}

/// Changes something of each group.
fn change_everything(context: &mut Context) {
    context.color([0.1, 0.2, 0.3, 0.4]);
    context.normal([1.0, 0.0, 0.0]);
    context.shade_model(0x1D00);
    context.light_model(0x0B53, &[0.5; 4]);
    context.fog(0x0B65, &[2049.0]);
    context.point_size(3.0);
    context.line_width(2.0);
    context.cull_face(0x0404);
    context.polygon_mode(0x0408, 0x1B01);
    context.depth_func(0x207);
    context.stencil_func(0x200, 3, 7);
    context.alpha_func(0x204, 0.5);
    context.blend_func(0x0302, 0x0303);
    context.color_mask(true, false, true, false);
    context.clear_color([0.5; 4]);
    context.scissor(1, 2, 3, 4);
    context.viewport(1, 2, 3, 4);
    context.matrix_mode(gl::PROJECTION);
    context.list_base(7);
    context.hint(0x0C54, 0x1102);
    for capability in [gl::LIGHTING, gl::BLEND, gl::DEPTH_TEST, gl::CULL_FACE, 0x0DE1] {
        context.enable(capability);
    }
}

#[test]
fn section_6_1_13_popping_restores_all_that_was_pushed() {
    let mut context = Context::new(Configuration::default());
    context.push_attrib(gl::ALL_ATTRIB_BITS);
    change_everything(&mut context);
    let changed = DEFAULTS.iter().filter(|(name, expected)| {
        let values = context.get(*name).unwrap();
        (0..expected.len()).any(|at| (values.to_f64(at) - expected[at]).abs() > 1e-7)
    });
    assert!(changed.count() >= 15, "most groups are changed");
    context.pop_attrib();
    for (name, expected) in DEFAULTS {
        let values = context.get(*name).unwrap();
        for (at, expected) in expected.iter().enumerate() {
            assert!((values.to_f64(at) - expected).abs() < 1e-7, "{name:#x}: {values:?}");
        }
    }
    for capability in [gl::LIGHTING, gl::BLEND, gl::DEPTH_TEST, gl::CULL_FACE, 0x0DE1] {
        assert!(!context.is_enabled(capability), "{capability:#x}");
    }
}

#[test]
fn section_6_1_13_a_group_leaves_the_others_alone() {
    let mut context = Context::new(Configuration::default());
    context.push_attrib(0x8); // GL_POLYGON_BIT
    change_everything(&mut context);
    context.pop_attrib();
    assert_eq!(context.get(0x0B45).unwrap().to_i32(0), 0x0405);
    assert_eq!(context.get(0x0B74).unwrap().to_i32(0), 0x207);
    assert!(context.is_enabled(gl::BLEND) && !context.is_enabled(gl::CULL_FACE));
}

#[test]
fn section_2_10_2_matrices_multiply_from_the_right_and_are_read_by_columns() {
    let mut context = Context::new(Configuration::default());
    context.translate(1.0, 2.0, 3.0);
    context.scale(2.0, 2.0, 2.0);
    let values = context.get(0x0BA6).unwrap();
    let column = |first: usize| [0, 1, 2, 3].map(|row| values.to_f64(first + row));
    assert_eq!([column(0), column(12)], [[2.0, 0.0, 0.0, 0.0], [1.0, 2.0, 3.0, 1.0]]);
    let transposed = context.get(0x84E3).unwrap();
    assert_eq!(transposed.to_f64(3), 1.0);
    let matrix: [f64; 16] = std::array::from_fn(|at| at as f64);
    context.load_transpose_matrix(&matrix);
    assert_eq!(context.get(0x0BA6).unwrap().to_f64(1), 4.0);
}

#[test]
fn section_6_1_11_the_version_is_1_5_and_extensions_are_names_with_spaces_between() {
    let mut context = Context::new(Configuration::default());
    let string = |context: &mut Context, name| {
        context.get_string(name).unwrap().to_str().unwrap().to_owned()
    };
    assert!(string(&mut context, 0x1F02).starts_with("1.5"));
    let extensions = string(&mut context, 0x1F03);
    let mut names: Vec<&str> = extensions.split(' ').filter(|name| !name.is_empty()).collect();
    assert!(names.iter().all(|name| name.starts_with("GL_")));
    assert!(names.contains(&"GL_EXT_framebuffer_object") && names.contains(&"GL_ARB_clip_control"));
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count, "some name stands there twice");
}
