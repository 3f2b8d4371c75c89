//! Which point of one stroke belongs to which of the other: an order-preserving dynamic programming.

use glam::DVec2;

/// Weight w of the difference in normalised arc length against that in the shared coordinate. It decides where the
/// shared coordinate stands still and cannot.
pub(super) const ARC_LENGTH_WEIGHT: f64 = 0.01;

/// Cost of a step that advances both strokes, in terms of one that advances a single one: it stands for two of them.
const DIAGONAL: f64 = 2.0;

/// Two sample sequences to be matched.
#[derive(Clone, Copy)]
pub(super) struct Sequences<'a> {
    /// Samples of the two strokes, (own, shared) [m], uniform in arc length.
    pub(super) samples: [&'a [DVec2]; 2],
    /// Weight w of the squared difference in normalised arc length.
    pub(super) arc_weight: f64,
    /// Length that makes shared coordinates comparable: the model's diagonal H [m].
    pub(super) scale: f64,
    /// Where the match may end on the first stroke.
    pub(super) end: MatchEnd,
}

/// Where a match may end on the first stroke.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum MatchEnd {
    /// At its last sample.
    Last,
    /// Wherever the mean cost is least: the second stroke is still being drawn.
    Anywhere,
}

/// An order-preserving correspondence.
#[derive(Clone, Debug)]
pub(super) struct Match {
    /// Index pairs (first, second) from both starts on; each pair advances one index or both by one.
    pub(super) pairs: Vec<[usize; 2]>,
    /// Mean cost over the path: dimensionless, a squared fraction of the model's diagonal.
    pub(super) mean_cost: f64,
}

/// The cheapest order-preserving path through the table of all pairs, with
/// cost(i, j) = ((yA - yB) / H)² + w (sA - sB)², steps (1, 0), (0, 1) and, at twice the cost, (1, 1)
/// (Sakoe and Chiba's symmetric form, IEEE ASSP 26, 1978: every path has the same total weight, so that
/// its sum can be compared and averaged). Either sequence empty gives an empty path.
pub(super) fn correspond(sequences: Sequences<'_>) -> Match {
    let Sequences { samples: [first, second], scale, end, .. } = sequences;
    let (rows, columns) = (first.len(), second.len());
    if rows == 0 || columns == 0 {
        return Match { pairs: Vec::new(), mean_cost: 0.0 };
    }
    let arc_scale = sequences.arc_weight.sqrt();
    let signature = |samples: &[DVec2]| -> Vec<DVec2> {
        let last = samples.len().saturating_sub(1).max(1) as f64;
        samples.iter().enumerate().map(|(i, point)| DVec2::new(point.y / scale, arc_scale * i as f64 / last)).collect()
    };
    let (a, b) = (signature(first), signature(second));
    let mut steps = vec![Advance::Both; rows * columns];
    let mut totals = vec![0.0; columns];
    // Least mean cost of a path that ends in the last column, and its row.
    let mut best = (f64::INFINITY, rows - 1);
    for (i, here) in a.iter().enumerate() {
        // Total of the cell up and left, which the sweep has already overwritten.
        let mut diagonal = 0.0;
        for (j, there) in b.iter().enumerate() {
            let cost = here.distance_squared(*there);
            let up = totals[j];
            let (mut total, mut step) = (diagonal + DIAGONAL * cost, Advance::Both);
            if i > 0 && (j == 0 || up + cost < total) {
                (total, step) = (up + cost, Advance::First);
            }
            if j > 0 && (i == 0 || totals[j - 1] + cost < total) {
                (total, step) = (totals[j - 1] + cost, Advance::Second);
            }
            diagonal = up;
            totals[j] = total;
            steps[i * columns + j] = step;
        }
        let mean = totals[columns - 1] / (i + 1 + columns) as f64;
        if i == rows - 1 && end == MatchEnd::Last || end == MatchEnd::Anywhere && mean < best.0 {
            best = (mean, i);
        }
    }
    Match { pairs: walk_back(&steps, columns, [best.1, columns - 1]), mean_cost: best.0 }
}

/// Which strokes a step advances.
#[derive(Clone, Copy)]
enum Advance {
    First,
    Second,
    Both,
}

fn walk_back(steps: &[Advance], columns: usize, end: [usize; 2]) -> Vec<[usize; 2]> {
    let [mut i, mut j] = end;
    let mut pairs = vec![end];
    while i > 0 || j > 0 {
        match steps[i * columns + j] {
            Advance::First => i -= 1,
            Advance::Second => j -= 1,
            Advance::Both => (i, j) = (i - 1, j - 1),
        }
        pairs.push([i, j]);
    }
    pairs.reverse();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heights(values: &[f64]) -> Vec<DVec2> {
        values.iter().map(|&y| DVec2::new(0.0, y)).collect()
    }

    fn total(a: &[DVec2], b: &[DVec2], pairs: &[[usize; 2]]) -> f64 {
        let cost = |[i, j]: [usize; 2]| {
            let arc = i as f64 / (a.len() - 1) as f64 - j as f64 / (b.len() - 1) as f64;
            (a[i].y - b[j].y).powi(2) + ARC_LENGTH_WEIGHT * arc * arc
        };
        let steps = pairs.windows(2).map(|w| (w[1][0] - w[0][0] + w[1][1] - w[0][1]) as f64 * cost(w[1]));
        2.0 * cost(pairs[0]) + steps.sum::<f64>()
    }

    /// Every monotone path, by brute force.
    fn paths(path: &mut Vec<[usize; 2]>, end: [usize; 2], visit: &mut impl FnMut(&[[usize; 2]])) {
        let [i, j] = path[path.len() - 1];
        if [i, j] == end {
            return visit(path);
        }
        for next in [[i + 1, j], [i, j + 1], [i + 1, j + 1]] {
            if next[0] <= end[0] && next[1] <= end[1] {
                path.push(next);
                paths(path, end, visit);
                path.pop();
            }
        }
    }

    #[test]
    fn the_path_found_is_the_cheapest_of_all_paths() {
        let (a, b) = (heights(&[0.0, 0.3, 0.9, 0.4, 1.0]), heights(&[0.1, 0.8, 1.0, 0.3, 0.2, 0.9]));
        let found =
            correspond(Sequences { samples: [&a, &b], arc_weight: ARC_LENGTH_WEIGHT, scale: 1.0, end: MatchEnd::Last });
        let mut least = f64::INFINITY;
        paths(&mut vec![[0, 0]], [4, 5], &mut |path| least = least.min(total(&a, &b, path)));
        assert!((found.mean_cost * 11.0 - least).abs() < 1e-14);
        assert!((total(&a, &b, &found.pairs) - least).abs() < 1e-14);
    }

    #[test]
    fn an_open_end_stops_where_the_second_sequence_is() {
        let (a, b) = (heights(&[0.0, 0.2, 0.4, 0.6, 0.4, 0.2, 0.0]), heights(&[0.0, 0.2, 0.4]));
        let found = correspond(Sequences { samples: [&a, &b], arc_weight: 0.0, scale: 1.0, end: MatchEnd::Anywhere });
        assert_eq!(found.pairs, [[0, 0], [1, 1], [2, 2]]);
        assert_eq!(found.mean_cost, 0.0);
    }

    #[test]
    fn empty_sequences_match_nothing() {
        let found = correspond(Sequences { samples: [&[], &[]], arc_weight: 0.0, scale: 1.0, end: MatchEnd::Last });
        assert!(found.pairs.is_empty());
    }
}
