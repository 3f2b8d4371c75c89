//! The integrators by name: the one table that files, reports, the command line and the window go by.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Each integrator in the order in which they are offered: `Kind "word" "Name";`, the word as files have it, the name as
/// people read it.
macro_rules! integrators {
    ($($(#[$attribute:meta])* $kind:ident $word:literal $name:literal;)*) => {
        /// How a body is stepped through time.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
        pub enum IntegratorKind {
            $($(#[$attribute])* #[serde(rename = $word)] $kind,)*
        }

        impl IntegratorKind {
            /// All of them, in the order in which they are offered.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$kind),*];

            /// Its word in scene files, in reports and on the command line.
            pub fn word(self) -> &'static str {
                match self {
                    $(Self::$kind => $word,)*
                }
            }

            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $name,)*
                }
            }
        }
    };
}

integrators! {
    /// Kick-drift-kick leap-frog: order 2, one force evaluation a step, keeps momenta and energy.
    #[default]
    LeapFrog "leap_frog" "Leap-frog";
    /// Explicit Euler: order 1, gains energy without damping.
    ExplicitEuler "explicit_euler" "Explicit Euler";
    /// Explicit midpoint: order 2, two evaluations a step.
    Midpoint "midpoint" "Midpoint";
    /// Classical Runge-Kutta: order 4, four evaluations a step.
    Rk4 "rk4" "Runge-Kutta 4";
    /// Symplectic Euler: order 1, one evaluation a step.
    SymplecticEuler "symplectic_euler" "Symplectic Euler";
    /// Velocity Verlet with a predicted velocity: order 2 with damping too, two evaluations a step.
    Verlet "verlet" "Verlet";
    /// Backward Euler: order 1, stable at any step, takes energy.
    BackwardEuler "backward_euler" "Backward Euler";
}
