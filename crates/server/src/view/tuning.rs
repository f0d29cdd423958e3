use crate::wire::TuningView;
use seamwright_executive::Error;
use seamwright_machine::{Axis, AxisKind};
use seamwright_servo::{Tuned, decibels, unwrapped};
use seamwright_simulation::tune_axis;

/// Returns an axis tuned in simulation, as `machine tune` does it.
pub(crate) fn tuning_view(axis: &Axis, period_s: f64) -> TuningView {
    let tuned = tune_axis(axis, period_s);
    let refused = match &tuned {
        Ok(_) => None,
        Err(Error::Drive { reason, .. }) => Some(reason.into()),
        Err(other) => Some(other.message().into()),
    };
    let tuned = tuned.ok();
    let margins = tuned.as_ref().map(|t| t.margins);
    TuningView {
        axis: axis.name.clone(),
        unit: axis.unit().to_owned(),
        assumed_drive: axis.drive.is_none(),
        refused,
        response: tuned.as_ref().map_or(Vec::new(), response),
        gain_margin: margins
            .map(|m| [m.gain_margin_db, m.phase_crossover_hz])
            .filter(|pair| pair.iter().all(|v| v.is_finite())),
        phase_margin: margins.map(|m| [m.phase_margin_deg, m.gain_crossover_hz]),
        values: tuned.as_ref().map_or(Vec::new(), |t| values(axis, t)),
        settings: tuned.as_ref().map_or(Vec::new(), |t| settings(axis, t)),
        notches: tuned.as_ref().map_or(Vec::new(), notches),
    }
}

fn response(tuned: &Tuned) -> Vec<[f64; 3]> {
    let lines = tuned.response.iter().zip(unwrapped(&tuned.response));
    lines.map(|(line, phase)| [line.frequency_hz, decibels(line.ratio.norm()), phase.to_degrees()]).collect()
}

/// Rounds to 1e-6, below measurement accuracy, as `machine tune` writes values.
fn short(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn notches(t: &Tuned) -> Vec<[f64; 3]> {
    t.notches.iter().map(|n| [short(n.frequency_hz), n.depth, short(n.width_hz)]).collect()
}

/// Returns the settings for the machine file: the keys that `machine tune` writes.
fn settings(axis: &Axis, t: &Tuned) -> Vec<(String, f64)> {
    let unit = axis.unit();
    let force = if axis.kind == AxisKind::Linear { "n" } else { "n_m" };
    let mut list = vec![
        ("velocity_bandwidth_hz".to_owned(), short(t.velocity_bandwidth_hz)),
        ("kp_per_s".to_owned(), short(t.gains.kp)),
        ("kvff".to_owned(), short(t.gains.kvff)),
        ("kaff_s".to_owned(), short(t.gains.kaff)),
    ];
    if let Some(friction) = &t.friction {
        list.push((format!("friction_compensation_{force}"), short(friction.force)));
        list.push((format!("friction_smoothing_{unit}_s"), short(axis.to_file(friction.smoothing))));
    }
    if let Some(backlash) = &t.backlash {
        list.push((format!("backlash_compensation_{unit}"), short(axis.to_file(backlash.width))));
        list.push(("backlash_compensation_ms".to_owned(), short(backlash.time_s * 1e3)));
    }
    list
}

fn values(axis: &Axis, t: &Tuned) -> Vec<(String, f64)> {
    let unit = axis.unit();
    let mut list = vec![
        ("velocity_bandwidth_hz".to_owned(), t.velocity_bandwidth_hz),
        ("kp_per_s".to_owned(), t.gains.kp),
        ("kvff".to_owned(), t.gains.kvff),
        ("kaff_s".to_owned(), t.gains.kaff),
        ("bandwidth_hz".to_owned(), t.margins.bandwidth_hz),
        (format!("measured_at_{unit}_s"), axis.to_file(t.speed)),
        ("following_error_counts".to_owned(), t.following_counts),
        (format!("load_error_{unit}"), axis.to_file(t.load_error)),
    ];
    list.extend(t.resonance_hz.map(|hz| ("resonance_hz".to_owned(), hz)));
    list.extend(t.notches.iter().map(|notch| ("notch_hz".to_owned(), notch.frequency_hz)));
    list
}
