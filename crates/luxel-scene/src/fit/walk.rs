//! Views and bounds held against a walk over all points, bit by bit.

use super::*;
use crate::{Lines, MaterialId, Mesh, MeshId, Node, NodeId, Object, Points};
use proptest::prelude::*;

/// The drawn points, in the order of the objects, each in the target space of `target_from_mesh`.
fn points(scene: &Scene, target_from_mesh: impl Fn(&Object) -> DMat4) -> Vec<DVec3> {
    let mut points = Vec::new();
    for object in scene.objects() {
        let mesh = &scene.meshes[object.mesh.index()];
        let target_from_mesh = target_from_mesh(&object);
        let drawn = mesh.drawn_positions();
        points.extend(
            (0..drawn.len())
                .filter(|&number| drawn[number])
                .map(|number| target_from_mesh.transform_point3(mesh.position(number as u32))),
        );
    }
    points
}

fn bounds(points: &[DVec3]) -> Bounds {
    let mut bounds = Bounds::EMPTY;
    points.iter().for_each(|&point| bounds.include(point));
    bounds
}

fn world_bounds(scene: &Scene) -> Bounds {
    bounds(&points(scene, |object| object.world_from_mesh.matrix()))
}

fn highest<const N: usize>(
    points: &[DVec3],
    of: impl Fn(DVec3) -> [(f64, f64); N],
) -> [(f64, f64); N] {
    let mut highest = [(f64::NEG_INFINITY, 0.0); N];
    for values in points.iter().map(|&point| of(point)) {
        for (highest, value) in highest.iter_mut().zip(values) {
            if *highest < value {
                *highest = value;
            }
        }
    }
    highest
}

/// [`fit_along`] by walks over all points.
fn walked(scene: &Scene, axes: [DVec3; 3], lens: Lens, size: Size) -> Camera {
    let picture_from_world = picture_from_world(axes);
    let points = points(scene, |object| picture_from_world * object.world_from_mesh.matrix());
    let bounds = bounds(&points);
    let (eye, lens) = if bounds.is_empty() || !is_measurable(&bounds) {
        (DVec3::Z, lens)
    } else if let Lens::Orthographic { height } = lens {
        let height = if height > 0.0 { height } else { fitting_height(&bounds, size) };
        let distance = bounds.radius().max(height);
        (bounds.centre().with_z(bounds.max.z + distance), Lens::Orthographic { height })
    } else {
        (walked_eye(&points, &bounds, &Slopes::of(lens, size)), lens)
    };
    let view_from_world = DMat4::from_translation(-eye) * picture_from_world;
    let (near, far) = fit_planes(&world_bounds(scene), &view_from_world);
    Camera { view_from_world, projection: Projection { lens, near, far } }
}

fn walked_eye(points: &[DVec3], bounds: &Bounds, slopes: &Slopes) -> DVec3 {
    let support = highest(points, |point| {
        let along = |axis: usize, slope: f64| point[axis] + slope * point.z;
        [
            along(0, slopes.high[0]),
            -along(0, slopes.low[0]),
            along(1, slopes.high[1]),
            -along(1, slopes.low[1]),
        ]
        .map(|along| (along, 0.0))
    });
    let support = support.map(|(along, _)| along);
    let mut height = bounds.max.z + LEAST_DISTANCE * size_of_a_point(bounds);
    for axis in 0..2 {
        let opening = slopes.high[axis] - slopes.low[axis];
        let needed = (support[2 * axis] + support[2 * axis + 1]) / opening;
        if needed.is_finite() {
            height = height.max(needed);
        }
    }
    let mut eye = [0, 1].map(|axis| {
        let least = support[2 * axis] - slopes.high[axis] * height;
        let most = -support[2 * axis + 1] - slopes.low[axis] * height;
        (least + most) * 0.5
    });
    for _ in 0..ROUNDS_OF_CENTRING {
        let outermost = highest(points, |point| {
            let distance = height - point.z;
            let by_distance = 1.0 / distance;
            let (x, y) = ((point.x - eye[0]) * by_distance, (point.y - eye[1]) * by_distance);
            [(x, distance), (-x, distance), (y, distance), (-y, distance)]
        });
        let centred = [0, 1].map(|axis| {
            let [(high, high_distance), (low, low_distance)] =
                [outermost[2 * axis], outermost[2 * axis + 1]];
            let off = high - low - (slopes.low[axis] + slopes.high[axis]);
            eye[axis] + off / (1.0 / high_distance + 1.0 / low_distance)
        });
        let moved = (0..2).map(|axis| (centred[axis] - eye[axis]).abs()).fold(0.0, f64::max);
        if !moved.is_finite() {
            break;
        }
        eye = centred;
        if moved <= NEARLY_CENTRED * size_of_a_point(bounds) {
            break;
        }
    }
    DVec3::new(eye[0], eye[1], height)
}

/// Random numbers from a seed.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (((self.0 >> 33) * count as u64) >> 31) as usize
    }

    /// From -1 to 1.
    fn number(&mut self) -> f64 {
        self.below(2_000_001) as f64 * 1e-6 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A few or many positions: in clouds and on surfaces, in rows and at random, equal, large and
    /// small.
    fn positions(&mut self) -> Vec<[f32; 3]> {
        let count = self.of(&[0, 1, 3, 64, 65, 300, 600, 2500]);
        let kind = self.below(6);
        let scale = self.of(&[1.0, 1.0, 1.0, 1e-3, 1e4, 1e20, 3e38, 1e-20, 1e-42]);
        let place = |random: &mut Self, at: usize| match kind {
            0 => random.vector(),
            1 => random.vector().normalize_or_zero(),
            // Many that are equally far.
            2 => (random.vector() * 2.0).round(),
            3 => DVec3::new((at % 40) as f64 / 40.0, (at / 40) as f64 / 40.0, 0.0),
            4 => DVec3::ONE,
            _ => {
                let along = at as f64 / 100.0;
                DVec3::new(along - along.floor(), along * 0.04, random.number() * 1e-3)
            }
        };
        let mut positions: Vec<[f32; 3]> =
            (0..count).map(|at| (place(self, at) * scale).as_vec3().to_array()).collect();
        if count > 0 && self.below(4) == 0 {
            for _ in 0..self.below(4) {
                let (at, axis) = (self.below(count), self.below(3));
                positions[at][axis] =
                    self.of(&[f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, f32::MAX]);
            }
        }
        positions
    }

    fn mesh(&mut self) -> Mesh {
        let positions = self.positions();
        let count = positions.len();
        let draws_all = self.below(2) == 0;
        let mut mesh = Mesh { positions, ..Mesh::default() };
        mesh.origin = match self.below(6) {
            0 => self.vector() * self.of(&[1e7, 1e14]),
            1 => DVec3::splat(-0.0),
            2 => self.vector() * 1e200,
            _ => DVec3::ZERO,
        };
        if count == 0 {
            return mesh;
        }
        if draws_all {
            mesh.triangles = (0..count as u32).map(|at| [at, at / 2, 0]).collect();
        }
        let some =
            |random: &mut Self| (0..random.below(9)).map(|_| random.below(count) as u32).collect();
        let (indices, ends): (Vec<u32>, Vec<u32>) = (some(self), some(self));
        let segments = ends.windows(2).map(|ends| [ends[0], ends[1]]).collect();
        mesh.points = vec![Points { indices, material: MaterialId(0) }];
        mesh.lines = vec![Lines { segments, material: MaterialId(0) }];
        mesh
    }

    fn matrix(&mut self) -> DMat4 {
        let shear = DMat4::from_cols(
            (DVec3::X + self.vector()).extend(0.0),
            (DVec3::Y + self.vector()).extend(0.0),
            (DVec3::Z + self.vector()).extend(0.0),
            self.vector().extend(1.0),
        );
        match self.below(10) {
            0 => DMat4::IDENTITY,
            1 => DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
            2 => DMat4::from_scale(DVec3::new(1.0, 0.0, 1e-9)),
            3 => DMat4::from_translation(self.vector() * self.of(&[1e9, 1e15])) * shear,
            4 => DMat4::from_scale(DVec3::splat(1e170)),
            5 => DMat4::from_scale(DVec3::splat(1e-170)),
            6 => DMat4::from_translation(self.vector() * 3.0),
            _ => shear,
        }
    }

    fn scene(&mut self) -> Scene {
        let meshes: Vec<Mesh> = (0..1 + self.below(3)).map(|_| self.mesh()).collect();
        let node = |random: &mut Self, at: usize| Node {
            parent: (at > 0 && random.below(2) == 0).then(|| NodeId(random.below(at) as u32)),
            parent_from_node: random.matrix().into(),
            ..Node::root(
                "it",
                (random.below(5) > 0).then(|| MeshId(random.below(meshes.len()) as u32)),
            )
        };
        let nodes = (0..self.of(&[0, 1, 1, 2, 9])).map(|at| node(self, at)).collect();
        Scene { nodes, meshes: meshes.into(), ..Scene::default() }
    }

    fn lens(&mut self) -> Lens {
        match self.below(6) {
            0 => Lens::Orthographic { height: 0.0 },
            1 => Lens::Orthographic { height: 2.0 },
            2 => {
                let [fx, fy] = [0, 1].map(|_| self.of(&[900.0, 300.0, 1e-200, 0.0]));
                Lens::Intrinsics { fx, fy, cx: self.number() * 900.0, cy: self.number() * 900.0 }
            }
            _ => Lens::Perspective {
                fov_y_radians: self.of(&[0.8, 0.1, 1e-4, 2.5, std::f64::consts::PI]),
            },
        }
    }

    fn axes(&mut self) -> [DVec3; 3] {
        let viewpoint = Viewpoint {
            up: self.of(&[DVec3::Y, DVec3::Z, DVec3::NEG_Y, DVec3::new(1.0, 2.0, -3.0)]),
            azimuth_radians: self.number() * self.of(&[0.0, 3.0]),
            elevation_radians: self.number() * self.of(&[0.0, 1.5]),
        };
        viewpoint.axes()
    }
}

/// Their bits; any NaN is as good as any other.
fn bits(numbers: impl IntoIterator<Item = f64>) -> Vec<u64> {
    let bits = |number: f64| if number.is_nan() { u64::MAX } else { number.to_bits() };
    numbers.into_iter().map(bits).collect()
}

fn bits_of_bounds(bounds: &Bounds) -> Vec<u64> {
    bits(bounds.min.to_array().into_iter().chain(bounds.max.to_array()))
}

fn bits_of_camera(camera: &Camera) -> (Vec<u64>, Lens) {
    let Projection { lens, near, far } = camera.projection;
    (bits(camera.view_from_world.to_cols_array().into_iter().chain([near, far])), lens)
}

fn assert_as_walked(scene: &Scene, random: &mut Random) -> Result<(), TestCaseError> {
    prop_assert_eq!(bits_of_bounds(&scene.bounds()), bits_of_bounds(&world_bounds(scene)));
    for _ in 0..3 {
        let (axes, lens) = (random.axes(), random.lens());
        let size = random.of(&[
            Size { width: 1280, height: 720 },
            Size { width: 100, height: 900 },
            Size { width: 0, height: 1 },
        ]);
        let found = fit_along(scene, axes, lens, size);
        let expected = walked(scene, axes, lens, size);
        prop_assert_eq!(bits_of_camera(&found), bits_of_camera(&expected), "{:?} {:?}", axes, lens);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn views_and_bounds_have_the_bits_of_a_walk_also_after_a_change(seed in any::<u64>()) {
        let mut random = Random(seed);
        let mut scene = random.scene();
        assert_as_walked(&scene, &mut random)?;
        let change = random.vector();
        let at = random.below(scene.meshes.len());
        for [x, y, _] in &mut scene.meshes[at].positions {
            *x = 2.0 * *y + change.x as f32;
        }
        assert_as_walked(&scene, &mut random)?;
        scene.meshes[at] = random.mesh();
        assert_as_walked(&scene, &mut random)?;
    }
}
