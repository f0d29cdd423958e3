//! Teaching in simulation: the seam is where the seed has it, and the report says how far the taught line truly is from it.

use super::outcome::Outcome;
use super::{camera, follower, settings, start};
use crate::args::teach::TeachArgs;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::progress::Progress;
use glam::DVec3;
use seamwright_cell::eyes::{Appearance, Distortion, Eye, SeamLine};
use seamwright_cell::frames::{Recorder, TimedFrame};
use seamwright_cell::teach::{Carrier, NoOperator, crawl, truth};
use seamwright_machine::{Joints, Surroundings};
use seamwright_motion::PassMotion;
use seamwright_tracking::teach::{Crawl, End};

/// How far beside the joint the operator of the simulation puts the cross, mm.
const BESIDE_MM: f64 = 0.3;

pub(super) fn teach(args: &TeachArgs, loaded: &Loaded, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let machine = &loaded.machine;
    let (sensor, table) = camera(args, machine)?;
    let actual = distortion(args)?.of(nominal, args.seed);
    let mut appearance = Appearance { tacks: tacks(args)?, ..Appearance::default() };
    if args.no_height {
        appearance.height_error_mm = None;
    }
    let eye = Eye::new(machine, sensor, actual.clone(), appearance, args.seed);
    let mut eye = eye.ok_or_else(|| Failure::Input(format!("{} is no camera", sensor.name)))?;
    let pass = &loaded.welding.program.value.passes[0];
    let planned = PassMotion::plan(machine, &loaded.welding.path(0), pass, 1).map_err(Failure::Findings)?;
    let guide = |point: DVec3| -> Option<Joints> {
        let way = nominal.foot(point)?.way;
        Some(planned.path.at(way.min(planned.path.length())))
    };
    let around = Surroundings::new(machine, &loaded.clamped).map_err(|e| Failure::Input(e.to_string()))?;
    let mut carrier = Carrier::new(machine, sensor, &around, Some(&guide), planned.path.at(0.0));
    let (first, along) = actual.at(0.0);
    let begin = start(args, nominal, first.point + BESIDE_MM * first.normal.cross(along))?;
    let mut walk = Crawl::new(settings(args, nominal)?, table, nominal, begin);
    let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
    let mut recorder = args.record.as_ref().map(|folder| Recorder::create(folder, &axes)).transpose()?;
    let progress = Progress::new("teaching", nominal.length() as u64);
    let mut operator = NoOperator::default();
    let mut each = |frame: &TimedFrame, crawl: &Crawl| -> Result<(), Failure> {
        progress.at(crawl.line().length() as u64);
        recorder.as_mut().map_or(Ok(()), |recorder| recorder.add(frame)).map_err(Failure::from)
    };
    let run = crawl(
        (machine, sensor),
        (&mut walk, &mut carrier, &mut eye),
        (&mut follower(args, table)?, &mut operator),
        &mut each,
    )?;
    drop(progress);
    if let Some(recorder) = recorder {
        recorder.finish()?;
    }
    let finding = match &run.end {
        End::Closed { .. } | End::JointEnd => None,
        End::Limit(why) => Some(format!("the machine can go no further: {why}")),
        End::TooLong => Some("the joint is longer than twice the nominal seam".to_owned()),
        End::Operator => Some(run.asked.last().cloned().unwrap_or_else(|| "the joint is lost".to_owned())),
    };
    let mut outcome = Outcome::of(&walk, &run, finding, None);
    outcome.truth = Some(truth(&actual, &outcome.smooth));
    Ok(outcome)
}

fn distortion(args: &TeachArgs) -> Result<Distortion, Failure> {
    let [shift_mm, turn_deg, bend_mm] = args.distortion[..] else {
        return Err(Failure::Input(
            "--distortion: not three numbers\n   allowed: SHIFT,TURN,BEND in mm, degrees, mm".to_owned(),
        ));
    };
    // Beyond them a part is not the one of the job.
    let allowed = [("shift", shift_mm, 20.0), ("turn", turn_deg, 10.0), ("bend", bend_mm, 20.0)];
    if let Some((what, value, most)) = allowed.into_iter().find(|(_, v, most)| !(0.0..=*most).contains(v)) {
        return Err(Failure::Input(format!("--distortion: {what} {value}\n   allowed: 0 to {most}")));
    }
    Ok(Distortion { shift_mm, turn: turn_deg.to_radians(), bend_mm })
}

fn tacks(args: &TeachArgs) -> Result<Vec<(f64, f64)>, Failure> {
    let tack = |text: &String| {
        let ends: Option<Vec<f64>> =
            text.split(',').map(|v| v.trim().parse().ok().filter(|v: &f64| v.is_finite())).collect();
        match ends.as_deref() {
            Some([from, to]) if from < to => Ok((*from, *to)),
            _ => {
                Err(Failure::Input(format!("--tack {text}\n   allowed: FROM,TO in mm along the seam, FROM before TO")))
            }
        }
    };
    args.tack.iter().map(tack).collect()
}
