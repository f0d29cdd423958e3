# Modes.
cell-mode-off = вимкнено
cell-mode-idle = без нуля
cell-mode-homing = пошук нуля
cell-mode-ready = готово
cell-mode-jog = ручний рух
cell-mode-teach = навчання
cell-mode-dry-run = холостий прогін
cell-mode-weld = зварювання
cell-mode-hold = пауза
cell-mode-fault = аварія

# Events that change the mode.
cell-trigger-switch-on = увімкнути
cell-trigger-switch-off = вимкнути
cell-trigger-home = у нуль
cell-trigger-homed = нулі знайдено
cell-trigger-jog = ручний рух
cell-trigger-teach = навчання
cell-trigger-dry-run = холостий прогін
cell-trigger-weld = зварювання
cell-trigger-hold = пауза
cell-trigger-finish = завершити
cell-trigger-abort = перервати
cell-trigger-trip = аварійне спрацювання
cell-trigger-reset = скинути аварію
cell-refused = «{ $event }» неможливо в стані «{ $mode }»: дозволено у станах: { $modes }

# Commands.
cell-ask-switch-on = увімкнути
cell-ask-switch-off = вимкнути
cell-ask-home = у нуль
cell-ask-home-axis = одну вісь у вихідне положення
cell-ask-start-jog = почати ручний рух
cell-ask-start-teach = почати навчання
cell-ask-jog = ручний рух
cell-ask-start-dry-run = почати холостий прогін
cell-ask-arm = дозволити дугу чи промінь
cell-ask-start-weld = почати зварювання
cell-ask-hold = пауза
cell-ask-resume = далі
cell-ask-reverse = реверс
cell-ask-stop = зупинити
cell-ask-override = корекція подачі { $override }
cell-ask-reset = скинути аварію
cell-ask-acknowledge = підтвердити всі тривоги
cell-ask-acknowledge-one = підтвердити одну тривогу
cell-ask-why = чому ні
cell-ask-load = завантажити програму
cell-ask-quit = завершити роботу

# Missing permissives.
cell-missing-rest = осі ще рухаються: зачекайте
cell-missing-references = нуль осі { $axes } невідомий: спершу «У нуль»
cell-missing-homes-first = спершу має піти в нуль вісь { $axis }, як задано у файлі верстата
cell-missing-power = приводи ще не мають живлення: зачекайте
cell-missing-answer = не відповідає: { $device }; перевірте кабель і пристрій
cell-missing-interlock = умову блокування «{ $interlock }» не виконано
cell-missing-acknowledgement = тривога «{ $alarm }»: { $action }, потім підтвердьте
cell-missing-arming = дугу чи промінь не дозволено: дозвольте й почніть протягом хвилини
cell-missing-source = джерело процесу не готове
cell-missing-start = вісь { $axis } не на початку підходу до шва
cell-missing-program = програму не завантажено
cell-missing-value = число поза дозволеними межами
cell-missing-motion = цей рух зараз неможливий
cell-device-drives = приводи
cell-device-inputs = входи
cell-device-source = джерело процесу

# Events and notes of a weld.
cell-event-mode = { $from } → { $to }
cell-event-missed = пропущено циклів: { $n }, до { $gap } поспіль
cell-event-pass-ends = прохід { $pass } закінчено на { $at }
cell-event-pass-left = прохід { $pass } зупинено, зварено до { $at }
cell-event-without-rights = без прав реального часу: { $rights }
cell-right-priority = пріоритет
cell-right-memory = заблокована пам’ять
cell-right-cpu = процесор
cell-note-stopped = зупинено через: { $cause }
cell-note-left = зупинено в проході { $pass }, зварено до { $at }
cell-note-not-finished = не зварено до кінця
cell-note-nothing-welded = нічого не зварено
cell-shutdown-signal = сигнал { $signal }
cell-shutdown-panic = помилка програми (panic)
cell-shutdown-end = завершення програми
cell-shutdown-cycle-stopped = цикл зупинився й не відновлюється

# Real-time rights.
cell-realtime-granted = пріоритет реального часу, пам’ять заблоковано
cell-realtime-degraded = з обмеженнями: { $missing }
cell-realtime-no-priority = немає пріоритету реального часу ({ $why }; дозвольте через `ulimit -r` або CAP_SYS_NICE)
cell-realtime-memory-not-locked = пам’ять не заблоковано ({ $why }; дозвольте через `ulimit -l` або CAP_IPC_LOCK)
cell-realtime-no-cpu = не на замовленому процесорі ({ $why })
cell-no-such-cpu = процесора { $cpu } немає
cell-only-on-linux = лише в Linux
cell-cycle-failed = збій циклу (помилка програми); пристроям наказано вимкнутися

# A cell that cannot run.
cell-invalid-drive = привід осі { $axis }: { $why }
cell-too-many-process-values =
    параметрів процесу в програмі: { $n }
       дозволено: до { $max }
cell-no-stepper = вісь не має крокового двигуна
cell-microsteps-too-coarse = найдрібніший крок драйвера не дає потрібної роздільності

# Tracking.
cell-no-cross-slide = головка { $head } верстата { $machine } не має хрестового супорта: двох власних лінійних осей
cell-no-stripe-sensor = верстат { $machine } не має лазерно-смугового давача для головки { $head }: стеженню потрібен давач перед пальником; дозволено [sensors.<name>] з kind = "stripe" у файлі верстата
cell-sensor-not-leading = давач { $sensor } верстата { $machine } не випереджає головку { $head } на цьому проході: відстань випередження змінюється від { $min } до { $max }; дозволено сталу в межах десятої, як у давача, що повертається зі швом
cell-off-line-two-torches = прохід «{ $pass }» з коливанням двох пальників: зміщену деталь можна симулювати, лише якщо пальник іде лінією шва; дозволено прохід без скруглених кутів, з коливанням щонайбільше одного пальника, або без файлу відхилень
cell-off-line-beam = прохід «{ $pass }» з коливанням променя: зміщену деталь можна симулювати, лише якщо промінь іде лінією шва; дозволено прохід без скруглених кутів і без коливання, або без файлу відхилень
cell-off-line-blends = прохід «{ $pass }» має скруглені кути: зміщену деталь можна симулювати, лише якщо пальник іде лінією шва; дозволено прохід без скруглених кутів, з коливанням щонайбільше одного пальника, або без файлу відхилень
cell-slides-aside = хрестовий супорт головки { $head } верстата { $machine } не може зміщувати пальник в усі боки від цього шва; дозволено два [[heads.steps]], чиї `move` лежать поперек шва в різних напрямах
cell-no-beam-camera = верстат { $machine } не має камери, що дивиться крізь промінь; дозволено [sensors.<name>] з kind = "camera" у файлі верстата
cell-no-replay = верстат { $machine } не може відтворити збережені відхилення: у нього немає відхилюваного променя; дозволено верстати з torch.deflection у файлі
cell-gun-not-carried = осі не можуть змістити гармату вбік: { $why }
cell-alarm-with-cause = { $alarm }: { $cause }
cell-alarm-of-head = { $alarm }, головка { $head }
cell-joint-not-seen = стик не бачили перед зварюванням
cell-sighting-cut-short = рух, щоб побачити початок, скорочено
cell-sighting-length = { $clear } з { $wanted }, { $why }
cell-end-of-reach = осі на межі досяжності
cell-too-close = { $a } і { $b } надто близько
cell-something-too-close = два тіла надто близько

# Distortion file.
cell-empty-range = порожня ділянка: від { $from } до { $to }
cell-allowed-range = `to` більше за `from`
cell-no-head = такої головки немає
cell-allowed-heads = 1 або 2
cell-empty-displacement = зміщення порожнє
cell-turn-missing = бракує осі для цього кута
cell-allowed-turn = turn = [x, y, z], вісь

# Teaching.
cell-camera-out-of-reach = осі не можуть привести туди камеру: залишається { $remaining }
cell-no-points = точок немає; задайте принаймні одну на стику
cell-point-off-seam = точка { $point } далі ніж { $max } від номінального шва
cell-points-coincide = точки { $first } і { $second } в одному місці шва

# Frames of cameras.
cell-frame-io = { $what }: { $why }
cell-frames-missing =
    { $what }: { $why }
       дозволено: наявна тека кадрів із frames.csv
cell-frame-list =
    { $file }:{ $line }: { $why }
       дозволено: { $allowed }
cell-frame-header =
    кадр { $frame }: неправильне значення ({ $field }): { $found }
       дозволено: { $allowed }
cell-frame-magic = перші байти
cell-frame-version = версія
cell-frame-depth = глибина пікселя
cell-frame-width = ширина
cell-frame-height = висота
cell-frame-axes = кількість осей
cell-frame-reserved = байти з 18 по 23
cell-frame-work-height = висота деталі
cell-frame-position = положення осі
cell-frame-depth-allowed = 8 або 16 біт на піксель
cell-frame-position-allowed = скінченне число мм або градусів
cell-frame-work-height-allowed = скінченне число мм або NaN
cell-frame-machine-axes = { $n }, осі верстата
cell-frame-header-truncated = кадр { $frame }: потік закінчується після { $found } з { $wanted } заголовка
cell-frame-axes-truncated = кадр { $frame }: потік закінчується після { $found } з { $wanted } положень осей
cell-frame-pixels-truncated = кадр { $frame }: потік закінчується після { $found } з { $wanted } пікселів
cell-frame-time = кадр { $frame }: неправильний час { $time }; час має бути скінченним і зростати
cell-frame-time-order = кадр { $frame }: неправильний час { $time } після кадру в { $before }; час має бути скінченним і зростати
cell-frame-shape = кадр { $frame }: { $why }
cell-frame-late = кадр { $frame } не прийшов вчасно
cell-frame-size = кадр має { $size } пікселів; дозволено: size_px давача, { $allowed }
cell-camera-closed = камера закрила з’єднання
cell-no-frame-in-time = жоден кадр не прийшов вчасно
cell-image-format = невідомий формат зображення; дозволено: PNG, JPEG, PNM
cell-image-broken = не вдалося прочитати зображення: { $why }
cell-jpeg-truncated = файл JPEG обривається до кінця зображення
cell-pixel-count = кількість пікселів не відповідає зображенню
cell-file-too-large = файл має { $size }; дозволено до { $max }
cell-list-no-text = це не текстовий файл
cell-list-columns = стовпці: { $columns }
cell-list-columns-allowed = { $columns }, за бажанням { $optional }
cell-list-cells = комірок: { $n }
cell-list-cells-allowed = { $n }, по одній на стовпець
cell-list-file = неправильне ім’я файлу "{ $name }"
cell-list-file-allowed = ім’я зображення в цій теці
cell-list-number = { $column }: "{ $value }" не число
cell-list-time = t_s: { $time } не після { $before } у попередньому рядку
cell-list-time-allowed = час, що зростає
cell-list-empty = у переліку немає кадрів
cell-list-empty-allowed = один рядок на кадр

# Devices on Modbus.
cell-modbus-unreachable = пристрій «{ $device }» за адресою { $address }: { $why }
cell-modbus-no-register = пристрій «{ $device }» не має регістра, що задає параметр процесу «{ $value }» цього завдання
cell-modbus-refused = пристрій відхиляє { $what } ({ $code })
cell-modbus-registers = { $table } { $from }–{ $to }
cell-modbus-named = { $registers }: { $names }
cell-modbus-cells = { $table } { $at }: запитано комірок: { $asked }, отримано: { $answered }
cell-modbus-no-connection = немає з’єднання протягом { $time }
cell-modbus-no-answer = немає відповіді протягом { $time }
cell-modbus-no-heartbeat = немає сигналу життя протягом { $time }
cell-modbus-closed = з’єднання закрито
cell-modbus-not-connected = немає з’єднання
cell-modbus-second-connection = { $why }, на другому з’єднанні; якщо пристрій приймає лише одне: connections = 1

# LinuxCNC's HAL.
cell-hal-not-installed =
    LinuxCNC не встановлено: немає програми `{ $program }`
       дозволено: пакунок Debian linuxcnc-uspace (apt install linuxcnc-uspace)
cell-hal-running =
    HAL LinuxCNC уже працює: { $owner }
       дозволено: лише один водночас; завершіть інший або приберіть його через `halrun -U`
cell-hal-of-seamwright = HAL Seamwright, процес { $process }
cell-hal-foreign = HAL іншої програми
cell-hal-refused = LinuxCNC не приймає { $file }: { $why }
cell-hal-own-commands = наші команди
cell-hal-too-slow = триває довше ніж { $time }; { $said }
cell-hal-no-start = HAL LinuxCNC не запускається: { $why }
cell-hal-no-samples = HAL LinuxCNC не працює, не надсилає відліків: { $why }
cell-hal-output = { $sampler }; { $keeper }
cell-hal-no-output = немає виводу
cell-hal-not-run = HAL LinuxCNC не може працювати: { $why }
cell-hal-refuses-root = HAL не приймає root, а користувача `nobody` немає; запустіть від іншого користувача
cell-hal-no-pipes = її потоки не мають каналів
cell-hal-program-ended = { $program } завершилася
cell-hal-no-data = її програма реального часу нічого не надсилає
cell-hal-ended = HAL LinuxCNC завершився: { $why }; перезапускається без живлення
cell-hal-runs-again = HAL LinuxCNC знову працює: підтвердьте, скиньте, увімкніть, «У нуль»
cell-hal-retried =
    { $error }
       нова спроба кожні { $time }

# Fault injection.
cell-fault-form = неправильна відмова; дозволено DEVICE:KIND@TIME[+DURATION], як drives:silent@12.5 чи inputs:disconnect@3+0.5
cell-fault-no-device = пристрою «{ $name }» немає; дозволено { $names }
cell-fault-no-kind = відмови «{ $name }» немає; дозволено { $names }
cell-fault-no-time = неправильний час «{ $text }»; дозволено число секунд, 0 або більше
cell-fault-injection-summary =
    { $kept } з { $all } випадків закінчуються як належить ({ $faults } аварією); процес вимкнено щонайпізніше за { $cycles ->
        [one] { $cycles } цикл
        [few] { $cycles } цикли
       *[other] { $cycles } циклів
    }; найдовший шлях зупинки { $stop }, щонайбільше { $bound } межі
cell-violation = { $time }: { $what }
cell-violation-no-restart = комірку не вдається увімкнути знову
cell-violation-no-rest = осі не зупиняються
cell-violation-process-on = процес увімкнено у стані «{ $mode }»
cell-violation-process-after-alarm = процес увімкнено після тривоги
cell-violation-stop = шлях зупинки { $length }; дозволено { $max }
cell-violation-jump = вісь { $axis }: задане положення за { $distance } від дійсного
cell-violation-limits = вісь { $axis }: швидкість { $speed }, прискорення { $acceleration } поза межами
cell-program-damaged = програма надійшла пошкодженою: { $why }
cell-program-changed = { $job } або названий у ньому файл змінено після планування: завантажте знову
cell-program-panicked = потік комірки завершився через помилку програми
cell-socket = немає сокетів у { $folder }: { $why }
cell-already-runs = комірка із сокетами в { $folder } вже працює
cell-no-process = процес комірки не запускається: { $why }
cell-process-ended-early = процес комірки завершився без повідомлення
cell-process-silent = процес комірки не відповідав і був завершений
cell-process-signal = її процес завершено сигналом { $signal }
cell-process-code = її процес завершився з кодом { $code }
cell-safe-not-asked = запиту не було
cell-outputs-unconfirmed = пристрій { $device }: безпечність виходів не підтверджено: { $why }
cell-record-not-saved = останні рядки зварювання { $weld } не записано вчасно
cell-does-not-end = цикл не завершується: перевірте, що дугу, газ і приводи вимкнено
cell-program-too-large = заплановане переміщення займає { $size }, більше за дозволені { $max }

# Системи керування роботами, що приймають задані положення.
cell-robot-unusable = пристрій `{ $device }` ({ $protocol }), адреса { $address }: { $why }
cell-robot-lost = немає з’єднання: { $why }
cell-robot-port-in-use = цей порт зайнятий іншою програмою
cell-robot-not-listening = цей комп’ютер не може приймати за цією адресою: { $why }
cell-robot-no-reports = система керування нічого не передає; запустіть її програму й перевірте адресу отримувача
cell-robot-closed = система керування закрила з’єднання
cell-robot-malformed = система керування передає байти, які не є повідомленням цього протоколу
cell-robot-version = система керування відхиляє версію 2 RTDE
cell-robot-unknown-fields = система керування не знає { $fields }
cell-robot-fields-in-use = інша програма використовує { $fields }
cell-robot-not-started = система керування не починає передавати звіти
cell-robot-joints = система керування повідомляє про { $reported } ланок, файлу верстата потрібно { $needed }
cell-robot-not-stopped = робот не підтвердив зупинку
cell-robot-motors-off = двигуни робота вимкнено
cell-robot-protective-stop = захисна зупинка робота
cell-robot-safeguard-stop = зупинка робота захисною огорожею
cell-robot-emergency-stop = аварійна зупинка робота
cell-robot-safety-fault = система безпеки робота повідомляє про несправність
cell-robot-program-stopped = програма в системі керування роботом не виконується
cell-robot-other-program = у системі керування роботом виконується інша програма
cell-robot-control-error = інтерфейс руху системи керування роботом повідомляє про помилку
cell-robot-starved = роботу забракло заданих положень
cell-robot-jump = задане положення надто далеко від положення робота
cell-robot-disconnected = з’єднання з роботом втрачено
