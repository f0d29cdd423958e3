# Findings at the command line.
project-weld-possible = the weld can be made as asked
project-weld-possible-with-remarks = the weld can be made, with remarks
project-weld-impossible = the weld cannot be made as asked: { $findings ->
        [one] { $findings } finding
       *[other] { $findings } findings
    }
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
project-more-places = { $places ->
        [one] { $places } more place
       *[other] { $places } more places
    }

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
project-with-hint =
    { $message }
    { "   " }{ $hint }
project-or = { $first } or { $second }
project-note = note: { $note }
project-planning-cancelled = planning was cancelled
project-failed = it failed
project-standard-input = standard input: { $why }
project-in-machine-file = machine file: { $why }
project-in-file = { $file }: { $why }
project-document-fault = { $file }:{ $line }: { $key }: { $message }

# Files.
project-unreadable = { $file }: cannot be read: { $why }
project-not-writable = { $file }: cannot be written: { $why }
project-writable = a folder or file that you may write
project-no-such-folder = there is no such folder
project-permission-denied = permission denied
project-not-a-folder = it is not a folder
project-is-a-folder = it is a folder
project-file-too-large = { $file }: the file is too large
project-up-to-1-gib = up to 1 GiB
project-other-file-there = { $file }: another file stands where the copy of { $from } should go
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
project-link-outside = a link leads outside of the folder of the jobs
project-not-a-plain-file = it is not a plain file
project-file-above = it is larger than { $max }

# Tables.
project-csv-value = { $file }:{ $line }: { $column } = `{ $value }`: { $fault }
project-not-a-finite-number = not a finite number
project-no-column = { $file }:1: there is no column `{ $column }` in `{ $header }`
project-header-line = a header line with { $columns }, then numbers
project-header-line-with-commas = a header line with { $columns }, then numbers, separated by commas
project-table-too-long = { $file }: the table is too long
project-up-to-points = up to { $max } points
project-file-from-job = a file that is there, its path seen from the job's folder

# Jobs and machines.
project-no-such-file = { $file }: there is no such file
project-copy-example = there is an example `{ $name }`; to copy it: seamwright examples { $name } > { $name }.toml
project-job-or-example = a job or program file, or the name of an example: { $names }
project-program-without-seam = the program has no seam
project-job-or-seam = a job, or a program with [seam]
project-no-machine = there is no machine `{ $name }`
project-shipped-machine-or-file = a machine that ships, or the path of a machine file
project-no-machine-or-file = there is no such machine, and no file { $file }
project-no-such-machine = { $name }: there is no such machine, and no such file
project-machine-names = { $names }, or the path of a machine file
project-machine-refused = machine `{ $name }`: { $why }
project-machine-among-jobs = the name of a machine that ships, or a machine file among the jobs
project-machine-without-file = machine `{ $name }` has no file
project-not-a-table = `{ $table }` is not a table
project-process-value-is-axis = process value `{ $name }` has the name of an axis of the machine
project-one-head = { $machine } has one head: it cannot weld both fillets at once
project-no-recording-machine = there is no machine `{ $name }` that could have recorded them
project-machine-as-recorded = `machine` as it was when they were recorded
project-positions-for-axes = { $positions ->
        [one] { $positions } position
       *[other] { $positions } positions
    }, and { $machine } has { $axes ->
        [one] { $axes } axis
       *[other] { $axes } axes
    }
project-within-axis-ranges = positions within the axes' ranges
project-option-tolerance = --tolerance-mm { $value }: { $why }

# Planning.
project-part-not-checked = no part is described: collisions are checked against the machine and the fixtures only
project-cure-describe-part = describe the part with [[part.solids]], or with the [seam] that it is made from
project-part-replaced = the part made from the seam is replaced: collisions are checked against the solids of [part] only
project-period-too-long = a period of { $period } is longer than the travel of pass { $pass }
project-period-within-travel = up to { $max }, the time of the travel
project-too-many-set-points = the motion takes { $time }, { $set-points } set-points of { $period }
project-up-to-set-points = up to { $max } set-points; a higher speed, shorter times or a longer period
project-tracking-with-devices = passes are tracked with simulated sensors, but the machine file has devices of its own
project-no-devices-or-tracking = a machine file without [devices], or no tracking

# Devices.
project-register-too-small = pass { $pass } asks for { $value } of `{ $name }`, which its register ({ $register }) of device `{ $device }` cannot hold
project-register-range = { $min } to { $max }, or another scale or type in the machine file
project-register-or-no-value = a register `{ $value }` in [devices.{ $device }.modbus.set] of the machine file, or a job without it
project-check-modbus = check cable, address, unit and registers; `seamwright io MACHINE` reads them one by one
project-period-of-no-cell = machine `{ $machine }`: no cell runs with a servo_period_ms of { $period }
project-periods = { $min } to { $max }, 1 ms if missing; `seamwright latency` measures what this computer can do
project-linuxcnc-needs-linux = drives by LinuxCNC are only on Linux
project-simulated = simulated: { $devices }
project-drives = drives
project-process-source = process source
project-inputs = inputs
project-pulses-end = { $file }: { $why }: the pulses end here

# Welds that were interrupted.
project-journal-damaged = { $folder }: both files of the journal of positions are damaged: a weld may have been interrupted at an unknown position
project-look-and-choose = look at the part, then --from PASS,MM to continue there, or --from 1,0 to weld anew
project-weld-left = weld { $weld } was left by a failure of power or program: pass { $pass }, welded up to { $welded }, the torch at { $torch }
project-grind-and-continue = look at the end of the bead, grind it, then --from { $from }; or --from 1,0 to weld anew
project-journal-thread-failed = the journal's thread failed

# Teaching by camera.
project-no-taught-program = the line found makes no program: { $why }
project-teach-machine-limit = the machine can go no further: { $why }
project-teach-joint-too-long = the joint is longer than twice the nominal seam
project-teach-joint-lost = the joint is lost
project-teach-no-joint = no joint was found
project-teach-no-more-frames = the frames end before the joint does
project-cure-teach = teach on from there with --start, allow a longer --longest-tack-mm, or take the points by hand
project-goes-on = goes on in pass { $pass } from { $from }
