/// The pulses of one axis in one period: an iterator over the ticks of their rising edges, from the period's start.
///
/// Integers throughout: each pulse is an integer quotient rounded down, computed from the previous one by an addition
/// and a carry (Bresenham).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Train {
    /// Direction of its pulses: true counts up.
    pub positive: bool,
    /// Tick at which the direction line changes to it, if it does.
    pub turn: Option<u64>,
    left: u64,
    tick: u64,
    /// Fraction of a tick, of `whole`.
    part: u64,
    gap: u64,
    gap_part: u64,
    whole: u64,
}

/// Evenly spaced points of time in ticks: the first at `tick + part / whole`, the others `gap / whole` apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct EvenTicks {
    pub(super) tick: u64,
    pub(super) part: u64,
    pub(super) gap: u64,
    pub(super) whole: u64,
}

impl Train {
    /// The first `count` pulses `at` evenly spaced ticks, each rounded down. The direction line changes in tick `turn`,
    /// if it does.
    pub(super) fn new(positive: bool, turn: Option<u64>, count: u64, at: EvenTicks) -> Self {
        let EvenTicks { tick, part, gap, whole } = at;
        Self { positive, turn, left: count, tick, part, gap: gap / whole, gap_part: gap % whole, whole }
    }
}

impl Iterator for Train {
    type Item = u64;

    #[inline]
    fn next(&mut self) -> Option<u64> {
        self.left = self.left.checked_sub(1)?;
        let tick = self.tick;
        let part = self.part + self.gap_part;
        let carry = u64::from(part >= self.whole);
        self.tick += self.gap + carry;
        self.part = part - carry * self.whole;
        Some(tick)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left as usize, Some(self.left as usize))
    }
}

impl ExactSizeIterator for Train {}
