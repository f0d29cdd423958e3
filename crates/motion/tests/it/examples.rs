//! Every example job as motion: all set-points within all limits, equal steps along the seam, honest findings.

use crate::number;
use crate::planning;

use crate::planning::{machine_of, read, read_machine, shipped_machine};
use proptest::prelude::*;
use seamwright_machine::{AxisKind, Joints, Machine, shipped};
use seamwright_motion::{PassMotion, Phase, SetPoint};
use seamwright_program::{Finding, PathRange, TorchPath};
use seamwright_testkit::cases;
use seamwright_weld::Welding;

const EXAMPLES: [(&str, &str); 7] = [
    ("saddle", include_str!("../../../../examples/saddle.toml")),
    ("head-nozzle", include_str!("../../../../examples/head-nozzle.toml")),
    ("ellipse", include_str!("../../../../examples/ellipse.toml")),
    ("trunnion-saddle", include_str!("../../../../examples/trunnion-saddle.toml")),
    ("oblique-girth", include_str!("../../../../examples/oblique-girth.toml")),
    ("t-joint", include_str!("../../../../examples/t-joint.toml")),
    ("taught-saddle", include_str!("../../../../examples/taught-saddle.toml")),
];

/// Its corners are blended.
const KNUCKLE: &str = include_str!("../../../../examples/knuckle-nozzle.toml");

struct Case {
    machine: Machine,
    welding: Welding,
}

impl Case {
    fn new(text: &str) -> Self {
        let welding = read(text);
        let machine = machine_of(&welding);
        Self { machine, welding }
    }

    fn motion(&self) -> Result<PassMotion, Vec<Finding>> {
        planning::plan(&self.machine, &self.welding)
    }

    fn speed(&self) -> f64 {
        self.welding.program.value.passes[0].speed_at(0.0)
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
    for (name, text) in EXAMPLES.into_iter().chain([("knuckle-nozzle", KNUCKLE)]) {
        let case = Case::new(text);
        let motion = case.motion().unwrap_or_else(|f| panic!("{name}: {f:#?}"));
        for period in [1e-3, 4e-3, 0.02] {
            let mut check = LimitCheck { machine: &case.machine, period, last: None, worst: 0.0 };
            motion.set_points(period).for_each(|p| check.add(&p.q));
            assert!(check.worst <= 1.0 + 1e-9, "{name}: {}", check.worst);
        }
    }
}

#[test]
fn the_tip_moves_along_the_seam_at_the_asked_speed() {
    for (name, text) in EXAMPLES {
        let case = Case::new(text);
        let motion = case.motion().unwrap();
        let path = case.welding.path(0);
        let v = case.speed();
        let report = motion.profile.report();
        let period = 0.01;
        let steady = |p: &SetPoint| p.profile.s > report.run_up_end && p.profile.s < report.run_down_start;
        let points: Vec<SetPoint> = motion.set_points(period).collect();
        for w in points.windows(2) {
            // The tip is on the exact path, in its attitude.
            let (tip, exact) = (case.machine.forward(&w[0].q), path.pose(w[0].profile.s));
            assert!((tip.point - exact.point).length() < 1e-8, "{name}");
            let off = (tip.direction - exact.direction).length();
            assert!(off <= 2.0 * (0.5 * motion.attitude_error.0).sin() + 1e-6, "{name} {off}");
            if steady(&w[0]) && steady(&w[1]) {
                let step = w[1].profile.s - w[0].profile.s;
                assert!((step - v * period).abs() < 1e-9 * v * period, "{name} {step}");
            }
        }
        assert!((report.least - v).abs() < 1e-12 * v && (report.greatest - v).abs() < 1e-12 * v, "{name} {report:?}");
        let last = points.last().unwrap();
        assert!((last.profile.s - path.length()).abs() < 1e-9 && last.phase == Phase::Postflow);
    }
}

#[test]
fn a_nozzle_across_a_knuckle_needs_an_answer_to_its_corners() {
    let with = |corner: &str| Case::new(&KNUCKLE.replace("corner = { blend_mm = 0.2 }", corner));
    let refused = with("").motion().unwrap_err();
    let knots = with("").welding.seam.as_ref().unwrap().knots();
    assert!(knots.len() == 2 && refused.len() == 2, "{refused:#?}");
    for (finding, s) in refused.iter().zip(&knots) {
        assert!((finding.from_mm - s).abs() < 1e-6 && finding.kind == "stop", "{finding:?}");
    }
    let case = with("corner = { blend_mm = 0.05 }");
    let (motion, path) = (case.motion().unwrap(), case.welding.path(0));
    let mut farthest: f64 = 0.0;
    for p in motion.set_points(0.01) {
        let tip = case.machine.forward(&p.q);
        let foot = path.foot(tip.point, p.profile.s, PathRange::up_to(path.length()));
        farthest = farthest.max(path.pose(foot).point.distance(tip.point));
    }
    assert!(farthest > 1e-7 && farthest < 0.05 + 1e-6, "{farthest}");
}

#[test]
fn the_profile_is_consistent_in_time_and_length() {
    let case = Case::new(EXAMPLES[0].1);
    let motion = case.motion().unwrap();
    let mut cursor = 0;
    let n = 20_000;
    let mut integral = 0.0;
    let h = motion.profile.duration() / f64::from(n);
    for i in 0..n {
        let t = (f64::from(i) + 0.5) * h;
        let p = motion.profile.at(t, &mut cursor);
        integral += p.v * h;
        assert!((motion.profile.time(p.s) - t).abs() < 1e-9);
        assert!((motion.profile.speed(p.s) - p.v).abs() < 1e-6);
    }
    assert!((integral - case.welding.seam.as_ref().unwrap().weld_length()).abs() < 5e-3);
}

#[test]
fn too_fast_is_refused_or_slowed_as_asked() {
    let fast = EXAMPLES[0].1.replace("speed_mm_s = 10", "speed_mm_s = 200");
    let case = Case::new(&fast);
    let findings = case.motion().unwrap_err();
    let speed: Vec<_> = findings.iter().filter(|f| f.kind == "speed").collect();
    assert!(
        !speed.is_empty() && speed.iter().all(|f| !f.allowed && f.message.to_string().contains("allows")),
        "{findings:#?}"
    );
    let slow = fast.replace("[weld]\n", "[weld]\non_limit = \"slow\"\n");
    let case = Case::new(&slow);
    let motion = case.motion().unwrap_or_else(|f| panic!("{f:#?}"));
    assert!(motion.findings.iter().any(|f| f.kind == "speed" && f.allowed));
    let mut check = LimitCheck { machine: &case.machine, period: 1e-3, last: None, worst: 0.0 };
    motion.set_points(1e-3).for_each(|p| check.add(&p.q));
    assert!(check.worst <= 1.0 + 1e-9 && check.worst > 0.99, "{}", check.worst);
}

/// A straight seam on which the torch leans by a little within a few mm.
fn leaning(speed: f64) -> String {
    format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"torch-5axis\"\n[seam.line]\nstart_mm = [-700, 0, 0]\n\
         end_mm = [700, 0, 0]\nfirst_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[torch]\nat = [\
         {{ s_mm = 0 }}, {{ s_mm = 700.1 }}, {{ s_mm = 704, travel_angle_deg = 2 }}]\n[weld]\nspeed_mm_s = {speed}\n"
    )
}

#[test]
fn a_short_bend_is_refused_and_the_cure_cures() {
    let findings = Case::new(&leaning(12.5)).motion().unwrap_err();
    // It brakes before the bend and gains speed after it.
    assert!(findings.iter().all(|f| f.kind == "speed" && f.from_mm > 699.0 && f.to_mm < 705.0), "{findings:#?}");
    assert!(findings[0].message.to_string().contains("jerk"), "{findings:#?}");
    let cure = number(findings[0].cure.as_ref().unwrap(), "speed");
    let motion = Case::new(&leaning(cure)).motion().unwrap();
    assert!(motion.profile.report().least >= cure * (1.0 - 1e-9) && cure > 8.0, "{:?}", motion.profile.report());
}

#[test]
fn too_short_to_reach_the_speed_is_said() {
    let short = leaning(100.0).replace("[-700, 0, 0]", "[-2.5, 0, 0]").replace("[700, 0, 0]", "[2.5, 0, 0]");
    let short = short.split("[torch]").next().unwrap().to_owned() + "[weld]\nspeed_mm_s = 100\n";
    let findings = Case::new(&short).motion().unwrap_err();
    assert!(findings[0].message.to_string().contains("too short"), "{findings:#?}");
    // Four parts of constant jerk j over 5 mm reach j t^2 with 2 j t^3 = 5 mm; 397 mm/s^2 are no limit then.
    let reached = number(&findings[0].message, "reached");
    let most = 5000.0 * (5.0 / 1e4f64).powf(2.0 / 3.0);
    assert!(reached < most && reached > 0.98 * most, "{reached} {most}");
}

#[test]
fn a_range_passed_between_two_places_is_found() {
    let case = Case::new(EXAMPLES[0].1);
    let motion = case.motion().unwrap();
    let least = (0..200_000).map(|i| motion.path.at(motion.path.length() * f64::from(i) / 2e5)[1]).fold(0.0, f64::min);
    let text = shipped("saddle-4axis").unwrap().text;
    let with = |low: f64| {
        let narrow = text.replacen("range_mm = [-200, 200]", &format!("range_mm = [{low}, 200]"), 1);
        planning::plan(&read_machine(&narrow), &case.welding)
    };
    assert!(with(least - 1e-7).is_ok());
    assert!(with(least + 1e-7).unwrap_err().iter().any(|f| f.kind == "range"));
}

#[test]
fn out_of_range_and_out_of_reach_say_where() {
    let low = EXAMPLES[0].1.replace("move_mm = [0, 0, -800]", "move_mm = [0, 0, 0]");
    let findings = Case::new(&low).motion().unwrap_err();
    let range: Vec<_> = findings.iter().filter(|f| f.kind == "range").collect();
    assert!(
        range.iter().any(|f| f.message.to_string().contains("axis h")
            && f.message.to_string().contains("beyond its limit 150.000 mm"))
    );
    let lifted = EXAMPLES[2].1.replace("[seam.ellipse]", "[placement]\nmove_mm = [0, 0, 1]\n[seam.ellipse]");
    let findings = Case::new(&lifted).motion().unwrap_err();
    assert!(
        findings.iter().all(|f| f.kind == "reach" && f.message.to_string().contains("1.0000 mm off")),
        "{findings:#?}"
    );
}

#[test]
fn missing_freedoms_are_reported_not_hidden() {
    let tilted = EXAMPLES[2].1.replace("joint = \"butt\"", "joint = \"fillet\"");
    let findings = Case::new(&tilted).motion().unwrap_err();
    assert!(findings.iter().any(|f| f.kind == "attitude" && !f.allowed));
    let accepted = tilted.replace("[weld]\n", "[tolerance]\nattitude_deg = 46\n[weld]\n");
    let case = Case::new(&accepted);
    let motion = case.motion().unwrap();
    assert!((motion.attitude_error.0 - 45f64.to_radians()).abs() < 1e-9);
    assert!(
        motion.findings.iter().any(|f| f.kind == "attitude" && f.allowed && f.message.to_string().contains("45.00"))
    );
}

#[test]
fn rotary_axes_stay_in_their_range_over_the_whole_weld() {
    // Starts at +300 degrees: one turn on from there would pass 400, so the weld starts a turn earlier.
    let text = EXAMPLES[0].1.replace("phi_deg = 20", "phi_deg = 300");
    let case = Case::new(&text);
    let motion = case.motion().unwrap_or_else(|f| panic!("{f:#?}"));
    let first = motion.path.at(0.0)[0].to_degrees();
    assert!((first + 60.0).abs() < 1e-6 && case.machine.axes[0].kind == AxisKind::Rotary, "{first}");
}

/// A nozzle on a shell somewhere in the 5-axis machine, with torch angles that change, faster than the axes can.
fn random_job() -> impl Strategy<Value = String> {
    let sizes = (30.0..250.0f64, 1.2..6.0f64, -0.4..0.4f64, -0.3..0.3f64);
    let weld = (1.0..400.0f64, 0.0..360.0f64, any::<bool>(), 0.0..30.0f64);
    let torch = prop::collection::vec((-12.0..12.0f64, -12.0..12.0f64), 2..6);
    (sizes, weld, torch).prop_map(|((r, ratio, offset, lean), (speed, phi, clockwise, overlap), torch)| {
        let shell = r * ratio;
        let direction = if clockwise { "clockwise" } else { "counter-clockwise" };
        let mut text = format!(
            "schema = 1\ntitle = \"random\"\nmachine = \"torch-5axis\"\n[placement]\nmove_mm = [0, 0, {}]\n\
             [seam.nozzle]\nradius_mm = {r}\norigin_mm = [0, {}, 0]\ndirection = [{lean}, 0, 1]\n\
             [seam.nozzle.body.cylinder]\nradius_mm = {shell}\n[start]\nphi_deg = {phi}\n\
             direction = \"{direction}\"\noverlap_mm = {overlap}\n[weld]\nspeed_mm_s = {speed}\non_limit = \"slow\"\n",
            200.0 - shell,
            offset * r,
        );
        for (i, (work, travel)) in torch.iter().enumerate() {
            let s = i as f64 / torch.len() as f64 * 6.0 * r;
            text += &format!("[[torch.at]]\ns_mm = {s}\nwork_angle_deg = {work}\ntravel_angle_deg = {travel}\n");
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(60), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_welds_keep_every_limit(text in random_job()) {
        let Ok(welding) = Welding::read("random.toml", &text) else { return Ok(()) };
        let machine = shipped_machine("torch-5axis");
        let pass = &welding.program.value.passes[0];
        let Ok(motion) = PassMotion::plan(&machine, &welding.path(0), pass, 1) else { return Ok(()) };
        let mut check = LimitCheck { machine: &machine, period: 1e-3, last: None, worst: 0.0 };
        let (mut last, mut fastest) = (0.0, 0.0f64);
        for p in motion.set_points(1e-3) {
            check.add(&p.q);
            prop_assert!(p.profile.s >= last && p.profile.v <= pass.speed_at(0.0) * (1.0 + 1e-9));
            last = p.profile.s;
            fastest = fastest.max(p.profile.v);
        }
        prop_assert!(check.worst <= 1.0 + 1e-9, "{}", check.worst);
        // The weld reaches the requested speed, or some axis' limit.
        let full = fastest > 0.999 * pass.speed_at(0.0);
        prop_assert!(full || check.worst > 0.95, "{} of {}: {}", fastest, pass.speed_at(0.0), check.worst);
    }
}
