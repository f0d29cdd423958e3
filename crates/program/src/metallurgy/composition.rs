use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Composition in % of mass, by chemical symbols; missing elements are 0, the rest is iron.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields, rename_all = "PascalCase")]
pub struct Composition {
    /// Carbon, %.
    pub c: NonNegative,
    /// Silicon, %.
    pub si: NonNegative,
    /// Manganese, %.
    pub mn: NonNegative,
    /// Phosphorus, %.
    pub p: NonNegative,
    /// Sulphur, %.
    pub s: NonNegative,
    /// Chromium, %.
    pub cr: NonNegative,
    /// Molybdenum, %.
    pub mo: NonNegative,
    /// Nickel, %.
    pub ni: NonNegative,
    /// Copper, %.
    pub cu: NonNegative,
    /// Vanadium, %.
    pub v: NonNegative,
    /// Niobium, %.
    pub nb: NonNegative,
    /// Titanium, %.
    pub ti: NonNegative,
    /// Aluminium, %.
    pub al: NonNegative,
    /// Nitrogen, %.
    pub n: NonNegative,
    /// Boron, %.
    pub b: NonNegative,
}

/// Carbon equivalents of a steel, %.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CarbonEquivalents {
    /// CE of the International Institute of Welding.
    pub ce_iiw: f64,
    /// CET of EN 1011-2, method B.
    pub cet: f64,
    /// Pcm of Ito and Bessyo.
    pub pcm: f64,
}

/// Carbon of steel is at most this, %; more is cast iron, or a mistaken decimal point.
const MAX_CARBON: f64 = 2.1;

impl Composition {
    /// Carbon equivalents: CE = C + Mn/6 + (Cr + Mo + V)/5 + (Ni + Cu)/15 (IIW); CET = C + (Mn + Mo)/10 + (Cr + Cu)/20 +
    /// Ni/40 (EN 1011-2); Pcm = C + Si/30 + (Mn + Cu + Cr)/20 + Ni/60 + Mo/15 + V/10 + 5 B (Ito and Bessyo, 1969).
    pub fn carbon_equivalents(&self) -> CarbonEquivalents {
        let [c, si, mn, cr, mo, ni, cu, v, b] =
            [self.c, self.si, self.mn, self.cr, self.mo, self.ni, self.cu, self.v, self.b].map(NonNegative::get);
        CarbonEquivalents {
            ce_iiw: c + mn / 6.0 + (cr + mo + v) / 5.0 + (ni + cu) / 15.0,
            cet: c + (mn + mo) / 10.0 + (cr + cu) / 20.0 + ni / 40.0,
            pcm: c + si / 30.0 + (mn + cu + cr) / 20.0 + ni / 60.0 + mo / 15.0 + v / 10.0 + 5.0 * b,
        }
    }

    fn sum(&self) -> f64 {
        let Self { c, si, mn, p, s, cr, mo, ni, cu, v, nb, ti, al, n, b } = *self;
        [c, si, mn, p, s, cr, mo, ni, cu, v, nb, ti, al, n, b].map(NonNegative::get).iter().sum()
    }

    /// Checks the composition at `path` of a file.
    ///
    /// # Errors
    /// With the key's address: no carbon, too much of it, more than 100 % in all.
    pub(super) fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let carbon = self.c.get();
        if carbon <= 0.0 || carbon > MAX_CARBON {
            let allowed = Message::new("document-more-than-up-to").number("min", 0.0, 0).number("max", MAX_CARBON, 1);
            let message = Message::new("program-carbon-invalid").value("found", carbon, Unit::Percent);
            return Err(file.error_at(&format!("{path}.C"), message, allowed));
        }
        if self.sum() > 100.0 {
            let message = Message::new("program-composition-sum").quantity("sum", self.sum(), Unit::Percent, 2);
            let allowed = Message::new("document-up-to").value("max", 100.0, Unit::Percent);
            return Err(file.error_at(path, message, allowed));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steel(parts: &str) -> Composition {
        toml::from_str(parts).unwrap()
    }

    /// Compositions and carbon equivalents computed by hand from the formulas of the standards.
    #[test]
    fn carbon_equivalents_are_those_of_the_standards() {
        let s355 = steel("C = 0.18\nSi = 0.4\nMn = 1.5\nCr = 0.1\nNi = 0.1\nCu = 0.2\nMo = 0.02\nV = 0.01")
            .carbon_equivalents();
        assert!((s355.ce_iiw - (0.18 + 0.25 + 0.026 + 0.02)).abs() < 1e-12);
        assert!((s355.cet - (0.18 + 0.152 + 0.015 + 0.0025)).abs() < 1e-12);
        let pcm = 0.18 + 0.4 / 30.0 + 1.8 / 20.0 + 0.1 / 60.0 + 0.02 / 15.0 + 0.001;
        assert!((s355.pcm - pcm).abs() < 1e-12);
        // 13CrMo4-5, by hand: 0.13 + 0.55/6 + 1.45/5 and 0.13 + 1.05/10 + 0.95/20.
        let crmo = steel("C = 0.13\nSi = 0.25\nMn = 0.55\nCr = 0.95\nMo = 0.5").carbon_equivalents();
        assert!((crmo.ce_iiw - 0.5117).abs() < 1e-4 && (crmo.cet - 0.2825).abs() < 1e-9, "{crmo:?}");
        // Boron counts five times in Pcm alone.
        let [with, without] = ["C = 0.1\nB = 0.002", "C = 0.1"].map(|text| steel(text).carbon_equivalents());
        assert!((with.pcm - without.pcm - 0.01).abs() < 1e-12);
        assert!((with.ce_iiw - without.ce_iiw).abs() < 1e-12 && (with.cet - without.cet).abs() < 1e-12);
    }
}
