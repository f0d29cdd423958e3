use crate::limits::{MAX_SESSIONS, MAX_SESSIONS_OF_USER, SESSION_IDLE, SESSION_TIME};
use crate::wire::Role;
use seamwright_message::Message;
use seamwright_record::sha256;
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// Returns 256 random bits as hexadecimal text.
pub(crate) fn secret() -> Result<String, Message> {
    let mut bytes = [0u8; 32];
    getrandom::fill(&mut bytes).map_err(|e| Message::new("server-no-random").text("why", e.to_string()))?;
    Ok(bytes.iter().map(|b| format!("{b:02x}")).collect())
}

/// Session of a user who is logged in.
#[derive(Debug, Clone)]
pub(crate) struct Session {
    /// SHA-256 of its cookie.
    pub(crate) id: String,
    pub(crate) user: String,
    pub(crate) role: Role,
    /// Token that requests with changes must send beside the cookie.
    pub(crate) token: String,
    made: Instant,
    used: Instant,
    /// Time of its last request, including those that do not count as use: a page that only watches, heartbeats.
    seen: Instant,
}

/// All sessions, by SHA-256 of their cookie.
#[derive(Default)]
pub(crate) struct Sessions(Mutex<HashMap<String, Session>>);

impl Sessions {
    fn table(&self) -> MutexGuard<'_, HashMap<String, Session>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Starts a session. Returns its cookie and the session.
    pub(crate) fn begin(&self, user: &str, role: Role) -> Result<(String, Session), Message> {
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

    /// Returns the session of a cookie and counts it as used.
    pub(crate) fn of(&self, cookie: &str) -> Option<Session> {
        let now = Instant::now();
        let mut table = self.table();
        let session = table.get_mut(&sha256(cookie.as_bytes())).filter(|s| s.is_alive(now))?;
        (session.used, session.seen) = (now, now);
        Some(session.clone())
    }

    /// Returns the session of a cookie without counting it as used.
    pub(crate) fn known(&self, cookie: &str) -> Option<Session> {
        let now = Instant::now();
        self.table().get(&sha256(cookie.as_bytes())).filter(|s| s.is_alive(now)).cloned()
    }

    /// Number of sessions.
    pub(crate) fn count(&self) -> usize {
        let now = Instant::now();
        self.table().values().filter(|session| session.is_alive(now)).count()
    }

    pub(crate) fn end(&self, cookie: &str) {
        self.table().remove(&sha256(cookie.as_bytes()));
    }

    /// Ends all sessions of a user whose role or password changed.
    pub(crate) fn end_all_of(&self, user: &str) {
        self.table().retain(|_, s| s.user != user);
    }

    /// Returns true if the session exists; `used` counts it as used.
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

/// Returns the session that must end before `user` starts another one, if any.
fn superfluous(table: &HashMap<String, Session>, user: &str) -> Option<String> {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    table.values().for_each(|session| *counts.entry(&session.user).or_default() += 1);
    let of = if counts.get(user).is_some_and(|own| *own >= MAX_SESSIONS_OF_USER) {
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
        now - self.used < SESSION_IDLE && now - self.made < SESSION_TIME
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

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
        // The number of sessions is bounded.
        (0..2000).for_each(|i| drop(sessions.begin(&format!("user {}", i / 10), Role::Viewer).unwrap()));
        assert!(sessions.table().len() <= MAX_SESSIONS);
    }

    /// Repeated logins end neither sessions of other users nor the user's own page that watches.
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
        assert_eq!(sessions.table().len(), MAX_SESSIONS_OF_USER + 1);
    }

    /// A session in use stays alive, up to its maximum duration.
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
            older(SESSION_IDLE - Duration::from_secs(60));
            assert!(sessions.lives(&session, true));
        }
        assert!(sessions.of(&cookie).is_some());
        older(Duration::from_secs(600));
        assert!(sessions.of(&cookie).is_none() && !sessions.lives(&session, true));
        let (cookie, session) = sessions.begin("ada", Role::Admin).unwrap();
        sessions.table().get_mut(&session.id).unwrap().used -= SESSION_IDLE;
        assert!(!sessions.lives(&session, true) && sessions.of(&cookie).is_none());
    }
}
