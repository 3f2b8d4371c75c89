//! How a lattice is cut into bricks.

use crate::solver::wide::LANES;
use glam::{DMat3, IVec3};
use std::collections::HashSet;

/// Cells of a brick, one for each lane.
pub(crate) const CELLS: i32 = 4;
const _: () = assert!(CELLS as usize == LANES, "a brick fills its lanes");

/// Which axis of the lattice the rows run along, and where bricks begin on it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Alignment {
    /// The axis: 0 x, 1 y, 2 z.
    axis: usize,
    /// Cells by which bricks begin before a multiple of four.
    phase: i32,
}

impl Alignment {
    /// Every alignment, the plain one first.
    fn all() -> impl Iterator<Item = Self> {
        (0..3).flat_map(|axis| (0..CELLS).map(move |phase| Self { axis, phase }))
    }

    /// The alignment of fewest bricks; another than the plain one only where that saves some.
    pub(crate) fn of_fewest_bricks(cells: &[IVec3]) -> Self {
        let bricks = |cut: Self| cells.iter().map(|&cell| brick_of(cut.cell(cell))).collect::<HashSet<_>>().len();
        let mut best: Option<(usize, Self)> = None;
        for cut in Self::all() {
            let count = bricks(cut);
            if best.is_none_or(|(least, _)| 20 * count < 19 * least) {
                best = Some((count, cut));
            }
        }
        best.map_or(Self::default(), |(_, cut)| cut)
    }

    /// A lattice index along the rows: the axes in turn, so that they stay right-handed, rows first, begun at the
    /// phase.
    pub(crate) fn cell(self, cell: IVec3) -> IVec3 {
        let [x, y, z] = cell.to_array();
        let cell = [IVec3::new(x, y, z), IVec3::new(y, z, x), IVec3::new(z, x, y)][self.axis];
        cell + self.phase * IVec3::X
    }

    /// The lattice's axes in the same order.
    pub(crate) fn axes(self, axes: &DMat3) -> DMat3 {
        let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis];
        match self.axis {
            0 => *axes,
            1 => DMat3::from_cols(y, z, x),
            _ => DMat3::from_cols(z, x, y),
        }
    }
}

/// Brick of a cell: its x in units of bricks.
pub(super) fn brick_of(cell: IVec3) -> IVec3 {
    IVec3::new(cell.x.div_euclid(CELLS), cell.y, cell.z)
}

/// Lane of a cell within its brick.
pub(super) fn lane_of(cell: IVec3) -> usize {
    cell.x.rem_euclid(CELLS) as usize
}
