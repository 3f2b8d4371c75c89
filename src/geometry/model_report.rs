//! What was found in a model, and what was done about it.

use std::fmt;

/// Counts of what is odd about a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelReport {
    /// What the reader of the file left out or took another way.
    pub reading: Vec<Finding>,
    /// Vertices of the picture.
    pub vertices: usize,
    /// Different positions of the surface.
    pub points: usize,
    /// Faces of the surface.
    pub faces: usize,
    /// Vertices whose position is no number or beyond all measure; the faces at them were left out.
    pub lost_vertices: usize,
    /// Faces left out for that.
    pub lost_faces: usize,
    /// Faces of which two corners fall together, left out.
    pub collapsed_faces: usize,
    /// Faces without area, kept where they close the surface.
    pub flat_faces: usize,
    /// Faces that were there twice, left out.
    pub duplicate_faces: usize,
    /// Points moved onto another that was as good as at the same place.
    pub welded_points: usize,
    /// Edges of one face only.
    pub open_edges: usize,
    /// Loops that those form.
    pub holes: usize,
    /// Edges of more than two faces.
    pub crowded_edges: usize,
    /// Faces turned round to agree with their neighbours.
    pub turned_faces: usize,
    /// Edges across which no turning helps.
    pub twisted_edges: usize,
    /// Pieces of surface not connected by edges.
    pub pieces: usize,
    /// Pieces that were inside out and were turned round.
    pub inverted_pieces: usize,
    /// Cavities within other pieces.
    pub cavities: usize,
    /// Pieces wholly within another piece.
    pub nested_pieces: usize,
    /// Pairs of faces that pass through each other.
    pub crossings: usize,
    /// Whether the surface is closed, so that every point is either inside or outside.
    pub closed: bool,
    /// Share of the filled points that lie where inside and outside are not clearly told apart; zero when closed.
    pub doubtful: f64,
    /// What parts share, over the volume inside, where it counts once.
    pub shared: f64,
    /// Pieces that enclose nothing, left out.
    pub left_out: LeftOut,
}

/// Sheets and strays that were left out, for they enclose nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeftOut {
    /// How many pieces.
    pub pieces: usize,
    /// Their faces.
    pub faces: usize,
    /// Names of the parts of the model that they are of, where they have one.
    pub parts: Vec<String>,
    /// The middle of the first [m].
    pub at: [f64; 3],
}

impl LeftOut {
    /// Together with what was left out later.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        let at = if self.pieces > 0 { self.at } else { other.at };
        let mut parts = self.parts;
        parts.extend(other.parts);
        parts.dedup();
        Self { pieces: self.pieces + other.pieces, faces: self.faces + other.faces, parts, at }
    }

    /// The first few names, in brackets.
    fn names(&self) -> String {
        if self.parts.is_empty() {
            return String::new();
        }
        let names: Vec<String> = self.parts.iter().take(NAMES).map(|name| format!("{name:?}")).collect();
        let more = if self.parts.len() > NAMES { ", ..." } else { "" };
        format!(" ({}{more})", names.join(", "))
    }
}

/// Names of parts that are written out.
const NAMES: usize = 3;

/// Share of the volume that parts may have in common without a word.
const SHARED: f64 = 1e-4;

/// One thing that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// What, how often, and what was done.
    pub text: String,
    /// Whether a person should look at the model.
    pub warning: bool,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A model that cannot be filled.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// Nothing but points and lines, or nothing at all.
    #[error("the model has no faces{}; export it as a surface of faces", lost(*.lost_faces))]
    NoFaces {
        /// Faces left out for vertices that are no numbers.
        lost_faces: usize,
    },
    /// A surface without an inside.
    #[error(
        "the surface encloses nothing ({open_edges} open edges in {holes} {}); give it thickness or close it in the \
         program it is from", count_noun(*.holes, "hole")
    )]
    NothingInside {
        /// Edges of one face only.
        open_edges: usize,
        /// Loops that those form.
        holes: usize,
    },
    /// Holes through which inside and outside run into each other.
    #[error(
        "the surface is too open to tell its inside from its outside ({open_edges} open edges in {holes} {}, {} % of \
         the inside in doubt); close the holes in the program it is from", count_noun(*.holes, "hole"), percent(*.doubtful)
    )]
    TooOpen {
        /// Edges of one face only.
        open_edges: usize,
        /// Loops that those form.
        holes: usize,
        /// Share of the inside where the two are not clearly told apart.
        doubtful: f64,
    },
}

fn lost(faces: usize) -> String {
    if faces == 0 { String::new() } else { format!(" ({faces} were left out: their vertices are no numbers)") }
}

/// Of the inside no more than all can be in doubt, however much more there is outside of what is counted as inside.
fn percent(share: f64) -> f64 {
    (100.0 * share).round().min(100.0)
}

fn count_noun(count: usize, noun: &str) -> String {
    if count == 1 { noun.to_owned() } else { format!("{noun}s") }
}

/// A count with its noun.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {}", count_noun(count, noun))
}

impl ModelReport {
    /// Everything worth saying, in the order in which it was found.
    pub fn findings(&self) -> Vec<Finding> {
        let mut found = self.reading.clone();
        let mut say = |count: usize, warning: bool, text: String| {
            if count > 0 {
                found.push(Finding { text, warning });
            }
        };
        say(
            self.lost_vertices,
            true,
            format!(
                "{} without a usable position: the {} at them left out",
                counted(self.lost_vertices, "vertex").replace("vertexs", "vertices"),
                counted(self.lost_faces, "face")
            ),
        );
        say(self.collapsed_faces, false, format!("{} of zero size left out", counted(self.collapsed_faces, "face")));
        say(self.flat_faces, false, format!("{} without area kept", counted(self.flat_faces, "face")));
        say(self.duplicate_faces, false, format!("{} left out as duplicates", counted(self.duplicate_faces, "face")));
        say(self.welded_points, false, format!("{} welded to close gaps", counted(self.welded_points, "point")));
        let left_out = &self.left_out;
        say(
            left_out.pieces,
            true,
            format!(
                "{}{} of {} {} nothing and {} left out, the first around {:.4?} m",
                counted(left_out.pieces, "piece"),
                left_out.names(),
                counted(left_out.faces, "face"),
                if left_out.pieces == 1 { "encloses" } else { "enclose" },
                if left_out.pieces == 1 { "is" } else { "are" },
                left_out.at
            ),
        );
        say(
            self.turned_faces,
            true,
            format!("{} turned round to agree with their neighbours", counted(self.turned_faces, "face")),
        );
        say(self.inverted_pieces, true, format!("{} inside out: turned round", counted(self.inverted_pieces, "piece")));
        say(
            self.twisted_edges,
            true,
            format!("{} where no turning helps", counted(self.twisted_edges, "twisted edge")),
        );
        say(
            self.crowded_edges,
            false,
            format!("{} (of more than two faces)", counted(self.crowded_edges, "non-manifold edge")),
        );
        say(
            self.open_edges,
            true,
            format!("{} with {}", counted(self.holes, "hole"), counted(self.open_edges, "open edge")),
        );
        say(
            self.crossings,
            false,
            format!(
                "{} of faces pass through each other: what is inside any part is filled once",
                counted(self.crossings, "pair")
            ),
        );
        say(
            usize::from(self.shared.abs() > SHARED && self.nested_pieces == 0),
            false,
            format!("parts share {:.2} % of the volume inside, which is filled once", 100.0 * self.shared),
        );
        say(
            self.cavities,
            false,
            format!("{} kept empty", counted(self.cavities, "cavity").replace("cavitys", "cavities")),
        );
        say(self.nested_pieces, false, format!("{} within another, filled once", counted(self.nested_pieces, "piece")));
        say(
            usize::from(!self.closed),
            true,
            format!(
                "not closed: inside and outside are told apart by the winding number, {} % of the inside in doubt",
                percent(self.doubtful)
            ),
        );
        found
    }
}
