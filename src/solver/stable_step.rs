//! The highest frequency of a body, found from its forces.
//!
//! By Lanczos iteration on `M^-1/2 K M^-1/2`, K by differences of the forces around the start.

use super::forces::{Force, total_forces};
use super::linear_algebra::lanczos::greatest_eigenvalue;
use super::linear_algebra::vectors::normalise;
use super::state::ParticleState;
use glam::DVec3;

/// Square of the highest angular frequency [1/s²] of `state` under `forces`; `scale` [m] is the length against which a
/// displacement counts as small. Zero when nothing resists; none where `stop`, asked again and again, says that it is
/// no longer wanted.
pub(crate) fn highest_frequency_squared(
    forces: &mut [Box<dyn Force>],
    state: &ParticleState,
    scale: f64,
    stop: &mut dyn FnMut() -> bool,
) -> Option<f64> {
    let n = state.len();
    let mut probe = state.clone();
    probe.velocities.fill(DVec3::ZERO);
    let at_start = total_forces(forces, &probe);
    let root_mass: Vec<f64> = state.masses.iter().map(|mass| mass.sqrt()).collect();
    let stiffness = |v: &[DVec3]| {
        let longest = v.iter().zip(&root_mass).map(|(v, m)| v.length() / m).fold(0.0, f64::max);
        let step = 1e-6 * scale / longest;
        for i in 0..n {
            probe.positions[i] = state.positions[i] + v[i] * (step / root_mass[i]);
        }
        let moved = total_forces(forces, &probe);
        (0..n).map(|i| (at_start[i] - moved[i]) / (step * root_mass[i])).collect()
    };
    greatest_eigenvalue(starting_vector(n), stiffness, stop).map(|greatest| greatest.max(0.0))
}

/// A fixed unit vector without any symmetry.
pub(super) fn starting_vector(n: usize) -> Vec<DVec3> {
    // A linear congruential sequence (Knuth's MMIX constants): the same on every machine.
    let mut seed: u64 = 0x5eed;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut v: Vec<DVec3> = (0..n).map(|_| DVec3::new(next(), next(), next())).collect();
    normalise(&mut v);
    v
}
