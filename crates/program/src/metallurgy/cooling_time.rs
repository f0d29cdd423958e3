use schemars::JsonSchema;
use seamwright_document::Positive;
use seamwright_message::named_enum;
use serde::{Deserialize, Serialize};

named_enum! {
    /// Direction in which heat flows from the weld.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum HeatFlow {
        /// Into the plate only: it is heated through.
        TwoDimensional => "2D", "program-heat-flow-2d";
        /// Into the plate and down into it: a thick plate.
        ThreeDimensional => "3D", "program-heat-flow-3d";
    }
}

/// Shape factors of a weld for its cooling time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShapeFactors {
    /// F2: where the heat flows into the plate only.
    pub two_dimensional: Positive,
    /// F3: where it also flows down into a thick plate.
    pub three_dimensional: Positive,
}

/// Conditions of cooling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoolingTime {
    /// Heat input, kJ/mm.
    pub heat_input_kj_mm: f64,
    /// Temperature of the work before the pass, degrees Celsius; below 500.
    pub work_c: f64,
    /// Thickness of the plate, mm.
    pub thickness_mm: f64,
    /// Shape factors F2 and F3.
    pub factors: (f64, f64),
}

impl CoolingTime {
    /// Time in which the weld cools from 800 to 500 degrees Celsius, s, and the flow of heat, by EN 1011-2 (annex D): the
    /// longer of the times for two- and for three-dimensional flow, which are equal at the transition thickness.
    pub fn t85_s(&self) -> (f64, HeatFlow) {
        let (plate, thick) = (self.two_dimensional_s(), self.three_dimensional_s());
        if plate > thick { (plate, HeatFlow::TwoDimensional) } else { (thick, HeatFlow::ThreeDimensional) }
    }

    /// (4300 - 4.3 T0) 1e5 Q^2/d^2 (1/(500 - T0)^2 - 1/(800 - T0)^2) F2.
    fn two_dimensional_s(&self) -> f64 {
        let (at_500, at_800) = self.reciprocals();
        let per_thickness = self.heat_input_kj_mm / self.thickness_mm;
        (4300.0 - 4.3 * self.work_c) * 1e5 * per_thickness.powi(2) * (at_500.powi(2) - at_800.powi(2)) * self.factors.0
    }

    /// (6700 - 5 T0) Q (1/(500 - T0) - 1/(800 - T0)) F3.
    fn three_dimensional_s(&self) -> f64 {
        let (at_500, at_800) = self.reciprocals();
        (6700.0 - 5.0 * self.work_c) * self.heat_input_kj_mm * (at_500 - at_800) * self.factors.1
    }

    fn reciprocals(&self) -> (f64, f64) {
        (1.0 / (500.0 - self.work_c), 1.0 / (800.0 - self.work_c))
    }

    /// Thickness at which both flows give the same time, mm; thicker plates have three-dimensional flow.
    pub fn transition_thickness_mm(&self) -> f64 {
        self.thickness_mm * (self.two_dimensional_s() / self.three_dimensional_s()).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    fn on_plate(heat_input_kj_mm: f64, work_c: f64, thickness_mm: f64) -> CoolingTime {
        CoolingTime { heat_input_kj_mm, work_c, thickness_mm, factors: (1.0, 1.0) }
    }

    /// By hand with formula 3.2 of the SSAB Welding Handbook (edition 2), which is that of EN 1011-2: at 20 degrees
    /// 6600 Q (1/480 - 1/780) = 5.288 Q, at 150 degrees 5950 Q (1/350 - 1/650) = 7.846 Q.
    #[test]
    fn thick_plates_cool_as_in_the_handbook() {
        for (heat, work_c, seconds) in [(1.0, 20.0, 5.288), (2.0, 20.0, 10.577), (2.0, 150.0, 15.692)] {
            let (time, flow) = on_plate(heat, work_c, 200.0).t85_s();
            assert!((time - seconds).abs() < 1e-3, "{heat} {work_c}: {time}");
            assert_eq!(flow, HeatFlow::ThreeDimensional);
        }
    }

    /// By hand: 1 kJ/mm into 10 mm at 20 degrees: (4300 - 86) 1e5 (1/100) (1/480^2 - 1/780^2) = 11.36 s.
    #[test]
    fn thin_plates_are_heated_through() {
        let (time, flow) = on_plate(1.0, 20.0, 10.0).t85_s();
        assert!((time - 11.363).abs() < 0.01, "{time}");
        assert_eq!(flow, HeatFlow::TwoDimensional);
    }

    #[test]
    fn both_flows_meet_at_the_transition_thickness() {
        let mut random = Random::new(8);
        for _ in 0..5000 {
            let (f2, f3) = (random.within(0.45, 1.0), random.within(0.6, 1.0));
            let mut weld = on_plate(random.within(0.2, 5.0), random.within(-10.0, 300.0), random.within(2.0, 100.0));
            weld.factors = (f2, f3);
            weld.thickness_mm = weld.transition_thickness_mm();
            let at = weld.t85_s().0;
            let around = [0.999, 1.001].map(|part| CoolingTime { thickness_mm: part * weld.thickness_mm, ..weld });
            assert_eq!(around[0].t85_s().1, HeatFlow::TwoDimensional);
            assert_eq!(around[1].t85_s().1, HeatFlow::ThreeDimensional);
            assert!(around.iter().all(|near| (near.t85_s().0 / at - 1.0).abs() < 3e-3));
        }
    }

    /// The temperature on the line of an instantaneous source of heat Q: the standard's formulas follow from it, with the
    /// properties of steel as linear functions of the work's temperature. Cooling time from the analytic temperature,
    /// found by bisection, must be proportional alike.
    #[test]
    fn cooling_follows_the_conduction_of_heat() {
        let time_at = |above: f64, thick: bool, q: f64, d: f64| {
            // Rosenthal: T - T0 = q/(2 pi k t), or q/(d sqrt(4 pi k c t)); steel: k = 0.03 W/(mm K), c = 0.005 J/(mm^3 K).
            let at = |t: f64| match thick {
                true => 1000.0 * q / (2.0 * std::f64::consts::PI * 0.03 * t),
                false => 1000.0 * q / (d * (4.0 * std::f64::consts::PI * 0.03 * 0.005 * t).sqrt()),
            };
            let (mut low, mut high) = (1e-6, 1e6);
            for _ in 0..200 {
                let middle = f64::sqrt(low * high);
                if at(middle) > above { low = middle } else { high = middle }
            }
            low
        };
        let mut random = Random::new(5);
        for _ in 0..200 {
            let (q, d, t0) = (random.within(0.5, 4.0), random.within(5.0, 60.0), random.within(0.0, 250.0));
            for thick in [true, false] {
                let cooling = |q: f64, d: f64| time_at(500.0 - t0, thick, q, d) - time_at(800.0 - t0, thick, q, d);
                let formula = |q: f64, d: f64| {
                    let weld = on_plate(q, t0, d);
                    if thick { weld.three_dimensional_s() } else { weld.two_dimensional_s() }
                };
                let ratio = cooling(q, d) / formula(q, d);
                let other = cooling(1.7 * q, 0.6 * d) / formula(1.7 * q, 0.6 * d);
                assert!((ratio / other - 1.0).abs() < 1e-6, "{ratio} {other}");
                assert!((0.5..2.0).contains(&ratio), "{thick} {t0} {ratio}");
            }
        }
    }
}
