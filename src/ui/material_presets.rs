//! Materials by name: what people know by touch, as the numbers that the matrix takes.

use crate::scene::{Mass, Material};
use crate::text::number::compact;
use egui::{ComboBox, Ui};

/// A material that people know.
struct Preset {
    name: &'static str,
    meaning: &'static str,
    /// Young's modulus [Pa].
    young_modulus: f64,
    poisson_ratio: f64,
    /// Density [kg/m³].
    density: f64,
}

/// From the softest to the stiffest; figures of the usual order for each.
const PRESETS: [Preset; 7] = [
    Preset {
        name: "Jelly",
        meaning: "Wobbles under its own weight",
        young_modulus: 1e4,
        poisson_ratio: 0.45,
        density: 1050.0,
    },
    Preset {
        name: "Sponge",
        meaning: "Light, and hardly wider when it is pressed",
        young_modulus: 3e4,
        poisson_ratio: 0.1,
        density: 80.0,
    },
    Preset { name: "Flesh", meaning: "Soft tissue at rest", young_modulus: 5e4, poisson_ratio: 0.45, density: 1060.0 },
    Preset {
        name: "Rubber",
        meaning: "Keeps its volume and swings back; a step ten times as short as flesh",
        young_modulus: 2e6,
        poisson_ratio: 0.47,
        density: 1100.0,
    },
    Preset { name: "Leather", meaning: "Hardly gives", young_modulus: 5e7, poisson_ratio: 0.4, density: 900.0 },
    Preset {
        name: "Wood",
        meaning: "Rings rather than bends: far slower than real time",
        young_modulus: 1e10,
        poisson_ratio: 0.35,
        density: 600.0,
    },
    Preset {
        name: "Steel",
        meaning: "Rings rather than bends: thousands of times slower than real time",
        young_modulus: 2e11,
        poisson_ratio: 0.3,
        density: 7850.0,
    },
];

impl Preset {
    fn is(&self, material: &Material) -> bool {
        material.young_modulus == self.young_modulus
            && material.poisson_ratio == self.poisson_ratio
            && matches!(material.mass, Mass::Density(density) if density == self.density)
    }

    /// How it is sampled and damped stays as it is.
    fn give(&self, material: &mut Material) {
        material.young_modulus = self.young_modulus;
        material.poisson_ratio = self.poisson_ratio;
        material.mass = Mass::Density(self.density);
    }

    fn explained(&self) -> String {
        let [young, density] = [self.young_modulus, self.density].map(compact);
        format!("{}\nE {young} Pa, nu {}, {density} kg/m³", self.meaning, self.poisson_ratio)
    }
}

/// Lets a person choose a material by its name.
pub(super) fn material_presets(ui: &mut Ui, material: &mut Material) {
    let present = PRESETS.iter().find(|preset| preset.is(material));
    ui.horizontal(|ui| {
        let title = ui.label("Like");
        let shown = present.map_or("Choose…", |preset| preset.name);
        let choice = ComboBox::from_id_salt("material preset").selected_text(shown).show_ui(ui, |ui| {
            for preset in &PRESETS {
                let label = ui.selectable_label(preset.is(material), preset.name).on_hover_text(preset.explained());
                if label.clicked() {
                    preset.give(material);
                }
            }
        });
        choice.response.labelled_by(title.id).on_hover_text("Materials by name: stiffness, thinning and density");
    });
}
