//! Files and folders that only their owner can read, regardless of the permissions of the folder around them.

#[cfg(unix)]
use std::fs;
use std::fs::{DirBuilder, OpenOptions};
use std::path::Path;

/// Makes a folder and those above it, as far as they are missing.
pub(crate) fn folder(path: &Path) -> std::io::Result<()> {
    let mut builder = DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(path)
}

/// Options to open files; new ones are readable by the owner only.
pub(crate) fn options() -> OpenOptions {
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}

/// Takes the rights of others away from a file or folder, if it exists. The contents of a folder that others may enter
/// come before it, so that a second call costs one look. Links in folders are left alone.
#[cfg(unix)]
pub(crate) fn tighten(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    let Ok(there) = fs::metadata(path) else { return Ok(()) };
    let mode = there.permissions().mode();
    if mode & 0o077 == 0 {
        return Ok(());
    }
    if there.is_dir() {
        for entry in fs::read_dir(path)? {
            let entry = entry?;
            if !entry.file_type()?.is_symlink() {
                tighten(&entry.path())?;
            }
        }
    }
    fs::set_permissions(path, fs::Permissions::from_mode(mode & 0o700))
}

/// No effect on systems whose files have no such modes.
#[cfg(not(unix))]
pub(crate) fn tighten(_: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Reserves room on the disk behind the first `from` bytes of a file, whose length stays. File systems that cannot reserve
/// are no error.
#[cfg(target_os = "linux")]
pub(crate) fn reserve(file: &std::fs::File, from: u64, bytes: u64) -> std::io::Result<()> {
    use rustix::fs::{FallocateFlags, fallocate};
    use rustix::io::Errno;
    match fallocate(file, FallocateFlags::KEEP_SIZE, from, bytes.max(1)) {
        Ok(()) | Err(Errno::OPNOTSUPP | Errno::NOSYS) => Ok(()),
        Err(e) => Err(e.into()),
    }
}

/// No effect on systems without `fallocate`.
#[cfg(not(target_os = "linux"))]
pub(crate) fn reserve(_: &std::fs::File, _: u64, _: u64) -> std::io::Result<()> {
    Ok(())
}
