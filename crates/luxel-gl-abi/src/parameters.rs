//! Parameters that come as one value, or as integers.

use crate::memory::Few;
use luxel_gl::convert;

/// The pnames whose integers are colours: mapped onto [-1, 1] by table 2.9, where others are taken as they are.
const COLORS: [u32; 9] = [
    0x0B53, // GL_LIGHT_MODEL_AMBIENT
    0x0B66, // GL_FOG_COLOR
    0x1004, // GL_TEXTURE_BORDER_COLOR
    0x1200, // GL_AMBIENT
    0x1201, // GL_DIFFUSE
    0x1202, // GL_SPECULAR
    0x1600, // GL_EMISSION
    0x1602, // GL_AMBIENT_AND_DIFFUSE
    0x2201, // GL_TEXTURE_ENV_COLOR
];

/// The value of a command like glLightf: of a pname of several values the first one, the others 0, as in Mesa; none for
/// a name that isn't one.
pub(crate) fn single(value: &f32, length: usize) -> &[f32] {
    if length > 0 { std::slice::from_ref(value) } else { &[] }
}

/// The values of a command like glLightiv.
pub(crate) fn from_integers(pname: u32, values: &Few<i32>) -> Few<f32> {
    if COLORS.contains(&pname) {
        values.map(convert::int)
    } else {
        values.map(|value| value as f32)
    }
}
