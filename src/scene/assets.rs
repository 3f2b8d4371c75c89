//! What a scene refers to but does not hold: the solids that its meshes stand for.

use super::{Axis, ClosedMesh, ColliderMesh, MeshShape};
use crate::geometry::file_mesh::FileMesh;
use crate::geometry::mesh::TriangleMesh;
use crate::geometry::model::{MeshData, Model, UpAxis};
use crate::geometry::model_report::Refusal;
use crate::geometry::obstacle_mesh::ObstacleMesh;
use crate::geometry::point_cache::PointCache;
use crate::geometry::skeleton::Skeleton;
use crate::geometry::solid::Solid;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Solids, and surfaces of colliders, by the files that shapes name, each loaded and checked once. Copies share them.
#[derive(Clone, Debug, Default)]
pub struct Assets {
    solids: BTreeMap<Key, Arc<Solid>>,
    obstacles: BTreeMap<Key, Arc<ObstacleMesh>>,
    /// By paths alone: what bodies follow keeps its file's unit and axes.
    skeletons: BTreeMap<String, Arc<Skeleton>>,
    caches: BTreeMap<String, Arc<PointCache>>,
    rest_meshes: BTreeMap<String, Arc<FileMesh>>,
}

/// A model as a shape names it: all that its solid follows from, but for the content of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelFile<'a> {
    /// The file, relative to the scene file.
    pub path: &'a str,
    /// Metres to a unit of the file.
    pub scale: f64,
    /// Axis of the file that points up.
    pub up: Axis,
}

impl Assets {
    /// Takes in all that others hold, in the place of what is here under the same names.
    #[cfg(feature = "gui")]
    pub(crate) fn take_in(&mut self, others: Self) {
        self.solids.extend(others.solids);
        self.obstacles.extend(others.obstacles);
        self.skeletons.extend(others.skeletons);
        self.caches.extend(others.caches);
        self.rest_meshes.extend(others.rest_meshes);
    }
}

impl<'a> From<&'a MeshShape> for ModelFile<'a> {
    fn from(shape: &'a MeshShape) -> Self {
        Self { path: &shape.path, scale: shape.scale, up: shape.up }
    }
}

impl<'a> From<&'a ClosedMesh> for ModelFile<'a> {
    fn from(shape: &'a ClosedMesh) -> Self {
        Self { path: &shape.path, scale: shape.scale, up: shape.up }
    }
}

impl<'a> From<&'a ColliderMesh> for ModelFile<'a> {
    fn from(mesh: &'a ColliderMesh) -> Self {
        Self { path: &mesh.path, scale: mesh.scale, up: mesh.up }
    }
}

impl<'a> From<&'a str> for ModelFile<'a> {
    /// In metres, Y up.
    fn from(path: &'a str) -> Self {
        Self { path, scale: 1.0, up: Axis::Y }
    }
}

impl ModelFile<'_> {
    /// The axis that points up, as importers have it.
    pub fn up_axis(&self) -> UpAxis {
        match self.up {
            Axis::X => UpAxis::X,
            Axis::Y => UpAxis::Y,
            Axis::Z => UpAxis::Z,
        }
    }
}

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    path: String,
    scale: u64,
    up: usize,
}

impl Key {
    fn of(file: ModelFile<'_>) -> Self {
        Self { path: file.path.to_owned(), scale: file.scale.to_bits(), up: file.up.index() }
    }
}

impl Assets {
    /// The solid that a shape stands for, once it has been put in.
    pub fn solid<'a>(&self, shape: impl Into<ModelFile<'a>>) -> Option<&Arc<Solid>> {
        self.solids.get(&Key::of(shape.into()))
    }

    /// Puts in the solid that a shape stands for: upright and in metres.
    pub fn insert<'a>(&mut self, shape: impl Into<ModelFile<'a>>, solid: Arc<Solid>) {
        self.solids.insert(Key::of(shape.into()), solid);
    }

    /// Puts in what a mesh in memory encloses, under the name that shapes have for its file: nothing is read from there
    /// then. Vertices are [m] with Y up, unless the shape says otherwise. The mesh is checked, and repaired where that
    /// is possible; faces with a vertex that is not there are left out. [`Assets::solid`] tells what was found.
    ///
    /// ```
    /// use sinew::geometry::{Cuboid, box_surface};
    /// use sinew::scene::{Assets, Body, Scene};
    /// use glam::DVec3;
    ///
    /// let mesh = box_surface(&Cuboid { center: DVec3::ZERO, size: DVec3::splat(0.04) }, 0.01);
    /// let mut assets = Assets::default();
    /// assets.insert_mesh("block", &mesh)?;
    /// let body = Body::from_mesh("body", "block");
    /// let scene = Scene::new("Block").with_body(body);
    /// let world = sinew::bake::bake(&scene, &assets)?.world;
    /// // The material's 1000 kg/m³ times 64 cm³.
    /// assert!((world.bodies()[0].state().mass() - 0.064).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Refusal`] where nothing is inside.
    pub fn insert_mesh<'a>(&mut self, shape: impl Into<ModelFile<'a>>, mesh: &TriangleMesh) -> Result<(), Refusal> {
        let file = shape.into();
        self.insert(file, Arc::new(Solid::new(&model_of(file, mesh))?));
        Ok(())
    }

    /// The surface that a collider stands for, once it has been put in.
    pub(crate) fn obstacle<'a>(&self, mesh: impl Into<ModelFile<'a>>) -> Option<&Arc<ObstacleMesh>> {
        self.obstacles.get(&Key::of(mesh.into()))
    }

    /// Puts in the surface of a model, upright and in metres, that a collider stands for.
    ///
    /// # Errors
    /// [`Refusal`] where there is no face.
    pub(crate) fn insert_obstacle_of<'a>(
        &mut self,
        mesh: impl Into<ModelFile<'a>>,
        model: &Model,
    ) -> Result<(), Refusal> {
        self.obstacles.insert(Key::of(mesh.into()), Arc::new(ObstacleMesh::new(model)?));
        Ok(())
    }

    /// Puts in a mesh in memory, closed or open, for colliders that have its name for their file. Vertices are [m] with
    /// Y up, unless the collider says otherwise.
    ///
    /// # Errors
    /// [`Refusal`] where there is no face.
    pub fn insert_obstacle<'a>(
        &mut self,
        collider: impl Into<ModelFile<'a>>,
        mesh: &TriangleMesh,
    ) -> Result<(), Refusal> {
        let file = collider.into();
        self.insert_obstacle_of(file, &model_of(file, mesh))
    }

    /// The skeleton of a file that bodies follow, once it has been put in.
    pub(crate) fn skeleton(&self, path: &str) -> Option<&Arc<Skeleton>> {
        self.skeletons.get(path)
    }

    /// Puts in the skeleton of a file that bodies follow.
    pub(crate) fn insert_skeleton(&mut self, path: &str, skeleton: Skeleton) {
        self.skeletons.insert(path.to_owned(), Arc::new(skeleton));
    }

    /// The point cache of a file that bodies follow, once it has been put in.
    pub(crate) fn cache(&self, path: &str) -> Option<&Arc<PointCache>> {
        self.caches.get(path)
    }

    /// Puts in a point cache that bodies follow.
    pub(crate) fn insert_cache(&mut self, path: &str, cache: PointCache) {
        self.caches.insert(path.to_owned(), Arc::new(cache));
    }

    /// The mesh whose vertices a point cache moves, as its file has it, once it has been put in.
    pub(crate) fn rest_mesh(&self, path: &str) -> Option<&Arc<FileMesh>> {
        self.rest_meshes.get(path)
    }

    /// Puts in the mesh whose vertices a point cache moves, in its file's unit and axes.
    pub(crate) fn insert_rest_mesh(&mut self, path: &str, mesh: Arc<FileMesh>) {
        self.rest_meshes.insert(path.to_owned(), mesh);
    }

    /// Number of solids.
    pub fn len(&self) -> usize {
        self.solids.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.solids.is_empty()
    }
}

/// A mesh in memory as a model, upright and in metres.
fn model_of(file: ModelFile<'_>, mesh: &TriangleMesh) -> Model {
    let mut model = Model::default();
    model.add(MeshData {
        name: file.path.to_owned(),
        positions: mesh.positions.clone(),
        triangles: mesh.triangles.clone(),
        ..MeshData::default()
    });
    model.file = Some(Arc::new(FileMesh::of_triangles(file.path, mesh.positions.clone(), &mesh.triangles)));
    model.stand_up(file.up_axis(), file.scale);
    model
}
