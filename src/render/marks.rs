//! Marks on the picture: the scale, the axes in a corner, and the list's labels.

use super::camera::Camera;
use super::encoding::{ON_SCREEN, SEGMENT_WORDS, push_line};
use super::renderer::Renderer;
use super::store::Store;
use super::{glyphs, scale};
use crate::draw::{Colour, DrawList, Line};
use glam::{DVec2, DVec3, Vec2, Vec3};

/// Distances from the picture's edges, and extents [points].
const MARGIN: f32 = 18.0;
const ARM: f32 = 26.0;
const LETTER: f32 = 9.0;
const LETTER_WIDTH: f32 = 1.3;
const LONGEST_BAR: f64 = 140.0;
const TICK: f32 = 4.0;
/// A picture smaller than this [points] is left to its subject.
const SMALLEST: f32 = 220.0;

/// Writes the marks of a view.
pub(super) fn write(
    store: &mut Store,
    renderer: &Renderer,
    list: &DrawList,
    camera: &Camera,
    size: [u32; 2],
    pixels_per_point: f32,
) {
    let mut marks = MarksBuilder { words: Vec::new(), scale: pixels_per_point };
    let extent = Vec2::from_array(size.map(|extent| extent as f32));
    let roomy = extent.min_element() >= SMALLEST * pixels_per_point;
    if list.ground.axes && roomy {
        marks.axes(list, camera, extent);
    }
    if list.ground.grid && roomy {
        marks.bar(list, camera, extent);
    }
    for label in &list.labels {
        let point = list.origin + label.at.as_dvec3();
        if let Some(seen) = camera.project(point, DVec2::from_array(size.map(f64::from))) {
            let at = Vec2::new(seen.pixel.x as f32, extent.y - seen.pixel.y as f32);
            marks.text(&label.text, at + Vec2::splat(6.0 * pixels_per_point), label.colour);
        }
    }
    store.write(renderer.device(), renderer.queue(), &marks.words, SEGMENT_WORDS);
}

/// Draws in pixels from the lower left corner.
struct MarksBuilder {
    words: Vec<u32>,
    scale: f32,
}

impl MarksBuilder {
    fn line(&mut self, points: &[Vec2], width: f32, colour: Colour) {
        let points: Vec<Vec3> = points.iter().map(|point| point.extend(0.0)).collect();
        push_line(&mut self.words, &Line { points, width, colour, through: 0.0, pick: 0 }, ON_SCREEN);
    }

    fn text(&mut self, text: &str, at: Vec2, colour: Colour) {
        for line in glyphs::text(text).0 {
            let points: Vec<Vec2> = line.iter().map(|point| at + *point * LETTER * self.scale).collect();
            self.line(&points, LETTER_WIDTH, colour);
        }
    }

    /// The directions of the axes, those that come towards the eye last.
    fn axes(&mut self, list: &DrawList, camera: &Camera, extent: Vec2) {
        let reach = (MARGIN + ARM + LETTER) * self.scale;
        let centre = Vec2::new(extent.x - reach, extent.y - reach);
        let view_from_world = camera.world_from_view().transpose();
        let mut arms: Vec<(DVec3, Colour, &str)> = DVec3::AXES
            .iter()
            .zip(list.theme.axes)
            .zip(["X", "Y", "Z"])
            .map(|((&axis, colour), name)| (view_from_world * axis, colour, name))
            .collect();
        arms.sort_by(|a, b| a.0.z.total_cmp(&b.0.z));
        for (direction, colour, name) in arms {
            let flat = Vec2::new(direction.x as f32, direction.y as f32);
            // An axis that points at the eye or away has nothing to show.
            if flat.length() < 0.05 {
                continue;
            }
            let tip = centre + flat * ARM * self.scale;
            self.line(&[centre, tip], 2.0, colour);
            let letter = tip + flat.normalize_or_zero() * 0.95 * LETTER * self.scale;
            let half = 0.5 * Vec2::new(glyphs::text(name).1, 1.0) * LETTER * self.scale;
            self.text(name, letter - half, colour);
        }
    }

    /// A bar of a round length with its name.
    fn bar(&mut self, list: &DrawList, camera: &Camera, extent: Vec2) {
        let metres_per_pixel = camera.metres_per_pixel(f64::from(extent.y));
        let (length, name) = scale::bar(LONGEST_BAR * f64::from(self.scale) * metres_per_pixel);
        let pixels = (length / metres_per_pixel) as f32;
        // On whole pixels, so that the bar is crisp.
        let start = Vec2::splat(MARGIN * self.scale).floor() + 0.5;
        let (end, tick) = ((start + Vec2::X * pixels).floor() + 0.5, Vec2::Y * TICK * self.scale);
        let end = Vec2::new(end.x, start.y);
        self.line(&[start + tick, start, end, end + tick], 1.5, list.theme.text);
        let middle = 0.5 * (start + end);
        let left = middle - Vec2::X * 0.5 * glyphs::text(&name).1 * LETTER * self.scale;
        self.text(&name, left + Vec2::Y * 7.0 * self.scale, list.theme.text);
    }
}
