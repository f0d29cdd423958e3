//! Rate limits of requests, by session or address.

use crate::limits::{MAX_RATES, REQUEST_BURST, REQUEST_RATE_PER_S};
use crate::users::house;
use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Asker {
    /// A session, by its identifier.
    Session(String),
    /// A client without a session, by address.
    Stranger(IpAddr),
}

impl Asker {
    pub(super) fn stranger(address: IpAddr) -> Self {
        Self::Stranger(house(address))
    }

    /// Clients without a session on this computer are not counted: behind a tunnel all share its address and would be
    /// locked out together.
    fn is_counted(&self) -> bool {
        !matches!(self, Self::Stranger(address) if address.is_loopback())
    }
}

/// Remaining allowance of each sender, and the time of its update.
#[derive(Default)]
pub(super) struct Rates(Mutex<HashMap<Asker, (f64, Instant)>>);

impl Rates {
    /// Counts a request. Returns false if it exceeds the limit.
    pub(super) fn allows(&self, asker: Asker, now: Instant) -> bool {
        if !asker.is_counted() {
            return true;
        }
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() >= MAX_RATES && !known.contains_key(&asker) {
            // Senders with a full allowance need no entry.
            let filled = Duration::from_secs_f64(REQUEST_BURST / REQUEST_RATE_PER_S);
            known.retain(|_, (_, since)| now.saturating_duration_since(*since) < filled);
            if known.len() >= MAX_RATES {
                return false;
            }
        }
        let (left, since) = known.entry(asker).or_insert((REQUEST_BURST, now));
        *left = (*left + REQUEST_RATE_PER_S * now.saturating_duration_since(*since).as_secs_f64()).min(REQUEST_BURST);
        *since = now;
        let allowed = *left >= 1.0;
        if allowed {
            *left -= 1.0;
        }
        allowed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_asks_too_much_waits_and_others_do_not() {
        let (rates, now) = (Rates::default(), Instant::now());
        let of = |name: &str| Asker::Session(name.to_owned());
        let allowed = (0..2000).filter(|_| rates.allows(of("eve"), now)).count();
        assert_eq!(allowed, REQUEST_BURST as usize);
        assert!(rates.allows(of("ada"), now));
        let later = now + Duration::from_secs(2);
        let allowed = (0..2000).filter(|_| rates.allows(of("eve"), later)).count();
        assert_eq!(allowed, (2.0 * REQUEST_RATE_PER_S) as usize);
    }

    #[test]
    fn made_up_addresses_take_bounded_memory() {
        let (rates, now) = (Rates::default(), Instant::now());
        for i in 0..3 * MAX_RATES as u32 {
            let _ = rates.allows(Asker::stranger(IpAddr::from(i.to_be_bytes())), now);
        }
        assert!(rates.0.lock().unwrap().len() <= MAX_RATES);
        let later = now + Duration::from_secs(60);
        assert!(rates.allows(Asker::stranger(IpAddr::from([9, 9, 9, 9])), later));
    }
}
