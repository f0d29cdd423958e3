//! Connection slots, by the user or address behind them.

use crate::limits::{
    CONNECTIONS_KEPT_FOR_OPERATORS, MAX_CONNECTIONS, MAX_CONNECTIONS_OF_USER, MAX_STRANGERS, MAX_STRANGERS_OF_ADDRESS,
};
use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::Notify;

#[derive(Clone, Default)]
pub(super) struct Places(Arc<Mutex<Table>>);

#[derive(Default)]
struct Table {
    /// Connections by number: a lower one is older.
    seats: HashMap<u64, Arc<Seat>>,
    next: u64,
}

/// Entry of a connection in the table.
#[derive(Debug)]
struct Seat {
    number: u64,
    address: IpAddr,
    /// User of the session that the connection has sent.
    user: Mutex<Option<Known>>,
    /// A complete request is being answered.
    is_answering: AtomicBool,
    ends: Notify,
}

/// A user with a session.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Known {
    pub(super) user: String,
    /// Its role may only watch and stop.
    pub(super) watches: bool,
}

impl Seat {
    fn known(&self) -> Option<Known> {
        self.user.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn is_stranger(&self) -> bool {
        self.user.lock().unwrap_or_else(PoisonError::into_inner).is_none()
    }
}

/// Slot of a connection; freed when the last clone is dropped.
#[derive(Clone)]
pub(super) struct Place(Arc<Held>);

struct Held {
    of: Places,
    seat: Arc<Seat>,
}

impl Places {
    fn table(&self) -> MutexGuard<'_, Table> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Gives a slot to a new connection. If there are too many without a session, the oldest one without a complete
    /// request ends. It is chosen from the address with the most.
    pub(super) fn enter(&self, address: IpAddr) -> Place {
        let address = address.to_canonical();
        let mut table = self.table();
        table.make_room(address);
        table.next += 1;
        let seat = Arc::new(Seat {
            number: table.next,
            address,
            user: Mutex::new(None),
            is_answering: AtomicBool::new(false),
            ends: Notify::new(),
        });
        table.seats.insert(seat.number, Arc::clone(&seat));
        Place(Arc::new(Held { of: self.clone(), seat }))
    }

    #[cfg(test)]
    pub(super) fn count(&self) -> usize {
        self.table().seats.len()
    }
}

impl Table {
    fn make_room(&mut self, newcomer: IpAddr) {
        let mut by_address: HashMap<IpAddr, usize> = HashMap::new();
        for seat in self.seats.values().filter(|seat| seat.is_stranger()) {
            *by_address.entry(seat.address).or_default() += 1;
        }
        let own = by_address.get(&newcomer).copied().unwrap_or(0);
        let strangers: usize = by_address.values().sum();
        let from = if own >= MAX_STRANGERS_OF_ADDRESS && !newcomer.is_loopback() {
            newcomer
        } else if strangers >= MAX_STRANGERS {
            let most = by_address.iter().max_by_key(|(_, n)| **n);
            most.map_or(newcomer, |(address, _)| *address)
        } else {
            return;
        };
        let of_address = self.seats.values().filter(|seat| seat.address == from && seat.is_stranger());
        let first = of_address.min_by_key(|seat| (seat.is_answering.load(Ordering::Relaxed), seat.number));
        if let Some(seat) = first.cloned() {
            self.seats.remove(&seat.number);
            seat.ends.notify_one();
        }
    }
}

impl Place {
    /// Waits until the slot is taken by another connection.
    pub(super) async fn ends(&self) {
        self.0.seat.ends.notified().await;
    }

    /// Sets whether a complete request is being answered.
    pub(super) fn answers(&self, is_answering: bool) {
        self.0.seat.is_answering.store(is_answering, Ordering::Relaxed);
    }

    /// Counts the connection as one of `known`, as long as the limits allow. Viewers do not get the last places.
    pub(super) fn known_as(&self, known: &Known) {
        let table = self.0.of.table();
        if self.0.seat.known().as_ref() == Some(known) {
            return;
        }
        let others: Vec<Known> = table.seats.values().filter_map(|seat| seat.known()).collect();
        let own = others.iter().filter(|other| other.user == known.user).count();
        let most = if known.watches { MAX_CONNECTIONS - CONNECTIONS_KEPT_FOR_OPERATORS } else { MAX_CONNECTIONS };
        let fits = others.len() < most && own < MAX_CONNECTIONS_OF_USER;
        let fits = fits && table.seats.contains_key(&self.0.seat.number);
        *self.0.seat.user.lock().unwrap_or_else(PoisonError::into_inner) = fits.then(|| known.clone());
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.of.table().seats.remove(&self.seat.number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::future::Future as _;
    use std::task::{Context, Waker};

    fn has_ended(place: &Place) -> bool {
        let waiting = std::pin::pin!(place.ends());
        waiting.poll(&mut Context::from_waker(Waker::noop())).is_ready()
    }

    fn of(user: &str, watches: bool) -> Known {
        Known { user: user.to_owned(), watches }
    }

    /// Viewers do not take the last places of those who operate.
    #[test]
    fn places_of_connections_are_kept_for_operators() {
        let (places, here) = (Places::default(), IpAddr::from([127, 0, 0, 1]));
        let enter = |user: &str, watches: bool| {
            let place = places.enter(here);
            place.known_as(&of(user, watches));
            place
        };
        let viewers: Vec<Place> = (0..MAX_CONNECTIONS).map(|i| enter(&format!("viewer {}", i % 20), true)).collect();
        let known = |places: &[Place]| places.iter().filter(|place| place.0.seat.known().is_some()).count();
        assert_eq!(known(&viewers), MAX_CONNECTIONS - CONNECTIONS_KEPT_FOR_OPERATORS);
        let operators: Vec<Place> =
            (0..MAX_CONNECTIONS).map(|i| enter(&format!("operator {}", i % 20), false)).collect();
        assert_eq!(known(&operators), CONNECTIONS_KEPT_FOR_OPERATORS);
    }

    /// A newcomer gets in and known users stay, however many connections have no session.
    #[test]
    fn newcomers_get_in_and_known_users_stay() {
        let (places, here) = (Places::default(), IpAddr::from([127, 0, 0, 1]));
        let known: Vec<Place> = (0..MAX_CONNECTIONS_OF_USER).map(|_| places.enter(here)).collect();
        known.iter().for_each(|place| place.known_as(&of("olga", false)));
        let answering = places.enter(here);
        answering.answers(true);
        let idle: Vec<Place> = (0..3 * MAX_STRANGERS).map(|_| places.enter(here)).collect();
        assert!(!has_ended(&answering) && known.iter().all(|place| !has_ended(place)));
        let ended = idle.iter().filter(|place| has_ended(place)).count();
        assert_eq!(ended, 3 * MAX_STRANGERS - (MAX_STRANGERS - 1));
        assert!(!has_ended(&idle[idle.len() - 1]));
        // A connection beyond a user's share counts as without a session and is closed for newcomers.
        let late = places.enter(here);
        late.known_as(&of("olga", false));
        let newer: Vec<Place> = (0..MAX_STRANGERS).map(|_| places.enter(here)).collect();
        assert!(has_ended(&late) && !has_ended(&newer[newer.len() - 1]));
        drop((known, answering, idle, late, newer));
        assert_eq!(places.count(), 0);
    }

    /// An address that opens too many connections does not affect other addresses.
    #[test]
    fn one_address_ends_its_own_connections() {
        let places = Places::default();
        let from = |i: u8| IpAddr::from([10, 0, 0, i]);
        let quiet = places.enter(from(2));
        let loud: Vec<Place> = (0..2 * MAX_STRANGERS).map(|_| places.enter(from(1))).collect();
        assert!(!has_ended(&quiet));
        let open = loud.iter().filter(|place| !has_ended(place)).count();
        assert_eq!(open, MAX_STRANGERS_OF_ADDRESS);
    }
}
