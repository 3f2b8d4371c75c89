//! Patterns that act, laid into bodies of any shape: some of their fibres hold there, and move them the way they
//! should.

use glam::DVec3;
use sinew::bake::bake;
use sinew::edit::fibre_ops::{Called, laid, made_to_act};
use sinew::io::load_assets;
use sinew::scene::{Assets, BallShape, Body, CapsuleShape, Material, Scene, Shape};
use sinew::sim::Runner;
use sinew::sketch::pattern::{PATTERNS, Pattern};
use std::path::Path;

/// One swing [s].
const PERIOD: f64 = 0.8;

/// Bodies of three shapes, with their files.
fn bodies() -> Vec<(Body, Assets)> {
    let of = |shape: Shape| {
        let mut body = Body::new("body", shape);
        body.material = Material::new(2e4, 0.33, 1000.0).with_support_radius(0.03);
        (body.material.damping.pair, body.material.damping.air) = (20.0, 6.0);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
        let scene = Scene::new("fit").with_body(body.clone());
        let assets = load_assets(&scene, &folder, &mut |_| {}).expect("files that ship");
        (body, assets)
    };
    let mesh = sinew::scene::MeshShape::from("character.glb").with_particles(600);
    vec![of(BallShape::new(0.05).into()), of(CapsuleShape::new(0.03, 0.15).into()), of(mesh.into())]
}

/// The body with a pattern as it is laid into the box around it, all of a fibre swinging at once.
fn with_pattern(body: &Body, around: [DVec3; 2], rest: &[DVec3], pattern: &Pattern) -> Body {
    let mut values = pattern.defaults();
    for (parameter, value) in pattern.parameters.iter().zip(&mut values) {
        match parameter.id {
            "waves" => *value = 0.0,
            "period" => *value = PERIOD,
            _ => {}
        }
    }
    // Round bodies and limbs leave the corners of their boxes empty.
    let fitted = pattern.lay_into(&values, around, rest);
    println!("{} in {}: {:?}, {} stick out", pattern.id, around[1] - around[0], fitted.further_in, fitted.outside);
    let lines = fitted.fibres;
    let mut body = body.clone();
    let spacing = body.material.spacing();
    let called = Called { id: pattern.id, title: pattern.title, bending: pattern.bending, spacing };
    body.fibres = laid(called, &lines, &body.material, &[]);
    let acts = pattern.acts(&values, lines.len());
    body.drives = made_to_act(&mut body.fibres, (&lines, &acts), pattern.id, &[]);
    body
}

/// Where particles are, and where they were at rest.
struct Moved<'a> {
    rest: &'a [DVec3],
    now: &'a [DVec3],
    low: DVec3,
    high: DVec3,
}

impl Moved<'_> {
    /// Means of what lies in the first, the middle and the last third along an axis, at rest and now.
    fn thirds(&self, axis: usize) -> [[DVec3; 2]; 3] {
        [0, 1, 2].map(|third| {
            let share = |at: &DVec3| (at[axis] - self.low[axis]) / (self.high - self.low)[axis];
            let within = |at: &DVec3| ((3.0 * share(at)).floor() as usize).min(2) == third;
            let pairs: Vec<_> = self.rest.iter().zip(self.now).filter(|(at, _)| within(at)).collect();
            let mean =
                |of: &dyn Fn(&(&DVec3, &DVec3)) -> DVec3| pairs.iter().map(of).sum::<DVec3>() / pairs.len() as f64;
            [mean(&|pair| *pair.0), mean(&|pair| *pair.1)]
        })
    }

    /// How far both ends along an axis have gone in the direction of another, against the middle, over the size there.
    fn bow(&self, along: usize, towards: usize) -> f64 {
        let [first, middle, last] = self.thirds(along).map(|[before, after]| (after - before)[towards]);
        (0.5 * (first + last) - middle) / (self.high - self.low)[along]
    }

    /// Turn [rad] of the last third along Y against the first, about it.
    fn twist(&self) -> f64 {
        let thirds = self.thirds(1);
        let turn = |third: usize| {
            let [before, after] = thirds[third];
            let (mut sine, mut cosine) = (0.0, 0.0);
            for (at, x) in self.rest.iter().zip(self.now) {
                let share = (at.y - self.low.y) / (self.high - self.low).y;
                if ((3.0 * share).floor() as usize).min(2) == third {
                    let (a, b) = (*at - before, *x - after);
                    sine += a.z * b.x - a.x * b.z;
                    cosine += a.x * b.x + a.z * b.z;
                }
            }
            sine.atan2(cosine)
        };
        turn(2) - turn(0)
    }

    /// Mean distance from the axis along Y, or from the middle, over that at rest.
    fn girth(&self, all_round: bool) -> f64 {
        let across = |x: &DVec3| if all_round { *x } else { DVec3::new(x.x, 0.0, x.z) };
        let spread = |of: &[DVec3]| {
            let middle = of.iter().map(across).sum::<DVec3>() / of.len() as f64;
            of.iter().map(|x| across(x).distance(middle)).sum::<f64>()
        };
        spread(self.now) / spread(self.rest)
    }

    /// How far the end along an axis has come towards the middle, over the size.
    fn drawn_in(&self, along: usize) -> f64 {
        let [_, middle, last] = self.thirds(along).map(|[before, after]| (after - before)[along]);
        (middle - last) / (self.high - self.low)[along]
    }
}

#[test]
fn patterns_that_act_hold_in_bodies_of_any_shape_and_move_them_their_way() {
    let mut wrong = Vec::new();
    for (body, assets) in bodies() {
        let scene_of = |body: &Body| Scene::new("fit").with_gravity([0.0; 3]).with_body(body.clone());
        let world = bake(&scene_of(&body), &assets).expect("a body").world;
        let rest = world.bodies()[0].parts().rest.to_vec();
        let corner = |of: fn(DVec3, DVec3) -> DVec3| rest.iter().copied().reduce(of).expect("particles");
        let [low, high] = match body.shape.size() {
            Some(size) => [-0.5, 0.5].map(|half| half * DVec3::from_array(size)),
            None => [corner(DVec3::min), corner(DVec3::max)],
        };
        let size = high - low;
        // As a layout tells them.
        let along = if size.z > size.x { 2 } else { 0 };
        let mut order = [1, 0, 2];
        order.sort_by(|&a, &b| size[b].total_cmp(&size[a]));
        for pattern in PATTERNS.iter().filter(|pattern| pattern.is_acting()) {
            let fitted = with_pattern(&body, [low, high], &rest, pattern);
            let laid = fitted.fibres.len();
            let fitted = scene_of(&fitted);
            let baked = bake(&fitted, &assets).expect("it fits");
            let discarded = baked.notes.iter().filter(|note| note.warning && note.text.contains("discarded")).count();
            let mut runner = Runner::new(baked);
            let held = runner.snapshot().bodies[0].fibres.len();
            let mut found: Vec<f64> = Vec::new();
            for swings in [1.5, 2.0] {
                while runner.world().frame() < runner.frames_for(swings * PERIOD) {
                    runner.advance_frame();
                }
                assert!(runner.world().divergence().is_none(), "{}: {:?}", pattern.id, runner.world().divergence());
                let state = runner.world().bodies()[0].state();
                let moved = Moved { rest: &rest, now: &state.positions, low, high };
                found.push(match pattern.id {
                    "worm" => -moved.bow(along, 1),
                    "tail" => -moved.bow(along, 2 - along),
                    "finger" => moved.bow(order[0], order[1]),
                    "rings" => 1.0 - moved.girth(false),
                    "spokes" => 1.0 - moved.girth(true),
                    "starfish" => moved.drawn_in(order[0]),
                    // What winds by the right hand turns its upper end to the left as it shortens.
                    "trunk" | "tentacle" => -moved.twist(),
                    other => panic!("nothing is known of {other}"),
                });
            }
            let name = format!("{:?} {}", body.shape.size(), pattern.id);
            println!("{name}: {held} fibres, {found:.4?}");
            // Of a figure a layout may stick out however far in it goes: what sticks out is left off.
            let is_figure = body.shape.size().is_none();
            let is_whole = held >= laid && discarded == 0;
            assert!(is_whole || (is_figure && held > 0), "{name}: {held} of {laid} fibres are left in it");
            // At the height of a swing, and where it is over: then those on the other side, if any, pull.
            let [pulled, over] = [found[0], found[1]];
            // A figure's limbs swing on: of it no more is asked than that each pattern moves it, and then the other
            // way.
            let has_others = matches!(pattern.id, "worm" | "tail" | "trunk" | "tentacle");
            let goes_back = match pattern.id {
                // One arm after the other does.
                "starfish" => true,
                _ if is_figure && has_others => over < 0.0,
                _ if is_figure => over.abs() < 0.5 * pulled.abs(),
                _ if has_others => over < -0.2 * pulled,
                _ => over < 0.25 * pulled,
            };
            let moves = if is_figure && pattern.id == "finger" { pulled.abs() > 1e-3 } else { pulled > 1e-3 };
            if !(moves && goes_back) {
                wrong.push(format!("{name}: {found:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}
