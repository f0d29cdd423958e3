//! Verification of a post: its text is read back, played by the control's own rules, and taken through the machine's
//! forward kinematics. The result is compared block by block with the part program that was written, and in time with
//! the planned motion.

mod block_comparison;
mod plan_comparison;

use crate::control::Control;
use crate::part_program::{Level, PartProgram};
use crate::points::is_posted_as_it_stands;
use seamwright_machine::Machine;
use seamwright_message::{Argument, Language, Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_program::Program;
use serde::Serialize;

/// Plan against which a post is verified.
#[derive(Debug, Clone, Copy)]
pub struct Planned<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// Its control.
    pub control: &'a Control,
    /// The program that was posted.
    pub program: &'a Program,
    /// Its motion.
    pub motion: &'a WeldMotion,
    /// Maximum distance of the blocks' path from the planned one of the tip, mm.
    pub tolerance_mm: f64,
    /// Maximum deviation of the tip's speed inside blocks that are not brief, percent, see [`crate::Options`].
    pub speed_percent: f64,
}

/// A proof.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verification {
    /// Blocks with motion.
    pub moves: usize,
    /// Maximum difference of an axis or process value between the request and the text read back, mm or degrees.
    pub rounding: f64,
    /// Each pass.
    pub passes: Vec<PassVerification>,
}

/// The proof of one pass.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PassVerification {
    /// Its name.
    pub name: String,
    /// Whether its blocks are the program's own points: then they have no planned path to deviate from.
    pub as_it_stands: bool,
    /// Maximum distance of the tip from the planned path, mm.
    pub tip_mm: f64,
    /// Maximum deviation of a linear axis from the planned path, mm, and its name.
    pub linear: Option<(f64, String)>,
    /// Maximum deviation of a rotary axis, degrees, and its name.
    pub rotary: Option<(f64, String)>,
    /// Maximum deviation of the torch's direction, degrees.
    pub direction_deg: f64,
    /// Maximum lead or lag of the tip against the plan, mm.
    pub lag_mm: f64,
    /// Maximum deviation of the tip's mean speed in a block, percent of the planned one.
    pub speed_percent: f64,
    /// Maximum deviation of the tip's speed inside blocks between the acceleration and deceleration phases, percent of
    /// the planned one.
    pub speed_inside_percent: f64,
    /// and that in blocks that are long enough to be cut for it, of passes that do not weave.
    #[serde(skip)]
    pub(crate) speed_bounded_percent: f64,
    /// Time with the arc on, s, and its deviation from the planned one, percent.
    pub arc_s: f64,
    /// Deviation of that time, percent.
    pub time_percent: f64,
    /// Maximum deviation of a process value, percent of its maximum in the pass, and its name.
    pub process: Option<(f64, String)>,
}

/// Deviation of a pass' time that is allowed, percent.
pub(crate) const TIME_PERCENT: f64 = 0.1;
/// Permitted deviation of a process value, percent of its maximum: ramps go in steps of a fiftieth.
const PROCESS_PERCENT: f64 = 2.5;
/// Rounding of six decimals.
const ROUNDING: f64 = 1e-5;

/// Verifies the program read back from the text against `asked`, from which it was written, and the plan. `start` is
/// the row before the first block.
///
/// # Errors
/// Descriptions of all faults: blocks that are missing or differ, and deviations beyond the tolerance, 0.1 % of the
/// time or 2.5 % of a process value.
pub fn verify(
    asked: &PartProgram,
    told: &PartProgram,
    start: &[f64],
    planned: Planned,
) -> Result<Verification, Vec<Message>> {
    let same = block_comparison::same(planned.control, asked, told, start).map_err(|wrong| vec![wrong])?;
    let mut wrong = Vec::new();
    if same.rounding > ROUNDING {
        wrong.push(Message::new("post-rounding").text("difference", format!("{:.2e}", same.rounding)));
    }
    let mut passes = Vec::new();
    for (i, pass) in planned.program.passes.iter().enumerate() {
        let checked = match is_posted_as_it_stands(planned.control, pass) {
            true => plan_comparison::as_it_stands(pass, i, &same.blocks),
            false => plan_comparison::check(planned, pass, i, &same.blocks),
        };
        wrong.extend(checked.complaints(planned, i + 1));
        // Checks the text itself, not `asked`: the arc must be off in a pass without one.
        let burns =
            |block: &block_comparison::Block| block.pass == i && block.told.arc && planned.control.switches_arc();
        if !pass.has_arc() && same.blocks.iter().any(burns) {
            wrong.push(in_pass(i + 1, &pass.name, Message::new("post-arc-in-pass-without")));
        }
        passes.push(checked);
    }
    let proof = Verification { moves: same.blocks.len(), rounding: same.rounding, passes };
    if wrong.is_empty() { Ok(proof) } else { Err(wrong) }
}

/// Permitted deviations of a pass.
pub(crate) struct Permitted {
    /// Of the tip, mm.
    pub(crate) tip_mm: f64,
    /// Of the time, percent.
    pub(crate) time_percent: f64,
    /// Of process values by rounding, beside [`PROCESS_PERCENT`], percent.
    pub(crate) rounding_percent: f64,
}

impl PassVerification {
    fn complaints(&self, planned: Planned, number: usize) -> Vec<Message> {
        let Planned { tolerance_mm, speed_percent, .. } = planned;
        let permitted = Permitted { tip_mm: tolerance_mm, time_percent: TIME_PERCENT, rounding_percent: 0.0 };
        let mut wrong = self.complaints_within(&permitted, number);
        if self.speed_bounded_percent > speed_percent {
            let fault = percent("post-speed-off", self.speed_bounded_percent, 2, speed_percent);
            wrong.push(in_pass(number, &self.name, fault));
        }
        wrong
    }

    /// Faults of tip, time and process values.
    pub(crate) fn complaints_within(&self, permitted: &Permitted, number: usize) -> Vec<Message> {
        let Permitted { tip_mm: tolerance_mm, time_percent, rounding_percent } = *permitted;
        let mut wrong = Vec::new();
        let mut complain = |fault: Message| wrong.push(in_pass(number, &self.name, fault));
        if self.tip_mm > tolerance_mm + ROUNDING {
            let message = Message::new("post-tip-off").quantity("deviation", self.tip_mm, Unit::Mm, 6);
            complain(message.value("max", tolerance_mm, Unit::Mm));
        }
        if self.time_percent.is_nan() || self.time_percent.abs() > time_percent {
            complain(percent("post-time-off", self.time_percent, 3, time_percent));
        }
        if let Some((off, name)) = self.process.as_ref().filter(|(off, _)| *off > PROCESS_PERCENT + rounding_percent) {
            complain(percent("post-process-off", *off, 2, PROCESS_PERCENT + rounding_percent).text("name", name));
        }
        wrong
    }

    /// Returns the proof in a line.
    pub fn message(&self) -> Message {
        if self.as_it_stands {
            let message = Message::new("post-proof-as-it-stands").text("name", &self.name);
            return message.quantity("time", self.arc_s, Unit::S, 3);
        }
        let of = |code, value: f64, unit, decimals| Message::new(code).quantity("deviation", value, unit, decimals);
        let named = |worst: &Option<(f64, String)>, unit, decimals| {
            worst.as_ref().map(|(off, name)| of("post-proof-named", *off, unit, decimals).text("name", name))
        };
        let speed = self.speed_percent.max(self.speed_inside_percent);
        let deviations = [
            Some(of("post-proof-tip", self.tip_mm, Unit::Mm, 5)),
            named(&self.linear, Unit::Mm, 5),
            named(&self.rotary, Unit::Deg, 5),
            Some(of("post-proof-speed", speed, Unit::Percent, 2)),
            Some(of("post-proof-time", self.time_percent, Unit::Percent, 4)),
            named(&self.process, Unit::Percent, 2),
        ];
        let deviations = deviations.into_iter().flatten().map(|deviation| Argument::Message(Box::new(deviation)));
        Message::new("post-proof-pass").text("name", &self.name).list("deviations", deviations)
    }
}

impl Verification {
    /// Returns the proof: a summary, and a message for each pass.
    pub fn messages(&self) -> Vec<Message> {
        let all = Message::new("post-proof").count("moves", self.moves);
        let all = all.text("rounding", format!("{:.1e}", self.rounding));
        std::iter::once(all).chain(self.passes.iter().map(PassVerification::message)).collect()
    }

    /// Returns the proof in lines of a header, in English and ASCII like all comments of part programs.
    pub fn lines(&self) -> Vec<String> {
        let line = |message: &Message| message.in_language(Language::English).replace('°', " deg");
        self.messages().iter().map(line).collect()
    }
}

/// A deviation in percent, with its limit.
fn percent(code: &'static str, deviation: f64, decimals: u8, max: f64) -> Message {
    Message::new(code).quantity("deviation", deviation, Unit::Percent, decimals).value("max", max, Unit::Percent)
}

/// A fault in a pass, counted from 1.
pub(crate) fn in_pass(number: usize, name: &str, fault: Message) -> Message {
    Message::new("post-in-pass").pass("pass", number).text("name", name).message("fault", fault)
}

/// The level of a move, where X, Y and Z are the tip.
fn is_tip(level: Option<Level>) -> bool {
    level == Some(Level::Tip)
}
