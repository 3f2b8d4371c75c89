//! Fibres: rods that bend and stretch (sec. 4.1), riding on the material particles.
//!
//! Per edge `l_f (EA / 2 l0) (|e| - l0)²`; per inner vertex `l_f (EI / L0) |kb - R_s kb0|²` with the curvature binormal
//! of eq. 6, `L0` the rest lengths of both edges and `R_s` the turn of the material around the vertex. The gradients
//! are exact: the paper's own (the centre vertex's, with half reactions on its neighbours) is 28 to 56 % off and makes
//! torque. A straight rest shape needs no `R_s`: `l_f (4 EI / L0) (1 - c) / (1 + c)`, c the cosine of the turn.
//!
//! A fibre may resist twist (`twist`), and drives may act on it (`activation`): it wants to be shorter, to curl or to
//! be twisted, or pulls as a muscle does (`muscle`).
//!
//! Edge by edge and bend by bend these are `elements`; all fibres of a body together are evaluated in packed loops,
//! which keep the same contract.
//!
//! Eq. 7 is half of Bergou's energy, so that EI is the paper's `K_b / 2`. The energy of eq. 6 is unbounded where a
//! fibre folds back on itself; below `c = -1/2` it continues linearly in c.

mod activation;
mod activity;
mod as_elements;
mod band;
pub(in crate::solver::forces) mod between;
mod break_limits;
pub(crate) mod breaking;
mod corner;
mod curved_bends;
pub(in crate::solver::forces) mod elements;
mod energies;
mod fibre_embedding;
mod force;
pub(in crate::solver) mod implicit;
pub(in crate::solver::forces) mod material_turn;
mod muscle;
mod packed_rods;
mod rest;
mod soa;
mod strip;
mod tension;
mod twist;
mod twisting;
mod yield_limits;
mod yielding;

pub(crate) use activation::FibreActivation;
pub use force::FibreForce;
pub(crate) use muscle::Muscle;
pub use rest::FibreRest;
pub(crate) use twist::FibreTwist;
pub(crate) use yield_limits::YieldLimits;
