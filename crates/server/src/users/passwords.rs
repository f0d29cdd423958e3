//! Password hashes: Argon2id, as PHC strings.

use super::accounts::Trouble;
use crate::limits::{MAX_HASH_MEMORY_KIB, MAX_HASH_PASSES};
use argon2::password_hash::phc::{Output, ParamsString, PasswordHash, Salt};
use argon2::{ARGON2ID_IDENT, Algorithm, Argon2, Block, Params, Version};
use seamwright_message::Message;
use std::sync::{Mutex, PoisonError};

/// Hashes one password at a time in shared memory: hundreds of logins need no more than one.
#[derive(Default)]
pub(super) struct Passwords {
    memory: Mutex<Vec<Block>>,
}

impl Passwords {
    /// Hashes a password. Slow by design.
    /// Fails if the system provides no random numbers or no memory.
    pub(super) fn hash(&self, password: &str) -> Result<String, Trouble> {
        let failed =
            |e: &dyn std::fmt::Display| Trouble(Message::new("server-password-hash").text("why", e.to_string()));
        let mut random = [0u8; 16];
        getrandom::fill(&mut random).map_err(|e| failed(&e))?;
        let salt = Salt::new(&random).map_err(|e| failed(&e))?;
        let argon2 = Argon2::default();
        let output = self.output(&argon2, password, &salt, Params::DEFAULT_OUTPUT_LEN).map_err(|e| failed(&e))?;
        let hash = PasswordHash {
            algorithm: ARGON2ID_IDENT,
            version: Some(Version::default().into()),
            params: ParamsString::try_from(argon2.params()).map_err(|e| failed(&e))?,
            salt: Some(salt),
            hash: Some(output),
        };
        Ok(hash.to_string())
    }

    /// Returns true if `hash` belongs to `password`. Takes as long as [`Self::hash`].
    pub(super) fn fits(&self, password: &str, hash: &str) -> bool {
        self.checked(password, hash).unwrap_or(false)
    }

    fn checked(&self, password: &str, hash: &str) -> Option<bool> {
        let hash = PasswordHash::new(hash).ok()?;
        let (salt, expected) = (hash.salt?, hash.hash?);
        let params = Params::try_from(&hash).ok()?;
        if params.m_cost() > MAX_HASH_MEMORY_KIB || params.t_cost() > MAX_HASH_PASSES {
            return None;
        }
        let algorithm = Algorithm::try_from(hash.algorithm.as_str()).ok()?;
        let version = hash.version.map(Version::try_from).transpose().ok()?.unwrap_or_default();
        let argon2 = Argon2::new(algorithm, version, params);
        let output = self.output(&argon2, password, &salt, expected.len()).ok()?;
        // Compares in constant time.
        Some(output == expected)
    }

    fn output(&self, argon2: &Argon2<'_>, password: &str, salt: &[u8], length: usize) -> Result<Output, String> {
        let mut memory = self.memory.lock().unwrap_or_else(PoisonError::into_inner);
        let blocks = argon2.params().block_count();
        if memory.len() < blocks {
            memory.resize(blocks, Block::new());
        }
        let mut buffer = [0u8; Output::MAX_LENGTH];
        let out = buffer.get_mut(..length).ok_or("the hash is too long")?;
        let made = argon2.hash_password_into_with_memory(password.as_bytes(), salt, out, &mut memory[..blocks]);
        made.map_err(|e| e.to_string())?;
        Output::new(out).map_err(|e| e.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use argon2::PasswordVerifier as _;

    /// Hashes match the library's, whatever the memory contained before.
    #[test]
    fn hashes_are_those_of_the_library() {
        let passwords = Passwords::default();
        let (first, second) = (passwords.hash("correct horse").unwrap(), passwords.hash("correct horse").unwrap());
        assert_ne!(first, second);
        for hash in [&first, &second] {
            assert!(Argon2::default().verify_password(b"correct horse", &PasswordHash::new(hash).unwrap()).is_ok());
            assert!(passwords.fits("correct horse", hash) && !passwords.fits("correct horsf", hash));
        }
        // Made by the library before this program computed hashes itself.
        let older = "$argon2id$v=19$m=65536,t=2,p=1$c29tZXNhbHQ$RdescudvJCsgt3ub+b4dWRWJTmaaJObG";
        let oracle = Argon2::default().verify_password(b"password", &PasswordHash::new(older).unwrap());
        assert_eq!(passwords.fits("password", older), oracle.is_ok());
    }

    /// All checks share the memory of the first. A hash that requires gigabytes is invalid.
    #[test]
    fn hundreds_of_checks_take_the_memory_of_one() {
        let passwords = Passwords::default();
        let hash = passwords.hash("correct horse").unwrap();
        let first = passwords.memory.lock().unwrap().as_ptr();
        (0..5).for_each(|i| assert!(!passwords.fits(&format!("guess {i}"), &hash)));
        assert_eq!(passwords.memory.lock().unwrap().as_ptr(), first);
        let huge = hash.replace("m=19456", "m=4000000");
        assert!(huge != hash && !passwords.fits("correct horse", &huge));
        assert_eq!(passwords.memory.lock().unwrap().as_ptr(), first);
    }
}
