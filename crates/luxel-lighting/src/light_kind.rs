//! How lights spread, and what each kind says of itself: flags, scene files, the window and the
//! documents read it.

/// How a light spreads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From everywhere, equally: only the ambient intensity counts.
    Ambient,
    /// Along one direction, from infinitely far.
    Directional,
    /// From a point into all directions.
    Point,
    /// From a point into a cone.
    Spot(Cone),
}

impl LightKind {
    /// Whether what arrives depends on the distance and direction of a place.
    #[must_use]
    pub const fn has_place(self) -> bool {
        self.description().has_position
    }

    /// Its name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.description().name
    }

    /// What it says of itself.
    #[must_use]
    pub const fn description(self) -> &'static LightKindDescription {
        match self {
            Self::Directional => &DIRECTIONAL,
            Self::Point => &POINT,
            Self::Spot(_) => &SPOT,
            Self::Ambient => &AMBIENT,
        }
    }
}

/// The cone of a spot light; angle t is between the light's direction and the way to the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cone {
    /// max(cos t, 0)^exponent inside the cutoff, 0 outside (OpenGL 1.x, section 2.13.1). A cosine
    /// of the cutoff of -1 means no cone.
    Exponent {
        /// Cosine of the half-angle.
        cos_cutoff: f32,
        /// How the light concentrates along the axis; below 0 is taken as 0.
        exponent: f32,
    },
    /// 1 inside the inner cone, 0 outside the outer one, between them
    /// ((cos t - cos outer) / (cos inner - cos outer))^2 (glTF `KHR_lights_punctual`).
    Smooth {
        /// Cosine of the inner half-angle.
        cos_inner: f32,
        /// Cosine of the outer half-angle.
        cos_outer: f32,
    },
}

/// What a kind of light says of itself.
#[derive(Debug)]
pub struct LightKindDescription {
    /// A light of the kind as the window adds it.
    pub kind: LightKind,
    /// Its name, as flags and scene files have it.
    pub name: &'static str,
    /// How it spreads, in a line.
    pub help: &'static str,
    /// Whether it stands somewhere, so that its light comes from there and may weaken on its way.
    pub has_position: bool,
    /// Whether it shines in a direction.
    pub has_direction: bool,
    /// The numbers that only this kind has.
    pub fields: &'static [LightField],
    /// The fields of its text form behind position and direction; empty if there are none.
    pub usage: &'static str,
}

/// A number that only one kind of light has.
#[derive(Clone, Copy, Debug)]
pub struct LightField {
    /// Its key.
    pub name: &'static str,
    /// What it means, in a line.
    pub help: &'static str,
    /// A value, as scene files write it.
    pub example: &'static str,
}

/// All kinds, in the order of lists.
pub static LIGHT_KINDS: [&LightKindDescription; 4] = [&DIRECTIONAL, &POINT, &SPOT, &AMBIENT];

static DIRECTIONAL: LightKindDescription = LightKindDescription {
    kind: LightKind::Directional,
    name: "directional",
    help: "along one direction, from infinitely far",
    has_position: false,
    has_direction: true,
    fields: &[],
    usage: "",
};

static POINT: LightKindDescription = LightKindDescription {
    kind: LightKind::Point,
    name: "point",
    help: "from a point into all directions",
    has_position: true,
    has_direction: false,
    fields: &[],
    usage: "",
};

/// The cosine of 30 degrees.
const COS_30_DEGREES: f32 = 0.866_025_4;

static SPOT: LightKindDescription = LightKindDescription {
    kind: LightKind::Spot(Cone::Exponent { cos_cutoff: COS_30_DEGREES, exponent: 8.0 }),
    name: "spot",
    help: "from a point into a cone",
    has_position: true,
    has_direction: true,
    fields: &[
        LightField {
            name: "cutoff",
            help: "half-angle of the cone, 0 to 90, or 180 for none (spot) [default: 180]",
            example: "30",
        },
        LightField {
            name: "exponent",
            help: "how it concentrates along the axis (spot) [default: 0]",
            example: "8",
        },
        LightField {
            name: "inner",
            help: "instead of an exponent: the half-angle up to which it is not weakened, as in glTF (spot)",
            example: "20",
        },
    ],
    usage: "cutoff=DEG:exponent=E (or :inner=DEG, a soft edge)",
};

static AMBIENT: LightKindDescription = LightKindDescription {
    kind: LightKind::Ambient,
    name: "ambient",
    help: "from everywhere, equally",
    has_position: false,
    has_direction: false,
    fields: &[],
    usage: "color=R,G,B",
};

impl LightKindDescription {
    /// The kind of a name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<&'static Self> {
        LIGHT_KINDS.into_iter().find(|kind| kind.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_is_found_by_its_name_and_described_by_its_own_description() {
        for description in LIGHT_KINDS {
            assert_eq!(description.kind.name(), description.name);
            let found = LightKindDescription::by_name(description.name).unwrap();
            assert_eq!(found.kind, description.kind);
        }
    }
}
