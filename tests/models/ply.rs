//! PLY as programs write it, and as it is damaged.

use crate::cases::Right::{Refused, Volume};
use crate::cases::{CORNERS, Folder, QUADS, encodings, triangles};
use glam::{DVec3, Vec3};
use std::fmt::Write;

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";
const LIST: &str = "property list uchar int vertex_indices\n";

fn header(format: &str, vertex: &str, faces: usize, face: &str) -> String {
    format!("ply\nformat {format} 1.0\nelement vertex 8\n{vertex}element face {faces}\n{face}end_header\n")
}

fn vertices(behind: &str) -> String {
    CORNERS.iter().fold(String::new(), |text, [x, y, z]| format!("{text}{x} {y} {z}{behind}\n"))
}

fn faces(before: &str, behind: &str) -> String {
    triangles().iter().fold(String::new(), |text, [a, b, c]| format!("{text}{before}3 {a} {b} {c}{behind}\n"))
}

fn cube() -> String {
    header("ascii", XYZ, 12, LIST) + &vertices("") + &faces("", "")
}

#[test]
fn text_comes_in_any_encoding_with_any_line_end() {
    let folder = Folder::new();
    let commented = cube().replacen('\n', "\ncomment Grüße\nobj_info num_cols 512\n", 1);
    for text in [cube(), commented, cube().replace("\n3 3", "\n\n \n3 3") + "\n\n"] {
        for (encoding, bytes) in encodings(&text) {
            folder.check(&encoding, "a.ply", &bytes, &Volume(8.0));
        }
    }
    let latin1: Vec<u8> = cube().replacen('\n', "\ncomment Gr\u{fc}\u{df}e\n", 1).chars().map(|c| c as u8).collect();
    folder.check("latin-1", "a.ply", &latin1, &Volume(8.0));
}

#[test]
fn texts_of_all_kinds_of_programs_are_read() {
    let folder = Folder::new();
    let strips = triangles().iter().map(|[a, b, c]| format!("{a} {b} {c} -1 ")).collect::<Vec<_>>().concat();
    let strip_header =
        header("ascii", XYZ, 1, "property list int int vertex_indices\n").replace("face 1", "tristrips 1");
    let quads = QUADS.map(|[a, b, c, d]| format!("4 {a} {b} {c} {d}\n")).concat();
    let with = |vertex: &str, face: &str, body: String| header("ascii", vertex, 12, face) + &body;
    let extra = |name: &str| format!("{XYZ}property float {name}\n");
    let cases = [
        ("points without digits", cube().replace("2 2 2\n", "2. 2. .2e1\n")),
        ("no numbers aside", with(&extra("quality"), LIST, vertices(" nan") + &faces("", ""))),
        (
            "no numbers in normals",
            with(
                &format!("{}property float ny\nproperty float nz\n", extra("nx")),
                LIST,
                vertices(" nan -nan(ind) 1.#IND") + &faces("", ""),
            ),
        ),
        ("a name with signs", with(&extra("scalar_Coord._Z-(x)"), LIST, vertices(" 1") + &faces("", ""))),
        ("a name that is not UTF-8", with(&extra("h\u{f6}he"), LIST, vertices(" 1") + &faces("", ""))),
        (
            "a list aside",
            with(&format!("{XYZ}property list uchar float weights\n"), LIST, vertices(" 2 1 1") + &faces("", "")),
        ),
        (
            "indices as numbers with points",
            with(XYZ, "property list float float vertex_indices\n", vertices("") + &faces("", "").replace(' ', ".0 ")),
        ),
        ("another name of indices", cube().replace("vertex_indices", "vertex_index")),
        (
            "something before the list",
            with(XYZ, &format!("property uchar intensity\n{LIST}"), vertices("") + &faces("7 ", "")),
        ),
        (
            "something behind the list",
            with(
                XYZ,
                &format!("{LIST}property list uchar float texcoord\n"),
                vertices("") + &faces("", " 6 0 0 1 0 1 1"),
            ),
        ),
        ("quads", header("ascii", XYZ, 6, LIST) + &vertices("") + &quads),
        ("strips", strip_header.clone() + &vertices("") + "48 " + &strips + "\n"),
        ("a strip over lines", strip_header + &vertices("") + "48 " + &strips.replace("-1 ", "-1\n")),
        (
            "edges",
            cube().replace("end_header", "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header")
                + "0 1\n1 2\n",
        ),
        (
            "points in another order",
            with(
                "property float z\nproperty float x\nproperty float y\n",
                LIST,
                CORNERS.iter().fold(String::new(), |text, [x, y, z]| format!("{text}{z} {x} {y}\n")) + &faces("", ""),
            ),
        ),
        (
            "faces first",
            format!("ply\nformat ascii 1.0\nelement face 12\n{LIST}element vertex 8\n{XYZ}end_header\n")
                + &faces("", "")
                + &vertices(""),
        ),
        (
            "a vertex at no place that no face uses",
            cube().replace("vertex 8", "vertex 9").replace("\n3 3 2 1", "\nnan 0 0\n3 3 2 1"),
        ),
    ];
    for (case, text) in cases {
        folder.check(case, "a.ply", text.as_bytes(), &Volume(8.0));
    }
}

#[test]
fn every_type_of_value_is_read_in_every_format() {
    type Written = fn(f64) -> Vec<u8>;
    let folder = Folder::new();
    let types: [(&str, Written); 12] = [
        ("char", |v| vec![v as i8 as u8]),
        ("uchar", |v| vec![v as u8]),
        ("short", |v| (v as i16).to_be_bytes().into()),
        ("ushort", |v| (v as u16).to_be_bytes().into()),
        ("int", |v| (v as i32).to_be_bytes().into()),
        ("uint", |v| (v as u32).to_be_bytes().into()),
        ("float", |v| (v as f32).to_be_bytes().into()),
        ("double", |v| v.to_be_bytes().into()),
        ("int8", |v| vec![v as i8 as u8]),
        ("uint16", |v| (v as u16).to_be_bytes().into()),
        ("float32", |v| (v as f32).to_be_bytes().into()),
        ("float64", |v| v.to_be_bytes().into()),
    ];
    for (name, big) in types {
        for (count_name, big_count) in types {
            let vertex = XYZ.replace("float", name);
            let face = format!("property list {count_name} {name} vertex_indices\n");
            let text = header("ascii", &vertex, 12, &face) + &vertices("") + &faces("", "");
            folder.check(name, "a.ply", text.as_bytes(), &Volume(8.0));
            let values = CORNERS.iter().flatten().map(|&c| (c, big));
            let lists = triangles()
                .into_iter()
                .flat_map(|t| std::iter::once((3.0, big_count)).chain(t.map(|i| (f64::from(i), big))));
            let values: Vec<_> = values.chain(lists).collect();
            for (format, little) in [("binary_big_endian", false), ("binary_little_endian", true)] {
                let mut bytes = header(format, &vertex, 12, &face).into_bytes();
                for (value, big) in &values {
                    let mut value = big(*value);
                    if little {
                        value.reverse();
                    }
                    bytes.extend(value);
                }
                folder.check(&format!("{name}, {count_name}, {format}"), "a.ply", &bytes, &Volume(8.0));
            }
        }
    }
}

#[test]
fn coordinates_are_exact() {
    let folder = Folder::new();
    for (kind, far) in [("int", 100_000_001.0), ("uint", 4_294_967_295.0), ("double", 100_000_000.1)] {
        let mut text = header("ascii", &XYZ.replace("float", kind), 12, LIST);
        for [x, y, z] in CORNERS {
            writeln!(text, "{} {y} {z}", far - x).expect("written");
        }
        folder.put("a.ply", (text + &faces("", "")).as_bytes());
        let model = folder.model("a.ply");
        let exact = CORNERS.map(|[x, y, z]| DVec3::new(far - x, y, z));
        assert_eq!(model.positions, exact, "{kind}");
    }
}

#[test]
fn colours_and_normals_come_along() {
    let folder = Folder::new();
    for (kind, full) in [("uchar", "255"), ("float", "1.0"), ("double", "1"), ("ushort", "65535")] {
        let extra = format!(
            "{XYZ}property float nx\nproperty float ny\nproperty float nz\n\
             property {kind} red\nproperty {kind} green\nproperty {kind} blue\nproperty {kind} alpha\n"
        );
        let text = header("ascii", &extra, 12, LIST) + &vertices(&format!(" 0 0 2 {full} 0 0 {full}")) + &faces("", "");
        folder.check(kind, "a.ply", text.as_bytes(), &Volume(8.0));
        let model = folder.model("a.ply");
        assert!(model.colours.iter().all(|colour| *colour == [1.0, 0.0, 0.0, 1.0]), "{kind}: {:?}", model.colours);
        assert!(model.normals.iter().all(|normal| *normal == Vec3::Z));
    }
}

#[test]
fn a_refusal_names_the_line_the_property_or_what_is_missing() {
    let folder = Folder::new();
    let broken = |from: &str, to: &str| cube().replacen(from, to, 1);
    let cases = [
        ("no magic", cube()[4..].to_owned(), Refused(&["first line"])),
        ("another format", broken("ascii", "utf8"), Refused(&["line 2", "`format utf8 1.0`"])),
        ("another type", broken("float x", "half x"), Refused(&["line 4", "`half`"])),
        ("no name", broken("float x", "float"), Refused(&["line 4", "no name"])),
        ("twice", broken("float y", "float x"), Refused(&["line 5", "twice"])),
        ("no count", broken("vertex 8", "vertex"), Refused(&["line 3", "a count"])),
        ("no element", broken("element vertex 8\n", ""), Refused(&["line 3", "element"])),
        ("another line", broken("end_header", "end"), Refused(&["line 9", "`end`"])),
        ("no end", cube().split("end_header").next().unwrap().to_owned(), Refused(&["end_header"])),
        ("no x", broken("float x", "float u"), Refused(&["no property `x`"])),
        ("a list for x", broken("float x", "list uchar float x"), Refused(&["`x` of vertex 1 of 8"])),
        ("too many", broken("vertex 8", "vertex 800000"), Refused(&["announces more than the file holds"])),
        ("a word", broken("2 2 2\n", "2 two 2\n"), Refused(&["line 16", "`two`", "`y` of vertex 7 of 8"])),
        ("a comma", broken("2 2 2\n", "2,0 2 2\n"), Refused(&["line 16", "`2,0`", "`x` of vertex 7 of 8"])),
        ("a value too many", broken("2 2 2\n", "2 2 2 2\n"), Refused(&["line 16", "1 values", "vertex 7 of 8"])),
        (
            "all in one line",
            cube().replace('\n', " ").replacen("end_header ", "end_header\n", 1),
            Refused(&["first line"]),
        ),
        (
            "half an index",
            broken("\n3 3 2 1", "\n3 3 2 0.5"),
            Refused(&["line 18", "0.5", "`vertex_indices` of face 1 of 12"]),
        ),
        ("no number of a vertex", broken("\n3 3 2 1", "\n3 3 2 nan"), Refused(&["line 18", "`vertex_indices`"])),
        ("less than no corners", broken("\n3 3 2 1", "\n-3 3 2 1"), Refused(&["line 18", "-3"])),
        ("more corners than the file has", broken("\n3 3 2 1", "\n200 3 2 1"), Refused(&["cut off", "face 1 of 12"])),
        ("no such vertex", broken("\n3 3 2 1", "\n3 3 2 99"), Refused(&["face 1", "vertex 99", "1 of 12 faces"])),
        ("a vertex below none", broken("\n3 3 2 1", "\n3 3 2 -1"), Refused(&["face 1", "vertex -1"])),
        ("no place", broken("2 2 2\n", "2 nan 2\n"), Refused(&["face 3", "vertex 6", "NaN", "5 of 12 faces"])),
        ("cut", cube()[..cube().len() - 30].to_owned(), Refused(&["cut off", "face 9 of 12", "4 of 12 are missing"])),
    ];
    for (case, text, right) in cases {
        folder.check(case, "a.ply", text.as_bytes(), &right);
    }
    let mut binary = header("binary_little_endian", XYZ, 12, LIST).into_bytes();
    binary.extend(CORNERS.iter().flatten().flat_map(|c| (*c as f32).to_le_bytes()));
    binary.extend([3, 0, 0, 0, 0]);
    folder.check("cut bytes", "a.ply", &binary, &Refused(&["cut off", "face 1 of 12", "12 of 12 are missing"]));
}
