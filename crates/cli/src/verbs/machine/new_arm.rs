use super::arm_file::write_arm;
use crate::args::arm::NewArmArgs;
use crate::refusals::not_allowed;
use crate::verbs::positive;
use seamwright_machine::{DhConvention, ImportedArm, ImportedAxis, MAX_AXES, OpwArm};
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;

pub(crate) fn run(args: &NewArmArgs) -> Result<(), Failure> {
    if args.dh.len() > MAX_AXES {
        return Err(not_allowed("--dh", args.dh.len(), crate::refusals::at_most(MAX_AXES as f64, Unit::One)));
    }
    let mut arm = of_parameters(args);
    set_ranges(&mut arm.axes, args)?;
    write_arm(arm, &args.arm, &|_| Err(std::io::ErrorKind::NotFound.into()))
}

fn of_parameters(args: &NewArmArgs) -> ImportedArm {
    let Some(lengths) = args.opw else {
        let convention = if args.modified { DhConvention::Modified } else { DhConvention::Standard };
        let row = |row: &seamwright_machine::DhRow| {
            let [alpha, theta] = [row.alpha, row.theta].map(|angle| shown(angle.to_degrees()));
            let end = if row.is_linear { ",linear" } else { "" };
            format!("{},{alpha},{},{theta}{end}", row.a, row.d)
        };
        let rows: Vec<String> = args.dh.iter().map(row).collect();
        let kind = if args.modified { "Craig's rows" } else { "rows" };
        let source = format!("{kind} of Denavit and Hartenberg (a, alpha, d, theta): {}", rows.join("; "));
        return ImportedArm { source, ..ImportedArm::from_dh(&args.dh, convention) };
    };
    let (offsets, signs) = (args.offsets_deg.unwrap_or_default(), args.signs.unwrap_or([1.0; 6]));
    let list = |values: &[f64]| values.iter().map(|v| shown(*v)).collect::<Vec<_>>().join(", ");
    let [lengths_text, offsets_text, signs_text] = [list(&lengths), list(&offsets), list(&signs)];
    let source = format!("a1, a2, b, c1, c2, c3, c4 = {lengths_text}; offsets {offsets_text}; signs {signs_text}");
    let opw = OpwArm { lengths, offsets: offsets.map(f64::to_radians), signs };
    ImportedArm { source, ..ImportedArm::from_opw(&opw) }
}

/// A number without the rounding of radians.
fn shown(value: f64) -> String {
    ((value * 1e9).round() / 1e9).to_string()
}

fn set_ranges(axes: &mut [ImportedAxis], args: &NewArmArgs) -> Result<(), Failure> {
    let names = || Message::verbatim(axes.iter().map(|axis| axis.name.as_str()).collect::<Vec<_>>().join(", "));
    for (option, count) in [("--ranges", args.ranges.len()), ("--speeds", args.speeds.len())] {
        if count > 0 && count != axes.len() {
            return Err(not_allowed(option, count, names()));
        }
    }
    for (i, axis) in axes.iter_mut().enumerate() {
        let own = |v: f64| if axis.is_rotary { v.to_radians() } else { v };
        if let Some(range) = args.ranges.get(i) {
            let [low, high] = range.map(own);
            axis.range = Some([low, high]);
            axis.home = if low <= 0.0 && high >= 0.0 { 0.0 } else { 0.5 * (low + high) };
        }
        if let Some(speed) = args.speeds.get(i) {
            axis.max_speed = own(positive("--speeds", *speed)?);
        }
    }
    Ok(())
}
