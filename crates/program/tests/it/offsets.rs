//! Work offsets and the placement of the seam.

use glam::DVec3;
use seamwright_program::Program;

const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\noffset = \"table\"\n\
    [offsets.table]\nmove_mm = [10, 0, 0]\nangle_deg = 90\n[offsets.chuck]\nmove_mm = [0, 0, 5]\n\
    [placement]\nmove_mm = [1, 2, 3]\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [1, 0, 0]\n\
    first_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[[passes]]\nname = \"root\"\n\
    [[passes.spans]]\nfrom_mm = 0\nto_mm = 1\nspeed_mm_s = 5\n";

#[test]
fn the_seam_stands_by_its_placement_and_then_by_the_offset() {
    let program = Program::read("p.toml", TEXT).unwrap().value;
    let p = program.seam_in_work().transform_point3(DVec3::X);
    assert!((p - DVec3::new(10.0 - 2.0, 2.0, 3.0)).length() < 1e-14, "{p}");
    assert_eq!(Program::read("p.toml", &program.to_toml().unwrap()).unwrap().value, program);
    let none = Program::read("p.toml", &TEXT.replace("offset = \"table\"\n", "")).unwrap().value;
    assert_eq!(none.seam_in_work(), none.placement.affine());
}

#[test]
fn an_offset_that_is_not_there_is_named() {
    let e = Program::read("p.toml", &TEXT.replace("= \"table\"", "= \"tabel\"")).unwrap_err();
    assert_eq!((e.line, e.key.as_str(), e.value.as_str()), (4, "offset", "\"tabel\""));
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("chuck, table"));
    assert_eq!(e.help.as_ref().map(ToString::to_string).as_deref(), Some("did you mean `table`?"));
    let e = Program::read("p.toml", &TEXT.replace("[offsets.chuck]", "[offsets.\"a b\"]")).unwrap_err();
    assert!(e.key == "offsets" && e.message.to_string().contains("`a b`"), "{e}");
}
