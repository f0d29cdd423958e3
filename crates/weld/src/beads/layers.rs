//! Layers that fill the groove so that beads keep their windows.
//!
//! Levels across the groove are the nodes of a graph, layers between two of them its edges. Each edge costs what its
//! beads deviate from their run's area, the layer's height and the windows of beads, at stations all along the seam; the
//! cheapest path from root to cap is the stack of layers.

use super::run_values::RunValues;
use super::shape::{LayerShape, Level};
use crate::joint::Section;
use seamwright_document::Positive;
use seamwright_program::Role;

/// A layer of beads, from the root out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Role of its beads.
    pub role: Role,
    /// Number of beads side by side.
    pub beads: usize,
    /// Its part of the whole area, before layers that are left out.
    pub share: f64,
    /// Stick-out of its runs, mm.
    pub stick_out: f64,
}

/// Stick-out of runs that name none, mm.
const USUAL_STICK_OUT_MM: f64 = 15.0;

/// Settings of the three kinds of runs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Runs {
    pub(crate) root: Option<RunValues>,
    pub(crate) fill: RunValues,
    pub(crate) cap: RunValues,
    /// Distance of neighbouring beads as a part of their width.
    pub(crate) spacing: f64,
    /// Maximum deviation of a bead's area from its run's, as a part of it.
    pub(crate) most: f64,
}

impl Runs {
    /// Area of the smallest bead that fills a layer, mm^2.
    fn smallest(&self) -> f64 {
        self.fill.area.min(self.cap.area)
    }

    pub(crate) fn of(&self, role: Role) -> &RunValues {
        match role {
            Role::Root => self.root.as_ref().unwrap_or(&self.fill),
            Role::Fill | Role::Tack => &self.fill,
            Role::Cap | Role::Cosmetic => &self.cap,
        }
    }

    fn all(&self) -> impl Iterator<Item = &RunValues> {
        [&self.fill, &self.cap].into_iter().chain(&self.root)
    }
}

/// Maximum number of beads in a layer.
const MAX_IN_LAYER: f64 = 400.0;

/// Maximum number of beads in a section; more are a mistake: a V of 60 degrees in 300 mm takes 2,600 beads of 20 mm^2.
pub(crate) const MAX_BEADS: usize = 5_000;

/// Levels in the smallest wanted layer height: so finely heights of layers are chosen.
const LEVELS_PER_LAYER: f64 = 6.0;
/// Minimum number of levels.
const MIN_LEVELS: f64 = 12.0;
/// Maximum number of layers between two levels: a bound of time.
const MAX_EDGES: f64 = 50_000.0;
/// Maximum height of a layer, as a multiple of the largest wanted one. Checked on `random_joints.rs`: 5 % of the fill layers
/// are more than 1.64 times as high as wanted, so it rarely binds.
const MAX_LAYER: f64 = 2.0;
/// A layer has this many beads more or less than its area asks for. More would be outside `most_percent` in layers of
/// up to three beads.
const MORE_OR_LESS: i32 = 1;
/// Cost of a bead outside a window, beside that of deviations within: 5 % outside as much as 2.7 times the area.
///
/// Tuned on the jobs of `examples/`. Checked on 1,000 joints of `random_joints.rs`: a quarter or four times of it and of
/// [`HEIGHT`] leave 4.3 to 7.8 % of the beads outside, these values 5.7 %.
const OUTSIDE: f64 = 400.0;
/// Cost of a layer's height beside that of its beads' area: the area follows from wire and speed, the height is a wish.
///
/// Tuned and checked as [`OUTSIDE`]: 90 % of the fill layers are 0.81 to 1.64 times as high as wanted; 0.77 to 1.75 with a
/// quarter of it, 0.83 to 1.50 with four times, but then more areas are off.
const HEIGHT: f64 = 0.5;

/// A section of which a part is filled already.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Opening<'a> {
    pub(crate) section: &'a Section,
    /// Area that is filled, mm^2.
    pub(crate) filled: f64,
}

impl Opening<'_> {
    /// Area to be filled, mm^2.
    fn to_fill(self) -> f64 {
        self.section.total() - self.filled
    }

    /// The level below which lies this part of the area to be filled.
    fn level(&self, part: f64) -> Level {
        Level::new(self.section, self.filled + part * self.to_fill())
    }
}

/// The layers that fill a joint best, judged at sections along the seam, the first of them the most important one. The
/// lowest is a root layer only `from_root`.
///
/// Errors: the number of beads it would take, if that is more than [`MAX_BEADS`].
pub(crate) fn layers(sections: &[Opening], runs: &Runs, from_root: bool) -> Result<Vec<Layer>, f64> {
    let total = sections[0].to_fill();
    // Before the first layer is made: each of them takes memory, and there may be more than there is.
    let beads = total / runs.smallest();
    if beads > MAX_BEADS as f64 {
        return Err(beads);
    }
    let best = Search::new(sections, runs, from_root).best();
    // The same layers with one factor for all beads: often better, as levels are steps.
    let area: f64 = best.iter().map(|l| l.beads as f64 * runs.of(l.role).area).sum();
    let even: Vec<Layer> =
        best.iter().map(|l| Layer { share: l.beads as f64 * runs.of(l.role).area / area, ..*l }).collect();
    let cost = |layers: &[Layer]| stack_cost(sections, runs, layers);
    Ok(if cost(&even) <= cost(&best) { even } else { best })
}

/// Cost of a stack of layers.
fn stack_cost(sections: &[Opening], runs: &Runs, layers: &[Layer]) -> f64 {
    let one = |opening: &Opening| {
        let chord = opening.section.chord();
        let mut filled = 0.0;
        let mut low = opening.level(0.0);
        let of = |layer: &Layer| {
            filled += layer.share;
            let high = opening.level(filled);
            let shape = LayerShape::new(&low, &high, chord);
            low = high;
            layer_cost(&shape, layer.beads, runs.of(layer.role), runs)
        };
        layers.iter().map(of).sum::<f64>()
    };
    sections.iter().map(one).sum()
}

/// Cost of a layer of `count` beads at one station.
fn layer_cost(layer: &LayerShape, count: usize, run: &RunValues, runs: &Runs) -> f64 {
    if layer.area <= 0.0 || layer.height <= 0.0 {
        return f64::INFINITY;
    }
    let size = layer.bead(count, runs.spacing);
    let ratio = layer.area / count as f64 / run.area;
    let areas = [1.0 - runs.most, 1.0 + runs.most];
    let outside: f64 =
        run.outside(size, count).map(|q| q.excess).into_iter().chain([excess(ratio, areas)]).map(|e| e * e).sum();
    let height = (layer.height / run.layer).ln();
    OUTSIDE * outside + ratio.ln() * ratio.ln() + HEIGHT * height * height
}

/// Logarithm of the factor by which a value is outside a range; 0 inside.
pub(crate) fn excess(value: f64, [low, high]: [f64; 2]) -> f64 {
    if value < low {
        (low / value).ln()
    } else if value > high {
        (value / high).ln()
    } else {
        0.0
    }
}

/// The cheapest way from level to level.
struct Search<'a> {
    runs: &'a Runs,
    /// True if the lowest layer is a root layer.
    from_root: bool,
    /// Parts of the area to be filled below the levels.
    parts: Vec<f64>,
    /// The levels, from the root out, at each section.
    levels: Vec<Vec<Level>>,
    chords: Vec<f64>,
    /// Maximum number of steps of a layer.
    reach: usize,
}

/// The best layer that ends at a level.
#[derive(Clone, Copy)]
struct Step {
    /// Cost of it and all below.
    cost: f64,
    from: usize,
    role: Role,
    beads: usize,
}

impl<'a> Search<'a> {
    fn new(sections: &[Opening], runs: &'a Runs, from_root: bool) -> Self {
        let Opening { section: chosen, filled } = sections[0];
        let (low, high) = (chosen.slices.height_of(filled), chosen.slices.heights().1);
        let heights = || runs.all().map(|run| run.layer);
        let finest = heights().fold(f64::INFINITY, f64::min) / LEVELS_PER_LAYER;
        let highest = MAX_LAYER * heights().fold(0.0, f64::max);
        // A layer from each level to all within its reach.
        let most = (MAX_EDGES * ((high - low) / highest).max(1.0)).sqrt();
        let count = ((high - low) / finest).min(most).max(MIN_LEVELS).ceil() as usize;
        let step = (high - low) / count as f64;
        let to_fill = sections[0].to_fill();
        let part = |i: usize| (chosen.slices.area_below(low + step * i as f64) - filled).max(0.0) / to_fill;
        let mut parts: Vec<f64> = (0..count).map(part).collect();
        parts.push(1.0);
        let levels = sections.iter().map(|s| parts.iter().map(|p| s.level(*p)).collect()).collect();
        let reach = (highest / step).ceil().clamp(1.0, count as f64) as usize;
        let chords = sections.iter().map(|s| s.section.chord()).collect();
        Self { runs, from_root, parts, levels, chords, reach }
    }

    fn best(&self) -> Vec<Layer> {
        let last = self.parts.len() - 1;
        let none = Step { cost: f64::INFINITY, from: 0, role: Role::Cap, beads: 1 };
        let mut steps = vec![none; last + 1];
        steps[0].cost = 0.0;
        for to in 1..=last {
            for from in to.saturating_sub(self.reach)..to {
                // A layer that costs more than the best one known is not looked at to its end.
                let room = steps[to].cost - steps[from].cost;
                if room > 0.0
                    && let Some(step) = self.step(from, to, room)
                {
                    steps[to] = Step { cost: steps[from].cost + step.cost, ..step };
                }
            }
        }
        let (mut layers, mut at) = (Vec::new(), last);
        while at > 0 {
            let Step { from, role, beads, .. } = steps[at];
            let stick_out = self.runs.of(role).stick_out_mm.map_or(USUAL_STICK_OUT_MM, Positive::get);
            layers.push(Layer { role, beads, share: self.parts[at] - self.parts[from], stick_out });
            at = from;
        }
        layers.reverse();
        layers
    }

    /// The best layer between two levels that costs less than `room`.
    fn step(&self, from: usize, to: usize, room: f64) -> Option<Step> {
        let role = match (from, to) {
            (0, _) if self.from_root && self.runs.root.is_some() => Role::Root,
            (_, to) if to + 1 == self.parts.len() => Role::Cap,
            _ => Role::Fill,
        };
        let run = self.runs.of(role);
        let shape = |k: usize| LayerShape::new(&self.levels[k][from], &self.levels[k][to], self.chords[k]);
        let wanted = (shape(0).area / run.area).round();
        let count = |k: i32| (wanted + f64::from(k)).clamp(1.0, MAX_IN_LAYER) as usize;
        // A root pass of its own is one bead.
        let counts = if role == Role::Root { 1..=1 } else { count(-MORE_OR_LESS)..=count(MORE_OR_LESS) };
        let mut best: Option<Step> = None;
        for beads in counts {
            let limit = best.map_or(room, |step| step.cost);
            let mut cost = 0.0;
            for k in 0..self.levels.len() {
                cost += layer_cost(&shape(k), beads, run, self.runs);
                if cost >= limit {
                    break;
                }
            }
            if cost < limit {
                best = Some(Step { cost, from, role, beads });
            }
        }
        best
    }
}
