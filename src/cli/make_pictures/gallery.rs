//! The taking of pictures: in one light, before one ground that looks well in either theme.

use super::Demo;
use super::examples::ExamplePicture;
use crate::bake::bake;
use crate::cli::CliError;
use crate::cli::prepare::source_name;
use crate::draw::{Bounds, Display, SkinStyle, Subject, Theme, draw};
use crate::io::{load_assets, load_scene};
use crate::render::{Camera, Offscreen, Picture};
use crate::scene::{Assets, Scene};
use crate::sim::Runner;
use crate::solver::snapshot::Snapshot;
use std::path::Path;

/// Pictures in a strip, one below the other.
const FRAMES: u32 = 10;
/// Width and height of each [pixels].
const FRAME: u32 = 128;
/// Width and height of an example's picture [pixels].
pub(super) const EXAMPLE: [u32; 2] = [240, 150];
/// Pictures in the strip of an example.
pub(super) const EXAMPLE_FRAMES: u32 = 12;
/// The camera frames with room to spare; small pictures need less.
const CLOSER: f64 = 0.88;
/// Examples show balls around particles at their edge, too.
const EXAMPLE_CLOSER: f64 = 0.97;
/// Eyes up to this height see a panel by its edge [degrees].
const SIDELONG: f64 = 10.0;
/// Pictures are drawn so many times as large each way, and averaged.
const FINER: u32 = 2;

/// The strip of a pattern as a PNG file.
///
/// # Errors
/// No driver, or a scene that cannot be put together.
pub(super) fn strip(demo: &Demo) -> Result<Vec<u8>, CliError> {
    let times: Vec<f64> =
        (0..FRAMES).map(|k| demo.from + (demo.to - demo.from) * f64::from(k) / f64::from(FRAMES - 1)).collect();
    let states = run(&demo.scene, &Assets::default(), &times, None)?;
    let plain = if demo.beside_plain { run(&demo.plain(), &Assets::default(), &times, None)? } else { Vec::new() };
    let display = Display { skin: SkinStyle::XRay, ..bare() };
    let mut camera = Camera::perspective();
    [camera.yaw, camera.pitch] = demo.eye.map(f64::to_radians);
    let seen = states.iter().chain(&plain).flat_map(|state| state.bodies.iter().flat_map(|body| &body.skin)).copied();
    if let Some(bounds) = Bounds::of(seen) {
        camera.frame(&bounds, 1.0);
        camera.height *= CLOSER;
    }
    let mut scene = demo.scene.clone();
    // Seen from above, what presses would hide what turns below it.
    if demo.eye[1] > SIDELONG {
        scene.panels.clear();
    }
    let mut offscreen = Offscreen::new([FINER * FRAME; 2])?;
    let mut strip = Picture { size: [FRAME, FRAMES * FRAME], rgba: Vec::new() };
    for (k, snapshot) in states.iter().enumerate() {
        let subject = Subject { scene: &scene, snapshot, ghost: plain.get(k) };
        let picture = offscreen.draw(draw(&subject, &display, &Theme::gallery()), &camera)?;
        strip.rgba.extend(averaged(&picture).rgba);
    }
    Ok(strip.to_png()?)
}

/// The picture of an example as a PNG file, or the strip of them.
///
/// # Errors
/// A scene that cannot be used, or no driver.
pub(super) fn picture(example: &ExamplePicture, folder: &Path) -> Result<Vec<u8>, CliError> {
    let path = folder.join(format!("{}.json", example.name));
    let scene = load_scene(&path)?;
    let assets = load_assets(&scene, folder, &mut |_| {})?;
    let until = example.until.unwrap_or(example.at);
    let count = if example.until.is_some() { EXAMPLE_FRAMES } else { 1 };
    let taken = (0..count).map(|k| example.at + (until - example.at) * f64::from(k) / f64::from(count.max(2) - 1));
    let times: Vec<f64> = [0.0].into_iter().chain(taken).collect();
    let mut states = run(&scene, &assets, &times, Some(&path))?;
    let start = Some(states.remove(0)).filter(|_| example.beside_start);
    let has_something = scene.bodies.iter().any(|body| !body.fibres.is_empty() || !body.sheets.is_empty());
    let skin = if has_something { SkinStyle::XRay } else { SkinStyle::Shaded };
    let display = Display { skin, ..bare() };
    let size = EXAMPLE.map(|extent| FINER * extent);
    let list =
        |snapshot| draw(&Subject { scene: &scene, snapshot, ghost: start.as_ref() }, &display, &Theme::gallery());
    let mut camera = Camera::perspective();
    let shown = states.iter().chain(&start);
    if let Some(bounds) = shown.filter_map(|snapshot| list(snapshot).bounds).reduce(Bounds::union) {
        camera.frame(&bounds, f64::from(size[0]) / f64::from(size[1]));
        camera.height *= EXAMPLE_CLOSER;
    }
    let mut offscreen = Offscreen::new(size)?;
    let mut strip = Picture { size: [EXAMPLE[0], count * EXAMPLE[1]], rgba: Vec::new() };
    for state in &states {
        strip.rgba.extend(averaged(&offscreen.draw(list(state), &camera)?).rgba);
    }
    Ok(strip.to_png()?)
}

/// The bodies of a scene at some times, in order.
fn run(scene: &Scene, assets: &Assets, times: &[f64], source: Option<&Path>) -> Result<Vec<Snapshot>, CliError> {
    let baked = bake(scene, assets).map_err(|error| CliError::Bake { scene: source_name(source), source: error })?;
    let mut runner = Runner::new(baked);
    let mut states = Vec::new();
    for time in times {
        let frame = runner.frames_for(*time);
        while runner.world().frame() < frame {
            runner.advance_frame();
        }
        states.push(runner.snapshot());
    }
    Ok(states)
}

fn bare() -> Display {
    Display { grid: false, axes: false, room: false, ..Display::default() }
}

/// The picture at its final size.
fn averaged(fine: &Picture) -> Picture {
    let size = fine.size.map(|extent| extent / FINER);
    let mut rgba = Vec::with_capacity(4 * (size[0] * size[1]) as usize);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let parts = (0..FINER * FINER).filter_map(|k| fine.pixel([FINER * x + k % FINER, FINER * y + k / FINER]));
            let mut sums = [0_u32; 4];
            for part in parts {
                (0..4).for_each(|c| sums[c] += u32::from(part[c]));
            }
            let parts = FINER * FINER;
            rgba.extend(sums.map(|sum| ((sum + parts / 2) / parts) as u8));
        }
    }
    Picture { size, rgba }
}
