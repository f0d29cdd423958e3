//! The page of a weld for its reader: first verdict, totals and joint; then the passes and the cross-section; then the
//! map of the weld and its schedule. Findings, the procedure and checks follow. Curves and the
//! job's text are in an appendix on request: curves of all axes would fill a book.

use super::Plots;
use super::figures::WeldReport;
use super::limits::{bounds_table, speed_text};
use super::simulated::following_table;
use crate::block::{paragraph, sections, signatures};
use crate::number::{Significant as _, range};
use crate::{Block, Finding, Language, Page, Severity, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_program::{FindingGroup, FindingPlace, Role, group_findings};

/// Maximum number of places listed of one finding.
const MAX_PLACES: usize = 6;

/// Drawings of seam, torch and process in the appendix.
const SEAM: [&str; 2] = ["torch", "process"];
/// Curves of a pass in the appendix, after those.
const CURVES: [&str; 7] = ["clearance", "speed", "speed-deviation", "following", "attitude", "axes", "jerk"];

/// Content of the page of a weld.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Joint, verdict, totals, passes, map, findings, procedure and checks.
    #[default]
    Summary,
    /// The same, with an appendix: curves of axes, speed and torch, more cross-sections, and the text of the job.
    WithAppendix,
}

impl WeldReport {
    /// Renders the report as one self-contained HTML page in this language. `source` is the text of the job or program,
    /// `date` that of the report, `plots` those of each pass in the same language. Typed texts stay untranslated.
    pub fn page(&self, plots: &[Plots], source: &str, date: &str, extent: Extent, language: Language) -> String {
        let mut blocks = self.first_page(language);
        blocks.extend(self.pass_page(plots, language));
        blocks.extend(self.map_page(plots, language));
        blocks.extend(self.findings(language));
        blocks.extend(self.details(plots, language));
        if extent == Extent::WithAppendix {
            blocks.extend(self.appendix(plots, source, language));
        }
        let subtitle = if self.simulation.is_some() { "report-subtitle-simulation" } else { "report-subtitle-plan" };
        let procedure = self.procedure.as_ref().map_or_else(|| language.words("report-none"), |p| p.number.clone());
        Page {
            language,
            title: self.title.clone(),
            subtitle: language.words(subtitle),
            meta: language.named_values([
                ("report-meta-machine", self.machine.title.clone()),
                ("report-meta-procedure", procedure),
                ("report-column-file", self.file.clone()),
                ("report-column-date", date.to_owned()),
                ("report-meta-made-by", format!("Seamwright {}", self.seamwright)),
            ]),
            verdict: Some(self.verdict(language)),
            blocks,
        }
        .render()
    }

    /// Returns totals, errors, and the joint.
    fn first_page(&self, language: Language) -> Vec<Block> {
        let mut blocks = vec![Block::Tiles(self.tiles(language))];
        let errors = self.grouped(|severity| severity == Severity::Error, language);
        let errors = if errors.is_empty() { Vec::new() } else { vec![Block::Findings(errors)] };
        let joint = vec![Block::Facts(self.joint_facts(language))];
        blocks.extend(sections([("report-heading-errors", errors), ("report-heading-joint", joint)], language));
        blocks
    }

    fn pass_page(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let mut blocks = vec![self.page_of("report-heading-passes", language), self.passes_table(language)];
        let sections = figures(plots.first(), &["section"], language);
        blocks.extend(if sections.is_empty() { self.seam_views(plots, language) } else { sections });
        blocks
    }

    fn map_page(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let mut blocks = vec![self.page_of("report-heading-map", language)];
        blocks.extend(figures(plots.first(), &["map", "order"], language));
        blocks.push(self.order_table(language));
        blocks
    }

    fn seam_views(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let views = figures(plots.get(self.main_pass()), &["seam"], language);
        if views.is_empty() { Vec::new() } else { vec![Block::Small(views)] }
    }

    /// Returns the checks that were made and warnings, those of one code together, then notes, which need no action.
    /// Errors are on the first page.
    fn findings(&self, language: Language) -> Vec<Block> {
        let warnings = self.grouped(|severity| severity == Severity::Warning, language);
        let notes = self.grouped(|severity| severity == Severity::Note, language);
        let mut blocks = vec![self.page_of("report-heading-findings", language)];
        blocks.push(Block::Paragraph(self.checked(language)));
        if !warnings.is_empty() {
            blocks.push(Block::Findings(warnings));
        } else if self.findings.iter().all(|f| f.allowed) {
            blocks.push(paragraph("report-no-findings-plan", language));
        }
        let notes = if notes.is_empty() { Vec::new() } else { vec![Block::Findings(notes)] };
        blocks.extend(sections([("report-heading-notes", notes)], language));
        blocks
    }

    fn grouped(&self, wanted: impl Fn(Severity) -> bool, language: Language) -> Vec<Finding> {
        let several = self.passes.len() > 1;
        let groups = group_findings(&self.findings);
        let all = groups.iter().map(|group| finding(group, several, language));
        all.filter(|finding| wanted(finding.severity)).collect()
    }

    /// Returns procedure, checks and results of simulation with the curves that concern the weld and not the machine.
    fn details(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let main = plots.get(self.main_pass());
        let mut procedure = self.procedure_of_all(language);
        if !procedure.is_empty() {
            procedure.extend(figures(main, &["heat-input", "position"], language));
        }
        let mut simulated = self.simulated_of_all(language);
        simulated.extend(figures(main, &["path-error"], language));
        let mut tracked = self.tracked_of_all(language);
        tracked.extend(figures(main, &["tracking"], language));
        let parts = [
            ("report-heading-process", figures(main, &["process", "weave", "oscillation"], language)),
            ("report-heading-procedure", procedure),
            ("report-heading-materials", self.metallurgy(language)),
            ("report-heading-cut", figures(plots.first(), &["cut"], language)),
            ("report-heading-seam", if self.joint.is_some() { self.seam_views(plots, language) } else { Vec::new() }),
            ("report-heading-taught", main.map_or(Vec::new(), |plots| plots.taught(language))),
            ("report-heading-checks", vec![self.checks_table(language)]),
            ("report-heading-simulated", simulated),
            ("report-heading-tracking", tracked),
            ("report-heading-job", vec![self.data_table(language)]),
            ("report-heading-programs", self.posts.iter().flat_map(|post| post.blocks(language)).collect()),
        ];
        let signers = ["report-welding-engineer", "report-inspector"].map(|role| (role, String::new()));
        let released = [("report-heading-released", vec![signatures(signers, language)])];
        sections(parts.into_iter().chain(released), language).collect()
    }

    /// Returns curves of one pass of each kind, limits of the axes, and the text of the job.
    fn appendix(&self, plots: &[Plots], source: &str, language: Language) -> Vec<Block> {
        let mut blocks =
            vec![Block::Page(language.words("report-heading-curves")), paragraph("report-about-curves", language)];
        blocks.extend(figures(plots.first(), &["sections"], language));
        blocks.extend(self.axes_of_all(language));
        for i in self.typical_passes() {
            let (pass, plots) = (&self.passes[i], plots.get(i));
            let heading = Message::new("report-heading-pass-curves").pass("pass", i + 1).text("name", &pass.name);
            blocks.push(Block::Heading(heading.in_language(language)));
            blocks.extend(figures(plots, &SEAM, language));
            blocks.push(Block::Paragraph(speed_text(&pass.certificate, language)));
            blocks.push(bounds_table(&pass.certificate, language));
            blocks.extend(pass.simulation.as_ref().map(|summary| following_table(summary, language)));
            blocks.extend(figures(plots, &CURVES, language));
        }
        let source = Block::Code { caption: self.file.clone(), text: source.to_owned() };
        blocks.extend(sections([("report-heading-source", vec![source])], language));
        blocks
    }

    /// Returns a heading that begins a printed page; a weld in one pass does not fill pages.
    fn page_of(&self, code: &'static str, language: Language) -> Block {
        let text = language.words(code);
        if self.passes.len() > 1 { Block::Page(text) } else { Block::Heading(text) }
    }

    /// Returns the index of the pass that stands for the weld: one with an error, or else the longest. Tacks and cosmetic
    /// passes are not the weld.
    fn main_pass(&self) -> usize {
        let aside = [Role::Tack.name(), Role::Cosmetic.name()];
        let weight = |i: usize| {
            let pass = &self.passes[i];
            let against = self.findings.iter().any(|f| f.pass == i + 1 && !f.allowed);
            (!pass.role.is_some_and(|role| aside.contains(&role)), against, pass.plan.length_mm)
        };
        (0..self.passes.len()).reduce(|a, b| if weight(b) > weight(a) { b } else { a }).unwrap_or(0)
    }
}

fn figures(plots: Option<&Plots>, names: &[&str], language: Language) -> Vec<Block> {
    plots.map_or(Vec::new(), |plots| plots.figures(names, language))
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
