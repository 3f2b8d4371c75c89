//! What becomes of elements when their body is scaled.

use super::of_fibres::scale_drive;
use crate::scene::{Element, ElementLaw, ElementMeasure};

/// An element of the same material in a body that is larger by a factor.
pub(super) fn scale_element(element: &mut Element, factor: f64) {
    for point in &mut element.points {
        *point = point.map(|at| factor * at);
    }
    let force = match element.measure {
        ElementMeasure::Length => factor.powi(2),
        ElementMeasure::Area => factor,
        ElementMeasure::Volume => 1.0,
        ElementMeasure::Turn | ElementMeasure::Dihedral | ElementMeasure::Twist => factor.powi(3),
    };
    match &mut element.law {
        ElementLaw::Spring(of) | ElementLaw::TensionOnly(of) => of.stiffness *= force,
        ElementLaw::Muscle(of) => of.force *= force,
        ElementLaw::Table(points) => points.iter_mut().for_each(|point| point[1] *= force),
    }
    if let Some(of) = &mut element.activation {
        scale_drive(&mut of.drive, factor);
    }
}
