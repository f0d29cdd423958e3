use schemars::JsonSchema;
use seamwright_document::NonNegative;
use serde::Deserialize;

/// The drives by a Universal Robots control, over RTDE.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RtdeFile {
    /// Host and port of the control, like `192.168.1.10`; port 30004 if missing.
    pub address: String,
    /// Axes of this machine in the order of the arm's joints; all axes in the order of the file if missing.
    pub axes: Option<Vec<String>>,
    /// Rate of the control's reports and set-points, Hz: 500, or 125 of a CB3; 500 if missing.
    pub rate_hz: Option<u32>,
    /// Set-points in store here, 2 to 200; those of 10 ms if missing, at least 2. So many periods late is a correction,
    /// and so many cycles may be missed.
    pub store: Option<u32>,
    /// Time from a set-point until a report shows it, ms, 0 to 200, until it is measured; 34 if missing.
    pub latency_ms: Option<NonNegative>,
}

/// The drives by an ABB control, over Externally Guided Motion (EGM).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EgmFile {
    /// Address and UDP port here to which the control sends, like `0.0.0.0:6510`.
    pub listen: String,
    /// IP address of the control, like `192.168.125.1`: packets of others are refused. Any if missing.
    pub from: Option<String>,
    /// Axes of this machine in the order of the arm's joints and then of the external joints; all axes in the order of
    /// the file if missing.
    pub axes: Option<Vec<String>>,
    /// Number of joints of the arm, 6 or 7; 6 if missing. The other axes are external joints.
    pub joints: Option<u8>,
    /// Set-points in store here, 2 to 200; those of 10 ms if missing, at least 2. So many periods late is a correction,
    /// and so many cycles may be missed.
    pub store: Option<u32>,
    /// Time from a set-point until a report shows it, ms, 0 to 200, until it is measured; 20 if missing.
    pub latency_ms: Option<NonNegative>,
}

/// The drives by a KUKA control, over the RobotSensorInterface (RSI).
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RsiFile {
    /// Address and UDP port here to which the control sends, like `0.0.0.0:49152`.
    pub listen: String,
    /// IP address of the control, like `172.31.1.147`: packets of others are refused. Any if missing.
    pub from: Option<String>,
    /// Axes of this machine in the order A1 to A6, and then E1 to E6; all axes in the order of the file if missing.
    pub axes: Option<Vec<String>>,
    /// Period of the control, ms: 4 (`IPO_FAST`) or 12; 4 if missing.
    pub cycle_ms: Option<u32>,
    /// Set-points in store here, 2 to 200; those of 10 ms if missing, at least 2. So many periods late is a correction,
    /// and so many cycles may be missed.
    pub store: Option<u32>,
    /// Time from a set-point until a report shows it, ms, 0 to 200, until it is measured; 12 if missing.
    pub latency_ms: Option<NonNegative>,
}
