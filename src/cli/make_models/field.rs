//! Signed distances of the shapes that plants are made of [m].

use glam::{DVec2, DVec3};

/// Two shapes as one, with a fillet of about `k` [m] between them (a polynomial smooth minimum).
pub(super) fn smooth_union(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * k / 4.0
}

/// What both shapes have in common, with a rounding of about `k` [m] where they meet.
pub(super) fn smooth_intersection(a: f64, b: f64, k: f64) -> f64 {
    -smooth_union(-a, -b, k)
}

/// A stalk: a tube along a smooth curve, with a radius that changes from end to end.
#[derive(Clone, Debug)]
pub(super) struct Stalk<C, R> {
    curve: C,
    radius: R,
}

/// Places along a stalk that are looked at before the nearest is searched for in between.
const PLACES: usize = 8;

/// Steps of that search.
const STEPS: usize = 3;

impl<C: Fn(f64) -> DVec3, R: Fn(f64) -> f64> Stalk<C, R> {
    /// Along `curve`, with `radius` [m], both over [0, 1].
    pub(super) fn new(curve: C, radius: R) -> Self {
        Self { curve, radius }
    }

    /// Distance to its surface.
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let at = |t: f64| p.distance((self.curve)(t)) - (self.radius)(t);
        let mut step = 1.0 / PLACES as f64;
        let places = (0..=PLACES).map(|k| k as f64 * step).map(|t| (t, at(t)));
        let Some((mut t, mut least)) = places.reduce(|a, b| if b.1 < a.1 { b } else { a }) else { return 0.0 };
        for _ in 0..STEPS {
            // To the foot of the parabola through three places.
            let middle = t.clamp(step, 1.0 - step);
            let [before, here, after] = [middle - step, middle, middle + step].map(at);
            let bend = before + after - 2.0 * here;
            if bend > 0.0 {
                let to = (middle + 0.5 * step * (before - after) / bend).clamp(0.0, 1.0);
                let there = at(to);
                if there < least {
                    (t, least) = (to, there);
                }
            }
            step *= 0.3;
        }
        least
    }
}

/// A leaf's blade in its own frame: from its foot at the origin along x, its upper side along y, its width along z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blade {
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

/// Powers with which the outline leaves the foot and reaches the tip, and what brings its greatest width to one.
const FOOT: f64 = 0.62;
const TIP: f64 = 1.02;
const WIDEST: f64 = FOOT / (FOOT + TIP);

/// Roundness of the tip [m]: a sharp one would be finer than the mesh.
const TIP_ROUND: f64 = 6e-3;

/// Share of the length over which the outline turns at its foot.
const EASE: f64 = 0.025;

/// Half width of the midrib's groove [m], its depth, and the height of the side veins.
const GROOVE: f64 = 4.5e-3;
const GROOVE_DEPTH: f64 = 1.8e-3;
const VEIN: f64 = 6e-4;

/// Side veins over the length of a blade, and how steeply they run forward.
const VEINS: f64 = 7.0;
const SLANT: f64 = 1.6;

impl Blade {
    /// Half width at `s` in [0, 1]: a rounded foot, a pointed tip. Beyond its ends it goes on below zero.
    fn outline(&self, s: f64) -> f64 {
        if s >= 1.0 {
            return self.half_width * 3.0 * (1.0 - s);
        }
        // `s` that bends away before it reaches zero: the foot is round instead of blunt.
        let eased = 0.5 * (s + s.hypot(2.0 * EASE));
        let widest = WIDEST.powf(FOOT) * (1.0 - WIDEST).powf(TIP);
        self.half_width * (eased.powf(FOOT) * (1.0 - s).powf(TIP) / widest - 3.0 * (eased - s))
    }

    /// Height of the middle surface.
    fn height(&self, s: f64, z: f64) -> f64 {
        let bend = -self.droop * s * s.abs();
        let across = z.hypot(4e-3) - 4e-3;
        let edge = (z / self.half_width).powi(2).min(1.5);
        bend + self.fold * across + self.wave[0] * edge * (9.0 * s + self.wave[1]).sin()
    }

    /// Half thickness above or below the middle surface: a groove along the midrib and ridges of veins above, the
    /// midrib itself below.
    fn half_thickness(&self, s: f64, z: f64, above: bool) -> f64 {
        let [at_edge, at_rib] = self.half_thickness;
        let rib = at_rib * (-(z / (0.25 * self.half_width)).powi(2)).exp();
        let thinner = 1.0 - 0.08 * s.clamp(0.0, 1.0).powi(2);
        if !above {
            return (at_edge + 1.6 * rib) * thinner;
        }
        let fade = (s * 6.0).clamp(0.0, 1.0) * ((1.0 - s) * 4.0).clamp(0.0, 1.0);
        let groove = GROOVE_DEPTH * (-(z / GROOVE).powi(2)).exp();
        let phase = VEINS * (s - SLANT * z.abs() / self.length);
        let inner = (1.0 - (z / self.outline(s).max(1e-3)).powi(2)).max(0.0);
        let vein = inner * VEIN * (2.0 * (std::f64::consts::PI * phase).cos().powi(4) - 1.0);
        (at_edge + 0.6 * rib) * thinner + fade * (vein * (1.0 - (-(z / GROOVE).powi(2)).exp()) - groove)
    }

    /// Distance to its surface, nearly.
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let s = p.x / self.length;
        let across = p.z.hypot(TIP_ROUND) - TIP_ROUND;
        let step = 1e-4;
        let widening = (self.outline(s + step) - self.outline(s - step)) / (2.0 * step * self.length);
        let beside = (across - self.outline(s)) / 1.0_f64.hypot(widening);
        let height = p.y - self.height(s, p.z);
        let tilt = (self.height(s + step, p.z) - self.height(s - step, p.z)) / (2.0 * step * self.length);
        let above = height.abs() / (1.0 + tilt * tilt + self.fold * self.fold).sqrt();
        // A slab with round edges.
        let round = 0.9 * self.half_thickness[0];
        let q = DVec2::new(beside + round, above - self.half_thickness(s, p.z, height > 0.0) + round);
        q.max_element().min(0.0) + q.max(DVec2::ZERO).length() - round
    }
}

/// A place and direction for a blade.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalFrame {
    /// Where its foot is [m].
    pub origin: DVec3,
    /// Its axes in the world.
    pub axes: glam::DMat3,
}

impl LocalFrame {
    /// From a foot along `direction`, the upper side as far up as that allows, then rolled about it [rad].
    pub(super) fn new(origin: DVec3, direction: DVec3, roll: f64) -> Self {
        let x = direction.normalize_or(DVec3::X);
        let z = x.cross(DVec3::Y).normalize_or(DVec3::Z);
        let axes = glam::DMat3::from_cols(x, z.cross(x), z);
        Self { origin, axes: glam::DMat3::from_axis_angle(x, roll) * axes }
    }

    /// A point as the blade sees it.
    pub(super) fn local(&self, p: DVec3) -> DVec3 {
        self.axes.transpose() * (p - self.origin)
    }
}
