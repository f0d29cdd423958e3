use crate::singular;
use glam::DVec3;
use seamwright_geometry::angle_between;
use seamwright_machine::{AxisKind, AxisSet, Joints, MAX_AXES, Machine, Target};
use seamwright_program::{
    FilletOrButt, Inclination, Pass, Position, PositionLimits, Procedure, SpareAxes, TorchPath, WeldingPosition,
};
use std::f64::consts::{PI, TAU};

/// Residuals of one station: limits and turns by axis, ends of ranges by axis, then singularity, position, clearance,
/// allowed positions.
pub(crate) const ROWS: usize = 3 * MAX_AXES + 4;
const ENDS: usize = MAX_AXES;
const TURNS: usize = 2 * MAX_AXES;
const SINGULAR: usize = 3 * MAX_AXES;
const POSITION: usize = SINGULAR + 1;
const CLEARANCE: usize = SINGULAR + 2;
const ALLOWED: usize = SINGULAR + 3;

/// Fraction of a range, before its end, in which proximity costs.
const MARGIN: f64 = 0.1;
/// Fraction of a range, before its end, to be avoided.
const INSET: f64 = 0.002;
/// Factor of the ends' residuals relative to the root of the maximum weight.
const STRONG: f64 = 100.0;
/// Margin of a weld to the limits of the positions that its procedure allows, degrees.
const ALLOWED_MARGIN_DEG: f64 = 2.0;
/// Weight of a degree beyond these limits, relative to the maximum weight of the wishes.
const ALLOWED_WEIGHT: f64 = 5.0;
/// Sine of the distance from a singular attitude below which proximity costs.
const SINGULAR_NEAR: f64 = 0.342;
/// Fraction of an axis' speed and acceleration above which use costs as much as a limit.
const USABLE: f64 = 0.9;
const EXCESS: f64 = 10.0;

#[derive(Clone, Copy)]
pub(crate) struct AllowedPositions<'a> {
    pub(crate) limits: &'a PositionLimits,
    pub(crate) joint: FilletOrButt,
    pub(crate) positions: &'a [WeldingPosition],
}

/// Number of samples of the faces.
const FACES: u32 = 60;

impl<'a> AllowedPositions<'a> {
    /// Positions that `procedure` allows for `pass`, the `number`-th, along `path`; none if it allows all.
    pub(crate) fn of(procedure: &'a Procedure, path: &dyn TorchPath, pass: &Pass, number: usize) -> Option<Self> {
        let positions = procedure.run_of(number, pass)?.positions.as_deref()?;
        let places = (0..=FACES).map(|i| path.length() * f64::from(i) / f64::from(FACES));
        let angles = places.filter_map(|s| path.groove(s)).map(|groove| groove.dihedral);
        let ends = angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), a| (low.min(a), high.max(a)));
        let ends = if ends.0 <= ends.1 { ends } else { (PI, PI) };
        Some(Self { limits: &procedure.position_limits, joint: procedure.joint(ends.0, ends.1), positions })
    }

    /// Distance of a weld outside all of them, degrees; negative within one.
    pub(crate) fn beyond(&self, at: Inclination) -> f64 {
        let each = self.positions.iter().map(|position| self.limits.beyond(self.joint, *position, at));
        // A joint without any of these positions gets a constant.
        each.fold(180.0, f64::min)
    }
}

/// Cost of the axes' positions and motion: a mean over the path of squares of dimensionless residuals.
pub(crate) struct Cost<'a> {
    machine: &'a Machine,
    wishes: &'a SpareAxes,
    clearance: Option<Clearance<'a>>,
    positions: Option<AllowedPositions<'a>>,
    decided: AxisSet,
    /// Axes held by request: their positions are fixed.
    still: AxisSet,
    /// True if axes can turn or tilt the work against gravity.
    tilts: bool,
    ends: f64,
    allowed: f64,
    /// Roots of the weights of motion and acceleration, times the factor from a derivative by s to a fraction of the
    /// limit.
    pub(crate) speed: Joints,
    pub(crate) acceleration: Joints,
}

impl<'a> Cost<'a> {
    /// Cost of motions of `machine` towards `aim`, with the axes in `still` held at `base`.
    pub(crate) fn new(machine: &'a Machine, aim: Aim<'a>, still: AxisSet, base: &Joints) -> Self {
        let Aim { speed, wishes, clearance, positions, .. } = aim;
        let w = &wishes.weights;
        let all: AxisSet = (0..machine.axes.len()).collect();
        // A weight of motion above 0 keeps the optimum unique.
        let root = |weight: f64| weight.max(1e-6).sqrt();
        let (mut rate, mut acceleration) = (Joints::default(), Joints::default());
        for (i, axis) in machine.axes.iter().enumerate() {
            rate[i] = root(w.motion.get()) * speed / axis.max_speed;
            acceleration[i] = root(w.acceleration.get()) * speed * speed / axis.max_acceleration;
        }
        let most =
            [w.limits, w.singularity, w.position, w.wind_up, w.clearance].iter().fold(1.0, |m, w| w.get().max(m));
        Self {
            machine,
            wishes,
            clearance,
            positions,
            decided: all.different(machine.free().union(still)),
            still,
            // Dependent axes under the work turn with the free ones.
            tilts: tilts(machine, all.different(still), base),
            ends: STRONG * most.sqrt(),
            allowed: ALLOWED_WEIGHT * most,
            speed: rate,
            acceleration,
        }
    }

    pub(crate) fn place(&self, q: &Joints, place: &Place) -> [f64; ROWS] {
        let w = &self.wishes.weights;
        let mut rows = [0.0; ROWS];
        let root = f64::sqrt;
        for (i, axis) in self.machine.axes.iter().enumerate().filter(|(i, _)| !self.still.has(*i)) {
            if let Some((low, high)) = axis.range {
                let inside = (q[i] - low).min(high - q[i]) / (high - low);
                rows[i] = root(w.limits.get()) * (1.0 - inside / MARGIN).max(0.0);
                rows[ENDS + i] = self.ends * (INSET - inside).max(0.0) / MARGIN;
            }
            let winds = axis.range.is_none_or(|(low, high)| high - low > TAU);
            if axis.kind == AxisKind::Rotary && winds {
                rows[TURNS + i] = root(w.wind_up.get()) * ((q[i] - axis.home).abs() - PI).max(0.0) / TAU;
            }
        }
        if w.singularity.get() > 0.0
            && let Some(distance) = singular::distance(self.machine, self.decided, q)
        {
            rows[SINGULAR] = root(w.singularity.get()) * (1.0 - distance / SINGULAR_NEAR).max(0.0);
        }
        let up = if self.tilts { self.machine.up_in_work(q) } else { self.machine.up };
        if let (true, Some(positions)) = (self.tilts, &self.positions) {
            let beyond = positions.beyond(Inclination::new(place.tangent, place.face, up));
            let lacking = (beyond + ALLOWED_MARGIN_DEG).max(0.0);
            // The square grows linearly, faster than that of any wish but slower than that of the ends of ranges.
            rows[ALLOWED] = root(2.0 * self.allowed * ((1.0 + lacking * lacking).sqrt() - 1.0));
        }
        if self.tilts && self.wishes.position == Position::Flat && w.position.get() > 0.0 {
            let angle = angle_between(up, place.face);
            let beyond = (angle.to_degrees() - self.wishes.flat_within_deg.get()).max(0.0);
            rows[POSITION] = root(w.position.get()) * beyond / 10.0;
        }
        if let Some(clearance) = &self.clearance {
            let (distance, wanted) = ((clearance.distance)(q), clearance.wanted_mm);
            // Grows as 1 / distance; inside an obstacle linearly, so that the gradient leads out.
            let lacking = (wanted - distance).max(0.0);
            rows[CLEARANCE] = root(w.clearance.get()) * lacking / distance.max(0.05 * wanted);
        }
        rows
    }

    /// The square of a rate (a fraction of the limit, times its weight), plus that of the excess beyond the usable
    /// fraction.
    pub(crate) fn rate(rate: f64) -> f64 {
        let excess = EXCESS * (rate.abs() - USABLE).max(0.0);
        rate * rate + excess * excess
    }

    /// The excess beyond the usable fraction as a residual, and its derivative by the rate.
    pub(crate) fn excess(rate: f64) -> Option<(f64, f64)> {
        let over = rate.abs() - USABLE;
        (over > 0.0).then(|| (EXCESS * over * rate.signum(), EXCESS))
    }
}

/// True if any axis in `axes` tilts or turns the work against gravity, with the others at `base`.
fn tilts(machine: &Machine, axes: AxisSet, base: &Joints) -> bool {
    let up = machine.up_in_work(base);
    axes.iter().any(|axis| {
        let mut q = *base;
        q[axis] += 0.1;
        (machine.up_in_work(&q) - up).length() > 1e-6
    })
}

/// Distance to obstacles, for the choice of the free axes.
#[derive(Clone, Copy)]
pub struct Clearance<'a> {
    /// Minimum distance (mm) at axis positions, negative inside an obstacle; continuous.
    pub distance: &'a dyn Fn(&Joints) -> f64,
    /// Distance above which more has no benefit, mm; greater than 0.
    pub wanted_mm: f64,
}

/// Criteria for the choice of the free axes.
#[derive(Clone, Copy)]
pub(crate) struct Aim<'a> {
    pub(crate) speed: f64,
    pub(crate) wishes: &'a SpareAxes,
    pub(crate) clearance: Option<Clearance<'a>>,
    pub(crate) positions: Option<AllowedPositions<'a>>,
    /// False if the reason for a missing path is not needed: without a closed form it is slow to find.
    pub(crate) explains: bool,
    /// True for a search that may miss a path which a thorough one finds, in a small part of its time.
    pub(crate) is_quick: bool,
}

pub(super) struct Place {
    pub(super) s: f64,
    pub(super) target: Target,
    pub(super) face: DVec3,
    pub(super) tangent: DVec3,
}
