//! Findings against a pass that need no machine.

use crate::PassPath;
use seamwright_program::{Finding, TorchPath, torch_jumps};

/// Number of stations checked along a pass.
const PLACES: u32 = 720;
/// Minimum progress of a bead, as a part of the way along the seam: beyond the centre of a bend it goes back.
const MIN_PROGRESS: f64 = 0.1;

impl PassPath<'_> {
    /// Everything that stands against the pass, the `number`-th from 1.
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
            let (part, sine) =
                if axis.dot(p.n1) < axis.dot(p.n2) { ("first", axis.dot(p.n1)) } else { ("second", axis.dot(p.n2)) };
            (sine <= 0.0).then(|| {
                format!(
                    "the torch would lie {:.1} degrees inside the face of the {part} part (dihedral angle {:.1} degrees)",
                    -sine.asin().to_degrees(),
                    p.dihedral.to_degrees()
                )
            })
        };
        self.stretches(("access", number), "make the work angle smaller than half the dihedral angle", complaint)
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
            let backwards = || {
                "the bead would (nearly) stand still or go back: it lies beyond the centre of the seam's bend, or its \
                 rows change too quickly"
                    .to_owned()
            };
            (progress < MIN_PROGRESS).then(backwards)
        };
        self.stretches(("turn", number), "lay the bead nearer to the seam there", complaint)
    }

    /// Stretches of neighbouring stations with a complaint, each a finding with the first one's.
    fn stretches(
        &self,
        (kind, pass): (&'static str, usize),
        cure: &str,
        complaint: impl Fn(f64) -> Option<String>,
    ) -> Vec<Finding> {
        let step = self.length() / f64::from(PLACES);
        let mut findings: Vec<Finding> = Vec::new();
        let mut open = false;
        for s in (0..=PLACES).map(|i| f64::from(i) * step) {
            let Some(message) = complaint(s) else {
                open = false;
                continue;
            };
            match findings.last_mut().filter(|_| open) {
                Some(last) => last.to_mm = s,
                None => findings.push(Finding {
                    kind,
                    message: message.into(),
                    pass,
                    from_mm: s,
                    to_mm: s,
                    cure: Some(cure.into()),
                    allowed: false,
                }),
            }
            open = true;
        }
        findings
    }
}
