//! Browsers in which somebody has logged in before: guesses from elsewhere at a name do not lock them out.

use super::secret;
use seamwright_record::sha256;
use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Maximum number of browsers that are remembered, and of one user: the one that was not used for longest is forgotten.
const MAX_DEVICES: usize = 1000;
const MAX_OF_USER: usize = 20;

/// A browser of a user.
struct Device {
    user: String,
    used: Instant,
}

/// All of them since the program began, by the hash of what is in their cookies.
#[derive(Default)]
pub(crate) struct Devices(Mutex<HashMap<String, Device>>);

impl Devices {
    /// Returns the number of the device whose cookie this is, if `user` has logged in on it.
    pub(crate) fn of(&self, cookie: &str, user: &str) -> Option<String> {
        let id = sha256(cookie.as_bytes());
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let device = known.get_mut(&id).filter(|device| device.user == user)?;
        device.used = Instant::now();
        Some(id)
    }

    /// Remembers a new device of `user`; what its cookie is to hold.
    ///
    /// # Errors
    /// See [`secret`].
    pub(crate) fn remember(&self, user: &str) -> Result<String, String> {
        let cookie = secret()?;
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let own = known.values().filter(|device| device.user == user).count();
        if own >= MAX_OF_USER || known.len() >= MAX_DEVICES {
            let candidates = known.iter().filter(|(_, device)| own < MAX_OF_USER || device.user == user);
            let oldest = candidates.min_by_key(|(_, device)| device.used).map(|(id, _)| id.clone());
            oldest.map(|id| known.remove(&id));
        }
        known.insert(sha256(cookie.as_bytes()), Device { user: user.to_owned(), used: Instant::now() });
        Ok(cookie)
    }

    /// Forgets all devices of a user, whose password or role changed.
    pub(crate) fn forget(&self, user: &str) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).retain(|_, device| device.user != user);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_are_of_one_user_and_bounded() {
        let devices = Devices::default();
        let ada = devices.remember("ada").unwrap();
        assert!(devices.of(&ada, "ada").is_some() && devices.of(&ada, "eve").is_none());
        assert!(devices.of("guess", "ada").is_none());
        (0..3 * MAX_OF_USER).for_each(|_| drop(devices.remember("eve").unwrap()));
        assert_eq!(devices.0.lock().unwrap().len(), MAX_OF_USER + 1);
        assert!(devices.of(&ada, "ada").is_some());
        devices.forget("ada");
        assert!(devices.of(&ada, "ada").is_none());
    }
}
