//! OBJ: bodies on the vertices of their files, polygons uncut, with texture coordinates, normals, colours, groups and
//! materials; fibres as lines.

use super::names::word;
use crate::export::{BodyFrame, BodySubject, Subject};
use crate::geometry::file_mesh::FileMesh;
use crate::io::colours::for_screen;
use crate::io::obj::write_element;
use glam::DVec3;
use std::io::{self, Write};

/// What holds from one object of a file to the next.
struct Next<'a> {
    /// Numbers of the next vertex, the next texture coordinates and the next normal: a file counts them from 1.
    vertex: usize,
    texture: usize,
    normal: usize,
    /// Group and material of what comes next; empty for none.
    group: &'a str,
    material: &'a str,
}

impl<'a> Next<'a> {
    fn new() -> Self {
        Self { vertex: 1, texture: 1, normal: 1, group: "", material: "" }
    }

    /// Says group and material where they are not those that hold.
    fn change(&mut self, out: &mut dyn Write, group: &'a str, material: &'a str) -> io::Result<()> {
        let or = |name: &str, none: &str| if name.is_empty() { none.to_owned() } else { word(name) };
        if std::mem::replace(&mut self.group, group) != group {
            writeln!(out, "g {}", or(group, "default"))?;
        }
        if std::mem::replace(&mut self.material, material) != material {
            writeln!(out, "usemtl {}", or(material, "none"))?;
        }
        Ok(())
    }
}

/// Writes a body where it was put, undeformed, to the last digit.
pub(super) fn write_rest(out: &mut dyn Write, body: &BodySubject) -> io::Result<()> {
    writeln!(out, "o {}", word(&body.name))?;
    let mut colours = body.mesh.colours.iter();
    for point in &body.mesh.points {
        write!(out, "v {} {} {}", point.x, point.y, point.z)?;
        end_vertex(out, colours.next())?;
    }
    let normals = body.mesh.normals.as_ref().map_or(&[][..], |normals| &normals.values);
    write_faces(out, &body.mesh, normals, &mut Next::new())
}

/// Writes the bodies of a frame, to nine places.
pub(super) fn write_frame(out: &mut dyn Write, subject: &Subject, bodies: &[BodyFrame], time: f64) -> io::Result<()> {
    let space = subject.space;
    let unit = if space.scale == 1.0 { "metres".to_owned() } else { format!("{} units a metre", space.scale) };
    writeln!(out, "# sinew, {time} s; {unit}, {:?} up", space.up)?;
    let mut next = Next::new();
    for (body, frame) in subject.bodies.iter().zip(bodies) {
        writeln!(out, "o {}", word(&body.name))?;
        write_vertices(out, &frame.vertices, &body.mesh.colours)?;
        write_faces(out, &body.mesh, &frame.normals, &mut next)?;
        for (fibre, frame) in body.fibres.iter().zip(&frame.fibres) {
            next.change(out, "", "")?;
            writeln!(out, "o {}.{}", word(&body.name), word(&fibre.id))?;
            write_vertices(out, &frame.vertices, &[])?;
            let end = next.vertex + frame.vertices.len();
            write_element(out, "l", next.vertex..end)?;
            next.vertex = end;
        }
    }
    Ok(())
}

/// Writes vertices; the first so many have colours.
fn write_vertices(out: &mut dyn Write, vertices: &[DVec3], colours: &[[f32; 4]]) -> io::Result<()> {
    let mut colours = colours.iter();
    vertices.iter().try_for_each(|vertex| {
        write!(out, "v {:.9} {:.9} {:.9}", vertex.x, vertex.y, vertex.z)?;
        end_vertex(out, colours.next())
    })
}

/// Ends the line of a vertex, with its colour behind the place as many programs have it.
fn end_vertex(out: &mut dyn Write, colour: Option<&[f32; 4]>) -> io::Result<()> {
    match colour.map(|&colour| for_screen(colour)) {
        Some([r, g, b]) => writeln!(out, " {r:.6} {g:.6} {b:.6}"),
        None => writeln!(out),
    }
}

/// Writes faces over the vertices that were written last, with normals in the order of those of the mesh, if there are
/// any; vertices without any face as points.
fn write_faces<'a>(out: &mut dyn Write, mesh: &'a FileMesh, normals: &[DVec3], next: &mut Next<'a>) -> io::Result<()> {
    let first = next.vertex;
    next.vertex += mesh.points.len();
    if mesh.counts.is_empty() {
        next.change(out, "", "")?;
        return write_element(out, "p", first..next.vertex);
    }
    let textures = mesh.uv_sets.first();
    let first_texture = next.texture;
    for [u, v] in textures.iter().flat_map(|set| &set.values) {
        writeln!(out, "vt {u} {v}")?;
        next.texture += 1;
    }
    let first_normal = next.normal;
    for normal in normals {
        writeln!(out, "vn {:.6} {:.6} {:.6}", normal.x, normal.y, normal.z)?;
        next.normal += 1;
    }
    let lit = mesh.normals.as_ref().filter(|_| !normals.is_empty());
    let mut parts = mesh.parts.iter().peekable();
    // One part without a material is the object itself.
    let are_told = mesh.parts.len() > 1 || mesh.parts.iter().any(|part| !part.material.is_empty());
    for (face, corners) in mesh.faces().enumerate() {
        while let Some(part) = parts.next_if(|part| part.faces.start == face) {
            next.change(out, if are_told { &part.name } else { "" }, &part.material)?;
        }
        write!(out, "f")?;
        let textured = textures.filter(|set| corners.clone().all(|corner| set.of(corner).is_some()));
        for corner in corners {
            write!(out, " {}", first + mesh.corners[corner] as usize)?;
            if let Some(texture) = textured.and_then(|set| set.of(corner)) {
                write!(out, "/{}", first_texture + texture as usize)?;
            }
            if let Some(normal) = lit.and_then(|normals| normals.of(corner)) {
                let no_texture = if textured.is_none() { "/" } else { "" };
                write!(out, "{no_texture}/{}", first_normal + normal as usize)?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}
