//! Findings against beads: areas that a run cannot have, sections outside their windows, steep toes, layers of another
//! height.

use super::fill::BeadAt;
use super::layers::{Runs, excess};
use super::plan::BeadPlan;
use super::run_values::RunValues;
use super::shape::BeadSize;
use seamwright_message::{Message, Unit};
use seamwright_program::{BeadWindow, Finding, PathRange};

/// A quantity of a bead's section that has a window.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Quantity {
    Width,
    Height,
    WidthToHeight,
    /// The width of a bead without a weave.
    Unwoven,
}

/// A quantity outside its window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Breach {
    quantity: Quantity,
    value: f64,
    range: [f64; 2],
    /// Logarithm of the factor by which it is outside.
    pub(crate) excess: f64,
}

/// Factor by which a layer's height may differ from the wanted one without a finding: a groove of one and a half layers
/// takes one or two. Not tuned; of the fill layers of `random_joints.rs` about one in ten is beyond it.
const WHOLE_LAYERS: f64 = 1.5;

/// Width that a bead alone in its layer gains by melting both walls, mm, up to its own width: 1 mm of each. Without it
/// every bead in a square gap would count as deeper than wide. Chosen from etched sections of handbooks (1 to 2 mm); checked
/// on the random joints of `random_joints.rs`.
const MELTED_MM: f64 = 2.0;
/// A layer's rounding beside a window's end.
const ROUNDING: f64 = 1e-9;

impl RunValues {
    /// The quantity that is farthest outside its window, in a layer of `count` beads.
    pub(crate) fn outside(&self, size: BeadSize, count: usize) -> Option<Breach> {
        let window = &self.window;
        // Alone in its layer a bead is as wide as the groove.
        let narrowest = if count == 1 { 0.0 } else { window.width_mm[0] };
        let melted = if count == 1 { MELTED_MM.min(size.width) } else { 0.0 };
        let unwoven = if self.weave.is_some() { f64::INFINITY } else { window.max_unwoven_mm };
        let all = [
            (Quantity::Unwoven, size.width, [0.0, unwoven]),
            (Quantity::Width, size.width, [narrowest, window.width_mm[1]]),
            (Quantity::Height, size.height, window.height_mm),
            (Quantity::WidthToHeight, (size.width + melted) / size.height, window.width_to_height),
        ];
        let breaches =
            all.map(|(quantity, value, range)| Breach { quantity, value, range, excess: excess(value, range) });
        breaches.into_iter().filter(|b| b.excess > ROUNDING).max_by(|a, b| a.excess.total_cmp(&b.excess))
    }
}

impl Breach {
    fn message(&self, bead: &BeadAt) -> Message {
        let (code, unit) = match self.quantity {
            Quantity::Width => ("weld-bead-width-out-of-window", Unit::Mm),
            Quantity::Height => ("weld-bead-height-out-of-window", Unit::Mm),
            Quantity::WidthToHeight => ("weld-bead-ratio-out-of-window", Unit::One),
            Quantity::Unwoven => ("weld-bead-too-wide-without-weave", Unit::Mm),
        };
        let message =
            Message::new(code).quantity("width", bead.width, Unit::Mm, 1).quantity("height", bead.height, Unit::Mm, 1);
        let message = if self.quantity == Quantity::WidthToHeight {
            message.quantity("ratio", self.value, unit, 2)
        } else {
            message
        };
        let message =
            if self.quantity == Quantity::Unwoven { message } else { message.quantity("min", self.range[0], unit, 1) };
        message.quantity("max", self.range[1], unit, 1)
    }

    fn cure(&self) -> Message {
        Message::new(match self.quantity {
            Quantity::Unwoven => "weld-cure-weave-or-smaller-beads",
            _ => "weld-cure-bead-window",
        })
    }
}

/// The pass that lays a bead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BeadPlace {
    /// Its number, from 1.
    pub(crate) pass: usize,
    /// Length of the turns before the bead in a pass of several beads, mm.
    pub(crate) before_mm: f64,
}

impl Default for BeadPlace {
    fn default() -> Self {
        Self { pass: 1, before_mm: 0.0 }
    }
}

/// Angles at a toe are compared to this, degrees: a vertical wall has 90 to rounding.
pub(super) const TOE_ROUNDING_DEG: f64 = 1e-6;

/// A toe angle below its minimum, degrees.
struct SteepToe {
    angle: f64,
    min: f64,
}

/// A value that is wrong at some stations: the first and the last of them, and the worst.
struct Wrong<T> {
    range: PathRange,
    worst: T,
    station: usize,
}

impl BeadPlan {
    /// Beads whose area differs more than the runs allow from their run's, beads outside their windows, and layers that
    /// are not as high as asked for. `place_of` gives the place of a bead in its pass.
    pub(crate) fn findings(&self, runs: &Runs, place_of: impl Fn(usize) -> BeadPlace) -> Vec<Finding> {
        let mut findings = Vec::new();
        for b in 0..self.count() {
            let values = runs.of(self.layers[self.beads[b].layer].role);
            let BeadPlace { pass, before_mm } = place_of(b);
            let mut of_bead: Vec<Finding> = self.area_finding(b, values, runs.most, pass).into_iter().collect();
            of_bead.extend(self.window_finding(b, values, pass));
            of_bead.extend(self.toe_finding(b, values, pass));
            if self.beads[b].index == 0 {
                of_bead.extend(self.layer_finding(b, values, pass));
            }
            for finding in &mut of_bead {
                finding.from_mm += before_mm;
                finding.to_mm += before_mm;
            }
            findings.extend(of_bead);
        }
        findings
    }

    /// The stations at which bead `b` has a `fault`, of which the one with the largest first number is the worst.
    fn wrong<T>(&self, b: usize, fault: impl Fn(&BeadAt) -> Option<(f64, T)>) -> Option<Wrong<T>> {
        self.wrong_at(b, |_, bead| fault(bead))
    }

    /// The same with a `fault` that depends on the station.
    fn wrong_at<T>(&self, b: usize, fault: impl Fn(usize, &BeadAt) -> Option<(f64, T)>) -> Option<Wrong<T>> {
        let at = |i: usize| Some(&self.at_station(i)[b]).filter(|bead| bead.area > 0.0);
        let all = (0..self.stations.len()).filter_map(|i| Some((i, fault(i, at(i)?)?)));
        let mut found: Option<(Wrong<T>, f64)> = None;
        for (i, (size, fault)) in all {
            let s = self.stations[i];
            match &mut found {
                None => {
                    let range = PathRange { from_mm: s, to_mm: s };
                    found = Some((Wrong { range, worst: fault, station: i }, size));
                }
                Some((wrong, largest)) => {
                    wrong.range.to_mm = s;
                    if size > *largest {
                        (wrong.worst, wrong.station, *largest) = (fault, i, size);
                    }
                }
            }
        }
        found.map(|(wrong, _)| wrong)
    }

    fn area_finding(&self, b: usize, values: &RunValues, most: f64, pass: usize) -> Option<Finding> {
        let off = |bead: &BeadAt| {
            let ratio = bead.area / values.area;
            ((ratio - 1.0).abs() > most + ROUNDING).then(|| (ratio.ln().abs(), ratio))
        };
        let wrong = self.wrong(b, off)?;
        let cure = if wrong.worst > 1.0 { "weld-cure-thinner-layers" } else { "weld-cure-smaller-beads" };
        let message = Message::new("weld-bead-area-out-of-range")
            .quantity("area", wrong.worst * values.area, Unit::Mm2, 1)
            .quantity("ratio", 100.0 * wrong.worst, Unit::Percent, 1)
            .quantity("run", values.area, Unit::Mm2, 1)
            .quantity("min", 100.0 * (1.0 - most), Unit::Percent, 0)
            .quantity("max", 100.0 * (1.0 + most), Unit::Percent, 0);
        Some(Finding::error("bead", message, pass, wrong.range, Message::new(cure)))
    }

    fn window_finding(&self, b: usize, values: &RunValues, pass: usize) -> Option<Finding> {
        let count = self.layers[self.beads[b].layer].beads;
        let outside = |bead: &BeadAt| {
            let breach = values.outside(BeadSize { width: bead.width, height: bead.height }, count)?;
            Some((breach.excess, breach))
        };
        let wrong = self.wrong(b, outside)?;
        let message = wrong.worst.message(&self.at_station(wrong.station)[b]);
        let finding = Finding::error("bead", message, pass, wrong.range, wrong.worst.cure());
        Some(Finding { allowed: !values.window.is_binding, ..finding })
    }

    /// Toes of the cap on the parts that are steeper than the quality level allows. Valleys between beads are no toes.
    fn toe_finding(&self, b: usize, values: &RunValues, pass: usize) -> Option<Finding> {
        let layer = self.layers[self.beads[b].layer];
        // A root or a fill bead may be the only layer.
        if self.beads[b].layer + 1 != self.layers.len() {
            return None;
        }
        let index = self.beads[b].index;
        let (on_second, on_first) = (index == 0, index + 1 == layer.beads);
        let steep = |i: usize, bead: &BeadAt| {
            let toes = [(on_second, bead.toes.second), (on_first, bead.toes.first)];
            let angle = toes.iter().filter(|(is_on_part, _)| *is_on_part).map(|(_, angle)| angle.to_degrees());
            let angle = angle.fold(f64::INFINITY, f64::min);
            let min = min_toe_deg(&values.window, self.dihedrals[i], angle, bead);
            (angle < min - TOE_ROUNDING_DEG).then_some((min - angle, SteepToe { angle, min }))
        };
        let wrong = self.wrong_at(b, steep)?;
        Some(toe_finding(wrong.worst.angle, wrong.worst.min, pass, wrong.range, &values.window))
    }

    fn layer_finding(&self, b: usize, values: &RunValues, pass: usize) -> Option<Finding> {
        let off = |bead: &BeadAt| {
            let off = (bead.layer_height / values.layer).ln().abs();
            (off > WHOLE_LAYERS.ln() + ROUNDING).then_some((off, bead.layer_height))
        };
        let wrong = self.wrong(b, off)?;
        let message = Message::new("weld-layer-height-not-kept")
            .quantity("height", wrong.worst, Unit::Mm, 1)
            .quantity("wanted", values.layer, Unit::Mm, 1)
            .quantity("area", values.area, Unit::Mm2, 1);
        let finding = Finding::error("bead", message, pass, wrong.range, Message::new("weld-cure-layer-height"));
        Some(Finding { allowed: true, ..finding })
    }
}

/// The finding that a toe has the `angle` instead of `min` or more, degrees: an error if the procedure gives the limit.
pub(super) fn toe_finding(angle: f64, min: f64, pass: usize, range: PathRange, window: &BeadWindow) -> Finding {
    let message =
        Message::new("weld-bead-toe-steep").quantity("angle", angle, Unit::Deg, 0).quantity("min", min, Unit::Deg, 0);
    let finding = Finding::error("bead", message, pass, range, Message::new("weld-cure-bead-toe"));
    Finding { allowed: window.given_toe_deg.is_none(), ..finding }
}

/// Minimum toe angle of `bead` with the toe `angle` between faces with this angle (rad), degrees. A joint whose flat face
/// would be steeper than usual is reported only for what the beads add.
pub(super) fn min_toe_deg(window: &BeadWindow, dihedral: f64, angle: f64, bead: &BeadAt) -> f64 {
    let flat = if window.given_toe_deg.is_some() { f64::INFINITY } else { angle + bead.toes.convexity.to_degrees() };
    window.min_toe_deg(dihedral).min(flat)
}
