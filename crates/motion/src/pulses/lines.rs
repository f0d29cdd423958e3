use super::{Error, Generator, Timing, Train};

/// What a line does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
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
    /// What changes.
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
    fall: Option<u64>,
    turn: Option<u64>,
    rise: Option<u64>,
}

impl Lines {
    /// Axes at rest, each with its times (of the same period) and its position in steps.
    ///
    /// # Errors
    /// Of which axis (by index), and those of [`Generator::new`].
    pub fn new(axes: &[(Timing, f64)]) -> Result<Self, (usize, Error)> {
        let line = |(i, &(timing, start)): (usize, &(Timing, f64))| {
            let generator = Generator::new(timing, start).map_err(|e| (i, e))?;
            Ok(Line { generator, train: Train::default(), fall: None, turn: None, rise: None })
        };
        let lines = axes.iter().enumerate().map(line).collect::<Result<_, _>>()?;
        Ok(Self { lines, period: axes.first().map_or(0, |(t, _)| t.period), begin: 0, end: 0 })
    }

    /// Begins the next period, which ends at these positions (steps). Take its events with [`Lines::event`] before the
    /// next one begins; those not taken are lost.
    ///
    /// # Errors
    /// Of which axis (by index), and those of [`Generator::period`].
    pub fn advance(&mut self, to: impl IntoIterator<Item = f64>) -> Result<(), (usize, Error)> {
        (self.begin, self.end) = (self.end, self.end + self.period);
        for (i, (line, to)) in self.lines.iter_mut().zip(to).enumerate() {
            line.train = line.generator.period(to).map_err(|e| (i, e))?;
            line.turn = line.train.turn;
            line.rise = line.train.next();
        }
        Ok(())
    }

    /// The next event of this period in the order of time; in one tick falling edges come first, then directions.
    #[inline]
    pub fn event(&mut self) -> Option<Event> {
        let (tick, edge, axis) = self.lines.iter().enumerate().filter_map(|(i, l)| l.next(self.begin, i)).min()?;
        if tick >= self.end {
            return None;
        }
        let line = &mut self.lines[axis];
        match edge {
            Edge::Fall => line.fall = None,
            Edge::Direction(_) => line.turn = None,
            Edge::Rise => {
                line.fall = Some(tick + line.generator.timing().width);
                line.rise = line.train.next();
            }
        }
        Some(Event { tick, axis, edge })
    }

    /// The last falling edges, after the last period.
    pub fn finish(&mut self) -> impl Iterator<Item = Event> + '_ {
        self.end = u64::MAX;
        std::iter::from_fn(|| self.event())
    }

    /// The generators of the axes, in their order.
    pub fn generators(&self) -> impl Iterator<Item = &Generator> {
        self.lines.iter().map(|l| &l.generator)
    }
}

impl Line {
    /// Its next change, if there is one.
    #[inline]
    fn next(&self, begin: u64, axis: usize) -> Option<(u64, Edge, usize)> {
        let fall = self.fall.map(|t| (t, Edge::Fall, axis));
        let turn = self.turn.map(|t| (begin + t, Edge::Direction(self.train.positive), axis));
        let rise = self.rise.map(|t| (begin + t, Edge::Rise, axis));
        [fall, turn, rise].into_iter().flatten().min()
    }
}
