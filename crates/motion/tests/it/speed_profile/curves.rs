//! Paths in closed form and splines, as channels.

use seamwright_machine::AxisLimits;
use seamwright_motion::speed_profile::Channels;

/// Cubic pieces by parameter, coefficients highest first: `pieces[i][power][axis]`.
pub struct Spline {
    pub knots: Vec<f64>,
    pub pieces: Vec<[Vec<f64>; 4]>,
    pub limits: Vec<AxisLimits>,
}

impl Spline {
    /// All paths of `path_timing.json` with the duration found by toppra on its finest grid; jerk limits `jerk` times
    /// the accelerations.
    pub fn reference(jerk: f64) -> Vec<(Self, f64)> {
        let text = include_str!("../../../../../tests/data/path_timing.json");
        let all: serde_json::Value = serde_json::from_str(text).unwrap();
        let numbers =
            |v: &serde_json::Value| -> Vec<f64> { v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect() };
        let path = |p: &serde_json::Value| {
            let pieces = p["coefficients_highest_first"].as_array().unwrap().iter();
            let (speed, acceleration) = (numbers(&p["max_speed"]), numbers(&p["max_acceleration"]));
            let limit = |(v, a): (&f64, &f64)| AxisLimits { speed: *v, acceleration: *a, jerk: jerk * a };
            let spline = Self {
                knots: numbers(&p["knots"]),
                pieces: pieces.map(|c| std::array::from_fn(|k| numbers(&c[k]))).collect(),
                limits: speed.iter().zip(&acceleration).map(limit).collect(),
            };
            (spline, p["duration_s_grid_4000"].as_f64().unwrap())
        };
        all["paths"].as_array().unwrap().iter().map(path).collect()
    }
}

impl Channels for Spline {
    fn range(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    fn limits(&self) -> &[AxisLimits] {
        &self.limits
    }

    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        let after = self.knots.partition_point(|k| if before { *k < u } else { *k <= u });
        let i = after.clamp(1, self.pieces.len()) - 1;
        let x = u - self.knots[i];
        let [a, b, c, _] = &self.pieces[i];
        for (k, out) in out.iter_mut().enumerate() {
            *out = [(3.0 * a[k] * x + 2.0 * b[k]) * x + c[k], 6.0 * a[k] * x + 2.0 * b[k], 6.0 * a[k]];
        }
        0.0
    }

    fn asked(&self, _u: f64) -> f64 {
        f64::INFINITY
    }

    fn breaks(&self) -> Vec<f64> {
        self.knots[1..self.knots.len() - 1].to_vec()
    }
}

/// A path with breaks added evenly between its own ones: a profile with limits of jerk has a cell's border at each, so
/// at least about `cells` cells.
pub struct Finely<P> {
    path: P,
    breaks: Vec<f64>,
}

impl<P: Channels> Finely<P> {
    pub fn new(path: P, cells: usize) -> Self {
        let (from, to) = path.range();
        let mut breaks = vec![from];
        for end in path.breaks().into_iter().chain([to]) {
            let begin = breaks[breaks.len() - 1];
            let parts = (cells as f64 * (end - begin) / (to - from)).round().max(1.0);
            breaks.extend((1..parts as usize).map(|i| begin + (end - begin) * i as f64 / parts));
            breaks.push(end);
        }
        breaks.pop();
        breaks.remove(0);
        Self { path, breaks }
    }
}

impl<P: Channels> Channels for Finely<P> {
    fn range(&self) -> (f64, f64) {
        self.path.range()
    }

    fn limits(&self) -> &[AxisLimits] {
        self.path.limits()
    }

    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        self.path.derivatives(u, before, out)
    }

    fn asked(&self, u: f64) -> f64 {
        self.path.asked(u)
    }

    fn breaks(&self) -> Vec<f64> {
        self.breaks.clone()
    }
}

/// The saddle of a nozzle of radius 25 on a shell of radius 60 with a trunnion that tilts by 20 sin(phi) degrees, in
/// closed form by phi: X Y Z in mm, A C in degrees; the same as in the table of rivals' measurements.
pub struct Saddle {
    pub limits: Vec<AxisLimits>,
    pub speed: f64,
}

/// Value and three derivatives.
type Jet = [f64; 4];

fn product(a: Jet, b: Jet) -> Jet {
    [
        a[0] * b[0],
        a[1] * b[0] + a[0] * b[1],
        a[2] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[2],
        a[3] * b[0] + 3.0 * a[2] * b[1] + 3.0 * a[1] * b[2] + a[0] * b[3],
    ]
}

/// `f(g)` from the derivatives of f at g.
fn chain(f: Jet, g: Jet) -> Jet {
    [
        f[0],
        f[1] * g[1],
        f[2] * g[1] * g[1] + f[1] * g[2],
        f[3] * g[1] * g[1] * g[1] + 3.0 * f[2] * g[1] * g[2] + f[1] * g[3],
    ]
}

impl Saddle {
    pub fn new(jerk: f64) -> Self {
        let limit = |speed, acceleration| AxisLimits { speed, acceleration, jerk: jerk * acceleration };
        let (linear, rotary) = (limit(50.0, 500.0), limit(60.0, 600.0));
        Self { limits: vec![linear, linear, linear, rotary, rotary], speed: 20.0 }
    }

    fn jets(phi: f64) -> ([Jet; 5], f64) {
        let (s, c) = phi.sin_cos();
        let (sin, cos) = ([s, c, -s, -c], [c, -s, -c, s]);
        let square = product(sin, sin).map(|x| -625.0 * x);
        let g = [square[0] + 3600.0, square[1], square[2], square[3]];
        let r = g[0].sqrt();
        let z = chain([r, 0.5 / r, -0.25 / (r * g[0]), 0.375 / (r * g[0] * g[0])], g);
        let tilt = sin.map(|x| x * 20.0f64.to_radians());
        let (st, ct) = tilt[0].sin_cos();
        let (sin_a, cos_a) = (chain([st, ct, -st, -ct], tilt), chain([ct, -st, -ct, st], tilt));
        let tip = ((25.0 * cos[1]).powi(2) + (25.0 * sin[1]).powi(2) + z[1] * z[1]).sqrt();
        let axes = [
            [25.0, 0.0, 0.0, 0.0],
            product(z, sin_a).map(|x| -x),
            product(z, cos_a),
            tilt.map(f64::to_degrees),
            [phi.to_degrees(), 1f64.to_degrees(), 0.0, 0.0],
        ];
        (axes, tip)
    }
}

impl Channels for Saddle {
    fn range(&self) -> (f64, f64) {
        (0.0, std::f64::consts::TAU)
    }

    fn limits(&self) -> &[AxisLimits] {
        &self.limits
    }

    fn derivatives(&self, u: f64, _before: bool, out: &mut [[f64; 3]]) -> f64 {
        let (axes, tip) = Self::jets(u);
        axes.iter().zip(out).for_each(|(a, out)| *out = [a[1], a[2], a[3]]);
        tip
    }

    fn asked(&self, _u: f64) -> f64 {
        self.speed
    }

    fn breaks(&self) -> Vec<f64> {
        Vec::new()
    }
}
