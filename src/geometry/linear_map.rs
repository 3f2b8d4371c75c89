//! Points as weighted sums of other points.

use glam::Vec3;
use rayon::prelude::*;

/// A sparse linear map of points in single precision: point `i` is the sum of `weights[k] * points[sources[k]]` over
/// `k` in `starts[i]..starts[i + 1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearMap {
    /// Where the terms of every point start, and one more.
    pub starts: Vec<u32>,
    /// The points that are summed.
    pub sources: Vec<u32>,
    /// Their weights.
    pub weights: Vec<f32>,
}

impl Default for LinearMap {
    /// No points at all.
    fn default() -> Self {
        Self { starts: vec![0], sources: Vec::new(), weights: Vec::new() }
    }
}

impl LinearMap {
    /// Points that are copies of others.
    pub fn gather(sources: &[u32]) -> Self {
        Self {
            starts: (0..=sources.len() as u32).collect(),
            sources: sources.to_vec(),
            weights: vec![1.0; sources.len()],
        }
    }

    /// Number of points that it gives.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether it gives none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds a point.
    pub fn push(&mut self, terms: impl IntoIterator<Item = (u32, f32)>) {
        for (source, weight) in terms {
            self.sources.push(source);
            self.weights.push(weight);
        }
        self.starts.push(self.sources.len() as u32);
    }

    /// The terms of a point.
    pub fn terms(&self, point: usize) -> impl Iterator<Item = (u32, f32)> {
        let range = self.starts[point] as usize..self.starts[point + 1] as usize;
        self.sources[range.clone()].iter().copied().zip(self.weights[range].iter().copied())
    }

    /// This map of what `first` gives.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        let mut whole = Self::default();
        let mut terms: Vec<(u32, f32)> = Vec::new();
        for point in 0..self.len() {
            terms.clear();
            for (middle, outer) in self.terms(point) {
                terms.extend(first.terms(middle as usize).map(|(source, inner)| (source, outer * inner)));
            }
            terms.sort_by_key(|(source, _)| *source);
            terms.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += next.1;
                }
                same
            });
            whole.push(terms.iter().copied());
        }
        whole
    }

    /// The values that it makes of `values`, one at each of its sources.
    pub fn apply_to_values(&self, values: &[f32]) -> Vec<f32> {
        let sum = |point| self.terms(point).map(|(source, weight)| weight * values[source as usize]).sum();
        (0..self.len()).into_par_iter().with_min_len(1024).map(sum).collect()
    }

    /// The points that it makes of `points`.
    pub fn apply(&self, points: &[Vec3]) -> Vec<Vec3> {
        let sum = |point| self.terms(point).map(|(source, weight)| weight * points[source as usize]).sum();
        (0..self.len()).into_par_iter().with_min_len(1024).map(sum).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_after_each_other_are_one_map() {
        let mut first = LinearMap::default();
        first.push([(0, 0.5), (1, 0.5)]);
        first.push([(1, 1.0)]);
        let mut second = LinearMap::gather(&[1, 0]);
        second.push([(0, 0.25), (1, 0.75)]);
        let points = [Vec3::X, Vec3::new(0.0, 2.0, 4.0)];
        let whole = second.after(&first);
        assert_eq!(whole.apply(&points), second.apply(&first.apply(&points)));
        assert_eq!(whole.terms(2).collect::<Vec<_>>(), [(0, 0.125), (1, 0.875)]);
    }
}
