//! What a scene refers to but does not hold: the solids that its meshes stand for.

use super::{Axis, MeshShape, Scene, Shape};
use crate::geometry::model::Up;
use crate::geometry::solid::Solid;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Solids by the shapes that name them, each loaded and checked once. Copies share them.
#[derive(Clone, Debug, Default)]
pub struct Assets {
    solids: BTreeMap<Key, Arc<Solid>>,
}

/// All that a solid follows from, but for the content of its file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    path: String,
    scale: u64,
    up: usize,
}

impl Key {
    fn of(shape: &MeshShape) -> Self {
        Self { path: shape.path.clone(), scale: shape.scale.to_bits(), up: shape.up.index() }
    }
}

impl Assets {
    /// The solid that a shape stands for, once it has been put in.
    pub fn solid(&self, shape: &MeshShape) -> Option<&Arc<Solid>> {
        self.solids.get(&Key::of(shape))
    }

    /// Puts in the solid that a shape stands for: upright and in metres.
    pub fn insert(&mut self, shape: &MeshShape, solid: Arc<Solid>) {
        self.solids.insert(Key::of(shape), solid);
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

impl MeshShape {
    /// The axis that points up, as importers have it.
    pub fn up_axis(&self) -> Up {
        match self.up {
            Axis::X => Up::X,
            Axis::Y => Up::Y,
            Axis::Z => Up::Z,
        }
    }
}

impl Scene {
    /// The mesh shapes of the scene, each with its JSON pointer.
    pub fn meshes(&self) -> impl Iterator<Item = (String, &MeshShape)> {
        self.bodies.iter().enumerate().filter_map(|(index, body)| match &body.shape {
            Shape::Mesh(shape) => Some((format!("/bodies/{index}/shape/mesh"), shape)),
            Shape::Box(_) => None,
        })
    }
}
