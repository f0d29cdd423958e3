//! Programs of several passes: axes unwind between them, every set-point is within every limit, without jumps;
//! obstacles are reported or avoided.

use crate::number;
use crate::planning::{machine_of, plan_weld, read, read_machine, several_passes};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_machine::{Clamped, Joints, Machine};
use seamwright_motion::{Phase, WeldMotion};
use seamwright_program::{Finding, TorchPath};
use seamwright_weld::Welding;

/// Plays the whole motion from home to home and checks every set-point by differences: ranges, speeds, accelerations,
/// reported rates; the last position.
fn check(machine: &Machine, motion: &WeldMotion) {
    let period = 2e-3;
    let mut last: Vec<Joints> = Vec::new();
    let mut phases = Vec::new();
    let mut count = 0u64;
    let played: Result<(), ()> = motion.play(period, true, |pass, set, rates| {
        assert!(machine.outside(&set.q).is_none());
        assert!((set.phase == Phase::Transfer) == (pass == 0));
        assert!((set.t - count as f64 * period).abs() < 1e-9);
        for (i, axis) in machine.axes.iter().enumerate() {
            assert!(rates.0[i].abs() <= axis.max_speed * (1.0 + 1e-6));
            assert!(rates.1[i].abs() <= axis.max_acceleration * (1.0 + 1e-6));
            if let [.., before, here] = last.as_slice() {
                let v = (set.q[i] - here[i]) / period;
                let a = (set.q[i] - 2.0 * here[i] + before[i]) / (period * period);
                assert!(v.abs() <= axis.max_speed * (1.0 + 1e-6), "{} at {}: {v}", axis.name, set.t);
                assert!(a.abs() <= axis.max_acceleration * (1.0 + 1e-4) + 1e-6, "{} at {}: {a}", axis.name, set.t);
            }
        }
        phases.push(pass);
        last.push(set.q);
        count += 1;
        Ok(())
    });
    played.unwrap();
    assert_eq!(count, motion.count(period, true));
    phases.dedup();
    let expected: Vec<usize> = (1..=motion.passes.len()).flat_map(|i| [0, i]).chain([0]).collect();
    assert_eq!(phases, expected);
    let home = machine.home();
    for (i, axis) in machine.axes.iter().enumerate() {
        assert!((axis.turn_near(last[0][i], home[i]) - home[i]).abs() < 1e-9);
        let end = last[last.len() - 1][i];
        assert!((axis.turn_near(end, home[i]) - home[i]).abs() < 1e-9);
    }
}

#[test]
fn a_limited_axis_unwinds_between_passes_and_an_endless_one_goes_on() {
    let saddle = several_passes(include_str!("../../../../examples/saddle.toml"), 3);
    let machine_4 = machine_of(&saddle);
    let motion = plan_weld(&machine_4, &saddle, &Clamped::default()).unwrap();
    let unwound: Vec<&Finding> = motion.findings.iter().filter(|f| f.kind == "unwind").collect();
    // From -340 deg the second pass goes on to 385; the third has no room and starts again from -340.
    assert!(unwound.len() == 1 && unwound[0].allowed && unwound[0].pass == 2);
    assert!((number(&unwound[0].message, "by") - 364.6).abs() < 0.05, "{}", unwound[0].message);
    check(&machine_4, &motion);

    let trunnion = several_passes(include_str!("../../../../examples/trunnion-saddle.toml"), 3);
    let machine_5 = machine_of(&trunnion);
    let motion = plan_weld(&machine_5, &trunnion, &Clamped::default()).unwrap();
    assert!(motion.findings.iter().all(|f| f.kind != "unwind"), "{:?}", motion.findings);
    let c = machine_5.axis("c").unwrap();
    let turned = motion.passes[2].path.at(motion.passes[2].path.length())[c] - motion.passes[0].path.at(0.0)[c];
    assert!(turned.abs() > 6.0 * std::f64::consts::PI, "the table turns on: {turned}");
    check(&machine_5, &motion);
}

/// A girth of 1000 mm diameter in six passes, on rolls of which `range` gives the end stops.
fn girth_on_rolls(range: &str, step_over: &str) -> (Machine, Welding) {
    let welding = read(&format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"column-boom\"\n[seam.girth]\nradius_mm = 500\ndirection = [1, 0, 0]\n\
         zero_direction = [0, 0, 1]\n[joint]\n[joint.preparation.single_v]\nthickness_mm = 14\nangle_deg = 50\n\
         root_gap_mm = 2\nroot_face_mm = 1\n[start]\noverlap_mm = 15\n[beads]\nwire_mm = 3.2\nstation_mm = 50\nwall_tilt_deg = 4\n{step_over}\n\
         order = \"from_second\"\nroot = {{ layer_mm = 4 }}\nfill = {{ layer_mm = 3 }}\n[weld]\nspeed_mm_s = 8\n[weld.process]\n\
         wire_feed_m_min = 1.2\n"
    ));
    let text = seamwright_machine::shipped("column-boom").unwrap().text;
    (read_machine(&text.replace("continuous = true", range)), welding)
}

/// Angles (degrees) by which the rolls turn from the end of each pass to the start of the next.
fn turns_between(machine: &Machine, motion: &WeldMotion) -> Vec<f64> {
    let w = machine.axis("w").unwrap();
    let ends = motion.passes.windows(2).map(|two| two[1].path.at(0.0)[w] - two[0].path.at(two[0].path.length())[w]);
    ends.map(f64::to_degrees).collect()
}

#[test]
fn rolls_turn_on_from_pass_to_pass_and_unwind_only_when_they_must() {
    for (range, unwound) in [
        ("continuous = true", 0),
        ("range_deg = [-3600, 3600]", 0),
        // All passes just fit, from one end to the other.
        ("range_deg = [-1300, 1300]", 0),
        // Two passes between unwindings.
        ("range_deg = [-550, 550]", 2),
    ] {
        let (machine, welding) = girth_on_rolls(range, "");
        let count = welding.program.value.passes.len();
        assert_eq!(count, 6, "the ranges are made for six passes");
        let motion = plan_weld(&machine, &welding, &Clamped::default()).unwrap_or_else(|f| panic!("{range}: {f:?}"));
        let between = turns_between(&machine, &motion);
        assert_eq!(between.iter().filter(|by| by.abs() > 180.0).count(), unwound, "{range}: {between:?}");
        assert_eq!(motion.findings.iter().filter(|f| f.kind == "unwind").count(), unwound, "{range}");
        check(&machine, &motion);
    }
}

#[test]
fn a_spiral_is_welded_in_one_motion_without_a_stop() {
    let (machine, welding) = girth_on_rolls("continuous = true", "step_over_mm = 60");
    let passes = &welding.program.value.passes;
    let motion = plan_weld(&machine, &welding, &Clamped::default()).unwrap_or_else(|f| panic!("{f:?}"));
    assert!(motion.passes.len() < 6 && passes.iter().any(|pass| !pass.step_overs.is_empty()));
    check(&machine, &motion);
    let w = machine.axis("w").unwrap();
    for (planned, pass) in motion.passes.iter().zip(passes) {
        let turned = planned.path.at(planned.path.length())[w] - planned.path.at(0.0)[w];
        let turns = pass.length() / welding.seam.as_ref().unwrap().length();
        assert!((turned.abs() / std::f64::consts::TAU - turns).abs() < 1e-3, "{turned} {turns}");
        // From the acceleration to the deceleration phase the torch keeps its speed.
        let (least, greatest) = planned.tip_band(&machine);
        let (low, high) = pass.speeds();
        assert!(least > 0.98 * low && greatest < 1.02 * high, "{least} {greatest} {low} {high}");
    }
}

#[test]
fn seven_and_ten_axes_play_several_passes() {
    for text in [
        include_str!("../../../../examples/oblique-girth.toml"),
        include_str!("../../../../examples/t-joint.toml"),
        include_str!("../../../../examples/head-nozzle.toml"),
        include_str!("../../../../examples/ellipse.toml"),
    ] {
        let welding = several_passes(text, 2);
        let machine = machine_of(&welding);
        let motion = plan_weld(&machine, &welding, &Clamped::default()).unwrap_or_else(|f| panic!("{f:?}"));
        check(&machine, &motion);
        assert!(motion.total_s() > 2.0 * motion.passes[0].total_s());
    }
}

/// Torch and work both have a nozzle: the names distinguish them.
#[test]
fn the_nearest_things_are_named_as_in_findings() {
    let welding = several_passes(include_str!("../../../../examples/head-nozzle.toml"), 1);
    let clamped = welding.clamped(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap();
    let motion = plan_weld(&machine_of(&welding), &welding, &clamped).unwrap_or_else(|f| panic!("{f:#?}"));
    let (_, _, between) = motion.clearance[0].as_ref().unwrap().nearest.as_ref().unwrap();
    assert!(between.iter().any(|solid| solid.code == "machine-solid-of-part"), "{between:?}");
}

#[test]
fn what_is_too_near_is_told() {
    let welding = several_passes(include_str!("../../../../examples/head-nozzle.toml"), 1);
    let machine = machine_of(&welding);
    let free = plan_weld(&machine, &welding, &Clamped::default()).unwrap();
    let length = welding.path(0).length();
    let pose = welding.path(0).pose(0.4 * length);
    // 60 mm up along the torch, 20 mm aside: the torch body of 14 mm radius passes 1 mm from a ball of 5 mm.
    let aside = welding.path(0).line(0.4 * length).1;
    let out = -pose.direction;
    let across = out.cross(aside).normalize();
    let ball = |d: f64| {
        let at = pose.point + 100.0 * out + d * across;
        vec![Solid::new("clamp", Shape::Sphere { radius: 5.0 }, DAffine3::from_translation(at)).unwrap()]
    };
    let with =
        |d: f64| plan_weld(&machine, &welding, &Clamped { fixtures: ball(d), least_mm: 2.0, ..Clamped::default() });
    let findings = with(20.0).unwrap_err();
    let f = findings.iter().find(|f| f.kind == "clearance").unwrap();
    assert!(f.message.to_string().contains("clamp") && f.message.to_string().contains("torch"));
    assert!(f.from_mm < 0.4 * length && f.to_mm > 0.4 * length && f.to_mm - f.from_mm < 0.2 * length);
    // Far enough away it is no finding, and the minimum distance is reported.
    let clear = with(60.0).unwrap();
    let nearest = clear.clearance[0].as_ref().unwrap();
    assert!(nearest.nearest.is_some() && free.clearance[0].is_some());
    assert!(nearest.at_least.iter().all(|c| c.1 >= 2.0));
    // A required clearance above the maximum reported distance is valid.
    let wide = Clamped { fixtures: ball(500.0), least_mm: 100.0, ..Clamped::default() };
    assert!(plan_weld(&machine, &welding, &wide).is_ok());
    // A ball round home blocks the transfer moves.
    let home = machine.forward(&machine.home()).point + DVec3::new(0.0, 0.0, 100.0);
    let at_home = Solid::new("hook", Shape::Sphere { radius: 5.0 }, DAffine3::from_translation(home)).unwrap();
    let blocked =
        plan_weld(&machine, &welding, &Clamped { fixtures: vec![at_home], least_mm: 2.0, ..Clamped::default() });
    let findings = blocked.unwrap_err();
    assert!(findings.iter().any(|f| f.kind == "air" && f.message.to_string().contains("hook")), "{findings:?}");
}
