//! What is said of a motion that gains energy from nothing.

use super::account::{Account, HARD_BOUND};
use super::body::{Body, BodyParts};
use std::fmt;

/// A body, or all that touch each other, found to gain energy that nothing gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Unbalanced {
    /// Name of the body; none where it came by contact between bodies or with panels.
    pub body: Option<String>,
    /// When that was seen [s].
    pub time: f64,
    /// What was gained [J].
    pub gained: f64,
    /// Since when [s].
    pub since: f64,
    /// The greatest energy that was handled before, without what was gained [J].
    pub handled: f64,
    /// How it is stepped: the integrator's word and the step [s].
    pub stepped: (&'static str, f64),
    /// Which parameter to change.
    pub remedy: String,
}

impl Unbalanced {
    /// Of a body.
    pub(super) fn of_body(body: &Body, time: f64, account: &Account) -> Self {
        let parts = body.parts();
        let [gained, since] = account.excess();
        let stepped = (parts.integrator_word, parts.dt);
        let body = Some(parts.name.clone());
        Self { body, time, gained, since, handled: account.handled, stepped, remedy: remedy(parts) }
    }

    /// Of contact between bodies, of which one is given.
    pub(super) fn of_contact(body: &Body, time: f64, account: &Account) -> Self {
        let lower = format!("lower {}", step_of(body.parts()));
        Self { body: None, remedy: lower, ..Self::of_body(body, time, account) }
    }

    fn share(&self) -> f64 {
        100.0 * self.gained / self.handled
    }

    /// Why a body is stopped, and what to do.
    pub(super) fn as_stop(&self) -> (String, String) {
        let where_from = if self.body.is_some() { "" } else { " by contact between bodies" };
        let cause = format!(
            "it gained {:.3e} J{where_from} that nothing gave, more than {:.0} % of the {:.3e} J that it handled",
            self.gained,
            100.0 * HARD_BOUND,
            self.handled
        );
        (cause, self.remedy.clone())
    }
}

impl fmt::Display for Unbalanced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (word, dt) = self.stepped;
        match &self.body {
            Some(body) => write!(f, "body \"{body}\" gained")?,
            None => write!(f, "contact between bodies gave")?,
        }
        let (gained, share, over, handled) = (self.gained, self.share(), self.time - self.since, self.handled);
        write!(f, " {gained:.3e} J in {over:.3} s ({share:.1} % of the {handled:.3e} J handled) that nothing gave")?;
        write!(f, ", seen at {:.4} s under {word} in steps of {dt:.2e} s; {}", self.time, self.remedy)
    }
}

/// What chooses a body's step.
fn step_of(parts: &BodyParts) -> &str {
    // One that is stable at any step takes as many to a frame as that is long.
    if parts.stable_dt.is_infinite() && parts.step_parameter.contains("automatic") {
        "the step: raise /time/frames_per_second"
    } else {
        &parts.step_parameter
    }
}

fn remedy(parts: &BodyParts) -> String {
    let BodyParts { dt, stable_dt, pointer, limited_by, .. } = parts;
    let (mut beyond, mut or) = (String::new(), String::new());
    if dt > stable_dt {
        beyond = format!("its step is beyond the stable {stable_dt:.2e} s: ");
        or = limited_by.as_ref().map_or(or, |parameter| format!(", or {parameter}, which sets it"));
    }
    format!("{beyond}lower {}{or}, or choose another {pointer}/integrator", step_of(parts))
}
