//! How a lattice is cut into bricks.

use glam::{DMat3, DVec3, IVec3, Vec3Swizzles};
use std::collections::HashSet;

/// Which axis of the lattice the rows run along, how long the bricks are and where they begin on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Alignment {
    /// The axis: 0 x, 1 y, 2 z.
    axis: usize,
    /// Cells of a brick, one for each lane.
    length: i32,
    /// Cells by which bricks begin before a multiple of their length.
    phase: i32,
}

impl Alignment {
    /// Bricks of so many lanes along x.
    pub(crate) fn plain(lanes: usize) -> Self {
        #[allow(clippy::cast_possible_wrap, reason = "a register has a handful")]
        Self { axis: 0, length: lanes as i32, phase: 0 }
    }

    /// Every alignment of bricks of so many lanes, the plain one first.
    fn all(lanes: usize) -> impl Iterator<Item = Self> {
        let plain = Self::plain(lanes);
        (0..3).flat_map(move |axis| (0..plain.length).map(move |phase| Self { axis, phase, ..plain }))
    }

    /// The alignment of fewest bricks; another than the plain one only where that saves some.
    pub(crate) fn of_fewest_bricks(cells: &[IVec3], lanes: usize) -> Self {
        let bricks = |cut: Self| cells.iter().map(|&cell| cut.brick_of(cut.cell(cell))).collect::<HashSet<_>>().len();
        let mut best: Option<(usize, Self)> = None;
        for cut in Self::all(lanes) {
            let count = bricks(cut);
            if best.is_none_or(|(least, _)| 20 * count < 19 * least) {
                best = Some((count, cut));
            }
        }
        best.map_or(Self::plain(lanes), |(_, cut)| cut)
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

    /// Numbers along the lattice's axes in the same order.
    pub(crate) fn along(self, values: DVec3) -> DVec3 {
        [values, values.yzx(), values.zxy()][self.axis]
    }

    /// Cells of a brick.
    pub(crate) fn length(self) -> i32 {
        self.length
    }

    /// Brick of a cell along the rows: its x in units of bricks.
    pub(super) fn brick_of(self, cell: IVec3) -> IVec3 {
        IVec3::new(cell.x.div_euclid(self.length), cell.y, cell.z)
    }

    /// Lane of a cell along the rows within its brick.
    pub(super) fn lane_of(self, cell: IVec3) -> usize {
        cell.x.rem_euclid(self.length) as usize
    }
}
