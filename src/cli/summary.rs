//! What a run has shown, for people.

use super::body_table;
use super::table::{Align, Table, readable};
use crate::scene::one_line;
use crate::sim::{MeasureReport, Report};
use crate::solver::snapshot::BreakPlace;
use crate::solver::world::World;
use crate::text::number::four_figures;

/// The summary of a run that has ended.
pub(super) fn summary(report: &Report, world: &World, source: &str) -> String {
    let name = if report.scene.is_empty() { source.to_owned() } else { one_line(&report.scene) };
    let mut text = format!(
        "{name}: {} s in {} of {} s{}\n",
        four_figures(report.seconds),
        if report.frames == 1 { "1 frame".to_owned() } else { format!("{} frames", report.frames) },
        four_figures(world.plan().frame_seconds),
        match report {
            Report { complete: false, .. } => ", interrupted",
            Report { at_rest: true, .. } => ", at rest",
            _ => "",
        },
    );
    text += &pace(report);
    text += &fallbacks(report);
    for part in [bodies(report, world), measures(&report.measures), breaks(report, world), energies(report)] {
        if !part.is_empty() {
            text += "\n";
            text += &part.render();
        }
    }
    text
}

/// Which implicit steps were not taken as they were meant; nothing where all were.
fn fallbacks(report: &Report) -> String {
    let cut = report.bodies.iter().filter(|body| body.halved_steps > 0);
    cut.map(|body| {
        let (name, steps) = (one_line(&body.name), body.steps);
        let (halved, handed_over) = (body.halved_steps, body.handed_over_steps);
        format!("{name}: of {steps} implicit steps {halved} were halved and {handed_over} parts taken by leap-frog\n")
    })
    .fold(String::new(), |text, line| text + &line)
}

/// How fast the run was, against the clock.
fn pace(report: &Report) -> String {
    let wall = four_figures(report.wall_seconds);
    // Time that passes without a body that moves says nothing about speed.
    let moved = report.bodies.iter().any(|body| body.diverged.is_none());
    match report.real_time_factor {
        factor if factor == 0.0 || !moved => format!("stepped in {wall} s\n"),
        factor if factor < 1.0 => {
            format!("stepped in {wall} s: slow motion, {} times slower than real time\n", four_figures(1.0 / factor))
        }
        factor => format!("stepped in {wall} s: {} times as fast as real time\n", four_figures(factor)),
    }
}

fn bodies(report: &Report, world: &World) -> Table {
    let own = [
        ("time step [s]", Align::Right),
        ("steps a frame", Align::Right),
        ("limited by", Align::Left),
        ("", Align::Left),
    ];
    let mut table = Table::new(body_table::COLUMNS.into_iter().chain(own));
    for ((told, body), substeps) in report.bodies.iter().zip(world.bodies()).zip(&world.plan().substeps) {
        let own = [
            four_figures(told.dt),
            (u64::from(*substeps) * u64::from(world.plan().outer_steps)).to_string(),
            told.limited_by.clone().unwrap_or_else(|| "-".to_owned()),
            if told.diverged.is_some() { "diverged".to_owned() } else { String::new() },
        ];
        table.push(body_table::cells(one_line(&told.name), body).into_iter().chain(own));
    }
    table
}

fn measures(measures: &[MeasureReport]) -> Table {
    let mut table =
        Table::new([("measure", Align::Left), ("kind", Align::Left), ("value", Align::Right), ("unit", Align::Left)]);
    for measure in measures {
        table.push([
            one_line(&measure.name),
            measure.kind.to_owned(),
            readable(&measure.value),
            measure.unit.to_owned(),
        ]);
    }
    table
}

/// Breaks that are listed; of a fibre that crumbles the others are only counted.
const LISTED: usize = 10;

/// Where and when fibres broke, in the order of time within a body.
fn breaks(report: &Report, world: &World) -> Table {
    let mut table = Table::new([
        ("break", Align::Right),
        ("body", Align::Left),
        ("fibre", Align::Left),
        ("at", Align::Left),
        ("time [s]", Align::Right),
    ]);
    for (body, shown) in world.bodies().iter().zip(&report.bodies) {
        for (k, broken) in body.breaks().take(LISTED).enumerate() {
            let fibre = body.parts().fibres.get(broken.fibre as usize).map_or("", |line| &line.id);
            let place = match broken.place {
                BreakPlace::Vertex(vertex) => format!("vertex {vertex}"),
                BreakPlace::Edge(vertex) => format!("between vertices {vertex} and {}", vertex + 1),
            };
            table.push([(k + 1).to_string(), one_line(&shown.name), one_line(fibre), place, four_figures(broken.time)]);
        }
        if shown.breaks > LISTED {
            let others = format!("and {} more", shown.breaks - LISTED);
            table.push([String::new(), one_line(&shown.name), others, String::new(), String::new()]);
        }
    }
    table
}

/// One row an energy, one column a body; energies that no body has are left out.
fn energies(report: &Report) -> Table {
    let bodies = report.bodies.iter().map(|body| (one_line(&body.name), Align::Right));
    let mut table = Table::new([("energy [J]".to_owned(), Align::Left)].into_iter().chain(bodies));
    let named: Vec<_> = report.bodies.iter().map(|body| body.energy.named()).collect();
    let Some(first) = named.first() else { return table };
    for (index, (name, _)) in first.iter().enumerate() {
        let values: Vec<f64> = named.iter().map(|energies| energies[index].1).collect();
        if values.iter().any(|&value| value != 0.0) {
            table.push([(*name).to_owned()].into_iter().chain(values.into_iter().map(four_figures)));
        }
    }
    table
}
