//! Findings against a pass that need no machine.

use crate::pass_path::PassPath;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange, TorchPath, torch_jumps};

/// Number of stations checked along a pass, or along each turn of one that goes round several times.
const PLACES: u32 = 720;
/// Minimum progress of a bead, as a part of the way along the seam: beyond the centre of a bend it goes back.
const MIN_PROGRESS: f64 = 0.1;

impl PassPath<'_> {
    /// All findings against the pass, the `number`-th from 1.
    pub fn findings(&self, number: usize) -> Vec<Finding> {
        let mut findings = self.access_findings(number);
        let turns = torch_jumps(self, number);
        // A jump of the tip may go back, so it is not reported twice.
        if turns.is_empty() {
            findings.extend(self.progress_findings(number));
        }
        findings.extend(turns);
        findings
    }

    /// Reports stretches on which the torch would lie in one of the two faces.
    fn access_findings(&self, number: usize) -> Vec<Finding> {
        let complaint = |s: f64| {
            let p = self.seam_point(s);
            let (_, axis) = self.torch_at(&p);
            let [first, second] = self.groove(s)?.off_faces(self.placement.transform_vector3(axis));
            let (code, sine) = if first < second {
                ("weld-torch-inside-first-face", first)
            } else {
                ("weld-torch-inside-second-face", second)
            };
            (sine <= 0.0).then(|| {
                let message = Message::new(code).quantity("angle", -sine.asin().to_degrees(), Unit::Deg, 1);
                message.quantity("dihedral", p.dihedral.to_degrees(), Unit::Deg, 1)
            })
        };
        self.stretches("access", number, "weld-cure-smaller-work-angle", complaint)
    }

    /// Reports stretches on which the bead would not progress along the seam.
    fn progress_findings(&self, number: usize) -> Vec<Finding> {
        if self.bead.is_none() {
            return Vec::new();
        }
        let tip = |s: f64| self.torch_at(&self.seam_point(s)).0;
        let complaint = |s: f64| {
            let h = 1e-3_f64.min(0.25 * self.length());
            let (behind, ahead) = ((s - h).max(0.0), (s + h).min(self.length()));
            let way = (tip(ahead) - tip(behind)) / (ahead - behind);
            let progress = way.dot(self.stretch.sense * self.seam_point(s).tangent);
            (progress < MIN_PROGRESS).then(|| Message::new("weld-bead-goes-back"))
        };
        self.stretches("turn", number, "weld-cure-bead-nearer", complaint)
    }

    /// Stretches of neighbouring stations with a complaint, each a finding with the first one's.
    fn stretches(
        &self,
        kind: &'static str,
        pass: usize,
        cure: &'static str,
        complaint: impl Fn(f64) -> Option<Message>,
    ) -> Vec<Finding> {
        let turns = (self.length() / self.seam.length()).floor().max(1.0);
        let count = PLACES * turns as u32;
        let step = self.length() / f64::from(count);
        let mut findings: Vec<Finding> = Vec::new();
        let mut open = false;
        for s in (0..=count).map(|i| f64::from(i) * step) {
            let Some(message) = complaint(s) else {
                open = false;
                continue;
            };
            match findings.last_mut().filter(|_| open) {
                Some(last) => last.to_mm = s,
                None => findings.push(Finding::error(kind, message, pass, PathRange::at(s), Message::new(cure))),
            }
            open = true;
        }
        findings
    }
}
