//! NumPy arrays into plain numbers, of any dtype that holds them, and back.

use crate::errors::argument;
use numpy::{AllowTypeChange, PyArrayLike, PyArrayLike2, PyUntypedArrayMethods};
use numpy::{Element, IntoPyArray, PyArray, PyArrayMethods};
use pyo3::prelude::*;

/// Rows of N numbers, all finite.
///
/// # Errors
/// `ValueError` for another shape, or a number that is not finite, with its row.
pub(crate) fn rows<const N: usize>(
    name: &str,
    value: &Bound<'_, PyAny>,
) -> PyResult<Vec<[f64; N]>> {
    let array = value
        .extract::<PyArrayLike2<'_, f64, AllowTypeChange>>()
        .map_err(|_| argument(name, format!("expected an array of shape (n, {N})")))?;
    let [count, width] = [array.shape()[0], array.shape()[1]];
    if width != N {
        let found = format!("expected an array of shape (n, {N}), not ({count}, {width})");
        return Err(argument(name, found));
    }
    let rows: Vec<[f64; N]> = match array.as_slice() {
        Ok(numbers) if array.is_c_contiguous() => numbers.as_chunks().0.to_vec(),
        _ => {
            let rows = array.as_array();
            rows.rows().into_iter().map(|row| std::array::from_fn(|column| row[column])).collect()
        }
    };
    // No early exit: valid input is read without branches.
    if rows.as_flattened().iter().fold(true, |all, number| all & number.is_finite()) {
        return Ok(rows);
    }
    let row = rows.iter().position(|row| row.iter().any(|number| !number.is_finite()));
    let row = row.unwrap_or_default();
    Err(argument(name, format!("row {row} has a number that is not finite")))
}

/// Rows of N indices below `count`.
///
/// # Errors
/// `ValueError` for another shape or dtype, or an index out of range, with its row.
pub(crate) fn index_rows<const N: usize>(
    name: &str,
    value: &Bound<'_, PyAny>,
    count: usize,
) -> PyResult<Vec<[u32; N]>> {
    let expected = || argument(name, format!("expected whole numbers of shape (n, {N})"));
    let value = &value.py().import("numpy")?.call_method1("asarray", (value,))?;
    let kind: char = value.getattr("dtype")?.getattr("kind")?.extract()?;
    if !matches!(kind, 'i' | 'u') {
        return Err(expected());
    }
    let array =
        value.extract::<PyArrayLike2<'_, i64, AllowTypeChange>>().map_err(|_| expected())?;
    if array.shape()[1] != N {
        return Err(expected());
    }
    let array = array.as_array();
    let mut rows = Vec::with_capacity(array.nrows());
    for (number, row) in array.rows().into_iter().enumerate() {
        let mut indices = [0; N];
        for (index, &given) in indices.iter_mut().zip(row) {
            *index = u32::try_from(given)
                .ok()
                .filter(|&index| (index as usize) < count)
                .ok_or_else(|| {
                    let there = format!("row {number} names vertex {given}; there are {count}");
                    argument(name, there)
                })?;
        }
        rows.push(indices);
    }
    Ok(rows)
}

/// A 4x4 matrix, by columns.
///
/// # Errors
/// `ValueError` for anything but sixteen finite numbers in four rows.
pub(crate) fn matrix(name: &str, value: &Bound<'_, PyAny>) -> PyResult<[[f64; 4]; 4]> {
    let rows = rows::<4>(name, value)?;
    let rows: [[f64; 4]; 4] = rows
        .try_into()
        .map_err(|rows: Vec<_>| argument(name, format!("expected 4 rows, not {}", rows.len())))?;
    Ok(std::array::from_fn(|column| std::array::from_fn(|row| rows[row][column])))
}

/// A sequence of numbers, if it is one.
pub(crate) fn numbers(value: &Bound<'_, PyAny>) -> Option<Vec<f64>> {
    let array = value.extract::<PyArrayLike<'_, f64, numpy::Ix1, AllowTypeChange>>().ok()?;
    Some(array.as_array().iter().copied().collect())
}

/// N numbers.
///
/// # Errors
/// `ValueError` for anything else.
pub(crate) fn vector<const N: usize>(name: &str, value: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let expected = || argument(name, format!("expected {N} finite numbers"));
    let numbers = numbers(value).ok_or_else(expected)?;
    let numbers: [f64; N] = numbers.try_into().map_err(|_| expected())?;
    if numbers.iter().all(|number| number.is_finite()) { Ok(numbers) } else { Err(expected()) }
}

/// Numbers as an array of this shape, without a copy.
pub(crate) fn array<'py, T: Element>(
    py: Python<'py>,
    numbers: Vec<T>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    let flat: Bound<'py, PyArray<T, numpy::Ix1>> = numbers.into_pyarray(py);
    Ok(flat.reshape(shape)?.into_any())
}
