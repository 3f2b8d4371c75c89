//! Drawing a fibre or a sheet by a stroke in each of two views. Knows strokes and pixels, but no window.

use crate::edit::fibre_ops::Sampling;
use crate::scene::{Mismatch, StrokePair, SweptStrokes, ViewStroke};
use crate::sketch::{
    Guides, LiftOptions, Lifted, PartialLift, SketchError, Stroke, Sweep, View, guides, lift, partial_lift, sweep,
};
use glam::DVec2;
use std::cell::RefCell;
use std::rc::Rc;

/// Pointer travel between two samples [pixels].
const SAMPLE_EVERY: f64 = 2.0;

/// Strokes shorter than this are taken for a slip [pixels].
pub(super) const SHORTEST_STROKE: f64 = 12.0;

/// Where the drawing of a fibre stands.
#[derive(Clone, Debug, Default)]
pub(crate) enum Stage {
    /// Nothing is drawn.
    #[default]
    Empty,
    /// The pointer draws; the first stroke is there already when this is the second.
    Drawing {
        /// What has been drawn so far.
        stroke: Stroke,
        /// Travel of the pointer [pixels].
        length: f64,
        /// Last sample [pixels].
        last: DVec2,
        /// The first stroke, when this is the second.
        first: Option<Stroke>,
    },
    /// The first stroke is drawn and waits for the second.
    Waiting {
        /// The first stroke.
        first: Stroke,
    },
    /// Both strokes are drawn but do not make a fibre as they are.
    Refused {
        /// The first stroke.
        first: Stroke,
        /// The second stroke.
        second: Stroke,
    },
}

impl Stage {
    /// A number for each stage.
    pub(crate) fn number(&self) -> u8 {
        match self {
            Self::Empty => 0,
            Self::Drawing { first: None, .. } => 1,
            Self::Waiting { .. } => 2,
            Self::Drawing { first: Some(_), .. } => 3,
            Self::Refused { .. } => 4,
        }
    }
}

/// What two strokes make.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Makes {
    /// The curve that both see.
    #[default]
    Fibre,
    /// The surface that the first sweeps along the second.
    Sheet,
}

/// What a released stroke has led to.
#[derive(Clone, Debug)]
pub(crate) enum StrokeOutcome {
    /// It was too short to be meant [pixels].
    Slip(f64),
    /// The first stroke is there; the second goes into another view.
    First,
    /// The pair cannot be used as it is.
    Refused(SketchError),
    /// The pair sweeps a surface.
    Swept(SweptStrokes),
    /// The pair makes a curve.
    Pair {
        /// The raw strokes and how they were taken.
        strokes: StrokePair,
        /// The curve and what is to be said about it.
        lifted: Box<Lifted>,
    },
}

/// The tool.
#[derive(Clone, Debug, Default)]
pub(crate) struct SketchTool {
    stage: Stage,
    /// What was previewed last.
    previewed: RefCell<Option<Preview<f64, PartialLift>>>,
    swept: RefCell<Option<Preview<Sampling, Sweep>>>,
}

/// What two strokes make so far.
#[derive(Clone, Debug)]
struct Preview<K, T> {
    /// Points that the second stroke had.
    points: usize,
    /// What it was made for.
    made_for: K,
    made: Option<Rc<T>>,
}

impl SketchTool {
    /// Where the drawing stands.
    pub(crate) fn stage(&self) -> &Stage {
        &self.stage
    }

    /// Whether a stroke is being drawn in `view`.
    pub(crate) fn draws_in(&self, view: View) -> bool {
        matches!(&self.stage, Stage::Drawing { stroke, .. } if stroke.view == view)
    }

    /// The first stroke, once it is finished.
    pub(crate) fn first(&self) -> Option<&Stroke> {
        match &self.stage {
            Stage::Empty => None,
            Stage::Drawing { first, .. } => first.as_ref(),
            Stage::Waiting { first } | Stage::Refused { first, .. } => Some(first),
        }
    }

    /// Starts a stroke at a pixel and the point [m] that it shows. In the view of the first stroke it takes that one's
    /// place.
    pub(crate) fn press(&mut self, view: View, pixel: DVec2, point: DVec2) {
        let first = self.first().filter(|first| first.view != view).cloned();
        self.previewed.take();
        self.swept.take();
        self.stage = Stage::Drawing { stroke: Stroke { view, points: vec![point] }, length: 0.0, last: pixel, first };
    }

    /// Takes a pointer sample of the stroke that is being drawn.
    pub(crate) fn drag(&mut self, pixel: DVec2, point: DVec2) {
        if let Stage::Drawing { stroke, length, last, .. } = &mut self.stage {
            let travel = pixel.distance(*last);
            if travel >= SAMPLE_EVERY {
                stroke.points.push(point);
                *length += travel;
                *last = pixel;
            }
        }
    }

    /// Ends the stroke, drawn into a body that is sampled like this; two make what is asked for.
    pub(crate) fn release(&mut self, sampling: Sampling, makes: Makes) -> Option<StrokeOutcome> {
        let Stage::Drawing { stroke, length, first, .. } = std::mem::take(&mut self.stage) else { return None };
        if length < SHORTEST_STROKE {
            self.stage = first.map_or(Stage::Empty, |first| Stage::Waiting { first });
            return Some(StrokeOutcome::Slip(length));
        }
        let Some(first) = first else {
            self.stage = Stage::Waiting { first: stroke };
            return Some(StrokeOutcome::First);
        };
        Some(match makes {
            Makes::Fibre => self.pair(first, stroke, sampling.model_diagonal, Mismatch::Clip),
            Makes::Sheet => self.swept(&first, &stroke, sampling),
        })
    }

    /// A pair that sweeps no surface leaves the first stroke, to be swept along another one.
    fn swept(&mut self, first: &Stroke, second: &Stroke, sampling: Sampling) -> StrokeOutcome {
        match sweep(first, second, sampling.model_diagonal, sampling.spacing) {
            Ok(_) => StrokeOutcome::Swept(SweptStrokes::new(drawn(first), drawn(second))),
            Err(error) => {
                self.stage = Stage::Waiting { first: first.clone() };
                StrokeOutcome::Refused(error)
            }
        }
    }

    /// Takes a refused pair by stretching the second stroke onto the first.
    pub(crate) fn stretch(&mut self, model_diagonal: f64) -> Option<StrokeOutcome> {
        let Stage::Refused { first, second } = std::mem::take(&mut self.stage) else { return None };
        Some(self.pair(first, second, model_diagonal, Mismatch::Stretch))
    }

    fn pair(&mut self, first: Stroke, second: Stroke, model_diagonal: f64, mismatch: Mismatch) -> StrokeOutcome {
        let options = LiftOptions { flip_second: false, stretch: mismatch == Mismatch::Stretch, model_diagonal };
        match lift(&first, &second, &options) {
            Ok(lifted) => {
                let strokes = StrokePair { mismatch, ..StrokePair::new(drawn(&first), drawn(&second)) };
                StrokeOutcome::Pair { strokes, lifted: Box::new(lifted) }
            }
            Err(error) => {
                self.stage = Stage::Refused { first, second };
                StrokeOutcome::Refused(error)
            }
        }
    }

    /// Throws away the stroke that is being drawn, or else what has been drawn so far; false if there was nothing.
    pub(crate) fn cancel(&mut self) -> bool {
        match std::mem::take(&mut self.stage) {
            Stage::Empty => false,
            Stage::Drawing { first: Some(first), .. } | Stage::Refused { first, .. } => {
                self.stage = Stage::Waiting { first };
                true
            }
            Stage::Drawing { first: None, .. } | Stage::Waiting { .. } => true,
        }
    }

    /// What helps to draw the second stroke in `view`; none before the first one is there.
    pub(crate) fn guides(&self, view: View, model_diagonal: f64) -> Option<Guides> {
        guides(self.first()?, view, model_diagonal).ok()
    }

    /// The curve that the strokes make so far, while the second one is being drawn; lifted anew only as that grows.
    pub(crate) fn preview(&self, model_diagonal: f64) -> Option<Rc<PartialLift>> {
        let Stage::Drawing { stroke, first: Some(first), .. } = &self.stage else { return None };
        let points = stroke.points.len();
        let mut previewed = self.previewed.borrow_mut();
        let made = || partial_lift(first, stroke, model_diagonal).ok();
        remade(&mut previewed, points, model_diagonal, made)
    }

    /// The surface that the strokes sweep so far, likewise.
    pub(crate) fn swept_preview(&self, sampling: Sampling) -> Option<Rc<Sweep>> {
        let Stage::Drawing { stroke, first: Some(first), .. } = &self.stage else { return None };
        let made = || sweep(first, stroke, sampling.model_diagonal, sampling.spacing).ok();
        remade(&mut self.swept.borrow_mut(), stroke.points.len(), sampling, made)
    }
}

/// What was made last, or made anew where the stroke or what it is made for is another.
fn remade<K: Copy + PartialEq, T>(
    last: &mut Option<Preview<K, T>>,
    points: usize,
    made_for: K,
    make: impl FnOnce() -> Option<T>,
) -> Option<Rc<T>> {
    if let Some(known) = last.as_ref().filter(|known| known.points == points && known.made_for == made_for) {
        return known.made.clone();
    }
    let made = make().map(Rc::new);
    *last = Some(Preview { points, made_for, made: made.clone() });
    made
}

fn drawn(stroke: &Stroke) -> ViewStroke {
    ViewStroke::new(stroke.view, stroke.points.iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draw(tool: &mut SketchTool, view: View, points: &[(f64, f64)]) -> Option<StrokeOutcome> {
        let at = |(x, y): (f64, f64)| DVec2::new(x, y);
        tool.press(view, at(points[0]) * 4000.0, at(points[0]));
        for pair in points.windows(2) {
            for k in 1..=20 {
                let point = at(pair[0]).lerp(at(pair[1]), f64::from(k) / 20.0);
                tool.drag(point * 4000.0, point);
            }
        }
        tool.release(Sampling { model_diagonal: 0.1, spacing: 0.01 }, Makes::Fibre)
    }

    #[test]
    fn two_strokes_make_a_pair() {
        let mut tool = SketchTool::default();
        assert!(matches!(draw(&mut tool, View::Front, &[(0.0, 0.0), (0.02, 0.07)]), Some(StrokeOutcome::First)));
        assert!(tool.guides(View::Side, 0.1).is_some());
        let Some(StrokeOutcome::Pair { strokes, lifted }) = draw(&mut tool, View::Side, &[(0.01, 0.0), (-0.01, 0.07)])
        else {
            panic!("no pair")
        };
        assert_eq!((strokes.first.view, strokes.second.view), (View::Front, View::Side));
        let end = lifted.curve[lifted.curve.len() - 1];
        assert!(end.distance(glam::DVec3::new(0.02, 0.07, -0.01)) < 1e-3, "{end}");
        assert!(matches!(tool.stage(), Stage::Empty));
    }

    #[test]
    fn slips_are_refused_and_keep_the_first_stroke() {
        let mut tool = SketchTool::default();
        assert!(matches!(draw(&mut tool, View::Front, &[(0.0, 0.0), (0.001, 0.001)]), Some(StrokeOutcome::Slip(_))));
        assert!(tool.first().is_none());
        draw(&mut tool, View::Front, &[(0.0, 0.0), (0.02, 0.07)]);
        assert!(matches!(draw(&mut tool, View::Side, &[(0.0, 0.0), (0.001, 0.001)]), Some(StrokeOutcome::Slip(_))));
        assert!(tool.first().is_some());
    }

    #[test]
    fn a_stroke_in_the_first_ones_view_takes_its_place_and_escape_goes_back() {
        let mut tool = SketchTool::default();
        draw(&mut tool, View::Front, &[(0.0, 0.0), (0.02, 0.07)]);
        assert!(matches!(draw(&mut tool, View::Front, &[(0.0, 0.0), (0.0, 0.07)]), Some(StrokeOutcome::First)));
        assert!(tool.first().is_some_and(|first| first.points.iter().all(|point| point.x == 0.0)));
        tool.press(View::Side, DVec2::ZERO, DVec2::ZERO);
        assert!(tool.cancel() && tool.first().is_some());
        assert!(tool.cancel() && tool.first().is_none());
        assert!(!tool.cancel());
    }

    #[test]
    fn strokes_of_different_ranges_can_be_stretched() {
        let mut tool = SketchTool::default();
        draw(&mut tool, View::Front, &[(0.0, 0.0), (0.02, 0.07)]);
        let refused = draw(&mut tool, View::Side, &[(0.0, 0.0), (0.01, 0.03)]);
        assert!(matches!(refused, Some(StrokeOutcome::Refused(SketchError::Overlap { .. }))), "{refused:?}");
        assert!(matches!(tool.stretch(0.1), Some(StrokeOutcome::Pair { .. })));
    }
}
