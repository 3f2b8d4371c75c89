//! A model by itself, as a scene: what is dropped on the window, or given to a command in the place of a scene.

use super::IoError;
use super::assets::{Stages, load_assets_unless, never, without_pointer};
use crate::geometry::fineness::by_itself_unless;
use crate::scene::{Assets, Body, Material, MeshShape, Scene};
use std::ops::ControlFlow;
use std::path::Path;

/// A model is taken as it is when its greatest extent lies in this range [m], and brought to a hand's size otherwise.
const USUAL_EXTENT: (f64, f64) = (0.02, 5.0);
const HAND: f64 = 0.12;
/// Share of critical damping with which the floor is met: a model comes to rest there.
const LANDING: f64 = 0.2;

/// A model hangs this share of its height above the floor at the start.
const DROP: f64 = 0.15;

/// Particles until it is known how many a model takes.
const LEAST_PARTICLES: u32 = 8;

/// A soft solid in the shape of a model, just above a floor.
#[derive(Clone, Debug)]
pub struct OpenedModel {
    /// The scene. It names the model from the model's own folder.
    pub scene: Scene,
    /// The solid of the model.
    pub assets: Assets,
    /// About how many particles it is filled with.
    pub particles: u32,
    /// That it was brought to another size, and why; none where it was not.
    pub scaled: Option<String>,
    /// Which parts have too few layers of particles, and what would help; none where all have enough.
    pub thin: Option<String>,
}

impl OpenedModel {
    /// What it is made: a soft solid of how many particles, to what size it was brought, which parts are thin.
    pub fn said(&self) -> String {
        let scaled = self.scaled.as_ref().map_or_else(String::new, |scaled| format!(", {scaled}"));
        let thin = self.thin.as_ref().map_or_else(String::new, |thin| format!("; {thin}"));
        format!("a soft solid of about {} particles{scaled}{thin}", self.particles)
    }
}

/// Makes a scene of a model; `progress` hears what is being worked on.
///
/// # Errors
/// A file that cannot be read, or whose surface has no inside.
pub fn open_model(path: &Path, progress: &mut dyn FnMut(&str)) -> Result<OpenedModel, IoError> {
    open_model_unless(path, &mut never(progress))
}

/// [`open_model`], unless `progress` breaks it off.
///
/// # Errors
/// As [`open_model`], and [`IoError::Cancelled`].
pub(crate) fn open_model_unless(path: &Path, progress: &mut Stages<'_>) -> Result<OpenedModel, IoError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let mut shape = MeshShape::new(file).with_particles(LEAST_PARTICLES);
    let mut scene = model_scene(&name, &shape);
    let mut load = |scene: &Scene| load_assets_unless(scene, folder, progress).map_err(without_pointer);
    let mut assets = load(&scene)?;
    let found = assets.solid(&shape).map_or(HAND, |solid| solid.size().max_element());
    let mut scaled = None;
    if !(USUAL_EXTENT.0..=USUAL_EXTENT.1).contains(&found) {
        shape.scale = HAND / found;
        scene = model_scene(&name, &shape);
        assets = load(&scene)?;
        scaled = Some(format!("scaled by {:.3e} to {HAND} m: the file measures {found:.3e} units", shape.scale));
    }
    let mut particles = LEAST_PARTICLES;
    let mut thin = None;
    if let Some(solid) = assets.solid(&shape) {
        let mut tell =
            |done, of| progress(&format!("{}: looking how finely it is filled, {} %", shape.path, 100 * done / of));
        let reach = scene.bodies[0].material.spacing_ratio.recip();
        let ControlFlow::Continue(filled) = by_itself_unless(solid, reach, &mut tell) else {
            return Err(IoError::Cancelled);
        };
        (particles, thin) = (filled.particles, filled.said());
        shape.particles = Some(particles);
        scene = model_scene(&name, &shape);
        let body = &mut scene.bodies[0];
        let low = solid.model.positions.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        body.placement.translation[1] = DROP * solid.size().y - low;
        // What is not used is still to make sense: a fortieth of the size is about what the particles give.
        body.material.support_radius = 0.1 * solid.size().max_element();
    }
    Ok(OpenedModel { scene, assets, particles, scaled, thin })
}

fn model_scene(name: &str, shape: &MeshShape) -> Scene {
    let material = Material::new(1e5, 0.33, 1000.0).with_support_radius(0.01).with_damping(10.0, 0.0);
    let body = Body::from_mesh("model", shape.clone()).with_name(name).with_material(material);
    let mut scene = Scene::new(name).with_floor(0.0).with_body(body);
    scene.room.contact_damping = LANDING;
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    /// Two boxes in one another, of which one lacks a side.
    fn boxes() -> String {
        let corner = |k: u32, at: f64| {
            let bit = |n: u32| at + 0.1 * f64::from(k >> n & 1);
            format!("v {} {} {}\n", bit(0), bit(1), bit(2))
        };
        let corners = [0.0, 0.05].into_iter().flat_map(|at| (0..8).map(move |k| corner(k, at)));
        corners.collect::<String>()
            + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
            + "f 9 11 12 10\nf 13 14 16 15\nf 9 10 14 13\nf 11 15 16 12\nf 9 13 15 11\n"
    }

    #[test]
    fn every_stage_is_told_and_ends_where_it_is_not_wanted() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("boxes.obj");
        std::fs::write(&file, boxes()).expect("written");
        let mut heard = Vec::new();
        let whole = open_model_unless(&file, &mut |said| {
            heard.push(said.to_owned());
            ControlFlow::Continue(())
        });
        whole.expect("an inside");
        let told = |stage: &str| heard.iter().any(|said| said.contains(stage));
        for stage in
            ["reading", "looking for an inside, 0 %", "an inside, 50 %", "an inside, 100 %", "how finely it is filled"]
        {
            assert!(told(stage), "{stage}: {heard:?}");
        }
        let shares = heard.iter().filter_map(|said| said.split("looking for an inside, ").nth(1)?.split(' ').next());
        let shares: Vec<u32> = shares.map(|share| share.parse().expect("a number")).collect();
        assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]), "{shares:?}");
        for last in 1..=heard.len() {
            let mut calls = 0;
            let ended = open_model_unless(&file, &mut |_| {
                calls += 1;
                if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
            let error = ended.expect_err("it is not wanted");
            assert!(matches!(error.bare(), IoError::Cancelled), "{error} at {}", heard[last - 1]);
            assert_eq!(calls, last, "it is not asked again");
        }
    }

    #[test]
    fn a_model_becomes_a_scene_that_stands_above_the_floor() {
        let leaf = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/leaf.glb");
        let OpenedModel { scene, assets, .. } = open_model(&leaf, &mut |_| {}).expect("the model is there");
        scene.validate().expect("a sound scene");
        let body = &scene.bodies[0];
        let Shape::Mesh(shape) = &body.shape else { panic!("a mesh") };
        let solid = assets.solid(shape).expect("loaded");
        let low = solid.model.positions.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        assert!(low + body.placement.translation[1] > 0.0);
    }
}
