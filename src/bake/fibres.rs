//! Fibres of a body: from vertices or strokes to structure particles that ride on the material.

use super::drives::drive;
use super::error::BakeError;
use super::note::Note;
use super::slide::{holds, slide_in};
use crate::scene::{Body, Fibre, FibreSource, RestShape};
use crate::sketch::{Placed, SketchError, SketchNote, structure_particles, trim};
use crate::solver::body::FibreLine;
use crate::solver::embedding::{Embedder, EmbeddingWeights};
use crate::solver::forces::fibre::breaking::BreakLimits;
use crate::solver::forces::fibre::{FibreActivation, FibreRest, FibreTwist, Muscle, YieldLimits};
use crate::text::number::four_figures;
use glam::DVec3;
use std::f64::consts::PI;
use std::ops::Range;

/// One run of a fibre inside the material.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedFibre {
    /// Index of the scene's fibre.
    pub fibre: usize,
    /// Identifier of the scene's fibre.
    pub id: String,
    /// Way along the fibre from its first point to the first of these [m].
    pub start: f64,
    /// Structure particles at rest, model frame [m].
    pub vertices: Vec<DVec3>,
    /// Their embedding.
    pub embedding: Vec<EmbeddingWeights>,
    /// Those that carry force; the others are drawn only.
    pub active: Range<usize>,
}

impl PlacedFibre {
    /// Volume fraction at its centre line, and its structure particles that carry force.
    pub(super) fn share(&self, body: &Body) -> (f64, &[DVec3]) {
        (body.fibres[self.fibre].volume_fraction, &self.vertices[self.active.clone()])
    }

    /// Distance [m] of the nearest of its structure particles that carry force, and the way along the fibre to that
    /// [m].
    pub(super) fn nearest(&self, at: DVec3) -> (f64, f64) {
        let (mut nearest, mut along) = ((f64::INFINITY, 0.0), self.start);
        for (k, vertex) in self.vertices.iter().enumerate() {
            along += k.checked_sub(1).map_or(0.0, |before| vertex.distance(self.vertices[before]));
            let distance = vertex.distance_squared(at);
            if self.active.contains(&k) && distance < nearest.0 {
                nearest = (distance, along);
            }
        }
        (nearest.0.sqrt(), nearest.1)
    }

    /// Volume fraction at its centre line where its drive is 0, and where it is 1; none where it stays the same.
    pub(super) fn thickening(&self, body: &Body) -> Option<[f64; 2]> {
        let fibre = &body.fibres[self.fibre];
        Some([fibre.volume_fraction, fibre.activation.as_ref()?.volume_fraction?])
    }

    /// The greatest volume fraction that it ever has at its centre line.
    fn greatest_fraction(&self, body: &Body) -> f64 {
        body.fibres[self.fibre].greatest_fraction(&body.drives)
    }

    pub(super) fn line(&self) -> FibreLine {
        FibreLine { id: self.id.clone(), vertices: self.embedding.clone() }
    }
}

/// Structure particles nearer to each other than this share of the spacing D are warned of.
pub(super) const CROWDED: f64 = 0.75;

/// Turn [degrees] of a fibre at one vertex beyond which its bending energy is only a continuation of the law (below a
/// cosine of -1/2), and as drawn less than a sixteenth of its stiffness is left.
const FOLDED: f64 = 120.5;

/// Turns [degrees] from vertex to vertex from which on a curl and a twist have another meaning.
pub(super) const MOST_CURLED: f64 = 90.0;
const MOST_TWISTED: f64 = 180.0;

/// Where the fibres of one body are put, and where it is said what happened.
pub(super) struct Placing<'a> {
    pub(super) body: &'a Body,
    pub(super) embedder: &'a Embedder<'a>,
    /// Diagonal H of the shape's bounding box [m].
    pub(super) diagonal: f64,
    /// Pointer to the body.
    pub(super) path: &'a str,
    pub(super) notes: &'a mut Vec<Note>,
}

impl Placing<'_> {
    /// Places every fibre of the body; what is trimmed, split, moved or discarded is said in the notes.
    pub(super) fn place(&mut self) -> Vec<PlacedFibre> {
        let mut placed = Vec::new();
        for (k, fibre) in self.body.fibres.iter().enumerate() {
            let path = format!("{}/fibres/{k}", self.path);
            self.warn_if_weak(fibre, &path);
            self.warn_if_it_gives_way(fibre, &path);
            match self.runs(fibre, &path) {
                Ok(runs) => placed.extend(runs.into_iter().filter_map(|run| self.embed(k, run, &path))),
                Err(error) => self.note(&path, true, format!("the fibre is left out: {error}")),
            }
        }
        placed
    }

    fn note(&mut self, path: &str, warning: bool, text: String) {
        self.notes.push(Note { path: path.to_owned(), text, warning });
    }

    /// Structure particles of a fibre, cut to the runs that lie in the material, each with the way along the fibre to
    /// where it begins [m].
    fn runs(&mut self, fibre: &Fibre, path: &str) -> Result<Vec<(f64, Vec<DVec3>)>, SketchError> {
        let material = &self.body.material;
        let particles = match &fibre.source {
            FibreSource::Vertices(vertices) => vertices.iter().map(|&x| DVec3::from_array(x)).collect(),
            FibreSource::Strokes(pair) => {
                let lifted = pair.lifted(self.diagonal)?;
                for note in &lifted.notes {
                    let warning = matches!(note, SketchNote::PoorMatch { .. } | SketchNote::Strays { .. });
                    self.note(path, warning, note.to_string());
                }
                structure_particles(&lifted.curve, material.spacing())?
            }
        };
        let placed: Vec<Placed> = particles
            .into_iter()
            .map(|point| Placed {
                point,
                embedded: self.embedder.is_embedded(point) && self.embedder.vertex_weights(point).is_some(),
                distance: self.embedder.distance(point) / material.support_radius,
            })
            .collect();
        let trimmed = trim(&placed, material.support_radius)?;
        for note in &trimmed.notes {
            self.note(path, true, note.to_string());
        }
        Ok(trimmed.starts.into_iter().zip(trimmed.runs).collect())
    }

    /// Embeds one run: ends too far outside the particles carry no force, inner vertices there slide inwards.
    fn embed(&mut self, fibre: usize, (start, mut vertices): (f64, Vec<DVec3>), path: &str) -> Option<PlacedFibre> {
        let total = vertices.len();
        let holds = |at: DVec3| holds(self.embedder, at);
        // A fibre that runs along the outside all its length has no end worth keeping: all of it slides.
        let first = vertices.iter().position(|&at| holds(at)).unwrap_or(0);
        let last = vertices.iter().rposition(|&at| holds(at)).unwrap_or(total - 1);
        let mut slid = 0;
        for vertex in &mut vertices[first..=last] {
            if let Some(inside) = slide_in(self.embedder, *vertex) {
                *vertex = inside;
                slid += 1;
            }
        }
        if !vertices[first..=last].iter().all(|&at| holds(at)) {
            let text = "discarded: the particles around it are too few to carry it; use smaller ones";
            self.note(path, true, text.to_owned());
            return None;
        }
        let stubs = first + (total - 1 - last);
        if last - first < 2 {
            self.note(path, true, format!("discarded: {stubs} of {total} points lie too far outside; draw it deeper"));
            return None;
        }
        if stubs > 0 {
            let text = format!("{stubs} of {total} points at its ends lie too far outside the material to carry force");
            self.note(path, false, text);
        }
        if slid > 0 {
            let text = format!("{slid} of {total} points lay too far outside the material and were moved into it");
            self.note(path, true, text);
        }
        let spacing = self.body.material.spacing();
        let closest = vertices.windows(2).map(|pair| pair[0].distance(pair[1])).fold(f64::INFINITY, f64::min);
        if closest < CROWDED * spacing {
            let text = format!(
                "its vertices lie as close as {closest:.2e} m, which shrinks the time step; keep them {spacing} m apart"
            );
            self.note(path, true, text);
        }
        self.warn_if_folded(&vertices[first..=last], path);
        let embedding = vertices.iter().map(|&at| self.embedder.vertex_weights(at).unwrap_or_default()).collect();
        let id = self.body.fibres[fibre].id.clone();
        Some(PlacedFibre { fibre, id, start, vertices, embedding, active: first..last + 1 })
    }

    /// Where a fibre turns back on itself, bending has no meaning: as drawn it holds next to nothing, and straight it
    /// is as content to stay folded as to open.
    fn warn_if_folded(&mut self, vertices: &[DVec3], path: &str) {
        let turn = |k: usize| (vertices[k] - vertices[k - 1]).angle_between(vertices[k + 1] - vertices[k]);
        let inner = 1..vertices.len().saturating_sub(1);
        let Some(sharpest) = inner.max_by(|&a, &b| turn(a).total_cmp(&turn(b))) else { return };
        let (turn, at) = (turn(sharpest), vertices[sharpest]);
        if turn > FOLDED.to_radians() {
            let text = format!(
                "the fibre folds back on itself by {:.0} degrees at [{}] m, where it does not resist bending; draw the turn \
                 as a bow of several points, or as two fibres",
                turn.to_degrees(),
                at.to_array().map(four_figures).join(", ")
            );
            self.note(path, true, text);
        }
    }

    /// A fibre softer than the material it displaces weakens the solid and reverses what it is meant to do.
    fn warn_if_weak(&mut self, fibre: &Fibre, path: &str) {
        let material = &self.body.material;
        let (ea, _) = fibre.stiffness.rigidity(material.spacing().powi(3));
        let displaced = material.young_modulus * 0.2 * PI * material.support_radius.powi(2);
        if ea < displaced && fibre.greatest_fraction(&self.body.drives) > 0.0 {
            let contracts = fibre.activation.as_ref().is_some_and(|of| of.contract != 0.0);
            let lost = if contracts { ", and its contraction is lost in it" } else { "" };
            let text = format!(
                "EA = {ea:.3e} N is less than the {displaced:.3e} N of the material that the fibre displaces, so it \
                 weakens the solid{lost}; raise EA or lower the material's Young's modulus"
            );
            self.note(&format!("{path}/stiffness"), true, text);
        }
    }

    /// A muscle pulls less the longer it is: where it loses more than fibre and matrix gain, it gives way.
    fn warn_if_it_gives_way(&mut self, fibre: &Fibre, path: &str) {
        let Some((of, muscle)) = fibre.activation.as_ref().and_then(|of| Some((of, of.muscle.as_ref()?))) else {
            return;
        };
        let material = &self.body.material;
        let share = fibre.greatest_fraction(&self.body.drives);
        let loses = 2.0 * share * muscle.force * drive(&of.drive, &self.body.drives).greatest() / muscle.width;
        let (ea, _) = fibre.stiffness.rigidity(material.spacing().powi(3));
        let gains = share * ea + material.young_modulus * PI * material.support_radius.powi(2);
        if loses > gains {
            let text = format!(
                "stretched to the end of its width it pulls as if by -{loses:.3e} N for its length, where the fibre and the \
                 material in its reach hold {gains:.3e} N against that: it may give way all at once; lower the force, or \
                 raise the width or EA"
            );
            self.note(&format!("{path}/activation/muscle"), true, text);
        }
    }
}

/// Rods of the placed fibres that carry anything.
pub(super) fn rods(
    body: &Body,
    embedder: &Embedder<'_>,
    particle_volume: f64,
    placed: &[PlacedFibre],
    path: &str,
) -> Result<Vec<FibreRest>, BakeError> {
    let carrying = placed.iter().enumerate().filter(|(_, run)| carries(body, run));
    carrying
        .map(|(line, run)| {
            let fibre = &body.fibres[run.fibre];
            let (ea, ei) = fibre.stiffness.rigidity(particle_volume);
            let vertices = &run.vertices[run.active.clone()];
            let curls = fibre.activation.as_ref().is_some_and(|activation| activation.curl.is_some());
            let bends_for_good = fibre.yields.as_ref().is_some_and(|past| past.curvature_degrees_per_metre.is_some());
            let inner = vertices.get(1..vertices.len().saturating_sub(1)).unwrap_or_default();
            let turns = inner
                .iter()
                .map(|&at| match fibre.rest_shape {
                    RestShape::Straight if !curls && !bends_for_good => None,
                    _ => embedder.turn_weights(at),
                })
                .collect();
            let share = run.greatest_fraction(body);
            let mut rest = FibreRest::new(run.embedding[run.active.clone()].to_vec(), vertices, ea, ei, share, turns);
            if fibre.rest_shape == RestShape::Straight {
                rest = rest.straightened();
            }
            let activation = activation(body, run, &format!("{path}/fibres/{}/activation", run.fibre))?;
            Ok(rest
                .twisting(twist((fibre, share), embedder, vertices))
                .on_line(line as u32, run.active.start as u32)
                .breaking(limits(fibre))
                .yielding(yield_limits(fibre))
                .acting(activation))
        })
        .collect()
}

/// What drives do to a run of a fibre whose activation has this pointer.
fn activation(body: &Body, run: &PlacedFibre, path: &str) -> Result<Option<FibreActivation>, BakeError> {
    let fibre = &body.fibres[run.fibre];
    let Some(of) = &fibre.activation else { return Ok(None) };
    let vertices = &run.vertices[run.active.clone()];
    let length_of =
        |points: &[DVec3]| -> Vec<f64> { points.windows(2).map(|edge| edge[0].distance(edge[1])).collect() };
    let lengths = length_of(vertices);
    let start = run.start + length_of(&run.vertices[..=run.active.start]).iter().sum::<f64>();
    let drive = drive(&of.drive, &body.drives);
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    let share = run.greatest_fraction(body);
    let thickness = run.thickening(body).map(|fractions| fractions.map(|fraction| fraction / share));
    let mut activation = FibreActivation::new(&drive, start, vertices).contracting(of.contract).thickening(thickness);
    if let Some(curl) = &of.curl {
        let longest = lengths.windows(2).map(|edges| 0.5 * (edges[0] + edges[1])).fold(0.0, f64::max);
        within_reach(curl.degrees_per_metre, MOST_CURLED, drive.largest(), longest, &format!("{path}/curl"))?;
        let axis = DVec3::from_array(curl.axis).normalize_or(DVec3::Z);
        activation = activation.curling(curl.degrees_per_metre.to_radians(), axis, &lengths);
    }
    if let Some(muscle) = &of.muscle {
        activation = activation.pulling(Muscle::new(share * muscle.force, muscle.width));
    }
    if let Some(twist) = &of.twist {
        within_reach(twist.degrees_per_metre, MOST_TWISTED, drive.largest(), longest, &format!("{path}/twist"))?;
        activation = activation.twisting(twist.degrees_per_metre.to_radians(), &lengths);
    }
    Ok(Some(activation))
}

/// Checks that a turn per length [degrees/m] times the largest value of its drive stays below `most` [degrees] from
/// vertex to vertex, which are `longest` [m] apart at most; `path` is the pointer to what it is of.
fn within_reach(rate: f64, most: f64, largest: f64, longest: f64, path: &str) -> Result<(), BakeError> {
    let degrees = rate.abs() * largest * longest;
    if degrees < most {
        return Ok(());
    }
    let path = format!("{path}/degrees_per_metre");
    Err(BakeError::TurnsTooFar { path, rate, largest, longest, degrees, most })
}

/// How the part of a fibre of this volume fraction that runs through these vertices resists twist; not at all where the
/// turn of the material cannot be read.
fn twist((fibre, share): (&Fibre, f64), embedder: &Embedder<'_>, vertices: &[DVec3]) -> Option<FibreTwist> {
    let gj = share * fibre.stiffness.twisting();
    if gj == 0.0 {
        return None;
    }
    let turns: Option<Vec<_>> = vertices.iter().map(|&at| embedder.turn_weights(at)).collect();
    Some(FibreTwist::new(turns?, vertices, gj))
}

fn limits(fibre: &Fibre) -> BreakLimits {
    let past = fibre.break_past.as_ref();
    BreakLimits {
        angle: past.and_then(|past| past.angle).map_or(f64::INFINITY, f64::to_radians),
        tension: past.and_then(|past| past.tension).unwrap_or(f64::INFINITY),
    }
}

fn yield_limits(fibre: &Fibre) -> YieldLimits {
    let past = fibre.yields.as_ref();
    YieldLimits {
        tension: past.and_then(|past| past.tension).unwrap_or(f64::INFINITY),
        curvature: past.and_then(|past| past.curvature_degrees_per_metre).map_or(f64::INFINITY, f64::to_radians),
    }
}

/// Index in the scene of the fibre whose rods resist a move of a structure particle most; none without rods.
pub(super) fn strongest(body: &Body, placed: &[PlacedFibre], rods: &[FibreRest]) -> Option<usize> {
    let carrying = placed.iter().filter(|run| carries(body, run));
    carrying.zip(rods).max_by(|(_, a), (_, b)| a.stiffest().total_cmp(&b.stiffest())).map(|(run, _)| run.fibre)
}

/// A fibre that never has a volume fraction carries nothing and is left out, to the bit.
fn carries(body: &Body, run: &PlacedFibre) -> bool {
    run.greatest_fraction(body) > 0.0
}
