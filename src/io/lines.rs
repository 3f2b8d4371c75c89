//! Curves in space as other programs write them: polylines of OBJ, rows of CSV, lists of JSON. Every digit of every
//! number goes out and comes in.

use super::json::parse;
use super::model::load_obj_lines;
use super::read::read_text;
use super::scene::MAX_SCENE_BYTES;
use super::{IoError, write_atomically, write_json};
use crate::scene::{brief, one_line};
use glam::DVec3;
use serde_json::{Value, json};
use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;

/// A curve and whose it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct NamedLine {
    /// The body that it is of, as the file names it; may be empty.
    pub(crate) body: String,
    /// Its name; may be empty.
    pub(crate) name: String,
    /// Where it stands in the file, as a message calls it.
    pub(crate) place: String,
    /// Its vertices, in the file's unit and axes.
    pub(crate) points: Vec<DVec3>,
}

/// Formats, by how names end.
#[derive(Clone, Copy)]
enum Format {
    Obj,
    Csv,
    Json,
}

impl Format {
    fn of(path: &Path) -> Result<Self, IoError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
        match ending.as_str() {
            "obj" => Ok(Self::Obj),
            "csv" => Ok(Self::Csv),
            "json" => Ok(Self::Json),
            _ => Err(IoError::UnknownLines.within(path)),
        }
    }
}

/// Whether a path is that of a file of lines, by its name.
///
/// # Errors
/// [`IoError::UnknownLines`] where it is not.
pub(crate) fn check_lines_name(path: &Path) -> Result<(), IoError> {
    Format::of(path).map(drop)
}

/// Writes curves, wholly or not at all.
///
/// # Errors
/// [`IoError::UnknownLines`] for another name, and as [`write_atomically`].
pub(crate) fn write_lines(path: &Path, lines: &[NamedLine]) -> Result<(), IoError> {
    match Format::of(path)? {
        Format::Obj => write_atomically(path, |out| write_obj(out, lines)),
        Format::Csv => write_atomically(path, |out| write_csv(out, lines).map_err(io::Error::other)),
        Format::Json => {
            let fibre = |line: &NamedLine| {
                let vertices: Vec<[f64; 3]> = line.points.iter().map(DVec3::to_array).collect();
                json!({"body": line.body, "fibre": line.name, "vertices": vertices})
            };
            write_json(path, &json!({"fibres": lines.iter().map(fibre).collect::<Vec<_>>()}))
        }
    }
}

fn write_obj(out: &mut dyn Write, lines: &[NamedLine]) -> io::Result<()> {
    let word = |name: &str| name.replace(|c: char| c.is_whitespace() || c.is_control(), "_");
    let mut next = 1;
    for line in lines {
        let dot = if line.body.is_empty() { "" } else { "." };
        writeln!(out, "o {}{dot}{}", word(&line.body), word(&line.name))?;
        for point in &line.points {
            writeln!(out, "v {} {} {}", point.x, point.y, point.z)?;
        }
        write!(out, "l")?;
        for vertex in next..next + line.points.len() {
            write!(out, " {vertex}")?;
        }
        writeln!(out)?;
        next += line.points.len();
    }
    Ok(())
}

fn write_csv(out: &mut dyn Write, lines: &[NamedLine]) -> csv::Result<()> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record(["body", "fibre", "x", "y", "z"])?;
    for line in lines {
        for point in &line.points {
            let [x, y, z] = point.to_array().map(|c| c.to_string());
            table.write_record([&line.body, &line.name, &x, &y, &z])?;
        }
    }
    Ok(table.flush()?)
}

/// Reads curves. Names in an OBJ file are one word each, of which the part before a dot may be that of a body:
/// `is_body` knows these.
///
/// # Errors
/// [`IoError::InFile`] with what is wrong: another name, no regular file of sensible size, no sense in it, and where.
pub(crate) fn read_lines(path: &Path, is_body: impl Fn(&str) -> bool) -> Result<Vec<NamedLine>, IoError> {
    match Format::of(path)? {
        Format::Obj => load_obj_lines(path)?
            .into_iter()
            .map(|line| {
                let place = format!("line {}", line.line);
                let (body, name) = parted(&line.name, &is_body).map_err(|problem| fault("OBJ", &place, problem))?;
                Ok(NamedLine { body: body.to_owned(), name: name.to_owned(), place, points: line.points })
            })
            .collect(),
        Format::Csv => read_text(path, MAX_SCENE_BYTES).and_then(|text| read_csv(&text)),
        Format::Json => read_text(path, MAX_SCENE_BYTES).and_then(|text| of_json(&parse(&text)?)),
    }
    .map_err(|error| match error {
        error @ IoError::InFile { .. } => error,
        error => error.within(path),
    })
}

/// The body and the name of a line that a file names in one word; no body where it names none.
fn parted<'a>(name: &'a str, is_body: &impl Fn(&str) -> bool) -> Result<(&'a str, &'a str), String> {
    let ways = name.match_indices('.').map(|(dot, _)| (&name[..dot], &name[dot + 1..]));
    let mut meant = ways.filter(|(body, _)| is_body(body));
    match (meant.next(), meant.next()) {
        (Some((one, _)), Some((other, _))) => {
            let [name, one, other] = [name, one, other].map(|text| brief(&text));
            Err(format!("{name} may be of body {one} and of body {other}"))
        }
        (one, _) => Ok(one.unwrap_or(("", name))),
    }
}

fn fault(format: &'static str, place: impl Display, problem: impl Display) -> IoError {
    let remedy = match format {
        "CSV" => "give columns x, y and z, and fibre where there are several",
        "OBJ" => "name the body by --body, or give the lines as CSV or JSON",
        _ => "give {\"fibres\": [{\"vertices\": [[x, y, z], ...]}]}",
    };
    IoError::Model { format, problem: one_line(&format!("{place}: {problem}")), remedy: remedy.to_owned() }
}

fn read_csv(text: &str) -> Result<Vec<NamedLine>, IoError> {
    let mut table =
        csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.trim_start_matches('\u{feff}').as_bytes());
    let line = |error: &csv::Error| error.position().map_or(1, csv::Position::line);
    let unread = |error: csv::Error| fault("CSV", format_args!("line {}", line(&error)), "it is no row of the table");
    let head = table.headers().map_err(unread)?.clone();
    let column = |names: &[&str]| head.iter().position(|head| names.iter().any(|name| head.eq_ignore_ascii_case(name)));
    let place = |names: &[&str]| {
        column(names).ok_or_else(|| fault("CSV", "line 1", format_args!("there is no column {}", names[0])))
    };
    let axes = [place(&["x"])?, place(&["y"])?, place(&["z"])?];
    let (body, fibre) = (column(&["body"]), column(&["fibre", "fiber", "curve", "id"]));
    let mut lines: Vec<NamedLine> = Vec::new();
    for row in table.records() {
        let row = row.map_err(unread)?;
        let at = format!("line {}", row.position().map_or(0, csv::Position::line));
        let text = |column: Option<usize>| column.and_then(|column| row.get(column)).unwrap_or_default().to_owned();
        let (body, name) = (text(body), text(fibre));
        let mut point = [0.0; 3];
        for (c, &column) in point.iter_mut().zip(&axes) {
            let value = row.get(column).unwrap_or_default();
            *c = value
                .parse()
                .ok()
                .filter(|c: &f64| c.is_finite())
                .ok_or_else(|| fault("CSV", &at, format_args!("{} is not a number", brief(&value))))?;
        }
        match lines.last_mut().filter(|line| line.body == body && line.name == name) {
            Some(line) => line.points.push(point.into()),
            None => lines.push(NamedLine { body, name, place: at, points: vec![point.into()] }),
        }
    }
    Ok(lines)
}

fn of_json(value: &Value) -> Result<Vec<NamedLine>, IoError> {
    let Some(list) = value.get("fibres").unwrap_or(value).as_array() else {
        return Err(fault("JSON", "/", "it holds no list of fibres"));
    };
    let mut lines = Vec::new();
    for (index, fibre) in list.iter().enumerate() {
        let place = format!("fibre {} of the list", index + 1);
        let vertices = fibre.get("vertices").unwrap_or(fibre).as_array();
        let vertices = vertices.ok_or_else(|| fault("JSON", &place, "it has no list of vertices"))?;
        let point = |vertex: &Value| {
            let numbers: Option<Vec<f64>> = vertex.as_array()?.iter().map(Value::as_f64).collect();
            <[f64; 3]>::try_from(numbers?).ok().map(DVec3::from_array)
        };
        let bad = |vertex: usize| fault("JSON", &place, format_args!("vertex {vertex}, from 0, is not three numbers"));
        let points = vertices.iter().enumerate().map(|(k, vertex)| point(vertex).ok_or_else(|| bad(k)));
        let points = points.collect::<Result<Vec<_>, _>>()?;
        let text =
            |names: &[&str]| names.iter().find_map(|name| fibre.get(*name)?.as_str()).unwrap_or_default().to_owned();
        lines.push(NamedLine { body: text(&["body"]), name: text(&["fibre", "id", "name"]), place, points });
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_come_back_to_the_last_digit_in_every_format() {
        let points = vec![DVec3::new(0.1, -1.0 / 3.0, 1e-17), DVec3::new(1e9, 2.5, 3.0), DVec3::ZERO];
        let line = |body: &str, name: &str| NamedLine {
            body: body.to_owned(),
            name: name.to_owned(),
            points: points.clone(),
            ..NamedLine::default()
        };
        let lines = [line("a", "f1"), line("a", "f.2"), line("b.c", "f.2"), line("", "c.d")];
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.obj", "a.csv", "a.JSON"] {
            let path = folder.path().join(name);
            write_lines(&path, &lines).unwrap();
            let mut read = read_lines(&path, |name| ["a", "b.c"].contains(&name)).unwrap();
            assert!(read.iter_mut().all(|line| !std::mem::take(&mut line.place).is_empty()));
            assert_eq!(read, lines, "{name}");
        }
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        let folder = tempfile::tempdir().unwrap();
        for (name, text, part) in [
            ("a.txt", "", "give .obj, .csv or .json"),
            ("a.csv", "x,y\n1,2\n", "line 1: there is no column z"),
            ("a.csv", "x,y,z\n1,2,3\n1,2,b\n", "line 3: \"b\" is not a number"),
            ("a.json", "{\"fibres\": 3}", "it holds no list of fibres"),
            ("a.json", "[[[0, 0, 0], [1, 2]]]", "fibre 1 of the list: vertex 1, from 0, is not three numbers"),
            ("a.obj", "v 0 0 0\nl 1 7\n", "line 2"),
        ] {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            let error = read_lines(&path, |_| false).expect_err(name).to_string();
            assert!(error.contains(part) && error.contains(name), "{error}");
        }
    }
}
