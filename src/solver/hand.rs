//! A hand that leads a drive: from where the drive was to another value within a frame, and back to the drive when it
//! lets go.

/// By what share of a frame a hand begins to lead after the frame does: so what is evaluated at the end of the frame
/// before, as far as it is told from the beginning of this one, knows nothing of it.
pub(crate) const LATE: f64 = 1e-6;

/// The way of a drive from one value to another, or back to what it is by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lead {
    /// Time [s] and value from which it goes.
    from: (f64, f64),
    /// When it is there [s], and the value that it goes to; none where it goes back, and the drive is itself then.
    to: (f64, Option<f64>),
    /// Whether it was held at the first value, and not by itself there.
    from_held: bool,
}

impl Lead {
    /// From where a drive is by itself at the first of two times [s] to a value at the second.
    pub(crate) fn away([from, to]: [f64; 2], own: f64, aim: f64) -> Self {
        Self { from: (from, own), to: (to, Some(aim)), from_held: false }
    }

    /// From a value at which it was held at the first of two times [s] to what it is by itself at the second.
    pub(crate) fn back([from, to]: [f64; 2], held: f64) -> Self {
        Self { from: (from, held), to: (to, None), from_held: true }
    }

    /// Value and rate [1/s] at a time [s] of a drive that by itself has these.
    pub(crate) fn lead(&self, time: f64, own: (f64, f64)) -> (f64, f64) {
        let ((start, a), (end, aim)) = (self.from, self.to);
        if time < start {
            return own;
        }
        let s = (time - start) / (end - start);
        match aim {
            Some(b) if s >= 1.0 => (b, 0.0),
            // As between keys.
            Some(b) => (a + (b - a) * s, (b - a) / (end - start)),
            None if s >= 1.0 => own,
            None => (own.0 + (1.0 - s) * (a - own.0), own.1 * s + (own.0 - a) / (end - start)),
        }
    }

    /// What it makes of a drive along which a wave runs, whose value at each place it changes alike.
    pub(crate) fn share(&self, time: f64) -> OwnShare {
        let ((start, a), (end, aim)) = (self.from, self.to);
        let s = (time - start) / (end - start);
        match aim {
            _ if s < 0.0 => OwnShare::WHOLE,
            Some(b) if s >= 1.0 => OwnShare::none(b),
            Some(b) if self.from_held => OwnShare::none(a + (b - a) * s),
            Some(b) => OwnShare { own: 1.0 - s, added: s * b },
            None if s >= 1.0 => OwnShare::WHOLE,
            None => OwnShare { own: s, added: (1.0 - s) * a },
        }
    }
}

/// A value as so much of what it is by itself, and so much besides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OwnShare {
    own: f64,
    added: f64,
}

impl OwnShare {
    /// What it is by itself.
    pub(crate) const WHOLE: Self = Self { own: 1.0, added: 0.0 };

    /// This value, whatever it is by itself.
    pub(crate) fn none(value: f64) -> Self {
        Self { own: 0.0, added: value }
    }

    /// The value of what is so much by itself.
    pub(crate) fn of(self, own: f64) -> f64 {
        if self == Self::WHOLE { own } else { self.own * own + self.added }
    }

    /// Of what itself is made of something else.
    pub(crate) fn after(self, first: Self) -> Self {
        Self { own: self.own * first.own, added: self.own * first.added + self.added }
    }
}

/// What a hand makes of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand {
    now: Lead,
    /// What it did before that.
    before: Option<Lead>,
}

impl Hand {
    /// From a value at the first of two times [s] to another one at the second, or to what the drive is by itself;
    /// `before` is the hand that led it until then.
    pub(crate) fn new([from, to]: [f64; 2], value: f64, aim: Option<f64>, before: Option<Self>) -> Self {
        let from_held = before.is_some_and(|before| before.holds());
        Self { now: Lead { from: (from, value), to: (to, aim), from_held }, before: before.map(|before| before.now) }
    }

    /// What counts at a time [s].
    fn at(&self, time: f64) -> Option<&Lead> {
        if time < self.now.from.0 { self.before.as_ref() } else { Some(&self.now) }
    }

    /// Value and rate [1/s] at a time [s] of a drive that by itself has these.
    pub(crate) fn lead(&self, time: f64, own: (f64, f64)) -> (f64, f64) {
        self.at(time).map_or(own, |lead| lead.lead(time, own))
    }

    /// What it makes of a drive along which a wave runs.
    pub(crate) fn share(&self, time: f64) -> OwnShare {
        self.at(time).map_or(OwnShare::WHOLE, |lead| lead.share(time))
    }

    /// Until when [s] what it leads changes, if that by itself changes until `own` [s]: as long as it holds it, it may
    /// lead it elsewhere at any time.
    pub(crate) fn until(&self, own: f64) -> f64 {
        if self.holds() { f64::INFINITY } else { own.max(self.now.to.0) }
    }

    /// Whether it holds.
    pub(crate) fn holds(&self) -> bool {
        self.now.to.1.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hand_leads_from_where_a_drive_is_and_back_to_it() {
        let own = |time: f64| (0.2 + 0.1 * time, 0.1);
        let taken = Hand::new([1.0, 1.5], own(1.0).0, Some(0.8), None);
        assert_eq!(taken.lead(0.9, own(0.9)), own(0.9));
        assert_eq!(taken.lead(1.0, own(1.0)).0, own(1.0).0);
        assert!((taken.lead(1.25, own(1.25)).0 - 0.55).abs() < 1e-15);
        assert_eq!(taken.lead(2.0, own(2.0)), (0.8, 0.0));
        let let_go = Hand::new([2.0, 2.5], 0.8, None, Some(taken));
        assert_eq!(let_go.lead(2.0, own(2.0)).0, 0.8);
        assert_eq!(let_go.lead(2.5, own(2.5)), own(2.5));
        for (hand, time) in [(taken, 1.2), (let_go, 2.3)] {
            let value = |time: f64| hand.lead(time, own(time)).0;
            let rate = (value(time + 1e-6) - value(time - 1e-6)) / 2e-6;
            assert!((rate - hand.lead(time, own(time)).1).abs() < 1e-6, "{hand:?}");
        }
        assert!(taken.until(0.0).is_infinite() && let_go.until(0.0) == 2.5 && taken.holds() && !let_go.holds());
    }
    #[test]
    fn along_a_wave_every_place_is_led_as_one_is() {
        let taken = Hand::new([1.0, 1.5], 0.2, Some(0.8), None);
        let on = Hand::new([2.0, 2.5], 0.8, Some(0.1), Some(taken));
        let let_go = Hand::new([3.0, 3.5], 0.1, None, Some(on));
        // At the place whose value it was told of they are the same; the others come from where they are.
        for (hand, time) in [(taken, 0.5), (taken, 1.2), (taken, 1.9), (on, 1.7), (on, 2.2), (on, 2.6), (let_go, 3.4)] {
            let one = hand.lead(time, (0.2, 0.0)).0;
            assert!((hand.share(time).of(0.2) - one).abs() < 1e-15, "{hand:?} {time}");
        }
        assert!((taken.share(1.25).of(0.6) - 0.7).abs() < 1e-15);
        assert_eq!(on.share(2.25).of(0.6), on.share(2.25).of(0.0));
        assert_eq!((let_go.share(3.5).of(0.6), taken.share(0.9).of(0.6)), (0.6, 0.6));
    }
}
