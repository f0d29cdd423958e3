use crate::part_program::Arc;
use crate::polynomial::Evenly;
use glam::DVec3;
use seamwright_machine::Joints;

/// End of a block: where the axes are, where the tip is, and how the block went there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Path length at its end, mm.
    pub s: f64,
    /// Axis positions at its end, mm or rad.
    pub q: Joints,
    /// Torch tip at its end in the work frame, mm.
    pub tip: DVec3,
    /// Duration by the plan, s.
    pub duration: f64,
    /// True if the block only turns: its linear motion is too small for the control's minimum feed and is left to a
    /// later block.
    pub turns_only: bool,
    /// True if the torch stops at its end, at a corner.
    pub stops: bool,
    /// The way there.
    pub shape: Shape,
}

/// The way of a block, from the end of the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "blocks stay copies: thousands a pass, not millions")]
pub enum Shape {
    /// All goes evenly.
    Line,
    /// X, Y and Z (the axes, at tip level the tip) go along this arc, evenly by its angle; all else evenly.
    Arc(Arc),
    /// Cubics in time.
    Hermite {
        /// Speeds at its start.
        from: Speeds,
        /// Speeds at its end.
        to: Speeds,
    },
    /// Cubics of a parameter, gone along evenly.
    Curve {
        /// Derivatives by the part of the parameter at its start.
        from: Speeds,
        /// The same at its end.
        to: Speeds,
        /// The parameter by the control's feed.
        evenly: Evenly,
    },
    /// Its end is a control point of a uniform cubic B-spline.
    Spline,
}

/// Speeds at one station, per s, or derivatives by a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Speeds {
    /// Of the axes, mm or rad.
    pub q: Joints,
    /// Of the tip in the work frame, mm.
    pub tip: DVec3,
}

/// A pass cut into blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearisation {
    /// Start of the first block (with no duration).
    pub start: Block,
    /// The blocks.
    pub blocks: Vec<Block>,
    /// Maximum distance found between the path of the blocks and the planned one of the tip, mm.
    pub chord_error_mm: f64,
}

impl Block {
    /// Positions and tip at the part `f` of the time of the block that ends here and starts at `begin`; X, Y and Z of
    /// an arc are left to the caller.
    pub(crate) fn part(&self, begin: &Self, f: f64) -> (Joints, DVec3) {
        let line = |a: f64, b: f64| a + f * (b - a);
        let cubic = |from: Speeds, to: Speeds, w: [f64; 3]| {
            let cubic = |a: f64, va: f64, b: f64, vb: f64| a + w[0] * (b - a) + w[1] * va + w[2] * vb;
            let q = std::array::from_fn(|i| cubic(begin.q[i], from.q[i], self.q[i], to.q[i]));
            (q, begin.tip + w[0] * (self.tip - begin.tip) + w[1] * from.tip + w[2] * to.tip)
        };
        match self.shape {
            Shape::Hermite { from, to } => cubic(from, to, hermite(f, self.duration)),
            Shape::Curve { from, to, evenly } => cubic(from, to, hermite(evenly.parameter(f), 1.0)),
            _ => (std::array::from_fn(|i| line(begin.q[i], self.q[i])), begin.tip.lerp(self.tip, f)),
        }
    }
}

/// Weights of the way, the speed at the start and that at the end in a cubic of `time` s at its part `f`.
fn hermite(f: f64, time: f64) -> [f64; 3] {
    let g = 1.0 - f;
    [f * f * (3.0 - 2.0 * f), time * f * g * g, -time * f * f * g]
}
