//! Fibres to edit.

use glam::DVec3;
use sinew::edit::fibre_ops::{Sampling, vertices};
use sinew::scene::{Extra, Fibre, FibreSource, RestShape, Rigidity, StrokePair, ViewStroke};
use sinew::sketch::View;

/// A model of a hand's size.
pub const SAMPLING: Sampling = Sampling { model_diagonal: 0.1, spacing: 0.006 };

pub fn fibre(source: FibreSource) -> Fibre {
    Fibre {
        source,
        extra: Extra::from([("kept".to_owned(), 7.into())]),
        ..Fibre::through("fibre-1", [[0.0; 3]; 0])
            .with_name("Fibre 1")
            .with_stiffness(Rigidity::new(3000.0, 0.05))
            .with_volume_fraction(0.5)
            .with_rest_shape(RestShape::Straight)
    }
}

/// A climbing curve that bends in both views.
pub fn curve(t: f64) -> DVec3 {
    DVec3::new(0.012 * (3.0 * t).sin(), 0.01 + 0.07 * t, 0.01 * (2.0 * t).cos())
}

/// The curve, drawn in two views.
pub fn drawn(first: View, second: View) -> Fibre {
    let stroke = |view: View| ViewStroke::new(view, (0..=60).map(|k| view.project(curve(f64::from(k) / 60.0))));
    fibre(FibreSource::Strokes(StrokePair::new(stroke(first), stroke(second))))
}

/// The curve by vertices, unevenly spaced.
pub fn given() -> Fibre {
    let vertices = (0..9).map(|k| curve((f64::from(k) / 8.0).powi(2)).to_array()).collect();
    fibre(FibreSource::Vertices(vertices))
}

pub fn at(fibre: &Fibre) -> Vec<DVec3> {
    vertices(fibre, SAMPLING).expect("a fibre with a curve")
}

pub fn strokes(fibre: &Fibre) -> &StrokePair {
    match &fibre.source {
        FibreSource::Strokes(pair) => pair,
        FibreSource::Vertices(_) => panic!("the strokes are gone"),
    }
}

pub fn is_drawn(fibre: &Fibre) -> bool {
    matches!(fibre.source, FibreSource::Strokes(_))
}

/// Largest distance between points of the same number.
pub fn apart(a: &[DVec3], b: &[DVec3]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}
