//! Values that a scene may have but that no solid has, or for which small strains do not hold: mostly a unit that was
//! mistaken.

use super::note::Note;
use crate::scene::{Body, Scene};
use crate::text::number::four_figures;
use glam::DVec3;

/// Young's moduli [Pa] of solids, from the softest gels to diamond.
const YOUNG_MODULUS: [f64; 2] = [10.0, 1.3e12];

/// Densities of solids [kg/m³], from aerogels to osmium.
const DENSITY: [f64; 2] = [0.1, 2.3e4];

/// A body whose weight strains it by this much is more than crushed by it.
const CRUSHED: f64 = 1.0;

/// What is said of a body of this extent [m] that is filled to this mass [kg] in this volume [m³].
pub(super) fn notes(scene: &Scene, body: &Body, size: DVec3, (mass, volume): (f64, f64), path: &str) -> Vec<Note> {
    let modulus = body.material.young_modulus;
    let (density, gravity) = (mass / volume, DVec3::from_array(scene.gravity));
    let mut notes = Vec::new();
    let mut warn = |field: &str, text: String| {
        notes.push(Note { path: format!("{path}/material/{field}"), text, warning: true });
    };
    let between = |value: f64, [least, most]: [f64; 2]| {
        (value < least).then_some(("less", least)).or((value > most).then_some(("more", most)))
    };
    if let Some((than, limit)) = between(modulus, YOUNG_MODULUS) {
        let [value, limit] = [modulus, limit].map(four_figures);
        warn("young_modulus", format!("{value} Pa is {than} than any solid has ({limit} Pa); is it meant in pascals?"));
    }
    if let Some((than, limit)) = between(density, DENSITY) {
        let [value, limit] = [density, limit].map(four_figures);
        warn(
            "mass",
            format!(
                "the body has {value} kg/m³, {than} than any solid ({limit} kg/m³); is it meant in kilograms and metres?"
            ),
        );
    }
    // By the extent along gravity in the world, whatever the body's turn.
    let up = body.placement.rotation.quaternion().inverse() * gravity.normalize_or_zero();
    let height = up.abs().dot(size);
    let strain = density * gravity.length() * height / modulus;
    if strain > CRUSHED {
        let strain = four_figures(100.0 * strain);
        warn(
            "young_modulus",
            format!(
                "the body's own weight strains it by about {strain} %: it cannot stand; strains of a few per cent are meant"
            ),
        );
    }
    let speed = DVec3::from_array(body.initial.velocity).length();
    let sound = (modulus / density).sqrt();
    if speed > sound {
        let [speed, sound] = [speed, sound].map(four_figures);
        warn(
            "young_modulus",
            format!(
                "the body starts at {speed} m/s, faster than waves run in it ({sound} m/s): whatever it strikes crushes it"
            ),
        );
    }
    notes
}
