//! Faces that close the holes of a surface.
//!
//! A hole is a ring of edges. A fan closes it, or a band that closes it together with another hole: an open tube with
//! walls has a ring outside and one inside at each end, and the narrow band between the two takes far less of the sky
//! than two discs, one on top of the other.

use super::edges::{Edges, balance};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Rings that are tried in pairs, the largest of all.
const PAIRED: usize = 48;

/// Share of the area of two fans that a band may have at most to take their place.
const NARROW: f64 = 0.7;

/// Faces that close every hole; the middles of the fans among them are added to the points.
pub(crate) fn caps(points: &mut Vec<DVec3>, faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let rings = rings(faces);
    let (bands, banded) = bands(points, &rings);
    let mut caps = bands;
    for (_, ring) in rings.iter().enumerate().filter(|(index, _)| !banded.contains(index)) {
        fan(points, ring, &mut caps);
    }
    caps
}

/// Rings of the edges that are missing, each run through as its cap is to run.
fn rings(faces: &[[u32; 3]]) -> Vec<Vec<u32>> {
    // The ends of the edges that are missing at each point: those that would run against the open ones.
    let mut missing: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let edges = Edges::new(faces);
    let as_they_are = vec![false; faces.len()];
    for edge in edges.unbalanced(&as_they_are) {
        let balance = balance(edge, &as_they_are);
        let [a, b] = edge[0].ends;
        let [from, to] = if balance > 0 { [b, a] } else { [a, b] };
        missing.entry(from).or_default().extend(std::iter::repeat_n(to, balance.unsigned_abs() as usize));
    }
    let starts: Vec<u32> = missing.keys().copied().collect();
    let mut rings = Vec::new();
    // The way so far, and where on it each point lies.
    let (mut way, mut place_of): (Vec<u32>, BTreeMap<u32, usize>) = (Vec::new(), BTreeMap::new());
    for start in starts {
        way.push(start);
        place_of.insert(start, 0);
        // As many edges leave a point as arrive at it, so that every way comes back to a point that it went through.
        while let Some(next) = way.last().and_then(|last| missing.get_mut(last)).and_then(Vec::pop) {
            if let Some(&place) = place_of.get(&next) {
                let ring: Vec<u32> = way.drain(place + 1..).collect();
                for point in &ring {
                    place_of.remove(point);
                }
                rings.push([&[next], ring.as_slice()].concat());
            } else {
                place_of.insert(next, way.len());
                way.push(next);
            }
        }
        way.clear();
        place_of.clear();
    }
    rings
}

/// Adds a fan that closes a ring of edges.
fn fan(points: &mut Vec<DVec3>, ring: &[u32], caps: &mut Vec<[u32; 3]>) {
    if ring.len() <= 3 {
        // Two edges that run along each other leave no hole.
        caps.extend(<[u32; 3]>::try_from(ring));
        return;
    }
    let middle = points.len() as u32;
    points.push(middle_of(points, ring));
    caps.extend((0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()], middle]));
}

/// Bands between rings where that is much less to close than both with fans, and the rings that they close.
fn bands(points: &[DVec3], rings: &[Vec<u32>]) -> (Vec<[u32; 3]>, BTreeSet<usize>) {
    let mut large: Vec<(usize, DVec3, f64)> = rings
        .iter()
        .enumerate()
        .filter(|(_, ring)| ring.len() > 3)
        .map(|(index, ring)| {
            let middle = middle_of(points, ring);
            let corners = (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]].map(|i| points[i as usize]));
            (index, middle, corners.map(|[a, b]| area([a, b, middle])).sum())
        })
        .collect();
    large.sort_by(|a, b| b.2.total_cmp(&a.2).then(a.0.cmp(&b.0)));
    large.truncate(PAIRED);
    let mut gains: Vec<(f64, [usize; 2], Vec<[u32; 3]>)> = Vec::new();
    for (k, &(one, its_middle, its_area)) in large.iter().enumerate() {
        for &(other, middle, fan) in &large[k + 1..] {
            // Rings further apart than they are wide have a band that is larger than they are.
            let fans = its_area + fan;
            if its_middle.distance_squared(middle) < fans {
                let band = band(points, &rings[one], &rings[other]);
                let of_band: f64 = band.iter().map(|face| area(face.map(|i| points[i as usize]))).sum();
                if of_band < NARROW * fans {
                    gains.push((fans - of_band, [one, other], band));
                }
            }
        }
    }
    gains.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let (mut faces, mut banded) = (Vec::new(), BTreeSet::new());
    for (_, pair, band) in gains {
        if pair.iter().all(|ring| !banded.contains(ring)) {
            banded.extend(pair);
            faces.extend(band);
        }
    }
    (faces, banded)
}

/// Faces between two rings, which run opposite ways around it: from a pair of near points on, one edge after the other,
/// the one whose far end lies nearer first.
fn band(points: &[DVec3], a: &[u32], b: &[u32]) -> Vec<[u32; 3]> {
    let at = |i: u32| points[i as usize];
    let distance = |i: u32, j: u32| at(i).distance_squared(at(j));
    let nearest = (0..b.len()).min_by(|&i, &j| distance(a[0], b[i]).total_cmp(&distance(a[0], b[j]))).unwrap_or(0);
    // The second one backwards.
    let (on_a, on_b) = (|k: usize| a[k % a.len()], |k: usize| b[(nearest + b.len() - k % b.len()) % b.len()]);
    let (mut k, mut l) = (0, 0);
    let mut faces = Vec::with_capacity(a.len() + b.len());
    while k < a.len() || l < b.len() {
        let along_a = distance(on_a(k + 1), on_b(l)) <= distance(on_a(k), on_b(l + 1));
        if l == b.len() || (k < a.len() && along_a) {
            faces.push([on_a(k), on_a(k + 1), on_b(l)]);
            k += 1;
        } else {
            faces.push([on_b(l + 1), on_b(l), on_a(k)]);
            l += 1;
        }
    }
    // A corner that the rings share closes nothing with itself.
    faces.retain(|[a, b, c]| a != b && b != c && c != a);
    faces
}

fn middle_of(points: &[DVec3], ring: &[u32]) -> DVec3 {
    ring.iter().map(|&i| points[i as usize]).sum::<DVec3>() / ring.len() as f64
}

fn area([a, b, c]: [DVec3; 3]) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::model::Model;
    use crate::geometry::octahedron::sphere;
    use crate::geometry::weld::Welded;
    use glam::DVec2;

    fn unbalanced(faces: &[[u32; 3]], caps: &[[u32; 3]]) -> usize {
        let all = [faces, caps].concat();
        Edges::new(&all).unbalanced(&vec![false; all.len()]).count()
    }

    #[test]
    fn caps_close_every_hole() {
        let mesh = sphere(3);
        // Two holes that touch in a point, and one apart.
        let far = |t: &&[u32; 3]| {
            let middle = t.iter().map(|&i| mesh.positions[i as usize]).sum::<DVec3>() / 3.0;
            middle.distance(DVec3::Y) > 0.4 && !t.contains(&1)
        };
        let triangles = mesh.triangles.iter().filter(far).copied().collect();
        let Welded { mut points, faces, .. } =
            Welded::new(&Model { positions: mesh.positions.clone(), triangles, ..Model::default() });
        let caps = caps(&mut points, &faces);
        assert!(caps.len() > 8);
        assert_eq!(unbalanced(&faces, &caps), 0);
    }

    #[test]
    fn the_wall_of_a_tube_is_closed_by_bands_between_its_rings() {
        // Outer and inner wall, with as many sides each as are asked for, and open at both ends.
        for sides in [[32, 32], [32, 20], [7, 50]] {
            let (mut points, mut faces) = (Vec::new(), Vec::new());
            for (&n, radius) in sides.iter().zip([1.0, 0.9]) {
                let first = points.len() as u32;
                let at = |k: u32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k / 2) / f64::from(n));
                points.extend((0..2 * n).map(|k| (radius * at(k)).extend(f64::from(k % 2))));
                for k in 0..n {
                    let [a, b, c, d] =
                        [2 * k, (2 * k + 2) % (2 * n), (2 * k + 3) % (2 * n), 2 * k + 1].map(|i| first + i);
                    let quad = if first == 0 { [[a, b, c], [a, c, d]] } else { [[c, b, a], [d, c, a]] };
                    faces.extend(quad);
                }
            }
            let before = points.len();
            let caps = caps(&mut points, &faces);
            assert_eq!((points.len(), caps.len() as u32), (before, 2 * (sides[0] + sides[1])), "{sides:?}");
            assert_eq!(unbalanced(&faces, &caps), 0, "{sides:?}");
            let all: f64 = caps.iter().map(|face| area(face.map(|i| points[i as usize]))).sum();
            assert!(all < 0.5 * 2.0 * std::f64::consts::PI, "{sides:?}: {all}");
        }
    }
}
