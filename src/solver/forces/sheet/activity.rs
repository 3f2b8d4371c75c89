//! The work that drives do on sheets.
//!
//! A step's is half of what the change of the drive adds to the energy where it begins, and half where it ends: second order.

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
    /// Vertices of the sheets that act [m].
    places: Vec<Vec<DVec3>>,
}

impl Booked {
    fn now(sheets: &[SheetRest], time: f64, positions: &[DVec3]) -> Self {
        Self { time, places: acting(sheets).map(|sheet| sheet.places(positions)).collect() }
    }
}

fn acting(sheets: &[SheetRest]) -> impl Iterator<Item = &SheetRest> {
    sheets.iter().filter(|sheet| sheet.drive.is_some())
}

impl Activity {
    /// Takes note of where the booking begins, unless it has begun.
    pub(super) fn begin(&mut self, sheets: &[SheetRest], time: f64, positions: &[DVec3]) {
        self.booked.get_or_insert_with(|| Booked::now(sheets, time, positions));
    }

    /// Books the work of the step that ended at a time [s].
    pub(super) fn book(&mut self, sheets: &[SheetRest], time: f64, positions: &[DVec3]) {
        let now = Booked::now(sheets, time, positions);
        if let Some(before) = &self.booked {
            for (k, sheet) in acting(sheets).enumerate() {
                let (was, is) = (sheet.metric(before.time), sheet.metric(time));
                if was != is {
                    let more = |x: &[DVec3]| sheet.membrane_energy(x, is) - sheet.membrane_energy(x, was);
                    self.work += 0.5 * (more(&before.places[k]) + more(&now.places[k]));
                }
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
        self.booked.as_ref().map_or(0, |booked| booked.places.iter().map(|places| size_of_val(&**places)).sum())
    }
}
