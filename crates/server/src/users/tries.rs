use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Wrong passwords for one name from one address before it has to wait.
const OF_NAME: u32 = 5;
/// The same for all names from one address. Not counted on this computer: behind a tunnel everybody is there.
const OF_ADDRESS: u32 = 20;
/// How long it waits after that, doubled with every further one up to 2^8 times as long.
const WAIT: Duration = Duration::from_secs(2);
/// Without a wrong one for this long all are forgotten.
const FORGET: Duration = Duration::from_secs(3600);
/// Most names and addresses that are remembered.
const MOST: usize = 2000;

/// Where from, and as whom; no name: as anybody.
type Key = (IpAddr, Option<String>);

/// Wrong passwords, and how long whoever tries has to wait.
#[derive(Default)]
pub(crate) struct Tries(Mutex<HashMap<Key, (u32, Instant)>>);

/// An address, or the network of a house: who has one address of IPv6 has 2^64.
fn house(address: IpAddr) -> IpAddr {
    match address.to_canonical() {
        IpAddr::V6(v6) if !v6.is_loopback() => IpAddr::V6((u128::from(v6) >> 64 << 64).into()),
        other => other,
    }
}

fn keys(address: IpAddr, user: &str) -> impl Iterator<Item = (Key, u32)> {
    let house = house(address);
    let of_all = (!house.is_loopback()).then_some(((house, None), OF_ADDRESS));
    [((house, Some(user.to_owned())), OF_NAME)].into_iter().chain(of_all)
}

impl Tries {
    /// How long `user` has to wait at `address`.
    pub(crate) fn waits(&self, address: IpAddr, user: &str) -> Option<Duration> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        let left = keys(address, user).filter_map(|(key, _)| known.get(&key)?.1.checked_duration_since(now));
        left.max().filter(|left| !left.is_zero())
    }

    /// A password was right or wrong. A right one says nothing of the other names that were tried from there.
    pub(crate) fn tried(&self, address: IpAddr, user: &str, right: bool) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        if right {
            known.remove(&(house(address), Some(user.to_owned())));
            return;
        }
        known.retain(|_, (_, until)| *until + FORGET > now);
        for (key, allowed) in keys(address, user) {
            if known.len() >= MOST && !known.contains_key(&key) {
                // Names made up by the thousand do not push out those that are tried again and again.
                if let Some(least) = known.iter().min_by_key(|(_, counted)| **counted).map(|(key, _)| key.clone()) {
                    known.remove(&least);
                }
            }
            let (tries, until) = known.entry(key).or_insert((0, now));
            *tries += 1;
            if *tries >= allowed {
                *until = now + WAIT * 2u32.pow((*tries - allowed).min(8));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wrong(tries: &Tries, address: &str, user: &str, times: u32) {
        (0..times).for_each(|_| tries.tried(address.parse().unwrap(), user, false));
    }

    fn waits(tries: &Tries, address: &str, user: &str) -> Option<Duration> {
        tries.waits(address.parse().unwrap(), user)
    }

    #[test]
    fn who_guesses_waits_and_others_do_not() {
        let tries = Tries::default();
        wrong(&tries, "10.0.0.1", "ada", OF_NAME - 1);
        assert!(waits(&tries, "10.0.0.1", "ada").is_none());
        wrong(&tries, "10.0.0.1", "ada", 1);
        let first = waits(&tries, "10.0.0.1", "ada").unwrap();
        wrong(&tries, "10.0.0.1", "ada", 1);
        assert!(waits(&tries, "10.0.0.1", "ada").unwrap() > first);
        // Ada herself, elsewhere, is not locked out by it; nor others there.
        assert!(waits(&tries, "10.0.0.2", "ada").is_none() && waits(&tries, "10.0.0.1", "eve").is_none());
        tries.tried("10.0.0.1".parse().unwrap(), "ada", true);
        assert!(waits(&tries, "10.0.0.1", "ada").is_none());
        // A new name each time helps nobody, nor an own account in between; on this computer only names count.
        for i in 0..OF_ADDRESS {
            wrong(&tries, "10.0.0.3", &format!("name {i}"), 1);
            tries.tried("10.0.0.3".parse().unwrap(), "eve", true);
            wrong(&tries, "127.0.0.1", &format!("name {i}"), 1);
        }
        assert!(waits(&tries, "10.0.0.3", "ada").is_some() && waits(&tries, "127.0.0.1", "ada").is_none());
        // A house's addresses of IPv6 are one, and one of IPv4 is the same written as IPv6.
        (0..OF_ADDRESS).for_each(|i| wrong(&tries, &format!("2001:db8:0:1::{i:x}"), &format!("name {i}"), 1));
        assert!(waits(&tries, "2001:db8:0:1:ffff::1", "ada").is_some());
        assert!(waits(&tries, "2001:db8:0:2::1", "ada").is_none());
        assert!(waits(&tries, "::ffff:10.0.0.3", "ada").is_some());
    }

    #[test]
    fn it_never_grows_without_end_and_forgets_the_least() {
        let tries = Tries::default();
        wrong(&tries, "127.0.0.1", "ada", OF_NAME);
        for i in 0..3 * MOST {
            wrong(&tries, "127.0.0.1", &format!("name {i}"), 1);
        }
        assert!(tries.0.lock().unwrap().len() <= MOST);
        assert!(waits(&tries, "127.0.0.1", "ada").is_some());
    }
}
