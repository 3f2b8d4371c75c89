//! The highest frequency of a body, found from its forces.
//!
//! Lanczos iteration on `M^-1/2 K M^-1/2`, K by differences of the forces around the start: a power iteration that uses
//! all of its iterates, and so needs some forty force evaluations where the plain one needs hundreds for 1 %.

use super::forces::Force;
use super::state::ParticleState;
use glam::DVec3;

const ITERATIONS: usize = 60;
/// The estimate is taken once it rises by less than this share over [`CHECK_EVERY`] iterations.
const SETTLED: f64 = 2e-4;
const CHECK_EVERY: usize = 8;

/// Square of the highest angular frequency [1/s²] of `state` under `forces`; `scale` [m] is the length against which a
/// displacement counts as small. Zero when nothing resists.
pub fn highest_frequency_squared(forces: &mut [Box<dyn Force>], state: &ParticleState, scale: f64) -> f64 {
    let n = state.len();
    let mut probe = state.clone();
    probe.velocities.fill(DVec3::ZERO);
    let mut total = |probe: &ParticleState| {
        let mut sum = vec![DVec3::ZERO; n];
        for force in forces.iter_mut() {
            force.add_forces(0.0, probe, &mut sum);
        }
        sum
    };
    let at_start = total(&probe);
    let root_mass: Vec<f64> = state.masses.iter().map(|mass| mass.sqrt()).collect();
    let mut v = starting_vector(n);
    let mut before = vec![DVec3::ZERO; n];
    let (mut alphas, mut betas): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut beta = 0.0;
    let mut last = 0.0;
    for iteration in 1..=ITERATIONS {
        let longest = v.iter().zip(&root_mass).map(|(v, m)| v.length() / m).fold(0.0, f64::max);
        let step = 1e-6 * scale / longest;
        for i in 0..n {
            probe.positions[i] = state.positions[i] + v[i] * (step / root_mass[i]);
        }
        let moved = total(&probe);
        let mut w: Vec<DVec3> =
            (0..n).map(|i| (at_start[i] - moved[i]) / (step * root_mass[i]) - beta * before[i]).collect();
        let alpha = dot(&w, &v);
        for (w, v) in w.iter_mut().zip(&v) {
            *w -= alpha * *v;
        }
        alphas.push(alpha);
        beta = dot(&w, &w).sqrt();
        if beta <= 1e-12 * alpha.abs() || !beta.is_finite() {
            break;
        }
        betas.push(beta);
        for w in &mut w {
            *w /= beta;
        }
        before = std::mem::replace(&mut v, w);
        if iteration % CHECK_EVERY == 0 {
            let estimate = greatest_eigenvalue(&alphas, &betas);
            if estimate - last < SETTLED * estimate {
                break;
            }
            last = estimate;
        }
    }
    greatest_eigenvalue(&alphas, &betas).max(0.0)
}

/// A fixed unit vector without any symmetry.
fn starting_vector(n: usize) -> Vec<DVec3> {
    // A linear congruential sequence (Knuth's MMIX constants): the same on every machine.
    let mut seed: u64 = 0x5eed;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut v: Vec<DVec3> = (0..n).map(|_| DVec3::new(next(), next(), next())).collect();
    let length = dot(&v, &v).sqrt();
    for v in &mut v {
        *v /= length;
    }
    v
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

/// Greatest eigenvalue of the symmetric tridiagonal matrix with these diagonals, by bisection on Sturm counts.
fn greatest_eigenvalue(diagonal: &[f64], beside: &[f64]) -> f64 {
    let n = diagonal.len();
    let beside = |k: usize| beside.get(k).copied().filter(|_| k + 1 < n).unwrap_or(0.0).abs();
    let radius = |k: usize| beside(k) + if k > 0 { beside(k - 1) } else { 0.0 };
    let mut high = (0..n).map(|k| diagonal[k] + radius(k)).fold(f64::NEG_INFINITY, f64::max);
    let mut low = diagonal.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        // All eigenvalues lie below `middle` exactly if every pivot of T - middle I is negative.
        let mut pivot = diagonal[0] - middle;
        let mut all_below = pivot < 0.0;
        for k in 1..n {
            if !all_below {
                break;
            }
            pivot = diagonal[k] - middle - beside(k - 1).powi(2) / pivot;
            all_below = pivot < 0.0;
        }
        if all_below {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_greatest_eigenvalue_of_a_known_matrix() {
        // 2 on the diagonal, 1 beside it: eigenvalues 2 + 2 cos(k pi / (n + 1)).
        let n = 12;
        let found = greatest_eigenvalue(&vec![2.0; n], &vec![1.0; n - 1]);
        let expected = 2.0 + 2.0 * (std::f64::consts::PI / (n as f64 + 1.0)).cos();
        assert!((found - expected).abs() < 1e-12);
    }
}
