use super::file::{Adapt, Asked, Beads, WIRE_FEED};
use super::layers::Runs;
use super::plan::BeadPlan;
use super::sectors::Sectors;
use crate::seam::SeamCurve;
use seamwright_document::{Finite, NonNegative, Positive};
use seamwright_program::{Bead, Pass, Ramp, Span, SpanValue, Weave, part_start, parts_of};

/// Speed or wire feed between the ends of a span may be off a straight line by this part.
const STRAIGHT: f64 = 2e-3;

/// A bead over a part of the seam, or all along it.
struct Run {
    /// The bead, as counted at a station.
    bead: usize,
    begin: f64,
    length: f64,
    reverse: bool,
}

/// The passes of a plan in the order of welding, each with the index of its bead. Values common to all are those of
/// `template`.
pub(crate) fn passes(
    plan: &BeadPlan,
    beads: &Beads,
    runs: &Runs,
    sectors: &Sectors,
    seam: &SeamCurve,
    template: &Pass,
) -> Vec<(Pass, usize)> {
    let making = Making { plan, beads, runs, sectors, template };
    let mut all = Vec::new();
    for &bead in &plan.order {
        let parts = &plan.parts[plan.at_station(0)[bead].layer];
        let pieces: Vec<Option<(f64, f64)>> =
            if parts.is_empty() { vec![None] } else { parts.iter().copied().map(Some).collect() };
        for (i, part) in pieces.iter().enumerate() {
            let number = all.len();
            let reverse = beads.alternate && number % 2 == 1;
            let stagger = number as f64 * beads.stagger_mm.get();
            let (from, to) = match part {
                Some(part) => *part,
                None if seam.all_round() => (stagger % seam.length(), stagger % seam.length() + seam.weld_length()),
                None => (0.0, seam.weld_length()),
            };
            let begin = match part {
                None if reverse && seam.all_round() => from,
                // A part may end beyond the seam's start.
                _ if reverse && seam.all_round() => to % seam.length(),
                _ if reverse => to,
                _ => from,
            };
            let run = Run { bead, begin, length: to - from, reverse };
            let mut pass = making.pass(&run);
            if pieces.len() > 1 {
                pass.name = format!("{}, part {}", pass.name, i + 1);
            }
            all.push((pass, bead));
        }
    }
    all
}

/// Inputs of all passes.
struct Making<'a> {
    plan: &'a BeadPlan,
    beads: &'a Beads,
    runs: &'a Runs,
    sectors: &'a Sectors,
    template: &'a Pass,
}

impl Making<'_> {
    fn pass(&self, run: &Run) -> Pass {
        let at = self.plan.at_station(0)[run.bead];
        let layer = self.plan.layers[at.layer];
        let asked = self.runs.of(layer.role);
        let mut pass = self.template.clone();
        pass.name = match layer.beads {
            1 => format!("{} {}", layer.role.name(), at.layer + 1),
            _ => format!("{} {}.{}", layer.role.name(), at.layer + 1, at.index + 1),
        };
        pass.role = Some(layer.role);
        pass.begin_mm = NonNegative::new(run.begin).unwrap_or_default();
        pass.reverse = run.reverse;
        if let Some(travel) = asked.travel_angle_deg {
            pass.torch.travel_angle_deg = travel;
        }
        if let Some(weave) = &asked.weave {
            pass.weave = Some(weave.clone());
        }
        let follows = pass.weave.as_ref().filter(|_| self.beads.adapt == Adapt::WeaveWidth);
        pass.bead = Some(columns(self.plan, run.bead, follows));
        pass.spans = self.spans(asked, run);
        pass
    }

    /// Spans on which the value that follows the area is straight, and the factors of the sectors are.
    fn spans(&self, asked: &Asked, run: &Run) -> Vec<Span> {
        let step = self.plan.stations.get(1).copied().unwrap_or(run.length);
        let sense = if run.reverse { -1.0 } else { 1.0 };
        let mut ends = self.sectors.places(run.begin, sense, run.length);
        ends.push(run.length);
        let on_seam = |s: f64| run.begin + sense * s;
        let follows_feed = self.beads.adapt != Adapt::WireFeed && asked.area_from_wire;
        let value = |s: f64| {
            let ratio = self.plan.area(run.bead, on_seam(s)).map_or(1.0, |area| asked.wire_part(area));
            // More wire fills the same area at a higher speed.
            let feed = if follows_feed { self.sectors.factor(WIRE_FEED, on_seam(s)) } else { 1.0 };
            if self.beads.adapt == Adapt::WireFeed { ratio } else { feed / ratio }
        };
        let (mut spans, mut begin) = (Vec::new(), 0.0);
        for end in ends {
            let count = parts_of(end - begin, step);
            let places: Vec<f64> = (0..=count).map(|i| begin + part_start(end - begin, i, count)).collect();
            let values: Vec<f64> = places.iter().map(|s| value(*s)).collect();
            let mut first = 0;
            while first < count {
                let last = first + straight(&values[first..]);
                let [from, to] = [first, last].map(|i| (places[i], values[i]));
                let mut span = span(self.beads.adapt, asked, from, to);
                for (name, value) in span.process.iter_mut().filter(|(name, _)| self.sectors.changes(name)) {
                    let [low, high] = [from.0, to.0].map(|s| self.sectors.factor(name, on_seam(s)));
                    scale(value, low, high);
                }
                spans.push(span);
                first = last;
            }
            begin = end;
        }
        spans
    }
}

/// Multiplies both ends of a value.
fn scale(value: &mut SpanValue<Finite>, from: f64, to: f64) {
    let (a, b) = value.ends();
    let [a, b] = [a * from, b * to].map(|value| Finite::new(rounded(value)).unwrap_or_default());
    *value = if a == b { SpanValue::Steady(a) } else { SpanValue::Ramp(Ramp { from: a, to: b }) };
}

/// Rounds to six digits, more than any machine keeps.
fn rounded(value: f64) -> f64 {
    let digits = 10_f64.powf(5.0 - value.abs().log10().floor());
    if value == 0.0 { 0.0 } else { (value * digits).round() / digits }
}

/// Position of the bead at every station, and the width of a weave that `follows` the groove.
fn columns(plan: &BeadPlan, bead: usize, follows: Option<&Weave>) -> Bead {
    // Rounded to the resolution of a file: a tenth of a micrometre, a millionth of a degree.
    let rounded = |value: f64, digits: f64| Finite::new((value * digits).round() / digits).unwrap_or_default();
    let column = |value: &dyn Fn(usize) -> f64, digits: f64| {
        (0..plan.stations.len()).map(|i| rounded(value(i), digits)).collect::<Vec<_>>()
    };
    let at = |i: usize| plan.at_station(i)[bead];
    let part = |width: f64| column(&|i| (at(i).room / width).min(1.0), 1e4);
    let parts = follows.map_or(Vec::new(), |weave| part(weave.width_mm.get()));
    Bead {
        weave_part: parts.iter().filter_map(|part| NonNegative::new(part.get())).collect(),
        s_mm: plan.stations.iter().map(|s| Finite::new(*s).unwrap_or_default()).collect(),
        across_mm: column(&|i| at(i).tip.x, 1e4),
        out_mm: column(&|i| at(i).tip.y, 1e4),
        work_angle_deg: column(&|i| at(i).lean.to_degrees(), 1e6),
        area_mm2: (0..plan.stations.len())
            .map(|i| NonNegative::new((at(i).area * 1e4).round() / 1e4).unwrap_or_default())
            .collect(),
    }
}

/// Number of steps from the first of `values` (at least two) over which a line deviates from each by at most
/// [`STRAIGHT`] of it. One pass over the values: each narrows the permitted slopes of the line.
fn straight(values: &[f64]) -> usize {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let goes_on = |(i, value): &(usize, &f64)| {
        let slope = |value: f64| (value - values[0]) / *i as f64;
        (low, high) = (low.max(slope((1.0 - STRAIGHT) * **value)), high.min(slope((1.0 + STRAIGHT) * **value)));
        (low..=high).contains(&slope(**value))
    };
    values.iter().enumerate().skip(1).take_while(goes_on).count().max(1)
}

fn span(adapt: Adapt, asked: &Asked, from: (f64, f64), to: (f64, f64)) -> Span {
    let mut span = Span {
        from_mm: NonNegative::new(from.0).unwrap_or_default(),
        to_mm: Positive::new(to.0).unwrap_or(Positive::TEN),
        speed_mm_s: asked.speed.into(),
        process: asked.process.clone(),
    };
    match adapt {
        Adapt::Speed | Adapt::WeaveWidth | Adapt::Passes => {
            let ends = [from.1, to.1].map(|v| Positive::new(rounded(v * asked.speed.get())));
            if let [Some(from), Some(to)] = ends {
                span.speed_mm_s = if from == to { SpanValue::Steady(from) } else { SpanValue::Ramp(Ramp { from, to }) };
            }
        }
        Adapt::WireFeed => {
            if let Some(feed) = span.process.get_mut(WIRE_FEED) {
                let of = |v: f64| Finite::new(rounded(v * feed.ends().0)).unwrap_or_default();
                *feed = SpanValue::Ramp(Ramp { from: of(from.1), to: of(to.1) });
            }
        }
    }
    span
}
