//! Energies, momenta and measures frame by frame, as CSV.

use super::CliError;
use crate::scene::one_line;
use crate::sim::{EnergyReport, Runner};
use crate::solver::body::Body;
use crate::solver::measure::MeasureValue;
use crate::solver::world::World;
use std::collections::HashSet;

/// Rows so far. They are kept in memory and written once, so that a run that is broken off leaves no half file.
pub struct Series {
    writer: csv::Writer<Vec<u8>>,
}

impl Series {
    /// The head of the table for a world.
    ///
    /// # Errors
    /// [`CliError::Series`] where it cannot be formatted.
    pub fn new(world: &World) -> Result<Self, CliError> {
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        writer.write_record(head(world))?;
        Ok(Self { writer })
    }

    /// Adds the present frame.
    ///
    /// # Errors
    /// [`CliError::Series`] where it cannot be formatted.
    pub fn push(&mut self, runner: &Runner) -> Result<(), CliError> {
        Ok(self.writer.serialize(row(runner.world()))?)
    }

    /// The table as CSV.
    ///
    /// # Errors
    /// [`CliError::Series`] where it cannot be formatted.
    pub fn into_bytes(self) -> Result<Vec<u8>, CliError> {
        self.writer.into_inner().map_err(|error| CliError::Series(error.into_error().into()))
    }
}

/// Names by which bodies are told apart: their names, or their identifiers where two share a name.
pub fn labels(bodies: &[Body]) -> Vec<String> {
    let names: HashSet<&str> = bodies.iter().map(|body| body.parts().name.as_str()).collect();
    let unique = names.len() == bodies.len();
    bodies.iter().map(|body| one_line(if unique { &body.parts().name } else { &body.parts().id })).collect()
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn head(world: &World) -> Vec<String> {
    let bodies = world.bodies();
    let mut columns = vec!["time [s]".to_owned()];
    for (body, label) in bodies.iter().zip(labels(bodies)) {
        let prefix = if bodies.len() > 1 { format!("{label}: ") } else { String::new() };
        let energies = EnergyReport::new(body, world.time()).named();
        columns.extend(energies.map(|(name, _)| format!("{prefix}{name} [J]")));
        columns.extend(AXES.map(|axis| format!("{prefix}linear_momentum {axis} [kg m/s]")));
        columns.extend(AXES.map(|axis| format!("{prefix}angular_momentum {axis} [kg m²/s]")));
    }
    for probe in world.probes() {
        let (name, unit) = (one_line(&probe.name), probe.quantity.unit());
        if probe.quantity.is_vector() {
            columns.extend(AXES.map(|axis| format!("{name} {axis} [{unit}]")));
        } else {
            columns.push(format!("{name} [{unit}]"));
        }
    }
    columns
}

fn row(world: &World) -> Vec<f64> {
    let mut row = vec![world.time()];
    for body in world.bodies() {
        row.extend(EnergyReport::new(body, world.time()).named().map(|(_, value)| value));
        row.extend(body.state().linear_momentum().to_array());
        row.extend(body.state().angular_momentum().to_array());
    }
    for value in world.measures() {
        match value {
            MeasureValue::Scalar(value) => row.push(value),
            MeasureValue::Vector(value) => row.extend(value.to_array()),
        }
    }
    row
}
