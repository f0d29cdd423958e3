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
    (&a.kind, a.allowed) == (&b.kind, b.allowed)
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
