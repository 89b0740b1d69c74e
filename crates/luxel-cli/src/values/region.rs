//! Regions of the image: `X,Y,W,H` and `X,Y,X,Y,...`.

use luxel::formats::values::finite;

/// A rectangle: upper left corner and size in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

fn numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(finite).collect()
}

/// A rectangle of a size above 0.
pub(crate) fn rectangle(text: &str) -> Result<Rectangle, String> {
    let numbers = numbers(text)?;
    let [x, y, width, height] = numbers[..] else {
        return Err("use four numbers separated by commas: X,Y,W,H".to_owned());
    };
    if width > 0.0 && height > 0.0 {
        Ok(Rectangle { x, y, width, height })
    } else {
        Err("width and height must be above 0".to_owned())
    }
}

/// A polygon's corners.
pub(crate) fn lasso(text: &str) -> Result<Vec<[f64; 2]>, String> {
    let numbers = numbers(text)?;
    let (corners, rest) = numbers.as_chunks::<2>();
    if rest.is_empty() && corners.len() >= 3 {
        Ok(corners.to_vec())
    } else {
        Err("use at least three corners, all numbers separated by commas: X,Y,X,Y,X,Y".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_has_a_corner_and_a_size() {
        let expected = Rectangle { x: -1.5, y: 2.0, width: 3.0, height: 0.5 };
        assert_eq!(rectangle("-1.5,2,3,.5"), Ok(expected));
        for text in ["", "1,2,3", "1,2,0,4", "1,2,3,-4", "1,2,3,4,5", "nan,0,1,1"] {
            assert!(rectangle(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_polygon_has_three_corners_at_least() {
        assert_eq!(lasso("0,0,1,0,0,1"), Ok(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]));
        for text in ["0,0,1,0", "0,0,1,0,0", "0,0,1,0,0,x"] {
            assert!(lasso(text).is_err(), "{text}");
        }
    }
}
