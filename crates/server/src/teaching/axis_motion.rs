//! Axis motion of a teaching session, by jog commands.

use super::state::{Teaching, Wish};
use crate::cell::{Hub, ToDesk};
use crate::http::Panel;
use crate::wire::Status;
use seamwright_executive::{Ask, Command, Origin};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::jog;
use std::time::Duration;

/// Period of jog commands; the axes stop after 200 ms without one.
const SIGN: Duration = Duration::from_millis(50);
/// Tolerance for reaching a set-point, mm or rad.
const THERE: f64 = 1e-5;
/// Settling time of the drives after the last set-point, s.
const SETTLE_S: f64 = 0.15;
/// Axes without motion for this time before the target have been stopped, s.
const STALLED_S: f64 = 0.4;
/// Maximum attempts to continue after the cell stopped the axes: jog commands of a busy computer may be late.
const TRIES: u32 = 4;

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Came {
    /// At the target, at rest.
    There,
    /// Paused, stopped, or no longer permitted to move.
    Interrupted,
    /// Stopped by the cell.
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

    /// Returns set-points and measured positions of the axes, mm or rad, and the newest status.
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
        // Sending fails only if the cell has ended.
        drop(self.panel.cell.desk.send(ToDesk::Command(command)));
    }

    /// Returns the reason for which the axes may not move; `None`: they may.
    fn hindrance(&self, station: u32, mode: &str) -> Option<&'static str> {
        if !self.hub().controls(station, true) {
            return Some("control");
        }
        (!matches!(mode, "jog" | "teach")).then_some("mode")
    }

    /// Moves the axes to `target` and waits until they are at rest there.
    pub(super) fn go(&self, target: &Joints) -> Came {
        // Acknowledges an earlier halt of the jog.
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
                // The session stays paused until a page resumes it.
                drop(self.teaching().pause(why));
                return Came::Interrupted;
            }
            self.jog(station, jog::Command::To(*target));
            let far = (0..self.machine.axes.len()).map(|i| (set[i] - target[i]).abs()).fold(0.0, f64::max);
            if far <= THERE {
                let since = *there.get_or_insert(status.t);
                if status.t - since >= SETTLE_S {
                    // Ends the jog command while the camera looks.
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
