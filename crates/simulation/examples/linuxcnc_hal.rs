//! A job welded on drives by LinuxCNC's HAL without hardware, in real time, with HAL's state for every set-point.
//!
//! A correction comes every few seconds: a step of one axis, like that of a tracker after a shift of the joint. Prints
//! HAL's underruns of set-points, the deviation of its joints from the orders, and the delay of the orders. Fails if
//! they exceed the stated limits.
//!
//! Usage: linuxcnc_hal JOB [STORE]

#[cfg(not(target_os = "linux"))]
fn main() {}

#[cfg(target_os = "linux")]
fn main() -> std::process::ExitCode {
    linux::main()
}

#[cfg(target_os = "linux")]
mod linux {
    use seamwright_executive::devices::{DeviceSet, Drives, LinuxCncDrives, LinuxCncError, Taken};
    use seamwright_executive::realtime::{Paced, Pacer, RealtimeRights, SteadyTime};
    use seamwright_executive::{
        Alarm, Command, Cycle, DriveReport, Executive, Mode, Note, Orders, Port, Slack, Start, Work,
    };
    use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
    use seamwright_motion::WeldMotion;
    use seamwright_program::{Pass, TorchPath};
    use seamwright_simulation::WeldOperator;
    use seamwright_simulation::devices::{Device, Faulty, SimulatedInputs, SimulatedSource};
    use seamwright_weld::Welding;
    use std::path::Path;
    use std::process::ExitCode;
    use std::time::{Duration, Instant};

    /// Cycles between corrections, their axis and size, mm or rad.
    const EVERY: u64 = 3000;
    const CORRECTED: usize = 1;
    const CORRECTION: f64 = 0.25;
    /// Tolerance for HAL's six decimals, mm or degrees.
    const SAME: f64 = 1e-6;
    /// Time of a line through two pipes, and of HAL's own jitter, periods.
    const PIPES: f64 = 2.0;

    /// Drives with added corrections.
    struct Corrected<D> {
        drives: D,
        cycles: u64,
        by: f64,
        /// Time of each correction, and the resulting axis position.
        steps: Vec<(SteadyTime, f64)>,
        starved: u32,
    }

    impl<D: Drives> Drives for Corrected<D> {
        fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
            self.cycles += 1;
            let mut orders = *orders;
            let corrects = orders.power && self.cycles.is_multiple_of(EVERY);
            if corrects {
                self.by = CORRECTION - self.by;
            }
            orders.set[CORRECTED].position += self.by;
            if corrects {
                self.steps.push((SteadyTime::now(), orders.set[CORRECTED].position));
            }
            self.drives.exchange(&orders, report);
            // Remove the correction: the executive follows its own plan.
            report.position[CORRECTED] -= self.by;
            self.starved = report.starved;
        }

        fn rides_out(&self) -> Slack {
            self.drives.rides_out()
        }

        fn late_s(&self) -> f64 {
            self.drives.late_s()
        }
    }

    /// Welds once; keeps all samples of HAL.
    struct Operator {
        operator: WeldOperator,
        mode: Mode,
        welded: bool,
        alarms: Vec<Alarm>,
        missed: u32,
        tap: rtrb::Consumer<Taken>,
        taken: Vec<Taken>,
    }

    impl Port for Operator {
        fn command(&mut self, t: f64) -> Option<Command> {
            self.operator.command(t)
        }

        fn show(&mut self, cycle: &Cycle<'_>) {
            self.operator.show(cycle);
            self.welded |= self.mode == Mode::Weld && cycle.mode == Mode::Ready;
            self.mode = cycle.mode;
            self.missed += cycle.reports.missed;
            while let Ok(taken) = self.tap.pop() {
                self.taken.push(taken);
            }
        }

        fn note(&mut self, t: f64, note: Note) {
            self.operator.note(t, note);
            if let Note::Alarm(raised) = note {
                self.alarms.push(raised.alarm);
            }
        }
    }

    pub(super) fn main() -> ExitCode {
        let mut args = std::env::args().skip(1);
        let (Some(job), store) = (args.next(), args.next()) else {
            eprintln!("usage: linuxcnc_hal JOB [STORE]");
            return ExitCode::from(2);
        };
        match run(&job, store.as_deref().unwrap_or("10")) {
            Ok(true) => ExitCode::SUCCESS,
            Ok(false) => ExitCode::FAILURE,
            Err(error) => match error.downcast_ref() {
                Some(why @ (LinuxCncError::NotInstalled(_) | LinuxCncError::Running(_))) => {
                    eprintln!("SKIPPED: no job was streamed into LinuxCNC's HAL: {why}");
                    ExitCode::SUCCESS
                }
                _ => {
                    eprintln!("error: {error}");
                    ExitCode::from(3)
                }
            },
        }
    }

    fn run(job: &str, store: &str) -> Result<bool, Box<dyn std::error::Error>> {
        let welding = Welding::read(job, &std::fs::read_to_string(job)?)?;
        let program = &welding.program.value;
        let text = shipped(&program.machine).ok_or("the job's machine does not ship")?.text;
        let text = format!("{text}\n[devices.drives.linuxcnc]\nstore = {store}");
        let machine = Machine::read(&program.machine, &text)?;
        let device = machine.devices.linuxcnc.clone().ok_or("no drives")?;
        let around = Surroundings::new(&machine, &Clamped::default())?;
        let path = welding.path(0);
        let passes: Vec<(&dyn TorchPath, &Pass)> = vec![(&path, &program.passes[0])];
        let motion = WeldMotion::plan(&machine, &around, &passes, 30.0).map_err(|e| format!("{e:?}"))?;
        let passes: Vec<&Pass> = program.passes.iter().collect();
        let work = Work::new(&machine, None, &passes, &motion, Start::at_home(&motion)).map_err(|n| format!("{n}"))?;
        let period = machine.servo_period_s;
        let begun = Instant::now();
        let mut drives = LinuxCncDrives::start(&machine, &device, Path::new("."), |text| eprintln!("note: {text}"))?;
        let started = begun.elapsed();
        let tap = drives.tap(4096);
        let drives = Faulty::new(drives, Device::Drives, &[], period);
        let devices = DeviceSet {
            drives: Corrected { drives, cycles: 0, by: 0.0, steps: Vec::with_capacity(1000), starved: 0 },
            source: SimulatedSource::new(1, period),
            inputs: SimulatedInputs::all_met(&machine),
        };
        let footing = RealtimeRights::ask(None);
        let mut operator = Operator {
            operator: WeldOperator::default(),
            mode: Mode::Off,
            welded: false,
            alarms: Vec::with_capacity(64),
            missed: 0,
            tap,
            taken: Vec::with_capacity(1_000_000),
        };
        let mut paced = Paced::new(devices, &machine, Pacer::new(period));
        Executive::new(&machine, &mut paced, &mut operator).serve(Some(&work));
        let late = paced.pacer.latency().clone();
        println!(
            "{} axes at {} ms, {store} in store; {footing}; HAL started in {:.2} s",
            machine.axes.len(),
            1e3 * period,
            started.as_secs_f64()
        );
        println!(
            "cycle: {} cycles, late by {:.0} us in the median, {:.0} us in 99.9 %, {:.0} us at most; {} missed",
            late.count(),
            late.quantile_us(0.5),
            late.quantile_us(0.999),
            late.most_us(),
            late.missed()
        );
        let Corrected { steps, starved, .. } = &paced.devices.drives;
        Ok(judge(&machine, device.store, &operator, steps, *starved) && operator.welded)
    }

    /// Prints and evaluates the samples of HAL.
    fn judge(machine: &Machine, store: u32, operator: &Operator, steps: &[(SteadyTime, f64)], starved: u32) -> bool {
        let taken = &operator.taken;
        let period = Duration::from_secs_f64(machine.servo_period_s);
        let gaps = taken.windows(2).filter(|w| w[1].sample.number > w[0].sample.number + 1).count();
        let ordered: Vec<&Taken> = taken.iter().filter(|t| t.sample.number > 0 && t.sample.powered).collect();
        // During homing the axes do not follow set-points.
        let after = ordered.iter().position(|t| t.sample.homed.count_ones() as usize == machine.axes.len());
        let followed = &ordered[(after.unwrap_or(0) + 500).min(ordered.len())..];
        let worst = followed.iter().flat_map(|t| {
            let axes = machine.axes.iter().enumerate();
            axes.map(|(i, axis)| (axis.to_file(t.set[i]) - axis.to_file(t.sample.position[i])).abs())
        });
        let worst = worst.fold(0.0, f64::max);
        // HAL's periods lie on a grid of the same clock: the sample read with the least delay marks its start.
        let early = taken.iter().enumerate().map(|(k, t)| (taken[0].read() + period * k as u32).since(t.read()));
        let begin = taken[0].read() - early.max().unwrap_or_default();
        let at = |k: usize| begin + period * k as u32;
        let first = taken.iter().position(|t| t.sample.number > store + 1).unwrap_or(0);
        let mut delays: Vec<f64> = taken.iter().enumerate().skip(first).map(|(k, t)| ms(at(k), t.ordered)).collect();
        delays.sort_by(f64::total_cmp);
        let part = |part: f64| delays[((delays.len() - 1) as f64 * part) as usize];
        println!(
            "HAL: {} periods, {} without a set-point while it had power, {gaps} not seen; joints at most {worst:.1e} mm or degrees from what was ordered",
            taken.len(),
            starved
        );
        println!(
            "order to joint: {:.2} ms in the median, {:.2} in 99.9 %, {:.2} at most",
            part(0.5),
            part(0.999),
            part(1.0)
        );
        let mut applied = Vec::new();
        let mut seen = Vec::new();
        for (when, position) in steps {
            let next = taken.iter().enumerate().filter(|(_, t)| t.ordered >= *when && t.sample.powered);
            let there = |q: f64| (q - position).abs() < CORRECTION / 2.0;
            // While the store refills, a step may lie between two set-points.
            let found = next.take(3).find(|(_, t)| there(t.set[CORRECTED]) && there(t.sample.position[CORRECTED]));
            if let Some((k, t)) = found {
                applied.push(ms(at(k), *when));
                seen.push(ms(t.read(), *when));
            }
        }
        let most = |all: &[f64]| all.iter().fold(0.0f64, |a, b| a.max(*b));
        let stated = (f64::from(store) + PIPES) * 1e3 * machine.servo_period_s;
        println!(
            "corrections: {} of {} at the joint after at most {:.2} ms ({stated} ms stated), seen by us after at most {:.2} ms",
            applied.len(),
            steps.len(),
            most(&applied),
            most(&seen)
        );
        if !operator.alarms.is_empty() {
            println!("alarms: {:?}", operator.alarms);
        }
        starved == 0 && gaps == 0 && worst < SAME && applied.len() == steps.len() && most(&applied) <= stated
    }

    /// Returns the time from `then` to `now`, ms.
    fn ms(now: SteadyTime, then: SteadyTime) -> f64 {
        1e3 * now.since(then).as_secs_f64()
    }

    trait Read {
        fn read(&self) -> SteadyTime;
    }

    impl Read for Taken {
        fn read(&self) -> SteadyTime {
            self.sample.read
        }
    }
}
