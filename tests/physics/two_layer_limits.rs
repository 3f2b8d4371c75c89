//! Stability limits of the time step, by estimate and by simulation, and orders of convergence.

use crate::two_layer::{ball, ring, segment, two_layer, with};
use serde_json::{Value, json};
use sinew::scene::{Assets, IntegratorKind, Scene};
use sinew::sim::{Study, Trial, convergence_order};

const EULER: IntegratorKind = IntegratorKind::ExplicitEuler;
const MIDPOINT: IntegratorKind = IntegratorKind::Midpoint;
const RK4: IntegratorKind = IntegratorKind::Rk4;
const SYMPLECTIC: IntegratorKind = IntegratorKind::SymplecticEuler;

fn estimate(scene: &Scene, integrator: IntegratorKind) -> f64 {
    trial(scene, integrator, 1e-3).stable_dt()
}

fn trial(scene: &Scene, integrator: IntegratorKind, dt: f64) -> Trial {
    Study::new(scene, &Assets::default()).unwrap().trial(integrator, dt)
}

/// Whether a small disturbance dies out under steps of `dt`.
fn calms(scene: &Scene, integrator: IntegratorKind, dt: f64) -> bool {
    let mut trial = trial(scene, integrator, dt);
    let mut early: f64 = 0.0;
    let mut last = 0.0;
    for step in 0..4000 {
        // By positions: a mode that swings to and fro in every step hides from leap-frog's velocities.
        let before = trial.world().bodies()[0].state().positions.clone();
        trial.step();
        if trial.blew_up_at().is_some() {
            return false;
        }
        let now = &trial.world().bodies()[0].state().positions;
        last = before.iter().zip(now).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        if step < 20 {
            early = early.max(last);
        }
    }
    last < 0.03 * early
}

#[test]
fn limits_of_the_step_are_those_of_the_formulation() {
    let table: [(Value, [f64; 4]); 3] = [
        (segment(), [0.01875, 0.0450, 0.0683, 0.0347]),
        (ring(), [0.01034, 0.01034, 0.01439, 0.00894]),
        (ball(1), [0.00543, 0.00543, 0.00757, 0.00499]),
    ];
    let disturbed = json!({"initial": {"deformation": [[1.01, 0.004, 0], [0, 0.993, 0], [0, 0, 1]]}});
    for (body, limits) in table {
        let scene = two_layer(&[with(body.clone(), disturbed.clone())], json!({}));
        for (integrator, limit) in [EULER, MIDPOINT, RK4, SYMPLECTIC].into_iter().zip(limits) {
            let estimated = estimate(&scene, integrator);
            println!("{} {integrator:?}: {estimated:.5} s estimated, {limit} s expected", body["shape"]);
            assert!((estimated / limit - 1.0).abs() < 0.01, "{integrator:?}: {estimated}, not {limit}");
            assert!(calms(&scene, integrator, 0.98 * limit), "{integrator:?} at {limit}");
            assert!(!calms(&scene, integrator, 1.02 * limit), "{integrator:?} at {limit}");
        }
    }
}

#[test]
fn leap_frog_and_verlet_too_are_stable_up_to_their_estimates() {
    let disturbed = json!({"initial": {"deformation": [[1.01, 0.004, 0], [0, 0.993, 0], [0, 0, 1]]}});
    for body in [segment(), ring(), ball(1)] {
        let scene = two_layer(&[with(body, disturbed.clone())], json!({}));
        for integrator in [IntegratorKind::LeapFrog, IntegratorKind::Verlet] {
            let limit = estimate(&scene, integrator);
            assert!(calms(&scene, integrator, 0.98 * limit), "{integrator:?} at {limit}");
            assert!(!calms(&scene, integrator, 1.02 * limit), "{integrator:?} at {limit}");
        }
    }
}

#[test]
fn backward_euler_is_stable_at_any_step() {
    let scene = two_layer(
        &[with(ball(1), json!({"initial": {"deformation": [[1.3, 0, 0], [0, 0.8, 0], [0, 0, 1]]}}))],
        json!({}),
    );
    assert_eq!(estimate(&scene, IntegratorKind::BackwardEuler), f64::INFINITY);
    for dt in [0.03, 0.3, 3.0] {
        let mut trial = trial(&scene, IntegratorKind::BackwardEuler, dt);
        for _ in 0..300 {
            trial.step();
        }
        assert_eq!(trial.blew_up_at(), None, "{dt}");
        let kinetic = trial.world().bodies()[0].state().kinetic_energy();
        assert!(kinetic < 1e-6, "{dt}: {kinetic} J");
    }
}

#[test]
fn orders_of_convergence_in_free_oscillation() {
    let oscillating = json!({"initial": {"deformation": [[1.2, 0, 0], [0, 0.9, 0], [0, 0, 1]]}});
    let undamped = json!({"kd": 0, "rkd": 0});
    let damped_scene = two_layer(&[with(ring(), oscillating.clone())], json!({}));
    let free_scene = two_layer(&[with(with(ring(), oscillating), undamped)], json!({}));
    let (dts, seconds) = ([5e-4, 1e-3, 2e-3], 0.4);
    let fit = |scene: &Scene, integrator| {
        let exact = Study::new(scene, &Assets::default()).unwrap().reference(seconds, dts[0]);
        let points = dts.map(|dt| {
            let mut trial = trial(scene, integrator, dt);
            for _ in 0..(seconds / dt).round() as u32 {
                trial.step();
            }
            (dt, trial.position_error(&exact))
        });
        convergence_order(&points).unwrap()
    };
    for (integrator, expected) in [
        (EULER, 1.0),
        (MIDPOINT, 2.0),
        (RK4, 4.0),
        (SYMPLECTIC, 1.0),
        (IntegratorKind::BackwardEuler, 1.0),
        (IntegratorKind::Verlet, 2.0),
        (IntegratorKind::TrBdf2, 2.0),
        (IntegratorKind::Sdirk2, 2.0),
        (IntegratorKind::ImplicitMidpoint, 2.0),
        (IntegratorKind::Bdf2, 2.0),
        (IntegratorKind::Newmark, 2.0),
    ] {
        let found = fit(&damped_scene, integrator);
        println!("{integrator:?}: {found:.3}");
        assert!((found - expected).abs() < 0.2, "{integrator:?}: {found}");
    }
    // Kick-drift-kick is of order 2 where nothing damps.
    let found = fit(&free_scene, IntegratorKind::LeapFrog);
    assert!((found - 2.0).abs() < 0.1, "{found}");
}

/// Which pairs of integrator and step stay stable: rows Euler, midpoint, Runge-Kutta, columns 0.003, 0.03, 0.3 s.
fn stable(scene: &Scene, seconds: f64) -> [[bool; 3]; 3] {
    [EULER, MIDPOINT, RK4].map(|integrator| {
        [0.003, 0.03, 0.3].map(|dt| {
            let mut trial = trial(scene, integrator, dt);
            for _ in 0..(seconds / dt).round() as u32 {
                trial.step();
            }
            trial.blew_up_at().is_none()
        })
    })
}

#[test]
fn the_papers_claims_hold_for_two_sets_of_parameters_and_not_for_its_defaults() {
    for shape in [json!({"ring": {}}), json!({"ball": {}})] {
        let of = |fields: Value, g: f64| {
            let body = with(json!({"shape": shape}), fields);
            let room = json!({"floor": -5, "ceiling": 5, "x_min": -5, "x_max": 5, "z_min": -5, "z_max": 5});
            two_layer(&[body], json!({"gravity": [0, -g, 0], "room": room}))
        };
        let claims = [[true, false, false], [true, true, false], [true, true, true]];
        let stiff = stable(&of(json!({"ks": 800, "rks": 800, "kd": 15, "rkd": 15, "mass": 2}), 9.81), 5.0);
        assert_eq!(stiff.map(|row| [row[0], row[1]]), claims.map(|row| [row[0], row[1]]));
        let soft = json!({"ks": 10, "rks": 8.75, "kd": 0.1, "rkd": 0.0875, "pressure": 0.25,
            "contact": {"kc": 60, "cc": 0.5, "ct": 0.5}});
        assert_eq!(stable(&of(soft, 0.1), 30.0), claims);
        let defaults = stable(&of(json!({}), 9.81), 5.0);
        assert_eq!(defaults.map(|row| row[1]), [false; 3], "no integrator takes 0.03 s at the defaults");
    }
}

#[test]
fn a_single_layer_blows_up_under_euler_where_two_hold() {
    let body = |single: bool| {
        json!({"shape": {"ring": {"single_layer": single}},
            "initial": {"deformation": [[1.05, 0, 0], [0, 0.95, 0], [0, 0, 1]]}})
    };
    let blew_up = |single: bool| {
        let scene = two_layer(&[body(single)], json!({"gravity": [0, -9.81, 0], "room": {"floor": -5}}));
        let mut trial = trial(&scene, EULER, 0.005);
        for _ in 0..2000 {
            trial.step();
        }
        trial.blew_up_at()
    };
    assert!(blew_up(true).is_some() && blew_up(false).is_none());
}
