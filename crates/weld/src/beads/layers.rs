use super::file::Asked;
use crate::joint::Section;
use seamwright_program::Role;

/// A layer of beads, from the root out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Role of its beads.
    pub role: Role,
    /// Number of beads side by side.
    pub beads: usize,
    /// Its part of the whole area, before layers that are left out.
    pub share: f64,
}

/// Settings of the three kinds of runs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Runs {
    pub(crate) root: Option<Asked>,
    pub(crate) fill: Asked,
    pub(crate) cap: Asked,
}

impl Runs {
    /// Area of the smallest bead that fills a layer, mm^2.
    fn smallest(&self) -> f64 {
        self.fill.area.min(self.cap.area)
    }

    pub(crate) fn of(&self, role: Role) -> &Asked {
        match role {
            Role::Root => self.root.as_ref().unwrap_or(&self.fill),
            Role::Fill | Role::Tack => &self.fill,
            Role::Cap | Role::Cosmetic => &self.cap,
        }
    }
}

/// Maximum number of beads in a layer.
const MAX_IN_LAYER: f64 = 400.0;

/// Maximum number of beads in a section; more are a mistake: a V of 60 degrees in 300 mm takes 2,600 beads of 20 mm^2.
pub(crate) const MAX_BEADS: usize = 5_000;

/// The layers that fill a section best. Every bead has its run's area times one factor for all, as near to 1 as whole
/// numbers of beads allow.
///
/// A single bead is used if it is large enough. Otherwise a root pass of its own, if there is one, then layers of beads
/// side by side. Their number gives a height near to the wanted one. The cap layer has the area above the line from toe
/// to toe. Errors: the number of beads it would take, if that is more than [`MAX_BEADS`].
pub(crate) fn layers(section: &Section, runs: &Runs) -> Result<Vec<Layer>, f64> {
    let (_, high) = section.slices.heights();
    let total = section.total();
    // Before the first layer is made: each of them takes memory, and there may be more than there is.
    let beads = total / runs.smallest();
    if beads > MAX_BEADS as f64 {
        return Err(beads);
    }
    let (first, alone) = match &runs.root {
        Some(root) => (Role::Root, root.area),
        None => (Role::Cap, runs.cap.area),
    };
    if total <= 1.25 * alone {
        return Ok(vec![Layer { role: first, beads: 1, share: 1.0 }]);
    }
    let root = runs.root.as_ref().map_or(0.0, |root| root.area);
    let top = (total - section.slices.area_below(high - runs.cap.layer)).min(total - root);
    let wanted = whole(top / runs.cap.area);
    // At least the area above the line from toe to toe, or the layer below would have to fill it.
    let least = (1.3 * section.cap / runs.cap.area).ceil() as usize;
    let counts = [wanted, wanted + 1, wanted.saturating_sub(1).max(1)].map(|count| count.max(least));
    let all = counts.map(|cap| stack(section, runs, cap));
    let off = |stack: &[Layer]| (total / stack.iter().map(|l| l.share).sum::<f64>()).ln().abs();
    let best = all.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default();
    let sum: f64 = best.iter().map(|l| l.share).sum();
    Ok(best.into_iter().map(|l| Layer { share: l.share / sum, ..l }).collect())
}

/// The layers under and with a cap layer of `cap` beads; their shares are areas, mm^2.
fn stack(section: &Section, runs: &Runs, cap: usize) -> Vec<Layer> {
    let mut stack: Vec<Layer> = Vec::new();
    let mut add = |role: Role, beads: usize| {
        let share = beads as f64 * runs.of(role).area;
        stack.push(Layer { role, beads, share });
        share
    };
    let mut filled = if runs.root.is_some() { add(Role::Root, 1) } else { 0.0 };
    let until = section.total() - cap as f64 * runs.cap.area;
    let area = runs.fill.area;
    while until - filled > 0.5 * area {
        let low = section.slices.height_of(filled);
        let slice = section.slices.area_below(low + runs.fill.layer) - filled.min(section.area());
        filled += add(Role::Fill, whole(slice / area).min(whole((until - filled) / area)));
    }
    add(Role::Cap, cap);
    stack
}

/// The number of beads nearest to `wanted`, at least one.
fn whole(wanted: f64) -> usize {
    wanted.round().clamp(1.0, MAX_IN_LAYER) as usize
}
