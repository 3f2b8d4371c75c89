//! Fibres as lines of other programs, and back.

use super::TransferError;
use crate::edit::fibre_ops::{LEAST_VERTICES, NEW_VOLUME_FRACTION, STIFFER, Sampling, rigidity_of, vertices};
use crate::export::Space;
use crate::io::{NamedLine, read_lines};
use crate::scene::{Body, Fibre, Placement, Scene, one_line};
use crate::solver::body::Body as WorldBody;
use crate::solver::world::World;
use crate::text::number::four_figures;
use glam::{DQuat, DVec3};
use std::path::Path;

/// Frame, unit and axes in which lines stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LineSpace {
    /// Whether in a body's own frame, that of its model's file; else in the world, with every body where it was put.
    pub(crate) in_model: bool,
    /// Unit and axes.
    pub(crate) space: Space,
}

/// The fibre solids of a scene as lines see them.
pub(crate) struct LineSites<'a> {
    scene: &'a Scene,
    sites: Vec<Site>,
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
    fn new(body: &Body, of: &WorldBody, at: LineSpace) -> Self {
        let parts = of.parts();
        let around = parts.model.iter().map(|&p| [p; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        let corners = around.unwrap_or_default();
        let spacing = parts.reach * body.material.spacing_ratio;
        let placement = if at.in_model { Placement::default() } else { body.placement.clone() };
        Self {
            turn: placement.rotation.quaternion(),
            shift: DVec3::from_array(placement.translation),
            space: at.space,
            sampling: Sampling { model_diagonal: (corners[1] - corners[0] + DVec3::splat(spacing)).length(), spacing },
            corners,
            reach: parts.reach,
        }
    }

    fn out(&self, point: DVec3) -> DVec3 {
        self.space.place(self.turn * point + self.shift)
    }

    fn back(&self, point: DVec3) -> DVec3 {
        self.turn.inverse() * (self.space.back(point) - self.shift)
    }

    /// How far a place of the model frame lies from the body [m].
    fn distance(&self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.corners[0], self.corners[1]))
    }
}

impl<'a> LineSites<'a> {
    /// Of a scene that was put together as a world.
    pub(crate) fn new(scene: &'a Scene, world: &World, at: LineSpace) -> Self {
        let sites = scene.bodies.iter().zip(world.bodies()).map(|(body, of)| Site::new(body, of, at)).collect();
        Self { scene, sites }
    }

    /// The place of the body that is meant by a name: its identifier or its title.
    ///
    /// # Errors
    /// [`TransferError::NoBody`] and [`TransferError::SeveralBodies`].
    pub(crate) fn find(&self, name: &str) -> Result<usize, TransferError> {
        let scene = self.scene;
        match meant(scene, name)[..] {
            [index] => Ok(index),
            [] => {
                let titles: Vec<String> = scene.bodies.iter().map(|body| format!("{:?}", body.title())).collect();
                Err(TransferError::NoBody { name: name.to_owned(), bodies: titles.join(", ") })
            }
            ref several => {
                let ids: Vec<String> = several.iter().map(|&index| format!("{:?}", scene.bodies[index].id)).collect();
                Err(TransferError::SeveralBodies { name: name.to_owned(), ids: ids.join(", ") })
            }
        }
    }

    /// Fibres as lines, those that are wanted of each body.
    ///
    /// # Errors
    /// [`TransferError::Fibre`] for one that is no curve.
    pub(crate) fn lines(&self, wanted: impl Fn(usize, &Fibre) -> bool) -> Result<Vec<NamedLine>, TransferError> {
        let mut lines = Vec::new();
        for (index, (body, site)) in self.scene.bodies.iter().zip(&self.sites).enumerate() {
            for fibre in body.fibres.iter().filter(|fibre| wanted(index, fibre)) {
                let of = || format!("fibre {:?} of body {:?}", fibre.id, body.title());
                let found = vertices(fibre, site.sampling);
                let points = found.map_err(|error| TransferError::Fibre { which: of(), problem: error.to_string() })?;
                let points = points.into_iter().map(|point| site.out(point)).collect();
                // Titles may be alike, identifiers never are.
                let (body, name) = (body.id.clone(), fibre.id.clone());
                lines.push(NamedLine { body, name, place: String::new(), points });
            }
        }
        Ok(lines)
    }

    /// The lines of a file as fibres, each with the place of its body: `only`, or else the one that it names. `remedy`
    /// is what can be done about lines that lie elsewhere.
    ///
    /// # Errors
    /// A file that cannot be read or holds nothing; a line that can be no fibre or lies far outside, with figures.
    pub(crate) fn read(
        &self,
        file: &Path,
        only: Option<usize>,
        remedy: &str,
    ) -> Result<Vec<(usize, Fibre)>, TransferError> {
        let is_body = |name: &str| {
            let meant = meant(self.scene, name);
            only.map_or(!meant.is_empty(), |only| meant.contains(&only))
        };
        let shown = one_line(&file.display().to_string());
        let lines = read_lines(file, is_body)?;
        if lines.is_empty() {
            return Err(TransferError::Fibre { which: shown, problem: "it holds no lines".to_owned() });
        }
        let mut fibres: Vec<(usize, Fibre)> = Vec::new();
        for line in &lines {
            let which = || format!("{shown}: {}{}", line.place, quoted(&line.name));
            let index = only.map_or_else(|| self.chosen(line), Ok)?;
            let points = self.places(index, line, remedy);
            let points = points.map_err(|problem| TransferError::Fibre { which: which(), problem })?;
            let (body, site) = (&self.scene.bodies[index], &self.sites[index]);
            let mut material = body.material.clone();
            material.support_radius = site.reach;
            let added = fibres.iter().filter(|(of, _)| *of == index).map(|(_, fibre)| fibre);
            let id = free_id(body.fibres.iter().chain(added), &line.name);
            let fibre = Fibre::through(id, points.into_iter().map(|point| point.to_array()))
                .with_name(line.name.clone())
                .with_stiffness(rigidity_of(&material, STIFFER))
                .with_volume_fraction(NEW_VOLUME_FRACTION);
            fibres.push((index, fibre));
        }
        Ok(fibres)
    }

    /// The vertices of a line in the frame of a body [m], or why they are no fibre of it.
    fn places(&self, index: usize, line: &NamedLine, remedy: &str) -> Result<Vec<DVec3>, String> {
        let site = &self.sites[index];
        if line.points.len() < LEAST_VERTICES {
            let count = line.points.len();
            return Err(format!("a fibre has {LEAST_VERTICES} vertices at least, and this has {count}"));
        }
        let points: Vec<DVec3> = line.points.iter().map(|&point| site.back(point)).collect();
        let far = points.iter().map(|&point| site.distance(point)).fold(0.0, f64::max);
        let near = points.iter().map(|&point| site.distance(point)).fold(f64::INFINITY, f64::min);
        let size = site.corners[1] - site.corners[0];
        if near > site.reach || far > size.length() {
            return Err(format!(
                "its vertices lie {} to {} m outside of body {:?}, which measures {} m: {remedy}",
                four_figures(near),
                four_figures(far),
                self.scene.bodies[index].title(),
                size.to_array().map(four_figures).join(" x "),
            ));
        }
        Ok(points)
    }

    /// The body that a line becomes a fibre of: the one that it names, or the only one.
    fn chosen(&self, line: &NamedLine) -> Result<usize, TransferError> {
        match self.find(if line.body.is_empty() { &line.name } else { &line.body }) {
            Err(TransferError::NoBody { .. }) if self.scene.bodies.len() == 1 => Ok(0),
            found => found,
        }
    }
}

/// The bodies that may be meant by a name: the one of that identifier, or else all of that title, the two also as one
/// word.
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

fn quoted(name: &str) -> String {
    if name.is_empty() { String::new() } else { format!(", {:?}", one_line(name)) }
}

/// An identifier like a name that none of these fibres has.
fn free_id<'a>(known: impl Iterator<Item = &'a Fibre>, name: &str) -> String {
    let taken: Vec<&str> = known.map(|fibre| fibre.id.as_str()).collect();
    let name = if name.is_empty() { "line" } else { name };
    let is_free = |id: &String| !taken.contains(&id.as_str());
    let numbered = (2..).map(|number| format!("{name}-{number}"));
    std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
}
