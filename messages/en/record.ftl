# Errors of files and of the library.
record-full =
    { $path }: { $why }
       allowed: free disk space, or another data folder; earlier data are kept
record-disk-full = the disk is full
record-no-room = { $free } are free, the record of the weld needs { $needed }
record-read-only =
    { $path }: not writable: { $why }
       allowed: a folder with write permission
record-not-read =
    { $path }: cannot read: { $why }
       allowed: an existing file or folder, on a working disk
record-not-written =
    { $path }: cannot write: { $why }
       allowed: an existing file or folder, on a working disk
record-not-created =
    { $path }: cannot create: { $why }
       allowed: an existing file or folder, on a working disk
record-not-removed =
    { $path }: cannot remove: { $why }
       allowed: an existing file or folder, on a working disk
record-not-moved =
    { $path }: cannot move: { $why }
       allowed: an existing file or folder, on a working disk
record-not-archived =
    { $path }: cannot add to the archive: { $why }
       allowed: an existing file or folder, on a working disk
record-not-unpacked =
    { $path }: cannot unpack the archive: { $why }
       allowed: an existing file or folder, on a working disk
record-damaged =
    { $path }: { $why }
       allowed: { $allowed }
record-newer =
    { $path }: written by a later version (schema { $found }, this version reads up to { $known })
       allowed: that version of Seamwright; nothing was changed
record-busy =
    { $path }: in use by another program
       allowed: try again after that program has ended
record-invalid =
    { $what }
       allowed: { $allowed }
record-database = { $path }: { $why }
record-invalid-moment = invalid date: { $text }; allowed: 2026-11-21 or "2026-11-21 14:05", UTC

# The library.
record-library-damaged = the library is damaged ({ $why })
record-library-from-copy = replace it by its last copy, or move it away: a new library is begun, and traces stay as they are
record-library-missing = { $path }: the library is missing
record-begin-library = a data folder with recorded welds: simulate JOB -o DIR --data DIR begins one
record-schema-version = its schema has version { $found }, this program reads { $known }
record-migrate = any command that writes to it brings it up to date: records recover
record-no-library = not a library of Seamwright
record-other-folder = another data folder
record-own-archive = an archive of `records backup`
record-own-schema = an archive of a library that only Seamwright has changed; remove the foreign part with sqlite3 first
record-schema-foreign = the library has a foreign { $kind } `{ $name }`
record-schema-changed = the library's { $kind } `{ $name }` was changed
record-schema-missing = the library's { $kind } `{ $name }` is missing
record-loose-row = a row of table { $table } refers to a missing row
record-no-document = document { $id } does not exist
record-no-alarm = alarm { $id } does not exist
record-known-number = a number in the library
record-no-weld = { $path }: weld { $id } does not exist
record-no-welds-yet = nothing yet: no weld is recorded
record-weld-damaged = weld { $id }: { $why }
record-whole-library = an undamaged library
record-foreign-file = it names `{ $name }` for weld { $id }, which is not a file of that weld
record-own-files = file names in the weld's folder
record-finite-numbers = finite numbers

# Traces.
record-no-trace = not a trace: { $why }
record-own-parquet = a Parquet file written by Seamwright
record-own-trace = a trace written by Seamwright
record-column-kind = column { $column } holds { $kind }
record-no-column = { $path }: column { $column } does not exist
record-row-length =
    { $path }: a row of { $n ->
        [one] { $n } value
       *[other] { $n } values
    }
record-value-per-column = { $n }, one per column
record-incomplete-rows = { $size } at its end are not complete rows
record-recover-whole-rows = seamwright records recover, which keeps the complete rows
record-trace-left = a crash left this trace here, or it is being written
record-recover-first = recover it first: seamwright records recover
record-trace-replaced = removed or replaced while it was written: its rows are lost
record-folder-untouched = leave the folder unchanged until the weld has ended
record-no-raw-trace = not a raw trace, or cut off in its header
record-own-raw-trace = a file begun by a trace

# Backup and restore.
record-folder-not-empty = { $path }: the folder is not empty
record-empty-folder = an empty or new folder
record-archive-as-written = an unchanged archive
record-manifest-missing = { $name }: missing, although the version that wrote the archive writes it
record-manifest-size = { $name }: { $size }, too large
record-archive-changed = { $name }: changed, missing or added since the backup
record-archive-without-hashes = the archive has no list of hashes and is not in order: { $problem }
record-archive-problems =
    the contents are not in order: { $problem } ({ $more ->
        [0] no other problems
        [one] and { $more } more problem
       *[other] and { $more } more problems
    })
record-restore-elsewhere = `seamwright records restore` restores it into a folder of its own
record-nothing-restored = nothing was restored
record-checked-archive = a checked archive
record-archive-foreign = it contains { $name }, which is foreign to a backup
record-archive-outside = { $name } leads out of the archive
record-archive-cut-off = the end of the archive is missing
record-archive-no-library = the archive has no library

# Problems found by `records verify`.
record-problem-audit = audit log, entry { $id }: { $why }
record-audit-missing = the entry is missing
record-audit-hash = the hash does not match the entry or the one before it
record-audit-cut-off = this entry and all after it are missing
record-problem-lost = weld { $id }: the library lost its entry; its files are in { $folder }
record-problem-unfinished = weld { $id }: its trace is being written
record-problem-left = weld { $id }: a crash left its trace unfinished; run `records recover`
record-problem-program = weld { $id }: the text of its program was changed
record-problem-changed = { $path }: changed since it was recorded

# Notes of a weld.
record-notes = { $first }; { $then }
record-rows-lost =
    { $n ->
        [one] { $n } row
       *[other] { $n } rows
    } of the trace lost: { $why }
record-incomplete = the record is incomplete: { $why }
record-no-figures = no figures: { $why }
record-heat-input-outside = heat input outside the procedure over { $length }
record-recovered = recovered { $time }
record-recovered-without = recovered { $time } without the last { $size } of the trace, which are not complete rows
