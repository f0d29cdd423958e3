//! The tables, version by version. A library is brought up to date when it is opened to be written.

/// Value of `PRAGMA application_id` in our files: "SWLb".
pub(super) const APPLICATION: i64 = 0x5357_4c62;

/// Steps from each schema version to the next; the first makes an empty file version 1.
pub(super) const MIGRATIONS: [&str; 4] = [FIRST, LISTED, WITH_MANIFEST, PRIORITY];

/// Programs of this version on write archives with the hashes of all files: see [`super::Library::has_manifests`]. Tables stay.
const WITH_MANIFEST: &str = "";

/// The version to which [`WITH_MANIFEST`] leads.
pub(super) const MANIFEST_VERSION: i64 = 3;

/// Priority of an alarm at the time when it was raised; empty before this version.
const PRIORITY: &str = "
ALTER TABLE alarm ADD COLUMN priority TEXT NOT NULL DEFAULT '' CHECK (priority IN ('', 'critical', 'high', 'medium', 'low'));
";

const LISTED: &str = "
-- On the panel's list until somebody acknowledges it.
ALTER TABLE alarm ADD COLUMN listed INTEGER NOT NULL DEFAULT 0 CHECK (listed IN (0, 1));
CREATE INDEX alarm_listed ON alarm (id) WHERE listed = 1;
";

const FIRST: &str = "
-- Texts that welds are made from, each version kept as it was. Times are ms since 1970 UTC.
CREATE TABLE document (
    id INTEGER PRIMARY KEY,
    kind TEXT NOT NULL CHECK (kind IN ('job', 'program', 'machine', 'procedure')),
    name TEXT NOT NULL,
    version INTEGER NOT NULL,
    sha256 TEXT NOT NULL,
    text TEXT NOT NULL,
    added INTEGER NOT NULL,
    UNIQUE (kind, name, version),
    UNIQUE (kind, name, sha256)
) STRICT;

CREATE TABLE welder (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL UNIQUE
) STRICT;

CREATE TABLE weld (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    part TEXT NOT NULL,
    title TEXT NOT NULL,
    simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
    job INTEGER REFERENCES document (id),
    program INTEGER NOT NULL REFERENCES document (id),
    machine INTEGER NOT NULL REFERENCES document (id),
    procedure INTEGER REFERENCES document (id),
    welder INTEGER REFERENCES welder (id),
    begun INTEGER NOT NULL,
    ended INTEGER,
    result TEXT NOT NULL CHECK (result IN ('running', 'good', 'deviating', 'stopped', 'interrupted')),
    note TEXT NOT NULL DEFAULT '',
    heat_input_min_kj_mm REAL,
    heat_input_mean_kj_mm REAL,
    heat_input_max_kj_mm REAL,
    worst_deviation_mm REAL,
    worst_deviation_at_mm REAL,
    basis TEXT NOT NULL
) STRICT;
CREATE INDEX weld_part ON weld (part);
CREATE INDEX weld_begun ON weld (begun);

-- Files of a weld, in welds/<id>/ beside the library.
CREATE TABLE weld_file (
    weld INTEGER NOT NULL REFERENCES weld (id),
    name TEXT NOT NULL,
    sha256 TEXT NOT NULL,
    bytes INTEGER NOT NULL,
    rows INTEGER,
    PRIMARY KEY (weld, name)
) STRICT;

-- Values while the arc was on, against the window of the procedure where it has one.
CREATE TABLE weld_value (
    weld INTEGER NOT NULL REFERENCES weld (id),
    pass INTEGER NOT NULL,
    name TEXT NOT NULL,
    least REAL NOT NULL,
    mean REAL NOT NULL,
    greatest REAL NOT NULL,
    allowed_least REAL,
    allowed_greatest REAL,
    outside_s REAL NOT NULL,
    outside_mm REAL NOT NULL,
    PRIMARY KEY (weld, pass, name)
) STRICT;

CREATE TABLE alarm (
    id INTEGER PRIMARY KEY,
    weld INTEGER REFERENCES weld (id),
    name TEXT NOT NULL,
    cause TEXT NOT NULL,
    pass INTEGER,
    s_mm REAL,
    t_s REAL,
    raised INTEGER NOT NULL,
    first_out INTEGER NOT NULL CHECK (first_out IN (0, 1)),
    acknowledged_by TEXT,
    acknowledged INTEGER
) STRICT;
CREATE INDEX alarm_weld ON alarm (weld);

CREATE TABLE event (
    id INTEGER PRIMARY KEY,
    weld INTEGER REFERENCES weld (id),
    at INTEGER NOT NULL,
    text TEXT NOT NULL,
    pass INTEGER,
    s_mm REAL,
    t_s REAL
) STRICT;
CREATE INDEX event_weld ON event (weld);

-- Append-only: each entry's hash covers its fields and the hash before.
CREATE TABLE audit (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    at INTEGER NOT NULL,
    user TEXT NOT NULL,
    station TEXT NOT NULL,
    command TEXT NOT NULL,
    old TEXT NOT NULL,
    new TEXT NOT NULL,
    result TEXT NOT NULL,
    hash TEXT NOT NULL
) STRICT;
CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_is_not_deleted BEFORE DELETE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER document_is_not_changed BEFORE UPDATE ON document
BEGIN SELECT RAISE(ABORT, 'a version of a document is not changed'); END;
";
