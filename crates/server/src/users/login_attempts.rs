use crate::limits::{
    MAX_CHECKS_OF_NAME, MAX_WRONG_KEYS, MAX_WRONG_OF_ADDRESS, MAX_WRONG_OF_NAME, WRONG_DOUBLINGS, WRONG_DOUBLINGS_HERE,
    WRONG_WAIT,
};
use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Wrong passwords are forgotten after this time without another one.
const FORGET: Duration = Duration::from_secs(3600);

/// Key by which wrong passwords are counted.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Key {
    /// A browser in which this user has logged in before.
    Device(String),
    /// A name from an address.
    Name(IpAddr, String),
    /// All names from an address.
    Address(IpAddr),
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Origin {
    pub(crate) address: IpAddr,
    /// The device, if it is one of the user's: see [`super::Devices::of`].
    pub(crate) device: Option<String>,
}

/// Counts of wrong passwords, and the waits that follow.
#[derive(Default)]
pub(crate) struct Tries(Mutex<HashMap<Key, (u32, Instant)>>);

/// Returns an address, or the /64 network of an IPv6 address: one host has 2^64 addresses.
pub(crate) fn house(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(v6) if !v6.is_loopback() => IpAddr::V6((u128::from(v6) >> 64 << 64).into()),
        other => other,
    }
}

/// Returns the keys of an attempt, each with its allowed count and doublings. On the user's own device only its own
/// attempts count.
fn keys(origin: &Origin, user: &str) -> Vec<(Key, u32, u32)> {
    if let Some(device) = &origin.device {
        return vec![(Key::Device(device.clone()), MAX_WRONG_OF_NAME, WRONG_DOUBLINGS)];
    }
    let house = house(origin.address);
    let name = Key::Name(house, user.to_owned());
    if house.is_loopback() {
        return vec![(name, MAX_WRONG_OF_NAME, WRONG_DOUBLINGS_HERE)];
    }
    vec![(name, MAX_WRONG_OF_NAME, WRONG_DOUBLINGS), (Key::Address(house), MAX_WRONG_OF_ADDRESS, WRONG_DOUBLINGS)]
}

impl Tries {
    /// Returns the time for which `user` must wait there.
    pub(crate) fn waits(&self, origin: &Origin, user: &str) -> Option<Duration> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        let left =
            keys(origin, user).into_iter().filter_map(|(key, ..)| known.get(&key)?.1.checked_duration_since(now));
        left.max().filter(|left| !left.is_zero())
    }

    /// Counts a right or wrong password. A right one does not clear the count of the address.
    pub(crate) fn tried(&self, origin: &Origin, user: &str, right: bool) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        if right {
            for (key, ..) in keys(origin, user).iter().filter(|(key, ..)| !matches!(key, Key::Address(_))) {
                known.remove(key);
            }
            return;
        }
        known.retain(|_, (_, until)| *until + FORGET > now);
        for (key, allowed, doublings) in keys(origin, user) {
            if known.len() >= MAX_WRONG_KEYS && !known.contains_key(&key) {
                // A flood of invented names does not displace names that are tried repeatedly.
                if let Some(least) = known.iter().min_by_key(|(_, counted)| **counted).map(|(key, _)| key.clone()) {
                    known.remove(&least);
                }
            }
            let (tries, until) = known.entry(key).or_insert((0, now));
            *tries += 1;
            if *tries >= allowed {
                *until = now + WRONG_WAIT * 2u32.pow((*tries - allowed).min(doublings));
            }
        }
    }
}

/// Number of passwords of each name that are being checked.
#[derive(Default, Clone)]
pub(crate) struct Checks(Arc<Mutex<HashMap<String, usize>>>);

/// A running password check; ends when dropped.
pub(crate) struct Check {
    of: Checks,
    user: String,
}

impl Checks {
    /// Starts a check. `None`: too many checks of this name.
    pub(crate) fn begin(&self, user: &str) -> Option<Check> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let own = known.entry(user.to_owned()).or_default();
        if *own >= MAX_CHECKS_OF_NAME {
            return None;
        }
        *own += 1;
        Some(Check { of: self.clone(), user: user.to_owned() })
    }
}

impl Drop for Check {
    fn drop(&mut self) {
        let mut known = self.of.0.lock().unwrap_or_else(PoisonError::into_inner);
        match known.get_mut(&self.user) {
            Some(n) if *n > 1 => *n -= 1,
            _ => drop(known.remove(&self.user)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(address: &str) -> Origin {
        Origin { address: address.parse().unwrap(), device: None }
    }

    fn wrong(tries: &Tries, address: &str, user: &str, times: u32) {
        (0..times).for_each(|_| tries.tried(&at(address), user, false));
    }

    fn waits(tries: &Tries, address: &str, user: &str) -> Option<Duration> {
        tries.waits(&at(address), user)
    }

    /// Guesses at a name do not lock out its user in a known browser. Guesses in that browser count separately.
    #[test]
    fn own_devices_are_not_locked_out_by_others() {
        let tries = Tries::default();
        let own = Origin { device: Some("her browser".to_owned()), ..at("127.0.0.1") };
        wrong(&tries, "127.0.0.1", "ada", 100);
        assert!(
            waits(&tries, "127.0.0.1", "ada").is_some_and(|wait| wait <= WRONG_WAIT * 2u32.pow(WRONG_DOUBLINGS_HERE))
        );
        assert!(tries.waits(&own, "ada").is_none());
        (0..MAX_WRONG_OF_NAME).for_each(|_| tries.tried(&own, "ada", false));
        assert!(tries.waits(&own, "ada").is_some());
    }

    #[test]
    fn no_name_takes_the_places_of_another() {
        let checks = Checks::default();
        let held: Vec<Option<Check>> = (0..100).map(|_| checks.begin("ada")).collect();
        assert_eq!(held.iter().flatten().count(), MAX_CHECKS_OF_NAME);
        assert!(checks.begin("eve").is_some());
        drop(held);
        assert!(checks.0.lock().unwrap().is_empty());
    }

    #[test]
    fn who_guesses_waits_and_others_do_not() {
        let tries = Tries::default();
        wrong(&tries, "10.0.0.1", "ada", MAX_WRONG_OF_NAME - 1);
        assert!(waits(&tries, "10.0.0.1", "ada").is_none());
        wrong(&tries, "10.0.0.1", "ada", 1);
        let first = waits(&tries, "10.0.0.1", "ada").unwrap();
        wrong(&tries, "10.0.0.1", "ada", 1);
        assert!(waits(&tries, "10.0.0.1", "ada").unwrap() > first);
        // Ada is not locked out elsewhere, nor are other users at this address.
        assert!(waits(&tries, "10.0.0.2", "ada").is_none() && waits(&tries, "10.0.0.1", "eve").is_none());
        tries.tried(&at("10.0.0.1"), "ada", true);
        assert!(waits(&tries, "10.0.0.1", "ada").is_none());
        // Neither a new name each time nor a right password in between resets the count; on this computer only names
        // count.
        for i in 0..MAX_WRONG_OF_ADDRESS {
            wrong(&tries, "10.0.0.3", &format!("name {i}"), 1);
            tries.tried(&at("10.0.0.3"), "eve", true);
            wrong(&tries, "127.0.0.1", &format!("name {i}"), 1);
        }
        assert!(waits(&tries, "10.0.0.3", "ada").is_some() && waits(&tries, "127.0.0.1", "ada").is_none());
        // All IPv6 addresses of a network count as one; an IPv4 address equals its IPv6 form.
        (0..MAX_WRONG_OF_ADDRESS).for_each(|i| wrong(&tries, &format!("2001:db8:0:1::{i:x}"), &format!("name {i}"), 1));
        assert!(waits(&tries, "2001:db8:0:1:ffff::1", "ada").is_some());
        assert!(waits(&tries, "2001:db8:0:2::1", "ada").is_none());
        assert!(waits(&tries, "::ffff:10.0.0.3", "ada").is_some());
    }

    #[test]
    fn it_never_grows_without_end_and_forgets_the_least() {
        let tries = Tries::default();
        wrong(&tries, "127.0.0.1", "ada", MAX_WRONG_OF_NAME);
        for i in 0..3 * MAX_WRONG_KEYS {
            wrong(&tries, "127.0.0.1", &format!("name {i}"), 1);
        }
        assert!(tries.0.lock().unwrap().len() <= MAX_WRONG_KEYS);
        assert!(waits(&tries, "127.0.0.1", "ada").is_some());
    }
}
