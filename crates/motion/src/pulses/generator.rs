use super::Error;
use super::timing::{Timing, check_period};
use super::train::{EvenTicks, Train};

/// Fraction bits of a position in steps. Positions are even multiples of the smallest fraction and pulse positions odd
/// ones, so the two never coincide.
const BITS: u32 = 25;
const STEP: i64 = 1 << BITS;
/// Maximum position, steps.
const FARTHEST: f64 = 1e11;

/// Generates the pulses of one axis, period by period, without allocation. See the [module](super) for its guarantees.
/// The direction line is assumed to be set at the start of the first pulse's period.
///
/// ```
/// use seamwright_motion::pulses::{Generator, Timing};
/// // A period of 1000 ticks; pulses at least 20 apart, 5 wide; direction 10 before and 10 after.
/// let timing = Timing { period: 1000, width: 5, spacing: 20, setup: 10, hold: 10 };
/// let mut axis = Generator::new(timing, 0.0)?;
/// assert_eq!(axis.period(4.0)?.collect::<Vec<_>>(), [124, 374, 624, 874]);
/// assert_eq!(axis.period(4.25)?.len(), 0);
/// assert_eq!(axis.count(), 4);
/// # Ok::<(), seamwright_motion::pulses::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Generator {
    timing: Timing,
    start: i64,
    /// Position at the end of the last period, of `STEP` a step, even.
    at: i64,
    /// Direction line: true if positive; none before the first pulse.
    positive: Option<bool>,
    /// Rising edge of the last pulse, ticks from the start of the next period.
    last: i64,
    /// Maximum travel of a period so far, of `STEP` a step.
    fastest: u64,
    pulses: u64,
}

impl Generator {
    /// An axis at rest at `start` steps.
    ///
    /// # Errors
    /// [`Error::Position`], [`Error::Period`].
    pub fn new(timing: Timing, start: f64) -> Result<Self, Error> {
        check_period(timing.period)?;
        let at = fixed(start)?;
        Ok(Self { timing, start: count(at), at, positive: None, last: i64::MIN / 2, fastest: 0, pulses: 0 })
    }

    /// The pulses of the next period, at whose end the axis is at `to` steps.
    ///
    /// # Errors
    /// [`Error::TooFast`], [`Error::Crowded`], [`Error::Position`].
    pub fn period(&mut self, to: f64) -> Result<Train, Error> {
        let Timing { period, spacing, .. } = self.timing;
        let to = fixed(to)?;
        let way = self.at.abs_diff(to);
        if u128::from(way) * u128::from(spacing) > u128::from(period) << BITS {
            let steps = |fixed: f64| fixed / STEP as f64;
            let most = period as f64 / spacing as f64;
            return Err(Error::TooFast { asked: steps(way as f64), most });
        }
        let pulses = count(self.at).abs_diff(count(to));
        let train = if pulses == 0 { Train::default() } else { self.train(to, way, pulses)? };
        self.at = to;
        self.fastest = self.fastest.max(way);
        self.pulses += pulses;
        self.last = self.last.saturating_sub_unsigned(period);
        Ok(train)
    }

    /// A period without pulses.
    pub fn stay(&mut self) {
        self.last = self.last.saturating_sub_unsigned(self.timing.period);
    }

    /// Computes a period with `pulses` pulses on its `way` to `to`.
    fn train(&mut self, to: i64, way: u64, pulses: u64) -> Result<Train, Error> {
        let Timing { period, width, spacing, setup, hold } = self.timing;
        let positive = to > self.at;
        let after = |ticks: u64| self.last.saturating_add_unsigned(ticks).max(0) as u64;
        let turn = (self.positive != Some(positive)).then(|| after(width + hold));
        let earliest = after(spacing).max(turn.map_or(0, |turn| turn + setup));
        // Distances from the start to the first pulse position and from the last one to the end: below a step, so their
        // products with a period fit.
        let step = STEP.unsigned_abs();
        let first = if positive { place(count(self.at)) - self.at } else { self.at - place(count(self.at) - 1) };
        let rest = if positive { to - place(count(to) - 1) } else { place(count(to)) - to };
        let first = first.unsigned_abs() * period;
        let mut last = period - (rest.unsigned_abs() * period).div_ceil(way);
        let ticks = if first / way >= earliest {
            EvenTicks { tick: first / way, part: first % way, gap: step * period, whole: way }
        } else {
            // The first pulse must wait: the pulses are spread from then on, up to the last one's position if possible.
            let gaps = pulses - 1;
            last = last.max(earliest.saturating_add(gaps * spacing));
            if last >= period {
                return Err(Error::Crowded { pulses });
            }
            EvenTicks { tick: earliest, part: 0, gap: last - earliest, whole: gaps.max(1) }
        };
        self.last = last.cast_signed();
        self.positive = Some(positive);
        Ok(Train::new(positive, turn, pulses, ticks))
    }

    /// Position after the pulses so far, steps.
    pub fn count(&self) -> i64 {
        count(self.at)
    }

    /// Position at the end of the last period, steps with fractions.
    pub fn position(&self) -> f64 {
        self.at as f64 / STEP as f64
    }

    /// The count at the start, steps.
    pub fn start(&self) -> i64 {
        self.start
    }

    /// Pulses made so far, in both directions.
    pub fn pulses(&self) -> u64 {
        self.pulses
    }

    /// Maximum travel of a period so far, steps with fractions.
    pub fn fastest(&self) -> f64 {
        self.fastest as f64 / STEP as f64
    }

    /// Direction line: true if positive; none before the first pulse.
    pub fn positive(&self) -> Option<bool> {
        self.positive
    }

    /// The driver's times.
    pub fn timing(&self) -> &Timing {
        &self.timing
    }
}

/// A position in steps as a whole number, even.
fn fixed(steps: f64) -> Result<i64, Error> {
    if steps.abs() <= FARTHEST {
        Ok(2 * (steps * (STEP / 2) as f64).round() as i64)
    } else {
        Err(Error::Position { steps })
    }
}

/// Whole steps of a position: rounded, halves up.
fn count(at: i64) -> i64 {
    (at + STEP / 2) >> BITS
}

/// Position at which the count changes from `count` to the next: odd.
fn place(count: i64) -> i64 {
    count * STEP + STEP / 2 - 1
}
