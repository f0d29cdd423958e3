use super::{Canvas, Disturbances, OrientedPoint, Random, Texture};
use glam::DVec2;
use seamwright_vision::Image;
use seamwright_vision::joint::Start;
use std::f64::consts::{PI, TAU};

/// Content of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A bent joint from rim to rim with a tack, all disturbances, contrast to noise at least 2.
    Clear,
    /// The same, contrast to noise 1 to 2.
    Faint,
    /// Parallel scratches 5 to 30 pixels beside the joint and some across.
    Scratches,
    /// One side much darker than the other: the edge of a shadow along the joint, which is darker than either side.
    Step,
    /// A second joint branches off.
    Branch,
    /// The joint turns back.
    UTurn,
    /// The joint is a closed loop.
    Loop,
    /// The joint ends in the frame.
    End,
    /// Two joints cross.
    Cross,
    /// No joint, texture and shading alone.
    Blank,
    /// No joint but scratches.
    OnlyScratches,
    /// As a step, but the shadow also covers the joint. At its edge the joint is not darker than both sides.
    Shadow,
}

impl Kind {
    /// All kinds, those without a joint last.
    pub const ALL: [Self; 12] = [
        Self::Clear,
        Self::Faint,
        Self::Scratches,
        Self::Step,
        Self::Branch,
        Self::UTurn,
        Self::Loop,
        Self::End,
        Self::Cross,
        Self::Shadow,
        Self::Blank,
        Self::OnlyScratches,
    ];

    /// Returns its name in tables and file names.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Clear => "clear",
            Self::Faint => "faint",
            Self::Scratches => "scratches",
            Self::Step => "step",
            Self::Shadow => "shadow",
            Self::Branch => "branch",
            Self::UTurn => "u-turn",
            Self::Loop => "loop",
            Self::End => "end",
            Self::Cross => "cross",
            Self::Blank => "blank",
            Self::OnlyScratches => "only-scratches",
        }
    }
}

/// Hidden truth of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// The midline, pixels, half a pixel apart; empty if there is no joint.
    pub midline: Vec<DVec2>,
    /// Visibility of each point of the midline. A visible point is as deep as twice the noise, or half as deep as the
    /// whole joint if that is less. Tacks and out-of-focus edges of light hide the joint.
    pub shown: Vec<bool>,
    /// Full width at half depth, pixels, before defocus.
    pub width: f64,
    /// Contrast to noise, both of the frame: after defocus.
    pub cnr: f64,
    /// Centres and radii of tacks.
    pub tacks: Vec<(DVec2, f64)>,
    /// End of the joint, if it ends.
    pub end: Option<DVec2>,
    /// The joint returns to its start.
    pub closed: bool,
}

/// A frame, a start, and the hidden truth.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The frame.
    pub image: Image,
    /// Start of the search near the joint's start, off by up to 1.5 pixels and 6 degrees.
    pub start: Start,
    /// Hidden truth.
    pub truth: Truth,
}

/// Minimum depth of a visible joint, as a multiple of the noise.
const SHOWN: f64 = 2.0;

/// Distance of the midline's points, pixels.
const SPACING: f64 = 0.5;

/// Creates the scene of a kind and seed, `size` pixels wide and high.
#[must_use]
pub fn scene(kind: Kind, seed: u64, size: usize) -> Scene {
    let mut random = Random::new(seed.wrapping_mul(16).wrapping_add(kind as u64));
    let r = &mut random;
    let side = size as f64;
    let contrast = if kind == Kind::Faint { r.within(8.0, 40.0) } else { r.within(12.0, 60.0) };
    let cnr = if kind == Kind::Faint { r.within(1.0, 2.0) } else { r.within(2.0, 8.0) };
    // Uniform in the logarithm: most joints are narrow.
    let width = 2.0 * 20f64.powf(r.within(0.0, 1.0) * if matches!(kind, Kind::UTurn | Kind::Loop) { 0.6 } else { 1.0 });
    let mut midline = midline(kind, side, width, r);
    let metal = r.within(110.0, 170.0);
    let mut canvas = Canvas::new(size, size, metal);
    let direction = heading(&midline, 0);
    let disturbances = disturb(contrast / cnr, width, direction, r);
    let closed = kind == Kind::Loop;
    let mut truth = Truth { midline: Vec::new(), shown: Vec::new(), width, cnr, tacks: Vec::new(), end: None, closed };
    let jointless = matches!(kind, Kind::Blank | Kind::OnlyScratches);
    if !jointless {
        if kind == Kind::End {
            let keep = (midline.len() as f64 * r.within(0.45, 0.7)) as usize;
            midline.truncate(keep);
            truth.end = midline.last().copied();
        }
        let darker = edge_of_light(kind, &midline, r);
        if let (Kind::Step, Some((depth, line))) = (kind, darker) {
            canvas.step(depth, line);
            canvas.gap(&midline, width, metal - depth - contrast);
        } else {
            canvas.line(&midline, width, contrast, |_| 1.0);
        }
        if let (Kind::Shadow, Some((depth, line))) = (kind, darker) {
            canvas.step(depth, line);
        }
        other_joint(kind, &midline, width, contrast, &mut canvas, r);
    }
    if matches!(kind, Kind::Scratches | Kind::OnlyScratches) {
        scratches(&midline, contrast, &mut canvas, r);
    }
    let tacked = matches!(kind, Kind::Clear | Kind::Faint | Kind::Scratches | Kind::Step | Kind::Shadow);
    if tacked && r.chance(0.7) {
        let radius = (r.within(0.0, 40.0)).max(0.6 * width);
        let at = midline[(midline.len() as f64 * r.within(0.35, 0.7)) as usize];
        canvas.tack(at, radius, 150.0, r);
        truth.tacks.push((at, radius));
    }
    let begin = midline[0] + DVec2::new(r.within(-1.0, 1.0), r.within(-1.0, 1.0));
    let start = Start {
        x: begin.x as f32,
        y: begin.y as f32,
        direction: (direction + r.within(-0.1, 0.1)) as f32,
        width: None,
    };
    if !jointless {
        truth.midline = midline;
    }
    canvas.light_up(&disturbances, &truth.midline, width, r);
    truth.shown = shown(&canvas, &disturbances, &truth);
    Scene { image: canvas.take(&disturbances, r), start, truth }
}

/// Returns the visibility of each point of the midline in a frame of this light.
fn shown(canvas: &Canvas, d: &Disturbances, truth: &Truth) -> Vec<bool> {
    let noise = d.noise.hypot(d.texture.deviation).hypot(d.charging);
    let least = (0.5 * truth.cnr).min(SHOWN) * noise;
    let reach = 1.5 * truth.width + 2.0 * d.defocus as f64 + 1.0;
    let normal = |i| DVec2::from_angle(heading(&truth.midline, i)).perp();
    let points = truth.midline.iter().enumerate().map(|(i, point)| OrientedPoint { point: *point, normal: normal(i) });
    points.map(|at| canvas.depth(d, at, reach)).map(|depth| depth >= least).collect()
}

/// Direction of the midline at its point `i`, rad.
fn heading(midline: &[DVec2], i: usize) -> f64 {
    let to = (i + 12).min(midline.len() - 1);
    (midline[to] - midline[to.saturating_sub(12)]).to_angle()
}

/// Step of brightness: depth, and its line, which runs along the joint's middle.
fn edge_of_light(kind: Kind, midline: &[DVec2], r: &mut Random) -> Option<(f64, OrientedPoint)> {
    if !matches!(kind, Kind::Step | Kind::Shadow) {
        return None;
    }
    let place = midline[midline.len() / 2];
    let normal = DVec2::from_angle(heading(midline, midline.len() / 2)).perp();
    Some((r.within(20.0, 50.0), OrientedPoint { point: place + normal * r.within(-30.0, 30.0), normal }))
}

fn midline(kind: Kind, side: f64, width: f64, r: &mut Random) -> Vec<DVec2> {
    let centre = DVec2::splat(side / 2.0);
    let turn = DVec2::from_angle(r.within(0.0, TAU));
    if kind == Kind::Loop {
        let radius = side * r.within(0.22, 0.36);
        let (count, way) = (TAU * radius / SPACING, if r.chance(0.5) { 1.0 } else { -1.0 });
        return (0..=count as usize)
            .map(|i| centre + radius * turn.rotate(DVec2::from_angle(way * i as f64 * TAU / count)))
            .collect();
    }
    if kind == Kind::UTurn {
        let (radius, leg) = (side * r.within(0.12, 0.2), side * 0.25);
        let length = 2.0 * leg + PI * radius;
        return (0..(length / SPACING) as usize)
            .map(|i| {
                let s = i as f64 * SPACING;
                let p = if s < leg {
                    DVec2::new(s - leg, -radius)
                } else if s < leg + PI * radius {
                    radius * DVec2::from_angle((s - leg) / radius - PI / 2.0)
                } else {
                    DVec2::new(leg + PI * radius - s, radius)
                };
                centre + turn.rotate(p)
            })
            .collect();
    }
    // Waves about a straight line through the frame.
    let straight = matches!(kind, Kind::Branch | Kind::Cross);
    let bend = if straight { 0.3 } else { 1.0 };
    let waves: Vec<(f64, f64, f64)> = (1..=2)
        .map(|k| (bend * r.within(0.0, 16.0) / f64::from(k), TAU * f64::from(k) / side, r.within(0.0, TAU)))
        .collect();
    let offset = r.within(-0.1, 0.1) * side;
    let inset = 12.0f64.max(width);
    let points = (0..(2.0 * side / SPACING) as usize).map(|i| {
        let s = i as f64 * SPACING - side;
        let across: f64 = waves.iter().map(|(a, k, phase)| a * (k * s + phase).sin()).sum();
        centre + turn.rotate(DVec2::new(s, offset + across))
    });
    let inside = |p: &DVec2, m: f64| p.x >= m && p.y >= m && p.x < side - m && p.y < side - m;
    points.skip_while(|p| !inside(p, inset)).take_while(|p| inside(p, -1.5 * width)).collect()
}

/// Creates disturbances. A joint of `width` in focus has the required contrast to noise with `noise`.
fn disturb(noise: f64, width: f64, direction: f64, r: &mut Random) -> Disturbances {
    let mut some = |part: f64, most: f64| if r.chance(part) { r.within(0.0, most) } else { 0.0 };
    let (ramp, vignette) = ([some(0.5, 90.0), some(0.5, 40.0)], some(0.5, 50.0));
    // The noise is shared out: the squares of its deviations add up.
    let texture = some(0.4, 0.6);
    let charging = some(0.3, 0.3);
    let jitter = some(0.3, 0.4);
    let salt = some(0.2, 0.01);
    let defocus = some(0.2, 2.99) as usize;
    let noise = noise * contrast_left(width, defocus);
    let rest = (1.0 - texture * texture - charging * charging).sqrt();
    let sign = if r.chance(0.5) { -1.0 } else { 1.0 };
    Disturbances {
        noise: noise * rest,
        ramp: [sign * ramp[0], ramp[1]],
        vignette,
        texture: Texture { deviation: noise * texture, direction: direction + r.within(-0.5, 0.5) },
        jitter,
        charging: noise * charging,
        salt,
        defocus,
    }
}

/// Share of a line's contrast left by defocus: its bell and two boxes add their variances.
fn contrast_left(width: f64, defocus: usize) -> f64 {
    let (line, side) = ((width / 2.355).powi(2), (2 * defocus + 1) as f64);
    let boxes = 2.0 * (side * side - 1.0) / 12.0;
    (line / (line + boxes)).sqrt()
}

fn other_joint(kind: Kind, midline: &[DVec2], width: f64, contrast: f64, canvas: &mut Canvas, r: &mut Random) {
    let at = midline[midline.len() / 2];
    let angle = r.within(0.6, 1.2) * if r.chance(0.5) { 1.0 } else { -1.0 };
    let along = DVec2::from_angle(heading(midline, midline.len() / 2) + angle);
    match kind {
        Kind::Branch => canvas.line(&[at, at + 2000.0 * along], width, contrast, |_| 1.0),
        Kind::Cross => canvas.line(&[at - 2000.0 * along, at + 2000.0 * along], width, contrast, |_| 1.0),
        _ => {}
    }
}

/// Paints thin scratches beside the joint, shorter and fainter than it, and some across.
fn scratches(midline: &[DVec2], contrast: f64, canvas: &mut Canvas, r: &mut Random) {
    for _ in 0..8 {
        let i = r.within(0.0, midline.len() as f64 - 1.0) as usize;
        let along = DVec2::from_angle(heading(midline, i) + r.within(-0.05, 0.05));
        let side = if r.chance(0.5) { 1.0 } else { -1.0 };
        let from = midline[i] + along.perp() * side * r.within(5.0, 30.0);
        let length = r.within(30.0, 150.0);
        canvas.line(&[from, from + length * along], r.within(1.0, 2.0), contrast * r.within(0.2, 0.7), |_| 1.0);
    }
    for _ in 0..4 {
        let at = midline[r.within(0.0, midline.len() as f64 - 1.0) as usize];
        let along = DVec2::from_angle(r.within(0.0, TAU)) * r.within(20.0, 100.0);
        canvas.line(&[at - along, at + along], r.within(1.0, 2.0), contrast * r.within(0.2, 0.7), |_| 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defocus_leaves_so_much_of_the_contrast() {
        for width in [2.0, 3.0, 5.0, 10.0, 30.0] {
            for defocus in [0, 1, 2] {
                let mut canvas = Canvas::new(96, 96, 220.0);
                canvas.line(&[DVec2::new(-200.0, 48.0), DVec2::new(300.0, 48.0)], width, 200.0, |_| 1.0);
                let focus = Disturbances { defocus, ..Disturbances::default() };
                let Image::U8 { pixels, .. } = canvas.finish(&focus, &[], 0.0, &mut Random::new(1)) else {
                    panic!("a scene has 8 bits")
                };
                let darkest = pixels[48 * 96..49 * 96].iter().min().copied().unwrap_or(0);
                let (left, told) = ((220.0 - f64::from(darkest)) / 200.0, contrast_left(width, defocus));
                assert!((left - told).abs() < 0.04, "{width} {defocus}: {left}, {told}");
            }
        }
    }

    #[test]
    fn a_tack_hides_the_joint_and_a_ramp_does_not() {
        // Numbers of points and of visible points, under a tack and beside it.
        let (mut under, mut beside) = ([0, 0], [0, 0]);
        for seed in 0..40 {
            let Scene { truth, .. } = scene(Kind::Clear, seed, 512);
            let inside = |p: &DVec2| p.min_element() >= 0.0 && p.max_element() < 512.0;
            for (place, shown) in truth.midline.iter().zip(&truth.shown).filter(|(place, _)| inside(place)) {
                let away = truth.tacks.iter().map(|(middle, radius)| middle.distance(*place) - radius);
                let away = away.fold(f64::INFINITY, f64::min);
                let of = if away < 0.0 { &mut under } else { &mut beside };
                if away.abs() > 5.0 {
                    *of = [of[0] + 1, of[1] + usize::from(*shown)];
                }
            }
        }
        // A tack's ripples may look like a joint here and there.
        assert!(10 * under[1] < under[0] && 100 * (beside[0] - beside[1]) < beside[0], "{under:?} {beside:?}");
        // A wide, shallow joint on a ramp that would hide its darker side.
        let Scene { truth, .. } = scene(Kind::Clear, 895, 512);
        let shown = truth.shown.iter().filter(|shown| **shown).count();
        assert!(10 * shown > 9 * truth.shown.len(), "{shown} of {}", truth.shown.len());
    }
}
