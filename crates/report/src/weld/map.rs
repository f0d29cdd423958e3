//! The map of a weld: its passes on the unrolled seam.

use super::run_windows::numbers;
use crate::{Language, MapPiece, MapRow, WeldMap, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_program::{Pass, Role};
use seamwright_weld::{SeamCurve, Welding};

/// Number of angles marked around a closed seam.
const MARKS: u32 = 8;

/// Draws the passes along the seam, on the first of its copies; `None` if all passes go through points.
pub(super) fn map(welding: &Welding, language: Language) -> Option<WeldMap> {
    let (program, seam) = (&welding.program.value, welding.seam.as_ref()?);
    let round = seam.all_round();
    let length_mm = if round { seam.length() } else { seam.weld_length() };
    let on_seam = |pass: &Pass| pass.points.is_none() && pass.copy == 0;
    let passes = (1..).zip(&program.passes).filter(|(_, pass)| on_seam(pass));
    let mut rows: Vec<Row<'_>> = Vec::new();
    for (number, pass) in passes {
        match rows.last_mut().filter(|row| row.takes(pass, length_mm)) {
            Some(row) => row.passes.push((number, pass)),
            None => rows.push(Row { passes: vec![(number, pass)] }),
        }
    }
    if rows.is_empty() {
        return None;
    }
    let mut key = vec![language.words("report-map-key")];
    if program.copies.len() > 1 {
        key.push(Message::new("report-map-copies").count("n", program.copies.len()).in_language(language));
    }
    Some(WeldMap {
        language,
        title: language.words("report-chart-map"),
        key: language.sentences(&key),
        length_mm,
        round,
        marks: if round { marks(seam, language) } else { Vec::new() },
        rows: rows.iter().map(|row| row.drawn(length_mm, language)).collect(),
    })
}

/// Returns the places of angles around the seam, if it goes around a tube or nozzle.
fn marks(seam: &SeamCurve, language: Language) -> Vec<(f64, String)> {
    let mark = |i: u32| {
        let degrees = 360.0 * f64::from(i) / f64::from(MARKS);
        let label = Message::new("quantity").value("value", degrees, Unit::Deg).in_language(language);
        Some((seam.s_of_phi(degrees.to_radians())?, label))
    };
    (0..MARKS).filter_map(mark).collect()
}

/// Passes in one row, each with its number: tacks, or the pieces in which a bead is welded.
struct Row<'a> {
    passes: Vec<(usize, &'a Pass)>,
}

impl Row<'_> {
    /// True if the pass is another tack, or another piece of the same bead.
    fn takes(&self, pass: &Pass, length: f64) -> bool {
        let (_, last) = self.passes[self.passes.len() - 1];
        if pass.known_role() != last.known_role() {
            return false;
        }
        let is_tack = pass.known_role() == Some(Role::Tack);
        let is_beside = |(_, other): &(usize, &Pass)| overlap(pass, other, length) < 0.5 * pass.length();
        is_tack || (pass.bead == last.bead && self.passes.iter().all(is_beside))
    }

    /// Returns the row on a seam of this length: of a pass of several beads all round one turn, where it starts, to where
    /// it stops.
    fn drawn(&self, length: f64, language: Language) -> MapRow {
        let (_, first) = self.passes[0];
        let all: Vec<usize> = self.passes.iter().map(|(number, _)| *number).collect();
        let name = self.passes.iter().fold(first.name.as_str(), |name, (_, pass)| common(name, &pass.name));
        let piece = |(number, pass): &(usize, &Pass)| MapPiece {
            start_mm: pass.seam_s(0.0),
            stop_mm: pass.seam_s(pass.length() - pass.step_overs.len() as f64 * length),
            label: number.to_string(),
        };
        MapRow {
            name: format!("{}: {}", numbers(&all, language), name.trim_end_matches([' ', ','])),
            colour: match first.known_role() {
                Some(Role::Tack | Role::Root) => 2,
                Some(Role::Cap | Role::Cosmetic) => 3,
                Some(Role::Fill) | None => 1,
            },
            pieces: self.passes.iter().map(piece).collect(),
        }
    }
}

/// Returns the length that both passes weld on a seam of this length, mm, if neither is longer than it.
fn overlap(a: &Pass, b: &Pass, length: f64) -> f64 {
    let ends = |pass: &Pass| {
        let (from, to) = (pass.seam_s(0.0), pass.seam_s(pass.length()));
        (from.min(to), from.max(to))
    };
    let ((a0, a1), (b0, b1)) = (ends(a), ends(b));
    let shifted = |turns: f64| (a1.min(b1 + turns * length) - a0.max(b0 + turns * length)).max(0.0);
    [-1.0, 0.0, 1.0].map(shifted).into_iter().sum()
}

/// Returns what two names have in common at their start.
fn common<'a>(a: &'a str, b: &str) -> &'a str {
    let equal = a.char_indices().zip(b.chars()).find(|((_, x), y)| x != y).map(|((i, _), _)| i);
    &a[..equal.unwrap_or_else(|| a.len().min(b.len()))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Drawing as _;

    const SADDLE: &str = include_str!("../../../../examples/thick-saddle.toml");

    #[test]
    fn every_pass_has_a_piece_and_every_bead_a_row() {
        let welding = Welding::read("thick-saddle.toml", SADDLE).unwrap();
        let map = map(&welding, Language::English).unwrap();
        let passes = &welding.program.value.passes;
        let pieces: Vec<&MapPiece> = map.rows.iter().flat_map(|row| &row.pieces).collect();
        assert_eq!(pieces.len(), passes.len());
        for (piece, pass) in pieces.iter().zip(passes) {
            assert!(((piece.stop_mm - piece.start_mm).abs() - pass.length()).abs() < 1e-9);
        }
        assert_eq!(map.rows.len(), passes.len() - 3, "four tacks are in one row");
        assert_eq!(map.rows[0].name, "1 to 4: tack");
        assert_eq!(map.rows[1].name, "5: root 1");
        assert_eq!(map.marks.len(), 8);
        assert!(map.to_svg().contains("1 to 4: tack"));
    }

    #[test]
    fn quarters_of_a_bead_are_in_one_row() {
        let text = format!("{SADDLE}\n[order]\nparts = \"quadrants\"\n");
        let welding = Welding::read("quarters.toml", &text).unwrap();
        let map = map(&welding, Language::English).unwrap();
        let quarters = map.rows.iter().skip(1).map(|row| row.pieces.len());
        assert!(quarters.clone().all(|n| n == 4), "{:?}", quarters.collect::<Vec<_>>());
    }

    #[test]
    fn names_have_a_common_start() {
        assert_eq!(common("tack 1", "tack 2"), "tack ");
        assert_eq!(common("fill 2.1", "fill 2.1"), "fill 2.1");
        assert_eq!(common("ж1", "ж"), "ж");
        assert_eq!(common("", "a"), "");
    }
}
