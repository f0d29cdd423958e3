use crate::rows::{Cell, Rows};
use crate::verbs::process_columns::ProcessColumns;
use seamwright_machine::Joints;
use seamwright_motion::SetPoint;
use seamwright_program::ArcTime;
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;

/// The position along the seam at an instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Along {
    /// Counted from 1; 0 in the air.
    pub(super) pass: usize,
    /// Path length, mm; no number in the air, like the speed.
    pub(super) s: f64,
    /// Speed of the tip, mm/s.
    pub(super) speed: f64,
    /// `None` while the arc is off.
    pub(super) arc: Option<ArcTime>,
}

impl Along {
    pub(super) fn new(pass: usize, set: &SetPoint, speed: f64, arc: Option<ArcTime>) -> Self {
        Self { pass, s: set.profile.s, speed, arc }
    }
}

pub(super) struct Row {
    pub(super) t: f64,
    pub(super) along: Along,
    /// Positions, or control points.
    pub(super) q: Joints,
    /// Speeds of the axes, with positions for moves by position, velocity and time.
    pub(super) speeds: Option<Joints>,
    /// Phase of a run under commands.
    pub(super) phase: Option<&'static str>,
}

/// Columns beside those of every table of set-points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum More {
    None,
    Speeds,
    Phase,
}

/// Set-points as rows on standard output.
pub(super) struct Table<'a> {
    loaded: &'a Loaded,
    process: ProcessColumns<'a>,
    rows: Rows,
    /// Of the row being written.
    cells: Vec<Cell<'static>>,
}

impl<'a> Table<'a> {
    pub(super) fn new(loaded: &'a Loaded, more: More, json: bool) -> Self {
        let axes = &loaded.machine.axes;
        let process = ProcessColumns::new(&loaded.welding.program.value);
        let mut columns: Vec<String> = ["t_s", "pass", "s_mm"].map(str::to_owned).into();
        columns.extend(axes.iter().map(|a| a.name.clone()));
        if more == More::Speeds {
            columns.extend(axes.iter().map(|a| format!("{}_{}_s", a.name, a.unit())));
        }
        columns.extend(["speed_mm_s".to_owned(), "arc".to_owned()]);
        columns.extend((more == More::Phase).then(|| "phase".to_owned()));
        columns.extend_from_slice(process.names());
        Self { loaded, process, rows: Rows::new(columns, json), cells: Vec::new() }
    }

    pub(super) fn row(&mut self, row: &Row) -> Result<(), Failure> {
        let Along { pass, s, speed, arc } = row.along;
        let number = |v: f64| if v.is_finite() { Cell::Number(v) } else { Cell::Empty };
        let axes = &self.loaded.machine.axes;
        let cells = &mut self.cells;
        cells.clear();
        cells.extend([Cell::Number(row.t), Cell::Count(pass as u64), number(s)]);
        for values in [Some(&row.q), row.speeds.as_ref()].into_iter().flatten() {
            cells.extend(axes.iter().zip(values).map(|(axis, value)| Cell::Number(axis.to_file(*value))));
        }
        cells.extend([number(speed), Cell::Count(u64::from(arc.is_some()))]);
        cells.extend(row.phase.map(Cell::Text));
        cells.extend(self.process.values(pass, s, arc).map(Cell::Number));
        self.rows.row(cells)
    }

    pub(super) fn finish(self) -> Result<(), Failure> {
        self.rows.finish()
    }
}
