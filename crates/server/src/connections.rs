//! Connections: how many there may be, how long one may take to say what it wants.

use axum::extract::ConnectInfo;
use axum::{Extension, Router};
use axum_server::accept::Accept;
use axum_server::tls_rustls::{RustlsAcceptor, RustlsConfig};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::collections::HashMap;
use std::io;
use std::net::IpAddr;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll};
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpListener, TcpStream};

/// Most connections from elsewhere at once: records need open files too, and this computer's own panel finds a place always.
const MOST: usize = 400;
/// Most connections of one address.
const MOST_OF_ADDRESS: usize = 250;
/// Time to say who one is to TLS, and for the head of a request.
const PATIENCE: Duration = Duration::from_secs(10);

/// Answers by HTTP/1.1 until it is dropped: later versions name the host otherwise, and have ways of their own to be too many.
pub(crate) async fn answer(listener: TcpListener, tls: Option<RustlsConfig>, app: Router) {
    within(PATIENCE, listener, tls, app).await;
}

async fn within(patience: Duration, listener: TcpListener, tls: Option<RustlsConfig>, app: Router) {
    let counted = Counted::default();
    let tls = tls.map(|config| RustlsAcceptor::new(config).handshake_timeout(patience));
    loop {
        let Ok((stream, from)) = listener.accept().await else {
            // Too many open files, perhaps: others close.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        // What is told 30 times a second is small: it does not wait for more.
        let Some(place) = counted.place(from.ip()).filter(|_| stream.set_nodelay(true).is_ok()) else { continue };
        let (held, tls) = (Held { stream, _place: place }, tls.clone());
        let app = app.clone().layer(Extension(ConnectInfo(from)));
        tokio::spawn(async move {
            match tls {
                None => speak(held, app, patience).await,
                Some(tls) => {
                    if let Ok((stream, app)) = tls.accept(held, app).await {
                        speak(stream, app, patience).await;
                    }
                }
            }
        });
    }
}

async fn speak(stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static, app: Router, patience: Duration) {
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(patience);
    let connection = builder.serve_connection(TokioIo::new(stream), TowerToHyperService::new(app));
    // Who breaks off has gone.
    drop(connection.with_upgrades().await);
}

/// How many connections there are, by address.
#[derive(Clone, Default)]
struct Counted(Arc<Mutex<HashMap<IpAddr, usize>>>);

impl Counted {
    /// A place for a connection from `address`, until it is dropped; none: there are too many.
    fn place(&self, address: IpAddr) -> Option<Place> {
        let address = address.to_canonical();
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let all: usize = known.iter().filter(|(of, _)| !of.is_loopback()).map(|(_, n)| n).sum();
        let own = known.get(&address).copied().unwrap_or(0);
        if own >= MOST_OF_ADDRESS || (!address.is_loopback() && all >= MOST) {
            return None;
        }
        known.insert(address, own + 1);
        Some(Place { of: self.clone(), address })
    }
}

/// A connection's place among all.
struct Place {
    of: Counted,
    address: IpAddr,
}

impl Drop for Place {
    fn drop(&mut self) {
        let mut known = self.of.0.lock().unwrap_or_else(PoisonError::into_inner);
        match known.get_mut(&self.address) {
            Some(n) if *n > 1 => *n -= 1,
            _ => drop(known.remove(&self.address)),
        }
    }
}

/// A connection that has its place.
struct Held {
    stream: TcpStream,
    _place: Place,
}

impl AsyncRead for Held {
    fn poll_read(mut self: Pin<&mut Self>, cx: &mut Context<'_>, buf: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(cx, buf)
    }
}

impl AsyncWrite for Held {
    fn poll_write(mut self: Pin<&mut Self>, cx: &mut Context<'_>, buf: &[u8]) -> Poll<io::Result<usize>> {
        Pin::new(&mut self.stream).poll_write(cx, buf)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        bufs: &[io::IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        Pin::new(&mut self.stream).poll_write_vectored(cx, bufs)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(cx)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::routing::get;
    use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};

    #[test]
    fn one_address_does_not_take_all_places() {
        let (counted, own) = (Counted::default(), IpAddr::from([127, 0, 0, 1]));
        let from = |i: u8| IpAddr::from([10, 0, 0, i]);
        let mut held: Vec<Place> = (0..MOST_OF_ADDRESS).map(|_| counted.place(from(1)).unwrap()).collect();
        assert!(counted.place(from(1)).is_none());
        held.extend((MOST_OF_ADDRESS..MOST).map(|_| counted.place(from(2)).unwrap()));
        assert!(counted.place(from(3)).is_none());
        let here: Vec<Place> = (0..MOST_OF_ADDRESS).map(|_| counted.place(own).unwrap()).collect();
        assert!(counted.place(own).is_none());
        held.pop();
        assert!(counted.place(from(3)).is_some());
        drop((held, here));
        assert!(counted.0.lock().unwrap().is_empty());
    }

    /// HTTP/2 is not spoken, and who says nothing is cut off.
    #[tokio::test]
    async fn only_the_plain_version_is_spoken_and_in_time() {
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let address = listener.local_addr().unwrap();
        let app = Router::new().route("/", get(|| async { "here" }));
        let served = tokio::spawn(within(Duration::from_millis(300), listener, None, app));
        let say = async |what: &[u8]| {
            let (mut stream, mut said) = (TcpStream::connect(address).await.unwrap(), Vec::new());
            stream.write_all(what).await.unwrap();
            // It ends by itself, with or without a word.
            let ended = tokio::time::timeout(PATIENCE, stream.read_to_end(&mut said)).await;
            assert!(ended.is_ok(), "{} is waited for", String::from_utf8_lossy(what));
            String::from_utf8_lossy(&said).into_owned()
        };
        let said = say(b"GET / HTTP/1.1\r\nhost: x\r\nconnection: close\r\n\r\n").await;
        assert!(said.starts_with("HTTP/1.1 200") && said.ends_with("here"), "{said}");
        for strange in [
            &b""[..],
            b"GET / HTTP/1.1\r\nhost:",
            b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n\0\0\0\x04\0\0\0\0\0",
            b"\x16\x03\x01",
        ] {
            let said = say(strange).await;
            assert!(said.is_empty() || said.starts_with("HTTP/1.1 4"), "{said:?}");
        }
        served.abort();
    }
}
