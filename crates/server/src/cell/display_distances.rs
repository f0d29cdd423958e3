//! Smallest distances for display, computed beside the cycle, which has its own collision monitor.

use super::hub::Hub;
use crate::view::near;
use crate::wire::NearView;
use seamwright_executive::Foreseen;
use seamwright_machine::{Clamped, Joints, MAX_AXES, Machine, Surroundings};
use seamwright_motion::jog::JogError;
use self_cell::self_cell;
use std::collections::BTreeSet;
use std::sync::{Arc, Weak};
use std::time::Duration;

/// Period of the distance computation.
const LOOK: Duration = Duration::from_millis(50);
/// Maximum distance that is reported, mm.
const WITHIN_MM: f64 = 60.0;
/// Below this margin over the minimum clearance all pairs are considered, mm.
const URGENT_MM: f64 = 10.0;

self_cell! {
    struct Stood {
        owner: (Machine, Clamped),
        #[not_covariant]
        dependent: Surroundings,
    }
}

/// Machine, part and fixtures.
pub(crate) struct Around {
    all: Stood,
    /// Each link alone with part, fixtures and zones: links of the machine are always close to each other.
    links: Vec<Stood>,
}

impl Around {
    /// # Errors
    /// In words, if a solid is invalid for distance computation.
    pub(crate) fn new(machine: &Machine, clamped: &Clamped) -> Result<Self, String> {
        let stand = |machine: Machine| {
            let owner = (machine, clamped.clone());
            let stood = Stood::try_new(owner, |(machine, clamped)| Surroundings::new(machine, clamped));
            stood.map_err(|e| e.to_string())
        };
        let alone = |link: usize| {
            let mut machine = machine.clone();
            machine.solids.solids.retain(|(on, _)| *on == link);
            stand(machine)
        };
        let links: BTreeSet<usize> = machine.solids.solids.iter().map(|(link, _)| *link).collect();
        Ok(Self { all: stand(machine.clone())?, links: links.into_iter().map(alone).collect::<Result<_, _>>()? })
    }

    /// Computes a motion by hand in advance; see [`seamwright_executive::foresee`].
    ///
    /// # Errors
    /// See [`seamwright_executive::foresee`].
    pub(crate) fn foresee(&self, start: &Joints, target: &Joints, samples: usize) -> Result<Foreseen, JogError> {
        self.all.with_dependent(|(machine, _), around| {
            seamwright_executive::foresee(machine, Some(around), start, target, samples)
        })
    }

    /// Returns the pair with the smallest margin with the axes at `q`, mm or rad. Pairs of links are considered only
    /// below [`URGENT_MM`].
    pub(crate) fn near(&self, q: &Joints) -> Option<NearView> {
        let of = |stood: &Stood| stood.with_dependent(|_, around| near(around, q, WITHIN_MM));
        let room = |near: &NearView| near.distance_mm - near.least_mm;
        of(&self.all).filter(|near| room(near) < URGENT_MM).or_else(|| {
            let all = self.links.iter().filter_map(of);
            all.min_by(|a, b| room(a).total_cmp(&room(b)))
        })
    }
}

/// Updates the smallest distance for as long as the hub exists.
pub(super) fn watch(hub: &Weak<Hub>) {
    let mut last: Option<([u64; MAX_AXES], Arc<Around>)> = None;
    while let Some(hub) = hub.upgrade() {
        if let Some((around, q)) = hub.around().zip(hub.set_points()) {
            // Skips the computation for the same position in the same surroundings.
            let at = q.map(f64::to_bits);
            if !last.as_ref().is_some_and(|(was, of)| *was == at && Arc::ptr_eq(of, &around)) {
                hub.set_near(around.near(&q));
                last = Some((at, around));
            }
        }
        drop(hub);
        std::thread::sleep(LOOK);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_clearance::{Shape, Solid};
    use seamwright_machine::shipped;

    /// The distance to a ball below the torch tip decreases by as much as the machine goes down; the ball is named.
    #[test]
    fn a_ball_under_the_torch_comes_nearer_as_it_goes_down() {
        let machine = Machine::read("m.toml", shipped("saddle-4axis").unwrap().text).unwrap();
        let mut q = machine.home();
        let down = machine.axes.iter().position(|axis| axis.name == "h").unwrap();
        let tip = machine.forward(&q).point;
        let ball = Solid::new(
            "ball",
            Shape::Sphere { radius: 10.0 },
            glam::DAffine3::from_translation(tip - 120.0 * glam::DVec3::Z),
        );
        let clamped = Clamped { fixtures: vec![ball.unwrap()], least_mm: 1.0, ..Clamped::default() };
        let around = Around::new(&machine, &clamped).unwrap();
        assert_eq!(around.near(&q), None);
        let mut distances = Vec::new();
        for _ in 0..7 {
            q[down] -= 15.0;
            let near = around.near(&q);
            distances.extend(
                near.filter(|near| near.between.iter().any(|name| name.contains("ball"))).map(|n| n.distance_mm),
            );
        }
        assert!(distances.len() >= 2, "{distances:?}");
        assert!(distances.windows(2).all(|pair| (pair[0] - pair[1] - 15.0).abs() < 0.1), "{distances:?}");
    }
}
