//! Thousands of meshes made at random: what is said of their volume is so, and particles lie within.

use crate::random_meshes::{KINDS, mesh, volume};
use crate::shapes::single;
use glam::DVec3;
use rayon::prelude::*;
use sinew::bake::bake;
use sinew::geometry::{FillError, FillResolution, Solid, TriangleMesh, fill};
use sinew::scene::{Assets, Body, MeshShape, Scene};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Tells every seed that fails, not only the first.
pub fn for_every(seeds: impl Iterator<Item = u64>, check: impl Fn(u64) -> Result<(), String> + Sync) {
    let wrong: Vec<String> = seeds
        .collect::<Vec<_>>()
        .into_par_iter()
        .filter_map(|seed| check(seed).err().map(|text| format!("seed {seed}, {}: {text}", mesh(seed).2)))
        .collect();
    assert!(wrong.is_empty(), "{} seeds, the first of them:\n{}", wrong.len(), wrong[..wrong.len().min(40)].join("\n"));
}

fn model(seed: u64) -> TriangleMesh {
    let (points, triangles, _) = mesh(seed);
    TriangleMesh { positions: points.into_iter().map(DVec3::from_array).collect(), triangles }
}

fn solid(seed: u64) -> Result<Solid, String> {
    let TriangleMesh { positions, triangles } = model(seed);
    Solid::new(&single(positions, triangles)).map_err(|refusal| refusal.to_string())
}

#[test]
fn volumes_are_within_two_per_cent_of_an_independent_measure() {
    for_every(0..2000, |seed| {
        let solid = solid(seed)?;
        let (found, expected) = (solid.volume, volume(seed));
        let bounds = solid.size().element_product();
        if (found / expected - 1.0).abs() < 0.02 && found <= bounds * (1.0 + 1e-12) && solid.report.closed {
            return Ok(());
        }
        Err(format!("{found:.5e} m³ instead of {expected:.5e}: {:?}", solid.report))
    });
}

#[test]
fn particles_lie_inside_and_fill_as_much() {
    for_every((0..2000).step_by(7), |seed| {
        let solid = solid(seed)?;
        let filling = match fill(&solid, FillResolution::Particles(120), 2.5, 100_000) {
            // Blades and walls may be too thin for so few.
            Err(FillError::TooThin { .. }) => return Ok(()),
            other => other.map_err(|error| error.to_string())?,
        };
        if !filling.sample.points.iter().all(|&point| solid.contains(point)) {
            return Err("a particle lies outside".to_owned());
        }
        let held = filling.sample.points.len() as f64 * filling.sample.spacing.powi(3);
        let error = (held / volume(seed) - 1.0).abs();
        // A wall of one or two layers holds by a fifth more or less, depending on where they fall.
        let is_thin = filling.thinness.single + filling.thinness.double > 0;
        if error < if is_thin { 0.25 } else { 0.08 } {
            Ok(())
        } else {
            Err(format!("the particles hold {held:.4e} m³ of {:.4e}", volume(seed)))
        }
    });
}

#[test]
fn the_mass_is_the_density_times_the_volume() {
    let measured = Mutex::new(0);
    for_every((0..2000).step_by(31), |seed| {
        let mut assets = Assets::default();
        assets.insert_mesh("mesh", &model(seed)).map_err(|refusal| refusal.to_string())?;
        let body = Body::from_mesh("body", MeshShape::new("mesh").with_particles(150));
        let density = 1000.0;
        // What is too thin for so few particles is refused, which is another test.
        let baked = match bake(&Scene::new("Random").with_body(body), &assets) {
            Err(error) if error.to_string().contains("too thin") => return Ok(()),
            other => other.map_err(|error| error.to_string())?,
        };
        *measured.lock().expect("a count") += 1;
        let mass = baked.world.bodies()[0].state().mass();
        let error = (mass / (density * volume(seed)) - 1.0).abs();
        if error < 0.02 { Ok(()) } else { Err(format!("{mass:.4e} kg of {:.4e}", density * volume(seed))) }
    });
    let measured = measured.into_inner().expect("a count");
    println!("{measured} masses");
    assert!(measured >= 40, "only {measured} of 65 meshes were thick enough");
}

#[test]
fn the_same_seed_gives_the_same_closed_mesh() {
    for seed in 0..10 * KINDS {
        let (points, faces, kind) = mesh(seed);
        assert_eq!((&points, &faces, kind), (&mesh(seed).0, &mesh(seed).1, mesh(seed).2));
        let mut balance: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        for &[a, b, c] in &faces {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                *balance.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
            }
        }
        assert!(balance.values().all(|&sum| sum == 0), "seed {seed}, {kind}: not closed");
        assert!(points.iter().flatten().all(|x| x.is_finite()) && volume(seed) > 0.0, "seed {seed}, {kind}");
    }
}
