//! Findings with the same message at several positions, gathered so that they are read once.

use crate::{Finding, Severity};
use seamwright_message::{Argument, Message};

/// Path lengths within this distance are shown alike, mm.
const SAME_MM: f64 = 5e-4;

/// Findings with the same message, and their positions.
#[derive(Debug, Clone, PartialEq)]
pub struct FindingGroup<'a> {
    /// The first of them.
    pub finding: &'a Finding,
    /// Message of all of them; a number that differs from one to another is a range, as `1.69–5.60`.
    pub message: Message,
    /// Operator action, in the same way.
    pub cure: Option<Message>,
    /// Positions of the findings, in their order.
    pub places: Vec<FindingPlace>,
}

/// A range of path length in a pass, or the same range in passes that follow one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FindingPlace {
    /// The first of the passes, counted from 1.
    pub first_pass: usize,
    /// The last of them.
    pub last_pass: usize,
    /// Start on the pass, mm of path length.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
}

/// Gathers findings of the same kind with the same message: errors first, then warnings, then notes, each in the order
/// of its first occurrence.
///
/// Warnings and notes are the same also if their numbers differ. Errors with different numbers stay apart, as each
/// needs its own operator action.
pub fn group_findings(findings: &[Finding]) -> Vec<FindingGroup<'_>> {
    let mut groups: Vec<(FindingGroup<'_>, Vec<&Finding>)> = Vec::new();
    for finding in findings {
        let place = FindingPlace {
            first_pass: finding.pass,
            last_pass: finding.pass,
            from_mm: finding.from_mm,
            to_mm: finding.to_mm,
        };
        match groups.iter_mut().find(|(group, _)| says_the_same(group.finding, finding)) {
            Some((group, members)) => {
                group.add(place);
                members.push(finding);
            }
            None => {
                let (message, cure) = (finding.message.clone(), finding.cure.clone());
                groups.push((FindingGroup { finding, message, cure, places: vec![place] }, vec![finding]));
            }
        }
    }
    for (group, members) in &mut groups {
        group.message = gathered(&members.iter().map(|f| &f.message).collect::<Vec<_>>());
        let cures: Vec<&Message> = members.iter().filter_map(|f| f.cure.as_ref()).collect();
        group.cure = (!cures.is_empty()).then(|| gathered(&cures));
    }
    let mut groups: Vec<FindingGroup<'_>> = groups.into_iter().map(|(group, _)| group).collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.finding.severity()));
    groups
}

fn says_the_same(a: &Finding, b: &Finding) -> bool {
    let same = |a: &Message, b: &Message| match (verbatim(a), verbatim(b)) {
        (Some(a), Some(b)) => pieces(a).map(Piece::shape).eq(pieces(b).map(Piece::shape)),
        _ => a.is_alike(b),
    };
    let exactly = a.severity() == Severity::Error;
    (a.kind, a.allowed) == (b.kind, b.allowed)
        && if exactly {
            (&a.message, &a.cure) == (&b.message, &b.cure)
        } else {
            let cures = match (&a.cure, &b.cure) {
                (Some(a), Some(b)) => same(a, b),
                (a, b) => a == b,
            };
            same(&a.message, &b.message) && cures
        }
}

/// Text of a message that has no code of its own yet.
fn verbatim(message: &Message) -> Option<&str> {
    match message.argument("text") {
        Some(Argument::Text(text)) if message.code == "text" => Some(text),
        _ => None,
    }
}

fn gathered(messages: &[&Message]) -> Message {
    let texts: Option<Vec<&str>> = messages.iter().map(|message| verbatim(message)).collect();
    texts.map_or_else(|| Message::gathered(messages), |texts| Message::verbatim(ranged(&texts)))
}

/// A piece of a sentence.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Piece<'a> {
    /// A number that stands alone; digits in names like `saddle-4axis` or `j1` are text.
    Number(&'a str),
    Text(&'a str),
}

impl<'a> Piece<'a> {
    /// The piece without the value of a number.
    fn shape(self) -> Option<&'a str> {
        match self {
            Self::Number(_) => None,
            Self::Text(text) => Some(text),
        }
    }

    fn text(self) -> &'a str {
        match self {
            Self::Number(text) | Self::Text(text) => text,
        }
    }
}

/// Splits a sentence into numbers and the text between them.
fn pieces(sentence: &str) -> impl Iterator<Item = Piece<'_>> {
    let mut rest = sentence;
    let mut before = ' ';
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let number = number_at(rest).filter(|_| !before.is_alphanumeric() && !['_', '-', '.'].contains(&before));
        let length = number.unwrap_or_else(|| {
            // Up to the next possible start of a number.
            let start = if first.is_ascii_digit() { digits(rest) } else { first.len_utf8() };
            rest[start..].find(|c: char| c.is_ascii_digit()).map_or(rest.len(), |at| start + at)
        });
        let (piece, after) = rest.split_at(length);
        before = piece.chars().next_back().unwrap_or(before);
        rest = after;
        Some(if number.is_some() { Piece::Number(piece) } else { Piece::Text(piece) })
    })
}

fn digits(text: &str) -> usize {
    text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len())
}

/// Length of the number at the start of `text` that no letter follows.
fn number_at(text: &str) -> Option<usize> {
    let whole = digits(text);
    let fraction = text[whole..].strip_prefix('.').map_or(0, digits);
    let length = whole + if fraction > 0 { fraction + 1 } else { 0 };
    let follows = text[length..].chars().next();
    (whole > 0 && !follows.is_some_and(|c| c.is_alphanumeric() || c == '_')).then_some(length)
}

/// The sentence of several that differ in their numbers, with ranges where they differ.
fn ranged(sentences: &[&str]) -> String {
    let Some(first) = sentences.first() else { return String::new() };
    let range = |(i, piece): (usize, Piece<'_>)| {
        let all = sentences.iter().filter_map(|sentence| pieces(sentence).nth(i)).map(Piece::text);
        let value = |text: &&str| text.parse::<f64>().unwrap_or(0.0);
        let by_value = |a: &&str, b: &&str| value(a).total_cmp(&value(b));
        let ends = all.clone().min_by(by_value).zip(all.max_by(by_value));
        match (piece, ends) {
            (Piece::Number(_), Some((least, greatest))) if least != greatest => format!("{least}–{greatest}"),
            _ => piece.text().to_owned(),
        }
    };
    pieces(first).enumerate().map(range).collect()
}

impl FindingGroup<'_> {
    fn add(&mut self, place: FindingPlace) {
        let next = |p: &&mut FindingPlace| place.first_pass.wrapping_sub(p.last_pass) <= 1 && p.is_at(&place);
        match self.places.iter_mut().find(next) {
            Some(known) => known.last_pass = place.last_pass,
            None => self.places.push(place),
        }
    }
}

impl FindingPlace {
    /// True if it is a single point of path length.
    pub fn is_point(&self) -> bool {
        self.to_mm - self.from_mm < SAME_MM
    }

    fn is_at(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| (a - b).abs() < SAME_MM || a.to_bits() == b.to_bits();
        same(self.from_mm, other.from_mm) && same(self.to_mm, other.to_mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn note(message: &str, pass: usize, range: (f64, f64)) -> Finding {
        Finding::note("process", message, pass, range)
    }

    #[test]
    fn equal_findings_are_one_with_all_their_places() {
        let mut findings: Vec<Finding> = (2..=14).map(|pass| note("same", pass, (0.0, 0.0))).collect();
        findings.insert(3, note("same", 2, (5.0, 7.0)));
        findings.push(note("same", 20, (0.0, 0.0)));
        findings.push(note("other", 14, (0.0, 0.0)));
        let groups = group_findings(&findings);
        assert_eq!(groups.iter().map(|g| g.message.to_string()).collect::<Vec<_>>(), ["same", "other"]);
        let place = |first_pass, last_pass, from_mm, to_mm| FindingPlace { first_pass, last_pass, from_mm, to_mm };
        assert_eq!(groups[0].places, [place(2, 14, 0.0, 0.0), place(2, 2, 5.0, 7.0), place(20, 20, 0.0, 0.0)]);
        assert!(groups[0].places[0].is_point() && !groups[0].places[1].is_point());
    }

    #[test]
    fn numbers_that_differ_are_ranges() {
        let unwinds = |by: &str, pass: usize| {
            let message =
                format!("axis j1 of saddle-4axis unwinds by {by} deg from pass {pass} to pass {}, v2.", pass + 1);
            note(&message, pass, (0.0, 0.0))
        };
        let findings = [unwinds("318.2", 4), unwinds("711.0", 5), unwinds("35.1", 9)];
        let groups = group_findings(&findings);
        let message = "axis j1 of saddle-4axis unwinds by 35.1–711.0 deg from pass 4–9 to pass 5–10, v2.";
        assert_eq!((groups.len(), groups[0].message.to_string()), (1, message.to_owned()));
        // Another axis is another matter, and so is another machine.
        let other = [note("axis j1 turns", 1, (0.0, 0.0)), note("axis j2 turns", 1, (0.0, 0.0))];
        assert_eq!(group_findings(&other).len(), 2);
        let other = [note("of saddle-4axis", 1, (0.0, 0.0)), note("of saddle-5axis", 1, (0.0, 0.0))];
        assert_eq!(group_findings(&other).len(), 2);
        // One that stands alone keeps every character.
        let alone = note("at 3.5, 7. Then -2 of 1e-3: 12 %, größer (4)", 1, (0.0, 0.0));
        assert_eq!(group_findings(std::slice::from_ref(&alone))[0].message, alone.message);
    }

    #[test]
    fn errors_keep_their_numbers() {
        let error = |speed: &str| Finding {
            allowed: false,
            cure: Some(format!("ask for {speed}").into()),
            ..note(&format!("allows {speed} mm/s"), 1, (0.0, 1.0))
        };
        let findings = [error("4.1"), error("3.9"), error("4.1")];
        let groups = group_findings(&findings);
        assert_eq!(
            groups.iter().map(|g| g.cure.as_ref().unwrap().to_string()).collect::<Vec<_>>(),
            ["ask for 4.1", "ask for 3.9"]
        );
    }

    #[test]
    fn what_stands_against_the_weld_comes_first() {
        let note = note("note", 1, (0.0, 1.0));
        let warning = Finding { cure: Some("do".into()), message: "warning".into(), ..note.clone() };
        let error = Finding { allowed: false, message: "error".into(), ..note.clone() };
        let findings = [note.clone(), warning, error, note];
        let groups = group_findings(&findings);
        assert_eq!(groups.iter().map(|g| g.message.to_string()).collect::<Vec<_>>(), ["error", "warning", "note"]);
    }

    #[test]
    fn another_cure_or_severity_is_another_finding() {
        let one = note("same", 1, (0.0, 1.0));
        let other = Finding { cure: Some("do".into()), ..one.clone() };
        let against = Finding { allowed: false, ..one.clone() };
        assert_eq!(group_findings(&[one, other, against]).len(), 3);
    }
}
