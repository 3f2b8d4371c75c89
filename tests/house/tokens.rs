//! Words and marks of Rust source with their lines: it knows comments, literals, words and `::`, and that is enough.

/// One word or mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Token {
    Word(String),
    PathSeparator,
    Open,
    Close,
    Comma,
    Other(char),
}

/// Words and marks of a source text with their lines; comments and literals are left out.
pub fn tokens(text: &str) -> Vec<(Token, usize)> {
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
