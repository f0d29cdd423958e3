//! Names of verbs before they were grouped. They go on working, and a note names the new ones.

use super::machine::{ListMachinesArgs, MachineArgs, MachineVerb, ShowArgs};
use super::*;

/// A verb under its former name.
#[derive(Debug, Subcommand)]
pub(crate) enum Former {
    /// See `tools seam`
    #[command(hide = true)]
    Seam(SeamArgs),
    /// See `tools section`
    #[command(hide = true)]
    Section(SectionArgs),
    /// See `tools motion`
    #[command(hide = true)]
    Motion(MotionArgs),
    /// See `tools pulses`
    #[command(hide = true)]
    Pulses(PulsesArgs),
    /// See `tools follow`
    #[command(hide = true)]
    Follow(follow::FollowArgs),
    /// See `tools reduce`
    #[command(hide = true)]
    Reduce(reduce::ReduceArgs),
    /// See `tools interpolate`
    #[command(hide = true)]
    Interpolate(InterpolateArgs),
    /// See `tools bench`
    #[command(hide = true)]
    Bench(bench::BenchArgs),
    /// See `machine latency`
    #[command(hide = true)]
    Latency(run::LatencyArgs),
    /// See `machine io`
    #[command(hide = true)]
    Io(io::IoArgs),
    /// See `machine kinematics`
    #[command(hide = true)]
    Kinematics(KinematicsArgs),
    /// See `machine move`
    #[command(hide = true)]
    Move(move_to::MoveArgs),
    /// See `machine list` and `machine show`
    #[command(hide = true)]
    Machines(ListArgs),
    /// See `examples --procedures`
    #[command(hide = true)]
    Procedures(ListArgs),
    /// See `import`
    #[command(hide = true)]
    Read(read::ReadArgs),
    /// See `vision joint`
    #[command(hide = true)]
    FindJoint(find_joint::FindJointArgs),
    /// See `vision stripe`
    #[command(hide = true)]
    Stripe(stripe::StripeArgs),
}

impl Former {
    /// Returns the former name, the present one, and the verb.
    pub(crate) fn renamed(self) -> (&'static str, &'static str, Verb) {
        let tools = |verb| Verb::Tools(ToolsArgs { verb });
        let machine = |verb| Verb::Machine(MachineArgs { verb });
        let vision = |verb| Verb::Vision(VisionArgs { verb });
        match self {
            Self::Seam(a) => ("seam", "tools seam", tools(ToolsVerb::Seam(a))),
            Self::Section(a) => ("section", "tools section", tools(ToolsVerb::Section(a))),
            Self::Motion(a) => ("motion", "tools motion", tools(ToolsVerb::Motion(a))),
            Self::Pulses(a) => ("pulses", "tools pulses", tools(ToolsVerb::Pulses(a))),
            Self::Follow(a) => ("follow", "tools follow", tools(ToolsVerb::Follow(a))),
            Self::Reduce(a) => ("reduce", "tools reduce", tools(ToolsVerb::Reduce(a))),
            Self::Interpolate(a) => ("interpolate", "tools interpolate", tools(ToolsVerb::Interpolate(a))),
            Self::Bench(a) => ("bench", "tools bench", tools(ToolsVerb::Bench(a))),
            Self::Latency(a) => ("latency", "machine latency", machine(MachineVerb::Latency(a))),
            Self::Io(a) => ("io", "machine io", machine(MachineVerb::Io(a))),
            Self::Kinematics(a) => ("kinematics", "machine kinematics", machine(MachineVerb::Kinematics(a))),
            Self::Move(a) => ("move", "machine move", machine(MachineVerb::Move(a))),
            Self::Machines(ListArgs { name: Some(name), .. }) => {
                ("machines", "machine show", machine(MachineVerb::Show(ShowArgs { name })))
            }
            Self::Machines(ListArgs { json, .. }) => {
                ("machines", "machine list", machine(MachineVerb::List(ListMachinesArgs { json })))
            }
            Self::Procedures(list) => {
                ("procedures", "examples --procedures", Verb::Examples(ExamplesArgs { list, procedures: true }))
            }
            Self::Read(a) => ("read", "import", Verb::Import(a)),
            Self::FindJoint(a) => ("find-joint", "vision joint", vision(VisionVerb::Joint(a))),
            Self::Stripe(a) => ("stripe", "vision stripe", vision(VisionVerb::Stripe(a))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Cli;
    use super::*;
    use clap::error::ErrorKind;
    use clap::{CommandFactory, Parser};
    use std::collections::BTreeSet;

    /// Former names, each with arguments that it takes.
    const CASES: [(&str, &str); 18] = [
        ("seam", "saddle --points 5"),
        ("section", "saddle --points 2"),
        ("motion", "saddle --period-ms 4"),
        ("pulses", "saddle --period-ms 4"),
        ("follow", "- --machine ellipse-xy --speed-mm-s 5"),
        ("reduce", "points.csv --tolerance-mm 1"),
        ("interpolate", "--curve ellipse --summary"),
        ("bench", "tracking --seeds 1"),
        ("latency", "--seconds 1"),
        ("io", "ellipse-xy"),
        ("kinematics", "ellipse-xy --forward"),
        ("move", "ellipse-xy --to x=1"),
        ("machines", ""),
        ("machines", "ellipse-xy"),
        ("procedures", ""),
        ("read", "part.ngc --machine ellipse-xy"),
        ("find-joint", "frame.png --start 1,1 --direction-deg 0"),
        ("stripe", "stripe.png --joint v"),
    ];

    fn parse(verb: &str, arguments: &str) -> Result<Cli, clap::Error> {
        Cli::try_parse_from(format!("seamwright {verb} {arguments}").split_whitespace())
    }

    #[test]
    fn every_former_name_is_its_present_verb() {
        for (name, arguments) in CASES {
            let cli = parse(name, arguments).unwrap_or_else(|e| panic!("{name} {arguments}: {e}"));
            let Some(Verb::Former(former)) = cli.verb else { panic!("{name} is no former name") };
            let (old, present, verb) = former.renamed();
            assert_eq!(old, name);
            let expected = parse(present, arguments).unwrap_or_else(|e| panic!("{present} {arguments}: {e}"));
            assert_eq!(format!("{verb:?}"), format!("{:?}", expected.verb.unwrap()), "{name}");
            for verb in [name, present] {
                assert_eq!(parse(verb, "--help").unwrap_err().kind(), ErrorKind::DisplayHelp, "{verb}");
            }
        }
        let all = Former::augment_subcommands(clap::Command::new("former"));
        let all: BTreeSet<&str> = all.get_subcommands().map(clap::Command::get_name).collect();
        assert_eq!(CASES.iter().map(|(name, _)| *name).collect::<BTreeSet<_>>(), all);
        let shown = Cli::command();
        assert!(shown.get_subcommands().filter(|verb| all.contains(verb.get_name())).all(clap::Command::is_hide_set));
    }
}
