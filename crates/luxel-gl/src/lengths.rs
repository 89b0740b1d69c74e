//! How many values a pointer argument points to: what the C side reads before it calls the safe crate.
//!
//! 0 for a name that isn't one: the command itself records the error.

use crate::enums as gl;
use crate::limits::PIXEL_MAP;
use crate::state::evaluator::MapTarget;

/// Values of `glLightfv` and `glGetLightfv` (OpenGL 1.5, table 2.10).
#[must_use]
pub fn light(pname: u32) -> usize {
    match pname {
        gl::AMBIENT | gl::DIFFUSE | gl::SPECULAR | gl::POSITION => 4,
        gl::SPOT_DIRECTION => 3,
        gl::SPOT_EXPONENT
        | gl::SPOT_CUTOFF
        | gl::CONSTANT_ATTENUATION
        | gl::LINEAR_ATTENUATION
        | gl::QUADRATIC_ATTENUATION => 1,
        _ => 0,
    }
}

/// Values of `glLightModelfv`.
#[must_use]
pub fn light_model(pname: u32) -> usize {
    match pname {
        gl::LIGHT_MODEL_AMBIENT => 4,
        gl::LIGHT_MODEL_LOCAL_VIEWER | gl::LIGHT_MODEL_TWO_SIDE | gl::LIGHT_MODEL_COLOR_CONTROL => {
            1
        }
        _ => 0,
    }
}

/// Values of `glMaterialfv` and `glGetMaterialfv`.
#[must_use]
pub fn material(pname: u32) -> usize {
    match pname {
        gl::AMBIENT | gl::DIFFUSE | gl::SPECULAR | gl::EMISSION | gl::AMBIENT_AND_DIFFUSE => 4,
        gl::COLOR_INDEXES => 3,
        gl::SHININESS => 1,
        _ => 0,
    }
}

/// Values of `glFogfv`.
#[must_use]
pub fn fog(pname: u32) -> usize {
    match pname {
        gl::FOG_COLOR => 4,
        gl::FOG_MODE
        | gl::FOG_DENSITY
        | gl::FOG_START
        | gl::FOG_END
        | gl::FOG_INDEX
        | gl::FOG_COORD_SRC => 1,
        _ => 0,
    }
}

/// Values of `glPointParameterfv`.
#[must_use]
pub fn point_parameter(pname: u32) -> usize {
    match pname {
        gl::POINT_DISTANCE_ATTENUATION => 3,
        gl::POINT_SIZE_MIN | gl::POINT_SIZE_MAX | gl::POINT_FADE_THRESHOLD_SIZE => 1,
        _ => 0,
    }
}

/// Bytes of `glCallLists`' array of `n` names; 0 for a negative count or a type that isn't one.
#[must_use]
pub fn call_lists_bytes(n: i32, data_type: u32) -> usize {
    let each = match data_type {
        gl::BYTE | gl::UNSIGNED_BYTE => 1,
        gl::SHORT | gl::UNSIGNED_SHORT | gl::_2_BYTES => 2,
        gl::_3_BYTES => 3,
        gl::INT | gl::UNSIGNED_INT | gl::FLOAT | gl::_4_BYTES => 4,
        _ => 0,
    };
    usize::try_from(n).unwrap_or(0).saturating_mul(each)
}

/// Values of `glTexParameterfv` and `glGetTexParameterfv`.
#[must_use]
pub fn tex_parameter(pname: u32) -> usize {
    match pname {
        gl::TEXTURE_BORDER_COLOR => 4,
        gl::TEXTURE_WRAP_S
        | gl::TEXTURE_WRAP_T
        | gl::TEXTURE_WRAP_R
        | gl::TEXTURE_MIN_FILTER
        | gl::TEXTURE_MAG_FILTER
        | gl::TEXTURE_PRIORITY
        | gl::TEXTURE_MIN_LOD
        | gl::TEXTURE_MAX_LOD
        | gl::TEXTURE_BASE_LEVEL
        | gl::TEXTURE_MAX_LEVEL
        | gl::TEXTURE_LOD_BIAS
        | gl::DEPTH_TEXTURE_MODE
        | gl::TEXTURE_COMPARE_MODE
        | gl::TEXTURE_COMPARE_FUNC
        | gl::GENERATE_MIPMAP => 1,
        _ => 0,
    }
}

/// Values of `glTexEnvfv`.
#[must_use]
pub fn tex_env(pname: u32) -> usize {
    match pname {
        gl::TEXTURE_ENV_COLOR => 4,
        gl::TEXTURE_ENV_MODE
        | gl::TEXTURE_LOD_BIAS
        | gl::COMBINE_RGB
        | gl::COMBINE_ALPHA
        | gl::RGB_SCALE
        | gl::ALPHA_SCALE => 1,
        gl::SRC0_RGB..=gl::SRC2_RGB
        | gl::SRC0_ALPHA..=gl::SRC2_ALPHA
        | gl::OPERAND0_RGB..=gl::OPERAND2_RGB
        | gl::OPERAND0_ALPHA..=gl::OPERAND2_ALPHA => 1,
        _ => 0,
    }
}

/// Values of `glTexGenfv`.
#[must_use]
pub fn tex_gen(pname: u32) -> usize {
    match pname {
        gl::OBJECT_PLANE | gl::EYE_PLANE => 4,
        gl::TEXTURE_GEN_MODE => 1,
        _ => 0,
    }
}

/// Numbers of `glMap1`'s control points, from the first to the last; 0 for arguments that are in error.
#[must_use]
pub fn map_1(target: u32, stride: i32, order: i32) -> usize {
    MapTarget::named(target)
        .filter(|of| of.dimensions == 1)
        .map_or(0, |of| of.length([stride, 0], [order, 1]))
}

/// Numbers of `glMap2`'s control points, from the first to the last; 0 for arguments that are in error.
#[must_use]
pub fn map_2(target: u32, stride: [i32; 2], order: [i32; 2]) -> usize {
    MapTarget::named(target)
        .filter(|of| of.dimensions == 2)
        .map_or(0, |of| of.length(stride, order))
}

/// Of `glPixelMap`: the size, or 0 for one that a table can't have.
#[must_use]
pub fn pixel_map(size: i32) -> i32 {
    if (1..=PIXEL_MAP).contains(&size) { size } else { 0 }
}
