//! Energies of a body by what stores them.

use serde::Serialize;

/// The one list of energies: fields, names in reports and their order all follow from it.
macro_rules! energies {
    ($($(#[$doc:meta])* $name:ident,)+) => {
        /// Energies [J] by what stores them, in the order of reports.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
        pub struct Energies {
            $($(#[$doc])* pub $name: f64,)+
        }

        impl Energies {
            /// The names that energies have in reports.
            pub const NAMES: [&str; [$(stringify!($name)),+].len()] = [$(stringify!($name)),+];

            /// Every energy [J] in the order of [`Self::NAMES`].
            pub fn values(&self) -> [f64; Self::NAMES.len()] {
                [$(self.$name),+]
            }
        }
    };
}

energies! {
    /// Energy of motion.
    kinetic,
    /// Strain energy of the matrix.
    matrix,
    /// Energy of the terms that hold back the zero-energy modes.
    zero_energy,
    /// Stretching energy of the fibres.
    stretching,
    /// Bending energy of the fibres.
    bending,
    /// Energy of springs.
    springs,
    /// Energy of enclosed gas.
    pressure,
    /// Elastic energy of contacts: with the room and panels whole, with other bodies half.
    contact,
    /// Potential energy in the gravity field, zero at the world's origin.
    gravity,
    /// Elastic energy of the springs by which the body is grabbed.
    grab,
    /// Energy of the fibres' twist.
    twisting,
    /// The work that the drives of fibres, sheets, elements, springs, gravity and enclosed gas have done on the body,
    /// counted down from zero: with it the sum stays what it was. What pins, panels, grabs and wind do comes from
    /// outside and is not among the energies.
    activation,
    /// Energy of the sheets' stretch and shear in their surfaces.
    membrane,
    /// Energy of the sheets' bending.
    hinges,
    /// Energy of elements.
    elements,
}

impl Energies {
    /// Every energy [J] with its name, in their order.
    pub fn named(&self) -> [(&'static str, f64); Self::NAMES.len()] {
        let values = self.values();
        std::array::from_fn(|k| (Self::NAMES[k], values[k]))
    }

    /// Sum of all.
    pub fn total(&self) -> f64 {
        self.kinetic + self.potential()
    }

    /// Sum of all but the kinetic energy.
    pub fn potential(&self) -> f64 {
        Self { kinetic: 0.0, ..*self }.values().iter().sum()
    }
}
