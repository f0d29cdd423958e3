//! Encrypted connections, with certificates of the user or of the cell's own authority.

use crate::error::Error;
use rcgen::{
    BasicConstraints, CertificateParams, DistinguishedName, DnType, ExtendedKeyUsagePurpose, IsCa, Issuer, KeyPair,
    KeyUsagePurpose,
};
use rustls::ServerConfig;
use rustls::crypto::ring;
use rustls::pki_types::pem::PemObject as _;
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use seamwright_log as log;
use seamwright_message::Message;
use seamwright_project::failure::with_allowed;
use seamwright_project::files;
use seamwright_record::Moment;
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError, RwLock};
use std::time::Duration;
use time::OffsetDateTime;

/// Source of the certificate.
#[derive(Debug, Clone)]
pub enum Tls {
    /// Own authority in the data folder. Browsers trust it once its `tls/ca.pem` is installed there.
    Own,
    /// PEM files of the user: chain and key.
    Files {
        /// The certificate, followed by its chain.
        cert: PathBuf,
        /// Its private key.
        key: PathBuf,
    },
}

/// Validity of the authority, days: ten years. A start renews it, with the same key, if less than [`RENEWED_DAYS`] are
/// left.
const AUTHORITY_DAYS: i64 = 3652;
const RENEWED_DAYS: i64 = 420;
/// Validity of a certificate, days: the maximum that browsers accept, less a day for clocks that differ.
const CERTIFICATE_DAYS: i64 = 397;
/// Renewal period of the certificate of a running panel.
const ANEW: Duration = Duration::from_secs(30 * 24 * 3600);

fn wrong(e: &impl std::fmt::Display) -> Error {
    Error::System(Message::new("server-certificate-failed").message("why", Message::outside(e)))
}

/// Configuration of new encrypted connections; it is replaced when the certificate is renewed.
#[derive(Clone)]
pub(crate) struct Encryption(Arc<RwLock<Arc<ServerConfig>>>);

impl Encryption {
    pub(crate) fn current(&self) -> Arc<ServerConfig> {
        Arc::clone(&self.0.read().unwrap_or_else(PoisonError::into_inner))
    }

    fn replace(&self, config: ServerConfig) {
        *self.0.write().unwrap_or_else(PoisonError::into_inner) = Arc::new(config);
    }
}

pub(crate) async fn encryption(tls: &Tls, data: &Path, names: &[String]) -> Result<Encryption, Error> {
    let config = config(tls, data, names).await?;
    Ok(Encryption(Arc::new(RwLock::new(Arc::new(config)))))
}

async fn config(tls: &Tls, data: &Path, names: &[String]) -> Result<ServerConfig, Error> {
    // Keys and files take time; a blocking thread keeps stops from waiting for them.
    let (tls, data, names) = (tls.clone(), data.to_owned(), names.to_vec());
    let made = tokio::task::spawn_blocking(move || match &tls {
        Tls::Files { cert, key } => of_files(cert, key).map_err(|why| {
            let options = format!("--cert {} --key {}", cert.display(), key.display());
            let message = Message::new("server-certificate-files").text("options", options);
            let message = message.message("why", Message::verbatim(why));
            Error::Settings(with_allowed(message, Message::new("server-pem-files")))
        }),
        Tls::Own => {
            let (cert, key) = own(&data, &names)?;
            of_pem(["certificate", "key"], cert.as_bytes(), key.as_bytes()).map_err(|why| wrong(&why))
        }
    });
    made.await.map_err(|e| wrong(&e))?
}

/// Reads the configuration from PEM files of the user. The error says why it is not possible, in the words of the
/// system or the library.
fn of_files(cert: &Path, key: &Path) -> Result<ServerConfig, String> {
    let read = |path: &Path| std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()));
    let names = [cert, key].map(|path| path.display().to_string());
    of_pem([&names[0], &names[1]], &read(cert)?, &read(key)?)
}

/// Returns the configuration for a chain of certificates and its key, both PEM, with the names of both in errors.
fn of_pem(names: [&str; 2], cert: &[u8], key: &[u8]) -> Result<ServerConfig, String> {
    let chain: Result<Vec<_>, _> = CertificateDer::pem_slice_iter(cert).collect();
    let chain = chain.map_err(|e| format!("{}: {e}", names[0]))?;
    let key = PrivateKeyDer::from_pem_slice(key).map_err(|e| format!("{}: {e}", names[1]))?;
    let builder = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()));
    let builder = builder.with_safe_default_protocol_versions().map_err(|e| e.to_string())?;
    let mut config = builder.with_no_client_auth().with_single_cert(chain, key).map_err(|e| e.to_string())?;
    // Browsers use HTTP/2 if it is offered. Then they send no `host` header and do not upgrade to a WebSocket.
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(config)
}

/// Renews the cell's own certificate for new connections, until the task is aborted.
pub(crate) async fn renew(current: Encryption, data: PathBuf, names: Vec<String>) {
    loop {
        tokio::time::sleep(ANEW).await;
        match config(&Tls::Own, &data, &names).await {
            Ok(new) => current.replace(new),
            Err(e) => log::warn(&Message::new("server-log-certificate-fails").message("reason", e.message())),
        }
    }
}

/// Issues a certificate for `names` from the cell's own authority. Returns certificate and key, both PEM.
fn own(data: &Path, names: &[String]) -> Result<(String, String), Error> {
    let folder = data.join("tls");
    files::make_private(&folder).map_err(|e| Error::System(files::not_writable(&folder, &e).message()))?;
    let failed = |e: seamwright_project::Failure| Error::System(e.message());
    let (key_file, cert_file) = (folder.join("ca.key"), folder.join("ca.pem"));
    let ca_key = if key_file.is_file() {
        let key = KeyPair::from_pem(&files::read(&key_file).map_err(failed)?);
        key.map_err(|e| wrong(&format!("{}: {e}", key_file.display())))?
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
    // The end of validity is stored beside it. Authorities of older versions, valid for thirty years, lack this file.
    let until_file = folder.join("ca.until");
    let known = if cert_file.is_file() { std::fs::read_to_string(&until_file).ok() } else { None };
    if known.as_deref().is_none_or(|until| !is_current(until, now)) {
        let cert = authority.self_signed(&ca_key).map_err(|e| wrong(&e))?;
        files::write(&cert_file, &cert.pem()).map_err(failed)?;
        let until = authority.not_after.date();
        files::write(&until_file, &format!("{until}\n")).map_err(failed)?;
        let made = Message::new("server-log-authority").text("until", until.to_string());
        log::info(&made.text("file", cert_file.display().to_string()));
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

fn now() -> Result<OffsetDateTime, Error> {
    OffsetDateTime::from_unix_timestamp(Moment::now().0.div_euclid(1000)).map_err(|e| wrong(&e))
}

/// Validity from one day ago, since clocks differ, until `days` from now.
fn days(now: OffsetDateTime, days: i64) -> (OffsetDateTime, OffsetDateTime) {
    (now - time::Duration::days(1), now + time::Duration::days(days))
}

/// Returns true if an authority valid until this date (`YYYY-MM-DD`) lasts long enough, and no longer than
/// [`AUTHORITY_DAYS`].
fn is_current(until: &str, now: OffsetDateTime) -> bool {
    let until = until.trim().parse::<Moment>().map(|until| until.0.div_euclid(1000));
    let left = until.map(|until| (until - now.unix_timestamp()) / (24 * 3600));
    left.is_ok_and(|left| (RENEWED_DAYS..=AUTHORITY_DAYS).contains(&left))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The authority stays, every start issues a new certificate, and only the owner can read keys.
    #[tokio::test]
    async fn the_cell_is_its_own_authority() {
        let folder = tempfile::tempdir().unwrap();
        let names = ["127.0.0.1".to_owned(), "cell.shop".to_owned()];
        let offered = config(&Tls::Own, folder.path(), &names).await.unwrap();
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
        // Errors name the file: one that is missing, or no PEM.
        let at = |name: &str| folder.path().join(name);
        let why = async |tls: Tls| config(&tls, folder.path(), &names).await.unwrap_err().to_string();
        let key = at("tls/ca.key");
        assert!(why(Tls::Files { cert: at("no.pem"), key: key.clone() }).await.contains("no.pem: "));
        std::fs::write(at("broken.key"), "-----BEGIN PRIVATE KEY-----\nno\n").unwrap();
        assert!(why(Tls::Files { cert: at("tls/ca.pem"), key: at("broken.key") }).await.contains("broken.key: "));
        std::fs::write(&key, "no key").unwrap();
        assert!(why(Tls::Own).await.contains("ca.key: "));
    }

    /// Returns the end of validity of a certificate from its DER: the second of two times (UTCTime, X.690 8.26).
    fn ends(pem: &str) -> String {
        let der = CertificateDer::from_pem_slice(pem.as_bytes()).unwrap();
        let times: Vec<&[u8]> = der.windows(15).filter(|w| w[0] == 0x17 && w[1] == 13 && w[14] == b'Z').collect();
        assert_eq!(times.len(), 2);
        let digits = std::str::from_utf8(&times[1][2..8]).unwrap();
        format!("20{}-{}-{}", &digits[..2], &digits[2..4], &digits[4..])
    }

    /// A start renews authorities that end soon or were made by older versions for thirty years. Certificates last a
    /// year.
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
