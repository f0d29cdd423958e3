//! Files that the user names: read, or written whole, as [`WholeFile`] does it.

use crate::failure::Failure;
use crate::file_scope::{FileRefusal, FileScope};
use seamwright_message::{Message, Unit};
use seamwright_record::{ClosedFile, WholeFile};
use std::fs;
use std::io::{BufWriter, Read as _, Write};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Maximum size of a file, bytes.
const MAX_BYTES: u64 = 1 << 30;

/// Maximum number of written files that are named one by one.
const MAX_NAMES: usize = 6;

/// Reads a text file that the user named.
pub fn read(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|e| unreadable(&path.display().to_string(), &e))
}

/// Reads a text file of at most `max` bytes: it may come from elsewhere, as in a restored archive.
pub fn read_up_to(path: &Path, max: u64) -> Result<String, Failure> {
    let failed = |e: &std::io::Error| unreadable(&path.display().to_string(), e);
    let mut bytes = Vec::new();
    let read = fs::File::open(path).and_then(|file| file.take(max + 1).read_to_end(&mut bytes));
    read.map_err(|e| failed(&e))?;
    if bytes.len() as u64 > max {
        let why = Message::new("project-file-above").quantity("max", (max >> 20) as f64, Unit::MiB, 0);
        let file = path.display().to_string();
        return Err(Failure::Input(Message::new("project-unreadable").text("file", file).message("why", why)));
    }
    String::from_utf8(bytes).map_err(|e| failed(&std::io::Error::new(std::io::ErrorKind::InvalidData, e)))
}

/// Reads a plain text file in `folder` or below, which a text from elsewhere names.
///
/// # Errors
/// A name that leads out of the folder, anything but a plain file of moderate size.
pub fn read_foreign(folder: &Path, name: &str) -> Result<String, Failure> {
    let failed = |e: std::io::Error| {
        Failure::Input(Message::new("project-unreadable").text("file", name).message("why", io_error(&e)))
    };
    let path = FileScope::fenced(folder).file(name).map_err(failed)?;
    fs::read_to_string(path).map_err(failed)
}

/// Failure of reading the file called `source`.
pub(crate) fn unreadable(source: &str, e: &std::io::Error) -> Failure {
    Failure::Input(Message::new("project-unreadable").text("file", source).message("why", io_error(e)))
}

/// The words of an error of the system, or of one of our own within it.
pub(crate) fn io_error(e: &std::io::Error) -> Message {
    let own = e.get_ref().and_then(|own| own.downcast_ref::<FileRefusal>());
    own.map_or_else(|| Message::outside(e), FileRefusal::message)
}

/// Reads a file of bytes, or standard input for `-`; `source` names it in messages.
pub fn read_bytes(path: &Path, source: &str) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let result = if source == "-" {
        std::io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes)
    } else {
        fs::File::open(path).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes))
    };
    result.map_err(|e| unreadable(source, &e))?;
    if bytes.len() as u64 > MAX_BYTES {
        let message = Message::new("project-file-too-large").text("file", source);
        return Err(Failure::refused(message, Message::new("project-up-to-1-gib")));
    }
    Ok(bytes)
}

/// Makes a folder and its missing parents, accessible to the owner only: write access to it would allow to change the
/// users.
pub fn make_private(folder: &Path) -> std::io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.recursive(true).create(folder)
}

/// Writes one file whole that only its owner may read; its folder must exist.
pub fn write_secret(path: &Path, text: &str) -> Result<(), Failure> {
    write_into(WholeFile::create_private(path), path, text)
}

/// Writes one file whole; its folder must exist.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    write_into(WholeFile::create(path), path, text)
}

fn write_into(file: std::io::Result<WholeFile>, path: &Path, text: &str) -> Result<(), Failure> {
    let failed = |e| not_writable(path, &e);
    let mut file = file.map_err(failed)?;
    file.write_all(text.as_bytes()).map_err(failed)?;
    file.finish().map_err(failed)
}

/// The same piece by piece: `fill` writes it.
pub fn write_with(path: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> Result<(), Failure> {
    fill_into(WholeFile::create(path), path, fill)
}

/// Writes one file whole that only its owner may read, piece by piece.
pub fn write_secret_with(path: &Path, fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure>) -> Result<(), Failure> {
    fill_into(WholeFile::create_private(path), path, fill)
}

fn fill_into(
    file: std::io::Result<WholeFile>,
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let failed = |e| not_writable(path, &e);
    let mut file = file.map_err(failed)?;
    let mut out = BufWriter::with_capacity(1 << 16, &mut file);
    fill(&mut out)?;
    out.flush().map_err(failed)?;
    drop(out);
    file.finish().map_err(failed)
}

/// Failure of writing at `path`: a wrong name is bad input, a disk that fails is not.
pub fn not_writable(path: &Path, e: &std::io::Error) -> Failure {
    use std::io::ErrorKind::{
        AlreadyExists, BrokenPipe, InvalidInput, IsADirectory, NotADirectory, NotFound, PermissionDenied,
        ReadOnlyFilesystem,
    };
    let message = Message::new("project-not-writable").text("file", path.display().to_string());
    // The error's own text may name our temporary file; those of invalid input are our own.
    let why = match e.kind() {
        BrokenPipe => return Failure::ReaderGone,
        NotFound => Message::new("project-no-such-folder"),
        PermissionDenied => Message::new("project-permission-denied"),
        NotADirectory | AlreadyExists => Message::new("project-not-a-folder"),
        IsADirectory => Message::new("project-is-a-folder"),
        ReadOnlyFilesystem => Message::outside(&e.kind()),
        InvalidInput => Message::outside(e),
        kind => return Failure::Environment(message.message("why", Message::outside(&kind))),
    };
    Failure::refused(message.message("why", why), Message::new("project-writable"))
}

/// Files that are named first where many were written.
const MAIN: [&str; 3] = ["report.html", "program.toml", "report.json"];

/// List of the files written, a line a folder: `61 files to out/saddle: report.html, program.toml and 59 more`.
pub fn written_text(paths: &[PathBuf]) -> Vec<String> {
    let mut folders: Vec<(&Path, Vec<String>)> = Vec::new();
    for path in paths {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        match folders.iter_mut().find(|(known, _)| *known == folder) {
            Some((_, names)) => names.push(name),
            None => folders.push((folder, vec![name])),
        }
    }
    folders.into_iter().map(|(folder, names)| folder_text(folder, names)).collect()
}

fn folder_text(folder: &Path, mut names: Vec<String>) -> String {
    if let [name] = names.as_slice() {
        return folder.join(name).display().to_string();
    }
    let count = names.len();
    names.sort_by_key(|name| MAIN.iter().position(|main| main == name).unwrap_or(MAIN.len()));
    let shown = if count > MAX_NAMES { MAIN.len() } else { count };
    let code = if shown < count { "project-files-written-more" } else { "project-files-written" };
    let text = Message::new(code).count("files", count).text("folder", folder.display().to_string());
    let text = text.text("names", names[..shown].join(", "));
    if shown < count { text.count("more", count - shown).to_string() } else { text.to_string() }
}

/// A folder that results go to, all at once when everything has been made.
pub struct Output {
    folder: PathBuf,
    /// Closed: a weld of many passes has more files than a program may have open.
    files: Vec<(ClosedFile, PathBuf)>,
}

impl Output {
    /// The folder, created if missing; fails at once if it is not writable.
    pub fn new(folder: &Path) -> Result<Self, Failure> {
        fs::create_dir_all(folder).map_err(|e| not_writable(folder, &e))?;
        let output = Self { folder: folder.to_owned(), files: Vec::new() };
        output.scratch()?;
        Ok(output)
    }

    /// A folder for unfinished files; it is removed with this value.
    pub fn scratch(&self) -> Result<TempDir, Failure> {
        let folder = tempfile::Builder::new().prefix(".seamwright-").tempdir_in(&self.folder);
        folder.map_err(|e| not_writable(&self.folder, &e))
    }

    /// Copies the file at `from` to `name`, replacing any file there.
    pub fn take(&mut self, name: &str, from: &Path) -> Result<(), Failure> {
        let mut source = fs::File::open(from).map_err(|e| unreadable(&from.display().to_string(), &e))?;
        self.fill(name, |file| std::io::copy(&mut source, file).map(drop))
    }

    /// Takes a text under its name.
    pub fn text(&mut self, name: &str, text: &str) -> Result<(), Failure> {
        self.fill(name, |file| file.write_all(text.as_bytes()))
    }

    /// Writes a file `name` with the output of `fill`.
    fn fill(&mut self, name: &str, fill: impl FnOnce(&mut WholeFile) -> std::io::Result<()>) -> Result<(), Failure> {
        let path = self.folder.join(name);
        // The name may lead into a folder of its own.
        let folder = path.parent().unwrap_or(&self.folder);
        fs::create_dir_all(folder).map_err(|e| not_writable(folder, &e))?;
        let mut file = WholeFile::create(&path).map_err(|e| not_writable(&path, &e))?;
        fill(&mut file).map_err(|e| not_writable(&path, &e))?;
        let closed = file.close().map_err(|e| not_writable(&path, &e))?;
        self.files.push((closed, path));
        Ok(())
    }

    /// Takes a copy of the file at `from` under `name`, unless it is that file; another file of that name is not
    /// touched.
    pub fn copy(&mut self, name: &str, from: &Path) -> Result<(), Failure> {
        let bytes = fs::read(from).map_err(|e| unreadable(&from.display().to_string(), &e))?;
        let to = self.folder.join(name);
        match fs::read(&to) {
            Ok(there) if there == bytes => Ok(()),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => self.fill(name, |file| file.write_all(&bytes)),
            _ => {
                let message = Message::new("project-other-file-there").text("file", to.display().to_string());
                let message = message.text("from", from.display().to_string());
                Err(Failure::refused(message, Message::new("project-other-folder")))
            }
        }
    }

    /// Gives every file its name; the paths written.
    pub fn finish(self) -> Result<Vec<PathBuf>, Failure> {
        let mut paths = Vec::new();
        for (file, path) in self.files {
            file.finish().map_err(|e| not_writable(&path, &e))?;
            paths.push(path);
        }
        Ok(paths)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_os = "linux")]
    #[test]
    fn files_that_wait_for_their_names_are_not_open() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().canonicalize().unwrap();
        let mut output = Output::new(&folder).unwrap();
        for i in 0..50 {
            output.text(&format!("pass-{i}.svg"), "x").unwrap();
        }
        let open = fs::read_dir("/proc/self/fd").unwrap().filter_map(|fd| fs::read_link(fd.ok()?.path()).ok());
        assert_eq!(open.filter(|path| path.starts_with(&folder)).count(), 0);
        assert!(!folder.join("pass-7.svg").exists());
        assert_eq!(output.finish().unwrap().len(), 50);
        assert_eq!(fs::read_to_string(folder.join("pass-7.svg")).unwrap(), "x");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 50);
    }

    #[test]
    fn a_text_from_elsewhere_is_read_up_to_its_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("job.toml");
        fs::write(&path, "x".repeat(1 << 20)).unwrap();
        assert_eq!(read_up_to(&path, 1 << 20).unwrap().len(), 1 << 20);
        fs::write(&path, "x".repeat((1 << 20) + 1)).unwrap();
        let refused = read_up_to(&path, 1 << 20).unwrap_err().message().to_string();
        assert!(refused.contains("job.toml") && refused.contains("larger than 1 MiB"), "{refused}");
        // Of a larger file no more than the limit is read.
        fs::File::create(&path).unwrap().set_len(1 << 34).unwrap();
        assert!(read_up_to(&path, 1 << 20).is_err());
        fs::write(&path, b"\xff").unwrap();
        assert!(read_up_to(&path, 10).is_err());
    }

    /// Backups have the hashes of passwords: other users must not read them, also where they replace a file of others.
    #[cfg(unix)]
    #[test]
    fn secrets_written_in_pieces_are_readable_by_their_owner_only() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cell.tar");
        for _ in 0..2 {
            write_secret_with(&path, |out| Ok(out.write_all(b"secret")?)).unwrap();
            assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o077, 0);
            fs::set_permissions(&path, fs::Permissions::from_mode(0o666)).unwrap();
        }
    }

    #[test]
    fn many_written_files_are_one_line_a_folder() {
        let many = (0..300).map(|i| Path::new("out").join(format!("pass-{i}-axes.svg")));
        let main =
            ["program.toml", "report.json", "report.html", "parts/shell.stl"].map(|name| Path::new("out").join(name));
        let paths: Vec<PathBuf> = many.chain(main).collect();
        let lines = written_text(&paths);
        let first = "303 files to out: report.html, program.toml, report.json and 300 more";
        assert_eq!(lines, [first, "out/parts/shell.stl"]);
        assert_eq!(written_text(&[PathBuf::from("a.csv"), PathBuf::from("b.csv")]), ["2 files to .: a.csv, b.csv"]);
    }
}
