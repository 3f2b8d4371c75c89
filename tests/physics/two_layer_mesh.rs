//! Two-layer bodies of any closed mesh: against the ball, the virial theorem, and each other.

use crate::two_layer::{ball, two_layer, with};
use glam::DVec3;
use serde_json::{Value, json};
use sinew::bake::{Baked, bake};
use sinew::geometry::Solid;
use sinew::geometry::{MeshData, Model};
use sinew::io::{load_assets, load_scene};
use sinew::scene::{Assets, Scene, TwoLayerShape};
use sinew::sim::Runner;
use sinew::solver::Body;
use sinew::solver::Energies;
use sinew::solver::SpringKind;
use sinew::test_support::geometry::sphere;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

/// The octahedron subdivided once, of radius 2, as files have it: every face with corners of its own.
fn split_sphere() -> Model {
    let mesh = sphere(1);
    let corners = mesh.triangles.iter().flatten().map(|&i| 2.0 * mesh.positions[i as usize]);
    let count = 3 * mesh.triangles.len() as u32;
    single(corners.collect(), (0..count / 3).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect())
}

/// A torus about the Y axis, `n` vertices around it, `m` around its section.
fn torus(n: u32, m: u32, large: f64, small: f64) -> Model {
    let at = |k: u32| {
        let (u, v) = (TAU * f64::from(k / m) / f64::from(n), TAU * f64::from(k % m) / f64::from(m));
        let out = large + small * v.cos();
        DVec3::new(out * u.cos(), small * v.sin(), -out * u.sin())
    };
    let index = |i: u32, j: u32| (i % n) * m + j % m;
    let faces = (0..n * m).flat_map(|k| {
        let (i, j) = (k / m, k % m);
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    single((0..n * m).map(at).collect(), faces.collect())
}

fn single(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Model {
    let mut model = Model::default();
    model.add(MeshData { positions, triangles, ..MeshData::default() });
    model
}

/// A body of a mesh, its inner layer `offset` [m] inside it.
fn mesh(offset: f64) -> Value {
    json!({"shape": {"mesh": {"path": "mesh", "inner_offset": {"metres": offset}}}, "integrator": "rk4"})
}

/// The scene with `model` for its first body's mesh.
fn bake_with(scene: &Scene, model: &Model) -> Result<Baked, String> {
    let mut assets = Assets::default();
    let TwoLayerShape::Mesh(shape) = &scene.two_layer[0].shape else { panic!("a mesh") };
    assets.insert(shape, Arc::new(Solid::new(model).unwrap()));
    bake(scene, &assets).map_err(|error| error.to_string())
}

fn runner(scene: &Scene, model: &Model) -> Runner {
    Runner::new(bake_with(scene, model).unwrap())
}

fn run(mut runner: Runner, seconds: f64) -> Runner {
    for _ in 0..runner.frames_for(seconds) {
        runner.advance_frame();
        assert!(runner.world().divergence().is_none(), "{:?}", runner.world().divergence());
    }
    runner
}

fn first(runner: &Runner) -> &Body {
    &runner.world().bodies()[0]
}

fn volume(body: &Body) -> f64 {
    body.parts().layers.as_ref().unwrap().outer_surface.as_ref().unwrap().volume(&body.state().positions)
}

#[test]
fn counts_are_those_of_the_welded_mesh() {
    // A torus has as many vertices as edges less faces: V, 3 V, 2 V.
    for (model, [vertices, edges, faces], drawn) in
        [(torus(9, 6, 2.0, 0.7), [54, 162, 108], 54), (split_sphere(), [18, 48, 32], 96)]
    {
        for single in [false, true] {
            let mut body = mesh(0.2);
            body["shape"]["mesh"]["single_layer"] = json!(single);
            let baked = bake_with(&two_layer(&[body], json!({})), &model).unwrap();
            let parts = baked.world.bodies()[0].parts();
            let layers = parts.layers.as_ref().unwrap();
            let count = |kind| layers.springs.groups().iter().find(|group| group.kind == kind).unwrap().springs.len();
            let two = usize::from(!single);
            assert_eq!((parts.state.len(), layers.outer), ((1 + two) * vertices, vertices));
            assert_eq!(count(SpringKind::Structural), (1 + two) * edges);
            assert_eq!(count(SpringKind::Radius), two * vertices);
            assert_eq!((count(SpringKind::ShearLeft), count(SpringKind::ShearRight)), (two * edges, two * edges));
            let skin = parts.skin.as_ref().unwrap();
            assert_eq!((skin.len(), skin.triangles().len()), (drawn, faces));
            let farthest = skin.positions(&parts.state.positions);
            assert!(farthest.iter().zip(&model.positions).all(|(a, b)| a.distance(*b) < 1e-12), "the skin is the mesh");
            assert_eq!(baked.regions[0]["inner"].len(), two * vertices);
        }
    }
}

#[test]
fn a_mesh_of_the_ball_is_the_ball() {
    let rest = json!({"gravity": [0, -9.81, 0], "room": {"floor": -2.5}});
    let of_mesh = bake_with(&two_layer(&[mesh(1.0)], rest.clone()), &split_sphere()).unwrap();
    let of_ball = crate::common::baked(&two_layer(&[ball(1)], rest));
    let lengths = |baked: &Baked| {
        let parts = baked.world.bodies()[0].parts();
        let at = |i: u32| parts.rest[i as usize];
        let springs = parts.layers.as_ref().unwrap().springs.ends().to_vec();
        let mut lengths: Vec<f64> = springs.into_iter().map(|[a, b]| at(a).distance(at(b))).collect();
        lengths.sort_by(f64::total_cmp);
        lengths
    };
    let (one, other) = (lengths(&of_mesh), lengths(&of_ball));
    assert!(one.len() == 210 && one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-12));
    let limit = |baked: &Baked| baked.world.bodies()[0].parts().stable_dt;
    assert!((limit(&of_mesh) / limit(&of_ball) - 1.0).abs() < 1e-3, "{} {}", limit(&of_mesh), limit(&of_ball));
    // They fall, meet the floor and swing alike.
    let (one, other) = (run(Runner::new(of_mesh), 1.0), run(Runner::new(of_ball), 1.0));
    let (a, b) = (first(&one), first(&other));
    assert!((volume(a) / volume(b) - 1.0).abs() < 1e-9, "{} {}", volume(a), volume(b));
    assert!(a.state().center().distance(b.state().center()) < 1e-9);
}

#[test]
fn springs_of_a_mesh_at_rest_hold_the_gas_as_the_virial_theorem_says() {
    // At rest `sum x . f = 0`: the springs' `-sum T L` and the gas's `P x . grad V = 3 P V = 3 nRT` cancel.
    for (pressure, inside) in [(20.0, "outer"), (200.0, "outer"), (50.0, "inner")] {
        let body = with(mesh(0.3), json!({"pressure": pressure, "pressure_in": inside, "mass": 0.2, "air_drag": 2}));
        let runner = run(runner(&two_layer(&[body], json!({})), &torus(10, 7, 2.0, 0.8)), 60.0);
        let body = first(&runner);
        let springs = &body.parts().layers.as_ref().unwrap().springs;
        let at = |i: u32| body.state().positions[i as usize];
        let rest = |i: u32| body.parts().rest[i as usize];
        let virial: f64 = springs
            .groups()
            .iter()
            .flat_map(|group| springs.ends()[group.springs.clone()].iter().map(|&ends| (group.stiffness, ends)))
            .map(|(stiffness, [a, b])| {
                let length = at(a).distance(at(b));
                stiffness * (length - rest(a).distance(rest(b))) * length
            })
            .sum();
        println!("{pressure} J {inside}: sum T L = {virial:.6} J, V = {:.4} m³", volume(body));
        assert!((virial / (3.0 * pressure) - 1.0).abs() < 1e-6, "{virial}, not {}", 3.0 * pressure);
    }
}

#[test]
fn forces_of_a_mesh_are_the_gradient_of_their_energy() {
    let body = with(mesh(0.3), json!({"pressure_in": "both", "pressure": 100, "kd": 0, "rkd": 0}));
    let baked = bake_with(&two_layer(&[body], json!({})), &torus(6, 5, 2.0, 0.8)).unwrap();
    let parts = baked.world.bodies()[0].parts();
    let (mut forces, mut state) = (parts.forces.clone(), parts.state.clone());
    for (k, x) in state.positions.iter_mut().enumerate() {
        let k = k as f64;
        *x += 0.05 * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin());
    }
    let mut exact = vec![DVec3::ZERO; state.len()];
    for force in &mut forces {
        force.add_forces(0.0, &state, &mut exact);
    }
    let scale = exact.iter().map(|force| force.length()).fold(0.0, f64::max);
    let h = 1e-4;
    for i in 0..state.len() {
        for axis in 0..3 {
            let at = state.positions[i];
            let mut moved = |share: f64| {
                state.positions[i][axis] = at[axis] + share * h;
                let mut energies = Energies::default();
                for force in &forces {
                    force.add_energy(0.0, &state, &mut energies);
                }
                state.positions[i] = at;
                energies.potential()
            };
            let slope = (8.0 * (moved(1.0) - moved(-1.0)) - (moved(2.0) - moved(-2.0))) / (12.0 * h);
            assert!((exact[i][axis] + slope).abs() < 1e-8 * scale, "particle {i}, axis {axis}: {slope}");
        }
    }
}

#[test]
fn a_mesh_in_free_flight_keeps_both_momenta() {
    let thrown = json!({"initial": {"velocity": [1, 2, 0.5], "angular_velocity": [30, 0, 90],
        "deformation": [[1.1, 0.1, 0], [0, 0.95, 0], [0, 0, 1]]}, "integrator": "leap_frog"});
    let model = torus(12, 8, 2.0, 0.8);
    let scene = two_layer(&[with(mesh(0.3), thrown)], json!({}));
    let (start, end) = (runner(&scene, &model), run(runner(&scene, &model), 2.0));
    let (before, now) = (first(&start).state(), first(&end).state());
    let share = |before: DVec3, now: DVec3| (now - before).length() / before.length();
    let (linear, angular) = (
        share(before.linear_momentum(), now.linear_momentum()),
        share(before.angular_momentum(), now.angular_momentum()),
    );
    println!("linear {linear:.1e}, angular {angular:.1e}");
    assert!(linear < 1e-12 && angular < 1e-9);
    assert!(volume(first(&start)) != volume(first(&end)), "it swings");
}

#[test]
fn the_tube_comes_to_rest_on_the_floor_with_all_its_weight() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let scene = load_scene(&folder.join("two_layer_mesh.json")).unwrap();
    let assets = load_assets(&scene, &folder, &mut |_| {}).unwrap();
    let runner = run(Runner::new(bake(&scene, &assets).unwrap()), 30.0);
    let body = first(&runner);
    let depths = body.state().positions.iter().map(|x| (-x.y).max(0.0));
    let (carried, weight) = (2000.0 * depths.sum::<f64>(), body.state().mass() * 9.81);
    println!("the floor carries {carried:.3} N of {weight:.3} N, {:.2e} J left", body.state().kinetic_energy());
    assert!((carried / weight - 1.0).abs() < 1e-3 && body.state().kinetic_energy() < 1e-3);
    // Flat: hardly higher than its section, and larger than at rest by its gas.
    let ys = body.state().positions.iter().map(|x| x.y);
    let height = ys.clone().fold(f64::NEG_INFINITY, f64::max) - ys.fold(f64::INFINITY, f64::min);
    assert!(height > 1.4 && height < 1.7, "{height}");
    assert!(volume(body) > 23.25, "{}", volume(body));
}

#[test]
fn an_inner_layer_that_would_turn_inside_out_is_refused_with_what_would_do() {
    let refusal = |model: &Model, offset: Value| {
        let mut body = mesh(0.1);
        body["shape"]["mesh"]["inner_offset"] = offset;
        bake_with(&two_layer(&[body], json!({})), model).err()
    };
    // A torus has the radius of its section; an egg's sharp ends give out long before its middle.
    let mut egg = split_sphere();
    egg.positions.iter_mut().for_each(|x| x.x *= 3.0);
    let torus = torus(16, 10, 2.0, 0.8);
    for (model, unit, value, least, most) in
        [(&torus, "metres", 0.9, 0.7, 0.8), (&torus, "metres", 7.5, 0.7, 0.8), (&egg, "fraction", 0.9, 0.2, 0.85)]
    {
        let message = refusal(model, json!({unit: value})).unwrap();
        println!("{message}");
        let start = format!("/two_layer/0/shape/mesh/inner_offset/{unit}: {value} turns the inner layer inside out");
        assert!(message.starts_with(&start), "{message}");
        let (_, advice) = message.split_once("; give ").unwrap();
        let advised: f64 = advice.split_whitespace().next().unwrap().parse().unwrap();
        assert!(advised > least && advised < most, "{message}");
        assert_eq!(refusal(model, json!({unit: advised})), None);
        assert!(refusal(model, json!({unit: 1.05 * advised})).is_some());
    }
}

#[test]
fn meshes_with_holes_and_meshes_that_are_not_there_are_refused() {
    let mut open = torus(8, 6, 2.0, 0.8);
    open.triangles.pop();
    open.parts[0].triangles.end -= 1;
    let scene = two_layer(&[mesh(0.1)], json!({}));
    let message = bake_with(&scene, &open).err().unwrap();
    assert!(message.starts_with("/two_layer/0/shape/mesh/path: ") && message.contains("3 open edges"), "{message}");
    let message = bake(&scene, &Assets::default()).err().unwrap().to_string();
    assert!(message.starts_with("/two_layer/0/shape/mesh/path: the model was not loaded"), "{message}");
    let message = load_assets(&scene, Path::new("/"), &mut |_| {}).err().unwrap().to_string();
    assert!(message.starts_with("/two_layer/0/shape/mesh/path: "), "{message}");
}
