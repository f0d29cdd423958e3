//! Arguments of `licences`.

use clap::Args;

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright licences | less
  seamwright licences --sbom > seamwright.cdx.json")]
pub(crate) struct LicencesArgs {
    /// Print the bill of materials (SBOM) instead, CycloneDX 1.6: packages, versions, licences, checksums
    #[arg(long)]
    pub(crate) sbom: bool,
}
