//! The time step: how it is chosen, and what each body allows.

use super::context::{Context, Step};
use super::field::NumberField;
use crate::edit::Command;
use crate::scene::{Automatic, TimeStep};
use egui::{DragValue, Ui};

const DT: NumberField =
    NumberField::new("DT", "s", 1e-7..=1.0, None, "Time step, as it is given; beyond a body's limit it may diverge");
const SAFETY: NumberField = NumberField::new(
    "Safety",
    "",
    0.01..=1.0,
    Some(0.6),
    "Share of the stable step that is used; less keeps energy better",
);

/// Shows the time step and the limits of every body.
pub(super) fn time_section(ui: &mut Ui, cx: &mut Context) {
    let mut time = cx.scene().time.clone();
    let bodies = &cx.simulation.published().status.bodies;
    let dt = bodies.iter().map(|body| body.dt).fold(f64::INFINITY, f64::min);
    ui.horizontal(|ui| {
        let automatic = matches!(time.step, TimeStep::Automatic(_));
        let tooltip = "Steps of a frame follow from the stable step that is measured";
        if ui.selectable_label(automatic, "Automatic").on_hover_text(tooltip).clicked() && !automatic {
            time.step = TimeStep::Automatic(Automatic::default());
        }
        let tooltip = "The step is given, whatever comes of it";
        if ui.selectable_label(!automatic, "By hand").on_hover_text(tooltip).clicked() && automatic {
            let dt = if dt.is_finite() { dt } else { 1e-3 };
            let substeps_per_frame = (1.0 / (time.frames_per_second * dt)).ceil().max(1.0) as u32;
            time.step = TimeStep::manual(dt, substeps_per_frame);
        }
    });
    match &mut time.step {
        TimeStep::Automatic(step) => {
            SAFETY.show(ui, &mut step.safety);
        }
        TimeStep::Manual(step) => {
            DT.show(ui, &mut step.dt);
            ui.horizontal(|ui| {
                ui.label("Steps a frame");
                ui.add(DragValue::new(&mut step.substeps_per_frame).range(1..=100_000));
            });
        }
    }
    for body in bodies {
        let set_by = cx.set_by(body.limited_by.as_deref());
        if body.dt > body.stable_dt {
            let text =
                format!("{}: DT {:.3e} s is beyond its limit {:.3e} s{set_by}", body.name, body.dt, body.stable_dt);
            ui.colored_label(cx.tone.error(), text);
        } else {
            ui.label(format!("{}: limit {:.3e} s{set_by}", body.name, body.stable_dt));
        }
    }
    if time != cx.scene().time {
        cx.edit(&Command::SetTime(time), Step::Present);
    }
}
