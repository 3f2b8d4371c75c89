//! Thousands of meshes made at random: what is said of their volume is so.

use crate::random_meshes::{KINDS, mesh, volume};
use std::collections::BTreeMap;

#[test]
fn the_same_seed_gives_the_same_closed_mesh() {
    for seed in 0..10 * KINDS {
        let (points, faces, kind) = mesh(seed);
        assert_eq!((&points, &faces, kind), (&mesh(seed).0, &mesh(seed).1, mesh(seed).2));
        let mut balance: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        for &[a, b, c] in &faces {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                *balance.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
            }
        }
        assert!(balance.values().all(|&sum| sum == 0), "seed {seed}, {kind}: not closed");
        assert!(points.iter().flatten().all(|x| x.is_finite()) && volume(seed) > 0.0, "seed {seed}, {kind}");
    }
}
