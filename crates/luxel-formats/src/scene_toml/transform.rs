//! The transform of a model: scale, rotate, translate, or a matrix.

use super::document::Table;
use super::keys::ROTATE;
use crate::Error;
use crate::values::{finite, numbers, point, up};
use glam::{DMat4, DVec3};

/// A model's transform to its parent.
pub(super) fn transform(table: &Table<'_>) -> Result<DMat4, Error> {
    if let Some(matrix) = table.value("matrix", affine)? {
        if let Some(other) = ["scale", "rotate", "translate"].into_iter().find(|key| table.has(key))
        {
            return Err(table.error_at(other, format!("`{other}` and `matrix` exclude each other")));
        }
        return Ok(matrix);
    }
    let scale = table.value("scale", scale)?.unwrap_or(DVec3::ONE);
    let translation = table.value("translate", point)?.unwrap_or_default();
    let rotation = match table.table("rotate", &ROTATE)? {
        Some(turn) => {
            let axis = turn.value("axis", up)?.unwrap_or(DVec3::Y);
            let degrees = turn.value("degrees", finite)?.unwrap_or_default();
            DMat4::from_axis_angle(axis, degrees.to_radians())
        }
        None => DMat4::IDENTITY,
    };
    Ok(DMat4::from_translation(translation) * rotation * DMat4::from_scale(scale))
}

/// One factor for all axes or one per axis, none of them 0.
fn scale(text: &str) -> Result<DVec3, String> {
    let factors = if text.contains(',') { point(text)? } else { DVec3::splat(finite(text)?) };
    if factors.to_array().contains(&0.0) {
        Err("the scale must not be 0".to_owned())
    } else {
        Ok(factors)
    }
}

/// An invertible affine matrix.
fn affine(text: &str) -> Result<DMat4, String> {
    let matrix = DMat4::from_cols_array(&numbers(text)?);
    if matrix.row(3) != DMat4::IDENTITY.row(3) {
        return Err("its last row must be 0,0,0,1 (numbers go column by column)".to_owned());
    }
    let determinant = matrix.determinant();
    if determinant == 0.0 || !determinant.is_finite() {
        return Err("the matrix must be invertible".to_owned());
    }
    Ok(matrix)
}
