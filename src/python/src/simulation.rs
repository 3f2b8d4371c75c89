//! A scene that runs.

use crate::arrays::{numbers, rows};
use crate::json::value_of;
use crate::error::refused;
use crate::scene::Scene;
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::{PyKeyError, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sinew::bake::bake;
use sinew::io::load_assets;
use sinew::sim::{Report, Runner, TimeSeries};
use sinew::solver::{Body, FieldKind, MeasureValue};
use std::time::Instant;

/// A scene put together and run frame by frame. What is changed in the scene afterwards does not touch it.
#[pyclass(module = "sinew")]
pub(crate) struct Simulation {
    scene: sinew::scene::Scene,
    runner: Runner,
    series: TimeSeries,
    notes: Vec<String>,
    wall_seconds: f64,
}

/// A body by its identifier or its place in the scene.
#[derive(FromPyObject)]
pub(crate) enum Which {
    /// Its place, from 0.
    Place(usize),
    /// Its identifier.
    Id(String),
}

#[pymethods]
impl Simulation {
    /// Puts a scene together.
    #[new]
    fn new(py: Python<'_>, scene: &Scene) -> PyResult<Self> {
        let (document, folder) = (scene.scene.clone(), scene.folder.clone());
        py.detach(move || {
            let assets = load_assets(&document, &folder, &mut |_| {}).map_err(refused)?;
            let baked = bake(&document, &assets).map_err(refused)?;
            let notes = baked.notes.iter().map(ToString::to_string).collect();
            let runner = Runner::new(baked);
            let mut series = TimeSeries::new(runner.world(), usize::MAX);
            series.push(runner.world());
            Ok(Self { scene: document, runner, series, notes, wall_seconds: 0.0 })
        })
    }

    /// Goes on by some frames. RuntimeError where a body diverges; what was good until then stays to be read.
    #[pyo3(signature = (frames = 1))]
    fn step(&mut self, py: Python<'_>, frames: u64) -> PyResult<()> {
        for _ in 0..frames {
            self.frame(py)?;
        }
        Ok(())
    }

    /// Goes on by a time [s], in whole frames; the scene's duration unless given.
    #[pyo3(signature = (seconds = None))]
    fn run(&mut self, py: Python<'_>, seconds: Option<f64>) -> PyResult<()> {
        let frames = self.runner.frames_for(seconds.unwrap_or(self.scene.time.duration));
        self.step(py, frames)
    }

    /// Goes on until everything rests, for a time [s] at most, ten times the scene's duration unless given; whether it
    /// does.
    #[pyo3(signature = (seconds = None))]
    fn until_rest(&mut self, py: Python<'_>, seconds: Option<f64>) -> PyResult<bool> {
        for _ in 0..self.runner.frames_for(seconds.unwrap_or(10.0 * self.scene.time.duration)) {
            if self.runner.at_rest() {
                break;
            }
            self.frame(py)?;
        }
        Ok(self.runner.at_rest())
    }

    /// Simulated time [s].
    #[getter]
    fn time(&self) -> f64 {
        self.runner.world().time()
    }

    /// Frames so far.
    #[getter]
    fn frame_number(&self) -> u64 {
        self.runner.world().frame()
    }

    /// Whether everything has come to rest.
    #[getter]
    fn at_rest(&self) -> bool {
        self.runner.at_rest()
    }

    /// What was noticed when the scene was put together.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// Identifiers of the bodies, in the order of the scene.
    #[getter]
    fn bodies(&self) -> Vec<String> {
        self.runner.world().bodies().iter().map(|body| body.parts().id.clone()).collect()
    }

    /// Present values of the measures by their names: numbers, or lists of three.
    #[getter]
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (probes, found) = (self.runner.world().probes(), PyDict::new(py));
        for (probe, value) in probes.iter().zip(self.runner.reported_measures()) {
            match value {
                MeasureValue::Scalar(value) => found.set_item(&probe.name, value)?,
                MeasureValue::Vector(value) => found.set_item(&probe.name, value.to_array())?,
            }
        }
        Ok(found)
    }

    /// Positions of the particles [m], (n, 3).
    #[pyo3(signature = (body = Which::Place(0)))]
    fn positions<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.body(&body)?.state().positions.iter().map(|x| x.to_array()))
    }

    /// Velocities of the particles [m/s], (n, 3).
    #[pyo3(signature = (body = Which::Place(0)))]
    fn velocities<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.body(&body)?.state().velocities.iter().map(|v| v.to_array()))
    }

    /// Where the particles are at rest [m], (n, 3).
    #[pyo3(signature = (body = Which::Place(0)))]
    fn rest<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, self.body(&body)?.parts().rest.iter().map(|x| x.to_array()))
    }

    /// Masses of the particles [kg], (n,).
    #[pyo3(signature = (body = Which::Place(0)))]
    fn masses<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(numbers(py, self.body(&body)?.state().masses.clone()))
    }

    /// Equivalent stress of the matrix after von Mises [Pa], (n,); empty of a body without a matrix.
    #[pyo3(signature = (body = Which::Place(0)))]
    fn stresses<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(numbers(py, self.body(&body)?.field(FieldKind::Stress)))
    }

    /// Equivalent strain of the matrix after von Mises, (n,); empty of a body without a matrix.
    #[pyo3(signature = (body = Which::Place(0)))]
    fn strains<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(numbers(py, self.body(&body)?.field(FieldKind::Strain)))
    }

    /// Vertices of the fibres [m] by their identifiers, (n, 3) each; of one that is cut into runs, all of them.
    #[pyo3(signature = (body = Which::Place(0)))]
    fn fibres<'py>(&self, py: Python<'py>, body: Which) -> PyResult<Bound<'py, PyDict>> {
        let (body, found) = (self.body(&body)?, PyDict::new(py));
        let lines = &body.parts().fibres;
        for line in lines {
            let vertices = lines.iter().filter(|other| other.id == line.id).flat_map(|line| &line.vertices);
            let points = vertices.map(|vertex| vertex.gather(&body.state().positions).to_array());
            found.set_item(&line.id, rows(py, points)?)?;
        }
        Ok(found)
    }

    /// Every frame so far: a dictionary of columns, those of `sinew simulate --series` with their units, (frames + 1,)
    /// each.
    fn series<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = PyDict::new(py);
        for (place, column) in self.series.columns().iter().enumerate() {
            let values = self.series.rows().map(|(_, row)| row[place]).collect();
            found.set_item(format!("{} [{}]", column.name, column.unit), numbers(py, values))?;
        }
        Ok(found)
    }

    /// The report of `sinew simulate`, as a dictionary.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        value_of(py, &Report::new(&self.scene, &self.runner, self.wall_seconds, self.notes.clone()))
    }

    fn __repr__(&self) -> String {
        format!("<sinew.Simulation of {:?} at {} s>", self.scene.name, self.time())
    }
}

impl Simulation {
    fn body(&self, which: &Which) -> PyResult<&Body> {
        let bodies = self.runner.world().bodies();
        let found = match which {
            Which::Place(place) => bodies.get(*place),
            Which::Id(id) => bodies.iter().find(|body| body.parts().id == *id),
        };
        found.ok_or_else(|| {
            PyKeyError::new_err(format!("there is no such body; there are {}", self.bodies().join(", ")))
        })
    }

    /// One frame, with Python left to others and Ctrl-C heard between frames.
    fn frame(&mut self, py: Python<'_>) -> PyResult<()> {
        py.check_signals()?;
        let was_good = self.runner.world().divergence().is_none();
        let started = Instant::now();
        py.detach(|| {
            self.runner.advance_frame();
            self.series.push(self.runner.world());
        });
        self.wall_seconds += started.elapsed().as_secs_f64();
        match self.runner.world().divergence() {
            Some(divergence) if was_good => Err(PyRuntimeError::new_err(divergence.to_string())),
            _ => Ok(()),
        }
    }
}
