use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::Weaving;
use seamwright_weld::Welding;

/// Numbers of evenly spaced stations, and of stations that close in on each end, where the speed changes quickly.
const EVEN: u32 = 1200;
const NEAR_ENDS: i32 = 60;
/// Minimum number of stations per weave period.
const A_PERIOD: f64 = 32.0;

/// The plan at one station of the weld; mm, deg, s.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    pub(crate) s: f64,
    /// Planned speed of the torch tip.
    pub(crate) speed: f64,
    /// Position, speed, acceleration and jerk of each axis, in mm or degrees.
    pub(crate) axes: Vec<[f64; 4]>,
    /// Work angle (offset from the bisector), travel angle and dihedral angle, along a seam.
    pub(crate) angles: Option<(f64, f64, f64)>,
}

/// Samples the plan along the whole of pass `pass`, counted from 0.
pub(crate) fn samples(machine: &Machine, welding: &Welding, pass: usize, motion: &PassMotion) -> Vec<Sample> {
    let length = motion.path.length();
    let pass_as_asked = &welding.program.value.passes[pass];
    let periods = Weaving::new(pass_as_asked).map_or(0.0, |weaving| weaving.phase(length));
    let even = EVEN.max((A_PERIOD * periods).ceil() as u32);
    let mut places: Vec<f64> = (0..=even).map(|i| length * f64::from(i) / f64::from(even)).collect();
    for i in 0..NEAR_ENDS {
        let d = length / f64::from(EVEN) * 0.85f64.powi(i);
        places.extend([d, length - d]);
    }
    places.sort_by(f64::total_cmp);
    places.into_iter().map(|s| sample(machine, welding, pass, motion, s)).collect()
}

fn sample(machine: &Machine, welding: &Welding, pass: usize, motion: &PassMotion, s: f64) -> Sample {
    let profile = motion.profile.at(motion.profile.time(s), &mut 0);
    let p = motion.path.point(s, false);
    let (v, a) = (profile.v, profile.a);
    let axes = machine.axes.iter().enumerate().map(|(i, axis)| {
        let speed = p.d1[i] * v;
        let acceleration = p.d2[i] * v * v + p.d1[i] * a;
        let jerk = p.d3[i] * v * v * v + 3.0 * p.d2[i] * v * a + p.d1[i] * profile.j;
        [p.q[i], speed, acceleration, jerk].map(|value| axis.to_file(value))
    });
    let path = welding.path(pass);
    let angles = path.along_seam().map(|path| {
        let (work, travel) = path.angles(s);
        (work.to_degrees(), travel.to_degrees(), path.seam_point(s).dihedral.to_degrees())
    });
    Sample { s, speed: motion.tip_speed(machine, profile), axes: axes.collect(), angles }
}
