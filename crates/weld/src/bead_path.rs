use crate::bead_line::{BeadLine, BesideSeam};
use crate::pass_keys::PassKeys;
use crate::seam::SeamCurve;
use crate::stretch::Stretch;
use seamwright_document::{Document, DocumentError};
use seamwright_program::{Keyed, Pass, PathRange, StepOver};

/// Line of a pass beside the seam: that of its bead, or those of several beads with step-overs between them.
///
/// Outside the step-overs it is the line of a bead itself. In a step-over it goes from one line to the next by
/// [`StepOver::part`], twice continuously differentiable.
#[derive(Debug, Clone, PartialEq)]
pub struct BeadPath {
    lines: Vec<BeadLine>,
    step_overs: Vec<StepOver>,
}

impl BeadPath {
    /// The line of `pass` over `stretch` of `seam`, `None` if it runs on the seam; `keys` are those of its values in `file`.
    ///
    /// # Errors
    /// With the key's address: rows beside the weld, or rows that do not reach over the pass.
    pub fn new<T>(
        file: &Document<T>,
        keys: &PassKeys,
        pass: &Pass,
        seam: &SeamCurve,
        stretch: &Stretch,
    ) -> Result<Option<Self>, DocumentError> {
        let line = |(i, (bead, _)): (usize, (_, PathRange))| {
            let key = i.checked_sub(1).map_or("bead".to_owned(), |step| format!("step_overs[{step}].bead"));
            BeadLine::new(file, keys, Keyed { key: &key, value: bead }, seam, stretch)
        };
        let lines: Vec<BeadLine> = pass.beads().enumerate().map(line).collect::<Result<_, _>>()?;
        Ok((!lines.is_empty()).then(|| Self { lines, step_overs: pass.step_overs.clone() }))
    }

    /// The torch at the pass' own path length `own` and path length `s` on the seam.
    pub fn at(&self, own: f64, s: f64) -> BesideSeam {
        // The bead is that after the last step-over whose start lies behind.
        let begun = self.step_overs.partition_point(|step| step.range().from_mm < own);
        let Some(step) = begun.checked_sub(1) else { return self.lines[0].at(s) };
        let (part, _) = self.step_overs[step].part(own);
        // Not blended where it would change nothing: the line is that of the bead to the last digit.
        if part >= 1.0 {
            self.lines[begun].at(s)
        } else {
            self.lines[step].at(s).towards(&self.lines[begun].at(s), part)
        }
    }

    /// Path lengths on the seam inside `stretch` where third derivatives may jump, mm: rows of the beads where they are
    /// welded, and the ends of step-overs.
    pub(crate) fn knots_within(&self, stretch: &Stretch) -> Vec<f64> {
        let starts = std::iter::once(0.0).chain(self.step_overs.iter().map(|step| step.range().from_mm));
        let ends = self.step_overs.iter().map(|step| step.range().to_mm).chain(std::iter::once(stretch.length));
        let ranges = starts.zip(ends).map(|(from_mm, to_mm)| stretch.range_of(PathRange { from_mm, to_mm }));
        let of_lines = self.lines.iter().zip(ranges).flat_map(|(line, range)| line.knots_within(range));
        let of_steps = self.step_overs.iter().flat_map(|step| [step.range().from_mm, step.range().to_mm]);
        let mut knots: Vec<f64> = of_steps.map(|own| stretch.seam_s(own)).collect();
        knots.extend(of_lines);
        knots
    }
}
