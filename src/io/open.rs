//! A model by itself, as a scene: what is dropped on the window, or given to a command in the place of a scene.

use super::{IoError, load_assets};
use crate::geometry::fill::{FillError, FillResolution, fill};
use crate::geometry::fineness::{BY_ITSELF, Fineness, fineness};
use crate::geometry::solid::Solid;
use crate::scene::{Assets, Body, MAX_PARTICLES, Material, MeshShape, Scene};
use std::path::Path;

/// A model is taken as it is when its greatest extent lies in this range [m], and brought to a hand's size otherwise.
const USUAL_EXTENT: (f64, f64) = (0.02, 5.0);
const HAND: f64 = 0.12;
/// A model hangs this share of its height above the floor at the start.
const DROP: f64 = 0.15;

/// Particles up to which a model is opened that falls apart in fewer.
const MOST_ANYWAY: u32 = 1_000_000;

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

/// Makes a scene of a model; `progress` hears what is being worked on.
///
/// # Errors
/// A file that cannot be read, or whose surface has no inside.
pub fn open_model(path: &Path, progress: &mut dyn FnMut(&str)) -> Result<OpenedModel, IoError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let mut shape = MeshShape::new(file).with_particles(BY_ITSELF[0]);
    let mut scene = model_scene(&name, &shape);
    let mut load = |scene: &Scene| load_assets(scene, folder, progress).map_err(without_pointer);
    let mut assets = load(&scene)?;
    let found = assets.solid(&shape).map_or(HAND, |solid| solid.size().max_element());
    let mut scaled = None;
    if !(USUAL_EXTENT.0..=USUAL_EXTENT.1).contains(&found) {
        shape.scale = HAND / found;
        scene = model_scene(&name, &shape);
        assets = load(&scene)?;
        scaled = Some(format!("scaled by {:.3e} to {HAND} m: the file measures {found:.3e} units", shape.scale));
    }
    let mut filled = Fineness { particles: BY_ITSELF[0], given_up: None };
    let mut taken = None;
    if let Some(solid) = assets.solid(&shape) {
        filled = fineness(solid, BY_ITSELF);
        taken = taken_anyway(solid, &filled, scene.bodies[0].material.spacing_ratio.recip());
        filled.particles = taken.unwrap_or(filled.particles);
        shape.particles = Some(filled.particles);
        scene = model_scene(&name, &shape);
        let body = &mut scene.bodies[0];
        let low = solid.model.positions.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        body.placement.translation[1] = DROP * solid.size().y - low;
        // What is not used is still to make sense: a fortieth of the size is about what the particles give.
        body.material.support_radius = 0.1 * solid.size().max_element();
    }
    let thin = match taken {
        Some(_) => Some("fewer would not hold it together, and so many do not run in real time".to_owned()),
        None => filled.given_up.map(|thin| thin.to_string()),
    };
    Ok(OpenedModel { scene, assets, particles: filled.particles, scaled, thin })
}

/// The particles that a solid takes all the same where those that it would be opened with do not hold it together; none where
/// they do, or where not even the most do.
fn taken_anyway(solid: &Solid, filled: &Fineness, reach: f64) -> Option<u32> {
    filled.given_up?;
    match fill(solid, FillResolution::Particles(filled.particles), reach, MAX_PARTICLES) {
        Err(FillError::TooThin { suggested: Some(spacing), .. }) => {
            Some(solid.particles_at(spacing)).filter(|&count| count <= MOST_ANYWAY)
        }
        _ => None,
    }
}

/// Nobody has written the scene in which the error is.
fn without_pointer(error: IoError) -> IoError {
    match error {
        IoError::Asset { error, .. } => *error,
        other => other,
    }
}

fn model_scene(name: &str, shape: &MeshShape) -> Scene {
    let material = Material::new(1e5, 0.33, 1000.0).with_support_radius(0.01).with_damping(10.0, 0.0);
    let body = Body::from_mesh("model", shape.clone()).with_name(name).with_material(material);
    Scene::new(name).with_floor(0.0).with_body(body)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::lattice::Cuboid;
    use crate::geometry::mesh::box_surface;
    use crate::scene::Shape;
    use glam::DVec3;
    use std::path::PathBuf;

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

    /// An OBJ of a box.
    fn box_file(folder: &Path, size: DVec3) -> PathBuf {
        let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size }, size.max_element());
        let vertices = mesh.positions.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z));
        let faces = mesh.triangles.iter().map(|t| t.map(|i| i + 1)).map(|[a, b, c]| format!("f {a} {b} {c}\n"));
        let path = folder.join("plate.obj");
        std::fs::write(&path, vertices.chain(faces).collect::<String>()).expect("written");
        path
    }

    #[test]
    fn what_falls_apart_in_the_most_particles_is_opened_in_as_many_as_hold_it_together() {
        let folder = tempfile::tempdir().expect("a folder");
        // One layer of 50,000 particles is 3.2 mm thick.
        let path = box_file(folder.path(), DVec3::new(0.9, 0.0036, 0.7));
        let OpenedModel { scene, assets, particles, thin, .. } = open_model(&path, &mut |_| {}).expect("a model");
        let Shape::Mesh(shape) = &scene.bodies[0].shape else { panic!("a mesh") };
        assert!(particles > BY_ITSELF[2] && shape.particles == Some(particles), "{particles}");
        assert!(thin.is_some_and(|text| text.contains("real time")));
        let solid = assets.solid(shape).expect("loaded");
        let reach = scene.bodies[0].material.spacing_ratio.recip();
        let filling = fill(solid, FillResolution::Particles(particles), reach, MAX_PARTICLES).expect("a filling");
        assert_eq!(filling.thinness.single, 0);
        assert!(filling.volume_error.abs() < 0.02, "{}", filling.volume_error);
    }
}
