//! Comma-separated numbers: points, directions, matrices.

use super::number::finite;
use luxel_scene::{DMat4, DVec3, DVec4};

/// How far a view matrix may be from a rotation: the rounding error of six printed digits.
const RIGID_TOLERANCE: f64 = 1e-4;

/// `N` finite numbers, separated by commas.
pub(crate) fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let numbers: Vec<f64> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    let count = numbers.len();
    numbers.try_into().map_err(|_| {
        let noun = if count == 1 { "number" } else { "numbers" };
        format!("expected {N} numbers separated by commas, found {count} {noun}")
    })
}

/// A point.
///
/// # Errors
/// Anything but three finite numbers.
pub fn point(text: &str) -> Result<DVec3, String> {
    numbers(text).map(DVec3::from_array)
}

/// A direction of any length but 0, normalized.
///
/// # Errors
/// Anything but three finite numbers, or length 0.
pub fn direction(text: &str) -> Result<DVec3, String> {
    let vector = point(text)?;
    let largest = vector.abs().max_element();
    if largest == 0.0 {
        return Err("a direction must not have length 0".to_owned());
    }
    // A unit vector is returned as written.
    if (vector.length_squared() - 1.0).abs() < 1e-15 {
        return Ok(vector);
    }
    // Dividing first keeps tiny and huge vectors from under- and overflowing when squared.
    Ok((vector / largest).normalize())
}

/// The up direction: an axis by name, or a vector.
///
/// # Errors
/// Anything but an axis or a direction.
pub fn up(text: &str) -> Result<DVec3, String> {
    match text {
        "X" | "x" | "+X" | "+x" => Ok(DVec3::X),
        "Y" | "y" | "+Y" | "+y" => Ok(DVec3::Y),
        "Z" | "z" | "+Z" | "+z" => Ok(DVec3::Z),
        "-X" | "-x" => Ok(DVec3::NEG_X),
        "-Y" | "-y" => Ok(DVec3::NEG_Y),
        "-Z" | "-z" => Ok(DVec3::NEG_Z),
        _ => direction(text).map_err(|message| format!("{message}; or use X, Y or Z")),
    }
}

/// Focal lengths and principal point in pixels: fx, fy above 0, cx, cy anywhere.
///
/// # Errors
/// Anything else.
pub fn intrinsics(text: &str) -> Result<[f64; 4], String> {
    let [fx, fy, cx, cy] = numbers(text)?;
    if fx > 0.0 && fy > 0.0 {
        Ok([fx, fy, cx, cy])
    } else {
        Err("focal lengths must be above 0".to_owned())
    }
}

/// A view matrix, column by column: a rotation and a translation.
///
/// # Errors
/// Anything but sixteen numbers that are a rotation and a translation, to 1e-4.
pub fn view_matrix(text: &str) -> Result<DMat4, String> {
    let matrix = DMat4::from_cols_array(&numbers(text)?);
    if matrix.row(3) != DMat4::IDENTITY.row(3) {
        return Err("its last row must be 0,0,0,1 (numbers go column by column)".to_owned());
    }
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(DVec4::truncate);
    let deviation = [
        x.length() - 1.0,
        y.length() - 1.0,
        z.length() - 1.0,
        x.dot(y),
        y.dot(z),
        z.dot(x),
        x.cross(y).dot(z) - 1.0,
    ];
    // The comparison refuses NaN from overflow, too.
    if deviation.iter().all(|error| error.abs() <= RIGID_TOLERANCE) {
        Ok(rigid(&matrix))
    } else {
        Err("it must be a rotation and a translation, without scale or mirror".to_owned())
    }
}

/// The rigid matrix nearest to one rounded by printing; keeps the position of the eye.
fn rigid(matrix: &DMat4) -> DMat4 {
    let eye = matrix.inverse().w_axis.truncate();
    let x = matrix.x_axis.truncate().normalize();
    let y = matrix.y_axis.truncate();
    let y = (y - x * x.dot(y)).normalize();
    let z = x.cross(y);
    let translation = -(x * eye.x + y * eye.y + z * eye.z);
    let near =
        DMat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), translation.extend(1.0));
    // A rigid matrix is returned as written.
    let is_rotation = |one: &DMat4, other: &DMat4| {
        [(one.x_axis, other.x_axis), (one.y_axis, other.y_axis), (one.z_axis, other.z_axis)]
            .into_iter()
            .all(|(one, other)| one.abs_diff_eq(other, 1e-14))
    };
    if is_rotation(&near, matrix) { *matrix } else { near }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::Camera;

    #[test]
    fn points_may_begin_with_a_minus_and_hold_spaces() {
        assert_eq!(point("-1,.5,1e-7"), Ok(DVec3::new(-1.0, 0.5, 1e-7)));
        assert_eq!(point(" 1, 2 , 3"), Ok(DVec3::new(1.0, 2.0, 3.0)));
    }

    #[test]
    fn points_of_other_lengths_and_without_numbers_are_refused() {
        for text in ["", "1", "1,2", "1,2,3,4", "1,,3", "1;2;3", "a,b,c", "1,2,nan", "inf,0,0"] {
            assert!(point(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_direction_may_be_tiny_or_huge_but_not_zero() {
        for text in ["0,0,-1e-300", "0,0,-1e300", "0,0,-7"] {
            assert_eq!(direction(text), Ok(DVec3::NEG_Z), "{text}");
        }
        assert!(direction("0,0,0").is_err());
        assert!(direction("-0,0,0").is_err());
    }

    #[test]
    fn up_takes_axes_and_vectors() {
        assert_eq!(up("Z"), Ok(DVec3::Z));
        assert_eq!(up("y"), Ok(DVec3::Y));
        assert_eq!(up("0,0,2"), Ok(DVec3::Z));
        assert!(up("W").is_err() && up("0,0,0").is_err());
    }

    #[test]
    fn focal_lengths_are_positive() {
        assert_eq!(intrinsics("500,510,-3,4"), Ok([500.0, 510.0, -3.0, 4.0]));
        assert!(intrinsics("0,500,1,1").is_err() && intrinsics("500,-1,1,1").is_err());
    }

    #[test]
    fn a_printed_view_matrix_reads_back() {
        let view = Camera::look_at(DVec3::new(3.0, 4.0, 5.0), DVec3::ZERO, DVec3::Y);
        let all_digits = view.to_cols_array().map(|number| number.to_string());
        assert_eq!(view_matrix(&all_digits.join(",")), Ok(view));
        let five_digits = view.to_cols_array().map(|number| format!("{number:.5}"));
        assert!(view_matrix(&five_digits.join(",")).unwrap().abs_diff_eq(view, 1e-4));
    }

    #[test]
    fn a_view_matrix_must_be_rigid() {
        let identity = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1";
        assert_eq!(view_matrix(identity), Ok(DMat4::IDENTITY));
        for wrong in [
            "2,0,0,0,0,2,0,0,0,0,2,0,0,0,0,1",     // scale
            "-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1",    // mirror
            "1,0,0,5,0,1,0,0,0,0,1,0,0,0,0,1",     // row by row
            "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0",     // nothing
            "1e300,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", // overflows when squared
            "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0",       // fifteen
        ] {
            assert!(view_matrix(wrong).is_err(), "{wrong}");
        }
    }
}
