//! What is done to the keys of a drive: pure functions from a drive to the drive as it is to be.

use crate::bake::solver_drive;
use crate::scene::{AfterLast, Drive, DriveKey, DriveKeys, Interpolation, SharedDrive, Wave};

/// The frame that is nearest to a time [s], and not before the start.
pub(super) fn on_frame(time: f64, frame: f64) -> f64 {
    ((time / frame).round() * frame).max(0.0)
}

/// The key at a time [s], as far as frames tell times apart.
pub(super) fn key_at(keys: &DriveKeys, time: f64, frame: f64) -> Option<usize> {
    keys.keys.iter().position(|key| (key.time - time).abs() < 0.5 * frame)
}

/// Keys from one value on, where there is none yet.
pub(super) fn first_key(time: f64, value: f64) -> DriveKeys {
    DriveKeys::new([(time, value)])
}

/// With a key at a time, in place of the one that is there in the same frame; tells which it is.
pub(super) fn with_key(keys: &DriveKeys, time: f64, value: f64, frame: f64) -> (DriveKeys, usize) {
    let mut keys = keys.clone();
    let key = DriveKey::new(time, value);
    let index = key_at(&keys, time, frame).unwrap_or_else(|| {
        let index = keys.keys.partition_point(|key| key.time < time);
        keys.keys.insert(index, key.clone());
        index
    });
    keys.keys[index].value = value;
    (keys, index)
}

/// Without some of its keys; where none is left, what it is otherwise, or what the first of these was.
pub(super) fn without_keys(keys: &DriveKeys, which: &[usize]) -> Drive {
    let mut left = keys.clone();
    let mut index = 0;
    left.keys.retain(|_| {
        index += 1;
        !which.contains(&(index - 1))
    });
    match left.keys.len() {
        0 => match left.otherwise {
            Some(otherwise) => *otherwise.drive,
            None => Drive::Constant(keys.keys.first().map_or(0.0, |key| key.value)),
        },
        // One alone is none to come again to.
        1 => DriveKeys { after: AfterLast::Hold, ..left }.into(),
        _ => left.into(),
    }
}

/// Moves some keys in time [s], none of them before the start, and in value, none of them out of `limits`. Those that
/// stay and come to lie in the frame of one that is moved make room for it. Tells which the moved ones are now.
pub(super) fn moved_keys(
    keys: &DriveKeys,
    which: &[usize],
    [later, higher]: [f64; 2],
    [least, most]: [f64; 2],
    frame: f64,
) -> (DriveKeys, Vec<usize>) {
    let moving = |index: &usize| which.contains(index);
    let first =
        which.iter().filter_map(|&index| keys.keys.get(index)).map(|key| key.time).fold(f64::INFINITY, f64::min);
    let later = later.max(-first);
    let mut moved: Vec<(bool, DriveKey)> = Vec::new();
    for (index, key) in keys.keys.iter().enumerate().filter(|(index, _)| moving(index)) {
        let value = (key.value + higher).clamp(least.min(key.value), most.max(key.value));
        let time = (keys.keys[index].time + later).max(0.0);
        moved.push((true, DriveKey { time, value, ..key.clone() }));
    }
    let makes_room = |key: &DriveKey| moved.iter().any(|(_, other)| (other.time - key.time).abs() < 0.5 * frame);
    let staying = keys.keys.iter().enumerate().filter(|(index, key)| !moving(index) && !makes_room(key));
    let staying: Vec<_> = staying.map(|(_, key)| (false, key.clone())).collect();
    moved.extend(staying);
    moved.sort_by(|a, b| a.1.time.total_cmp(&b.1.time));
    let now = moved.iter().enumerate().filter(|(_, (is_moved, _))| *is_moved).map(|(index, _)| index).collect();
    let keys = DriveKeys { keys: moved.into_iter().map(|(_, key)| key).collect(), ..keys.clone() };
    (keys, now)
}

/// Keys put in, in place of what is there in the same frames; tells which they are.
pub(super) fn with_keys(keys: &DriveKeys, put: &[DriveKey], frame: f64) -> (DriveKeys, Vec<usize>) {
    let mut all = keys.clone();
    for key in put {
        let (with, index) = with_key(&all, key.time, key.value, frame);
        all = with;
        all.keys[index].slope = key.slope;
    }
    let which = put.iter().filter_map(|key| key_at(&all, key.time, frame)).collect();
    (all, which)
}

/// With a key at a time that leaves the course as it is; tells which it is.
pub(super) fn with_key_on(keys: &DriveKeys, time: f64, frame: f64) -> (DriveKeys, usize) {
    let (value, slope) = solver_drive(&Drive::Keyframes(keys.clone()), &[]).at(time);
    let is_smooth = keys.between == Interpolation::Smooth;
    let (mut keys, index) = with_key(keys, time, value, frame);
    if is_smooth {
        keys.keys[index].slope = slope;
    }
    (keys, index)
}

/// A drive as keys that go on as it does. Of a wave the least and the greatest value of a swing, over and over: it
/// neither rises at its start nor runs along a fibre then.
pub(super) fn as_keys(drive: Option<&Drive>, shared: &[SharedDrive], time: f64, frame: f64) -> DriveKeys {
    match drive.and_then(|drive| drive.resolved(shared)) {
        Some(Drive::Keyframes(keys)) => keys.clone(),
        Some(Drive::Wave(wave)) if wave.amplitude != 0.0 => {
            let low = wave.start + wave.period * (wave.phase_degrees / 360.0).rem_euclid(1.0);
            let [trough, crest] = [wave.mean - wave.amplitude, wave.mean + wave.amplitude];
            let swing = [(low, trough), (low + 0.5 * wave.period, crest), (low + wave.period, trough)];
            DriveKeys { after: AfterLast::Repeat, between: Interpolation::Smooth, ..DriveKeys::new(swing) }
        }
        other => first_key(on_frame(time, frame), other.map_or(1.0, |drive| value_of(drive, shared, time))),
    }
}

/// A drive as a wave between the least and the greatest value that it has, or could have.
pub(super) fn as_wave(drive: Option<&Drive>, shared: &[SharedDrive]) -> Wave {
    let resolved = drive.and_then(|drive| drive.resolved(shared));
    if let Some(Drive::Wave(wave)) = resolved {
        return wave.clone();
    }
    let span = resolved.and_then(Drive::range).filter(|[least, greatest]| greatest > least);
    let [least, greatest] = span.unwrap_or([0.0, 1.0]);
    let period = match resolved {
        Some(Drive::Keyframes(DriveKeys { keys, .. })) if span.is_some() => {
            keys.last().map_or(1.0, |last| last.time) - keys.first().map_or(0.0, |first| first.time)
        }
        _ => 1.0,
    };
    Wave { mean: 0.5 * (least + greatest), amplitude: 0.5 * (greatest - least), ..Wave::new(period) }
}

/// The value of a drive at a time [s]; of a wave, where a fibre begins.
pub(super) fn value_of(drive: &Drive, shared: &[SharedDrive], time: f64) -> f64 {
    solver_drive(drive, shared).at(time).0
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: f64 = 1.0 / 60.0;

    fn keys(list: &[(f64, f64)]) -> DriveKeys {
        DriveKeys::new(list.iter().copied())
    }

    fn pairs(keys: &DriveKeys) -> Vec<(f64, f64)> {
        keys.keys.iter().map(|key| (key.time, key.value)).collect()
    }

    #[test]
    fn a_key_takes_the_place_of_the_one_in_its_frame() {
        let before = keys(&[(0.0, 0.0), (1.0, 1.0)]);
        let (after, index) = with_key(&before, 0.5, 0.25, FRAME);
        assert_eq!((pairs(&after), index), (vec![(0.0, 0.0), (0.5, 0.25), (1.0, 1.0)], 1));
        let (after, index) = with_key(&after, 0.5 + 0.3 * FRAME, 0.75, FRAME);
        assert_eq!((pairs(&after), index), (vec![(0.0, 0.0), (0.5, 0.75), (1.0, 1.0)], 1));
    }

    #[test]
    fn a_key_set_on_the_way_leaves_the_course_as_it_is() {
        let mut before = keys(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.5)]);
        before.keys[1].slope = -1.5;
        let (after, index) = with_key_on(&before, 0.4, FRAME);
        assert_eq!((index, after.keys.len()), (1, 4));
        for k in 0..=40 {
            let time = 0.05 * f64::from(k);
            let [one, other] = [&before, &after].map(|keys| value_of(&keys.clone().into(), &[], time));
            assert!((one - other).abs() < 1e-12, "{time}: {one} and {other}");
        }
        let (pasted, which) = with_keys(&keys(&[(0.0, 0.0)]), &before.keys[1..], FRAME);
        assert_eq!((which, pasted.keys[1].slope), (vec![1, 2], -1.5));
    }

    #[test]
    fn what_is_moved_goes_past_what_stays_and_stops_at_the_start_and_the_limits() {
        let before = keys(&[(0.0, 0.0), (0.5, 0.5), (1.0, 1.0)]);
        let (after, which) = moved_keys(&before, &[0], [0.7, 0.2], [0.0, 1.0], FRAME);
        assert_eq!((pairs(&after), which), (vec![(0.5, 0.5), (0.7, 0.2), (1.0, 1.0)], vec![1]));
        // On another key it takes its place.
        let (after, which) = moved_keys(&before, &[0], [0.5, 0.0], [0.0, 1.0], FRAME);
        assert_eq!((pairs(&after), which), (vec![(0.5, 0.0), (1.0, 1.0)], vec![0]));
        let (after, which) = moved_keys(&before, &[1, 2], [-0.9, 0.3], [0.0, 1.0], FRAME);
        assert_eq!((pairs(&after), which), (vec![(0.0, 0.8), (0.5, 1.0)], vec![0, 1]));
    }

    #[test]
    fn keys_go_and_the_last_leaves_its_value() {
        let repeated = DriveKeys { after: AfterLast::Repeat, ..keys(&[(0.0, 0.25), (1.0, 0.5)]) };
        let Drive::Keyframes(left) = without_keys(&repeated, &[1]) else { panic!("one key is left") };
        assert_eq!((pairs(&left), left.after), (vec![(0.0, 0.25)], AfterLast::Hold));
        assert_eq!(without_keys(&repeated, &[0, 1]), Drive::Constant(0.25));
    }

    #[test]
    fn a_wave_as_keys_goes_on_as_the_wave_did_within_a_hundredth() {
        let wave = Drive::from(Wave { mean: 0.3, amplitude: 0.2, start: 0.1, ..Wave::new(0.6).with_phase(130.0) });
        let keys = Drive::from(as_keys(Some(&wave), &[], 0.0, FRAME));
        for k in 0..200 {
            let time = 1.0 + 0.01 * f64::from(k);
            let [before, after] = [&wave, &keys].map(|drive| value_of(drive, &[], time));
            assert!((before - after).abs() < 0.011 * 0.4, "{time}: {before} {after}");
        }
        let back = as_wave(Some(&keys), &[]);
        assert!((back.mean - 0.3).abs() < 1e-12 && (back.period - 0.6).abs() < 1e-12, "{back:?}");
    }
}
