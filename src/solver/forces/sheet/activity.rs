//! The work that drives do on sheets.
//!
//! A step's is half of what the change of the drive adds to the energy where it begins, and half where it ends: second
//! order.

use super::hinge::{HingeRest, hinge_angle, unwound};
use super::rest::SheetRest;
use glam::DVec3;

/// What the drives of a body's sheets have done.
#[derive(Clone, Debug, Default)]
pub(super) struct Activity {
    /// Work up to the last booking [J].
    pub(super) work: f64,
    booked: Option<Booked>,
}

#[derive(Clone, Debug)]
struct Booked {
    /// [s]
    time: f64,
    sheets: Vec<Shape>,
}

/// A sheet that acts, at one time.
#[derive(Clone, Debug)]
struct Shape {
    /// Its vertices [m].
    places: Vec<DVec3>,
    /// Angles of its hinges [rad].
    angles: Vec<f64>,
}

impl Booked {
    fn now(sheets: &[SheetRest], last: &[f64], time: f64, positions: &[DVec3]) -> Self {
        let mut first = 0;
        let mut shapes = Vec::new();
        for sheet in sheets {
            let last = &last[first..first + sheet.hinges.len()];
            first += sheet.hinges.len();
            if sheet.drive.is_some() {
                let places = sheet.places(positions);
                let angle = |(of, &last): (&HingeRest, &f64)| {
                    unwound(hinge_angle(of.vertices.map(|k| places[k as usize])), last)
                };
                let angles = sheet.hinges.iter().zip(last).map(angle).collect();
                shapes.push(Shape { places, angles });
            }
        }
        Self { time, sheets: shapes }
    }
}

impl Activity {
    /// Takes note of where the booking begins, unless it has begun; `last` are the angles of all hinges at the last
    /// look.
    pub(super) fn begin(&mut self, sheets: &[SheetRest], last: &[f64], time: f64, positions: &[DVec3]) {
        self.booked.get_or_insert_with(|| Booked::now(sheets, last, time, positions));
    }

    /// Books the work of the step that ended at a time [s].
    pub(super) fn book(&mut self, sheets: &[SheetRest], last: &[f64], time: f64, positions: &[DVec3]) {
        let now = Booked::now(sheets, last, time, positions);
        if let Some(before) = &self.booked {
            let acting = sheets.iter().filter(|sheet| sheet.drive.is_some());
            for (sheet, (was, is)) in acting.zip(before.sheets.iter().zip(&now.sheets)) {
                let more = |shape: &Shape| energy(sheet, shape, time) - energy(sheet, shape, before.time);
                self.work += 0.5 * (more(was) + more(is));
            }
        }
        self.booked = Some(now);
    }

    /// Begins to book anew, from wherever the body is next, and goes on with the work of what stood here before.
    pub(super) fn adopt(&mut self, before: Option<&Self>) {
        *self = Self { work: before.map_or(0.0, |before| before.work), booked: None };
    }

    /// Memory of the lists [bytes].
    pub(super) fn bytes(&self) -> usize {
        let bytes = |shape: &Shape| size_of_val(&*shape.places) + size_of_val(&*shape.angles);
        self.booked.as_ref().map_or(0, |booked| booked.sheets.iter().map(bytes).sum())
    }
}

/// Energy [J] of a sheet of this shape as its drive has it at a time [s].
fn energy(sheet: &SheetRest, shape: &Shape, time: f64) -> f64 {
    let curvature = sheet.curvature(time);
    let hinges = sheet.hinges.iter().zip(&shape.angles).map(|(of, &angle)| of.energy(angle, curvature));
    sheet.membrane_energy(&shape.places, sheet.metric(time)) + hinges.sum::<f64>()
}
