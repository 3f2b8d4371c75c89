//! An order of vertices in which those that touch each other stand near each other (reverse Cuthill-McKee).

use std::collections::{BTreeSet, VecDeque};

/// The vertices in order. `neighbours` are those of each vertex, in both directions.
pub(super) fn near_neighbours_first(neighbours: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut order = Vec::with_capacity(neighbours.len());
    let mut met = vec![false; neighbours.len()];
    for vertex in 0..neighbours.len() {
        if met[vertex] {
            continue;
        }
        // From one end of what hangs together: the vertex that is reached last from any is such an end, about.
        let reached = breadth_first(neighbours, vertex, &mut met.clone());
        let from = breadth_first(neighbours, reached[reached.len() - 1], &mut met.clone());
        order.extend(breadth_first(neighbours, from[from.len() - 1], &mut met));
    }
    order.reverse();
    order
}

/// All that is reached from a vertex, level by level, of each those of few neighbours first.
fn breadth_first(neighbours: &[BTreeSet<usize>], from: usize, met: &mut [bool]) -> Vec<usize> {
    let mut order = Vec::new();
    let mut queue = VecDeque::from([from]);
    met[from] = true;
    while let Some(vertex) = queue.pop_front() {
        order.push(vertex);
        let mut next: Vec<usize> = neighbours[vertex].iter().copied().filter(|&near| !met[near]).collect();
        next.sort_by_key(|&near| (neighbours[near].len(), near));
        for near in next {
            met[near] = true;
            queue.push_back(near);
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shuffled_chain_and_one_more_come_out_in_order() {
        let chain = [4, 2, 0, 3, 1];
        let mut neighbours = vec![BTreeSet::new(); 7];
        for pair in chain.windows(2).chain([&[5, 6][..]]) {
            neighbours[pair[0]].insert(pair[1]);
            neighbours[pair[1]].insert(pair[0]);
        }
        let order = near_neighbours_first(&neighbours);
        let place = |vertex| order.iter().position(|&one| one == vertex).expect("every vertex has a place");
        for (vertex, near) in neighbours.iter().enumerate() {
            assert!(near.iter().all(|&near| place(vertex).abs_diff(place(near)) == 1), "{order:?}");
        }
    }
}
