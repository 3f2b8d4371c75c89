//! Plots as SVG: two axes, some lines and a legend.
//!
//! Written out by hand: that is less than a plotting library with its fonts would be.

use crate::text::number::four_figures;
use std::fmt::Write;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 520.0;
const TOP: f64 = 50.0;
const BOTTOM: f64 = 420.0;

/// Colours that people who see colours differently tell apart (Okabe and Ito).
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

/// Where values stand on an axis, and what is written there.
pub(super) struct Scale {
    least: f64,
    most: f64,
    is_log: bool,
    ticks: Vec<(f64, String)>,
}

impl Scale {
    /// Whole decades around all values above zero.
    pub(super) fn logarithmic(values: impl Iterator<Item = f64>) -> Self {
        let powers: Vec<f64> = values.map(f64::log10).filter(|power| power.is_finite()).collect();
        let least = powers.iter().copied().reduce(f64::min).unwrap_or(0.0).floor();
        let most = powers.iter().copied().reduce(f64::max).unwrap_or(0.0).ceil().max(least + 1.0);
        let ticks = (least as i32..=most as i32).map(|power| (10_f64.powi(power), format!("1e{power}"))).collect();
        Self { least, most, is_log: true, ticks }
    }

    /// Round steps around all values.
    pub(super) fn linear(values: impl Iterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        let least = values.iter().copied().reduce(f64::min).unwrap_or(0.0);
        let most = values.iter().copied().reduce(f64::max).unwrap_or(1.0);
        let span = if most > least { most - least } else { 1e-12_f64.max(least.abs()) };
        let decade = 10_f64.powf((span / 5.0).log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * decade).into_iter().find(|step| span / step <= 6.0);
        let step = step.unwrap_or(span);
        let (first, last) = ((least / step).floor(), (most / step).ceil().max((least / step).floor() + 1.0));
        let count = (last - first).round() as u32;
        let ticks = (0..=count).map(|k| step * (first + f64::from(k))).map(|at| (at, four_figures(at))).collect();
        Self { least: step * first, most: step * last, is_log: false, ticks }
    }

    /// Where a value stands between the ends of the axis: from 0 to 1.
    fn share(&self, value: f64) -> f64 {
        let value = if self.is_log { value.log10() } else { value };
        (value - self.least) / (self.most - self.least)
    }

    fn x(&self, value: f64) -> f64 {
        LEFT + self.share(value) * (RIGHT - LEFT)
    }

    fn y(&self, value: f64) -> f64 {
        BOTTOM + self.share(value) * (TOP - BOTTOM)
    }
}

/// A plot that is being drawn.
pub(super) struct Canvas {
    svg: String,
    x: Scale,
    y: Scale,
}

impl Canvas {
    /// A title and axes with what they show.
    pub(super) fn new(title: &str, [x_name, y_name]: [&str; 2], [x, y]: [Scale; 2]) -> Self {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n\
             <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n"
        );
        let mut canvas = Self { svg, x, y };
        canvas.text(LEFT, 28.0, "start", title);
        canvas.text(0.5 * (LEFT + RIGHT), HEIGHT - 14.0, "middle", x_name);
        let (at_x, at_y) = (20.0, 0.5 * (TOP + BOTTOM));
        canvas.put(format_args!("<g transform=\"rotate(-90 {at_x} {at_y})\">\n"));
        canvas.text(at_x, at_y, "middle", y_name);
        canvas.put(format_args!("</g>\n"));
        for (value, name) in canvas.x.ticks.clone() {
            let at = canvas.x.x(value);
            canvas.rule([at, TOP], [at, BOTTOM]);
            canvas.text(at, BOTTOM + 20.0, "middle", &name);
        }
        for (value, name) in canvas.y.ticks.clone() {
            let at = canvas.y.y(value);
            canvas.rule([LEFT, at], [RIGHT, at]);
            canvas.text(LEFT - 8.0, at + 4.0, "end", &name);
        }
        canvas
    }

    /// A line through points, which are marked, in a colour by its number, and its name in the legend.
    pub(super) fn line(&mut self, index: usize, name: &str, points: &[(f64, f64)]) {
        let colour = COLOURS[index % COLOURS.len()];
        let places: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (self.x.x(x), self.y.y(y))).collect();
        let path: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let path = path.join(" ");
        self.put(format_args!("<polyline points=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\n"));
        for (x, y) in places {
            self.put(format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{colour}\"/>\n"));
        }
        let row = TOP + 12.0 + 24.0 * index as f64;
        self.put(format_args!("<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill=\"{colour}\"/>\n", RIGHT + 20.0, row - 4.0));
        self.text(RIGHT + 32.0, row, "start", name);
    }

    /// The whole file.
    pub(super) fn finish(mut self) -> String {
        self.svg += "</svg>\n";
        self.svg
    }

    fn rule(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.put(format_args!(
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#cccccc\"/>\n"
        ));
    }

    fn text(&mut self, x: f64, y: f64, anchor: &str, text: &str) {
        let text = escape(text);
        self.put(format_args!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>\n"));
    }

    fn put(&mut self, piece: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.svg.write_fmt(piece);
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_has_round_ticks_that_hold_all_values() {
        let scale = Scale::linear([0.13, 0.87].into_iter());
        let names: Vec<&str> = scale.ticks.iter().map(|(_, name)| &**name).collect();
        assert_eq!((names.first(), names.len()), (Some(&"0"), 6), "{names:?}");
        assert!((scale.share(0.5) - 0.5).abs() < 1e-12);
        for alone in [0.0, 3.0, -2e-5] {
            let scale = Scale::linear([alone].into_iter());
            assert!((0.0..=1.0).contains(&scale.share(alone)) && scale.ticks.len() > 1, "{alone}");
        }
    }
}
