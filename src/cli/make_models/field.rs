//! Signed distances of the shapes that plants are made of [m].

use glam::{DVec2, DVec3};

/// Two shapes as one, with a fillet of about `k` [m] between them (a polynomial smooth minimum).
pub fn smooth_union(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * k / 4.0
}

/// A stalk: a tube along a smooth curve, with a radius that changes from end to end.
#[derive(Clone, Debug)]
pub struct Stalk {
    nodes: Vec<(DVec3, f64)>,
}

/// Straight pieces that a curved stalk is made of.
const PIECES: usize = 16;

impl Stalk {
    /// Along `curve`, with `radius`, both over [0, 1].
    pub fn new(curve: impl Fn(f64) -> DVec3, radius: impl Fn(f64) -> f64) -> Self {
        let nodes = (0..=PIECES).map(|k| k as f64 / PIECES as f64).map(|t| (curve(t), radius(t)));
        Self { nodes: nodes.collect() }
    }

    /// Distance to its surface.
    pub fn distance(&self, p: DVec3) -> f64 {
        let pieces = self.nodes.windows(2).map(|pair| {
            let [(a, ra), (b, rb)] = [pair[0], pair[1]];
            let along = b - a;
            let t = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            p.distance(a + t * along) - (ra + t * (rb - ra))
        });
        // Neighbouring pieces meet at an angle: a little fillet hides it.
        pieces.reduce(|a, b| smooth_union(a, b, 1e-3)).unwrap_or(f64::INFINITY)
    }
}

/// A leaf's blade in its own frame: from its foot at the origin along x, its upper side along y, its width along z.
#[derive(Clone, Copy, Debug)]
pub struct Blade {
    /// From foot to tip [m].
    pub length: f64,
    /// Greatest half width [m].
    pub half_width: f64,
    /// Half thickness at the edge and, more, along the midrib [m].
    pub half_thickness: [f64; 2],
    /// Height that the blade has lost at its tip [m]; negative for one that rises.
    pub droop: f64,
    /// Slope by which both halves rise from the midrib.
    pub fold: f64,
    /// Height of the waves along the edge [m], and their phase.
    pub wave: [f64; 2],
}

/// Where along a blade it is widest.
const WIDEST: f64 = 0.38;

impl Blade {
    /// Half width at `s` in [0, 1]: a rounded foot, a pointed tip. Beyond its ends it goes on below zero.
    fn outline(&self, s: f64) -> f64 {
        // A cubic easing to the widest place from either side, and a straight line out of each end.
        let bulge = |t: f64| 1.0 - (1.0 - t).powi(2);
        if s <= 0.0 {
            return self.half_width * 2.0 * s / WIDEST;
        }
        if s < WIDEST {
            return self.half_width * bulge(s / WIDEST).powf(0.8);
        }
        let t = (1.0 - s) / (1.0 - WIDEST);
        // Drawn out to a point: the outline leaves the tip with a slope of its own.
        self.half_width * if t < 0.0 { 1.2 * t } else { (1.2 * t + 1.2 * t * t - 1.4 * t * t * t).max(0.0) }
    }

    /// Height of the middle surface.
    fn height(&self, s: f64, z: f64) -> f64 {
        let bend = -self.droop * s * s.abs();
        let across = (z * z + 1e-5).sqrt() - 1e-5_f64.sqrt();
        let edge = (z / self.half_width).powi(2).min(1.5);
        bend + self.fold * across + self.wave[0] * edge * (9.0 * s + self.wave[1]).sin()
    }

    /// Distance to its surface, nearly.
    pub fn distance(&self, p: DVec3) -> f64 {
        let s = p.x / self.length;
        let across = (p.z * p.z + 4e-6).sqrt() - 2e-3;
        let step = 1e-4;
        let widening = (self.outline(s + step) - self.outline(s - step)) / (2.0 * step * self.length);
        let beside = (across - self.outline(s)) / (1.0 + widening * widening).sqrt();
        let [at_edge, at_rib] = self.half_thickness;
        let rib = at_rib * (-(p.z / (0.25 * self.half_width)).powi(2)).exp();
        let swell = (at_edge + rib) * (1.0 - 0.25 * s.clamp(0.0, 1.0).powi(2));
        let tilt = (self.height(s + step, p.z) - self.height(s - step, p.z)) / (2.0 * step * self.length);
        let above = (p.y - self.height(s, p.z)).abs() / (1.0 + tilt * tilt + self.fold * self.fold).sqrt();
        // A slab with round edges of the radius of its half thickness at the edge.
        let round = 0.9 * at_edge;
        let q = DVec2::new(beside + round, above - swell + round);
        q.max_element().min(0.0) + q.max(DVec2::ZERO).length() - round
    }
}

/// A place and direction for a blade.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Where its foot is [m].
    pub origin: DVec3,
    /// Its axes in the world.
    pub axes: glam::DMat3,
}

impl Frame {
    /// From a foot along `direction`, the upper side as far up as that allows, then rolled about it [rad].
    pub fn new(origin: DVec3, direction: DVec3, roll: f64) -> Self {
        let x = direction.normalize_or(DVec3::X);
        let z = x.cross(DVec3::Y).normalize_or(DVec3::Z);
        let axes = glam::DMat3::from_cols(x, z.cross(x), z);
        Self { origin, axes: glam::DMat3::from_axis_angle(x, roll) * axes }
    }

    /// A point as the blade sees it.
    pub fn local(&self, p: DVec3) -> DVec3 {
        self.axes.transpose() * (p - self.origin)
    }
}
