//! sinew for Python: a scene is read, changed by pointers and run frame by frame; positions, velocities and stresses
//! come as NumPy arrays. Numbers are SI, arrays of points have a row a particle: `(n, 3)`. Arrays are copies: what is
//! done to them moves nothing.
//!
//! ```python
//! import sinew
//!
//! scene = sinew.load("scenes/cantilever.json")
//! for modulus in [5e5, 1e6, 2e6]:
//!     scene["/bodies/0/material/young_modulus"] = modulus
//!     run = sinew.Simulation(scene)
//!     run.until_rest()
//!     print(modulus, run.measures["sag"])
//! ```

mod arrays;
mod error;
mod json;
mod scene;
mod simulation;

use pyo3::prelude::*;

/// Soft solids with fibres: scenes in, motion and measures out.
#[pymodule(name = "sinew")]
mod module {
    #[pymodule_export]
    use crate::scene::{Scene, from_json, load};
    #[pymodule_export]
    use crate::simulation::Simulation;
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
