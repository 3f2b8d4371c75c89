//! The last look at numbers that go into a file: one that is none never does.
//!
//! JSON has no way to write them, and its writer takes null instead; text and binary formats write them, and other
//! programs fall over them. Everything that this crate writes asks here.

use super::IoError;
use glam::{DVec3, Vec3};
use serde::Serialize;
use serde::ser;
use std::fmt::{self, Display};
use std::io;

/// A number that is none, as writers give it.
fn not_finite(what: impl Display, value: impl Display) -> io::Error {
    let error = IoError::NotFinite { what: what.to_string(), value: value.to_string() };
    io::Error::new(io::ErrorKind::InvalidData, error)
}

/// Refuses points of which one is at no place; `what` names them.
///
/// # Errors
/// [`IoError::NotFinite`] as an [`io::Error`], with the number of the first such point, from 0.
pub(super) fn check_points(points: &[DVec3], what: impl Fn() -> String) -> io::Result<()> {
    match points.iter().position(|point| !point.is_finite()) {
        Some(index) => {
            let [x, y, z] = points[index].to_array();
            Err(not_finite(format_args!("{} {index}", what()), format_args!("({x}, {y}, {z})")))
        }
        None => Ok(()),
    }
}

/// As [`check_points`], for what is written in single precision.
pub(super) fn check_single(points: &[Vec3], what: impl Fn() -> String) -> io::Result<()> {
    match points.iter().position(|point| !point.is_finite()) {
        Some(index) => {
            check_points(&[points[index].as_dvec3()], || format!("{} {index}, in single precision,", what()))
        }
        None => Ok(()),
    }
}

/// Refuses a thing with a number in it that JSON cannot hold.
///
/// # Errors
/// [`IoError::NotFinite`] as an [`io::Error`], with the place of the number as an RFC 6901 pointer.
pub(super) fn check_numbers(thing: &impl Serialize) -> io::Result<()> {
    thing.serialize(Look).map_err(|Fault { value, path }| {
        let tokens: Vec<&str> = path.iter().rev().map(String::as_str).collect();
        not_finite(if tokens.is_empty() { "the value".to_owned() } else { format!("/{}", tokens.join("/")) }, value)
    })
}

/// Looks at every number and writes nothing.
struct Look;

/// The first number that is none, and the members that lead to it, the innermost first.
#[derive(Debug)]
struct Fault {
    value: String,
    path: Vec<String>,
}

impl Fault {
    fn within(mut self, token: impl Display) -> Self {
        self.path.push(token.to_string());
        self
    }
}

impl Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.value)
    }
}

impl std::error::Error for Fault {}

impl ser::Error for Fault {
    fn custom<T: Display>(message: T) -> Self {
        Self { value: message.to_string(), path: Vec::new() }
    }
}

fn finite(value: f64) -> Result<(), Fault> {
    if value.is_finite() { Ok(()) } else { Err(Fault { value: value.to_string(), path: Vec::new() }) }
}

/// Values without numbers with a point.
macro_rules! pass {
    ($($name:ident($type:ty)),* $(,)?) => {
        $(fn $name(self, _: $type) -> Result<(), Fault> {
            Ok(())
        })*
    };
}

impl ser::Serializer for Look {
    type Ok = ();
    type Error = Fault;
    type SerializeSeq = Members;
    type SerializeTuple = Members;
    type SerializeTupleStruct = Members;
    type SerializeTupleVariant = Members;
    type SerializeMap = Members;
    type SerializeStruct = Members;
    type SerializeStructVariant = Members;

    pass!(
        serialize_bool(bool),
        serialize_i8(i8),
        serialize_i16(i16),
        serialize_i32(i32),
        serialize_i64(i64),
        serialize_u8(u8),
        serialize_u16(u16),
        serialize_u32(u32),
        serialize_u64(u64),
        serialize_char(char),
        serialize_str(&str),
        serialize_bytes(&[u8]),
        serialize_unit_struct(&'static str),
    );

    fn serialize_f32(self, value: f32) -> Result<(), Fault> {
        finite(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Fault> {
        finite(value)
    }

    fn serialize_none(self) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_some<T: ?Sized + Serialize>(self, value: &T) -> Result<(), Fault> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_newtype_struct<T: ?Sized + Serialize>(self, _: &'static str, value: &T) -> Result<(), Fault> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: ?Sized + Serialize>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Fault> {
        value.serialize(self).map_err(|fault| fault.within(variant))
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Members, Fault> {
        Ok(Members::default())
    }

    fn serialize_tuple(self, _: usize) -> Result<Members, Fault> {
        Ok(Members::default())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Members, Fault> {
        Ok(Members::default())
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Members, Fault> {
        Ok(Members { variant: Some(variant), ..Members::default() })
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Members, Fault> {
        Ok(Members::default())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Members, Fault> {
        Ok(Members::default())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Members, Fault> {
        Ok(Members { variant: Some(variant), ..Members::default() })
    }
}

/// A thing that holds others, each of which is looked at in turn.
#[derive(Default)]
struct Members {
    variant: Option<&'static str>,
    next: usize,
    key: String,
}

impl Members {
    fn look<T: ?Sized + Serialize>(&mut self, token: impl Display, value: &T) -> Result<(), Fault> {
        self.next += 1;
        let within = |fault: Fault| match self.variant {
            Some(variant) => fault.within(token).within(variant),
            None => fault.within(token),
        };
        value.serialize(Look).map_err(within)
    }
}

/// By their places.
macro_rules! by_place {
    ($($kind:ident::$name:ident),* $(,)?) => {
        $(impl ser::$kind for Members {
            type Ok = ();
            type Error = Fault;

            fn $name<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Fault> {
                self.look(self.next, value)
            }

            fn end(self) -> Result<(), Fault> {
                Ok(())
            }
        })*
    };
}

by_place!(
    SerializeSeq::serialize_element,
    SerializeTuple::serialize_element,
    SerializeTupleStruct::serialize_field,
    SerializeTupleVariant::serialize_field,
);

/// By their names.
macro_rules! by_name {
    ($($kind:ident),* $(,)?) => {
        $(impl ser::$kind for Members {
            type Ok = ();
            type Error = Fault;

            fn serialize_field<T: ?Sized + Serialize>(&mut self, name: &'static str, value: &T) -> Result<(), Fault> {
                self.look(name, value)
            }

            fn end(self) -> Result<(), Fault> {
                Ok(())
            }
        })*
    };
}

by_name!(SerializeStruct, SerializeStructVariant);

impl ser::SerializeMap for Members {
    type Ok = ();
    type Error = Fault;

    fn serialize_key<T: ?Sized + Serialize>(&mut self, key: &T) -> Result<(), Fault> {
        let text = serde_json::to_string(key).unwrap_or_default();
        text.trim_matches('"').clone_into(&mut self.key);
        Ok(())
    }

    fn serialize_value<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Fault> {
        let key = std::mem::take(&mut self.key);
        self.look(key, value)
    }

    fn end(self) -> Result<(), Fault> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[derive(Serialize)]
    enum Choice {
        One,
        Pair(f64, f32),
        Named { value: Option<f64> },
        Whole(u8),
    }

    #[derive(Serialize)]
    struct Thing {
        name: &'static str,
        list: Vec<Choice>,
        map: BTreeMap<&'static str, [f64; 2]>,
    }

    fn thing(change: impl Fn(&mut Thing)) -> String {
        let list = vec![Choice::One, Choice::Pair(1.0, 2.0), Choice::Named { value: Some(3.0) }, Choice::Whole(4)];
        let mut thing = Thing { name: "a", list, map: BTreeMap::from([("place", [0.0, 1.0])]) };
        change(&mut thing);
        check_numbers(&thing).map_or_else(|error| error.to_string(), |()| thing.name.to_owned())
    }

    #[test]
    fn a_number_that_is_none_is_named_by_its_place() {
        type Case = (&'static str, &'static str, fn(&mut Thing));
        assert_eq!(thing(|_| {}), "a");
        assert_eq!(thing(|thing| thing.list[2] = Choice::Named { value: None }), "a");
        let cases: [Case; 4] = [
            ("/map/place/1", "inf", |thing| thing.map = BTreeMap::from([("place", [0.0, f64::INFINITY])])),
            ("/list/1/Pair/0", "NaN", |thing| thing.list[1] = Choice::Pair(f64::NAN, 0.0)),
            ("/list/1/Pair/1", "NaN", |thing| thing.list[1] = Choice::Pair(0.0, f32::NAN)),
            ("/list/2/Named/value", "-inf", |thing| thing.list[2] = Choice::Named { value: Some(-f64::INFINITY) }),
        ];
        for (place, value, change) in cases {
            let said = thing(change);
            assert!(said.contains(place) && said.contains(&format!("is {value},")), "{place}: {said}");
        }
    }

    #[test]
    fn points_name_the_first() {
        let points = [DVec3::ZERO, DVec3::new(0.0, f64::NAN, 1.0)];
        let said = check_points(&points, || "vertex".to_owned()).expect_err("it is none").to_string();
        assert!(said.contains("vertex 1 is (0, NaN, 1)"), "{said}");
        let single = check_single(&[Vec3::ZERO, Vec3::INFINITY], || "vertex".to_owned());
        assert!(single.expect_err("it is none").to_string().contains("vertex 1"));
    }
}
