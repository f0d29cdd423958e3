//! A range of values along one axis.

/// Magnitude from which values, like non-finite ones, count as missing.
const HUGE: f64 = 1e100;

/// Fraction of its magnitude below which a range counts as one constant value.
const NARROW: f64 = 1e-6;

/// Returns whether `value` can be drawn.
pub(crate) fn usable(value: f64) -> bool {
    value.abs() < HUGE
}

/// A closed range `lo <= hi` of usable values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Domain {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

impl Domain {
    /// Returns the extent of the usable `values`; `None` without any.
    pub(crate) fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        values
            .into_iter()
            .filter(|v| usable(*v))
            .fold(None, |found, v| Some(found.map_or(Self { lo: v, hi: v }, |d: Self| d.including(v))))
    }

    pub(crate) fn including(self, value: f64) -> Self {
        Self { lo: self.lo.min(value), hi: self.hi.max(value) }
    }

    pub(crate) fn union(self, other: Self) -> Self {
        self.including(other.lo).including(other.hi)
    }

    pub(crate) fn span(self) -> f64 {
        self.hi - self.lo
    }

    pub(crate) fn centre(self) -> f64 {
        0.5 * (self.lo + self.hi)
    }

    pub(crate) fn contains(self, value: f64) -> bool {
        (self.lo..=self.hi).contains(&value)
    }

    /// Returns a range wide enough to divide by: a constant `c` becomes `c ± |c|/2`, zero becomes ±1.
    pub(crate) fn settled(self) -> Self {
        let magnitude = self.lo.abs().max(self.hi.abs());
        if self.span() > (NARROW * magnitude).max(1e-200) {
            self
        } else if magnitude > 1e-150 {
            self.widened_to(magnitude)
        } else {
            Self { lo: -1.0, hi: 1.0 }
        }
    }

    /// Returns a range with the same centre, at least `span` wide.
    pub(crate) fn widened_to(self, span: f64) -> Self {
        let half = 0.5 * span.max(self.span());
        Self { lo: self.centre() - half, hi: self.centre() + half }
    }

    /// Returns a range wider by `part` of the span at each end.
    pub(crate) fn padded(self, part: f64) -> Self {
        self.widened_to(self.span() * (1.0 + 2.0 * part))
    }

    /// Maps `value` from this range onto `from..to`.
    pub(crate) fn map(self, value: f64, from: f64, to: f64) -> f64 {
        from + (value - self.lo) / self.span() * (to - from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extent_skips_what_cannot_be_drawn() {
        let d = Domain::of([f64::NAN, 3.0, f64::INFINITY, -1.0, 1e300]);
        assert_eq!(d, Some(Domain { lo: -1.0, hi: 3.0 }));
        assert_eq!(Domain::of([f64::NAN]), None);
    }

    #[test]
    fn settled_ranges_have_width() {
        for v in [0.0, 1.0, -8.0, 1e-12, 1e99, 1e-300, 5e-324] {
            let d = Domain { lo: v, hi: v }.settled();
            assert!(d.lo < d.hi && d.contains(v), "{v:e}: {d:?}");
            assert!(d.map(v, 0.0, 1.0).is_finite());
        }
        let noise = Domain { lo: 8.0, hi: 8.0 + 1e-9 }.settled();
        assert!(noise.span() > 1.0, "rounding noise is not blown up");
    }
}
