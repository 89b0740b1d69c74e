use super::*;
use crate::{ErrorKind, Place};
use luxel_lighting::Reflection;
use luxel_scene::{AlphaMode, MaterialId, Mesh};
use proptest::prelude::*;
use std::fmt::Write;

fn load(text: &str) -> Result<Loaded, Error> {
    read(text.as_bytes(), "stem", None, &Limits::default())
}

fn scene(text: &str) -> Scene {
    load(text).unwrap().scene
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.nodes.iter().map(|node| node.name.as_str()).collect()
}

const QUAD: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn quad(rest: &str) -> String {
    format!("{QUAD}{rest}")
}

fn one(rest: &str) -> Mesh {
    scene(&quad(rest)).meshes.remove(0)
}

/// A temporary folder for one test, removed at its end.
struct Folder(std::path::PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &[u8])]) -> Self {
        let path = std::env::temp_dir().join(format!("luxel-obj-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        for (name, bytes) in files {
            std::fs::write(path.join(name), bytes).unwrap();
        }
        Self(path)
    }

    fn load(&self, text: &str) -> Loaded {
        read(text.as_bytes(), "stem", Some(&self.0), &Limits::default()).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn objects_are_o_else_g_else_the_stem() {
    let faces = "f 1 2 3\no a\nf 1 2 3\ng b\nf 1 2 3\no a\nf 1 2 3\no empty\no c d\nf 1 3 4\n";
    let scene_of_o = scene(&quad(faces));
    assert_eq!(names(&scene_of_o), ["stem", "a", "c d"]);
    assert_eq!(scene_of_o.meshes[1].triangles.len(), 3);
    let scene_of_g = scene(&quad("g x\nf 1 2 3\ng y\nf 1 2 3\ng x\nf 1 2 3\n"));
    assert_eq!(names(&scene_of_g), ["x", "y", "x"]);
    assert_eq!(names(&scene(&quad("f 1 2 3\n"))), ["stem"]);
}

#[test]
fn indices_count_from_one_or_backwards_across_joined_lines() {
    let mesh = one("f -4 \\\r\n -3 \\\n -2\r\nf\t1 3 4\n");
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(mesh.polygons, None);
}

#[test]
fn positions_are_shared_where_attributes_are_split() {
    let mesh = one("vt 0 0\nvt 1 0.25\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n");
    assert_eq!(mesh.positions.len(), 4);
    assert_eq!(mesh.attribute_corners(), [[0, 1, 2], [3, 2, 4]]);
    assert_eq!(mesh.uvs[0][1], [1.0, 0.75]);
    assert_eq!(mesh.normals, vec![[0.0, 0.0, 1.0]; 5]);
    let same = one("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    assert_eq!(same.attribute_corners, None);
    assert_eq!(same.polygons, Some(vec![0, 0]));
}

#[test]
fn smoothing_groups_are_kept_where_a_file_has_them() {
    assert_eq!(one("f 1 2 3\n").smoothing_groups, None);
    let mesh = one("f 1 2 3\ns 7\nf 1 2 3\ns off\nf 1 2 3\n");
    assert_eq!(mesh.smoothing_groups, Some(vec![0, 7, 0]));
}

#[test]
fn concave_polygons_keep_their_area() {
    let scene = scene("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nf 4 1 2 3\n");
    let mesh = &scene.meshes[0];
    let area = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| mesh.position(corner));
        (b - a).cross(c - a).z / 2.0
    };
    assert!(mesh.triangles.iter().all(|corners| area(corners) > 0.0));
    assert_eq!(mesh.triangles.iter().map(area).sum::<f64>(), 4.0);
}

#[test]
fn colours_lines_and_points_are_read() {
    let scene = scene("v 0 0 0 1 0 0\nv 1 0 0 1.0 0 1 0\nv 0 1 0\nf 1 2 3\nl 1 2 3\np 3 1\n");
    let mesh = &scene.meshes[0];
    assert_eq!(mesh.colors, [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [1.0; 4]]);
    assert_eq!(scene.materials[0].constants.diffuse, [1.0; 3]);
    assert_eq!(mesh.lines[0].segments, [[0, 1], [1, 2]]);
    assert_eq!(mesh.points[0].indices, [2, 0]);
}

#[test]
fn errors_name_their_line() {
    let error = |rest: &str| load(&quad(rest)).unwrap_err();
    assert_eq!(error("f 1 2 5\n").to_string(), "<input>:5: vertex 5 doesn't exist: there are 4");
    assert_eq!(error("f 1 2 -5\n").to_string(), "<input>:5: vertex -5 doesn't exist: there are 4");
    assert_eq!(error("f 1 2 0\n").to_string(), "<input>:5: vertex 0 doesn't exist: there are 4");
    assert!(matches!(error("f 1/1 2 3\n").kind, ErrorKind::OutOfRange { index: 1, count: 0, .. }));
    assert_eq!(error("f 1 2 x\n").place, Place::Line(5));
    assert_eq!(error("v 1 2\n").place, Place::Line(5));
    assert_eq!(error("v 1 2 z\n").place, Place::Line(5));
    assert!(load("\u{1}\u{2} nothing\n<html>\n").is_err());
}

#[test]
fn faces_may_come_before_their_vertices() {
    assert_eq!(scene(&format!("f 1 2 3\n{QUAD}")).triangle_count(), 1);
}

#[test]
fn faces_with_infinite_corners_are_left_out_and_counted() {
    let loaded =
        load(&quad("v nan 0 0\nv 1e300 0 0\nf 1 2 5\nf 1 2 3 6\nf 1 2 3\nf 1 2\n")).unwrap();
    assert_eq!(loaded.scene.triangle_count(), 1);
    assert_eq!(
        loaded.warnings,
        [
            "2 faces with a corner that is not finite were left out",
            "faces with fewer than three corners were left out: 1",
        ]
    );
}

#[test]
fn the_vertices_of_a_file_without_elements_are_points() {
    let loaded = load(QUAD).unwrap();
    assert_eq!(loaded.scene.meshes[0].points[0].indices, [0, 1, 2, 3]);
    assert!(loaded.warnings.is_empty());
    assert!(load("# nothing\n").unwrap().scene.nodes.is_empty());
}

#[test]
fn mtl_is_the_equation_term_by_term() {
    let mtl =
        b"newmtl shiny\t \r\nKa .1 .2 .3\r\nKd 0.5\r\nKs 1 1 0\r\nNs 10\r\nKe 2 0 0\r\nd 0.25\r\n\
        newmtl matte\nKd 1 0 0\nillum 1\nnewmtl flat\nillum 0\nKd 0 1 0\nnewmtl plain\nKd 0 0 1\n\
        newmtl meshlab\nKs 1 1 1\nNs 0\nTr 1\nnewmtl glass\nTr 0.75\n";
    let folder = Folder::new("terms", &[("a b.mtl", mtl)]);
    let uses = ["shiny", "matte", "flat", "plain", "meshlab", "glass", "other"]
        .map(|name| format!("usemtl {name}\nf 1 2 3\n"))
        .concat();
    let loaded = folder.load(&quad(&format!("mtllib a b.mtl\n{uses}")));
    let materials = &loaded.scene.materials;
    let [shiny, matte, flat, plain, meshlab, glass, other] = &materials[..] else {
        panic!("{materials:?}")
    };
    assert_eq!(shiny.name, "shiny");
    assert_eq!(shiny.constants.ambient, Some([0.1, 0.2, 0.3]));
    assert_eq!(shiny.constants.diffuse, [0.5; 3]);
    assert_eq!((shiny.constants.specular, shiny.constants.k_s), ([1.0, 1.0, 0.0], 1.0));
    assert_eq!((shiny.constants.shininess, shiny.constants.emission), (10.0, [2.0, 0.0, 0.0]));
    assert_eq!((shiny.opacity, shiny.alpha_mode), (0.25, AlphaMode::Blend));
    assert_eq!((&matte.constants.reflection, matte.constants.k_s), (&Reflection::Lambert, 0.0));
    assert_eq!(flat.constants.reflection, Reflection::Unlit);
    assert_eq!((plain.constants.k_s, plain.constants.ambient), (0.2, None));
    assert_eq!((meshlab.constants.k_s, meshlab.opacity), (0.0, 1.0));
    assert_eq!(glass.opacity, 0.25);
    assert_eq!(other.constants, SceneMaterial::default().constants);
    assert_eq!(loaded.warnings, ["no library has the material `other`: a default is used"]);
    assert_eq!(loaded.scene.meshes[0].parts.len(), 7);
}

fn png(texels: &[[u8; 4]]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, texels.len() as u32, 1);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(texels.as_flattened()).unwrap();
    drop(writer);
    bytes
}

#[test]
fn textures_are_found_with_spaces_options_and_backslashes() {
    let holes = png(&[[9, 9, 9, 0], [9, 9, 9, 255]]);
    let folder = Folder::new(
        "textures",
        &[
            (
                "m.mtl",
                b"newmtl a\nKa 1 1 1\nmap_Kd -s 2 3 1 -o 0.5 0.25 -clamp on .\\my picture.png\n",
            ),
            ("my picture.png", &holes),
        ],
    );
    let loaded = folder.load(&quad("mtllib none.mtl m.mtl\nusemtl a\nf 1 2 3\n"));
    assert_eq!(loaded.warnings.len(), 1, "{:?}", loaded.warnings);
    let material = &loaded.scene.materials[0];
    let used = material.base_color.as_ref().unwrap();
    // v up: 3 v + 0.25; v down: 1 - (3 (1 - v) + 0.25) = 3 v - 2.25.
    assert_eq!(used.transform, [2.0, 0.0, 0.5, 0.0, 3.0, -2.25]);
    assert_eq!(material.ambient.as_ref(), Some(used));
    assert_eq!(material.constants.diffuse, [1.0; 3]);
    assert_eq!(material.alpha_mode, AlphaMode::Mask { cutoff: 0.5 });
    assert_eq!(loaded.scene.textures[0].image.levels[0].width, 2);
}

#[test]
fn textures_that_are_missing_or_damaged_get_placeholders() {
    let mtl = b"newmtl a\nmap_Kd ../up.png\nmap_Ks C:\\wood.png\nmap_d gone.png\nbump m.mtl\n";
    let folder = Folder::new("outside", &[("m.mtl", mtl)]);
    let loaded = folder.load(&quad("mtllib m.mtl\nusemtl a\nf 1 2 3\n"));
    assert_eq!(loaded.scene.textures.len(), 4);
    assert_eq!(loaded.warnings.len(), 4, "{:?}", loaded.warnings);
    assert!(loaded.warnings[0].message.contains("leads out"), "{:?}", loaded.warnings);
    assert!(load(&quad("mtllib m.mtl\nusemtl a\nf 1 2 3\n")).unwrap().warnings.len() == 2);
    let loaded = folder.load(&quad("mtllib ../m.mtl\nf 1 2 3\n"));
    assert!(loaded.warnings[0].message.contains("leads out"), "{:?}", loaded.warnings);
}

proptest! {
    #[test]
    fn a_written_mesh_is_read_back(
        positions in prop::collection::vec([-1e3_f32..1e3, -1.0..1.0, -1e-3..1e-3], 5..30),
        faces in prop::collection::vec(prop::collection::vec(0..5_u32, 3..6), 1..30),
        backwards in any::<bool>(),
    ) {
        use std::fmt::Write;
        let mut text = String::new();
        for [x, y, z] in &positions {
            writeln!(text, "v {x} {y:e} {z}").unwrap();
        }
        for face in &faces {
            text.push('f');
            for &corner in face {
                let shift = if backwards { -(positions.len() as i64) } else { 1 };
                write!(text, " {}", i64::from(corner) + shift).unwrap();
            }
            text.push('\n');
        }
        let mesh = &scene(&text).meshes[0];
        let expected: usize = faces.iter().map(|face| face.len() - 2).sum();
        prop_assert_eq!(mesh.triangles.len(), expected);
        for (index, face) in faces.iter().enumerate().filter(|(_, face)| face.len() == 3) {
            let triangle = mesh.polygons.as_ref().map_or(Some(index), |polygons| {
                polygons.iter().position(|&polygon| polygon == index as u32)
            });
            let corners = mesh.triangles[triangle.unwrap()];
            for (corner, &original) in corners.iter().zip(face) {
                let position = mesh.position(*corner).as_vec3().to_array();
                for axis in 0..3 {
                    // Positions are relative to an origin: as exact as the largest coordinate.
                    let sizes = positions.iter().map(|position| position[axis].abs());
                    let error = (position[axis] - positions[original as usize][axis]).abs();
                    prop_assert!(error <= f32::EPSILON * sizes.fold(0.0, f32::max), "{error}");
                }
            }
        }
    }

    #[test]
    fn no_text_makes_it_panic(
        words in prop::collection::vec(
            prop::sample::select(vec![
                "v", "vt", "vn", "f", "l", "p", "o", "g", "s", "usemtl", "mtllib", "\n", "\n", "\\\n",
                "\r", "#", "1", "2", "-1", "0", "1/1/1", "2//1", "1/", "/", "nan", "1e999", "x",
                "newmtl", "Kd", "Ks", "map_Kd", "-s", "-o", "off", "999999999999", "\u{0}",
            ]),
            0..120,
        )
    ) {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n{}", words.join(" "));
        let _ = load(&text);
        mtl::read(text.replace("v 0", "newmtl").as_bytes(), "x.mtl", &mut Warnings::default(), &mut |_, _| {});
    }
}

#[cfg(unix)]
#[test]
fn references_to_what_is_no_regular_file_or_leads_out_are_errors_and_never_block() {
    let secret = Folder::new("secret", &[("secret.mtl", b"newmtl m\nKd 1 0 0\n")]);
    let folder = Folder::new("references", &[]);
    let at = |name: &str| folder.0.join(name);
    let made = std::process::Command::new("mkfifo").arg(at("pipe.mtl")).status();
    assert!(made.is_ok_and(|status| status.success()), "mkfifo");
    std::fs::create_dir(at("folder.mtl")).unwrap();
    std::os::unix::fs::symlink("/dev/zero", at("device.mtl")).unwrap();
    std::os::unix::fs::symlink(secret.0.join("secret.mtl"), at("outside.mtl")).unwrap();
    std::fs::write(at("own.mtl"), "newmtl m\nKd 0 1 0\n").unwrap();
    std::os::unix::fs::symlink("own.mtl", at("inside.mtl")).unwrap();
    std::os::unix::fs::symlink("circle.mtl", at("circle.mtl")).unwrap();
    std::os::unix::fs::symlink("nothing.mtl", at("dangling.mtl")).unwrap();
    let above = format!("../{}/secret.mtl", secret.0.file_name().unwrap().to_str().unwrap());
    let absolute = secret.0.join("secret.mtl");
    let error = |text: &str| {
        let read = read(text.as_bytes(), "m", Some(&folder.0), &Limits::default());
        read.expect_err(text).to_string()
    };
    for (name, what) in [
        ("pipe.mtl", "it is not a regular file"),
        ("folder.mtl", "it is not a regular file"),
        ("none.mtl folder.mtl", "it is not a regular file"),
        ("device.mtl", "a link leads out of the model's folder"),
        ("outside.mtl", "a link leads out of the model's folder"),
        ("circle.mtl", "is not read: "),
        (&above, "it leads out of the model's folder"),
        (absolute.to_str().unwrap(), "it leads out of the model's folder"),
        ("/dev/zero", "it leads out of the model's folder"),
    ] {
        let own = name.rsplit(' ').next().unwrap();
        let message = error(&quad(&format!("mtllib {name}\nusemtl m\nf 1 2 3\n")));
        assert!(message.contains(what) && message.contains(own), "{name}: {message}");
        if !name.contains(' ') {
            std::fs::write(at("textured.mtl"), format!("newmtl m\nmap_Kd {name}\n")).unwrap();
            let message = error(&quad("mtllib textured.mtl\nusemtl m\nf 1 2 3\n"));
            assert!(message.contains(what) && message.contains(own), "{name}: {message}");
        }
    }
    let loaded = folder.load(&quad("mtllib dangling.mtl ../nothing.mtl\nf 1 2 3\n"));
    assert_eq!(loaded.warnings.len(), 2, "{:?}", loaded.warnings);
    let loaded = folder.load(&quad("mtllib inside.mtl\nusemtl m\nf 1 2 3\n"));
    assert_eq!(loaded.scene.materials[0].constants.diffuse, [0.0, 1.0, 0.0]);
}

#[test]
fn a_library_in_utf16_is_named_as_such() {
    let text: Vec<u8> = "newmtl m\nKd 1 0 0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let folder = Folder::new("utf16", &[("a.mtl", &text)]);
    let loaded = folder.load(&quad("mtllib a.mtl\nusemtl m\nf 1 2 3\n"));
    assert!(loaded.warnings[0].message.contains("UTF-16"), "{:?}", loaded.warnings);
}

#[test]
fn a_library_is_read_once_however_often_it_is_named() {
    let unused = "newmtl other\nKd nothing\n".repeat(3);
    let text = format!("newmtl m\nKd 1 0 0\n{unused}");
    let folder = Folder::new("named-often", &[("a.mtl", text.as_bytes())]);
    let lines = "mtllib a.mtl\nmtllib a.mtl a.mtl\n".repeat(100);
    let loaded = folder.load(&quad(&format!("{lines}usemtl m\nf 1 2 3\n")));
    assert_eq!(loaded.scene.materials.len(), 1);
    assert_eq!(loaded.scene.materials[0].constants.diffuse, [1.0, 0.0, 0.0]);
    // One for each line of the library that isn't valid.
    assert!(loaded.warnings.len() <= 3, "{:?}", loaded.warnings);
}

#[test]
fn a_thousand_small_groups_share_a_mesh_and_stay_objects() {
    // Triangles, quads with texture coordinates, and a group far from the world's origin.
    let mut text = quad("v 1e6 0 0\nv 1000001 0 0\nv 1e6 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n");
    let elements =
        ["f 1 2 3", "f 2 3 4 1", "f 1/1 2/2 3/3", "f 5 6 7", "usemtl red\nf 1 3 4", "l 1 2"];
    for number in 0..1000 {
        let block = 20 * elements.len();
        let _ = writeln!(text, "g part{number}\n{}", elements[number % block / 20]);
    }
    let joined = scene(&text);
    assert!(joined.meshes.len() < 200, "{}", joined.meshes.len());
    let names: Vec<_> = (0..1000).map(|number| format!("part{number}")).collect();
    assert_eq!(names, self::names(&joined));
    for (number, object) in joined.objects().iter().enumerate() {
        let element = elements[number % (20 * elements.len()) / 20];
        let head = text.split("g part").next().unwrap();
        let mut alone = scene(&format!("{head}{element}")).meshes.remove(0);
        let mut mesh = joined.mesh_of(object).into_owned();
        // Materials are numbered by their first use in the file.
        mesh.parts.iter_mut().for_each(|part| part.material = MaterialId(0));
        alone.parts.iter_mut().for_each(|part| part.material = MaterialId(0));
        mesh.lines.iter_mut().for_each(|lines| lines.material = MaterialId(0));
        assert_eq!(mesh, alone, "{number}");
    }
}
