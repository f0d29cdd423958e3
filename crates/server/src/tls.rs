//! Encrypted connections: certificates of the user, or of an authority of the cell's own.

use crate::Error;
use crate::log;
use axum_server::tls_rustls::RustlsConfig;
use rcgen::{
    BasicConstraints, CertificateParams, DistinguishedName, DnType, ExtendedKeyUsagePurpose, IsCa, Issuer, KeyPair,
    KeyUsagePurpose,
};
use seamwright_project::files;
use seamwright_record::Moment;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use time::OffsetDateTime;

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

/// Validity of the authority, days: ten years. It is renewed at a start, with its key, when less than [`RENEWED_DAYS`] are left.
const AUTHORITY_DAYS: i64 = 3652;
const RENEWED_DAYS: i64 = 420;
/// Validity of a certificate, days: what browsers take at most, less a day for clocks that differ.
const CERTIFICATE_DAYS: i64 = 397;
/// A running panel gets a new certificate this often.
const ANEW: Duration = Duration::from_secs(30 * 24 * 3600);

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
            // Keys and files take their time: nobody who stops waits for them.
            let (data, names) = (data.to_owned(), names.to_vec());
            let made = tokio::task::spawn_blocking(move || own(&data, &names)).await;
            let (cert, key) = made.map_err(|e| wrong(&e))??;
            RustlsConfig::from_pem(cert.into_bytes(), key.into_bytes()).await.map_err(|e| wrong(&e))?
        }
    };
    // Browsers take HTTP/2 where it is offered, and then neither name the host in a header nor upgrade to a WebSocket.
    let mut offered = (*config.get_inner()).clone();
    offered.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(RustlsConfig::from_config(Arc::new(offered)))
}

/// Gives connections to come a new certificate of the cell's own, for as long as it is waited for.
pub(crate) async fn renew(current: RustlsConfig, data: PathBuf, names: Vec<String>) {
    loop {
        tokio::time::sleep(ANEW).await;
        match config(&Tls::Own, &data, &names).await {
            Ok(new) => current.reload_from_config(new.get_inner()),
            Err(e) => log::warning(&format!("the certificate is not renewed: {e}")),
        }
    }
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
    let now = now()?;
    let mut authority = CertificateParams::new(Vec::new()).map_err(|e| wrong(&e))?;
    authority.distinguished_name = named("Seamwright cell");
    authority.is_ca = IsCa::Ca(BasicConstraints::Constrained(0));
    authority.key_usages = vec![KeyUsagePurpose::KeyCertSign, KeyUsagePurpose::CrlSign];
    (authority.not_before, authority.not_after) = days(now, AUTHORITY_DAYS);
    // Beside it stands until when it is valid; those of older versions, made for thirty years, have nothing beside them.
    let until_file = folder.join("ca.until");
    let known = if cert_file.is_file() { std::fs::read_to_string(&until_file).ok() } else { None };
    if known.as_deref().is_none_or(|until| !is_current(until, now)) {
        let cert = authority.self_signed(&ca_key).map_err(|e| wrong(&e))?;
        files::write(&cert_file, &cert.pem()).map_err(failed)?;
        let until = authority.not_after.date();
        files::write(&until_file, &format!("{until}\n")).map_err(failed)?;
        log::info(&format!("the cell's authority is valid until {until}: install {} in browsers", cert_file.display()));
    }
    let mut params = CertificateParams::new(names.to_vec()).map_err(|e| wrong(&e))?;
    params.distinguished_name = named("Seamwright panel");
    params.extended_key_usages = vec![ExtendedKeyUsagePurpose::ServerAuth];
    (params.not_before, params.not_after) = days(now, CERTIFICATE_DAYS);
    let key = KeyPair::generate().map_err(|e| wrong(&e))?;
    let cert = params.signed_by(&key, &Issuer::new(authority, ca_key)).map_err(|e| wrong(&e))?;
    Ok((cert.pem(), key.serialize_pem()))
}

fn named(name: &str) -> DistinguishedName {
    let mut distinguished = DistinguishedName::new();
    distinguished.push(DnType::CommonName, name);
    distinguished
}

/// The time, by the system's clock.
fn now() -> Result<OffsetDateTime, Error> {
    OffsetDateTime::from_unix_timestamp(Moment::now().0.div_euclid(1000)).map_err(|e| wrong(&e))
}

/// From a day ago, as clocks differ, until `days` from now.
fn days(now: OffsetDateTime, days: i64) -> (OffsetDateTime, OffsetDateTime) {
    (now - time::Duration::days(1), now + time::Duration::days(days))
}

/// True if an authority that is valid until this date (`YYYY-MM-DD`) is so for long enough, and not for longer than ours are.
fn is_current(until: &str, now: OffsetDateTime) -> bool {
    let until = until.trim().parse::<Moment>().map(|until| until.0.div_euclid(1000));
    let left = until.map(|until| (until - now.unix_timestamp()) / (24 * 3600));
    left.is_ok_and(|left| (RENEWED_DAYS..=AUTHORITY_DAYS).contains(&left))
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
        let files = Tls::Files { cert: folder.path().join("no.pem"), key: folder.path().join("tls/ca.key") };
        assert!(config(&files, folder.path(), &names).await.unwrap_err().to_string().contains("no.pem"));
    }

    /// The date after which a certificate is not valid, from its DER: the second of two times (UTCTime, X.690 8.26).
    fn ends(pem: &str) -> String {
        use rustls::pki_types::pem::PemObject as _;
        let der = rustls::pki_types::CertificateDer::from_pem_slice(pem.as_bytes()).unwrap();
        let times: Vec<&[u8]> = der.windows(15).filter(|w| w[0] == 0x17 && w[1] == 13 && w[14] == b'Z').collect();
        assert_eq!(times.len(), 2);
        let digits = std::str::from_utf8(&times[1][2..8]).unwrap();
        format!("20{}-{}-{}", &digits[..2], &digits[2..4], &digits[4..])
    }

    /// Authorities that end soon, or that older versions made for thirty years, are renewed at a start; certificates are for a year.
    #[test]
    fn an_authority_is_renewed_in_time_and_keeps_its_key() {
        let folder = tempfile::tempdir().unwrap();
        let names = ["127.0.0.1".to_owned()];
        let date = |in_days: i64| (now().unwrap() + time::Duration::days(in_days)).date().to_string();
        let (before, (cert, _)) = (date(CERTIFICATE_DAYS), own(folder.path(), &names).unwrap());
        assert!([before, date(CERTIFICATE_DAYS)].contains(&ends(&cert)), "{}", ends(&cert));
        let tls = |name: &str| folder.path().join("tls").join(name);
        let read = |name: &str| std::fs::read_to_string(tls(name)).unwrap();
        let key = read("ca.key");
        for (until, is_renewed) in [
            (Some(date(10)), true),
            (Some(date(-5)), true),
            (Some(date(RENEWED_DAYS + 2)), false),
            (Some(date(30 * 365)), true),
            (Some("soon".to_owned()), true),
            (None, true),
        ] {
            std::fs::write(tls("ca.pem"), "as it was").unwrap();
            match &until {
                Some(until) => std::fs::write(tls("ca.until"), until).unwrap(),
                None => std::fs::remove_file(tls("ca.until")).unwrap(),
            }
            own(folder.path(), &names).unwrap();
            assert_eq!(read("ca.pem") != "as it was", is_renewed, "{until:?}");
            if is_renewed {
                assert_eq!(ends(&read("ca.pem")), read("ca.until").trim());
                assert!(is_current(&read("ca.until"), now().unwrap()));
            }
        }
        assert_eq!(read("ca.key"), key);
    }
}
