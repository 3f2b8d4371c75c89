//! Faces of more than three corners.

use super::failure::Failure;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Corners that are looked at while the polygons of a file are cut, at most: those of an ordinary polygon are looked at
/// as often as it has corners, those of one that crosses itself as often again.
const MOST_LOOKS: u64 = 100_000_000;

/// Polygons of more corners than this are looked at as a whole first: of a convex one every corner is an ear.
const MANY: usize = 64;

/// Cuts the polygons of a file into triangles of their corners, by ears.
#[derive(Debug)]
pub(in crate::io) struct Cutter {
    /// Looks that are left.
    looks: u64,
}

impl Default for Cutter {
    fn default() -> Self {
        Self { looks: MOST_LOOKS }
    }
}

impl Cutter {
    /// Cuts a polygon, convex or not, but flat more or less. Corners are given by index, so are triangles. A polygon
    /// that crosses itself still comes out in one less triangle less than it has corners; so does one for which no
    /// looks are left, whatever its triangles cover: false is told then.
    pub(in crate::io) fn cut(&mut self, corners: &[u32], positions: &[DVec3], triangles: &mut Vec<[u32; 3]>) -> bool {
        match *corners {
            [a, b, c] => triangles.push([a, b, c]),
            [_, _, _, _, ..] => match flatten(corners, positions) {
                Some(flat) if corners.len() > MANY && is_convex(&flat) => triangles.extend(from_last(corners)),
                Some(flat) => cut_ears(corners, &flat, triangles, &mut self.looks),
                // Indices without a position are left for the model to sort out.
                None => triangles.extend(fan(corners)),
            },
            _ => {}
        }
        self.looks > 0
    }
}

/// Why a polygon of so many corners is not cut.
pub(super) fn too_long(corners: usize) -> Failure {
    Failure::with(
        format_args!(
            "cutting its faces into triangles takes more than {} million looks at corners, at one of {corners} corners",
            MOST_LOOKS / 1_000_000
        ),
        "cut its faces into triangles in the program that it is from",
    )
}

/// As ears are cut, from the first corner on, where every corner is one.
fn from_last(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    let last = corners[corners.len() - 1];
    corners[..corners.len() - 1].windows(2).map(move |pair| [last, pair[0], pair[1]])
}

/// Whether an outline turns left everywhere, and once around in all.
fn is_convex(flat: &[DVec2]) -> bool {
    let n = flat.len();
    let mut turned = 0.0;
    (0..n).all(|k| {
        let [a, b, c] = [flat[k], flat[(k + 1) % n], flat[(k + 2) % n]];
        let (turn, ahead) = ((b - a).perp_dot(c - b), (b - a).dot(c - b));
        turned += turn.atan2(ahead);
        turn > 0.0
    }) && turned < 1.5 * TAU
}

fn fan(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    corners[1..].windows(2).map(|pair| [corners[0], pair[0], pair[1]])
}

/// Corners in the plane that the polygon lies in most (Newell), counter-clockwise.
fn flatten(corners: &[u32], positions: &[DVec3]) -> Option<Vec<DVec2>> {
    let points: Vec<DVec3> = corners.iter().map(|&i| positions.get(i as usize).copied()).collect::<Option<_>>()?;
    let mut normal = DVec3::ZERO;
    for (k, p) in points.iter().enumerate() {
        normal += (*p - points[0]).cross(points[(k + 1) % points.len()] - points[0]);
    }
    let normal = normal.try_normalize()?;
    let (u, v) = normal.any_orthonormal_pair();
    Some(points.iter().map(|&p| DVec2::new((p - points[0]).dot(u), (p - points[0]).dot(v))).collect())
}

fn cut_ears(corners: &[u32], flat: &[DVec2], triangles: &mut Vec<[u32; 3]>, looks: &mut u64) {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut at = 0;
    let mut tried = 0;
    while left.len() > 3 {
        let n = left.len();
        if *looks == 0 {
            triangles.extend(fan(&left.iter().map(|&k| corners[k]).collect::<Vec<_>>()));
            return;
        }
        let [before, here, after] = [(at + n - 1) % n, at % n, (at + 1) % n].map(|k| left[k]);
        // With nothing but bad corners left any will do: the outline is kept, whatever lies inside.
        if tried > n || is_ear(flat, &left, [before, here, after], looks) {
            triangles.push([before, here, after].map(|k| corners[k]));
            left.remove(at % n);
            // Those behind it move up.
            *looks = looks.saturating_sub(1 + (n / 16) as u64);
            tried = 0;
        } else {
            tried += 1;
            at += 1;
        }
        at %= left.len();
    }
    triangles.push([left[0], left[1], left[2]].map(|k| corners[k]));
}

fn is_ear(flat: &[DVec2], left: &[usize], ear: [usize; 3], looks: &mut u64) -> bool {
    let [a, b, c] = ear.map(|k| flat[k]);
    let turn = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let inside = |p: DVec2| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    if turn(a, b, c) <= 0.0 || turn(a, b, c).is_nan() {
        *looks = looks.saturating_sub(1);
        return false;
    }
    let found = left.iter().position(|k| !ear.contains(k) && inside(flat[*k]));
    *looks = looks.saturating_sub(found.unwrap_or(left.len()) as u64 + 1);
    found.is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[[f64; 2]]) -> f64 {
        let positions: Vec<DVec3> = outline.iter().map(|p| DVec3::new(p[0], p[1], 0.5 * p[0])).collect();
        let corners: Vec<u32> = (0..outline.len() as u32).collect();
        let mut triangles = Vec::new();
        assert!(Cutter::default().cut(&corners, &positions, &mut triangles));
        assert_eq!(triangles.len(), outline.len() - 2);
        let twice = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| DVec2::from_array(outline[i as usize]));
            (b - a).perp_dot(c - a)
        };
        assert!(triangles.iter().all(|t| twice(t) >= 0.0), "{triangles:?}");
        triangles.iter().map(|t| 0.5 * twice(t)).sum()
    }

    #[test]
    fn hollow_corners_stay_hollow() {
        assert_eq!(area(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), 1.0);
        let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
        assert_eq!(area(&arrow), 1.5);
        let comb = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [3.0, 2.0], [3.0, 1.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(area(&comb), 7.0);
    }

    #[test]
    fn a_polygon_too_long_to_be_looked_at_is_told() {
        // Convex, or with every second corner nearer to the middle.
        let ring = |n: u32, dent: f64| -> Vec<DVec3> {
            let at = |k: u32| (1.0 - dent * f64::from(k % 2)) * DVec2::from_angle(TAU * f64::from(k) / f64::from(n));
            (0..n).map(|k| DVec3::from((at(k), 0.0))).collect()
        };
        let mut cutter = Cutter { looks: 20_000 };
        for (n, dent, whole) in [(50, 0.5, true), (5000, 0.0, true), (500, 0.5, false)] {
            let (corners, mut triangles) = ((0..n).collect::<Vec<u32>>(), Vec::new());
            assert_eq!(cutter.cut(&corners, &ring(n, dent), &mut triangles), whole, "{n}");
            assert_eq!(triangles.len() as u32, n - 2, "the outline is kept");
        }
    }

    #[test]
    fn a_convex_outline_is_cut_as_by_its_ears() {
        let at = |k: u32| DVec2::from_angle(TAU * f64::from(k) / 70.0);
        let positions: Vec<DVec3> = (0..70).map(|k| DVec3::from((at(k), 0.0))).collect();
        let flat: Vec<DVec2> = (0..70).map(at).collect();
        let corners: Vec<u32> = (0..70).collect();
        let (mut soon, mut by_ears) = (Vec::new(), Vec::new());
        Cutter::default().cut(&corners, &positions, &mut soon);
        cut_ears(&corners, &flat, &mut by_ears, &mut 1_000_000);
        // The last one may begin with another of its corners.
        let of_least = |face: &[u32; 3]| {
            let mut face = *face;
            let least = (0..3).min_by_key(|&k| face[k]).unwrap_or_default();
            face.rotate_left(least);
            face
        };
        let [soon, by_ears] = [soon, by_ears].map(|faces| faces.iter().map(of_least).collect::<Vec<_>>());
        assert_eq!(soon, by_ears);
        // One that goes twice around is not convex, though it turns left everywhere.
        assert!(is_convex(&flat) && !is_convex(&(0..70).map(|k| at(2 * k)).collect::<Vec<_>>()));
    }
}
