use super::carrier::Wanted;
use super::live_head::{Step, Told};
use super::sensor::Sensor;
use super::tally::Watch;
use super::{SensorModel, World};
use glam::DVec2;
use seamwright_tracking::actuator::{Alarm, HeadTracking, SlideLimits};
use seamwright_tracking::lead::{Moment, SeamFrame, Sight};

/// A head that a leading sensor guides.
pub(super) struct Leading {
    sensor: Sensor,
    head: HeadTracking,
    watch: [Watch; 2],
    known: (f64, Sight),
}

impl Leading {
    pub(super) fn new(model: SensorModel, head: HeadTracking, seed: u64) -> Self {
        Self {
            sensor: Sensor::new(model, seed),
            watch: head.limits().map(|l: SlideLimits| Watch::new(l, head.settings().cycle_s)),
            head,
            known: (f64::INFINITY, Sight::Unseen),
        }
    }

    /// How far before the seam the torch must begin to be sure of its start, mm, and how fast it may come, mm/s.
    pub(super) fn sighting_mm(&self) -> (f64, f64) {
        let settings = self.head.settings();
        (settings.lead_mm + super::pass_scene::SIGHTING_MM, settings.speed_mm_s)
    }

    /// What is known of the joint at the torch: standard deviation, mm, and how.
    pub(super) fn known(&self) -> (f64, Sight) {
        self.known
    }

    /// The greatest part of each limit that was used.
    pub(super) fn used(&self) -> [f64; 4] {
        std::array::from_fn(|i| self.watch[0].used[i].max(self.watch[1].used[i]))
    }

    /// One cycle with the torch truly off its planned place by `correction`, and off its line by `swing` on top of that: lateral
    /// and height, mm. The sensor swings with it.
    pub(super) fn cycle(
        &mut self,
        world: &World<'_>,
        step: &Step,
        frame: SeamFrame,
        (correction, swing): (DVec2, DVec2),
    ) -> (Wanted, Told) {
        let Step { t, s, speed, .. } = *step;
        let slide = correction + swing;
        self.sensor.look(world, t, s, slide);
        while let Some(arrived) = self.sensor.arrived(t) {
            if let Some(measured) = arrived {
                self.head.take(&measured, t);
            }
        }
        let orders = self.head.cycle_woven(Moment { t_s: t, s_mm: s, slide }, speed, swing);
        self.watch[0].add(orders.slide.x);
        self.watch[1].add(orders.slide.y);
        self.known = (orders.estimate.sigma_mm, orders.estimate.sight);
        let wanted = (frame, orders.slide);
        // Before the seam nothing can be known of it.
        if s <= 0.0 {
            return (wanted, Told::NOTHING);
        }
        let mut alarm = orders.alarm;
        // Beyond the end there is no joint to be seen, and none is needed; the last frame on it is a period before.
        let left = world.left(s);
        let settings = self.head.settings();
        let last = 3.0 * settings.period_s * settings.speed_mm_s;
        if (left < settings.lead_mm && alarm == Some(Alarm::Blind)) || (left < last && alarm == Some(Alarm::Coasting)) {
            alarm = None;
        }
        let cause = orders.cause.map(|cause| cause.name().to_owned());
        (wanted, Told { pace: orders.pace, alarm: alarm.map(|alarm| (alarm, cause)) })
    }
}
