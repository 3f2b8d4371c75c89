//! Colours that stand for values: one map from dark violet over green-blue to pale yellow, and one for values of either
//! sign, from blue over a pale grey to red.
//!
//! Both are curves of this crate's own in OKLCH (Ottosson 2020). The first grows steadily lighter, so that it can be
//! read in grey and with any kind of colour vision; the second grows darker from its middle, alike on both sides, by
//! hues that most eyes tell apart. They are cut into tables of steps of equal length in OKLab: equal differences of the
//! value look equally different, wherever they lie.

use super::Colour;
use crate::geometry::rig::Rig;
use std::iter::repeat_n;
use std::sync::OnceLock;

/// Colours in the table.
const STEPS: usize = 256;
/// Pieces of the curve by which its length is measured.
const PIECES: usize = 4096;

/// Lightness, chroma and hue [turns] of the curve at `t` from 0 to 1. The chroma is least in the middle, where screens
/// have least of it.
fn curve(t: f32) -> [f32; 3] {
    let edge = 2.0 * t - 1.0;
    [0.28 + 0.62 * t, 0.088 + 0.052 * edge * edge, (292.0 - 187.0 * t) / 360.0]
}

/// As [`curve`], of values of either sign: pale in the middle, where hues meet as grey.
fn signed_curve(t: f32) -> [f32; 3] {
    let side = 2.0 * t - 1.0;
    let hue = if side < 0.0 { 256.0 } else { 33.0 };
    [0.88 - 0.36 * side.abs(), 0.17 * side.abs(), hue / 360.0]
}

/// A curve as a table.
fn table(curve: fn(f32) -> [f32; 3]) -> [Colour; STEPS] {
    let lab = |piece: usize| {
        let [lightness, chroma, hue] = curve(piece as f32 / PIECES as f32);
        let (sin, cos) = (std::f32::consts::TAU * hue).sin_cos();
        glam::Vec3::new(lightness, chroma * cos, chroma * sin)
    };
    let mut lengths = vec![0.0_f32];
    for piece in 0..PIECES {
        lengths.push(lengths[piece] + lab(piece).distance(lab(piece + 1)));
    }
    let whole = lengths[PIECES];
    std::array::from_fn(|step| {
        let wanted = whole * step as f32 / (STEPS - 1) as f32;
        let piece = lengths.partition_point(|length| *length < wanted).min(PIECES);
        let [lightness, chroma, hue] = curve(piece as f32 / PIECES as f32);
        Colour::oklch(lightness, chroma, hue)
    })
}

fn colours() -> &'static [Colour; STEPS] {
    static COLOURS: OnceLock<[Colour; STEPS]> = OnceLock::new();
    COLOURS.get_or_init(|| table(curve))
}

fn signed_colours() -> &'static [Colour; STEPS] {
    static COLOURS: OnceLock<[Colour; STEPS]> = OnceLock::new();
    COLOURS.get_or_init(|| table(signed_curve))
}

/// The entry of a table for a place in it, 0 to 1.
fn entry(place: f32) -> usize {
    (place.clamp(0.0, 1.0) * (STEPS - 1) as f32).round() as usize
}

/// The colour of a value's place in its range, 0 to 1; what lies outside, or is no number, has the colour of an end.
pub(crate) fn colour(place: f32) -> Colour {
    colours()[entry(place)]
}

/// The colour of a signed value's place in its range, -1 to 1: cool below zero, pale at it, warm above. What lies
/// outside has the colour of an end, what is no number that of zero.
pub(crate) fn signed_colour(place: f32) -> Colour {
    let place = if place.is_nan() { 0.0 } else { place };
    signed_colours()[entry(0.5 + 0.5 * place)]
}

/// A colour as 8 bits a channel, sRGB.
pub(super) fn bytes(colour: Colour) -> [u8; 3] {
    [colour.red, colour.green, colour.blue].map(|part| (255.0 * part).round() as u8)
}

/// Colours of values over a range, sRGB, 0 to 255.
pub(super) fn of(values: &[f64], [low, high]: [f64; 2]) -> Vec<[u8; 3]> {
    let width = if high > low { high - low } else { 1.0 };
    values.iter().map(|value| bytes(colour(((value - low) / width) as f32))).collect()
}

/// Colours of a surface's vertices over a range of values, sRGB, 0 to 255, from one value at each particle that the
/// surface hangs on: by the same weights as the vertices themselves.
pub(super) fn over(rig: &Rig, values: &[f64], [low, high]: [f64; 2]) -> Vec<[u8; 3]> {
    let table = colours().map(bytes);
    let width = if high > low { high - low } else { 1.0 };
    // Directions have no value.
    let directions = repeat_n(0.0, rig.directions);
    let places: Vec<f32> = values.iter().map(|value| ((value - low) / width) as f32).chain(directions).collect();
    let places = rig.vertices.apply_to_values(&rig.points.apply_to_values(&places));
    places.iter().map(|place| table[entry(*place)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::linear_map::LinearMap;

    /// OKLab of a colour, as published.
    #[allow(clippy::excessive_precision, reason = "the matrices as published")]
    fn oklab(colour: Colour) -> glam::DVec3 {
        let [r, g, b, _] = colour.linear().map(f64::from);
        let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
        let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
        let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
        glam::DVec3::new(
            0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
            1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
            0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
        )
    }

    #[test]
    fn equal_steps_look_equal_and_grow_lighter() {
        let labs: Vec<glam::DVec3> = (0..=32).map(|k| oklab(colour(k as f32 / 32.0))).collect();
        let steps: Vec<f64> = labs.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
        let mean = steps.iter().sum::<f64>() / steps.len() as f64;
        // An entry of the table more or less is an eighth of such a step.
        assert!(steps.iter().all(|step| (step / mean - 1.0).abs() < 0.14), "{mean} {steps:?}");
        assert!(labs.windows(2).all(|pair| pair[1].x > pair[0].x + 0.005), "{labs:?}");
    }

    #[test]
    fn signed_values_are_cool_pale_or_warm_by_equal_steps_alike_on_both_sides() {
        let labs: Vec<glam::DVec3> = (-16..=16).map(|k| oklab(signed_colour(k as f32 / 16.0))).collect();
        let steps: Vec<f64> = labs.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
        let mean = steps.iter().sum::<f64>() / steps.len() as f64;
        assert!(steps.iter().all(|step| (step / mean - 1.0).abs() < 0.14), "{mean} {steps:?}");
        for k in 0..16 {
            let [below, above] = [labs[k], labs[32 - k]];
            assert!((below.x - above.x).abs() < 0.012, "as light on both sides: {below} {above}");
            assert!(below.x < labs[k + 1].x, "lighter towards the middle");
            assert!(below.z < 0.0 && above.y > 0.0 && above.z > 0.0, "blue and red: {below} {above}");
        }
        let chroma = labs[16].y.hypot(labs[16].z);
        assert!(chroma < 0.01, "{chroma}");
        assert_eq!((signed_colour(-3.0), signed_colour(3.0)), (signed_colour(-1.0), signed_colour(1.0)));
        assert_eq!(signed_colour(f32::NAN), signed_colour(0.0));
    }

    #[test]
    fn what_lies_outside_the_range_has_the_colour_of_an_end() {
        assert_eq!((colour(-3.0), colour(7.0)), (colour(0.0), colour(1.0)));
        assert_ne!(colour(0.0), colour(1.0));
        assert_eq!(colour(f32::NAN), colour(0.0));
    }

    #[test]
    fn vertices_take_the_mean_of_what_they_hang_on() {
        let mut points = LinearMap::default();
        points.push([(0, 1.0)]);
        points.push([(0, 0.5), (1, 0.5)]);
        points.push([(1, 1.0)]);
        let rig = Rig { points, vertices: LinearMap::gather(&[2, 1, 0]), ..Rig::default() };
        let bytes = |place: f32| bytes(colour(place));
        assert_eq!(over(&rig, &[10.0, 20.0], [10.0, 20.0]), [bytes(1.0), bytes(0.5), bytes(0.0)]);
    }
}
