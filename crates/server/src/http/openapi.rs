use super::answer::JSON;
use super::routes::routes;
use axum::Json;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

pub(super) async fn document() -> Json<Value> {
    Json(openapi())
}

/// Describes the interface as OpenAPI 3.1, generated from the routes.
pub fn openapi() -> Value {
    let settings = SchemaSettings::draft2020_12().with(|s| s.definitions_path = "/components/schemas".into());
    let mut generator = settings.into_generator();
    let mut paths = Map::new();
    for route in routes() {
        let mut operation = json!({ "summary": route.about, "responses": { "default": {
            "description": "Refused or failed", "content": { "application/json": { "schema":
                generator.subschema_for::<crate::wire::Trouble>() } } } } });
        if let Some(action) = route.action {
            operation["x-permission"] = json!(action);
            let reads = route.method == "get";
            operation["security"] =
                if reads { json!([{ "session": [] }]) } else { json!([{ "session": [], "token": [] }]) };
        }
        if let Some(body) = route.body {
            let schema = (body.schema)(&mut generator);
            operation["requestBody"] =
                json!({ "required": true, "content": { "application/json": { "schema": schema } } });
        }
        if route.takes != JSON {
            let bytes = json!({ "type": "string", "format": "binary" });
            operation["requestBody"] = json!({ "required": true, "content": { route.takes: { "schema": bytes } } });
        }
        let ok = match route.answer {
            Some(answer) => {
                let schema = (answer.schema)(&mut generator);
                json!({ "description": "Done", "content": { "application/json": { "schema": schema } } })
            }
            None => json!({ "description": "Done" }),
        };
        operation["responses"]["2XX"] = ok;
        let names = route.path.split('{').skip(1).filter_map(|rest| rest.split('}').next());
        let parameters: Vec<Value> = names
            .map(|name| json!({ "name": name, "in": "path", "required": true, "schema": { "type": "string" } }))
            .collect();
        if !parameters.is_empty() {
            operation["parameters"] = json!(parameters);
        }
        let path = paths.entry(route.path).or_insert_with(|| json!({}));
        path[route.method] = operation;
    }
    json!({
        "openapi": "3.1.0",
        "info": { "title": "Seamwright", "version": env!("CARGO_PKG_VERSION") },
        "paths": paths,
        "components": {
            "schemas": generator.take_definitions(true),
            "securitySchemes": {
                "session": { "type": "apiKey", "in": "cookie", "name": super::guard::COOKIE },
                "token": { "type": "apiKey", "in": "header", "name": super::guard::TOKEN },
            },
        },
    })
}
