//! Two-layer bodies of another size.

use crate::scene::{InnerOffset, TwoLayer, TwoLayerShape};

/// A two-layer body larger by a factor that behaves alike. Its springs are as stiff, so that under gravity it sags by
/// the same share of its size with masses that follow the factor, and bulges by it with the gas following its square;
/// swings take the square root of it longer, and damping follows that.
#[must_use]
pub fn scaled_two_layer(body: &TwoLayer, factor: f64) -> TwoLayer {
    let mut body = body.clone();
    match &mut body.shape {
        TwoLayerShape::Segment(shape) => shape.length *= factor,
        TwoLayerShape::Ring(shape) => {
            (shape.outer_radius, shape.inner_radius) = (factor * shape.outer_radius, factor * shape.inner_radius);
        }
        TwoLayerShape::Ball(shape) => {
            (shape.outer_radius, shape.inner_radius) = (factor * shape.outer_radius, factor * shape.inner_radius);
        }
        TwoLayerShape::Mesh(shape) => {
            shape.scale *= factor;
            if let InnerOffset::Metres(offset) = &mut shape.inner_offset {
                *offset *= factor;
            }
        }
    }
    body.mass *= factor;
    body.inner_mass = body.inner_mass.map(|mass| factor * mass);
    body.masses.iter_mut().for_each(|of| of.mass *= factor);
    body.pressure *= factor.powi(2);
    let slower = factor.sqrt();
    for damping in [&mut body.kd, &mut body.rkd, &mut body.mkd, &mut body.contact.cc, &mut body.contact.ct] {
        *damping *= slower;
    }
    body.air_drag /= slower;
    for impulse in body.impulses.iter_mut().flat_map(|of| &mut of.impulse) {
        *impulse *= factor * slower;
    }
    body
}
