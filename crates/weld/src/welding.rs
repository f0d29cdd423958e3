use crate::{Attitude, BeadLine, Job, PassPath, SeamCurve, Stretch};
use seamwright_document::{Document, DocumentError};
use seamwright_program::{Finding, Program};

/// A weld read from a job or a program file: the program, the seam, and the torch angles along it.
#[derive(Debug)]
pub struct Welding {
    /// The program, at the address of the file it came from.
    pub program: Document<Program>,
    /// The seam by path length from the start of the weld.
    pub seam: SeamCurve,
    /// The part of the seam that each pass runs over.
    pub stretches: Vec<Stretch>,
    /// Torch angles along each pass, by the seam's path length; without what its bead adds to them.
    pub attitudes: Vec<Attitude>,
    /// Where the bead of each pass lies beside the seam, if it does.
    pub beads: Vec<Option<BeadLine>>,
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
        let stretches = vec![Stretch::whole(&seam)];
        Ok(Self { program: job.with(program), seam, stretches, attitudes: vec![attitude], beads: vec![None] })
    }

    fn from_program(program: Document<Program>) -> Result<Self, DocumentError> {
        let p = &program.value;
        let seam = SeamCurve::new(&program, &p.seam, &p.start)?;
        let (mut stretches, mut attitudes, mut beads) = (Vec::new(), Vec::new(), Vec::new());
        for (i, pass) in p.passes.iter().enumerate() {
            let path = |key: &str| format!("passes[{i}]{key}");
            let stretch = Stretch::new(&program, &path(""), pass, &seam)?;
            let bead = |bead| BeadLine::new(&program, &path(".bead"), bead, (&seam, &stretch));
            attitudes.push(Attitude::new(&program, &path(".torch"), &pass.torch, &seam)?);
            beads.push(pass.bead.as_ref().map(bead).transpose()?);
            stretches.push(stretch);
        }
        Ok(Self { seam, stretches, attitudes, beads, program })
    }

    /// The torch's path in pass `pass`, counted from 0, in the machine's work frame.
    pub fn path(&self, pass: usize) -> PassPath<'_> {
        PassPath {
            seam: &self.seam,
            stretch: self.stretches[pass],
            attitude: self.attitudes[pass].clone(),
            bead: self.beads[pass].as_ref(),
            placement: self.program.value.seam_in_work(),
        }
    }

    /// What stands against the weld before any machine is looked at.
    pub fn findings(&self) -> Vec<Finding> {
        (0..self.attitudes.len()).flat_map(|i| self.path(i).findings(i + 1)).collect()
    }
}
