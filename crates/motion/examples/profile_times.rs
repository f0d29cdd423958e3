//! Times and durations of the speed profile along paths given as splines, as JSON: for the comparison with toppra.
//!
//! The paths of `tests/data/path_timing.json`. Writes a list with one object a path: for some numbers of cells without
//! jerk, and with jerk limits of ten times the accelerations on cells that the profile chooses and on 1000 even ones, the
//! number of cells, the duration (s) and the time taken (s, the least of many).

#![allow(clippy::print_stdout, clippy::unwrap_used, reason = "a program for a script")]

#[path = "../tests/it/speed_profile/curves.rs"]
#[allow(dead_code, unreachable_pub, reason = "it has more kinds of paths")]
mod curves;

use curves::{Finely, Spline};
use seamwright_motion::speed_profile::SpeedProfile;
use std::time::Instant;

fn timed(repeats: u32, profile: impl Fn() -> SpeedProfile) -> serde_json::Value {
    let mut least = f64::INFINITY;
    let (mut duration, mut cells) = (0.0, 0);
    for _ in 0..repeats {
        let begin = Instant::now();
        let profile = profile();
        least = least.min(begin.elapsed().as_secs_f64());
        (duration, cells) = (profile.duration(), profile.cells());
    }
    serde_json::json!({ "duration_s": duration, "time_s": least, "cells": cells })
}

fn main() {
    let (free, jerky) = (Spline::reference(f64::INFINITY), Spline::reference(10.0));
    let finely = Spline::reference(10.0).into_iter().map(|(jerky, _)| Finely::new(jerky, 1000));
    let paths = free.iter().zip(&jerky).zip(finely).map(|(((free, _), (jerky, _)), finely)| {
        let by_cells =
            [100, 200, 400, 1000].map(|n| (n.to_string(), timed(50, || SpeedProfile::without_jerk(free, n).unwrap())));
        serde_json::json!({
            "by_cells": serde_json::Value::Object(by_cells.into_iter().collect()),
            "jerk": timed(10, || SpeedProfile::new(jerky).unwrap()),
            "jerk_finely": timed(10, || SpeedProfile::new(&finely).unwrap()),
        })
    });
    println!("{}", serde_json::Value::Array(paths.collect()));
}
