//! A written file replaces a plain file only, and leaves links, modes, owners, pipes and devices unchanged.

use rustix::fs::{CWD, FileType, Mode, makedev, mknodat};
use seamwright_record::WholeFile;
use std::fs::{self, Metadata, Permissions};
use std::io::{self, ErrorKind, Write as _};
use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _, chown, symlink};
use std::os::unix::net::UnixListener;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn write(path: &Path) -> io::Result<()> {
    let mut file = WholeFile::create(path)?;
    file.write_all(b"new")?;
    file.finish()
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(path).unwrap()
}

fn mode(path: &Path) -> u32 {
    fs::metadata(path).unwrap().mode() & 0o777
}

/// Names in a folder, to check that no temporary file is left.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// A folder with `name` in it, made by mknod.
fn node(kind: FileType, major_minor: (u32, u32)) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("node");
    let mode = Mode::RUSR | Mode::WUSR;
    mknodat(CWD, &path, kind, mode, makedev(major_minor.0, major_minor.1)).unwrap();
    (folder, path)
}

fn is_root() -> bool {
    rustix::process::geteuid().is_root()
}

#[test]
fn a_pipe_gets_the_bytes_and_stays_a_pipe() {
    let (folder, pipe) = node(FileType::Fifo, (0, 0));
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || read(pipe)
    });
    write(&pipe).unwrap();
    assert_eq!(reader.join().unwrap(), "new");
    assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    assert_eq!(names(folder.path()), ["node"]);
}

#[test]
fn a_character_device_stays_a_device() {
    // Only root can create a device; `/dev/null` exists for all, and no file may be left beside it either.
    write(Path::new("/dev/null")).unwrap();
    assert!(fs::symlink_metadata("/dev/null").unwrap().file_type().is_char_device());
    if is_root() {
        let (_folder, null) = node(FileType::CharacterDevice, (1, 3));
        // A sandbox may forbid to open it: then there is an error, and no file instead of it.
        drop(write(&null));
        assert!(fs::symlink_metadata(&null).unwrap().file_type().is_char_device());
    }
}

#[test]
fn a_block_device_and_a_socket_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let socket = folder.path().join("socket");
    let _listener = UnixListener::bind(&socket).unwrap();
    assert_eq!(write(&socket).unwrap_err().kind(), ErrorKind::InvalidInput);
    assert!(fs::symlink_metadata(&socket).unwrap().file_type().is_socket());
    if is_root() {
        // A number that no disk has.
        let (_folder, disk) = node(FileType::BlockDevice, (240, 77));
        assert_eq!(write(&disk).unwrap_err().kind(), ErrorKind::InvalidInput);
        assert!(fs::symlink_metadata(&disk).unwrap().file_type().is_block_device());
    }
}

#[test]
fn links_are_followed_and_stay() {
    let folder = tempfile::tempdir().unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let target = elsewhere.path().join("target");
    fs::write(&target, "old").unwrap();
    symlink(&target, at("absolute")).unwrap();
    symlink("absolute", at("of a link")).unwrap();
    write(&at("of a link")).unwrap();
    assert_eq!(read(&target), "new");
    // A link whose target is missing makes it.
    let missing = elsewhere.path().join("missing");
    symlink(&missing, at("dangling")).unwrap();
    write(&at("dangling")).unwrap();
    assert_eq!(read(&missing), "new");
    for name in ["absolute", "of a link", "dangling"] {
        assert!(fs::symlink_metadata(at(name)).unwrap().is_symlink(), "{name}");
    }
    assert_eq!(names(elsewhere.path()), ["missing", "target"]);
    // Dangling links are refused and stay too.
    symlink("no folder/file", at("nowhere")).unwrap();
    assert_eq!(write(&at("nowhere")).unwrap_err().kind(), ErrorKind::NotFound);
    symlink("round", at("round")).unwrap();
    assert!(write(&at("round")).is_err());
    assert!(fs::symlink_metadata(at("round")).unwrap().is_symlink());
}

#[test]
fn an_open_file_of_a_process_is_appended_to() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("redirected");
    let mut open = fs::File::create(&path).unwrap();
    open.write_all(b"head ").unwrap();
    let link = format!("/proc/self/fd/{}", std::os::fd::AsRawFd::as_raw_fd(&open));
    let inode = open.metadata().unwrap().ino();
    write(Path::new(&link)).unwrap();
    assert_eq!((read(&path).as_str(), fs::metadata(&path).unwrap().ino()), ("head new", inode));
}

#[test]
fn mode_and_owner_of_what_is_replaced_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    for kept in [0o600, 0o640, 0o664, 0o755] {
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(kept)).unwrap();
        write(&path).unwrap();
        assert_eq!((read(&path).as_str(), mode(&path)), ("new", kept), "{kept:o}");
    }
    // A private file stays private when it replaces a public one.
    let secret = WholeFile::create_private(&path).unwrap();
    secret.finish().unwrap();
    assert_eq!(mode(&path), 0o600);
    if is_root() {
        chown(&path, Some(12_345), Some(54_321)).unwrap();
        write(&path).unwrap();
        let owner = |m: &Metadata| (m.uid(), m.gid());
        assert_eq!(owner(&fs::metadata(&path).unwrap()), (12_345, 54_321));
    }
}

#[test]
fn what_may_not_be_written_is_refused_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("folder");
    fs::create_dir(&inside).unwrap();
    assert_eq!(write(&inside).unwrap_err().kind(), ErrorKind::IsADirectory);
    assert_eq!(write(&folder.path().join("none/file")).unwrap_err().kind(), ErrorKind::NotFound);
    // Permissions do not hold root back.
    if !is_root() {
        let protected = folder.path().join("protected");
        fs::write(&protected, "old").unwrap();
        fs::set_permissions(&protected, Permissions::from_mode(0o444)).unwrap();
        assert_eq!(write(&protected).unwrap_err().kind(), ErrorKind::PermissionDenied);
        assert_eq!(read(&protected), "old");
        fs::set_permissions(&inside, Permissions::from_mode(0o555)).unwrap();
        assert_eq!(write(&inside.join("file")).unwrap_err().kind(), ErrorKind::PermissionDenied);
    }
}

#[test]
fn an_unfinished_file_leaves_the_old_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file");
    fs::write(&path, "old").unwrap();
    let mut file = WholeFile::create(&path).unwrap();
    file.write_all(b"new").unwrap();
    drop(file);
    assert_eq!(read(&path), "old");
    assert_eq!(names(folder.path()), ["file"]);
}
