//! The colours by which compared runs are told apart, in lists, plots and views alike.

use super::context::Context;
use super::theme::{self, Tone};
use crate::draw::Colour;
use crate::scene::IntegratorKind;
use egui::Color32;

/// The place of an integrator among all of them.
pub(super) fn place(kind: IntegratorKind) -> usize {
    IntegratorKind::ALL.iter().position(|known| *known == kind).unwrap_or_default()
}

/// The colour of an integrator's run.
pub(super) fn run_colour(tone: Tone, kind: IntegratorKind) -> Color32 {
    theme::color(tone.pictures().fibre(place(kind)))
}

/// Colours of the bodies in the order of the snapshot; none where nothing is compared.
pub(super) fn tints(cx: &Context) -> Vec<Colour> {
    let theme = cx.tone.pictures();
    let runs = cx.simulation.published().compared.iter();
    runs.flat_map(|run| std::iter::repeat_n(theme.fibre(place(run.integrator)), run.bodies)).collect()
}
