use crate::outside::{fetch, forget};
use crate::{Attitude, BeadPlan, Cut, Job, NoFiles, Outside, PassPath, SeamCurve, SeamJoint, procedure};
use seamwright_document::{Document, DocumentError};
use seamwright_program::{Finding, Program};

/// A weld read from a job or a program file: the program, the seam, and the torch angles along it.
#[derive(Debug)]
pub struct Welding {
    /// The program, at the address of the file it came from.
    pub program: Document<Program>,
    /// The seam by path length from the start of the weld.
    pub seam: SeamCurve,
    /// Torch angles along each pass.
    pub attitudes: Vec<Attitude>,
    /// The joint along the seam, if the file has one.
    pub joint: Option<SeamJoint>,
    /// The beads that fill it, if they were planned: from a job, not from a program.
    pub beads: Option<BeadPlan>,
    /// What stands against the beads.
    bead_findings: Vec<Finding>,
    /// The end of the branch or nozzle as it is cut, where the file gives what it takes.
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
            let place = (program.value.machine.as_str(), program.value.seam_in_work());
            fetch(&program, (&mut seam, &mut taught), place, outside)?;
            (program.value.seam, program.value.taught) = (seam, taught);
            Self::from_program(program)?
        } else {
            let mut job = Job::read(file, text)?;
            let (mut seam, mut taught) = (job.value.seam.clone(), job.value.taught.clone());
            fetch(&job, (&mut seam, &mut taught), (&job.value.machine, job.value.seam_in_work()), outside)?;
            (job.value.seam, job.value.taught) = (seam, taught);
            Self::from_job(&job, outside)?
        };
        forget(&mut welding.program.value.seam, &mut welding.program.value.taught);
        Ok(welding)
    }

    fn from_job(job: &Document<Job>, outside: &dyn Outside) -> Result<Self, DocumentError> {
        let j = &job.value;
        let seam = SeamCurve::with_taught(job, (&j.seam, &j.start), &j.taught)?;
        let attitude = Attitude::new(job, "torch", &j.torch, &seam)?;
        let mut program = Job::program(job, &seam)?;
        let joint = j.joint.as_ref().map(|joint| SeamJoint::new(job, joint, &seam)).transpose()?;
        let (mut plan, mut findings) = (None, Vec::new());
        if let (Some(beads), Some(joint)) = (&j.beads, &joint) {
            let weld = (j.weld.speed_mm_s, &j.weld.process);
            let filled = beads.filled(job, (&seam, joint), weld, &program.passes[0])?;
            program.passes = filled.passes;
            (plan, findings) = (Some(filled.plan), filled.findings);
        }
        let attitudes = vec![attitude; program.passes.len()];
        let cut = Cut::new(job, &j.seam)?;
        program.procedure = procedure::of_job(job, &program, outside)?;
        Ok(Self { program: job.with(program), seam, attitudes, joint, beads: plan, bead_findings: findings, cut })
    }

    fn from_program(program: Document<Program>) -> Result<Self, DocumentError> {
        let p = &program.value;
        let seam = SeamCurve::with_taught(&program, (&p.seam, &p.start), &p.taught)?;
        let mut attitudes = Vec::new();
        for (i, pass) in p.passes.iter().enumerate() {
            if (pass.length() - seam.weld_length()).abs() > 1e-6 {
                let path = format!("passes[{i}].spans[{}].to_mm", pass.spans.len() - 1);
                let message = "the pass does not end where the weld ends";
                return Err(program.error_at(&path, message, format!("{}", seam.weld_length())));
            }
            attitudes.push(Attitude::new(&program, &format!("passes[{i}].torch"), &pass.torch, &seam)?);
        }
        let joint = p.joint.as_ref().map(|joint| SeamJoint::new(&program, joint, &seam)).transpose()?;
        let cut = Cut::new(&program, &p.seam)?;
        Ok(Self { seam, attitudes, program, joint, beads: None, bead_findings: Vec::new(), cut })
    }

    /// The torch's path in pass `pass`, counted from 0, in the machine's work frame.
    pub fn path(&self, pass: usize) -> PassPath<'_> {
        let placement = self.program.value.seam_in_work();
        PassPath { seam: &self.seam, attitude: self.attitudes[pass].clone(), placement }
    }

    /// What stands against the weld before any machine is looked at.
    pub fn findings(&self) -> Vec<Finding> {
        let passes = self.attitudes.iter().enumerate();
        let both = |(i, attitude): (usize, &Attitude)| {
            let mut findings = attitude.access_findings(&self.seam, i + 1);
            findings.extend(attitude.turn_findings(&self.seam, i + 1));
            findings
        };
        self.bead_findings.iter().cloned().chain(passes.flat_map(both)).collect()
    }
}
