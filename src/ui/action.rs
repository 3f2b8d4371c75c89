//! Everything that can be asked of the program, in one list: menu, shortcut, tooltip, palette and help are made of it.

pub(crate) use super::menu::Menu;
use egui::{Key, KeyboardShortcut, Modifiers};

/// What there is to know of an action.
struct Entry {
    menu: Menu,
    name: &'static str,
    tooltip: &'static str,
    shortcuts: &'static [KeyboardShortcut],
}

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

/// Each action in the order of the menus: `Action in Menu [keys] "name": "tooltip";`. The first key is shown; a name
/// ends in an ellipsis where more is asked.
macro_rules! actions {
    ($($action:ident in $menu:ident [$($key:expr),*] $name:literal: $tooltip:literal;)*) => {
        /// Something that a person asks for.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Action {
            $(#[doc = $tooltip] $action,)*
        }

        impl Action {
            const COUNT: usize = [$($name),*].len();

            /// All actions in the order of the menus.
            pub const ALL: [Self; Self::COUNT] = [$(Self::$action),*];

            fn entry(self) -> Entry {
                match self {
                    $(Self::$action => Entry {
                        menu: Menu::$menu,
                        name: $name,
                        tooltip: $tooltip,
                        shortcuts: const { &[$($key),*] },
                    },)*
                }
            }
        }
    };
}

actions! {
    New in File [ctrl(Key::N)] "New from the soft bar": "Starts over with the built-in scene";
    NewEmpty in File [ctrl_shift(Key::N)] "New, empty": "Starts over with a floor and nothing on it";
    Open in File [ctrl(Key::O)] "Open…": "Opens a scene or a model; dropping one on the window does the same";
    Examples in File [ctrl(Key::E)] "Examples…":
        "Shows every scene that ships, with a picture and what to look at";
    Reload in File [] "Reload": "Takes the scene as its file holds it";
    Save in File [ctrl(Key::S)] "Save": "Writes the scene to its file";
    SaveAs in File [ctrl_shift(Key::S)] "Save as…": "Writes the scene to another file";
    Export in File [] "Export readings…":
        "Writes energies, momenta and measures of every frame since the start as a table, CSV";
    ExportMotion in File [] "Export motion…":
        "Writes the motion for other programs: USD, point caches, glTF, OBJ, PLY, tables, moving pictures";
    SaveClip in File [] "Save clip…": "Saves the kept frames, as the result view shows them, as a moving picture";
    SaveTurntable in File [] "Save turntable…": "Saves what is shown, seen from all around, as a moving picture";
    CopyPicture in File [] "Copy picture": "Puts the picture of the result view on the clipboard";
    SaveJournal in File [] "Save journal":
        "Writes what was asked of the motion since its start beside the scene; `sinew replay` makes it again";
    Recover in File [] "Recover unsaved…": "Lists changes that were not saved when the program ended";
    Quit in File [ctrl(Key::Q)] "Quit": "Closes the window";
    Undo in Edit [ctrl(Key::Z)] "Undo": "Takes the last change of the scene back";
    Redo in Edit [ctrl_shift(Key::Z), ctrl(Key::Y)] "Redo": "Makes the change that was taken back again";
    Delete in Edit [plain(Key::Delete), plain(Key::X)] "Delete": "Deletes the selected fibres, vertices, sheet, pin or body";
    Duplicate in Edit [shift(Key::D)] "Duplicate": "Copies the selected fibres or body and moves the copy with the pointer; of a sheet, beside it";
    Cut in Edit [ctrl(Key::X)] "Cut": "Puts the selected fibres, sheet or body on the clipboard and takes them away";
    Copy in Edit [ctrl(Key::C)] "Copy": "Puts the selected fibres, sheet or body on the clipboard, for this scene or another one";
    Paste in Edit [ctrl(Key::V)] "Paste": "Puts fibres, a sheet or a pattern of the clipboard into the body, or its body into the scene";
    SelectAll in Edit [plain(Key::A), ctrl(Key::A)] "Select all": "Selects every fibre of the body, or every vertex of the fibre";
    BoxSelect in Edit [plain(Key::B)] "Select by a box": "Selects what a box is dragged around; Shift adds";
    Preferences in Edit [ctrl(Key::Comma)] "Preferences…": "Gestures of the camera, theme, size of the interface, memory";
    AddBox in Body [] "Add a box": "Adds a soft box where there is room";
    AddBall in Body [] "Add a ball": "Adds a soft ball where there is room";
    AddCylinder in Body [] "Add a cylinder": "Adds a soft cylinder where there is room";
    AddCapsule in Body [] "Add a capsule": "Adds a soft cylinder with round ends where there is room";
    AddTorus in Body [] "Add a torus": "Adds a soft ring where there is room";
    AddModel in Body [] "Add a model…": "Adds a soft solid in the shape of a model to the scene";
    AddSegment in Body [] "Add a two-layer segment": "Adds two particles and a spring where there is room";
    AddRing in Body [] "Add a two-layer ring": "Adds a ring in a plane with gas in it where there is room";
    AddBalloon in Body [] "Add a two-layer ball": "Adds a ball with gas in it where there is room";
    AddLayered in Body [] "Add a two-layer model…": "Adds the surface of a closed model with gas in it to the scene";
    DrawTool in Fibre [plain(Key::E)] "Draw tool": "A drag in a drawing view draws a stroke, wherever it begins";
    SheetTool in Fibre [shift(Key::E)] "Sheet tool":
        "A drag in a drawing view draws a stroke of a sheet: the first is swept along the second";
    SelectTool in Fibre [plain(Key::W)] "Select tool":
        "A drag in a drawing view moves the selection by its handles, or elsewhere selects by a box";
    Vertices in Fibre [plain(Key::Tab)] "Edit vertices":
        "Edits the vertices of the selected fibre, or whole fibres again";
    Move in Fibre [plain(Key::G)] "Move":
        "Moves the selection with the pointer; X, Y and Z lock an axis, numbers are taken in mm";
    Turn in Fibre [plain(Key::R)] "Rotate":
        "Turns the selection about its middle; X, Y and Z choose an axis, numbers are taken in degrees";
    Scale in Fibre [plain(Key::S)] "Scale":
        "Scales the selection with the pointer; a number is taken as a factor. A body keeps its material";
    MirrorX in Fibre [] "Mirror along X": "Mirrors the selected fibres or sheet left to right in the middle of the body";
    MirrorY in Fibre [] "Mirror along Y": "Mirrors the selected fibres or sheet top to bottom in the middle of the body";
    MirrorZ in Fibre [] "Mirror along Z": "Mirrors the selected fibres or sheet front to back in the middle of the body";
    MirrorCopyX in Fibre [] "Mirrored copy along X": "Copies the selected fibres or sheet, left for right";
    MirrorCopyY in Fibre [] "Mirrored copy along Y": "Copies the selected fibres or sheet, top for bottom";
    MirrorCopyZ in Fibre [] "Mirrored copy along Z": "Copies the selected fibres or sheet, front for back";
    Reverse in Fibre [] "Reverse": "Runs the selected fibres from their other end";
    Smooth in Fibre [] "Smooth": "Smooths the selected fibres; their ends stay";
    Resample in Fibre [] "Resample": "Spaces the vertices of the selected fibres evenly, as far apart as the particles";
    SnapToSurface in Fibre [] "Snap to surface":
        "Lays the selected fibres or vertices half a particle spacing under the surface";
    Detach in Fibre [] "Detach from strokes":
        "Keeps the selected fibres as vertices and forgets the strokes that they were drawn by";
    InsertVertex in Fibre [plain(Key::I)] "Insert vertices":
        "Puts a vertex between selected ones that stand beside each other";
    Split in Fibre [plain(Key::K)] "Split at vertex": "Cuts the fibre in two at the selected vertex";
    Redraw in Fibre [plain(Key::D)] "Redraw one stroke":
        "Takes the next stroke in place of the one that the selected fibre has in that view";
    Paint in Fibre [plain(Key::V)] "Paint volume fraction":
        "Takes up a brush that paints how much of the body is fibre, or follows a motion, in the result view";
    Patterns in Fibre [] "Patterns": "Shows layouts of fibres that can be fitted to the body and added to it";
    KeepPattern in Fibre [] "Save selection as pattern…":
        "Keeps the selected fibres, or all of them, as a pattern of your own";
    ImportFibres in Fibre [] "Import fibres…": "Takes lines of a file (OBJ, CSV, JSON) as fibres of the body";
    ExportFibres in Fibre [] "Export fibres…":
        "Writes the selected fibres, or all of the body, as lines to a file (OBJ, CSV, JSON)";
    Hide in Edit [plain(Key::H)] "Hide": "Hides the selected fibres, sheet or body; they act all the same";
    ShowAll in Edit [alt(Key::H)] "Show all": "Shows every hidden body, and fibre and sheet of the body";
    PlayPause in Simulation [plain(Key::Space)] "Play or pause": "Runs or holds the simulation";
    ComputeAhead in Simulation [] "Compute ahead…":
        "Computes some seconds of a motion that is slow to compute, then plays them at full speed";
    Step in Simulation [plain(Key::Period), plain(Key::ArrowRight)] "Advance one frame":
        "Shows the next frame and holds the simulation; at the end of what is kept it is computed";
    StepBack in Simulation [plain(Key::ArrowLeft)] "Step back": "Shows the frame before and holds the simulation";
    FirstFrame in Simulation [shift(Key::ArrowLeft)] "First kept frame":
        "Shows the oldest frame that is kept and holds the simulation";
    Replay in Simulation [shift(Key::Space)] "Replay":
        "Shows the kept frames from here on, or from the first, as fast as they were meant to be, and computes none";
    GoOn in Simulation [shift(Key::Enter)] "Go on from here":
        "Runs the simulation on from the frame that is shown; the later ones are dropped";
    Live in Simulation [shift(Key::ArrowRight)] "Live": "Back from earlier frames to where the simulation has come to";
    Reset in Simulation [ctrl(Key::R)] "Back to the start": "Puts the simulation back to the start of the scene";
    ReleasePins in Simulation [ctrl_shift(Key::P)] "Release pinned drags":
        "Lets go of every point that P has pinned while dragging";
    Frame in View [plain(Key::F)] "Frame selection": "Fits every view to the selected fibre, or to everything";
    FrameAll in View [plain(Key::Home)] "Frame everything": "Fits every view to everything";
    Follow in View [alt(Key::B)] "Follow the body":
        "Moves the result view along with the body, wherever that goes";
    XRay in View [alt(Key::Z)] "See through the solid": "Shows the fibres through the solid in the result view";
    Particles in View [alt(Key::P)] "Show particles": "Shows material particles cool and structure particles warm";
    Springs in View [alt(Key::S)] "Show springs":
        "Shows the springs of two-layer bodies by kind, outer particles cool and inner ones warm";
    Strokes in View [alt(Key::K)] "Show strokes":
        "Shows the strokes of every fibre in the result view, in the planes in which they were drawn";
    Grid in View [alt(Key::G)] "Show grid": "Shows the grid of the result view";
    ColourMap in View [alt(Key::C)] "Next colour map":
        "Colours solids by strain, stress, volume fraction, speed, or not at all";
    Tension in View [alt(Key::F)] "Colour fibres by tension":
        "Colours fibres by the force that they carry: warm where they pull, cool where they are pressed";
    Activation in View [alt(Key::A)] "Show fibres act":
        "Colours fibres by their drive, from 0 to 1, and has them bulge as they contract";
    Slice in View [alt(Key::X)] "Next cut":
        "Cuts the solid open across X, Y or Z in the result view, or not at all";
    ShowEffect in View [] "Show the last change":
        "Plays the scene from its start in slow motion beside itself as it was before the last change, and tells what differs";
    Ghost in View [alt(Key::O)] "Next ghost":
        "Runs the scene without its fibres and sheets, as it was before the last edit, or nothing beside it";
    Timeline in View [alt(Key::L)] "Show timeline": "Shows what is kept of the motion, below the views";
    Drives in View [alt(Key::D)] "Show drives":
        "Shows what changes in time below the timeline, a lane each, with its keys";
    Plots in View [alt(Key::E)] "Show plots": "Plots energies, momenta and the scene's measures below the views";
    Theme in View [alt(Key::T)] "Light or dark": "Switches between the light and the dark theme";
    Palette in Help [ctrl(Key::P)] "Command palette…": "Finds any of these by its name";
    Report in Help [] "Report a fault…":
        "Writes the scene, its models, what was done to the motion, what was said and versions into one archive";
    FirstScene in Help [] "First scene": "Tells how a scene of your own is made, step by step";
    Help in Help [plain(Key::F1)] "Keys and gestures": "Lists every key and gesture";
}

impl Action {
    /// Name in menus, palette and help; an ellipsis where more is asked.
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// What it does, in a sentence.
    pub fn tooltip(self) -> &'static str {
        self.entry().tooltip
    }

    /// Menu in which it stands.
    pub fn menu(self) -> Menu {
        self.entry().menu
    }

    /// Keys; the first is shown.
    pub fn shortcuts(self) -> &'static [KeyboardShortcut] {
        self.entry().shortcuts
    }
}

/// How an action stands in a frame.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActionState {
    /// Why it cannot be asked for just now; none where it can.
    pub disabled: Option<&'static str>,
    /// Whether the switch that it is is on; none for what is no switch.
    pub on: Option<bool>,
    /// What exactly it would do, to be said behind its name.
    pub detail: Option<String>,
}

/// How every action stands in a frame.
pub(crate) struct ActionStates([ActionState; Action::COUNT]);

impl ActionStates {
    /// As `state` gives them.
    pub(crate) fn new(state: impl FnMut(Action) -> ActionState) -> Self {
        Self(Action::ALL.map(state))
    }
}

impl Default for ActionStates {
    fn default() -> Self {
        Self::new(|_| ActionState::default())
    }
}

impl std::ops::Index<Action> for ActionStates {
    type Output = ActionState;

    fn index(&self, action: Action) -> &ActionState {
        // Actions are declared in the order in which they are listed.
        &self.0[action as usize]
    }
}

/// Gestures of the pointer and single keys that are no actions, for the help; those of the cameras are the
/// navigation's.
pub(crate) const GESTURES: [(&str, &str); 18] = [
    ("Click on a body in the result view", "selects it: G, R, S and its handles move, turn and scale it"),
    ("Click on a fibre, Shift + click", "selects it, selects it too"),
    ("Drag an arrow, the square, the ring", "moves along an axis, moves freely, turns"),
    ("X, Y, Z, numbers, Shift, Ctrl while moving", "lock an axis, mm or degrees, finely, in steps"),
    ("Drag a vertex", "moves it, while vertices are edited"),
    ("Left drag in a drawing view", "draws a stroke"),
    ("Escape", "takes the last stroke back"),
    ("Left drag or right drag on a body in the result view", "pulls it"),
    ("Right click in a view", "opens the menu of what lies there"),
    ("2*3cm, 1.5 kPa, 90 g", "are numbers in every field, and while something is moved"),
    ("P while pulling", "leaves the point pinned where it is"),
    ("Drag in the timeline", "shows the motion at another time"),
    ("I over a field with a diamond", "sets a key there in the frame that is shown, or takes it away"),
    ("Double click, drag, Shift in a lane", "adds a key, moves keys or draws a box around them, off the frames"),
    ("1, 3, 7, the ends of the axes", "shows the result from the front, the side, the top"),
    ("Ctrl + 1, 3, 7", "shows it from the other side"),
    ("5", "changes between parallel and perspective"),
    ("Drop a scene or a model on the window", "opens it; a model joins a scene that you have begun"),
];
