//! Wavefront OBJ: the shape of a world at one time.

use super::finite::check_points;
use crate::solver::snapshot::{BodySnapshot, Snapshot};
use glam::DVec3;
use std::io::{self, Write};

/// Writes a snapshot as OBJ text: of each body its skin (or, where it has none, its particles as points), then its
/// fibres as polylines, every one an object of its own. Coordinates are in metres, world axes, Y up, to the nanometre.
///
/// # Errors
/// What `out` gives, and [`IoError::NotFinite`](super::IoError::NotFinite) as an [`io::Error`] for a vertex at no
/// place.
pub fn write_obj(out: &mut dyn Write, snapshot: &Snapshot) -> io::Result<()> {
    writeln!(out, "# sinew, {} s; metres, Y up", snapshot.time)?;
    // OBJ counts the vertices of a file from 1, through all of its objects.
    let mut next = 1;
    for body in &snapshot.bodies {
        write_body(out, body, &mut next)?;
        for fibre in &body.fibres {
            let first = next;
            writeln!(out, "o {}.{}", object_name(&body.name), object_name(&fibre.id))?;
            let what = || format!("body {:?}, fibre {:?}: vertex", body.name, fibre.id);
            write_vertices(out, &fibre.vertices, &what, &mut next)?;
            write_element(out, "l", first..next)?;
        }
    }
    Ok(())
}

fn write_body(out: &mut dyn Write, body: &BodySnapshot, next: &mut usize) -> io::Result<()> {
    let first = *next;
    writeln!(out, "o {}", object_name(&body.name))?;
    if body.triangles.is_empty() {
        write_vertices(out, &body.particles, &|| format!("body {:?}: particle", body.name), next)?;
        return write_element(out, "p", first..*next);
    }
    write_vertices(out, &body.skin, &|| format!("body {:?}: vertex of the skin", body.name), next)?;
    for triangle in body.triangles.iter() {
        let [a, b, c] = triangle.map(|vertex| first + vertex as usize);
        writeln!(out, "f {a} {b} {c}")?;
    }
    Ok(())
}

/// Writes points; `what` names them where one is at no place.
fn write_vertices(
    out: &mut dyn Write,
    vertices: &[DVec3],
    what: &dyn Fn() -> String,
    next: &mut usize,
) -> io::Result<()> {
    check_points(vertices, what)?;
    for vertex in vertices {
        writeln!(out, "v {:.9} {:.9} {:.9}", vertex.x, vertex.y, vertex.z)?;
    }
    *next += vertices.len();
    Ok(())
}

pub(super) fn write_element(out: &mut dyn Write, kind: &str, vertices: std::ops::Range<usize>) -> io::Result<()> {
    if vertices.is_empty() {
        return Ok(());
    }
    write!(out, "{kind}")?;
    for vertex in vertices {
        write!(out, " {vertex}")?;
    }
    writeln!(out)
}

/// A name as one word: many readers end a name at the first space, all do at the end of the line.
fn object_name(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::snapshot::FibreSnapshot;

    #[test]
    fn indices_count_through_all_objects_and_names_are_one_word() {
        let skin = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let body = BodySnapshot {
            name: "left arm\n2".to_owned(),
            particles: vec![DVec3::Z; 2],
            fibres: vec![FibreSnapshot {
                id: "f 1".to_owned(),
                vertices: vec![DVec3::ZERO, DVec3::new(0.0, 0.5, 0.0)],
            }],
            skin,
            triangles: [[0, 1, 2]].into(),
            ..BodySnapshot::default()
        };
        let bare = BodySnapshot { triangles: [].into(), fibres: Vec::new(), ..body.clone() };
        let snapshot = Snapshot { time: 0.5, bodies: vec![body, bare], ..Snapshot::default() };
        let mut text = Vec::new();
        write_obj(&mut text, &snapshot).unwrap();
        let text = String::from_utf8(text).unwrap();
        let rest: Vec<&str> = text.lines().filter(|line| !line.starts_with("v ")).collect();
        let expected = [
            "# sinew, 0.5 s; metres, Y up",
            "o left_arm_2",
            "f 1 2 3",
            "o left_arm_2.f_1",
            "l 4 5",
            "o left_arm_2",
            "p 6 7",
        ];
        assert_eq!(rest, expected);
        assert_eq!(text.lines().nth(3), Some("v 1.000000000 0.000000000 0.000000000"));
    }

    #[test]
    fn a_vertex_at_no_place_is_named_and_not_written() {
        let body = |skin: [DVec3; 2], fibre: DVec3| BodySnapshot {
            name: "arm".to_owned(),
            skin: skin.to_vec(),
            triangles: [[0, 1, 1]].into(),
            fibres: vec![FibreSnapshot { id: "f1".to_owned(), vertices: vec![fibre] }],
            ..BodySnapshot::default()
        };
        let lost = DVec3::new(0.0, f64::NAN, 1.0);
        for (body, what) in [
            (body([DVec3::ZERO, lost], DVec3::ZERO), "body \"arm\": vertex of the skin 1 is (0, NaN, 1)"),
            (body([DVec3::ZERO; 2], lost), "body \"arm\", fibre \"f1\": vertex 0 is (0, NaN, 1)"),
        ] {
            let snapshot = Snapshot { bodies: vec![body], ..Snapshot::default() };
            let folder = tempfile::tempdir().expect("a folder");
            let path = folder.path().join("a.obj");
            let error =
                crate::io::write_atomically(&path, |out| write_obj(out, &snapshot)).expect_err("it is at no place");
            assert!(error.to_string().contains(what), "{error}");
            assert!(matches!(error.bare(), crate::io::IoError::NotFinite { .. }) && !path.exists());
        }
    }
}
