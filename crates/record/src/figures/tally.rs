use super::{BIN_MM, Basis, Curve, Figures, HEAT_INPUT, Judged, Value};
use crate::trace::Trace;
use std::collections::BTreeMap;

/// A value outside by less than this part of the window's larger limit (or of 1, if that is more) is on the limit.
const ROUNDING: f64 = 1e-6;
/// Maximum number of bins of a pass: 20 km of it.
const MAX_BINS: f64 = 1e7;
/// Columns that every trace has, first.
const ALWAYS: [&str; 4] = ["t_s", "pass", "s_mm", "arc"];

/// Energy and way in a bin.
#[derive(Debug, Clone, Copy, Default)]
struct Heat {
    joule: f64,
    way: f64,
    time: f64,
    /// The torch rested or ramped here, which is no steady travel.
    unsteady: bool,
}

/// Data of a pass bin by bin.
#[derive(Debug, Clone, Default)]
struct Pass {
    heat: Vec<Heat>,
    /// Of each column of deviations, position and value of the maximum in each bin.
    deviations: Vec<Vec<(f64, f64)>>,
    /// Indices in the list of values.
    judged: Vec<usize>,
}

#[derive(Debug, Clone)]
struct Gathered {
    judged: Judged,
    /// Its index in a row; `None` for the heat input.
    column: Option<usize>,
    least: f64,
    greatest: f64,
    sum: f64,
    weight: f64,
    outside_s: f64,
    outside_mm: f64,
    outside_along: Option<(f64, f64)>,
}

/// For how long (s), over how much way (mm) and with which weight a value held, and from where to where (mm).
#[derive(Debug, Clone, Copy)]
struct Span {
    time: f64,
    way: f64,
    weight: f64,
    along: (f64, f64),
}

impl Gathered {
    fn new(judged: Judged, column: Option<usize>) -> Self {
        let (least, greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        Self {
            judged,
            column,
            least,
            greatest,
            sum: 0.0,
            weight: 0.0,
            outside_s: 0.0,
            outside_mm: 0.0,
            outside_along: None,
        }
    }

    fn add(&mut self, value: f64, span: Span) {
        if !value.is_finite() {
            return;
        }
        self.least = self.least.min(value);
        self.greatest = self.greatest.max(value);
        self.sum += value * span.weight;
        self.weight += span.weight;
        if self.is_outside(value) {
            self.outside_s += span.time;
            self.outside_mm += span.way;
            let (from, to) = self.outside_along.unwrap_or(span.along);
            self.outside_along = Some((from.min(span.along.0), to.max(span.along.1)));
        }
    }

    /// Returns true for a value outside its window by more than rounding.
    fn is_outside(&self, value: f64) -> bool {
        let Some((least, greatest)) = self.judged.allowed else { return false };
        let rounding = ROUNDING * least.abs().max(greatest.abs()).max(1.0);
        value < least - rounding || value > greatest + rounding
    }

    fn counts(&self, from: f64, to: f64) -> bool {
        self.judged.along.is_empty() || self.judged.along.iter().any(|(a, b)| from >= *a && to <= *b)
    }
}

/// Gathers the figures row by row.
pub(super) struct Tally {
    columns: Vec<String>,
    /// Index of the column of the tip's position.
    tip: usize,
    /// Index of the column for steady travel, if there is one.
    steady: Option<usize>,
    /// Indices and scales of the columns whose product is the power.
    power: Vec<(usize, f64)>,
    efficiency: f64,
    /// Indices of the columns of deviations.
    deviations: Vec<usize>,
    passes: BTreeMap<u32, Pass>,
    values: Vec<Gathered>,
    /// The row before.
    last: Option<Vec<f64>>,
    figures: Figures,
}

impl Tally {
    pub(super) fn new(trace: &Trace, basis: &Basis) -> Self {
        let there = |name: &str| trace.columns().iter().any(|c| c.name == name);
        let mut columns: Vec<String> = ALWAYS.map(str::to_owned).into();
        let mut place = |name: &str| {
            columns.iter().position(|c| c == name).unwrap_or_else(|| {
                columns.push(name.to_owned());
                columns.len() - 1
            })
        };
        let tip = place(if there("tip_s_mm") { "tip_s_mm" } else { "s_mm" });
        let steady = there("steady").then(|| place("steady"));
        let known = basis.power.as_ref().filter(|power| power.factors.iter().all(|(name, _)| there(name)));
        let power = known.map_or(Vec::new(), |p| p.factors.iter().map(|(name, by)| (place(name), *by)).collect());
        let names = trace.columns().iter().map(|c| c.name.as_str());
        let of_seam = |name: &&str| {
            *name == "path_error_mm" || name.starts_with("miss_lateral_mm") || name.starts_with("miss_height_mm")
        };
        let deviations = names.filter(of_seam).map(&mut place).collect();
        let judged = basis.judged.iter().filter(|j| j.name == HEAT_INPUT || there(&j.name));
        let values: Vec<Gathered> = judged
            .map(|judged| Gathered::new(judged.clone(), (judged.name != HEAT_INPUT).then(|| place(&judged.name))))
            .collect();
        let mut passes: BTreeMap<u32, Pass> = BTreeMap::new();
        for (i, value) in values.iter().enumerate() {
            passes.entry(value.judged.pass).or_default().judged.push(i);
        }
        let efficiency = known.map_or(0.0, |p| p.efficiency);
        let (last, figures) = (None, Figures::default());
        Self { columns, tip, steady, power, efficiency, deviations, passes, values, last, figures }
    }

    pub(super) fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Adds a row: the one before holds until it.
    pub(super) fn row(&mut self, row: &[f64]) {
        if let Some(last) = self.last.take() {
            let same = row[1].to_bits() == last[1].to_bits();
            let way = if same { row[self.tip] - last[self.tip] } else { 0.0 };
            self.hold(&last, (row[0] - last[0]).max(0.0), if way.is_finite() { way } else { 0.0 });
            let mut last = last;
            last.copy_from_slice(row);
            self.last = Some(last);
        } else {
            self.last = Some(row.to_vec());
        }
        self.figures.last_s = row[0];
    }

    /// The values of `row` for a time (s) over a way (mm).
    fn hold(&mut self, row: &[f64], time: f64, way: f64) {
        let (number, s, arc) = (row[1], row[2], row[3] > 0.5);
        if number < 1.0 || !arc || !s.is_finite() {
            return;
        }
        self.figures.arc_on_s += time;
        let steady = self.steady.is_none_or(|place| row[place] > 0.5);
        let pass = self.passes.entry(number as u32).or_default();
        let bin = (s / BIN_MM).clamp(0.0, MAX_BINS) as usize;
        if !self.power.is_empty() {
            grow(&mut pass.heat, bin, Heat::default());
            let heat = &mut pass.heat[bin];
            heat.joule += time * self.power.iter().map(|(place, by)| row[*place] * by).product::<f64>();
            heat.way += way;
            heat.time += time;
            heat.unsteady |= !steady;
        }
        pass.deviations.resize(self.deviations.len(), Vec::new());
        for (bins, place) in pass.deviations.iter_mut().zip(&self.deviations) {
            grow(bins, bin, (s, f64::NAN));
            let value = row[*place];
            let known = bins[bin].1;
            if value.is_finite() && (known.is_nan() || value.abs() > known.abs()) {
                bins[bin] = (s, value);
            }
            if self.columns[*place] == "path_error_mm" && self.figures.worst_deviation_mm.is_none_or(|(w, _)| value > w)
            {
                self.figures.worst_deviation_mm =
                    value.is_finite().then_some((value, s)).or(self.figures.worst_deviation_mm);
            }
        }
        for i in &pass.judged {
            let value = &mut self.values[*i];
            if let Some(column) = value.column
                && steady
                && value.counts(s, s)
            {
                value.add(row[column], Span { time, way, weight: time, along: (s, s + way.max(0.0)) });
            }
        }
    }

    pub(super) fn finish(mut self) -> Figures {
        let whole = Judged { pass: 0, name: String::new(), allowed: None, along: Vec::new() };
        let mut all = Gathered::new(whole, None);
        for (number, pass) in &self.passes {
            let of_pass = pass.judged.iter().copied().find(|i| self.values[*i].column.is_none());
            let mut curve = Vec::new();
            for (i, heat) in pass.heat.iter().enumerate().filter(|(_, heat)| heat.way >= 0.5 * BIN_MM) {
                let (from, to) = (i as f64 * BIN_MM, (i + 1) as f64 * BIN_MM);
                let value = self.efficiency * heat.joule / heat.way / 1000.0;
                curve.push((0.5 * (from + to), value));
                let counts = !heat.unsteady && of_pass.is_none_or(|i| self.values[i].counts(from, to));
                if counts {
                    let span = Span { time: heat.time, way: heat.way, weight: heat.way, along: (from, to) };
                    all.add(value, span);
                    of_pass.into_iter().for_each(|i| self.values[i].add(value, span));
                }
            }
            if !curve.is_empty() {
                self.figures.heat_input.push(Curve { pass: *number, name: HEAT_INPUT.to_owned(), points: curve });
            }
            for (points, place) in pass.deviations.iter().zip(&self.deviations) {
                let points: Vec<_> = points.iter().copied().filter(|p| p.1.is_finite()).collect();
                if !points.is_empty() {
                    let name = self.columns[*place].clone();
                    self.figures.deviations.push(Curve { pass: *number, name, points });
                }
            }
        }
        if all.weight > 0.0 {
            self.figures.heat_input_kj_mm = Some([all.least, all.sum / all.weight, all.greatest]);
        }
        let found = self.values.into_iter().filter(|v| v.weight > 0.0);
        self.figures.values = found
            .map(|v| Value {
                pass: v.judged.pass,
                name: v.judged.name,
                least: v.least,
                mean: v.sum / v.weight,
                greatest: v.greatest,
                allowed: v.judged.allowed,
                outside_s: v.outside_s,
                outside_mm: v.outside_mm,
                outside_along: v.outside_along,
            })
            .collect();
        self.figures
    }
}

fn grow<T: Clone>(bins: &mut Vec<T>, bin: usize, empty: T) {
    if bins.len() <= bin {
        bins.resize(bin + 1, empty);
    }
}
