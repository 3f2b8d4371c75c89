//! Which signals are meant for this program.

/// Whether a signal of this number is to end the program: it is not where whoever started the program said so, as
/// `nohup` says of hang-ups and shells of Ctrl-C to what runs behind them. None where that cannot be told.
pub(crate) fn heeds(signal: i32) -> Option<bool> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    heeded(&status, signal)
}

/// The same by what Linux tells of a process: the mask of ignored signals has signal 1 as its lowest bit.
fn heeded(status: &str, signal: i32) -> Option<bool> {
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"))?;
    let mask = u64::from_str_radix(mask.trim(), 16).ok()?;
    Some((mask >> (signal - 1)) & 1 == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_ignored_stays_ignored() {
        let status = "Name:\tsinew\nSigIgn:\t0000000000001002\nSigCgt:\t0000000000000001\n";
        assert_eq!([1, 2, 13, 15].map(|signal| heeded(status, signal)), [true, false, false, true].map(Some));
        assert_eq!(heeded("Name:\tsinew\n", 1), None);
        assert_eq!(heeded("SigIgn:\tnone\n", 1), None);
    }
}
