//! Protocols of robot controls on constructed packets: bytes after the manuals, and bytes at random.

use seamwright_executive::devices::robot::{
    Egm, Hindrance, ProtocolError, RobotOrder, RobotProtocol, RobotReport, RobotState, Rsi, Rtde, URSCRIPT,
};
use seamwright_machine::MAX_AXES;
use seamwright_testkit::{Random, cases};

fn order(joints: &[f64], follows: bool, number: u32) -> RobotOrder {
    let mut all = [0.0; MAX_AXES];
    all[..joints.len()].copy_from_slice(joints);
    RobotOrder { joints: all, follows, number }
}

/// A message of RTDE: length, type, body.
fn rtde(kind: u8, body: &[u8]) -> Vec<u8> {
    [&((body.len() + 3) as u16).to_be_bytes()[..], &[kind], body].concat()
}

/// An RTDE client after its handshake.
fn connected() -> Rtde {
    let (mut client, mut out) = (Rtde::new(125.0), Vec::new());
    client.begin(&mut out);
    assert_eq!(out, [0, 5, b'V', 0, 2]);
    out.clear();
    client.feed(&[0, 4, b'V', 1]).unwrap();
    assert_eq!(client.next(&mut out), Ok(None));
    // Outputs: length, type, 125 as a double, names.
    assert_eq!(out[2..11], [b'O', 0x40, 0x5f, 0x40, 0, 0, 0, 0, 0]);
    let first = usize::from(u16::from_be_bytes([out[0], out[1]]));
    assert!(out[11..first].starts_with(b"timestamp,actual_q,"));
    assert!(out[first + 2] == b'I' && out[first + 3..].starts_with(b"input_int_register_24,"));
    out.clear();
    let outputs = "DOUBLE,VECTOR6D,VECTOR6INT32,INT32,INT32,UINT32,INT32,INT32,INT32";
    client.feed(&rtde(b'O', &[&[7], outputs.as_bytes()].concat())).unwrap();
    let inputs = "INT32,INT32,DOUBLE,DOUBLE,DOUBLE,DOUBLE,DOUBLE,DOUBLE";
    // Messages are cut anywhere.
    let answer = rtde(b'I', &[&[9], inputs.as_bytes()].concat());
    client.feed(&answer[..20]).unwrap();
    assert_eq!(client.next(&mut out), Ok(None));
    assert!(out.is_empty());
    client.feed(&answer[20..]).unwrap();
    assert_eq!(client.next(&mut out), Ok(None));
    assert_eq!(out, [0, 3, b'S']);
    client.feed(&[0, 4, b'S', 1]).unwrap();
    assert_eq!(client.next(&mut out), Ok(None));
    client
}

/// A report of RTDE with these modes: robot, safety, runtime, follows, version.
fn rtde_report(modes: [i32; 5]) -> Vec<u8> {
    let [robot, safety, runtime, follows, version] = modes;
    let mut body = vec![7];
    body.extend(12.5f64.to_be_bytes());
    (1..=6).for_each(|joint| body.extend((0.1 * f64::from(joint)).to_be_bytes()));
    [253, 253, 252, 253, 253, 253].iter().for_each(|mode: &i32| body.extend(mode.to_be_bytes()));
    [robot, safety, runtime, 41, follows, version].iter().for_each(|value| body.extend(value.to_be_bytes()));
    rtde(b'U', &body)
}

#[test]
fn rtde_by_the_guide() {
    let mut out = Vec::new();
    for (modes, state) in [
        ([7, 1, 2, 1, 1], RobotState::Follows),
        ([7, 2, 2, 0, 1], RobotState::Ready),
        ([7, 3, 2, 1, 1], RobotState::Hindered(Hindrance::ProtectiveStop)),
        ([7, 5, 2, 1, 1], RobotState::Hindered(Hindrance::SafeguardStop)),
        ([7, 7, 2, 1, 1], RobotState::Hindered(Hindrance::EmergencyStop)),
        ([7, 9, 2, 1, 1], RobotState::Hindered(Hindrance::SafetyFault)),
        ([5, 1, 2, 0, 1], RobotState::Hindered(Hindrance::MotorsOff)),
        ([7, 1, 1, 0, 1], RobotState::Hindered(Hindrance::ProgramStopped)),
        ([7, 1, 2, 0, 0], RobotState::Hindered(Hindrance::OtherProgram)),
    ] {
        let mut client = connected();
        client.feed(&rtde_report(modes)).unwrap();
        let report = client.next(&mut out).unwrap().unwrap();
        assert_eq!((report.state, report.fault, report.clock_s), (state, 0b100, 12.5), "{modes:?}");
        assert!((report.joints[5] - 0.6).abs() < 1e-12 && report.joints[6] == 0.0);
    }
    let mut client = connected();
    out.clear();
    client.order(&order(&[0.0, 0.0, 0.0, 0.0, 0.0, -1.5], true, 77), &mut out);
    assert_eq!(out[..12], [0, 60, b'U', 9, 0, 0, 0, 77, 0, 0, 0, 1]);
    assert_eq!(out[52..60], (-1.5f64).to_be_bytes());
    // The registers of the program are those of the client.
    for register in ["read_input_integer_register(25)", "read_input_float_register(29)", "rtde_set_watchdog"] {
        assert!(URSCRIPT.contains(register), "{register}");
    }
}

#[test]
fn rtde_refuses() {
    let mut out = Vec::new();
    let answers: [(&[u8], ProtocolError); 5] = [
        (&[0, 4, b'V', 0], ProtocolError::Version),
        (&[0, 4, b'S', 0], ProtocolError::NotStarted),
        (&[0, 2, b'V'], ProtocolError::Malformed),
        (&rtde(b'O', b"\x01DOUBLE,NOT_FOUND,X"), ProtocolError::UnknownFields("actual_q".to_owned())),
        (&rtde(b'I', b"\x00INT32,IN_USE"), ProtocolError::FieldsInUse("input_int_register_25".to_owned())),
    ];
    for (bytes, error) in answers {
        let mut client = Rtde::new(500.0);
        client.begin(&mut out);
        client.feed(bytes).unwrap();
        assert_eq!(client.next(&mut out), Err(error));
    }
    // A report of another length.
    let mut client = connected();
    client.feed(&rtde(b'U', &[7, 1, 2, 3])).unwrap();
    assert_eq!(client.next(&mut out), Err(ProtocolError::Malformed));
}

/// A message of EGM: key, length, content.
fn nested(field: u8, content: &[u8]) -> Vec<u8> {
    [&[field << 3 | 2, content.len() as u8], content].concat()
}

/// `EgmRobot` with number, time (ms), joints, external joints and states.
fn egm(number: u8, ms: u8, joints: &[f64], external: &[f64], states: [u8; 3]) -> Vec<u8> {
    let list = |values: &[f64]| values.iter().flat_map(|v| [&[9][..], &v.to_le_bytes()].concat()).collect::<Vec<u8>>();
    let feedback = [nested(1, &list(joints)), nested(3, &list(external))].concat();
    let [motors, mci, rapid] = states;
    [
        nested(1, &[8, number, 16, ms, 24, 2]),
        nested(2, &feedback),
        nested(4, &[8, motors]),
        nested(5, &[8, mci]),
        nested(8, &[8, rapid]),
        // A double of a later version.
        vec![10 << 3 | 1, 0, 0, 0, 0, 0, 0, 0, 0],
    ]
    .concat()
}

fn one(protocol: &mut dyn RobotProtocol, bytes: &[u8]) -> Result<Option<RobotReport>, ProtocolError> {
    protocol.feed(bytes)?;
    protocol.next(&mut Vec::new())
}

#[test]
fn egm_by_its_messages() {
    let mut linear = [false; MAX_AXES];
    linear[6] = true;
    let mut sensor = Egm::new(6, 7, linear);
    let joints = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0];
    let report = one(&mut sensor, &egm(5, 20, &joints, &[250.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1, 3, 2])).unwrap().unwrap();
    assert_eq!((report.state, report.clock_s, report.begins), (RobotState::Follows, 0.02, false));
    assert!((report.joints[5] - 60f64.to_radians()).abs() < 1e-12);
    assert!((report.joints[6] - 250.0).abs() < 1e-12);
    // Doubled and overtaken datagrams are skipped.
    assert_eq!(one(&mut sensor, &egm(5, 20, &joints, &[0.0; 6], [1, 3, 2])), Ok(None));
    assert_eq!(one(&mut sensor, &egm(4, 16, &joints, &[0.0; 6], [1, 3, 2])), Ok(None));
    for (states, why) in [
        ([2, 3, 2], Hindrance::MotorsOff),
        ([1, 1, 2], Hindrance::ControlError),
        ([1, 2, 2], Hindrance::ProgramStopped),
        ([1, 3, 1], Hindrance::ProgramStopped),
    ] {
        let mut sensor = Egm::new(6, 7, linear);
        let report = one(&mut sensor, &egm(1, 0, &joints, &[0.0; 6], states)).unwrap().unwrap();
        assert_eq!(report.state, RobotState::Hindered(why));
    }
    let error = ProtocolError::Joints { reported: 6, needed: 7 };
    assert_eq!(one(&mut Egm::new(6, 7, linear), &egm(1, 0, &joints, &[], [1, 3, 2])), Err(error));
    // EgmSensor: number and type; planned joints in degrees, the linear one in mm.
    let mut out = Vec::new();
    let quarter = std::f64::consts::FRAC_PI_2;
    sensor.order(&order(&[quarter, 0.0, 0.0, 0.0, 0.0, 0.0, 12.5], true, 300), &mut out);
    let list = |values: &[f64]| values.iter().flat_map(|v| [&[9][..], &v.to_le_bytes()].concat()).collect::<Vec<u8>>();
    let planned = [nested(1, &list(&[90.0, 0.0, 0.0, 0.0, 0.0, 0.0])), nested(3, &list(&[12.5]))].concat();
    let expected = [nested(1, &[8, 0xac, 2, 24, 3]), nested(2, &planned)].concat();
    assert_eq!(out, expected);
}

fn rsi(ipoc: u64, joints: &str) -> Vec<u8> {
    format!(
        "<Rob Type=\"KUKA\">\r\n <RIst X=\"445.0\" Y=\"0\" Z=\"790.0\" A=\"180.0\" B=\"0.0\" C=\"180.0\"/>\r\n \
         <RSol X=\"445.0\" Y=\"0\" Z=\"790.0\" A=\"180.0\" B=\"0.0\" C=\"180.0\"/>\r\n <AIPos {joints}/>\r\n \
         <Delay D=\"0\"/><IPOC>{ipoc}</IPOC>\r\n</Rob>"
    )
    .into_bytes()
}

const JOINTS: &str = "A1=\"0.0000\" A2=\"-90.0\" A3=\"90.0\" A4=\"0.0\" A5=\"9e1\" A6=\"-0.5\"";

#[test]
fn rsi_by_its_messages() {
    let mut sensor = Rsi::new(6, [false; MAX_AXES]);
    let report = one(&mut sensor, &rsi(4_208_163, JOINTS)).unwrap().unwrap();
    assert_eq!((report.state, report.begins), (RobotState::Follows, false));
    assert!((report.clock_s - 4208.163).abs() < 1e-9 && (report.joints[1] + 90f64.to_radians()).abs() < 1e-12);
    assert!((report.joints[4] - 90f64.to_radians()).abs() < 1e-12);
    // Corrections count from the start; the answer repeats IPOC.
    let mut out = Vec::new();
    let to = [0.01, -1.57, 1.57, 0.0, 1.57, 0.0];
    sensor.order(&order(&to, true, 1), &mut out);
    let text = String::from_utf8(out).unwrap();
    assert!(text.starts_with("<Sen Type=\"ImFree\"><AK A1=\"0.572958\" A2=\"0.045626\""), "{text}");
    assert!(text.contains("A6=\"0.500000\"/>") && text.ends_with("<IPOC>4208163</IPOC></Sen>"), "{text}");
    assert_eq!(one(&mut sensor, &rsi(4_208_163, JOINTS)), Ok(None), "doubled");
    assert_eq!(one(&mut sensor, &rsi(4_208_159, JOINTS)), Ok(None), "overtaken");
    let next = one(&mut sensor, &rsi(4_208_167, JOINTS)).unwrap().unwrap();
    assert!(!next.begins);
    // RSI was started again, at another position.
    let moved = JOINTS.replace("A6=\"-0.5\"", "A6=\"10\"");
    assert!(one(&mut sensor, &rsi(4_300_000, &moved)).unwrap().unwrap().begins);
    let mut out = Vec::new();
    sensor.order(&order(&[0.0, 0.0, 0.0, 0.0, 0.0, 10f64.to_radians()], true, 2), &mut out);
    assert!(String::from_utf8(out).unwrap().contains("A6=\"0.000000\""));
    // External joints in their own elements.
    let mut sensor = Rsi::new(7, [false; MAX_AXES]);
    assert_eq!(one(&mut sensor, &rsi(1, JOINTS)), Err(ProtocolError::Joints { reported: 6, needed: 7 }));
    let both = format!("{JOINTS}/><EIPos E1=\"5\" E2=\"0\"");
    assert!((one(&mut sensor, &rsi(5, &both)).unwrap().unwrap().joints[6] - 5f64.to_radians()).abs() < 1e-12);
    for bad in [
        rsi(9, &JOINTS.replace("-0.5", "north")),
        rsi(9, &JOINTS.replace("-0.5", "NaN")),
        rsi(9, "A1=\"0\""),
        b"<Rob><IPOC>x</IPOC></Rob>".to_vec(),
        b"\xff\xfe".to_vec(),
    ] {
        assert!(one(&mut Rsi::new(6, [false; MAX_AXES]), &bad).is_err());
    }
}

/// Random bytes, and random changes of valid ones, are refused or read, never more.
#[test]
fn random_bytes() {
    let valid: [Vec<u8>; 5] = [
        rtde_report([7, 1, 2, 1, 1]),
        rtde(b'O', b"\x01DOUBLE,VECTOR6D"),
        egm(5, 20, &[1.0; 6], &[0.0; 6], [1, 3, 2]),
        rsi(100, JOINTS),
        vec![0x12, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1],
    ];
    let mut reports = 0;
    for case in 0..cases(4000u32) {
        let mut random = Random::of_case(case);
        let mut bytes = if random.one_in(4) {
            (0..random.below(80)).map(|_| random.bits() as u8).collect()
        } else {
            random.one(&valid).clone()
        };
        for _ in 0..random.below(4) {
            if !bytes.is_empty() {
                let at = random.below(bytes.len());
                if random.yes() {
                    bytes[at] = random.bits() as u8;
                } else {
                    bytes.truncate(at);
                }
            }
        }
        let protocols: [Box<dyn RobotProtocol>; 3] = [
            Box::new(connected()),
            Box::new(Egm::new(6, 6 + random.below(7), [random.yes(); MAX_AXES])),
            Box::new(Rsi::new(6 + random.below(7), [random.yes(); MAX_AXES])),
        ];
        for mut protocol in protocols {
            let mut out = Vec::new();
            for part in bytes.chunks(1 + random.below(bytes.len().max(1))) {
                if protocol.feed(part).is_err() {
                    break;
                }
                while let Ok(Some(report)) = protocol.next(&mut out) {
                    reports += 1;
                    assert!(report.clock_s.is_finite());
                    protocol.order(&order(&report.joints, true, case), &mut out);
                }
            }
            assert!(out.len() < 1 << 16);
        }
    }
    assert!(reports > 100, "{reports}");
}
