//! Elements of a body: those of its scene, and those of a program's own.

use super::drives::drive;
use super::error::BakeError;
use super::note::Note;
use super::slide::{holds, slide_in};
use crate::scene::{self, Body, ElementLaw, ElementMeasure, Scene};
use crate::solver::Element;
use crate::solver::embedding::{Embedder, EmbeddingWeights, TurnWeights};
use crate::solver::forces::element::contract::Local;
use crate::solver::forces::element::{Kind, Law, Measure, MeasuredElement, Structure, check};
use glam::{DQuat, DVec3};

/// Elements of a program's own, over points in a body of a scene.
#[derive(Clone)]
pub struct OwnElements {
    /// Identifier of the body, a fibre solid.
    pub body: String,
    /// What they are called.
    pub id: String,
    /// Points in the model frame [m], which ride on the material; elements name them by their places here. Those that
    /// lie just outside of the particles are moved in.
    pub points: Vec<DVec3>,
    /// What they are driven by; nothing unless given. It may follow a drive that the body shares.
    pub drive: Option<scene::Drive>,
    /// The elements.
    pub elements: Vec<Box<dyn Element>>,
}

impl OwnElements {
    /// Undriven elements over these points of a body [m].
    pub fn new(
        body: impl Into<String>,
        id: impl Into<String>,
        points: impl Into<Vec<DVec3>>,
        elements: Vec<Box<dyn Element>>,
    ) -> Self {
        Self { body: body.into(), id: id.into(), points: points.into(), drive: None, elements }
    }

    /// Driven.
    #[must_use]
    pub fn driven(self, drive: impl Into<scene::Drive>) -> Self {
        Self { drive: Some(drive.into()), ..self }
    }
}

/// Checks that all of some elements have a body to be in.
pub(super) fn have_bodies(own: &[OwnElements], scene: &Scene) -> Result<(), BakeError> {
    let is_there = |of: &OwnElements| scene.bodies.iter().any(|body| body.id == of.body);
    match own.iter().find(|of| !is_there(of)) {
        Some(of) => Err(BakeError::NoBodyOfElements { id: of.id.clone(), body: of.body.clone() }),
        None => Ok(()),
    }
}

/// Where the elements of one body are put, and where it is said what happened.
pub(super) struct Placing<'a> {
    pub(super) body: &'a Body,
    pub(super) embedder: &'a Embedder<'a>,
    /// Pointer to the body.
    pub(super) path: &'a str,
    pub(super) notes: &'a mut Vec<Note>,
}

/// Points as they ride on the particles.
struct Embedded {
    /// Model frame [m].
    places: Vec<DVec3>,
    weights: Vec<EmbeddingWeights>,
    /// Number of those that were moved.
    slid: usize,
}

impl Placing<'_> {
    /// Places the elements of the scene's body, and then those of a program's own that are for it.
    pub(super) fn place(&mut self, own: &[OwnElements]) -> Result<Vec<Structure>, BakeError> {
        let body = self.body;
        let mut placed: Vec<Structure> = (0..body.elements.len()).filter_map(|index| self.element(index)).collect();
        for of in own.iter().filter(|of| of.body == body.id) {
            placed.push(self.own(of)?);
        }
        Ok(placed)
    }

    fn embed(&self, points: impl Iterator<Item = DVec3>) -> Result<Embedded, DVec3> {
        let mut embedded = Embedded { places: Vec::new(), weights: Vec::new(), slid: 0 };
        for point in points {
            let found = self.embedder.is_embedded(point);
            let inside = if found { slide_in(self.embedder, point) } else { None };
            embedded.slid += usize::from(inside.is_some());
            let at = inside.unwrap_or(point);
            let weights =
                self.embedder.vertex_weights(at).filter(|_| found && holds(self.embedder, at)).ok_or(point)?;
            embedded.places.push(at);
            embedded.weights.push(weights);
        }
        Ok(embedded)
    }

    fn note(&mut self, path: &str, warning: bool, text: String) {
        self.notes.push(Note { path: path.to_owned(), text, warning });
    }

    fn element(&mut self, index: usize) -> Option<Structure> {
        let body = self.body;
        let (element, path) = (&body.elements[index], format!("{}/elements/{index}", self.path));
        let points = element.points.iter().map(|&x| DVec3::from_array(x));
        let Embedded { places, weights, slid } = match self.embed(points) {
            Ok(embedded) => embedded,
            Err(at) => {
                let distance = self.embedder.distance(at);
                let text = format!(
                    "the element is left out: its point {:?} m lies outside of the material, {distance:.2e} m from the \
                     nearest particle",
                    at.to_array()
                );
                self.note(&path, true, text);
                return None;
            }
        };
        if slid > 0 {
            let text = format!("{slid} of {} points lay just outside of the particles and were moved in", places.len());
            self.note(&path, false, text);
        }
        let measure = match element.measure {
            ElementMeasure::Length => Measure::Length,
            ElementMeasure::Turn => Measure::Turn,
            ElementMeasure::Area => Measure::Area,
            ElementMeasure::Volume => Measure::Volume,
            ElementMeasure::Dihedral => Measure::Dihedral,
            ElementMeasure::Twist => Measure::Twist((places[1] - places[0]).normalize_or(DVec3::Y)),
        };
        let twists = matches!(measure, Measure::Twist(_));
        let turns: Vec<Option<TurnWeights>> =
            places.iter().map(|&at| if twists { self.embedder.turn_weights(at) } else { None }).collect();
        let rest = measure.value(&Local { points: &places, turns: &[DQuat::IDENTITY; 2] });
        if (twists && turns.contains(&None)) || (rest == 0.0 && !element.measure.is_angle()) {
            let text = "the element is left out: the particles around its points do not tell what it measures";
            self.note(&path, true, text.to_owned());
            return None;
        }
        let of = element.activation.as_ref();
        let drive = of.map(|of| drive(&of.drive, &body.drives));
        let contract =
            of.map_or(0.0, |of| if element.measure.is_angle() { -of.turn_degrees.to_radians() } else { of.contract });
        let driven = drive.as_ref().map_or([1.0; 2], |drive| [drive.least(), drive.greatest()]);
        let measured = MeasuredElement::new((measure, rest), law(element), contract, driven);
        Some(Structure::new(&element.id, weights, turns, [Kind::Measured(measured)]).driven(drive))
    }

    /// Elements of a program's own, tried before they act.
    fn own(&self, of: &OwnElements) -> Result<Structure, BakeError> {
        let refused = |index: Option<usize>, why: String| BakeError::ElementRefused {
            path: self.path.to_owned(),
            element: index.map_or_else(|| of.id.clone(), |index| format!("{}, element {index}", of.id)),
            why,
        };
        let Embedded { places, weights, .. } = self.embed(of.points.iter().copied()).map_err(|at| {
            let nearest = self.embedder.distance(at);
            refused(None, format!("point {:?} m lies {nearest:.2e} m from the nearest particle", at.to_array()))
        })?;
        let mut turns: Vec<Option<TurnWeights>> = vec![None; places.len()];
        let mut drive = of.drive.as_ref().map(|one| drive(one, &self.body.drives));
        for (index, element) in of.elements.iter().enumerate() {
            let mut tried = element.clone();
            if let Some(drive) = &mut drive {
                tried.activate(drive.greatest());
            }
            check(&*tried, &places).map_err(|fault| refused(Some(index), fault.to_string()))?;
            for &name in element.turns() {
                let found = self.embedder.turn_weights(places[name as usize]);
                let why = || format!("the particles around point {name} do not tell how the material is turned");
                turns[name as usize] = Some(found.ok_or_else(|| refused(Some(index), why()))?);
            }
        }
        let elements = of.elements.iter().map(|element| Kind::Custom(element.clone()));
        Ok(Structure::new(&of.id, weights, turns, elements).driven(drive))
    }
}

/// Slopes over x as the solver has it: angles in radians.
fn law(element: &scene::Element) -> Law {
    match &element.law {
        ElementLaw::Spring(of) => Law::Spring(of.stiffness),
        ElementLaw::TensionOnly(of) => Law::TensionOnly(of.stiffness),
        ElementLaw::Muscle(of) => Law::Muscle { force: of.force, width: of.width },
        ElementLaw::Table(points) => {
            let unit = if element.measure.is_angle() { 1f64.to_radians() } else { 1.0 };
            Law::Table(points.iter().map(|&[s, force]| [s * unit, force]).collect())
        }
    }
}
