//! Sheets element by element.

use super::elements::{Hinge, Triangle};
use super::rest::SheetRest;
use crate::solver::forces::element::{ElementForce, Kind, Structure};
use glam::{DQuat, DVec2, DVec3};

impl ElementForce {
    /// The elements of undriven sheets over particles that start at `positions` [m]: what [`super::SheetForce`] is held
    /// against.
    pub fn of_sheets(sheets: &[SheetRest], positions: &[DVec3]) -> Self {
        let structure = |sheet: &SheetRest| {
            let triangle = |rest: &_| {
                let (law, contract) = (sheet.membrane, DVec2::ZERO);
                Kind::Triangle(Triangle { rest: *rest, law, contract, metric: DVec2::ONE })
            };
            let hinge = |rest: &super::hinge::HingeRest| {
                Kind::Hinge(Hinge { rest: *rest, curl: DVec2::ZERO, curvature: DVec2::ZERO, last: rest.angle })
            };
            let elements = sheet.triangles.iter().map(triangle).chain(sheet.hinges.iter().map(hinge));
            Structure::new("", sheet.vertices.clone(), vec![None; sheet.vertices.len()], elements)
        };
        Self::new(sheets.iter().map(structure).collect(), positions, DQuat::IDENTITY)
    }
}
