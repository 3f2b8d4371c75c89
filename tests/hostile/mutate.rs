//! Files made of sound ones by chance, the same on every machine.

use serde_json::{Value, json};

/// Steele, Lea and Flood's `SplitMix64`.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to below `end`, which is above 0.
    pub fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    pub fn one_of<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }
}

/// Longest file that comes of it [bytes].
const LONGEST: usize = 1 << 16;

/// Numbers that break what was not thought through.
const NUMBERS: [&str; 24] = [
    "0",
    "-1",
    "1",
    "-0.0",
    "0.5",
    "2",
    "255",
    "65535",
    "4294967295",
    "4294967296",
    "-2147483648",
    "9223372036854775807",
    "18446744073709551615",
    "1e300",
    "-1e300",
    "1e308",
    "5e-324",
    "1e-300",
    "1e9",
    "1e-9",
    "nan",
    "inf",
    "1e999",
    "1000000",
];

/// Words that stand in one place or other of JSON.
const JSON: [&str; 14] =
    ["null", "true", "[]", "{}", "\"\"", "[[]]", "{\"\":0}", ",", ":", "]", "}", "\"", "\\u0000", "[0,0,0]"];

/// A file made of one of `sound`, with `words` of its format.
pub fn mutated(random: &mut Random, sound: &[Vec<u8>], words: &[&str]) -> Vec<u8> {
    let mut bytes = sound[random.below(sound.len())].clone();
    if bytes.starts_with(b"{") && random.below(10) < 7 {
        let changed = serde_json::from_slice(&bytes).ok().map(|mut value: Value| {
            for _ in 0..=random.below(3) {
                in_tree(random, &mut value);
            }
            value.to_string().into_bytes()
        });
        return changed.unwrap_or(bytes);
    }
    for _ in 0..=random.below(4) {
        change(random, &mut bytes, sound, words);
    }
    bytes.truncate(LONGEST);
    bytes
}

fn change(random: &mut Random, bytes: &mut Vec<u8>, sound: &[Vec<u8>], words: &[&str]) {
    let at = random.below(bytes.len() + 1);
    let length = random.below(bytes.len() - at + 1).min(1 + random.below(64));
    match random.below(12) {
        0 => {
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len().max(1));
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
        1 => bytes.truncate(at),
        2 => drop(bytes.drain(at..at + length)),
        3 => {
            let piece = bytes[at..at + length].repeat(1 + random.below(20));
            bytes.splice(at..at, piece);
        }
        4 | 5 => number(random, bytes, at),
        6 => {
            let word = random.one_of(&JSON);
            bytes.splice(at..at + length.min(4), word.bytes());
        }
        7 if !words.is_empty() => {
            let word = random.one_of(words);
            bytes.splice(at..at, word.bytes());
        }
        8 => {
            // A piece of another file.
            let other = &sound[random.below(sound.len())];
            let from = random.below(other.len() + 1);
            let to = (from + 1 + random.below(200)).min(other.len());
            bytes.splice(at..at + length, other[from..to.max(from)].iter().copied());
        }
        9 => {
            // A line goes, or stands twice.
            let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |line| line + 1);
            let end = bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |line| at + line + 1);
            let line = bytes[start..end].to_vec();
            if random.below(2) == 0 {
                bytes.drain(start..end);
            } else {
                bytes.splice(start..start, line);
            }
        }
        10 => {
            // A binary number.
            let odd = [0, 1, u32::MAX, 0x7fff_ffff, 0x8000_0000, 0x7f80_0000, 0x7fc0_0000, 0x0080_0000, 0xffff];
            let word = odd[random.below(odd.len())];
            let word = if random.below(2) == 0 { word.to_le_bytes() } else { word.to_be_bytes() };
            for (byte, new) in bytes.iter_mut().skip(at).zip(word) {
                *byte = new;
            }
        }
        _ => {
            let new = (random.next() & 0xff) as u8;
            if let Some(byte) = bytes.get_mut(at) {
                *byte = new;
            } else {
                bytes.push(new);
            }
        }
    }
}

/// Pointers to all values below the root.
fn places(value: &Value, path: &str, out: &mut Vec<String>) {
    let children: Vec<(String, &Value)> = match value {
        Value::Object(members) => members.iter().map(|(name, member)| (name.clone(), member)).collect(),
        Value::Array(items) => items.iter().enumerate().map(|(index, item)| (index.to_string(), item)).collect(),
        _ => Vec::new(),
    };
    for (name, child) in children {
        let path = format!("{path}/{name}");
        places(child, &path, out);
        out.push(path);
    }
}

/// Changes a value of a tree, or gives a place what stands at another.
fn in_tree(random: &mut Random, value: &mut Value) {
    let mut all = Vec::new();
    places(value, "", &mut all);
    if all.is_empty() {
        return;
    }
    let (at, from) = (random.below(all.len()), random.below(all.len()));
    let other = value.pointer(&all[from]).cloned().unwrap_or_default();
    let Some(place) = value.pointer_mut(&all[at]) else { return };
    let factor = [0.0, 0.5, 0.9, 1.1, 2.0, 10.0, 1e3, 1e-3, -1.0, 1e30, 1e-30][random.below(11)];
    match (random.below(5), &mut *place) {
        (0..3, Value::Number(number)) => {
            *place = if number.is_f64() {
                json!(number.as_f64().unwrap_or_default() * factor)
            } else {
                let near = [-1, 0, 1, 2, 7, 255, 65_536, i64::from(u32::MAX), i64::MAX][random.below(9)];
                json!(near.wrapping_add(number.as_i64().unwrap_or_default() % 3))
            };
        }
        (0..2, Value::Array(items)) if !items.is_empty() => {
            let item = items[random.below(items.len())].clone();
            items.extend(std::iter::repeat_n(item, 1 + random.below(3)));
        }
        (2, Value::Array(items)) => drop(items.pop()),
        (0..2, Value::Object(members)) if !members.is_empty() => {
            let name = members.keys().nth(random.below(members.len())).cloned().unwrap_or_default();
            members.remove(&name);
        }
        (0, Value::Bool(is)) => *place = json!(!*is),
        (0..4, _) => *place = other,
        _ => {
            let odd = [json!(null), json!(0), json!(-1), json!(1e300), json!(""), json!([]), json!({}), json!("x")];
            *place = odd[random.below(odd.len())].clone();
        }
    }
}

/// Puts another number in the place of the next one in the text.
fn number(random: &mut Random, bytes: &mut Vec<u8>, at: usize) {
    let is_part = |byte: u8| byte.is_ascii_digit() || b"+-.".contains(&byte);
    let Some(start) = bytes[at..].iter().position(|&byte| is_part(byte)).map(|first| at + first) else { return };
    let end = bytes[start..].iter().position(|&byte| !is_part(byte)).map_or(bytes.len(), |length| start + length);
    let new = random.one_of(&NUMBERS);
    bytes.splice(start..end, new.bytes());
}
