//! The light that a surface point sends to the eye.
//!
//! The only implementation of the lighting equation ([`lit`]), generic over the number (one pixel,
//! or sixteen) and over a [`Witness`] that observes every term as it is computed: for rendering it
//! is [`Silent`] and costs nothing, for explaining it is a [`Ledger`] that writes the terms down.
//!
//! Places and directions are those of the world, with the eye as the origin, so that scenes far
//! from the world's origin don't shake. Light is linear and of any intensity; [`PictureEncoding`]
//! converts it to bytes.
//!
//! | subject | here |
//! | --- | --- |
//! | light | [`Light`], [`LightKind`], [`LIGHT_KINDS`], [`PlacedLight`], [`Environment`], [`EnvironmentMap`] |
//! | reflection | [`Reflection`], [`REFLECTION_MODELS`], [`ReflectionModel`], [`Parameter`] |
//! | surface | [`Material`], [`Reflectance`], [`Coefficients`], [`SurfacePoint`] |
//! | result | [`lit`], [`lit_by`], [`reflected`], [`Fog`] |
//! | shadow | [`Occlusion`], [`terminator`] |
//! | observers | [`Witness`], [`Silent`], [`Ledger`] |
//! | display | [`Display`], [`Tone`]: exposure and tone curve |
//! | encoding | [`PictureEncoding`], [`srgb_to_byte`] |

#![forbid(unsafe_code)]

mod coefficients;
mod display;
mod encode;
mod environment;
mod equation;
mod fog;
mod light;
mod light_kind;
mod material;
mod occlusion;
mod parameter;
mod placed;
mod point;
mod reflectance;
mod reflection;
mod tone;
mod witness;

pub use coefficients::{Broadcast, Coefficients, Uniform};
pub use display::Display;
pub use encode::{
    PictureEncoding, byte_to_linear, decode_srgb, encode_srgb, srgb_to_byte, unit_to_byte,
};
pub use environment::{Environment, EnvironmentMap, EquirectangularImage, OrientedMap};
pub use equation::{LightingEnvironment, lit, lit_by, reflected};
pub use fog::{Fog, FogLaw};
pub use light::{Attenuation, Light};
pub use light_kind::{
    CUTOFF, Cone, EXPONENT, INNER, LIGHT_KINDS, LightField, LightKind, LightKindDescription,
    LightNumber,
};
pub use material::Material;
pub use occlusion::{Occlusion, terminator};
pub use parameter::{K_A, K_D, K_S, METALLIC, Parameter, ROUGHNESS, SHARED, SHININESS};
pub use placed::PlacedLight;
pub use point::SurfacePoint;
pub use reflectance::Reflectance;
pub use reflection::{
    HighlightVector, ModelFactor, NOT_METAL, OwnParameter, Quantity, REFLECTION_MODELS, Reflection,
    ReflectionModel, Symbol, own_parameters, parameters,
};
pub use tone::Tone;
pub use witness::{
    DiffuseTerms, Ledger, LedgerLight, LightTerms, Lobe, MirrorTerms, PartTerms, Silent, Terms,
    Witness,
};
