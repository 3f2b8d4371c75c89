//! New bodies of a size that suits the scene, soft enough to be seen to give and quick enough for real time.

use crate::edit::body_ops::scaled_two_layer;
use crate::scene::{
    BallShape, Body, BoxShape, CapsuleShape, CylinderShape, Material, OwnedBody, Shape, TorusShape, TwoLayer,
};

/// Particles of a new solid.
const PARTICLES: f64 = 500.0;
/// Layers of them at least across its thinnest part.
const LAYERS: f64 = 4.0;
/// Young's modulus for each metre of size [Pa/m]: under its own weight a body of any size gives by the same share of
/// it.
const STIFFNESS: f64 = 6e5;
const DENSITY: f64 = 1000.0;
/// Radial damping [1/s], with which what has landed comes to rest.
const DAMPING: f64 = 10.0;

/// What can be added as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NewBody {
    /// A fibre solid in the shape of a box.
    Box,
    /// In that of a ball.
    Ball,
    /// In that of a cylinder.
    Cylinder,
    /// In that of a cylinder with round ends.
    Capsule,
    /// In that of a ring.
    Torus,
    /// Two particles and a spring.
    Segment,
    /// A two-layer body in a plane, with gas in it.
    Ring,
    /// A two-layer body with gas in it.
    Balloon,
}

impl NewBody {
    /// Identifier and name, if they are free.
    fn called(self) -> (&'static str, &'static str) {
        match self {
            Self::Box => ("box", "Box"),
            Self::Ball => ("ball", "Ball"),
            Self::Cylinder => ("cylinder", "Cylinder"),
            Self::Capsule => ("capsule", "Capsule"),
            Self::Torus => ("torus", "Torus"),
            Self::Segment => ("segment", "Segment"),
            Self::Ring => ("ring", "Ring"),
            Self::Balloon => ("balloon", "Balloon"),
        }
    }

    /// A body whose greatest extent is `size` [m], about the origin.
    pub(crate) fn of_size(self, size: f64) -> OwnedBody {
        let (id, name) = self.called();
        let shape: Shape = match self {
            Self::Box => BoxShape::new([size; 3]).into(),
            Self::Ball => BallShape::new(0.5 * size).into(),
            Self::Cylinder => CylinderShape::new(0.3 * size, size).into(),
            Self::Capsule => CapsuleShape::new(0.25 * size, 0.5 * size).into(),
            Self::Torus => TorusShape::new(0.34 * size, 0.16 * size).into(),
            Self::Segment => return two_layer(TwoLayer::segment(id), name, size / 2.0),
            Self::Ring => return two_layer(TwoLayer::ring(id), name, size / 4.0),
            Self::Balloon => return two_layer(TwoLayer::ball(id), name, size / 4.0),
        };
        let material = material_for(&shape, size);
        Body::new(id, shape).with_name(name).with_material(material).into()
    }
}

/// A two-layer body with the paper's parameters, brought to another size.
fn two_layer(body: TwoLayer, name: &str, factor: f64) -> OwnedBody {
    scaled_two_layer(&body.with_name(name), factor).into()
}

fn material_for(shape: &Shape, size: f64) -> Material {
    let material = Material::new(STIFFNESS * size, 0.33, DENSITY).with_damping(DAMPING, 0.0);
    let spacing = spacing_for(shape, PARTICLES).unwrap_or_else(|| material.spacing());
    let radius = spacing / material.spacing_ratio;
    material.with_support_radius(radius)
}

/// Spacing [m] at which so many particles fill a shape, closer where its thinnest part needs that; none of a mesh.
pub(super) fn spacing_for(shape: &Shape, particles: f64) -> Option<f64> {
    Some((shape.volume()? / particles).cbrt().min(shape.thickness()? / LAYERS))
}
