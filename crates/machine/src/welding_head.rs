use crate::axis::{Axis, AxisKind};
use crate::chain::{AxisSet, Chain};
use crate::inverse::Inverse;
use glam::{DAffine3, DVec3};
use seamwright_message::{Argument, Message};

/// A torch, beam or laser head with its axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// Name: `torch` on machines with one head.
    pub name: String,
    /// Position of its tip in the last frame of its steps, mm.
    pub tip: DVec3,
    /// The tip's frame in the flange: the first fixed step behind the last axis is the flange, the others are the tool.
    pub tool: DAffine3,
    /// The chain from the clamped work to the head's tip.
    pub chain: Chain,
    /// Linear axes of the head alone, by index: its correction slides.
    pub slides: AxisSet,
    pub(crate) inverse: Inverse,
}

impl Head {
    /// Redundant axes of this head's chain: more than a point and a direction need.
    /// [`Machine::inverse`](crate::Machine::inverse) holds them at their positions of `near`.
    pub fn free(&self) -> AxisSet {
        self.inverse.held
    }

    /// True if positions are found by Newton's method: the arrangement of the axes has no closed form.
    pub fn is_numeric(&self) -> bool {
        self.inverse.is_numeric()
    }

    /// Describes the inverse kinematics; `axes` are the machine's.
    pub fn structure(&self, axes: &[Axis]) -> Message {
        let named = |set: AxisSet| set.iter().map(|axis| Argument::Axis(axes[axis].name.clone())).collect::<Vec<_>>();
        let decided = self.chain.axes().different(self.free());
        let of_kind = |kind| decided.iter().filter(|&axis| axes[axis].kind == kind).collect::<AxisSet>();
        let (linear, rotary) = (of_kind(AxisKind::Linear), of_kind(AxisKind::Rotary));
        let part = |code, set: AxisSet| Message::new(code).count("n", set.iter().count()).list("axes", named(set));
        let (linear, rotary) = (
            Some(linear).filter(|set| !set.is_empty()).map(|set| part("machine-linear-axes", set)),
            Some(rotary).filter(|set| !set.is_empty()).map(|set| part("machine-rotary-axes", set)),
        );
        let decided = match (linear, rotary) {
            (Some(linear), Some(rotary)) => {
                Message::new("machine-linear-and-rotary").message("linear", linear).message("rotary", rotary)
            }
            (linear, rotary) => linear.or(rotary).unwrap_or_default(),
        };
        let has_roll = self.inverse.has_free_roll();
        let roll = has_roll.then(|| Argument::Message(Box::new(Message::new("machine-free-roll"))));
        let free: Vec<Argument> = named(self.free()).into_iter().chain(roll).collect();
        let structure = match free.is_empty() {
            true => Message::new("machine-structure"),
            false => Message::new("machine-structure-with-free").list("free", free),
        };
        structure.message("method", Message::new(self.inverse.method())).message("axes", decided)
    }
}
