# Modes.
cell-mode-off = выключено
cell-mode-idle = без нуля
cell-mode-homing = поиск нуля
cell-mode-ready = готово
cell-mode-jog = ручное движение
cell-mode-teach = обучение
cell-mode-dry-run = холостой прогон
cell-mode-weld = сварка
cell-mode-hold = пауза
cell-mode-fault = авария

# Events that change the mode.
cell-trigger-switch-on = включить
cell-trigger-switch-off = выключить
cell-trigger-home = в ноль
cell-trigger-homed = нули найдены
cell-trigger-jog = ручное движение
cell-trigger-teach = обучение
cell-trigger-dry-run = холостой прогон
cell-trigger-weld = сварка
cell-trigger-hold = пауза
cell-trigger-finish = завершить
cell-trigger-abort = прервать
cell-trigger-trip = аварийное срабатывание
cell-trigger-reset = сбросить аварию
cell-refused = «{ $event }» невозможно в состоянии «{ $mode }»: разрешено в состояниях: { $modes }

# Commands.
cell-ask-switch-on = включить
cell-ask-switch-off = выключить
cell-ask-home = в ноль
cell-ask-home-axis = одну ось в исходное положение
cell-ask-start-jog = начать ручное движение
cell-ask-start-teach = начать обучение
cell-ask-jog = ручное движение
cell-ask-start-dry-run = начать холостой прогон
cell-ask-arm = разрешить дугу или луч
cell-ask-start-weld = начать сварку
cell-ask-hold = пауза
cell-ask-resume = дальше
cell-ask-reverse = реверс
cell-ask-stop = остановить
cell-ask-override = коррекция подачи { $override }
cell-ask-reset = сбросить аварию
cell-ask-acknowledge = подтвердить все тревоги
cell-ask-acknowledge-one = подтвердить одну тревогу
cell-ask-why = почему нет
cell-ask-load = загрузить программу
cell-ask-quit = завершить работу

# Missing permissives.
cell-missing-rest = оси ещё движутся: подождите
cell-missing-references = ноль оси { $axes } неизвестен: сначала «В ноль»
cell-missing-homes-first = сначала в ноль должна идти ось { $axis }, как задано в файле станка
cell-missing-power = у приводов ещё нет питания: подождите
cell-missing-answer = не отвечает: { $device }; проверьте кабель и устройство
cell-missing-interlock = условие блокировки «{ $interlock }» не выполнено
cell-missing-acknowledgement = тревога «{ $alarm }»: { $action }, затем подтвердите
cell-missing-arming = дуга или луч не разрешены: разрешите и начните в течение минуты
cell-missing-source = сварочный источник не готов
cell-missing-start = ось { $axis } не в начале подхода к шву
cell-missing-program = программа не загружена
cell-missing-value = число вне допустимых пределов
cell-missing-motion = это движение сейчас невозможно
cell-device-drives = приводы
cell-device-inputs = входы
cell-device-source = сварочный источник

# Events and notes of a weld.
cell-event-mode = { $from } → { $to }
cell-event-missed = пропущено циклов: { $n }, до { $gap } подряд
cell-event-pass-ends = проход { $pass } закончен на { $at }
cell-event-pass-left = проход { $pass } остановлен, сварено до { $at }
cell-event-without-rights = без прав реального времени: { $rights }
cell-right-priority = приоритет
cell-right-memory = заблокированная память
cell-right-cpu = процессор
cell-note-stopped = остановлено из-за: { $cause }
cell-note-left = остановлено в проходе { $pass }, сварено до { $at }
cell-note-not-finished = не сварено до конца
cell-note-nothing-welded = ничего не сварено
cell-shutdown-signal = сигнал { $signal }
cell-shutdown-panic = ошибка программы (panic)
cell-shutdown-end = завершение программы
cell-shutdown-cycle-stopped = цикл остановился и не возобновляется

# Real-time rights.
cell-realtime-granted = приоритет реального времени, память заблокирована
cell-realtime-degraded = с ограничениями: { $missing }
cell-realtime-no-priority = нет приоритета реального времени ({ $why }; разрешите через `ulimit -r` или CAP_SYS_NICE)
cell-realtime-memory-not-locked = память не заблокирована ({ $why }; разрешите через `ulimit -l` или CAP_IPC_LOCK)
cell-realtime-no-cpu = не на запрошенном процессоре ({ $why })
cell-no-such-cpu = процессора { $cpu } нет
cell-only-on-linux = только в Linux
cell-cycle-failed = сбой цикла (ошибка программы); устройствам приказано выключиться

# A cell that cannot run.
cell-invalid-drive = привод оси { $axis }: { $why }
cell-too-many-process-values =
    параметров процесса в программе: { $n }
       разрешено: до { $max }
cell-no-stepper = у оси нет шагового двигателя
cell-microsteps-too-coarse = самый мелкий шаг драйвера не даёт нужного разрешения

# Tracking.
cell-no-cross-slide = головка { $head } станка { $machine } не имеет крестового суппорта: двух собственных линейных осей
cell-no-stripe-sensor = станок { $machine } не имеет лазерно-полосового датчика для головки { $head }: слежению нужен датчик перед горелкой; разрешено [sensors.<name>] с kind = "stripe" в файле станка
cell-sensor-not-leading = датчик { $sensor } станка { $machine } не опережает головку { $head } на этом проходе: расстояние опережения меняется от { $min } до { $max }; разрешено постоянное в пределах десятой, как у датчика, который поворачивается со швом
cell-off-line-two-torches = проход «{ $pass }» с колебанием двух горелок: смещённую деталь можно симулировать, только если горелка идёт по линии шва; разрешён проход без скруглённых углов, с колебанием не более одной горелки, или без файла отклонений
cell-off-line-beam = проход «{ $pass }» с колебанием луча: смещённую деталь можно симулировать, только если луч идёт по линии шва; разрешён проход без скруглённых углов и без колебания, или без файла отклонений
cell-off-line-blends = проход «{ $pass }» имеет скруглённые углы: смещённую деталь можно симулировать, только если горелка идёт по линии шва; разрешён проход без скруглённых углов, с колебанием не более одной горелки, или без файла отклонений
cell-slides-aside = крестовый суппорт головки { $head } станка { $machine } не может смещать горелку во все стороны от этого шва; разрешены два [[heads.steps]], чьи `move` лежат поперёк шва в разных направлениях
cell-no-beam-camera = станок { $machine } не имеет камеры, которая смотрит через луч; разрешено [sensors.<name>] с kind = "camera" в файле станка
cell-no-replay = станок { $machine } не может воспроизвести сохранённые отклонения: у него нет отклоняемого луча; разрешены станки с torch.deflection в файле
cell-gun-not-carried = оси не могут сместить пушку вбок: { $why }
cell-alarm-with-cause = { $alarm }: { $cause }
cell-alarm-of-head = { $alarm }, головка { $head }
cell-joint-not-seen = стык не видели перед сваркой
cell-sighting-cut-short = движение, чтобы увидеть начало, сокращено
cell-sighting-length = { $clear } из { $wanted }, { $why }
cell-end-of-reach = оси на пределе досягаемости
cell-too-close = { $a } и { $b } слишком близко
cell-something-too-close = два тела слишком близко

# Distortion file.
cell-empty-range = пустой участок: от { $from } до { $to }
cell-allowed-range = `to` больше `from`
cell-no-head = такой головки нет
cell-allowed-heads = 1 или 2
cell-empty-displacement = смещение пустое
cell-turn-missing = нет оси для этого угла
cell-allowed-turn = turn = [x, y, z], ось

# Teaching.
cell-camera-out-of-reach = оси не могут привести туда камеру: остаётся { $remaining }
cell-no-points = точек нет; задайте хотя бы одну на стыке
cell-point-off-seam = точка { $point } дальше чем { $max } от номинального шва
cell-points-coincide = точки { $first } и { $second } в одном месте шва

# Frames of cameras.
cell-frame-io = { $what }: { $why }
cell-frames-missing =
    { $what }: { $why }
       разрешено: существующая папка кадров с frames.csv
cell-frame-list =
    { $file }:{ $line }: { $why }
       разрешено: { $allowed }
cell-frame-header =
    кадр { $frame }: неверное значение ({ $field }): { $found }
       разрешено: { $allowed }
cell-frame-magic = первые байты
cell-frame-version = версия
cell-frame-depth = глубина пикселя
cell-frame-width = ширина
cell-frame-height = высота
cell-frame-axes = количество осей
cell-frame-reserved = байты с 18 по 23
cell-frame-work-height = высота детали
cell-frame-position = положение оси
cell-frame-depth-allowed = 8 или 16 бит на пиксель
cell-frame-position-allowed = конечное число мм или градусов
cell-frame-work-height-allowed = конечное число мм или NaN
cell-frame-machine-axes = { $n }, оси станка
cell-frame-header-truncated = кадр { $frame }: поток заканчивается после { $found } из { $wanted } заголовка
cell-frame-axes-truncated = кадр { $frame }: поток заканчивается после { $found } из { $wanted } положений осей
cell-frame-pixels-truncated = кадр { $frame }: поток заканчивается после { $found } из { $wanted } пикселей
cell-frame-time = кадр { $frame }: неверное время { $time }; время должно быть конечным и возрастать
cell-frame-time-order = кадр { $frame }: неверное время { $time } после кадра в { $before }; время должно быть конечным и возрастать
cell-frame-shape = кадр { $frame }: { $why }
cell-frame-late = кадр { $frame } не пришёл вовремя
cell-frame-size = кадр имеет { $size } пикселей; разрешено: size_px датчика, { $allowed }
cell-camera-closed = камера закрыла соединение
cell-no-frame-in-time = ни один кадр не пришёл вовремя
cell-image-format = неизвестный формат изображения; разрешено: PNG, JPEG, PNM
cell-image-broken = не удалось прочитать изображение: { $why }
cell-jpeg-truncated = файл JPEG обрывается до конца изображения
cell-pixel-count = количество пикселей не соответствует изображению
cell-file-too-large = файл имеет { $size }; разрешено до { $max }
cell-list-no-text = это не текстовый файл
cell-list-columns = столбцы: { $columns }
cell-list-columns-allowed = { $columns }, по желанию { $optional }
cell-list-cells = ячеек: { $n }
cell-list-cells-allowed = { $n }, по одной на столбец
cell-list-file = неверное имя файла "{ $name }"
cell-list-file-allowed = имя изображения в этой папке
cell-list-number = { $column }: "{ $value }" не число
cell-list-time = t_s: { $time } не после { $before } в предыдущей строке
cell-list-time-allowed = возрастающее время
cell-list-empty = в списке нет кадров
cell-list-empty-allowed = одна строка на кадр

# Devices on Modbus.
cell-modbus-unreachable = устройство «{ $device }» по адресу { $address }: { $why }
cell-modbus-no-register = устройство «{ $device }» не имеет регистра, который задаёт параметр процесса «{ $value }» этого задания
cell-modbus-refused = устройство отклоняет { $what } ({ $code })
cell-modbus-registers = { $table } { $from }–{ $to }
cell-modbus-named = { $registers }: { $names }
cell-modbus-cells = { $table } { $at }: запрошено ячеек: { $asked }, получено: { $answered }
cell-modbus-no-connection = нет соединения в течение { $time }
cell-modbus-no-answer = нет ответа в течение { $time }
cell-modbus-no-heartbeat = нет сигнала жизни в течение { $time }
cell-modbus-closed = соединение закрыто
cell-modbus-not-connected = нет соединения
cell-modbus-second-connection = { $why }, на втором соединении; если устройство принимает только одно: connections = 1

# LinuxCNC's HAL.
cell-hal-not-installed =
    LinuxCNC не установлен: нет программы `{ $program }`
       разрешено: пакет Debian linuxcnc-uspace (apt install linuxcnc-uspace)
cell-hal-running =
    HAL LinuxCNC уже работает: { $owner }
       разрешено: только один одновременно; завершите другой или уберите его через `halrun -U`
cell-hal-of-seamwright = HAL Seamwright, процесс { $process }
cell-hal-foreign = HAL другой программы
cell-hal-refused = LinuxCNC не принимает { $file }: { $why }
cell-hal-own-commands = наши команды
cell-hal-too-slow = длится дольше { $time }; { $said }
cell-hal-no-start = HAL LinuxCNC не запускается: { $why }
cell-hal-no-samples = HAL LinuxCNC не работает, не присылает отсчётов: { $why }
cell-hal-output = { $sampler }; { $keeper }
cell-hal-no-output = нет вывода
cell-hal-not-run = HAL LinuxCNC не может работать: { $why }
cell-hal-refuses-root = HAL не принимает root, а пользователя `nobody` нет; запустите от другого пользователя
cell-hal-no-pipes = её потоки не имеют каналов
cell-hal-program-ended = { $program } завершилась
cell-hal-no-data = её программа реального времени ничего не присылает
cell-hal-ended = HAL LinuxCNC завершился: { $why }; перезапускается без питания
cell-hal-runs-again = HAL LinuxCNC снова работает: подтвердите, сбросьте, включите, «В ноль»
cell-hal-retried =
    { $error }
       новая попытка каждые { $time }

# Fault injection.
cell-fault-form = неверный отказ; разрешено DEVICE:KIND@TIME[+DURATION], как drives:silent@12.5 или inputs:disconnect@3+0.5
cell-fault-no-device = устройства «{ $name }» нет; разрешено { $names }
cell-fault-no-kind = отказа «{ $name }» нет; разрешено { $names }
cell-fault-no-time = неверное время «{ $text }»; разрешено число секунд, 0 или больше
cell-fault-injection-summary =
    { $kept } из { $all } случаев заканчиваются как требуется ({ $faults } аварией); процесс выключен не позднее чем через { $cycles ->
        [one] { $cycles } цикл
        [few] { $cycles } цикла
       *[other] { $cycles } циклов
    }; наибольший путь остановки { $stop }, не более { $bound } предела
cell-violation = { $time }: { $what }
cell-violation-no-restart = ячейку не удаётся включить снова
cell-violation-no-rest = оси не останавливаются
cell-violation-process-on = процесс включён в состоянии «{ $mode }»
cell-violation-process-after-alarm = процесс включён после тревоги
cell-violation-stop = путь остановки { $length }; разрешено { $max }
cell-violation-jump = ось { $axis }: заданное положение в { $distance } от действительного
cell-violation-limits = ось { $axis }: скорость { $speed }, ускорение { $acceleration } вне пределов
cell-program-damaged = программа пришла повреждённой: { $why }
cell-program-changed = { $job } или названный в нём файл изменён после планирования: загрузите снова
cell-program-panicked = поток ячейки завершился из-за ошибки программы
cell-socket = нет сокетов в { $folder }: { $why }
cell-already-runs = ячейка с сокетами в { $folder } уже работает
cell-no-process = процесс ячейки не запускается: { $why }
cell-process-ended-early = процесс ячейки завершился без сообщения
cell-process-silent = процесс ячейки не отвечал и был завершён
cell-process-signal = её процесс завершён сигналом { $signal }
cell-process-code = её процесс завершился с кодом { $code }
cell-safe-not-asked = запроса не было
cell-outputs-unconfirmed = устройство { $device }: безопасность выходов не подтверждена: { $why }
cell-record-not-saved = последние строки сварки { $weld } не записаны вовремя
cell-does-not-end = цикл не завершается: проверьте, что дуга, газ и приводы выключены
cell-program-too-large = запланированное движение занимает { $size }, больше допустимых { $max }

# Системы управления роботами, принимающие заданные положения.
cell-robot-unusable = устройство `{ $device }` ({ $protocol }), адрес { $address }: { $why }
cell-robot-lost = нет соединения: { $why }
cell-robot-port-in-use = этот порт занят другой программой
cell-robot-not-listening = этот компьютер не может принимать по этому адресу: { $why }
cell-robot-no-reports = система управления ничего не передаёт; запустите её программу и проверьте адрес получателя
cell-robot-closed = система управления закрыла соединение
cell-robot-malformed = система управления передаёт байты, которые не являются сообщением этого протокола
cell-robot-version = система управления отклоняет версию 2 RTDE
cell-robot-unknown-fields = система управления не знает { $fields }
cell-robot-fields-in-use = другая программа использует { $fields }
cell-robot-not-started = система управления не начинает передачу отчётов
cell-robot-joints = система управления сообщает о { $reported } звеньях, файлу станка нужно { $needed }
cell-robot-not-stopped = робот не подтвердил остановку
cell-robot-motors-off = двигатели робота выключены
cell-robot-protective-stop = защитная остановка робота
cell-robot-safeguard-stop = остановка робота защитным ограждением
cell-robot-emergency-stop = аварийная остановка робота
cell-robot-safety-fault = система безопасности робота сообщает о неисправности
cell-robot-program-stopped = программа в системе управления роботом не выполняется
cell-robot-other-program = в системе управления роботом выполняется другая программа
cell-robot-control-error = интерфейс движения системы управления роботом сообщает об ошибке
cell-robot-starved = роботу не хватило заданных положений
cell-robot-jump = заданное положение слишком далеко от положения робота
cell-robot-disconnected = соединение с роботом потеряно
