//! A hand that leads a drive: from where the drive was to another value within a frame, and back to the drive when it
//! lets go.

/// By what share of a frame a hand begins to lead after the frame does: so what is evaluated at the end of the frame
/// before, as far as it is told from the beginning of this one, knows nothing of it.
pub(crate) const LATE: f64 = 1e-6;

/// What a hand makes of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand {
    /// Time [s] and value from which it goes.
    from: (f64, f64),
    /// When it is there [s], and the value that it goes to; none where it lets go, and the drive is itself again then.
    to: (f64, Option<f64>),
}

impl Hand {
    /// From a value at the first of two times [s] to another one at the second, or to what the drive is by itself.
    pub(crate) fn new([from, to]: [f64; 2], value: f64, aim: Option<f64>) -> Self {
        Self { from: (from, value), to: (to, aim) }
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

    /// As [`Self::lead`], of the value at one of the places along which a wave runs: from there, not from the value of
    /// the first place.
    pub(crate) fn lead_along(&self, time: f64, own: f64) -> f64 {
        let ((start, a), (end, aim)) = (self.from, self.to);
        let s = (time - start) / (end - start);
        match aim {
            _ if s < 0.0 => own,
            Some(b) if s >= 1.0 => b,
            Some(b) => own + s * (b - own),
            None if s >= 1.0 => own,
            None => own + (1.0 - s) * (a - own),
        }
    }

    /// Until when [s] what it leads changes, if that by itself changes until `own` [s]: as long as it holds it, it may
    /// lead it elsewhere at any time.
    pub(crate) fn until(&self, own: f64) -> f64 {
        if self.to.1.is_some() { f64::INFINITY } else { own.max(self.to.0) }
    }

    /// Whether it holds.
    pub(crate) fn holds(&self) -> bool {
        self.to.1.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hand_leads_from_where_a_drive_is_and_back_to_it() {
        let own = |time: f64| (0.2 + 0.1 * time, 0.1);
        let taken = Hand::new([1.0, 1.5], own(1.0).0, Some(0.8));
        assert_eq!(taken.lead(0.9, own(0.9)), own(0.9));
        assert_eq!(taken.lead(1.0, own(1.0)).0, own(1.0).0);
        assert!((taken.lead(1.25, own(1.25)).0 - 0.55).abs() < 1e-15);
        assert_eq!(taken.lead(2.0, own(2.0)), (0.8, 0.0));
        let let_go = Hand::new([2.0, 2.5], 0.8, None);
        assert_eq!(let_go.lead(2.0, own(2.0)).0, 0.8);
        assert_eq!(let_go.lead(2.5, own(2.5)), own(2.5));
        for (hand, time) in [(taken, 1.2), (let_go, 2.3)] {
            let value = |time: f64| hand.lead(time, own(time)).0;
            let rate = (value(time + 1e-6) - value(time - 1e-6)) / 2e-6;
            assert!((rate - hand.lead(time, own(time)).1).abs() < 1e-6, "{hand:?}");
        }
        assert!(taken.until(0.0).is_infinite() && let_go.until(0.0) == 2.5 && taken.holds() && !let_go.holds());
    }
}
