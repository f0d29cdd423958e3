use super::layers::Layer;
use crate::joint::Section;
use glam::DVec2;

/// Arrangement of beads in their layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Laying {
    /// Distance of the wire from the walls, mm.
    pub(crate) wall: f64,
    /// Turn of the wire towards a wall, rad.
    pub(crate) tilt: f64,
    /// True if the wires share the way between the walls, each weaving over its part.
    pub(crate) shared: bool,
}

/// A bead in a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeadAt {
    /// Its layer, counted from 0 at the root.
    pub layer: usize,
    /// Its index in the layer, counted from 0 at the second part.
    pub index: usize,
    /// Target of the wire, mm, in the frame of the [`Section`].
    pub tip: DVec2,
    /// Angle from the bisector to the torch, rad; positive leans towards the first part.
    pub lean: f64,
    /// Its part of the way between the walls, mm: how wide a wire weaves that shares it with the others.
    pub room: f64,
    /// Area of the bead, mm^2.
    pub area: f64,
    /// Heights between which the bead's layer lies in the groove, mm.
    pub heights: (f64, f64),
    /// Parts of the cap's height between which it lies over the line from toe to toe.
    pub cap: (f64, f64),
    /// Parts of the layer's width between which the bead lies, from the second part to the first.
    pub parts: (f64, f64),
}

/// Height of the wire's target over the bottom of the groove in the first layer, as a part of the layer's height.
const ROOT_RISE: f64 = 0.35;

/// The beads of `layers` in a section, layer by layer, each from the second part to the first. Layers for which
/// `present` is false are left out and their area goes to the others.
///
/// Guarantee: the areas sum to that of groove and cap. A bead's area is its share of its layer's. The layers' areas are
/// those of the groove between their heights, and of the cap for the last one.
pub(crate) fn fill(
    section: &Section,
    layers: &[Layer],
    present: impl Fn(usize) -> bool,
    laying: Laying,
    out: &mut Vec<BeadAt>,
) {
    out.clear();
    let shares: f64 = layers.iter().enumerate().filter(|(k, _)| present(*k)).map(|(_, l)| l.share).sum();
    let scale = section.total() / shares;
    let square = section.up.x.atan2(section.up.y);
    let mut below = 0.0;
    for (k, layer) in layers.iter().enumerate().filter(|(k, _)| present(*k)) {
        let over = |area: f64| {
            let part = if section.cap > 0.0 { (area - section.area()) / section.cap } else { 0.0 };
            part.clamp(0.0, 1.0)
        };
        let (low, under) = (section.slices.height_of(below), over(below));
        below += layer.share * scale;
        let high = section.slices.height_of(below);
        // At the root the gap between the parts is narrow, and the wire points above it.
        let base = if below <= layer.share * scale { low + ROOT_RISE * (high - low) } else { low };
        let (left, right) = section.slices.edges(base);
        let middle = section.slices.edges(0.5 * (low + high));
        let n = layer.beads as f64;
        for index in 0..layer.beads {
            let centre = middle.0 + (middle.1 - middle.0) * (index as f64 + 0.5) / n;
            let (from, to) = (left + laying.wall, right - laying.wall);
            let across = if layer.beads == 1 || from >= to {
                0.5 * (left + right)
            } else if laying.shared {
                from + (to - from) * (index as f64 + 0.5) / n
            } else {
                centre.clamp(from, to)
            };
            let towards = match index {
                _ if layer.beads == 1 => 0.0,
                0 => laying.tilt,
                i if i + 1 == layer.beads => -laying.tilt,
                _ => 0.0,
            };
            out.push(BeadAt {
                layer: k,
                index,
                tip: section.place(across, base),
                lean: square + towards,
                room: ((to - from) / n).max(0.0),
                area: layer.share * scale / n,
                heights: (low, high),
                cap: (under, over(below)),
                parts: (index as f64 / n, (index as f64 + 1.0) / n),
            });
        }
    }
}

impl Section {
    /// Outline of a bead for drawing, mm: its part of the layer in the groove, and of the cap.
    pub fn outline(&self, bead: &BeadAt) -> Vec<DVec2> {
        let (low, high) = bead.heights;
        let top = self.slices.heights().1;
        let side = |part: f64, height: f64| {
            let (left, right) = self.slices.edges(height);
            self.place(left + part * (right - left), height)
        };
        let steps = 24;
        let heights = |k: i32| low + (high - low) * f64::from(k) / f64::from(steps);
        // Just below the top: there the edges are those of the toes.
        let at = |part: f64, k: i32| side(part, heights(k).min(top - 1e-9 * (top - low)));
        let mut outline: Vec<DVec2> = (0..=steps).map(|k| at(bead.parts.1, k)).collect();
        // The cap is a parabola from toe to toe; layers in it lie between flatter ones.
        let curve = |rise: f64, from: f64, to: f64| {
            (0..=steps).map(move |k| from + (to - from) * f64::from(k) / f64::from(steps)).map(move |part| {
                let height = self.cap_height * rise * 4.0 * part * (1.0 - part);
                at(part, steps) + height * self.up
            })
        };
        let (first, last) = bead.parts;
        if bead.cap.1 > 0.0 {
            outline.extend(curve(bead.cap.1, last, first));
        }
        outline.extend((0..=steps).rev().map(|k| at(first, k)));
        if bead.cap.0 > 0.0 {
            outline.extend(curve(bead.cap.0, first, last));
        }
        outline
    }
}
