//! What an integrator makes of a steady swing.

use super::body::{Body, BodyParts, RestScale};
use super::energy::Energies;
use super::forces::{ContactLaw, Force};
use super::integrators::Integrator;
use super::state::ParticleState;
use glam::DVec3;

/// An undamped oscillation as it comes out in steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// Angular frequency [rad/s].
    pub frequency: f64,
    /// Rate at which its amplitude falls [1/s]; negative where it grows.
    pub decay: f64,
}

/// Radians between the values that are looked at.
const APART: f64 = 0.6;
/// Values that are looked at, after as many that are not.
const VALUES: u64 = 40;

/// An oscillation of `omega` [rad/s] under an integrator in steps of `dt` [s]; none where it does not swing any more.
///
/// In the long run such values follow `x'' = a x' + b x` from one to the next, and the roots of that are the swing.
pub(crate) fn swing_under(integrator: Box<dyn Integrator>, omega: f64, dt: f64) -> Option<Swing> {
    let mut body = oscillator(integrator, omega, dt);
    let stride = (APART / (omega * dt)).round().max(1.0);
    let mut values = Vec::new();
    for value in 0..2 * VALUES {
        let start = value as f64 * stride * dt;
        body.advance(start, stride as u32, &|| false, &mut |_, _| {});
        if value >= VALUES {
            values.push(body.state().positions[0].x);
        }
    }
    let [mut aa, mut ab, mut bb, mut ac, mut bc] = [0.0; 5];
    for window in values.windows(3) {
        let (b, a, c) = (window[0], window[1], window[2]);
        (aa, ab, bb, ac, bc) = (aa + a * a, ab + a * b, bb + b * b, ac + a * c, bc + b * c);
    }
    let of_both = aa * bb - ab * ab;
    let (a, b) = ((ac * bb - bc * ab) / of_both, (bc * aa - ac * ab) / of_both);
    // Roots of r² = a r + b: a pair with the squared size -b where they turn.
    let turning = -b - 0.25 * a * a;
    let over = stride * dt;
    (turning > 0.0 && turning.is_finite())
        .then(|| Swing { frequency: turning.sqrt().atan2(0.5 * a) / over, decay: -0.5 * (-b).ln() / over })
}

/// One particle of the mass 1 kg on a spring along x, a metre from its rest.
fn oscillator(integrator: Box<dyn Integrator>, omega: f64, dt: f64) -> Body {
    let state = ParticleState { positions: vec![DVec3::X], velocities: vec![DVec3::ZERO], masses: vec![1.0] };
    let explicit_dt = 2.0 / omega;
    let mut body = Body::new(BodyParts {
        id: String::new(),
        pointer: String::new(),
        name: String::new(),
        kind: "oscillator",
        state,
        model: [DVec3::ZERO].into(),
        rest: [DVec3::ZERO].into(),
        forces: vec![Box::new(Spring { omega })],
        integrator,
        integrator_word: "other",
        integrator_reason: None,
        constraints: Vec::new(),
        contact: ContactLaw { radius: 0.0, stiffness: 0.0, damping: 0.0, friction: 0.0, sticking: 0.0, holding: 0.0 },
        contact_surface: None,
        fibres: Vec::new(),
        sheets: Vec::new(),
        elements: Vec::new(),
        layers: None,
        skin: None,
        parted_skin: None,
        reach: 1.0,
        rest_scale: RestScale { force: 0.0, energy: 0.0 },
        mean_neighbours: 0.0,
        dt,
        stable_dt: dt,
        explicit_dt,
        step_parameter: String::new(),
        limited_by: None,
    });
    body.set_guarded(false);
    body
}

/// `f = -omega² x`.
#[derive(Clone)]
struct Spring {
    omega: f64,
}

impl Force for Spring {
    fn add_forces(&mut self, _time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        for (force, x) in forces.iter_mut().zip(&state.positions) {
            *force -= self.omega * self.omega * *x;
        }
    }

    fn add_energy(&self, _time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.springs += state.positions.iter().map(|x| 0.5 * (self.omega * x.length()).powi(2)).sum::<f64>();
    }

    fn changes_until(&self) -> f64 {
        0.0
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::integrators::{BackwardEuler, ImplicitMidpoint, LeapFrog, TrBdf2};

    const OMEGA: f64 = 80.0;

    fn of(integrator: impl Integrator + 'static, dt: f64) -> Swing {
        swing_under(Box::new(integrator), OMEGA, dt).expect("a swing")
    }

    #[test]
    fn the_swings_of_known_schemes_are_theirs() {
        let dt = 0.005;
        let theta = OMEGA * dt;
        let leap_frog = of(LeapFrog::default(), dt);
        assert!((leap_frog.frequency * dt - 2.0 * (0.5 * theta).asin()).abs() < 1e-9, "{leap_frog:?}");
        assert!(leap_frog.decay.abs() < 1e-6, "{leap_frog:?}");
        let midpoint = of(ImplicitMidpoint::default(), dt);
        assert!((midpoint.frequency * dt - 2.0 * (0.5 * theta).atan()).abs() < 1e-5, "{midpoint:?}");
        assert!(midpoint.decay.abs() < 1e-2, "{midpoint:?}");
        let euler = of(BackwardEuler::default(), dt);
        assert!((euler.frequency * dt - theta.atan()).abs() < 1e-5, "{euler:?}");
        assert!((euler.decay * dt - 0.5 * (theta * theta).ln_1p()).abs() < 1e-5, "{euler:?}");
    }

    #[test]
    fn steps_of_a_microsecond_err_by_nothing() {
        let swing = of(TrBdf2::default(), 1e-6);
        assert!((swing.frequency / OMEGA - 1.0).abs() < 1e-6 && swing.decay.abs() < 1e-3, "{swing:?}");
    }

    #[test]
    fn a_step_beyond_the_limit_is_no_swing() {
        assert_eq!(swing_under(Box::new(LeapFrog::default()), OMEGA, 0.03), None);
    }
}
