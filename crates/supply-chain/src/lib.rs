//! Third-party packages of the program: the rules for them, the texts of their licences, the bill of materials.
//!
//! Used while building and testing; no part of the program. The build of the command line embeds what
//! [`notices()`] and [`bill_of_materials()`] return; `seamwright licences` prints it.
//!
//! | task | start at |
//! |---|---|
//! | which packages are in the program | [`Tree::of_program`] |
//! | rules for packages, and what violates them | [`Rules::violations`], `deny.toml` |
//! | checksums, sources, packages of the panel | [`CargoLock`], [`NpmLock`] |
//! | texts of licences | [`notices()`] |
//! | CycloneDX | [`bill_of_materials()`] |
//!
//! # Method
//!
//! The tree is that of `cargo tree`: it follows the features and the platform of a build. `cargo metadata` reports
//! packages of features that are off, too (28 of 285 here); it only gives the folders of the sources. Neither needs a
//! network once the packages are downloaded.
//!
//! # Limitations
//!
//! Licences are those that a package declares; `cargo deny` compares them with its files. Advisories need the database
//! of RustSec, so that only `cargo deny` checks them.

mod bill;
mod bundled;
mod cargo;
mod error;
mod licence_texts;
mod locks;
mod notices;
mod package_url;
mod rules;
mod tree;

pub use bill::bill_of_materials;
pub use bundled::Toolchain;
pub use cargo::{Cargo, Sources};
pub use error::Error;
pub use licence_texts::LicenceText;
pub use locks::{CargoLock, LockedPackage, NpmLock, NpmPackage};
pub use notices::{Notices, notices};
pub use rules::{Rule, Rules, Violation};
pub use tree::{Origin, Package, Tree};
