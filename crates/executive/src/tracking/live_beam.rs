use super::beam_head::{BeamHead, END_MM, LOOK_S, STEP_MM};
use super::beam_use::BeamUse;
use super::carrier::Wanted;
use super::head_requests::{HeadRequests, Step, Why};
use super::limit_use::LimitUse;
use super::pass_sensors::BeamCamera;
use super::seam::Seam;
use glam::{DVec2, DVec3};
use seamwright_machine::BeamDeflection;
use seamwright_tracking::actuator::{Alarm, SlideLimits};
use seamwright_tracking::beam::{Beam, DeviationRecord, Picture, Recorder};
use seamwright_tracking::lead::{Estimate, Moment, SeamFrame};
use serde::Serialize;

/// State of a beam in a cycle, in addition to the torch's own correction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamSample {
    /// Lateral deflection, mm.
    pub deflection_mm: f64,
    /// True while the beam was on the weld; otherwise it looked at the work.
    pub welds: bool,
}

/// Corrections of a pass by a beam; mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BeamSummary {
    /// True if stored deviations corrected the pass, not the view of the beam.
    pub replayed: bool,
    /// Maximum deflection.
    pub deflected_mm: f64,
    /// Range of the deflection.
    pub range_mm: f64,
    /// Maximum distance by which the axes carried the gun.
    pub carried_mm: f64,
    /// Share of the weld's time that the beam was away from it to look, %.
    pub away_percent: f64,
    /// Longest interruption, ms.
    pub longest_away_ms: f64,
    /// Fit of the stored deviations, if they were checked and fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fit: Option<BeamFit>,
}

/// Differences between stored deviations and the joint seen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BeamFit {
    /// Number of points compared.
    pub points: usize,
    /// Median of the differences, mm.
    pub median_mm: f64,
    /// Nine of ten differences lie within this, mm.
    pub within_mm: f64,
}

/// A head guided by its own beam, or by the record of an earlier pass.
pub(super) struct LiveBeam<'a> {
    head: BeamHead<'a>,
    beam: BeamDeflection,
    noise_mm: f64,
    cycle_s: f64,
    recorder: Recorder,
    limits: LimitUse,
    beam_use: BeamUse,
    /// Alarm that prevents the weld while the beam looks at its start.
    stops: Option<Alarm>,
}

impl<'a> LiveBeam<'a> {
    pub(super) fn new(
        head: BeamHead<'a>,
        camera: &BeamCamera<'_>,
        seam: &Seam,
        cycle_s: f64,
        axes: SlideLimits,
    ) -> Self {
        let BeamCamera { camera: sensor, beam, .. } = *camera;
        Self {
            head,
            beam,
            noise_mm: sensor.noise_mm,
            cycle_s,
            recorder: Recorder::new(seam.length_mm, STEP_MM, sensor.noise_mm),
            limits: LimitUse::new(axes, cycle_s),
            beam_use: BeamUse::default(),
            stops: None,
        }
    }

    /// Returns the time for which the beam looks at the start of the pass before it welds, s.
    pub(super) fn look_s(&self) -> f64 {
        LOOK_S
    }

    /// Noise of a single point, mm.
    pub(super) fn noise_mm(&self) -> f64 {
        self.noise_mm
    }

    /// Checks whether the weld may start, after the look at its start; otherwise returns alarm and cause.
    pub(super) fn ready(&self) -> Result<(), (Alarm, Option<Why>)> {
        match (&self.head, self.stops) {
            (BeamHead::Tracking(head), _) if !head.has_seen() => Err((Alarm::Lost, Some(Why::NotSeen))),
            (_, Some(alarm)) => Err((alarm, self.misfit())),
            _ => Ok(()),
        }
    }

    pub(super) fn used(&self) -> [f64; 4] {
        self.limits.used
    }

    /// Takes in a picture that has arrived.
    pub(super) fn take(&mut self, picture: &Picture<'_>, t_s: f64) {
        self.head.take(picture, t_s);
    }

    /// Runs one cycle, `left` mm before the joint ends, with the torch `off` its planned position: along, lateral,
    /// height.
    pub(super) fn cycle(
        &mut self,
        left: f64,
        step: &Step,
        frame: SeamFrame,
        off: DVec3,
    ) -> (Wanted, HeadRequests, Estimate) {
        let Step { t, speed, welds, lag, .. } = *step;
        let now = Moment { t_s: t, s_mm: lag.torch_mm + off.x, slide: DVec2::new(off.y, off.z) };
        let orders = self.head.cycle(now, speed, welds);
        let on = !matches!(orders.beam, Beam::Scan);
        self.limits.add(orders.carried_mm);
        if welds {
            self.recorder.add(now.s_mm, &orders.estimate);
            self.beam_use.cycle(on, orders.deflection_mm, off.y);
        }
        let wanted = (frame, DVec2::new(orders.carried_mm, 0.0));
        let requests = HeadRequests { beam: orders.beam, deflection_mm: orders.deflection_mm, ..HeadRequests::NOTHING };
        if !welds {
            self.stops = orders.alarm.filter(|_| orders.feed_override <= 0.0);
            return (wanted, requests, orders.estimate);
        }
        // At the very end no part of the seam lies ahead.
        let ends = left < END_MM || (orders.alarm == Some(Alarm::Blind) && left < self.sees_mm());
        let alarm = orders.alarm.filter(|_| !ends).map(|alarm| (alarm, self.misfit()));
        (wanted, HeadRequests { feed_override: orders.feed_override, alarm, ..requests }, orders.estimate)
    }

    /// Returns the distance up to which the beam looks ahead, mm.
    fn sees_mm(&self) -> f64 {
        match &self.head {
            BeamHead::Tracking(head) => head.zone().to_mm,
            BeamHead::Replay(_) => 0.0,
        }
    }

    /// Returns the reason if the stored deviations do not fit.
    fn misfit(&self) -> Option<Why> {
        let BeamHead::Replay(head) = &self.head else { return None };
        head.judged()?.err().map(Why::Misfit)
    }

    /// Returns the deviations of the seam found so far, by the pass's own path length; `None` for a replay.
    pub(super) fn found(&self) -> Option<DeviationRecord> {
        match &self.head {
            BeamHead::Tracking(_) => self.recorder.clone().finish(),
            BeamHead::Replay(_) => None,
        }
    }

    pub(super) fn summary(&self) -> BeamSummary {
        let (away, longest) = self.beam_use.away();
        let (fit, replayed) = match &self.head {
            BeamHead::Tracking(_) => (None, false),
            BeamHead::Replay(head) => (head.judged().and_then(Result::ok), true),
        };
        BeamSummary {
            replayed,
            deflected_mm: self.beam_use.used[0],
            range_mm: self.beam.range_mm,
            carried_mm: self.beam_use.used[1],
            away_percent: 100.0 * away,
            longest_away_ms: 1e3 * f64::from(longest) * self.cycle_s,
            fit: fit.map(|f| BeamFit { points: f.points, median_mm: f.median_mm, within_mm: f.within_mm }),
        }
    }
}
