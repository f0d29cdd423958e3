use super::status::{AlarmView, EventView, LackView, Status};
use super::teach::{TeachOrder, TeachView};
use super::weld::WorkView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// From the panel over the socket.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ToCell {
    /// A command; answered by [`FromCell::Answer`] with the same number.
    Command {
        /// Counts up from 1 in a connection; one that is not greater than the last is refused.
        seq: u32,
        /// The command.
        ask: AskView,
    },
    /// Jogs, every 50 ms while a key is held; not answered. All speeds zero: the key is released.
    Jog {
        /// See [`ToCell::Command`]; jogs count by themselves.
        seq: u32,
        /// By joints, by the tip or about it.
        of: JogOf,
        /// Frame of the directions of the tip; see [`JogOf`].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        frame: Option<String>,
        /// For joints: part of the maximum speed of each axis, -1 to 1. For the tip: x, y, z of the frame as parts of the
        /// maximum jogging speed; its direction is kept. For a turn: rates about x, y, z of the frame as parts of the
        /// maximum rate. The cell slows all axes so that the tip keeps to that speed.
        speeds: Vec<f64>,
    },
    /// Moves by one step, every 50 ms while a key is held, its number counted with [`ToCell::Jog`]; not answered. The
    /// first one after a release sets the target; a release (a jog of zeros) stops the motion.
    Step {
        /// See [`ToCell::Jog`].
        seq: u32,
        /// By joints, by the tip or about it.
        of: JogOf,
        /// Frame of the directions of the tip; see [`JogOf`].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        frame: Option<String>,
        /// Axis, or x, y, z of the frame, from 0.
        index: u32,
        /// Distance with sign: mm or degrees, 10 at most, for a turn 1. A step beyond an axis' end stops at the end.
        by: f64,
    },
    /// Moves all axes to a position while a key is held, as [`ToCell::Step`].
    Go {
        /// See [`ToCell::Jog`].
        seq: u32,
        /// Positions of all axes, mm or degrees; all axes arrive at the same time.
        axes: Vec<f64>,
    },
    /// A command for teaching by camera, its number counted and answered as those of [`ToCell::Command`].
    Teach {
        /// See [`ToCell::Command`].
        seq: u32,
        /// The command.
        order: TeachOrder,
    },
    /// Sign of life of the page, every 250 ms; after 1 s without one the page loses the control token.
    Beat {},
    /// Asks for the control token.
    TakeControl {
        /// Take it from another connection (never while an axis is jogged).
        over: bool,
    },
    /// Gives the control token back.
    GiveControl {},
    /// Asks for the missing conditions of a command; answered by [`FromCell::Why`].
    Why {
        /// The command: `switch_on`, `home`, `start_jog`, `start_dry_run`, `start_weld`, `resume`, `reset`.
        ask: String,
    },
}

/// Target of a jog. Frames of the tip's directions: `work` (if none is given), `base`, `tool` (z from the torch to the work)
/// or the name of a user frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JogOf {
    /// Single axes.
    Joints,
    /// The torch's tip, along a straight line.
    Tip,
    /// The torch about its tip.
    Turn,
}

/// Commands to the executive. Stop and hold need no control token; stop no role either.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum AskView {
    /// Switches the drives on.
    SwitchOn {},
    /// Switches the drives off.
    SwitchOff {},
    /// Homes the machine as its file describes; with `axis`, moves one axis to its home position.
    Home {
        /// The axis, counted from 0; all if missing.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        axis: Option<u8>,
    },
    /// Starts jogging, until a hold.
    StartJog {},
    /// Starts teaching: jogging while positions are recorded.
    StartTeach {},
    /// Runs the program with the process off.
    StartDryRun {},
    /// Allows the next start of the process: one start, within a minute.
    Arm {},
    /// Runs the program with the process on. Refused (`finished_pass`, `finished_part`) over finished weld.
    StartWeld {
        /// The operator confirmed that finished work may be welded again. No if missing.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        #[ts(optional, as = "Option<bool>")]
        reweld: bool,
    },
    /// Stops on the path.
    Hold {},
    /// Continues after a hold.
    Resume {},
    /// Moves back along the path with the process off, until the next hold.
    Reverse {},
    /// Stops everything, the process first.
    Stop {},
    /// Sets the feed override: part of the planned speed.
    Override {
        /// 0 to 1.
        part: f64,
    },
    /// Resets a fault.
    Reset {},
    /// Acknowledges all alarms, or one.
    Acknowledge {
        /// Number and detail of the alarm; all if missing.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        one: Option<(u8, u8)>,
    },
}

/// A command that the mode of the cell refuses, or in which it has no effect.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RefusedView {
    /// The command, by its name in `do` of [`AskView`].
    pub ask: String,
    /// Reason: `mode`, `power`, `motion`, or `at_rest` (nothing to stop).
    pub why: LackView,
}

/// To the panel over the socket.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FromCell {
    /// First on every connection.
    Hello {
        /// Number of this connection.
        station: u32,
        /// Version of the program.
        version: String,
    },
    /// 30 times a second, the newest only.
    Status(Box<Status>),
    /// Every event in order; the last hundred on connecting.
    Event(EventView),
    /// The whole list, whenever it changes.
    Alarms {
        /// All active or unacknowledged alarms, the first one first.
        list: Vec<AlarmView>,
    },
    /// Commands that the cell would refuse now, or that would have no effect, whenever they change.
    Commands {
        /// Each with the first reason; all others are possible as far as mode and power decide.
        refused: Vec<RefusedView>,
    },
    /// The machine of the cell changed, see `GET /api/machine`; also sent on connecting.
    Machine,
    /// The program in the cell changed; none: the cell is empty.
    Work {
        /// The program.
        work: Option<WorkView>,
    },
    /// Holder of the control token, whenever it changes.
    Control {
        /// The connection; none: no one has control.
        station: Option<u32>,
        /// Its user's name.
        user: Option<String>,
        /// True for this connection.
        mine: bool,
    },
    /// State of teaching by camera, whenever it changes.
    Teach(TeachView),
    /// Answer to a command of this connection.
    Answer {
        /// Its number.
        seq: u32,
        /// True if it was accepted.
        ok: bool,
        /// Reason of a refusal: a stable key (`mode`, `moving`, `references`, `power`, `silent`, `condition`, `alarm`,
        /// `arming`, `source`, `not_at_start`, `work`, `value`, `motion`, `role`, `control`, `replayed`,
        /// `silent_cycle`: a stop was passed on to a cycle that sends no status), and words.
        why: Option<LackView>,
    },
    /// Answer to [`ToCell::Why`]; empty: no condition is missing.
    Why {
        /// The command.
        ask: String,
        /// Its missing conditions.
        lacks: Vec<LackView>,
    },
}
