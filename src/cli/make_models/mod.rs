//! `sinew make-models`: the models in assets/, made anew. What they look like is in the code here, nothing is drawn by
//! hand; the same code gives the same files on the same machine.
//!
//! Sizes of the fibre solids follow Table 1 of the fibre paper: vertices within 2 %, and a volume that holds its number
//! of particles at the spacing of 6 mm that follows from its support radius of 15 mm.

mod bars;
mod character;
mod field;
mod plants;
mod tube;

use super::{CliError, Console, Outcome, output};
use crate::geometry::model::Model;
use crate::geometry::solid::Solid;
use crate::io::{make_folder, write_glb, write_skinned_glb};
use clap::Args;
use glam::DVec3;
use std::path::PathBuf;

/// Arguments of `sinew make-models`.
#[derive(Debug, Args)]
pub struct MakeModels {
    /// Folder to write to
    folder: PathBuf,
}

/// Spacing of the particles in the fibre paper [m].
const SPACING: f64 = 0.006;

/// What varies the plant's leaves.
const SEED: u64 = 7;

/// Colours of plants and leaves.
const PLANT: [f32; 3] = [0.17, 0.42, 0.13];
const LEAF: [f32; 3] = [0.26, 0.50, 0.12];

/// Colour of the figure on a skeleton.
const CHARACTER: [f32; 3] = [0.72, 0.42, 0.26];

/// Makes the models and writes one GLB file each.
///
/// # Errors
/// A folder or file that cannot be written.
pub(super) fn run(args: &MakeModels, console: &mut Console) -> Result<Outcome, CliError> {
    make_folder(&args.folder)?;
    for (name, model) in [
        (
            "short_bar",
            coloured(bars::bar(SPACING * DVec3::new(7.0, 12.0, 7.0), [53.0, 90.0, 53.0]), [0.80, 0.36, 0.22]),
        ),
        ("long_bar", coloured(bars::bar(SPACING * DVec3::new(5.0, 15.0, 5.0), [20.0, 63.0, 20.0]), [0.22, 0.42, 0.66])),
        ("plant", coloured(of_particles(plants::plant(&plants::PLANT, SEED), 2723.0), PLANT)),
        ("leaf", coloured(of_particles(plants::leaf(&plants::LEAF), 1159.0), LEAF)),
        ("thick_plant", coloured(plants::plant(&plants::THICK_PLANT, SEED), PLANT)),
        ("thick_leaf", coloured(plants::leaf(&plants::THICK_LEAF), LEAF)),
        ("tube", coloured(tube::tube(), [0.16, 0.17, 0.19])),
    ] {
        let path = args.folder.join(format!("{name}.glb"));
        write_glb(&path, &model, name)?;
        console.print(&output::wrote(&format!("{name}: {} vertices,", model.positions.len()), &path))?;
    }
    let (model, skeleton) = character::character();
    let model = coloured(model, CHARACTER);
    let path = args.folder.join("character.glb");
    write_skinned_glb(&path, &model, &skeleton, "character")?;
    console.print(&output::wrote(&format!("character: {} vertices,", model.positions.len()), &path))?;
    Ok(Outcome::Done)
}

fn coloured(mut model: Model, [r, g, b]: [f32; 3]) -> Model {
    model.colours = vec![[r, g, b, 1.0]; model.positions.len()];
    model
}

/// A model scaled to the volume of so many particles.
fn of_particles(mut model: Model, count: f64) -> Model {
    let volume = Solid::new(&model).map_or(1.0, |solid| solid.volume);
    let scale = SPACING * (count / volume).cbrt();
    model.positions.iter_mut().for_each(|position| *position *= scale);
    model
}
