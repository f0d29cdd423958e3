use super::Plots;
use super::figures::{PassFigures, WeldReport};
use super::limits::{axes_table, bounds_table, speed_text, uses_table};
use super::procedure::{positions_table, procedure_text, verdict, windows_table};
use super::simulated::{following_table, simulation_text};
use super::tracking;
use crate::block::{heading, paragraph, sections, signatures};
use crate::number::{Significant as _, range};
use crate::{Block, Finding, Language, Page, Severity, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_program::{FindingGroup, FindingPlace, group_findings};

/// Maximum number of places listed of one finding.
const MAX_PLACES: usize = 6;

/// Drawings of seam, torch and process.
pub(super) const SEAM: [&str; 6] = ["seam", "torch", "process", "weave", "oscillation", "cut"];

impl WeldReport {
    /// Renders the report as one self-contained HTML page in this language. `source` is the text of the job or program,
    /// `date` that of the report, `plots` those of each pass in the same language. Typed texts stay untranslated.
    pub fn page(&self, plots: &[Plots], source: &str, date: &str, language: Language) -> String {
        let several = self.passes.len() > 1;
        let mut blocks = vec![Block::Tiles(self.tiles(language)), heading("report-heading-findings", language)];
        blocks.push(Block::Paragraph(self.checked(language)));
        blocks.extend(self.findings(language));
        match (self.passes.first(), plots.first()) {
            _ if several => blocks.extend(self.all_passes(plots, language)),
            (Some(pass), Some(plots)) => blocks.extend(self.only_pass(pass, plots, language)),
            _ => {}
        }
        let source = Block::Code { caption: self.file.clone(), text: source.to_owned() };
        let signers = ["report-welding-engineer", "report-inspector"].map(|role| (role, String::new()));
        let last = [
            ("report-heading-programs", self.posts.iter().flat_map(|post| post.blocks(language)).collect()),
            ("report-heading-job", vec![self.data_table(language), source]),
            ("report-heading-released", vec![signatures(signers, language)]),
            ("report-heading-curves", if several { self.curves(plots, language) } else { Vec::new() }),
        ];
        blocks.extend(sections(last, language));
        let subtitle = if self.simulation.is_some() { "report-subtitle-simulation" } else { "report-subtitle-plan" };
        Page {
            language,
            title: self.title.clone(),
            subtitle: language.words(subtitle),
            meta: language.named_values([
                ("report-meta-machine", self.machine.title.clone()),
                ("report-column-file", self.file.clone()),
                ("report-column-date", date.to_owned()),
                ("report-meta-made-by", format!("Seamwright {}", self.seamwright)),
            ]),
            verdict: Some(self.verdict(language)),
            blocks,
        }
        .render()
    }

    /// Returns errors and warnings, equal ones once, then notes, which need no action.
    fn findings(&self, language: Language) -> Vec<Block> {
        let several = self.passes.len() > 1;
        let groups = group_findings(&self.findings);
        let found: Vec<Finding> = groups.iter().map(|group| finding(group, several, language)).collect();
        let (notes, findings): (Vec<_>, Vec<_>) = found.into_iter().partition(|f| f.severity == Severity::Note);
        let mut blocks = vec![match findings.is_empty() {
            true => paragraph("report-no-findings-plan", language),
            false => Block::Findings(findings),
        }];
        if !notes.is_empty() {
            blocks.extend([heading("report-heading-notes", language), Block::Findings(notes)]);
        }
        blocks
    }

    fn only_pass(&self, pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
        let figures = |names: &[&str]| plots.figures(names, language);
        let nearest = pass.clearance.as_ref().and_then(|clearance| clearance.nearest_text(language));
        let clearance = nearest.into_iter().map(Block::Paragraph).chain(figures(&["clearance"])).collect();
        let mut speed = vec![Block::Paragraph(speed_text(&pass.certificate, language))];
        speed.extend(figures(&["speed"]));
        speed.push(bounds_table(&pass.certificate, language));
        speed.extend(figures(&["speed-deviation"]));
        let mut axes = figures(&["axes", "jerk"]);
        axes.extend([axes_table(&pass.plan.axes, language), uses_table(&pass.certificate.uses, language)]);
        let parts = [
            ("report-heading-seam", figures(&SEAM)),
            ("report-heading-joint", figures(&["sections"])),
            ("report-heading-procedure", self.procedure(pass, plots, language)),
            ("report-heading-taught", plots.taught(language)),
            ("report-heading-clearance", clearance),
            ("report-heading-speed", speed),
            ("report-heading-tracking", tracked(pass, plots, language)),
            ("report-heading-simulated", self.simulated(pass, plots, language)),
            ("report-heading-axes", axes),
        ];
        sections(parts, language).collect()
    }

    fn procedure(&self, pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
        let (Some(figures), Some(procedure)) = (&pass.procedure, &self.procedure) else { return Vec::new() };
        let mut blocks = vec![Block::Paragraph(procedure_text(procedure, figures, language))];
        blocks.extend(plots.figures(&["heat-input", "position"], language));
        let values = figures.quantities.iter().map(|q| (q.clone(), verdict(q, language)));
        blocks.push(windows_table(language.words("report-caption-plan-values"), values, language));
        blocks.push(positions_table(figures, language));
        blocks
    }

    fn simulated(&self, pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
        let Some(summary) = &pass.simulation else { return Vec::new() };
        let text = simulation_text(summary, &self.machine.assumed_drives, language);
        let mut blocks = vec![Block::Paragraph(text)];
        blocks.extend(plots.figures(&["path-error", "following"], language));
        blocks.push(following_table(summary, language));
        if pass.plan.attitude_error_deg > 0.01 {
            blocks.extend(plots.figures(&["attitude"], language));
        }
        blocks
    }
}

/// Returns the deviation of the weld from the joint, if the joint may deviate from the plan.
fn tracked(pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
    let figures = plots.figures(&["tracking"], language);
    let Some(summary) = pass.simulation.as_ref().filter(|_| !figures.is_empty()) else { return Vec::new() };
    let tables = [Some(tracking::table(&summary.heads, language)), tracking::beam_table(&summary.heads, language)];
    let text = Block::Paragraph(tracking::text(&summary.heads, language));
    std::iter::once(text).chain(tables.into_iter().flatten().map(Block::Table)).chain(figures).collect()
}

fn finding(group: &FindingGroup<'_>, several: bool, language: Language) -> Finding {
    let f = group.finding;
    let mut places: Vec<String> =
        group.places.iter().take(MAX_PLACES).map(|place| place_text(place, several, language)).collect();
    let more = group.places.len().saturating_sub(MAX_PLACES);
    if more > 0 {
        places.push(Message::new("report-more-places").count("n", more).in_language(language));
    }
    Finding {
        severity: match f.severity() {
            seamwright_program::Severity::Error => Severity::Error,
            seamwright_program::Severity::Warning => Severity::Warning,
            seamwright_program::Severity::Note => Severity::Note,
        },
        text: group.message.in_language(language),
        place: places.join("; "),
        cure: group.cure.as_ref().map_or_else(String::new, |cure| cure.in_language(language)),
    }
}

fn place_text(place: &FindingPlace, several: bool, language: Language) -> String {
    let at = match place.is_point() {
        true => Message::new("report-at").significant("s", place.from_mm, Unit::Mm, 5),
        false => range("report-at-range", (place.from_mm, place.to_mm), Unit::Mm),
    };
    let message = match several {
        false => at,
        true if place.first_pass == place.last_pass => {
            Message::new("report-pass-at").pass("pass", place.first_pass).message("place", at)
        }
        true => {
            let passes = Message::new("report-passes-at").pass("first", place.first_pass);
            passes.pass("last", place.last_pass).message("place", at)
        }
    };
    message.in_language(language)
}
