//! Limits of the panel's server, each with its unit and its reason.
//!
//! `docs/reference/server-limits.md` is made from these constants: it says what happens beyond each of them, and which
//! test goes there. Limits of queues to the disk are constants of [`crate::cell`], those of log lines of `seamwright_log`.

use std::time::Duration;

/// Limit of long work: how much of it runs at once, and how much waits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Queue {
    pub(crate) at_once: usize,
    pub(crate) waiting: usize,
}

// Connections.

/// Maximum number of connections without a session. A new one closes the oldest: a newcomer, who may want to stop the
/// machine, always gets in.
pub(crate) const MAX_STRANGERS: usize = 128;
/// The same from one address. Not applied on this computer: behind a tunnel everybody has its address.
pub(crate) const MAX_STRANGERS_OF_ADDRESS: usize = 64;
/// Maximum number of connections with a session; further ones count as without a session.
pub(crate) const MAX_CONNECTIONS: usize = 400;
/// The same of one user.
pub(crate) const MAX_CONNECTIONS_OF_USER: usize = 64;
/// Places among [`MAX_CONNECTIONS`] that viewers do not get, so that operators have some.
pub(crate) const CONNECTIONS_KEPT_FOR_OPERATORS: usize = 100;

// Requests.

/// Maximum size of the head of a request, bytes: browsers send less than 4 KiB.
pub(crate) const MAX_HEAD_BYTES: usize = 32 << 10;
/// Maximum number of header lines: browsers send about 20.
pub(crate) const MAX_HEADERS: usize = 64;
/// Maximum time for the TLS handshake, for the head of a request, and between requests.
pub(crate) const HEAD_TIME: Duration = Duration::from_secs(10);
/// Maximum time for the body of a client without a session.
pub(crate) const STRANGER_BODY_TIME: Duration = Duration::from_secs(5);
/// Maximum time for the body of a user with a session.
pub(crate) const BODY_TIME: Duration = Duration::from_secs(60);
/// Maximum size of a body without a session, bytes: a name and a password.
pub(crate) const MAX_STRANGER_BODY_BYTES: usize = 8 << 10;
/// Maximum size of a body with a session, bytes: a long job text, or a picture.
pub(crate) const MAX_BODY_BYTES: usize = 4 << 20;
/// Maximum size of all large bodies that are being received, bytes: a slow sender does not take memory without end.
pub(crate) const BODY_ROOM_BYTES: usize = 64 << 20;
/// The same of one user: a slow sender does not block others.
pub(crate) const BODY_ROOM_OF_USER_BYTES: usize = 16 << 20;
/// Bodies and answers up to this size, bytes, need no room: the number of connections bounds them.
pub(crate) const SMALL_BYTES: usize = 64 << 10;
/// Requests per second of one session, or of one address without a session.
pub(crate) const REQUEST_RATE_PER_S: f64 = 50.0;
/// Maximum burst of requests: opening the panel takes some dozens.
pub(crate) const REQUEST_BURST: f64 = 400.0;
/// Maximum number of sessions and addresses whose rate is remembered.
pub(crate) const MAX_RATES: usize = 2000;

// Answers.

/// Maximum time for reading some of the bytes that are sent.
pub(crate) const READ_TIME: Duration = Duration::from_secs(20);
/// Minimum rate at which a client reads an answer, bytes/s, after an initial [`READ_TIME`].
pub(crate) const READ_RATE_BYTES_PER_S: usize = 64 << 10;
/// Maximum size of all large answers held until they are sent, bytes.
pub(crate) const ANSWER_ROOM_BYTES: usize = 256 << 20;
/// The same of one user: the largest answer fits.
pub(crate) const ANSWER_ROOM_OF_USER_BYTES: usize = 128 << 20;

// Work of handlers. The cycle needs its share of the processor.

/// Number of handlers that read records, jobs and texts at once, and that wait for it.
pub(crate) const READING: Queue = Queue { at_once: 2, waiting: 32 };
/// Number of views drawn at once, and waiting.
pub(crate) const DRAWING: Queue = Queue { at_once: 1, waiting: 8 };
/// Number of files written at once, and waiting: existing files are read first.
pub(crate) const SAVING: Queue = Queue { at_once: 1, waiting: 16 };
/// Number of passwords checked at once, and waiting: one at a time, so that simultaneous guesses are all counted.
pub(crate) const CHECKING: Queue = Queue { at_once: 1, waiting: MAX_CHECKS_OF_NAME * MAX_USERS };
/// Number of backups and restores at once, and waiting.
pub(crate) const BACKING_UP: Queue = Queue { at_once: 1, waiting: 0 };
/// Number of jobs planned in this process at once to be loaded, and waiting.
pub(crate) const LOADING: Queue = Queue { at_once: 1, waiting: 8 };

// Pages: connections over which a page gets the state of the cell and sends commands.

/// Maximum number of pages.
pub(crate) const MAX_PAGES: usize = 64;
/// Maximum number of pages of viewers.
pub(crate) const MAX_VIEWER_PAGES: usize = 32;
/// Maximum number of pages of one user.
pub(crate) const MAX_PAGES_OF_USER: usize = 24;
/// Places reserved for the first page of an operator.
pub(crate) const PAGES_KEPT_FOR_OPERATORS: usize = 8;
/// Maximum size of a message from a page, bytes.
pub(crate) const MAX_MESSAGE_BYTES: usize = 16 << 10;
/// Messages per second of a page.
pub(crate) const MESSAGE_RATE_PER_S: f64 = 100.0;
/// Maximum burst of messages of a page.
pub(crate) const MESSAGE_BURST: f64 = 200.0;
/// Number of bytes of a page that are read at once: a flood of tiny frames gives way to other pages often.
pub(crate) const MESSAGE_READ_BYTES: usize = 4 << 10;
/// Maximum time that a page may take for a message.
pub(crate) const MESSAGE_TIME: Duration = Duration::from_secs(20);
/// Maximum number of messages that wait for a page. A slower page is disconnected and must connect anew.
pub(crate) const MAX_WAITING_MESSAGES: usize = 1024;
/// Number of recent events sent to a new page.
pub(crate) const RECENT_EVENTS: usize = 100;

// Users, logins, sessions.

/// Maximum number of users.
pub(crate) const MAX_USERS: usize = 200;
/// Minimum number of characters of a password.
pub(crate) const MIN_PASSWORD_CHARS: usize = 10;
/// Maximum number of characters of a name or password.
pub(crate) const MAX_NAME_CHARS: usize = 128;
/// Maximum size of the file of users, bytes; larger than [`MAX_USERS`] entries. A restored one may have any size.
pub(crate) const MAX_USERS_FILE_BYTES: u64 = 1 << 20;
/// Maximum length of a name or password at login, bytes.
pub(crate) const MAX_LOGIN_BYTES: usize = 512;
/// Wrong passwords allowed for one name from one address before a wait.
pub(crate) const MAX_WRONG_OF_NAME: u32 = 5;
/// The same for all names from one address. Not counted on this computer: behind a tunnel everybody has its address.
pub(crate) const MAX_WRONG_OF_ADDRESS: u32 = 20;
/// First wait after wrong passwords. Each further one doubles it.
pub(crate) const WRONG_WAIT: Duration = Duration::from_secs(2);
/// Maximum number of doublings of the wait.
pub(crate) const WRONG_DOUBLINGS: u32 = 8;
/// The same on this computer: behind a tunnel everybody has its address.
pub(crate) const WRONG_DOUBLINGS_HERE: u32 = 4;
/// Maximum number of names, addresses and browsers whose wrong passwords are counted.
pub(crate) const MAX_WRONG_KEYS: usize = 2000;
/// Maximum number of passwords of one name that wait for a check: no name blocks another.
pub(crate) const MAX_CHECKS_OF_NAME: usize = 8;
/// Maximum memory of a password hash that is checked, KiB: a restored archive may ask for any.
pub(crate) const MAX_HASH_MEMORY_KIB: u32 = 64 << 10;
/// Maximum number of passes of a password hash that is checked.
pub(crate) const MAX_HASH_PASSES: u32 = 16;
/// Maximum number of sessions. Beyond it the least recently seen session of the user with the most ends.
pub(crate) const MAX_SESSIONS: usize = 500;
/// Maximum number of sessions of one user. Beyond it the least recently seen ends.
pub(crate) const MAX_SESSIONS_OF_USER: usize = 20;
/// A session ends after this time without use.
pub(crate) const SESSION_IDLE: Duration = Duration::from_secs(8 * 3600);
/// Maximum duration of a session.
pub(crate) const SESSION_TIME: Duration = Duration::from_secs(24 * 3600);
/// Maximum number of remembered browsers. The least recently used one is forgotten.
pub(crate) const MAX_BROWSERS: usize = 1000;
/// The same of one user.
pub(crate) const MAX_BROWSERS_OF_USER: usize = 20;

// Plans and drafts, in processes of their own.

/// Maximum memory of a process that plans, bytes.
pub(crate) const PLAN_MEMORY_BYTES: u64 = 2 << 30;
/// Maximum processor time of a process that plans.
pub(crate) const PLAN_PROCESSOR_TIME: Duration = Duration::from_secs(600);
/// Maximum time for a draft, which the user waits for while typing.
pub(crate) const DRAFT_TIME: Duration = Duration::from_secs(20);
/// Maximum time for a plan, a part program, a report or a job to be loaded.
pub(crate) const PLAN_TIME: Duration = Duration::from_secs(300);
/// Maximum time for planning all rows of a schedule in the background: what is done is kept.
pub(crate) const LONG_TIME: Duration = Duration::from_secs(24 * 3600);
/// Maximum processor time of its process: all cores for that time.
pub(crate) const LONG_PROCESSOR_TIME: Duration = Duration::from_secs(64 * 24 * 3600);
/// Maximum size of the answer of such a process, bytes.
pub(crate) const MAX_PLAN_BYTES: usize = 128 << 20;
/// Number of processes of each sort (plans, drafts, loads) at once, and waiting.
pub(crate) const PLANNING: Queue = Queue { at_once: 1, waiting: 8 };
/// Maximum number of questions of one user and sort at a time, over all its pages.
pub(crate) const MAX_PLANS_OF_USER: usize = 2;
/// Maximum length of the identifier of a page in a request, characters.
pub(crate) const MAX_PAGE_CHARS: usize = 64;

// Jobs and other texts.

/// Maximum number of own jobs.
pub(crate) const MAX_JOBS: usize = 2000;
/// Maximum length of the file name of a job, bytes.
pub(crate) const MAX_JOB_NAME_BYTES: usize = 120;
/// Maximum size of the text of a job, bytes: what a request can hold.
pub(crate) const MAX_JOB_BYTES: u64 = MAX_BODY_BYTES as u64;
/// Maximum number of operations in a request.
pub(crate) const MAX_OPERATIONS: usize = 1000;
/// Maximum number of changes of a form in a request; each reads the whole text.
pub(crate) const MAX_FORM_CHANGES: usize = 50;
/// Maximum number of tables of passes in a form, and of other tables; those beyond are changed in the text. Counted
/// apart, many passes hide no fixture or offset behind them.
pub(crate) const MAX_FORM_TABLES: usize = 2000;
/// Maximum length of a part number, characters.
pub(crate) const MAX_PART_CHARS: usize = 120;
/// Maximum number of touched points for the position of the part.
pub(crate) const MAX_PLACE_POINTS: usize = 1000;
/// Maximum number of touches for the position of a tool.
pub(crate) const MAX_TOUCHES: usize = 1000;
/// Maximum number of pixels of a picture of a grid.
pub(crate) const MAX_PICTURE_PX: usize = 1 << 23;

// Schedules.

/// Maximum number of tables of seams.
pub(crate) const MAX_SCHEDULES: usize = 500;
/// Maximum number of rows of a table that a page shows; all are planned, and in the result files.
pub(crate) const MAX_SCHEDULE_ROWS: usize = 5000;
/// Maximum number of parts that a page shows on the machines.
pub(crate) const MAX_SCHEDULE_PARTS: usize = 2000;

/// Maximum number of user frames of a machine.
pub(crate) const MAX_FRAMES: usize = 200;

// Records, audit log, archives.

/// Maximum number of welds listed, the newest.
pub(crate) const MAX_WELDS: u32 = 5000;
/// Maximum number of trace rows sent.
pub(crate) const MAX_TRACE_ROWS: usize = 20_000;
/// Maximum number of trace columns sent.
pub(crate) const MAX_TRACE_COLUMNS: usize = 64;
/// Maximum number of trace values sent, rows times columns.
pub(crate) const MAX_TRACE_VALUES: usize = 400_000;
/// Maximum number of entries of the audit log sent.
pub(crate) const MAX_AUDIT_ENTRIES: u32 = 10_000;
/// Maximum time for reading the library: a search compares its text with every entry.
pub(crate) const SEARCH_TIME: Duration = Duration::from_secs(20);
/// Maximum length of a text that is searched, characters: it is compared with the words of every entry.
pub(crate) const MAX_SEARCH_CHARS: usize = 200;
/// Maximum size of an archive that is restored from a page, bytes.
pub(crate) const MAX_ARCHIVE_BYTES: u64 = 16 << 30;
/// Maximum time that a client may take for a piece of an archive.
pub(crate) const PIECE_TIME: Duration = Duration::from_secs(30);
/// Minimum rate of an archive that is sent or received, bytes/s, after an initial [`PIECE_TIME`]: a trickle holds the
/// only turn for backups no longer.
pub(crate) const ARCHIVE_RATE_BYTES_PER_S: u64 = 64 << 10;
