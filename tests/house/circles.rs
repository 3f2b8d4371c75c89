//! Circles of files: which file of an area imports which other, and where that goes round.
//!
//! A path is followed through the modules to the file that it ends in. A name that a module's file brings in by a `use`
//! is followed further, to the file where it is defined, so that `use super::Thing` is an import of the sibling that
//! defines the thing wherever the parent re-exports it. The parent's own `mod` and `pub use` of what lies below it are
//! no imports, unless its code speaks of the name. Methods are not seen: only paths tie files.

use crate::imports::{Import, Kind, imports};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Files, and the names by which each imports another.
type Ties = BTreeMap<PathBuf, BTreeMap<PathBuf, BTreeSet<String>>>;

/// Files that import each other in a circle, with what ties them.
#[derive(Debug)]
pub struct Circle {
    /// The area that the files are in.
    pub area: String,
    /// The files, in the order of their names.
    pub files: Vec<PathBuf>,
    /// One line an import: `a.rs <- b.rs: Thing, other`, for a that imports from b.
    pub ties: Vec<String>,
}

/// The circles of files inside areas among sources with their paths below `src`.
pub fn circles(sources: &[(PathBuf, String)]) -> Vec<Circle> {
    let house = House::new(sources);
    let ties = house.ties();
    knots(&ties).into_iter().map(|files| circle(&ties, files)).collect()
}

struct House {
    files: BTreeMap<Vec<String>, PathBuf>,
    imports: BTreeMap<PathBuf, Vec<Import>>,
    /// What each name that a module brings in by a `use` stands for.
    names: BTreeMap<(Vec<String>, String), Vec<String>>,
}

impl House {
    fn new(sources: &[(PathBuf, String)]) -> Self {
        let mut house = Self { files: BTreeMap::new(), imports: BTreeMap::new(), names: BTreeMap::new() };
        for (path, text) in sources.iter().filter(|(path, _)| !path.ends_with("tests.rs")) {
            let module = module_of(path);
            house.imports.insert(path.clone(), imports(text, &module, false));
            house.files.insert(module, path.clone());
        }
        for import in house.imports.values().flatten() {
            if let Some(name) = &import.name {
                house.names.insert((import.module.clone(), name.clone()), import.path.clone());
            }
        }
        house
    }

    /// The module whose file defines what is at the end of a path, and its name there, if it is not the module itself.
    fn home(&self, path: &[String], follow: usize) -> (Vec<String>, Option<String>) {
        let mut module = Vec::new();
        for (k, segment) in path.iter().enumerate() {
            let below: Vec<String> = module.iter().chain([segment]).cloned().collect();
            if self.files.contains_key(&below) {
                module = below;
                continue;
            }
            let known = self.names.get(&(module.clone(), segment.clone()));
            match known.filter(|known| known[..] != path[..=k]) {
                Some(known) if follow > 0 => {
                    let further: Vec<String> = known.iter().chain(&path[k + 1..]).cloned().collect();
                    return self.home(&further, follow - 1);
                }
                _ => return (module, Some(segment.clone())),
            }
        }
        (module, None)
    }

    fn ties(&self) -> Ties {
        let mut ties = Ties::new();
        for (path, imports) in &self.imports {
            let module = module_of(path);
            let tied = ties.entry(path.clone()).or_default();
            for import in imports {
                let (home, name) = self.home(&import.path, 8);
                let is_below = home.len() > module.len() && home.starts_with(&module);
                let shows = import.kind == Kind::ReExport && is_below;
                // What a module that is brought in by its own name is needed for is told by the paths through it.
                let whole = import.name.is_some() && name.is_none();
                let same_room = !home.is_empty() && home.first() == module.first();
                if home != module && same_room && !shows && !whole {
                    let name = name.or(home.last().cloned()).unwrap_or_default();
                    tied.entry(self.files[&home].clone()).or_default().insert(name);
                }
            }
        }
        ties
    }
}

/// The path of a file's module: `io/scene.rs` is io::scene, `io/mod.rs` io, `main.rs` main, `lib.rs` the crate itself.
pub fn module_of(path: &Path) -> Vec<String> {
    let mut parts: Vec<String> =
        path.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
    if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
        parts.pop();
    }
    parts
}

/// All files that can be reached from one by imports.
fn reached(ties: &Ties, from: &Path) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    let mut open = vec![from.to_owned()];
    while let Some(next) = open.pop() {
        for file in ties[&next].keys() {
            if found.insert(file.clone()) {
                open.push(file.clone());
            }
        }
    }
    found
}

/// The strongly connected components of more than one file.
fn knots(ties: &Ties) -> Vec<Vec<PathBuf>> {
    let reached: BTreeMap<&PathBuf, BTreeSet<PathBuf>> = ties.keys().map(|file| (file, reached(ties, file))).collect();
    let mut knots: Vec<Vec<PathBuf>> = Vec::new();
    for file in ties.keys().filter(|file| reached[file].contains(*file)) {
        match knots.iter_mut().find(|knot| reached[file].contains(&knot[0]) && reached[&knot[0]].contains(file)) {
            Some(knot) => knot.push(file.clone()),
            None => knots.push(vec![file.clone()]),
        }
    }
    knots
}

fn circle(ties: &Ties, files: Vec<PathBuf>) -> Circle {
    let mut lines = Vec::new();
    for file in &files {
        for (other, names) in ties[file].iter().filter(|(other, _)| files.contains(other)) {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            lines.push(format!("{} <- {}: {}", file.display(), other.display(), names.join(", ")));
        }
    }
    let area = module_of(&files[0]).into_iter().next().unwrap_or_default();
    Circle { area, files, ties: lines }
}
