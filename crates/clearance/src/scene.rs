//! Groups of solids and the conditions between them.

use crate::distance::{Posed, is_usable, of_shapes, of_swept};
use crate::error::ClearanceError;
use crate::mesh::Last;
use crate::permitted_zone::room;
use crate::shape::Solid;
use glam::{DAffine3, DVec3};

/// Solids that move rigidly together: a link of the machine, the torch, the part, the fixtures.
#[derive(Debug, Clone)]
pub struct Group {
    /// Name for reports.
    pub name: String,
    /// Its solids, in the group's frame.
    pub solids: Vec<Solid>,
}

/// Condition between two groups.
#[derive(Debug, Clone)]
#[allow(missing_docs, reason = "groups are indices")]
pub enum Watch {
    /// Two groups keep clear of each other by a distance above 0, since overlapping bodies have distance 0. A forbidden
    /// zone is the group `b` with the zone's solids.
    Apart { a: usize, b: usize, least_mm: f64 },
    /// A group stays inside permitted zones, all of it inside at least one of them, by a margin to the zone's surface.
    /// Zones are boxes, cylinders, spheres and half-spaces in the frame of the group `of`.
    Inside { group: usize, of: usize, zones: Vec<Solid>, least_mm: f64 },
}

impl Watch {
    /// The watched group and the reference group, by index.
    pub fn groups(&self) -> (usize, usize) {
        match *self {
            Self::Apart { a, b, .. } => (a, b),
            Self::Inside { group, of, .. } => (group, of),
        }
    }

    /// Minimum distance or margin, mm.
    pub fn least_mm(&self) -> f64 {
        match *self {
            Self::Apart { least_mm, .. } | Self::Inside { least_mm, .. } => least_mm,
        }
    }
}

/// A distance or margin in one configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// Lower bound of the distance of two groups or the margin in a zone, mm. The margin is negative outside a zone:
    /// for a box the minimum over its faces.
    pub distance: f64,
    /// The nearest points; none if the distance is only a bound at the limit, or the frames are not finite. With such
    /// frames the distance is 0, and the margin minus infinity.
    pub place: Option<Place>,
}

/// Nearest points of two groups.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Index of the solid of the first group, and of the solid of the second or of the permitted zone.
    pub solids: [usize; 2],
    /// Point of the first solid, in the common frame.
    pub on_a: DVec3,
    /// Point of the second solid, or of the zone's surface.
    pub on_b: DVec3,
}

/// Groups of solids, and the watches between them.
///
/// Evaluate it in one configuration with [`Scene::evaluate`] or [`Scene::nearest`], along a motion with
/// [`Scene::along`]. Frames map the frame of each group to a common one, in the order of [`Scene::groups`].
///
/// # Examples
///
/// Torch and clamp keep 5 mm clear of each other:
///
/// ```
/// use glam::{DAffine3, DVec3};
/// use seamwright_clearance::{Group, Scene, Shape, Solid, Watch};
///
/// let solid = |name: &str, shape| Solid::new(name, shape, DAffine3::IDENTITY);
/// let nozzle = solid("gas cup", Shape::Cylinder { radius: 10.0, length: 80.0 })?;
/// let clamp = solid("clamp", Shape::Box { size: DVec3::splat(40.0) })?;
/// let groups = vec![
///     Group { name: "torch".to_owned(), solids: vec![nozzle] },
///     Group { name: "fixtures".to_owned(), solids: vec![clamp] },
/// ];
/// let scene = Scene::new(groups, vec![Watch::Apart { a: 0, b: 1, least_mm: 5.0 }])?;
/// // The faces are 10 mm apart.
/// let frames = [DAffine3::IDENTITY, DAffine3::from_translation(DVec3::new(40.0, 0.0, 40.0))];
/// let found = scene.evaluate(0, &frames, 100.0);
/// assert!((found.distance - 10.0).abs() < 1e-3);
/// assert!(found.distance >= scene.watches()[0].least_mm());
/// # Ok::<(), seamwright_clearance::ClearanceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Scene {
    groups: Vec<Group>,
    watches: Vec<Watch>,
}

/// Warm start of a watch: the nearest pair of the last evaluation, checked first. One for each watch; it allocates
/// once.
#[derive(Debug, Default)]
pub struct Memory {
    nearest: usize,
    last: Vec<Last>,
    gaps: Vec<f64>,
}

impl Scene {
    /// Makes a scene. A watch whose first group has a half-space is swapped, so that the first group is always bounded.
    ///
    /// # Errors
    /// Missing groups, watches between unbounded groups, minimum distances that are not above 0, missing or invalid
    /// zones.
    pub fn new(groups: Vec<Group>, mut watches: Vec<Watch>) -> Result<Self, ClearanceError> {
        let ends = |group: usize| groups[group].solids.iter().all(Solid::ends);
        for (watch, w) in watches.iter_mut().enumerate() {
            let (a, b) = w.groups();
            if let Some(&group) = [a, b].iter().find(|g| **g >= groups.len()) {
                return Err(ClearanceError::NoSuchGroup { watch, group });
            }
            let least = w.least_mm();
            match w {
                _ if !least.is_finite() => return Err(ClearanceError::Minimum { watch }),
                Watch::Apart { .. } if least <= 0.0 => return Err(ClearanceError::Minimum { watch }),
                Watch::Apart { a, b, .. } if !ends(*a) => std::mem::swap(a, b),
                Watch::Inside { zones, .. } if zones.is_empty() => return Err(ClearanceError::NoZone { watch }),
                Watch::Inside { zones, .. } if !zones.iter().all(Solid::is_zone) => {
                    return Err(ClearanceError::ZoneShape { watch });
                }
                _ => {}
            }
            if !ends(w.groups().0) {
                return Err(ClearanceError::Endless { watch, group: groups[w.groups().0].name.clone() });
            }
        }
        Ok(Self { groups, watches })
    }

    /// The groups.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The watches, swapped where a first group had a half-space.
    pub fn watches(&self) -> &[Watch] {
        &self.watches
    }

    /// Evaluates one watch in one configuration: `frames` maps each group's frame to a common one. Distances of `limit`
    /// (mm) or more are only reported as at least that.
    ///
    /// # Panics
    /// If there is no such watch, or no frame for one of its groups.
    pub fn evaluate(&self, watch: usize, frames: &[DAffine3], limit: f64) -> Evaluation {
        self.evaluate_near(watch, frames, limit, &mut Memory::default())
    }

    /// Returns the index and evaluation of the watch with the minimum distance or margin; `None` without watches.
    ///
    /// # Panics
    /// If there is no frame for a watched group.
    pub fn nearest(&self, frames: &[DAffine3], limit: f64) -> Option<(usize, Evaluation)> {
        let mut least: Option<(usize, Evaluation)> = None;
        for watch in 0..self.watches.len() {
            let found = self.evaluate(watch, frames, least.map_or(limit, |l| l.1.distance.max(0.0)));
            if least.is_none_or(|l| found.distance < l.1.distance) {
                least = Some((watch, found));
            }
        }
        least
    }

    /// As [`Scene::evaluate`], but faster after small motions since the last use of `memory` for this watch. After one
    /// use of `memory` with an infinite limit it does not allocate, except on meshes.
    ///
    /// # Panics
    /// As [`Scene::evaluate`].
    pub fn evaluate_near(&self, watch: usize, frames: &[DAffine3], limit: f64, memory: &mut Memory) -> Evaluation {
        match &self.watches[watch] {
            Watch::Apart { a, b, .. } => self.apart(*a, *b, frames, limit, memory),
            Watch::Inside { group, of, zones, .. } => self.inside(*group, *of, zones, frames),
        }
    }

    /// Distance of two groups, in the frame of the first.
    fn apart(&self, a: usize, b: usize, frames: &[DAffine3], limit: f64, memory: &mut Memory) -> Evaluation {
        let (solids_a, solids_b) = (&self.groups[a].solids, &self.groups[b].solids);
        let to_a = frames[a].inverse() * frames[b];
        if !is_usable(&to_a) {
            return Evaluation { distance: 0.0, place: None };
        }
        memory.gaps.clear();
        for solid in solids_b {
            let centre = to_a.transform_point3(solid.centre);
            memory.gaps.extend(solids_a.iter().map(|s| s.centre.distance(centre) - s.reach - solid.reach));
        }
        let far = memory.gaps.iter().copied().fold(f64::INFINITY, f64::min);
        if far >= limit {
            return Evaluation { distance: far, place: None };
        }
        memory.last.resize(memory.gaps.len(), Last::MAX);
        let mut best = Evaluation { distance: limit, place: None };
        let first = memory.nearest.min(memory.gaps.len() - 1);
        let others = (0..memory.gaps.len()).filter(|i| *i != first);
        for i in std::iter::once(first).chain(others) {
            if memory.gaps[i] >= best.distance {
                continue;
            }
            let pair = [i % solids_a.len(), i / solids_a.len()];
            let (s, t) = (&solids_a[pair[0]], &solids_b[pair[1]]);
            let (s, t) = (Posed::new(s, *s.pose()), Posed::new(t, to_a * *t.pose()));
            if let Some(gap) = of_shapes(s, t, best.distance, &mut memory.last[i]) {
                memory.nearest = i;
                let place = Place { solids: pair, on_a: gap.on_a, on_b: gap.on_b };
                best = Evaluation { distance: gap.distance, place: Some(place) };
            }
        }
        moved(best, &frames[a])
    }

    /// Lower bound of the distance of two groups while every point of the first moves straight from its place in the pose
    /// `from` to that in `to`, both in the frame of the second; at most `limit`, mm. None for permitted zones and for
    /// frames that are not finite.
    pub(crate) fn swept(
        &self,
        watch: usize,
        from: &DAffine3,
        to: &DAffine3,
        limit: f64,
        memory: &mut Memory,
    ) -> Option<f64> {
        let Watch::Apart { a, b, .. } = self.watches[watch] else { return None };
        if !is_usable(from) || !is_usable(to) {
            return None;
        }
        let (solids_a, solids_b) = (&self.groups[a].solids, &self.groups[b].solids);
        memory.last.resize(solids_a.len() * solids_b.len(), Last::MAX);
        let mut least = limit;
        for (i, s) in solids_a.iter().enumerate() {
            let (start, end) = (from.transform_point3(s.centre), to.transform_point3(s.centre));
            let (middle, reach) = ((start + end) / 2.0, start.distance(end) / 2.0 + s.reach);
            let ends = [*from * *s.pose(), *to * *s.pose()];
            for (k, t) in solids_b.iter().enumerate() {
                if middle.distance(t.centre) - reach - t.reach >= least {
                    continue;
                }
                let last = &mut memory.last[k * solids_a.len() + i];
                if let Some(bound) = of_swept(Posed::new(s, ends[0]), ends[1], Posed::new(t, *t.pose()), least, last) {
                    least = bound;
                }
            }
        }
        Some(least)
    }

    /// Margin of a group in the zone with the largest margin.
    fn inside(&self, group: usize, of: usize, zones: &[Solid], frames: &[DAffine3]) -> Evaluation {
        let to_zone = frames[of].inverse() * frames[group];
        let mut most = Evaluation { distance: f64::NEG_INFINITY, place: None };
        if !is_usable(&to_zone) {
            return most;
        }
        for (k, zone) in zones.iter().enumerate() {
            let mut least = Evaluation { distance: f64::INFINITY, place: None };
            for (i, solid) in self.groups[group].solids.iter().enumerate() {
                let room = room(solid, &to_zone, zone);
                if room.distance < least.distance {
                    let place = Place { solids: [i, k], on_a: room.on_body, on_b: room.on_zone };
                    least = Evaluation { distance: room.distance, place: Some(place) };
                }
            }
            if least.distance > most.distance {
                most = least;
            }
        }
        moved(most, &frames[of])
    }
}

fn moved(found: Evaluation, frame: &DAffine3) -> Evaluation {
    let at = |p: DVec3| frame.transform_point3(p);
    let place = found.place.map(|p| Place { solids: p.solids, on_a: at(p.on_a), on_b: at(p.on_b) });
    Evaluation { place, ..found }
}
