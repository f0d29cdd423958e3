
# Parts of every error in a file.
document-error = { $at }: { $message }
document-allowed = allowed: { $allowed }
document-help = help: { $help }

# Keys and names.
document-unknown-key = there is no key `{ $key }` here
    .cause = The key is misspelt, belongs to another table, or ends in another unit. Keys after a table header belong to that table.
    .cure = Use one of the allowed keys in the message. `seamwright schema` prints the whole format.
document-unknown-name = `{ $name }` is not known
    .cause = The value is not among the names that exist: of axes, links, machines or choices.
    .cure = Use one of the allowed names in the message. Names are case-sensitive.
document-missing-key = the key `{ $key }` is missing
    .cause = The key has no default and is not in this table.
    .cure = Add it to the table at the line in the message. Every file begins with `schema = 1`.
document-key-in-unit = `{ $key } = ...`, in { $unit }
document-missing-schema = begin the file with: schema = 1
document-schema-version = 1, the version this build reads
document-none-given = none is given
    .cause = The table needs exactly one of several choices, as one kind of `[seam]`, and has none.
    .cure = Add one of the choices. The reference page of the file lists them.
document-several-given = several are given
    .cause = The table needs exactly one of several choices, and has more.
    .cure = Keep one of them.
document-exactly-one = exactly one of them
document-suggestion = did you mean `{ $name }`?
document-suggestion-unit = did you mean `{ $name }`? This value is given in { $unit }
document-own-name = a name of its own
document-own-names = names of their own
document-nested = tables and lists are nested too deeply
    .cause = Each table, list and part of a key in another one is a level; no format needs ten of them.
    .cure = Write the inner table under a header of its own, or correct a bracket that is not closed.
document-nesting = up to { $max } levels
document-no-such-entry = there is no such entry in the text
    .cause = The text was changed meanwhile, or the path is misspelt.
    .cure = Read the entries of the text again.
document-unfit-change = the entry cannot be changed in this way
    .cause = The entry is a table where a value is expected, or the other way round.
    .cure = Change it in the text.

# Values.
document-invalid-value = invalid value: { $value }
    .cause = The value has the right type and is not allowed: 0 for a positive number, or a `schema` other than 1.
    .cure = Replace it by one of the allowed values in the message.
document-invalid-type = invalid type: { $value }
    .cause = The value has another type: text in quotes for a number, or a number for a list.
    .cure = Write numbers without quotes and names with them.
document-number = a number
document-positive-number = a finite number greater than 0
document-non-negative-number = a finite number, 0 or greater
document-finite-number = a finite number
document-whole-number = a whole number from { $min } to { $max }
document-table = a table { $name }
document-number-without-unit = a number stands alone: its unit is in the key
document-direction = three numbers that are not all 0
document-direction-without-length = the direction has no length
    .cause = All three numbers of a direction are 0.
    .cure = Give the direction, for example `[0, 0, 1]`. Its length does not matter.
document-coordinates = three numbers within { $limit } of 0
document-coordinate-too-large = the coordinate is too large
    .cause = A coordinate is more than 10 km from 0, usually because it is in micrometres.
    .cure = Give it in mm. For plant coordinates subtract the position of the machine.
document-too-large = this is too large
    .cause = The magnitude exceeds the bound of the unit in which the key ends, usually because of another unit or a missing decimal point.
    .cure = Convert the value to the unit of the key. The job page lists all bounds.
document-too-small = this is too small
    .cause = The magnitude is below the bound of the unit in which the key ends, and is not 0.
    .cure = Convert the value to the unit of the key, as m/s to mm/s.

# Allowed values; numbers come with their units.
document-at-least = at least { $min }
document-at-most = up to { $max }
document-more-than = more than { $min }
document-less-than = less than { $max }
document-between = { $min } to { $max }
document-more-than-up-to = more than { $min }, up to { $max }
document-strictly-between = more than { $min } and less than { $max }
document-within = at least { $min }, up to { $max } ({ $reason })
document-up-to = up to { $max } ({ $reason })

# Reasons of bounds.
document-bound-scanner-jerk = jerk of the fastest scanner
document-bound-scanner-acceleration = acceleration of the fastest scanner
document-bound-turns = one turn in 40 days to 280 turns a second
document-bound-gravity = 10,000 times gravity
document-bound-speed = 0.36 mm an hour to 100 m a second
document-bound-wire-feeder = ten times the fastest wire feeder
document-bound-square-metre = a square metre
document-bound-many-turns = 2,700 turns
document-bound-kilometre = a kilometre
document-bound-10-km = 10 km
document-bound-hour = an hour
document-bound-pulses = the fastest pulse generator
document-bound-hundredfold = a hundredfold
document-bound-process-source = the largest process source
document-bound-beam-generator = the largest beam generator

# The code under which docs/reference/messages.md explains a message.
document-code = code: { $code }
