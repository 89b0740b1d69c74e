use super::*;
use crate::{Error, ErrorKind, Place};
use glam::{DMat4, DVec3};
use luxel_lighting::{Environment, FogLaw, LightKind, REFLECTION_MODELS, Reflection};
use luxel_scene::{AlphaMode, EnvironmentChoice, Lens, Placement};
use proptest::prelude::*;

fn load_in(folder: Option<&Path>, rest: &str) -> Result<Loaded, Error> {
    let text = format!("format = \"luxel-scene\"\nversion = 1\n{rest}");
    read(text.as_bytes(), folder, &Limits::default())
}

#[track_caller]
fn scene(rest: &str) -> Scene {
    load_in(None, rest).unwrap().scene
}

#[track_caller]
fn refused(rest: &str) -> String {
    load_in(None, rest).err().unwrap().to_string()
}

/// A temporary folder for one test, removed at its end.
struct Folder(std::path::PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("luxel-toml-{}-{name}", std::process::id()));
        std::fs::create_dir_all(path.join("parts")).unwrap();
        let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        let two = format!("{triangle}o left\nusemtl a\nf 1 2 3\no right\nusemtl b\nf 1 2 3\n");
        std::fs::write(path.join("parts/two.obj"), two).unwrap();
        let bad = "v 0 0 0\nf 1 2 3\n";
        std::fs::write(path.join("bad.obj"), bad).unwrap();
        Self(path)
    }

    fn load(&self, rest: &str) -> Result<Loaded, Error> {
        load_in(Some(&self.0), rest)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn every_key_accepts_its_example_and_has_an_effect() {
    let needed = |section: &Section, but: &str| {
        let keys = section.keys.iter().filter(|key| key.required && key.name != but);
        keys.map(|key| format!("{} = {}\n", key.name, key.example)).collect::<String>()
    };
    // The models and materials that the examples refer to.
    let around = "[[models]]\nsource = \"demo:teapot\"\nname = \"pot\"\n\
                  [[materials]]\nname = \"glaze\"\n";
    for section in sections() {
        for key in section.keys {
            let owner = REFLECTION_MODELS
                .iter()
                .find(|model| model.own.iter().any(|own| own.parameter.name == key.name));
            let owner = owner.map(|model| format!("reflection = \"{}\"\n", model.name));
            // A key changes the scene, or can't be left out, or is refused with its neighbours.
            let with = |value: &str| {
                let kind = match (section.name, key.name) {
                    ("lights", "color") => "kind = \"ambient\"\n",
                    ("lights", "cutoff" | "exponent") => {
                        "kind = \"spot\"\npos = [0, 0, 0]\ndir = [1, 0, 0]\n"
                    }
                    ("lights", "inner") => {
                        "kind = \"spot\"\npos = [0, 0, 0]\ndir = [1, 0, 0]\ncutoff = 30\n"
                    }
                    ("lights", "angle") => "kind = \"directional\"\ndir = [0, -1, 0]\n",
                    ("lights", "dir") => "kind = \"directional\"\n",
                    ("lights", "pos") => "kind = \"point\"\n",
                    ("lights", "kind") => "pos = [0, 0, 0]\n",
                    ("lights", _) => "kind = \"point\"\npos = [0, 0, 0]\n",
                    ("fog", "near") => "far = 20\n",
                    ("fog", "far") => "near = 4\n",
                    ("fog", "law") => "density = 1\n",
                    ("fog", "density") => "law = \"exp\"\n",
                    ("fog", _) => "near = 4\nfar = 20\n",
                    ("cameras", "eye") => "target = [0, 0, 0]\n",
                    ("cameras", "view-matrix" | "node") => "",
                    ("cameras", "target") => "eye = [9, 9, 9]\n",
                    ("cameras", _) => "eye = [9, 9, 9]\ntarget = [0, 0, 0]\n",
                    _ => owner.as_deref().unwrap_or_default(),
                };
                let rest =
                    needed(section, if section.name == "lights" { "kind" } else { key.name });
                let value = if value.is_empty() {
                    String::new()
                } else {
                    format!("{} = {value}\n", key.name)
                };
                let name = match (section.name, key.name) {
                    ("", "format" | "version") => return format!("\n{around}"),
                    ("", _) => return format!("{value}{around}"),
                    ("materials", "name") => {
                        return format!("{around}\n[[materials]]\nname = \"other\"\n");
                    }
                    ("materials", _) => {
                        return format!(
                            "{around}{kind}{value}[[overrides]]\nmaterial = \"glaze\"\n"
                        );
                    }
                    (name, _) if section.repeated => format!("[[{name}]]"),
                    (name, _) => format!("[{name}]"),
                };
                format!("{around}{name}\n{kind}{rest}{value}")
            };
            let text = with(key.example);
            let error = load_in(None, &text).err().map(|error| error.to_string());
            assert_eq!(error, None, "{} {}\n{text}", section.name, key.name);
            let wrong = load_in(None, &with("[[1]]"));
            let is_header = matches!(key.name, "format" | "version");
            let is_name = (section.name, key.name) == ("materials", "name");
            assert!(wrong.is_err() || is_header || is_name, "{} {}", section.name, key.name);
        }
    }
}

#[test]
fn each_model_gets_its_own_node_in_order() {
    let scene = scene(
        "[[models]]\nsource = \"demo:teapot\"\n\
         [[models]]\nsource = \"demo:teapot\"\nname = \"small\"\nparent = \"teapot/lid\"\n\
         scale = 0.5\nrotate = { axis = \"Z\", degrees = 90 }\ntranslate = [1, 2, 3]\n",
    );
    let objects = scene.objects();
    assert_eq!(objects.len(), 8);
    assert_eq!(scene.path(objects[0].node), ["teapot", "teapot", "body"]);
    let small = scene.path(objects[4].node);
    assert_eq!(small, ["teapot", "teapot", "lid", "small", "teapot", "body"]);
    assert_eq!(objects[0].mesh, objects[4].mesh, "a model used twice is read once");
    let placed =
        objects[4].world_from_mesh.matrix() * objects[0].world_from_mesh.matrix().inverse();
    // Scale, then rotate, then translate: (1, 0, 0) becomes (0, 0.5, 0), then moves.
    let at = placed.transform_point3(DVec3::X);
    assert!(at.abs_diff_eq(DVec3::new(1.0, 2.5, 3.0), 1e-12), "{at}");
}

#[test]
fn a_matrix_is_read_column_by_column() {
    let scene = scene(
        "[[models]]\nsource = \"demo:teapot\"\n\
         matrix = [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1]\n",
    );
    let expected = DMat4::from_translation(DVec3::new(5.0, 6.0, 7.0))
        * DMat4::from_rotation_z(std::f64::consts::FRAC_PI_2)
        * DMat4::from_scale(DVec3::splat(2.0));
    assert!(scene.nodes[0].parent_from_node.matrix().abs_diff_eq(expected, 1e-12));
}

#[test]
fn models_are_read_only_from_the_folder_of_the_scene_file() {
    let folder = Folder::new("beside");
    let scene = folder.load("[[models]]\nsource = \"parts/two.obj\"\n").unwrap().scene;
    let names: Vec<_> = scene.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["two", "left", "right"]);
    for (source, expected) in [
        ("../parts/two.obj", ":4:10: `../parts/two.obj` is not read: it leads out"),
        ("/etc/passwd", "leads out"),
        ("C:/x.obj", "leads out"),
        ("missing.obj", "missing.obj: "),
        ("other.toml", "can't contain scene files"),
        ("two.xyz", ":4:10: "),
        ("demo:nothing", "there is no demo `nothing`: use teapot"),
    ] {
        let error = folder.load(&format!("[[models]]\nsource = \"{source}\"\n")).unwrap_err();
        assert!(error.to_string().contains(expected), "{source}: {error}");
    }
    let nested = folder.load("[[models]]\nsource = \"bad.obj\"\n").unwrap_err();
    assert!(nested.file.unwrap().ends_with("bad.obj"), "the file that is wrong is the model");
    assert!(matches!(nested.place, Place::Line(2)));
    let from_nowhere = refused("[[models]]\nsource = \"x.obj\"\n");
    assert!(from_nowhere.contains("standard input"), "{from_nowhere}");
}

#[test]
fn lights_have_the_fields_of_the_flag() {
    let scene = scene(
        "[[models]]\nsource = \"demo:cornell\"\nname = \"room\"\n\
         [[lights]]\nkind = \"point\"\npos = [1, 2, 3]\ndiffuse = \"3,0,0\"\n\
         [[lights]]\nname = \"a:b\"\nkind = \"directional\"\nnode = \"room\"\ndir = [0, -2, 0]\n",
    );
    let flag = crate::values::light("point:pos=1,2,3:diffuse=3,0,0").unwrap().named(0);
    assert_eq!(scene.lights[0], flag);
    assert_eq!(scene.lights[1].name, "a:b");
    assert_eq!(scene.lights[1].light.kind, LightKind::Directional);
    assert!(matches!(scene.lights[1].placement, Placement::Node(node) if node.index() == 0));
    assert_eq!(scene.lights.len(), 2, "the room's own light is off");
}

#[test]
fn lights_and_cameras_of_a_model_move_with_it() {
    let with = |rest: &str| {
        scene(&format!("[[models]]\nsource = \"demo:cornell\"\ntranslate = [9, 0, 0]\n{rest}"))
    };
    let room = luxel_scene::demos::demo("cornell").unwrap();
    let moved = with("");
    assert_eq!(moved.lights.len(), room.lights.len());
    assert!(moved.lights.iter().all(|light| matches!(light.placement, Placement::Node(_))));
    assert_eq!(moved.cameras.len(), 1);
    let bare = with("lights = false\ncameras = false\n");
    assert!(bare.lights.is_empty() && bare.cameras.is_empty());
}

#[test]
fn surroundings_read_as_on_the_command_line() {
    let scene = scene(
        "up = \"Z\"\nambient = [0.1, 0.2, 0.3]\nenvironment = \"studio\"\n\
         background = [0.5, 0.5, 0.5]\n[fog]\nnear = 1\nfar = 5\nback = 0.25\n",
    );
    assert_eq!(scene.up, DVec3::Z);
    assert_eq!(scene.ambient, Some([0.1, 0.2, 0.3]));
    let studio = Environment::Studio { up: [0.0, 0.0, 1.0] };
    assert_eq!(scene.environment, Some(EnvironmentChoice::Always(studio)));
    assert_eq!(scene.background, Some([0.5, 0.5, 0.5, 1.0].into()));
    let law = FogLaw::DepthCue { near: 1.0, far: 5.0, front: 1.0, back: 0.25 };
    assert_eq!(scene.fog.unwrap().law, law);
}

#[test]
fn cameras_have_the_position_of_the_file() {
    let scene = scene(
        "[[models]]\nsource = \"demo:teapot\"\nname = \"pot\"\n\
         [[cameras]]\nname = \"a\"\neye = [0, 0, 5]\ntarget = [0, 0, 0]\northo = 3\n\
         [[cameras]]\nname = \"b\"\nnode = \"pot\"\n",
    );
    let [a, b] = &scene.cameras[..] else { panic!("two cameras") };
    assert_eq!(a.lens, Lens::Orthographic { height: 3.0 });
    assert!(a.view_from_node.abs_diff_eq(DMat4::from_translation(DVec3::Z * -5.0), 1e-15));
    assert_eq!((b.view_from_node, b.node.map(|node| node.0)), (DMat4::IDENTITY, Some(0)));
}

#[test]
fn materials_change_only_the_given_keys_of_the_matching_surfaces() {
    let folder = Folder::new("materials");
    let scene = folder
        .load(
            "[material]\nka = 0.5\n\
             [[models]]\nsource = \"parts/two.obj\"\nname = \"one\"\n\
             [[models]]\nsource = \"parts/two.obj\"\nname = \"other\"\nmaterial = \"matte\"\n\
             [[materials]]\nname = \"matte\"\nks = 0\n\
             [[materials]]\nname = \"red\"\ncolor = [1, 0, 0]\nopacity = 0.5\n\
             [[overrides]]\nmodel = \"other\"\nobject = \"right\"\nmaterial = \"red\"\n",
        )
        .unwrap()
        .scene;
    let objects = scene.objects();
    let of = |object: usize| {
        let part = scene.meshes[objects[object].mesh.index()].parts[0];
        &scene.materials[part.material.index()]
    };
    for object in 0..4 {
        assert_eq!(of(object).constants.k_a, 0.5, "[material] is for all");
    }
    assert!(of(0).constants.k_s > 0.0 && of(1).constants.k_s > 0.0, "the first stays glossy");
    assert_eq!((of(2).constants.k_s, of(3).constants.k_s), (0.0, 0.0));
    assert_ne!(of(2).constants.diffuse, [1.0, 0.0, 0.0]);
    assert_eq!(of(3).constants.diffuse, [1.0, 0.0, 0.0], "on top of the model's");
    assert_eq!(of(3).alpha_mode, AlphaMode::Blend);
    assert_eq!(of(3).name, "red");
}

#[test]
fn an_override_applies_below_its_object_and_only_to_its_surface() {
    let scene = scene(
        "[[models]]\nsource = \"demo:plane\"\n[[materials]]\nname = \"m\"\nreflection = \"phong\"\n\
         [[overrides]]\nobject = \"stack\"\nsurface = \"torus\"\nmaterial = \"m\"\n",
    );
    for object in scene.objects() {
        let name = scene.nodes[object.node.index()].name.as_str();
        let part = scene.meshes[object.mesh.index()].parts[0];
        let reflection = &scene.materials[part.material.index()].constants.reflection;
        assert_eq!(*reflection == Reflection::Phong, name == "torus", "{name}");
    }
}

#[test]
fn errors_have_line_column_and_suggestion() {
    let teapot = "[[models]]\nsource = \"demo:teapot\"\n";
    for (rest, expected) in [
        ("lihgts = 1\n", ":3:1: `lihgts` is unknown here: did you mean `lights`?"),
        ("[models]\nsource = \"demo:teapot\"\n", ":3:1: `models` is a table: write [[models]]"),
        ("[[models]]\nname = \"x\"\n", ":3:1: `source` is missing"),
        ("[[models]]\nsource = 5\n", ":4:10: source: use a quoted string"),
        ("[[lights]]\nkind = \"sun\"\n", ":4:8: `sun` is not a kind of light"),
        ("[[lights]]\nkind = \"point\"\n", "needs pos"),
        ("[[lights]]\nkind = \"point\"\npos = [1, 2]\n", ":5:7: pos: expected 3 numbers"),
        ("[[lights]]\nkind = \"point\"\npos = [1, 2, 3]\nnode = \"x\"\n", "there is no node `x`"),
        (
            "[[lights]]\nkind = \"point\"\npos = [1,2,3]\nname = \"x\"\n\
          [[lights]]\nkind = \"point\"\npos = [1,2,3]\nname = \"x\"\n",
            "two lights have the name `x`",
        ),
        ("ambient = [1, 2, nan]\n", ":3:11: ambient: `nan` is not a finite number"),
        ("ambient = [[1, 2, 3]]\n", "found a list"),
        ("up = 1979-05-27\n", "expected a number or a string, found a date"),
        ("[fog]\nnear = 3\n", ":3:1: it needs far=Z"),
        ("[fog]\nlaw = \"exp\"\ndensity = -1\n", ":5:11: density: it must not be below 0"),
        ("[fog]\nnear = 3\nfar = 2\n", ":3:1: near must be less than far"),
        ("[[cameras]]\nname = \"c\"\n", "needs eye and target"),
        (
            "[[cameras]]\nname = \"c\"\neye=[1,1,1]\ntarget=[1,1,1]\n",
            "eye and target are the same point",
        ),
        ("[[cameras]]\nname = \"c\"\neye=[1,1,1]\ntarget=[0,1,1]\nfov=9\northo=1\n", "exclude"),
        ("[[overrides]]\nmaterial = \"m\"\n", "add it under [[materials]]"),
        ("a = 1\na = 2\n", ":4:1: "),
        ("a = \n", ":3:5: "),
    ] {
        let message = refused(rest);
        assert!(message.contains(expected), "{rest}: {message}");
    }
    for (rest, expected) in [
        ("scale = 0\n", ":5:9: scale: the scale must not be 0"),
        ("rotate = 30\n", ":5:10: rotate: use { axis = "),
        ("rotate = { axis = \"Y\", angle = 1 }\n", "`angle` is unknown here"),
        ("scale = 2\nmatrix = [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]\n", "exclude each other"),
        ("matrix = [1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1]\n", "must be invertible"),
        (
            "[[overrides]]\nmaterial = \"m\"\n[[materials]]\nname = \"m\"\n[[overrides]]\n\
          material = \"m\"\nobject = \"lidd\"\n",
            "there is no node `lidd`: did you mean `lid`?",
        ),
        (
            "[[materials]]\nname = \"m\"\n[[overrides]]\nmaterial = \"m\"\nsurface = \"glase\"\n",
            "did you mean `glaze`?",
        ),
        (
            "[[models]]\nsource = \"demo:teapot\"\n[[models]]\nsource = \"demo:teapot\"\n\
          parent = \"lid\"\n",
            "add the name of its parent",
        ),
    ] {
        let message = refused(&format!("{teapot}{rest}"));
        assert!(message.contains(expected), "{rest}: {message}");
    }
}

#[test]
fn columns_are_counted_in_characters() {
    assert!(refused("\"schön\" = 1 \n").contains(":3:1: "));
    let message = refused("ambient = [\"ä\", \"ö\", 1, []]\n");
    assert!(message.contains(":3:11: "), "{message}");
    let message = refused("x = \"äöü\" 1\n");
    assert!(message.contains(":3:11: "), "{message}");
}

#[test]
fn other_files_and_other_versions_are_refused() {
    for (text, expected) in [
        ("", "this is not a scene file"),
        ("[package]\nname = \"x\"\n", "this is not a scene file"),
        ("format = \"other\"\nversion = 1\n", ":1:10: a scene file begins with format"),
        ("format = \"luxel-scene\"\n", "the version is missing"),
        ("format = \"luxel-scene\"\nversion = 2\n", ":2:11: version 2 is not supported"),
        ("format = \"luxel-scene\"\nversion = \"1\"\n", ":2:11: "),
    ] {
        let error = read(text.as_bytes(), None, &Limits::default()).unwrap_err().to_string();
        assert!(error.contains(expected), "{text}: {error}");
    }
    let error = read(b"format = \"\xff\"", None, &Limits::default()).unwrap_err();
    assert_eq!(error.place, Place::Byte(10));
}

#[test]
fn memory_is_bounded_over_all_models() {
    let text = "format = \"luxel-scene\"\nversion = 1\n[[models]]\nsource = \"demo:blob\"\n";
    let limits = Limits { max_memory: 10 << 20, ..Limits::default() };
    let error = read(text.as_bytes(), None, &limits).err().unwrap();
    assert!(matches!(error.kind, ErrorKind::TooLarge { .. }), "{error}");
    assert!(matches!(error.place, Place::LineColumn(4, 10)));
}

#[test]
fn deep_nesting_is_an_error() {
    let deep = format!("x = {}{}\n", "[".repeat(100_000), "]".repeat(100_000));
    assert!(load_in(None, &deep).is_err());
    let dotted = format!("{}x = 1\n", "a.".repeat(100_000));
    assert!(load_in(None, &dotted).is_err());
}

proptest! {
    #[test]
    fn any_text_ends_in_a_scene_or_an_error(text in "[a-z=\\[\\]\"0-9 .\n]{0,200}") {
        let _ = load_in(None, &text);
        let _ = scene_settings(text.as_bytes(), &Limits::default());
    }

    #[test]
    fn numbers_arrive_as_they_are_written(x in any::<f32>().prop_filter("finite", |x| x.is_finite())) {
        let scene = scene(&format!("ambient = [{x:?}, 0, 0]\n"));
        prop_assert_eq!(scene.ambient, Some([x, 0.0, 0.0]));
    }
}

#[cfg(feature = "exr")]
#[test]
fn a_picture_of_the_environment_lies_beside_the_scene_file_and_is_turned() {
    let folder = std::env::temp_dir().join(format!("luxel-environment-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("sky")).unwrap();
    let picture = include_bytes!("../../tests/environments/zip-half.exr");
    std::fs::write(folder.join("sky/noon.exr"), picture).unwrap();
    let with = |keys: &str| {
        let text = format!(
            "format = \"luxel-scene\"\nversion = 1\n{keys}\n[[models]]\nsource = \"demo:plane\"\n"
        );
        read(text.as_bytes(), Some(&folder), &Limits::default())
    };
    let scene = with("environment = \"sky/noon.exr\"\nenvironment_rotation = 90").unwrap().scene;
    let choice = scene.environment.unwrap();
    let map = choice.map().unwrap();
    assert_eq!(map.rotation_degrees(), 90.0);
    assert!(map.map().name().ends_with("noon.exr"));
    for (name, expected) in [
        ("sky/dusk.exr", "dusk.exr"),
        ("../noon.exr", "leads out of the model's folder"),
        ("/noon.exr", "leads out of the model's folder"),
    ] {
        let error = with(&format!("environment = \"{name}\"")).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
