# Findings at the command line.
project-weld-possible = the weld can be made as asked
project-weld-possible-with-remarks = the weld can be made, with remarks
    .cause = Some findings are warnings or notes, such as a lower speed permitted by `on_limit = "slow"`.
    .cure = Read each finding; those with a cure are warnings.
project-weld-impossible = the weld cannot be made as asked: { $findings ->
        [one] { $findings } finding
       *[other] { $findings } findings
    }
    .cause = At least one finding prevents the weld: a limit of an axis, the tip or the procedure, a clearance, or a search without result.
    .cure = Follow the cure below each finding; `seamwright check JOB --json` lists all of them with pass and position.
project-finding = { $severity } ({ $kind }): { $finding }
project-severity-error = finding
project-severity-warning = warning
project-severity-note = note
project-where = where: { $places }
project-cure = cure: { $cure }
project-pass = pass { $pass }
project-passes = passes { $first } to { $last }
project-place = { $passes }, s = { $s }
project-place-range = { $passes }, s = { $from } to { $to }
project-places = { $first }; { $then }
project-more-places = { $places ->
        [one] { $places } more place
       *[other] { $places } more places
    }

project-angles-of-another-plan = the torch angles belong to another plan
    .cause = A plan brings the torch angles of its own search along, and the job's passes ask for others.
    .cure = Plan the job again.
project-long-stick-out = the torch is clear only with a stick-out of { $found }: beyond { $usual } the current falls at the same wire feed, and the shielding gas thins
    .cause = The job lets the search of torch angles lengthen the stick-out, and no procedure says how far it may.
    .cure = Use a torch that fits the groove better, or a procedure whose window `stick_out_mm` covers it.
project-cure-long-stick-out = use a torch that fits the groove better, or a procedure whose stick_out_mm covers it

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
    .cause = The first line gives the fault, the second one the allowed values.
    .cure = Choose an allowed value.
project-with-hint =
    { $message }
    { "   " }{ $hint }
    .cause = The first line gives the fault, the second one a suggestion.
    .cure = Follow the suggestion.
project-or = { $first } or { $second }
project-note = note: { $note }
project-planning-cancelled = planning was cancelled
    .cause = A signal (Ctrl+C), the panel or a newer request ended the planning.
    .cure = Start the command again; `--time-limit S` limits the searches of planning instead.
project-failed = it failed
    .cause = The command has printed its findings, or the reader of its output has closed the pipe.
    .cure = Read the lines printed before this one; write large tables to a file instead of a pipe.
project-standard-input = standard input: { $why }
    .cause = The bytes on standard input are not UTF-8 text, for example a binary file or a spreadsheet.
    .cure = Export the table as CSV in UTF-8 and redirect it again.
project-in-machine-file = machine file: { $why }
    .cause = The drives in the machine file are invalid, for the reason that follows.
    .cure = Correct `[drives.AXIS]`; `seamwright machine check MACHINE` tests the whole file.
project-in-file = { $file }: { $why }
    .cause = The content of the file is invalid, for the reason that follows.
    .cure = Correct the file as the reason and the allowed values name it.
project-document-fault = { $file }:{ $line }: { $key }: { $message }
    .cause = The value of this key in this line is invalid, for the reason that follows.
    .cure = Correct the line; the reference of the file format explains the key.

# Files.
project-unreadable = { $file }: cannot be read: { $why }
    .cause = The file is missing, its permissions exclude you, or it is not UTF-8 text.
    .cure = Check path and permissions with `ls -l`; save text files as UTF-8.
project-not-writable = { $file }: cannot be written: { $why }
    .cause = The folder of the output is missing or read-only, a file has the name of the folder, or the disk fails.
    .cure = Choose another `-o`, create the folder, correct its permissions, or check the disk with `df`.
project-writable = a folder or file that you may write
project-no-such-folder = there is no such folder
    .cause = An output file needs an existing folder; only output folders of whole plans are created.
    .cure = Create the folder with `mkdir -p`, or correct the path after `-o`.
project-permission-denied = permission denied
    .cause = The user who runs the program has no write permission for the file or its folder.
    .cure = Choose a folder of your own, or change the owner or mode with `chown` or `chmod`.
project-not-a-folder = it is not a folder
    .cause = A part of the path is a file although a folder is needed there.
    .cure = Choose another `-o`, or move that file away.
project-is-a-folder = it is a folder
    .cause = The name of the output file is that of an existing folder.
    .cure = Add a file name to the path after the option.
project-file-too-large = { $file }: the file is too large
    .cause = Files and standard input of this command are read into memory, up to 1 GiB.
    .cure = Split the file, or take a smaller or compressed image.
project-up-to-1-gib = up to 1 GiB
project-other-file-there = { $file }: another file stands where the copy of { $from } should go
    .cause = The plan copies machine and STL files into its output folder; a file of that name with other content exists there.
    .cure = Choose a new folder with `-o`, or move the old file away.
project-other-folder = another output folder
project-files-written = { $files ->
        [one] { $files } file
       *[other] { $files } files
    } to { $folder }: { $names }
project-files-written-more = { $files ->
        [one] { $files } file
       *[other] { $files } files
    } to { $folder }: { $names } and { $more } more
project-file-outside = the name leads outside of the folder of the jobs
    .cause = A job or machine file in the panel's folder of jobs names a file with `..` or an absolute path.
    .cure = Copy the file into the folder of jobs and name it relative to the file that uses it.
project-link-outside = a link leads outside of the folder of the jobs
    .cause = The named file is a symbolic link to a place outside of the panel's folder of jobs.
    .cure = Replace the link by a copy of the file.
project-not-a-plain-file = it is not a plain file
    .cause = The name in the job or machine file is that of a folder, pipe or device.
    .cure = Name a regular file.
project-file-above = it is larger than { $max }
    .cause = Jobs and users of the panel, and files that a job or machine file of the panel names, such as STL and CSV, have this maximum size.
    .cure = Reduce the number of triangles or points, or plan with `seamwright plan` on the command line, without this limit.

# Tables.
project-csv-value = { $file }:{ $line }: { $column } = `{ $value }`: { $fault }
    .cause = The value in this column is not a number, is empty, or is outside the range of the column.
    .cure = Correct the cell in this line; use a dot as decimal separator and commas between columns.
project-not-a-finite-number = not a finite number
    .cause = The cell is empty, a text, `nan` or infinite, or has a decimal comma.
    .cure = Write a number with a decimal dot, such as 12.5, into the cell.
project-no-column = { $file }:1: there is no column `{ $column }` in `{ $header }`
    .cause = The header line has no such column, often because columns are separated by semicolons or tabs, or the header is missing.
    .cure = Name the columns exactly as listed, with units, separated by commas; the order is free.
project-header-line = a header line with { $columns }, then numbers
project-header-line-with-commas = a header line with { $columns }, then numbers, separated by commas
project-table-too-long = { $file }: the table is too long
    .cause = A table of points that a job names has more than 20,000 rows below its header.
    .cure = Thin the points, for example with `seamwright tools reduce`, or split the seam into several jobs.
project-up-to-points = up to { $max } points
project-file-from-job = a file that is there, its path seen from the job's folder

# Jobs and machines.
project-no-such-file = { $file }: there is no such file
    .cause = Neither a file nor an example has this name; the path starts at the current folder.
    .cure = Correct the path, or run `seamwright examples` for the names of the examples.
project-copy-example = there is an example `{ $name }`; to copy it: seamwright examples { $name } > { $name }.toml
project-job-or-example = a job or program file, or the name of an example: { $names }
project-program-without-seam = the program has no seam
    .cause = The passes of the program go through points only; this command needs the geometry of a seam.
    .cure = Use the job from which the program was made, or keep its `[seam]` in the program.
project-job-or-seam = a job, or a program with [seam]
project-no-machine = there is no machine `{ $name }`
    .cause = The key `machine` names neither a supplied machine nor a file seen from the job's folder.
    .cure = Correct `machine` in the job; `seamwright machine list` prints the supplied names.
project-shipped-machine-or-file = a machine that ships, or the path of a machine file
project-no-machine-or-file = there is no such machine, and no file { $file }
    .cause = The key `machine` is not the name of a supplied machine, and no file has this path, seen from the job's folder.
    .cure = Correct `machine` in the job, or put the machine file there; `seamwright machine list` prints the supplied names.
project-no-such-machine = { $name }: there is no such machine, and no such file
    .cause = The command line names neither a supplied machine nor an existing file, seen from the current folder.
    .cure = Run `seamwright machine list`, or give the path of the machine file with its ending.
project-machine-names = { $names }, or the path of a machine file
project-machine-refused = machine `{ $name }`: { $why }
    .cause = The machine file of a job in the panel lies outside of the folder of jobs, or is not a regular file below 64 MiB.
    .cure = Copy the machine file into the folder of jobs, for example to `machines/`, and name it in `machine`.
project-machine-among-jobs = the name of a machine that ships, or a machine file among the jobs
project-machine-without-file = machine `{ $name }` has no file
    .cause = Calibration and tuning are stored in a machine file; this machine has none and is not a supplied one.
    .cure = Save its description as `machines/NAME.toml` in the folder of jobs and name it in `machine`.
project-not-a-table = `{ $table }` is not a table
    .cause = The key exists in the file with another type, for example a number, an array or a missing entry of an array of tables.
    .cure = Open the file and write the key as a table, such as `[drives.AXIS]` or `[offsets.NAME]`.
project-process-value-is-axis = process value `{ $name }` has the name of an axis of the machine
    .cause = Columns of set-points and traces are named after axes and process values; two with one name would be ambiguous.
    .cure = Rename the process value in the job's `process` tables, for example by adding its unit.
project-one-head = { $machine } has one head: it cannot weld both fillets at once
    .cause = The job has `fillet = "both"` in `[seam.t_joint]`; the machine file has a single `[torch]` or head.
    .cure = Set `fillet` to `left` or `right`, or choose a machine with two `[[heads]]`.
project-no-recording-machine = there is no machine `{ $name }` that could have recorded them
    .cause = A `[[taught]]` table gives positions of axes; they become points by the kinematics of the job's `machine`, which was not found.
    .cure = Correct `machine` in the job, or put the machine file of the recording beside it.
project-machine-as-recorded = `machine` as it was when they were recorded
project-positions-for-axes = { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }, and { $machine } has { $axes ->
        [one] { $axes } axis
       *[other] { $axes } axes
    }
    .cause = A row of `axes` in `[[taught]]` has more or fewer numbers than the machine has axes.
    .cure = Give one number for each axis in the order of the machine file: tool, heads, work.
project-within-axis-ranges = positions within the axes' ranges
project-option-tolerance = --tolerance-mm { $value }: { $why }
    .cause = Blocks within this tolerance would be shorter than the control can take.
    .cure = Give `--tolerance-mm` a larger value.

# Planning.
project-part-not-checked = no part is described: collisions are checked against the machine and the fixtures only
    .cause = `[part]` has `watched = false`, or the program has no seam and no `[[part.solids]]`, so no solid of the part exists.
    .cure = Remove `watched = false`; until then watch the torch near the part in a dry run.
project-cure-describe-part = describe the part with [[part.solids]], or with the [seam] that it is made from
project-part-replaced = the part made from the seam is replaced: collisions are checked against the solids of [part] only
    .cause = `[part]` has `replace = true`, so only its solids are checked; no part is made from the seam.
    .cure = Remove `replace` if the solids do not cover the whole part.
project-period-too-long = a period of { $period } is longer than the travel of pass { $pass }
    .cause = One set-point period is longer than the whole travel of this pass, so no set-point would lie within it.
    .cure = Lower `--period-ms` or `servo_period_ms` in the machine file, or lower `speed_mm_s`.
project-period-within-travel = up to { $max }, the time of the travel
project-too-many-set-points = the motion takes { $time }, { $set-points } set-points of { $period }
    .cause = The motion would have more than 1,000,000,000 set-points; usually a speed or a period is wrong by powers of ten.
    .cure = Check `speed_mm_s` in the job, dwell times in `[sequence]`, and `--period-ms` or `servo_period_ms`.
project-up-to-set-points = up to { $max } set-points; a higher speed, shorter times or a longer period
project-tracking-with-devices = passes are tracked with simulated sensors, but the machine file has devices of its own
    .cause = `--distortion` makes a simulated part that simulated sensors track; real devices would not see that part.
    .cure = Remove `[devices]` from a copy of the machine file, or add `--no-tracking`.
project-no-devices-or-tracking = a machine file without [devices], or no tracking

# Devices.
project-register-too-small = pass { $pass } asks for { $value } of `{ $name }`, which its register ({ $register }) of device `{ $device }` cannot hold
    .cause = A process value of the pass, with its slopes and weave sides, exceeds the range of the register's `type`, `scale` and `offset`.
    .cure = Correct the value in the job, or change `scale` or `type` in `[devices.NAME.modbus.set]`.
project-register-range = { $min } to { $max }, or another scale or type in the machine file
project-register-or-no-value = a register `{ $value }` in [devices.{ $device }.modbus.set] of the machine file, or a job without it
project-check-modbus = check cable, address, unit and registers; `seamwright machine io MACHINE` reads them one by one
project-check-robot = check the cable, the addresses on both sides, and that the program of `seamwright machine robot-program { $protocol }` runs on the control
project-period-of-no-cell = machine `{ $machine }`: no cell runs with a servo_period_ms of { $period }
    .cause = The key `servo_period_ms` of the machine file is outside 0.25 to 4 ms, the periods of a cell in real time.
    .cure = Set it to 1 and measure this computer with `seamwright machine latency`.
project-periods = { $min } to { $max }, 1 ms if missing; `seamwright machine latency` measures what this computer can do
project-linuxcnc-needs-linux = drives by LinuxCNC are only on Linux
    .cause = The machine file has `[devices.NAME.linuxcnc]`; HAL needs LinuxCNC on a Linux computer.
    .cure = Run the cell on the LinuxCNC computer, or remove that table to simulate the drives.
project-simulated = simulated: { $devices }
    .cause = The machine file describes some real devices in `[devices]`; those named here have no entry.
    .cure = Add them to `[devices.NAME]` before welding metal; for a trial nothing is needed.
project-drives = drives
project-process-source = process source
project-inputs = inputs
project-pulses-end = { $file }: { $why }: the pulses end here
    .cause = The disk is full, or the program that reads the named pipe has ended; the drives then report a fault.
    .cure = Free disk space or start the reader again, then reset the fault and find references again.

# Welds that were interrupted.
project-journal-damaged = { $folder }: both files of the journal of positions are damaged: a weld may have been interrupted at an unknown position
    .cause = Both files of the journal in the data folder fail their checksums, usually after a disk fault or a foreign change.
    .cure = Measure on the part up to which point the bead reaches, and check the disk.
project-look-and-choose = look at the part, then --from PASS,MM to continue there, or --from 1,0 to weld anew
project-weld-left = weld { $weld } was left by a failure of power or program: pass { $pass }, welded up to { $welded }, the torch at { $torch }
    .cause = The last weld of this data folder did not end in order: power failure, crash or killed program while welding or held.
    .cure = Inspect the end of the bead; positions are accurate to 50 ms of travel.
project-grind-and-continue = look at the end of the bead, grind it, then --from { $from }; or --from 1,0 to weld anew
project-journal-thread-failed = the journal's thread failed
    .cause = The thread that writes the position of the weld to the disk ended by a fault of the program.
    .cure = Look at the part before welding again, and report the fault with the lines printed before.

# Teaching by camera.
project-no-taught-program = the line found makes no program: { $why }
    .cause = The taught line is too short, or does not give valid curves within `--tolerance-mm` and `--attitude-deg`.
    .cure = Teach a longer stretch, or enlarge these two options.
project-teach-machine-limit = the machine can go no further: { $why }
    .cause = The next move along the joint leaves the range of an axis, enters a zone, or comes too near to the part.
    .cure = Move the part with `[placement]`, or teach the rest from the other end with `--start` and `--direction`.
project-teach-joint-too-long = the joint is longer than twice the nominal seam
    .cause = The taught line is longer than twice the nominal seam plus 100 mm, so a closed joint missed its start or a scratch was followed.
    .cure = Look at the last frame; restart with `--start` on the joint, or correct the dimensions of `[seam]`.
project-teach-joint-lost = the joint is lost
    .cause = The detection found no joint with sufficient confidence, and the operator ended the search there.
    .cure = Clean the joint, improve light and focus, and teach on from there with `--start`.
project-teach-no-joint = no joint was found
    .cause = The first frames show no dark line within about a millimetre of the start.
    .cure = Move the camera onto the joint, or give a point on it with `--start X,Y,Z` and a rough `--direction`.
project-teach-no-more-frames = the frames end before the joint does
    .cause = The folder of frames has no further image, or the sender closed its connection, before the joint ended.
    .cure = Record frames up to the end of the joint, or teach the rest with `--start`.
project-cure-teach = teach on from there with --start, allow a longer --longest-tack-mm, or take the points by hand
project-goes-on = goes on in pass { $pass } from { $from }
    .cause = The weld was continued with `--from` or from the panel; it starts before the welded end by `overlap_mm`.

# Search for placements.
project-reach-axes = pass { $pass } is given by axis positions: no placement moves it
    .cause = A pass through taught axis positions stays where it was taught.
    .cure = Use a job whose passes follow a seam or points of the torch.
project-reach-axes-allowed = passes along a seam, or through points of the torch
