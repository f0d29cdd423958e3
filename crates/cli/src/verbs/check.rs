use crate::args::CheckArgs;
use crate::failure::{Failure, write_findings};
use crate::load::load;
use crate::planning;
use crate::rows::print_json;
use std::io;

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let findings =
        planning::try_plan(&loaded, &args.planning)?.map_or_else(|findings| findings, |motion| motion.findings);
    let printed = if args.json {
        print_json(&findings)
    } else {
        write_findings(&mut io::stdout().lock(), &findings).map_err(Failure::from)
    };
    match printed {
        // The exit code is the answer, also to whoever reads no further.
        Ok(()) | Err(Failure::ReaderGone) if findings.iter().any(|f| !f.allowed) => Err(Failure::Printed),
        printed => printed,
    }
}
