use crate::job::Job;
use seamwright_program::{Pass, Role};

/// Keys of a pass' values in its file, so that an error names a key that exists.
///
/// A program lists its passes. A job's passes are derived: their values come from `[weld]` or from the table of their
/// kind (`[beads]`, `[tacks]`, `[cosmetic]`). Rows of beads and spans are in no table.
#[derive(Debug, Clone, PartialEq)]
pub struct PassKeys(Source);

#[derive(Debug, Clone, PartialEq)]
enum Source {
    /// The pass is `passes[i]` of a program.
    Listed(usize),
    /// The pass follows from a job.
    Derived {
        /// The table that makes the pass.
        table: &'static str,
        /// The table of its own process values, and their names; the others are those of `[weld.process]`.
        own: (&'static str, Vec<String>),
        /// True if that table has a speed of its own too.
        has_speed: bool,
    },
}

impl PassKeys {
    /// Keys of `passes[i]` of a program.
    pub(crate) fn listed(i: usize) -> Self {
        Self(Source::Listed(i))
    }

    /// Keys from which `pass` of `job` follows.
    pub(crate) fn derived(job: &Job, pass: &Pass) -> Self {
        let beads = job.beads.as_ref();
        let (table, run, process, speed) = match pass.role {
            None => ("weld", "weld", None, None),
            Some(Role::Tack) => {
                let tacks = job.tacks.as_ref();
                ("tacks", "tacks", tacks.map(|tacks| &tacks.process), tacks.and_then(|tacks| tacks.speed_mm_s))
            }
            Some(Role::Cosmetic) => {
                let cosmetic = job.cosmetic.as_ref();
                ("cosmetic", "cosmetic", cosmetic.map(|c| &c.process), cosmetic.and_then(|c| c.speed_mm_s))
            }
            Some(role) => {
                let root = beads.and_then(|b| b.root.as_ref()).filter(|_| role == Role::Root);
                let cap = beads.and_then(|b| b.cap.as_ref()).filter(|_| role == Role::Cap);
                let (name, run) = match (root, cap) {
                    (Some(root), _) => ("beads.root", Some(root)),
                    (_, Some(cap)) => ("beads.cap", Some(cap)),
                    (None, None) => ("beads.fill", beads.map(|b| &b.fill)),
                };
                ("beads", name, run.map(|run| &run.process), run.and_then(|run| run.speed_mm_s))
            }
        };
        let names = process.map_or(Vec::new(), |process| process.keys().cloned().collect());
        Self(Source::Derived { table, own: (run, names), has_speed: speed.is_some() })
    }

    /// The key of the file from which `key` of the pass has its value: of where it runs (`begin_mm`, `bead.s_mm[3]`,
    /// `spans[0].to_mm`), of its torch or of its redundant axes (`spare_axes.hold.r`); the pass itself if empty.
    pub fn of(&self, key: &str) -> String {
        match &self.0 {
            Source::Listed(i) if key.is_empty() => format!("passes[{i}]"),
            Source::Listed(i) => format!("passes[{i}].{key}"),
            Source::Derived { table, .. } => match key.split(['.', '[']).next() {
                Some("begin_mm" | "spans" | "bead" | "step_overs" | "") | None => (*table).to_owned(),
                Some(_) => key.to_owned(),
            },
        }
    }

    /// The key of the file that gives the pass' speed.
    pub(crate) fn speed(&self) -> String {
        match &self.0 {
            Source::Listed(i) => format!("passes[{i}].spans[0].speed_mm_s"),
            Source::Derived { own: (run, _), has_speed: true, .. } => format!("{run}.speed_mm_s"),
            Source::Derived { .. } => "weld.speed_mm_s".to_owned(),
        }
    }

    /// The key of the file that gives the pass' process value `name`.
    pub fn process(&self, name: &str) -> String {
        match &self.0 {
            Source::Listed(i) => format!("passes[{i}].spans[0].process.{name}"),
            Source::Derived { own: (run, names), .. } if names.iter().any(|own| own == name) => {
                format!("{run}.process.{name}")
            }
            Source::Derived { .. } => format!("weld.process.{name}"),
        }
    }
}
