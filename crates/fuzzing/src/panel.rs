//! Messages and bodies of requests that the panel's server reads.

use crate::scratch::empty_folder;
use crate::target::{Target, USUAL};
use crate::texts::with_text;
use crate::words;
use seamwright_server::{fuzzing, openapi, wire};

/// Messages of a page over its socket.
pub const SOCKET_MESSAGE: Target = Target {
    name: "socket_message",
    read: |bytes| with_text(bytes, fuzzing::socket_message),
    seeds: || MESSAGES.map(|text| text.as_bytes().to_vec()).to_vec(),
    words: || words::json(&schemars::schema_for!(wire::ToCell).to_value()),
    max_length: 2048,
    ..USUAL
};

/// Bodies of requests: the first line is the name of the type, see [`fuzzing::BODIES`].
pub const REQUEST_BODY: Target = Target {
    name: "request_body",
    read: |bytes| {
        let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else { return };
        let name = std::str::from_utf8(&bytes[..end]).unwrap_or_default();
        fuzzing::request_body(name, &bytes[end + 1..], empty_folder());
    },
    seeds: || BODIES.map(|text| text.as_bytes().to_vec()).to_vec(),
    words: || words::json(&openapi()),
    max_memory: 256 << 20,
    ..USUAL
};

const MESSAGES: [&str; 12] = [
    r#"{"kind":"command","seq":1,"ask":{"do":"switch_on"}}"#,
    r#"{"kind":"command","seq":2,"ask":{"do":"home","axis":1}}"#,
    r#"{"kind":"command","seq":3,"ask":{"do":"override","part":0.5}}"#,
    r#"{"kind":"command","seq":4,"ask":{"do":"start_weld","reweld":true}}"#,
    r#"{"kind":"command","seq":5,"ask":{"do":"acknowledge","one":[3,0]}}"#,
    r#"{"kind":"jog","seq":1,"of":"tip","speeds":[1.0,-1.0,0.0]}"#,
    r#"{"kind":"step","seq":2,"of":"joints","index":1,"by":-0.1}"#,
    r#"{"kind":"go","seq":3,"axes":[1.5,2e3]}"#,
    r#"{"kind":"teach","seq":6,"order":{"do":"open","step_mm":5,"longest_tack_mm":10,"seed":1,"tack_mm":[1,2]}}"#,
    r#"{"kind":"teach","seq":7,"order":{"do":"here","px":[10,20],"at":null}}"#,
    r#"{"kind":"take_control","over":true}"#,
    r#"{"kind":"why","ask":"start_weld"}"#,
];

/// A small program, as the value of a JSON text.
macro_rules! program {
    () => {
        r#""schema = 1\ntitle = \"a\"\nmachine = \"ellipse-xy\"\nnozzle_outside_mm = 0\n[[passes]]\nname = \"p\"\n[passes.points]\nstart = [0, 0, 0]\n""#
    };
}

const BODIES: [&str; 17] = [
    concat!(
        "edit\n{\"text\":",
        program!(),
        r#","operations":[{"op":"duplicate_pass","pass":1},{"op":"delete_pass","pass":2},{"op":"scale_speed","factor":0.5}]}"#
    ),
    concat!(
        "form\n{\"text\":",
        program!(),
        r#","changes":[{"op":"set","path":"title","value":"b"},{"op":"add","path":"placement"},{"op":"remove","path":"title"}]}"#
    ),
    concat!(
        "form\n{\"text\":",
        program!(),
        r#","changes":[{"op":"choose","path":"passes[0].points","kind":"points"},{"op":"move","path":"passes[0]","to":0},{"op":"insert","path":"passes[0]","value":{}}]}"#
    ),
    concat!(
        "place\n{\"text\":",
        program!(),
        r#","method":"three_points","probe_radius_mm":1,"points":[{"feature":"plane","tip":[0,0,0]},{"feature":"origin","tip":[1,0,0]},{"feature":"direction","tip":[0,1,0]}]}"#
    ),
    "tool_touches\n{\"head\":0,\"touches\":[[0,0,0,0,0],[1,2,3,4,5],[3,2,1,90,45],[3,2,1,-30,45]]}",
    "login\n{\"user\":\"ada\",\"password\":\"guess\"}",
    "job_kept\n{\"text\":\"schema = 1\",\"over\":null}",
    "job_text\n{\"text\":\"schema = 1\"}",
    "load\n{\"job\":\"ellipse.toml\",\"from\":[1,2.5],\"overlap_mm\":5,\"part\":\"N-17\",\"distortion\":null}",
    "post\n{\"text\":\"schema = 1\",\"dialect\":\"pmac\"}",
    "teach_program\n{\"tolerance_mm\":0.1,\"attitude_deg\":1,\"method\":\"greedy\"}",
    "parameters\n{\"axis\":\"x\",\"values\":[[\"max_speed_mm_s\",50],[\"inertia\",null]],\"notches\":[[100,0.5,10]]}",
    "tool_tip\n{\"head\":0,\"tip_mm\":[1,2,3]}",
    "sensor\n{\"name\":\"camera\",\"values\":[[\"map.z_mm\",[1,2]]],\"heights\":[{\"z_mm\":1,\"mm_per_px\":[1,1],\"centre_px\":null,\"rotation_deg\":0,\"shear\":0,\"barrel\":0}]}",
    "shelving\n{\"number\":3,\"detail\":0,\"minutes\":10}",
    "user\n{\"role\":\"operator\",\"password\":\"0123456789\",\"enabled\":true,\"own_password\":null,\"only_new\":false}",
    "own_password\n{\"own_password\":\"x\"}",
];
