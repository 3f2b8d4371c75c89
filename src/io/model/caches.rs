//! Point caches in: PC2 and MDD. How they are laid out is said where they are written, in `io::export`.

use super::failure::{Failure, missing};
use crate::geometry::point_cache::PointCache;
use glam::Vec3;

/// Bytes of a point.
const POINT: usize = 12;

/// Reads a PC2 file, whose times are frames.
pub(super) fn read_pc2(bytes: &[u8]) -> Result<PointCache, Failure> {
    let Some(rest) = bytes.strip_prefix(b"POINTCACHE2\0") else {
        return Err(Failure::new("it does not begin with POINTCACHE2, as every PC2 file does"));
    };
    let mut words = rest.chunks_exact(4).map(|word| [word[0], word[1], word[2], word[3]]);
    let head: Vec<[u8; 4]> = words.by_ref().take(5).collect();
    let [version, points, first, step, samples] = head[..] else {
        return Err(cut_off(20 - 4 * head.len()));
    };
    let version = i32::from_le_bytes(version);
    if version != 1 {
        return Err(Failure::new(format_args!("it is of version {version} of the format, and 1 is read")));
    }
    let [points, samples] = [points, samples].map(u32::from_le_bytes);
    let (first, step) = (f64::from(f32::from_le_bytes(first)), f64::from(f32::from_le_bytes(step)));
    let times: Vec<f64> = (0..counted(points, samples, rest.len().saturating_sub(20))?.1)
        .map(|sample| first + step * sample as f64)
        .collect();
    if !(step > 0.0 && times.iter().all(|time| time.is_finite())) {
        return Err(Failure::new(format_args!("its samples are {step} frames apart, which is no time")));
    }
    cache(times, true, points as usize, &rest[20..], f32::from_le_bytes)
}

/// Reads an MDD file.
pub(super) fn read_mdd(bytes: &[u8]) -> Result<PointCache, Failure> {
    let Some((head, rest)) = bytes.split_at_checked(8) else { return Err(cut_off(8 - bytes.len())) };
    let number = |word: &[u8]| u32::from_be_bytes([word[0], word[1], word[2], word[3]]);
    let [samples, points] = [number(&head[..4]), number(&head[4..])];
    // A time of four bytes goes with every sample.
    let times_take = 4 * samples as usize;
    let (_, samples) = counted(points, samples, rest.len().saturating_sub(times_take))?;
    let (times, rest) = rest.split_at(4 * samples);
    let times: Vec<f64> =
        times.chunks_exact(4).map(|word| f64::from(f32::from_be_bytes([word[0], word[1], word[2], word[3]]))).collect();
    if !(times.iter().all(|time| time.is_finite()) && times.windows(2).all(|pair| pair[0] < pair[1])) {
        return Err(Failure::new("the times of its samples are no ascending numbers"));
    }
    cache(times, false, points as usize, rest, f32::from_be_bytes)
}

fn cut_off(bytes: usize) -> Failure {
    Failure::new(format_args!("it is cut off: {}", missing(bytes)))
}

/// The numbers of points and samples, where there are any and so many bytes hold them.
fn counted(points: u32, samples: u32, bytes: usize) -> Result<(usize, usize), Failure> {
    if points == 0 || samples == 0 {
        let what = if samples == 0 { "frames" } else { "points" };
        return Err(Failure::new(format_args!("it has no {what}")));
    }
    let needed = (points as usize).saturating_mul(POINT).saturating_mul(samples as usize);
    if needed > bytes {
        let problem = format_args!("it is cut off: {samples} frames of {points} points, {}", missing(needed - bytes));
        return Err(Failure::new(problem));
    }
    Ok((points as usize, samples as usize))
}

fn cache(
    times: Vec<f64>,
    in_frames: bool,
    points: usize,
    bytes: &[u8],
    number: fn([u8; 4]) -> f32,
) -> Result<PointCache, Failure> {
    let each = bytes.chunks_exact(POINT).take(points * times.len());
    let part = |point: &[u8], k: usize| number([point[k], point[k + 1], point[k + 2], point[k + 3]]);
    let values: Vec<Vec3> = each.map(|point| Vec3::new(part(point, 0), part(point, 4), part(point, 8))).collect();
    if let Some(lost) = values.iter().position(|value| !value.is_finite()) {
        let problem = format_args!("point {} of frame {} (from 0) is at no place", lost % points, lost / points);
        return Err(Failure::new(problem));
    }
    Ok(PointCache::new(times, in_frames, points, values))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pc2(points: u32, samples: u32, step: f32, values: &[f32]) -> Vec<u8> {
        let mut bytes = b"POINTCACHE2\0".to_vec();
        for word in [1_u32.to_le_bytes(), points.to_le_bytes(), 3_f32.to_le_bytes(), step.to_le_bytes()] {
            bytes.extend(word);
        }
        bytes.extend(samples.to_le_bytes());
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        bytes
    }

    fn mdd(points: u32, times: &[f32], values: &[f32]) -> Vec<u8> {
        let words = [times.len() as u32, points].into_iter().flat_map(u32::to_be_bytes);
        words.chain(times.iter().chain(values).flat_map(|value| value.to_be_bytes())).collect()
    }

    #[test]
    fn both_formats_hold_the_same() {
        let values: Vec<f32> = (0..12_u8).map(f32::from).collect();
        let cache = read_pc2(&pc2(2, 2, 2.0, &values)).expect("a sound file");
        assert_eq!((cache.points(), cache.length()), (2, 2.0));
        assert_eq!(cache.around(2.0).point(1)[0].to_array(), [9.0, 10.0, 11.0]);
        let other = read_mdd(&mdd(2, &[0.5, 1.0], &values)).expect("a sound file");
        assert_eq!(other.length(), 0.5);
        assert_eq!(other.around(0.5).point(1)[0].to_array(), [9.0, 10.0, 11.0]);
    }

    #[test]
    fn what_is_damaged_is_refused_in_a_sentence() {
        let values = [0.0; 12];
        let lost = [0.0, 0.0, 0.0, 0.0, f32::NAN, 0.0];
        let whole = pc2(2, 2, 1.0, &values);
        for (found, said) in [
            (read_pc2(b"POINT"), "POINTCACHE2"),
            (read_pc2(&whole[..20]), "12 bytes are missing"),
            (read_pc2(&whole[..60]), "20 bytes are missing"),
            (read_pc2(&pc2(2, 0, 1.0, &[])), "no frames"),
            (read_pc2(&pc2(0, 2, 1.0, &[])), "no points"),
            (read_pc2(&pc2(2, 2, 0.0, &values)), "0 frames apart"),
            (read_pc2(&pc2(u32::MAX, u32::MAX, 1.0, &values)), "cut off"),
            (read_pc2(&pc2(2, 1, 1.0, &lost)), "point 1 of frame 0"),
            (read_mdd(&[0; 7]), "1 byte is missing"),
            (read_mdd(&mdd(2, &[], &[])), "no frames"),
            (read_mdd(&mdd(2, &[1.0, 1.0], &values)), "ascending"),
            (read_mdd(&mdd(2, &[1.0, 2.0], &values[..11])), "4 bytes are missing"),
        ] {
            let Err(Failure::Content { problem, .. }) = found else { panic!("{said}: {found:?}") };
            assert!(problem.contains(said), "{problem}");
        }
    }
}
