//! Drives by a robot control that takes set-points.

use super::robot_file::{EgmFile, RsiFile, RtdeFile};
use crate::axis::{Axis, AxisKind};
use crate::file::MachineFile;
use seamwright_document::{Document, DocumentError, NonNegative};
use seamwright_message::{Message, Unit};
use std::net::{IpAddr, SocketAddr};

/// Number of joints of an arm, where the protocol leaves no choice.
const ARM: usize = 6;
/// Maximum number of external joints of EGM and RSI.
const MAX_EXTERNAL: usize = 6;
/// Port of RTDE.
const RTDE_PORT: u16 = 30004;
/// Time that the default store covers, s: the delay of a desktop's cycle that is rarely exceeded.
const STORE_S: f64 = 0.01;
/// Maximum of `latency_ms`.
const MAX_LATENCY_MS: f64 = 200.0;

/// The drives by a robot control that takes set-points.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotDevice {
    /// Its name in the machine file.
    pub name: String,
    /// Its protocol.
    pub protocol: RobotProtocolKind,
    /// Axes of the machine, by index, in the order of the control's joints.
    pub axes: Vec<usize>,
    /// Number of the arm's joints; the axes beyond it are external joints.
    pub arm_joints: usize,
    /// Period of the control, s.
    pub period_s: f64,
    /// Set-points in store.
    pub store: u32,
    /// Latency until it is measured, s.
    pub latency_s: f64,
}

/// Protocol of a robot control, and where it is reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RobotProtocolKind {
    /// Universal Robots RTDE: host and port of the control.
    Rtde {
        /// Host and port.
        address: String,
    },
    /// ABB EGM.
    Egm(Listening),
    /// KUKA RSI.
    Rsi(Listening),
}

/// Address at which a control's packets arrive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Listening {
    /// Our address and UDP port.
    pub on: SocketAddr,
    /// Address of the control; any if `None`.
    pub from: Option<IpAddr>,
}

impl RobotProtocolKind {
    /// Returns its name, which is also its key in the machine file.
    #[must_use]
    pub fn key(&self) -> &'static str {
        match self {
            Self::Rtde { .. } => "rtde",
            Self::Egm(_) => "egm",
            Self::Rsi(_) => "rsi",
        }
    }

    /// Returns the address of the control, or ours to which it sends.
    #[must_use]
    pub fn address(&self) -> String {
        match self {
            Self::Rtde { address } => address.clone(),
            Self::Egm(listening) | Self::Rsi(listening) => listening.on.to_string(),
        }
    }
}

type File = Document<MachineFile>;

pub(super) fn rtde(file: &File, axes: &[Axis], name: &str, device: &RtdeFile) -> Result<RobotDevice, DocumentError> {
    let at = format!("devices.{name}.rtde");
    let rate_hz = device.rate_hz.unwrap_or(500);
    if ![125, 500].contains(&rate_hz) {
        return Err(file.error_at(&format!("{at}.rate_hz"), Message::new("machine-out-of-range"), "125, 500"));
    }
    let joints = joints(file, axes, &at, device.axes.as_deref(), ARM, 0)?;
    Ok(RobotDevice {
        name: name.to_owned(),
        protocol: RobotProtocolKind::Rtde {
            address: super::register_check::address(file, &at, &device.address, RTDE_PORT)?,
        },
        axes: joints,
        arm_joints: ARM,
        period_s: 1.0 / f64::from(rate_hz),
        store: store(file, &at, device.store)?,
        latency_s: latency_s(file, &at, device.latency_ms, 34.0)?,
    })
}

pub(super) fn egm(file: &File, axes: &[Axis], name: &str, device: &EgmFile) -> Result<RobotDevice, DocumentError> {
    /// Period of EGM, s.
    const PERIOD_S: f64 = 0.004;
    let at = format!("devices.{name}.egm");
    let arm_joints = usize::from(device.joints.unwrap_or(6));
    if !(6..=7).contains(&arm_joints) {
        let allowed = Message::new("document-whole-number").text("min", "6").text("max", "7");
        return Err(file.error_at(&format!("{at}.joints"), Message::new("machine-out-of-range"), allowed));
    }
    Ok(RobotDevice {
        name: name.to_owned(),
        protocol: RobotProtocolKind::Egm(listening(file, &at, &device.listen, device.from.as_deref())?),
        axes: joints(file, axes, &at, device.axes.as_deref(), arm_joints, MAX_EXTERNAL)?,
        arm_joints,
        period_s: PERIOD_S,
        store: store(file, &at, device.store)?,
        latency_s: latency_s(file, &at, device.latency_ms, 20.0)?,
    })
}

pub(super) fn rsi(file: &File, axes: &[Axis], name: &str, device: &RsiFile) -> Result<RobotDevice, DocumentError> {
    let at = format!("devices.{name}.rsi");
    let cycle_ms = device.cycle_ms.unwrap_or(4);
    if ![4, 12].contains(&cycle_ms) {
        return Err(file.error_at(&format!("{at}.cycle_ms"), Message::new("machine-out-of-range"), "4, 12"));
    }
    Ok(RobotDevice {
        name: name.to_owned(),
        protocol: RobotProtocolKind::Rsi(listening(file, &at, &device.listen, device.from.as_deref())?),
        axes: joints(file, axes, &at, device.axes.as_deref(), ARM, MAX_EXTERNAL)?,
        arm_joints: ARM,
        period_s: 1e-3 * f64::from(cycle_ms),
        store: store(file, &at, device.store)?,
        latency_s: latency_s(file, &at, device.latency_ms, 12.0)?,
    })
}

/// Returns the machine's axes in the order of the control's joints: every axis once, the arm's joints rotary.
fn joints(
    file: &File,
    axes: &[Axis],
    at: &str,
    names: Option<&[String]>,
    arm: usize,
    external: usize,
) -> Result<Vec<usize>, DocumentError> {
    let key = if names.is_some() { format!("{at}.axes") } else { at.to_owned() };
    let joints = match names {
        None => (0..axes.len()).collect(),
        Some(names) => {
            let mut joints = Vec::with_capacity(names.len());
            for name in names {
                let Some(axis) = axes.iter().position(|axis| axis.name == *name) else {
                    let known: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
                    return Err(file.unknown_name(&key, name, &known));
                };
                if joints.contains(&axis) {
                    let message = Message::new("machine-robot-axis-twice").axis("axis", name);
                    return Err(file.error_at(&key, message, Message::new("machine-robot-axis-once")));
                }
                joints.push(axis);
            }
            joints
        }
    };
    if let Some(missing) = (0..axes.len()).find(|axis| !joints.contains(axis)) {
        let message = Message::new("machine-robot-axis-missing").axis("axis", &axes[missing].name);
        return Err(file.error_at(&key, message, Message::new("machine-robot-axis-once")));
    }
    if !(arm..=arm + external).contains(&joints.len()) {
        let message = Message::new("machine-robot-axis-count").count("n", joints.len());
        let allowed = Message::new("machine-robot-axis-count-allowed").count("arm", arm).count("external", external);
        return Err(file.error_at(&key, message, allowed));
    }
    let linear = joints[..arm].iter().find(|axis| axes[**axis].kind == AxisKind::Linear);
    if let Some(linear) = linear {
        let message = Message::new("machine-robot-axis-linear").axis("axis", &axes[*linear].name);
        return Err(file.error_at(&key, message, Message::new("machine-robot-axis-rotary").count("arm", arm)));
    }
    Ok(joints)
}

fn store(file: &File, at: &str, store: Option<u32>) -> Result<u32, DocumentError> {
    let period_s = 1e-3 * file.value.servo_period_ms.map_or(1.0, seamwright_document::Positive::get);
    let store = store.unwrap_or_else(|| ((STORE_S / period_s).round() as u32).clamp(2, 200));
    if (2..=200).contains(&store) {
        return Ok(store);
    }
    let allowed = Message::new("document-whole-number").text("min", "2").text("max", "200");
    Err(file.error_at(&format!("{at}.store"), Message::new("machine-out-of-range"), allowed))
}

fn latency_s(file: &File, at: &str, ms: Option<NonNegative>, usual_ms: f64) -> Result<f64, DocumentError> {
    let ms = ms.map_or(usual_ms, NonNegative::get);
    if ms <= MAX_LATENCY_MS {
        return Ok(1e-3 * ms);
    }
    let allowed = Message::new("document-between").value("min", 0.0, Unit::Ms).value("max", MAX_LATENCY_MS, Unit::Ms);
    Err(file.error_at(&format!("{at}.latency_ms"), Message::new("machine-out-of-range"), allowed))
}

fn listening(file: &File, at: &str, on: &str, from: Option<&str>) -> Result<Listening, DocumentError> {
    let bad =
        |key: &str, code, allowed| file.error_at(&format!("{at}.{key}"), Message::new(code), Message::new(allowed));
    let on: SocketAddr =
        on.parse().map_err(|_| bad("listen", "machine-robot-listen", "machine-robot-listen-allowed"))?;
    let from = from.map(str::parse::<IpAddr>).transpose();
    let from = from.map_err(|_| bad("from", "machine-robot-from", "machine-robot-from-allowed"))?;
    Ok(Listening { on, from })
}
