//! What is selected: fibres of the active body, vertices of one of them while those are edited, a sheet, a pin, or the
//! body itself.

/// Fibres by their identifiers, the last chosen at the end; vertices of that one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Selection {
    fibres: Vec<String>,
    vertices: Option<Vec<usize>>,
    pin: Option<ChosenPin>,
    collider: Option<String>,
    sheet: Option<String>,
    /// Whether the active body is selected as a whole.
    body: bool,
}

/// A pin, by what it is known by.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ChosenPin {
    /// A pin of the document.
    Region {
        /// Identifier of the body.
        body: String,
        /// Its own.
        pin: String,
    },
    /// A point that a drag has left pinned.
    Point {
        /// Index of the body.
        body: usize,
        /// Its place among what pulls at the body.
        grab: usize,
    },
}

impl Selection {
    /// The fibre that was chosen last.
    pub(crate) fn active(&self) -> Option<&String> {
        self.fibres.last()
    }

    /// All selected fibres.
    pub(crate) fn fibres(&self) -> &[String] {
        &self.fibres
    }

    /// Whether a fibre is selected.
    pub(crate) fn contains(&self, fibre: &str) -> bool {
        self.fibres.iter().any(|id| id == fibre)
    }

    /// The selected vertices of the active fibre; none while whole fibres are edited.
    pub(crate) fn vertices(&self) -> Option<&[usize]> {
        self.vertices.as_deref()
    }

    /// Selects one fibre alone.
    pub(crate) fn only(&mut self, fibre: impl Into<String>) {
        *self = Self { fibres: vec![fibre.into()], ..Self::default() };
    }

    /// Selects fibres, and nothing else.
    pub(crate) fn set(&mut self, fibres: impl IntoIterator<Item = String>) {
        *self = Self { fibres: fibres.into_iter().collect(), ..Self::default() };
    }

    /// Adds a fibre, or takes it out.
    pub(crate) fn toggle(&mut self, fibre: &str) {
        let before = self.fibres.len();
        self.fibres.retain(|id| id != fibre);
        if self.fibres.len() == before {
            self.fibres.push(fibre.to_owned());
        }
        *self = Self { fibres: std::mem::take(&mut self.fibres), ..Self::default() };
    }

    /// Whether the active body is selected as a whole.
    pub(crate) fn is_body(&self) -> bool {
        self.body
    }

    /// Selects the active body as a whole, and nothing else.
    pub(crate) fn choose_body(&mut self) {
        *self = Self { body: true, ..Self::default() };
    }

    /// The pin that is chosen.
    pub(crate) fn pin(&self) -> Option<&ChosenPin> {
        self.pin.as_ref()
    }

    /// Chooses a pin, and nothing else.
    pub(crate) fn choose_pin(&mut self, pin: ChosenPin) {
        *self = Self { pin: Some(pin), ..Self::default() };
    }

    /// The collider that is chosen, by its identifier.
    pub(crate) fn collider(&self) -> Option<&String> {
        self.collider.as_ref()
    }

    /// Chooses a collider, and nothing else.
    pub(crate) fn choose_collider(&mut self, collider: String) {
        *self = Self { collider: Some(collider), ..Self::default() };
    }

    /// The sheet of the active body that is chosen, by its identifier.
    pub(crate) fn sheet(&self) -> Option<&String> {
        self.sheet.as_ref()
    }

    /// Chooses a sheet of the active body, and nothing else.
    pub(crate) fn choose_sheet(&mut self, sheet: impl Into<String>) {
        *self = Self { sheet: Some(sheet.into()), ..Self::default() };
    }

    /// Chooses no pin any more.
    pub(crate) fn forget_pin(&mut self) {
        self.pin = None;
    }

    /// Takes in what a click means: a fibre alone, or one more with `adding`; nothing, unless adding, clears.
    pub(crate) fn click(&mut self, fibre: Option<&str>, adding: bool) {
        match fibre {
            Some(fibre) if adding => self.toggle(fibre),
            Some(fibre) => self.only(fibre),
            None if adding => {}
            None => self.clear(),
        }
    }

    /// Selects nothing.
    pub(crate) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Goes into the vertices of the active fibre, or back to whole fibres.
    pub(crate) fn enter_vertices(&mut self, enter: bool) {
        self.vertices = (enter && !self.fibres.is_empty()).then(Vec::new);
    }

    /// Selects vertices of the active fibre, in order and each once.
    pub(crate) fn set_vertices(&mut self, mut vertices: Vec<usize>) {
        vertices.sort_unstable();
        vertices.dedup();
        self.vertices = Some(vertices);
    }

    /// As [`Self::click`], for a vertex of the active fibre.
    pub(crate) fn click_vertex(&mut self, vertex: Option<usize>, adding: bool) {
        let mut vertices = self.vertices.take().unwrap_or_default();
        match vertex {
            Some(vertex) if adding && vertices.contains(&vertex) => vertices.retain(|k| *k != vertex),
            Some(vertex) if adding => vertices.push(vertex),
            Some(vertex) => vertices = vec![vertex],
            None if adding => {}
            None => vertices.clear(),
        }
        self.set_vertices(vertices);
    }

    /// Forgets fibres and vertices that are not there any more.
    pub(crate) fn retain(&mut self, there: impl Fn(&str) -> bool) {
        let active = self.active().cloned();
        self.fibres.retain(|id| there(id));
        if self.active() != active.as_ref() {
            self.vertices = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clicks_choose_one_and_shift_adds_or_takes_out() {
        let mut selection = Selection::default();
        selection.click(Some("a"), false);
        selection.click(Some("b"), true);
        assert_eq!(selection.fibres(), ["a", "b"]);
        assert_eq!(selection.active().map(String::as_str), Some("b"));
        selection.click(Some("a"), true);
        assert_eq!(selection.fibres(), ["b"]);
        selection.click(None, true);
        assert_eq!(selection.fibres(), ["b"]);
        selection.click(None, false);
        assert!(selection.fibres().is_empty());
    }

    #[test]
    fn vertices_belong_to_the_active_fibre() {
        let mut selection = Selection::default();
        selection.enter_vertices(true);
        assert_eq!(selection.vertices(), None, "there is no fibre to enter");
        selection.only("a");
        selection.enter_vertices(true);
        selection.click_vertex(Some(4), false);
        selection.click_vertex(Some(2), true);
        assert_eq!(selection.vertices(), Some(&[2, 4][..]));
        selection.click_vertex(Some(4), true);
        assert_eq!(selection.vertices(), Some(&[2][..]));
        selection.retain(|id| id != "a");
        assert_eq!(selection.vertices(), None);
    }
}
