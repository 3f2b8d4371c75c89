//! Bodies of both kinds, put together call by call.

use super::{Body, Follow, Impulse, Initial, IntegratorChoice, Pin, Placement, Region, Rotation, TwoLayer};

macro_rules! building {
    ($($kind:ty)*) => {
        $(impl $kind {
            /// With a name that a person reads.
            #[must_use]
            pub fn with_name(self, name: impl Into<String>) -> Self {
                Self { name: name.into(), ..self }
            }

            /// With its model's origin at this point [m, world].
            #[must_use]
            pub fn with_translation(self, translation: impl Into<[f64; 3]>) -> Self {
                Self { placement: Placement { translation: translation.into(), ..self.placement }, ..self }
            }

            /// Turned about its model's origin.
            #[must_use]
            pub fn with_rotation(self, rotation: Rotation) -> Self {
                Self { placement: Placement { rotation, ..self.placement }, ..self }
            }

            /// Stepped through time by this integrator; chosen at the bake unless given.
            #[must_use]
            pub fn with_integrator(self, integrator: impl Into<IntegratorChoice>) -> Self {
                Self { integrator: integrator.into(), ..self }
            }

            /// With this velocity at the start [m/s, world axes].
            #[must_use]
            pub fn with_velocity(self, velocity: impl Into<[f64; 3]>) -> Self {
                Self { initial: Initial { velocity: velocity.into(), ..self.initial }, ..self }
            }

            /// With one named set of particles more.
            #[must_use]
            pub fn with_region(mut self, region: Region) -> Self {
                self.regions.push(region);
                self
            }

            /// With one region more whose motion is prescribed.
            #[must_use]
            pub fn with_pin(mut self, pin: Pin) -> Self {
                self.pins.push(pin);
                self
            }

            /// With one motion more that it follows.
            #[must_use]
            pub fn with_follow(mut self, follow: Follow) -> Self {
                self.follows.push(follow);
                self
            }

            /// With one impulse more that a region is given at the start.
            #[must_use]
            pub fn with_impulse(mut self, impulse: Impulse) -> Self {
                self.impulses.push(impulse);
                self
            }
        })*
    };
}

building! { Body TwoLayer }
