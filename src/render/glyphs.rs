//! Letters as strokes, for the few words inside a picture: scales and axes. A window has better type for the rest.

use glam::Vec2;

/// Width of a letter's box and step from one to the next, in letter heights.
const ADVANCE: f32 = 0.80;

/// Polylines of a letter on a grid four wide and six high; each pair of digits is a point, right and up.
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
        'm' => "0004 0314233020 23344330 4340",
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

/// A text as polylines: its lower left corner at the origin, one unit high. What has no strokes leaves a space.
pub(super) fn text(text: &str) -> Vec<Vec<Vec2>> {
    (0_u16..)
        .zip(text.chars())
        .flat_map(|(place, letter)| {
            strokes(letter).split(' ').map(move |line| {
                let digits: Vec<u8> = line.bytes().collect();
                digits
                    .chunks_exact(2)
                    .map(|pair| {
                        // What hangs below the line is written with a minus.
                        let at = |digit: u8| if digit == b'-' { -1.5 } else { f32::from(digit - b'0') };
                        Vec2::new(at(pair[0]) / 6.0 + f32::from(place) * ADVANCE, at(pair[1]) / 6.0)
                    })
                    .collect()
            })
        })
        .filter(|line: &Vec<Vec2>| line.len() > 1)
        .collect()
}

/// Width of a text in letter heights.
pub(super) fn width(text: &str) -> f32 {
    (text.chars().count() as f32 - 1.0).max(0.0) * ADVANCE + 4.0 / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_scales_and_axes_has_strokes_within_its_box() {
        for letter in "0123456789mcknµXYZ.-".chars() {
            let lines = text(&letter.to_string());
            assert!(!lines.is_empty(), "{letter}");
            for point in lines.iter().flatten() {
                assert!((0.0..=0.67).contains(&point.x) && (-0.26..=1.0).contains(&point.y), "{letter} {point}");
            }
        }
        assert!(text("? ").is_empty());
        assert!((width("12") - (ADVANCE + 0.667)).abs() < 1e-3);
    }
}
