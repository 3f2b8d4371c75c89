//! A plant and a leaf, as fields of signed distance that are meshed.

use super::field::{Blade, LocalFrame, Stalk, smooth_intersection, smooth_union};
use crate::geometry::isosurface::isosurface;
use crate::geometry::model::Model;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// A leaf that lies on its side along x: its stalk begins at the origin, where a person holds it.
pub(super) fn leaf(build: &LeafBuild) -> Model {
    let blade = Blade {
        length: 0.235,
        half_width: build.half_width,
        half_thickness: build.half_thickness,
        droop: 0.045,
        fold: 0.2,
        wave: [4e-3, 0.6],
    };
    let foot = DVec3::new(0.074, 0.021, 0.0);
    let frame = LocalFrame::new(foot, DVec3::new(1.0, 0.24, 0.0), 0.0);
    let stalk = Stalk::new(
        |t| DVec3::new(0.092 * t, 0.025 * t * (1.45 - 0.45 * t), 2e-3 * (PI * t).sin()),
        |t| build.stalk[0] - build.stalk[1] * t,
    );
    let field = |p: DVec3| smooth_union(blade.distance(frame.local(p)), stalk.distance(p), build.fillet);
    isosurface(&field, DVec3::new(-0.03, -0.05, -0.09), DVec3::new(0.34, 0.09, 0.09), build.cell)
}

/// What leaves differ in [m].
#[derive(Clone, Copy, Debug)]
pub(super) struct LeafBuild {
    /// Greatest half width of the blade.
    half_width: f64,
    /// Half thickness of the blade at its edge and, more, along its midrib.
    half_thickness: [f64; 2],
    /// Radius of the stalk at its beginning, and what it loses up to the blade.
    stalk: [f64; 2],
    /// Fillet between stalk and blade.
    fillet: f64,
    /// Size of the cells on which the field is meshed.
    cell: f64,
}

/// The paper's leaf: its cells give the vertices of Table 1.
pub(super) const LEAF: LeafBuild = LeafBuild {
    half_width: 0.053,
    half_thickness: [5.6e-3, 1.6e-3],
    stalk: [8.2e-3, 1.4e-3],
    fillet: 0.014,
    cell: 4.08e-3,
};

/// A leaf thick enough for particles of twice the spacing, so that it moves in real time.
pub(super) const THICK_LEAF: LeafBuild =
    LeafBuild { half_width: 0.058, half_thickness: [10e-3, 2.5e-3], stalk: [14e-3, 2e-3], fillet: 0.02, cell: 5e-3 };

/// A turn of the stem from leaf to leaf: the golden angle, as plants have it.
const GOLDEN: f64 = TAU * 0.381_966;

/// A plant that stands on the origin: a bent stem that grows thinner, and leaves around it. `seed` varies the leaves.
pub(super) fn plant(build: &PlantBuild, seed: u64) -> Model {
    let mut random = Mmix(seed);
    let height = 0.33;
    let stem_at = |t: f64| {
        let sway = 0.028 * (1.15 * PI * t).sin();
        DVec3::new(sway, height * t, 0.6 * sway * (1.0 - t) - 0.012 * t * t)
    };
    let [radius, loss] = build.stem;
    let stem = Stalk::new(stem_at, |t| radius - loss * t + 0.006 * (-t * 14.0).exp());
    let mut leaves = Vec::new();
    for k in 0..build.leaves {
        let share = k as f64 / (build.leaves - 1) as f64;
        let from = stem_at(0.32 + 0.68 * share);
        let angle = 0.4 + GOLDEN * k as f64 + random.around(0.12);
        let size = 1.0 - 0.3 * share + random.around(0.04);
        let out = DVec3::new(angle.cos(), 0.0, angle.sin());
        let rise = 0.55 + 0.8 * share + random.around(0.08);
        let foot = from + 0.058 * size * (out + DVec3::Y * 0.8).normalize_or(DVec3::Y);
        let petiole = Stalk::new(
            move |t| from.lerp(foot + 0.02 * size * (out + DVec3::Y * rise), t) - DVec3::Y * 4e-3 * (PI * t).sin(),
            |_| build.petiole,
        );
        let blade = Blade {
            length: 0.165 * size,
            half_width: 0.038 * size,
            half_thickness: build.half_thickness,
            droop: 0.075 * size + random.around(0.01),
            fold: 0.2,
            wave: [3e-3, random.around(3.0)],
        };
        leaves.push((petiole, blade, LocalFrame::new(foot, out + DVec3::Y * rise, random.around(0.2))));
    }
    let field = |p: DVec3| {
        let foot = smooth_intersection(stem.distance(p), -p.y, 0.008);
        leaves.iter().fold(foot, |nearest, (petiole, blade, frame)| {
            // A leaf too far away to change anything is not looked at.
            let ball = frame.origin + frame.axes * DVec3::new(0.4 * blade.length, 0.0, 0.0);
            if p.distance(ball) - blade.length > nearest + build.fillet {
                return nearest;
            }
            let leaf = smooth_union(petiole.distance(p), blade.distance(frame.local(p)), 0.01);
            smooth_union(nearest, leaf, build.fillet)
        })
    };
    isosurface(&field, DVec3::new(-0.3, -0.04, -0.3), DVec3::new(0.3, 0.5, 0.3), build.cell)
}

/// What plants differ in [m].
#[derive(Clone, Copy, Debug)]
pub(super) struct PlantBuild {
    /// Number of leaves, two or more.
    leaves: usize,
    /// Radius of the stem at its foot, and what it loses up to its top.
    stem: [f64; 2],
    /// Radius of the petioles.
    petiole: f64,
    /// Half thickness of the blades at their edge and, more, along their midrib.
    half_thickness: [f64; 2],
    /// Fillet between stem and leaves.
    fillet: f64,
    /// Size of the cells on which the field is meshed.
    cell: f64,
}

/// The paper's plant: its cells give the vertices of Table 1.
pub(super) const PLANT: PlantBuild = PlantBuild {
    leaves: 5,
    stem: [0.0148, 0.0058],
    petiole: 7.2e-3,
    half_thickness: [6e-3, 1.2e-3],
    fillet: 0.012,
    cell: 2.55e-3,
};

/// A plant with fewer and thicker leaves, for particles of twice the spacing, so that it moves in real time.
pub(super) const THICK_PLANT: PlantBuild = PlantBuild {
    leaves: 3,
    stem: [0.021, 0.006],
    petiole: 12e-3,
    half_thickness: [10e-3, 2e-3],
    fillet: 0.018,
    cell: 5e-3,
};

/// A small generator of numbers (Knuth's MMIX): the same in every run.
struct Mmix(u64);

impl Mmix {
    /// A number from `-reach` to `reach`.
    fn around(&mut self, reach: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        reach * ((self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    }
}
