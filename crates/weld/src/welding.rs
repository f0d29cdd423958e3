use crate::{Attitude, Job, PassPath, SeamCurve};
use seamwright_document::{Document, DocumentError};
use seamwright_program::{Finding, Program};

/// A weld read from a job or a program file: the program, the seam, and the torch angles along it.
#[derive(Debug)]
pub struct Welding {
    /// The program, at the address of the file it came from.
    pub program: Document<Program>,
    /// The seam by path length from the start of the weld.
    pub seam: SeamCurve,
    /// Torch angles along the weld.
    pub attitude: Attitude,
}

impl Welding {
    /// Reads a job file, or a program file (one with `passes`).
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        if Program::is_in(text) {
            return Self::from_program(Program::read(file, text)?);
        }
        let job = Job::read(file, text)?;
        let seam = SeamCurve::new(&job, &job.value.seam, &job.value.start)?;
        let attitude = Attitude::new(&job, "torch", &job.value.torch, &seam)?;
        let program = Job::program(&job, &seam)?;
        Ok(Self { program: job.with(program), seam, attitude })
    }

    fn from_program(program: Document<Program>) -> Result<Self, DocumentError> {
        let p = &program.value;
        if p.passes.len() > 1 {
            let message = "programs of several passes need air moves between them, which this version does not plan";
            return Err(program.error_at("passes", message, "one pass"));
        }
        let seam = SeamCurve::new(&program, &p.seam, &p.start)?;
        let length = p.passes[0].length();
        if (length - seam.weld_length()).abs() > 1e-6 {
            let path = format!("passes[0].spans[{}].to_mm", p.passes[0].spans.len() - 1);
            let message = "the pass does not end where the weld ends";
            return Err(program.error_at(&path, message, format!("{}", seam.weld_length())));
        }
        let attitude = Attitude::new(&program, "passes[0].torch", &p.passes[0].torch, &seam)?;
        Ok(Self { seam, attitude, program })
    }

    /// The torch's path in the machine's work frame.
    pub fn path(&self) -> PassPath<'_> {
        PassPath { seam: &self.seam, attitude: self.attitude.clone(), placement: self.program.value.seam_in_work() }
    }

    /// What stands against the weld before any machine is looked at.
    pub fn findings(&self) -> Vec<Finding> {
        self.attitude.access_findings(&self.seam, 1)
    }
}
