/// A machine file that ships with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shipped {
    /// Name used in job files.
    pub name: &'static str,
    /// The file's text.
    pub text: &'static str,
}

macro_rules! ship {
    ($($name:literal),*) => {
        &[$(Shipped { name: $name, text: include_str!(concat!("../../../machines/", $name, ".toml")) }),*]
    };
}

/// All machine files that ship.
pub const SHIPPED: &[Shipped] = ship![
    "saddle-4axis",
    "torch-5axis",
    "ebw-7axis",
    "dual-laser-10axis",
    "ellipse-xy",
    "table-tilting-xyzac",
    "ur10e",
    "irb-2600",
    "kr-16",
    "arc-mate-120id",
    "ar1440",
    "ur10e-positioner",
    "irb-2600-positioner",
    "kr-16-positioner",
    "arc-mate-120id-positioner",
    "ar1440-positioner",
    "irb-2600-rail",
    "iiwa-14",
    "column-boom"
];

/// The shipped machine file called `name`.
pub fn shipped(name: &str) -> Option<Shipped> {
    SHIPPED.iter().copied().find(|s| s.name == name)
}
