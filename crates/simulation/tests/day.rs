//! A day of welds in virtual time: constant memory, welds without drift.

#![cfg(target_os = "linux")]

mod common;

use common::{SADDLE, Tracked};
use seamwright_executive::{Ask, Command, Cycle, Executive, Mode, Note, Place, Port, Reaction, Start};
use seamwright_simulation::Judge;

/// Current memory of this process, kB.
fn memory_kb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|l| l.starts_with("VmRSS:")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse().unwrap()
}

/// Result of a weld.
#[derive(Debug, Clone, Copy)]
struct Made {
    /// Maximum distance of weld and joint from 10 mm on, mm.
    miss_mm: f64,
    /// Travelled path length, mm.
    end_mm: f64,
    /// Time from the first order of the arc to its end, s.
    took_s: f64,
}

/// Welds repeatedly until the time is over.
struct Shift<'a> {
    judge: Judge<'a>,
    until_s: f64,
    mode: Mode,
    armed: bool,
    powered: bool,
    asked: bool,
    begun: Option<f64>,
    now: Made,
    made: Vec<Made>,
    /// Memory after the first hour, and at the end, kB.
    memory: [u64; 2],
}

impl Port for Shift<'_> {
    fn command(&mut self, t: f64) -> Option<Command> {
        if std::mem::replace(&mut self.asked, true) {
            return None;
        }
        let over = t > self.until_s;
        let ask = match self.mode {
            Mode::Off if over => Ask::Quit,
            Mode::Off => Ask::SwitchOn,
            Mode::Idle if self.powered => Ask::Home,
            Mode::Ready if over => Ask::SwitchOff,
            Mode::Ready if !self.armed => Ask::Arm,
            Mode::Ready => Ask::StartWeld,
            Mode::Hold | Mode::Fault => panic!("{:?} at {t} s, weld {}", self.mode, self.made.len() + 1),
            _ => return None,
        };
        Some(Command::of(ask))
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.asked = false;
        (self.mode, self.armed, self.powered) = (cycle.mode, cycle.armed, cycle.reports.drives.powered);
        let sample = self.judge.sample(cycle);
        if sample.arc() && sample.pass > 0 {
            self.begun.get_or_insert(cycle.t);
            self.now.end_mm = sample.set.profile.s;
            self.now.took_s = cycle.t - self.begun.unwrap();
            if let Some(head) = sample.heads[0].filter(|_| sample.set.profile.s > 10.0) {
                self.now.miss_mm = self.now.miss_mm.max(head.miss.length());
            }
        } else if cycle.mode == Mode::Ready && self.begun.take().is_some() {
            self.made.push(std::mem::replace(&mut self.now, Made { miss_mm: 0.0, end_mm: 0.0, took_s: 0.0 }));
            self.memory[usize::from(cycle.t > 3600.0)] = memory_kb();
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        if let Note::Alarm(raised) = note {
            assert!(raised.reaction < Reaction::Hold, "{raised:?} at {t} s, weld {}", self.made.len() + 1);
        }
    }
}

#[test]
#[ignore = "24 hours of cell; make soak"]
fn a_day_of_tracked_welds() {
    let tracked = Tracked::new(&SADDLE.replace("overlap_mm = 20", "end_phi_deg = 120"));
    let cell = tracked.cell();
    let work = cell.work(Start::at_home(&tracked.planned.motion)).unwrap();
    let mut devices = cell.devices().unwrap();
    let mut tracking = cell.tracking(Place::default()).unwrap();
    let mut shift = Shift {
        judge: cell.judge().unwrap(),
        until_s: 24.0 * 3600.0,
        mode: Mode::Off,
        armed: false,
        powered: false,
        asked: false,
        begun: None,
        now: Made { miss_mm: 0.0, end_mm: 0.0, took_s: 0.0 },
        made: Vec::new(),
        memory: [0; 2],
    };
    let guide = tracking.as_mut().map(|tracking| tracking as _);
    Executive::new(&tracked.planned.machine, &mut devices, &mut shift).with_guide(guide).serve(Some(&work));
    let (made, [hour, day]) = (&shift.made, shift.memory);
    let miss = |welds: &[Made]| welds.iter().map(|m| m.miss_mm).fold(0.0, f64::max);
    let (first, last) = made.split_at(made.len() / 2);
    println!(
        "{} welds; most off the joint {:.3} mm in the first half, {:.3} mm in the second; {hour} kB after an hour, {day} kB at the end",
        made.len(),
        miss(first),
        miss(last)
    );
    assert!(made.len() > 500, "{}", made.len());
    // Noise of the sensor differs from weld to weld: the bound is that of a single weld.
    assert!(miss(made) < 0.12, "{}", miss(made));
    // Time and path length follow the plan in the last weld as in the first.
    assert!(made.iter().all(|m| (m.end_mm - made[0].end_mm).abs() < 1e-6), "{made:?}");
    assert!(made.iter().all(|m| (m.took_s - made[0].took_s).abs() < 0.5), "{made:?}");
    assert!(day <= hour + 1024, "{hour} kB, {day} kB");
}
