use super::passwords::Passwords;
use crate::limits::{MAX_NAME_CHARS, MAX_USERS, MAX_USERS_FILE_BYTES, MIN_PASSWORD_CHARS};
use crate::wire::{Role, UserRow};
use seamwright_message::Message;
use seamwright_project::files;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Name of the client that has the printed address while there is no administrator; reserved.
pub(crate) const OWNER: &str = "owner";

/// Error of a user or password.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Trouble(pub(crate) Message);

fn trouble<T>(message: Message) -> Result<T, Trouble> {
    Err(Trouble(message))
}

fn unreadable(path: &Path, why: &dyn std::fmt::Display) -> Message {
    Message::new("server-file-unreadable").text("file", path.display().to_string()).text("why", why.to_string())
}

/// Reads the users of a file, which may be of a restored archive.
fn read(path: &Path) -> Result<Vec<User>, Trouble> {
    let text = files::read_up_to(path, MAX_USERS_FILE_BYTES).map_err(|e| Trouble(e.message()))?;
    let users: Vec<User> = serde_json::from_str(&text).map_err(|e| Trouble(unreadable(path, &e)))?;
    if users.len() > MAX_USERS {
        return trouble(Message::new("server-too-many-users").count("max", MAX_USERS));
    }
    Ok(users)
}

/// The users of a data folder, in `users.json`.
pub(crate) struct Accounts {
    path: PathBuf,
    /// Locked only briefly: every request reads it.
    users: Mutex<Vec<User>>,
    /// Locked while users are changed and written, however long the disk takes.
    changes: Mutex<()>,
    passwords: Passwords,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct User {
    name: String,
    role: Role,
    enabled: bool,
    /// Argon2id, as a PHC string.
    hash: String,
}

impl User {
    fn row(&self) -> UserRow {
        UserRow { name: self.name.clone(), role: self.role, enabled: self.enabled }
    }
}

impl Accounts {
    /// Fails if the file cannot be read or parsed: access is denied rather than granted by mistake.
    pub(crate) fn open(folder: &Path) -> Result<Self, Trouble> {
        let path = folder.join("users.json");
        let users = if path.try_exists().unwrap_or(true) { read(&path)? } else { Vec::new() };
        Ok(Self { path, users: Mutex::new(users), changes: Mutex::new(()), passwords: Passwords::default() })
    }

    fn users(&self) -> MutexGuard<'_, Vec<User>> {
        self.users.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Locks out other changes until dropped.
    fn alone(&self) -> MutexGuard<'_, ()> {
        self.changes.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn has_admin(&self) -> bool {
        self.users().iter().any(|u| u.enabled && u.role == Role::Admin)
    }

    pub(crate) fn list(&self) -> Vec<UserRow> {
        self.users().iter().map(User::row).collect()
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.users().iter().any(|u| u.name == name)
    }

    /// Returns the role of an enabled user.
    pub(crate) fn role(&self, name: &str) -> Option<Role> {
        self.users().iter().find(|u| u.name == name && u.enabled).map(|u| u.role)
    }

    /// Checks name and password. Returns the role and the hash that was checked. Slow by design if the user exists; the
    /// caller hides the difference if not.
    pub(crate) fn check(&self, name: &str, password: &str) -> Option<(Role, String)> {
        let user = self.users().iter().find(|u| u.name == name && u.enabled).cloned()?;
        let fits = password.len() <= 4 * MAX_NAME_CHARS && self.passwords.fits(password, &user.hash);
        fits.then_some((user.role, user.hash))
    }

    /// Returns true if the user's password and role are still those that were checked.
    pub(crate) fn is_still(&self, name: &str, role: Role, hash: &str) -> bool {
        self.users().iter().any(|u| u.name == name && u.enabled && u.role == role && u.hash == hash)
    }

    /// Creates or changes a user; a new user needs a password.
    ///
    /// # Errors
    /// An invalid name or password, no administrator left, or an unwritable file.
    pub(crate) fn put(
        &self,
        name: &str,
        role: Role,
        enabled: bool,
        password: Option<&str>,
    ) -> Result<UserRow, Trouble> {
        let good = |c: char| c.is_alphanumeric() || "-_. ".contains(c);
        if name.trim() != name || name.is_empty() || name.chars().count() > MAX_NAME_CHARS || !name.chars().all(good) {
            return trouble(Message::new("server-user-name").count("max", MAX_NAME_CHARS));
        }
        if name.eq_ignore_ascii_case(OWNER) {
            return trouble(Message::new("server-user-owner").text("user", name));
        }
        let hash = match password {
            Some(p) if !(MIN_PASSWORD_CHARS..=MAX_NAME_CHARS).contains(&p.chars().count()) => {
                let message = Message::new("server-password-length");
                return trouble(message.count("min", MIN_PASSWORD_CHARS).count("max", MAX_NAME_CHARS));
            }
            Some(p) => Some(self.passwords.hash(p)?),
            None => None,
        };
        let _alone = self.alone();
        let mut changed = self.users().clone();
        let full = changed.len() >= MAX_USERS;
        match (changed.iter_mut().find(|u| u.name == name), hash) {
            (Some(user), hash) => {
                (user.role, user.enabled) = (role, enabled);
                user.hash = hash.unwrap_or_else(|| user.hash.clone());
            }
            (None, None) => return trouble(Message::new("server-password-needed")),
            (None, Some(hash)) if !full => {
                changed.push(User { name: name.to_owned(), role, enabled, hash });
            }
            (None, Some(_)) => return trouble(Message::new("server-too-many-users").count("max", MAX_USERS)),
        }
        self.keep(changed)?;
        Ok(UserRow { name: name.to_owned(), role, enabled })
    }

    /// Removes a user. Returns false if the user did not exist.
    ///
    /// # Errors
    /// No administrator left, or an unwritable file.
    pub(crate) fn remove(&self, name: &str) -> Result<bool, Trouble> {
        let _alone = self.alone();
        let before = self.users().clone();
        let changed: Vec<User> = before.iter().filter(|u| u.name != name).cloned().collect();
        let was = changed.len() < before.len();
        self.keep(changed)?;
        Ok(was)
    }

    /// Writes the users, then applies them. The caller holds [`Self::alone`].
    fn keep(&self, changed: Vec<User>) -> Result<(), Trouble> {
        let admin = |users: &[User]| users.iter().any(|u| u.enabled && u.role == Role::Admin);
        if !changed.is_empty() && !admin(&changed) {
            return trouble(Message::new("server-last-admin"));
        }
        if changed.is_empty() && admin(&self.users()) {
            return trouble(Message::new("server-last-admin"));
        }
        let text = serde_json::to_string_pretty(&changed).map_err(|e| Trouble(e.to_string().into()))?;
        files::write_secret(&self.path, &(text + "\n")).map_err(|e| Trouble(e.text().into()))?;
        *self.users() = changed;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A restored file of users is neither larger nor has more users than the panel itself would write.
    #[test]
    fn a_file_of_too_many_users_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("users.json");
        let user = |i: usize| User { name: format!("user {i}"), role: Role::Admin, enabled: true, hash: String::new() };
        let write = |count: usize| {
            let users: Vec<User> = (0..count).map(user).collect();
            std::fs::write(&file, serde_json::to_string(&users).unwrap()).unwrap();
            Accounts::open(folder.path()).map(|accounts| accounts.list().len()).map_err(|e| e.0.code.to_string())
        };
        assert_eq!(write(MAX_USERS), Ok(MAX_USERS));
        assert_eq!(write(MAX_USERS + 1), Err("server-too-many-users".to_owned()));
        std::fs::File::create(&file).unwrap().set_len(MAX_USERS_FILE_BYTES + 1).unwrap();
        assert!(Accounts::open(folder.path()).is_err_and(|e| e.0.to_string().contains("larger than 1 MiB")));
    }

    #[test]
    fn users_are_looked_up_while_a_change_waits_for_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let accounts = Accounts::open(folder.path()).unwrap();
        accounts.put("ada", Role::Admin, true, Some("correct horse")).unwrap();
        let (changed, waits) = std::sync::mpsc::channel();
        std::thread::scope(|scope| {
            // Simulates a write that hangs.
            let disk = accounts.alone();
            scope.spawn(|| changed.send(accounts.put("olga", Role::Operator, true, Some("long enough 1"))).unwrap());
            for _ in 0..20 {
                assert!(accounts.role("ada") == Some(Role::Admin) && accounts.role("olga").is_none());
                std::thread::sleep(std::time::Duration::from_millis(10));
            }
            assert!(waits.try_recv().is_err());
            drop(disk);
        });
        assert!(waits.recv().unwrap().is_ok() && accounts.role("olga").is_some());
    }

    #[test]
    fn users_come_and_go_and_an_admin_stays() {
        let folder = tempfile::tempdir().unwrap();
        let accounts = Accounts::open(folder.path()).unwrap();
        assert!(!accounts.has_admin());
        // The first user must be an administrator.
        assert!(accounts.put("olga", Role::Operator, true, Some("long enough 1")).is_err());
        accounts.put("ada", Role::Admin, true, Some("correct horse")).unwrap();
        accounts.put("olga", Role::Operator, true, Some("long enough 1")).unwrap();
        let right = accounts.check("ada", "correct horse").unwrap();
        let is_still = |name: &str| accounts.is_still(name, right.0, &right.1);
        assert!(right.0 == Role::Admin && is_still("ada") && !is_still("olga"));
        assert_eq!(accounts.check("ada", "wrong horse!"), None);
        assert_eq!(accounts.check("nobody", "nobody has this password"), None);
        for (name, password) in [
            ("", "0123456789"),
            ("a/b", "0123456789"),
            ("Owner", "0123456789"),
            ("a\nb", "0123456789"),
            ("x", "short"),
            ("y", &"x".repeat(200)),
        ] {
            assert!(accounts.put(name, Role::Viewer, true, Some(password)).is_err(), "{name} {password}");
        }
        assert!(accounts.put("new", Role::Viewer, true, None).is_err());
        // The last administrator is neither removed, disabled nor given a lower role.
        assert!(accounts.remove("ada").is_err());
        assert!(accounts.put("ada", Role::Admin, false, None).is_err());
        assert!(accounts.put("ada", Role::Viewer, true, None).is_err());
        accounts.put("olga", Role::Operator, false, None).unwrap();
        assert_eq!(accounts.check("olga", "long enough 1"), None);
        // A changed password invalidates an earlier check.
        accounts.put("ada", Role::Admin, true, Some("correct horse 2")).unwrap();
        assert!(!is_still("ada"));
        accounts.put("ada", Role::Admin, true, Some("correct horse")).unwrap();
        // The file contains everything, and only its owner can read it.
        let again = Accounts::open(folder.path()).unwrap();
        assert_eq!(again.check("ada", "correct horse").unwrap().0, Role::Admin);
        assert_eq!(again.list().len(), 2);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            let mode = std::fs::metadata(folder.path().join("users.json")).unwrap().permissions().mode();
            assert_eq!(mode & 0o077, 0);
        }
        std::fs::write(folder.path().join("users.json"), "[{}]").unwrap();
        assert!(Accounts::open(folder.path()).is_err());
    }
}
