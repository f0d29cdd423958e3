use crate::attitude::Attitude;
use crate::bead_path::BeadPath;
use crate::beads::{BeadPlan, WeldValues};
use crate::job::Job;
use crate::joint::SeamJoint;
use crate::outside_data::{NoFiles, Outside, fetch, forget};
use crate::pass_keys::PassKeys;
use crate::pass_path::PassPath;
use crate::points::PointPath;
use crate::seam::SeamCurve;
use crate::stretch::Stretch;
use crate::tube_cut::Cut;
use crate::weld_path::WeldPath;
use crate::{body, order, procedure, stick_out};
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, MAX_TRAVEL_S, Pass, PathRange, Program, Role, Seam, Torch, Weaving};
use std::sync::Arc;

/// A weld read from a job or a program file: the program, the seam, and the torch angles along it.
#[derive(Debug)]
pub struct Welding {
    /// The program, at the address of the file it came from, each pass as often as it is welded.
    pub program: Document<Program>,
    /// The seam by path length from the start of the weld; `None` if all passes go through points.
    pub seam: Option<SeamCurve>,
    lines: Vec<Arc<PassLine>>,
    /// Keys of each pass' values in the file.
    keys: Vec<PassKeys>,
    /// The joint along the seam, if the file has one.
    pub joint: Option<SeamJoint>,
    /// Plan of the beads that fill it, if any: from a job, not from a program.
    pub plan: Option<BeadPlan>,
    /// Findings against the plan.
    plan_findings: Vec<Finding>,
    /// Stick-out of the machine's torch, mm, if a pass needs it.
    machine_stick_out: Option<f64>,
    /// The end of the branch or nozzle as it is cut, if the file has the data for it.
    pub cut: Option<Cut>,
}

impl Welding {
    /// Reads a job file that names no other files, or a program file (one with `passes`).
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        Self::read_with(file, text, &NoFiles)
    }

    /// The same for one that names tables of points, recorded axis positions or a procedure file; the program holds
    /// these itself.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read_with(file: &str, text: &str, outside: &dyn Outside) -> Result<Self, DocumentError> {
        let mut welding = if Program::is_in(text) {
            let mut program = Program::read(file, text)?;
            let (mut seam, mut taught) = (program.value.seam.clone(), program.value.taught.clone());
            let frame = program.value.seam_in_work();
            fetch(&program, seam.as_mut(), &mut taught, &program.value.machine, frame, outside)?;
            (program.value.seam, program.value.taught) = (seam, taught);
            Self::from_program(&program, outside)?
        } else {
            let mut job = Job::read(file, text)?;
            let (mut seam, mut taught) = (job.value.seam.clone(), job.value.taught.clone());
            fetch(&job, Some(&mut seam), &mut taught, &job.value.machine, job.value.seam_in_work(), outside)?;
            (job.value.seam, job.value.taught) = (seam, taught);
            Self::from_job(&job, outside)?
        };
        let value = &mut welding.program.value;
        forget(&mut value.seam, &mut value.taught);
        Ok(welding)
    }

    fn from_job(job: &Document<Job>, outside: &dyn Outside) -> Result<Self, DocumentError> {
        let j = &job.value;
        let seam = SeamCurve::with_taught(job, &j.seam, &j.start, &j.taught)?;
        let mut program = Job::program(job, &seam)?;
        let joint = j.joint.as_ref().map(|joint| SeamJoint::new(job, joint, &seam)).transpose()?;
        let weld = program.passes[0].clone();
        let procedure = procedure::of_job(job, outside)?;
        let (mut plan, mut plan_findings) = (None, Vec::new());
        if let (Some(beads), Some(joint)) = (&j.beads, &joint) {
            let values = WeldValues {
                speed_mm_s: j.weld.speed_mm_s,
                process: &j.weld.process,
                procedure: procedure.as_ref().map(|p| &p.value),
                weave: j.weld.weave.as_ref(),
                insert_mm2: joint.joint().insert.map_or(0.0, |insert| insert.area_mm2()),
            };
            let filled = beads.filled(job, &seam, joint, &values, &weld)?;
            program.passes = filled.passes;
            (plan, plan_findings) = (Some(filled.plan), filled.findings);
        }
        if let Some(cosmetic) = &j.cosmetic {
            program.passes.push(cosmetic.pass(job, &seam, &weld)?);
        }
        let ordered = order::ordered(job, &seam, &program.passes, &weld, &program.copies)?;
        for finding in &mut plan_findings {
            // A finding against a bead is reported at the first pass that lays it there.
            let bead = finding.pass.checked_sub(1);
            let laid = ordered.iter().enumerate().filter(|(_, (_, from))| *from == bead);
            at_first_pass(finding, laid.map(|(i, (pass, _))| (i, pass)), &seam);
        }
        program.passes = ordered.into_iter().map(|(pass, _)| pass).collect();
        plan_findings.extend(joint_findings(job, joint.as_ref(), &seam, &j.seam, &program.passes));
        for pass in &program.passes {
            // Only here: quarters that go on over the start of the weld may bring speeds together that did not meet.
            match (&j.beads, &pass.weave) {
                (Some(beads), _) => beads.check_weave(job, pass)?,
                (None, Some(weave)) => {
                    weave.check_speeds(job, "weld.weave", &pass.spans, |_| "weld.speed_mm_s".to_owned())?;
                }
                (None, None) => {}
            }
        }
        let cut = Cut::new(job, &j.seam)?;
        if let Some(procedure) = procedure {
            procedure.value.check_passes(&procedure, "", &program.passes)?;
            program.procedure = Some(procedure.value);
        }
        let program = job.with(program);
        let keys: Vec<PassKeys> = program.value.passes.iter().map(|pass| PassKeys::derived(j, pass)).collect();
        let machine_stick_out = stick_out::of_machine(&program, outside)?;
        let lines = pass_lines(&program, Some(&seam), &keys, machine_stick_out, outside)?;
        let lines = lines.into_iter().map(Arc::new).collect();
        Ok(Self { program, seam: Some(seam), lines, keys, joint, plan, plan_findings, machine_stick_out, cut })
    }

    fn from_program(program: &Document<Program>, outside: &dyn Outside) -> Result<Self, DocumentError> {
        let p = &program.value;
        let seam =
            p.seam.as_ref().map(|seam| SeamCurve::with_taught(program, seam, &p.start, &p.taught)).transpose()?;
        let keys: Vec<PassKeys> = (0..p.passes.len()).map(PassKeys::listed).collect();
        let machine_stick_out = stick_out::of_machine(program, outside)?;
        let lines = pass_lines(program, seam.as_ref(), &keys, machine_stick_out, outside)?;
        let joint = match (&p.joint, &seam) {
            (Some(joint), Some(seam)) => Some(SeamJoint::new(program, joint, seam)?),
            _ => None,
        };
        let cut = p.seam.as_ref().map_or(Ok(None), |seam| Cut::new(program, seam))?;
        let plan_findings = match (&seam, &p.seam) {
            (Some(curve), Some(seam)) => joint_findings(program, joint.as_ref(), curve, seam, &p.passes),
            _ => Vec::new(),
        };
        // The lines of the passes in the order of the file, so that errors have their addresses; then a line for each
        // time a pass is welded.
        let times = || p.passes.iter().map(|pass| usize::from(pass.repeat.get()));
        let lines: Vec<Arc<PassLine>> =
            lines.into_iter().map(Arc::new).zip(times()).flat_map(|(line, n)| std::iter::repeat_n(line, n)).collect();
        let keys = keys.into_iter().zip(times()).flat_map(|(keys, n)| std::iter::repeat_n(keys, n)).collect();
        let mut value = program.value.expanded();
        for (pass, line) in value.passes.iter_mut().zip(&lines) {
            if let PassLine::Points(points) = line.as_ref() {
                pass.spans = points.spans().to_vec();
            }
        }
        let program = program.with(value);
        Ok(Self { program, seam, lines, keys, joint, plan: None, plan_findings, machine_stick_out, cut })
    }

    /// The same with other torch angles in pass `pass`, counted from 0.
    ///
    /// # Errors
    /// With the key's address: angles out of range.
    pub fn with_torch(mut self, pass: usize, torch: Torch) -> Result<Self, DocumentError> {
        let (Some(seam), PassLine::Seam(line)) = (&self.seam, self.lines[pass].as_ref()) else { return Ok(self) };
        let key = self.keys[pass].of("torch");
        let attitude = Attitude::new(&self.program, &key, &torch, seam)?;
        let drawn_back = stick_out::drawn_back(&self.program, &key, &torch, self.machine_stick_out)?;
        let line = SeamLine { stretch: line.stretch, attitude, bead: line.bead.clone(), drawn_back };
        self.lines[pass] = Arc::new(PassLine::Seam(Box::new(line)));
        self.program.value.passes[pass].torch = torch;
        Ok(self)
    }

    /// The torch's path in pass `pass`, counted from 0, in the machine's work frame.
    pub fn path(&self, pass: usize) -> WeldPath<'_> {
        match (self.lines[pass].as_ref(), &self.seam) {
            (PassLine::Points(points), _) => WeldPath::Points(points),
            (PassLine::Seam(line), Some(seam)) => WeldPath::Seam(Box::new(PassPath {
                seam,
                joint: self.joint.as_ref(),
                stretch: line.stretch,
                attitude: line.attitude.clone(),
                bead: line.bead.as_ref(),
                weaving: Weaving::new(&self.program.value.passes[pass]),
                drawn_back: line.drawn_back,
                placement: self.program.value.copy_in_work(self.program.value.passes[pass].copy),
            })),
            // Reading a program refuses it.
            (PassLine::Seam(_), None) => unreachable!("a pass along a seam has one"),
        }
    }

    /// Work angle (offset from the bisector of the faces, towards the first part) and travel angle of the torch, rad.
    /// They are at path length `s` (mm) of the seam, in passes of this role, without the bead's addition to the work
    /// angle. `None` without such a pass along the seam.
    pub fn torch_angles(&self, role: Option<Role>, s: f64) -> Option<(f64, f64)> {
        let passes = self.program.value.passes.iter().zip(&self.lines);
        let line = passes.filter(|(pass, _)| pass.role == role).find_map(|(_, line)| match line.as_ref() {
            PassLine::Seam(line) => Some(line),
            PassLine::Points(_) => None,
        })?;
        Some(line.attitude.angles(s))
    }

    /// The part of the seam that each pass runs over; `None` for passes through points.
    pub(crate) fn stretches(&self) -> Vec<Option<Stretch>> {
        let stretch = |line: &Arc<PassLine>| match line.as_ref() {
            PassLine::Seam(line) => Some(line.stretch),
            PassLine::Points(_) => None,
        };
        self.lines.iter().map(stretch).collect()
    }

    /// Keys in the file of the values of pass `pass`, counted from 0.
    pub fn keys(&self, pass: usize) -> &PassKeys {
        &self.keys[pass]
    }

    /// Findings against the weld that need no machine.
    pub fn findings(&self) -> Vec<Finding> {
        let paths = (0..self.lines.len()).map(|i| (i, self.path(i)));
        let passes = paths.flat_map(|(i, path)| path.along_seam().map_or(Vec::new(), |path| path.findings(i + 1)));
        let gaps = self.program.value.passes.iter().enumerate().filter_map(|(i, pass)| gaps(pass, i + 1));
        self.plan_findings.iter().cloned().chain(passes).chain(gaps).collect()
    }
}

/// Puts a `finding` of a range of the seam to the first of `passes` that runs there.
fn at_first_pass<'a>(finding: &mut Finding, passes: impl Iterator<Item = (usize, &'a Pass)>, seam: &SeamCurve) {
    let range = PathRange { from_mm: finding.from_mm, to_mm: finding.to_mm };
    let mut laid = passes.filter_map(|(i, pass)| Some((i, on_pass(pass, seam, range)?)));
    if let Some((i, own)) = laid.next() {
        (finding.pass, finding.from_mm, finding.to_mm) = (i + 1, own.from_mm, own.to_mm);
    }
}

/// Findings against the joint itself, each at the first pass along the seam there.
fn joint_findings<T>(
    file: &Document<T>,
    joint: Option<&SeamJoint>,
    curve: &SeamCurve,
    seam: &Seam,
    passes: &[Pass],
) -> Vec<Finding> {
    let body = if let Seam::Nozzle(nozzle) = seam { body::thickness(file, &nozzle.body).ok() } else { None };
    let mut findings = joint.map_or(Vec::new(), |joint| joint.beside_standard(curve, seam, body));
    for finding in &mut findings {
        let along =
            passes.iter().enumerate().filter(|(_, pass)| pass.points.is_none() && pass.role != Some(Role::Tack));
        at_first_pass(finding, along, curve);
    }
    findings
}

/// Number of stations checked in a range of the seam.
const PLACES: u32 = 64;

/// The path lengths of `pass` between which it runs over a range of the seam (from the start of the weld); `None` if it
/// does not.
fn on_pass(pass: &Pass, seam: &SeamCurve, range: PathRange) -> Option<PathRange> {
    let PathRange { from_mm: from, to_mm: to } = range;
    let sense = if pass.reverse { -1.0 } else { 1.0 };
    let own = |i: u32| {
        let s = sense * (from + (to - from) * f64::from(i) / f64::from(PLACES) - pass.begin_mm.get());
        // A range beyond the seam's length is that of a bead in a later turn.
        let is_turned = seam.all_round() && !(0.0..=pass.length()).contains(&s);
        if is_turned { s.rem_euclid(seam.length()) } else { s }
    };
    let inside = (0..=PLACES).map(own).filter(|s| (0.0..=pass.length()).contains(s));
    inside.fold(None, |own: Option<PathRange>, s| {
        let own = own.unwrap_or(PathRange::at(s));
        Some(PathRange { from_mm: own.from_mm.min(s), to_mm: own.to_mm.max(s) })
    })
}

/// Reports gaps that the oscillation of the beam leaves in pass `number`.
fn gaps(pass: &Pass, number: usize) -> Option<Finding> {
    let (message, cure) = pass.oscillation.as_ref()?.gaps(pass.speeds().1)?;
    Some(Finding::error("oscillation", message, number, PathRange::up_to(pass.length()), cure))
}

#[derive(Debug)]
enum PassLine {
    Seam(Box<SeamLine>),
    Points(Box<PointPath>),
}

#[derive(Debug)]
struct SeamLine {
    /// The part of the seam.
    stretch: Stretch,
    /// Torch angles by the seam's path length, without the bead's addition.
    attitude: Attitude,
    /// Position of its beads beside the seam, if it has any.
    bead: Option<BeadPath>,
    /// Distance of the machine's tip behind the arc, mm.
    drawn_back: f64,
}

/// Lines of the passes of `program`; `keys` are the keys of their values in the file.
fn pass_lines(
    program: &Document<Program>,
    seam: Option<&SeamCurve>,
    keys: &[PassKeys],
    machine_stick_out: Option<f64>,
    outside: &dyn Outside,
) -> Result<Vec<PassLine>, DocumentError> {
    let machine = || {
        let machine = outside.axes(&program.value.machine);
        machine.map_err(|w| program.error_at("machine", w.message, w.allowed))
    };
    let line = |(i, pass): (usize, &Pass)| {
        let keys = &keys[i];
        let seam = match (&pass.points, seam) {
            (None, Some(seam)) => seam,
            (Some(points), _) => {
                return Ok(PassLine::Points(Box::new(PointPath::new(program, i, points, &machine)?)));
            }
            (None, None) => {
                let message = Message::new("weld-pass-without-seam");
                return Err(program.error_at(&keys.of(""), message, Message::verbatim("[seam]")));
            }
        };
        let stretch = Stretch::new(program, keys, pass, seam)?;
        if pass.travel_s() > MAX_TRAVEL_S {
            let message = Message::new("weld-travel-too-long").text("pass", &pass.name);
            let message = message.quantity("time", pass.travel_s(), Unit::S, 0);
            let allowed = Message::new("weld-allowed-travel-time").value("max", MAX_TRAVEL_S, Unit::S);
            return Err(program.error_at(&keys.speed(), message, allowed));
        }
        let attitude = Attitude::new(program, &keys.of("torch"), &pass.torch, seam)?;
        let bead = BeadPath::new(program, keys, pass, seam, &stretch)?;
        let drawn_back = stick_out::drawn_back(program, &keys.of("torch"), &pass.torch, machine_stick_out)?;
        Ok(PassLine::Seam(Box::new(SeamLine { stretch, attitude, bead, drawn_back })))
    };
    program.value.passes.iter().enumerate().map(line).collect()
}
