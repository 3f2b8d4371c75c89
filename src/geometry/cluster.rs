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

/// Groups those of the pieces that `keep` accepts, by the first piece of each group. The boxes of two groups may touch, but
/// no piece of one touches one of the other.
pub(crate) fn clusters(pieces: &[Piece], keep: impl Fn(usize) -> bool) -> Vec<Cluster> {
    let mut order: Vec<usize> = (0..pieces.len()).filter(|&index| keep(index)).collect();
    order.sort_by(|&a, &b| pieces[a].min.x.total_cmp(&pieces[b].min.x).then(a.cmp(&b)));
    let mut groups = Groups::new(pieces.len());
    let mut near: Vec<usize> = Vec::new();
    for &index in &order {
        let piece = &pieces[index];
        near.retain(|&other| pieces[other].max.x >= piece.min.x);
        for &other in &near {
            let other_piece = &pieces[other];
            if piece.min.cmple(other_piece.max).all() && other_piece.min.cmple(piece.max).all() {
                groups.join(index, other);
            }
        }
        near.push(index);
    }
    let (labels, count) = groups.labels();
    let empty = Cluster { pieces: Vec::new(), min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    let mut found = vec![empty; count];
    order.sort_unstable();
    for index in order {
        let cluster = &mut found[labels[index] as usize];
        cluster.pieces.push(index);
        cluster.min = cluster.min.min(pieces[index].min);
        cluster.max = cluster.max.max(pieces[index].max);
    }
    found.retain(|cluster| !cluster.pieces.is_empty());
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
        };
        let pieces = [piece(5.0), piece(0.0), piece(2.0), piece(1.0), piece(9.0)];
        let groups: Vec<_> = clusters(&pieces, |index| index != 4).into_iter().map(|group| group.pieces).collect();
        assert_eq!(groups, [vec![0], vec![1, 2, 3]]);
    }
}
