//! What a plan comes to, at the top of its page.

use super::figures::WeldReport;
use super::page::{number, small};
use super::plan::PlanFigures;
use crate::{Language, Severity, Tile, Verdict, format_number, said};
use seamwright_cell::Summary;

impl WeldReport {
    /// What was looked at, and what not.
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
        let p = &self.plan;
        let held = match p.speed_held {
            true => language.say("the asked speed from run-up to run-down").to_owned(),
            false => language.fill("slowed to {0} mm/s where an axis needs it", &[&number(p.least_speed_mm_s)]),
        };
        let mut text = vec![language.fill("Planned: all axes within their limits, {0}.", &[&held])];
        let left = self.findings.iter().filter(|f| f.kind == "procedure").count();
        text.extend(self.procedure.as_ref().map(|p| match left {
            0 => language.fill("Within {0}.", &[&p.number]),
            1 => language.fill("Outside {0}: 1 finding.", &[&p.number]),
            n => language.fill("Outside {0}: {1} findings.", &[&p.number, &n.to_string()]),
        }));
        text.extend(self.simulation.as_ref().map(|s| p.simulated(s, language)));
        Verdict { ok: self.findings.iter().all(|f| f.allowed), text: text.join(language.between_sentences()) }
    }

    pub(super) fn tiles(&self, language: Language) -> Vec<Tile> {
        let p = &self.plan;
        let tile = |label, value: f64, unit, note| tile(language, (label, unit), number(value), note);
        let (length, of) = match &self.seam {
            Some(seam) => (seam.weld_length_mm, language.fill("seam {0} mm", &[&number(seam.length_mm)])),
            None => (p.length_mm, language.say("through points").to_owned()),
        };
        let cycle = language.fill("whole cycle {0} s, air moves {1} s", &[&number(self.total_s), &number(self.air_s)]);
        let speeds = language.fill("asked {0}, greatest {1}", &[&p.asked(language), &number(p.greatest_speed_mm_s)]);
        let mut tiles = vec![
            tile("Weld length", length, "mm", of),
            tile("Weld time", p.weld_s, "s", language.say("travel, rest to rest").to_owned()),
            tile("Arc-on time", p.arc_on_s, "s", cycle),
            tile("Speed, planned", p.least_speed_mm_s, "mm/s", speeds),
        ];
        tiles.extend(self.simulation.iter().flat_map(|s| simulated_tiles(s, language)));
        tiles.push(p.attitude_tile(language));
        tiles.extend(p.energy_tile(language));
        tiles
    }
}

fn tile(language: Language, (label, unit): (&'static str, &'static str), value: String, note: String) -> Tile {
    let unit = language.unit(unit).to_owned();
    Tile { label: language.say(label).to_owned(), value, unit, note, ..Tile::default() }
}

/// What the simulated pass did.
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
    /// The asked speed, or the range of those of several spans.
    fn asked(&self, language: Language) -> String {
        let (low, high) = self.asked_speed_mm_s;
        if high > low { language.fill("{0} to {1}", &[&number(low), &number(high)]) } else { number(low) }
    }

    /// What the simulated pass comes to, in words.
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

    /// Arc energy, if current and voltage are given.
    fn energy_tile(&self, language: Language) -> Option<Tile> {
        let (least, greatest) = self.arc_energy_kj_mm?;
        let note = if greatest - least < 1e-3 * greatest {
            language.say("U I / v, before any efficiency").to_owned()
        } else {
            language.fill("greatest; least {0}; U I / v", &[&format_number(least, 3)])
        };
        Some(tile(language, ("Arc energy", "kJ/mm"), format_number(greatest, 3), note))
    }
}
