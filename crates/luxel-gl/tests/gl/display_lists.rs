//! Display lists (section 5.4).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::{Configuration, Context, NoClientMemory};

/// A scene of several commands, with a colour that it leaves behind.
fn scene(context: &mut Context) {
    context.push_matrix();
    context.translate(1.0, 2.0, 0.0);
    context.begin(gl::TRIANGLES);
    for (number, [x, y]) in [[0.0, 0.0], [12.0, 1.0], [3.0, 12.0]].into_iter().enumerate() {
        context.color([number as f32 / 2.0, 0.5, 1.0 - number as f32 / 2.0, 1.0]);
        context.vertex([x, y, 0.0, 1.0]);
    }
    context.end();
    context.pop_matrix();
    context.point_size(3.0);
    draw(context, gl::POINTS, &[[13.0, 13.0, 0.0]]);
}

#[test]
fn section_5_4_a_list_draws_what_its_commands_draw() {
    let mut direct = canvas(16, 16);
    scene(&mut direct);
    let mut listed = canvas(16, 16);
    listed.new_list(5, gl::COMPILE);
    scene(&mut listed);
    listed.end_list();
    assert!(pixels(&mut listed).iter().all(|pixel| *pixel == [0; 4]));
    assert_eq!(listed.get(0x0B11).unwrap().to_f32(0), 1.0);
    listed.call_list(5);
    assert_eq!(pixels(&mut listed), pixels(&mut direct));
    assert_eq!(listed.get(0x0B11).unwrap().to_f32(0), 3.0);
    let mut both = canvas(16, 16);
    both.new_list(5, gl::COMPILE_AND_EXECUTE);
    scene(&mut both);
    both.end_list();
    assert_eq!(pixels(&mut both), pixels(&mut direct));
    for context in [&mut direct, &mut listed, &mut both] {
        assert_eq!(context.get_error(), gl::NO_ERROR);
    }
}

#[test]
fn section_5_4_lists_call_one_another_as_they_are_then() {
    let mut context = canvas(8, 8);
    context.new_list(1, gl::COMPILE);
    context.call_list(2);
    context.end_list();
    context.call_list(1);
    assert_eq!(context.get(0x0B00).unwrap().to_f32(1), 1.0);
    context.new_list(2, gl::COMPILE);
    context.color([0.0, 0.25, 0.0, 1.0]);
    context.end_list();
    context.call_list(1);
    assert_eq!(context.get(0x0B00).unwrap().to_f32(1), 0.25);
}

#[test]
fn section_5_4_a_list_that_calls_itself_ends() {
    let mut context = canvas(8, 8);
    context.new_list(1, gl::COMPILE);
    context.translate(1.0, 0.0, 0.0);
    context.call_list(1);
    context.end_list();
    context.call_list(1);
    assert_eq!(context.get(0x0BA6).unwrap().to_f64(12), 64.0);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_5_4_lists_that_call_lists_twice_end() {
    let mut context = canvas(8, 8);
    context.new_list(1, gl::COMPILE);
    context.call_list(1);
    context.call_list(1);
    context.end_list();
    context.call_list(1);
    assert_eq!(context.get_error(), 0x0505);
    context.call_list(2);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_5_4_calls_of_many_add_the_base_to_names_of_every_type() {
    let mut context = canvas(8, 8);
    for name in [11, 12, 13] {
        context.new_list(name, gl::COMPILE);
        context.translate(f64::from(name), 0.0, 0.0);
        context.end_list();
    }
    context.list_base(10);
    let floats: Vec<u8> = [1.0_f32, 2.9].iter().flat_map(|name| name.to_ne_bytes()).collect();
    let shorts: Vec<u8> = [3_u16, 1].iter().flat_map(|name| name.to_ne_bytes()).collect();
    let cases: [(u32, &[u8], f64); 5] = [
        (0x1401, &[1, 2], 23.0),
        (0x1403, &shorts, 24.0),
        (0x1406, &floats, 23.0),
        (0x1407, &[0, 3, 0, 1], 24.0),
        (0x1409, &[0, 0, 0, 1, 0, 0, 0, 2], 23.0),
    ];
    for (data_type, names, expected) in cases {
        context.load_identity();
        context.call_lists(2, data_type, names);
        assert_eq!(context.get(0x0BA6).unwrap().to_f64(12), expected, "{data_type:#x}");
    }
    context.call_lists(-1, 0x1401, &[]);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
}

#[test]
fn section_5_4_errors_come_when_a_list_is_executed() {
    let mut context = canvas(8, 8);
    context.new_list(3, gl::COMPILE);
    context.enable(1);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.new_list(4, gl::COMPILE);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.end_list();
    context.call_list(3);
    assert_eq!(context.get_error(), gl::INVALID_ENUM);
}

#[test]
fn section_5_4_names_are_reserved_deleted_and_shared() {
    let mut context = Context::new(Configuration::default());
    let first = context.gen_lists(3);
    assert!(context.is_list(first) && context.is_list(first + 2) && !context.is_list(first + 3));
    let mut other = Context::sharing(Configuration::default(), &context);
    other.delete_lists(first, 2);
    assert!(!context.is_list(first) && context.is_list(first + 2));
    assert_eq!(context.gen_lists(0), 0);
}

#[test]
fn section_5_4_lists_open_with_begin_and_close_elsewhere() {
    let mut context = canvas(8, 8);
    context.new_list(1, gl::COMPILE);
    context.begin(gl::TRIANGLES);
    context.vertex([0.0, 0.0, 0.0, 1.0]);
    context.end_list();
    context.call_list(1);
    context.vertex([16.0, 0.0, 0.0, 1.0]);
    context.vertex([0.0, 16.0, 0.0, 1.0]);
    context.end();
    assert!(pixels(&mut context).iter().all(|pixel| *pixel == [255; 4]));
}

#[test]
fn quads_of_lists_have_the_diagonal_of_their_last_corner_and_others_that_of_the_first() {
    let quad = |context: &mut Context| {
        context.begin(gl::QUADS);
        for (number, [x, y]) in [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]].iter().enumerate()
        {
            let light = f32::from(u8::from(number % 2 == 1));
            context.color([light, light, light, 1.0]);
            context.vertex([*x, *y, 0.0, 1.0]);
        }
        context.end();
    };
    let middle = |context: &mut Context| pixels(context)[4 * 8 + 4][0];
    let mut context = canvas(8, 8);
    quad(&mut context);
    assert!(middle(&mut context) < 40, "dark corners are joined");
    context.new_list(1, gl::COMPILE);
    quad(&mut context);
    context.end_list();
    context.call_list(1);
    assert!(middle(&mut context) > 215, "light corners are joined");
}

/// A wavy mesh of 21 600 vertices, given triangle by triangle, with a colour or a normal each.
fn mesh(context: &mut Context, colored: bool) {
    context.begin(gl::TRIANGLES);
    for at in 0..60 * 60 {
        let (column, row) = (at % 60, at / 60);
        for [right, up] in [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]] {
            let (x, y) = ((column + right) as f32, (row + up) as f32);
            let wave = (x * 0.3).fract() - (y * 0.2).fract();
            if colored {
                context.color([x / 60.0, y / 60.0, wave.abs(), 1.0]);
            } else {
                context.normal([wave, 0.3, 1.0]);
            }
            context.vertex([x + wave, y, wave / 2.0, 1.0]);
        }
    }
    context.end();
}

#[test]
fn section_3_5_a_listed_triangle_has_the_depths_of_its_commands_beside_backs_that_are_outlines() {
    let depths = |listed: bool, backs: u32| {
        let mut context = canvas(48, 48);
        context.enable(gl::DEPTH_TEST);
        context.polygon_mode(0x0405, backs);
        context.rotate(20.0, 0.1, 0.2, 1.0);
        if listed {
            context.new_list(1, gl::COMPILE);
        }
        for number in 0..24_u8 {
            let [x, y] = [f32::from(number % 6) * 7.0, f32::from(number / 6) * 9.0];
            draw(&mut context, gl::TRIANGLES, &[[x, y, 0.0], [x + 8.0, y, 0.0], [x, y + 9.0, 0.0]]);
        }
        if listed {
            context.end_list();
            context.call_list(1);
        }
        let mut depths = vec![0; 48 * 48 * 4];
        context.read_pixels(0, 0, 48, 48, gl::DEPTH_COMPONENT, gl::FLOAT, &mut depths);
        depths
    };
    let filled = depths(false, 0x1b02);
    for (listed, backs) in [(false, 0x1b01), (true, 0x1b02), (true, 0x1b01)] {
        assert_eq!(depths(listed, backs), filled, "listed: {listed}, backs: {backs:#x}");
    }
}

#[test]
fn section_5_4_long_primitives_are_those_of_their_commands() {
    const COLOR_MATERIAL: u32 = 0x0b57;
    for colored in [false, true] {
        let drawn = |listed: bool, mode: u32| {
            let mut context = canvas(64, 64);
            for capability in [gl::DEPTH_TEST, gl::LIGHTING, gl::LIGHT0, COLOR_MATERIAL] {
                context.enable(capability);
            }
            context.polygon_mode(0x0408, 0x1b01 + u32::from(colored));
            context.color([0.9, 0.6, 0.3, 1.0]);
            if listed {
                context.new_list(1, gl::COMPILE);
                mesh(&mut context, colored);
                context.end_list();
            }
            // Something waits to be drawn before.
            draw(
                &mut context,
                gl::TRIANGLES,
                &[[3.0, 3.0, 0.9], [30.0, 3.0, 0.9], [3.0, 9.0, 0.9]],
            );
            context.select_buffer(64);
            context.feedback_buffer(1 << 20, 0x0603);
            context.render_mode(mode);
            if listed {
                context.call_list(1);
            } else {
                mesh(&mut context, colored);
            }
            let after = [0x0b00, 0x0b02].map(|name| {
                let values = context.get(name).unwrap();
                [0, 1, 2].map(|at| values.to_f32(at))
            });
            let words = format!("{:?}", context.render_mode(gl::RENDER).words);
            assert_eq!(context.get_error(), gl::NO_ERROR);
            (pixels(&mut context), words, after)
        };
        for mode in [gl::RENDER, gl::SELECT, gl::FEEDBACK] {
            let (listed, immediate) = (drawn(true, mode), drawn(false, mode));
            assert!(listed.0 == immediate.0, "other pixels, {colored}");
            assert!(listed.1 == immediate.1, "other words in mode {mode:#x}, {colored}");
            assert_eq!(listed.2, immediate.2);
        }
    }
}

#[test]
fn section_5_4_long_primitives_within_others_are_an_error_and_vertices() {
    let drawn = |listed: bool| {
        let mut context = canvas(64, 64);
        context.new_list(1, gl::COMPILE);
        mesh(&mut context, true);
        context.end_list();
        context.begin(gl::TRIANGLES);
        context.vertex([0.0, 0.0, 0.0, 1.0]);
        if listed {
            context.call_list(1);
        } else {
            mesh(&mut context, true);
        }
        assert_eq!(context.get_error(), gl::INVALID_OPERATION);
        context.end();
        assert_eq!(context.get_error(), gl::INVALID_OPERATION);
        pixels(&mut context)
    };
    assert!(drawn(true) == drawn(false));
}

#[test]
fn section_5_4_a_list_repeats_the_errors_of_commands_between_begin_and_end() {
    type Drawing = fn(&mut Context);
    let commands: [(&str, Drawing); 3] = [
        ("glBitmap", |context| context.bitmap([1, 1], [0.0; 2], [0.0; 2], Some(&[0x80]))),
        ("glDrawArrays", |context| context.draw_arrays(gl::POINTS, 0, 1, &NoClientMemory)),
        ("glDrawElements", |context| {
            context.draw_elements(gl::POINTS, 0, gl::UNSIGNED_INT, 0, &NoClientMemory);
        }),
    ];
    for (name, command) in commands {
        let mut context = canvas(4, 4);
        context.new_list(1, gl::COMPILE_AND_EXECUTE);
        context.begin(gl::POINTS);
        command(&mut context);
        context.end();
        context.end_list();
        assert_eq!(context.get_error(), gl::INVALID_OPERATION, "{name} executed");
        context.call_list(1);
        assert_eq!(context.get_error(), gl::INVALID_OPERATION, "{name} called");
    }
}
