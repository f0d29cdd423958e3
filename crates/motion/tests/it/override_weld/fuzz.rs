//! Random commands at random times on real welds: on the seam, in limits, to the same end.

use super::welds::{self, Weld};
use seamwright_machine::Joints;
use seamwright_motion::feed_override::{Command, FeedOverride, PassTimed, Played, Timed};
use seamwright_testkit::{Random, cases};

/// Samples in a period.
const PLACES: u32 = 3;

#[derive(Debug, Default, Clone, Copy)]
struct Seen {
    /// Maximum distance of the tip, by forward kinematics, from the seam, mm.
    off_seam: f64,
    /// Maximum use of a limit, by the played rates.
    limits: f64,
    /// The same by differences of positions alone, less their rounding.
    differences: f64,
    /// Maximum distance of an axis from its end position without commands.
    off_end: f64,
    periods: u64,
    on_faster: u64,
}

impl Seen {
    fn join(self, o: Self) -> Self {
        Self {
            off_seam: self.off_seam.max(o.off_seam),
            limits: self.limits.max(o.limits),
            differences: self.differences.max(o.differences),
            off_end: self.off_end.max(o.off_end),
            periods: self.periods + o.periods,
            on_faster: self.on_faster + o.on_faster,
        }
    }

    /// Differences are means of the derivatives: never above their maximum.
    fn differ(&mut self, weld: &Weld, q: &[Joints; 4], h: f64) {
        for (i, axis) in weld.machine.axes.iter().enumerate() {
            let [a, b, c, d] = q.map(|q| q[i]);
            let rounding = 8.0 * f64::EPSILON * d.abs().max(1.0);
            let all = [
                (d - c, h * axis.max_speed),
                (d - 2.0 * c + b, h * h * axis.max_acceleration),
                (d - 3.0 * c + 3.0 * b - a, h * h * h * axis.jerk()),
            ];
            let part = all.map(|(step, most)| (step.abs() - rounding).max(0.0) / most);
            self.differences = part.iter().fold(self.differences, |m, p| m.max(*p));
        }
    }
}

/// A feed override that is played and checked.
struct Watched<'a> {
    weld: &'a Weld,
    feed_override: FeedOverride<'a, PassTimed<'a>>,
    last: [Joints; 4],
    seen: Seen,
}

impl Watched<'_> {
    fn step(&mut self) -> Played {
        let now = self.feed_override.step();
        let h = self.feed_override.period() / f64::from(PLACES);
        for k in (0..PLACES).rev() {
            let p = self.feed_override.earlier(f64::from(k) * h);
            self.seen.limits = self.seen.limits.max(self.weld.use_of_limits(&p.rates));
            self.last.rotate_left(1);
            self.last[3] = p.rates.q;
            self.seen.differ(self.weld, &self.last, h);
        }
        self.seen.off_seam = self.seen.off_seam.max(self.weld.off_seam(&now.rates));
        self.seen.periods += 1;
        self.seen.on_faster += u64::from(now.faster);
        now
    }

    fn rest(&mut self, what: &str) -> Played {
        for _ in 0..60_000 {
            let now = self.step();
            if self.feed_override.at_rest() {
                assert!(now.phi == 0.0 && now.rates.tip.v == 0.0 && now.rates.tip.a == 0.0, "{what}: {now:?}");
                return now;
            }
        }
        panic!("{what}: never at rest: {:?}", self.feed_override.earlier(0.0));
    }
}

fn command(random: &mut Random, here: f64, length: f64) -> Command {
    match random.below(9) {
        0 | 1 => Command::Hold,
        2 => Command::Resume,
        3 => Command::Reverse,
        4 => Command::Override(random.within(0.0, 1.0)),
        5 => Command::Override(random.within(1.0, 1.5)),
        6 => Command::Override(1.0),
        7 => Command::StopAt((here + random.within(-0.5, 0.5)).clamp(0.0, length)),
        _ => Command::StopAt((here + random.within(-5.0, 5.0)).clamp(0.0, length)),
    }
}

/// Random commands from a station near one of the weld's ends, to save time, and then to that end.
fn run(seed: u32, welds: &[(&Weld, PassTimed, PassTimed)]) -> Seen {
    let random = &mut Random::of_case(seed);
    let (weld, base, faster) = &welds[random.below(welds.len())];
    let (back, duration) = (random.below(3) == 0, base.duration());
    let away = random.within(0.0, duration.min(0.4));
    let start = base.at(if back { away } else { duration - away }, false);
    let period = random.within(0.002, 0.004);
    let feed_override = FeedOverride::new(&weld.limits(), period, base).unwrap().with_faster(faster, 1.5).unwrap();
    let feed_override = feed_override.from_place(start.tip.s.min(weld.length())).unwrap();
    let first = feed_override.earlier(0.0).rates.q;
    let mut watched = Watched { weld, feed_override, last: [first; 4], seen: Seen::default() };
    watched.feed_override.command(Command::Resume).unwrap();
    let mut given = format!("{}, seed {seed}, period {period}, from {}:", weld.name, start.tip.s);
    for _ in 0..1 + random.below(6) {
        let periods = random.below(30);
        let now = (0..periods).map(|_| watched.step()).last().unwrap_or_else(|| watched.feed_override.earlier(0.0));
        let command = command(random, now.rates.tip.s, weld.length());
        given += &format!(" {periods} {command:?}");
        watched.feed_override.command(command).unwrap();
    }
    if random.below(2) == 0 {
        watched.feed_override.command(Command::Hold).unwrap();
        watched.rest(&given);
    }
    watched.feed_override.command(Command::Override(if random.below(2) == 0 { 1.0 } else { 1.5 })).unwrap();
    watched.feed_override.command(if back { Command::Reverse } else { Command::Resume }).unwrap();
    let end = watched.rest(&given);
    let s = if back { 0.0 } else { weld.length() };
    assert!(end.rates.tip.s == s && watched.feed_override.at_end() != back, "{given}: {end:?}");
    let axes = weld.position(s).into_iter().zip(end.rates.q);
    let off_end = axes.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let seen = Seen { off_end, ..watched.seen };
    assert!(seen.limits <= 1.0 + 1e-9 && seen.differences <= 1.0 + 1e-6, "{given}: {seen:?}");
    assert!(seen.off_seam <= 1e-9 && seen.off_end <= 1e-9, "{given}: {seen:?}");
    seen
}

/// With those of `tests/it/feed_override.rs` ten thousand; `SEAMWRIGHT_SOAK` multiplies them.
#[test]
fn random_commands_on_welds() {
    let runs = cases(4000);
    let welds: Vec<_> = welds::all().iter().map(|w| (w, w.base(), w.faster())).collect();
    let half = |from: u32| (from..runs).step_by(2).map(|seed| run(seed, &welds)).fold(Seen::default(), Seen::join);
    let seen = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        half(0).join(other.join().unwrap())
    });
    assert!(seen.on_faster > u64::from(runs) && seen.limits > 0.9, "{seen:?}");
}
