//! A jerk-limited motion on a curved path of several axes, built in closed form, independent of the planner.

#![allow(dead_code, unreachable_pub, reason = "each user has its own part")]

pub mod orders;

use seamwright_machine::{AxisLimits, Joints};
use seamwright_motion::feed_override::{ChannelLimits, Rates, Timed, Tip};
use seamwright_testkit::Random;

/// An axis along the path: `slope * s + size * sin(wave * s + phase)`.
#[derive(Debug, Clone, Copy)]
pub struct Wave {
    pub slope: f64,
    pub size: f64,
    pub wave: f64,
    pub phase: f64,
}

/// Stretch of constant jerk along the path.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    t: f64,
    s: f64,
    v: f64,
    a: f64,
    j: f64,
}

#[derive(Debug, Clone)]
pub struct Profile {
    pub axes: Vec<Wave>,
    stretches: Vec<Stretch>,
    down: f64,
    pub duration: f64,
    pub length: f64,
}

impl Profile {
    /// Builds a motion from stretches (jerk, duration) that start and end at rest.
    fn new(axes: &[Wave], stretches: &[(f64, f64)]) -> Self {
        let mut now = Stretch { t: 0.0, s: 0.0, v: 0.0, a: 0.0, j: 0.0 };
        let mut all = Vec::new();
        for &(j, d) in stretches.iter().filter(|s| s.1 > 0.0) {
            now.j = j;
            all.push(now);
            let (a, v) = (now.a + j * d, now.v + d * (now.a + 0.5 * j * d));
            now = Stretch { t: now.t + d, s: now.s + d * (now.v + d * (0.5 * now.a + d * j / 6.0)), v, a, j };
        }
        assert!(now.v.abs() < 1e-9 && now.a.abs() < 1e-7, "not at rest: {now:?}");
        Self { axes: axes.to_vec(), stretches: all, down: 0.0, duration: now.t, length: now.s }
    }

    fn tip(&self, t: f64, before: bool) -> Tip {
        let rest = |s| Tip { s, ..Default::default() };
        if t < 0.0 || (t <= 0.0 && before) {
            return rest(0.0);
        }
        if t > self.duration || (t >= self.duration && !before) {
            return rest(self.length);
        }
        let after = |c: &Stretch| if before { c.t < t } else { c.t <= t };
        let c = &self.stretches[self.stretches.partition_point(after).saturating_sub(1)];
        let d = t - c.t;
        Tip {
            s: c.s + d * (c.v + d * (0.5 * c.a + d * c.j / 6.0)),
            v: c.v + d * (c.a + 0.5 * c.j * d),
            a: c.a + c.j * d,
            j: c.j,
        }
    }

    pub fn position(&self, s: f64) -> Joints {
        let mut q = Joints::default();
        for (q, w) in q.iter_mut().zip(&self.axes) {
            *q = w.slope * s + w.size * (w.wave * s + w.phase).sin();
        }
        q
    }

    pub fn borders(&self) -> Vec<f64> {
        self.stretches.iter().map(|s| s.t).collect()
    }

    /// Time of the last three stretches, which stop it.
    pub fn run_down(&self) -> f64 {
        self.duration - self.down
    }

    /// Maximum speed, acceleration and jerk of each axis on a dense grid with both sides of the borders.
    fn uses(&self) -> Vec<[f64; 3]> {
        let mut most = vec![[0.0f64; 3]; self.axes.len()];
        let mut see = |t: f64, before: bool| {
            let r = self.at(t, before);
            for (i, m) in most.iter_mut().enumerate() {
                *m = [m[0].max(r.v[i].abs()), m[1].max(r.a[i].abs()), m[2].max(r.j[i].abs())];
            }
        };
        for k in 0..=2000 {
            see(self.duration * f64::from(k) / 2000.0, true);
        }
        for t in self.borders() {
            see(t, true);
            see(t, false);
        }
        most
    }
}

impl Timed for Profile {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn at(&self, t: f64, before: bool) -> Rates {
        let tip = self.tip(t, before);
        let mut r = Rates { tip, ..Default::default() };
        for (i, w) in self.axes.iter().enumerate() {
            let (sin, cos) = (w.wave * tip.s + w.phase).sin_cos();
            let k = w.wave;
            let (d1, d2, d3) = (w.slope + w.size * k * cos, -w.size * k * k * sin, -w.size * k * k * k * cos);
            r.q[i] = w.slope * tip.s + w.size * sin;
            r.v[i] = d1 * tip.v;
            r.a[i] = d2 * tip.v * tip.v + d1 * tip.a;
            r.j[i] = d3 * tip.v.powi(3) + 3.0 * d2 * tip.v * tip.a + d1 * tip.j;
        }
        r
    }

    fn next_border(&self, t: f64, forward: bool) -> f64 {
        if forward {
            let i = self.stretches.partition_point(|c| c.t <= t);
            self.stretches.get(i).map_or(if t < self.duration { self.duration } else { f64::INFINITY }, |c| c.t)
        } else if t > self.duration {
            self.duration
        } else {
            let i = self.stretches.partition_point(|c| c.t < t);
            if i == 0 { f64::NEG_INFINITY } else { self.stretches[i - 1].t }
        }
    }

    fn time_of(&self, s: f64) -> f64 {
        if s <= 0.0 {
            return 0.0;
        }
        if s >= self.length {
            return self.duration;
        }
        let (mut low, mut high) = (0.0, self.duration);
        let mut t = 0.5 * high;
        for _ in 0..100 {
            let at = self.tip(t, false);
            *(if at.s > s { &mut high } else { &mut low }) = t;
            let newton = t + (s - at.s) / at.v;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - t).abs() <= 1e-16 * self.duration {
                break;
            }
            t = next;
        }
        t
    }
}

/// The jerk-limited change of speed by `dv`: three stretches, the middle one with acceleration `a`.
fn change(out: &mut Vec<(f64, f64)>, dv: f64, a: f64, j: f64) {
    let ramp = (a / j).min((dv.abs() / j).sqrt());
    let hold = (dv.abs() / (j * ramp) - ramp).max(0.0);
    let j = j.copysign(dv);
    out.extend([(j, ramp), (0.0, hold), (-j, ramp)]);
}

fn distance(v: f64, stretches: &[(f64, f64)]) -> f64 {
    let (mut s, mut v, mut a) = (0.0, v, 0.0);
    for &(j, d) in stretches {
        s += d * (v + d * (0.5 * a + d * j / 6.0));
        v += d * (a + 0.5 * j * d);
        a += j * d;
    }
    s
}

/// Builds a motion from rest to rest over `length` with speed `v`, with waves of full jerk in between if `busy`.
fn profile(axes: &[Wave], length: f64, v: f64, a: f64, j: f64, busy: Option<&mut Random>) -> Profile {
    let (mut up, mut down) = (Vec::new(), Vec::new());
    change(&mut up, v, a, j);
    change(&mut down, -v, a, j);
    let mut middle = Vec::new();
    if let Some(random) = busy {
        while distance(v, &middle) < 0.4 * length {
            let tau = random.within(0.2, 1.0) * (a / j).min((0.3 * v / j).sqrt());
            // The speed goes down and comes back.
            middle.extend([(-j, tau), (j, 2.0 * tau), (-j, tau), (j, tau), (-j, 2.0 * tau), (j, tau)]);
        }
    }
    let left = length - distance(0.0, &up) - distance(v, &middle) - distance(v, &down);
    assert!(left >= 0.0, "too short");
    let run_down: f64 = down.iter().map(|d| d.1).sum();
    middle.push((0.0, left / v));
    up.extend(middle);
    up.extend(down);
    let mut profile = Profile::new(axes, &up);
    profile.down = profile.duration - run_down;
    profile
}

/// A base motion, one for 1.5 times its speed, and limits of which they use at most 0.999.
pub struct Case {
    pub base: Profile,
    pub faster: Profile,
    pub limits: Vec<AxisLimits>,
}

impl Case {
    pub fn limits(&self) -> ChannelLimits {
        self.limits.iter().copied().collect()
    }

    pub fn random(random: &mut Random) -> Self {
        let straight = random.below(4) == 0;
        let axes: Vec<Wave> = (0..2 + random.below(3))
            .map(|_| Wave {
                slope: random.within(-1.0, 1.0),
                size: if straight { 0.0 } else { random.within(0.0, 3.0) },
                wave: random.within(0.05, 1.2),
                phase: random.within(0.0, 6.0),
            })
            .collect();
        let v = random.within(10.0, 60.0);
        let rise = random.within(0.03, 0.1);
        let a = v / rise;
        let j = a / (rise * random.within(0.15, 1.0));
        let length = v * (random.within(0.1, 0.4) + 10.0 * rise);
        let busy = random.below(2) == 0;
        let base = profile(&axes, length, v, a, j, busy.then_some(&mut *random));
        let faster = profile(&axes, length, 1.5 * v, a, j, None);
        let uses = base.uses().into_iter().zip(faster.uses());
        let limits = uses
            .map(|(b, f)| {
                let [speed, acceleration, jerk] = std::array::from_fn(|k| b[k].max(f[k]) / 0.999);
                AxisLimits { speed, acceleration, jerk }
            })
            .collect();
        let mut case = Self { base, faster, limits };
        if random.below(8) == 0 {
            case.limits.iter_mut().for_each(|l| l.jerk = f64::INFINITY);
        }
        case
    }

    /// One straight axis, for which the best stop is known: the motion's own.
    pub fn straight(v: f64, a: f64, j: f64) -> Self {
        let axes = [Wave { slope: 1.0, size: 0.0, wave: 0.0, phase: 0.0 }];
        let base = profile(&axes, 20.0 * v, v, a, j, None);
        let faster = profile(&axes, 20.0 * v, 1.5 * v, a, j, None);
        let [speed, acceleration, jerk] = [1.5 * v / 0.999, a / 0.999, j / 0.999];
        Self { base, faster, limits: vec![AxisLimits { speed, acceleration, jerk }] }
    }
}
