use super::short_sequence::ShortSequence;
use super::steady_values::check_steady;
use crate::allowed::{between, by_key};
use crate::seam::SeamCurve;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{Bead, Pass, ProcessValues, Role, Sequence, Span, SpanValue, is_before, parts_of};
use serde::{Deserialize, Serialize};

/// Maximum number of tacks on a seam; more are a mistake.
const MAX_TACKS: f64 = 1000.0;

/// Short welds that hold the parts together before anything else is welded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tacks {
    /// Length of a tack, mm.
    pub length_mm: Positive,
    /// Number of tacks on the seam, at least 2; or `pitch_mm`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub count: Option<u32>,
    /// Maximum distance from a tack's middle to the next one's, mm; or `count`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pitch_mm: Option<Positive>,
    /// Distance of tacks from the weld's start, and on an open seam from its end, mm.
    #[serde(default = "clear")]
    pub clear_mm: NonNegative,
    /// Speed, mm/s; that of `[weld]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Positive>,
    /// Process values that differ from those of `[weld.process]`.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub process: ProcessValues,
    /// Times before and after the travel.
    #[serde(default, skip_serializing_if = "ShortSequence::is_usual")]
    pub sequence: ShortSequence,
}

fn clear() -> NonNegative {
    NonNegative::new(5.0).unwrap_or_default()
}

impl Tacks {
    /// Checks the settings that do not depend on the seam; `sequence` and `process` are those of the weld. Fails with
    /// the key's address: neither number nor pitch or both, fewer than two, a process value that the weld does not
    /// have.
    pub(crate) fn check<T>(
        &self,
        file: &Document<T>,
        sequence: &Sequence,
        process: &ProcessValues,
    ) -> Result<(), DocumentError> {
        self.sequence.check(file, "tacks.sequence", sequence, process)?;
        if self.count.is_some() == self.pitch_mm.is_some() {
            let message = Message::new("weld-tack-count-or-pitch");
            return Err(file.error_at("tacks", message, Message::new("weld-allowed-count-or-pitch")));
        }
        if self.count.is_some_and(|count| !(2.0..=MAX_TACKS).contains(&f64::from(count))) {
            let allowed = between(2.0, MAX_TACKS, Unit::One);
            return Err(file.error_at("tacks.count", Message::new("weld-tack-count-invalid"), allowed));
        }
        check_steady(file, "tacks.process", &self.process, process, "weld-tack-ramp")
    }

    /// The tacks on `seam` that start at `starts`, in the order of welding: each far from all before it, then the one
    /// opposite. Values without a setting of their own come from `weld`, the pass along the whole seam. They lie on the
    /// `root` bead of a groove.
    pub(crate) fn passes(&self, starts: &[f64], seam: &SeamCurve, weld: &Pass, root: Option<&Bead>) -> Vec<Pass> {
        // Their metal is not that of the bead, which comes on top.
        let none = |root: &Bead| vec![NonNegative::default(); root.area_mm2.len()];
        let bead = root.map(|root| Bead { area_mm2: none(root), weave_part: Vec::new(), ..root.clone() });
        let pass = |(number, place): (usize, usize)| {
            let begin = starts[place];
            let mut process = weld.span_at(begin).map(|span| span.process.clone()).unwrap_or_default();
            for value in process.values_mut() {
                let there = weld.span_at(begin).map(|span| value.at(span.part(begin)));
                *value = there.and_then(Finite::new).map_or(*value, SpanValue::Steady);
            }
            let speed = self.speed_mm_s.or(Positive::new(weld.speed_at(begin)));
            process.extend(self.process.clone());
            Pass {
                name: format!("tack {}", number + 1),
                role: Some(Role::Tack),
                begin_mm: NonNegative::new(begin).unwrap_or_default(),
                reverse: false,
                least_speed_mm_s: None,
                sequence: self.sequence.of(&weld.sequence),
                bead: bead.clone(),
                weave: None,
                spans: vec![Span {
                    from_mm: NonNegative::default(),
                    to_mm: self.length_mm,
                    speed_mm_s: speed.map_or(weld.spans[0].speed_mm_s, SpanValue::Steady),
                    process,
                }],
                ..weld.clone()
            }
        };
        opposite_first(starts.len(), seam.all_round()).into_iter().enumerate().map(pass).collect()
    }

    /// Path lengths of the tacks' starts, increasing, mm: evenly, with the start in the middle between two on a seam
    /// welded all round, else from end to end. Fails with the key's address: tacks longer than the pitch or too near to
    /// the start.
    pub(crate) fn starts<T>(&self, file: &Document<T>, seam: &SeamCurve) -> Result<Vec<f64>, DocumentError> {
        let (length, clear) = (self.length_mm.get(), self.clear_mm.get());
        let round = seam.all_round();
        // From the first tack's beginning to the last one's, or all round.
        let way = if round { seam.length() } else { seam.weld_length() - 2.0 * clear - length };
        let least = |pitches: f64| if round { pitches.max(2.0) } else { pitches.max(1.0) + 1.0 };
        let count = match (self.count, self.pitch_mm) {
            (Some(count), _) => f64::from(count),
            (None, pitch) => least(parts_of(way, pitch.map_or(way, Positive::get)) as f64),
        };
        if count > MAX_TACKS {
            let allowed = Message::new("weld-allowed-tack-pitch").quantity("min", way / MAX_TACKS, Unit::Mm, 3);
            let allowed = allowed.count("count", MAX_TACKS as usize);
            return Err(file.error_at("tacks.pitch_mm", Message::new("weld-too-many-tacks"), allowed));
        }
        let pitch = if round { way / count } else { way / (count - 1.0) };
        let asked = self.pitch_mm.map_or(pitch, |asked| asked.get().min(pitch));
        if !is_before(length, asked) {
            let allowed = match (self.pitch_mm, round) {
                (Some(pitch), _) if pitch.get() <= length => {
                    by_key("weld-allowed-less-than-key", "pitch_mm", pitch.get())
                }
                _ => {
                    let allowed = Message::new("weld-allowed-tack-length").count("count", count as usize);
                    allowed.quantity("length", seam.length(), Unit::Mm, 3)
                }
            };
            return Err(file.error_at("tacks.length_mm", Message::new("weld-tacks-meet"), allowed));
        }
        let first = if round { 0.5 * (pitch - length) } else { clear };
        if is_before(first, clear) {
            let message = Message::new("weld-tacks-near-start").quantity("distance", first, Unit::Mm, 3);
            let key = file.given_or("tacks.clear_mm", "tacks");
            let allowed = Message::new("weld-allowed-tack-clearance").quantity("max", first, Unit::Mm, 3);
            return Err(file.error_at(key, message, allowed));
        }
        Ok((0..count as usize).map(|i| first + pitch * i as f64).collect())
    }
}

/// An order of `count` positions on a ring or a line: the one farthest from all before it, then the remaining one
/// nearest to its opposite, and again.
fn opposite_first(count: usize, ring: bool) -> Vec<usize> {
    let apart = |a: usize, b: usize| {
        let d = a.abs_diff(b);
        if ring { d.min(count - d) } else { d }
    };
    let mut order: Vec<usize> = Vec::with_capacity(count);
    // Distance of each tack from those in order; `None` for those in order.
    let mut from_all: Vec<Option<usize>> = vec![Some(count); count];
    while order.len() < count {
        let left = || from_all.iter().enumerate().filter_map(|(i, apart)| Some((i, (*apart)?)));
        let Some((next, _)) = left().max_by_key(|(i, apart)| (*apart, usize::MAX - i)) else { break };
        let opposite = if ring { (next + count / 2) % count } else { count - 1 - next };
        let others = left().map(|(i, _)| i).filter(|i| *i != next);
        let second = others.min_by_key(|i| (apart(*i, opposite), *i));
        for taken in std::iter::once(next).chain(second) {
            order.push(taken);
            for (i, nearest) in from_all.iter_mut().enumerate() {
                *nearest = nearest.map(|nearest| nearest.min(apart(i, taken))).filter(|_| i != taken);
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opposite_places_follow_each_other() {
        assert_eq!(opposite_first(4, true), [0, 2, 1, 3]);
        assert_eq!(opposite_first(2, false), [0, 1]);
        assert_eq!(opposite_first(5, false), [0, 4, 2, 1, 3]);
        for count in 2..60 {
            for ring in [true, false] {
                let order = opposite_first(count, ring);
                let mut sorted = order.clone();
                sorted.sort_unstable();
                assert!(sorted.into_iter().eq(0..count), "{count} {order:?}");
                if ring && count % 2 == 0 {
                    assert!(order.chunks(2).all(|p| p[0].abs_diff(p[1]) == count / 2), "{count} {order:?}");
                }
            }
        }
    }
}
