//! The cross-section of a bead as metal: width and height from its area and the surface it lies on.
//!
//! **Side by side.** A bead on an open surface is a parabola: its area is 2/3 of width times height. Neighbours lie
//! `spacing` widths apart, the outer beads reach the walls. At 2/3 the valleys are just filled (flat top), at 0.738 the
//! later bead is tangent to the one before (Ding, Pan, Cuiuri and Li, Robotics and Computer-Integrated Manufacturing 31
//! (2015) 101-110, measured for GMAW on flat plate).
//!
//! **Alone in its layer** a bead is as wide as the groove at its top and as high as the layer is thick, with a cap that is
//! a parabola from toe to toe.
//!
//! **Where it fails.** The parabola is for beads in flat position wider than high: gravity makes others unsymmetrical,
//! and beads much wider than their weave or arc sag. Melted walls are not part of a bead: in a narrow gap the real bead
//! is wider by the fusion into both walls, usually 1 to 2 mm each.

use crate::joint::Section;

/// A level of the filled section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Level {
    /// Area of groove and cap below it, mm^2.
    pub(crate) area: f64,
    /// Its height in the groove, mm.
    pub(crate) height: f64,
    /// Area over the line from toe to toe, mm^2.
    over: f64,
    /// Width of the groove there, mm.
    width: f64,
}

/// The groove's width at a level is that just below it, by this part of the groove's height.
const BELOW: f64 = 1e-9;

impl Level {
    /// The level with `area` below it.
    pub(crate) fn new(section: &Section, area: f64) -> Self {
        let height = section.slices.height_of(area);
        let (low, high) = section.slices.heights();
        let (left, right) = section.slices.edges(height - BELOW * (high - low));
        Self { area, height, over: (area - section.area()).max(0.0), width: right - left }
    }
}

/// A layer in a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LayerShape {
    /// Area, mm^2.
    pub(crate) area: f64,
    /// Mean height, mm.
    pub(crate) height: f64,
    /// Width at its top, mm.
    top: f64,
    /// Height in its middle, mm: more than the mean one by a cap.
    middle: f64,
    /// Slope of its cap at the toes.
    crown: f64,
}

/// Width and height of a bead, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BeadSize {
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl LayerShape {
    /// The layer between two levels of a section whose line from toe to toe is `chord` long.
    pub(crate) fn new(low: &Level, high: &Level, chord: f64) -> Self {
        let (rise, over) = (high.height - low.height, high.over - low.over);
        Self {
            area: high.area - low.area,
            height: rise + over / chord,
            top: high.width,
            middle: rise + 1.5 * over / chord,
            crown: 6.0 * high.over / (chord * chord),
        }
    }

    /// Slope of its cap at the toes.
    pub(crate) fn crown(&self) -> f64 {
        self.crown
    }

    /// Slope at the valleys between `count` beads side by side; 0 where the next bead fills them.
    pub(crate) fn wave(&self, count: usize, spacing: f64) -> f64 {
        if count == 1 {
            return 0.0;
        }
        let BeadSize { width, height } = self.bead(count, spacing);
        let crest = height * (1.0 - 2.0 / (3.0 * spacing));
        (12.0 * crest / (spacing * width)).max(0.0)
    }

    /// Each of `count` beads side by side, `spacing` of their widths apart.
    pub(crate) fn bead(&self, count: usize, spacing: f64) -> BeadSize {
        if count == 1 {
            return BeadSize { width: self.top, height: self.middle };
        }
        let width = self.area / self.height / (1.0 + spacing * (count as f64 - 1.0));
        BeadSize { width, height: 1.5 * self.area / count as f64 / width }
    }
}
