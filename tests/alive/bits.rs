//! What is there and changes nothing changes no bit.

use crate::common::*;
use glam::DVec3;
use serde_json::{Value, json};
use sinew::io::scene_from_json;
use sinew::scene::{
    Activation, ActiveSprings, DriveKeys, RestShape, Scene, SharedDrive, Stiffness, TimeStep, TwoLayer, Wave, Wind,
};

/// A bar with a straight fibre and a curved one, and a ring with gas, which fall in a wind.
fn falling() -> Scene {
    let mut bar = block([4, 7, 4], 5e4);
    let line = |x: f64, bow: f64| {
        let at = |k: u32| {
            let s = f64::from(k) / 6.0;
            [x + bow * s * (1.0 - s), D * (0.5 + 6.0 * s), 0.0]
        };
        (0..=6).map(at).collect::<Vec<_>>()
    };
    let stiff = rigidity(20.0, 2e-4);
    bar.fibres.push(fibre("straight", line(0.5 * D, 0.0), stiff.clone(), 0.25, RestShape::Straight));
    bar.fibres.push(fibre("curved", line(-D, 0.01), stiff, 0.25, RestShape::AsDrawn));
    let ring = TwoLayer::ring("ring").with_translation([0.0, 2.4, 0.0]);
    let mut scene = Scene::new("fall").with_floor(-0.002).with_body(bar).with_two_layer(ring);
    scene.wind = Some(Wind::new([2.0, 0.0, 1.0]));
    scene.time.step = TimeStep::manual(2e-4, 40);
    scene
}

/// All that there is of a motion after some frames.
fn bits(scene: &Scene) -> Vec<u64> {
    let mut runner = runner(scene);
    (0..6).for_each(|_| runner.advance_frame());
    let world = runner.world();
    assert!(world.divergence().is_none(), "{:?}", world.divergence());
    let states = world.bodies().iter().map(sinew::solver::Body::state);
    let places = states.flat_map(|state| state.positions.iter().chain(&state.velocities)).flat_map(DVec3::to_array);
    places.chain(world.bodies().iter().flat_map(|body| body.tensions().concat())).map(f64::to_bits).collect()
}

/// A change by its name.
type Change<'a> = (&'a str, &'a dyn Fn(&mut Scene));

#[test]
fn drives_and_stiffnesses_that_change_nothing_change_no_bit() {
    let plain = falling();
    let before = bits(&plain);
    let twisting = |stiffness: &Stiffness, gj: f64| {
        let Stiffness::Rigidity(rigidity) = stiffness else { panic!("a rigidity") };
        Stiffness::from(rigidity.clone().with_twisting(gj))
    };
    let cases: &[Change<'_>] = &[
        ("gravity times one", &|scene| scene.gravity_drive = Some(1.0.into())),
        ("gravity by keys", &|scene| scene.gravity_drive = Some(DriveKeys::new([(0.0, 1.0), (0.05, 1.0)]).into())),
        ("wind times one", &|scene| scene.wind.as_mut().expect("wind").drive = Some(1.0.into())),
        ("gas times one", &|scene| scene.two_layer[0].pressure_drive = Some(1.0.into())),
        ("a shared drive that nothing follows", &|scene| {
            scene.bodies[0].drives.push(SharedDrive::new("idle", Wave::new(0.3)));
            scene.two_layer[0].drives.push(SharedDrive::new("idle", 0.5));
        }),
        ("no twisting stiffness", &|scene| {
            for fibre in &mut scene.bodies[0].fibres {
                fibre.stiffness = twisting(&fibre.stiffness, 0.0);
            }
        }),
        ("springs that shorten by nothing", &|scene| {
            scene.two_layer[0].active_springs.push(ActiveSprings::new("idle", "everything", 0.0, 1.0));
        }),
        ("a fibre that shortens by nothing", &|scene| {
            scene.bodies[0].fibres[1].activation = Some(Activation::contracting(0.0, Wave::new(0.3)));
        }),
    ];
    for (name, change) in cases {
        let mut scene = plain.clone();
        change(&mut scene);
        assert!(bits(&scene) == before, "{name}");
    }
    // One that does something does.
    let mut scene = plain.clone();
    scene.gravity_drive = Some(1.000_001.into());
    assert_ne!(bits(&scene), before);
}

/// Fields of a file that are there and empty, or of the value that they have anyway.
#[test]
fn fields_that_are_empty_change_no_bit() {
    let plain = serde_json::to_value(falling()).expect("a document");
    let mut full = plain.clone();
    let put = |at: &mut Value, name: &str, value: Value| {
        let before = at.as_object_mut().expect("an object").insert(name.to_owned(), value.clone());
        assert!(before.is_none_or(|before| before == value), "{name} is not what it is anyway");
    };
    for body in ["/bodies/0", "/two_layer/0"] {
        let body = full.pointer_mut(body).expect("a body");
        put(body, "drives", json!([]));
        put(body, "follows", json!([]));
    }
    put(full.pointer_mut("/two_layer/0").expect("a ring"), "active_springs", json!([]));
    for list in ["elements", "sheets", "voids", "seams"] {
        put(full.pointer_mut("/bodies/0").expect("a bar"), list, json!([]));
    }
    for fibre in 0..2 {
        let fibre = full.pointer_mut(&format!("/bodies/0/fibres/{fibre}")).expect("a fibre");
        put(fibre, "activation", Value::Null);
        put(fibre.pointer_mut("/stiffness/rigidity").expect("a rigidity"), "gj", json!(0));
    }
    put(&mut full, "gravity_drive", Value::Null);
    let [plain, full] = [plain, full].map(|scene| scene_from_json(&scene.to_string()).expect("a scene"));
    assert_eq!(bits(&full), bits(&plain));
}
