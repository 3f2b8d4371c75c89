//! A model made ready to be filled: checked, repaired where that is possible, and asked what is inside.

use super::bvh::Bvh;
use super::crossing::crossing_pairs;
use super::edges::{Edges, count_loops};
use super::model::Model;
use super::model_report::{ModelReport, Refusal};
use super::orient::{area, orientation};
use super::scanline::{OpenScanline, inside_stretches, open_scanline};
use super::weld::Welded;
use super::winding::{Far, Winding, far_fields};
use glam::DVec3;
use rayon::prelude::*;

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
    bvh: Bvh,
    /// Far fields of the tree's nodes; none for a closed surface, which needs none.
    far: Vec<Far>,
}

/// Coordinates beyond this are taken for damage [m]: their cubes, and sums of those, must stay far from the greatest
/// number.
const LARGEST: f64 = 1e9;

/// Open edges closer than this share of the diagonal are gaps that were never meant.
const GAP: f64 = 1e-5;

/// Volume below this share of what a surface could enclose counts as none.
const NO_VOLUME: f64 = 1e-9;

/// Rows along each axis where the volume is counted instead of computed: of a surface with holes, and of one whose
/// pieces overlap.
const SAMPLES: usize = 48;
const FINE_SAMPLES: usize = 384;

/// Steps along the diagonal in which the rows through a surface with holes are looked at.
const LOOKS: f64 = 24.0;

/// Share of doubtful points from which on an open surface is refused.
const TOO_DOUBTFUL: f64 = 0.2;

impl Solid {
    /// Checks a model whose positions are in metres, repairs what it can and measures what is inside.
    ///
    /// # Errors
    /// [`Refusal`] where nothing can be filled.
    pub fn new(model: &Model) -> Result<Self, Refusal> {
        let mut report = ModelReport { reading: model.notes.clone(), ..ModelReport::default() };
        let model = without_lost(model, &mut report);
        if model.triangles.is_empty() {
            return Err(Refusal::NoFaces { lost_faces: report.lost_faces });
        }
        let mut surface = Welded::new(&model);
        drop_duplicates(&mut surface, &mut report);
        let (min, max) = bounds(&surface.points);
        close_gaps(&mut surface, GAP * (max - min).length(), &mut report);

        let edges = Edges::new(&surface.faces);
        let oriented = orientation(&surface.points, &surface.faces, &edges);
        let open: Vec<_> = edges.open().collect();
        report.open_edges = open.len();
        report.holes = count_loops(&open);
        report.crowded_edges = edges.crowded();
        report.closed = !surface.faces.is_empty() && edges.unbalanced(&oriented.flipped) == 0;
        for (face, &flipped) in surface.faces.iter_mut().zip(&oriented.flipped) {
            if flipped {
                // The first stays the least.
                face.swap(1, 2);
            }
        }
        report.turned_faces = oriented.disagreeing;
        report.twisted_edges = oriented.twisted;
        report.pieces = oriented.pieces;
        report.inverted_pieces = oriented.inverted;
        report.cavities = oriented.cavities;
        report.nested_pieces = oriented.nested;

        let bvh = Bvh::new(&surface.points, &surface.faces);
        report.crossings = crossing_pairs(&surface.points, &surface.faces, &bvh);
        report.flat_faces = surface.faces.par_iter().filter(|&&face| area(&surface.points, face) == 0.0).count();
        report.vertices = model.positions.len();
        report.points = surface.points.len();
        report.faces = surface.faces.len();
        report.collapsed_faces = surface.collapsed;
        let far = if report.closed { Vec::new() } else { far_fields(&surface.points, &surface.faces, &bvh) };
        let mut this = Self { model, surface, report, min, max, volume: 0.0, bvh, far };
        this.measure()?;
        Ok(this)
    }

    /// Stretches of the row through (y, z) along x that lie inside [m].
    pub(crate) fn scanline(&self, y: f64, z: f64) -> Vec<[f64; 2]> {
        if self.report.closed {
            inside_stretches(&self.surface.points, &self.surface.faces, &self.bvh, y, z)
        } else {
            self.open_scanline(y, z).inside
        }
    }

    fn open_scanline(&self, y: f64, z: f64) -> OpenScanline {
        let surface = (self.surface.points.as_slice(), self.surface.faces.as_slice(), &self.bvh);
        let step = self.size().length() / LOOKS;
        open_scanline(surface, &self.winding(), [self.min.x, self.max.x], step, [y, z])
    }

    /// Queries of the winding number of a surface with holes. That of a closed surface follows from its rows.
    fn winding(&self) -> Winding<'_> {
        Winding::new(&self.surface.points, &self.surface.faces, &self.bvh, &self.far)
    }

    /// Whether a point lies inside.
    pub fn contains(&self, point: DVec3) -> bool {
        self.scanline(point.y, point.z).iter().any(|[from, to]| (*from..=*to).contains(&point.x))
    }

    /// Extents [m].
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    fn measure(&mut self) -> Result<(), Refusal> {
        let ModelReport { open_edges, holes, .. } = self.report;
        let diagonal = self.size().length();
        if !self.report.closed {
            let [volume, doubtful] = self.count_rows(SAMPLES, |y, z| {
                let row = self.open_scanline(y, z);
                [row.inside.iter().map(|[from, to]| to - from).sum(), row.doubtful]
            });
            let doubtful = if volume > 0.0 { doubtful / volume } else { 1.0 };
            (self.volume, self.report.doubtful) = (volume, doubtful);
            if volume > 0.0 && doubtful > TOO_DOUBTFUL {
                return Err(Refusal::TooOpen { open_edges, holes, doubtful });
            }
        } else if self.report.crossings + self.report.nested_pieces + self.report.crowded_edges > 0 {
            let length = |y, z| [self.scanline(y, z).iter().map(|[from, to]| to - from).sum(), 0.0];
            [self.volume, _] = self.count_rows(FINE_SAMPLES, length);
        } else {
            self.volume = signed_volume(&self.surface, self.min);
        }
        if self.volume > NO_VOLUME * diagonal.powi(3) {
            return Ok(());
        }
        Err(Refusal::NothingInside { open_edges, holes })
    }

    /// Volumes by two lengths of each of many rows.
    fn count_rows(&self, count: usize, lengths: impl Fn(f64, f64) -> [f64; 2] + Sync) -> [f64; 2] {
        let size = self.size();
        let step = [size.y / count as f64, size.z / count as f64];
        let lengths: Vec<[f64; 2]> = (0..count * count)
            .into_par_iter()
            .map(|k| {
                let y = self.min.y + step[0] * ((k % count) as f64 + 0.5);
                let z = self.min.z + step[1] * ((k / count) as f64 + 0.5);
                lengths(y, z)
            })
            .collect();
        let sum = lengths.iter().fold([0.0, 0.0], |sum, row| [sum[0] + row[0], sum[1] + row[1]]);
        sum.map(|sum| sum * step[0] * step[1])
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
/// the whole model is made of such pairs: then it is one surface, drawn from both sides.
fn drop_duplicates(surface: &mut Welded, report: &mut ModelReport) {
    let before = surface.faces.len();
    let mut faces = std::mem::take(&mut surface.faces);
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

fn signed_volume(surface: &Welded, reference: DVec3) -> f64 {
    let volumes = surface.faces.iter().map(|face| {
        let [a, b, c] = face.map(|i| surface.points[i as usize] - reference);
        a.dot(b.cross(c)) / 6.0
    });
    volumes.sum()
}
