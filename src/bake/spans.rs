//! Baking as a trace shows it: one span for the whole, one within it for each stage of each body.

use super::stage::BakeStage;
use std::mem::{Discriminant, discriminant};
use tracing::span::EnteredSpan;
use tracing::{Span, info_span};

/// Bakes within spans: those of the stages follow what `work` tells `progress`.
pub(super) fn within<T>(
    progress: &mut dyn FnMut(&str, BakeStage),
    work: impl FnOnce(&mut dyn FnMut(&str, BakeStage)) -> T,
) -> T {
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
        progress(body, stage);
    })
}

fn span_of(body: &str, stage: BakeStage) -> Span {
    match stage {
        BakeStage::Sampling => info_span!("sampling", body),
        BakeStage::Neighbours => info_span!("neighbours", body),
        BakeStage::Embedding => info_span!("embedding", body),
        BakeStage::Skin { .. } => info_span!("skin", body),
        BakeStage::StableStep => info_span!("stable step", body),
    }
}
