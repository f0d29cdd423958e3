use crate::wire::TrackingStatus;
use seamwright_executive::Tracked;
use seamwright_tracking::lead::Sight;

pub(crate) fn tracking(heads: &[Option<Tracked>; 2]) -> Vec<TrackingStatus> {
    let known = heads.iter().zip(1..).filter_map(|(head, number)| head.map(|of| (number, of)));
    known
        .map(|(head, of)| TrackingStatus {
            head,
            deviation_mm: of.deviation_mm,
            correction_mm: of.correction_mm,
            confidence: of.confidence,
            sigma_mm: Some(of.sigma_mm).filter(|sigma| sigma.is_finite()),
            state: match of.sight {
                Sight::Seen => "seen",
                Sight::Bridged => "bridged",
                Sight::Coasted => "coasted",
                Sight::Fading => "fading",
                Sight::Unseen => "unseen",
                Sight::Lost => "lost",
            }
            .to_owned(),
        })
        .collect()
}
