use super::answer::JSON;
use super::declarations::Declarations;
use super::guard::{Need, host, need};
use super::panel::Panel;
use super::{
    assets, audit, cell_views, choices, diagnostics, edit, frames, health, jobs, login, monitor_access, openapi, plan,
    records, restore, schedules, sensors, setup, socket, stop, target, teach, users,
};
use crate::limits::{MAX_BODY_BYTES, MAX_STRANGER_BODY_BYTES};
use crate::wire::{
    AlarmEntry, ArchiveView, AuditRow, ChoicesView, DeviceView, DiagnosticsView, DistortionRow, DraftAnswer,
    EditAnswer, FormAnswer, FormText, FrameChange, FramePoints, FrameTaught, FramesView, JobKept, JobRow, JobText,
    Load, Login, MachineView, OwnPassword, ParameterChange, ParametersView, PlaceAnswer, PlaceText, PlanAnswer,
    PlanningView, PostAnswer, PostText, ReachAnswer, ReachText, RecordRow, RecordView, ScheduleOptions, ScheduleRow,
    ScheduleText, ScheduleView, SensorAnswer, SensorChange, SensorsView, SessionView, Shelving, StandingView, Stopped,
    TargetAnswer, TargetText, TaughtProgram, TaughtView, TeachProgram, ToolAnswer, ToolTip, ToolTouches, TraceView,
    TuningView, UserChange, UserRow, WorkView,
};
use axum::extract::DefaultBodyLimit;
use axum::routing::{MethodRouter, delete, get, post, put};
use axum::{Router, middleware};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use std::sync::Arc;
use ts_rs::{TS, TypeVisitor};

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

/// Makes the table of routes. A row has method, path, action (empty: no login needed), description, handler, types of body
/// and answer, and the content type of a body that is not JSON.
macro_rules! table {
    ($($method:ident $path:literal $action:literal $about:literal
        $handler:path $(: $body:ty)? $(=> $answer:ty)? $(, $takes:ident)?;)*) => {
        vec![$(Route {
            method: stringify!($method),
            path: $path,
            action: Some($action).filter(|action| !action.is_empty()),
            about: $about,
            body: None $(.or(shape::<$body>()))?,
            takes: *[JSON $(, $takes)?].last().unwrap_or(&JSON),
            answer: None $(.or(shape::<$answer>()))?,
            handler: $method($handler),
        }),*]
    };
}

pub(super) fn routes() -> Vec<Route> {
    table! {
        post "/api/login" "" "Starts a session" login::login: Login => SessionView;
        post "/api/stop" "" "Stops the cell; needs no login" stop::stop => Stopped;
        post "/api/logout" "watch" "Ends the session" login::logout;
        get "/api/session" "watch" "The logged-in user" login::session => SessionView;
        get "/api/machine" "watch" "The machine of the cell" cell_views::machine => MachineView;
        get "/api/machine/of-job" "plan" "The machine that a job names" cell_views::machine_of_job => MachineView;
        get "/api/devices" "watch" "Inputs, outputs and lines to devices" cell_views::devices => Vec<DeviceView>;
        get "/api/diagnostics" "diagnose" "How cell and server are: cycle, queues, disk, memory, processes"
            diagnostics::diagnostics => DiagnosticsView;
        get "/api/work" "watch" "The program in the cell" cell_views::work => Option<WorkView>;
        get "/api/alarms/catalogue" "watch" "All alarms" cell_views::catalogue => Vec<AlarmEntry>;
        get "/api/live" "watch" "The socket: status, events, commands" socket::live;
        get "/api/jobs" "jobs.read" "Jobs and examples" jobs::list => Vec<JobRow>;
        get "/api/choices" "jobs.read" "Machines and procedures that jobs can name" choices::choices => ChoicesView;
        get "/api/distortions" "jobs.read" "Distortions of simulated parts" jobs::distortions => Vec<DistortionRow>;
        get "/api/jobs/{name}" "jobs.read" "A job's text" jobs::get => JobText;
        put "/api/jobs/{name}" "jobs.write" "Saves a job" jobs::put: JobKept => JobRow;
        delete "/api/jobs/{name}" "jobs.write" "Removes a job" jobs::delete;
        post "/api/plan" "plan" "Plans a text without saving it" plan::plan: JobText => PlanAnswer;
        post "/api/draft" "plan" "Parts and sections of the joint that a text describes"
            plan::draft: JobText => DraftAnswer;
        post "/api/place" "plan" "Position of the part from touched points" plan::place: PlaceText => PlaceAnswer;
        get "/api/planning" "plan" "Running plans of this page (header x-seamwright-page) and their durations"
            plan::planning => Vec<PlanningView>;
        delete "/api/planning" "plan" "Cancels the running plans of this page; ?kind=NAME: only those of a kind"
            plan::cancel;
        post "/api/reach" "plan" "Searches the placement with the largest margin of the axes' ranges; nothing is saved"
            plan::reach: ReachText => ReachAnswer;
        post "/api/load" "load" "Plans a job and loads it into the cell" plan::load: Load => WorkView;
        post "/api/post" "post" "A part program with its proof" plan::post: PostText => PostAnswer;
        post "/api/form" "jobs.read" "Entries of a text with what its format allows, after changes of some; nothing is saved"
            edit::form: FormText => FormAnswer;
        post "/api/edit" "edit" "Edits a text" edit::edit => EditAnswer;
        get "/api/position" "watch" "Positions of axes and tip; refused while an axis moves"
            teach::position => StandingView;
        post "/api/target" "jog" "Checks a target of motion by hand: positions, duration, clearance; nothing moves"
            target::check: TargetText => TargetAnswer;
        get "/api/teach" "watch" "Taught points and frames" teach::taught => TaughtView;
        get "/api/teach/picture" "watch" "The newest picture of the camera, PNG" teach::picture;
        post "/api/teach/program" "teach" "A program of the taught points; nothing is saved"
            teach::made: TeachProgram => TaughtProgram;
        get "/api/report" "jobs.read" "The report of a plan as a page; ?job=NAME, ?language=en, uk, zh, de or ru, ?appendix=true for curves and the job's text"
            plan::report;
        get "/api/schedules" "jobs.read" "Tables of seams, and how far they are planned" schedules::list => Vec<ScheduleRow>;
        get "/api/schedules/{name}" "jobs.read" "A table with what is known of its rows" schedules::get => ScheduleView;
        put "/api/schedules/{name}" "jobs.write" "Checks and saves a table" schedules::put: ScheduleText => ScheduleRow;
        delete "/api/schedules/{name}" "jobs.write" "Removes a table with its results" schedules::delete;
        post "/api/schedules/{name}/run" "jobs.write" "Plans all rows of a table that have no result yet; one table at a time"
            schedules::run: ScheduleOptions;
        delete "/api/schedules/{name}/run" "jobs.write" "Cancels it; what is planned is kept" schedules::cancel;
        get "/api/schedules/{name}/job" "jobs.read" "The job of a row; ?row=NAME, ?machine=NAME of several"
            schedules::job => JobText;
        get "/api/schedules/{name}/files/{file}" "jobs.read" "A result file: schedule.csv, schedule.parquet, machines.csv, report.html"
            schedules::file;
        get "/api/records" "records.read" "Welds" records::list => Vec<RecordRow>;
        get "/api/records/{id}" "records.read" "A weld" records::get => RecordView;
        get "/api/records/{id}/trace" "records.read" "Its trace" records::trace => TraceView;
        get "/api/records/{id}/work" "records.read" "Its program" plan::recorded => WorkView;
        get "/api/records/{id}/report" "records.read" "Its report as a page; ?language=en, uk, zh, de or ru"
            records::report;
        get "/api/tuning" "tune" "An axis tuned in simulation" plan::tuning => TuningView;
        get "/api/parameters" "watch" "Axes, drives and tools in the machine file" setup::parameters => ParametersView;
        put "/api/parameters" "set_up" "Changes numbers of an axis in the machine file"
            setup::change: ParameterChange => ParametersView;
        post "/api/tool" "set_up" "Position of a tool's tip from touches of one point; nothing is saved"
            setup::find_tool: ToolTouches => ToolAnswer;
        put "/api/tool" "set_up" "Saves a tool's tip in the machine file" setup::keep_tool: ToolTip => ParametersView;
        get "/api/frames" "watch" "Frames in the machine file" frames::frames => FramesView;
        put "/api/frames" "set_up" "Saves or removes a frame in the machine file" frames::keep: FrameChange => FramesView;
        post "/api/frames/teach" "set_up" "A frame through three touched points; nothing is saved"
            frames::teach: FramePoints => FrameTaught;
        get "/api/sensors" "watch" "Sensors in the machine file" sensors::sensors => SensorsView;
        get "/api/sensor/picture" "set_up" "Picture of a plate with a grid of dots by a simulated camera, PNG"
            sensors::picture;
        post "/api/sensor" "set_up" "Map of a camera from pixels to mm, from a picture of a grid of dots; nothing is saved"
            sensors::find => SensorAnswer, PNG;
        put "/api/sensor" "set_up" "Saves numbers of a sensor in the machine file"
            sensors::keep: SensorChange => SensorsView;
        post "/api/alarms/shelve" "shelve" "Shelves a message-only alarm for a while" setup::shelve: Shelving;
        get "/api/audit" "audit.read" "Entries of the audit log" audit::list => Vec<AuditRow>;
        get "/api/backup" "backup" "All data as a tar archive" records::backup;
        put "/api/restore" "restore" "Receives an archive of a backup and checks it; nothing is replaced"
            restore::take => ArchiveView, TAR;
        post "/api/restore" "restore" "Replaces all data by the checked archive; all sessions end"
            restore::begin: OwnPassword;
        get "/api/users" "users.read" "Users" users::list => Vec<UserRow>;
        put "/api/users/{name}" "users.write" "Makes or changes a user" users::put: UserChange => UserRow;
        delete "/api/users/{name}" "users.write" "Removes a user" users::delete: OwnPassword;
        get "/api/openapi.json" "watch" "Description of this interface" openapi::document;
    }
}

/// Paths of routes that neither wait nor block: the front end answers them on its own threads.
pub(crate) const URGENT: [&str; 6] = ["/api/stop", "/api/live", "/api/diagnostics", "/healthz", "/readyz", "/metrics"];

pub(crate) fn app(panel: &Arc<Panel>) -> Router {
    router(panel, routes())
}

pub(crate) fn urgent_app(panel: &Arc<Panel>) -> Router {
    router(panel, routes().into_iter().filter(|route| URGENT.contains(&route.path)).collect())
}

fn router(panel: &Arc<Panel>, routes: Vec<Route>) -> Router {
    let mut router = Router::new();
    for route in routes {
        let need_of = Need { panel: Arc::clone(panel), action: route.action, takes: route.takes };
        let most = if route.action.is_some() { MAX_BODY_BYTES } else { MAX_STRANGER_BODY_BYTES };
        let handler = route.handler.layer(DefaultBodyLimit::max(most));
        router = router.route(route.path, handler.layer(middleware::from_fn_with_state(need_of, need)));
    }
    let monitor = || middleware::from_fn_with_state(Arc::clone(panel), monitor_access::monitor);
    router
        .route("/readyz", get(diagnostics::ready).layer(monitor()))
        .route("/metrics", get(diagnostics::metrics).layer(monitor()))
        .fallback(assets::serve)
        .layer(middleware::from_fn_with_state(Arc::clone(panel), host))
        // Added after the host check: monitoring tools need not know the panel's name.
        .route("/healthz", get(health::health))
        .with_state(Arc::clone(panel))
}

#[cfg(test)]
pub(crate) fn all_routes() -> Vec<(&'static str, &'static str, Option<&'static str>)> {
    routes().into_iter().map(|route| (route.method, route.path, route.action)).collect()
}
