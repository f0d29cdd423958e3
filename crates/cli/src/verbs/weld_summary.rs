//! Summary of a planned or simulated weld at the command line.

use crate::labels::{labelled, line};
use crate::refusals::{range, unit_of};
use seamwright_executive::tracking::BeamSummary;
use seamwright_message::{Message, Unit};
use seamwright_program::group_findings;
use seamwright_project::failure::{places, severity_word};
use seamwright_project::files::written_text;
use seamwright_report::{PassFigures, WeldReport};
use seamwright_simulation::Summary;
use seamwright_simulation::tracking::HeadSummary;
use std::path::PathBuf;

pub(super) fn summary(r: &WeldReport, paths: &[PathBuf]) -> String {
    let mut text = format!("{}\n", r.title);
    labelled(&mut text, "cli-label-machine", &r.machine.title);
    if let Some(seam) = &r.seam {
        let message = Message::new("cli-summary-seam").quantity("length", seam.length_mm, Unit::Mm, 3);
        labelled(&mut text, "cli-label-seam", message.quantity("weld", seam.weld_length_mm, Unit::Mm, 3));
    }
    if let [pass] = r.passes.as_slice() {
        only_pass(&mut text, pass);
    } else {
        several_passes(&mut text, r);
    }
    consumption(&mut text, r);
    if r.totals.wait_s > 0.0 {
        let waits = Message::new("cli-summary-waits").quantity("time", r.totals.wait_s, Unit::S, 0);
        labelled(&mut text, "cli-label-waits", waits);
    }
    let transfers = Message::new("cli-summary-transfers").quantity("time", r.air_s, Unit::S, 2);
    labelled(&mut text, "cli-label-transfers", transfers.quantity("total", r.total_s, Unit::S, 2));
    for group in group_findings(&r.findings) {
        let finding = format!("{} ({})", group.message, places(&group));
        line(&mut text, &severity_word(group.finding), finding);
    }
    written_text(paths).iter().for_each(|files| labelled(&mut text, "cli-label-wrote", files));
    text
}

fn consumption(text: &mut String, r: &WeldReport) {
    let energy = r.totals.arc_energy_kj.filter(|kj| *kj > 0.0);
    let energy = energy.map(|kj| Message::new("cli-summary-takes-energy").quantity("energy", kj, Unit::KiloJ, 1));
    let wire = r.totals.wire_m.filter(|m| *m > 0.0);
    let wire = wire.map(|m| Message::new("cli-summary-takes-wire").quantity("wire", m, Unit::M, 2));
    let kg = |code, mass: Option<f64>| {
        mass.filter(|kg| *kg > 0.0).map(|kg| Message::new(code).quantity("mass", kg, Unit::Kg, 3))
    };
    let gas = r.totals.gas_l.map(|l| Message::new("cli-summary-takes-gas").quantity("gas", l, Unit::L, 0));
    let metal = kg("cli-summary-takes-metal", r.totals.weld_metal_kg);
    let takes = [energy, wire, metal, gas, kg("cli-summary-takes-flux", r.totals.flux_kg)];
    let takes: Vec<String> = takes.into_iter().flatten().map(|message| message.to_string()).collect();
    if !takes.is_empty() {
        labelled(text, "cli-label-takes", takes.join(", "));
    }
    let duty = Message::new("cli-summary-duty").quantity("part", r.totals.arc_percent, Unit::Percent, 1);
    labelled(text, "cli-label-duty", duty.quantity("duty", r.totals.duty_percent, Unit::Percent, 1));
    if let Some(cost) = &r.totals.cost {
        let complete = cost.without.is_empty();
        let message = Message::new(if complete { "cli-summary-cost" } else { "cli-summary-cost-incomplete" })
            .number("total", cost.total, 2)
            .text("currency", cost.currency.as_str());
        let message = if complete { message } else { message.text("without", cost.without.join(", ")) };
        labelled(text, "cli-label-cost", message);
    }
}

fn times(travel: f64, arc: f64, total: f64) -> Message {
    let times = Message::new("cli-summary-time").quantity("travel", travel, Unit::S, 2);
    times.quantity("arc", arc, Unit::S, 2).quantity("total", total, Unit::S, 2)
}

fn only_pass(text: &mut String, pass: &PassFigures) {
    let p = &pass.plan;
    let speed = Message::new("cli-summary-speed")
        .number("from", p.least_speed_mm_s, 4)
        .quantity("to", p.greatest_speed_mm_s, Unit::MmPerS, 4)
        .value("asked-from", p.asked_speed_mm_s.0, Unit::One)
        .value("asked-to", p.asked_speed_mm_s.1, Unit::One);
    labelled(text, "cli-label-speed", speed);
    labelled(text, "cli-label-time", times(p.weld_s, p.arc_on_s, p.total_s));
    if let Some(s) = &pass.simulation {
        simulated(text, s);
    }
    if let Some(energy) = energy_text(pass) {
        labelled(text, "cli-label-energy", energy);
    }
    if let Some(clearance) = clearance(pass) {
        labelled(text, "cli-label-clearance", clearance);
    }
}

/// Several passes: totals, then a line each, and the results of simulated ones.
fn several_passes(text: &mut String, r: &WeldReport) {
    let totals = &r.totals;
    let passes = Message::new("cli-summary-passes").number("passes", totals.passes as f64, 0);
    labelled(text, "cli-label-passes", passes.quantity("length", totals.length_mm, Unit::Mm, 3));
    labelled(text, "cli-label-time", times(totals.weld_s, totals.arc_on_s, totals.total_s));
    for (number, pass) in (1..).zip(&r.passes) {
        let p = &pass.plan;
        let quantity = |value, unit, decimals| Message::new("quantity").quantity("value", value, unit, decimals);
        let mut parts = vec![
            quantity(p.length_mm, Unit::Mm, 1).to_string(),
            range(p.least_speed_mm_s, p.greatest_speed_mm_s, Unit::MmPerS, 3).to_string(),
            quantity(p.weld_s, Unit::S, 2).to_string(),
        ];
        parts.extend(energy_text(pass));
        let clearance = clearance(pass).map(|c| Message::new("cli-summary-clearance").message("clearance", c));
        parts.extend(clearance.map(|clearance| clearance.to_string()));
        let label = Message::new("cli-label-pass").pass("pass", number).to_string();
        line(text, &label, format!("{}: {}", pass.name, parts.join(", ")));
        if let Some(s) = &pass.simulation {
            simulated(text, s);
        }
    }
}

/// Arc energy and, with a procedure, heat input of a pass.
fn energy_text(pass: &PassFigures) -> Option<String> {
    let from_to = |(low, high): (f64, f64)| match high - low < 1e-3 * high {
        true => Message::new("quantity").quantity("value", high, Unit::KiloJPerMm, 3),
        false => range(low, high, Unit::KiloJPerMm, 3),
    };
    let energy = pass.plan.arc_energy_kj_mm;
    let energy = energy.map(|energy| Message::new("cli-summary-arc-energy").message("energy", from_to(energy)));
    let heat = pass.heat_input_kj_mm();
    let heat = heat.map(|heat| Message::new("cli-summary-heat-input").message("heat", from_to(heat)));
    let both: Vec<String> = energy.into_iter().chain(heat).map(|message| message.to_string()).collect();
    (!both.is_empty()).then(|| both.join(", "))
}

fn clearance(pass: &PassFigures) -> Option<Message> {
    let c = pass.clearance.as_ref()?;
    Some(match &c.nearest {
        Some([first, second]) => {
            let between = Message::new("cli-clearance-between").quantity("distance", c.nearest_mm, Unit::Mm, 2);
            between.message("first", first.clone()).message("second", second.clone())
        }
        None => Message::new("cli-clearance-none").quantity("distance", c.nearest_mm, Unit::Mm, 2),
    })
}

fn simulated(text: &mut String, s: &Summary) {
    if !s.welded {
        labelled(text, "cli-label-welded", Message::new("cli-summary-not-welded"));
        return s.heads.iter().for_each(|head| tracked_head(text, head, false));
    }
    let e = &s.path_error_mm;
    let error = Message::new("cli-summary-path-error").quantity("max", e.max, Unit::Mm, 4);
    labelled(text, "cli-label-path-error", error.quantity("rms", e.rms, Unit::Mm, 4));
    s.heads.iter().for_each(|head| tracked_head(text, head, true));
    let speed = s.tip_speed_mm_s.as_ref().map_or(Message::new("cli-summary-too-short"), |v| {
        let speed = Message::new("cli-summary-tip-speed").number("from", v.min, 4);
        speed.quantity("to", v.max, Unit::MmPerS, 4).quantity("rms", v.rms, Unit::MmPerS, 4)
    });
    labelled(text, "cli-label-tip-speed", speed);
    for a in &s.axes {
        let f = &a.following_error;
        let worst = f.min.abs().max(f.max.abs());
        let error = Message::new("cli-summary-following-error").quantity("error", worst, unit_of(a.unit), 5);
        let label = Message::new("cli-label-axis").axis("axis", &a.axis).to_string();
        line(text, &label, error.number("rms", f.rms, 5));
    }
}

/// Deviation of a head's weld from a seam that is elsewhere than planned: tracked, and without.
fn tracked_head(text: &mut String, head: &HeadSummary, welded: bool) {
    if welded {
        let deviation = Message::new(if head.tracked { "cli-summary-tracked" } else { "cli-summary-untracked" })
            .quantity("p99", head.miss_p99_mm, Unit::Mm, 3)
            .quantity("max", head.miss_most_mm, Unit::Mm, 3);
        let plain = |deviation: Message| {
            let deviation = deviation.number("plain-p99", head.untracked_p99_mm, 3);
            deviation.quantity("plain-max", head.untracked_most_mm, Unit::Mm, 3)
        };
        line(text, &head.head, if head.tracked { plain(deviation) } else { deviation });
        if let Some(beam) = &head.beam {
            line(text, "", beam_message(beam));
        }
    }
    if let Some(at) = head.stopped_mm {
        let stopped = Message::new("cli-summary-stopped").quantity("at", at, Unit::Mm, 1);
        line(text, if welded { "" } else { &head.head }, stopped);
    }
    for alarm in &head.alarms {
        let message = Message::new("cli-summary-alarm").quantity("at", alarm.at_mm, Unit::Mm, 1);
        line(text, "", message.message("alarm", alarm.message()));
    }
}

fn beam_message(beam: &BeamSummary) -> Message {
    let mut message = Message::new("cli-summary-beam")
        .number("deflection", beam.deflected_mm, 3)
        .value("range", beam.range_mm, Unit::Mm)
        .quantity("carried", beam.carried_mm, Unit::Mm, 3)
        .quantity("away", beam.away_percent, Unit::Percent, 2)
        .quantity("longest", beam.longest_away_ms, Unit::Ms, 1);
    if let Some(fit) = &beam.fit {
        let points = Message::new("cli-summary-beam-fit").message("beam", message).count("points", fit.points);
        message = points.quantity("distance", fit.within_mm, Unit::Mm, 3);
    }
    match beam.replayed {
        true => Message::new("cli-summary-beam-replayed").message("beam", message),
        false => message,
    }
}
