//! Everything that can be asked of the program, in one list: menu, shortcut, tooltip, palette and help are made of it.

use egui::{Key, KeyboardShortcut, Modifiers};

/// Something that a person asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Action {
    /// Start from the built-in scene.
    New,
    /// Open a scene.
    Open,
    /// Save the scene where it came from.
    Save,
    /// Save the scene elsewhere.
    SaveAs,
    /// Close the window.
    Quit,
    /// Take the last change back.
    Undo,
    /// Make it again.
    Redo,
    /// Delete the selected fibres or vertices.
    Delete,
    /// Copy the selected fibres.
    Duplicate,
    /// Select every fibre or vertex.
    SelectAll,
    /// Select by a box.
    BoxSelect,
    /// Edit vertices, or whole fibres again.
    Vertices,
    /// Move the selection.
    Move,
    /// Turn the selection.
    Turn,
    /// Mirror the selection along X.
    MirrorX,
    /// Mirror it along Y.
    MirrorY,
    /// Mirror it along Z.
    MirrorZ,
    /// Run fibres the other way.
    Reverse,
    /// Smooth fibres.
    Smooth,
    /// Space the vertices of fibres evenly.
    Resample,
    /// Lay fibres under the surface.
    SnapToSurface,
    /// Part fibres from their strokes.
    Detach,
    /// Insert vertices.
    InsertVertex,
    /// Cut a fibre in two.
    Split,
    /// Draw one stroke again.
    Redraw,
    /// Paint the volume fraction.
    Paint,
    /// Hide fibres.
    Hide,
    /// Show what is hidden.
    ShowAll,
    /// Run or hold the simulation.
    PlayPause,
    /// Advance one frame.
    Step,
    /// Back to the start.
    Reset,
    /// Let go of everything that is pinned by dragging.
    ReleasePins,
    /// Fit the views to the selected fibre.
    Frame,
    /// Fit the views to everything.
    FrameAll,
    /// See through the solid.
    XRay,
    /// Show the particles.
    Particles,
    /// Show springs and layers.
    Springs,
    /// Show the strokes that were drawn.
    Strokes,
    /// Show the grid.
    Grid,
    /// Switch between light and dark.
    Theme,
    /// Find an action by its name.
    Palette,
    /// List keys and gestures.
    Help,
}

/// Menu in which an action stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files.
    File,
    /// The document.
    Edit,
    /// Fibres.
    Fibre,
    /// The running simulation.
    Simulation,
    /// What is seen.
    View,
    /// Help.
    Help,
}

impl Menu {
    /// All menus in their order.
    pub const ALL: [Self; 6] = [Self::File, Self::Edit, Self::Fibre, Self::Simulation, Self::View, Self::Help];

    /// Title.
    pub fn title(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Fibre => "Fibre",
            Self::Simulation => "Simulation",
            Self::View => "View",
            Self::Help => "Help",
        }
    }
}

impl Action {
    /// All actions in the order of the menus.
    pub const ALL: [Self; 42] = [
        Self::New,
        Self::Open,
        Self::Save,
        Self::SaveAs,
        Self::Quit,
        Self::Undo,
        Self::Redo,
        Self::Delete,
        Self::Duplicate,
        Self::SelectAll,
        Self::BoxSelect,
        Self::Vertices,
        Self::Move,
        Self::Turn,
        Self::MirrorX,
        Self::MirrorY,
        Self::MirrorZ,
        Self::Reverse,
        Self::Smooth,
        Self::Resample,
        Self::SnapToSurface,
        Self::Detach,
        Self::InsertVertex,
        Self::Split,
        Self::Redraw,
        Self::Paint,
        Self::Hide,
        Self::ShowAll,
        Self::PlayPause,
        Self::Step,
        Self::Reset,
        Self::ReleasePins,
        Self::Frame,
        Self::FrameAll,
        Self::XRay,
        Self::Particles,
        Self::Springs,
        Self::Strokes,
        Self::Grid,
        Self::Theme,
        Self::Palette,
        Self::Help,
    ];

    /// Name in menus, palette and help; an ellipsis where more is asked.
    pub fn name(self) -> &'static str {
        match self {
            Self::New => "New from the soft bar",
            Self::Open => "Open…",
            Self::Save => "Save",
            Self::SaveAs => "Save as…",
            Self::Quit => "Quit",
            Self::Undo => "Undo",
            Self::Redo => "Redo",
            Self::Delete => "Delete",
            Self::Duplicate => "Duplicate",
            Self::SelectAll => "Select all",
            Self::BoxSelect => "Select by a box",
            Self::Vertices => "Edit vertices",
            Self::Move => "Move",
            Self::Turn => "Rotate",
            Self::MirrorX => "Mirror along X",
            Self::MirrorY => "Mirror along Y",
            Self::MirrorZ => "Mirror along Z",
            Self::Reverse => "Reverse",
            Self::Smooth => "Smooth",
            Self::Resample => "Resample",
            Self::SnapToSurface => "Snap to surface",
            Self::Detach => "Detach from strokes",
            Self::InsertVertex => "Insert vertices",
            Self::Split => "Split at vertex",
            Self::Redraw => "Redraw one stroke",
            Self::Paint => "Paint volume fraction",
            Self::Hide => "Hide",
            Self::ShowAll => "Show all",
            Self::PlayPause => "Play or pause",
            Self::Step => "Advance one frame",
            Self::Reset => "Back to the start",
            Self::ReleasePins => "Release pinned drags",
            Self::Frame => "Frame selection",
            Self::FrameAll => "Frame everything",
            Self::XRay => "See through the solid",
            Self::Particles => "Show particles",
            Self::Springs => "Show springs",
            Self::Strokes => "Show strokes",
            Self::Grid => "Show grid",
            Self::Theme => "Light or dark",
            Self::Palette => "Command palette…",
            Self::Help => "Keys and gestures",
        }
    }

    /// What it does, in a sentence.
    pub fn tooltip(self) -> &'static str {
        match self {
            Self::New => "Starts over with the built-in scene",
            Self::Open => "Opens a scene or a model; dropping one on the window does the same",
            Self::Save => "Writes the scene to its file",
            Self::SaveAs => "Writes the scene to another file",
            Self::Quit => "Closes the window",
            Self::Undo => "Takes the last change of the scene back",
            Self::Redo => "Makes the change that was taken back again",
            Self::Delete => "Deletes the selected fibres or vertices",
            Self::Duplicate => "Copies the selected fibres and moves the copies with the pointer",
            Self::SelectAll => "Selects every fibre of the body, or every vertex of the fibre",
            Self::BoxSelect => "Selects what a box is dragged around; Shift adds",
            Self::Vertices => "Edits the vertices of the selected fibre, or whole fibres again",
            Self::Move => "Moves the selection with the pointer; X, Y and Z lock an axis, numbers are taken in mm",
            Self::Turn => {
                "Turns the selection about its middle; X, Y and Z choose an axis, numbers are taken in degrees"
            }
            Self::MirrorX => "Mirrors the selected fibres left to right in the middle of the body",
            Self::MirrorY => "Mirrors the selected fibres top to bottom in the middle of the body",
            Self::MirrorZ => "Mirrors the selected fibres front to back in the middle of the body",
            Self::Reverse => "Runs the selected fibres from their other end",
            Self::Smooth => "Smooths the selected fibres; their ends stay",
            Self::Resample => "Spaces the vertices of the selected fibres evenly, as far apart as the particles",
            Self::SnapToSurface => "Lays the selected fibres or vertices half a particle spacing under the surface",
            Self::Detach => "Keeps the selected fibres as vertices and forgets the strokes that they were drawn by",
            Self::InsertVertex => "Puts a vertex between selected ones that stand beside each other",
            Self::Split => "Cuts the fibre in two at the selected vertex",
            Self::Redraw => "Takes the next stroke in place of the one that the selected fibre has in that view",
            Self::Paint => "Takes up a brush that paints how much of the body is fibre, on the body in the result view",
            Self::Hide => "Hides the selected fibres; they act all the same",
            Self::ShowAll => "Shows every hidden fibre of the body",
            Self::PlayPause => "Runs or holds the simulation",
            Self::Step => "Advances the simulation by one frame and holds it",
            Self::Reset => "Puts the simulation back to the start of the scene",
            Self::ReleasePins => "Lets go of every point that P has pinned while dragging",
            Self::Frame => "Fits every view to the selected fibre, or to everything",
            Self::FrameAll => "Fits every view to everything",
            Self::XRay => "Shows the fibres through the solid in the result view",
            Self::Particles => "Shows material particles cool and structure particles warm",
            Self::Springs => "Shows the springs of two-layer bodies by kind, outer particles cool and inner ones warm",
            Self::Strokes => {
                "Shows the strokes of every fibre in the result view, in the planes in which they were drawn"
            }
            Self::Grid => "Shows the grid of the result view",
            Self::Theme => "Switches between the light and the dark theme",
            Self::Palette => "Finds any of these by its name",
            Self::Help => "Lists every key and gesture",
        }
    }

    /// Menu in which it stands.
    pub fn menu(self) -> Menu {
        match self {
            Self::New | Self::Open | Self::Save | Self::SaveAs | Self::Quit => Menu::File,
            Self::Undo
            | Self::Redo
            | Self::Delete
            | Self::Duplicate
            | Self::SelectAll
            | Self::BoxSelect
            | Self::Hide
            | Self::ShowAll => Menu::Edit,
            Self::Vertices
            | Self::Move
            | Self::Turn
            | Self::MirrorX
            | Self::MirrorY
            | Self::MirrorZ
            | Self::Reverse
            | Self::Smooth
            | Self::Resample
            | Self::SnapToSurface
            | Self::Detach
            | Self::InsertVertex
            | Self::Split
            | Self::Redraw
            | Self::Paint => Menu::Fibre,
            Self::PlayPause | Self::Step | Self::Reset | Self::ReleasePins => Menu::Simulation,
            Self::Frame
            | Self::FrameAll
            | Self::XRay
            | Self::Particles
            | Self::Springs
            | Self::Strokes
            | Self::Grid
            | Self::Theme => Menu::View,
            Self::Palette | Self::Help => Menu::Help,
        }
    }

    /// Whether it is about the selected fibres.
    pub fn edits_fibres(self) -> bool {
        self.menu() == Menu::Fibre || (self.menu() == Menu::Edit && !matches!(self, Self::Undo | Self::Redo))
    }

    /// Keys; the first is shown.
    pub fn shortcuts(self) -> &'static [KeyboardShortcut] {
        const fn plain(key: Key) -> KeyboardShortcut {
            KeyboardShortcut::new(Modifiers::NONE, key)
        }
        const fn alt(key: Key) -> KeyboardShortcut {
            KeyboardShortcut::new(Modifiers::ALT, key)
        }
        const fn shift(key: Key) -> KeyboardShortcut {
            KeyboardShortcut::new(Modifiers::SHIFT, key)
        }
        const fn ctrl(key: Key) -> KeyboardShortcut {
            KeyboardShortcut::new(Modifiers::COMMAND, key)
        }
        const fn ctrl_shift(key: Key) -> KeyboardShortcut {
            KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
        }
        match self {
            Self::New => const { &[ctrl(Key::N)] },
            Self::Open => const { &[ctrl(Key::O)] },
            Self::Save => const { &[ctrl(Key::S)] },
            Self::SaveAs => const { &[ctrl_shift(Key::S)] },
            Self::Quit => const { &[ctrl(Key::Q)] },
            Self::Undo => const { &[ctrl(Key::Z)] },
            Self::Redo => const { &[ctrl_shift(Key::Z), ctrl(Key::Y)] },
            Self::Delete => const { &[plain(Key::Delete), plain(Key::X)] },
            Self::Duplicate => const { &[shift(Key::D)] },
            Self::SelectAll => const { &[plain(Key::A)] },
            Self::BoxSelect => const { &[plain(Key::B)] },
            Self::Vertices => const { &[plain(Key::Tab)] },
            Self::Move => const { &[plain(Key::G)] },
            Self::Turn => const { &[plain(Key::R)] },
            Self::InsertVertex => const { &[plain(Key::I)] },
            Self::Split => const { &[plain(Key::K)] },
            Self::Redraw => const { &[plain(Key::D)] },
            Self::Paint => const { &[plain(Key::V)] },
            Self::Hide => const { &[plain(Key::H)] },
            Self::ShowAll => const { &[alt(Key::H)] },
            Self::MirrorX
            | Self::MirrorY
            | Self::MirrorZ
            | Self::Reverse
            | Self::Smooth
            | Self::Resample
            | Self::SnapToSurface
            | Self::Detach => &[],
            Self::PlayPause => const { &[plain(Key::Space)] },
            Self::Step => const { &[plain(Key::Period)] },
            Self::Reset => const { &[ctrl(Key::R)] },
            Self::ReleasePins => const { &[ctrl_shift(Key::P)] },
            Self::Frame => const { &[plain(Key::F)] },
            Self::FrameAll => const { &[plain(Key::Home)] },
            Self::XRay => const { &[alt(Key::Z)] },
            Self::Particles => const { &[alt(Key::P)] },
            Self::Springs => const { &[alt(Key::S)] },
            Self::Strokes => const { &[alt(Key::K)] },
            Self::Grid => const { &[alt(Key::G)] },
            Self::Theme => const { &[alt(Key::T)] },
            Self::Palette => const { &[ctrl(Key::P)] },
            Self::Help => const { &[plain(Key::F1)] },
        }
    }
}

/// Gestures of the pointer and single keys that are no actions, for the help.
pub const GESTURES: [(&str, &str); 15] = [
    ("Click on a fibre, Shift + click", "selects it, selects it too"),
    ("Drag an arrow, the square, the ring", "moves along an axis, moves freely, turns"),
    ("X, Y, Z, numbers, Shift, Ctrl while moving", "lock an axis, mm or degrees, finely, in steps"),
    ("Drag a vertex", "moves it, while vertices are edited"),
    ("Left drag in a drawing view", "draws a stroke"),
    ("Escape", "takes the last stroke back"),
    ("Left drag on a body in the result view", "pulls it"),
    ("P while pulling", "leaves the point pinned where it is"),
    ("Middle drag, Alt + left drag", "turns the result view, moves a drawing view"),
    ("Shift + middle drag, Alt + middle drag", "moves the view"),
    ("Wheel, Alt + right drag", "moves nearer or further"),
    ("1, 3, 7, the ends of the axes", "shows the result from the front, the side, the top"),
    ("Ctrl + 1, 3, 7", "shows it from the other side"),
    ("5", "changes between parallel and perspective"),
    ("Drop a scene or a model on the window", "opens it"),
];
