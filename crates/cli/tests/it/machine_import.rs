//! `machine import` and `machine new`: files that check and plan, and refusals that write nothing.

use crate::common::{bad, good, has_all, root, write};
use std::fs;

fn urdf(name: &str) -> String {
    root().join("crates/machine/tests/data").join(name).display().to_string()
}

#[test]
fn an_imported_arm_passes_the_check_and_plans_a_nozzle() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.toml").display().to_string();
    let tool = ["--tool", "90,0,330,0,35,0", "--work", "800,0,0"];
    let out = good(&[&["machine", "import", &urdf("kuka_kr16_2.urdf"), "-o", &file][..], &tool].concat());
    has_all(&out, &["wrote ", "check it: seamwright machine check "]);
    has_all(&good(&["machine", "check", &file, "--poses", "300"]), &["result       passed", "spherical wrist"]);
    let job = write(folder.path(), "job.toml", JOB.replace("MACHINE", "arm.toml"));
    has_all(&good(&["check", &job]), &["weld"]);
}

const JOB: &str = include_str!("../../../../tests/data/nozzle-on-arm.toml");

#[test]
fn meshes_are_found_in_their_package_and_named_from_the_machine_file() {
    let folder = tempfile::tempdir().unwrap();
    let package = folder.path().join("arm_support");
    fs::create_dir_all(package.join("urdf")).unwrap();
    fs::create_dir_all(package.join("meshes")).unwrap();
    fs::create_dir_all(folder.path().join("machines")).unwrap();
    let text = fs::read_to_string(urdf("kuka_kr16_2.urdf")).unwrap();
    let mesh = "<mesh filename=\"package://arm_support/meshes/base.stl\"/>";
    let text = text.replacen("<box size=\"0.5 0.45 0.3\"/>", mesh, 1);
    let arm = write(&package.join("urdf"), "arm.urdf", text);
    let file = folder.path().join("machines/arm.toml").display().to_string();
    let error = bad(2, &["machine", "import", &arm, "-o", &file]);
    has_all(
        &error,
        &["there is no mesh `package://arm_support/meshes/base.stl`", "arm_support/meshes/base.stl, ", "--package"],
    );
    assert!(!folder.path().join("machines/arm.toml").exists());
    fs::copy(root().join("tests/data/tetrahedron.stl"), package.join("meshes/base.stl")).unwrap();
    good(&["machine", "import", &arm, "-o", &file]);
    let written = fs::read_to_string(&file).unwrap();
    assert!(written.contains("shape.stl = { file = \"../arm_support/meshes/base.stl\", scale = 1000 }"), "{written}");
    good(&["machine", "check", &file, "--poses", "100"]);
}

#[test]
fn new_arms_come_from_parameters() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("arm.toml").display().to_string();
    let dh = "0,90,180.7,0;-612.7,0,0,0;-571.55,0,0,0;0,90,174.15,0;0,-90,119.85,0;0,0,116.55,0";
    good(&["machine", "new", "arm", "--dh", dh, "--name", "my-ur", "-o", &file]);
    has_all(&good(&["machine", "check", &file, "--poses", "300"]), &["my-ur", "passed", "three parallel axes"]);
    let opw = ["machine", "new", "arm", "--opw", "150,-115,0,445,700,795,85", "--offsets-deg", "0,0,-90,0,0,0"];
    let text = good(&[&opw[..], &["--speeds", "175,175,175,360,360,500", "--home", "0,0,0,0,30,0"]].concat());
    has_all(&text, &["max_speed_deg_s = 175", "home_deg = 30", "# Source of axes, ranges and speeds: a1, a2, b, c1"]);
    has_all(&bad(2, &[&opw[..], &["--speeds", "1,2"]].concat()), &["--speeds 2", "j1, j2, j3, j4, j5, j6"]);
    has_all(&bad(2, &[&opw[..], &["--home", "0,0,0,0,300,0"]].concat()), &["axis `j5`", "-180"]);
    bad(2, &["machine", "new", "arm"]);
    bad(2, &["machine", "new", "arm", "--dh", "1,2,3"]);
    bad(2, &["machine", "new", "arm", "--opw", "1,2,3"]);
}
