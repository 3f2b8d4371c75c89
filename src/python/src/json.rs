//! Values between Python and JSON, by Python's own `json`.

use crate::error::refused;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;

/// The JSON text of a Python value; what has a `tolist`, as NumPy's numbers and arrays have, is taken as that.
pub(crate) fn text_of(value: &Bound<'_, PyAny>) -> PyResult<String> {
    let py = value.py();
    let options = PyDict::new(py);
    options.set_item("default", py.import("operator")?.call_method1("methodcaller", ("tolist",))?)?;
    options.set_item("allow_nan", false)?;
    py.import("json")?.call_method("dumps", (value,), Some(&options))?.extract()
}

/// The Python value of something that can be JSON: dictionaries, lists, numbers, text.
pub(crate) fn value_of<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).map_err(refused)?;
    py.import("json")?.call_method1("loads", (text,))
}
