//! STL as programs write it, and as it is damaged.

use crate::cases::Right::{Noted, Refused, Volume};
use crate::cases::{CORNERS, Folder, encodings, triangles};
use std::fmt::Write;

fn facets(triangles: &[[u32; 3]], normal: &str) -> String {
    let mut text = String::new();
    for triangle in triangles {
        writeln!(text, " facet{normal}\n  outer loop").expect("written");
        for [x, y, z] in triangle.map(|corner| CORNERS[corner as usize]) {
            writeln!(text, "   vertex {x} {y} {z}").expect("written");
        }
        text += "  endloop\n endfacet\n";
    }
    text
}

fn cube() -> String {
    format!("solid a\n{}endsolid a\n", facets(&triangles(), " normal 0 0 0"))
}

/// A binary cube whose header begins in a way and announces a number of facets.
fn binary(header: &[u8], announced: u32) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(announced.to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0; 12]);
        let corners = triangle.map(|corner| CORNERS[corner as usize]);
        bytes.extend(corners.iter().flatten().flat_map(|c| (*c as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn text_comes_in_any_encoding_with_any_line_end() {
    let folder = Folder::new();
    for text in [cube(), format!("\n \n{}", cube()), format!("  {}", cube()), cube().to_uppercase()] {
        for (encoding, bytes) in encodings(&text) {
            folder.check(&encoding, "a.stl", &bytes, &Volume(8.0));
        }
    }
    let latin1: Vec<u8> = cube().replace("solid a", "solid W\u{fc}rfel").chars().map(|c| c as u8).collect();
    folder.check("latin-1", "a.stl", &latin1, &Volume(8.0));
}

#[test]
fn every_solid_of_a_text_is_read() {
    let folder = Folder::new();
    let shifted = cube().replace("vertex ", "vertex 1");
    folder.check("two", "a.stl", format!("{}{shifted}", cube()).as_bytes(), &Volume(16.0));
    folder.check(
        "two, the second without a name",
        "a.stl",
        format!("{}\nsolid\n{}", cube(), &shifted[8..]).as_bytes(),
        &Volume(16.0),
    );
    assert_eq!(folder.model("a.stl").parts.len(), 2);
    // Neither of two halves is closed on its own.
    let all = triangles();
    let halves = [("left half", &all[..5]), ("right", &all[5..])]
        .map(|(name, half)| format!("solid {name}\n{}endsolid {name}\n", facets(half, " normal 0 0 1")));
    folder.check("halves", "a.stl", halves.concat().as_bytes(), &Volume(8.0));
    assert_eq!(folder.model("a.stl").parts[0].name, "left half");
    folder.check("an empty one between", "a.stl", format!("{}solid b\nendsolid b\n", cube()).as_bytes(), &Volume(8.0));
}

#[test]
fn texts_of_all_kinds_of_programs_are_read() {
    let folder = Folder::new();
    let with = |normal: &str| format!("solid a\n{}endsolid a\n", facets(&triangles(), normal));
    let cases = [
        ("no name", cube().replace("solid a", "solid")),
        ("a name like a keyword", cube().replace("solid a", "solid endfacet vertex 1")),
        ("normals that are no numbers", with(" normal nan nan nan")),
        ("normals as one runtime prints them", with(" normal -nan(ind) -nan(ind) -nan(ind)")),
        ("normals as another does", with(" normal 1.#QNAN 0 0")),
        ("normals that are infinite", with(" normal inf 0 0")),
        ("no normals", with("")),
        ("a normal on a line of its own", with("\n normal 0 0 1")),
        ("words apart", cube().replace("endloop", "end loop").replace("endfacet", "end facet")),
        ("tabs", cube().replace(' ', "\t")),
        ("a facet a line", cube().replace("\n  ", " ").replace("\n endfacet", " endfacet")),
        ("all in one line", cube().replace('\n', " ")),
        ("blank lines", cube().replace('\n', "\n\n")),
        ("points without digits", cube().replace("2 ", "2. ").replace(" 0 ", " .0 ")),
        ("exponents", cube().replace(" 2 ", " +2.000000e+000 ")),
        ("no header", facets(&triangles(), " normal 0 0 1") + "endsolid\n"),
        ("colours", cube().replace(" facet", " color 1 0 0\n facet")),
    ];
    for (case, text) in cases {
        folder.check(case, "a.stl", text.as_bytes(), &Volume(8.0));
    }
    let open = cube().replace("endsolid a\n", "");
    folder.check("no end", "a.stl", open.as_bytes(), &Noted(8.0, &["endsolid", "cut off"]));
}

#[test]
fn binary_files_are_told_by_their_bytes() {
    let folder = Folder::new();
    for header in
        [b"".as_slice(), b"solid exported", b"solid", b"  SOLID x", b"facet", b"COLOR=\xff\0\0\xff", b"\xef\xbb\xbfx"]
    {
        let case = String::from_utf8_lossy(header);
        let bytes = binary(header, 12);
        folder.check(&case, "a.stl", &bytes, &Volume(8.0));
        for tail in
            [b"\n".as_slice(), b"\0", b"extra bytes that a program has appended, more than a facet has, many more"]
        {
            folder.check(&case, "a.stl", &[&bytes, tail].concat(), &Volume(8.0));
        }
        for count in [0, u32::MAX] {
            folder.check(&case, "a.stl", &binary(header, count), &Noted(8.0, &["the 12 that are there are read"]));
        }
    }
}

#[test]
fn a_refusal_names_the_line_or_what_is_missing() {
    let folder = Folder::new();
    let broken = |from: &str, to: &str| cube().replacen(from, to, 1);
    let cases = [
        (
            "a comma",
            broken("vertex 0 2 0", "vertex 0,0 2,0 0,0"),
            Refused(&["line 4", "`vertex 0,0 2,0 0,0`", "commas"]),
        ),
        ("a word", broken("vertex 0 2 0", "vertex 0 2 o"), Refused(&["line 4", "three numbers"])),
        ("no place", broken("vertex 0 2 0", "vertex 0 nan 0"), Refused(&["line 4", "no place"])),
        ("two corners", broken("   vertex 0 2 0\n", ""), Refused(&["line 7", "2 corners"])),
        (
            "four corners",
            broken("   vertex 0 2 0\n", "vertex 0 0 0\nvertex 1 0 0\n"),
            Refused(&["line 9", "4 corners"]),
        ),
        ("no end of a facet", broken(" endfacet\n", ""), Refused(&["line 8", "`facet"])),
        ("another word", broken(" facet", " face"), Refused(&["line 2", "out of place"])),
        ("cut in a facet", cube()[..cube().len() - 60].to_owned(), Refused(&["cut off within a facet"])),
    ];
    for (case, text, right) in cases {
        folder.check(case, "a.stl", text.as_bytes(), &right);
    }
    let sound = binary(b"solid", 12);
    folder.check("cut", "a.stl", &sound[..659], &Refused(&["12 facets", "11 are there", "25 bytes are missing"]));
    folder.check("cut by one", "a.stl", &sound[..683], &Refused(&["1 byte is missing"]));
    folder.check("too many announced", "a.stl", &binary(b"", 20), &Refused(&["20 facets", "400 bytes are missing"]));
    folder.check("short", "a.stl", b"short", &Refused(&["5 bytes"]));
    let mut lost = sound.clone();
    lost[84 + 2 * 50 + 12 + 24..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
    folder.check("no place", "a.stl", &lost, &Refused(&["facet 3 of 12", "corner 3", "NaN"]));
}
