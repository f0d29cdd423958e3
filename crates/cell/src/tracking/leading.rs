use super::carrier::Wanted;
use super::live_head::{Step, Told, Why};
use super::tally::Watch;
use glam::DVec2;
use seamwright_tracking::actuator::{Alarm, HeadTracking, SlideLimits};
use seamwright_tracking::lead::{Estimate, Measurement, Moment, SeamFrame};

/// A head that a leading sensor guides.
pub(super) struct Leading {
    head: HeadTracking,
    watch: [Watch; 2],
}

impl Leading {
    pub(super) fn new(head: HeadTracking) -> Self {
        Self { watch: head.limits().map(|l: SlideLimits| Watch::new(l, head.settings().cycle_s)), head }
    }

    /// How far before the seam the torch must begin to be sure of its start, mm, and how fast it may come, mm/s.
    pub(super) fn sighting_mm(&self) -> (f64, f64) {
        let settings = self.head.settings();
        (settings.lead_mm + super::pass_scene::SIGHTING_MM, settings.speed_mm_s)
    }

    /// Of a single measurement, mm.
    pub(super) fn noise_mm(&self) -> f64 {
        self.head.settings().noise_mm
    }

    /// The greatest part of each limit that was used.
    pub(super) fn used(&self) -> [f64; 4] {
        std::array::from_fn(|i| self.watch[0].used[i].max(self.watch[1].used[i]))
    }

    /// What has arrived.
    pub(super) fn take(&mut self, measured: &Measurement, t_s: f64) {
        self.head.take(measured, t_s);
    }

    /// One cycle, `left` mm before the joint ends, with the torch off its planned place by `correction`, and off its line by
    /// `swing` on top of that: lateral and height, mm. The sensor swings with it.
    pub(super) fn cycle(
        &mut self,
        left: f64,
        step: &Step,
        frame: SeamFrame,
        (correction, swing): (DVec2, DVec2),
    ) -> (Wanted, Told, Estimate) {
        let Step { t, s, speed, .. } = *step;
        let orders = self.head.cycle_woven(Moment { t_s: t, s_mm: s, slide: correction + swing }, speed, swing);
        self.watch[0].add(orders.slide.x);
        self.watch[1].add(orders.slide.y);
        let wanted = (frame, orders.slide);
        // Before the seam nothing can be known of it.
        if s <= 0.0 {
            return (wanted, Told::NOTHING, orders.estimate);
        }
        let mut alarm = orders.alarm;
        // Beyond the end there is no joint to be seen, and none is needed. A tack may hide the end, or the part lie a little
        // back; the last frame is a period before, and some more on its way.
        let settings = self.head.settings();
        let last = settings.tack_mm + 6.0 * settings.period_s * settings.speed_mm_s;
        if (left < settings.lead_mm && alarm == Some(Alarm::Blind)) || (left < last && alarm == Some(Alarm::Coasting)) {
            alarm = orders.carried;
        }
        let alarm = alarm.map(|alarm| (alarm, orders.cause.map(Why::Sensor)));
        (wanted, Told { pace: orders.pace, alarm, ..Told::NOTHING }, orders.estimate)
    }
}
