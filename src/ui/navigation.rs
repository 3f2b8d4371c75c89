//! How the cameras are moved: by the gestures of the program that a person's hand knows.

use egui::{Event, Modifiers, MouseWheelUnit, PointerButton, Ui, Vec2};
use serde::{Deserialize, Serialize};

/// Points that a notch of a wheel counts as.
const NOTCH: f32 = 40.0;

/// Whose gestures move the cameras.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Navigation {
    /// Those of Blender, and with Alt those of Maya.
    #[default]
    Blender,
    /// Those of Maya: nothing without Alt.
    Maya,
    /// Those of Houdini: as Maya's, and the middle button moves.
    Houdini,
    /// Two fingers on a touchpad in place of a middle button.
    Laptop,
}

/// What becomes of a camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CameraMove {
    /// It turns about what it looks at; a drawing view, which does not turn, is moved.
    Turn,
    /// It is moved along the picture.
    Pan,
    /// It comes nearer or goes further.
    Zoom,
}

impl Navigation {
    /// All there are.
    pub(crate) const ALL: [Self; 4] = [Self::Blender, Self::Maya, Self::Houdini, Self::Laptop];

    /// Name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Blender => "Blender",
            Self::Maya => "Maya",
            Self::Houdini => "Houdini",
            Self::Laptop => "Laptop",
        }
    }

    /// Which gestures turn, move and bring nearer.
    pub(crate) fn gestures(self) -> [(&'static str, &'static str); 3] {
        const TURNS: &str = "turns the result view, moves a drawing view";
        const PANS: &str = "moves the view";
        const ZOOMS: &str = "moves nearer or further";
        match self {
            Self::Blender => [
                ("Middle drag, Alt + left drag", TURNS),
                ("Shift + middle drag, Alt + middle drag, Alt + Shift + left drag", PANS),
                ("Wheel, Ctrl + middle drag, Alt + right drag, pinch", ZOOMS),
            ],
            Self::Maya => [
                ("Alt + left drag", TURNS),
                ("Alt + middle drag, Alt + Shift + left drag", PANS),
                ("Wheel, Alt + right drag, pinch", ZOOMS),
            ],
            Self::Houdini => [
                ("Alt + left drag", TURNS),
                ("Middle drag, Alt + middle drag, Alt + Shift + left drag", PANS),
                ("Wheel, Alt + right drag, pinch", ZOOMS),
            ],
            Self::Laptop => [
                ("Two fingers, Alt + left drag", TURNS),
                ("Shift + two fingers, Alt + Shift + left drag", PANS),
                ("Pinch, Ctrl + two fingers, Alt + right drag", ZOOMS),
            ],
        }
    }

    /// What can be done where bodies are seen.
    pub(crate) fn hint(self) -> &'static str {
        match self {
            Self::Blender => "Drag a body to pull it; middle drag turns the view, the wheel comes closer",
            Self::Maya | Self::Houdini => "Drag a body to pull it; Alt + drag turns the view, the wheel comes closer",
            Self::Laptop => "Drag a body to pull it; two fingers turn the view, a pinch comes closer",
        }
    }

    /// What a drag by a button does to the camera; none where it belongs to the tools.
    pub(crate) fn dragged(self, button: PointerButton, modifiers: Modifiers) -> Option<CameraMove> {
        let Modifiers { alt, shift, .. } = modifiers;
        match button {
            PointerButton::Primary if alt && shift => Some(CameraMove::Pan),
            PointerButton::Primary if alt => Some(CameraMove::Turn),
            PointerButton::Secondary if alt => Some(CameraMove::Zoom),
            PointerButton::Middle if alt => Some(CameraMove::Pan),
            PointerButton::Middle => match self {
                Self::Blender | Self::Laptop if shift => Some(CameraMove::Pan),
                Self::Blender | Self::Laptop if modifiers.command => Some(CameraMove::Zoom),
                Self::Blender | Self::Laptop => Some(CameraMove::Turn),
                Self::Houdini => Some(CameraMove::Pan),
                Self::Maya => None,
            },
            _ => None,
        }
    }

    /// What a wheel, or two fingers that move, do to the camera, and by how much [points].
    pub(crate) fn scrolled(self, ui: &Ui) -> Option<(CameraMove, Vec2)> {
        if self != Self::Laptop {
            let by = ui.input(egui::InputState::smooth_scroll_delta);
            return (by.y != 0.0).then_some((CameraMove::Zoom, by));
        }
        // As the fingers move: with Shift held only their sum would be left, as one goes through a wide page.
        let moved = |(sum, shift): (Vec2, bool), event: &Event| match event {
            Event::MouseWheel { unit, delta, modifiers, .. } if !modifiers.command => {
                let scale = if *unit == MouseWheelUnit::Point { 1.0 } else { NOTCH };
                (sum + scale * *delta, shift || modifiers.shift)
            }
            _ => (sum, shift),
        };
        let (by, shift) = ui.input(|input| input.events.iter().fold((Vec2::ZERO, false), moved));
        let what = if shift { CameraMove::Pan } else { CameraMove::Turn };
        (by != Vec2::ZERO).then_some((what, by))
    }
}
