//! `sinew fibres`: a scene's fibres as lines for other programs, and lines of other programs as fibres.

use super::motion::Up;
use super::output::{self, check, wrote};
use super::prepare::{Sets, bake_with_notes, folder_of, load};
use super::{CliError, Console, Outcome};
use crate::export::Space;
use crate::io::{check_lines_name, save_scene, with_models_from, write_lines};
use crate::transfer::{LineSites, LineSpace};
use clap::{ArgGroup, Args, ValueEnum};
use std::path::PathBuf;

/// What can be done about lines that lie elsewhere.
const REMEDY: &str = "give the lines' unit by --scale, such as 1000 for millimetres, their axes by --up, or --in model where \
                      they stand in the model's own frame";

/// Arguments of `sinew fibres`.
#[derive(Debug, Args)]
#[command(group = ArgGroup::new("direction").required(true).args(["to", "from"]))]
pub struct Fibres {
    /// Scene file
    scene: PathBuf,
    #[command(flatten)]
    sets: Sets,
    /// Write the fibres as lines to this file: OBJ, CSV or JSON
    #[arg(long, value_name = "FILE")]
    to: Option<PathBuf>,
    /// Read the lines of this file, OBJ, CSV or JSON, as fibres
    #[arg(long, value_name = "FILE", requires = "out")]
    from: Option<PathBuf>,
    /// Scene file to write with the fibres of --from
    #[arg(long, value_name = "SCENE.json", conflicts_with = "to")]
    out: Option<PathBuf>,
    /// Name or identifier of the body: all unless given, or the one that a line names
    #[arg(long, value_name = "BODY")]
    body: Option<String>,
    /// Frame in which the lines stand
    #[arg(long = "in", value_enum, default_value_t)]
    frame: LineFrame,
    /// Units of the lines to a metre: 1000 for millimetres
    #[arg(long, value_name = "N", value_parser = super::motion::scale, default_value_t = 1.0)]
    scale: f64,
    /// Axis of the lines that points up
    #[arg(long, value_enum, default_value_t = Up::Y)]
    up: Up,
}

/// Frames in which lines stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum LineFrame {
    /// The world, with every body where it was put
    #[default]
    World,
    /// The body's own, which is that of its model's file
    Model,
}

/// Writes or reads fibres.
///
/// # Errors
/// A scene, a file of lines or a body that cannot be used; a file that cannot be written.
pub(super) fn run(args: &Fibres, console: &mut Console) -> Result<Outcome, CliError> {
    for path in args.to.iter().chain(&args.from) {
        check_lines_name(path)?;
    }
    let mut loaded = load(Some(&args.scene), &args.sets, None, console)?;
    let baked = bake_with_notes(&mut loaded, Some(&args.scene), console)?;
    let mut scene = loaded.scene;
    let space = Space { up: args.up.axis(), scale: args.scale };
    let at = LineSpace { in_model: args.frame == LineFrame::Model, space };
    let sites = LineSites::new(&scene, &baked.world, at);
    let only = args.body.as_ref().map(|name| sites.find(name)).transpose();
    let inputs = output::inputs(Some(&args.scene), &scene);
    let mut text = String::new();
    if let Some(path) = &args.to {
        check(&inputs, &[("--to", Some(path))])?;
        let only = only?;
        let lines = sites.lines(|body, _| only.is_none_or(|only| only == body))?;
        write_lines(path, &lines)?;
        text = wrote(&format!("{} fibres", lines.len()), path);
    } else if let (Some(from), Some(out)) = (&args.from, &args.out) {
        check(&inputs.and("--from", Some(from)), &[("--out", Some(out))])?;
        let fibres = sites.read(from, only?, REMEDY)?;
        let count = fibres.len();
        for (body, fibre) in fibres {
            scene.bodies[body].fibres.push(fibre);
        }
        scene.validate()?;
        let scene = with_models_from(scene, folder_of(Some(&args.scene)), out)?;
        save_scene(out, &scene)?;
        text = wrote(&format!("the scene with {count} fibres more"), out);
    }
    console.print(&text)?;
    Ok(Outcome::Done)
}
