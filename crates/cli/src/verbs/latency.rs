use crate::args::run::LatencyArgs;
use crate::progress::Progress;
use crate::refusals::{between, not_allowed};
use crate::rows::print_either;
use seamwright_executive::realtime::{Latency, Pacer, RealtimeRights};
use seamwright_message::{Language, Message, Unit};
use seamwright_project::failure::Failure;
use std::fmt::Write;

/// Parts of all cycles whose lateness is printed.
const PARTS: [f64; 4] = [0.5, 0.99, 0.999, 1.0];
/// Widest bar of the histogram, characters.
const WIDE: f64 = 50.0;

pub(crate) fn run(args: &LatencyArgs) -> Result<(), Failure> {
    for (what, value, low, high) in
        [("--period-ms", args.period_ms, 0.25, 4.0), ("--seconds", args.seconds, 0.1, 86_400.0)]
    {
        if !(low..=high).contains(&value) {
            return Err(not_allowed(what, value, between(low, high)));
        }
    }
    let cycles = (args.seconds * 1e3 / args.period_ms).round() as u64;
    let progress = Progress::new("cli-progress-cycles", cycles);
    let measured = std::thread::scope(|scope| scope.spawn(|| measure(args, cycles, &progress)).join());
    drop(progress);
    let (footing, latency) = measured.map_err(|_| Failure::environment(Message::new("cli-cycle-ended-early")))?;
    print_either(args.json, &json(args, &footing, &latency), || text(args, &footing, &latency))
}

fn measure(args: &LatencyArgs, cycles: u64, progress: &Progress) -> (RealtimeRights, Latency) {
    let footing = RealtimeRights::ask(args.cpu);
    let mut pacer = Pacer::new(args.period_ms * 1e-3);
    let mut done = 0;
    while done < cycles {
        done += 1 + u64::from(pacer.wait());
        // The bar draws itself ten times a second, from a thread of its own.
        progress.at(done);
    }
    (footing, pacer.latency().clone())
}

fn json(args: &LatencyArgs, footing: &RealtimeRights, latency: &Latency) -> serde_json::Value {
    let bins: Vec<_> =
        latency.bins().map(|(us, cycles)| serde_json::json!({ "up_to_us": us, "cycles": cycles })).collect();
    serde_json::json!({
        "period_ms": args.period_ms,
        "cycles": latency.count(),
        "missed": latency.missed(),
        "footing": footing.message().in_language(Language::English),
        "late_us": { "median": latency.quantile_us(0.5), "p99": latency.quantile_us(0.99),
            "p99_9": latency.quantile_us(0.999), "most": latency.most_us() },
        "histogram": bins,
    })
}

fn text(args: &LatencyArgs, footing: &RealtimeRights, latency: &Latency) -> String {
    let cycles = Message::new("cli-latency-cycles").count("cycles", latency.count() as usize);
    let cycles = cycles.value("period", args.period_ms, Unit::Ms).number("missed", latency.missed() as f64, 0);
    let mut text = format!("{footing}\n{cycles}\n");
    let us = |value: f64| Message::new("quantity").quantity("value", value, Unit::Us, 1).to_string();
    for part in PARTS {
        // Writing to a String never fails.
        let _ = writeln!(text, "{}", late(part, &us(latency.quantile_us(part))));
    }
    let mut octaves: Vec<(f64, u64)> = Vec::new();
    for (us, cycles) in latency.bins() {
        match octaves.last_mut() {
            Some((upper, sum)) if us <= *upper => *sum += cycles,
            _ => octaves.push((2f64.powf(us.log2().ceil()), cycles)),
        }
    }
    let most = octaves.iter().map(|o| o.1).max().unwrap_or(1) as f64;
    for (upper, cycles) in octaves {
        let bar = "#".repeat((WIDE * (cycles as f64).ln_1p() / most.ln_1p()).round() as usize);
        let _ = writeln!(text, "{:>13} {cycles:>9} {bar}", us(upper));
    }
    text
}

/// Maximum delay of this part of all cycles.
fn late(part: f64, late: &str) -> Message {
    let part = Message::new("quantity").value("value", 100.0 * part, Unit::Percent).to_string();
    Message::new("cli-latency-late").text("part", format!("{part:>8}")).text("late", format!("{late:>13}"))
}
