
# Parts of every error in a file.
document-error = { $at }: { $message }
document-allowed = дозволено: { $allowed }
document-help = підказка: { $help }

# Keys and names.
document-unknown-key = тут немає ключа `{ $key }`
document-unknown-name = `{ $name }` невідоме
document-missing-key = бракує ключа `{ $key }`
document-key-in-unit = `{ $key } = ...`, у { $unit }
document-missing-schema = почніть файл з: schema = 1
document-schema-version = 1, версія, яку читає ця збірка
document-none-given = не задано жодного
document-several-given = задано кілька
document-exactly-one = рівно одне з них
document-suggestion = можливо, `{ $name }`?
document-suggestion-unit = можливо, `{ $name }`? Це значення задають у { $unit }
document-own-name = власне ім’я
document-own-names = власні імена
document-nested = надто глибока вкладеність таблиць і списків
document-nesting = до { $max } рівнів
document-no-such-entry = такого запису в тексті немає
document-unfit-change = запис не можна змінити в такий спосіб

# Values.
document-invalid-value = недопустиме значення: { $value }
document-invalid-type = значення не того типу: { $value }
document-number = число
document-positive-number = число, більше за 0
document-non-negative-number = число, 0 або більше
document-finite-number = скінченне число
document-whole-number = ціле число від { $min } до { $max }
document-table = таблиця { $name }
document-number-without-unit = число пишуть без одиниці: вона вже в ключі
document-direction = три числа, не всі 0
document-direction-without-length = напрям не має довжини
document-coordinates = три числа в межах { $limit } від 0
document-coordinate-too-large = координата завелика
document-too-large = це завелике значення
document-too-small = це замале значення

# Allowed values; numbers come with their units.
document-at-least = щонайменше { $min }
document-at-most = до { $max }
document-more-than = більше за { $min }
document-less-than = менше за { $max }
document-between = від { $min } до { $max }
document-more-than-up-to = більше за { $min }, до { $max }
document-strictly-between = більше за { $min } і менше за { $max }
document-within = щонайменше { $min }, до { $max } ({ $reason })
document-up-to = до { $max } ({ $reason })

# Reasons of bounds.
document-bound-scanner-jerk = ривок найшвидшого сканера
document-bound-scanner-acceleration = прискорення найшвидшого сканера
document-bound-turns = від одного оберту за 40 днів до 280 обертів за секунду
document-bound-gravity = 10 000 прискорень вільного падіння
document-bound-speed = від 0,36 мм за годину до 100 м за секунду
document-bound-wire-feeder = удесятеро швидше за найшвидший подавач дроту
document-bound-square-metre = квадратний метр
document-bound-many-turns = 2700 обертів
document-bound-kilometre = кілометр
document-bound-10-km = 10 км
document-bound-hour = година
document-bound-pulses = найшвидший генератор імпульсів
document-bound-hundredfold = стократне значення
document-bound-process-source = найбільше джерело живлення процесу
document-bound-beam-generator = найбільший генератор променя

# The code under which docs/reference/messages.md explains a message.
document-code = код: { $code }
