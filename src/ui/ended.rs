//! Ends from outside: signals, where the system has them.

/// Calls `keep` once before a signal ends the program, as the system would have it end. Signals that are ignored stay
/// so, and hang-ups of which that cannot be told are left to the system.
#[cfg(unix)]
pub(super) fn before_the_end(keep: impl Fn() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    // Without a thread that listens, signals end the program at once.
    let listen = move || {
        let is_heeded = |signal: &&i32| crate::io::heeds(**signal).unwrap_or(**signal != SIGHUP);
        let Ok(mut signals) = Signals::new([SIGHUP, SIGINT, SIGTERM].iter().filter(is_heeded)) else { return };
        if let Some(signal) = signals.forever().next() {
            keep();
            // It does not come back from one that ends programs.
            emulate_default_handler(signal).ok();
        }
    };
    std::thread::Builder::new().name("ends from outside".into()).spawn(listen).ok();
}

/// Nothing: the system asks windows to close.
#[cfg(not(unix))]
pub(super) fn before_the_end(_keep: impl Fn() + Send + 'static) {}
