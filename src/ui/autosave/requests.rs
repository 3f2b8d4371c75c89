//! What the window asks of the thread that keeps the document, and what that tells.

use super::offer::RecoveryOffer;
use super::recorder::RecordingOffer;
use crate::io::{FileStamp, FileState, IoError, Origin, RecoverableDocument};
use crate::scene::Scene;
use crate::sim::JournalTail;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::Sender;

/// What is asked of the thread.
pub(super) enum AutosaveRequest {
    /// Keeps documents in this folder from now on, and tells which were left there.
    Folder(PathBuf),
    /// Keeps the newest document in the slot before long.
    Keep,
    /// Keeps at once what waits.
    KeepNow,
    /// The same, and says when that is done.
    KeepAndSay(Sender<()>),
    /// Keeps the recording of a motion from now on, whose document belongs there.
    Record(JournalTail, Origin),
    /// The document whose motion begins next belongs there.
    Opened(Origin),
    /// That whose motion goes on belongs there now.
    Placed(Origin),
    /// Keeps what waits and ends: by a fault, or because the window was closed.
    End(bool),
    /// Forgets documents up to this number: they are saved, or their changes are not wanted.
    Forget(u64),
    /// What was recovered goes as soon as it is kept here, or forgotten.
    Recovered(RecoverableDocument),
    /// Looks after this file from now on; its reports bear this number.
    Watch(u64, Option<FileStamp>),
    /// Looks whether the watched file holds this.
    Compare(Arc<Scene>),
    /// Looks after the file now.
    Look,
}

/// What the thread tells.
pub(super) enum AutosaveReport {
    /// Documents that were left behind.
    Offers(Vec<RecoveryOffer>),
    /// Recordings that were.
    Recordings(Vec<RecordingOffer>),
    /// The document cannot be kept.
    NotKept(IoError),
    /// The recording of the motion cannot.
    NotRecorded(IoError),
    /// It is as long as it may become [bytes]: what comes now is not kept.
    RecordedUpTo(u64),
    /// The file that is watched under a number became this.
    File(u64, FileState),
}
