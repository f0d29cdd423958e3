//! All thresholds between usual values of welding machines and likely mistakes or other units.

/// Faster than the fastest linear motors of machine tools (about 4 m/s): mm/min or a mistake.
pub(super) const FAST_MM_S: f64 = 5000.0;
/// Slower than any welding speed: m/s or a mistake.
pub(super) const SLOW_MM_S: f64 = 0.5;
/// Ten turns per second: a spindle, not a positioner; deg/min or a mistake.
pub(super) const FAST_DEG_S: f64 = 3600.0;
/// A turn takes over six minutes: rad/s or rpm in place of deg/s.
pub(super) const SLOW_DEG_S: f64 = 1.0;
/// Axes reach their speed in less than a minute.
pub(super) const LONG_RUN_UP_S: f64 = 60.0;
/// A millisecond is about one period of the position loop: not an acceleration that a control can follow.
pub(super) const SHORT_RUN_UP_S: f64 = 1e-3;
/// Ten times gravity: more than linear motors give.
pub(super) const HARD_MM_S2: f64 = 100_000.0;
/// An acceleration that takes longer to build up than this is a jerk in the wrong unit.
pub(super) const LONG_JERK_S: f64 = 2.0;
/// The longest gantries have some 60 m.
pub(super) const LONG_MM: f64 = 100_000.0;
/// Less than the play of a slide: m in place of mm.
pub(super) const SHORT_MM: f64 = 0.1;
/// Cables do not survive a hundred turns: continuous, or a mistake.
pub(super) const MANY_DEG: f64 = 36_000.0;
/// Less than an encoder's count: not an axis.
pub(super) const FEW_DEG: f64 = 0.01;
/// Two turns in rad: a narrower range in degrees may be meant in rad.
pub(super) const RADIANS_SPAN_DEG: f64 = 12.6;
/// Tolerance of rounded multiples of a quarter turn, rad.
pub(super) const RADIANS_ROUNDED: f64 = 0.006;
/// The slowest position loops in use; larger values are in s or Hz.
pub(super) const LONG_PERIOD_S: f64 = 10e-3;
/// Faster than any fieldbus: s in place of ms.
pub(super) const SHORT_PERIOD_S: f64 = 20e-6;
/// A screw or rack that is off by more is broken, or its table is in micrometres.
pub(super) const PITCH_ERROR_MM: f64 = 1.0;
/// The same of a rotary axis: half a degree is 4 mm on a radius of 500 mm.
pub(super) const PITCH_ERROR_DEG: f64 = 0.5;
/// Ratio of a drive's peak to its load's need above which a mass may be in t or a force in mN.
pub(super) const STRONG: f64 = 300.0;
/// An encoder this coarse is insufficient for welding, mm or deg.
pub(super) const COARSE: f64 = 0.1;
/// Longer displacements do not occur on machines: mm in place of m, or a mistake.
pub(super) const FAR_MM: f64 = 100_000.0;
