//! What can be chosen about the strokes of a fibre that is drawn already.

use super::context::{Context, Step};
use crate::edit::Command;
use crate::scene::{Fibre, FibreSource, Mismatch};
use egui::Ui;

/// Buttons that take the selected fibre's strokes another way.
pub(super) fn stroke_choices(ui: &mut Ui, cx: &mut Context) {
    let Some((_, fibre)) = cx.selected_fibre() else { return };
    let FibreSource::Strokes(pair) = fibre.source.clone() else { return };
    let Some(lift) = cx.selected_lift() else { return };
    let Some(lifted) = &lift.lifted else { return };
    let mut changed = pair.clone();
    let tooltip = "Takes the second stroke from its other end: the start dots are green";
    if ui.button("Flip second stroke").on_hover_text(tooltip).clicked() {
        changed.flip_second = !changed.flip_second;
    }
    let clipped = lifted.clipped.iter().any(|parts| !parts.is_empty());
    if pair.mismatch == Mismatch::Stretch || clipped {
        let (text, tooltip, mismatch) = match pair.mismatch {
            Mismatch::Clip => ("Stretch instead", "Stretches the second stroke onto the first", Mismatch::Stretch),
            Mismatch::Stretch => ("Clip instead", "Cuts both strokes to what they share", Mismatch::Clip),
        };
        if ui.button(text).on_hover_text(tooltip).clicked() {
            changed.mismatch = mismatch;
        }
    }
    let Some((body, fibre)) = cx.selected_fibre().filter(|_| changed != pair) else { return };
    let fibre = Fibre { source: FibreSource::Strokes(changed), ..fibre.clone() };
    let body = body.id.clone();
    cx.edit(&Command::SetFibre { body, fibre }, Step::Own);
}
