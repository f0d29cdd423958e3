use seamwright_motion::{SetPoint, WeldMotion};
use seamwright_program::Program;

/// The process columns of a table with a row a set-point.
pub(super) struct ProcessColumns<'a> {
    program: &'a Program,
    motion: &'a WeldMotion,
    names: Vec<String>,
    /// The pass that is played, counted from 1, and when it began, s.
    begun: (usize, f64),
}

impl<'a> ProcessColumns<'a> {
    pub(super) fn new(program: &'a Program, motion: &'a WeldMotion) -> Self {
        let values = program.passes.iter().flat_map(|p| &p.spans).flat_map(|s| s.process.keys().cloned());
        let mut names: Vec<String> = values.collect();
        names.sort();
        names.dedup();
        Self { program, motion, names, begun: (0, 0.0) }
    }

    /// Names of the process values, in the order of their columns.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// The values at `set` in `pass` (0 in the air), for set-points in the order in which they are played: 0 while the arc
    /// is off.
    pub(super) fn values(&mut self, pass: usize, set: &SetPoint) -> impl Iterator<Item = f64> {
        if pass != self.begun.0 {
            self.begun = (pass, set.t);
        }
        let arc = pass.checked_sub(1).filter(|_| set.phase.arc());
        let now = arc.map(|i| (&self.program.passes[i], self.motion.passes[i].arc_clock(set.t - self.begun.1)));
        let value = move |name: &String| now.and_then(|(pass, clock)| pass.process_at(name, set.law.s, clock));
        self.names.iter().map(move |name| value(name).unwrap_or(0.0))
    }
}
