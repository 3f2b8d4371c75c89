//! Bodies in the shape of models: brought into the scene that is open, beside what is there.

use super::actions::add_body;
use super::free_place::usual_size;
use super::incoming::{Brought, Incoming};
use super::layers::Layers;
use crate::draw::Bounds;
use crate::edit::body_ops::{scaled, scaled_two_layer};
use crate::geometry::model::UpAxis;
use crate::geometry::solid::Solid;
use crate::io::{OpenedModel, path_from};
use crate::scene::{Assets, Body, ClosedMesh, MeshShape, ModelFile, OwnedBody, Shape, TwoLayer, TwoLayerShape};
use crate::ui::context::{Context, Severity};
use glam::DVec3;
use std::convert::Infallible;
use std::path::Path;
use std::sync::Arc;

/// A model is brought to the scene's size where it is more than so many times as large or as small.
const ODD: f64 = 4.0;
/// Vertices of a model that become particles of a two-layer body, at most.
const MOST_VERTICES: usize = 3000;
/// Greatest extent of the paper's two-layer ball [m], whose parameters a new body has in proportion.
const PAPERS: f64 = 4.0;

/// Adds a body in the shape of a model, which was read from a file, to the scene.
pub(crate) fn add_model(path: &Path, opened: OpenedModel, layers: Layers, cx: &mut Context) {
    let mut what = match layers {
        Layers::Filled => format!(", {}", opened.said()),
        Layers::Two => String::new(),
    };
    let Some(body) = opened.scene.bodies.into_iter().next() else { return };
    let Shape::Mesh(shape) = &body.shape else { return };
    let Some(solid) = opened.assets.solid(shape).cloned() else { return };
    let file = path_from(&cx.document.folder, path);
    let mut body: OwnedBody = match layers {
        Layers::Filled => {
            let shape = MeshShape { path: file, ..shape.clone() };
            let id = body.name.to_lowercase().replace(|c: char| !c.is_ascii_alphanumeric(), "-");
            Body { id, shape: shape.into(), ..body }.into()
        }
        Layers::Two => {
            if solid.surface.points.len() > MOST_VERTICES {
                let found = solid.surface.points.len();
                let text = format!(
                    "{} has {found} vertices, each of which would be a particle: give a model of {MOST_VERTICES} or \
                     fewer, or add it as a soft solid",
                    path.display()
                );
                return cx.say(Severity::Error, text);
            }
            let mesh = ClosedMesh { scale: shape.scale, up: shape.up, ..ClosedMesh::new(file) };
            let usual = TwoLayer::from_mesh("balloon", mesh.clone()).with_name(body.name.clone());
            // The springs are the paper's; masses and gas are those of a body of this size.
            let sized = scaled_two_layer(&usual, solid.size().max_element() / PAPERS);
            TwoLayer { shape: TwoLayerShape::Mesh(mesh), ..sized }.into()
        }
    };
    insert(&body, &solid, cx);
    let (found, usual) = (solid.size().max_element(), usual_size(cx));
    let is_odd = cx.scene().all_bodies().next().is_some() && !(usual / ODD..=usual * ODD).contains(&found);
    let mut bounds = Bounds { min: solid.min, max: solid.max };
    if is_odd && let Ok(sized) = scaled(&body, DVec3::ZERO, usual / found) {
        let larger = resized(&solid, usual / found);
        insert(&sized, &larger, cx);
        bounds = Bounds { min: larger.min, max: larger.max };
        body = sized;
        what += ", made as large as what is there";
    }
    body.view_mut().placement_mut().translation = [0.0; 3];
    add_body("Add", &body, bounds, &what, cx);
}

fn insert(body: &OwnedBody, solid: &Arc<Solid>, cx: &mut Context) {
    if let Some(model) = body.view().model() {
        let put = |assets: &mut Assets, _: &Path| {
            assets.insert(model, Arc::clone(solid));
            Ok::<(), Infallible>(())
        };
        let Ok(()) = cx.add_models(put);
    }
}

/// A solid of another size; itself where it cannot be.
fn resized(solid: &Arc<Solid>, factor: f64) -> Arc<Solid> {
    let mut model = solid.model.clone();
    model.stand_up(UpAxis::Y, factor);
    let Ok(mut sized) = Solid::new(&model) else { return Arc::clone(solid) };
    sized.report = solid.report.clone();
    Arc::new(sized)
}

/// Puts in the solid of a body's model, of which there is one in the size that the body had before. False where there
/// is none of either size.
pub(crate) fn scaled_model(before: ModelFile<'_>, after: &OwnedBody, cx: &mut Context) -> bool {
    let Some(now) = after.view().model() else { return true };
    if cx.document.assets().solid(now).is_some() {
        return true;
    }
    let Some(solid) = cx.document.assets().solid(before).cloned() else { return false };
    let solid = resized(&solid, now.scale / before.scale);
    insert(after, &solid, cx);
    true
}

/// A body that comes from elsewhere, for the document; `bounds` is the box around it where it stands [m], unless it is
/// of a model.
///
/// # Errors
/// A model that ships has no place yet.
pub(crate) fn incoming(body: OwnedBody, bounds: Bounds, cx: &Context) -> Result<Incoming, &'static str> {
    let document = &cx.document;
    let keeps_shipped = document.is_example || document.folder.as_os_str().is_empty();
    let (known, folder) = (Arc::clone(document.assets()), document.folder.clone());
    let incoming = Incoming { body, bounds, known, folder, keeps_shipped };
    if !keeps_shipped && document.path.is_none() && incoming.names_shipped() {
        return Err("Save the scene first: the model comes with the program and is put beside the scene's file");
    }
    Ok(incoming)
}

/// Puts a body that comes from elsewhere into the scene, where there is room, with what was read of it.
pub(crate) fn paste_body(brought: Brought, cx: &mut Context) {
    let Brought { body, bounds, models, ships } = brought;
    cx.take_in_models(models);
    cx.document.is_example |= ships;
    add_body("Paste", &body, bounds, "", cx);
}
