//! Where the active body stands and what shape it has, as numbers. A change begins the scene anew.

use super::actions::begin_anew;
use super::import::scaled_model;
use super::made::spacing_for;
use crate::edit::Command;
use crate::edit::body_ops::scaled;
use crate::scene::{AnyBody, Body, MeshShape, OwnedBody, Placement, Shape, TwoLayer, TwoLayerShape};
use crate::ui::context::{Context, Severity, Step};
use crate::ui::field::{NumberField, vector};
use crate::ui::theme::GRID;
use egui::{CollapsingHeader, Ui};
use glam::DVec3;

const TURNED: NumberField = NumberField::new(
    "Turned by",
    "°",
    -360.0..=360.0,
    Some(0.0),
    "Turn about the axis, right-handed, through the body's origin",
);
const SEGMENT: NumberField = length("Length", "Length of the segment at rest");
const RADIUS: NumberField = length("Radius", "Of the ball, the cylinder, or the middle of the torus's tube");
const HEIGHT: NumberField = length("Height", "Of the cylinder, without its round ends");
const TUBE: NumberField = length("Tube radius", "Radius of the torus's tube");
const OUTER: NumberField = length("Outer radius", "Radius of the outer layer");
const INNER: NumberField = length("Inner radius", "Radius of the inner layer");
const COUNT: NumberField = NumberField::new(
    "Particles",
    "",
    8.0..=20000.0,
    None,
    "About how many particles fill the model; spacing and support radius follow",
);
const SCALE: NumberField = NumberField::new(
    "Scale",
    "",
    1e-6..=1e6,
    None,
    "Metres to a unit of the model's file; what is in the body goes along",
);

const fn length(label: &'static str, tooltip: &'static str) -> NumberField {
    NumberField::new(label, "m", 1e-5..=1e3, None, tooltip)
}

/// Shows where the active body stands at the start, and its shape.
pub(crate) fn place_and_shape(ui: &mut Ui, cx: &mut Context) {
    let Some(body) = cx.scene().any_body(cx.active.index).map(AnyBody::owned) else { return };
    ui.add_space(GRID);
    CollapsingHeader::new("Place and shape").default_open(true).show(ui, |ui| {
        place(ui, body.view().id(), body.view().placement(), cx);
        shape(ui, &body, cx);
    });
}

fn place(ui: &mut Ui, id: &str, before: &Placement, cx: &mut Context) {
    let mut placement = before.clone();
    vector(ui, "Position", "m", &mut placement.translation, "Where the body's origin is at the start, world");
    TURNED.show(ui, &mut placement.rotation.degrees);
    if placement.rotation.degrees != 0.0 {
        vector(ui, "About", "", &mut placement.rotation.axis, "Axis of the turn, of any length but zero");
    }
    if placement != *before {
        cx.edit(&Command::SetPlacement { body: id.to_owned(), placement }, Step::Present);
        begin_anew(cx);
    }
}

fn shape(ui: &mut Ui, before: &OwnedBody, cx: &mut Context) {
    let changed = match before {
        OwnedBody::Solid(body) => solid_shape(ui, body).map(OwnedBody::from),
        OwnedBody::TwoLayer(body) => Some(two_layer_shape(ui, body).into()),
    };
    let Some(body) = changed.filter(|changed| changed != before) else { return };
    let is_there = before.view().model().is_none_or(|model| scaled_model(model, &body, cx));
    if is_there {
        cx.edit(&Command::SetBody { verb: "Shape".to_owned(), body }, Step::Present);
        begin_anew(cx);
    } else {
        cx.say(Severity::Error, "The model has no inside in that size");
    }
}

/// The body with the shape that is asked for, as many particles as before in it; none where a number makes no sense.
fn solid_shape(ui: &mut Ui, body: &Body) -> Option<Body> {
    let mut shape = body.shape.clone();
    match &mut shape {
        Shape::Box(shape) => {
            vector(ui, "Size", "m", &mut shape.size, "Full extents of the box");
        }
        Shape::Ball(shape) => {
            RADIUS.show(ui, &mut shape.radius);
        }
        Shape::Cylinder(shape) => {
            RADIUS.show(ui, &mut shape.radius);
            HEIGHT.show(ui, &mut shape.height);
        }
        Shape::Capsule(shape) => {
            RADIUS.show(ui, &mut shape.radius);
            HEIGHT.show(ui, &mut shape.height);
        }
        Shape::Torus(shape) => {
            RADIUS.show(ui, &mut shape.radius);
            TUBE.show(ui, &mut shape.tube_radius);
            shape.tube_radius = shape.tube_radius.min(0.95 * shape.radius);
        }
        Shape::Mesh(shape) => return mesh_shape(ui, body, shape),
    }
    if shape == body.shape {
        return None;
    }
    let mut changed = Body { shape, ..body.clone() };
    let particles = body.shape.volume()? / body.material.spacing().powi(3);
    let spacing = spacing_for(&changed.shape, particles)?;
    changed.material.support_radius = spacing / changed.material.spacing_ratio;
    Some(changed)
}

fn mesh_shape(ui: &mut Ui, body: &Body, shape: &MeshShape) -> Option<Body> {
    let mut scale = shape.scale;
    if SCALE.show(ui, &mut scale) && scale > 0.0 {
        let at = DVec3::from_array(body.placement.translation);
        let larger = scaled(&body.clone().into(), at, scale / shape.scale).ok()?;
        return match larger {
            OwnedBody::Solid(body) => Some(*body),
            OwnedBody::TwoLayer(_) => None,
        };
    }
    let mut particles = f64::from(shape.particles?);
    COUNT.show(ui, &mut particles);
    let shape = MeshShape { particles: Some(particles.round() as u32), ..shape.clone() };
    Some(Body { shape: shape.into(), ..body.clone() })
}

fn two_layer_shape(ui: &mut Ui, body: &TwoLayer) -> TwoLayer {
    let mut body = body.clone();
    match &mut body.shape {
        TwoLayerShape::Segment(shape) => {
            SEGMENT.show(ui, &mut shape.length);
        }
        TwoLayerShape::Ring(shape) => {
            OUTER.show(ui, &mut shape.outer_radius);
            INNER.show(ui, &mut shape.inner_radius);
        }
        TwoLayerShape::Ball(shape) => {
            OUTER.show(ui, &mut shape.outer_radius);
            INNER.show(ui, &mut shape.inner_radius);
        }
        TwoLayerShape::Mesh(shape) => {
            SCALE.show(ui, &mut shape.scale);
        }
    }
    body
}
