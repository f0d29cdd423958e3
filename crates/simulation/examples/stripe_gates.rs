//! The acceptance criteria of the laser stripe, and the cases of a kind that are silent, wrong or far off:
//! `cargo run --release -p seamwright-simulation --example stripe_gates CASES FIRST_SEED [KIND LEVEL]`.

#![allow(missing_docs)]
use seamwright_simulation::acceptance::Limit;
use seamwright_simulation::camera_simulator::stripe::{
    Section, StripeDisturbances, confident_nowhere, stripe_gates, stripe_scene, stripe_task,
};
use seamwright_vision::stripe::{JointKind, Quantity, StripeReader};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, or: u64| arguments.get(i).and_then(|n| n.parse().ok()).unwrap_or(or);
    let (cases, first) = (number(0, 50), number(1, 0));
    let named = |kind: &JointKind| arguments.get(2).is_some_and(|n| format!("{kind:?}").eq_ignore_ascii_case(n));
    if let Some(kind) = JointKind::ALL.into_iter().find(named) {
        let how = match arguments.get(3).map(String::as_str) {
            Some("rough") => StripeDisturbances::ROUGH,
            Some("holed") => StripeDisturbances::HOLED,
            Some("clean") => StripeDisturbances::CLEAN,
            _ => StripeDisturbances::USUAL,
        };
        (first..first + cases).for_each(|seed| show(kind, &how, seed));
        return;
    }
    let table = stripe_gates(first..first + cases, || ());
    for gate in table.rows {
        let Limit::Most(limit) = gate.limit else { continue };
        let kept = if gate.is_kept() { "kept" } else { "not kept" };
        println!("| {} | {} | {:.3} {} | <= {limit} | {kept} |", gate.frames, gate.what, gate.value, gate.unit);
    }
    for (seed, section, found) in confident_nowhere(first..first + cases, || ()) {
        println!("{seed}: {:?} in {section:?}: {:.2} at {:.2}", found.kind, found.confidence, found.joint());
    }
}

/// Prints the detection of one case beside its truth.
fn show(kind: JointKind, how: &StripeDisturbances, seed: u64) {
    let section = Section::random(kind, seed);
    let scene = stripe_scene(section, seed);
    let image = scene.image(how, seed);
    let Ok(frame) = image.image.frame() else { return };
    let found = StripeReader::new().read_image(&frame, Some(&scene.to_mm), &stripe_task(kind, &section));
    let truth = image.truth.joint().unwrap_or_default();
    let gap = image.truth.values.iter().find(|v| v.0 == Quantity::Gap).map_or(f64::NAN, |v| v.1);
    match found {
        Err(why) => println!("{seed}: none: {why}"),
        Ok(f) => {
            let off = f.joint() - truth;
            let seen = f.value(Quantity::Gap).unwrap_or(f64::NAN);
            let sure = if f.is_confident() { "sure" } else { "    " };
            println!(
                "{seed}: {sure} {:.2} off {:.3} ({:.3}, {:.3}) gap {gap:.3} by {:.3}",
                f.confidence,
                off.length(),
                off.x,
                off.y,
                seen - gap
            );
        }
    }
}
