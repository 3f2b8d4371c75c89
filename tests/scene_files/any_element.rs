//! Elements at random, and numbers that scenes are made of.

use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::Value;
use sinew::scene::{Element, ElementLaw, ElementMeasure, Extra, SpringLaw};

/// Numbers in the accepted range, of every exponent and any mantissa.
pub fn number() -> impl Strategy<Value = f64> {
    (any::<i64>(), -15_i32..15).prop_map(|(mantissa, power)| mantissa as f64 / i64::MAX as f64 * 10_f64.powi(power))
}

/// The same above zero.
pub fn above_zero() -> impl Strategy<Value = f64> {
    number().prop_map(|value| value.abs().max(1e-12))
}

/// Members of newer programs, with awkward names and values.
pub fn extra() -> impl Strategy<Value = Extra> {
    let value = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        number().prop_map(Value::from),
        any::<String>().prop_map(Value::from),
        vec(number(), 0..4).prop_map(Value::from),
    ];
    proptest::collection::btree_map("x[\\PC]{0,5}", value, 0..2)
}

/// Any element.
pub fn element() -> impl Strategy<Value = Element> {
    let law = prop_oneof![
        (above_zero(), extra()).prop_map(|(stiffness, extra)| ElementLaw::Spring(SpringLaw { stiffness, extra })),
        (number(), number()).prop_map(|(a, b)| ElementLaw::Table(vec![[-1.0 / 3.0, a], [2.0 / 3.0, b]])),
    ];
    (any::<String>(), law, number(), extra()).prop_map(|(name, law, x, extra)| {
        let points = [[0.0, x, 0.0], [1.0, x, 0.0], [0.0, x, 1.0]];
        Element { name, extra, ..Element::new("element", ElementMeasure::Turn, points, law) }
    })
}
