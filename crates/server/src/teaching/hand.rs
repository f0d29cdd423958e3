//! The session's hand on the keys.

use super::Teaching;
use super::state::Wish;
use crate::cell::{Hub, ToDesk};
use crate::http::Panel;
use crate::wire::Status;
use seamwright_cell::executive::{Ask, Command, Origin};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::jog;
use std::time::Duration;

/// A sign of life so often; the axes stop after 200 ms without.
const SIGN: Duration = Duration::from_millis(50);
/// Set-points this near to where they were sent are there, mm or rad.
const THERE: f64 = 1e-5;
/// After the last set-point the drives come to rest, s.
const SETTLE_S: f64 = 0.15;
/// Axes that stand for so long on their way have been stopped, s.
const STALLED_S: f64 = 0.4;
/// Tries to go on from a place where the cell has stopped them: a busy computer's sign of life may be late.
const TRIES: u32 = 4;

/// How a move ended.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Came {
    /// There, at rest.
    There,
    /// It was paused or stopped, or may not move any more.
    Interrupted,
    /// The cell has stopped it.
    Blocked,
}

/// Moves the axes for a session, as long as its page has control.
pub(super) struct Hand<'a> {
    pub(super) panel: &'a Panel,
    pub(super) machine: &'a Machine,
}

impl Hand<'_> {
    fn hub(&self) -> &Hub {
        &self.panel.cell.hub
    }

    fn teaching(&self) -> &Teaching {
        &self.panel.teaching
    }

    /// Where the axes shall be and are, mm or rad, and the newest status.
    pub(super) fn axes(&self) -> Option<(Joints, Joints, Status)> {
        let (status, set) = self.hub().standing()?;
        let mut measured = Joints::default();
        for (value, (axis, of)) in measured.iter_mut().zip(self.machine.axes.iter().zip(&status.axes)) {
            *value = axis.from_file(of.position);
        }
        (status.axes.len() == self.machine.axes.len()).then_some((set, measured, status))
    }

    fn jog(&self, station: u32, command: jog::Command) {
        let command = Command { origin: Origin { user: 0, station }, number: 0, ask: Ask::Jog(command) };
        // A cell that has ended moves nothing.
        drop(self.panel.cell.desk.send(ToDesk::Command(command)));
    }

    /// Why the axes may not move; none: they may.
    fn hindrance(&self, station: u32, mode: &str) -> Option<&'static str> {
        if !self.hub().controls(station, true) {
            return Some("control");
        }
        (!matches!(mode, "jog" | "teach")).then_some("mode")
    }

    /// Sends the axes to `target` and waits until they rest there.
    pub(super) fn go(&self, target: &Joints) -> Came {
        // Whatever stopped the axes before is known.
        self.jog(self.teaching().state().station, jog::Command::Rest);
        std::thread::sleep(SIGN);
        let (mut there, mut moved, mut tries) = (None, (f64::NAN, Joints::default()), 0);
        loop {
            let (station, wish) = {
                let state = self.teaching().state();
                (state.station, state.wish)
            };
            let Some((set, _, status)) = self.axes() else { return Came::Interrupted };
            if wish != Wish::Run {
                self.jog(station, jog::Command::Rest);
                return Came::Interrupted;
            }
            if let Some(why) = self.hindrance(station, &status.mode) {
                self.jog(station, jog::Command::Rest);
                // Only a page says that it is in its right place to go on.
                drop(self.teaching().pause(why));
                return Came::Interrupted;
            }
            self.jog(station, jog::Command::To(*target));
            let far = (0..self.machine.axes.len()).map(|i| (set[i] - target[i]).abs()).fold(0.0, f64::max);
            if far <= THERE {
                let since = *there.get_or_insert(status.t);
                if status.t - since >= SETTLE_S {
                    // Nobody holds a key while the eye looks.
                    self.jog(station, jog::Command::Rest);
                    return Came::There;
                }
            } else if moved.0.is_nan() || set.iter().zip(moved.1).any(|(a, b)| (a - b).abs() > 0.0) {
                (moved, tries) = ((status.t, set), 0);
            } else if status.t - moved.0 > STALLED_S && status.override_part > 0.0 {
                self.jog(station, jog::Command::Rest);
                (moved.0, tries) = (status.t, tries + 1);
                if tries > TRIES {
                    return Came::Blocked;
                }
            }
            std::thread::sleep(SIGN);
        }
    }
}
