use super::Error;
use super::generator::Generator;
use super::timing::Timing;
use super::train::Train;

/// Edge of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// The step line goes low.
    Fall,
    /// The direction line changes: true counts up.
    Direction(bool),
    /// The step line goes high: a pulse.
    Rise,
}

/// A change of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Event {
    /// Ticks from the start of the first period.
    pub tick: u64,
    /// Index of the axis.
    pub axis: usize,
    /// The edge.
    pub edge: Edge,
}

/// Step and direction lines of several axes on one timer. Allocates when built, not afterwards.
#[derive(Debug, Clone)]
pub struct Lines {
    lines: Vec<Line>,
    period: u64,
    begin: u64,
    end: u64,
}

#[derive(Debug, Clone)]
struct Line {
    generator: Generator,
    train: Train,
    /// Tick from the start of the first period of its next fall, turn and rise.
    fall: u64,
    turn: u64,
    rise: u64,
    /// The earliest of them, as [`key`].
    next: u64,
}

/// Tick of an event that never occurs.
const NEVER: u64 = u64::MAX >> 2;

/// A tick and, below it, the order of edges in a tick.
const fn key(tick: u64, order: u64) -> u64 {
    tick << 2 | order
}

impl Lines {
    /// Axes at rest, each with its times (of the same period) and its position in steps.
    ///
    /// # Errors
    /// The axis (by index), and the error of [`Generator::new`].
    pub fn new(axes: &[(Timing, f64)]) -> Result<Self, (usize, Error)> {
        let line = |(i, &(timing, start)): (usize, &(Timing, f64))| {
            let generator = Generator::new(timing, start).map_err(|e| (i, e))?;
            let (fall, turn, rise, next) = (NEVER, NEVER, NEVER, key(NEVER, 0));
            Ok(Line { generator, train: Train::default(), fall, turn, rise, next })
        };
        let lines = axes.iter().enumerate().map(line).collect::<Result<_, _>>()?;
        Ok(Self { lines, period: axes.first().map_or(0, |(t, _)| t.period), begin: 0, end: 0 })
    }

    /// Begins the next period, which ends at these positions (steps). Take its events with [`Lines::event`] before the
    /// next one begins; those not taken are lost.
    ///
    /// # Errors
    /// The axis (by index), and the error of [`Generator::period`].
    pub fn advance(&mut self, to: impl IntoIterator<Item = f64>) -> Result<(), (usize, Error)> {
        (self.begin, self.end) = (self.end, self.end + self.period);
        for (i, (line, to)) in self.lines.iter_mut().zip(to).enumerate() {
            line.train = line.generator.period(to).map_err(|e| (i, e))?;
            line.begin_period(self.begin);
        }
        Ok(())
    }

    /// Begins the next period as [`Lines::advance`], but an axis that cannot reach its position in time rests for this
    /// period.
    pub fn advance_or_stay(&mut self, to: impl IntoIterator<Item = f64>) {
        (self.begin, self.end) = (self.end, self.end + self.period);
        for (line, to) in self.lines.iter_mut().zip(to) {
            line.train = line.generator.period(to).unwrap_or_else(|_| {
                line.generator.stay();
                Train::default()
            });
            line.begin_period(self.begin);
        }
    }

    /// The next event of this period in the order of time; in one tick falling edges come first, then directions.
    #[inline]
    pub fn event(&mut self) -> Option<Event> {
        let (axis, next) = self.lines.iter().map(|l| l.next).enumerate().min_by_key(|(_, next)| *next)?;
        let tick = next >> 2;
        if tick >= self.end {
            return None;
        }
        let line = &mut self.lines[axis];
        let edge = if next == key(line.fall, 0) {
            line.fall = NEVER;
            Edge::Fall
        } else if next == key(line.turn, 1) {
            line.turn = NEVER;
            Edge::Direction(line.train.positive)
        } else {
            line.fall = tick + line.generator.timing().width;
            line.next_rise(self.begin);
            Edge::Rise
        };
        line.find_next();
        Some(Event { tick, axis, edge })
    }

    /// The next of the last falling edges, after the last period; none at the end.
    pub fn last_event(&mut self) -> Option<Event> {
        self.end = NEVER;
        self.event()
    }

    /// Ticks from the start of the first period to the end of this one.
    pub fn end(&self) -> u64 {
        self.end
    }

    /// The generators of the axes, in their order.
    pub fn generators(&self) -> impl Iterator<Item = &Generator> {
        self.lines.iter().map(|l| &l.generator)
    }
}

impl Line {
    fn begin_period(&mut self, begin: u64) {
        self.turn = self.train.turn.map_or(NEVER, |tick| begin + tick);
        self.next_rise(begin);
        self.find_next();
    }

    #[inline]
    fn next_rise(&mut self, begin: u64) {
        self.rise = self.train.next().map_or(NEVER, |tick| begin + tick);
    }

    #[inline]
    fn find_next(&mut self) {
        self.next = key(self.fall, 0).min(key(self.turn, 1)).min(key(self.rise, 2));
    }
}
