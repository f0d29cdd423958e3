//! Commands at any time: on the path, in limits, to the same end.

use crate::override_profile;
use crate::override_profile::Case;
use seamwright_motion::feed_override::{Command, FeedOverride, FeedOverrideError, Played, Timed};
use seamwright_testkit::{Random, cases};

const PERIOD: f64 = 0.002;
/// Samples in a period.
const LOOKS: u32 = 3;

#[derive(Debug, Default, Clone, Copy)]
struct Seen {
    off_path: f64,
    speed: f64,
    acceleration: f64,
    jerk: f64,
    /// Maximum step of the path length against the speeds at its ends, mm.
    jump: f64,
    periods: u64,
    on_faster: u64,
}

impl Seen {
    fn see(&mut self, case: &Case, p: &Played) {
        let on = case.base.position(p.rates.tip.s);
        for (i, l) in case.limits.iter().enumerate() {
            self.off_path = self.off_path.max((on[i] - p.rates.q[i]).abs());
            self.speed = self.speed.max(p.rates.v[i].abs() / l.speed);
            self.acceleration = self.acceleration.max(p.rates.a[i].abs() / l.acceleration);
            self.jerk = self.jerk.max(p.rates.j[i].abs() / l.jerk);
        }
    }

    fn step(
        &mut self,
        case: &Case,
        feed_override: &mut FeedOverride<override_profile::Profile>,
        last: &Played,
    ) -> Played {
        let now = feed_override.step();
        let mut before = *last;
        let h = feed_override.period() / f64::from(LOOKS);
        for k in (0..LOOKS).rev() {
            let p = feed_override.earlier(h * f64::from(k));
            self.see(case, &p);
            let mean = 0.5 * (p.rates.tip.v + before.rates.tip.v) * h;
            self.jump = self.jump.max((p.rates.tip.s - before.rates.tip.s - mean).abs());
            before = p;
        }
        self.periods += 1;
        self.on_faster += u64::from(now.faster);
        now
    }

    fn join(self, o: Self) -> Self {
        Self {
            off_path: self.off_path.max(o.off_path),
            speed: self.speed.max(o.speed),
            acceleration: self.acceleration.max(o.acceleration),
            jerk: self.jerk.max(o.jerk),
            jump: self.jump.max(o.jump),
            periods: self.periods + o.periods,
            on_faster: self.on_faster + o.on_faster,
        }
    }
}

fn random_command(random: &mut Random, length: f64) -> Command {
    match random.below(8) {
        0 | 1 => Command::Hold,
        2 => Command::Resume,
        3 => Command::Reverse,
        4 => Command::Override(random.within(0.0, 1.0)),
        5 => Command::Override(random.within(1.0, 1.5)),
        6 => Command::Override(1.0),
        _ => Command::StopAt(random.within(0.0, length)),
    }
}

/// One run of random commands; then to the end, to the start, or to rest, and from there to the end.
fn run(seed: u32, case: &Case) -> Seen {
    let random = &mut Random::of_case(seed);
    let period = random.within(0.002, 0.004);
    let mut feed_override =
        FeedOverride::new(&case.limits(), period, &case.base).unwrap().with_faster(&case.faster, 1.5).unwrap();
    let mut seen = Seen::default();
    let mut last = feed_override.earlier(0.0);
    feed_override.command(Command::Resume).unwrap();
    let mut given = vec![];
    for _ in 0..1 + random.below(5) {
        let command = random_command(random, case.base.length);
        given.push(command);
        for _ in 0..random.below(30) {
            last = seen.step(case, &mut feed_override, &last);
        }
        feed_override.command(command).unwrap();
    }
    let ending = random.below(3);
    let value = random.within(0.7, 1.5);
    feed_override.command(Command::Override(value)).unwrap();
    feed_override.command([Command::Resume, Command::Reverse, Command::Hold][ending]).unwrap();
    let mut rest = |feed_override: &mut FeedOverride<override_profile::Profile>| {
        for _ in 0..20_000 {
            if feed_override.at_rest() {
                break;
            }
            last = seen.step(case, feed_override, &last);
        }
        assert!(feed_override.at_rest(), "seed {seed}: never at rest: {given:?} {last:?}");
        assert!(last.phi == 0.0 && last.rates.tip.v == 0.0 && last.rates.tip.a == 0.0, "seed {seed}: {last:?}");
        last
    };
    let there = rest(&mut feed_override);
    if ending == 1 {
        assert!(there.theta == 0.0 && there.rates.tip.s == 0.0, "seed {seed}: {there:?}");
    }
    if ending > 0 {
        feed_override.command(Command::Resume).unwrap();
    }
    let end = rest(&mut feed_override);
    let profile = if end.faster { &case.faster } else { &case.base };
    assert!(end.theta >= profile.duration() && end.rates.tip.s >= profile.length, "seed {seed}: {end:?}");
    // The lengths of the two profiles are separate sums.
    let off = end.rates.q.iter().zip(case.base.position(case.base.length)).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f64::max) <= 1e-9, "seed {seed}: {end:?}");
    seen
}

/// With those on welds (`tests/override_weld`) ten thousand.
#[test]
fn runs_with_random_commands_stay_in_limits() {
    let runs = cases(6000);
    // Making a case takes longer than a run.
    let group = |first: u32| {
        let case = Case::random(&mut Random::of_case(1_000_000_000 + first));
        (first..runs.min(first + 10)).map(|seed| run(seed, &case)).fold(Seen::default(), Seen::join)
    };
    let half = |from: u32| (10 * from..runs).step_by(20).map(group).fold(Seen::default(), Seen::join);
    let seen = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        half(0).join(other.join().unwrap())
    });
    assert!(seen.off_path <= 1e-9, "{seen:?}");
    assert!(seen.speed.max(seen.acceleration).max(seen.jerk) <= 1.0 + 1e-9, "{seen:?}");
    assert!(seen.on_faster > u64::from(runs), "{seen:?}");
}

/// The same by differences of positions alone: speeds, accelerations and jerks that no formula of ours went into.
#[test]
fn differences_of_positions_stay_in_limits() {
    let mut changed = 0;
    for seed in 0..60 {
        let random = &mut Random::of_case(1000 + seed);
        let case = Case::random(random);
        let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        feed_override.command(Command::Resume).unwrap();
        let mut q = vec![];
        for k in 0..400 {
            if k % 40 == 20 {
                feed_override.command(random_command(random, case.base.length)).ok();
            }
            changed += u32::from((feed_override.step().phi - feed_override.earlier(PERIOD).phi).abs() > 0.0);
            q.extend((0..4).rev().map(|i| feed_override.earlier(PERIOD * f64::from(i) / 4.0).rates.q));
        }
        let h = PERIOD / 4.0;
        for w in q.windows(4) {
            for (i, l) in case.limits.iter().enumerate() {
                let [a, b, c, d] = [w[0][i], w[1][i], w[2][i], w[3][i]];
                // Differences are means of the derivatives: never above their maximum, except for rounding.
                assert!(((b - a) / h).abs() <= l.speed * (1.0 + 1e-6) + 1e-9, "seed {seed}");
                assert!(((c - 2.0 * b + a) / (h * h)).abs() <= l.acceleration * (1.0 + 1e-6) + 1e-5, "seed {seed}");
                let jerk = ((d - 3.0 * c + 3.0 * b - a) / (h * h * h)).abs();
                assert!(jerk <= l.jerk * (1.0 + 1e-6) + 1e-2, "seed {seed}: {jerk} {}", l.jerk);
            }
        }
    }
    assert!(changed > 3000, "{changed}");
}

fn periods_to_stand(feed_override: &mut FeedOverride<override_profile::Profile>) -> u32 {
    feed_override.command(Command::Hold).unwrap();
    let mut periods = 0;
    while !feed_override.at_rest() {
        feed_override.step();
        periods += 1;
    }
    periods
}

/// On a straight axis at constant speed the profile's own deceleration phase is the quickest stop.
#[test]
fn a_hold_stops_nearly_as_quickly_as_can_be() {
    let mut ratios = vec![];
    for seed in 0..200 {
        let random = &mut Random::of_case(seed);
        let (v, rise) = (random.within(5.0, 80.0), random.within(0.04, 0.3));
        let a = v / rise;
        let j = a / (rise * random.within(0.2, 1.0));
        let case = Case::straight(v, a, j);
        let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        feed_override.command(Command::Resume).unwrap();
        while feed_override.earlier(0.0).theta < 5.0 {
            feed_override.step();
        }
        let best = rise + a / j;
        ratios.push(f64::from(periods_to_stand(&mut feed_override)) * PERIOD / best);
    }
    ratios.sort_by(f64::total_cmp);
    assert!(ratios[199] < 1.35, "{ratios:?}");
}

/// A hold at any time comes to rest before the profile's own end, and mostly within the time of its deceleration phase.
#[test]
fn a_hold_anywhere_on_a_curved_path_stands_still() {
    let mut ratios = vec![];
    for seed in 0..cases(300) {
        let random = &mut Random::of_case(50_000 + seed);
        let case = Case::random(random);
        let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        feed_override.command(Command::Resume).unwrap();
        let until = random.within(0.1, 0.9) * case.base.duration;
        while feed_override.earlier(0.0).theta < until {
            feed_override.step();
        }
        let left = case.base.duration - until;
        let stop = f64::from(periods_to_stand(&mut feed_override)) * PERIOD;
        ratios.push(stop / case.base.run_down());
        assert!(stop < 1.5 * left + 3.0 * case.base.run_down(), "seed {seed}: {stop} s, {left} s left");
    }
    ratios.sort_by(f64::total_cmp);
    let of = |part: f64| ratios[(part * (ratios.len() - 1) as f64) as usize];
    assert!(of(0.5) < 2.0, "{ratios:?}");
}

/// A stop is exact or reported as dropped: hardly ever at an override that leaves room.
#[test]
fn a_stop_at_a_place_is_exact_from_both_sides() {
    let mut given_up = [0, 0];
    for seed in 0..cases(60) {
        let random = &mut Random::of_case(seed);
        let case = Case::random(random);
        let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
        let full = seed % 2 == 0;
        feed_override.command(Command::Override(if full { 1.0 } else { 0.6 })).unwrap();
        for _ in 0..4 {
            let s = random.within(0.0, case.base.length);
            feed_override.command(Command::StopAt(s)).unwrap();
            let mut last = feed_override.step();
            let mut left = 20_000;
            while !feed_override.at_rest() && feed_override.stop().is_some() && left > 0 {
                last = feed_override.step();
                left -= 1;
            }
            let stops = feed_override.stop().is_some();
            assert!(left > 0, "seed {seed}: {s} {last:?}");
            given_up[usize::from(full)] += u32::from(!stops);
            assert!(!stops || ((last.rates.tip.s - s).abs() <= 1e-9 && last.phi == 0.0), "seed {seed}: {s} {last:?}");
            if !stops {
                periods_to_stand(&mut feed_override);
            }
        }
    }
    assert!(given_up[0] < cases(60) / 12 && given_up[1] < cases(60) / 2, "{given_up:?}");
}

#[test]
fn bad_values_are_refused_and_change_nothing() {
    let case = Case::straight(10.0, 100.0, 1000.0);
    let mut feed_override = FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap();
    for value in [f64::NAN, -0.1, 1.01, f64::INFINITY] {
        assert!(matches!(
            feed_override.command(Command::Override(value)),
            Err(FeedOverrideError::Override { greatest: 1.0, .. })
        ));
    }
    assert!(
        feed_override.command(Command::StopAt(f64::NAN)).is_err()
            && feed_override.command(Command::StopAt(1e9)).is_err()
    );
    assert!(feed_override.at_rest());
    assert!(FeedOverride::new(&case.limits(), 0.1, &case.base).is_err());
    assert!(FeedOverride::new(&case.limits(), f64::NAN, &case.base).is_err());
    assert!(FeedOverride::new(&case.limits(), PERIOD, &case.base).unwrap().with_faster(&case.faster, 1.6).is_err());
}
