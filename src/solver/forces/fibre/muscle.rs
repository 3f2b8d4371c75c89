//! How a muscle pulls by its length.

/// An edge that pulls with `T0 a max(0, 1 - q²)`, `q = (s - 1) / w`, s its length over the drawn one and a how far it
/// is excited: most at the length at which it was drawn, and not at all where it is shorter or longer by w.
///
/// The energy is `T0 a l0 w (q - q³/3)`, with q no further than 1 to either side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Muscle {
    /// Greatest pull T0, the volume fraction included [N].
    force: f64,
    /// Share w of the drawn length, at most 1.
    width: f64,
    /// Whether it stands for all that it may ever be.
    stiffest: bool,
}

impl Muscle {
    /// A muscle of greatest pull `force` [N] that ends where it is shorter or longer by the share `width`.
    pub(crate) fn new(force: f64, width: f64) -> Self {
        Self { force, width, stiffest: false }
    }

    /// What resists any move as much as the muscle ever does, fully excited: a spring without length, of the greatest
    /// slope of the pull.
    pub(super) fn stiffest(self) -> Self {
        Self { stiffest: true, ..self }
    }

    /// One that pulls by a share of this one's force.
    pub(super) fn scaled(self, share: f64) -> Self {
        Self { force: share * self.force, ..self }
    }

    /// Pull [N] at a length over the drawn one.
    pub(super) fn pull(self, excited: f64, s: f64) -> f64 {
        if self.stiffest {
            return 2.0 * self.force / self.width * s;
        }
        let q = (s - 1.0) / self.width;
        self.force * excited * (1.0 - q * q).max(0.0)
    }

    /// Energy [J] at a length over the drawn one, which is `drawn` [m].
    pub(super) fn energy(self, excited: f64, s: f64, drawn: f64) -> f64 {
        let q = ((s - 1.0) / self.width).clamp(-1.0, 1.0);
        self.force * excited * drawn * self.width * (q - q * q * q / 3.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pull_is_the_slope_of_the_energy_and_no_steeper_than_the_stiffest() {
        let muscle = Muscle::new(12.0, 0.4);
        let (drawn, step) = (0.02, 1e-6);
        for s in [0.3, 0.61, 0.8, 1.0, 1.2, 1.39, 1.6] {
            let slope =
                (muscle.energy(0.7, s + step, drawn) - muscle.energy(0.7, s - step, drawn)) / (2.0 * step * drawn);
            assert!((slope - muscle.pull(0.7, s)).abs() < 1e-6, "{s}");
            let steep = (muscle.pull(1.0, s + step) - muscle.pull(1.0, s - step)) / (2.0 * step);
            let stiffest = muscle.stiffest().pull(0.0, 1.0);
            assert!(steep <= stiffest && muscle.pull(1.0, s) / s <= stiffest, "{s}");
        }
    }
}
