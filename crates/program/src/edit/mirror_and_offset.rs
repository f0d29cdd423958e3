//! Edits of points' positions: mirrored, or moved by the torch's frame.

use super::draft::{Body, Draft, PointRange, PointsDraft, Row, RowSpan, along_seam, through_points};
use super::report::Report;
use crate::arc_through::ArcThrough;
use crate::bead::Bead;
use crate::points::Along;
use crate::step_over::BeadShift;
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_document::{Direction, DocumentError, Finite, NonNegative, Point};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// Mirrors the points of a pass, or of all passes through points: poses about a plane (`at_mm` and `normal`), with the
/// torch's direction; axis positions about the value `about` of one `axis`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mirror {
    /// The pass, from 1; all through points if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<usize>,
    /// A point of the plane, mm; the origin if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_mm: Option<Point>,
    /// Normal of the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Direction>,
    /// The axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<String>,
    /// Its position that stays, mm or degrees; 0 if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<Finite>,
}

/// Moves a pass. Poses: by the frame of direction of travel x, torch direction z, and y across both (z cross x). At a
/// point between two ways the direction of travel is the mean of both. A pass along the seam: its bead.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Offset {
    /// The pass, from 1.
    pub pass: usize,
    /// The first and last point of a pass through points; all if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<[usize; 2]>,
    /// Along the direction of travel, mm.
    #[serde(default)]
    pub dx_mm: Finite,
    /// Across, mm.
    #[serde(default)]
    pub dy_mm: Finite,
    /// Along the torch's direction, mm: greater than 0 towards the work.
    #[serde(default)]
    pub dz_mm: Finite,
    /// Along the seam: added to the bead's `across_mm`.
    #[serde(default)]
    pub across_mm: Finite,
    /// Along the seam: added to its `out_mm`.
    #[serde(default)]
    pub out_mm: Finite,
    /// Along the seam: added to its `work_angle_deg`.
    #[serde(default)]
    pub work_angle_deg: Finite,
}

impl Mirror {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let mut report = Report::new(Message::new("program-edit-mirrored"));
        let plane = match (&self.axis, self.normal) {
            (None, Some(normal)) if self.about.is_none() => {
                Some(MirrorPlane { point: self.at_mm.unwrap_or_default().get(), normal: normal.unit() })
            }
            (Some(_), None) if self.at_mm.is_none() => None,
            _ => {
                return Err(draft.wrong(Message::new("program-mirror-unclear"), Message::new("program-mirror-keys")));
            }
        };
        for pass in draft.numbers(self.pass)? {
            if self.pass.is_none() && matches!(draft.pass(pass)?.body, Body::Seam(_)) {
                continue;
            }
            let points = draft.points(pass)?;
            match (plane, &self.axis, points.places().filter(|_| points.known().pose > 0)) {
                (Some(plane), _, Some(columns)) => points.mirror(&plane, columns),
                (None, Some(axis), None) if points.known().axes.iter().any(|(name, _)| name == axis) => {
                    points.mirror_axis(axis, self.about.unwrap_or_default().get());
                }
                (None, Some(axis), None) => return Err(super::points::unknown_column(draft, pass, axis)),
                (Some(_), ..) => {
                    let message = Message::new("program-points-are-axes").pass("pass", pass);
                    return Err(draft.wrong_in(pass, message, "`axis`, `about`"));
                }
                _ => {
                    let message = Message::new("program-points-are-poses").pass("pass", pass);
                    return Err(draft.wrong_in(pass, message, "`normal`, `at_mm`"));
                }
            }
            report = report.pass(pass);
        }
        if report.touched.is_empty() {
            return Err(draft.wrong(Message::new("program-no-points-pass"), Message::new("program-with-points")));
        }
        Ok(report)
    }
}

/// Plane of a mirror, with a unit normal.
#[derive(Debug, Clone, Copy)]
struct MirrorPlane {
    point: DVec3,
    normal: DVec3,
}

impl PointsDraft {
    fn mirror(&mut self, plane: &MirrorPlane, columns: [usize; 3]) {
        let MirrorPlane { point, normal } = *plane;
        let mirrored = |p: DVec3| p - 2.0 * (p - point).dot(normal) * normal;
        let turned = |d: DVec3| d - 2.0 * d.dot(normal) * normal;
        let directions = self.directions();
        let of_speeds: Vec<[usize; 3]> = [Some(columns), directions]
            .into_iter()
            .flatten()
            .filter_map(|columns| self.among_speeds(columns))
            .collect();
        for row in self.rows_mut() {
            row.set_place(columns, mirrored(row.place(columns)));
            if let Some(columns) = directions {
                row.set_place(columns, turned(row.place(columns)));
            }
        }
        for span in &mut self.spans {
            span.via = span.via.map(mirrored);
            span.normal = span.normal.and_then(|normal| Direction::new(turned(normal.unit())));
            for speeds in span.each_speeds() {
                for among in &of_speeds {
                    let new = turned(DVec3::from_array(among.map(|k| speeds[k])));
                    among.iter().zip(new.to_array()).for_each(|(k, speed)| speeds[*k] = speed);
                }
            }
        }
    }

    fn mirror_axis(&mut self, axis: &str, about: f64) {
        let Some(column) = self.column(axis) else { return };
        self.rows_mut().for_each(|row| row.numbers[column] = 2.0 * about - row.numbers[column]);
        if let Some(k) = self.place_columns().iter().position(|c| *c == column) {
            self.spans.iter_mut().flat_map(RowSpan::each_speeds).for_each(|speeds| speeds[k] = -speeds[k]);
        }
        let Some(k) = ["x", "y", "z"].iter().position(|name| *name == axis) else { return };
        for span in &mut self.spans {
            if let Some(via) = &mut span.via {
                via[k] = 2.0 * about - via[k];
            }
            if let Some(normal) = span.normal {
                let mut turned = normal.unit();
                turned[k] = -turned[k];
                span.normal = Direction::new(turned);
            }
        }
    }

    /// Directions of travel at the start and the end of the way to each point, of unit length; `None` for a way without
    /// length.
    fn tangents(&self, columns: [usize; 3]) -> Vec<Option<(DVec3, DVec3)>> {
        let mut here = self.start.place(columns);
        let mut out = Vec::new();
        let among = self.among_speeds(columns);
        for span in &self.spans {
            let mut begin = &span.begin_speeds;
            for row in &span.rows {
                let there = row.place(columns);
                if let Some(among) = among.filter(|_| span.is_cubic()) {
                    // A cubic with zero speed at an end leaves it towards the other.
                    let travel = |speeds: &[f64]| DVec3::from_array(among.map(|k| speeds[k])).try_normalize();
                    let way = (there - here).try_normalize();
                    out.push(travel(begin).or(way).zip(travel(&row.speeds).or(way)));
                    (here, begin) = (there, &row.speeds);
                    continue;
                }
                let arc = span.via.and_then(|via| ArcThrough::new(here, via, there, span.normal.map(Direction::unit)));
                let ends = arc.map_or((there - here, there - here), |arc| (arc.tangent(0.0), arc.tangent(1.0)));
                out.push(ends.0.try_normalize().zip(ends.1.try_normalize()));
                here = there;
            }
        }
        out
    }

    /// Direction of travel at each point: the mean of the way to it and the way from it.
    fn travel(&self, columns: [usize; 3]) -> Vec<Option<DVec3>> {
        let ways = self.tangents(columns);
        let at = |point: usize| {
            let behind = ways[..point].iter().rev().find_map(|way| way.map(|(_, end)| end));
            let ahead = ways[point..].iter().find_map(|way| way.map(|(begin, _)| begin));
            match (behind, ahead) {
                (Some(a), Some(b)) => (a + b).try_normalize().or(Some(b)),
                (a, b) => a.or(b),
            }
        };
        (0..=ways.len()).map(at).collect()
    }

    /// Moves the points of a range; fails with the number of a point that has no frame.
    fn offset(&mut self, range: PointRange, by: DVec3, columns: [usize; 3]) -> Result<(), usize> {
        let PointRange { from, to } = range;
        let travel = self.travel(columns);
        let rows: Vec<Row> = self.rows().cloned().collect();
        let moved = |place: DVec3, travel: DVec3, direction: DVec3| {
            let across = direction.cross(travel).try_normalize()?;
            Some(place + by.x * travel + by.y * across + by.z * direction)
        };
        let mut new = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            let inside = (from..=to).contains(&i);
            let place = row.place(columns);
            let there = || moved(place, travel[i]?, self.direction(row));
            new.push(if inside { there().ok_or(i)? } else { place });
        }
        let mut first = 0;
        for span in 0..self.spans.len() {
            let (start, end) = (&rows[first], &rows[first + 1]);
            let inside = from <= first && first < to;
            if let (Along::Arc, true, Some(via)) = (self.spans[span].along, inside, self.spans[span].via) {
                let normal = self.spans[span].normal;
                let way = ArcThrough::new(start.place(columns), via, end.place(columns), normal.map(Direction::unit))
                    .ok_or(first + 1)?;
                let part = way.part_of(via);
                let (a, b) = (self.direction(start), self.direction(end));
                let direction = a.lerp(b, part).normalize_or(a);
                self.spans[span].via = Some(moved(via, way.tangent(part).normalize(), direction).ok_or(first + 1)?);
            }
            first += self.spans[span].rows.len();
        }
        let moves: Vec<DVec3> = rows.iter().zip(&new).map(|(row, new)| *new - row.place(columns)).collect();
        self.follow(&moves, columns);
        for (row, place) in self.rows_mut().zip(new) {
            row.set_place(columns, place);
        }
        Ok(())
    }
}

impl Offset {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let by = DVec3::from_array([self.dx_mm, self.dy_mm, self.dz_mm].map(Finite::get));
        let beside = [self.across_mm, self.out_mm, self.work_angle_deg].map(Finite::get);
        let words = Message::new("program-edit-moved").pass("pass", self.pass);
        if matches!(draft.pass(self.pass)?.body, Body::Seam(_)) {
            if by != DVec3::ZERO || self.points.is_some() {
                let allowed = "`across_mm`, `out_mm`, `work_angle_deg`";
                return Err(draft.wrong_in(self.pass, along_seam(self.pass), allowed));
            }
            let pass = &mut draft.pass(self.pass)?.pass;
            let begin = Finite::new(pass.begin_mm.get()).unwrap_or_default();
            pass.bead.get_or_insert_with(|| on_the_seam(begin));
            let [across_mm, out_mm, work_angle_deg] = beside;
            pass.shift_beads(BeadShift { across_mm, out_mm, work_angle_deg });
            return Ok(Report::new(words).pass(self.pass));
        }
        if beside.iter().any(|by| by.abs() > 0.0) {
            return Err(draft.wrong_in(self.pass, through_points(self.pass), "`dx_mm`, `dy_mm`, `dz_mm`"));
        }
        let range = draft.range(self.pass, self.points, 0)?;
        let points = draft.points(self.pass)?;
        let Some(columns) = points.places().filter(|_| points.known().pose > 0) else {
            let message = Message::new("program-offset-of-axes");
            return Err(draft.wrong_in(self.pass, message, Message::new("program-points-with-poses")));
        };
        if let Err(point) = points.offset(range, by, columns) {
            let message = Message::new("program-no-torch-frame").number("point", point as f64, 0);
            return Err(draft.wrong_in(self.pass, message, Message::new("program-torch-across-path")));
        }
        Ok(Report::new(words).points(self.pass, range.from, range.to))
    }
}

/// A bead that lies on the seam, with one row.
fn on_the_seam(begin: Finite) -> Bead {
    let zero = || vec![Finite::default()];
    Bead {
        s_mm: vec![begin],
        across_mm: zero(),
        out_mm: zero(),
        work_angle_deg: zero(),
        weave_part: Vec::new(),
        area_mm2: vec![NonNegative::default()],
    }
}
