//! OBJ and MTL as programs write them, and as they are damaged.

use crate::cases::Right::{Noted, Refused, Volume};
use crate::cases::{CORNERS, Folder, QUADS, Right, encodings};
use std::fmt::Write;

/// A cube of 8 m³.
fn cube() -> String {
    let mut text = String::new();
    for [x, y, z] in CORNERS {
        writeln!(text, "v {x} {y} {z}").expect("written");
    }
    for [a, b, c, d] in QUADS.map(|quad| quad.map(|i| i + 1)) {
        writeln!(text, "f {a} {b} {c} {d}").expect("written");
    }
    text
}

/// The cube with every line behind its first word changed.
fn changed(keyword: &str, change: impl Fn(usize, &str) -> String) -> String {
    let mut count = 0;
    let change = |line: &str| {
        let Some(values) = line.strip_prefix(keyword).and_then(|rest| rest.strip_prefix(' ')) else {
            return line.to_owned();
        };
        count += 1;
        change(count - 1, values)
    };
    cube().lines().map(change).collect::<Vec<_>>().join("\n") + "\n"
}

/// The cube with one line replaced, from 1.
fn with_line(number: usize, line: &str) -> String {
    let text = cube();
    let replaced = |(index, old)| if index + 1 == number { line } else { old };
    text.lines().enumerate().map(replaced).collect::<Vec<_>>().join("\n") + "\n"
}

#[test]
fn text_comes_in_any_encoding_with_any_line_end() {
    let folder = Folder::new();
    for text in [cube(), format!("\n\n# Grüße\no Würfel\n{}", cube())] {
        for (encoding, bytes) in encodings(&text) {
            folder.check(&encoding, "a.obj", &bytes, &Volume(8.0));
        }
    }
    // A mark before the first vertex neither hides it nor shifts the others.
    let shifted = format!("\u{feff}{}v 2 2 3\n", cube());
    folder.check("mark", "a.obj", shifted.as_bytes(), &Volume(8.0));
    let latin1 = [b"# Gr\xfc\xdfe\no W\xfcrfel\nmtllib W\xfcrfel.mtl\n".as_slice(), cube().as_bytes()].concat();
    folder.check("latin-1", "a.obj", &latin1, &Volume(8.0));
}

#[test]
fn what_the_format_allows_is_read() {
    let folder = Folder::new();
    let back = |_: usize, values: &str| {
        let indices = values.split(' ').map(|index| index.parse::<i32>().expect("an index") - 9);
        format!("f {}", indices.map(|index| index.to_string()).collect::<Vec<_>>().join(" "))
    };
    let mut interleaved = String::new();
    for quad in QUADS {
        for [x, y, z] in quad.map(|corner| CORNERS[corner as usize]) {
            writeln!(interleaved, "v {x} {y} {z}").expect("written");
        }
        interleaved += "vn 0 0 1\nf -4//-1 -3//-1 -2//-1 -1//-1\n";
    }
    let mut faces_first: Vec<String> = cube().lines().map(str::to_owned).collect();
    faces_first.rotate_left(8);
    let cases = [
        ("comment behind a vertex", changed("v", |_, v| format!("v {v} # a vertex"))),
        ("comment behind a face", changed("f", |_, f| format!("f {f} # a face"))),
        ("comment that touches a number", changed("f", |_, f| format!("f {f}#face"))),
        ("comment that touches a coordinate", changed("v", |_, v| format!("v {v}#vertex"))),
        ("a continued face", changed("f", |_, f| format!("f {}", f.replacen(' ', " \\\n ", 2)))),
        ("a continued vertex", changed("v", |_, v| format!("v \\\n{}", v.replacen(' ', " \\\n", 1)))),
        ("a comment that goes on", format!("# a \\\nv 9 9 9\n{}", cube())),
        ("tabs and spaces", changed("v", |_, v| format!("\t v\t{}  ", v.replace(' ', "\t")))),
        ("points without digits", changed("v", |_, v| format!("v {}", v.replace('2', "2.").replace('0', ".0")))),
        ("fortran's exponents", changed("v", |_, v| format!("v {}", v.replace('2', "0.2D+01")))),
        ("weights", changed("v", |_, v| format!("v {} 0.5", v.replace('2', "1")))),
        ("colours", changed("v", |_, v| format!("v {v} 1 0.5 0.5"))),
        ("colours with opacity", changed("v", |_, v| format!("v {v} 1 0.5 0.5 1"))),
        ("some colours", changed("v", |k, v| if k == 3 { format!("v {v} 1 0 0") } else { format!("v {v}") })),
        ("a colour that is none", changed("v", |_, v| format!("v {v} nan 0 0"))),
        ("indices that count back", changed("f", back)),
        ("indices that count back through a file", interleaved),
        ("faces before vertices", faces_first.join("\n")),
        ("the first versions' faces", changed("f", |_, f| format!("fo {f}"))),
        ("texture coordinates of one number", format!("vt 0.5\n{}", changed("f", |_, corners| f(corners, "/1")))),
        ("no such texture coordinates", changed("f", |_, corners| f(corners, "/9"))),
        ("no such normals", changed("f", |_, corners| f(corners, "//9"))),
        ("a normal of two numbers", format!("vn 0 0\n{}", changed("f", |_, corners| f(corners, "//1")))),
        ("materials without a name", format!("usemtl\nusemtl \n{}", cube())),
        ("materials that are not there", format!("mtllib none.mtl\nusemtl stone\n{}", cube())),
        ("a folder for a library", format!("mtllib .\n{}", cube())),
        ("groups and objects", cube().replace("f 5", "g top\nf 5").replace("f 3", "o \nusemtl x#1\nf 3")),
        ("a closed polyline", format!("{}v 5 5 5\nl 1 7 9 2\nl 1 2 7 1\n", cube())),
        ("axes", format!("{}v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nl 9 10 11 12\n", cube())),
        ("points", format!("{}p 1 2 3 4\n", cube())),
        ("curves", format!("{}vp 0.1 0.2\ncstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n", cube())),
        ("a vertex at no place that no face uses", format!("v nan nan nan\n{}", changed("f", |_, f| more(f, 1)))),
        ("an infinite one", format!("v inf 0 0\n{}", changed("f", |_, f| more(f, 1)))),
    ];
    for (case, text) in cases {
        folder.check(case, "a.obj", text.as_bytes(), &Volume(8.0));
    }
}

/// Corners with something behind each.
fn f(faces: &str, behind: &str) -> String {
    let corners = faces.split(' ').map(|corner| format!("{corner}{behind}"));
    format!("f {}", corners.collect::<Vec<_>>().join(" "))
}

/// Corners with greater indices.
fn more(faces: &str, by: u32) -> String {
    let corners = faces.split(' ').map(|corner| (corner.parse::<u32>().expect("an index") + by).to_string());
    format!("f {}", corners.collect::<Vec<_>>().join(" "))
}

#[test]
fn a_refusal_names_the_line_and_its_text() {
    let folder = Folder::new();
    let cases: [(&str, String, Right); 12] = [
        ("a comma", with_line(7, "v 2,0 2,0 2,0"), Refused(&["line 7", "`v 2,0 2,0 2,0`", "points and not commas"])),
        ("a word", with_line(7, "v 2 two 2"), Refused(&["line 7", "`two` is not a number"])),
        ("two coordinates", with_line(7, "v 2 2"), Refused(&["line 7", "three coordinates"])),
        ("no weight", with_line(7, "v 2 2 2 0"), Refused(&["line 7", "weight"])),
        ("no place", with_line(7, "v nan nan -nan(ind)"), Refused(&["line 10", "vertex 7", "line 7", "no place"])),
        ("C's no number", with_line(7, "v 1.#IND 2 2"), Refused(&["line 10", "vertex 7", "line 7"])),
        ("infinite", with_line(7, "v 2 -inf 2"), Refused(&["line 10", "vertex 7", "line 7"])),
        ("a corner that is none", with_line(9, "f 1 2 x"), Refused(&["line 9", "`f 1 2 x`", "`x`"])),
        ("too many slashes", with_line(9, "f 1/1/1/1 2 3"), Refused(&["line 9", "`1/1/1/1`"])),
        ("corner 0", with_line(9, "f 0 1 2"), Refused(&["line 9", "from 1"])),
        ("no such vertex", with_line(9, "f 1 2 99"), Refused(&["line 9", "vertex 99", "8 are there"])),
        ("none so far back", with_line(9, "f 1 2 -9"), Refused(&["line 9", "vertex -9"])),
    ];
    let edges = format!("{}f 1 2\nf 3\n", cube());
    folder.check("edges", "a.obj", edges.as_bytes(), &Noted(8.0, &["2 faces have fewer than three", "line 15"]));
    for (case, text, right) in cases {
        folder.check(case, "a.obj", text.as_bytes(), &right);
        // Lines are counted whatever ends them.
        folder.check(case, "a.obj", text.replace('\n', "\r\n").as_bytes(), &right);
        folder.check(case, "a.obj", text.replace('\n', "\r").as_bytes(), &right);
    }
    // Nothing in a file without faces is wrong, but that it has none.
    folder.put("a.obj", b"");
    assert!(folder.model("a.obj").triangles.is_empty());
}

#[test]
fn colours_come_from_materials_or_are_said_to_be_missing() {
    let folder = Folder::new();
    let with = |library: &str| format!("mtllib {library}\nusemtl x\n{}", cube());
    folder.put("a.mtl", b"newmtl x\r\n\tKd 1 0 0 # red\r\nNs abc\r\nmap_Kd\r\n");
    folder.put("two words.mtl", b"\xef\xbb\xbfnewmtl x\nKd 1 0 0\n");
    folder.put("other.mtl", b"newmtl y\nKd 0 0 1\n");
    folder.put("late.mtl", b"Kd 0 1 0\nnewmtl x");
    let names =
        ["a.mtl", "two words.mtl", "other.mtl a.mtl", "C:\\Users\\me\\a.mtl", "/home/me/a.mtl", "none.mtl a.mtl"];
    for name in names {
        folder.check(name, "a.obj", with(name).as_bytes(), &Volume(8.0));
        let colours = folder.model("a.obj").colours;
        assert!(!colours.is_empty() && colours.iter().all(|colour| *colour == [1.0, 0.0, 0.0, 1.0]), "{name}");
    }
    folder.check("no colour", "a.obj", with("late.mtl").as_bytes(), &Volume(8.0));
    assert!(folder.model("a.obj").colours.is_empty());
    let broken =
        [("Kd 0.5", "`Kd 0.5`"), ("Kd spectral file.rfl 1", "`Kd spectral file.rfl 1`"), ("Kd a b c", "`Kd a b c`")];
    for (line, shown) in broken {
        folder.put("bad.mtl", format!("newmtl x\n{line}\nNs abc\n").as_bytes());
        folder.check(
            line,
            "a.obj",
            with("bad.mtl").as_bytes(),
            &Noted(8.0, &["bad.mtl, line 2", "without its colour"]),
        );
        assert!(folder.model("a.obj").notes[0].text.contains(shown));
    }
    // A vertex without a colour of its own takes that of its material, or white.
    let some = changed("v", |k, v| if k == 0 { format!("v {v} 0 0 1") } else { format!("v {v}") });
    folder.check("mixed", "a.obj", format!("mtllib a.mtl\nusemtl x\n{some}").as_bytes(), &Volume(8.0));
    let model = folder.model("a.obj");
    let first = model.positions.iter().position(|p| p.length() == 0.0).unwrap();
    assert_eq!(model.colours[first], [0.0, 0.0, 1.0, 1.0]);
    assert!(model.colours.iter().filter(|colour| **colour == [1.0, 0.0, 0.0, 1.0]).count() == 7);
}
