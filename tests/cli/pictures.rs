//! Pictures from the command line.

#[cfg(feature = "render")]
use super::Said;
use super::{Desk, pressed, program, said};
use std::fs;

/// The signature with which every PNG file starts, and the width and height that follow.
#[cfg(feature = "render")]
fn png_size(bytes: &[u8]) -> [u32; 2] {
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("four bytes")))
}

/// Runs the program; none, and a word about it, where there is no graphics driver and none is required.
#[cfg(feature = "render")]
#[allow(clippy::print_stderr, reason = "what is skipped is said")]
fn drawn(desk: &Desk, arguments: &str) -> Option<Said> {
    let said = desk.run(arguments);
    if said.code == Some(4) {
        let required = std::env::var("SINEW_REQUIRE_GPU").is_ok_and(|value| value == "1");
        assert!(!required, "a graphics driver is required: {said:?}");
        eprintln!("skipped `{arguments}`: {}", said.err);
        return None;
    }
    assert_eq!(said.code, Some(0), "{arguments}: {said:?}");
    Some(said)
}

#[cfg(feature = "render")]
#[test]
fn a_model_is_drawn_as_the_window_opens_it() {
    let desk = Desk::new(&pressed());
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n\
        f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    fs::write(desk.path("cube.obj"), cube).expect("the model is written");
    let Some(said) = drawn(&desk, "render cube.obj --at 0.05 --size 320x200 --out a.png") else { return };
    assert_eq!(said.out, "picture written to a.png\n");
    assert!(said.err.contains("the model is made a soft solid"), "{}", said.err);
    let picture = fs::read(desk.path("a.png")).expect("the picture is there");
    assert_eq!(png_size(&picture), [320, 200]);
}

#[cfg(feature = "render")]
#[test]
fn a_picture_is_as_large_as_it_was_asked_to_be_and_shows_when_it_was_taken() {
    let desk = Desk::new(&pressed());
    let Some(said) = drawn(&desk, "render scene.json --at 0 --size 320x200 --out a.png") else { return };
    assert_eq!(said.out, "picture written to a.png\n");
    let picture = |name: &str| fs::read(desk.path(name)).expect("the picture is there");
    assert_eq!(png_size(&picture("a.png")), [320, 200]);
    for (name, options) in [
        ("again.png", "--at 0"),
        ("later.png", "--at 0.1"),
        ("front.png", "--at 0 --view front"),
        ("inside.png", "--at 0 --x-ray"),
        ("particles.png", "--at 0 --particles"),
        ("dark.png", "--at 0 --theme dark"),
        ("cut.png", "--at 0 --slice x=0.001"),
        ("other_side.png", "--at 0 --slice -x=0.001"),
    ] {
        drawn(&desk, &format!("render scene.json {options} --size 320x200 --out {name}"));
        assert_eq!(picture("a.png") == picture(name), name == "again.png", "{name}");
    }
}

#[cfg(feature = "render")]
#[test]
fn a_run_leaves_a_picture_of_every_frame() {
    let desk = Desk::new(&pressed());
    let run = "simulate scene.json --seconds 0.05 --png frames --size 160x120";
    let Some(said) = drawn(&desk, run) else { return };
    assert!(said.out.contains("4 pictures written to frames"), "{}", said.out);
    assert_eq!(super::names(&desk.path("frames")), (0..4).map(|k| format!("frame_{k:06}.png")).collect::<Vec<_>>());
    let said = desk.run("simulate scene.json --seconds 0 --png frames --size 160x120");
    assert!(said.err.contains("3 more frames of an earlier"), "{}", said.err);
}

#[cfg(feature = "render")]
#[test]
fn without_a_driver_one_line_says_what_to_install() {
    let desk = Desk::new(&pressed());
    for arguments in ["render scene.json --out a.png", "simulate scene.json --png frames"] {
        let mut program = program();
        // Where the drivers are looked for, there is nothing.
        for variable in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
            program.env(variable, "/nonexistent");
        }
        program.env("WGPU_BACKEND", "vulkan").args(arguments.split(' ')).current_dir(desk.path(""));
        let Said { code, err, .. } = said(&mut program);
        assert_eq!(code, Some(4), "{err}");
        let lines: Vec<&str> = err.lines().filter(|line| line.contains("libvulkan1 mesa-vulkan-drivers")).collect();
        assert!(lines.len() == 1 && lines[0].starts_with("error: ") && !err.contains("panicked"), "{err}");
        assert_eq!(desk.files(), ["scene.json"]);
    }
}

#[test]
fn pictures_that_cannot_be_made_are_refused_before_anything_is_run() {
    let desk = Desk::new(&pressed());
    let error = desk.refused("render scene.json --at 100000 --out no/such/a.png");
    assert!(error.contains("no/such/a.png"), "{error}");
    let error = desk.refused("render scene.json --at 100000 --out ./scene.json");
    assert!(error.contains("the same file"), "{error}");
    for bad in
        ["--size 0x5", "--size big", "--view back", "--theme pink", "--at -1", "--x-ray --particles", "--slice w=0"]
    {
        let said = desk.run(&format!("render scene.json {bad} --out a.png"));
        assert_eq!((said.code, desk.files()), (Some(2), vec!["scene.json".to_owned()]), "{bad}: {said:?}");
    }
    let said = said(program().arg("render"));
    assert_eq!(said.code, Some(2));
    let error = desk.refused("simulate scene.json --view top --seconds 0");
    assert!(error.contains("give --png DIR"), "{error}");
    assert!(fs::metadata(desk.path("a.png")).is_err(), "nothing was written");
}

#[cfg(not(feature = "render"))]
#[test]
fn a_program_without_pictures_says_so() {
    let desk = Desk::new(&pressed());
    for arguments in ["render scene.json --out a.png", "simulate scene.json --png frames"] {
        let error = desk.refused(arguments);
        assert!(error.contains("built without pictures"), "{error}");
    }
}

#[cfg(feature = "render")]
#[test]
fn the_pictures_of_the_galleries_can_be_made_again() {
    let desk = Desk::new(&pressed());
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes");
    let make = |only: &str| drawn(&desk, &format!("make-pictures made --scenes {scenes} --only {only}"));
    if make("vert").is_none() {
        return;
    }
    make("two_layer_1d");
    let [strip, example] = ["made/patterns/vertical.png", "made/examples/two_layer_1d.png"]
        .map(|name| fs::read(desk.path(name)).expect("the picture is there"));
    assert_eq!((png_size(&strip), png_size(&example)), ([128, 1280], [240, 150]));
    assert_eq!(super::names(&desk.path("made/patterns")), ["vertical.png"]);
}

#[cfg(feature = "render")]
#[test]
fn a_run_leaves_a_moving_picture_of_the_frames_that_are_asked_for() {
    let desk = Desk::new(&pressed());
    let run = "simulate scene.json --format apng,gif --frames 2..5 --size 80x60 --out out";
    let Some(said) = drawn(&desk, run) else { return };
    assert!(said.out.contains("a moving picture of 4 frames written to out/motion.apng"), "{}", said.out);
    // A GIF is never faster than fifty pictures a second.
    assert!(said.out.contains("a moving picture of 3 of 4 frames written to out/motion.gif"), "{}", said.out);
    assert_eq!(super::names(&desk.path("out")), ["motion.apng", "motion.gif"]);
    let file = std::io::BufReader::new(fs::File::open(desk.path("out/motion.apng")).expect("it is there"));
    let mut reader = png::Decoder::new(file).read_info().expect("a head");
    assert_eq!(
        (reader.info().size(), reader.info().animation_control().map(|said| said.num_frames)),
        ((80, 60), Some(4))
    );
    let mut pictures = vec![vec![0; reader.output_buffer_size().expect("a size")]; 4];
    for picture in &mut pictures {
        reader.next_frame(picture).expect("a picture");
    }
    assert!(pictures.windows(2).any(|pair| pair[0] != pair[1]));

    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut reader =
        options.read_info(fs::File::open(desk.path("out/motion.gif")).expect("it is there")).expect("a head");
    assert_eq!((reader.width(), reader.height(), reader.repeat()), (80, 60, gif::Repeat::Infinite));
    let (mut canvas, mut shown) = (vec![[0; 3]; 80 * 60], 0);
    // Frames 0, 2 and 3 of the four.
    for number in [0, 2, 3] {
        let frame = reader.read_next_frame().expect("a picture").expect("one more");
        shown += frame.delay;
        for (index, pixel) in frame.buffer.as_chunks::<4>().0.iter().enumerate().filter(|(_, pixel)| pixel[3] > 0) {
            let (row, column) = (index / usize::from(frame.width), index % usize::from(frame.width));
            let place = (row + usize::from(frame.top)) * 80 + column + usize::from(frame.left);
            canvas[place] = [pixel[0], pixel[1], pixel[2]];
        }
        let pixels = canvas.iter().flatten().zip(&pictures[number]);
        let off: Vec<u8> = pixels.map(|(a, b)| a.abs_diff(*b)).collect();
        assert!(off.iter().all(|&off| off < 128), "{number}: {:?}", off.iter().max());
        assert!(off.iter().map(|&off| usize::from(off)).sum::<usize>() < 2 * off.len(), "{number}");
    }
    assert!(reader.read_next_frame().expect("an end").is_none());
    assert_eq!(shown, 6);
}
