# Steps and axes of the machine file.
machine-step-neither = шаг не является ни осью, ни неподвижным смещением
machine-step-kinds = либо `axis` со своими ключами, либо только `fixed`
machine-step-fixed-axis = у шага есть и `axis`, и `fixed`
machine-step-fixed-apart = `fixed` в отдельном шаге
machine-axis-name-invalid = имя оси содержит недопустимые символы
machine-plain-letters = строчные буквы, цифры и _
machine-axis-name-reserved = это имя зарезервировано для другого столбца таблиц
machine-axis-turn-or-move = ось либо поворачивается, либо движется прямолинейно
machine-turn-or-move = ровно один из `turn` и `move`
machine-axis-key-of-rotary = у линейной оси нет такого ключа
machine-only-with-turn = только с `turn`
machine-axis-lacks-key = оси `{ $axis }` не хватает `{ $key }`
machine-key-positive = { $key } = число больше 0
machine-home-outside-range = исходное положение вне диапазона
machine-letter-invalid = это не буква оси
machine-linear-axis-in-mm = линейную ось задают в мм
machine-rotary-axis-in-degrees = поворотную ось задают в градусах
machine-range-of-continuous = у оси без упоров нет диапазона
machine-continuous-or-range = `continuous` или диапазон
machine-range-missing = у оси нет диапазона
machine-range-form = { $key } = [минимум, максимум]
machine-range-form-or-continuous = { $key } = [минимум, максимум] или continuous = true
machine-range-empty = диапазон пуст
machine-axis-name-taken = такое имя есть у другой оси
machine-axis-letter-taken = такая буква есть у другой оси
machine-own-letter = собственная буква
machine-axes-count = у станка { $n ->
        [one] { $n } ось
        [few] { $n } оси
       *[many] { $n } осей
    }
machine-axes-allowed = от 1 до { $max } осей в [[tool]] и [[work]]
machine-home-order-twice = ось уже есть в списке
machine-each-axis-once = каждая ось один раз

# Torch and heads.
machine-torch-and-heads = у станка есть и `[torch]`, и `[[heads]]`
machine-torch-or-heads = `[torch]` для одной головки, `[[heads]]` для двух
machine-torch-missing = у станка нет горелки
machine-torch-form = `[torch]` с `direction` или две `[[heads]]`
machine-heads-many = у станка { $n ->
        [one] { $n } головка
        [few] { $n } головки
       *[many] { $n } головок
    }
machine-head-without-steps = у головки `{ $head }` нет собственных шагов: её ничто не несёт
machine-head-steps = `[[heads.steps]]` для каждой головки
machine-head-name-taken = такое имя есть у оси, другой головки или системы координат
machine-frame-name = пользовательская система координат с именем «{ $name }»
machine-frame-name-allowed = до { $max } знаков, не из числа { $names }

# Outputs and controls.
machine-output-taken = этот выход уже занят `{ $name }`
machine-own-output = собственный выход
machine-address-invalid = недопустимый адрес
machine-address-form = заглавная буква, кроме G и N, далее заглавные буквы, цифры и _, например X или CW
machine-address-taken = этот адрес есть у другой оси или величины процесса
machine-own-address = собственный адрес
machine-code-invalid = недопустимый G- или M-код
machine-code-form = G или M и число, например M54
machine-event-invalid = недопустимое имя события
machine-event-names = { $names } или собственное имя из строчных букв, цифр и _
machine-kinematics-output = только LinuxCNC переключает кинематику выходом

# Drives.
machine-drive-of-linear = у привода линейной оси масса и сила, а длины в мм
machine-drive-of-rotary = у привода поворотной оси момент инерции и крутящий момент, а углы в градусах
machine-drive-key-missing = приводу не хватает ключа
machine-drive-limit-range = предел не лежит между трением и пиковым значением
machine-drive-without-resonance = без резонанса двигатель и нагрузка составляют одну массу
machine-drive-resonance-alone = для резонанса нужно отношение инерции нагрузки к инерции двигателя
machine-together-with = вместе с `{ $key }`
machine-fraction-too-large = доля больше 1
machine-notches-many = у контура положения слишком много режекторных фильтров
machine-notch-too-high = { $frequency } — не ниже половины частоты дискретизации
machine-notch-depth = усиление в центре больше 1
machine-friction-smoothing-alone = компенсации трения нет
machine-backlash-time-alone = компенсации люфта нет

# Steppers and their pulses.
machine-full-steps = у двухфазного двигателя 4 полных шага на каждый зуб ротора
machine-multiple-of-4 = кратное 4, обычно 200
machine-microsteps-invalid = недопустимые микрошаги драйвера
machine-microsteps-allowed = целые числа от 1 до { $max }, по возрастанию, не меньше одного
machine-pulse-time = импульсы с уровнями по { $time } слишком длинные для этой частоты
machine-stepper-lacks-key = шаговому двигателю не хватает `{ $key }`
machine-motor-key-missing = двигателю не хватает ключа
machine-motor-keys = rotor_inertia_kg_m2, torque_rpm и torque_n_m вместе, или без всех трёх
machine-torque-lengths = скоростей: { $speeds }, моментов: { $torques }
machine-torque-equal-lengths = столько же моментов, сколько скоростей, не меньше 2
machine-torque-speeds = кривая момента не начинается с покоя с ростом скорости
machine-zero-then-increasing = сначала 0, далее по возрастанию
machine-torque-holding = у двигателя нет удерживающего момента
machine-torque-first = сначала удерживающий момент больше 0
machine-stepper-missing = у оси `{ $axis }` нет шагового двигателя для импульсов
machine-stepper-or-other-drives = [drives.{ $axis }.stepper] или другие приводы вместо `steps`
machine-resolution-too-fine = самая мелкая настройка драйвера грубее этого
machine-pulse-rate = оси `{ $axis }` на максимальной скорости ({ $speed }, микрошагов: { $microsteps }) нужны импульсы с частотой { $needed }; драйвер принимает до { $possible }
machine-pulse-rate-allowed = максимальная скорость до { $speed }, более грубое `{ $resolution }` или более быстрый драйвер (max_pulse_hz, min_pulse_us)
machine-pulses-after-reversal = после реверса { $n ->
        [one] { $n } импульс не помещается
        [few] { $n } импульса не помещаются
       *[many] { $n } импульсов не помещаются
    } в период
machine-direction-times-allowed = direction_setup_us и direction_hold_us вместе до { $time }
machine-tick = такт таймера { $tick }
machine-tick-allowed = от 10 до 100000 нс, целое число раз в периоде { $period }
machine-stream-file = `{ $file }` не является файлом VCD
machine-stream-file-allowed = путь к файлу, оканчивающийся на .vcd, или без `stream`

# Pitch errors.
machine-pitch-in-mm = таблица погрешности шага оси `{ $axis }` задаётся в мм
machine-pitch-in-degrees = таблица погрешности шага оси `{ $axis }` задаётся в градусах
machine-pitch-keys = { $positions } и { $errors }, списки одинаковой длины
machine-pitch-lengths = положений: { $positions }, погрешностей: { $errors }
machine-pitch-equal-lengths = столько же погрешностей, сколько положений, не меньше 2
machine-pitch-positions = недопустимые положения таблицы погрешности шага
machine-increasing-positions = положения по возрастанию
machine-increasing-within-a-turn = положения по возрастанию в пределах одного оборота
machine-pitch-steep = погрешность меняется на { $slope } от перемещения: слишком круто для погрешности шага

# Sensors.
machine-image-width = недопустимая ширина изображения
machine-image-height = недопустимая высота изображения
machine-image-size = от 1 до { $max } столбцов и строк
machine-frames-of-stripe = у датчика с лазерной полосой нет потока кадров
machine-frames-invalid = недопустимый источник кадров
machine-frames-form = для камеры: "tcp://HOST:PORT"
machine-stripe-map-missing = датчику с лазерной полосой нужен `map`, из пикселей в мм
machine-stripe-maps = `map.camera`, `map.homography` или `map.scale`
machine-camera-angle = камера не видела бы стыка
machine-map-of-camera = это отображение для камеры
machine-map-singular = у разных пикселей было бы одно положение
machine-map-invertible = числа обратимого отображения
machine-map-horizon = пиксель ({ $column }, { $row }) за горизонтом: он не видит ни одной точки плоскости лазера
machine-map-every-pixel = отображение, дающее положение каждому пикселю изображения
machine-camera-map-missing = камере нужен `map.heights`
machine-heights-order = z не возрастает от строки к строке
machine-more-than-before = больше, чем в предыдущей строке
machine-heights-rows = строки одной камеры, не меньше одной

# Shapes and zones.
machine-zone-watches-nothing = у `{ $link }` нет форм: зона ничего не контролировала бы
machine-shapes-first = звено с [[shapes.{ $link }]]
machine-zone-empty = у зоны нет объёма
machine-zone-solids = не меньше одного [[zones.solids]]
machine-zone-shape = разрешённая зона не может иметь такую форму
machine-part = деталь
machine-fixtures = оснастка
machine-solid-of-part = { $name } (деталь)
machine-solid-of-fixtures = { $name } (оснастка)
machine-forbidden-zone = запретная зона { $zone }
machine-permitted-zone = разрешённая зона { $zone }

# Interlocks.
machine-interlocks-many = у станка { $n ->
        [one] { $n } блокировка
        [few] { $n } блокировки
       *[many] { $n } блокировок
    }
machine-interlock-name-empty = имя пусто
machine-interlock-input-empty = у входа нет имени
machine-a-name = имя
machine-interlock-name-taken = такое имя есть у другой блокировки
machine-interlocks-contradict = `{ $first }` требует { $first_value } на входе { $input }, а `{ $second }` — { $second_value }: ничто никогда не запустится
machine-value-or-other-input = { $value } или другой вход
machine-input-taken = `{ $interlock }` уже контролирует вход { $input }
machine-one-interlock-an-input = одна блокировка на вход: сильнее for = "{ $level }"

# Devices.
machine-out-of-range = значение вне допустимых пределов
machine-unit-reserved = этот адрес устройства зарезервирован
machine-unit-allowed = от 0 до 247 или 255
machine-device-without-registers = у устройства нет регистров
machine-device-without-role = устройство не является источником процесса и не имеет входов
machine-device-roles = регистры для входов или для outputs.on и reports.burning
machine-host-missing = хост не указан
machine-port-missing = порт от 1 до 65535 не указан
machine-host-and-port = хост:порт, например 192.168.1.20:502 или [fe80::1]:502
machine-fault-code-type = код неисправности — это простое u16
machine-exactly-one-of = ровно одно из { $names }
machine-register-tables = названа не ровно одна таблица
machine-register-read-only = `{ $table }` можно только читать, а сюда пишут
machine-register-single-bit = `{ $table }` — это один бит
machine-bit-with-register = `bit` с holding или input
machine-register-bits = в регистре 16 битов
machine-bit-allowed = от 0 (младший) до 15
machine-bit-form = bit = от 0 (младший) до 15
machine-safe-of-input = безопасное состояние есть только у выходов
machine-safe-with-outputs = `safe` с gas, on и set
machine-safe-state-on = безопасное состояние дуги или луча — выключено
machine-words-of-16-bits = 16 битов — это один регистр
machine-words-with-32-bits = `words` с u32, i32 и f32
machine-register-last = 32 битам нужны два регистра, а этот последний
machine-scale-zero = любое число имело бы одно и то же значение
machine-not-zero = любое число, кроме 0
machine-safe-out-of-range = регистр не вмещает этого значения
machine-register-taken = по адресу { $address } уже есть `{ $register }`
machine-source-taken = источником процесса уже является устройство `{ $device }`
machine-one-source = один источник процесса
machine-source-without-register = у источника процесса нет регистра для `{ $key }`
machine-inputs-taken = входы уже есть у устройства `{ $device }`
machine-inputs-on-one-device = все входы на одном устройстве
machine-input-without-register = у входа `{ $input }` блокировки `{ $interlock }` нет регистра
machine-register-for-every-input = регистр для входа каждой блокировки
machine-drives-taken = приводы уже заняты другим устройством
machine-one-device-of-drives = одно устройство с `linuxcnc`, `steps`, `rtde`, `egm` или `rsi`
machine-robot-axis-twice = ось `{ $axis }` названа дважды
machine-robot-axis-missing = у оси `{ $axis }` нет звена системы управления роботом
machine-robot-axis-once = каждая ось станка один раз, в порядке звеньев системы управления
machine-robot-axis-count = число осей ({ $n }) не соответствует звеньям системы управления роботом
machine-robot-axis-count-allowed = звеньев руки: { $arm }, внешних звеньев: до { $external }
machine-robot-axis-linear = ось `{ $axis }` линейная, но это звено руки
machine-robot-axis-rotary = первые { $arm } — поворотные оси
machine-robot-listen = это не IP-адрес с портом
machine-robot-listen-allowed = IP-адрес этого компьютера с портом, например 0.0.0.0:6510
machine-robot-from = это не IP-адрес
machine-robot-from-allowed = IP-адрес системы управления, например 192.168.125.1
machine-hal-file = `{ $file }` не является файлом HAL
machine-hal-file-allowed = путь к файлу, оканчивающийся на .hal, или без `hal`
machine-base-period = недопустимый период более быстрого потока: { $base }
machine-base-period-allowed = от 10 до 1000, целое число раз в периоде { $period }, не меньше двух
machine-axis-name-long = имя оси `{ $axis }` слишком длинное для HAL в LinuxCNC
machine-name-length = до { $max } символов

# Reasons why a pose is out of reach.
machine-unreachable-direction = поворотные оси не могут так повернуть горелку; ближайшее направление отличается на { $angle }
machine-unreachable-point = оси не достигают точки; не хватает { $distance }
machine-unreachable-flat = при этих положениях поворотных осей линейные оси параллельны одной плоскости
machine-out-of-reach = вне досягаемости на { $distance }: ось { $axis } была бы на { $position }, на { $excess } за пределом { $limit }
machine-axis-out-of-range = ось { $axis } была бы на { $position }, на { $excess } за пределом { $limit }
machine-pair-axes = двум головкам одновременно нужны три линейные и три поворотные оси, несущие обе; соседние оси не параллельны
machine-pair-same-point = обе горелки в одной точке: общей системы координат нет
machine-pair-opposed = горелки направлены друг на друга: общей системы координат нет

# Check of a machine: inverse kinematics and failures.
machine-method-closed = в замкнутой форме
machine-method-plane-on-rotary = в замкнутой форме, плоскость на поворотной оси
machine-method-in-plane = в замкнутой форме, в плоскости
machine-method-numeric = численно (метод Ньютона)
machine-method-spherical-wrist = в замкнутой форме, рука со сферическим запястьем
machine-method-three-parallel = в замкнутой форме, рука с тремя параллельными осями
machine-method-spherical-shoulder = в замкнутой форме, рука со сферическими плечом и запястьем
machine-free-roll = поворот вокруг горелки
machine-linear-axes = линейные: { $n } ({ $axes })
machine-rotary-axes = поворотные: { $n } ({ $axes })
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }: { $axes }
machine-structure-with-free = { $method }: { $axes }; избыточные: { $free }
machine-check-head = головка { $head }: { $why }
machine-check-pair = обе головки одновременно: { $why }
machine-check-round-trip = расхождение обратного решения: { $distance } мм, { $angle }°, { $difference } в оси; поз без решения: { $unsolved }, без собственной ветви: { $missed }
machine-check-jacobian = якобиан отличается на { $difference } столбца оси { $axis }

# Check of a machine: singular configurations.
machine-singular-linear = линейные оси { $axes } лежат в одной плоскости: остриё не может её покинуть
machine-singular-along-axis = горелка направлена вдоль оси { $axis }: там { $axis } свободна
machine-singular-undone = { $axes } может отменить движение оси { $axis }: там { $axis } свободна
machine-singular-parallel = оси { $first } и { $second } параллельны: одна отменяет другую
machine-singular-tilt = горелка лежит в плоскости осей { $first } и { $second }: обе наклоняют её одинаково
machine-singular-undo = оси { $axes } отменяют друг друга
machine-singular-following = { $what }, при этом движется { $axes }
machine-singular-wrist = сингулярность запястья: оси { $first } и { $second } параллельны
machine-singular-elbow = сингулярность локтя: манипулятор вытянут или сложен
machine-singular-shoulder = сингулярность плеча: запястье над осью { $axis }
machine-singular-stretched = манипулятор вытянут или сложен: оси { $first } и { $second } двигают остриё одинаково
machine-singular-tip-on-axis = остриё лежит на оси { $axis }, которая не может его двигать
machine-singular-direction = остриё не может двигаться вдоль ({ $x }, { $y }, { $z }) детали
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }, при { $positions }
machine-singular-for-example = { $what }, например при { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = контуры положения работали бы каждые { $period }
machine-cure-period = задайте период в мс; обычно 1
machine-remark-displacement = смещение длиннее { $limit }
machine-cure-displacement = задавайте длины в мм
machine-remark-no-shapes = у станка нет форм: столкновения не проверяются
machine-cure-no-shapes = добавьте [[shapes.torch]] и так же для всего остального, что может столкнуться
machine-remark-home-collision = в исходном положении между { $first } и { $second } всего { $distance }, меньше минимума { $min }
machine-cure-home-collision = измените home_mm или home_deg оси или формы
machine-remark-range-long = у оси { $axis } был бы ход { $travel }
machine-cure-range-long = задайте диапазон в мм
machine-remark-range-short = ось { $axis } двигалась бы всего на { $travel }
machine-cure-range-short = задайте диапазон в мм; возможно, имелись в виду метры
machine-remark-turns = ось { $axis } делала бы оборотов: { $turns }
machine-cure-turns = задайте диапазон в градусах или continuous = true
machine-remark-range-narrow = ось { $axis } поворачивалась бы всего на { $travel }
machine-cure-range-narrow = задайте диапазон в градусах
machine-remark-range-quarter-turns = ось { $axis } поворачивалась бы всего на { $travel }; её границы — четверти оборота в радианах: от { $low } до { $high }
machine-remark-range-radians = ось { $axis } поворачивалась бы всего на { $travel }; в радианах это было бы от { $low } до { $high }
machine-cure-range-radians = задайте диапазон в градусах; оставьте, если так и задумано
machine-remark-speed-high = { $speed } — быстрее, чем движутся такие оси
machine-remark-speed-low = { $speed } — медленнее, чем движутся такие оси
machine-cure-linear-speed-high = задайте скорость в мм/с; возможно, имелись в виду мм/мин
machine-cure-rotary-speed-high = задайте скорость в °/с; возможно, имелись в виду °/мин
machine-cure-linear-speed-low = задайте скорость в мм/с; возможно, имелись в виду м/с
machine-cure-rotary-speed-low = задайте скорость в °/с; возможно, имелись в виду рад/с или об/мин
machine-remark-speed-unreached = ось { $axis } никогда её не достигнет: разгону и торможению нужно { $needed }, а её ход { $travel }
machine-cure-linear-speed-unreached = задайте скорость в мм/с и ускорение в мм/с²
machine-cure-rotary-speed-unreached = задайте скорость в °/с и ускорение в °/с²
machine-remark-acceleration-low = оси { $axis } нужно { $time }, чтобы достичь максимальной скорости
machine-remark-acceleration-high = ось { $axis } достигает максимальной скорости за { $time }
machine-remark-gravity = ускорение в { $factor } g — больше, чем выдерживают такие оси
machine-cure-linear-acceleration = задайте ускорение в мм/с²
machine-cure-rotary-acceleration = задайте ускорение в °/с²
machine-cure-linear-acceleration-low = задайте ускорение в мм/с²; возможно, имелись в виду м/с²
machine-cure-rotary-acceleration-low = задайте ускорение в °/с²; возможно, имелись в виду рад/с²
machine-remark-jerk-missing = у оси { $axis } нет ограничения рывка
machine-cure-jerk-missing = добавьте { $key }; обычно в десять раз больше ускорения
machine-remark-jerk-low = ускорение нарастает { $time }
machine-cure-linear-jerk = задайте рывок в мм/с³
machine-cure-rotary-jerk = задайте рывок в °/с³
machine-remark-drive-missing = у оси { $axis } нет привода: в симуляции взят предполагаемый
machine-cure-drive-missing = добавьте [drives.{ $axis }]
machine-remark-drive-weak = оси { $axis } для ускорения на максимальной скорости нужно { $needed }, с учётом трения
machine-cure-drive-weak = возьмите более мощный привод или уменьшите max_acceleration
machine-remark-drive-strong = привод в { $factor } раза мощнее, чем нужно нагрузке
machine-cure-linear-drive-strong = задайте массу в кг и силу в Н
machine-cure-rotary-drive-strong = задайте момент инерции в кг·м² и крутящий момент в Н·м
machine-remark-encoder = один отсчёт — это { $count }
machine-cure-linear-encoder = задайте число отсчётов на мм на оси
machine-cure-rotary-encoder = задайте число отсчётов на градус на оси
machine-remark-velocity-loop = { $bandwidth } — слишком высоко для контура положения с периодом { $period }
machine-cure-velocity-loop = задайте полосу в Гц или более короткий servo_period_ms
machine-remark-pitch = погрешность оси { $axis } была бы до { $error }
machine-cure-linear-pitch = задайте погрешности в мм
machine-cure-rotary-pitch = задайте погрешности в градусах

# Import of arms.
machine-urdf-not-xml = файл не является XML: { $why }
machine-urdf-cure-xml = Исправьте XML здесь или экспортируйте файл заново.
machine-urdf-attribute-missing = у элемента нет атрибута `{ $name }`
machine-urdf-cure-attribute = Добавьте в элемент `{ $name }="…"`.
machine-urdf-element-missing = в элементе нет `<{ $name }>`
machine-urdf-cure-element = Добавьте в сочленение `<{ $name } link="…"/>`.
machine-urdf-not-numbers = недопустимые числа
machine-urdf-cure-numbers = Количество чисел здесь: { $n }, через пробел, например `0.1 0 0.25`.
machine-urdf-root = корневой элемент — `{ $name }`, а не `robot`
machine-urdf-empty = в файле нет звеньев
machine-urdf-cure-root = Укажите файл URDF: его корень — `<robot>`, внутри — `<link>` и `<joint>`.
machine-urdf-xacro = в файле есть макросы xacro
machine-urdf-cure-xacro = Сначала раскройте макросы: `xacro robot.urdf.xacro > robot.urdf`.
machine-urdf-two-parents = звено `{ $link }` уже закреплено на сочленении `{ $joint }`
machine-urdf-loop = звено `{ $link }` входит в замкнутый контур
machine-urdf-cure-tree = Удалите одно из сочленений: каждое звено несёт одно сочленение.
machine-urdf-name-taken = имя `{ $name }` встречается дважды
machine-urdf-cure-name = Переименуйте одно из двух.
machine-urdf-link-unknown = звена `{ $link }` нет
machine-urdf-cure-link = Укажите одно из звеньев файла.
machine-urdf-axis-zero = у оси нет направления
machine-urdf-cure-axis = Укажите направление, например `xyz="0 0 1"`.
machine-urdf-size = размер не больше 0
machine-urdf-cure-size = Укажите размеры в метрах, больше 0.
machine-urdf-roots = в файле несколько звеньев основания: { $links }
machine-urdf-cure-roots = Выберите основание: `--base LINK`.
machine-urdf-tips = число концов дерева, которые движутся осями: { $n } ({ $links })
machine-urdf-cure-tips = Выберите звено, несущее горелку: `--tip LINK`.
machine-urdf-no-axes = ни одна ось не движет звено, закреплённое на `{ $link }`
machine-urdf-cure-no-axes = Выберите другое основание (`--base LINK`) или сделайте сочленения `revolute` или `prismatic`.
machine-urdf-not-carried = основание `{ $base }` не несёт звено `{ $tip }`
machine-urdf-cure-not-carried = Выберите другие `--base` или `--tip`.
machine-urdf-axes = число осей до звена `{ $link }`: { $n }
machine-urdf-cure-axes = Выберите `--base` и `--tip` так, чтобы между ними было от 1 до { $max } осей.
machine-urdf-too-long = длина цепи от основания до конца — { $length }: для манипулятора в метрах слишком много
machine-urdf-too-short = длина цепи от основания до конца — { $length }: для манипулятора в метрах слишком мало
machine-urdf-cure-scale = URDF задают в метрах. Импортируйте с `--scale { $factor }` или экспортируйте файл в метрах.
machine-urdf-degrees = углы сочленения `{ $joint }` заданы не в радианах
machine-urdf-cure-degrees = Запишите пределы в рад и рад/с: градусы, делённые на 57.29578.
machine-urdf-joint-type = тип сочленения `{ $joint }` не является осью
machine-urdf-cure-joint-type = Между основанием и концом допустимы: `revolute`, `continuous`, `prismatic`, `fixed`.
machine-urdf-mimic = сочленение `{ $joint }` следует за сочленением `{ $other }`
machine-urdf-cure-mimic = Выберите `--tip` перед этим сочленением, сделайте его `fixed` или удалите `<mimic>`, если у него свой привод.
machine-urdf-limit-missing = у сочленения `{ $joint }` нет пределов
machine-urdf-limit-empty = диапазон сочленения `{ $joint }` пуст
machine-urdf-cure-limit = Напишите `<limit lower="…" upper="…" velocity="…" effort="…"/>` в рад, рад/с и Н·м или в м, м/с и Н, как в паспорте.
machine-urdf-velocity = у сочленения `{ $joint }` нет наибольшей скорости
machine-urdf-cure-velocity = Укажите `velocity` из паспорта, в рад/с или м/с.
machine-urdf-mesh-missing = сетки `{ $mesh }` нет
machine-urdf-mesh-tried = файл в одном из мест: { $files }
machine-urdf-cure-mesh = Укажите папку её пакета, `--package NAME=DIR`, или импортируйте без тел, `--no-shapes`.
machine-import-rounded-angles = углы источника ({ $n }) — округлённые кратные 15 градусов, как 1.5708; они прочитаны как точные
machine-import-flange = из нескольких концов ({ $links }) выбран фланец `tool0`; `--tip` выбирает другой
machine-import-held = сочленения вне цепи остаются в нуле: { $joints }
machine-import-no-shapes = тел нет: зазоры не проверяются
machine-import-shape-kind = тело звена { $link } пропущено: `{ $kind }` — не параллелепипед, цилиндр, шар или сетка
machine-import-mesh-format = сетка { $file } звена { $link } пропущена: преобразуйте её в STL
machine-import-mesh-unusable = сетка { $file } звена { $link } пропущена: { $why }
machine-import-mesh-stretched = её масштаб вдоль x, y и z различен
