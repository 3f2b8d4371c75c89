//! The `sinew` binary: arguments in, a headless command or the window out.

fn main() {}
