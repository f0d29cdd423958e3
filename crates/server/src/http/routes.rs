use super::answer::JSON;
use super::declarations::Declarations;
use super::guard::{Need, host, need};
use super::panel::Panel;
use super::{
    assets, audit, cell_views, choices, edit, health, jobs, login, openapi, plan, records, restore, sensors, setup,
    socket, stop, teach, users,
};
use crate::wire::{
    AlarmEntry, ArchiveView, AuditRow, ChoicesView, DeviceView, DistortionRow, DraftAnswer, EditAnswer, FormAnswer,
    FormText, JobKept, JobRow, JobText, Load, Login, MachineView, OwnPassword, ParameterChange, ParametersView,
    PlaceAnswer, PlaceText, PlanAnswer, PlanningView, PostAnswer, PostText, RecordRow, RecordView, SensorAnswer,
    SensorChange, SensorsView, SessionView, Shelving, StandingView, Stopped, TaughtProgram, TaughtView, TeachProgram,
    ToolAnswer, ToolTip, ToolTouches, TraceView, TuningView, UserChange, UserRow, WorkView,
};
use axum::extract::DefaultBodyLimit;
use axum::routing::{MethodRouter, delete, get, post, put};
use axum::{Router, middleware};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use std::sync::Arc;
use ts_rs::{TS, TypeVisitor};

/// Maximum size of a request, bytes.
pub(crate) const MAX_BYTES: usize = 4 << 20;

/// Maximum size of a request without a session, bytes.
pub(crate) const MAX_UNKNOWN: usize = 8 << 10;

/// Content types of bodies.
const TAR: &str = "application/x-tar";
const PNG: &str = "image/png";

/// A route: the single definition of its permission and of its data.
pub(super) struct Route {
    pub(super) method: &'static str,
    pub(super) path: &'static str,
    /// Action in the table of permissions; `None`: no login needed.
    pub(super) action: Option<&'static str>,
    pub(super) about: &'static str,
    pub(super) body: Option<Shape>,
    /// Content type of the body.
    pub(super) takes: &'static str,
    pub(super) answer: Option<Shape>,
    handler: MethodRouter<Arc<Panel>>,
}

/// Type of a body or an answer.
pub(super) struct Shape {
    /// Writes its JSON Schema.
    pub(super) schema: fn(&mut SchemaGenerator) -> Schema,
    /// Declares it in TypeScript.
    pub(super) declare: fn(&mut Declarations),
}

fn shape<T: JsonSchema + TS + 'static>() -> Option<Shape> {
    Some(Shape { schema: SchemaGenerator::subschema_for::<T>, declare: Declarations::visit::<T> })
}

impl Route {
    fn get(path: &'static str, action: &'static str, about: &'static str, handler: MethodRouter<Arc<Panel>>) -> Self {
        Self::write("get", path, action, about, handler)
    }

    /// Creates a route without the data of body and answer.
    fn write(
        method: &'static str,
        path: &'static str,
        action: &'static str,
        about: &'static str,
        handler: MethodRouter<Arc<Panel>>,
    ) -> Self {
        Self { method, path, action: Some(action), about, body: None, takes: JSON, answer: None, handler }
    }

    fn with_body<T: JsonSchema + TS + 'static>(self) -> Self {
        Self { body: shape::<T>(), ..self }
    }

    fn with_answer<T: JsonSchema + TS + 'static>(self) -> Self {
        Self { answer: shape::<T>(), ..self }
    }
}

/// Returns all routes of the interface.
pub(super) fn routes() -> Vec<Route> {
    let login = post(login::login).layer(DefaultBodyLimit::max(MAX_UNKNOWN));
    let login = Route {
        action: None,
        ..Route::write("post", "/api/login", "", "Starts a session", login)
            .with_body::<Login>()
            .with_answer::<SessionView>()
    };
    let about = "Stops the cell; needs no login";
    let stop = post(stop::stop).layer(DefaultBodyLimit::max(MAX_UNKNOWN));
    let stop = Route { action: None, ..Route::write("post", "/api/stop", "", about, stop).with_answer::<Stopped>() };
    let jobs = "/api/jobs/{name}";
    let user = "/api/users/{name}";
    vec![
        login,
        stop,
        Route::write("post", "/api/logout", "watch", "Ends the session", post(login::logout)),
        Route::get("/api/session", "watch", "The logged-in user", get(login::session)).with_answer::<SessionView>(),
        Route::get("/api/machine", "watch", "The machine of the cell", get(cell_views::machine))
            .with_answer::<MachineView>(),
        Route::get("/api/machine/of-job", "plan", "The machine that a job names", get(cell_views::machine_of_job))
            .with_answer::<MachineView>(),
        Route::get("/api/devices", "watch", "Inputs, outputs and lines to devices", get(cell_views::devices))
            .with_answer::<Vec<DeviceView>>(),
        Route::get("/api/work", "watch", "The program in the cell", get(cell_views::work))
            .with_answer::<Option<WorkView>>(),
        Route::get("/api/alarms/catalogue", "watch", "All alarms", get(cell_views::catalogue))
            .with_answer::<Vec<AlarmEntry>>(),
        Route::get("/api/live", "watch", "The socket: status, events, commands", get(socket::live)),
        Route::get("/api/jobs", "jobs.read", "Jobs and examples", get(jobs::list)).with_answer::<Vec<JobRow>>(),
        Route::get("/api/choices", "jobs.read", "Machines and procedures that jobs can name", get(choices::choices))
            .with_answer::<ChoicesView>(),
        Route::get("/api/distortions", "jobs.read", "Distortions of simulated parts", get(jobs::distortions))
            .with_answer::<Vec<DistortionRow>>(),
        Route::get(jobs, "jobs.read", "A job's text", get(jobs::get)).with_answer::<JobText>(),
        Route::write("put", jobs, "jobs.write", "Saves a job", put(jobs::put))
            .with_body::<JobKept>()
            .with_answer::<JobRow>(),
        Route::write("delete", jobs, "jobs.write", "Removes a job", delete(jobs::delete)),
        Route::write("post", "/api/plan", "plan", "Plans a text without saving it", post(plan::plan))
            .with_body::<JobText>()
            .with_answer::<PlanAnswer>(),
        Route::write(
            "post",
            "/api/draft",
            "plan",
            "Parts and sections of the joint that a text describes",
            post(plan::draft),
        )
        .with_body::<JobText>()
        .with_answer::<DraftAnswer>(),
        Route::write("post", "/api/place", "plan", "Position of the part from touched points", post(plan::place))
            .with_body::<PlaceText>()
            .with_answer::<PlaceAnswer>(),
        Route::get(
            "/api/planning",
            "plan",
            "Running plans of this page (header x-seamwright-page) and their durations",
            get(plan::planning),
        )
        .with_answer::<Vec<PlanningView>>(),
        Route::write("delete", "/api/planning", "plan", "Cancels the running plans of this page", delete(plan::cancel)),
        Route::write("post", "/api/load", "load", "Plans a job and loads it into the cell", post(plan::load))
            .with_body::<Load>()
            .with_answer::<WorkView>(),
        Route::write("post", "/api/post", "post", "A part program with its proof", post(plan::post))
            .with_body::<PostText>()
            .with_answer::<PostAnswer>(),
        Route::write(
            "post",
            "/api/form",
            "jobs.read",
            "Entries of a text with what its format allows, after changes of some; nothing is saved",
            post(edit::form),
        )
        .with_body::<FormText>()
        .with_answer::<FormAnswer>(),
        Route::write("post", "/api/edit", "edit", "Edits a text", post(edit::edit)).with_answer::<EditAnswer>(),
        Route::get(
            "/api/position",
            "watch",
            "Positions of axes and tip; refused while an axis moves",
            get(teach::position),
        )
        .with_answer::<StandingView>(),
        Route::get("/api/teach", "watch", "Taught points and frames", get(teach::taught)).with_answer::<TaughtView>(),
        Route::get("/api/teach/picture", "watch", "The newest picture of the camera, PNG", get(teach::picture)),
        Route::write(
            "post",
            "/api/teach/program",
            "teach",
            "A program of the taught points; nothing is saved",
            post(teach::made),
        )
        .with_body::<TeachProgram>()
        .with_answer::<TaughtProgram>(),
        Route::get(
            "/api/report",
            "jobs.read",
            "The report of a plan as a page; ?job=NAME, ?language=en, uk, zh, de or ru",
            get(plan::report),
        ),
        Route::get("/api/records", "records.read", "Welds", get(records::list)).with_answer::<Vec<RecordRow>>(),
        Route::get("/api/records/{id}", "records.read", "A weld", get(records::get)).with_answer::<RecordView>(),
        Route::get("/api/records/{id}/trace", "records.read", "Its trace", get(records::trace))
            .with_answer::<TraceView>(),
        Route::get("/api/records/{id}/work", "records.read", "Its program", get(plan::recorded))
            .with_answer::<WorkView>(),
        Route::get(
            "/api/records/{id}/report",
            "records.read",
            "Its report as a page; ?language=en, uk, zh, de or ru",
            get(records::report),
        ),
        Route::get("/api/tuning", "tune", "An axis tuned in simulation", get(plan::tuning)).with_answer::<TuningView>(),
        Route::get("/api/parameters", "watch", "Axes, drives and tools in the machine file", get(setup::parameters))
            .with_answer::<ParametersView>(),
        Route::write(
            "put",
            "/api/parameters",
            "set_up",
            "Changes numbers of an axis in the machine file",
            put(setup::change),
        )
        .with_body::<ParameterChange>()
        .with_answer::<ParametersView>(),
        Route::write(
            "post",
            "/api/tool",
            "set_up",
            "Position of a tool's tip from touches of one point; nothing is saved",
            post(setup::find_tool),
        )
        .with_body::<ToolTouches>()
        .with_answer::<ToolAnswer>(),
        Route::write("put", "/api/tool", "set_up", "Saves a tool's tip in the machine file", put(setup::keep_tool))
            .with_body::<ToolTip>()
            .with_answer::<ParametersView>(),
        Route::get("/api/sensors", "watch", "Sensors in the machine file", get(sensors::sensors))
            .with_answer::<SensorsView>(),
        Route::get(
            "/api/sensor/picture",
            "set_up",
            "Picture of a plate with a grid of dots by a simulated camera, PNG",
            get(sensors::picture),
        ),
        Route {
            takes: PNG,
            ..Route::write(
                "post",
                "/api/sensor",
                "set_up",
                "Map of a camera from pixels to mm, from a picture of a grid of dots; nothing is saved",
                post(sensors::find),
            )
            .with_answer::<SensorAnswer>()
        },
        Route::write(
            "put",
            "/api/sensor",
            "set_up",
            "Saves numbers of a sensor in the machine file",
            put(sensors::keep),
        )
        .with_body::<SensorChange>()
        .with_answer::<SensorsView>(),
        Route::write(
            "post",
            "/api/alarms/shelve",
            "shelve",
            "Shelves a message-only alarm for a while",
            post(setup::shelve),
        )
        .with_body::<Shelving>(),
        Route::get("/api/audit", "audit.read", "Entries of the audit log", get(audit::list))
            .with_answer::<Vec<AuditRow>>(),
        Route::get("/api/backup", "backup", "All data as a tar archive", get(records::backup)),
        Route {
            takes: TAR,
            ..Route::write(
                "put",
                "/api/restore",
                "restore",
                "Receives an archive of a backup and checks it; nothing is replaced",
                put(restore::take),
            )
            .with_answer::<ArchiveView>()
        },
        Route::write(
            "post",
            "/api/restore",
            "restore",
            "Replaces all data by the checked archive; all sessions end",
            post(restore::begin),
        )
        .with_body::<OwnPassword>(),
        Route::get("/api/users", "users.read", "Users", get(users::list)).with_answer::<Vec<UserRow>>(),
        Route::write("put", user, "users.write", "Makes or changes a user", put(users::put))
            .with_body::<UserChange>()
            .with_answer::<UserRow>(),
        Route::write("delete", user, "users.write", "Removes a user", delete(users::delete)).with_body::<OwnPassword>(),
        Route::get("/api/openapi.json", "watch", "Description of this interface", get(openapi::document)),
    ]
}

/// Paths of routes that neither wait nor block: the front end answers them on its own threads.
pub(crate) const URGENT: [&str; 3] = ["/api/stop", "/api/live", "/healthz"];

/// Returns the complete application.
pub(crate) fn app(panel: &Arc<Panel>) -> Router {
    router(panel, routes())
}

/// Returns only the routes of [`URGENT`].
pub(crate) fn urgent_app(panel: &Arc<Panel>) -> Router {
    router(panel, routes().into_iter().filter(|route| URGENT.contains(&route.path)).collect())
}

fn router(panel: &Arc<Panel>, routes: Vec<Route>) -> Router {
    let mut router = Router::new();
    for route in routes {
        let need_of = Need { panel: Arc::clone(panel), action: route.action, takes: route.takes };
        router = router.route(route.path, route.handler.layer(middleware::from_fn_with_state(need_of, need)));
    }
    router
        .fallback(assets::serve)
        .layer(DefaultBodyLimit::max(MAX_BYTES))
        .layer(middleware::from_fn_with_state(Arc::clone(panel), host))
        // Added after the host check: monitoring tools need not know the panel's name.
        .route("/healthz", get(health::health))
        .with_state(Arc::clone(panel))
}

/// Returns method, path and permission of every route.
#[cfg(test)]
pub(crate) fn all_routes() -> Vec<(&'static str, &'static str, Option<&'static str>)> {
    routes().into_iter().map(|route| (route.method, route.path, route.action)).collect()
}
