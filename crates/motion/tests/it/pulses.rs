//! Pulses of random position streams with reversals: counts, distances, the direction line, evenness. Everything is
//! checked on the edges alone, against floating-point sums independent of the generator's integers.

use seamwright_motion::pulses::{Edge, Error, Generator, Lines, Timing};
use seamwright_testkit::{Random, cases};

fn whole(random: &mut Random, low: usize, high: usize) -> u64 {
    (low + random.below(high - low + 1)) as u64
}

fn random_timing(random: &mut Random) -> Timing {
    let width = whole(random, 1, 30);
    let spacing = 2 * width + whole(random, 0, 60);
    let period = spacing * whole(random, 3, 60) + whole(random, 0, 50);
    Timing { period, width, spacing, setup: whole(random, 0, 80), hold: whole(random, 0, 80) }
}

/// Model of a driver and a counter on the two lines, checked edge by edge.
struct Driver {
    timing: Timing,
    count: i64,
    positive: Option<bool>,
    rise: Option<u64>,
    fall: Option<u64>,
    turned: Option<u64>,
}

impl Driver {
    fn new(timing: Timing, count: i64) -> Self {
        Self { timing, count, positive: None, rise: None, fall: None, turned: None }
    }

    fn edge(&mut self, tick: u64, edge: Edge) {
        let Timing { width, spacing, setup, hold, .. } = self.timing;
        let since = |before: Option<u64>| before.map_or(u64::MAX, |b| tick - b);
        match edge {
            Edge::Rise => {
                assert!(since(self.rise) >= spacing, "{} < {spacing}", since(self.rise));
                assert!(since(self.fall) >= width && since(self.turned) >= setup);
                assert!(self.rise.is_none() || self.fall >= self.rise, "the line is high already");
                self.count += if self.positive.unwrap() { 1 } else { -1 };
                self.rise = Some(tick);
            }
            Edge::Fall => {
                assert_eq!(since(self.rise), width);
                self.fall = Some(tick);
            }
            Edge::Direction(positive) => {
                assert!(self.positive != Some(positive));
                assert!(since(self.fall) >= hold && self.fall >= self.rise);
                (self.positive, self.turned) = (Some(positive), Some(tick));
            }
        }
    }
}

/// Maximum deviation of `ticks` from the best-fitting equally spaced ones, ticks: half the minimum width of a strip
/// that contains them all. The width is convex in the strip's slope, so a ternary search finds the minimum.
fn jitter(ticks: &[u64]) -> f64 {
    let n = ticks.len();
    if n < 3 {
        return 0.0;
    }
    let width = |slope: f64| {
        let off = ticks.iter().enumerate().map(|(i, t)| *t as f64 - slope * i as f64);
        let (low, high) = off.fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let mean = (ticks[n - 1] - ticks[0]) as f64 / (n - 1) as f64;
    let (mut low, mut high) = (mean - 2.0, mean + 2.0);
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if width(a) < width(b) { high = b } else { low = a }
    }
    0.5 * width(low)
}

#[test]
fn random_streams_of_several_axes() {
    let mut random = Random::new(11);
    let (mut pulses, mut turns, mut refused, mut waited) = (0u64, 0u64, 0u64, 0u64);
    for _ in 0..cases(3000) {
        let first = random_timing(&mut random);
        let axes = 1 + random.below(4);
        let start: Vec<(Timing, f64)> = (0..axes)
            .map(|_| (Timing { period: first.period, ..random_timing(&mut random) }, random.within(-1e6, 1e6)))
            .collect();
        let mut lines = Lines::new(&start).unwrap();
        let mut at: Vec<f64> = start.iter().map(|s| s.1).collect();
        let mut drivers: Vec<Driver> = start.iter().map(|(t, p)| Driver::new(*t, (p + 0.5).floor() as i64)).collect();
        let (mut begin, mut before, mut whole) = (0, 0, true);
        for _ in 0..40 {
            // Speeds up to a little beyond the driver's, often slow, often turning round.
            let to: Vec<f64> = at
                .iter()
                .zip(&start)
                .map(|(at, (t, _))| {
                    let most = t.period as f64 / t.spacing as f64;
                    let v = random.within(-1.0, 1.0).powi(3) * most * 1.01;
                    at + if random.chance(0.1) { 0.0 } else { v }
                })
                .collect();
            match lines.advance(to.iter().copied()) {
                Ok(()) => at = to,
                Err((axis, Error::TooFast { asked, most })) => {
                    assert!(asked > most && (asked - (to[axis] - at[axis]).abs()).abs() < 1e-6);
                    (refused, whole) = (refused + 1, false);
                    break;
                }
                Err((axis, Error::Crowded { pulses })) => {
                    // The error occurs only if direction and pulses need more time than the period has.
                    let t = start[axis].0;
                    let needed = 2 * t.spacing + t.width + t.hold + t.setup + pulses * t.spacing;
                    assert!(needed >= t.period, "{needed} in {}", t.period);
                    (refused, whole) = (refused + 1, false);
                    break;
                }
                Err(other) => panic!("{other:?}"),
            }
            let mut ticks = vec![Vec::new(); axes];
            let mut turned = vec![None; axes];
            while let Some(event) = lines.event() {
                assert!(event.tick >= before && event.tick < begin + first.period);
                before = event.tick;
                drivers[event.axis].edge(event.tick, event.edge);
                match event.edge {
                    Edge::Rise => ticks[event.axis].push(event.tick - begin),
                    Edge::Direction(_) => turned[event.axis] = Some(event.tick),
                    Edge::Fall => {}
                }
            }
            for (axis, driver) in drivers.iter().enumerate() {
                assert!((driver.count as f64 - at[axis]).abs() <= 0.5 + 1e-7, "{} {}", driver.count, at[axis]);
                assert!(jitter(&ticks[axis]) <= 0.5, "{:?}", ticks[axis]);
                pulses += ticks[axis].len() as u64;
                turns += u64::from(turned[axis].is_some());
                waited += u64::from(turned[axis].is_some() && ticks[axis].len() > 1);
            }
            begin += first.period;
        }
        while let Some(event) = lines.last_event() {
            drivers[event.axis].edge(event.tick, event.edge);
        }
        assert!(drivers.iter().all(|d| d.fall >= d.rise));
        for (generator, driver) in lines.generators().zip(&drivers) {
            // A refused period may have begun on axes before the one that refused it.
            assert!(!whole || generator.count() == driver.count);
        }
    }
    assert!(pulses > 1_000_000 && turns > 50_000 && waited > 10_000 && refused > 100);
}

/// Every pulse is in the tick in which the straight line between the positions passes half a step, and the next one
/// is as far away across the border of a period.
#[test]
fn pulses_lie_on_the_straight_line() {
    let timing = Timing { period: 10_000, width: 25, spacing: 50, setup: 0, hold: 50 };
    let mut random = Random::new(5);
    for _ in 0..cases(2000) {
        let speed = random.within(-200.0, 200.0);
        let start = random.within(-1e5, 1e5);
        let mut axis = Generator::new(timing, start).unwrap();
        let mut expected = if speed > 0.0 { (start + 0.5).floor() + 0.5 } else { (start + 0.5).floor() - 0.5 };
        for k in 0..20u32 {
            let train = axis.period(start + speed * f64::from(k + 1)).unwrap();
            for tick in train {
                let place = (expected - start) / speed * 10_000.0;
                let off = place - (f64::from(k) * 10_000.0 + tick as f64);
                assert!(off > -1e-3 && off < 1.001, "{off}");
                expected += speed.signum();
            }
        }
    }
}

/// A million periods there and back, over a distance that no double represents exactly: no step is lost or gained.
#[test]
fn no_drift_over_a_million_periods() {
    let timing = Timing { period: 10_000, width: 25, spacing: 50, setup: 50, hold: 50 };
    let mut axis = Generator::new(timing, 0.0).unwrap();
    let (mut count, mut pulses) = (0i64, 0u64);
    for k in 1..=1_000_000u32 {
        let t = f64::from(k) * 1e-3;
        // Within the driver's speed: 100,000 and 317 steps a second of 200,000.
        let position = 1e6 * (0.1 * t).sin() + 317.123_456_7 * t;
        let train = axis.period(position).unwrap();
        pulses += train.len() as u64;
        let sign = if train.positive { 1 } else { -1 };
        count += sign * train.count() as i64;
        assert_eq!(count, (position + 0.5).floor() as i64);
    }
    assert!(pulses > 60_000_000 && axis.pulses() == pulses && axis.count() == count);
}

#[test]
fn what_cannot_be_made_is_refused_and_changes_nothing() {
    let timing = Timing { period: 1000, width: 5, spacing: 20, setup: 100, hold: 100 };
    let mut axis = Generator::new(timing, 0.25).unwrap();
    assert!(matches!(axis.period(50.3), Err(Error::TooFast { most, .. }) if (most - 50.0).abs() < 1e-12));
    axis.period(45.25).unwrap();
    let before = axis;
    // Back at almost full speed, with 205 ticks for the direction line.
    assert_eq!(axis.period(-2.0), Err(Error::Crowded { pulses: 47 }));
    for bad in [f64::NAN, f64::INFINITY, -1.1e11] {
        assert!(matches!(axis.period(bad), Err(Error::Position { .. })));
    }
    assert_eq!(axis, before);
    assert_eq!(axis.period(10.0).unwrap().len(), 35);
    assert!(Generator::new(timing, f64::NAN).is_err());
}

/// On the ties: a position of exactly half a step counts up, from above and from below.
#[test]
fn halves_and_standing_still() {
    let timing = Timing { period: 1000, width: 5, spacing: 20, setup: 10, hold: 10 };
    let mut axis = Generator::new(timing, 0.5).unwrap();
    assert_eq!(axis.count(), 1);
    for _ in 0..100 {
        assert_eq!(axis.period(0.5).unwrap().len(), 0);
        // Noise far below a step makes no pulses.
        assert_eq!(axis.period(0.5 - 1e-9).unwrap().len(), 0);
    }
    assert_eq!((axis.period(0.4).unwrap().len(), axis.count()), (1, 0));
    assert_eq!((axis.period(0.5).unwrap().len(), axis.count()), (1, 1));
    assert_eq!((axis.period(1.5).unwrap().len(), axis.count()), (1, 2));
    assert_eq!((axis.period(-0.5).unwrap().len(), axis.count()), (2, 0));
}

#[test]
fn periods_of_nothing_and_endless_ones_are_refused() {
    for period in [0, u64::MAX] {
        let timing = Timing { period, width: 1, spacing: 2, setup: 1, hold: 1 };
        assert_eq!(Generator::new(timing, 0.0).err(), Some(Error::Period { ticks: period }));
    }
}
