/// Following error (mm) and its duration (s) from which an axis is stuck. The error is twice that of slides at full
/// acceleration through a jump.
const STUCK_MM: f64 = 0.1;
const STUCK_S: f64 = 0.02;

/// Monitors the following error of axes.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Following {
    off_since: Option<f64>,
    stuck: bool,
}

impl Following {
    /// Updates with following error `off_mm`; returns true once the axes are stuck, and from then on.
    pub(crate) fn is_stuck(&mut self, t_s: f64, off_mm: f64) -> bool {
        if off_mm <= STUCK_MM {
            self.off_since = None;
        } else {
            let since = *self.off_since.get_or_insert(t_s);
            self.stuck |= t_s - since >= STUCK_S;
        }
        self.stuck
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_errors_are_forgiven_and_long_ones_never() {
        let mut following = Following::default();
        // Off for 15 ms of every 30.
        for i in 0..990 {
            let t = 1e-3 * f64::from(i);
            assert!(!following.is_stuck(t, if i % 30 < 15 { 0.5 } else { 0.05 }), "{i}");
        }
        let stuck = (1000..1100).map(|i| following.is_stuck(1e-3 * f64::from(i), 0.11)).collect::<Vec<_>>();
        let first = stuck.iter().position(|s| *s).unwrap();
        assert!((19..=21).contains(&first), "{first}");
        assert!(following.is_stuck(2.0, 0.0));
    }
}
