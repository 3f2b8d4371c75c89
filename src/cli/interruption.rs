//! Interruptions: Ctrl-C and what asks a program to end.
//!
//! Before a run there is nothing to lose, and the program ends at once. While it runs, the first signal ends it in
//! order, at the end of the frame or step at hand, so that what was computed until then can be written; a second one
//! ends it at once.

#[cfg(unix)]
use crate::io::heeds;
#[cfg(unix)]
use signal_hook::consts::SIGHUP;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// What a program can be asked to end by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// SIGINT: Ctrl-C.
    Interrupt,
    /// SIGTERM: somebody wants the program to end.
    Terminate,
    /// SIGHUP: the terminal that it was started from is gone.
    #[cfg(unix)]
    HangUp,
}

impl Signal {
    const ALL: &[Self] = &[
        Self::Interrupt,
        Self::Terminate,
        #[cfg(unix)]
        Self::HangUp,
    ];

    /// Whether it is to end this run. Of a hang-up that must be sure: where it is not, the system's own way holds.
    #[cfg(unix)]
    fn is_heeded(self) -> bool {
        heeds(self.number()).unwrap_or(self != Self::HangUp)
    }

    /// The same where nothing is kept off a program.
    #[cfg(not(unix))]
    fn is_heeded(self) -> bool {
        true
    }

    fn number(self) -> i32 {
        match self {
            Self::Interrupt => SIGINT,
            Self::Terminate => SIGTERM,
            #[cfg(unix)]
            Self::HangUp => SIGHUP,
        }
    }

    /// What the program ends with: 128 and the number of the signal, as shells give it; 130, 143 or 129.
    pub fn exit_code(self) -> u8 {
        128 + self.number() as u8
    }
}

impl fmt::Display for Signal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Interrupt => "SIGINT",
            Self::Terminate => "SIGTERM",
            #[cfg(unix)]
            Self::HangUp => "SIGHUP",
        })
    }
}

/// Whether a command was interrupted. One that does not listen never is.
#[derive(Clone, Debug, Default)]
pub(super) struct Interruption {
    at_once: Arc<AtomicBool>,
    number: Arc<AtomicUsize>,
}

impl Interruption {
    /// Listens from now on; until [`Self::wait_for_end`] a signal ends the program at once.
    pub(super) fn listening() -> Self {
        let this = Self::default();
        this.at_once.store(true, Ordering::SeqCst);
        for signal in Signal::ALL.iter().filter(|signal| signal.is_heeded()) {
            let number = signal.number();
            // In this order: the signal that sets the flag is not the one that it lets through. Where nothing can be
            // registered, the system's own way holds, which is to end at once.
            flag::register_conditional_shutdown(number, signal.exit_code().into(), Arc::clone(&this.at_once))
                .and_then(|_| flag::register(number, Arc::clone(&this.at_once)))
                .and_then(|_| flag::register_usize(number, Arc::clone(&this.number), number as usize))
                .ok();
        }
        this
    }

    /// One that was heard.
    #[cfg(test)]
    pub(super) fn by(signal: Signal) -> Self {
        Self { number: Arc::new(AtomicUsize::new(signal.number() as usize)), ..Self::default() }
    }

    /// From now on there is something to lose: the first signal is only heard.
    pub(super) fn wait_for_end(&self) {
        self.at_once.store(false, Ordering::SeqCst);
    }

    /// The signal that was heard, if one was.
    pub(super) fn signal(&self) -> Option<Signal> {
        let number = self.number.load(Ordering::SeqCst);
        Signal::ALL.iter().copied().find(|signal| signal.number() as usize == number)
    }
}
