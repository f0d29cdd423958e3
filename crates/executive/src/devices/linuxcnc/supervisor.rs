//! Supervision of HAL: a thread that restarts it after it has ended.

use super::engine::{Engine, Link, Plan};
use super::error::LinuxCncError;
use rtrb::{Consumer, Producer, RingBuffer};
use seamwright_message::{Message, Unit};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{JoinHandle, park_timeout};
use std::time::{Duration, Instant};

/// Interval between checks of HAL.
const LOOK: Duration = Duration::from_millis(50);
/// Delay from a failed start to the next one.
const AGAIN: Duration = Duration::from_secs(5);
/// Capacity of the queues of links, to and from the cycle.
const LINKS: usize = 4;

/// The cycle's side of the supervision.
#[derive(Debug)]
pub(super) struct Supervisor {
    /// The streams of the restarted HAL.
    pub(super) started: Consumer<Link>,
    /// Ended streams: the thread closes them, outside of the cycle.
    pub(super) ended: Producer<Link>,
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Supervisor {
    /// Starts HAL and its supervision, which reports events to the callback. Errors: the reason why HAL does not run.
    pub(super) fn start(plan: Plan, tell: impl Fn(&Message) + Send + 'static) -> Result<(Self, Link), LinuxCncError> {
        let (engine, link) = Engine::start(&plan)?;
        let (to_cycle, started) = RingBuffer::new(LINKS);
        let (ended, from_cycle) = RingBuffer::new(LINKS);
        let ends = Arc::new(AtomicBool::new(false));
        let work = Work { plan, to_cycle, from_cycle, ends: Arc::clone(&ends) };
        let thread = std::thread::spawn(move || work.attend(engine, &tell));
        Ok((Self { started, ended, ends, thread: Some(thread) }, link))
    }

    /// Ends HAL, and closes the streams.
    pub(super) fn end(&mut self, link: Option<Link>) {
        // Set first: closed streams look like HAL's end.
        self.ends.store(true, Ordering::SeqCst);
        drop(link);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            // A panic of the thread has reported itself.
            let _ = thread.join();
        }
    }
}

/// State of the thread.
struct Work {
    plan: Plan,
    to_cycle: Producer<Link>,
    from_cycle: Consumer<Link>,
    ends: Arc<AtomicBool>,
}

impl Work {
    fn attend(mut self, mut engine: Engine, tell: &dyn Fn(&Message)) {
        while let Some(why) = self.watch(&mut engine) {
            tell(&Message::new("cell-hal-ended").message("why", why));
            engine.end(false);
            match self.again(tell) {
                Some(started) => engine = started,
                None => return,
            }
        }
        engine.end(true);
    }

    /// Watches HAL until it ends; returns the reason, or `None` at shutdown.
    fn watch(&mut self, engine: &mut Engine) -> Option<Message> {
        loop {
            while self.from_cycle.pop().is_ok() {}
            let why = engine.ended();
            if self.ends.load(Ordering::SeqCst) {
                return None;
            }
            if why.is_some() {
                return why;
            }
            park_timeout(LOOK);
        }
    }

    /// Starts HAL until it runs; `None` at shutdown.
    fn again(&mut self, tell: &dyn Fn(&Message)) -> Option<Engine> {
        let mut told = None;
        while !self.ends.load(Ordering::SeqCst) {
            match Engine::start(&self.plan) {
                Ok((engine, link)) => {
                    tell(&Message::new("cell-hal-runs-again"));
                    // There is room: the cycle has taken the earlier link, or will skip it.
                    let _ = self.to_cycle.push(link);
                    return Some(engine);
                }
                Err(error) => {
                    if told.as_ref() != Some(&error) {
                        let again = Message::new("cell-hal-retried").message("error", error.message());
                        tell(&again.value("time", AGAIN.as_secs_f64(), Unit::S));
                    }
                    told = Some(error);
                }
            }
            let begun = Instant::now();
            while begun.elapsed() < AGAIN && !self.ends.load(Ordering::SeqCst) {
                park_timeout(LOOK);
            }
        }
        None
    }
}
