//! Waits between passes: for a time, or until the weld has cooled below the maximum interpass temperature.

use crate::pass_heat::{PassHeat, thickness_mm};
use crate::pass_time::MAX_PASS_S;
use crate::weld_motion::WeldMotion;
use seamwright_geometry::numeric::bisect;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Interpass, Pass, PathRange, Program, Role};

/// Distance of places along a pass at which the weld must have cooled, mm: less than an overlap, which is heated twice.
const STEP_MM: f64 = 5.0;
/// Minimum and maximum number of these places.
const PLACES: (usize, usize) = (24, 500);
/// A pass is over another one if it has more than this part of its places; fewer are a tie-in.
const TIE_IN: f64 = 0.12;
/// Halvings of the time in which a wait is sought: from days to a fraction of a second.
const HALVINGS: u32 = 20;
/// Waits are rounded up to this, s.
const STEP_S: f64 = 1.0;

impl WeldMotion {
    /// Preheat and cooling time of each pass by EN 1011-2; `None` where materials, power or thickness are unknown.
    pub fn heat(&self, program: &Program) -> Vec<Option<PassHeat>> {
        let held = (1..).zip(&self.procedure);
        held.map(|(number, held)| PassHeat::new(program, number, held)).collect()
    }

    /// Adds the waits of `[interpass]` and the findings about preheat and cooling. Call it after
    /// [`WeldMotion::hold_to`], from which the heat input comes. `period` is the length of a seam welded all round, mm.
    pub fn cool(&mut self, program: &Program, period: Option<f64>) {
        for (number, heat) in (1..).zip(self.heat(program)) {
            self.findings.extend(heat.iter().flat_map(|heat| heat.findings(program, number)));
        }
        if let Some(interpass) = &program.interpass {
            self.wait_between(program, interpass, period);
        }
    }

    fn wait_between(&mut self, program: &Program, interpass: &Interpass, period: Option<f64>) {
        let thickness = thickness_mm(program.materials.as_ref(), program.joint.as_ref());
        let mut now = 0.0;
        let mut starts = Vec::new();
        for (i, pass) in program.passes.iter().enumerate() {
            now += self.transfers[i].duration();
            let weld = Weld { motion: self, program, starts: &starts, period };
            let wait = match (interpass.wait_s, interpass.below_c.zip(thickness)) {
                (Some(wait), _) => Ok(weld.time_left(i, now, wait.get())),
                (None, Some((below, thickness))) => {
                    let plate = Plate { interpass, thickness, below_c: below.get() };
                    weld.cooling_left(i, now, plate)
                }
                (None, None) => Err("motion-interpass-thickness"),
            };
            let whole = PathRange::up_to(pass.length());
            match wait {
                Ok(wait) if wait > 0.0 => {
                    let wait = (wait / STEP_S).ceil() * STEP_S;
                    self.transfers[i].rest(&self.passes[i].path.at(0.0), wait);
                    now += wait;
                    let message = Message::new("motion-interpass-wait").quantity("time", wait, Unit::S, 0);
                    self.findings.push(Finding::note("interpass", message, i + 1, PathRange::at(0.0)));
                }
                Ok(_) => {}
                Err(code) => {
                    let cure = Message::new("motion-cure-interpass");
                    self.findings.push(Finding::error("interpass", Message::new(code), i + 1, whole, cure));
                    return;
                }
            }
            starts.push(now);
            now += self.passes[i].total_s();
        }
    }
}

/// The passes before one, each with the time at which it starts, s.
struct Weld<'a> {
    motion: &'a WeldMotion,
    program: &'a Program,
    starts: &'a [f64],
    period: Option<f64>,
}

/// A plate that cools.
#[derive(Clone, Copy)]
struct Plate<'a> {
    interpass: &'a Interpass,
    thickness: f64,
    below_c: f64,
}

/// An arc that went over a place: heat input, kJ/mm, and time, s.
struct Passage {
    heat: f64,
    at: f64,
}

impl Weld<'_> {
    /// Earlier passes on the same copy of the seam, without tacks; by index.
    fn earlier(&self, i: usize) -> impl Iterator<Item = (usize, &Pass)> {
        let copy = self.program.passes[i].copy;
        let passes = self.program.passes.iter().enumerate().take(i);
        passes.filter(move |(_, pass)| pass.copy == copy && pass.has_arc() && pass.known_role() != Some(Role::Tack))
    }

    /// Time still to wait before pass `i`, which could start at `now`, s.
    fn time_left(&self, i: usize, now: f64, wait: f64) -> f64 {
        let places: Vec<f64> = places(&self.program.passes[i]).collect();
        let shared = |pass: &Pass| places.iter().filter(|x| self.is_on(pass, **x)).count() as f64;
        let over = self.earlier(i).filter(|(_, pass)| shared(pass) > TIE_IN * places.len() as f64);
        let end = |k: usize| self.starts[k] + self.motion.passes[k].total_s();
        over.map(|(k, _)| wait - (now - end(k))).fold(0.0, f64::max)
    }

    /// Time still to wait until every place of pass `i` is cool when its arc comes, s. Fails with the code of a reason.
    fn cooling_left(&self, i: usize, now: f64, plate: Plate) -> Result<f64, &'static str> {
        let (pass, motion) = (&self.program.passes[i], &self.motion.passes[i]);
        let mut hot: Vec<(f64, Vec<Passage>)> = Vec::new();
        for place in places(pass) {
            let mut passages = Vec::new();
            for (k, earlier) in self.earlier(i) {
                for s in self.own(earlier, place) {
                    let heat = self.heat(k, s).ok_or("motion-interpass-power")?;
                    passages.push(Passage { heat, at: self.arrival(k, self.starts[k], s) });
                }
            }
            let own = (place - pass.begin_mm.get()).abs();
            hot.push((self.arrival(i, now, own.min(motion.path.length())), passages));
        }
        let is_cool = |wait: f64| {
            hot.iter().all(|(arrival, passages)| {
                let rise = |p: &Passage| plate.interpass.rise_k(p.heat, plate.thickness, arrival + wait - p.at);
                plate.interpass.work_c.get() + passages.iter().map(rise).sum::<f64>() <= plate.below_c
            })
        };
        if is_cool(0.0) {
            return Ok(0.0);
        }
        if !is_cool(MAX_PASS_S) {
            return Err("motion-interpass-never");
        }
        Ok(bisect(MAX_PASS_S, 0.0, HALVINGS, is_cool).0)
    }

    /// Time at which the arc of pass `k`, which starts at `start`, is at its own path length `s`.
    fn arrival(&self, k: usize, start: f64, s: f64) -> f64 {
        let motion = &self.motion.passes[k];
        start + motion.before_s() + motion.profile.time(s)
    }

    /// Heat input of pass `k` at its own path length `s`, kJ/mm: in acceleration and deceleration phase that beside it.
    fn heat(&self, k: usize, s: f64) -> Option<f64> {
        let curve = &self.motion.procedure.get(k)?.heat_input;
        let i = curve.partition_point(|(at, _)| *at < s).min(curve.len().checked_sub(1)?);
        // A stop with the arc on is at a point; around it the heat input is finite.
        let finite = |(_, heat): &&(f64, f64)| heat.is_finite();
        curve[i..].iter().find(finite).or_else(|| curve[..i].iter().rev().find(finite)).map(|(_, heat)| *heat)
    }

    fn is_on(&self, pass: &Pass, place: f64) -> bool {
        self.own(pass, place).next().is_some()
    }

    /// Path lengths of the pass itself at a place of the seam; several where it overlaps itself.
    fn own(&self, pass: &Pass, place: f64) -> impl Iterator<Item = f64> {
        let (begin, length, period) = (pass.begin_mm.get(), pass.length(), self.period);
        let along = if pass.reverse { begin - place } else { place - begin };
        let turns = if period.is_some() { -2..=2 } else { 0..=0 };
        let on = turns.map(move |turn| along + f64::from(turn) * period.unwrap_or_default());
        on.filter(move |s| (0.0..=length).contains(s))
    }
}

/// Places of a pass along the seam, mm.
fn places(pass: &Pass) -> impl Iterator<Item = f64> {
    let count = ((pass.length() / STEP_MM) as usize).clamp(PLACES.0, PLACES.1);
    (0..=count).map(move |k| pass.seam_s(pass.length() * k as f64 / count as f64))
}
