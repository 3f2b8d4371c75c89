//! Files of any bytes for everything that reads: sound ones of `tests/corpus`, changed by chance. Nothing that they do
//! may be a panic or go on for ever; they are taken, and sound then, or refused in one sentence.
//!
//! The long form runs for any time, on all targets in turn or on one:
//!
//! ```sh
//! tests/tools/fuzz.sh SECONDS|INPUTSx [TARGET [SEED]]
//! ```
//!
//! It is a fuzzer by mutation, on the stable compiler; one that is led by coverage needs a nightly one.

use crate::files::corpus;
use crate::mutate::{Random, mutated};
use crate::read::{Verdict, as_file};
use crate::{drawn, read, run};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};
use std::{env, fs};

/// Something that reads.
struct Target {
    name: &'static str,
    /// Its sound files.
    folder: &'static str,
    read: fn(&Path) -> Verdict,
    /// Words of its format.
    words: &'static [&'static str],
    /// Inputs of the short form.
    short: u32,
}

const OBJ: &[&str] =
    &["v ", "f ", "vn ", "vt ", "o ", "g ", "usemtl red\n", "mtllib a.obj\n", "//", "/", "-1 ", "\\\n", "l ", "#"];
const STL: &[&str] =
    &["solid ", "endsolid\n", "facet ", "normal ", "outer loop\n", "vertex ", "endloop\n", "endfacet\n", "end "];
const PLY: &[&str] = &[
    "element vertex 3\n",
    "element face 1\n",
    "property float x\n",
    "property list uchar int vertex_indices\n",
    "end_header\n",
    "format ascii 1.0\n",
    "property list int double texcoord\n",
    "comment ",
    "element tristrips 1\n",
];
const GLTF: &[&str] = &[
    "\"byteStride\":1,",
    "\"sparse\":{\"count\":1},",
    "\"mode\":5,",
    "\"skin\":0,",
    "\"children\":[0],",
    "\"mesh\":0,",
    "\"matrix\":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0],",
    "\"count\":4294967295,",
    "\"normalized\":true,",
    "\"weights\":[1],",
];
const SCENE: &[&str] = &[
    "\"activation\":{\"drive\":{\"constant\":2}},",
    "\"follows\":[],",
    "\"voids\":[{\"id\":\"v\"}],",
    "\"gravity\":[0,0,0],",
    "\"hidden\":true,",
    "\"version\":1,",
    "\"integrator\":\"rk4\",",
    "\"integrator\":\"backward_euler\",",
    "\"poisson_ratio\":0.49,",
    "\"period\":0,",
];

const TARGETS: [Target; 12] = [
    Target { name: "scene", folder: "scene", read: read::scene, words: SCENE, short: 25 },
    Target { name: "obj", folder: "obj", read: read::model, words: OBJ, short: 60 },
    Target { name: "stl", folder: "stl", read: read::model, words: STL, short: 60 },
    Target { name: "ply", folder: "ply", read: read::model, words: PLY, short: 60 },
    Target { name: "gltf", folder: "gltf", read: read::model, words: GLTF, short: 60 },
    Target { name: "skeleton", folder: "skeleton", read: read::motion, words: GLTF, short: 60 },
    Target { name: "cache", folder: "cache", read: read::motion, words: &[], short: 80 },
    Target { name: "lines", folder: "lines", read: read::lines, words: OBJ, short: 80 },
    Target { name: "strokes", folder: "strokes", read: drawn::strokes, words: &[], short: 60 },
    Target { name: "commands", folder: "commands", read: drawn::commands, words: &[], short: 2 },
    Target { name: "drives", folder: "drives", read: run::drives, words: SCENE, short: 6 },
    Target { name: "recording", folder: "recording", read: run::journal, words: SCENE, short: 6 },
];

/// The sound files of a target, by their endings; the scene of every field is one more.
fn sound(target: &Target) -> BTreeMap<String, Vec<Vec<u8>>> {
    let mut by_ending: BTreeMap<String, Vec<Vec<u8>>> = BTreeMap::new();
    let mut put = |path: &Path, bytes| {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_owned();
        by_ending.entry(ending).or_default().push(bytes);
    };
    for (path, bytes) in corpus(target.folder) {
        put(&path, bytes);
    }
    if target.name == "scene" {
        put(Path::new("a.json"), include_bytes!("../scene_files/every_field.json").to_vec());
    }
    by_ending
}

/// An input of a target: the name of its file, and its bytes.
fn input(random: &mut Random, target: &Target, sound: &BTreeMap<String, Vec<Vec<u8>>>) -> (String, Vec<u8>) {
    let endings: Vec<&String> = sound.keys().collect();
    let ending = endings[random.below(endings.len())];
    (format!("a.{ending}"), mutated(random, &sound[ending], target.words))
}

#[test]
fn sound_files_and_those_that_once_did_harm_are_read_or_refused() {
    for target in &TARGETS {
        for (path, bytes) in corpus(target.folder) {
            let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
            let verdict = as_file(name, &bytes, target.read);
            let wanted = if name.starts_with("bad-") { Verdict::Refused } else { Verdict::Taken };
            assert!(verdict == wanted || name.starts_with("any-"), "{}: {verdict:?}", path.display());
        }
    }
}

#[test]
fn files_of_any_bytes_are_sound_or_refused_in_a_sentence() {
    for target in &TARGETS {
        let (sound, mut random) = (sound(target), Random(7));
        let mut verdicts = [0, 0];
        for _ in 0..target.short {
            let (name, bytes) = input(&mut random, target, &sound);
            verdicts[as_file(&name, &bytes, target.read) as usize] += 1;
        }
        // Changes that are never refused, or always, would test nothing.
        let [taken, refused] = verdicts;
        assert!(taken > 0 && (refused > 0 || target.name == "commands"), "{}: {taken} {refused}", target.name);
    }
}

/// What asks for the long form: for how long, then a target or `all`, then a seed.
const ASKED: &str = "SINEW_FUZZ";

/// On how many threads it runs; as many as the machine has unless given.
const THREADS: &str = "SINEW_FUZZ_THREADS";

/// How long the long form goes on: for so many seconds, or until so many inputs of every target were read.
#[derive(Clone, Copy, Debug)]
enum Length {
    Seconds(u64),
    Inputs(u64),
}

impl Length {
    /// Seconds, or inputs with an `x` behind them.
    fn of(word: &str) -> Self {
        let number = |word: &str| word.parse().expect("a number");
        word.strip_suffix('x').map_or_else(|| Self::Seconds(number(word)), |inputs| Self::Inputs(number(inputs)))
    }

    /// The share of one of so many threads.
    fn share(self, threads: u64) -> Self {
        match self {
            Self::Inputs(inputs) => Self::Inputs(inputs.div_ceil(threads)),
            seconds @ Self::Seconds(_) => seconds,
        }
    }
}

/// An input may take so long before it is told, and before it is taken for one that never ends.
const SLOW: Duration = Duration::from_secs(2);
const ENDLESS: Duration = Duration::from_mins(1);

/// What one target came to.
#[derive(Clone, Debug, Default)]
struct Tally {
    taken: u64,
    refused: u64,
    slow: u64,
    panics: u64,
    /// On all threads together.
    time: Duration,
}

impl Tally {
    fn read(&self) -> u64 {
        self.taken + self.refused + self.panics
    }

    fn add(&mut self, other: &Self) {
        self.taken += other.taken;
        self.refused += other.refused;
        self.slow += other.slow;
        self.panics += other.panics;
        self.time += other.time;
    }
}

type Tallies = BTreeMap<&'static str, Tally>;

/// An input that is being read.
type Current = Arc<Mutex<(String, String, Vec<u8>)>>;

/// How many inputs were kept.
static KEPT: AtomicUsize = AtomicUsize::new(0);

fn kept(current: &Current, what: &str) -> PathBuf {
    let held = current.lock().expect("whole");
    let count = KEPT.fetch_add(1, Ordering::SeqCst);
    let path = env::temp_dir().join(format!("sinew-fuzz-{}-{what}-{count}-{}", held.0, held.1));
    fs::write(&path, &held.2).expect("kept");
    path
}

/// Where the last panic was, and what it said; and where those were that were told.
static PANIC: Mutex<(String, String)> = Mutex::new((String::new(), String::new()));
static SEEN: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Reads one input of a target.
fn one(target: &Target, (name, bytes): (String, Vec<u8>), current: &Current, of: &mut Tally) -> Option<String> {
    *current.lock().expect("whole") = (target.name.to_owned(), name.clone(), bytes.clone());
    let start = Instant::now();
    let outcome = catch_unwind(AssertUnwindSafe(|| as_file(&name, &bytes, target.read)));
    let took = start.elapsed();
    of.time += took;
    if took > SLOW {
        of.slow += 1;
        println!("{}: {:.1} s: {}", target.name, took.as_secs_f64(), kept(current, "slow").display());
    }
    match outcome {
        Ok(Verdict::Taken) => of.taken += 1,
        Ok(Verdict::Refused) => of.refused += 1,
        Err(_) => {
            of.panics += 1;
            let (at, said) = PANIC.lock().expect("whole").clone();
            let mut seen = SEEN.lock().expect("whole");
            if !seen.contains(&at) {
                seen.push(at.clone());
                return Some(format!("{}: {at}: {said}: {}", target.name, kept(current, "panic").display()));
            }
        }
    }
    None
}

/// Reads input after input as long as that is to go on; tells of each.
fn work(length: Length, only: &str, seed: u64, current: &Current, told: &Sender<Option<String>>) -> Tallies {
    let mut targets: Vec<(&Target, _)> =
        TARGETS.iter().filter(|target| only == "all" || target.name == only).map(|t| (t, sound(t))).collect();
    assert!(!targets.is_empty(), "there is no target {only}");
    let mut tallies = Tallies::new();
    let mut random = Random(seed);
    let begun = Instant::now();
    while !targets.is_empty() && !matches!(length, Length::Seconds(most) if begun.elapsed().as_secs() >= most) {
        targets.retain(|(target, sound)| {
            let of = tallies.entry(target.name).or_default();
            // Of what takes long fewer.
            for _ in 0..target.short {
                let input = input(&mut random, target, sound);
                told.send(one(target, input, current, of)).expect("heard");
            }
            !matches!(length, Length::Inputs(most) if of.read() >= most)
        });
    }
    tallies
}

fn wait(heard: &Receiver<Option<String>>, current: &Current) -> Vec<String> {
    let mut faults = Vec::new();
    loop {
        match heard.recv_timeout(ENDLESS) {
            Ok(None) => {}
            Ok(Some(fault)) => {
                println!("{fault}");
                faults.push(fault);
            }
            Err(RecvTimeoutError::Disconnected) => return faults,
            Err(RecvTimeoutError::Timeout) => panic!("it never ends: {}", kept(current, "endless").display()),
        }
    }
}

#[test]
#[ignore = "for any time: tests/tools/fuzz.sh SECONDS|INPUTSx [TARGET [SEED]]"]
fn for_any_time() {
    let asked = env::var(ASKED).unwrap_or_else(|_| "10".to_owned());
    let mut words = asked.split_whitespace();
    let length = Length::of(words.next().expect("seconds, or inputs"));
    let only = words.next().unwrap_or("all").to_owned();
    let seed: u64 = words.next().map_or(1, |word| word.parse().expect("a seed"));
    let usual = || thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let threads: u64 = env::var(THREADS).map_or_else(|_| usual(), |word| word.parse().expect("a number"));
    std::panic::set_hook(Box::new(|panic| {
        let said = panic.payload_as_str().unwrap_or("something").replace(['\n', '\r'], " ");
        let at = panic.location().map_or_else(String::new, |at| format!("{}:{}", at.file(), at.line()));
        *PANIC.lock().expect("whole") = (at, said);
    }));
    let begun = Instant::now();
    let start = |number: u64| {
        let (current, only) = (Current::default(), only.clone());
        let (told, heard) = channel();
        let worker = {
            let (current, seed) = (Arc::clone(&current), seed.wrapping_add(number << 32));
            thread::spawn(move || work(length.share(threads), &only, seed, &current, &told))
        };
        thread::spawn(move || (wait(&heard, &current), worker.join().expect("it ends by itself")))
    };
    let all: Vec<_> = (0..threads).map(start).collect();
    let (mut faults, mut tallies) = (Vec::new(), Tallies::new());
    for one in all {
        let (found, of) = one.join().expect("it ends by itself");
        faults.extend(found);
        for (name, tally) in &of {
            tallies.entry(name).or_default().add(tally);
        }
    }
    for (name, tally) in &tallies {
        let Tally { taken, refused, slow, panics, time } = tally;
        let rate = tally.read() as f64 * threads as f64 / time.as_secs_f64();
        println!(
            "{name:10} {:9} read: {taken} taken, {refused} refused, {slow} slow, {panics} panics; {rate:.0} a second",
            tally.read()
        );
    }
    println!("seed {seed}, {threads} threads, {:.0} s", begun.elapsed().as_secs_f64());
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}
