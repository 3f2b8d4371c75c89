//! `sinew fibres`: a scene's fibres as lines for other programs, and lines of other programs as fibres.

use super::error::printable;
use super::motion::Up;
use super::output::{self, check, wrote};
use super::prepare::{Sets, folder_of, load, put_together};
use super::{CliError, Console, Outcome};
use crate::edit::fibre_ops::{LEAST_VERTICES, NEW_VOLUME_FRACTION, STIFFER, Sampling, rigidity_of, vertices};
use crate::export::Space;
use crate::geometry::model::UpAxis;
use crate::io::{NamedLine, check_lines_name, read_lines, save_scene, with_models_from, write_lines};
use crate::scene::{Body, Fibre, Placement, Scene, one_line};
use crate::solver::body::Body as WorldBody;
use crate::text::number::four_figures;
use clap::{ArgGroup, Args, ValueEnum};
use glam::{DQuat, DVec3};
use std::path::{Path, PathBuf};

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
    let baked = put_together(&mut loaded, Some(&args.scene), console)?;
    let mut scene = loaded.scene;
    let bodies: Vec<Site> =
        scene.bodies.iter().zip(baked.world.bodies()).map(|(body, of)| Site::new(body, of, args)).collect();
    let inputs = output::inputs(Some(&args.scene), &scene);
    let mut text = String::new();
    if let Some(path) = &args.to {
        check(&inputs, &[("--to", Some(path))])?;
        let lines = lines(&scene, &bodies, args)?;
        write_lines(path, &lines)?;
        text = wrote(&format!("{} fibres", lines.len()), path);
    }
    if let (Some(from), Some(out)) = (&args.from, &args.out) {
        check(&inputs.and("--from", Some(from)), &[("--out", Some(out))])?;
        let count = add(&mut scene, &bodies, from, args)?;
        let scene = with_models_from(scene, folder_of(Some(&args.scene)), out)?;
        save_scene(out, &scene)?;
        text = wrote(&format!("the scene with {count} fibres more"), out);
    }
    console.print(&text)?;
    Ok(Outcome::Done)
}

/// Where a body stands and what it spans.
struct Site {
    turn: DQuat,
    shift: DVec3,
    space: Space,
    sampling: Sampling,
    /// Corners of the box around its particles, model frame [m].
    corners: [DVec3; 2],
    reach: f64,
}

impl Site {
    fn new(body: &Body, of: &WorldBody, args: &Fibres) -> Self {
        let parts = of.parts();
        let around = parts.model.iter().map(|&p| [p; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        let corners = around.unwrap_or_default();
        let spacing = parts.reach * body.material.spacing_ratio;
        let is_placed = args.frame == LineFrame::World;
        let placement = if is_placed { body.placement.clone() } else { Placement::default() };
        Self {
            turn: placement.rotation.quaternion(),
            shift: DVec3::from_array(placement.translation),
            space: Space { up: if args.up == Up::Z { UpAxis::Z } else { UpAxis::Y }, scale: args.scale },
            sampling: Sampling { model_diagonal: (corners[1] - corners[0] + DVec3::splat(spacing)).length(), spacing },
            corners,
            reach: parts.reach,
        }
    }

    fn out(&self, point: DVec3) -> DVec3 {
        self.space.place(self.turn * point + self.shift)
    }

    fn back(&self, point: DVec3) -> DVec3 {
        self.turn.inverse() * (self.space.up.stand_up(point) / self.space.scale - self.shift)
    }

    /// How far a place of the model frame lies from the body [m].
    fn distance(&self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.corners[0], self.corners[1]))
    }
}

/// The bodies that may be meant by a name: the one of that identifier, or else all of that title, the two also as one word.
fn meant(scene: &Scene, name: &str) -> Vec<usize> {
    let word = |name: &str| name.replace(|c: char| c.is_whitespace() || c.is_control(), "_");
    let ways: [&dyn Fn(&Body) -> bool; 4] =
        [&|body| body.id == name, &|body| word(&body.id) == name, &|body| body.title() == name, &|body| {
            word(body.title()) == name
        }];
    let all = |is_it: &dyn Fn(&Body) -> bool| -> Vec<usize> {
        scene.bodies.iter().enumerate().filter(|(_, body)| is_it(body)).map(|(index, _)| index).collect()
    };
    ways.into_iter().map(all).find(|found| !found.is_empty()).unwrap_or_default()
}

/// The one body that is meant by a name.
fn find(scene: &Scene, name: &str) -> Result<usize, CliError> {
    match meant(scene, name)[..] {
        [index] => Ok(index),
        [] => Err(no_body(name, scene)),
        ref several => {
            let ids: Vec<String> = several.iter().map(|&index| format!("{:?}", scene.bodies[index].id)).collect();
            Err(CliError::SeveralBodies { name: name.to_owned(), ids: ids.join(", ") })
        }
    }
}

fn lines(scene: &Scene, bodies: &[Site], args: &Fibres) -> Result<Vec<NamedLine>, CliError> {
    let mut lines = Vec::new();
    let only = args.body.as_ref().map(|name| find(scene, name)).transpose()?;
    for (index, (body, site)) in scene.bodies.iter().zip(bodies).enumerate() {
        if only.is_some_and(|only| only != index) {
            continue;
        }
        for fibre in &body.fibres {
            let of = || format!("fibre {:?} of body {:?}", fibre.id, body.title());
            let found = vertices(fibre, site.sampling);
            let points = found.map_err(|error| CliError::Fibre { which: of(), problem: error.to_string() })?;
            let points = points.into_iter().map(|point| site.out(point)).collect();
            // Titles may be alike, identifiers never are.
            let (body, name) = (body.id.clone(), fibre.id.clone());
            lines.push(NamedLine { body, name, place: String::new(), points });
        }
    }
    Ok(lines)
}

fn no_body(name: &str, scene: &Scene) -> CliError {
    let titles: Vec<String> = scene.bodies.iter().map(|body| format!("{:?}", body.title())).collect();
    CliError::NoBody { name: name.to_owned(), bodies: titles.join(", ") }
}

/// Adds the lines of a file as fibres; gives how many.
fn add(scene: &mut Scene, bodies: &[Site], file: &Path, args: &Fibres) -> Result<usize, CliError> {
    let only = args.body.as_ref().map(|name| find(scene, name)).transpose()?;
    let is_body = |name: &str| {
        let meant = meant(scene, name);
        only.map_or(!meant.is_empty(), |only| meant.contains(&only))
    };
    let lines = read_lines(file, is_body)?;
    if lines.is_empty() {
        return Err(CliError::Fibre { which: printable(file), problem: "it holds no lines".to_owned() });
    }
    for line in &lines {
        let index = only.map_or_else(|| chosen(scene, line), Ok)?;
        let site = &bodies[index];
        let which = || format!("{}: {}{}", printable(file), line.place, quoted(&line.name));
        let refuse = |problem: String| Err(CliError::Fibre { which: which(), problem });
        if line.points.len() < LEAST_VERTICES {
            return refuse(format!(
                "a fibre has {LEAST_VERTICES} vertices at least, and this has {}",
                line.points.len()
            ));
        }
        let points: Vec<DVec3> = line.points.iter().map(|&point| site.back(point)).collect();
        let far = points.iter().map(|&point| site.distance(point)).fold(0.0, f64::max);
        let near = points.iter().map(|&point| site.distance(point)).fold(f64::INFINITY, f64::min);
        let size = site.corners[1] - site.corners[0];
        let body = &mut scene.bodies[index];
        if near > site.reach || far > size.length() {
            return refuse(format!(
                "its vertices lie {} to {} m outside of body {:?}, which measures {} m: give the lines' unit by --scale, \
                 such as 1000 for millimetres, their axes by --up, or --in model where they stand in the model's own frame",
                four_figures(near),
                four_figures(far),
                body.title(),
                size.to_array().map(four_figures).join(" x "),
            ));
        }
        let mut material = body.material.clone();
        material.support_radius = site.reach;
        let id = free_id(body, &line.name);
        let fibre = Fibre::through(id, points.into_iter().map(|point| point.to_array()))
            .with_name(line.name.clone())
            .with_stiffness(rigidity_of(&material, STIFFER))
            .with_volume_fraction(NEW_VOLUME_FRACTION);
        body.fibres.push(fibre);
    }
    scene.validate()?;
    Ok(lines.len())
}

/// The body that a line becomes a fibre of: the one that it names, or the only one.
fn chosen(scene: &Scene, line: &NamedLine) -> Result<usize, CliError> {
    match find(scene, if line.body.is_empty() { &line.name } else { &line.body }) {
        Err(CliError::NoBody { .. }) if scene.bodies.len() == 1 => Ok(0),
        found => found,
    }
}

fn quoted(name: &str) -> String {
    if name.is_empty() { String::new() } else { format!(", {:?}", one_line(name)) }
}

/// An identifier like a name that no fibre of the body has.
fn free_id(body: &Body, name: &str) -> String {
    let name = if name.is_empty() { "line" } else { name };
    let is_free = |id: &String| body.fibres.iter().all(|fibre| fibre.id != *id);
    let numbered = (2..).map(|number| format!("{name}-{number}"));
    std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
}
