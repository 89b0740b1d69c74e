//! The kinds of light, each with a description that flags, scene files, the viewer and the
//! documents read.

/// How a light spreads.
///
/// Of a `u8`, as [`Reflection`](crate::Reflection) is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(u8)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// Whether the incident light depends on the position of the surface.
    #[must_use]
    pub const fn has_place(self) -> bool {
        self.description().has_position
    }

    /// Its name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.description().name
    }

    /// The values of the fields that only this kind has.
    pub fn fields(self) -> impl Iterator<Item = (&'static LightField, LightNumber)> {
        let fields = self.description().fields.iter();
        fields.filter_map(move |field| Some((*field, (field.value)(self)?)))
    }

    /// The description of the kind.
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

/// The cone of a spot light; t is the angle between the light's direction and the direction to the
/// surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cone {
    /// max(cos t, 0)^exponent inside the cutoff, 0 outside (OpenGL 1.x, section 2.13.1). A cosine
    /// of the cutoff of -1 means no cone.
    Exponent {
        /// Cosine of the half-angle.
        cos_cutoff: f32,
        /// Concentration along the axis; negative values count as 0.
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

/// The description of a kind of light.
#[derive(Debug)]
pub struct LightKindDescription {
    /// The default light of the kind, as the viewer adds it.
    pub kind: LightKind,
    /// Its name, as flags and scene files have it.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// Whether it has a position, and attenuation with distance.
    pub has_position: bool,
    /// Whether it has a direction.
    pub has_direction: bool,
    /// The fields that only this kind has.
    pub fields: &'static [&'static LightField],
    /// The fields of its text form after position and direction; empty if none.
    pub usage: &'static str,
}

/// A field that only one kind of light has.
#[derive(Clone, Copy, Debug)]
pub struct LightField {
    /// Its key.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// An example value, as in scene files.
    pub example: &'static str,
    /// The value in a light; `None` if the light lacks the field.
    value: fn(LightKind) -> Option<LightNumber>,
}

/// The value of a [`LightField`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightNumber {
    /// The cosine of a half-angle, which users give in degrees.
    HalfAngle(f32),
    /// A number without unit.
    Plain(f32),
}

/// The half-angle of a spot light's cone, of either kind.
pub static CUTOFF: LightField = LightField {
    name: "cutoff",
    help: "half-angle of the cone, 0 to 90, or 180 for none (spot) [default: 180]",
    example: "30",
    value: |kind| match kind {
        LightKind::Spot(Cone::Exponent { cos_cutoff: cosine, .. })
        | LightKind::Spot(Cone::Smooth { cos_outer: cosine, .. }) => {
            Some(LightNumber::HalfAngle(cosine))
        }
        _ => None,
    },
};

/// The exponent of a [`Cone::Exponent`].
pub static EXPONENT: LightField = LightField {
    name: "exponent",
    help: "concentration along the axis (spot) [default: 0]",
    example: "8",
    value: |kind| match kind {
        LightKind::Spot(Cone::Exponent { exponent, .. }) => Some(LightNumber::Plain(exponent)),
        _ => None,
    },
};

/// The inner half-angle of a [`Cone::Smooth`].
pub static INNER: LightField = LightField {
    name: "inner",
    help: "instead of an exponent: the half-angle of full intensity, as in glTF (spot)",
    example: "20",
    value: |kind| match kind {
        LightKind::Spot(Cone::Smooth { cos_inner, .. }) => Some(LightNumber::HalfAngle(cos_inner)),
        _ => None,
    },
};

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
    fields: &[&CUTOFF, &EXPONENT, &INNER],
    usage: "cutoff=DEG:exponent=E (or :inner=DEG, a soft edge)",
};

static AMBIENT: LightKindDescription = LightKindDescription {
    kind: LightKind::Ambient,
    name: "ambient",
    help: "from everywhere, equally",
    has_position: false,
    has_direction: false,
    fields: &[],
    usage: "color=COLOR",
};

impl Cone {
    /// The smallest difference between the cosines of a smooth cone's angles: the lower bound of
    /// the divisor in the reference code of glTF's `KHR_lights_punctual`.
    const LEAST_EDGE: f32 = 0.001;

    /// A smooth cone, with an edge wide enough to divide by.
    #[must_use]
    pub const fn smooth(cos_inner: f32, cos_outer: f32) -> Self {
        Self::Smooth { cos_inner: cos_inner.max(cos_outer + Self::LEAST_EDGE), cos_outer }
    }
}

impl LightKindDescription {
    /// The kind with a name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<&'static Self> {
        LIGHT_KINDS.into_iter().find(|kind| kind.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_light_has_the_fields_of_its_cone() {
        let names =
            |cone| LightKind::Spot(cone).fields().map(|(field, _)| field.name).collect::<Vec<_>>();
        let with_exponent = names(Cone::Exponent { cos_cutoff: 0.5, exponent: 2.0 });
        assert_eq!(with_exponent, ["cutoff", "exponent"]);
        assert_eq!(names(Cone::smooth(0.9, 0.5)), ["cutoff", "inner"]);
        assert_eq!(LightKind::Point.fields().count(), 0);
    }

    #[test]
    fn a_kind_is_found_by_its_name_and_described_by_its_own_description() {
        for description in LIGHT_KINDS {
            assert_eq!(description.kind.name(), description.name);
            let found = LightKindDescription::by_name(description.name).unwrap();
            assert_eq!(found.kind, description.kind);
        }
    }
}
