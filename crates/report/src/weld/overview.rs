//! Overview of a plan, at the top of its page.

use super::figures::{PassFigures, WeldReport};
use super::page::{number, small};
use super::plan::PlanFigures;
use crate::Phrases as _;
use crate::{Language, Severity, Tile, Verdict, format_number, said};
use seamwright_cell::Summary;
use seamwright_program::group_findings;

impl WeldReport {
    /// Describes the checks that were made and their limits.
    pub(super) fn checked(&self, language: Language) -> String {
        let watched = self.passes.iter().find_map(|p| p.clearance.as_ref());
        let clearance = match watched {
            Some(c) => {
                let names: Vec<String> = c.watched.iter().map(|name| said::watched(language, name)).collect();
                language.fill(
                    "the distances from one another of {0}, along the passes and in the air moves, as far as the files give their shapes. Not checked: what is not in this list, parts beyond the lengths that the job gives them, cables and hoses.",
                    &[&names.join(", ")],
                )
            }
            None => language.say("nothing about collisions: the machine file has no shapes.").to_owned(),
        };
        language.fill(
            "Checked: reach, ranges, speeds, accelerations and jerks of the axes, that the torch axis stays clear of both faces, and {0}",
            &[&clearance],
        )
    }

    pub(super) fn verdict(&self, language: Language) -> Verdict {
        let slowed = self.passes.iter().map(|pass| &pass.plan).filter(|plan| !plan.speed_held);
        let held = match slowed.map(|plan| plan.least_speed_mm_s).reduce(f64::min) {
            None => language.say("the asked speed from run-up to run-down").to_owned(),
            Some(least) => language.fill("slowed to {0} mm/s where an axis needs it", &[&number(least)]),
        };
        let mut text = vec![language.fill("Planned: all axes within their limits, {0}.", &[&held])];
        let left = group_findings(&self.findings).iter().filter(|g| g.finding.kind == "procedure").count();
        text.extend(self.procedure.as_ref().map(|p| match left {
            0 => language.fill("Within {0}.", &[&p.number]),
            1 => language.fill("Outside {0}: 1 finding.", &[&p.number]),
            n => language.fill("Outside {0}: {1} findings.", &[&p.number, &n.to_string()]),
        }));
        text.extend(self.worst_simulated().map(|(pass, s)| pass.plan.simulated(s, language)));
        Verdict { ok: self.findings.iter().all(|f| f.allowed), text: text.join(language.between_sentences()) }
    }

    /// Returns the simulated pass with the maximum path error, if any was simulated.
    pub(super) fn worst_simulated(&self) -> Option<(&PassFigures, &Summary)> {
        let simulated = self.passes.iter().filter_map(|pass| Some((pass, pass.simulation.as_ref()?)));
        simulated.max_by(|a, b| a.1.path_error_mm.max.total_cmp(&b.1.path_error_mm.max))
    }

    /// Returns the key figures of the weld; with several passes sums, and the extremes of all passes.
    pub(super) fn tiles(&self, language: Language) -> Vec<Tile> {
        let totals = &self.totals;
        let tile = |label, value: f64, unit, note| tile(language, (label, unit), number(value), note);
        let mut of = match &self.seam {
            Some(seam) => language.fill("seam {0} mm", &[&number(seam.length_mm)]),
            None => language.say("through points").to_owned(),
        };
        let mut travel = language.say("travel, rest to rest").to_owned();
        if totals.passes > 1 {
            let count = totals.passes.to_string();
            of = language.fill("{0}; {1} passes, {2} mm in all", &[&of, &count, &number(totals.length_mm)]);
            travel = language.fill("travel of all {0} passes, rest to rest", &[&count]);
        }
        let length = self.seam.as_ref().map_or(totals.length_mm, |seam| seam.weld_length_mm);
        let cycle =
            language.fill("whole cycle {0} s, air moves {1} s", &[&number(totals.total_s), &number(totals.air_s)]);
        let plans = || self.passes.iter().map(|pass| &pass.plan);
        let asked = extremes(plans().flat_map(|plan| [plan.asked_speed_mm_s.0, plan.asked_speed_mm_s.1]));
        let (least, greatest) = extremes(plans().flat_map(|plan| [plan.least_speed_mm_s, plan.greatest_speed_mm_s]));
        let speeds = language.fill("asked {0}, greatest {1}", &[&range(asked, language), &number(greatest)]);
        let mut tiles = vec![
            tile("Weld length", length, "mm", of),
            tile("Weld time", totals.weld_s, "s", travel),
            tile("Arc-on time", totals.arc_on_s, "s", cycle),
            tile("Speed, planned", least, "mm/s", speeds),
        ];
        tiles.extend(self.worst_simulated().iter().flat_map(|(_, s)| simulated_tiles(s, language)));
        let worst = plans().max_by(|a, b| a.attitude_error_deg.total_cmp(&b.attitude_error_deg));
        tiles.extend(worst.map(|plan| plan.attitude_tile(language)));
        let energies = plans().filter_map(|plan| plan.arc_energy_kj_mm).flat_map(|(least, greatest)| [least, greatest]);
        tiles.extend(energy_tile(extremes(energies), language));
        let wire = |metres: f64| tile("Wire", metres, "m", language.say("while the arc is on").to_owned());
        tiles.extend(totals.wire_m.filter(|metres| *metres > 0.0).map(wire));
        tiles
    }
}

/// Returns minimum and maximum of the values; (∞, -∞) if empty.
pub(super) fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), v| (least.min(v), greatest.max(v)))
}

/// Formats a value, or the range of several.
pub(super) fn range((low, high): (f64, f64), language: Language) -> String {
    if high > low { language.fill("{0} to {1}", &[&number(low), &number(high)]) } else { number(low) }
}

fn tile(language: Language, (label, unit): (&'static str, &'static str), value: String, note: String) -> Tile {
    let unit = language.unit(unit).to_owned();
    Tile { label: language.say(label).to_owned(), value, unit, note, ..Tile::default() }
}

/// Returns the key figures of the simulated pass.
fn simulated_tiles(s: &Summary, language: Language) -> [Tile; 2] {
    let (ripple, note) = match (&s.tip_speed_mm_s, s.speed_ripple) {
        (Some(v), Some(ripple)) => {
            let of = [number(v.min), number(v.max), small(v.rms)];
            let note = language.fill("{0} to {1} mm/s, RMS {2} mm/s", &of.each_ref().map(String::as_str));
            (small(100.0 * ripple), note)
        }
        _ => ("–".to_owned(), language.say("too short a weld to judge").to_owned()),
    };
    let error = language.fill("greatest; RMS {0} mm", &[&small(s.path_error_mm.rms)]);
    [
        tile(language, ("Path error, simulated", "mm"), small(s.path_error_mm.max), error),
        tile(language, ("Speed ripple, simulated", "%"), ripple, note),
    ]
}

impl PlanFigures {
    /// Describes the result of the simulated pass.
    fn simulated(&self, s: &Summary, language: Language) -> String {
        let speed = match s.speed_ripple {
            Some(r) => {
                let (found, allowed) = (small(100.0 * r), number(self.tolerance.speed_percent.get()));
                language.fill("speed within {0} % of {1} allowed", &[&found, &allowed])
            }
            None => language.say("too short to judge its speed").to_owned(),
        };
        language.fill(
            "Simulated: path error at most {0} mm of {1} allowed, {2}.",
            &[&small(s.path_error_mm.max), &number(self.tolerance.path_mm.get()), &speed],
        )
    }

    fn attitude_tile(&self, language: Language) -> Tile {
        let (error, note) = (format_number(self.attitude_error_deg, 3), language.say("greatest, of the plan"));
        Tile {
            severity: (self.attitude_error_deg > 0.5).then_some(Severity::Warning),
            ..tile(language, ("Attitude error", "deg"), error, note.to_owned())
        }
    }
}

/// Returns the arc energy, if current and voltage are given.
fn energy_tile((least, greatest): (f64, f64), language: Language) -> Option<Tile> {
    if !greatest.is_finite() {
        return None;
    }
    let note = if greatest - least < 1e-3 * greatest {
        language.say("U I / v, before any efficiency").to_owned()
    } else {
        language.fill("greatest; least {0}; U I / v", &[&format_number(least, 3)])
    };
    Some(tile(language, ("Arc energy", "kJ/mm"), format_number(greatest, 3), note))
}
