//! Numbers as controls read them: fixed point, no exponent, no trailing zeros, no negative zero.

const DECIMALS: usize = 6;
const SCALE: f64 = 1e6;
/// Above this the products below are not exact any more.
const LARGEST: f64 = 4e9;

/// `value` with at most `decimals` decimals, without trailing zeros and without a negative zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let mut text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// Appends `value` with at most six decimals to `out`, with `point` as the decimal point. The exact value is rounded to
/// the nearest, ties to even.
pub(crate) fn push(out: &mut Vec<u8>, value: f64, point: u8) {
    let size = value.abs();
    if size.is_nan() || size > LARGEST {
        out.extend(fixed(value, DECIMALS).bytes().map(|c| if c == b'.' { point } else { c }));
        return;
    }
    let parts = millionths(size);
    if value < 0.0 && parts > 0 {
        out.push(b'-');
    }
    push_whole(out, parts / 1_000_000);
    let mut rest = (parts % 1_000_000) as u32;
    if rest > 0 {
        out.push(point);
        let mut unit = 100_000;
        while rest > 0 {
            out.push(b'0' + (rest / unit) as u8);
            rest %= unit;
            unit /= 10;
        }
    }
}

/// Appends a feed or a centre to `out`, with nine decimals: six would be too few digits of a slow feed, and centres are
/// no positions of an axis.
pub(super) fn push_fine(out: &mut Vec<u8>, value: f64, point: u8) {
    const PARTS: u64 = 1_000_000_000;
    if value.is_nan() || value.abs() > LARGEST {
        return push(out, value, point);
    }
    let parts = (value.abs() * PARTS as f64).round() as u64;
    if value < 0.0 && parts > 0 {
        out.push(b'-');
    }
    push_whole(out, parts / PARTS);
    let mut rest = (parts % PARTS) as u32;
    if rest > 0 {
        out.push(point);
        let mut unit = (PARTS / 10) as u32;
        while rest > 0 {
            out.push(b'0' + (rest / unit) as u8);
            rest %= unit;
            unit /= 10;
        }
    }
}

fn millionths(size: f64) -> u64 {
    let scaled = size * SCALE;
    let whole = scaled.floor();
    let above = scaled - whole - 0.5;
    // Near a tie the rounding error of the product decides.
    if above.abs() > scaled * f64::EPSILON {
        return whole as u64 + u64::from(above > 0.0);
    }
    let exact = above + size.mul_add(SCALE, -scaled);
    let whole = whole as u64;
    whole + u64::from(exact > 0.0 || (exact == 0.0 && whole % 2 == 1))
}

/// Adds a whole number.
pub(super) fn push_whole(out: &mut Vec<u8>, mut value: u64) {
    let mut digits = [0u8; 20];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (value % 10) as u8;
        value /= 10;
        if value == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pushed(value: f64) -> String {
        let mut out = Vec::new();
        push(&mut out, value, b'.');
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn plain_numbers() {
        assert_eq!(fixed(1.5, 6), "1.5");
        assert_eq!(fixed(-0.000_000_04, 6), "0");
        assert_eq!(fixed(100.0, 0), "100");
        assert_eq!(fixed(12.345_678_9, 6), "12.345679");
        let mut out = Vec::new();
        push(&mut out, -19.2, b',');
        assert_eq!(out, b"-19,2");
    }

    /// Against the standard library's exact rounding: all sizes, and values half-way between two decimals or next to
    /// it.
    #[test]
    fn numbers_are_those_of_format() {
        let mut random = seamwright_testkit::Random::new(7);
        let check = |value: f64| assert_eq!(pushed(value), fixed(value, 6), "{value:?}");
        for _ in 0..200_000 {
            check(random.within(-0.5, 0.5) * 10f64.powf(random.within(-3.0, 11.0)));
            // Halves of a millionth, which are exact only in 128ths.
            let half = (random.within(0.0, 1e9).floor() + 0.5) / 1e6;
            let tie = random.within(0.0, 1e6).floor() / 128.0;
            for value in [half, half.next_up(), half.next_down(), tie, -tie, tie.next_up(), tie.next_down()] {
                check(value);
            }
            // A decimal that was read comes back.
            let decimal = random.within(0.0, 1e9).floor() / 1e6;
            assert_eq!(pushed(decimal).parse::<f64>().unwrap().to_bits(), decimal.to_bits());
        }
        for value in [0.0, -0.0, 1e-7, 5e-7, 4e9, 4.1e9, 1e15, -1e300, 0.999_999_5, 0.999_999_499_999] {
            check(value);
        }
    }
}
