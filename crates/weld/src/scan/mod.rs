//! The groove in a measured profile: root gap, mismatch, groove angle, dihedral angle and the area that is still open,
//! each with its standard uncertainty.
//!
//! **Model.** The profile is compared with the surface that the joint's own cross-section shows to the sensor
//! (`surface`): both faces, the edges above the metal, and the metal's surface as a parabola after a layer. Unknown are
//! the sensor's pose in the plane of the section and the sizes of the groove that differ from part to part. All other
//! sizes are those of the drawing: the root gap is measured where the edges' lines reach the drawn root.
//!
//! **Estimate.** A coarse search finds the pose (`start`), iteratively reweighted least squares with Tukey's weights the
//! sizes (`fit`; Huber and Ronchetti, Robust Statistics, 2009). Points farther than four standard deviations are then
//! left out, and the rest is fitted by plain least squares. The drawn sizes take part as measurements with the tolerance of
//! a shop, so that a size that a profile does not show keeps its drawn value and has that uncertainty.
//!
//! **Uncertainty.** That of linear least squares: the inverse of the normal matrix with the scatter of the points
//! themselves, times their correlation length (GUM, JCGM 100:2008, 5.2). So a part that does not look like its drawing has
//! larger uncertainties.
//!
//! **Open area.** From the line from toe to toe down to the edges of the fitted section, and to the points themselves
//! where metal is (`area`).

mod area;
mod fit;
mod start;
mod surface;
#[cfg(test)]
mod tests;

use crate::joint::{Groove, SeamJoint};
use crate::seam::SeamPoint;
use fit::Fit;
use glam::DVec2;
use seamwright_message::{Message, Unit, display_by_message};
use seamwright_program::Preparation;
use surface::{ANGLE, DIHEDRAL, Fixed, GAP, MISMATCH, Unknowns};

/// Minimum number of points of a profile.
const FEWEST: usize = 40;
/// Minimum part of the points within four standard deviations of the groove.
const MIN_SHARE: f64 = 0.5;
/// Maximum scatter of the points, mm: a profile that is rougher does not show this groove.
const MAX_SCATTER_MM: f64 = 0.5;
/// Maximum deviation of an angle from the drawing, rad: four times the tolerance of a shop.
const MAX_TURN: f64 = 0.14;
/// Maximum standard uncertainty of the open area as a part of the groove's.
const MAX_UNCERTAINTY: f64 = 0.05;
/// Maximum open part of a groove with a layer in it: where nothing is filled, no metal was found.
const MAX_OPEN: f64 = 0.98;
/// Profiles with more points are thinned for the fit, not for the area.
const MAX_FITTED: usize = 500;

/// One point in so many is used to compare poses.
const COMPARED: usize = 3;

/// Poses that are compared again with other root gaps, and their deviations from the drawing, mm.
const KEPT: usize = 2;
const GAPS_MM: [f64; 2] = [1.2, -1.2];

/// A value with its standard uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Estimate.
    pub value: f64,
    /// Standard uncertainty (one standard deviation).
    pub uncertainty: f64,
}

/// The groove in one profile. Lengths in mm, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrooveScan {
    /// Root gap, where the edges' lines reach the drawn root. As drawn in joints whose gap no profile shows.
    pub gap: Measured,
    /// Height of the second part over the first. 0 in joints without mismatch.
    pub mismatch: Measured,
    /// Groove angle as the preparation's `angle_deg` counts it; `None` without bevelled edges.
    pub angle: Option<Measured>,
    /// Dihedral angle of the faces.
    pub dihedral: Measured,
    /// Area of the groove without any metal, up to the line from toe to toe.
    pub area: Measured,
    /// Area that is still open; that of the groove before the weld.
    pub remaining: Measured,
    /// Scatter of the points about the groove, mm.
    pub scatter: f64,
    /// Part of the points that lie on the groove.
    pub share: f64,
}

/// Reason why a profile has no measured groove.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoScan {
    /// Too few points.
    TooFewPoints(usize),
    /// No pose of the groove fits the profile.
    NoGroove {
        /// Part of the points that lie on the best one.
        share: f64,
        /// Their scatter, mm.
        scatter: f64,
    },
    /// The open area is uncertain by so much, mm^2.
    Uncertain(f64),
    /// The dihedral or groove angle of the best one is far from the drawn one, rad.
    OtherAngle {
        /// Estimate.
        angle: f64,
        /// Drawn.
        drawn: f64,
    },
}

impl NoScan {
    /// Returns the description of the reason.
    pub fn message(&self) -> Message {
        match *self {
            Self::TooFewPoints(found) => {
                Message::new("weld-scan-too-few-points").count("found", found).count("needed", FEWEST)
            }
            Self::NoGroove { share, scatter } => Message::new("weld-scan-no-groove")
                .number("share", 100.0 * share, 0)
                .number("scatter", scatter.min(99.0), 2),
            Self::Uncertain(area) => Message::new("weld-scan-uncertain").quantity("uncertainty", area, Unit::Mm2, 1),
            Self::OtherAngle { angle, drawn } => Message::new("weld-scan-other-angle")
                .quantity("angle", angle.to_degrees(), Unit::Deg, 1)
                .quantity("drawn", drawn.to_degrees(), Unit::Deg, 1),
        }
    }
}

display_by_message!(NoScan);

/// Position of the sensor over the joint.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SensorView {
    /// True if the profile's y runs from the first part to the second; usually it runs from the second to the first.
    pub mirrored: bool,
    /// Angle from [`Section::view`](crate::Section::view) to the sensor's z, rad, positive towards the first part: known
    /// within 15 degrees.
    pub turn: f64,
}

/// Measures grooves in profiles along a joint.
#[derive(Debug, Clone)]
pub struct GrooveScanner<'a> {
    joint: &'a SeamJoint,
    /// True after the first layer: there is metal in the groove.
    welded: bool,
    view: SensorView,
    /// The last fit, from which the next one starts.
    last: Option<Fit>,
}

impl<'a> GrooveScanner<'a> {
    /// Creates a scanner of a joint; `None` if profiles do not show its sizes (square and one-sided butt joints, flares).
    pub fn new(joint: &'a SeamJoint, welded: bool, view: SensorView) -> Option<Self> {
        surface::free_sizes(&joint.joint().preparation)?;
        Some(Self { joint, welded, view, last: None })
    }

    /// Names of the preparations that can be measured.
    pub const KINDS: &'static str = "single_v, u, fillet, t_bevel, t_j";

    /// Measures the groove in a profile of points (y, z), mm, z towards the sensor; points that are not finite count as
    /// missing. `p` is the station of the seam.
    ///
    /// # Errors
    /// The reason why the profile does not show the groove.
    pub fn measure(&mut self, p: &SeamPoint, points: &[DVec2]) -> Result<GrooveScan, NoScan> {
        let side = if self.view.mirrored { -1.0 } else { 1.0 };
        let mut points: Vec<DVec2> =
            points.iter().filter(|p| p.is_finite()).map(|p| DVec2::new(side * p.x, p.y)).collect();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        if points.len() < FEWEST {
            return Err(NoScan::TooFewPoints(points.len()));
        }
        let fixed = Fixed::new(self.joint, p, self.welded);
        let thinned: Vec<DVec2> = points.iter().copied().step_by(points.len().div_ceil(MAX_FITTED)).collect();
        let warm = self.last.as_ref().and_then(|last| Fit::new(&fixed, &thinned, last.unknowns));
        let warm = warm.filter(Fit::is_good).and_then(|fit| Some((judged(&fixed, &fit, &points).ok()?, fit)));
        let (scan, fit) = match warm {
            Some(found) => found,
            None => {
                let fit = self.search(&fixed, &thinned);
                let fit = fit.ok_or(NoScan::NoGroove { share: 0.0, scatter: f64::INFINITY })?;
                (judged(&fixed, &fit, &points)?, fit)
            }
        };
        self.last = Some(fit);
        Ok(scan)
    }

    /// The best fit from a coarse search.
    fn search(&self, fixed: &Fixed, points: &[DVec2]) -> Option<Fit> {
        // Few points are enough to compare poses and gaps.
        let few: Vec<DVec2> = points.iter().copied().step_by(COMPARED).collect();
        let rough = |start: Unknowns| fit::rough_fit(fixed, &few, start);
        let mut fits: Vec<(f64, Unknowns)> =
            start::starts(fixed, points, self.view.turn).into_iter().filter_map(rough).collect();
        fits.sort_by(|a, b| a.0.total_cmp(&b.0));
        fits.truncate(KEPT);
        if fixed.free.contains(&GAP) {
            let moved = |u: &Unknowns, gap: f64| {
                let mut u = *u;
                u[GAP] = (fixed.drawn.gap + gap).max(0.0);
                u
            };
            let others: Vec<Unknowns> = fits.iter().flat_map(|(_, u)| GAPS_MM.map(|gap| moved(u, gap))).collect();
            fits.extend(others.into_iter().filter_map(rough));
        }
        let (_, best) = fits.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
        Fit::new(fixed, points, best)
    }
}

/// The scan of a fit, or the reason why the fit is not this groove.
fn judged(fixed: &Fixed, fit: &Fit, points: &[DVec2]) -> Result<GrooveScan, NoScan> {
    let none = NoScan::NoGroove { share: fit.share, scatter: fit.scatter };
    if fit.share < MIN_SHARE || fit.scatter > MAX_SCATTER_MM {
        return Err(none);
    }
    for i in [DIHEDRAL, ANGLE] {
        let (angle, drawn) = (fit.unknowns[i], fixed.start(0.0)[i]);
        if (angle - drawn).abs() > MAX_TURN {
            return Err(NoScan::OtherAngle { angle, drawn });
        }
    }
    let scan = scan(fixed, fit, points).ok_or(none)?;
    let full = scan.remaining.value > MAX_OPEN * scan.area.value && fixed.welded;
    if full || scan.remaining.uncertainty > MAX_UNCERTAINTY * scan.area.value {
        return Err(NoScan::Uncertain(scan.remaining.uncertainty));
    }
    Ok(scan)
}

/// The sizes of a fit with their uncertainties.
fn scan(fixed: &Fixed, fit: &Fit, points: &[DVec2]) -> Option<GrooveScan> {
    let size =
        |i: usize| Measured { value: fit.unknowns[i], uncertainty: fit.uncertainty(|u| Some(u[i])).unwrap_or(0.0) };
    let groove_area = |u: &Unknowns| Some(fixed.section(u)?.area());
    let area = Measured { value: groove_area(&fit.unknowns)?, uncertainty: fit.uncertainty(groove_area)? };
    let remaining = if fixed.welded { area::open(fixed, fit, points)? } else { area };
    Some(GrooveScan {
        gap: size(GAP),
        mismatch: size(MISMATCH),
        angle: fixed.drawn.angle.map(|_| size(ANGLE)),
        dihedral: size(DIHEDRAL),
        area,
        remaining,
        scatter: fit.scatter,
        share: fit.share,
    })
}

/// True if the groove looks the same from both sides, so that a mirrored profile cannot be recognised.
pub fn is_symmetrical(preparation: &Preparation) -> bool {
    matches!(preparation, Preparation::SingleV(_) | Preparation::U(_))
        || matches!(preparation, Preparation::Fillet(p) if p.first_leg_mm.is_none())
}

/// The groove of a scan, as it is drawn.
impl From<&GrooveScan> for Groove {
    fn from(scan: &GrooveScan) -> Self {
        Self {
            dihedral: scan.dihedral.value,
            gap: scan.gap.value.max(0.0),
            mismatch: scan.mismatch.value,
            angle: scan.angle.map(|angle| angle.value),
        }
    }
}
