//! Commands at any time: on the path, in limits, to the same end.

mod pace_law;

use pace_law::{Case, Uniform, cases};
use seamwright_motion::pace::{Command, Pace, Played, Timed};

const PERIOD: f64 = 0.002;

/// What was seen over a run.
#[derive(Debug, Default, Clone, Copy)]
struct Seen {
    off_path: f64,
    speed: f64,
    acceleration: f64,
    jerk: f64,
    /// Greatest step of the path length against the speeds at its ends, mm.
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
            if std::env::var("OVER").is_ok() && ((p.rates.j[i].abs() / l.jerk) > 1.0 + 1e-9 || (p.rates.a[i].abs() / l.acceleration) > 1.0 + 1e-9) {
                let b = if p.faster { &case.faster } else { &case.base };
                println!("OVER axis {i} theta {} phi {} faster {} inf {} j {} a {} borders {} {} per {}", p.theta, p.phi, p.faster, l.jerk.is_infinite(), p.rates.j[i].abs() / l.jerk, p.rates.a[i].abs() / l.acceleration, b.next_border(p.theta, false), b.next_border(p.theta, true), self.periods);
            }
            self.jerk = self.jerk.max(p.rates.j[i].abs() / l.jerk);
        }
    }

    /// Plays a period and looks at ten places in it.
    fn step(&mut self, case: &Case, pace: &mut Pace<pace_law::Law>, last: &Played) -> Played {
        let now = pace.step();
        let mut before = *last;
        for k in (0..10).rev() {
            let p = pace.earlier(PERIOD * f64::from(k) / 10.0);
            self.see(case, &p);
            let mean = 0.5 * (p.rates.tip.v + before.rates.tip.v) * PERIOD / 10.0;
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

fn random_command(random: &mut Uniform, length: f64) -> Command {
    match random.below(8) {
        0 | 1 => Command::Hold,
        2 => Command::Resume,
        3 => Command::Reverse,
        4 => Command::Override(random.in_range(0.0, 1.0)),
        5 => Command::Override(random.in_range(1.0, 1.5)),
        6 => Command::Override(1.0),
        _ => Command::StopAt(random.in_range(0.0, length)),
    }
}

/// One run of random commands, and then to the end, to the start, or to rest.
fn run(seed: u32) -> Seen {
    let random = &mut Uniform::new(seed);
    let case = Case::random(random);
    let mut pace =
        Pace::new(&case.limits(), PERIOD, &case.base).unwrap().with_faster(&case.faster, 1.5).unwrap();
    let mut seen = Seen::default();
    let mut last = pace.earlier(0.0);
    pace.command(Command::Resume).unwrap();
    let mut given = vec![];
    for _ in 0..1 + random.below(5) {
        let command = random_command(random, case.base.length);
        given.push(command);
        for _ in 0..random.below(60) {
            last = seen.step(&case, &mut pace, &last);
        }
        pace.command(command).unwrap();
    }
    let ending = random.below(3);
    let value = random.in_range(0.3, 1.5);
    pace.command(Command::Override(value)).unwrap();
    pace.command([Command::Resume, Command::Reverse, Command::Hold][ending as usize]).unwrap();
    let mut left = 20_000;
    while !pace.at_rest() && left > 0 {
        last = seen.step(&case, &mut pace, &last);
        left -= 1;
    }
    assert!(left > 0, "seed {seed}: never at rest: {given:?} {last:?}");
    assert!(last.phi == 0.0 && last.rates.tip.v == 0.0 && last.rates.tip.a == 0.0, "seed {seed}: {last:?}");
    let law = if last.faster { &case.faster } else { &case.base };
    match ending {
        0 => assert!(last.theta == law.duration() && last.rates.tip.s == law.length, "seed {seed}: {last:?}"),
        1 => assert!(last.theta == 0.0 && last.rates.tip.s == 0.0, "seed {seed}: {last:?}"),
        _ => {}
    }
    if std::env::var("VERBOSE").is_ok() { println!("{seed} {:?}", seen); }
    seen
}

#[test]
fn one() {
    if let Ok(s) = std::env::var("SEED") {
        run(s.parse().unwrap());
    }
}

#[test]
fn ten_thousand_runs_with_random_commands() {
    let runs = cases(std::env::var("PACE_RUNS").ok().and_then(|v| v.parse().ok()).unwrap_or(1000));
    let half = |from: u32| (from..runs).step_by(2).map(run).fold(Seen::default(), Seen::join);
    let seen = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        half(0).join(other.join().unwrap())
    });
    println!("{runs} runs: {seen:?}");
    assert!(seen.off_path <= 1e-9, "{seen:?}");
    assert!(seen.speed.max(seen.acceleration).max(seen.jerk) <= 1.0 + 1e-9, "{seen:?}");
    assert!(seen.on_faster > u64::from(runs), "{seen:?}");
}
