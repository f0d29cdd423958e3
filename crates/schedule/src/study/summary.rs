//! Statistics of a study.

use super::columns::{Columns, Counts};
use super::draw::DrawResult;
use super::open::Study;
use crate::plan_row::Status;
use seamwright_project::failure::Failure;
use seamwright_study::{Interval, Moments, Sampling, first_order, quantile, wilson};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Plans besides the draws.
pub(crate) struct Nominals {
    /// All quantities at their nominal values.
    pub(crate) nominal: DrawResult,
    /// Each quantity at its low and its high value, one after the other.
    pub(crate) ends: Vec<DrawResult>,
}

/// Results of a study. This is `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StudySummary {
    /// Version of Seamwright that made the study.
    pub seamwright: &'static str,
    /// The study file.
    pub file: String,
    /// Its title.
    pub title: String,
    /// The job.
    pub job: String,
    /// The machine.
    pub machine: String,
    /// How values were drawn.
    pub sampling: Sampling,
    /// Seed of the draws.
    pub seed: u64,
    /// Number of draws.
    pub draws: u64,
    /// Number of plans that an earlier run had made.
    #[serde(skip)]
    pub kept: u64,
    /// Outcome of the plan without uncertainty.
    pub nominal: Outcome,
    /// Probability that the weld can be made as asked.
    pub weldable: Interval,
    /// First-order indices of that, by quantity.
    pub weldable_indices: Vec<IndexSummary>,
    /// Draws by outcome.
    pub outcomes: BTreeMap<&'static str, u64>,
    /// Probability of each finding.
    pub findings: Vec<FindingSummary>,
    /// First fault of an invalid or failed draw.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_error: Option<String>,
    /// Drawn values of each quantity.
    pub quantities: Vec<QuantitySummary>,
    /// Figures of the plans.
    pub figures: Vec<FigureSummary>,
    /// Results by the values of each sweep.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub sweeps: Vec<SweepSummary>,
}

/// Outcome of one plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outcome {
    /// Outcome, as in `draws.csv`.
    pub status: &'static str,
    /// Number of findings by code.
    pub findings: BTreeMap<String, usize>,
    /// The fault of an invalid or failed plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
}

/// A finding in the draws.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FindingSummary {
    /// Its code.
    pub code: String,
    /// Number of draws with it.
    pub draws: u64,
    /// Its probability, with the 95 % interval of Wilson.
    pub probability: Interval,
}

/// Drawn values of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QuantitySummary {
    /// Its name.
    pub name: String,
    /// The varied key, error or axis.
    pub varies: String,
    /// Nominal value.
    pub nominal: f64,
    /// Mean of the draws.
    pub mean: f64,
    /// Standard deviation of the draws.
    pub deviation: f64,
    /// Minimum.
    pub min: f64,
    /// Maximum.
    pub max: f64,
}

/// A figure over the draws that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureSummary {
    /// Name of its column.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// Value without uncertainty.
    pub nominal: Option<f64>,
    /// Number of draws that have it.
    pub draws: u64,
    /// Mean.
    pub mean: f64,
    /// Standard error of the mean, as of independent draws.
    pub standard_error: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Minimum.
    pub min: f64,
    /// Maximum.
    pub max: f64,
    /// Quantiles at 1, 5, 25, 50, 75, 95 and 99 %.
    pub quantiles: Quantiles,
    /// First-order Sobol indices by quantity.
    pub indices: Vec<IndexSummary>,
    /// Values with one quantity at its low and its high value.
    pub swings: Vec<Swing>,
}

impl FigureSummary {
    /// Codes of the names of [`FigureSummary::statistics`].
    pub const STATISTICS: [&str; 7] =
        ["study-mean", "study-deviation", "study-min", "study-p05", "study-p50", "study-p95", "study-max"];

    /// The statistics of a table.
    pub fn statistics(&self) -> [f64; 7] {
        let Quantiles { p05, p50, p95, .. } = self.quantiles;
        [self.mean, self.deviation, self.min, p05, p50, p95, self.max]
    }
}

/// Quantiles of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Quantiles {
    /// At 1 %.
    pub p01: f64,
    /// At 5 %.
    pub p05: f64,
    /// At 25 %.
    pub p25: f64,
    /// The median.
    pub p50: f64,
    /// At 75 %.
    pub p75: f64,
    /// At 95 %.
    pub p95: f64,
    /// At 99 %.
    pub p99: f64,
}

/// First-order Sobol index of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct IndexSummary {
    /// Name of the quantity.
    pub quantity: String,
    /// Part of the variance that it explains alone, with its 95 % interval.
    pub index: Interval,
}

/// A figure with one quantity at its ends: 5 % and 95 % of its distribution, the first and last of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Swing {
    /// Name of the quantity.
    pub quantity: String,
    /// The figure at the low value; none if it has no plan.
    pub at_low: Option<f64>,
    /// The figure at the high value.
    pub at_high: Option<f64>,
}

/// Results by the values of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepSummary {
    /// Name of the quantity.
    pub quantity: String,
    /// Its values in order.
    pub points: Vec<SweepPoint>,
}

/// Results at a value of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepPoint {
    /// The value.
    pub value: f64,
    /// Probability that the weld can be made as asked.
    pub weldable: Interval,
    /// Figures there, in the order of the study's.
    pub figures: Vec<SweepFigure>,
}

/// A figure at a value of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepFigure {
    /// Name of its column.
    pub name: String,
    /// Mean.
    pub mean: f64,
    /// Quantile at 5 %.
    pub p05: f64,
    /// Quantile at 95 %.
    pub p95: f64,
}

impl StudySummary {
    pub(crate) fn new(
        study: &Study,
        counts: &Counts,
        nominals: &Nominals,
        parquet: &Path,
        kept: u64,
    ) -> Result<Self, Failure> {
        let columns = Columns::open(study, parquet)?;
        let draws = study.rows();
        let weldable = counts.outcomes.get(Status::Weldable.word()).copied().unwrap_or(0);
        let finding = |(code, n): (&String, &u64)| FindingSummary {
            code: code.clone(),
            draws: *n,
            probability: wilson(*n, draws),
        };
        let mut findings: Vec<FindingSummary> = counts.findings.iter().map(finding).collect();
        findings.sort_by_key(|finding| std::cmp::Reverse(finding.draws));
        let nominal = &nominals.nominal;
        let file = &study.file.value;
        Ok(Self {
            seamwright: env!("CARGO_PKG_VERSION"),
            file: study.path.display().to_string(),
            title: file.title.clone(),
            job: file.job.clone(),
            machine: study.loaded.machine.name.clone(),
            sampling: file.sampling,
            seed: file.seed,
            draws,
            kept,
            nominal: Outcome {
                status: nominal.status.word(),
                findings: nominal.findings.clone(),
                error: nominal.error.clone(),
            },
            weldable: wilson(weldable, draws),
            weldable_indices: indices(study, &columns, &columns.weldable()?)?,
            outcomes: counts.outcomes.clone(),
            findings,
            first_error: counts.first_error.clone(),
            quantities: quantities(study, &columns)?,
            figures: figures(study, &columns, nominals)?,
            sweeps: sweeps(study, &columns)?,
        })
    }
}

fn quantities(study: &Study, columns: &Columns) -> Result<Vec<QuantitySummary>, Failure> {
    let summary = |(i, quantity): (usize, &super::open::Quantity)| {
        let moments: Moments = columns.quantity(i)?.into_iter().collect();
        Ok(QuantitySummary {
            name: quantity.name.clone(),
            varies: quantity.target.to_string(),
            nominal: quantity.nominal,
            mean: moments.mean(),
            deviation: moments.deviation(),
            min: moments.min(),
            max: moments.max(),
        })
    };
    study.quantities.iter().enumerate().map(summary).collect()
}

/// Figures that at least one draw has.
fn figures(study: &Study, columns: &Columns, nominals: &Nominals) -> Result<Vec<FigureSummary>, Failure> {
    let mut all = Vec::new();
    for (i, figure) in study.figures.iter().enumerate() {
        let values = columns.figure(i)?;
        let sorted = sorted(values.iter().copied());
        if sorted.is_empty() {
            continue;
        }
        let moments: Moments = sorted.iter().copied().collect();
        let deviation = if moments.is_constant() { 0.0 } else { moments.deviation() };
        let of = |result: &DrawResult| result.figures.get(i).copied().flatten();
        let swing = |(quantity, ends): (&super::open::Quantity, &[DrawResult])| Swing {
            quantity: quantity.name.clone(),
            at_low: of(&ends[0]),
            at_high: of(&ends[1]),
        };
        all.push(FigureSummary {
            name: figure.name.clone(),
            unit: figure.unit.symbol(),
            nominal: of(&nominals.nominal),
            draws: moments.count(),
            mean: moments.mean(),
            standard_error: deviation / (moments.count() as f64).sqrt(),
            deviation,
            min: moments.min(),
            max: moments.max(),
            quantiles: quantiles(&sorted),
            indices: indices(study, columns, &values)?,
            swings: study.quantities.iter().zip(nominals.ends.chunks_exact(2)).map(swing).collect(),
        });
    }
    Ok(all)
}

/// Numbers that are there, in increasing order.
pub(crate) fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted
}

fn quantiles(sorted: &[f64]) -> Quantiles {
    let at = |p| quantile(sorted, p);
    Quantiles { p01: at(0.01), p05: at(0.05), p25: at(0.25), p50: at(0.5), p75: at(0.75), p95: at(0.95), p99: at(0.99) }
}

/// Indices of all quantities for the values `y`, from the draws that have one.
fn indices(study: &Study, columns: &Columns, y: &[f64]) -> Result<Vec<IndexSummary>, Failure> {
    let present: Vec<f64> = y.iter().copied().filter(|y| y.is_finite()).collect();
    let mut found = Vec::new();
    for (i, quantity) in study.quantities.iter().enumerate() {
        let x = columns.quantity(i)?;
        let x: Vec<f64> = x.into_iter().zip(y).filter(|(_, y)| y.is_finite()).map(|(x, _)| x).collect();
        if let Some(index) = first_order(study.file.value.sampling, &x, &present) {
            found.push(IndexSummary { quantity: quantity.name.clone(), index });
        }
    }
    Ok(found)
}

fn sweeps(study: &Study, columns: &Columns) -> Result<Vec<SweepSummary>, Failure> {
    let mut all = Vec::new();
    for (i, quantity) in study.quantities.iter().enumerate() {
        let Some(values) = quantity.distribution.values() else { continue };
        let x = columns.quantity(i)?;
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        let at = |y: &[f64], value: f64| {
            let is_here = |x: &f64| x.total_cmp(&value).is_eq();
            sorted(x.iter().zip(y).filter(|(x, _)| is_here(x)).map(|(_, y)| *y))
        };
        let weldable = columns.weldable()?;
        let point = |value: &f64| {
            let here = at(&weldable, *value);
            let hits = here.iter().filter(|hit| **hit > 0.5).count() as u64;
            SweepPoint { value: *value, weldable: wilson(hits, here.len() as u64), figures: Vec::new() }
        };
        let mut points: Vec<SweepPoint> = values.iter().map(point).collect();
        for (k, figure) in study.figures.iter().enumerate() {
            let y = columns.figure(k)?;
            for point in &mut points {
                let here = at(&y, point.value);
                if here.is_empty() {
                    continue;
                }
                let mean = here.iter().copied().collect::<Moments>().mean();
                let (p05, p95) = (quantile(&here, 0.05), quantile(&here, 0.95));
                point.figures.push(SweepFigure { name: figure.name.clone(), mean, p05, p95 });
            }
        }
        all.push(SweepSummary { quantity: quantity.name.clone(), points });
    }
    Ok(all)
}
