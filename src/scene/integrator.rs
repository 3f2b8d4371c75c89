//! The integrators by name: the one table that files, reports, the command line and the window go by.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a body is stepped through time: as the scene says, or as the bake finds best.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(from = "Word", into = "Word")]
#[schemars(with = "Word")]
pub enum IntegratorChoice {
    /// Leap-frog, unless its step would be far shorter than another's that is as good.
    #[default]
    Automatic,
    /// This one.
    Given(IntegratorKind),
}

impl IntegratorChoice {
    /// Its name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Automatic => "Automatic",
            Self::Given(kind) => kind.name(),
        }
    }
}

impl From<IntegratorKind> for IntegratorChoice {
    fn from(kind: IntegratorKind) -> Self {
        Self::Given(kind)
    }
}

/// Each integrator in the order in which they are offered: `Kind "word" "Name";`, the word as files have it, the name
/// as people read it.
macro_rules! integrators {
    ($($(#[doc = $doc:literal])* $kind:ident $word:literal $name:literal;)*) => {
        /// How a body is stepped through time.
        ///
        #[doc = include_str!("integrators.md")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
        pub enum IntegratorKind {
            $($(#[doc = $doc])* #[serde(rename = $word)] $kind,)*
        }

        /// An integrator's word in files, or the one for none of them.
        #[derive(Serialize, Deserialize, JsonSchema)]
        #[schemars(rename = "IntegratorChoice")]
        enum Word {
            /// What the bake finds best.
            #[serde(rename = "automatic")]
            Automatic,
            $($(#[doc = $doc])* #[serde(rename = $word)] $kind,)*
        }

        impl From<Word> for IntegratorChoice {
            fn from(word: Word) -> Self {
                match word {
                    Word::Automatic => Self::Automatic,
                    $(Word::$kind => Self::Given(IntegratorKind::$kind),)*
                }
            }
        }

        impl From<IntegratorChoice> for Word {
            fn from(choice: IntegratorChoice) -> Self {
                match choice {
                    IntegratorChoice::Automatic => Self::Automatic,
                    $(IntegratorChoice::Given(IntegratorKind::$kind) => Self::$kind,)*
                }
            }
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
    LeapFrog "leap_frog" "Leap-frog";
    /// Fibres implicitly and all else by leap-frog: as long steps as the matrix allows, however stiff the fibres are.
    FibresImplicit "fibres_implicit" "Fibres implicit";
    /// Explicit Euler: order 1, gains energy without damping.
    ExplicitEuler "explicit_euler" "Explicit Euler";
    /// Explicit midpoint: order 2, two evaluations a step.
    Midpoint "midpoint" "Midpoint";
    /// Classical Runge-Kutta: order 4, four evaluations a step.
    Rk4 "rk4" "Runge-Kutta 4";
    /// Symplectic Euler: order 1, one evaluation a step.
    SymplecticEuler "symplectic_euler" "Symplectic Euler";
    /// Velocity Verlet with a predicted velocity: order 2 with damping too, two evaluations a step.
    Verlet "verlet" "Velocity Verlet";
    /// The Feynman Lectures' scheme, positions at whole and velocities at half steps: order 2, one force evaluation a
    /// step. Leap-frog but for rounding.
    Feynman "feynman" "Feynman";
    /// Backward Euler: order 1, stable at any step, takes energy.
    BackwardEuler "backward_euler" "Backward Euler";
    /// Trapezoidal rule and backward difference: order 2, stable at any step, two stages; keeps slow motion.
    TrBdf2 "tr_bdf2" "TR-BDF2";
    /// Two backward Euler stages: order 2, stable at any step; takes spin.
    Sdirk2 "sdirk2" "SDIRK2";
    /// Implicit midpoint: order 2, stable at any step, keeps momenta; stiff motion rings on.
    ImplicitMidpoint "implicit_midpoint" "Implicit midpoint";
    /// Second backward difference: order 2, stable at any step, one stage; takes energy.
    Bdf2 "bdf2" "BDF2";
    /// Newmark with the average acceleration: order 2, stable at any step; stiff motion rings on.
    Newmark "newmark" "Newmark";
}
