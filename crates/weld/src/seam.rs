use crate::allowed::{at_most, between, not_along, other_point, rounded};
use crate::angles::Angles;
use crate::branch::Joint;
use crate::nozzle::OnBody;
use crate::periodic_places::repeated;
use crate::taught::{TaughtEdge, TaughtSpan};
use crate::{girth, plane_seam, space_seam, spline_seam, t_joint};
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{ByLength, Curve, CurvedEdge, DEFAULT_ACCURACY_MM, Edge, Ellipse, FaceRule, Line};
use seamwright_message::{Message, Unit};
use seamwright_program::{
    MAX_SEAM_MM, PathRange, SAME_POSITION_MM, Seam, SeamStart, Side, Taught, WeldDirection, is_before, is_beyond,
    is_same_position,
};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A point of the seam with everything that torch attitude needs, in the seam's frame; mm and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamPoint {
    /// Path length from the start of the weld, mm.
    pub s: f64,
    /// Angle about the nozzle's axis or eccentric angle, rad, counted on beyond a turn; `None` on seams without angles.
    pub phi: Option<f64>,
    /// Position, mm.
    pub point: DVec3,
    /// Unit tangent in the direction of welding.
    pub tangent: DVec3,
    /// Unit direction square to both faces, in the direction of welding: the tangent, or on splines a smoother direction
    /// near it (see [`Edge::along`]).
    pub along: DVec3,
    /// Outward unit normal of the first part (nozzle).
    pub n1: DVec3,
    /// Outward unit normal of the second part (body).
    pub n2: DVec3,
    /// Unit bisector of the two faces, from the joint out to the torch.
    pub bisector: DVec3,
    /// Unit vector across the bisector in the normal plane, towards the first part.
    pub towards_first: DVec3,
    /// Angle between the two faces seen from the torch, rad.
    pub dihedral: f64,
}

/// A seam by path length, from the start of the weld and in its direction.
pub struct SeamCurve {
    pub(crate) curve: ByLength<Box<dyn Edge + Send + Sync>>,
    /// Arc length of the start of the weld on the curve, and the sense of welding.
    pub(crate) start: f64,
    pub(crate) sense: f64,
    weld_length: f64,
    pub(crate) closed: bool,
    angles: Angles,
    /// 1 if the curve runs along n2 x n1, as on a nozzle or tube; -1 on a line that runs the other way.
    face_sense: f64,
    /// True if the faces meet at an outside corner.
    outside_corner: bool,
    /// Thickness (mm) of the web whose other fillet is welded at the same time.
    web: Option<f64>,
    /// The seam without its taught spans, and these.
    pub(crate) taught: Option<(Arc<SeamCurve>, Vec<TaughtSpan>)>,
}

/// Minimum distance of the seam's corners, and distance at which its sides are evaluated, mm: more than rounding, and
/// too little for a bend to turn the torch.
pub(crate) const SAME_MM: f64 = 1e-9;

/// Maximum angle of a start or end, degrees: ten turns.
const MAX_PHI_DEG: f64 = 3600.0;

impl std::fmt::Debug for SeamCurve {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("SeamCurve").field("start", &self.start).field("weld_length", &self.weld_length).finish()
    }
}

impl SeamCurve {
    /// The seam of a job or program file.
    ///
    /// # Errors
    /// With the key's address: shapes that do not meet, a start or overlap that does not fit the seam.
    pub fn new<T>(file: &Document<T>, seam: &Seam, start: &SeamStart) -> Result<Self, DocumentError> {
        Self::along(file, edge(file, seam)?, seam, start)
    }

    /// The same seam with some of its parts replaced by taught points.
    ///
    /// # Errors
    /// With the key's address: spans that overlap or leave the weld, points that do not fit.
    pub fn with_taught<T>(
        file: &Document<T>,
        seam: &Seam,
        start: &SeamStart,
        taught: &[Taught],
    ) -> Result<Self, DocumentError> {
        let nominal = Self::new(file, seam, start)?;
        if taught.is_empty() {
            return Ok(nominal);
        }
        let nominal = Arc::new(nominal);
        let edge = TaughtEdge::new(file, &nominal, taught)?;
        let joins = edge.joins();
        let mut whole = Self::along(file, Box::new(edge), seam, start)?;
        whole.taught = Some((nominal, joins.into_iter().map(|join| join.by_length(|u| whole.s_at(u))).collect()));
        Ok(whole)
    }

    /// The seam along `edge`.
    fn along<T>(
        file: &Document<T>,
        edge: Box<dyn Edge + Send + Sync>,
        seam: &Seam,
        start: &SeamStart,
    ) -> Result<Self, DocumentError> {
        let curve = ByLength::new(edge, DEFAULT_ACCURACY_MM)
            .map_err(|e| file.error_at("seam", e.message(), Message::new("weld-allowed-smooth-seam")))?;
        let sense = match start.direction {
            WeldDirection::CounterClockwise => 1.0,
            WeldDirection::Clockwise => -1.0,
        };
        if curve.length() > MAX_SEAM_MM {
            let message = Message::new("weld-seam-too-long").quantity("length", curve.length(), Unit::Mm, 0);
            return Err(file.error_at("seam", message, at_most(MAX_SEAM_MM, Unit::Mm)));
        }
        let closed = curve.curve().closed();
        let angles = Angles::new(file, seam, closed)?;
        let length_at = |phi: f64| angles.parameter(phi.to_radians()).map_or(0.0, |u| curve.length_at(u));
        for (key, phi) in [("phi_deg", Some(start.phi_deg)), ("end_phi_deg", start.end_phi_deg)] {
            if phi.is_some_and(|p| p.get().abs() > MAX_PHI_DEG) {
                let allowed = between(-MAX_PHI_DEG, MAX_PHI_DEG, Unit::Deg);
                return Err(file.error_at(&format!("start.{key}"), Message::new("weld-phi-too-large"), allowed));
            }
        }
        if !closed || matches!(angles, Angles::None) {
            check_without_angles(file, start, closed)?;
        }
        let at = length_at(start.phi_deg.get());
        let length = curve.length();
        let weld_length = match start.end_phi_deg {
            Some(end) => {
                if start.overlap_mm.get() > 0.0 {
                    let message = Message::new("weld-overlap-with-end");
                    let allowed = Message::new("weld-allowed-overlap-or-end");
                    return Err(file.error_at("start.overlap_mm", message, allowed));
                }
                let span = sense * (length_at(end.get()) - at);
                if !is_beyond(span, 0.0) || is_beyond(span, length) {
                    let message = Message::new("weld-end-beside-turn");
                    let code = if sense > 0.0 { "weld-allowed-end-phi-more" } else { "weld-allowed-end-phi-less" };
                    let allowed = Message::new(code).text("start", start.phi_deg.get().to_string());
                    return Err(file.error_at("start.end_phi_deg", message, allowed.value("max", 360.0, Unit::Deg)));
                }
                if is_same_position(span, length) { length } else { span }
            }
            None => length + start.overlap_mm.get(),
        };
        if is_beyond(start.overlap_mm.get(), length) {
            let allowed = between(0.0, rounded(length), Unit::Mm);
            return Err(file.error_at("start.overlap_mm", Message::new("weld-overlap-too-long"), allowed));
        }
        let e = curve.curve().edge(curve.curve().domain().0);
        let outside_corner = plane_seam::is_corner(seam);
        let face_sense = if e.d1.normalize().dot(e.n2.cross(e.n1)) < -1e-9 { -1.0 } else { 1.0 };
        // Both turn over the side of the bisector on which the first part lies.
        let turned_over = outside_corner || matches!(seam, Seam::Girth(girth) if girth.inside);
        let face_sense = if turned_over { -face_sense } else { face_sense };
        let web = match seam {
            Seam::TJoint(joint) if joint.fillet == Side::Both => Some(joint.web_mm.get()),
            _ => None,
        };
        Ok(Self { curve, start: at, sense, weld_length, closed, angles, face_sense, outside_corner, web, taught: None })
    }

    /// Length of the whole seam once, mm.
    pub fn length(&self) -> f64 {
        self.curve.length()
    }

    /// Length of the weld, mm: the seam and the overlap, or the part that is welded.
    pub fn weld_length(&self) -> f64 {
        self.weld_length
    }

    /// True if the seam is closed and welded all round.
    pub fn all_round(&self) -> bool {
        self.closed && !is_before(self.weld_length, self.length())
    }

    /// Minimum and maximum dihedral angle over the weld, rad, found at 720 stations.
    pub fn dihedral_range(&self) -> (f64, f64) {
        let angles = (0..=720).map(|i| self.at(self.weld_length * f64::from(i) / 720.0).dihedral);
        angles.fold((f64::INFINITY, 0.0), |(l, h), a| (f64::min(l, a), f64::max(h, a)))
    }

    /// Path length of the angle `phi` (rad): the first one at or after the start of the weld on a closed seam. None on
    /// a seam without angles.
    pub fn s_of_phi(&self, phi: f64) -> Option<f64> {
        let s = self.sense * (self.curve.length_at(self.angles.parameter(phi)?) - self.start);
        if !self.closed {
            let within = !is_before(s, 0.0) && !is_beyond(s, self.length());
            return within.then_some(s.clamp(0.0, self.length()));
        }
        // A hair before the start is the start, not a turn later.
        let turns = ((s + SAME_POSITION_MM) / self.length()).floor();
        Some((s - turns * self.length()).max(0.0))
    }

    /// Path lengths inside the weld where a derivative of the seam or of its faces may jump, increasing.
    pub fn knots(&self) -> Vec<f64> {
        self.knots_within(PathRange::up_to(self.weld_length))
    }

    /// Those inside `range`; on a closed seam it may be longer than a turn, and start before the start of the weld.
    pub fn knots_within(&self, range: PathRange) -> Vec<f64> {
        let length = self.length();
        let place = |u: f64| {
            let s = self.sense * (self.curve.length_at(u) - self.start);
            if self.closed { s.rem_euclid(length) } else { s }
        };
        repeated(self.curve.curve().breaks().into_iter().map(place), self.closed.then_some(length), range, SAME_MM)
    }

    /// Path length from the start of the weld of the curve's parameter `u`, mm.
    fn s_at(&self, u: f64) -> f64 {
        self.sense * (self.curve.length_at(u) - self.start)
    }

    /// The seam at path length `s` (mm) from the start of the weld.
    pub fn at(&self, s: f64) -> SeamPoint {
        let u = self.curve.parameter(self.start + self.sense * s);
        let e = self.curve.curve().edge(u);
        let along = self.curve.curve().along(u, &e);
        let sum = e.n1 + e.n2;
        let width = sum.length();
        let bisector = sum / width;
        let inside = 2.0 * width.atan2((e.n1 - e.n2).length());
        SeamPoint {
            s,
            phi: self.angles.at(u),
            point: e.point,
            tangent: self.sense * e.d1.normalize(),
            along: self.sense * along,
            n1: e.n1,
            n2: e.n2,
            bisector,
            towards_first: self.face_sense * bisector.cross(along),
            dihedral: if self.outside_corner { TAU - inside } else { inside },
        }
    }
}

impl SeamCurve {
    /// True if two fillets are welded at the same time.
    pub fn is_double(&self) -> bool {
        self.web.is_some()
    }

    /// The point of the other fillet across the web, where both are welded at the same time; `s` is that of `p`.
    pub fn across(&self, p: &SeamPoint) -> Option<SeamPoint> {
        self.web.map(|web| {
            let n1 = -p.n1;
            let bisector = (n1 + p.n2).normalize();
            SeamPoint {
                point: p.point - web * p.n1,
                n1,
                bisector,
                // Along the web's face, away from the skin.
                towards_first: (p.n2 - n1).normalize(),
                ..*p
            }
        })
    }
}

/// An open seam, or one without angles, starts at its given start and goes on as given; an open one has no overlap.
fn check_without_angles<T>(file: &Document<T>, start: &SeamStart, closed: bool) -> Result<(), DocumentError> {
    let wrong = if start.phi_deg.get() != 0.0 {
        "phi_deg"
    } else if start.end_phi_deg.is_some() {
        "end_phi_deg"
    } else if start.direction != WeldDirection::CounterClockwise {
        "direction"
    } else if start.overlap_mm.get() > 0.0 && !closed {
        "overlap_mm"
    } else {
        return Ok(());
    };
    let (message, allowed) = if closed {
        ("weld-start-at-first-point", "weld-allowed-points-in-other-order")
    } else {
        ("weld-start-of-open-seam", "weld-allowed-no-key-on-open-seam")
    };
    Err(file.error_at(&format!("start.{wrong}"), Message::new(message), Message::new(allowed)))
}

fn edge<T>(file: &Document<T>, seam: &Seam) -> Result<Box<dyn Edge + Send + Sync>, DocumentError> {
    match seam {
        Seam::Nozzle(nozzle) => Ok(OnBody::new(file, nozzle)?.edge),
        Seam::Branch(branch) => Joint::new(file, branch)?.edge(file),
        Seam::Girth(girth) => Ok(Box::new(girth::edge(file, girth)?)),
        Seam::Ellipse(e) => {
            let normal = e.normal.unit();
            let (a, b) = (e.a_mm.get(), e.b_mm.get());
            let curve = Ellipse::new(e.centre_mm.get(), normal, e.a_direction.unit(), a, b)
                .map_err(|e| file.error_at("seam.ellipse.a_direction", e.message(), not_along("normal")))?;
            Ok(Box::new(CurvedEdge { curve, faces: plane_seam::rim_faces(e.joint, normal) }))
        }
        Seam::Circle(circle) => Ok(Box::new(plane_seam::circle(file, circle)?)),
        Seam::Arc(arc) => Ok(Box::new(plane_seam::arc(file, arc)?)),
        Seam::RoundedRectangle(r) => Ok(Box::new(plane_seam::rectangle(file, r)?)),
        Seam::Helix(helix) => Ok(Box::new(space_seam::helix(file, helix)?)),
        Seam::Spline(s) => Ok(Box::new(spline_seam::edge(file, s)?)),
        Seam::Polyline(p) => Ok(Box::new(plane_seam::polyline(file, p)?)),
        Seam::Line(line) => {
            let (n1, n2) = (line.first_normal.unit(), line.second_normal.unit());
            let curve = Line::new(line.start_mm.get(), line.end_mm.get())
                .map_err(|e| file.error_at("seam.line.end_mm", e.message(), other_point("start_mm")))?;
            let along = (line.end_mm.get() - line.start_mm.get()).normalize();
            for (key, n) in [("first_normal", n1), ("second_normal", n2)] {
                if n.dot(along).abs() > 1e-6 {
                    let message = Message::new("weld-normal-not-square");
                    let allowed = Message::new("weld-allowed-square-to-line");
                    return Err(file.error_at(&format!("seam.line.{key}"), message, allowed));
                }
            }
            if (n1 + n2).length() < 1e-6 {
                let message = Message::new("weld-faces-opposed");
                let allowed = Message::new("weld-allowed-not-opposite").key("key", "first_normal");
                return Err(file.error_at("seam.line.second_normal", message, allowed));
            }
            Ok(Box::new(CurvedEdge { curve, faces: FaceRule::Fixed { n1, n2 } }))
        }
        Seam::TJoint(joint) => t_joint::edge(file, joint),
    }
}
