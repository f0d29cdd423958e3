use clap::Args;
use std::path::PathBuf;

/// A cluster that plans instead of this computer.
#[derive(Debug, Args)]
pub(crate) struct ClusterArgs {
    /// Plan on a Spark cluster, at this address of Spark Connect: sc://HOST:PORT
    #[arg(long, value_name = "ADDRESS", conflicts_with = "jobs")]
    pub(crate) spark: Option<String>,
    /// With --spark: the Python program with the package seamwright and the client of Spark Connect
    #[arg(long, value_name = "FILE", default_value = "python3", requires = "spark")]
    pub(crate) python: PathBuf,
}
