//! Which pieces of a surface have an inside, and which are sheets and strays that enclose nothing.

use super::cluster::{Cluster, clusters};
use super::holes::OpenSurface;
use super::inside::{Inside, Measured};
use super::model_report::Refusal;
use super::orient::Piece;
use super::progress::GoOn;
use super::weld::Welded;
use glam::DVec3;
use std::ops::ControlFlow;

/// Volume below this share of that of a cube of a piece's diagonal counts as none.
pub(crate) const NO_VOLUME: f64 = 1e-9;

/// Share of doubtful points from which on an open surface is refused: a cube without its lid has a fifth.
const TOO_DOUBTFUL: f64 = 0.19;

/// Rows through pieces with holes: at least, for each face, at most.
const ROWS: [usize; 3] = [400, 8, 2500];

/// Pieces that have an inside and those that have none.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sorted {
    /// Numbers of the pieces that enclose nothing, in order.
    pub nothing: Vec<usize>,
    /// Surfaces with holes that have an inside all the same, by the group of pieces that each is made of.
    pub open: Vec<OpenSurface>,
    /// Volume of those [m³].
    pub volume: f64,
    /// Volume in them where inside and outside are not clearly told apart [m³].
    pub doubtful: f64,
    /// Greatest share of doubt for which pieces with holes were left out.
    pub refused_doubt: Option<f64>,
}

/// Pieces with holes, taken together.
struct Tried {
    pieces: Vec<usize>,
    surface: OpenSurface,
    volume: f64,
    measured: Measured,
    /// Of the doubtful in the inside; one where hardly anything is.
    doubt: f64,
}

/// Sorts the pieces of an oriented surface; `go_on` is asked from time to time.
pub(crate) fn sort(surface: &Welded, pieces: &[Piece], go_on: &mut GoOn<'_>) -> ControlFlow<(), Sorted> {
    let mut sorted = Sorted::default();
    let is_empty =
        |piece: &Piece| piece.closed && piece.volume.abs() <= NO_VOLUME * (piece.max - piece.min).length().powi(3);
    sorted.nothing = (0..pieces.len()).filter(|&index| is_empty(&pieces[index])).collect();
    for group in clusters(pieces, |index| !pieces[index].closed) {
        let tried = best(surface, pieces, &group, go_on)?;
        if tried.doubt > TOO_DOUBTFUL {
            sorted.refused_doubt = Some(sorted.refused_doubt.unwrap_or(0.0).max(tried.doubt));
            sorted.nothing.extend(group.pieces);
        } else {
            sorted.nothing.extend(group.pieces.iter().filter(|index| !tried.pieces.contains(index)));
            sorted.volume += tried.volume;
            sorted.doubtful += tried.measured.doubtful;
            sorted.open.push(tried.surface);
        }
    }
    sorted.nothing.sort_unstable();
    ControlFlow::Continue(sorted)
}

impl Sorted {
    /// Why a surface of which nothing is left cannot be filled.
    pub(crate) fn refusal(&self, open_edges: usize, holes: usize) -> Refusal {
        match self.refused_doubt {
            Some(doubtful) if doubtful < 1.0 => Refusal::TooOpen { open_edges, holes, doubtful },
            _ => Refusal::NothingInside { open_edges, holes },
        }
    }
}

/// The pieces of a group that tell inside from outside most clearly: all of them, or those that are no sheets.
fn best(surface: &Welded, pieces: &[Piece], group: &Cluster, go_on: &mut GoOn<'_>) -> ControlFlow<(), Tried> {
    let all = tried(surface, pieces, group.pieces.clone(), go_on)?;
    let bent: Vec<usize> = group.pieces.iter().copied().filter(|&index| !pieces[index].sheet).collect();
    if bent.is_empty() || bent.len() == group.pieces.len() || all.doubt == 0.0 {
        return ControlFlow::Continue(all);
    }
    let without = tried(surface, pieces, bent, go_on)?;
    ControlFlow::Continue(if without.doubt < all.doubt { without } else { all })
}

fn tried(surface: &Welded, pieces: &[Piece], chosen: Vec<usize>, go_on: &mut GoOn<'_>) -> ControlFlow<(), Tried> {
    go_on()?;
    let points = &surface.points;
    let every = || chosen.iter().map(|&index| &pieces[index]);
    let faces: Vec<[u32; 3]> =
        every().flat_map(|piece| &piece.faces).map(|&face| surface.faces[face as usize]).collect();
    let min = every().map(|piece| piece.min).fold(DVec3::INFINITY, DVec3::min);
    let max = every().map(|piece| piece.max).fold(DVec3::NEG_INFINITY, DVec3::max);
    let [least, each, most] = ROWS;
    let rows = (each * faces.len()).clamp(least, most);
    let surface = OpenSurface::new(points, &faces);
    let capped_volume = surface.capped_volume(min);
    let mut alone = Inside::new(points, <(Vec<_>, Vec<_>)>::default(), vec![surface]);
    // Where these are all the pieces there are their volume is measured along the same rows and some more.
    alone.remember([min, max], rows, go_on)?;
    let measured = alone.measure(points, [min, max], rows, go_on)?;
    let volume = (capped_volume - measured.shared).min((max - min).element_product());
    let encloses = volume > NO_VOLUME * (max - min).length().powi(3);
    let doubt = if encloses { (measured.doubtful / volume).min(1.0) } else { 1.0 };
    let surface = alone.into_open().swap_remove(0);
    ControlFlow::Continue(Tried { pieces: chosen, surface, volume, measured, doubt })
}
