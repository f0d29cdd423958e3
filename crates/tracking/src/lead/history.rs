use glam::DVec2;
use std::collections::VecDeque;

/// Position of the torch and its slide at one cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Time on the cell's clock, s.
    pub t_s: f64,
    /// Path length of the torch, mm.
    pub s_mm: f64,
    /// Actual offset of the slide or axes that carry the sensor, lateral and height, mm.
    pub slide: DVec2,
}

/// Positions of the torch and its slide in the last cycles, to match a late measurement with the position of its
/// exposure. Memory is allocated once.
#[derive(Debug, Clone)]
pub(crate) struct History {
    moments: VecDeque<Moment>,
    capacity: usize,
}

impl History {
    /// Creates a history of the last `capacity` cycles, at least two.
    pub(crate) fn new(capacity: usize) -> Self {
        let capacity = capacity.max(2);
        Self { moments: VecDeque::with_capacity(capacity), capacity }
    }

    /// Adds a cycle; ignores one that is not later than the last.
    pub(crate) fn push(&mut self, moment: Moment) {
        if self.moments.back().is_some_and(|last| moment.t_s <= last.t_s) {
            return;
        }
        if self.moments.len() == self.capacity {
            self.moments.pop_front();
        }
        self.moments.push_back(moment);
    }

    /// Interpolates linearly at `t_s`; `None` outside the stored time range.
    pub(crate) fn at(&self, t_s: f64) -> Option<Moment> {
        let after = self.moments.partition_point(|m| m.t_s < t_s);
        let b = self.moments.get(after)?;
        let a = match after.checked_sub(1) {
            Some(before) => &self.moments[before],
            None if b.t_s <= t_s => b,
            None => return None,
        };
        let part = if b.t_s > a.t_s { (t_s - a.t_s) / (b.t_s - a.t_s) } else { 0.0 };
        let s_mm = a.s_mm + part * (b.s_mm - a.s_mm);
        Some(Moment { t_s, s_mm, slide: a.slide.lerp(b.slide, part) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(t: f64) -> Moment {
        Moment { t_s: t, s_mm: 20.0 * t + 3.0, slide: DVec2::new(2.0 - t, 0.5 * t) }
    }

    #[test]
    fn between_cycles_it_is_linear_and_elsewhere_unknown() {
        let mut history = History::new(50);
        assert!(history.at(0.0).is_none());
        for i in 0..200 {
            history.push(moment(0.01 * f64::from(i)));
        }
        for i in 0..1000 {
            let t = 1.5 + 0.49 * f64::from(i) / 999.0;
            let found = history.at(t).unwrap();
            assert!((found.s_mm - moment(t).s_mm).abs() < 1e-12);
            assert!(found.slide.distance(moment(t).slide) < 1e-12);
        }
        assert!(history.at(1.4899).is_none() && history.at(1.9901).is_none());
        assert!(history.at(1.99).is_some());
    }

    #[test]
    fn time_does_not_run_back() {
        let mut history = History::new(4);
        for t in [0.0, 1.0, 0.5, 1.0, 2.0] {
            history.push(moment(t));
        }
        assert!((history.at(0.75).unwrap().s_mm - moment(0.75).s_mm).abs() < 1e-12);
        assert!((history.at(1.5).unwrap().s_mm - moment(1.5).s_mm).abs() < 1e-12);
    }
}
