//! The stable step, measured at load.

use crate::common::*;

fn critical(scene: &sinew::scene::Scene) -> f64 {
    baked(scene).world.bodies()[0].parts().stable_dt
}

#[test]
fn critical_steps_of_the_bars() {
    let short = critical(&in_space(short_bar(5e7)));
    let long = critical(&in_space(block([5, 15, 5], 3e8)));
    println!("short {short:.4e} s, long {long:.4e} s");
    assert!((short / 3.32e-5 - 1.0).abs() < 0.02, "{short}");
    assert!((long / 1.36e-5 - 1.0).abs() < 0.02, "{long}");
}
