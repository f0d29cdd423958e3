//! Orders to a run, and invariants of its instants.

use seamwright_document::NonNegative;
use seamwright_motion::feed_override::{Instant, Order, RunPhase};
use seamwright_program::{AtHold, Sequence};
use seamwright_testkit::Random;

pub fn sequence(at_hold: AtHold) -> Sequence {
    let s = |v: f64| NonNegative::new(v).unwrap();
    Sequence {
        preflow_s: s(0.02),
        travel_delay_s: s(0.03),
        crater_s: s(0.04),
        postflow_s: s(0.05),
        overlap_mm: s(0.7),
        at_hold,
        ..Sequence::default()
    }
}

/// An order that moves or stops, seldom an abort.
pub fn random_order(random: &mut Random) -> Order {
    let orders = [Order::Hold, Order::Resume, Order::Reverse, Order::Step, Order::Override(0.0)];
    match random.below(120) {
        0 => Order::Abort,
        n if n % 6 == 5 => Order::Override(random.within(0.2, 1.0)),
        n => orders[n % 6],
    }
}

/// Path length welded without a gap beyond `before`; also checks the phases.
pub fn welded(before: f64, log: &[Instant], at_hold: AtHold, seed: u32) -> f64 {
    let mut welded = before;
    for w in log.windows(2) {
        let (s, v) = (w[1].played.rates.tip.s, w[1].played.rates.tip.v);
        let here = format!("seed {seed}: {:?} to {:?} at {s}, speed {v:e}", w[0].phase, w[1].phase);
        match w[1].phase {
            RunPhase::Travel => {
                assert!(v >= 0.0 && w[0].played.rates.tip.s <= welded + 1e-9, "gap, {here}");
            }
            RunPhase::RunOut => assert!(at_hold == AtHold::Off, "{here}"),
            RunPhase::Move => {}
            _ => assert!(v == 0.0, "moves, {here}"),
        }
        // The phase of the period that ends here.
        if w[0].phase == RunPhase::Travel {
            welded = welded.max(s);
        }
    }
    welded
}
