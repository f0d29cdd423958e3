//! Times functions and prints a line for each: the median time of a call, and the rate of what it handles.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Calls of a round take at least this long, so that reading the clock costs nothing beside them.
const ROUND: Duration = Duration::from_millis(5);
/// Rounds are made for this long, but at least [`ROUNDS`].
const WHOLE: Duration = Duration::from_millis(500);
const ROUNDS: usize = 5;

/// Units of times and of numbers, by size.
const TIMES: [(&str, f64); 4] = [("ns", 1e-9), ("us", 1e-6), ("ms", 1e-3), ("s", 1.0)];
const NUMBERS: [(&str, f64); 4] = [("", 1.0), ("thousand", 1e3), ("million", 1e6), ("billion", 1e9)];

/// Prints the median time of a call of `work`.
pub(crate) fn time<T>(name: &str, work: impl FnMut() -> T) {
    if let Some(seconds) = median(name, work) {
        print(name, seconds, TIMES);
    }
}

/// Prints the median time of a call of `work`, which handles so many `elements`, and their number a second.
pub(crate) fn rate<T>(name: &str, elements: u64, work: impl FnMut() -> T) {
    if let Some(seconds) = median(name, work) {
        print(name, seconds, TIMES);
        print("  of them a second", elements as f64 / seconds, NUMBERS);
    }
}

/// Prints a value in the largest unit that it reaches.
fn print(name: &str, value: f64, units: [(&str, f64); 4]) {
    let (unit, size) = units.into_iter().rfind(|(_, size)| value >= *size).unwrap_or(units[0]);
    println!("{name:<40} {:>8.3} {unit}", value / size);
}

/// Median seconds of a call, or none if the command line names other benchmarks: a part of their names.
fn median<T>(name: &str, mut work: impl FnMut() -> T) -> Option<f64> {
    let asked = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    if asked.is_some_and(|part| !name.contains(&part)) {
        return None;
    }
    let mut round = |calls: u32| {
        let begin = Instant::now();
        (0..calls).for_each(|_| drop(black_box(work())));
        begin.elapsed()
    };
    // Also warms up.
    let mut calls = 1;
    while round(calls) < ROUND {
        calls *= 2;
    }
    let begin = Instant::now();
    let mut rounds = Vec::new();
    while rounds.len() < ROUNDS || begin.elapsed() < WHOLE {
        rounds.push(round(calls).as_secs_f64() / f64::from(calls));
    }
    rounds.sort_by(f64::total_cmp);
    Some(rounds[rounds.len() / 2])
}
