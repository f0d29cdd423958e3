//! Overview of a plan, at the top of its page.

use super::figures::{PassFigures, WeldReport};
use super::plan::PlanFigures;
use super::range::Range;
use crate::block::tile;
use crate::number::{NONE, Significant as _, number, range, significant, small};
use crate::{Language, Severity, Tile, Verdict, Words as _};
use seamwright_message::{Argument, Message, Unit};
use seamwright_program::group_findings;
use seamwright_simulation::Summary;

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
        let text: Vec<String> = text.iter().map(|message| message.in_language(language)).collect();
        Verdict { ok: self.findings.iter().all(|f| f.allowed), text: language.sentences(&text) }
    }

    /// Returns the simulated pass with the maximum path error, if any was simulated.
    pub(super) fn worst_simulated(&self) -> Option<(&PassFigures, &Summary)> {
        let simulated = self.passes.iter().filter_map(|pass| Some((pass, pass.simulation.as_ref()?)));
        simulated.max_by(|a, b| a.1.path_error_mm.max.total_cmp(&b.1.path_error_mm.max))
    }

    /// Returns the key figures of the weld; with several passes sums, and the extremes of all passes.
    pub(super) fn tiles(&self, language: Language) -> Vec<Tile> {
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
        let cycle = Message::new("report-cycle").significant("total", totals.total_s, Unit::S, 5);
        let cycle = cycle.significant("transfer", totals.air_s, Unit::S, 5);
        let plans = || self.passes.iter().map(|pass| &pass.plan);
        let asked = Range::of(plans().flat_map(|plan| [plan.asked_speed_mm_s.0, plan.asked_speed_mm_s.1]));
        let planned = Range::of(plans().flat_map(|plan| [plan.least_speed_mm_s, plan.greatest_speed_mm_s]));
        let speeds = Message::new("report-speed-requested").text("requested", asked.text(language));
        let speeds = speeds.significant("max", planned.max, Unit::One, 5);
        let mut tiles = vec![
            tile("report-tile-weld-length", length, Unit::Mm, of),
            tile("report-tile-weld-time", totals.weld_s, Unit::S, travel),
            tile("report-tile-arc-on", totals.arc_on_s, Unit::S, cycle),
            tile("report-tile-speed", planned.min, Unit::MmPerS, speeds),
        ];
        tiles.extend(self.worst_simulated().iter().flat_map(|(_, s)| simulated_tiles(s, language)));
        let worst = plans().max_by(|a, b| a.attitude_error_deg.total_cmp(&b.attitude_error_deg));
        tiles.extend(worst.map(|plan| plan.attitude_tile(language)));
        let energies = plans().filter_map(|plan| plan.arc_energy_kj_mm).flat_map(|(least, greatest)| [least, greatest]);
        tiles.extend(energy_tile(Range::of(energies), language));
        let wire = |metres: f64| tile("report-tile-wire", metres, Unit::M, Message::new("report-wire-with-arc"));
        tiles.extend(totals.wire_m.filter(|metres| *metres > 0.0).map(wire));
        tiles
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
            severity: (self.attitude_error_deg > 0.5).then_some(Severity::Warning),
            ..tile(language, "report-tile-attitude-error", Unit::Deg, error, note)
        }
    }
}

fn energy_tile(energy_kj_mm: Range, language: Language) -> Option<Tile> {
    let Range { min, max } = energy_kj_mm;
    if !max.is_finite() {
        return None;
    }
    let note = match max - min < 1e-3 * max {
        true => Message::new("report-arc-energy-formula"),
        false => Message::new("report-arc-energy-range").significant("min", min, Unit::One, 3),
    };
    let value = significant(max, 3, language);
    Some(tile(language, "report-tile-arc-energy", Unit::KiloJPerMm, value, note.in_language(language)))
}
