use crate::chain::{AxisSet, Chain};
use crate::inverse::Inverse;
use crate::{Axis, AxisKind};
use glam::DVec3;

/// A torch, beam or laser head with its axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// Name: `torch` on machines with one head.
    pub name: String,
    /// Position of its tip in the last frame of its steps, mm.
    pub tip: DVec3,
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

    /// Describes the inverse kinematics in words; `axes` are the machine's.
    pub fn structure(&self, axes: &[Axis]) -> String {
        let named = |set: AxisSet| set.iter().map(|axis| axes[axis].name.as_str()).collect::<Vec<_>>().join(", ");
        let decided = self.chain.axes().different(self.free());
        let of_kind = |kind| decided.iter().filter(|&axis| axes[axis].kind == kind).collect::<AxisSet>();
        let (linear, rotary) = (of_kind(AxisKind::Linear), of_kind(AxisKind::Rotary));
        let parts = [("linear", linear), ("rotary", rotary)].into_iter().filter(|(_, set)| !set.is_empty());
        let parts = parts.map(|(kind, set)| format!("{} {kind} ({})", counted(set.iter().count()), named(set)));
        let free = if self.free().is_empty() { String::new() } else { format!("; free: {}", named(self.free())) };
        format!("{}: {}{free}", self.inverse.words(), parts.collect::<Vec<_>>().join(" + "))
    }
}

fn counted(n: usize) -> String {
    let words = ["no", "one", "two", "three", "four", "five", "six"];
    words.get(n).map_or_else(|| n.to_string(), |w| (*w).to_owned())
}
