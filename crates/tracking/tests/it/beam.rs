//! Beam mode: joint detection in short interruptions of the weld, and its corrections, for many seams and cameras.

use glam::{DVec2, DVec3};
use seamwright_machine::{AxisLimits, BeamDeflection};
use seamwright_testkit::Random;
use seamwright_tracking::actuator::{Alarm, SlideLimits};
use seamwright_tracking::beam::{
    Beam, BeamReplay, BeamTracking, DeviationRecord, Error, Misfit, Orders, Picture, Point, Recorder, Replay,
    ReplaySettings, Settings, Taken,
};
use seamwright_tracking::lead::{Moment, Refusal, SeamFrame};

const BEAM: BeamDeflection = BeamDeflection { range_mm: 2.0, speed: 2000.0, latency_s: 75e-6, pivot_mm: 400.0 };
const AXES: SlideLimits =
    SlideLimits { stroke_mm: 5.0, motion: AxisLimits { speed: 5.0, acceleration: 30.0, jerk: 300.0 } };
const CYCLE: f64 = 1e-3;
const RADIUS: f64 = 150.0;

/// A ring in the plane; lateral is towards its centre.
fn ring(s: f64) -> SeamFrame {
    let (sin, cos) = (s / RADIUS).sin_cos();
    SeamFrame {
        point: DVec3::new(RADIUS * sin, RADIUS * (1.0 - cos), 0.0),
        along: DVec3::new(cos, sin, 0.0),
        lateral: DVec3::new(-sin, cos, 0.0),
        height: DVec3::Z,
    }
}

/// Lateral deviation of the actual seam, mm.
fn beside(s: f64) -> f64 {
    2.2 * (0.006 * s + 0.5).sin() + 0.5 * (0.03 * s).cos()
}

/// Midline points every millimetre, seen from a torch at `s` that is carried aside by `carried`.
fn points(s: f64, carried: f64, error: &mut impl FnMut() -> f64) -> Vec<Point> {
    let here = ring(s);
    let point = |k: i32| {
        let along_mm = f64::from(k);
        let mut place = s + along_mm;
        let off = |place: f64| ring(place).point + beside(place) * ring(place).lateral - here.point;
        for _ in 0..8 {
            place += along_mm - off(place).dot(here.along);
        }
        (place >= 0.0).then(|| Point {
            along_mm,
            lateral_mm: off(place).dot(here.lateral) - carried + error(),
            confidence: 0.95,
        })
    };
    (-20..=24).filter_map(point).collect()
}

/// Simulated weld with an ideal gun; a [`Wrong`] alters the points, time stamp and arrival of a picture.
struct Weld {
    cycle: u64,
    s: f64,
    carried: f64,
    under_way: Vec<(f64, f64, Vec<Point>)>,
    misses: Vec<(f64, f64)>,
    taken: Vec<Taken>,
    alarms: Vec<(f64, Alarm)>,
    random: Random,
}

type Wrong<'a> = &'a mut dyn FnMut(f64, &mut f64, &mut f64, &mut Vec<Point>);

#[derive(Clone, Copy)]
struct Stretch {
    to_mm: f64,
    speed_mm_s: f64,
}

impl Weld {
    fn new(seed: u32) -> Self {
        let random = Random::of_case(seed);
        let (under_way, misses, taken, alarms) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { cycle: 0, s: 0.0, carried: 0.0, under_way, misses, taken, alarms, random }
    }

    /// Welds a stretch from rest; returns false if it was stopped.
    fn run(&mut self, head: &mut BeamTracking<'_>, stretch: Stretch, wrong: Wrong<'_>) -> bool {
        while self.s < stretch.to_mm {
            self.cycle += 1;
            let t = self.cycle as f64 * CYCLE;
            let welds = t > 1.2;
            let v = if welds { stretch.speed_mm_s } else { 0.0 };
            self.s += v * CYCLE;
            while let Some(i) = self.under_way.iter().position(|(due, ..)| *due <= t) {
                let (_, exposed_s, points) = self.under_way.remove(i);
                self.taken.push(head.take(&Picture { exposed_s, height_mm: 0.0, points: &points }, t));
            }
            let orders = head.cycle(Moment { t_s: t, s_mm: self.s, slide: DVec2::new(self.carried, 0.0) }, v, welds);
            if let Beam::Seen(mut exposed) = orders.beam {
                let then = self.s - v * (t - exposed);
                let random = &mut self.random;
                let mut error =
                    || 0.03 * (random.within(-1.0, 1.0) + random.within(-1.0, 1.0) + random.within(-1.0, 1.0));
                let mut seen = points(then, self.carried, &mut error);
                let mut due = t + 0.045;
                wrong(self.s, &mut exposed, &mut due, &mut seen);
                self.under_way.push((due, exposed, seen));
            }
            if welds && !self.apply(&orders) {
                return false;
            }
            self.carried = orders.carried_mm;
        }
        true
    }

    fn apply(&mut self, orders: &Orders) -> bool {
        self.misses.push((self.s, self.carried + orders.deflection_mm - beside(self.s)));
        self.alarms.extend(orders.alarm.map(|alarm| (self.s, alarm)));
        orders.feed_override > 0.0
    }

    fn within(&self, part: f64) -> f64 {
        let mut misses: Vec<f64> = self.misses.iter().map(|m| m.1.abs()).collect();
        misses.sort_by(f64::total_cmp);
        misses[((misses.len() - 1) as f64 * part) as usize]
    }
}

fn right(_: f64, _: &mut f64, _: &mut f64, _: &mut Vec<Point>) {}

/// The beam follows a seam with deviations up to 2.6 mm at any speed. The axes carry the excess over the deflection
/// range, and an alarm reports it.
#[test]
fn a_ring_is_met() {
    for (speed, seed) in [5.0, 8.0, 10.0].into_iter().flat_map(|v| (0..8).map(move |seed| (v, seed))) {
        let mut head = BeamTracking::new(Settings::usual(10.0), &ring, BEAM, AXES).unwrap();
        let mut weld = Weld::new(seed);
        assert!(weld.run(&mut head, Stretch { to_mm: 300.0, speed_mm_s: speed }, &mut right));
        assert!(weld.within(0.99) < 0.04 && weld.within(1.0) < 0.08, "{speed} {seed}: {}", weld.within(0.99));
        assert!(weld.alarms.iter().all(|(_, alarm)| *alarm == Alarm::AxesCarry), "{:?}", weld.alarms.last());
        assert!(!weld.alarms.is_empty());
        // Each picture is used except for points in the heat or too far ahead.
        assert!(weld.taken.iter().all(|t| t.refused.is_none() && t.used >= 5 && t.gated <= 2), "{:?}", weld.taken);
    }
}

#[test]
fn outliers_and_tacks() {
    for seed in 0..40 {
        let mut head = BeamTracking::new(Settings::usual(10.0), &ring, BEAM, AXES).unwrap();
        let mut weld = Weld::new(seed);
        let mut random = Random::of_case(seed + 100);
        let mut wrong = |s: f64, _: &mut f64, _: &mut f64, seen: &mut Vec<Point>| {
            seen.retain(|p| !(100.0..105.0).contains(&(s + p.along_mm)));
            for point in seen {
                if random.one_in(20) {
                    point.lateral_mm += 3.0 * random.within(-1.0, 1.0);
                }
            }
        };
        assert!(
            weld.run(&mut head, Stretch { to_mm: 250.0, speed_mm_s: 10.0 }, &mut wrong),
            "{seed}: {:?}",
            weld.alarms.last()
        );
        assert!(weld.within(0.95) < 0.04, "{seed}: {}", weld.within(0.95));
        // On the tack, which is 2 % of the way, the seam is bridged.
        assert!(weld.within(1.0) < 0.15, "{seed}: {}", weld.within(1.0));
    }
}

/// A single picture of another line, such as a scratch, is ignored; a moved part is followed from the second picture
/// on.
#[test]
fn other_lines_and_parts_that_move() {
    for (seed, moves) in [(1, false), (2, false), (3, true), (4, true)] {
        let mut head = BeamTracking::new(Settings::usual(10.0), &ring, BEAM, AXES).unwrap();
        let mut weld = Weld::new(seed);
        let mut count = 0;
        let mut wrong = |s: f64, _: &mut f64, _: &mut f64, seen: &mut Vec<Point>| {
            count += u32::from(s >= 100.0);
            if if moves { count > 0 } else { count == 1 } {
                seen.iter_mut().for_each(|p| p.lateral_mm += 0.8);
            }
        };
        assert!(
            weld.run(&mut head, Stretch { to_mm: 200.0, speed_mm_s: 10.0 }, &mut wrong),
            "{seed} {:?}",
            weld.alarms.last()
        );
        let off = |from: f64, to: f64, by: f64| {
            weld.misses.iter().filter(|m| (from..to).contains(&m.0)).map(|m| (m.1 - by).abs()).fold(0.0, f64::max)
        };
        assert!(off(0.0, 100.0, 0.0) < 0.08);
        if moves {
            // Two pictures, and the distance to the start of the zone.
            assert!(off(113.0, 200.0, 0.8) < 0.08, "{}", off(113.0, 200.0, 0.8));
        } else {
            assert!(off(100.0, 200.0, 0.0) < 0.08, "{}", off(100.0, 200.0, 0.0));
        }
    }
}

/// Pictures fail from half-way on, in several ways. The cause is reported; the weld stays near the seam as far as it is
/// known, fades out to the taught path and stops.
#[test]
fn eyes_that_fail() {
    const THERE: f64 = 120.0;
    let settings = Settings::usual(10.0);
    let (_, lead) = settings.check().unwrap();
    let known = lead.lead_mm;
    let frozen = || {
        let mut kept: Option<Vec<Point>> = None;
        move |s: f64, _: &mut f64, _: &mut f64, seen: &mut Vec<Point>| {
            if s >= THERE {
                *seen = kept.get_or_insert_with(|| seen.clone()).clone();
            }
        }
    };
    for seed in 0..5 {
        let mut random = Random::of_case(seed);
        let mut frozen = frozen();
        let mut silent = |s: f64, _: &mut f64, due: &mut f64, _: &mut Vec<Point>| {
            if s >= THERE {
                *due = f64::INFINITY;
            }
        };
        let mut wild = |s: f64, _: &mut f64, _: &mut f64, seen: &mut Vec<Point>| {
            if s >= THERE {
                seen.iter_mut().for_each(|p| p.lateral_mm = 15.0 * random.within(-1.0, 1.0));
            }
        };
        let mut late =
            |s: f64, _: &mut f64, due: &mut f64, _: &mut Vec<Point>| *due += if s >= THERE { 0.9 } else { 0.0 };
        let mut clock =
            |s: f64, at: &mut f64, _: &mut f64, _: &mut Vec<Point>| *at += if s >= THERE { 0.5 } else { 0.0 };
        let cases: [(&str, Wrong<'_>, Option<Refusal>); 5] = [
            ("silent", &mut silent, None),
            ("frozen", &mut frozen, Some(Refusal::Frozen)),
            ("wild", &mut wild, None),
            ("late", &mut late, Some(Refusal::Late)),
            ("clock", &mut clock, Some(Refusal::Clock)),
        ];
        for (name, wrong, refusal) in cases {
            let mut head = BeamTracking::new(settings, &ring, BEAM, AXES).unwrap();
            let mut weld = Weld::new(seed);
            assert!(!weld.run(&mut head, Stretch { to_mm: 400.0, speed_mm_s: 10.0 }, wrong), "{name}");
            let stopped = weld.s - THERE;
            let least = lead.coast_mm() + lead.fade_mm;
            assert!((least..least + known + 4.0).contains(&stopped), "{name} {seed}: {stopped}");
            assert_eq!(weld.alarms.last().map(|a| a.1), Some(Alarm::Lost));
            let first = weld.alarms.iter().find(|(s, alarm)| *s > THERE && *alarm >= Alarm::Blind).unwrap();
            // 2.5 periods, plus up to one for the age of the last picture.
            assert!(first.0 - THERE < 3.6 * 0.3 * 10.0, "{name}: {first:?}");
            assert_eq!(weld.taken.iter().rev().find_map(|t| t.refused), refusal, "{name}");
            // The weld meets the known part, then drifts by at most the seam's turn and fades out to the taught path.
            let off = |from: f64, to: f64| {
                let misses = weld.misses.iter().filter(|m| (from..to).contains(&(m.0 - THERE)));
                misses.map(|m| m.1.abs()).fold(0.0, f64::max)
            };
            assert!(off(0.0, 5.0) < 0.1, "{name} {seed}: {}", off(0.0, 5.0));
            assert!(off(0.0, lead.coast_mm()) < 0.4, "{name} {seed}: {}", off(0.0, lead.coast_mm()));
            let farthest = (0..600).map(|k| beside(THERE + 0.1 * f64::from(k)).abs()).fold(0.0, f64::max);
            assert!(off(0.0, 100.0) < farthest + 0.1, "{name} {seed}: {}", off(0.0, 100.0));
        }
    }
}

fn recorded(length: f64) -> DeviationRecord {
    let mut recorder = Recorder::new(length, 0.5, 0.03);
    let mut s = -1.0;
    while s < length + 1.0 {
        let value = DVec2::new(beside(s), 0.0);
        let sight = seamwright_tracking::lead::Sight::Seen;
        recorder.add(s, &seamwright_tracking::lead::Estimate { value, sigma_mm: 0.03, sight });
        s += 0.5;
    }
    recorder.finish().unwrap()
}

/// Replays a pass from 40 mm on of a stored seam displaced by `moved`. Returns the position of a stop, the fit, the
/// maximum error and the number of frames.
fn replayed(moved: f64, settings: ReplaySettings, seed: u32) -> (f64, Option<Result<f64, Misfit>>, f64, u32) {
    let replay = Replay::new(recorded(200.0), 40.0, 150.0, 0.03).unwrap();
    let later = |s: f64| ring(s + 40.0);
    let mut head = BeamReplay::new(settings, replay, &later, BEAM, AXES).unwrap();
    let (mut random, mut s, mut carried, mut worst, mut looks) = (Random::of_case(seed), 0.0, 0.0, 0.0f64, 0);
    for cycle in 0..16_000 {
        let t = f64::from(cycle) * CYCLE;
        let v = if t > 1.2 { 10.0 } else { 0.0 };
        s += v * CYCLE;
        let orders = head.cycle(Moment { t_s: t, s_mm: s, slide: DVec2::new(carried, 0.0) }, v);
        if let Beam::Seen(exposed_s) = orders.beam {
            looks += 1;
            let mut error = || moved + 0.03 * (random.within(-1.0, 1.0) + random.within(-1.0, 1.0));
            let seen = points(s + 40.0 - v * (t - exposed_s), carried, &mut error);
            head.take(&Picture { exposed_s, height_mm: 0.0, points: &seen }, t);
        }
        if orders.feed_override <= 0.0 {
            assert_eq!(orders.alarm, Some(Alarm::Misfit));
            break;
        }
        if v > 0.0 {
            worst = worst.max((carried + orders.deflection_mm - beside(s + 40.0) - moved).abs());
        }
        carried = orders.carried_mm;
    }
    (s, head.judged().map(|j| j.map(|fit| fit.median_mm)), worst, looks)
}

/// A fitting record is replayed exactly after three frames; a misfit is refused with its numbers.
#[test]
fn replays_fit_or_are_refused() {
    for seed in 0..10 {
        let (s, fit, worst, looks) = replayed(0.0, ReplaySettings::USUAL, seed);
        assert!(s > 140.0 && worst < 0.005 && looks == 3, "{s} {worst} {looks}");
        assert!(fit.unwrap().unwrap().abs() < 0.02, "{fit:?}");
        for moved in [-0.3, 0.2, 1.0] {
            let (s, fit, ..) = replayed(moved, ReplaySettings::USUAL, seed);
            let Some(Err(Misfit::Moved { median_mm, within_mm, .. })) = fit else { panic!("{moved}: {fit:?}") };
            assert!(s < 0.1 && (median_mm - moved).abs() < 0.03 && within_mm > moved.abs() - 0.03, "{fit:?}");
        }
    }
    let (s, fit, _, looks) = replayed(0.3, ReplaySettings { frames: 0, ..ReplaySettings::USUAL }, 1);
    assert!(s > 140.0 && fit.is_none() && looks == 0, "unchecked if that is asked for");
}

#[test]
fn what_cannot_be_replayed_is_refused() {
    let refused = |shift, length| Replay::new(recorded(200.0), shift, length, 0.03).unwrap_err();
    for (shift, length) in [(0.0, 204.0), (-5.0, 100.0), (150.0, 100.0)] {
        assert!(matches!(refused(shift, length), Error::NotCovered { last_mm, .. } if last_mm > 200.0));
    }
    // Empty pictures.
    let replay = Replay::new(recorded(200.0), 0.0, 150.0, 0.03).unwrap();
    let mut head = BeamReplay::new(ReplaySettings::USUAL, replay, &ring, BEAM, AXES).unwrap();
    for i in 0..3 {
        assert!(head.judged().is_none());
        head.take(&Picture { exposed_s: 0.0, height_mm: 0.0, points: &[] }, 0.01 * f64::from(i));
    }
    let misfit = head.judged().unwrap().unwrap_err();
    assert_eq!(misfit, Misfit::Unseen { points: 0, frames: 3 });
    assert!(misfit.to_string().contains("0 points in 3 frames"), "{misfit}");
    // A silent camera stops the weld too.
    let replay = Replay::new(recorded(200.0), 0.0, 150.0, 0.03).unwrap();
    let mut head = BeamReplay::new(ReplaySettings::USUAL, replay, &ring, BEAM, AXES).unwrap();
    let stops = (1..5000u32).find(|i| {
        let t = f64::from(*i) * CYCLE;
        head.cycle(Moment { t_s: t, s_mm: 10.0 * t, slide: DVec2::ZERO }, 10.0).feed_override <= 0.0
    });
    assert!(stops.is_some_and(|i| i < 2000), "{stops:?}");
    assert_eq!(head.judged().unwrap().unwrap_err(), Misfit::Unseen { points: 0, frames: 0 });
}

#[test]
fn axes_that_are_stuck_stop_it() {
    let mut head = BeamTracking::new(Settings::usual(10.0), &ring, BEAM, AXES).unwrap();
    let mut weld = Weld::new(1);
    assert!(weld.run(&mut head, Stretch { to_mm: 40.0, speed_mm_s: 10.0 }, &mut right));
    // From here on the gun does not move.
    let (held, mut s, mut stopped) = (weld.carried, weld.s, None);
    for i in 0..30_000u32 {
        let t = (weld.cycle + 1 + u64::from(i)) as f64 * CYCLE;
        s += 10.0 * CYCLE;
        let orders = head.cycle(Moment { t_s: t, s_mm: s, slide: DVec2::new(held, 0.0) }, 10.0, true);
        if let Beam::Seen(exposed_s) = orders.beam {
            let seen = points(s - 10.0 * (t - exposed_s), held, &mut || 0.0);
            head.take(&Picture { exposed_s, height_mm: 0.0, points: &seen }, t);
        }
        let miss = held + orders.deflection_mm - beside(s);
        assert!(miss.abs() < 0.1, "the deflection makes up for it: {miss} at {s}");
        if orders.feed_override <= 0.0 {
            stopped = Some(orders.alarm);
            break;
        }
    }
    assert_eq!(stopped, Some(Some(Alarm::SlideStuck)), "{s}");
}
