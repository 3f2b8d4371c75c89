//! **sinew** is an interactive stroke-based fibre editor for soft solids: a fibre drawn by one stroke in each of two
//! orthogonal views makes a soft body bend, shear, twist or stiffen, with no constitutive parameters to tune. This
//! crate is its core, its command line and its window: on one machine the same scene gives the same motion, bit for
//! bit, on any number of threads.
//!
//! # Start here
//!
//! Build a scene, put it together, run it, read it:
//!
//! ```
//! use sinew::{bake::bake, scene::{Assets, Body, Material, Scene}, sim::Runner};
//!
//! let cube = Body::cuboid("cube", [0.03; 3]) // [m]
//!     .with_material(Material::new(1e5, 0.33, 1000.0)) // Young's modulus [Pa], Poisson's ratio, density [kg/m³]
//!     .with_translation([0.0, 0.05, 0.0]);
//! let scene = Scene::new("Drop").with_floor(0.0).with_body(cube);
//! scene.validate()?;
//! let baked = bake(&scene, &Assets::default())?;
//! for note in &baked.notes {
//!     println!("{note}"); // what should be looked at
//! }
//! let mut runner = Runner::new(baked);
//! runner.advance_frame();
//! assert!(runner.world().bodies()[0].state().center().y < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Four examples of a page each go on from there; they lie in `tests/examples` and check what they say:
//!
//! - `cargo run --example box_drop`: a scene step by step, and where its particles are;
//! - `cargo run --example own_element`: a structure of your own, tied to points of a body;
//! - `cargo run --example own_force`: a force of your own on a body of the crate;
//! - `cargo run --example parameter_study`: a table of how a result hangs on a parameter, beside theory.
//!
//! | to | see |
//! | --- | --- |
//! | build a scene | [`scene::Scene`], [`scene::Body`], [`scene::Material`], [`scene::Fibre`], [`scene::Sheet`], [`scene::Element`], [`scene::TwoLayer`] |
//! | read one from a file, write one | [`io::load_scene`], [`io::save_scene`], [`io::load_assets`]; scenes that ship lie in `scenes` |
//! | fill a mesh, from a file or from memory | [`scene::Body::from_mesh`], [`scene::Assets::insert_mesh`] |
//! | put a scene together | [`bake::bake`]; with structures of your own in it: [`bake::bake_with_elements`] |
//! | run it | [`sim::Runner`]; on a thread of its own, to be paused, pulled and replayed: [`sim::Worker`] |
//! | make again what was done to it there | [`sim::Journal`], [`sim::Rerun`] |
//! | read what it shows | [`solver::World`], [`sim::Report`], [`sim::TimeSeries`], [`solver::Snapshot`] |
//! | write shapes for other programs | [`io::write_obj`], [`io::FrameFolder`], [`io::write_glb`] |
//! | open a model as a scene of its own | [`io::open_model`] |
//! | change a scene so that it can be undone | [`edit::Editor`] |
//! | turn strokes into a curve | [`sketch::lift()`] |
//! | make pictures | [`draw::draw`], `render::Offscreen` |
//!
//! # From a stroke to a picture
//!
//! ```text
//! strokes --sketch--> curve --scene--> Scene --bake--> World --sim--> frames --> Snapshot, Report --io--> files
//!                                                                         |
//!                                                                         +--draw--> DrawList --render--> pixels
//! ```
//!
//! # Modules
//!
//! - `text`: how numbers are written for people, and how a content is told by one.
//! - [`geometry`]: shapes and distances. Kernel, lattice sampling, neighbour search, curves, models and how they are
//!   checked, filled and moved inwards, rigs of skins. Knows nothing of scenes or physics.
//! - [`sketch`]: a pair of strokes in two views becomes one curve in space, or a message that says why not
//!   ([`sketch::lift()`]); layouts of fibres to start from ([`sketch::pattern`]). Pure functions.
//! - [`scene`]: the document. Bodies, materials, fibres, pins, room, panels, colliders, time, measures; data,
//!   constructors and validation.
//! - [`edit`]: the only writer of an open document; each change is one step of undo and redo. What can be done to a
//!   fibre, as pure functions: [`edit::fibre_ops`]; to a sheet: [`edit::sheet_ops`]; to a whole body:
//!   [`edit::body_ops`].
//! - [`solver`]: a world of bodies and its step. A body is a particle state with a list of `solver::forces` and of
//!   constraints, and any of the `solver::integrators` steps any body; what bodies and panels do to each other is the
//!   world's (`solver::body_contact`, `solver::panel`). Knows no file, clock, thread start or window.
//! - [`bake`]: from the document to the solver, where alone they meet. Pure: the same scene gives the same world.
//! - [`sim`]: the clock-free [`sim::Runner`] and its reports, by which command line and window run a scene: it knows
//!   rest, measures and what is reported, where a program that only steps bodies does without; the thread
//!   that paces it for a window and keeps as much of the last motion as fits its memory, to be shown again and gone on
//!   from bit for bit; time series; the comparison of integrators, by numbers and side by side.
//! - `export`: a motion as other programs take it, as plain data: surfaces on the vertices of the files that they are
//!   from, with normals and colours of these, panels as boxes, fibres with what they carry, particles with their
//!   fields. Formats are [`io`]'s.
//! - [`io`]: the only module that reads and writes files. Scene JSON and its schema, models, motions for other
//!   programs, fibres as lines, scenes collected with their models, atomic writes, recovery, folders of what the
//!   program keeps for a person, traces of what took how long. (The window's toolkit keeps the window's settings.)
//! - [`draw`]: from a scene and a snapshot to what is to be seen, as plain data: meshes, lines, points, pick numbers,
//!   themes. Knows no graphics interface.
//! - `render` (feature `render`): a draw list becomes pixels, and a pixel what was drawn there. Camera, shaders,
//!   picking, pictures without a window. Its shaders are beside it as WGSL files.
//! - `transfer`: motions out and lines in, as the command line and the window do it alike: frames of a run in formats
//!   for a program, pictures of them, fibres as lines and back.
//! - [`cli`]: the command line, a file or a folder for each command.
//! - `ui` (feature `gui`): the window. Reads the document and the newest snapshot; what a person does leaves as a
//!   [`edit::Command`] or a [`sim::SimCommand`].
//!
//! - `test_support`: what the tests look at besides all this.
//!
//! `src/python` is a crate of its own, the Python package, on what is public here.
//!
//! What is public is there to be called from other crates, and its changes are told in the list of changes; the rest is
//! `pub(crate)` or less, which the lint `unreachable_pub` holds the code to.
//!
//! What a module may import: text and geometry nothing; sketch geometry; scene geometry and sketch; edit scene, sketch
//! and geometry; solver geometry; bake scene, sketch, geometry and solver; export scene, geometry and solver; io scene,
//! geometry, export and the solver's snapshot; sim scene, bake and solver; transfer scene, geometry, edit, solver, sim,
//! export, io, draw and render; draw scene, geometry and the solver's snapshot; render draw and geometry; cli all but
//! ui; ui all but cli; any but geometry and solver may import text; and test_support may import all. A test holds the
//! code to this.
//!
//! # Where to find
//!
//! | what | where |
//! | --- | --- |
//! | a stroke becomes a curve | [`sketch::lift()`]: `clean` the strokes, `correspond` them, merge them |
//! | the matrix's force | `solver::forces::matrix`: the formulae at its head, a plain evaluation (`pair_list`) and a fast one (`stencil`) |
//! | what changes in time, and what it does to fibres | `solver::drive`, `solver::forces::fibre::activation`; from the scene: `bake::drives` |
//! | the fibres' force | `solver::forces::fibre`; how a fibre hangs in the matrix: `solver::embedding` |
//! | fibres that get thicker and thinner | `solver::driven_fractions`; what the matrix around does: `solver::forces::matrix` (`thinning`); from the scene: `bake::fractions` |
//! | how layers of particles fit a shape, and what particles at its surface stand for | `geometry::whole_layers`, `geometry::lattice_fit`, `geometry::cell_shares`; what is said of it: `bake::section_notes` |
//! | sheets: the force; where strokes sweep one; how one lies in the matrix | `solver::forces::sheet`; [`sketch::sweep()`]; `bake::sheets` |
//! | structures behind one contract; what is tried of each; from the scene | `solver::forces::element`; [`solver::check_element`]; `bake::elements` |
//! | fibres far stiffer than their matrix | `solver::integrators::fibres_implicit`; chosen in `bake::integrator` |
//! | what a body of a scene is made of, force by force | `bake::body`, `bake::two_layer` |
//! | what is taken out of a body | `bake::voids`; `geometry::hollows`, what they leave: `geometry::carve`, the skin: `geometry::clip` |
//! | regions with a matrix of their own | `bake::region_materials` |
//! | seams that tear: the bonds, the skin | `solver::forces::matrix` (`seams`), `bake::seams`; `bake::parted_skin`, `geometry::clip` (`parting`) |
//! | what does not spring back | `solver::forces::matrix` (`inelastic`, `flow_rule`), `solver::forces::fibre::yielding` |
//! | implicit steps: the matrix, how a stage is solved, what becomes of one that is not | `solver::implicit` |
//! | what bodies follow: how particles are bound, where they are led, springs | `bake::follows`, `solver::led`, `solver::forces::LedSprings`; `geometry::skeleton`, `geometry::point_cache` |
//! | contact with the room, with panels, between bodies | `solver::forces::Contact`; `solver::panel`; `solver::body_contact`, by `solver::contact_surface` |
//! | contact of a body with itself | `solver::forces::SelfContact`; which particles can touch: `bake::self_contact` |
//! | colliders: how far a point is from one; where they are; how bodies touch them | `geometry::obstacle`; `solver::collider`; `solver::forces::ColliderContact` |
//! | what overlaps at the start, and how it is eased apart | `solver::overlap`, `solver::eased_overlap`; what is said of it: `bake::overlaps` |
//! | pins that cannot be meant | `bake::pins` |
//! | the recording, and what asks for it | `sim::recording`; [`sim::SimCommand`] |
//! | what ends a frame or a bake on the way | `sim::worker::stop`, asked by [`sim::Runner::advance_frame_unless`] |
//! | where a force, an integrator or an element is added | [below](#a-force-an-integrator-and-an-element-of-your-own), in the source `src/own_parts.md` |
//! | the stable step | `solver::stable_step` of fibre solids, `solver::modes` of two-layer bodies; what sets it: `bake::limits` |
//! | how a frame is divided into steps | `bake::step_plan`, carried out by [`solver::World::advance_frame`] |
//! | what a file may hold, and the errors | `scene::validate` |
//! | what a file holds of a mesh, vertex by vertex | [`geometry::FileMesh`], kept by the readers in `io::model` |
//! | how its vertices ride on the particles, how its normals turn | `export::carrier`, `export::normals` |
//! | the scene file, its schema | `io::scene`, `io::schema` |
//! | a format that models are read in | `io::model` |
//! | a format that a motion is written in | `io::export`, of moving pictures `io::moving`; all that are offered: `transfer::format` |
//! | which frames of a run are written, and for which program | `transfer::run_files`, `transfer::program` |
//! | what the window writes beside itself | `ui::transfer`; from the recording: `sim::taken` |
//! | which integrator is which scheme | [`scene::IntegratorKind`] |
//! | the work that is done from outside | `solver::outside_body`, booked as a world goes by `solver::world::work` |
//! | the balance of energy and work, and what is said where it is not kept | `solver::world::watch`, `solver::account`, [`solver::Unbalanced`] |
//! | what a series has in its columns | `sim::columns` |
//! | values that no solid has | `bake::regime` |
//! | what can be driven in a scene, and where that stands in the file | [`scene::Drivable`]; its lanes and keys: `ui::drives` |
//! | a menu entry, its key and its tooltip | the table in `ui::action`; what it does, and when: `ui::app::dispatch` |
//! | where a new body stands free, and how a body is moved in the window | `ui::bodies`, `ui::editing::body` |
//! | what a change of the document does | [`edit::Command`], `edit::apply` |
//!
//! # Conventions
//!
//! SI units throughout: metres, kilograms, seconds, newtons, pascals; angles in degrees in scenes and reports, in
//! radians in the code. Frames are right-handed with Y up. A body is described in its *model frame* and put into the
//! world by its placement; capital X in formulae is the rest position, small x the present one. State and forces are
//! f64; what a fast matrix computes on the way to them is f32. Parallel loops write by index and sums run in a fixed
//! order, so that the number of threads changes nothing.
//!
//! # Glossary
//!
//! The matter:
//! - *fibre solid*: a body of an elastic matrix with fibres in it, filled with particles (the fibre paper's).
//! - *matrix*: the homogeneous, isotropic material of a fibre solid, without its fibres.
//! - *material particle*: one of the points of mass that carry the matrix, on a cubic lattice at rest.
//! - *structure particle*: a vertex of a fibre. It has no mass and no state of its own: material particles carry it.
//! - *sheet*: a surface in a fibre solid that resists stretch, shear and bending, carried as fibres are. *Membrane*:
//!   its stretch and shear. *Hinge*: its bending at an edge between two triangles. *Grain*: the direction of its
//!   threads. *Rim*: where it ends. *Seam*: one along which the matrix *tears*, *bond* of two neighbours by bond.
//! - *element*: an energy of a few points that ride on the particles, and of how the material is turned there.
//!   *Measure* (of one) and *law*: what one without code looks at, and what it does about it. *Majorant*: the most that
//!   it ever resists a move.
//! - *embedding weights*: by how much each of the material particles around a point carries it (eq. 17, corrected).
//! - *spacing* D: distance of neighbours in the lattice [m]. *Support radius* h: reach of the smoothing kernel [m]; the
//!   particles within it are a particle's *neighbours*. D / h is the spacing ratio.
//! - *deformation gradient* F: the linear map from a particle's neighbourhood at rest to the present one.
//! - *volume fraction* l: share of the material around a point that is fibre. *Matrix fraction*: 1 - l, the share of
//!   the matrix's energy that is left there (eq. 18).
//! - *stencil*: the offsets of the lattice within h with their weights, the same for every particle. *Brick*: four
//!   places of the lattice in a row along x (eight in f32), computed at once. *Pair list*: the same forces, neighbour
//!   by neighbour. *Fast*: the stencil in f32, on deviations from the body's rigid motion; *exact*: all else, in f64.
//! - *void*: what is taken out of a body. *Hollow*: its shape among the particles, across which they feel nothing.
//! - *yield*: to take another shape at rest, past a limit. *Dissipated*: lost to that, to tearing and to viscosity.
//! - *two-layer body*: an outer and an inner *layer* of particles joined by springs, with gas inside (the two-layer
//!   paper's). It has no matrix and no fibres.
//! - *skin*: the surface that is drawn, carried by the particles. *Rig*: how it hangs on them. *Arm*: the way to a
//!   point too far outside for particles to carry it; it turns with them. *Directions*: an arm's three axes, turned.
//!
//! The scene:
//! - *scene*: the document. *Assets*: the solids that its meshes stand for. *Solid*: a mesh with an inside.
//! - *room*: the floor, walls and ceiling. *Panel*: a rigid horizontal plate that falls or is driven.
//! - *collider*: a rigid thing, still or moved, that bodies touch and that nothing pushes away; *obstacle*: what it is,
//!   about its own origin. *Shell*: an obstacle of no thickness, touched from both sides.
//! - *region*: a named set of particles, chosen at rest. *Pin*: a region that is held or moved. One that is new to a
//!   motion takes hold of the region where it finds it. *Pinned point*: a grab that was left where it pulls.
//! - *leader*: a motion made elsewhere that particles follow. *Skeleton*: nodes within nodes, of which some are
//!   *joints* that a skin hangs on; a *bone* leads from one joint to the next. *Clip*: nodes moved over a time. *Point
//!   cache*: a mesh's vertices frame by frame. *Pre-roll*: the time in which a body is eased from its rest pose into
//!   the first frame.
//! - *measure*: a quantity read off a body, such as the twist of one region against another. *Probe*: one in a world.
//! - *file's mesh*: a model as its file has it, every vertex in its order, polygons uncut, with texture coordinates,
//!   normals, colours and parts; motions are written on it. *Part*: a run of its faces of one name and material.
//! - *model frame*: the frame in which a body is described. *Placement*: where it stands in the world.
//! - *view*: front, side or top. *Stroke*: what was drawn in one. *Lift*: to make a curve of two strokes.
//!   *Sweep*: to make a surface of them, the first carried along the second.
//! - *drivable*: what a drive moves or could move. *Key*: a value of a drive at a time. *Lane*: its course, shown.
//! - *drive*: a number that changes in time. *Activation*: what a drive does to a fibre, which *acts* then. *Wind*: air
//!   or water that moves as one.
//! - *pattern*: a layout of fibres to start from. *Dab*: one touch of the brush that paints the volume fraction.
//!
//! The motion:
//! - *bake*: to put a scene together into a world. *Note*: what was noticed on the way ([`bake::Baked::notes`]).
//!   [`scene`] and [`solver`] call a thing by one name: a `Body`, `Panel`, `Collider`, `Drive`, `Element` or `Grab`
//!   of the one is what the other makes of it. (A scene's `Measure` becomes a probe.)
//! - *world*: bodies and panels at one time. *State*: positions, velocities and masses of a body.
//! - *frame*: the time from one picture to the next. *Outer step*: a part of it for which contact between bodies and
//!   with panels is evaluated once. *Sub-step*: one of a body's own steps in that.
//! - *fibres implicit*: fibres' forces found together with where they bring the particles, so that their stiffness does
//!   not set the step; all else by leap-frog.
//! - *stable step*: the longest step under which a body's small motions do not grow. *Safety*: the share of it in use.
//! - *hand*: what leads a shared drive away from what it is by itself.
//! - *grip*: what touching particles hold on to below Coulomb's limit: springs along the surface.
//! - *body contact*: the push between two bodies. *Strike*: an impulse on one.
//! - *overlap*: of bodies that start inside one another, the room or a panel. *Allowance*: the depth that contact
//!   grants such a one. *Eased overlap*: one whose allowance fades. *Easing* of a ramp: how its speed sets in and ends.
//! - *asleep*: a body at rest that nothing comes near; it takes no steps.
//! - *stage*: an implicit equation for the end, or a point, of a step. *Chord step*: one towards its solution, by a
//!   matrix that stays. *Fallback*: a step that was halved, or handed over to leap-frog, because a stage was not
//!   solved.
//! - *divergence*: a motion that can no longer be computed; the body is stopped. *Break*: of a fibre, past its limits.
//! - *grab*: a point of a body that is pulled by hand, with the spring from there to where the hand is. *Lead*: of a
//!   shared drive that is led by hand, what it is told to be.
//! - *von Mises stress*: the size of a stress that changes shape; it is shown, measured and yielded by.
//! - *snapshot*: what can be seen of a world at one time, as plain data.
//! - *recording*: the states of the last frames, as many as fit its memory, to go back to. *Time series*: the numbers
//!   of the last frames, many more of them.
//! - *taken motion*: a scene as it was put together and the frames that are kept of it, shared with who writes them to
//!   files.
//! - *led*: of particles, where their leader has them. *Work*: what pins that move, leaders, driven panels and wind
//!   have done on bodies ([`solver::World::work`]).
//! - *balance*: energy less work from outside; dissipation lowers it. *Handled*: the energy that was there at the most.
//! - *journal*: what was asked of a motion from its start on, frame by frame, and what every frame came to.
//! - *checkpoint*: all that a world goes on from, bit for bit.
//! - *ghost*: the scene without its fibres, or before the last edit, run in step beside it.
//! - *study*, *trial*: a scene under several integrators and steps, put together once; under one.
//!
//! The picture and the window:
//! - *draw list*: what is to be seen, as plain data. *Pick number*: what was drawn at a pixel.
//! - *view inputs*: all that the picture of a view follows from but its camera; it is kept until one of them changes.
//! - *command*: a change of the document, one step of undo. *Gesture*: changes that undo as one, such as a drag.
//! - *pass*: of a frame's input, up to one change that others depend on; only the last pass over a frame is drawn.
//! - *action*: what menus, keys and the palette offer. *Disabled reason*: why one cannot be had just now.
//! - *autosave*: the copy of a changed scene that is kept aside. *Recoverable document*: one found at the next start.
//!
#![doc = include_str!("own_parts.md")]
//!
//! # Where the formulation differs from the papers' print
//!
//! The fibre paper (Liu, He, Ren, Li, Wang: *Physical material editing with structure embedding for animated solid*,
//! Graphics Interface 2012) is neither conservative nor dimensionally consistent as printed. What is done instead, and
//! why, stands at the head of each file: `geometry::kernel` (eq. 13 unnormalised), `solver::forces::matrix` (eqs. 10
//! to 15), `solver::forces::fibre` (eqs. 6 to 8 and the appendix), `solver::embedding` (eq. 17),
//! [`scene::PaperStiffness`] (Table 1). The README lists them all.
// Units stand in brackets throughout the docs: [m], [N/m].
#![warn(unreachable_pub)]
#![allow(rustdoc::broken_intra_doc_links, reason = "units in brackets are no links")]

pub mod bake;
pub mod cli;
pub mod draw;
pub mod edit;
mod export;
pub mod geometry;
pub mod io;
#[cfg(feature = "render")]
pub mod render;
pub mod scene;
pub mod sim;
pub mod sketch;
pub mod solver;
#[doc(hidden)]
pub mod test_support;
#[cfg_attr(not(feature = "gui"), allow(dead_code, reason = "most numbers are written in the window"))]
mod text;
mod transfer;
#[cfg(feature = "gui")]
pub mod ui;
