//! Posted programs read back: the path between their words stays within the tolerance of the seam, and takes as long as
//! planned by LinuxCNC's own rules for feeds. `make peers` does the same with LinuxCNC's interpreter.

use crate::common::Planned;
use glam::DVec3;
use seamwright_machine::{AxisKind, Joints, Machine};
use seamwright_motion::PassMotion;
use seamwright_post::{Control, Dialect, Error, Level, Options, WriteOptions, linearise, write};
use seamwright_program::TorchPath;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

const EXAMPLES: [&str; 4] = [
    include_str!("../../../../examples/saddle.toml"),
    include_str!("../../../../examples/head-nozzle.toml"),
    include_str!("../../../../examples/ellipse.toml"),
    include_str!("../../../../examples/trunnion-saddle.toml"),
];

struct Posted {
    planned: Planned,
    text: String,
}

impl Posted {
    fn new(planned: Planned, options: &Options) -> Result<Self, Error> {
        let control = Control::new(&planned.machine, Dialect::Linuxcnc)?;
        let part = planned.program(&control, options)?;
        let (machine, rounding_mm) = (planned.machine.title.clone(), options.rounding_mm());
        let text = write(&control, &part, &WriteOptions { machine, rounding_mm, ..WriteOptions::default() })?;
        Ok(Self { planned, text })
    }

    fn motion(&self) -> &PassMotion {
        &self.planned.motion.passes[0]
    }
}

fn post(job: &str, options: &Options) -> Result<Posted, Error> {
    Posted::new(Planned::job(job), options)
}

/// A line or an arc of the text: positions by letter at its end, and the words of an arc.
#[derive(Clone)]
struct Read {
    at: BTreeMap<char, f64>,
    /// Centre from the start by I J K, and whether it goes clockwise.
    arc: Option<([f64; 3], bool)>,
}

impl Read {
    /// Positions at the part `f` of the way from `before`.
    fn part(&self, before: &BTreeMap<char, f64>, f: f64) -> BTreeMap<char, f64> {
        let mut at: BTreeMap<char, f64> = before.iter().map(|(l, a)| (*l, a + f * (self.at[l] - a))).collect();
        if let Some((to_centre, clockwise)) = self.arc {
            // The two letters of the plane in the order of their turn: XY, ZX, YZ.
            let plane = [('X', 'Y', 0, 1), ('Z', 'X', 2, 0), ('Y', 'Z', 1, 2)]
                .into_iter()
                .find(|p| !to_centre[p.2].is_nan() && !to_centre[p.3].is_nan());
            let (u, v, i, j) = plane.unwrap();
            let centre = (before[&u] + to_centre[i], before[&v] + to_centre[j]);
            let angle = |p: &BTreeMap<char, f64>| (p[&v] - centre.1).atan2(p[&u] - centre.0);
            let turn = (angle(&self.at) - angle(before)).rem_euclid(TAU);
            let turn = if clockwise { turn - TAU } else { turn };
            let (radius, now) = (to_centre[i].hypot(to_centre[j]), angle(before) + f * turn);
            at.insert(u, centre.0 + radius * now.cos());
            at.insert(v, centre.1 + radius * now.sin());
        }
        at
    }
}

/// Lines and arcs between arc on and arc off, the first being the start; and the arc's time.
fn read(text: &str) -> (Vec<Read>, f64) {
    let (mut here, mut points, mut time, mut on, mut inverse) = (BTreeMap::new(), Vec::new(), 0.0, false, false);
    for line in text.lines() {
        let line = line.split('(').next().unwrap_or_default().trim();
        let words: Vec<(char, f64)> =
            line.split_whitespace().map(|w| (w.chars().next().unwrap(), w[1..].parse().unwrap())).collect();
        let has = |letter: char, value: f64| words.iter().any(|w| w.0 == letter && (w.1 - value).abs() < 1e-12);
        let value = |letter: char| words.iter().find(|w| w.0 == letter).map(|w| w.1);
        inverse = (inverse || has('G', 93.0)) && !has('G', 94.0);
        if (has('M', 64.0) || has('M', 62.0)) && has('P', 0.0) && !on {
            on = true;
            points.push(Read { at: here.clone(), arc: None });
        }
        on &= !(has('M', 65.0) && has('P', 0.0));
        if has('G', 4.0) && on {
            time += value('P').unwrap();
        }
        if (0..4).any(|g| has('G', f64::from(g))) {
            let before = here.clone();
            here.extend(words.iter().copied().filter(|w| "XYZABC".contains(w.0)));
            if on {
                assert!(inverse);
                let centre = ['I', 'J', 'K'].map(|l| value(l).unwrap_or(f64::NAN));
                let arc = (has('G', 2.0) || has('G', 3.0)).then_some((centre, has('G', 2.0)));
                let read = Read { at: here.clone(), arc };
                time += duration(&before, &read, value('F').unwrap());
                points.push(read);
            }
        }
    }
    (points, time)
}

/// Time of a G93 block, s: LinuxCNC makes a feed of it, counting X Y Z if they move and else A B C, and never goes
/// below 0.1 per minute.
fn duration(a: &BTreeMap<char, f64>, read: &Read, per_minute: f64) -> f64 {
    if read.arc.is_some() {
        return 60.0 / per_minute;
    }
    let b = &read.at;
    let length =
        |letters: &str| letters.chars().filter_map(|l| Some((b.get(&l)? - a.get(&l)?).powi(2))).sum::<f64>().sqrt();
    let linear = length("XYZ");
    let length = if linear > 0.0 { linear } else { length("ABC") };
    length / (length * per_minute).max(0.1) * 60.0
}

fn joints(machine: &Machine, at: &BTreeMap<char, f64>) -> Joints {
    let mut q = Joints::default();
    for (q, axis) in q.iter_mut().zip(&machine.axes) {
        *q = axis.from_file(at[&axis.letter.unwrap()]);
    }
    q
}

/// Distance of a point from the seam, searched around path length `s`, which is set to the foot.
fn distance(path: &dyn TorchPath, point: DVec3, s: &mut f64) -> f64 {
    for _ in 0..4 {
        let h = 1e-3;
        let ahead = path.pose((*s + h).min(path.length())).point - path.pose((*s - h).max(0.0)).point;
        *s = (*s + (point - path.pose(*s).point).dot(ahead.normalize())).clamp(0.0, path.length());
    }
    (point - path.pose(*s).point).length()
}

fn check(job: &str, level: Level, tolerance_mm: f64) -> usize {
    let p = post(job, &Options { level, tolerance_mm, ..Options::default() }).unwrap();
    let (points, time) = read(&p.text);
    assert!((time / p.motion().arc_on_s() - 1.0).abs() < 1e-5, "{time} {}", p.motion().arc_on_s());
    let path = p.planned.welding.path(0);
    let mut s = 0.0;
    let mut worst = 0.0f64;
    for w in points.windows(2) {
        for k in 0..=20 {
            let f = f64::from(k) / 20.0;
            let at = w[1].part(&w[0].at, f);
            let tip = match level {
                Level::Joint => p.planned.machine.forward(&joints(&p.planned.machine, &at)).point,
                Level::Tip => DVec3::new(at[&'X'], at[&'Y'], at[&'Z']),
            };
            worst = worst.max(distance(&path, tip, &mut s));
        }
    }
    // Words have six decimals.
    assert!(worst <= tolerance_mm + 1e-5, "{worst} of {tolerance_mm}");
    assert!(
        worst > 0.3 * tolerance_mm || level == Level::Tip || points.len() < 120,
        "{worst}: more blocks than needed"
    );
    assert!((s - path.length()).abs() < 1e-5);
    points.len()
}

#[test]
fn blocks_stay_on_the_seam_and_keep_the_time() {
    for job in EXAMPLES {
        for tolerance in [0.1, 0.01, 0.001] {
            check(job, Level::Joint, tolerance);
        }
    }
    for tolerance in [0.1, 0.01] {
        check(EXAMPLES[3], Level::Tip, tolerance);
    }
}

#[test]
fn no_block_could_be_left_out() {
    // Greedy lines: doubling the tolerance must need fewer, by about the square root of two where chords decide.
    let p = post(EXAMPLES[2], &Options::default()).unwrap();
    let lines = |tolerance: f64| {
        let used = (0.9 - 0.05) * tolerance;
        linearise(&p.planned.machine, p.motion(), &[], Level::Joint, used).unwrap().blocks.len()
    };
    let (fine, coarse) = (lines(0.001), lines(0.002));
    assert!((fine as f64 / coarse as f64 - 2f64.sqrt()).abs() < 0.1, "{fine} {coarse}");
    // An ellipse's blocks, counted from its curvature: ds = sqrt(8 tol / k), so n is the integral of sqrt(k / 8 tol). A
    // tenth of the tolerance is the control's, and 2 % of the rest is kept for deviations between the stations checked.
    let (a, b, tolerance) = (20.0f64, 16.0f64, 0.001 * (0.9 - 0.05) * 0.98);
    let n: f64 = (0..100_000)
        .map(|i| {
            let t = f64::from(i) / 100_000.0 * std::f64::consts::TAU;
            let speed = (a * t.sin()).hypot(b * t.cos());
            (a * b / speed.powi(3) / (8.0 * tolerance)).sqrt() * speed
        })
        .sum::<f64>()
        * std::f64::consts::TAU
        / 100_000.0;
    let with_overlap = n * 118.447 / 113.447;
    assert!((fine as f64 - with_overlap).abs() < 0.05 * n + 3.0, "{fine} blocks, {with_overlap} by curvature");
    // Arcs: their distance goes with the cube of their length.
    let (fine, coarse) = (check(EXAMPLES[2], Level::Joint, 0.001), check(EXAMPLES[2], Level::Joint, 0.008));
    assert!((fine as f64 / coarse as f64 - 2.0).abs() < 0.4 && 2 * fine < lines(0.001), "{fine} {coarse}");
}

#[test]
fn slow_welds_keep_their_time_in_spite_of_the_control_s_least_feed() {
    let job =
        EXAMPLES[0].replace("speed_mm_s = 10", "speed_mm_s = 0.3").replace("overlap_mm = 20", "end_phi_deg = 110");
    check(&job, Level::Joint, 0.01);
}

#[test]
fn letters_must_fit_the_axes() {
    let written = |to: &str| {
        let planned = Planned::on(EXAMPLES[0], |text| text.replace("letter = \"C\"\n", to));
        Posted::new(planned, &Options::default()).map(|posted| posted.text)
    };
    assert!(matches!(written(""), Err(Error::NoLetter { .. })));
    assert!(matches!(written("letter = \"U\"\n"), Err(Error::WrongLetter { .. })));
    assert!(matches!(post(EXAMPLES[0], &Options { level: Level::Tip, ..Options::default() }), Err(Error::NoTip)));
}

#[test]
fn too_fine_a_tolerance_is_refused() {
    let options = Options { tolerance_mm: 1e-12, ..Options::default() };
    assert!(matches!(post(EXAMPLES[2], &options), Err(Error::TooFine { .. })));
}

#[test]
fn comments_cannot_carry_commands() {
    let job = EXAMPLES[2].replace("Ellipse: radiator", "Ellipse) M3 (\\nM4 radiator");
    let p = post(&job, &Options::default()).unwrap();
    assert!(p.text.starts_with("(Seamwright"));
    assert!(p.text.lines().all(|l| l.matches('(').count() <= 1 && !l.starts_with("M4") && !l.starts_with("M3")));
    assert!(p.planned.machine.axes.iter().all(|a| a.kind == AxisKind::Linear));
}

/// Values at the sides of a weave are written at every swing: each block has that of its middle, and the dwells have
/// exactly theirs.
#[test]
fn values_follow_the_weave() {
    let p = post(include_str!("../../../../examples/weave.toml"), &Options::default()).unwrap();
    let pass = &p.planned.welding.program.value.passes[0];
    let weld = p.text.split("(arc on with the motion)").nth(1).unwrap().split("M65 P0").next().unwrap();
    let (mut current, mut time, mut before, mut cursor) = (0.0, 0.0, 0.0, 0);
    let (mut at_sides, mut worst, mut most_step) = (0.0, 0.0_f64, 0.0_f64);
    let head = p.text.split("(arc on with the motion)").next().unwrap();
    for line in head.lines().rev().take(6).chain(weld.lines()) {
        let number = |letter: char| {
            let word = line.split('(').next()?.split_whitespace().find(|word| word.starts_with(letter))?;
            word[1..].parse::<f64>().ok()
        };
        if line.starts_with("M67 E0 ") {
            let next = number('Q').unwrap();
            most_step = most_step.max(if time > 0.0 { f64::abs(next - current) } else { 0.0 });
            current = next;
        }
        let Some(feed) = number('F') else { continue };
        time += 60.0 / feed;
        let s = p.motion().profile.at(time, &mut cursor).s;
        let swing = pass.swing_at(0.5 * (before + s));
        worst = worst.max((current - (190.0 - 20.0 * swing * swing)).abs());
        if (current - 170.0_f64).abs() < 1e-6 {
            at_sides += s - before;
        }
        before = s;
    }
    assert!(worst < 0.05 && most_step < 8.0, "{worst} A off, steps of {most_step} A");
    // Between the fades 0.3 s of 1.333 s, and stations that are as good.
    let share = at_sides / 110.0;
    assert!(share > 0.2 && share < 0.4, "{share}");
}
