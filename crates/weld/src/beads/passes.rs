use super::file::{Adapt, Beads, WIRE_FEED};
use super::layers::Runs;
use super::plan::BeadPlan;
use super::run_values::RunValues;
use super::sectors::Sectors;
use crate::seam::SeamCurve;
use seamwright_document::{Finite, NonNegative, Positive};
use seamwright_program::{
    Bead, Pass, Ramp, Role, Span, SpanValue, StepOver, Weave, is_same_position, part_start, parts_of,
};

/// Speed or wire feed between the ends of a span may be off a straight line by this part.
const STRAIGHT: f64 = 2e-3;

/// Minimum number of parts of a step-over between which speed or wire feed is straight.
const STEP_OVER_PARTS: f64 = 16.0;

/// A bead over a part of the seam, or several beads all round it in one pass.
struct Run {
    /// The beads in the order of welding, as counted at a station.
    beads: Vec<usize>,
    /// Step-overs from each of them to the next.
    steps: Vec<StepOver>,
    begin: f64,
    length: f64,
    reverse: bool,
}

impl Run {
    /// The step-over before or in which the run is at its own path length `s`, with the index of the bead before it.
    fn step_at(&self, s: f64) -> Option<(usize, &StepOver)> {
        self.steps.iter().enumerate().find(|(_, step)| s < step.range().to_mm)
    }

    /// Path length on the seam at the own path length `s`, counted on from turn to turn, mm.
    fn on_seam(&self, s: f64) -> f64 {
        if self.reverse { self.begin - s } else { self.begin + s }
    }
}

/// A pass with the indices of its beads, as they are counted at a station.
pub(crate) struct PassOfBeads {
    pub(crate) pass: Pass,
    pub(crate) beads: Vec<usize>,
}

/// The passes of a plan in the order of welding. Values common to all are those of `template`.
pub(crate) fn passes(
    plan: &BeadPlan,
    beads: &Beads,
    runs: &Runs,
    sectors: &Sectors,
    seam: &SeamCurve,
    template: &Pass,
) -> Vec<PassOfBeads> {
    let making = Making { plan, beads, runs, sectors, template };
    let mut all = Vec::new();
    for group in groups(plan, beads) {
        let parts = &plan.parts[plan.at_station(0)[group[0]].layer];
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
            let more = (group.len() - 1) as f64 * seam.length();
            let steps = making.steps(&group, seam);
            let run = Run { beads: group.clone(), steps, begin, length: to - from + more, reverse };
            let mut pass = making.pass(&run);
            if pieces.len() > 1 {
                pass.name = format!("{}, part {}", pass.name, i + 1);
            }
            all.push(PassOfBeads { pass, beads: run.beads });
        }
    }
    all
}

/// The beads of each pass: one, or with step-overs all that follow one another in the same role, but for the root. A
/// groove that is measured again after a layer ends a pass there.
fn groups(plan: &BeadPlan, beads: &Beads) -> Vec<Vec<usize>> {
    let layer = |bead: usize| plan.at_station(0)[bead].layer;
    let role = |bead: usize| plan.layers[layer(bead)].role;
    let is_joined = |a: &usize, b: &usize| {
        let is_measured_between = layer(*a) != layer(*b) && plan.starts_stage(layer(*b));
        beads.step_over_mm.is_some() && role(*a) == role(*b) && role(*a) != Role::Root && !is_measured_between
    };
    plan.order.chunk_by(is_joined).map(<[usize]>::to_vec).collect()
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
    /// Step-overs between `beads`, each in the middle a whole number of turns after the start of the pass: so every bead
    /// has the length of the seam.
    fn steps(&self, beads: &[usize], seam: &SeamCurve) -> Vec<StepOver> {
        let Some(length_mm) = self.beads.step_over_mm else { return Vec::new() };
        let step = |(k, bead): (usize, &usize)| {
            let at_mm = Positive::new(k as f64 * seam.length())?;
            Some(StepOver { at_mm, length_mm, bead: self.columns(*bead) })
        };
        beads.iter().enumerate().skip(1).filter_map(step).collect()
    }

    /// Number of a bead in names of passes: its layer, and its place there if it is not alone.
    fn number(&self, bead: usize) -> String {
        let at = self.plan.at_station(0)[bead];
        match self.plan.layers[at.layer].beads {
            1 => format!("{}", at.layer + 1),
            _ => format!("{}.{}", at.layer + 1, at.index + 1),
        }
    }

    /// The bead's columns, with those of a weave that follows the groove.
    fn columns(&self, bead: usize) -> Bead {
        let values = self.values_of(bead);
        let weave = values.weave.as_ref().or(self.template.weave.as_ref());
        columns(self.plan, bead, weave.filter(|_| self.beads.adapt == Adapt::WeaveWidth))
    }

    fn values_of(&self, bead: usize) -> &RunValues {
        self.runs.of(self.plan.layers[self.plan.at_station(0)[bead].layer].role)
    }

    fn pass(&self, run: &Run) -> Pass {
        let first = run.beads[0];
        let layer = self.plan.layers[self.plan.at_station(0)[first].layer];
        let values = self.values_of(first);
        let mut pass = self.template.clone();
        pass.name = match run.beads.last() {
            Some(last) if *last != first => {
                format!("{} {} to {}", layer.role.name(), self.number(first), self.number(*last))
            }
            _ => format!("{} {}", layer.role.name(), self.number(first)),
        };
        pass.role = Some(layer.role);
        pass.begin_mm = NonNegative::new(run.begin).unwrap_or_default();
        pass.reverse = run.reverse;
        if let Some(travel) = values.travel_angle_deg {
            pass.torch.travel_angle_deg = travel;
        }
        if values.stick_out_mm.is_some() {
            pass.torch.stick_out_mm = values.stick_out_mm;
        }
        if let Some(weave) = &values.weave {
            pass.weave = Some(weave.clone());
        }
        pass.bead = Some(self.columns(first));
        pass.step_overs.clone_from(&run.steps);
        pass.spans = self.spans(values, run);
        pass
    }

    /// Area of the beads at the own path length `s` of a run, as a part of its run's, and the travel of the torch by
    /// path length as a multiple of that along a bead.
    fn deposit(&self, values: &RunValues, run: &Run, s: f64) -> Deposit {
        let on_seam = run.on_seam(s);
        let part = |bead: usize| self.plan.area(bead, on_seam).map_or(1.0, |area| values.wire_part(area));
        let Some((k, step)) = run.step_at(s) else {
            return Deposit { area: part(run.beads[run.steps.len()]), travel: 1.0 };
        };
        let (over, slope) = step.part(s);
        let [from, to] = [run.beads[k], run.beads[k + 1]];
        let sideways = slope * self.plan.distance(from, to, on_seam);
        Deposit { area: part(from) * (1.0 - over) + part(to) * over, travel: 1f64.hypot(sideways) }
    }

    /// Own path lengths at which spans end: at sectors, at ends of step-overs and at the end.
    fn ends(&self, run: &Run) -> Vec<f64> {
        let sense = if run.reverse { -1.0 } else { 1.0 };
        let mut ends = self.sectors.places(run.begin, sense, run.length);
        ends.extend(run.steps.iter().flat_map(|step| [step.range().from_mm, step.range().to_mm]));
        ends.push(run.length);
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|later, earlier| is_same_position(*later, *earlier));
        ends
    }

    /// Spans on which the value that follows the area is straight, and the factors of the sectors are.
    fn spans(&self, of_run: &RunValues, run: &Run) -> Vec<Span> {
        let station = self.plan.stations.get(1).copied().unwrap_or(run.length);
        let follows_feed = self.beads.adapt != Adapt::WireFeed && of_run.area_from_wire;
        let value = |s: f64| {
            let deposit = self.deposit(of_run, run, s);
            // The requested speed is that of the torch: where it travels farther, it lays as much in the same time.
            let ratio = deposit.area / deposit.travel;
            // More wire fills the same area at a higher speed.
            let feed = if follows_feed { self.sectors.factor(WIRE_FEED, run.on_seam(s)) } else { 1.0 };
            if self.beads.adapt == Adapt::WireFeed { ratio } else { feed / ratio }
        };
        let (mut spans, mut begin) = (Vec::new(), 0.0);
        for end in self.ends(run) {
            let middle = 0.5 * (begin + end);
            let over = run.step_at(middle).filter(|(_, step)| middle > step.range().from_mm);
            let step = over.map_or(station, |(_, step)| station.min(step.length_mm.get() / STEP_OVER_PARTS));
            let count = parts_of(end - begin, step);
            let places: Vec<f64> = (0..=count).map(|i| begin + part_start(end - begin, i, count)).collect();
            let values: Vec<f64> = places.iter().map(|s| value(*s)).collect();
            let mut first = 0;
            while first < count {
                let last = first + straight(&values[first..]);
                let [from, to] = [first, last].map(|i| (places[i], values[i]));
                let mut span = span(self.beads.adapt, of_run, from, to);
                for (name, value) in span.process.iter_mut().filter(|(name, _)| self.sectors.changes(name)) {
                    let [low, high] = [from.0, to.0].map(|s| self.sectors.factor(name, run.on_seam(s)));
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

/// Metal that a run lays at one position.
struct Deposit {
    /// Area as a part of that of a bead of the run.
    area: f64,
    /// Travel of the torch as a multiple of that along a bead.
    travel: f64,
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
    one_if_alike(Bead {
        weave_part: parts.iter().filter_map(|part| NonNegative::new(part.get())).collect(),
        s_mm: plan.stations.iter().map(|s| Finite::new(*s).unwrap_or_default()).collect(),
        across_mm: column(&|i| at(i).tip.x, 1e4),
        out_mm: column(&|i| at(i).tip.y, 1e4),
        work_angle_deg: column(&|i| at(i).lean.to_degrees(), 1e6),
        area_mm2: (0..plan.stations.len())
            .map(|i| NonNegative::new((at(i).area * 1e4).round() / 1e4).unwrap_or_default())
            .collect(),
    })
}

/// The first row alone if all rows are alike: it holds for the whole pass.
fn one_if_alike(mut bead: Bead) -> Bead {
    let is_alike = |column: &[Finite]| column.iter().all(|value| *value == column[0]);
    let is_same = |column: &[NonNegative]| column.iter().all(|value| *value == column[0]);
    let columns = [&bead.across_mm, &bead.out_mm, &bead.work_angle_deg].map(Vec::as_slice);
    if columns.into_iter().all(is_alike) && is_same(&bead.weave_part) && is_same(&bead.area_mm2) {
        for column in [&mut bead.s_mm, &mut bead.across_mm, &mut bead.out_mm, &mut bead.work_angle_deg] {
            column.truncate(1);
        }
        bead.weave_part.truncate(1);
        bead.area_mm2.truncate(1);
    }
    bead
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

fn span(adapt: Adapt, values: &RunValues, from: (f64, f64), to: (f64, f64)) -> Span {
    let mut span = Span {
        from_mm: NonNegative::new(from.0).unwrap_or_default(),
        to_mm: Positive::new(to.0).unwrap_or(Positive::TEN),
        speed_mm_s: values.speed.into(),
        process: values.process.clone(),
    };
    match adapt {
        Adapt::Speed | Adapt::WeaveWidth | Adapt::Passes => {
            let ends = [from.1, to.1].map(|v| Positive::new(rounded(v * values.speed.get())));
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
