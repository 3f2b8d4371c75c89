//! Polylines of an OBJ file (`l`), which are no part of a surface.

use super::failure::Failure;
use super::obj::each_statement;
use super::text::{named, shown, without_mark};
use glam::DVec3;

/// A polyline.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::io) struct ObjLine {
    /// Name of its object or group; may be empty.
    pub(in crate::io) name: String,
    /// Line of the file in which it begins.
    pub(in crate::io) line: usize,
    pub(in crate::io) points: Vec<DVec3>,
}

/// All polylines in their order. One that begins where the one before it ended, in the same object, goes on from it:
/// some programs write every edge by itself.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<ObjLine>, Failure> {
    let text = without_mark(bytes);
    let mut positions = Vec::new();
    each_statement(&text, |statement| {
        if statement.keyword() == b"v" {
            let mut at = [0.0; 3];
            if statement.numbers(&mut at)? < 3 {
                return Err(statement.fail("a vertex has three coordinates"));
            }
            positions.push(DVec3::from_array(at));
        }
        Ok(())
    })?;
    let (mut lines, mut name, mut seen, mut end) = (Vec::<ObjLine>::new(), String::new(), 0_i64, None);
    each_statement(&text, |statement| {
        match statement.keyword() {
            b"v" => seen += 1,
            b"o" | b"g" => (name, end) = (named(statement.name()), None),
            b"l" => {
                let mut vertices = Vec::new();
                for word in statement.values() {
                    let digits = word.split(|&byte| byte == b'/').next().unwrap_or_default();
                    let given = str::from_utf8(digits).ok().and_then(|digits| digits.parse::<i64>().ok());
                    let index = given.map(|given| if given < 0 { given + seen } else { given - 1 });
                    let point = index.and_then(|index| positions.get(usize::try_from(index).ok()?));
                    let (Some(index), Some(&point)) = (index, point) else {
                        let count = positions.len();
                        return Err(statement.fail(format_args!("`{}` is none of the {count} vertices", shown(word))));
                    };
                    if !point.is_finite() {
                        return Err(statement.fail(format_args!("vertex {} is at no place", shown(word))));
                    }
                    vertices.push((index, point));
                }
                let (first, last) = (vertices.first().map(|v| v.0), vertices.last().map(|v| v.0));
                let points = vertices.into_iter().map(|(_, point)| point);
                match lines.last_mut().filter(|_| first.is_some() && first == end) {
                    Some(line) => line.points.extend(points.skip(1)),
                    None => {
                        lines.push(ObjLine { name: name.clone(), line: statement.number, points: points.collect() });
                    }
                }
                end = last;
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_written_one_by_one_are_one_line_within_an_object() {
        let text = b"v 0 0 0\nv 1 0 0\nv 2 0 0\no a\nl 1 2\nl 2/1 3\nl 1 -1\no b\nl 3 1\n";
        let lines: Vec<(String, usize, Vec<f64>)> = read(text)
            .unwrap_or_default()
            .into_iter()
            .map(|line| (line.name, line.line, line.points.iter().map(|p| p.x).collect()))
            .collect();
        let expected = [
            ("a".to_owned(), 5, vec![0.0, 1.0, 2.0]),
            ("a".to_owned(), 7, vec![0.0, 2.0]),
            ("b".to_owned(), 9, vec![2.0, 0.0]),
        ];
        assert_eq!(lines, expected);
        assert!(read(b"v 0 0 0\nl 1 2\n").is_err() && read(b"v 0 0 nan\nl 1 1\n").is_err());
    }
}
