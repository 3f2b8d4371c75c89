//! The order plot: errors over steps, log-log, as SVG.

use super::svg::{Canvas, Scale};
use crate::scene::one_line;

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

/// The plot of these lines.
pub(super) fn order_plot(title: &str, lines: &[PlotLine]) -> String {
    let points = || lines.iter().flat_map(|line| &line.points);
    let scales = [Scale::logarithmic(points().map(|point| point.0)), Scale::logarithmic(points().map(|point| point.1))];
    let mut canvas = Canvas::new(&one_line(title), ["time step [s]", "position error [m]"], scales);
    for (index, line) in lines.iter().enumerate() {
        let order = line.order.map_or("none".to_owned(), |order| format!("{order:.2}"));
        canvas.line(index, &format!("{}: {order}", line.name), &line.points);
    }
    canvas.finish()
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
