//! The solver through its public doors: scenes in, forces, energies, momenta and measures out.
#![allow(clippy::unwrap_used, reason = "a test may panic")]
#![allow(clippy::print_stdout, reason = "`--nocapture` shows the measured figures")]

mod asleep;
mod balance;
mod balance_sweep;
mod behaviours;
mod breaking;
mod checkpoints;
mod common;
mod compared;
mod conservation;
mod fast;
mod feynman;
mod fibres;
mod fibres_implicit;
mod fields;
mod figures;
mod forces;
mod friction;
mod implicit;
mod inelastic;
mod measured;
mod meeting;
mod paint;
mod panels;
mod patterns;
mod press;
mod printed;
mod region_materials;
mod rods;
mod round;
mod section_shapes;
mod sections;
mod self_contact;
mod ship;
mod shipped;
mod stable_step;
mod starts;
mod stencil;
mod step_parameters;
mod two_layer;
mod two_layer_forces;
mod two_layer_limits;
mod two_layer_mesh;
mod voids;
mod world;
