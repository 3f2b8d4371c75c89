//! What panels ask of the document: the active body, what is selected of it and where that lies.

use super::{ChosenPin, Context, Lift};
use crate::edit::body_ops::placed;
use crate::edit::fibre_ops::Sampling;
use crate::scene::{AnyBody, Body, Fibre, FibreSource, Shape, Sheet, TwoLayer};
use crate::sketch::View;
use glam::DVec3;
use std::rc::Rc;

/// Spacing [m] that fibres are drawn with where there is no body yet.
const USUAL_SPACING: f64 = 1e-2;
/// A ghost is shown aside by so many widths of the scene.
const ASIDE: f64 = 1.8;

impl Context {
    /// The fibre solid that is drawn into.
    pub(crate) fn active_body(&self) -> Option<&Body> {
        self.scene().any_body(self.active.index)?.solid()
    }

    /// The two-layer body whose properties are shown.
    pub(crate) fn active_two_layer(&self) -> Option<&TwoLayer> {
        self.scene().any_body(self.active.index)?.two_layer()
    }

    /// The active body, if it is selected as a whole.
    pub(crate) fn chosen_body(&self) -> Option<AnyBody<'_>> {
        self.scene().any_body(self.active.index).filter(|_| self.selection.is_body())
    }

    /// The middle of the active body where it starts [m]; none before it is put together.
    pub(crate) fn body_pivot(&self) -> Option<DVec3> {
        let body = self.scene().any_body(self.active.index)?;
        Some(placed(body.placement(), self.active.bounds()?.center()))
    }

    /// How strokes of the active body become vertices.
    pub(crate) fn sampling(&self) -> Sampling {
        let model_diagonal = self.active.diagonal();
        // Of a mesh that is filled with a number of particles, the spacing that came out.
        let body = self.active.model.bodies.first();
        let filled = body.map(|body| model_diagonal / (body.particles.len().max(1) as f64).cbrt());
        let spacing = match self.active_body() {
            Some(body) => match &body.shape {
                Shape::Mesh(mesh) if mesh.particles.is_some() => filled.unwrap_or_else(|| body.material.spacing()),
                _ => body.material.spacing(),
            },
            None => filled.unwrap_or(USUAL_SPACING),
        };
        Sampling { model_diagonal, spacing }
    }

    /// The selected fibres of the active body, in the order in which they were chosen.
    pub(crate) fn selected_fibres(&self) -> Vec<&Fibre> {
        let Some(body) = self.active_body() else { return Vec::new() };
        let find = |id: &String| body.fibres.iter().find(|fibre| fibre.id == *id);
        self.selection.fibres().iter().filter_map(find).collect()
    }

    /// The fibre that was selected last and the body that it lies in.
    pub(crate) fn selected_fibre(&self) -> Option<(&Body, &Fibre)> {
        let body = self.active_body()?;
        let id = self.selection.active()?;
        Some((body, body.fibres.iter().find(|fibre| fibre.id == *id)?))
    }

    /// The sheet that is chosen and the body that it lies in.
    pub(crate) fn selected_sheet(&self) -> Option<(&Body, &Sheet)> {
        let body = self.active_body()?;
        let id = self.selection.sheet()?;
        Some((body, body.sheets.iter().find(|sheet| sheet.id == *id)?))
    }

    /// The curve and vertices of that fibre.
    pub(crate) fn selected_lift(&self) -> Option<Rc<Lift>> {
        let (_, fibre) = self.selected_fibre()?;
        Some(self.lifts.of(fibre, self.sampling()))
    }

    /// Views in which the strokes of that fibre were drawn.
    pub(crate) fn selected_views(&self) -> Vec<View> {
        match self.selected_fibre().map(|(_, fibre)| &fibre.source) {
            Some(FibreSource::Strokes(pair)) => vec![pair.first.view, pair.second.view],
            _ => Vec::new(),
        }
    }

    /// Vertices of that fibre in the model frame [m].
    pub(crate) fn active_vertices(&self) -> Vec<DVec3> {
        self.selected_lift().map_or_else(Vec::new, |lift| lift.vertices.clone())
    }

    /// The middle of what is selected, in the model frame [m]; none if nothing is.
    pub(crate) fn pivot(&self) -> Option<DVec3> {
        if self.selection.is_body() {
            return Some(self.active.bounds()?.center());
        }
        let points: Vec<DVec3> = if let Some(chosen) = self.selection.vertices() {
            let vertices = self.active_vertices();
            chosen.iter().filter_map(|&k| vertices.get(k).copied()).collect()
        } else if let Some((_, sheet)) = self.selected_sheet() {
            self.lifts.of_sheet(sheet, self.sampling()).to_vec()
        } else {
            let sampling = self.sampling();
            let lifts = self.selected_fibres().into_iter().map(|fibre| self.lifts.of(fibre, sampling));
            lifts.flat_map(|lift| lift.vertices.clone()).collect()
        };
        (!points.is_empty()).then(|| points.iter().sum::<DVec3>() / points.len() as f64)
    }

    /// By how much the ghost is shown aside [m].
    pub(crate) fn ghost_aside(&self) -> DVec3 {
        let placed = self.simulation.published().placed.filter(|_| self.ghost_beside);
        placed.map_or(DVec3::ZERO, |[low, high]| ASIDE * (high.x - low.x) * DVec3::X)
    }

    /// What sets a stable step, to be said after it; nothing where that is not known.
    pub(crate) fn set_by(&self, limited_by: Option<&str>) -> String {
        limited_by.map_or_else(String::new, |pointer| format!(", set by {}", self.scene().with_names(pointer)))
    }

    /// Forgets what is selected and no longer there.
    pub(super) fn forget_what_is_gone(&mut self) {
        let ids: Vec<String> =
            self.active_body().into_iter().flat_map(|body| &body.fibres).map(|fibre| fibre.id.clone()).collect();
        self.selection.retain(|id| ids.iter().any(|known| known == id));
        if let Some(ChosenPin::Region { body, pin }) = self.selection.pin() {
            let is_there = |known: AnyBody<'_>| known.id() == body && known.pins().iter().any(|known| known.id == *pin);
            if !self.scene().all_bodies().any(is_there) {
                self.selection.forget_pin();
            }
        }
        let sheets = self.active_body().map_or(&[][..], |body| &body.sheets);
        if self.selection.sheet().is_some_and(|id| sheets.iter().all(|known| known.id != *id)) {
            self.selection.clear();
        }
        if self.selection.collider().is_some_and(|id| self.scene().colliders.iter().all(|known| known.id != *id)) {
            self.selection.clear();
        }
        if let Some(chosen) = self.selection.vertices().map(<[usize]>::to_vec) {
            let count = self.active_vertices().len();
            if chosen.iter().any(|&k| k >= count) {
                self.selection.set_vertices(chosen.into_iter().filter(|&k| k < count).collect());
            }
        }
    }
}
