//! Arcs of a block, from its words, its start and its end, with the errors that the control reports.

use super::arcs::{self, Tolerance};
use super::error::{Fault, Read, Span};
use super::modal_state::{Motion, State};
use super::motion::{Block, INCH};
use super::target::How;
use crate::control::Dialect;
use crate::part_program::Arc;
use glam::DVec3;
use seamwright_message::{Message, Unit};
use std::f64::consts::TAU;

const IJK: [char; 3] = ['I', 'J', 'K'];
const PLANES: [&str; 3] = ["G19", "G18", "G17"];

impl State<'_> {
    /// X, Y and Z of a row; those that the machine has not are 0.
    fn place_of(&self, row: &[f64]) -> DVec3 {
        DVec3::from_array(self.addresses.xyz.map(|channel| channel.map_or(0.0, |i| row[i])))
    }

    pub(super) fn arc(&mut self, motion: Motion, block: &Block) -> Read<Arc> {
        let (start, end) = (self.place_of(&self.row), self.place_of(&self.next));
        if motion == Motion::Through {
            return self.arc_through(block, start, end);
        }
        if let Some((_, _, span)) = block.middle.iter().flatten().next() {
            return Err(Fault::new(*span, "post-point-without-cip").allowed("post-centre-words"));
        }
        let mut normal = block.normal.unwrap_or(DVec3::AXES[self.plane]);
        if (motion == Motion::Clockwise) != block.normal.is_some() {
            normal = -normal;
        }
        self.check_plane(block, normal)?;
        let extra = block.turns.map_or(0, |t| t.0);
        let tolerance = self.tolerance();
        if let Some((radius, span)) = block.radius {
            let centre = self.centre_by_radius(block, start, end, radius, normal, span)?;
            return Ok(arcs::about(start, end, centre, normal, extra, tolerance.least_angle));
        }
        let centre = self.centre(block, start)?;
        if let Some((degrees, span)) = block.angle {
            return self.arc_by_angle(centre, start, normal, degrees.to_radians(), extra, span);
        }
        let Some((centre, span)) = centre else {
            return Err(Fault::new(block.span, "post-arc-undefined").allowed("post-arc-words"));
        };
        self.check_circle(start, end, centre, normal, span)?;
        Ok(arcs::about(start, end, centre, normal, extra, tolerance.least_angle))
    }

    /// Arcs want the axes of their plane, and no third centre word.
    fn check_plane(&self, block: &Block, normal: DVec3) -> Read {
        if let (Some((_, _, span)), None) = (block.centre[self.plane], block.normal) {
            let message = Message::new("post-centre-outside-plane").text("plane", PLANES[self.plane]);
            return Err(Fault::new(span, message.text("word", IJK[self.plane])).cure("post-plane-cure"));
        }
        let missing = (0..3).find(|k| self.addresses.xyz[*k].is_none() && normal[*k].abs() < 1.0 - 1e-9);
        missing.map_or(Ok(()), |k| {
            let message = Message::new("post-arc-axis-missing").text("axis", ["x", "y", "z"][k]);
            Err(Fault::new(block.span, message).cure("post-arc-axis-missing-cure"))
        })
    }

    fn centre_by_radius(
        &self,
        block: &Block,
        start: DVec3,
        end: DVec3,
        radius: f64,
        normal: DVec3,
        span: Span,
    ) -> Read<DVec3> {
        if let Some((_, _, other)) = block.centre.iter().flatten().next() {
            return Err(Fault::new(*other, "post-centre-and-radius").cure("post-omit-one-word"));
        }
        if let Some((_, other)) = block.angle {
            return Err(Fault::new(other, "post-angle-and-radius").cure("post-omit-one-word"));
        }
        let radius = if self.inch { INCH * radius } else { radius };
        let chord = (end - start).reject_from_normalized(normal).length();
        if chord <= 0.0 {
            return Err(Fault::new(span, "post-radius-full-circle").cure("post-radius-full-circle-cure"));
        }
        arcs::by_radius(start, end, radius, normal, self.tolerance().radius).ok_or_else(|| {
            let message = Message::new("post-radius-too-small").quantity("half", 0.5 * chord, Unit::Mm, 6);
            let allowed = Message::new("post-radius-allowed").quantity("min", 0.5 * chord, Unit::Mm, 6);
            Fault::new(span, message).allowed(allowed)
        })
    }

    /// The arc's centre by I, J and K, if they are given.
    fn centre(&self, block: &Block, start: DVec3) -> Read<Option<(DVec3, Span)>> {
        let Some(span) = block.centre.iter().flatten().map(|c| c.2).next() else { return Ok(None) };
        let mut centre = start;
        for (k, word) in block.centre.iter().enumerate() {
            let Some((value, how, _)) = word else {
                if self.absolute_centre && k != self.plane {
                    return Err(Fault::new(span, Message::new("post-absolute-centre-missing").text("word", IJK[k])));
                }
                continue;
            };
            let value = if self.inch { INCH * value } else { *value };
            let absolute = if *how == How::Modal { self.absolute_centre } else { *how == How::Absolute };
            centre[k] = if absolute { value } else { start[k] + value };
        }
        Ok(Some((centre, span)))
    }

    /// An arc given by its angle, and the centre or the end.
    fn arc_by_angle(
        &mut self,
        centre: Option<(DVec3, Span)>,
        start: DVec3,
        normal: DVec3,
        angle: f64,
        extra: u32,
        span: Span,
    ) -> Read<Arc> {
        if !(angle > 0.0 && angle < TAU) {
            return Err(Fault::new(span, "post-arc-angle").allowed("post-arc-angle-allowed"));
        }
        let sweep = angle + f64::from(extra) * TAU;
        if let Some((centre, centre_span)) = centre {
            let said =
                |k: usize| k != self.plane && self.addresses.xyz[k].is_some_and(|i| self.target.get(i).is_some());
            if (0..3).any(said) {
                return Err(Fault::new(centre_span, "post-centre-angle-end").cure("post-omit-one-word"));
            }
            let end = arcs::turned(start, centre, angle, normal);
            for k in (0..3).filter(|k| *k != self.plane) {
                if let Some(channel) = self.addresses.xyz[k] {
                    self.next[channel] = end[k];
                }
            }
            return Ok(Arc { centre, normal, sweep });
        }
        let end = self.place_of(&self.next);
        let centre = arcs::by_angle(start, end, angle, normal);
        let centre = centre.ok_or_else(|| Fault::new(span, "post-angle-full-circle"))?;
        Ok(Arc { centre, normal, sweep })
    }

    fn check_circle(&mut self, start: DVec3, end: DVec3, centre: DVec3, normal: DVec3, span: Span) -> Read {
        let (first, last) = arcs::radii(start, end, centre, normal);
        let tolerance = self.tolerance();
        if first.min(last) < tolerance.radius.max(1e-6) {
            let starts = first < last;
            let message = if starts { "post-arc-starts-at-centre" } else { "post-arc-ends-at-centre" };
            return Err(Fault::new(span, message));
        }
        let (off, most) = ((first - last).abs(), tolerance.off(first.max(last)));
        if off <= most {
            return Ok(());
        }
        if self.control.dialect == Dialect::Pmac {
            self.note("post-spiral");
            return Ok(());
        }
        let message = Message::new("post-arc-off-circle").quantity("start", first, Unit::Mm, 6).quantity(
            "end",
            last,
            Unit::Mm,
            6,
        );
        let allowed = Message::new("post-arc-off-circle-allowed").quantity("max", most, Unit::Mm, 6);
        Err(Fault::new(span, message)
            .allowed(allowed.message("rule", Message::new(tolerance.rule)))
            .cure("post-arc-off-circle-cure"))
    }

    fn arc_through(&mut self, block: &Block, start: DVec3, end: DVec3) -> Read<Arc> {
        let place = block.arc_word().unwrap_or(block.span);
        if self.addresses.xyz.contains(&None) {
            return Err(Fault::new(place, "post-cip-axes"));
        }
        let centre = block.centre.iter().flatten().map(|c| c.2).next();
        if let Some(span) = centre.or(block.radius.map(|r| r.1)).or(block.angle.map(|a| a.1)) {
            return Err(Fault::new(span, "post-cip-words").allowed("post-cip-words-allowed"));
        }
        let mut middle = start;
        for (k, word) in block.middle.iter().enumerate() {
            let Some((value, how, _)) = word else { continue };
            let value = if self.inch { INCH * value } else { *value };
            let increment = if *how == How::Modal { self.incremental } else { *how == How::Increment };
            middle[k] = if increment { start[k] + value } else { value };
        }
        let mut arc = arcs::through(start, middle, end)
            .ok_or_else(|| Fault::new(place, "post-cip-on-line").cure("post-cip-on-line-cure"))?;
        arc.sweep += f64::from(block.turns.map_or(0, |t| t.0)) * TAU;
        Ok(arc)
    }

    fn tolerance(&self) -> Tolerance {
        let (least, relative, most, radius, least_angle, rule) = match self.control.dialect {
            // Its interpreter: absolute and relative, and at most a hundred times the absolute one for any radius.
            Dialect::Linuxcnc => {
                let least = 2f64.sqrt() * if self.inch { 0.002 * INCH } else { 0.02 };
                (least, 0.001, 100.0 * least, 0.00127, 1e-6, "post-rule-linuxcnc")
            }
            Dialect::Grblhal => (0.005, 0.001, 0.5, 0.0, 5e-7, "post-rule-grblhal"),
            Dialect::Sinumerik => (0.01, 0.001, f64::INFINITY, 0.01, 1e-9, "post-rule-sinumerik"),
            Dialect::Pmac => (0.01, 0.001, f64::INFINITY, 0.001, std::f64::consts::PI / 1_048_576.0, "post-rule-pmac"),
        };
        Tolerance { least, relative, most, radius, least_angle, rule }
    }
}
