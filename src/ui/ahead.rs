//! How much of a slow motion is computed before it is shown at full speed.

use super::theme::{GRID, Tone};
use crate::sim::Status;
use crate::text::number::{duration, memory};
use egui::{DragValue, RichText, Ui};

/// What is asked for first [s].
const USUAL: f64 = 2.0;
/// The most that can be [s].
const MOST: f64 = 3600.0;

/// A question for a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AheadQuestion {
    /// Simulated time to be computed [s].
    seconds: f64,
}

impl Default for AheadQuestion {
    fn default() -> Self {
        Self { seconds: USUAL }
    }
}

/// What was answered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AheadAnswer {
    /// Nothing is to be computed.
    Closed,
    /// So much is [s].
    Compute(f64),
}

impl AheadQuestion {
    /// Asks it, of a simulation that stands so and makes frames so long [s].
    pub(crate) fn ask(&mut self, ui: &mut Ui, (status, frame): (&Status, f64), tone: Tone) -> Option<AheadAnswer> {
        ui.set_width(420.0);
        ui.heading("Compute ahead");
        ui.label(
            "Computes as fast as this machine can, then plays it as fast as it is meant to be. Pause ends it earlier and \
             leaves what is there in the timeline.",
        );
        ui.add_space(GRID);
        ui.horizontal(|ui| {
            let label = ui.label("Simulated time");
            let seconds = DragValue::new(&mut self.seconds).range(0.01..=MOST).speed(0.05).max_decimals(2).suffix(" s");
            ui.add(seconds).labelled_by(label.id);
        });
        ui.label(RichText::new(self.takes(status)).weak());
        if let Some(dropped) = self.dropped(status, frame) {
            ui.colored_label(tone.warning(), dropped);
        }
        ui.add_space(GRID);
        let buttons = ui.horizontal(|ui| {
            let computes = ui.button("Compute").clicked().then_some(AheadAnswer::Compute(self.seconds));
            computes.or(ui.button("Cancel").clicked().then_some(AheadAnswer::Closed))
        });
        buttons.inner
    }

    /// How long it takes.
    fn takes(self, status: &Status) -> String {
        let pace = status.real_time_factor;
        if pace > 0.0 {
            format!("About {} at the last pace", duration(self.seconds / pace))
        } else {
            "How long that takes is told once some frames are there".to_owned()
        }
    }

    /// What of it would be dropped for want of memory; none where all can be kept, or how much it takes is not known.
    fn dropped(self, status: &Status, frame: f64) -> Option<String> {
        let kept = &status.recording;
        let of_frame = kept.bytes as f64 / (kept.frames as f64).max(1.0);
        let frames = self.seconds / frame;
        let kept_frames = kept.limit as f64 / of_frame.max(1.0);
        (kept.frames > 0 && frames > kept_frames).then(|| {
            format!(
                "{} would take {}: only the last {} are kept. Preferences give the motion more memory.",
                duration(self.seconds),
                memory((frames * of_frame) as usize, kept.limit),
                duration(kept_frames * frame)
            )
        })
    }
}

/// How far computing ahead has come, and how long it still takes.
pub(crate) fn told([from, until]: [f64; 2], time: f64, pace: f64) -> String {
    let so_far = format!("Computing {:.2} of {:.2} s", time - from, until - from);
    if pace > 0.0 { format!("{so_far}, {} left", duration((until - time).max(0.0) / pace)) } else { so_far }
}
