# Steps and axes of the machine file.
machine-step-neither = крок не є ні віссю, ні нерухомим переміщенням
machine-step-kinds = або `axis` зі своїми ключами, або лише `fixed`
machine-step-fixed-axis = крок має і `axis`, і `fixed`
machine-step-fixed-apart = `fixed` в окремому кроці
machine-axis-name-invalid = назва осі містить недопустимі символи
machine-plain-letters = малі літери, цифри і _
machine-axis-name-reserved = ця назва зарезервована для іншого стовпця таблиць
machine-axis-turn-or-move = вісь або повертається, або рухається прямолінійно
machine-turn-or-move = рівно один із `turn` і `move`
machine-axis-key-of-rotary = лінійна вісь не має такого ключа
machine-only-with-turn = лише з `turn`
machine-axis-lacks-key = осі `{ $axis }` бракує `{ $key }`
machine-key-positive = { $key } = число, більше за 0
machine-home-outside-range = вихідне положення поза діапазоном
machine-letter-invalid = це не літера осі
machine-linear-axis-in-mm = лінійну вісь задають у мм
machine-rotary-axis-in-degrees = поворотну вісь задають у градусах
machine-range-of-continuous = вісь без упорів не має діапазону
machine-continuous-or-range = `continuous` або діапазон
machine-range-missing = вісь не має діапазону
machine-range-form = { $key } = [мінімум, максимум]
machine-range-form-or-continuous = { $key } = [мінімум, максимум] або continuous = true
machine-range-empty = діапазон порожній
machine-axis-name-taken = таку назву має інша вісь
machine-axis-letter-taken = таку літеру має інша вісь
machine-own-letter = власна літера
machine-axes-count = верстат має { $n ->
        [one] { $n } вісь
        [few] { $n } осі
       *[many] { $n } осей
    }
machine-axes-allowed = від 1 до { $max } осей у [[tool]] і [[work]]
machine-home-order-twice = вісь уже є в переліку
machine-each-axis-once = кожна вісь один раз

# Torch and heads.
machine-torch-and-heads = верстат має і `[torch]`, і `[[heads]]`
machine-torch-or-heads = `[torch]` для однієї головки, `[[heads]]` для двох
machine-torch-missing = верстат не має пальника
machine-torch-form = `[torch]` з `direction` або дві `[[heads]]`
machine-heads-many = верстат має { $n ->
        [one] { $n } головку
        [few] { $n } головки
       *[many] { $n } головок
    }
machine-head-without-steps = головка `{ $head }` не має власних кроків: її нічого не несе
machine-head-steps = `[[heads.steps]]` для кожної головки
machine-head-name-taken = таку назву має вісь, інша головка або система координат
machine-frame-name = система координат користувача з назвою «{ $name }»
machine-frame-name-allowed = до { $max } знаків, не з-поміж { $names }

# Outputs and controls.
machine-output-taken = цей вихід уже має `{ $name }`
machine-own-output = власний вихід
machine-address-invalid = недопустима адреса
machine-address-form = велика літера, крім G і N, далі великі літери, цифри і _, як-от X або CW
machine-address-taken = цю адресу має інша вісь або величина процесу
machine-own-address = власна адреса
machine-code-invalid = недопустимий G- або M-код
machine-code-form = G або M і число, як-от M54
machine-event-invalid = недопустима назва події
machine-event-names = { $names } або власне ім’я з малих літер, цифр і _
machine-kinematics-output = лише LinuxCNC перемикає кінематику виходом

# Drives.
machine-drive-of-linear = привід лінійної осі має масу і силу, а довжини в мм
machine-drive-of-rotary = привід поворотної осі має момент інерції і крутний момент, а кути в градусах
machine-drive-key-missing = приводу бракує ключа
machine-drive-limit-range = межа не лежить між тертям і піковим значенням
machine-drive-without-resonance = без резонансу двигун і навантага є однією масою
machine-drive-resonance-alone = для резонансу потрібне відношення інерції навантаги до інерції двигуна
machine-together-with = разом із `{ $key }`
machine-fraction-too-large = частка більша за 1
machine-notches-many = контур положення має забагато режекторних фільтрів
machine-notch-too-high = { $frequency } — не нижче половини частоти дискретизації
machine-notch-depth = підсилення в центрі більше за 1
machine-friction-smoothing-alone = компенсації тертя немає
machine-backlash-time-alone = компенсації люфту немає

# Steppers and their pulses.
machine-full-steps = двофазний двигун має 4 повні кроки на кожен зубець ротора
machine-multiple-of-4 = кратне 4, зазвичай 200
machine-microsteps-invalid = недопустимі мікрокроки драйвера
machine-microsteps-allowed = цілі числа від 1 до { $max }, за зростанням, щонайменше одне
machine-pulse-time = імпульси з рівнями по { $time } задовгі для цієї частоти
machine-stepper-lacks-key = кроковому двигуну бракує `{ $key }`
machine-motor-key-missing = двигуну бракує ключа
machine-motor-keys = rotor_inertia_kg_m2, torque_rpm і torque_n_m разом, або без усіх трьох
machine-torque-lengths = швидкостей: { $speeds }, моментів: { $torques }
machine-torque-equal-lengths = стільки моментів, скільки швидкостей, щонайменше 2
machine-torque-speeds = крива моменту не починається зі спокою зі зростанням швидкості
machine-zero-then-increasing = спершу 0, далі за зростанням
machine-torque-holding = двигун не має утримувального моменту
machine-torque-first = спершу утримувальний момент, більший за 0
machine-stepper-missing = вісь `{ $axis }` не має крокового двигуна для імпульсів
machine-stepper-or-other-drives = [drives.{ $axis }.stepper] або інші приводи замість `steps`
machine-resolution-too-fine = найдрібніше налаштування драйвера грубіше за це
machine-pulse-rate = осі `{ $axis }` на максимальній швидкості ({ $speed }, мікрокроків: { $microsteps }) потрібні імпульси з частотою { $needed }; драйвер приймає до { $possible }
machine-pulse-rate-allowed = максимальна швидкість до { $speed }, грубіше `{ $resolution }` або швидший драйвер (max_pulse_hz, min_pulse_us)
machine-pulses-after-reversal = після реверсу { $n ->
        [one] { $n } імпульс не вміщується
        [few] { $n } імпульси не вміщуються
       *[many] { $n } імпульсів не вміщуються
    } в період
machine-direction-times-allowed = direction_setup_us і direction_hold_us разом до { $time }
machine-tick = такт таймера { $tick }
machine-tick-allowed = від 10 до 100000 нс, ціле число разів у періоді { $period }
machine-stream-file = `{ $file }` не є файлом VCD
machine-stream-file-allowed = шлях до файла, що закінчується на .vcd, або без `stream`

# Pitch errors.
machine-pitch-in-mm = таблиця похибки кроку осі `{ $axis }` задається в мм
machine-pitch-in-degrees = таблиця похибки кроку осі `{ $axis }` задається в градусах
machine-pitch-keys = { $positions } і { $errors }, списки однакової довжини
machine-pitch-lengths = положень: { $positions }, похибок: { $errors }
machine-pitch-equal-lengths = стільки похибок, скільки положень, щонайменше 2
machine-pitch-positions = недопустимі положення таблиці похибки кроку
machine-increasing-positions = положення за зростанням
machine-increasing-within-a-turn = положення за зростанням у межах одного оберту
machine-pitch-steep = похибка змінюється на { $slope } від переміщення: це забагато для похибки кроку

# Sensors.
machine-image-width = недопустима ширина зображення
machine-image-height = недопустима висота зображення
machine-image-size = від 1 до { $max } стовпців і рядків
machine-frames-of-stripe = лазерний давач зі смугою не має потоку кадрів
machine-frames-invalid = недопустиме джерело кадрів
machine-frames-form = для камери: "tcp://HOST:PORT"
machine-stripe-map-missing = лазерному давачу зі смугою потрібен `map`, з пікселів у мм
machine-stripe-maps = `map.camera`, `map.homography` або `map.scale`
machine-camera-angle = камера не бачила б стику
machine-map-of-camera = це відображення для камери
machine-map-singular = різні пікселі мали б те саме положення
machine-map-invertible = числа оборотного відображення
machine-map-horizon = піксель ({ $column }, { $row }) за обрієм: він не бачить жодної точки площини лазера
machine-map-every-pixel = відображення, що дає положення кожному пікселю зображення
machine-camera-map-missing = камері потрібен `map.heights`
machine-heights-order = z не зростає від рядка до рядка
machine-more-than-before = більше, ніж у попередньому рядку
machine-heights-rows = рядки однієї камери, щонайменше один

# Shapes and zones.
machine-zone-watches-nothing = `{ $link }` не має форм: зона нічого не контролювала б
machine-shapes-first = ланка з [[shapes.{ $link }]]
machine-zone-empty = зона не має об’єму
machine-zone-solids = щонайменше одне [[zones.solids]]
machine-zone-shape = дозволена зона не може мати такої форми
machine-part = деталь
machine-fixtures = оснащення
machine-solid-of-part = { $name } (деталь)
machine-solid-of-fixtures = { $name } (оснащення)
machine-forbidden-zone = заборонена зона { $zone }
machine-permitted-zone = дозволена зона { $zone }

# Interlocks.
machine-interlocks-many = верстат має { $n ->
        [one] { $n } блокування
        [few] { $n } блокування
       *[many] { $n } блокувань
    }
machine-interlock-name-empty = ім’я порожнє
machine-interlock-input-empty = вхід не має імені
machine-a-name = ім’я
machine-interlock-name-taken = таке ім’я має інше блокування
machine-interlocks-contradict = `{ $first }` потребує { $first_value } на вході { $input }, а `{ $second }` — { $second_value }: ніщо ніколи не запуститься
machine-value-or-other-input = { $value } або інший вхід
machine-input-taken = `{ $interlock }` уже контролює вхід { $input }
machine-one-interlock-an-input = одне блокування на вхід: сильніше for = "{ $level }"

# Devices.
machine-out-of-range = значення поза допустимими межами
machine-unit-reserved = ця адреса пристрою зарезервована
machine-unit-allowed = від 0 до 247 або 255
machine-device-without-registers = пристрій не має регістрів
machine-device-without-role = пристрій не є джерелом процесу і не має входів
machine-device-roles = регістри для входів або для outputs.on і reports.burning
machine-host-missing = хост не вказано
machine-port-missing = порт від 1 до 65535 не вказано
machine-host-and-port = хост:порт, як-от 192.168.1.20:502 або [fe80::1]:502
machine-fault-code-type = код несправності — це просте u16
machine-exactly-one-of = рівно одне з { $names }
machine-register-tables = названо не рівно одну таблицю
machine-register-read-only = `{ $table }` можна лише читати, а сюди пишуть
machine-register-single-bit = `{ $table }` — це один біт
machine-bit-with-register = `bit` з holding або input
machine-register-bits = регістр має 16 бітів
machine-bit-allowed = від 0 (наймолодший) до 15
machine-bit-form = bit = від 0 (наймолодший) до 15
machine-safe-of-input = безпечний стан мають лише виходи
machine-safe-with-outputs = `safe` з gas, on і set
machine-safe-state-on = безпечний стан дуги чи променя — вимкнено
machine-words-of-16-bits = 16 бітів — це один регістр
machine-words-with-32-bits = `words` з u32, i32 і f32
machine-register-last = 32 біти потребують двох регістрів, а цей останній
machine-scale-zero = кожне число мало б те саме значення
machine-not-zero = будь-яке число, крім 0
machine-safe-out-of-range = регістр не вміщує цього значення
machine-register-taken = за адресою { $address } уже є `{ $register }`
machine-source-taken = джерелом процесу вже є пристрій `{ $device }`
machine-one-source = одне джерело процесу
machine-source-without-register = джерело процесу не має регістра для `{ $key }`
machine-inputs-taken = входи вже має пристрій `{ $device }`
machine-inputs-on-one-device = усі входи на одному пристрої
machine-input-without-register = вхід `{ $input }` блокування `{ $interlock }` не має регістра
machine-register-for-every-input = регістр для входу кожного блокування
machine-drives-taken = приводи вже має інший пристрій
machine-one-device-of-drives = один пристрій з `linuxcnc`, `steps`, `rtde`, `egm` або `rsi`
machine-robot-axis-twice = вісь `{ $axis }` названо двічі
machine-robot-axis-missing = вісь `{ $axis }` не має ланки системи керування роботом
machine-robot-axis-once = кожна вісь верстата один раз, у порядку ланок системи керування
machine-robot-axis-count = кількість осей ({ $n }) не відповідає ланкам системи керування роботом
machine-robot-axis-count-allowed = ланок руки: { $arm }, зовнішніх ланок: до { $external }
machine-robot-axis-linear = вісь `{ $axis }` лінійна, але це ланка руки
machine-robot-axis-rotary = перші { $arm } — поворотні осі
machine-robot-listen = це не IP-адреса з портом
machine-robot-listen-allowed = IP-адреса цього комп’ютера з портом, наприклад 0.0.0.0:6510
machine-robot-from = це не IP-адреса
machine-robot-from-allowed = IP-адреса системи керування, наприклад 192.168.125.1
machine-hal-file = `{ $file }` не є файлом HAL
machine-hal-file-allowed = шлях до файла, що закінчується на .hal, або без `hal`
machine-base-period = недопустимий період швидшого потоку: { $base }
machine-base-period-allowed = від 10 до 1000, ціле число разів у періоді { $period }, щонайменше двічі
machine-axis-name-long = назва осі `{ $axis }` задовга для HAL у LinuxCNC
machine-name-length = до { $max } символів

# Reasons why a pose is out of reach.
machine-unreachable-direction = поворотні осі не можуть так повернути пальник; найближчий напрям відрізняється на { $angle }
machine-unreachable-point = осі не досягають точки; бракує { $distance }
machine-unreachable-flat = за цих положень поворотних осей лінійні осі паралельні одній площині
machine-out-of-reach = поза досяжністю на { $distance }: вісь { $axis } була б на { $position }, на { $excess } за межею { $limit }
machine-axis-out-of-range = вісь { $axis } була б на { $position }, на { $excess } за межею { $limit }
machine-pair-axes = дві головки одночасно потребують трьох лінійних і трьох поворотних осей, що несуть обидві; сусідні осі не паралельні
machine-pair-same-point = обидва пальники в одній точці: спільної системи координат немає
machine-pair-opposed = пальники спрямовані один на одного: спільної системи координат немає

# Check of a machine: inverse kinematics and failures.
machine-method-closed = у замкненій формі
machine-method-plane-on-rotary = у замкненій формі, площина на поворотній осі
machine-method-in-plane = у замкненій формі, у площині
machine-method-numeric = чисельно (метод Ньютона)
machine-method-spherical-wrist = у замкненій формі, рука зі сферичним зап’ястям
machine-method-three-parallel = у замкненій формі, рука з трьома паралельними осями
machine-method-spherical-shoulder = у замкненій формі, рука зі сферичними плечем і зап’ястям
machine-free-roll = поворот навколо пальника
machine-linear-axes = лінійні: { $n } ({ $axes })
machine-rotary-axes = поворотні: { $n } ({ $axes })
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }: { $axes }
machine-structure-with-free = { $method }: { $axes }; надлишкові: { $free }
machine-check-head = головка { $head }: { $why }
machine-check-pair = обидві головки одночасно: { $why }
machine-check-round-trip = розбіжність зворотного розв’язку: { $distance } мм, { $angle }°, { $difference } в осі; поз без розв’язку: { $unsolved }, без власної гілки: { $missed }
machine-check-jacobian = якобіан відрізняється на { $difference } стовпця осі { $axis }

# Check of a machine: singular configurations.
machine-singular-linear = лінійні осі { $axes } лежать в одній площині: вістря не може з неї вийти
machine-singular-along-axis = пальник спрямований уздовж осі { $axis }: там { $axis } вільна
machine-singular-undone = { $axes } може скасувати рух осі { $axis }: там { $axis } вільна
machine-singular-parallel = осі { $first } і { $second } паралельні: одна скасовує іншу
machine-singular-tilt = пальник лежить у площині осей { $first } і { $second }: обидві нахиляють його однаково
machine-singular-undo = осі { $axes } скасовують одна одну
machine-singular-following = { $what }, при цьому рухається { $axes }
machine-singular-wrist = сингулярність зап’ястка: осі { $first } і { $second } паралельні
machine-singular-elbow = сингулярність ліктя: маніпулятор випростаний або складений
machine-singular-shoulder = сингулярність плеча: зап’ясток над віссю { $axis }
machine-singular-stretched = маніпулятор випростаний або складений: осі { $first } і { $second } рухають вістря однаково
machine-singular-tip-on-axis = вістря лежить на осі { $axis }, яка не може його рухати
machine-singular-direction = вістря не може рухатися вздовж ({ $x }, { $y }, { $z }) деталі
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }, за { $positions }
machine-singular-for-example = { $what }, наприклад за { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = контури положення працювали б кожні { $period }
machine-cure-period = задайте період у мс; зазвичай 1
machine-remark-displacement = переміщення довше за { $limit }
machine-cure-displacement = задавайте довжини в мм
machine-remark-no-shapes = верстат не має форм: зіткнення не перевіряються
machine-cure-no-shapes = додайте [[shapes.torch]] і так само для всього іншого, що може зіткнутися
machine-remark-home-collision = у вихідному положенні між { $first } і { $second } лише { $distance }, менше за мінімум { $min }
machine-cure-home-collision = змініть home_mm чи home_deg осі або форми
machine-remark-range-long = вісь { $axis } мала б хід { $travel }
machine-cure-range-long = задайте діапазон у мм
machine-remark-range-short = вісь { $axis } рухалася б лише на { $travel }
machine-cure-range-short = задайте діапазон у мм; можливо, малися на увазі метри
machine-remark-turns = вісь { $axis } робила б обертів: { $turns }
machine-cure-turns = задайте діапазон у градусах або continuous = true
machine-remark-range-narrow = вісь { $axis } поверталася б лише на { $travel }
machine-cure-range-narrow = задайте діапазон у градусах
machine-remark-range-quarter-turns = вісь { $axis } поверталася б лише на { $travel }; її межі є чвертями оберту в радіанах: від { $low } до { $high }
machine-remark-range-radians = вісь { $axis } поверталася б лише на { $travel }; у радіанах це було б від { $low } до { $high }
machine-cure-range-radians = задайте діапазон у градусах; залиште, якщо так і задумано
machine-remark-speed-high = { $speed } — швидше, ніж рухаються такі осі
machine-remark-speed-low = { $speed } — повільніше, ніж рухаються такі осі
machine-cure-linear-speed-high = задайте швидкість у мм/с; можливо, малися на увазі мм/хв
machine-cure-rotary-speed-high = задайте швидкість у °/с; можливо, малися на увазі °/хв
machine-cure-linear-speed-low = задайте швидкість у мм/с; можливо, малися на увазі м/с
machine-cure-rotary-speed-low = задайте швидкість у °/с; можливо, малися на увазі рад/с або об/хв
machine-remark-speed-unreached = вісь { $axis } ніколи її не досягне: розгін і гальмування потребують { $needed }, а її хід { $travel }
machine-cure-linear-speed-unreached = задайте швидкість у мм/с і прискорення в мм/с²
machine-cure-rotary-speed-unreached = задайте швидкість у °/с і прискорення в °/с²
machine-remark-acceleration-low = осі { $axis } треба { $time }, щоб досягти максимальної швидкості
machine-remark-acceleration-high = вісь { $axis } досягає максимальної швидкості за { $time }
machine-remark-gravity = прискорення в { $factor } g — більше, ніж витримують такі осі
machine-cure-linear-acceleration = задайте прискорення в мм/с²
machine-cure-rotary-acceleration = задайте прискорення в °/с²
machine-cure-linear-acceleration-low = задайте прискорення в мм/с²; можливо, малися на увазі м/с²
machine-cure-rotary-acceleration-low = задайте прискорення в °/с²; можливо, малися на увазі рад/с²
machine-remark-jerk-missing = вісь { $axis } не має обмеження ривка
machine-cure-jerk-missing = додайте { $key }; зазвичай удесятеро більше за прискорення
machine-remark-jerk-low = прискорення наростає { $time }
machine-cure-linear-jerk = задайте ривок у мм/с³
machine-cure-rotary-jerk = задайте ривок у °/с³
machine-remark-drive-missing = вісь { $axis } не має приводу: у симуляції взято припущений
machine-cure-drive-missing = додайте [drives.{ $axis }]
machine-remark-drive-weak = осі { $axis } для прискорення на максимальній швидкості треба { $needed }, разом із тертям
machine-cure-drive-weak = візьміть потужніший привід або зменште max_acceleration
machine-remark-drive-strong = привід у { $factor } раза потужніший, ніж треба навантазі
machine-cure-linear-drive-strong = задайте масу в кг і силу в Н
machine-cure-rotary-drive-strong = задайте момент інерції в кг·м² і крутний момент у Н·м
machine-remark-encoder = один відлік — це { $count }
machine-cure-linear-encoder = задайте кількість відліків на мм на осі
machine-cure-rotary-encoder = задайте кількість відліків на градус на осі
machine-remark-velocity-loop = { $bandwidth } — зависоко для контуру положення з періодом { $period }
machine-cure-velocity-loop = задайте смугу в Гц або коротший servo_period_ms
machine-remark-pitch = вісь { $axis } мала б похибку до { $error }
machine-cure-linear-pitch = задайте похибки в мм
machine-cure-rotary-pitch = задайте похибки в градусах

# Import of arms.
machine-urdf-not-xml = файл не є XML: { $why }
machine-urdf-cure-xml = Виправте XML тут або експортуйте файл знову.
machine-urdf-attribute-missing = елементу бракує атрибута `{ $name }`
machine-urdf-cure-attribute = Додайте до елемента `{ $name }="…"`.
machine-urdf-element-missing = в елементі немає `<{ $name }>`
machine-urdf-cure-element = Додайте до з’єднання `<{ $name } link="…"/>`.
machine-urdf-not-numbers = неприпустимі числа
machine-urdf-cure-numbers = Кількість чисел тут: { $n }, через пробіл, наприклад `0.1 0 0.25`.
machine-urdf-root = кореневий елемент — `{ $name }`, а не `robot`
machine-urdf-empty = у файлі немає ланок
machine-urdf-cure-root = Укажіть файл URDF: його корінь — `<robot>`, усередині — `<link>` і `<joint>`.
machine-urdf-xacro = у файлі є макроси xacro
machine-urdf-cure-xacro = Спочатку розкрийте макроси: `xacro robot.urdf.xacro > robot.urdf`.
machine-urdf-two-parents = ланка `{ $link }` уже закріплена на з’єднанні `{ $joint }`
machine-urdf-loop = ланка `{ $link }` входить до замкненого контуру
machine-urdf-cure-tree = Вилучіть одне зі з’єднань: кожну ланку несе одне з’єднання.
machine-urdf-name-taken = ім’я `{ $name }` трапляється двічі
machine-urdf-cure-name = Перейменуйте одне з двох.
machine-urdf-link-unknown = ланки `{ $link }` немає
machine-urdf-cure-link = Укажіть одну з ланок файлу.
machine-urdf-axis-zero = вісь не має напрямку
machine-urdf-cure-axis = Укажіть напрямок, наприклад `xyz="0 0 1"`.
machine-urdf-size = розмір не більший за 0
machine-urdf-cure-size = Укажіть розміри в метрах, більші за 0.
machine-urdf-roots = у файлі кілька ланок основи: { $links }
machine-urdf-cure-roots = Виберіть основу: `--base LINK`.
machine-urdf-tips = кількість кінців дерева, які рухають осі: { $n } ({ $links })
machine-urdf-cure-tips = Виберіть ланку, що несе пальник: `--tip LINK`.
machine-urdf-no-axes = жодна вісь не рухає ланку, закріплену на `{ $link }`
machine-urdf-cure-no-axes = Виберіть іншу основу (`--base LINK`) або зробіть з’єднання `revolute` чи `prismatic`.
machine-urdf-not-carried = основа `{ $base }` не несе ланку `{ $tip }`
machine-urdf-cure-not-carried = Виберіть інші `--base` або `--tip`.
machine-urdf-axes = кількість осей до ланки `{ $link }`: { $n }
machine-urdf-cure-axes = Виберіть `--base` і `--tip` так, щоб між ними було від 1 до { $max } осей.
machine-urdf-too-long = довжина ланцюга від основи до кінця — { $length }: для маніпулятора в метрах забагато
machine-urdf-too-short = довжина ланцюга від основи до кінця — { $length }: для маніпулятора в метрах замало
machine-urdf-cure-scale = URDF задають у метрах. Імпортуйте з `--scale { $factor }` або експортуйте файл у метрах.
machine-urdf-degrees = кути з’єднання `{ $joint }` задано не в радіанах
machine-urdf-cure-degrees = Запишіть межі в рад і рад/с: градуси, поділені на 57.29578.
machine-urdf-joint-type = тип з’єднання `{ $joint }` не є віссю
machine-urdf-cure-joint-type = Між основою та кінцем дозволено: `revolute`, `continuous`, `prismatic`, `fixed`.
machine-urdf-mimic = з’єднання `{ $joint }` повторює з’єднання `{ $other }`
machine-urdf-cure-mimic = Виберіть `--tip` перед цим з’єднанням, зробіть його `fixed` або вилучіть `<mimic>`, якщо воно має власний привод.
machine-urdf-limit-missing = з’єднання `{ $joint }` не має меж
machine-urdf-limit-empty = діапазон з’єднання `{ $joint }` порожній
machine-urdf-cure-limit = Напишіть `<limit lower="…" upper="…" velocity="…" effort="…"/>` у рад, рад/с і Н·м або в м, м/с і Н, як у паспорті.
machine-urdf-velocity = з’єднання `{ $joint }` не має найбільшої швидкості
machine-urdf-cure-velocity = Укажіть `velocity` з паспорта, у рад/с або м/с.
machine-urdf-mesh-missing = сітки `{ $mesh }` немає
machine-urdf-mesh-tried = файл в одному з місць: { $files }
machine-urdf-cure-mesh = Укажіть теку її пакета, `--package NAME=DIR`, або імпортуйте без тіл, `--no-shapes`.
machine-import-rounded-angles = кути джерела ({ $n }) — заокруглені кратні 15 градусів, як 1.5708; їх прочитано як точні
machine-import-flange = з кількох кінців ({ $links }) вибрано фланець `tool0`; `--tip` вибирає інший
machine-import-held = з’єднання поза ланцюгом лишаються в нулі: { $joints }
machine-import-no-shapes = тіл немає: зазори не перевіряються
machine-import-shape-kind = тіло ланки { $link } пропущено: `{ $kind }` — не паралелепіпед, циліндр, куля чи сітка
machine-import-mesh-format = сітку { $file } ланки { $link } пропущено: перетворіть її на STL
machine-import-mesh-unusable = сітку { $file } ланки { $link } пропущено: { $why }
machine-import-mesh-stretched = її масштаб уздовж x, y і z різний
