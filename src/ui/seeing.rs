//! What is seen besides the bodies: colour maps over them and their fibres, and a ghost that runs in step.

use super::app::{App, Gravity};
use crate::draw::{Bounds, SkinStyle, Slice};
use crate::scene::{Axis, Scene};
use crate::sim::SimCommand;
use crate::solver::snapshot::FieldKind;
use egui::{Slider, SliderClamping, Ui};
use glam::DVec3;
use std::sync::Arc;

/// What was chosen.
#[derive(Default)]
pub(super) struct Seeing {
    field: Option<FieldKind>,
    /// Whether fibres are coloured by what they carry.
    pub(super) tension: bool,
    ghost: Option<Ghost>,
    /// When the newest break that was said happened [s], and what was said of it.
    pub(super) broke: Option<(f64, String)>,
}

/// What runs beside the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ghost {
    WithoutFibres,
    BeforeEdit,
}

const MILLI: f64 = 1e3;
const MICRO: f64 = 1e6;

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

const CUTS: [(Option<Axis>, &str); 4] = [
    (None, "No cut"),
    (Some(Axis::X), "Cut across X"),
    (Some(Axis::Y), "Cut across Y"),
    (Some(Axis::Z), "Cut across Z"),
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

    /// Colours fibres by what they carry, or no longer; a solid that hides them is seen through from then on.
    pub(super) fn toggle_tension(&mut self) {
        self.seeing.tension = !self.seeing.tension;
        if self.seeing.tension {
            if self.display.skin == SkinStyle::Shaded {
                self.display.skin = SkinStyle::XRay;
            }
            if self.seeing.field.is_some() && self.display.slice.is_none() {
                self.say(
                    Gravity::Note,
                    "The colours of the solid hide its fibres: take them off, or cut it open (Alt+X)",
                );
            }
        }
        self.ask(SimCommand::Tension(self.seeing.tension));
    }

    pub(super) fn next_slice(&mut self) {
        let present = self.display.slice.map(|slice| slice.axis);
        self.choose_slice(CUTS[(place(&CUTS, present) + 1) % CUTS.len()].0);
    }

    /// Cuts through the middle of all bodies.
    fn choose_slice(&mut self, axis: Option<Axis>) {
        let middle = self.body_bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
        // To a micrometre; the sum makes a zero of minus zero.
        let at = |axis: Axis| (MICRO * middle[axis.index()]).round() / MICRO + 0.0;
        self.display.slice = axis.map(|axis| Slice { axis, at: at(axis), flipped: false });
    }

    fn body_bounds(&self) -> Option<Bounds> {
        Bounds::of(self.published.snapshot.bodies.iter().flat_map(|body| body.particles.iter().copied()))
    }

    /// Where the cut is, and which side is left.
    fn place_slice(&mut self, ui: &mut Ui) {
        let Some((mut slice, bounds)) = self.display.slice.zip(self.body_bounds()) else { return };
        let axis = slice.axis.index();
        let mut at = MILLI * slice.at;
        let range = (MILLI * bounds.min[axis]).min(at)..=(MILLI * bounds.max[axis]).max(at);
        ui.horizontal(|ui| {
            let slider = Slider::new(&mut at, range)
                .suffix(" mm")
                .max_decimals(1)
                .trailing_fill(true)
                .clamping(SliderClamping::Never);
            if ui.add(slider).on_hover_text("Where the cut is").changed() {
                slice.at = at / MILLI;
            }
            let tooltip = "Takes the other side away";
            if ui.button("Flip").on_hover_text(tooltip).clicked() {
                slice.flipped = !slice.flipped;
            }
        });
        self.display.slice = Some(slice);
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
        let cut = self.display.slice.map(|slice| slice.axis);
        if let Some(axis) = menu(ui, &CUTS, cut, "Cuts solids open; their fibres stay whole (Alt+X)") {
            self.choose_slice(axis);
        }
        if self.display.slice.is_some() {
            ui.end_row();
            self.place_slice(ui);
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
