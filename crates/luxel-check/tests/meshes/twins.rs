use crate::made::{ball, ball_with_normals, checked, counts, field, hill, scene_of, setup};
use luxel_check::{Kind, Report, check};
use luxel_lighting::{Material, Reflection};
use luxel_render::{Interpolation, ShadingMode};
use luxel_scene::{Camera, DVec3, Lines, Mesh, Sides, Size};

fn severity(report: &Report, kind: Kind) -> f32 {
    let finding = report.findings.iter().find(|finding| finding.kind == kind).unwrap();
    finding.severity.unwrap()
}

#[test]
fn nothing_is_found_on_sound_meshes() {
    for (name, mesh) in
        [("ball", ball()), ("with normals", ball_with_normals()), ("hill", hill(16))]
    {
        assert_eq!(counts(mesh), [], "{name}");
    }
    for name in ["teapot", "spheres", "cornell", "plane"] {
        let scene = luxel_scene::demos::demo(name).unwrap();
        assert_eq!(check(&scene, &setup(&scene)).findings, [], "{name}");
    }
}

#[test]
fn an_empty_scene_has_no_findings() {
    assert_eq!(counts(Mesh::default()), []);
    let scene = luxel_scene::Scene::default();
    assert_eq!(check(&scene, &setup(&scene)).findings, []);
}

#[test]
fn faces_without_area_are_counted() {
    let mut mesh = hill(8);
    let [a, b, _] = mesh.triangles[0];
    mesh.triangles.extend([[a, a, b], [b, b, b]]);
    let middle = mesh.positions.len() as u32;
    // In the middle of an edge, as far as f32 can tell.
    let [from, to] = [a, b].map(|corner| mesh.positions[corner as usize]);
    mesh.positions.push([0, 1, 2].map(|axis| (from[axis] + to[axis]) * 0.5));
    mesh.triangles.push([a, middle, b]);
    assert_eq!(counts(mesh), [(Kind::DegenerateFace, 3)]);
}

#[test]
fn doubled_faces_are_counted_unless_they_are_the_back_of_a_sheet() {
    let mut mesh = hill(8);
    let [a, b, c] = mesh.triangles[5];
    mesh.triangles.extend([[b, c, a], [a, c, b], [c, a, b]]);
    assert_eq!(counts(mesh.clone()), [(Kind::DuplicateFace, 3)]);
    let mut scene = scene_of(mesh);
    scene.materials[0].sides = Sides::Front;
    let report = check(&scene, &setup(&scene));
    assert_eq!(report.findings[0].count, 2, "one of them is the back of a sheet");
}

#[test]
fn faces_wound_against_their_neighbours_are_counted_and_seen() {
    let mut mesh = ball();
    for triangle in [3, 77, 400] {
        mesh.triangles[triangle].swap(0, 1);
    }
    assert_eq!(counts(mesh.clone()), [(Kind::InconsistentWinding, 3)]);
    let report = checked(mesh);
    assert!(severity(&report, Kind::InconsistentWinding) > 5.0, "averages of normals cancel out");
    let places: Vec<_> = report.findings[0].places.iter().map(|place| place.triangle).collect();
    assert_eq!(places, [Some(3), Some(77), Some(400)]);
}

#[test]
fn a_solid_inside_out_is_flipped_and_a_cavity_is_not() {
    let count = ball().triangles.len() as u64;
    let turned = |mut mesh: Mesh| {
        mesh.triangles.iter_mut().for_each(|corners| corners.swap(0, 1));
        mesh
    };
    assert_eq!(counts(turned(ball())), [(Kind::FlippedWinding, count)]);
    let mut hollow = ball();
    let first = hollow.positions.len() as u32;
    let cavity = turned(ball());
    hollow.positions.extend(cavity.positions.iter().map(|position| position.map(|x| 0.5 * x)));
    hollow.triangles.extend(cavity.triangles.iter().map(|corners| corners.map(|c| c + first)));
    assert_eq!(counts(hollow), []);
}

#[test]
fn faces_behind_their_normals_are_flipped() {
    let mut mesh = hill(8);
    mesh.normals = vec![[0.0, 1.0, 0.0]; mesh.positions.len()];
    assert_eq!(counts(mesh.clone()), []);
    mesh.triangles.iter_mut().for_each(|corners| corners.swap(0, 1));
    assert_eq!(counts(mesh.clone()), [(Kind::FlippedWinding, 128)]);
    // luxel shows both sides, so it looks right; with culling it would disappear.
    assert_eq!(severity(&checked(mesh.clone()), Kind::FlippedWinding), 0.0);
    let mut scene = scene_of(mesh);
    scene.materials[0].sides = Sides::Front;
    let report = check(&scene, &setup(&scene));
    assert!(severity(&report, Kind::FlippedWinding) > 100.0);
}

#[test]
fn a_band_with_one_side_turns_over_once_and_one_with_two_never() {
    let band = |half_turns: f32| {
        let mut mesh = Mesh::default();
        const STEPS: u32 = 64;
        for step in 0..STEPS {
            let angle = std::f32::consts::TAU * step as f32 / STEPS as f32;
            let turn = angle * 0.5 * half_turns;
            for side in [-0.3_f32, 0.3] {
                let radius = 1.0 + side * libm::cosf(turn);
                let position = [
                    radius * libm::cosf(angle),
                    side * libm::sinf(turn),
                    radius * libm::sinf(angle),
                ];
                mesh.positions.push(position);
            }
        }
        for step in 0..STEPS {
            let (a, b) = (2 * step, 2 * step + 1);
            let (mut c, mut d) = ((a + 2) % (2 * STEPS), (b + 2) % (2 * STEPS));
            if step == STEPS - 1 && half_turns % 2.0 == 1.0 {
                (c, d) = (d, c);
            }
            mesh.triangles.extend([[a, b, c], [b, d, c]]);
        }
        mesh
    };
    assert_eq!(counts(band(2.0)), []);
    assert_eq!(counts(band(1.0)), [(Kind::OneSidedSurface, 1)]);
}

#[test]
fn edges_of_three_faces_are_counted() {
    let mut mesh = hill(8);
    // A wall along two edges in the middle of the field.
    let [a, b, c] = [40, 41, 42];
    let first = mesh.positions.len() as u32;
    for corner in [a, b, c] {
        let [x, y, z] = mesh.positions[corner as usize];
        mesh.positions.push([x, y + 0.2, z]);
    }
    let [d, e, f] = [first, first + 1, first + 2];
    mesh.triangles.extend([[a, b, d], [b, e, d], [b, c, e], [c, f, e]]);
    assert_eq!(counts(mesh), [(Kind::NonManifoldEdge, 2)]);
}

/// Two fields side by side along x = 1, of n rows each and of m times as many.
fn side_by_side(n: u32, m: u32, height: impl Fn(f32, f32) -> f32 + Copy) -> Mesh {
    let mut mesh = field(n, height);
    let right = field(n * m, |x, z| height(x + 1.0, z));
    // Equal coordinates count as the same position.
    let mut number = Vec::new();
    for &[x, y, z] in &right.positions {
        let position = [x + 1.0, y, z];
        let known = mesh.positions.iter().position(|other| *other == position);
        number.push(known.unwrap_or_else(|| {
            mesh.positions.push(position);
            mesh.positions.len() - 1
        }) as u32);
    }
    mesh.triangles.extend(right.triangles.iter().map(|c| c.map(|corner| number[corner as usize])));
    mesh
}

#[test]
fn corners_in_the_middle_of_edges_are_counted() {
    // Plane, so that the middles of edges are exactly on them.
    let flat = |_: f32, _: f32| 0.25;
    assert_eq!(counts(side_by_side(4, 1, flat)), []);
    assert_eq!(counts(side_by_side(4, 2, flat)), [(Kind::TJunction, 4)]);
    assert_eq!(counts(side_by_side(4, 4, flat)), [(Kind::TJunction, 12)]);
}

#[test]
fn a_t_junction_on_a_bent_surface_is_seen_and_its_cure_is_not() {
    // Bent across the seam, straight along it.
    let bent = |x: f32, _: f32| 0.5 * (x - 1.0) * (x - 1.0) + 0.5 * (x - 1.0);
    let report = checked(side_by_side(4, 2, bent));
    assert_eq!(report.findings[0].kind, Kind::TJunction);
    assert!(severity(&report, Kind::TJunction) >= 1.0);
}

#[test]
fn gaps_between_edges_are_counted_and_wide_ones_are_meant() {
    let with_gap = |width: f32| {
        let mut mesh = hill(8);
        let first = mesh.positions.len() as u32;
        let right: Vec<usize> = (0..=8).map(|row| row * 9 + 4).collect();
        for &corner in &right {
            let [x, y, z] = mesh.positions[corner];
            mesh.positions.push([x + width, y, z]);
        }
        // The right half of the field uses copies of the middle column.
        for corners in &mut mesh.triangles {
            let is_right = corners.iter().any(|&corner| corner % 9 > 4);
            if is_right {
                for corner in corners {
                    if let Some(row) = right.iter().position(|&at| at == *corner as usize) {
                        *corner = first + row as u32;
                    }
                }
            }
        }
        mesh
    };
    assert_eq!(counts(with_gap(1e-4)), [(Kind::Crack, 8)]);
    assert_eq!(counts(with_gap(0.05)), [], "a gap of half an edge is meant");
    assert_eq!(counts(with_gap(0.0)), [(Kind::DuplicateVertex, 9)], "no gap but two numbers");
    let report = checked(with_gap(1e-4));
    assert!(severity(&report, Kind::Crack) >= 1.0, "normals break there");
}

#[test]
fn thin_strips_are_no_gaps_but_slits_in_a_surface_are() {
    let strip = |places: &[[f32; 3]], triangles: &[[u32; 3]]| Mesh {
        positions: places.to_vec(),
        triangles: triangles.to_vec(),
        ..Mesh::default()
    };
    for width in [0.009, 1e-3, 1e-5] {
        let [a, b] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
        let [c, d] = [[1.0, width, 0.0], [0.0, width, 0.0]];
        let (middle, far) = ([0.0, width * 0.5, 0.0], [0.5, width, 0.0]);
        for (what, mesh) in [
            ("a quad", strip(&[a, b, c, d], &[[0, 1, 2], [0, 2, 3]])),
            ("its other diagonal", strip(&[a, b, c, d], &[[0, 1, 3], [1, 2, 3]])),
            ("a needle", strip(&[a, b, c], &[[0, 1, 2]])),
            (
                "a corner at its end",
                strip(&[a, b, c, d, middle], &[[0, 1, 4], [1, 2, 4], [2, 3, 4]]),
            ),
            ("a corner at its side", strip(&[a, b, c, d, far], &[[0, 1, 4], [1, 2, 4], [0, 4, 3]])),
        ] {
            let kinds: Vec<_> = counts(mesh).into_iter().map(|(kind, _)| kind).collect();
            assert!(!kinds.contains(&Kind::Crack), "{what} of width {width}: {kinds:?}");
        }
        // Two quads with a slit between them, that another one closes at its end.
        let wide = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.3],
            [0.0, 1.0, 0.3],
            [0.0, -width, 0.0],
            [1.0, -width, 0.0],
            [1.0, -1.0, 0.3],
            [0.0, -1.0, 0.3],
        ];
        let slit = strip(&wide, &[[0, 1, 2], [0, 2, 3], [5, 4, 6], [4, 7, 6]]);
        assert!(counts(slit).contains(&(Kind::Crack, 1)), "a slit of width {width}");
    }
}

#[test]
fn repeated_vertices_count_where_they_cut_a_smooth_surface() {
    let soup = |mesh: &Mesh| Mesh {
        positions: mesh
            .triangles
            .as_flattened()
            .iter()
            .map(|&corner| mesh.positions[corner as usize])
            .collect(),
        triangles: (0..mesh.triangles.len() as u32)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2])
            .collect(),
        ..Mesh::default()
    };
    let ball = ball();
    let repeated = (3 * ball.triangles.len() - ball.positions.len()) as u64;
    assert_eq!(counts(soup(&ball)), [(Kind::DuplicateVertex, repeated)]);
    // On a flat face and at sharp edges nothing is lost.
    assert_eq!(counts(soup(&field(4, |_, _| 0.0))), []);
    let cube = luxel_scene::primitives::cuboid([1.0; 3].into());
    let cube = Mesh { positions: cube.positions, triangles: cube.triangles, ..Mesh::default() };
    assert_eq!(counts(soup(&cube)), []);
}

#[test]
fn normals_that_are_none_or_too_long_are_counted() {
    let mut mesh = ball_with_normals();
    mesh.normals[3] = [0.0; 3];
    mesh.normals[5] = [f32::NAN, 0.0, 1.0];
    for vertex in [7, 8, 9] {
        mesh.normals[vertex] = mesh.normals[vertex].map(|x| 1.1 * x);
    }
    // Normals rounded to bytes count as unit.
    mesh.normals[10] = mesh.normals[10].map(|x| 1.007 * x);
    assert_eq!(counts(mesh), [(Kind::UndefinedNormal, 2), (Kind::NonUnitNormal, 3)]);
}

#[test]
fn normals_behind_their_faces_are_counted_and_seen() {
    let mut mesh = ball_with_normals();
    mesh.normals[100] = mesh.normals[100].map(|x| -x);
    let report = checked(mesh);
    let found: Vec<_> = report.findings.iter().map(|f| (f.kind, f.count)).collect();
    assert_eq!(found, [(Kind::NormalBehindFace, 1)]);
    assert!(severity(&report, Kind::NormalBehindFace) > 50.0);
}

#[test]
fn faces_of_which_their_normals_know_nothing_are_counted() {
    // A zigzag whose averages are all upright: folds that shading doesn't show.
    let zigzag = |slope: f32| {
        let mut mesh = field(8, |x, _| if (x * 8.0) as u32 % 2 == 1 { slope / 8.0 } else { 0.0 });
        mesh.normals = vec![[0.0, 1.0, 0.0]; mesh.positions.len()];
        mesh
    };
    assert_eq!(counts(zigzag(0.3)), [], "17 degrees are a bump");
    assert_eq!(counts(zigzag(2.5)), [(Kind::UnrepresentativeNormals, 128)]);
}

#[test]
fn folds_that_normals_average_away_are_counted_and_seen() {
    let zigzag = |slope: f32| {
        field(8, |x, _| if (x * 8.0).round() as u32 % 2 == 1 { slope / 8.0 } else { 0.0 })
    };
    // Seven folds of 90 degrees, each over eight cells.
    let upright =
        Mesh { normals: vec![[0.0, 1.0, 0.0]; zigzag(1.0).positions.len()], ..zigzag(1.0) };
    let report = checked(upright);
    let found: Vec<_> = report.findings.iter().map(|f| (f.kind, f.count)).collect();
    assert_eq!(found, [(Kind::HiddenFold, 56)]);
    assert!(severity(&report, Kind::HiddenFold) > 30.0);
    assert_eq!(counts(zigzag(1.0)), [], "normals split at folds show them");
    // A box whose normals are averages is badly shaded, but its edges show.
    let cube = luxel_scene::primitives::cuboid([1.0; 3].into());
    let diagonal = |position: &[f32; 3]| position.map(|x| x.signum() / 3.0_f32.sqrt());
    let normals = cube.positions.iter().map(diagonal).collect();
    let cube =
        Mesh { normals, positions: cube.positions, triangles: cube.triangles, ..Mesh::default() };
    assert!(!counts(cube).iter().any(|(kind, _)| *kind == Kind::HiddenFold));
}

#[test]
fn slivers_count_where_they_show() {
    let sliver = |bend: f32, height: f32| {
        let mut mesh = Mesh {
            positions: vec![
                [-1.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 0.0, height],
                [0.0, 0.0, -1.0],
                [0.0, 0.0, 1.0],
            ],
            // The sliver between two fat triangles.
            triangles: vec![[0, 2, 1], [0, 1, 3], [0, 4, 2], [2, 4, 1]],
            ..Mesh::default()
        };
        mesh.normals = vec![[0.0, 1.0, 0.0]; 5];
        mesh.normals[2] = [libm::sinf(bend), libm::cosf(bend), 0.0];
        mesh
    };
    assert_eq!(counts(sliver(0.0, 0.02)), [], "flat ones do no harm");
    assert_eq!(counts(sliver(0.5, 0.02)), [(Kind::Sliver, 1)]);
    assert_eq!(counts(sliver(0.5, 0.3)), [], "it is not thin");
    assert_eq!(counts(sliver(0.0, 0.001)), [(Kind::Sliver, 1)], "never a pixel wide");
}

#[test]
fn highlights_between_vertices_are_lost_where_vertices_are_lit() {
    let shiny = |mesh: Mesh, shininess: f32| {
        let mut scene = scene_of(mesh);
        scene.materials[0].constants = Material {
            reflection: Reflection::Phong,
            diffuse: [0.1; 3],
            k_s: 0.8,
            shininess,
            ..Material::default()
        };
        assert_eq!(check(&scene, &setup(&scene)).findings, [], "pixels are lit and lose none");
        let mut asked = setup(&scene);
        asked.view.shading.mode = ShadingMode::Gouraud;
        let report = check(&scene, &asked);
        if !report.findings.is_empty() {
            assert!(severity(&report, Kind::MissedHighlight) > 16.0);
        }
        let found = report.findings.iter();
        found.map(|finding| (finding.kind, finding.count)).collect::<Vec<_>>()
    };
    let count = ball().triangles.len() as u64;
    assert_eq!(shiny(ball_with_normals(), 400.0), [(Kind::MissedHighlight, count)]);
    assert_eq!(shiny(ball_with_normals(), 2.0), []);
}

#[test]
fn a_highlight_that_a_lamp_puts_inside_a_flat_face_is_missed_by_its_corners() {
    let found = |with_line: bool| {
        let mut scene = luxel_scene::demos::demo("lab-lamp").unwrap();
        if with_line {
            // A line has no triangle that could be named.
            let (material, ends) = (scene.meshes[0].parts[0].material, [0, 2]);
            scene.meshes[0].lines.push(Lines { segments: vec![ends], material });
        }
        scene.compute_normals(&Default::default());
        let mut asked = setup(&scene);
        asked.view.lights = scene.lights.clone();
        asked.view.shading.mode = ShadingMode::Gouraud;
        let report = check(&scene, &asked);
        report.findings.iter().map(|found| (found.kind, found.count)).collect::<Vec<_>>()
    };
    assert_eq!(found(false), [(Kind::MissedHighlight, 2)]);
    assert_eq!(found(true), [(Kind::MissedHighlight, 2)]);
}

#[test]
fn things_slide_over_triangles_that_reach_into_the_depth() {
    let seen = |n: u32| {
        let scene = scene_of(field(n, |_, _| 0.0));
        let mut setup = setup(&scene);
        setup.view.shading.interpolation = Interpolation::Screen;
        // From above one edge, along the field.
        setup.view.camera.view_from_world =
            Camera::look_at(DVec3::new(0.5, 0.5, 2.0), DVec3::new(0.5, 0.0, 0.5), DVec3::Y);
        setup.view.size = Size { width: 720, height: 720 };
        check(&scene, &setup).findings
    };
    let [finding] = &seen(1)[..] else { panic!("two triangles reach from near to far") };
    assert_eq!((finding.kind, finding.count), (Kind::ScreenDrift, 2));
    // The diagonal is the longest edge: its ends as the lens of 45 degrees shows them.
    let back = DVec3::new(0.0, 0.5, 1.5).normalize();
    let up = DVec3::X.cross(-back).normalize();
    let up = if up.y < 0.0 { -up } else { up };
    let shown = |x: f64, z: f64| {
        let way = DVec3::new(x, 0.0, z) - DVec3::new(0.5, 0.5, 2.0);
        let depth = -way.dot(back);
        let scale = 360.0 / (libm::tan(std::f64::consts::FRAC_PI_8) * depth);
        ([way.x * scale, way.dot(up) * scale], depth)
    };
    let ([x, y], far) = shown(0.0, 0.0);
    let ([other_x, other_y], near) = shown(1.0, 1.0);
    let root = (far / near).sqrt();
    let expected = (x - other_x).hypot(y - other_y) * (root - 1.0) / (root + 1.0);
    let pixels = f64::from(finding.pixels.unwrap());
    assert!((pixels - expected).abs() < 1e-3 * expected, "{pixels} {expected}");
    assert_eq!(seen(40), [], "small triangles have one depth");
    let beside = scene_of(field(1, |_, _| 0.0));
    let mut away = setup(&beside);
    away.view.shading.interpolation = Interpolation::Screen;
    away.view.camera.view_from_world =
        Camera::look_at(DVec3::new(0.5, 0.5, 4.0), DVec3::new(4.0, 0.5, 1.0), DVec3::Y);
    assert_eq!(check(&beside, &away).findings, [], "nothing slides where nothing is seen");
    let scene = scene_of(field(1, |_, _| 0.0));
    assert_eq!(check(&scene, &setup(&scene)).findings, [], "nobody interpolates in the window");
}

#[test]
fn coarse_silhouettes_are_reported_in_pixels() {
    let ball = |level| {
        let mesh = luxel_scene::primitives::icosphere(1.0, level);
        let scene = scene_of(mesh);
        check(&scene, &setup(&scene)).findings
    };
    assert_eq!(ball(8), []);
    let [finding] = &ball(2)[..] else { panic!("a ball of 80 triangles is not round") };
    assert_eq!(finding.kind, Kind::FacetedSilhouette);
    // 576 pixels across, edges of 31.7 and 36 degrees: r (1 - cos 18 degrees) is 14 pixels.
    let pixels = finding.pixels.unwrap();
    assert!((9.0..16.0).contains(&pixels), "{pixels}");
    // A cube has sharp edges, but no silhouette of a curve.
    let cube = luxel_scene::primitives::cuboid([1.0; 3].into());
    assert_eq!(counts(cube), []);
}

#[test]
fn a_mesh_of_several_objects_is_reported_once() {
    let mut mesh = hill(8);
    mesh.triangles[5].swap(0, 1);
    let mut scene = scene_of(mesh);
    scene.nodes.push(luxel_scene::Node::root("again", Some(luxel_scene::MeshId(0))));
    let findings = check(&scene, &setup(&scene)).findings;
    assert_eq!((findings.len(), findings[0].count), (1, 1));
}

#[test]
fn marks_show_where_findings_are() {
    let mut mesh = hill(8);
    mesh.triangles[60].swap(0, 1);
    let scene = scene_of(mesh);
    let setup = setup(&scene);
    let marked = check(&scene, &setup).marked(&scene);
    assert_eq!(marked.objects().len(), 2);
    let marks = &marked.meshes[marked.objects()[0].mesh.index()];
    assert_eq!(marks.triangles, [scene.meshes[0].triangles[60]]);
    let color = &marked.materials[marks.parts[0].material.index()].constants.diffuse;
    assert_eq!(*color, Kind::InconsistentWinding.color());
}
