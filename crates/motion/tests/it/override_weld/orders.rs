//! Runs of real welds under random orders, aborted and begun again: the seam is welded to its end, in limits.

use super::welds::{self, Weld};
use crate::override_profile::orders::{random_order, sequence, welded};
use seamwright_motion::feed_override::{
    FeedOverride, FeedOverrideError, Instant, Order, PassTimed, Run, RunPhase, Timed,
};
use seamwright_program::AtHold;
use seamwright_testkit::{Random, cases};

/// Periods with random orders; after them the only order is to continue.
const BUSY: usize = 1500;

fn log<'a>(weld: &Weld, run: &mut Run<'a, PassTimed<'a>>, random: &mut Random, seed: u32) -> Vec<Instant> {
    let mut log: Vec<Instant> = vec![];
    run.order(Order::Resume).unwrap();
    while log.last().is_none_or(|i| i.phase != RunPhase::Ended) {
        let i = run.step().unwrap();
        assert!(weld.off_seam(&i.played.rates) <= 1e-9, "{}, seed {seed}: {i:?}", weld.name);
        let used = weld.use_of_limits(&run.earlier(0.0007).rates).max(weld.use_of_limits(&i.played.rates));
        assert!(used <= 1.0 + 1e-9, "{}, seed {seed}: {used} {i:?}", weld.name);
        log.push(i);
        if log.len() < BUSY && random.below(60) == 0 {
            run.order(random_order(random))
                .or_else(|e| if e == FeedOverrideError::Zero { Ok(()) } else { Err(e) })
                .unwrap();
        } else if log.len() == BUSY {
            // The run may be moving back to the start of a long seam.
            run.order(Order::Hold).unwrap();
        } else if log.len() > BUSY && i.phase == RunPhase::Held {
            run.order(Order::Override(1.0)).unwrap();
            run.order(Order::Resume).unwrap();
        }
        assert!(log.len() < 40_000, "{}, seed {seed}: it goes on without end: {i:?}", weld.name);
    }
    log
}

#[test]
fn random_orders_on_welds() {
    let welds: Vec<_> = welds::all().iter().map(|w| (w, w.base())).collect();
    let mut aborted = 0;
    for seed in 0..cases(60) {
        let random = &mut Random::of_case(70_000 + seed);
        let (weld, base) = &welds[seed as usize % welds.len()];
        let at_hold = if random.below(2) == 0 { AtHold::Crater } else { AtHold::Off };
        let from = base.at(base.duration() - random.within(0.0, base.duration().min(2.0)), false).tip.s;
        let places = [0.3, 0.6].map(|part| from + part * (weld.length() - from));
        let mut done = from;
        while done < weld.length() {
            let feed_override = FeedOverride::new(&weld.limits(), 0.002, base).unwrap().from_place(done).unwrap();
            let mut run = Run::new(feed_override, sequence(at_hold), &places);
            let log = log(weld, &mut run, random, seed);
            let reached = welded(done, &log, at_hold, seed);
            assert!((reached - run.welded_to()).abs() < 1e-9, "seed {seed}: {reached} {}", run.welded_to());
            done = run.welded_to();
            aborted += u32::from(done < weld.length());
        }
    }
    assert!(aborted > 5, "{aborted}");
}
