//! Configuration data: which of the arm's positions a pose means.

use super::arm::RobotArm;
use super::language::RobotLanguage;
use seamwright_machine::{ArmConfiguration, Elbow, Joints, Machine, Shoulder};

impl RobotLanguage {
    /// The arm's configuration at positions `q` in the numbers of the language:
    ///
    /// - RAPID: cf1, cf4, cf6 (quadrants of axes 1, 4 and 6) and cfx (shoulder, elbow, wrist).
    /// - KRL: status S and turn T.
    /// - FANUC: flip, up, front as 0 or 1, then turns of axes 1, 4 and 6.
    /// - INFORM: the first eight numbers of RCONF.
    /// - URScript: none, the arm takes the positions nearest to its own.
    pub(crate) fn configuration(self, machine: &Machine, arm: &RobotArm, q: &Joints) -> Vec<i32> {
        let Some(of) = machine.arm_configuration(q) else { return Vec::new() };
        let deg = arm.arm_deg(q);
        match self {
            Self::Rapid => rapid(&deg, &of),
            Self::Krl => krl(&deg, &of),
            Self::FanucLs => fanuc(&deg, &of),
            Self::Inform => inform(&deg, &of),
            Self::Urscript => Vec::new(),
        }
    }
}

/// Quadrant of an angle: 0 from 0 to 90 degrees, 1 to 180, -1 down to -90.
fn quadrant(deg: f64) -> i32 {
    (deg / 90.0).floor() as i32
}

/// cfx: 4 if the wrist is behind axis 1, 2 if it is behind the lower arm, 1 if axis 5 is negative.
fn rapid(deg: &[f64; 6], of: &ArmConfiguration) -> Vec<i32> {
    let cfx =
        4 * i32::from(of.shoulder == Shoulder::Back) + 2 * i32::from(of.elbow == Elbow::Down) + i32::from(deg[4] < 0.0);
    vec![quadrant(deg[0]), quadrant(deg[3]), quadrant(deg[5]), cfx]
}

/// S: bit 0 if the wrist is over or behind axis 1, bit 1 if the elbow is bent upwards (A3 beyond its stretched position),
/// bit 2 if A5 is positive. T: bit n - 1 if axis n is negative.
fn krl(deg: &[f64; 6], of: &ArmConfiguration) -> Vec<i32> {
    let status =
        i32::from(of.shoulder == Shoulder::Back) + 2 * i32::from(of.elbow == Elbow::Up) + 4 * i32::from(deg[4] > 0.0);
    let turn = deg.iter().enumerate().map(|(i, angle)| i32::from(*angle < 0.0) << i).sum();
    vec![status, turn]
}

fn fanuc(deg: &[f64; 6], of: &ArmConfiguration) -> Vec<i32> {
    let turns = [0, 3, 5].map(|i| of.turns[i]);
    let flags = [deg[4] > 0.0, of.elbow == Elbow::Up, of.shoulder == Shoulder::Front].map(i32::from);
    flags.into_iter().chain(turns).collect()
}

/// No-flip (axis R turned by more than a quarter, whole turns aside), lower arm, rear, then whether R, T and S are beyond
/// half a turn; the last two are of axes that the arm lacks.
fn inform(deg: &[f64; 6], of: &ArmConfiguration) -> Vec<i32> {
    let far = |i: usize| deg[i] > 180.0 || deg[i] <= -180.0;
    let quarters = (deg[3] + 90.0).rem_euclid(360.0);
    let flips = quarters > 0.0 && quarters <= 180.0;
    let flags = [!flips, of.elbow == Elbow::Down, of.shoulder == Shoulder::Back, far(3), far(5), far(0), false, false];
    flags.map(i32::from).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::pose::RobotPose;
    use crate::robot::program::{JointTarget, RobotProgram, RobotStep, TcpMove};
    use crate::robot::write::{RobotText, write_robot};
    use seamwright_machine::shipped;

    fn of(name: &str, language: RobotLanguage, deg: [f64; 6]) -> Vec<i32> {
        let machine = Machine::read(name, shipped(name).unwrap().text).unwrap();
        let arm = RobotArm::new(&machine, language).unwrap();
        let mut q = Joints::default();
        arm.joints.iter().zip(deg).for_each(|(axis, deg)| q[*axis] = deg.to_radians());
        language.configuration(&machine, &arm, &q)
    }

    /// Positions whose data the makers' manuals show: the arm in front of its base, elbow up.
    #[test]
    fn data_are_those_of_known_positions() {
        let rapid = |deg| of("irb-2600", RobotLanguage::Rapid, deg);
        assert_eq!(rapid([0.0, 0.0, 0.0, 0.0, 30.0, 0.0]), [0, 0, 0, 0]);
        assert_eq!(rapid([-10.0, 0.0, 0.0, 100.0, -30.0, 185.0]), [-1, 1, 2, 1]);
        // KUKA's usual start: S 2, and T 2 for a negative A2.
        let krl = |deg| of("kr-16", RobotLanguage::Krl, deg);
        assert_eq!(krl([0.0, -90.0, 90.0, 0.0, 0.0, 0.0]), [2, 2]);
        assert_eq!(krl([-5.0, -90.0, 90.0, 0.0, 30.0, -1.0]), [6, 35]);
        // FANUC's usual start with the tool down: N U T.
        let fanuc = |deg| of("arc-mate-120id", RobotLanguage::FanucLs, deg);
        assert_eq!(fanuc([0.0, 0.0, 0.0, 0.0, -90.0, 0.0]), [0, 1, 1, 0, 0, 0]);
        assert_eq!(fanuc([0.0, 0.0, 0.0, 190.0, 60.0, 0.0]), [1, 1, 1, 0, 1, 0]);
        let inform = |deg| of("ar1440", RobotLanguage::Inform, deg);
        assert_eq!(inform([0.0, 0.0, 0.0, 0.0, -90.0, 190.0]), [0, 0, 0, 0, 1, 0, 0, 0]);
        // Ranges of R printed in the NX100 operator's manual: flip up to 90 degrees, no-flip above, flip again from 270.
        for (r, no_flip, far) in
            [(90.0, 0, 0), (90.1, 1, 0), (-89.9, 0, 0), (-90.0, 1, 0), (181.0, 1, 1), (-275.0, 0, 1)]
        {
            assert_eq!(inform([0.0, 0.0, 0.0, r, -90.0, 0.0]), [no_flip, 0, 0, far, 0, 0, 0, 0], "{r}");
        }
        // Turned half round at the base and bent over backwards: rear.
        assert_eq!(inform([170.0, -80.0, 130.0, 0.0, -30.0, 0.0])[2], 1);
        assert!(of("ur10e", RobotLanguage::Urscript, [0.0, -90.0, -90.0, -90.0, 90.0, 0.0]).is_empty());
    }

    /// A position of a FANUC arm published with its axes for both sides of the wrist (J. Strybis, "The perils of six-axis
    /// robots", onerobotics.com, 2013): W 135, P -45, R 0. The orientation does not depend on the lengths of the arm.
    #[test]
    fn a_published_position_has_its_orientation() {
        let machine = Machine::read("m", shipped("arc-mate-120id").unwrap().text).unwrap();
        let arm = RobotArm::new(&machine, RobotLanguage::FanucLs).unwrap();
        for (pendant, configuration) in [
            ([7.962, -5.284, -36.25, 77.661, -51.975, -79.273], "'N U T, 0, 0, 0'"),
            ([7.962, -5.284, -36.25, -102.339, 51.975, 100.727], "'F U T, 0, 0, 0'"),
        ] {
            // The pendant counts J3 from the horizontal.
            let mut deg: [f64; 6] = pendant;
            deg[2] += deg[1];
            let mut q = machine.home();
            arm.joints.iter().zip(deg).for_each(|(axis, deg)| q[*axis] = deg.to_radians());
            let turn = arm.work.turn * RobotArm::pose(&machine, &q).turn * arm.tool.turn.inverse();
            let flange = TcpMove {
                via: None,
                to: RobotPose { turn, ..RobotPose::IDENTITY },
                externals: Vec::new(),
                configuration: RobotLanguage::FanucLs.configuration(&machine, &arm, &q),
                speed_mm_s: 1.0,
                zone_mm: 0.0,
            };
            let joints = RobotStep::Joints(JointTarget { arm: deg, externals: Vec::new() });
            let steps = vec![RobotStep::Pass(String::new()), joints, RobotStep::Move(flange)];
            let program = RobotProgram { title: String::new(), frames: None, steps };
            let text = RobotText { machine: &machine, arm: &arm, remarks: &[] };
            let text = write_robot(RobotLanguage::FanucLs, &program, &text);
            assert!(text.contains(configuration) && text.contains("J3= -36.25 deg"), "{text}");
            for (word, angle) in [("\tW = ", 135.0), ("\tP = ", -45.0), ("\tR = ", 0.0)] {
                let (_, rest) = text.split_once(word).unwrap();
                let written: f64 = rest.split(' ').next().unwrap().parse().unwrap();
                assert!((written - angle).abs() < 2e-3, "{word}: {written}");
            }
        }
    }
}
