//! Rules by which each control converts a block's F into a time.
//!
//! Inverse time (G93): `60 / F` seconds on all of them; LinuxCNC converts it into a feed along the way and raises that
//! to [`MIN_FEED`] without a message. Per minute (G94): the counted way divided by F. The counted way is
//! - LinuxCNC: X Y Z if they move, else U V W, else A B C in degrees;
//! - grblHAL: the root of the sum of squares of all axes, degrees as mm;
//! - Sinumerik: the same of the axes of FGROUP, by default X Y Z; axes beside it arrive with them. A degree of a rotary
//!   axis counts as a mm (FGREF at its usual 360 / 2 pi mm);
//! - PMAC: the same of the axes of FRAX, by default X Y Z; F is per second (Isx90 = 1000).

use crate::control::{Control, Dialect};
use crate::part_program::{Arc, ChannelKind};
use glam::DVec3;

/// LinuxCNC's interpreter raises any lower feed to this, in mm/min or deg/min, without a word.
pub(crate) const MIN_FEED: f64 = 0.1;

/// Axes that a feed counts: those of FGROUP or FRAX by channel; `None`: the control's usual ones.
pub type Group<'a> = Option<&'a [usize]>;

/// A control's rule for the counted way, computed once for many blocks.
#[derive(Debug, Clone)]
pub(crate) struct FeedRule {
    /// Sets of channels that count together: the first one with motion is used.
    sets: Vec<Vec<usize>>,
    xyz: [Option<usize>; 3],
}

impl FeedRule {
    /// Channels that count together, a bit for each; 0 if the rule has no set.
    pub(crate) fn counted(&self) -> u64 {
        self.sets.first().into_iter().flatten().fold(0, |bits, channel| bits | 1 << channel)
    }

    /// The way from one row to another, mm (or degrees); `arc` if X Y Z go round.
    pub(crate) fn way(&self, arc: Option<&Arc>, from: &[f64], to: &[f64]) -> f64 {
        self.sets.iter().map(|axes| self.way_of(axes, arc, from, to)).find(|way| *way > 0.0).unwrap_or(0.0)
    }

    /// The root of the sum of squares of `axes`; X Y Z among them along `arc` if it is given.
    fn way_of(&self, axes: &[usize], arc: Option<&Arc>, from: &[f64], to: &[f64]) -> f64 {
        let square = |i: &usize| (to[*i] - from[*i]).powi(2);
        let Some(arc) = arc.filter(|_| self.xyz.iter().flatten().any(|i| axes.contains(i))) else {
            return axes.iter().map(square).sum::<f64>().sqrt();
        };
        let place = |row: &[f64]| DVec3::from_array(self.xyz.map(|channel| channel.map_or(0.0, |i| row[i])));
        let others = axes.iter().filter(|i| !self.xyz.contains(&Some(**i))).map(square).sum::<f64>();
        (arc.length(place(from), place(to)).powi(2) + others).sqrt()
    }
}

impl Control {
    /// The way that the control counts a feed along, from one row to another, mm (or degrees); `arc` if X Y Z go round.
    pub fn feed_way(&self, group: Group, arc: Option<&Arc>, from: &[f64], to: &[f64]) -> f64 {
        self.feed_rule(group).way(arc, from, to)
    }

    pub(crate) fn feed_rule(&self, group: Group) -> FeedRule {
        let xyz = ["x", "y", "z"].map(|name| self.channel(name));
        let axes = |counts: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..self.channels.len()).filter(|i| self.is_axis(*i) && counts(*i)).collect()
        };
        let sets = match (self.dialect, group) {
            (Dialect::Linuxcnc, _) => {
                ["XYZ", "UVW", "ABC"].map(|letters| axes(&|i| letters.contains(self.addresses[i].as_str()))).to_vec()
            }
            (Dialect::Grblhal, _) => vec![axes(&|_| true)],
            (_, Some(group)) => vec![group.to_vec()],
            (_, None) => vec![xyz.iter().flatten().copied().collect()],
        };
        FeedRule { sets, xyz }
    }

    fn is_axis(&self, channel: usize) -> bool {
        matches!(self.channels[channel].kind, ChannelKind::Linear | ChannelKind::Rotary)
    }

    /// Time of a block with inverse-time feed `f` (per minute) whose way is `way`, s.
    pub fn inverse_time(&self, f: f64, way: f64) -> f64 {
        match self.dialect {
            Dialect::Linuxcnc if way > 0.0 => 60.0 * way / (way * f).max(MIN_FEED),
            _ => 60.0 / f,
        }
    }

    /// Time of a block with feed `f` (mm/min; PMAC: mm/s) whose way is `way`, s.
    pub fn per_minute(&self, f: f64, way: f64) -> f64 {
        match self.dialect {
            Dialect::Linuxcnc => 60.0 * way / f.max(MIN_FEED),
            Dialect::Pmac => way / f,
            _ => 60.0 * way / f,
        }
    }
}

impl Arc {
    /// Length from `start` to `end`, mm: of a helix its way along the axis counts too, of a spiral its mean radius.
    pub fn length(&self, start: DVec3, end: DVec3) -> f64 {
        let across = |p: DVec3| {
            let away = p - self.centre;
            (away.dot(self.normal), away.reject_from_normalized(self.normal).length())
        };
        let ((h0, r0), (h1, r1)) = (across(start), across(end));
        (self.sweep * 0.5 * (r0 + r1)).hypot(h1 - h0)
    }
}
