use super::Error;
use glam::{DMat2, DVec2, DVec3};
use seamwright_machine::{Joints, Machine};
use seamwright_tracking::actuator::{OverAxes, SlideLimits};
use seamwright_tracking::lead::SeamFrame;

/// The farthest that the machine's own axes take a torch from its planned path, mm.
const RANGE_MM: f64 = 6.0;

/// What takes a torch off its planned path: a cross slide, or the axes that carry it.
#[derive(Debug, Clone)]
pub(crate) enum Carrier<'a> {
    Slides { machine: &'a Machine, head: usize, axes: [usize; 2] },
    Axes(Box<OverAxes<'a>>),
}

impl<'a> Carrier<'a> {
    /// That of head `head`.
    ///
    /// # Errors
    /// [`Error::NoSlide`] for a second head without a slide of its own.
    pub(crate) fn new(machine: &'a Machine, head: usize) -> Result<Self, Error> {
        let none = || Error::NoSlide { machine: machine.name.clone(), head: head + 1 };
        let mut slides = machine.heads.get(head).ok_or_else(none)?.slides.iter();
        match (slides.next(), slides.next()) {
            (Some(a), Some(b)) => Ok(Self::Slides { machine, head, axes: [a, b] }),
            _ if head == 0 => Ok(Self::Axes(Box::new(OverAxes::new(machine)))),
            _ => Err(none()),
        }
    }

    /// True if plans have to leave a reserve of the axes for it.
    pub(crate) fn needs_reserve(&self) -> bool {
        matches!(self, Self::Axes(_))
    }

    /// What corrections may do, lateral and height each, along a path with these planned positions and frames.
    ///
    /// # Errors
    /// Of axes that cannot carry it out.
    pub(crate) fn limits(
        &self,
        machine: &Machine,
        places: impl Iterator<Item = (Joints, SeamFrame)>,
    ) -> Result<SlideLimits, Error> {
        let Self::Slides { machine, head, axes } = self else {
            let places = places.map(|(q, frame)| (q, [frame.lateral, frame.height]));
            return Ok(OverAxes::limits(machine, places, RANGE_MM)?);
        };
        let infinite = f64::INFINITY;
        let mut most = SlideLimits { stroke_mm: infinite, speed: infinite, acceleration: infinite, jerk: infinite };
        for (q, frame) in places {
            let Some(by_slide) = slides_by(machine, *head, *axes, &q, &frame) else {
                return Err(Error::NoSlide { machine: machine.name.clone(), head: head + 1 });
            };
            for (k, axis) in axes.iter().map(|i| &machine.axes[*i]).enumerate() {
                let gain = by_slide.row(k).abs().element_sum();
                let room = axis.range.map_or(infinite, |(low, high)| (high - q[axes[k]]).min(q[axes[k]] - low));
                most.stroke_mm = most.stroke_mm.min(room / gain);
                most.speed = most.speed.min(axis.max_speed / gain);
                most.acceleration = most.acceleration.min(axis.max_acceleration / gain);
                most.jerk = most.jerk.min(axis.jerk() / gain);
            }
        }
        most.check()?;
        Ok(most)
    }

    /// The positions `q` with the torch `by` (lateral and height, mm) beside where they put it; none where the axes
    /// cannot. No allocation.
    pub(crate) fn shifted(&mut self, q: &Joints, frame: &SeamFrame, by: DVec2) -> Option<Joints> {
        match self {
            Self::Axes(over) => over.shifted(q, by.x * frame.lateral + by.y * frame.height).ok(),
            Self::Slides { machine, head, axes } => {
                let slides = slides_by(machine, *head, *axes, q, frame)? * by;
                let mut q = *q;
                q[axes[0]] += slides.x;
                q[axes[1]] += slides.y;
                Some(q)
            }
        }
    }
}

/// What both slides do for corrections, lateral and height.
fn slides_by(machine: &Machine, head: usize, axes: [usize; 2], q: &Joints, frame: &SeamFrame) -> Option<DMat2> {
    let columns = machine.heads[head].chain.jacobian(&machine.true_positions(q));
    let seen = |way: DVec3| DVec2::new(way.dot(frame.lateral), way.dot(frame.height));
    let moved = DMat2::from_cols(seen(columns[axes[0]].0), seen(columns[axes[1]].0));
    (moved.determinant().abs() > 1e-3).then(|| moved.inverse())
}
