//! Limit of bytes held in memory: in total, and a share per user.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::Notify;

/// Bytes that may be held at once.
#[derive(Debug)]
pub(super) struct Room {
    held: Mutex<Held>,
    freed: Notify,
    /// Maximum number of bytes of all users, and of one.
    all: usize,
    share: usize,
}

#[derive(Debug, Default)]
struct Held {
    all: usize,
    of_users: HashMap<String, usize>,
}

/// Room that is taken; freed when dropped.
#[derive(Debug)]
pub(super) struct Taken {
    room: Arc<Room>,
    user: String,
    bytes: usize,
}

impl Room {
    pub(super) fn new(all: usize, share: usize) -> Arc<Self> {
        Arc::new(Self { held: Mutex::default(), freed: Notify::new(), all, share })
    }

    fn held(&self) -> MutexGuard<'_, Held> {
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes room for `user`, if available now.
    pub(super) fn try_take(self: &Arc<Self>, user: &str, bytes: usize) -> Option<Taken> {
        let mut held = self.held();
        let own = held.of_users.get(user).copied().unwrap_or(0);
        if held.all + bytes > self.all || own + bytes > self.share {
            return None;
        }
        held.all += bytes;
        held.of_users.insert(user.to_owned(), own + bytes);
        Some(Taken { room: Arc::clone(self), user: user.to_owned(), bytes })
    }

    /// Takes room for `user` once available.
    pub(super) async fn take(self: &Arc<Self>, user: &str, bytes: usize) -> Taken {
        loop {
            let mut freed = std::pin::pin!(self.freed.notified());
            // Registered before the check, so that a release after it is not missed.
            freed.as_mut().enable();
            if let Some(taken) = self.try_take(user, bytes) {
                return taken;
            }
            freed.await;
        }
    }
}

impl Drop for Taken {
    fn drop(&mut self) {
        let mut held = self.room.held();
        held.all -= self.bytes;
        if let Some(own) = held.of_users.get_mut(&self.user) {
            *own -= self.bytes;
            if *own == 0 {
                held.of_users.remove(&self.user);
            }
        }
        drop(held);
        self.room.freed.notify_waiters();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_user_takes_no_more_than_a_share() {
        let room = Room::new(100, 40);
        let mut taken: Vec<_> = (0..4).map_while(|_| room.try_take("eve", 10)).collect();
        assert!(taken.len() == 4 && room.try_take("eve", 1).is_none());
        taken.push(room.try_take("ada", 40).unwrap());
        assert!(room.try_take("olga", 21).is_none());
        taken.push(room.try_take("olga", 20).unwrap());
        drop(taken);
        assert!(room.held().of_users.is_empty() && room.held().all == 0);
    }

    #[tokio::test]
    async fn room_that_is_freed_is_taken_by_who_waits() {
        let room = Room::new(10, 10);
        let first = room.try_take("eve", 10).unwrap();
        let waits = tokio::spawn({
            let room = Arc::clone(&room);
            async move { room.take("ada", 5).await }
        });
        tokio::task::yield_now().await;
        assert!(!waits.is_finished());
        drop(first);
        assert_eq!(waits.await.unwrap().bytes, 5);
    }
}
