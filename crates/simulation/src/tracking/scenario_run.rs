use super::scenario::{HeadScene, Scenario};
use super::sensor_model::Sensor;
use super::travel::{Leg, Travel};
use super::weld_statistics::{MissDistribution, Turns};
use super::world::World;
use crate::drives::DriveSet;
use crate::error::Error;
use glam::DVec2;
use seamwright_executive::tracking::{self, LimitUse, PassPosition};
use seamwright_machine::Machine;
use seamwright_program::is_before;
use seamwright_servo::SetPoint;
use seamwright_tracking::actuator::{Alarm, Cause, HeadTracking, Slide, SlideLimits};
use seamwright_tracking::lead::{Measurement, Moment, OwnCurve, SampleBuffer, Settings};

/// Method by which the seam is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// No correction.
    Uncorrected,
    /// As DUALBEAM-2013, one step per sample.
    OneStep,
    /// As DUALBEAM-2013 at high speed, each step divided into one part per cycle.
    Subdivided,
    /// By path length.
    Tracked,
}

impl Method {
    /// All methods.
    pub const ALL: [Self; 4] = [Self::Uncorrected, Self::OneStep, Self::Subdivided, Self::Tracked];
}

/// Result of one head's weld.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// 99 % of the weld lie within this distance of the seam, lateral and height together, mm.
    pub p99_mm: f64,
    /// Maximum distance, mm.
    pub most_mm: f64,
    /// Median distance, mm.
    pub median_mm: f64,
    /// Welded distance, mm; stretches welded twice count twice.
    pub welded_mm: f64,
    /// Position at which the torch was stopped before the end, mm.
    pub stopped_mm: Option<f64>,
    /// Most severe alarm.
    pub alarm: Option<Alarm>,
    /// Position of the first alarm, mm.
    pub alarm_mm: Option<f64>,
    /// Fault of the sensor at the end.
    pub cause: Option<Cause>,
    /// Number of reversals of set-points since the fault of the scene, the larger of both axes.
    pub turns: u32,
    /// Maximum share of each limit used by set-points: stroke, speed, acceleration, jerk; the worse of both axes.
    pub used: [f64; 4],
    /// Every tenth of a second: position of the torch, miss, slide; mm.
    pub places: Vec<(f64, DVec2, DVec2)>,
}

/// Welds a scenario on the drives of `machine`'s cross slides, its first head with the first scene. The same seed gives
/// the same weld.
///
/// # Errors
/// [`Error::Cell`] for invalid drives, [`Error::Tracking`] for invalid settings, such as a lead too short.
pub fn run(scenario: &Scenario, machine: &Machine, method: Method, seed: u64) -> Result<Vec<Outcome>, Error> {
    let cycle_s = machine.servo_period_s;
    let mut drives = DriveSet::new(machine, seed)?;
    drives.settle_at(&vec![0.0; machine.axes.len()]);
    let heads = scenario.heads.iter().enumerate();
    let heads = heads.map(|(i, scene)| Head::new(scenario, scene, machine, i, method, seed));
    let mut heads = heads.collect::<Result<Vec<_>, Error>>()?;
    let lead = scenario.heads.iter().map(|h| h.sensor.lead_mm).fold(0.0, f64::max);
    let mut travel = Travel::new(-lead - 10.0, &scenario.legs);
    let (mut t, mut feed_override) = (0.0, 1.0);
    while travel.step(feed_override, cycle_s) {
        t += cycle_s;
        feed_override = 1.0;
        for head in &mut heads {
            feed_override = head.cycle(&mut drives, t, &travel).min(feed_override);
        }
    }
    let end = match scenario.legs.last() {
        Some(Leg::To(end, _)) if is_before(travel.s, *end) => Some(travel.s),
        _ => None,
    };
    Ok(heads.into_iter().map(|head| head.outcome(end)).collect())
}

/// Source of the slides' set-points.
enum Follower {
    None,
    Samples { buffer: SampleBuffer, slides: Box<[Slide; 2]>, own: OwnCurve },
    Tracking(Box<HeadTracking>),
}

struct Head<'a> {
    world: World<'a>,
    length: f64,
    sensor: Sensor,
    follower: Follower,
    least_confidence: f64,
    axes: [usize; 2],
    cycle_s: f64,
    stuck_mm: Option<f64>,
    slide: DVec2,
    ordered: [DVec2; 3],
    misses: MissDistribution,
    limits: [LimitUse; 2],
    fault_mm: Option<f64>,
    turns: [Turns; 2],
    outcome: Outcome,
    next_place_s: f64,
}

/// Time between positions kept for plots, s.
const PLACE_S: f64 = 0.1;

impl<'a> Head<'a> {
    fn new(
        scenario: &Scenario,
        scene: &'a HeadScene,
        machine: &Machine,
        number: usize,
        method: Method,
        seed: u64,
    ) -> Result<Self, Error> {
        let (axes, limits) = slides(machine, number)?;
        let cycle_s = machine.servo_period_s;
        let model = scene.sensor;
        let settings = settings(scenario, scene, cycle_s);
        let length = scene.seam.length_mm;
        let own = || OwnCurve::of(model.lead_mm, -model.lead_mm - 10.0, length, &scene.seam.frame);
        let follower = match method {
            Method::Uncorrected => Follower::None,
            Method::Tracked => Follower::Tracking(Box::new(HeadTracking::new(settings, own(), limits)?)),
            Method::OneStep | Method::Subdivided => {
                let [x, y] = limits.map(|l| Slide::new(l, cycle_s));
                let slides = Box::new([x?, y?]);
                let parts = if method == Method::OneStep { 1 } else { (model.period_s / cycle_s).round() as u32 };
                // The paper matches lead and speed; the delay of sensor and slide is matched too.
                let late = model.latency_s + slides[0].lag_s() + model.period_s * if parts == 1 { 0.5 } else { 1.0 };
                let lead = model.lead_mm - scenario.speed_mm_s * late;
                let buffer = SampleBuffer::new(lead, scenario.speed_mm_s, model.period_s, parts);
                Follower::Samples { buffer, slides, own: own() }
            }
        };
        let (displacement, placement) = (scene.displacement.clone(), scene.placement);
        Ok(Self {
            world: World {
                taught: &*scene.seam.frame,
                displacement,
                placement,
                along: PassPosition { round_mm: scene.seam.round_mm, ..PassPosition::default() },
                ends_mm: None,
            },
            length,
            sensor: Sensor::new(model, seed.wrapping_mul(8).wrapping_add(number as u64)),
            follower,
            least_confidence: settings.least_confidence,
            axes,
            cycle_s,
            stuck_mm: scene.stuck_mm,
            slide: DVec2::ZERO,
            ordered: [DVec2::ZERO; 3],
            misses: MissDistribution::default(),
            limits: limits.map(|l| LimitUse::new(l, cycle_s)),
            fault_mm: scene.stuck_mm.or(model.fault.map(|(from, _)| from)),
            turns: [Turns::default(); 2],
            outcome: Outcome {
                p99_mm: f64::INFINITY,
                most_mm: f64::INFINITY,
                median_mm: f64::INFINITY,
                welded_mm: 0.0,
                stopped_mm: None,
                alarm: None,
                alarm_mm: None,
                cause: None,
                turns: 0,
                used: [0.0; 4],
                places: Vec::new(),
            },
            next_place_s: 0.0,
        })
    }

    /// Runs one cycle; returns the maximum feed override of the torch in the next.
    fn cycle(&mut self, drives: &mut DriveSet, t: f64, travel: &Travel<'_>) -> f64 {
        let (s, speed) = (travel.s, travel.speed);
        self.sensor.look(&self.world, t, s, self.slide);
        while let Some(arrived) = self.sensor.arrived(t) {
            self.take(arrived, t, s);
        }
        let (order, feed_override) = self.order(t, s, speed);
        self.limits[0].add(order.x);
        self.limits[1].add(order.y);
        if self.fault_mm.is_some_and(|from| s >= from) {
            self.turns[0].add(order.x);
            self.turns[1].add(order.y);
        }
        let stuck = self.stuck_mm.is_some_and(|from| s >= from);
        self.drive(drives, if stuck { self.ordered[0] } else { order });
        self.measure(t, s, speed);
        feed_override
    }

    fn take(&mut self, arrived: Option<Measurement>, t: f64, s: f64) {
        match &mut self.follower {
            Follower::None => {}
            Follower::Tracking(head) => {
                if let Some(measured) = arrived {
                    head.take(&measured, t);
                }
            }
            Follower::Samples { buffer, own, .. } => {
                let sure = arrived.filter(|m| m.confidence >= self.least_confidence);
                // The slide is read when the sample arrives.
                buffer.sample(sure.map(|m| m.offset - own.at(s).offset), self.slide);
            }
        }
    }

    fn order(&mut self, t: f64, s: f64, speed: f64) -> (DVec2, f64) {
        match &mut self.follower {
            Follower::None => (DVec2::ZERO, 1.0),
            Follower::Samples { buffer, slides, .. } => {
                let target = buffer.step();
                (DVec2::new(slides[0].step(target.x), slides[1].step(target.y)), 1.0)
            }
            Follower::Tracking(head) => {
                let orders = head.cycle(Moment { t_s: t, s_mm: s, slide: self.slide }, speed);
                if s >= 0.0 && orders.alarm.is_some() && self.outcome.alarm_mm.is_none() {
                    self.outcome.alarm_mm = Some(s);
                }
                if s >= 0.0 {
                    self.outcome.cause = orders.cause;
                    self.outcome.alarm = self.outcome.alarm.max(orders.alarm);
                }
                // The seam is unknown before its start.
                (orders.slide, if s < 0.0 { 1.0 } else { orders.feed_override })
            }
        }
    }

    fn drive(&mut self, drives: &mut DriveSet, order: DVec2) {
        let [last, before, _] = self.ordered;
        self.ordered = [order, last, before];
        let velocity = (order - last) / self.cycle_s;
        let acceleration = (order - 2.0 * last + before) / (self.cycle_s * self.cycle_s);
        let mut at = DVec2::ZERO;
        for (k, axis) in self.axes.into_iter().enumerate() {
            let set = SetPoint { position: order[k], velocity: velocity[k], acceleration: acceleration[k] };
            at[k] = drives.step(axis, set).position;
        }
        self.slide = at;
    }

    fn measure(&mut self, t: f64, s: f64, speed: f64) {
        if !(0.0..=self.length).contains(&s) {
            return;
        }
        let Some(miss) = self.world.miss(s, self.slide) else { return };
        // Going back, the arc is off.
        if speed > 0.0 {
            self.misses.add(miss, speed * self.cycle_s);
        }
        if t >= self.next_place_s {
            self.next_place_s = t + PLACE_S;
            self.outcome.places.push((s, miss, self.slide));
        }
    }

    fn outcome(mut self, stopped_mm: Option<f64>) -> Outcome {
        let [p99_mm, most_mm, median_mm] = [0.99, 1.0, 0.5].map(|part| self.misses.quantile(part));
        let turns = self.turns[0].count.max(self.turns[1].count);
        let used = std::array::from_fn(|i| self.limits[0].used[i].max(self.limits[1].used[i]));
        Outcome { p99_mm, most_mm, median_mm, welded_mm: self.misses.way(), stopped_mm, turns, used, ..self.outcome }
    }
}

/// Tracking settings for a scene's sensor, as the file of such a sensor would give them.
fn settings(scenario: &Scenario, scene: &HeadScene, cycle_s: f64) -> Settings {
    let tack_mm = scene.displacement.tacks.iter().map(|(from, to)| to - from).fold(0.0, f64::max);
    Settings { tack_mm, ..scene.sensor.settings(cycle_s, scenario.speed_mm_s) }
}

/// Returns both axes of the cross slide of head `number`, and their limits.
fn slides(machine: &Machine, number: usize) -> Result<([usize; 2], [SlideLimits; 2]), Error> {
    let none = || tracking::Error::NoSlide { machine: machine.name.clone(), head: number + 1 };
    let mut axes = machine.heads.get(number).ok_or_else(none)?.slides.iter();
    let axes = [axes.next().ok_or_else(none)?, axes.next().ok_or_else(none)?];
    let limits = axes.map(|i| {
        let axis = &machine.axes[i];
        let stroke_mm = axis.range.map_or(f64::MAX, |(low, high)| high.min(-low));
        SlideLimits { stroke_mm, motion: axis.limits() }
    });
    Ok((axes, limits))
}
