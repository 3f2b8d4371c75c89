//! Pieces of a surface whose boxes touch: what lies in several of them can only be found within such a group.

use super::edges::Groups;
use super::orient::Piece;
use glam::DVec3;

/// Pieces whose boxes touch, directly or by way of others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cluster {
    /// Numbers of its pieces, in order.
    pub pieces: Vec<usize>,
    /// Least corner [m].
    pub min: DVec3,
    /// Greatest corner [m].
    pub max: DVec3,
}

/// Share of its diagonal by which the box of a piece with holes is widened: patches that leave gaps between them may
/// enclose something together.
const GAPS: f64 = 0.25;

/// Groups those of the pieces that `keep` accepts, by the first piece of each group. The boxes of two groups touch
/// nowhere.
pub(crate) fn clusters(pieces: &[Piece], keep: impl Fn(usize) -> bool) -> Vec<Cluster> {
    let alone = |index: usize| {
        let Piece { min, max, closed, .. } = pieces[index];
        let wider = DVec3::splat(if closed { 0.0 } else { GAPS * (max - min).length() });
        Cluster { pieces: vec![index], min: min - wider, max: max + wider }
    };
    let mut found: Vec<Cluster> = (0..pieces.len()).filter(|&index| keep(index)).map(alone).collect();
    loop {
        let before = found.len();
        found = joined(&found);
        // The box around two of them may touch a third one.
        if found.len() == before {
            break;
        }
    }
    for cluster in &mut found {
        cluster.pieces.sort_unstable();
        let boxes = || cluster.pieces.iter().map(|&index| &pieces[index]);
        cluster.min = boxes().map(|piece| piece.min).fold(DVec3::INFINITY, DVec3::min);
        cluster.max = boxes().map(|piece| piece.max).fold(DVec3::NEG_INFINITY, DVec3::max);
    }
    found
}

/// Joins those whose boxes touch.
fn joined(boxes: &[Cluster]) -> Vec<Cluster> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].min.x.total_cmp(&boxes[b].min.x).then(a.cmp(&b)));
    let mut groups = Groups::new(boxes.len());
    let mut near: Vec<usize> = Vec::new();
    for &index in &order {
        let own = &boxes[index];
        near.retain(|&other| boxes[other].max.x >= own.min.x);
        for &other in &near {
            let beside = &boxes[other];
            if own.min.cmple(beside.max).all() && beside.min.cmple(own.max).all() {
                groups.join(index, other);
            }
        }
        near.push(index);
    }
    let (labels, count) = groups.labels();
    let empty = Cluster { pieces: Vec::new(), min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    let mut found = vec![empty; count];
    for (one, &label) in boxes.iter().zip(&labels) {
        let cluster = &mut found[label as usize];
        cluster.pieces.extend(&one.pieces);
        cluster.min = cluster.min.min(one.min);
        cluster.max = cluster.max.max(one.max);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_that_touch_in_a_chain_are_one_group() {
        let piece = |x: f64| Piece {
            faces: Vec::new(),
            min: DVec3::new(x, 0.0, 0.0),
            max: DVec3::new(x + 1.0, 1.0, 1.0),
            volume: 1.0,
            closed: true,
            sheet: false,
        };
        let pieces = [piece(5.0), piece(0.0), piece(2.0), piece(1.0), piece(9.0)];
        let groups: Vec<_> = clusters(&pieces, |index| index != 4).into_iter().map(|group| group.pieces).collect();
        assert_eq!(groups, [vec![0], vec![1, 2, 3]]);
    }
}
