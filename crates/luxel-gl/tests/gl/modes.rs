//! Selection (section 5.2) and feedback (section 5.3).

use crate::canvas::{canvas, draw, gl};
use luxel_gl::{Configuration, Context, RenderModeResult, Words};

fn space() -> Context {
    let mut context = Context::new(Configuration::default());
    context.resize_default(100, 50);
    context
}

/// Records of a result: names and depths.
fn records(result: &RenderModeResult) -> Vec<(Vec<u32>, [f64; 2])> {
    let Words::Selection(words) = &result.words else { panic!("{result:?}") };
    let mut rest = words.as_slice();
    let mut records = Vec::new();
    while let [count, low, high, names @ ..] = rest {
        let (names, after) = names.split_at(*count as usize);
        let depths = [*low, *high].map(|depth| f64::from(depth) / f64::from(u32::MAX));
        records.push((names.to_vec(), depths));
        rest = after;
    }
    records
}

fn triangle(z: f32) -> [[f32; 3]; 3] {
    [[0.0, 0.0, z], [0.5, 0.0, z], [0.0, 0.5, z]]
}

#[test]
fn section_5_2_a_record_tells_the_names_and_the_depths_of_what_was_hit() {
    let mut context = space();
    context.select_buffer(64);
    assert_eq!(context.render_mode(gl::SELECT).count, 0);
    context.load_name(3);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.push_name(3);
    draw(&mut context, gl::TRIANGLES, &triangle(0.0));
    draw(&mut context, gl::TRIANGLES, &triangle(0.5));
    context.push_name(4);
    draw(&mut context, gl::LINES, &[[-9.0, 0.0, -0.5], [9.0, 0.0, -0.5]]);
    context.load_name(5);
    draw(&mut context, gl::POINTS, &[[2.0, 0.0, 0.0]]);
    context.pop_name();
    draw(&mut context, gl::POINTS, &[[0.5, 0.5, -1.0]]);
    let result = context.render_mode(gl::RENDER);
    let expected = [(vec![3], [0.5, 0.75]), (vec![3, 4], [0.25, 0.25]), (vec![3], [0.0, 0.0])];
    assert_eq!(result.count, 3);
    for ((names, depths), (expected_names, expected)) in records(&result).iter().zip(&expected) {
        assert_eq!(names, expected_names);
        assert!((0..2).all(|at| (depths[at] - expected[at]).abs() < 1e-9), "{depths:?}");
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_5_2_depths_are_those_of_what_clipping_leaves() {
    let mut context = space();
    context.select_buffer(64);
    context.clip_plane(0x3000, [0.0, 0.0, 1.0, 0.5]);
    context.enable(0x3000);
    context.depth_range(0.0, 0.5);
    context.render_mode(gl::SELECT);
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, -3.0], [0.1, 0.0, 3.0], [0.0, 0.1, 3.0]]);
    draw(&mut context, gl::TRIANGLES, &triangle(-0.75));
    let result = context.render_mode(gl::RENDER);
    let [(names, depths)] = records(&result).try_into().unwrap();
    assert!(names.is_empty() && (depths[0] - 0.125).abs() < 1e-6 && (depths[1] - 0.5).abs() < 1e-6);
}

#[test]
fn section_5_2_culled_faces_are_no_hits_and_nothing_is_drawn() {
    let mut context = space();
    context.select_buffer(64);
    context.render_mode(gl::SELECT);
    context.enable(gl::CULL_FACE);
    context.cull_face(0x0404);
    draw(&mut context, gl::TRIANGLES, &triangle(0.0));
    assert_eq!(context.render_mode(gl::RENDER).count, 0);
    assert!(crate::canvas::pixels(&mut context).iter().all(|pixel| *pixel == [0; 4]));
}

#[test]
fn section_5_2_a_buffer_that_is_too_small_gives_minus_one_and_whole_records() {
    let mut context = space();
    context.select_buffer(9);
    context.render_mode(gl::SELECT);
    for name in 0..4 {
        context.init_names();
        context.push_name(name);
        draw(&mut context, gl::TRIANGLES, &triangle(0.0));
    }
    let result = context.render_mode(gl::RENDER);
    assert_eq!((result.count, records(&result).len()), (-1, 2));
    for _ in 0..65 {
        context.push_name(1);
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.render_mode(gl::SELECT);
    for _ in 0..64 {
        context.push_name(1);
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.push_name(1);
    assert_eq!(context.get_error(), gl::STACK_OVERFLOW);
}

#[test]
fn section_2_12_a_valid_raster_position_is_a_hit_and_an_invalid_one_stays() {
    let mut context = space();
    context.select_buffer(9);
    context.render_mode(gl::SELECT);
    context.raster_pos([0.5, 0.5, 0.0, 1.0]);
    assert_eq!(context.render_mode(gl::RENDER).count, 1);
    let position = context.get(0x0B07).unwrap();
    assert_eq!([0, 1, 2, 3].map(|at| position.to_f32(at)), [75.0, 37.5, 0.5, 1.0]);
    context.raster_pos([1.5, 0.5, 0.0, 1.0]);
    assert_eq!(context.get(0x0B08).unwrap().to_bool(0), 0);
    context.window_pos([300.0, -7.0, 0.25]);
    let position = context.get(0x0B07).unwrap();
    assert_eq!([0, 1, 2].map(|at| position.to_f32(at)), [300.0, -7.0, 0.25]);
    assert_eq!(context.get(0x0B08).unwrap().to_bool(0), 1);
}

fn fed_back(context: &mut Context, of: u32, scene: impl Fn(&mut Context)) -> Vec<f32> {
    context.feedback_buffer(1000, of);
    context.render_mode(gl::FEEDBACK);
    scene(context);
    let result = context.render_mode(gl::RENDER);
    let Words::Feedback(values) = result.words else { panic!("no values") };
    assert_eq!(result.count as usize, values.len());
    values
}

#[test]
fn section_5_3_primitives_become_tokens_with_the_values_of_the_type() {
    let mut context = canvas(100, 50);
    let scene = |context: &mut Context| {
        context.color([0.25, 0.5, 0.75, 1.0]);
        context.tex_coord(0x84C0, [2.0, 3.0, 0.0, 1.0]);
        context.pass_through(7.0);
        draw(context, gl::POINTS, &[[10.0, 20.0, 0.5]]);
    };
    let color = [0.25, 0.5, 0.75, 1.0];
    let texture = [2.0, 3.0, 0.0, 1.0];
    let head = [1792.0, 7.0, 1793.0, 10.0, 20.0];
    let expected: [Vec<f32>; 5] = [
        head.to_vec(),
        [&head[..], &[0.25]].concat(),
        [&head[..], &[0.25], &color].concat(),
        [&head[..], &[0.25], &color, &texture].concat(),
        [&head[..], &[0.25, 1.0], &color, &texture].concat(),
    ];
    for (of, expected) in (0x0600..).zip(expected) {
        let found = fed_back(&mut context, of, scene);
        assert_eq!(found.len(), expected.len());
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-5), "{found:?}");
    }
}

#[test]
fn section_5_3_polygons_are_clipped_to_one_polygon_and_lines_of_strips_continue() {
    let mut context = canvas(100, 50);
    let cut = fed_back(&mut context, 0x0600, |context| {
        draw(context, gl::TRIANGLES, &[[-10.0, 10.0, 0.0], [10.0, 10.0, 0.0], [10.0, 30.0, 0.0]]);
    });
    assert_eq!(cut[..2], [1795.0, 4.0]);
    let places: Vec<[f32; 2]> = cut[2..].as_chunks().0.to_vec();
    for expected in [[0.0, 10.0], [10.0, 10.0], [10.0, 30.0], [0.0, 20.0]] {
        let near =
            |place: &[f32; 2]| (0..2).all(|axis| (place[axis] - expected[axis]).abs() < 1e-4);
        assert!(places.iter().any(near), "{places:?}");
    }
    let strip = fed_back(&mut context, 0x0600, |context| {
        draw(context, gl::LINE_STRIP, &[[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [3.0, 1.0, 0.0]]);
    });
    assert_eq!([strip[0], strip[5]], [1799.0, 1794.0]);
    context.feedback_buffer(3, 0x0601);
    context.render_mode(gl::FEEDBACK);
    draw(&mut context, gl::POINTS, &[[1.0, 1.0, 0.0]]);
    assert_eq!(context.render_mode(gl::RENDER).count, -1);
}

#[test]
fn section_5_3_many_polygons_are_in_the_order_of_calls_up_to_the_end_of_the_buffer() {
    let mut context = canvas(100, 50);
    context.shade_model(0x1D00);
    // Some of them are clipped.
    let corner = |number: usize, at: usize| {
        let [x, y] = [(number % 97) as f32, (number % 41) as f32];
        [x + [0.0, 9.0, 0.0][at] - 4.0, y + [0.0, 0.0, 9.0][at], 0.0, 1.0]
    };
    let triangle = |context: &mut Context, number: usize| {
        for at in 0..3 {
            context.color([number as f32 / 9000.0, 0.0, 0.0, 1.0]);
            context.vertex(corner(number, at));
        }
    };
    let mut fed_back = |room: usize, is_one: bool| {
        context.feedback_buffer(room as i32, 0x0602);
        context.render_mode(gl::FEEDBACK);
        if is_one {
            context.begin(gl::TRIANGLES);
            (0..9000).for_each(|number| triangle(&mut context, number));
            context.end();
        } else {
            for number in 0..9000 {
                context.begin(gl::TRIANGLES);
                triangle(&mut context, number);
                context.end();
            }
        }
        let result = context.render_mode(gl::RENDER);
        let Words::Feedback(values) = result.words else { panic!("no values") };
        (result.count, values)
    };
    let whole = fed_back(1 << 20, false);
    let count = whole.1.len();
    assert!(whole.0 as usize == count && count > 9000 * 23);
    assert_eq!(fed_back(1 << 20, true), whole);
    for room in [count, count - 1, count / 2, 9000 * 6, 11, 0] {
        let (own, values) = fed_back(room, true);
        assert_eq!(own, if room == count { count as i32 } else { -1 });
        assert!(values == whole.1[..room], "{room}");
    }
}

#[test]
fn section_5_3_very_many_points_are_all_there_in_order() {
    const COUNT: usize = 140_000;
    let mut context = canvas(100, 50);
    context.feedback_buffer(1 << 21, 0x0602);
    context.render_mode(gl::FEEDBACK);
    context.begin(gl::POINTS);
    for number in 0..COUNT {
        context.color([number as f32 / (1 << 18) as f32, 0.0, 0.0, 1.0]);
        context.vertex([1.0, 1.0, 0.0, 1.0]);
    }
    context.end();
    let Words::Feedback(values) = context.render_mode(gl::RENDER).words else {
        panic!("no values")
    };
    assert_eq!(values.len(), 8 * COUNT);
    for (number, point) in values.as_chunks::<8>().0.iter().enumerate() {
        assert_eq!([point[0], point[4]], [1793.0, number as f32 / (1 << 18) as f32]);
    }
}

#[test]
fn section_5_3_the_mode_of_polygons_and_edge_flags_decide_about_tokens() {
    let mut context = canvas(100, 50);
    context.polygon_mode(0x0408, 0x1B01);
    let tokens = |context: &mut Context| {
        let values = fed_back(context, 0x0600, |context| {
            context.begin(gl::TRIANGLES);
            for (number, [x, y]) in [[1.0, 1.0], [9.0, 1.0], [1.0, 9.0]].into_iter().enumerate() {
                context.edge_flag(number != 1);
                context.vertex([x, y, 0.0, 1.0]);
            }
            context.end();
        });
        values.into_iter().filter(|value| *value > 1000.0).collect::<Vec<_>>()
    };
    assert_eq!(tokens(&mut context), [1799.0, 1794.0]);
    context.polygon_mode(0x0408, 0x1B00);
    assert_eq!(tokens(&mut context), [1793.0, 1793.0]);
}
