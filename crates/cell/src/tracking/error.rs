/// Why a weld cannot be tracked in simulation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The machine's drives.
    #[error(transparent)]
    Cell(Box<crate::Error>),
    /// A head has no cross slide to correct with.
    #[error("head {head} of machine {machine} has no cross slide: two linear axes of its own")]
    NoSlide {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// Nothing on the machine sees the joint ahead of a head.
    #[error(
        "machine {machine} has no stripe sensor for head {head}: tracking needs one ahead of the torch; \
         allowed is [sensors.<name>] with kind = \"stripe\" in the machine file"
    )]
    NoSensor {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// The best sensor of a head does not lead it all along a pass.
    #[error(
        "sensor {sensor} of {machine} does not lead head {head} along this pass: it is {:.1} to {:.1} mm ahead; allowed is a lead \
         that stays the same within a tenth, as of a sensor that turns with the seam",
        ahead_mm[0], ahead_mm[1]
    )]
    NotLeading {
        /// Name of the machine.
        machine: String,
        /// Name of the sensor.
        sensor: String,
        /// Counted from 1.
        head: usize,
        /// Least and greatest.
        ahead_mm: [f64; 2],
    },
    /// A torch that does not go along the seam's line.
    #[error(
        "pass `{pass}` {what}: a part that lies elsewhere is simulated only where the torch goes along the seam's line; \
         allowed is a pass without blended corners, woven by one torch if at all, or no distortion file"
    )]
    OffLine {
        /// Name of the pass.
        pass: String,
        /// What it does.
        what: &'static str,
    },
    /// The slides of a head do not span the plane square to its seam.
    #[error(
        "the cross slides of head {head} of machine {machine} cannot move the torch to all sides of this seam; allowed are \
         two [[heads.steps]] whose `move` lies across the seam, in different directions"
    )]
    SlidesAside {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// A distortion file.
    #[error("{0}")]
    Distortion(String),
    /// Settings that cannot work, as a lead too short for the speed.
    #[error(transparent)]
    Settings(#[from] seamwright_tracking::lead::Error),
    /// Beam mode that cannot work.
    #[error(transparent)]
    Beam(#[from] seamwright_tracking::beam::Error),
    /// A beam that does not look.
    #[error(
        "machine {machine} has no camera through which its beam looks; allowed is [sensors.<name>] with kind = \"camera\" in the \
         machine file"
    )]
    NoEye {
        /// Name of the machine.
        machine: String,
    },
    /// Stored deviations on a machine that has no beam to correct with.
    #[error(
        "machine {machine} cannot replay stored deviations: it has no beam that is deflected; allowed are machines whose file has \
         torch.deflection"
    )]
    NoReplay {
        /// Name of the machine.
        machine: String,
    },
    /// Axes that cannot carry the gun aside.
    #[error("the axes cannot carry the gun aside: {0}")]
    Carried(String),
    /// A frame that cannot be had.
    #[error("{0}")]
    Frame(String),
}

impl From<crate::Error> for Error {
    fn from(error: crate::Error) -> Self {
        Self::Cell(Box::new(error))
    }
}
