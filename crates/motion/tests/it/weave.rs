//! Woven passes as motion: limits by differences, the speed of the centre line, the weave's frequency in time, and its
//! maximum.

use crate::number;
use crate::planning;
use crate::planning::{machine_of, read, shipped_machine};
use proptest::prelude::*;
use seamwright_geometry::Pose;
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::{Finding, Groove, TorchPath, WovenPath};
use seamwright_testkit::cases;
use seamwright_weld::Welding;
use std::sync::atomic::{AtomicU64, Ordering};

const WEAVE: &str = include_str!("../../../../examples/weave.toml");

fn text(arc: bool, weave: &str) -> String {
    let text = WEAVE.split("[weld.weave]").next().unwrap();
    let text = match arc {
        true => text.replace("[seam.polyline]\npoints_mm = [[-60, 0, 0], [60, 0, 0]]", "[seam.circle]\nradius_mm = 20"),
        false => text.to_owned(),
    };
    format!("{text}[weld.weave]\n{weave}\n")
}

fn plan(text: &str) -> (Welding, Result<PassMotion, Vec<Finding>>) {
    let welding = read(text);
    let motion = planning::plan(&machine_of(&welding), &welding);
    (welding, motion)
}

/// The worst part of a limit that differences of set-points come to.
fn worst(machine: &Machine, motion: &PassMotion, period: f64) -> f64 {
    let mut worst = 0.0f64;
    let sets: Vec<_> = motion.set_points(period).map(|set| set.q).collect();
    for (i, axis) in machine.axes.iter().enumerate() {
        let q = |k: usize| sets[k][i];
        let rounding = 8.0 * f64::EPSILON * q(0).abs().max(1.0);
        for k in 3..sets.len() {
            let speed = (q(k) - q(k - 1)).abs() - rounding;
            let acceleration = (q(k) - 2.0 * q(k - 1) + q(k - 2)).abs() - 4.0 * rounding;
            let jerk = (q(k) - 3.0 * q(k - 1) + 3.0 * q(k - 2) - q(k - 3)).abs() - 8.0 * rounding;
            worst = worst.max(speed / period / axis.max_speed);
            worst = worst.max(acceleration / period.powi(2) / axis.max_acceleration);
            worst = worst.max(jerk / period.powi(3) / axis.jerk());
        }
    }
    worst
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(8)))]

    /// For every weave, slowed down if necessary: every set-point is within every limit, the tip is on the woven path,
    /// and the centre line is never passed faster than requested.
    #[test]
    fn random_weaves_are_within_all_limits(
        arc in any::<bool>(),
        figure in prop::sample::select(vec!["sine", "triangle", "trapezoid", "circle", "eight"]),
        (width, pitch, fade) in (1.0..10.0f64, 1.5..12.0f64, 1.0..10.0f64),
    ) {
        let keys = format!("figure = \"{figure}\"\nwidth_mm = {width}\npitch_mm = {pitch}\nfade_mm = {fade}");
        let text = text(arc, &keys).replace("speed_mm_s = 2.5", "speed_mm_s = 2.5\non_limit = \"slow\"");
        let (welding, motion) = plan(&text);
        let (motion, machine) = (motion.unwrap_or_else(|f| panic!("{f:#?}")), shipped_machine("torch-5axis"));
        for period in [2e-3, 0.02] {
            let worst = worst(&machine, &motion, period);
            prop_assert!(worst <= 1.0 + 1e-6, "{}", worst);
        }
        let path = welding.path(0);
        for set in motion.set_points(0.05) {
            prop_assert!(machine.forward(&set.q).point.distance(path.pose(set.profile.s).point) < 1e-8);
            prop_assert!(set.profile.v <= 2.5 * (1.0 + 1e-9));
        }
        prop_assert!(motion.path.is_woven() && (motion.path.tip_rate(&machine, 30.0) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn the_asked_speed_is_that_along_the_seam() {
    let (_, motion) = plan(WEAVE);
    let motion = motion.unwrap_or_else(|f| panic!("{f:#?}"));
    let (least, greatest) = motion.tip_band(&shipped_machine("torch-5axis"));
    assert!((least - 2.5).abs() < 1e-6 && (greatest - 2.5).abs() < 1e-6, "{least} {greatest}");
    let (worst, uses) = (worst(&shipped_machine("torch-5axis"), &motion, 1e-3), &motion.certificate.uses);
    assert!(worst <= 1.0 + 1e-6 && worst > 0.5, "{worst} {uses:?}");
}

#[test]
fn the_frequency_stays_over_a_ramp_of_the_speed() {
    let (job, _) = plan(WEAVE);
    let mut program = job.program.value;
    let pass = &mut program.passes[0];
    let weave = "[passes.weave]\nwidth_mm = 6\nfrequency_hz = 1.25\nfade_mm = 4\n";
    pass.weave = None;
    let text = program.to_toml().unwrap();
    let spans = "[[passes.spans]]\nfrom_mm = 0\nto_mm = 120\nspeed_mm_s = { from = 2, to = 5 }\n";
    let text = format!("{}{weave}{spans}", text.split("[[passes.spans]]").next().unwrap());
    let welding = read(&text);
    let machine = shipped_machine("torch-5axis");
    let motion = planning::plan(&machine, &welding).unwrap_or_else(|f| panic!("{f:#?}"));
    let legs = motion.profile.legs();
    let steady = |s: f64| s > legs[0].run_up_end + 1.0 && s < legs[0].run_down_start - 1.0;
    let (mut crossings, mut last): (Vec<f64>, Option<(f64, f64)>) = (Vec::new(), None);
    for set in motion.set_points(1e-3).filter(|set| steady(set.profile.s)) {
        let y = machine.forward(&set.q).point.y;
        if let Some((t, before)) = last.filter(|(_, before)| before * y < 0.0) {
            crossings.push(t + 1e-3 * before / (before - y));
        }
        last = Some((set.t, y));
    }
    assert!(crossings.len() > 60, "{}", crossings.len());
    for w in crossings.windows(2) {
        // In a ramp the tip stays slightly below the requested speed.
        assert!((w[1] - w[0] - 0.4).abs() < 0.004 * 0.4, "{w:?}");
    }
}

#[test]
fn the_highest_frequency_told_can_be_planned_and_not_much_more() {
    // A short seam: it is planned a dozen times for every figure.
    let text = |arc, keys: &str| text(arc, keys).replace("[[-60, 0, 0], [60, 0, 0]]", "[[-15, 0, 0], [15, 0, 0]]");
    for (figure, width) in [("sine", 8.0), ("triangle", 5.0), ("circle", 6.0), ("trapezoid", 8.0)] {
        let keys = |hz: f64| format!("figure = \"{figure}\"\nwidth_mm = {width}\nfrequency_hz = {hz}\n");
        let findings = plan(&text(false, &keys(3.0))).1.unwrap_err();
        let [finding] = &findings[..] else { panic!("{findings:#?}") };
        assert!(finding.kind == "speed" && finding.message.code == "motion-weave-frequency", "{finding:?}");
        let told = number(finding.cure.as_ref().unwrap(), "frequency");
        assert!(plan(&text(false, &keys(0.97 * told))).1.is_ok(), "{figure}");
        assert!(plan(&text(false, &keys(1.05 * told))).1.is_err(), "{figure}");
        // A sine of 8 mm against 5000 mm/s^3: its jerk is 4 (2 pi f)^3, all of which is used except for the reserve.
        if figure == "sine" {
            let exact = (5000.0_f64 / 4.0).cbrt() / std::f64::consts::TAU;
            assert!((told / exact - 1.0).abs() < 0.015, "{told} {exact}");
        }
    }
    // For a pitch the minimum is reported; a weld that is too fast without any weave is reported as such.
    let findings = plan(&text(false, "width_mm = 8\npitch_mm = 0.8\n")).1.unwrap_err();
    let told = number(findings[0].cure.as_ref().unwrap(), "pitch");
    assert!(plan(&text(false, &format!("width_mm = 8\npitch_mm = {}\n", told / 0.97))).1.is_ok());
    let fast = text(false, "width_mm = 8\npitch_mm = 50\n").replace("speed_mm_s = 2.5", "speed_mm_s = 150");
    let findings = plan(&fast).1.unwrap_err();
    assert!(findings.iter().all(|f| !f.message.code.starts_with("motion-weave")), "{findings:#?}");
}

/// A torch path that counts the evaluations of its pose, also those of its slower weaves.
struct Counted<'a> {
    path: Box<dyn TorchPath + 'a>,
    poses: &'a AtomicU64,
}

impl TorchPath for Counted<'_> {
    fn length(&self) -> f64 {
        self.path.length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.poses.fetch_add(1, Ordering::Relaxed);
        self.path.pose(s)
    }

    fn rate(&self, s: f64) -> f64 {
        self.path.rate(s)
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        self.path.groove(s)
    }

    fn knots(&self) -> Vec<f64> {
        self.path.knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path.bends()
    }

    fn weave(&self) -> Option<&dyn WovenPath> {
        self.path.weave().map(|_| self as &dyn WovenPath)
    }
}

impl WovenPath for Counted<'_> {
    fn swing(&self, s: f64) -> glam::DVec3 {
        self.path.weave().unwrap().swing(s)
    }

    fn slower(&self, factor: f64) -> Box<dyn TorchPath + '_> {
        Box::new(Counted { path: self.path.weave().unwrap().slower(factor), poses: self.poses })
    }
}

/// Refusing a weave with its maximum frequency costs about one plan; it once took a dozen.
#[test]
fn the_highest_frequency_costs_about_a_plan() {
    let text = include_str!("../../../../tests/data/field-trial/saddle-weave-8hz.toml").replace("procedure = ", "# ");
    let machine = shipped_machine("saddle-4axis");
    let planned = |frequency: f64| {
        let text = text.replace("frequency_hz = 8", &format!("frequency_hz = {frequency}"));
        let welding = read(&text);
        let poses = AtomicU64::new(0);
        let path = welding.path(0);
        let path = path.along_seam().unwrap();
        // With a factor of 1 the path is its own.
        let counted = Counted { path: path.weave().unwrap().slower(1.0), poses: &poses };
        let motion = PassMotion::plan(&machine, &counted, &welding.program.value.passes[0], 1);
        let poses = poses.load(Ordering::Relaxed);
        let mut findings = motion.err().unwrap_or_default();
        // Ignores that the machine has too few axes for the direction.
        findings.retain(|f| f.kind != "attitude");
        (findings, poses)
    };
    let (findings, refused) = planned(8.0);
    let [finding] = &findings[..] else { panic!("{findings:#?}") };
    assert_eq!(finding.message.code, "motion-weave-frequency");
    let told = number(finding.cure.as_ref().unwrap(), "frequency");
    let (left, possible) = planned(told);
    assert!(left.iter().all(|f| f.allowed), "{told} Hz: {left:#?}");
    assert!(refused < 2 * possible, "{refused} poses to refuse it, {possible} to plan it at {told} Hz");
    assert!(planned(1.03 * told).0.iter().any(|f| f.kind == "speed"), "{told} Hz");
}
