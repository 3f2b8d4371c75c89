//! What hands played on shared drives, as keys that play it again.

use super::journal::{Asked, Journal, JournalEntry};
use crate::bake::solver_drive;
use crate::scene::{Drive, DriveKeys, Interpolation};
use crate::solver::hand::LATE;

/// A hand on a drive, from where it took it.
struct Hold {
    /// Times [s] and values, between which it went evenly.
    keys: Vec<(f64, f64)>,
    /// In which time the drive went back to itself from there [s], once it was let go.
    back_in: Option<f64>,
}

impl Journal {
    /// A shared drive of a body with what hands played on it as keys on top, by which the motion from the start on is
    /// the same again, to the bit; none where nothing was played on it. The frames of the scene that the motion started
    /// from are counted.
    pub fn performed(&self, body: usize, id: &str, drive: &Drive) -> Option<Drive> {
        let [least, greatest] = solver_drive(drive, &[]).in_hand();
        let mut drive = drive.clone();
        let mut hold: Option<Hold> = None;
        let mut was_performed = false;
        for JournalEntry { frame, what } in &self.asked {
            let Asked::Lead { body: of, drive: led, aim } = what else { continue };
            if (*of, led.as_str()) != (body, id) || (hold.is_none() && aim.is_none()) {
                continue;
            }
            let seconds = self.scene.time.frame_seconds();
            let [start, end] = [*frame as f64 * seconds + LATE * seconds, (frame + 1) as f64 * seconds];
            let own = solver_drive(&drive, &[]);
            let held = hold.get_or_insert_with(|| Hold { keys: vec![(start, own.at(start).0)], back_in: None });
            if let Some(&(time, value)) = held.keys.last()
                && time < start
            {
                held.keys.push((start, value));
            }
            was_performed = true;
            match aim {
                Some(aim) => held.keys.push((end, aim.clamp(least, greatest))),
                None => held.back_in = Some(end - start),
            }
            if aim.is_none()
                && let Some(done) = hold.take()
            {
                drive = on_top(done, &drive);
            }
        }
        if let Some(held) = hold {
            drive = on_top(held, &drive);
        }
        was_performed.then_some(drive)
    }
}

/// What a hand played on top of a drive.
fn on_top(Hold { keys, back_in }: Hold, drive: &Drive) -> Drive {
    let first = keys.first().map_or(0.0, |key| key.0);
    let keys = DriveKeys { between: Interpolation::Linear, ..DriveKeys::new(keys) };
    match beneath(drive, first, back_in.is_some()) {
        // The first key says as much.
        Drive::Constant(_) if back_in.is_none() => keys.into(),
        own => keys.over(own.clone(), back_in).into(),
    }
}

/// What is still seen of a drive under keys from a time on [s].
fn beneath(drive: &Drive, first: f64, goes_back: bool) -> &Drive {
    match drive {
        Drive::Keyframes(DriveKeys { keys, otherwise: Some(otherwise), .. })
            if !goes_back && keys.first().is_some_and(|key| key.time >= first) =>
        {
            beneath(&otherwise.drive, first, goes_back)
        }
        drive => drive,
    }
}
