use crate::plane_map::{MapError, PlaneMap};
use glam::{DVec2, DVec3};
use seamwright_message::{Message, Unit, display_by_message};

/// Error of a map between pixels and space. Rows count from 0, heights are in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum HeightError {
    /// An empty table.
    Empty,
    /// Heights that do not increase.
    Order { row: usize, height: f64 },
    /// Rows of frames of different sizes.
    Size { row: usize },
    /// A row and the next one are too different for a valid map between them.
    Between { row: usize, why: MapError },
    /// A height outside the table.
    Outside { height: f64, low: f64, high: f64 },
    /// A pixel beyond the fold of the distortion.
    Folded { x: f64, y: f64 },
}

display_by_message!(HeightError);

impl HeightError {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        let of_row = |code, row: usize| Message::new(code).text("row", row.to_string());
        match *self {
            Self::Empty => Message::new("geometry-heights-empty"),
            Self::Order { row, height } => of_row("geometry-heights-order", row).value("height", height, Unit::Mm),
            Self::Size { row } => of_row("geometry-heights-frame-size", row),
            Self::Between { row, why } => of_row("geometry-heights-between", row)
                .text("next", (row + 1).to_string())
                .message("why", why.message()),
            Self::Outside { height, low, high } => Message::new("geometry-height-outside")
                .quantity("height", height, Unit::Mm, 3)
                .value("min", low, Unit::Mm)
                .value("max", high, Unit::Mm),
            Self::Folded { x, y } => Message::new("geometry-pixel-folded").number("x", x, 1).number("y", y, 1),
        }
    }
}

/// Maps at several heights, linear between them; or one map for every height. A camera with a pinhole, and a beam that
/// is deflected about a point, are linear in height exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightTable {
    rows: Vec<(f64, PlaneMap)>,
}

impl HeightTable {
    /// One map for every height: a telecentric lens.
    pub fn telecentric(map: PlaneMap) -> Self {
        Self { rows: vec![(0.0, map)] }
    }

    /// Maps at two or more heights (mm), increasing.
    ///
    /// # Errors
    /// Rows that are too few, out of order, of different frames or too different.
    pub fn new(rows: Vec<(f64, PlaneMap)>) -> Result<Self, HeightError> {
        let Some((_, first)) = rows.first() else { return Err(HeightError::Empty) };
        if let Some(row) = rows.iter().position(|(_, map)| map.parameters().size_px != first.parameters().size_px) {
            return Err(HeightError::Size { row });
        }
        for (i, pair) in rows.windows(2).enumerate() {
            let finite = pair[1].0.is_finite() && pair[0].0.is_finite();
            if !finite || pair[1].0 <= pair[0].0 {
                return Err(HeightError::Order { row: i + 1, height: pair[1].0 });
            }
            pair[0].1.mixed(&pair[1].1, 0.5).map_err(|why| HeightError::Between { row: i, why })?;
        }
        Ok(Self { rows })
    }

    /// Heights (mm) with their maps.
    pub fn rows(&self) -> &[(f64, PlaneMap)] {
        &self.rows
    }

    /// Size of a frame, pixels.
    pub fn size_px(&self) -> (usize, usize) {
        self.rows[0].1.parameters().size_px
    }

    /// Lowest and highest height, mm.
    pub fn range(&self) -> (f64, f64) {
        match self.rows.as_slice() {
            [(low, _), .., (high, _)] => (*low, *high),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// The map on the plane at `height`, mm.
    ///
    /// # Errors
    /// [`HeightError::Outside`]: the height is outside the table.
    pub fn at(&self, height: f64) -> Result<PlaneMap, HeightError> {
        let (low, high) = self.range();
        if !(low..=high).contains(&height) || height.is_nan() {
            return Err(HeightError::Outside { height, low, high });
        }
        let above = self.rows.partition_point(|(h, _)| *h < height);
        if self.rows.len() == 1 || above == 0 {
            return Ok(self.rows[0].1);
        }
        let ((from, a), (to, b)) = (&self.rows[above - 1], &self.rows[above]);
        a.mixed(b, (height - from) / (to - from)).map_err(|why| HeightError::Between { row: above - 1, why })
    }

    /// The pixel of a point in the camera's frame, mm.
    ///
    /// # Errors
    /// A height outside the table, a point beyond the distortion's fold.
    pub fn to_px(&self, point: DVec3) -> Result<DVec2, HeightError> {
        let map = self.at(point.z)?;
        map.to_px(point.truncate()).ok_or(HeightError::Folded { x: point.x, y: point.y })
    }

    /// The point in the camera's frame, mm, seen by a pixel on the plane at `height`.
    ///
    /// # Errors
    /// A height outside the table, a pixel beyond the distortion's fold.
    pub fn to_point(&self, px: DVec2, height: f64) -> Result<DVec3, HeightError> {
        let mm = self.at(height)?.to_mm(px).ok_or(HeightError::Folded { x: px.x, y: px.y })?;
        Ok(mm.extend(height))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane_map::MapParameters;

    fn row(height: f64, scale: f64) -> (f64, PlaneMap) {
        let parameters = MapParameters {
            size_px: (640, 480),
            centre_px: DVec2::new(320.0, 240.0),
            mm_per_px: DVec2::splat(scale),
            rotation: 0.1,
            shear: 0.01,
            barrel: -0.02,
        };
        (height, PlaneMap::new(parameters).unwrap())
    }

    #[test]
    fn a_pinhole_is_exact_between_rows() {
        // Focal length 1000 px, 200 mm before height 0.
        let table = HeightTable::new(vec![row(-50.0, 0.15), row(0.0, 0.2), row(100.0, 0.3)]).unwrap();
        for height in [-50.0, -20.0, 0.0, 33.0, 100.0] {
            let exact = row(height, (200.0 + height) / 1000.0).1;
            let px = DVec2::new(500.0, 100.0);
            let point = table.to_point(px, height).unwrap();
            assert!((point.truncate() - exact.to_mm(px).unwrap()).length() < 1e-12);
            assert!((table.to_px(point).unwrap() - px).length() < 1e-9);
        }
        let e = table.to_point(DVec2::ZERO, 100.5).unwrap_err();
        assert_eq!(e, HeightError::Outside { height: 100.5, low: -50.0, high: 100.0 });
        assert!(e.to_string().contains("-50 mm to 100 mm"));
        assert!(table.at(f64::NAN).is_err());
    }

    #[test]
    fn one_row_is_for_every_height() {
        let table = HeightTable::telecentric(row(0.0, 0.1).1);
        assert_eq!(table.at(-1e3), table.at(1e3));
        assert!(table.at(f64::NAN).is_err());
    }

    #[test]
    fn tables_that_are_none_are_refused() {
        assert_eq!(HeightTable::new(Vec::new()), Err(HeightError::Empty));
        let twice = HeightTable::new(vec![row(1.0, 0.1), row(1.0, 0.1)]);
        assert_eq!(twice, Err(HeightError::Order { row: 1, height: 1.0 }));
    }
}
