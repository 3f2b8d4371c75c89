//! What bodies hold on to by friction, of each other and of panels; of the room they do on their own.

use crate::solver::body_contact::TouchKey;
use crate::solver::forces::Grip;

/// The grips of a world.
#[derive(Clone, Debug, Default)]
pub(super) struct Grips {
    /// Of every two bodies that touch: stretches [m], by the indices of the bodies.
    pairs: Vec<([usize; 2], Grip<TouchKey>)>,
    /// Of every body that touches a panel: places [m], by the indices of the two.
    panels: Vec<([usize; 2], Grip<u32>)>,
}

impl Grips {
    /// Has two bodies take hold of each other anew.
    pub(super) fn of_pair<T>(&mut self, pair: [usize; 2], renew: impl FnOnce(&mut Grip<TouchKey>) -> T) -> T {
        renewed(&mut self.pairs, pair, renew)
    }

    /// Has a body take hold of a panel anew.
    pub(super) fn of_panel<T>(&mut self, pair: [usize; 2], renew: impl FnOnce(&mut Grip<u32>) -> T) -> T {
        renewed(&mut self.panels, pair, renew)
    }

    /// Those of a world in which bodies and panels have other indices; none of what has no index there.
    pub(super) fn renumbered(
        &self,
        body: impl Fn(usize) -> Option<usize>,
        panel: impl Fn(usize) -> Option<usize>,
    ) -> Self {
        let pairs = self.pairs.iter().filter_map(|([first, second], grip)| {
            let pair = [body(*first)?, body(*second)?];
            (pair[0] < pair[1]).then(|| (pair, grip.clone()))
        });
        let panels = self.panels.iter().filter_map(|([of, on], grip)| Some(([body(*of)?, panel(*on)?], grip.clone())));
        Self { pairs: pairs.collect(), panels: panels.collect() }
    }

    /// Memory that they take beside themselves [bytes].
    pub(super) fn bytes(&self) -> usize {
        let pairs: usize = self.pairs.iter().map(|pair| size_of_val(pair) + pair.1.bytes()).sum();
        let panels: usize = self.panels.iter().map(|pair| size_of_val(pair) + pair.1.bytes()).sum();
        pairs + panels
    }
}

fn renewed<K: Copy + Ord, T>(
    grips: &mut Vec<([usize; 2], Grip<K>)>,
    pair: [usize; 2],
    renew: impl FnOnce(&mut Grip<K>) -> T,
) -> T {
    let index = grips.iter().position(|(known, _)| *known == pair);
    let mut grip = index.map_or_else(Grip::default, |index| grips.swap_remove(index).1);
    let answer = renew(&mut grip);
    if !grip.is_empty() {
        grips.push((pair, grip));
    }
    answer
}
