//! Quadrics (GLU 1.3, chapter 6) beside the formulas of the surfaces.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_glu::{DrawStyle, Drawing, InvalidValue, MOST_STEPS, Normals, Orientation, Quadric};

#[derive(Clone, Copy, Default)]
struct Vertex {
    position: [f64; 3],
    normal: [f64; 3],
    texture: [f64; 2],
}

/// Takes down primitives.
#[derive(Default)]
struct Notes {
    primitives: Vec<(u32, Vec<Vertex>)>,
    current: Vertex,
}

impl Drawing for Notes {
    fn begin(&mut self, mode: u32) {
        self.primitives.push((mode, Vec::new()));
    }

    fn end(&mut self) {}

    fn normal(&mut self, normal: [f64; 3]) {
        self.current.normal = normal;
    }

    fn tex_coord(&mut self, st: [f64; 2]) {
        self.current.texture = st;
    }

    fn vertex(&mut self, position: [f64; 3]) {
        self.current.position = position;
        self.primitives.last_mut().unwrap().1.push(self.current);
    }
}

impl Notes {
    fn vertices(&self) -> impl Iterator<Item = &Vertex> {
        self.primitives.iter().flat_map(|(_, vertices)| vertices)
    }

    /// The quads of strips and of quads; triangles of fans, with a corner twice.
    fn quads(&self) -> Vec<[Vertex; 4]> {
        let mut quads = Vec::new();
        for (mode, v) in &self.primitives {
            match mode {
                6 => quads.extend(v[1..].windows(2).map(|pair| [v[0], pair[0], pair[1], pair[1]])),
                7 => quads.extend(v.chunks(4).map(|q| [q[0], q[1], q[2], q[3]])),
                8 => quads.extend(
                    (0..v.len() - 3).step_by(2).map(|i| [v[i], v[i + 1], v[i + 3], v[i + 2]]),
                ),
                _ => panic!("mode {mode} is no quads"),
            }
        }
        quads
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The sum of a quad's triangles as vectors of area, and the volume of the tetrahedra to the origin.
fn area_and_volume(quad: &[Vertex; 4]) -> ([f64; 3], f64) {
    let p = quad.map(|vertex| vertex.position);
    let area = cross(minus(p[2], p[0]), minus(p[3], p[1])).map(|x| x / 2.0);
    let tetrahedron = |a, b, c| dot(a, cross(b, c)) / 6.0;
    (area, tetrahedron(p[0], p[1], p[2]) + tetrahedron(p[0], p[2], p[3]))
}

#[test]
fn a_sphere_has_its_radius_its_normals_and_nearly_its_volume() {
    for orientation in [Orientation::Outside, Orientation::Inside] {
        let mut notes = Notes::default();
        let quadric = Quadric { orientation, ..Quadric::default() };
        quadric.sphere(&mut notes, 2.0, 64, 48).unwrap();
        let sign = if orientation == Orientation::Outside { 1.0 } else { -1.0 };
        for vertex in notes.vertices() {
            assert!((dot(vertex.position, vertex.position) - 4.0).abs() < 1e-12);
            assert!((dot(vertex.position, vertex.normal) - sign * 2.0).abs() < 1e-12);
        }
        let volume: f64 = notes.quads().iter().map(|quad| area_and_volume(quad).1).sum();
        let exact = sign * 32.0 * std::f64::consts::PI / 3.0;
        assert!((volume / exact - 1.0).abs() < 0.01, "{volume} is not nearly {exact}");
    }
}

#[test]
fn flat_shading_lights_each_facet_about_a_pole_by_a_corner_of_its_own() {
    let mut notes = Notes::default();
    Quadric::default().sphere(&mut notes, 1.0, 6, 4).unwrap();
    let fans: Vec<_> = notes.primitives.iter().filter(|(mode, _)| *mode == 6).collect();
    assert_eq!(fans.len(), 2);
    for (_, fan) in fans {
        assert_eq!(fan.len(), 8);
        assert_eq!(fan[0].position[2].abs(), 1.0);
        assert!(fan[1..].windows(2).all(|pair| pair[0].normal != pair[1].normal));
    }
    // Texture coordinates of a pole are others for each facet.
    let mut notes = Notes::default();
    let textured = Quadric { textured: true, ..Quadric::default() };
    textured.sphere(&mut notes, 1.0, 6, 4).unwrap();
    assert!(notes.primitives.iter().all(|(mode, _)| *mode == 8));
}

#[test]
fn flat_facets_have_one_normal_that_is_perpendicular_to_them() {
    let mut notes = Notes::default();
    let quadric = Quadric { normals: Normals::Flat, ..Quadric::default() };
    quadric.cylinder(&mut notes, [1.0, 0.4], 2.0, 7, 3).unwrap();
    assert_eq!(notes.quads().len(), 21);
    for quad in notes.quads() {
        let (area, _) = area_and_volume(&quad);
        let length = dot(area, area).sqrt();
        for vertex in quad {
            assert_eq!(vertex.normal, quad[0].normal);
            // Of the frustum that touches the edges: the facet is a little steeper.
            assert!(dot(area, vertex.normal) > 0.999 * length);
        }
    }
}

#[test]
fn a_disk_has_the_area_of_its_polygon_and_a_part_of_it_a_part() {
    let area = |inner: f64, start: f64, sweep: f64| {
        let mut notes = Notes::default();
        Quadric::default().partial_disk(&mut notes, [inner, 2.0], 36, 3, [start, sweep]).unwrap();
        notes.quads().iter().map(|quad| area_and_volume(quad).0[2]).sum::<f64>()
    };
    // 36 triangles of the angle 10 degrees, whose sine is 0.17364817766693033.
    let whole = 36.0 * 2.0 * 0.173_648_177_666_930_33;
    assert!((area(0.0, 0.0, 360.0) - whole).abs() < 1e-12);
    assert!((area(0.0, 17.0, -720.0) - whole).abs() < 1e-12);
    assert!((area(1.0, 0.0, 360.0) - 0.75 * whole).abs() < 1e-12);
    // Ten degrees in 36 steps are nearly the sector.
    assert!((area(0.0, 33.0, 10.0) - 10.0f64.to_radians() * 2.0).abs() < 1e-5);
    assert!((area(0.0, 33.0, -10.0) - 10.0f64.to_radians() * 2.0).abs() < 1e-5);
}

#[test]
fn texture_coordinates_run_around_up_and_across() {
    let textured = Quadric { textured: true, ..Quadric::default() };
    let mut notes = Notes::default();
    textured.sphere(&mut notes, 1.0, 4, 2).unwrap();
    // +x is at three quarters, the north pole at the top.
    let at = |notes: &Notes, p: [f64; 3]| {
        let near = |v: &&Vertex| dot(minus(v.position, p), minus(v.position, p)) < 1e-12;
        notes.vertices().find(near).unwrap().texture
    };
    assert_eq!(at(&notes, [1.0, 0.0, 0.0]), [0.75, 0.5]);
    assert_eq!(at(&notes, [0.0, 0.0, 1.0])[1], 1.0);
    let mut notes = Notes::default();
    textured.disk(&mut notes, [0.0, 2.0], 4, 2).unwrap();
    let corner = at(&notes, [2.0, 0.0, 0.0]);
    assert!((corner[0] - 1.0).abs() < 1e-12 && (corner[1] - 0.5).abs() < 1e-12);
}

#[test]
fn styles_draw_points_lines_and_outlines() {
    let count = |draw_style: DrawStyle, f: fn(&Quadric, &mut Notes)| {
        let mut notes = Notes::default();
        f(&Quadric { draw_style, ..Quadric::default() }, &mut notes);
        let modes: Vec<u32> = notes.primitives.iter().map(|(mode, _)| *mode).collect();
        (modes.len(), modes[0], notes.vertices().count())
    };
    let ring: fn(&Quadric, &mut Notes) = |q, n| q.disk(n, [1.0, 2.0], 6, 2).unwrap();
    assert_eq!(count(DrawStyle::Point, ring), (1, 0, 18));
    assert_eq!(count(DrawStyle::Line, ring), (9, 3, 3 * 7 + 6 * 3));
    assert_eq!(count(DrawStyle::Silhouette, ring), (2, 3, 14));
    let part: fn(&Quadric, &mut Notes) =
        |q, n| q.partial_disk(n, [1.0, 2.0], 6, 2, [0.0, 90.0]).unwrap();
    assert_eq!(count(DrawStyle::Silhouette, part), (4, 3, 20));
}

#[test]
fn sizes_that_no_shape_has_are_refused() {
    let mut notes = Notes::default();
    let q = Quadric::default();
    for radius in [-1.0, f64::NAN] {
        assert_eq!(q.sphere(&mut notes, radius, 5, 5), Err(InvalidValue));
        assert_eq!(q.cylinder(&mut notes, [radius, 1.0], 1.0, 5, 5), Err(InvalidValue));
        assert_eq!(q.cylinder(&mut notes, [1.0, 1.0], radius, 5, 5), Err(InvalidValue));
        assert_eq!(q.disk(&mut notes, [radius, 1.0], 5, 5), Err(InvalidValue));
        assert_eq!(q.disk(&mut notes, [0.0, radius], 5, 5), Err(InvalidValue));
    }
    assert_eq!(q.sphere(&mut notes, 1.0, 1, 5), Err(InvalidValue));
    assert_eq!(q.sphere(&mut notes, 1.0, 5, 0), Err(InvalidValue));
    assert_eq!(q.disk(&mut notes, [2.0, 1.0], 5, 5), Err(InvalidValue));
    assert_eq!(
        q.partial_disk(&mut notes, [0.0, 1.0], 5, 5, [f64::INFINITY, 1.0]),
        Err(InvalidValue)
    );
    assert!(notes.primitives.is_empty());
    // More steps than anybody sees don't take for ever.
    q.sphere(&mut notes, 1.0, i32::MAX, 1).unwrap();
    assert_eq!(notes.vertices().count(), 2 * (MOST_STEPS as usize + 1));
}
