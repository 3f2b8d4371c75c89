//! The force of all sheets of a body.

use super::activity::Activity;
use super::hinge::{hinge_angle, hinge_slopes, unwound};
use super::rest::SheetRest;
use crate::solver::energy::Energies;
use crate::solver::forces::force::Force;
use crate::solver::state::ParticleState;
use glam::DVec3;
use std::sync::Arc;

/// Stretching and bending of all sheets of a body.
#[derive(Clone)]
pub struct SheetForce {
    sheets: Arc<[SheetRest]>,
    /// Last angle of every hinge [rad], sheet after sheet: the next is the one nearest to it, so that a sheet may fold
    /// through half a turn.
    angles: Vec<f64>,
    activity: Activity,
}

impl SheetForce {
    /// The force of these sheets.
    pub fn new(sheets: Arc<[SheetRest]>) -> Self {
        let angles = sheets.iter().flat_map(|sheet| &sheet.hinges).map(|hinge| hinge.angle).collect();
        Self { sheets, angles, activity: Activity::default() }
    }

    /// Whether any of them is driven.
    pub(crate) fn is_driven(&self) -> bool {
        self.sheets.iter().any(|sheet| sheet.drive.is_some())
    }
}

impl Force for SheetForce {
    fn add_forces(&mut self, time: f64, state: &ParticleState, forces: &mut [DVec3]) {
        let positions = &state.positions;
        if self.is_driven() {
            self.activity.begin(&self.sheets, &self.angles, time, positions);
        }
        let mut angles = self.angles.iter_mut();
        for sheet in self.sheets.iter() {
            let x = sheet.places(positions);
            let mut slopes = vec![DVec3::ZERO; x.len()];
            let (metric, curvature) = (sheet.metric(time), sheet.curvature(time));
            for of in &sheet.triangles {
                let [a, b, c] = of.vertices.map(|k| k as usize);
                let [second, third] = of.slopes(&sheet.membrane, [x[a], x[b], x[c]], metric);
                slopes[a] -= second + third;
                slopes[b] += second;
                slopes[c] += third;
            }
            for (of, last) in sheet.hinges.iter().zip(angles.by_ref()) {
                let corners = of.vertices.map(|k| x[k as usize]);
                *last = unwound(hinge_angle(corners), *last);
                let moment = of.stiffness * (*last - of.angle - of.curl.dot(curvature));
                let Some(by) = hinge_slopes(corners).filter(|_| moment != 0.0) else { continue };
                for (k, slope) in of.vertices.into_iter().zip(by) {
                    slopes[k as usize] += moment * slope;
                }
            }
            for (vertex, slope) in sheet.vertices.iter().zip(slopes) {
                vertex.scatter(-slope, forces);
            }
        }
    }

    fn add_energy(&self, time: f64, state: &ParticleState, energies: &mut Energies) {
        energies.activation -= self.activity.work;
        let mut angles = self.angles.iter();
        for sheet in self.sheets.iter() {
            let x = sheet.places(&state.positions);
            energies.membrane += sheet.membrane_energy(&x, sheet.metric(time));
            let curvature = sheet.curvature(time);
            for (of, &last) in sheet.hinges.iter().zip(angles.by_ref()) {
                let angle = unwound(hinge_angle(of.vertices.map(|k| x[k as usize])), last);
                energies.hinges += of.energy(angle, curvature);
            }
        }
    }

    fn is_internal(&self) -> bool {
        true
    }

    fn couplings(&self) -> Vec<Vec<u32>> {
        self.sheets.iter().flat_map(SheetRest::couplings).collect()
    }

    fn changes_until(&self) -> f64 {
        self.sheets.iter().map(SheetRest::changes_until).fold(0.0, f64::max)
    }

    fn driven_until(&self) -> f64 {
        self.changes_until()
    }

    fn drive_work(&self) -> f64 {
        self.activity.work
    }

    fn end_step(&mut self, time: f64, state: &ParticleState) -> bool {
        if self.is_driven() {
            self.activity.book(&self.sheets, &self.angles, time, &state.positions);
        }
        false
    }

    fn adopt(&mut self, before: &[Box<dyn Force>]) {
        let before = before.iter().find_map(|force| force.downcast_ref::<Self>());
        self.activity.adopt(before.map(|before| &before.activity));
        // Sheets that lie where they lay are folded as they were.
        if let Some(before) = before {
            let mut first = 0;
            for sheet in self.sheets.iter() {
                let mut old_first = 0;
                for old in before.sheets.iter() {
                    let same = old.vertices == sheet.vertices && old.hinges.len() == sheet.hinges.len();
                    if same {
                        let count = sheet.hinges.len();
                        self.angles[first..first + count].copy_from_slice(&before.angles[old_first..old_first + count]);
                    }
                    old_first += old.hinges.len();
                }
                first += sheet.hinges.len();
            }
        }
    }

    fn remembered(&self, number: &mut dyn FnMut(f64)) {
        self.angles.iter().copied().for_each(number);
    }

    fn name(&self) -> &'static str {
        "sheets"
    }

    fn bytes(&self) -> usize {
        size_of_val(self) + size_of_val(&*self.angles) + self.activity.bytes()
    }

    fn clone_at_extreme(&self, greatest: bool) -> Box<dyn Force> {
        let sheets = self.sheets.iter().map(|sheet| sheet.at_extreme(greatest)).collect();
        Box::new(Self { sheets, ..self.clone() })
    }

    fn clone_box(&self) -> Box<dyn Force> {
        Box::new(self.clone())
    }
}
