use super::blocks::{figure, paragraph, table};
use super::charts::Plots;
use super::figures::{PassFigures, WeldReport};
use super::limits::{axes_table, bounds_table, speed_text, uses_table};
use super::procedure::{positions_table, procedure_text, windows_table};
use super::simulated::{following_table, simulation_text};
use super::tracking;
use crate::block::{Block, Finding, Severity};
use crate::chart::Chart;
use crate::grid::ChartGrid;
use crate::number::Significant as _;
use crate::page::Page;
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_program::{FindingGroup, FindingPlace, group_findings};

/// Maximum number of places listed of one finding.
const MAX_PLACES: usize = 6;

// Captions of drawings, for one pass and for several.
pub(super) const SECTIONS: &str = "report-caption-sections";
pub(super) const TAUGHT: &str = "report-caption-taught";
pub(super) const HEAT_INPUT: &str = "report-caption-heat-input";
pub(super) const POSITIONS: &str = "report-caption-positions";
pub(super) const CLEARANCE: &str = "report-caption-clearance";
pub(super) const SPEED: &str = "report-caption-speed";
pub(super) const DEVIATION: &str = "report-caption-deviation";
pub(super) const TRACKED: &str = "report-caption-tracking";
pub(super) const PATH_ERROR: &str = "report-caption-path-error";
pub(super) const FOLLOWING: &str = "report-caption-following";
pub(super) const AXES: &str = "report-caption-axes";

impl WeldReport {
    /// Renders the report as one self-contained HTML page in this language. `source` is the text of the job or program,
    /// `date` that of the report, `plots` those of each pass in the same language. Typed texts stay untranslated.
    pub fn page(&self, plots: &[Plots], source: &str, date: &str, language: Language) -> String {
        let heading = |text| Block::Heading(language.words(text));
        let mut blocks = vec![Block::Tiles(self.tiles(language)), heading("report-heading-findings")];
        blocks.push(Block::Paragraph(self.checked(language)));
        blocks.extend(self.findings(language));
        let several = self.passes.len() > 1;
        match (self.passes.first(), plots.first()) {
            _ if several => blocks.extend(self.all_passes(plots, language)),
            (Some(pass), Some(plots)) => self.only_pass(pass, plots, &mut blocks, language),
            _ => {}
        }
        if !self.posts.is_empty() {
            blocks.push(heading("report-heading-programs"));
            blocks.extend(self.posts.iter().flat_map(|post| post.blocks(language)));
        }
        blocks.push(heading("report-heading-job"));
        blocks.push(self.data_table(language));
        blocks.push(Block::Code { caption: self.file.clone(), text: source.to_owned() });
        blocks.push(heading("report-heading-released"));
        blocks.push(released(language));
        if several {
            blocks.extend(self.curves(plots, language));
        }
        let subtitle = match self.simulation {
            Some(_) => "report-subtitle-simulation",
            None => "report-subtitle-plan",
        };
        let meta = [
            ("report-meta-machine", self.machine.title.clone()),
            ("report-column-file", self.file.clone()),
            ("report-column-date", date.to_owned()),
            ("report-meta-made-by", format!("Seamwright {}", self.seamwright)),
        ];
        Page {
            language,
            title: self.title.clone(),
            subtitle: language.words(subtitle),
            meta: meta.map(|(name, value)| (language.words(name), value)).into(),
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
            blocks.push(Block::Heading(language.words("report-heading-notes")));
            blocks.push(Block::Findings(notes));
        }
        blocks
    }

    /// Adds all sections about the pass of a single-pass weld.
    fn only_pass(&self, pass: &PassFigures, plots: &Plots, blocks: &mut Vec<Block>, language: Language) {
        let heading = |what| Block::Heading(language.words(what));
        blocks.push(heading("report-heading-seam"));
        blocks.extend(seam(plots, language));
        if let Some(sections) = &plots.sections {
            blocks.push(heading("report-heading-joint"));
            blocks.push(figure(sections.to_svg(), SECTIONS, language));
        }
        let held = self.procedure(pass, plots, language);
        if !held.is_empty() {
            blocks.push(heading("report-heading-procedure"));
            blocks.extend(held);
        }
        if !plots.taught.is_empty() {
            blocks.push(heading("report-heading-taught"));
        }
        for taught in &plots.taught {
            blocks.push(Block::Paragraph(taught.text.clone()));
            blocks.push(figure(taught.charts.to_svg(), TAUGHT, language));
        }
        if let Some(clearance) = &plots.clearance {
            blocks.push(heading("report-heading-clearance"));
            if let Some(text) = pass.clearance.as_ref().and_then(|clearance| clearance.nearest_text(language)) {
                blocks.push(Block::Paragraph(text));
            }
            blocks.push(figure(clearance.to_svg(), CLEARANCE, language));
        }
        blocks.push(heading("report-heading-speed"));
        blocks.extend(speed(pass, plots, language));
        let tracked = tracking(pass, plots, language);
        if !tracked.is_empty() {
            blocks.push(heading("report-heading-tracking"));
            blocks.extend(tracked);
        }
        let simulated = self.simulated(pass, plots, language);
        if !simulated.is_empty() {
            blocks.push(heading("report-heading-simulated"));
            blocks.extend(simulated);
        }
        blocks.push(heading("report-heading-axes"));
        blocks.extend(axes(pass, plots, language));
    }

    /// Returns the pass against its procedure, if there is one.
    fn procedure(&self, pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
        let (Some(figures), Some(drawn), Some(procedure)) = (&pass.procedure, &plots.procedure, &self.procedure) else {
            return Vec::new();
        };
        let mut blocks = vec![Block::Paragraph(procedure_text(procedure, figures, language))];
        blocks.extend(drawn.heat_input.as_ref().map(|heat_input| {
            let caption = HEAT_INPUT;
            figure(heat_input.to_svg(), caption, language)
        }));
        blocks.push(figure(drawn.positions.to_svg(), POSITIONS, language));
        blocks.push(windows_table(figures, language));
        blocks.push(positions_table(figures, language));
        blocks
    }

    /// Returns the results of the simulated weld, if it was simulated.
    fn simulated(&self, pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
        let (Some(summary), Some(path_error), Some(following), Some(attitude)) =
            (&pass.simulation, &plots.path_error, &plots.following, &plots.attitude)
        else {
            return Vec::new();
        };
        let mut blocks = vec![
            Block::Paragraph(simulation_text(summary, &self.machine.assumed_drives, language)),
            figure(path_error.to_svg(), PATH_ERROR, language),
            figure(following.to_svg(), FOLLOWING, language),
            following_table(summary, language),
        ];
        if pass.plan.attitude_error_deg > 0.01 {
            let caption = "report-caption-attitude";
            blocks.push(figure(attitude.to_svg(), caption, language));
        }
        blocks
    }
}

/// Returns the drawings of seam, torch, process values, weave and oscillation.
pub(super) fn seam(plots: &Plots, language: Language) -> Vec<Block> {
    let drawn = [
        (Some(plots.seam.to_svg()), "report-caption-seam"),
        (plots.torch.as_ref().map(Chart::to_svg), "report-caption-torch-angles"),
        (plots.process.as_ref().map(ChartGrid::to_svg), "report-caption-process-values"),
        (plots.weave.as_ref().map(Chart::to_svg), "report-caption-weave"),
        (plots.oscillation.as_ref().map(Chart::to_svg), "report-caption-oscillation"),
        (plots.cut.clone(), "report-caption-cut"),
    ];
    drawn.into_iter().filter_map(|(svg, caption)| Some(figure(svg?, caption, language))).collect()
}

fn speed(pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
    let mut blocks = vec![
        Block::Paragraph(speed_text(&pass.certificate, language)),
        figure(plots.speed.to_svg(), SPEED, language),
        bounds_table(&pass.certificate, language),
    ];
    blocks.extend(plots.deviation.as_ref().map(|deviation| {
        let caption = DEVIATION;
        figure(deviation.to_svg(), caption, language)
    }));
    blocks
}

/// Returns the deviation of the weld from the joint, if the joint may deviate from the plan.
fn tracking(pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
    let Some((summary, tracked)) = pass.simulation.as_ref().zip(plots.tracking.as_ref()) else { return Vec::new() };
    let mut blocks = vec![
        Block::Paragraph(tracking::text(&summary.heads, language)),
        Block::Table(tracking::table(&summary.heads, language)),
    ];
    blocks.extend(tracking::beam_table(&summary.heads, language).map(Block::Table));
    blocks.push(figure(tracked.to_svg(), TRACKED, language));
    blocks
}

fn axes(pass: &PassFigures, plots: &Plots, language: Language) -> [Block; 4] {
    let planned = AXES;
    [
        figure(plots.axes.to_svg(), planned, language),
        figure(plots.jerks.to_svg(), "report-caption-jerks", language),
        axes_table(&pass.plan.axes, language),
        uses_table(&pass.certificate.uses, language),
    ]
}

/// Returns a form for the release of the weld.
fn released(language: Language) -> Block {
    let row = |who| vec![language.words(who), String::new(), String::new(), String::new()];
    let head =
        ["", "report-column-name", "report-column-date", "report-column-signature"].map(|head| language.words(head));
    let rows = ["report-welding-engineer", "report-inspector"].map(row).into();
    table(&language.words("report-caption-by-hand"), &head, rows, 4..4)
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

/// Formats the location of a finding, with its pass if there are several.
fn place_text(place: &FindingPlace, several: bool, language: Language) -> String {
    let at = match place.is_point() {
        true => Message::new("report-at").significant("s", place.from_mm, Unit::Mm, 5),
        false => Message::new("report-at-range").significant("from", place.from_mm, Unit::One, 5).significant(
            "to",
            place.to_mm,
            Unit::Mm,
            5,
        ),
    };
    let message = match several {
        false => at,
        true if place.first_pass == place.last_pass => {
            Message::new("report-pass-at").pass("pass", place.first_pass).message("place", at)
        }
        true => Message::new("report-passes-at")
            .pass("first", place.first_pass)
            .pass("last", place.last_pass)
            .message("place", at),
    };
    message.in_language(language)
}
