//! A tree of boxes around triangles: what is near a point, a line or another triangle is found without looking at all.

use glam::DVec3;
use std::ops::Range;

/// Triangles by their corners, sorted into a binary tree of boxes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    order: Vec<u32>,
}

/// A box with what is in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// Least corner [m].
    pub min: DVec3,
    /// Greatest corner [m].
    pub max: DVec3,
    /// First of its triangles in the tree's order.
    first: u32,
    /// Number of its triangles.
    count: u32,
    /// Index of the second child; the first follows its parent. Zero for a leaf.
    second: u32,
    /// Index of the first node behind it that is not below it: where a walk goes on that does not enter it.
    next: u32,
}

/// Triangles of a leaf.
const LEAF: usize = 4;

impl Node {
    /// Whether it has no children.
    pub(crate) fn is_leaf(&self) -> bool {
        self.second == 0
    }

    /// Index of the first node behind it that is not below it: a walk through the nodes in order goes on there where it
    /// does not enter this one.
    pub(crate) fn next(&self) -> usize {
        self.next as usize
    }

    /// Its triangles in the tree's order.
    pub(crate) fn range(&self) -> Range<u32> {
        self.first..self.first + self.count
    }

    /// Whether two boxes have anything in common.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
}

impl Bvh {
    /// Sorts triangles. The tree depends on their order and positions only.
    pub(crate) fn new(points: &[DVec3], faces: &[[u32; 3]]) -> Self {
        let corners = |&face: &u32| faces[face as usize].map(|i| points[i as usize]);
        let centers: Vec<DVec3> =
            faces.iter().map(|t| t.iter().map(|&i| points[i as usize]).sum::<DVec3>() / 3.0).collect();
        let mut this = Self { nodes: Vec::with_capacity(faces.len()), order: (0..faces.len() as u32).collect() };
        if !faces.is_empty() {
            this.split(0..faces.len(), &centers, &corners);
        }
        this
    }

    fn split(&mut self, range: Range<usize>, centers: &[DVec3], corners: &impl Fn(&u32) -> [DVec3; 3]) -> usize {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut least, mut greatest) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for face in &self.order[range.clone()] {
            for corner in corners(face) {
                min = min.min(corner);
                max = max.max(corner);
            }
            least = least.min(centers[*face as usize]);
            greatest = greatest.max(centers[*face as usize]);
        }
        let index = self.nodes.len();
        self.nodes.push(Node { min, max, first: range.start as u32, count: range.len() as u32, second: 0, next: 0 });
        if range.len() > LEAF {
            let spread = greatest - least;
            let axis = spread.max_position();
            let middle = range.len() / 2;
            self.order[range.clone()].select_nth_unstable_by(middle, |&a, &b| {
                centers[a as usize][axis].total_cmp(&centers[b as usize][axis]).then(a.cmp(&b))
            });
            self.split(range.start..range.start + middle, centers, corners);
            let second = self.split(range.start + middle..range.end, centers, corners);
            self.nodes[index].second = second as u32;
        }
        self.nodes[index].next = self.nodes.len() as u32;
        index
    }

    /// All boxes, parents before their children.
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The two children of a node that is no leaf.
    pub(crate) fn children(&self, index: usize) -> [usize; 2] {
        [index + 1, self.nodes[index].second as usize]
    }

    /// Triangles in a node.
    pub(crate) fn triangles(&self, index: usize) -> &[u32] {
        let Range { start, end } = self.nodes[index].range();
        &self.order[start as usize..end as usize]
    }

    /// Calls `found` for every triangle in a leaf whose box, and all boxes above it, `enter` accepts.
    pub(crate) fn visit(&self, enter: impl Fn(&Node) -> bool, mut found: impl FnMut(u32)) {
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            if !enter(node) {
                index = node.next();
                continue;
            }
            if node.is_leaf() {
                self.triangles(index).iter().for_each(|&face| found(face));
            }
            index += 1;
        }
    }

    /// Pairs of leaves that meet, each once, a leaf with itself included: `meet` tells of two nodes whether any
    /// triangles below them may.
    pub(crate) fn meeting_leaves(&self, meet: impl Fn(usize, usize) -> bool) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        let mut open = vec![[0, 0]];
        if self.nodes.is_empty() {
            open.clear();
        }
        while let Some([a, b]) = open.pop() {
            let [m, n] = [a, b].map(|index: usize| &self.nodes[index]);
            if a != b && !meet(a, b) {
                continue;
            }
            match (m.is_leaf(), n.is_leaf()) {
                (true, true) => pairs.push([a as u32, b as u32]),
                (false, false) if a == b => {
                    let [c, d] = self.children(a);
                    open.extend([[c, c], [c, d], [d, d]]);
                }
                (false, is_leaf) if is_leaf || m.count >= n.count => {
                    open.extend(self.children(a).map(|child| [child, b]));
                }
                _ => open.extend(self.children(b).map(|child| [a, child])),
            }
        }
        pairs
    }
}
