# Errors of files and of the library.
record-full =
    { $path }: { $why }
       allowed: free disk space, or another data folder; earlier data are kept
    .cause = The disk or the user's quota has no room for the next write, or less than the weld needs.
    .cure = Check with `df -h`; delete old output folders, or give another `--data` folder on a larger disk.
record-disk-full = the disk is full
    .cause = The system reported a full disk or an exhausted quota on a write.
    .cure = Free space on that disk; old traces can be exported and moved away with a backup.
record-no-room = { $free } are free, the record of the weld needs { $needed }
    .cause = A weld needs room for twice its raw trace (rows times bytes of a row) and 64 MiB.
    .cure = Free that much space, or record on another disk with `--data`.
record-read-only =
    { $path }: not writable: { $why }
       allowed: a folder with write permission
    .cause = The file or its folder belongs to another user, is write-protected, or lies on a disk mounted read-only.
    .cure = Check with `ls -l` and `mount`; correct the owner with `chown`, or give another `--data`.
record-not-read =
    { $path }: cannot read: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = The file is missing, was removed meanwhile, or the disk or network share reported a read error.
    .cure = Check the path; look at the system log for errors of the disk.
record-not-written =
    { $path }: cannot write: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = The disk, the network share or the USB medium reported an error other than a full disk.
    .cure = Look at the system log for errors of the disk, and record on another one with `--data`.
record-not-created =
    { $path }: cannot create: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = A folder of the path is missing or is a file, or the disk reported an error.
    .cure = Create the parent folder, or move the file of that name away.
record-not-removed =
    { $path }: cannot remove: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = Another program holds the file, or the disk reported an error; the result beside it is complete.
    .cure = Close programs that read the data folder, then run `seamwright records recover`.
record-not-moved =
    { $path }: cannot move: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = Source and target are on different disks, another program holds the file, or the disk reported an error.
    .cure = Close programs that read the data folder; the move continues when the folder is opened next.
record-not-archived =
    { $path }: cannot add to the archive: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = The file vanished or changed while the backup was written, or it has an unreadable sector.
    .cure = Repeat `seamwright records backup`; if it fails again, check the disk and run `seamwright records verify`.
record-not-unpacked =
    { $path }: cannot unpack the archive: { $why }
       allowed: an existing file or folder, on a working disk
    .cause = The file is not a tar archive, is damaged, or the disk reported an error while unpacking.
    .cure = Copy the archive again from its source, and compare its size and SHA-256.
record-damaged =
    { $path }: { $why }
       allowed: { $allowed }
    .cause = The file exists, but its content fails a check; the reason follows the path.
    .cure = Keep a copy of the file, then do what the second line names.
record-newer =
    { $path }: written by a later version (schema { $found }, this version reads up to { $known })
       allowed: that version of Seamwright; nothing was changed
    .cause = A later version of Seamwright has opened this library for writing and changed its schema.
    .cure = Run that version (`seamwright --version`), or restore a backup made before into another folder.
record-busy =
    { $path }: in use by another program
       allowed: try again after that program has ended
    .cause = Another process holds the library, the journal or a trace; for the library the wait is 5 s.
    .cure = End the other `seamwright run`, panel or `sqlite3` on this data folder; for reading, wait for the weld's end.
record-search-ended =
    { $path }: the search took too long
       allowed: try again with a shorter time range or without a text
    .cause = The panel ends a search in the library after 20 s, and when the page that asked has gone.
    .cure = Give a time range, a part or a procedure; the text is then compared with fewer entries.
record-invalid =
    { $what }
       allowed: { $allowed }
    .cause = The request names something that the data folder does not have, or has an invalid value.
    .cure = Give one of the allowed values of the second line.
record-database = { $path }: { $why }
    .cause = SQLite refused for a reason that is neither space, permission, lock nor damage.
    .cure = Run `seamwright records verify`; if it reports nothing, report the sentence of SQLite.
record-invalid-moment = invalid date: { $text }; allowed: 2026-11-21 or "2026-11-21 14:05", UTC
    .cause = The date is not in the calendar, has another order or separator, or seconds of 60 and more.
    .cure = Write year, month and day with hyphens, the time after a space with colons, in UTC.

# The library.
record-library-damaged = the library is damaged ({ $why })
    .cause = SQLite found a file that is not a database or has broken pages, after a disk fault or a copy without its `-wal` file.
    .cure = Restore the last `seamwright records backup` into an empty folder with `records restore`.
record-library-from-copy = replace it by its last copy, or move it away: a new library is begun, and traces stay as they are
record-library-missing = { $path }: the library is missing
    .cause = The data folder has no `library.sqlite`: another folder was meant, or no weld was recorded there.
    .cure = Check `--data` and the variable `SEAMWRIGHT_DATA`.
record-begin-library = a data folder with recorded welds: simulate JOB -o DIR --data DIR begins one
record-schema-version = its schema has version { $found }, this program reads { $known }
    .cause = An older version wrote this library, and reading alone does not change it.
    .cure = Make a backup, then run `seamwright records recover --data DIR` once.
record-migrate = any command that writes to it brings it up to date: records recover
record-no-library = not a library of Seamwright
    .cause = The file `library.sqlite` is an SQLite database of another program, or the archive contains such a file.
    .cure = Correct `--data`, or the name of the archive.
record-other-folder = another data folder
record-own-archive = an archive of `records backup`
record-own-schema = an archive of a library that only Seamwright has changed; remove the foreign part with sqlite3 first
record-schema-foreign = the library has a foreign { $kind } `{ $name }`
    .cause = Somebody added a table, view, index or trigger to the library with another program.
    .cure = Remove it with `sqlite3 library.sqlite "DROP ..."`, after a copy of the file.
record-schema-changed = the library's { $kind } `{ $name }` was changed
    .cause = The definition of this table, view, index or trigger differs from that of the library's version.
    .cure = Restore the last good backup; records since then are no longer protected as written.
record-schema-missing = the library's { $kind } `{ $name }` is missing
    .cause = A table, view, index or trigger of the library's version was deleted with another program.
    .cure = Restore the last good backup; a missing trigger means that the audit log was changeable.
record-loose-row = a row of table { $table } refers to a missing row
    .cause = The row that this one refers to, for example its weld or document, was deleted with another program or lost by damage.
    .cure = Restore the last good backup, or keep the library as evidence and begin a new data folder.
record-no-document = document { $id } does not exist
    .cause = No document of the library has this number.
    .cure = Take the number of the job, program, machine or procedure from `seamwright records show ID --json`.
record-no-alarm = alarm { $id } does not exist
    .cause = No alarm of the library has this number; the list of the panel is older than the library, for example after a restore.
    .cure = Load the page of the panel again.
record-known-number = a number in the library
record-no-weld = { $path }: weld { $id } does not exist
    .cause = No weld of this data folder has the number.
    .cure = Run `seamwright records list --data DIR` for the numbers, and check `--data`.
record-no-welds-yet = nothing yet: no weld is recorded
record-weld-damaged = weld { $id }: { $why }
    .cause = The planned values that the library keeps for the figures of this weld are not readable.
    .cure = Restore the last good backup; the trace of the weld itself is not affected.
record-whole-library = an undamaged library
record-foreign-file = it names `{ $name }` for weld { $id }, which is not a file of that weld
    .cause = The library's list of files has a name with a slash or dots, so it was changed with another program.
    .cure = Do not export this weld; restore the last good backup.
record-own-files = file names in the weld's folder
record-finite-numbers = finite numbers

# Traces.
record-no-trace = not a trace: { $why }
    .cause = The Parquet file is damaged, cut off, or of another kind.
    .cure = Restore the trace from a backup; `seamwright records verify` names other changed files.
record-own-parquet = a Parquet file written by Seamwright
record-own-trace = a trace written by Seamwright
record-column-kind = column { $column } holds { $kind }
    .cause = A column has a type that traces do not use; they have 64 and 32 bit floats and unsigned integers of 8 and 32 bits.
    .cure = Use the original file; another program has written this one.
record-trace-groups = row groups of more than { $max } rows, or columns of different or negative lengths
    .cause = The numbers of rows in the file contradict each other, or another program has written it.
    .cure = Use the original file, or restore it from a backup.
record-no-column = { $path }: column { $column } does not exist
    .cause = The trace has no column of this name; columns depend on the machine's axes and the job's process values.
    .cure = Choose one of the allowed names; `docs/reference/traces.md` explains them.
record-row-length =
    { $path }: a row of { $n ->
        [one] { $n } value
       *[other] { $n } values
    }
    .cause = The program wrote a row whose number of values differs from the header of the trace.
    .cure = Report it as a fault of the program, with the job.
record-value-per-column = { $n }, one per column
record-trace-left = a crash left this trace here, or it is being written
    .cause = The weld's folder already contains `trace.raw`: of a crash, or of a process that still runs.
    .cure = Look for a running `seamwright run` or panel first, then run `seamwright records recover --data DIR`.
record-recover-first = recover it first: seamwright records recover
record-trace-replaced = removed or replaced while it was written: its rows are lost
    .cause = Somebody removed, moved or replaced `trace.raw` while the weld ran, for example a cleaning script.
    .cure = Exclude the data folder from scripts and synchronisation; the weld continues with alarm 23.
record-folder-untouched = leave the folder unchanged until the weld has ended
record-no-raw-trace = not a raw trace, or cut off in its header
    .cause = The file `trace.raw` has no valid header, because the power failed at its creation or it was changed.
    .cure = Run `seamwright records recover --data DIR`, which sets the file aside as `trace.raw.damaged`.
record-own-raw-trace = a file begun by a trace

# Backup and restore.
record-folder-not-empty = { $path }: the folder is not empty
    .cause = `records restore` unpacks into a missing or empty folder only, so that it never overwrites data.
    .cure = Give a new folder with `--data`.
record-empty-folder = an empty or new folder
record-archive-as-written = an unchanged archive
record-manifest-missing = { $name }: missing, although the version that wrote the archive writes it
    .cause = The archive lacks `manifest.sha256`, the list of hashes that its version writes as last file.
    .cure = Use an untouched copy of the archive; it was repacked or changed.
record-manifest-size = { $name }: { $size }, too large
    .cause = The list of hashes in the archive is larger than 64 MiB, enough for half a million files.
    .cure = Use an untouched copy of the archive.
record-archive-changed = { $name }: changed, missing or added since the backup
    .cause = A file differs from its SHA-256 in `manifest.sha256`, is missing in the archive, or is not in that list.
    .cure = Copy the archive again from its source, or use an earlier backup.
record-archive-without-hashes = the archive has no list of hashes and is not in order: { $problem }
    .cause = The archive is of schema 1 or 2; instead of hashes its own library was checked, with this fault.
    .cure = Use an earlier backup of that version.
record-archive-problems =
    the contents are not in order: { $problem } ({ $more ->
        [0] no other problems
        [one] and { $more } more problem
       *[other] and { $more } more problems
    })
    .cause = The panel restores only data that pass `records verify`; the first problem is named.
    .cure = Restore it into a new folder on the command line and look at all problems with `seamwright records verify`.
record-restore-elsewhere = `seamwright records restore` restores it into a folder of its own
record-nothing-restored = nothing was restored
    .cause = The checked archive vanished from the data folder between check and replacement.
    .cure = Send the archive in the panel again and check it.
record-checked-archive = a checked archive
record-archive-foreign = it contains { $name }, which is foreign to a backup
    .cause = The archive has an entry that no backup writes, or a link or device.
    .cure = Use an archive of `seamwright records backup` or of the panel, not one made with `tar`.
record-archive-outside = { $name } leads out of the archive
    .cause = The name of an entry has `..` or an absolute path; such an archive could overwrite other files.
    .cure = Do not use this archive; find out its origin.
record-archive-entries = more than { $max } files and folders
    .cause = A backup is limited to half a million files, about a hundred thousand welds, so that a restore can check them in memory.
    .cure = Move folders of old welds to another data folder; an archive that is not your own may be an attack.
record-archive-fewer = a data folder with fewer files
record-archive-name = a name or an addition to a name is longer than { $max } KiB
    .cause = The headers of an entry are longer than in any backup; reading them could take all memory.
    .cure = Do not use this archive; find out its origin.
record-archive-cut-off = the end of the archive is missing
    .cause = The 1024 zero bytes at the end of every tar archive are missing: a copy or download was interrupted.
    .cure = Copy or download the archive again.
record-archive-no-library = the archive has no library
    .cause = The archive has no `library.sqlite`, so it is not a complete backup.
    .cure = Use an archive of `seamwright records backup` or of the panel.

# Problems found by `records verify`.
record-problem-audit = audit log, entry { $id }: { $why }
    .cause = The chain of hashes of the audit log breaks at this entry: it was changed with another program, or damaged.
    .cure = Keep the file as evidence, find out who had access, and restore the last good backup.
record-audit-missing = the entry is missing
    .cause = The numbers of the entries have a gap here; the program never deletes entries.
    .cure = Compare with the last backup, which still has the entry.
record-audit-hash = the hash does not match the entry or the one before it
    .cause = The entry's text, user, time or number differs from that at the time of writing.
    .cure = Compare with the last backup, which still has the original entry.
record-audit-cut-off = this entry and all after it are missing
    .cause = SQLite counted more entries than the table has; the newest ones were deleted or lost by damage to the write-ahead log.
    .cure = Compare with the last backup, and with hashes noted elsewhere.
record-problem-lost = weld { $id }: the library lost its entry; its files are in { $folder }
    .cause = The library lost its newest entries, usually by damage to its write-ahead log; the weld's files are untouched.
    .cure = Keep the folder; restore the library from a backup that has this weld, into another folder.
record-problem-unfinished = weld { $id }: its trace is being written
    .cause = A process holds the trace: the weld runs now, or a panel or `run` is still closing it.
    .cure = Verify again after the end of the weld.
record-problem-left = weld { $id }: a crash left its trace unfinished; run `records recover`
    .cause = The program or the power failed during the weld; its raw trace was not closed and no process holds it now.
    .cure = Run `seamwright records recover` with the data folder while no weld runs.
record-problem-program = weld { $id }: the text of its program was changed
    .cause = The stored text of the program differs from its SHA-256, so it was changed with another program or damaged.
    .cure = Restore the last good backup; do not use this text as proof.
record-problem-changed = { $path }: changed since it was recorded
    .cause = The SHA-256 of the file differs from that in the library.
    .cure = Restore the file from a backup; do not use the changed one as proof.

# Notes of a weld.
record-notes = { $first }; { $then }
    .cause = Several things happened to the record of one weld; each part is explained under its own code.
record-interrupted = interrupted: { $cause }
    .cause = The process that welded and wrote the record ended without closing it, for the reason given. The record has the rows up to that moment.
    .cure = Look at the seam where the record ends before the weld is continued.
record-log-damaged = a line of the log of this weld is damaged
    .cause = An event, an alarm or the end of a pass could not be written, or was changed since.
    .cure = Look at the trace for what happened; check the disk of the data folder.
record-rows-late = the disk was too slow
    .cause = Rows of the trace came faster than the disk took them, and more waited than memory is kept for.
    .cure = Check the disk of the data folder: its health, and other programs that write to it.
record-rows-lost =
    { $n ->
        [one] { $n } row
       *[other] { $n } rows
    } of the trace lost: { $why }
    .cause = The disk was full or failed during the weld; the weld went on and rows were counted only.
    .cure = Free space or replace the disk; the trace has a gap in `t_s` there.
record-incomplete = the record is incomplete: { $why }
    .cause = A file of the weld was not written at its end, for the reason given.
    .cure = Correct the reason, then run `seamwright records recover --data DIR`.
record-no-figures = no figures: { $why }
    .cause = The trace or the planned values of this weld are unreadable, so heat input and deviations were not calculated.
    .cure = Run `seamwright records verify --data DIR` and restore the named files from a backup.
record-heat-input-outside = heat input outside the procedure over { $length }
    .cause = Some 2 mm of the travel have a heat input outside of `heat_input_kj_mm` of the procedure, although the weld was completed.
    .cure = Inspect that length by the rules of the procedure; check speed, current, voltage and wire feed there in the report.
record-recovered = recovered { $time }
    .cause = A crash or power failure left the trace open; `records recover` or the start of the panel closed it completely.
record-recovered-without = recovered { $time } without the last { $size } of the trace, which are not complete rows
    .cause = The power failed within a write; the incomplete block at the end of the trace is lost.
    .cure = Compare the end of the record with the journal's position before continuing the weld.
