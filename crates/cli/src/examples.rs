//! The example jobs that ship inside the program.

/// An example job.
pub(crate) struct Example {
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
}

macro_rules! examples {
    ($($name:literal),*) => {
        &[$(Example { name: $name, text: include_str!(concat!("../../../examples/", $name, ".toml")) }),*]
    };
}

/// All examples; the first is the one that runs without a verb.
pub(crate) const EXAMPLES: &[Example] = examples![
    "saddle",
    "head-nozzle",
    "ellipse",
    "tube-plate",
    "trunnion-saddle",
    "oblique-girth",
    "half-ring",
    "t-joint",
    "knuckle-nozzle",
    "set-in-nozzle",
    "y-branch",
    "taught-saddle",
    "hillside",
    "thick-saddle",
    "weave",
    "radiator"
];
