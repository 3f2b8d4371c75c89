//! Curves and vertices of fibres and sheets, made of their strokes once and not in every frame of every view.

use crate::edit::fibre_ops::{self, Sampling};
use crate::edit::sheet_ops;
use crate::scene::{Fibre, FibreSource, Sheet, SheetSource};
use crate::sketch::{Lifted, structure_particles};
use glam::DVec3;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// What strokes came out as.
#[derive(Debug, Default)]
pub(crate) struct Lifts {
    /// Fibres, by their identifiers.
    fibres: RefCell<HashMap<String, Rc<Lift>>>,
    /// The sheet that was asked for last.
    sheet: RefCell<Option<Sweep>>,
}

/// What a sheet came out as.
#[derive(Debug)]
struct Sweep {
    source: SheetSource,
    sampling: Sampling,
    vertices: Rc<[DVec3]>,
}

/// What a fibre came out as.
#[derive(Debug)]
pub(crate) struct Lift {
    source: FibreSource,
    sampling: Sampling,
    /// The curve of its strokes; none where it has none, or they give none.
    pub lifted: Option<Lifted>,
    /// Its vertices in the model frame [m]; none where its strokes give no curve.
    pub vertices: Vec<DVec3>,
}

impl Lifts {
    /// What a fibre comes out as: lifted anew where its strokes or the body have changed since the last time.
    pub(crate) fn of(&self, fibre: &Fibre, sampling: Sampling) -> Rc<Lift> {
        let mut known = self.fibres.borrow_mut();
        if let Some(lift) = known.get(&fibre.id)
            && lift.source == fibre.source
            && lift.sampling == sampling
        {
            return Rc::clone(lift);
        }
        let lifted = match &fibre.source {
            FibreSource::Strokes(pair) => pair.lifted(sampling.model_diagonal).ok(),
            FibreSource::Vertices(_) => None,
        };
        let vertices = match &lifted {
            Some(lifted) => structure_particles(&lifted.curve, sampling.spacing).unwrap_or_default(),
            None => fibre_ops::vertices(fibre, sampling).unwrap_or_default(),
        };
        let lift = Rc::new(Lift { source: fibre.source.clone(), sampling, lifted, vertices });
        known.insert(fibre.id.clone(), Rc::clone(&lift));
        lift
    }

    /// The vertices of a sheet in the model frame [m], none where its strokes sweep no surface: swept anew where they
    /// or the body have changed since the last time.
    pub(crate) fn of_sheet(&self, sheet: &Sheet, sampling: Sampling) -> Rc<[DVec3]> {
        let mut known = self.sheet.borrow_mut();
        match &*known {
            Some(sweep) if sweep.source == sheet.source && sweep.sampling == sampling => Rc::clone(&sweep.vertices),
            _ => {
                let vertices: Rc<[DVec3]> = sheet_ops::vertices(sheet, sampling).unwrap_or_default().into();
                *known = Some(Sweep { source: sheet.source.clone(), sampling, vertices: Rc::clone(&vertices) });
                vertices
            }
        }
    }

    /// Forgets all: another body or document is drawn into.
    pub(crate) fn clear(&self) {
        self.fibres.borrow_mut().clear();
        *self.sheet.borrow_mut() = None;
    }
}
