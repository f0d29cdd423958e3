//! Home position of an imported arm: away from singularities, without a collision.

use super::ImportedArm;
use crate::chain::Joints;
use crate::file::Load;
use crate::machine::Machine;
use crate::surroundings::Surroundings;
use seamwright_clearance::Clamped;
use seamwright_document::DocumentError;
use std::f64::consts::PI;

/// Positions that each axis between the first and the last is tried at, as parts of half a turn.
const PLACES: [f64; 7] = [0.0, 1.0 / 6.0, -1.0 / 6.0, 1.0 / 3.0, -1.0 / 3.0, 0.5, -0.5];
/// Distance from the singularities that suffices, 0 to 1.
const WIDE: f64 = 0.4;
/// Positions whose clearance is checked.
const CHECKED: usize = 20;

impl ImportedArm {
    /// Chooses a home position away from singularities, with the torch downwards if the arm allows it. Links whose
    /// shapes touch at all the best positions are then ignored. `load` reads the STL files by their names.
    ///
    /// # Errors
    /// An error in the machine file, as far too many axes or a shape of a wrong size.
    pub fn choose_home(&mut self, load: Load<'_>) -> Result<(), DocumentError> {
        let machine = Machine::read_with(&self.name, &self.to_toml(), load)?;
        let mut homes = candidates(&machine);
        homes.truncate(CHECKED);
        homes.push(machine.home());
        let Ok(around) = Surroundings::new(&machine, &Clamped::default()) else { return Ok(()) };
        let home = homes.iter().find(|q| around.is_clear(q)).or(homes.first()).copied().unwrap_or_default();
        self.axes.iter_mut().zip(home).for_each(|(axis, home)| axis.home = home);
        let touching = around.touching(&home);
        self.ignored = touching.into_iter().map(|(a, b)| [a, b].map(|link| self.link_name(&machine, link))).collect();
        Ok(())
    }

    fn link_name(&self, machine: &Machine, link: usize) -> String {
        let named = machine.links.named().iter().find(|frame| frame.link == link);
        named.map_or_else(String::new, |frame| frame.name.clone())
    }
}

/// Positions of an arm in multiples of 30 degrees, the best first; empty without known singularities.
fn candidates(machine: &Machine) -> Vec<Joints> {
    let home = machine.home();
    let last = machine.axes.len().saturating_sub(1);
    if machine.arm_margins(&home).is_none() {
        return Vec::new();
    }
    let mut all = vec![home];
    for axis in 1..last {
        let allowed = |q: &Joints| machine.axes[axis].outside(q[axis]).is_none();
        let moved = |q: &Joints, place: f64| {
            let mut q = *q;
            q[axis] = PI * place;
            q
        };
        all = all.iter().flat_map(|q| PLACES.map(|place| moved(q, place))).filter(allowed).collect();
    }
    let mut scored: Vec<(f64, Joints)> = all.into_iter().map(|q| (score(machine, &q), q)).collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0));
    scored.into_iter().map(|(_, q)| q).collect()
}

/// Rates a position: distance from singularities first, then a torch that points down, an arm above the work, and small
/// angles.
fn score(machine: &Machine, q: &Joints) -> f64 {
    let margin = machine.arm_margins(q).map_or(0.0, |margins| margins.min()).min(WIDE);
    let pose = machine.forward(q);
    let motion = machine.link_frames(q);
    let up = machine.up_in_work(q);
    let axes = (0..machine.axes.len()).filter_map(|axis| machine.links.screw_at(axis, &motion));
    let heights: Vec<f64> = axes.map(|screw| screw.at.dot(up)).chain([pose.point.dot(up)]).collect();
    let extent = heights.iter().map(|h| h.abs()).fold(1.0, f64::max);
    let height = heights.iter().sum::<f64>() / (extent * heights.len() as f64);
    let angles: f64 = q.iter().map(|v| v.abs()).sum();
    10.0 * margin - pose.direction.dot(up) + height - 0.05 * angles
}
