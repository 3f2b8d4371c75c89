//! Lists of values and the combinations that a sweep runs.

use super::super::CliError;
use super::super::prepare::Assignment;
use serde::Serialize;
use serde_json::{Map, Value};
use std::str::FromStr;

/// More combinations than this are refused.
const MOST_ROWS: u32 = 100_000;

/// What a value of the scene, or several that change together, is to be, one after the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Vary {
    /// RFC 6901 pointer.
    pub pointer: String,
    /// Pointers to what takes the same value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tied: Vec<String>,
    #[serde(flatten)]
    pub values: Values,
}

/// Where the values come from.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Values {
    /// These.
    Values(Vec<Value>),
    /// Drawn anew for every sample.
    Random(Range),
}

/// Numbers between two, either included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Range {
    from: f64,
    to: f64,
    /// Whether equal shares of it are equal factors, not equal differences.
    log: bool,
}

impl Range {
    /// The number at a share of the way.
    fn at(self, share: f64) -> f64 {
        let Self { from, to, log } = self;
        let between = if log { from * (to / from).powf(share) } else { from + share * (to - from) };
        match share {
            0.0 => from,
            1.0 => to,
            _ => between,
        }
    }
}

impl FromStr for Vary {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Assignment { pointer, text } = text.parse()?;
        // Each pointer begins with a slash.
        let mut pointers = pointer.split(",/").enumerate().map(|(k, part)| match k {
            0 => part.to_owned(),
            _ => format!("/{part}"),
        });
        let first = pointers.next().unwrap_or_default();
        Ok(Self { pointer: first, tied: pointers.collect(), values: text.parse()? })
    }
}

impl FromStr for Values {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(found) = span(text) {
            return found;
        }
        let values: Vec<Value> = serde_json::from_str(&format!("[{text}]")).map_err(|_| {
            format!(
                "`{text}` is no list of JSON values; write 1,2,3, with text in double quotes, a range such as 0.1..0.9/9 or \
                 1e4..1e7/4/log, or 0.1..0.9/random"
            )
        })?;
        if values.is_empty() { Err("it has no value".to_owned()) } else { Ok(Self::Values(values)) }
    }
}

/// Values of a range; none of a text that is no range.
fn span(text: &str) -> Option<Result<Values, String>> {
    let (from, rest) = text.split_once("..")?;
    let (to, how) = rest.split_once('/')?;
    let (Ok(from), Ok(to)) = (from.parse::<f64>(), to.parse::<f64>()) else { return None };
    let (how, log) = how.strip_suffix("/log").map_or((how, false), |how| (how, true));
    if !from.is_finite() || !to.is_finite() {
        return Some(Err(format!("`{text}` does not end anywhere")));
    }
    if log && (from <= 0.0 || to <= 0.0) {
        return Some(Err(format!("`{text}` is logarithmic, so both of its ends must be above zero")));
    }
    let range = Range { from, to, log };
    if how == "random" {
        return Some(Ok(Values::Random(range)));
    }
    let Some(count) = how.parse::<u32>().ok().filter(|count| (2..=MOST_ROWS).contains(count)) else {
        return Some(Err(format!("`{text}`: behind the slash stands how many values, at least 2, or `random`")));
    };
    let number = |k: u32| range.at(f64::from(k) / f64::from(count - 1));
    let numbers: Vec<f64> = (0..count).map(number).collect();
    // What counts things takes whole numbers alone.
    let is_whole = !log && numbers.iter().all(|number| number.fract() == 0.0 && number.abs() < 1e15);
    let json = |number: f64| if is_whole { Value::from(number as i64) } else { Value::from(number) };
    Some(Ok(Values::Values(numbers.into_iter().map(json).collect())))
}

/// How often everything that is drawn is drawn, and from where.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Samples {
    /// How many to every combination of the lists.
    pub(super) count: u32,
    /// What they follow from.
    pub(super) seed: u64,
}

/// Every combination of the values of several lists, and for each as many samples as are asked for of those that are
/// drawn; the samples vary fastest, then the last list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Product<'a> {
    lists: &'a [Vary],
    samples: Option<Samples>,
    rows: usize,
}

impl<'a> Product<'a> {
    /// The product of `lists`.
    ///
    /// # Errors
    /// A pointer that occurs twice, more combinations than can be run, samples of nothing or nothing said of how many.
    pub(super) fn of(lists: &'a [Vary], samples: Option<Samples>) -> Result<Self, CliError> {
        let pointers = || lists.iter().flat_map(|list| std::iter::once(&list.pointer).chain(&list.tied));
        for (index, pointer) in pointers().enumerate() {
            if pointers().take(index).any(|other| other == pointer) {
                return Err(CliError::VariedTwice { pointer: pointer.clone() });
            }
        }
        let draws = lists.iter().find(|list| matches!(list.values, Values::Random(_)));
        match (draws, samples) {
            (Some(list), None) => return Err(CliError::NoSamples { pointer: list.pointer.clone() }),
            (None, Some(_)) => return Err(CliError::NothingDrawn),
            _ => {}
        }
        let of_list = |list: &Vary| match &list.values {
            Values::Values(values) => values.len() as u128,
            Values::Random(_) => 1,
        };
        let drawn = samples.map_or(1, |samples| u128::from(samples.count));
        let rows = lists.iter().map(of_list).fold(drawn, u128::saturating_mul);
        if rows > u128::from(MOST_ROWS) {
            return Err(CliError::TooManyRows { rows, limit: MOST_ROWS.into() });
        }
        Ok(Self { lists, samples, rows: rows as usize })
    }

    /// Number of combinations.
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// The lists, and their values in a combination.
    pub(super) fn row(&self, row: usize) -> Vec<(&'a Vary, Value)> {
        let count = self.samples.map_or(1, |samples| samples.count as usize);
        let (sample, mut rest) = (row % count, row / count);
        let mut found: Vec<_> = self
            .lists
            .iter()
            .enumerate()
            .rev()
            .map(|(index, list)| match &list.values {
                Values::Values(values) => {
                    let value = values[rest % values.len()].clone();
                    rest /= values.len();
                    (list, value)
                }
                Values::Random(range) => {
                    let seed = self.samples.map_or(0, |samples| samples.seed);
                    (list, Value::from(range.at(share(seed, index as u64, sample as u64))))
                }
            })
            .collect();
        found.reverse();
        found
    }

    /// A combination as assignments.
    pub(super) fn assignments(&self, row: usize) -> Vec<Assignment> {
        let each = self.row(row).into_iter().flat_map(|(list, value)| {
            let text = value.to_string();
            let pointers = std::iter::once(&list.pointer).chain(&list.tied);
            pointers.map(move |pointer| Assignment { pointer: pointer.clone(), text: text.clone() })
        });
        each.collect()
    }

    /// A combination as a JSON object.
    pub(super) fn object(&self, row: usize) -> Map<String, Value> {
        self.row(row).into_iter().map(|(list, value)| (list.pointer.clone(), value)).collect()
    }

    /// A combination on one line.
    pub(super) fn line(&self, row: usize) -> String {
        let pairs = self.row(row).into_iter().map(|(list, value)| format!("{}={value}", list.pointer));
        pairs.collect::<Vec<_>>().join(", ")
    }
}

/// A share from 0 to 1 that follows from three numbers alone (SplitMix64), so that each row's is known without the
/// others'.
fn share(seed: u64, list: u64, sample: u64) -> f64 {
    let mixed = [list, sample].into_iter().fold(mix(seed), |state, next| mix(state ^ mix(next)));
    (mixed >> 11) as f64 / (1_u64 << 53) as f64
}

fn mix(state: u64) -> u64 {
    let z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn values(text: &str) -> Vec<Value> {
        match text.parse().unwrap() {
            Values::Values(values) => values,
            Values::Random(range) => panic!("{range:?}"),
        }
    }

    fn lines(lists: &[Vary], samples: Option<Samples>) -> Vec<String> {
        let product = Product::of(lists, samples).unwrap();
        (0..product.rows()).map(|row| product.line(row)).collect()
    }

    #[test]
    fn values_are_json_and_may_be_lists_themselves() {
        assert_eq!(values("[0,-9.81,0],[0,0,0]"), [json!([0, -9.81, 0]), json!([0, 0, 0])]);
        for bad in ["/a", "/a=", "/a=1,", "/a=x", "/a=1],[2", "/a=1..2", "/a=1..2/1", "/a=1..2/x", "/a=0..2/3/log"] {
            assert!(bad.parse::<Vary>().is_err(), "{bad}");
        }
    }

    #[test]
    fn ranges_have_both_their_ends() {
        assert_eq!(values("0.1..0.9/3"), [json!(0.1), json!(0.5), json!(0.9)]);
        assert_eq!(values("2..8/4"), [json!(2), json!(4), json!(6), json!(8)]);
        assert_eq!(values("1e4..1e7/4/log").len(), 4);
        let middle = values("1e4..1e6/3/log")[1].as_f64().unwrap();
        assert!((middle / 1e5 - 1.0).abs() < 1e-12, "{middle}");
    }

    #[test]
    fn the_last_list_varies_fastest() {
        let lists: [Vary; 2] = ["/a=1,2".parse().unwrap(), "/b=3,4,5".parse().unwrap()];
        assert_eq!(
            lines(&lists, None),
            ["/a=1, /b=3", "/a=1, /b=4", "/a=1, /b=5", "/a=2, /b=3", "/a=2, /b=4", "/a=2, /b=5"]
        );
    }

    #[test]
    fn tied_pointers_take_the_same_value() {
        let lists: [Vary; 1] = ["/a,/b/c=1,2".parse().unwrap()];
        let product = Product::of(&lists, None).unwrap();
        let set: Vec<String> =
            product.assignments(1).iter().map(|set| format!("{}={}", set.pointer, set.text)).collect();
        assert_eq!(set, ["/a=2", "/b/c=2"]);
    }

    #[test]
    fn samples_follow_from_their_seed_and_stay_in_their_range() {
        let lists: [Vary; 3] =
            ["/a=1,2".parse().unwrap(), "/b=-1..3/random".parse().unwrap(), "/c=1..100/random/log".parse().unwrap()];
        let of = |seed| lines(&lists, Some(Samples { count: 50, seed }));
        assert_eq!(of(7), of(7));
        assert_ne!(of(7), of(8));
        let product = Product::of(&lists, Some(Samples { count: 50, seed: 7 })).unwrap();
        let drawn: Vec<[f64; 2]> = (0..100)
            .map(|row| product.row(row))
            .map(|row| [row[1].1.as_f64().unwrap(), row[2].1.as_f64().unwrap()])
            .collect();
        assert!(drawn.iter().all(|[b, c]| (-1.0..=3.0).contains(b) && (1.0..=100.0).contains(c)), "{drawn:?}");
        let mean = drawn.iter().map(|[b, _]| b).sum::<f64>() / 100.0;
        assert!((mean - 1.0).abs() < 0.4, "{mean}");
        // Every combination of the lists sees the same samples.
        assert_eq!(drawn[..50], drawn[50..]);
    }

    #[test]
    fn too_many_and_repeated_lists_are_refused() {
        let long: Vary = format!("/a={}", ["1"; 1000].join(",")).parse().unwrap();
        let lists: Vec<Vary> = ["/a", "/b"].map(|name| Vary { pointer: name.to_owned(), ..long.clone() }).to_vec();
        assert!(matches!(Product::of(&lists, None), Err(CliError::TooManyRows { rows: 1_000_000, .. })));
        assert!(matches!(Product::of(&[long.clone(), long.clone()], None), Err(CliError::VariedTwice { .. })));
        let tied: Vary = "/b,/a=1".parse().unwrap();
        assert!(matches!(Product::of(&[long.clone(), tied], None), Err(CliError::VariedTwice { .. })));
        assert!(matches!(Product::of(&[long], Some(Samples { count: 2, seed: 0 })), Err(CliError::NothingDrawn)));
        let drawn: Vary = "/a=1..2/random".parse().unwrap();
        assert!(matches!(Product::of(&[drawn], None), Err(CliError::NoSamples { .. })));
    }
}
