//! What every table of bodies begins with.

use super::table::Align;
use crate::solver::body::Body;
use crate::text::number::four_figures;

/// The columns.
pub(super) const COLUMNS: [(&str, Align); 6] = [
    ("body", Align::Left),
    ("kind", Align::Left),
    ("particles", Align::Right),
    ("neighbours", Align::Right),
    ("fibres", Align::Right),
    ("vertices", Align::Right),
];

/// What stands in them for a body of this name.
pub(super) fn cells(name: String, body: &Body) -> [String; 6] {
    let parts = body.parts();
    [
        name,
        parts.kind.to_owned(),
        body.state().len().to_string(),
        four_figures(parts.mean_neighbours),
        parts.fibres.len().to_string(),
        parts.fibres.iter().map(|fibre| fibre.vertices.len()).sum::<usize>().to_string(),
    ]
}
