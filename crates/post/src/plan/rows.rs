//! Rows of a part program and the ways between them, with the decimals that are written.

use super::arcs;
use super::block::{Block, Shape, Speeds};
use super::steps::Steps;
use crate::part_program::{Level, Move, Path, What};
use glam::DVec3;
use seamwright_machine::AxisKind;

/// Decimals of positions and values.
pub(super) const SCALE: f64 = 1e6;
/// Decimals of polynomials' coefficients.
const FINE: f64 = 1e9;

impl Steps<'_> {
    /// Writes a position into the row; linear axes keep theirs if `rotary_only`.
    pub(super) fn go_to(&mut self, at: &Block, rotary_only: bool) {
        for (i, axis) in self.machine.axes.iter().enumerate() {
            let value = match (axis.kind, self.level) {
                (AxisKind::Rotary, _) => axis.to_file(at.q[i]),
                (AxisKind::Linear, _) if rotary_only => continue,
                (AxisKind::Linear, Level::Joint) => axis.to_file(at.q[i]),
                (AxisKind::Linear, Level::Tip) => match self.tip_part(i) {
                    Some(k) => at.tip[k],
                    None => continue,
                },
            };
            self.row[i] = rounded(value, SCALE);
        }
    }

    /// Index of axis `i` among X, Y and Z.
    fn tip_part(&self, i: usize) -> Option<usize> {
        ["x", "y", "z"].iter().position(|name| *name == self.machine.axes[i].name)
    }

    /// X, Y and Z of a row.
    fn place(&self, row: &[f64]) -> DVec3 {
        DVec3::from_array(self.control.axes_xyz().map(|i| i.map_or(0.0, |i| row[i])))
    }

    /// Speeds of the axes as a row, in the units of files.
    fn speeds(&self, speeds: &Speeds) -> Vec<f64> {
        let mut row = vec![0.0; self.row.len()];
        for (i, axis) in self.machine.axes.iter().enumerate() {
            let tip = self.tip_part(i).filter(|_| self.level == Level::Tip);
            row[i] = tip.map_or_else(|| axis.to_file(speeds.q[i]), |k| speeds.tip[k]);
        }
        row
    }

    /// The curve from the row before to the row that has these derivatives at its ends.
    fn curve(&mut self, from: &Speeds, to: &Speeds) -> Path {
        let [from, to] = [from, to].map(|speeds| self.speeds(speeds));
        let rise = |i: usize| self.row[i] - self.before[i];
        let axes = self.program.axes();
        let bent = |i: usize| i < axes && rise(i).abs() + from[i].abs() + to[i].abs() > 0.0;
        let power = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
            (0..self.row.len()).map(|i| if bent(i) { rounded(of(i), FINE) } else { 0.0 }).collect()
        };
        let none = || vec![0.0; self.row.len()];
        let second = power(&|i| 3.0 * rise(i) - 2.0 * from[i] - to[i]);
        let third = power(&|i| from[i] + to[i] - 2.0 * rise(i));
        Path::Curve(self.program.add_curve(&[second, third, none(), none()], (1 << axes) - 1))
    }

    /// The way of a block from the row before to where the row is now.
    pub(super) fn path(&mut self, shape: &Shape) -> Path {
        match shape {
            Shape::Line => Path::Line,
            Shape::Spline => Path::Spline,
            Shape::Hermite { to, .. } => {
                let speeds: Vec<f64> = self.speeds(to).into_iter().map(|v| rounded(v, SCALE)).collect();
                Path::Hermite(self.program.add_row(&speeds))
            }
            Shape::Curve { from, to, .. } => self.curve(from, to),
            Shape::Arc(arc) => {
                let from = self.place(&self.before);
                // The centre as it will be written: from the start, with as many decimals.
                let axis = (0..3).find(|k| arc.normal[*k].abs() > 1.0 - 1e-12);
                let to_centre = (arc.centre - from).reject_from_normalized(arc.normal);
                let centre = from + axis.map_or(to_centre, |_| (to_centre * SCALE).round() / SCALE);
                match arcs::between(from, self.place(&self.row), centre, arc.normal) {
                    Some(arc) => {
                        self.program.arcs.push(arc);
                        Path::Arc(self.program.arcs.len() as u32 - 1)
                    }
                    None => Path::Line,
                }
            }
        }
    }

    /// A move to the row.
    pub(super) fn push(&mut self, path: Path, seconds: f64, exact_stop: bool) {
        let row = self.program.add_row(&self.row);
        self.program.push(What::Move(Move { path, row, seconds, level: self.level, exact_stop }));
    }
}

/// `value` as it is written with so many parts of 1; never a negative zero.
pub(super) fn rounded(value: f64, scale: f64) -> f64 {
    (value * scale).round() / scale + 0.0
}
