//! Corners of a pass: path lengths inside it at which the speed or acceleration of an axis would jump. The torch stops
//! there, or rounds them on a blend.
//!
//! A blend is a quintic of every axis, twice continuously differentiable at both ends. Bisection finds its width:
//! within the allowed distance of the seam, and no wider than the requested speed needs. In blends, and along a bead
//! beside the seam, the tip's travel by path length differs from 1; `JointPath::tip_rate` is this ratio. Without a
//! blend the speed profile stops at the corner, and the pass has several legs.

use crate::follower::Follower;
use crate::joint_path::JointPath;
use crate::pass_channels::PassChannels;
use crate::speed_profile::Channels;
use crate::stretch::Stretch;
use crate::taught::Piece;
use crate::tip_channels::channel_derivatives;
use glam::DVec3;
use seamwright_geometry::{Pose, angle_between};
use seamwright_machine::{AxisLimits, Joints};
use seamwright_message::{Message, Unit};
use seamwright_program::{AtCorner, Finding, Pass, PathRange};

/// Samples of a blend; the maximum is then refined between the neighbours of the worst sample.
const PLACES: u32 = 64;
const REFINED: usize = 24;
/// Fraction of the tolerances that blends use: a margin for the finite sampling.
const USED: f64 = 0.999;
/// Fraction of every limit that is used in a blend wide enough for the requested speed.
const AT_EASE: f64 = 0.9;
/// Relative accuracy of the width of a blend.
const CLOSE: f64 = 1e-5;
/// Deviation from the seam (mm) and from the torch's direction (degrees) below which a blend gets no note:
/// post-processors and drives deviate more.
const RELEVANT_MM: f64 = 5e-3;
const RELEVANT_DEG: f64 = 0.05;
/// Minimum half width of a blend (mm, and as a fraction of the path): shorter ones cost the speed profile digits.
const SHORTEST: (f64, f64) = (1e-3, 1e-5);
/// Minimum travel of the tip in a blend, as a fraction of the seam's: a blend at a turn by more than 168 degrees would
/// nearly stop in its middle.
const MIN_TIP_RATE: f64 = 0.1;

/// A corner without a blend.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Left {
    pub(crate) s: f64,
    /// An axis whose speed or acceleration would jump there.
    pub(crate) axis: usize,
    /// Reason for the missing blend, if one was requested.
    pub(crate) why: Option<Message>,
}

/// A blend within the tolerances, and its deviations from the seam and the torch's direction.
struct Fitting {
    piece: Piece,
    away: Away,
}

#[derive(Debug, Clone, Copy, Default)]
struct Away {
    /// Distance of the tip from the seam, mm.
    tip: f64,
    /// Angle between the direction and the one requested at the nearest point of the seam, rad.
    direction: f64,
}

enum Unfit {
    /// The tip would (nearly) stand still: the path turns back.
    TurnsBack,
    TooFar,
}

/// Rounds the corners of the path as `pass` requests. Returns the path, the remaining corners, and notes of the blends.
pub(crate) fn rounded(
    follower: Follower,
    joints: JointPath,
    pass: &Pass,
    number: usize,
) -> (JointPath, Vec<Left>, Vec<Finding>) {
    let machine = follower.machine;
    let channels = PassChannels::new(machine, &joints, pass, 1.0);
    let corners = channels.corners.clone();
    let AtCorner::BlendMm(distance) = pass.corner else {
        let left = corners.into_iter().map(|(s, axis)| Left { s, axis, why: None });
        return (joints, left.collect(), Vec::new());
    };
    let most = Away { tip: distance.get(), direction: pass.tolerance.attitude_deg.get().to_radians() };
    let (mut blends, mut left, mut notes) = (Vec::new(), Vec::new(), Vec::new());
    for (i, &(s, axis)) in corners.iter().enumerate() {
        let before = if i > 0 { corners[i - 1].0 } else { 0.0 };
        let after = corners.get(i + 1).map_or(joints.length(), |c| c.0);
        let reach = Stretch { from: before, to: after };
        let corner = Corner { follower, joints: &joints, channels: &channels, s, reach };
        match corner.blend(&most) {
            Ok(fitting) => {
                notes.extend(note(&fitting, s, number));
                blends.push(fitting.piece);
            }
            Err(why) => left.push(Left { s, axis, why: Some(why) }),
        }
    }
    if blends.is_empty() { (joints, left, notes) } else { (joints.blended(&blends), left, notes) }
}

fn note(blend: &Fitting, s: f64, pass: usize) -> Option<Finding> {
    let Fitting { piece, away } = blend;
    let turned = away.direction.to_degrees();
    if away.tip < RELEVANT_MM && turned < RELEVANT_DEG {
        return None;
    }
    let blend =
        |code| {
            Message::new(code)
                .quantity("s", s, Unit::Mm, 3)
                .quantity("over", piece.to - piece.from, Unit::Mm, 3)
                .quantity("deviation", away.tip, Unit::Mm, 3)
        };
    let message = match turned < RELEVANT_DEG {
        true => blend("motion-blend"),
        false => blend("motion-blend-turned").quantity("turned", turned, Unit::Deg, 1),
    };
    Some(Finding::note("blend", message, pass, PathRange { from_mm: piece.from, to_mm: piece.to }))
}

/// A corner and its surroundings on the path.
struct Corner<'a> {
    follower: Follower<'a>,
    joints: &'a JointPath,
    channels: &'a PassChannels<'a>,
    s: f64,
    /// The path between the corners beside it, or the ends of the path, mm.
    reach: Stretch,
}

impl Corner<'_> {
    /// Finds the fastest blend within `most` and half the distance to the next corner or end: as wide as allowed, but
    /// no wider than the requested speed needs. Else returns the reason.
    fn blend(&self, most: &Away) -> Result<Fitting, Message> {
        let room = 0.5 * (self.s - self.reach.from).min(self.reach.to - self.s);
        let shortest = SHORTEST.0.max(SHORTEST.1 * self.joints.length());
        if room < shortest {
            return Err(Message::new("motion-blend-no-room").quantity("distance", 2.0 * room, Unit::Mm, 4));
        }
        let mut best = self.fitting(shortest, most);
        let (mut low, mut high, mut half) = (shortest, room, room);
        while best.is_ok() && high - low > CLOSE * low {
            match self.fitting(half, most) {
                Ok(blend) if !self.at_ease(&blend.piece) => (low, best) = (half, Ok(blend)),
                Ok(blend) => (high, best) = (half, Ok(blend)),
                Err(_) => high = half,
            }
            half = (low * high).sqrt();
        }
        best.map_err(|unfit| match unfit {
            Unfit::TurnsBack => Message::new("motion-blend-turns-back"),
            Unfit::TooFar => Message::new("motion-blend-too-far")
                .quantity("over", 2.0 * shortest, Unit::Mm, 4)
                .value("deviation", most.tip, Unit::Mm)
                .quantity("turned", most.direction.to_degrees(), Unit::Deg, 1),
        })
    }

    /// Builds the blend `half` mm to each side, if it stays within `most`.
    fn fitting(&self, half: f64, most: &Away) -> Result<Fitting, Unfit> {
        let over = Stretch { from: self.s - half, to: self.s + half };
        let Stretch { from, to } = over;
        let end = |s: f64, before: bool| {
            let p = self.joints.point(s, before);
            [p.q, p.d1, p.d2]
        };
        let piece = Piece::quintic(over, end(from, true), end(to, false));
        let at = |i: f64| from + (to - from) * i / f64::from(PLACES);
        let mut away = Away::default();
        let mut worst = [(0.0, 0.0); 2];
        for i in 1..PLACES {
            let d = piece.derivatives(at(f64::from(i)));
            // On a path by time the axes move evenly at any tip speed.
            if !self.joints.timed
                && self.follower.machine.tip_derivatives(&d, self.joints.drawn_back)[0].length() < MIN_TIP_RATE
            {
                return Err(Unfit::TurnsBack);
            }
            let here = self.away(&d[0], half);
            for (worst, here) in worst.iter_mut().zip([here.tip, here.direction]) {
                *worst = if here > worst.1 { (f64::from(i), here) } else { *worst };
            }
            away = away.greater(here);
            if !away.within(most) {
                return Err(Unfit::TooFar);
            }
        }
        for (kind, (i, _)) in worst.into_iter().enumerate() {
            let value = |i: f64| self.away(&piece.derivatives(at(i))[0], half);
            let around = Stretch { from: i - 1.0, to: i + 1.0 };
            let greatest = greatest(around, |i| [value(i).tip, value(i).direction][kind]);
            away = away.greater(value(greatest));
        }
        if away.within(most) { Ok(Fitting { piece, away }) } else { Err(Unfit::TooFar) }
    }

    /// True if the torch passes `blend` at the requested speed within [`AT_EASE`] of every limit. At constant tip speed
    /// `v` the squared speed by path length is `v^2 / rate^2`; its derivatives follow from those of the tip.
    fn at_ease(&self, blend: &Piece) -> bool {
        let asked = self.channels.asked(blend.from).max(self.channels.asked(blend.to));
        let mut rows = vec![[0.0; 3]; self.channels.limits().len()];
        (0..=PLACES).all(|i| {
            let u = blend.from + (blend.to - blend.from) * f64::from(i) / f64::from(PLACES);
            let d = blend.derivatives(u);
            let [r1, r2, r3] = channel_derivatives(self.follower.machine, self.joints.drawn_back, &d, &mut rows);
            let (square, mixed) = (r1.length_squared(), r1.dot(r2));
            let [b, b1, b2] = if self.joints.timed {
                [asked * asked, 0.0, 0.0]
            } else {
                let b = asked * asked / square;
                let b1 = -2.0 * b * mixed / square;
                [b, b1, 2.0 * b * (4.0 * mixed * mixed / square - r2.length_squared() - r1.dot(r3)) / square]
            };
            let within = |([q1, q2, q3], l): (&[f64; 3], &AxisLimits)| {
                let speed = q1.abs() * b.sqrt() / l.speed;
                let acceleration = (q2 * b + 0.5 * q1 * b1).abs() / l.acceleration;
                let jerk = b.sqrt() * (q3 * b + 1.5 * q2 * b1 + 0.5 * q1 * b2).abs() / l.jerk;
                speed.max(acceleration).max(jerk) <= AT_EASE
            };
            rows.iter().zip(self.channels.limits()).all(within)
        })
    }

    /// Deviation of the torches at positions `q`, in a blend `half` mm to each side.
    fn away(&self, q: &Joints, half: f64) -> Away {
        let Follower { machine, path, .. } = self.follower;
        let sides = [
            Stretch { from: (self.s - 2.0 * half).max(self.reach.from), to: self.s },
            Stretch { from: self.s, to: (self.s + 2.0 * half).min(self.reach.to) },
        ];
        let first = nearest(|s| path.pose(s), machine.forward(q), sides);
        match path.second(self.s) {
            // A path has a second torch everywhere or nowhere.
            Some(_) => {
                let pose = |s: f64| path.second(s).unwrap_or_else(|| path.pose(s));
                first.greater(nearest(pose, machine.forward_of(1, q), sides))
            }
            None => first,
        }
    }
}

impl Away {
    fn greater(self, other: Self) -> Self {
        Self { tip: self.tip.max(other.tip), direction: self.direction.max(other.direction) }
    }

    fn within(&self, most: &Self) -> bool {
        self.tip <= USED * most.tip && self.direction <= USED * most.direction
    }
}

/// Deviation of `torch` from the nearest point of the seam, which is smooth on both `sides` of a corner.
fn nearest(pose: impl Fn(f64) -> Pose, torch: Pose, sides: [Stretch; 2]) -> Away {
    let there = pose(foot_at_corner(&pose, torch.point, sides));
    Away { tip: there.point.distance(torch.point), direction: angle_between(there.direction, torch.direction) }
}

/// Path length of the point of the seam `pose` nearest to `point` (mm, near `s`), on either side of the corner. None
/// unless `s` lies in a blend of the axes' path `joints`.
pub fn foot_in_blend(joints: &JointPath, pose: impl Fn(f64) -> Pose, point: DVec3, s: f64) -> Option<f64> {
    let &(from, to) = joints.blends().iter().find(|(from, to)| *from <= s && s <= *to)?;
    let (corner, half) = (0.5 * (from + to), 0.5 * (to - from));
    let before = Stretch { from: (from - half).max(0.0), to: corner };
    let after = Stretch { from: corner, to: (to + half).min(joints.length()) };
    Some(foot_at_corner(pose, point, [before, after]))
}

/// Path length of the seam's nearest point to `point`; the seam is smooth on both `sides` of a corner.
fn foot_at_corner(pose: impl Fn(f64) -> Pose, point: DVec3, sides: [Stretch; 2]) -> f64 {
    let feet = [foot(&pose, point, sides[0], sides[0].to), foot(&pose, point, sides[1], sides[1].from)];
    let [before, after] = feet.map(|s| pose(s).point.distance(point));
    if before <= after { feet[0] } else { feet[1] }
}

/// Path length of the seam's nearest point to `point` on one `side` of a corner, by Newton's method without the
/// curvature. Before convergence the distance found is slightly too large, never too small.
fn foot(pose: impl Fn(f64) -> Pose, point: DVec3, side: Stretch, start: f64) -> f64 {
    let Stretch { from, to } = side;
    let h = 1e-4 * (to - from);
    let mut s = start;
    for _ in 0..5 {
        let (behind, ahead) = ((s - h).max(from), (s + h).min(to));
        let tangent = (pose(ahead).point - pose(behind).point) / (ahead - behind);
        if tangent.length_squared() == 0.0 {
            return s;
        }
        let next = (s + (point - pose(s).point).dot(tangent) / tangent.length_squared()).clamp(from, to);
        if (next - s).abs() < 1e-9 * (to - from) {
            return next;
        }
        s = next;
    }
    s
}

/// Argument of the maximum of a function that is unimodal `within` a range.
fn greatest(within: Stretch, value: impl Fn(f64) -> f64) -> f64 {
    let Stretch { from: mut low, to: mut high } = within;
    for _ in 0..REFINED {
        let [a, b] = [low + (high - low) * 0.45, low + (high - low) * 0.55];
        if value(a) < value(b) { low = a } else { high = b }
    }
    0.5 * (low + high)
}
