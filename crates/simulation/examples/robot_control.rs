//! A simulated robot control on a socket, to try a cell without a robot.
//!
//! Usage: robot_control rtde HOST:PORT, or robot_control egm|rsi HOST:PORT of the cell; then SECONDS and the positions
//! of the joints in degrees. Runs for that time, and prints where the joints are, once a second.

use seamwright_simulation::robot::{
    ControlServer, EgmControl, JointPositions, MAX_JOINTS, RsiControl, RtdeControl, Servo,
};
use std::time::Duration;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match start(&arguments) {
        Ok((server, seconds)) => {
            for _ in 0..seconds {
                std::thread::sleep(Duration::from_secs(1));
                println!("{:.4?} follows {}", &server.positions()[..6], server.follows());
            }
        }
        Err(why) => {
            eprintln!("{why}\nusage: robot_control rtde|egm|rsi HOST:PORT SECONDS [DEGREES...]");
            std::process::exit(2);
        }
    }
}

fn start(arguments: &[String]) -> Result<(ControlServer, u64), String> {
    let [protocol, address, seconds, angles @ ..] = arguments else { return Err("arguments are missing".to_owned()) };
    let seconds = seconds.parse().map_err(|e| format!("{seconds}: {e}"))?;
    let mut degrees: JointPositions = [0.0; MAX_JOINTS];
    for (joint, angle) in degrees.iter_mut().zip(angles) {
        *joint = angle.parse().map_err(|e| format!("{angle}: {e}"))?;
    }
    let external = angles.len().saturating_sub(6).min(MAX_JOINTS - 6);
    let to = || address.parse().map_err(|e| format!("{address}: {e}"));
    let servo = Servo { delay_s: 0.008, lag_s: 0.01 };
    let server = match protocol.as_str() {
        "rtde" => {
            let control = RtdeControl::new(500.0, Servo::UNIVERSAL_ROBOTS, degrees.map(f64::to_radians));
            ControlServer::tcp(control, address)
        }
        "egm" => ControlServer::udp(EgmControl::new(6, external, servo, degrees), to()?),
        "rsi" => ControlServer::udp(RsiControl::new(external, 0.004, servo, degrees), to()?),
        other => return Err(format!("{other}: unknown protocol")),
    };
    Ok((server.map_err(|e| format!("{address}: {e}"))?, seconds))
}
