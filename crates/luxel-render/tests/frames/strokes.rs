//! Points and lines, which are no triangles.

use crate::scenes::{bytes, matte, scene, square, view};
use luxel_math::SimdLevel;
use luxel_render::{Layer, LayerValues, Renderer};
use luxel_scene::{Lines, MaterialId, Mesh, Points, Scene};

/// A line along x through the middle, a point in the upper half, a square behind both.
fn strokes() -> Scene {
    let positions = vec![[-1.5, 0.0, 1.0], [1.5, 0.0, 1.0], [0.0, 1.5, 1.0]];
    let material = MaterialId(0);
    let mesh = Mesh {
        positions,
        lines: vec![Lines { segments: vec![[0, 1]], material }],
        points: vec![Points { indices: vec![2], material }],
        ..Mesh::default()
    };
    scene(vec![(mesh, matte([1.0; 3])), (square(0.0), matte([0.0, 0.0, 1.0]))])
}

#[test]
fn lines_and_points_are_drawn_lit_from_the_front() {
    let mut view = view(65);
    view.samples = 4;
    let pixels = bytes(&strokes(), &view);
    let at = |x: usize, y: usize| pixels[y * 65 + x];
    assert_eq!(at(32, 32), [255; 4], "the line before the square");
    assert_eq!(at(10, 32), [255; 4], "the line beside the square");
    assert_eq!(at(32, 20), [0, 0, 255, 255], "the square");
    assert_eq!(at(32, 8), [255; 4], "the point");
    assert_eq!(at(40, 8), [0; 4], "beside the point");
}

#[test]
fn strokes_belong_to_their_object_and_are_no_triangles() {
    let scene = strokes();
    let execution = crate::scenes::execution(1, SimdLevel::Auto);
    let renderer = Renderer::new(scene.clone(), &execution).unwrap();
    let layers = renderer.layers(&view(65), &[Layer::Object, Layer::Triangle]).unwrap();
    let [LayerValues::U32(objects), LayerValues::U32(triangles)] = &layers[..] else {
        panic!("ids are whole numbers")
    };
    let at = 32 * 65 + 32;
    assert_eq!((objects[at], triangles[at]), (0, u32::MAX));
    let at = 25 * 65 + 32;
    assert_eq!(objects[at], 1);
}

#[test]
fn points_are_as_large_as_the_view_says() {
    for side in [1_usize, 3, 7] {
        let view = view(65).with_point_size(side as f32);
        let pixels = bytes(&strokes(), &view);
        let is_white = |column: usize| pixels[8 * 65 + column] == [255; 4];
        let count = (0..65).filter(|column| is_white(*column)).count();
        assert!(count.abs_diff(side) <= 1, "{side}: {count}");
    }
}
