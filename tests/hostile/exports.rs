//! Exports as the command line writes them: of a small ring, in two versions that differ by their number of points.

use clap::Parser;
use sinew::cli::{Cli, Console, run};
use sinew::io::load_model;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Sides of the ring, and so half of its particles, in each version.
const SIDES: [usize; 2] = [8, 12];

/// What is said on standard error.
#[derive(Clone, Default)]
struct Said(Arc<Mutex<Vec<u8>>>);

impl Write for Said {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().expect("whole").write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Runs a ring for a frame and writes that and its start in these formats into a folder.
///
/// # Errors
/// What the command says stopped it.
fn export(folder: &Path, version: usize, formats: &str) -> Result<(), String> {
    let scene = folder.join(format!("ring-{version}.json"));
    let text = format!(
        r#"{{"version": 1, "two_layer": [{{"id": "ring", "shape": {{"ring": {{"sides": {}}}}}}}]}}"#,
        SIDES[version]
    );
    fs::write(&scene, text).expect("written");
    let out = folder.join("out");
    let [scene, out] = [&scene, &out].map(|path| path.to_str().expect("letters"));
    let cli = Cli::parse_from(["sinew", "simulate", scene, "--frames", "0..1", "--format", formats, "--out", out]);
    let said = Said::default();
    let mut console = Console::new(Box::new(io::sink()), Box::new(said.clone()), false);
    run(&cli.command.expect("a command"), &mut console);
    let said = String::from_utf8(said.0.lock().expect("whole").clone()).expect("text");
    let error = said.lines().find_map(|line| line.strip_prefix("error: "));
    error.map_or(Ok(()), |error| Err(error.to_owned()))
}

/// The version of a file by its number of points, all of which are there.
fn by_points(what: &str, points: usize) -> usize {
    let is_one = |version: &usize| points == 2 * SIDES[*version] || points == SIDES[*version];
    (0..2).find(is_one).unwrap_or_else(|| panic!("{what}: {points} points"))
}

/// Vertices of an OBJ file.
fn vertices(text: &str) -> usize {
    text.lines().filter(|line| line.starts_with("v ")).count()
}

/// A point cache: a header that says how much there is, and all of that.
pub fn cache(folder: &Path, version: usize) -> Result<(), String> {
    export(folder, version, "pc2")
}

/// Which versions of it and of the rest shape are there whole.
pub fn caches(folder: &Path) -> Vec<usize> {
    let rest = fs::read_to_string(folder.join("out/ring_rest.obj")).ok();
    let rest = rest.map(|text| by_points("rest shape", vertices(&text)));
    let whole = |bytes: Vec<u8>| {
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        assert_eq!(&bytes[..12], b"POINTCACHE2\0");
        let (points, samples) = (number(16), number(28));
        assert!(bytes.len() >= 32 + 12 * points * samples, "a cache of {samples} frames that are not there");
        assert!(samples > 0);
        by_points("cache", points)
    };
    fs::read(folder.join("out/ring.pc2")).into_iter().map(whole).chain(rest).collect()
}

/// What a stage names is there, all of one version: that.
fn stage(out: &Path, text: &str) -> usize {
    let after = |mark: &str| text.split_once(mark).unwrap_or_else(|| panic!("{mark}: {text}")).1;
    let number = |mark: &str| after(mark).lines().next().expect("a line").trim().parse::<u64>().expect("a number");
    let path = |mark: &str, end: char| out.join(after(mark).split_once(end).expect("an end").0);
    let read = |path: &Path| fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let list = |text: &str, mark: &str| -> Vec<String> {
        let all = text.split(mark).skip(1).map(|rest| rest.split_once(']').expect("an end").0.to_owned());
        let all: Vec<_> = all.collect();
        assert!(!all.is_empty(), "{mark}: {text}");
        all
    };
    let points = |list: &String| list.matches('(').count();
    // How many springs there are stands in what stays, where they are in each frame.
    let shape = read(&path("subLayers = [\n        @./", '@'));
    let springs = list(&shape, "curveVertexCounts = ")[0].matches('2').count();
    read(&path("manifestAssetPath = @./", '@'));
    let frames = path("templateAssetPath = \"./", '"').to_string_lossy().into_owned();
    let mut found = Vec::new();
    for frame in number("startTimeCode = ")..=number("endTimeCode = ") {
        let frame = read(Path::new(&frames.replace("######", &format!("{frame:06}"))));
        let lists = list(&frame, "point3f[] points.timeSamples");
        assert_eq!(lists.last().map(points), Some(2 * springs), "a frame of another shape");
        found.push(by_points("USD", points(&lists[0])));
    }
    assert!(found.windows(2).all(|pair| pair[0] == pair[1]) && !found.is_empty(), "{found:?}");
    found[0]
}

/// Files that are written anew or once a frame: MDD, glTF, OBJ, PLY, CSV and USD.
pub fn shapes(folder: &Path, version: usize) -> Result<(), String> {
    export(folder, version, "mdd,gltf,obj,ply,csv,usd")
}

/// Which versions of those that tell are there whole; the others are whole.
pub fn found_shapes(folder: &Path) -> Vec<usize> {
    let out = folder.join("out");
    let mut found = Vec::new();
    if let Ok(text) = fs::read_to_string(out.join("motion.usda")) {
        found.push(stage(&out, &text));
    }
    if let Ok(text) = fs::read_to_string(out.join("ring_rest.obj")) {
        found.push(by_points("rest shape", vertices(&text)));
    }
    if let Ok(bytes) = fs::read(out.join("ring.mdd")) {
        let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        let (frames, points) = (number(0), number(4));
        assert_eq!(bytes.len(), 8 + 4 * frames + 12 * frames * points, "MDD");
        found.push(by_points("MDD", points));
    }
    for entry in fs::read_dir(&out)
        .into_iter()
        .flatten()
        .flatten()
        .chain(fs::read_dir(out.join("motion_layers")).into_iter().flatten().flatten())
    {
        let path = entry.path();
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let text = || fs::read_to_string(&path).expect("text");
        match ending {
            "usda" => {
                let count = |mark: char| text().chars().filter(|&each| each == mark).count();
                assert!(text().starts_with("#usda 1.0") && count('{') == count('}'), "{}: torn", path.display());
            }
            "csv" => {
                let text = text();
                let commas = |line: &str| line.matches(',').count();
                let head = text.lines().next().map(commas);
                assert!(text.ends_with('\n') && text.lines().all(|line| Some(commas(line)) == head), "{text}");
                found.push(by_points("CSV", text.lines().count() - 1));
            }
            "glb" => {
                let bytes = fs::read(&path).expect("there");
                let length = u32::from_le_bytes(bytes[8..12].try_into().expect("four bytes"));
                assert_eq!(length as usize, bytes.len(), "GLB");
            }
            "obj" | "ply" => {
                if let Err(error) = load_model(&path) {
                    assert!(error.to_string().contains("face"), "{error}");
                }
            }
            _ => {}
        }
    }
    found
}
