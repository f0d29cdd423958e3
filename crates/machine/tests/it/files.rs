//! Mistakes in machine files are refused with their address.

use crate::common::{refusal, shipped_machine};
use glam::{DVec2, DVec3};
use seamwright_machine::{Joints, Machine, Sight, shipped};

fn saddle() -> &'static str {
    shipped("saddle-4axis").unwrap().text
}

/// Changes the shipped file and returns key and message of the error.
fn wrong(from: &str, to: &str) -> (String, String) {
    let e = refusal(saddle(), from, to);
    (e.key.clone(), e.to_string())
}

#[test]
fn mistakes_have_an_address() {
    let key = |from, to| wrong(from, to).0;
    assert_eq!(key("range_deg = [-400, 400]", "range_deg = [400, -400]"), "tool[0].range_deg");
    assert_eq!(key("range_deg = [-400, 400]", "range_mm = [-400, 400]"), "tool[0].range_mm");
    assert_eq!(key("max_speed_deg_s = 30", "max_speed_mm_s = 30"), "tool[0].max_speed_mm_s");
    assert_eq!(key("max_speed_deg_s = 30", ""), "tool[0]");
    assert_eq!(key("max_speed_deg_s = 30", "max_speed_deg_s = 0"), "tool[0].max_speed_deg_s");
    assert_eq!(key("axis = \"s\"", "axis = \"theta\""), "tool[2].axis");
    assert_eq!(key("axis = \"s\"", "axis = \"S 1\""), "tool[2].axis");
    assert_eq!(key("letter = \"X\"", "letter = \"C\""), "tool[2].letter");
    assert_eq!(key("letter = \"X\"", "letter = \"Q\""), "tool[2].letter");
    assert_eq!(key("turn = [0, 0, 1]", "turn = [0, 0, 0]"), "tool[0].turn");
    assert_eq!(key("turn = [0, 0, 1]", "turn = [0, 0, 1]\nmove = [1, 0, 0]"), "tool[0]");
    assert_eq!(key("turn = [0, 0, 1]", "turn = [0, 0, 1]\ncontinuous = true"), "tool[0]");
    assert_eq!(key("turn = [0, 0, 1]", "turn = [0, 0, 1]\nhome_deg = 500"), "tool[0]");
    assert_eq!(
        key("fixed = { move_mm = [400, 0, 100] }", "fixed = { move_mm = [400, nan, 100] }"),
        "tool[1].fixed.move_mm[1]"
    );
    assert_eq!(key("fixed = { move_mm = [400, 0, 100] }", ""), "tool[1]");
    assert_eq!(key("[drives.theta]", "[drives.tetha]"), "drives.tetha");
    assert_eq!(key("inertia_kg_m2 = 30", "mass_kg = 30"), "drives.theta");
    assert_eq!(key("input = \"curtain_clear\"", "input = \" \""), "interlocks[1].input");
    assert_eq!(key("name = \"light curtain\"", "name = \"emergency stop chain\""), "interlocks[1].name");
    assert_eq!(key("for = \"motion\"", "for = \"moving\""), "interlocks[1].for");
    let (at, text) = wrong("input = \"curtain_clear\"", "is = false\ninput = \"e_stop_ok\"");
    assert!(at == "interlocks[1].is" && text.contains("nothing could ever run"), "{text}");
    assert_eq!(key("input = \"curtain_clear\"", "input = \"e_stop_ok\""), "interlocks[1].input");
    assert!(wrong("max_speed_deg_s = 30", "max_sped_deg_s = 30").1.contains("did you mean `max_speed_deg_s`?"));
}

#[test]
fn mistakes_in_a_drive_have_an_address() {
    // The first velocity loop is theta's, a rotary axis.
    let theta = |more: &str| {
        let (key, _) = wrong("velocity_bandwidth_hz = 25", &format!("velocity_bandwidth_hz = 25\n{more}"));
        key.strip_prefix("drives.theta").unwrap_or(&key).to_owned()
    };
    assert_eq!(theta("resonance_hz = 0\nload_ratio = 2"), ".resonance_hz");
    assert_eq!(theta("resonance_hz = nan\nload_ratio = 2"), ".resonance_hz");
    assert_eq!(theta("resonance_hz = 20"), ".resonance_hz");
    assert_eq!(theta("load_ratio = 2"), ".load_ratio");
    assert_eq!(theta("backlash_deg = 0.01"), ".backlash_deg");
    assert_eq!(theta("encoder_on = \"load\""), ".encoder_on");
    let elastic = |more: &str| theta(&format!("resonance_hz = 20\nload_ratio = 2\n{more}"));
    assert_eq!(elastic("resonance_damping = 1.2"), ".resonance_damping");
    assert_eq!(elastic("motor_friction = 1.01"), ".motor_friction");
    assert_eq!(elastic("backlash_deg = -0.1"), ".backlash_deg");
    assert_eq!(elastic("encoder_on = \"gear\""), ".encoder_on");
    // Lengths on a rotary axis.
    for key in ["backlash_mm = 0.1", "force_limit_n = 10", "friction_compensation_n = 3", "encoder_counts_per_mm = 1"] {
        assert_eq!(elastic(key), "");
    }
    assert_eq!(theta("torque_limit_n_m = 151"), ".torque_limit_n_m");
    assert_eq!(theta("torque_limit_n_m = 8"), ".torque_limit_n_m");
    assert_eq!(theta("current_delay_ms = -1"), ".current_delay_ms");
    assert_eq!(theta("friction_smoothing_deg_s = 1"), ".friction_smoothing_deg_s");
    assert_eq!(theta("friction_compensation_n_m = 5\nfriction_smoothing_deg_s = 0"), ".friction_smoothing_deg_s");
    assert_eq!(theta("backlash_compensation_ms = 5"), ".backlash_compensation_ms");
    assert_eq!(theta("backlash_compensation_deg = nan"), ".backlash_compensation_deg");
    let notch = |n: &str| theta(&format!("notches = [{n}]"));
    assert_eq!(notch("{ frequency_hz = 600, depth = 0.1, width_hz = 20 }"), ".notches[0].frequency_hz");
    assert_eq!(notch("{ frequency_hz = 60, depth = 1.1, width_hz = 20 }"), ".notches[0].depth");
    assert_eq!(notch("{ frequency_hz = 60, depth = 0.1, width_hz = 0 }"), ".notches[0].width_hz");
    let good = "{ frequency_hz = 60, depth = 0.1, width_hz = 20 }";
    assert_eq!(notch(&[good; 3].join(", ")), ".notches");
}

#[test]
fn the_longest_gap_is_in_s_and_bounded() {
    let key = "servo_period_ms = 1";
    let gap = |ms: &str| saddle().replacen(key, &format!("{key}\nlongest_gap_ms = {ms}"), 1);
    assert_eq!(Machine::read("m.toml", saddle()).unwrap().longest_gap_s, None);
    let gap_s = Machine::read("m.toml", &gap("40")).unwrap().longest_gap_s.unwrap();
    assert!((gap_s - 0.04).abs() < 1e-15);
    for ms in ["0.9", "1001"] {
        let error = Machine::read("m.toml", &gap(ms)).unwrap_err();
        assert!(error.key == "longest_gap_ms" && error.to_string().contains("1 ms to 1000 ms"), "{error}");
    }
}

#[test]
fn a_drive_is_read_in_mm_and_rad() {
    let more =
        "velocity_bandwidth_hz = 25\nresonance_hz = 20\nload_ratio = 2\nbacklash_deg = 0.01\nencoder_on = \"load\"
torque_limit_n_m = 100\ncurrent_delay_ms = 0.25\nfriction_compensation_n_m = 7\nbacklash_compensation_deg = 0.02
notches = [{ frequency_hz = 60, depth = 0.1, width_hz = 20 }]";
    let machine = Machine::read("m.toml", &saddle().replacen("velocity_bandwidth_hz = 25", more, 1)).unwrap();
    let drive = machine.axes[0].drive.clone().unwrap();
    let transmission = drive.transmission.unwrap();
    assert!((transmission.backlash - 0.01f64.to_radians()).abs() < 1e-15);
    assert!(
        (transmission.damping - 0.02).abs() < 1e-15 && transmission.encoder_on == seamwright_servo::EncoderSide::Load
    );
    assert!(drive.force_limit == Some(100.0) && (drive.current_delay_s - 2.5e-4).abs() < 1e-15);
    let friction = drive.friction_compensation.unwrap();
    assert!((friction.force - 7.0).abs() < 1e-15 && (friction.smoothing - 0.06f64.to_radians()).abs() < 1e-15);
    let backlash = drive.backlash_compensation.unwrap();
    assert!((backlash.width - 0.02f64.to_radians()).abs() < 1e-15 && (backlash.time_s - 0.02).abs() < 1e-15);
    assert_eq!(drive.notches.len(), 1);
    assert!((drive.encoder_counts_per_unit - 20_000f64 * 1f64.to_degrees()).abs() < 1e-6);
}

/// Mistakes with two heads.
#[test]
fn heads_have_names_and_tails_of_their_own() {
    let dual = shipped("dual-laser-10axis").unwrap().text;
    let wrong = |from: &str, to: &str| refusal(dual, from, to).key;
    assert_eq!(wrong("name = \"right\"", "name = \"left\""), "heads[1].name");
    assert_eq!(wrong("name = \"right\"", "name = \"base\""), "heads[1].name");
    assert_eq!(wrong("axis = \"u2\"", "axis = \"u1\""), "heads[1].steps[0].axis");
    let no_tail = "[[heads]]\nname = \"third\"\ndirection = [0, 0, -1]\n[drives.x]";
    assert_eq!(wrong("[drives.x]", no_tail), "heads[2]");
    assert_eq!(wrong("[drives.x]", "[torch]\ndirection = [0, 0, -1]\n[drives.x]"), "torch");
    let single = saddle();
    let none = single.replacen("[torch]\ndirection = [0, 0, -1]\nstick_out_mm = 15", "", 1);
    assert!(Machine::read("m.toml", &none).unwrap_err().to_string().contains("no torch"));
    let one = single.replacen("stick_out_mm = 15\n", "", 1);
    let one = one.replacen("[torch]\ndirection", "[[heads]]\nname = \"torch\"\ndirection", 1);
    assert_eq!(Machine::read("m.toml", &one).unwrap_err().key, "heads[0]");
    let empty = "schema = 1\nname = \"m\"\ntitle = \"m\"\n[torch]\ndirection = [0, 0, -1]\n";
    assert!(Machine::read("m.toml", empty).unwrap_err().to_string().contains("0 axes"));
}

#[test]
fn steppers_say_what_does_not_fit() {
    let torch = shipped("torch-5axis").unwrap().text;
    let wrong = |from: &str, to: &str| refusal(torch, from, to).key;
    assert_eq!(wrong("full_steps_per_turn = 200", "full_steps_per_turn = 201"), "drives.y.stepper.full_steps_per_turn");
    assert_eq!(wrong("full_steps_per_turn = 200", "full_steps_per_turn = 0"), "drives.y.stepper.full_steps_per_turn");
    assert_eq!(wrong("full_steps_per_turn = 200", "full_steps_per_turn = -4"), "drives.y.stepper.full_steps_per_turn");
    assert_eq!(wrong("mm_per_turn = 10", "deg_per_turn = 10"), "drives.y.stepper.deg_per_turn");
    assert_eq!(wrong("mm_per_turn = 10", ""), "drives.y.stepper");
    assert_eq!(wrong("deg_per_turn = 5", "deg_per_turn = 0"), "drives.a.stepper.deg_per_turn");
    assert_eq!(wrong("resolution_deg = 0.002", "resolution_mm = 0.002"), "drives.a.stepper.resolution_mm");
    for microsteps in ["[]", "[0, 1]", "[2, 1]", "[1, 1]", "[5000]"] {
        let to = format!("microsteps = {microsteps}");
        assert_eq!(wrong("microsteps = [1, 2, 4, 8, 16, 32, 64, 128]", &to), "drives.y.stepper.microsteps");
    }
    assert_eq!(wrong("max_pulse_hz = 200000", "max_pulse_hz = 200001"), "drives.y.stepper.max_pulse_hz");
    assert_eq!(wrong("min_pulse_us = 2.5", "min_pulse_us = 0"), "drives.y.stepper.min_pulse_us");
    assert_eq!(wrong("direction_setup_us = 5", "direction_setup_us = -5"), "drives.y.stepper.direction_setup_us");
    assert_eq!(wrong("rotor_inertia_kg_m2 = 2.7e-4", ""), "drives.y.stepper");
    let rpm = "torque_rpm = [0, 150, 300, 600, 900, 1200]";
    assert_eq!(wrong(rpm, "torque_rpm = [0, 150]"), "drives.y.stepper.torque_n_m");
    assert_eq!(wrong(rpm, "torque_rpm = [1, 150, 300, 600, 900, 1200]"), "drives.y.stepper.torque_rpm");
    assert_eq!(wrong(rpm, "torque_rpm = [0, 300, 150, 600, 900, 1200]"), "drives.y.stepper.torque_rpm");
    assert_eq!(wrong("torque_n_m = [8.5,", "torque_n_m = [0,"), "drives.y.stepper.torque_n_m");
    assert_eq!(wrong("[drives.x.stepper]", "[drives.x.steppper]"), "drives.x.steppper");
}

#[test]
fn steppers_are_in_mm_and_rad() {
    let machine = shipped_machine("torch-5axis");
    let of = |name: &str| machine.axes[machine.axis(name).unwrap()].stepper.clone().unwrap();
    assert!((of("x").full_steps_per_unit() - 20.0).abs() < 1e-12);
    // 200 steps for 5 degrees.
    assert!((of("a").full_steps_per_unit() - 40.0 * 1f64.to_degrees()).abs() < 1e-9);
    assert!((of("a").resolution - 0.002f64.to_radians()).abs() < 1e-15);
    let motor = of("b").motor.unwrap();
    assert!((motor.torque[3].0 - 20.0 * std::f64::consts::PI).abs() < 1e-12 && (motor.torque[3].1 - 1.4).abs() < 1e-12);
    assert!(Machine::read("m", saddle()).unwrap().axes.iter().all(|a| a.stepper.is_none()));
}

fn sensor(text: &str) -> (String, String) {
    let dual = shipped("dual-laser-10axis").unwrap().text;
    let (_, rest) = dual.split_once("[sensors.left]").unwrap();
    let (left, _) = rest.split_once("[sensors.right]").unwrap();
    let e = refusal(dual, left, &format!("\n{text}\n"));
    (e.key.clone(), e.to_string())
}

#[test]
fn sensors_say_what_does_not_fit() {
    let on = |map: &str| sensor(&format!("kind = \"stripe\"\non = \"left\"\nsize_px = [1280, 1024]\n{map}")).0;
    assert!(sensor("kind = \"strip\"\non = \"left\"\nsize_px = [1280, 1024]").1.contains("did you mean `stripe`?"));
    let (key, text) =
        sensor("kind = \"stripe\"\non = \"lefd\"\nsize_px = [1280, 1024]\nmap.scale = { mm_per_px = [1, 1] }");
    assert!(key == "sensors.left.on" && text.contains("did you mean `left`?"));
    assert_eq!(sensor("kind = \"stripe\"\non = \"left\"\nsize_px = [0, 4]").0, "sensors.left.size_px");
    assert_eq!(sensor("kind = \"stripe\"\non = \"left\"\nsize_px = [4, 20000]").0, "sensors.left.size_px");
    assert_eq!(on(""), "sensors.left");
    assert_eq!(on("map.scale = { mm_per_px = [0.05, 0] }"), "sensors.left.map.scale");
    assert_eq!(on("map.scale = { mm_per_px = [0.05, nan] }"), "sensors.left.map.scale.mm_per_px[1]");
    assert_eq!(on("map.homography = [1, 0, 0, 0, 0, 0, 0, 0]"), "sensors.left.map.homography");
    assert_eq!(on("map.homography = [1, 0, 0, 0, 1, 0, 0, -0.001]"), "sensors.left.map.homography");
    let camera = |angle: f64, focal: f64| {
        on(&format!("map.camera = {{ distance_mm = 100, angle_deg = {angle}, focal_px = {focal} }}"))
    };
    assert_eq!(camera(90.0, 3000.0), "sensors.left.map.camera.angle_deg");
    assert_eq!(camera(-5.0, 3000.0), "sensors.left.map.camera.angle_deg");
    // With such a short lens the upper edge of the image looks past the plane.
    assert_eq!(camera(30.0, 200.0), "sensors.left.map.camera");
}

/// The shipped sensors match the comments of their files: at the beam's focus plus the look-ahead, bisecting, with the
/// stated scales. Checked against a camera set up from its pose.
#[test]
fn sensors_see_ahead_of_the_beam() {
    let machine = shipped_machine("dual-laser-10axis");
    let q = Joints::default();
    for (head, name, side) in [(0, "left", 1.0), (1, "right", -1.0)] {
        let sensor = machine.sensor(name).unwrap();
        let frame = machine.sensor_frame(sensor, &q);
        let lead = frame.translation - machine.forward_of(head, &q).point;
        assert!((lead - DVec3::new(20.0, 0.0, 0.0)).length() < 1e-12);
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert!((frame.transform_vector3(DVec3::Z) - DVec3::new(0.0, side * half, half)).length() < 1e-12);
        let Sight::Stripe(stripe) = &sensor.sight else { panic!("{name} is no stripe sensor") };
        // A pinhole camera 110 mm from the origin, 25 degrees from z towards x, x to the right, y down.
        let (sin, cos) = 25f64.to_radians().sin_cos();
        let (eye, ahead) = (110.0 * DVec3::new(sin, 0.0, cos), -DVec3::new(sin, 0.0, cos));
        let (right, down) = (DVec3::Y, ahead.cross(DVec3::Y));
        for p in [DVec3::ZERO, DVec3::new(0.0, 10.0, 5.0), DVec3::new(0.0, -15.0, -20.0)] {
            let seen = p - eye;
            let at = DVec2::new(seen.dot(right), seen.dot(down)) * 3667.0 / seen.dot(ahead);
            let px = DVec2::new(639.5, 511.5) + at;
            let mm = stripe.to_mm.map(px).unwrap();
            assert!((mm - DVec2::new(p.y, p.z)).length() < 1e-9, "{p}: {mm}");
        }
        let at = |x, y| stripe.to_mm.map(DVec2::new(x, y)).unwrap();
        assert!((at(640.5, 511.5) - at(639.5, 511.5) - DVec2::new(0.03, 0.0)).length() < 1e-4);
        assert!((at(639.5, 511.0) - at(639.5, 512.0) - DVec2::new(0.0, 0.071)).length() < 1e-4);
    }
}

/// The beam image of the EBW machine has 0.1 mm per pixel at its focus and a wider field on deeper work. Its x is along
/// x of the gun, its rows against y. The camera of the saddle welder looks 60 mm ahead with its rows across the seam.
#[test]
fn cameras_see_the_work() {
    let machine = shipped_machine("ebw-7axis");
    let sensor = machine.sensor("beam").unwrap();
    let Sight::Camera(camera) = &sensor.sight else { panic!("the beam is no camera") };
    assert!((sensor.period_s - 0.3).abs() < 1e-12 && camera.table.size_px() == (512, 512));
    let q = machine.home();
    let frame = machine.camera_frame(sensor, &q);
    let tip = machine.forward(&q);
    assert!((frame.translation - tip.point).length() < 1e-9);
    assert!((frame.transform_vector3(DVec3::Z) - tip.direction).length() < 1e-12);
    let seen =
        |x, y, height| frame.transform_point3(camera.table.to_point(DVec2::new(x, y), height).unwrap()) - tip.point;
    assert!((seen(265.5, 245.5, 0.0) - DVec3::new(1.0, 1.0, 0.0)).length() < 1e-9);
    // 20 mm deeper the beam, deflected about a point 260 mm above, sees 280/260 as much.
    assert!((seen(265.5, 255.5, 20.0) - DVec3::new(280.0 / 260.0, 0.0, -20.0)).length() < 1e-9);
    assert!(camera.table.at(40.0).is_err());

    let machine = shipped_machine("saddle-4axis");
    let sensor = machine.sensor("camera").unwrap();
    let frame = machine.camera_frame(sensor, &Joints::default());
    assert!(
        (frame.translation - machine.forward(&Joints::default()).point - DVec3::new(0.0, 60.0, 0.0)).length() < 1e-9
    );
    assert!((frame.transform_vector3(DVec3::X) - DVec3::Y).length() < 1e-12);
}

#[test]
fn cameras_that_are_none_are_refused() {
    let text = shipped("ebw-7axis").unwrap().text;
    let (before, rest) = text.split_once("[[sensors.beam.map.heights]]").unwrap();
    let after = &rest[rest.find("[drives.x]").unwrap()..];
    let key = |lines: &str| Machine::read("m", &format!("{before}{lines}\n{after}")).unwrap_err().key;
    assert_eq!(key(""), "sensors.beam");
    assert_eq!(key("map.scale = { mm_per_px = [1, 1] }"), "sensors.beam.map");
    assert_eq!(key("map.heights = []"), "sensors.beam.map.heights");
    assert_eq!(key("map.heights = [{ mm_per_px = [0.1, 0] }]"), "sensors.beam.map.heights[0].mm_per_px[1]");
    assert_eq!(key("map.heights = [{ mm_per_px = [0.1, 0.1], barrel = -0.2 }]"), "sensors.beam.map.heights[0]");
    let falling = "map.heights = [{ z_mm = 1, mm_per_px = [0.1, 0.1] }, { z_mm = 0, mm_per_px = [0.1, 0.1] }]";
    assert_eq!(key(falling), "sensors.beam.map.heights[1].z_mm");
    for wrong in ["http://a:1", "tcp://camera", "tcp://:7000", "tcp://camera:99999", "tcp://camera:0", ""] {
        let frames = format!("frames = \"{wrong}\"\nmap.heights = [{{ mm_per_px = [0.1, 0.1] }}]");
        assert_eq!(key(&frames), "sensors.beam.frames", "{wrong}");
    }
    assert!(Machine::read("m", &format!("{before}map.heights = [{{ mm_per_px = [0.1, 0.1] }}]\n{after}")).is_ok());
}
