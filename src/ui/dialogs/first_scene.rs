//! How a first scene is made, step by step.

use super::answer::Answer;
use crate::ui::theme::GRID;
use egui::{RichText, ScrollArea, Ui};

/// What is to come about, and how.
const STEPS: [(&str, &str); 9] = [
    ("An empty scene", "Ctrl+Shift+N: a floor, and nothing on it."),
    (
        "A body in the shape of a model",
        "Drop an OBJ, STL, PLY or glTF file on the window, or Body > Add a model…. It is filled with as many particles as \
         run in real time, and stands a little above the floor.",
    ),
    (
        "A ball beside it",
        "Body > Add a ball. What is added is chosen: G moves it, R turns it, S scales it, by the pointer or by numbers; X, Y \
         and Z lock an axis. The same is done by its handles in the result view, and on the right under Place and shape.",
    ),
    ("What the ball is made of", "On the right, Material > Like > Jelly. The numbers below say what that means."),
    ("The body to draw into", "Click the model in the result view, or its name in the list on the left."),
    (
        "A fibre",
        "Drag a stroke in the front view, then the same fibre as it is seen from the side, between the guides. Then a second \
         one. Each stiffens the body along itself: draw them askew, and it twists as it lands.",
    ),
    ("A pin", "On the right, World > Pin a region > top: what is pinned stays where it is, the rest hangs from it."),
    ("What comes of it", "Space plays and pauses, Ctrl+R goes back to the start, a drag in the result view pulls."),
    ("To keep it", "Ctrl+S, a name, Enter. Every step can be undone with Ctrl+Z."),
];

/// Shows the steps.
pub(super) fn first_scene(ui: &mut Ui) -> Answer {
    ui.set_width(520.0);
    ui.heading("First scene");
    let room = 0.7 * ui.ctx().content_rect().height();
    ScrollArea::vertical().max_height(room).show(ui, |ui| {
        for (number, (what, how)) in (1..).zip(STEPS) {
            ui.add_space(GRID);
            ui.label(RichText::new(format!("{number}  {what}")).strong());
            ui.label(how);
        }
        ui.add_space(GRID);
    });
    if ui.button("Close").clicked() { Answer::Closed } else { Answer::None }
}
