//! Overview of a plan, at the top of its page.

use super::figures::{PassFigures, WeldReport};
use super::plan::PlanFigures;
use super::range::Range;
use crate::block::tile;
use crate::number::{NONE, Significant as _, fixed, number, range, significant, small};
use crate::{Language, Tile, Verdict, Words as _};
use seamwright_message::{Argument, Message, Unit};
use seamwright_program::{Severity, group_findings};
use seamwright_simulation::Summary;

/// Attitude errors above this are worth the reader's attention, degrees.
const ATTITUDE_DEG: f64 = 0.5;

impl WeldReport {
    /// Describes the checks that were made and their limits.
    pub(super) fn checked(&self, language: Language) -> String {
        let clearance = self.passes.iter().find_map(|p| p.clearance.as_ref());
        let message = match clearance {
            Some(c) => {
                let objects = c.objects.iter().map(|object| Argument::Message(Box::new(object.clone())));
                Message::new("report-checked").list("objects", objects)
            }
            None => Message::new("report-checked-without-shapes"),
        };
        message.in_language(language)
    }

    pub(super) fn verdict(&self, language: Language) -> Verdict {
        let slowed = self.passes.iter().map(|pass| &pass.plan).filter(|plan| !plan.speed_held);
        let planned = match slowed.map(|plan| plan.least_speed_mm_s).reduce(f64::min) {
            None => Message::new("report-verdict-planned"),
            Some(least) => Message::new("report-verdict-planned-slowed").significant("speed", least, Unit::MmPerS, 5),
        };
        let mut text = vec![planned];
        let outside = group_findings(&self.findings).iter().filter(|g| g.finding.kind == "procedure").count();
        text.extend(self.procedure.as_ref().map(|p| match outside {
            0 => Message::new("report-verdict-within").text("procedure", &p.number),
            n => Message::new("report-verdict-outside").text("procedure", &p.number).count("n", n),
        }));
        text.extend(self.worst_simulated().map(|(pass, s)| pass.plan.simulated(s)));
        let groups = group_findings(&self.findings);
        let count = |wanted: Severity| groups.iter().filter(|g| g.finding.severity() == wanted).count();
        let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
        if errors + warnings > 0 {
            text.push(Message::new("report-verdict-findings").count("errors", errors).count("warnings", warnings));
        }
        let text: Vec<String> = text.iter().map(|message| message.in_language(language)).collect();
        Verdict { ok: self.findings.iter().all(|f| f.allowed), text: language.sentences(&text) }
    }

    /// Returns the simulated pass with the maximum path error, if any was simulated.
    pub(super) fn worst_simulated(&self) -> Option<(&PassFigures, &Summary)> {
        let simulated = self.passes.iter().filter_map(|pass| Some((pass, pass.simulation.as_ref()?)));
        simulated.max_by(|a, b| a.1.path_error_mm.max.total_cmp(&b.1.path_error_mm.max))
    }

    /// Returns the totals of the weld: lengths, times, metal, consumables, energy and cost.
    pub(super) fn tiles(&self, language: Language) -> Vec<Tile> {
        let mut tiles = self.time_tiles(language);
        tiles.extend(self.consumption_tiles(language));
        tiles.extend(self.cost_tile(language));
        tiles.extend(self.worst_simulated().iter().flat_map(|(_, s)| simulated_tiles(s, language)));
        let plans = self.passes.iter().map(|pass| &pass.plan);
        let worst = plans.max_by(|a, b| a.attitude_error_deg.total_cmp(&b.attitude_error_deg));
        tiles.extend(
            worst.filter(|plan| plan.attitude_error_deg > ATTITUDE_DEG).map(|plan| plan.attitude_tile(language)),
        );
        tiles
    }

    fn time_tiles(&self, language: Language) -> Vec<Tile> {
        let totals = &self.totals;
        let tile = |label, value: f64, unit, note: Message| {
            tile(language, label, unit, number(value, language), note.in_language(language))
        };
        let mut of = match &self.seam {
            Some(seam) => Message::new("report-seam-length").significant("length", seam.length_mm, Unit::Mm, 5),
            None => Message::new("report-through-points"),
        };
        let mut travel = Message::new("report-travel");
        if totals.passes > 1 {
            of = Message::new("report-length-of-passes").message("of", of).count("n", totals.passes);
            of = of.significant("length", totals.length_mm, Unit::Mm, 5);
            travel = Message::new("report-travel-of-passes").count("n", totals.passes);
        }
        let length = self.seam.as_ref().map_or(totals.length_mm, |seam| seam.weld_length_mm);
        let parts = Message::new(if totals.wait_s > 0.0 { "report-total-parts-waiting" } else { "report-total-parts" });
        let parts = parts.significant("transfer", totals.air_s, Unit::S, 4);
        let parts = parts.significant("wait", totals.wait_s, Unit::S, 4);
        let duty = Message::new("report-duty").significant("part", totals.arc_percent, Unit::Percent, 3).significant(
            "duty",
            totals.duty_percent,
            Unit::Percent,
            3,
        );
        vec![
            tile("report-tile-weld-length", length, Unit::Mm, of),
            tile("report-tile-weld-time", totals.weld_s, Unit::S, travel),
            tile("report-tile-arc-on", totals.arc_on_s, Unit::S, duty),
            tile("report-tile-total", totals.total_s, Unit::S, parts),
        ]
    }

    fn consumption_tiles(&self, language: Language) -> Vec<Tile> {
        let totals = &self.totals;
        let positive = |value: Option<f64>| value.filter(|value| *value > 0.0);
        let tile = |label, value: f64, unit, note: Option<Message>| {
            let note = note.map_or_else(String::new, |note| note.in_language(language));
            tile(language, label, unit, significant(value, 4, language), note)
        };
        let length = |code, metres: f64| Message::new(code).significant("length", metres, Unit::M, 4);
        let wire = match (positive(totals.wire_kg), positive(totals.wire_m)) {
            (Some(kg), metres) => {
                let note = metres.map(|m| length("report-wire-length", m));
                Some(tile("report-tile-wire", kg, Unit::Kg, note))
            }
            (None, Some(m)) => Some(tile("report-tile-wire", m, Unit::M, Some(Message::new("report-wire-with-arc")))),
            (None, None) => None,
        };
        let energies = self.passes.iter().filter_map(|pass| pass.plan.arc_energy_kj_mm);
        let heat = self.passes.iter().filter_map(PassFigures::heat_input_kj_mm);
        let per_length = |label, ends: Range, code| {
            let note = Message::new(code).significant("min", ends.min, Unit::One, 3);
            let max = (1000.0 * ends.max).round() / 1000.0;
            ends.max.is_finite().then(|| tile(label, max, Unit::KiloJPerMm, Some(note)))
        };
        let heat = Range::of(heat.flat_map(|(min, max)| [min, max]).filter(|heat| heat.is_finite()));
        let energy = Range::of(energies.flat_map(|(min, max)| [min, max]));
        let mains = |kwh| Message::new("report-mains").significant("energy", kwh, Unit::KiloWh, 3);
        [
            positive(totals.weld_metal_kg).map(|kg| tile("report-tile-weld-metal", kg, Unit::Kg, None)),
            wire,
            positive(totals.gas_l).map(|l| tile("report-tile-gas", l, Unit::L, Some(Message::new("report-gas-time")))),
            positive(totals.flux_kg).map(|kg| tile("report-tile-flux", kg, Unit::Kg, None)),
            positive(totals.arc_energy_kj)
                .map(|kj| tile("report-tile-energy", kj, Unit::KiloJ, totals.mains_kwh.map(mains))),
            per_length("report-tile-heat-input", heat, "report-heat-input-range")
                .or_else(|| per_length("report-tile-arc-energy", energy, "report-arc-energy-range")),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn cost_tile(&self, language: Language) -> Option<Tile> {
        let cost = self.totals.cost.as_ref()?;
        let money = |value: f64| fixed(value, 2, language);
        let items = [
            ("report-cost-labour", cost.labour),
            ("report-cost-machine", cost.machine),
            ("report-cost-wire", cost.wire),
            ("report-cost-gas", cost.gas),
            ("report-cost-flux", cost.flux),
            ("report-cost-energy", cost.energy),
        ];
        let item =
            |(code, value): (&'static str, Option<f64>)| Some(format!("{} {}", language.words(code), money(value?)));
        let mut notes: Vec<String> = items.into_iter().filter_map(item).collect();
        if !cost.without.is_empty() {
            notes.push(language.words("report-cost-incomplete"));
        }
        Some(Tile {
            label: language.words("report-tile-cost"),
            value: money(cost.total),
            unit: cost.currency.clone(),
            note: notes.join(", "),
            severity: (!cost.without.is_empty()).then_some(crate::Severity::Warning),
        })
    }
}

fn simulated_tiles(s: &Summary, language: Language) -> [Tile; 2] {
    let (ripple, note) = match (&s.tip_speed_mm_s, s.speed_ripple) {
        (Some(v), Some(ripple)) => {
            let note = range("report-speed-range", (v.min, v.max), Unit::MmPerS);
            (small(100.0 * ripple, language), note.significant("rms", v.rms, Unit::MmPerS, 2))
        }
        _ => (NONE.to_owned(), Message::new("report-too-short")),
    };
    let error = Message::new("report-path-error-rms").significant("rms", s.path_error_mm.rms, Unit::Mm, 2);
    let path_error = small(s.path_error_mm.max, language);
    [
        tile(language, "report-tile-path-error", Unit::Mm, path_error, error.in_language(language)),
        tile(language, "report-tile-speed-ripple", Unit::Percent, ripple, note.in_language(language)),
    ]
}

impl PlanFigures {
    fn simulated(&self, s: &Summary) -> Message {
        let code = if s.speed_ripple.is_some() { "report-verdict-simulated" } else { "report-verdict-simulated-short" };
        let (path, speed) = (self.tolerance.path_mm.get(), self.tolerance.speed_percent.get());
        let message = Message::new(code).significant("error", s.path_error_mm.max, Unit::Mm, 2);
        let message = message.significant("allowed", path, Unit::Mm, 5);
        let Some(ripple) = s.speed_ripple else { return message };
        let message = message.significant("ripple", 100.0 * ripple, Unit::Percent, 2);
        message.significant("ripple_allowed", speed, Unit::Percent, 5)
    }

    fn attitude_tile(&self, language: Language) -> Tile {
        let error = significant(self.attitude_error_deg, 3, language);
        let note = language.words("report-attitude-error-of-plan");
        Tile {
            severity: Some(crate::Severity::Warning),
            ..tile(language, "report-tile-attitude-error", Unit::Deg, error, note)
        }
    }
}
