//! The scene as a whole.

use super::{Body, Collider, Drive, Extra, Measure, Panel, Room, Time, TimeStep, TwoLayer, Wind};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Version of the scene format that this program reads and writes.
pub const SCENE_VERSION: u32 = 1;

/// More particles than this are refused (with the memory they would take) instead of exhausting the machine.
pub const MAX_PARTICLES: usize = 2_000_000;

/// The system of units of a scene file. There is one, and the file says so.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Units {
    /// Metre, kilogram, second, newton, pascal; degrees for angles.
    #[default]
    #[serde(rename = "SI")]
    Si,
}

/// A whole scene: the document that is edited, saved and baked into a simulated world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Scene {
    /// Version of the format; this program reads and writes version 1.
    pub version: u32,
    /// Units of every number in the file: "SI".
    #[serde(default)]
    pub units: Units,
    /// Name a person reads.
    #[serde(default)]
    pub name: String,
    /// What the scene shows, in a sentence or two.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub description: String,
    /// Gravitational acceleration [m/s²], world axes.
    #[serde(default = "earth_gravity")]
    pub gravity: [f64; 3],
    /// What gravity is multiplied by; by 1 unless given. None that is shared, which only bodies have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gravity_drive: Option<Drive>,
    /// Air or water that the bodies move in; none unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wind: Option<Wind>,
    /// Floor, walls and ceiling.
    #[serde(default)]
    pub room: Room,
    /// Rigid horizontal panels that fall on the bodies or are driven.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub panels: Vec<Panel>,
    /// Rigid things that the bodies touch, still or moved.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub colliders: Vec<Collider>,
    /// Frame rate, length and time step.
    #[serde(default)]
    pub time: Time,
    /// The soft bodies.
    #[serde(default)]
    pub bodies: Vec<Body>,
    /// The two-layer bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub two_layer: Vec<TwoLayer>,
    /// Quantities to read off the motion.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub measures: Vec<Measure>,
    /// Unknown fields, kept.
    #[serde(flatten)]
    pub extra: Extra,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            version: SCENE_VERSION,
            units: Units::Si,
            name: String::new(),
            description: String::new(),
            gravity: earth_gravity(),
            gravity_drive: None,
            wind: None,
            room: Room::default(),
            panels: Vec::new(),
            colliders: Vec::new(),
            time: Time::default(),
            bodies: Vec::new(),
            two_layer: Vec::new(),
            measures: Vec::new(),
            extra: Extra::new(),
        }
    }
}

impl Scene {
    /// A scene with nothing in it but the earth's gravity: 60 frames a second, 1 s long.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// With one fibre solid more.
    #[must_use]
    pub fn with_body(mut self, body: Body) -> Self {
        self.bodies.push(body);
        self
    }

    /// With one two-layer body more.
    #[must_use]
    pub fn with_two_layer(mut self, body: TwoLayer) -> Self {
        self.two_layer.push(body);
        self
    }

    /// With one panel more.
    #[must_use]
    pub fn with_panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// With one collider more.
    #[must_use]
    pub fn with_collider(mut self, collider: Collider) -> Self {
        self.colliders.push(collider);
        self
    }

    /// With one quantity more to read off the motion.
    #[must_use]
    pub fn with_measure(mut self, measure: Measure) -> Self {
        self.measures.push(measure);
        self
    }

    /// With another gravitational acceleration [m/s², world axes]; `[0.0; 3]` for none.
    #[must_use]
    pub fn with_gravity(self, gravity: impl Into<[f64; 3]>) -> Self {
        Self { gravity: gravity.into(), ..self }
    }

    /// With air or water that the bodies move in.
    #[must_use]
    pub fn with_wind(self, wind: Wind) -> Self {
        Self { wind: Some(wind), ..self }
    }

    /// With a floor at this height [m, world Y]. Its friction coefficient is 0.4 and it gives back what falls on it
    /// undamped, unless [`Scene::room`] says otherwise.
    #[must_use]
    pub fn with_floor(mut self, height: f64) -> Self {
        self.room.floor = Some(height);
        self
    }

    /// With so many frames to each simulated second.
    #[must_use]
    pub fn with_frame_rate(mut self, frames_per_second: f64) -> Self {
        self.time.frames_per_second = frames_per_second;
        self
    }

    /// With another choice of the time step.
    #[must_use]
    pub fn with_time_step(mut self, step: TimeStep) -> Self {
        self.time.step = step;
        self
    }

    /// The body with this id.
    pub fn body(&self, id: &str) -> Option<&Body> {
        self.bodies.iter().find(|body| body.id == id)
    }

    /// The two-layer body with this id.
    pub fn two_layer_body(&self, id: &str) -> Option<&TwoLayer> {
        self.two_layer.iter().find(|body| body.id == id)
    }

    /// Whether another scene moves as this one does, bit for bit: they differ in what is hidden and in colours at most.
    pub fn moves_like(&self, other: &Self) -> bool {
        self.without_looks() == other.without_looks()
    }

    fn without_looks(&self) -> Self {
        let mut scene = self.clone();
        for mut body in scene.all_bodies_mut() {
            (*body.hidden_mut(), *body.color_mut()) = (false, None);
        }
        for fibre in scene.bodies.iter_mut().flat_map(|body| &mut body.fibres) {
            (fibre.hidden, fibre.color) = (false, None);
        }
        for sheet in scene.bodies.iter_mut().flat_map(|body| &mut body.sheets) {
            (sheet.hidden, sheet.color) = (false, None);
        }
        scene
    }
}

fn earth_gravity() -> [f64; 3] {
    [0.0, -9.81, 0.0]
}
