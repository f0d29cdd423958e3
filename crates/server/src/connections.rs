//! Connections: how many there may be, how long one may take to say what it wants.

use axum::Router;
use axum_server::accept::Accept;
use axum_server::tls_rustls::{RustlsAcceptor, RustlsConfig};
use hyper_util::rt::{TokioExecutor, TokioTimer};
use hyper_util::server::conn::auto::Builder;
use std::collections::HashMap;
use std::future::{Ready, ready};
use std::io;
use std::net::{IpAddr, SocketAddr};
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
pub(crate) async fn answer(listener: TcpListener, tls: Option<RustlsConfig>, app: Router) -> io::Result<()> {
    within(PATIENCE, listener, tls, app).await
}

async fn within(patience: Duration, listener: TcpListener, tls: Option<RustlsConfig>, app: Router) -> io::Result<()> {
    let mut server = axum_server::from_tcp(listener.into_std()?)?;
    let mut builder = Builder::new(TokioExecutor::new()).http1_only();
    builder.http1().timer(TokioTimer::new()).header_read_timeout(patience);
    *server.http_builder() = builder;
    let (counted, service) = (Counted::default(), app.into_make_service_with_connect_info::<SocketAddr>());
    match tls {
        None => server.acceptor(counted).serve(service).await,
        Some(tls) => {
            let tls = RustlsAcceptor::new(tls).handshake_timeout(patience).acceptor(counted);
            server.acceptor(tls).serve(service).await
        }
    }
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

impl<S> Accept<TcpStream, S> for Counted {
    type Stream = Held;
    type Service = S;
    type Future = Ready<io::Result<(Held, S)>>;

    fn accept(&self, stream: TcpStream, service: S) -> Self::Future {
        // What is told 30 times a second is small: it does not wait for more.
        let place = stream.set_nodelay(true).and_then(|()| stream.peer_addr());
        let place = place.and_then(|from| self.place(from.ip()).ok_or_else(|| io::ErrorKind::QuotaExceeded.into()));
        ready(place.map(|place| (Held { stream, _place: place }, service)))
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
        let mut said = Vec::new();
        let mut two = TcpStream::connect(address).await.unwrap();
        two.write_all(b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n").await.unwrap();
        let ended = tokio::time::timeout(PATIENCE, two.read_to_end(&mut said)).await;
        assert!(ended.is_ok(), "it waits for more of HTTP/2");
        assert!(said.is_empty() || said.starts_with(b"HTTP/1.1 400"), "{}", String::from_utf8_lossy(&said));
        let mut one = TcpStream::connect(address).await.unwrap();
        one.write_all(b"GET / HTTP/1.1\r\nhost: x\r\nconnection: close\r\n\r\n").await.unwrap();
        said.clear();
        one.read_to_end(&mut said).await.unwrap();
        assert!(said.starts_with(b"HTTP/1.1 200") && said.ends_with(b"here"));
        let mut slow = TcpStream::connect(address).await.unwrap();
        slow.write_all(b"GET / HTTP/1.1\r\nhost:").await.unwrap();
        said.clear();
        // It ends by itself, with or without a word.
        let ended = tokio::time::timeout(PATIENCE, slow.read_to_end(&mut said)).await;
        assert!(ended.is_ok());
        served.abort();
    }
}
