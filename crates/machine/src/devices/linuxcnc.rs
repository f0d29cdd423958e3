use super::file::LinuxCncFile;
use crate::file::MachineFile;
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};

/// The drives by LinuxCNC's HAL.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinuxCnc {
    /// HAL file of the hardware, beside the machine file.
    pub hal: Option<String>,
    /// Set-points in store.
    pub store: u32,
    /// Period of the faster thread, us.
    pub base_period_us: Option<u32>,
}

/// Default number of set-points in store.
const STORE: u32 = 10;
/// Maximum length of an axis' name: HAL's names have up to 47 characters.
const LONGEST_NAME: usize = 24;

pub(super) fn linuxcnc(
    file: &Document<MachineFile>,
    name: &str,
    device: &LinuxCncFile,
) -> Result<LinuxCnc, DocumentError> {
    let at = |key: &str| format!("devices.{name}.linuxcnc.{key}");
    let m = &file.value;
    if let Some(hal) = device.hal.as_ref().filter(|hal| !hal.ends_with(".hal") || hal.len() == 4) {
        let message = Message::new("machine-hal-file").text("file", hal);
        return Err(file.error_at(&at("hal"), message, Message::new("machine-hal-file-allowed")));
    }
    let store = device.store.unwrap_or(STORE);
    if !(2..=200).contains(&store) {
        let allowed = Message::new("document-whole-number").text("min", "2").text("max", "200");
        return Err(file.error_at(&at("store"), Message::new("machine-out-of-range"), allowed));
    }
    let period_us = 1e3 * m.servo_period_ms.map_or(1.0, seamwright_document::Positive::get);
    if let Some(base) = device.base_period_us {
        let times = period_us / f64::from(base);
        if !(10..=1000).contains(&base) || times < 2.0 || (times - times.round()).abs() > 1e-9 {
            let message = Message::new("machine-base-period").value("base", f64::from(base), Unit::Us);
            let allowed = Message::new("machine-base-period-allowed").value("period", period_us, Unit::Us);
            return Err(file.error_at(&at("base_period_us"), message, allowed));
        }
    }
    let axes =
        m.tool.iter().chain(&m.work).chain(m.heads.iter().flat_map(|h| &h.steps)).filter_map(|s| s.axis.as_ref());
    if let Some(axis) = axes.into_iter().find(|axis| axis.len() > LONGEST_NAME) {
        let message = Message::new("machine-axis-name-long").axis("axis", axis);
        let allowed = Message::new("machine-name-length").text("max", LONGEST_NAME.to_string());
        return Err(file.error_at(&format!("devices.{name}.linuxcnc"), message, allowed));
    }
    Ok(LinuxCnc { hal: device.hal.clone(), store, base_period_us: device.base_period_us })
}
