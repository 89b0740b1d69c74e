//! The choice of an environment, by name.

use glam::DVec3;
use luxel_lighting::{Environment, EnvironmentMap, OrientedMap};
use std::sync::Arc;

/// The environment: what mirrors and metals reflect and, of a map, what lights matt surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum EnvironmentChoice {
    /// The studio for microfacet materials, nothing for others.
    #[default]
    StudioForMicrofacets,
    /// The same for every material.
    Always(Environment),
}

/// An environment with a name: all but uniform light of some colour and maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamedEnvironment {
    /// Nothing.
    None,
    /// An analytic gradient.
    Studio,
    /// That gradient for microfacet materials, nothing for others.
    StudioForMicrofacets,
}

impl NamedEnvironment {
    /// All environments with a name, in the order of lists.
    pub const ALL: [Self; 3] = [Self::None, Self::Studio, Self::StudioForMicrofacets];

    /// All names, in the same order.
    pub const NAMES: [&'static str; 3] =
        [Self::None.name(), Self::Studio.name(), Self::StudioForMicrofacets.name()];

    /// The environment with a name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|environment| environment.name() == name)
    }

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Studio => "studio",
            Self::StudioForMicrofacets => "microfacet",
        }
    }

    /// One line of help.
    #[must_use]
    pub const fn help(self) -> &'static str {
        match self {
            Self::None => "no reflections",
            Self::Studio => "bright above, a soft horizon, dark below",
            Self::StudioForMicrofacets => "the studio, for microfacet materials only",
        }
    }

    /// The environment in a scene with this up direction.
    #[must_use]
    pub fn choice(self, up: DVec3) -> EnvironmentChoice {
        match self {
            Self::None => EnvironmentChoice::Always(Environment::None),
            Self::Studio => {
                EnvironmentChoice::Always(Environment::Studio { up: up.as_vec3().to_array() })
            }
            Self::StudioForMicrofacets => EnvironmentChoice::StudioForMicrofacets,
        }
    }
}

impl EnvironmentChoice {
    /// A map in a scene with these directions [right, up and front](crate::Viewpoint::frame), turned about up.
    #[must_use]
    pub fn of_map(map: Arc<EnvironmentMap>, frame: [DVec3; 3], rotation_degrees: f64) -> Self {
        let frame = frame.map(|axis| axis.to_array());
        Self::Always(Environment::Map(OrientedMap::new(map, frame, rotation_degrees)))
    }

    /// The map, if it is one.
    #[must_use]
    pub fn map(&self) -> Option<&OrientedMap> {
        match self {
            Self::Always(Environment::Map(map)) => Some(map),
            _ => None,
        }
    }

    /// Whether its map has all of its texels, if it is one.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.map().is_none_or(|map| map.map().is_sound())
    }

    /// The same with these directions [right, up and front](crate::Viewpoint::frame).
    #[must_use]
    pub fn in_frame(self, frame: [DVec3; 3]) -> Self {
        match self {
            Self::Always(Environment::Studio { .. }) => NamedEnvironment::Studio.choice(frame[1]),
            Self::Always(Environment::Map(map)) => {
                Self::of_map(Arc::clone(map.map()), frame, map.rotation_degrees())
            }
            other => other,
        }
    }

    /// What is seen all around, whatever the materials, in a scene with this up direction.
    #[must_use]
    pub fn surroundings(&self, up: DVec3) -> Environment {
        match self {
            Self::Always(environment) => environment.clone(),
            Self::StudioForMicrofacets => Environment::Studio { up: up.as_vec3().to_array() },
        }
    }

    /// The environment's name; `None` for uniform light and maps.
    #[must_use]
    pub fn named(&self) -> Option<NamedEnvironment> {
        match self {
            Self::StudioForMicrofacets => Some(NamedEnvironment::StudioForMicrofacets),
            Self::Always(Environment::None) => Some(NamedEnvironment::None),
            Self::Always(Environment::Studio { .. }) => Some(NamedEnvironment::Studio),
            Self::Always(Environment::Constant(_) | Environment::Map(_)) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_named_environment_is_found_by_its_name_and_its_choice() {
        for (environment, name) in NamedEnvironment::ALL.into_iter().zip(NamedEnvironment::NAMES) {
            assert_eq!(NamedEnvironment::by_name(name), Some(environment));
            assert_eq!(environment.choice(DVec3::Z).named(), Some(environment));
        }
    }
}
