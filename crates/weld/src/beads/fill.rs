use super::layers::Layer;
use super::shape::{BeadSize, LayerShape, Level};
use super::toes::{LayerToes, Toes};
use crate::joint::Section;
use glam::DVec2;
use seamwright_program::Inclination;

/// Arrangement of beads in their layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Laying {
    /// Distance of the wire from the walls, mm.
    pub(crate) wall: f64,
    /// Turn of the wire towards a wall, rad.
    pub(crate) tilt: f64,
    /// True if the wires share the way between the walls, each weaving over its part.
    pub(crate) shared: bool,
    /// Distance of neighbours as a part of their width.
    pub(crate) spacing: f64,
}

/// A bead in a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeadAt {
    /// Its layer, counted from 0 at the root.
    pub layer: usize,
    /// Its index in the layer, counted from 0 at the second part.
    pub index: usize,
    /// Target of the wire, mm, in the frame of the [`Section`].
    pub tip: DVec2,
    /// Angle from the bisector to the torch, rad; positive leans towards the first part.
    pub lean: f64,
    /// Its part of the way between the walls, mm: how wide a wire weaves that shares it with the others.
    pub room: f64,
    /// Area of the bead, mm^2.
    pub area: f64,
    /// Width of its section, mm.
    pub width: f64,
    /// Height of its section, mm.
    pub height: f64,
    /// Angles at its toes.
    pub toes: Toes,
    /// Mean height of its layer, mm.
    pub layer_height: f64,
    /// Areas of groove and cap below its layer, and with it, mm^2.
    pub filled: (f64, f64),
}

impl BeadAt {
    /// The smaller toe angle (rad) of the bead laid without a weave on a weld of this inclination: it sags to its lower
    /// toe.
    pub fn min_toe_in(&self, at: Inclination) -> f64 {
        let face = self.toes.convexity;
        self.toes.min() - ((face.tan() + at.sag(self.width)).atan() - face)
    }

    /// This bead changed to `other` by a part of the way.
    pub(crate) fn towards(&self, other: &Self, part: f64) -> Self {
        let between = |a: f64, b: f64| a + (b - a) * part;
        Self {
            tip: self.tip.lerp(other.tip, part),
            lean: between(self.lean, other.lean),
            room: between(self.room, other.room),
            area: between(self.area, other.area),
            width: between(self.width, other.width),
            height: between(self.height, other.height),
            toes: self.toes.towards(&other.toes, part),
            layer_height: between(self.layer_height, other.layer_height),
            filled: (between(self.filled.0, other.filled.0), between(self.filled.1, other.filled.1)),
            ..*self
        }
    }
}

/// Part of the free angle that stays between torch and either wall. Not tuned: a torch in the middle of a V has half of it
/// on each side. All jobs of `examples/` and `examples/vessel-shop` are clear with it.
const OFF_WALL: f64 = 0.25;

/// Lean of a torch whose wire points at `at` in the groove: square to the line from toe to toe and turned by `towards`,
/// as far as the walls leave room beyond the `stick_out` (mm), where the gas nozzle begins.
fn lean(section: &Section, at: DVec2, towards: f64, stick_out: f64) -> f64 {
    let [low, high] = section.free_angles(at, stick_out);
    let off = OFF_WALL * (high - low).max(0.0);
    let square = section.up.x.atan2(section.up.y);
    (square + towards).max(low + off).min(high - off)
}

/// Height of the wire's target over the bottom of the groove in the first layer, as a part of the layer's height. Chosen so
/// that the arc reaches both root faces in the examples; `tests.rs` checks on random grooves that the target lies between the
/// walls.
const ROOT_RISE: f64 = 0.35;

/// Layers between two areas of the filled section.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stack<'a> {
    pub(crate) layers: &'a [Layer],
    /// Index of the first of them among all layers.
    pub(crate) first: usize,
    /// Area below them, mm^2.
    pub(crate) from: f64,
    /// Area with them, mm^2.
    pub(crate) to: f64,
}

/// Adds the beads of `stack` in a section, layer by layer, each from the second part to the first. Layers for which
/// `present` is false are left out and their area goes to the others.
///
/// Guarantee: the areas sum to that between the stack's ends. A bead's area is its share of its layer's. The layers'
/// areas are those of the groove between their levels, and of the cap for the last one.
pub(crate) fn fill(
    section: &Section,
    stack: &Stack,
    present: impl Fn(usize) -> bool,
    laying: Laying,
    out: &mut Vec<BeadAt>,
) {
    let there = || (stack.first..).zip(stack.layers).filter(|(k, _)| present(*k));
    let shares: f64 = there().map(|(_, l)| l.share).sum();
    let scale = (stack.to - stack.from) / shares;
    let mut low = Level::new(section, stack.from);
    for (number, layer) in there() {
        let area = layer.share * scale;
        let high = Level::new(section, low.area + area);
        let laid = LaidLayer::new(section, LayerAt { number, layer, area, low: &low, high: &high }, laying);
        out.extend((0..layer.beads).map(|index| laid.bead(index)));
        low = high;
    }
}

/// A layer between two levels of a section.
#[derive(Clone, Copy)]
struct LayerAt<'a> {
    /// Counted from 0 at the root.
    number: usize,
    layer: &'a Layer,
    /// Its area, mm^2.
    area: f64,
    low: &'a Level,
    high: &'a Level,
}

/// The common values of the beads of a layer.
struct LaidLayer<'a> {
    section: &'a Section,
    at: LayerAt<'a>,
    laying: Laying,
    size: BeadSize,
    toes: LayerToes,
    height: f64,
    /// Height of the wires' targets, mm.
    base: f64,
    /// Ends of the groove at that height, mm across.
    walls: (f64, f64),
    /// Ends of the groove at half of the layer's height, mm across.
    middle: (f64, f64),
}

impl<'a> LaidLayer<'a> {
    fn new(section: &'a Section, at: LayerAt<'a>, laying: Laying) -> Self {
        let LayerAt { layer, low, high, .. } = at;
        let shape = LayerShape::new(low, high, section.chord());
        // At the root the gap between the parts is narrow, and the wire points above it.
        let base = low.height + if low.area > 0.0 { 0.0 } else { ROOT_RISE * (high.height - low.height) };
        Self {
            section,
            at,
            laying,
            size: shape.bead(layer.beads, laying.spacing),
            toes: LayerToes::new(section, &shape, high, layer.beads, laying.spacing),
            height: shape.height,
            base,
            walls: section.slices.edges(base),
            middle: section.slices.edges(0.5 * (low.height + high.height)),
        }
    }

    /// Ends of the wires' way between the walls, mm across; the first may be beyond the second.
    fn way(&self) -> (f64, f64) {
        (self.walls.0 + self.laying.wall, self.walls.1 - self.laying.wall)
    }

    /// Position of a bead's wire, mm across.
    fn across(&self, index: usize) -> f64 {
        let ((from, to), n) = (self.way(), self.at.layer.beads as f64);
        let part = (index as f64 + 0.5) / n;
        if self.at.layer.beads == 1 || from >= to {
            0.5 * (self.walls.0 + self.walls.1)
        } else if self.laying.shared {
            from + (to - from) * part
        } else {
            (self.middle.0 + (self.middle.1 - self.middle.0) * part).clamp(from, to)
        }
    }

    /// Turn of a bead's wire to the wall beside it, rad.
    fn towards_wall(&self, index: usize) -> f64 {
        match (index, self.at.layer.beads) {
            (_, 1) => 0.0,
            (0, _) => self.laying.tilt,
            (index, count) if index + 1 == count => -self.laying.tilt,
            _ => 0.0,
        }
    }

    /// Bead `index`, counted from the second part.
    fn bead(&self, index: usize) -> BeadAt {
        let LayerAt { number, layer, area, low, high } = self.at;
        let ((from, to), n) = (self.way(), layer.beads as f64);
        let tip = self.section.place(self.across(index), self.base);
        BeadAt {
            layer: number,
            index,
            tip,
            lean: lean(self.section, tip, self.towards_wall(index), layer.stick_out),
            room: ((to - from) / n).max(0.0),
            area: area / n,
            width: self.size.width,
            height: self.size.height,
            toes: self.toes.of(index, layer.beads),
            layer_height: self.height,
            filled: (low.area, high.area),
        }
    }
}
