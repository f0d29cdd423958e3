//! Arms from parameters: of Denavit and Hartenberg, and of ortho-parallel arms.

use super::{ImportedArm, ImportedAxis};
use glam::{DAffine3, DVec3};
use seamwright_message::Message;
use std::f64::consts::PI;

/// Range of rotary (rad) and linear (mm) axes whose range is not given: from minus to plus.
const USUAL_RANGE: [f64; 2] = [PI, 1000.0];
/// Highest speed of axes whose speed is not given, rad/s and mm/s.
const USUAL_SPEED: [f64; 2] = [PI, 500.0];

/// Parameters of one axis by Denavit and Hartenberg, mm and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DhRow {
    /// Length along x.
    pub a: f64,
    /// Turn about x.
    pub alpha: f64,
    /// Offset along z; a linear axis adds its position.
    pub d: f64,
    /// Turn about z; a rotary axis adds its position.
    pub theta: f64,
    /// True for a linear axis.
    pub is_linear: bool,
}

/// Order of the four motions of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DhConvention {
    /// About and along z, then along and about x: Denavit and Hartenberg (1955), data sheets of Universal Robots.
    Standard,
    /// About and along x, then about and along z: Craig, Introduction to Robotics (1986).
    Modified,
}

/// Lengths of an ortho-parallel arm with a spherical wrist (Brandstötter, Angerer, Hofbaur: An Analytical Solution of the
/// Inverse Kinematics Problem of Industrial Serial Manipulators with an Ortho-parallel Basis and a Spherical Wrist, 2014,
/// figure 2), mm, and how the controller counts its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OpwArm {
    /// Lengths a1, a2, b, c1, c2, c3 and c4.
    pub lengths: [f64; 7],
    /// Offsets of the axes, rad: the model's angle is the sign times the position, less the offset.
    pub offsets: [f64; 6],
    /// Signs of the axes, 1 or -1.
    pub signs: [f64; 6],
}

/// An axis on its way from the base: where it is, and what follows at position zero.
struct Joint {
    /// Direction in the frame that has been reached.
    direction: DVec3,
    is_linear: bool,
    /// Displacement to the next frame with the axis at zero.
    next: DAffine3,
}

impl ImportedArm {
    /// The arm of these rows, from the base to the flange, with usual ranges and speeds.
    pub fn from_dh(rows: &[DhRow], convention: DhConvention) -> Self {
        let joint = |row: &DhRow| {
            let along_x = DAffine3::from_translation(row.a * DVec3::X) * DAffine3::from_rotation_x(row.alpha);
            let along_z = DAffine3::from_translation(row.d * DVec3::Z) * DAffine3::from_rotation_z(row.theta);
            (along_x, along_z)
        };
        let mut start = DAffine3::IDENTITY;
        let mut joints = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            let (along_x, along_z) = joint(row);
            let next = match convention {
                DhConvention::Standard => along_z * along_x,
                DhConvention::Modified => along_z * rows.get(i + 1).map_or(DAffine3::IDENTITY, |next| joint(next).0),
            };
            if i == 0 && convention == DhConvention::Modified {
                start = along_x;
            }
            joints.push(Joint { direction: DVec3::Z, is_linear: row.is_linear, next });
        }
        arm(start, &joints)
    }

    /// The six-axis arm of these lengths, with usual ranges and speeds. At model angles of zero it points upwards.
    pub fn from_opw(opw: &OpwArm) -> Self {
        let [a1, a2, b, c1, c2, c3, c4] = opw.lengths;
        let moves = [
            DVec3::new(a1, 0.0, c1),
            DVec3::new(0.0, 0.0, c2),
            DVec3::new(a2, b, c3),
            DVec3::ZERO,
            DVec3::ZERO,
            DVec3::new(0.0, 0.0, c4),
        ];
        let axes = [DVec3::Z, DVec3::Y, DVec3::Y, DVec3::Z, DVec3::Y, DVec3::Z];
        let joint = |i: usize| Joint {
            direction: opw.signs[i] * axes[i],
            is_linear: false,
            next: DAffine3::from_axis_angle(axes[i], -opw.offsets[i]) * DAffine3::from_translation(moves[i]),
        };
        arm(DAffine3::IDENTITY, &std::array::from_fn::<_, 6, _>(joint))
    }
}

fn arm(start: DAffine3, joints: &[Joint]) -> ImportedArm {
    let mut frame = start;
    let mut axes = Vec::new();
    for Joint { direction, is_linear, next } in joints {
        let kind = usize::from(*is_linear);
        let name = format!("j{}", axes.len() + 1);
        axes.push(ImportedAxis {
            source_name: name.clone(),
            name,
            is_rotary: !is_linear,
            direction: frame.matrix3 * *direction,
            at: frame.translation,
            range: Some([-USUAL_RANGE[kind], USUAL_RANGE[kind]]),
            home: 0.0,
            max_speed: USUAL_SPEED[kind],
            effort: None,
        });
        frame *= *next;
    }
    ImportedArm {
        name: "arm".to_owned(),
        title: "Arm".to_owned(),
        source: String::new(),
        axes,
        flange: frame,
        flange_name: "flange".to_owned(),
        tool: None,
        direction: DVec3::Z,
        work: DAffine3::IDENTITY,
        shapes: Vec::new(),
        ignored: Vec::new(),
        notes: vec![Message::new("machine-import-no-shapes")],
    }
}
