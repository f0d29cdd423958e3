use super::preview::softened;
use super::{Following, Slide, SlideLimits};
use crate::lead::{Error, Estimate, Measurement, Moment, OwnCurve, Refusal, Settings, Sight, Tracker, Verdict};
use glam::DVec2;

/// Part of a slide's speed and stroke that may be used before the torch is slowed and a warning given.
const RESERVE: f64 = 0.8;
/// As many periods without a measurement of use are worth a warning, if the torch goes on for longer than tacks
/// explain.
const BLIND_PERIODS: f64 = 10.0;
/// Slowest that the torch goes while a correction fades out or comes to its end, as a part of its speed.
const FADING_SPEED: f64 = 0.25;

/// What is wrong; from [`Alarm::Blind`] on each is worse than the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Alarm {
    /// The seam, here or ahead, needs more than 80 % of a slide's stroke, or of what the axes may carry the gun.
    NearStroke,
    /// The seam is beyond the reach of the beam's deflection: the axes that carry the gun do the rest.
    AxesCarry,
    /// The seam ahead leaves the taught path faster than a slide can go: slowed down.
    Slowed,
    /// Nothing of use has come from the sensor for some periods. The weld still lies on what was seen.
    Blind,
    /// The torch is beyond what was seen: the last slope is followed.
    Coasting,
    /// The torch has gone back farther than is remembered: the slide stays where it is.
    Unknown,
    /// The correction fades out to the taught path.
    FadingOut,
    /// A slide is at its end: the weld misses the joint.
    StrokeEnd,
    /// The correction has faded out: stop.
    Lost,
    /// A slide does not go where it is ordered: stop.
    SlideStuck,
    /// What is stored does not fit the part any more: stop.
    Misfit,
}

/// Why nothing of use comes from a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// Nothing comes at all.
    Silent,
    /// What comes does not agree with itself.
    Wild,
    /// What comes is refused.
    Refused(Refusal),
}

impl Cause {
    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Silent => "the sensor is silent",
            Self::Wild => "what it sends does not agree with itself",
            Self::Refused(Refusal::Confidence) => "its confidence is no number from 0 to 1",
            Self::Refused(Refusal::Faint) => "it sees the joint too faintly",
            Self::Refused(Refusal::OutOfField) => "the joint is outside of its field",
            Self::Refused(Refusal::Clock) => "its times are wrong",
            Self::Refused(Refusal::Late) => "what it sends comes too late",
            Self::Refused(Refusal::Frozen) => "it sends the same again and again",
        }
    }
}

impl Alarm {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::NearStroke,
        Self::AxesCarry,
        Self::Slowed,
        Self::Blind,
        Self::Coasting,
        Self::Unknown,
        Self::FadingOut,
        Self::StrokeEnd,
        Self::Lost,
        Self::SlideStuck,
        Self::Misfit,
    ];

    /// In words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NearStroke => "correction near its end",
            Self::AxesCarry => "beyond the beam's deflection: the axes carry the gun",
            Self::Slowed => "slowed down for a steep deviation",
            Self::Blind => "nothing seen by the sensor",
            Self::Coasting => "torch beyond what was seen",
            Self::Unknown => "torch back beyond what is remembered",
            Self::FadingOut => "correction fades out to the taught path",
            Self::StrokeEnd => "correction at its end: the weld misses the joint",
            Self::Lost => "joint lost",
            Self::SlideStuck => "slide does not go where it is ordered",
            Self::Misfit => "the stored deviation does not fit",
        }
    }
}

/// What is to be done in the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    /// Set-points of the slide, lateral and height, mm.
    pub slide: DVec2,
    /// Greatest part of its speed that the torch may have; 0: stop.
    pub pace: f64,
    /// The worst that is wrong.
    pub alarm: Option<Alarm>,
    /// The same of what has nothing to do with sight.
    pub carried: Option<Alarm>,
    /// What is wrong with the sensor, as soon as nothing of use has come from it for some periods.
    pub cause: Option<Cause>,
    /// What is known of the seam at the torch.
    pub estimate: Estimate,
}

/// Tracking of one head: its tracker and its cross slide.
#[derive(Debug, Clone)]
pub struct HeadTracking {
    tracker: Tracker,
    slides: [Slide; 2],
    ordered: DVec2,
    target: DVec2,
    /// When and where anything of use came last.
    taken: Option<(f64, f64)>,
    /// When and where on the seam the torch was first.
    begun: Option<(f64, f64)>,
    /// Where the torch is, mm.
    here_mm: f64,
    /// The last measurement that was of no use since, and when it came.
    unused: Option<(f64, Verdict)>,
    following: Following,
    stuck: bool,
}

impl HeadTracking {
    /// A head on the seam that `own` is of, its cross slide in the middle.
    ///
    /// # Errors
    /// Those of [`Settings::check`] and [`SlideLimits::check`]; a notice shorter than the slides' lag.
    pub fn new(settings: Settings, own: OwnCurve, limits: [SlideLimits; 2]) -> Result<Self, Error> {
        let [x, y] = limits.map(|limits| Slide::new(limits, settings.cycle_s));
        let slides = [x?, y?];
        if slides.iter().any(|slide| slide.lag_s() >= settings.notice_s) {
            let (key, value) = ("notice_s", settings.notice_s);
            return Err(Error::Value { key, value, allowed: "more than the slides' lag, at most 0.02" });
        }
        let tracker = Tracker::new(settings, own)?;
        let (ordered, target) = (DVec2::ZERO, DVec2::ZERO);
        Ok(Self {
            tracker,
            slides,
            ordered,
            target,
            taken: None,
            begun: None,
            here_mm: 0.0,
            unused: None,
            following: Following::default(),
            stuck: false,
        })
    }

    /// How its sensor is followed.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        self.tracker.settings()
    }

    /// What its corrections may do, lateral and height.
    #[must_use]
    pub fn limits(&self) -> [SlideLimits; 2] {
        [*self.slides[0].limits(), *self.slides[1].limits()]
    }

    /// A measurement has arrived at time `now_s`.
    pub fn take(&mut self, measured: &Measurement, now_s: f64) -> Verdict {
        let verdict = self.tracker.take(measured, now_s);
        match verdict {
            Verdict::Taken | Verdict::Restarted => (self.taken, self.unused) = (Some((now_s, self.here_mm)), None),
            Verdict::Gated | Verdict::Refused(_) => self.unused = Some((now_s, verdict)),
        }
        verdict
    }

    /// A cycle: where the torch and the slide truly are, and how fast the torch goes along the seam, mm/s.
    pub fn cycle(&mut self, now: Moment, speed: f64) -> Orders {
        self.cycle_woven(now, speed, DVec2::ZERO)
    }

    /// The same of a torch that weaves: of where the slide truly is `swing` (lateral and height, mm) is the weave's.
    pub fn cycle_woven(&mut self, now: Moment, speed: f64, swing: DVec2) -> Orders {
        let settings = *self.tracker.settings();
        let way = speed.abs() * settings.notice_s;
        self.here_mm = now.s_mm;
        if now.s_mm > 0.0 {
            self.begun.get_or_insert((now.t_s, now.s_mm));
        }
        self.tracker.advance(now, now.s_mm + way);
        self.stuck = self.following.is_stuck(now.t_s, (now.slide - swing).distance(self.ordered));
        let estimate = self.tracker.at(now.s_mm);
        // A stuck slide's set-points come to rest, within its limits.
        if !self.stuck {
            self.aim(&now, speed, &settings);
        }
        let orders = [self.slides[0].step(self.target.x), self.slides[1].step(self.target.y)];
        self.ordered = DVec2::from_array(orders);
        let (pace, alarm, carried) = self.judge(&now, speed, &estimate);
        Orders { slide: self.ordered, pace, alarm, carried, cause: self.cause(&now), estimate }
    }

    /// Why nothing of use has come for some periods, and for longer than tacks explain; none if something has.
    fn cause(&self, now: &Moment) -> Option<Cause> {
        let settings = self.tracker.settings();
        let long_ago = |since: f64| now.t_s - since > BLIND_PERIODS * settings.period_s;
        let blind = |(t, s): (f64, f64)| long_ago(t) && (now.s_mm - s).abs() > settings.coast_mm();
        // Nothing yet counts from where the seam begins.
        if !self.taken.or(self.begun).is_some_and(blind) {
            return None;
        }
        Some(match self.unused {
            Some((at, Verdict::Refused(refusal))) if !long_ago(at) => Cause::Refused(refusal),
            Some((at, _)) if !long_ago(at) => Cause::Wild,
            _ => Cause::Silent,
        })
    }

    /// Where the slides are sent: what they will have reached when the torch is there.
    fn aim(&mut self, now: &Moment, speed: f64, settings: &Settings) {
        let [x, y] = &self.slides;
        // Both have lags of their own, but nearly the same.
        let lag = x.lag_s().max(y.lag_s());
        let there = now.s_mm + speed * (lag + settings.cycle_s);
        // Where nothing is known, as after going back far, the slide stays.
        if self.tracker.at(there).sight != Sight::Unseen {
            let limit = |f: fn(&Slide) -> f64| DVec2::new(f(x), f(y));
            self.target = softened(
                |t| self.tracker.at(there + speed * t).value,
                settings.notice_s - lag,
                limit(|slide| slide.limits().speed),
                limit(Slide::acceleration),
            );
        }
    }

    /// Pace, the worst that is wrong, and of what has nothing to do with sight.
    fn judge(&self, now: &Moment, speed: f64, here: &Estimate) -> (f64, Option<Alarm>, Option<Alarm>) {
        let settings = self.tracker.settings();
        if self.stuck {
            return (0.0, Some(Alarm::SlideStuck), None);
        }
        let stroke = DVec2::new(self.slides[0].limits().stroke_mm, self.slides[1].limits().stroke_mm);
        let fastest = RESERVE * DVec2::new(self.slides[0].limits().speed, self.slides[1].limits().speed);
        let ahead = self.tracker.ahead(now.s_mm);
        let needed = (ahead.slope * settings.speed_mm_s.max(speed.abs()) / fastest).max_element();
        let mut pace = if needed > 1.0 { 1.0 / needed } else { 1.0 };
        let reach = (ahead.value / stroke).max_element();
        let blind = self.cause(now).is_some();
        let never = self.begun.filter(|_| self.taken.is_none());
        let lost = settings.coast_mm() + settings.fade_mm;
        let carried = if needed > 1.0 { Some(Alarm::Slowed) } else { (reach > RESERVE).then_some(Alarm::NearStroke) };
        let alarm = match here.sight {
            Sight::Lost => Alarm::Lost,
            _ if never.is_some_and(|(_, from)| now.s_mm - from > lost) => Alarm::Lost,
            _ if here.value.abs().cmpgt(stroke).any() => Alarm::StrokeEnd,
            Sight::Fading => Alarm::FadingOut,
            Sight::Unseen if self.taken.is_some() => Alarm::Unknown,
            Sight::Coasted => Alarm::Coasting,
            _ if blind => Alarm::Blind,
            _ => match carried {
                Some(alarm) => alarm,
                None => return (pace, None, None),
            },
        };
        // The nearer to its end, the slower: time for the operator.
        pace = pace.min(1.0 - (1.0 - FADING_SPEED) * ((reach - RESERVE) / (1.0 - RESERVE)).clamp(0.0, 1.0));
        match alarm {
            Alarm::Lost | Alarm::StrokeEnd => pace = 0.0,
            Alarm::FadingOut => pace = pace.min(FADING_SPEED),
            _ => {}
        }
        (pace, Some(alarm), carried)
    }
}
