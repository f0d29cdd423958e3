use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Waiting with the arc off until the weld has cooled: a time, or the temperature below which the next pass may begin.
/// Tacks count as no pass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interpass {
    /// Minimum time from the end of a pass to the start of the next one over it, s; or `below_c`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wait_s: Option<NonNegative>,
    /// Maximum temperature of the weld before a pass, degrees Celsius; or `wait_s`. The wait is estimated by the
    /// conduction of heat in a plate of the joint's thickness: measure before welding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub below_c: Option<Positive>,
    /// Temperature of the work far from the weld, degrees Celsius.
    #[serde(default = "ambient")]
    pub work_c: Finite,
    /// Heat conductivity, W/(m K): 40 of unalloyed steel at these temperatures, 20 of austenitic steel.
    #[serde(default = "conductivity")]
    pub conductivity_w_mk: Positive,
    /// Heat capacity by volume, MJ/(m^3 K): 4.5 of steel.
    #[serde(default = "capacity")]
    pub capacity_mj_m3k: Positive,
    /// Heat transfer to the air from each face, W/(m^2 K): 20 by convection and radiation.
    #[serde(default = "transfer")]
    pub transfer_w_m2k: NonNegative,
}

fn ambient() -> Finite {
    Finite::new(20.0).unwrap_or_default()
}

fn conductivity() -> Positive {
    Positive::new(40.0).unwrap_or(Positive::TEN)
}

fn capacity() -> Positive {
    Positive::new(4.5).unwrap_or(Positive::TEN)
}

fn transfer() -> NonNegative {
    NonNegative::new(20.0).unwrap_or_default()
}

/// Images of the source of heat on each side: more change the temperature by less than 1e-9 of it where it matters.
const IMAGES: u32 = 40;

impl Interpass {
    /// Checks the table `path` of a file.
    ///
    /// # Errors
    /// With the key's address: neither a time nor a temperature, or both; a temperature that the work never reaches.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        if self.wait_s.is_some() == self.below_c.is_some() {
            let allowed = Message::new("program-interpass-wait-or-below");
            return Err(file.error_at(path, Message::new("program-interpass-one-of"), allowed));
        }
        match self.below_c.filter(|below| below.get() <= self.work_c.get()) {
            Some(below) => {
                let message = Message::new("program-interpass-below-work").value("found", below.get(), Unit::DegC);
                let allowed = Message::new("document-more-than").value("min", self.work_c.get(), Unit::DegC);
                Err(file.error_at(&format!("{path}.below_c"), message, allowed))
            }
            None => Ok(()),
        }
    }

    /// Rise of temperature at a place `t` seconds after an arc went over it with `heat_kj_mm`, K, in a plate of
    /// `thickness_mm`: a line source on the face of a plate whose faces only lose heat to the air (Carslaw and Jaeger,
    /// Conduction of Heat in Solids, 10.3: images at multiples of twice the thickness).
    pub fn rise_k(&self, heat_kj_mm: f64, thickness_mm: f64, t: f64) -> f64 {
        if t <= 0.0 {
            return f64::INFINITY;
        }
        // J, mm, s, K.
        let (k, c) = (1e-3 * self.conductivity_w_mk.get(), 1e-3 * self.capacity_mj_m3k.get());
        let a = k / c;
        let image = |n: u32| (-(f64::from(n) * thickness_mm).powi(2) / (a * t)).exp();
        // Far beyond the time in which heat goes through the plate the sum over images becomes an integral.
        let images = match a * t > 25.0 * thickness_mm.powi(2) {
            true => (std::f64::consts::PI * a * t).sqrt() / thickness_mm,
            false => 1.0 + 2.0 * (1..=IMAGES).map(image).sum::<f64>(),
        };
        let loss = (-2e-6 * self.transfer_w_m2k.get() * t / (c * thickness_mm)).exp();
        1000.0 * heat_kj_mm / (2.0 * std::f64::consts::PI * k * t) * images * loss
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;
    use std::f64::consts::PI;

    fn steel(rest: &str) -> Interpass {
        toml::from_str(&format!("below_c = 200\n{rest}")).unwrap()
    }

    #[test]
    fn thin_and_thick_plates_follow_rosenthal() {
        let steel = steel("transfer_w_m2k = 0");
        let (k, c) = (0.04, 0.0045);
        let mut random = Random::new(3);
        for _ in 0..2000 {
            let (q, d, t) = (random.within(0.2, 4.0), random.decades(1.0, 300.0), random.decades(0.1, 5000.0));
            let rise = steel.rise_k(q, d, t);
            let thick = 1000.0 * q / (2.0 * PI * k * t);
            let thin = 1000.0 * q / (d * (4.0 * PI * k * c * t).sqrt());
            assert!(rise >= thick.max(thin) * (1.0 - 1e-9), "{q} {d} {t}: {rise} {thick} {thin}");
            let depth = d * d / (k / c * t);
            if depth > 30.0 {
                assert!((rise / thick - 1.0).abs() < 1e-9, "{depth} {rise} {thick}");
            }
            if depth < 0.1 {
                assert!((rise / thin - 1.0).abs() < 1e-9, "{depth} {rise} {thin}");
            }
        }
    }

    /// Against finite differences: a plate of 10 mm across its width and thickness, heated along a line on its face.
    #[test]
    fn a_plate_in_finite_differences_cools_alike() {
        let steel = steel("transfer_w_m2k = 0");
        let (k, c, d, q) = (0.04, 0.0045, 10.0, 1.0);
        let (h, layers, half) = (0.5, 20, 220);
        let mut field = vec![vec![0.0; half]; layers];
        // Half of the plate, mirrored at the weld: the first cell holds half of the heat.
        field[0][0] = 500.0 * q / (c * h * h);
        let step = 0.2 * h * h * c / k;
        let (mut t, mut compared) = (0.0, 0);
        while t < 40.0 {
            let old = field.clone();
            for y in 0..layers {
                for x in 0..half {
                    let at = |y: usize, x: usize| old[y.min(layers - 1)][x.min(half - 1)];
                    let around = at(y.saturating_sub(1), x) + at(y + 1, x) + at(y, x.saturating_sub(1)) + at(y, x + 1);
                    field[y][x] += 0.2 * (around - 4.0 * old[y][x]);
                }
            }
            t += step;
            if t > 3.0 * f64::from(compared + 1) && compared < 12 {
                compared += 1;
                let rise = steel.rise_k(q, d, t);
                assert!((field[0][0] / rise - 1.0).abs() < 0.02, "{t}: {} {rise}", field[0][0]);
            }
        }
        assert_eq!(compared, 12);
    }

    #[test]
    fn heat_leaves_by_the_faces() {
        let (with, without) = (steel(""), steel("transfer_w_m2k = 0"));
        // 2 h t / (c d): 2 * 20 * 450 / (4.5e6 * 0.01) = 0.4.
        let ratio = with.rise_k(1.0, 10.0, 450.0) / without.rise_k(1.0, 10.0, 450.0);
        assert!((ratio - (-0.4_f64).exp()).abs() < 1e-9, "{ratio}");
    }
}
