//! What is seen of the bodies: colour maps over them and their fibres, cuts, and a ghost that runs in step.

use crate::draw::{Bounds, Display, SkinStyle, Slice};
use crate::scene::Axis;
use crate::sim::SimCommand;
use crate::solver::snapshot::FieldKind;
use crate::ui::context::{Context, Ghost, Severity};
use egui::{Slider, SliderClamping, Ui};
use glam::DVec3;

/// What was chosen.
pub(crate) struct ViewOptions {
    /// How the result is drawn.
    pub display: Display,
    field: Option<FieldKind>,
    /// Whether fibres are coloured by what they carry.
    pub tension: bool,
    /// Whether they are coloured, and bulge, by what they do by themselves.
    pub activation: bool,
    /// Whether the camera goes along with the active body.
    pub follow: bool,
}

impl Default for ViewOptions {
    fn default() -> Self {
        let display = Display { skin: SkinStyle::XRay, axes: false, ..Display::default() };
        Self { display, field: None, tension: false, activation: false, follow: false }
    }
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

/// What follows what is chosen.
fn next<T: PartialEq + Copy, const N: usize>(all: &[(T, &str); N], chosen: T) -> T {
    all[(place(all, chosen) + 1) % N].0
}

impl ViewOptions {
    /// The field that solids are coloured by.
    pub(crate) fn field(&self) -> Option<FieldKind> {
        self.field
    }

    /// The next colour map, or none.
    pub(crate) fn next_field(&mut self, cx: &Context) {
        self.choose_field(next(&FIELDS, self.field), cx);
    }

    /// The next scene beside the document, or none.
    pub(crate) fn next_ghost(cx: &mut Context) {
        choose_ghost(next(&GHOSTS, cx.simulation.ghost()), cx);
    }

    /// The next cut, or none.
    pub(crate) fn next_slice(&mut self, cx: &Context) {
        self.choose_slice(next(&CUTS, self.display.slice.map(|slice| slice.axis)), cx);
    }

    /// Shows the fibres through the solid, or no longer.
    pub(crate) fn toggle_see_through(&mut self) {
        let skin = &mut self.display.skin;
        *skin = if *skin == SkinStyle::XRay { SkinStyle::Shaded } else { SkinStyle::XRay };
    }

    /// Shows particles, or no longer.
    pub(crate) fn toggle_particles(&mut self) {
        self.display.particles = !self.display.particles;
        self.display.structure = self.display.particles;
    }

    /// Colours fibres by what they carry, or no longer; a solid that hides them is seen through from then on.
    pub(crate) fn toggle_tension(&mut self, cx: &mut Context) {
        self.tension = !self.tension;
        if self.tension {
            self.activation = false;
            self.see_fibres(cx);
        }
        self.ask_for_colours(cx);
    }

    /// Colours fibres by what they do by themselves, or no longer; a solid that hides them is seen through from then
    /// on.
    pub(crate) fn toggle_activation(&mut self, cx: &mut Context) {
        self.activation = !self.activation;
        if self.activation {
            self.tension = false;
            self.see_fibres(cx);
            let acts = |body: crate::scene::AnyBody<'_>| body.fibres().iter().any(|fibre| fibre.activation.is_some());
            if !cx.scene().all_bodies().any(acts) {
                cx.say(Severity::Note, "No fibre acts yet: Activation in the inspector of a fibre lets it");
            }
        }
        self.ask_for_colours(cx);
    }

    fn ask_for_colours(&self, cx: &Context) {
        cx.ask(SimCommand::Tension(self.tension));
        cx.ask(SimCommand::Activation(self.activation));
    }

    /// Sees through a solid that hides its fibres.
    fn see_fibres(&mut self, cx: &mut Context) {
        if self.display.skin == SkinStyle::Shaded {
            self.display.skin = SkinStyle::XRay;
        }
        if self.field.is_some() && self.display.slice.is_none() {
            cx.say(Severity::Note, "The colours of the solid hide its fibres: take them off, or cut it open (Alt+X)");
        }
    }

    /// Nothing is cut any more: another document is shown.
    pub(crate) fn forget_slice(&mut self) {
        self.display.slice = None;
    }

    fn choose_field(&mut self, field: Option<FieldKind>, cx: &Context) {
        self.field = field;
        cx.ask(SimCommand::Field(field));
    }

    /// Cuts through the middle of all bodies.
    fn choose_slice(&mut self, axis: Option<Axis>, cx: &Context) {
        let middle = body_bounds(cx).map_or(DVec3::ZERO, |bounds| bounds.center());
        // To a micrometre; the sum makes a zero of minus zero.
        let at = |axis: Axis| (MICRO * middle[axis.index()]).round() / MICRO + 0.0;
        self.display.slice = axis.map(|axis| Slice { axis, at: at(axis), flipped: false });
    }

    /// Where the cut is, and which side is left.
    fn place_slice(&mut self, ui: &mut Ui, cx: &Context) {
        let Some((mut slice, bounds)) = self.display.slice.zip(body_bounds(cx)) else { return };
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

    /// The menus in the corner of the result.
    pub(crate) fn menus(&mut self, ui: &mut Ui, cx: &mut Context) {
        let field = menu(ui, &FIELDS, self.field, "Colours solids by a value at every point");
        if let Some(field) = field {
            self.choose_field(field, cx);
        }
        let ghost = menu(ui, &GHOSTS, cx.simulation.ghost(), "Runs the scene otherwise beside it, pale and in step");
        if let Some(ghost) = ghost {
            choose_ghost(ghost, cx);
        }
        let cut = self.display.slice.map(|slice| slice.axis);
        if let Some(axis) = menu(ui, &CUTS, cut, "Cuts solids open; their fibres stay whole (Alt+X)") {
            self.choose_slice(axis, cx);
        }
        if self.display.slice.is_some() {
            ui.end_row();
            self.place_slice(ui, cx);
        }
    }
}

fn choose_ghost(ghost: Option<Ghost>, cx: &mut Context) {
    if !cx.simulation.choose_ghost(ghost, &cx.document) {
        cx.say(Severity::Note, "Nothing was changed yet: the ghost comes with the next edit");
    }
}

fn body_bounds(cx: &Context) -> Option<Bounds> {
    let bodies = &cx.simulation.published().snapshot.bodies;
    Bounds::of(bodies.iter().flat_map(|body| body.particles.iter().copied()))
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
