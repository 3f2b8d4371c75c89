//! What a run has shown, ready for JSON.

use super::runner::Runner;
use crate::scene::Scene;
use crate::solver::body::Body;
use crate::solver::collider::Collider;
use crate::solver::energy::Energies;
use crate::solver::measure::MeasureValue;
use crate::solver::world::{Accuracy, World};
use crate::text::fnv::Fnv;
use serde::Serialize;

/// Result of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Name of the scene.
    pub scene: String,
    /// Simulated time [s].
    pub seconds: f64,
    /// Frames advanced.
    pub frames: u64,
    /// Whether the run went to its end; false where it was interrupted.
    pub complete: bool,
    /// Whether everything had come to rest and nothing diverged.
    pub at_rest: bool,
    /// Time spent stepping [s].
    pub wall_seconds: f64,
    /// Simulated over wall seconds.
    pub real_time_factor: f64,
    /// One entry a body.
    pub bodies: Vec<BodyReport>,
    /// One entry a collider; left out where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub colliders: Vec<ColliderReport>,
    /// One entry a measure.
    pub measures: Vec<MeasureReport>,
    /// How accurate all of it was together, contact between bodies and with panels included; null where there is but
    /// one body and no panel, and where a body is not watched.
    pub accuracy: Option<AccuracyReport>,
    /// What gained energy that nothing gave it, as it was said, in the order of time.
    pub unbalanced: Vec<String>,
    /// What was noticed while the scene was put together.
    pub notes: Vec<String>,
}

/// What a run cost in accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AccuracyReport {
    /// Energy less the work from outside, since the start [J]: below zero what was dissipated, above it what was
    /// gained.
    pub energy_change: f64,
    /// The most by which that has risen over a time, beyond a hundredth a second of the energy handled [J]: an error of
    /// the integration.
    pub energy_gained: f64,
    /// The greatest energy handled, by which the gain is judged [J]: of motion and all potentials.
    pub energy_handled: f64,
    /// Linear momentum that came from nowhere while nothing but steady gravity, other bodies and panels acted [kg m/s];
    /// null where something else always did.
    pub linear_momentum_drift: Option<f64>,
    /// The same of angular momentum, of a body about its centre of mass [kg m²/s].
    pub angular_momentum_drift: Option<f64>,
    /// For how long momenta were followed so [s].
    pub followed_seconds: f64,
}

impl AccuracyReport {
    fn new(of: Accuracy) -> Self {
        Self {
            energy_change: of.change,
            energy_gained: of.gained,
            energy_handled: of.handled,
            linear_momentum_drift: of.drift.map(|drift| drift[0]),
            angular_momentum_drift: of.drift.map(|drift| drift[1]),
            followed_seconds: of.followed,
        }
    }
}

/// One body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyReport {
    /// Identifier in the scene.
    pub id: String,
    /// Name a person reads.
    pub name: String,
    /// Kind of body.
    pub kind: &'static str,
    /// Material particles.
    pub particles: usize,
    /// Mean number of neighbours of a material particle.
    pub mean_neighbours: f64,
    /// Fibres in the material.
    pub fibres: usize,
    /// Vertices of all fibres.
    pub structure_particles: usize,
    /// How it is stepped: the integrator's word, as in scene files; "other" once a program has given the body its own.
    pub integrator: &'static str,
    /// Why, where the scene leaves that open and it is not the usual one; null otherwise.
    pub integrator_reason: Option<String>,
    /// Time step [s].
    pub dt: f64,
    /// Greatest stable time step [s].
    pub stable_dt: Option<f64>,
    /// JSON pointer of the parameter that sets the stable step: of all, halving it raises that step most. Null where no
    /// single one does by more than a hundredth.
    pub limited_by: Option<String>,
    /// Breaks of its fibres.
    pub breaks: usize,
    /// Time of the first of them [s]; null if there is none.
    pub first_break: Option<f64>,
    /// Pairs of neighbours across its seams that are torn.
    pub torn: usize,
    /// When the first of them tore [s]; null if none has.
    pub first_tear: Option<f64>,
    /// Time steps taken.
    pub steps: u64,
    /// Force evaluations made.
    pub evaluations: u64,
    /// Implicit steps that were taken in two halves, since no solution was found for the whole.
    pub halved_steps: u64,
    /// Implicit steps, whole or halved, that leap-frog took over.
    pub handed_over_steps: u64,
    /// Why the body was stopped; null if it was not.
    pub diverged: Option<String>,
    /// Energies [J].
    pub energy: Energies,
    /// What its motion cost in accuracy; null of one that was stopped or is not watched.
    pub accuracy: Option<AccuracyReport>,
    /// Linear momentum [kg m/s].
    pub linear_momentum: [f64; 3],
    /// Angular momentum about the world's origin [kg m²/s].
    pub angular_momentum: [f64; 3],
    /// Hash of all positions and velocities, of what has yielded, and of where it holds on to colliders, equal only for
    /// equal bits; to be compared on one machine.
    pub state_hash: String,
}

/// One collider.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ColliderReport {
    /// Identifier in the scene.
    pub id: String,
    /// Name a person reads.
    pub name: String,
    /// Force of all bodies on it [N].
    pub force: [f64; 3],
    /// Work that it has done on the bodies so far [J].
    pub work: f64,
    /// Where its own origin is [m].
    pub translation: [f64; 3],
}

/// One measure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeasureReport {
    /// Name in the scene.
    pub name: String,
    /// Kind of measure.
    pub kind: &'static str,
    /// A number, or a vector of three.
    pub value: serde_json::Value,
    /// Unit of the value.
    pub unit: &'static str,
}

impl Report {
    /// What `runner` shows after `wall_seconds` of stepping.
    pub fn new(scene: &Scene, runner: &Runner, wall_seconds: f64, notes: Vec<String>) -> Self {
        let world = runner.world();
        let seconds = world.time();
        Self {
            scene: scene.name.clone(),
            seconds,
            frames: world.frame(),
            complete: true,
            at_rest: runner.at_rest() && world.divergence().is_none(),
            wall_seconds,
            real_time_factor: if wall_seconds > 0.0 { seconds / wall_seconds } else { 0.0 },
            bodies: (0..world.bodies().len()).map(|index| BodyReport::new(world, index)).collect(),
            colliders: world
                .colliders()
                .iter()
                .enumerate()
                .map(|(index, of)| ColliderReport::new(world, index, of))
                .collect(),
            measures: world
                .probes()
                .iter()
                .zip(runner.reported_measures())
                .map(|(probe, value)| MeasureReport {
                    name: probe.name.clone(),
                    kind: probe.quantity.kind(),
                    value: match value {
                        MeasureValue::Scalar(value) => serde_json::json!(value),
                        MeasureValue::Vector(value) => serde_json::json!(value.to_array()),
                    },
                    unit: probe.quantity.unit(),
                })
                .collect(),
            accuracy: world.accuracy().map(AccuracyReport::new),
            unbalanced: world.unbalanced().iter().map(ToString::to_string).collect(),
            notes,
        }
    }
}

impl Report {
    /// What in it is no finite number, the first of it, by its name; none where all is well. A measure
    /// has null in its place.
    pub fn not_finite(&self) -> Option<String> {
        let body = |body: &BodyReport| {
            let energies = body.energy.named().into_iter();
            let momenta = [("linear momentum", body.linear_momentum), ("angular momentum", body.angular_momentum)];
            let momenta = momenta.into_iter().map(|(name, momentum)| (name, momentum.iter().sum::<f64>()));
            let first = energies.chain(momenta).find(|(_, value)| !value.is_finite());
            first.map(|(what, _)| format!("{what} of body \"{}\"", body.name))
        };
        let is_null = |value: &serde_json::Value| match value {
            serde_json::Value::Array(parts) => parts.iter().any(serde_json::Value::is_null),
            other => other.is_null(),
        };
        let measure = self.measures.iter().find(|measure| is_null(&measure.value));
        self.bodies.iter().find_map(body).or_else(|| measure.map(|measure| format!("measure \"{}\"", measure.name)))
    }
}

impl ColliderReport {
    fn new(world: &World, index: usize, of: &Collider) -> Self {
        Self {
            id: of.id.clone(),
            name: of.name.clone(),
            force: world.force_on_collider(index).to_array(),
            work: world.work_of_collider(index),
            translation: of.pose(world.time()).translation.to_array(),
        }
    }
}

impl BodyReport {
    fn new(world: &World, index: usize) -> Self {
        let (body, time) = (&world.bodies()[index], world.time());
        let parts = body.parts();
        let state = body.state();
        Self {
            id: parts.id.clone(),
            name: parts.name.clone(),
            kind: parts.kind,
            particles: state.len(),
            mean_neighbours: parts.mean_neighbours,
            fibres: parts.fibres.len(),
            structure_particles: parts.fibres.iter().map(|fibre| fibre.vertices.len()).sum(),
            integrator: parts.integrator_word,
            integrator_reason: parts.integrator_reason.clone(),
            dt: parts.dt,
            stable_dt: Some(parts.stable_dt).filter(|dt| dt.is_finite()),
            limited_by: parts.limited_by.clone(),
            breaks: body.breaks().count(),
            first_break: body.breaks().map(|at| at.time).reduce(f64::min),
            torn: body.tears().iter().map(|seam| seam.torn).sum(),
            first_tear: body.first_tear(),
            steps: body.steps(),
            evaluations: body.evaluations(),
            halved_steps: body.fallbacks().halved,
            handed_over_steps: body.fallbacks().handed_over,
            diverged: body.divergence().map(ToString::to_string),
            energy: body.energies(time),
            accuracy: world.accuracy_of(index).map(AccuracyReport::new),
            linear_momentum: state.linear_momentum().to_array(),
            angular_momentum: state.angular_momentum().to_array(),
            state_hash: state_hash([body]),
        }
    }
}

/// Hash (FNV-1a) of a state of bodies, equal only for equal bits: of positions, velocities and what forces remember of
/// the motion so far.
pub(super) fn state_hash<'a>(bodies: impl IntoIterator<Item = &'a Body>) -> String {
    let mut hash = Fnv::START;
    bodies.into_iter().for_each(|body| add_state(body, &mut hash));
    hash.hex()
}

fn add_state(body: &Body, hash: &mut Fnv) {
    for v in body.state().positions.iter().chain(&body.state().velocities) {
        for component in v.to_array() {
            hash.add(&component.to_bits().to_le_bytes());
        }
    }
    for force in &body.parts().forces {
        force.remembered(&mut |number| hash.add(&number.to_bits().to_le_bytes()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bake::bake;
    use crate::scene::{Assets, Body as SceneBody};
    use crate::sim::TimeSeries;
    use crate::solver::forces::Force;
    use crate::solver::state::ParticleState;
    use glam::DVec3;

    /// Pushes nothing, and stores an energy that is no number.
    #[derive(Clone)]
    struct Wrong;

    impl Force for Wrong {
        fn add_forces(&mut self, _time: f64, _state: &ParticleState, _forces: &mut [DVec3]) {}

        fn add_energy(&self, _time: f64, _state: &ParticleState, energies: &mut Energies) {
            energies.springs += f64::NAN;
        }

        fn clone_box(&self) -> Box<dyn Force> {
            Box::new(self.clone())
        }
    }

    #[test]
    fn a_result_that_is_no_number_is_named() {
        let scene = Scene::new("box").with_body(SceneBody::cuboid("box", [0.03; 3]).with_name("Box"));
        let mut runner = Runner::new(bake(&scene, &Assets::default()).expect("a scene"));
        let found = |runner: &Runner| {
            let mut series = TimeSeries::new(runner.world(), 10);
            series.push(runner.world());
            let in_series = series.not_finite().map(|(time, column)| (time, column.to_owned()));
            (Report::new(&scene, runner, 0.0, Vec::new()).not_finite(), in_series)
        };
        assert_eq!(found(&runner), (None, None));
        runner.body_mut(0).expect("a body").add_force(Box::new(Wrong));
        let expected = (Some("springs of body \"Box\"".to_owned()), Some((0.0, "box: springs".to_owned())));
        assert_eq!(found(&runner), expected);
    }
}
