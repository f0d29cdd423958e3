//! Planned examples, and part programs played by rules written down a second time.

use glam::DVec3;
use seamwright_machine::{Clamped, Joints, Machine, Surroundings, shipped};
use seamwright_motion::WeldMotion;
use seamwright_post::{Arc, Control, Level, Move, Options, PartProgram, Path, What, part_program};
use seamwright_program::{Finding, Pass, TorchPath};
use seamwright_weld::{Outside, Welding};

pub(crate) struct Planned {
    pub(crate) machine: Machine,
    pub(crate) welding: Welding,
    pub(crate) motion: WeldMotion,
}

struct Folder;

impl Planned {
    pub(crate) fn example(name: &str) -> Self {
        let path = format!("{}/../../examples/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        Self::job(&std::fs::read_to_string(path).unwrap())
    }

    pub(crate) fn job(text: &str) -> Self {
        Self::on(text, str::to_owned)
    }

    pub(crate) fn on(text: &str, change: impl Fn(&str) -> String) -> Self {
        Self::attempt(text, change).unwrap_or_else(|findings| panic!("{findings:?}"))
    }

    /// The plan, or the findings against it.
    pub(crate) fn attempt(text: &str, change: impl Fn(&str) -> String) -> Result<Self, Vec<Finding>> {
        let welding = Welding::read_with("job.toml", text, &Folder).unwrap();
        let file = change(shipped(&welding.program.value.machine).unwrap().text);
        let machine = Machine::read("m", &file).unwrap();
        let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
        let motion = {
            let paths: Vec<_> = (0..welding.program.value.passes.len()).map(|i| welding.path(i)).collect();
            let passes: Vec<(&dyn TorchPath, &Pass)> =
                paths.iter().zip(&welding.program.value.passes).map(|(p, pass)| (p as &dyn TorchPath, pass)).collect();
            WeldMotion::plan(&machine, &around, &passes, 30.0)?
        };
        Ok(Self { machine, welding, motion })
    }

    pub(crate) fn program(&self, control: &Control, options: &Options) -> Result<PartProgram, seamwright_post::Error> {
        let paths: Vec<_> = (0..self.welding.program.value.passes.len()).map(|i| self.welding.path(i)).collect();
        let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
        part_program(&self.machine, control, &self.welding.program.value, &paths, &self.motion, options)
    }

    /// The plan as a part program is verified against it.
    pub(crate) fn within<'a>(&'a self, control: &'a Control, options: &Options) -> seamwright_post::Planned<'a> {
        seamwright_post::Planned {
            machine: &self.machine,
            control,
            program: &self.welding.program.value,
            motion: &self.motion,
            tolerance_mm: options.tolerance_mm,
            speed_percent: options.speed_percent,
        }
    }
}

/// The steps of each pass, from its start to the next one's.
pub(crate) fn passes(program: &PartProgram) -> Vec<std::ops::Range<usize>> {
    let mut begins: Vec<usize> =
        (0..program.steps.len()).filter(|i| matches!(program.steps[*i].what, What::Pass(_))).collect();
    begins.push(program.steps.len());
    begins.windows(2).map(|w| w[0]..w[1]).collect()
}

/// A way in time: rows at the part `f` of it.
pub(crate) struct Way<'a> {
    pub(crate) step: Move,
    from: Vec<f64>,
    to: &'a [f64],
    shape: Shape<'a>,
    xyz: [Option<usize>; 3],
}

enum Shape<'a> {
    Line,
    Arc(Arc),
    /// Speeds at both ends.
    Hermite(Vec<f64>, &'a [f64]),
    /// Four control points.
    Spline([Vec<f64>; 4]),
    /// Coefficients of second and third power, and the share of the way at even steps of the parameter.
    Curve(&'a [f64], &'a [f64], Vec<f64>),
}

/// All ways of the moves in a range of steps, in order. Each segment of a spline is a way, also the two that the
/// control adds to a run.
pub(crate) fn ways<'a>(program: &'a PartProgram, range: std::ops::Range<usize>) -> Vec<(usize, Way<'a>)> {
    let xyz = ["x", "y", "z"].map(|name| program.channels.iter().position(|c| c.name == name));
    let mut all: Vec<(usize, Way)> = Vec::new();
    let mut here = vec![0.0; program.channels.len()];
    let mut speeds = here.clone();
    let moves: Vec<(usize, Move)> = range
        .filter_map(|i| match &program.steps[i].what {
            What::Move(m) => Some((i, *m)),
            _ => None,
        })
        .collect();
    let mut k = 0;
    while k < moves.len() {
        let (i, step) = moves[k];
        let to = program.row(step.row);
        // Values that are set between moves.
        let before = if k > 0 { moves[k - 1].0 } else { 0 };
        for step in &program.steps[before..i] {
            if let What::Set { channel, value, .. } = step.what {
                here[usize::from(channel)] = value;
            }
        }
        let shape = match step.path {
            Path::Rapid | Path::Line => Shape::Line,
            Path::Arc(arc) => Shape::Arc(program.arcs[arc as usize]),
            Path::Hermite(row) => Shape::Hermite(speeds.clone(), program.row(row)),
            Path::Curve(index) => {
                let curve = program.curves[index as usize];
                let [second, third] = [0, 1].map(|k| program.row(curve.row + k));
                Shape::Curve(second, third, CubicRows { from: &here, to, second, third }.shares(curve.counted))
            }
            Path::Spline => {
                let run = moves[k..]
                    .iter()
                    .take_while(|(_, m)| m.path == Path::Spline && (m.seconds - step.seconds).abs() < 1e-9);
                let mut count = run.count();
                // An exact stop ends a run.
                count = moves[k..k + count].iter().position(|(_, m)| m.exact_stop).map_or(count, |p| p + 1);
                let mut points = vec![here.clone(); 3];
                points.extend(moves[k..k + count].iter().map(|(_, m)| program.row(m.row).to_vec()));
                points.extend(vec![points[points.len() - 1].clone(); 2]);
                let last = moves[k + count - 1].1;
                for (n, w) in points.windows(4).enumerate() {
                    let (at, step) = moves[k + n.saturating_sub(1).min(count - 1)];
                    let shape = Shape::Spline(std::array::from_fn(|j| w[j].clone()));
                    all.push((at, Way { step, from: here.clone(), to: program.row(last.row), shape, xyz }));
                }
                here = program.row(last.row).to_vec();
                k += count;
                continue;
            }
        };
        speeds = match &shape {
            Shape::Hermite(_, to) => to.to_vec(),
            _ => vec![0.0; here.len()],
        };
        all.push((i, Way { step, from: here.clone(), to, shape, xyz }));
        here = to.to_vec();
        k += 1;
    }
    all
}

/// Cubics of all channels: rows at their ends, and of their coefficients of second and third power.
struct CubicRows<'a> {
    from: &'a [f64],
    to: &'a [f64],
    second: &'a [f64],
    third: &'a [f64],
}

impl CubicRows<'_> {
    /// Value of channel `i` at the parameter `u`.
    fn at(&self, i: usize, u: f64) -> f64 {
        let (a, b, c, d) = (self.from[i], self.to[i], self.second[i], self.third[i]);
        a + u * (b - a - c - d + u * (c + u * d))
    }

    /// Share of the way of the counted axes at even steps of the parameter, by chords.
    fn shares(&self, counted: u64) -> Vec<f64> {
        let steps = 4096;
        let axes: Vec<usize> = (0..self.from.len()).filter(|i| counted >> i & 1 == 1).collect();
        let at = |i: usize, k: usize| self.at(i, k as f64 / steps as f64);
        let mut ways = vec![0.0];
        for k in 0..steps {
            let chord = axes.iter().map(|i| (at(*i, k + 1) - at(*i, k)).powi(2)).sum::<f64>().sqrt();
            ways.push(ways[k] + chord);
        }
        let whole = ways[steps];
        ways.into_iter().map(|way| way / whole).collect()
    }
}

impl Way<'_> {
    /// The row at the part `f` of the time.
    pub(crate) fn at(&self, f: f64) -> Vec<f64> {
        let even = |i: usize| self.from[i] + f * (self.to[i] - self.from[i]);
        let n = self.from.len();
        match &self.shape {
            Shape::Line => (0..n).map(even).collect(),
            Shape::Arc(arc) => {
                let mut row: Vec<f64> = (0..n).map(even).collect();
                let place = |row: &[f64]| DVec3::from_array(self.xyz.map(|i| i.map_or(0.0, |i| row[i])));
                let (start, end) = (place(&self.from), place(self.to));
                // In two dimensions, with an axis of its own.
                let out = start - arc.centre;
                let up = arc.normal;
                let (x, height) = (out - up * out.dot(up), out.dot(up));
                let y = up.cross(x);
                let (sin, cos) = (f * arc.sweep).sin_cos();
                let climb = (end - start).dot(up);
                let at = arc.centre + x * cos + y * sin + up * (height + f * climb);
                self.xyz.iter().zip(at.to_array()).for_each(|(i, v)| i.iter().for_each(|i| row[*i] = v));
                row
            }
            Shape::Hermite(from, to) => {
                let t = self.step.seconds;
                // By its coefficients: q = a + b u + c u^2 + d u^3 with u from 0 to 1.
                let value = |i: usize| {
                    let (a, b) = (self.from[i], from[i] * t);
                    let (rest, slope) = (self.to[i] - a - b, to[i] * t - b);
                    let (c, d) = (3.0 * rest - slope, slope - 2.0 * rest);
                    a + f * (b + f * (c + f * d))
                };
                (0..n).map(value).collect()
            }
            Shape::Curve(second, third, shares) => {
                let above = shares.partition_point(|share| *share <= f).clamp(1, shares.len() - 1);
                let (low, high) = (shares[above - 1], shares[above]);
                let u = (above as f64 - 1.0 + (f - low) / (high - low)) / (shares.len() - 1) as f64;
                let cubics = CubicRows { from: &self.from, to: self.to, second, third };
                (0..n).map(|i| cubics.at(i, u)).collect()
            }
            Shape::Spline(p) => {
                // De Boor's steps on uniform knots.
                let mix = |a: f64, b: f64, w: f64| a + w * (b - a);
                let value = |i: usize| {
                    let first = [0, 1, 2].map(|j| mix(p[j][i], p[j + 1][i], (f + 2.0 - j as f64) / 3.0));
                    let second = [0, 1].map(|j| mix(first[j], first[j + 1], (f + 1.0 - j as f64) / 2.0));
                    mix(second[0], second[1], f)
                };
                (0..n).map(value).collect()
            }
        }
    }

    /// Tip of head `head` at the part `f`.
    pub(crate) fn tip(&self, machine: &Machine, head: usize, f: f64) -> DVec3 {
        let row = self.at(f);
        if self.step.level == Level::Tip {
            return DVec3::from_array(self.xyz.map(|i| row[i.unwrap()]));
        }
        let mut q = Joints::default();
        for ((q, axis), value) in q.iter_mut().zip(&machine.axes).zip(&row) {
            *q = axis.from_file(*value);
        }
        machine.forward_of(head, &q).point
    }
}

impl Outside for Folder {
    fn bytes(&self, file: &str) -> std::io::Result<Vec<u8>> {
        std::fs::read(format!("{}/../../examples/{file}", env!("CARGO_MANIFEST_DIR")))
    }

    fn table(&self, file: &str) -> Result<Vec<Vec<f64>>, seamwright_weld::Wrong> {
        let text = String::from_utf8(self.bytes(file).unwrap()).unwrap();
        let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).skip(1);
        Ok(lines.map(|line| line.split(',').map(|v| v.trim().parse().unwrap()).collect()).collect())
    }

    fn tip(&self, machine: &str, axes: &[f64]) -> Result<DVec3, seamwright_weld::Wrong> {
        let machine = Machine::read("m", shipped(machine).unwrap().text).unwrap();
        let mut q = Joints::default();
        for ((q, axis), value) in q.iter_mut().zip(&machine.axes).zip(axes) {
            *q = axis.from_file(*value);
        }
        Ok(machine.forward(&q).point)
    }
}
