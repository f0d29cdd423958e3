//! Numbers as text, and as arguments of messages.

use crate::{Language, Words as _};
use seamwright_message::{Argument, Message, Quantity, Unit};

/// Placeholder for a missing value.
pub(crate) const NONE: &str = "–";

/// Writes `value` with up to `digits` significant digits, a decimal point and no trailing zeros.
///
/// Digits left of the point are never dropped: `12345.6` with 3 digits is `12346`. Magnitudes
/// from 1e-4 up to 1e9 are written plainly, others as `1.2e-12`. NaN is an en dash, the
/// infinities `∞` and `-∞`. The minus sign is the ASCII hyphen, so that the text can be read back;
/// charts and numeric columns set it as a true minus.
pub fn format_number(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "–".into();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "-∞" }.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.clamp(1, 17);
    let scientific = format!("{:.*e}", digits - 1, value);
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..9).contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        trim_zeros(&format!("{value:.decimals$}")).into()
    } else {
        format!("{}e{exponent}", trim_zeros(mantissa))
    }
}

pub(crate) fn localized(number: &str, language: Language) -> String {
    number.replace('.', &language.decimal_sign().to_string())
}

/// Formats `value` with up to `digits` significant digits and the decimal sign of `language`.
pub(crate) fn significant(value: f64, digits: usize, language: Language) -> String {
    localized(&format_number(value, digits), language)
}

pub(crate) fn fixed(value: f64, decimals: usize, language: Language) -> String {
    localized(&format_fixed(value, decimals), language)
}

/// Formats lengths, times, positions and other values in full.
pub(crate) fn number(value: f64, language: Language) -> String {
    significant(value, 5, language)
}

/// Formats errors and deviations, for which two digits suffice.
pub(crate) fn small(value: f64, language: Language) -> String {
    significant(value, 2, language)
}

pub(crate) fn quantity(value: f64, unit: Unit, digits: usize) -> Message {
    Message::new("quantity").significant("value", value, unit, digits)
}

/// Returns a message about a range, whose unit stands at its end.
pub(crate) fn range(code: &'static str, ends: (f64, f64), unit: Unit) -> Message {
    Message::new(code).significant("from", ends.0, Unit::One, 5).significant("to", ends.1, unit, 5)
}

pub(crate) fn from_to(from: impl Into<String>, to: impl Into<String>, language: Language) -> String {
    Message::new("report-range").text("from", from).text("to", to).in_language(language)
}

pub(crate) fn allowed(window: Option<(f64, f64)>, language: Language) -> String {
    match window {
        Some((low, high)) => from_to(number(low, language), number(high, language), language),
        None => language.words("report-not-limited"),
    }
}

pub(crate) trait Significant: Sized {
    /// Adds a value with up to `digits` significant digits, see [`format_number`].
    fn significant(self, name: &'static str, value: f64, unit: Unit, digits: usize) -> Self;
}

impl Significant for Message {
    fn significant(self, name: &'static str, value: f64, unit: Unit, digits: usize) -> Self {
        let text = format_number(value, digits);
        if !value.is_finite() {
            return self.text(name, text);
        }
        let decimals = match text.split_once('e') {
            // Smaller values are printed in full; larger ones are whole numbers.
            Some((mantissa, exponent)) => {
                let digits = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
                (digits as i32 - exponent.parse().unwrap_or(0)).clamp(0, 15) as usize
            }
            None => text.split_once('.').map_or(0, |(_, decimals)| decimals.len()),
        };
        self.with(name, Argument::Quantity(Quantity { value, unit, decimals: decimals as u8 }))
    }
}

/// Writes `value` with exactly `decimals` places and without a negative zero.
pub(crate) fn format_fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| b == b'0' || b == b'.') => rest.into(),
        _ => text,
    }
}

/// Writes a drawing coordinate in tenths of a pixel.
pub(crate) fn px(value: f64) -> String {
    trim_zeros(&format_fixed(value, 1)).into()
}

fn trim_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_without_noise() {
        for (value, digits, text) in [
            (0.0, 3, "0"),
            (-0.0, 3, "0"),
            (1.0, 4, "1"),
            (2.5, 4, "2.5"),
            (0.1 + 0.2, 6, "0.3"),
            (12345.6, 3, "12346"),
            (100.0, 2, "100"),
            (999.96, 4, "1000"),
            (-0.012345, 3, "-0.0123"),
            (0.000_123_4, 2, "0.00012"),
            (0.000_012_34, 2, "1.2e-5"),
            (3e12, 4, "3e12"),
            (-1.5e-12, 4, "-1.5e-12"),
            (f64::NAN, 4, "–"),
            (f64::INFINITY, 4, "∞"),
            (f64::NEG_INFINITY, 4, "-∞"),
        ] {
            assert_eq!(format_number(value, digits), text, "{value:e} to {digits}");
        }
    }

    #[test]
    fn arguments_have_as_many_digits_as_text() {
        for (value, text) in [(0.0, "0 mm"), (12345.6, "12346 mm"), (-0.012_345, "-0.0123 mm"), (1.2e-5, "0.000012 mm")]
        {
            let message = Message::new("quantity").significant("value", value, Unit::Mm, 3);
            assert_eq!(message.in_language(Language::English), text);
        }
        let message = Message::new("quantity").significant("value", 2.50, Unit::Mm, 3);
        assert_eq!(message.in_language(Language::German), "2,5 mm");
        assert_eq!(significant(-1.25, 3, Language::Ukrainian), "-1,25");
    }

    #[test]
    fn digits_out_of_range_are_clamped() {
        assert_eq!(format_number(12.5, 0), "12");
        assert!(format_number(0.1, 1000).starts_with("0.1"));
    }

    #[test]
    fn coordinates_are_short_and_never_minus_zero() {
        assert_eq!(px(12.04), "12");
        assert_eq!(px(-0.04), "0");
        assert_eq!(px(7.25), "7.2");
        assert_eq!(format_fixed(-0.001, 2), "0.00");
    }
}
