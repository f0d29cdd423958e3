//! Text of the machine file of an imported arm.

use super::{ACCELERATION_PER_SPEED, ImportedArm, ImportedAxis, ImportedShape, JERK_PER_ACCELERATION};
use glam::{DAffine3, DVec3};
use seamwright_clearance::ShapeFile;
use seamwright_document::{Positive, Transform};
use seamwright_message::Language;
use std::fmt::Write as _;

/// Decimals of lengths, mm: rounding stays far below 1e-9 mm.
const LENGTH: i32 = 10;
/// Decimals of the parts of unit vectors.
const DIRECTION: i32 = 15;
/// Decimals of angles of fixed displacements, degrees.
const ANGLE: i32 = 12;
/// Decimals of ranges and speeds.
const LIMIT: i32 = 4;
/// Factor of a drive's torque on the torque that its axis needs, as in the supplied files.
const DRIVE_RESERVE: f64 = 2.5;
/// Moved inertia (kg m^2) and mass (kg) of axes without a torque in their source.
const USUAL_LOAD: [f64; 2] = [20.0, 300.0];

impl ImportedArm {
    /// The machine file.
    pub fn to_toml(&self) -> String {
        let mut text = self.head();
        for axis in &self.axes {
            axis.write(&mut text);
        }
        self.write_ends(&mut text);
        self.write_shapes(&mut text);
        self.write_drives(&mut text);
        text
    }

    fn head(&self) -> String {
        let mut text = format!("# {}\n", one_line(&self.title));
        line(&mut text, &format!("# Source of axes, ranges and speeds: {}", one_line(&self.source)));
        text += "# Assumed, as sources do not state them: accelerations (a quarter of a second to full speed), jerks (a tenth of a\n\
                 # second to full acceleration) and drives. Replace them by those of your arm and load.\n\
                 # With all axes at zero all frames are parallel to the base frame, so that `at_mm` is a point on the axis in that\n\
                 # frame.\n";
        for note in &self.notes {
            for part in note.in_language(Language::English).lines() {
                line(&mut text, &format!("# Note: {}", one_line(part)));
            }
        }
        let (name, title) = (quoted(&self.name), quoted(&self.title));
        text + &format!("schema = 1\nname = {name}\ntitle = {title}\nservo_period_ms = 4\n")
    }

    fn write_ends(&self, text: &mut String) {
        let flange = fixed(&self.flange).unwrap_or_default();
        line(text, &format!("\n# The flange: `{}`.\n[[tool]]\nfixed = {flange}", one_line(&self.flange_name)));
        match self.tool.as_ref().and_then(fixed) {
            Some(tool) => {
                line(
                    text,
                    &format!(
                        "\n# The torch's tool frame. Correct it after tool calibration.\n[[tool]]\nfixed = {tool}"
                    ),
                );
            }
            None => text.push_str(
                "\n# Without a tool frame the torch tip is the flange: add one, as tool calibration finds it.\n\
                 # [[tool]]\n# fixed = { move_mm = [90, 0, 330], turn = [0, 1, 0], angle_deg = 35 }\n",
            ),
        }
        line(text, &format!("\n[torch]\ndirection = {}", vector(self.direction, DIRECTION)));
        match fixed(&self.work).filter(|_| self.work != DAffine3::IDENTITY) {
            Some(work) => line(text, &format!("\n# The work frame in the base frame.\n[[work]]\nfixed = {work}")),
            None => text.push_str(
                "\n# The work frame is the base frame. Move it to the table:\n# [[work]]\n# fixed = { move_mm = [800, 0, 0] }\n",
            ),
        }
    }

    fn write_shapes(&self, text: &mut String) {
        if self.shapes.is_empty() {
            return;
        }
        text.push_str("\n# Shapes, each in the frame of its link.\n");
        for ImportedShape { link, solid } in &self.shapes {
            let name = solid.name.as_deref().unwrap_or(link);
            let at = fixed(&solid.at.affine()).map(|at| format!("at = {at}\n")).unwrap_or_default();
            line(text, &format!("[[shapes.{link}]]\nname = {}\nshape.{}", quoted(name), shape(&solid.shape)));
            text.push_str(&at);
        }
        if !self.ignored.is_empty() {
            let pairs: Vec<String> =
                self.ignored.iter().map(|[a, b]| format!("[{}, {}]", quoted(a), quoted(b))).collect();
            text.push_str("\n# Links whose shapes touch at the home position.\n[clearance]\n");
            line(text, &format!("ignore = [{}]", pairs.join(", ")));
        }
    }

    fn write_drives(&self, text: &mut String) {
        text.push_str("\n# Drives for the simulation only: assumed inertias with motor.\n");
        for (i, axis) in self.axes.iter().enumerate() {
            if i > 0 {
                text.push('\n');
            }
            axis.write_drive(text);
        }
    }
}

impl ImportedAxis {
    fn write(&self, text: &mut String) {
        let unit = if self.is_rotary { "deg" } else { "mm" };
        let own = |v: f64| if self.is_rotary { v.to_degrees() } else { v };
        let speed = rounded(own(self.max_speed), LIMIT).max(1e-3);
        let acceleration = ACCELERATION_PER_SPEED * speed;
        let comment =
            if self.source_name == self.name { String::new() } else { format!("   # {}", one_line(&self.source_name)) };
        line(text, &format!("\n[[tool]]\naxis = {}{comment}", quoted(&self.name)));
        if self.is_rotary {
            line(text, &format!("turn = {}", vector(self.direction, DIRECTION)));
            line(text, &format!("at_mm = {}", vector(self.at, LENGTH)));
        } else {
            line(text, &format!("move = {}", vector(self.direction, DIRECTION)));
        }
        match self.range {
            Some(range) => {
                let [low, high] = range.map(|v| number(own(v), LIMIT));
                line(text, &format!("range_{unit} = [{low}, {high}]"));
            }
            None => text.push_str("continuous = true\n"),
        }
        line(text, &format!("home_{unit} = {}", number(own(self.home), LIMIT)));
        line(text, &format!("max_speed_{unit}_s = {}", number(speed, LIMIT)));
        line(text, &format!("max_acceleration_{unit}_s2 = {}", number(acceleration, LIMIT)));
        line(text, &format!("max_jerk_{unit}_s3 = {}", number(JERK_PER_ACCELERATION * acceleration, LIMIT)));
    }

    fn write_drive(&self, text: &mut String) {
        // N m of rad/s^2, or N of mm/s^2.
        let acceleration = ACCELERATION_PER_SPEED * self.max_speed * if self.is_rotary { 1.0 } else { 1e-3 };
        let [inertia, mass] = USUAL_LOAD;
        let usual = if self.is_rotary { inertia } else { mass };
        let peak = self.effort.unwrap_or(DRIVE_RESERVE * usual * acceleration).max(1.0);
        let load = peak / (DRIVE_RESERVE * acceleration);
        let (friction, counts, bandwidth) = (0.03 * peak, if self.is_rotary { 20_000 } else { 1000 }, 30);
        line(text, &format!("[drives.{}]", self.name));
        let keys = if self.is_rotary {
            ["inertia_kg_m2", "peak_torque_n_m", "friction_n_m", "viscous_n_m_s_rad", "encoder_counts_per_deg"]
        } else {
            ["mass_kg", "peak_force_n", "friction_n", "viscous_n_s_m", "encoder_counts_per_mm"]
        };
        let values = [load, peak, friction, friction].map(|v| number(v, 3).to_string());
        for (key, value) in keys.iter().zip(values.into_iter().chain([counts.to_string()])) {
            line(text, &format!("{key} = {value}"));
        }
        line(text, &format!("velocity_bandwidth_hz = {bandwidth}"));
    }
}

fn line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{line}");
}

/// A displacement as an inline table; none if a number is not finite.
fn fixed(motion: &DAffine3) -> Option<String> {
    let transform = Transform::from_affine(motion)?;
    let angle = rounded(transform.angle_deg.get(), ANGLE);
    let mut parts = Vec::new();
    if transform.move_mm.get().abs().max_element() > 1e-10 || angle == 0.0 {
        parts.push(format!("move_mm = {}", vector(transform.move_mm.get(), LENGTH)));
    }
    if angle != 0.0 {
        let turn = transform.turn.map_or(DVec3::Z, seamwright_document::Direction::unit);
        parts.push(format!("turn = {}, angle_deg = {}", vector(turn, DIRECTION), number(angle, ANGLE)));
    }
    Some(format!("{{ {} }}", parts.join(", ")))
}

fn shape(shape: &ShapeFile) -> String {
    let mm = |v: &Positive| number(v.get(), 6);
    match shape {
        ShapeFile::Box { size_mm } => format!("box = {{ size_mm = [{}] }}", size_mm.each_ref().map(mm).join(", ")),
        ShapeFile::Sphere { radius_mm } => format!("sphere = {{ radius_mm = {} }}", mm(radius_mm)),
        ShapeFile::Cylinder { radius_mm, length_mm } => {
            format!("cylinder = {{ radius_mm = {}, length_mm = {} }}", mm(radius_mm), mm(length_mm))
        }
        ShapeFile::Capsule { radius_mm, length_mm } => {
            format!("capsule = {{ radius_mm = {}, length_mm = {} }}", mm(radius_mm), mm(length_mm))
        }
        ShapeFile::Stl { file, scale } => format!("stl = {{ file = {}, scale = {} }}", quoted(file), scale.get()),
        // Sources have no others.
        _ => String::new(),
    }
}

fn vector(v: DVec3, decimals: i32) -> String {
    format!("[{}]", v.to_array().map(|v| number(v, decimals)).join(", "))
}

fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10.0_f64.powi(decimals);
    let rounded = (value * scale).round() / scale;
    // Without the sign of a zero.
    if rounded == 0.0 { 0.0 } else { rounded }
}

fn number(value: f64, decimals: i32) -> String {
    rounded(value, decimals).to_string()
}

/// A text without line ends and other control characters.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", one_line(text).replace('\\', "\\\\").replace('"', "\\\""))
}
