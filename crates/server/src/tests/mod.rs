//! Tests of the panel from outside: over HTTP and over the socket.

mod alarmed;
mod asked;
mod assets;
mod attacked;
mod crowded;
mod devices;
mod drawn;
mod framed;
mod guarded;
mod jogged;
mod limits;
mod limits_page;
mod lived;
mod observed;
mod recorded;
mod restored;
mod scheduled;
mod sensors;
mod set_up;
mod taught;
mod tracked;
mod welded;

pub(crate) use lived::page;

use crate::cell::Cell;
use crate::http::{Panel, app, begin_with};
use crate::planner::Planner;
use crate::users::Accounts;
use crate::wire::Role;
use axum::Router;
use axum::body::Body;
use axum::http::{Request, Response, StatusCode};
use http_body_util::BodyExt as _;
use seamwright_cell::{CellStart, MachineSource};
use seamwright_executive::realtime::Shutdown;
use seamwright_machine::shipped;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;
use tempfile::TempDir;
use tower::ServiceExt as _;

pub(crate) const HOST: &str = "127.0.0.1:8080";
pub(crate) const KEY: &str = "0123456789abcdef0123456789abcdef";

/// Token of monitoring tools.
pub(crate) const MONITOR_TOKEN: &str = "fedcba9876543210";

/// The job of the example ellipse beside the home position of its machine, with little gas after the arc: what is waited for
/// in real time is short.
pub(crate) fn beside_home(ellipse: &str) -> String {
    let near = ellipse.replace("postflow_s = 5 ", "postflow_s = 0.2 ") + "\n[placement]\nmove_mm = [-500, -150, 0]\n";
    assert!(near.contains("postflow_s = 0.2"));
    near
}

/// A cell on the machine of a text, whose paths are relative to `folder`.
pub(crate) fn cell_start(folder: &Path, machine: &str) -> CellStart {
    let machine = MachineSource { name: "m.toml".to_owned(), text: machine.to_owned(), folder: folder.to_owned() };
    CellStart { machine, values: Vec::new() }
}

/// A panel with its own cell.
pub(crate) struct Bench {
    pub(crate) panel: Arc<Panel>,
    app: Router,
    folder: Option<TempDir>,
    shutdown: Shutdown,
}

/// A user who is logged in.
#[derive(Clone)]
pub(crate) struct Visitor {
    pub(crate) cookie: String,
    pub(crate) token: String,
}

impl Bench {
    async fn new() -> Self {
        let machine = shipped("ellipse-xy").unwrap().text;
        let bench = Self::bare(tempfile::tempdir().unwrap(), &[HOST], machine);
        begin_with(&bench.panel, "ellipse.toml").await.unwrap();
        bench
    }

    async fn with_owner() -> (Self, Visitor) {
        let bench = Self::new().await;
        let owner = bench.owner().await;
        (bench, owner)
    }

    /// Starts on existing data with the text of a machine file, without a program.
    pub(crate) fn bare(folder: TempDir, hosts: &[&str], machine: &str) -> Self {
        Self::planned_by(folder, hosts, machine, Planner::new(None))
    }

    fn planned_by(folder: TempDir, hosts: &[&str], machine: &str, planner: Planner) -> Self {
        std::fs::create_dir_all(folder.path().join("jobs")).unwrap();
        let shutdown = Shutdown::default();
        let cell = Cell::start(&cell_start(folder.path(), machine), folder.path(), None, &shutdown).unwrap();
        let accounts = Accounts::open(folder.path()).unwrap();
        let hosts = hosts.iter().map(|h| (*h).to_owned()).collect();
        let mut panel = Panel::new(cell, accounts, KEY.to_owned(), folder.path().to_owned(), hosts);
        panel.planner = planner;
        panel.diagnostics.token = Some(MONITOR_TOKEN.to_owned());
        let panel = Arc::new(panel);
        Self { app: app(&panel), panel, folder: Some(folder), shutdown }
    }

    fn path(&self) -> &Path {
        self.folder.as_ref().unwrap().path()
    }

    fn end(mut self) -> TempDir {
        self.panel.cell.end();
        self.folder.take().unwrap()
    }

    async fn ask(&self, request: Request<Body>) -> (StatusCode, Value) {
        let response = self.raw(request).await;
        let status = response.status();
        let bytes = response.into_body().collect().await.unwrap().to_bytes();
        (status, serde_json::from_slice(&bytes).unwrap_or(Value::Null))
    }

    async fn load(&self, who: &Visitor, job: &str, part: Option<&str>) -> (StatusCode, Value) {
        let load = json!({ "job": job, "from": null, "part": part });
        self.ask(who.request("POST", "/api/load", Some(&load))).await
    }

    async fn raw(&self, request: Request<Body>) -> Response<Body> {
        self.app.clone().oneshot(request).await.unwrap()
    }

    async fn log_in(&self, user: &str, password: &str) -> Option<Visitor> {
        let response = self.raw(login(user, password)).await;
        let cookie = response.headers().get("set-cookie").map(|c| c.to_str().unwrap().to_owned());
        let bytes = response.into_body().collect().await.unwrap().to_bytes();
        let view: Value = serde_json::from_slice(&bytes).unwrap();
        let cookie = cookie?.split(';').next().unwrap().to_owned();
        Some(Visitor { cookie, token: view["token"].as_str().unwrap().to_owned() })
    }

    pub(crate) async fn owner(&self) -> Visitor {
        self.log_in("", KEY).await.unwrap()
    }

    /// Creates users of all roles, each with a password derived from its name; the first is the administrator.
    pub(crate) async fn everybody(&self) -> Vec<(Role, Visitor)> {
        let roles = [Role::Admin, Role::Viewer, Role::Operator, Role::Programmer, Role::Service];
        let mut all = Vec::new();
        for role in roles {
            let name = format!("{role:?}");
            self.panel.accounts.put(&name, role, true, Some(&format!("password of {name}"))).unwrap();
        }
        for role in roles {
            let name = format!("{role:?}");
            all.push((role, self.log_in(&name, &format!("password of {name}")).await.unwrap()));
        }
        all
    }
}

fn login(user: &str, password: &str) -> Request<Body> {
    let body = json!({ "user": user, "password": password }).to_string();
    let request = Request::post("/api/login").header("host", HOST).header("x-seamwright", "login");
    request.header("content-type", "application/json").body(Body::from(body)).unwrap()
}

impl Visitor {
    fn request(&self, method: &str, path: &str, body: Option<&Value>) -> Request<Body> {
        let request = Request::builder()
            .method(method)
            .uri(path)
            .header("host", HOST)
            .header("cookie", &self.cookie)
            .header("x-seamwright", &self.token)
            .header("content-type", "application/json");
        request.body(Body::from(body.map_or("{}".to_owned(), Value::to_string))).unwrap()
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        self.panel.cell.end();
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn the_first_key_opens_until_there_is_an_administrator() {
    let bench = Bench::new().await;
    assert!(bench.log_in("", "guess").await.is_none());
    let owner = bench.owner().await;
    let (status, view) = bench.ask(owner.request("GET", "/api/session", None)).await;
    assert_eq!((status, &view["role"], &view["first_run"]), (StatusCode::OK, &"admin".into(), &true.into()));
    let ada = json!({ "role": "admin", "password": "correct horse", "enabled": true, "own_password": null });
    assert_eq!(bench.ask(owner.request("PUT", "/api/users/ada", Some(&ada))).await.0, StatusCode::OK);
    assert!(bench.log_in("", KEY).await.is_none());
    // The session of the first key ends with it.
    assert_eq!(bench.ask(owner.request("GET", "/api/session", None)).await.0, StatusCode::UNAUTHORIZED);
    let ada = bench.log_in("ada", "correct horse").await.unwrap();
    let (_, view) = bench.ask(ada.request("GET", "/api/session", None)).await;
    assert_eq!((&view["user"], &view["first_run"]), (&"ada".into(), &false.into()));
    assert_eq!(bench.ask(ada.request("POST", "/api/logout", None)).await.0, StatusCode::NO_CONTENT);
    assert_eq!(bench.ask(ada.request("GET", "/api/session", None)).await.0, StatusCode::UNAUTHORIZED);
    assert!(bench.path().join("users.json").is_file());
}
