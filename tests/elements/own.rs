//! Elements of a program's own: they are tried before they act.

use crate::common::*;
use crate::{E, element_force, stored};
use glam::DVec3;
use sinew::bake::{BakeError, OwnElements, bake_with_elements};
use sinew::scene::{Assets, Wave};
use sinew::sim::Runner;
use sinew::solver::{Change, Element, ElementFault, Local, Slopes, check_element};

/// A spring between two points, and what may be wrong with one.
#[derive(Clone)]
struct Rope {
    points: Vec<u32>,
    turns: Vec<u32>,
    /// [N/m]
    stiffness: f64,
    rest: f64,
    majorant: f64,
    fault: Fault,
    breaks_at: f64,
    wanted: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Fault {
    None,
    /// Slopes a hundredth too steep.
    Steep,
    /// Held by a nail in space.
    Nailed,
    /// Turned about an axis of space.
    Wound,
    /// Energy without a number.
    Lost,
}

impl Rope {
    fn new(stiffness: f64, rest: f64) -> Self {
        Self {
            points: vec![0, 1],
            turns: Vec::new(),
            stiffness,
            rest,
            majorant: 2.0 * stiffness,
            fault: Fault::None,
            breaks_at: f64::INFINITY,
            wanted: 1.0,
        }
    }
}

impl Element for Rope {
    fn points(&self) -> &[u32] {
        &self.points
    }

    fn turns(&self) -> &[u32] {
        &self.turns
    }

    fn energy(&self, at: &Local<'_>) -> f64 {
        let longer = at.points[0].distance(at.points[1]) - self.wanted * self.rest;
        let own = 0.5 * self.stiffness * longer * longer;
        match self.fault {
            Fault::None | Fault::Steep => own,
            Fault::Nailed => own + 0.5 * self.stiffness * at.points[0].length_squared(),
            Fault::Wound => own + 0.5 * self.stiffness * (at.points[1].x - at.points[0].x).powi(2),
            Fault::Lost => f64::NAN,
        }
    }

    fn slopes(&self, at: &Local<'_>, out: &mut Slopes<'_>) {
        let edge = at.points[1] - at.points[0];
        let mut pull = self.stiffness * (edge.length() - self.wanted * self.rest) * edge.normalize_or_zero();
        match self.fault {
            Fault::None | Fault::Lost => {}
            Fault::Steep => pull *= 1.01,
            Fault::Nailed => out.points[0] += self.stiffness * at.points[0],
            Fault::Wound => pull.x += self.stiffness * edge.x,
        }
        out.points[0] -= pull;
        out.points[1] += pull;
    }

    fn majorant(&self) -> f64 {
        self.majorant
    }

    fn activate(&mut self, value: f64) {
        self.wanted = 1.0 - 0.3 * value;
    }

    fn end_step(&mut self, at: &Local<'_>) -> Change {
        if at.points[0].distance(at.points[1]) > self.breaks_at { Change::Broken } else { Change::None }
    }

    fn clone_box(&self) -> Box<dyn Element> {
        Box::new(self.clone())
    }
}

const ENDS: [DVec3; 2] = [DVec3::new(0.0, 1.5 * D, 0.0), DVec3::new(0.0, 3.5 * D, 0.0)];

fn bake(own: &[OwnElements]) -> Result<sinew::bake::Baked, BakeError> {
    bake_with_elements(&in_space(block([4, 5, 4], E)), &Assets::default(), own)
}

fn of(rope: &Rope) -> OwnElements {
    OwnElements::new("block", "ropes", ENDS, vec![Box::new(rope.clone())])
}

#[test]
fn every_fault_is_refused_with_its_figure() {
    let sound = Rope::new(100.0, 2.0 * D);
    assert_eq!(check_element(&sound, &ENDS), Ok(()));
    let faulty = |fault: Fault| Rope { fault, majorant: f64::INFINITY, ..sound.clone() };
    let found = |rope: &Rope| check_element(rope, &ENDS).expect_err("a fault");
    match found(&faulty(Fault::Steep)) {
        ElementFault::Slopes(off) => assert!((1e-4..0.1).contains(&off), "{off}"),
        other => panic!("{other}"),
    }
    assert!(matches!(found(&faulty(Fault::Nailed)), ElementFault::Sum(of) if of > 1e-3));
    assert!(matches!(found(&faulty(Fault::Wound)), ElementFault::Torque(of) if of > 1e-3));
    assert!(matches!(found(&faulty(Fault::Lost)), ElementFault::NoNumber(_)));
    let soft = Rope { majorant: 120.0, ..sound.clone() };
    assert!(matches!(found(&soft), ElementFault::Majorant { found, said: 120.0 } if found > 120.0));
    assert_eq!(found(&Rope { points: vec![0, 2], ..sound.clone() }), ElementFault::Point(2));
    assert_eq!(found(&Rope { points: vec![0, 0], ..sound.clone() }), ElementFault::Point(0));
    assert_eq!(found(&Rope { points: vec![], ..sound.clone() }), ElementFault::Points(0));
    // Baking refuses it with the body's pointer and the figure.
    let refused = bake(&[of(&faulty(Fault::Steep))]).map(drop).expect_err("a fault").to_string();
    assert!(refused.starts_with("/bodies/0: ropes, element 0 is refused: its slopes are"), "{refused}");
    let lost = OwnElements::new("nobody", "ropes", ENDS, Vec::new());
    assert!(matches!(bake(&[lost]).map(drop), Err(BakeError::NoBodyOfElements { .. })));
    let far = OwnElements::new("block", "ropes", [ENDS[0], DVec3::Y], vec![Box::new(sound)]);
    let refused = bake(&[far]).map(drop).expect_err("far away").to_string();
    assert!(refused.contains("from the nearest particle"), "{refused}");
}

#[test]
fn ones_own_rope_is_the_built_in_one_in_step_and_motion() {
    use sinew::scene::{Element as SceneElement, ElementLaw, ElementMeasure};
    let stiffness = 300.0 * E * D;
    let own = bake(&[of(&Rope::new(stiffness, 2.0 * D))]).expect("a sound rope");
    let built_in = SceneElement::new(
        "rope",
        ElementMeasure::Length,
        ENDS.map(|end| end.to_array()),
        ElementLaw::spring(stiffness * 2.0 * D),
    );
    let other = baked(&in_space(block([4, 5, 4], E).with_element(built_in)));
    let steps = [&own, &other].map(|baked| baked.world.bodies()[0].parts().stable_dt);
    assert!((steps[0] / steps[1] - 1.0).abs() < 1e-9, "{steps:?}");
    let x: Vec<DVec3> = other.world.bodies()[0].state().positions.iter().map(|x| *x * 1.1).collect();
    let [one, two] = [&own, &other].map(|baked| stored(&*element_force(&baked.world.bodies()[0]), 0.0, &x).elements);
    assert!((one / two - 1.0).abs() < 1e-12 && one > 0.0, "{one} and {two}");
    // It is softer without: the step was measured with it.
    assert!(steps[0] < 0.8 * bake(&[]).expect("a block").world.bodies()[0].parts().stable_dt);
}

#[test]
fn one_that_is_driven_books_its_work_and_one_that_breaks_is_gone_for_good() {
    let wave = Wave { mean: 0.5, amplitude: 0.5, ..Wave::new(0.05) };
    let driven = of(&Rope::new(10.0 * E * D, 2.0 * D)).driven(wave);
    let mut runner = Runner::new(bake(&[driven]).expect("a sound rope"));
    (0..5).for_each(|_| runner.advance_frame());
    let energies = runner.world().bodies()[0].energies(runner.world().time());
    assert!(energies.elements > 0.0 && -energies.activation > 1e-6, "{energies:?}");
    assert!(energies.total().abs() < 0.02 * -energies.activation, "{energies:?}");

    let weak = Rope { breaks_at: 2.1 * D, ..Rope::new(10.0 * E * D, 2.0 * D) };
    let mut scene = in_space(block([4, 5, 4], E));
    scene.bodies[0].initial.deformation = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 1.0]];
    let baked = bake_with_elements(&scene, &Assets::default(), &[of(&weak)]).expect("a sound rope");
    let mut runner = Runner::new(baked);
    let stored = |runner: &Runner| runner.world().bodies()[0].energies(runner.world().time()).elements;
    assert!(stored(&runner) > 0.0);
    let start = runner.world().checkpoint();
    runner.advance_frame();
    assert_eq!(stored(&runner), 0.0, "it broke in the first step");
    // A checkpoint of before has it whole.
    let after: Vec<DVec3> = runner.world().bodies()[0].state().positions.clone();
    let mut world = runner.world().clone();
    world.go_back(&start);
    assert!(world.bodies()[0].energies(world.time()).elements > 0.0);
    world.advance_frame();
    assert_eq!(world.bodies()[0].state().positions, after);
}
