//! A document or a model that is being read: on a thread of its own, since that may take long, and the window goes on
//! meanwhile.

use super::autosave::{RecordingOffer, RecoveryOffer};
use super::bodies::{Brought, Incoming, Layers};
use super::document::Document;
use super::fault_report::FaultReport;
use super::gallery::shipped_assets;
use super::theme::GRID;
use crate::io::{
    FileStamp, IoError, OpenedModel, Origin, Stages, add_collider_model, add_leader, is_model, load_assets_unless,
    open_model_unless,
};
use crate::scene::{Assets, Leader};
use egui::{Context, RichText, Ui};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A model that is read within this time is there in the same frame: nothing flashes up for it. A scene without one
/// always is.
const QUICK: Duration = Duration::from_millis(100);
/// How often it is looked whether a model is being read.
const LOOK: Duration = Duration::from_millis(5);

/// What is read.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// A scene or a model, and whether it may read models outside of its folder.
    File(PathBuf, bool),
    /// A document that was left behind.
    Recovery(RecoveryOffer),
    /// A model that is to be a body of the scene that is open.
    Model(PathBuf, Layers),
    /// A body from elsewhere that is to be put into the scene that is open.
    Body(Box<Incoming>),
    /// A model that bodies of the scene that is open are to touch.
    Collider {
        /// Its file.
        file: PathBuf,
        /// The folder from which the scene names it.
        folder: PathBuf,
    },
    /// A motion that a body of the scene that is open is to follow.
    Leader {
        /// Its file.
        file: PathBuf,
        /// The motion as the scene names it.
        leader: Leader,
        /// The folder from which it does.
        folder: PathBuf,
    },
    /// A report of a fault, which is written: its models are read for that.
    Report(Box<FaultReport>),
    /// A recording that was left behind, which is written to a file.
    Recording(Box<RecordingOffer>, PathBuf),
}

/// What was read, or written.
pub(crate) enum Read {
    /// A document.
    Document(Box<Document>),
    /// A model for a body of the scene that is open.
    Model {
        /// Its file.
        path: PathBuf,
        /// What becomes of it.
        layers: Layers,
        /// What it holds.
        opened: Box<OpenedModel>,
    },
    /// A body from elsewhere, with what it names.
    Body(Box<Brought>),
    /// A model that bodies of the scene that is open are to touch.
    Collider {
        /// Its file.
        file: PathBuf,
        /// How the scene names it.
        path: String,
        /// The model.
        models: Assets,
    },
    /// A report of a fault was written, without these; or not at all, since it was no longer wanted.
    Report(Option<Vec<String>>),
    /// A recording was written.
    Recording,
    /// A motion that a body of the scene that is open is to follow.
    Leader {
        /// As the scene names it.
        leader: Leader,
        /// What it consists of.
        models: Assets,
    },
}

impl Source {
    /// What a person calls it.
    fn name(&self) -> String {
        match self {
            Self::Recovery(offer) => offer.name().to_owned(),
            Self::Body(incoming) => incoming.body.view().title().to_owned(),
            other => other.file().map_or_else(String::new, |path| path.display().to_string()),
        }
    }

    /// The file; none of a document that was left behind, and of a body.
    pub(crate) fn file(&self) -> Option<&Path> {
        match self {
            Self::File(path, _) | Self::Model(path, _) | Self::Recording(_, path) => Some(path),
            Self::Collider { file, .. } | Self::Leader { file, .. } => Some(file),
            Self::Report(report) => Some(&report.path),
            Self::Recovery(_) | Self::Body(_) => None,
        }
    }

    fn load(self, progress: &mut Stages<'_>) -> Result<Read, IoError> {
        let document = match self {
            Self::Model(path, layers) => {
                let opened = Box::new(open_model_unless(&path, progress)?);
                return Ok(Read::Model { path, layers, opened });
            }
            Self::Body(incoming) => return incoming.bring(progress).map(|brought| Read::Body(Box::new(brought))),
            Self::Recording(recording, path) => return recording.save(&path, progress).map(|()| Read::Recording),
            Self::Report(report) => return report.write(progress).map(Read::Report),
            Self::Collider { file, folder } => {
                let mut models = Assets::default();
                let path = add_collider_model(&mut models, &file, &folder, progress)?;
                return Ok(Read::Collider { file, path, models });
            }
            Self::Leader { leader, folder, .. } => {
                let mut models = Assets::default();
                add_leader(&mut models, &leader, &folder, progress)?;
                return Ok(Read::Leader { leader, models });
            }
            Self::File(path, outside) => Document::load_unless(Some(path), outside, progress)?,
            Self::Recovery(offer) => {
                let scene = offer.document.load()?;
                let Origin { file, folder, shipped, .. } = offer.document.origin;
                let assets =
                    if shipped { shipped_assets(&scene) } else { load_assets_unless(&scene, &folder, progress) };
                Document { scene, assets: Arc::new(assets?), path: file, folder, note: None, asks: None }
            }
        };
        Ok(Read::Document(Box::new(document)))
    }
}

/// Why nothing was read.
pub(crate) enum Unread {
    /// The scene reads files outside of its folder, which nobody has let it.
    Outside(Vec<PathBuf>),
    /// In words.
    Problem(String),
}

impl From<IoError> for Unread {
    fn from(error: IoError) -> Self {
        match error.bare() {
            IoError::Outside { files } => Self::Outside(files.clone()),
            _ => Self::Problem(error.to_string()),
        }
    }
}

/// What was read, or why it could not be.
pub(crate) type Loaded = Result<Read, Unread>;

/// How far a document that is being read has come.
pub(crate) enum Progress {
    /// It is being read.
    GoesOn,
    /// It is not wanted.
    Cancelled,
    /// It is there, or cannot be read.
    Done(Box<Loaded>),
}

/// A document that is being read. Dropped, it is not wanted any more: its thread ends as soon as it asks for that.
pub(crate) struct Loading {
    /// What is read.
    pub(crate) source: Source,
    /// How the file was before it was read: what is written in between is found later then.
    pub(crate) stamp: Option<FileStamp>,
    stage: Arc<Mutex<String>>,
    loaded: Receiver<Result<Read, IoError>>,
    is_wanted: Arc<AtomicBool>,
}

impl Drop for Loading {
    fn drop(&mut self) {
        self.is_wanted.store(false, Ordering::Relaxed);
    }
}

impl Loading {
    /// Begins to read.
    pub(crate) fn start(source: Source, ctx: &Context) -> Self {
        let file = match &source {
            Source::File(path, _) => Some(path),
            Source::Recovery(offer) => offer.document.origin.file.as_ref().filter(|_| is_known(offer)),
            Source::Model(..)
            | Source::Body(_)
            | Source::Collider { .. }
            | Source::Leader { .. }
            | Source::Report(_)
            | Source::Recording(..) => None,
        };
        let stamp = file.filter(|path| !is_model(path)).and_then(|path| FileStamp::of(path).ok());
        let stage = Arc::new(Mutex::new(String::new()));
        let (sender, loaded) = channel();
        let is_wanted = Arc::new(AtomicBool::new(true));
        let (what, told, wanted, ctx) = (source.clone(), Arc::clone(&stage), Arc::clone(&is_wanted), ctx.clone());
        std::thread::spawn(move || read(what, &told, &wanted, &sender, &ctx));
        Self { source, stamp, stage, loaded, is_wanted }
    }

    /// What has been read by now; what is quick is waited for. None while it is not there.
    pub(crate) fn at_once(&self) -> Option<Loaded> {
        let begun = Instant::now();
        loop {
            match self.loaded.recv_timeout(LOOK) {
                Ok(loaded) => return Some(loaded.map_err(Unread::from)),
                Err(RecvTimeoutError::Timeout) if self.stage().is_empty() || begun.elapsed() < QUICK => {}
                Err(_) => return self.take(),
            }
        }
    }

    /// What is being worked on; nothing before there is a model to be read.
    fn stage(&self) -> String {
        self.stage.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// What has been read; none while it is not there.
    fn take(&self) -> Option<Loaded> {
        match self.loaded.try_recv() {
            Ok(loaded) => Some(loaded.map_err(Unread::from)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                let said = format!("{}: reading it failed by a fault of this program", self.source.name());
                Some(Err(Unread::Problem(said)))
            }
        }
    }

    /// Shows what is being worked on, and a way out.
    pub(crate) fn show(&self, ui: &mut Ui) -> Progress {
        ui.set_width(460.0);
        let writes = matches!(self.source, Source::Report(_) | Source::Recording(..));
        ui.heading(if writes { "Writing" } else { "Opening" });
        ui.label(RichText::new(self.source.name()).weak());
        ui.add_space(GRID);
        let stage = self.stage();
        ui.horizontal(|ui| {
            ui.spinner();
            ui.label(if stage.is_empty() { "reading" } else { &stage });
        });
        ui.add_space(GRID);
        if ui.button("Cancel").clicked() {
            return Progress::Cancelled;
        }
        self.take().map_or(Progress::GoesOn, |loaded| Progress::Done(Box::new(loaded)))
    }
}

/// Whether what the file holds now is what the document grew from.
pub(crate) fn is_known(offer: &RecoveryOffer) -> bool {
    !offer.is_older && !offer.document.origin.doubtful
}

fn read(
    source: Source,
    stage: &Mutex<String>,
    wanted: &AtomicBool,
    sender: &Sender<Result<Read, IoError>>,
    ctx: &Context,
) {
    let loaded = source.load(&mut |said| {
        if !wanted.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        said.clone_into(&mut stage.lock().unwrap_or_else(PoisonError::into_inner));
        ctx.request_repaint();
        ControlFlow::Continue(())
    });
    // Nobody may want it any more.
    let _ = sender.send(loaded);
    ctx.request_repaint();
}

/// What is said of a document that was opened from a file.
pub(crate) fn opened(document: &Document, path: &Path) -> String {
    document.note.clone().unwrap_or_else(|| format!("Opened {}", path.display()))
}
