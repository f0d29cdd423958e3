//! Comparison of a joint with the ranges of a standard. The values are those that shops keep (trust: to be read again in
//! the standard's edition in force); a joint outside is a warning, not an error.

use super::SeamJoint;
use super::section::Section;
use crate::seam::SeamCurve;
use seamwright_document::Positive;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, JointStandard, PathRange, Preparation, Seam};

/// Stations at which a joint is compared.
const PLACES: u32 = 360;

/// A size of a joint that a standard gives a range for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Size {
    Thickness,
    Angle,
    RootGap,
    RootFace,
    CoverThroat,
}

/// Ranges of ISO 9692-1, mm and degrees.
struct Ranges {
    thickness: [f64; 2],
    angle: [f64; 2],
    gap: [f64; 2],
    root_face: [f64; 2],
}

const ANY: [f64; 2] = [0.0, f64::INFINITY];

/// Ranges of ISO 9692-1 for arc welds in steel: of the kind that a preparation is, with the steep or broad form of a V
/// recognised by its sizes.
fn iso_9692(preparation: &Preparation, is_backed: bool) -> Ranges {
    let of = |thickness, angle, gap, root_face| Ranges { thickness, angle, gap, root_face };
    match preparation {
        Preparation::Square(p) => {
            let most = if is_backed { 8.0 } else { 4.0 };
            of([0.0, most], ANY, [0.0, p.thickness_mm.get()], ANY)
        }
        Preparation::SingleV(p) if p.angle_deg.get() <= 20.0 => {
            of([16.0, f64::INFINITY], [5.0, 20.0], [5.0, 15.0], ANY)
        }
        Preparation::SingleV(p) if p.root_face_mm.get() > 2.0 => of([5.0, 40.0], [50.0, 70.0], [1.0, 4.0], [2.0, 4.0]),
        Preparation::SingleV(_) => of([3.0, 10.0], [40.0, 60.0], [0.0, 4.0], [0.0, 2.0]),
        Preparation::DoubleV(_) => of([10.0, f64::INFINITY], [40.0, 60.0], [1.0, 3.0], [0.0, 2.0]),
        Preparation::Bevel(_) | Preparation::TBevel(_) => of([3.0, 10.0], [35.0, 60.0], [2.0, 4.0], [1.0, 2.0]),
        Preparation::DoubleBevel(_) | Preparation::TDoubleBevel(_) => {
            of([10.0, f64::INFINITY], [35.0, 60.0], [1.0, 4.0], [0.0, 2.0])
        }
        Preparation::U(_) => of([12.0, f64::INFINITY], [8.0, 12.0], [0.0, 4.0], [0.0, 3.0]),
        Preparation::DoubleU(_) => of([30.0, f64::INFINITY], [8.0, 12.0], [0.0, 3.0], [2.0, 4.0]),
        Preparation::J(_) | Preparation::TJ(_) => of([16.0, f64::INFINITY], [10.0, 20.0], [2.0, 4.0], [1.0, 2.0]),
        Preparation::Corner(_) | Preparation::Fillet(_) | Preparation::Lap(_) => of(ANY, ANY, [0.0, 2.0], ANY),
        Preparation::FlareBevel(_) | Preparation::FlareV(_) => of(ANY, ANY, ANY, ANY),
    }
}

/// Details A to D of AWS D1.1 for complete penetration from one side in T-, Y- and K-connections of tubes: local dihedral
/// angle, groove angle (a part of the dihedral angle in C and D) and root opening.
fn aws_details(dihedral: f64, angle: f64) -> Vec<[[f64; 2]; 2]> {
    let mut all = Vec::new();
    let mut detail = |of: [f64; 2], angles: [f64; 2], gaps: [f64; 2]| {
        if (of[0]..=of[1]).contains(&dihedral) {
            all.push([angles, gaps]);
        }
    };
    detail([135.0, 180.0], [45.0, 90.0], [2.0, 5.0]);
    detail([50.0, 150.0], [37.5, 60.0], [2.0, if angle <= 45.0 { 8.0 } else { 6.0 }]);
    detail([30.0, 75.0], [0.5 * dihedral, 40.0_f64.max(0.5 * dihedral)], ANY);
    detail([15.0, 40.0], [0.4 * dihedral, 0.6 * dihedral], ANY);
    all
}

/// A size outside its range at some stations: the worst of them.
struct Outside {
    size: Size,
    value: f64,
    range: [f64; 2],
    dihedral: Option<f64>,
}

impl Outside {
    fn distance(&self) -> f64 {
        (self.range[0] - self.value).max(self.value - self.range[1])
    }

    fn message(&self, standard: JointStandard, s: f64) -> Message {
        let standard = match standard {
            JointStandard::Iso9692 => "ISO 9692-1",
            JointStandard::AwsD11 => "AWS D1.1",
            JointStandard::AsmeUw16 => "ASME VIII-1, UW-16",
        };
        let (size, unit) = match self.size {
            Size::Thickness => ("weld-size-thickness", Unit::Mm),
            Size::Angle => ("weld-size-groove-angle", Unit::Deg),
            Size::RootGap => ("weld-size-root-gap", Unit::Mm),
            Size::RootFace => ("weld-size-root-face", Unit::Mm),
            Size::CoverThroat => ("weld-size-cover-throat", Unit::Mm),
        };
        let [min, max] = self.range;
        let code = match (self.dihedral.is_some(), max.is_finite()) {
            (true, _) => "weld-joint-beside-standard-at-dihedral",
            (false, true) => "weld-joint-beside-standard",
            (false, false) => "weld-joint-below-standard",
        };
        let mut message = Message::new(code).message("size", Message::new(size)).text("standard", standard);
        message = message.quantity("value", self.value, unit, 1).quantity("s", s, Unit::Mm, 0);
        message = message.quantity("min", min, unit, 1);
        if max.is_finite() || self.dihedral.is_some() {
            message = message.quantity("max", max, unit, 1);
        }
        match self.dihedral {
            Some(dihedral) => message.quantity("dihedral", dihedral, Unit::Deg, 1),
            None => message,
        }
    }
}

impl SeamJoint {
    /// Sizes of the joint beside the ranges of its standard, each over the range of the seam where it is outside. `body` is
    /// the thickness of the body's wall, if it is known, mm.
    pub(crate) fn beside_standard(&self, curve: &SeamCurve, seam: &Seam, body: Option<f64>) -> Vec<Finding> {
        let Some(standard) = self.joint.standard else { return Vec::new() };
        let mut found: Vec<(Outside, PathRange, f64)> = Vec::new();
        for i in 0..=PLACES {
            let s = curve.weld_length() * f64::from(i) / f64::from(PLACES);
            let p = curve.at(s);
            let Some(section) = self.section(&p) else { continue };
            let angle = self.last_measured(&p).angle.map(f64::to_degrees);
            let sizes = match standard {
                JointStandard::Iso9692 => self.iso_sizes(&section, angle),
                JointStandard::AwsD11 => aws_sizes(&section, angle),
                JointStandard::AsmeUw16 => self.cover_throat(&section, seam, body),
            };
            for outside in sizes.into_iter().filter(|size| size.distance() > 1e-9) {
                match found.iter_mut().find(|(of, ..)| of.size == outside.size) {
                    None => found.push((outside, PathRange::at(s), s)),
                    Some((worst, range, at)) => {
                        range.to_mm = s;
                        if outside.distance() > worst.distance() {
                            (*worst, *at) = (outside, s);
                        }
                    }
                }
            }
        }
        let finding = |(outside, range, s): (Outside, PathRange, f64)| Finding {
            allowed: true,
            ..Finding::error("joint", outside.message(standard, s), 1, range, Message::new("weld-cure-joint-standard"))
        };
        found.into_iter().map(finding).collect()
    }

    fn iso_sizes(&self, section: &Section, angle: Option<f64>) -> Vec<Outside> {
        let preparation = &self.joint.preparation;
        let ranges = iso_9692(preparation, self.joint.backing.is_some());
        let of = |size, value: Option<f64>, range| value.map(|value| Outside { size, value, range, dihedral: None });
        let sizes = [
            of(Size::Thickness, preparation.thickness_mm().filter(|_| !is_fillet(preparation)), ranges.thickness),
            of(Size::Angle, angle, ranges.angle),
            of(Size::RootGap, Some(section.gap), ranges.gap),
            of(Size::RootFace, preparation.root_face_mm(), ranges.root_face),
        ];
        sizes.into_iter().flatten().collect()
    }

    /// The throat of the cover fillet, over the corner of the parts' outsides: at least 6 mm or 0.7 of the thinner part,
    /// which counts up to 19 mm.
    fn cover_throat(&self, section: &Section, seam: &Seam, body: Option<f64>) -> Vec<Outside> {
        let wall = if let Seam::Nozzle(nozzle) = seam { nozzle.wall_mm.map(Positive::get) } else { None };
        let known = [self.joint.preparation.thickness_mm(), wall, body];
        let thinner = known.into_iter().flatten().fold(19.0, f64::min);
        let [first, second] = section.toes();
        let value = (first - second).normalize_or_zero().perp_dot(first).abs();
        let range = [f64::min(6.0, 0.7 * thinner), f64::INFINITY];
        vec![Outside { size: Size::CoverThroat, value, range, dihedral: None }]
    }
}

/// Groove angle (degrees) and root opening beside the detail that they fit best.
fn aws_sizes(section: &Section, angle: Option<f64>) -> Vec<Outside> {
    let (dihedral, Some(angle)) = (section.dihedral.to_degrees(), angle) else { return Vec::new() };
    let sizes = |[angles, gaps]: [[f64; 2]; 2]| {
        let of = |size, value, range| Outside { size, value, range, dihedral: Some(dihedral) };
        [of(Size::Angle, angle, angles), of(Size::RootGap, section.gap, gaps)]
    };
    let details = aws_details(dihedral, angle).into_iter().map(sizes);
    let off = |sizes: &[Outside; 2]| sizes.iter().map(|size| size.distance().max(0.0)).sum::<f64>();
    details.min_by(|a, b| off(a).total_cmp(&off(b))).map_or(Vec::new(), |sizes| sizes.into_iter().collect())
}

fn is_fillet(preparation: &Preparation) -> bool {
    matches!(preparation, Preparation::Fillet(_) | Preparation::Lap(_) | Preparation::Corner(_))
}
