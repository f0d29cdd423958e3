use super::carrier::Wanted;
use super::head_requests::{HeadRequests, Step, Why};
use super::limit_use::LimitUse;
use glam::DVec2;
use seamwright_tracking::actuator::{Alarm, HeadTracking, SlideLimits};
use seamwright_tracking::lead::{Estimate, Measurement, Moment, SeamFrame};

/// Distance needed to know a position on the seam before the torch arrives, beyond the sensor's lead, mm.
pub(super) const SIGHTING_MM: f64 = 6.0;

/// Offset of a torch, lateral and height, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct TorchOffset {
    /// From its planned position.
    pub(super) correction: DVec2,
    /// From its line in addition, by the weave, where the torch is.
    pub(super) swing: DVec2,
}

pub(super) struct LeadingHead {
    head: HeadTracking,
    limits: [LimitUse; 2],
}

impl LeadingHead {
    pub(super) fn new(head: HeadTracking) -> Self {
        Self { limits: head.limits().map(|l: SlideLimits| LimitUse::new(l, head.settings().cycle_s)), head }
    }

    /// Returns the distance before the seam from which the torch finds its start reliably, mm, and the maximum
    /// approach speed, mm/s.
    pub(super) fn sighting_mm(&self) -> (f64, f64) {
        let settings = self.head.settings();
        (settings.lead_mm + SIGHTING_MM, settings.speed_mm_s)
    }

    /// Noise of a single measurement, mm.
    pub(super) fn noise_mm(&self) -> f64 {
        self.head.settings().noise_mm
    }

    /// Returns the maximum used share of each limit.
    pub(super) fn used(&self) -> [f64; 4] {
        std::array::from_fn(|i| self.limits[0].used[i].max(self.limits[1].used[i]))
    }

    /// Takes in a measurement that has arrived.
    pub(super) fn take(&mut self, measured: &Measurement, t_s: f64) {
        self.head.take(measured, t_s);
    }

    /// Runs one cycle, `left` mm before the joint ends, with the torch at `offset`. The sensor swings with it.
    pub(super) fn cycle(
        &mut self,
        left: f64,
        step: &Step,
        frame: SeamFrame,
        offset: TorchOffset,
    ) -> (Wanted, HeadRequests, Estimate) {
        let TorchOffset { correction, swing } = offset;
        let Step { t, s, speed, lag, .. } = *step;
        let orders = self.head.cycle_lagging(Moment { t_s: t, s_mm: s, slide: correction }, speed, swing, lag);
        self.limits[0].add(orders.slide.x);
        self.limits[1].add(orders.slide.y);
        let wanted = (frame, orders.slide);
        // The seam is unknown before its start.
        if s <= 0.0 {
            return (wanted, HeadRequests::NOTHING, orders.estimate);
        }
        let mut alarm = orders.alarm;
        // Beyond the end there is no joint to see, and none is needed. A tack may hide the end, or the part may lie a
        // little back. The last frame is a period old, and others are in transit.
        let settings = self.head.settings();
        let last = settings.tack_mm + 6.0 * settings.period_s * settings.speed_mm_s;
        if (left < settings.lead_mm && alarm == Some(Alarm::Blind)) || (left < last && alarm == Some(Alarm::Coasting)) {
            alarm = orders.carried;
        }
        let alarm = alarm.map(|alarm| (alarm, orders.cause.map(Why::Sensor)));
        (wanted, HeadRequests { feed_override: orders.feed_override, alarm, ..HeadRequests::NOTHING }, orders.estimate)
    }
}
