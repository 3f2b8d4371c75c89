//! Sheets: surfaces that resist stretch, shear and bending, riding on the material particles (sec. 7 of the fibre
//! paper: "other structures e.g. plane or shell ... can be implemented in the same way").
//!
//! Per triangle a corotated membrane: `F = [x1 - x0, x2 - x0] Dm⁻¹` (3 x 2), `F = R U`, `e = U - I`, `l_s A (mu e:e +
//! lambda/2 tr(e)²)` with `2 mu = Et / (1 + nu)` and `lambda = nu Et / (1 - nu²)` of plane stress; with a grain along
//! m, `l_s A Et_m / 2 (|F m| - 1)²` beside it ([`membrane`]). Per edge between two triangles a hinge, `k/2 (theta -
//! theta0)²` (Grinspun et al. 2003, *Discrete shells*), with weights under which a flat grid bends alike in all
//! directions ([`hinge`]). The gradients are exact, so that momentum and angular momentum stay.
//!
//! A drive makes a sheet want to be shorter: it changes the metric at rest, `Dm -> diag(1 - c_u, 1 - c_v) Dm`, and A
//! with it. Or it makes it want to curl: theta0 of every hinge is then that of a surface with these curvatures beside
//! the one at rest.

mod activity;
mod as_elements;
pub(in crate::solver::forces) mod elements;
mod force;
pub(in crate::solver::forces) mod hinge;
mod membrane;
mod rest;

pub use force::SheetForce;
pub(crate) use rest::SheetDrive;
pub use rest::{SheetLaw, SheetRest};
