//! The core's errors as Python's.

use pyo3::PyErr;
use pyo3::exceptions::PyValueError;
use std::fmt;

/// A refusal of the core as Python's exception, in the same words.
pub(crate) fn refused(error: impl fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}
