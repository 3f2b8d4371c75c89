//! What the window opens: a scene and the models that it names, or a model alone.

use crate::geometry::fineness::{BY_ITSELF, Fineness, fineness};
use crate::geometry::solid::Solid;
use crate::io::{IoError, is_model, load_assets, load_scene, resolved, scene_from_json, unknown_fields};
use crate::scene::{Assets, Body, Material, MeshShape, Scene};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// The built-in scene.
const BUILT_IN: &str = include_str!("../../scenes/short_bar_soft.json");

/// A model is taken as it is when its greatest extent lies in this range [m], and brought to a hand's size otherwise.
const USUAL_EXTENT: (f64, f64) = (0.02, 5.0);
const HAND: f64 = 0.12;
/// A model hangs this share of its height above the floor at the start.
const DROP: f64 = 0.15;

/// A scene as it was read.
#[derive(Clone, Debug)]
pub struct Document {
    /// The scene.
    pub scene: Scene,
    /// The models that it names.
    pub assets: Arc<Assets>,
    /// Where it was read from; none for what is not a scene's file.
    pub path: Option<PathBuf>,
    /// Folder from which the scene names its models.
    pub folder: PathBuf,
    /// What is to be said about it.
    pub note: Option<String>,
}

impl Document {
    /// Reads a scene and its models, or makes a scene of a model; the built-in one unless a path is given.
    ///
    /// # Errors
    /// A file that cannot be used.
    pub fn load(path: Option<PathBuf>) -> Result<Self, IoError> {
        if let Some(path) = path.as_deref().filter(|path| is_model(path)) {
            return Self::of_model(path);
        }
        let scene = path.as_deref().map_or_else(|| scene_from_json(BUILT_IN), load_scene)?;
        let folder = path.as_deref().and_then(Path::parent).unwrap_or(Path::new("")).to_owned();
        let assets = Arc::new(load_assets(&scene, &folder, &mut |_| {})?);
        let note = path.as_deref().and_then(|path| unknown(path, &scene));
        Ok(Self { scene, assets, path, folder, note })
    }

    /// Whether it is what the window starts with unless it is given something else.
    pub(super) fn is_built_in(&self) -> bool {
        self.path.is_none() && self.note.is_none()
    }

    /// A soft solid in the shape of a model, just above a floor.
    fn of_model(path: &Path) -> Result<Self, IoError> {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut shape = MeshShape::new(file).with_particles(BY_ITSELF[0]);
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut scene = model_scene(&name, &shape);
        let mut assets = load_assets(&scene, &folder, &mut |_| {})?;
        let extent = |assets: &Assets, shape: &MeshShape| {
            assets.solid(shape).map_or(HAND, |solid: &Arc<Solid>| solid.size().max_element())
        };
        let found = extent(&assets, &shape);
        let mut scaled = String::new();
        if !(USUAL_EXTENT.0..=USUAL_EXTENT.1).contains(&found) {
            shape.scale = HAND / found;
            scene = model_scene(&name, &shape);
            assets = load_assets(&scene, &folder, &mut |_| {})?;
            scaled = format!(", scaled by {:.3e} to {HAND} m: the file measures {found:.3e} units", shape.scale);
        }
        let mut filled = Fineness { particles: BY_ITSELF[0], given_up: None };
        if let Some(solid) = assets.solid(&shape) {
            filled = fineness(solid, BY_ITSELF);
            shape.particles = Some(filled.particles);
            scene = model_scene(&name, &shape);
            let body = &mut scene.bodies[0];
            let low = solid.model.positions.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
            body.placement.translation[1] = DROP * solid.size().y - low;
            // What is not used is still to make sense: a fortieth of the size is about what the particles give.
            body.material.support_radius = 0.1 * solid.size().max_element();
        }
        let thin = filled.given_up.map_or(String::new(), |thin| format!("; {thin}"));
        let note = format!("Opened {name} as a soft solid of about {} particles{scaled}{thin}", filled.particles);
        Ok(Self { scene, assets: Arc::new(assets), path: None, folder, note: Some(note) })
    }
}

/// What is to be said of fields that this program does not know.
fn unknown(path: &Path, scene: &Scene) -> Option<String> {
    let fields = unknown_fields(scene);
    let (first, more) = (fields.first()?, fields.len() - 1);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    Some(format!("Opened {}: {first}{more} is unknown here; it is kept but does nothing", path.display()))
}

fn model_scene(name: &str, shape: &MeshShape) -> Scene {
    let material = Material::new(1e5, 0.33, 1000.0).with_support_radius(0.01).with_damping(10.0, 0.0);
    let body = Body::from_mesh("model", shape.clone()).with_name(name).with_material(material);
    Scene::new(name).with_floor(0.0).with_body(body)
}

/// `scene` with the models that it names from the folder `from` named from the folder `to`.
pub(super) fn moved(scene: &Scene, from: &Path, to: &Path) -> Scene {
    let mut scene = scene.clone();
    let (Some(from), Some(to)) = (resolved(from), resolved(to)) else { return scene };
    if from == to {
        return scene;
    }
    for path in scene.model_paths_mut() {
        *path = seen_from(&from.join(&*path), &to);
    }
    scene
}

/// A path relative to a folder, both absolute, with `/` between the names.
fn seen_from(path: &Path, folder: &Path) -> String {
    let path = resolved(path).unwrap_or_else(|| path.to_owned());
    let shared = path.components().zip(folder.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(shared).map(|_| "..".to_owned());
    let down =
        path.components().skip(shared).map(|part: Component<'_>| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    fn asset(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name)
    }

    #[test]
    fn a_model_becomes_a_scene_that_stands_above_the_floor() {
        let document = Document::load(Some(asset("leaf.glb"))).expect("the model is there");
        document.scene.validate().expect("a sound scene");
        assert!(document.path.is_none() && document.note.is_some());
        let body = &document.scene.bodies[0];
        let Shape::Mesh(shape) = &body.shape else { panic!("a mesh") };
        let solid = document.assets.solid(shape).expect("loaded");
        let low = solid.model.positions.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        assert!(low + body.placement.translation[1] > 0.0);
    }

    #[test]
    fn a_scene_saved_elsewhere_still_finds_its_models() {
        let document = Document::load(Some(asset("leaf.glb"))).expect("the model is there");
        let elsewhere = tempfile::tempdir().expect("a folder");
        let moved = moved(&document.scene, &document.folder, elsewhere.path());
        let Shape::Mesh(shape) = &moved.bodies[0].shape else { panic!("a mesh") };
        assert!(shape.path.contains(".."), "{}", shape.path);
        load_assets(&moved, elsewhere.path(), &mut |_| {}).expect("the model is found");
        assert_eq!(super::moved(&document.scene, &document.folder, &document.folder), document.scene);
    }
}
