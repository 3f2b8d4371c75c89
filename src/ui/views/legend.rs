//! What the colours over the bodies stand for.

use crate::draw::{Colour, colour_map};
use crate::solver::snapshot::FieldKind;
use crate::text::number::three_figures;
use crate::ui::context::Context;
use crate::ui::theme::{self, GRID, Tone};
use egui::{Align2, FontId, Mesh, Pos2, Rect, Sense, Ui, Vec2};

/// Size of the bar [points].
const BAR: Vec2 = Vec2::new(160.0, 10.0);
/// Height of a line of words [points].
const LINE: f32 = 14.0;
/// Parts of the bar, each shaded between the colours of its ends.
const PARTS: u16 = 32;

/// Name with unit, and what exactly is meant.
fn title(kind: FieldKind) -> (&'static str, &'static str) {
    match kind {
        FieldKind::Strain => ("Strain", "Equivalent strain of the matrix, √(2/3 e′:e′) with e = sym(Rᵀ F) − I"),
        FieldKind::Stress => {
            ("Stress [Pa]", "Stress of the matrix after von Mises, √(3/2 s′:s′) with s = 2µ e + λ tr(e) I")
        }
        FieldKind::VolumeFraction => ("Volume fraction", "Share of fibre in the volume"),
        FieldKind::Speed => ("Speed [m/s]", "Length of the velocity"),
    }
}

/// A bar of colours and what it stands for.
struct Scale {
    name: &'static str,
    meaning: &'static str,
    /// What the ends of the bar stand for.
    range: [f64; 2],
    /// The colour at a share of its length.
    colour: fn(f32) -> Colour,
}

/// Name, unit, colours and range of what colours stand for in the result; nothing where there is none.
pub(super) fn legend(ui: &mut Ui, cx: &Context) {
    let snapshot = &cx.simulation.published().snapshot;
    if let Some(field) = &snapshot.field {
        let (name, meaning) = title(field.kind);
        scale(ui, cx.tone, &Scale { name, meaning, range: field.range, colour: colour_map::colour });
    }
    if let Some(tension) = &snapshot.tension {
        let meaning =
            "Force that a fibre carries along itself, l_f EA (l - l0) / l0: pulled warm, slack pale, pressed cool";
        let range = [-tension.range, tension.range];
        let colour = |share: f32| colour_map::signed_colour(2.0 * share - 1.0);
        scale(ui, cx.tone, &Scale { name: "Tension of fibres [N]", meaning, range, colour });
    }
    if snapshot.activation.is_some() {
        let meaning = "What the drive of a fibre comes to; it is as thick as it is short: r / sqrt(1 - c)";
        let (range, colour) = ([0.0, 1.0], colour_map::colour);
        scale(ui, cx.tone, &Scale { name: "Activation of fibres", meaning, range, colour });
    }
}

fn scale(ui: &mut Ui, tone: Tone, Scale { name, meaning, range, colour }: &Scale) {
    let [low, high] = range.map(three_figures);
    ui.add_space(1.5 * GRID);
    let (place, response) = ui.allocate_exact_size(BAR + Vec2::new(0.0, 2.0 * LINE), Sense::hover());
    let spoken = format!("{name} from {low} to {high}");
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &spoken));
    response.on_hover_text(*meaning);
    let painter = ui.painter();
    let pictures = tone.pictures();
    let ink = theme::color(pictures.text);
    // What it lies over may be of any colour.
    let paper = theme::color(pictures.background_top).gamma_multiply(0.8);
    painter.rect_filled(place.expand(GRID), GRID, paper);
    let words = |at: Pos2, align: Align2, text: &str| {
        painter.text(at, align, text, FontId::proportional(11.0), ink);
    };
    words(place.left_top(), Align2::LEFT_TOP, name);
    let bar = Rect::from_min_size(place.min + Vec2::new(0.0, LINE), BAR);
    let mut mesh = Mesh::default();
    for part in 0..=PARTS {
        let share = f32::from(part) / f32::from(PARTS);
        let colour = theme::color(colour(share));
        let x = bar.left() + share * bar.width();
        mesh.colored_vertex(Pos2::new(x, bar.top()), colour);
        mesh.colored_vertex(Pos2::new(x, bar.bottom()), colour);
        if part > 0 {
            let last = 2 * u32::from(part);
            mesh.add_triangle(last - 2, last - 1, last);
            mesh.add_triangle(last - 1, last, last + 1);
        }
    }
    painter.add(mesh);
    words(place.left_bottom(), Align2::LEFT_BOTTOM, &low);
    words(place.right_bottom(), Align2::RIGHT_BOTTOM, &high);
    if range[0] < 0.0 {
        words(place.center_bottom(), Align2::CENTER_BOTTOM, "0");
    }
}
