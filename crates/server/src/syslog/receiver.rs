use seamwright_message::{Message, display_by_message};
use std::fmt;
use std::str::FromStr;

/// Port of syslog.
const PORT: u16 = 514;
/// Maximum length of a host name.
const MAX_HOST: usize = 253;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Transport {
    Udp,
    Tcp,
}

/// Receiver of syslog messages: `udp://HOST:PORT` or `tcp://HOST:PORT`; the port may be left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SyslogReceiver {
    pub(super) transport: Transport,
    /// Name or address, an IPv6 address without brackets.
    pub(super) host: String,
    pub(super) port: u16,
}

/// A text is not a [`SyslogReceiver`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InvalidReceiver {
    /// The text.
    pub text: String,
}

impl InvalidReceiver {
    /// Returns its message.
    pub fn message(&self) -> Message {
        Message::new("server-syslog-receiver").text("text", &self.text)
    }
}

display_by_message!(InvalidReceiver);

impl FromStr for SyslogReceiver {
    type Err = InvalidReceiver;

    fn from_str(text: &str) -> Result<Self, InvalidReceiver> {
        parsed(text).ok_or_else(|| InvalidReceiver { text: text.to_owned() })
    }
}

fn parsed(text: &str) -> Option<SyslogReceiver> {
    let (transport, place) = match text.split_once("://")? {
        ("udp", place) => (Transport::Udp, place),
        ("tcp", place) => (Transport::Tcp, place),
        _ => return None,
    };
    let (host, port) = match place.strip_prefix('[') {
        Some(inside) => {
            let (host, after) = inside.split_once(']')?;
            host.parse::<std::net::Ipv6Addr>().ok()?;
            (host, if after.is_empty() { None } else { Some(after.strip_prefix(':')?) })
        }
        None => match place.split_once(':') {
            Some((host, port)) => (host, Some(port)),
            None => (place, None),
        },
    };
    let digits = |port: &str| port.bytes().all(|b| b.is_ascii_digit()).then(|| port.parse().ok()).flatten();
    let port = port.map_or(Some(PORT), digits).filter(|port| *port != 0)?;
    let is_name = !host.is_empty()
        && host.len() <= MAX_HOST
        && (place.starts_with('[')
            || host.bytes().all(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'-' | b'_')));
    is_name.then(|| SyslogReceiver { transport, host: host.to_owned(), port })
}

impl fmt::Display for SyslogReceiver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scheme = match self.transport {
            Transport::Udp => "udp",
            Transport::Tcp => "tcp",
        };
        match self.host.contains(':') {
            true => write!(f, "{scheme}://[{}]:{}", self.host, self.port),
            false => write!(f, "{scheme}://{}:{}", self.host, self.port),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_receiver_is_the_same_after_its_text() {
        for (text, whole) in [
            ("udp://log.shop.example", "udp://log.shop.example:514"),
            ("tcp://10.0.0.7:601", "tcp://10.0.0.7:601"),
            ("tcp://[::1]", "tcp://[::1]:514"),
            ("udp://[fe80::1]:5514", "udp://[fe80::1]:5514"),
        ] {
            let receiver: SyslogReceiver = text.parse().unwrap();
            assert_eq!(receiver.to_string(), whole);
            assert_eq!(receiver.to_string().parse(), Ok(receiver));
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in [
            "",
            "log.shop.example:514",
            "tls://log:6514",
            "udp://",
            "udp://:514",
            "udp://log:0",
            "udp://log:65536",
            "udp://log:+1",
            "udp://log:514/path",
            "udp://user@log",
            "udp://a b",
            "udp://::1:514",
            "tcp://[::1",
            "tcp://[log]:514",
            "tcp://[::1]514",
            "UDP://log",
        ] {
            let refused = text.parse::<SyslogReceiver>().unwrap_err().to_string();
            assert!(refused.contains("udp://HOST:PORT") && refused.contains(text), "{refused}");
        }
    }
}
