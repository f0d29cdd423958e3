//! A crawl along the joint with whatever carries the eye.

use super::operator::Terminal;
use super::outcome::Outcome;
use super::picture::Picture;
use super::{camera, follower, settings};
use crate::args::teach::TeachArgs;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::progress::Progress;
use glam::DVec3;
use seamwright_cell::eyes::SeamLine;
use seamwright_cell::frames::Recorder;
use seamwright_cell::teach::{Carrier, Look, Rig};
use seamwright_geometry::HeightTable;
use seamwright_machine::{Joints, Machine, Sensor, Surroundings};
use seamwright_motion::PassMotion;
use seamwright_tracking::teach::{Crawl, End, EyePose};
use std::cell::RefCell;

/// What a crawl is along, and with which eye.
pub(super) struct Session<'a> {
    pub(super) args: &'a TeachArgs,
    pub(super) nominal: &'a SeamLine,
    pub(super) machine: &'a Machine,
    pub(super) sensor: &'a Sensor,
    table: &'a HeightTable,
}

impl<'a> Session<'a> {
    pub(super) fn new(args: &'a TeachArgs, loaded: &'a Loaded, nominal: &'a SeamLine) -> Result<Self, Failure> {
        let (sensor, table) = camera(args, &loaded.machine)?;
        Ok(Self { args, nominal, machine: &loaded.machine, sensor, table })
    }

    /// Crawls from `start` with the eye that `rig` carries.
    pub(super) fn crawl(&self, start: EyePose, rig: &mut dyn Rig) -> Result<Outcome, Failure> {
        let Self { args, nominal, machine, sensor, table } = self;
        let mut crawl = Crawl::new(settings(args, nominal)?, table, *nominal, start);
        let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        let mut recorder = args.record.as_ref().map(|folder| Recorder::create(folder, &axes)).transpose()?;
        let progress = Progress::new("teaching", nominal.length() as u64);
        let picture = RefCell::new(None);
        let mut operator = Terminal::new(args, nominal, &progress, &picture);
        let mut each = |look: &Look| -> Result<(), Failure> {
            progress.at(look.crawl.line().length() as u64);
            picture.replace(Some(Picture::of(look, table)));
            recorder.as_mut().map_or(Ok(()), |recorder| recorder.add(look.frame)).map_err(Failure::from)
        };
        let mut follower = follower(args, table)?;
        let helpers = (&mut follower as _, &mut operator as _);
        let run = seamwright_cell::teach::teach((machine, sensor), &mut crawl, rig, helpers, &mut each);
        let ended = operator.said_end();
        drop(progress);
        // Frames that came before one that did not can be played again.
        recorder.map_or(Ok(()), Recorder::finish)?;
        let run = run?;
        let finding = match &run.end {
            Some(End::Closed { .. } | End::JointEnd) => None,
            Some(End::Limit(why)) => Some(format!("the machine can go no further: {why}")),
            Some(End::TooLong) => Some("the joint is longer than twice the nominal seam".to_owned()),
            Some(End::Operator) if ended => None,
            Some(End::Operator) => Some(run.asked.last().cloned().unwrap_or_else(|| "the joint is lost".to_owned())),
            None => Some("the frames are at their end, and the joint is not".to_owned()),
        };
        Ok(Outcome { picture: picture.into_inner(), ..Outcome::of(&crawl, &run, finding) })
    }
}

/// What a machine that is to move needs to know: the planned weld, near which its axes to spare stay, and what is around.
pub(super) struct Ground<'a> {
    nominal: &'a SeamLine,
    planned: PassMotion,
    around: Surroundings<'a>,
}

impl<'a> Ground<'a> {
    pub(super) fn new(loaded: &'a Loaded, nominal: &'a SeamLine) -> Result<Self, Failure> {
        let machine = &loaded.machine;
        let pass = &loaded.welding.program.value.passes[0];
        let planned = PassMotion::plan(machine, &loaded.welding.path(0), pass, 1).map_err(Failure::Findings)?;
        let around = Surroundings::new(machine, &loaded.clamped).map_err(|e| Failure::Input(e.to_string()))?;
        Ok(Self { nominal, planned, around })
    }

    /// Positions of the axes where the planned weld is nearest to a point.
    pub(super) fn guide(&self, point: DVec3) -> Option<Joints> {
        let way = self.nominal.foot(point)?.way;
        Some(self.planned.path.at(way.min(self.planned.path.length())))
    }

    /// Positions of the axes where the planned weld begins.
    pub(super) fn start(&self) -> Joints {
        self.planned.path.at(0.0)
    }

    /// The machine of `session` with its axes at `axes`.
    pub(super) fn carrier<'b>(
        &'b self,
        session: &Session<'b>,
        guide: &'b dyn Fn(DVec3) -> Option<Joints>,
        axes: Joints,
    ) -> Carrier<'b> {
        Carrier::new(session.machine, session.sensor, &self.around, Some(guide), axes)
    }
}
