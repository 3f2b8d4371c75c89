//! From arguments to a world that is ready to run: what every command does first.

use super::error::printable;
use super::{CliError, Console};
use crate::bake::{Baked, Note, bake_with_progress};
use crate::io::{
    OpenedModel, apply_sets, complete_assets, is_model, load_scene, open_model, refuse_outside, scene_from_json,
    unknown_fields,
};
use crate::scene::{Assets, Scene, TimeStep};
use crate::sim::Runner;
use crate::text::number::four_figures;
use clap::Args;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The scene that is there without any file.
const BUILT_IN: &str = include_str!("../../scenes/short_bar_soft.json");

/// Longest time that can be asked for [s], as in a scene.
const LONGEST: f64 = 1e6;

/// More unknown fields than this are counted instead of named one by one.
const NAMED_FIELDS: usize = 10;

/// Values to replace in the scene, and which files it may read.
#[derive(Clone, Debug, Default, Args)]
pub(super) struct Sets {
    /// Let the scene read models outside of its folder and of the folder `assets` beside that
    #[arg(long)]
    pub outside: bool,
    /// Replace a value of the scene: an RFC 6901 pointer and JSON, as in /bodies/0/material/young_modulus=2e5
    #[arg(long = "set", value_name = "POINTER=JSON")]
    pub sets: Vec<Assignment>,
}

impl Sets {
    /// Refuses a scene that comes of a file and reads models outside of where its own lie, unless it may.
    ///
    /// # Errors
    /// [`CliError::Io`] with the models.
    pub(super) fn refuse_outside(&self, scene: &Scene, source: Option<&Path>) -> Result<(), CliError> {
        match source.filter(|path| !self.outside && !is_model(path)) {
            Some(path) => Ok(refuse_outside(scene, path)?),
            None => Ok(()),
        }
    }
}

/// How long to run, and in which frames.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(super) struct Span {
    /// Simulated time to run [s]; the scene's duration unless given
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    pub seconds: Option<f64>,
    /// Frames a simulated second, as --set /time/frames_per_second
    #[arg(long, value_name = "RATE", allow_negative_numbers = true)]
    pub fps: Option<f64>,
    /// Stop as soon as everything rests; at the latest after --seconds, or ten times the scene's duration
    #[arg(long)]
    pub until_rest: bool,
}

impl Span {
    /// Simulated time after which a run ends at the latest [s].
    pub(super) fn limit(&self, scene: &Scene) -> f64 {
        let factor = if self.until_rest { 10.0 } else { 1.0 };
        self.seconds.unwrap_or(factor * scene.time.duration)
    }
}

/// How many threads to run on.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(super) struct Threads {
    /// Threads to run on; the result is the same on any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

impl Threads {
    /// As many as were asked for, or as the machine has.
    pub(super) fn count(self) -> usize {
        self.threads.map_or_else(rayon::current_num_threads, usize::from)
    }

    /// Runs `work` on that many. The results are the same bits on any number.
    ///
    /// # Errors
    /// The threads cannot be started.
    pub(super) fn run<T: Send>(self, work: impl FnOnce() -> Result<T, CliError> + Send) -> Result<T, CliError> {
        match self.threads {
            Some(threads) => rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build()?.install(work),
            None => work(),
        }
    }
}

/// A pointer and the text of a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Assignment {
    /// RFC 6901 pointer.
    pub pointer: String,
    /// Text behind the equals sign.
    pub text: String,
}

impl FromStr for Assignment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((pointer, value)) => Ok(Self { pointer: pointer.to_owned(), text: value.to_owned() }),
            None => Err("it has no equals sign; write a pointer, = and a value, as in /gravity/1=-1.6".to_owned()),
        }
    }
}

/// A length of time [s] that can be simulated.
///
/// # Errors
/// What to give instead.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if (0.0..=LONGEST).contains(&seconds) => Ok(seconds),
        _ => Err(format!("give a number of seconds from 0 to {LONGEST}")),
    }
}

/// Where a scene is from, as a person reads it.
pub(super) fn source_name(source: Option<&Path>) -> String {
    source.map_or_else(|| "the built-in scene".to_owned(), printable)
}

/// A scene with what has been loaded of what it refers to.
pub(super) struct Loaded {
    /// The scene.
    pub(super) scene: Scene,
    /// Solids of its models; those that are missing are loaded when it is put together.
    pub(super) assets: Assets,
    /// What is to be said of how it came to be.
    made: Option<Note>,
}

impl Loaded {
    /// What is worth saying about it: how it was made of a model, fields that nothing reads, and what was noticed while
    /// putting it together.
    pub(super) fn notes(&self, baked: &Baked) -> Vec<Note> {
        self.made.iter().cloned().chain(notes(&self.scene, baked)).collect()
    }

    /// How it was made of a model.
    pub(super) fn made(&self) -> &[Note] {
        self.made.as_slice()
    }
}

/// Reads a scene, makes one of a model, or takes the built-in one, and replaces values in it.
///
/// # Errors
/// A file or a value that cannot be used, or a frame rate where the scene's own time step gives one.
pub(super) fn load(
    source: Option<&PathBuf>,
    sets: &Sets,
    fps: Option<f64>,
    console: &mut Console,
) -> Result<Loaded, CliError> {
    let loaded = match source {
        None => of_scene(scene_from_json(BUILT_IN)?),
        Some(path) if is_model(path) => {
            console.begin();
            let opened = open_model(path, &mut |stage| console.stage(&stage));
            console.end();
            of_model(opened?)
        }
        Some(path) => of_scene(load_scene(path)?),
    };
    let scene = with_sets(&loaded.scene, &sets.sets)?;
    sets.refuse_outside(&scene, source.map(PathBuf::as_path))?;
    Ok(Loaded { scene: with_frame_rate(scene, fps)?, ..loaded })
}

fn of_scene(scene: Scene) -> Loaded {
    Loaded { scene, assets: Assets::default(), made: None }
}

fn of_model(opened: OpenedModel) -> Loaded {
    let text = format!(
        "the model is made {}; it starts above a floor. Change it by --set, or save it from the window",
        opened.said()
    );
    let OpenedModel { scene, assets, thin, .. } = opened;
    let warning = thin.is_some();
    Loaded { scene, assets, made: Some(Note { path: "/bodies/0".to_owned(), text, warning }) }
}

/// The scene with values replaced, checked.
///
/// # Errors
/// As [`apply_sets`].
pub(super) fn with_sets(scene: &Scene, sets: &[Assignment]) -> Result<Scene, CliError> {
    let sets = sets.iter().map(|set| (set.pointer.as_str(), set.text.as_str()));
    Ok(apply_sets(scene, sets)?)
}

/// The scene with another frame rate, if one is given, checked.
///
/// # Errors
/// [`CliError::ManualFrames`] where the frames follow from the time step, [`CliError::Scene`] for a rate out of range.
pub(super) fn with_frame_rate(mut scene: Scene, fps: Option<f64>) -> Result<Scene, CliError> {
    let Some(fps) = fps else { return Ok(scene) };
    if matches!(scene.time.step, TimeStep::Manual(_)) {
        return Err(CliError::ManualFrames { frame: scene.time.frame_seconds() });
    }
    scene.time.frames_per_second = fps;
    scene.validate()?;
    Ok(scene)
}

/// The folder that paths in a scene are relative to: that of its file, or the present one.
pub(super) fn folder_of(source: Option<&Path>) -> &Path {
    source.and_then(Path::parent).unwrap_or(Path::new(""))
}

/// Loads what a scene refers to and has not been loaded yet, showing what is worked on when it takes long.
///
/// # Errors
/// A model that cannot be used.
pub(super) fn load_models(loaded: &mut Loaded, source: Option<&Path>, console: &mut Console) -> Result<(), CliError> {
    console.begin();
    let Loaded { scene, assets, .. } = loaded;
    let complete = complete_assets(assets, scene, folder_of(source), &mut |stage| console.stage(&stage));
    console.end();
    Ok(complete?)
}

/// Loads what a scene refers to and has not been loaded yet, and puts it together, showing what is worked on when it
/// takes long.
///
/// # Errors
/// A model that cannot be used, or [`CliError::Bake`] with where the scene is from.
pub(super) fn bake_with_notes(
    loaded: &mut Loaded,
    source: Option<&Path>,
    console: &mut Console,
) -> Result<Baked, CliError> {
    load_models(loaded, source, console)?;
    console.begin();
    let mut tell = |body: &str, stage| {
        console.stage(&format!("{body}: {stage}"));
        ControlFlow::Continue(())
    };
    let baked = bake_with_progress(&loaded.scene, &loaded.assets, &mut tell)
        .map_err(|error| CliError::Bake { scene: source_name(source), source: error });
    console.end();
    baked
}

/// What is worth saying about a scene: fields that nothing reads, and what was noticed while putting it together.
pub(super) fn notes(scene: &Scene, baked: &Baked) -> Vec<Note> {
    let unknown = unknown_fields(scene);
    let behind = unknown.len().saturating_sub(NAMED_FIELDS);
    let mut notes: Vec<Note> = unknown
        .into_iter()
        .take(NAMED_FIELDS)
        .map(|path| Note {
            path,
            text: "an unknown field, kept but not used; check its name".to_owned(),
            warning: true,
        })
        .collect();
    if behind > 0 {
        let text = format!("{behind} more unknown fields, kept but not used; see `sinew schema` for those there are");
        notes.push(Note { path: "/".to_owned(), text, warning: true });
    }
    notes.extend(baked.notes.iter().cloned());
    notes
}

/// Whether a person should act on a note, as the word before it.
pub(super) fn word(note: &Note) -> &'static str {
    if note.warning { "warning" } else { "note" }
}

/// Says every note.
pub(super) fn tell(notes: &[Note], console: &mut Console) {
    for note in notes {
        console.say(word(note), note);
    }
}

/// Number of frames that reach a time [s], which is said where it lies within the last of them.
pub(super) fn frames_to(seconds: f64, runner: &Runner, console: &mut Console) -> u64 {
    let frames = runner.frames_for(seconds);
    let end = frames as f64 * runner.world().plan().frame_seconds;
    if end > seconds * (1.0 + 1e-6) {
        let (asked, end) = (four_figures(seconds), four_figures(end));
        console.say("note", &format!("{asked} s lies within a frame, which is run to its end at {end} s"));
    }
    frames
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_assignment_ends_its_pointer_at_the_first_equals_sign() {
        let set: Assignment = "/name=\"a=b\"".parse().unwrap();
        assert_eq!((set.pointer.as_str(), set.text.as_str()), ("/name", "\"a=b\""));
        assert!("/name".parse::<Assignment>().is_err());
    }

    #[test]
    fn seconds_are_finite_and_not_negative() {
        assert_eq!(seconds("0.5"), Ok(0.5));
        for bad in ["-1", "nan", "inf", "1e7", "", "x"] {
            assert!(seconds(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn the_built_in_scene_is_a_scene_without_unknown_fields() {
        let scene = scene_from_json(BUILT_IN).unwrap();
        assert_eq!(unknown_fields(&scene), Vec::<String>::new());
    }
}
