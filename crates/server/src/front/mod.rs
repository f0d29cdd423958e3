//! Front end: accepts connections, serves STOP, sockets and health checks on its own threads, and forwards all other
//! requests.
//!
//! These threads never wait for a disk, a database, a plan or another client. Handlers of other routes run on another
//! runtime: a stop is handled even if one of them blocks its thread.

mod answers;
mod bodies;
mod connection_slots;
mod memory_limit;
mod rate_limits;
mod refusal_log;
mod stream;

use crate::diagnostics::{Ended, log_readiness};
use crate::http::{Panel, Refused, URGENT, app, cookie, urgent_app};
use crate::limits::{
    BODY_TIME, HEAD_TIME, MAX_HEAD_BYTES, MAX_HEADERS, READ_RATE_BYTES_PER_S, READ_TIME, STRANGER_BODY_TIME,
};
use crate::tls::Encryption;
use crate::users::Session;
use crate::wire::Role;
use answers::Answers;
use axum::Router;
use axum::body::Body;
use axum::extract::ConnectInfo;
use axum::http::{HeaderValue, Request, Response, StatusCode, header};
use axum::response::IntoResponse as _;
use bodies::Bodies;
use connection_slots::{Known, Place, Places};
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use rate_limits::{Asker, Rates};
use rustls::ServerConfig;
use seamwright_message::Message;
use std::convert::Infallible;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::{Duration, Instant};
use stream::{Deadline, Held};
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpListener;
use tokio::runtime::Handle;
use tokio::task::JoinHandle;
use tokio_rustls::TlsAcceptor;
use tower::ServiceExt as _;

/// Time limits of clients.
#[derive(Debug, Clone, Copy)]
struct Patience {
    /// For the TLS handshake, and for the head of a request.
    head: Duration,
    /// For the body of a client without a session.
    stranger: Duration,
    /// For the body of a user with a session.
    body: Duration,
    /// For reading some of the written bytes.
    read: Duration,
    /// Minimum rate at which a client reads an answer, bytes/s, after an initial time of `read`.
    rate: usize,
}

impl Patience {
    /// Time limit for an answer of this size.
    fn to_read(self, bytes: usize) -> Duration {
        self.read + Duration::from_secs_f64(bytes as f64 / self.rate as f64)
    }
}

const PATIENCE: Patience = Patience {
    head: HEAD_TIME,
    stranger: STRANGER_BODY_TIME,
    body: BODY_TIME,
    read: READ_TIME,
    rate: READ_RATE_BYTES_PER_S,
};

/// Route that stops the machine.
const STOP: &str = "/api/stop";
/// Path prefix of everything except the panel's files.
const API: &str = "/api/";
/// The only route whose body is not collected: an archive is as large as the data, and its handler limits it.
const STREAMED: &str = "/api/restore";

/// Serves HTTP/1.1 until dropped; handlers run on `work`. Later versions name the host differently and need limits of
/// their own.
pub(crate) async fn answer(listener: TcpListener, tls: Option<Encryption>, panel: Arc<Panel>, work: Handle) {
    let rest = app(&panel);
    let front = Front::new(panel, rest, work, PATIENCE);
    tokio::select! {
        () = front.accept(listener, tls) => {}
        () = refusal_log::sum_up(&front.panel.diagnostics.counts) => {}
        () = log_readiness(&front.panel) => {}
    }
}

/// State shared by all connections.
struct Front {
    panel: Arc<Panel>,
    urgent: Router,
    rest: Router,
    work: Handle,
    places: Places,
    rates: Rates,
    bodies: Bodies,
    answers: Answers,
    patience: Patience,
}

/// A connection: address, place, and deadline for reading its answer.
#[derive(Clone)]
struct Connection {
    from: SocketAddr,
    place: Place,
    deadline: Deadline,
}

/// A handler's task, aborted when its receiver is dropped.
struct Aborted<T>(JoinHandle<T>);

impl<T> Drop for Aborted<T> {
    fn drop(&mut self) {
        self.0.abort();
    }
}

impl Front {
    fn new(panel: Arc<Panel>, rest: Router, work: Handle, patience: Patience) -> Arc<Self> {
        let urgent = urgent_app(&panel);
        let (places, rates, bodies) = (Places::default(), Rates::default(), Bodies::default());
        Arc::new(Self { panel, urgent, rest, work, places, rates, bodies, answers: Answers::default(), patience })
    }

    async fn accept(self: &Arc<Self>, listener: TcpListener, tls: Option<Encryption>) {
        loop {
            let Ok((stream, from)) = listener.accept().await else {
                // Possibly too many open files: wait until others close.
                tokio::time::sleep(Duration::from_millis(50)).await;
                continue;
            };
            // Status messages, sent 30 times a second, are small and must not be delayed.
            if stream.set_nodelay(true).is_err() {
                continue;
            }
            let place = self.places.enter(from.ip());
            let deadline = Deadline::default();
            let held = Held::new(stream, place.clone(), self.patience.read, deadline.clone());
            let (front, tls, connection) =
                (Arc::clone(self), tls.as_ref().map(Encryption::current), Connection { from, place, deadline });
            let open = self.panel.diagnostics.counts.open();
            tokio::spawn(async move {
                let (ends, counts) = (connection.place.clone(), Arc::clone(&front.panel.diagnostics.counts));
                let how = tokio::select! {
                    () = ends.ends() => Ended::Displaced,
                    how = front.greet(held, tls, connection) => how,
                };
                counts.ended(how);
                drop(open);
            });
        }
    }

    async fn greet(self: Arc<Self>, held: Held, tls: Option<Arc<ServerConfig>>, connection: Connection) -> Ended {
        match tls {
            None => self.speak(held, connection).await,
            Some(tls) => {
                let handshake = TlsAcceptor::from(tls).accept(held);
                let Ok(Ok(stream)) = tokio::time::timeout(self.patience.head, handshake).await else {
                    return Ended::Handshake;
                };
                self.speak(stream, connection).await;
            }
        }
        Ended::InOrder
    }

    async fn speak(self: Arc<Self>, stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static, of: Connection) {
        let mut builder = http1::Builder::new();
        builder.timer(TokioTimer::new()).header_read_timeout(self.patience.head);
        // A head is refused with status 431 once it exceeds the buffer, before it has arrived whole.
        builder.max_headers(MAX_HEADERS).max_header_size(MAX_HEAD_BYTES).max_buf_size(MAX_HEAD_BYTES);
        let service = service_fn(move |request| {
            let (front, of) = (Arc::clone(&self), of.clone());
            async move { Ok::<_, Infallible>(front.answer(request, &of).await) }
        });
        let connection = builder.serve_connection(TokioIo::new(stream), service);
        // An error means that the client has gone.
        drop(connection.with_upgrades().await);
    }

    async fn answer(&self, request: Request<Incoming>, of: &Connection) -> Response<Body> {
        of.deadline.set(None);
        let response = self.respond(request, of).await;
        self.panel.diagnostics.counts.answered(response.status().as_u16());
        if let Some(size) = answers::size(response.body()).filter(|size| *size > 0) {
            of.deadline.set(Some(tokio::time::Instant::now() + self.patience.to_read(size)));
        }
        response
    }

    async fn respond(&self, request: Request<Incoming>, of: &Connection) -> Response<Body> {
        let mut request = request.map(Body::new);
        request.extensions_mut().insert(ConnectInfo(of.from));
        let path = request.uri().path();
        let (is_urgent, is_streamed) = (URGENT.contains(&path), path == STREAMED);
        let session = cookie(request.headers(), self.panel.tls).and_then(|cookie| self.panel.sessions.known(cookie));
        if let Some(session) = &session {
            of.place.known_as(&Known { user: session.user.clone(), watches: session.role < Role::Operator });
        }
        if path == STOP {
            // Handled without a rate limit and before the body has arrived.
            return hand(self.urgent.clone(), request).await;
        }
        if !self.allows(session.as_ref(), of) {
            let message = Message::new("server-too-many-requests");
            return closing(Refused::new(StatusCode::TOO_MANY_REQUESTS, "slow_down", message));
        }
        let request = match session.is_some() && is_streamed {
            true => request,
            false => match self.whole(request, session.as_ref()).await {
                Ok(request) => request,
                Err(refused) => return closing(refused),
            },
        };
        of.place.answers(true);
        // The panel's files are shared in memory by all answers.
        let user = session.filter(|_| request.uri().path().starts_with(API)).map(|session| session.user);
        let response = if is_urgent { hand(self.urgent.clone(), request).await } else { self.pass_on(request).await };
        of.place.answers(false);
        match user {
            Some(user) => self.answers.hold(&user, response),
            None => response,
        }
    }

    fn allows(&self, session: Option<&Session>, of: &Connection) -> bool {
        let asker = session.map_or_else(|| Asker::stranger(of.from.ip()), |session| Asker::Session(session.id.clone()));
        self.rates.allows(asker, Instant::now())
    }

    /// Returns the request with its complete body.
    async fn whole(&self, request: Request<Body>, session: Option<&Session>) -> Result<Request<Body>, Refused> {
        let (parts, body) = request.into_parts();
        let collected = match session {
            Some(session) => tokio::time::timeout(self.patience.body, self.bodies.known(&session.user, body)).await,
            None => tokio::time::timeout(self.patience.stranger, self.bodies.stranger(body)).await,
        };
        let message = Message::new("server-request-late");
        let late = |_| Refused::new(StatusCode::REQUEST_TIMEOUT, "slow_down", message);
        Ok(Request::from_parts(parts, collected.map_err(late)??))
    }

    /// Answers on the other runtime. The work is aborted if the client goes.
    async fn pass_on(&self, request: Request<Body>) -> Response<Body> {
        let mut answering = Aborted(self.work.spawn(hand(self.rest.clone(), request)));
        let answered = (&mut answering.0).await;
        answered.unwrap_or_else(|_| Refused::server(Message::new("server-failed")).into_response())
    }
}

async fn hand(app: Router, request: Request<Body>) -> Response<Body> {
    match app.oneshot(request).await {
        Ok(response) => response,
        Err(never) => match never {},
    }
}

/// Closes the connection after the answer: the rest of the request is not read.
fn closing(refused: Refused) -> Response<Body> {
    let mut response = refused.into_response();
    response.headers_mut().insert(header::CONNECTION, HeaderValue::from_static("close"));
    response
}

#[cfg(test)]
mod tests;
