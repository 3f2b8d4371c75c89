//! What is seen besides the bodies: a colour map over them, and a ghost that runs in step.

use super::app::{App, Gravity};
use crate::scene::Scene;
use crate::sim::SimCommand;
use crate::solver::snapshot::FieldKind;
use egui::Ui;
use std::sync::Arc;

/// What was chosen.
#[derive(Default)]
pub(super) struct Seeing {
    field: Option<FieldKind>,
    ghost: Option<Ghost>,
}

/// What runs beside the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ghost {
    WithoutFibres,
    BeforeEdit,
}

/// What can be chosen, in the order in which a key goes through it.
const FIELDS: [(Option<FieldKind>, &str); 5] = [
    (None, "No colours"),
    (Some(FieldKind::Strain), "Strain"),
    (Some(FieldKind::Stress), "Stress"),
    (Some(FieldKind::VolumeFraction), "Volume fraction"),
    (Some(FieldKind::Speed), "Speed"),
];
const GHOSTS: [(Option<Ghost>, &str); 3] = [
    (None, "No ghost"),
    (Some(Ghost::WithoutFibres), "Without fibres"),
    (Some(Ghost::BeforeEdit), "Before the last edit"),
];

fn place<T: PartialEq + Copy, const N: usize>(all: &[(T, &str); N], chosen: T) -> usize {
    all.iter().position(|(known, _)| *known == chosen).unwrap_or_default()
}

impl App {
    pub(super) fn next_field(&mut self) {
        self.choose_field(FIELDS[(place(&FIELDS, self.seeing.field) + 1) % FIELDS.len()].0);
    }

    pub(super) fn next_ghost(&mut self) {
        self.choose_ghost(GHOSTS[(place(&GHOSTS, self.seeing.ghost) + 1) % GHOSTS.len()].0);
    }

    fn choose_field(&mut self, field: Option<FieldKind>) {
        self.seeing.field = field;
        self.ask(SimCommand::Field(field));
    }

    fn choose_ghost(&mut self, ghost: Option<Ghost>) {
        self.seeing.ghost = ghost;
        let scene = self.ghost_scene();
        if ghost.is_some() && scene.is_none() {
            self.say(Gravity::Note, "Nothing was changed yet: the ghost comes with the next edit");
        }
        self.ask(SimCommand::Ghost(scene));
    }

    /// Tells the simulation what is to run beside the document as it is now.
    pub(super) fn ask_for_ghost(&self) {
        if self.seeing.ghost.is_some() {
            self.ask(SimCommand::Ghost(self.ghost_scene()));
        }
    }

    fn ghost_scene(&self) -> Option<Arc<Scene>> {
        match self.seeing.ghost? {
            Ghost::WithoutFibres => {
                let mut scene = (**self.editor.scene()).clone();
                scene.bodies.iter_mut().for_each(|body| body.fibres.clear());
                Some(Arc::new(scene))
            }
            Ghost::BeforeEdit => self.editor.before_last().cloned(),
        }
    }

    /// The menus of both in the corner of the result.
    pub(super) fn choose_sights(&mut self, ui: &mut Ui) {
        let field = menu(ui, &FIELDS, self.seeing.field, "Colours solids by a value at every point");
        if let Some(field) = field {
            self.choose_field(field);
        }
        let ghost = menu(ui, &GHOSTS, self.seeing.ghost, "Runs the scene otherwise beside it, pale and in step");
        if let Some(ghost) = ghost {
            self.choose_ghost(ghost);
        }
    }
}

/// A button that shows what is chosen and opens a list of all; gives what is chosen anew.
fn menu<T: PartialEq + Copy, const N: usize>(
    ui: &mut Ui,
    all: &[(T, &'static str); N],
    chosen: T,
    tooltip: &str,
) -> Option<T> {
    let mut anew = None;
    let button = ui.menu_button(all[place(all, chosen)].1, |ui| {
        for (each, name) in all {
            if ui.selectable_label(*each == chosen, *name).clicked() {
                anew = Some(*each);
                ui.close();
            }
        }
    });
    button.response.on_hover_text(tooltip);
    anew
}
