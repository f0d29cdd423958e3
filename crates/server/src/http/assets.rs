//! The panel's files, compressed and identified by their contents when the program is built.

use super::answer::Refused;
use axum::body::Body;
use axum::http::{HeaderMap, Method, StatusCode, Uri, header};
use axum::response::{IntoResponse, Response};

struct File {
    /// Its path, `assets/index-1a2b.js`.
    name: &'static str,
    /// Checksum of its contents.
    hash: &'static str,
    plain: &'static [u8],
    /// Its contents, compressed by gzip.
    zipped: &'static [u8],
}

/// The panel as built, sorted by name.
static FILES: &[File] = include!(concat!(env!("OUT_DIR"), "/panel.rs"));

/// File in the panel with the licences of its packages; Vite writes it.
const PACKAGES: &str = "third-party.json";

/// Returns the npm packages that the panel contains, with their licences: a JSON array of objects with `name`, `version`,
/// `identifier` and `text`. None if the program was built without the panel.
pub fn panel_packages() -> Option<&'static [u8]> {
    let file = FILES.binary_search_by_key(&PACKAGES, |file| file.name);
    file.ok().map(|at| FILES[at].plain)
}

/// Minimum size for compression, bytes; smaller files do not gain from it.
const MIN_COMPRESSED: usize = 256;

pub(super) async fn serve(method: Method, uri: Uri, headers: HeaderMap) -> Response {
    let path = uri.path().trim_start_matches('/');
    if !matches!(method, Method::GET | Method::HEAD) || path.starts_with("api/") {
        return Refused::not_found(format!("there is no {method} {}", uri.path())).into_response();
    }
    let name = if path.is_empty() { "index.html" } else { path };
    match FILES.binary_search_by_key(&name, |file| file.name) {
        Err(_) => Refused::not_found(format!("there is no {}", uri.path())).into_response(),
        Ok(at) => sent(&FILES[at], &headers).into_response(),
    }
}

fn sent(file: &'static File, headers: &HeaderMap) -> Result<Response, Refused> {
    let (kind, is_text) = kind(file.name);
    let compresses = is_text && file.plain.len() >= MIN_COMPRESSED;
    let zipped = compresses && accepts_gzip(headers);
    let tag = if zipped { format!("\"{}-gz\"", file.hash) } else { format!("\"{}\"", file.hash) };
    // Names of built files contain a hash of their contents.
    let cache = if file.name.starts_with("assets/") { "public, max-age=31536000, immutable" } else { "no-cache" };
    let mut response = if is_known(headers, &tag) {
        StatusCode::NOT_MODIFIED.into_response()
    } else if zipped {
        ([(header::CONTENT_ENCODING, "gzip")], Body::from(file.zipped)).into_response()
    } else {
        Body::from(file.plain).into_response()
    };
    let set = response.headers_mut();
    set.insert(header::CONTENT_TYPE, header::HeaderValue::from_static(kind));
    set.insert(header::CACHE_CONTROL, header::HeaderValue::from_static(cache));
    set.insert(header::ETAG, tag.try_into().map_err(|_| Refused::server("a tag cannot be sent"))?);
    if compresses {
        set.insert(header::VARY, header::HeaderValue::from_static("accept-encoding"));
    }
    Ok(response)
}

fn accepts_gzip(headers: &HeaderMap) -> bool {
    let accepted = headers.get_all(header::ACCEPT_ENCODING).into_iter().filter_map(|value| value.to_str().ok());
    accepted.flat_map(|value| value.split(',')).any(|coding| {
        let (name, weight) = coding.split_once(';').unwrap_or((coding, "q=1"));
        let weight = weight.trim().strip_prefix("q=").and_then(|q| q.parse::<f64>().ok());
        matches!(name.trim(), "gzip" | "*") && weight.is_none_or(|q| q > 0.0)
    })
}

/// Returns true if the client has this version of the file.
fn is_known(headers: &HeaderMap, tag: &str) -> bool {
    let known = headers.get(header::IF_NONE_MATCH).and_then(|value| value.to_str().ok()).unwrap_or_default();
    known.split(',').any(|one| matches!(one.trim().trim_start_matches("W/"), one if one == tag || one == "*"))
}

/// Returns the content type of a file, and whether it is text.
fn kind(name: &str) -> (&'static str, bool) {
    match name.rsplit('.').next() {
        Some("js" | "mjs") => ("text/javascript; charset=utf-8", true),
        Some("css") => ("text/css; charset=utf-8", true),
        Some("svg") => ("image/svg+xml", true),
        Some("png") => ("image/png", false),
        Some("json" | "webmanifest") => ("application/json", true),
        Some("html") => ("text/html; charset=utf-8", true),
        Some("woff2") => ("font/woff2", false),
        _ => ("application/octet-stream", false),
    }
}

#[cfg(test)]
pub(crate) fn panel_files() -> impl Iterator<Item = (&'static str, &'static [u8])> {
    FILES.iter().map(|file| (file.name, file.plain))
}
