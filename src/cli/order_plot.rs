//! The order plot: errors over steps, log-log, as SVG.
//!
//! Written out by hand: two axes, some lines and a legend are less than a plotting library with its fonts would be.

use crate::scene::one_line;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// Errors of one integrator.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlotLine {
    /// Name of the integrator.
    pub name: String,
    /// Order of convergence.
    pub order: Option<f64>,
    /// Steps [s] and errors [m], steps ascending.
    pub points: Vec<(f64, f64)>,
}

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 520.0;
const TOP: f64 = 50.0;
const BOTTOM: f64 = 420.0;

/// Colours that people who see colours differently tell apart (Okabe and Ito).
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

/// The plot of these lines.
pub(super) fn order_plot(title: &str, lines: &[PlotLine]) -> String {
    let points = || lines.iter().flat_map(|line| &line.points);
    let x = PlotAxis::over(points().map(|point| point.0), LEFT, RIGHT);
    let y = PlotAxis::over(points().map(|point| point.1), BOTTOM, TOP);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
         viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n"
    );
    text(&mut svg, LEFT, 28.0, "start", &escape(&one_line(title)));
    text(&mut svg, 0.5 * (LEFT + RIGHT), HEIGHT - 14.0, "middle", "time step [s]");
    let (at_x, at_y) = (20.0, 0.5 * (TOP + BOTTOM));
    put(&mut svg, format_args!("<g transform=\"rotate(-90 {at_x} {at_y})\">\n"));
    text(&mut svg, at_x, at_y, "middle", "position error [m]");
    svg += "</g>\n";
    for power in x.powers() {
        let at = x.at(10_f64.powi(power));
        rule(&mut svg, (at, TOP), (at, BOTTOM));
        text(&mut svg, at, BOTTOM + 20.0, "middle", &format!("1e{power}"));
    }
    for power in y.powers() {
        let at = y.at(10_f64.powi(power));
        rule(&mut svg, (LEFT, at), (RIGHT, at));
        text(&mut svg, LEFT - 8.0, at + 4.0, "end", &format!("1e{power}"));
    }
    for (index, line) in lines.iter().enumerate() {
        draw(&mut svg, index, line, &x, &y);
    }
    svg += "</svg>\n";
    svg
}

fn draw(svg: &mut String, index: usize, line: &PlotLine, x: &PlotAxis, y: &PlotAxis) {
    let colour = COLOURS[index % COLOURS.len()];
    let places: Vec<(f64, f64)> = line.points.iter().map(|&(dt, error)| (x.at(dt), y.at(error))).collect();
    let path: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    put(
        svg,
        format_args!(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\n",
            path.join(" ")
        ),
    );
    for (x, y) in places {
        put(svg, format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{colour}\"/>\n"));
    }
    let row = TOP + 12.0 + 24.0 * index as f64;
    put(svg, format_args!("<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill=\"{colour}\"/>\n", RIGHT + 20.0, row - 4.0));
    let order = line.order.map_or("none".to_owned(), |order| format!("{order:.2}"));
    text(svg, RIGHT + 32.0, row, "start", &format!("{}: {order}", escape(&line.name)));
}

/// A logarithmic axis of whole decades.
struct PlotAxis {
    decades: RangeInclusive<i32>,
    start: f64,
    end: f64,
}

impl PlotAxis {
    fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Self {
        let powers: Vec<f64> = values.map(f64::log10).filter(|power| power.is_finite()).collect();
        let least = powers.iter().copied().reduce(f64::min).unwrap_or(0.0).floor() as i32;
        let most = powers.iter().copied().reduce(f64::max).unwrap_or(0.0).ceil() as i32;
        Self { decades: least..=most.max(least + 1), start, end }
    }

    fn at(&self, value: f64) -> f64 {
        let (least, most) = (f64::from(*self.decades.start()), f64::from(*self.decades.end()));
        self.start + (value.log10() - least) / (most - least) * (self.end - self.start)
    }

    fn powers(&self) -> RangeInclusive<i32> {
        self.decades.clone()
    }
}

fn rule(svg: &mut String, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
    put(svg, format_args!("<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#cccccc\"/>\n"));
}

fn text(svg: &mut String, x: f64, y: f64, anchor: &str, text: &str) {
    put(svg, format_args!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>\n"));
}

fn put(svg: &mut String, piece: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = svg.write_fmt(piece);
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_is_drawn_whatever_there_is_to_draw() {
        let line = PlotLine { name: "a<b".into(), order: Some(1.0), points: vec![(1e-3, 1e-5), (1e-2, 1e-4)] };
        let bare = PlotLine { name: "none".into(), order: None, points: Vec::new() };
        for lines in [vec![], vec![bare.clone()], vec![line, bare]] {
            let svg = order_plot("Title & more", &lines);
            assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n") && !svg.contains("NaN"), "{svg}");
            assert_eq!(svg.matches("<polyline").count(), lines.len());
        }
    }
}
