use crate::axis::{Axis, AxisKind};
use crate::chain::{AxisSet, Chain, Screw};
use crate::file::{MachineFile, StepFile};
use crate::inverse::Inverse;
use crate::links::{Link, Links, NamedFrame};
use crate::welding_head::Head;
use glam::{DAffine3, DVec3};
use seamwright_document::{Direction, Point};
use seamwright_geometry::Pose;

/// Builds the links from the clamped work through the base to the heads.
pub(super) struct Tree<'a> {
    axes: &'a [Axis],
    links: Links,
    /// The link and the frame (in the work frame with all axes at zero) to which the next step attaches.
    link: usize,
    frame: DAffine3,
    /// The frame behind the first fixed step after the last axis.
    flange: Option<DAffine3>,
}

/// Assembles both branches of the file: the links and the heads on them.
pub(super) fn tree(file: &MachineFile, axes: &[Axis]) -> (Links, Vec<Head>) {
    let work = Link { parent: None, axes: AxisSet::default() };
    let links = Links { links: vec![work], ..Links::default() };
    let mut tree = Tree { axes, links, link: 0, frame: DAffine3::IDENTITY, flange: None };
    tree.name("work");
    // From the work to the base: the work's steps in reverse, each inverted.
    file.work.iter().rev().for_each(|step| tree.undo(step));
    tree.links.base = tree.link;
    tree.links.base_zero = tree.frame;
    tree.name("base");
    file.tool.iter().for_each(|step| tree.add(step));
    let (link, frame, flange) = (tree.link, tree.frame, tree.flange);
    let shared = tree.links.links[link].axes;
    let mut heads = Vec::new();
    for (name, steps, direction, tip) in file.heads() {
        (tree.link, tree.frame, tree.flange) = (link, frame, flange);
        steps.iter().for_each(|step| tree.add(step));
        tree.name(name);
        heads.push(tree.head(name, direction, tip, shared));
    }
    (tree.links, heads)
}

impl Tree<'_> {
    fn name(&mut self, name: &str) {
        self.links.frames.push(NamedFrame { name: name.to_owned(), link: self.link, zero: self.frame });
    }

    fn add(&mut self, step: &StepFile) {
        if let Some(fixed) = &step.fixed {
            self.frame *= fixed.affine();
            self.flange.get_or_insert(self.frame);
        } else if let Some((axis, screw)) = self.screw(step, 1.0) {
            self.flange = None;
            self.grow(screw);
            self.name(&axis);
        }
    }

    /// Adds the inverse of one step of the work's branch: the link it carries is already there.
    fn undo(&mut self, step: &StepFile) {
        if let Some(fixed) = &step.fixed {
            self.frame *= fixed.affine().inverse();
        } else if let Some((axis, screw)) = self.screw(step, -1.0) {
            self.name(&axis);
            self.grow(screw);
        }
    }

    fn screw(&self, step: &StepFile, sense: f64) -> Option<(String, Screw)> {
        let axis = self.axes.iter().position(|a| Some(&a.name) == step.axis.as_ref())?;
        let local: Direction = step.turn.or(step.direction)?;
        let direction = sense * self.frame.transform_vector3(local.unit());
        let at = self.frame.transform_point3(step.at_mm.map_or(DVec3::ZERO, Point::get));
        let screw = Screw { axis, kind: self.axes[axis].kind, direction, at };
        Some((self.axes[axis].name.clone(), screw))
    }

    fn grow(&mut self, screw: Screw) {
        let axes = self.links.links[self.link].axes.with(screw.axis);
        self.links.links.push(Link { parent: Some((self.link, screw)), axes });
        self.link = self.links.links.len() - 1;
    }

    /// The head at the end of the steps so far, with its torch's direction and tip in the last frame.
    fn head(&self, name: &str, direction: Direction, tip: DVec3, shared: AxisSet) -> Head {
        let mut screws: Vec<Screw> = Vec::new();
        let mut link = self.link;
        while let Some((parent, screw)) = self.links.links[link].parent {
            screws.push(screw);
            link = parent;
        }
        let zero = Pose {
            point: self.frame.transform_point3(tip),
            direction: self.frame.transform_vector3(direction.unit()).normalize(),
        };
        let x = self.frame.transform_vector3(DVec3::X);
        let across = (x - x.dot(zero.direction) * zero.direction).try_normalize();
        // A torch along the frame's x axis has no such direction: any will do.
        let across = across.unwrap_or_else(|| zero.direction.any_orthonormal_vector());
        let chain = Chain { screws: screws.into_iter().rev().collect(), zero, across };
        let own = chain.screws.iter().filter(|s| s.kind == AxisKind::Linear && !shared.has(s.axis));
        let slides = own.map(|s| s.axis).collect();
        let inverse = Inverse::of(&chain, self.axes);
        let tool = self.flange.unwrap_or(self.frame).inverse() * self.frame * DAffine3::from_translation(tip);
        Head { name: name.to_owned(), tip, tool, chain, slides, inverse }
    }
}
