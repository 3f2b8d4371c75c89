//! Volume fractions of fibres that get thicker and thinner as their drives say, at the particles around (eq. 18).

use super::drive_along::DriveAlong;
use super::hand::Hand;

/// The particles around such fibres, and what the volume fraction there is made of: the largest of all fibres and
/// sheets, with what is painted over it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrivenFractions {
    /// Indices of the particles, ascending.
    pub(crate) particles: Vec<u32>,
    /// At each of them the largest fraction of all that does not change.
    pub(crate) others: Vec<f64>,
    /// What is painted there: `[a, b]` makes a fraction l `a l + b`.
    pub(crate) painted: Vec<[f64; 2]>,
    /// The fibres, one entry for each run.
    pub(crate) runs: Vec<DrivenRun>,
}

/// A run of a fibre that gets thicker or thinner.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrivenRun {
    /// Volume fraction at its centre line where its drive is 0, and where it is 1.
    pub(crate) fractions: [f64; 2],
    /// Its drive where it is nearest to each of the particles that it reaches.
    pub(crate) drive: DriveAlong,
    /// Places of these in the list of particles, and how much of the fraction is left there.
    pub(crate) reached: Vec<(u32, f64)>,
}

impl DrivenFractions {
    /// The fractions at a time [s], or where all drives are 0; one for each of the particles.
    pub(crate) fn at(&self, time: Option<f64>) -> Vec<f64> {
        let mut largest = self.others.clone();
        for DrivenRun { fractions: [own, at_one], drive, reached } in &self.runs {
            let value = time.map(|time| drive.at(time));
            for (place, &(particle, left)) in reached.iter().enumerate() {
                let by = value.as_ref().map_or(0.0, |value| value(place));
                let fraction = &mut largest[particle as usize];
                *fraction = fraction.max((own + (at_one - own) * by) * left);
            }
        }
        largest.iter().zip(&self.painted).map(|(fraction, [a, b])| a * fraction + b).collect()
    }

    /// Until when [s] they change.
    pub(crate) fn until(&self) -> f64 {
        self.runs.iter().map(|run| run.drive.until()).fold(0.0, f64::max)
    }

    /// Has a hand lead a shared drive, or none.
    pub(crate) fn give(&mut self, to: &str, led: Option<Hand>) {
        for run in &mut self.runs {
            run.drive.give(to, led);
        }
    }

    /// Where all fibres stay as thick as they ever get, or as thin.
    pub(crate) fn at_extreme(&self, thickest: bool) -> Self {
        let still = |run: &DrivenRun| DrivenRun {
            fractions: [run.drive.thickest(run.fractions, thickest); 2],
            drive: run.drive.at_extreme(thickest),
            ..run.clone()
        };
        Self { runs: self.runs.iter().map(still).collect(), ..self.clone() }
    }
}
