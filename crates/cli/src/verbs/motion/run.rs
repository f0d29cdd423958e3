//! The motion as it runs under an operator's commands.

use super::commands::{Command, MIN_OVERRIDE, Timed};
use super::table::{Along, More, Row, Table};
use crate::args::MotionArgs;
use crate::refusals::{between, refused};
use seamwright_machine::Joints;
use seamwright_message::{Message, Unit};
use seamwright_motion::feed_override::{
    FeedOverride, FeedOverrideError, Instant, Order, Run, RunPhase, Timed as Moves, channel_limits,
};
use seamwright_motion::{PassMotion, SpeedProfile, Stage, WeldMotion};
use seamwright_program::{ArcTime, Finding, Pass, PathRange};
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use std::io::Write;

/// Maximum override; a speed profile of its own is planned for it if needed.
const FASTER: f64 = 1.5;
/// Longest time from where a run cannot go on until it rests with the process off, s.
const WIND_DOWN_S: f64 = 600.0;

/// Plays all stages under `commands`, one set-point every `period` s, and writes them.
pub(super) fn run(
    loaded: &Loaded,
    motion: &WeldMotion,
    commands: &[Timed],
    period: f64,
    args: &MotionArgs,
) -> Result<(), Failure> {
    let mut player = Player::new(loaded, commands, period, args.json);
    for stage in motion.stages(args.air) {
        match stage {
            Stage::Pass(i, pass) => player.pass(i, pass)?,
            Stage::Transfer(air) => {
                for k in 0..air.count(period) {
                    let Some((leg, t)) = air.leg(k as f64 * period) else { break };
                    player.wait_in_air();
                    let along = Along { pass: 0, s: f64::NAN, speed: f64::NAN, arc: None };
                    player.row(along, leg.at_time(t), "air")?;
                }
            }
        }
        if player.over {
            break;
        }
    }
    player.table.finish()
}

/// Refuses periods that no control runs at.
pub(super) fn check_period(period: f64) -> Result<(), Failure> {
    if !(0.00025..=0.004).contains(&period) {
        let fault = Message::new("cli-motion-period-with-commands");
        return Err(refused("--period-ms", period * 1e3, fault, between(0.25, 4.0)));
    }
    Ok(())
}

struct Player<'a> {
    loaded: &'a Loaded,
    /// Commands to come.
    commands: &'a [Timed],
    period: f64,
    /// Set-points written.
    count: u64,
    /// Part of the planned speed.
    feed_override: f64,
    /// Command that starts the next pass, if that does not wait.
    first: Option<Command>,
    /// This stage is the last.
    over: bool,
    /// Time since the arc went on, s.
    burning: f64,
    table: Table<'a>,
}

impl<'a> Player<'a> {
    fn new(loaded: &'a Loaded, commands: &'a [Timed], period: f64, json: bool) -> Self {
        Self {
            loaded,
            commands,
            period,
            count: 0,
            feed_override: 1.0,
            first: Some(Command::Resume),
            over: false,
            burning: 0.0,
            table: Table::new(loaded, More::Phase, json),
        }
    }

    /// The next command, if it is due before the next set-point.
    fn due(&mut self) -> Option<Command> {
        let (first, rest) = self.commands.split_first()?;
        if first.t > self.count as f64 * self.period * (1.0 + 1e-12) {
            return None;
        }
        self.commands = rest;
        match first.command {
            Command::Override(percent) => self.feed_override = percent / 100.0,
            Command::Abort => self.over = true,
            _ => {}
        }
        Some(first.command)
    }

    /// Commands during a transfer move: the move goes on to its end, the next pass waits or starts as commanded.
    fn wait_in_air(&mut self) {
        while let Some(command) = self.due() {
            match command {
                Command::Hold | Command::Reverse => self.first = None,
                Command::Resume | Command::Step(_) => self.first = Some(command),
                Command::Override(_) | Command::Abort => {}
            }
        }
    }

    /// Plays a pass until it has ended, or is held and no command is left.
    fn pass(&mut self, i: usize, motion: &PassMotion) -> Result<(), Failure> {
        let program = &self.loaded.welding.program.value;
        let faster = self.faster(motion, &program.passes[i]).map_err(|e| Failure::input(&e))?;
        let base = motion.timed(&self.loaded.machine);
        let faster = faster.as_ref().map(|profile| {
            seamwright_motion::feed_override::PassTimed::new(&self.loaded.machine, &motion.path, profile)
        });
        let stuck = |e: FeedOverrideError| Failure::Findings(vec![finding(&e, i + 1)]);
        let mut feed_override =
            FeedOverride::new(&channel_limits(&self.loaded.machine), self.period, &base).map_err(stuck)?;
        if let Some(profile) = &faster {
            feed_override = feed_override.with_faster(profile, FASTER).map_err(stuck)?;
        }
        let mut run = Run::new(feed_override, motion.sequence.clone(), &[]);
        run.order(Order::Override(self.feed_override)).map_err(stuck)?;
        let first = self.first.replace(Command::Resume);
        if let Some(first) = first.filter(|_| self.feed_override * 100.0 >= MIN_OVERRIDE) {
            run.order(order(first, 0.0, motion.path.length())).map_err(stuck)?;
        }
        loop {
            while let Some(command) = self.due() {
                let order = order(command, run.welded_to(), motion.path.length());
                run.order(order).map_err(stuck)?;
            }
            let now = run.now();
            self.instant(i + 1, motion, &now)?;
            let waits = now.phase == RunPhase::Held && self.commands.is_empty();
            if waits {
                held(i + 1, &now);
                self.over = true;
            }
            if waits || now.phase == RunPhase::Ended {
                return Ok(());
            }
            if let Err(reason) = run.step() {
                self.wind_down(i + 1, motion, &mut run)?;
                return Err(stuck(reason));
            }
        }
    }

    /// Writes a run that cannot go on until it rests with the process off, as it does by itself.
    fn wind_down<L: Moves>(&mut self, pass: usize, motion: &PassMotion, run: &mut Run<'_, L>) -> Result<(), Failure> {
        let most = (WIND_DOWN_S / self.period) as u64;
        for _ in 0..most {
            let now = run.now();
            self.instant(pass, motion, &now)?;
            if matches!(now.phase, RunPhase::Held | RunPhase::Ended) {
                break;
            }
            // The error has been reported already.
            run.step().ok();
        }
        Ok(())
    }

    /// The speed profile for overrides above 100 %, if one comes or is in force.
    fn faster(
        &self,
        motion: &PassMotion,
        pass: &Pass,
    ) -> Result<Option<SpeedProfile>, seamwright_motion::speed_profile::SpeedProfileError> {
        let above = |c: &Timed| matches!(c.command, Command::Override(percent) if percent > 100.0);
        let wanted = self.feed_override > 1.0 || self.commands.iter().any(above);
        wanted.then(|| motion.faster(&self.loaded.machine, pass, FASTER)).transpose()
    }

    fn instant(&mut self, pass: usize, motion: &PassMotion, now: &Instant) -> Result<(), Failure> {
        let r = &now.played.rates;
        let until_off_s = if now.phase == RunPhase::Crater { now.left_s } else { f64::INFINITY };
        let arc = now.phase.arc().then_some(ArcTime { since_on_s: self.burning, until_off_s });
        self.burning = arc.map_or(0.0, |arc| arc.since_on_s + self.period);
        let speed = r.tip.v * motion.path.tip_rate(&self.loaded.machine, r.tip.s);
        self.row(Along { pass, s: r.tip.s, speed, arc }, r.q, now.phase.name())
    }

    fn row(&mut self, along: Along, q: Joints, phase: &'static str) -> Result<(), Failure> {
        let t = self.count as f64 * self.period;
        self.count += 1;
        self.table.row(&Row { t, along, q, speeds: None, phase: Some(phase) })
    }
}

/// The order of a command when the seam is welded up to a path length.
fn order(command: Command, welded: f64, length: f64) -> Order {
    match command {
        Command::Override(percent) => Order::Override(percent / 100.0),
        Command::Hold => Order::Hold,
        Command::Resume => Order::Resume,
        Command::Reverse => Order::Reverse,
        Command::Step(mm) if welded + mm < length => Order::StepTo(welded + mm),
        Command::Step(_) => Order::Resume,
        Command::Abort => Order::Abort,
    }
}

/// Reports on standard error where the run waits; errors are ignored.
fn held(pass: usize, now: &Instant) {
    let s = now.played.rates.tip.s;
    let note = Message::new("cli-motion-held").pass("pass", pass).quantity("at", s, Unit::Mm, 3);
    let _ = writeln!(std::io::stderr().lock(), "{note}");
}

fn finding(error: &FeedOverrideError, pass: usize) -> Finding {
    let s = if let FeedOverrideError::Stuck { s } = error { *s } else { 0.0 };
    Finding::error("pace", error.message(), pass, PathRange::at(s), Message::new("cli-cure-commands-or-speed"))
}
