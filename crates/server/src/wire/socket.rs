use super::{AlarmView, EventView, LackView, Status, TeachOrder, TeachView, WorkView};
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
    /// Pressed jog keys, every 50 ms while pressed; not answered. All speeds zero: released.
    Jog {
        /// See [`ToCell::Command`]; jogs count by themselves.
        seq: u32,
        /// By joints or by the tip.
        of: JogOf,
        /// For joints: part of the highest speed of each axis, -1 to 1. For the tip: x, y, z in the work frame as parts of the
        /// highest speed by hand; its direction is kept. The cell slows all of it so that the tip keeps to that speed.
        speeds: Vec<f64>,
    },
    /// The hand on a key that moves by a step and stands, every 50 ms while it holds, its number counted with [`ToCell::Jog`]; not
    /// answered. The first one since the hand let go says where to; let go (a jog of zeros), it stops where it is.
    Step {
        /// See [`ToCell::Jog`].
        seq: u32,
        /// By joints or by the tip.
        of: JogOf,
        /// Which axis, or x, y, z of the work frame: from 0.
        index: u32,
        /// Distance with sign: mm or degrees, 10 at most. A step beyond an axis' end stops at the end.
        by: f64,
    },
    /// The hand on a key that sends all axes to a place, as [`ToCell::Step`].
    Go {
        /// See [`ToCell::Jog`].
        seq: u32,
        /// Positions of all axes, mm or degrees; reached at once.
        axes: Vec<f64>,
    },
    /// An order to the teaching by camera, its number counted with [`ToCell::Command`] and answered so.
    Teach {
        /// See [`ToCell::Command`].
        seq: u32,
        /// The order.
        order: TeachOrder,
    },
    /// Sign of life of the page, every 250 ms; the control token is lost without for 1 s.
    Beat {},
    /// Asks for the control token.
    TakeControl {
        /// Take it from its holder (never while something jogs).
        over: bool,
    },
    /// Gives the control token back.
    GiveControl {},
    /// Asks what stands between now and a start; answered by [`FromCell::Why`].
    Why {
        /// For which command: `switch_on`, `home`, `start_jog`, `start_dry_run`, `start_weld`, `resume`, `reset`.
        ask: String,
    },
}

/// Target of a jog.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum JogOf {
    /// Single axes.
    Joints,
    /// The torch's tip.
    Tip,
}

/// Commands to the executive. Stop and hold need no control token; stop no role either.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum AskView {
    /// Power for the drives.
    SwitchOn {},
    /// No power for the drives.
    SwitchOff {},
    /// Find the references, and go home as the machine file says; or one axis goes to its home position alone.
    Home {
        /// The axis, counted from 0; all if missing.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        axis: Option<u8>,
    },
    /// Jogging, until hold.
    StartJog {},
    /// Jogging while places are recorded.
    StartTeach {},
    /// The program with the process off.
    StartDryRun {},
    /// Allow the next start of the process: for one start, within a minute.
    Arm {},
    /// The program with the process on. Refused (`finished_pass`, `finished_part`) where it would weld again what is finished.
    StartWeld {
        /// The operator confirmed that finished work may be welded again. No if missing.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        #[ts(optional, as = "Option<bool>")]
        reweld: bool,
    },
    /// Stand still on the path.
    Hold {},
    /// Go on after a hold.
    Resume {},
    /// Go back along the path with the process off, until the next hold.
    Reverse {},
    /// Everything stops, the process first.
    Stop {},
    /// Part of the planned speed.
    Override {
        /// 0 to 1.
        part: f64,
    },
    /// The fault has been looked at.
    Reset {},
    /// All alarms are known, or one.
    Acknowledge {
        /// Number and detail of the alarm; all if missing.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[ts(optional)]
        one: Option<(u8, u8)>,
    },
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
        /// All that are there or not acknowledged, the first first.
        list: Vec<AlarmView>,
    },
    /// The cell has another machine: `GET /api/machine` says which. On connecting, too.
    Machine,
    /// The program in the cell changed; none: the cell is empty.
    Work {
        /// The program.
        work: Option<WorkView>,
    },
    /// Holder of the control token, whenever it changes.
    Control {
        /// The connection; none: no holder.
        station: Option<u32>,
        /// Its user's name.
        user: Option<String>,
        /// True if that is this connection.
        mine: bool,
    },
    /// State of teaching by camera, whenever it changes.
    Teach(TeachView),
    /// To a command of this connection.
    Answer {
        /// Its number.
        seq: u32,
        /// True if it was taken.
        ok: bool,
        /// Why not: a stable key (`mode`, `moving`, `references`, `power`, `silent`, `condition`, `alarm`, `arming`, `source`,
        /// `not_at_start`, `work`, `value`, `motion`, `role`, `control`, `replayed`, `silent_cycle`: a stop was passed on to a cycle
        /// that is not heard of), and words.
        why: Option<LackView>,
    },
    /// To [`ToCell::Why`]; empty: nothing.
    Why {
        /// The command that was asked for.
        ask: String,
        /// Reasons that prevent it.
        lacks: Vec<LackView>,
    },
}
