//! Arms from URDF files: forward kinematics against a product of transforms, plans of the files, every bad input.

use crate::common::random_joints;
use glam::{DMat4, DVec3, dvec3};
use seamwright_machine::check::{Check, CheckOptions};
use seamwright_machine::{
    DhConvention, DhRow, FoundMesh, ImportOptions, ImportedArm, Machine, MachineFile, OpwArm, shipped,
};
use seamwright_testkit::{Random, cases};
use std::f64::consts::{FRAC_PI_2, PI};

const UR10E: &str = include_str!("../data/ur10e.urdf");
const KR16: &str = include_str!("../data/kuka_kr16_2.urdf");

fn no_mesh(name: &str) -> Result<FoundMesh, Vec<String>> {
    Err(vec![format!("meshes/{name}")])
}

const OPTIONS: ImportOptions<'_> =
    ImportOptions { base: None, tip: None, scale: 1.0, with_shapes: true, find_mesh: &no_mesh };

fn import(text: &str) -> ImportedArm {
    ImportedArm::from_urdf("arm.urdf", text, &OPTIONS).unwrap_or_else(|e| panic!("{e}"))
}

fn machine(arm: &ImportedArm) -> Machine {
    Machine::read("arm.toml", &arm.to_toml()).unwrap_or_else(|e| panic!("{e}\n{}", arm.to_toml()))
}

/// A joint of the product: where it is on the link before, and what it turns about.
struct Step {
    xyz: DVec3,
    rpy: [f64; 3],
    axis: Option<DVec3>,
}

const fn step(xyz: [f64; 3], rpy: [f64; 3], axis: Option<DVec3>) -> Step {
    Step { xyz: DVec3::from_array(xyz), rpy, axis }
}

/// The end of a chain in metres, from its joints in order.
fn product(steps: &[Step], q: &[f64]) -> DMat4 {
    let mut turned = q.iter();
    steps.iter().fold(DMat4::IDENTITY, |frame, Step { xyz, rpy: [roll, pitch, yaw], axis }| {
        let (sr, cr) = roll.sin_cos();
        let (sp, cp) = pitch.sin_cos();
        let (sy, cy) = yaw.sin_cos();
        // Rows of Rz(yaw) Ry(pitch) Rx(roll), as in the specification of URDF.
        let rows = [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, xyz.x],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, xyz.y],
            [-sp, cp * sr, cp * cr, xyz.z],
            [0.0, 0.0, 0.0, 1.0],
        ];
        let placed = frame * DMat4::from_cols_array_2d(&rows).transpose();
        match axis {
            Some(axis) => placed * DMat4::from_axis_angle(*axis, *turned.next().unwrap()),
            None => placed,
        }
    })
}

fn same_forward(arm: &ImportedArm, steps: &[Step]) {
    let machine = machine(arm);
    let mut random = Random::new(11);
    for _ in 0..cases(10_000) {
        let q = random_joints(&machine, &mut random);
        let end = product(steps, &q[..machine.axes.len()]);
        let pose = machine.forward(&q);
        let off = (pose.point - 1000.0 * end.w_axis.truncate()).length();
        assert!(off < 1e-9, "{off:e} at {q:?}");
        assert!((pose.direction - end.z_axis.truncate()).length() < 1e-12, "{q:?}");
        assert!((machine.across(&q) - end.x_axis.truncate()).length() < 1e-12, "{q:?}");
    }
}

#[test]
fn a_ur10e_moves_as_its_description() {
    let z = Some(DVec3::Z);
    // With the right angles that the file rounds to ten digits.
    let steps = [
        step([0.0; 3], [0.0, 0.0, PI], None),
        step([0.0, 0.0, 0.1807], [0.0; 3], z),
        step([0.0; 3], [FRAC_PI_2, 0.0, 0.0], z),
        step([-0.6127, 0.0, 0.0], [0.0; 3], z),
        step([-0.57155, 0.0, 0.17415], [0.0; 3], z),
        step([0.0, -0.11985, -2.458_164_590_756_244e-11], [FRAC_PI_2, 0.0, 0.0], z),
        step([0.0, 0.11655, -2.390_480_459_346_185e-11], [1.570_796_326_589_793, PI, PI], z),
        step([0.0; 3], [0.0, -FRAC_PI_2, -FRAC_PI_2], None),
        step([0.0; 3], [FRAC_PI_2, 0.0, FRAC_PI_2], None),
    ];
    let arm = import(UR10E);
    let names: Vec<&str> = arm.axes.iter().map(|axis| axis.name.as_str()).collect();
    assert_eq!(names, ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"]);
    assert_eq!(arm.flange_name, "tool0");
    same_forward(&arm, &steps);
}

#[test]
fn a_kr_16_moves_as_its_description() {
    let y = Some(DVec3::Y);
    let steps = [
        step([0.0, 0.0, 0.675], [0.0; 3], Some(DVec3::NEG_Z)),
        step([0.26, 0.0, 0.0], [0.0; 3], y),
        step([0.68, 0.0, 0.0], [0.0; 3], y),
        step([0.67, 0.0, -0.035], [0.0; 3], Some(DVec3::NEG_X)),
        step([0.0; 3], [0.0; 3], y),
        step([0.0; 3], [0.0; 3], Some(DVec3::NEG_X)),
        step([0.158, 0.0, 0.0], [0.0, FRAC_PI_2, 0.0], None),
    ];
    same_forward(&import(KR16), &steps);
}

#[test]
fn imported_arms_have_a_closed_form_and_pass_the_check() {
    for (text, method) in [(UR10E, "three-parallel"), (KR16, "spherical-wrist")] {
        let mut arm = import(text);
        arm.choose_home(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap();
        let text = arm.to_toml();
        let machine = machine(&arm);
        let home = machine.home();
        assert!(machine.arm_margins(&home).unwrap().min() > 0.3, "{method}: {text}");
        let file = MachineFile::read("arm.toml", &text).unwrap();
        let check = Check::run(&file, &machine, &CheckOptions { seed: 1, poses: 300 }, &mut || {});
        assert!(check.passed, "{method}: {text}");
        assert!(check.remarks.is_empty(), "{:?}", check.remarks);
        assert!(text.contains("# Source of axes") && !machine.solids.solids.is_empty());
    }
}

#[test]
fn shapes_are_where_their_links_are() {
    let arm = import(KR16);
    let shape = &arm.shapes[1];
    assert_eq!((shape.link.as_str(), shape.solid.name.as_deref()), ("a2", Some("link_2")));
    // Joint 2 at (260, 0, 675), the box 340 mm from there.
    assert!((shape.solid.at.affine().translation - dvec3(600.0, 0.0, 675.0)).length() < 1e-9);
    let cylinder = &import(UR10E).shapes[0];
    // Centred on 50 mm, 100 mm long, in machine files from its lower end.
    assert_eq!(cylinder.link, "base");
    assert!(cylinder.solid.at.affine().translation.length() < 1e-9);
    let bare = ImportOptions { with_shapes: false, ..OPTIONS };
    assert!(ImportedArm::from_urdf("a", KR16, &bare).unwrap().shapes.is_empty());
}

#[test]
fn a_rail_a_tip_and_a_scale_are_chosen() {
    let text = "<robot name='On Rail'><link name='w'/><link name='a'/><link name='b'/><link name='f1'/><link name='f2'/>
        <joint name='rail' type='prismatic'><parent link='w'/><child link='a'/><axis xyz='0 2 0'/>
        <limit lower='-1500' upper='1500' velocity='500'/></joint>
        <joint name='1' type='continuous'><parent link='a'/><child link='b'/><origin xyz='100 0 300'/><axis xyz='0 0 1'/>
        <limit velocity='2'/></joint>
        <joint name='l' type='prismatic'><parent link='b'/><child link='f1'/><limit upper='10' velocity='5'/></joint>
        <joint name='r' type='fixed'><parent link='b'/><child link='f2'/></joint></robot>";
    let options = ImportOptions { tip: Some("f2"), scale: 0.001, ..OPTIONS };
    let arm = ImportedArm::from_urdf("a", text, &options).unwrap();
    assert_eq!(arm.name, "on-rail");
    let machine = machine(&arm);
    assert_eq!(machine.axes[0].range, Some((-1500.0, 1500.0)));
    assert!(machine.axes[1].range.is_none() && machine.axes[1].name == "j1");
    let mut q = machine.home();
    q[0] = 70.0;
    q[1] = FRAC_PI_2;
    assert!((machine.forward(&q).point - dvec3(100.0, 70.0, 300.0)).length() < 1e-9);
    assert!(arm.to_toml().contains("joints beside the chain stay at zero: l"), "{}", arm.to_toml());
}

/// A fault: what replaces a part of the text of the KR 16, and words of the error.
struct Bad {
    from: &'static str,
    to: &'static str,
    words: [&'static str; 2],
}

const fn bad(from: &'static str, to: &'static str, words: [&'static str; 2]) -> Bad {
    Bad { from, to, words }
}

#[test]
fn every_bad_input_is_refused_with_its_place_and_cure() {
    let limit = "<limit effort=\"0\" lower=\"-3.22885911619\" upper=\"3.22885911619\" velocity=\"2.722713633111\"/>";
    let cases = [
        bad(limit, "", ["joint[joint_a1]: joint `joint_a1` has no limits", "Write `<limit"]),
        bad(limit, "<limit velocity='1'/>", ["range of joint `joint_a1` is empty", "Write `<limit"]),
        bad(limit, "<limit lower='1' upper='-1' velocity='1'/>", ["joint[joint_a1].limit.upper = -1", "is empty"]),
        bad(limit, "<limit lower='-1' upper='1'/>", ["has no maximum speed", "Give `velocity`"]),
        bad(limit, "<limit lower='-1' upper='1' velocity='0'/>", ["limit.velocity = 0", "Give `velocity`"]),
        bad(limit, "<limit lower='-185' upper='185' velocity='2'/>", ["no angles in rad", "divided by 57.29578"]),
        bad(limit, "<limit lower='-3' upper='3' velocity='156'/>", ["velocity = 156", "divided by 57.29578"]),
        bad(
            limit,
            "<limit lower='-3' upper='abc' velocity='1'/>",
            ["upper = abc: invalid numbers", "Numbers needed here: 1"],
        ),
        bad(
            limit,
            "<mimic joint='joint_a2'/>",
            ["joint `joint_a1` follows joint `joint_a2`", "`--tip` before this joint"],
        ),
        bad(
            "type=\"revolute\"",
            "type=\"floating\"",
            ["joint[joint_a1].type = floating", "Allowed between base and tip"],
        ),
        bad("<axis xyz=\"0 0 -1\"/>", "<axis xyz=\"0 0 0\"/>", ["axis.xyz = 0 0 0", "Give a direction"]),
        bad("xyz=\"0 0 0.675\"", "xyz=\"0 0\"", ["origin.xyz = 0 0", "Numbers needed here: 3"]),
        bad("xyz=\"0 0 0.675\"", "xyz=\"0 0 675\"", ["joint[joint_a1]: the chain", "--scale 0.001"]),
        bad(
            "<parent link=\"base_link\"/>",
            "<parent link=\"bas_link\"/>",
            ["there is no link `bas_link`", "allowed: base, base_link"],
        ),
        bad("<parent link=\"base_link\"/>", "", ["the element lacks `<parent>`", "Add `<parent"]),
        bad("<link name=\"link_4\"/>", "<link name=\"link_1\"/>", ["the name `link_1` is used twice", "Rename"]),
        bad("<link name=\"link_4\"/>", "<link/>", ["lacks the attribute `name`", "Add `name"]),
        bad(
            "<link name=\"tool0\"/>",
            "<link name=\"tool0\"/><link name=\"x\"/>",
            ["several base links: base_link, x", "--base LINK"],
        ),
        bad("<box size=\"0.5 0.45 0.3\"/>", "<box size=\"0.5 0 0.3\"/>", ["size = 0.5 0 0.3", "greater than 0"]),
        bad(
            "<box size=\"0.5 0.45 0.3\"/>",
            "<mesh filename=\"package://p/a.stl\"/>",
            ["no mesh `package://p/a.stl`", "--package NAME=DIR"],
        ),
        bad(
            "<robot",
            "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro/></robot><robot",
            ["not XML", "Correct the XML"],
        ),
        bad(
            "<link name=\"link_4\"/>",
            "<xacro:if xmlns:xacro='http://www.ros.org/wiki/xacro'/>",
            ["xacro macros", "xacro robot.urdf.xacro"],
        ),
        bad("</robot>", "", ["not XML", "Correct the XML"]),
    ];
    for Bad { from, to, words } in cases {
        assert!(KR16.contains(from), "{from}");
        let text = KR16.replacen(from, to, 1);
        let Err(error) = ImportedArm::from_urdf("arm.urdf", &text, &OPTIONS) else { panic!("accepted: {to}") };
        let shown = error.to_string();
        assert!(words.iter().all(|word| shown.contains(word)), "{to}: {words:?}\n{shown}");
        assert!(
            shown.starts_with("arm.urdf:") && shown.contains("help: ") && shown.contains("code: machine-urdf-"),
            "{shown}"
        );
    }
}

#[test]
fn trees_without_one_chain_are_refused() {
    let fingers = KR16.replacen(
        "</robot>",
        "<link name='left'/><link name='right'/>
         <joint name='l' type='prismatic'><parent link='tool0'/><child link='left'/></joint>
         <joint name='r' type='prismatic'><parent link='tool0'/><child link='right'/></joint></robot>",
        1,
    );
    let shown = |text: &str, options: &ImportOptions<'_>| {
        ImportedArm::from_urdf("arm.urdf", text, options).map(|_| ()).unwrap_err().to_string()
    };
    let two = shown(&fingers, &OPTIONS);
    assert!(two.contains("2 ends that axes move: left, right") && two.contains("--tip LINK"), "{two}");
    let chosen = ImportOptions { tip: Some("tool0"), ..OPTIONS };
    assert_eq!(ImportedArm::from_urdf("arm.urdf", &fingers, &chosen).unwrap().axes.len(), 6);
    let elsewhere = ImportOptions { base: Some("link_6"), tip: Some("base"), ..OPTIONS };
    assert!(shown(KR16, &elsewhere).contains("does not carry the link `base`"));
    let none = ImportOptions { base: Some("link_6"), tip: Some("tool0"), ..OPTIONS };
    assert!(shown(KR16, &none).contains("number of axes up to link `tool0`: 0"));
    let none = ImportOptions { base: Some("link_6"), ..OPTIONS };
    assert!(shown(KR16, &none).contains("no axis moves a link that is carried by `link_6`"));
    let unknown = ImportOptions { tip: Some("flange"), ..OPTIONS };
    assert!(shown(KR16, &unknown).contains("there is no link `flange`"));
    let ring = "<robot name='r'><link name='a'/><link name='b'/>
        <joint name='1' type='fixed'><parent link='a'/><child link='b'/></joint>
        <joint name='2' type='fixed'><parent link='b'/><child link='a'/></joint></robot>";
    assert!(shown(ring, &OPTIONS).contains("closed loop"));
    assert!(shown(ring, &ImportOptions { base: Some("a"), ..OPTIONS }).contains("no axis moves"));
    let twice = ring.replace("'b'/><child link='a'", "'a'/><child link='b'");
    assert!(shown(&twice, &OPTIONS).contains("already the child of joint `1`"));
    assert!(shown("<sdf/>", &OPTIONS).contains("the root element is `sdf`"));
    assert!(shown("<robot/>", &OPTIONS).contains("the file has no links"));
    assert!(shown("", &OPTIONS).contains("not XML"));
}

#[test]
fn damaged_files_end_without_a_panic() {
    let mut random = Random::new(5);
    for text in [UR10E, KR16] {
        for _ in 0..cases(400) {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=random.below(4) {
                let at = random.below(bytes.len());
                match random.below(4) {
                    0 => bytes.truncate(at),
                    1 => bytes[at] = b"<>\"/0-e. "[random.below(9)],
                    2 => drop(bytes.drain(at..(at + random.below(60)).min(bytes.len()))),
                    _ => bytes.insert(at, b"<>\"&0-eX"[random.below(8)]),
                }
                if bytes.is_empty() {
                    break;
                }
            }
            let text = String::from_utf8_lossy(&bytes);
            if let Ok(arm) = ImportedArm::from_urdf("arm.urdf", &text, &OPTIONS) {
                // Its text is a machine file, or the error has its own address.
                let _ = Machine::read("arm.toml", &arm.to_toml());
            }
        }
    }
}

#[test]
fn meshes_are_read_or_left_out_with_a_reason() {
    let with = |mesh: &str| KR16.replacen("<box size=\"0.5 0.45 0.3\"/>", &format!("<mesh {mesh}/>"), 1);
    let found = |name: &str| Ok(FoundMesh { name: format!("found/{name}"), bytes: TETRAHEDRON.as_bytes().to_vec() });
    let options = ImportOptions { find_mesh: &found, ..OPTIONS };
    let mut arm = ImportedArm::from_urdf("a", &with("filename='m.STL' scale='0.001 0.001 0.001'"), &options).unwrap();
    arm.choose_home(&|_| Ok(TETRAHEDRON.into())).unwrap();
    assert!(arm.to_toml().contains("shape.stl = { file = \"found/m.STL\", scale = 1 }"), "{}", arm.to_toml());
    for (mesh, reason) in
        [("filename='m.dae'", "convert it to STL"), ("filename='m.stl' scale='1 1 2'", "its scale differs")]
    {
        let arm = ImportedArm::from_urdf("a", &with(mesh), &options).unwrap();
        assert!(arm.notes.iter().any(|note| note.to_string().contains(reason)), "{:?}", arm.notes);
    }
    let open = |_: &str| Ok(FoundMesh { name: "m.stl".to_owned(), bytes: b"solid x\nendsolid x\n".to_vec() });
    let arm = ImportedArm::from_urdf("a", &with("filename='m.stl'"), &ImportOptions { find_mesh: &open, ..OPTIONS });
    assert!(arm.unwrap().notes.iter().any(|note| note.to_string().contains("was left out")));
}

const TETRAHEDRON: &str = "solid t
facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 90 0\nvertex 90 0 0\nendloop\nendfacet
facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 90 0 0\nvertex 0 0 90\nendloop\nendfacet
facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 90\nvertex 0 90 0\nendloop\nendfacet
facet normal 1 1 1\nouter loop\nvertex 90 0 0\nvertex 0 90 0\nvertex 0 0 90\nendloop\nendfacet
endsolid t\n";

fn row(a: f64, alpha_deg: f64, d: f64, theta_deg: f64) -> DhRow {
    DhRow { a, alpha: alpha_deg.to_radians(), d, theta: theta_deg.to_radians(), is_linear: false }
}

/// The end of rows of Denavit and Hartenberg by the matrices of textbooks.
fn of_rows(rows: &[DhRow], q: &[f64], convention: DhConvention) -> DMat4 {
    rows.iter().zip(q).fold(DMat4::IDENTITY, |frame, (row, q)| {
        let (st, ct) = (row.theta + if row.is_linear { 0.0 } else { *q }).sin_cos();
        let d = row.d + if row.is_linear { *q } else { 0.0 };
        let ((sa, ca), a) = (row.alpha.sin_cos(), row.a);
        let rows = match convention {
            DhConvention::Standard => [
                [ct, -st * ca, st * sa, a * ct],
                [st, ct * ca, -ct * sa, a * st],
                [0.0, sa, ca, d],
                [0.0, 0.0, 0.0, 1.0],
            ],
            DhConvention::Modified => [
                [ct, -st, 0.0, a],
                [st * ca, ct * ca, -sa, -sa * d],
                [st * sa, ct * sa, ca, ca * d],
                [0.0, 0.0, 0.0, 1.0],
            ],
        };
        frame * DMat4::from_cols_array_2d(&rows).transpose()
    })
}

#[test]
fn rows_of_denavit_and_hartenberg_become_the_same_arm() {
    let ur10e = [
        row(0.0, 90.0, 180.7, 0.0),
        row(-612.7, 0.0, 0.0, 0.0),
        row(-571.55, 0.0, 0.0, 0.0),
        row(0.0, 90.0, 174.15, 0.0),
        row(0.0, -90.0, 119.85, 0.0),
        row(0.0, 0.0, 116.55, 0.0),
    ];
    let mut odd = vec![row(10.0, 20.0, 30.0, 40.0), row(-150.0, 75.0, 0.0, -10.0), row(80.0, -33.0, 12.0, 90.0)];
    odd.push(DhRow { is_linear: true, ..row(5.0, 90.0, 100.0, 15.0) });
    let mut random = Random::new(3);
    for rows in [&ur10e[..], &odd] {
        for convention in [DhConvention::Standard, DhConvention::Modified] {
            let machine = machine(&ImportedArm::from_dh(rows, convention));
            for _ in 0..cases(1000) {
                let q = random_joints(&machine, &mut random);
                let (end, pose) = (of_rows(rows, &q, convention), machine.forward(&q));
                assert!((pose.point - end.w_axis.truncate()).length() < 1e-9, "{convention:?}");
                assert!((pose.direction - end.z_axis.truncate()).length() < 1e-12, "{convention:?}");
                assert!((machine.across(&q) - end.x_axis.truncate()).length() < 1e-12, "{convention:?}");
            }
        }
    }
    // The supplied file of the UR10e, but for its torch.
    let supplied = shipped("ur10e").unwrap();
    let supplied = Machine::read(supplied.name, supplied.text).unwrap();
    let new = machine(&ImportedArm::from_dh(&ur10e, DhConvention::Standard));
    for (a, b) in new.axes.iter().zip(&supplied.axes) {
        assert_eq!(a.kind, b.kind);
    }
}

/// The flange of an ortho-parallel arm: equations 5 to 10 of Brandstötter, Angerer and Hofbaur.
fn of_lengths(opw: &OpwArm, q: &[f64]) -> (DVec3, DVec3, DVec3) {
    let [a1, a2, b, c1, c2, c3, c4] = opw.lengths;
    let t: [f64; 6] = std::array::from_fn(|i| opw.signs[i] * q[i] - opw.offsets[i]);
    let (psi, k) = (a2.atan2(c3), a2.hypot(c3));
    let x = c2 * t[1].sin() + k * (t[1] + t[2] + psi).sin() + a1;
    let z = c2 * t[1].cos() + k * (t[1] + t[2] + psi).cos() + c1;
    let centre = dvec3(x * t[0].cos() - b * t[0].sin(), x * t[0].sin() + b * t[0].cos(), z);
    let turn = |axis, angle| glam::DMat3::from_axis_angle(axis, angle);
    let rotation = turn(DVec3::Z, t[0])
        * turn(DVec3::Y, t[1] + t[2])
        * turn(DVec3::Z, t[3])
        * turn(DVec3::Y, t[4])
        * turn(DVec3::Z, t[5]);
    (centre + c4 * rotation.z_axis, rotation.z_axis, rotation.x_axis)
}

#[test]
fn lengths_of_an_ortho_parallel_arm_become_the_same_arm() {
    let mut random = Random::new(4);
    let degrees = |offsets: [f64; 6]| offsets.map(f64::to_radians);
    for opw in [
        // ABB IRB 2600-12/1.65.
        OpwArm {
            lengths: [150.0, -115.0, 0.0, 445.0, 700.0, 795.0, 85.0],
            offsets: degrees([0.0, 0.0, -90.0, 0.0, 0.0, 0.0]),
            signs: [1.0; 6],
        },
        OpwArm {
            lengths: [260.0, 35.0, 17.0, 675.0, 680.0, 670.0, 158.0],
            offsets: degrees([12.0, -90.0, 7.0, 180.0, 3.0, 5.0]),
            signs: [-1.0, 1.0, 1.0, -1.0, 1.0, -1.0],
        },
    ] {
        let arm = ImportedArm::from_opw(&opw);
        let machine = machine(&arm);
        assert!(machine.has_free_roll() && machine.arm_margins(&machine.home()).is_some());
        for _ in 0..cases(2000) {
            let q = random_joints(&machine, &mut random);
            let ((point, direction, across), pose) = (of_lengths(&opw, &q), machine.forward(&q));
            assert!((pose.point - point).length() < 1e-9);
            assert!((pose.direction - direction).length() < 1e-12 && (machine.across(&q) - across).length() < 1e-12);
        }
    }
}
