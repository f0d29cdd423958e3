//! A run under orders: the process follows, every run ends.

#![allow(clippy::float_cmp, reason = "what rests does not move at all")]

use crate::override_profile::orders::{random_order, sequence, welded};
use crate::override_profile::{Case, Profile};
use seamwright_motion::feed_override::{
    Command, FeedOverride, FeedOverrideError, Instant, Order, Rates, Run, RunPhase, Timed,
};
use seamwright_program::AtHold;
use seamwright_testkit::{Random, cases};

const PERIOD: f64 = 0.002;

#[test]
fn runs_weld_the_whole_seam_and_never_burn_at_rest() {
    let mut aborted = 0;
    for seed in 0..cases(80) {
        let random = &mut Random::of_case(90_000 + seed);
        let at_hold = if random.below(2) == 0 { AtHold::Crater } else { AtHold::Off };
        let case = Case::random(random);
        let feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        let places = [0.3, 0.6].map(|part| part * case.base.length);
        let mut run = Run::new(feed_override, sequence(at_hold), &places);
        run.order(Order::Resume).unwrap();
        let mut log: Vec<Instant> = vec![];
        for k in 0..60_000 {
            let i = run.step().unwrap();
            log.push(i);
            if i.phase == RunPhase::Ended {
                break;
            }
            let late = k > 3000;
            if late && i.phase == RunPhase::Held {
                run.order(Order::Override(1.0)).unwrap();
                run.order(Order::Resume).unwrap();
            } else if !late && random.below(60) == 0 {
                run.order(random_order(random))
                    .or_else(|e| if e == FeedOverrideError::Zero { Ok(()) } else { Err(e) })
                    .unwrap();
            }
        }
        assert_eq!(log.last().unwrap().phase, RunPhase::Ended, "seed {seed}");
        let welded = welded(0.0, &log, at_hold, seed);
        assert!((welded - run.welded_to()).abs() < 1e-9, "seed {seed}: {welded} {}", run.welded_to());
        aborted += u32::from(welded < case.base.length - 1e-9);
    }
    assert!(aborted > 1, "{aborted}");
}

fn until_it_waits<L: Timed + ?Sized>(run: &mut Run<L>) -> Instant {
    for _ in 0..100_000 {
        let i = run.step().unwrap();
        if matches!(i.phase, RunPhase::Held | RunPhase::Ended) {
            return i;
        }
    }
    panic!("it goes on without end at {}", run.welded_to());
}

#[test]
fn an_aborted_run_goes_on_where_it_ended() {
    let mut goes_on = 0;
    for seed in 0..cases(60) {
        let random = &mut Random::of_case(40_000 + seed);
        let at_hold = if random.below(2) == 0 { AtHold::Crater } else { AtHold::Off };
        let case = Case::random(random);
        let mut done = 0.0;
        for _ in 0..100 {
            let feed_override =
                FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap().from_place(done).unwrap();
            let mut run = Run::new(feed_override, sequence(at_hold), &[]);
            run.order(Order::Resume).unwrap();
            let mut log = vec![];
            let periods = 40 + random.below(500);
            while log.last().is_none_or(|i: &Instant| i.phase != RunPhase::Ended) {
                log.push(run.step().unwrap());
                if log.len() == periods {
                    run.order(Order::Abort).unwrap();
                }
                assert!(log.len() < 20_000, "seed {seed}: it goes on without end");
            }
            let welded = welded(done, &log, at_hold, seed);
            assert!((welded - run.welded_to()).abs() < 1e-9, "seed {seed}: {welded} {}", run.welded_to());
            done = run.welded_to();
            if done >= case.base.length {
                break;
            }
            goes_on += 1;
        }
        assert!(done >= case.base.length, "seed {seed}: {done} of {}", case.base.length);
        // The whole seam is welded.
        let feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap().from_place(done).unwrap();
        let mut run = Run::new(feed_override, sequence(at_hold), &[]);
        run.order(Order::Resume).unwrap();
        assert_eq!(run.step().unwrap().phase, RunPhase::Ended);
    }
    assert!(goes_on > cases(60) / 2, "{goes_on}");
}

#[test]
fn a_run_of_a_pace_that_moves_stops_it_first() {
    let case = Case::straight(20.0, 200.0, 4000.0);
    let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
    feed_override.command(Command::Resume).unwrap();
    for _ in 0..500 {
        feed_override.step();
    }
    let mut run = Run::new(feed_override, sequence(AtHold::Crater), &[]);
    let first = run.step().unwrap();
    assert!(first.phase == RunPhase::Move && first.played.phi > 0.5, "{first:?}");
    let held = until_it_waits(&mut run);
    assert!(held.phase == RunPhase::Held && held.played.phi == 0.0, "{held:?}");
}

#[test]
fn overrides_next_to_nothing_hold() {
    let case = Case::straight(20.0, 200.0, 4000.0);
    for value in [0.0, 1e-300, 1e-9, 0.0009] {
        let feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        let mut run = Run::new(feed_override, sequence(AtHold::Crater), &[]);
        run.order(Order::Resume).unwrap();
        for _ in 0..300 {
            run.step().unwrap();
        }
        run.order(Order::Override(value)).unwrap();
        assert_eq!(until_it_waits(&mut run).phase, RunPhase::Held);
        assert_eq!(run.order(Order::Resume), Err(FeedOverrideError::Zero));
        for bad in [f64::NAN, -1e-9, -0.5, 1.01] {
            assert!(matches!(run.order(Order::Override(bad)), Err(FeedOverrideError::Override { .. })));
        }
        run.order(Order::Override(0.5)).unwrap();
        run.order(Order::Resume).unwrap();
        assert_eq!(until_it_waits(&mut run).phase, RunPhase::Ended);
    }
}

/// An arc that does not burn: travel waits for it, the seam after extinction counts as not welded, and a restart
/// overlaps.
#[test]
fn without_an_arc_nothing_is_welded() {
    let case = Case::straight(20.0, 200.0, 4000.0);
    for at_hold in [AtHold::Crater, AtHold::Off] {
        let sequence = sequence(at_hold);
        let feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        let mut run = Run::new(feed_override, sequence.clone(), &[]);
        run.set_burning(false);
        run.order(Order::Resume).unwrap();
        let mut phase = RunPhase::Held;
        for _ in 0..5000 {
            let i = run.step().unwrap();
            phase = i.phase;
            assert!(i.played.phi == 0.0 && matches!(phase, RunPhase::Preflow | RunPhase::TravelDelay));
        }
        assert_eq!(phase, RunPhase::TravelDelay);
        // A hold while it does not burn fills no crater; the next try is like the first.
        run.order(Order::Hold).unwrap();
        loop {
            match run.step().unwrap().phase {
                RunPhase::Postflow => {}
                RunPhase::Held => break,
                other => panic!("{other:?}"),
            }
        }
        run.order(Order::Resume).unwrap();
        run.set_burning(true);
        while run.step().unwrap().played.rates.tip.s < 0.4 * case.base.length {}
        run.set_burning(false);
        let out = run.now().played.rates.tip.s;
        let mut phases = vec![];
        loop {
            let i = run.step().unwrap();
            assert!(!i.phase.arc(), "{:?}", i.phase);
            if phases.last() != Some(&i.phase) {
                phases.push(i.phase);
            }
            if i.phase == RunPhase::Held {
                break;
            }
        }
        assert_eq!(phases, [RunPhase::RunOut, RunPhase::Postflow, RunPhase::Held]);
        assert!(run.welded_to() <= out);
        run.set_burning(true);
        run.order(Order::Resume).unwrap();
        while run.step().unwrap().phase != RunPhase::Travel {}
        let begins = run.now().played.rates.tip.s;
        assert!((begins - (run.welded_to() - sequence.overlap_mm.get()).max(0.0)).abs() < 1e-6);
        assert_eq!(until_it_waits(&mut run).phase, RunPhase::Ended);
        assert!((run.welded_to() - case.base.length).abs() < 1e-9);
    }
}

/// A motion that is NaN beyond a time.
struct Broken<'a>(&'a Profile, f64);

impl Timed for Broken<'_> {
    fn duration(&self) -> f64 {
        self.0.duration()
    }

    fn at(&self, t: f64, before: bool) -> Rates {
        let mut r = self.0.at(t, before);
        if t > self.1 {
            r.v[0] = f64::NAN;
        }
        r
    }

    fn next_border(&self, t: f64, forward: bool) -> f64 {
        self.0.next_border(t, forward)
    }

    fn time_of(&self, s: f64) -> f64 {
        self.0.time_of(s)
    }
}

/// The process goes off and the run waits, under every order.
#[test]
fn what_cannot_go_on_is_an_error_and_the_arc_goes_off() {
    let case = Case::straight(20.0, 200.0, 4000.0);
    let profile = Broken(&case.base, -1.0);
    let mut run = Run::new(FeedOverride::new(&case.limits(), PERIOD, &profile).unwrap(), sequence(AtHold::Crater), &[]);
    let mut stuck = 0;
    for _ in 0..3 {
        run.order(Order::Resume).unwrap();
        let mut on_at_rest = 0;
        for _ in 0..400 {
            match run.step() {
                Ok(i) => on_at_rest += u32::from(i.phase == RunPhase::Travel),
                Err(e) => {
                    assert_eq!(e, FeedOverrideError::Stuck { s: 0.0 });
                    stuck += 1;
                }
            }
        }
        assert!(on_at_rest <= 60, "{on_at_rest}");
        assert_eq!(run.step().unwrap().phase, RunPhase::Held);
    }
    assert_eq!(stuck, 3);
}

/// A step holds exactly at its path length, or just behind one that is too near; welded path lengths are refused.
#[test]
fn steps_to_places_hold_there() {
    let (mut exact, mut steps) = (0, 0);
    for seed in 0..cases(100) {
        let random = &mut Random::of_case(60_000 + seed);
        let case = Case::random(random);
        let at_hold = if random.below(2) == 0 { AtHold::Crater } else { AtHold::Off };
        let mut run = Run::new(FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap(), sequence(at_hold), &[]);
        let length = case.base.length;
        let mut log = vec![run.now()];
        for _ in 0..6 {
            let welded = run.welded_to();
            for bad in [f64::NAN, -1.0, welded, length + 1e-3] {
                let error = run.order(Order::StepTo(bad));
                assert!(matches!(error, Err(FeedOverrideError::StepTo { .. })), "seed {seed}: {bad} {error:?}");
            }
            let place = welded + random.within(0.0, 1.0) * (length - welded);
            if run.order(Order::StepTo(place)).is_err() {
                assert!(place <= welded + 1e-6);
                continue;
            }
            for _ in 0..1 + random.below(200) {
                log.push(run.step().unwrap());
            }
            // Once more from anywhere in the restart or the travel.
            run.order(Order::StepTo(place)).ok();
            while !matches!(log.last().unwrap().phase, RunPhase::Held | RunPhase::Ended) {
                log.push(run.step().unwrap());
                assert!(log.len() < 60_000, "seed {seed}: it goes on without end");
            }
            // A beam is off before.
            let s = log.last().unwrap().played.rates.tip.s;
            assert!(run.welded_to() >= welded && (s - place).abs() < 0.3 * length, "seed {seed}: {s} {place}");
            exact += u32::from((s - place).abs() < 1e-9);
            steps += 1;
            if log.last().unwrap().phase == RunPhase::Ended {
                break;
            }
        }
        assert!((welded(0.0, &log, at_hold, seed) - run.welded_to()).abs() < 1e-9, "seed {seed}");
    }
    assert!(exact > steps * 9 / 10 && steps > 3 * cases(100), "{exact} of {steps}");
}
