//! The greatest step at which an integrator keeps one oscillation `x'' = -w² x - c x'` from growing.

/// Growth a step that passes for none.
const GROWTH_A_STEP: f64 = 2e-4;

/// Growth of the amplitude that passes for none in a second [1/s]: the energy of an undamped oscillation grows under
/// explicit Euler and midpoint at any step, and by a hundredth in a second at this one.
const GROWTH_A_SECOND: f64 = 5e-3;

/// Share of a step over the fastest rate below which none is looked for.
const SHORTEST: f64 = 1e-11;

/// Greatest step [s] up to which the spectral radius `radius_at(step)` does not exceed one, for an oscillation of
/// angular frequency `omega` [rad/s] with damping rate `damping` [1/s]; infinite where there is none.
pub(super) fn greatest_step(omega: f64, damping: f64, radius_at: impl Fn(f64) -> f64) -> f64 {
    const RATIO: f64 = 1.02;
    let fastest = omega.max(damping);
    if fastest <= 0.0 {
        return f64::INFINITY;
    }
    let grows = |step: f64| radius_at(step) > 1.0 + GROWTH_A_STEP.min(GROWTH_A_SECOND * step);
    let mut stable = 1e-3 / fastest;
    while grows(stable) && stable * fastest > SHORTEST {
        stable *= 0.5;
    }
    while !grows(stable * RATIO) {
        stable *= RATIO;
        if stable * fastest > 1e6 {
            return f64::INFINITY;
        }
    }
    let mut unstable = stable * RATIO;
    for _ in 0..40 {
        let middle = 0.5 * (stable + unstable);
        if grows(middle) {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    stable
}

/// [`greatest_step`] of a Runge-Kutta method whose stability function is `1 + z + ... ` with these coefficients of
/// z, z², ...
pub(super) fn greatest_step_of(coefficients: &[f64], omega: f64, damping: f64) -> f64 {
    // Both roots of l² + c l + w² = 0.
    let half = 0.5 * damping;
    let square = half * half - omega * omega;
    let roots = if square >= 0.0 {
        [(-half - square.sqrt(), 0.0), (-half + square.sqrt(), 0.0)]
    } else {
        [(-half, (-square).sqrt()); 2]
    };
    greatest_step(omega, damping, |step| {
        let value = |(re, im): (f64, f64)| {
            let (x, y) = (step * re, step * im);
            // Horner's rule from the highest power down, then once more for the leading 1.
            let (re, im) = coefficients.iter().rev().fold((0.0, 0.0), |(re, im), &k: &f64| {
                let (re, im) = (re + k, im);
                (re * x - im * y, re * y + im * x)
            });
            (1.0 + re).hypot(im)
        };
        value(roots[0]).max(value(roots[1]))
    })
}

/// Greatest magnitude of the eigenvalues of a 2 x 2 matrix.
pub(super) fn spectral_radius([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    let (half, determinant) = (0.5 * (a + d), a * d - b * c);
    let square = half * half - determinant;
    if square >= 0.0 { half.abs() + square.sqrt() } else { determinant.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn textbook_limits() {
        // Explicit Euler: c / w² under-damped, 2 / l over-damped; Runge-Kutta 4: 2.785 and 2.828.
        assert!((greatest_step_of(&[1.0], 40.0, 30.0) - 30.0 / 1600.0).abs() < 2e-5);
        assert!((greatest_step_of(&[1.0], 1e-6, 10.0) - 0.2).abs() < 1e-4);
        let rk4 = [1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0];
        assert!((greatest_step_of(&rk4, 1e-6, 1.0) - 2.785).abs() < 2e-3);
        assert!((greatest_step_of(&rk4, 1.0, 0.0) - 8.0_f64.sqrt()).abs() < 2e-3);
        assert_eq!(greatest_step_of(&rk4, 0.0, 0.0), f64::INFINITY);
        // Undamped, explicit Euler grows by `w² dt / 2` in a second, midpoint by `w⁴ dt³ / 8`.
        for omega in [30.0, 1e3, 3e4_f64] {
            let euler = 2.0 * GROWTH_A_SECOND / (omega * omega);
            assert!((greatest_step_of(&[1.0], omega, 0.0) / euler - 1.0).abs() < 0.01, "{omega}");
            let midpoint = (8.0 * GROWTH_A_SECOND / omega.powi(4)).cbrt();
            assert!((greatest_step_of(&[1.0, 0.5], omega, 0.0) / midpoint - 1.0).abs() < 0.01, "{omega}");
        }
        assert!((spectral_radius([[0.0, 2.0], [-2.0, 0.0]]) - 2.0).abs() < 1e-15);
    }
}
