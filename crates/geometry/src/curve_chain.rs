use crate::arc::Arc;
use crate::curve::{Curve, Jet};
use crate::error::Error;
use crate::line::Line;
use glam::DVec3;

/// Lines and arcs joined end to start; `u` is the length from the start, mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    pieces: Vec<Piece>,
    /// Start of each piece, and the end of the last, mm.
    starts: Vec<f64>,
    closed: bool,
}

/// A piece of a [`Chain`].
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// A straight line.
    Line(Line),
    /// An arc.
    Arc(Arc),
}

/// Maximum gap between joined pieces, mm and as a fraction of the chain's length.
const GAP: f64 = 1e-9;

impl Piece {
    fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.domain().1,
            Self::Arc(arc) => arc.domain().1 * arc.radius(),
        }
    }

    /// The jet by length, `x` mm into the piece.
    fn jet(&self, x: f64) -> Jet {
        match self {
            Self::Line(line) => line.jet(x),
            Self::Arc(arc) => {
                let radius = arc.radius();
                let jet = arc.jet(x / radius);
                Jet { point: jet.point, d1: jet.d1 / radius, d2: jet.d2 / (radius * radius) }
            }
        }
    }
}

impl Chain {
    /// The chain of `pieces`; if `closed`, the first follows on the last.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] without pieces, [`Error::Gap`] if a piece does not start at the end of the one before.
    pub fn new(pieces: Vec<Piece>, closed: bool) -> Result<Self, Error> {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
            return Err(Error::TooFewPoints { what: "geometry-points-chain", given: 0, min: 1 });
        };
        let mut starts = vec![0.0];
        for piece in &pieces {
            starts.push(starts[starts.len() - 1] + piece.length());
        }
        let most = GAP * (1.0 + starts[pieces.len()]);
        let joins = |a: &Piece, b: &Piece| a.jet(a.length()).point.distance(b.jet(0.0).point) <= most;
        if let Some(i) = pieces.windows(2).position(|pair| !joins(&pair[0], &pair[1])) {
            return Err(Error::Gap { piece: i + 1 });
        }
        if closed && !joins(last, first) {
            return Err(Error::Gap { piece: 0 });
        }
        Ok(Self { closed, pieces, starts })
    }

    /// Lines from point to point, and from the last to the first if `closed`.
    ///
    /// # Errors
    /// [`Error::Size`] if a point is where the one before is, [`Error::TooFewPoints`] for fewer than two.
    pub fn through(points: &[DVec3], closed: bool) -> Result<Self, Error> {
        let pairs = points.windows(2).map(|pair| (pair[0], pair[1]));
        let last = points.last().zip(points.first()).filter(|_| closed).map(|(last, first)| (*last, *first));
        let line = |(a, b)| Line::new(a, b).map(Piece::Line);
        Self::new(pairs.chain(last).map(line).collect::<Result<_, _>>()?, closed)
    }

    fn length(&self) -> f64 {
        self.starts[self.pieces.len()]
    }
}

impl Curve for Chain {
    fn domain(&self) -> (f64, f64) {
        (0.0, self.length())
    }

    fn closed(&self) -> bool {
        self.closed
    }

    fn jet(&self, u: f64) -> Jet {
        let outside = !(0.0..=self.length()).contains(&u);
        let u = if outside && self.closed { u.rem_euclid(self.length()) } else { u };
        let i = self.starts[1..self.pieces.len()].partition_point(|start| *start <= u);
        self.pieces[i].jet(u - self.starts[i])
    }

    fn breaks(&self) -> Vec<f64> {
        // The closing point is also a break.
        self.starts[usize::from(!self.closed)..self.pieces.len()].to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arc_length::{ByLength, DEFAULT_ACCURACY_MM};

    #[test]
    fn runs_through_its_pieces() {
        let (a, b) = (DVec3::new(30.0, 0.0, 0.0), DVec3::new(40.0, 10.0, 0.0));
        let arc = Arc::new(DVec3::new(30.0, 10.0, 0.0), DVec3::Z, a, 0.5 * std::f64::consts::PI).unwrap();
        let line = |a, b| Piece::Line(Line::new(a, b).unwrap());
        let chain =
            Chain::new(vec![line(DVec3::ZERO, a), Piece::Arc(arc), line(b, b + 20.0 * DVec3::Y)], false).unwrap();
        let quarter = 5.0 * std::f64::consts::PI;
        assert!((chain.domain().1 - 50.0 - quarter).abs() < 1e-12 && !chain.closed());
        assert_eq!(chain.breaks(), [30.0, 30.0 + quarter]);
        for (u, d2) in [(29.999_999, 0.0), (30.0, 0.1), (30.0 + quarter - 1e-6, 0.1), (30.0 + quarter, 0.0)] {
            assert!((chain.jet(u).d2.length() - d2).abs() < 1e-9 && (chain.jet(u).d1.length() - 1.0).abs() < 1e-12);
        }
        let by_length = ByLength::new(&chain, DEFAULT_ACCURACY_MM).unwrap();
        for i in 0..=1000 {
            let s = chain.domain().1 * f64::from(i) / 1000.0;
            assert!((by_length.parameter(s) - s).abs() < 1e-12);
        }
    }

    #[test]
    fn closes_and_repeats() {
        let points = [DVec3::ZERO, DVec3::new(3.0, 0.0, 0.0), DVec3::new(0.0, 4.0, 0.0)];
        let triangle = Chain::through(&points, true).unwrap();
        assert!(triangle.closed() && triangle.breaks() == [0.0, 3.0, 8.0]);
        assert!((triangle.point(12.0) - triangle.point(0.0)).length() < 1e-15);
        assert!((triangle.point(-1.0) - DVec3::new(0.0, 1.0, 0.0)).length() < 1e-15);
        assert!((triangle.point(13.0) - DVec3::X).length() < 1e-14);
        assert_eq!(Chain::through(&points, false).unwrap().breaks(), [3.0]);
    }

    #[test]
    fn refuses_gaps_and_nothing() {
        let line = |a, b| Piece::Line(Line::new(a, b).unwrap());
        let apart = vec![line(DVec3::ZERO, DVec3::X), line(DVec3::Y, DVec3::Z)];
        assert_eq!(Chain::new(apart, false), Err(Error::Gap { piece: 1 }));
        assert_eq!(Chain::new(vec![line(DVec3::ZERO, DVec3::X)], true), Err(Error::Gap { piece: 0 }));
        assert!(Chain::through(&[DVec3::X], false).is_err());
        assert!(Chain::through(&[DVec3::X, DVec3::X], false).is_err());
    }
}
