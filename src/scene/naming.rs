//! What things are called where a person reads of them.

use super::{AnyBody, Body, Collider, Element, Fibre, Panel, Scene, Sheet, TwoLayer, Void};

macro_rules! titles {
    ($($thing:ty)*) => {
        $(impl $thing {
            /// Its name, or its identifier where it has none.
            pub fn title(&self) -> &str {
                if self.name.is_empty() { &self.id } else { &self.name }
            }
        })*
    };
}

titles! { Body Collider Element Fibre Panel Sheet TwoLayer Void }

/// What a scene without a name is called.
pub(crate) const UNTITLED: &str = "Untitled";

impl Scene {
    /// Its name, or what one without a name is called.
    pub fn title(&self) -> &str {
        if self.name.is_empty() { UNTITLED } else { &self.name }
    }

    /// `text` with names for the pointers that lead to bodies and what is in them: "stiffness of Helix 4" for
    /// `/bodies/0/fibres/3/stiffness`. Pointers to anything else stay.
    pub fn with_names(&self, text: &str) -> String {
        let mut named = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(start) = rest.find('/') {
            let pointer = &rest[start..];
            let end =
                pointer.find(|c: char| !(c.is_ascii_alphanumeric() || "/_-~".contains(c))).unwrap_or(pointer.len());
            named.push_str(&rest[..start]);
            match self.pointed(&pointer[..end]) {
                Some(name) => named.push_str(&name),
                None => named.push_str(&pointer[..end]),
            }
            rest = &pointer[end..];
        }
        named + rest
    }

    /// What a pointer leads to, in words.
    fn pointed(&self, pointer: &str) -> Option<String> {
        let mut segments = pointer.split('/').skip(1).peekable();
        let (list, index) = (segments.next()?, segments.next()?);
        let body = self.listed_body(list, index.parse().ok()?)?;
        let mut name = body.title();
        if let AnyBody::Solid(body) = body
            && segments.next_if_eq(&"fibres").is_some()
        {
            name = body.fibres.get(segments.next()?.parse::<usize>().ok()?)?.title();
        } else if let AnyBody::Solid(body) = body
            && segments.next_if_eq(&"sheets").is_some()
        {
            name = body.sheets.get(segments.next()?.parse::<usize>().ok()?)?.title();
        } else if let AnyBody::Solid(body) = body
            && segments.next_if_eq(&"elements").is_some()
        {
            name = body.elements.get(segments.next()?.parse::<usize>().ok()?)?.title();
        } else if let AnyBody::Solid(body) = body
            && segments.next_if_eq(&"voids").is_some()
        {
            name = body.voids.get(segments.next()?.parse::<usize>().ok()?)?.title();
        }
        match segments.last() {
            None => Some(name.to_owned()),
            Some(number) if number.parse::<usize>().is_ok() => None,
            Some(part) => Some(format!("{} of {name}", part.replace('_', " "))),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    #[test]
    fn pointers_to_bodies_and_fibres_become_their_names() {
        let fibre = r#"{"id": "f", "source": {"vertices": []}, "stiffness": {"rigidity": {"ea": 1, "ei": 1}}"#;
        let text = format!(
            r#"{{"version": 1, "bodies": [{{"id": "bar", "name": "Long bar", "shape": {{"box": {{"size": [1, 1, 1]}}}},
            "material": {{"young_modulus": 1, "mass": {{"density": 1}}, "support_radius": 1}},
            "fibres": [{fibre}}}, {fibre}, "name": "Helix 4"}}],
            "sheets": [{{"id": "fin", "source": {{"grid": []}}, "stiffness": {{"et": 1}}}}]}}]}}"#
        );
        let scene: Scene = serde_json::from_str(&text).expect("a scene");
        let cases = [
            ("/bodies/0/fibres/1: 2 of 24 points lie outside", "Helix 4: 2 of 24 points lie outside"),
            ("0.1 s, set by /bodies/0/fibres/0/stiffness, is less", "0.1 s, set by stiffness of f, is less"),
            ("set by /bodies/0/sheets/0/stiffness", "set by stiffness of fin"),
            ("lower /bodies/0/material/young_modulus", "lower young modulus of Long bar"),
            ("/bodies/0", "Long bar"),
            // What has no name stays as it is.
            ("/bodies/0/regions/2 and /bodies/7", "/bodies/0/regions/2 and /bodies/7"),
            ("/time/step: 1 / 2 kg m²/s", "/time/step: 1 / 2 kg m²/s"),
        ];
        for (text, expected) in cases {
            assert_eq!(scene.with_names(text), expected);
        }
    }
}
