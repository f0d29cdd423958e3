use crate::{LawPoint, SpeedLaw};

/// A stretch of a pass from rest to rest: all of it, or from one corner at which the torch stops to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Path length at which it begins and ends, mm.
    pub from: f64,
    /// See [`Leg::from`].
    pub to: f64,
    /// Path length where its run-up ends, mm.
    pub run_up_end: f64,
    /// Path length where its run-down begins, mm; where the run-up ends if the two meet.
    pub run_down_start: f64,
}

/// The legs of `law`, which rests at `stops`, increasing.
pub(crate) fn legs(law: &SpeedLaw, stops: &[f64], length: f64) -> Vec<Leg> {
    let ends: Vec<f64> = [0.0].iter().chain(stops).chain(&[length]).copied().collect();
    let at = |cell: usize, part: f64| -> LawPoint { law.in_cell(cell, part) };
    let rises = |cell: &usize| !law.cruises(*cell) && at(*cell, 1.0).v > at(*cell, 0.0).v;
    let falls = |cell: &usize| !law.cruises(*cell) && at(*cell, 1.0).v < at(*cell, 0.0).v;
    let mut first = 0;
    let leg = |w: &[f64]| {
        let count = (first..law.cells()).take_while(|cell| at(*cell, 0.5).s < w[1]).count();
        let cells = first..first + count;
        first = cells.end;
        let up = cells.clone().take_while(rises).count();
        let down = cells.clone().rev().take_while(falls).count();
        let border = |cell: usize| if cell < cells.end { at(cell, 0.0).s } else { w[1] };
        let run_up_end = border(cells.start + up);
        Leg { from: w[0], to: w[1], run_up_end, run_down_start: border(cells.end - down).max(run_up_end) }
    };
    ends.windows(2).map(leg).collect()
}
