//! An independent checker of certificates. Its only inputs are the rows of `motion`, the machine file's limits, and the
//! tip's position by `kinematics`; it calls no code of the planner.
//!
//! Bounds by differences over a period T:
//! - A first, second or third difference by T, T^2 or T^3 is a weighted mean of the speed, acceleration or jerk. It
//!   covers one, two or three periods; the weights are those of a B-spline, none negative. So it never exceeds the
//!   maximum of them, nor the limit: the only allowance upwards is rounding.
//! - A number q in the table is off by `e`: a few units in its last place and the axis motion within the rounding of
//!   the time. Differences of order n then are off by `2^n e / T^n`.
//! - Downwards, the maximum speed by differences falls short of the true one by at most `T/2` times the maximum
//!   acceleration. The maximum acceleration falls short by at most `T` times the maximum jerk. Jerk may jump, but in a
//!   weld it lasts for many periods, and over one it changes little. [`jerk_short`] bounds the shortfall of its means
//!   over three periods.

use super::{column, good, run_with, table};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use toml_edit::{DocumentMut, Item};

/// An axis' limits in file units: speed, acceleration, jerk.
pub type Limits = BTreeMap<String, [f64; 3]>;

/// The limits in a machine file.
pub fn limits(machine: &str) -> Limits {
    let file: DocumentMut = machine.parse().unwrap();
    let mut limits = Limits::new();
    axes(file.as_item(), &mut limits);
    limits
}

fn axes(item: &Item, limits: &mut Limits) {
    let Some(table) = item.as_table_like() else {
        item.as_array_of_tables().into_iter().flatten().for_each(|t| axes(&Item::Table(t.clone()), limits));
        return;
    };
    if let Some(name) = table.get("axis").and_then(Item::as_str) {
        let number = |key: &str| {
            ["mm", "deg"].iter().find_map(|unit| {
                let item = table.get(&key.replace('#', unit))?;
                item.as_float().or(item.as_integer().map(|i| i as f64))
            })
        };
        let (speed, acceleration) = (number("max_speed_#_s").unwrap(), number("max_acceleration_#_s2").unwrap());
        // Default of docs/reference/machine.md: without a jerk, full acceleration within 20 ms.
        let jerk = number("max_jerk_#_s3").unwrap_or(50.0 * acceleration);
        limits.insert(name.to_owned(), [speed, acceleration, jerk]);
    }
    table.iter().for_each(|(_, inner)| {
        if inner.is_table() || inner.is_array_of_tables() {
            axes(inner, limits);
        }
    });
}

/// A motion as a stranger sees it.
#[derive(Clone)]
pub struct Motion {
    pub period: f64,
    /// Columns of `motion`.
    pub t: Vec<f64>,
    pub s: Vec<f64>,
    pub axes: BTreeMap<String, Vec<f64>>,
    /// Torch tip in the work frame.
    pub tip: Vec<[f64; 3]>,
    pub limits: Limits,
    /// Claim: the first pass of the certificate.
    pub claim: Value,
}

/// Runs `motion` on a job of one pass and `kinematics` on its rows.
pub fn motion(job: &str, machine: &str, machine_text: &str, period_ms: &str) -> Motion {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("certificate.json");
    let csv = good(&["tools", "motion", job, "--period-ms", period_ms, "--certificate", &file.display().to_string()]);
    let claim: Value = serde_json::from_str(&std::fs::read_to_string(Path::new(&file)).unwrap()).unwrap();
    assert_eq!(claim["passes"].as_array().unwrap().len(), 1);
    let rows = table(&csv);
    let limits = limits(machine_text);
    let poses =
        table(&String::from_utf8(run_with(&["machine", "kinematics", machine, "--forward"], &csv).stdout).unwrap());
    Motion {
        period: period_ms.parse::<f64>().unwrap() * 1e-3,
        t: column(&rows, "t_s"),
        s: column(&rows, "s_mm"),
        axes: limits.keys().map(|name| (name.clone(), column(&rows, name))).collect(),
        tip: poses.1.iter().map(|p| [p[0], p[1], p[2]]).collect(),
        limits,
        claim: claim["passes"][0].clone(),
    }
}

/// Result of the check.
#[derive(Default, Debug)]
pub struct Checked {
    /// Everything that does not hold.
    pub wrong: Vec<String>,
    /// Maximum use of each axis' speed, acceleration and jerk by differences.
    pub uses: BTreeMap<String, [f64; 3]>,
    /// Minimum and maximum speed of the tip between the acceleration and deceleration phases.
    pub band: (f64, f64),
    /// Part of the length at the asked speed.
    pub at_asked: f64,
}

/// Differences of order 1 to 3, over a power of the period each.
fn differences(q: &[f64], period: f64) -> [Vec<f64>; 3] {
    let next = |x: &[f64]| -> Vec<f64> { x.windows(2).map(|w| (w[1] - w[0]) / period).collect() };
    let first = next(q);
    let second = next(&first);
    let third = next(&second);
    [first, second, third]
}

fn greatest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, v| v.abs().max(m))
}

/// Maximum shortfall of a jerk's differences over a period, as a part of the maximum jerk.
fn jerk_short(period: f64) -> f64 {
    0.03 + 15.0 * period
}

const NAMES: [&str; 3] = ["speed", "acceleration", "jerk"];

/// Checks limits, band, part at asked speed, uses and intervals.
pub fn check(m: &Motion) -> Checked {
    let mut found = Checked::default();
    for (name, q) in &m.axes {
        check_axis(m, name, q, &mut found);
    }
    check_tip(m, &mut found);
    found
}

/// Maximum error of a position in the table.
fn rounding(m: &Motion, name: &str) -> f64 {
    let q = &m.axes[name];
    // The position is a series of some ten terms in a path length, in other units: some ulps of each.
    let along = m.limits[name][0] * m.t.last().unwrap();
    8.0 * f64::EPSILON * greatest(q).max(1.0) + f64::EPSILON * along
}

fn check_axis(m: &Motion, name: &str, q: &[f64], found: &mut Checked) {
    let (limits, e) = (m.limits[name], rounding(m, name));
    let claimed = m.claim["uses"].as_array().unwrap().iter().find(|u| u["axis"] == name).unwrap();
    let claimed = |k: usize| claimed[format!("{}_percent", NAMES[k])].as_f64().unwrap() * 0.01 * limits[k];
    let mut uses = [0.0; 3];
    for (k, d) in differences(q, m.period).iter().enumerate() {
        let (most, off) = (greatest(d), e * (2.0 / m.period).powi(k as i32 + 1));
        uses[k] = most / limits[k];
        if most > limits[k] + off {
            found.wrong.push(format!("{name}: {} {most} over its limit {}", NAMES[k], limits[k]));
        }
        // Claims are taken at five stations of each of the speed profile's cells; between them there may be a little
        // more.
        let between = 2e-3 * limits[k];
        if most > claimed(k) + off + between {
            found.wrong.push(format!("{name}: {} {most}, claimed {}", NAMES[k], claimed(k)));
        }
        let short = match k {
            0 => 0.5 * m.period * claimed(1),
            1 => m.period * claimed(2),
            _ => jerk_short(m.period) * claimed(2),
        };
        if claimed(k) > most + off + short {
            found.wrong.push(format!("{name}: {} claimed {}, found {most} + {short}", NAMES[k], claimed(k)));
        }
    }
    found.uses.insert(name.to_owned(), uses);
}

/// Chords are shorter than their arcs by the sagitta; this is far more than any of them.
const CHORD: f64 = 1e-5;

fn check_tip(m: &Motion, found: &mut Checked) {
    let number = |key: &str| m.claim[key].as_f64().unwrap();
    let asked = m.claim["asked_speed_mm_s"][1].as_f64().unwrap();
    let chord = |i: usize| (0..3).map(|k| (m.tip[i + 1][k] - m.tip[i][k]).powi(2)).sum::<f64>().sqrt();
    let speeds: Vec<f64> = (0..m.tip.len() - 1).map(|i| chord(i) / m.period).collect();
    let (up, down) = (number("run_up_end_mm"), number("run_down_start_mm"));
    let inside = (0..speeds.len()).filter(|&i| m.s[i] >= up && m.s[i + 1] <= down);
    let inside: Vec<f64> = inside.map(|i| speeds[i]).collect();
    let band = inside.iter().fold((f64::INFINITY, 0.0f64), |b, v| (b.0.min(*v), b.1.max(*v)));
    // The tip's speed over a period differs from that at an instant in it by at most this.
    let change = greatest(&inside.windows(2).map(|w| w[1] - w[0]).collect::<Vec<_>>());
    found.band = band;
    let (least, most) = (number("least_speed_mm_s"), number("greatest_speed_mm_s"));
    if band.0 < least * (1.0 - CHORD) || band.1 > most * (1.0 + CHORD) {
        found.wrong.push(format!("tip: {band:?}, claimed {least} to {most}"));
    }
    // A pass with acceleration and deceleration phases only has no band.
    if band.0.is_finite() && (band.0 > least + change + CHORD * least || band.1 < most - change - CHORD * most) {
        found.wrong.push(format!("tip: only {band:?}, claimed {least} to {most}"));
    }
    let (length, full) = (m.s.last().unwrap(), (1.0 - CHORD) * asked);
    let at_asked: f64 = speeds.iter().filter(|v| **v >= full).map(|v| v * m.period).sum();
    found.at_asked = at_asked / length;
    let intervals = m.claim["intervals"].as_array().unwrap();
    // A period at either end of each stretch, and cells of the speed profile that are fast enough in part only.
    let edge = (2.0 * m.period * asked * (intervals.len() + 1) as f64) / length + 2e-3;
    if (found.at_asked - 0.01 * number("at_asked_percent")).abs() > edge {
        found.wrong.push(format!("at asked: {}, claimed {} %", found.at_asked, number("at_asked_percent")));
    }
    check_intervals(m, &speeds, found);
}

/// Stretches follow one another over the whole path; the programmed speed is reached where it alone binds; all speeds
/// are within their band.
fn check_intervals(m: &Motion, speeds: &[f64], found: &mut Checked) {
    let mut end = 0.0;
    for interval in m.claim["intervals"].as_array().unwrap() {
        let number = |key: &str| interval[key].as_f64().unwrap();
        let (from, to) = (number("from_mm"), number("to_mm"));
        if from.to_bits() != f64::to_bits(end) || to <= from {
            found
                .wrong
                .push(format!("the stretch from {from} to {to} does not follow the one before, which ends at {end}"));
        }
        end = to;
        let first = m.s.partition_point(|s| *s < from);
        let last = m.s.partition_point(|s| *s <= to).saturating_sub(1);
        let here = speeds.get(first..last).unwrap_or_default();
        let (least, most) = (number("least_speed_mm_s"), number("greatest_speed_mm_s"));
        let rest = here.iter().find(|v| **v < least * (1.0 - CHORD) - 1e-9 || **v > most * (1.0 + CHORD) + 1e-9);
        if let Some(v) = rest {
            found.wrong.push(format!("between {from} and {to} mm the tip has {v}, claimed {least} to {most}"));
        }
    }
    if (end - m.s.last().unwrap()).abs() > 1e-9 * end {
        found.wrong.push(format!("the stretches end at {end}"));
    }
}
