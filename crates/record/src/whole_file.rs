//! Files that are written whole or not at all: a temporary name, sync, rename.
//!
//! The user's name may exist already, and need not be a plain file. [`WholeFile`] follows symbolic links and keeps mode
//! and owner of a file that it replaces. It writes to pipes and character devices instead of putting a file in their
//! place.

use crate::error::{Doing, Error};
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::{NamedTempFile, TempPath};

/// Mode of a new file, less those bits that the user's umask takes away.
const MODE: u32 = 0o666;

/// Mode of a file that only its owner may read.
const PRIVATE_MODE: u32 = 0o600;

/// Maximum number of symbolic links that lead to one file, as in Linux.
const MAX_LINKS: usize = 40;

/// A file being written; [`WholeFile::finish`] gives it its name.
///
/// Dropped unfinished it leaves no file, and an existing file stays unchanged.
#[derive(Debug)]
pub struct WholeFile {
    file: NamedTempFile,
    destination: Destination,
}

/// A file that was written and synced, and closed; [`ClosedFile::finish`] gives it its name.
///
/// Dropped unfinished it leaves no file. Many of them wait for their names without a file handle each.
#[derive(Debug)]
pub struct ClosedFile {
    file: TempPath,
    destination: Destination,
}

/// Destination of a finished file.
#[derive(Debug)]
enum Destination {
    /// Takes this name, which is not a link, and replaces the file of that name.
    Replace(PathBuf),
    /// Is copied into this pipe, character device or open file.
    Stream(PathBuf),
}

impl WholeFile {
    /// Starts a file that will be called `path`; its folder must exist.
    ///
    /// # Errors
    /// If writing is impossible: no such folder, no permission, a folder, socket or block device of that name. Also a
    /// file whose owner cannot be kept.
    pub fn create(path: &Path) -> io::Result<Self> {
        Self::create_with(path, MODE)
    }

    /// Begins a file that only its owner may read, also where it replaces one that others may read.
    pub fn create_private(path: &Path) -> io::Result<Self> {
        Self::create_with(path, PRIVATE_MODE)
    }

    fn create_with(path: &Path, mode: u32) -> io::Result<Self> {
        let (destination, replaced) = resolve(path)?;
        let file = match &destination {
            Destination::Stream(_) => temporary(&std::env::temp_dir(), PRIVATE_MODE)?,
            Destination::Replace(path) => match replaced {
                None => temporary(folder_of(path), mode)?,
                Some(replaced) => temporary_like(path, &replaced, mode)?,
            },
        };
        Ok(Self { file, destination })
    }

    /// The open file.
    pub fn as_file_mut(&mut self) -> &mut File {
        self.file.as_file_mut()
    }

    /// Syncs the file and closes it; it has no name yet.
    pub fn close(self) -> io::Result<ClosedFile> {
        if matches!(self.destination, Destination::Replace(_)) {
            self.file.as_file().sync_all()?;
        }
        Ok(ClosedFile { file: self.file.into_temp_path(), destination: self.destination })
    }

    /// Syncs the file and gives it its name; a pipe or device gets all of it now.
    pub fn finish(self) -> io::Result<()> {
        self.close()?.finish()
    }
}

impl ClosedFile {
    /// Gives the file its name; a pipe or device gets all of it now.
    pub fn finish(self) -> io::Result<()> {
        match self.destination {
            Destination::Replace(path) => self.file.persist(path).map_err(|e| e.error),
            Destination::Stream(path) => {
                // Appends to a stream that is open already, such as standard output in a file.
                let mut stream = OpenOptions::new().append(true).open(path)?;
                io::copy(&mut File::open(&self.file)?, &mut stream)?;
                stream.flush()
            }
        }
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Follows the links of `path`. Returns the destination, and the file that it replaces.
fn resolve(path: &Path) -> io::Result<(Destination, Option<Metadata>)> {
    let mut path = path.to_owned();
    for _ in 0..MAX_LINKS {
        let Some(there) = not_missing(fs::symlink_metadata(&path))? else {
            return Ok((Destination::Replace(path), None));
        };
        if !there.is_symlink() {
            return destination(path, there);
        }
        if is_of_open_file(&path) {
            return Ok((Destination::Stream(path), None));
        }
        // A relative link counts from its own folder, an absolute one replaces the whole path.
        path = folder_of(&path).join(fs::read_link(&path)?);
    }
    Err(io::Error::other("too many symbolic links lead to it"))
}

/// Destination of a file whose name is in use by something other than a link.
fn destination(path: PathBuf, there: Metadata) -> io::Result<(Destination, Option<Metadata>)> {
    if there.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if is_stream(&there) {
        return Ok((Destination::Stream(path), None));
    }
    if !there.is_file() {
        return Err(refused("it is a block device or a socket"));
    }
    // A file that no program may write is not replaced either.
    OpenOptions::new().write(true).open(&path)?;
    Ok((Destination::Replace(path), Some(there)))
}

/// A reason of our own not to write, which the user can mend.
fn refused(why: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, why)
}

fn not_missing(found: io::Result<Metadata>) -> io::Result<Option<Metadata>> {
    match found {
        Ok(found) => Ok(Some(found)),
        Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(e) => Err(e),
    }
}

/// Returns whether a link refers to a file that a process has open, as `/dev/stdout` does in the end. Its name leads to
/// the open file, and replacing that would leave the process with one that has no name.
fn is_of_open_file(link: &Path) -> bool {
    folder_of(link).canonicalize().is_ok_and(|folder| folder.starts_with("/proc"))
}

#[cfg(unix)]
fn is_stream(there: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    let kind = there.file_type();
    kind.is_fifo() || kind.is_char_device()
}

#[cfg(not(unix))]
fn is_stream(_: &Metadata) -> bool {
    false
}

/// A temporary file beside `path` with mode and owner of the one that it will replace, but no more of `mode` than that.
#[cfg(unix)]
fn temporary_like(path: &Path, replaced: &Metadata, mode: u32) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, fchown};
    // The file has its final mode before others can read it.
    let file = temporary(folder_of(path), PRIVATE_MODE)?;
    let ours = file.as_file().metadata()?;
    if (ours.uid(), ours.gid()) != (replaced.uid(), replaced.gid()) {
        fchown(file.as_file(), Some(replaced.uid()), Some(replaced.gid()))
            .map_err(|_| refused("it belongs to another user or group, which a file in its place would not"))?;
    }
    let kept = replaced.mode() & if mode == PRIVATE_MODE { PRIVATE_MODE } else { 0o777 };
    file.as_file().set_permissions(fs::Permissions::from_mode(kept))?;
    Ok(file)
}

#[cfg(not(unix))]
fn temporary_like(path: &Path, _: &Metadata, mode: u32) -> io::Result<NamedTempFile> {
    temporary(folder_of(path), mode)
}

/// A temporary file in `folder` with this mode, less those bits that the user's umask takes away.
fn temporary(folder: &Path, mode: u32) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(mode));
    #[cfg(not(unix))]
    let _ = mode;
    builder.prefix(".seamwright-").tempfile_in(folder)
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Starts the file `path` of a data folder: readable by its owner only, regardless of the folder's permissions.
pub(crate) fn create(path: &Path) -> Result<WholeFile, Error> {
    WholeFile::create_private(path).map_err(|e| Error::io(path, Doing::Write, e))
}

/// Gives a written file of a data folder its name, for good.
pub(crate) fn finish(file: WholeFile, path: &Path) -> Result<(), Error> {
    file.finish().map_err(|e| Error::io(path, Doing::Write, e))?;
    sync_folder(path)
}

/// Makes the names in the folder of `path` last; where folders cannot be synced they last by themselves.
pub(crate) fn sync_folder(path: &Path) -> Result<(), Error> {
    if cfg!(unix) {
        let folder = folder_of(path);
        let synced = File::open(folder).and_then(|folder| folder.sync_all());
        synced.map_err(|e| Error::io(folder, Doing::Write, e))?;
    }
    Ok(())
}
