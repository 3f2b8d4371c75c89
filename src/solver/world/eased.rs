//! What a world is easing apart.

use crate::solver::eased_overlap::EasedOverlap;
use crate::solver::overlap::EasedPair;

/// What is being eased apart, from its start on.
#[derive(Clone, Debug, Default)]
pub(super) struct Eased {
    pub(super) pairs: Vec<EasedPair>,
    /// Bodies and panels by their indices.
    pub(super) panels: Vec<(usize, usize, EasedOverlap)>,
}

impl Eased {
    /// How two bodies are eased apart, if they are.
    pub(super) fn pair(&self, first: usize, second: usize) -> Option<&EasedPair> {
        self.pairs.iter().find(|pair| (pair.first, pair.second) == (first, second))
    }

    /// How a body is eased out of a panel, if it is.
    pub(super) fn panel(&self, body: usize, panel: usize) -> Option<&EasedOverlap> {
        self.panels.iter().find(|eased| (eased.0, eased.1) == (body, panel)).map(|(.., easing)| easing)
    }

    /// When all is apart [s].
    pub(super) fn end(&self) -> f64 {
        let ends = self.pairs.iter().map(|pair| pair.easing.end());
        ends.chain(self.panels.iter().map(|(.., easing)| easing.end())).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Memory that it takes beside itself [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.pairs) + size_of_val(&*self.panels)
    }
}
