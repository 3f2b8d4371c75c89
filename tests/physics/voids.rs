//! Voids against theory and a finer computation: what is left of the stiffness, what a cut lets through, which walls
//! are refused.

use crate::common::*;
use glam::DVec3;
use sinew::bake::{BakeError, bake};
use sinew::geometry::{Cuboid, box_surface};
use sinew::scene::{Assets, Axis, Body, Distance, FibreSource, MeasureKind, Motion, Scene, Side, Void};
use std::f64::consts::PI;

const E: f64 = 5e6;
const DENSITY: f64 = 4e-4 / (D * D * D);

/// A block that is pulled a little along y; its ends are held along `held` and free otherwise.
fn pulled(mut block: Body, layers_along: u32, held: &[Axis]) -> Scene {
    let length = f64::from(layers_along - 1) * D;
    let omega = PI * (E / DENSITY).sqrt() / length;
    block.material.damping.air = 1.2 * omega;
    block.regions = vec![layers("bottom", Axis::Y, Side::Min, 1), layers("top", Axis::Y, Side::Max, 1)];
    let pull = ramp([0.0, 1.0, 0.0], Distance::Metres(1e-3 * length), 3.0 / omega);
    block.pins = vec![pin("bottom", held, Motion::Fixed), pin("top", held, pull)];
    let mut scene = in_space(block);
    scene.time.frames_per_second = omega;
    scene.measures = vec![measure("pull", MeasureKind::reaction_force("bottom", [0.0, 1.0, 0.0]))];
    scene
}

/// Pull of a block with a void over that of the same block without, and the share of particles that is taken out.
fn stiffness(block: &Body, void: Void, layers_along: u32, held: &[Axis]) -> (f64, f64) {
    let pull = |block: Body| {
        let runner = settle(&pulled(block, layers_along, held), 400);
        (scalar(&runner, 0), runner.world().bodies()[0].state().len() as f64)
    };
    let ((solid, all), (hollow, left)) = (pull(block.clone()), pull(block.clone().with_void(void)));
    println!("{hollow} N of {solid} N, {left} of {all} particles");
    (hollow / solid, 1.0 - left / all)
}

#[test]
fn a_hollow_cube_is_as_soft_as_hexahedra_of_half_the_size_have_it() {
    let hole = Void::sphere("hole", [0.0, 5.0 * D, 0.0], 2.88 * D);
    let (found, removed) = stiffness(&block([10, 10, 10], E), hole, 10, &[Axis::Y]);
    // Of the same share taken out of hexahedra half the size: 0.839; (1 - p) / (1 + p) = 0.838.
    assert!((removed - 0.088).abs() < 1e-9, "{removed}");
    assert!((found / 0.839 - 1.0).abs() < 0.025, "{found}");
}

#[test]
fn a_square_tube_of_two_layers_pulls_by_its_section() {
    let top = 13.0 * D;
    let hole = Void::in_box("bore", [-2.0 * D, -D, -2.0 * D], [2.0 * D, top, 2.0 * D]);
    let (found, removed) = stiffness(&block([8, 12, 8], E), hole, 12, &[Axis::Y]);
    assert!((removed - 0.25).abs() < 1e-9, "{removed}");
    assert!((found / 0.75 - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn a_crack_lets_nothing_through_and_takes_nothing_out() {
    let crack = Void::in_box("crack", [0.0, 5.99 * D, -9.0 * D], [9.0 * D, 6.01 * D, 9.0 * D]);
    let whole = block([6, 12, 6], E);
    let (found, removed) = stiffness(&whole, crack, 12, &ALL);
    assert!(removed == 0.0, "a crack takes no particle out");
    // Hexahedra of half the size have 0.605 with a slit there.
    assert!((found - 0.605).abs() < 0.02, "{found}");
    // Right through: what it cuts off is left out, and that is said.
    let through = Void::in_box("cut", [-9.0 * D, 4.99 * D, -9.0 * D], [9.0 * D, 5.01 * D, 9.0 * D]);
    let baked = baked(&in_space(whole.with_void(through)));
    assert_eq!(baked.world.bodies()[0].state().len(), 7 * 36);
    assert!(
        baked.notes.iter().any(|note| note.warning && note.text.contains("cut 180 particles off")),
        "{:?}",
        baked.notes
    );
}

#[test]
fn walls_of_less_than_two_layers_are_refused_with_their_figure() {
    let with = |void: Void| in_space(block([8, 8, 8], E).with_void(void));
    // One layer is left under the top.
    let error = bake(
        &with(Void::in_box("slot", [-2.0 * D, 3.0 * D, -2.0 * D], [2.0 * D, 7.0 * D, 2.0 * D])),
        &Assets::default(),
    );
    let error = error.err().expect("a wall of one layer");
    let text = error.to_string();
    assert!(matches!(error, BakeError::ThinWall { .. }), "{error:?}");
    assert!(text.starts_with("/bodies/0/voids/0/shape") && text.contains("leave 1.20e-2 m or more"), "{text}");
    // One layer between two of them.
    let mut two = with(Void::in_box("left", [-2.0 * D, 2.0 * D, -2.0 * D], [-D, 6.0 * D, 2.0 * D]));
    two.bodies[0] =
        two.bodies[0].clone().with_void(Void::in_box("right", [0.0, 2.0 * D, -2.0 * D], [D, 6.0 * D, 2.0 * D]));
    assert!(matches!(bake(&two, &Assets::default()), Err(BakeError::ThinWall { .. })));
    // A bore right through, and a dent in the top, end in rims and are none.
    let line = |y: f64| FibreSource::Vertices(vec![[-0.1, y, 0.0], [0.0, y, 0.0], [0.1, y, 0.0]]);
    let bore = baked(&with(Void::tube("bore", line(4.0 * D), 1.6 * D)));
    let dent = baked(&with(Void::sphere("dent", [0.0, 9.0 * D, 0.0], 3.0 * D)));
    for (of, least) in [(bore, 400), (dent, 470)] {
        let left = of.world.bodies()[0].state().len();
        assert!((least..512).contains(&left), "{left}");
    }
}

#[test]
fn the_skin_opens_where_a_void_comes_out_and_has_its_wall() {
    let void = Void::mesh("hole", "hole");
    let side = 4.4 * D;
    let cube = Cuboid { center: DVec3::new(0.0, 9.0 * D, 0.0), size: DVec3::splat(side) };
    let mut assets = Assets::default();
    assets.insert_mesh("hole", &box_surface(&cube, D)).expect("a cube");
    let body = block([9, 9, 9], E).with_void(void);
    let world = bake(&in_space(body), &assets).expect("a cube with a dent").world;
    let parts = world.bodies()[0].parts();
    let skin = parts.skin.as_ref().expect("a skin");
    let vertices = skin.positions(&parts.model);
    let volume: f64 = skin
        .triangles()
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|k| vertices[k as usize]);
            a.dot(b.cross(c)) / 6.0
        })
        .sum();
    let expected = (9.0 * D).powi(3) - side * side * 0.5 * side;
    // The corners of the opening are cut off within a face each.
    assert!((volume / expected - 1.0).abs() < 4e-3, "{volume}, not {expected}");
    let inside = |at: &DVec3| ((*at - cube.center).abs() - 0.5 * side).max_element() < -1e-6;
    assert!(!vertices.iter().any(inside), "nothing of the skin is left in the hole");
}
