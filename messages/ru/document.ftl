
# Parts of every error in a file.
document-error = { $at }: { $message }
document-allowed = допустимо: { $allowed }
document-help = подсказка: { $help }

# Keys and names.
document-unknown-key = здесь нет ключа `{ $key }`
document-unknown-name = `{ $name }` неизвестно
document-missing-key = не хватает ключа `{ $key }`
document-key-in-unit = `{ $key } = ...`, в { $unit }
document-missing-schema = начните файл с: schema = 1
document-schema-version = 1, версия, которую читает эта сборка
document-none-given = не задано ни одного
document-several-given = задано несколько
document-exactly-one = ровно одно из них
document-suggestion = возможно, `{ $name }`?
document-suggestion-unit = возможно, `{ $name }`? Это значение задают в { $unit }
document-own-name = собственное имя
document-own-names = собственные имена
document-nested = слишком глубокая вложенность таблиц и списков
document-nesting = до { $max } уровней
document-no-such-entry = такой записи в тексте нет
document-unfit-change = запись нельзя изменить таким образом

# Values.
document-invalid-value = недопустимое значение: { $value }
document-invalid-type = значение не того типа: { $value }
document-number = число
document-positive-number = число больше 0
document-non-negative-number = число, 0 или больше
document-finite-number = конечное число
document-whole-number = целое число от { $min } до { $max }
document-table = таблица { $name }
document-number-without-unit = число пишут без единицы: она уже в ключе
document-direction = три числа, не все 0
document-direction-without-length = направление не имеет длины
document-coordinates = три числа в пределах { $limit } от 0
document-coordinate-too-large = координата слишком велика
document-too-large = это значение слишком велико
document-too-small = это значение слишком мало

# Allowed values; numbers come with their units.
document-at-least = не меньше { $min }
document-at-most = до { $max }
document-more-than = больше { $min }
document-less-than = меньше { $max }
document-between = от { $min } до { $max }
document-more-than-up-to = больше { $min }, до { $max }
document-strictly-between = больше { $min } и меньше { $max }
document-within = не меньше { $min }, до { $max } ({ $reason })
document-up-to = до { $max } ({ $reason })

# Reasons of bounds.
document-bound-scanner-jerk = рывок самого быстрого сканера
document-bound-scanner-acceleration = ускорение самого быстрого сканера
document-bound-turns = от одного оборота за 40 дней до 280 оборотов в секунду
document-bound-gravity = 10 000 ускорений свободного падения
document-bound-speed = от 0,36 мм в час до 100 м в секунду
document-bound-wire-feeder = в десять раз быстрее самой быстрой подачи проволоки
document-bound-square-metre = квадратный метр
document-bound-many-turns = 2700 оборотов
document-bound-kilometre = километр
document-bound-10-km = 10 км
document-bound-hour = час
document-bound-pulses = самый быстрый генератор импульсов
document-bound-hundredfold = стократное значение
document-bound-process-source = самый большой источник питания процесса
document-bound-beam-generator = самый большой генератор луча

# The code under which docs/reference/messages.md explains a message.
document-code = код: { $code }
