//! Joint following with any carrier of the camera.

use super::operator::Terminal;
use super::setup::{camera, follower, settings};
use crate::args::teach::TeachArgs;
use crate::progress::Progress;
use seamwright_frames::Recorder;
use seamwright_geometry::HeightTable;
use seamwright_machine::{Machine, Sensor};
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_teaching::{CameraPose, Crawl, Look, Outcome, Picture, Rig, SeamLine, Setup};
use std::cell::RefCell;

/// Seam and camera of a joint following.
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

    pub(super) fn crawl(&self, start: CameraPose, rig: &mut dyn Rig) -> Result<Outcome, Failure> {
        let Self { args, nominal, machine, sensor, table } = self;
        let mut crawl = Crawl::new(settings(args, nominal)?, table, *nominal, start);
        let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        let mut recorder = args.record.as_ref().map(|folder| Recorder::create(folder, &axes)).transpose()?;
        let progress = Progress::new("cli-progress-teaching", nominal.length() as u64);
        let picture = RefCell::new(None);
        let mut operator = Terminal::new(args, nominal, &progress, &picture);
        let mut each = |look: &Look| -> Result<(), Failure> {
            progress.at(look.crawl.line().length() as u64);
            picture.replace(Some(Picture::of(look, table)));
            recorder.as_mut().map_or(Ok(()), |recorder| recorder.add(look.frame)).map_err(Failure::from)
        };
        let mut follower = follower(args, table)?;
        let setup = Setup { machine, sensor, midline: &mut follower, operator: &mut operator };
        let run = seamwright_teaching::teach(setup, &mut crawl, rig, &mut each);
        let ended = operator.said_end();
        drop(progress);
        // Frames that came before one that did not can be played again.
        recorder.map_or(Ok(()), Recorder::finish)?;
        let run = run?;
        Ok(Outcome { picture: picture.into_inner(), ..Outcome::of(&crawl, &run, ended) })
    }
}
