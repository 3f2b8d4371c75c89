//! Lattices of which a whole number of layers fills a length.

use glam::DVec3;

/// Cost of a coarser and of a finer lattice, and of one that is stretched, as error of moments.
const COARSER: f64 = 0.15;
const FINER: f64 = 0.3;
pub(crate) const UNEVEN: f64 = 0.5;

/// Least and greatest change of the spacing that is made for it.
pub(crate) const CHANGES: [f64; 2] = [0.8, 1.25];

/// Stretches that differ from one by less are none.
const WHOLE: f64 = 1e-9;

/// By how much a spacing [m] is stretched so that a whole number of layers fills a length [m]; exactly one where it
/// does.
pub(crate) fn stretch_to(length: f64, layers: f64, spacing: f64) -> f64 {
    let stretch = length / (layers * spacing);
    if (stretch - 1.0).abs() < WHOLE { 1.0 } else { stretch }
}

/// What a change of the spacing and a stretch along the axes cost.
pub(crate) fn price(change: f64, stretch: DVec3) -> f64 {
    let by = if change < 1.0 { FINER } else { COARSER };
    let uneven = stretch.max_element().max(1.0).ln() - stretch.min_element().min(1.0).ln();
    by * change.ln().abs() + UNEVEN * uneven
}

/// Changes of a spacing [m] by which a length [m] is a whole number of layers.
pub(crate) fn whole_changes(length: f64, spacing: f64) -> impl Iterator<Item = f64> {
    let layers = (length / spacing).floor().max(1.0);
    let [least, greatest] = CHANGES;
    [layers, layers + 1.0]
        .map(|count| stretch_to(length, count, spacing))
        .into_iter()
        .filter(move |&change| least <= change && change <= greatest)
}
