//! Detection of the journal of systemd.

/// Returns true if standard error is connected to the journal: `JOURNAL_STREAM` names its device and inode
/// (systemd.exec(5)).
#[cfg(unix)]
pub(crate) fn is_connected() -> bool {
    use std::os::fd::AsFd as _;
    use std::os::unix::fs::MetadataExt as _;
    let Ok(named) = std::env::var("JOURNAL_STREAM") else { return false };
    let own = std::io::stderr().as_fd().try_clone_to_owned().and_then(|own| std::fs::File::from(own).metadata());
    own.is_ok_and(|own| named == format!("{}:{}", own.dev(), own.ino()))
}

#[cfg(not(unix))]
pub(crate) fn is_connected() -> bool {
    false
}
