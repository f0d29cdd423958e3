use crate::allowed::{between, more_than, on_weld, strictly_between};
use crate::periodic_places::repeated;
use crate::seam::{SeamCurve, SeamPoint};
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::MonotoneCurve;
use seamwright_message::{Message, Unit};
use seamwright_program::{PathRange, SAME_POSITION_MM, Torch, is_before, is_beyond, is_same_position};

/// Largest travel angle, degrees: beyond it the torch lies along the seam.
const MAX_TRAVEL_DEG: f64 = 75.0;

/// Torch angles along a weld: work angle as an offset from the bisector, and travel angle (AWS A3.0), rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Attitude {
    work: MonotoneCurve,
    travel: MonotoneCurve,
}

impl Attitude {
    /// The angles that `torch`, at `path` in `file`, gives along `seam`. Between given positions they change smoothly
    /// and stay between the two values. They repeat if the seam is welded all round.
    ///
    /// # Errors
    /// With the key's address: angles out of range, positions that do not increase or lie outside the weld.
    pub fn new<T>(file: &Document<T>, path: &str, torch: &Torch, seam: &SeamCurve) -> Result<Self, DocumentError> {
        let mut rows = Vec::new();
        for (i, at) in torch.at.iter().enumerate() {
            let (s, key) = (at.s_mm.get(), format!("{path}.at[{i}]"));
            let end = if seam.all_round() { seam.length() } else { seam.weld_length() };
            // On a seam welded all round its end is its start, which has a row of its own.
            let is_end = seam.all_round() && is_same_position(s, end);
            if is_before(s, 0.0) || is_beyond(s, end) || is_end {
                let message = Message::new("weld-position-beside-weld");
                return Err(file.error_at(&format!("{key}.s_mm"), message, on_weld(end, seam.all_round())));
            }
            if let Some((last, ..)) = rows.last().filter(|(last, ..): &&(f64, f64, f64)| !is_beyond(s, *last)) {
                let message = Message::new("weld-positions-must-increase");
                return Err(file.error_at(&format!("{key}.s_mm"), message, more_than(*last, Unit::Mm)));
            }
            rows.push((s, at.work_angle_deg.get(), at.travel_angle_deg.get()));
            check_angles(file, &key, rows[i].1, rows[i].2)?;
        }
        if rows.is_empty() {
            rows.push((0.0, torch.work_angle_deg.get(), torch.travel_angle_deg.get()));
            check_angles(file, path, rows[0].1, rows[0].2)?;
        } else if torch.work_angle_deg.get() != 0.0 || torch.travel_angle_deg.get() != 0.0 {
            let message = Message::new("weld-angles-twice");
            return Err(file.error_at(path, message, Message::new("weld-allowed-angles-once")));
        }
        if let Some(search) = torch.search {
            let limits = [("max_work_deg", search.max_work_deg, 60.0), ("max_travel_deg", search.max_travel_deg, 45.0)];
            if let Some((key, _, max)) = limits.into_iter().find(|(_, value, max)| value.get() > *max) {
                let message = Message::new("weld-torch-search-too-wide");
                return Err(file.error_at(&format!("{path}.search.{key}"), message, between(0.0, max, Unit::Deg)));
            }
        }
        let curve_of = |value: fn(&(f64, f64, f64)) -> f64| {
            let points: Vec<_> = rows.iter().map(|r| (r.0, value(r).to_radians())).collect();
            MonotoneCurve::new(&points, seam.all_round().then(|| seam.length()))
                .map_err(|e| file.error_at(path, e.message(), Message::new("weld-allowed-positions-increasing")))
        };
        Ok(Self { work: curve_of(|r| r.1)?, travel: curve_of(|r| r.2)? })
    }

    /// Work angle (offset from the bisector) and travel angle at path length `s`, rad.
    pub fn angles(&self, s: f64) -> (f64, f64) {
        (self.work.at(s), self.travel.at(s))
    }

    /// Unit vector from the joint to the torch at a point of the seam: the bisector turned about the tangent by the
    /// work angle and `lean` (rad), then in the plane of that and the tangent by the travel angle. The torch travels
    /// along the weld's direction (`sense` 1) or against it (-1).
    pub fn leaning(&self, p: &SeamPoint, lean: f64, sense: f64) -> DVec3 {
        let (work, travel) = self.angles(p.s);
        let work = work + lean;
        let across = work.cos() * p.bisector + work.sin() * p.towards_first;
        travel.cos() * across + travel.sin() * (sense * p.along)
    }

    /// Positions inside `range` of the seam at which a second derivative of the angles may jump, mm.
    pub(crate) fn knots_within(&self, range: PathRange) -> Vec<f64> {
        repeated(self.work.knots().iter().copied(), self.work.period(), range, SAME_POSITION_MM)
    }
}

/// Checks the angles (degrees) in the table `path` of a file. Fails with the key's address.
pub(crate) fn check_angles<T>(file: &Document<T>, path: &str, work: f64, travel: f64) -> Result<(), DocumentError> {
    if travel.abs() > MAX_TRAVEL_DEG {
        let message = Message::new("weld-travel-angle-too-large");
        let push = Message::new("weld-allowed-travel-angle").value("min", -MAX_TRAVEL_DEG, Unit::Deg);
        let allowed = push.value("max", MAX_TRAVEL_DEG, Unit::Deg);
        return Err(file.error_at(&format!("{path}.travel_angle_deg"), message, allowed));
    }
    if work.abs() >= 90.0 {
        let message = Message::new("weld-work-angle-too-large");
        let allowed = strictly_between(-90.0, 90.0, Unit::Deg);
        return Err(file.error_at(&format!("{path}.work_angle_deg"), message, allowed));
    }
    Ok(())
}
