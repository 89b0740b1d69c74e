//! The sections and keys of scene files. Readers, the JSON schema and the documentation use this table.
//! Parameters of reflection and kinds of light come from the tables of `luxel-lighting`.

use crate::values::reflection_choices;
use luxel_lighting::{
    K_A, K_D, K_S, LIGHT_KINDS, LightKindDescription, METALLIC, Parameter, ROUGHNESS, SHININESS,
    own_parameters,
};
use std::sync::LazyLock;

/// A table of a scene file, or the keys outside all tables.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// The table's name; empty for what stands outside all tables.
    pub name: &'static str,
    /// Whether there may be many: `[[name]]` instead of `[name]`.
    pub repeated: bool,
    /// What it is, in a line. Names of settings of a program stand in backticks.
    pub about: &'static str,
    /// What may stand in it.
    pub keys: &'static [Key],
}

/// A key with what may stand behind it.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// The key; where a program has a setting for it, the name of that.
    pub name: &'static str,
    /// The kind of value.
    pub shape: Shape,
    /// Whether it can't be left out.
    pub required: bool,
    /// What it means, in a line.
    pub about: &'static str,
    /// A value, as the file writes it.
    pub example: &'static str,
}

/// The kind of a value. Every number and list of numbers may also be a string, as on the command
/// line.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// One text.
    Exactly(&'static str),
    /// The whole number 1.
    One,
    /// Any text.
    Text,
    /// One of some texts.
    Choice(&'static [&'static str]),
    /// A number.
    Number,
    /// As many numbers.
    Numbers(usize),
    /// Three or four numbers.
    ThreeOrFour,
    /// Three numbers, or one of some texts.
    NumbersOr(&'static [&'static str]),
    /// One number for all axes, or three.
    OneOrThree,
    /// `true` or `false`.
    Switch,
    /// The name of a node, the end of its path with `/` between the names, or a list of these names.
    Node,
    /// A table of its own.
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

/// Keys outside all tables.
pub(crate) static ROOT: Section = Section {
    name: "",
    repeated: false,
    about: "What the file is, and what surrounds the models",
    keys: &[
        required(key(
            "format",
            Shape::Exactly(FORMAT),
            "that this is a scene file",
            "\"luxel-scene\"",
        )),
        required(key("version", Shape::One, "the version of what is described here", "1")),
        key("up", AXES, "what is up [default: as the first model has it]", "\"Z\""),
        key("ambient", Shape::Numbers(3), "the scene's ambient light", "[0.1, 0.1, 0.12]"),
        key(
            "environment",
            Shape::NumbersOr(&["none", "studio", "microfacet"]),
            "what mirrors and metals see",
            "\"studio\"",
        ),
        key(
            "background",
            Shape::ThreeOrFour,
            "linear colour where nothing is, with alpha if you like",
            "[0.02, 0.02, 0.03]",
        ),
    ],
};

pub(crate) static ROTATE: Section = Section {
    name: "rotate",
    repeated: false,
    about: "A turn about an axis through the origin",
    keys: &[
        required(key("axis", AXES, "the axis", "\"Y\"")),
        required(key(
            "degrees",
            Shape::Number,
            "how far, counter-clockwise seen from its tip",
            "30",
        )),
    ],
};

pub(crate) static MODELS: Section = Section {
    name: "models",
    repeated: true,
    about: "Models, in the order in which their objects are numbered. Each hangs on a node of its own",
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
            "the name of its node [default: the file's, without its ending]",
            "\"pot\"",
        ),
        key(
            "parent",
            Shape::Node,
            "the node that it hangs on, of a model above it [default: the world]",
            "\"pot\"",
        ),
        key("scale", Shape::OneOrThree, "its size, done first; a minus mirrors", "2.5"),
        key(
            "rotate",
            Shape::Table(&ROTATE),
            "a turn, done second",
            "{ axis = \"Y\", degrees = 30 }",
        ),
        key("translate", Shape::Numbers(3), "a move, done last", "[0, 1.5, 0]"),
        key(
            "matrix",
            Shape::Numbers(16),
            "from its coordinates to its parent's, column by column, instead of the three",
            "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
        ),
        key("material", Shape::Text, "one of [[materials]], for all of it", "\"glaze\""),
        key(
            "lights",
            Shape::Switch,
            "whether its own lights shine where the file has no [[lights]] [default: true]",
            "false",
        ),
        key(
            "cameras",
            Shape::Switch,
            "whether its own cameras can be used [default: true]",
            "false",
        ),
    ],
};

/// Changes to surfaces by name.
pub(crate) static MATERIALS: LazyLock<Section> = LazyLock::new(|| Section {
    name: "materials",
    repeated: true,
    about: "Changes to surfaces, by name: what is said replaces, what isn't stays as the model has it",
    keys: kept([NAME, REPLACE].into_iter().chain(material_keys())),
});

/// A change to all surfaces.
pub(crate) static MATERIAL: LazyLock<Section> = LazyLock::new(|| Section {
    name: "material",
    repeated: false,
    about: "A change to all surfaces, before any other",
    keys: kept(material_keys()),
});

/// Keys that are made of tables of other crates, as long as the program runs.
fn kept(keys: impl Iterator<Item = Key>) -> &'static [Key] {
    keys.collect::<Vec<_>>().leak()
}

/// The constants of reflection: with a flag or of all materials in the order of the help, then the
/// parameters that only one model has.
fn material_keys() -> impl Iterator<Item = Key> {
    let about = format!("the model of reflection: {}", reflection_choices()).leak();
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
    "ambient colour, where it isn't the diffuse one",
    "[0.1, 0.1, 0.1]",
);
const SPECULAR: Key = key(
    "specular",
    Shape::Numbers(3),
    "colour of the highlight, instead of a texture",
    "[1, 0.9, 0.6]",
);
const EMISSION: Key = key(
    "emission",
    Shape::Numbers(3),
    "light of the surface's own, instead of a texture",
    "[0, 0, 0.1]",
);
const OPACITY: Key = key(
    "opacity",
    Shape::Number,
    "0 to 1; below 1 the surface lets through what is behind it",
    "0.5",
);

pub(crate) static OVERRIDES: Section = Section {
    name: "overrides",
    repeated: true,
    about: "Which surfaces get which of [[materials]]: those that fit all of model, object and surface. Later ones come on top of earlier ones",
    keys: &[
        required(key("material", Shape::Text, "one of [[materials]]", "\"glaze\"")),
        key("model", Shape::Text, "of the model of this name", "\"pot\""),
        key("object", Shape::Node, "of the objects of this name or path", "\"lid\""),
        key("surface", Shape::Text, "those whose material is called so in the model", "\"glaze\""),
    ],
};

pub(crate) static LIGHTS: LazyLock<Section> = LazyLock::new(|| Section {
    name: "lights",
    repeated: true,
    about: "Lights, instead of the models' own, in the order in which they are added up; the keys are the fields of `light`",
    keys: kept(light_keys()),
});

fn light_keys() -> impl Iterator<Item = Key> {
    let names = LIGHT_KINDS.map(|kind| kind.name).to_vec().leak();
    let kind = required(key("kind", Shape::Choice(names), "how it spreads", "\"point\""));
    let of = |has: fn(&LightKindDescription) -> bool| {
        let names: Vec<_> =
            LIGHT_KINDS.iter().filter(|kind| has(kind)).map(|kind| kind.name).collect();
        names.join(", ")
    };
    let position = format!("where it stands ({})", of(|kind| kind.has_position)).leak();
    let direction =
        format!("the direction in which its light travels ({})", of(|kind| kind.has_direction))
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
        "the node whose coordinates they are instead: the light moves with it",
        "\"pot\"",
    ),
];

const LIGHT_INTENSITIES: [Key; 7] = [
    key("color", Shape::Numbers(3), "its intensity (ambient)", "[0.1, 0.1, 0.1]"),
    key(
        "ambient",
        Shape::Numbers(3),
        "what it adds to the ambient term [default: 0, 0, 0]",
        "[0.05, 0.05, 0.05]",
    ),
    key(
        "diffuse",
        Shape::Numbers(3),
        "its intensity for diffuse reflection [default: 1, 1, 1]",
        "[1, 0.9, 0.8]",
    ),
    key(
        "specular",
        Shape::Numbers(3),
        "its intensity for the highlight [default: as diffuse]",
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
        "what that is cut at, 1 as in Foley et al. [default: it is not cut]",
        "1",
    ),
    key(
        "range",
        Shape::Number,
        "where its light ends, faded out as in glTF [default: nowhere]",
        "20",
    ),
];

pub(crate) static CAMERAS: Section = Section {
    name: "cameras",
    repeated: true,
    about: "Cameras, before the models' own; the first one is used unless `camera` names another",
    keys: &[
        required(key("name", Shape::Text, "its name", "\"front\"")),
        key("eye", Shape::Numbers(3), "where the eye stands", "[4, 3, 8]"),
        key("target", Shape::Numbers(3), "where it looks", "[0, 1, 0]"),
        key("up", AXES, "what is up [default: the scene's]", "\"Y\""),
        key(
            "view-matrix",
            Shape::Numbers(16),
            "from world to camera space, column by column, instead of the three",
            "[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -5, 1]",
        ),
        key(
            "node",
            Shape::Node,
            "the node whose coordinates these are, instead of the world's",
            "\"pot\"",
        ),
        key(
            "fov",
            Shape::Number,
            "the angle of view from bottom to top, in degrees [default: 45]",
            "35",
        ),
        key("ortho", Shape::Number, "parallel rays; world units from bottom to top", "4"),
        key(
            "intrinsics",
            Shape::Numbers(4),
            "a calibrated lens: focal lengths and principal point, in pixels",
            "[900, 900, 640, 360]",
        ),
    ],
};

pub(crate) static FOG: Section = Section {
    name: "fog",
    repeated: false,
    about: "Depth cueing; the keys are the fields of `fog`",
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
            "the distance along the view where the fog begins (linear)",
            "4",
        ),
        key("far", Shape::Number, "where it ends (linear)", "20"),
        key("density", Shape::Number, "how thick it is (exp, exp2)", "0.1"),
        key(
            "front",
            Shape::Number,
            "the share of the surface's own light at near (linear) [default: 1]",
            "1",
        ),
        key("back", Shape::Number, "its share at far (linear) [default: 0]", "0.2"),
        key(
            "color",
            Shape::Numbers(3),
            "what the surfaces fade to [default: 0, 0, 0]",
            "[0.5, 0.6, 0.7]",
        ),
    ],
};

/// The name of the table whose keys are settings of the program that draws.
pub(crate) const RENDER: &str = "render";

/// All sections but `[render]`, whose keys are the program's: first the keys outside all tables, then
/// the tables.
#[must_use]
pub fn sections() -> [&'static Section; 8] {
    [&ROOT, &MODELS, &MATERIAL, &MATERIALS, &OVERRIDES, &LIGHTS, &CAMERAS, &FOG]
}
