//! What a person chooses once, for every scene: the hand's gestures, colours, size and memory of the window.

use super::navigation::Navigation;
use super::theme::{GRID, Tone};
use egui::{Grid, RichText, Ui};

/// Sizes of the interface that can be chosen [%].
const SIZES: [u16; 8] = [75, 90, 100, 110, 125, 150, 175, 200];

/// Memory for the motion that can be chosen [MiB].
pub(crate) const MEMORY: [usize; 7] = [128, 256, 512, 1024, 2048, 4096, 8192];

/// Height of a screen [points] that the interface is made for at 100 %.
const USUAL_HEIGHT: f32 = 1080.0;

/// How the window is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Preferences {
    /// Whose gestures move the cameras.
    pub navigation: Navigation,
    /// Light or dark.
    pub tone: Tone,
    /// Size of the interface [%] of what the system asks for.
    pub size: u16,
    /// Memory that frames of the motion may take [MiB].
    pub memory: usize,
}

/// What a person has done with them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Something was chosen.
    Changed,
    /// They are right as they are.
    Closed,
    /// The list of all keys is to be shown.
    Keys,
}

impl Preferences {
    /// Asks for them. What is chosen holds at once.
    pub(crate) fn ask(&mut self, ui: &mut Ui) -> Option<Asked> {
        let before = *self;
        ui.set_width(460.0);
        ui.heading("Preferences");
        ui.add_space(GRID);
        Grid::new("preferences").num_columns(2).spacing([4.0 * GRID, 2.0 * GRID]).show(ui, |ui| {
            ui.label("Cameras move as in");
            ui.horizontal(|ui| {
                for each in Navigation::ALL {
                    ui.selectable_value(&mut self.navigation, each, each.name());
                }
            });
            ui.end_row();
            for (gesture, effect) in self.navigation.gestures() {
                ui.label(RichText::new(effect).small().weak());
                ui.label(RichText::new(gesture).small());
                ui.end_row();
            }
            ui.label("Theme");
            ui.horizontal(|ui| {
                ui.selectable_value(&mut self.tone, Tone::Light, "Light");
                ui.selectable_value(&mut self.tone, Tone::Dark, "Dark");
            });
            ui.end_row();
            ui.label("Size of the interface");
            choice(ui, &mut self.size, &SIZES, |size| format!("{size} %"));
            ui.end_row();
            ui.label("Memory for the motion");
            choice(ui, &mut self.memory, &MEMORY, |of| memory_name(*of));
            ui.end_row();
        });
        ui.add_space(GRID);
        let keys = ui.horizontal(|ui| {
            let closed = ui.button("Close").clicked().then_some(Asked::Closed);
            ui.button("Keys and gestures…").clicked().then_some(Asked::Keys).or(closed)
        });
        keys.inner.or((*self != before).then_some(Asked::Changed))
    }
}

/// A button that shows what is chosen and opens a list of what can be.
fn choice<T: PartialEq + Copy>(ui: &mut Ui, chosen: &mut T, all: &[T], name: impl Fn(&T) -> String) {
    ui.menu_button(name(chosen), |ui| {
        for each in all {
            if ui.selectable_value(chosen, *each, name(each)).clicked() {
                ui.close();
            }
        }
    });
}

/// So many MiB, as they are written.
pub(crate) fn memory_name(mebibytes: usize) -> String {
    if mebibytes < 1024 { format!("{mebibytes} MiB") } else { format!("{} GiB", mebibytes / 1024) }
}

/// The size of the interface [%] with which it is legible at first on a screen so high [points].
pub(crate) fn first_size(height: f32) -> u16 {
    let fits = |size: &&u16| f32::from(**size) <= 100.0 * height / USUAL_HEIGHT;
    SIZES.iter().rev().find(fits).map_or(100, |size| (*size).max(100))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interface_is_as_large_as_a_screen_without_a_scale_of_its_own_asks_for() {
        for (height, size) in [(0.0, 100), (768.0, 100), (1080.0, 100), (1440.0, 125), (2160.0, 200), (4320.0, 200)] {
            assert_eq!(first_size(height), size, "{height}");
        }
    }
}
