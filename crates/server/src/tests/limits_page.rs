//! The page of limits in the reference, made from the constants.

use crate::limits as is;
use crate::limits::Queue;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A limit.
struct Row {
    what: &'static str,
    limit: String,
    beyond: &'static str,
    /// How it is measured.
    counted: String,
    /// Tests that go beyond it: `FILE::NAME`, files of this crate's `src` or of the repository.
    tests: &'static [&'static str],
}

fn row(what: &'static str, limit: String, beyond: &'static str, counted: &str, tests: &'static [&'static str]) -> Row {
    Row { what, limit, beyond, counted: counted.to_owned(), tests }
}

/// A limit of another crate: its constant must be in this line of this file.
fn elsewhere(
    what: &'static str,
    limit: &str,
    beyond: &'static str,
    (file, line): (&'static str, &'static str),
    tests: &'static [&'static str],
) -> Row {
    let text = std::fs::read_to_string(repository().join(file)).unwrap();
    assert!(text.contains(line), "{file} has no line `{line}`: adapt the row “{what}”");
    let name = line.split("const ").nth(1).and_then(|rest| rest.split(':').next());
    let counted = name.map_or_else(|| format!("`{file}`"), |name| format!("`{name}` in `{file}`"));
    Row { what, limit: limit.to_owned(), beyond, counted, tests }
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A number with separators.
fn count(n: impl TryInto<u64>) -> String {
    let digits = n.try_into().unwrap_or_default().to_string();
    let groups: Vec<&str> = digits.as_bytes().rchunks(3).rev().map(|g| std::str::from_utf8(g).unwrap()).collect();
    groups.join(",")
}

fn bytes(n: impl TryInto<u64>) -> String {
    let n: u64 = n.try_into().unwrap_or_default();
    let unit = |shift: u32, name: &str| {
        (n >= 1 << shift && n.is_multiple_of(1 << shift)).then(|| format!("{} {name}", n >> shift))
    };
    unit(30, "GiB")
        .or_else(|| unit(20, "MiB"))
        .or_else(|| unit(10, "KiB"))
        .unwrap_or_else(|| format!("{} bytes", count(n)))
}

fn time(time: Duration) -> String {
    match time.as_secs() {
        s if s >= 3600 && s % 3600 == 0 => format!("{} h", s / 3600),
        s if s > 60 && s % 60 == 0 => format!("{} min", s / 60),
        s => format!("{s} s"),
    }
}

fn queue(of: Queue) -> String {
    format!("{} at once, {} waiting", of.at_once, count(of.waiting as u64))
}

type Section = (&'static str, &'static str, Vec<Row>);

const CLOSED: &str = "the connection is closed";
const SLOW_DOWN: &str = "503 `slow_down`";
const INPUT: &str = "422 `input`";

const UNFINISHED: &str = "front/tests.rs::unfinished_requests_keep_nobody_from_stopping";
const HEADS: &str = "front/tests.rs::heads_that_are_too_large_are_refused";
const QUEUES: &str = "tests/limits.rs::queues_that_are_full_refuse_and_hold_up_no_stop";
const SLOW: &str = "tests/limits.rs::three_hundred_slow_clients_keep_nobody_out";
const ONE_MORE: &str = "tests/limits.rs::one_more_than_allowed_is_refused";
const NO_PAGE: &str = "tests/limits.rs::an_operator_gets_a_page_while_all_others_are_taken";
const PLACES: &str = "front/connection_slots.rs::places_of_connections_are_kept_for_operators";
const NEWCOMERS: &str = "front/connection_slots.rs::newcomers_get_in_and_known_users_stay";
const SHARES: &str = "http/work_limit.rs::places_are_kept_for_other_users_and_for_operators";
const PAGES: &str = "cell/hub.rs::places_are_kept_for_those_who_operate";
const SESSIONS: &str = "users/sessions.rs::logins_end_sessions_of_their_own_user_only";
const OLD: &str = "users/sessions.rs::sessions_grow_old";
const GUESSES: &str = "users/login_attempts.rs::who_guesses_waits_and_others_do_not";
const USERS: &str = "users/accounts.rs::a_file_of_too_many_users_is_refused";
const PLANS: &str = "planner/tests.rs::failures_of_the_process_are_answers";
const BOUNDED: &str = "crates/cli/tests/it/serve.rs::the_process_that_plans_is_bounded";
const TRACES: &str = "tests/attacked.rs::what_is_asked_for_is_bounded";
const BIG: &str = "tests/attacked.rs::thousands_of_malformed_requests_are_refused";
const ARCHIVES: &str = "tests/restored.rs::archives_are_checked_whole_and_by_the_administrator_only";
const TRICKLE: &str = "http/transfer_rate.rs::a_trickle_is_given_up_and_a_steady_transfer_is_not";

fn connections() -> Section {
    let intro = "A connection counts as its user's from the first request with a valid session cookie. All others \
                 share the places without a session, where a newcomer always gets in: the login page can stop the \
                 machine.";
    let rows = vec![
        row(
            "Connections without a session",
            count(is::MAX_STRANGERS as u64),
            "the oldest one that waits for a request is closed, of the address with the most",
            "all at once",
            &[UNFINISHED, NEWCOMERS, SLOW],
        ),
        row(
            "The same from one remote address",
            count(is::MAX_STRANGERS_OF_ADDRESS as u64),
            "its own oldest one is closed",
            "by address; not on this computer",
            &["front/connection_slots.rs::one_address_ends_its_own_connections"],
        ),
        row(
            "Connections with a session",
            count(is::MAX_CONNECTIONS as u64),
            "further ones count as without a session",
            "all at once",
            &[PLACES],
        ),
        row(
            "Of these, kept for operators",
            count(is::CONNECTIONS_KEPT_FOR_OPERATORS as u64),
            "those of viewers count as without a session",
            "by role",
            &[PLACES],
        ),
        row(
            "Connections of one user",
            count(is::MAX_CONNECTIONS_OF_USER as u64),
            "further ones count as without a session",
            "by user",
            &[NEWCOMERS],
        ),
        row(
            "TLS handshake; head of a request; pause between requests",
            time(is::HEAD_TIME),
            CLOSED,
            "each",
            &["front/tests.rs::only_the_plain_version_is_spoken_and_in_time", SLOW],
        ),
        row(
            "Time until a client reads some of what is sent",
            time(is::READ_TIME),
            CLOSED,
            "from a full buffer of the system",
            &["front/tests.rs::who_does_not_read_is_cut_off", SLOW],
        ),
        row(
            "Rate at which an answer is read",
            format!("at least {}/s, after {}", bytes(is::READ_RATE_BYTES_PER_S as u64), time(is::READ_TIME)),
            CLOSED,
            "mean of the whole answer",
            &["front/tests.rs::who_reads_an_answer_too_slowly_is_cut_off"],
        ),
    ];
    ("Connections", intro, rows)
}

fn requests() -> Section {
    let intro = "`POST /api/stop` is answered before its body has arrived, and is not counted by any rate.";
    let rows = vec![
        row("Head of a request", bytes(is::MAX_HEAD_BYTES as u64), "431, closed", "all lines", &[HEADS]),
        row("Header lines", count(is::MAX_HEADERS as u64), "431, closed", "lines", &[HEADS]),
        row(
            "Body without a session",
            bytes(is::MAX_STRANGER_BODY_BYTES as u64),
            "413 `size`",
            "declared and received size",
            &[BIG],
        ),
        row(
            "Body with a session",
            bytes(is::MAX_BODY_BYTES as u64),
            "413 `size`",
            "declared and received size",
            &[BIG, "tests/guarded.rs::wrong_bodies_are_told_and_passwords_slowed"],
        ),
        row(
            "Time for a body without a session",
            time(is::STRANGER_BODY_TIME),
            "408 `slow_down`, closed",
            "from the end of the head",
            &[UNFINISHED, SLOW],
        ),
        row(
            "Time for a body with a session",
            time(is::BODY_TIME),
            "408 `slow_down`, closed",
            "from the end of the head",
            &["front/tests.rs::who_sends_a_body_too_slowly_is_cut_off", SLOW],
        ),
        row(
            "Large bodies being received",
            format!("{}, {} of one user", bytes(is::BODY_ROOM_BYTES as u64), bytes(is::BODY_ROOM_OF_USER_BYTES as u64)),
            "the request waits, up to its time",
            "sum of declared sizes above 64 KiB",
            &[
                "front/tests.rs::large_requests_that_trickle_hold_up_no_other_user",
                "front/tests.rs::large_requests_that_trickle_hold_up_nothing_small",
            ],
        ),
        row(
            "Requests of a session, or of an address without one",
            format!("{} a second, bursts of {}", is::REQUEST_RATE_PER_S, is::REQUEST_BURST),
            "429 `slow_down`, closed",
            "each; without a session not on this computer",
            &["front/tests.rs::who_asks_without_end_is_slowed_down"],
        ),
        row(
            "Sessions and addresses whose rate is known",
            count(is::MAX_RATES as u64),
            "429 for new ones until others have paused",
            "all",
            &["front/rate_limits.rs::made_up_addresses_take_bounded_memory"],
        ),
        row(
            "Large answers held until they are sent",
            format!(
                "{}, {} of one user",
                bytes(is::ANSWER_ROOM_BYTES as u64),
                bytes(is::ANSWER_ROOM_OF_USER_BYTES as u64)
            ),
            SLOW_DOWN,
            "sum of sizes above 64 KiB",
            &["front/tests.rs::answers_that_nobody_reads_take_bounded_memory"],
        ),
    ];
    ("Requests and answers", intro, rows)
}

fn work() -> Section {
    let intro = "Requests that need a disk, the library or a plan wait in queues of their kind. A user has at most half \
                 of the places of a queue, and so have all viewers together; of several turns viewers leave one to \
                 others. STOP, status and commands of pages use no queue.";
    let row = |what, of: Queue| row(what, queue(of), SLOW_DOWN, "until the work is done", &[QUEUES, SHARES]);
    let rows = vec![
        row("Reading records, audit log, jobs and texts", is::READING),
        row("Views of machine, sensors and parameters", is::DRAWING),
        row("Saving files", is::SAVING),
        row("Loading a job, tuning", is::LOADING),
        row("Checking passwords", is::CHECKING),
        row("Backup and restore", is::BACKING_UP),
    ];
    ("Work", intro, rows)
}

fn pages() -> Section {
    let intro = "A page is a connection over which a browser gets the state of the cell and sends commands.";
    let rows = vec![
        row("Pages", count(is::MAX_PAGES as u64), SLOW_DOWN, "all", &[PAGES, NO_PAGE]),
        row("Pages of viewers", count(is::MAX_VIEWER_PAGES as u64), SLOW_DOWN, "by role", &[PAGES, NO_PAGE]),
        row(
            "Pages of one user",
            count(is::MAX_PAGES_OF_USER as u64),
            SLOW_DOWN,
            "by user",
            &["tests/attacked.rs::sockets_want_a_session_and_a_page_of_ours", PAGES],
        ),
        row(
            "Places kept for the first page of operators",
            count(is::PAGES_KEPT_FOR_OPERATORS as u64),
            SLOW_DOWN,
            "by role",
            &[PAGES, NO_PAGE],
        ),
        row(
            "Message from a page",
            bytes(is::MAX_MESSAGE_BYTES as u64),
            CLOSED,
            "each, with all its fragments",
            &["tests/attacked.rs::sockets_want_a_session_and_a_page_of_ours"],
        ),
        row(
            "Messages of a page",
            format!("{} a second, bursts of {}", is::MESSAGE_RATE_PER_S, is::MESSAGE_BURST),
            CLOSED,
            "all kinds, pings too",
            &["tests/limits.rs::a_page_that_floods_is_closed"],
        ),
        row(
            "Messages that wait for a page",
            count(is::MAX_WAITING_MESSAGES as u64),
            "the page is disconnected and connects anew",
            "without status, of which only the newest waits",
            &["tests/limits.rs::a_page_that_never_reads_is_disconnected"],
        ),
        row(
            "Time that a page takes for a message",
            time(is::MESSAGE_TIME),
            "the page is disconnected and connects anew",
            "each",
            &["tests/limits.rs::a_page_that_never_reads_is_disconnected"],
        ),
        row(
            "Events that a new page gets",
            count(is::RECENT_EVENTS as u64),
            "older ones are in records and audit log",
            "the newest",
            &["tests/limits.rs::a_page_that_never_reads_is_disconnected"],
        ),
    ];
    ("Pages", intro, rows)
}

fn users() -> Section {
    let rows = vec![
        row("Users", count(is::MAX_USERS as u64), INPUT, "all", &[USERS]),
        row(
            "File of users, also of an archive",
            bytes(is::MAX_USERS_FILE_BYTES),
            "422 `archive`; a panel does not start",
            "size",
            &[USERS],
        ),
        row(
            "Name; password",
            format!("{}; {} to {} characters", is::MAX_NAME_CHARS, is::MIN_PASSWORD_CHARS, is::MAX_NAME_CHARS),
            INPUT,
            "characters",
            &["users/accounts.rs::users_come_and_go_and_an_admin_stays"],
        ),
        row(
            "Name or password at login",
            bytes(is::MAX_LOGIN_BYTES as u64),
            INPUT,
            "each",
            &["tests/attacked.rs::guesses_at_once_count_one_by_one"],
        ),
        row(
            "Wrong passwords",
            format!("{} of a name, {} of a remote address", is::MAX_WRONG_OF_NAME, is::MAX_WRONG_OF_ADDRESS),
            "429 `slow_down`: wait before the next try",
            "by name and address; in a known browser by itself",
            &[GUESSES, "users/login_attempts.rs::own_devices_are_not_locked_out_by_others"],
        ),
        row(
            "Wait after wrong passwords",
            format!(
                "{}, doubled up to {} times, on this computer {}",
                time(is::WRONG_WAIT),
                is::WRONG_DOUBLINGS,
                is::WRONG_DOUBLINGS_HERE
            ),
            "forgotten after an hour",
            "from the last wrong one",
            &["users/login_attempts.rs::own_devices_are_not_locked_out_by_others"],
        ),
        row(
            "Names, addresses and browsers whose wrong passwords are counted",
            count(is::MAX_WRONG_KEYS as u64),
            "those with the fewest are forgotten",
            "all",
            &["users/login_attempts.rs::it_never_grows_without_end_and_forgets_the_least"],
        ),
        row(
            "Passwords of one name that wait for a check",
            count(is::MAX_CHECKS_OF_NAME as u64),
            "429 `slow_down`",
            "by name",
            &["users/login_attempts.rs::no_name_takes_the_places_of_another"],
        ),
        row(
            "Cost of a password hash that is checked",
            format!("{}, {} passes", bytes(u64::from(is::MAX_HASH_MEMORY_KIB) << 10), is::MAX_HASH_PASSES),
            "the password is wrong",
            "parameters of Argon2id; all checks share one memory",
            &["users/passwords.rs::hundreds_of_checks_take_the_memory_of_one"],
        ),
        row(
            "Sessions",
            format!("{}, {} of one user", is::MAX_SESSIONS, is::MAX_SESSIONS_OF_USER),
            "the session seen least recently ends, of the user with the most",
            "logins",
            &[SESSIONS, "users/sessions.rs::sessions_end"],
        ),
        row("Session without use", time(is::SESSION_IDLE), "401 `login`", "watching is no use", &[OLD]),
        row("Session", time(is::SESSION_TIME), "401 `login`", "from the login", &[OLD]),
        row(
            "Known browsers",
            format!("{}, {} of one user", count(is::MAX_BROWSERS as u64), is::MAX_BROWSERS_OF_USER),
            "the one used least recently is forgotten",
            "cookies",
            &["users/known_browsers.rs::devices_are_of_one_user_and_bounded"],
        ),
    ];
    ("Users, logins, sessions", "", rows)
}

fn plans() -> Section {
    let intro = "Texts are planned in processes of their own: a text that needs too much memory or time ends its process, \
                 not the panel.";
    let rows = vec![
        row("Memory of a plan", bytes(is::PLAN_MEMORY_BYTES), INPUT, "address space of its process", &[PLANS, BOUNDED]),
        row("Processor time of a plan", time(is::PLAN_PROCESSOR_TIME), "500 `server`", "of its process", &[BOUNDED]),
        row("Time of a draft", time(is::DRAFT_TIME), INPUT, "from its start", &[PLANS]),
        row("Time of a plan, part program, report or load", time(is::PLAN_TIME), INPUT, "from its start", &[PLANS]),
        row("Answer of a plan", bytes(is::MAX_PLAN_BYTES as u64), INPUT, "JSON", &[PLANS]),
        row(
            "Plans; drafts; loads; searches",
            format!("each {}", queue(is::PLANNING)),
            SLOW_DOWN,
            "processes of each kind",
            &["planner/tests.rs::one_user_does_not_take_all_places", QUEUES],
        ),
        row(
            "The same of one user",
            count(is::MAX_PLANS_OF_USER as u64),
            SLOW_DOWN,
            "over all pages; a newer draft of a page ends its older one",
            &["planner/tests.rs::one_user_does_not_take_all_places"],
        ),
    ];
    ("Plans and drafts", intro, rows)
}

fn texts() -> Section {
    let intro = "Jobs, programs, procedures and machine files. Limits of programs apply on the command line too.";
    let rows = vec![
        row(
            "Jobs",
            count(is::MAX_JOBS as u64),
            INPUT,
            "files in `jobs`",
            &["tests/limits.rs::jobs_are_bounded_in_size_and_number"],
        ),
        row(
            "Tables of seams",
            count(is::MAX_SCHEDULES as u64),
            INPUT,
            "files in `jobs/schedules`",
            &["tests/scheduled.rs::tables_and_user_frames_are_bounded_in_number"],
        ),
        row(
            "Parts of a schedule that a page shows",
            count(is::MAX_SCHEDULE_PARTS as u64),
            "the first",
            "of weldable rows",
            &["tests/scheduled.rs::a_table_is_imported_planned_exported_and_removed"],
        ),
        row(
            "User frames",
            count(is::MAX_FRAMES as u64),
            INPUT,
            "in a machine file",
            &["tests/scheduled.rs::tables_and_user_frames_are_bounded_in_number"],
        ),
        row("File name of a job", bytes(is::MAX_JOB_NAME_BYTES as u64), INPUT, "UTF-8", &[ONE_MORE]),
        row(
            "Text of a job",
            bytes(is::MAX_JOB_BYTES),
            INPUT,
            "size of the file; a larger one can be removed",
            &["tests/limits.rs::jobs_are_bounded_in_size_and_number"],
        ),
        row("Operations of a request", count(is::MAX_OPERATIONS as u64), INPUT, "each request", &[ONE_MORE]),
        row("Changes of a form", count(is::MAX_FORM_CHANGES as u64), INPUT, "each request", &[ONE_MORE]),
        row(
            "Tables in a form",
            format!("{} of passes, {} others", count(is::MAX_FORM_TABLES as u64), count(is::MAX_FORM_TABLES as u64)),
            "further ones are changed in the text",
            "in the order of the text",
            &["form/tests.rs::a_form_has_a_bounded_number_of_tables"],
        ),
        row("Part number", count(is::MAX_PART_CHARS as u64), INPUT, "characters", &[ONE_MORE, TRACES]),
        row("Points of a part's position", count(is::MAX_PLACE_POINTS as u64), INPUT, "each request", &[ONE_MORE]),
        row("Touches of a tool", count(is::MAX_TOUCHES as u64), INPUT, "each request", &[ONE_MORE]),
        row(
            "Picture of a grid",
            format!("{} pixels", count(is::MAX_PICTURE_PX as u64)),
            "verdict `picture`",
            "before it is decoded; a camera's own size is allowed",
            &["tests/sensors.rs::what_is_no_picture_of_the_grid_is_refused_with_its_reason"],
        ),
        elsewhere(
            "Tables and lists within each other",
            "32",
            INPUT,
            ("crates/document/src/nesting.rs", "const MAX_NESTING: usize = 32;"),
            &[
                "crates/document/tests/it/nesting.rs::texts_that_nest_too_deeply_are_refused_before_they_are_parsed",
                ONE_MORE,
            ],
        ),
        elsewhere(
            "File that a job names",
            "64 MiB",
            INPUT,
            ("crates/project/src/file_scope.rs", "const MAX_BYTES: u64 = 64 << 20;"),
            &["crates/project/src/file_scope.rs::names_stay_within_the_fence"],
        ),
        elsewhere(
            "Passes of a program",
            "10,000",
            INPUT,
            ("crates/program/src/size_limits.rs", "const MAX_PASSES: usize = 10_000;"),
            &["crates/weld/tests/it/bounds.rs::programs_of_too_many_passes_are_refused_before_they_are_repeated"],
        ),
        elsewhere(
            "Rows of all passes",
            "4,000,000",
            INPUT,
            ("crates/program/src/size_limits.rs", "const MAX_ROWS: usize = 4_000_000;"),
            &["crates/weld/tests/it/bounds.rs::refusals_of_many_rows_name_a_table_of_the_file"],
        ),
        elsewhere(
            "Seam",
            "1 km",
            INPUT,
            ("crates/program/src/size_limits.rs", "const MAX_SEAM_MM: f64 = 1e6;"),
            &["crates/weld/tests/it/bounds.rs::seams_of_more_than_a_kilometre_are_refused"],
        ),
        elsewhere(
            "Travel of a pass",
            "a day",
            INPUT,
            ("crates/program/src/size_limits.rs", "const MAX_TRAVEL_S: f64 = 86_400.0;"),
            &["crates/weld/tests/it/bounds.rs::a_pass_of_more_than_a_day_is_refused_at_its_speed"],
        ),
        elsewhere(
            "Time with a unit in a key",
            "1 h",
            INPUT,
            ("crates/document/src/bounds.rs", "bound(\"_s\", Unit::S, [0.0, 3600.0], \"document-bound-hour\")"),
            &["crates/weld/tests/it/bounds.rs::slips_of_the_trial_are_refused_at_their_key"],
        ),
        elsewhere(
            "Beads of a groove",
            "5,000",
            INPUT,
            ("crates/weld/src/beads/layers.rs", "const MAX_BEADS: usize = 5_000;"),
            &["crates/weld/tests/it/bounds.rs::a_groove_of_too_many_beads_is_refused_before_they_are_made"],
        ),
    ];
    ("Texts", intro, rows)
}

fn records() -> Section {
    let intro = "Searches return the newest entries. An archive is checked completely before anything is replaced; it takes \
                 no more room unpacked than packed, since compressed and sparse ones are refused.";
    let rows = vec![
        row(
            "Welds of a list",
            count(is::MAX_WELDS),
            "the newest are listed",
            "each request",
            &["crates/record/tests/it/welds.rs::words_are_found_among_many_alarms"],
        ),
        row(
            "Rows, columns and values of a trace",
            format!(
                "{}, {}, {}",
                count(is::MAX_TRACE_ROWS as u64),
                is::MAX_TRACE_COLUMNS,
                count(is::MAX_TRACE_VALUES as u64)
            ),
            INPUT,
            "each request",
            &[TRACES],
        ),
        row(
            "Entries of the audit log",
            count(is::MAX_AUDIT_ENTRIES),
            "the newest are sent",
            "each request",
            &["tests/recorded.rs::the_audit_log_is_read_page_by_page_and_searched_whole"],
        ),
        row(
            "Time for reading the library",
            time(is::SEARCH_TIME),
            SLOW_DOWN,
            "from its start; also when the client has gone",
            &["crates/record/tests/it/welds.rs::a_search_that_takes_too_long_is_ended"],
        ),
        row("Text that is searched", format!("{} characters", is::MAX_SEARCH_CHARS), INPUT, "characters", &[ONE_MORE]),
        row(
            "Archive sent by a page",
            bytes(is::MAX_ARCHIVE_BYTES),
            "413 `size`",
            "declared and received size",
            &[ARCHIVES, "http/restore.rs::no_more_is_kept_than_allowed_and_nothing_that_broke_off"],
        ),
        row(
            "Rate of an archive, in both directions",
            format!("at least {}/s, after {}", bytes(is::ARCHIVE_RATE_BYTES_PER_S), time(is::PIECE_TIME)),
            "422 `input`, or the answer breaks off",
            "mean, and time of each piece",
            &[TRICKLE],
        ),
        elsewhere(
            "Free room on the disk for a weld",
            "twice its raw trace and 64 MiB",
            "the weld is refused",
            ("crates/record/src/disk.rs", "pub const SPARE_BYTES: u64 = 64 << 20;"),
            &["crates/record/tests/it/welds.rs::no_room_no_weld"],
        ),
        elsewhere(
            "Files and folders of an archive",
            "500,000",
            "422 `archive`; a backup is refused",
            ("crates/record/src/backup.rs", "const MAX_ENTRIES: usize = 500_000;"),
            &["crates/record/src/backup.rs::an_archive_of_too_many_files_makes_none"],
        ),
        elsewhere(
            "Name of an entry",
            "4 KiB",
            "422 `archive`",
            ("crates/record/src/backup.rs", "const MAX_NAME_BYTES: u64 = 4 << 10;"),
            &["crates/record/src/backup.rs::names_of_gigabytes_and_sparse_files_are_refused"],
        ),
        elsewhere(
            "List of hashes of an archive",
            "64 MiB",
            "422 `archive`",
            ("crates/record/src/backup.rs", "const MAX_MANIFEST: u64 = 64 << 20;"),
            &["crates/record/src/backup.rs::a_manifest_of_any_size_is_not_read"],
        ),
    ];
    ("Records, audit log, archives", intro, rows)
}

fn cell_queues() -> Section {
    let intro = "The cycle never waits: queues between it, the disk and the panel have a fixed size.";
    let rows = vec![
        elsewhere(
            "Alarms, and orders, that wait for the disk",
            "65,536 entries and 16 MiB each",
            "counted, and the count is written",
            ("crates/server/src/cell/archive_queue.rs", "const MAX_ENTRIES: usize = 65_536;"),
            &[
                "cell/archive.rs::what_is_repeated_takes_no_room_of_alarms_and_orders",
                "cell/archive.rs::a_flood_of_refusals_displaces_nothing_and_is_summed_exactly",
            ],
        ),
        elsewhere(
            "Sources of refusals that are summed up in a minute",
            "64 sources with 8 kinds each",
            "further ones are summed up together",
            ("crates/server/src/cell/refusals.rs", "const MAX_SOURCES: usize = 64;"),
            &["cell/refusals.rs::made_up_sources_and_kinds_take_bounded_memory_and_entries"],
        ),
        elsewhere(
            "Active alarms",
            "160",
            "the number of lost ones is counted",
            ("crates/executive/src/executive/alarm_list.rs", "const MAX_ALARMS: usize = 160;"),
            &["crates/executive/src/executive/alarm_list.rs::a_full_list_tells_what_it_lost"],
        ),
        elsewhere(
            "Time-out of a Modbus device that switches something on",
            "1 s",
            "the machine file is refused",
            ("crates/machine/src/devices/register_check.rs", "let longest = if switches { 1.0 } else { 5.0 };"),
            &["crates/machine/tests/it/devices.rs::what_cannot_be_is_refused_with_its_address"],
        ),
        elsewhere(
            "Decoded picture of a camera",
            "512 MiB",
            "the picture is refused",
            ("crates/frames/src/decode.rs", "const MAX_BYTES: usize = 512 << 20;"),
            &["crates/frames/tests/frame_sources.rs::pictures_are_bounded_before_they_are_decoded"],
        ),
    ];
    ("Queues of the cell, devices", intro, rows)
}

fn page() -> String {
    let mut page = String::from(
        "# Limits of the server\n\n<!-- Made from crates/server/src/limits.rs by a test; change it there, then run\n\
         `SEAMWRIGHT_BLESS=1 cargo test -p seamwright-server the_page_of_limits`. -->\n\n\
         Every limit of the panel's server: what happens beyond it, how it is measured, and which test goes there \
         (paths are below `crates/server/src/`, or from the root of the repository). Refusals are JSON with a key, see \
         [REST interface](rest-api.md). STOP, status and commands of an operator's page go on while any of these limits \
         is exhausted.\n",
    );
    for (title, intro, rows) in
        [connections(), requests(), work(), pages(), users(), plans(), texts(), records(), cell_queues()]
    {
        let _ = write!(page, "\n## {title}\n\n");
        if !intro.is_empty() {
            let _ = write!(page, "{intro}\n\n");
        }
        page += "| what | limit | beyond it | measured | tests |\n|---|---|---|---|---|\n";
        for row in rows {
            let tests: Vec<String> = row.tests.iter().map(|test| checked(test)).collect();
            let (what, limit, beyond, counted) = (row.what, row.limit, row.beyond, row.counted);
            let _ = writeln!(page, "| {what} | {limit} | {beyond} | {counted} | {} |", tests.join("<br>"));
        }
    }
    page
}

/// A test as the page names it, once its file has it.
fn checked(test: &str) -> String {
    let (file, name) = test.split_once("::").unwrap_or((test, ""));
    let folder =
        if file.starts_with("crates/") { repository() } else { Path::new(env!("CARGO_MANIFEST_DIR")).join("src") };
    let text = std::fs::read_to_string(folder.join(file)).unwrap_or_default();
    assert!(!name.is_empty() && text.contains(&format!("fn {name}()")), "there is no test {test}");
    format!("`{file}` `{name}`")
}

#[test]
fn the_page_of_limits_is_that_of_the_constants() {
    let path = repository().join("docs/reference/server-limits.md");
    let page = page();
    if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(known == page, "docs/reference/server-limits.md is not up to date: run this test with SEAMWRIGHT_BLESS=1");
}
