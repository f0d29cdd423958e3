//! The rows of the trace of a run.

use crate::load::Loaded;
use glam::DVec3;
use seamwright_executive::realtime::Shown;
use seamwright_executive::{ProcessState, VALUES};
use seamwright_machine::Machine;
use seamwright_program::TorchPath;
use std::collections::VecDeque;

/// The speed of the tip is that over so long, s: encoders count in steps.
const OVER_S: f64 = 0.05;

/// Columns of each head that is tracked.
const HEAD: [(&str, &str); 6] = [
    ("deviation_lateral_mm", "mm"),
    ("deviation_height_mm", "mm"),
    ("correction_lateral_mm", "mm"),
    ("correction_height_mm", "mm"),
    ("sigma_mm", "mm"),
    ("confidence", "1"),
];

/// Columns of the trace of a run with their units: a row a cycle. `heads` are the ends of the names of each head that is tracked.
pub fn columns(machine: &Machine, values: &[String], heads: &[String]) -> Vec<(String, &'static str)> {
    let mut columns: Vec<(String, &'static str)> = [
        ("t_s", "s"),
        ("mode", "1"),
        ("pass", "1"),
        ("s_mm", "mm"),
        ("welded_mm", "mm"),
        ("speed_set_mm_s", "mm/s"),
        ("tip_speed_mm_s", "mm/s"),
        ("path_error_mm", "mm"),
        ("override", "1"),
        ("arc", "1"),
        ("gas", "1"),
        ("process_state", "1"),
        ("burning", "1"),
        ("power", "1"),
        ("inputs", "1"),
        ("missed", "1"),
        ("steady", "1"),
    ]
    .map(|(name, unit)| (name.to_owned(), unit))
    .to_vec();
    for axis in &machine.axes {
        let (name, unit) = (&axis.name, axis.unit());
        columns.push((format!("{name}_set_{unit}"), unit));
        columns.push((format!("{name}_measured_{unit}"), unit));
        columns.push((format!("{name}_following_error_{unit}"), unit));
        columns.push((format!("{name}_current_part"), "1"));
    }
    for head in heads {
        columns.extend(HEAD.iter().map(|(name, unit)| (format!("{name}{head}"), *unit)));
    }
    for name in values {
        // The unit is the end of the name, by which its window is found too.
        columns.push((format!("{name}_set"), ""));
        columns.push((name.clone(), ""));
    }
    columns
}

/// Recent positions of the torch tip on the work.
#[derive(Debug, Default)]
pub struct Tips {
    /// Times (s), and the tip as it was measured and as it was set, mm.
    last: VecDeque<(f64, DVec3, DVec3)>,
    pass: usize,
}

impl Tips {
    /// The tip's speed (mm/s), and its distance from its way (mm), by the reports of the drives in a cycle.
    fn next(&mut self, machine: &Machine, c: &Shown) -> (f64, f64) {
        if c.place.pass != self.pass {
            (self.last, self.pass) = (VecDeque::new(), c.place.pass);
        }
        if self.pass == 0 {
            return (f64::NAN, f64::NAN);
        }
        let measured = machine.forward(&c.reports.drives.position).point;
        let set = machine.forward(&std::array::from_fn(|i| c.orders.set[i].position)).point;
        self.last.push_back((c.t, measured, set));
        while self.last.len() > 2 && self.last.get(1).is_some_and(|(t, ..)| c.t - t >= OVER_S) {
            self.last.pop_front();
        }
        let (t, before, set_before) = self.last[0];
        let speed = if c.t > t { (measured - before).length() / (c.t - t) } else { 0.0 };
        let off = measured - set;
        let beside = (set - set_before).try_normalize().map_or(off, |along| off.reject_from_normalized(along));
        (speed, beside.length())
    }
}

/// A cycle as a row; `values` is how many process values the program has, `heads` how many heads are tracked.
pub fn row(tips: &mut Tips, machine: &Machine, c: &Shown, values: usize, heads: usize) -> Vec<f64> {
    let (tip_speed, beside) = tips.next(machine, c);
    let bit = |yes: bool| if yes { 1.0 } else { 0.0 };
    let in_pass = c.place.pass > 0;
    let process = match c.process {
        ProcessState::Off => 0.0,
        ProcessState::Strikes => 1.0,
        ProcessState::Pauses => 2.0,
        ProcessState::Burns => 3.0,
        ProcessState::Failed => 4.0,
    };
    let mut row = vec![
        c.t,
        f64::from(c.mode as u8),
        c.place.pass as f64,
        if in_pass { c.place.s_mm } else { f64::NAN },
        if in_pass { c.welded_mm } else { f64::NAN },
        if in_pass { c.speed } else { f64::NAN },
        tip_speed,
        beside,
        c.feed_override,
        bit(c.orders.process.on),
        bit(c.orders.process.gas),
        process,
        bit(c.reports.source.burning),
        bit(c.orders.power),
        c.reports.inputs as f64,
        f64::from(c.reports.missed),
        bit(c.steady),
    ];
    for (i, axis) in machine.axes.iter().enumerate() {
        row.push(axis.to_file(c.orders.set[i].position));
        row.push(axis.to_file(c.reports.drives.position[i]));
        row.push(axis.to_file(c.reports.drives.following_error[i]));
        row.push(c.reports.drives.current[i]);
    }
    for head in c.tracked.iter().take(heads) {
        row.extend(head.map_or([f64::NAN; HEAD.len()], |h| {
            let ([a, b], [c, d]) = (h.deviation_mm, h.correction_mm);
            [a, b, c, d, h.sigma_mm, h.confidence]
        }));
    }
    for i in 0..values.min(VALUES) {
        row.push(c.orders.process.values[i]);
        row.push(c.reports.source.values[i]);
    }
    row
}

/// Suffixes of each head's columns; empty for one head.
pub fn head_names(loaded: &Loaded) -> Vec<String> {
    let pairs = loaded.paths().iter().any(|path| path.second(0.0).is_some());
    let heads = loaded.machine.heads.iter().take(if pairs { 2 } else { 1 });
    heads.map(|head| if pairs { format!("_{}", head.name) } else { String::new() }).collect()
}
