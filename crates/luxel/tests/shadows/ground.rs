//! The ground under a model: what it shows, and where it shows nothing.

use crate::oracle::{reference, triangles};
use crate::{SIZE, all_pixels, closed, solid, view};
use luxel::render::{Execution, ExplainedGround, Explanation, Renderer, Seen, View};
use luxel::scene::{DVec3, Lens, Scene, SceneLight, Viewpoint, demos, fit_view, primitives};
use luxel::view::{AmbientOcclusion, Background};

fn explained(scene: &Scene, view: &View) -> Vec<Explanation> {
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    renderer.explain_pixels(view, &all_pixels()).unwrap()
}

/// What the first sample of a pixel sees of the ground, if it sees no surface.
fn ground(explained: &Explanation) -> Option<&ExplainedGround> {
    match &explained.samples[0].seen[0] {
        Seen::Background { ground, .. } => ground.as_deref(),
        Seen::Surface(_) => None,
    }
}

/// Views in which each scene stands on a ground that it shades in many pixels.
fn standing() -> Vec<(&'static str, Scene, View)> {
    let named = |name: &'static str| {
        let scene = solid(demos::demo(name).unwrap());
        let view = view(&scene, 0.6).with_shadows(false).with_ground(true);
        (name, scene, view)
    };
    ["teapot", "spheres", "plane", "lab-corrugated"].map(named).into()
}

#[test]
fn the_ground_is_in_shadow_where_f64_rays_meet_a_triangle() {
    let (mut shadowed, mut lit) = (0, 0);
    for (name, scene, view) in standing() {
        let all = triangles(&scene);
        let margin = 1e-5 * scene.bounds().radius();
        let low = all.iter().flat_map(|facet| facet.corners).map(|corner| corner.dot(scene.up));
        let low = low.fold(f64::INFINITY, f64::min);
        let mut uncertain = 0;
        for explained in explained(&scene, &view) {
            let Some(seen) = ground(&explained) else { continue };
            let place = DVec3::from_array(seen.position);
            assert!((place.dot(scene.up) - low).abs() < margin, "{name}: it isn't under the model");
            for light in &seen.lights {
                let Some(shadow) = &light.shadow else { continue };
                let [origin, direction] = shadow.ray.unwrap().map(DVec3::from_array);
                assert!((origin - place).length() <= margin, "{name}: {origin} is not at {place}");
                let end = (DVec3::from_array(light.position) - origin).length();
                let end = if light.name == "sun" { f64::INFINITY } else { end };
                let (mut clear, mut near) = (false, false);
                for facet in &all {
                    let Some((t, inside)) = facet.meeting(origin, direction) else { continue };
                    clear |= t > margin && t < end - margin && inside > margin;
                    near |= t > -margin && t < end + margin && inside > -margin;
                }
                let visibility = light.terms.visibility.unwrap();
                if clear {
                    assert_eq!(visibility, 0.0, "{name}: light leaks at {:?}", explained.pixel);
                    assert!(!shadow.blocked_by.is_empty(), "{name}: nothing is named");
                    shadowed += 1;
                } else if near {
                    uncertain += 1;
                } else {
                    assert_eq!(visibility, 1.0, "{name}: dark at {:?}", explained.pixel);
                    lit += 1;
                }
            }
        }
        assert!(uncertain < 40, "{name}: {uncertain}");
    }
    assert!(shadowed > 500 && lit > 2000, "{shadowed}, {lit}");
}

#[test]
fn the_openness_of_the_ground_is_that_of_f64_rays() {
    for (name, scene, view) in standing().into_iter().take(2) {
        let rule = AmbientOcclusion { radius: Some(f64::INFINITY), rays: 64 };
        let view = view.with_ambient_occlusion(Some(rule));
        let all = triangles(&scene);
        let margin = 1e-5 * scene.bounds().radius();
        let found = explained(&scene, &view);
        let mut grounds: Vec<_> = found.iter().filter_map(ground).collect();
        grounds.retain(|seen| seen.openness < 1.0);
        let mut squares = Vec::new();
        for seen in grounds.iter().step_by(grounds.len() / 20) {
            let place = DVec3::from_array(seen.position);
            let off = f64::from(seen.openness) - reference(&all, place, [scene.up; 2], margin);
            squares.push(off * off);
        }
        let error = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        // As the docs state it for 64 rays.
        assert!(error < 0.03, "{name}: {error}");
    }
}

#[test]
fn the_ground_hides_by_its_missing_light_alone_what_lies_behind() {
    let (name, scene, view) = standing().remove(0);
    for background in [Background::TRANSPARENT, [1.0; 4].into(), [0.2, 0.5, 0.1, 0.4].into()] {
        let view = view.clone().with_background(background);
        let (mut dark, mut clear) = (0, 0);
        for explained in explained(&scene, &view) {
            let Some(seen) = ground(&explained) else { continue };
            let luminance = |[r, g, b]: [f32; 3]| 0.2126_f32 * r + 0.7152_f32 * g + 0.0722_f32 * b;
            let missing = 1.0 - luminance(seen.light) / luminance(seen.unoccluded);
            assert!((seen.darkness - missing).abs() < 1e-6, "{name}: {seen:?}");
            let [r, g, b, alpha] = seen.behind;
            let Background::Flat(flat) = background else { unreachable!() };
            assert_eq!(if alpha > 0.0 { flat } else { [0.0; 4] }, [r, g, b, alpha]);
            // What a page of sRGB's bytes makes of it is what linear light makes of the darkness.
            let on_page = 1.0 - luxel::lighting::encode_srgb(f64::from(1.0 - seen.darkness)) as f32;
            let own = seen.darkness * alpha + on_page * (1.0 - alpha);
            assert!((seen.alpha - own).abs() < 1e-6);
            let covered = own + (1.0 - own) * alpha;
            let [shown @ .., shown_alpha] = explained.linear;
            assert!((shown_alpha - covered).abs() < 1e-6);
            for (shown, behind) in shown.into_iter().zip([r, g, b]) {
                let expected = behind * alpha * (1.0 - own);
                assert!((shown * shown_alpha - expected).abs() < 1e-6, "{:?}", explained.pixel);
            }
            dark += usize::from(seen.darkness > 0.3);
            clear += usize::from(seen.darkness == 0.0);
            let is_open = seen.openness == 1.0
                && seen.lights.iter().all(|light| light.terms.visibility == Some(1.0));
            assert_eq!(seen.darkness == 0.0, is_open, "{:?}", explained.pixel);
        }
        assert!(dark > 50 && clear > 300, "{dark}, {clear}");
    }
}

#[test]
fn a_white_page_shows_a_transparent_picture_as_one_on_white() {
    let (_, _, view) = standing().remove(0);
    let scene = solid(demos::demo("teapot").unwrap());
    let renderer = Renderer::new(scene, &Execution::default()).unwrap();
    // Of several samples the mean is taken of light here, and of bytes there.
    let view = view.with_samples(1).with_size(luxel::scene::Size { width: 96, height: 72 });
    let transparent = renderer.rgba8(&view).unwrap().pixels;
    let white = renderer.rgba8(&view.with_background([1.0; 4])).unwrap().pixels;
    let mut shaded = 0;
    for (transparent, white) in transparent.iter().zip(&white) {
        let [r, g, b, alpha] = *transparent;
        // Where the ground is seen.
        if [r, g, b] != [0; 3] || alpha == 0 {
            continue;
        }
        shaded += 1;
        // As a browser does.
        let page = 255 - i32::from(alpha);
        assert!((page - i32::from(white[0])).abs() <= 1, "{page} for {white:?}");
    }
    assert!(shaded > 80, "{shaded}");
}

#[test]
fn there_is_no_ground_from_below_and_above_the_horizon() {
    let (_, scene, seen_from_above) = standing().remove(0);
    let below = Viewpoint { up: scene.up, azimuth_radians: 0.6, elevation_radians: -0.3 };
    for lens in [Lens::Perspective { fov_y_radians: 0.8 }, Lens::Orthographic { height: 5.0 }] {
        let camera = fit_view(&scene, &below, lens, SIZE);
        let view = seen_from_above.clone().with_camera(camera);
        assert!(explained(&scene, &view).iter().all(|one| ground(one).is_none()), "{lens:?}");
    }
    let level = Viewpoint { up: scene.up, azimuth_radians: 0.6, elevation_radians: 0.0 };
    let camera = fit_view(&scene, &level, Lens::Perspective { fov_y_radians: 0.8 }, SIZE);
    for one in explained(&scene, &seen_from_above.with_camera(camera)) {
        assert!(one.pixel[1] >= SIZE.height / 2 || ground(&one).is_none(), "{:?}", one.pixel);
    }
}

#[test]
fn a_ground_closes_what_stands_on_it() {
    // A box: its bottom lies on the ground, a side sees half of the ground, its top none of it.
    let scene = closed(primitives::cuboid(DVec3::ONE), 1.0, DVec3::ZERO, false);
    let rule = AmbientOcclusion { radius: Some(f64::INFINITY), rays: 256 };
    for (elevation, expected) in [(-1.5, 0.0), (0.0, 0.5), (1.5, 1.0)] {
        let from = Viewpoint { up: scene.up, azimuth_radians: 0.0, elevation_radians: elevation };
        let lens = Lens::Orthographic { height: 0.5 };
        let camera = fit_view(&scene, &from, lens, SIZE);
        let view = View::new(SIZE, camera)
            .with_samples(1)
            .with_ambient_occlusion(Some(rule))
            .with_ground(true);
        let open: Vec<f32> = explained(&scene, &view)
            .iter()
            .filter_map(|one| one.samples[0].seen[0].surface())
            .filter(|surface| {
                let [.., facing] = surface.view;
                let [x, y, z] = surface.normal;
                // The face that is seen from the front.
                elevation != 0.0 || z * facing > 0.9 && x.abs() + y.abs() < 0.1
            })
            .filter(|surface| elevation == 0.0 || surface.normal[1].abs() > 0.9)
            .filter_map(|surface| surface.openness)
            .collect();
        assert!(open.len() > 100, "{elevation}: {}", open.len());
        for openness in open {
            assert!((openness - expected).abs() < 0.01, "{elevation}: {openness}");
        }
    }
}

#[test]
fn a_light_from_below_shades_no_ground() {
    let (_, scene, view) = standing().remove(0);
    let below = SceneLight::directional(scene.up, [1.0; 3]).named("below");
    let view = view.with_lights(vec![below]).with_ambient([0.0; 3]);
    for one in explained(&scene, &view) {
        let darkness = ground(&one).map_or(0.0, |seen| seen.darkness);
        assert_eq!(darkness, 0.0, "{:?}", one.pixel);
    }
}
