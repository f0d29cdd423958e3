use super::beam_authority::{BeamAuthority, SOON_S, Shares};
use super::error::Error;
use super::picture::{Course, PLACES, Picture, Place, Taken, located, on_one_line};
use super::schedule::{Beam, Schedule};
use super::settings::Settings;
use super::zone::Zone;
use crate::actuator::{Alarm, Following, SlideLimits};
use crate::lead::{Estimate, Moment, OwnCurve, Refusal, Sight, Tracker};
use arrayvec::ArrayVec;
use glam::DVec2;
use seamwright_machine::BeamDeflection;

/// Feed override while a correction fades out, as a fraction.
const FADING_SPEED: f64 = 0.25;
/// Number of periods without a usable picture before a warning.
const BLIND_PERIODS: f64 = 2.5;

/// Distance from the known seam, mm, above which a picture shows another line or a moved part.
const ELSEWHERE_MM: f64 = 0.3;

/// Commands for the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    /// Action of the beam.
    pub beam: Beam,
    /// Lateral deflection of the beam while it welds, mm.
    pub deflection_mm: f64,
    /// Lateral set-point of the axes that carry the gun, mm in the torch frame.
    pub carried_mm: f64,
    /// Maximum feed override as a fraction; 0: stop.
    pub feed_override: f64,
    /// Most severe alarm.
    pub alarm: Option<Alarm>,
    /// Estimate of the seam at the torch.
    pub estimate: Estimate,
}

/// Tracks the seam with the welding beam.
#[derive(Clone)]
pub struct BeamTracking<'a> {
    settings: Settings,
    seam: Course<'a>,
    schedule: Schedule,
    tracker: Tracker,
    authority: BeamAuthority,
    following: Following,
    zone: Zone,
    carried: f64,
    taken_s: Option<f64>,
    /// First and last point of the previous picture.
    before: [DVec2; 2],
    /// Offset of the seam in the previous picture if it was elsewhere, mm.
    elsewhere: Option<f64>,
}

impl<'a> BeamTracking<'a> {
    /// Creates tracking on the nominal `seam`, corrected by the deflection and by the `axes` that carry the gun.
    ///
    /// # Errors
    /// Those of [`Settings::check`]; invalid limits.
    pub fn new(
        settings: Settings,
        seam: Course<'a>,
        deflection: BeamDeflection,
        axes: SlideLimits,
    ) -> Result<Self, Error> {
        let (schedule, lead) = settings.check()?;
        Ok(Self {
            tracker: Tracker::new(lead, OwnCurve::straight(lead.lead_mm))?,
            authority: BeamAuthority::new(deflection, axes, settings.cycle_s)?,
            following: Following::default(),
            zone: settings.zone(settings.speed_mm_s[1])?,
            carried: 0.0,
            taken_s: None,
            before: [DVec2::NAN; 2],
            elsewhere: None,
            settings,
            seam,
            schedule,
        })
    }

    /// Returns the current detection zone.
    #[must_use]
    pub fn zone(&self) -> Zone {
        self.zone
    }

    /// Returns whether any picture has been used.
    #[must_use]
    pub fn has_seen(&self) -> bool {
        self.taken_s.is_some()
    }

    /// Returns the expected lateral deviation at `s_mm`, mm; `None` where the seam is unknown.
    #[must_use]
    pub fn expected(&self, s_mm: f64) -> Option<f64> {
        let known = self.tracker.at(s_mm);
        (known.sight != Sight::Unseen).then_some(known.value.x)
    }

    /// Processes the midline of a frame that arrived at time `now_s`.
    pub fn take(&mut self, picture: &Picture<'_>, now_s: f64) -> Taken {
        let then = match self.moment(picture, now_s) {
            Ok(then) => then,
            Err(refusal) => return Taken { refused: Some(refusal), ..Taken::default() },
        };
        let mut taken = Taken::default();
        let Zone { from_mm, to_mm } = self.zone;
        let mut places: ArrayVec<Place, PLACES> = ArrayVec::new();
        for point in picture.points {
            let within =
                (from_mm..=to_mm).contains(&point.along_mm) && point.lateral_mm.abs() <= self.settings.reach_mm.y;
            let sure = (self.settings.least_confidence..=1.0).contains(&point.confidence);
            if !within || !sure || places.is_full() {
                taken.left_out += 1;
                continue;
            }
            let (s, deviation) = located(self.seam, &then, point, picture.height_mm);
            places.push((s, deviation, point.confidence));
        }
        let Some(lie) = on_one_line(&places, self.settings.noise_mm) else {
            taken.gated = places.len() as u32;
            return taken;
        };
        taken.used = lie.iter().filter(|lies| **lies).count() as u32;
        taken.gated = places.len() as u32 - taken.used;
        let mut on_line = lie.iter();
        places.retain(|_| on_line.next().is_some_and(|lies| *lies));
        if !self.is_believed(&places) {
            return Taken { used: 0, gated: taken.gated + taken.used, ..taken };
        }
        for (s, deviation, confidence) in places {
            self.tracker.see(s, deviation, confidence, picture.exposed_s);
        }
        self.taken_s = Some(now_s);
        taken
    }

    /// Accepts a picture with the seam elsewhere than known only if the previous one showed it there too. Then the part
    /// has moved, and the estimate from there on is discarded.
    fn is_believed(&mut self, places: &[Place]) -> bool {
        let off = |(s, deviation, _): &Place| {
            let known = self.tracker.at(*s);
            (known.sight <= Sight::Bridged).then_some(deviation.x - known.value.x)
        };
        let mut off: ArrayVec<f64, PLACES> = places.iter().filter_map(off).collect();
        off.sort_unstable_by(f64::total_cmp);
        let median = off.get(off.len() / 2).copied().unwrap_or(0.0);
        let before = self.elsewhere.take();
        if median.abs() <= ELSEWHERE_MM {
            return true;
        }
        let again = before.is_some_and(|before| (before - median).abs() <= ELSEWHERE_MM);
        if again {
            self.tracker.forget_from(places.iter().map(|place| place.0).fold(f64::INFINITY, f64::min));
        } else {
            self.elsewhere = Some(median);
        }
        again
    }

    /// Returns the torch position at a picture's exposure, or the reason for rejecting the picture.
    fn moment(&mut self, picture: &Picture<'_>, now_s: f64) -> Result<Moment, Refusal> {
        let [young, old] = self.settings.age_s;
        let slack = 0.5 * self.settings.cycle_s;
        let age = now_s - picture.exposed_s;
        if age > old + slack {
            return Err(Refusal::Late);
        }
        if age.is_nan() || age < young - slack {
            return Err(Refusal::Clock);
        }
        if picture.height_mm.is_nan() || picture.height_mm.abs() > self.settings.reach_mm.y {
            return Err(Refusal::OutOfField);
        }
        let (Some(first), Some(last)) = (picture.points.first(), picture.points.last()) else {
            return Err(Refusal::Faint);
        };
        let ends = [first, last].map(|p| DVec2::new(p.along_mm, p.lateral_mm));
        let same = ends == self.before;
        self.before = ends;
        if same {
            return Err(Refusal::Frozen);
        }
        self.tracker.moment(picture.exposed_s).ok_or(Refusal::Clock)
    }

    /// Runs one cycle with the torch's position on the nominal seam and the actual carry of the gun by the axes.
    /// `speed` is the torch's, mm/s. Before it `welds` the work is cold, and the joint is detected from its start on.
    pub fn cycle(&mut self, now: Moment, speed: f64, welds: bool) -> Orders {
        let notice = self.authority.lag_s() + self.settings.cycle_s;
        let there = now.s_mm + speed * notice;
        self.tracker.advance(now, now.s_mm + speed.abs() * self.tracker.settings().notice_s);
        if let Ok(zone) = self.settings.zone(speed.abs()) {
            self.zone = if welds { zone } else { Zone { from_mm: -zone.from_mm, ..zone } };
        }
        let estimate = self.tracker.at(now.s_mm);
        // At an unknown seam the gun stays.
        let to = [there, there + speed * SOON_S].map(|s| self.expected(s).unwrap_or(f64::NAN));
        let stuck = self.following.is_stuck(now.t_s, (now.slide.x - self.carried).abs());
        let shares = self.authority.step(to, now.slide.x, now.t_s);
        self.carried = shares.carried;
        let blind = self.taken_s.is_some_and(|t| now.t_s - t > BLIND_PERIODS * self.settings.period_s);
        let unknown = welds && estimate.sight == Sight::Unseen;
        let (feed_override, alarm) = judge(&shares, &estimate, Faults { stuck, unknown, blind });
        Orders {
            beam: self.schedule.at(now.t_s, true),
            deflection_mm: shares.deflection,
            carried_mm: shares.carried,
            feed_override,
            alarm,
            estimate,
        }
    }
}

/// Faults in a cycle beside those of the estimate and of the shares.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Faults {
    /// The axes do not follow.
    pub(super) stuck: bool,
    /// The beam welds where the seam has not been seen.
    pub(super) unknown: bool,
    /// The last usable picture is too old.
    pub(super) blind: bool,
}

/// Returns the feed override and the most severe alarm.
pub(super) fn judge(shares: &Shares, here: &Estimate, faults: Faults) -> (f64, Option<Alarm>) {
    let Faults { stuck, unknown, blind } = faults;
    let alarm = match here.sight {
        _ if stuck => Alarm::SlideStuck,
        Sight::Lost => Alarm::Lost,
        _ if shares.short => Alarm::StrokeEnd,
        Sight::Fading => return (FADING_SPEED, Some(Alarm::FadingOut)),
        _ if unknown => Alarm::Unknown,
        Sight::Coasted => Alarm::Coasting,
        _ if blind => Alarm::Blind,
        _ if shares.carries => {
            if shares.near_stroke {
                Alarm::NearStroke
            } else {
                Alarm::AxesCarry
            }
        }
        _ => return (1.0, None),
    };
    let stops = matches!(alarm, Alarm::SlideStuck | Alarm::Lost | Alarm::StrokeEnd);
    (if stops { 0.0 } else { 1.0 }, Some(alarm))
}
