//! Edges of a surface: which are shared, which are open, and how the faces on both sides are turned.

use rayon::prelude::*;
use std::ops::Range;

/// One side of a face: an edge with a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct HalfEdge {
    /// The two points, the lesser index first.
    pub ends: [u32; 2],
    /// Its face.
    pub face: u32,
    /// Whether the face runs along it from the lesser index to the greater.
    pub forward: bool,
}

/// All half edges, those of one edge side by side.
#[derive(Clone, Debug)]
pub(crate) struct Edges {
    halves: Vec<HalfEdge>,
    runs: Vec<Range<u32>>,
}

impl Edges {
    /// Collects the edges of triangles.
    pub(crate) fn new(faces: &[[u32; 3]]) -> Self {
        let mut halves: Vec<HalfEdge> = faces
            .par_iter()
            .enumerate()
            .flat_map_iter(|(face, &[a, b, c])| {
                [[a, b], [b, c], [c, a]].map(|[from, to]| HalfEdge {
                    ends: [from.min(to), from.max(to)],
                    face: face as u32,
                    forward: from < to,
                })
            })
            .collect();
        halves.par_sort_unstable();
        let mut runs = Vec::with_capacity(halves.len() / 2);
        let mut first = 0;
        for k in 1..=halves.len() {
            if k == halves.len() || halves[k].ends != halves[first].ends {
                runs.push(first as u32..k as u32);
                first = k;
            }
        }
        Self { halves, runs }
    }

    /// The half edges of every edge.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[HalfEdge]> {
        self.runs.iter().map(|run| &self.halves[run.start as usize..run.end as usize])
    }

    /// Pairs of faces that share an edge with no third, and whether they run along it in opposite directions, as
    /// neighbours of an oriented surface do.
    pub(crate) fn neighbours(&self) -> impl Iterator<Item = ([u32; 2], bool)> {
        self.iter().filter_map(|edge| match edge {
            [a, b] => Some(([a.face, b.face], a.forward != b.forward)),
            _ => None,
        })
    }

    /// Edges of one face only.
    pub(crate) fn open(&self) -> impl Iterator<Item = [u32; 2]> {
        self.iter().filter_map(|edge| match edge {
            [alone] => Some(alone.ends),
            _ => None,
        })
    }

    /// Edges of more than two faces.
    pub(crate) fn crowded(&self) -> impl Iterator<Item = &[HalfEdge]> {
        self.iter().filter(|edge| edge.len() > 2)
    }

    /// Edges that are not run along as often one way as the other, where `flipped` tells which faces are turned round
    /// first. Without any the surface is closed: it turns around every point a whole number of times.
    pub(crate) fn unbalanced<'a>(&'a self, flipped: &'a [bool]) -> impl Iterator<Item = &'a [HalfEdge]> {
        self.iter().filter(|edge| balance(edge, flipped) != 0)
    }
}

/// How often more an edge is run along forwards than backwards, where `flipped` tells which faces are turned round
/// first.
pub(crate) fn balance(edge: &[HalfEdge], flipped: &[bool]) -> i64 {
    edge.iter().map(|half| if half.forward == flipped[half.face as usize] { -1 } else { 1 }).sum()
}

/// Loops and chains that edges form: the number of holes that open edges surround.
pub(crate) fn count_loops(edges: &[[u32; 2]]) -> usize {
    let mut points: Vec<u32> = edges.iter().flatten().copied().collect();
    points.sort_unstable();
    points.dedup();
    let index = |point: u32| points.binary_search(&point).unwrap_or(0);
    let mut groups = Groups::new(points.len());
    for [a, b] in edges {
        groups.join(index(*a), index(*b));
    }
    groups.labels().1
}

/// Disjoint sets.
#[derive(Clone, Debug)]
pub(crate) struct Groups(Vec<u32>);

impl Groups {
    /// Every item alone.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    fn root(&mut self, mut item: usize) -> usize {
        while self.0[item] as usize != item {
            // Halving the path keeps the next search short.
            self.0[item] = self.0[self.0[item] as usize];
            item = self.0[item] as usize;
        }
        item
    }

    /// Puts the sets of two items together.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let [a, b] = [self.root(a), self.root(b)];
        self.0[a.max(b)] = a.min(b) as u32;
    }

    /// The number of every item's set, sets numbered by their first items, and how many there are.
    pub(crate) fn labels(mut self) -> (Vec<u32>, usize) {
        let mut labels = vec![0; self.0.len()];
        let mut count = 0;
        for item in 0..self.0.len() {
            let root = self.root(item);
            if root == item {
                labels[item] = count;
                count += 1;
            } else {
                labels[item] = labels[root];
            }
        }
        (labels, count as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_is_closed_and_an_open_one_is_not() {
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        let edges = Edges::new(&faces);
        assert_eq!(edges.unbalanced(&[false; 4]).count(), 0);
        assert_eq!(edges.unbalanced(&[true, false, false, false]).count(), 3);
        assert!(edges.neighbours().all(|(_, opposite)| opposite));
        let edges = Edges::new(&faces[1..]);
        let open: Vec<_> = edges.open().collect();
        assert_eq!(open.len(), 3);
        assert_eq!(count_loops(&open), 1);
    }

    #[test]
    fn sets_are_numbered_by_their_first_items() {
        let mut groups = Groups::new(6);
        groups.join(5, 1);
        groups.join(3, 5);
        assert_eq!(groups.labels(), (vec![0, 1, 2, 1, 3, 1], 4));
    }
}
