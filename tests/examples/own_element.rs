//! A structure of one's own, written outside the crate and put into a body of a scene: `cargo run --example
//! own_element`.
//!
//! A cord runs from one point of a soft block through a ring at a second to a third, and slides there without friction.
//! No spring between two points does that: what one side of the cord gets longer by, the other gives.
#![allow(clippy::print_stdout, reason = "an example talks to whoever runs it")]

use glam::DVec3;
use sinew::bake::{OwnElements, bake_with_elements};
use sinew::scene::{Assets, Automatic, Body, Material, Scene, TimeStep};
use sinew::solver::{Element, Local, Slopes};
use std::error::Error;

/// A cord through a ring, `k/2 (|b - a| + |c - b| - L)²` where it is taut.
#[derive(Clone)]
struct Cord {
    /// k [N/m].
    stiffness: f64,
    /// L [m].
    length: f64,
}

impl Cord {
    /// By how much it is longer than at rest [m].
    fn longer(&self, at: &Local<'_>) -> f64 {
        let [a, b, c] = [at.points[0], at.points[1], at.points[2]];
        (b.distance(a) + c.distance(b) - self.length).max(0.0)
    }
}

impl Element for Cord {
    /// The first three points that are given with it.
    fn points(&self) -> &[u32] {
        &[0, 1, 2]
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        0.5 * self.stiffness * self.longer(at).powi(2)
    }

    /// Its gradient: both sides pull with the same tension, and the ring is pulled by both.
    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let tension = self.stiffness * self.longer(at);
        let before = tension * (at.points[1] - at.points[0]).normalize_or_zero();
        let after = tension * (at.points[2] - at.points[1]).normalize_or_zero();
        out.points[0] -= before;
        out.points[1] += before - after;
        out.points[2] += after;
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(self.clone())
    }
}

/// The same, whose slopes are not those of its energy: it is refused.
#[derive(Clone)]
struct Careless(Cord);

impl Element for Careless {
    fn points(&self) -> &[u32] {
        self.0.points()
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        1.02 * self.0.energy(at)
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        self.0.slopes(at, out);
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(self.clone())
    }
}

/// The cord's ends and the ring between them, model frame [m].
const POINTS: [DVec3; 3] =
    [DVec3::new(-0.012, -0.012, 0.0), DVec3::new(0.012, -0.012, 0.0), DVec3::new(0.012, 0.012, 0.0)];

/// Runs the example.
///
/// # Errors
/// A scene that cannot be used.
pub fn main() -> Result<(), Box<dyn Error>> {
    let mut block = Body::cuboid("block", [0.036; 3]).with_material(Material::new(2e4, 0.3, 1000.0));
    // Pulled out of shape at the start, so that the cord is a tenth too long.
    block.initial.deformation = [[1.15, 0.2, 0.0], [0.0, 1.05, 0.0], [0.0, 0.0, 1.0]];
    // In short steps, as its energy is looked at closely.
    let step = TimeStep::Automatic(Automatic { safety: 0.15, ..Automatic::default() });
    let scene = Scene::new("Cord").with_gravity([0.0; 3]).with_frame_rate(500.0).with_time_step(step).with_body(block);
    scene.validate()?;

    let cord = Cord { stiffness: 300.0, length: 0.048 };
    let careless = OwnElements::new("block", "careless", POINTS, vec![Box::new(Careless(cord.clone()))]);
    let refused = bake_with_elements(&scene, &Assets::default(), &[careless]).err().ok_or("it is not refused")?;
    println!("{refused}");
    assert!(refused.to_string().contains("its slopes are"), "{refused}");

    let own = OwnElements::new("block", "cord", POINTS, vec![Box::new(cord.clone())]);
    let mut world = bake_with_elements(&scene, &Assets::default(), &[own])?.world;
    let energy = |world: &sinew::solver::World| world.bodies()[0].energies(world.time());
    let before = energy(&world);
    let mut swung = [0.0_f64; 2];
    println!("   time  one side  other side      both     in the cord");
    for frame in 0..=30 {
        let body = &world.bodies()[0];
        let points: Vec<DVec3> =
            body.parts().elements[0].points.iter().map(|point| point.gather(&body.state().positions)).collect();
        let sides = [points[0].distance(points[1]), points[1].distance(points[2])];
        let both = sides[0] + sides[1];
        let stored = energy(&world).elements;
        if frame % 3 == 0 {
            let [one, other] = sides.map(|side| 1e3 * side);
            println!(
                "{:5.3} s {one:6.2} mm   {other:6.2} mm {:6.2} mm  {:9.4} mJ",
                world.time(),
                1e3 * both,
                1e3 * stored
            );
        }
        // What it stores is its law at the length that it has.
        let expected = 0.5 * cord.stiffness * (both - cord.length).max(0.0).powi(2);
        assert!((stored - expected).abs() < 1e-9 * before.elements, "{stored} J, not {expected} J");
        let whole = energy(&world).total();
        assert!((whole / before.total() - 1.0).abs() < 0.005, "{whole} J, not {} J", before.total());
        if frame > 0 {
            swung = [0, 1].map(|k: usize| swung[k].max((sides[k] / 0.024 - 1.0).abs()));
        }
        world.advance_frame();
    }
    let drift = world.bodies()[0].state().linear_momentum().length();
    assert!(drift < 1e-12, "{drift} N s that nothing gave");
    println!(
        "Each side swings by {:.0} % and more, and the block keeps energy and momentum.",
        100.0 * swung[0].min(swung[1])
    );
    Ok(())
}
