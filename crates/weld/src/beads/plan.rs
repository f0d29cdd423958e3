use super::file::{Adapt, Beads, Order};
use super::fill::{BeadAt, Laying, Stack, fill};
use super::layers::{Layer, Opening, Runs, layers};
use super::refusal::NoPlan;
use crate::joint::{SeamJoint, Section};
use crate::seam::SeamCurve;
use seamwright_program::{BeadWindow, Role, part_start, parts_of};

/// Positions of all beads along a seam.
#[derive(Debug, Clone, PartialEq)]
pub struct BeadPlan {
    /// Layers from the root out.
    pub layers: Vec<Layer>,
    /// Stations along the seam at which the beads were laid out, mm from the start of the weld. On a seam welded all
    /// round evenly from 0 to less than its length, else with both ends.
    pub stations: Vec<f64>,
    /// Area of groove and cap at the stations, mm^2.
    pub totals: Vec<f64>,
    /// Dihedral angle of the faces at the stations, rad.
    pub(crate) dihedrals: Vec<f64>,
    /// Parts of the seam on which a layer is, by layer: empty where it is all along.
    pub parts: Vec<Vec<(f64, f64)>>,
    /// The beads at all stations, station by station, [`BeadPlan::count`] each, also those that are not there (area 0).
    pub(crate) beads: Vec<BeadAt>,
    /// The beads in the order of welding, as they are counted at a station.
    pub order: Vec<usize>,
    /// Number of beads at a station.
    per_station: usize,
    /// Layers planned from each state in which the groove was measured.
    stages: Vec<Stage>,
    laying: Laying,
    /// Window of the last layer's beads.
    pub(crate) last_window: BeadWindow,
    /// The seam's length if it is welded all round.
    period: Option<f64>,
}

/// Layers planned from one state of the groove.
#[derive(Debug, Clone, PartialEq)]
struct Stage {
    /// Index of the first of them.
    first: usize,
    /// The part of the groove's area that was open before them, at the stations.
    open: Vec<f64>,
}

/// Minimum area of the layers of a stage as a part of the whole: measured areas may contradict each other.
const SLIVER: f64 = 1e-6;

/// Maximum number of stations along a seam; more are a mistake: 100 m of seam at the default distance.
pub(crate) const MAX_STATIONS: usize = 20_000;
/// More beads times stations, or passes times stations, take more memory than a plan is worth.
pub(crate) const MAX_BEAD_STATIONS: usize = 1_000_000;

/// A part of the seam for one layer may end this much of a station beyond the last station it is at.
const HALF: f64 = 0.5;

/// Sections at which layers are judged, by their areas from the smallest to the largest.
const JUDGED: usize = 5;

/// Stations by which the layers are chosen, the one of mean area first; if layers may be left out that of the largest.
fn judged(totals: &[f64], adapt: Adapt) -> Vec<usize> {
    let mut by_area: Vec<usize> = (0..totals.len()).collect();
    by_area.sort_by(|a, b| totals[*a].total_cmp(&totals[*b]));
    let last = by_area.len() - 1;
    if adapt == Adapt::Passes {
        return vec![by_area[last]];
    }
    let mean = (totals[by_area[0]] * totals[by_area[last]]).sqrt();
    let nearest =
        by_area.iter().copied().min_by(|a, b| (totals[*a] - mean).abs().total_cmp(&(totals[*b] - mean).abs()));
    let ranks = (0..JUDGED).map(|k| by_area[k * last / (JUDGED - 1)]);
    let mut judged: Vec<usize> = nearest.into_iter().chain(ranks).collect();
    let mut seen = Vec::new();
    judged.retain(|i| {
        !seen.contains(i) && {
            seen.push(*i);
            true
        }
    });
    judged
}

/// Shares of some layers together, and the sizes of their beads.
#[derive(Debug, Clone, Copy)]
struct Sizes {
    shares: f64,
    /// Sizes of the smallest and the largest bead, as parts of their runs' areas, before shares are scaled.
    range: (f64, f64),
}

impl Default for Sizes {
    fn default() -> Self {
        Self { shares: 0.0, range: (f64::INFINITY, 0.0) }
    }
}

impl Sizes {
    fn add(&mut self, share: f64, size: f64) {
        self.shares += share;
        self.range = (self.range.0.min(size), self.range.1.max(size));
    }

    /// Logarithm of the factor by which the worst bead is off where all layers fill `part` of the largest area.
    fn off(&self, part: f64) -> f64 {
        let of = |size: f64| (size * part / self.shares).ln().abs();
        of(self.range.0).max(of(self.range.1))
    }
}

impl BeadPlan {
    /// Lays out the beads of `beads` along a seam with a joint. The layers are chosen so that the beads keep their
    /// windows all along the seam (at its largest area, if layers may be left out). They fill the groove everywhere.
    ///
    /// If the groove was measured again after some layers, these stay as they were planned. The layers above fill the
    /// area that was open then.
    ///
    /// Guarantee: at every station the areas of the beads planned last sum to the open area and the cap, away from ends
    /// of layers. Errors: a station without a groove, and plans that would be too large: found before they are made.
    pub(crate) fn new(seam: &SeamCurve, joint: &SeamJoint, beads: &Beads, runs: &Runs) -> Result<Self, NoPlan> {
        let mut plan = Self::of_state(seam, joint, beads, runs, 0)?;
        for state in 1..joint.states() {
            let (done, entry) = joint.after_layer(state);
            if done >= plan.layers.len() {
                return Err(NoPlan::Layers { entry, layers: plan.layers.len() });
            }
            plan = plan.followed_by(done, Self::of_state(seam, joint, beads, runs, state)?);
            plan.check_size()?;
        }
        Ok(plan)
    }

    /// Fails if the plan takes too much memory.
    fn check_size(&self) -> Result<(), NoPlan> {
        let stations = self.stations.len();
        // A layer over several pieces of the seam has each bead as often, with all of its rows.
        let passes: usize = self.layers.iter().zip(&self.parts).map(|(l, parts)| l.beads * parts.len().max(1)).sum();
        let too_many = passes.max(self.per_station) * stations > MAX_BEAD_STATIONS;
        if too_many { Err(NoPlan::Positions { passes, stations }) } else { Ok(()) }
    }

    /// Lays out the beads that fill the groove as measured in a state.
    fn of_state(seam: &SeamCurve, joint: &SeamJoint, beads: &Beads, runs: &Runs, state: usize) -> Result<Self, NoPlan> {
        let period = seam.all_round().then(|| seam.length());
        let length = period.unwrap_or_else(|| seam.weld_length());
        let cells = parts_of(length, beads.station_mm.get());
        let count = if period.is_some() { cells } else { cells + 1 };
        if count > MAX_STATIONS {
            return Err(NoPlan::Stations(count));
        }
        let stations: Vec<f64> = (0..count).map(|i| part_start(length, i, cells)).collect();
        let section = |s: &f64| joint.try_section(state, &seam.at(*s)).map_err(|why| NoPlan::NoGroove { s: *s, why });
        let sections: Vec<Section> = stations.iter().map(section).collect::<Result<_, _>>()?;
        let stage = Stage { first: 0, open: stations.iter().map(|s| joint.open_part(state, *s)).collect() };
        let totals: Vec<f64> = sections.iter().map(Section::total).collect();
        let filled = |i: usize| (1.0 - stage.open[i]) * sections[i].area();
        let to_fill: Vec<f64> = (0..count).map(|i| (totals[i] - filled(i)).max(SLIVER * totals[i])).collect();
        let judged = judged(&to_fill, beads.adapt);
        let chosen: Vec<Opening> =
            judged.iter().map(|i| Opening { section: &sections[*i], filled: totals[*i] - to_fill[*i] }).collect();
        let layers = layers(&chosen, runs, state == 0).map_err(|beads| {
            let groove = to_fill[judged[0]];
            NoPlan::Beads { groove, beads, smallest: groove / beads }
        })?;
        let last_window = runs.of(layers.last().map_or(Role::Cap, |layer| layer.role)).window;
        let laying = Laying {
            wall: beads.wall(),
            tilt: beads.wall_tilt_deg.get().to_radians(),
            shared: beads.adapt == Adapt::WeaveWidth,
            spacing: runs.spacing,
        };
        let mut plan = Self {
            parts: vec![Vec::new(); layers.len()],
            per_station: layers.iter().map(|l| l.beads).sum(),
            layers,
            stations,
            totals,
            dihedrals: sections.iter().map(|section| section.dihedral).collect(),
            beads: Vec::new(),
            order: Vec::new(),
            stages: vec![stage],
            last_window,
            laying,
            period,
        };
        plan.check_size()?;
        if beads.adapt == Adapt::Passes {
            plan.leave_out(runs, beads.shortest_mm.get(), &to_fill);
            plan.per_station = plan.layers.iter().map(|l| l.beads).sum();
            plan.check_size()?;
        }
        plan.order = plan.ordered(beads.order);
        let mut here = Vec::new();
        for (i, section) in sections.iter().enumerate() {
            plan.lay(section, plan.stations[i], &mut here);
            plan.beads.extend_from_slice(&here);
        }
        plan.tie_in(beads.tie_in_mm.get());
        Ok(plan)
    }

    /// This plan up to layer `done`, then the layers of `later`, which has the same stations.
    fn followed_by(self, done: usize, later: Self) -> Self {
        let kept: usize = self.layers[..done].iter().map(|l| l.beads).sum();
        let of_layer = |bead: &BeadAt| BeadAt { layer: bead.layer + done, ..*bead };
        let beads = (0..self.stations.len()).flat_map(|i| {
            let above = later.at_station(i).iter().map(of_layer);
            self.at_station(i)[..kept].iter().copied().chain(above)
        });
        let stages = self.stages.iter().filter(|stage| stage.first < done).cloned();
        let above = later.stages.iter().map(|stage| Stage { first: stage.first + done, open: stage.open.clone() });
        Self {
            beads: beads.collect(),
            layers: self.layers[..done].iter().chain(&later.layers).copied().collect(),
            parts: self.parts[..done].iter().chain(&later.parts).cloned().collect(),
            order: self
                .order
                .iter()
                .copied()
                .filter(|b| *b < kept)
                .chain(later.order.iter().map(|b| b + kept))
                .collect(),
            stages: stages.chain(above).collect(),
            per_station: kept + later.per_station,
            ..later
        }
    }

    /// Lets beads change evenly over `length` (mm) where another layer starts or ends. Metal is kept: what is too much
    /// before the end is too little after it.
    fn tie_in(&mut self, length: f64) {
        let n = self.stations.len();
        let ends: Vec<f64> = self.parts.iter().flatten().flat_map(|(from, to)| [*from, *to]).collect();
        for end in ends {
            let near = |i: usize| {
                let away = self.stations[i] - end;
                self.period.map_or(away, |period| (away + 0.5 * period).rem_euclid(period) - 0.5 * period)
            };
            let mut within: Vec<(f64, usize)> = (0..n).map(|i| (near(i), i)).collect();
            within.sort_by(|a, b| a.0.total_cmp(&b.0));
            let first = within.partition_point(|(away, _)| *away < -0.5 * length);
            let last = within.partition_point(|(away, _)| *away <= 0.5 * length);
            let (Some(before), Some(after)) = (first.checked_sub(1).map(|k| within[k]), within.get(last).copied())
            else {
                continue;
            };
            for bead in 0..self.count() {
                let [a, b] = [before.1, after.1].map(|i| self.at_station(i)[bead]);
                let between = &within[first..last];
                if a.area > 0.0 && b.area > 0.0 && between.iter().all(|(_, i)| self.at_station(*i)[bead].area > 0.0) {
                    for (away, i) in between {
                        let part = (away - before.0) / (after.0 - before.0);
                        let at = i * self.per_station + bead;
                        self.beads[at] = a.towards(&b, part);
                    }
                }
            }
        }
    }

    /// The beads layer by layer, each layer in the order asked for.
    fn ordered(&self, order: Order) -> Vec<usize> {
        let mut all = Vec::new();
        for layer in &self.layers {
            let (first, n) = (all.len(), layer.beads);
            match order {
                Order::FromSecond => all.extend(first..first + n),
                Order::FromFirst => all.extend((first..first + n).rev()),
                Order::WallsFirst if n < 3 => all.extend(first..first + n),
                Order::WallsFirst => all.extend([first, first + n - 1].into_iter().chain(first + 1..first + n - 1)),
            }
        }
        all
    }

    /// Number of beads at a station.
    pub fn count(&self) -> usize {
        self.per_station
    }

    /// The beads at station `i`; those of layers that are not there have no area.
    pub fn at_station(&self, i: usize) -> &[BeadAt] {
        &self.beads[i * self.count()..][..self.count()]
    }

    /// Area of a bead (as counted at a station) at path length `s`, linear between stations; at an end of its layer
    /// that of the nearest one. `None` if it is absent at both.
    pub fn area(&self, bead: usize, s: f64) -> Option<f64> {
        let (before, after, part) = self.around(s);
        let at = |i: usize| Some(self.at_station(i)[bead].area).filter(|area| *area > 0.0);
        match (at(before), at(after)) {
            (Some(a), Some(b)) => Some(a + (b - a) * part),
            (a, b) => a.or(b),
        }
    }

    /// True if the groove was measured before layer `layer`, and after the ones below it.
    pub(crate) fn starts_stage(&self, layer: usize) -> bool {
        layer > 0 && self.stages.iter().any(|stage| stage.first == layer)
    }

    /// Distance between the wires of two beads (as counted at a station) at path length `s`, mm: linear between
    /// stations.
    pub(crate) fn distance(&self, a: usize, b: usize, s: f64) -> f64 {
        let (before, after, part) = self.around(s);
        let tip = |bead: usize| self.at_station(before)[bead].tip.lerp(self.at_station(after)[bead].tip, part);
        tip(a).distance(tip(b))
    }

    /// The beads of a section at any station of the seam in the order of welding, without absent ones.
    pub fn in_order(&self, section: &Section, s: f64) -> Vec<BeadAt> {
        let mut beads = Vec::new();
        self.lay(section, s, &mut beads);
        self.order.iter().map(|b| beads[*b]).filter(|bead| bead.area > 0.0).collect()
    }

    /// Number of a bead in drawings and tables, from 1: the beads in the order of welding, also those that are not all
    /// along the seam.
    pub fn number(&self, bead: &BeadAt) -> usize {
        let below: usize = self.layers[..bead.layer].iter().map(|layer| layer.beads).sum();
        self.order.iter().position(|other| *other == below + bead.index).map_or(0, |at| at + 1)
    }

    fn lay(&self, section: &Section, s: f64, out: &mut Vec<BeadAt>) {
        out.clear();
        let mut from = section.area() * (1.0 - self.open(0, s));
        for (k, stage) in self.stages.iter().enumerate() {
            let next = self.stages.get(k + 1).map(|next| next.first);
            let to = next.map_or(section.total(), |_| section.area() * (1.0 - self.open(k + 1, s)));
            let layers = &self.layers[stage.first..next.unwrap_or(self.layers.len())];
            let to = to.max(from + SLIVER * section.total());
            let stack = Stack { layers, first: stage.first, from, to };
            fill(section, &stack, |layer| self.is_there(layer, s), self.laying, out);
            from = to;
        }
        if out.len() < self.count() {
            self.add_absent(s, out);
        }
    }

    /// The part of the groove's area that was open before the layers of a stage, linear between stations.
    fn open(&self, stage: usize, s: f64) -> f64 {
        let open = &self.stages[stage].open;
        let (before, after, part) = self.around(s);
        open[before] + (open[after] - open[before]) * part
    }

    /// The stations around path length `s`, and its part of the way between them.
    fn around(&self, s: f64) -> (usize, usize, f64) {
        let n = self.stations.len();
        let end = self.period.unwrap_or_else(|| self.stations[n - 1]);
        let s = if self.period.is_some() { s.rem_euclid(end) } else { s.clamp(0.0, end) };
        let before = self.stations.partition_point(|x| *x <= s).clamp(1, n) - 1;
        let after = if self.period.is_some() { (before + 1) % n } else { (before + 1).min(n - 1) };
        let width = if after > before { self.stations[after] } else { end } - self.stations[before];
        let part = if width > 0.0 { (s - self.stations[before]) / width } else { 0.0 };
        (before, after, part)
    }

    /// Adds absent layers, without area, on top of those below them: so the line of a pass continues smoothly beyond
    /// its end.
    fn add_absent(&self, s: f64, out: &mut Vec<BeadAt>) {
        let there = std::mem::replace(out, Vec::with_capacity(self.count()));
        let mut left = there.as_slice();
        for (k, layer) in self.layers.iter().enumerate() {
            // The next layer that is there: this one, or the one that lies where this one would.
            let next = &left[..left.first().map_or(0, |bead| self.layers[bead.layer].beads)];
            if self.is_there(k, s) {
                out.extend_from_slice(next);
                left = &left[next.len()..];
            } else {
                let like = |index: usize| next[(index * next.len() / layer.beads).min(next.len() - 1)];
                out.extend((0..layer.beads).map(|index| BeadAt { layer: k, index, area: 0.0, ..like(index) }));
            }
        }
    }

    /// True if layer `layer` is there at path length `s`.
    pub fn is_there(&self, layer: usize, s: f64) -> bool {
        let parts = &self.parts[layer];
        let s = self.period.map_or(s, |period| s.rem_euclid(period));
        let within = |(from, to): &(f64, f64)| {
            (*from..*to).contains(&s) || self.period.is_some_and(|period| (*from..*to).contains(&(s + period)))
        };
        parts.is_empty() || parts.iter().any(within)
    }

    /// Leaves out fill layers, the last first, where the beads would be nearer to their areas without.
    fn leave_out(&mut self, runs: &Runs, shortest: f64, to_fill: &[f64]) {
        // Fills follow each other between root and cap.
        let first = self.layers.iter().position(|l| l.role == Role::Fill).unwrap_or(self.layers.len());
        let fills = self.layers[first..].iter().take_while(|l| l.role == Role::Fill).count();
        // Shares were made for the largest area: without some layers the others' beads are larger by this.
        let whole = to_fill.iter().copied().fold(0.0, f64::max);
        let with = |mut sizes: Sizes, layer: &Layer| {
            sizes.add(layer.share, layer.share * whole / layer.beads as f64 / runs.of(layer.role).area);
            sizes
        };
        let below = self.layers[..first].iter().fold(Sizes::default(), with);
        let mut stacks = vec![below];
        for layer in &self.layers[first..first + fills] {
            stacks.push(with(stacks[stacks.len() - 1], layer));
        }
        // By the number of fills that are left out.
        let above = &self.layers[first + fills..];
        let stacks: Vec<Sizes> = stacks.into_iter().rev().map(|stack| above.iter().fold(stack, with)).collect();
        let off = |left: &usize, total: f64| stacks[*left].off(total / whole);
        let best = |total: &f64| (0..=fills).min_by(|a, b| off(a, *total).total_cmp(&off(b, *total))).unwrap_or(0);
        let left: Vec<usize> = to_fill.iter().map(best).collect();
        for rank in 0..fills {
            let there: Vec<bool> = left.iter().map(|left| *left <= rank).collect();
            self.parts[first + fills - 1 - rank] = self.runs_of(&there, shortest);
        }
        // Layers that are absent everywhere are removed.
        let layers = std::mem::take(&mut self.layers).into_iter().zip(std::mem::take(&mut self.parts));
        (self.layers, self.parts) = layers.filter(|(_, parts)| *parts != [(0.0, 0.0)]).unzip();
        let kept: f64 = self.layers.iter().map(|l| l.share).sum();
        self.layers.iter_mut().for_each(|l| l.share /= kept);
    }

    /// Pieces of the seam that a layer covers; empty if it covers the whole. Pieces that are too short are made longer,
    /// gaps that are too short are closed.
    fn runs_of(&self, there: &[bool], shortest: f64) -> Vec<(f64, f64)> {
        if there.iter().all(|t| *t) {
            return Vec::new();
        }
        if there.iter().all(|t| !*t) {
            return vec![(0.0, 0.0)];
        }
        let n = there.len();
        let step = self.stations.get(1).copied().unwrap_or(0.0);
        let end = self.period.unwrap_or_else(|| self.stations[n - 1]);
        // On a closed seam start at a gap, so that no piece goes over the start of the list.
        let begin = if self.period.is_some() { there.iter().position(|t| !*t).unwrap_or(0) } else { 0 };
        let at = |k: usize| self.stations[k % n] + if k >= n { end } else { 0.0 };
        let mut runs: Vec<(f64, f64)> = Vec::new();
        for k in begin..begin + n {
            if there[k % n] {
                let (from, to) = (at(k) - HALF * step, at(k) + HALF * step);
                match runs.last_mut().filter(|run| from - run.1 < shortest) {
                    Some(run) => run.1 = to,
                    None => runs.push((from, to)),
                }
            }
        }
        for run in &mut runs {
            let more = 0.5 * (shortest - (run.1 - run.0)).max(0.0);
            *run = (run.0 - more, run.1 + more);
            if self.period.is_none() {
                *run = (run.0.max(0.0), run.1.min(end));
            } else {
                let turns = end * (run.0 / end).floor();
                *run = (run.0 - turns, run.1 - turns);
            }
        }
        let whole = runs.iter().any(|run| run.1 - run.0 >= end);
        if whole { Vec::new() } else { runs }
    }
}
