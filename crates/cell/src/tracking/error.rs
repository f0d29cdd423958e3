/// Reason why a weld cannot be tracked in simulation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// Error of the machine's drives.
    #[error(transparent)]
    Cell(Box<crate::Error>),
    /// A head has no cross slide for corrections.
    #[error("head {head} of machine {machine} has no cross slide: two linear axes of its own")]
    NoSlide {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// The machine has no sensor that sees the joint ahead of a head.
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
    /// The best sensor of a head does not lead it along the whole pass.
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
        /// Minimum and maximum.
        ahead_mm: [f64; 2],
    },
    /// The torch does not follow the seam's line.
    #[error(
        "pass `{pass}` {what}: a part that lies elsewhere is simulated only where the torch goes along the seam's line; \
         allowed is a pass without blended corners, woven by one torch if at all, or no distortion file"
    )]
    OffLine {
        /// Name of the pass.
        pass: String,
        /// Motion of the torch off the line.
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
    /// Invalid distortion file.
    #[error("{0}")]
    Distortion(String),
    /// Invalid settings, such as a lead too short for the speed.
    #[error(transparent)]
    Settings(#[from] seamwright_tracking::lead::Error),
    /// Invalid settings of beam mode.
    #[error(transparent)]
    Beam(#[from] seamwright_tracking::beam::Error),
    /// The machine has no camera that looks through the beam.
    #[error(
        "machine {machine} has no camera through which its beam looks; allowed is [sensors.<name>] with kind = \"camera\" in the \
         machine file"
    )]
    NoEye {
        /// Name of the machine.
        machine: String,
    },
    /// Stored deviations on a machine without a beam to correct with.
    #[error(
        "machine {machine} cannot replay stored deviations: it has no beam that is deflected; allowed are machines whose file has \
         torch.deflection"
    )]
    NoReplay {
        /// Name of the machine.
        machine: String,
    },
    /// The axes cannot carry the gun aside.
    #[error("the axes cannot carry the gun aside: {0}")]
    Carried(String),
    /// A frame or record is not available.
    #[error("{0}")]
    Frame(String),
}

impl From<crate::Error> for Error {
    fn from(error: crate::Error) -> Self {
        Self::Cell(Box::new(error))
    }
}
