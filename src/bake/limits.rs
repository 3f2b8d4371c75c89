//! Which parameter sets the stable step of a body: the one that, halved, raises it most.
//!
//! Measuring the step anew for every parameter would take as many times as long as measuring it once, and on a fine
//! body that is seconds. Two-layer bodies therefore ask only what becomes of the few modes that would grow first (their
//! Rayleigh quotients under the halved parameter); fibre solids, whose frequency is one number, what is left of it
//! without fibres.

use super::layer_model::LayerModel;
use crate::scene::{Hold, TwoLayer};
use crate::solver::forces::pressure::Pressure;
use crate::solver::forces::{
    ElementForce, FibreForce, Flow, Force, Inelastic, MatrixForce, MatrixThinning, SheetForce, StepLimit, total_forces,
};
use crate::solver::integrators::Integrator;
use crate::solver::modes::{Modes, greatest_stable_step};
use crate::solver::stable_step::highest_frequency_squared;
use crate::solver::state::ParticleState;
use glam::DVec3;

/// A parameter that raises the step by less than this share does not set it.
const NOTICEABLE: f64 = 0.01;

/// Modes that are looked at.
const MODES: usize = 8;

/// A parameter by its pointer from the body, and how it is scaled; whether there is any of it.
type Parameter = (&'static str, fn(&mut TwoLayer, f64) -> bool);

/// What may set the step of a two-layer body. Contact brakes with the greater of cc and ct in all directions.
const PARAMETERS: [Parameter; 12] = [
    ("ks", |body, by| scale(&mut body.ks, by)),
    ("kd", |body, by| scale(&mut body.kd, by)),
    ("rks", |body, by| scale(&mut body.rks, by)),
    ("rkd", |body, by| scale(&mut body.rkd, by)),
    ("mks", |body, by| !body.grabs.is_empty() && scale(&mut body.mks, by)),
    ("mkd", |body, by| !body.grabs.is_empty() && scale(&mut body.mkd, by)),
    ("pressure", |body, by| scale(&mut body.pressure, by)),
    ("air_drag", |body, by| scale(&mut body.air_drag, by)),
    ("contact/kc", |body, by| scale(&mut body.contact.kc, by)),
    ("contact/cc", |body, by| {
        let contact = &mut body.contact;
        contact.cc >= contact.ct && { scale(&mut contact.ct, by) | scale(&mut contact.cc, by) }
    }),
    ("follows", |body, by| {
        let stiffnesses = body.follows.iter_mut().filter_map(|of| match &mut of.hold {
            Hold::Springs(springs) => Some(&mut springs.stiffness),
            Hold::Hard => None,
        });
        stiffnesses.map(|stiffness| scale(stiffness, by)).fold(false, |one, other| one | other)
    }),
    ("contact/ct", |body, by| body.contact.ct > body.contact.cc && scale(&mut body.contact.ct, by)),
];

fn scale(value: &mut f64, by: f64) -> bool {
    *value *= by;
    *value > 0.0
}

/// Greatest rate [1/s] at which wind brakes a body under these forces. It grows with the speed, so that no small motion
/// around a body at rest shows it.
pub(super) fn wind_rate(forces: &[Box<dyn Force>], state: &ParticleState) -> f64 {
    forces.iter().filter_map(|force| force.downcast_ref::<Flow>()).map(|flow| flow.step_limit(state).damping_rate).sum()
}

/// Share of the step of a body whose springs change its shape: of that only the size is followed, see `squeeze`.
const OF_CHANGING_SHAPE: f64 = 0.95;

/// Pointer to what the drag of the wind is proportional to.
const WIND: &str = "/wind/density";

/// A two-layer body whose step is asked for.
pub(super) struct Layered<'a> {
    pub(super) body: &'a TwoLayer,
    /// Pointer to the body.
    pub(super) path: &'a str,
    /// At rest.
    pub(super) state: &'a ParticleState,
    /// Its particles and what joins them.
    pub(super) model: &'a LayerModel,
    /// [`wind_rate`].
    pub(super) wind: f64,
}

impl Layered<'_> {
    /// The greatest stable step [s], which is that of the modes at rest, `by_modes`, unless the body's forces are far
    /// out of balance there and accelerate particles by up to `burst` [m/s²]. Gas that bursts a body open has it in
    /// another shape after a step or two, of which those modes tell nothing: from rest no particle may go further than
    /// half the distance to its neighbours in one step, `a dt² / 2`. Implicit steps, which have no limit, get none.
    pub(super) fn stable_step(&self, by_modes: f64, burst: f64) -> f64 {
        let changes = self.body.active_springs.iter().any(|of| of.contract != 0.0);
        let share = if changes { OF_CHANGING_SHAPE } else { 1.0 };
        if by_modes.is_finite() { share * by_modes.min((self.model.least_spacing() / burst).sqrt()) } else { by_modes }
    }

    /// The greatest acceleration [m/s²] that the body's springs, and its gas at its strongest, give a particle at rest.
    pub(super) fn burst(&self, forces: &[Box<dyn Force>]) -> f64 {
        let own = forces.iter().filter(|force| force.is_internal());
        let mut own: Vec<_> = own
            .map(|force| match force.downcast_ref::<Pressure>() {
                Some(gas) => gas.clone_at_extreme(true),
                None => force.clone_box(),
            })
            .collect();
        let mut still = self.state.clone();
        still.velocities.fill(DVec3::ZERO);
        let forces = total_forces(&mut own, &still);
        forces.iter().zip(&self.state.masses).map(|(force, mass)| force.length() / mass).fold(0.0, f64::max)
    }

    /// The pointer to the parameter that sets its step; none where no single one does. `forces_of` gives the forces of
    /// a body with other parameters that its modes are found under, `own_forces_of` those that it starts with.
    pub(super) fn limited_by(
        &self,
        modes: &Modes,
        integrator: &dyn Integrator,
        forces_of: impl Fn(&TwoLayer) -> Vec<Box<dyn Force>>,
        own_forces_of: impl Fn(&TwoLayer) -> Vec<Box<dyn Force>>,
    ) -> Option<String> {
        let shapes = modes.limiting(integrator, MODES);
        let step = |body: &TwoLayer, wind: f64| {
            let burst = self.burst(&own_forces_of(body));
            let modes = modes.under(&mut forces_of(body), self.state, self.model.radius, &shapes);
            self.stable_step(greatest_stable_step(integrator, modes, wind), burst)
        };
        let present = step(self.body, self.wind);
        let raised = PARAMETERS.iter().filter_map(|(name, scale)| {
            let mut halved = self.body.clone();
            scale(&mut halved, 0.5).then(|| (format!("{}/{name}", self.path), step(&halved, self.wind)))
        });
        let calmed = (self.wind > 0.0).then(|| (WIND.to_owned(), step(self.body, 0.5 * self.wind)));
        greatest(present, raised.chain(calmed))
    }
}

/// The one of some parameters that raises a step most from what it is now.
fn greatest<T>(present: f64, raised: impl Iterator<Item = (T, f64)>) -> Option<T> {
    let noticeable = raised.filter(|(_, step)| present.is_finite() && *step > (1.0 + NOTICEABLE) * present);
    // Of equals the first.
    noticeable.reduce(|a, b| if b.1 > a.1 { b } else { a }).map(|(name, _)| name)
}

/// Whether a drive changes how stiff a force is, or tearing does.
fn is_driven(force: &dyn Force) -> bool {
    force.downcast_ref().is_some_and(FibreForce::is_driven)
        || force.downcast_ref().is_some_and(SheetForce::is_driven)
        || force.downcast_ref().is_some_and(ElementForce::is_driven)
        || force.downcast_ref::<MatrixThinning>().is_some()
        || force.downcast_ref::<MatrixForce>().is_some_and(|matrix| !matrix.tears().is_empty())
}

/// Share of the bound of a damping rate that the stiffest mode is sure to see.
const ASSURED: f64 = 0.25;

/// What sets the step of a fibre solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SolidParameter {
    YoungModulus,
    Fibres,
    Sheets,
    Elements,
    PairDamping,
    Viscosity,
    AirDrag,
    Wind,
    Follows,
}

impl SolidParameter {
    const ALL: [Self; 9] = [
        Self::YoungModulus,
        Self::Fibres,
        Self::Sheets,
        Self::Elements,
        Self::PairDamping,
        Self::Viscosity,
        Self::AirDrag,
        Self::Wind,
        Self::Follows,
    ];

    /// Its pointer, of a body by the pointer to that.
    pub(super) fn pointer(self, body: &str) -> String {
        match self {
            Self::YoungModulus => format!("{body}/material/young_modulus"),
            Self::Fibres => format!("{body}/fibres"),
            Self::Sheets => format!("{body}/sheets"),
            Self::Elements => format!("{body}/elements"),
            Self::PairDamping => format!("{body}/material/damping/pair"),
            Self::Viscosity => format!("{body}/material/viscosity"),
            Self::AirDrag => format!("{body}/material/damping/air"),
            Self::Wind => WIND.to_owned(),
            Self::Follows => format!("{body}/follows"),
        }
    }
}

/// Forces of a fibre solid without some that stiffen it.
#[derive(Default)]
pub(super) struct Softer {
    /// Matrix, elements and sheets, where there are fibres.
    pub(super) unthreaded: Option<Vec<Box<dyn Force>>>,
    /// Matrix and elements, where there are sheets.
    pub(super) unsheeted: Option<Vec<Box<dyn Force>>>,
    /// The matrix alone, where there are elements.
    pub(super) matrix: Option<Vec<Box<dyn Force>>>,
}

/// What resists the stiffest motion of a fibre solid: squares of angular frequencies [1/s²] and rates of damping [1/s],
/// by what they come from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resistance {
    /// Matrix, elements, sheets and fibres.
    all: f64,
    /// Matrix, elements and sheets.
    unthreaded: f64,
    /// Matrix and elements.
    unsheeted: f64,
    /// The matrix alone.
    matrix: f64,
    contact: StepLimit,
    /// Of springs that lead particles.
    led: StepLimit,
    pair: f64,
    /// Of the matrix: the very rate of the mode that sees most of it.
    viscous: f64,
    air: f64,
    /// By [`wind_rate`].
    wind: f64,
    /// Whether the fibres can be stepped implicitly.
    implicit: bool,
}

impl Resistance {
    /// Of a body under `forces`, the `softer` ones that are left without fibres, sheets and elements, and besides them
    /// a contact that may come and springs that lead particles; `air` is the rate of air drag among the forces. None
    /// where `stop`, asked again and again, says that it is no longer wanted.
    pub(super) fn measured(
        forces: &[Box<dyn Force>],
        softer: Softer,
        state: &ParticleState,
        spacing: f64,
        [contact, led]: [StepLimit; 2],
        air: f64,
        stop: &mut dyn FnMut() -> bool,
    ) -> Option<Self> {
        // On copies: the forces' warm starts must be those of the start when the run begins.
        let mut highest = |forces: &[Box<dyn Force>]| {
            let mut at_extreme = |greatest: bool| {
                let mut copies: Vec<_> = forces.iter().map(|force| force.clone_at_extreme(greatest)).collect();
                highest_frequency_squared(&mut copies, state, spacing, stop)
            };
            let greatest = at_extreme(true)?;
            Some(if forces.iter().any(|force| is_driven(force.as_ref())) {
                greatest.max(at_extreme(false)?)
            } else {
                greatest
            })
        };
        let fibres = forces.iter().find_map(|force| force.downcast_ref::<FibreForce>());
        let all = highest(forces)?;
        let unthreaded = match softer.unthreaded {
            Some(forces) => highest(&forces)?.min(all),
            None => all,
        };
        let unsheeted = match softer.unsheeted {
            Some(forces) => highest(&forces)?.min(unthreaded),
            None => unthreaded,
        };
        let matrix = match softer.matrix {
            Some(forces) => highest(&forces)?.min(unsheeted),
            None => unsheeted,
        };
        let wind = wind_rate(forces, state);
        let viscous: f64 = forces
            .iter()
            .filter(|force| force.downcast_ref::<Inelastic>().is_some())
            .map(|force| force.step_limit(state).damping_rate)
            .sum();
        let of_the_body = forces
            .iter()
            .filter(|force| force.downcast_ref::<Flow>().is_none() && force.downcast_ref::<Inelastic>().is_none());
        let damping: f64 = of_the_body.map(|force| force.step_limit(state).damping_rate).sum();
        let implicit = fibres.is_none_or(FibreForce::takes_implicit_steps);
        Some(Self {
            all,
            unthreaded,
            unsheeted,
            matrix,
            contact,
            led,
            pair: damping - air,
            viscous,
            air,
            wind,
            implicit,
        })
    }

    /// Greatest stable step [s].
    pub(super) fn stable_step(&self, integrator: &dyn Integrator) -> f64 {
        let own = if integrator.takes_fibres() && self.implicit { self.unthreaded } else { self.all };
        let frequency = (self.contact.frequency_squared + own + self.led.frequency_squared).sqrt();
        let assured = self.pair + self.viscous + self.air;
        // Damping shortens the step of some integrators and is all that holds others: explicit Euler may count only on
        // what every particle has all the time, and the bound of each rate is up to four times what a mode sees.
        let with_least = integrator.stable_step(frequency, ASSURED * assured);
        integrator
            .stable_step(frequency, assured + self.contact.damping_rate + self.wind + self.led.damping_rate)
            .min(with_least)
    }

    /// What sets that step; none where no single parameter does.
    pub(super) fn limited_by(&self, integrator: &dyn Integrator) -> Option<SolidParameter> {
        let raised = SolidParameter::ALL.map(|parameter| (parameter, self.halved(parameter).stable_step(integrator)));
        greatest(self.stable_step(integrator), raised.into_iter())
    }

    fn halved(mut self, parameter: SolidParameter) -> Self {
        match parameter {
            SolidParameter::YoungModulus => {
                self.all -= 0.5 * self.matrix;
                self.unthreaded -= 0.5 * self.matrix;
                self.unsheeted -= 0.5 * self.matrix;
                self.matrix *= 0.5;
                // Contact is as stiff as the material, and damped in proportion to the root of that.
                self.contact.frequency_squared *= 0.5;
                self.contact.damping_rate *= 0.5_f64.sqrt();
            }
            SolidParameter::Fibres => self.all -= 0.5 * (self.all - self.unthreaded),
            SolidParameter::Sheets => {
                let by = 0.5 * (self.unthreaded - self.unsheeted);
                self.all -= by;
                self.unthreaded -= by;
            }
            SolidParameter::Elements => {
                let by = 0.5 * (self.unsheeted - self.matrix);
                self.all -= by;
                self.unthreaded -= by;
            }
            SolidParameter::PairDamping => self.pair *= 0.5,
            SolidParameter::Viscosity => self.viscous *= 0.5,
            SolidParameter::AirDrag => self.air *= 0.5,
            SolidParameter::Wind => self.wind *= 0.5,
            SolidParameter::Follows => {
                self.led.frequency_squared *= 0.5;
                self.led.damping_rate *= 0.5_f64.sqrt();
            }
        }
        self
    }
}
