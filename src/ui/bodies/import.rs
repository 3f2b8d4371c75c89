//! Bodies in the shape of models: brought into the scene that is open, beside what is there.

use super::actions::add_body;
use super::free_place::usual_size;
use super::layers::Layers;
use crate::draw::Bounds;
use crate::edit::body_ops::{placed, scaled, scaled_two_layer};
use crate::geometry::model::UpAxis;
use crate::geometry::solid::Solid;
use crate::io::{OpenedModel, add_leader};
use crate::scene::{Assets, Body, ClosedMesh, Leader, MeshShape, ModelFile, OwnedBody, Shape, TwoLayer, TwoLayerShape};
use crate::ui::context::{Context, Severity};
use crate::ui::document::named_from;
use crate::ui::gallery::{shipped_beside, shipped_or_read};
use glam::DVec3;
use std::convert::Infallible;
use std::ops::ControlFlow;
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
    let file = named_from(path, &cx.document.folder);
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

/// Puts in the files of a body that comes from elsewhere, its model and the motions that it follows, which it names by
/// whole paths or as those that ship, and names them as the document does. Gives the box around the body as it is
/// placed [m]; none where it is of no model.
///
/// # Errors
/// What cannot be read.
pub(crate) fn bring_models(body: &mut OwnedBody, cx: &mut Context) -> Result<Option<Bounds>, String> {
    let around = bring_model(body, cx)?;
    bring_leaders(body, cx)?;
    Ok(around)
}

fn bring_leaders(body: &mut OwnedBody, cx: &mut Context) -> Result<(), String> {
    for follow in body.view_mut().follows_mut() {
        for path in follow.leader.paths_mut() {
            *path = brought(path, cx)?;
        }
        let is_there = match &follow.leader {
            Leader::Skeleton(of) => cx.document.assets().skeleton(&of.path).is_some(),
            Leader::Cache(of) => {
                let rest = of.rest.as_ref().is_none_or(|rest| cx.document.assets().rest_mesh(rest).is_some());
                rest && cx.document.assets().cache(&of.path).is_some()
            }
        };
        if !is_there {
            let added = cx.add_models(|assets, folder| {
                add_leader(assets, &follow.leader, folder, &mut |_| ControlFlow::Continue(()))
            });
            added.map_err(|error| error.to_string())?;
        }
    }
    Ok(())
}

/// The name that the document has for a file that is named by a whole path or as one of those that ship.
fn brought(path: &str, cx: &mut Context) -> Result<String, String> {
    let whole = Path::new(path);
    if whole.is_absolute() { Ok(named_from(whole, &cx.document.folder)) } else { put_down(path, cx) }
}

fn bring_model(body: &mut OwnedBody, cx: &mut Context) -> Result<Option<Bounds>, String> {
    let Some(model) = body.view().model() else { return Ok(None) };
    let bounds = |solid: &Solid| {
        let corners = Bounds { min: solid.min, max: solid.max }.corners();
        Bounds::of(corners.map(|at| placed(body.view().placement(), at)))
    };
    let path = Path::new(model.path).to_owned();
    let file = brought(model.path, cx)?;
    let named = ModelFile { path: &file, ..model };
    let found = match cx.document.assets().solid(named) {
        Some(solid) => Arc::clone(solid),
        None => Arc::new(read(&path, model)?),
    };
    let around = bounds(&found);
    if let Some(path) = body.view_mut().into_model_paths().into_iter().next() {
        *path = file;
    }
    insert(body, &found, cx);
    Ok(around)
}

/// A model that ships has no folder: it goes beside the scene's file, now or when the scene is first saved. Gives its
/// name.
fn put_down(name: &str, cx: &mut Context) -> Result<String, String> {
    if cx.document.is_example || cx.document.folder.as_os_str().is_empty() {
        cx.document.is_example = true;
        return Ok(name.to_owned());
    }
    if cx.document.path.is_none() {
        return Err(format!("Save the scene first: {name} comes with the program and is put beside the scene's file"));
    }
    shipped_beside(&cx.document.folder, name).map_err(|error| error.to_string())
}

fn read(path: &Path, model: ModelFile<'_>) -> Result<Solid, String> {
    let mut loaded = shipped_or_read(path).map_err(|error| error.to_string())?;
    loaded.stand_up(model.up_axis(), model.scale);
    Solid::new(&loaded).map_err(|refusal| format!("{}: {refusal}", path.display()))
}
