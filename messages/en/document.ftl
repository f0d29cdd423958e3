
# Parts of every error in a file.
document-allowed = allowed: { $allowed }
document-help = help: { $help }

# Keys and names.
document-unknown-key = there is no key `{ $key }` here
document-unknown-name = `{ $name }` is not known
document-missing-key = the key `{ $key }` is missing
document-key-in-unit = `{ $key } = ...`, in { $unit }
document-missing-schema = begin the file with: schema = 1
document-schema-version = 1, the version this build reads
document-none-given = none is given
document-several-given = several are given
document-exactly-one = exactly one of them
document-suggestion = did you mean `{ $name }`?
document-suggestion-unit = did you mean `{ $name }`? This value is given in { $unit }
document-own-name = a name of its own
document-own-names = names of their own

# Values.
document-invalid-value = invalid value: { $value }
document-invalid-type = invalid type: { $value }
document-number = a number
document-positive-number = a finite number greater than 0
document-non-negative-number = a finite number, 0 or greater
document-finite-number = a finite number
document-whole-number = a whole number from { $min } to { $max }
document-table = a table { $name }
document-number-without-unit = a number stands alone: its unit is in the key
document-direction = three numbers that are not all 0
document-direction-without-length = the direction has no length
document-coordinates = three numbers within { $limit } of 0
document-coordinate-too-large = the coordinate is too large
document-too-large = this is too large
document-too-small = this is too small

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

# The code under which docs/messages.md explains a message.
document-code = code: { $code }
