//! The filters, which turn decoded integers into normals, rotations and floats.

/// Applies a filter to elements of `stride` bytes, in place.
pub(super) fn apply(filter: &str, bytes: &mut [u8], stride: usize) -> Result<(), String> {
    let wants = |strides: &str| Err(format!("{filter} needs a stride of {strides}, not {stride}"));
    match (filter, stride) {
        ("NONE", _) => {}
        ("OCTAHEDRAL", 4) => {
            for element in bytes.as_chunks_mut::<4>().0 {
                let [x, y, one, _] = element.map(|byte| f32::from(byte as i8));
                let normal = from_octahedron(x, y, one, 127.0);
                element[..3].copy_from_slice(&normal.map(|value| value as i8 as u8));
            }
        }
        ("OCTAHEDRAL", 8) => {
            for element in bytes.as_chunks_mut::<8>().0 {
                let [x, y, one, _] = words(element).map(f32::from);
                let [x, y, z] = from_octahedron(x, y, one, 32_767.0).map(|value| value as i16);
                let [_, _, _, last] = words(element);
                write_words(element, [x, y, z, last]);
            }
        }
        ("OCTAHEDRAL", _) => return wants("4 or 8"),
        ("QUATERNION", 8) => {
            for element in bytes.as_chunks_mut::<8>().0 {
                let rotation = from_largest_component(words(element));
                write_words(element, rotation);
            }
        }
        ("QUATERNION", _) => return wants("8"),
        ("EXPONENTIAL", _) => {
            for word in bytes.as_chunks_mut::<4>().0 {
                *word = exponential(i32::from_le_bytes(*word)).to_le_bytes();
            }
        }
        _ => return Err(format!("`{filter}` is not a filter of the extension")),
    }
    Ok(())
}

fn words(element: &[u8; 8]) -> [i16; 4] {
    let (words, _) = element.as_chunks::<2>();
    [0, 1, 2, 3].map(|index| i16::from_le_bytes(words[index]))
}

fn write_words(element: &mut [u8; 8], words: [i16; 4]) {
    for (to, word) in element.as_chunks_mut::<2>().0.iter_mut().zip(words) {
        *to = word.to_le_bytes();
    }
}

/// Half away from zero, as the appendix rounds. Casts of the result saturate; NaN becomes 0.
fn rounded(value: f32) -> f32 {
    (value + if value >= 0.0 { 0.5 } else { -0.5 }).trunc()
}

/// A unit vector, times `full`, from a point of the unfolded octahedron whose edge is `one` long.
fn from_octahedron(x: f32, y: f32, one: f32, full: f32) -> [f32; 3] {
    let z = one - x.abs() - y.abs();
    // The lower half is folded outwards.
    let fold = z.min(0.0);
    let x = x + if x >= 0.0 { fold } else { -fold };
    let y = y + if y >= 0.0 { fold } else { -fold };
    let scale = full / (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|value| rounded(value * scale))
}

/// A quaternion of which the largest component is left out; two bits give its place.
fn from_largest_component(words: [i16; 4]) -> [i16; 4] {
    let [x, y, z, last] = words;
    let scale = std::f32::consts::FRAC_1_SQRT_2 / f32::from(last | 3);
    let [x, y, z] = [x, y, z].map(|word| f32::from(word) * scale);
    let w = (1.0 - x * x - y * y - z * z).max(0.0).sqrt();
    let mut rotation = [0; 4];
    for (step, value) in [w, x, y, z].into_iter().enumerate() {
        let place = (usize::from(last as u16 & 3) + step) & 3;
        rotation[place] = rounded(value * 32_767.0) as i16;
    }
    rotation
}

/// 2^e m, with e in the upper 8 bits and m in the lower 24, both signed.
fn exponential(word: i32) -> f32 {
    let exponent = i64::from(word >> 24);
    let mantissa = f64::from(word << 8 >> 8);
    let power = f64::from_bits(((1023 + exponent) as u64) << 52);
    (mantissa * power) as f32
}
