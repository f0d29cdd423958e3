use crate::args::CheckArgs;
use crate::failure::{Failure, write_findings};
use crate::load::load;
use crate::rows::print_json;
use std::io;

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let findings = loaded.try_plan()?.map_or_else(|findings| findings, |motion| motion.findings);
    if args.json {
        print_json(&findings)?;
    } else {
        write_findings(&mut io::stdout().lock(), &findings)?;
    }
    if findings.iter().all(|f| f.allowed) { Ok(()) } else { Err(Failure::Printed) }
}
