//! The fastest modes of a body, damping included, and the greatest step at which an integrator keeps all from growing.
//!
//! Arnoldi iteration on the linearised motion `(x, v)' = (v, -M^-1 K x - M^-1 C v)` around a state, K and C by
//! differences of the forces: forty or so evaluations find the modes that set the limit. Unlike the highest frequency
//! alone (`stable_step`) it sees which mode is damped how, on which the limit of a two-layer body depends.

use super::forces::{Force, total_forces};
use super::integrators::Integrator;
use super::linear_algebra::arnoldi::{KrylovSpace, krylov_space};
use super::linear_algebra::hessenberg::{Complex, eigenvalues, eigenvector};
use super::linear_algebra::vectors::{axpy, dot, normalise};
use super::stable_step::highest_frequency_squared;
use super::state::ParticleState;
use glam::DVec3;

/// One mode: `x'' = -w² x - c x'`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mode {
    /// Angular frequency w of the undamped mode [rad/s].
    pub frequency: f64,
    /// Damping rate c [1/s].
    pub damping: f64,
}

/// Size of the Krylov space at most.
const MOST_VECTORS: usize = 70;

/// Modes slower than this share of the fastest set no step, and rigid motions among them only look like growth.
const SLOW: f64 = 0.02;

/// A mode is taken once its residual is below this share of the fastest rate.
const RESIDUAL: f64 = 5e-3;

/// Eigenvalues nearer to the real axis than this share of the fastest are real.
const REAL: f64 = 1e-6;

/// More than this many real modes are not paired: the fastest ones set the step.
const REAL_MODES: usize = 3;

/// The fastest modes of `state` under `forces`, around the velocity zero; `scale` [m] is the length against which a
/// displacement counts as small. No modes where nothing resists; none at all where `stop`, asked again and again, says
/// that they are no longer wanted.
pub(crate) fn fastest_modes(
    forces: &mut [Box<dyn Force>],
    state: &ParticleState,
    scale: f64,
    stop: &mut dyn FnMut() -> bool,
) -> Option<Modes> {
    let stiffest = highest_frequency_squared(forces, state, scale, stop)?.sqrt();
    let rate = forces.iter().map(|force| force.step_limit(state).damping_rate).fold(stiffest, f64::max);
    if rate <= 0.0 {
        return Some(Modes::default());
    }
    Linearised::new(forces, state, scale, rate).modes(stop)
}

/// Modes and what moves in them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Modes {
    found: Vec<(Mode, Vec<Complex>)>,
    /// Of displacements times the root of the mass; the modes are sums of these.
    basis: Vec<Vec<DVec3>>,
    /// Rate by which displacements are scaled against velocities [1/s].
    rate: f64,
}

/// What moves in a mode, times the root of the mass: the parts in phase and a quarter of a swing behind.
#[derive(Clone, Debug)]
pub(crate) struct ModeShape([Vec<DVec3>; 2]);

impl Modes {
    /// Greatest step [s] at which `integrator` keeps every mode from growing, where a drag that small motions do not
    /// show may brake them by up to `drag` [1/s] more.
    pub(crate) fn greatest_stable_step(&self, integrator: &dyn Integrator, drag: f64) -> f64 {
        greatest_stable_step(integrator, self.found.iter().map(|(mode, _)| *mode), drag)
    }

    /// The shapes of the modes that would grow first, `most` at most.
    pub(crate) fn limiting(&self, integrator: &dyn Integrator, most: usize) -> Vec<ModeShape> {
        let mut order: Vec<(f64, &[Complex])> = self
            .found
            .iter()
            .map(|(mode, vector)| (integrator.stable_step(mode.frequency, mode.damping), vector.as_slice()))
            .collect();
        order.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        order.into_iter().take(most).map(|(_, vector)| ModeShape(combined(vector, &self.basis))).collect()
    }

    /// What becomes of modes of these shapes under other forces: their Rayleigh quotients, exact to second order in
    /// what the shapes would change by.
    pub(crate) fn under(
        &self,
        forces: &mut [Box<dyn Force>],
        state: &ParticleState,
        scale: f64,
        shapes: &[ModeShape],
    ) -> Vec<Mode> {
        let mut linearised = Linearised::new(forces, state, scale, self.rate);
        shapes.iter().map(|ModeShape(parts)| linearised.quotients(parts)).collect()
    }
}

/// [`Modes::greatest_stable_step`] of some modes.
pub(crate) fn greatest_stable_step(
    integrator: &dyn Integrator,
    modes: impl IntoIterator<Item = Mode>,
    drag: f64,
) -> f64 {
    let step = |frequency: f64, damping: f64| integrator.stable_step(frequency, damping);
    let braked = |mode: Mode| {
        let step_of_its_own = step(mode.frequency, mode.damping);
        if drag > 0.0 { step_of_its_own.min(step(mode.frequency, mode.damping + drag)) } else { step_of_its_own }
    };
    let alone = if drag > 0.0 { step(0.0, drag) } else { f64::INFINITY };
    modes.into_iter().map(braked).fold(alone, f64::min)
}

/// The sum of base vectors by complex shares, its common phase such that the greatest share is real.
fn combined(shares: &[Complex], basis: &[Vec<DVec3>]) -> [Vec<DVec3>; 2] {
    let largest = shares.iter().copied().fold(Complex::default(), |a, b| if b.abs() > a.abs() { b } else { a });
    let mut parts = [vec![DVec3::ZERO; basis[0].len()], vec![DVec3::ZERO; basis[0].len()]];
    for (share, base) in shares.iter().zip(basis) {
        let turned = [share.re * largest.re + share.im * largest.im, share.im * largest.re - share.re * largest.im];
        for (part, share) in parts.iter_mut().zip(turned) {
            axpy(share / largest.abs(), base, part);
        }
    }
    parts
}

/// The motion around a state, in variables in which both halves weigh the same: `(rate sqrt(m) x, sqrt(m) v)`.
struct Linearised<'a> {
    forces: &'a mut [Box<dyn Force>],
    state: &'a ParticleState,
    probe: ParticleState,
    at_rest: Vec<DVec3>,
    root_masses: Vec<f64>,
    rate: f64,
    scale: f64,
}

impl<'a> Linearised<'a> {
    fn new(forces: &'a mut [Box<dyn Force>], state: &'a ParticleState, scale: f64, rate: f64) -> Self {
        let mut probe = state.clone();
        probe.velocities.fill(DVec3::ZERO);
        let root_masses = state.masses.iter().map(|mass| mass.sqrt()).collect();
        let mut linearised = Self { forces, state, probe, at_rest: Vec::new(), root_masses, rate, scale };
        linearised.at_rest = total_forces(linearised.forces, &linearised.probe);
        linearised
    }

    /// The rate of change of a small motion, both in the scaled variables.
    fn apply(&mut self, y: &[DVec3]) -> Vec<DVec3> {
        let n = self.state.len();
        let largest = y.iter().map(|v| v.length()).fold(0.0, f64::max);
        let lightest = self.root_masses.iter().copied().fold(f64::INFINITY, f64::min);
        // The largest displacement becomes a millionth of the scale, velocities follow.
        let step = 1e-6 * self.scale * self.rate * lightest / largest;
        for i in 0..n {
            self.probe.positions[i] = self.state.positions[i] + y[i] * (step / (self.rate * self.root_masses[i]));
            self.probe.velocities[i] = y[n + i] * (step / self.root_masses[i]);
        }
        let moved = total_forces(self.forces, &self.probe);
        let mut out: Vec<DVec3> = y[n..].iter().map(|&v| self.rate * v).collect();
        out.extend((0..n).map(|i| (moved[i] - self.at_rest[i]) / (step * self.root_masses[i])));
        out
    }

    fn modes(mut self, stop: &mut dyn FnMut() -> bool) -> Option<Modes> {
        let most = MOST_VECTORS.min(6 * self.state.len());
        let (start, rate) = (starting_vector(2 * self.state.len()), self.rate);
        let KrylovSpace { mut basis, matrix, residual } = krylov_space(start, most, rate, |y| self.apply(y), stop)?;
        // From here on only displacements are asked for.
        for base in &mut basis {
            base.truncate(self.state.len());
        }
        let values = eigenvalues(&matrix);
        let fastest = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
        // One of each conjugate pair; real ones lie on either side of the axis by round-off.
        let on_axis = REAL * fastest;
        let found: Vec<(Complex, Vec<Complex>)> = values
            .into_iter()
            .filter(|value| value.im >= -on_axis && value.abs() > SLOW * fastest)
            .map(|value| (value, eigenvector(&matrix, value)))
            .filter(|(_, vector)| vector.last().map_or(0.0, |last| last.abs()) * residual <= RESIDUAL * fastest)
            .collect();
        let (mut real, swinging): (Vec<_>, Vec<_>) = found.into_iter().partition(|(value, _)| value.im <= on_axis);
        let mode = |value: Complex| Mode { frequency: value.abs(), damping: at_least_zero(-2.0 * value.re) };
        let mut found: Vec<_> = swinging.into_iter().map(|(value, vector)| (mode(value), vector)).collect();
        real.sort_by(|(a, _), (b, _)| a.re.total_cmp(&b.re));
        for (value, vector) in real.into_iter().take(REAL_MODES) {
            if let Some(mode) = self.overdamped(value.re, &combined(&vector, &basis)[0]) {
                found.push((mode, vector));
            }
        }
        Some(Modes { found, basis, rate: self.rate })
    }

    /// The mode to which a real eigenvalue belongs: its stiffness is its vector's Rayleigh quotient.
    fn overdamped(&mut self, value: f64, shape: &[DVec3]) -> Option<Mode> {
        let square = dot(shape, shape);
        if square <= 0.0 {
            return None;
        }
        let [stiffness, _] = self.resistance(shape).map(|resistance| resistance / square);
        let damping = at_least_zero(-(value * value + stiffness) / value);
        Some(Mode { frequency: stiffness.max(0.0).sqrt(), damping })
    }

    /// What a shape of these two parts resists with.
    fn quotients(&mut self, parts: &[Vec<DVec3>; 2]) -> Mode {
        let mut sums = [0.0; 3];
        for part in parts.iter().filter(|part| dot(part, part) > 0.0) {
            let [stiffness, damping] = self.resistance(part);
            for (sum, value) in sums.iter_mut().zip([dot(part, part), stiffness, damping]) {
                *sum += value;
            }
        }
        let [square, stiffness, damping] = sums;
        Mode { frequency: (stiffness / square).max(0.0).sqrt(), damping: at_least_zero(damping / square) }
    }

    /// `y . M^-1/2 K M^-1/2 y` [1/s²] and `y . M^-1/2 C M^-1/2 y` [1/s].
    fn resistance(&mut self, y: &[DVec3]) -> [f64; 2] {
        let n = y.len();
        let still = vec![DVec3::ZERO; n];
        let pull = self.apply(&[y, &still].concat());
        let brake = self.apply(&[&still, y].concat());
        [-self.rate * dot(y, &pull[n..]), -dot(y, &brake[n..])]
    }
}

/// No force of a body at rest drives its motion: growth this close to none is the rounding of the differences.
fn at_least_zero(damping: f64) -> f64 {
    damping.max(0.0)
}

/// A fixed unit vector without any symmetry.
fn starting_vector(n: usize) -> Vec<DVec3> {
    let mut v: Vec<DVec3> = (0..n)
        .map(|i| {
            let at = i as f64 + 1.0;
            DVec3::new((1.7 * at).sin(), (2.3 * at * at.sqrt()).cos(), (0.9 * at + at.sqrt()).sin())
        })
        .collect();
    normalise(&mut v);
    v
}
