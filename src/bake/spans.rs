//! Baking as a trace shows it: one span for the whole, one within it for each stage of each body.

use super::error::BakeError;
use super::stage::{BakeStage, Tell};
use std::mem::{Discriminant, discriminant};
use std::ops::ControlFlow;
use tracing::span::EnteredSpan;
use tracing::{Span, info_span};

/// Bakes within spans: those of the stages follow what `work` tells `progress`.
///
/// # Errors
/// That of `work`, which gets [`BakeError::Cancelled`] where `progress` breaks off.
pub(super) fn within<T>(
    progress: &mut dyn FnMut(&str, BakeStage) -> ControlFlow<()>,
    work: impl FnOnce(&mut Tell<'_>) -> Result<T, BakeError>,
) -> Result<T, BakeError> {
    let _bake = info_span!("bake").entered();
    let mut present: Option<(Discriminant<BakeStage>, EnteredSpan)> = None;
    work(&mut |body, stage| {
        let kind = discriminant(&stage);
        // A stage that tells how far it has come goes on.
        if present.as_ref().is_none_or(|(known, _)| *known != kind) {
            // One ends before the next begins.
            present = None;
            present = Some((kind, span_of(body, stage).entered()));
        }
        match progress(body, stage) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(BakeError::Cancelled),
        }
    })
}

fn span_of(body: &str, stage: BakeStage) -> Span {
    match stage {
        BakeStage::Sampling { .. } => info_span!("sampling", body),
        BakeStage::Neighbours => info_span!("neighbours", body),
        BakeStage::Embedding => info_span!("embedding", body),
        BakeStage::Skin { .. } => info_span!("skin", body),
        BakeStage::StableStep => info_span!("stable step", body),
    }
}
