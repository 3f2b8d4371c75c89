//! A model made ready to be filled: checked, repaired where that is possible, and asked what is inside.

use super::bvh::Bvh;
use super::cluster::{Cluster, clusters};
use super::crossing::crossing_pairs_unless;
use super::edges::{Edges, count_loops};
use super::filling::KnownFilling;
use super::holes::OpenSurface;
use super::inside::Inside;
use super::model::Model;
use super::model_report::{LeftOut, ModelReport, Refusal};
use super::orient::{Orientation, area, orientation};
use super::progress::{GoOn, Progress, Steps};
use super::sheets::{NO_VOLUME, Sorted, sort};
use super::thickness_shares::Thickness;
use super::weld::Welded;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::sync::OnceLock;

/// A model with an inside.
#[derive(Clone, Debug)]
pub struct Solid {
    /// The picture, without what could not be used.
    pub model: Model,
    /// Points and oriented faces of its surface.
    pub surface: Welded,
    /// What was found and done.
    pub report: ModelReport,
    /// Least corner of the surface [m].
    pub min: DVec3,
    /// Greatest corner of the surface [m].
    pub max: DVec3,
    /// Volume inside [m³]; what lies in several pieces counts once.
    pub volume: f64,
    /// Groups of pieces whose boxes touch.
    clusters: Vec<Cluster>,
    inside: Inside,
    /// Winding numbers that are looked at for a row, on average over the group that takes most of them.
    looks_a_row: f64,
    /// How thick it is, where that was asked.
    pub(super) known_thickness: OnceLock<Thickness>,
    /// What it was filled with to see whether that does.
    pub(super) known_filling: OnceLock<KnownFilling>,
}

/// Coordinates beyond this are taken for damage [m]: their cubes, and sums of those, must stay far from the greatest
/// number.
const LARGEST: f64 = 1e9;

/// Open edges closer than this share of the diagonal are gaps that were never meant.
const GAP: f64 = 1e-5;

/// Steps in which a model is checked.
const STEPS: usize = 8;

/// Rows along which what pieces share is measured, in all; for each face of a group that is measured, and the least for
/// a group.
const ROWS: f64 = 100_000.0;
const ROWS_EACH: f64 = 64.0;
const LEAST_ROWS: f64 = 4096.0;

impl Solid {
    /// Checks a model whose positions are in metres, repairs what it can and measures what is inside.
    ///
    /// # Errors
    /// [`Refusal`] where nothing can be filled.
    pub fn new(model: &Model) -> Result<Self, Refusal> {
        match Self::with_progress(model, &mut |_, _| ControlFlow::Continue(())) {
            ControlFlow::Continue(checked) => checked,
            ControlFlow::Break(()) => unreachable!("nothing stops it"),
        }
    }

    /// [`Self::new`], and `progress` hears how far it has come; it breaks off what is no longer wanted, and is not
    /// asked again then.
    pub(crate) fn with_progress(model: &Model, progress: &mut Progress<'_>) -> ControlFlow<(), Result<Self, Refusal>> {
        let mut report = ModelReport { reading: model.notes.clone(), ..ModelReport::default() };
        let model = without_lost(model, &mut report);
        Self::of_usable(model, report, &mut Steps::new(STEPS, progress))
    }

    /// Leaves out the pieces that enclose nothing and begins again without them: they are not to count for the extents
    /// either.
    fn of_usable(
        model: Model,
        mut report: ModelReport,
        steps: &mut Steps<'_, '_>,
    ) -> ControlFlow<(), Result<Self, Refusal>> {
        if model.triangles.is_empty() {
            return ControlFlow::Continue(Err(Refusal::NoFaces { lost_faces: report.lost_faces }));
        }
        steps.reach(0)?;
        let mut surface = Welded::new(&model);
        steps.reach(1)?;
        let as_given = report.clone();
        drop_duplicates(&mut surface, &mut report);
        let (min, max) = bounds(&surface.points);
        close_gaps(&mut surface, GAP * (max - min).length(), &mut report);

        steps.reach(2)?;
        let edges = Edges::new(&surface.faces);
        let bvh = Bvh::new(&surface.points, &surface.faces);
        steps.reach(3)?;
        let oriented = orientation(&surface.points, &surface.faces, &edges);
        let open: Vec<_> = edges.open().collect();
        report.open_edges = open.len();
        report.holes = count_loops(&open);
        report.crowded_edges = edges.crowded().count();
        for (face, &flipped) in surface.faces.iter_mut().zip(&oriented.flipped) {
            if flipped {
                // The first stays the least.
                face.swap(1, 2);
            }
        }
        steps.reach(4)?;
        let sorted = sort(&surface, &oriented.pieces, &mut || steps.ask())?;
        if sorted.nothing.len() == oriented.pieces.len() {
            return ControlFlow::Continue(Err(sorted.refusal(report.open_edges, report.holes)));
        }
        if !sorted.nothing.is_empty() {
            return Self::of_usable(
                without(&model, &surface, &oriented, &sorted),
                ModelReport {
                    left_out: as_given.left_out.with(left_out(&model, &surface, &oriented, &sorted)),
                    ..as_given
                },
                steps,
            );
        }
        report.closed = sorted.open.is_empty();
        report.turned_faces = oriented.disagreeing;
        report.twisted_edges = oriented.twisted;
        report.pieces = oriented.pieces.len();
        report.inverted_pieces = oriented.inverted;
        report.cavities = oriented.cavities;
        report.nested_pieces = oriented.nested;
        report.flat_faces = surface.faces.par_iter().filter(|&&face| area(&surface.points, face) == 0.0).count();
        report.vertices = model.positions.len();
        report.points = surface.points.len();
        report.faces = surface.faces.len();
        report.collapsed_faces = surface.collapsed;
        if sorted.volume > 0.0 {
            report.doubtful = sorted.doubtful / sorted.volume;
        }
        steps.reach(5)?;
        let crossings = crossing_pairs_unless(&surface.points, &surface.faces, &bvh, &mut || steps.ask())?;
        report.crossings = crossings.len();
        // Pieces that may share places with themselves.
        let mut crowded = vec![false; oriented.pieces.len()];
        let crossed = crossings.iter().flatten().copied();
        for face in crossed.chain(edges.crowded().flatten().map(|half| half.face)) {
            crowded[oriented.piece_of[face as usize] as usize] = true;
        }
        steps.reach(6)?;
        let clusters = clusters(&oriented.pieces, |_| true);
        let inside = inside(&surface, &oriented, sorted.open);
        let (known_thickness, known_filling) = (OnceLock::new(), OnceLock::new());
        let (volume, looks_a_row) = (0.0, 0.0);
        let mut this = Self {
            model,
            surface,
            report,
            min,
            max,
            volume,
            clusters,
            inside,
            looks_a_row,
            known_thickness,
            known_filling,
        };
        steps.reach(7)?;
        this.measure(&oriented, &crowded, &mut || steps.ask())?;
        this.inside.forget();
        steps.reach(STEPS)?;
        let room: f64 = this.boxes().map(|[min, max]| (max - min).length().powi(3)).sum();
        if this.volume > NO_VOLUME * room {
            return ControlFlow::Continue(Ok(this));
        }
        let ModelReport { open_edges, holes, .. } = this.report;
        ControlFlow::Continue(Err(Refusal::NothingInside { open_edges, holes }))
    }

    /// Stretches of the row through (y, z) along x that lie inside [m].
    pub(crate) fn scanline(&self, y: f64, z: f64) -> Vec<[f64; 2]> {
        self.inside.row(&self.surface.points, y, z)
    }

    /// Stretches of the row through (y, z) along x that lie inside [m], as far as a part of it is concerned.
    pub(crate) fn scanline_within(&self, row: [f64; 2], part: [f64; 2]) -> Vec<[f64; 2]> {
        self.inside.row_within(&self.surface.points, row, part)
    }

    /// Faces that are looked at for a row, on average.
    pub(crate) fn faces_a_row(&self) -> f64 {
        self.inside.faces_a_row()
    }

    /// Winding numbers that are looked at for a row beside holes, on average.
    pub(crate) fn windings_a_row(&self) -> f64 {
        self.looks_a_row
    }

    /// Whether a point lies inside.
    pub fn contains(&self, point: DVec3) -> bool {
        self.scanline_within([point.y, point.z], [point.x; 2]).iter().any(|[from, to]| (*from..=*to).contains(&point.x))
    }

    /// How many closed pieces turn around a point, cavities counting against them; none where there are open ones.
    pub(crate) fn turns_around(&self, point: DVec3) -> Option<i32> {
        self.report.closed.then(|| self.inside.turns_around(&self.surface.points, point))
    }

    /// Boxes outside of which nothing is inside: least and greatest corners [m].
    pub(crate) fn boxes(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.clusters.iter().map(|cluster| [cluster.min, cluster.max])
    }

    /// Extents [m].
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// About how many particles fill it at a spacing [m].
    pub(crate) fn particles_at(&self, spacing: f64) -> u32 {
        // More than any integer holds is more than is ever allowed.
        (self.volume / spacing.powi(3)).round() as u32
    }

    /// What the faces enclose follows from their corners; what several pieces share counts once, and is measured along
    /// rows wherever pieces may.
    fn measure(&mut self, oriented: &Orientation, crowded: &[bool], go_on: &mut GoOn<'_>) -> ControlFlow<()> {
        let pieces = &oriented.pieces;
        let points = &self.surface.points;
        let may_share = |cluster: &Cluster| {
            cluster.pieces.len() > 1 || cluster.pieces.iter().any(|&index| crowded[index] || !pieces[index].closed)
        };
        let faces =
            |cluster: &Cluster| cluster.pieces.iter().map(|&index| pieces[index].faces.len() as f64).sum::<f64>();
        let measured: f64 = self.clusters.iter().filter(|cluster| may_share(cluster)).map(faces).sum();
        let (mut volume, mut shared, mut looks_a_row) = (0.0, 0.0, 0.0_f64);
        for cluster in &self.clusters {
            let bounds = [cluster.min, cluster.max];
            let closed = cluster.pieces.iter().filter(|&&index| pieces[index].closed);
            let mut all: f64 = closed.map(|&index| pieces[index].volume).sum();
            if self.clusters.len() == 1 && self.report.closed {
                all = signed_volume(points, &self.surface.faces, self.min);
            }
            if may_share(cluster) {
                let is_open = cluster.pieces.iter().any(|&index| !pieces[index].closed);
                let most = if is_open { LEAST_ROWS } else { ROWS * faces(cluster) / measured };
                let rows = (ROWS_EACH * faces(cluster)).min(most).max(LEAST_ROWS);
                let found = self.inside.measure(points, bounds, rows as usize, go_on)?;
                looks_a_row = looks_a_row.max(found.looks_a_row);
                let caps = self.inside.capped_volume(bounds);
                if found.shared != 0.0 || caps != 0.0 {
                    all = (all + caps - found.shared).min((cluster.max - cluster.min).element_product());
                    shared += found.shared;
                }
            }
            volume += all;
        }
        (self.volume, self.looks_a_row) = (volume, looks_a_row);
        if self.report.closed {
            self.report.shared = shared / volume;
        }
        ControlFlow::Continue(())
    }
}

fn inside(surface: &Welded, oriented: &Orientation, open: Vec<OpenSurface>) -> Inside {
    let closed = |&(face, _): &(usize, &[u32; 3])| oriented.pieces[oriented.piece_of[face] as usize].closed;
    let span = |face: usize| {
        let piece = &oriented.pieces[oriented.piece_of[face] as usize];
        [piece.min.x, piece.max.x]
    };
    let faces = surface.faces.iter().enumerate().filter(closed);
    let faces = faces.map(|(index, face)| (*face, span(index))).unzip();
    Inside::new(&surface.points, faces, open)
}

/// The corners of a face, whichever way it looks.
fn corners([a, b, c]: [u32; 3]) -> [u32; 3] {
    let mut corners = [a, b, c];
    corners.sort_unstable();
    corners
}

/// Corners of the faces of pieces that enclose nothing, in order.
fn of_nothing(surface: &Welded, oriented: &Orientation, sorted: &Sorted) -> Vec<[u32; 3]> {
    let pieces = sorted.nothing.iter().map(|&index| &oriented.pieces[index]);
    let faces = pieces.flat_map(|piece| &piece.faces).map(|&face| surface.faces[face as usize]);
    let mut faces: Vec<[u32; 3]> = faces.map(corners).collect();
    faces.sort_unstable();
    faces
}

/// A model without the pieces that enclose nothing.
fn without(model: &Model, surface: &Welded, oriented: &Orientation, sorted: &Sorted) -> Model {
    let gone = of_nothing(surface, oriented, sorted);
    model.retain(|t| gone.binary_search(&corners(t.map(|i| surface.point_of[i as usize]))).is_err())
}

/// What is said of them.
fn left_out(model: &Model, surface: &Welded, oriented: &Orientation, sorted: &Sorted) -> LeftOut {
    let gone = of_nothing(surface, oriented, sorted);
    let is_gone = |t: &[u32; 3]| gone.binary_search(&corners(t.map(|i| surface.point_of[i as usize]))).is_ok();
    let parts = model.parts.iter().filter(|part| model.triangles[part.triangles.clone()].iter().any(is_gone));
    let at = sorted.nothing.first().map(|&index| 0.5 * (oriented.pieces[index].min + oriented.pieces[index].max));
    LeftOut {
        pieces: sorted.nothing.len(),
        faces: gone.len(),
        parts: parts.map(|part| part.name.clone()).filter(|name| !name.is_empty()).collect(),
        at: at.unwrap_or_default().to_array(),
    }
}

fn without_lost(model: &Model, report: &mut ModelReport) -> Model {
    let usable: Vec<bool> = model.positions.iter().map(|p| p.is_finite() && p.abs().max_element() <= LARGEST).collect();
    let keep = |t: &[u32; 3]| t.iter().all(|&i| usable[i as usize]);
    report.lost_vertices = usable.iter().filter(|&&usable| !usable).count();
    report.lost_faces = model.triangles.iter().filter(|t| !keep(t)).count();
    model.retain(keep)
}

/// Leaves one of faces that are there several times. Faces on the same corners that look opposite ways cancel, unless
/// the whole model is made of such pairs: then it is one surface, drawn from both sides. Where that opens more edges
/// than it closes the faces are those of parts that have a side in common, and all stay.
fn drop_duplicates(surface: &mut Welded, report: &mut ModelReport) {
    let before = surface.faces.len();
    let mut faces = surface.faces.clone();
    let all = std::mem::take(&mut surface.faces);
    let key = |&[a, b, c]: &[u32; 3]| [a, b.min(c), b.max(c)];
    faces.sort_by_key(|face| (key(face), *face));
    let groups = || faces.chunk_by(|a, b| key(a) == key(b));
    let paired = groups().filter(|group| group.first() != group.last()).map(<[_]>::len).sum::<usize>();
    let two_sided = 2 * paired > before;
    for group in groups() {
        let front = group.iter().filter(|face| **face == group[0]).count();
        if two_sided || 2 * front != group.len() {
            let rarer = 2 * front < group.len() && !two_sided;
            surface.faces.push(if rarer { group[group.len() - 1] } else { group[0] });
        }
    }
    surface.faces.sort_unstable();
    let odd = |faces: &[[u32; 3]]| Edges::new(faces).iter().filter(|edge| edge.len() % 2 != 0).count();
    if surface.faces.len() < before && odd(&surface.faces) > odd(&all) {
        surface.faces = all;
    }
    report.duplicate_faces = before - surface.faces.len();
}

/// Welds the two sides of gaps that are too narrow to be meant, if that closes any.
fn close_gaps(surface: &mut Welded, distance: f64, report: &mut ModelReport) {
    let edges = Edges::new(&surface.faces);
    let open = edges.open().count();
    if open == 0 || distance <= 0.0 {
        return;
    }
    let mut loose: Vec<u32> = edges.open().flatten().collect();
    loose.sort_unstable();
    loose.dedup();
    let mut welded = surface.clone();
    let gone = welded.weld_near(&loose, distance);
    if gone > 0 && Edges::new(&welded.faces).open().count() < open {
        *surface = welded;
        report.welded_points = gone;
    }
}

fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(min, max), &p| (min.min(p), max.max(p)))
}

fn signed_volume(points: &[DVec3], faces: &[[u32; 3]], reference: DVec3) -> f64 {
    let volumes = faces.iter().map(|face| {
        let [a, b, c] = face.map(|i| points[i as usize] - reference);
        a.dot(b.cross(c)) / 6.0
    });
    volumes.sum()
}
