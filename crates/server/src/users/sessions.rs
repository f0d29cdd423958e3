use crate::wire::Role;
use seamwright_record::sha256;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A session that nobody used for this long is over.
const IDLE: Duration = Duration::from_secs(8 * 3600);
/// A session is over after this long.
const LONGEST: Duration = Duration::from_secs(24 * 3600);
/// Maximum number of sessions at once, and of one user. Past that a session of this user, or else of the user with the most of them,
/// ends: the one that was not seen for longest.
const MAX_SESSIONS: usize = 500;
const MAX_OF_USER: usize = 20;
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
    /// Hash of what is in its cookie.
    pub(crate) id: String,
    pub(crate) user: String,
    pub(crate) role: Role,
    /// What changes something must say beside the cookie.
    pub(crate) token: String,
    made: Instant,
    used: Instant,
    /// When something came with it last, also what does not count as used: a page that only watches, signs of life.
    seen: Instant,
}

/// All sessions, by the hash of what is in their cookies.
#[derive(Default)]
pub(crate) struct Sessions(Mutex<HashMap<String, Session>>);

impl Sessions {
    fn table(&self) -> MutexGuard<'_, HashMap<String, Session>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A new session: its cookie, and what it is.
    ///
    /// # Errors
    /// See [`secret`].
    pub(crate) fn begin(&self, user: &str, role: Role) -> Result<(String, Session), String> {
        let (cookie, token) = (secret()?, secret()?);
        let (id, now) = (sha256(cookie.as_bytes()), Instant::now());
        let session = Session { id: id.clone(), user: user.to_owned(), role, token, made: now, used: now, seen: now };
        let mut table = self.table();
        table.retain(|_, s| s.is_alive(now));
        if let Some(oldest) = superfluous(&table, user) {
            table.remove(&oldest);
        }
        table.insert(id, session.clone());
        Ok((cookie, session))
    }

    /// The session of a cookie, which counts as used.
    pub(crate) fn of(&self, cookie: &str) -> Option<Session> {
        let now = Instant::now();
        let mut table = self.table();
        let session = table.get_mut(&sha256(cookie.as_bytes())).filter(|s| s.is_alive(now))?;
        (session.used, session.seen) = (now, now);
        Some(session.clone())
    }

    /// Returns the session of a cookie, which does not count as used.
    pub(crate) fn known(&self, cookie: &str) -> Option<Session> {
        let now = Instant::now();
        self.table().get(&sha256(cookie.as_bytes())).filter(|s| s.is_alive(now)).cloned()
    }

    pub(crate) fn end(&self, cookie: &str) {
        self.table().remove(&sha256(cookie.as_bytes()));
    }

    /// All sessions of a user are over: role or password changed.
    pub(crate) fn end_all_of(&self, user: &str) {
        self.table().retain(|_, s| s.user != user);
    }

    /// True if the session is there still; `used`: it counts as used.
    pub(crate) fn lives(&self, session: &Session, used: bool) -> bool {
        let now = Instant::now();
        let mut table = self.table();
        let Some(known) = table.get_mut(&session.id).filter(|s| s.is_alive(now)) else { return false };
        known.seen = now;
        if used {
            known.used = now;
        }
        true
    }
}

/// The session that ends when another one of `user` begins, if one has to.
fn superfluous(table: &HashMap<String, Session>, user: &str) -> Option<String> {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    table.values().for_each(|session| *counts.entry(&session.user).or_default() += 1);
    let of = if counts.get(user).is_some_and(|own| *own >= MAX_OF_USER) {
        user
    } else if table.len() >= MAX_SESSIONS {
        counts.iter().max_by_key(|(_, count)| **count).map(|(user, _)| *user)?
    } else {
        return None;
    };
    let own = table.iter().filter(|(_, session)| session.user == of);
    own.min_by_key(|(_, session)| session.seen).map(|(id, _)| id.clone())
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
    fn sessions_end() {
        let sessions = Sessions::default();
        let (cookie, session) = sessions.begin("ada", Role::Admin).unwrap();
        assert_eq!(sessions.of(&cookie).unwrap().token, session.token);
        assert!(sessions.of("guess").is_none() && sessions.lives(&session, false));
        let (other, _) = sessions.begin("ada", Role::Admin).unwrap();
        sessions.end(&cookie);
        assert!(sessions.of(&cookie).is_none() && !sessions.lives(&session, true) && sessions.of(&other).is_some());
        sessions.end_all_of("ada");
        assert!(sessions.of(&other).is_none());
        // It never grows without end.
        (0..2000).for_each(|i| drop(sessions.begin(&format!("user {}", i / 10), Role::Viewer).unwrap()));
        assert!(sessions.table().len() <= MAX_SESSIONS);
    }

    /// However often somebody logs in, the sessions of others stay, and of his own the page that watches.
    #[test]
    fn logins_end_sessions_of_their_own_user_only() {
        let sessions = Sessions::default();
        let (cookie, _) = sessions.begin("ada", Role::Operator).unwrap();
        let (_, watches) = sessions.begin("eve", Role::Viewer).unwrap();
        for _ in 0..2 * MAX_SESSIONS {
            drop(sessions.begin("eve", Role::Viewer).unwrap());
            assert!(sessions.lives(&watches, false));
        }
        assert!(sessions.of(&cookie).is_some());
        assert_eq!(sessions.table().len(), MAX_OF_USER + 1);
    }

    /// What is used lives on, but not for ever.
    #[test]
    fn sessions_grow_old() {
        let sessions = Sessions::default();
        let (cookie, session) = sessions.begin("ada", Role::Admin).unwrap();
        let older = |by: Duration| {
            let mut table = sessions.table();
            let known = table.get_mut(&session.id).unwrap();
            (known.made, known.used) = (known.made - by, known.used - by);
        };
        for _ in 0..3 {
            older(IDLE - Duration::from_secs(60));
            assert!(sessions.lives(&session, true));
        }
        assert!(sessions.of(&cookie).is_some());
        older(Duration::from_secs(600));
        assert!(sessions.of(&cookie).is_none() && !sessions.lives(&session, true));
        let (cookie, session) = sessions.begin("ada", Role::Admin).unwrap();
        sessions.table().get_mut(&session.id).unwrap().used -= IDLE;
        assert!(!sessions.lives(&session, true) && sessions.of(&cookie).is_none());
    }
}
