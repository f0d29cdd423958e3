//! Text for markup: allowed characters, estimated widths, the minus sign.

/// Replaces the characters that XML forbids with U+FFFD.
pub(crate) fn printable(markup: String) -> String {
    let is_forbidden =
        |c: char| (c.is_control() && !matches!(c, '\t' | '\n' | '\r')) || matches!(c, '\u{fffe}' | '\u{ffff}');
    if markup.contains(is_forbidden) { markup.replace(is_forbidden, "\u{fffd}") } else { markup }
}

/// Replaces each hyphen at the start of a number with a true minus.
pub(crate) fn minus(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut chars = text.chars().peekable();
    let mut previous = ' ';
    while let Some(c) = chars.next() {
        let number = chars.peek().is_some_and(|n| n.is_ascii_digit() || *n == '∞');
        let starts = !previous.is_alphanumeric() && previous != '-';
        out.push(if c == '-' && number && starts { '−' } else { c });
        previous = c;
    }
    out
}

/// Estimates the width of `text` in px at font `size`, on the wide side of common sans-serif faces.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(advance).sum::<f64>() * size
}

fn advance(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | 'I' | '|' | '\'' => 0.3,
        ' ' | '.' | ',' | ':' | ';' => 0.33,
        'f' | 't' | 'r' | '(' | ')' | '/' | '-' | '!' => 0.41,
        'm' | 'M' | 'W' | '%' | '@' | '—' => 1.0,
        'w' | '+' | '=' | '−' | '±' | '×' => 0.83,
        '0'..='9' | 'a'..='z' => 0.64,
        'A'..='Z' => 0.73,
        c if (c as u32) < 0x2e80 => 0.66,
        _ => 1.0,
    }
}

/// Breaks `text` at spaces into lines of at most `limit` px at font `size`; longer words have a line of their own.
pub(crate) fn lines(text: &str, size: f64, limit: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(" ", size) + width(word, size) <= limit => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Shortens `text` with an ellipsis so that it fits `limit` px at font `size`.
pub(crate) fn fit(text: &str, size: f64, limit: f64) -> String {
    if width(text, size) <= limit {
        return text.into();
    }
    let mut room = limit - width("…", size);
    let mut out = String::new();
    for c in text.chars() {
        room -= advance(c) * size;
        if room < 0.0 {
            break;
        }
        out.push(c);
    }
    out.truncate(out.trim_end().len());
    out.push('…');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_keep_all_words_within_their_room() {
        let text = "dihedral angle 90 degrees, area 123.4 mm^2 and cap 5 mm^2";
        let all = lines(text, 12.0, 150.0);
        assert!(all.len() > 2 && all.join(" ") == text && all.iter().all(|line| width(line, 12.0) <= 150.0), "{all:?}");
        assert!(lines("", 12.0, 100.0).is_empty());
    }

    #[test]
    fn forbidden_characters_are_replaced() {
        assert_eq!(printable("<a>\u{0}\u{1b}\n".to_owned()), "<a>\u{fffd}\u{fffd}\n");
        assert_eq!(printable("ä\t".to_owned()), "ä\t");
    }

    #[test]
    fn minus_only_before_numbers() {
        assert_eq!(minus("-3.5"), "−3.5");
        assert_eq!(minus("-∞"), "−∞");
        assert_eq!(minus("-3 to -1"), "−3 to −1");
        assert_eq!(minus("G1 X-3"), "G1 X-3");
        assert_eq!(minus("1.2e-5, 2026-11-20, run-up"), "1.2e-5, 2026-11-20, run-up");
    }

    #[test]
    fn fitting_shortens_only_what_is_too_long() {
        assert_eq!(fit("short", 12.0, 100.0), "short");
        let cut = fit("a title that is far too long for its place", 12.0, 100.0);
        assert!(cut.ends_with('…') && width(&cut, 12.0) <= 100.0, "{cut}");
        assert_eq!(fit("anything", 12.0, 0.0), "…");
    }
}
