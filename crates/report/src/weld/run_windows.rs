//! Values of the passes of each run of the procedure against its limits.

use super::figures::WeldReport;
use super::procedure::{
    PassProcedureFigures, QuantityFigures, degrees, positions_caption, procedure_text, verdict, windows_table,
};
use crate::number::{from_to, number};
use crate::{Block, Language, Table, Words as _};
use seamwright_message::Message;
use seamwright_program::WeldingPosition;

struct RunPasses<'a> {
    /// Number, counted from 1, and figures of each pass.
    passes: Vec<(usize, &'a PassProcedureFigures)>,
}

struct PositionSum {
    position: WeldingPosition,
    allowed: bool,
    length_mm: f64,
    slope_deg: Option<(f64, f64)>,
    rotation_deg: Option<(f64, f64)>,
    passes: Vec<usize>,
}

impl WeldReport {
    /// Returns all passes against their procedure, run by run, if there is one.
    pub(super) fn procedure_of_all(&self, language: Language) -> Vec<Block> {
        let Some(procedure) = &self.procedure else { return Vec::new() };
        let mut runs: Vec<RunPasses<'_>> = Vec::new();
        let passes = self.passes.iter().zip(1..).filter_map(|(pass, number)| Some((number, pass.procedure.as_ref()?)));
        for pass in passes {
            let kind = |figures: &PassProcedureFigures| (figures.run.clone(), figures.joint);
            match runs.iter_mut().find(|run| kind(run.passes[0].1) == kind(pass.1)) {
                Some(run) => run.passes.push(pass),
                None => runs.push(RunPasses { passes: vec![pass] }),
            }
        }
        let blocks = runs.iter().flat_map(|run| {
            let text = Block::Paragraph(procedure_text(procedure, run.first(), language));
            [text, run.windows_table(language), run.positions_table(language)]
        });
        blocks.collect()
    }
}

impl<'a> RunPasses<'a> {
    fn first(&self) -> &'a PassProcedureFigures {
        self.passes[0].1
    }

    fn windows_table(&self, language: Language) -> Block {
        let rows = self.first().quantities.iter().map(|q| {
            let (all, outside) = self.quantity(q);
            let verdict = match outside.is_empty() || self.passes.len() == 1 {
                true => verdict(q, language),
                false => {
                    let passes = numbers(&outside, language);
                    Message::new("report-outside-pass").text("passes", passes).in_language(language)
                }
            };
            (all, verdict)
        });
        let passes: Vec<usize> = self.passes.iter().map(|(number, _)| *number).collect();
        let caption = Message::new("report-caption-plan-values-of").text("passes", numbers(&passes, language));
        windows_table(caption.in_language(language), rows, language)
    }

    /// Returns the quantity with the extremes of all passes, and the passes in which it is outside.
    fn quantity(&self, of: &QuantityFigures) -> (QuantityFigures, Vec<usize>) {
        let (mut found, mut outside) = (None, Vec::new());
        for (number, figures) in &self.passes {
            for q in figures.quantities.iter().filter(|q| q.key == of.key) {
                found = wider(found, q.found);
                if !q.outside.is_empty() {
                    outside.push(*number);
                }
            }
        }
        (QuantityFigures { found, outside: Vec::new(), ..of.clone() }, outside)
    }

    fn positions_table(&self, language: Language) -> Block {
        let table = Table::of(language, self.positions())
            .text("report-column-position", |sum| sum.position.to_string())
            .text("report-column-pass", |sum| numbers(&sum.passes, language))
            .number("report-column-length-mm", |sum| number(sum.length_mm, language))
            .number("report-column-slope", |sum| degrees(sum.slope_deg, language))
            .number("report-column-rotation", |sum| degrees(sum.rotation_deg, language))
            .text("", |sum| language.words(if sum.allowed { "report-allowed" } else { "report-not-allowed" }));
        Block::Table(table.table(positions_caption(self.first(), language)))
    }

    fn positions(&self) -> Vec<PositionSum> {
        let mut sums: Vec<PositionSum> = Vec::new();
        for (number, figures) in &self.passes {
            for p in &figures.positions {
                let i = sums.iter().position(|sum| sum.position == p.position).unwrap_or_else(|| {
                    sums.push(PositionSum {
                        position: p.position,
                        allowed: p.allowed,
                        length_mm: 0.0,
                        slope_deg: None,
                        rotation_deg: None,
                        passes: Vec::new(),
                    });
                    sums.len() - 1
                });
                let sum = &mut sums[i];
                sum.length_mm += p.to_mm - p.from_mm;
                sum.slope_deg = wider(sum.slope_deg, p.slope_deg);
                sum.rotation_deg = wider(sum.rotation_deg, p.rotation_deg);
                if sum.passes.last() != Some(number) {
                    sum.passes.push(*number);
                }
            }
        }
        sums
    }
}

/// Returns the union of both ranges.
fn wider(a: Option<(f64, f64)>, b: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (a, b) {
        (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
        _ => a.or(b),
    }
}

/// Formats increasing numbers of passes: `1 to 4, 6`.
pub(super) fn numbers(passes: &[usize], language: Language) -> String {
    let runs = passes.chunk_by(|a, b| *b == a + 1);
    let text = |run: &[usize]| match run {
        [first, .., last] => from_to(first.to_string(), last.to_string(), language),
        _ => run.iter().map(usize::to_string).collect(),
    };
    runs.map(text).collect::<Vec<_>>().join(", ")
}
