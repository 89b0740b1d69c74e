//! Surfaces of different objects in one plane: the first in the file is seen, in frames and in picks.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel::pick::{PhysicalPosition, PickView, Picker};
use luxel::render::{Cull, Execution, Layer, LayerValues, Renderer};
use luxel::scene::{
    Camera, DMat4, DVec2, DVec3, Lens, MaterialId, Mesh, MeshId, Node, Part, Projection, Scene,
    SceneMaterial, Size,
};

const SIZE: Size = Size { width: 120, height: 90 };

/// xorshift64 (Marsaglia 2003).
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let direction = DVec3::from_array([(); 3].map(|()| self.next()));
            if (0.1..1.0).contains(&direction.length()) {
                return direction.normalize();
            }
        }
    }
}

/// Convex quads in one plane.
struct Pile {
    scene: Scene,
    /// From the plane's coordinates, whose third is 0, to the world's.
    world_from_plane: DMat4,
    /// Their corners in the plane, counter-clockwise.
    quads: Vec<[DVec2; 4]>,
}

impl Pile {
    fn new(random: &mut Random, count: usize) -> Self {
        let turn = DMat4::from_axis_angle(random.direction(), 3.0 * random.next());
        let place = random.direction() * [0.01, 1.0, 10.0, 100.0][count % 4];
        let world_from_plane = DMat4::from_translation(place) * turn;
        let mut scene = Scene { materials: vec![SceneMaterial::default()], ..Scene::default() };
        let mut quads = Vec::new();
        for number in 0..count {
            let centre = DVec2::new(random.next(), random.next()) * 0.4;
            let angle = 3.0 * random.next();
            let quad = [0.0, 1.5, 3.0, 4.8]
                .map(|at| centre + DVec2::from_angle(angle + at) * (0.7 + 0.3 * random.next()));
            // Each in coordinates of its own, rounded as files round them.
            let rounded = |value: f64| f64::from(value as f32);
            let own = DMat4::from_axis_angle(random.direction(), 3.0 * random.next());
            let own = DMat4::from_translation(random.direction() * 2.0) * own;
            let own = DMat4::from_cols_array(&own.to_cols_array().map(rounded));
            let corner = |at: DVec2| {
                let world = world_from_plane.transform_point3(at.extend(0.0));
                own.inverse().transform_point3(world).as_vec3().to_array()
            };
            let part = Part { first: 0, count: 2, material: MaterialId(0) };
            scene.meshes.push(Mesh {
                positions: quad.map(corner).to_vec(),
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                parts: vec![part],
                ..Mesh::default()
            });
            let node = Node::root(format!("quad {number}"), Some(MeshId(number as u32)));
            scene.nodes.push(Node { parent_from_node: own.into(), ..node });
            quads.push(quad);
        }
        Self { scene, world_from_plane, quads }
    }

    /// The quads that hold a place of the plane, in order; `None` if it is too near to an edge.
    fn at(&self, place: DVec2, margin: f64) -> Option<Vec<u32>> {
        let mut found = Vec::new();
        for (number, quad) in (0..).zip(&self.quads) {
            let inside = (0..4).map(|at| {
                let (from, to) = (quad[at], quad[(at + 1) % 4]);
                (to - from).normalize().perp_dot(place - from)
            });
            let inside = inside.fold(f64::INFINITY, f64::min);
            if inside.abs() < margin {
                return None;
            }
            if inside > 0.0 {
                found.push(number);
            }
        }
        Some(found)
    }
}

/// Compares what is seen and picked of a pile, from anywhere, with what holds each place. How many pixels lie in
/// several objects.
fn compare(pile: &Pile, random: &mut Random, round: usize) -> usize {
    let mut compared = 0;
    // From in front of the plane, or behind it, at up to 84 degrees.
    let normal = pile.world_from_plane.transform_vector3(DVec3::Z);
    let direction = loop {
        let direction = random.direction();
        if direction.dot(normal).abs() > 0.1 {
            break direction;
        }
    };
    let centre = pile.world_from_plane.w_axis.truncate();
    let eye = centre + direction * 4.0;
    let lens = match round % 3 {
        0 => Lens::Orthographic { height: 2.5 },
        _ => Lens::Perspective { fov_y_radians: 0.6 },
    };
    let camera = Camera {
        view_from_world: Camera::look_at(eye, centre, normal.any_orthonormal_vector()),
        projection: Projection { lens, near: 0.5, far: 50.0 },
    };
    let renderer = Renderer::new(pile.scene.clone(), &Execution::default()).unwrap();
    let mut view = luxel::default_view(&pile.scene, SIZE);
    (view.camera, view.samples, view.cull) = (camera, 1, Cull::None);
    let layers = renderer.layers(&view, &[Layer::Object]).unwrap();
    let LayerValues::U32(objects) = &layers[0] else { panic!("objects are numbers") };
    let picker = Picker::new(pile.scene.clone()).unwrap();
    let picks = PickView::new(&picker, camera, SIZE, Cull::None).unwrap();
    let world_from_clip =
        (camera.projection.clip_from_view(SIZE) * camera.view_from_world).inverse();
    let plane_from_world = pile.world_from_plane.inverse();
    for (at, &object) in objects.iter().enumerate() {
        let (x, y) = (at as u32 % SIZE.width, at as u32 / SIZE.width);
        let window = PhysicalPosition::centre_of(x, y);
        let across = (f64::from(x) + 0.5) / f64::from(SIZE.width) * 2.0 - 1.0;
        let down = 1.0 - (f64::from(y) + 0.5) / f64::from(SIZE.height) * 2.0;
        let [near, far] = [-0.9, 0.9].map(|z| {
            let world = world_from_clip.project_point3(DVec3::new(across, down, z));
            plane_from_world.transform_point3(world)
        });
        let place = near + (far - near) * (near.z / (near.z - far.z));
        // Corners are snapped to 1/256 pixel.
        let Some(expected) = pile.at(place.truncate(), 0.01) else { continue };
        let first = expected.first().copied().unwrap_or(u32::MAX);
        assert_eq!(object, first, "round {round}: ({x}, {y}) of {expected:?}");
        let hits: Vec<u32> = picks.through(window).iter().map(|hit| hit.object as u32).collect();
        assert_eq!(hits, expected, "round {round}: ({x}, {y})");
        compared += usize::from(expected.len() > 1);
    }
    compared
}

#[test]
fn of_objects_in_one_plane_the_first_is_seen_and_picked_and_the_others_follow() {
    let mut random = Random(0x5eed);
    let mut compared = 0;
    for round in 0..40 {
        let pile = Pile::new(&mut random, 2 + round % 4);
        compared += compare(&pile, &mut random, round);
    }
    assert!(compared > 20_000, "only {compared} pixels lie in several objects");
}

#[test]
fn objects_that_repeat_the_one_before_lie_as_far_behind_others_as_it_does() {
    let mut random = Random(0xc0);
    let mut compared = 0;
    for round in 0..8 {
        let mut pile = Pile::new(&mut random, 3);
        let repeated = |number: usize| std::iter::repeat_n(number, 1 + number % 3);
        let nodes = &pile.scene.nodes;
        pile.scene.nodes = (0..3).flat_map(repeated).map(|at| nodes[at].clone()).collect();
        pile.quads = (0..3).flat_map(repeated).map(|at| pile.quads[at]).collect();
        compared += compare(&pile, &mut random, round);
    }
    assert!(compared > 4_000, "only {compared} pixels lie in several objects");
}
