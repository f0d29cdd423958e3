//! Page of a weld of several passes: tables by pass, and the curves of one pass of each kind. The curves of all passes
//! would fill a book with repetitions.

use super::blocks::{figure, number, paragraph, small, table};
use super::certificate::UseFigures;
use super::charts::Plots;
use super::figures::{PassFigures, WeldReport};
use super::limits::{axes_table, speed_text, uses_table};
use super::page::seam;
use super::plan::AxisFigures;
use super::range::Range;
use super::simulated::simulation_text;
use super::tracking;
use crate::block::{Block, Table};
use crate::chart::Chart;
use crate::grid::ChartGrid;
use crate::names;
use crate::number::{Significant as _, from_to, significant};
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_simulation::tracking::HeadSummary;

/// A column of a table by pass: its heading and its cell for a pass.
type Column<'a> = (String, Box<dyn Fn(&PassFigures) -> String + 'a>);

/// Placeholder for a missing value.
const NONE: &str = "–";

impl WeldReport {
    /// Returns the sections about all passes, before the job.
    pub(super) fn all_passes(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let heading = |text| Block::Heading(language.words(text));
        let mut blocks = vec![heading("report-heading-passes"), self.passes_table(language)];
        let first = plots.first();
        blocks.push(heading("report-heading-order"));
        blocks.extend(first.and_then(|plots| plots.order.as_ref()).map(|order| {
            let caption = "report-caption-order";
            figure(order.to_svg(), caption, language)
        }));
        blocks.push(self.order_table(language));
        if let Some(sections) = first.and_then(|plots| plots.sections.as_ref()) {
            blocks.push(heading("report-heading-joint"));
            blocks.push(figure(sections.to_svg(), super::page::SECTIONS, language));
        }
        blocks.extend(self.procedure_of_all(language));
        blocks.push(heading("report-heading-checks"));
        blocks.push(self.checks_table(language));
        blocks.push(axes_table(&self.axes_of_all(), language));
        blocks.push(uses_table(&self.uses_of_all(), language));
        blocks.extend(self.simulated_of_all(language));
        blocks
    }

    /// Returns the curves of one pass of each kind.
    pub(super) fn curves(&self, plots: &[Plots], language: Language) -> Vec<Block> {
        let mut blocks =
            vec![Block::Heading(language.words("report-heading-curves")), paragraph("report-about-curves", language)];
        for i in self.typical_passes() {
            let (pass, Some(plots)) = (&self.passes[i], plots.get(i)) else { continue };
            let heading = Message::new("report-heading-pass-curves").pass("pass", i + 1).text("name", &pass.name);
            blocks.push(Block::Heading(heading.in_language(language)));
            blocks.extend(pass_curves(pass, plots, language));
        }
        blocks
    }

    /// Returns one pass of each kind, in the order of welding: one with a finding against it, or else the longest. A
    /// pass without a role, as in a program of points, is alike only to those of its name.
    fn typical_passes(&self) -> Vec<usize> {
        let weight = |i: usize| {
            let against = self.findings.iter().any(|f| f.pass == i + 1 && !f.allowed);
            (against, self.passes[i].plan.length_mm)
        };
        let is_alike = |a: &PassFigures, b: &PassFigures| a.role == b.role && (a.role.is_some() || a.name == b.name);
        let mut typical: Vec<usize> = Vec::new();
        for i in 0..self.passes.len() {
            match typical.iter_mut().find(|known| is_alike(&self.passes[**known], &self.passes[i])) {
                Some(known) if weight(i) > weight(*known) => *known = i,
                Some(_) => {}
                None => typical.push(i),
            }
        }
        typical.sort_unstable();
        typical
    }

    /// Returns process values and results of each pass, with equal passes in one row. Times of arc and gas are in the
    /// table of the order, because the table would be wider than a page.
    fn passes_table(&self, language: Language) -> Block {
        let say = |code: &'static str| language.words(code);
        let mut names: Vec<&String> = self.passes.iter().flat_map(|pass| pass.process_range.keys()).collect();
        names.sort_unstable();
        names.dedup();
        let mut columns: Vec<Column<'_>> = Vec::new();
        for name in names {
            let value = move |pass: &PassFigures| {
                optional(pass.process_range.get(name).map(|r| Range::from(*r).text(language)))
            };
            columns.push((names::value(language, name), Box::new(value)));
        }
        let speed = |pass: &PassFigures| {
            let range = Range { min: pass.plan.least_speed_mm_s, max: pass.plan.greatest_speed_mm_s };
            range.short_text(language)
        };
        columns.push((say("report-column-speed-mm-s"), Box::new(speed)));
        if self.passes.iter().any(|pass| pass.plan.arc_energy_kj_mm.is_some()) {
            let energy =
                |pass: &PassFigures| optional(pass.plan.arc_energy_kj_mm.map(|e| Range::from(e).short_text(language)));
            columns.push((say("report-column-arc-energy"), Box::new(energy)));
        }
        if self.passes.iter().any(|pass| pass.heat_input_kj_mm().is_some()) {
            let heat =
                |pass: &PassFigures| optional(pass.heat_input_kj_mm().map(|h| Range::from(h).short_text(language)));
            columns.push((say("report-column-heat-input"), Box::new(heat)));
        }
        columns.push((say("report-column-length-mm"), Box::new(|pass| number(pass.plan.length_mm, language))));
        columns.push((say("report-column-travel-s"), Box::new(|pass| number(pass.plan.weld_s, language))));
        if self.totals.wire_m.is_some_and(|wire| wire > 0.0) {
            columns.push((
                say("report-column-wire-m"),
                Box::new(|pass| optional(pass.wire_m.map(|m| significant(m, 3, language)))),
            ));
        }
        let caption = language.words("report-caption-passes");
        let mut by_pass = by_pass(&self.passes, &columns, &caption, language);
        by_pass.rows.push(self.sums(&by_pass, columns.len(), language));
        Block::Table(by_pass)
    }

    /// Returns the last row of the table of passes: sums of the columns that have one.
    fn sums(&self, table: &Table, columns: usize, language: Language) -> Vec<String> {
        let totals = &self.totals;
        let sums = [
            ("report-column-length-mm", Some(totals.length_mm)),
            ("report-column-travel-s", Some(totals.weld_s)),
            ("report-column-wire-m", totals.wire_m),
        ];
        let sum = |head: &String| {
            let found = sums.iter().find(|(name, _)| language.words(name) == *head);
            found.and_then(|(_, value)| *value).map_or_else(String::new, |value| number(value, language))
        };
        let all = [String::new(), language.words("report-all-passes")];
        all.into_iter().chain(table.head[2..columns + 2].iter().map(sum)).collect()
    }

    /// Returns the checks of each pass.
    fn checks_table(&self, language: Language) -> Block {
        let say = |code: &'static str| language.words(code);
        let mut columns: Vec<Column<'_>> = vec![
            (
                say("report-column-at-requested-speed"),
                Box::new(|pass: &PassFigures| significant(pass.certificate.at_asked_percent, 3, language)),
            ),
            (
                say("report-column-attitude-error"),
                Box::new(|pass: &PassFigures| small(pass.plan.attitude_error_deg, language)),
            ),
        ];
        if self.passes.iter().any(|pass| pass.clearance.is_some()) {
            let nearest = |pass: &PassFigures| match &pass.clearance {
                Some(c) if c.between.is_some() => number(c.nearest_mm, language),
                Some(c) => {
                    let message = Message::new("report-more-than").significant("value", c.nearest_mm, Unit::One, 5);
                    message.in_language(language)
                }
                None => NONE.to_owned(),
            };
            columns.push((say("report-column-clearance"), Box::new(nearest)));
            let between = |pass: &PassFigures| optional(pass.clearance.as_ref().and_then(|c| c.between_text(language)));
            columns.push((say("report-column-between"), Box::new(between)));
        }
        let mut by_pass = by_pass(&self.passes, &columns, &language.words("report-caption-checks"), language);
        if let Some(last) = by_pass.numeric.get_mut(5) {
            *last = false;
        }
        Block::Table(by_pass)
    }

    /// Returns the extremes of the axes over all passes.
    fn axes_of_all(&self) -> Vec<AxisFigures> {
        let mut passes = self.passes.iter().map(|pass| &pass.plan.axes);
        let mut all = passes.next().cloned().unwrap_or_default();
        for axes in passes {
            for (all, axis) in all.iter_mut().zip(axes) {
                (all.min, all.max) = (all.min.min(axis.min), all.max.max(axis.max));
            }
        }
        all
    }

    /// Returns the maximum use of limits over all passes.
    fn uses_of_all(&self) -> Vec<UseFigures> {
        let mut passes = self.passes.iter().map(|pass| &pass.certificate.uses);
        let mut all = passes.next().cloned().unwrap_or_default();
        for uses in passes {
            for (all, used) in all.iter_mut().zip(uses) {
                all.speed_percent = all.speed_percent.max(used.speed_percent);
                all.acceleration_percent = all.acceleration_percent.max(used.acceleration_percent);
                all.jerk_percent = all.jerk_percent.max(used.jerk_percent);
            }
        }
        all
    }

    /// Returns the results of the simulated passes, if they were simulated.
    fn simulated_of_all(&self, language: Language) -> Vec<Block> {
        let Some((_, worst)) = self.worst_simulated() else { return Vec::new() };
        let heading = |text| Block::Heading(language.words(text));
        let say = |code: &'static str| language.words(code);
        let simulated =
            |of: fn(&seamwright_simulation::Summary) -> Option<f64>| -> Box<dyn Fn(&PassFigures) -> String> {
                Box::new(move |pass| {
                    optional(pass.simulation.as_ref().and_then(of).map(|value| small(value, language)))
                })
            };
        let columns: [Column<'_>; 3] = [
            (say("report-column-path-error-mm"), simulated(|s| s.welded.then_some(s.path_error_mm.max))),
            (say("report-column-rms-mm"), simulated(|s| s.welded.then_some(s.path_error_mm.rms))),
            (say("report-column-speed-ripple"), simulated(|s| s.speed_ripple.map(|ripple| 100.0 * ripple))),
        ];
        let caption = language.words("report-caption-simulated-passes");
        let mut blocks = vec![
            heading("report-heading-simulated"),
            Block::Paragraph(simulation_text(worst, &self.machine.assumed_drives, language)),
            Block::Table(by_pass(&self.passes, &columns, &caption, language)),
        ];
        let heads = |pass: &PassFigures| pass.simulation.as_ref().map_or(0, |s| s.heads.len());
        if self.passes.iter().any(|pass| heads(pass) > 0) {
            blocks.push(heading("report-heading-tracking"));
            blocks.extend(self.tracked_of_all(language));
        }
        blocks
    }

    /// Returns the deviation of each pass from the joint, and the corrections of beams.
    fn tracked_of_all(&self, language: Language) -> Vec<Block> {
        let heads = |pass: &PassFigures| pass.simulation.as_ref().map_or_else(Vec::new, |s| s.heads.clone());
        let all: Vec<HeadSummary> = self.passes.iter().flat_map(heads).collect();
        let tables: [HeadTable; 2] = [
            |heads, language| Some(tracking::table(heads, language)),
            |heads, language| tracking::beam_table(heads, language),
        ];
        let mut blocks = vec![Block::Paragraph(tracking::text(&all, language))];
        for table in tables {
            let of_passes = self.passes.iter().enumerate().filter_map(|(i, pass)| {
                let heads = heads(pass);
                Some((i + 1, table(&heads, language).filter(|_| !heads.is_empty())?))
            });
            blocks.extend(joined(of_passes, language).map(Block::Table));
        }
        blocks
    }
}

/// A table about the heads of one pass, if it has rows.
type HeadTable = fn(&[HeadSummary], Language) -> Option<Table>;

/// Joins the tables of several passes, which have the same columns, with the number of the pass in front.
fn joined(tables: impl Iterator<Item = (usize, Table)>, language: Language) -> Option<Table> {
    let numbered = tables.map(|(pass, mut table)| {
        table.rows.iter_mut().for_each(|row| row.insert(0, pass.to_string()));
        table
    });
    let mut all = numbered.reduce(|mut all, table| {
        all.rows.extend(table.rows);
        all
    })?;
    all.head.insert(0, language.words("report-column-pass"));
    all.numeric.insert(0, false);
    Some(all)
}

/// Creates a table with a row per pass; consecutive passes with equal columns share one.
fn by_pass(passes: &[PassFigures], columns: &[Column<'_>], caption: &str, language: Language) -> Table {
    let mut rows: Vec<(usize, usize, Vec<String>)> = Vec::new();
    for (i, pass) in passes.iter().enumerate() {
        let cells: Vec<String> = columns.iter().map(|(_, of)| of(pass)).collect();
        match rows.last_mut() {
            Some((_, last, same)) if *same == cells => *last = i,
            _ => rows.push((i, i, cells)),
        }
    }
    let row = |(first, last, cells): (usize, usize, Vec<String>)| {
        let (numbers, names) = match first == last {
            true => ((first + 1).to_string(), passes[first].name.clone()),
            false => (
                from_to((first + 1).to_string(), (last + 1).to_string(), language),
                format!("{} … {}", passes[first].name, passes[last].name),
            ),
        };
        [numbers, names].into_iter().chain(cells).collect()
    };
    let head = [language.words("report-column-pass"), language.words("report-column-name")];
    Table {
        caption: caption.to_owned(),
        numeric: (0..columns.len() + 2).map(|column| column > 1).collect(),
        head: head.into_iter().chain(columns.iter().map(|(head, _)| head.clone())).collect(),
        rows: rows.into_iter().map(row).collect(),
    }
}

fn optional(text: Option<String>) -> String {
    text.unwrap_or_else(|| NONE.to_owned())
}

/// Returns the drawings of one pass.
fn pass_curves(pass: &PassFigures, plots: &Plots, language: Language) -> Vec<Block> {
    let mut blocks = seam(plots, language);
    for taught in &plots.taught {
        blocks.push(Block::Paragraph(taught.text.clone()));
        blocks.push(figure(taught.charts.to_svg(), super::page::TAUGHT, language));
    }
    let procedure = plots.procedure.as_ref();
    let drawn = [
        (procedure.and_then(|p| p.heat_input.as_ref()).map(Chart::to_svg), super::page::HEAT_INPUT),
        (procedure.map(|p| p.positions.to_svg()), super::page::POSITIONS),
        (plots.clearance.as_ref().map(Chart::to_svg), super::page::CLEARANCE),
        (Some(plots.speed.to_svg()), super::page::SPEED),
        (plots.deviation.as_ref().map(Chart::to_svg), super::page::DEVIATION),
        (plots.tracking.as_ref().map(ChartGrid::to_svg), super::page::TRACKED),
        (plots.path_error.as_ref().map(Chart::to_svg), super::page::PATH_ERROR),
        (plots.following.as_ref().map(ChartGrid::to_svg), super::page::FOLLOWING),
        (Some(plots.axes.to_svg()), super::page::AXES),
    ];
    blocks.extend(drawn.into_iter().filter_map(|(svg, caption)| Some(figure(svg?, caption, language))));
    blocks.insert(0, Block::Paragraph(speed_text(&pass.certificate, language)));
    blocks
}

impl WeldReport {
    /// Returns the passes in the order of welding with their times.
    pub(super) fn order_table(&self, language: Language) -> Block {
        let mut begun = 0.0;
        let rows = self.passes.iter().enumerate().map(|(i, pass)| {
            let p = &pass.plan;
            begun += pass.air_before_s;
            let row = vec![
                (i + 1).to_string(),
                pass.name.clone(),
                number(pass.air_before_s, language),
                number(begun, language),
                number(p.weld_s, language),
                number(p.arc_on_s, language),
                number(p.total_s, language),
            ];
            begun += p.total_s;
            row
        });
        let mut rows: Vec<Vec<String>> = rows.collect();
        let sum = |f: fn(&super::figures::PassFigures) -> f64| number(self.passes.iter().map(f).sum(), language);
        rows.push(vec![
            String::new(),
            language.words("report-all-from-home"),
            number(self.air_s, language),
            String::new(),
            sum(|p| p.plan.weld_s),
            sum(|p| p.plan.arc_on_s),
            number(self.total_s, language),
        ]);
        let head = [
            "",
            "report-column-pass",
            "report-column-transfer-before-s",
            "report-column-start-s",
            "report-column-travel-s",
            "report-column-arc-on-s",
            "report-column-total-s",
        ];
        table(&language.words("report-caption-order-table"), &head.map(|head| language.words(head)), rows, 2..7)
    }
}
