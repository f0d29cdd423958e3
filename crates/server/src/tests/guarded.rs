//! Every route without a session, with too low a role, from foreign pages, with wrong bodies.

use super::{Bench, HOST, Visitor, login};
use crate::http::all_routes;
use crate::users::may;
use axum::body::Body;
use axum::http::{Request, StatusCode};
use serde_json::json;

/// Host names similar to the panel's, and foreign origins.
const FOREIGN: [(&str, &str); 14] = [
    ("host", "evil.example"),
    ("host", ""),
    ("host", "127.0.0.1"),
    ("host", "127.0.0.1:80"),
    ("host", "127.0.0.1:8080.evil.example"),
    ("host", "127.0.0.1:8080@evil.example"),
    ("host", "[::ffff:127.0.0.1]:8080"),
    ("host", "[::1]:8081"),
    ("origin", "http://evil.example"),
    ("origin", "null"),
    ("origin", "https://127.0.0.1:8080"),
    ("origin", "http://127.0.0.1:8081"),
    ("origin", "http://127.0.0.1:8080.evil.example"),
    ("origin", "http://[::1]:8080"),
];

fn path(path: &str) -> String {
    path.replace("{name}", "nobody.toml").replace("{id}", "999")
}

#[tokio::test(flavor = "multi_thread")]
async fn every_route_wants_a_session_a_role_a_token_and_json() {
    let bench = Bench::new().await;
    let everybody = bench.everybody().await;
    let open: Vec<&str> = all_routes().iter().filter(|(.., action)| action.is_none()).map(|row| row.1).collect();
    assert_eq!(open, ["/api/login", "/api/stop"], "all others need a session");
    let mut checked = 0;
    for (method, route, action) in all_routes() {
        let Some(action) = action else { continue };
        let method = method.to_uppercase();
        let nobody = Visitor { cookie: "seamwright=guess".into(), token: "guess".into() };
        let (status, _) = bench.ask(nobody.request(&method, &path(route), None)).await;
        assert_eq!(status, StatusCode::UNAUTHORIZED, "{method} {route}");
        for (role, visitor) in &everybody {
            if route == "/api/logout" {
                continue;
            }
            let (status, answer) = bench.ask(visitor.request(&method, &path(route), None)).await;
            let refused = status == StatusCode::FORBIDDEN && answer["key"] == "role";
            assert_eq!(refused, !may(*role, action), "{role:?} {method} {route}: {status} {answer}");
            checked += 1;
            if method != "GET" && may(*role, action) {
                // A page that does not know the token, and one that posts a form.
                let forged = Visitor { token: "guess".into(), ..visitor.clone() };
                let (status, answer) = bench.ask(forged.request(&method, &path(route), None)).await;
                assert_eq!((status, &answer["key"]), (StatusCode::FORBIDDEN, &json!("token")), "{method} {route}");
                let mut form = visitor.request(&method, &path(route), None);
                form.headers_mut().insert("content-type", "text/plain".parse().unwrap());
                assert_eq!(bench.ask(form).await.0, StatusCode::UNSUPPORTED_MEDIA_TYPE, "{method} {route}");
            }
        }
    }
    assert!(checked > 100, "{checked}");
}

#[tokio::test(flavor = "multi_thread")]
async fn foreign_hosts_and_origins_are_refused_everywhere() {
    let bench = Bench::new().await;
    let mut owner = bench.owner().await;
    for (method, route, _) in all_routes() {
        let method = method.to_uppercase();
        for (name, value) in FOREIGN {
            let mut request = owner.request(&method, &path(route), None);
            request.headers_mut().insert(if name == "host" { "host" } else { "origin" }, value.parse().unwrap());
            let (status, answer) = bench.ask(request).await;
            assert_eq!((status, &answer["key"]), (StatusCode::FORBIDDEN, &json!("origin")), "{method} {route} {value}");
        }
        let mut request = owner.request(&method, &path(route), None);
        request.headers_mut().insert("origin", format!("http://{HOST}").parse().unwrap());
        let (_, answer) = bench.ask(request).await;
        assert_ne!(answer["key"], "origin", "{method} {route}");
        if route == "/api/logout" {
            owner = bench.owner().await;
        }
        // Browsers send this header even without an origin.
        for (site, foreign) in [("cross-site", true), ("same-site", true), ("same-origin", false), ("none", false)] {
            let mut request = owner.request(&method, &path(route), None);
            request.headers_mut().insert("sec-fetch-site", site.parse().unwrap());
            let (_, answer) = bench.ask(request).await;
            assert_eq!(answer["key"] == "origin", foreign, "{method} {route} {site}");
            if route == "/api/logout" && !foreign {
                owner = bench.owner().await;
            }
        }
    }
    // Assets too, and every answer carries the headers.
    let request = |host: &str| Request::get("/").header("host", host).body(Body::empty()).unwrap();
    assert_eq!(bench.raw(request("evil.example")).await.status(), StatusCode::FORBIDDEN);
    let page = bench.raw(request(HOST)).await;
    assert_eq!(page.status(), StatusCode::OK);
    let policy = page.headers()["content-security-policy"].to_str().unwrap();
    assert!(policy.contains("default-src 'self'") && policy.contains("frame-ancestors 'none'"), "{policy}");
    assert!(!policy.contains("unsafe-eval") && page.headers()["x-content-type-options"] == "nosniff");
}

#[tokio::test(flavor = "multi_thread")]
async fn wrong_bodies_are_told_and_passwords_slowed() {
    let (bench, owner) = Bench::with_owner().await;
    for body in [json!({}), json!({ "text": 5 }), json!({ "text": "x", "more": 1 }), json!([])] {
        let (status, _) = bench.ask(owner.request("POST", "/api/plan", Some(&body))).await;
        assert!(status.is_client_error(), "{body}: {status}");
    }
    let large = json!({ "text": "x".repeat(5 << 20) });
    let (status, _) = bench.ask(owner.request("POST", "/api/plan", Some(&large))).await;
    assert_eq!(status, StatusCode::PAYLOAD_TOO_LARGE);
    for name in ["../../etc/passwd.toml", "..%2f..%2fx.toml", ".hidden.toml", "x.txt", "a%00b.toml", "saddle.toml"] {
        let put =
            owner.request("PUT", &format!("/api/jobs/{}", name.replace("../", "..%2F")), Some(&json!({ "text": "" })));
        let (status, _) = bench.ask(put).await;
        assert!(status.is_client_error(), "{name}: {status}");
    }
    assert_eq!(std::fs::read_dir(bench.path().join("jobs")).unwrap().count(), 0);
    let mut slowed = 0;
    for _ in 0..8 {
        slowed += u32::from(bench.ask(login("ada", "guess")).await.0 == StatusCode::TOO_MANY_REQUESTS);
    }
    assert_eq!(slowed, 3);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_new_user_takes_nobodys_place() {
    let bench = Bench::new().await;
    let everybody = bench.everybody().await;
    let (_, admin) = &everybody[0];
    let change = |role: &str, only_new: Option<bool>| {
        let own = "password of Admin";
        let body = json!({ "role": role, "enabled": true, "password": "another one", "own_password": own, "only_new": only_new });
        admin.request("PUT", "/api/users/Viewer", Some(&body))
    };
    let (status, refused) = bench.ask(change("operator", Some(true))).await;
    assert_eq!((status, &refused["key"]), (StatusCode::CONFLICT, &json!("exists")), "{refused}");
    assert!(bench.log_in("Viewer", "password of Viewer").await.is_some(), "it is as it was");
    for only_new in [Some(false), None] {
        let (status, row) = bench.ask(change("operator", only_new)).await;
        assert_eq!((status, &row["role"]), (StatusCode::OK, &json!("operator")), "{row}");
    }
    assert!(bench.log_in("Viewer", "another one").await.is_some());
}
