//! `sinew check`: what a scene or a model holds and what is odd about it, without running it.

use super::check_model::{ModelOptions, check_model};
use super::error::printable;
use super::prepare::{Sets, bake_with_notes, load, tell};
use super::table::{Align, Table};
use super::{CliError, Console, Outcome, body_table};
use crate::bake::Baked;
use crate::io::is_model;
use crate::scene::{BYTES_PER_PARTICLE, Scene, one_line};
use crate::sim::body_labels;
use crate::solver::body::Body;
use crate::solver::world::World;
use crate::text::number::four_figures;
use clap::Args;
use glam::DVec3;
use std::path::PathBuf;

/// Arguments of `sinew check`.
#[derive(Debug, Args)]
pub struct Check {
    /// Scene file, or a model: OBJ, STL, PLY, glTF or GLB
    scene: PathBuf,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    model: ModelOptions,
}

/// Puts the scene together and prints what is there.
///
/// # Errors
/// A scene or a set that cannot be used.
pub(super) fn run(args: &Check, console: &mut Console) -> Result<Outcome, CliError> {
    if is_model(&args.scene) {
        return check_model(&args.scene, &args.model, console);
    }
    let source = printable(&args.scene);
    let mut loaded = load(Some(&args.scene), &args.sets, None, console)?;
    let baked = bake_with_notes(&mut loaded, Some(&args.scene), console)?;
    tell(&loaded.notes(&baked), console);
    console.print(&contents(&loaded.scene, &baked, &source))?;
    Ok(Outcome::Done)
}

fn contents(scene: &Scene, baked: &Baked, source: &str) -> String {
    let world = &baked.world;
    let frame = world.plan().frame_seconds;
    let name = if scene.name.is_empty() { source.to_owned() } else { one_line(&scene.name) };
    let mut text = format!(
        "{name}: {} s in frames of {} s; bodies: {}, panels: {}, measures: {}\n",
        four_figures(scene.time.duration),
        four_figures(frame),
        world.bodies().len(),
        world.panels().len(),
        world.probes().len(),
    );
    text += &whole(scene, world);
    for part in [bodies(world), steps(world), regions(baked), measures(world)] {
        if !part.is_empty() {
            text += "\n";
            text += &part.render();
        }
    }
    text
}

/// Particles that are moved in a second by one core, within a factor of three [1/s].
const RATE: f64 = 3e6;

/// What the whole scene takes: particles, memory and time.
fn whole(scene: &Scene, world: &World) -> String {
    let plan = world.plan();
    let particles: usize = world.bodies().iter().map(|body| body.state().len()).sum();
    let a_second =
        world.bodies().iter().zip(&plan.substeps).map(|(body, &substeps)| {
            cost(body, f64::from(substeps) * f64::from(plan.outer_steps) / plan.frame_seconds)
        });
    let steps = a_second.sum::<f64>() * scene.time.duration;
    format!(
        "in all: {particles} particles, about {} MB of memory, {} particle steps, about {} s on one core\n",
        four_figures((BYTES_PER_PARTICLE * particles as f64 * 1e-6).ceil()),
        four_figures(steps),
        four_figures((steps / RATE).ceil()),
    )
}

fn bodies(world: &World) -> Table {
    let own = [("span of particles [m]", Align::Right), ("mass [kg]", Align::Right)];
    let mut table = Table::new(body_table::COLUMNS.into_iter().chain(own));
    for (body, label) in world.bodies().iter().zip(body_labels(world.bodies())) {
        let span = span(&body.state().positions).to_array().map(four_figures).join(" x ");
        let own = [span, four_figures(body.state().mass())];
        table.push(body_table::cells(label, body).into_iter().chain(own));
    }
    table
}

/// From the first to the last particle along each world axis [m].
fn span(positions: &[DVec3]) -> DVec3 {
    let least = positions.iter().copied().reduce(DVec3::min).unwrap_or_default();
    let greatest = positions.iter().copied().reduce(DVec3::max).unwrap_or_default();
    greatest - least
}

fn steps(world: &World) -> Table {
    let mut table = Table::new([
        ("body", Align::Left),
        ("integrator", Align::Left),
        ("time step [s]", Align::Right),
        ("stable up to [s]", Align::Right),
        ("limited by", Align::Left),
        ("steps a frame", Align::Right),
        ("particle steps a second", Align::Right),
    ]);
    let plan = world.plan();
    let label_of = body_labels(world.bodies());
    for ((body, label), &substeps) in world.bodies().iter().zip(label_of).zip(&plan.substeps) {
        let a_frame = f64::from(substeps) * f64::from(plan.outer_steps);
        table.push([
            label,
            body.parts().integrator_word.to_owned(),
            four_figures(body.parts().dt),
            four_figures(body.parts().stable_dt),
            body.parts().limited_by.clone().unwrap_or_else(|| "-".to_owned()),
            a_frame.to_string(),
            four_figures(cost(body, a_frame / plan.frame_seconds)),
        ]);
    }
    table
}

/// Particles moved for one simulated second: what the run will cost, whatever the machine.
fn cost(body: &Body, steps_a_second: f64) -> f64 {
    body.state().len() as f64 * steps_a_second
}

fn regions(baked: &Baked) -> Table {
    let mut table = Table::new([("region", Align::Left), ("body", Align::Left), ("particles", Align::Right)]);
    for (regions, label) in baked.regions.iter().zip(body_labels(baked.world.bodies())) {
        let mut regions: Vec<_> = regions.iter().collect();
        regions.sort_by_key(|(id, _)| *id);
        for (id, particles) in regions {
            table.push([one_line(id), label.clone(), particles.len().to_string()]);
        }
    }
    table
}

fn measures(world: &World) -> Table {
    let mut table =
        Table::new([("measure", Align::Left), ("body", Align::Left), ("kind", Align::Left), ("unit", Align::Left)]);
    let label_of = body_labels(world.bodies());
    for probe in world.probes() {
        let quantity = &probe.quantity;
        table.push([
            one_line(&probe.name),
            label_of.get(probe.body).cloned().unwrap_or_default(),
            quantity.kind().to_owned(),
            quantity.unit().to_owned(),
        ]);
    }
    table
}
