use seamwright_message::{Argument, Message};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Priority of the cycle, 1 to 99: above ordinary work, below the kernel's own threads.
const CYCLE: u8 = 80;
/// Priority of the cycle's supervisor: an endless loop of the cycle must not keep it from running.
const ABOVE: u8 = 85;
/// Priority of the cycle's device threads.
const BELOW: u8 = 70;

/// Real-time resources that the system grants to the calling thread.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RealtimeRights {
    /// Real-time priority (SCHED_FIFO), or the reason for its refusal.
    pub priority: Result<(), Message>,
    /// Memory locked against paging, or the reason for its refusal.
    pub memory: Result<(), Message>,
    /// CPU to stay on, if requested, or the reason for its refusal.
    pub cpu: Option<Result<usize, Message>>,
}

impl RealtimeRights {
    /// Requests all of it for the calling thread; `cpu` is the CPU to stay on.
    pub fn ask(cpu: Option<usize>) -> Self {
        Self { priority: system::priority(CYCLE), memory: system::memory(), cpu: cpu.map(system::stay_on) }
    }

    /// Requests a real-time priority below that of the cycle for the calling thread, which serves devices. A refusal
    /// also affects the cycle, which reports it.
    pub(crate) fn ask_below_cycle() {
        let _ = system::priority(BELOW);
    }

    /// Requests a real-time priority above that of the cycle for the calling thread, which supervises it.
    pub(super) fn ask_above_cycle() {
        let _ = system::priority(ABOVE);
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

impl RealtimeRights {
    /// Returns its message: granted, or what is missing and how it is granted.
    pub fn message(&self) -> Message {
        let refused = |code, why: Option<&Message>| why.map(|why| Message::new(code).message("why", why.clone()));
        let missing = [
            refused("cell-realtime-no-priority", self.priority.as_ref().err()),
            refused("cell-realtime-memory-not-locked", self.memory.as_ref().err()),
            refused("cell-realtime-no-cpu", self.cpu.as_ref().and_then(|cpu| cpu.as_ref().err())),
        ];
        if self.is_whole() {
            return Message::new("cell-realtime-granted");
        }
        let missing = missing.into_iter().flatten().map(|one| Argument::Message(Box::new(one)));
        Message::new("cell-realtime-degraded").list("missing", missing)
    }

    /// Returns the event of a weld without the rights of these keys, see [`RealtimeRights::missing`].
    pub fn event(missing: &[&str]) -> Message {
        let named = |key: &&str| match *key {
            "priority" => Message::new("cell-right-priority"),
            "memory" => Message::new("cell-right-memory"),
            "cpu" => Message::new("cell-right-cpu"),
            other => Message::verbatim(other),
        };
        let rights = missing.iter().map(|key| Argument::Message(Box::new(named(key))));
        Message::new("cell-event-without-rights").list("rights", rights)
    }
}

impl fmt::Display for RealtimeRights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

#[cfg(target_os = "linux")]
mod system {
    use rustix::mm::{MlockAllFlags, mlockall};
    use rustix::thread::{CpuSet, sched_setaffinity};
    use seamwright_message::Message;
    use thread_priority::unix::{RealtimeThreadSchedulePolicy, ThreadSchedulePolicy, set_thread_priority_and_policy};
    use thread_priority::{ThreadPriority, ThreadPriorityValue, thread_native_id};

    pub(super) fn priority(value: u8) -> Result<(), Message> {
        let value = ThreadPriorityValue::try_from(value).map_err(Message::verbatim)?;
        let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        let set = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(value), policy);
        set.map_err(|e| Message::verbatim(format!("{e:?}")))
    }

    pub(super) fn memory() -> Result<(), Message> {
        mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE).map_err(|e| Message::outside(&e))
    }

    pub(super) fn stay_on(cpu: usize) -> Result<usize, Message> {
        let mut set = CpuSet::new();
        if cpu >= CpuSet::MAX_CPU {
            return Err(Message::new("cell-no-such-cpu").number("cpu", cpu as f64, 0));
        }
        set.set(cpu);
        sched_setaffinity(None, &set).map(|()| cpu).map_err(|e| Message::outside(&e))
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use seamwright_message::Message;

    const NOT_HERE: Message = Message::new("cell-only-on-linux");

    pub(super) fn priority(_value: u8) -> Result<(), Message> {
        Err(NOT_HERE)
    }

    pub(super) fn memory() -> Result<(), Message> {
        Err(NOT_HERE)
    }

    pub(super) fn stay_on(_cpu: usize) -> Result<usize, Message> {
        Err(NOT_HERE)
    }
}
