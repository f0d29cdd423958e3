/// `value` with at most `decimals` decimals, without trailing zeros and without a negative zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let mut text = format!("{value:.decimals$}");
    if text.contains('.') {
        let end = text.trim_end_matches('0').trim_end_matches('.').len();
        text.truncate(end);
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// `value` with about `digits` significant digits, never in exponent form, which controls do not read.
pub(crate) fn significant(value: f64, digits: i32) -> String {
    let magnitude = if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 };
    fixed(value, usize::try_from(digits - 1 - magnitude).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_numbers() {
        assert_eq!(fixed(1.5, 6), "1.5");
        assert_eq!(fixed(-0.000_000_04, 6), "0");
        assert_eq!(fixed(100.0, 0), "100");
        assert_eq!(fixed(12.345_678_9, 6), "12.345679");
        assert_eq!(significant(0.001_234_567_89, 4), "0.001235");
        assert_eq!(significant(123_456.78, 4), "123457");
        assert_eq!(significant(0.0, 4), "0");
    }
}
