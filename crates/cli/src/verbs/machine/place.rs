use super::placement_report::{Axis, Fitted, Placed};
use super::touched_points::{Touched, Wanted, read};
use crate::args::machine::{PlaceArgs, PlaceMethod};
use crate::refusals::{between, in_file, not_allowed, refused, signed};
use crate::rows::print_either;
use crate::verbs::positive;
use glam::{DAffine3, DQuat, DVec3};
use seamwright_document::Transform;
use seamwright_geometry::fit::{Touch, best_fit, fit_pairs, plane_line_point, run_out};
use seamwright_geometry::{Error, Tube};
use seamwright_machine::{AxisKind, Machine};
use seamwright_message::{Message, Unit};
use seamwright_program::{OFFSET_NAMES, is_offset_name};
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, load, load_text};
use seamwright_project::{files, work_offset};
use seamwright_weld::{SeamCurve, SeamSurfaces};
use std::path::Path;

pub(crate) fn run(args: &PlaceArgs) -> Result<(), Failure> {
    check(args)?;
    let loaded = load(&args.job)?;
    let rows = read(&args.points, &loaded.machine, &wanted(args.method))?;
    let fitted = fitted(args, &loaded, &rows).map_err(|e| match e {
        NoPlace::Points(e) => {
            let message = in_file(&args.points.display().to_string(), &e);
            Failure::refused(message, Message::new("cli-place-more-points"))
        }
        NoPlace::Input(failure) => failure,
    })?;
    let transform = work_offset::rounded(&fitted.offset).ok_or_else(|| no_number(args))?;
    let placed = Placed::new(args, &rows, fitted, transform);
    if let (Some(path), true) = (&args.output, placed.accepted) {
        write_job(args, path, &transform)?;
    }
    print_either(args.json, &placed, || placed.text(args.output.as_deref()))?;
    if placed.accepted { Ok(()) } else { Err(Failure::Printed) }
}

fn check(args: &PlaceArgs) -> Result<(), Failure> {
    positive("--largest-mm", args.largest_mm)?;
    let radius = args.probe_radius_mm;
    if !(0.0..=1000.0).contains(&radius) {
        return Err(not_allowed("--probe-radius-mm", radius, between(0.0, 1000.0)));
    }
    if radius > 0.0 && args.method == PlaceMethod::ThreePoint {
        let (fault, allowed) = ("cli-place-side-unknown", "cli-place-radius-with-three-points");
        return Err(refused("--probe-radius-mm", radius, Message::new(fault), Message::new(allowed)));
    }
    if !is_offset_name(&args.name) {
        return Err(not_allowed("--name", &args.name, OFFSET_NAMES));
    }
    Ok(())
}

fn no_number(args: &PlaceArgs) -> Failure {
    Failure::input(in_file(&args.points.display().to_string(), Message::new("cli-place-undetermined")))
}

fn wanted(method: PlaceMethod) -> Wanted {
    match method {
        PlaceMethod::ThreePoint => Wanted { features: &[], feature_needed: false, nominal: true },
        PlaceMethod::PlaneLinePoint => {
            Wanted { features: &["plane", "line", "point"], feature_needed: true, nominal: false }
        }
        PlaceMethod::BestFit => Wanted { features: &["nozzle", "body"], feature_needed: true, nominal: false },
        PlaceMethod::Chuck => Wanted { features: &["nozzle"], feature_needed: false, nominal: false },
    }
}

/// Reason why there is no placement.
enum NoPlace {
    Points(Error),
    Input(Failure),
}

impl From<Error> for NoPlace {
    fn from(e: Error) -> Self {
        Self::Points(e)
    }
}

fn fitted(args: &PlaceArgs, loaded: &Loaded, rows: &[Touched]) -> Result<Fitted, NoPlace> {
    let program = &loaded.welding.program;
    let Some(seam) = &program.value.seam else {
        let (message, allowed) = (Message::new("cli-place-no-seam"), Message::new("project-job-or-seam"));
        return Err(NoPlace::Input(program.error_at("", message, allowed).into()));
    };
    // Only these two methods measure against the seam's surfaces; not every seam has them.
    let surfaces = || SeamSurfaces::new(program, seam).map_err(|e| NoPlace::Input(e.into()));
    match args.method {
        PlaceMethod::ThreePoint => {
            let pairs: Vec<(DVec3, DVec3)> = rows.iter().map(|r| (r.nominal, r.point)).collect();
            let fit = fit_pairs(&pairs)?;
            let residuals = fit.residuals.iter().map(|r| r.length()).collect();
            Ok(Fitted { sides: fit.sides, deviation: fit.deviation, ..Fitted::new(fit.transform, residuals) })
        }
        PlaceMethod::PlaneLinePoint => faces(args, rows, &program.value.work_offset()),
        PlaceMethod::BestFit => {
            let surfaces = surfaces()?;
            let touch = |r: &Touched| {
                let surface = if r.feature == "nozzle" { &surfaces.first } else { &surfaces.second };
                Touch { point: r.point, surface: surface.as_ref(), outside: args.probe_radius_mm }
            };
            let touches: Vec<Touch> = rows.iter().map(touch).collect();
            let fit = best_fit(&touches, &program.value.seam_in_work(), false)?;
            let placed = program.value.work_offset().inverse() * program.value.seam_in_work();
            let offset = fit.transform * placed.inverse();
            let mut fitted = Fitted { free: fit.free, deviation: fit.deviation, ..Fitted::new(offset, fit.residuals) };
            if fitted.deviation.is_none() {
                fitted.warnings.push(Message::new("cli-place-no-redundancy"));
            }
            Ok(fitted)
        }
        PlaceMethod::Chuck => {
            let surfaces = surfaces()?;
            let Some(nozzle) = &surfaces.nozzle else {
                let (message, allowed) = (Message::new("cli-place-no-nozzle"), Message::new("cli-place-nozzle"));
                return Err(NoPlace::Input(program.error_at("seam", message, allowed).into()));
            };
            Ok(chuck(args, loaded, loaded.seam().map_err(NoPlace::Input)?, rows, nozzle)?)
        }
    }
}

fn faces(args: &PlaceArgs, rows: &[Touched], nominal: &DAffine3) -> Result<Fitted, NoPlace> {
    let of = |feature: &str| -> Vec<DVec3> { rows.iter().filter(|r| r.feature == feature).map(|r| r.point).collect() };
    let (plane, line, point) = (of("plane"), of("line"), of("point"));
    let fit = plane_line_point(&plane, &line, &point, args.probe_radius_mm, nominal)?;
    // Back in the order of the table.
    let mut lists = [("plane", fit.plane.iter()), ("line", fit.line.iter()), ("point", fit.point.iter())];
    let next = |r: &Touched| lists.iter_mut().find(|(name, _)| *name == r.feature).and_then(|l| l.1.next().copied());
    let residuals = rows.iter().filter_map(next).collect();
    Ok(Fitted::new(fit.transform, residuals))
}

fn chuck(
    args: &PlaceArgs,
    loaded: &Loaded,
    seam: &SeamCurve,
    rows: &[Touched],
    nozzle: &Tube,
) -> Result<Fitted, Error> {
    let points: Vec<DVec3> = rows.iter().map(|r| r.point).collect();
    // Without the offset in force: the part turns about the axis that the job meant it to have.
    let program = &loaded.welding.program.value;
    let placement = program.work_offset().inverse() * program.seam_in_work();
    let tube = nozzle.moved(&placement);
    let step = seam.length() / f64::from(SAMPLES);
    let on_seam = (0..SAMPLES).map(|i| placement.transform_point3(seam.at(step * f64::from(i)).point));
    let at = tube.on_axis(on_seam.sum::<DVec3>() / f64::from(SAMPLES));
    let found = run_out(&points, args.probe_radius_mm, &tube, at)?;
    let mut warnings = Vec::new();
    match found.growth {
        None => warnings.push(Message::new("cli-place-radius-unknown")),
        Some(growth) if growth.abs() > args.largest_mm => {
            let deviation = signed(growth, Unit::Mm, 3);
            warnings.push(Message::new("cli-place-radius-off").message("deviation", deviation));
        }
        Some(_) => {}
    }
    if !turns_about(&loaded.machine, &tube) {
        warnings.push(Message::new("cli-place-no-rotary-axis"));
    }
    let axis = Axis::new(&found, at);
    let fitted =
        Fitted { free: found.free, warnings, axis: Some(axis), ..Fitted::new(found.correction, found.residuals) };
    Ok(fitted)
}

/// Number of points of the seam whose mean represents its middle.
const SAMPLES: u32 = 360;

/// True if one of the machine's rotary axes, from home, turns the torch about the tube's axis.
fn turns_about(machine: &Machine, tube: &Tube) -> bool {
    let home = machine.home();
    let before = machine.forward(&home);
    let on_axis = tube.on_axis(DVec3::ZERO);
    machine.axes.iter().enumerate().filter(|(_, a)| a.kind == AxisKind::Rotary).any(|(i, _)| {
        [1.0, -1.0].iter().any(|sense| {
            let mut q = home;
            q[i] += 1.0;
            let after = machine.forward(&q);
            let turn = DQuat::from_axis_angle(tube.direction(), *sense);
            let point = on_axis + turn * (before.point - on_axis);
            (after.point - point).length() < 1e-6 && (after.direction - turn * before.direction).length() < 1e-6
        })
    })
}

/// Writes the job again with the offset in force, after a look whether it can be read where it will stand.
fn write_job(args: &PlaceArgs, path: &Path, transform: &Transform) -> Result<(), Failure> {
    let cannot = |why: Message| {
        let message = Message::new("cli-place-unchangeable").text("file", args.job.display().to_string());
        Failure::input(message.message("why", why))
    };
    let placed = work_offset::put_into(&files::read(&args.job)?, &args.name, transform)
        .map_err(|e| cannot(Message::outside(&e)))?;
    let text = placed.ok_or_else(|| cannot(Message::new("project-not-a-table").key("table", "offsets")))?;
    let folder = path.parent().unwrap_or(Path::new("."));
    load_text(&path.display().to_string(), &text, folder)?;
    files::write(path, &text)
}
