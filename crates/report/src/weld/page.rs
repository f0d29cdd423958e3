use super::Plots;
use super::figures::{PassFigures, WeldReport};
use super::limits::{axes_table, bounds_table, speed_text, uses_table};
use super::procedure::{positions_table, procedure_text, windows_table};
use super::simulated::{following_table, simulation_text};
use super::tracking;
use crate::Phrases as _;
use crate::{Block, Chart, ChartGrid, Finding, Language, Page, Severity, Table, format_number, said};
use seamwright_program::{FindingGroup, FindingPlace, group_findings};

/// Maximum number of places listed of one finding.
const MAX_PLACES: usize = 6;

// Captions of drawings, for one pass and for several.
pub(super) const SECTIONS: &str = "Cross-sections along the seam, all at one scale, the second part's face level or a butt joint's face up: beads in the order of welding, and where the wire points in each; the area is that of the groove and of the cap over it.";
pub(super) const TAUGHT: &str =
    "The seam as welded against the nominal one: at both joins the same place, direction and curvature.";
pub(super) const HEAT_INPUT: &str =
    "Heat input at the planned speed between run-up and run-down, with its window; shaded where it is outside.";
pub(super) const POSITIONS: &str = "Welding position (ISO 6947) by slope of the travel and rotation of the weld's face, as the machine's axes turn the part.";
pub(super) const CLEARANCE: &str = "Least distance of torch, links, part, fixtures and zones from one another, and the bound below which none falls anywhere.";
pub(super) const SPEED: &str = "Speed of the tip along the seam, relative to the work; shaded where it is slower than asked, with the limit that binds.";
pub(super) const DEVIATION: &str =
    "Deviation of the simulated speed between run-up and run-down; at its start the drives settle.";
pub(super) const TRACKED: &str = "Where the joint truly lies beside the planned path, how far the weld lies from it, and how well tracking knew the joint.";
pub(super) const PATH_ERROR: &str = "Distance of the true tip from the seam, normal to it.";
pub(super) const FOLLOWING: &str = "Set-point less true position of each axis.";
pub(super) const AXES: &str = "Planned position, speed and acceleration of each axis against its limits.";

impl WeldReport {
    /// Renders the report as one self-contained HTML page in this language. `source` is the text of the job or program,
    /// `date` that of the report, `plots` those of each pass in the same language. Typed texts stay untranslated.
    pub fn page(&self, plots: &[Plots], source: &str, date: &str, language: Language) -> String {
        let heading = |text| Block::Heading(language.say(text).to_owned());
        let mut blocks = vec![Block::Tiles(self.tiles(language)), heading("Findings")];
        blocks.push(Block::Paragraph(self.checked(language)));
        blocks.extend(self.findings(language));
        let several = self.passes.len() > 1;
        match (self.passes.first(), plots.first()) {
            _ if several => blocks.extend(self.all_passes(plots, language)),
            (Some(pass), Some(plots)) => self.only_pass(pass, plots, &mut blocks, language),
            _ => {}
        }
        if !self.posts.is_empty() {
            blocks.push(heading("Part programs"));
            blocks.extend(self.posts.iter().flat_map(|post| post.blocks(language)));
        }
        blocks.push(heading("job.head"));
        blocks.push(self.data_table(language));
        blocks.push(Block::Code { caption: self.file.clone(), text: source.to_owned() });
        blocks.push(heading("Released"));
        blocks.push(released(language));
        if several {
            blocks.extend(self.curves(plots, language));
        }
        let subtitle = match self.simulation {
            Some(_) => "Weld report: plan and simulation",
            None => "Weld report: plan",
        };
        let meta = [
            ("record.machine", self.machine.title.clone()),
            ("File", self.file.clone()),
            ("Date", date.to_owned()),
            ("Made by", format!("Seamwright {}", self.seamwright)),
        ];
        Page {
            language,
            title: self.title.clone(),
            subtitle: language.say(subtitle).to_owned(),
            meta: meta.map(|(name, value)| (language.say(name).to_owned(), value)).into(),
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
            true => paragraph("None: the weld can be made as asked on this machine.", language),
            false => Block::Findings(findings),
        }];
        if !notes.is_empty() {
            blocks.push(Block::Heading(language.say("Notes").to_owned()));
            blocks.push(Block::Findings(notes));
        }
        blocks
    }

    /// Adds all sections about the pass of a single-pass weld.
    fn only_pass(&self, pass: &PassFigures, plots: &Plots, blocks: &mut Vec<Block>, language: Language) {
        let heading = |what| Block::Heading(language.say(what).to_owned());
        blocks.push(heading("Seam and torch"));
        blocks.extend(seam(plots, language));
        if let Some(sections) = &plots.sections {
            blocks.push(heading("Joint"));
            blocks.push(figure(sections.to_svg(), SECTIONS, language));
        }
        let held = self.procedure(pass, plots, language);
        if !held.is_empty() {
            blocks.push(heading("record.procedure"));
            blocks.extend(held);
        }
        if !plots.taught.is_empty() {
            blocks.push(heading("Taught spans"));
        }
        for taught in &plots.taught {
            blocks.push(Block::Paragraph(taught.text.clone()));
            blocks.push(figure(taught.charts.to_svg(), TAUGHT, language));
        }
        if let Some(clearance) = &plots.clearance {
            blocks.push(heading("Clearance"));
            if let Some(text) = pass.clearance.as_ref().and_then(|clearance| clearance.nearest_text(language)) {
                blocks.push(Block::Paragraph(text));
            }
            blocks.push(figure(clearance.to_svg(), CLEARANCE, language));
        }
        blocks.push(heading("Speed"));
        blocks.extend(speed(pass, plots, language));
        let tracked = tracking(pass, plots, language);
        if !tracked.is_empty() {
            blocks.push(heading("Tracking"));
            blocks.extend(tracked);
        }
        let simulated = self.simulated(pass, plots, language);
        if !simulated.is_empty() {
            blocks.push(heading("Simulated weld"));
            blocks.extend(simulated);
        }
        blocks.push(heading("Axes"));
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
            let caption = "Angle between the true torch direction and the one asked for.";
            blocks.push(figure(attitude.to_svg(), caption, language));
        }
        blocks
    }
}

/// Returns the drawings of seam, torch, process values, weave and oscillation.
pub(super) fn seam(plots: &Plots, language: Language) -> Vec<Block> {
    let drawn = [
        (Some(plots.seam.to_svg()), "Seam with the torch axis asked for, in the job's frame, first-angle projection."),
        (
            plots.torch.as_ref().map(Chart::to_svg),
            "Work angle from the bisector of the faces (positive towards the first part), travel angle, and half the angle between the faces.",
        ),
        (
            plots.process.as_ref().map(ChartGrid::to_svg),
            "Process values along the pass where they change; slopes at its ends are not in it.",
        ),
        (
            plots.weave.as_ref().map(Chart::to_svg),
            "The woven path as asked, seen along the torch with the seam laid straight, the same scale along and across; the way goes to the right.",
        ),
        (
            plots.oscillation.as_ref().map(Chart::to_svg),
            "Where the deflected beam goes on the work, the same scale along and across; oscillation.csv has one period of the deflection.",
        ),
        (
            plots.cut.clone(),
            "The tube's end as it is cut, unrolled; cut.svg has it at true size, seen from outside, to wrap around the tube, and cut.csv its points.",
        ),
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
        figure(plots.jerks.to_svg(), "Planned jerk of each axis against its limit.", language),
        axes_table(&pass.plan.axes, language),
        uses_table(&pass.certificate.uses, language),
    ]
}

/// Returns a form for the release of the weld.
fn released(language: Language) -> Block {
    let row = |who| vec![language.say(who).to_owned(), String::new(), String::new(), String::new()];
    let head = ["", "Name", "Date", "Signature"].map(|head| language.say(head));
    let rows = ["Welding engineer", "Inspector"].map(row).into();
    table(language.say("To be filled in by hand"), &head, rows, 4..4)
}

/// Formats lengths, times and positions.
pub(super) fn number(value: f64) -> String {
    format_number(value, 5)
}

/// Formats errors and deviations, for which two digits suffice.
pub(super) fn small(value: f64) -> String {
    format_number(value, 2)
}

pub(super) fn paragraph(text: &'static str, language: Language) -> Block {
    Block::Paragraph(language.say(text).to_owned())
}

pub(super) fn figure(svg: String, caption: &'static str, language: Language) -> Block {
    Block::Figure { svg, caption: language.say(caption).to_owned() }
}

fn finding(group: &FindingGroup<'_>, several: bool, language: Language) -> Finding {
    let f = group.finding;
    let mut places: Vec<String> =
        group.places.iter().take(MAX_PLACES).map(|place| place_text(place, several, language)).collect();
    let more = group.places.len().saturating_sub(MAX_PLACES);
    if more > 0 {
        places.push(language.fill("{0} more places", &[&more.to_string()]));
    }
    Finding {
        severity: match f.severity() {
            seamwright_program::Severity::Error => Severity::Error,
            seamwright_program::Severity::Warning => Severity::Warning,
            seamwright_program::Severity::Note => Severity::Note,
        },
        text: said::message(language, &group.message),
        place: places.join("; "),
        cure: group.cure.as_ref().map_or_else(String::new, |cure| said::message(language, cure)),
    }
}

/// Formats the location of a finding, with its pass if there are several.
fn place_text(place: &FindingPlace, several: bool, language: Language) -> String {
    let at = match place.is_point() {
        true => language.fill("s = {0} mm", &[&number(place.from_mm)]),
        false => language.fill("s = {0} to {1} mm", &[&number(place.from_mm), &number(place.to_mm)]),
    };
    let (first, last) = (place.first_pass.to_string(), place.last_pass.to_string());
    match several {
        false => at,
        true if first == last => language.fill("pass {0}, {1}", &[&first, &at]),
        true => language.fill("passes {0} to {1}, {2}", &[&first, &last, &at]),
    }
}

pub(crate) fn table(caption: &str, head: &[&str], rows: Vec<Vec<String>>, numeric: std::ops::Range<usize>) -> Block {
    Block::Table(Table {
        caption: caption.to_owned(),
        head: head.iter().map(|h| (*h).to_owned()).collect(),
        numeric: (0..head.len()).map(|i| numeric.contains(&i)).collect(),
        rows,
    })
}
