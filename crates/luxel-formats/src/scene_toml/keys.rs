//! The sections and keys of scene files. Readers, the JSON schema and the documentation use this
//! table. Parameters of reflection and kinds of light come from the tables of `luxel-lighting`.

use crate::values::reflection_choices;
use luxel_lighting::{
    K_A, K_D, K_S, LIGHT_KINDS, LightKindDescription, METALLIC, Parameter, ROUGHNESS, SHININESS,
    own_parameters,
};
use luxel_scene::NamedEnvironment;
use std::sync::LazyLock;

/// A table of a scene file, or the top-level keys.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// The table's name; empty for the top level.
    pub name: &'static str,
    /// Whether it may be repeated: `[[name]]` instead of `[name]`.
    pub repeated: bool,
    /// One line of help.
    pub about: &'static str,
    /// The program's setting whose value has these keys as fields, if there is one.
    pub setting: Option<&'static str>,
    /// Its keys.
    pub keys: &'static [Key],
}

/// A key with its values.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// The key, named like the program's setting if there is one.
    pub name: &'static str,
    /// The kind of value.
    pub shape: Shape,
    /// Whether it is required.
    pub required: bool,
    /// One line of help.
    pub about: &'static str,
    /// An example value.
    pub example: &'static str,
}

/// The kind of a value. Every number and list of numbers may also be a string, as on the command
/// line.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// One fixed string.
    Exactly(&'static str),
    /// The whole number 1.
    One,
    /// Any string.
    Text,
    /// One of these strings.
    Choice(&'static [&'static str]),
    /// A number.
    Number,
    /// This many numbers.
    Numbers(usize),
    /// Three or four numbers.
    ThreeOrFour,
    /// Three numbers, or one of these strings.
    NumbersOr(&'static [&'static str]),
    /// One number for all axes, or three.
    OneOrThree,
    /// `true` or `false`.
    Switch,
    /// The name of a node, the end of its path with `/` between names, or a list of these names.
    Node,
    /// A nested table.
    Table(&'static Section),
}

const fn key(name: &'static str, shape: Shape, about: &'static str, example: &'static str) -> Key {
    Key { name, shape, required: false, about, example }
}

const fn required(key: Key) -> Key {
    Key { required: true, ..key }
}

/// The value of `format`, which distinguishes scene files from other TOML.
pub(crate) const FORMAT: &str = "luxel-scene";

const AXES: Shape = Shape::NumbersOr(&["X", "Y", "Z", "-X", "-Y", "-Z"]);

/// Top-level keys.
pub(crate) static ROOT: Section = Section {
    name: "",
    repeated: false,
    about: "The file's format, and the surroundings of the models",
    setting: None,
    keys: &[
        required(key(
            "format",
            Shape::Exactly(FORMAT),
            "marks the file as a scene file",
            "\"luxel-scene\"",
        )),
        required(key("version", Shape::One, "the version of the format", "1")),
        key("up", AXES, "the up direction [default: the first model's]", "\"Z\""),
        key("ambient", Shape::Numbers(3), "the scene's ambient light", "[0.1, 0.1, 0.12]"),
        key(
            "environment",
            Shape::NumbersOr(&NamedEnvironment::NAMES),
            "the environment that mirrors and metals reflect; or an equirectangular picture, .hdr or .exr, \
             in the scene file's folder or below, that also lights matt surfaces",
            "\"studio\"",
        ),
        key(
            "environment_rotation",
            Shape::Number,
            "turns a picture of the environment about up, in degrees, counterclockwise from above",
            "90",
        ),
        key(
            "background",
            Shape::ThreeOrFour,
            "the background: `studio`, or a linear colour with optional alpha",
            "[0.02, 0.02, 0.03]",
        ),
    ],
};

pub(crate) static ROTATE: Section = Section {
    name: "rotate",
    repeated: false,
    about: "A rotation about an axis through the origin",
    setting: None,
    keys: &[
        required(key("axis", AXES, "the axis", "\"Y\"")),
        required(key(
            "degrees",
            Shape::Number,
            "the angle, counter-clockwise seen from the axis's tip",
            "30",
        )),
    ],
};

pub(crate) static MODELS: Section = Section {
    name: "models",
    repeated: true,
    about: "Models, in the order in which their objects are numbered. Each gets a node as its parent",
    setting: None,
    keys: &[
        required(key(
            "source",
            Shape::Text,
            "a model file in the scene file's folder or below it, or demo:NAME",
            "\"demo:teapot\"",
        )),
        key(
            "name",
            Shape::Text,
            "the name of its node [default: the file name without extension]",
            "\"pot\"",
        ),
        key(
            "parent",
            Shape::Node,
            "its parent, a node of a model above it [default: the world]",
            "\"pot\"",
        ),
        key("scale", Shape::OneOrThree, "scale, applied first; negative factors mirror", "2.5"),
        key(
            "rotate",
            Shape::Table(&ROTATE),
            "rotation, applied second",
            "{ axis = \"Y\", degrees = 30 }",
        ),
        key("translate", Shape::Numbers(3), "translation, applied last", "[0, 1.5, 0]"),
        key(
            "matrix",
            Shape::Numbers(16),
            "transform to its parent, column by column, instead of the three",
            "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
        ),
        key("material", Shape::Text, "one of [[materials]], for the whole model", "\"glaze\""),
        key(
            "lights",
            Shape::Switch,
            "whether to use its lights if the file has no [[lights]] [default: true]",
            "false",
        ),
        key("cameras", Shape::Switch, "whether to add its cameras [default: true]", "false"),
    ],
};

/// Changes to surfaces by name.
pub(crate) static MATERIALS: LazyLock<Section> = LazyLock::new(|| Section {
    name: "materials",
    repeated: true,
    about: "Named changes to surfaces: keys that are given replace the model's values, others keep them",
    setting: None,
    keys: kept([NAME, REPLACE].into_iter().chain(material_keys())),
});

/// A change to all surfaces.
pub(crate) static MATERIAL: LazyLock<Section> = LazyLock::new(|| Section {
    name: "material",
    repeated: false,
    about: "A change to all surfaces, applied before all others",
    setting: None,
    keys: kept(material_keys()),
});

/// Keys built from the tables of other crates; built once and leaked.
fn kept(keys: impl Iterator<Item = Key>) -> &'static [Key] {
    keys.collect::<Vec<_>>().leak()
}

/// The reflection constants: the shared ones in the order of the help, then the
/// parameters that only one model has.
fn material_keys() -> impl Iterator<Item = Key> {
    let about = format!("reflection model: {}", reflection_choices()).leak();
    let model = key("reflection", Shape::Text, about, "\"phong\"");
    [COLOR, AMBIENT, SPECULAR]
        .into_iter()
        .chain([&K_A, &K_D, &K_S, &SHININESS].map(parameter))
        .chain([EMISSION, model])
        .chain([&METALLIC, &ROUGHNESS].map(parameter))
        .chain([OPACITY])
        .chain(own_parameters().map(|own| parameter(&own.parameter)))
}

const fn parameter(of: &Parameter) -> Key {
    key(of.name, Shape::Number, of.help, of.example)
}

const NAME: Key = required(key("name", Shape::Text, "its name", "\"glaze\""));
const REPLACE: Key = key(
    "replace",
    Shape::Switch,
    "start from luxel's plain material instead of the surface's own",
    "true",
);
const COLOR: Key = key(
    "color",
    Shape::Numbers(3),
    "diffuse and ambient colour, instead of textures and vertex colours",
    "[0.6, 0.1, 0.05]",
);
const AMBIENT: Key = key(
    "ambient",
    Shape::Numbers(3),
    "ambient colour, if it differs from the diffuse one",
    "[0.1, 0.1, 0.1]",
);
const SPECULAR: Key = key(
    "specular",
    Shape::Numbers(3),
    "colour of the highlight, instead of a texture",
    "[1, 0.9, 0.6]",
);
const EMISSION: Key =
    key("emission", Shape::Numbers(3), "emitted light, instead of a texture", "[0, 0, 0.1]");
const OPACITY: Key =
    key("opacity", Shape::Number, "opacity from 0 to 1; below 1 the surface is transparent", "0.5");

pub(crate) static OVERRIDES: Section = Section {
    name: "overrides",
    repeated: true,
    about: "Assigns one of [[materials]] to the surfaces that match model, object and surface. Later overrides apply on top of earlier ones",
    setting: None,
    keys: &[
        required(key("material", Shape::Text, "one of [[materials]]", "\"glaze\"")),
        key("model", Shape::Text, "only in the model with this name", "\"pot\""),
        key(
            "object",
            Shape::Node,
            "only objects with this name or path, and those below them",
            "\"lid\"",
        ),
        key(
            "surface",
            Shape::Text,
            "only surfaces whose material has this name in the model",
            "\"glaze\"",
        ),
    ],
};

pub(crate) static LIGHTS: LazyLock<Section> = LazyLock::new(|| Section {
    name: "lights",
    repeated: true,
    about: "Lights, instead of the models' lights, in the order of summation",
    setting: Some("light"),
    keys: kept(light_keys()),
});

fn light_keys() -> impl Iterator<Item = Key> {
    let names = LIGHT_KINDS.map(|kind| kind.name).to_vec().leak();
    let kind = required(key("kind", Shape::Choice(names), "the kind of light", "\"point\""));
    let of = |has: fn(&LightKindDescription) -> bool| {
        let names: Vec<_> =
            LIGHT_KINDS.iter().filter(|kind| has(kind)).map(|kind| kind.name).collect();
        names.join(", ")
    };
    let position = format!("position ({})", of(|kind| kind.has_position)).leak();
    let direction =
        format!("the direction in which the light travels ({})", of(|kind| kind.has_direction))
            .leak();
    let own = LIGHT_KINDS.iter().flat_map(|kind| kind.fields);
    [kind]
        .into_iter()
        .chain(LIGHT_PLACEMENT)
        .chain([
            key("pos", Shape::Numbers(3), position, "[2, 3, 4]"),
            key("dir", Shape::Numbers(3), direction, "[0, -1, 0]"),
        ])
        .chain(own.map(|field| key(field.name, Shape::Number, field.help, field.example)))
        .chain(LIGHT_INTENSITIES)
}

const LIGHT_PLACEMENT: [Key; 3] = [
    key("name", Shape::Text, "its name [default: light1, light2, ...]", "\"key\""),
    key(
        "in",
        Shape::Choice(&["world", "camera"]),
        "the coordinates of pos and dir [default: world]",
        "\"camera\"",
    ),
    key(
        "node",
        Shape::Node,
        "the node that pos and dir are relative to: the light moves with it",
        "\"pot\"",
    ),
];

const LIGHT_INTENSITIES: [Key; 9] = [
    key("color", Shape::Numbers(3), "intensity (ambient)", "[0.1, 0.1, 0.1]"),
    key(
        "ambient",
        Shape::Numbers(3),
        "intensity for the ambient term [default: 0, 0, 0]",
        "[0.05, 0.05, 0.05]",
    ),
    key(
        "diffuse",
        Shape::Numbers(3),
        "intensity for diffuse reflection [default: 1, 1, 1]",
        "[1, 0.9, 0.8]",
    ),
    key(
        "specular",
        Shape::Numbers(3),
        "intensity for the highlight [default: as diffuse]",
        "[1, 1, 1]",
    ),
    key(
        "attenuation",
        Shape::Numbers(3),
        "c1, c2, c3 of 1 / (c1 + c2 d + c3 d^2) [default: 1, 0, 0]",
        "[1, 0, 0.1]",
    ),
    key(
        "limit",
        Shape::Number,
        "upper limit of the attenuation, 1 as in Foley et al. [default: none]",
        "1",
    ),
    key(
        "range",
        Shape::Number,
        "distance at which the light fades to 0, as in glTF [default: none]",
        "20",
    ),
    key(
        "radius",
        Shape::Number,
        "the radius of the ball that the light is, for soft shadows (point, spot) [default: 0]",
        "0.1",
    ),
    key(
        "angle",
        Shape::Number,
        "the angle under which the light is seen, for soft shadows (directional) [default: 0]",
        "0.53",
    ),
];

pub(crate) static CAMERAS: Section = Section {
    name: "cameras",
    repeated: true,
    about: "Cameras, before those of the models; the first one is the default",
    setting: None,
    keys: &[
        required(key("name", Shape::Text, "its name", "\"front\"")),
        key("eye", Shape::Numbers(3), "the position of the eye", "[4, 3, 8]"),
        key("target", Shape::Numbers(3), "the point it looks at", "[0, 1, 0]"),
        key("up", AXES, "the up direction [default: the scene's]", "\"Y\""),
        key(
            "view-matrix",
            Shape::Numbers(16),
            "from world to camera space, column by column, instead of the three",
            "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1]",
        ),
        key(
            "node",
            Shape::Node,
            "the node that the coordinates are relative to, instead of the world",
            "\"pot\"",
        ),
        key("fov", Shape::Number, "vertical field of view in degrees [default: 45]", "35"),
        key("ortho", Shape::Number, "orthographic projection: visible height in world units", "4"),
        key(
            "intrinsics",
            Shape::Numbers(4),
            "a calibrated camera: focal lengths and principal point, in pixels",
            "[900, 900, 640, 360]",
        ),
    ],
};

pub(crate) static FOG: Section = Section {
    name: "fog",
    repeated: false,
    about: "Depth cueing",
    setting: Some("fog"),
    keys: &[
        key(
            "law",
            Shape::Choice(&["linear", "exp", "exp2"]),
            "how the surface's own light fades: linearly from near to far, as exp(-density z), or as \
             exp(-(density z)^2) [default: linear]",
            "\"exp\"",
        ),
        key(
            "near",
            Shape::Number,
            "the distance along the view axis at which the fog begins (linear)",
            "4",
        ),
        key("far", Shape::Number, "the distance at which it ends (linear)", "20"),
        key("density", Shape::Number, "density (exp, exp2)", "0.1"),
        key(
            "front",
            Shape::Number,
            "the weight of the surface's light at near (linear) [default: 1]",
            "1",
        ),
        key("back", Shape::Number, "the weight at far (linear) [default: 0]", "0.2"),
        key(
            "color",
            Shape::Numbers(3),
            "the colour that surfaces fade to [default: 0, 0, 0]",
            "[0.5, 0.6, 0.7]",
        ),
    ],
};

/// The table with settings of the rendering program.
pub(crate) const RENDER: &str = "render";

/// All sections but `[render]`, whose keys belong to the program: first the top-level keys, then
/// the tables.
#[must_use]
pub fn sections() -> [&'static Section; 8] {
    [&ROOT, &MODELS, &MATERIAL, &MATERIALS, &OVERRIDES, &LIGHTS, &CAMERAS, &FOG]
}
