//! Encrypted connections: certificates of the user, or of an authority of the cell's own.

use crate::Error;
use axum_server::tls_rustls::RustlsConfig;
use rcgen::{
    BasicConstraints, CertificateParams, DistinguishedName, DnType, ExtendedKeyUsagePurpose, IsCa, Issuer, KeyPair,
    KeyUsagePurpose, date_time_ymd,
};
use seamwright_project::files;
use seamwright_record::Moment;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where the certificate comes from.
#[derive(Debug, Clone)]
pub enum Tls {
    /// From an authority of its own in the data folder: browsers trust it once its `tls/ca.pem` is installed there.
    Own,
    /// The user's: PEM files of the chain and the key.
    Files {
        /// The certificate, then those that it hangs on.
        cert: PathBuf,
        /// Its private key.
        key: PathBuf,
    },
}

fn wrong(e: &impl std::fmt::Display) -> Error {
    Error::System(format!("the certificate cannot be made: {e}"))
}

/// What connections are encrypted with; `names` are those under which the panel is asked for.
pub(crate) async fn config(tls: &Tls, data: &Path, names: &[String]) -> Result<RustlsConfig, Error> {
    // A second one is the same: it does not matter.
    drop(rustls::crypto::ring::default_provider().install_default());
    let config = match tls {
        Tls::Files { cert, key } => RustlsConfig::from_pem_file(cert, key).await.map_err(|e| {
            let files = format!("--cert {} --key {}", cert.display(), key.display());
            Error::Settings(format!("{files}: {e}\n   allowed: PEM files of a certificate and its private key"))
        })?,
        Tls::Own => {
            let (cert, key) = own(data, names)?;
            RustlsConfig::from_pem(cert.into_bytes(), key.into_bytes()).await.map_err(|e| wrong(&e))?
        }
    };
    // Browsers take HTTP/2 where it is offered, and then neither name the host in a header nor upgrade to a WebSocket.
    let mut offered = (*config.get_inner()).clone();
    offered.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(RustlsConfig::from_config(Arc::new(offered)))
}

/// A new certificate for `names` from the cell's own authority, and its key; both PEM.
fn own(data: &Path, names: &[String]) -> Result<(String, String), Error> {
    let folder = data.join("tls");
    files::make_private(&folder).map_err(|e| Error::System(format!("{}: {e}", folder.display())))?;
    let failed = |e: seamwright_project::Failure| Error::System(e.text());
    let (key_file, cert_file) = (folder.join("ca.key"), folder.join("ca.pem"));
    let ca_key = if key_file.is_file() {
        KeyPair::from_pem(&files::read(&key_file).map_err(failed)?).map_err(|e| wrong(&e))?
    } else {
        let key = KeyPair::generate().map_err(|e| wrong(&e))?;
        files::write_secret(&key_file, &key.serialize_pem()).map_err(failed)?;
        key
    };
    let mut authority = CertificateParams::new(Vec::new()).map_err(|e| wrong(&e))?;
    authority.distinguished_name = named("Seamwright cell");
    authority.is_ca = IsCa::Ca(BasicConstraints::Constrained(0));
    authority.key_usages = vec![KeyUsagePurpose::KeyCertSign, KeyUsagePurpose::CrlSign];
    (authority.not_before, authority.not_after) = (date_time_ymd(2026, 1, 1), date_time_ymd(2056, 1, 1));
    if !cert_file.is_file() {
        let cert = authority.self_signed(&ca_key).map_err(|e| wrong(&e))?;
        files::write(&cert_file, &cert.pem()).map_err(failed)?;
    }
    let mut params = CertificateParams::new(names.to_vec()).map_err(|e| wrong(&e))?;
    params.distinguished_name = named("Seamwright panel");
    params.extended_key_usages = vec![ExtendedKeyUsagePurpose::ServerAuth];
    (params.not_before, params.not_after) = year();
    let key = KeyPair::generate().map_err(|e| wrong(&e))?;
    let cert = params.signed_by(&key, &Issuer::new(authority, ca_key)).map_err(|e| wrong(&e))?;
    Ok((cert.pem(), key.serialize_pem()))
}

fn named(name: &str) -> DistinguishedName {
    let mut distinguished = DistinguishedName::new();
    distinguished.push(DnType::CommonName, name);
    distinguished
}

/// From the begin of this month for 13 months: it is made anew at every start.
fn year() -> (time::OffsetDateTime, time::OffsetDateTime) {
    let today = Moment::now().to_string();
    let mut parts = today.split(['-', ' ']).map_while(|part| part.parse::<i32>().ok());
    let (year, month) = (parts.next().unwrap_or(2026), parts.next().unwrap_or(1));
    let next = if month == 12 { (year + 2, 1) } else { (year + 1, month + 1) };
    (date_time_ymd(year, month as u8, 1), date_time_ymd(next.0, next.1 as u8, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The authority stays, certificates are new at every start, and keys are nobody else's to read.
    #[tokio::test]
    async fn the_cell_is_its_own_authority() {
        let folder = tempfile::tempdir().unwrap();
        let names = ["127.0.0.1".to_owned(), "cell.shop".to_owned()];
        let offered = config(&Tls::Own, folder.path(), &names).await.unwrap().get_inner();
        assert_eq!(offered.alpn_protocols, [b"http/1.1"]);
        let authority = std::fs::read_to_string(folder.path().join("tls/ca.pem")).unwrap();
        let (first, _) = own(folder.path(), &names).unwrap();
        let (second, _) = own(folder.path(), &names).unwrap();
        assert_ne!(first, second);
        assert_eq!(std::fs::read_to_string(folder.path().join("tls/ca.pem")).unwrap(), authority);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            for file in ["tls", "tls/ca.key"] {
                let mode = std::fs::metadata(folder.path().join(file)).unwrap().permissions().mode();
                assert_eq!(mode & 0o077, 0, "{file}");
            }
        }
        let (from, to) = year();
        assert!((393..=398).contains(&(to - from).whole_days()));
        let files = Tls::Files { cert: folder.path().join("no.pem"), key: folder.path().join("tls/ca.key") };
        assert!(config(&files, folder.path(), &names).await.unwrap_err().to_string().contains("no.pem"));
    }
}
