//! Numbers as people type them: with arithmetic and with units, such as `2*3cm` or `1.5 kg / 4`.
//!
//! How it works. A recursive descent over sums, products, powers and parentheses, whose values carry powers of metre,
//! kilogram and second. A plain number takes the unit of what it is typed for; one with units is taken only where these
//! fit.

/// Powers of metre, kilogram and second.
type Dimension = [i8; 3];

/// A value in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Quantity {
    value: f64,
    of: Dimension,
}

const NONE: Dimension = [0; 3];

/// What a unit is in SI units: longer names before those that they begin with.
const UNITS: [(&str, f64, Dimension); 30] = [
    ("MPa", 1e6, [-1, 1, -2]),
    ("GPa", 1e9, [-1, 1, -2]),
    ("kPa", 1e3, [-1, 1, -2]),
    ("Pa", 1.0, [-1, 1, -2]),
    ("degrees", 1.0, NONE),
    ("deg", 1.0, NONE),
    ("°", 1.0, NONE),
    ("%", 1e-2, NONE),
    ("×", 1.0, NONE),
    ("min", 60.0, [0, 0, 1]),
    ("mm", 1e-3, [1, 0, 0]),
    ("cm", 1e-2, [1, 0, 0]),
    ("dm", 1e-1, [1, 0, 0]),
    ("km", 1e3, [1, 0, 0]),
    ("µm", 1e-6, [1, 0, 0]),
    ("um", 1e-6, [1, 0, 0]),
    ("kg", 1.0, [0, 1, 0]),
    ("mg", 1e-6, [0, 1, 0]),
    ("ms", 1e-3, [0, 0, 1]),
    ("µs", 1e-6, [0, 0, 1]),
    ("us", 1e-6, [0, 0, 1]),
    ("mN", 1e-3, [1, 1, -2]),
    ("kN", 1e3, [1, 1, -2]),
    ("N", 1.0, [1, 1, -2]),
    ("J", 1.0, [2, 1, -2]),
    ("Hz", 1.0, [0, 0, -1]),
    ("inch", 0.0254, [1, 0, 0]),
    ("m", 1.0, [1, 0, 0]),
    ("g", 1e-3, [0, 1, 0]),
    ("s", 1.0, [0, 0, 1]),
];

/// What was typed, in `unit`; none where it is no number or another kind of quantity.
pub(crate) fn typed(text: &str, unit: &str) -> Option<f64> {
    let typed = Reader::new(text).all()?;
    // A plain number is taken as it stands, whatever the unit.
    let value = if typed.of == NONE {
        typed.value
    } else {
        let unit = Reader::new(unit).unit().filter(|unit| unit.of == typed.of)?;
        typed.value / unit.value
    };
    value.is_finite().then_some(value)
}

/// Reads from the front.
struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn new(text: &'a str) -> Self {
        Self { rest: text }
    }

    fn all(mut self) -> Option<Quantity> {
        let found = self.sum()?;
        self.rest.trim().is_empty().then_some(found)
    }

    /// A unit alone, with products, quotients and powers: `kg/m³`, `N m²`, `1/s`.
    fn unit(mut self) -> Option<Quantity> {
        let is_rate = self.rest.trim_start().starts_with("1/") && self.take("1");
        let mut found = if is_rate { Quantity { value: 1.0, of: NONE } } else { self.one_unit()? };
        loop {
            if self.take("/") {
                found = divided(found, self.one_unit()?);
            } else if self.rest.trim().is_empty() {
                return Some(found);
            } else {
                found = times(found, self.one_unit()?);
            }
        }
    }

    fn take(&mut self, mark: &str) -> bool {
        let rest = self.rest.trim_start();
        let taken = rest.strip_prefix(mark);
        self.rest = taken.unwrap_or(rest);
        taken.is_some()
    }

    fn sum(&mut self) -> Option<Quantity> {
        let mut found = self.product()?;
        loop {
            let sign = if self.take("+") {
                1.0
            } else if self.take("-") || self.take("−") {
                -1.0
            } else {
                return Some(found);
            };
            let next = self.product()?;
            if next.of != found.of {
                return None;
            }
            found.value += sign * next.value;
        }
    }

    fn product(&mut self) -> Option<Quantity> {
        let mut found = self.factor()?;
        loop {
            if self.take("*") || self.take("·") {
                found = times(found, self.factor()?);
            } else if self.take("/") {
                // What a quantity is divided by may be a bare unit: `3 g/cm³`.
                let by = if self.begins_number() { self.factor()? } else { self.one_unit()? };
                found = divided(found, by);
            } else if let Some(unit) = self.one_unit() {
                found = times(found, unit);
            } else {
                return Some(found);
            }
        }
    }

    fn begins_number(&self) -> bool {
        self.rest.trim_start().starts_with(|c: char| c.is_ascii_digit() || ".(-+".contains(c))
    }

    fn factor(&mut self) -> Option<Quantity> {
        if self.take("-") || self.take("−") {
            let found = self.factor()?;
            return Some(Quantity { value: -found.value, ..found });
        }
        if self.take("+") {
            return self.factor();
        }
        let found = if self.take("(") {
            let found = self.sum()?;
            self.take(")").then_some(found)?
        } else {
            self.number()?
        };
        Some(self.raised(found))
    }

    fn number(&mut self) -> Option<Quantity> {
        let text = self.rest.trim_start();
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let mut end = digits(text);
        // An exponent, but not the beginning of a word.
        if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
            let sign = exponent.len() - exponent.trim_start_matches(['-', '+']).len();
            let more =
                exponent[sign.min(1)..].find(|c: char| !c.is_ascii_digit()).unwrap_or(exponent.len() - sign.min(1));
            if more > 0 && sign <= 1 {
                end += 1 + sign + more;
            }
        }
        let value = text[..end].parse().ok()?;
        self.rest = &text[end..];
        Some(Quantity { value, of: NONE })
    }

    fn one_unit(&mut self) -> Option<Quantity> {
        let text = self.rest.trim_start();
        let &(name, value, of) = UNITS.iter().find(|(name, ..)| text.starts_with(name))?;
        self.rest = &text[name.len()..];
        // A longer word is none of them.
        if name.ends_with(char::is_alphabetic) && self.rest.starts_with(char::is_alphabetic) {
            self.rest = text;
            return None;
        }
        Some(self.raised(Quantity { value, of }))
    }

    /// Squares and cubes, as `²`, `^2` or, behind a unit, `2`.
    fn raised(&mut self, of: Quantity) -> Quantity {
        let is_unit = of.of != NONE;
        let power = if self.rest.starts_with('²')
            || self.rest.starts_with("^2")
            || (is_unit && self.rest.starts_with('2'))
        {
            2
        } else if self.rest.starts_with('³') || self.rest.starts_with("^3") || (is_unit && self.rest.starts_with('3'))
        {
            3
        } else {
            return of;
        };
        let mark = self.rest.chars().take_while(|c| *c == '^').map(char::len_utf8).sum::<usize>();
        self.rest = &self.rest[mark + self.rest[mark..].chars().next().map_or(0, char::len_utf8)..];
        (1..power).fold(of, |product, _| times(product, of))
    }
}

fn times(a: Quantity, b: Quantity) -> Quantity {
    Quantity { value: a.value * b.value, of: [0, 1, 2].map(|k| a.of[k].saturating_add(b.of[k])) }
}

fn divided(a: Quantity, b: Quantity) -> Quantity {
    Quantity { value: a.value / b.value, of: [0, 1, 2].map(|k| a.of[k].saturating_sub(b.of[k])) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_and_units_come_to_what_a_field_takes() {
        for (text, unit, expected) in [
            ("7", "m", 7.0),
            ("-2.5e-3", "m", -2.5e-3),
            ("2*3cm", "m", 0.06),
            ("2*3cm", "mm", 60.0),
            ("1 cm + 5mm", "m", 0.015),
            ("(1+2)/4", "", 0.75),
            ("1.2 g/cm3", "kg/m³", 1200.0),
            ("1 g/cm³", "kg/m³", 1000.0),
            ("120 kPa", "Pa", 1.2e5),
            ("3 kN / 2", "N", 1500.0),
            ("2 cm * 3 cm", "m²", 6e-4),
            ("1.5kg/4", "kg", 0.375),
            ("250 ms", "s", 0.25),
            ("9.81 m/s2", "m/s²", 9.81),
            ("1e-9 N m²", "N m²", 1e-9),
            ("50%", "", 0.5),
            ("45°", "°", 45.0),
            ("2^3", "", 8.0),
            (" -(2 - 5) ", "mm", 3.0),
            ("-0.5", "1/s", -0.5),
            ("3/ms", "1/s", 3000.0),
            ("20 Hz", "1/s", 20.0),
            ("1/2", "turns", 0.5),
        ] {
            let found = typed(text, unit).unwrap_or_else(|| panic!("{text} is taken for {unit}"));
            assert!((found / expected - 1.0).abs() < 1e-12, "{text} in {unit}: {found}");
        }
    }

    #[test]
    fn what_is_no_such_quantity_is_not_taken() {
        for (text, unit) in [
            ("", "m"),
            ("nonsense", "m"),
            ("3 kg", "m"),
            ("3cm", ""),
            ("1 cm + 2", "m"),
            ("2 *", "m"),
            ("(1", "m"),
            ("1/0", "m"),
            ("3 metres", "m"),
            ("1 2", "m"),
        ] {
            assert_eq!(typed(text, unit), None, "{text} for {unit}");
        }
    }
}
