//! Every example job as motion: all set-points within all limits, equal steps along the seam, honest findings.

use seamwright_document::Document;
use seamwright_machine::{AxisKind, Joints, Machine, shipped};
use seamwright_motion::{PassMotion, Phase, SetPoint};
use seamwright_program::{Finding, Program, TorchPath};
use seamwright_weld::{Attitude, Job, PassPath, SeamCurve};

const EXAMPLES: [(&str, &str); 4] = [
    ("saddle", include_str!("../../../examples/saddle.toml")),
    ("head-nozzle", include_str!("../../../examples/head-nozzle.toml")),
    ("ellipse", include_str!("../../../examples/ellipse.toml")),
    ("trunnion-saddle", include_str!("../../../examples/trunnion-saddle.toml")),
];

struct Case {
    job: Document<Job>,
    machine: Machine,
    seam: SeamCurve,
    program: Program,
}

impl Case {
    fn new(name: &str, text: &str) -> Self {
        let job = Job::read(name, text).unwrap_or_else(|e| panic!("{e}"));
        let machine = Machine::read("m", shipped(&job.value.machine).unwrap().text).unwrap();
        let seam = SeamCurve::new(&job, &job.value.seam, &job.value.start).unwrap_or_else(|e| panic!("{e}"));
        let program = Job::program(&job, &seam).unwrap_or_else(|e| panic!("{e}"));
        Self { job, machine, seam, program }
    }

    fn path(&self) -> PassPath<'_> {
        let attitude = Attitude::new(&self.job, "torch", &self.program.passes[0].torch, &self.seam).unwrap();
        PassPath { seam: &self.seam, attitude, placement: self.program.placement.affine() }
    }

    fn motion(&self) -> Result<PassMotion, Vec<Finding>> {
        PassMotion::plan(&self.machine, &self.path(), &self.program.passes[0], 1)
    }
}

/// Checks positions, and speeds and accelerations by differences, of set-points that come one by one.
struct LimitCheck<'a> {
    machine: &'a Machine,
    period: f64,
    last: Option<(Joints, Option<Joints>)>,
    worst: f64,
}

impl LimitCheck<'_> {
    fn add(&mut self, q: &Joints) {
        let m = self.machine;
        assert!(m.outside(q).is_none());
        let speed = self.last.map(|(before, _)| std::array::from_fn(|i| (q[i] - before[i]) / self.period));
        if let Some(v) = speed {
            for (axis, v) in m.axes.iter().zip(&v) {
                self.worst = self.worst.max(v.abs() / axis.max_speed);
            }
            if let Some((_, Some(before))) = self.last {
                for (i, axis) in m.axes.iter().enumerate() {
                    let a: f64 = (v[i] - before[i]) / self.period;
                    // Positions are doubles: their rounding shows in second differences.
                    let rounding = 8.0 * f64::EPSILON * q[i].abs().max(1.0) / (self.period * self.period);
                    self.worst = self.worst.max((a.abs() - rounding) / axis.max_acceleration);
                }
            }
        }
        self.last = Some((*q, speed));
    }
}

#[test]
fn every_set_point_of_every_example_is_within_every_limit() {
    for (name, text) in EXAMPLES {
        let case = Case::new(name, text);
        let motion = case.motion().unwrap_or_else(|f| panic!("{name}: {f:#?}"));
        for period in [1e-3, 4e-3, 0.02] {
            let mut check = LimitCheck { machine: &case.machine, period, last: None, worst: 0.0 };
            let mut count = 0;
            for p in motion.set_points(period) {
                check.add(&p.q);
                count += 1;
            }
            println!(
                "{name} {period}: {count} set-points, worst {} of a limit, {:?}",
                check.worst,
                motion.law.report()
            );
            assert!(check.worst <= 1.0 + 1e-9, "{name}: {}", check.worst);
        }
    }
}

#[test]
fn the_tip_moves_along_the_seam_at_the_asked_speed() {
    for (name, text) in EXAMPLES {
        let case = Case::new(name, text);
        let motion = case.motion().unwrap();
        let path = case.path();
        let v = case.job.value.weld.speed_mm_s.get();
        let report = motion.law.report();
        let period = 0.01;
        let steady = |p: &SetPoint| p.law.s > report.run_up_end && p.law.s < report.run_down_start;
        let points: Vec<SetPoint> = motion.set_points(period).collect();
        for w in points.windows(2) {
            // The tip is on the exact path, in its attitude.
            let (tip, exact) = (case.machine.forward(&w[0].q), path.pose(w[0].law.s));
            assert!((tip.point - exact.point).length() < 1e-8, "{name}");
            let off = (tip.direction - exact.direction).length();
            assert!(off <= 2.0 * (0.5 * motion.attitude_error.0).sin() + 1e-6, "{name} {off}");
            if steady(&w[0]) && steady(&w[1]) {
                let step = w[1].law.s - w[0].law.s;
                assert!((step - v * period).abs() < 1e-9 * v * period, "{name} {step}");
            }
        }
        assert!((report.least - v).abs() < 1e-12 * v && (report.greatest - v).abs() < 1e-12 * v, "{name} {report:?}");
        let last = points.last().unwrap();
        assert!((last.law.s - path.length()).abs() < 1e-9 && last.phase == Phase::Postflow);
    }
}

#[test]
fn the_law_is_consistent_in_time_and_length() {
    let case = Case::new("saddle", EXAMPLES[0].1);
    let motion = case.motion().unwrap();
    let mut cursor = 0;
    let n = 20_000;
    let mut integral = 0.0;
    let h = motion.law.duration() / f64::from(n);
    for i in 0..n {
        let t = (f64::from(i) + 0.5) * h;
        let p = motion.law.at(t, &mut cursor);
        integral += p.v * h;
        assert!((motion.law.time(p.s) - t).abs() < 1e-9);
        assert!((motion.law.speed(p.s) - p.v).abs() < 1e-6);
    }
    assert!((integral - case.seam.weld_length()).abs() < 5e-3);
}

#[test]
fn too_fast_is_refused_or_slowed_as_asked() {
    let fast = EXAMPLES[0].1.replace("speed_mm_s = 10", "speed_mm_s = 200");
    let case = Case::new("saddle", &fast);
    let findings = case.motion().unwrap_err();
    let speed: Vec<_> = findings.iter().filter(|f| f.kind == "speed").collect();
    assert!(!speed.is_empty() && speed.iter().all(|f| !f.allowed && f.message.contains("allows")), "{findings:#?}");
    let slow = fast.replace("[weld]\n", "[weld]\non_limit = \"slow\"\n");
    let case = Case::new("saddle", &slow);
    let motion = case.motion().unwrap_or_else(|f| panic!("{f:#?}"));
    assert!(motion.findings.iter().any(|f| f.kind == "speed" && f.allowed));
    let mut check = LimitCheck { machine: &case.machine, period: 1e-3, last: None, worst: 0.0 };
    motion.set_points(1e-3).for_each(|p| check.add(&p.q));
    assert!(check.worst <= 1.0 + 1e-9 && check.worst > 0.99, "{}", check.worst);
}

#[test]
fn out_of_range_and_out_of_reach_say_where() {
    let low = EXAMPLES[0].1.replace("move_mm = [0, 0, -800]", "move_mm = [0, 0, 0]");
    let findings = Case::new("saddle", &low).motion().unwrap_err();
    let range: Vec<_> = findings.iter().filter(|f| f.kind == "range").collect();
    assert!(range.iter().any(|f| f.message.contains("axis h") && f.message.contains("beyond its limit 150.000 mm")));
    let lifted = EXAMPLES[2].1.replace("[seam.ellipse]", "[placement]\nmove_mm = [0, 0, 1]\n[seam.ellipse]");
    let findings = Case::new("ellipse", &lifted).motion().unwrap_err();
    assert!(findings.iter().all(|f| f.kind == "reach" && f.message.contains("1.0000 mm off")), "{findings:#?}");
}

#[test]
fn missing_freedoms_are_reported_not_hidden() {
    let tilted = EXAMPLES[2].1.replace("joint = \"butt\"", "joint = \"fillet\"");
    let case = Case::new("ellipse", &tilted);
    let motion = case.motion().unwrap();
    assert!((motion.attitude_error.0 - 45f64.to_radians()).abs() < 1e-9);
    assert!(motion.findings.iter().any(|f| f.kind == "attitude" && f.allowed && f.message.contains("45.00")));
}

#[test]
fn rotary_axes_stay_in_their_range_over_the_whole_weld() {
    // Starts at +300 degrees: one turn on from there would pass 400, so the weld starts a turn earlier.
    let text = EXAMPLES[0].1.replace("phi_deg = 20", "phi_deg = 300");
    let case = Case::new("saddle", &text);
    let motion = case.motion().unwrap_or_else(|f| panic!("{f:#?}"));
    let first = motion.path.at(0.0)[0].to_degrees();
    assert!((first + 60.0).abs() < 1e-6 && case.machine.axes[0].kind == AxisKind::Rotary, "{first}");
}
