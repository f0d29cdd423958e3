//! Lines of the streams.

use crate::executive::Orders;
use crate::realtime::SteadyTime;
use seamwright_machine::{Axis, Joints, MAX_AXES};
use std::io::Write as _;

/// Maximum line length: numbers have up to 25 characters.
pub(super) const LONGEST: usize = 512;

/// Writes the set-points of all axes in `halstreamer`'s form: number, power, home, watchdog, positions in mm and
/// degrees.
///
/// Neither allocates nor fails: every line is shorter than the maximum.
pub(super) fn write<'a>(
    buffer: &'a mut [u8; LONGEST],
    axes: &[Axis],
    number: u32,
    orders: &Orders,
    positions: &[f64; MAX_AXES],
) -> &'a [u8] {
    let bit = u8::from;
    let mut rest = &mut buffer[..];
    let (power, home, alive) = (bit(orders.power), bit(orders.home), bit(orders.watchdog.toggle));
    let mut written = write!(rest, "{number} {power} {home} {alive}").is_ok();
    for (axis, position) in axes.iter().zip(positions) {
        // Exponents keep every number short.
        written &= write!(rest, " {:e}", axis.to_file(*position)).is_ok();
    }
    written &= rest.write_all(b"\n").is_ok();
    let left = rest.len();
    // Discard a truncated line.
    if written { &buffer[..LONGEST - left] } else { &[] }
}

/// HAL's state in a period, as `halsampler` reports it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time of reading.
    pub read: SteadyTime,
    /// Number of the active set-point.
    pub number: u32,
    /// Number of periods without a set-point.
    pub underruns: u32,
    /// Stored set-points after it.
    pub level: u32,
    /// The drives have power.
    pub powered: bool,
    /// Axes with a fault, one bit each.
    pub fault: u16,
    /// Axes on a limit switch.
    pub limit: u16,
    /// Axes with a known reference.
    pub homed: u16,
    /// Measured positions, mm and rad.
    pub position: Joints,
}

/// Parses a line; `None` if it is not a sample.
pub(super) fn read(text: &str, axes: &[Axis], read: SteadyTime) -> Option<Sample> {
    let mut words = text.split_ascii_whitespace();
    let number = words.next()?.parse().ok()?;
    // HAL's count is signed.
    let underruns = words.next()?.parse::<i32>().ok()? as u32;
    let level = words.next()?.parse::<i32>().ok()?.max(0) as u32;
    let powered = words.next()? == "1";
    let [fault, limit, homed] = [(); 3].map(|()| words.next().and_then(|word| word.parse::<u16>().ok()));
    let mut position = Joints::default();
    for (position, axis) in position.iter_mut().zip(axes) {
        *position = axis.from_file(words.next()?.parse().ok()?);
    }
    words.next().is_none().then_some(())?;
    Some(Sample { read, number, underruns, level, powered, fault: fault?, limit: limit?, homed: homed?, position })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::executive::Watchdog;
    use seamwright_machine::{Machine, shipped};
    use seamwright_servo::SetPoint;

    #[test]
    fn a_line_comes_back() {
        let machine = Machine::read("m.toml", shipped("dual-laser-10axis").unwrap().text).unwrap();
        let mut state = 9u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for k in 0..2000u32 {
            let mut positions = Joints::default();
            let size = 10f64.powi((k % 600) as i32 - 300);
            positions.iter_mut().for_each(|q| *q = next() * size);
            let watchdog = Watchdog { toggle: k % 5 == 0, late: false };
            let orders = Orders { power: k % 2 == 0, home: k % 3 == 0, watchdog, ..Orders::default() };
            let orders = Orders { set: [SetPoint::default(); MAX_AXES], ..orders };
            let mut buffer = [0; LONGEST];
            let line = write(&mut buffer, &machine.axes, k.wrapping_mul(4_000_037), &orders, &positions);
            let line = std::str::from_utf8(line).unwrap();
            let words: Vec<&str> = line.trim_end().split(' ').collect();
            assert!(line.ends_with('\n') && words.len() == 4 + machine.axes.len(), "{line}");
            let flags = [orders.power, orders.home, watchdog.toggle].map(|yes| if yes { "1" } else { "0" });
            assert!(words[0] == k.wrapping_mul(4_000_037).to_string() && words[1..4] == flags, "{line}");
            for ((word, axis), q) in words[4..].iter().zip(&machine.axes).zip(&positions) {
                assert!((word.parse::<f64>().unwrap() - axis.to_file(*q)).abs() <= 0.0, "{word} {q}");
            }
        }
    }

    #[test]
    fn samples_are_read() {
        let machine = Machine::read("m.toml", shipped("ellipse-xy").unwrap().text).unwrap();
        let now = SteadyTime::now();
        let sample = read("17 3 9 1 0 2 3 1.250000 -7.000000 ", &machine.axes, now).unwrap();
        assert_eq!((sample.number, sample.underruns, sample.level, sample.powered), (17, 3, 9, true));
        assert_eq!((sample.fault, sample.limit, sample.homed), (0, 2, 3));
        assert_eq!(sample.position[..2], [1.25, -7.0]);
        for bad in ["overrun", "", "17 3 9 1 0 2 3 1.25", "17 3 9 1 0 2 3 1.25 7 8", "17 3 9 1 0 -2 3 1.25 7"] {
            assert_eq!(read(bad, &machine.axes, now), None, "{bad}");
        }
    }
}
