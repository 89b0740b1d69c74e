//! Shading modes against pictures computed naively: rays, triangles and the lighting equation in f64.

use crate::scenes::{bytes, execution, largest_difference, linear, scene, view};
use luxel_lighting::{Cone, LightKind, Material, Reflection, encode_srgb};
use luxel_math::SimdLevel;
use luxel_render::{At, Renderer, Shading, ShadingMode, View};
use luxel_scene::{
    Camera, DVec3, Encoding, Image, Lens, Mesh, MeshId, Node, Placement, Projection, Sampler,
    Scene, SceneMaterial, Size, Texture, TextureId, TextureUse, default_lights,
};
use std::sync::Arc;

const EYE: DVec3 = DVec3::new(1.5, 1.1, 2.6);

/// A bent sheet of quads with normals, steep enough that perspective matters.
pub(crate) fn sheet() -> Scene {
    const SIDE: u32 = 7;
    let mut mesh = Mesh { polygons: Some(Vec::new()), ..Mesh::default() };
    for row in 0..=SIDE {
        for column in 0..=SIDE {
            let [u, v] = [column, row].map(|at| f64::from(at) / f64::from(SIDE) * 2.0 - 1.0);
            let height = 0.3 * u * u - 0.2 * v * v + 0.1 * u * v;
            let normal = DVec3::new(-0.6 * u - 0.1 * v, 1.0, 0.4 * v - 0.1 * u).normalize();
            mesh.positions.push([u, height, v].map(|value| value as f32));
            mesh.normals.push(normal.as_vec3().to_array());
        }
    }
    for row in 0..SIDE {
        for column in 0..SIDE {
            let first = row * (SIDE + 1) + column;
            let [a, b, c, d] = [first, first + SIDE + 1, first + SIDE + 2, first + 1];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
            let polygon = row * SIDE + column;
            mesh.polygons.as_mut().unwrap().extend([polygon, polygon]);
        }
    }
    let constants = Material {
        reflection: Reflection::BlinnPhong,
        diffuse: [0.7, 0.5, 0.2],
        k_s: 0.8,
        shininess: 20.0,
        ..Material::default()
    };
    scene(vec![(mesh, SceneMaterial { constants, ..SceneMaterial::default() })])
}

pub(crate) fn sheet_view(mode: ShadingMode) -> View {
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let mut lights = default_lights();
    for light in &mut lights {
        light.placement = Placement::World;
    }
    view(1)
        .with_size(Size { width: 96, height: 80 })
        .with_camera(Camera {
            view_from_world: Camera::look_at(EYE, DVec3::ZERO, DVec3::Y),
            projection: Projection { lens, near: 0.1, far: 20.0 },
        })
        .with_lights(lights)
        .with_ambient([0.1, 0.2, 0.3])
        .with_shading(Shading { mode, ..Shading::default() })
}

/// I_a k_a O_a and Blinn-Phong's terms.
fn light(view: &View, material: &Material, place: DVec3, normal: DVec3) -> DVec3 {
    let color = |c: [f32; 3]| DVec3::from_array(c.map(f64::from));
    let to_eye = (EYE - place).normalize();
    let mut sum = color(view.ambient) * color(material.diffuse);
    for placed in &view.lights {
        let to_light = -placed.direction.normalize();
        let n_dot_l = normal.dot(to_light);
        if n_dot_l > 0.0 {
            let n_dot_h = normal.dot((to_light + to_eye).normalize()).max(0.0);
            let lobe = libm::pow(n_dot_h, f64::from(material.shininess));
            sum += color(placed.light.diffuse) * color(material.diffuse) * n_dot_l;
            sum += color(placed.light.specular) * f64::from(material.k_s) * lobe;
        }
    }
    sum
}

/// The colour at a pixel's centre; `None` where nothing is, or close to an edge of a triangle.
fn naive(scene: &Scene, view: &View, x: u32, y: u32) -> Option<[f64; 3]> {
    let world_from_view = view.camera.view_from_world.inverse();
    let half = libm::tan(0.8 / 2.0);
    let (width, height) = (f64::from(view.size.width), f64::from(view.size.height));
    let right = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * half * width / height;
    let up = (1.0 - 2.0 * (f64::from(y) + 0.5) / height) * half;
    let ray = world_from_view.transform_vector3(DVec3::new(right, up, -1.0));
    let mesh = &scene.meshes[0];
    let material = &scene.materials[0].constants;
    let mut nearest: Option<(f64, usize, [f64; 3])> = None;
    for (number, triangle) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = triangle.map(|at| mesh.position(at) - EYE);
        let volumes = [ray.dot(b.cross(c)), ray.dot(c.cross(a)), ray.dot(a.cross(b))];
        let sum = volumes[0] + volumes[1] + volumes[2];
        let weights = volumes.map(|volume| volume / sum);
        let least = weights[0].min(weights[1]).min(weights[2]);
        if least >= -1e-3 {
            let distance = (a * weights[0] + b * weights[1] + c * weights[2]).dot(ray);
            if distance > 0.0 && nearest.is_none_or(|(other, ..)| distance < other) {
                nearest = Some((distance, number, weights));
            }
        }
    }
    let (_, number, weights) = nearest?;
    if weights.iter().any(|weight| *weight < 2e-3) {
        return None;
    }
    let normal_at = |at: u32| DVec3::from_array(mesh.normals[at as usize].map(f64::from));
    let corners = mesh.triangles[number];
    // Which side is seen, the face's plane tells.
    let [a, b, c] = corners.map(|at| mesh.position(at));
    let plane = (b - a).cross(c - a);
    let side = if plane.dot(EYE - a) < 0.0 { -1.0 } else { 1.0 };
    let outwards = plane.dot(corners.map(normal_at).into_iter().sum());
    let side = if outwards < 0.0 { -side } else { side };
    let clamped = |light: DVec3| light.clamp(DVec3::ZERO, DVec3::ONE);
    let mixed = |values: [DVec3; 3]| {
        values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2]
    };
    let sum = match view.shading.mode {
        ShadingMode::Phong => {
            let normal = mixed(corners.map(normal_at)).normalize() * side;
            light(view, material, mixed([a, b, c]), normal)
        }
        ShadingMode::Gouraud => mixed(
            corners
                .map(|at| clamped(light(view, material, mesh.position(at), normal_at(at) * side))),
        ),
        ShadingMode::Flat => {
            let quad = number / 2 * 2;
            let [a, b, c] = mesh.triangles[quad].map(|at| mesh.position(at));
            let d = mesh.position(mesh.triangles[quad + 1][2]);
            let areas = [(b - a).cross(c - a), (c - a).cross(d - a)];
            let whole = areas[0] + areas[1];
            let parts = areas.map(|area| area.dot(whole) / whole.dot(whole));
            let centroid = (a + b + c) / 3.0 * parts[0] + (a + c + d) / 3.0 * parts[1];
            let normal = whole.normalize();
            let normal = if normal.dot(EYE - centroid) < 0.0 { -normal } else { normal };
            clamped(light(view, material, centroid, normal))
        }
        ShadingMode::Subdivided { .. } => return None,
    };
    Some(clamped(sum).to_array())
}

#[test]
fn whole_pictures_are_the_naive_ones_within_a_step() {
    let scene = sheet();
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat] {
        let view = sheet_view(mode);
        let drawn = bytes(&scene, &view);
        let mut compared = 0;
        for y in 0..view.size.height {
            for x in 0..view.size.width {
                let Some(naive) = naive(&scene, &view, x, y) else { continue };
                let pixel = drawn[(y * view.size.width + x) as usize];
                for channel in 0..3 {
                    let expected = 255.0 * encode_srgb(naive[channel]);
                    let off = (f64::from(pixel[channel]) - expected).abs();
                    assert!(off <= 0.51, "{mode:?} ({x}, {y}): {pixel:?} and {naive:?}");
                }
                compared += 1;
            }
        }
        assert!(compared > 1500, "{mode:?}: {compared}");
    }
}

#[test]
fn subdividing_comes_within_its_tolerance_of_phong() {
    let mut scene = sheet();
    // A small highlight, which corners miss.
    scene.materials[0].constants.shininess = 300.0;
    let mirrored = |mode| {
        let mut view = sheet_view(mode);
        // From where the middle of the sheet mirrors it into the eye.
        view.lights[0].direction = EYE * DVec3::new(1.0, -1.0, 1.0);
        view
    };
    let phong = bytes(&scene, &mirrored(ShadingMode::Phong));
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let mut counts = Vec::new();
    for tolerance in [1.0, 4.0, 40.0] {
        let picture = renderer.rgba8(&mirrored(ShadingMode::Subdivided { tolerance })).unwrap();
        let told = picture.subdivision.unwrap();
        assert!(told.largest_error <= tolerance, "{told:?}");
        let mut largest = 0;
        for (a, b) in picture.pixels.as_flattened().iter().zip(phong.as_flattened()) {
            largest = largest.max(a.abs_diff(*b));
        }
        // A byte is rounded by half a step, once in each picture.
        assert!(f32::from(largest) <= told.largest_error + 1.0, "{tolerance}: {largest}");
        assert_eq!((told.beyond, told.beyond_pixels), (0, 0.0));
        if tolerance == 40.0 {
            assert!(largest > 4, "a coarse tolerance shows: {largest}");
        }
        counts.push(told.triangles);
    }
    assert!(counts[0] > counts[1] && counts[1] > counts[2], "{counts:?}");
    assert!(renderer.rgba8(&mirrored(ShadingMode::Phong)).unwrap().subdivision.is_none());
}

#[test]
fn a_texture_colours_of_subdivided_light_what_it_colours_of_phong_s() {
    let mut textured = sheet();
    let texels: [[u8; 3]; 4] = [[255, 255, 255], [20, 60, 200], [4, 2, 1], [250, 130, 0]];
    let texel = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    let image = Arc::new(Image::new("four", Encoding::Srgb, 2, 2, texels.map(texel).to_vec()));
    textured.textures = vec![Texture { image, sampler: Sampler::default() }];
    textured.materials[0].base_color = Some(TextureUse::new(TextureId(0)).into());
    let mesh = &mut textured.meshes[0];
    mesh.uvs[0] = mesh.positions.iter().map(|[x, _, z]| [x * 1.7, z * 1.3]).collect();
    // Every model without jumps; half metals' light isn't linear in the texel.
    let jumps = |model: &Reflection| matches!(model, Reflection::Phong | Reflection::Toon { .. });
    let models = crate::ledger::reflections().into_iter().filter(|model| !jumps(model));
    let mut matters = 0;
    for reflection in models {
        let constants = &mut textured.materials[0].constants;
        (constants.reflection, constants.metallic) = (reflection.clone(), 0.5);
        let scene = &textured;
        for intensity in [0.8, 4.0] {
            let lit = |mode| {
                let mut view = sheet_view(mode);
                view.lights[0].direction = EYE * DVec3::new(1.0, -1.0, 1.0);
                view.lights[0].light.diffuse = [intensity; 3];
                view.lights[0].light.specular = [intensity; 3];
                view
            };
            let phong = bytes(scene, &lit(ShadingMode::Phong));
            let gouraud = bytes(scene, &lit(ShadingMode::Gouraud));
            matters += u32::from(largest_difference(&gouraud, &phong) > 10);
            for tolerance in [1.0, 4.0] {
                let divided = bytes(scene, &lit(ShadingMode::Subdivided { tolerance }));
                let largest = f32::from(largest_difference(&divided, &phong));
                let place = format!("{reflection:?}, {tolerance}, {intensity}");
                assert!(largest <= tolerance + 1.0, "{place}: {largest}");
            }
            ledger_adds_up(scene, &lit(ShadingMode::Subdivided { tolerance: 4.0 }));
        }
    }
    assert!(matters > 6, "highlights and textures matter in {matters} pictures");
}

/// The terms of each corner of a piece, under the pixel's texel, are its light; the weighted sum is the
/// pixel's.
fn ledger_adds_up(scene: &Scene, view: &View) {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    for at in [[30, 30], [48, 40], [60, 50]] {
        let explained = renderer.explain(view, At::Pixel(at)).unwrap();
        let surface = explained.samples[0].seen[0].surface().unwrap();
        assert_eq!((surface.evaluated_at.len(), surface.texture), (3, [1.0; 3]));
        for channel in 0..3 {
            let mut sum = 0.0;
            for place in &surface.evaluated_at {
                let mut terms = place.emission[channel]
                    + place.scene_ambient[channel]
                    + place.environment[channel];
                for light in &place.lights {
                    let of = [light.terms.ambient, light.terms.diffuse, light.terms.specular];
                    terms += of.iter().map(|term| term.lane(0)[channel]).sum::<f32>();
                }
                assert!((terms - place.light[channel]).abs() < 1e-5 * terms.max(1.0), "{at:?}");
                sum += place.weight * place.light[channel];
            }
            let off = (sum - surface.sum[channel]).abs();
            assert!(off < 2e-5 * sum.max(1.0), "{at:?}: {sum} and {}", surface.sum[channel]);
        }
    }
}

#[test]
fn textures_that_shape_the_light_are_lit_at_pixels_by_subdivided_shading() {
    let mut scene = sheet();
    let texels = (0..16).map(|at| [0, at * 16, 255 - at * 9, 255]).collect();
    let image = Arc::new(Image::new("rough", Encoding::Linear, 4, 4, texels));
    scene.textures = vec![Texture { image, sampler: Sampler::default() }];
    scene.materials[0].constants.reflection = Reflection::Microfacet;
    scene.materials[0].metallic_roughness = Some(TextureUse::new(TextureId(0)).into());
    let mesh = &mut scene.meshes[0];
    mesh.uvs[0] = mesh.positions.iter().map(|[x, _, z]| [x * 1.7, z * 1.3]).collect();
    let phong = bytes(&scene, &sheet_view(ShadingMode::Phong));
    let divided = bytes(&scene, &sheet_view(ShadingMode::Subdivided { tolerance: 1.0 }));
    assert_eq!(phong, divided);
    assert_ne!(phong, bytes(&scene, &sheet_view(ShadingMode::Gouraud)));
}

#[test]
fn where_light_jumps_subdividing_tells_how_far_and_on_how_many_pixels() {
    let scene = sheet();
    let with_torch = |mode| {
        let mut view = sheet_view(mode);
        let cone = Cone::Exponent { cos_cutoff: 0.97, exponent: 0.0 };
        view.lights[0].light.kind = LightKind::Spot(cone);
        view.lights[0].position = DVec3::new(0.4, 3.0, 0.5);
        view.lights[0].direction = DVec3::NEG_Y;
        view
    };
    let phong = bytes(&scene, &with_torch(ShadingMode::Phong));
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let mode = ShadingMode::Subdivided { tolerance: 2.0 };
    let picture = renderer.rgba8(&with_torch(mode)).unwrap();
    let told = picture.subdivision.unwrap();
    // The edge of the cone is a jump, which no interpolation follows.
    assert!(told.largest_error > 20.0 && told.beyond > 0, "{told:?}");
    assert!(told.beyond_pixels < 20.0, "it is as thin as a part of a pixel: {told:?}");
    let steps = |(one, other): (&[u8; 4], &[u8; 4])| {
        (0..3).map(|channel| one[channel].abs_diff(other[channel])).max().unwrap()
    };
    let off: Vec<u8> = picture.pixels.iter().zip(&phong).map(steps).collect();
    let largest = f32::from(*off.iter().max().unwrap());
    assert!(largest <= told.largest_error + 1.0);
    let beyond = off.iter().filter(|off| **off > 3).count();
    assert!((beyond as f64) <= told.beyond_pixels + 3.0, "{beyond} of {}", told.beyond_pixels);
}

#[test]
fn with_any_error_allowed_subdividing_is_gouraud_and_lights_no_pixel() {
    let mut scene = sheet();
    // A small highlight, which corners miss.
    scene.materials[0].constants.shininess = 300.0;
    let drawn = |mode| {
        let mut view = sheet_view(mode);
        view.lights[0].direction = EYE * DVec3::new(1.0, -1.0, 1.0);
        bytes(&scene, &view)
    };
    let gouraud = drawn(ShadingMode::Gouraud);
    let subdivided = drawn(ShadingMode::Subdivided { tolerance: 1e6 });
    assert!(largest_difference(&subdivided, &gouraud) <= 1);
    assert!(largest_difference(&drawn(ShadingMode::Phong), &gouraud) > 4);
}

/// The sheet with white vertex colours, which its material reads.
fn coloured_sheet() -> Scene {
    let mut scene = sheet();
    for mesh in &mut scene.meshes {
        mesh.colors = vec![[1.0; 4]; mesh.positions.len()];
    }
    for material in &mut scene.materials {
        material.vertex_colors = true;
    }
    scene
}

#[test]
fn white_vertex_colours_change_no_light_at_pixels_and_none_at_corners() {
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat] {
        let view = sheet_view(mode);
        let (plain, coloured) = (linear(&sheet(), &view), linear(&coloured_sheet(), &view));
        for (plain, coloured) in plain.iter().zip(&coloured) {
            for (plain, coloured) in plain.iter().zip(coloured) {
                assert!((plain - coloured).abs() < 1e-6, "{mode:?}: {plain} and {coloured}");
            }
        }
    }
}

#[test]
fn what_else_a_scene_holds_changes_no_byte_of_a_plain_surface() {
    // A second material, and a coloured mesh behind the eye: batches of the sheet are sorted from
    // others one by one and stay as they are.
    let mut mixed = sheet();
    let other = coloured_sheet();
    let mut mesh = other.meshes[0].clone();
    for position in &mut mesh.positions {
        *position = position.map(|side| side * 0.1 + 9.0);
    }
    for part in &mut mesh.parts {
        part.material.0 += mixed.materials.len() as u32;
    }
    let number = mixed.meshes.len() as u32;
    mixed.meshes.push(mesh);
    mixed.materials.extend(other.materials.iter().cloned());
    mixed.nodes.push(Node::root("other", Some(MeshId(number))));
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud] {
        for samples in [1, 4] {
            let view = sheet_view(mode).with_samples(samples);
            assert!(bytes(&sheet(), &view) == bytes(&mixed, &view), "{mode:?}, {samples} samples");
        }
    }
}
