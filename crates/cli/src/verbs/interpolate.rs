mod plot;

use crate::args::{CurveArg, InterpolateArgs, MethodArg, StepArg};
use crate::refusals::of_option;
use crate::rows::{Cell, Rows};
use glam::DVec2;
use seamwright_interpolators::{AngleRule, EqualStep, Interpolation, Method, Request, Shape, Statistics};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::files;

const POINTS: &str = "method,t_s,phi_deg,x_mm,y_mm,z_mm,chord_mm";
const SUMMARY: &str = "method,steps,step_mm,chord_min_mm,chord_max_mm,chord_mean_mm,chord_min_percent,chord_max_percent,\
    chord_rms_percent,deviation_max_mm,deviation_rms_mm,chord_error_max_mm,length_mm,true_length_mm,end_error_mm,\
    duration_s";

struct Named {
    name: &'static str,
    request: Request,
}

impl Named {
    fn interpolate(&self) -> Result<Interpolation, Failure> {
        self.request.interpolate().map_err(|e| Failure::Input(e.0))
    }
}

pub(crate) fn run(args: &InterpolateArgs) -> Result<(), Failure> {
    let base = request(args)?;
    let requests: Vec<Named> =
        methods(args).into_iter().map(|(name, method)| Named { name, request: Request { method, ..base } }).collect();
    // All are checked before anything is written.
    for named in &requests {
        named.interpolate()?;
    }
    if let Some(path) = &args.svg {
        files::write(path, &plot::draw(&requests)?)?;
    }
    if args.summary { summary(&requests, args.json) } else { points(&requests, args.json) }
}

fn methods(args: &InterpolateArgs) -> Vec<(&'static str, Method)> {
    let exact = match args.step {
        StepArg::Arc => ("exact-arc", Method::Exact(EqualStep::Arc)),
        StepArg::Chord => ("exact-chord", Method::Exact(EqualStep::Chord)),
    };
    let rules = [
        ("eccentric-angle-printed", Method::EccentricAngle(AngleRule::Printed)),
        ("eccentric-angle-polar", Method::EccentricAngle(AngleRule::Polar)),
        ("eccentric-angle-tangent", Method::EccentricAngle(AngleRule::Tangent)),
    ];
    let pulses = [
        ("point-by-point", Method::PointByPoint),
        ("comparison-integral", Method::ComparisonIntegral),
        ("dda", Method::Dda),
    ];
    match args.method {
        MethodArg::Exact => vec![exact],
        MethodArg::EccentricAngle => vec![rules[0]],
        MethodArg::PointByPoint => vec![pulses[0]],
        MethodArg::ComparisonIntegral => vec![pulses[1]],
        MethodArg::Dda => vec![pulses[2]],
        MethodArg::All => std::iter::once(exact).chain(rules).chain(pulses).collect(),
    }
}

fn request(args: &InterpolateArgs) -> Result<Request, Failure> {
    let (shape, speed, period_ms) = match args.curve {
        CurveArg::Ellipse => (ellipse(args)?, 5.0, 10.0),
        CurveArg::Saddle => {
            let shape = Shape::Saddle {
                nozzle_radius_mm: args.nozzle_radius_mm,
                shell_radius_mm: args.shell_radius_mm,
                start_rad: 0.0,
                sweep_rad: args.sweep_deg.to_radians(),
            };
            (shape, 10.0, 20.0)
        }
    };
    Ok(Request {
        shape,
        speed_mm_s: args.speed_mm_s.unwrap_or(speed),
        period_s: 1e-3 * args.period_ms.unwrap_or(period_ms),
        pulse_mm: args.pulse_mm,
        ..Request::default()
    })
}

fn ellipse(args: &InterpolateArgs) -> Result<Shape, Failure> {
    let point = |name: &str, given: &Option<Vec<f64>>, or: DVec2| match given.as_deref() {
        None => Ok(or),
        Some(&[x, y]) => Ok(DVec2::new(x, y)),
        Some(_) => {
            let allowed = Message::new("cli-point-form").text("example", "0,16");
            Err(Failure::refused(of_option(name, Message::new("cli-not-a-point")), allowed))
        }
    };
    let (a, b) = (args.a_mm, args.b_mm);
    let start_mm = point("--start-mm", &args.start_mm, DVec2::new(0.0, b))?;
    let end = point("--end-mm", &args.end_mm, DVec2::new(a, 0.0))?;
    Ok(Shape::Ellipse { a_mm: a, b_mm: b, start_mm, end_mm: (!args.full_turn).then_some(end), clockwise: true })
}

fn points(requests: &[Named], json: bool) -> Result<(), Failure> {
    let mut rows = Rows::with_header(POINTS, json);
    for named in requests {
        let mut last = None;
        for p in named.interpolate()? {
            let chord = last.map_or(Cell::Empty, |l| Cell::Number(p.position.distance(l)));
            last = Some(p.position);
            let [x, y, z] = p.position.to_array().map(Cell::Number);
            rows.row(&[Cell::Text(named.name), p.t_s.into(), p.u_rad.to_degrees().into(), x, y, z, chord])?;
        }
    }
    rows.finish()
}

fn summary(requests: &[Named], json: bool) -> Result<(), Failure> {
    let mut rows = Rows::with_header(SUMMARY, json);
    for Named { name, request } in requests {
        let s: Statistics = request.statistics().map_err(|e| Failure::Input(e.0))?;
        // Pulse methods: distances a period, since a pulse has no speed.
        let c = s.per_period;
        let mut cells = vec![Cell::Text(name), Cell::Count(s.steps)];
        let numbers = [
            c.reference_mm,
            c.min_mm,
            c.max_mm,
            c.mean_mm,
            c.min_percent,
            c.max_percent,
            c.rms_percent,
            s.deviation_max_mm,
            s.deviation_rms_mm,
            s.chord_error_max_mm,
            s.length_mm,
            s.true_length_mm,
            s.end_error_mm,
            s.duration_s,
        ];
        cells.extend(numbers.map(Cell::Number));
        rows.row(&cells)?;
    }
    rows.finish()
}
