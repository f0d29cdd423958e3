/// Conditions under which a weld hardens and cracks by hydrogen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hardening {
    /// Carbon equivalent CET, %.
    pub cet: f64,
    /// Thickness of the plate, mm.
    pub thickness_mm: f64,
    /// Diffusible hydrogen of the weld metal, ml in 100 g.
    pub hydrogen_ml_100g: f64,
    /// Heat input, kJ/mm.
    pub heat_input_kj_mm: f64,
}

/// Ranges of method B of EN 1011-2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PreheatRange {
    /// CET, %.
    pub cet: (f64, f64),
    /// Thickness, mm.
    pub thickness_mm: (f64, f64),
    /// Diffusible hydrogen, ml in 100 g.
    pub hydrogen_ml_100g: (f64, f64),
    /// Heat input, kJ/mm.
    pub heat_input_kj_mm: (f64, f64),
}

/// The ranges in which the formula was fitted (EN 1011-2, C.3).
pub const PREHEAT_RANGE: PreheatRange = PreheatRange {
    cet: (0.2, 0.5),
    thickness_mm: (10.0, 90.0),
    hydrogen_ml_100g: (1.0, 20.0),
    heat_input_kj_mm: (0.5, 4.0),
};

impl Hardening {
    /// Minimum temperature before each pass, degrees Celsius, by method B of EN 1011-2 (C.3):
    /// 697 CET + 160 tanh(d/35) + 62 HD^0.35 + (53 CET - 32) Q - 328. Below room temperature no preheat is needed.
    /// Values outside [`PREHEAT_RANGE`] are computed alike, see [`Hardening::is_in_range`].
    pub fn preheat_c(&self) -> f64 {
        let Self { cet, thickness_mm, hydrogen_ml_100g, heat_input_kj_mm } = *self;
        697.0 * cet
            + 160.0 * (thickness_mm / 35.0).tanh()
            + 62.0 * hydrogen_ml_100g.powf(0.35)
            + (53.0 * cet - 32.0) * heat_input_kj_mm
            - 328.0
    }

    /// True if all values are in the ranges for which the formula was made.
    pub fn is_in_range(&self) -> bool {
        let within = |value: f64, (low, high): (f64, f64)| (low..=high).contains(&value);
        within(self.cet, PREHEAT_RANGE.cet)
            && within(self.thickness_mm, PREHEAT_RANGE.thickness_mm)
            && within(self.hydrogen_ml_100g, PREHEAT_RANGE.hydrogen_ml_100g)
            && within(self.heat_input_kj_mm, PREHEAT_RANGE.heat_input_kj_mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// The standard splits the formula into four parts, one for each quantity with the others at usual values (figures
    /// C.1 to C.4): their sum is the formula.
    #[test]
    fn the_formula_is_the_sum_of_its_parts_in_the_standard() {
        let mut random = Random::new(2);
        for _ in 0..5000 {
            let (cet, d) = (random.within(0.2, 0.5), random.within(10.0, 90.0));
            let (hd, q) = (random.within(1.0, 20.0), random.within(0.5, 4.0));
            let of_steel = 750.0 * cet - 150.0;
            let of_thickness = 160.0 * (d / 35.0).tanh() - 110.0;
            let of_hydrogen = 62.0 * hd.powf(0.35) - 100.0;
            let of_heat = (53.0 * cet - 32.0) * q - 53.0 * cet + 32.0;
            let all = Hardening { cet, thickness_mm: d, hydrogen_ml_100g: hd, heat_input_kj_mm: q };
            let sum = of_steel + of_thickness + of_hydrogen + of_heat;
            assert!((all.preheat_c() - sum).abs() < 1e-9 && all.is_in_range(), "{all:?}");
        }
    }

    /// The standard's line for the steel alone, 750 CET - 150, is that of 30 mm, HD 4 and 1 kJ/mm.
    #[test]
    fn carbon_equivalent_alone() {
        for (cet, preheat_c) in [(0.24, 30.0), (0.3, 75.0), (0.36, 120.0), (0.42, 165.0)] {
            let steel = Hardening { cet, thickness_mm: 30.0, hydrogen_ml_100g: 4.0, heat_input_kj_mm: 1.0 };
            assert!((steel.preheat_c() - preheat_c).abs() < 3.0, "{cet} {}", steel.preheat_c());
        }
    }

    #[test]
    fn preheat_grows_with_all_but_heat_input() {
        let steel = Hardening { cet: 0.35, thickness_mm: 30.0, hydrogen_ml_100g: 5.0, heat_input_kj_mm: 1.5 };
        let of = |changed: Hardening| changed.preheat_c() - steel.preheat_c();
        assert!(of(Hardening { cet: 0.36, ..steel }) > 0.0);
        assert!(of(Hardening { thickness_mm: 40.0, ..steel }) > 0.0);
        assert!(of(Hardening { hydrogen_ml_100g: 10.0, ..steel }) > 0.0);
        assert!(of(Hardening { heat_input_kj_mm: 2.0, ..steel }) < 0.0);
        assert!(!Hardening { thickness_mm: 5.0, ..steel }.is_in_range());
    }
}
