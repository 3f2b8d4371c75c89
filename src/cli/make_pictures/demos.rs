//! The little scenes that show what each pattern does: one of a few bodies, pressed, dropped, bent or stretched, with
//! the pattern's fibres in it.

use crate::edit::fibre_ops::{Called, laid, made_to_act};
use crate::io::{IoError, scene_from_json};
use crate::scene::{Scene, Shape};
use crate::sketch::pattern::Pattern;
use glam::DVec3;

const DROPPED: &str = include_str!("../../../assets/patterns/dropped_bar.json");
const PRESSED: &str = include_str!("../../../assets/patterns/pressed_bar.json");
const BENT: &str = include_str!("../../../assets/patterns/bent_bar.json");
const PUSHED: &str = include_str!("../../../assets/patterns/pushed_bar.json");
const HELD_PLATE: &str = include_str!("../../../assets/patterns/held_plate.json");
const HELD_LEAF: &str = include_str!("../../../assets/patterns/held_leaf.json");
const STRETCHED: &str = include_str!("../../../assets/patterns/stretched_plate.json");
const CRAWLING: &str = include_str!("../../../assets/patterns/crawling_bar.json");
const SWIMMING: &str = include_str!("../../../assets/patterns/swimming_bar.json");
const CUBE: &str = include_str!("../../../assets/patterns/floating_cube.json");
const ARM: &str = include_str!("../../../assets/patterns/standing_arm.json");
const BALL: &str = include_str!("../../../assets/patterns/floating_ball.json");
const STAR: &str = include_str!("../../../assets/patterns/floating_star.json");

/// What a pattern does, as a scene.
#[derive(Clone, Debug)]
pub struct Demo {
    /// The scene, fibres included.
    pub scene: Scene,
    /// Time from which on it is worth watching [s].
    pub from: f64,
    /// Time until which it is [s].
    pub to: f64,
    /// Whether the effect shows only beside the same body without fibres.
    pub beside_plain: bool,
    /// From where it is seen: turn to the right, height [degrees].
    pub eye: [f64; 2],
}

/// A row of the table: pattern, body, time to watch [s], eye, parameters unlike the usual ones.
type Row = (&'static str, &'static str, [f64; 2], [f64; 2], &'static [(&'static str, f64)]);

/// From where things that stand, things that bend to the side and things that lie flat are seen [degrees].
const STANDING: [f64; 2] = [28.0, 16.0];
const ASIDE: [f64; 2] = [8.0, 6.0];
const FLAT: [f64; 2] = [24.0, 32.0];
const ABOVE: [f64; 2] = [0.0, 62.0];

/// From when the panel has come down to the bar to when it has come down furthest [s].
const PRESSING: [f64; 2] = [0.06, 0.4];
/// From its release to its greatest squeeze, the bar takes this long [s].
const LANDING: [f64; 2] = [0.004, 0.0165];

/// The second swing of fibres that act, less the last of ten pictures, which is the first again [s].
const SWING: [f64; 2] = [0.8, 0.8 + 0.9 * 0.8];

const ROWS: [Row; 20] = [
    ("vertical", DROPPED, LANDING, STANDING, &[]),
    ("slanted", PRESSED, PRESSING, ASIDE, &[]),
    ("helix_left", PRESSED, PRESSING, STANDING, &[]),
    ("helix_right", PRESSED, PRESSING, STANDING, &[]),
    ("cross", PUSHED, [0.0, 0.06], ASIDE, &[]),
    ("frame", DROPPED, LANDING, STANDING, &[]),
    ("c_shape", BENT, PRESSING, ASIDE, &[]),
    ("s_shape", BENT, PRESSING, ASIDE, &[]),
    ("radial", HELD_PLATE, [0.0, 0.15], FLAT, &[]),
    ("vein", HELD_LEAF, [0.0, 0.2], FLAT, &[]),
    ("spiral", STRETCHED, [0.0, 0.4], ABOVE, &[("arms", 3.0), ("turns", 1.0)]),
    ("short_fibres", DROPPED, LANDING, STANDING, &[("fibres", 60.0)]),
    ("worm", CRAWLING, SWING, ASIDE, &[]),
    ("tail", SWIMMING, [1.0, 1.45], ABOVE, &[("contract", 0.6), ("period", 0.5)]),
    ("finger", ARM, SWING, ASIDE, &[]),
    ("rings", CUBE, SWING, STANDING, &[]),
    ("starfish", STAR, SWING, FLAT, &[]),
    ("tentacle", ARM, SWING, STANDING, &[]),
    ("trunk", ARM, SWING, STANDING, &[]),
    ("spokes", BALL, SWING, STANDING, &[]),
];

/// Bodies whose fibres hold against something: what they do shows only beside the same body without them.
const HOLDING: [&str; 4] = [DROPPED, PUSHED, HELD_PLATE, HELD_LEAF];

/// The scene of a pattern; none for one that has none.
///
/// # Errors
/// None for the scenes that ship.
pub fn demo(pattern: &Pattern) -> Result<Option<Demo>, IoError> {
    let Some((_, base, [from, to], eye, changed)) = ROWS.into_iter().find(|row| row.0 == pattern.id) else {
        return Ok(None);
    };
    let mut scene = scene_from_json(base)?;
    let mut values = pattern.defaults();
    for (parameter, value) in pattern.parameters.iter().zip(&mut values) {
        *value = changed.iter().find(|(id, _)| *id == parameter.id).map_or(*value, |(_, other)| *other);
    }
    for body in &mut scene.bodies {
        let Some(size) = body.shape.size() else { continue };
        let middle = if let Shape::Box(shape) = &body.shape { DVec3::from_array(shape.center) } else { DVec3::ZERO };
        let half = 0.5 * DVec3::from_array(size);
        let lines = pattern.lay(&values, middle - half, middle + half);
        let spacing = body.material.spacing();
        let called = Called { id: pattern.id, title: pattern.title, bending: pattern.bending, spacing };
        body.fibres = laid(called, &lines, &body.material, &[]);
        body.drives = made_to_act(&mut body.fibres, (&lines, &pattern.acts(&values, lines.len())), pattern.id, &[]);
    }
    Ok(Some(Demo { scene, from, to, beside_plain: HOLDING.contains(&base), eye }))
}

impl Demo {
    /// The same scene without fibres.
    pub fn plain(&self) -> Scene {
        let mut scene = self.scene.clone();
        scene.bodies.iter_mut().for_each(|body| body.fibres.clear());
        scene
    }
}
