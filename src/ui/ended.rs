//! Ends from outside: signals, where the system has them.

/// Calls `keep` once before a signal ends the program, as the system would have it end. Where no thread can be had for that, it
/// just ends.
#[cfg(unix)]
pub(super) fn before_the_end(keep: impl Fn() -> bool + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    let hang_up = crate::io::heeds_hang_ups().then_some(SIGHUP);
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM].into_iter().chain(hang_up)) else { return };
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            keep();
            // It does not come back from one that ends programs.
            emulate_default_handler(signal).ok();
        }
    };
    std::thread::Builder::new().name("ends from outside".into()).spawn(wait).ok();
}

/// Nothing: the system asks windows to close.
#[cfg(not(unix))]
pub(super) fn before_the_end(_keep: impl Fn() -> bool + Send + 'static) {}
