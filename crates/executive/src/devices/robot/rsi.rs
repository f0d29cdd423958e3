//! KUKA's RobotSensorInterface (RSI), corrections of axes over Ethernet.
//!
//! Source: KUKA, "KUKA.RobotSensorInterface 4.1" (manual), for the objects `ETHERNET` and `AXISCORR` and for the
//! messages. The control sends a datagram every 4 or 12 ms and needs the answer, with its `IPOC`, before the next one.
//! `AK` and `EK` are corrections from the positions at which RSI was started, in degrees or mm. When answers are late or
//! missing too often, RSI ends with an error and the arm stops.

use super::protocol::{Datagram, ProtocolError, RobotOrder, RobotProtocol, RobotReport, RobotState};
use seamwright_machine::{Joints, MAX_AXES};
use std::io::Write as _;

/// The configuration of the control, and its program in KRL.
pub const KRL: &str = include_str!("programs/kuka.txt");

/// Joints of the arm.
const ARM: usize = 6;
/// Maximum time from report to report within a session, ms.
const MAX_GAP_MS: u64 = 1000;

/// RSI as the sensor of a control.
#[derive(Debug)]
pub struct Rsi {
    joints: usize,
    linear: [bool; MAX_AXES],
    datagram: Datagram,
    /// Time of the last report, ms, which the answer repeats.
    ipoc: Option<u64>,
    /// Positions at the start of the session, degrees or mm.
    start: Joints,
}

impl Rsi {
    /// Creates it for `joints` joints, at least the six of the arm; `linear` marks those in mm.
    #[must_use]
    pub fn new(joints: usize, linear: [bool; MAX_AXES]) -> Self {
        Self { joints, linear, datagram: Datagram::default(), ipoc: None, start: [0.0; MAX_AXES] }
    }

    fn report(&mut self, bytes: &[u8]) -> Result<Option<RobotReport>, ProtocolError> {
        let text = std::str::from_utf8(bytes).map_err(|_| ProtocolError::Malformed)?;
        let ipoc = content(text, "IPOC").and_then(|ipoc| ipoc.trim().parse().ok()).ok_or(ProtocolError::Malformed)?;
        let last = self.ipoc.replace(ipoc);
        let continues = last.is_some_and(|last| ipoc.abs_diff(last) <= MAX_GAP_MS);
        if continues && last.is_some_and(|last| ipoc <= last) {
            // Overtaken or doubled: it has been answered.
            self.ipoc = last;
            return Ok(None);
        }
        let mut reported = [0.0; MAX_AXES];
        for (joint, position) in reported[..self.joints].iter_mut().enumerate() {
            let (element, name) = if joint < ARM { ("AIPos", "A") } else { ("EIPos", "E") };
            let number = joint % ARM + 1;
            let found = attribute(text, element, name, number).and_then(|value| value.parse::<f64>().ok());
            let found = found.filter(|value| value.is_finite());
            *position = found.ok_or(ProtocolError::Joints { reported: joint, needed: self.joints })?;
        }
        if !continues {
            self.start = reported;
        }
        let joints = std::array::from_fn(|i| if self.linear[i] { reported[i] } else { reported[i].to_radians() });
        let begins = last.is_some() && !continues;
        let clock_s = 1e-3 * ipoc as f64;
        Ok(Some(RobotReport { clock_s, joints, state: RobotState::Follows, fault: 0, begins }))
    }
}

/// Returns the text of an element.
fn content<'a>(text: &'a str, element: &str) -> Option<&'a str> {
    let mut rest = text;
    loop {
        let (_, after) = rest.split_once('<')?;
        rest = after;
        let inner = after.strip_prefix(element).and_then(|after| after.strip_prefix('>'));
        if let Some(inner) = inner {
            return inner.split_once('<').map(|(content, _)| content);
        }
    }
}

/// Returns the attribute `name` with `number`, as `A1`, of the first `element`.
fn attribute<'a>(text: &'a str, element: &str, name: &str, number: usize) -> Option<&'a str> {
    let mut rest = text;
    let tag = loop {
        let (_, after) = rest.split_once('<')?;
        rest = after;
        let tag = after.strip_prefix(element).filter(|tag| tag.starts_with(|c: char| c.is_ascii_whitespace()));
        if let Some(tag) = tag {
            break tag.split_once('>')?.0;
        }
    };
    let mut rest = tag;
    loop {
        let (before, after) = rest.split_once('=')?;
        let quoted = after.trim_start().strip_prefix('"')?;
        let (value, next) = quoted.split_once('"')?;
        let digits = before.trim().strip_prefix(name);
        if digits.is_some_and(|digits| digits.parse() == Ok(number)) {
            return Some(value.trim());
        }
        rest = next;
    }
}

impl RobotProtocol for Rsi {
    fn begin(&mut self, _out: &mut Vec<u8>) {
        self.datagram.clear();
        self.ipoc = None;
    }

    fn feed(&mut self, bytes: &[u8]) -> Result<(), ProtocolError> {
        self.datagram.put(bytes);
        Ok(())
    }

    fn next(&mut self, _out: &mut Vec<u8>) -> Result<Option<RobotReport>, ProtocolError> {
        self.datagram.take().map_or(Ok(None), |datagram| self.report(&datagram))
    }

    fn order(&mut self, order: &RobotOrder, out: &mut Vec<u8>) {
        let Some(ipoc) = self.ipoc else { return };
        let correction = |joint: usize| {
            let position = order.joints[joint];
            let position = if self.linear[joint] { position } else { position.to_degrees() };
            position - self.start[joint]
        };
        // Writing to memory does not fail.
        let _ = write!(out, "<Sen Type=\"ImFree\"><AK");
        for joint in 0..ARM {
            let _ = write!(out, " A{}=\"{:.6}\"", joint + 1, correction(joint));
        }
        let _ = write!(out, "/>");
        if self.joints > ARM {
            let _ = write!(out, "<EK");
            for joint in ARM..self.joints {
                let _ = write!(out, " E{}=\"{:.6}\"", joint - ARM + 1, correction(joint));
            }
            let _ = write!(out, "/>");
        }
        let _ = write!(out, "<IPOC>{ipoc}</IPOC></Sen>");
    }

    fn holds_last(&self) -> bool {
        true
    }
}
