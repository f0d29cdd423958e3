//! Delivery of the panel's files.

use super::{Bench, HOST};
use axum::body::Body;
use axum::http::{Request, Response, StatusCode};
use http_body_util::BodyExt as _;
use seamwright_machine::shipped;
use std::io::Read as _;

async fn get(bench: &Bench, name: &str, headers: &[(&str, &str)]) -> Response<Body> {
    let request = Request::get(format!("/{name}")).header("host", HOST);
    let request = headers.iter().fold(request, |request, (name, value)| request.header(*name, *value));
    bench.raw(request.body(Body::empty()).unwrap()).await
}

async fn bytes(response: Response<Body>) -> Vec<u8> {
    response.into_body().collect().await.unwrap().to_bytes().to_vec()
}

/// The panel that is built in where Node.js is missing comes from the present sources. `SEAMWRIGHT_BLESS=1` packs it.
#[test]
fn packed_panel_is_current() {
    let packed = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("panel.tar.gz");
    let sources = env!("SEAMWRIGHT_PANEL_SOURCES");
    if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
        let file = std::fs::File::create(&packed).unwrap();
        let mut archive = tar::Builder::new(flate2::write::GzEncoder::new(file, flate2::Compression::best()));
        let mut add = |name: &str, bytes: &[u8]| {
            let mut header = tar::Header::new_ustar();
            header.set_size(bytes.len() as u64);
            header.set_mode(0o644);
            archive.append_data(&mut header, name, bytes).unwrap();
        };
        for (name, bytes) in crate::http::panel_files().filter(|(name, _)| *name != "sources.txt") {
            add(name, bytes);
        }
        add("sources.txt", sources.as_bytes());
        archive.into_inner().unwrap().finish().unwrap();
    }
    let mut archive = tar::Archive::new(flate2::read::GzDecoder::new(std::fs::File::open(packed).unwrap()));
    let mut entries = archive.entries().unwrap().map(Result::unwrap);
    let mut entry = entries.find(|entry| entry.path().unwrap().ends_with("sources.txt")).unwrap();
    let mut text = String::new();
    entry.read_to_string(&mut text).unwrap();
    assert_eq!(text, sources, "the packed panel is not that of these sources: run this test with SEAMWRIGHT_BLESS=1");
}

/// Text is compressed for clients that accept it, decompresses to the same text, and is not sent again to clients that
/// have it.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn text_is_compressed_and_not_sent_twice() {
    let bench = Bench::bare(tempfile::tempdir().unwrap(), &[HOST], shipped("ellipse-xy").unwrap().text);
    let header = |response: &Response<Body>, name: &str| {
        response.headers().get(name).map(|value| value.to_str().unwrap().to_owned())
    };
    let mut compressed = 0;
    for (name, _) in crate::http::panel_files() {
        let plain = get(&bench, name, &[]).await;
        assert_eq!((plain.status(), header(&plain, "content-encoding")), (StatusCode::OK, None), "{name}");
        let (tag, kind, varies) =
            (header(&plain, "etag").unwrap(), header(&plain, "content-type"), header(&plain, "vary"));
        let plain = bytes(plain).await;
        for _ in 0..2 {
            let zipped = get(&bench, name, &[("accept-encoding", "br, gzip;q=0.8")]).await;
            assert_eq!(header(&zipped, "content-type"), kind, "{name}");
            if varies.is_none() {
                assert_eq!(header(&zipped, "content-encoding"), None, "{name}");
                continue;
            }
            assert_eq!(header(&zipped, "content-encoding").as_deref(), Some("gzip"), "{name}");
            assert_ne!(header(&zipped, "etag").unwrap(), tag, "{name}: other bytes have another tag");
            let zipped = bytes(zipped).await;
            let mut text = Vec::new();
            flate2::read::GzDecoder::new(&zipped[..]).read_to_end(&mut text).unwrap();
            assert!(text == plain && zipped.len() < plain.len(), "{name}: {} of {}", zipped.len(), plain.len());
            compressed += 1;
        }
        let refused = get(&bench, name, &[("accept-encoding", "gzip;q=0, identity")]).await;
        assert_eq!(header(&refused, "content-encoding"), None, "{name}");
        let again = get(&bench, name, &[("if-none-match", &format!("\"other\", {tag}"))]).await;
        assert_eq!((again.status(), header(&again, "etag")), (StatusCode::NOT_MODIFIED, Some(tag)), "{name}");
        assert!(bytes(again).await.is_empty());
    }
    assert!(compressed > 0);
}
