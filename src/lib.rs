//! **sinew** is an interactive stroke-based fibre editor for soft solids: a fibre drawn by one stroke in each of two
//! orthogonal views makes a soft body bend, shear, twist or stiffen, with no constitutive parameters to tune. This
//! crate is its core, its command line and its window: on one machine the same scene gives the same motion, bit for bit,
//! on any number of threads.
//!
//! # The way through the house
//!
//! ```text
//! strokes --sketch--> curve --scene--> Scene --bake--> World --sim--> frames --> Snapshot, Report --io--> files
//!                                                                         |
//!                                                                         +--draw--> DrawList --render--> pixels
//! ```
//!
//! # Rooms
//!
//! - [`text`]: how numbers are written for people.
//! - [`geometry`]: shapes and distances. Kernel, lattice sampling, neighbour search, curves, models and how they are checked,
//!   filled and moved inwards, rigs of skins. Knows nothing of scenes or physics.
//! - [`sketch`]: a pair of strokes in two views becomes one curve in space, or a message that says why not; layouts of
//!   fibres to start from. Pure functions.
//! - [`scene`]: the document. Bodies, materials, fibres, pins, room, panels, time, measures; data and validation only.
//! - [`edit`]: the only writer of an open document; each change is one step of undo and redo. What can be done to a
//!   fibre, as pure functions: [`edit::fibre_ops`].
//! - [`solver`]: a world of bodies and its step. A body is a particle state with a list of [`solver::forces`], and any of
//!   the [`solver::integrators`] steps any body; contact between bodies is the world's. Knows no file, clock, thread
//!   start or window.
//! - [`bake`]: from the document to the solver, the one place where they meet. Pure: the same scene gives the same
//!   world.
//! - [`sim`]: the clock-free [`sim::Runner`] and its reports, whoever runs a scene runs it through this; the thread that
//!   paces it for a window and keeps the last minutes of motion in bounded memory, to be shown again and gone on from
//!   bit for bit; readings frame by frame; the comparison of integrators, by numbers and side by side.
//! - [`io`]: the only file access. Scene JSON and its schema, models, OBJ sequences, atomic writes, recovery, folders of
//!   what the program keeps for a person, traces of what took how long.
//! - [`draw`]: from a scene and a snapshot to what is to be seen, as plain data: meshes, lines, points, pick numbers,
//!   themes. Knows no graphics interface.
//! - `render` (feature `render`): a draw list becomes pixels, and a pixel what was drawn there. Camera, shaders, picking,
//!   pictures without a window. Its shaders are beside it as WGSL files.
//! - [`cli`]: the command line, one file a command.
//! - `ui` (feature `gui`): the window. Reads the document and the newest snapshot; what a person does leaves as a
//!   [`edit::Command`] or a [`sim::SimCommand`].
//!
//! What a room may import: text and geometry nothing; sketch geometry; scene geometry and sketch; edit scene, sketch and
//! geometry; solver geometry; bake scene, sketch, geometry and solver; io scene, geometry and the solver's snapshot;
//! sim scene, bake and solver; draw scene, geometry and the solver's snapshot; render draw and geometry; cli all but
//! ui; ui all but cli; and text any but geometry and solver. A test holds the code to this.
//!
//! # Conventions
//!
//! SI units throughout: metres, kilograms, seconds, newtons, pascals; angles in degrees in scenes and reports, in
//! radians in the code. Frames are right-handed with Y up. A body is described in its *model frame* and put into the
//! world by its placement; capital X in formulae is the rest position, small x the present one. State and forces are
//! f64. Parallel loops write by index and sums run in a fixed order, so that the number of threads changes nothing.
//!
//! # Running a scene
//!
//! ```
//! use sinew::{bake::bake, io::scene_from_json, sim::Runner};
//!
//! let scene = scene_from_json(r#"{
//!     "version": 1,
//!     "room": {"floor": 0.0},
//!     "bodies": [{
//!         "id": "cube",
//!         "shape": {"box": {"center": [0, 0.05, 0], "size": [0.03, 0.03, 0.03]}},
//!         "material": {"young_modulus": 1e5, "mass": {"density": 1000}, "support_radius": 0.015}
//!     }]
//! }"#)?;
//! let baked = bake(&scene, &sinew::scene::Assets::default())?;
//! let mut runner = Runner::new(baked);
//! runner.advance_frame();
//! assert!(runner.world().bodies()[0].state().center().y < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A force and an integrator of your own
//!
//! Both are traits; implement them and hand them to a body. A world can go back to any checkpoint of it and moves on from
//! there bit for bit: what a force or an integrator remembers goes along by its `clone_box`.
//!
//! ```
//! use glam::DVec3;
//! use sinew::solver::{Dynamics, Energies, Force, Integrator, ParticleState};
//!
//! /// A steady push on every particle [N].
//! #[derive(Clone)]
//! struct Wind(DVec3);
//!
//! impl Force for Wind {
//!     fn add_forces(&mut self, _time: f64, _state: &ParticleState, forces: &mut [DVec3]) {
//!         for force in forces {
//!             *force += self.0;
//!         }
//!     }
//!     fn add_energy(&self, _time: f64, _state: &ParticleState, _energies: &mut Energies) {}
//!     fn clone_box(&self) -> Box<dyn Force> {
//!         Box::new(self.clone())
//!     }
//! }
//!
//! /// Kick, then drift: first order, symplectic.
//! #[derive(Clone, Default)]
//! struct SymplecticEuler(Vec<DVec3>);
//!
//! impl Integrator for SymplecticEuler {
//!     fn step(&mut self, dynamics: &mut Dynamics<'_>, state: &mut ParticleState, time: f64, dt: f64) {
//!         dynamics.start(time, state);
//!         dynamics.accelerations(state, &mut self.0);
//!         for i in 0..state.len() {
//!             state.velocities[i] += dt * self.0[i];
//!             state.positions[i] += dt * state.velocities[i];
//!         }
//!         dynamics.constrain(time + dt, state);
//!     }
//!     fn stable_step(&self, omega: f64, _damping: f64) -> f64 {
//!         2.0 / omega
//!     }
//!     fn clone_box(&self) -> Box<dyn Integrator> {
//!         Box::new(self.clone())
//!     }
//! }
//!
//! # let scene = sinew::io::scene_from_json(r#"{"version": 1, "gravity": [0, 0, 0], "bodies": [{"id": "cube",
//! #     "shape": {"box": {"size": [0.03, 0.03, 0.03]}},
//! #     "material": {"young_modulus": 1e5, "mass": {"per_particle": 4e-4}, "support_radius": 0.015}}]}"#)?;
//! let mut world = sinew::bake::bake(&scene, &sinew::scene::Assets::default())?.world;
//! let body = world.body_mut(0).expect("the scene's first body");
//! body.set_integrator(Box::new(SymplecticEuler::default()));
//! body.add_force(Box::new(Wind(DVec3::X * 1e-3)));
//! world.advance_frame();
//! assert!(world.bodies()[0].state().linear_momentum().x > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Where the formulation differs from the papers' print
//!
//! The fibre paper (Liu, He, Ren, Li, Wang: *Physical material editing with structure embedding for animated solid*,
//! Graphics Interface 2012) is neither conservative nor dimensionally consistent as printed. What is done instead, and
//! why, stands at the head of each file: [`geometry::kernel`] (eq. 13 unnormalised), [`solver::forces::matrix`] (eqs. 10
//! to 15), [`solver::forces::fibre`] (eqs. 6 to 8 and the appendix), [`solver::embedding`] (eq. 17),
//! [`scene::PaperStiffness`] (Table 1). The README lists them all.
// Units stand in brackets throughout the docs: [m], [N/m].
#![allow(rustdoc::broken_intra_doc_links, reason = "units in brackets are no links")]

pub mod bake;
pub mod cli;
pub mod draw;
pub mod edit;
pub mod geometry;
pub mod io;
#[cfg(feature = "render")]
pub mod render;
pub mod scene;
pub mod sim;
pub mod sketch;
pub mod solver;
pub mod text;
#[cfg(feature = "gui")]
pub mod ui;
