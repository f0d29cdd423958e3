//! Behaviour at a corner, as a file states it.

use seamwright_document::{Document, DocumentError, Positive, to_toml};
use seamwright_program::AtCorner;
use serde::{Deserialize, Serialize};

#[derive(Debug, Serialize, Deserialize)]
struct File {
    corner: AtCorner,
}

fn read(value: &str) -> Result<AtCorner, DocumentError> {
    Document::<File>::read("f.toml", &format!("corner = {value}\n")).map(|d| d.value.corner)
}

#[test]
fn choices_are_read_as_written() {
    for corner in [AtCorner::Refuse, AtCorner::Stop, AtCorner::BlendMm(Positive::HALF)] {
        let text = to_toml(&File { corner }).unwrap();
        assert_eq!(Document::<File>::read("f.toml", &text).unwrap().value.corner, corner, "{text}");
    }
    assert_eq!(read("{ blend_mm = 0.25 }").unwrap(), AtCorner::BlendMm(Positive::new(0.25).unwrap()));
}

#[test]
fn whatever_else_is_refused_with_what_may_stand_there() {
    for bad in ["\"halt\"", "\"blend_mm\"", "\"\"", "0.2", "1", "true", "[0.2]"] {
        let e = read(bad).unwrap_err();
        let allowed = e.allowed.clone().map_or_else(String::new, |allowed| allowed.to_string());
        assert!(e.key == "corner" && allowed.contains("\"stop\" or { blend_mm = 0.2 }"), "{bad}: {e}");
    }
    for bad in ["0", "-1", "nan", "inf", "\"wide\"", "[1]"] {
        let e = read(&format!("{{ blend_mm = {bad} }}")).unwrap_err();
        assert!(e.key == "corner.blend_mm" && e.to_string().contains("greater than 0"), "{bad}: {e}");
    }
    for bad in ["{}", "{ blend = 1 }", "{ blend_mm = 1, stop = true }"] {
        assert!(read(bad).unwrap_err().to_string().contains("blend_mm"), "{bad}");
    }
}
