use std::fmt;

/// Priority of the cycle, 1 to 99: above ordinary work, below the kernel's own threads.
const CYCLE: u8 = 80;
/// Priority of the cycle's device threads.
const BELOW: u8 = 70;

/// Real-time resources that the system grants to the calling thread.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Footing {
    /// Real-time priority (SCHED_FIFO), or the reason for its refusal.
    pub priority: Result<(), String>,
    /// Memory locked against paging, or the reason for its refusal.
    pub memory: Result<(), String>,
    /// CPU to stay on, if requested, or the reason for its refusal.
    pub cpu: Option<Result<usize, String>>,
}

impl Footing {
    /// Requests all of it for the calling thread; `cpu` is the CPU to stay on.
    pub fn ask(cpu: Option<usize>) -> Self {
        Self { priority: system::priority(CYCLE), memory: system::memory(), cpu: cpu.map(system::stay_on) }
    }

    /// Requests a real-time priority below that of the cycle for the calling thread, which serves devices. A refusal
    /// also affects the cycle, which reports it.
    pub(crate) fn ask_below_cycle() {
        let _ = system::priority(BELOW);
    }

    /// Returns the missing resources, by key: `priority`, `memory`, `cpu`.
    pub fn missing(&self) -> impl Iterator<Item = &'static str> {
        let cpu = self.cpu.as_ref().is_some_and(Result::is_err);
        let all = [("priority", self.priority.is_err()), ("memory", self.memory.is_err()), ("cpu", cpu)];
        all.into_iter().filter_map(|(key, is_missing)| is_missing.then_some(key))
    }

    /// Returns true if all requested resources were granted.
    pub fn is_whole(&self) -> bool {
        self.priority.is_ok() && self.memory.is_ok() && self.cpu.as_ref().is_none_or(Result::is_ok)
    }
}

impl fmt::Display for Footing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_whole() {
            return f.write_str("real-time priority, memory locked");
        }
        f.write_str("degraded:")?;
        if let Err(why) = &self.priority {
            write!(f, " no real-time priority ({why}; allow it with `ulimit -r` or CAP_SYS_NICE)")?;
        }
        if let Err(why) = &self.memory {
            write!(f, " memory not locked ({why}; allow it with `ulimit -l` or CAP_IPC_LOCK)")?;
        }
        if let Some(Err(why)) = &self.cpu {
            write!(f, " not on the CPU asked for ({why})")?;
        }
        Ok(())
    }
}

#[cfg(target_os = "linux")]
mod system {
    use rustix::mm::{MlockAllFlags, mlockall};
    use rustix::thread::{CpuSet, sched_setaffinity};
    use thread_priority::unix::{RealtimeThreadSchedulePolicy, ThreadSchedulePolicy, set_thread_priority_and_policy};
    use thread_priority::{ThreadPriority, ThreadPriorityValue, thread_native_id};

    pub(super) fn priority(value: u8) -> Result<(), String> {
        let value = ThreadPriorityValue::try_from(value)?;
        let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        let set = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(value), policy);
        set.map_err(|e| format!("{e:?}"))
    }

    pub(super) fn memory() -> Result<(), String> {
        mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE).map_err(|e| e.to_string())
    }

    pub(super) fn stay_on(cpu: usize) -> Result<usize, String> {
        let mut set = CpuSet::new();
        if cpu >= CpuSet::MAX_CPU {
            return Err(format!("there is no CPU {cpu}"));
        }
        set.set(cpu);
        sched_setaffinity(None, &set).map(|()| cpu).map_err(|e| e.to_string())
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    const NOT_HERE: &str = "only on Linux";

    pub(super) fn priority(_value: u8) -> Result<(), String> {
        Err(NOT_HERE.to_owned())
    }

    pub(super) fn memory() -> Result<(), String> {
        Err(NOT_HERE.to_owned())
    }

    pub(super) fn stay_on(_cpu: usize) -> Result<usize, String> {
        Err(NOT_HERE.to_owned())
    }
}
