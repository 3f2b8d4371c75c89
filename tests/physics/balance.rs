//! The balance of energy and work: whatever is run under whatever step keeps it, or says that it does not.

use serde_json::{Value, json};
use sinew::bake::bake;
use sinew::io::scene_from_json;
use sinew::scene::{Assets, Scene};
use sinew::sim::{Report, Runner};

pub fn scene(value: &Value) -> Scene {
    let scene = scene_from_json(&value.to_string()).unwrap();
    scene.validate().unwrap();
    scene
}

pub fn runner(scene: &Scene) -> Runner {
    Runner::new(bake(scene, &Assets::default()).unwrap())
}

/// A block of 3 x `high` x 3 particles above the origin with layers at its ends.
fn solid(high: u32, young_modulus: f64) -> Value {
    let height = 0.006 * f64::from(high);
    json!({
        "id": "block", "name": "Block",
        "shape": {"box": {"center": [0, 0.5 * height, 0], "size": [0.018, height, 0.018]}},
        "material": {"young_modulus": young_modulus, "mass": {"per_particle": 2e-4}, "support_radius": 0.015},
        "regions": [
            {"id": "foot", "select": {"layers": {"axis": "y", "side": "min", "count": 1}}},
            {"id": "top", "select": {"layers": {"axis": "y", "side": "max", "count": 1}}}
        ]
    })
}

/// One or two of them, and whatever else is merged into the scene.
fn solids(bodies: &[Value], more: &Value) -> Value {
    let mut scene = json!({"version": 1, "gravity": [0, 0, 0], "bodies": bodies});
    merge(&mut scene, more);
    scene
}

fn merge(into: &mut Value, more: &Value) {
    for (key, value) in more.as_object().unwrap() {
        into[key] = value.clone();
    }
}

fn with(mut body: Value, more: &Value) -> Value {
    merge(&mut body, more);
    body
}

const FALLING: [f64; 3] = [0.0, -9.81, 0.0];
pub const KINDS: usize = 14;

fn fibre(high: u32, activation: &Value) -> Value {
    let line: Vec<[f64; 3]> = (0..high).map(|k| [0.002, 0.003 + 0.006 * f64::from(k), 0.001]).collect();
    let mut fibre = json!({
        "id": "strand", "source": {"vertices": line}, "stiffness": {"rigidity": {"ea": 20, "ei": 1e-5}}
    });
    merge(&mut fibre, activation);
    fibre
}

fn pins(motion: &Value) -> Value {
    json!([{"id": "hold", "region": "foot"}, {"id": "move", "region": "top", "motion": motion}])
}

/// A scene of some kind, of small bodies.
pub fn of_kind(kind: usize, high: u32, young_modulus: f64, [pair, air]: [f64; 2], speed: f64) -> Value {
    let mut block = solid(high, young_modulus);
    block["material"]["damping"] = json!({"pair": pair, "air": air});
    let thrown = json!({"initial": {"velocity": [0.1, -speed, 0.05], "angular_velocity": [300, 100, -200]}});
    let above = json!({"placement": {"translation": [0, 0.001, 0]}});
    let ball = json!({
        "id": "ball", "shape": {"ball": {"subdivisions": 1, "outer_radius": 0.2, "inner_radius": 0.1}},
        "ks": 80, "kd": 0.2 * pair.min(10.0), "rks": 80, "rkd": 0.2 * pair.min(10.0), "pressure": 2, "mass": 0.4,
        "air_drag": air, "initial": {"velocity": [0, -speed, 0]}, "placement": {"translation": [0, 0.25, 0]}
    });
    let balls = |ball: Value, more: &Value| {
        let mut scene = json!({"version": 1, "gravity": FALLING, "two_layer": [ball]});
        merge(&mut scene, more);
        scene
    };
    match kind {
        0 => solids(&[with(block, &thrown)], &json!({})),
        1 => solids(
            &[with(block, &json!({"initial": {"deformation": [[1.1, 0.05, 0], [0, 0.95, 0], [0, 0, 1]]}}))],
            &json!({}),
        ),
        2 => solids(&[with(with(block, &thrown), &above)], &json!({"gravity": FALLING, "room": {"floor": 0}})),
        3 => {
            let ramp = json!({"ramp": {"direction": [1, 0.5, 0], "distance": {"metres": 0.003}, "duration": 0.05}});
            solids(&[with(block, &json!({"pins": pins(&ramp)}))], &json!({"gravity": FALLING}))
        }
        4 => {
            let keys = json!({"keyframes": [
                {"time": 0, "offset": [0, 0, 0]}, {"time": 0.02, "offset": [0.002, 0, 0]},
                {"time": 0.04, "offset": [-0.002, 0, 0]}, {"time": 0.06, "offset": [0, 0, 0]}
            ]});
            let strand = fibre(high, &json!({}));
            solids(&[with(block, &json!({"pins": pins(&keys), "fibres": [strand]}))], &json!({}))
        }
        5 | 6 => {
            let top = 0.006 * f64::from(high) + 0.0005;
            let motion = if kind == 5 {
                json!({"driven": [{"time": 0, "height": top}, {"time": 0.1, "height": 0.85 * top}]})
            } else {
                json!("falls")
            };
            let panel = json!({"id": "lid", "height": top, "size": [0.1, 0.1], "mass": 0.02, "motion": motion});
            solids(&[block], &json!({"gravity": FALLING, "room": {"floor": 0}, "panels": [panel]}))
        }
        7 => {
            let other = with(
                block.clone(),
                &json!({"id": "other", "name": "Other", "placement": {"translation": [0.004, 0.006 * f64::from(high) + 0.002, 0]},
                    "initial": {"velocity": [0, -speed, 0]}}),
            );
            solids(&[block, other], &json!({}))
        }
        8 => balls(ball, &json!({"room": {"floor": 0}})),
        9 => {
            let drive = json!({"wave": {"mean": 1, "amplitude": 0.5, "period": 0.2}});
            balls(with(ball, &json!({"pressure_drive": drive})), &json!({"gravity": [0, 0, 0]}))
        }
        10 => {
            let act = json!({"activation": {"drive": {"wave": {"mean": 0.5, "amplitude": 0.5, "period": 0.1}}, "contract": 0.2}});
            let held = json!([{"id": "hold", "region": "foot"}]);
            solids(&[with(block, &json!({"pins": held, "fibres": [fibre(high, &act)]}))], &json!({}))
        }
        11 => {
            let drive = json!({"wave": {"mean": 1, "amplitude": 1, "period": 0.1}});
            solids(&[with(block, &above)], &json!({"gravity": FALLING, "gravity_drive": drive, "room": {"floor": 0}}))
        }
        12 => {
            let ram = json!({
                "id": "ram", "shape": {"capsule": {"radius": 0.006, "length": 0.05}},
                "placement": {"translation": [-0.018, 0.01, 0], "rotation": {"axis": [1, 0, 0], "degrees": 90}},
                "motion": {"ramp": {"direction": [1, 0, 0], "distance": {"metres": 0.02}, "duration": 0.05}}
            });
            solids(&[block], &json!({"gravity": FALLING, "room": {"floor": 0}, "colliders": [ram]}))
        }
        _ => balls(
            ball,
            &json!({"wind": {"velocity": [3, 0, 0], "drive": {"wave": {"period": 0.2}}, "density": 1.2, "drag": 1}}),
        ),
    }
}

fn run(value: &Value, seconds: f64) -> Runner {
    let mut runner = runner(&scene(value));
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
    }
    runner.look();
    runner
}

fn report(value: &Value, runner: &Runner) -> Value {
    json!(Report::new(&scene(value), runner, 0.0, Vec::new()))
}

/// A strained block in space that nothing damps, under an integrator in steps of so many seconds.
fn strained(integrator: &str, dt: f64, substeps: u32) -> Value {
    let mut value = of_kind(1, 4, 1e5, [0.0; 2], 0.0);
    value["bodies"][0]["integrator"] = json!(integrator);
    value["time"] = json!({"duration": 10, "step": {"manual": {"dt": dt, "substeps_per_frame": substeps}}});
    value
}

#[test]
fn a_gain_is_said_with_body_time_integrator_and_parameter_and_stops_the_body_past_the_bound() {
    let value = strained("explicit_euler", 1e-5, 40);
    let mut runner = runner(&scene(&value));
    let mut frames = 0;
    while runner.world().unbalanced().is_empty() && frames < 400 {
        runner.advance_frame();
        frames += 1;
    }
    let found = runner.world().unbalanced()[0].clone();
    println!("{found}");
    assert_eq!((found.body.as_deref(), found.stepped.0), (Some("Block"), "explicit_euler"));
    assert!(found.time > 0.0 && found.gained > 0.02 * found.handled && found.gained < 0.1 * found.handled, "{found:?}");
    let said = found.to_string();
    for part in ["\"Block\"", "explicit_euler", "1.00e-5 s", "/time/step/manual/dt", "/bodies/0/integrator"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert_eq!(report(&value, &runner)["unbalanced"][0], said);
    while runner.world().divergence().is_none() && frames < 4000 {
        runner.advance_frame();
        frames += 1;
    }
    let stopped = runner.world().divergence().unwrap();
    println!("{stopped}");
    assert!(stopped.cause.contains("that nothing gave, more than 100 %"), "{stopped}");
    assert!(stopped.remedy.contains("/time/step/manual/dt"), "{stopped}");
    // Long before a particle would have been seen to fly off.
    let strain = runner.world().energy();
    assert!(strain < 4.0 * found.handled, "{strain} J of {} J", found.handled);
    assert_eq!(runner.world().unbalanced().len(), 1);
}

/// Undamped, it would take steps of nanoseconds; damped, a step at which a second adds a hundredth at most.
#[test]
fn the_automatic_step_of_explicit_euler_is_one_that_keeps_the_balance_or_there_is_none() {
    let mut value = strained("explicit_euler", 1e-5, 1);
    value["time"] = json!({"duration": 1, "frames_per_second": 500});
    let refused = bake(&scene(&value), &Assets::default()).err().unwrap().to_string();
    println!("{refused}");
    for part in ["/time/frames_per_second", "steps of at most", "/bodies/0/integrator"] {
        assert!(refused.contains(part), "{part}: {refused}");
    }
    value["bodies"][0]["material"]["damping"] = json!({"air": 60});
    value["bodies"][0]["material"]["young_modulus"] = json!(1e3);
    value["time"]["frames_per_second"] = json!(2000);
    let runner = run(&value, 0.01);
    let accuracy = runner.world().accuracy_of(0).unwrap();
    println!("{accuracy:?}");
    assert_eq!(runner.world().unbalanced(), []);
    assert!(accuracy.change < 0.0 && accuracy.gained < 0.01 * accuracy.handled, "{accuracy:?}");
}

#[test]
fn what_is_done_by_hand_is_work_from_outside() {
    for integrator in ["leap_frog", "rk4", "midpoint", "tr_bdf2", "feynman"] {
        let mut value = of_kind(0, 4, 1e5, [3.0, 5.0], 0.1);
        value["bodies"][0]["integrator"] = json!(integrator);
        let mut runner = runner(&scene(&value));
        let mut most: f64 = 0.0;
        for frame in 0..24 {
            let body = runner.body_mut(0).unwrap();
            match frame % 8 {
                1 => body.strike(glam::DVec3::new(0.02, 0.01, -0.01)),
                3 => {
                    let (point, place) = (body.point(0).unwrap(), body.state().positions[0]);
                    body.grab(point, place + glam::DVec3::new(0.05, 0.02, 0.0));
                }
                _ => {}
            }
            if frame % 8 == 6 {
                runner.release_all();
            }
            runner.advance_frame();
            most = most.max(runner.world().energy());
        }
        runner.look();
        let accuracy = runner.world().accuracy_of(0).unwrap();
        println!("{integrator}: at most {most} J, {accuracy:?}");
        assert_eq!(runner.world().unbalanced(), [], "{integrator}");
        assert!(accuracy.gained < 0.01 * accuracy.handled, "{integrator}: {accuracy:?}");
    }
}

/// Two that collide in space: no momentum comes from nowhere, and leap-frog keeps the energy.
#[test]
fn a_report_has_what_a_run_cost_in_accuracy() {
    let mut value = of_kind(7, 4, 1e5, [0.0; 2], 0.5);
    value["room"] = json!({"friction": 0});
    let runner = run(&value, 0.1);
    let report = report(&value, &runner);
    println!("{}", report["accuracy"]);
    let number = |of: &Value, name: &str| of[name].as_f64().unwrap_or_else(|| panic!("{name} of {of}"));
    let momentum = runner.world().bodies().iter().map(|body| body.state().linear_momentum()).sum::<glam::DVec3>();
    for of in [&report["accuracy"], &report["bodies"][0]["accuracy"], &report["bodies"][1]["accuracy"]] {
        let (change, gained) = (number(of, "energy_change"), number(of, "energy_gained"));
        let handled = number(of, "energy_handled");
        assert!(handled > 1e-4 && gained < 0.02 * handled && change.abs() < 0.02 * handled, "{of}");
        let [linear, angular] = ["linear_momentum_drift", "angular_momentum_drift"].map(|name| number(of, name));
        assert!(linear < 1e-12 * momentum.length(), "{of}");
        assert!(angular < 1e-12 * momentum.length() * 0.02, "{of}");
        assert!((number(of, "followed_seconds") - 0.1).abs() < 1e-9, "{of}");
    }
    // What is held has other forces on it that nobody knows beforehand.
    let value = of_kind(3, 4, 1e5, [0.0; 2], 0.5);
    let of = &self::report(&value, &run(&value, 0.05))["bodies"][0]["accuracy"];
    assert!(of["linear_momentum_drift"].is_null() && of["energy_gained"].is_number(), "{of}");
}

/// The step is never so long that the watch does not see it: a copy of a run says the same, and so does one gone on
/// with.
#[test]
fn what_was_seen_goes_along_with_checkpoints() {
    let value = strained("explicit_euler", 1e-5, 40);
    let mut whole = runner(&scene(&value));
    (0..60).for_each(|_| whole.advance_frame());
    let mut parted = runner(&scene(&value));
    (0..25).for_each(|_| parted.advance_frame());
    let kept = parted.world().checkpoint();
    let mut world = parted.world().clone();
    (0..10).for_each(|_| world.advance_frame());
    world.go_back(&kept);
    (0..35).for_each(|_| world.advance_frame());
    assert_eq!(world.accuracy_of(0), whole.world().accuracy_of(0));
    assert_eq!(world.unbalanced(), whole.world().unbalanced());
    assert_eq!(world.unbalanced().len(), 1);
}

/// Landings at a step that resolves nothing of them, stiff and soft, with fibres and of two layers.
#[test]
fn backward_euler_wins_nothing_at_a_landing() {
    let mut cases = Vec::new();
    for young_modulus in [1e4, 6.76e5, 5e6] {
        let mut value = of_kind(2, 4, young_modulus, [0.0; 2], 1.5);
        value["bodies"][0]["fibres"] = json!([fibre(4, &json!({"stiffness": {"rigidity": {"ea": 2e3, "ei": 2e-3}}}))]);
        cases.push((value, "bodies"));
    }
    for stiffer in [1.0, 100.0] {
        let mut value = of_kind(8, 0, 0.0, [0.0; 2], 2.0);
        value["two_layer"][0]["ks"] = json!(80.0 * stiffer);
        value["two_layer"][0]["rks"] = json!(80.0 * stiffer);
        cases.push((value, "two_layer"));
    }
    for (mut value, bodies) in cases {
        value[bodies][0]["integrator"] = json!("backward_euler");
        value["time"] = json!({"duration": 1, "frames_per_second": 60});
        let mut runner = runner(&scene(&value));
        let start = runner.world().energy();
        let gas = runner.world().bodies()[0].energies(0.0).pressure;
        let mut highest = start;
        for _ in 0..24 {
            runner.advance_frame();
            highest = highest.max(runner.world().energy());
        }
        runner.look();
        let report = report(&value, &runner);
        let body = &report["bodies"][0];
        println!("{bodies}: {start} J, at most {highest} J, halved {}, {}", body["halved_steps"], body["accuracy"]);
        assert_eq!(body["diverged"], Value::Null);
        assert_eq!(report["unbalanced"], json!([]));
        // Energies of motion, of strain and of height; that of gas counts from anywhere.
        assert!(highest <= start + 0.01 * (start - gas).abs(), "{start} J, then {highest} J");
    }
}
