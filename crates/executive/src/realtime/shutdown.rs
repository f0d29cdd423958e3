use seamwright_message::Message;
use std::cell::Cell;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Codes of the causes other than signals: above all signal numbers.
const PANIC: usize = 1000;
const ASKED: usize = 1001;
const CYCLE_STOPPED: usize = 1002;

/// Causes of a shutdown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShutdownCause {
    /// The process received the signal of this number.
    Signal(i32),
    /// A thread of the program panicked.
    Panic,
    /// The program requested it.
    Asked,
    /// The cycle has stopped and does not come back.
    CycleStopped,
}

impl ShutdownCause {
    /// Returns its message.
    pub fn message(self) -> Message {
        match self {
            Self::Signal(number) => {
                let name = system::name(number).map_or_else(|| number.to_string(), str::to_owned);
                Message::new("cell-shutdown-signal").text("signal", name)
            }
            Self::Panic => Message::new("cell-shutdown-panic"),
            Self::Asked => Message::new("cell-shutdown-end"),
            Self::CycleStopped => Message::new("cell-shutdown-cycle-stopped"),
        }
    }
}

impl fmt::Display for ShutdownCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// A flag that ends a cell from anywhere: signals, panics, other threads.
///
/// The executive reads it before each exchange with its devices. The process is ordered off with that exchange, the
/// axes come to rest on their path, and power goes. Then [`crate::executive::Executive::serve`] returns. No other
/// thread is needed.
#[derive(Debug, Clone, Default)]
pub struct Shutdown(Arc<AtomicUsize>);

impl Shutdown {
    /// Requests the shutdown; the first cause stays.
    pub fn request(&self, cause: ShutdownCause) {
        let code = match cause {
            ShutdownCause::Signal(number) => usize::try_from(number).unwrap_or(ASKED),
            ShutdownCause::Panic => PANIC,
            ShutdownCause::Asked => ASKED,
            ShutdownCause::CycleStopped => CYCLE_STOPPED,
        };
        // It fails if an earlier cause is set.
        let _ = self.0.compare_exchange(0, code, Ordering::SeqCst, Ordering::SeqCst);
    }

    /// Returns true once a shutdown is requested.
    pub fn is_requested(&self) -> bool {
        self.0.load(Ordering::Relaxed) != 0
    }

    /// Returns the cause, once a shutdown is requested.
    pub fn cause(&self) -> Option<ShutdownCause> {
        match self.0.load(Ordering::Relaxed) {
            0 => None,
            PANIC => Some(ShutdownCause::Panic),
            ASKED => Some(ShutdownCause::Asked),
            CYCLE_STOPPED => Some(ShutdownCause::CycleStopped),
            number => Some(i32::try_from(number).map_or(ShutdownCause::Asked, ShutdownCause::Signal)),
        }
    }

    /// Redirects the signals that end or freeze a program to a shutdown request, for the rest of the process. That
    /// includes Ctrl-Z (SIGTSTP), because a frozen controller controls nothing. A file at its maximum size (SIGXFSZ)
    /// ends nothing: the write fails.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn on_signals(&self) -> std::io::Result<()> {
        system::register(&self.0)
    }

    /// Redirects the panics of all threads to a shutdown request, except those in [`contained`], for the rest of the
    /// process.
    pub fn on_panic(&self) {
        let before = std::panic::take_hook();
        let shutdown = self.clone();
        std::panic::set_hook(Box::new(move |info| {
            if !CONTAINED.get() {
                shutdown.request(ShutdownCause::Panic);
            }
            before(info);
        }));
    }
}

thread_local! {
    /// A panic of this thread stays within it.
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work`; a panic costs only its result: planning, drafting, drawing. Not for work that shares mutable data with
/// the cell.
///
/// # Errors
/// The payload of the panic.
pub fn contained<T>(work: impl FnOnce() -> T) -> std::thread::Result<T> {
    let before = CONTAINED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(work));
    CONTAINED.set(before);
    result
}

#[cfg(unix)]
mod system {
    use signal_hook::consts::{
        SIGALRM, SIGHUP, SIGINT, SIGIO, SIGPROF, SIGQUIT, SIGTERM, SIGTSTP, SIGTTIN, SIGTTOU, SIGUSR1, SIGUSR2,
        SIGVTALRM, SIGXCPU, SIGXFSZ,
    };
    use signal_hook::flag;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, AtomicUsize};

    /// Signals that end or freeze a process by default, from a person, a terminal, a service manager, a power supply or
    /// a limit of the system.
    pub(super) const SIGNALS: &[(i32, &str)] = &[
        (SIGTERM, "SIGTERM"),
        (SIGINT, "SIGINT"),
        (SIGHUP, "SIGHUP"),
        (SIGQUIT, "SIGQUIT"),
        (SIGTSTP, "SIGTSTP"),
        (SIGTTIN, "SIGTTIN"),
        (SIGTTOU, "SIGTTOU"),
        (SIGUSR1, "SIGUSR1"),
        (SIGUSR2, "SIGUSR2"),
        (SIGALRM, "SIGALRM"),
        (SIGVTALRM, "SIGVTALRM"),
        (SIGPROF, "SIGPROF"),
        (SIGIO, "SIGIO"),
        #[cfg(target_os = "linux")]
        (rustix::process::Signal::POWER.as_raw(), "SIGPWR"),
        (SIGXCPU, "SIGXCPU"),
    ];

    pub(super) fn name(number: i32) -> Option<&'static str> {
        SIGNALS.iter().find(|(known, _)| *known == number).map(|(_, name)| *name)
    }

    pub(super) fn register(flag: &Arc<AtomicUsize>) -> std::io::Result<()> {
        // A file at its maximum size: the write fails, and its caller reports that. The cell goes on.
        flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
        SIGNALS.iter().try_for_each(|(signal, _)| {
            flag::register_usize(*signal, Arc::clone(flag), usize::try_from(*signal).unwrap_or_default()).map(drop)
        })
    }
}

#[cfg(not(unix))]
mod system {
    use std::sync::Arc;
    use std::sync::atomic::AtomicUsize;

    pub(super) fn name(_number: i32) -> Option<&'static str> {
        None
    }

    /// Signals do not exist here.
    pub(super) fn register(_flag: &Arc<AtomicUsize>) -> std::io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first cause stays; a contained panic requests nothing, a panic of another thread does.
    #[test]
    fn causes_are_kept_and_contained_panics_ask_for_nothing() {
        let shutdown = Shutdown::default();
        assert_eq!(shutdown.cause(), None);
        shutdown.on_panic();
        assert!(contained(|| panic!("contained, as it should")).is_err());
        assert!(!shutdown.is_requested());
        assert!(std::thread::spawn(|| panic!("as it should")).join().is_err());
        assert_eq!(shutdown.cause(), Some(ShutdownCause::Panic));
        shutdown.request(ShutdownCause::Signal(15));
        assert_eq!(shutdown.cause(), Some(ShutdownCause::Panic));
        #[cfg(unix)]
        assert_eq!(ShutdownCause::Signal(15).to_string(), "signal SIGTERM");
    }

    /// Each signal that would end or freeze the process requests the shutdown; SIGXFSZ does not.
    #[cfg(unix)]
    #[test]
    fn signals_shut_down_and_do_not_kill() {
        use signal_hook::consts::SIGXFSZ;
        use signal_hook::low_level::raise;
        for (signal, name) in system::SIGNALS {
            let shutdown = Shutdown::default();
            shutdown.on_signals().unwrap();
            raise(SIGXFSZ).unwrap();
            assert!(!shutdown.is_requested(), "a file at its largest size ends the cell");
            raise(*signal).unwrap();
            assert_eq!(shutdown.cause(), Some(ShutdownCause::Signal(*signal)));
            assert_eq!(ShutdownCause::Signal(*signal).to_string(), format!("signal {name}"));
        }
        for named in ["SIGTTIN", "SIGTTOU", "SIGPROF", "SIGIO"] {
            assert!(system::SIGNALS.iter().any(|(_, name)| *name == named), "{named} would end or freeze the cell");
        }
    }

    #[test]
    fn a_signal_after_a_panic_changes_nothing() {
        let by_signal = Shutdown::default();
        by_signal.request(ShutdownCause::Signal(15));
        assert_eq!(by_signal.cause(), Some(ShutdownCause::Signal(15)));
    }
}
