//! Arguments of the commands that specify evaluators, as lists keep them (OpenGL 1.5, section 5.1).

/// The arguments of `glMap1` or `glMap2`.
#[derive(Clone, Debug)]
pub(crate) struct MapCall {
    pub(crate) target: u32,
    pub(crate) dimensions: usize,
    /// From and to, in u and v.
    pub(crate) domain: [[f64; 2]; 2],
    /// Numbers from one point to the next.
    pub(crate) stride: [i32; 2],
    pub(crate) order: [i32; 2],
    pub(crate) points: Box<[f64]>,
}
