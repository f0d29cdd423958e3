//! The example jobs as planned motion, at their speeds and so fast that the axes' limits bind.

use crate::planning::{first_pass, machine_of, plan, read};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::feed_override::{ChannelLimits, PassTimed, Rates, channel_limits};
use seamwright_motion::{PassMotion, SpeedProfile};
use seamwright_program::TorchPath;
use seamwright_weld::Welding;
use std::sync::OnceLock;

/// Name, text, and the factor of its speed at which the axes' limits bind.
const EXAMPLES: [(&str, &str, f64); 6] = [
    ("saddle", include_str!("../../../../../examples/saddle.toml"), 40.0),
    ("head-nozzle", include_str!("../../../../../examples/head-nozzle.toml"), 40.0),
    ("ellipse", include_str!("../../../../../examples/ellipse.toml"), 40.0),
    ("trunnion-saddle", include_str!("../../../../../examples/trunnion-saddle.toml"), 40.0),
    ("oblique-girth", include_str!("../../../../../examples/oblique-girth.toml"), 4.0),
    ("t-joint", include_str!("../../../../../examples/t-joint.toml"), 40.0),
];

pub(crate) struct Weld {
    pub(crate) name: String,
    pub(crate) machine: Machine,
    welding: Welding,
    motion: PassMotion,
    faster: SpeedProfile,
}

impl Weld {
    fn new(name: &str, text: &str, times: f64) -> Self {
        let number = |l: &str| l.split('#').next().unwrap().trim().parse::<f64>().unwrap();
        let line = |l: &str| match l.strip_prefix("speed_mm_s =") {
            Some(speed) => format!("speed_mm_s = {}\n", number(speed) * times),
            None if l == "[weld]" => "[weld]\non_limit = \"slow\"\n".to_owned(),
            None => format!("{l}\n"),
        };
        let text: String = text.lines().filter(|l| !l.starts_with("on_limit")).map(line).collect();
        let welding = read(&text);
        let machine = machine_of(&welding);
        let motion = plan(&machine, &welding).unwrap_or_else(|f| panic!("{name}: {f:#?}"));
        let faster = motion.faster(&machine, first_pass(&welding), 1.5).unwrap();
        Self { name: format!("{name} at {times} times its speed"), machine, welding, motion, faster }
    }

    pub(crate) fn limits(&self) -> ChannelLimits {
        channel_limits(&self.machine)
    }

    pub(crate) fn base(&self) -> PassTimed<'_> {
        self.motion.timed(&self.machine)
    }

    pub(crate) fn faster(&self) -> PassTimed<'_> {
        PassTimed::new(&self.machine, &self.motion.path, &self.faster)
    }

    pub(crate) fn profile(&self) -> &SpeedProfile {
        &self.motion.profile
    }

    pub(crate) fn length(&self) -> f64 {
        self.motion.path.length()
    }

    pub(crate) fn position(&self, s: f64) -> Joints {
        self.motion.path.at(s)
    }

    /// Distance of the tip, by the machine's forward kinematics, from the seam's point at the path length, mm.
    pub(crate) fn off_seam(&self, r: &Rates) -> f64 {
        (self.machine.forward(&r.q).point - self.welding.path(0).pose(r.tip.s).point).length()
    }

    /// Maximum speed, acceleration and jerk of any axis as part of its limit.
    pub(crate) fn use_of_limits(&self, r: &Rates) -> f64 {
        let axes = self.machine.axes.iter().enumerate();
        let parts = axes.map(|(i, axis)| {
            let (v, a, j) = (r.v[i] / axis.max_speed, r.a[i] / axis.max_acceleration, r.j[i] / axis.jerk());
            v.abs().max(a.abs()).max(j.abs())
        });
        parts.fold(0.0, f64::max)
    }
}

pub(crate) fn all() -> &'static [Weld] {
    static WELDS: OnceLock<Vec<Weld>> = OnceLock::new();
    WELDS.get_or_init(|| {
        let both = |&(name, text, fast): &(&str, &str, f64)| [1.0, fast].map(|times| Weld::new(name, text, times));
        EXAMPLES.iter().flat_map(both).collect()
    })
}
