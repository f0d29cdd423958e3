//! Findings with the same message at several positions, gathered so that they are read once.

use crate::finding::{Finding, Severity};
use seamwright_message::Message;

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
        group.message = Message::gathered(&members.iter().map(|f| &f.message).collect::<Vec<_>>());
        let cures: Vec<&Message> = members.iter().filter_map(|f| f.cure.as_ref()).collect();
        group.cure = (!cures.is_empty()).then(|| Message::gathered(&cures));
    }
    let mut groups: Vec<FindingGroup<'_>> = groups.into_iter().map(|(group, _)| group).collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.finding.severity()));
    groups
}

fn says_the_same(a: &Finding, b: &Finding) -> bool {
    let exactly = a.severity() == Severity::Error;
    (a.kind, a.allowed) == (b.kind, b.allowed)
        && if exactly {
            // As they are printed: numbers may differ beyond the decimals that are shown.
            let printed = |m: &Message| m.as_data();
            printed(&a.message) == printed(&b.message) && a.cure.as_ref().map(printed) == b.cure.as_ref().map(printed)
        } else {
            let cures = match (&a.cure, &b.cure) {
                (Some(a), Some(b)) => a.is_alike(b),
                (a, b) => a == b,
            };
            a.message.is_alike(&b.message) && cures
        }
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
    use crate::path_range::PathRange;
    use seamwright_message::Unit;

    fn note(message: Message, pass: usize, from_mm: f64, to_mm: f64) -> Finding {
        Finding::note("process", message, pass, PathRange { from_mm, to_mm })
    }

    fn codes(groups: &[FindingGroup<'_>]) -> Vec<String> {
        groups.iter().map(|group| group.message.as_data()).collect()
    }

    #[test]
    fn equal_findings_are_one_with_all_their_places() {
        let same = |pass, from, to| note(Message::new("same"), pass, from, to);
        let mut findings: Vec<Finding> = (2..=14).map(|pass| same(pass, 0.0, 0.0)).collect();
        findings.insert(3, same(2, 5.0, 7.0));
        findings.push(same(20, 0.0, 0.0));
        findings.push(note(Message::new("other"), 14, 0.0, 0.0));
        let groups = group_findings(&findings);
        assert_eq!(codes(&groups), ["same", "other"]);
        let place = |first_pass, last_pass, from_mm, to_mm| FindingPlace { first_pass, last_pass, from_mm, to_mm };
        assert_eq!(groups[0].places, [place(2, 14, 0.0, 0.0), place(2, 2, 5.0, 7.0), place(20, 20, 0.0, 0.0)]);
        assert!(groups[0].places[0].is_point() && !groups[0].places[1].is_point());
    }

    #[test]
    fn numbers_that_differ_are_ranges() {
        let unwinds = |axis: &str, by: f64, pass: usize| {
            let message =
                Message::new("unwinds").axis("axis", axis).quantity("by", by, Unit::Deg, 1).pass("pass", pass);
            note(message, pass, 0.0, 0.0)
        };
        let findings = [unwinds("j1", 318.2, 4), unwinds("j1", 711.0, 5), unwinds("j1", 35.1, 9)];
        assert_eq!(
            codes(&group_findings(&findings)),
            ["unwinds: axis = j1, by = 35.1 deg to 711.0 deg, pass = 4 to 9"]
        );
        // Another axis is another matter.
        assert_eq!(group_findings(&[unwinds("j1", 1.0, 1), unwinds("j2", 1.0, 1)]).len(), 2);
        // One that stands alone stays as it is.
        assert_eq!(group_findings(&findings[..1])[0].message, findings[0].message);
    }

    #[test]
    fn errors_keep_their_numbers() {
        let speed = |code, speed| Message::new(code).quantity("speed", speed, Unit::MmPerS, 1);
        let error =
            |v: f64| Finding { allowed: false, cure: Some(speed("set", v)), ..note(speed("allows", v), 1, 0.0, 1.0) };
        let groups = [error(4.1), error(3.9), error(4.1), error(4.1000001)];
        let groups = group_findings(&groups);
        let cures: Vec<&Message> = groups.iter().filter_map(|group| group.cure.as_ref()).collect();
        assert_eq!(cures, [&speed("set", 4.1), &speed("set", 3.9)]);
    }

    #[test]
    fn what_stands_against_the_weld_comes_first() {
        let note = note(Message::new("note"), 1, 0.0, 1.0);
        let warning = Finding { cure: Some(Message::new("do")), message: Message::new("warning"), ..note.clone() };
        let error = Finding { allowed: false, message: Message::new("error"), ..note.clone() };
        assert_eq!(codes(&group_findings(&[note.clone(), warning, error, note])), ["error", "warning", "note"]);
    }

    #[test]
    fn another_cure_or_severity_is_another_finding() {
        let one = note(Message::new("same"), 1, 0.0, 1.0);
        let other = Finding { cure: Some(Message::new("do")), ..one.clone() };
        let against = Finding { allowed: false, ..one.clone() };
        assert_eq!(group_findings(&[one, other, against]).len(), 3);
    }
}
