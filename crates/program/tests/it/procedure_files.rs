//! Procedure files: their content, and the message of each mistake.

use seamwright_document::DocumentError;
use seamwright_program::{PROCEDURES, Pass, Procedure, Program, Role, Run};

const TEXT: &str = "schema = 1\nnumber = \"WPS 7\"\ntitle = \"t\"\nprocess = 135\nwire_diameter_mm = 1.2\n\
    [[runs]]\nname = \"root\"\npositions = [\"PA\", \"PB\"]\nspeed_mm_s = [4, 6]\nheat_input_kj_mm = [0.4, 0.8]\n\
    interpass_c = [20, 250]\nranges = { current_a = [150, 180], voltage_v = [18, 20.5] }\n\
    [[runs]]\npasses = \"2-4, 7\"\ntravel_angle_deg = [-20, 0]\n";

const PROGRAM: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [1, 0, 0]\n\
    first_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[procedure]\nschema = 1\nnumber = \"W\"\ntitle = \"t\"\n\
    process = 141\n[[procedure.runs]]\nname = \"root\"\n[[procedure.runs]]\npasses = \"2\"\n\
    [[passes]]\nname = \"root\"\n[[passes.spans]]\nfrom_mm = 0\nto_mm = 1\nspeed_mm_s = 5\n\
    [[passes]]\nname = \"cap 1.1\"\n[[passes.spans]]\nfrom_mm = 0\nto_mm = 1\nspeed_mm_s = 5\n";

fn wrong(from: &str, to: &str) -> DocumentError {
    assert!(TEXT.contains(from), "{from}");
    let e = Procedure::read("w.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
    println!("{e}");
    e
}

fn pass(name: &str, role: Option<Role>) -> Pass {
    let text = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n[seam.nozzle.body.cylinder]\n\
         radius_mm = 800\n[[passes]]\nname = \"{name}\"\n[[passes.spans]]\nfrom_mm = 0\nto_mm = 40\nspeed_mm_s = 3\n"
    );
    Pass { role, ..Program::read("p.toml", &text).unwrap().value.passes.remove(0) }
}

#[test]
fn runs_are_found_by_name_and_by_number() {
    let p = Procedure::read("w.toml", TEXT).unwrap().value;
    let label =
        |run: &Run| run.name.map(|role| role.name().to_owned()).or(run.passes.as_ref().map(ToString::to_string));
    let run = |number, name| p.run_of(number, &pass(name, None)).and_then(label);
    assert_eq!(run(1, "root").as_deref(), Some("root"));
    assert_eq!(run(1, "root 1.2").as_deref(), Some("root"));
    assert_eq!(run(1, "rooted"), None);
    assert_eq!(run(3, "fill 2.1").as_deref(), Some("2-4, 7"));
    assert_eq!((run(5, "fill 2.4"), run(1, "pass 1")), (None, None));
    // The role of a pass takes precedence over its name.
    let of = |name, role| p.run_of(9, &pass(name, Some(role))).and_then(label);
    assert_eq!(of("north, part 1", Role::Root).as_deref(), Some("root"));
    assert_eq!(of("root, part 1", Role::Fill), None);
    let again = p.to_toml().unwrap();
    assert_eq!(Procedure::read("w.toml", &again).unwrap().value, p);
    assert_eq!(p.runs[0].name, Some(Role::Root));
    assert_eq!(p.runs[0].ranges["voltage_v"].ends(), (18.0, 20.5));
    for shipped in PROCEDURES {
        Procedure::read(shipped.name, shipped.text).unwrap_or_else(|e| panic!("{e}"));
    }
}

#[test]
fn windows_that_are_none() {
    let e = wrong("speed_mm_s = [4, 6]", "speed_mm_s = [6, 4]");
    assert_eq!((e.line, e.key.as_str()), (9, "runs[0].speed_mm_s"));
    assert!(
        e.message.to_string().contains("6, is above the maximum, 4")
            && e.allowed.as_ref().map(ToString::to_string).as_deref() == Some("[minimum, maximum]")
    );
    assert_eq!(wrong("current_a = [150, 180]", "current_a = [180, 150]").key, "runs[0].ranges.current_a");
    assert!(wrong("[0.4, 0.8]", "[0.4]").key.contains("heat_input_kj_mm"));
    assert!(wrong("[0.4, 0.8]", "0.4").key.contains("heat_input_kj_mm"));
    assert!(wrong("[0.4, 0.8]", "[0.4, nan]").key.contains("heat_input_kj_mm"));
    assert!(wrong("[0.4, 0.8]", "\"0.4 to 0.8\"").key.contains("heat_input_kj_mm"));
}

#[test]
fn names_that_are_not_known() {
    let e = wrong("process = 135", "process = 137");
    assert_eq!((e.line, e.key.as_str()), (4, "process"));
    assert!(e.allowed.unwrap().to_string().contains("135 (MAG welding with solid wire)"));
    assert_eq!(wrong("process = 135", "process = -1").key, "process");
    assert_eq!(wrong("process = 135", "process = \"MAG\"").key, "process");
    let e = wrong("\"PB\"", "\"PH\"");
    assert!(e.key.contains("runs[0].positions") && e.message.to_string().contains("`PH`"), "{e}");
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("PA, PB, PC, PD, PE, PF, PG"));
    assert_eq!(wrong("[\"PA\", \"PB\"]", "[]").key, "runs[0].positions");
    assert_eq!(
        wrong("name = \"root\"", "name = \"hot\"").allowed.as_ref().map(ToString::to_string).as_deref(),
        Some("tack, root, fill, cap, cosmetic")
    );
}

#[test]
fn units_are_in_the_keys() {
    let e = wrong("speed_mm_s = [4, 6]", "speed_mm_min = [240, 360]");
    assert_eq!(
        e.help.as_ref().map(ToString::to_string).as_deref(),
        Some("did you mean `speed_mm_s`? This value is given in mm/s")
    );
    let e = wrong("heat_input_kj_mm", "heat_input_kj_cm");
    assert!(e.help.unwrap().to_string().contains("did you mean `heat_input_kj_mm`?"));
    assert!(wrong("interpass_c", "interpass_f").help.unwrap().to_string().contains("`interpass_c`"));
    assert!(wrong("wire_diameter_mm", "wire_diameter").help.unwrap().to_string().contains("`wire_diameter_mm`"));
    assert!(wrong("current_a =", "current =").message.to_string().contains("not a valid name of a process value"));
    let e = wrong("current_a = [150, 180]", "heat_input_kj_mm = [1, 2]");
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("heat_input_kj_mm beside `ranges`"));
    let e = wrong("name = \"root\"", "name = \"root\"\ncurrent_a = [150, 180]");
    assert!(e.message.to_string().contains("`current_a`") && e.help.unwrap().to_string().contains("[runs.ranges]"));
}

#[test]
fn passes_are_named_once() {
    assert!(wrong("name = \"root\"\n", "").message.to_string().contains("names no passes"));
    let e = wrong("name = \"root\"", "name = \"root\"\npasses = \"1\"");
    assert_eq!((e.key.as_str(), e.line), ("runs[0]", 6));
    assert!(e.message.to_string().contains("twice"));
    assert!(wrong("passes = \"2-4, 7\"", "name = \"root\"").message.to_string().contains("runs[0] has this name"));
    let e = wrong("name = \"root\"", "passes = \"1, 4\"");
    assert_eq!(
        (e.key.as_str(), e.message.to_string().as_str()),
        ("runs[1].passes", "pass 4 is named by runs[0] already")
    );
    for (text, message) in [
        ("2-4, 3", "pass 3 is named twice"),
        ("0", "`0` names no passes"),
        ("4-2", "`4-2` names no passes"),
        ("", "`` names no passes"),
        ("all", "`all` names no passes"),
        ("1,", "`` names no passes"),
        ("-1", "`-1` names no passes"),
    ] {
        let e = wrong("\"2-4, 7\"", &format!("\"{text}\""));
        assert_eq!(e.key, "runs[1].passes", "{text}");
        assert!(e.message.to_string().replace('`', "").contains(&message.replace('`', "")), "{text}: {}", e.message);
        assert!(e.allowed.unwrap().to_string().contains("2-5"));
    }
    assert!(wrong("passes = \"2-4, 7\"", "passes = 2").key.contains("runs[1].passes"));
    let none = TEXT.split("[[runs]]").next().unwrap().to_owned() + "runs = []\n";
    assert!(Procedure::read("w.toml", &none).unwrap_err().message.to_string().contains("no runs"));
}

#[test]
fn efficiencies_power_and_limits() {
    let with = |line: &str| format!("process = 135\n{line}");
    let key = |line: &str| wrong("process = 135", &with(line)).key;
    assert_eq!(key("thermal_efficiency = 1.2"), "thermal_efficiency");
    assert_eq!(key("deposition_efficiency = 95"), "deposition_efficiency");
    assert_eq!(key("thermal_efficiency = 0"), "thermal_efficiency");
    for power in
        ["[]", "[\"current_a\"]", "[\"current_a\", \"laser_w\"]", "[\"current_a\", \"beam_ma\"]", "[\"speed_mm_s\"]"]
    {
        assert!(key(&format!("power = {power}")).starts_with("power"), "{power}");
    }
    assert_eq!(key("position_limits.fillet.pb_deg = 20"), "position_limits.fillet.pb_deg");
    assert_eq!(key("position_limits.butt.pc_deg = 180"), "position_limits.butt.pc_deg");
    assert_eq!(key("position_limits.level_slope_deg = 85"), "position_limits.vertical_slope_deg");
    assert_eq!(key("position_limits.hysteresis_deg = 10"), "position_limits.hysteresis_deg");
    assert!(key("position_limits.fillet.pf_deg = 20").contains("position_limits.fillet"));
    assert_eq!(key("joint = \"groove\""), "joint");
    let good = TEXT.replace("process = 135", &with("position_limits.fillet.pb_deg = 60\npower = [\"arc_kw\"]"));
    let p = Procedure::read("w.toml", &good).unwrap().value;
    assert!((p.position_limits.fillet.pb_deg.get() - 60.0).abs() < 1e-15);
    assert_eq!(Procedure::read("w.toml", &p.to_toml().unwrap()).unwrap().value, p);
}

#[test]
fn a_program_holds_its_procedure() {
    let program = Program::read("p.toml", PROGRAM).unwrap_or_else(|e| panic!("{e}")).value;
    let again = program.to_toml().unwrap();
    assert_eq!(Program::read("p.toml", &again).unwrap_or_else(|e| panic!("{e}\n{again}")).value, program);
    let wrong = |from: &str, to: &str| {
        assert!(PROGRAM.contains(from));
        Program::read("p.toml", &PROGRAM.replacen(from, to, 1)).unwrap_err()
    };
    let e = wrong("passes = \"2\"", "passes = \"1-2\"");
    assert_eq!(
        (e.key.as_str(), e.message.to_string().as_str()),
        ("procedure.runs[1]", "pass 1 (root) is in runs[0] already")
    );
    assert_eq!(wrong("process = 141", "process = 999").key, "procedure.process");
    assert_eq!(wrong("passes = \"2\"", "speed_mm_s = [1, 2]").key, "procedure.runs[1]");
    assert_eq!(wrong("process = 141", "process = 141\nthermal_efficiency = 2").key, "procedure.thermal_efficiency");
}
