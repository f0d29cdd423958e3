//! Passes planned in their order.
//!
//! Each pass starts near the end of the one before, so their motions are planned one after another. The distances along a
//! motion take about as long as the motion itself: other threads compute them while the next passes are planned. The result
//! is the same with any number of threads.

use crate::cures::Trial;
use crate::effort::Effort;
use crate::pass_clearance::{PassClearance, pass_clearance};
use crate::pass_motion::{PassMotion, Request};
use crate::redundancy::{Clearance, holding};
use crate::weld_motion::{MetalByPass, PassEnd, TransferSettings, WeldMotion};
use seamwright_clearance::ClearanceError;
use seamwright_machine::{Joints, Machine, Surroundings};
use seamwright_message::Message;
use seamwright_program::{Finding, Pass, PathRange, Procedure, TorchPath};
use std::collections::VecDeque;
use std::sync::Arc;
use std::thread::{ScopedJoinHandle, available_parallelism, scope};

/// Additional distance beyond the minimum that redundant axes seek near obstacles, mm.
const WANTED_MM: f64 = 10.0;
/// Maximum number of passes whose distances are computed at once: those after one that is too near are planned in vain.
const MAX_AHEAD: usize = 4;

/// The passes of a weld and what they are planned with.
pub(crate) struct Order<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) passes: &'a [(&'a dyn TorchPath, &'a Pass)],
    pub(crate) procedure: Option<&'a Procedure>,
    pub(crate) effort: &'a Effort<'a>,
    pub(crate) retract_mm: f64,
    /// Ends of the passes for the transfer moves between them.
    pub(crate) ends: &'a [PassEnd<'a>],
}

/// Surroundings of the passes and of the way home, with the weld metal before each. Those of passes that are done are
/// forgotten: metal takes memory.
pub(crate) struct Obstacles<'a> {
    bare: Arc<Surroundings<'a>>,
    metal: Option<MetalByPass<'a>>,
    /// Index of the first that is kept.
    first: usize,
    kept: VecDeque<Arc<Surroundings<'a>>>,
}

impl<'a> Obstacles<'a> {
    pub(crate) fn new(around: &Surroundings<'a>, metal: Option<MetalByPass<'a>>) -> Self {
        // Without a scene there is nothing to collide with.
        let metal = metal.filter(|_| !around.is_empty());
        Self { bare: Arc::new(around.clone()), metal, first: 0, kept: VecDeque::new() }
    }

    /// Those of pass `i`, counted from 0, which is not forgotten.
    fn of(&mut self, i: usize) -> Result<Arc<Surroundings<'a>>, Vec<Finding>> {
        while self.first + self.kept.len() <= i {
            let metal = self.metal.as_mut().and_then(Iterator::next).unwrap_or_else(|| Ok(Vec::new()));
            let around = metal.and_then(|solids| match solids.is_empty() {
                true => Ok(Arc::clone(&self.bare)),
                false => self.bare.with_part(&solids).map(Arc::new),
            });
            self.kept.push_back(around.map_err(|error| vec![no_metal(&error)])?);
        }
        Ok(Arc::clone(&self.kept[i - self.first]))
    }

    fn forget_before(&mut self, i: usize) {
        while self.first < i && self.kept.pop_front().is_some() {
            self.first += 1;
        }
    }
}

fn no_metal(error: &ClearanceError) -> Finding {
    let cure = Message::new("motion-cure-clearance");
    Finding::error("clearance", error.message(), 1, PathRange::at(0.0), cure)
}

/// A pass with the distances along it.
struct Checked {
    motion: PassMotion,
    clearance: Option<PassClearance>,
    /// Findings against the clearance.
    findings: Vec<Finding>,
}

impl Checked {
    fn new(motion: PassMotion, around: &Surroundings, path: &dyn TorchPath, number: usize) -> Self {
        let (clearance, findings) = pass_clearance(around, &motion.path, path, number);
        Self { motion, clearance, findings }
    }
}

impl Order<'_> {
    /// Plans all passes and the transfer moves between them, up to the first pass that fails.
    ///
    /// Errors: the findings of that pass and those of the passes before.
    pub(crate) fn plan(&self, obstacles: &mut Obstacles<'_>) -> Result<WeldMotion, Vec<Finding>> {
        let ahead = available_parallelism().map_or(1, usize::from).min(MAX_AHEAD);
        let mut planned = WeldMotion::default();
        let mut of_transfers = Vec::new();
        scope(|scope| {
            let mut waiting: VecDeque<ScopedJoinHandle<Checked>> = VecDeque::new();
            let mut failed: Option<Vec<Finding>> = None;
            let mut last: Option<Joints> = None;
            while planned.passes.len() < self.passes.len() {
                let done = planned.passes.len();
                let next = done + waiting.len();
                if failed.is_none() && next < self.passes.len() && waiting.len() < ahead {
                    self.effort.begin_pass(next + 1, self.passes.len());
                    match PassMotion::of(self.machine, self.request(next, last.as_ref())) {
                        Ok(motion) => {
                            last = Some(end(&motion));
                            let (around, path) = (obstacles.of(next)?, self.passes[next].0);
                            waiting.push_back(scope.spawn(move || Checked::new(motion, &around, path, next + 1)));
                        }
                        Err(findings) => failed = Some(findings),
                    }
                    continue;
                }
                let Some(first) = waiting.pop_front() else {
                    return Err(with_earlier(failed.unwrap_or_default(), &planned));
                };
                let mut checked = first.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
                let around = obstacles.of(done)?;
                if !checked.findings.is_empty() {
                    // The passes after it are planned again, from where this one ends then.
                    waiting.clear();
                    failed = None;
                    let before = planned.passes.last().map(end);
                    checked = self
                        .avoiding(done, &around, before.as_ref(), checked)
                        .map_err(|findings| with_earlier(findings, &planned))?;
                    last = Some(end(&checked.motion));
                }
                planned.findings.extend(checked.motion.findings.iter().cloned());
                planned.passes.push(checked.motion);
                planned.clearance.push(checked.clearance);
                self.transfer(&mut planned, &mut of_transfers, done, &around)?;
                obstacles.forget_before(done + 1);
            }
            Ok::<(), Vec<Finding>>(())
        })?;
        let home = self.passes.len();
        let around = obstacles.of(home)?;
        self.transfer(&mut planned, &mut of_transfers, home, &around)?;
        planned.findings.append(&mut of_transfers);
        Ok(planned)
    }

    /// Adds the transfer move before pass `i`, counted from 0, or home; its findings go into `findings`.
    fn transfer(
        &self,
        planned: &mut WeldMotion,
        findings: &mut Vec<Finding>,
        i: usize,
        around: &Surroundings,
    ) -> Result<(), Vec<Finding>> {
        let settings =
            TransferSettings { machine: self.machine, around, retract_mm: self.retract_mm, effort: self.effort };
        planned.transfer_move(&settings, i, self.ends, findings);
        let length = i.checked_sub(1).map_or(0.0, |before| self.passes[before].0.length());
        self.effort.check(i.max(1), length)
    }

    /// The request of pass `i`, counted from 0, after one that ends at `last`.
    fn request<'r>(&'r self, i: usize, last: Option<&'r Joints>) -> Request<'r> {
        let (path, pass) = self.passes[i];
        Request {
            path,
            pass,
            number: i + 1,
            effort: self.effort,
            procedure: self.procedure,
            last,
            explains: true,
            weld: self.passes,
            clearance: None,
            is_quick: false,
        }
    }

    /// Pass `i` with redundant axes that avoid obstacles.
    ///
    /// Errors: without such a motion the findings of the one `found`, with cures.
    fn avoiding(
        &self,
        i: usize,
        around: &Surroundings,
        last: Option<&Joints>,
        found: Checked,
    ) -> Result<Checked, Vec<Finding>> {
        let (machine, request) = (self.machine, self.request(i, last));
        self.effort.begin_pass(i + 1, self.passes.len());
        if machine.is_redundant() && request.path.second(0.0).is_none() {
            let room = |q: &Joints| {
                let nearest = around.nearest(q, WANTED_MM + around.greatest_least_mm());
                nearest.map_or(f64::INFINITY, |(watch, e)| e.distance - around.scene().watches()[watch].least_mm())
            };
            let clearance = Some(Clearance { distance: &room, wanted_mm: WANTED_MM });
            if let Ok(motion) = PassMotion::of(machine, Request { clearance, ..request }) {
                let checked = Checked::new(motion, around, request.path, request.number);
                if checked.findings.is_empty() {
                    return Ok(checked);
                }
            }
        }
        let mut findings = found.findings;
        // A search that was cut off is a finding of its own: another motion may exist.
        if let Err(stopped) = self.effort.check(request.number, request.path.length()) {
            findings.extend(stopped);
        } else if let Ok(held) = holding(machine, &request.pass.spare_axes) {
            Trial { machine, held: &held, request }.cure_clearance(around, &mut findings);
        }
        let mut all = found.motion.findings;
        all.extend(findings);
        Err(all)
    }
}

/// Positions at the end of a pass.
fn end(motion: &PassMotion) -> Joints {
    motion.path.at(motion.path.length())
}

fn with_earlier(mut findings: Vec<Finding>, planned: &WeldMotion) -> Vec<Finding> {
    findings.extend(planned.findings.iter().cloned());
    findings
}
