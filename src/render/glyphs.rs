//! Letters as strokes, for the few words inside a picture: scales and axes. A window has better type for the rest.

use glam::Vec2;

/// Space between letters, and the width of one that has no strokes, in letter heights.
const GAP: f32 = 0.30;
const BLANK: f32 = 0.35;
/// Steps of the grid a letter height.
const GRID: f32 = 6.0;

/// Polylines of a letter on a grid six high; each pair of digits is a point, right and up.
fn strokes(letter: char) -> &'static str {
    match letter {
        '0' => "1030414536160501 0110",
        '1' => "152620 1030",
        '2' => "05163645440000 0040",
        '3' => "0516364544331333 334241301001",
        '4' => "36020242 3430",
        '5' => "4606032334424130 301001",
        '6' => "4536160501103041423303",
        '7' => "064610",
        '8' => "13040516364544331302011030414233",
        '9' => "0110304145361605041343",
        'm' => "0004 031424333330 334454636360",
        'c' => "4334140301103041",
        'k' => "0006 0134 1240",
        'n' => "0004 03143443 4340",
        'µ' => "0-04 01103041 4440",
        'X' => "0046 0640",
        'Y' => "062346 2320",
        'Z' => "06460040",
        '.' => "1020",
        '-' => "1333",
        _ => "",
    }
}

/// A text as polylines and its width: its lower left corner at the origin, one unit high. What has no strokes leaves a
/// space.
pub(super) fn text(text: &str) -> (Vec<Vec<Vec2>>, f32) {
    let (mut lines, mut right) = (Vec::new(), 0.0_f32);
    for (place, letter) in text.chars().enumerate() {
        let left = if place > 0 { right + GAP } else { 0.0 };
        let letter = strokes_of(letter);
        let width = letter.iter().flatten().map(|point| point.x).reduce(f32::max).unwrap_or(BLANK);
        lines.extend(letter.into_iter().map(|line| line.into_iter().map(|at| at + Vec2::X * left).collect()));
        right = left + width;
    }
    (lines, right)
}

fn strokes_of(letter: char) -> Vec<Vec<Vec2>> {
    // What hangs below the line is written with a minus.
    let at = |digit: u8| if digit == b'-' { -0.25 } else { f32::from(digit.saturating_sub(b'0')) / GRID };
    let point = |pair: &[u8]| Vec2::new(at(pair[0]), at(pair[1]));
    let line = |digits: &str| digits.as_bytes().chunks_exact(2).map(point).collect();
    strokes(letter).split_terminator(' ').map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_scales_and_axes_has_strokes_within_its_box() {
        for letter in "0123456789mcknµXYZ.-".chars() {
            let (lines, width) = text(&letter.to_string());
            assert!(!lines.is_empty(), "{letter}");
            for point in lines.iter().flatten() {
                assert!((0.0..=width).contains(&point.x) && (-0.26..=1.0).contains(&point.y), "{letter} {point}");
            }
        }
        assert!(text("? ").0.is_empty());
        let [one, two] = ["1", "11"].map(|letters| text(letters).1);
        assert!((two - 2.0 * one - GAP).abs() < 1e-6);
    }
}
