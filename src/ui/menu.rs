//! The menus of the bar.

/// Menu in which an action stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files.
    File,
    /// The document.
    Edit,
    /// Bodies.
    Body,
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
    pub const ALL: [Self; 7] =
        [Self::File, Self::Edit, Self::Body, Self::Fibre, Self::Simulation, Self::View, Self::Help];

    /// Title.
    pub fn title(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Body => "Body",
            Self::Fibre => "Fibre",
            Self::Simulation => "Simulation",
            Self::View => "View",
            Self::Help => "Help",
        }
    }
}
