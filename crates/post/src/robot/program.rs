use super::pose::RobotPose;
use super::stream::SetPoints;
use super::weld_values::WeldValues;

/// Frames that a program declares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotFrames {
    /// The tool centre point in the flange.
    pub tool: RobotPose,
    /// The work frame in the base frame, or in the frame of the positioner's last axis.
    pub work: RobotPose,
}

/// A robot program as data, in no language.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotProgram {
    /// Title, for people.
    pub title: String,
    /// Frames; `None` if they are settings of the control and not part of the text.
    pub frames: Option<RobotFrames>,
    /// Steps in the order of execution.
    pub steps: Vec<RobotStep>,
}

/// A step of a robot program.
#[derive(Debug, Clone, PartialEq)]
pub enum RobotStep {
    /// Start of a pass, with its name.
    Pass(String),
    /// All axes go straight in axis space to a stop.
    Joints(JointTarget),
    /// All axes go straight in axis space to a pose and stop there, in languages without targets of axes.
    JointsTo(TcpMove),
    /// The tool centre point goes straight or along an arc in the work frame.
    Move(TcpMove),
    /// The arm's axes go through set-points, one each period, in URScript.
    SetPoints(SetPoints),
    /// The arc is switched on at rest.
    ArcOn(ArcStart),
    /// The arc is switched off at rest.
    ArcOff(ArcEnd),
    /// Process values of the lines that follow.
    Values(WeldValues),
    /// Rest, s.
    Wait(f64),
}

/// Positions of all axes.
#[derive(Debug, Clone, PartialEq)]
pub struct JointTarget {
    /// The arm's axes, degrees.
    pub arm: [f64; 6],
    /// External axes, mm or degrees.
    pub externals: Vec<f64>,
}

/// A move of the tool centre point: straight, or along an arc.
#[derive(Debug, Clone, PartialEq)]
pub struct TcpMove {
    /// Point between its ends through which the arc goes; `None`: the move is straight.
    pub via: Option<ThroughPoint>,
    /// Its end in the work frame.
    pub to: RobotPose,
    /// External axes at its end, mm or degrees.
    pub externals: Vec<f64>,
    /// Configuration of the arm at its end, as the language numbers it; empty if it has none.
    pub configuration: Vec<i32>,
    /// Speed of the tool centre point, mm/s.
    pub speed_mm_s: f64,
    /// Radius of the zone in which the corner at its end is rounded, mm; 0: the control stops there.
    pub zone_mm: f64,
}

impl TcpMove {
    /// The same with its poses moved as `moved` says for their external axes.
    pub(crate) fn mapped(&self, moved: impl Fn(&RobotPose, &[f64]) -> RobotPose) -> Self {
        let via = self.via.as_ref().map(|via| ThroughPoint { pose: moved(&via.pose, &via.externals), ..via.clone() });
        Self { via, to: moved(&self.to, &self.externals), ..self.clone() }
    }
}

/// A point of an arc between its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct ThroughPoint {
    /// Pose in the work frame; without a rotation in languages that ignore it.
    pub pose: RobotPose,
    /// External axes, mm or degrees; empty in languages that ignore them.
    pub externals: Vec<f64>,
    /// Configuration of the arm; empty in languages that ignore it.
    pub configuration: Vec<i32>,
}

/// Start of a weld at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcStart {
    /// Gas flows before the arc, s.
    pub preflow_s: f64,
    /// The arc burns before the motion, s.
    pub delay_s: f64,
    /// Process values.
    pub values: WeldValues,
}

/// End of a weld at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcEnd {
    /// The arc burns after the motion, s.
    pub crater_s: f64,
    /// Gas flows after the arc, s.
    pub postflow_s: f64,
}
