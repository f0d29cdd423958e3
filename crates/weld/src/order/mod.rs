//! Order of welding: copies of a seam, tacks, and the parts of each pass.
//!
//! A job's passes are those along one seam. Each is cut into its parts (`parts.rs`). A rule puts the welds of one visit
//! to a copy in order with those of the other copies (`tour.rs`). Tacks (`tacks.rs`) come before all others, the
//! cosmetic pass (`cosmetic.rs`) is the last of a visit.

mod cosmetic;
mod file;
mod parts;
mod rows;
mod short_sequence;
mod steady_values;
mod tacks;
#[cfg(test)]
mod tests;
mod tour;

pub use cosmetic::Cosmetic;
pub use file::{Parts, Rule, Turns, WeldOrder};
pub use rows::Rows;
pub use short_sequence::ShortSequence;
pub use tacks::Tacks;

use crate::job::Job;
use crate::seam::SeamCurve;
use glam::{DAffine3, DVec3};
use seamwright_document::{Document, DocumentError, Transform};
use seamwright_message::Message;
use seamwright_program::{MAX_PASSES, MAX_ROWS, Pass, SeamCopy};
use tour::{Leg, Stop, in_rows, tour};

/// Passes that are welded on a copy before the torch goes on to the next one, each with its parts.
type Visit = Vec<Vec<Pass>>;

impl WeldOrder {
    /// Checks the rule against the copies. Fails with the key's address: missing rows to go back and forth between, a
    /// skip over none or all.
    pub(crate) fn check_rule<T>(&self, file: &Document<T>, copies: &[SeamCopy]) -> Result<(), DocumentError> {
        let rows = in_rows(&copies.iter().map(|copy| Stop { row: row(copy), ways: Vec::new() }).collect::<Vec<_>>());
        match self.rule {
            Rule::BackAndForth if rows.len() < 2 => {
                let message = Message::new("weld-order-without-rows");
                Err(file.error_at("order.rule", message, Message::new("weld-allowed-two-rows")))
            }
            Rule::Skip(every) => {
                let most = rows.iter().map(Vec::len).max().unwrap_or(1).saturating_sub(1);
                if (2..=most).contains(&every) {
                    return Ok(());
                }
                let allowed = match most {
                    0 | 1 => Message::new("weld-allowed-no-skip"),
                    _ => Message::new("weld-allowed-skip").count("max", most).count("copies", most + 1),
                };
                Err(file.error_at("order.rule.skip", Message::new("weld-skip-invalid"), allowed))
            }
            _ => Ok(()),
        }
    }
}

fn row(copy: &SeamCopy) -> u32 {
    copy.row.map_or(1, std::num::NonZeroU32::get)
}

/// The copies of a job: listed or in rows; empty if the seam is welded once. Fails with the key's address: copies given
/// twice, and all faults in them.
pub(crate) fn copies(job: &Document<Job>) -> Result<Vec<SeamCopy>, DocumentError> {
    let j = &job.value;
    let copies = match &j.rows {
        Some(_) if !j.copies.is_empty() => {
            let allowed = Message::new("weld-allowed-rows-or-copies");
            return Err(job.error_at("rows", Message::new("weld-copies-twice"), allowed));
        }
        Some(rows) => {
            rows.check(job, &j.placement)?;
            rows.copies(&j.placement)
        }
        None => {
            SeamCopy::check(job, &j.copies, &j.placement)?;
            j.copies.clone()
        }
    };
    if let Some(order) = &j.order {
        order.check_rule(job, &copies)?;
    }
    Ok(copies)
}

/// The passes of `job` on all its copies in the order of welding. Each has the index of its origin among `passes`
/// (those along one seam); tacks have `None`. `weld` is the pass along the whole seam. Fails with the key's address:
/// parts or tacks that the seam has no room for.
pub(crate) fn ordered(
    job: &Document<Job>,
    seam: &SeamCurve,
    passes: &[Pass],
    weld: &Pass,
    copies: &[SeamCopy],
) -> Result<Vec<(Pass, Option<usize>)>, DocumentError> {
    let j = &job.value;
    let order = j.order.unwrap_or_default();
    order.check_parts(job, seam)?;
    if order.parts != Parts::Whole && j.beads.as_ref().is_some_and(|beads| beads.step_over_mm.is_some()) {
        let message = Message::new("weld-step-over-with-parts");
        return Err(job.error_at("order.parts", message, Message::verbatim("\"whole\"")));
    }
    let named = Naming { copies, one: passes.len() == 1 };
    let mut ordering = Ordering { seam, order, places: places(copies), named, last: None, done: Vec::new() };
    // Counted before they are made: tacks and welds together are the passes of the program.
    let mut extent = Extent::default();
    if let Some(tacks) = &j.tacks {
        let root = passes.first().and_then(|pass| pass.bead.as_ref());
        let starts = tacks.starts(job, seam)?;
        extent.add(starts.len(), 1 + root.map_or(0, |root| root.s_mm.len()));
        extent.check(job, "tacks", copies)?;
        let tacks: Visit = tacks.passes(&starts, seam, weld, root).into_iter().map(|tack| vec![tack]).collect();
        ordering.add(&tacks, None);
    }
    // Each part has all rows of its pass.
    passes.iter().for_each(|pass| extent.add(order.count_parts(pass, seam), pass.rows()));
    extent.check(job, multiplying_table(j), copies)?;
    let welds: Visit = passes.iter().map(|pass| order.parts_of(pass, seam)).collect();
    match order.passes {
        Turns::CopyByCopy => ordering.add(&welds, Some(0)),
        Turns::PassByPass => {
            for (i, pass) in welds.into_iter().enumerate() {
                ordering.add(&vec![pass], Some(i));
            }
        }
    }
    Ok(ordering.done)
}

/// The table of the job that multiplies its passes: one that is in the file.
fn multiplying_table(job: &Job) -> &'static str {
    match job {
        Job { order: Some(_), .. } => "order",
        Job { beads: Some(_), .. } => "beads",
        Job { rows: Some(_), .. } => "rows",
        Job { copies, .. } if !copies.is_empty() => "copies",
        _ => "weld",
    }
}

/// Passes on one copy of the seam, and their rows, counted before they are made.
#[derive(Debug, Clone, Copy, Default)]
struct Extent {
    passes: usize,
    rows: usize,
}

impl Extent {
    fn add(&mut self, passes: usize, rows: usize) {
        self.passes = self.passes.saturating_add(passes);
        self.rows = self.rows.saturating_add(passes.saturating_mul(rows));
    }

    /// Refuses more passes or rows on all `copies` than a program holds, at the table `key`.
    fn check(self, job: &Document<Job>, key: &str, copies: &[SeamCopy]) -> Result<(), DocumentError> {
        let times = copies.len().max(1);
        let (passes, rows) = (self.passes.saturating_mul(times), self.rows.saturating_mul(times));
        if passes > MAX_PASSES {
            let message = Message::new("weld-too-many-passes").count("passes", passes);
            return Err(job.error_at(key, message, Message::new("weld-allowed-passes").count("max", MAX_PASSES)));
        }
        if rows > MAX_ROWS {
            let message = Message::new("weld-too-many-rows").count("passes", passes).count("rows", rows);
            return Err(job.error_at(key, message, Message::new("weld-allowed-row-count").count("max", MAX_ROWS)));
        }
        Ok(())
    }
}

/// Row and frame of each copy, in the part's frame; a single one without copies.
fn places(copies: &[SeamCopy]) -> Vec<(u32, DAffine3)> {
    match copies {
        [] => vec![(1, Transform::default().affine())],
        copies => copies.iter().map(|copy| (row(copy), copy.placement.affine())).collect(),
    }
}

/// Passes being put in order.
struct Ordering<'a> {
    seam: &'a SeamCurve,
    order: WeldOrder,
    places: Vec<(u32, DAffine3)>,
    named: Naming<'a>,
    /// Position of the torch in the part's frame.
    last: Option<DVec3>,
    done: Vec<(Pass, Option<usize>)>,
}

impl Ordering<'_> {
    /// Adds a visit to every copy; its first pass comes from number `origin`, if from any.
    fn add(&mut self, visit: &Visit, origin: Option<usize>) {
        let turn = self.seam.all_round().then(|| self.seam.length());
        let turned = |parts: &Vec<Pass>| parts.iter().rev().map(|part| part.turned(turn)).collect();
        let mut ways = vec![visit.clone()];
        if self.order.either_end && origin.is_some() {
            ways.push(visit.iter().map(turned).collect());
        }
        let ends: Vec<(DVec3, DVec3)> = ways.iter().filter_map(|visit| self.ends(visit)).collect();
        let stop = |(row, place): &(u32, DAffine3)| {
            let placed = |p: &(DVec3, DVec3)| (place.transform_point3(p.0), place.transform_point3(p.1));
            Stop { row: *row, ways: ends.iter().map(placed).collect() }
        };
        let stops: Vec<Stop> = self.places.iter().map(stop).collect();
        let legs: Vec<Leg> = tour(&stops, self.order.rule, self.last);
        for &(copy, way) in &legs {
            for (i, parts) in ways[way].iter().enumerate() {
                for (k, part) in parts.iter().enumerate() {
                    let name = self.named.name(part, copy, (parts.len() > 1).then_some(k + 1));
                    self.done.push((Pass { name, copy, ..part.clone() }, origin.map(|origin| origin + i)));
                }
            }
        }
        self.last = legs.last().map(|&(copy, way)| stops[copy].ways[way].1);
    }

    fn ends(&self, visit: &Visit) -> Option<(DVec3, DVec3)> {
        let (first, last) = (visit.first()?.first()?, visit.last()?.last()?);
        Some((self.seam.at(first.seam_s(0.0)).point, self.seam.at(last.seam_s(last.length())).point))
    }
}

/// Names of passes: their kind, copy and part.
struct Naming<'a> {
    copies: &'a [SeamCopy],
    /// True if a copy has one pass, which has the copy's name.
    one: bool,
}

impl Naming<'_> {
    fn name(&self, pass: &Pass, copy: usize, part: Option<usize>) -> String {
        let copy = self.copies.get(copy).map(|copy| copy.name.clone());
        let own = (!self.one || copy.is_none() || pass.role.is_some()).then(|| pass.name.clone());
        [own, copy, part.map(|k| format!("part {k}"))].into_iter().flatten().collect::<Vec<_>>().join(", ")
    }
}
