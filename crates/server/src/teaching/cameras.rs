//! Addresses to which the cell connects for camera frames.

use seamwright_message::Message;
use std::net::IpAddr;

/// Allowed addresses, chosen at the start of the panel: `HOST` with any port, or `HOST:PORT`. A machine file names the
/// address of its camera, but job files come from others: they must not open connections of the cell.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cameras(Vec<String>);

impl Cameras {
    pub(crate) fn new(allowed: Vec<String>) -> Self {
        Self(allowed)
    }

    /// Checks that frames may come from `address` (`HOST:PORT`). This computer is always allowed.
    ///
    /// # Errors
    /// In words, if the address is not on the list.
    pub(crate) fn check(&self, address: &str) -> Result<(), Message> {
        let host = address.rsplit_once(':').map_or(address, |(host, _)| host);
        let is = |known: &String| known.eq_ignore_ascii_case(address) || known.eq_ignore_ascii_case(host);
        if is_this_computer(host) || self.0.iter().any(is) {
            return Ok(());
        }
        Err(match self.0.as_slice() {
            [] => Message::new("server-camera-address").text("address", address),
            known => {
                Message::new("server-camera-address-list").text("address", address).text("allowed", known.join(", "))
            }
        })
    }
}

fn is_this_computer(host: &str) -> bool {
    let bare = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
    bare.eq_ignore_ascii_case("localhost") || bare.parse::<IpAddr>().is_ok_and(|ip| ip.to_canonical().is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_addresses_of_the_list_and_this_computer() {
        let none = Cameras::default();
        for here in
            ["127.0.0.1:7000", "localhost:7000", "LocalHost:1", "[::1]:7000", "127.8.9.1:80", "[::ffff:127.0.0.1]:80"]
        {
            assert!(none.check(here).is_ok(), "{here}");
        }
        let elsewhere = [
            "192.168.1.20:7000",
            "localhost.evil.example:7000",
            "127.0.0.1.evil.example:80",
            "0.0.0.0:80",
            "[::]:80",
            "2130706433:80",
        ];
        for address in elsewhere {
            assert!(none.check(address).unwrap_err().to_string().contains("--camera"), "{address}");
        }
        let some = Cameras::new(vec!["192.168.1.20:7000".to_owned(), "camera.shop".to_owned()]);
        for (address, is_allowed) in [
            ("192.168.1.20:7000", true),
            ("192.168.1.20:7001", false),
            ("192.168.1.200:7000", false),
            ("camera.shop:9", true),
            ("CAMERA.shop:9", true),
            ("x.camera.shop:9", false),
        ] {
            assert_eq!(some.check(address).is_ok(), is_allowed, "{address}");
        }
    }
}
