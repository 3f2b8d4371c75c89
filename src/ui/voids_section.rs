//! Voids of the active body: what is taken out of it.

use super::context::{Context, Step};
use super::field::{NumberField, vector};
use super::theme::GRID;
use crate::edit::Command;
use crate::scene::{Body, BoxShape, Shape, Void, VoidShape};
use egui::{RichText, Ui};

const RADIUS: NumberField = NumberField::new(
    "Radius",
    "m",
    1e-6..=100.0,
    None,
    "What lies this near to its centre or line is taken out. Two layers of particles must be left beside it",
);

/// Radius of a new void, in spacings.
const FIRST_RADIUS: f64 = 2.0;

/// Shows the voids of a body.
pub(super) fn voids_section(ui: &mut Ui, cx: &mut Context, body: &Body) {
    ui.add_space(2.0 * GRID);
    ui.heading("Voids");
    let mut voids = body.voids.clone();
    let mut step = Step::Present;
    let mut gone = None;
    for (index, void) in voids.iter_mut().enumerate() {
        ui.push_id(("void", index), |ui| {
            ui.horizontal(|ui| {
                ui.label(void.title().to_owned());
                if ui.button("Fill").on_hover_text("Fills this void again").clicked() {
                    gone = Some(index);
                }
            });
            match &mut void.shape {
                VoidShape::Sphere { center, radius, .. } => {
                    vector(ui, "Centre", "m", center, "In the model frame");
                    RADIUS.show(ui, radius);
                }
                VoidShape::Box { min, max, .. } => {
                    vector(ui, "From", "m", min, "Least corner, in the model frame");
                    vector(ui, "To", "m", max, "Greatest corner, in the model frame");
                }
                VoidShape::Tube { radius, .. } => {
                    RADIUS.show(ui, radius);
                }
                VoidShape::Mesh(mesh) => {
                    ui.label(RichText::new(&mesh.path).weak().small());
                }
            }
        });
    }
    if let Some(index) = gone {
        voids.remove(index);
        step = Step::Own;
    }
    ui.horizontal_wrapped(|ui| {
        if let Some(void) = new_void(ui, cx, body) {
            voids.push(void);
            step = Step::Own;
        }
    });
    if voids != body.voids {
        cx.edit(&Command::SetVoids { body: body.id.clone(), voids }, step);
    }
    tube_of_fibre(ui, cx, body);
}

fn id_of(what: &str, body: &Body) -> String {
    let is_free = |id: &String| body.voids.iter().all(|void| void.id != *id);
    (1..=body.voids.len() + 1).map(|n| format!("{what} {n}")).find(is_free).unwrap_or_default()
}

/// A ball or box in the middle of the body that a person wants taken out.
fn new_void(ui: &mut Ui, cx: &Context, body: &Body) -> Option<Void> {
    let radius = FIRST_RADIUS * body.material.spacing();
    let [x, y, z] = middle(cx, body);
    let mut void = None;
    if ui.button("Take a ball out").on_hover_text("Takes a ball out of the body's middle").clicked() {
        void = Some(Void::sphere(id_of("Ball", body), [x, y, z], radius));
    }
    if ui.button("Take a box out").on_hover_text("Takes a box out of the body's middle").clicked() {
        let (min, max) = ([x - radius, y - radius, z - radius], [x + radius, y + radius, z + radius]);
        void = Some(Void::in_box(id_of("Box", body), min, max));
    }
    void
}

/// The middle of the body [m].
fn middle(cx: &Context, body: &Body) -> [f64; 3] {
    match &body.shape {
        Shape::Box(BoxShape { center, .. }) => *center,
        Shape::Ball(_) | Shape::Cylinder(_) | Shape::Capsule(_) | Shape::Torus(_) => [0.0; 3],
        Shape::Mesh(mesh) => {
            let solid = cx.document.assets().solid(mesh);
            solid.map_or([0.0; 3], |solid| (0.5 * (solid.min + solid.max)).to_array())
        }
    }
}

/// Makes a tube of the selected fibre, which goes.
fn tube_of_fibre(ui: &mut Ui, cx: &mut Context, body: &Body) {
    let Some((_, fibre)) = cx.selected_fibre() else { return };
    let fibre = fibre.clone();
    let text = "Takes a tube out along the selected fibre, which goes";
    if !ui.button("Make a tube of the fibre").on_hover_text(text).clicked() {
        return;
    }
    let radius = FIRST_RADIUS * body.material.spacing();
    let tube = Void::tube(id_of("Tube", body), fibre.source.clone(), radius);
    let voids = body.voids.iter().cloned().chain([tube]).collect();
    let commands = vec![
        Command::RemoveFibre { body: body.id.clone(), fibre: fibre.id.clone() },
        Command::SetVoids { body: body.id.clone(), voids },
    ];
    cx.edit(&Command::Many { name: format!("Make a tube of {}", fibre.title()), commands }, Step::Own);
}
