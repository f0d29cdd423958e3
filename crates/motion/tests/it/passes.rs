//! Passes beside the seam, with another start, reversed, partial, or with changing speed: the tip's path and speed by
//! differences of set-points.

use crate::planning::{machine_of, plan, read};
use crate::positive;
use proptest::prelude::*;
use seamwright_document::{Finite, NonNegative};
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_motion::speed_profile::Bound;
use seamwright_program::{Bead, OnLimit, Pass, Ramp, Span, SpanValue, TorchPath};
use seamwright_testkit::cases;
use seamwright_weld::Welding;

const EXAMPLES: [&str; 3] = [
    include_str!("../../../../examples/saddle.toml"),
    include_str!("../../../../examples/trunnion-saddle.toml"),
    include_str!("../../../../examples/head-nozzle.toml"),
];

/// Maximum relative shortfall of the profile against the requested speed if no limit binds.
const NEARLY: f64 = 3e-3;

struct Planned {
    welding: Welding,
    machine: Machine,
    motion: PassMotion,
}

fn planned(example: &str, change: impl FnOnce(&mut Pass, f64)) -> Planned {
    let one = read(example);
    let mut program = one.program.value.clone();
    change(&mut program.passes[0], one.seam.as_ref().unwrap().length());
    let welding = read(&program.to_toml().unwrap());
    let machine = machine_of(&welding);
    let motion = plan(&machine, &welding).unwrap_or_else(|findings| panic!("{findings:#?}"));
    Planned { welding, machine, motion }
}

fn bead(rows: &[[f64; 4]]) -> Bead {
    let column = |k: usize| rows.iter().map(|r| Finite::new(r[k]).unwrap()).collect();
    let area_mm2 = vec![NonNegative::new(12.0).unwrap(); rows.len()];
    Bead {
        s_mm: column(0),
        across_mm: column(1),
        out_mm: column(2),
        work_angle_deg: column(3),
        weave_part: Vec::new(),
        area_mm2,
    }
}

/// Spans over `length` with speeds at their ends.
fn spans(pass: &mut Pass, length: f64, speeds: &[(f64, f64)]) {
    let one = pass.spans[0].clone();
    let at = |i: usize| length * i as f64 / speeds.len() as f64;
    let span = |(i, (from, to)): (usize, &(f64, f64))| Span {
        from_mm: NonNegative::new(at(i)).unwrap(),
        to_mm: positive(at(i + 1)),
        speed_mm_s: match from.to_bits() == to.to_bits() {
            true => positive(*from).into(),
            false => SpanValue::Ramp(Ramp { from: positive(*from), to: positive(*to) }),
        },
        ..one.clone()
    };
    pass.spans = speeds.iter().enumerate().map(span).collect();
}

/// A random pass as fractions: start, length, direction, parallel rows, speeds as fractions of the example's.
#[derive(Debug, Clone)]
struct Case {
    example: usize,
    begin: f64,
    turns: f64,
    reverse: bool,
    rows: Vec<(f64, f64, f64)>,
    speeds: Vec<(f64, f64)>,
    stick_out_mm: Option<f64>,
}

fn case() -> impl Strategy<Value = Case> {
    let rows = prop::collection::vec((-3.0..3.0f64, 0.0..5.0f64, -6.0..6.0f64), 1..10);
    let speeds = prop::collection::vec((0.3..1.0f64, 0.3..1.0f64), 1..4);
    let stick_out = prop::option::of(10.0..30.0f64);
    let ends = (0.0..1.0f64, 0.2..1.1f64, any::<bool>());
    (0..EXAMPLES.len(), ends, rows, speeds, stick_out).prop_map(
        |(example, (begin, turns, reverse), rows, speeds, stick_out_mm)| Case {
            example,
            begin,
            turns,
            reverse,
            rows,
            speeds,
            stick_out_mm,
        },
    )
}

impl Case {
    /// The machine of the first example has too few axes for every attitude, and a longer wire would end beside the line.
    fn own_stick_out_mm(&self) -> Option<f64> {
        self.stick_out_mm.filter(|_| self.example > 0)
    }

    fn planned(&self) -> Planned {
        planned(EXAMPLES[self.example], |pass, seam| {
            let v = pass.speed_at(0.0);
            let speeds: Vec<_> = self.speeds.iter().map(|(a, b)| (a * v, b * v)).collect();
            (pass.begin_mm, pass.reverse) = (NonNegative::new(self.begin * seam).unwrap(), self.reverse);
            pass.on_limit = OnLimit::Slow;
            pass.torch.stick_out_mm = self.own_stick_out_mm().map(positive);
            spans(pass, self.turns * seam, &speeds);
            let at = |i: usize| seam * i as f64 / self.rows.len() as f64;
            let rows = self.rows.iter().enumerate().map(|(i, r)| [at(i), r.0, r.1, r.2]);
            pass.bead = Some(bead(&rows.collect::<Vec<_>>()));
        })
    }
}

/// Rows of angles and rows of a bead a hair apart: between them second derivatives are lost in rounding.
#[test]
fn angles_a_hair_beside_a_row_of_the_bead_make_no_corner() {
    for (example, hair) in [(1, 5e-5), (2, 5e-5), (1, -2e-5), (2, -2e-5)] {
        planned(EXAMPLES[example], |pass, seam| {
            let at = |i: i32| seam * f64::from(i) / 12.0;
            let wave = |i: i32| f64::from(i).sin();
            pass.bead = Some(bead(&(0..12).map(|i| [at(i), wave(i), 1.0 + wave(2 * i), 0.0]).collect::<Vec<_>>()));
            pass.on_limit = OnLimit::Slow;
            pass.torch.at = (1..12)
                .map(|i| seamwright_program::TorchAt {
                    s_mm: Finite::new(at(i) + hair).unwrap(),
                    work_angle_deg: Finite::new(3.0 * wave(3 * i)).unwrap(),
                    travel_angle_deg: Finite::default(),
                })
                .collect();
            (pass.torch.work_angle_deg, pass.torch.travel_angle_deg) = (Finite::default(), Finite::default());
        });
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(10)))]

    /// The arc's rate by the axes is that of the path, and the arc is on the path with any stick-out.
    #[test]
    fn the_rate_of_the_axes_is_that_of_the_bead(case in case(), parts in prop::collection::vec(0.01..0.99f64, 40)) {
        let Planned { welding, machine, motion } = case.planned();
        let path = welding.path(0);
        for s in parts.iter().map(|part| part * path.length()) {
            let tip = machine.forward(&motion.path.at(s));
            prop_assert!((tip.point - path.pose(s).point).length() < 1e-8);
            let longer = case.own_stick_out_mm().map_or(0.0, |own| own - 15.0);
            prop_assert!((tip.ahead(longer).point - path.line_point(s)).length() < 1e-8);
            let (axes, tip) = (motion.path.tip_rate(&machine, s), path.rate(s));
            prop_assert!((axes - tip).abs() < 2e-6, "{} {}", axes, tip);
        }
    }

    /// By differences of set-points the arc is never faster than requested, and as fast within the profile's reserve if
    /// no limit binds.
    #[test]
    fn the_tip_has_the_asked_speed(case in case()) {
        let Planned { welding, machine, motion } = case.planned();
        let pass = &welding.program.value.passes[0];
        let drawn_back = welding.path(0).drawn_back();
        let period = 2e-3;
        let sets: Vec<_> = motion.set_points(period).filter(|set| set.profile.v > 0.0).collect();
        let legs = motion.profile.legs();
        let free = |s: f64| {
            let i = motion.certificate.intervals.iter().find(|i| i.from <= s && s <= i.to).unwrap();
            i.bound == Bound::Asked && legs.iter().any(|leg| leg.run_up_end < s && s < leg.run_down_start)
        };
        let (mut judged, mut least) = (0.0, f64::INFINITY);
        for w in sets.windows(2) {
            let [a, b] = [&w[0], &w[1]].map(|set| machine.forward(&set.q).ahead(drawn_back).point);
            let chord = (b - a).length();
            let ends = [w[0].profile.s, w[1].profile.s];
            let border = pass.spans.iter().any(|span| span.to_mm.get() > ends[0] && span.to_mm.get() <= ends[1]);
            if border {
                continue;
            }
            let [before, after] = ends.map(|s| pass.speed_at(s));
            let speed = chord / period;
            prop_assert!(speed <= before.max(after) * (1.0 + 1e-7), "at {}: {} of {}", ends[0], speed, before);
            // The speed that is reported is that of the tip: its mean over the period, in which the jerk may jump.
            let parts = 8;
            let at = |part: usize| motion.profile.at(w[0].t - motion.before_s() + period * part as f64 / parts as f64, &mut 0);
            let mean = |part: usize| {
                let [v0, v1] = [at(part), at(part + 1)].map(|profile| motion.tip_speed(&machine, profile));
                0.5 * (v0 + v1) / parts as f64
            };
            let reported: f64 = (0..parts).map(mean).sum();
            let runs = speed > 0.5 * before;
            prop_assert!(!runs || (reported - speed).abs() < 1e-4 * speed, "reported {} is {}", reported, speed);
            if free(ends[0]) && free(ends[1]) {
                judged += chord;
                least = f64::min(least, speed / before.min(after));
            }
        }
        prop_assert!(judged == 0.0 || least >= 1.0 - NEARLY, "{} over {} mm", least, judged);
    }
}
