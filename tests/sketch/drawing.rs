//! Ten known curves in the unit box, and a hand that draws them: unevenly and with noise, the same every time.

use glam::{DVec2, DVec3};
use sinew::sketch::{LiftOptions, Lifted, Stroke, View, lift};
use sinew::test_support::geometry::distance_to_polyline;
use std::f64::consts::{PI, TAU};

/// Diagonal of the unit box.
pub(crate) const BOX_DIAGONAL: f64 = 1.732_050_807_568_877_2;

/// Options for a model that fills the unit box.
pub(crate) const PLAIN: LiftOptions = LiftOptions { flip_second: false, stretch: false, model_diagonal: BOX_DIAGONAL };

/// A curve over the parameter range 0 to 1.
pub(crate) type Curve = fn(f64) -> DVec3;

/// Ten known curves within the unit box, with a name for messages.
pub(crate) const CURVES: [(&str, Curve); 10] = [
    ("diagonal", |t| DVec3::new(0.1 + 0.8 * t, 0.1 + 0.7 * t, 0.2 + 0.6 * t)),
    ("helix", |t| helix(t, 1.0)),
    ("two-turn helix", |t| helix(t, 2.0)),
    ("S-curve", |t| DVec3::new(0.5 + 0.35 * (TAU * t).sin(), 0.1 + 0.8 * t, 0.2 + 0.6 * t * t)),
    ("arch", |t| DVec3::new(0.1 + 0.8 * t, 0.1 + 0.8 * (PI * t).sin(), 0.2 + 0.6 * t)),
    ("two humps", |t| DVec3::new(0.1 + 0.8 * t, 0.5 - 0.35 * (2.0 * TAU * t).cos(), 0.2 + 0.5 * t + 0.2 * t * t)),
    ("leaning S", |t| DVec3::new(0.1 + 0.8 * t, 0.5 + 0.4 * (1.5 * TAU * t).sin(), 0.5 + 0.3 * (PI * t).cos())),
    ("hook", |t| DVec3::new(0.5 - 0.3 * (1.4 * PI * t).cos(), 0.4 + 0.4 * (1.4 * PI * t).sin(), 0.2 + 0.5 * t)),
    ("cone spiral", |t| {
        let radius = 0.1 + 0.35 * t;
        DVec3::new(0.5 + radius * (1.5 * TAU * t).cos(), 0.1 + 0.8 * t, 0.5 + radius * (1.5 * TAU * t).sin())
    }),
    ("fast then slow", |t| DVec3::new(0.1 + 0.8 * t * t * t, 0.1 + 0.8 * t, 0.9 - 0.8 * t.sqrt())),
];

fn helix(t: f64, turns: f64) -> DVec3 {
    let angle = TAU * turns * t;
    DVec3::new(0.5 + 0.4 * angle.cos(), 0.1 + 0.8 * t, 0.5 + 0.4 * angle.sin())
}

/// The curve of that name.
pub(crate) fn curve(name: &str) -> Curve {
    CURVES.iter().find(|(known, _)| *known == name).expect("a known curve").1
}

/// 600 points on a curve: near enough to measure against.
pub(crate) fn exact(curve: Curve) -> Vec<DVec3> {
    (0..=600).map(|i| curve(f64::from(i) / 600.0)).collect()
}

/// Knuth's linear congruential generator (MMIX): noise that is the same on every machine.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    /// Uniform in 0..1.
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Near enough to normally distributed, with mean 0 and standard deviation 1.
    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

/// Draws a curve as it is seen in a view: 100 to 180 samples, at a pace that varies by half, each off by a normally
/// distributed `sigma` [m].
pub(crate) fn draw(curve: Curve, view: View, sigma: f64, seed: u64) -> Stroke {
    let mut noise = Noise(seed);
    noise.uniform();
    let samples = 100 + (80.0 * noise.uniform()) as usize;
    let (phase, waves) = (noise.uniform(), 1.0 + (2.0 * noise.uniform()).floor());
    let pace = |t: f64| t + 0.5 / (TAU * waves) * ((TAU * (waves * t + phase)).sin() - (TAU * phase).sin());
    let points = (0..samples).map(|i| {
        let point = view.project(curve(pace(i as f64 / (samples - 1) as f64)));
        point + sigma * DVec2::new(noise.normal(), noise.normal())
    });
    Stroke { view, points: points.collect() }
}

/// Lifts the two given drawings and insists that it works.
pub(crate) fn lifted(first: &Stroke, second: &Stroke) -> Lifted {
    lift(first, second, &PLAIN).unwrap_or_else(|error| panic!("{error}"))
}

/// Largest distance of either polyline from the other: the Hausdorff distance, sampled at the vertices.
pub(crate) fn apart(a: &[DVec3], b: &[DVec3]) -> f64 {
    let one_way = |from: &[DVec3], to: &[DVec3]| from.iter().map(|&p| distance_to_polyline(p, to)).fold(0.0, f64::max);
    one_way(a, b).max(one_way(b, a))
}
