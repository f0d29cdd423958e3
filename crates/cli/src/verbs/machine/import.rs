use super::arm_file::{folder_of, write_arm};
use crate::args::arm::{ImportArgs, Package};
use crate::verbs::positive;
use seamwright_machine::{FoundMesh, ImportOptions, ImportedArm};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

/// Maximum size of a URDF file, bytes.
const MAX_BYTES: u64 = 64 << 20;
/// Prefix of names of files in a package.
const PACKAGE: &str = "package://";

pub(crate) fn run(args: &ImportArgs) -> Result<(), Failure> {
    let scale = positive("--scale", args.scale)?;
    let text = files::read_up_to(&args.file, MAX_BYTES)?;
    let meshes = Meshes {
        beside: folder_of(&args.file).to_owned(),
        packages: &args.package,
        from: args.arm.output.as_deref().map_or(Path::new("."), folder_of),
        found: RefCell::default(),
    };
    let options = ImportOptions {
        base: args.base.as_deref(),
        tip: args.tip.as_deref(),
        scale,
        with_shapes: !args.no_shapes,
        find_mesh: &|name| meshes.find(name),
    };
    let mut arm = ImportedArm::from_urdf(&args.file.display().to_string(), &text, &options)?;
    let file = args.file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    arm.source = format!("URDF file {file}, robot {}", arm.title);
    write_arm(arm, &args.arm, &|name| {
        let found = meshes.found.borrow();
        found.get(name).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
    })
}

/// Meshes that a URDF file names.
struct Meshes<'a> {
    /// Folder of the URDF file.
    beside: PathBuf,
    packages: &'a [Package],
    /// Folder of the machine file.
    from: &'a Path,
    /// Content of those found, by their names in the machine file.
    found: RefCell<BTreeMap<String, Vec<u8>>>,
}

impl Meshes<'_> {
    fn find(&self, name: &str) -> Result<FoundMesh, Vec<String>> {
        let places = self.places(name);
        let read = |path: &PathBuf| std::fs::read(path).ok().map(|bytes| (relative(self.from, path), bytes));
        let Some((name, bytes)) = places.iter().find_map(read) else {
            return Err(places.iter().map(|path| path.display().to_string()).collect());
        };
        self.found.borrow_mut().insert(name.clone(), bytes.clone());
        Ok(FoundMesh { name, bytes })
    }

    /// Paths that a name may mean: in the given folder of its package, or in a folder of that name around the file.
    fn places(&self, name: &str) -> Vec<PathBuf> {
        let Some(in_package) = name.strip_prefix(PACKAGE) else {
            return vec![self.beside.join(name.strip_prefix("file://").unwrap_or(name))];
        };
        let (package, path) = in_package.split_once('/').unwrap_or((in_package, ""));
        let given = self.packages.iter().filter(|given| given.name == package).map(|given| given.folder.join(path));
        let beside = self.beside.canonicalize().unwrap_or_else(|_| self.beside.clone());
        let around = beside.ancestors().map(|folder| match folder.file_name() {
            Some(name) if name == package => folder.join(path),
            _ => folder.join(package).join(path),
        });
        let mut places: Vec<PathBuf> = given.collect();
        if places.is_empty() {
            places.extend(around.take(MAX_FOLDERS));
        }
        places
    }
}

/// Folders upwards that may hold a package.
const MAX_FOLDERS: usize = 5;

/// Name of the file at `path` as seen from `folder`; absolute if one of them cannot be resolved.
fn relative(folder: &Path, path: &Path) -> String {
    let plain = || path.to_string_lossy().into_owned();
    let (Ok(folder), Ok(path)) = (folder.canonicalize(), path.canonicalize()) else { return plain() };
    let common = folder.components().zip(path.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| Component::ParentDir);
    up.chain(path.components().skip(common)).collect::<PathBuf>().to_string_lossy().into_owned()
}
