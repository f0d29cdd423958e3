use super::error::Error;
use glam::{DMat2, DVec2, DVec3, Vec3Swizzles as _};
use seamwright_machine::{AxisSet, Joints, Machine};
use seamwright_tracking::actuator::{OverAxes, SlideAuthority, SlideLimits};
use seamwright_tracking::lead::SeamFrame;

/// Maximum distance by which the machine's own axes move a torch off its planned path, mm.
const RANGE_MM: f64 = 6.0;

/// Moves the torches of a pass off their planned paths: with the machine's own axes, or with the cross slides of its
/// heads. Near the ends of the slides, the axes that carry all heads take over.
#[derive(Debug, Clone)]
pub(super) struct Carrier<'a> {
    machine: &'a Machine,
    over: OverAxes<'a>,
    /// The slides of each head.
    slides: Vec<[usize; 2]>,
    authority: Option<SlideAuthority>,
    limits: SlideLimits,
}

/// Frame of a head in a cycle and its required offset, lateral and height, mm.
pub(super) type Wanted = (SeamFrame, DVec2);

impl<'a> Carrier<'a> {
    /// Creates the carrier for the first heads of `machine`, from planned positions along a path and each head's frames
    /// there. The `held` axes stand still. Errors: [`Error::NoSlide`] if one of two heads has no movable cross slide;
    /// axes that cannot carry out corrections.
    pub(super) fn new(machine: &'a Machine, held: AxisSet, places: &[(Joints, Vec<SeamFrame>)]) -> Result<Self, Error> {
        let heads = places.first().map_or(1, |(_, frames)| frames.len());
        let slides = slides(machine, heads, held)?;
        let both = places.iter().map(|(q, frames)| (*q, [frames[0].lateral, frames[0].height]));
        let over = if slides.is_empty() { OverAxes::new(machine) } else { OverAxes::carrying_all(machine) };
        let over = over.holding(held);
        let axes = over.limits(both, RANGE_MM)?;
        if slides.is_empty() {
            return Ok(Self { machine, over, slides, authority: None, limits: axes });
        }
        let mut least: Option<SlideLimits> = None;
        for (q, frames) in places {
            for (head, frame) in frames.iter().enumerate() {
                let here = slide_limits(machine, head, slides[head], q, frame)?;
                least = Some(least.map_or(here, |least| lesser(&least, &here)));
            }
        }
        let slide = least.unwrap_or(axes);
        let authority = SlideAuthority::new(slide, axes, machine.servo_period_s)?;
        // The axes move all heads together, so two heads that drift apart have only their own slides.
        let stroke_mm = if heads > 1 { slide.stroke_mm } else { authority.limits().stroke_mm };
        let limits = SlideLimits { stroke_mm, ..authority.limits() };
        Ok(Self { machine, over, slides, authority: Some(authority), limits })
    }

    /// Returns the axes that move all heads together, in their current state.
    pub(super) fn carrying(&self) -> OverAxes<'a> {
        self.over.clone()
    }

    /// Returns the limits of corrections, for lateral and height each.
    pub(super) fn limits(&self) -> SlideLimits {
        self.limits
    }

    /// Returns the positions `q` with every torch offset as wanted, or `None` if the axes cannot. Does not allocate.
    pub(super) fn shifted(&mut self, q: &Joints, wanted: &[Wanted]) -> Option<Joints> {
        let (first, by) = wanted.first()?;
        let Some(authority) = &mut self.authority else {
            return self.over.shifted(q, by.x * first.lateral + by.y * first.height).ok();
        };
        // The axes move all heads together: they take over the common part.
        let excess = |(frame, by): &Wanted| {
            let left = authority.excess(*by);
            left.x * frame.lateral + left.y * frame.height
        };
        let common = wanted.iter().map(excess).sum::<DVec3>() / wanted.len() as f64;
        let taken = authority.step(first.components(common).yz());
        let carried = taken.x * first.lateral + taken.y * first.height;
        let mut shifted = if carried == DVec3::ZERO { *q } else { self.over.shifted(q, carried).ok()? };
        for (head, (frame, by)) in wanted.iter().enumerate() {
            let left = *by - frame.components(carried).yz();
            if !authority.has_room(left) {
                return None;
            }
            let axes = self.slides[head];
            let slides = slides_by(self.machine, head, axes, q, frame)? * left;
            shifted[axes[0]] += slides.x;
            shifted[axes[1]] += slides.y;
        }
        Some(shifted)
    }
}

/// Returns the cross slides of the first `heads` heads; empty for a single head without movable ones.
fn slides(machine: &Machine, heads: usize, held: AxisSet) -> Result<Vec<[usize; 2]>, Error> {
    let of = |head: usize| {
        let mut slides = machine.heads.get(head)?.slides.iter().filter(|slide| !held.has(*slide));
        Some([slides.next()?, slides.next()?])
    };
    match (0..heads).map(of).collect::<Option<Vec<_>>>() {
        Some(slides) => Ok(slides),
        None if heads == 1 => Ok(Vec::new()),
        None => {
            let head = (0..heads).find(|head| of(*head).is_none()).map_or(heads, |head| head + 1);
            Err(Error::NoSlide { machine: machine.name.clone(), head })
        }
    }
}

/// Limits of corrections in a frame, from the slides there.
fn slide_limits(
    machine: &Machine,
    head: usize,
    axes: [usize; 2],
    q: &Joints,
    frame: &SeamFrame,
) -> Result<SlideLimits, Error> {
    let none = || Error::SlidesAside { machine: machine.name.clone(), head: head + 1 };
    let by_slide = slides_by(machine, head, axes, q, frame).ok_or_else(none)?;
    let one = |k: usize| {
        let (i, axis) = (axes[k], &machine.axes[axes[k]]);
        let gain = by_slide.row(k).abs().element_sum();
        let room = axis.range.map_or(f64::MAX, |(low, high)| (high - q[i]).min(q[i] - low));
        SlideLimits { stroke_mm: room / gain, motion: axis.limits().divided(gain) }
    };
    let limits = lesser(&one(0), &one(1));
    limits.check()?;
    Ok(limits)
}

fn lesser(a: &SlideLimits, b: &SlideLimits) -> SlideLimits {
    SlideLimits { stroke_mm: a.stroke_mm.min(b.stroke_mm), motion: a.motion.min(b.motion) }
}

/// Matrix from a correction, lateral and height, to the displacements of both slides.
fn slides_by(machine: &Machine, head: usize, axes: [usize; 2], q: &Joints, frame: &SeamFrame) -> Option<DMat2> {
    let columns = machine.heads[head].chain.jacobian(&machine.true_positions(q));
    let moved = DMat2::from_cols(frame.components(columns[axes[0]].0).yz(), frame.components(columns[axes[1]].0).yz());
    (moved.determinant().abs() > 1e-3).then(|| moved.inverse())
}
