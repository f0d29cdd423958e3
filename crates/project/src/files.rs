//! Files written whole: under a temporary name in the same folder, synced, then renamed.

use crate::failure::Failure;
use std::fs;
use std::io::{BufWriter, Read as _, Write};
use std::path::{Path, PathBuf};
use tempfile::{NamedTempFile, TempDir};

/// Most bytes of a file.
const MOST_BYTES: u64 = 1 << 30;

/// Reads a text file that the user named.
pub fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|e| Failure::Input(format!("{}: cannot be read: {e}", path.display())))
}

/// Reads a file of bytes, or standard input for `-`; `source` names it in messages.
pub fn read_bytes(path: &Path, source: &str) -> Result<Vec<u8>, Failure> {
    let unreadable = |e: &std::io::Error| Failure::Input(format!("{source}: cannot be read: {e}"));
    let mut bytes = Vec::new();
    let result = if source == "-" {
        std::io::stdin().lock().take(MOST_BYTES + 1).read_to_end(&mut bytes)
    } else {
        fs::File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes))
    };
    result.map_err(|e| unreadable(&e))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(Failure::Input(format!("{source}: the file is too large\n   allowed: up to 1 GiB")));
    }
    Ok(bytes)
}

/// Makes a folder and those above it where they are missing, its owner's alone: who may write there could change who may weld.
pub fn make_private(folder: &Path) -> std::io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(folder)
}

/// A temporary file in `folder` with these permissions, less those that the user never gives.
fn temporary_with(folder: &Path, mode: u32) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(mode));
    #[cfg(not(unix))]
    let _ = mode;
    builder.prefix(".seamwright-").tempfile_in(folder)
}

/// A temporary file in `folder` with the permissions that a new file of the user's has.
fn temporary(folder: &Path) -> std::io::Result<NamedTempFile> {
    temporary_with(folder, 0o666)
}

/// Writes one file whole that only its owner may read; its folder must exist.
pub fn write_secret(path: &Path, text: &str) -> Result<(), Failure> {
    write_as(path, text, 0o600)
}

/// Writes one file whole; its folder must exist.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    write_as(path, text, 0o666)
}

fn write_as(path: &Path, text: &str, mode: u32) -> Result<(), Failure> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut file = temporary_with(folder, mode).map_err(|e| not_writable(folder, &e))?;
    file.write_all(text.as_bytes()).map_err(|e| not_writable(path, &e))?;
    keep(file, path)
}

/// The same piece by piece: `fill` writes it.
pub fn write_with(path: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> Result<(), Failure> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut file = temporary(folder).map_err(|e| not_writable(folder, &e))?;
    let mut out = BufWriter::with_capacity(1 << 16, &mut file);
    fill(&mut out)?;
    out.flush().map_err(|e| not_writable(path, &e))?;
    drop(out);
    keep(file, path)
}

fn keep(file: NamedTempFile, path: &Path) -> Result<(), Failure> {
    file.as_file().sync_all().map_err(|e| not_writable(path, &e))?;
    file.persist(path).map(drop).map_err(|e| not_writable(path, &e.error))
}

fn not_writable(path: &Path, e: &std::io::Error) -> Failure {
    use std::io::ErrorKind::{
        AlreadyExists, IsADirectory, NotADirectory, NotFound, PermissionDenied, ReadOnlyFilesystem,
    };
    if !matches!(
        e.kind(),
        AlreadyExists | IsADirectory | NotADirectory | NotFound | PermissionDenied | ReadOnlyFilesystem
    ) {
        return Failure::Environment(format!("{}: cannot be written: {}", path.display(), e.kind()));
    }
    // The error's own text names our temporary file.
    let why = match e.kind() {
        std::io::ErrorKind::NotFound => "there is no such folder".to_owned(),
        std::io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        std::io::ErrorKind::NotADirectory | std::io::ErrorKind::AlreadyExists => "it is not a folder".to_owned(),
        std::io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        kind => kind.to_string(),
    };
    let allowed = "a folder or file that you may write";
    Failure::Input(format!("{}: cannot be written: {why}\n   allowed: {allowed}", path.display()))
}

/// A folder that results go to, all at once when everything has been made.
pub struct Output {
    folder: PathBuf,
    files: Vec<(NamedTempFile, PathBuf)>,
}

impl Output {
    /// The folder, made if missing; fails at once if nothing can be written there.
    pub fn new(folder: &Path) -> Result<Self, Failure> {
        fs::create_dir_all(folder).map_err(|e| not_writable(folder, &e))?;
        temporary(folder).map_err(|e| not_writable(folder, &e))?;
        Ok(Self { folder: folder.to_owned(), files: Vec::new() })
    }

    /// A file to be written piece by piece; give it back with [`Output::add`].
    pub fn open(&self) -> Result<NamedTempFile, Failure> {
        temporary(&self.folder).map_err(|e| not_writable(&self.folder, &e))
    }

    /// Takes a written file under its name.
    pub fn add(&mut self, name: &str, file: NamedTempFile) {
        self.files.push((file, self.folder.join(name)));
    }

    /// A folder for what is not finished; it goes with this value.
    pub fn scratch(&self) -> Result<TempDir, Failure> {
        let folder = tempfile::Builder::new().prefix(".seamwright-").tempdir_in(&self.folder);
        folder.map_err(|e| not_writable(&self.folder, &e))
    }

    /// Takes a copy of the file at `from` under `name`, whatever stands there.
    pub fn take(&mut self, name: &str, from: &Path) -> Result<(), Failure> {
        let unreadable = |e| Failure::Input(format!("{}: cannot be read: {e}", from.display()));
        let mut source = fs::File::open(from).map_err(unreadable)?;
        let mut file = self.open()?;
        std::io::copy(&mut source, &mut file).map_err(|e| not_writable(&self.folder, &e))?;
        self.add(name, file);
        Ok(())
    }

    /// Takes a text under its name.
    pub fn text(&mut self, name: &str, text: &str) -> Result<(), Failure> {
        let mut file = self.open()?;
        file.write_all(text.as_bytes()).map_err(|e| not_writable(&self.folder, &e))?;
        self.add(name, file);
        Ok(())
    }

    /// Takes a copy of the file at `from` under `name`, unless it is that file; another file of that name is not
    /// touched.
    pub fn copy(&mut self, name: &str, from: &Path) -> Result<(), Failure> {
        let bytes = fs::read(from).map_err(|e| Failure::Input(format!("{}: cannot be read: {e}", from.display())))?;
        let to = self.folder.join(name);
        match fs::read(&to) {
            Ok(there) if there == bytes => Ok(()),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => {
                // The name may lead into a folder of its own.
                let folder = to.parent().unwrap_or(&self.folder);
                fs::create_dir_all(folder).map_err(|e| not_writable(folder, &e))?;
                let mut file = temporary(folder).map_err(|e| not_writable(folder, &e))?;
                file.write_all(&bytes).map_err(|e| not_writable(folder, &e))?;
                self.add(name, file);
                Ok(())
            }
            _ => Err(Failure::Input(format!(
                "{}: another file stands where the copy of {} should go\n   allowed: another output folder",
                to.display(),
                from.display()
            ))),
        }
    }

    /// Gives every file its name; the paths written.
    pub fn finish(self) -> Result<Vec<PathBuf>, Failure> {
        if let Some((_, path)) = self.files.iter().find(|(_, path)| path.is_dir()) {
            return Err(not_writable(path, &std::io::ErrorKind::IsADirectory.into()));
        }
        let mut paths = Vec::new();
        for (file, path) in self.files {
            keep(file, &path)?;
            paths.push(path);
        }
        Ok(paths)
    }
}
