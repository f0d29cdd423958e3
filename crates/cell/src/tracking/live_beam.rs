use super::beam::{BeamEye, LOOK_S};
use super::beam::{BeamHead, BeamTally, END_MM, Glance, Hidden, Noise, STEP_MM, Shown, UnderWay};
use super::carrier::Wanted;
use super::live_head::{Step, Told};
use super::tally::Watch;
use super::{Error, World};
use glam::{DVec2, DVec3};
use seamwright_machine::{BeamDeflection, Joints, Sensor};
use seamwright_tracking::actuator::{Alarm, SlideLimits};
use seamwright_tracking::beam::{Beam, DeviationRecord, Misfit, Recorder};
use seamwright_tracking::lead::{Moment, SeamFrame, Sight};
use serde::Serialize;
use std::collections::VecDeque;

/// What a beam did in a cycle, beside the torch's own correction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamSample {
    /// By how much it was deflected, lateral, mm.
    pub deflection_mm: f64,
    /// True while it was on the weld; else it looked at the work.
    pub welds: bool,
}

/// How a beam corrected a pass; mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BeamSummary {
    /// True if the pass was corrected by stored deviations, not by what the beam saw.
    pub replayed: bool,
    /// Greatest deflection.
    pub deflected_mm: f64,
    /// What the deflection reaches.
    pub range_mm: f64,
    /// The farthest that the axes carried the gun.
    pub carried_mm: f64,
    /// Part of the weld's time that the beam was away from it to look, %.
    pub away_percent: f64,
    /// Longest interruption, ms.
    pub longest_away_ms: f64,
    /// How the stored deviations fitted, if they were checked and did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<BeamFit>,
}

/// How stored deviations lie beside what was seen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BeamFit {
    /// Points that were compared.
    pub points: usize,
    /// Half of them lie to either side of this, mm.
    pub median_mm: f64,
    /// Nine of ten lie within this, mm.
    pub within_mm: f64,
}

/// Cycles that are remembered for exposures.
const RECENT: usize = 12;

/// Where the gun truly was after a cycle.
#[derive(Debug, Clone, Copy)]
struct At {
    t: f64,
    s: f64,
    axes: Joints,
    tip: DVec3,
}

/// A head that its own beam guides, or what an earlier pass has found.
pub(super) struct LiveBeam<'a> {
    head: BeamHead<'a>,
    noise: Noise,
    pictures: UnderWay,
    beam: BeamDeflection,
    cycle_s: f64,
    recorder: Recorder,
    recent: VecDeque<At>,
    sample: BeamSample,
    known: (f64, Sight),
    watch: Watch,
    tally: BeamTally,
    /// What stands against the weld while the beam looks at its start.
    stops: Option<Alarm>,
}

/// The simulated seam as the eye of a beam.
struct WorldEye<'a, 'b>(&'a World<'b>, &'a mut Noise);

impl BeamEye for WorldEye<'_, '_> {
    fn glance(&mut self, glance: &Glance<'_>) -> Result<Shown, Error> {
        Ok(self.1.shown(self.0 as &dyn Hidden, glance))
    }
}

impl<'a> LiveBeam<'a> {
    pub(super) fn new(
        head: BeamHead<'a>,
        (camera, beam): (&Sensor, BeamDeflection),
        (length_mm, cycle_s): (f64, f64),
        axes: SlideLimits,
        seed: u64,
    ) -> Self {
        Self {
            head,
            noise: Noise::new(camera.noise_mm, seed),
            pictures: UnderWay::new(camera.latency_s, seed),
            beam,
            cycle_s,
            recorder: Recorder::new(length_mm, STEP_MM, camera.noise_mm),
            recent: VecDeque::with_capacity(RECENT),
            sample: BeamSample { deflection_mm: 0.0, welds: false },
            known: (f64::INFINITY, Sight::Unseen),
            watch: Watch::new(axes, cycle_s),
            tally: BeamTally::default(),
            stops: None,
        }
    }

    /// How long the beam looks at the start of the pass before it welds, s.
    pub(super) fn look_s(&self) -> f64 {
        LOOK_S
    }

    /// Whether the weld may begin, after the look at its start; else what is wrong.
    pub(super) fn ready(&self) -> Result<(), (Alarm, Option<String>)> {
        match (&self.head, self.stops) {
            (BeamHead::Tracking(head), _) if !head.has_seen() => {
                Err((Alarm::Lost, Some("it was not seen before the weld".to_owned())))
            }
            (_, Some(alarm)) => Err((alarm, self.misfit())),
            _ => Ok(()),
        }
    }

    pub(super) fn known(&self) -> (f64, Sight) {
        self.known
    }

    pub(super) fn used(&self) -> [f64; 4] {
        self.watch.used
    }

    pub(super) fn sample(&self) -> BeamSample {
        self.sample
    }

    /// One cycle with the torch truly `off` its planned place: along, lateral, height.
    pub(super) fn cycle(&mut self, world: &World<'_>, step: &Step, frame: SeamFrame, off: DVec3) -> (Wanted, Told) {
        let Step { t, s, speed, welds } = *step;
        self.pictures.deliver(&mut self.head, t);
        let now = Moment { t_s: t, s_mm: s + off.x, slide: DVec2::new(off.y, off.z) };
        let orders = self.head.cycle(now, speed, welds);
        if let Beam::Seen(exposed_s) = orders.beam {
            self.look(world, exposed_s, speed);
        }
        let on = !matches!(orders.beam, Beam::Scan);
        self.sample = BeamSample { deflection_mm: orders.deflection_mm, welds: welds && on };
        self.known = (orders.estimate.sigma_mm, orders.estimate.sight);
        self.watch.add(orders.carried_mm);
        if welds {
            self.recorder.add(now.s_mm, &orders.estimate);
            self.tally.cycle(on, orders.deflection_mm, off.y);
        }
        let wanted = (frame, DVec2::new(orders.carried_mm, 0.0));
        if !welds {
            self.stops = orders.alarm.filter(|_| orders.pace <= 0.0);
            return (wanted, Told::NOTHING);
        }
        // At its very end nothing of the seam lies ahead any more.
        let ends = world.left(s) < END_MM || (orders.alarm == Some(Alarm::Blind) && world.left(s) < self.sees_mm());
        let alarm = orders.alarm.filter(|_| !ends).map(|alarm| (alarm, self.misfit()));
        (wanted, Told { pace: orders.pace, alarm })
    }

    /// How far ahead the joint is looked at, mm.
    fn sees_mm(&self) -> f64 {
        match &self.head {
            BeamHead::Tracking(head) => head.zone().to_mm,
            BeamHead::Replay(_) => 0.0,
        }
    }

    fn look(&mut self, world: &World<'_>, exposed_s: f64, speed: f64) {
        let Some(at) = self.at(exposed_s) else { return };
        let taught = (world.taught)(at.s);
        let torch = SeamFrame { point: at.tip, ..taught };
        let glance =
            Glance { t_s: exposed_s, axes: &at.axes, torch, s_mm: at.s, from: self.head.looks_for(at.s, speed) };
        let mut eye = WorldEye(world, &mut self.noise);
        // Points of a simulated seam can always be had.
        let taken = self.pictures.look(&mut eye, &glance);
        debug_assert!(taken.is_ok());
    }

    /// Where the gun was at `t_s`, between two cycles.
    fn at(&self, t_s: f64) -> Option<At> {
        let after = self.recent.iter().position(|at| at.t >= t_s).unwrap_or(self.recent.len().checked_sub(1)?);
        let (a, b) = (self.recent.get(after.saturating_sub(1))?, self.recent.get(after)?);
        let part = if b.t > a.t { ((t_s - a.t) / (b.t - a.t)).clamp(0.0, 1.0) } else { 0.0 };
        let axes: Joints = std::array::from_fn(|i| a.axes[i] + part * (b.axes[i] - a.axes[i]));
        Some(At { t: t_s, s: a.s + part * (b.s - a.s), axes, tip: a.tip.lerp(b.tip, part) })
    }

    /// Where the gun truly is after the drives' step to `s` in the cycle that began at `t`.
    pub(super) fn feel(&mut self, t: f64, s: f64, axes: &Joints, tip: DVec3) {
        if self.recent.len() == RECENT {
            self.recent.pop_front();
        }
        self.recent.push_back(At { t, s, axes: *axes, tip });
    }

    /// Where the beam meets the work, lateral from the tip, with the work's surface `above` it, mm: it is deflected about a
    /// point at some distance.
    pub(super) fn lands(&self, above: f64) -> f64 {
        self.sample.deflection_mm * (1.0 - above / self.beam.pivot_mm)
    }

    /// Why what is stored does not fit, if it does not.
    fn misfit(&self) -> Option<String> {
        let BeamHead::Replay(head) = &self.head else { return None };
        let misfit: Misfit = head.judged()?.err()?;
        // What comes before it is the alarm's own name.
        let text = misfit.to_string();
        Some(text.split_once(": ").map_or(text.clone(), |(_, rest)| rest.to_owned()))
    }

    /// What it did, and what it found of the seam by the pass's own path length; a replay finds nothing.
    pub(super) fn finish(self) -> (BeamSummary, Option<DeviationRecord>) {
        let (away, longest) = self.tally.away();
        let (fit, replayed) = match &self.head {
            BeamHead::Tracking(_) => (None, false),
            BeamHead::Replay(head) => (head.judged().and_then(Result::ok), true),
        };
        let summary = BeamSummary {
            replayed,
            deflected_mm: self.tally.used[0],
            range_mm: self.beam.range_mm,
            carried_mm: self.tally.used[1],
            away_percent: 100.0 * away,
            longest_away_ms: 1e3 * f64::from(longest) * self.cycle_s,
            fit: fit.map(|f| BeamFit { points: f.points, median_mm: f.median_mm, within_mm: f.within_mm }),
        };
        (summary, if replayed { None } else { self.recorder.finish() })
    }
}
