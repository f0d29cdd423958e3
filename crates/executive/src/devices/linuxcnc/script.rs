//! HAL commands: the streams in and out, the watchdog, and axes without hardware.

use seamwright_machine::{LinuxCnc, Machine};
use std::fmt::Write as _;

/// Columns of the stream of set-points before those of the axes: number, power, home, watchdog.
const ORDERS: usize = 4;
/// Columns of the stream of reports before those of the axes.
const REPORTS: usize = 7;
/// Capacity of the sampler, samples; later ones are lost.
const SAMPLES: usize = 4000;
/// Periods without a set-point, after the stored ones, until HAL switches the power off.
pub(super) const WATCHED: u32 = 20;

/// Commands before those of the hardware: one or two threads, the streams, the watchdog, the signal names.
pub(super) fn before(machine: &Machine, device: &LinuxCnc, owner: &str) -> String {
    let n = machine.axes.len();
    let period_ns = (machine.servo_period_s * 1e9).round() as u64;
    // Its own reader sleeps for 10 ms on a full queue: keep spare room.
    let room = 2 * device.store + 100;
    let watched_s = f64::from(device.store + WATCHED) * machine.servo_period_s;
    let base = device.base_period_us.map(|us| format!("name1=cell-base period1={} fp1=0 ", 1000 * us));
    let cell = if base.is_some() { 2 } else { 1 };
    let floats = "f".repeat(n);
    let mut hal = format!(
        "loadrt threads {}name{cell}=cell period{cell}={period_ns}\n\
         loadrt streamer depth={room} cfg=ubbb{floats}\n\
         loadrt sampler depth={SAMPLES} cfg=ussbsss{floats}\n\
         loadrt weighted_sum wsum_sizes={n},{n},{n}\n\
         loadrt watchdog num_inputs=1\n\
         loadrt lut5 names=seamwright.gate\n\
         setp seamwright.gate.function 0x8\n\
         setp watchdog.timeout-0 {watched_s}\n\
         newsig {owner} bit\n\
         net seamwright.number streamer.0.pin.0 => sampler.0.pin.0\n\
         net seamwright.power streamer.0.pin.1 => watchdog.enable-in seamwright.gate.in-0\n\
         net seamwright.home streamer.0.pin.2\n\
         net seamwright.alive streamer.0.pin.3 => watchdog.input-0\n\
         net seamwright.fed watchdog.ok-out => seamwright.gate.in-1\n\
         net seamwright.enable seamwright.gate.out\n\
         net seamwright.underruns streamer.0.underruns => sampler.0.pin.1\n\
         net seamwright.level streamer.0.curr-depth => sampler.0.pin.2\n\
         net seamwright.powered sampler.0.pin.3\n",
        base.unwrap_or_default()
    );
    for (k, name) in ["faults", "limits", "homes"].into_iter().enumerate() {
        let pin = 4 + k;
        let _ = writeln!(hal, "net seamwright.{name} wsum.{k}.sum => sampler.0.pin.{pin}");
    }
    for (i, axis) in machine.axes.iter().enumerate() {
        let (name, set, position) = (&axis.name, ORDERS + i, REPORTS + i);
        let _ = write!(
            hal,
            "net seamwright.{name}.set streamer.0.pin.{set}\n\
             net seamwright.{name}.position sampler.0.pin.{position}\n\
             net seamwright.{name}.fault wsum.0.bit.{i}.in\n\
             net seamwright.{name}.limit wsum.1.bit.{i}.in\n\
             net seamwright.{name}.homed wsum.2.bit.{i}.in\n"
        );
    }
    // The watchdog's own output stays on without its enable, so the gate checks both; `lut5` because few others load
    // it.
    hal += "addf streamer.0 cell\naddf watchdog.process cell\naddf watchdog.set-timeouts cell\naddf seamwright.gate cell\n";
    hal
}

/// Axes without hardware: with power they follow at once, without power they stay. During homing they are at their home
/// positions.
pub(super) fn simulated(machine: &Machine) -> String {
    let names = |kind: &str| {
        let names: Vec<String> = machine.axes.iter().map(|a| format!("simulated.{}{kind}", a.name)).collect();
        names.join(",")
    };
    let mut hal = format!(
        "loadrt mux4 names={}\nloadrt flipflop names={}\nloadrt and2 names=simulated.power,simulated.homes\n\
         setp simulated.power.in1 1\n\
         net seamwright.enable => simulated.power.in0 simulated.homes.in0\n\
         net seamwright.home => simulated.homes.in1\n\
         net seamwright.powered simulated.power.out\n\
         net simulated.homing simulated.homes.out\n\
         addf simulated.power cell\naddf simulated.homes cell\n",
        names(""),
        names(".reference")
    );
    let home = machine.home();
    for (axis, home) in machine.axes.iter().zip(home) {
        let (name, home) = (&axis.name, axis.to_file(home));
        let _ = write!(
            hal,
            "setp simulated.{name}.in3 {home:.9}\n\
             net seamwright.enable => simulated.{name}.sel0\n\
             net simulated.homing => simulated.{name}.sel1 simulated.{name}.reference.set\n\
             net seamwright.{name}.set => simulated.{name}.in1\n\
             net seamwright.{name}.position simulated.{name}.out => simulated.{name}.in0\n\
             net seamwright.{name}.homed simulated.{name}.reference.out\n\
             addf simulated.{name} cell\naddf simulated.{name}.reference cell\n"
        );
    }
    hal
}

/// Commands after those of the hardware.
pub(super) const AFTER: &str = "addf process_wsums cell\naddf sampler.0 cell\nstart\n";

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::SHIPPED;

    /// Every pin is connected once, and HAL's names are within the length limit.
    #[test]
    fn every_pin_is_connected_once() {
        for shipped in SHIPPED {
            let text = format!("{}\n[devices.drives.linuxcnc]\nbase_period_us = 50", shipped.text);
            let machine = Machine::read("m.toml", &text).unwrap();
            let device = machine.devices.linuxcnc.clone().unwrap();
            let hal = before(&machine, &device, "seamwright.pid.1") + &simulated(&machine) + AFTER;
            let mut pins: Vec<&str> = Vec::new();
            for line in hal.lines().filter(|line| line.starts_with("net ")) {
                for word in line.split_whitespace().skip(2).filter(|word| *word != "=>") {
                    assert!(!pins.contains(&word), "{word} twice");
                    pins.push(word);
                }
            }
            assert!(hal.split_whitespace().filter(|word| !word.contains('=')).all(|word| word.len() <= 47));
            let streamed =
                (0..ORDERS + machine.axes.len()).all(|i| pins.contains(&format!("streamer.0.pin.{i}").as_str()));
            let sampled =
                (0..REPORTS + machine.axes.len()).all(|i| pins.contains(&format!("sampler.0.pin.{i}").as_str()));
            assert!(streamed && sampled, "{hal}");
            let period = (1e9 * machine.servo_period_s).round();
            let threads = format!("name1=cell-base period1=50000 fp1=0 name2=cell period2={period}");
            assert!(hal.contains(&threads), "{hal}");
        }
    }
}
