use super::Procedure;
use schemars::JsonSchema;
use seamwright_document::Positive;
use serde::{Deserialize, Serialize};

/// Comparison of current, voltage and wire feed with one another. A value that is off by more than `percent` is a
/// warning: it is more often a slip of the keyboard than a special arc.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Plausibility {
    /// Allowed deviation from the fits, %; 35 if missing.
    pub percent: Positive,
    /// Stick-out, mm: wire between contact tip and arc, of passes without one of their own; 15 if missing.
    pub stick_out_mm: Positive,
    /// Melting by the arc, mm/(A s), of solid steel wire of 1.2 mm; others melt with the inverse square of the diameter.
    pub melting_by_arc: Positive,
    /// Melting by the resistance of the stick-out, 1/(A^2 s), of that wire; others with the inverse fourth power.
    pub melting_by_resistance: Positive,
}

impl Default for Plausibility {
    fn default() -> Self {
        let positive = |value| Positive::new(value).unwrap_or(Positive::HALF);
        Self {
            percent: positive(35.0),
            stick_out_mm: positive(15.0),
            melting_by_arc: positive(0.3),
            melting_by_resistance: positive(5e-5),
        }
    }
}

/// Diameter of the wire to which the melting rates belong, mm.
const WIRE_MM: f64 = 1.2;

impl Plausibility {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// Wire feed at a current, m/min: the melting rate a I + b L I^2 of Lesnewich (Welding Journal 37, 1958, 343s and
    /// 418s), with the rates of steel wire scaled to the diameter.
    fn wire_feed_m_min(&self, current_a: f64, wire_mm: f64, stick_out_mm: f64) -> f64 {
        let thinner = WIRE_MM / wire_mm;
        let by_arc = self.melting_by_arc.get() * thinner.powi(2) * current_a;
        let by_resistance = self.melting_by_resistance.get() * thinner.powi(4) * stick_out_mm;
        0.06 * (by_arc + by_resistance * current_a.powi(2))
    }
}

/// A process value that should follow from the current, with the value that is usual for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Name of the process value.
    pub name: &'static str,
    /// The value by the fit.
    pub value: f64,
}

/// Maximum current of the conventional load voltages, A; beyond it they stay.
const MAX_CURRENT_A: f64 = 600.0;

impl Procedure {
    /// Values that are usual at a current: the voltage by the conventional load voltages of IEC 60974-1 (20 + 0.04 I of
    /// 111 and 121, 10 + 0.04 I of TIG, 14 + 0.05 I of MIG and MAG), and the wire feed of solid steel wire with this
    /// stick-out, or that of `[plausibility]`.
    pub fn expected(&self, current_a: f64, stick_out_mm: Option<f64>) -> Vec<Expected> {
        let line = match self.process.number {
            111 | 121 => Some((20.0, 0.04)),
            141 | 142 => Some((10.0, 0.04)),
            114 | 131 | 135 | 136 | 138 => Some((14.0, 0.05)),
            _ => None,
        };
        let volts = |(at_zero, per_a): (f64, f64)| at_zero + per_a * current_a.min(MAX_CURRENT_A);
        let voltage = line.map(|line| Expected { name: "voltage_v", value: volts(line) });
        let wire = self.wire_diameter_mm.filter(|_| [121, 135].contains(&self.process.number));
        let feed = wire.map(|wire| Expected {
            name: "wire_feed_m_min",
            value: self.plausibility.wire_feed_m_min(
                current_a,
                wire.get(),
                stick_out_mm.unwrap_or(self.plausibility.stick_out_mm.get()),
            ),
        });
        voltage.into_iter().chain(feed).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn procedure(process: u16, wire_mm: f64) -> Procedure {
        let text = format!(
            "schema = 1\nnumber = \"1\"\ntitle = \"t\"\nprocess = {process}\nwire_diameter_mm = {wire_mm}\n[[runs]]\npasses = \"1\"\n"
        );
        Procedure::read("p.toml", &text).unwrap().value
    }

    /// Middle of usual ranges in handbooks of makers: process, wire, current, voltage, wire feed.
    #[test]
    fn handbook_values_are_plausible() {
        let table = [
            (135, 1.0, 135.0, 18.0, 5.0),
            (135, 1.2, 155.0, 19.5, 4.0),
            (135, 1.2, 270.0, 28.5, 8.5),
            (135, 1.6, 350.0, 30.5, 6.0),
            (121, 3.2, 450.0, 28.0, 1.6),
            (121, 4.0, 600.0, 30.0, 1.3),
        ];
        for (process, wire, current, volts, feed) in table {
            let procedure = procedure(process, wire);
            for expected in procedure.expected(current, None) {
                let found = if expected.name == "voltage_v" { volts } else { feed };
                let off = 100.0 * (found / expected.value - 1.0).abs();
                assert!(off < procedure.plausibility.percent.get(), "{process} {wire} {current} {expected:?} {off}");
            }
        }
    }

    /// 1.2 mm at 200 A and 15 mm: (0.3 * 200 + 5e-5 * 15 * 200^2) mm/s = 90 mm/s.
    #[test]
    fn wire_melts_with_current_and_its_square() {
        let expected = procedure(135, 1.2).expected(200.0, None);
        let feed = expected.iter().find(|e| e.name == "wire_feed_m_min").unwrap();
        assert!((feed.value - 5.4).abs() < 1e-9);
        assert!((expected[0].value - 24.0).abs() < 1e-9);
        assert!(procedure(51, 1.2).expected(200.0, None).is_empty());
    }
}
