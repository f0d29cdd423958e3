//! Cycles of a cell that rests, of which few cross to the panel.

use seamwright_executive::realtime::Shown;
use seamwright_executive::{Mode, ProcessState};

/// Of the cycles at rest with the process off only one in this number crosses to the panel: they differ in their time
/// alone.
const AT_REST: u32 = 10;

/// Thins out the cycles of a cell that rests.
#[derive(Default)]
pub(crate) struct Resting {
    /// Cycles since the last one that was passed on, and what of them must not be lost.
    held: u32,
    missed: u32,
    late_ns: u64,
    late: bool,
    mode: Option<Mode>,
}

impl Resting {
    /// Returns the cycle to be passed on, with the missed cycles and the maximum lateness of those before it.
    pub(crate) fn pass(&mut self, mut shown: Shown) -> Option<Shown> {
        let process = &shown.orders.process;
        let is_off = shown.process == ProcessState::Off && !process.on && !process.gas;
        let rests = is_off && !shown.mode.moves() && shown.phase.is_none() && shown.orders.rests();
        let same = self.mode == Some(shown.mode) && shown.mode != Mode::Hold;
        self.missed = self.missed.saturating_add(shown.reports.missed);
        self.late_ns = self.late_ns.max(shown.reports.late_ns);
        self.late |= shown.reports.late;
        self.held += 1;
        if rests && same && self.held < AT_REST {
            return None;
        }
        (shown.reports.missed, shown.reports.late_ns, shown.reports.late) = (self.missed, self.late_ns, self.late);
        *self = Self { mode: Some(shown.mode), ..Self::default() };
        Some(shown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_executive::{Orders, Place, Reports, Status};

    fn shown(cycle: u64, mode: Mode) -> Shown {
        let status = Status {
            t: cycle as f64 * 1e-3,
            mode,
            place: Place::default(),
            phase: None,
            speed: 0.0,
            steady: false,
            welded_mm: 0.0,
            process: ProcessState::Off,
            armed: false,
            feed_override: 1.0,
            tracked: [None; 2],
        };
        let reports = Reports { missed: (cycle % 3) as u32, late_ns: cycle * 7 % 100, ..Reports::default() };
        Shown { status, orders: Orders::default(), reports, cycle, lost: 0 }
    }

    /// Thinned cycles lose neither missed cycles nor the maximum lateness, and every change of mode crosses at once.
    #[test]
    fn cycles_at_rest_are_thinned_and_nothing_is_lost() {
        let mut resting = Resting::default();
        let cycles: Vec<Shown> = (1..=1000).map(|i| shown(i, if i < 500 { Mode::Ready } else { Mode::Idle })).collect();
        let crossed: Vec<Shown> = cycles.iter().filter_map(|cycle| resting.pass(*cycle)).collect();
        assert!((100..105).contains(&crossed.len()), "{}", crossed.len());
        let missed = |of: &[Shown]| of.iter().map(|shown| shown.reports.missed).sum::<u32>() + resting.missed;
        assert_eq!(missed(&crossed), missed(&cycles) - resting.missed);
        let most = |of: &[Shown]| of.iter().map(|shown| shown.reports.late_ns).max();
        assert_eq!(most(&crossed), most(&cycles));
        assert!(crossed.iter().any(|shown| shown.cycle == 500), "the change of mode");
    }

    #[test]
    fn cycles_of_motion_hold_and_process_all_cross() {
        let mut resting = Resting::default();
        for mode in [Mode::Weld, Mode::DryRun, Mode::Jog, Mode::Hold] {
            assert!((1..100).all(|i| resting.pass(shown(i, mode)).is_some()), "{mode:?}");
        }
        let mut gas = shown(1, Mode::Ready);
        gas.orders.process.gas = true;
        assert!((0..100).all(|_| resting.pass(gas).is_some()));
        let mut moves = shown(1, Mode::Ready);
        moves.orders.set[0].velocity = 1.0;
        assert!((0..100).all(|_| resting.pass(moves).is_some()));
    }
}
