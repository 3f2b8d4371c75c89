//! Copies of bodies, and identifiers that are free.

use crate::scene::{OwnedBody, Scene};

/// A copy under the first free number: "box-2" and "Box 2" after "box".
pub fn copy(body: &OwnedBody, scene: &Scene) -> OwnedBody {
    let mut copy = body.clone();
    let number = first_free(body.view().id(), scene);
    let name = body.view().title().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end().to_owned();
    let mut view = copy.view_mut();
    if let Some(number) = number {
        *view.id_mut() = format!("{}-{number}", stem(body.view().id()));
        *view.name_mut() = format!("{name} {number}");
    }
    copy
}

/// The number under which an identifier is free; none where it is so already.
fn first_free(id: &str, scene: &Scene) -> Option<usize> {
    scene.find_body(id)?;
    (2..usize::MAX).find(|number| scene.find_body(&format!("{}-{number}", stem(id))).is_none())
}

fn stem(id: &str) -> &str {
    let stem = id.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('-');
    if stem.trim().is_empty() { "body" } else { stem }
}
