use super::deviation_cells::{BENT, CELLS, Cells, STRAIGHT};
use super::error::Error;
use super::estimate::{Estimate, Node, Sight};
use super::filter::{Filter, Noise};
use super::fit::{Fit, Seen};
use super::history::{History, Moment};
use super::measurement::{Measurement, Refusal, Verdict};
use super::outliers::{GATE, IN_A_ROW, Suspects, begun};
use super::own_curve::OwnCurve;
use super::ring::Ring;
use super::settings::{REACH, Settings};
use glam::DVec2;
use std::ops::Range;

/// Number of identical values in a row from a frozen sensor.
const FROZEN: u32 = 5;
/// Maximum half-width of the gate, mm; after a gap measurements must agree with each other.
const WIDEST_MM: f64 = 1.0;
/// Standard deviation of the seam's second derivative for extrapolation by a few millimetres, 1/mm.
const GENTLE: f64 = 0.01;
/// Minimum jump of the seam, mm; smaller steps are smoothed.
const JUMP_MM: f64 = 0.3;
/// Smoothing reach to each side, in cells.
const REACH_CELLS: i64 = (REACH * CELLS) as i64;

/// Estimates the seam's deviation from the taught path by path length, from a sensor ahead of the torch.
///
/// Call [`Self::advance`] every cycle with the positions of torch and slide, and [`Self::take`] for each measurement,
/// in any order. [`Self::at`] returns the deviation. Memory is bounded by the look-ahead distance; no call after
/// [`Self::new`] allocates.
#[derive(Debug, Clone)]
pub struct Tracker {
    settings: Settings,
    own: OwnCurve,
    history: History,
    cells: Cells,
    nodes: Ring<Node>,
    /// Next node to compute.
    cursor: Option<i64>,
    /// Index of the node at the torch.
    here: i64,
    filter: Option<Filter>,
    outliers: Suspects,
    anchor: Option<Anchor>,
    same: (DVec2, u32),
}

/// Extremes of the seam ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ahead {
    /// Maximum absolute deviation, lateral and height, mm.
    pub value: DVec2,
    /// Maximum absolute slope over path length.
    pub slope: DVec2,
}

/// Last measured position before the joint was lost.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    s: f64,
    fit: Fit,
    /// First node extrapolated from it.
    first: i64,
}

impl Tracker {
    /// Creates a tracker of the seam described by `own`.
    ///
    /// # Errors
    /// Those of [`Settings::check`].
    pub fn new(settings: Settings, own: OwnCurve) -> Result<Self, Error> {
        settings.check()?;
        let cells = Cells::new(settings.lead_mm);
        Ok(Self {
            own,
            history: History::new((settings.age_s[1] / settings.cycle_s).ceil() as usize + 2),
            nodes: Ring::new(cells.len() as usize),
            cells,
            cursor: None,
            here: 0,
            filter: None,
            outliers: Suspects::default(),
            anchor: None,
            same: (DVec2::NAN, 0),
            settings,
        })
    }

    /// Returns the settings.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Runs one cycle with the current positions; callers may ask for deviations up to `until_mm`.
    pub fn advance(&mut self, now: Moment, until_mm: f64) {
        self.advance_from(now, now.s_mm, until_mm);
    }

    /// Runs one cycle of a torch whose set-point is ahead of it, at `set_mm`.
    pub(crate) fn advance_from(&mut self, now: Moment, set_mm: f64, until_mm: f64) {
        self.history.push(now);
        let (here, until) = (self.cells.index(set_mm), self.cells.index(until_mm) + 1);
        self.here = here;
        // Nodes behind the torch are computed only after new measurements there.
        let cursor = self.cursor.map_or(here, |cursor| cursor.max(here - self.nodes.len() / 2));
        // One node per cycle keeps cycles short; at 1 ms and 20 mm look-ahead this suffices up to 300 mm/s.
        let node = self.node(cursor, cursor <= until);
        if let Some(node) = node {
            self.nodes.put(cursor, node);
        }
        self.cursor = Some(cursor + i64::from(node.is_some()));
    }

    /// Processes a measurement that arrived at time `now_s`.
    pub fn take(&mut self, measured: &Measurement, now_s: f64) -> Verdict {
        match self.located(measured, now_s) {
            Ok(seen) => self.accept(seen, measured.exposed_s),
            Err(refusal) => Verdict::Refused(refusal),
        }
    }

    /// Returns the positions at `t_s`; `None` outside the stored time range.
    pub(crate) fn moment(&self, t_s: f64) -> Option<Moment> {
        self.history.at(t_s)
    }

    /// Adds a deviation at `s` with this confidence, from a picture exposed at `exposed_s`. The caller has already
    /// judged the picture as a whole.
    pub(crate) fn see(&mut self, s: f64, deviation: DVec2, confidence: f64, exposed_s: f64) {
        let weight = (confidence / self.settings.noise_mm).powi(2);
        self.keep(Seen { s, value: deviation, weight }, exposed_s);
    }

    /// Removes the measurements from `s` on and records a seam jump there.
    pub(crate) fn forget_from(&mut self, s: f64) {
        self.cells.clear_from(s);
        self.cells.add_break(s);
    }

    /// Compares a measurement with the prediction.
    fn accept(&mut self, seen: Seen, t: f64) -> Verdict {
        let noise = Noise { wander: self.settings.wander, drift: self.settings.drift };
        let r = 1.0 / seen.weight;
        // Checked first: gating increases the variance, and soon the gate would let a jump pass.
        if let Some(three) = self.outliers.agreeing(&seen) {
            self.outliers.clear();
            self.begin_with(&three);
            self.filter = Some(begun(&three, t));
            for seen in three {
                self.keep(seen, t);
            }
            return Verdict::Restarted;
        }
        if let Some(expected) = self.filter.map(|f| f.predicted(seen.s, t, &noise))
            && expected.surprise(seen.value, r) <= GATE
            && GATE * expected.variance[0].sqrt() <= WIDEST_MM
        {
            self.outliers.clear();
            self.filter = Some(expected.updated(seen.value, r));
            // Far from the prediction it counts less: it may be an outlier, and the last one before the joint is lost.
            let off = (seen.value - expected.value).abs().max_element();
            self.keep(Seen { weight: seen.weight.min((GATE / off).powi(2)), ..seen }, t);
            return Verdict::Taken;
        }
        // After several gated measurements the prediction is discarded, because a widening gate would accept outliers.
        // From here on measurements must agree with each other.
        if self.outliers.add(seen) >= IN_A_ROW {
            self.filter = None;
        }
        Verdict::Gated
    }

    /// Returns the deviation at path length `s_mm`.
    #[must_use]
    pub fn at(&self, s_mm: f64) -> Estimate {
        let i = self.cells.index(s_mm);
        let part = s_mm / self.cells.cell_mm - i as f64;
        match (self.nodes.get(i), self.nodes.get(i + 1)) {
            (Some(a), Some(b)) => a.between(b, self.cells.cell_mm, part),
            (Some(one), None) | (None, Some(one)) => one.estimate(),
            (None, None) => Node::UNSEEN.estimate(),
        }
    }

    /// Returns the maximum absolute deviation and slope, per direction, between `s_mm` and the sensor.
    #[must_use]
    pub fn ahead(&self, s_mm: f64) -> Ahead {
        let from = self.cells.index(s_mm);
        let nodes = (from..from + CELLS as i64).filter_map(|i| self.nodes.get(i));
        nodes.fold(Ahead { value: DVec2::ZERO, slope: DVec2::ZERO }, |most, node| Ahead {
            value: most.value.max(node.value.abs()),
            slope: most.slope.max(node.slope.abs()),
        })
    }

    /// Returns position and deviation of a measurement, or the reason for rejecting it.
    fn located(&mut self, measured: &Measurement, now_s: f64) -> Result<Seen, Refusal> {
        let Measurement { exposed_s, offset, confidence } = *measured;
        if !(0.0..=1.0).contains(&confidence) {
            return Err(Refusal::Confidence);
        }
        if !offset.is_finite() || offset.abs().cmpgt(self.settings.field_mm).any() {
            return Err(Refusal::OutOfField);
        }
        self.same = if offset == self.same.0 { (offset, self.same.1 + 1) } else { (offset, 1) };
        if self.same.1 >= FROZEN {
            return Err(Refusal::Frozen);
        }
        let [young, old] = self.settings.age_s;
        let age = now_s - exposed_s;
        // Half a cycle, because times are those of cycles.
        let slack = 0.5 * self.settings.cycle_s;
        if age > old + slack {
            return Err(Refusal::Late);
        }
        if age.is_nan() || age < young - slack {
            return Err(Refusal::Clock);
        }
        if confidence < self.settings.least_confidence.max(f64::MIN_POSITIVE) {
            return Err(Refusal::Faint);
        }
        let then = self.history.at(exposed_s).ok_or(Refusal::Clock)?;
        let view = self.own.at(then.s_mm);
        let value = view.to_seam * (offset + then.slide - view.offset);
        let weight = (confidence / self.settings.noise_mm).powi(2);
        Ok(Seen { s: view.place_mm, value, weight })
    }

    fn keep(&mut self, seen: Seen, t: f64) {
        self.cells.add(seen, t, self.settings.drift);
        let mut from = self.cursor;
        // Recomputes extrapolated nodes and the nodes near the new measurement.
        if let Some(anchor) = self.anchor.take() {
            from = from.map(|cursor| cursor.min(anchor.first.max(self.here)));
        }
        let near = self.cells.index(seen.s) - REACH_CELLS;
        self.cursor = from.map(|cursor| cursor.min(near));
    }

    /// Restarts the estimate with three agreeing measurements: the seam jumps there, or an outlier had distorted the
    /// prediction.
    fn begin_with(&mut self, three: &[Seen; IN_A_ROW]) {
        let Some(front) = self.cells.front() else { return };
        let Seen { s, value, .. } = three[0];
        if s < front - 0.5 * self.cells.cell_mm {
            // The seam was measured there before and has moved since.
            self.cells.clear();
        } else if s - front < REACH * self.settings.lead_mm {
            let end = self.cells.index(front) + 1;
            let jumps = |cells: Range<i64>, bend: f64| {
                self.cells.fit(s, cells, bend).is_none_or(|fit| fit.value.distance(value) > JUMP_MM)
            };
            match (jumps(end - REACH_CELLS..end, BENT), jumps(end - 2 * REACH_CELLS..end - 1, GENTLE)) {
                (true, true) => self.cells.add_break(0.5 * (s + front)),
                // The last accepted measurement was an outlier: without it there is no jump.
                (true, false) => self.cells.clear_from(front),
                (false, _) => {}
            }
        }
    }

    fn node(&mut self, i: i64, urgent: bool) -> Option<Node> {
        if let Some(local) = self.cells.local(i, REACH_CELLS, urgent) {
            let sight = if local.bridged { Sight::Bridged } else { Sight::Seen };
            let Fit { value, slope, variance } = local.fit;
            return Some(Node { value, slope, variance, sight });
        }
        urgent.then(|| self.coasted(i))
    }

    /// Extrapolates beyond the last measurement.
    fn coasted(&mut self, i: i64) -> Node {
        let Some(anchor) = self.anchor.or_else(|| self.anchored(i)) else { return Node::UNSEEN };
        self.anchor = Some(anchor);
        let Settings { decay_mm, fade_mm, wander, .. } = self.settings;
        let way = (i as f64 * self.cells.cell_mm - anchor.s).max(0.0);
        let left = (-way / decay_mm).exp();
        let value = anchor.fit.value + anchor.fit.slope * decay_mm * (1.0 - left);
        let slope = anchor.fit.slope * left;
        let variance = anchor.fit.variance + wander * way.powi(3) / 3.0;
        let faded = (way - self.settings.coast_mm()) / fade_mm;
        if faded <= 0.0 {
            return Node { value, slope, variance, sight: Sight::Coasted };
        }
        let (faded, sight) = if faded < 1.0 { (faded, Sight::Fading) } else { (1.0, Sight::Lost) };
        let keep = 1.0 - faded * faded * (3.0 - 2.0 * faded);
        let falls = 6.0 * faded * (1.0 - faded) / fade_mm;
        Node { value: keep * value, slope: keep * slope - falls * value, variance, sight }
    }

    /// Fits value and slope at the last measurement; the slope is that over half a look-ahead distance.
    fn anchored(&self, first: i64) -> Option<Anchor> {
        let s = self.cells.front()?;
        let end = self.cells.index(s) + 1;
        let near = self.cells.fit(s, end - REACH_CELLS..end, BENT)?;
        let far = self.cells.fit(s, end - 2 * REACH_CELLS..end, STRAIGHT)?;
        Some(Anchor { s, fit: Fit { slope: far.slope, ..near }, first })
    }
}
