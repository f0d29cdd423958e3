use super::World;
use crate::disturbance::uniform;
use crate::eyes::stripe::{Placement, Section, StripeDisturbances, StripeScene};
use glam::DVec2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use seamwright_tracking::lead::{Measurement, Settings};
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use std::collections::VecDeque;

/// What goes wrong with a sensor, from a place of the torch on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// Nothing comes any more.
    Silent,
    /// The same value comes again and again.
    Frozen,
    /// Anything comes.
    Wild,
    /// Everything comes so much later, s.
    Late(f64),
    /// Its clock jumps by so much, s.
    ClockStep(f64),
}

/// What a leading sensor sees with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sees {
    /// Offsets with noise: as if images had been read.
    Offsets,
    /// Images of a laser stripe across a joint of this section, made hard like this, read as those of a real sensor.
    Stripes(Section, JointKind, StripeDisturbances),
}

/// How a leading sensor sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorModel {
    /// By how much it leads, mm.
    pub lead_mm: f64,
    /// From exposure to exposure, s.
    pub period_s: f64,
    /// From exposure to arrival, s.
    pub latency_s: f64,
    /// By how much arrivals, and exposures, come sooner or later, at most, as a part of the period.
    pub jitter: f64,
    /// Standard deviation, mm.
    pub noise_mm: f64,
    /// Part of all measurements that is anything within 3 mm, with full confidence.
    pub outliers: f64,
    /// Half of what it sees, mm.
    pub field_mm: f64,
    /// What goes wrong, and from which place of the torch on, mm.
    pub fault: Option<(f64, Fault)>,
    /// What it sees with.
    pub sees: Sees,
}

impl SensorModel {
    /// 100 exposures a second, 15 ms late, 0.02 mm of noise.
    #[must_use]
    pub const fn usual(lead_mm: f64) -> Self {
        let (period_s, latency_s, noise_mm) = (0.01, 0.015, 0.02);
        let (field_mm, sees) = (10.0, Sees::Offsets);
        Self { lead_mm, period_s, latency_s, jitter: 0.0, noise_mm, outliers: 0.0, field_mm, fault: None, sees }
    }

    /// How such a sensor is followed, with cycles of `cycle_s` and up to `speed_mm_s`: what it would be described with.
    pub(super) fn settings(&self, cycle_s: f64, speed_mm_s: f64) -> Settings {
        let late = 1.5 * self.period_s;
        Settings {
            cycle_s,
            period_s: self.period_s,
            age_s: [(self.latency_s - late).max(0.0), self.latency_s + late],
            field_mm: DVec2::splat(self.field_mm),
            noise_mm: self.noise_mm,
            ..Settings::usual(self.lead_mm, speed_mm_s)
        }
    }
}

/// A sensor at work.
#[derive(Debug)]
pub(super) struct Sensor {
    model: SensorModel,
    random: Pcg64Mcg,
    /// When it exposed first.
    begun_s: Option<f64>,
    next_s: f64,
    count: u64,
    under_way: VecDeque<(f64, Option<Measurement>)>,
    frozen: Option<DVec2>,
    reader: StripeReader,
}

/// Columns and rows of the images of stripes, and how large a pixel is, mm.
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
            // Few are under way at once.
            under_way: VecDeque::with_capacity(64),
            frozen: None,
            reader: StripeReader::new(),
        }
    }

    /// Exposes if it is time, with the torch at `s` and the slide at `slide`.
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

    /// The next measurement that has arrived at `t`; none inside if it saw nothing.
    pub(super) fn arrived(&mut self, t: f64) -> Option<Option<Measurement>> {
        let i = self.under_way.iter().position(|(due, _)| *due <= t + 1e-9)?;
        self.under_way.remove(i).map(|(_, m)| m)
    }

    fn seen(&mut self, world: &World<'_>, s: f64, slide: DVec2) -> Option<(DVec2, f64)> {
        let (seam, place) = world.crossing(s, self.model.lead_mm, s)?;
        if !world.has(place) {
            return None;
        }
        if world.displacement.is_tacked(world.along.place(place)) {
            // Mostly nothing, else the tack's own shape, and the reader does not trust it.
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

    /// What is read from an image of the joint's stripe at `offset`.
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
        let zero = section.truth(&Placement::default()).joint()?;
        Some((found.joint() - zero, found.confidence))
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
