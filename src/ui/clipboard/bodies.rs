//! A body as text, with all that is in it. Its model stays in its file.

use crate::draw::Bounds;
use crate::edit::body_ops::placed;
use crate::io::resolved;
use crate::scene::{Body, OwnedBody, Scene, TwoLayer};
use crate::ui::bodies::incoming;
use crate::ui::context::{Context, Request, Severity};
use crate::ui::gallery::is_shipped;
use serde::{Deserialize, Serialize};

/// What the text says that it holds.
pub(super) const BODY: &str = "body";

/// What is put on the clipboard.
#[derive(Serialize, Deserialize)]
struct Clipping {
    sinew: String,
    body: Kind,
    /// Half the extents where it stands [m], to find room for it.
    half_size: [f64; 3],
    /// Its middle there [m].
    center: [f64; 3],
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Solid(Box<Body>),
    TwoLayer(Box<TwoLayer>),
}

/// The selected body as text; its model by the whole path.
pub(super) fn copied(cx: &mut Context) -> Option<String> {
    let mut body = cx.chosen_body()?.owned();
    let title = body.view().title().to_owned();
    let at = |point| placed(body.view().placement(), point);
    let bounds = Bounds::of(cx.active.bounds()?.corners().map(at))?;
    for path in body.view_mut().into_model_paths() {
        let file = cx.document.folder.join(&*path);
        if !(cx.document.is_example && is_shipped(path)) {
            *path = resolved(&file).unwrap_or(file).display().to_string();
        }
    }
    let body = match body {
        OwnedBody::Solid(body) => Kind::Solid(body),
        OwnedBody::TwoLayer(body) => Kind::TwoLayer(body),
    };
    let half_size = (0.5 * (bounds.max - bounds.min)).to_array();
    let clipping = Clipping { sinew: BODY.to_owned(), body, half_size, center: bounds.center().to_array() };
    let text = serde_json::to_string_pretty(&clipping).ok()?;
    cx.say(Severity::Note, format!("Copied {title}"));
    Some(text)
}

/// Asks for the body of a text to be put into the scene, where there is room; false where the text holds none.
pub(super) fn paste(text: &str, cx: &mut Context) -> bool {
    let Ok(Clipping { body, half_size, center, .. }) = serde_json::from_str::<Clipping>(text) else { return false };
    let body = match body {
        Kind::Solid(body) => OwnedBody::Solid(body),
        Kind::TwoLayer(body) => OwnedBody::TwoLayer(body),
    };
    // What makes no sense is said as it is of a file, before room is looked for.
    let mut alone = Scene::new("");
    match &body {
        OwnedBody::Solid(body) => alone.bodies.push((**body).clone()),
        OwnedBody::TwoLayer(body) => alone.two_layer.push((**body).clone()),
    }
    if let Err(error) = alone.validate() {
        cx.say(Severity::Error, format!("The body on the clipboard cannot be used: {error}"));
        return true;
    }
    let [half, center] = [half_size, center].map(glam::DVec3::from_array);
    match incoming(body, Bounds { min: center - half, max: center + half }, cx) {
        Ok(incoming) => cx.request(Request::Bring(Box::new(incoming))),
        Err(problem) => cx.say(Severity::Error, problem),
    }
    true
}
