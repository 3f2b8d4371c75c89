//! Energy less work from outside, looked at from time to time. Dissipation lowers it and nothing may raise it: what it
//! gains is an error of the integration.

/// Share of the energy that was handled by which the balance may rise in a second [1/s].
const RATE: f64 = 0.01;

/// Share by which it may rise besides: what integrators that keep energy on the whole have more of it at one time than
/// at another.
const SLACK: f64 = 0.02;

/// A body that has gained this many times the energy that it ever handled is stopped.
pub(super) const HARD_BOUND: f64 = 1.0;

/// Share of the sizes of all energies that may be rounding.
const ROUND_OFF: f64 = 1e-9;

/// What is seen of a body, or of a whole world, at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BalanceSample {
    /// [s]
    pub(super) time: f64,
    /// Energy less the work that was done from outside so far [J].
    pub(super) balance: f64,
    /// Energy of motion and all potentials, those that count from anywhere by their change since the first look [J].
    pub(super) handled: f64,
    /// Sum of the sizes of all energies [J], of which the balance has its rounding.
    pub(super) sizes: f64,
}

/// What was gained so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Account {
    last: Option<BalanceSample>,
    first: f64,
    /// By how much the balance has risen beyond what it may in the time since it last was at its lowest [J].
    excess: f64,
    /// Since when that is more than nothing [s].
    since: f64,
    /// The most that it ever was [J].
    pub(super) gained: f64,
    /// The most energy that was handled so far, what was gained left out [J].
    pub(super) handled: f64,
}

impl Account {
    /// Looks; an error where the balance is no number.
    pub(super) fn look(&mut self, now: BalanceSample) {
        let Some(last) = self.last else {
            *self =
                Self { last: Some(now), first: now.balance, since: now.time, handled: now.handled, ..Self::default() };
            return;
        };
        let allowed = RATE * self.handled * (now.time - last.time) + ROUND_OFF * now.sizes.max(last.sizes);
        let risen = now.balance - last.balance - allowed;
        self.excess = (self.excess + risen).max(0.0);
        if self.excess == 0.0 {
            self.since = now.time;
        }
        self.handled = self.handled.max(now.handled - self.excess);
        self.gained = self.gained.max(self.excess);
        self.last = Some(now);
    }

    /// Whether more was gained than may be, `explained` [J] of it left out.
    pub(super) fn is_unbalanced(&self, explained: f64) -> bool {
        self.excess - explained > SLACK * self.handled
    }

    /// Whether so much was gained that nothing is left of the motion.
    pub(super) fn is_beyond(&self, explained: f64) -> bool {
        self.excess - explained > HARD_BOUND * self.handled
    }

    /// What the balance has changed by since the first look [J].
    pub(super) fn change(&self) -> f64 {
        self.last.map_or(0.0, |last| last.balance - self.first)
    }

    /// What was gained [J], and since when [s].
    pub(super) fn excess(&self) -> [f64; 2] {
        [self.excess, self.since]
    }
}
