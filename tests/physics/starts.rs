//! Bodies that overlap at the start, each other, the room or a panel: eased apart, and nothing is thrown.

use crate::common::{block, in_space, runner};
use crate::two_layer::{ball, ring, two_layer, with};
use glam::DVec3;
use serde_json::json;
use sinew::scene::{Body, Panel, Scene, TimeStep};
use sinew::sim::Runner;
use sinew::solver::Against;

/// What a run showed.
struct Course {
    runner: Runner,
    /// Total energy at the start and the greatest one after it [J].
    energies: [f64; 2],
    /// Greatest speed of a body's centre [m/s].
    fastest: f64,
    /// Greatest height of a body's centre [m].
    highest: f64,
    /// Change of the total linear momentum [kg m/s].
    drift: DVec3,
    /// Change of the total angular momentum about the origin [kg m²/s].
    turned: DVec3,
}

fn total_energy(runner: &Runner) -> f64 {
    let world = runner.world();
    world.bodies().iter().map(|body| body.energies(world.time()).total()).sum()
}

fn momentum(runner: &Runner) -> DVec3 {
    runner.world().bodies().iter().map(|body| body.state().linear_momentum()).sum()
}

fn angular_momentum(runner: &Runner) -> DVec3 {
    runner.world().bodies().iter().map(|body| body.state().angular_momentum()).sum()
}

fn course(scene: &Scene, seconds: f64) -> Course {
    let mut runner = runner(scene);
    let (start, before, turning) = (total_energy(&runner), momentum(&runner), angular_momentum(&runner));
    let (mut greatest, mut fastest, mut highest) = (f64::NEG_INFINITY, 0.0_f64, f64::NEG_INFINITY);
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
        greatest = greatest.max(total_energy(&runner));
        for body in runner.world().bodies() {
            let state = body.state();
            fastest = fastest.max((state.linear_momentum() / state.mass()).length());
            highest = highest.max(state.center().y);
        }
    }
    let drift = momentum(&runner) - before;
    let turned = angular_momentum(&runner) - turning;
    Course { runner, energies: [start, greatest], fastest, highest, drift, turned }
}

impl Course {
    /// Nothing is gained and nothing is thrown; gives the greatest speed of the easing [m/s].
    fn is_gentle(&self, named: &str) -> f64 {
        let easings = self.runner.world().overlaps().iter().filter_map(|overlap| overlap.easing);
        let eased = easings.map(|easing| easing.speed()).fold(0.0, f64::max);
        let [start, greatest] = self.energies;
        println!(
            "{named}: {start:.4e} J, then at most {greatest:.4e} J; {:.3} m/s, eased at {eased:.3} m/s; drift {:.1e}, {:.1e}",
            self.fastest,
            self.drift.length(),
            self.turned.length() / self.carried()
        );
        assert!(eased > 0.0, "{named}: it is eased");
        assert!(self.turned.length() < 0.15 * self.carried(), "{named}: it turned by {}", self.turned);
        assert!(greatest <= start + 0.01 * start.abs(), "{named}: {start} J, then {greatest} J");
        eased
    }

    /// What the bodies carry past each other [kg m²/s]: momentum of the lighter one times the way out.
    fn carried(&self) -> f64 {
        let world = self.runner.world();
        let mass = world.bodies().iter().map(|body| body.state().mass()).fold(f64::MAX, f64::min);
        let eased = world.overlaps().iter().filter_map(|overlap| overlap.easing);
        mass * eased.map(|easing| easing.speed() * easing.distance).fold(0.0, f64::max)
    }

    fn gap(&self) -> f64 {
        let positions = |k: usize| &self.runner.world().bodies()[k].state().positions;
        let distances = positions(0).iter().flat_map(|a| positions(1).iter().map(move |b| a.distance(*b)));
        distances.fold(f64::INFINITY, f64::min)
    }
}

fn cube(id: &str, at: [f64; 3]) -> Body {
    Body { id: id.into(), ..block([5, 5, 5], 2e5) }.with_translation(at)
}

fn two_cubes(apart: [f64; 3], safety: Option<f64>) -> Scene {
    let mut scene = in_space(cube("one", [0.0; 3]));
    scene.bodies.push(cube("other", apart));
    if let (Some(safety), TimeStep::Automatic(step)) = (safety, &mut scene.time.step) {
        step.safety = safety;
    }
    scene
}

#[test]
fn solids_that_overlap_are_eased_apart_without_gaining_energy() {
    let offsets = [
        ("half, on the lattice", [0.0, 0.012, 0.0]),
        ("half, off it", [0.0153, 0.002, 0.001]),
        ("coincident", [0.0; 3]),
    ];
    for (name, apart) in offsets {
        for safety in [0.8, 0.3] {
            let scene = two_cubes(apart, Some(safety));
            let course = course(&scene, 0.5);
            let speed = course.is_gentle(name);
            assert!(course.fastest < 1.2 * speed, "{name}: {} m/s", course.fastest);
            assert!(course.drift.length() < 1e-13, "{name}: {}", course.drift);
            assert!(course.gap() > 0.9 * 0.006, "{name}: {} m left between particles", course.gap());
        }
    }
}

#[test]
fn two_layer_bodies_that_overlap_are_eased_apart_without_gaining_energy() {
    for (name, body, apart) in [
        ("balls, deep", ball(1), [0.3, 1.0, 0.0]),
        ("balls, half", ball(2), [2.0, 0.1, 0.2]),
        ("balls, coincident", ball(1), [0.0; 3]),
        ("rings", ring(), [1.5, 0.2, 0.0]),
    ] {
        for dt in [1e-3, 4e-3] {
            let bodies = [body.clone(), with(body.clone(), json!({"placement": {"translation": apart}}))];
            let mut scene = two_layer(&bodies, json!({"room": {"friction": 0}}));
            scene.time.step = TimeStep::manual(dt, (1.0 / 60.0 / dt).round() as u32);
            let course = course(&scene, 6.0);
            let speed = course.is_gentle(name);
            assert!(course.fastest < 1.2 * speed, "{name}: {} m/s", course.fastest);
            assert!(course.drift.length() < 1e-11, "{name}: {}", course.drift);
            let centers = course.runner.world().bodies().iter().map(|body| body.state().center());
            let centers: Vec<DVec3> = centers.collect();
            assert!(centers[0].distance(centers[1]) > 3.5, "{name}: {centers:?}");
        }
    }
}

#[test]
fn a_solid_and_a_ball_that_overlap_are_eased_apart() {
    let mut scene = two_layer(&[with(ball(2), json!({"placement": {"translation": [1.5, 0, 0]}}))], json!({}));
    let mut large = block([5, 5, 5], 2e5);
    large.shape = sinew::scene::BoxShape::new([2.0; 3]).into();
    large.material = sinew::scene::Material::new(2e5, 0.33, 100.0).with_support_radius(1.0);
    scene.bodies.push(large);
    let course = course(&scene, 5.0);
    let speed = course.is_gentle("solid and ball");
    assert!(course.fastest < 2.0 * speed, "{} m/s", course.fastest);
    let overlaps = course.runner.world().overlaps();
    assert!(overlaps.len() == 1 && overlaps[0].against == Against::Body(0), "{overlaps:?}");
}

#[test]
fn bodies_in_the_floor_are_lifted_out_and_stay_on_it() {
    for depth in [0.5, 1.0, 3.0] {
        let mut scene = in_space(cube("one", [0.0, -0.03 * depth, 0.0])).with_gravity([0.0, -9.81, 0.0]);
        scene.room.floor = Some(0.0);
        scene.room.contact_damping = 0.2;
        let course = course(&scene, 1.0);
        course.is_gentle("solid in the floor");
        // Its centre rests at half its height.
        assert!(course.highest < 0.0155 + 0.1 * 0.03 * depth, "{depth}: it rose to {} m", course.highest);
        let center = course.runner.world().bodies()[0].state().center().y;
        assert!((center - 0.0148).abs() < 1e-3, "{depth}: {center} m");
    }
    for (name, y, law) in
        [("half", 0.0, "penalty"), ("wholly", -3.0, "penalty"), ("half, put back", 0.0, "paper_reset")]
    {
        let body = with(ball(1), json!({"placement": {"translation": [0, y, 0]}, "contact": {"law": law}}));
        let scene = two_layer(&[body], json!({"gravity": [0, -9.81, 0], "room": {"floor": 0}}));
        let course = course(&scene, 6.0);
        course.is_gentle(name);
        assert!(course.highest < 2.0 + 0.1 * (2.0 - y), "{name}: it rose to {} m", course.highest);
        let lowest = course.runner.world().bodies()[0].state().positions.iter().map(|x| x.y).fold(f64::MAX, f64::min);
        assert!(lowest > -0.3, "{name}: {lowest} m");
    }
}

#[test]
fn a_ball_in_a_panel_is_eased_out_below_it() {
    let mut scene = two_layer(&[ball(2)], json!({"room": {"floor": -6}}));
    scene.panels.push(Panel::driven("lid", [8.0, 8.0], [(0.0, 0.5)]));
    let course = course(&scene, 4.0);
    let speed = course.is_gentle("ball in a panel");
    assert!(course.fastest < 2.0 * speed, "{} m/s", course.fastest);
    let top = course.runner.world().bodies()[0].state().positions.iter().map(|x| x.y).fold(f64::MIN, f64::max);
    assert!(top < 0.6, "{top} m");
}

#[test]
fn what_only_touches_or_rests_is_left_alone() {
    let mut scene = in_space(cube("one", [0.0; 3]));
    scene.bodies.push(cube("other", [0.0, 0.03, 0.0]));
    scene.room.floor = Some(0.0);
    assert_eq!(runner(&scene).world().overlaps(), []);
    let balls = [ball(1), with(ball(1), json!({"placement": {"translation": [0, 4, 0]}}))];
    let scene = two_layer(&balls, json!({"room": {"floor": -2}}));
    assert_eq!(runner(&scene).world().overlaps(), []);
    // A ball that has sunk into the floor as far as its weight takes it rests there.
    let scene = two_layer(&[ball(1)], json!({"gravity": [0, -9.81, 0], "room": {"floor": -1.93}}));
    assert_eq!(runner(&scene).world().overlaps(), []);
}

#[test]
fn easing_goes_on_from_a_checkpoint_bit_for_bit() {
    let mut scene = two_cubes([0.0, 0.012, 0.0], None);
    scene.room.floor = Some(0.01);
    let mut straight = runner(&scene);
    for _ in 0..4 {
        straight.advance_frame();
    }
    let kept = straight.world().checkpoint();
    let mut again = runner(&scene).world().clone();
    again.go_back(&kept);
    let mut world = straight.world().clone();
    for _ in 0..6 {
        world.advance_frame();
        again.advance_frame();
    }
    for (one, other) in world.bodies().iter().zip(again.bodies()) {
        assert_eq!(one.state(), other.state());
    }
}

#[test]
fn a_body_put_into_another_by_an_edit_is_eased_out_and_touches_of_the_motion_go_on() {
    let scene = two_cubes([0.0, 0.06, 0.0], None).with_gravity([0.0, -9.81, 0.0]);
    let mut moving = runner(&scene);
    for _ in 0..3 {
        moving.advance_frame();
    }
    let mut same = runner(&scene);
    same.adopt(&moving);
    assert_eq!(same.world().overlaps(), []);
    let mut edited = scene.clone();
    edited.bodies[1].placement.translation = [0.0, 0.005, 0.0];
    let mut edited = runner(&edited);
    edited.adopt(&moving);
    let overlaps = edited.world().overlaps();
    assert!(overlaps.len() == 1 && overlaps[0].easing.is_some(), "{overlaps:?}");
    assert!(overlaps[0].easing.unwrap().end() > edited.world().time());
}
