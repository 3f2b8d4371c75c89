//! Which way the fibres run through every particle.

use crate::solver::body::FibreLine;
use glam::DVec3;

/// Mean directions of the fibres at particles at `positions` [m]: of every edge, by the weights with which a particle
/// carries its ends. A fibre has no front, so that those that run the other way count as if they did not. Zero where
/// there is none.
pub(super) fn fibre_directions(fibres: &[FibreLine], positions: &[DVec3]) -> Vec<DVec3> {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for fibre in fibres {
        let vertices: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(positions)).collect();
        for (edge, ends) in vertices.windows(2).enumerate() {
            let along = (ends[1] - ends[0]).normalize_or_zero();
            for vertex in &fibre.vertices[edge..edge + 2] {
                for &(particle, weight) in &vertex.weights {
                    let sum = &mut sums[particle as usize];
                    let sense = if sum.dot(along) < 0.0 { -1.0 } else { 1.0 };
                    *sum += sense * weight.abs() * along;
                }
            }
        }
    }
    sums.into_iter().map(DVec3::normalize_or_zero).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::embedding::EmbeddingWeights;

    #[test]
    fn fibres_that_run_both_ways_do_not_cancel() {
        let at = |particles: [u32; 2]| FibreLine {
            id: String::new(),
            vertices: particles.map(EmbeddingWeights::of_particle).to_vec(),
        };
        let positions = [DVec3::ZERO, 2.0 * DVec3::X, DVec3::Y];
        let found = fibre_directions(&[at([0, 1]), at([1, 0])], &positions);
        assert_eq!(found, [DVec3::X, DVec3::X, DVec3::ZERO]);
    }
}
