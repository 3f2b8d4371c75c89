//! What leaves the window: what is asked before it, the work on it and what became of that.

use super::answer::TransferAnswer;
use super::job::Job;
use super::question::{
    ClipKind, ClipQuestion, Known, LinesDone, LinesQuestion, MotionQuestion, PlaceField, Source, TransferQuestion,
};
use super::strip::{Asked, Ended, strip};
use super::work::{MotionWork, TURN_PICTURES, clip_frames, draw_clip, draw_turn};
use crate::edit::Command;
use crate::export::Space;
use crate::io::{resolved, write_lines};
use crate::scene::Fibre;
use crate::sim::TakenMotion;
use crate::transfer::{Format, Inputs, LineSites, LineSpace, Look, Program, TransferError};
use crate::ui::context::{Context, Request, Severity, Step};
use crate::ui::dialogs::Dialog;
use egui::Ui;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Sizes of pictures that are offered beside that of the view [pixels].
const SIZES: [[u32; 2]; 3] = [[1280, 720], [1920, 1080], [1080, 1080]];

/// What can be done about lines that lie elsewhere.
const REMEDY: &str = "choose their unit, such as millimetres, the axis that points up there, or that they stand in the \
                      model's own frame";

/// What is begun as soon as the motion is there that was asked for.
type Begin = Box<dyn FnOnce(TakenMotion, &egui::Context) -> Job>;

/// What leaves the window.
#[derive(Default)]
pub(crate) struct Transfer {
    waiting: Option<(Receiver<Option<TakenMotion>>, Begin)>,
    job: Option<Job>,
    ended: Option<Ended>,
    /// Program, formats and unit that were chosen last.
    last: Option<(Option<Program>, Space, Vec<Format>)>,
}

impl Transfer {
    /// Why nothing can be written just now.
    pub(crate) fn is_busy(&self) -> Option<&'static str> {
        (self.job.is_some() || self.waiting.is_some())
            .then_some("Something is being written; wait for it, or cancel it")
    }

    /// Asks what is to be written of the motion, with pictures of this look.
    pub(crate) fn ask_motion(&self, look: &Look, cx: &mut Context) {
        let (program, space, formats) = self.last.clone().unwrap_or_else(|| {
            let program = Program::Blender;
            (Some(program), program.space(), Format::named("usd").into_iter().collect())
        });
        let has_frames = cx.simulation.published().status.recording.frames > 1;
        let question = MotionQuestion {
            formats,
            program,
            space,
            source: if has_frames { Source::Kept } else { Source::Anew },
            range: None,
            step: 1,
            size: look.size,
            sizes: offered(look.size),
            folder: PlaceField::of(&beside(cx, "_motion")),
            known: Known::Asked(cx.simulation.take_motion()),
            replaced: None,
        };
        cx.request(Request::Open(Dialog::Transfer(TransferQuestion::Motion(Box::new(question)))));
    }

    /// Asks where a clip of this look goes.
    pub(crate) fn ask_clip(kind: ClipKind, look: &Look, cx: &mut Context) {
        let ending = if kind == ClipKind::Motion { "_clip.apng" } else { "_turntable.apng" };
        let file = PlaceField::of(&beside(cx, ending));
        let question = ClipQuestion { kind, size: look.size, sizes: offered(look.size), file };
        cx.request(Request::Open(Dialog::Transfer(TransferQuestion::Clip(question))));
    }

    /// Asks which lines become fibres of the active body.
    pub(crate) fn ask_import(cx: &mut Context) {
        let into = cx.active_body().map(|body| (body.id.clone(), body.title().to_owned()));
        Self::ask_lines(into, Vec::new(), PlaceField::default(), cx);
    }

    /// Asks where the selected fibres go, or all of the body where none is selected.
    pub(crate) fn ask_export(cx: &mut Context) {
        let mut fibres: Vec<String> = cx.selection.fibres().to_vec();
        if fibres.is_empty() {
            fibres = cx.active_body().map_or_else(Vec::new, |body| body.fibres.iter().map(|f| f.id.clone()).collect());
        }
        let file = PlaceField::of(&beside(cx, "_fibres.obj"));
        Self::ask_lines(None, fibres, file, cx);
    }

    fn ask_lines(into: Option<(String, String)>, fibres: Vec<String>, file: PlaceField, cx: &mut Context) {
        let at = LineSpace::default();
        let question = LinesQuestion { into, fibres, file, at, work: None, problem: None };
        cx.request(Request::Open(Dialog::Transfer(TransferQuestion::Lines(Box::new(question)))));
    }

    /// Does what a question was answered by; gives the question back where it goes on.
    pub(crate) fn answered(
        &mut self,
        ctx: &egui::Context,
        question: TransferQuestion,
        answer: TransferAnswer,
        look: Look,
        cx: &mut Context,
    ) -> Option<TransferQuestion> {
        match (answer, question) {
            (TransferAnswer::Begin, TransferQuestion::Motion(question)) => self.begin_motion(&question, look, cx),
            (TransferAnswer::Begin, TransferQuestion::Clip(question)) => self.begin_clip(ctx, &question, look, cx),
            (TransferAnswer::Begin, TransferQuestion::Lines(mut question)) => {
                begin_lines(ctx, &mut question, cx);
                return Some(TransferQuestion::Lines(question));
            }
            (TransferAnswer::Done(done), _) => finish_lines(done, cx),
            (TransferAnswer::Closed, _) => {}
        }
        None
    }

    fn begin_motion(&mut self, question: &MotionQuestion, look: Look, cx: &mut Context) {
        let (Some(folder), Some(frames)) = (question.folder.path(), question.frames(cx)) else { return };
        self.last = Some((question.program, question.space, question.formats.clone()));
        let (formats, space) = (question.formats.clone(), question.space);
        let (is_anew, inputs) = (question.source == Source::Anew, inputs(cx));
        let look = Look { size: question.size, ..look };
        let begin = move |motion: TakenMotion, ctx: &egui::Context| {
            let work = MotionWork { motion, formats, folder, frames, is_anew, space, look, inputs };
            let ctx = ctx.clone();
            Job::start(
                ["Exporting", "frames"],
                work.pieces(),
                move || ctx.request_repaint(),
                move |progress| work.run(progress),
            )
        };
        self.begin_with_motion(Box::new(begin), cx);
    }

    fn begin_clip(&mut self, ctx: &egui::Context, question: &ClipQuestion, look: Look, cx: &mut Context) {
        let Some(path) = question.file.path() else { return };
        if let Err(error) = inputs(cx).check_apart("the clip", std::slice::from_ref(&path)) {
            self.ended = Some(Ended::of(&[], Some(error.to_string()), false).failed(true));
            return;
        }
        let look = Look { size: question.size, ..look };
        let notify = ctx.clone();
        match question.kind {
            ClipKind::Turntable => {
                let (scene, shown) = (Arc::clone(cx.scene()), Arc::clone(cx.simulation.published()));
                let draw = move |progress: &_| draw_turn(&scene, &shown.snapshot, &look, path, progress);
                let notify = move || notify.request_repaint();
                self.start(Job::start(["Drawing", "pictures"], TURN_PICTURES, notify, draw));
            }
            ClipKind::Motion => {
                let Some([first, last]) = cx.simulation.published().status.recording.numbers else { return };
                let begin = move |motion: TakenMotion, _: &egui::Context| {
                    let frames = clip_frames(first, last, motion.start().world().plan().frame_seconds);
                    let draw = move |progress: &_| draw_clip(motion, frames, &look, path, progress);
                    Job::start(["Drawing", "pictures"], frames.count(), move || notify.request_repaint(), draw)
                };
                self.begin_with_motion(Box::new(begin), cx);
            }
        }
    }

    fn begin_with_motion(&mut self, begin: Begin, cx: &Context) {
        self.waiting = Some((cx.simulation.take_motion(), begin));
        self.ended = None;
    }

    fn start(&mut self, job: Job) {
        self.job = Some(job);
        self.ended = None;
    }

    /// Takes up what has come about: the motion that was asked for, the end of the work.
    pub(crate) fn look_after(&mut self, ctx: &egui::Context) {
        if let Some((receiver, begin)) = self.waiting.take() {
            match receiver.try_recv() {
                Ok(Some(motion)) => {
                    let job = begin(motion, ctx);
                    self.start(job);
                }
                Err(TryRecvError::Empty) => {
                    // It comes with the next frame of the simulation, or once the scene is put together.
                    ctx.request_repaint_after_secs(0.02);
                    self.waiting = Some((receiver, begin));
                }
                Ok(None) | Err(TryRecvError::Disconnected) => {
                    let problem = "There is no motion, as the scene is not put together".to_owned();
                    self.ended = Some(Ended::of(&[], Some(problem), false).failed(true));
                }
            }
        }
        if let Some(job) = &self.job
            && let Some(report) = job.report()
        {
            let failed = report.problem.is_some();
            self.ended = Some(Ended::of(&report.written, report.problem, job.is_cancelled()).failed(failed));
            self.job = None;
        }
    }

    /// Shows how far it has come, or what became of it.
    pub(crate) fn show(&mut self, ui: &mut Ui, cx: &mut Context) {
        match strip(ui, self.job.as_ref(), self.ended.as_ref(), cx) {
            Some(Asked::Cancel) => self.job.iter().for_each(Job::cancel),
            Some(Asked::Close) => self.ended = None,
            Some(Asked::Show(folder)) => {
                // The desktop's own program for folders; it is not waited for.
                if let Err(error) = open::that_detached(&folder) {
                    let said = format!("This desktop shows no folders ({error}); it is {}", folder.display());
                    cx.say(Severity::Error, said);
                }
            }
            None => {}
        }
    }

    /// What is told of what has ended.
    pub(crate) fn told(&self) -> Option<&str> {
        self.ended.as_ref().map(|ended| ended.text.as_str())
    }
}

/// Sizes of pictures to choose from, that of the view first.
fn offered(view: [u32; 2]) -> Vec<[u32; 2]> {
    let mut sizes = vec![view];
    sizes.extend(SIZES.into_iter().filter(|size| *size != view));
    sizes
}

/// A path beside the scene, of its name with another ending.
fn beside(cx: &Context, ending: &str) -> PathBuf {
    let document = &cx.document;
    let folder = document.path.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
    let folder = resolved(folder).unwrap_or_else(|| folder.to_owned());
    let stem = document.path.as_deref().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
    let safe = |c: char| if c.is_alphanumeric() || c == '-' { c } else { '_' };
    let stem = stem.unwrap_or_else(|| document.name().trim().chars().take(40).map(safe).collect());
    folder.join(format!("{stem}{ending}"))
}

/// Files that must not be written over.
fn inputs(cx: &Context) -> Inputs {
    let document = &cx.document;
    Inputs::of(document.path.as_deref(), &document.folder, document.scene())
}

/// Reads lines, or writes fibres, on a thread of its own.
fn begin_lines(ctx: &egui::Context, question: &mut LinesQuestion, cx: &Context) {
    let Some(path) = question.file.path() else { return };
    let (sender, receiver) = channel();
    (question.work, question.problem) = (Some(receiver), None);
    let (into, fibres, at) = (question.into.clone(), question.fibres.clone(), question.at);
    let (taken, inputs, ctx) = (cx.simulation.take_motion(), inputs(cx), ctx.clone());
    let active = cx.active.index;
    std::thread::spawn(move || {
        let work = || -> Result<LinesDone, String> {
            let motion = taken.recv().ok().flatten();
            let motion =
                motion.ok_or("The scene is not put together, so that nothing is known of where its bodies lie")?;
            let lines = match &into {
                Some((id, _)) => read(&motion, id, &path, at).map(|fibres| LinesDone::Read(id.clone(), fibres)),
                None => {
                    write(&motion, active, &fibres, &path, at, &inputs).map(|count| LinesDone::Written(count, path))
                }
            };
            lines.map_err(|error| error.to_string())
        };
        // The window may be gone by now.
        sender.send(work()).ok();
        ctx.request_repaint();
    });
}

fn read(motion: &TakenMotion, id: &str, path: &Path, at: LineSpace) -> Result<Vec<Fibre>, TransferError> {
    let scene = motion.scene().0;
    let sites = LineSites::new(scene, motion.start().world(), at);
    let only = scene.bodies.iter().position(|body| body.id == id);
    let fibres = sites.read(path, only, REMEDY)?;
    Ok(fibres.into_iter().map(|(_, fibre)| fibre).collect())
}

fn write(
    motion: &TakenMotion,
    active: usize,
    fibres: &[String],
    path: &Path,
    at: LineSpace,
    inputs: &Inputs,
) -> Result<usize, TransferError> {
    inputs.check_apart("the lines", &[path.to_owned()])?;
    let sites = LineSites::new(motion.scene().0, motion.start().world(), at);
    let lines = sites.lines(|body, fibre| body == active && fibres.contains(&fibre.id))?;
    write_lines(path, &lines)?;
    Ok(lines.len())
}

/// Takes fibres that were read into the body, selected; says what was done.
fn finish_lines(done: LinesDone, cx: &mut Context) {
    match done {
        LinesDone::Read(body, fibres) => {
            let (count, ids): (_, Vec<String>) = (fibres.len(), fibres.iter().map(|fibre| fibre.id.clone()).collect());
            cx.say(Severity::Note, format!("Imported {count} fibres; they are selected"));
            cx.edit(&Command::add_fibres("Import", &body, fibres), Step::Own);
            let known = |id: &String| cx.active_body().is_some_and(|body| body.fibres.iter().any(|f| f.id == *id));
            let there: Vec<String> = ids.into_iter().filter(known).collect();
            cx.selection.set(there);
        }
        LinesDone::Written(count, path) => {
            cx.say(Severity::Note, format!("Wrote {count} fibres to {}", path.display()));
        }
    }
}
