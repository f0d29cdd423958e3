//! Findings that say the same at several places, gathered so that they are read once.

use crate::Finding;

/// Path lengths within this distance are shown alike, mm.
const SAME_MM: f64 = 5e-4;

/// Findings that say the same, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct FindingGroup<'a> {
    /// The first of them.
    pub finding: &'a Finding,
    /// Where they were found, in their order.
    pub places: Vec<FindingPlace>,
}

/// A range of path length in a pass, or the same range in passes that follow one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FindingPlace {
    /// The first of the passes, counted from 1.
    pub first_pass: usize,
    /// The last of them.
    pub last_pass: usize,
    /// Where on the pass, mm of path length.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
}

/// Gathers findings of the same kind, message and cure: errors first, then warnings, then notes, each in the order in
/// which they were first found.
pub fn group_findings(findings: &[Finding]) -> Vec<FindingGroup<'_>> {
    let mut groups: Vec<FindingGroup<'_>> = Vec::new();
    for finding in findings {
        let place = FindingPlace {
            first_pass: finding.pass,
            last_pass: finding.pass,
            from_mm: finding.from_mm,
            to_mm: finding.to_mm,
        };
        match groups.iter_mut().find(|group| says_the_same(group.finding, finding)) {
            Some(group) => group.add(place),
            None => groups.push(FindingGroup { finding, places: vec![place] }),
        }
    }
    groups.sort_by_key(|group| std::cmp::Reverse(group.finding.severity()));
    groups
}

fn says_the_same(a: &Finding, b: &Finding) -> bool {
    (a.kind, a.allowed, &a.message, &a.cure) == (b.kind, b.allowed, &b.message, &b.cure)
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
        Finding::note("process", message.to_owned(), pass, range)
    }

    #[test]
    fn equal_findings_are_one_with_all_their_places() {
        let mut findings: Vec<Finding> = (2..=14).map(|pass| note("same", pass, (0.0, 0.0))).collect();
        findings.insert(3, note("same", 2, (5.0, 7.0)));
        findings.push(note("same", 20, (0.0, 0.0)));
        findings.push(note("other", 14, (0.0, 0.0)));
        let groups = group_findings(&findings);
        assert_eq!(groups.iter().map(|g| g.finding.message.as_str()).collect::<Vec<_>>(), ["same", "other"]);
        let place = |first_pass, last_pass, from_mm, to_mm| FindingPlace { first_pass, last_pass, from_mm, to_mm };
        assert_eq!(groups[0].places, [place(2, 14, 0.0, 0.0), place(2, 2, 5.0, 7.0), place(20, 20, 0.0, 0.0)]);
        assert!(groups[0].places[0].is_point() && !groups[0].places[1].is_point());
    }

    #[test]
    fn what_stands_against_the_weld_comes_first() {
        let note = note("note", 1, (0.0, 1.0));
        let warning = Finding { cure: "do".to_owned(), message: "warning".to_owned(), ..note.clone() };
        let error = Finding { allowed: false, message: "error".to_owned(), ..note.clone() };
        let findings = [note.clone(), warning, error, note];
        let messages: Vec<&str> = group_findings(&findings).iter().map(|g| g.finding.message.as_str()).collect();
        assert_eq!(messages, ["error", "warning", "note"]);
    }

    #[test]
    fn another_cure_or_severity_is_another_finding() {
        let one = note("same", 1, (0.0, 1.0));
        let other = Finding { cure: "do".to_owned(), ..one.clone() };
        let against = Finding { allowed: false, ..one.clone() };
        assert_eq!(group_findings(&[one, other, against]).len(), 3);
    }
}
