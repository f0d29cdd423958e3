use crate::moments::Moments;
use crate::proportion::Interval;
use crate::sampling::Sampling;

/// Number of groups of draws that are left out in turn, for the confidence interval.
const GROUPS: usize = 16;
/// Student's 97.5 % quantile for 15 degrees of freedom.
const T95: f64 = 2.131_449_545_559_323;
/// Minimum number of draws: a group needs a few.
const MIN_DRAWS: usize = 2 * GROUPS;
/// Maximum number of classes.
const MAX_CLASSES: usize = 16;
/// Draws in a class, at least.
const CLASS_DRAWS: usize = 20;
/// Quantities with at most as many different values, each in a few draws, have a class for each: they are sweeps.
const MAX_LEVELS: usize = 64;
/// Draws for a value of a sweep, at least on average.
const LEVEL_DRAWS: usize = 4;

/// A first-order Sobol index with its 95 % confidence interval.
pub type Index = Interval;

/// First-order Sobol index from given data: the part of the variance of `y` that the quantity `x` explains alone,
/// `Var(E[y | x]) / Var(y)`. None with fewer than 32 draws, or if `y` does not vary.
///
/// Method: the draws are put into up to 16 classes of neighbouring `x`, and a straight line through the points of each
/// class stands for `E[y | x]`. The index is the adjusted coefficient of determination of these lines, which is free of the
/// bias of fitting noise. It needs no further draws, one set serves all quantities, and it is exact for linear effects.
/// A quantity with few values has a class for each. Sources: Plischke, Borgonovo, Smith, "Global sensitivity measures
/// from given data", European Journal of Operational Research 226 (2013) 536, for the classes; Storlie, Helton, Reliability
/// Engineering and System Safety 93 (2008) 28, for local regression. The interval is that of the delete-a-group jackknife
/// (Kott, Journal of Official Statistics 17 (2001) 521) with 16 groups.
///
/// A Sobol sequence is balanced in each class, so that there is little noise to fit: then the coefficient is not adjusted,
/// and the interval includes the adjusted one.
///
/// # Panics
/// If `x` and `y` have different lengths.
pub fn first_order(sampling: Sampling, x: &[f64], y: &[f64]) -> Option<Index> {
    assert_eq!(x.len(), y.len(), "a value of y for each x");
    let moments: Moments = y.iter().copied().collect();
    if x.len() < MIN_DRAWS || moments.is_constant() {
        return None;
    }
    let classes = classes(x, y, moments.mean());
    let left_out: Moments = (0..GROUPS).map(|group| determination(&classes, Some(group)).adjusted).collect();
    let groups = GROUPS as f64;
    let half = T95 * left_out.deviation() * (groups - 1.0) / groups.sqrt();
    let Determination { plain, adjusted } = determination(&classes, None);
    let estimate = if sampling == Sampling::Sobol { plain } else { adjusted };
    Some(Index { estimate, low: adjusted - half, high: estimate + half })
}

/// Sums over draws.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    n: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Sums {
    fn add(&mut self, x: f64, y: f64) {
        self.merge(&Self { n: 1.0, x, y, xx: x * x, xy: x * y, yy: y * y });
    }

    fn merge(&mut self, other: &Self) {
        self.n += other.n;
        self.x += other.x;
        self.y += other.y;
        self.xx += other.xx;
        self.xy += other.xy;
        self.yy += other.yy;
    }

    /// Sum of squares of `y` about its mean.
    fn total(&self) -> f64 {
        self.yy - self.y * self.y / self.n.max(1.0)
    }

    /// Sum of squares of `y` about the line, and the number of its parameters.
    fn residual(&self) -> (f64, f64) {
        if self.n < 1.0 {
            return (0.0, 0.0);
        }
        let spread = self.xx - self.x * self.x / self.n;
        // With one value of x there is no slope.
        if self.n < 3.0 || spread <= 1e-12 * self.xx {
            return (self.total(), 1.0);
        }
        let slope = (self.xy - self.x * self.y / self.n) / spread;
        ((self.total() - slope * slope * spread).max(0.0), 2.0)
    }
}

/// Sums of each class, by group.
type Class = [Sums; GROUPS];

fn classes(x: &[f64], y: &[f64], mean_y: f64) -> Vec<Class> {
    let mut order: Vec<u32> = (0..x.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| x[a as usize].total_cmp(&x[b as usize]).then(a.cmp(&b)));
    let is_new = |pair: &[u32]| x[pair[0] as usize] < x[pair[1] as usize];
    let levels = 1 + order.windows(2).filter(|pair| is_new(pair)).count();
    let is_sweep = levels <= MAX_LEVELS && levels * LEVEL_DRAWS <= x.len();
    let count = (x.len() / CLASS_DRAWS).clamp(1, MAX_CLASSES);
    let (mut classes, mut origin): (Vec<Class>, f64) = (Vec::new(), 0.0);
    for (i, &draw) in order.iter().enumerate() {
        let begins = match i {
            0 => true,
            _ if is_sweep => is_new(&order[i - 1..=i]),
            _ => i * count / x.len() != (i - 1) * count / x.len(),
        };
        let draw = draw as usize;
        if begins {
            classes.push(Class::default());
            origin = x[draw];
        }
        if let Some(class) = classes.last_mut() {
            // Sums about a value of the class keep their digits.
            class[draw * GROUPS / x.len()].add(x[draw] - origin, y[draw] - mean_y);
        }
    }
    classes
}

/// Coefficient of determination, as it is and adjusted for the number of parameters.
struct Determination {
    plain: f64,
    adjusted: f64,
}

/// Coefficient of determination of the lines, perhaps without a group.
fn determination(classes: &[Class], without: Option<usize>) -> Determination {
    let (mut all, mut residual, mut parameters) = (Sums::default(), 0.0, 0.0);
    for class in classes {
        let mut sums = Sums::default();
        for (_, group) in class.iter().enumerate().filter(|(group, _)| Some(*group) != without) {
            sums.merge(group);
        }
        all.merge(&Sums { x: 0.0, xx: 0.0, xy: 0.0, ..sums });
        let (squares, used) = sums.residual();
        residual += squares;
        parameters += used;
    }
    let unexplained = residual / all.total();
    Determination {
        plain: 1.0 - unexplained,
        adjusted: 1.0 - unexplained * (all.n - 1.0) / (all.n - parameters).max(1.0),
    }
}
