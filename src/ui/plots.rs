//! Lines over time, wherever the window plots some.

use crate::text::number::{three_figures, tick};
use egui::{Color32, Ui};
use egui_plot::{GridInput, GridMark, HoverPosition, Line, LineStyle, Plot, PlotPoints, VLine};
use std::ops::RangeInclusive;

/// Width of a line, of one that stands out, and of one that stands back [points].
pub(super) const LINE: f32 = 1.5;
pub(super) const BOLD: f32 = 2.5;
pub(super) const THIN: f32 = 1.0;

/// Least distance between numbers along the time axis, along the other one, and the unit in which the toolkit counts
/// such distances [points].
const TIME_APART: f64 = 84.0;
const VALUES_APART: f64 = 32.0;
const COUNTED: f64 = 8.0;

/// A line in a plot.
pub(super) struct Trace {
    /// What it is called when the pointer is near.
    pub name: String,
    /// Its colour.
    pub colour: Color32,
    /// Its width [points].
    pub width: f32,
    /// Whether it is dashed.
    pub dashed: bool,
    /// Times [s] and values.
    pub points: Vec<[f64; 2]>,
}

/// Traces over time, with their values in `unit` where the pointer is, and a mark at some time [s].
pub(super) fn over_time(ui: &mut Ui, id: &str, height: f32, unit: &str, traces: Vec<Trace>, mark: Option<f64>) {
    let said = format!(" {unit}");
    let hover = move |at: &HoverPosition<'_>| match at {
        HoverPosition::NearDataPoint { plot_name, position, .. } => {
            Some(format!("{plot_name}\n{:.3} s\n{}{said}", position.x, three_figures(position.y)))
        }
        HoverPosition::Elsewhere { .. } => None,
    };
    let ink = ui.visuals().text_color();
    still(Plot::new(id))
        .height(height)
        .grid_color(ink.gamma_multiply(0.25))
        .x_grid_spacer(|input| marks(&input, TIME_APART))
        .y_grid_spacer(|input| marks(&input, VALUES_APART))
        .label_formatter(hover)
        .x_axis_formatter(|mark, range| format!("{} s", at_axis(mark, range)))
        .y_axis_formatter(at_axis)
        .y_axis_min_width(48.0)
        .show(ui, |plot| {
            for trace in traces {
                let style = if trace.dashed { LineStyle::dashed_dense() } else { LineStyle::Solid };
                let line = Line::new(trace.name, PlotPoints::from(trace.points));
                plot.line(line.color(trace.colour).width(trace.width).style(style));
            }
            if let Some(time) = mark {
                plot.vline(VLine::new("Shown", time).color(ink).width(THIN));
            }
        });
}

/// A plot that follows its data and leaves wheel and drag to the panel.
pub(super) fn still(plot: Plot<'_>) -> Plot<'_> {
    plot.allow_zoom(false).allow_scroll(false).allow_drag(false).allow_boxed_zoom(false).allow_axis_zoom_drag(false)
}

/// Grid lines at least so far apart [points], at multiples of 1, 2 or 5 times a power of ten.
fn marks(input: &GridInput, apart: f64) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let least = input.base_step_size * apart / COUNTED;
    let power = 10_f64.powf(least.log10().floor());
    let step_size = [1.0, 2.0, 5.0, 10.0].map(|by| by * power).into_iter().find(|step| *step >= least).unwrap_or(least);
    if !(step_size.is_finite() && step_size > 0.0 && (high - low) / step_size < 1e3) {
        return Vec::new();
    }
    let places = (low / step_size).ceil() as i64..=(high / step_size).floor() as i64;
    places.map(|place| GridMark { value: place as f64 * step_size, step_size }).collect()
}

/// A number at an axis.
fn at_axis(mark: GridMark, range: &RangeInclusive<f64>) -> String {
    tick(mark.value, mark.step_size, range.start().abs().max(range.end().abs()))
}

/// The points of a curve that a plot can show: of every `bucket` that follow each other the lowest and the highest, in
/// their order, and the last. Buckets begin at whole multiples of their size, counted by the points' own numbers, so
/// that a growing curve does not flicker.
pub(super) fn thinned(points: impl Iterator<Item = (u64, [f64; 2])>, bucket: u64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    let mut open: Option<(u64, [f64; 2], [f64; 2])> = None;
    let mut last = None;
    let close = |kept: &mut Vec<[f64; 2]>, (_, low, high): (u64, [f64; 2], [f64; 2])| {
        let (first, second) = if low[0] <= high[0] { (low, high) } else { (high, low) };
        kept.push(first);
        if first != second {
            kept.push(second);
        }
    };
    for (number, point) in points {
        last = Some(point);
        let place = number / bucket.max(1);
        open = Some(match open {
            Some((at, low, high)) if at == place => {
                (at, if point[1] < low[1] { point } else { low }, if point[1] > high[1] { point } else { high })
            }
            other => {
                if let Some(done) = other {
                    close(&mut kept, done);
                }
                (place, point, point)
            }
        });
    }
    if let Some(done) = open {
        close(&mut kept, done);
    }
    kept.extend(last.filter(|last| kept.last() != Some(last)));
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thinned_curve_keeps_its_peaks_and_its_end() {
        let curve = |k: u64| [k as f64, if k == 37 { 9.0 } else { (k as f64 * 0.7).sin() }];
        let kept = thinned((10..100).map(|k| (k, curve(k))), 8);
        assert!(kept.len() <= 2 * 13 + 1 && kept.contains(&[37.0, 9.0]));
        assert_eq!(kept.last(), Some(&curve(99)));
        assert!(kept.windows(2).all(|pair| pair[0][0] < pair[1][0]), "in order");
        // What has been shown stays as the curve goes on.
        let longer = thinned((10..120).map(|k| (k, curve(k))), 8);
        assert_eq!(longer[..20], kept[..20]);
        assert_eq!(thinned((0..5).map(|k| (k, curve(k))), 1).len(), 5);
    }

    #[test]
    fn grid_lines_stand_at_round_numbers_far_enough_apart() {
        let at = |bounds: (f64, f64)| {
            let base_step_size = (bounds.1 - bounds.0) / 160.0 * COUNTED;
            marks(&GridInput { bounds, base_step_size }, VALUES_APART).iter().map(|mark| mark.value).collect::<Vec<_>>()
        };
        assert_eq!(at((-2.2, 2.6)), [-2.0, -1.0, 0.0, 1.0, 2.0]);
        assert_eq!(at((0.1, 0.9)), [0.2, 0.4, 3.0 * 0.2, 0.8]);
        assert!(at((1.0, 1.0)).is_empty());
        assert!(at((f64::NEG_INFINITY, f64::INFINITY)).is_empty());
    }
}
