use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative};
use seamwright_program::{ProcessValues, Sequence, Slope};
use serde::{Deserialize, Serialize};

/// Default travel delay of a tack or cosmetic pass, if the weld's is longer, s.
const DELAY_S: f64 = 0.1;
/// Default crater fill of a tack or cosmetic pass, if the weld's is longer, s: the weld melts its crater again, or it
/// lies on the finished weld.
const CRATER_S: f64 = 0.2;

/// Times before and after the travel of a tack or a cosmetic pass. Gas that is not given flows as in `[sequence]`; the
/// other times are not those of the weld, which would take longer than a tack itself.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShortSequence {
    /// Gas flows before the arc (or beam) is switched on, s; that of `[sequence]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preflow_s: Option<NonNegative>,
    /// The arc (or beam) is on before the torch travels, s; if missing as long as the `upslope`, without one that of
    /// `[sequence]`, but at most 0.1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub travel_delay_s: Option<NonNegative>,
    /// The torch rests at the end with the arc on, s; if missing as long as the `downslope`, without one that of
    /// `[sequence]`, but at most 0.2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crater_s: Option<NonNegative>,
    /// Gas flows after the arc is off, s; that of `[sequence]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub postflow_s: Option<NonNegative>,
    /// Process values that rise (or fall) to those of the pass from the moment the arc is on, within the travel delay;
    /// none if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upslope: Option<Slope>,
    /// Process values that fall (or rise) from those of the pass until the arc goes off, within the crater fill; none if
    /// missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub downslope: Option<Slope>,
}

impl ShortSequence {
    /// True if all values are missing.
    pub(crate) fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// The sequence of the pass, with missing values from `weld`.
    pub(crate) fn of(&self, weld: &Sequence) -> Sequence {
        let time = |given: Option<NonNegative>, slope: Option<&Slope>, of_weld: NonNegative, max_s: f64| {
            let of_slope = slope.and_then(|slope| NonNegative::new(slope.time_s.get()));
            let short = NonNegative::new(of_weld.get().min(max_s)).unwrap_or_default();
            given.or(of_slope).unwrap_or(short)
        };
        Sequence {
            preflow_s: self.preflow_s.unwrap_or(weld.preflow_s),
            travel_delay_s: time(self.travel_delay_s, self.upslope.as_ref(), weld.travel_delay_s, DELAY_S),
            crater_s: time(self.crater_s, self.downslope.as_ref(), weld.crater_s, CRATER_S),
            postflow_s: self.postflow_s.unwrap_or(weld.postflow_s),
            upslope: self.upslope.clone(),
            downslope: self.downslope.clone(),
            ..weld.clone()
        }
    }

    /// Checks the slopes of the table `path`; `weld` is the weld's sequence, `process` are its process values. Fails
    /// with the key's address: slopes longer than the time for them, values that the weld has not.
    pub(crate) fn check<T>(
        &self,
        file: &Document<T>,
        path: &str,
        weld: &Sequence,
        process: &ProcessValues,
    ) -> Result<(), DocumentError> {
        self.of(weld).check(file, path, process)
    }
}
