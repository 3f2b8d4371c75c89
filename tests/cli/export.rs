//! Motion for other programs: on the vertices of the imported file, in its order, whatever becomes of the run.

use super::{Desk, names, pressed, program};
use serde_json::{Value, json};
use sinew::geometry::FileMesh;
use sinew::io::load_model;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// A prism of six sides in millimetres, Z up: a vertex that nothing uses first, caps of six corners, sides of four each
/// with texture coordinates of its own, two objects, a material.
pub(super) const PRISM: &str = "mtllib prism.mtl\no sides\nv 3 3 3\n\
    v 30 0 0\nv 15 26 0\nv -15 26 0\nv -30 0 0\nv -15 -26 0\nv 15 -26 0\n\
    v 30 0 40\nv 15 26 40\nv -15 26 40\nv -30 0 40\nv -15 -26 40\nv 15 -26 40\n\
    vt 0 0\nvt 0.25 0\nvt 0.25 0.5\nvt 0 0.5\nvt 1 1\n\
    usemtl red paint\n\
    f 2/1 3/2 9/3 8/4\nf 3/1 4/2 10/3 9/4\nf 4/1 5/2 11/3 10/4\n\
    f 5/1 6/2 12/3 11/4\nf 6/1 7/2 13/3 12/4\nf 7/1 2/2 8/3 13/4\n\
    o caps\nusemtl none\nf 7 6 5 4 3 2\nf 8/5 9/1 10/2 11/3 12/4 13/5\n";

/// The prism, its axis Y once it stands, turned and moved, in free fall; and a ring of springs.
pub(super) fn falling() -> Value {
    json!({
        "version": 1,
        "name": "Falling prism",
        "time": {"duration": 0.2, "frames_per_second": 50},
        "bodies": [{
            "id": "prism",
            "name": "Red prism 1",
            "shape": {"mesh": {"path": "prism.obj", "scale": 0.001, "up": "z", "particles": 200}},
            "placement": {"translation": [0.1, 0.5, -0.2], "rotation": {"axis": [0, 1, 0], "degrees": 90}},
            "material": {"young_modulus": 1e4, "mass": {"density": 1000}, "support_radius": 0.01, "damping": {"pair": 0, "air": 0}},
            "fibres": [{"id": "axis", "stiffness": {"rigidity": {"ea": 1, "ei": 1e-6}},
                "source": {"vertices": [[0, 0.01, 0], [0, 0.02, 0], [0, 0.03, 0]]}}]
        }],
        "two_layer": [{"id": "ring", "name": "red Prism 1", "placement": {"translation": [1, 1, 1]},
            "shape": {"ring": {"sides": 8, "outer_radius": 0.1, "inner_radius": 0.05}}}]
    })
}

pub(super) fn desk() -> Desk {
    let desk = Desk::new(&falling());
    fs::write(desk.path("prism.obj"), PRISM).unwrap();
    fs::write(desk.path("prism.mtl"), "newmtl red paint\nKd 1 0 0\n").unwrap();
    desk
}

/// Vertices of an OBJ file, and its other lines by their first word.
pub(super) fn obj(text: &str) -> (Vec<[f64; 3]>, BTreeMap<&str, Vec<&str>>) {
    let (mut vertices, mut rest): (_, BTreeMap<&str, Vec<&str>>) = (Vec::new(), BTreeMap::new());
    for line in text.lines() {
        let (kind, values) = line.split_once(' ').unwrap();
        if kind == "v" {
            let numbers: Vec<f64> = values.split(' ').map(|word| word.parse().unwrap()).collect();
            vertices.push([numbers[0], numbers[1], numbers[2]]);
        } else {
            rest.entry(kind).or_default().push(values);
        }
    }
    (vertices, rest)
}

/// Points of every sample of a PC2 file: as many as it says there are. And the number of the first frame.
pub(super) fn pc2(bytes: &[u8]) -> (f32, Vec<Vec<[f64; 3]>>) {
    let word = |at: usize| <[u8; 4]>::try_from(&bytes[at..at + 4]).unwrap();
    assert_eq!((&bytes[..12], u32::from_le_bytes(word(12))), (&b"POINTCACHE2\0"[..], 1));
    let (points, samples) = (u32::from_le_bytes(word(16)) as usize, u32::from_le_bytes(word(28)) as usize);
    assert_eq!(f32::from_le_bytes(word(24)), 1.0);
    let number = |index: usize| f64::from(f32::from_le_bytes(word(32 + 4 * index)));
    let point = |index: usize| [0, 1, 2].map(|axis| number(3 * index + axis));
    let sample = |sample: usize| (0..points).map(|index| point(sample * points + index)).collect();
    (f32::from_le_bytes(word(20)), (0..samples).map(sample).collect())
}

/// Times and points of every sample of an MDD file, which must have no byte more.
pub(super) fn mdd(bytes: &[u8]) -> (Vec<f32>, Vec<Vec<[f64; 3]>>) {
    let words: Vec<[u8; 4]> = bytes.as_chunks::<4>().0.to_vec();
    let (samples, points) = (u32::from_be_bytes(words[0]) as usize, u32::from_be_bytes(words[1]) as usize);
    assert_eq!(bytes.len(), 4 * (2 + samples + 3 * samples * points));
    let times = words[2..2 + samples].iter().map(|word| f32::from_be_bytes(*word)).collect();
    let numbers: Vec<f64> = words[2 + samples..].iter().map(|word| f64::from(f32::from_be_bytes(*word))).collect();
    let all = numbers.as_chunks::<3>().0;
    (times, (0..samples).map(|sample| all[sample * points..(sample + 1) * points].to_vec()).collect())
}

pub(super) fn distance(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn motion_comes_back_on_the_files_own_vertices_in_every_format() {
    let desk = desk();
    let out = desk.run("simulate scene.json --format usd,pc2,mdd,gltf,obj,ply,csv --frames 2..5 --out out");
    assert_eq!(out.code, Some(0), "{out:?}");
    assert!(out.out.contains("PC2 cache of 4 frames") && out.out.contains("4 OBJ files written to out"), "{}", out.out);
    let files = names(&desk.path("out"));
    let sequence = |prefix: &str, end: &str| (2..6).map(move |k| format!("{prefix}_{k:06}.{end}")).collect::<Vec<_>>();
    let mut expected = [sequence("frame", "obj"), sequence("frame", "ply")].concat();
    expected.extend([sequence("particles", "csv"), sequence("particles", "ply")].concat());
    // Two names that differ by case alone are one file elsewhere.
    expected.extend(
        ["Red_prism_1", "red_Prism_1_2"]
            .iter()
            .flat_map(|name| [".mdd", ".pc2", "_rest.obj"].map(|end| format!("{name}{end}"))),
    );
    expected.extend(["motion.glb", "motion.usda", "motion_layers"].map(str::to_owned));
    expected.sort();
    assert_eq!(files, expected);

    // The rest shape: the file's vertices, all thirteen, where the body was put; its faces as they stand there.
    let (given, lines) = obj(PRISM);
    let text = desk.text("out/Red_prism_1_rest.obj");
    let (rest, rest_lines) = obj(&text);
    let put = |[x, y, z]: [f64; 3]| [0.1 - 1e-3 * y, 0.5 + 1e-3 * z, -0.2 - 1e-3 * x];
    assert!(distance(&rest, &given.iter().map(|&p| put(p)).collect::<Vec<_>>()) < 1e-12);
    assert_eq!((&rest_lines["f"], &rest_lines["vt"]), (&lines["f"], &lines["vt"]));
    assert_eq!((&rest_lines["g"], &rest_lines["usemtl"]), (&vec!["sides", "caps"], &vec!["red_paint", "none"]));

    let (first, points) = pc2(&fs::read(desk.path("out/Red_prism_1.pc2")).unwrap());
    let (times, same_points) = mdd(&fs::read(desk.path("out/Red_prism_1.mdd")).unwrap());
    assert_eq!((first, points.len(), same_points.len()), (2.0, 4, 4));
    for (k, (points, same)) in points.iter().zip(&same_points).enumerate() {
        let time = 0.02 * (k + 2) as f64;
        assert!((f64::from(times[k]) - time).abs() < 1e-6);
        let text = desk.text(&format!("out/frame_{:06}.obj", k + 2));
        let (vertices, lines) = obj(&text);
        assert_eq!((lines["f"].clone(), lines["o"][0]), (rest_lines["f"].clone(), "Red_prism_1"));
        assert_eq!((vertices.len(), lines["l"][0], lines["p"].len()), (13 + 3 + 16, "14 15 16", 1));
        assert!(distance(points, &vertices[..13]) < 1e-7 && points == same);
        // All of it falls freely, the vertex that no face uses too.
        let fallen: Vec<[f64; 3]> = rest.iter().map(|[x, y, z]| [*x, y - 0.5 * 9.81 * time * time, *z]).collect();
        assert!(distance(points, &fallen) < 2e-6, "{}", distance(points, &fallen));
    }

    let mut table = csv::Reader::from_path(desk.path("out/particles_000005.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = table.records().map(Result::unwrap).collect();
    let number = |row: &csv::StringRecord, column: usize| row[column].parse::<f64>().unwrap();
    let prism: Vec<_> = rows.iter().filter(|row| &row[0] == "Red prism 1").collect();
    assert_eq!(rows.len(), prism.len() + 16);
    assert!(prism.len() > 100 && prism.iter().all(|row| (number(row, 6) + 9.81 * 0.1).abs() < 1e-6));
    assert!(prism.iter().any(|row| number(row, 8) > 0.1 && number(row, 12).abs() > 0.999));
    let ring = &rows[rows.len() - 1];
    assert_eq!((&ring[0], &ring[8], &ring[10]), ("red Prism 1", "", ""));

    let stage = desk.text("out/motion.usda");
    for part in [
        "startTimeCode = 2\n",
        "endTimeCode = 5\n",
        "timeCodesPerSecond = 50\n",
        "upAxis = \"Y\"",
        "metersPerUnit = 1\n",
    ] {
        assert!(stage.contains(part), "{part}: {stage}");
    }
    let shape = desk.text("out/motion_layers/shape.usda");
    assert!(shape.contains("int[] faceVertexCounts = [4, 4, 4, 4, 4, 4, 6, 6]\n"), "{shape}");
    assert!(shape.contains("def Mesh \"Red_prism_1\"") && shape.contains("def Points \"red_Prism_1_2\""), "{shape}");
}

#[test]
fn another_programs_unit_and_axes_are_those_of_every_place() {
    let desk = desk();
    desk.run("simulate scene.json --format pc2,usd --frames 3..3 --out here");
    desk.run("simulate scene.json --format pc2,usd --frames 3..3 --out there --scale 100 --up z");
    let points = |folder: &str| pc2(&fs::read(desk.path(&format!("{folder}/Red_prism_1.pc2"))).unwrap()).1.remove(0);
    let turned: Vec<[f64; 3]> = points("here").iter().map(|[x, y, z]| [100.0 * x, -100.0 * z, 100.0 * y]).collect();
    assert!(distance(&turned, &points("there")) < 1e-5);
    let stage = desk.text("there/motion.usda");
    assert!(stage.contains("metersPerUnit = 0.01\n") && stage.contains("upAxis = \"Z\""), "{stage}");
    // Rest shape and motion are in the same frame.
    assert!(distance(&obj(&desk.text("there/Red_prism_1_rest.obj")).0, &turned) < 2.0);
}

#[test]
fn a_program_stands_for_its_unit_and_axes_and_fewer_frames_last_as_long() {
    let desk = desk();
    let frame = |name: &str, options: &str| {
        desk.ran(format!("simulate scene.json --frames 3..3 --out {name} {options}").trim_end());
        desk.text(&format!("{name}/frame_000003.obj"))
    };
    let plain = frame("plain", "");
    assert_eq!(frame("houdini", "--for houdini"), plain);
    assert_eq!(frame("own", "--for maya --scale 1"), plain, "what is said itself goes first");
    assert_eq!(frame("blender", "--for Blender"), frame("z", "--up z"));
    assert_eq!(frame("maya", "--for maya"), frame("cm", "--scale 100"));
    assert_eq!(frame("unreal", "--for unreal"), frame("cm_z", "--scale 100 --up z"));
    let said = desk.run("simulate scene.json --for paint --out no");
    assert!(said.code == Some(2) && said.err.contains("blender, houdini, maya, unreal"), "{said:?}");

    desk.ran("simulate scene.json --frames 1..6 --step 2 --format usd,mdd --out every");
    let stage = desk.text("every/motion.usda");
    for part in ["startTimeCode = 0\n", "endTimeCode = 2\n", "timeCodesPerSecond = 25\n"] {
        assert!(stage.contains(part), "{stage}");
    }
    let (times, _) = mdd(&fs::read(desk.path("every/Red_prism_1.mdd")).unwrap());
    assert!(times.len() == 3 && times.iter().zip([0.02, 0.06, 0.1]).all(|(a, b)| (a - b).abs() < 1e-6), "{times:?}");
}

#[test]
fn what_cannot_be_written_is_refused_before_anything_is() {
    let desk = Desk::new(&pressed());
    let cases = [
        ("--format fbx --out out", "there is no format of that name; give one of usd, pc2"),
        ("--frames 5..3 --out out", "as in 10..60"),
        ("--scale 0 --out out", "how many units make a metre"),
        ("--format pc2", "give --out DIR"),
        ("--frames 0..3", "give --out DIR"),
        (
            "--frames 0..7 --out out",
            "--frames 0..7: the run has the frames 0 to 6; choose among them, or give a longer time",
        ),
        ("--seconds 0.05 --frames 4..5 --out out", "the run has the frames 0 to 3"),
        ("--seconds 100 --format gltf --out out", "6001 frames of these bodies are more than the 600"),
    ];
    for (options, part) in cases {
        let said = desk.run(&format!("simulate scene.json {options}"));
        assert_eq!((said.code, said.out.as_str()), (Some(2), ""), "{options}: {said:?}");
        assert!(said.err.contains(part), "{options}: {}", said.err);
        assert_eq!(desk.files(), ["scene.json"], "{options}");
    }
    // The run ends with the last frame that is asked for.
    desk.done("simulate scene.json --frames 1..2 --out out --report r.json");
    assert_eq!((desk.json("r.json")["frames"].clone(), names(&desk.path("out")).len()), (json!(2), 2));
    desk.done("simulate scene.json --frames 1..2 --out out --seconds 0.1 --report r.json");
    assert_eq!(desk.json("r.json")["frames"], 6);
}

#[test]
#[cfg(unix)]
#[allow(clippy::disallowed_methods, reason = "between two looks at the condition")]
fn a_run_that_is_killed_leaves_whole_files() {
    let desk = desk();
    let mut child = program()
        .args("simulate scene.json --seconds 1000 --format pc2,mdd,usd --out out".split(' '))
        .current_dir(desk.folder.path())
        .stdout(Stdio::null())
        .spawn()
        .expect("the program starts");
    let stage = desk.path("out/motion.usda");
    let last = |path: &Path| {
        let text = fs::read_to_string(path).unwrap_or_default();
        text.lines().find_map(|line| line.trim().strip_prefix("endTimeCode = ")?.parse::<usize>().ok())
    };
    while last(&stage) < Some(12) {
        assert!(child.try_wait().expect("a state").is_none(), "the run has ended");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    child.kill().expect("it is killed");
    child.wait().expect("it ends");
    let last = last(&stage).unwrap();
    let clip = desk.text(&format!("out/motion_layers/frame.{last:06}.usda"));
    assert!(clip.ends_with("}\n}\n"), "{clip}");
    let samples = pc2(&fs::read(desk.path("out/Red_prism_1.pc2")).unwrap()).1.len();
    assert!(samples > last, "{samples} {last}");
    let (times, _) = mdd(&fs::read(desk.path("out/Red_prism_1.mdd")).unwrap());
    assert!(3 * times.len() >= 2 * last, "{} {last}", times.len());
}

/// The checks of other programs' readers: skipped where they are not installed. `tests/tools/check_exports.sh` installs
/// them.
#[test]
fn readers_of_others_find_the_same() {
    let python = std::env::var("SINEW_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has = Command::new(&python).args(["-c", "import pxr"]).stderr(Stdio::null()).status();
    if !has.is_ok_and(|status| status.success()) {
        eprintln!("skipped: {python} has no pxr; tests/tools/check_exports.sh installs it");
        return;
    }
    let desk = desk();
    desk.run("simulate scene.json --format usd,gltf,obj,ply --frames 0..6 --out out");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tools/check_exports.py");
    let output = Command::new(&python).arg(script).arg(desk.path("out")).output().expect("it runs");
    let said = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    eprintln!("{said}");
}

/// Places and texture coordinates of all corners, in the order of the faces; none for corners without.
fn corners(mesh: &FileMesh) -> Vec<([f64; 3], Option<[f64; 2]>)> {
    let set = mesh.uv_sets.first();
    let uv = |corner: usize| set.and_then(|set| Some(set.values[set.of(corner)? as usize]));
    let at = |(corner, &vertex): (usize, &u32)| (mesh.points[vertex as usize].to_array(), uv(corner));
    mesh.corners.iter().enumerate().map(at).collect()
}

#[test]
fn what_went_out_comes_in_again_as_it_was() {
    let desk = desk();
    let mut scene = falling();
    scene["two_layer"] = json!([]);
    fs::write(desk.path("scene.json"), scene.to_string()).unwrap();
    desk.run("simulate scene.json --format obj,ply,gltf,pc2 --frames 0..0 --out out");
    let read = |name: &str| {
        let model = load_model(&desk.path(name)).unwrap_or_else(|error| panic!("{error}"));
        FileMesh::clone(model.file.as_deref().expect("the mesh of the file"))
    };
    let given = read("prism.obj");
    assert_eq!((given.points.len(), &given.counts), (13, &vec![4, 4, 4, 4, 4, 4, 6, 6]));
    let parts: Vec<_> =
        given.parts.iter().map(|part| (&*part.name, &*part.material, part.colour, part.faces.clone())).collect();
    assert_eq!(parts, [("sides", "red paint", Some([1.0, 0.0, 0.0, 1.0]), 0..6), ("caps", "none", None, 6..8)]);
    for name in ["out/Red_prism_1_rest.obj", "out/frame_000000.obj", "out/frame_000000.ply"] {
        let mesh = read(name);
        assert_eq!((&mesh.counts, &mesh.corners), (&given.counts, &given.corners), "{name}");
        for (a, b) in corners(&mesh).iter().zip(corners(&given)) {
            // Where every corner must have some, those without have the origin.
            assert!(a.1 == b.1 || (a.1 == Some([0.0; 2]) && b.1.is_none()), "{name}: {a:?} {b:?}");
        }
    }
    let rest = read("out/Red_prism_1_rest.obj");
    let clip = read("out/motion.glb");
    let places = |mesh: &FileMesh| mesh.points[..13].iter().map(glam::DVec3::to_array).collect::<Vec<_>>();
    assert!(distance(&places(&clip), &places(&rest)) < 1e-7 && clip.points.len() > 13);
    let parts: Vec<_> = clip.parts.iter().map(|part| (&*part.name, &*part.material, part.faces.len())).collect();
    assert_eq!(parts, [("sides", "red paint", 12), ("caps", "none", 8)]);
    let found = corners(&clip);
    for (place, uv) in corners(&rest) {
        let wanted = uv.unwrap_or_default();
        let is_it = |(at, is): &([f64; 3], Option<[f64; 2]>)| {
            let same = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
            // Without coordinates stands for the upper left in the format.
            same(at, &place) && is.is_some_and(|is| same(&is, &wanted) || (uv.is_none() && same(&is, &[0.0, 1.0])))
        };
        assert!(found.iter().any(is_it), "{place:?} {uv:?}");
    }
}
