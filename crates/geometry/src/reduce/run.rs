//! All lines and arcs between two points: one direction each.
//!
//! An arc from a point O to a point E is determined by its direction at O: the unit vector d, at the angle psi from the
//! direction e to E; it sweeps 2 psi, and psi = 0 is the line. Inversion about O with the radius L = |E - O| maps the
//! arc to the ray from E along d. It maps a ball about a point q to a ball. So the arc is within `near` of q exactly if
//! d is in a disc on the sphere of directions. In units of L, with x = q - O:
//!
//! `v = x - e (x^2 - near^2)`, d within the angle `asin(near / |v|)` of v, that is `|d x v| <= near` and `d . v > 0`.
//!
//! A point nearer than that to O or E imposes no condition. With `near` = 0 in v, `|d x v|` is thus the distance from
//! the arc to first order: the sum of its squares is least for the eigenvector of the sum of v v' with the largest
//! eigenvalue.

use super::discs::{Chart, Disc, apart, common};
use super::track::Track;
use glam::{DMat3, DVec3};

/// Rounds of adding the worst violation, after which a search gives up.
const ROUNDS: usize = 40;

/// Number of chords checked by a first search.
const SAMPLES: usize = 32;

/// Effort of checking a witness, in points.
const GLANCE: usize = 32;

/// Tolerance of the points' distance from a span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Near {
    /// Distance at the start, mm.
    pub(super) at_start: f64,
    /// Relative growth of the tolerance over the distance from start to end.
    pub(super) growth: f64,
    /// Points nearer than this to the end, mm, impose no condition.
    pub(super) end: f64,
    /// The same at the start.
    pub(super) start: f64,
}

impl Near {
    /// The same everywhere.
    pub(super) fn constant(near: f64) -> Self {
        Self { at_start: near, growth: 0.0, end: 0.0, start: 0.0 }
    }
}

/// Up to three positions, by number, that no line or arc satisfies together.
pub(super) type Witness = [usize; 3];

pub(super) enum Found {
    /// The direction of an arc within tolerance of all points.
    Direction(DVec3),
    /// No such arc exists: these positions prove it.
    None(Witness),
    /// The search ended without an arc or a proof.
    GivenUp,
}

/// A run of points from `first` to `last`, seen from the smaller of its end points by coordinates: so the reversed run
/// gives bitwise the same result.
pub(super) struct Run<'a> {
    track: &'a Track<'a>,
    pub(super) first: usize,
    pub(super) last: usize,
    /// Seen from the last point.
    pub(super) flipped: bool,
    /// The end point that it is seen from, mm.
    pub(super) origin: DVec3,
    /// Unit vector to the other end.
    pub(super) way: DVec3,
    /// Distance of the ends, mm.
    pub(super) length: f64,
    near: Near,
    /// Squared length, mm^2, above which the middle of a chord is checked too.
    long: f64,
}

impl<'a> Run<'a> {
    /// The run, if its ends are apart.
    pub(super) fn new(track: &'a Track<'a>, first: usize, last: usize, near: Near) -> Option<Self> {
        let (a, b) = (track.points[first], track.points[last]);
        // Growth counts from the first point.
        let flipped = near.growth == 0.0 && b.to_array() < a.to_array();
        let (origin, other) = if flipped { (b, a) } else { (a, b) };
        let length = origin.distance(other);
        let unit = Near {
            at_start: near.at_start / length,
            growth: near.growth,
            end: (near.end / length).powi(2),
            start: (near.start / length).powi(2),
        };
        // An arc with these ends has at least the radius length / 2, so its bulge over shorter chords is small.
        let long = track.near * f64::max(4.0 * track.near, length);
        let way = (other - origin) / length;
        (length > 0.0).then_some(Self { track, first, last, flipped, origin, way, length, near: unit, long })
    }

    /// Condition of a position on the direction: v and the tolerance; none if unconditional.
    fn demand(&self, number: usize) -> Option<(DVec3, f64)> {
        let x = (self.track.place(number) - self.origin) / self.length;
        let square = x.length_squared();
        let near = if self.near.growth == 0.0 {
            self.near.at_start
        } else {
            self.near.at_start * (1.0 + self.near.growth * (square.sqrt() + self.near.at_start))
        };
        let small = near * near;
        if square <= f64::max(small, self.near.start) || x.distance_squared(self.way) <= self.near.end {
            return None;
        }
        let v = x - (square - small) * self.way;
        (v.length_squared() > small).then_some((v, near))
    }

    /// Visits every condition between the ends, or of one chord in `stride`, in order from the origin.
    fn each(&self, stride: usize, mut look: impl FnMut(usize, DVec3, f64)) {
        self.track.add_work((self.last - self.first) / stride);
        let mut at = |number: usize| {
            if let Some((v, near)) = self.demand(number) {
                look(number, v, near);
            }
        };
        for t in (self.first..self.last).step_by(stride) {
            let k = if self.flipped { self.first + self.last - 1 - t } else { t };
            if self.track.chord(k) > self.long {
                at(2 * k + 1);
            }
            let next = if self.flipped { k } else { k + 1 };
            if next != self.first && next != self.last {
                at(2 * next);
            }
        }
    }

    /// The direction of the arc with the least sum of squared distances.
    fn least_squares(&self, stride: usize) -> DVec3 {
        let (mut sum, mut ahead) = (DMat3::ZERO, DVec3::ZERO);
        self.each(stride, |number, v, near| {
            if !number.is_multiple_of(2) {
                return; // The middles of chords lie inside of an arc.
            }
            let v = v - near * near * self.way;
            sum.x_axis += v.x * v;
            sum.y_axis += v.y * v;
            sum.z_axis += v.z * v;
            ahead += v;
        });
        // The 64th power of the matrix leaves the eigenvector; all columns are multiples of it.
        for _ in 0..6 {
            let scale = sum.x_axis.x + sum.y_axis.y + sum.z_axis.z;
            if scale <= 0.0 {
                return self.way;
            }
            sum *= 1.0 / scale;
            sum *= sum;
        }
        let columns = [sum.x_axis, sum.y_axis, sum.z_axis];
        let longest = columns.into_iter().fold(DVec3::ZERO, |a, b| if b.length() > a.length() { b } else { a });
        let direction = longest.try_normalize().unwrap_or(self.way);
        if direction.dot(ahead) < 0.0 { -direction } else { direction }
    }

    /// The position with the worst violation by the arc with this direction; none if all are within tolerance.
    fn worst(&self, direction: DVec3, stride: usize) -> Option<usize> {
        let (mut most, mut worst) = (1.0 + 1e-12, None);
        self.each(stride, |number, v, near| {
            let across = direction.cross(v).length_squared();
            let away = if direction.dot(v) > 0.0 { across } else { across + v.length_squared() };
            if away > most * near * near {
                (most, worst) = (away / (near * near), Some(number));
            }
        });
        worst
    }

    /// Searches a direction that satisfies all positions, preferably that of least squares.
    pub(super) fn search(&self) -> Found {
        match self.sample() {
            Found::Direction(_) | Found::GivenUp if self.stride() > 1 => self.search_from(self.least_squares(1), 1),
            found => found,
        }
    }

    /// Searches any direction that satisfies all positions, which is faster.
    pub(super) fn search_any(&self) -> Found {
        match self.sample() {
            Found::Direction(direction) if self.stride() > 1 => self.search_from(direction, 1),
            Found::GivenUp if self.stride() > 1 => self.search_from(self.least_squares(1), 1),
            found => found,
        }
    }

    /// Searches among a few positions, or all of a short run: if these contradict each other, all do.
    pub(super) fn sample(&self) -> Found {
        self.search_from(self.least_squares(self.stride()), self.stride())
    }

    fn stride(&self) -> usize {
        ((self.last - self.first) / SAMPLES).max(1)
    }

    /// Starts at a direction and adds the worst positions until these contradict each other or all positions are
    /// satisfied.
    fn search_from(&self, pole: DVec3, stride: usize) -> Found {
        let Some(mut worst) = self.worst(pole, stride) else { return Found::Direction(pole) };
        let chart = Chart::new(pole);
        let (mut numbers, mut discs): (Vec<usize>, Vec<Disc>) = (Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            let disc = self.demand(worst).and_then(|(v, near)| chart.disc(v, near));
            let Some(disc) = disc.filter(|_| !numbers.contains(&worst)) else { break };
            numbers.push(worst);
            discs.push(disc);
            let Some(place) = common(&discs) else {
                return apart(&discs).map_or(Found::GivenUp, |three| Found::None(three.map(|k| numbers[k])));
            };
            let direction = chart.direction(place);
            match self.worst(direction, stride) {
                None => return Found::Direction(direction),
                Some(number) => worst = number,
            }
        }
        Found::GivenUp
    }

    /// True if these positions prove that no line or arc exists.
    pub(super) fn excluded_by(&self, witness: &Witness) -> bool {
        let inside = |number: &usize| 2 * self.first < *number && *number < 2 * self.last;
        if !witness.iter().all(inside) {
            return false;
        }
        self.track.add_work(GLANCE);
        let demands = witness.map(|number| self.demand(number));
        let ahead: DVec3 = demands.iter().flatten().map(|(v, _)| v.normalize()).sum();
        let Some(pole) = ahead.try_normalize() else { return false };
        let chart = Chart::new(pole);
        let mut discs = [None; 3];
        for (disc, demand) in discs.iter_mut().zip(demands) {
            let Some(drawn) = demand.and_then(|(v, near)| chart.disc(v, near)) else { return false };
            *disc = Some(drawn);
        }
        let [Some(a), Some(b), Some(c)] = discs else { return false };
        common(&[a, b, c]).is_none()
    }
}
