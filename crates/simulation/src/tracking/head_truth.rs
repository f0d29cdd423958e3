use super::head_result::{HeadSample, HeadSummary};
use super::weld_statistics::MissDistribution;
use super::world::World;
use crate::sample::Sample;
use glam::{DVec2, Vec3Swizzles as _};
use seamwright_executive::tracking::{BeamSample, HeadReport, swing_at};
use seamwright_executive::{SeamOrders, Tracked};
use seamwright_machine::{BeamDeflection, Machine};
use seamwright_program::TorchPath;
use seamwright_tracking::beam::Beam;

/// True positions of a head's weld and joint: for evaluation only, hidden from control.
pub(crate) struct HeadTruth<'a> {
    /// Counted from 0.
    pub(crate) number: usize,
    world: World<'a>,
    path: &'a dyn TorchPath,
    /// Deflection of a beam, which height does not affect.
    deflection: Option<BeamDeflection>,
    tracked: MissDistribution,
    untracked: MissDistribution,
    last_s: Option<f64>,
}

impl<'a> HeadTruth<'a> {
    pub(super) fn new(number: usize, path: &'a dyn TorchPath, world: World<'a>, machine: &Machine) -> Self {
        let (tracked, untracked) = (MissDistribution::default(), MissDistribution::default());
        Self { number, world, path, deflection: machine.deflection, tracked, untracked, last_s: None }
    }

    /// Measures weld and joint at a sample; `None` before the torch travels along the seam.
    pub(crate) fn measure(
        &mut self,
        machine: &Machine,
        sample: &Sample,
        tracked: Option<Tracked>,
        orders: &SeamOrders,
    ) -> Option<HeadSample> {
        let s = sample.set.profile.s;
        if !(s.is_finite() && self.world.has(s)) {
            return None;
        }
        let frame = (self.world.taught)(s);
        let tip = machine.forward_of(self.number, &sample.q).ahead(self.path.drawn_back()).point;
        let off = frame.components(tip - frame.point) - swing_at(self.path, s, &frame);
        let (joint, _) = self.world.crossing(s, off.x, s)?;
        let (planned, _) = self.world.crossing(s, 0.0, s)?;
        let mut correction = off.yz();
        let beam = self.deflection.filter(|_| tracked.is_some()).map(|beam| {
            // The beam is deflected about a pivot at a distance.
            correction.x += orders.deflection_mm * (1.0 - (joint.y - off.z) / beam.pivot_mm);
            let welds = sample.arc() && !matches!(orders.beam, Beam::Scan);
            BeamSample { deflection_mm: orders.deflection_mm, welds }
        });
        let counts = if self.deflection.is_some() { DVec2::X } else { DVec2::ONE };
        let miss = (correction - joint) * counts;
        // While the beam looks it does not weld.
        if sample.travels() && beam.is_none_or(|beam| beam.welds) {
            let way = s - self.last_s.unwrap_or(s);
            // Stretches welded again after a hold count once.
            if way > 0.0 {
                self.tracked.add(miss, way);
                self.untracked.add(-planned * counts, way);
            }
            self.last_s = Some(s.max(self.last_s.unwrap_or(s)));
        }
        Some(HeadSample { seam: joint, correction, miss, beam, tracked })
    }

    /// Returns the summary, with the report of the guide if there was one.
    pub(crate) fn finish(mut self, machine: &Machine, guide: Option<HeadReport>) -> HeadSummary {
        let [miss_p99_mm, miss_most_mm] = [0.99, 1.0].map(|part| self.tracked.quantile(part));
        let [untracked_p99_mm, untracked_most_mm] = [0.99, 1.0].map(|part| self.untracked.quantile(part));
        let found = guide.as_ref().and_then(|guide| guide.found.as_ref());
        HeadSummary {
            head: machine.heads[self.number].name.clone(),
            miss_p99_mm,
            miss_most_mm,
            untracked_p99_mm,
            untracked_most_mm,
            lateral_only: self.deflection.is_some(),
            tracked: guide.is_some(),
            used: guide.as_ref().map(|guide| guide.used),
            stopped_mm: guide.as_ref().and_then(|guide| guide.stopped_mm),
            deviations: found.map(|found| self.world.along.on_seam(found)),
            alarms: guide.as_ref().map_or_else(Vec::new, |guide| guide.alarms.clone()),
            beam: guide.and_then(|guide| guide.beam),
        }
    }
}
