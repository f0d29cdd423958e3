use super::device_interface::Devices;
use super::device_io::DeviceIo;
use super::guide::{Guide, Guided, Seen, Tracked, Trouble};
use seamwright_machine::Joints;

/// The guide of the passes, and its last answer.
pub(super) struct GuideState<'a> {
    pub(super) guide: Option<&'a mut (dyn Guide + 'a)>,
    pub(super) corrects: bool,
    /// Maximum feed override of the guide.
    feed_override: f64,
    pub(super) trouble: Option<Trouble>,
    /// Planned positions of the pass in the last cycle.
    pub(super) planned_q: Joints,
}

impl<'a> GuideState<'a> {
    pub(super) fn new() -> Self {
        Self { guide: None, corrects: false, feed_override: 1.0, trouble: None, planned_q: Joints::default() }
    }

    /// Prepares pass `pass` (from 0) from `from_mm` on.
    pub(super) fn begin(&mut self, pass: usize, from_mm: f64, welds: bool) {
        self.corrects = self.guide.as_deref_mut().is_some_and(|guide| guide.begin(pass, from_mm, welds));
    }

    /// Calls the guide at time `t_s`, if it corrects the pass, with the current reports.
    pub(super) fn ask<T, D: Devices>(
        &mut self,
        t_s: f64,
        io: &DeviceIo<D>,
        ask: impl FnOnce(&mut (dyn Guide + 'a), &Seen<'_>) -> T,
    ) -> Option<T> {
        let guide = self.guide.as_deref_mut().filter(|_| self.corrects)?;
        Some(ask(guide, &Seen { t_s, reports: &io.reports, picture: io.devices.picture() }))
    }

    /// Takes the feed override of an answer.
    pub(super) fn take(&mut self, guided: &Guided) {
        self.feed_override = guided.feed_override;
    }

    pub(super) fn tracked(&self) -> [Option<Tracked>; 2] {
        self.guide.as_ref().filter(|_| self.corrects).map_or([None; 2], |guide| guide.tracked())
    }

    /// Returns the feed override to request instead of `asked`: the operator's, or the guide's if that is lower.
    pub(super) fn allowed_override(&self, asked: f64, operator: f64) -> f64 {
        /// Minimum increase that is worth an order.
        const WORTH: f64 = 0.02;
        /// Minimum override taken from the guide: below it, its alarm stops the motion.
        const SLOWEST: f64 = 0.01;
        let guide = if self.corrects { self.feed_override } else { 1.0 };
        if guide < SLOWEST {
            return asked;
        }
        let wanted = operator.min(guide);
        let whole = wanted >= operator;
        if wanted < asked || wanted > asked + WORTH || whole { wanted } else { asked }
    }
}
