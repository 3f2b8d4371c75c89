//! Elements over the same points, as they ride on a body's particles.

use super::contract::{Element, Local, MOST_POINTS, Slopes};
use super::kind::Kind;
use crate::solver::body::ElementLines;
use crate::solver::drive::Drive;
use crate::solver::embedding::{EmbeddingWeights, TurnWeights};
use crate::solver::forces::fibre::material_turn::turn_of_material;
use crate::solver::rotation::turn_stiffness;
use glam::{DMat3, DQuat, DVec3};

/// Elements over the same points.
#[derive(Clone)]
pub(crate) struct Structure {
    /// Identifier of the scene, or of who made it.
    pub(crate) id: String,
    /// How its points ride on the particles.
    pub(crate) points: Vec<EmbeddingWeights>,
    /// How the turn of the material is read at those where some element reads it.
    pub(crate) turns: Vec<Option<TurnWeights>>,
    /// The elements, and whether each still holds.
    pub(super) elements: Vec<(Kind, bool)>,
    /// What drives them, if anything does.
    pub(crate) drive: Option<Drive>,
}

/// The points of a structure at one time.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    points: Vec<DVec3>,
    turns: Vec<DQuat>,
    /// Rotations and stretches of the material, where its turn is read.
    material: Vec<Option<(DMat3, DMat3)>>,
}

/// The points of one element at one time.
pub(super) struct OfElement {
    points: [DVec3; MOST_POINTS],
    turns: [DQuat; MOST_POINTS],
    counts: [usize; 2],
}

impl OfElement {
    /// As the element is given it.
    pub(super) fn local(&self) -> Local<'_> {
        let [points, turns] = self.counts;
        Local { points: &self.points[..points], turns: &self.turns[..turns] }
    }
}

impl Structure {
    /// Elements over points with these stencils; `turns` where some element reads the turn of the material.
    pub(crate) fn new(
        id: impl Into<String>,
        points: Vec<EmbeddingWeights>,
        turns: Vec<Option<TurnWeights>>,
        elements: impl IntoIterator<Item = Kind>,
    ) -> Self {
        let elements = elements.into_iter().map(|kind| (kind, true)).collect();
        Self { id: id.into(), points, turns, elements, drive: None }
    }

    /// Driven.
    pub(crate) fn driven(self, drive: Option<Drive>) -> Self {
        Self { drive, ..self }
    }

    /// Where its points are among particles at `positions` [m]; `warm` are the last turns of the material around each.
    pub(super) fn places(&self, positions: &[DVec3], warm: &[DQuat]) -> Places {
        let mut turns = warm.to_vec();
        let found = self.turns.iter().zip(&mut turns);
        let found = found.map(|(turn, warm)| turn.as_ref().map(|turn| turn_of_material(turn, positions, warm)));
        let material = found.collect();
        // Weights sum to one: taken against one particle, a point stays exact far from the origin.
        let points = self.points.iter().map(|point| point.gather(positions)).collect();
        Places { points, turns, material }
    }

    /// Follows its drive.
    pub(super) fn follow(&mut self, time: f64) {
        if let Some(drive) = &self.drive {
            let (value, _) = drive.at(time);
            self.elements.iter_mut().for_each(|(kind, _)| kind.activate(value));
        }
    }

    /// Energy [J].
    pub(super) fn energy(&self, at: &Places) -> f64 {
        self.whole().map(|kind| kind.energy(&at.of(kind.element()).local())).sum()
    }

    fn whole(&self) -> impl Iterator<Item = &Kind> {
        self.elements.iter().filter(|(_, holds)| *holds).map(|(kind, _)| kind)
    }

    /// Adds the forces [N] on particles.
    pub(super) fn add_forces(&self, at: &Places, forces: &mut [DVec3]) {
        let mut by_point = vec![DVec3::ZERO; self.points.len()];
        let mut by_turn = vec![DVec3::ZERO; self.points.len()];
        for kind in self.whole() {
            let (mut points, mut turns) = ([DVec3::ZERO; MOST_POINTS], [DVec3::ZERO; MOST_POINTS]);
            let (names, turned) = (kind.points(), kind.turns());
            let mut slopes = Slopes { points: &mut points[..names.len()], turns: &mut turns[..turned.len()] };
            kind.slopes(&at.of(kind.element()).local(), &mut slopes);
            names.iter().zip(points).for_each(|(&k, slope)| by_point[k as usize] += slope);
            turned.iter().zip(turns).for_each(|(&k, slope)| by_turn[k as usize] += slope);
        }
        for (point, slope) in self.points.iter().zip(by_point) {
            if slope != DVec3::ZERO {
                point.scatter(-slope, forces);
            }
        }
        for ((turn, material), moment) in self.turns.iter().zip(&at.material).zip(by_turn) {
            if let (Some(turn), Some((r, stretch))) = (turn, material) {
                let p = turn_stiffness(*stretch).inverse() * moment;
                for &(particle, z) in &turn.weights {
                    forces[particle as usize] -= *r * p.cross(z);
                }
            }
        }
    }

    /// Groups of particles that are tied to each other: those around every element.
    pub(super) fn couplings(&self) -> impl Iterator<Item = Vec<u32>> + '_ {
        self.elements.iter().map(|(kind, _)| {
            let points = kind.points().iter().flat_map(|&k| self.points[k as usize].weights.iter().map(|&(p, _)| p));
            let turns = kind.turns().iter().filter_map(|&k| self.turns[k as usize].as_ref());
            points.chain(turns.flat_map(|turn| turn.weights.iter().map(|&(p, _)| p))).collect()
        })
    }

    /// The same with elements that resist any move as much as these ever do, its drive at its greatest or its least.
    pub(super) fn at_extreme(&self, greatest: bool, at: &Places) -> Self {
        let drive = self.drive.as_ref();
        let value = drive.map(|drive| if greatest { drive.greatest() } else { drive.least() });
        let stiffest = |(kind, holds): &(Kind, bool)| {
            let mut kind = kind.clone();
            if let Some(value) = value {
                kind.activate(value);
            }
            (kind.stiffest(&at.of(kind.element()).local()), *holds)
        };
        let elements = self.elements.iter().map(stiffest).collect();
        Self { elements, drive: None, ..self.clone() }
    }

    /// What is drawn of it.
    pub(crate) fn drawn(&self) -> ElementLines {
        let lines = self.elements.iter().flat_map(|(kind, _)| kind.lines()).collect();
        ElementLines { id: self.id.clone(), points: self.points.clone(), lines }
    }
}

impl Places {
    /// The points of an element and the turns that it reads.
    pub(super) fn of(&self, element: &dyn Element) -> OfElement {
        let (names, turned) = (element.points(), element.turns());
        let mut of = OfElement {
            points: [DVec3::ZERO; MOST_POINTS],
            turns: [DQuat::IDENTITY; MOST_POINTS],
            counts: [names.len(), turned.len()],
        };
        of.points.iter_mut().zip(names).for_each(|(at, &k)| *at = self.points[k as usize]);
        of.turns.iter_mut().zip(turned).for_each(|(at, &k)| *at = self.turns[k as usize]);
        of
    }

    /// The turns of the material around all points.
    pub(super) fn turns(&self) -> &[DQuat] {
        &self.turns
    }

    /// Memory of the lists [bytes].
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.points) + size_of_val(&*self.turns) + size_of_val(&*self.material)
    }
}
