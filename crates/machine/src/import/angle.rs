use std::f64::consts::PI;

/// Digits after the decimal point from which a number can be recognised as a rounded multiple of 15 degrees.
const MIN_DECIMALS: usize = 4;
/// Fifteen degrees.
const STEP: f64 = PI / 12.0;

/// An angle as written, in rad, and as it is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Angle {
    pub(super) value: f64,
    /// True if it is a multiple of 15 degrees, written with fewer digits than a computer keeps.
    pub(super) is_rounded: bool,
}

/// Reads an angle. `1.5708` means a right angle: without its digits the axes of an arm are not parallel, and its inverse
/// has no closed form.
pub(super) fn angle(text: &str) -> Option<Angle> {
    let value = text.trim().parse::<f64>().ok().filter(|value| value.is_finite())?;
    let decimals =
        text.trim().split_once('.').map_or(0, |(_, digits)| digits.bytes().take_while(u8::is_ascii_digit).count());
    let meant = (value / STEP).round() * STEP;
    let unit = 0.1_f64.powi(i32::try_from(decimals).unwrap_or(i32::MAX));
    let is_meant = decimals >= MIN_DECIMALS && (value - meant).abs() < unit && !text.contains(['e', 'E']);
    let is_rounded = is_meant && (value - meant).abs() > 1e-15 && meant != 0.0;
    Some(if is_rounded { Angle { value: meant, is_rounded } } else { Angle { value, is_rounded: false } })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

    #[test]
    fn rounded_right_angles_are_right_angles() {
        for (text, meant) in [
            ("1.5708", FRAC_PI_2),
            ("1.5707", FRAC_PI_2),
            ("-1.57079632679", -FRAC_PI_2),
            ("3.141592653589793", PI),
            ("1.0472", FRAC_PI_3),
        ] {
            assert!((angle(text).unwrap().value - meant).abs() < 1e-16, "{text}");
        }
        assert!(angle("1.5708").unwrap().is_rounded && !angle("1.5707963267948966").unwrap().is_rounded);
    }

    #[test]
    fn other_numbers_stay_as_they_are() {
        for (text, value) in
            [("1.57", 1.57), ("1.5703", 1.5703), ("0.0001", 0.0001), ("1e-4", 1e-4), ("0", 0.0), ("1.5709", 1.5709)]
        {
            assert_eq!(angle(text).map(|a| (a.value, a.is_rounded)), Some((value, false)), "{text}");
        }
        for text in ["", "x", "nan", "inf"] {
            assert_eq!(angle(text), None, "{text}");
        }
    }
}
