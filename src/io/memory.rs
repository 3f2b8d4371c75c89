//! How much memory is free.

use std::fs;

/// Memory that can be had without others being put aside for it [bytes], where the system tells.
pub(crate) fn free_memory() -> Option<u64> {
    free_in(&fs::read_to_string("/proc/meminfo").ok()?)
}

/// That of the kernel's list, which counts in KiB.
fn free_in(list: &str) -> Option<u64> {
    let line = list.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let number: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    number.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_free_is_read_from_the_list() {
        let list =
            "MemTotal:       24592132 kB\nMemFree:          407276 kB\nMemAvailable:   19290624 kB\nBuffers: 1 kB\n";
        assert_eq!(free_in(list), Some(19_290_624 * 1024));
        for other in ["", "MemTotal: 5 kB\n", "MemAvailable: many kB\n", "MemAvailable: 5\n"] {
            assert_eq!(free_in(other), None, "{other}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn this_machine_has_some() {
        assert!(free_memory().is_some_and(|free| free > 1 << 20));
    }
}
