//! Change of topology: a fibre that breaks into two (sec. 7, figure 10).
//!
//! A fibre that turns too far breaks at that vertex. Both parts still meet there, but nothing resists their turn any
//! more: the bending energy jumps down by exactly what the vertex stored, and no other term changes. A fibre that is
//! pulled too hard loses the edge, and with it the bending of the vertices at both ends, whose turn is no longer
//! defined. Of several places past their limits in one step only the one furthest past it breaks; that relieves the
//! others.

pub use super::break_limits::BreakLimits;

use super::rest::FibreRest;

/// Where along its centre line a fibre is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BreakPlace {
    /// At this vertex: it no longer bends there.
    Vertex(u32),
    /// Between this vertex and the next.
    Edge(u32),
}

/// One break.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreBreak {
    /// Index of the fibre among the body's centre lines.
    pub fibre: u32,
    /// Where on it, counted from the first vertex of the centre line.
    pub place: BreakPlace,
    /// When [s]: the end of the step in which it passed its limit.
    pub time: f64,
}

/// What is broken in the fibres of one body.
#[derive(Clone, Debug, Default)]
pub(super) struct Breakage {
    /// Bends of all fibres, one after another, that carry nothing any more.
    pub(super) bends: Vec<bool>,
    /// Edges likewise.
    pub(super) edges: Vec<bool>,
    /// Every break in the order of time.
    pub(super) breaks: Vec<FibreBreak>,
}

impl Breakage {
    /// Nothing broken.
    pub(super) fn none(fibres: &[FibreRest]) -> Self {
        Self {
            bends: vec![false; fibres.iter().map(|fibre| fibre.bends.len()).sum()],
            edges: vec![false; fibres.iter().map(|fibre| fibre.edges.len()).sum()],
            breaks: Vec::new(),
        }
    }

    /// What is broken in the fibres `before` an edit, carried to those `after` it. A fibre along the same vertices is
    /// the same one, whatever else of it is new and wherever it stands among the others now; one that was moved is
    /// whole.
    pub(super) fn carried(&self, [before, after]: [&[FibreRest]; 2]) -> Self {
        let mut carried = Self::none(after);
        let mut taken = vec![false; before.len()];
        let (mut bend, mut edge) = (0, 0);
        for fibre in after {
            let (bends, edges) = (bend..bend + fibre.bends.len(), edge..edge + fibre.edges.len());
            let (mut old_bend, mut old_edge) = (0, 0);
            for (old, taken) in before.iter().zip(&mut taken) {
                // Two may lie on each other.
                if !*taken && old.vertices == fibre.vertices && old.first_vertex == fibre.first_vertex {
                    *taken = true;
                    carried.bends[bends.clone()].copy_from_slice(&self.bends[old_bend..][..bends.len()]);
                    carried.edges[edges.clone()].copy_from_slice(&self.edges[old_edge..][..edges.len()]);
                    let breaks = self.breaks.iter().filter(|one| one.fibre == old.line);
                    carried.breaks.extend(breaks.map(|one| FibreBreak { fibre: fibre.line, ..*one }));
                    break;
                }
                old_bend += old.bends.len();
                old_edge += old.edges.len();
            }
            (bend, edge) = (bends.end, edges.end);
        }
        carried.breaks.sort_by(|one, other| one.time.total_cmp(&other.time));
        carried
    }

    /// Memory of the lists [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.bends) + size_of_val(&*self.edges) + size_of_val(&*self.breaks)
    }

    /// Breaks the vertex of bend `k` of a fibre whose first bend is `first_bend` of all.
    pub(super) fn at_vertex(&mut self, fibre: &FibreRest, first_bend: usize, k: usize, time: f64) {
        self.bends[first_bend + k] = true;
        let place = BreakPlace::Vertex(fibre.first_vertex + k as u32 + 1);
        self.breaks.push(FibreBreak { fibre: fibre.line, place, time });
    }

    /// Breaks edge `k` of a fibre whose first bend and edge are these of all.
    pub(super) fn at_edge(&mut self, fibre: &FibreRest, [first_bend, first_edge]: [usize; 2], k: usize, time: f64) {
        self.edges[first_edge + k] = true;
        // The bends at both ends of edge k; a fibre's ends have none.
        for bend in k.saturating_sub(1)..fibre.bends.len().min(k + 1) {
            self.bends[first_bend + bend] = true;
        }
        let place = BreakPlace::Edge(fibre.first_vertex + k as u32);
        self.breaks.push(FibreBreak { fibre: fibre.line, place, time });
    }
}
