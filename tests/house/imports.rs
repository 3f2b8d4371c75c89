//! Reads the paths into this crate out of Rust source, whatever form they have. Not a Rust parser: it knows comments,
//! literals, words and `::`, and that is enough.

/// A path into the crate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// Segments below the crate's root.
    pub path: Vec<String>,
    /// Line, from 1.
    pub line: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Token {
    Word(String),
    PathSeparator,
    Open,
    Close,
    Comma,
    Other(char),
}

/// Every path of `text`, the source of `module`, that starts at the crate's root: by `crate::`, by `sinew::` in the
/// binary, or by as many `super::` as lead out of the room.
pub fn imports(text: &str, module: &[String]) -> Vec<Import> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        match root_at(&tokens, at, module) {
            Some(below) => at = read_tree(&tokens, below, &mut Vec::new(), &mut found),
            None => at += 1,
        }
    }
    found
}

/// Where the path goes on below the crate's root, if one starts there at this token.
fn root_at(tokens: &[(Token, usize)], at: usize, module: &[String]) -> Option<usize> {
    let is_separator = |at: usize| tokens.get(at).is_some_and(|(token, _)| *token == Token::PathSeparator);
    if at > 0 && is_separator(at - 1) {
        return None;
    }
    let word = |at: usize| match tokens.get(at) {
        Some((Token::Word(word), _)) if is_separator(at + 1) => Some(word.as_str()),
        _ => None,
    };
    match word(at)? {
        "crate" => Some(at + 2),
        "sinew" if module == ["main"] => Some(at + 2),
        "super" => {
            let ups = (0..tokens.len()).take_while(|k| word(at + 2 * k) == Some("super")).count();
            (ups == module.len()).then_some(at + 2 * ups)
        }
        _ => None,
    }
}

/// Reads what stands behind `::`, a word or a group; gives the token behind it.
fn read_tree(tokens: &[(Token, usize)], mut at: usize, prefix: &mut Vec<String>, found: &mut Vec<Import>) -> usize {
    let depth = prefix.len();
    loop {
        match tokens.get(at) {
            Some((Token::Word(word), line)) => {
                prefix.push(word.clone());
                at += 1;
                if matches!(tokens.get(at), Some((Token::PathSeparator, _))) {
                    at += 1;
                    continue;
                }
                found.push(Import { path: prefix.clone(), line: *line });
            }
            Some((Token::Open, _)) => at = read_group(tokens, at + 1, prefix, found),
            // A glob, or a generic argument behind `::`.
            Some((_, line)) if !prefix.is_empty() => found.push(Import { path: prefix.clone(), line: *line }),
            _ => {}
        }
        prefix.truncate(depth);
        return at;
    }
}

/// Reads the items of a group up to its closing brace; gives the token behind it.
fn read_group(tokens: &[(Token, usize)], mut at: usize, prefix: &mut Vec<String>, found: &mut Vec<Import>) -> usize {
    loop {
        at = read_tree(tokens, at, prefix, found);
        // Whatever is left of the item, such as `as name`.
        while tokens.get(at).is_some_and(|(token, _)| !matches!(token, Token::Comma | Token::Close)) {
            at += 1;
        }
        match tokens.get(at) {
            Some((Token::Comma, _)) if !matches!(tokens.get(at + 1), Some((Token::Close, _))) => at += 1,
            Some((Token::Comma, _)) => return at + 2,
            _ => return at + 1,
        }
    }
}

/// Words and marks of a source text with their lines; comments and literals are left out.
fn tokens(text: &str) -> Vec<(Token, usize)> {
    let chars: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let (mut at, mut line) = (0, 1);
    while at < chars.len() {
        let next = literal_or_comment_end(&chars, at).unwrap_or_else(|| {
            let c = chars[at];
            let token = match c {
                ':' if chars.get(at + 1) == Some(&':') => Token::PathSeparator,
                '{' => Token::Open,
                '}' => Token::Close,
                ',' => Token::Comma,
                _ if is_word(c) => Token::Word(chars[at..].iter().copied().take_while(|&c| is_word(c)).collect()),
                other => Token::Other(other),
            };
            let length = match &token {
                Token::PathSeparator => 2,
                Token::Word(word) => word.chars().count(),
                _ => 1,
            };
            if !c.is_whitespace() {
                found.push((token, line));
            }
            at + length
        });
        line += chars[at..next].iter().filter(|&&c| c == '\n').count();
        at = next;
    }
    found
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The character behind the literal or comment that starts here, if one does.
fn literal_or_comment_end(chars: &[char], at: usize) -> Option<usize> {
    let end = chars.len();
    let starts = |text: &str| text.chars().eq(chars[at..].iter().copied().take(text.len()));
    let find = |from: usize, text: &str| {
        let pattern: Vec<char> = text.chars().collect();
        chars[from.min(end)..].windows(pattern.len()).position(|window| window == pattern).map(|k| from + k)
    };
    if starts("//") {
        return Some(find(at, "\n").unwrap_or(end));
    }
    if starts("/*") {
        return Some(find(at + 2, "*/").map_or(end, |close| close + 2));
    }
    if chars[at] == '\'' {
        return match chars.get(at + 1) {
            Some('\\') => Some(find(at + 3, "'").map_or(end, |close| close + 1)),
            Some(_) if chars.get(at + 2) == Some(&'\'') => Some(at + 3),
            _ => None,
        };
    }
    let in_word = at > 0 && is_word(chars[at - 1]);
    let raw =
        if in_word { 0 } else { ["br", "r"].iter().find(|prefix| starts(prefix)).map_or(0, |prefix| prefix.len()) };
    let hashes = chars[at + raw..].iter().take_while(|&&c| c == '#').count();
    if raw > 0 && chars.get(at + raw + hashes) == Some(&'"') {
        let close = format!("\"{}", "#".repeat(hashes));
        return Some(find(at + raw + hashes + 1, &close).map_or(end, |k| k + close.len()));
    }
    if chars[at] == '"' {
        let mut k = at + 1;
        while k < end && chars[k] != '"' {
            k += if chars[k] == '\\' { 2 } else { 1 };
        }
        return Some((k + 1).min(end));
    }
    None
}
