use crate::chain::{AxisSet, Chain};
use crate::inverse::Inverse;

/// A torch, beam or laser head with the axes that carry it.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// Name: `torch` on machines with one head.
    pub name: String,
    /// The chain from the clamped work to the head's tip.
    pub chain: Chain,
    /// Linear axes of the head alone, by index: its correction slides.
    pub slides: AxisSet,
    pub(crate) inverse: Inverse,
}

impl Head {
    /// Axes of this head's chain that a point and a direction leave free: the machine has more axes than the pose needs.
    /// [`Machine::inverse`](crate::Machine::inverse) holds them where they are in `near`.
    pub fn free(&self) -> AxisSet {
        self.inverse.held
    }
}
