//! The comments at the start of a text.

use super::dialect::Tongue;
use super::options::Feed;
use super::writer::Writer;
use crate::control::Dialect;
use crate::part_program::{ChannelKind, Event, Level, What};

impl Writer<'_> {
    /// The comments at the start: the program's name and origin, and how to start again.
    pub(super) fn comments<T: Tongue>(&mut self, tongue: &T, passes: u32) {
        let name = self.control.dialect.title();
        let text = format!("Seamwright {} for {name}: {}", env!("CARGO_PKG_VERSION"), self.program.title);
        self.text.comment(&text);
        if !self.options.machine.is_empty() {
            self.text.comment(&format!("machine: {}", self.options.machine));
        }
        let moves = self.program.steps.iter().filter_map(|step| match &step.what {
            What::Move(m) => Some(m.level),
            _ => None,
        });
        let tip = moves.into_iter().any(|level| level == Level::Tip);
        self.text.comment(match (tip, self.control.dialect) {
            (false, Dialect::Linuxcnc) => {
                "joint level: every word is an axis position, kinematics must be identity [trivkins]"
            }
            (false, _) => "joint level: every word is an axis position, without transformations",
            (true, _) => "tip level: X Y Z are the torch tip in the work frame, kinematics must match the machine",
        });
        let unit = |i: usize| if self.control.channels[i].kind == ChannelKind::Rotary { "degrees" } else { "mm" };
        let names: Vec<String> = (0..self.program.axes())
            .map(|i| format!("{} = {} [{}]", self.control.addresses[i], self.control.channels[i].name, unit(i)))
            .collect();
        self.text.comment(&format!("axes: {}", names.join(", ")));
        let feed = match (self.control.dialect, self.options.feed) {
            (Dialect::Pmac, Feed::InverseTime) => "times of blocks in ms",
            (Dialect::Pmac, Feed::PerMinute) => "feed per second along all axes",
            (_, Feed::InverseTime) => "inverse time feed G93",
            (_, Feed::PerMinute) => "feed per minute G94",
        };
        self.text.comment(&format!("units mm, degrees; absolute; {feed}"));
        self.text.comment("work offsets and tool offsets must be zero");
        self.options.remarks.iter().for_each(|remark| self.text.comment(remark));
        if passes > 1 && self.has_subs() {
            self.text.comment(&tongue.restart(passes));
            let burning = self.burning();
            if !burning.is_empty() {
                self.text.comment(&format!("but not at pass {}: the arc burns on into it", burning.join(", ")));
            }
        }
    }

    /// Numbers of the passes that start with the arc on.
    fn burning(&self) -> Vec<String> {
        let (mut on, mut number, mut burning) = (false, 0, Vec::new());
        for step in &self.program.steps {
            match &step.what {
                What::Event { event: Event::Arc(arc), .. } => on = *arc,
                What::Pass(_) => {
                    number += 1;
                    if on && self.control.switches_arc() {
                        burning.push(number.to_string());
                    }
                }
                _ => {}
            }
        }
        burning
    }
}

impl Dialect {
    /// Its name, for people.
    fn title(self) -> &'static str {
        match self {
            Self::Sinumerik => "Sinumerik 840D",
            Self::Linuxcnc => "LinuxCNC",
            Self::Grblhal => "grblHAL",
            Self::Pmac => "PMAC",
        }
    }
}
