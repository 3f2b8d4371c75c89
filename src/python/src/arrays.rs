//! Lists of the core as NumPy arrays.

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// Points or vectors as rows, `(n, 3)`.
pub(crate) fn rows<'py>(
    py: Python<'py>,
    points: impl IntoIterator<Item = [f64; 3]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat: Vec<f64> = points.into_iter().flatten().collect();
    let count = flat.len() / 3;
    PyArray1::from_vec(py, flat).reshape([count, 3])
}

/// Numbers, `(n,)`.
pub(crate) fn numbers(py: Python<'_>, values: Vec<f64>) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_vec(py, values)
}
