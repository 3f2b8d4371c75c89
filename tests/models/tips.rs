//! Skins where particles are few beside the surface: tips, blades, needles, teeth, dents, and points far outside.

use crate::shapes::{blocks, joined, lathe, single, solid, sphere};
use glam::{DMat3, DVec3};
use sinew::bake::bake;
use sinew::draw::{Display, Subject, Theme, draw};
use sinew::geometry::{FillResolution, Kernel, Model, TriangleMesh, fill};
use sinew::scene::{Assets, Body, Fibre, Initial, Material, MeshShape, Scene};
use sinew::sim::Runner;
use sinew::test_support::solver::{Skin, SkinShape};

/// Counts of particles that are asked for.
const COUNTS: [u32; 6] = [8, 30, 100, 455, 1200, 5000];

fn shapes() -> Vec<(&'static str, Model)> {
    // The corner of a cube cut off: three vertices reach far beyond what particles fill.
    let corner = single(
        [DVec3::ZERO, 3.0 * DVec3::X, 3.0 * DVec3::Y, 3.0 * DVec3::Z].to_vec(),
        vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
    );
    let blade = {
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z * (1.0 - x / 6.001));
        let mut model = blocks(&[0.0, 1.0, 2.0, 4.0, 6.0], &[0.0, 1.0, 2.0], &[-0.5, 0.5], |_| true);
        model.positions.iter_mut().for_each(|p| *p = at(p.x, p.y, p.z));
        model
    };
    let xs: Vec<f64> = (0..12).map(|k| f64::from(k / 2) + 0.9 * f64::from(k % 2)).collect();
    let comb = blocks(&xs, &[0.0, 1.0, 4.0], &[0.0, 0.8], |[i, j, _]| j == 0 || i % 2 == 0);
    let cuts = [-5.0, -0.03, 0.03, 5.0];
    let spiked = blocks(&cuts, &[0.0, 0.9, 12.0], &cuts, |[i, j, k]| j == 0 || (i, k) == (1, 1));
    let mut dented = sphere(24, 1.0);
    for (k, p) in dented.positions.iter_mut().enumerate() {
        let dent = 0.85 * (-8.0 * p.distance_squared(DVec3::Z)).exp();
        let thorn = if k % 97 == 5 { 1.5 } else { 0.0 };
        *p *= 1.0 - dent + thorn;
    }
    vec![
        ("corner", corner),
        ("tip", lathe(&[(0.0, 0.0), (1.0, 0.0), (0.3, 3.0), (0.02, 8.0), (0.0, 9.0)], 12)),
        ("needle", lathe(&[(0.0, -1.0), (1.0, -0.7), (1.0, 0.7), (0.02, 1.0), (0.01, 40.0), (0.0, 41.0)], 12)),
        ("blade", blade),
        ("comb", comb),
        ("plate with a spike", spiked),
        ("dented sphere with thorns", dented),
    ]
}

struct Case {
    name: String,
    skin: Skin,
    particles: Vec<DVec3>,
    vertices: Vec<DVec3>,
    extent: f64,
}

/// Every shape with every count that fills it.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (name, model) in shapes() {
        let solid = solid(&model);
        let before = cases.len();
        for count in COUNTS {
            let Ok(filling) = fill(&solid, FillResolution::Particles(count), 2.5, 100_000) else { continue };
            let (particles, kernel) = (filling.sample.points, Kernel::new(2.5 * filling.sample.spacing));
            let shape = SkinShape {
                points: &solid.surface.points,
                point_of: &solid.surface.point_of,
                normals: &[],
                colours: &[],
                triangles: &solid.model.triangles,
            };
            let skin = Skin::embed(&shape, &particles, kernel, &mut |_, _| {}).expect("a skin");
            let name = format!("{name} of {} particles", particles.len());
            let vertices = solid.model.positions.clone();
            cases.push(Case { name, skin, particles, vertices, extent: solid.size().max_element() });
        }
        assert!(cases.len() >= before + 2, "{name} is hardly ever filled");
    }
    cases
}

fn worst(found: &[DVec3], expected: impl Iterator<Item = DVec3>) -> f64 {
    // A maximum would pass over what is no number.
    let distances = found.iter().zip(expected).map(|(a, b)| a.distance(b));
    distances.fold(0.0, |worst, distance| if distance <= worst { worst } else { distance })
}

#[test]
fn every_vertex_lies_where_the_file_put_it_and_turns_as_the_body_does() {
    for case in cases() {
        let rest = case.skin.positions(&case.particles);
        let off = worst(&rest, case.vertices.iter().copied()) / case.extent;
        assert!(off < 1e-12, "{}: {off:e}", case.name);
        for degrees in [30.0_f64, 120.0, 180.0] {
            let turn = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize_or_zero(), degrees.to_radians());
            let carried = |x: DVec3| turn * x + case.extent * DVec3::new(30.0, -20.0, 10.0);
            let particles: Vec<DVec3> = case.particles.iter().map(|&x| carried(x)).collect();
            let found = case.skin.positions(&particles);
            let off = worst(&found, case.vertices.iter().map(|&x| carried(x))) / case.extent;
            assert!(off < 1e-11, "{} turned by {degrees} degrees: {off:e}", case.name);
            assert!(case.skin.normals(&found).iter().all(|normal| (normal.length() - 1.0).abs() < 1e-5));
        }
    }
}

#[test]
fn absolute_weights_sum_to_no_more_than_is_said() {
    let mut greatest = 0.0_f64;
    for case in cases() {
        for vertex in 0..case.skin.len() {
            let weights = case.skin.weights(vertex).expect("a vertex").weights;
            let sum: f64 = weights.iter().map(|(_, w)| w).sum();
            let size: f64 = weights.iter().map(|(_, w)| w.abs()).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{}: {sum}", case.name);
            assert!(size <= Skin::GREATEST_SUM * (1.0 + 1e-12), "{}: {size}", case.name);
            // Far points take no more of them than near ones.
            assert!(weights.len() < 400, "{}: {} particles", case.name, weights.len());
            greatest = greatest.max(size);
        }
    }
    // Some lie so far out that the bound is what holds them.
    assert!(greatest > 0.6 * Skin::GREATEST_SUM, "{greatest}");
}

/// Points alone, without faces.
fn points_over(particles: &[DVec3], points: &[DVec3], kernel: Kernel) -> Skin {
    let point_of: Vec<u32> = (0..points.len() as u32).collect();
    let shape = SkinShape { points, point_of: &point_of, normals: &[], colours: &[], triangles: &[] };
    Skin::embed(&shape, particles, kernel, &mut |_, _| {}).expect("a skin")
}

/// How much differs between one vertex and the next: sum of the absolute changes of the weights, or the way between
/// them in spacings, whichever is greater.
fn change(skin: &Skin, vertex: usize, positions: &[DVec3], particles: usize, spacing: f64) -> f64 {
    let mut weights = vec![0.0; particles];
    for (vertex, sign) in [(vertex, -1.0), (vertex + 1, 1.0)] {
        for (k, w) in skin.weights(vertex).expect("a vertex").weights {
            weights[k as usize] += sign * w;
        }
    }
    let change: f64 = weights.iter().map(|w| w.abs()).sum();
    change.max(positions[vertex].distance(positions[vertex + 1]) / spacing)
}

#[test]
fn nothing_jumps_on_the_way_out_along_a_tip() {
    for (name, model) in shapes() {
        let solid = solid(&model);
        for count in [30, 100, 455, 1200] {
            let Ok(filling) = fill(&solid, FillResolution::Particles(count), 2.5, 100_000) else { continue };
            let (particles, spacing) = (filling.sample.points, filling.sample.spacing);
            let kernel = Kernel::new(2.5 * spacing);
            let center = particles.iter().sum::<DVec3>() / particles.len() as f64;
            let far = |x: &DVec3| x.distance(center);
            let tip = solid.surface.points.iter().copied().max_by(|a, b| far(a).total_cmp(&far(b))).expect("a point");
            // From the middle to as far again beyond the tip, by a way that meets no symmetry.
            let way = tip - center + spacing * DVec3::new(0.13, 0.29, -0.17);
            // Bent, twisted and stretched.
            let bent = |x: &DVec3| {
                let y = (*x - center) / solid.size().max_element();
                let turn = DMat3::from_rotation_y(2.0 * y.y) * DMat3::from_rotation_x(1.5 * y.z + y.y);
                center + turn * (*x - center) * (1.0 + 0.3 * y.x)
            };
            let moved: Vec<DVec3> = particles.iter().map(bent).collect();
            // Parts of the way between whose ends much changes are halved; where something jumps, that never ends.
            let mut parts: Vec<[f64; 2]> =
                (0..500).map(|k| [f64::from(k), f64::from(k + 1)].map(|s| s / 250.0)).collect();
            for _ in 0..16 {
                let points: Vec<DVec3> = parts.iter().flatten().map(|s| center + *s * way).collect();
                let skin = points_over(&particles, &points, kernel);
                let bent = skin.positions(&moved);
                let jumps = |k: &usize| change(&skin, 2 * k, &bent, particles.len(), spacing) > 0.2;
                let left = (0..parts.len()).filter(jumps).map(|k| parts[k]);
                parts = left.flat_map(|[a, b]| [[a, 0.5 * (a + b)], [0.5 * (a + b), b]]).collect();
            }
            assert!(parts.is_empty(), "{name}, {count}: a jump at {:?} of the way", parts[0]);
        }
    }
}

#[test]
fn few_particles_and_flat_ones_carry_a_skin_too() {
    let kernel = Kernel::new(0.3);
    let points: Vec<DVec3> = (0..200)
        .map(|k| f64::from(k) * 0.731)
        .map(|k| (0.01 + 0.2 * k) * DVec3::new((1.3 * k).sin(), (2.1 * k).cos(), (0.7 * k).sin()))
        .chain([DVec3::ZERO, DVec3::X, 1e4 * DVec3::Z])
        .collect();
    let plane: Vec<DVec3> = (0..36).map(|k| DVec3::new(f64::from(k % 6), f64::from(k / 6), 0.0) * 0.1).collect();
    let line: Vec<DVec3> = (0..6).map(|k| DVec3::X * 0.1 * f64::from(k)).collect();
    for (name, particles, turns) in [
        ("a plane", &plane[..], true),
        ("three", &[DVec3::ZERO, DVec3::X, DVec3::Y], true),
        ("a line", &line, false),
        ("one", &[DVec3::Y], false),
        ("two at one place", &[DVec3::Y; 2], false),
    ] {
        let skin = points_over(particles, &points, kernel);
        let turn = if turns { DMat3::from_rotation_x(2.0) * DMat3::from_rotation_z(2.9) } else { DMat3::IDENTITY };
        let moved: Vec<DVec3> = particles.iter().map(|&x| turn * x + DVec3::ONE).collect();
        let found = skin.positions(&moved);
        for (x, y) in points.iter().zip(&found) {
            let off = y.distance(turn * *x + DVec3::ONE) / (1.0 + x.length());
            assert!(off < 1e-11, "{name}, {x}: {off:e}");
        }
        // However they are moved, nothing is ever no number.
        for k in 0..40 {
            let wild = |(i, x): (usize, &DVec3)| {
                let k = f64::from(k) + i as f64;
                *x * f64::from(k as i32 % 3) + DVec3::new((3.1 * k).sin(), (5.7 * k).cos(), (0.3 * k).sin())
            };
            let moved: Vec<DVec3> = particles.iter().enumerate().map(wild).collect();
            assert!(skin.positions(&moved).iter().all(|x| x.is_finite()), "{name}");
        }
        assert!(skin.positions(&vec![DVec3::ONE; particles.len()]).iter().all(|x| x.is_finite()), "{name}");
    }
}

#[test]
fn thrown_and_bent_every_frame_is_made_of_numbers() {
    for (name, model) in shapes() {
        let mesh = TriangleMesh { positions: model.positions, triangles: model.triangles };
        let mut assets = Assets::default();
        let mut ran = 0;
        for count in [8, 60, 455] {
            let shape = MeshShape::new("mesh").with_particles(count).with_scale(0.05);
            assets.insert_mesh(&shape, &mesh).expect("a solid");
            let mut body = Body::from_mesh("body", shape)
                .with_material(Material::new(2e4, 0.33, 1000.0))
                .with_translation([0.0, 0.3, 0.0]);
            body.initial = Initial {
                velocity: [1.0, -4.0, 0.5],
                angular_velocity: [400.0, -300.0, 900.0],
                deformation: [[1.05, 0.1, 0.0], [0.0, 0.95, 0.1], [0.05, 0.0, 1.0]],
                ..Initial::default()
            };
            let scene = Scene::new("thrown").with_floor(0.0).with_body(body);
            let Ok(baked) = bake(&scene, &assets) else { continue };
            ran += 1;
            let mut runner = Runner::new(baked);
            for frame in 0..=6 {
                let snapshot = runner.snapshot();
                let body = &snapshot.bodies[0];
                let size = body.particles.iter().map(|x| x.length()).fold(0.0, f64::max);
                for x in &body.skin {
                    assert!(x.is_finite() && x.length() < 100.0 * size, "{name}, {count}, frame {frame}: {x}");
                }
                assert!(body.normals.iter().all(|x| x.is_finite()), "{name}, {count}, frame {frame}");
                let subject = Subject { scene: &scene, snapshot: &snapshot, ghost: None };
                let list = draw(&subject, &Display::default(), &Theme::light());
                let drawn: Vec<_> =
                    list.meshes.iter().flat_map(|mesh| mesh.faces.worked_out().0.into_owned()).collect();
                assert!(drawn.len() >= body.skin.len(), "{name}, {count}, frame {frame}: nothing is drawn");
                let whole = drawn.iter().all(|vertex| vertex.position.is_finite() && vertex.normal.is_finite());
                assert!(whole, "{name}, {count}, frame {frame}");
                runner.advance_frame();
            }
            assert!(runner.world().divergence().is_none(), "{name}, {count}");
        }
        assert!(ran > 0, "{name} never ran");
    }
}

#[test]
fn fibres_that_run_out_of_tips_stay_finite_and_near() {
    let mut placed = 0;
    for (name, model) in shapes() {
        let center = model.positions.iter().sum::<DVec3>() / model.positions.len() as f64;
        let far = |x: &DVec3| x.distance(center);
        let tip = model.positions.iter().copied().max_by(|a, b| far(a).total_cmp(&far(b))).expect("a point");
        let mesh = TriangleMesh { positions: model.positions, triangles: model.triangles };
        let mut assets = Assets::default();
        for count in [8, 60, 455, 1200] {
            let shape = MeshShape::new("mesh").with_particles(count).with_scale(0.05);
            assets.insert_mesh(&shape, &mesh).expect("a solid");
            let mut body = Body::from_mesh("body", shape).with_material(Material::new(2e4, 0.33, 1000.0));
            for (k, points) in [12, 25, 50].into_iter().enumerate() {
                let at = |i: u32| 0.05 * center.lerp(tip, -0.3 + 1.6 * f64::from(i) / f64::from(points));
                body = body.with_fibre(Fibre::through(format!("f{k}"), (0..=points).map(at)));
            }
            let Ok(baked) = bake(&Scene::new("fibres").with_body(body), &assets) else { continue };
            let mut runner = Runner::new(baked);
            for frame in 0..2 {
                let snapshot = runner.snapshot();
                let body = &snapshot.bodies[0];
                let (low, high) = body
                    .particles
                    .iter()
                    .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
                for x in body.fibres.iter().flat_map(|fibre| &fibre.vertices) {
                    let inside = x.clamp(low, high);
                    let is_near = x.distance(inside) < 0.5 * (high - low).length();
                    assert!(x.is_finite() && is_near, "{name}, {count}, frame {frame}: {x} beside {low} to {high}");
                    placed += 1;
                }
                runner.advance_frame();
            }
            assert!(runner.world().divergence().is_none(), "{name}, {count}");
        }
    }
    assert!(placed > 500, "{placed}");
}

/// Places that are left without particles are told of and shown where they are: on the spike, wherever that is by now.
#[test]
fn what_no_particle_fills_is_said_and_shown_where_it_is() {
    let (_, model) = shapes().into_iter().find(|(name, _)| *name == "plate with a spike").expect("it is there");
    let mut assets = Assets::default();
    let mesh = TriangleMesh { positions: model.positions, triangles: model.triangles };
    assets.insert_mesh("spiked", &mesh).expect("a solid");
    let mut said = 0;
    for count in (200..1400).step_by(150) {
        let body = Body::from_mesh("spiked", MeshShape::new("spiked").with_particles(count))
            .with_material(Material::new(1e5, 0.33, 1000.0));
        let Ok(baked) = bake(&Scene::new("thin").with_body(body), &assets) else { continue };
        let is_told = |text: &str| {
            text.contains("in parts less than one layer thick were left out (the first at [")
                || text.contains("in parts so thin that no particle is in them (the first at [")
        };
        let told = baked.notes.iter().any(|note| note.warning && is_told(&note.text));
        let particles = &baked.world.bodies()[0].state().positions;
        let by = DVec3::new(3.0, -1.0, 7.0);
        let moved: Vec<DVec3> = particles.iter().map(|&at| at + by).collect();
        let places: Vec<DVec3> =
            baked.thin[0].places(&moved, 300).into_iter().filter(|place| place.y - by.y > 0.95).collect();
        assert_eq!(told, !places.is_empty(), "{count}: {places:?}");
        assert!(places.iter().all(|&place| (place - by).with_y(0.0).length() < 0.05), "{count}: {places:?}");
        said += usize::from(told);
    }
    assert!(said > 0);
}

/// A ball with a fin far thinner than the lattice, which runs beside it.
fn finned(thickness: f64) -> Model {
    let fin = blocks(&[0.5, 1.5, 2.2], &[0.11, 0.11 + thickness], &[-0.6, 0.0, 0.6], |_| true);
    joined(&[&sphere(24, 1.0), &fin])
}

#[test]
fn a_fin_between_two_layers_is_said_and_shown_and_a_thick_one_is_not() {
    for (thickness, is_missed) in [(0.01, true), (0.02, true), (0.6, false)] {
        let model = finned(thickness);
        let mut assets = Assets::default();
        let mesh = TriangleMesh { positions: model.positions, triangles: model.triangles };
        assets.insert_mesh("finned", &mesh).expect("a solid");
        for count in [300, 800, 2000, 3000] {
            let body = Body::from_mesh("finned", MeshShape::new("finned").with_particles(count))
                .with_material(Material::new(1e5, 0.33, 1000.0));
            let baked = bake(&Scene::new("fin").with_body(body), &assets).expect("a body");
            let particles = &baked.world.bodies()[0].state().positions;
            let places = baked.thin[0].places(particles, 300);
            let warnings: Vec<&str> =
                baked.notes.iter().filter(|note| note.warning).map(|note| note.text.as_str()).collect();
            let on_fin = places.iter().filter(|place| place.x > 1.2).count();
            assert_eq!(on_fin > 20, is_missed, "{thickness} m, {count}: {on_fin} of {}, {warnings:?}", places.len());
            assert!(places.iter().all(|place| place.length() > 0.95), "{thickness} m, {count}: {places:?}");
            let told = warnings.iter().any(|text| text.contains("particle") && text.contains("the first at ["));
            assert_eq!(told, is_missed, "{thickness} m, {count}: {warnings:?}");
        }
    }
}

#[test]
fn what_gives_a_fin_two_layers_is_said_and_does() {
    let model = finned(0.04);
    let mut assets = Assets::default();
    let mesh = TriangleMesh { positions: model.positions, triangles: model.triangles };
    assets.insert_mesh("finned", &mesh).expect("a solid");
    let noted = |count: u32| {
        let body = Body::from_mesh("finned", MeshShape::new("finned").with_particles(count))
            .with_material(Material::new(1e5, 0.33, 1000.0));
        let notes = bake(&Scene::new("fin").with_body(body), &assets).expect("a body").notes;
        notes.into_iter().find(|note| note.text.contains("no particle is in them")).map(|note| note.text)
    };
    let said = noted(800).expect("no particle is in it");
    let asked = said.split("about ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a number");
    let wanted: f64 = asked.parse().expect("a number");
    // Two layers in 0.04 m of a ball of 4.2 m³ are as many.
    assert!((wanted * 0.02_f64.powi(3) / 4.25 - 1.0).abs() < 0.03, "{said}");
}
