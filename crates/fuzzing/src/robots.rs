//! Messages of robot controls.

use crate::target::{Target, USUAL};
use seamwright_executive::devices::robot::{Egm, RobotProtocol, Rsi, Rtde};
use seamwright_machine::MAX_AXES;
use seamwright_simulation::robot::{EgmControl, MAX_JOINTS, RsiControl, RtdeControl, Servo, SimulatedControl};

const SERVO: Servo = Servo { delay_s: 0.0, lag_s: 0.01 };

/// The stream of a Universal Robots control.
pub const RTDE: Target = Target {
    name: "rtde",
    read: |bytes| read(&mut Rtde::new(500.0), bytes, 7),
    seeds: || {
        let (mut control, mut client) = (RtdeControl::new(500.0, SERVO, [0.1; MAX_JOINTS]), Rtde::new(500.0));
        let (mut all, mut requests) = (Vec::new(), Vec::new());
        client.begin(&mut requests);
        for period in 0..8 {
            let t_s = 0.002 * f64::from(period);
            let mut messages = Vec::new();
            control.take(&std::mem::take(&mut requests), t_s, &mut messages);
            control.tick(t_s, &mut messages);
            for message in messages {
                all.extend_from_slice(&message);
                // Messages of a control are accepted.
                let _ = client.feed(&message);
                while let Ok(Some(_)) = client.next(&mut requests) {}
            }
        }
        vec![all]
    },
    words: || {
        ["NOT_FOUND", "IN_USE", "DOUBLE", "VECTOR6D", "VECTOR6INT32", "INT32", "UINT32"].map(str::to_owned).to_vec()
    },
    is_text: false,
    ..USUAL
};

/// A datagram of an ABB control.
pub const EGM: Target = Target {
    name: "egm",
    read: |bytes| read(&mut Egm::new(6, 8, [false; MAX_AXES]), bytes, usize::MAX),
    seeds: || one_report(&mut EgmControl::new(6, 2, SERVO, [10.0; MAX_JOINTS])),
    is_text: false,
    ..USUAL
};

/// A datagram of a KUKA control.
pub const RSI: Target = Target {
    name: "rsi",
    read: |bytes| read(&mut Rsi::new(8, [false; MAX_AXES]), bytes, usize::MAX),
    seeds: || one_report(&mut RsiControl::new(2, 0.004, SERVO, [10.0; MAX_JOINTS])),
    words: || ["<AIPos A1=\"", "<EIPos E1=\"", "<IPOC>", "</IPOC>"].map(str::to_owned).to_vec(),
    ..USUAL
};

fn one_report(control: &mut dyn SimulatedControl) -> Vec<Vec<u8>> {
    let mut messages = Vec::new();
    control.tick(0.0, &mut messages);
    messages
}

/// Reads `bytes` in parts of this length, as the client of a control does.
fn read(protocol: &mut dyn RobotProtocol, bytes: &[u8], part: usize) {
    let mut out = Vec::new();
    protocol.begin(&mut out);
    for part in bytes.chunks(part.min(bytes.len().max(1))) {
        if protocol.feed(part).is_err() {
            return;
        }
        loop {
            match protocol.next(&mut out) {
                Ok(Some(report)) => assert!(report.clock_s.is_finite()),
                Ok(None) => break,
                Err(_) => return,
            }
        }
    }
}
