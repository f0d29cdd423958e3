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

/// Pages that open at once, just after a start and while sensors are drawn, all get their script.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn pages_that_open_at_once_get_their_files() {
    let bench = Bench::bare(tempfile::tempdir().unwrap(), &[HOST], shipped("ellipse-xy").unwrap().text);
    let drawing = bench.panel.drawing.now();
    assert!(drawing.is_some());
    let names = crate::http::names();
    let asked = names.iter().flat_map(|name| (0..20).map(|_| get(&bench, name, &[("accept-encoding", "gzip")])));
    let asked = futures_util::future::join_all(asked);
    let answers = tokio::time::timeout(std::time::Duration::from_secs(60), asked).await.unwrap();
    assert!(answers.iter().all(|answer| answer.status() == StatusCode::OK));
    drop(drawing);
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
    for name in crate::http::names() {
        let plain = get(&bench, &name, &[]).await;
        assert_eq!((plain.status(), header(&plain, "content-encoding")), (StatusCode::OK, None), "{name}");
        let (tag, kind, varies) =
            (header(&plain, "etag").unwrap(), header(&plain, "content-type"), header(&plain, "vary"));
        let plain = bytes(plain).await;
        for _ in 0..2 {
            let zipped = get(&bench, &name, &[("accept-encoding", "br, gzip;q=0.8")]).await;
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
        let refused = get(&bench, &name, &[("accept-encoding", "gzip;q=0, identity")]).await;
        assert_eq!(header(&refused, "content-encoding"), None, "{name}");
        let again = get(&bench, &name, &[("if-none-match", &format!("\"other\", {tag}"))]).await;
        assert_eq!((again.status(), header(&again, "etag")), (StatusCode::NOT_MODIFIED, Some(tag)), "{name}");
        assert!(bytes(again).await.is_empty());
    }
    assert!(compressed > 0);
}
