//! Machine, part and fixtures as one scene that moves with the axes.

use crate::axis::{Axis, AxisKind};
use crate::chain::{Joints, MAX_AXES};
use crate::file::ZoneKind;
use crate::lever::{Lever, PITCH, travel};
use crate::links::LinkFrames;
use crate::machine::Machine;
use arrayvec::ArrayVec;
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Clamped, ClearanceError, Evaluation, Group, Limits, Motion, Profile, Scene, Solid, Watch};
use seamwright_message::Message;
use std::collections::BTreeMap;

/// Positions of the axes along a parameter.
pub trait Course {
    /// First and last parameter.
    fn range(&self) -> (f64, f64);
    /// Positions at `s`, mm or rad.
    fn at(&self, s: f64) -> Joints;
    /// For each axis an upper bound of the speed |dq/ds| everywhere in `from..=to`.
    fn greatest_rates(&self, from: f64, to: f64) -> Joints;
    /// For each axis an upper bound of the difference of its speeds dq/ds at any two places of `from..=to`.
    fn greatest_rate_changes(&self, from: f64, to: f64) -> Joints {
        self.greatest_rates(from, to).map(|rate| 2.0 * rate)
    }
}

/// Scene of machine, part and fixtures with the clearances between them.
#[derive(Debug, Clone)]
pub struct Surroundings<'a> {
    machine: &'a Machine,
    scene: Scene,
    /// The link of each group of the scene.
    links: Vec<usize>,
    kinds: Vec<Kind>,
    /// A sphere around each group's solids: centre in the work frame with all axes at zero, and radius.
    spheres: Vec<(DVec3, f64)>,
}

/// Bounds of the axes' speeds |dq/ds| on a stretch.
struct Rates {
    /// The maximum.
    greatest: Joints,
    /// The maximum difference of two.
    change: Joints,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Link,
    Part,
    Fixtures,
    /// A forbidden zone, by its index.
    Forbidden(usize),
    /// A permitted zone, by its index.
    Permitted(usize),
}

fn permitted(zone: &str) -> Message {
    Message::new("machine-permitted-zone").text("zone", zone)
}

impl<'a> Surroundings<'a> {
    /// The machine with its clamped part and fixtures.
    ///
    /// It watches: links that are neither neighbours nor allowed to touch, part and fixtures against every link that
    /// moves relative to them, and the machine's zones.
    ///
    /// # Errors
    /// Unbounded solids (half-spaces) that would have to keep clear of one another.
    pub fn new(machine: &'a Machine, clamped: &Clamped) -> Result<Self, ClearanceError> {
        let mut build =
            Build { machine, groups: Vec::new(), links: Vec::new(), kinds: Vec::new(), watches: Vec::new() };
        build.links();
        for (kind, name, solids) in
            [(Kind::Part, "part", &clamped.part), (Kind::Fixtures, "fixtures", &clamped.fixtures)]
        {
            build.clamped(kind, name, solids, clamped.least_mm);
        }
        build.zones();
        let spheres = build.groups.iter().map(|g| around(&g.solids)).collect();
        let scene = Scene::new(build.groups, build.watches)?;
        Ok(Self { machine, scene, links: build.links, kinds: build.kinds, spheres })
    }

    /// The same with more solids of the part, as weld metal is; unchanged if the part is not watched.
    ///
    /// # Errors
    /// Half-spaces.
    pub fn with_part(&self, more: &[Solid]) -> Result<Self, ClearanceError> {
        let Some(part) = self.kinds.iter().position(|kind| *kind == Kind::Part) else { return Ok(self.clone()) };
        let mut groups = self.scene.groups().to_vec();
        groups[part].solids.extend(more.iter().cloned());
        let mut spheres = self.spheres.clone();
        spheres[part] = around(&groups[part].solids);
        let scene = Scene::new(groups, self.scene.watches().to_vec())?;
        Ok(Self { machine: self.machine, scene, links: self.links.clone(), kinds: self.kinds.clone(), spheres })
    }

    /// Groups and watches.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// True without watches: the file has no shapes, or they have no counterpart.
    pub fn is_empty(&self) -> bool {
        self.scene.watches().is_empty()
    }

    /// All watched groups, for messages: links, part, fixtures and zones.
    pub fn watched(&self) -> Vec<Message> {
        let mut groups: Vec<usize> = self.scene.watches().iter().flat_map(|w| [w.groups().0, w.groups().1]).collect();
        groups.sort_unstable();
        groups.dedup();
        groups.into_iter().map(|g| self.body(g)).collect()
    }

    /// Maximum of the watches' minimum distances, mm.
    pub fn greatest_least_mm(&self) -> f64 {
        self.scene.watches().iter().map(Watch::least_mm).fold(0.0, f64::max)
    }

    /// The two groups of a watch, for messages.
    pub fn bodies(&self, watch: usize) -> (Message, Message) {
        let watch = &self.scene.watches()[watch];
        let (a, b) = watch.groups();
        let second = match watch {
            Watch::Apart { .. } => self.body(b),
            Watch::Inside { zones, .. } => permitted(zones.first().map_or("", Solid::name)),
        };
        (self.body(a), second)
    }

    /// The nearest solids of a watch's evaluation, for messages; its groups if it has none. Solids of the job carry
    /// their group, since a job's nozzle is not a torch's.
    pub fn nearest_bodies(&self, watch: usize, found: &Evaluation) -> (Message, Message) {
        let Some(place) = &found.place else { return self.bodies(watch) };
        let watch = &self.scene.watches()[watch];
        let (a, b) = watch.groups();
        let second = match watch {
            Watch::Apart { .. } => self.solid_body(b, place.solids[1]),
            Watch::Inside { zones, .. } => permitted(zones[place.solids[1]].name()),
        };
        (self.solid_body(a, place.solids[0]), second)
    }

    /// True if the second group of a watch is the part.
    pub fn is_part(&self, watch: usize) -> bool {
        self.kinds[self.scene.watches()[watch].groups().1] == Kind::Part
    }

    fn body(&self, group: usize) -> Message {
        let name = &self.scene.groups()[group].name;
        match self.kinds[group] {
            Kind::Link => Message::verbatim(name),
            Kind::Part => Message::new("machine-part"),
            Kind::Fixtures => Message::new("machine-fixtures"),
            Kind::Forbidden(zone) => {
                Message::new("machine-forbidden-zone").text("zone", &self.machine.solids.zones[zone].name)
            }
            Kind::Permitted(zone) => permitted(&self.machine.solids.zones[zone].name),
        }
    }

    fn solid_body(&self, group: usize, solid: usize) -> Message {
        let of = &self.scene.groups()[group];
        let name = of.solids[solid].name();
        match self.kinds[group] {
            Kind::Part if name != of.name => Message::new("machine-solid-of-part").text("name", name),
            Kind::Fixtures if name != of.name => Message::new("machine-solid-of-fixtures").text("name", name),
            Kind::Link => Message::verbatim(name),
            _ => self.body(group),
        }
    }

    /// Names of the nearest solids of a watch's evaluation, as in the files.
    pub fn solids(&self, watch: usize, found: &Evaluation) -> Option<(String, String)> {
        let (a, b) = self.scene.watches()[watch].groups();
        let place = found.place.as_ref()?;
        let name = |group: usize, solid: usize| self.scene.groups()[group].solids[solid].name().to_owned();
        let second = match &self.scene.watches()[watch] {
            Watch::Apart { .. } => name(b, place.solids[1]),
            Watch::Inside { zones, .. } => format!("permitted zone {}", zones[place.solids[1]].name()),
        };
        Some((name(a, place.solids[0]), second))
    }

    /// The index and evaluation of the watch with the smallest margin (distance less its minimum) at positions `q`. A
    /// distance of `limit` (mm) or more is only reported as at least that. None without watches.
    pub fn nearest(&self, q: &Joints, limit: f64) -> Option<(usize, Evaluation)> {
        let frames = self.frames(q);
        let margin = |watch: usize, e: &Evaluation| e.distance - self.scene.watches()[watch].least_mm();
        (0..self.scene.watches().len())
            .map(|watch| (watch, self.scene.evaluate(watch, &frames, limit)))
            .min_by(|a, b| margin(a.0, &a.1).total_cmp(&margin(b.0, &b.1)))
    }

    /// True if every watch holds at positions `q`.
    pub fn is_clear(&self, q: &Joints) -> bool {
        let frames = self.frames(q);
        (0..self.scene.watches().len()).all(|watch| {
            let least = self.scene.watches()[watch].least_mm();
            self.scene.evaluate(watch, &frames, least + 1.0).distance >= least
        })
    }

    /// Pairs of links, by their indices, that are nearer than their minimum distance at positions `q`.
    pub(crate) fn touching(&self, q: &Joints) -> Vec<(usize, usize)> {
        let frames = self.frames(q);
        let too_near = |&watch: &usize| {
            let least = self.scene.watches()[watch].least_mm();
            self.scene.evaluate(watch, &frames, least + 1.0).distance < least
        };
        let links = |watch: usize| {
            let (a, b) = self.scene.watches()[watch].groups();
            (self.links[a], self.links[b])
        };
        (0..self.scene.watches().len()).filter(too_near).map(links).collect()
    }

    /// Distances along a whole course, conservative between samples: see [`Scene::along`].
    ///
    /// # Errors
    /// Limits that are not greater than 0.
    pub fn along(&self, course: &impl Course, stations: usize, limits: &Limits) -> Result<Profile, ClearanceError> {
        self.scene.along(&Follow { surroundings: self, course }, stations, limits)
    }

    /// True if every watch is proven along the whole course: see [`Scene::is_clear_along`].
    ///
    /// # Errors
    /// Limits that are not greater than 0.
    pub fn is_clear_along(&self, course: &impl Course, limits: &Limits) -> Result<bool, ClearanceError> {
        self.scene.is_clear_along(&Follow { surroundings: self, course }, limits)
    }

    /// Minimum distance at each edge of a `profile` of the course, mm, at most `cutoff_mm`: see [`Scene::at_edges`].
    pub fn at_edges(&self, course: &impl Course, profile: &Profile, cutoff_mm: f64) -> Vec<f64> {
        self.scene.at_edges(&Follow { surroundings: self, course }, profile, cutoff_mm)
    }

    /// Frames of the groups in the work frame.
    fn frames(&self, q: &Joints) -> Vec<DAffine3> {
        let mut frames = vec![DAffine3::IDENTITY; self.links.len()];
        self.frames_into(q, &mut frames);
        frames
    }

    /// The same into `frames`, one for each group.
    pub(crate) fn frames_into(&self, q: &Joints, frames: &mut [DAffine3]) {
        let motion = self.machine.link_frames(q);
        frames.iter_mut().zip(&self.links).for_each(|(f, &l)| *f = motion[l]);
    }

    /// An upper bound of the speed of any point of group `a` seen from group `b` while the axes move from `q` at up to
    /// `rates` over a stretch of `length`.
    ///
    /// Each axis between the two contributes its rate, a rotary one times the maximum distance of the group from the
    /// axis: that at `q`, plus the displacement by the axes between group and axis over the stretch.
    fn greatest_speed(&self, a: usize, b: usize, q: &Joints, rates: &Joints, length: f64) -> f64 {
        let levers = self.levers(a, b, q);
        if length > 0.0 { travel(&levers, |i| rates[i] * length) / length } else { travel(&levers, |i| rates[i]) }
    }

    /// An upper bound of the distance (mm) of any point of group `a`, seen from group `b`, from an even straight motion
    /// between its places at the ends of a stretch of `length`, on which the axes move from `q` with `rates`.
    ///
    /// A point whose velocity changes by up to c on the way is at most c / 4 times the length beside it. The velocity
    /// that an axis gives a point changes with the axis' rate, with the motion of the point by the axes before it, and by
    /// the turns of the axis itself and of those behind it.
    fn greatest_bend(&self, groups: (usize, usize), q: &Joints, rates: &Rates, length: f64) -> f64 {
        let levers = self.levers(groups.0, groups.1, q);
        let by = |lever: &Lever| rates.greatest[lever.axis] * lever.pitch * length;
        let turn = |lever: &Lever| if lever.kind == AxisKind::Rotary { by(lever) } else { 0.0 };
        let mut turned: f64 = levers.iter().map(turn).sum();
        let (mut moved, mut change) = (0.0, 0.0);
        for lever in &levers {
            let greatest = rates.greatest[lever.axis];
            let rate = greatest * lever.pitch;
            let rate_change = rates.change[lever.axis] * lever.pitch + 2.0 * (lever.pitch - 1.0) * greatest;
            let arm = if lever.kind == AxisKind::Rotary { lever.arm + moved } else { 1.0 };
            // `turned` is of this axis and those behind it.
            let arm_change = if lever.kind == AxisKind::Rotary { moved } else { 0.0 } + turned * arm;
            change += rate_change * arm + rate * arm_change;
            moved += by(lever) * arm;
            turned -= turn(lever);
        }
        change * length / 4.0
    }

    /// Levers of the axes between two groups on the points of the first at positions `q`, in their order from it.
    pub(crate) fn levers(&self, a: usize, b: usize, q: &Joints) -> ArrayVec<Lever, MAX_AXES> {
        let motion = self.machine.link_frames(q);
        let (centre, radius) = self.spheres[a];
        let centre = motion[self.links[a]].transform_point3(centre);
        let of = |axis: usize| {
            let Axis { kind, pitch_error, .. } = &self.machine.axes[axis];
            let arm = if *kind == AxisKind::Linear { 1.0 } else { self.lever(axis, centre, &motion) + radius };
            Lever { axis, kind: *kind, arm, pitch: if pitch_error.is_some() { PITCH } else { 1.0 } }
        };
        self.axes_from(a, b).map(of).collect()
    }

    fn lever(&self, axis: usize, point: DVec3, motion: &LinkFrames) -> f64 {
        // The tree contains every axis of the chain.
        self.machine.links.screw_at(axis, motion).map_or(f64::INFINITY, |s| s.direction.cross(point - s.at).length())
    }

    /// The axes between two groups, in their order from the first.
    fn axes_from(&self, a: usize, b: usize) -> impl Iterator<Item = usize> {
        let links = &self.machine.links;
        let (from, to) = (self.links[a], self.links[b]);
        let different = links.links[from].axes.different(links.links[to].axes);
        let up = links.up(from).filter(move |axis| different.has(*axis));
        let down: ArrayVec<usize, MAX_AXES> = links.up(to).filter(|axis| different.has(*axis)).collect();
        up.chain(down.into_iter().rev())
    }
}

/// A course as the motion of the scene.
struct Follow<'a, C> {
    surroundings: &'a Surroundings<'a>,
    course: &'a C,
}

impl<C: Course> Motion for Follow<'_, C> {
    fn range(&self) -> (f64, f64) {
        self.course.range()
    }

    fn frames(&self, s: f64, frames: &mut [DAffine3]) {
        self.surroundings.frames_into(&self.course.at(s), frames);
    }

    fn greatest_speed(&self, a: usize, b: usize, from: f64, to: f64) -> f64 {
        let (q, rates) = (self.course.at(from), self.course.greatest_rates(from, to));
        self.surroundings.greatest_speed(a, b, &q, &rates, to - from)
    }

    fn greatest_bend(&self, a: usize, b: usize, from: f64, to: f64) -> f64 {
        let (greatest, change) = (self.course.greatest_rates(from, to), self.course.greatest_rate_changes(from, to));
        self.surroundings.greatest_bend((a, b), &self.course.at(from), &Rates { greatest, change }, to - from)
    }
}

/// A sphere around solids; its radius is infinite around a half-space.
fn around(solids: &[Solid]) -> (DVec3, f64) {
    let spheres: Vec<(DVec3, f64)> = solids.iter().map(Solid::sphere).collect();
    let centre = spheres.iter().map(|s| s.0).sum::<DVec3>() / spheres.len().max(1) as f64;
    (centre, spheres.iter().map(|s| s.0.distance(centre) + s.1).fold(0.0, f64::max))
}

struct Build<'a> {
    machine: &'a Machine,
    groups: Vec<Group>,
    links: Vec<usize>,
    kinds: Vec<Kind>,
    watches: Vec<Watch>,
}

impl Build<'_> {
    fn group(&mut self, kind: Kind, name: &str, link: usize, solids: Vec<Solid>) -> usize {
        self.groups.push(Group { name: name.to_owned(), solids });
        self.links.push(link);
        self.kinds.push(kind);
        self.groups.len() - 1
    }

    /// Adds a group for each link, named by the frames that have shapes, and watches between links that are not
    /// neighbours.
    fn links(&mut self) {
        let mut by_link: BTreeMap<usize, Vec<Solid>> = BTreeMap::new();
        for (link, solid) in &self.machine.solids.solids {
            by_link.entry(*link).or_default().push(solid.clone());
        }
        for (link, solids) in by_link {
            let mut names: Vec<&str> = solids.iter().filter_map(|s| s.name().split(':').next()).collect();
            names.dedup();
            let name = names.join("/");
            self.group(Kind::Link, &name, link, solids);
        }
        let ignored = &self.machine.solids.ignored;
        for b in 0..self.groups.len() {
            for a in 0..b {
                let (l, m) = (self.links[a], self.links[b]);
                let neighbours = self.machine.links.parent(l) == Some(m) || self.machine.links.parent(m) == Some(l);
                if !neighbours && !ignored.contains(&(l, m)) && !ignored.contains(&(m, l)) {
                    self.watches.push(Watch::Apart { a, b, least_mm: self.machine.solids.least_mm });
                }
            }
        }
    }

    /// Adds part or fixtures, watched against every link that moves relative to the work.
    fn clamped(&mut self, kind: Kind, name: &str, solids: &[Solid], least_mm: f64) {
        if solids.is_empty() {
            return;
        }
        let others = self.groups.len();
        let b = self.group(kind, name, 0, solids.to_vec());
        let moving: Vec<usize> = (0..others).filter(|&a| self.links[a] != 0).collect();
        self.watches.extend(moving.into_iter().map(|a| Watch::Apart { a, b, least_mm }));
    }

    fn zones(&mut self) {
        let groups = self.groups.len();
        for (i, zone) in self.machine.solids.zones.iter().enumerate() {
            let (kind, word, solids) = match zone.kind {
                ZoneKind::Forbidden => (Kind::Forbidden(i), "forbidden", zone.solids.clone()),
                ZoneKind::Permitted => (Kind::Permitted(i), "permitted", Vec::new()),
            };
            let on = self.group(kind, &format!("{word} zone {}", zone.name), zone.link, solids);
            for group in 0..groups {
                let link = self.links[group];
                let named = |name: &String| match self.machine.links.frame(name) {
                    Some(frame) => frame.link == link && self.kinds[group] == Kind::Link,
                    None => *name == self.groups[group].name,
                };
                let watched = zone.watch.as_ref().map_or(link != zone.link, |names| names.iter().any(named));
                if !watched {
                    continue;
                }
                let least_mm = zone.least_mm;
                self.watches.push(match zone.kind {
                    ZoneKind::Forbidden => Watch::Apart { a: group, b: on, least_mm },
                    ZoneKind::Permitted => Watch::Inside { group, of: on, zones: zone.solids.clone(), least_mm },
                });
            }
        }
        // Permitted zones with the same group and minimum form one watch.
        self.join_permitted();
    }

    fn join_permitted(&mut self) {
        let mut joined: Vec<Watch> = Vec::new();
        for watch in std::mem::take(&mut self.watches) {
            let same = joined.iter_mut().find_map(|other| match (other, &watch) {
                (
                    Watch::Inside { group, of, zones, least_mm },
                    Watch::Inside { group: g, of: o, zones: more, least_mm: l },
                ) if group == g && self.links[*of] == self.links[*o] && (*least_mm - l).abs() < 1e-12 => {
                    Some((zones, more.clone()))
                }
                _ => None,
            });
            match same {
                Some((zones, more)) => zones.extend(more),
                None => joined.push(watch),
            }
        }
        self.watches = joined;
    }
}
