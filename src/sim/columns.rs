//! What a time series has in its columns. Their names hang on nothing but what they are of: those of one body are the
//! same whatever stands beside it.

use crate::scene::one_line;
use crate::solver::body::Body;
use crate::solver::energy::Energies;
use crate::solver::measure::MeasureValue;
use crate::solver::world::World;
use glam::DVec3;
use std::collections::HashSet;

const AXES: [&str; 3] = ["x", "y", "z"];

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Simulated time.
    Time,
    /// An energy of a body, by its place in [`Energies::NAMES`].
    Energy(usize),
    /// A component of a body's linear momentum.
    LinearMomentum(usize),
    /// A component of a body's angular momentum about the world's origin.
    AngularMomentum(usize),
    /// A measure.
    Measure,
    /// The energy of all bodies and of panels that fall.
    TotalEnergy,
    /// The work that was done on all of them from outside, as [`World::work`] has it.
    TotalWork,
    /// The sum of a body's energies.
    BodyEnergy,
    /// The work that was done on a body from outside, as [`World::work_on`] has it.
    BodyWork,
    /// A coordinate of a body's centre of mass.
    Center(usize),
    /// A component of the force with which a body pushes on a pin.
    PinForce(usize),
    /// The force on a panel from below.
    PanelForce,
    /// The force in the edge of a fibre that is pulled most.
    GreatestTension,
    /// The mean force in the edges of a fibre.
    MeanTension,
    /// The breaks of a fibre so far.
    Breaks,
}

impl ColumnKind {
    /// Whether it is of something that comes and goes while a body stays: a pin, a fibre or a panel.
    pub(super) fn is_of_a_part(self) -> bool {
        let of_fibre = matches!(self, Self::GreatestTension | Self::MeanTension | Self::Breaks);
        of_fibre || matches!(self, Self::PinForce(_) | Self::PanelForce)
    }
}

/// A column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name, with the identifier of the body that it is of.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// What it holds.
    pub kind: ColumnKind,
}

/// Names by which bodies are told apart for people: their names, or their identifiers where two share a name.
pub(crate) fn body_labels(bodies: &[Body]) -> Vec<String> {
    let names: HashSet<&str> = bodies.iter().map(|body| body.parts().name.as_str()).collect();
    let unique = names.len() == bodies.len();
    bodies.iter().map(|body| one_line(if unique { &body.parts().name } else { &body.parts().id })).collect()
}

/// The columns of a world. What is of pins, fibres and panels comes last, so that a world that differs from another in
/// these alone has all else at the same places.
pub(super) fn columns(world: &World) -> Vec<Column> {
    let mut columns = Vec::new();
    let mut add = |name: String, unit, kind| columns.push(Column { name, unit, kind });
    add("time".to_owned(), "s", ColumnKind::Time);
    let bodies = || world.bodies().iter().map(|body| (body, one_line(&body.parts().id)));
    for (_, id) in bodies() {
        for (k, name) in Energies::NAMES.iter().enumerate() {
            add(format!("{id}: {name}"), "J", ColumnKind::Energy(k));
        }
        for (what, unit, kind) in [
            ("linear_momentum", "kg m/s", ColumnKind::LinearMomentum as fn(usize) -> ColumnKind),
            ("angular_momentum", "kg m²/s", ColumnKind::AngularMomentum),
        ] {
            for (k, axis) in AXES.iter().enumerate() {
                add(format!("{id}: {what} {axis}"), unit, kind(k));
            }
        }
    }
    for probe in world.probes() {
        let (name, unit) = (one_line(&probe.name), probe.quantity.unit());
        if probe.quantity.is_vector() {
            for axis in AXES {
                add(format!("{name} {axis}"), unit, ColumnKind::Measure);
            }
        } else {
            add(name, unit, ColumnKind::Measure);
        }
    }
    add("total_energy".to_owned(), "J", ColumnKind::TotalEnergy);
    add("total_work".to_owned(), "J", ColumnKind::TotalWork);
    for (_, id) in bodies() {
        add(format!("{id}: energy"), "J", ColumnKind::BodyEnergy);
        add(format!("{id}: work"), "J", ColumnKind::BodyWork);
        for (k, axis) in AXES.iter().enumerate() {
            add(format!("{id}: center {axis}"), "m", ColumnKind::Center(k));
        }
    }
    for (body, id) in bodies() {
        for pin in body.parts().constraints.iter().filter_map(|constraint| constraint.id.as_deref()) {
            for (k, axis) in AXES.iter().enumerate() {
                add(format!("{id}: pin_force {} {axis}", one_line(pin)), "N", ColumnKind::PinForce(k));
            }
        }
        for (fibre, _) in fibres(body) {
            let fibre = one_line(fibre);
            add(format!("{id}: greatest_tension {fibre}"), "N", ColumnKind::GreatestTension);
            add(format!("{id}: mean_tension {fibre}"), "N", ColumnKind::MeanTension);
            add(format!("{id}: breaks {fibre}"), "1", ColumnKind::Breaks);
        }
    }
    for panel in world.panels() {
        add(format!("panel_force {}", one_line(&panel.id)), "N", ColumnKind::PanelForce);
    }
    columns
}

/// The present values of those columns.
pub(super) fn row(world: &World) -> Vec<f64> {
    let time = world.time();
    let mut row = vec![time];
    for body in world.bodies() {
        row.extend(body.energies(time).values());
        row.extend(body.state().linear_momentum().to_array());
        row.extend(body.state().angular_momentum().to_array());
    }
    let energies: Vec<f64> = (0..world.bodies().len()).map(|index| body_energy(&row, index)).collect();
    for value in world.measures() {
        match value {
            MeasureValue::Scalar(value) => row.push(value),
            MeasureValue::Vector(value) => row.extend(value.to_array()),
        }
    }
    row.extend([energies.iter().sum::<f64>() + world.energy_of_panels(), world.work()]);
    for (index, body) in world.bodies().iter().enumerate() {
        row.extend([energies[index], world.work_on(index)]);
        row.extend(body.state().center().to_array());
    }
    for body in world.bodies() {
        for pin in body.parts().constraints.iter().filter(|constraint| constraint.id.is_some()) {
            let on_it = |&i: &u32| DVec3::select(pin.locked, body.net_force(i as usize), DVec3::ZERO);
            row.extend(pin.particles.iter().map(on_it).sum::<DVec3>().to_array());
        }
        let tensions = body.tensions();
        for (_, lines) in fibres(body) {
            let edges = || lines.iter().flat_map(|&line| tensions[line].iter().copied());
            let count = edges().count().max(1) as f64;
            let breaks = body.breaks().filter(|at| lines.contains(&(at.fibre as usize))).count();
            row.extend([edges().reduce(f64::max).unwrap_or_default(), edges().sum::<f64>() / count, breaks as f64]);
        }
    }
    row.extend((0..world.panels().len()).map(|panel| world.panel_force(panel)));
    row
}

/// Sum of the energies of a body that stand at the beginning of a row.
fn body_energy(row: &[f64], index: usize) -> f64 {
    let energies = Energies::NAMES.len();
    let first = 1 + index * (energies + 2 * AXES.len());
    row[first..first + energies].iter().sum()
}

/// The fibres of a body by their identifiers, each with the centre lines that it is cut into.
fn fibres(body: &Body) -> Vec<(&str, Vec<usize>)> {
    let mut found: Vec<(&str, Vec<usize>)> = Vec::new();
    for (line, id) in body.parts().fibres.iter().map(|line| line.id.as_str()).enumerate() {
        match found.iter_mut().find(|(known, _)| *known == id) {
            Some((_, lines)) => lines.push(line),
            None => found.push((id, vec![line])),
        }
    }
    found
}
