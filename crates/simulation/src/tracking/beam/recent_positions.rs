use glam::DVec3;
use seamwright_machine::Joints;
use std::collections::VecDeque;

/// Number of recent cycles kept for exposures.
const RECENT: usize = 12;

/// True position of the gun after a cycle.
#[derive(Debug, Clone, Copy)]
pub(in crate::tracking) struct GunPosition {
    /// Time, s.
    pub(in crate::tracking) t: f64,
    /// Path length of the set-point, mm.
    pub(in crate::tracking) s: f64,
    pub(in crate::tracking) axes: Joints,
    pub(in crate::tracking) tip: DVec3,
}

/// True positions of the gun in recent cycles: exposures lie between them. Memory is allocated once.
pub(in crate::tracking) struct RecentPositions(VecDeque<GunPosition>);

impl RecentPositions {
    pub(in crate::tracking) fn new() -> Self {
        Self(VecDeque::with_capacity(RECENT))
    }

    pub(in crate::tracking) fn add(&mut self, position: GunPosition) {
        if self.0.len() == RECENT {
            self.0.pop_front();
        }
        self.0.push_back(position);
    }

    /// Interpolates the position at `t_s` between two cycles; `None` before the first.
    pub(in crate::tracking) fn at(&self, t_s: f64) -> Option<GunPosition> {
        let after = self.0.iter().position(|at| at.t >= t_s).unwrap_or(self.0.len().checked_sub(1)?);
        let (a, b) = (self.0.get(after.saturating_sub(1))?, self.0.get(after)?);
        let part = if b.t > a.t { ((t_s - a.t) / (b.t - a.t)).clamp(0.0, 1.0) } else { 0.0 };
        let axes: Joints = std::array::from_fn(|i| a.axes[i] + part * (b.axes[i] - a.axes[i]));
        Some(GunPosition { t: t_s, s: a.s + part * (b.s - a.s), axes, tip: a.tip.lerp(b.tip, part) })
    }
}
