use super::answer::Refused;
use axum::http::{HeaderValue, Method, Uri, header};
use axum::response::{Html, IntoResponse, Response};
use rust_embed::RustEmbed;

/// The panel as it was built.
#[derive(RustEmbed)]
#[folder = "$OUT_DIR/web"]
struct Web;

/// A file of the panel.
pub(super) async fn serve(method: Method, uri: Uri) -> Response {
    let path = uri.path().trim_start_matches('/');
    if !matches!(method, Method::GET | Method::HEAD) || path.starts_with("api/") {
        return Refused::not_found(format!("there is no {method} {}", uri.path())).into_response();
    }
    let name = if path.is_empty() { "index.html" } else { path };
    let Some(file) = Web::get(name) else {
        return Refused::not_found(format!("there is no {}", uri.path())).into_response();
    };
    if name == "index.html" {
        return Html(file.data).into_response();
    }
    let kind = HeaderValue::from_static(kind(name));
    // Names of built files carry their contents' hash.
    let cache = HeaderValue::from_static(match name.starts_with("assets/") {
        true => "public, max-age=31536000, immutable",
        false => "no-cache",
    });
    ([(header::CONTENT_TYPE, kind), (header::CACHE_CONTROL, cache)], file.data).into_response()
}

fn kind(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("js" | "mjs") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("json" | "webmanifest") => "application/json",
        Some("html") => "text/html; charset=utf-8",
        Some("woff2") => "font/woff2",
        _ => "application/octet-stream",
    }
}
