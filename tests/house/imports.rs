//! Reads the paths out of Rust source, whatever form they have, and what they mean below the crate's root. Not a Rust
//! parser: what it knows is words, `::`, braces, `use`, `mod` and `#[cfg(test)]`.

use crate::tokens::{Token, tokens};

/// How a path stands in the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// In a `use`.
    Use,
    /// In a `use` with a visibility: `pub use`, `pub(crate) use`.
    ReExport,
    /// In code, by at least two segments.
    Path,
    /// In code, a word that stands alone where a name may stand.
    Word,
}

/// A path, made absolute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// Segments below the crate's root.
    pub path: Vec<String>,
    /// Whether it said where it starts, by `crate::`, `self::`, `super::`, or by `sinew::` in the binary. One that did
    /// not is read as if it started in its own module, and may as well be the path of another crate.
    pub rooted: bool,
    /// The module in which it stands, one written inside the file with it.
    pub module: Vec<String>,
    /// The name that a `use` brings in; none for a glob and outside of `use`.
    pub name: Option<String>,
    /// How it stands.
    pub kind: Kind,
    /// Line, from 1.
    pub line: usize,
}

/// Every path of `text`, the source of `module`. What is for tests only is left out where `tests` is false.
pub fn imports(text: &str, module: &[String], tests: bool) -> Vec<Import> {
    let mut reader = Reader { tokens: tokens(text), module: module.to_vec(), found: Vec::new() };
    let (mut at, mut depth, mut inside) = (0, 0, Vec::new());
    while at < reader.tokens.len() {
        if !tests && reader.is_for_tests(at) {
            at = reader.item_end(at);
        } else if let Some(name) = reader.inline_module(at) {
            reader.module.push(name);
            inside.push(depth);
            depth += 1;
            at += 3;
        } else if reader.word(at) == Some("use") {
            at = reader.read_use(at);
        } else if let Some(end) = reader.visibility_end(at) {
            at = end;
        } else {
            match reader.tokens[at].0 {
                Token::Open => depth += 1,
                Token::Close => {
                    depth -= 1;
                    if inside.last() == Some(&depth) {
                        inside.pop();
                        reader.module.pop();
                    }
                }
                _ => {}
            }
            at = reader.read_path(at);
        }
    }
    reader.found
}

struct Reader {
    tokens: Vec<(Token, usize)>,
    module: Vec<String>,
    found: Vec<Import>,
}

impl Reader {
    fn token(&self, at: usize) -> Option<&Token> {
        self.tokens.get(at).map(|(token, _)| token)
    }

    fn word(&self, at: usize) -> Option<&str> {
        match self.token(at) {
            Some(Token::Word(word)) => Some(word),
            _ => None,
        }
    }

    fn is(&self, at: usize, mark: char) -> bool {
        self.token(at) == Some(&Token::Other(mark))
    }

    fn is_separator(&self, at: usize) -> bool {
        self.token(at) == Some(&Token::PathSeparator)
    }

    /// Whether `#[cfg(test)]` starts here.
    fn is_for_tests(&self, at: usize) -> bool {
        self.is(at, '#')
            && self.is(at + 1, '[')
            && self.word(at + 2) == Some("cfg")
            && self.is(at + 3, '(')
            && self.word(at + 4) == Some("test")
            && self.is(at + 5, ')')
    }

    /// The token behind the item that starts here: behind its `;`, or behind its braces.
    fn item_end(&self, mut at: usize) -> usize {
        let (mut round, mut braces) = (0, 0);
        while let Some(token) = self.token(at) {
            at += 1;
            match token {
                Token::Other('(' | '[') => round += 1,
                Token::Other(')' | ']') => round -= 1,
                Token::Open => braces += 1,
                Token::Close => braces -= 1,
                _ => {}
            }
            let closed = matches!(token, Token::Close | Token::Other(';'));
            if closed && round == 0 && braces == 0 {
                break;
            }
        }
        at
    }

    /// The name of the module that is opened here with a brace.
    fn inline_module(&self, at: usize) -> Option<String> {
        let opens = self.word(at) == Some("mod") && self.token(at + 2) == Some(&Token::Open);
        if opens { self.word(at + 1).map(str::to_owned) } else { None }
    }

    /// The token behind `pub(in path)`, if that starts here: its path imports nothing.
    fn visibility_end(&self, at: usize) -> Option<usize> {
        let starts = self.word(at) == Some("pub") && self.is(at + 1, '(') && self.word(at + 2) == Some("in");
        starts.then(|| (at..self.tokens.len()).find(|&k| self.is(k, ')')).map_or(self.tokens.len(), |k| k + 1))
    }

    /// Reads the `use` that starts here; gives the token behind it.
    fn read_use(&mut self, at: usize) -> usize {
        let seen = at > 0 && (self.word(at - 1) == Some("pub") || self.is(at - 1, ')'));
        let from = if self.is_separator(at + 1) { at + 2 } else { at + 1 };
        self.read_tree(from, &mut Vec::new(), if seen { Kind::ReExport } else { Kind::Use })
    }

    /// Reads what stands behind `::` or `use`, a word or a group; gives the token behind it.
    fn read_tree(&mut self, mut at: usize, prefix: &mut Vec<String>, kind: Kind) -> usize {
        let depth = prefix.len();
        loop {
            match self.token(at) {
                Some(Token::Word(word)) => {
                    prefix.push(word.clone());
                    at += 1;
                    if self.is_separator(at) {
                        at += 1;
                        continue;
                    }
                    let renamed = if self.word(at) == Some("as") { self.word(at + 1) } else { None };
                    let own = prefix.iter().rev().find(|segment| *segment != "self").cloned();
                    let name = renamed.map(str::to_owned).or(own);
                    self.find(prefix, name, kind, at - 1);
                }
                Some(Token::Open) => at = self.read_group(at + 1, prefix, kind),
                // A glob, or a generic argument behind `::`.
                Some(_) if !prefix.is_empty() => self.find(prefix, None, kind, at),
                _ => {}
            }
            prefix.truncate(depth);
            return at;
        }
    }

    /// Reads the items of a group up to its closing brace; gives the token behind it.
    fn read_group(&mut self, mut at: usize, prefix: &mut Vec<String>, kind: Kind) -> usize {
        loop {
            at = self.read_tree(at, prefix, kind);
            // Whatever is left of the item, such as `as name`.
            while self.token(at).is_some_and(|token| !matches!(token, Token::Comma | Token::Close)) {
                at += 1;
            }
            match self.token(at) {
                Some(Token::Comma) if self.token(at + 1) != Some(&Token::Close) => at += 1,
                Some(Token::Comma) => return at + 2,
                _ => return at + 1,
            }
        }
    }

    /// Reads the path in code that starts here, if one does; gives the token behind it.
    fn read_path(&mut self, at: usize) -> usize {
        let is_part = at > 0 && (self.is_separator(at - 1) || self.is(at - 1, '.'));
        let Some(word) = self.word(at) else { return at + 1 };
        if is_part {
            return at + 1;
        }
        if !self.is_separator(at + 1) {
            // A small letter may be that of a variable or a field: a function is one that is called.
            let declared = at > 0 && matches!(self.word(at - 1), Some("fn" | "let" | "mod"));
            if !declared && (word.starts_with(char::is_uppercase) || self.is(at + 1, '(')) {
                let word = word.to_owned();
                self.find(&[word], None, Kind::Word, at);
            }
            return at + 1;
        }
        let (mut end, mut path) = (at, Vec::new());
        while let Some(word) = self.word(end) {
            path.push(word.to_owned());
            if !self.is_separator(end + 1) {
                self.find(&path, None, Kind::Path, end);
                return end + 1;
            }
            end += 2;
        }
        self.find(&path, None, Kind::Path, end.min(self.tokens.len() - 1));
        end
    }

    /// Notes a path as it is written.
    fn find(&mut self, written: &[String], name: Option<String>, kind: Kind, at: usize) {
        let mut path = self.module.clone();
        let mut left = written;
        match written[0].as_str() {
            "crate" => path.clear(),
            "sinew" if self.module == ["main"] => path.clear(),
            "self" if written.len() > 1 => {}
            "super" => {
                path.pop();
            }
            _ => {
                let line = self.tokens[at].1;
                path.extend(written.iter().filter(|segment| *segment != "self").cloned());
                self.found.push(Import { path, rooted: false, module: self.module.clone(), name, kind, line });
                return;
            }
        }
        left = &left[1..];
        while left.first().is_some_and(|segment| segment == "super") {
            path.pop();
            left = &left[1..];
        }
        path.extend(left.iter().filter(|segment| *segment != "self").cloned());
        let line = self.tokens[at].1;
        self.found.push(Import { path, rooted: true, module: self.module.clone(), name, kind, line });
    }
}
