//! Report of a tuning: table, JSON, Bode plot and lines to paste.

use crate::labels::{columns, labelled, padded};
use crate::refusals::unit_of;
use crate::rows::in_english;
use seamwright_executive::Error;
use seamwright_machine::{Axis, AxisKind};
use seamwright_message::{Language, Message, Unit};
use seamwright_report::{Bode, format_number};
use seamwright_servo::{Tuned, decibels, unwrapped};
use serde::Serialize;
use std::fmt::Write;

/// Columns of the table.
const COLUMNS: usize = 12;

/// The tuning of one axis; mm or degrees, as in files.
#[derive(Debug, Serialize)]
pub(super) struct AxisTuning {
    pub(super) axis: String,
    /// `mm` or `deg`.
    unit: &'static str,
    /// True if the machine file describes no drive: an assumed one was tuned.
    assumed_drive: bool,
    pub(super) tuned: Option<Settings>,
    /// Reason why it cannot be tuned; as JSON its English words.
    #[serde(serialize_with = "in_english")]
    refused: Option<Message>,
    #[serde(skip)]
    force_unit: &'static str,
    #[serde(skip)]
    response: Vec<(f64, f64, f64)>,
}

#[derive(Debug, Serialize)]
pub(super) struct Settings {
    velocity_bandwidth_hz: f64,
    kp_per_s: f64,
    ki_per_s2: f64,
    kd: f64,
    kvff: f64,
    kaff_s: f64,
    notches: Vec<Notch>,
    friction_compensation: Option<f64>,
    friction_smoothing: Option<f64>,
    backlash_compensation: Option<f64>,
    backlash_compensation_ms: Option<f64>,
    resonance_hz: Option<f64>,
    /// Speed at which all was measured, unit/s.
    speed: f64,
    bandwidth_hz: f64,
    /// `None` if the phase never reaches -180 degrees.
    gain_margin_db: Option<f64>,
    phase_crossover_hz: Option<f64>,
    phase_margin_deg: f64,
    gain_crossover_hz: f64,
    peak_db: f64,
    following_error_counts: f64,
    /// Distance of the load from its set position at that speed, in the unit.
    load_error: f64,
}

#[derive(Debug, Serialize)]
struct Notch {
    frequency_hz: f64,
    depth: f64,
    width_hz: f64,
}

impl AxisTuning {
    pub(super) fn new(axis: &Axis, tuned: Result<Tuned, Error>) -> Self {
        let (response, refused) = match &tuned {
            Ok(tuned) => (response(tuned), None),
            Err(Error::Drive { reason, .. }) => (Vec::new(), Some(reason.clone())),
            Err(other) => (Vec::new(), Some(other.message())),
        };
        Self {
            axis: axis.name.clone(),
            unit: axis.unit(),
            assumed_drive: axis.drive.is_none(),
            tuned: tuned.ok().map(|t| Settings::new(axis, &t)),
            refused,
            force_unit: if axis.kind == AxisKind::Linear { "n" } else { "n_m" },
            response,
        }
    }

    pub(super) fn bode(&self) -> Option<Bode> {
        let t = self.tuned.as_ref()?;
        let none = |v: Option<f64>| v.unwrap_or(f64::NAN);
        Some(Bode {
            language: Language::of_process(),
            title: Message::new("cli-tune-bode")
                .axis("axis", &self.axis)
                .value("speed", rounded(t.speed), if self.unit == "mm" { Unit::MmPerS } else { Unit::DegPerS })
                .to_string(),
            lines: self.response.clone(),
            gain_margin: (t.gain_margin_db.unwrap_or(f64::INFINITY), none(t.phase_crossover_hz)),
            phase_margin: (t.phase_margin_deg, t.gain_crossover_hz),
        })
    }
}

/// Frequency, decibels and degrees.
fn response(tuned: &Tuned) -> Vec<(f64, f64, f64)> {
    let lines = tuned.response.iter().zip(unwrapped(&tuned.response));
    lines.map(|(line, phase)| (line.frequency_hz, decibels(line.ratio.norm()), phase.to_degrees())).collect()
}

impl Settings {
    fn new(axis: &Axis, t: &Tuned) -> Self {
        let finite = |v: f64| v.is_finite().then_some(v);
        let notch = |n: &seamwright_servo::NotchSettings| Notch {
            frequency_hz: n.frequency_hz,
            depth: n.depth,
            width_hz: n.width_hz,
        };
        Self {
            velocity_bandwidth_hz: t.velocity_bandwidth_hz,
            kp_per_s: t.gains.kp,
            ki_per_s2: t.gains.ki,
            kd: t.gains.kd,
            kvff: t.gains.kvff,
            kaff_s: t.gains.kaff,
            notches: t.notches.iter().map(notch).collect(),
            friction_compensation: t.friction.map(|f| f.force),
            friction_smoothing: t.friction.map(|f| axis.to_file(f.smoothing)),
            backlash_compensation: t.backlash.map(|b| axis.to_file(b.width)),
            backlash_compensation_ms: t.backlash.map(|b| b.time_s * 1e3),
            resonance_hz: t.resonance_hz,
            speed: axis.to_file(t.speed),
            bandwidth_hz: t.margins.bandwidth_hz,
            gain_margin_db: finite(t.margins.gain_margin_db),
            phase_crossover_hz: finite(t.margins.phase_crossover_hz),
            phase_margin_deg: t.margins.phase_margin_deg,
            gain_crossover_hz: t.margins.gain_crossover_hz,
            peak_db: t.margins.peak_db,
            following_error_counts: t.following_counts,
            load_error: axis.to_file(t.load_error),
        }
    }
}

fn rounded(value: f64) -> f64 {
    short(value).parse().unwrap_or(value)
}

/// Four digits: more than any setting needs.
fn short(v: f64) -> String {
    format_number(v, 4)
}

/// The table, an axis a row, and under it the axes that could not be tuned.
pub(super) fn table(machine: &str, tunings: &[AxisTuning]) -> String {
    let mut text = format!("  {}\n\n", Message::new("cli-tune-heading").text("machine", machine));
    let mut rows = vec![head(), units()];
    rows.extend(tunings.iter().filter_map(|t| Some(row(t, t.tuned.as_ref()?))));
    let wide = |column: usize| rows.iter().map(|r| columns(&r[column])).max().unwrap_or(0);
    let widths: Vec<usize> = (0..COLUMNS).map(wide).collect();
    for row in &rows {
        let cells = row.iter().zip(&widths).enumerate();
        let line: String = cells
            .map(|(i, (cell, width))| match i {
                0 => format!("  {}", padded(cell, *width)),
                _ => format!("  {}{cell}", " ".repeat(width - columns(cell))),
            })
            .collect();
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text.push('\n');
    for t in tunings {
        if let Some(why) = &t.refused {
            let refused = Message::new("cli-tune-refused").axis("axis", &t.axis).message("why", why.clone());
            labelled(&mut text, "cli-label-not-tuned", refused);
        }
        if t.assumed_drive {
            let assumed = Message::new("cli-tune-assumed").axis("axis", &t.axis);
            labelled(&mut text, "cli-label-assumed", assumed);
        }
    }
    text
}

fn words(code: &'static str) -> String {
    Message::new(code).to_string()
}

fn head() -> [String; COLUMNS] {
    [
        words("cli-tune-axis"),
        words("cli-tune-velocity-loop"),
        "kp".to_owned(),
        "kaff".to_owned(),
        words("cli-tune-notches"),
        words("cli-tune-resonance"),
        words("cli-tune-crossover"),
        words("cli-tune-bandwidth"),
        words("cli-tune-gain-margin"),
        words("cli-tune-phase-margin"),
        words("cli-tune-following"),
        words("cli-tune-load"),
    ]
}

fn units() -> [String; COLUMNS] {
    let hz = words("cli-tune-hz");
    [
        String::new(),
        hz.clone(),
        words("cli-tune-per-s"),
        words("cli-tune-ms"),
        hz.clone(),
        hz.clone(),
        hz.clone(),
        hz,
        words("cli-tune-db"),
        "°".to_owned(),
        words("cli-tune-counts"),
        String::new(),
    ]
}

fn row(tuning: &AxisTuning, t: &Settings) -> [String; COLUMNS] {
    let with_unit = |v: f64, unit, decimals| Message::new("quantity").quantity("value", v, unit, decimals).to_string();
    let number = |v: f64, decimals| with_unit(v, Unit::One, decimals);
    let notch = |n: &Notch| Message::new("quantity").value("value", rounded(n.frequency_hz), Unit::One).to_string();
    let notches: Vec<String> = t.notches.iter().map(notch).collect();
    let or_dash = |v: Option<f64>, decimals| v.map_or("-".to_owned(), |v| number(v, decimals));
    [
        tuning.axis.clone(),
        number(t.velocity_bandwidth_hz, 1),
        number(t.kp_per_s, 1),
        number(1e3 * t.kaff_s, 2),
        if notches.is_empty() { "-".to_owned() } else { notches.join(" ") },
        or_dash(t.resonance_hz, 1),
        number(t.gain_crossover_hz, 1),
        number(t.bandwidth_hz, 1),
        or_dash(t.gain_margin_db, 1),
        number(t.phase_margin_deg, 0),
        number(t.following_error_counts, 2),
        with_unit(t.load_error, unit_of(tuning.unit), 4),
    ]
}

/// Tables of a machine file with the settings as keys.
pub(super) fn snippet(file: &str, tunings: &[AxisTuning]) -> String {
    let mut text = format!(
        "# Settings for {file}, by `seamwright machine tune`.\n# Put the keys into the tables of these names, in place of those that are there.\n"
    );
    for tuning in tunings {
        let AxisTuning { axis, unit, force_unit, .. } = tuning;
        let Some(t) = &tuning.tuned else {
            let why = tuning.refused.as_ref().map_or_else(String::new, |why| why.in_language(Language::English));
            let _ = write!(text, "\n# {axis} could not be tuned: {why}\n");
            continue;
        };
        let _ = write!(text, "\n[drives.{axis}]\n");
        let mut key = |name: &str, value: f64| {
            let _ = writeln!(text, "{name} = {}", short(value));
        };
        key("velocity_bandwidth_hz", t.velocity_bandwidth_hz);
        key("kp_per_s", t.kp_per_s);
        key("kvff", t.kvff);
        key("kaff_s", t.kaff_s);
        if let (Some(force), Some(smoothing)) = (t.friction_compensation, t.friction_smoothing) {
            key(&format!("friction_compensation_{force_unit}"), force);
            key(&format!("friction_smoothing_{unit}_s"), smoothing);
        }
        if let (Some(width), Some(time)) = (t.backlash_compensation, t.backlash_compensation_ms) {
            key(&format!("backlash_compensation_{unit}"), width);
            key("backlash_compensation_ms", time);
        }
        let notch = |n: &Notch| {
            let Notch { frequency_hz, depth, width_hz } = n;
            format!("{{ frequency_hz = {}, depth = {}, width_hz = {} }}", short(*frequency_hz), depth, short(*width_hz))
        };
        let notches: Vec<String> = t.notches.iter().map(notch).collect();
        if !notches.is_empty() {
            let _ = writeln!(text, "notches = [{}]", notches.join(", "));
        }
        let gain = t.gain_margin_db.map_or("unbounded".to_owned(), |db| format!("{db:.1} dB"));
        let _ = writeln!(
            text,
            "# gain margin {gain}, phase margin {:.0} deg, bandwidth {:.1} Hz",
            t.phase_margin_deg, t.bandwidth_hz
        );
    }
    text
}
