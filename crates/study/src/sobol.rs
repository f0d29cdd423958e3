//! The Sobol sequence: points that fill a cube evenly.
//!
//! Direction numbers: Joe, Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM Journal on
//! Scientific Computing 30 (2008) 2635, table `new-joe-kuo-6.21201`, the first 32 dimensions.

/// Number of dimensions.
pub const DIMENSIONS: usize = 32;

/// First direction numbers of a dimension.
struct Start {
    degree: u32,
    /// Inner coefficients of the primitive polynomial, one bit each.
    coefficients: u32,
    numbers: &'static [u32],
}

/// Dimensions from the second on.
static STARTS: [Start; DIMENSIONS - 1] = [
    Start { degree: 1, coefficients: 0, numbers: &[1] },
    Start { degree: 2, coefficients: 1, numbers: &[1, 3] },
    Start { degree: 3, coefficients: 1, numbers: &[1, 3, 1] },
    Start { degree: 3, coefficients: 2, numbers: &[1, 1, 1] },
    Start { degree: 4, coefficients: 1, numbers: &[1, 1, 3, 3] },
    Start { degree: 4, coefficients: 4, numbers: &[1, 3, 5, 13] },
    Start { degree: 5, coefficients: 2, numbers: &[1, 1, 5, 5, 17] },
    Start { degree: 5, coefficients: 4, numbers: &[1, 1, 5, 5, 5] },
    Start { degree: 5, coefficients: 7, numbers: &[1, 1, 7, 11, 19] },
    Start { degree: 5, coefficients: 11, numbers: &[1, 1, 5, 1, 1] },
    Start { degree: 5, coefficients: 13, numbers: &[1, 1, 1, 3, 11] },
    Start { degree: 5, coefficients: 14, numbers: &[1, 3, 5, 5, 31] },
    Start { degree: 6, coefficients: 1, numbers: &[1, 3, 3, 9, 7, 49] },
    Start { degree: 6, coefficients: 13, numbers: &[1, 1, 1, 15, 21, 21] },
    Start { degree: 6, coefficients: 16, numbers: &[1, 3, 1, 13, 27, 49] },
    Start { degree: 6, coefficients: 19, numbers: &[1, 1, 1, 15, 7, 5] },
    Start { degree: 6, coefficients: 22, numbers: &[1, 3, 1, 15, 13, 25] },
    Start { degree: 6, coefficients: 25, numbers: &[1, 1, 5, 5, 19, 61] },
    Start { degree: 7, coefficients: 1, numbers: &[1, 3, 7, 11, 23, 15, 103] },
    Start { degree: 7, coefficients: 4, numbers: &[1, 3, 7, 13, 13, 15, 69] },
    Start { degree: 7, coefficients: 7, numbers: &[1, 1, 3, 13, 7, 35, 63] },
    Start { degree: 7, coefficients: 8, numbers: &[1, 3, 5, 9, 1, 25, 53] },
    Start { degree: 7, coefficients: 14, numbers: &[1, 3, 1, 13, 9, 35, 107] },
    Start { degree: 7, coefficients: 19, numbers: &[1, 3, 1, 5, 27, 61, 31] },
    Start { degree: 7, coefficients: 21, numbers: &[1, 1, 5, 11, 19, 41, 61] },
    Start { degree: 7, coefficients: 28, numbers: &[1, 3, 5, 3, 3, 13, 69] },
    Start { degree: 7, coefficients: 31, numbers: &[1, 1, 7, 13, 1, 19, 1] },
    Start { degree: 7, coefficients: 32, numbers: &[1, 3, 7, 5, 13, 19, 59] },
    Start { degree: 7, coefficients: 37, numbers: &[1, 1, 3, 9, 25, 29, 41] },
    Start { degree: 7, coefficients: 41, numbers: &[1, 3, 5, 13, 23, 1, 55] },
    Start { degree: 7, coefficients: 42, numbers: &[1, 3, 7, 3, 13, 59, 17] },
];

/// Direction numbers of each dimension, by bit of the point's number.
static DIRECTIONS: [[u32; 32]; DIMENSIONS] = directions();

const fn directions() -> [[u32; 32]; DIMENSIONS] {
    let mut all = [[0; 32]; DIMENSIONS];
    let mut bit = 0;
    while bit < 32 {
        all[0][bit] = 1 << (31 - bit);
        bit += 1;
    }
    let mut dimension = 1;
    while dimension < DIMENSIONS {
        all[dimension] = of_start(&STARTS[dimension - 1]);
        dimension += 1;
    }
    all
}

/// The recurrence of Sobol, USSR Computational Mathematics and Mathematical Physics 7 (1967) 86; Joe and Kuo, equation 3.
const fn of_start(start: &Start) -> [u32; 32] {
    let degree = start.degree as usize;
    let mut v = [0; 32];
    let mut bit = 0;
    while bit < 32 {
        if bit < degree {
            v[bit] = start.numbers[bit] << (31 - bit);
        } else {
            v[bit] = v[bit - degree] ^ (v[bit - degree] >> degree);
            let mut k = 1;
            while k < degree {
                if start.coefficients >> (degree - 1 - k) & 1 == 1 {
                    v[bit] ^= v[bit - k];
                }
                k += 1;
            }
        }
        bit += 1;
    }
    v
}

/// Coordinate `dimension` of point `i` of the sequence in Gray code order, as a part of 2^32. The first point is 0.
///
/// # Panics
/// If `dimension` is [`DIMENSIONS`] or more.
pub fn sobol_point(i: u32, dimension: usize) -> u32 {
    let gray = i ^ (i >> 1);
    let directions = &DIRECTIONS[dimension];
    (0..32).filter(|bit| gray >> bit & 1 == 1).fold(0, |point, bit| point ^ directions[bit])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A published coordinate as a part of 2^32: it is a multiple of that.
    fn whole(coordinate: f64) -> u32 {
        (coordinate * 2f64.powi(32)) as u32
    }

    /// The first points in three dimensions that Joe and Kuo publish with their table.
    #[test]
    fn the_first_points_are_those_of_joe_and_kuo() {
        let published = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
            [0.1875, 0.3125, 0.9375],
            [0.6875, 0.8125, 0.4375],
        ];
        for (i, point) in published.iter().enumerate() {
            assert_eq!([0, 1, 2].map(|d| sobol_point(i as u32, d)), point.map(whole), "{i}");
        }
    }

    /// Point 1000 of SciPy 1.17, `scipy.stats.qmc.Sobol(32, scramble=False)`.
    #[test]
    fn a_later_point_is_that_of_scipy_in_all_dimensions() {
        let point = [
            0.219_726_562_5,
            0.096_679_687_5,
            0.518_554_687_5,
            0.676_757_812_5,
            0.280_273_437_5,
            0.907_226_562_5,
            0.045_898_437_5,
            0.899_414_062_5,
            0.500_976_562_5,
            0.069_335_937_5,
            0.084_960_937_5,
            0.254_882_812_5,
            0.161_132_812_5,
            0.383_789_062_5,
            0.143_554_687_5,
            0.370_117_187_5,
            0.719_726_562_5,
            0.344_726_562_5,
            0.991_210_937_5,
            0.725_585_937_5,
            0.522_460_937_5,
            0.549_804_687_5,
            0.950_195_312_5,
            0.540_039_062_5,
            0.583_007_812_5,
            0.907_226_562_5,
            0.040_039_062_5,
            0.979_492_187_5,
            0.059_570_312_5,
            0.340_820_312_5,
            0.147_460_937_5,
            0.145_507_812_5,
        ];
        assert_eq!(std::array::from_fn(|d| sobol_point(1000, d)), point.map(whole));
    }

    #[test]
    fn the_points_of_a_power_of_two_fill_all_strata() {
        for dimension in 0..DIMENSIONS {
            let mut strata: Vec<u32> = (0..256).map(|i| sobol_point(i, dimension) >> 24).collect();
            strata.sort_unstable();
            assert_eq!(strata, (0..256).collect::<Vec<_>>());
        }
    }
}
