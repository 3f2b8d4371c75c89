//! Whether a hang-up is meant for this program.

/// Whether SIGHUP is to end the program: it is not where whoever started it said so, as `nohup` does, nor where that cannot be
/// told; there the system's own way holds.
pub(crate) fn heeds_hang_ups() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    heeds(&status)
}

/// The same by what Linux tells of a process: the mask of ignored signals has SIGHUP, 1, as its lowest bit.
fn heeds(status: &str) -> bool {
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ignored_hang_up_stays_ignored() {
        assert!(heeds("Name:\tsinew\nSigIgn:\t0000000000001000\nSigCgt:\t0000000000000001\n"));
        assert!(!heeds("SigIgn:\t0000000000001001\n"));
        assert!(!heeds("Name:\tsinew\n") && !heeds("SigIgn:\tnone\n"));
    }
}
