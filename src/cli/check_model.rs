//! `sinew check MODEL`: whether a model has an inside, and how many particles it takes to fill it.

use super::error::printable;
use super::table::{Align, Table};
use super::{CliError, Console, Outcome};
use crate::geometry::fill::{FillError, FillResolution, fill};
use crate::geometry::fineness::by_itself;
use crate::geometry::solid::Solid;
use crate::io::{IoError, load_model};
use crate::scene::{Axis, MAX_PARTICLES, ModelFile, one_line};
use crate::text::number::four_figures;
use clap::{Args, ValueEnum};
use std::path::Path;

/// What a scene would say about a model.
#[derive(Clone, Debug, Args)]
pub(super) struct ModelOptions {
    /// Of a model: metres to a unit of the file
    #[arg(long, value_name = "M", default_value_t = 1.0, value_parser = positive)]
    scale: f64,
    /// Of a model: the file's axis that points up
    #[arg(long, value_enum, default_value_t = UpOption::Y)]
    up: UpOption,
    /// Of a model: fill it at this support radius [m]
    #[arg(long, value_name = "M", value_parser = positive, conflicts_with = "particles")]
    support_radius: Option<f64>,
    /// Of a model: fill it with about so many particles
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=2_000_000))]
    particles: Option<u32>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum UpOption {
    X,
    Y,
    Z,
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("give a number above 0".to_owned()),
    }
}

/// Support radius over spacing, as in the fibre paper.
const REACH: f64 = 2.5;

/// Numbers of particles that are tried when none is asked for, beside the one with which the model opens by itself.
const USUAL: [u32; 2] = [2000, 8000];

/// Reads a model, checks it and fills it.
///
/// # Errors
/// A file that cannot be read or whose surface has no inside.
pub(super) fn check_model(path: &Path, options: &ModelOptions, console: &mut Console) -> Result<Outcome, CliError> {
    let up = match options.up {
        UpOption::X => Axis::X,
        UpOption::Y => Axis::Y,
        UpOption::Z => Axis::Z,
    };
    let file = ModelFile { path: "", scale: options.scale, up };
    console.begin();
    console.stage(&"reading");
    let mut model = load_model(path)?;
    model.stand_up(file.up_axis(), file.scale);
    console.stage(&"looking for an inside");
    let refused = |refusal| IoError::InFile { file: path.to_owned(), error: Box::new(IoError::Refused(refusal)) };
    let solid = Solid::new(&model).map_err(refused)?;
    console.stage(&"filling it with particles");
    let by_itself = by_itself(&solid, REACH);
    let asked = match (options.support_radius, options.particles) {
        (Some(radius), _) => vec![FillResolution::Spacing(radius / REACH)],
        (None, Some(count)) => vec![FillResolution::Particles(count)],
        (None, None) => {
            [&[by_itself.particles], &USUAL[..]].concat().into_iter().map(FillResolution::Particles).collect()
        }
    };
    let particles = particles(&solid, &asked);
    console.end();
    for finding in solid.report.findings() {
        console.say(if finding.warning { "warning" } else { "note" }, &finding);
    }
    if let Some(thin) = by_itself.said() {
        let count = by_itself.particles;
        let opened = match fill(&solid, FillResolution::Particles(count), REACH, MAX_PARTICLES) {
            Ok(_) => format!("opened by itself it gets {count} particles; {thin}"),
            Err(error) => format!("opened by itself with {count} particles it is refused: {error}"),
        };
        console.say("warning", &opened);
    }
    console.print(&format!("{}\n{}\n{}", contents(&solid, path), parts(&solid).render(), particles.render()))?;
    Ok(Outcome::Done)
}

fn contents(solid: &Solid, path: &Path) -> String {
    let report = &solid.report;
    let extent = solid.size().to_array().map(four_figures).join(" x ");
    let state = if report.closed { "closed" } else { "not closed" };
    format!(
        "{}: {} vertices at {} points, {} faces; {state}, pieces: {}\nextent [m]: {extent}\nvolume [m³]: {}\n",
        printable(path),
        report.vertices,
        report.points,
        report.faces,
        report.pieces,
        four_figures(solid.volume),
    )
}

fn parts(solid: &Solid) -> Table {
    let mut table = Table::new([("part", Align::Left), ("faces", Align::Right)]);
    for part in &solid.model.parts {
        let name = if part.name.is_empty() { "(no name)".to_owned() } else { one_line(&part.name) };
        table.push([name, part.triangles.len().to_string()]);
    }
    table
}

fn particles(solid: &Solid, asked: &[FillResolution]) -> Table {
    let mut table = Table::new([
        ("particles", Align::Right),
        ("support radius [m]", Align::Right),
        ("volume error [%]", Align::Right),
        ("pieces", Align::Right),
        ("in one layer", Align::Right),
        ("in two layers", Align::Right),
        ("", Align::Left),
    ]);
    for &resolution in asked {
        table.push(match fill(solid, resolution, REACH, MAX_PARTICLES) {
            Ok(filling) => [
                filling.sample.points.len().to_string(),
                four_figures(REACH * filling.sample.spacing),
                four_figures(100.0 * filling.volume_error),
                filling.sample.pieces().1.to_string(),
                filling.thinness.single.to_string(),
                filling.thinness.double.to_string(),
                String::new(),
            ],
            Err(error) => {
                let wanted = match resolution {
                    FillResolution::Particles(count) => [count.to_string(), "-".to_owned()],
                    FillResolution::Spacing(spacing) => ["-".to_owned(), four_figures(REACH * spacing)],
                };
                let [count, radius] = wanted;
                let dash = || "-".to_owned();
                let why = match error {
                    FillError::TooThin { suggested: Some(spacing), .. } => {
                        format!("too thin; {} m gives two layers", four_figures(REACH * spacing))
                    }
                    other => other.to_string(),
                };
                [count, radius, dash(), dash(), dash(), dash(), why]
            }
        });
    }
    table
}
