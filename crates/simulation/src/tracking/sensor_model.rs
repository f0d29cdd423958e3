use super::world::World;
use crate::camera_simulator::stripe::{Placement, Section, StripeDisturbances, StripeScene};
use crate::disturbance::uniform;
use glam::DVec2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use seamwright_executive::tracking::{FIELD_MM, LeadingSensor};
use seamwright_tracking::lead::{Measurement, Settings};
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use std::collections::VecDeque;

/// Fault of a sensor, from a position of the torch on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// No measurement arrives any more.
    Silent,
    /// The same value arrives again and again.
    Frozen,
    /// Random values arrive.
    Wild,
    /// Every measurement arrives later by this time, s.
    Late(f64),
    /// The clock jumps by this time, s.
    ClockStep(f64),
}

/// Input of a leading sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sees {
    /// Offsets with noise, as if images had been read.
    Offsets,
    /// Images of a laser stripe across a joint of this section, with these disturbances, read as those of a real
    /// sensor.
    Stripes(Section, JointKind, StripeDisturbances),
}

/// Model of a leading sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorModel {
    /// Lead, mm.
    pub lead_mm: f64,
    /// Time between exposures, s.
    pub period_s: f64,
    /// Time from exposure to arrival, s.
    pub latency_s: f64,
    /// Maximum variation of arrivals and exposures, as a share of the period.
    pub jitter: f64,
    /// Standard deviation of the noise, mm.
    pub noise_mm: f64,
    /// Share of measurements that are random within 3 mm, with full confidence.
    pub outliers: f64,
    /// Half of the field of view, mm.
    pub field_mm: f64,
    /// Fault, and the position of the torch from which it occurs, mm.
    pub fault: Option<(f64, Fault)>,
    /// Input of the sensor.
    pub sees: Sees,
}

impl SensorModel {
    /// Returns the usual model: 100 exposures a second, 15 ms late, 0.02 mm of noise.
    #[must_use]
    pub const fn usual(lead_mm: f64) -> Self {
        let (period_s, latency_s, noise_mm) = (0.01, 0.015, 0.02);
        let (field_mm, sees) = (FIELD_MM, Sees::Offsets);
        Self { lead_mm, period_s, latency_s, jitter: 0.0, noise_mm, outliers: 0.0, field_mm, fault: None, sees }
    }

    /// Returns the model of a machine's sensor, as its file describes it.
    pub(super) fn of(sensor: &LeadingSensor) -> Self {
        let LeadingSensor { lead_mm, period_s, latency_s, noise_mm, field_mm } = *sensor;
        Self { period_s, latency_s, noise_mm, field_mm, ..Self::usual(lead_mm) }
    }

    /// Returns the tracking settings for such a sensor, as its file would give them, with cycles of `cycle_s` and up
    /// to `speed_mm_s`.
    pub(super) fn settings(&self, cycle_s: f64, speed_mm_s: f64) -> Settings {
        let Self { lead_mm, period_s, latency_s, noise_mm, field_mm, .. } = *self;
        LeadingSensor { lead_mm, period_s, latency_s, noise_mm, field_mm }.settings(cycle_s, speed_mm_s)
    }
}

#[derive(Debug)]
pub(super) struct Sensor {
    model: SensorModel,
    random: Pcg64Mcg,
    /// Time of the first exposure.
    begun_s: Option<f64>,
    next_s: f64,
    count: u64,
    under_way: VecDeque<(f64, Option<Measurement>)>,
    frozen: Option<DVec2>,
    reader: StripeReader,
}

/// Columns and rows of the stripe images, and the size of a pixel, mm.
const STRIPE_PX: [usize; 2] = [640, 512];
const STRIPE_MM_PER_PX: f64 = 0.04;

impl Sensor {
    pub(super) fn new(model: SensorModel, seed: u64) -> Self {
        let random = Pcg64Mcg::seed_from_u64(seed ^ 0x5e05_0000_0000_0003);
        Self {
            model,
            random,
            begun_s: None,
            next_s: 0.0,
            count: 0,
            // Few measurements are in transit at once.
            under_way: VecDeque::with_capacity(64),
            frozen: None,
            reader: StripeReader::new(),
        }
    }

    /// Exposes if due, with the torch at `s` and the slide at `slide`.
    pub(super) fn look(&mut self, world: &World<'_>, t: f64, s: f64, slide: DVec2) {
        let begun = *self.begun_s.get_or_insert(t);
        if t + 1e-9 < self.next_s {
            return;
        }
        let SensorModel { period_s, latency_s, jitter, .. } = self.model;
        self.count += 1;
        self.next_s = begun + period_s * (self.count as f64 + jitter * (uniform(&mut self.random) - 0.5));
        let mut seen = self.seen(world, s, slide);
        // Arrivals come up to a period sooner or later.
        let mut arrives = t + latency_s + jitter * period_s * (2.0 * uniform(&mut self.random) - 1.0);
        let mut stamp = t;
        if let Some((from, fault)) = self.model.fault
            && s >= from
        {
            match fault {
                Fault::Silent => return,
                Fault::Frozen => {
                    let offset = *self.frozen.get_or_insert(seen.map_or(DVec2::ZERO, |m| m.0));
                    seen = Some((offset, 0.95));
                }
                Fault::Wild => seen = Some((self.anything(4.0), 0.95)),
                Fault::Late(by) => arrives += by,
                Fault::ClockStep(by) => stamp += by,
            }
        }
        let measured = seen.map(|(offset, confidence)| Measurement { exposed_s: stamp, offset, confidence });
        self.under_way.push_back((arrives, measured));
    }

    /// Returns the next measurement that has arrived at `t`; the inner `None` means that the sensor saw no joint.
    pub(super) fn arrived(&mut self, t: f64) -> Option<Option<Measurement>> {
        self.under_way.remove(self.under_way.iter().position(|(due, _)| *due <= t + 1e-9)?).map(|(_, m)| m)
    }

    fn seen(&mut self, world: &World<'_>, s: f64, slide: DVec2) -> Option<(DVec2, f64)> {
        let (seam, place) = world.crossing(s, self.model.lead_mm, s)?;
        if !world.has(place) {
            return None;
        }
        if world.displacement.is_tacked(world.along.place(place)) {
            // Mostly no measurement, else the tack's own shape, which the reader does not trust.
            let faint = 0.35 * uniform(&mut self.random);
            return (self.random.next_u64() % 5 < 2).then(|| (self.anything(1.0) + DVec2::new(0.5, 0.8), faint));
        }
        let offset = seam - slide;
        if offset.abs().max_element() > self.model.field_mm {
            return None;
        }
        if uniform(&mut self.random) < self.model.outliers {
            return Some((self.anything(3.0), 0.95));
        }
        if let Sees::Stripes(section, kind, how) = self.model.sees {
            return self.read(section, kind, &how, offset);
        }
        let noise = DVec2::new(self.normal(), self.normal()) * self.model.noise_mm;
        Some((offset + noise, 0.95))
    }

    /// Reads an image of the joint's stripe at `offset`.
    fn read(
        &mut self,
        section: Section,
        kind: JointKind,
        how: &StripeDisturbances,
        offset: DVec2,
    ) -> Option<(DVec2, f64)> {
        let placement = Placement { at: offset, ..Placement::default() };
        let scene = StripeScene::new(section, placement, STRIPE_PX, STRIPE_MM_PER_PX);
        let image = scene.image(how, self.random.next_u64()).image;
        let frame = image.frame().ok()?;
        let task = StripeTask::in_mm(kind);
        let found = self.reader.read_image(&frame, Some(&scene.to_mm), &task).ok()?;
        // The sensor's zero is at the joint point.
        Some((found.joint() - section.truth(&Placement::default()).joint()?, found.confidence))
    }

    fn anything(&mut self, size: f64) -> DVec2 {
        DVec2::new(2.0 * uniform(&mut self.random) - 1.0, 2.0 * uniform(&mut self.random) - 1.0) * size
    }

    /// Normally distributed (Box and Muller).
    fn normal(&mut self) -> f64 {
        let size = (-2.0 * (1.0 - uniform(&mut self.random)).ln()).sqrt();
        size * (std::f64::consts::TAU * uniform(&mut self.random)).cos()
    }
}
