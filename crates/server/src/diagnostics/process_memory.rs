use crate::wire::MemoryView;

/// Returns the memory of a process, where the system reports it (Linux: proc_pid_status(5)).
pub(super) fn of(process: u32) -> Option<MemoryView> {
    of_status(&std::fs::read_to_string(format!("/proc/{process}/status")).ok()?)
}

fn of_status(status: &str) -> Option<MemoryView> {
    let bytes = |name: &str| {
        let line = status.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'))?;
        Some(line.trim().strip_suffix(" kB")?.parse::<u64>().ok()? << 10)
    };
    Some(MemoryView { resident_bytes: bytes("VmRSS")?, locked_bytes: bytes("VmLck")? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_read_in_bytes() {
        let view = of_status("Name:\tx\nVmLck:\t      64 kB\nVmRSS:\t    1024 kB\n");
        assert_eq!(view, Some(MemoryView { resident_bytes: 1 << 20, locked_bytes: 64 << 10 }));
        assert_eq!(of_status("Name:\tx\n"), None);
        #[cfg(target_os = "linux")]
        assert!(of(std::process::id()).unwrap().resident_bytes > 1 << 20);
    }
}
