use crate::normal::{normal_cdf, normal_quantile};
use schemars::JsonSchema;
use seamwright_document::{Finite, Positive};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// The distribution of a quantity. Numbers are values as in the file that they go into; those that are missing follow from
/// the nominal value: the one in the file, 0 for errors of the work and of axes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Distribution {
    /// Normal, perhaps truncated.
    Normal(Normal),
    /// Every value between two ends is equally probable.
    Uniform(Uniform),
    /// Rises from one end to the most probable value and falls to the other end.
    Triangular(Triangular),
    /// A sweep: these values one after the other, each with all draws of the other quantities.
    Values(Vec<Finite>),
}

/// A normal distribution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Normal {
    /// Standard deviation.
    pub deviation: Positive,
    /// Mean; the nominal value if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mean: Option<Finite>,
    /// Values below this do not occur: parts beyond a limit are sorted out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<Finite>,
    /// Values above this do not occur.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<Finite>,
    /// Maximum distance from the mean, instead of `min` and `max`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<Positive>,
}

/// A uniform distribution: `within`, or `min` and `max`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uniform {
    /// Maximum distance from the nominal value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<Positive>,
    /// Minimum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<Finite>,
    /// Maximum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<Finite>,
}

/// A triangular distribution: `within`, or `min` and `max`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Triangular {
    /// Maximum distance from the most probable value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<Positive>,
    /// Minimum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<Finite>,
    /// Maximum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<Finite>,
    /// Most probable value; the nominal value if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mode: Option<Finite>,
}

/// Why a distribution is invalid.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Path of the key below `draw`.
    pub key: &'static str,
    /// The fault.
    pub message: Message,
    /// Allowed values.
    pub allowed: Message,
}

impl Fault {
    fn new(key: &'static str, fault: &'static str, allowed: &'static str) -> Self {
        Self { key, message: Message::new(fault), allowed: Message::new(allowed) }
    }
}

/// A distribution with all its numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum Resolved {
    /// Normal between two ends, which may be infinite.
    Normal {
        /// Mean before it is truncated.
        mean: f64,
        /// Standard deviation before it is truncated.
        deviation: f64,
        /// Minimum.
        min: f64,
        /// Maximum.
        max: f64,
    },
    /// Uniform.
    Uniform {
        /// Minimum.
        min: f64,
        /// Maximum.
        max: f64,
    },
    /// Triangular.
    Triangular {
        /// Minimum.
        min: f64,
        /// Most probable value.
        mode: f64,
        /// Maximum.
        max: f64,
    },
    /// A sweep.
    Values(Vec<f64>),
}

impl Distribution {
    /// Fills in what follows from the nominal value, `None` if the file does not give it.
    ///
    /// # Errors
    /// Missing or contradicting numbers, a minimum above the maximum, an empty or repeated list.
    pub fn resolved(&self, nominal: Option<f64>) -> Result<Resolved, Fault> {
        match self {
            Self::Normal(normal) => normal.resolved(nominal),
            Self::Uniform(Uniform { within, min, max }) => {
                let keys = ["uniform.within", "uniform.min", "uniform.max", "uniform"];
                let (min, max) = ends(keys, (*within, *min, *max), nominal)?;
                Ok(Resolved::Uniform { min, max })
            }
            Self::Triangular(triangular) => triangular.resolved(nominal),
            Self::Values(values) => {
                let values: Vec<f64> = values.iter().map(|v| v.get()).collect();
                let is_twice = |i: usize| values[..i].iter().any(|v| v.total_cmp(&values[i]).is_eq());
                if values.is_empty() || (0..values.len()).any(is_twice) {
                    return Err(Fault::new("values", "study-values-unfit", "study-allowed-values"));
                }
                Ok(Resolved::Values(values))
            }
        }
    }
}

impl Normal {
    fn resolved(&self, nominal: Option<f64>) -> Result<Resolved, Fault> {
        let Some(mean) = self.mean.map(Finite::get).or(nominal) else {
            return Err(Fault::new("normal", "study-no-nominal", "study-mean-needed"));
        };
        let deviation = self.deviation.get();
        let (min, max) = match (self.within, self.min, self.max) {
            (Some(_), Some(_), _) | (Some(_), _, Some(_)) => {
                return Err(Fault::new("normal.within", "study-ends-twice", "study-within-or-ends"));
            }
            (Some(within), ..) => (mean - within.get(), mean + within.get()),
            (None, min, max) => (min.map_or(f64::NEG_INFINITY, Finite::get), max.map_or(f64::INFINITY, Finite::get)),
        };
        if min >= max {
            return Err(Fault::new("normal.min", "study-min-above-max", "study-allowed-min"));
        }
        // Truncation keeps a part of the values; a vanishing one is a mistake.
        if normal_cdf((max - mean) / deviation) - normal_cdf((min - mean) / deviation) < MIN_KEPT {
            return Err(Fault::new("normal", "study-nothing-kept", "study-ends-near-mean"));
        }
        Ok(Resolved::Normal { mean, deviation, min, max })
    }
}

/// Minimum probability that truncation leaves.
const MIN_KEPT: f64 = 1e-6;

impl Triangular {
    fn resolved(&self, nominal: Option<f64>) -> Result<Resolved, Fault> {
        let mode = self.mode.map(Finite::get).or(nominal);
        let keys = ["triangular.within", "triangular.min", "triangular.max", "triangular"];
        let (min, max) = ends(keys, (self.within, self.min, self.max), mode)?;
        let Some(mode) = mode else {
            return Err(Fault::new("triangular", "study-no-nominal", "study-mode-needed"));
        };
        if !(min..=max).contains(&mode) {
            return Err(Fault::new("triangular", "study-mode-outside", "study-allowed-mode"));
        }
        Ok(Resolved::Triangular { min, mode, max })
    }
}

/// Both ends of a distribution about `centre`; keys are those of `within`, `min`, `max` and of the distribution.
fn ends(
    [within_key, min_key, max_key, key]: [&'static str; 4],
    given: (Option<Positive>, Option<Finite>, Option<Finite>),
    centre: Option<f64>,
) -> Result<(f64, f64), Fault> {
    match given {
        (Some(within), None, None) => match centre {
            Some(centre) => Ok((centre - within.get(), centre + within.get())),
            None => Err(Fault::new(within_key, "study-no-nominal", "study-ends-needed")),
        },
        (Some(_), ..) => Err(Fault::new(within_key, "study-ends-twice", "study-within-or-ends")),
        (None, Some(min), Some(max)) if min.get() < max.get() => Ok((min.get(), max.get())),
        (None, Some(_), Some(_)) => Err(Fault::new(min_key, "study-min-above-max", "study-allowed-min")),
        (None, Some(_), None) => Err(Fault::new(min_key, "study-end-missing", "study-within-or-ends")),
        (None, None, Some(_)) => Err(Fault::new(max_key, "study-end-missing", "study-within-or-ends")),
        (None, None, None) => Err(Fault::new(key, "study-end-missing", "study-within-or-ends")),
    }
}

impl Resolved {
    /// The value below which a draw is with probability `u`, in (0, 1); of a sweep, its value at this part of the list.
    pub fn quantile(&self, u: f64) -> f64 {
        match self {
            Self::Normal { mean, deviation, min, max } => {
                let (low, high) = ((min - mean) / deviation, (max - mean) / deviation);
                // In the upper tail probabilities are close to 1: the lower tail keeps their digits.
                let x = if low > 0.0 {
                    let (a, b) = (normal_cdf(-high), normal_cdf(-low));
                    -normal_quantile((b - u * (b - a)).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON))
                } else {
                    let (a, b) = (normal_cdf(low), normal_cdf(high));
                    normal_quantile((a + u * (b - a)).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON))
                };
                (mean + deviation * x).clamp(*min, *max)
            }
            Self::Uniform { min, max } => min + u * (max - min),
            Self::Triangular { min, mode, max } => {
                let (left, right) = (mode - min, max - mode);
                let part = left / (max - min);
                if u < part {
                    min + (u * (max - min) * left).sqrt()
                } else {
                    max - ((1.0 - u) * (max - min) * right).sqrt()
                }
            }
            Self::Values(values) => values[((u * values.len() as f64) as usize).min(values.len() - 1)],
        }
    }

    /// Values of a sweep, if it is one.
    pub fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Values(values) => Some(values),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::moments::Moments;

    fn moments(resolved: &Resolved) -> Moments {
        let n = 20_000;
        (0..n).map(|i| resolved.quantile((f64::from(i) + 0.5) / f64::from(n))).collect()
    }

    fn finite(value: f64) -> Option<Finite> {
        Finite::new(value)
    }

    #[test]
    fn moments_are_those_of_closed_forms() {
        let (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
        let truncated =
            (1.0 - 2.0 * 2.0 * (-2.0f64).exp() / (2.0 * std::f64::consts::PI).sqrt() / 0.954_499_736_103_641_6).sqrt();
        for (resolved, mean, deviation) in [
            (Resolved::Normal { mean: 5.0, deviation: 2.0, min: low, max: high }, 5.0, 2.0),
            // Symmetric about the mean at two deviations.
            (Resolved::Normal { mean: 5.0, deviation: 2.0, min: 1.0, max: 9.0 }, 5.0, 2.0 * truncated),
            // Half-normal: the upper half, and its mirror image.
            (
                Resolved::Normal { mean: 0.0, deviation: 1.0, min: 0.0, max: high },
                (2.0 / std::f64::consts::PI).sqrt(),
                (1.0 - 2.0 / std::f64::consts::PI).sqrt(),
            ),
            (Resolved::Uniform { min: -3.0, max: 1.0 }, -1.0, 4.0 / 12f64.sqrt()),
            (Resolved::Triangular { min: 0.0, mode: 1.0, max: 4.0 }, 5.0 / 3.0, (13.0f64 / 18.0).sqrt()),
        ] {
            let found = moments(&resolved);
            assert!((found.mean() - mean).abs() < 1e-3, "{resolved:?}: {}", found.mean());
            assert!((found.deviation() - deviation).abs() < 2e-3, "{resolved:?}: {}", found.deviation());
        }
    }

    #[test]
    fn a_far_tail_keeps_its_digits() {
        let tail = Resolved::Normal { mean: 0.0, deviation: 1.0, min: 4.0, max: f64::INFINITY };
        let median = -normal_quantile(0.5 * normal_cdf(-4.0));
        assert!((tail.quantile(0.5) - median).abs() < 1e-12 && tail.quantile(1e-9) >= 4.0);
    }

    #[test]
    fn what_is_missing_follows_from_the_nominal_value() {
        let normal = Normal { deviation: Positive::new(2.0).unwrap(), mean: None, min: None, max: None, within: None };
        let uniform = Uniform { within: Positive::new(3.0), min: None, max: None };
        assert_eq!(
            Distribution::Uniform(uniform).resolved(Some(10.0)).unwrap(),
            Resolved::Uniform { min: 7.0, max: 13.0 }
        );
        assert_eq!(Distribution::Normal(normal).resolved(None).unwrap_err().message.code, "study-no-nominal");
        let reversed = Uniform { within: None, min: finite(3.0), max: finite(1.0) };
        assert_eq!(Distribution::Uniform(reversed).resolved(None).unwrap_err().message.code, "study-min-above-max");
        let open = Uniform { within: None, min: finite(3.0), max: None };
        assert_eq!(Distribution::Uniform(open).resolved(None).unwrap_err().message.code, "study-end-missing");
        let far = Distribution::Normal(Normal { min: finite(100.0), ..normal });
        assert_eq!(far.resolved(Some(0.0)).unwrap_err().message.code, "study-nothing-kept");
        let twice = Distribution::Values(vec![Finite::new(1.0).unwrap(); 2]);
        assert_eq!(twice.resolved(None).unwrap_err().message.code, "study-values-unfit");
    }
}
