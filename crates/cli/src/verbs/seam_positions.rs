//! Positions along the seam, as the command line gives them.

use super::positive;
use crate::args::PlacesArgs;
use crate::refusals::{between, not_allowed, of_option, refused};
use seamwright_message::{Message, Unit};
use seamwright_program::{is_beyond, part_start, parts_of};
use seamwright_project::failure::Failure;
use seamwright_weld::SeamCurve;

/// Maximum number of points along a seam.
const MAX_POINTS: u32 = 10_000_000;

pub(super) enum Places {
    /// Path lengths with their angles, degrees.
    Angles(Vec<(f64, f64)>),
    /// Every `step` mm, `whole` times, and the end.
    Steps { step: f64, whole: u64 },
    /// So many at equal distances.
    Points(u32),
}

impl Places {
    /// The positions of `args`; `points` of them by default.
    pub(super) fn new(args: &PlacesArgs, seam: &SeamCurve, points: u32) -> Result<Self, Failure> {
        let length = seam.weld_length();
        if let Some(angles) = &args.phi_deg {
            let wrong = |phi: &f64, code| Failure::input(of_option(format!("--phi-deg {phi}"), Message::new(code)));
            let place = |phi: &f64| {
                let s = Some(phi).filter(|p| p.is_finite()).and_then(|p| seam.s_of_phi(p.to_radians()));
                let s = s.ok_or_else(|| wrong(phi, "cli-no-such-angle"))?;
                if is_beyond(s, length) {
                    return Err(wrong(phi, "cli-angle-not-welded"));
                }
                Ok((s, *phi))
            };
            return angles.iter().map(place).collect::<Result<_, _>>().map(Self::Angles);
        }
        if let Some(step) = args.every_mm {
            let step = positive("--every-mm", step)?;
            let parts = parts_of(length, step);
            if parts > MAX_POINTS as usize {
                let allowed = Message::new("cli-at-least-step").value("step", length / f64::from(MAX_POINTS), Unit::Mm);
                let allowed = allowed.number("points", f64::from(MAX_POINTS), 0);
                return Err(refused("--every-mm", step, Message::new("cli-too-many-points"), allowed));
            }
            return Ok(Self::Steps { step, whole: parts as u64 - 1 });
        }
        match args.points.unwrap_or(points) {
            n if !(2..=MAX_POINTS).contains(&n) => Err(not_allowed("--points", n, between(2.0, f64::from(MAX_POINTS)))),
            n => Ok(Self::Points(n)),
        }
    }

    /// Calls `at` with every path length, and the angle as it was asked for (not counted on from the start).
    pub(super) fn each(
        &self,
        length: f64,
        mut at: impl FnMut(f64, Option<f64>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        match self {
            Self::Angles(angles) => angles.iter().try_for_each(|(s, phi)| at(*s, Some(*phi))),
            Self::Steps { step, whole } => {
                (0..=*whole).try_for_each(|i| at(i as f64 * step, None))?;
                at(length, None)
            }
            Self::Points(n) => (0..*n).try_for_each(|i| at(part_start(length, i as usize, *n as usize - 1), None)),
        }
    }
}
