//! What is said about bodies that overlap at the start.

use super::note::Note;
use super::room;
use crate::scene::Scene;
use crate::solver::overlap::Against;
use crate::solver::world::World;
use crate::text::number::four_figures;
use glam::DVec3;

/// Says what each body overlaps with, how far, what will be done about it and what a person can do.
pub(super) fn note_overlaps(scene: &Scene, world: &World, notes: &mut Vec<Note>) {
    for overlap in world.overlaps() {
        let body = &world.bodies()[overlap.body];
        let (name, particles) = (&body.parts().name, body.state().len());
        let depth = four_figures(overlap.out.length());
        let (what, ways) = match overlap.against {
            Against::Plane(normal) => (format!("the {}", room::side(normal)), "out of it"),
            Against::Panel(panel) => (format!("the panel \"{}\"", world.panels()[panel].id), "out below it"),
            Against::Collider(collider) => {
                (format!("the collider \"{}\"", world.colliders()[collider].name), "out of it")
            }
            Against::Body(other) => (format!("the body \"{}\"", world.bodies()[other].parts().name), "apart"),
        };
        let wholly = if overlap.inside == particles { "wholly " } else { "" };
        let share = match overlap.inside {
            0 => String::new(),
            inside => format!("{inside} of its {particles} particles, "),
        };
        let at = place(overlap.at);
        let will = match &overlap.easing {
            Some(easing) => format!(
                "it is eased {ways} within {} s, at {} m/s at most",
                four_figures(easing.duration()),
                four_figures(easing.speed())
            ),
            None => "the contact is too soft to push it out".to_owned(),
        };
        let text = format!(
            "the body \"{name}\" starts {wholly}inside {what} ({share}around {at} m, {depth} m from the way out); {will}; \
             move it by {} m",
            place(overlap.out)
        );
        let path = format!("{}/placement/translation", scene.body_pointer(overlap.body));
        notes.push(Note { path, text, warning: true });
    }
}

/// A place or a way, with its figures.
fn place(x: DVec3) -> String {
    // What is nothing but round-off beside the longest component is shown as nothing.
    let least = 1e-6 * x.abs().max_element();
    format!("[{}]", x.to_array().map(|x| if x.abs() <= least { "0".to_owned() } else { four_figures(x) }).join(", "))
}
