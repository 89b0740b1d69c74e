//! Normalization of directions.

/// The normalized vector; 0 if it has no direction.
pub(crate) fn unit(vector: [f32; 3]) -> [f32; 3] {
    let [x, y, z] = vector.map(f64::from);
    let length = (x * x + y * y + z * z).sqrt();
    if length > 0.0 && length.is_finite() {
        [x, y, z].map(|value| (value / length) as f32)
    } else {
        [0.0; 3]
    }
}
