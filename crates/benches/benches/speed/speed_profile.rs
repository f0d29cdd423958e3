//! Cost of the speed profile along the reference splines: with limits of jerk, on automatic cells and on 1000 even ones
//! (aim: 30 ms for 7 axes), and without them over 1000 cells (aim: 0.3 ms).

#[path = "../../../motion/tests/it/speed_profile/curves.rs"]
#[allow(dead_code, unreachable_pub, reason = "it has more kinds of paths")]
mod curves;

use crate::measure::time;
use curves::{Finely, Spline};
use seamwright_motion::speed_profile::{Channels, SpeedProfile};
use std::hint::black_box;

pub(crate) fn profiles() {
    for (name, jerk) in [("without jerk", f64::INFINITY), ("with jerk", 10.0)] {
        for (i, (spline, _)) in Spline::reference(jerk).iter().enumerate() {
            let axes = spline.limits().len();
            time(&format!("profile {name}, path {i} of {axes} axes"), || {
                black_box(SpeedProfile::new(black_box(spline)).map(|profile| profile.duration()))
            });
        }
    }
}

pub(crate) fn finely() {
    for (i, (spline, _)) in Spline::reference(10.0).into_iter().enumerate() {
        let axes = spline.limits().len();
        let path = Finely::new(spline, 1000);
        time(&format!("profile with jerk, 1000 cells, path {i} of {axes} axes"), || {
            black_box(SpeedProfile::new(black_box(&path)).map(|profile| profile.duration()))
        });
    }
}
