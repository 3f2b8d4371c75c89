//! Whose forces hang on whose motion.

use std::ops::Range;

/// For every particle those whose motion changes its force, itself among them, ascending; symmetric.
#[derive(Clone, Debug)]
pub(super) struct Sparsity {
    starts: Vec<usize>,
    columns: Vec<u32>,
}

impl Sparsity {
    /// Of `n` particles, where those of a group hang on each other.
    pub(super) fn new(n: usize, groups: &[Vec<u32>]) -> Self {
        let mut groups_of: Vec<Vec<u32>> = vec![Vec::new(); n];
        for (g, group) in groups.iter().enumerate() {
            for &i in group {
                groups_of[i as usize].push(g as u32);
            }
        }
        let mut seen_by = vec![usize::MAX; n];
        let mut this = Self { starts: vec![0], columns: Vec::new() };
        for (i, of) in groups_of.iter().enumerate() {
            let first = this.columns.len();
            let members = of.iter().flat_map(|&g| groups[g as usize].iter().copied());
            for j in std::iter::once(i as u32).chain(members) {
                if seen_by[j as usize] != i {
                    seen_by[j as usize] = i;
                    this.columns.push(j);
                }
            }
            this.columns[first..].sort_unstable();
            this.starts.push(this.columns.len());
        }
        this
    }

    /// Number of particles.
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of blocks.
    pub(super) fn blocks(&self) -> usize {
        self.columns.len()
    }

    /// Places of row i among all blocks.
    pub(super) fn range(&self, i: usize) -> Range<usize> {
        self.starts[i]..self.starts[i + 1]
    }

    /// Particles of row i.
    pub(super) fn row(&self, i: usize) -> &[u32] {
        &self.columns[self.range(i)]
    }

    /// Place of the block in row i and column j, which there must be.
    pub(super) fn place(&self, i: usize, j: usize) -> usize {
        self.starts[i] + self.row(i).partition_point(|&k| (k as usize) < j)
    }

    /// Sets of particles of which no two change the force on the same one: they can be moved at once, and each force
    /// that changes tells which of them did it.
    pub(super) fn colours(&self) -> Vec<Vec<u32>> {
        let mut colour_of = vec![usize::MAX; self.len()];
        let mut taken_by: Vec<usize> = Vec::new();
        let mut colours: Vec<Vec<u32>> = Vec::new();
        for j in 0..self.len() {
            for &i in self.row(j) {
                for &k in self.row(i as usize) {
                    if let Some(taken) = taken_by.get_mut(colour_of[k as usize]) {
                        *taken = j;
                    }
                }
            }
            let free = (0..taken_by.len()).find(|&colour| taken_by[colour] != j).unwrap_or_else(|| {
                taken_by.push(usize::MAX);
                colours.push(Vec::new());
                taken_by.len() - 1
            });
            colour_of[j] = free;
            colours[free].push(j as u32);
        }
        colours
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_row_holds_two_of_a_colour() {
        // A chain in which three neighbours hang together, and a particle by itself.
        let groups: Vec<Vec<u32>> = (0..40).map(|i| vec![i, i + 1, i + 2]).collect();
        let sparsity = Sparsity::new(43, &groups);
        assert_eq!(sparsity.row(0), [0, 1, 2]);
        assert_eq!(sparsity.row(20), [18, 19, 20, 21, 22]);
        assert_eq!(sparsity.row(42), [42]);
        assert_eq!(sparsity.place(20, 21), sparsity.range(20).start + 3);
        let colours = sparsity.colours();
        assert_eq!(colours.iter().map(Vec::len).sum::<usize>(), 43);
        assert!(colours.len() <= 6, "{} colours", colours.len());
        for i in 0..43 {
            for colour in &colours {
                assert!(sparsity.row(i).iter().filter(|j| colour.contains(j)).count() <= 1);
            }
        }
    }
}
