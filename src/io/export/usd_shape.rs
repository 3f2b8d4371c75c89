//! What stays over a motion as a layer of USD: which prims there are, faces, texture coordinates, materials, widths.

use super::looks::{Look, merged_parts};
use super::names::{different, identifier};
use super::usd_text::{extent, quoted, write_list, write_vectors};
use crate::export::{BodySubject, Subject};
use crate::geometry::file_mesh::{FileMesh, FilePart, UvSet};
use std::collections::HashMap;
use std::io::{self, Write};

/// Width of a spring, as a share of its body's diagonal.
const SPRING_WIDTH: f64 = 0.003;

/// The scope of the materials.
const LOOKS: &str = "Looks";

/// Names of the prims of a body.
#[derive(Clone, Debug)]
pub(super) struct PrimNames {
    pub(super) surface: String,
    /// None without any normals.
    pub(super) normals: Option<NormalsAt>,
    /// None without any fibres.
    pub(super) fibres: Option<String>,
    /// None without any springs.
    pub(super) springs: Option<String>,
}

/// Where the normals of a body are.
#[derive(Clone, Debug)]
pub(super) struct NormalsAt {
    /// Whether every vertex has one, which is a fraction of the data; or else every corner.
    of_vertices: bool,
    /// Which of them each has; one behind the last for vertices of no face.
    pub(super) list: Vec<u32>,
}

impl NormalsAt {
    fn of(mesh: &FileMesh) -> Option<Self> {
        let of_corners =
            || mesh.normals.as_ref().map(|normals| Self { of_vertices: false, list: normals.corners.clone() });
        mesh.normals_of_vertices().map(|list| Self { of_vertices: true, list }).or_else(of_corners)
    }
}

/// Greatest widths of what is drawn at the points of the prims of a body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Widths {
    /// Zero but for points.
    pub(super) surface: f64,
    pub(super) fibres: f64,
    pub(super) springs: f64,
}

impl Widths {
    pub(super) fn of(body: &BodySubject) -> Self {
        let springs = f64::from(spring_width(body));
        Self {
            surface: if body.mesh.counts.is_empty() { springs } else { 0.0 },
            fibres: body.fibres.iter().map(|fibre| fibre.width).fold(0.0, f64::max),
            springs,
        }
    }
}

/// Names of the prims of all bodies, no two alike.
pub(super) fn prim_names(subject: &Subject) -> Vec<PrimNames> {
    let bodies = || subject.bodies.iter();
    let mut wanted: Vec<String> = vec![LOOKS.to_owned()];
    wanted.extend(bodies().map(|body| body.name.clone()));
    wanted.extend(bodies().map(|body| format!("{}_fibres", body.name)));
    wanted.extend(bodies().map(|body| format!("{}_springs", body.name)));
    let names = different(wanted.iter().map(String::as_str), identifier);
    let count = subject.bodies.len();
    let name = |kind: usize, index: usize| names[1 + kind * count + index].clone();
    let of = |(index, body): (usize, &BodySubject)| PrimNames {
        surface: name(0, index),
        normals: NormalsAt::of(&body.mesh),
        fibres: (!body.fibres.is_empty()).then(|| name(1, index)),
        springs: (!body.springs.is_empty()).then(|| name(2, index)),
    };
    bodies().enumerate().map(of).collect()
}

/// Writes the layer.
pub(super) fn write_shape(out: &mut dyn Write, subject: &Subject, names: &[PrimNames]) -> io::Result<()> {
    let (mut looks, mut numbers) = (Vec::new(), HashMap::new());
    for part in subject.bodies.iter().flat_map(|body| &body.mesh.parts).filter(|part| !part.material.is_empty()) {
        numbers.entry(Look::of(part)).or_insert_with(|| {
            looks.push(part);
            looks.len() - 1
        });
    }
    let look_names = different(looks.iter().map(|part| part.material.as_str()), identifier);
    let path_of = |part: &FilePart| Some(&look_names[*numbers.get(&Look::of(part))?]);
    writeln!(out, "#usda 1.0\n(\n    defaultPrim = \"Scene\"\n)\n\ndef Xform \"Scene\"\n{{")?;
    for (body, names) in subject.bodies.iter().zip(names) {
        if body.mesh.counts.is_empty() {
            write_points(out, body, names)?;
        } else {
            write_mesh(out, body, names, &path_of)?;
        }
        if let Some(name) = &names.fibres {
            write_fibres(out, body, name)?;
        }
        if let Some(name) = &names.springs {
            write_springs(out, body, name)?;
        }
    }
    if !looks.is_empty() {
        writeln!(out, "    def Scope \"{LOOKS}\"\n    {{")?;
        for (part, id) in looks.iter().zip(&look_names) {
            write_look(out, &part.material, part.colour, id)?;
        }
        writeln!(out, "    }}")?;
    }
    writeln!(out, "}}")
}

fn begin(out: &mut dyn Write, kind: &str, id: &str, name: &str, indent: &str) -> io::Result<()> {
    let shown =
        if id == name { String::new() } else { format!(" (\n{indent}    displayName = {}\n{indent})", quoted(name)) };
    writeln!(out, "{indent}def {kind} \"{id}\"{shown}\n{indent}{{")
}

/// Particles of a body that has no surface.
fn write_points(out: &mut dyn Write, body: &BodySubject, names: &PrimNames) -> io::Result<()> {
    begin(out, "Points", &names.surface, &body.name, "    ")?;
    writeln!(out, "        point3f[] points\n        vector3f[] velocities")?;
    writeln!(
        out,
        "        float[] widths = [{}] (\n            interpolation = \"constant\"\n        )",
        spring_width(body)
    )?;
    writeln!(out, "    }}")
}

fn write_mesh<'a>(
    out: &mut dyn Write,
    body: &BodySubject,
    names: &PrimNames,
    look_of: &dyn Fn(&FilePart) -> Option<&'a String>,
) -> io::Result<()> {
    let mesh = &body.mesh;
    begin(out, "Mesh", &names.surface, &body.name, "    ")?;
    write!(out, "        uniform token subdivisionScheme = \"none\"\n        int[] faceVertexCounts = ")?;
    write_list(out, &mesh.counts)?;
    write!(out, "\n        int[] faceVertexIndices = ")?;
    write_list(out, &mesh.corners)?;
    writeln!(out, "\n        point3f[] points\n        vector3f[] velocities")?;
    if let Some(normals) = &names.normals {
        let each = if normals.of_vertices { "vertex" } else { "faceVarying" };
        writeln!(out, "        normal3f[] normals (\n            interpolation = \"{each}\"\n        )")?;
    }
    write!(out, "        point3f[] primvars:rest = ")?;
    write_vectors(out, &mesh.points)?;
    writeln!(out, " (\n            interpolation = \"vertex\"\n        )")?;
    for (number, set) in mesh.uv_sets.iter().enumerate() {
        let name = if number == 0 { "st".to_owned() } else { format!("st{number}") };
        write_uvs(out, &name, set)?;
    }
    write_colours(out, &mesh.colours)?;
    write_parts(out, mesh, look_of)?;
    writeln!(out, "    }}")
}

/// Colours of the vertices.
fn write_colours(out: &mut dyn Write, colours: &[[f32; 4]]) -> io::Result<()> {
    if colours.is_empty() {
        return Ok(());
    }
    write!(out, "        color3f[] primvars:displayColor = ")?;
    write_list(out, colours.iter().map(|[r, g, b, _]| format!("({r}, {g}, {b})")))?;
    writeln!(out, " (\n            interpolation = \"vertex\"\n        )")?;
    if colours.iter().any(|colour| colour[3] < 1.0) {
        write!(out, "        float[] primvars:displayOpacity = ")?;
        write_list(out, colours.iter().map(|colour| colour[3]))?;
        writeln!(out, " (\n            interpolation = \"vertex\"\n        )")?;
    }
    Ok(())
}

fn write_uvs(out: &mut dyn Write, name: &str, set: &UvSet) -> io::Result<()> {
    // Corners without coordinates have a place of their own.
    let nowhere = set.values.len() as u32;
    let is_whole = (0..set.corners.len()).all(|corner| set.of(corner).is_some());
    let values = set.values.iter().map(|[u, v]| format!("({}, {})", *u as f32, *v as f32));
    let missing = (!is_whole).then(|| "(0, 0)".to_owned());
    write!(out, "        texCoord2f[] primvars:{name} = ")?;
    write_list(out, values.chain(missing))?;
    write!(
        out,
        " (\n            interpolation = \"faceVarying\"\n        )\n        int[] primvars:{name}:indices = "
    )?;
    write_list(out, (0..set.corners.len()).map(|corner| set.of(corner).unwrap_or(nowhere)))?;
    writeln!(out)
}

/// The faces of every part that has a material, or of which there are several.
fn write_parts<'a>(
    out: &mut dyn Write,
    mesh: &FileMesh,
    look_of: &dyn Fn(&FilePart) -> Option<&'a String>,
) -> io::Result<()> {
    let parts = merged_parts(mesh);
    let has_material = mesh.parts.iter().any(|part| !part.material.is_empty());
    if parts.len() < 2 && !has_material {
        return Ok(());
    }
    if has_material {
        writeln!(out, "        uniform token subsetFamily:materialBind:familyType = \"nonOverlapping\"")?;
    }
    let ids = different(parts.iter().map(|(part, _)| part.name.as_str()), |name| {
        identifier(if name.is_empty() { "part" } else { name })
    });
    for ((part, runs), id) in parts.iter().zip(ids) {
        let look = look_of(part);
        let schema = if look.is_some() { "prepend apiSchemas = [\"MaterialBindingAPI\"]\n            " } else { "" };
        let family = if look.is_some() { "materialBind" } else { "part" };
        writeln!(
            out,
            "        def GeomSubset \"{id}\" (\n            {schema}displayName = {}\n        )",
            quoted(&part.name)
        )?;
        writeln!(out, "        {{\n            uniform token elementType = \"face\"")?;
        writeln!(out, "            uniform token familyName = \"{family}\"")?;
        write!(out, "            int[] indices = ")?;
        write_list(out, runs.iter().cloned().flatten())?;
        if let Some(look) = look {
            write!(out, "\n            rel material:binding = </Scene/{LOOKS}/{look}>")?;
        }
        writeln!(out, "\n        }}")?;
    }
    Ok(())
}

fn write_look(out: &mut dyn Write, name: &str, colour: Option<[f32; 4]>, id: &str) -> io::Result<()> {
    begin(out, "Material", id, name, "        ")?;
    writeln!(out, "            token outputs:surface.connect = </Scene/{LOOKS}/{id}/surface.outputs:surface>")?;
    writeln!(out, "            def Shader \"surface\"\n            {{")?;
    writeln!(out, "                uniform token info:id = \"UsdPreviewSurface\"")?;
    if let Some([r, g, b, opacity]) = colour {
        writeln!(out, "                color3f inputs:diffuseColor = ({r}, {g}, {b})")?;
        writeln!(out, "                float inputs:opacity = {opacity}")?;
    }
    writeln!(out, "                token outputs:surface\n            }}\n        }}")
}

fn write_fibres(out: &mut dyn Write, body: &BodySubject, id: &str) -> io::Result<()> {
    begin(out, "BasisCurves", id, &format!("{} fibres", body.name), "    ")?;
    writeln!(out, "        uniform token type = \"linear\"\n        uniform token wrap = \"nonperiodic\"")?;
    write!(out, "        int[] curveVertexCounts = ")?;
    write_list(out, body.fibres.iter().map(|fibre| fibre.vertices))?;
    write!(out, "\n        point3f[] points\n        float[] widths = ")?;
    write_list(out, body.fibres.iter().map(|fibre| fibre.width as f32))?;
    write!(out, " (\n            interpolation = \"uniform\"\n        )\n        string[] primvars:fibre = ")?;
    write_list(out, body.fibres.iter().map(|fibre| quoted(&fibre.id)))?;
    writeln!(out, " (\n            interpolation = \"uniform\"\n        )")?;
    writeln!(out, "        float[] primvars:tension (\n            interpolation = \"vertex\"\n        )\n    }}")
}

fn write_springs(out: &mut dyn Write, body: &BodySubject, id: &str) -> io::Result<()> {
    begin(out, "BasisCurves", id, &format!("{} springs", body.name), "    ")?;
    writeln!(out, "        uniform token type = \"linear\"\n        uniform token wrap = \"nonperiodic\"")?;
    write!(out, "        int[] curveVertexCounts = ")?;
    write_list(out, body.springs.iter().map(|ends| ends.len()))?;
    writeln!(out, "\n        point3f[] points")?;
    writeln!(
        out,
        "        float[] widths = [{}] (\n            interpolation = \"constant\"\n        )",
        spring_width(body)
    )?;
    writeln!(out, "    }}")
}

fn spring_width(body: &BodySubject) -> f32 {
    let [min, max] = extent(&body.mesh.points);
    (SPRING_WIDTH * (max - min).length()) as f32
}
