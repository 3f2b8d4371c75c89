//! Files that are written beside the run: while one frame goes to them, the next is computed.

use crate::export::Frame;
use crate::io::IoError;
use crate::io::door::Door;
use crate::io::export::MotionFiles;
use std::panic::resume_unwind;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::{Builder, JoinHandle};

/// Frames that wait while one is written: more would only take memory.
const WAITING: usize = 1;

/// Files on a thread of their own.
pub(super) struct FilesBehind {
    /// None while the thread has them.
    files: Option<MotionFiles>,
    writing: Option<Writing>,
}

struct Writing {
    frames: SyncSender<Frame>,
    thread: JoinHandle<(MotionFiles, Result<(), IoError>)>,
}

impl FilesBehind {
    pub(super) fn new(files: MotionFiles) -> Self {
        Self { files: Some(files), writing: None }
    }

    /// Has the next frame written; waits while as many as may are on their way.
    ///
    /// # Errors
    /// What an earlier frame could not be written for; this one is not, then.
    pub(super) fn push(&mut self, frame: Frame) -> Result<(), IoError> {
        if let Some(files) = self.files.take() {
            match begin(files) {
                Ok(writing) => self.writing = Some(writing),
                // Without a thread it is done here.
                Err(mut files) => {
                    let result = files.push(&frame);
                    self.files = Some(files);
                    return result;
                }
            }
        }
        match self.writing.as_ref().map(|writing| writing.frames.send(frame)) {
            Some(Ok(())) | None => Ok(()),
            Some(Err(_)) => self.settle(),
        }
    }

    /// Waits for what is on its way.
    ///
    /// # Errors
    /// What a frame could not be written for.
    fn settle(&mut self) -> Result<(), IoError> {
        let Some(Writing { frames, thread }) = self.writing.take() else { return Ok(()) };
        drop(frames);
        let (files, result) = thread.join().unwrap_or_else(|panic| resume_unwind(panic));
        self.files = Some(files);
        result
    }

    /// Writes all that is on its way and what is left to be written after it.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(super) fn finish(&mut self) -> Result<(), IoError> {
        let settled = self.settle();
        let finished = self.files.as_mut().map_or(Ok(()), MotionFiles::finish);
        settled.and(finished)
    }

    /// What was written, as it is told, and where; of frames on their way nothing.
    pub(super) fn written(&self) -> Vec<(String, std::path::PathBuf, usize)> {
        self.files.as_ref().map_or_else(Vec::new, MotionFiles::written)
    }
}

impl Drop for FilesBehind {
    fn drop(&mut self) {
        // What was handed over is written, whatever ends the run.
        self.settle().ok();
    }
}

/// Starts the thread; the files come back where there is none to be had.
fn begin(files: MotionFiles) -> Result<Writing, MotionFiles> {
    let (frames, to_write) = sync_channel::<Frame>(WAITING);
    let (hand_over, taken) = sync_channel::<MotionFiles>(1);
    let door = Door::here();
    let write = move || {
        let mut files: MotionFiles = taken.recv().expect("they are handed over once the thread is there");
        let result = to_write.iter().try_for_each(|frame| files.push(&frame));
        (files, result)
    };
    let thread = Builder::new().name("sinew files".to_owned()).spawn(move || door.over(write));
    match thread {
        Ok(thread) => match hand_over.send(files) {
            Ok(()) => Ok(Writing { frames, thread }),
            Err(back) => Err(back.0),
        },
        Err(_) => Err(files),
    }
}
