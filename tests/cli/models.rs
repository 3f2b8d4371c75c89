//! What `sinew check` says of files of models.

use super::{Desk, pressed};
use std::fs;

const CUBE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nusemtl x\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

#[test]
fn what_a_reader_leaves_out_is_a_note_and_what_it_cannot_read_one_line() {
    let desk = Desk::new(&pressed());
    fs::write(desk.path("bad.mtl"), "newmtl x\nKd 0.5\n").unwrap();
    fs::write(desk.path("a.obj"), format!("mtllib bad.mtl\n{CUBE}")).unwrap();
    let said = desk.run("check a.obj --particles 60");
    assert_eq!(said.code, Some(0));
    assert!(said.out.contains("volume [m³]: 8.000"), "{}", said.out);
    let words =
        "note: bad.mtl, line 2: `Kd 0.5` is not red, green and blue: material `x` is shown without its colour\n";
    assert!(said.err.contains(words), "{}", said.err);

    fs::write(desk.path("b.obj"), CUBE.replace("v 2 2 2", "v 2,0 2,0 2,0")).unwrap();
    let said = desk.run("check b.obj");
    assert_eq!(said.code, Some(2));
    assert!(said.err.starts_with("error: ") && said.err.lines().count() == 1, "{}", said.err);
    assert!(said.err.contains("b.obj: ") && said.err.contains("(line 7, `v 2,0 2,0 2,0`: "), "{}", said.err);
}
