use crate::seam::SAME_MM;
use crate::{SeamCurve, SeamPoint};
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::MonotoneCurve;
use seamwright_program::{Finding, Torch};

/// Largest travel angle, degrees: beyond it the torch lies along the seam.
const MAX_TRAVEL_DEG: f64 = 75.0;

/// The torch's direction may turn by this at a place, rad: less is rounding.
const JUMP: f64 = 1e-6;

/// Torch angles along a weld: work angle as an offset from the bisector, and travel angle (AWS A3.0), rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Attitude {
    work: MonotoneCurve,
    travel: MonotoneCurve,
}

impl Attitude {
    /// The angles that `torch`, at `path` in `file`, gives along `seam`. Between the places where they are given they
    /// go smoothly from one value to the next and never beyond either, repeating if the seam is welded all round.
    ///
    /// # Errors
    /// With the key's address: angles out of range, places that do not increase or lie outside the weld.
    pub fn new<T>(file: &Document<T>, path: &str, torch: &Torch, seam: &SeamCurve) -> Result<Self, DocumentError> {
        let mut rows = Vec::new();
        for (i, at) in torch.at.iter().enumerate() {
            let (s, key) = (at.s_mm.get(), format!("{path}.at[{i}]"));
            let end = if seam.all_round() { seam.length() } else { seam.weld_length() };
            let inside = s >= 0.0 && (s < end || (s <= end && !seam.all_round()));
            if !inside {
                let or_end = if seam.all_round() { "less than" } else { "up to" };
                let allowed = format!("from 0 {or_end} {end:.6}");
                return Err(file.error_at(&format!("{key}.s_mm"), "this place is not on the weld", allowed));
            }
            if rows.last().is_some_and(|(last, ..): &(f64, f64, f64)| *last >= s) {
                let message = "the places must increase";
                return Err(file.error_at(&format!("{key}.s_mm"), message, "more than the one before"));
            }
            rows.push((s, at.work_angle_deg.get(), at.travel_angle_deg.get()));
            check_angles(file, &key, rows[i].1, rows[i].2)?;
        }
        if rows.is_empty() {
            rows.push((0.0, torch.work_angle_deg.get(), torch.travel_angle_deg.get()));
            check_angles(file, path, rows[0].1, rows[0].2)?;
        } else if torch.work_angle_deg.get() != 0.0 || torch.travel_angle_deg.get() != 0.0 {
            let message = "angles are given both constant and at several places";
            return Err(file.error_at(path, message, "either the constant angles or [[torch.at]]"));
        }
        let curve_of = |value: fn(&(f64, f64, f64)) -> f64| {
            let points: Vec<_> = rows.iter().map(|r| (r.0, value(r).to_radians())).collect();
            let curve = match seam.all_round() {
                true => MonotoneCurve::periodic(&points, seam.length()),
                false => MonotoneCurve::level(&points),
            };
            curve.map_err(|e| file.error_at(path, e.to_string(), "places that increase"))
        };
        Ok(Self { work: curve_of(|r| r.1)?, travel: curve_of(|r| r.2)? })
    }

    /// Work angle (offset from the bisector) and travel angle at path length `s`, rad.
    pub fn angles(&self, s: f64) -> (f64, f64) {
        (self.work.at(s), self.travel.at(s))
    }

    /// Unit vector from the joint to the torch at a point of the seam: the bisector turned about the tangent by the
    /// work angle, then in the plane of that and the tangent by the travel angle.
    pub fn torch_axis(&self, p: &SeamPoint) -> DVec3 {
        let (work, travel) = self.angles(p.s);
        let across = work.cos() * p.bisector + work.sin() * p.towards_first;
        travel.cos() * across + travel.sin() * p.along
    }

    /// Where a second derivative of the angles may jump, within (0, `end`) mm, increasing.
    pub(crate) fn knots(&self, end: f64) -> Vec<f64> {
        let knots = self.work.knots();
        let turns = self.work.period().map_or(0, |period| (end / period).ceil() as usize);
        let period = self.work.period().unwrap_or(0.0);
        let all = (0..=turns).flat_map(|k| knots.iter().map(move |x| x + k as f64 * period));
        let mut inside: Vec<f64> = all.filter(|x| *x > 1e-6 && *x < end - 1e-6).collect();
        inside.sort_by(f64::total_cmp);
        inside.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        inside
    }

    /// Corners of the seam at which the torch's direction would jump.
    pub fn turn_findings(&self, seam: &SeamCurve, pass: usize) -> Vec<Finding> {
        let jump = |s: f64| {
            let [before, after] = [s - SAME_MM, s + SAME_MM].map(|s| self.torch_axis(&seam.at(s)));
            2.0 * (before - after).length().atan2((before + after).length())
        };
        let turns = seam.knots().into_iter().map(|s| (s, jump(s))).filter(|(_, turn)| *turn > JUMP);
        let finding = |(s, turn): (f64, f64)| Finding {
            kind: "turn",
            message: format!(
                "the torch's direction would jump by {:.2} degrees at the corner at s = {s:.3} mm",
                turn.to_degrees()
            ),
            pass,
            from_mm: s,
            to_mm: s,
            cure: "round the corner in the seam; in a butt joint weld without work and travel angle".to_owned(),
            allowed: false,
        };
        turns.map(finding).collect()
    }

    /// Where the torch would lie in one of the two faces.
    pub fn access_findings(&self, seam: &SeamCurve, pass: usize) -> Vec<Finding> {
        let n = 720;
        let step = seam.weld_length() / f64::from(n);
        let mut findings: Vec<Finding> = Vec::new();
        let mut open = false;
        for i in 0..=n {
            let p = seam.at(f64::from(i) * step);
            let axis = self.torch_axis(&p);
            let (part, sine) =
                if axis.dot(p.n1) < axis.dot(p.n2) { ("first", axis.dot(p.n1)) } else { ("second", axis.dot(p.n2)) };
            if sine > 0.0 {
                open = false;
                continue;
            }
            match findings.last_mut().filter(|_| open) {
                Some(last) => last.to_mm = p.s,
                None => findings.push(Finding {
                    kind: "access",
                    message: format!(
                        "the torch would lie {:.1} degrees inside the face of the {part} part (dihedral angle {:.1} degrees)",
                        -sine.asin().to_degrees(),
                        p.dihedral.to_degrees()
                    ),
                    pass,
                    from_mm: p.s,
                    to_mm: p.s,
                    cure: "make the work angle smaller than half the dihedral angle".to_owned(),
                    allowed: false,
                }),
            }
            open = true;
        }
        findings
    }
}

fn check_angles<T>(file: &Document<T>, path: &str, work: f64, travel: f64) -> Result<(), DocumentError> {
    if travel.abs() > MAX_TRAVEL_DEG {
        let allowed = format!("-{MAX_TRAVEL_DEG} (push) to {MAX_TRAVEL_DEG} (drag)");
        return Err(file.error_at(&format!("{path}.travel_angle_deg"), "the torch would lie along the seam", allowed));
    }
    if work.abs() >= 90.0 {
        let message = "the torch would lie behind a face";
        return Err(file.error_at(&format!("{path}.work_angle_deg"), message, "more than -90 and less than 90"));
    }
    Ok(())
}
