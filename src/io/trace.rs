//! A trace of what the program does: its spans with their times, as a list of Chrome trace events.
//!
//! Spans stand around whole frames, stages of baking, pictures handed to the window and files; none is as short as a
//! step. Without a trace they cost a look at a flag each.

use super::IoError;
use super::atomic::Draft;
use serde_json::{Map, Value, json};
use std::cell::Cell;
use std::collections::{BTreeMap, HashMap};
use std::fmt::Debug;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use tracing::field::{Field, Visit};
use tracing::level_filters::LevelFilter;
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Metadata, Subscriber};

/// How every trace begins, by which one is known again.
const HEAD: &str = "[\n{\"name\":\"process_name\",\"ph\":\"M\",\"pid\":1,\"tid\":0,\"args\":{\"name\":\"sinew\"}}";
const TAIL: &str = "\n]\n";

/// A trace that is being written. Dropped before it is finished, it leaves nothing.
pub(crate) struct Trace {
    path: PathBuf,
    recorder: Arc<Recorder>,
}

impl Trace {
    /// Writes a trace of everything that the program does from now on. There is one trace in the life of a program.
    ///
    /// # Errors
    /// [`IoError::Write`] within [`IoError::InFile`]: the file cannot be written, or holds something that is no trace.
    pub(crate) fn start(path: &Path) -> Result<Self, IoError> {
        let started = Self::begin(path).and_then(|trace| {
            let recorder = tracing::Dispatch::from(Arc::clone(&trace.recorder) as Arc<dyn Subscriber + Send + Sync>);
            tracing::dispatcher::set_global_default(recorder).map_err(io::Error::other)?;
            Ok(trace)
        });
        started.map_err(|error| IoError::Write(error).within(path))
    }

    fn begin(path: &Path) -> io::Result<Self> {
        let mut draft = Draft::begin(path)?;
        keep_what_is_no_trace(path)?;
        draft.write_all(HEAD.as_bytes())?;
        let sink = Sink { draft, failure: None, depths: BTreeMap::new() };
        let recorder = Recorder {
            begun: Instant::now(),
            next: AtomicU64::new(1),
            spans: Mutex::default(),
            sink: Mutex::new(Some(sink)),
        };
        Ok(Self { path: path.to_owned(), recorder: Arc::new(recorder) })
    }

    /// Ends the trace and puts it where it is to be. Spans that are still open end now.
    ///
    /// # Errors
    /// [`IoError::Write`] within [`IoError::InFile`].
    pub(crate) fn finish(self) -> Result<(), IoError> {
        let Some(sink) = lock(&self.recorder.sink).take() else { return Ok(()) };
        let end = || {
            keep_what_is_no_trace(&self.path)?;
            sink.finish(self.recorder.now())
        };
        end().map_err(|error| IoError::Write(error).within(&self.path))
    }
}

impl Drop for Trace {
    fn drop(&mut self) {
        // The recorder itself stays for as long as the program runs.
        lock(&self.recorder.sink).take();
    }
}

/// A path that was mistyped must not cost a scene or a report.
fn keep_what_is_no_trace(path: &Path) -> io::Result<()> {
    let mut head = Vec::new();
    match File::open(path) {
        Ok(file) => file.take(HEAD.len() as u64).read_to_end(&mut head)?,
        Err(_) => return Ok(()),
    };
    if head.is_empty() || head == HEAD.as_bytes() {
        return Ok(());
    }
    Err(io::Error::new(io::ErrorKind::AlreadyExists, "it holds something that is no trace"))
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Where events go.
struct Sink {
    draft: Draft,
    failure: Option<io::Error>,
    /// Spans that are open in each thread.
    depths: BTreeMap<u64, u32>,
}

impl Sink {
    /// Adds an event; after a failure there are no more.
    fn add(&mut self, event: &Value) {
        if self.failure.is_none() {
            self.failure = write!(self.draft, ",\n{event}").err();
        }
    }

    fn finish(mut self, now: f64) -> io::Result<()> {
        for (thread, depth) in std::mem::take(&mut self.depths) {
            for _ in 0..depth {
                self.add(&end(thread, now));
            }
        }
        self.failure.map_or(Ok(()), Err)?;
        self.draft.write_all(TAIL.as_bytes())?;
        self.draft.replace().map(drop)
    }
}

fn end(thread: u64, now: f64) -> Value {
    json!({"ph": "E", "ts": now, "pid": 1, "tid": thread})
}

/// What there is to say of a span.
struct Known {
    name: &'static str,
    args: Fields,
    handles: usize,
}

/// Hears of every span and writes down when it is entered and left.
struct Recorder {
    begun: Instant,
    next: AtomicU64,
    spans: Mutex<HashMap<u64, Known>>,
    sink: Mutex<Option<Sink>>,
}

impl Recorder {
    /// Time since the trace began [µs].
    fn now(&self) -> f64 {
        self.begun.elapsed().as_secs_f64() * 1e6
    }
}

impl Subscriber for Recorder {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        // What libraries trace is theirs.
        metadata.is_span() && metadata.target().split("::").next() == Some(env!("CARGO_CRATE_NAME"))
    }

    fn max_level_hint(&self) -> Option<LevelFilter> {
        Some(LevelFilter::INFO)
    }

    fn new_span(&self, span: &Attributes<'_>) -> Id {
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        let mut args = Fields::default();
        span.record(&mut args);
        lock(&self.spans).insert(id, Known { name: span.metadata().name(), args, handles: 1 });
        Id::from_u64(id)
    }

    fn record(&self, id: &Id, values: &Record<'_>) {
        if let Some(span) = lock(&self.spans).get_mut(&id.into_u64()) {
            values.record(&mut span.args);
        }
    }

    fn record_follows_from(&self, _id: &Id, _follows: &Id) {}

    fn event(&self, _event: &Event<'_>) {}

    fn enter(&self, id: &Id) {
        let now = self.now();
        let (thread, is_new) = this_thread();
        let spans = lock(&self.spans);
        let Some(Known { name, args: Fields(args), .. }) = spans.get(&id.into_u64()) else { return };
        let mut sink = lock(&self.sink);
        let Some(sink) = sink.as_mut() else { return };
        if is_new {
            let args = json!({"name": std::thread::current().name().unwrap_or("unnamed")});
            sink.add(&json!({"name": "thread_name", "ph": "M", "pid": 1, "tid": thread, "args": args}));
        }
        sink.add(&json!({"name": name, "ph": "B", "ts": now, "pid": 1, "tid": thread, "args": args}));
        *sink.depths.entry(thread).or_default() += 1;
    }

    fn exit(&self, _id: &Id) {
        let now = self.now();
        let (thread, _) = this_thread();
        let mut sink = lock(&self.sink);
        let Some(sink) = sink.as_mut() else { return };
        // One that was entered before the trace began has no beginning in it.
        if let Some(depth) = sink.depths.get_mut(&thread).filter(|depth| **depth > 0) {
            *depth -= 1;
            sink.add(&end(thread, now));
        }
    }

    fn clone_span(&self, id: &Id) -> Id {
        if let Some(span) = lock(&self.spans).get_mut(&id.into_u64()) {
            span.handles += 1;
        }
        id.clone()
    }

    fn try_close(&self, id: Id) -> bool {
        let mut spans = lock(&self.spans);
        let Some(span) = spans.get_mut(&id.into_u64()) else { return false };
        span.handles -= 1;
        let is_last = span.handles == 0;
        if is_last {
            spans.remove(&id.into_u64());
        }
        is_last
    }
}

thread_local! {
    static THREAD: Cell<u64> = const { Cell::new(0) };
}

/// Number of this thread, from 1 in the order in which they are first heard of, and whether that is now.
fn this_thread() -> (u64, bool) {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    THREAD.with(|thread| {
        let is_new = thread.get() == 0;
        if is_new {
            thread.set(NEXT.fetch_add(1, Ordering::Relaxed));
        }
        (thread.get(), is_new)
    })
}

/// Fields of a span.
#[derive(Default)]
struct Fields(Map<String, Value>);

impl Visit for Fields {
    fn record_u64(&mut self, field: &Field, value: u64) {
        self.0.insert(field.name().to_owned(), value.into());
    }

    fn record_i64(&mut self, field: &Field, value: i64) {
        self.0.insert(field.name().to_owned(), value.into());
    }

    fn record_bool(&mut self, field: &Field, value: bool) {
        self.0.insert(field.name().to_owned(), value.into());
    }

    fn record_str(&mut self, field: &Field, value: &str) {
        self.0.insert(field.name().to_owned(), value.into());
    }

    fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
        self.0.insert(field.name().to_owned(), format!("{value:?}").into());
    }
}
