//! Program files: written and read, gaps and empty passes refused.

use seamwright_program::Program;

const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n\
    [seam.nozzle.body.cylinder]\nradius_mm = 800\n[[passes]]\nname = \"root\"\n\
    [[passes.spans]]\nfrom_mm = 0\nto_mm = 10.5\nspeed_mm_s = 5\nprocess = { current_a = 180 }\n\
    [[passes.spans]]\nfrom_mm = 10.5\nto_mm = 20\nspeed_mm_s = 8\nprocess = { current_a = 200 }\n";

#[test]
fn writing_and_reading_gives_the_same_program() {
    let program = Program::read("p.toml", TEXT).unwrap().value;
    let again = Program::read("p.toml", &program.to_toml().unwrap()).unwrap().value;
    assert_eq!(program, again);
    assert!((program.passes[0].length() - 20.0).abs() < 1e-15);
    assert!((program.passes[0].speed_at(10.5) - 8.0).abs() < 1e-15);
    assert!((program.passes[0].speed_at(25.0) - 8.0).abs() < 1e-15);
}

#[test]
fn gaps_and_empty_passes_are_refused() {
    let e = Program::read("p.toml", &TEXT.replace("from_mm = 10.5", "from_mm = 11")).unwrap_err();
    assert_eq!((e.key.as_str(), e.line, e.value.as_str()), ("passes[0].spans[1].from_mm", 16, "11"));
    let e = Program::read("p.toml", &TEXT.replace("to_mm = 20", "to_mm = 10.5")).unwrap_err();
    assert_eq!(e.key, "passes[0].spans[1].to_mm");
    let e = Program::read("p.toml", &TEXT.replace("current_a = 200", "voltage_v = 20")).unwrap_err();
    assert_eq!(
        (e.key.as_str(), e.allowed.as_ref().map(ToString::to_string).as_deref()),
        ("passes[0].spans[1].process", Some("current_a"))
    );
    let least = TEXT.replace("name = \"root\"", "name = \"root\"\nleast_speed_mm_s = 6");
    let e = Program::read("p.toml", &least).unwrap_err();
    assert_eq!((e.key.as_str(), e.value.as_str()), ("passes[0].least_speed_mm_s", "6"));
    assert!(Program::read("p.toml", &least.replace("= 6", "= 4.9")).is_ok());
    let corner = TEXT.replace("name = \"root\"", "name = \"root\"\ncorner = { blend_mm = 0.4 }");
    let blended = Program::read("p.toml", &corner).unwrap().value;
    assert_eq!(Program::read("p.toml", &blended.to_toml().unwrap()).unwrap().value, blended);
    let e = Program::read("p.toml", &corner.replace("0.4", "0.7")).unwrap_err();
    assert_eq!((e.key.as_str(), e.value.as_str()), ("passes[0].corner.blend_mm", "0.7"));
    assert_eq!(
        e.allowed.as_ref().map(ToString::to_string).as_deref(),
        Some("more than 0, up to passes[0].tolerance.path_mm = 0.5")
    );
    let none = TEXT.split("[[passes.spans]]").next().unwrap().to_owned() + "spans = []\n";
    assert!(Program::read("p.toml", &none).unwrap_err().message.to_string().contains("no spans"));
}
