//! PLY, binary, single precision: a frame's bodies as one mesh, and its particles as points.

use crate::export::{BodyFrame, Subject};
use crate::io::colours::for_screen;
use glam::DVec3;
use std::io::{self, Write};

fn write_vector(out: &mut dyn Write, v: DVec3) -> io::Result<()> {
    v.as_vec3().to_array().into_iter().try_for_each(|c| write_number(out, c))
}

fn write_number(out: &mut dyn Write, value: f32) -> io::Result<()> {
    out.write_all(&value.to_le_bytes())
}

fn write_head(out: &mut dyn Write, time: f64) -> io::Result<()> {
    writeln!(out, "ply\nformat binary_little_endian 1.0\ncomment sinew, {time} s")
}

/// How the length of a list is written: by a byte where that is enough.
#[derive(Clone, Copy)]
enum Length {
    Byte,
    Int,
}

impl Length {
    fn of(longest: usize) -> Self {
        if u8::try_from(longest).is_ok() { Self::Byte } else { Self::Int }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Byte => "uchar",
            Self::Int => "int",
        }
    }

    fn write(self, out: &mut dyn Write, length: usize) -> io::Result<()> {
        match self {
            Self::Byte => out.write_all(&[length as u8]),
            Self::Int => out.write_all(&(length as u32).to_le_bytes()),
        }
    }
}

/// Writes the bodies of a frame as one mesh, one after another: `body` counts them from 0. Texture coordinates are the
/// faces' `texcoord`, two numbers a corner; normals are there where every vertex has one. What a body has not of what
/// another has is zero, and its colour white.
pub(super) fn write_mesh(out: &mut dyn Write, subject: &Subject, bodies: &[BodyFrame], time: f64) -> io::Result<()> {
    let meshes = || subject.bodies.iter().map(|body| &body.mesh);
    let counts = || meshes().flat_map(|mesh| &mesh.counts);
    let textured = meshes().any(|mesh| !mesh.uv_sets.is_empty());
    let longest = counts().max().map_or(0, |&count| count as usize);
    let length = Length::of(if textured { 2 * longest } else { longest });
    write_head(out, time)?;
    let vertices: usize = bodies.iter().map(|body| body.vertices.len()).sum();
    writeln!(out, "element vertex {vertices}")?;
    let mut properties =
        |kind: &str, names: &str| names.split(' ').try_for_each(|name| writeln!(out, "property {kind} {name}"));
    properties("float", "x y z vx vy vz")?;
    let are_lit = meshes().any(|mesh| mesh.normals_of_vertices().is_some());
    if are_lit {
        properties("float", "nx ny nz")?;
    }
    let are_coloured = meshes().any(|mesh| !mesh.colours.is_empty());
    if are_coloured {
        properties("uchar", "red green blue")?;
    }
    writeln!(out, "property int body\nelement face {}", counts().count())?;
    writeln!(out, "property list {} int vertex_indices", length.name())?;
    if textured {
        writeln!(out, "property list {} float texcoord", length.name())?;
    }
    writeln!(out, "end_header")?;
    for (index, (body, mesh)) in bodies.iter().zip(meshes()).enumerate() {
        let normals = mesh.normals_of_vertices();
        for (k, &vertex) in body.vertices.iter().enumerate() {
            write_vector(out, vertex)?;
            write_vector(out, body.velocities.get(k).copied().unwrap_or_default())?;
            if are_lit {
                let of_vertex = normals.as_ref().map(|normals| normals[k] as usize);
                write_vector(out, of_vertex.and_then(|normal| body.normals.get(normal)).copied().unwrap_or_default())?;
            }
            if are_coloured {
                let colour = mesh.colours.get(k).map_or([1.0; 3], |&colour| for_screen(colour));
                out.write_all(&colour.map(|share| (255.0 * share).round().clamp(0.0, 255.0) as u8))?;
            }
            out.write_all(&(index as u32).to_le_bytes())?;
        }
    }
    let mut first = 0;
    for mesh in meshes() {
        for corners in mesh.faces() {
            length.write(out, corners.len())?;
            for &vertex in &mesh.corners[corners.clone()] {
                out.write_all(&(first + vertex).to_le_bytes())?;
            }
            if textured {
                length.write(out, 2 * corners.len())?;
                for corner in corners {
                    let set = mesh.uv_sets.first();
                    let uv = set.and_then(|set| Some(set.values[set.of(corner)? as usize])).unwrap_or_default();
                    uv.into_iter().try_for_each(|c| write_number(out, c as f32))?;
                }
            }
        }
        first += mesh.points.len() as u32;
    }
    Ok(())
}

/// Writes the particles of a frame; a field that a body has not is zero there.
pub(super) fn write_particles(out: &mut dyn Write, bodies: &[BodyFrame], time: f64) -> io::Result<()> {
    write_head(out, time)?;
    let count: usize = bodies.iter().map(|body| body.particles.positions.len()).sum();
    writeln!(out, "element vertex {count}")?;
    let names = "x y z vx vy vz volume_fraction strain stress fibre_x fibre_y fibre_z";
    names.split(' ').try_for_each(|name| writeln!(out, "property float {name}"))?;
    writeln!(out, "property int body\nend_header")?;
    for (index, body) in bodies.iter().enumerate() {
        let particles = &body.particles;
        for (k, &position) in particles.positions.iter().enumerate() {
            write_vector(out, position)?;
            write_vector(out, particles.velocities[k])?;
            for field in [&particles.fractions, &particles.strains, &particles.stresses] {
                write_number(out, field.get(k).map_or(0.0, |&value| value as f32))?;
            }
            write_vector(out, particles.directions.get(k).copied().unwrap_or_default())?;
            out.write_all(&(index as u32).to_le_bytes())?;
        }
    }
    Ok(())
}
