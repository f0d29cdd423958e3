//! Teaching in simulation: the seed determines the seam, and the report has the true distance of the taught line from
//! it.

use super::session::Session;
use super::setup::start;
use crate::args::teach::TeachArgs;
use crate::refusals::{between, not_allowed, of_option};
use glam::DVec3;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_simulation::camera_simulator::{Appearance, CameraSimulator, Distortion};
use seamwright_simulation::teaching::{SimulatedRig, Truth, truth};
use seamwright_teaching::{Outcome, PlannedWeld, SeamLine};

/// Distance from the joint at which the simulated operator puts the cross, mm.
const BESIDE_MM: f64 = 0.3;
/// Usual seed, and how far parts are shifted (mm), turned (degrees) and bent (mm).
const SEED: u64 = 1;
const DISTORTION: [f64; 3] = [1.0, 0.3, 1.0];

pub(super) fn teach(args: &TeachArgs, loaded: &Loaded, nominal: &SeamLine) -> Result<(Outcome, Truth), Failure> {
    let session = Session::new(args, loaded, nominal)?;
    let (machine, sensor, seed) = (session.machine, session.sensor, args.seed.unwrap_or(SEED));
    let actual = distortion(args)?.of(nominal, seed);
    let mut appearance = Appearance { tacks: tacks(args)?, ..Appearance::default() };
    if args.no_height {
        appearance.height_error_mm = None;
    }
    let eye = CameraSimulator::new(machine, sensor, actual.clone(), appearance, seed);
    let eye = eye.ok_or_else(|| Failure::input(Message::new("cli-teach-not-a-camera").text("sensor", &sensor.name)))?;
    let (first, along) = actual.at(0.0);
    let begin = start(args, nominal, first.point + BESIDE_MM * first.normal.cross(along))?;
    let ground = PlannedWeld::new(&loaded.welding, &loaded.machine, &loaded.clamped, nominal)?;
    let guide = |point: DVec3| ground.guide(point);
    let carrier = ground.carrier(session.machine, session.sensor, &guide, ground.start());
    let outcome = session.crawl(begin, &mut SimulatedRig::new(carrier, eye))?;
    let truth = truth(&actual, &outcome.smooth);
    Ok((outcome, truth))
}

fn distortion(args: &TeachArgs) -> Result<Distortion, Failure> {
    let [shift_mm, turn_deg, bend_mm] = *args.distortion.as_deref().unwrap_or(&DISTORTION) else {
        let message = of_option("--distortion", Message::new("cli-teach-not-three-numbers"));
        return Err(Failure::refused(message, Message::new("cli-teach-distortion")));
    };
    // Beyond them a part is not the one of the job.
    let allowed =
        [("cli-teach-shift", shift_mm, 20.0), ("cli-teach-turn", turn_deg, 10.0), ("cli-teach-bend", bend_mm, 20.0)];
    if let Some((code, value, most)) = allowed.into_iter().find(|(_, v, most)| !(0.0..=*most).contains(v)) {
        let fault = Message::new(code).value("value", value, Unit::One);
        return Err(Failure::refused(of_option("--distortion", fault), between(0.0, most)));
    }
    Ok(Distortion { shift_mm, turn: turn_deg.to_radians(), bend_mm })
}

fn tacks(args: &TeachArgs) -> Result<Vec<(f64, f64)>, Failure> {
    let tack = |text: &String| {
        let ends: Option<Vec<f64>> =
            text.split(',').map(|v| v.trim().parse().ok().filter(|v: &f64| v.is_finite())).collect();
        match ends.as_deref() {
            Some([from, to]) if from < to => Ok((*from, *to)),
            _ => Err(not_allowed("--tack", text, Message::new("cli-teach-tack"))),
        }
    };
    args.tack.iter().map(tack).collect()
}
