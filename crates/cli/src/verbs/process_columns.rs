use seamwright_motion::{SetPoint, WeldMotion};
use seamwright_program::{ArcTime, Program};

/// The process columns of a table with a row a set-point.
pub(super) struct ProcessColumns<'a> {
    program: &'a Program,
    names: Vec<String>,
}

impl<'a> ProcessColumns<'a> {
    pub(super) fn new(program: &'a Program) -> Self {
        let values = program.passes.iter().flat_map(|p| &p.spans).flat_map(|s| s.process.keys().cloned());
        let mut names: Vec<String> = values.collect();
        names.sort();
        names.dedup();
        Self { program, names }
    }

    /// Names of the process values, in the order of their columns.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// The values at path length `s` (mm) in `pass` (0 in the air): 0 while the arc is off, without a clock.
    pub(super) fn values(&self, pass: usize, s: f64, clock: Option<ArcTime>) -> impl Iterator<Item = f64> {
        let now = pass.checked_sub(1).zip(clock).map(|(i, clock)| (&self.program.passes[i], clock));
        let value = move |name: &String| now.and_then(|(pass, clock)| pass.process_at(name, s, clock));
        self.names.iter().map(move |name| value(name).unwrap_or(0.0))
    }
}

/// The clock of the arc for set-points in the order in which they are played.
pub(super) struct ArcClock<'a> {
    motion: &'a WeldMotion,
    /// The pass that is played, counted from 1, and when it began, s.
    begun: (usize, f64),
}

impl<'a> ArcClock<'a> {
    pub(super) fn new(motion: &'a WeldMotion) -> Self {
        Self { motion, begun: (0, 0.0) }
    }

    /// At `set` in `pass` (0 in transfer moves); `None` while the arc is off.
    pub(super) fn at(&mut self, pass: usize, set: &SetPoint) -> Option<ArcTime> {
        if pass != self.begun.0 {
            self.begun = (pass, set.t);
        }
        let arc = pass.checked_sub(1).filter(|_| set.phase.arc());
        arc.map(|i| self.motion.passes[i].arc_clock(set.t - self.begun.1))
    }
}
