use crate::wire::Role;
use seamwright_record::sha256;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A session that nobody used for this long is over.
const IDLE: Duration = Duration::from_secs(8 * 3600);
/// A session is over after this long.
const LONGEST: Duration = Duration::from_secs(24 * 3600);
/// Most sessions at once: past that the one that was not used for longest ends.
const MOST: usize = 500;
/// Wrong passwords before logging in has to wait, for one name and for all.
const TRIES: u32 = 5;
/// How long it waits after that, doubled with every further wrong one up to ten minutes.
const WAIT: Duration = Duration::from_secs(2);

/// A random text that cannot be guessed, of 256 bits.
///
/// # Errors
/// If the system has no random numbers.
pub(crate) fn secret() -> Result<String, String> {
    let mut bytes = [0u8; 32];
    getrandom::fill(&mut bytes).map_err(|e| format!("no random numbers: {e}"))?;
    Ok(bytes.iter().map(|b| format!("{b:02x}")).collect())
}

/// Somebody who is logged in.
#[derive(Debug, Clone)]
pub(crate) struct Session {
    pub(crate) user: String,
    pub(crate) role: Role,
    /// What changes something must say beside the cookie.
    pub(crate) token: String,
    made: Instant,
    used: Instant,
}

/// All sessions, by the hash of what is in their cookies; and wrong passwords.
#[derive(Default)]
pub(crate) struct Sessions {
    table: Mutex<HashMap<String, Session>>,
    wrong: Mutex<HashMap<String, (u32, Instant)>>,
}

impl Sessions {
    fn table(&self) -> MutexGuard<'_, HashMap<String, Session>> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A new session: its cookie, and what it is.
    ///
    /// # Errors
    /// See [`secret`].
    pub(crate) fn begin(&self, user: &str, role: Role) -> Result<(String, Session), String> {
        let (cookie, token) = (secret()?, secret()?);
        let now = Instant::now();
        let session = Session { user: user.to_owned(), role, token, made: now, used: now };
        let mut table = self.table();
        table.retain(|_, s| s.is_alive(now));
        if table.len() >= MOST
            && let Some(oldest) = table.iter().min_by_key(|(_, s)| s.used).map(|(key, _)| key.clone())
        {
            table.remove(&oldest);
        }
        table.insert(sha256(cookie.as_bytes()), session.clone());
        Ok((cookie, session))
    }

    /// The session of a cookie, which counts as used.
    pub(crate) fn of(&self, cookie: &str) -> Option<Session> {
        let now = Instant::now();
        let mut table = self.table();
        let session = table.get_mut(&sha256(cookie.as_bytes())).filter(|s| s.is_alive(now))?;
        session.used = now;
        Some(session.clone())
    }

    pub(crate) fn end(&self, cookie: &str) {
        self.table().remove(&sha256(cookie.as_bytes()));
    }

    /// All sessions of a user are over: role or password changed.
    pub(crate) fn end_all_of(&self, user: &str) {
        self.table().retain(|_, s| s.user != user);
    }

    /// True if the session with this token is there still.
    pub(crate) fn lives(&self, token: &str) -> bool {
        let now = Instant::now();
        self.table().values().any(|s| s.token == token && s.is_alive(now))
    }

    /// How long logging in as `user` has to wait after wrong passwords.
    pub(crate) fn waits(&self, user: &str) -> Option<Duration> {
        let wrong = self.wrong.lock().unwrap_or_else(PoisonError::into_inner);
        let (_, until) = wrong.get(user)?;
        until.checked_duration_since(Instant::now()).filter(|left| !left.is_zero())
    }

    /// A password was right or wrong.
    pub(crate) fn tried(&self, user: &str, right: bool) {
        let mut wrong = self.wrong.lock().unwrap_or_else(PoisonError::into_inner);
        let now = Instant::now();
        if right {
            wrong.remove(user);
            return;
        }
        wrong.retain(|_, (_, until)| *until + LONGEST > now);
        if wrong.len() >= MOST && !wrong.contains_key(user) {
            // Names made up by the thousand: the oldest are forgotten.
            if let Some(oldest) = wrong.iter().min_by_key(|(_, (_, until))| *until).map(|(name, _)| name.clone()) {
                wrong.remove(&oldest);
            }
        }
        let (tries, until) = wrong.entry(user.to_owned()).or_insert((0, now));
        *tries += 1;
        let further = tries.saturating_sub(TRIES);
        if *tries >= TRIES {
            *until = now + WAIT * 2u32.pow(further.min(8));
        }
    }
}

impl Session {
    fn is_alive(&self, now: Instant) -> bool {
        now - self.used < IDLE && now - self.made < LONGEST
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sessions_end_and_wrong_passwords_wait() {
        let sessions = Sessions::default();
        let (cookie, session) = sessions.begin("ada", Role::Admin).unwrap();
        assert_eq!(sessions.of(&cookie).unwrap().token, session.token);
        assert!(sessions.of("guess").is_none() && sessions.lives(&session.token));
        let (other, _) = sessions.begin("ada", Role::Admin).unwrap();
        sessions.end(&cookie);
        assert!(sessions.of(&cookie).is_none() && !sessions.lives(&session.token) && sessions.of(&other).is_some());
        sessions.end_all_of("ada");
        assert!(sessions.of(&other).is_none());
        for _ in 0..TRIES - 1 {
            sessions.tried("ada", false);
        }
        assert!(sessions.waits("ada").is_none());
        sessions.tried("ada", false);
        let first = sessions.waits("ada").unwrap();
        sessions.tried("ada", false);
        assert!(sessions.waits("ada").unwrap() > first && sessions.waits("eve").is_none());
        sessions.tried("ada", true);
        assert!(sessions.waits("ada").is_none());
        // It never grows without end.
        for i in 0..2000 {
            sessions.tried(&format!("name {i}"), false);
            sessions.begin("x", Role::Viewer).unwrap();
        }
        assert!(sessions.wrong.lock().unwrap().len() <= MOST && sessions.table().len() <= MOST);
    }
}
