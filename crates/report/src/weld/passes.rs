//! Tables by pass, and the passes whose curves stand for all.

use super::certificate::UseFigures;
use super::figures::{PassFigures, WeldReport};
use super::limits::{axes_table, uses_table};
use super::plan::AxisFigures;
use super::range::Range;
use super::simulated::simulation_text;
use super::tracking;
use crate::number::{NONE, Significant as _, from_to, number, significant, small};
use crate::{Block, Language, Table, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_simulation::Summary;
use seamwright_simulation::tracking::HeadSummary;

impl WeldReport {
    /// Returns one pass of each kind, in the order of welding: one with a finding against it, or else the longest. A
    /// pass without a role, as in a program of points, is alike only to those of its name.
    pub(super) fn typical_passes(&self) -> Vec<usize> {
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
    /// schedule, because the table would be wider than a page.
    pub(super) fn passes_table(&self, language: Language) -> Block {
        let any = |has: fn(&PassFigures) -> bool| self.passes.iter().any(has);
        let short = |of: Option<(f64, f64)>| optional(of.map(|range| Range::from(range).short_text(language)));
        let mut names: Vec<&String> = self.passes.iter().flat_map(|pass| pass.process_range.keys()).collect();
        names.sort_unstable();
        names.dedup();
        let mut table = Table::of(language, &self.passes);
        if any(|pass| pass.bead.is_some()) {
            table = table.number("report-column-bead", |pass| {
                let last = pass.last_bead.map_or(String::new(), |last| format!("–{last}"));
                optional(pass.bead.map(|bead| format!("{bead}{last}")))
            });
        }
        if any(|pass| pass.toe_deg.is_some()) {
            let toe = |pass: &&PassFigures| optional(pass.toe_deg.map(|(least, _)| number(least.round(), language)));
            table = table.number("report-column-toe-deg", toe);
        }
        for name in names {
            let value = |pass: &&PassFigures| pass.process_range.get(name).map(|r| Range::from(*r).text(language));
            table = table.column(value_names::value(language, name), true, |pass| optional(value(pass)));
        }
        table = table.number("report-column-speed-mm-s", |pass| {
            short(Some((pass.plan.least_speed_mm_s, pass.plan.greatest_speed_mm_s)))
        });
        if any(|pass| pass.stick_out_mm.is_some()) {
            table = table
                .number("report-column-stick-out", |pass| optional(pass.stick_out_mm.map(|mm| number(mm, language))));
        }
        // Heat input is the arc energy times the thermal efficiency: one of them is enough for a page.
        if any(|pass| pass.heat_input_kj_mm().is_some()) {
            table = table.number("report-column-heat-input", |pass| short(pass.heat_input_kj_mm()));
        } else if any(|pass| pass.plan.arc_energy_kj_mm.is_some()) {
            table = table.number("report-column-arc-energy", |pass| short(pass.plan.arc_energy_kj_mm));
        }
        let totals = &self.totals;
        table = table
            .number("report-column-length-mm", |pass| number(pass.plan.length_mm, language))
            .number("report-column-travel-s", |pass| number(pass.plan.weld_s, language));
        let mut sums = vec![number(totals.length_mm, language), number(totals.weld_s, language)];
        if let Some(wire) = totals.wire_m.filter(|wire| *wire > 0.0) {
            let metres = |pass: &&PassFigures| optional(pass.wire_m.map(|m| significant(m, 3, language)));
            table = table.number("report-column-wire-m", metres);
            sums.push(number(wire, language));
        }
        if let Some(metal) = totals.weld_metal_kg.filter(|metal| *metal > 0.0) {
            let mass = |pass: &&PassFigures| optional(pass.weld_metal_kg.map(|kg| significant(kg, 3, language)));
            table = table.number("report-column-weld-metal-kg", mass);
            sums.push(significant(metal, 4, language));
        }
        let mut table = self.by_pass(table.table(language.words("report-caption-passes")), language);
        // Sums are below the last columns.
        let mut row = vec![String::new(), in_one_line(&language.words("report-all-passes"))];
        row.resize(table.head.len() - sums.len(), String::new());
        table.rows.push([row, sums].concat());
        Block::Table(table)
    }

    pub(super) fn checks_table(&self, language: Language) -> Block {
        let mut table = Table::of(language, &self.passes)
            .number("report-column-at-requested-speed", |pass| {
                significant(pass.certificate.at_asked_percent, 3, language)
            })
            .number("report-column-attitude-error", |pass| small(pass.plan.attitude_error_deg, language));
        if self.passes.iter().any(|pass| pass.clearance.is_some()) {
            let nearest = |pass: &&PassFigures| match &pass.clearance {
                Some(c) if c.between.is_some() => number(c.nearest_mm, language),
                Some(c) => {
                    let message = Message::new("report-more-than").significant("value", c.nearest_mm, Unit::One, 5);
                    message.in_language(language)
                }
                None => NONE.to_owned(),
            };
            table = table.number("report-column-clearance", nearest).text("report-column-between", |pass| {
                optional(pass.clearance.as_ref().and_then(|c| c.between_text(language)))
            });
        }
        Block::Table(self.by_pass(table.table(language.words("report-caption-checks")), language))
    }

    /// Returns the ranges of the axes and how much of their limits is used, over all passes.
    pub(super) fn axes_of_all(&self, language: Language) -> [Block; 2] {
        [axes_table(&self.axis_ranges(), language), uses_table(&self.axis_uses(), language)]
    }

    fn axis_ranges(&self) -> Vec<AxisFigures> {
        let mut passes = self.passes.iter().map(|pass| &pass.plan.axes);
        let mut all = passes.next().cloned().unwrap_or_default();
        for axes in passes {
            for (all, axis) in all.iter_mut().zip(axes) {
                (all.min, all.max) = (all.min.min(axis.min), all.max.max(axis.max));
            }
        }
        all
    }

    fn axis_uses(&self) -> Vec<UseFigures> {
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

    pub(super) fn simulated_of_all(&self, language: Language) -> Vec<Block> {
        let Some((_, worst)) = self.worst_simulated() else { return Vec::new() };
        let simulated = |pass: &PassFigures, of: fn(&Summary) -> Option<f64>| {
            optional(pass.simulation.as_ref().and_then(of).map(|value| small(value, language)))
        };
        let table = Table::of(language, &self.passes)
            .number("report-column-path-error-mm", |p| simulated(p, |s| s.welded.then_some(s.path_error_mm.max)))
            .number("report-column-rms-mm", |p| simulated(p, |s| s.welded.then_some(s.path_error_mm.rms)))
            .number("report-column-speed-ripple", |p| simulated(p, |s| s.speed_ripple.map(|ripple| 100.0 * ripple)))
            .table(language.words("report-caption-simulated-passes"));
        let text = simulation_text(worst, &self.machine.assumed_drives, language);
        vec![Block::Paragraph(text), Block::Table(self.by_pass(table, language))]
    }

    /// Returns the deviation of each pass from the joint, and the corrections of beams, if any pass was tracked.
    pub(super) fn tracked_of_all(&self, language: Language) -> Vec<Block> {
        let heads = |pass: &PassFigures| pass.simulation.as_ref().map_or_else(Vec::new, |s| s.heads.clone());
        let all: Vec<HeadSummary> = self.passes.iter().flat_map(heads).collect();
        if all.is_empty() {
            return Vec::new();
        }
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

    /// Joins rows of consecutive passes with equal cells, and adds the numbers and names of their passes in front.
    pub(super) fn by_pass(&self, table: Table, language: Language) -> Table {
        let mut joined: Vec<(usize, usize, Vec<String>)> = Vec::new();
        for (i, cells) in table.rows.into_iter().enumerate() {
            match joined.last_mut() {
                Some((_, last, same)) if *same == cells => *last = i,
                _ => joined.push((i, i, cells)),
            }
        }
        let rows = joined.into_iter().map(|(first, last, cells)| {
            let (number, name) = ((first + 1).to_string(), in_one_line(&self.passes[first].name));
            let front = match first == last {
                true => vec![number, name],
                false => {
                    let numbers = from_to(number, (last + 1).to_string(), language);
                    vec![numbers, format!("{name} … {}", self.passes[last].name)]
                }
            };
            [front, cells].concat()
        });
        let front = ["report-column-pass", "report-column-name"].map(|head| language.words(head));
        Table {
            rows: rows.collect(),
            head: [front.to_vec(), table.head].concat(),
            numeric: [vec![false; 2], table.numeric].concat(),
            caption: table.caption,
            sortable: table.sortable,
        }
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

/// Longest name of a pass that is not broken over lines, in characters.
const UNBROKEN: usize = 12;

/// Returns a short name with spaces at which no line breaks.
fn in_one_line(name: &str) -> String {
    if name.chars().count() <= UNBROKEN { name.replace(' ', "\u{a0}") } else { name.to_owned() }
}

fn optional(text: Option<String>) -> String {
    text.unwrap_or_else(|| NONE.to_owned())
}

impl WeldReport {
    pub(super) fn order_table(&self, language: Language) -> Block {
        let number = |value| number(value, language);
        let mut start_s = 0.0;
        let mut started = |pass: &PassFigures| {
            start_s += pass.air_before_s + pass.wait_before_s;
            let started = number(start_s);
            start_s += pass.plan.total_s;
            started
        };
        let mut table = Table::of(language, self.passes.iter().zip(1..))
            .text("", |(_, i): &(_, i32)| i.to_string())
            .text("report-column-pass", |(pass, _)| pass.name.clone())
            .number("report-column-transfer-before-s", |(pass, _)| number(pass.air_before_s));
        if self.totals.wait_s > 0.0 {
            table = table.number("report-column-wait-before-s", |(pass, _)| number(pass.wait_before_s));
        }
        let mut table = table
            .number("report-column-start-s", |(pass, _)| started(pass))
            .number("report-column-travel-s", |(pass, _)| number(pass.plan.weld_s))
            .number("report-column-arc-on-s", |(pass, _)| number(pass.plan.arc_on_s))
            .number("report-column-total-s", |(pass, _)| number(pass.plan.total_s))
            .table(language.words("report-caption-order-table"));
        let mut sums = vec![String::new(), language.words("report-all-from-home"), number(self.air_s)];
        sums.extend((self.totals.wait_s > 0.0).then(|| number(self.totals.wait_s)));
        sums.extend([String::new(), number(self.totals.weld_s), number(self.totals.arc_on_s), number(self.total_s)]);
        table.rows.push(sums);
        Block::Table(table)
    }
}
