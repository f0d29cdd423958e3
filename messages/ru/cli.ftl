# Notes and errors of every command.
cli-more-time = { $cure }; больше времени: --time-limit S
cli-verb-renamed = примечание: `seamwright { $former }` теперь называется `seamwright { $present }`
cli-unknown-language = примечание: языка `{ $language }` нет, поэтому по-английски; доступны: { $known }
cli-error = ошибка: { $error }
cli-option = { $option }: { $fault }
cli-not-allowed = недопустимое значение
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = от { $from } до { $to }
cli-plus = +{ $value }
cli-wrote = записано { $files }
cli-no-such-axis = такой оси нет
cli-cycle-ended-early = поток цикла завершился преждевременно
cli-jobs-unreadable = не все задания удалось прочитать
cli-no-notices = лицензий сторонних пакетов в этой программе нет: { $why }
cli-at-least-two = не меньше двух
cli-standard-input = стандартный ввод

# Progress.
cli-progress-planning = планирование
cli-progress-rows = строки
cli-schedule-done = { $weldable } из { $rows } строк можно сварить как задано; { $kept } не планировались заново
cli-progress-draws = выборки
cli-study-done = { $draws } выборок { $job } на { $machine }; { $kept } планов взято из прежнего запуска
cli-study-weldable = можно сварить: { $percent } % (95-%-ный интервал от { $low } до { $high } %)
cli-study-first-error = первая ошибка: { $error }
cli-progress-pass = проход { $pass } из { $passes }: { $stage }
cli-progress-simulating = сварка в симуляции
cli-progress-machine = проверка станка
cli-progress-tuning = настройка осей
cli-progress-cycles = циклы
cli-progress-pulses = импульсы
cli-progress-set-points = заданные значения
cli-progress-teaching = обучение
cli-progress-faults = отказы
cli-progress-frames = смоделированные кадры
cli-progress-welds = смоделированные сварки

# Labels of the summary of a weld.
cli-label-machine = станок
cli-label-seam = шов
cli-label-speed = скорость
cli-label-time = время
cli-label-energy = энергия
cli-label-clearance = зазор
cli-label-passes = проходы
cli-label-pass = проход { $pass }
cli-label-takes = расход
cli-label-waits = ожидание
cli-label-duty = дуга
cli-label-cost = стоимость
cli-label-transfers = холостые ходы
cli-label-wrote = записано
cli-label-welded = сварено
cli-label-path-error = ошибка пути
cli-label-tip-speed = скорость TCP
cli-label-axis = ось { $axis }

# Summary of a weld.
cli-summary-seam = { $length }, сваривается { $weld }
cli-summary-takes-energy = { $energy } энергии дуги
cli-summary-takes-wire = { $wire } проволоки
cli-summary-takes-metal = { $mass } металла шва
cli-summary-takes-gas = { $gas } газа
cli-summary-takes-flux = { $mass } флюса
cli-summary-waits = { $time } между проходами, пока шов остынет
cli-summary-duty = { $part } времени, { $duty } худших 10 минут
cli-summary-cost = { $total } { $currency }
cli-summary-cost-incomplete = { $total } { $currency }, без: { $without }
cli-summary-transfers = { $time }, от исходного положения до исходного { $total }
cli-summary-speed = от { $from } до { $to } запланировано, от { $asked-from } до { $asked-to } задано
cli-summary-time = { $travel } движения, { $arc } с дугой, { $total } всего
cli-summary-passes = { $passes }, { $length } всего
cli-summary-clearance = зазор { $clearance }
cli-summary-arc-energy = погонная энергия дуги { $energy }
cli-summary-heat-input = тепловложение { $heat }
cli-clearance-between = { $distance }: { $first } и { $second }
cli-clearance-none = { $distance }: ничто из контролируемого не подходит ближе
cli-summary-not-welded = ничего (симуляция)
cli-summary-path-error = { $max } максимум, { $rms } RMS (симуляция)
cli-summary-tip-speed = от { $from } до { $to }, RMS-отклонение { $rms } (симуляция)
cli-summary-too-short = сварка слишком коротка для оценки
cli-summary-following-error = ошибка слежения { $error }, RMS { $rms }
cli-summary-tracked = { $p99 } от стыка на 99 % сварки, не больше { $max }; без слежения { $plain-p99 } и { $plain-max }
cli-summary-untracked = { $p99 } от стыка на 99 % сварки, не больше { $max }; без слежения
cli-summary-stopped = остановлено на { $at }
cli-summary-alarm = на { $at }: { $alarm }
cli-summary-beam = отклонено до { $deflection } из { $range }, пушка перемещена на { $carried }; луч отведён { $away } времени, дольше всего { $longest }
cli-summary-beam-replayed = по записи: { $beam }
cli-summary-beam-fit = { $beam }; 90 % из { $points ->
        [one] { $points } точки
        [few] { $points } точек
       *[many] { $points } точек
    } в пределах { $distance } от сохранённых отклонений

# Positions along the seam.
cli-no-such-angle = у этого шва нет такого угла
cli-angle-not-welded = этот угол не на свариваемой части
cli-too-many-points = слишком много точек
cli-at-least-step = не меньше { $step }: { $points } точек
cli-section-no-joint = в задании нет стыка, поэтому нет и сечения
cli-section-joint = [joint] с его подготовкой

# Lists.
cli-list-machine = станок
cli-list-axes = оси
cli-list-example = пример
cli-list-procedure = WPS
cli-list-process = процесс
cli-list-title = название
cli-no-machine = { $name }: такого станка нет
cli-no-example = { $name }: такого примера нет
cli-no-procedure = { $name }: такой WPS нет

# Lateness of the cycle.
cli-latency-cycles = { $cycles ->
        [one] { $cycles } цикл
        [few] { $cycles } цикла
       *[many] { $cycles } циклов
    } по { $period }, { $missed } пропущено
cli-latency-late = { $part } начинаются с опозданием до { $late }

# Moves from point to point.
cli-motions-up-to-two-hours = движения до двух часов
cli-move-set-points = { $count } заданных значений
cli-longer-period = до { $max }, с более длинным периодом
cli-move-done = { $time }, { $count ->
        [one] { $count } заданное значение
        [few] { $count } заданных значения
       *[many] { $count } заданных значений
    }; { $clearance }
cli-axis-value-of = ОСЬ=ЗНАЧЕНИЕ с осью { $axes }
cli-any-number-of = любое число { $unit }
cli-axis-twice = ось { $axis } задана дважды
cli-each-axis-once = каждая ось один раз
cli-axis-position-not-a-number = положение оси { $axis } — не число
cli-axis-outside = вне диапазона оси { $axis }
cli-move-no-shapes = без проверки столкновений: в файле станка нет тел, которые могли бы столкнуться
cli-move-min-distance = наименьшее расстояние { $distance } на { $time }: { $first } и { $second }
cli-move-clear = ничто не подходит ближе чем на { $distance }
cli-move-impossible = движение невозможно, как задано: { $findings ->
        [one] { $findings } замечание
        [few] { $findings } замечания
       *[many] { $findings } замечаний
    }
cli-move-times = t = от { $from } до { $to }
cli-move-in-parts = обойдите препятствие несколькими движениями

# Part programs.
cli-as-far-as-axes-reach = расстояние, которого достигают оси
cli-post-differs = управляющая программа отличается от плана и не записана:
cli-too-coarse = слишком грубо
cli-finer-than-decimals = мельче шести десятичных знаков слов
cli-no-such-blocks = в этой системе управления нет таких кадров
cli-interpolations = pvt, spline1, linear для PMAC; linear, poly для Sinumerik; linear для LinuxCNC и grblHAL
cli-too-far = слишком далеко
cli-up-to-pass-tolerance = до { $max }, допуск прохода
cli-import = { $file }: программа { $dialect }, { $moves ->
        [one] { $moves } движение
        [few] { $moves } движения
       *[many] { $moves } движений
    }, { $time } по её подачам; проходы: { $passes }
cli-import-left-out = пропущено: { $place }: { $words }: { $why }

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = исправьте строку или удалите из файла столбец, который не является осью
cli-cure-line-in-mm = исправьте строку; координаты в мм
cli-cure-line-per-point = одна строка чисел на точку, под строкой заголовков
cli-too-far-away = слишком далеко
cli-points-found = { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точек
    }
cli-reduced = { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точек
    }; отрезки: { $lines }, дуги: { $arcs }; наибольшая погрешность { $error }; наименьшее число участков: { $min }
cli-not-a-point = не точка
cli-point-form = x,y в мм, например { $example }
cli-too-many-to-draw = у { $method } больше { $max } точек для чертежа
cli-coarser-or-no-drawing = более грубый импульс или более длинный период, или без чертежа

# Edits of a program file.
cli-edit-no-operation = операция не задана, или задано несколько
cli-edit-operations = одна операция, undo, redo, history или --script OPS.json; см. `seamwright edit --help`
cli-edit-new-history = примечание: { $file } изменён вручную после последней правки: начинается новая история
cli-edit-of-operation = операция { $number }: { $why }
cli-edit-job = { $file }: это задание; редактируют программы
cli-edit-plan-first = сначала спланируйте: seamwright plan { $file }; затем редактируйте { $program }
cli-edit-by-hand = { $file }: файл изменён вручную после последней правки
cli-edit-force = --force, насколько возможно
cli-edit-nothing-to-undo = { $file }: нечего отменять
cli-edit-nothing-to-redo = { $file }: нечего повторять
cli-edit-see-history = см. `history`
cli-edit-undone = отменено: { $edit }
cli-edit-redone = повторено: { $edit }
cli-edit-unchanged = { $edit } (ничего не изменено)
cli-edit-undone-entry = { $edit } (отменено)
cli-edit-by-hand-since = файл с тех пор изменён вручную
cli-edit-none = правок нет
cli-edit-value = одно число, или два для линейного изменения
cli-edit-see-schema = см. `seamwright schema operation`

# Records of welds.
cli-no-data-folder = нет папки данных
cli-data-folder = --data DIR или SEAMWRIGHT_DATA
cli-record-backup = { $file }: { $size } МБ
cli-record-restored = { $folder }: восстановлено; проверьте: `seamwright records verify`
cli-recovered = сварка { $weld } ({ $part }): восстановлено { $rows ->
        [one] { $rows } строка
        [few] { $rows } строки
       *[many] { $rows } строк
    }, { $result }
cli-recovered-unread = сварка { $weld } ({ $part }): восстановлено { $rows ->
        [one] { $rows } строка
        [few] { $rows } строки
       *[many] { $rows } строк
    }, { $unread } в конце не прочитано, { $result }
cli-nothing-to-recover = нечего восстанавливать
cli-recorded = записано: сварка { $weld }
cli-record-weld-note = примечание: сварка { $weld }: { $note }
cli-record-heading = сварка { $weld }: { $title }
cli-label-part = деталь
cli-label-result = результат
cli-label-begun = начало
cli-label-ended = конец
cli-label-welder = сварщик
cli-label-procedure = WPS
cli-label-job = задание
cli-label-program = программа
cli-label-heat-input = тепловложение
cli-label-deviation = отклонение
cli-label-note = примечание
cli-label-alarm = тревога
cli-label-event = событие
cli-label-file = файл
cli-record-simulated = { $result }, симуляция
cli-record-version = { $name }, версия { $version }
cli-record-heat-input = от { $min } до { $max }, среднее { $mean }
cli-record-deviation = не больше { $max }, на s = { $at }
cli-record-value = { $name } от { $from } до { $to }
cli-record-value-allowed = { $value } (разрешено от { $min } до { $max })
cli-record-value-outside = { $value } (разрешено от { $min } до { $max }, вне пределов { $time })
cli-record-with-cause = { $alarm }: { $cause }
cli-record-at = { $alarm } на s = { $at }
cli-record-file = { $file }, { $size }, SHA-256 { $hash }
cli-record-table = { $file }, { $size }, { $rows ->
        [one] { $rows } строка
        [few] { $rows } строки
       *[many] { $rows } строк
    }, SHA-256 { $hash }
cli-verified = { $welds ->
        [one] { $welds } сварка
        [few] { $welds } сварки
       *[many] { $welds } сварок
    }, { $files ->
        [one] { $files } файл
        [few] { $files } файла
       *[many] { $files } файлов
    } как записано, { $entries ->
        [one] { $entries } запись аудита
        [few] { $entries } записи аудита
       *[many] { $entries } записей аудита
    }: всё в порядке
cli-verified-problems = { $welds ->
        [one] { $welds } сварка
        [few] { $welds } сварки
       *[many] { $welds } сварок
    }, { $files ->
        [one] { $files } файл
        [few] { $files } файла
       *[many] { $files } файлов
    } как записано, { $entries ->
        [one] { $entries } запись аудита
        [few] { $entries } записи аудита
       *[many] { $entries } записей аудита
    }: есть нарушения
cli-problem = нарушение: { $problem }

# Position of the work in the machine.
cli-place-more-points = больше точек, распределённых по измеренным элементам, или другой --method
cli-place-side-unknown = неизвестно, с какой стороны щуп коснулся отдельной точки
cli-place-radius-with-three-points = 0 для three-point, или другой --method
cli-place-undetermined = точки не определяют положение детали
cli-place-no-seam = в программе нет шва, поверхности которого могли быть измерены
cli-place-no-nozzle = у шва нет патрубка, поэтому нет и биения
cli-place-nozzle = [seam.nozzle], или другой --method
cli-place-no-redundancy = точек не больше, чем неизвестных: ошибочная точка не обнаружится
cli-place-radius-unknown = точки не определяют радиус: взят номинальный
cli-place-radius-off = радиус отличается от номинального на { $deviation }: проверьте трубу и щуп
cli-place-no-rotary-axis = у станка нет поворотной оси вокруг номинальной оси патрубка: биение отсчитано от номинальной оси
cli-place-unchangeable = { $file }: не удалось изменить: { $why }
cli-place-touch-again = остаток больше { $max }: измерьте точки снова; стороны показывают, какая ошибочна. Если деталь не лучше, разрешите больше через --largest-mm
cli-place-touch-again-round = остаток больше { $max }: измерьте снова точки с наибольшими остатками и проверьте, круглая ли труба. Если деталь не лучше, разрешите больше через --largest-mm
cli-place-touch-again-features = остаток больше { $max }: измерьте снова точки с наибольшими остатками; проверьте их элементы, радиус щупа и примерное положение детали в задании. Если деталь не лучше, разрешите больше через --largest-mm
cli-label-method = метод
cli-label-offset = смещение
cli-label-residuals = остатки
cli-label-sides = стороны
cli-label-run-out = биение
cli-label-tilt = наклон
cli-label-uncertainty = неопределённость
cli-label-free = не определено
cli-label-warning = внимание
cli-place-method = { $method }, { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точек
    }
cli-place-offset = { $name }: { $offset }
cli-place-residuals = { $rms } RMS, наибольший { $max }
cli-place-sides = 1-2 { $first }, 2-3 { $second }, 3-1 { $third } длиннее номинала
cli-place-run-out = { $eccentricity } { $vector } в { $at } мм
cli-place-run-out-radius = { $run-out }, радиус { $deviation }
cli-place-tilt = { $angle } в сторону { $direction }
cli-place-uncertainty = { $xyz } мм, { $turn } градусов вокруг x, y, z в { $at } мм
cli-place-free = { $motion }: оставлено, как в задании
cli-place-moved = сдвинуто { $vector } мм
cli-place-turned = повёрнуто { $angle } вокруг { $axis }, затем сдвинуто { $vector } мм
cli-place-column-line = строка
cli-place-column-feature = элемент
cli-place-column-residual = остаток, мм
cli-place-outlier = выброс
cli-place-not-accepted = не принято: { $cure }
cli-place-for-job = # для файла задания, `offset` в его начало
cli-at-line = { $file }:{ $line }: { $fault }
cli-no-column = в `{ $header }` нет столбца `{ $column }`
cli-touched-header = строка заголовков с { $columns }, или с осями станка { $axes }
cli-touched-feature-column = столбец feature с { $features }
cli-touched-nominal-columns = столбцы { $columns } с номинальным положением каждой точки в системе детали
cli-touched-unknown-feature = feature = `{ $feature }` неизвестно этому методу
cli-touched-not-a-number = { $column } = `{ $value }` не является подходящим числом
cli-finite-up-to = конечное число до { $max }

# Tuning of the axes.
cli-tune-heading = настройка { $machine }: разомкнутый контур каждого контура положения, измеренный при движении оси
cli-tune-axis = ось
cli-tune-velocity-loop = контур скор.
cli-tune-notches = режекторные
cli-tune-resonance = резонанс
cli-tune-crossover = срез
cli-tune-bandwidth = полоса
cli-tune-gain-margin = запас ампл.
cli-tune-phase-margin = запас фазы
cli-tune-following = слежение
cli-tune-load = нагрузка
cli-tune-counts = дискреты
cli-label-not-tuned = не настроено
cli-label-assumed = допущение
cli-tune-refused = { $axis }: { $why }
cli-tune-assumed = { $axis }: файл станка не описывает привода
cli-tune-bode = Контур положения оси { $axis }, измерено при { $speed }

# Registers of devices, kinematics.
cli-io-no-device = у станка `{ $machine }` нет устройства с регистрами
cli-io-machine = файл станка с [devices.NAME.modbus]
cli-no-such-head = такой головки нет
cli-pose-out-of-reach = никакие положения осей не достигают этой позы

# The joint in images.
cli-image-whole-file = целый файл PNG, JPEG или PNM
cli-image-size = { $width } x { $height } пикселей
cli-image-at-least = не меньше { $min } пикселей на сторону
cli-image-saturated = изображение пересвечено, полностью белое
cli-image-exposure = экспозиция, при которой металл серый: меньше света, времени или усиления
cli-finite-numbers = { $n ->
        [one] { $n } конечное число
        [few] { $n } конечных числа
       *[many] { $n } конечных чисел
    } через запятую
cli-joint-zone = левый край < правый в пределах от 0 до { $right }, верхний < нижний в пределах от 0 до { $bottom }
cli-outside-zone = вне зоны поиска
cli-outside-image = вне изображения
cli-joint-start = x от { $left } до { $right }, y от { $top } до { $bottom }
cli-joint-none-at-start = в начале нет стыка: попробуйте другие --start, --direction-deg или --width-px
cli-stripe-neither = ни изображение, ни текст
cli-stripe-formats = PNG, JPEG или PNM, либо CSV со столбцами y_mm,z_mm
cli-not-a-position = не положение
cli-stripe-position = число в пределах 1e7 мм от 0, или ничего, где его нет
cli-stripe-profile-in-mm = профиль уже в мм
cli-stripe-image-options = --machine, --mm-per-px и --overlay с изображением
cli-stripe-sensor-size = { $width } x { $height }, как у датчика
cli-stripe-no-sensors = у станка их нет: [sensors.NAME]
cli-stripe-no-such-sensor = у { $machine } нет такого датчика
cli-stripe-sees-none = этот датчик не видит полосы
cli-stripe-kind = датчик с kind = "stripe"
cli-stripe-hint = подсказка: вверх ногами стык есть: поверните изображение на 180 градусов или отразите, чтобы верх был от листов
cli-scan-at = при s = { $s }: { $why }
cli-scan-no-profile = нет профиля
cli-scan-kind = профили не показывают размеров этой разделки
cli-scan-needs-scale = изображению нужно преобразование пикселей в мм
cli-scan-scales = --machine и --sensor, или --mm-per-px
cli-scan-mirrored = профили показывают соединение зеркально
cli-scan-with-mirrored = с --mirrored
cli-scan-without-mirrored = без --mirrored
cli-scan-same-position = другая строка имеет это положение
cli-scan-one-profile = один профиль на положение
cli-scan-beside-seam = положение в { $distance } от шва
cli-scan-not-measured = ни один профиль не показывает соединение от s = { $from } до { $to }: больше { $bridge }
cli-stripe-no-joint = стыка нет: { $why }
cli-stripe-unsure = уверенность { $confidence } ниже { $min }, поэтому по стыку следовать нельзя
cli-stripe-unsure-because = уверенность { $confidence } ниже { $min }, поэтому по стыку следовать нельзя: { $why }

# Step and direction pulses.
cli-pulses-not-vcd = не value change dump
cli-pulses-vcd = имя, которое оканчивается на .vcd
cli-pulses-no-stepper = ни одна ось { $machine } не имеет шагового двигателя
cli-pulses-machine = станок с [drives.<axis>.stepper] в файле, например torch-5axis
cli-pulses-ticks = период { $period } — это { $ticks } тактов по { $tick }
cli-pulses-whole-ticks = целое число тактов, до 1e11; см. --period-ms и --tick-ns
cli-pulses-lost-steps = двигатель оси { $axis } теряет { $steps ->
        [one] { $steps } полный шаг
        [few] { $steps } полных шага
       *[many] { $steps } полных шагов
    }, начиная с t = { $time }
cli-cure-lost-steps = меньшая скорость или ускорение, либо двигатель с большим моментом
cli-pulses-too-fast = требуется { $asked } импульсов в секунду при { $microsteps ->
        [one] { $microsteps } микрошаге
        [few] { $microsteps } микрошагах
       *[many] { $microsteps } микрошагах
    }, максимум { $max }
cli-cure-pulses-too-fast = меньшая скорость, меньше `microsteps` или больше `max_pulse_hz` драйвера, либо более мелкий --tick-ns
cli-cure-pulses-crowded = более длинный --period-ms, меньшее ускорение или меньшая скорость
cli-cure-fewer-microsteps = меньше микрошагов
cli-pulses-crowded = ось { $axis } на t = { $time }: { $fault }
cli-pulses-crowded-in-transfer = ось { $axis } на t = { $time }, во время холостого хода: { $fault }
cli-pulses-bound-frequency = для большего нужно свыше { $max } импульсов в секунду
cli-pulses-bound-driver = у драйвера нет более мелкой настройки
cli-pulses-bound-none = даже эти слишком быстры
cli-pulses-resolution = ось { $axis } движется на { $resolution } за импульс при { $microsteps ->
        [one] { $microsteps } микрошаге
        [few] { $microsteps } микрошагах
       *[many] { $microsteps } микрошагах
    }, требуется { $wanted }: { $why }
cli-pulses-note = примечание (разрешение): { $note }
cli-pulses-by-resolution = разрешением
cli-pulses-by-frequency = частотой
cli-pulses-by-driver = драйвером
cli-pulses-axis = { $axis }: микрошагов { $microsteps }, определено { $bound }, { $resolution } за импульс (требуется { $wanted }), импульсов { $pulses }, от { $start } до { $end } шагов, до { $highest } из { $max }
cli-pulses-axis-loses = { $axis }, двигатель теряет { $steps ->
        [one] { $steps } полный шаг
        [few] { $steps } полных шага
       *[many] { $steps } полных шагов
    }
cli-pulses-heading = { $job }: { $time } с периодом { $period }, такты по { $tick }
cli-pulses-without-stepper = без шагового двигателя, поэтому без импульсов: { $axes }

# Set-points under an operator's commands.
cli-command-time = число секунд от { $from } до { $to }: строки упорядочены по времени
cli-not-a-command = не команда
cli-command-value = не подходит к { $command }
cli-command-without-speed = не может продолжить при коррекции подачи 0
cli-command-override-first = перед этим коррекция подачи не меньше { $min }
cli-command-percent = от 0 до 150 процентов
cli-command-step = конечное число мм, не меньше 0,001
cli-command-nothing = ничего
cli-motion-coarse = { $parts } периодов по { $period }
cli-motion-whole-multiple = целое кратное периода, до 1e6 раз
cli-motion-period-with-commands = недопустимо с --commands
cli-motion-held = примечание (удержание): проход { $pass } ждёт на s = { $at }, а команд больше нет
cli-cure-commands-or-speed = измените команды или скорость задания

# Points followed at constant speed.
cli-follow-too-few = меньше двух разных точек
cli-follow-done = { $time }, { $way }, быстрее всего { $speed }
cli-follow-slower = заданные { $speed } не достигаются: не дают пределы осей или длина пути
cli-follow-stops = { $stops ->
        [one] { $stops } остановка
        [few] { $stops } остановки
       *[many] { $stops } остановок
    } для планирования вперёд: более длинный --window-s устранит их
cli-no-length = не имеет длины
cli-direction = направление
cli-follow-too-near = { $first } слишком близко к { $second }
cli-follow-something-too-near = что-то слишком близко
cli-follow-point = точка в строке { $line }: { $why }
cli-cure-follow = измените точки, расположение детали или станок; движение заканчивается перед этой точкой

# A running cell.
cli-run-rights = примечание: цикл работает без прав реального времени: { $footing }
cli-run-missed = примечание: пропущено { $missed } из { $cycles ->
        [one] { $cycles } цикла
        [few] { $cycles } циклов
       *[many] { $cycles } циклов
    } по { $period }: худший начался с опозданием { $late }
cli-run-missed-cure = лучше: более длинный servo_period_ms, или меньше параллельных программ; `seamwright machine latency` измеряет это
cli-run-nothing-left = нечего доваривать
cli-run-passes-up-to = проходы от 1 до { $passes }
cli-run-up-to-in-pass = до { $length } в этом проходе
cli-run-outputs-unsafe = устройство `{ $device }`: безопасное состояние его выходов не подтверждено: { $why }
cli-run-not-asked = оно не опрошено
cli-run-look-at-once = немедленно проверьте, выключены ли дуга и газ
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = завершено из-за { $cause }, но цикл не заканчивается за { $time }: проверьте, что дуга, газ и приводы выключены
cli-run-record-later = запись дополнит следующее `seamwright records recover`
cli-run-state = режим { $mode }, проход { $pass }, s { $s }, входы { $inputs }
cli-run-cleared = { $alarm } снята
cli-run-refused = { $order }: { $why }
cli-run-alarm = { $alarm }: { $reaction }; { $action }
cli-run-alarm-at = { $alarm } на { $at }: { $reaction }; { $action }
cli-run-alarm-action = { $alarm }: { $action }
cli-run-stopped-by = программа остановлена из-за { $cause }; всё выключено
cli-run-stopped-by-alarm = программу остановила тревога: { $alarm }
cli-run-trace-lost = не удаётся записать трассу
cli-fault-never-came = примечание: { $fault } не наступил: всё закончилось на { $time }
cli-order-number = `{ $word }` в `{ $line }`; разрешено число от { $min } до { $max }
cli-order-mode = режима `{ $mode }` нет; разрешено { $modes }, N s, N mm
cli-order-unknown = `{ $line }` не является приказом; разрешено { $orders }, override PERCENT, wait MODE, wait N s, wait N mm, ?

# Teaching by camera.
cli-teach-frames = папка, tcp://HOST:PORT, simulated
cli-teach-source = либо --frames, либо --semi-manual
cli-teach-not-here = здесь недопустимо
cli-teach-only-with = только с { $source }
cli-teach-new-frames = кадрами, которых ещё нет в папке
cli-teach-beside = это имя файла рядом с программой
cli-teach-file = файл, например taught.toml
cli-teach-camera-machine = станок с камерой: [sensors.<name>] с kind = "camera" в файле
cli-teach-no-such-camera = у { $machine } нет такой камеры
cli-teach-no-camera = у { $machine } нет камеры
cli-teach-several-cameras = у { $machine } несколько камер: выберите одну через --sensor
cli-teach-numbers = { $n ->
        [one] { $n } число
        [few] { $n } числа
       *[many] { $n } чисел
    }
cli-teach-three-numbers = три, X,Y,Z
cli-teach-start-off-seam = начало { $start } не вблизи номинального шва
cli-teach-start-near = --start в пределах 15 мм от него, в рабочей системе координат станка
cli-direction-without-length = направление не имеет длины
cli-three-finite-numbers = три конечных числа, не все 0
cli-teach-answers = X,Y,Z (мм, рабочая система) или X,Y,Z,DX,DY,DZ, чтобы идти дальше оттуда, в том направлении; end: стык здесь заканчивается; stop: прекратить
cli-teach-lost = потеряно после { $way }, в { $point }: { $why }
cli-teach-seen = последний кадр: { $file }
cli-teach-bad-answer = не три или шесть чисел и не end или stop
cli-teach-point-off-seam = точка не в пределах 15 мм от номинального шва
cli-teach-by-points = номинальный шов, подведённый к точкам оператора
cli-teach-done = { $ended } после { $way }, { $frames ->
        [one] { $frames } кадр
        [few] { $frames } кадра
       *[many] { $frames } кадров
    } за { $time }; { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точек
    }
cli-teach-closes = замыкается в пределах { $gap }
cli-teach-asked = запрос к оператору: { $why }
cli-teach-spline = сплайн из { $pieces ->
        [one] { $pieces } участка
        [few] { $pieces } участков
       *[many] { $pieces } участков
    }
cli-teach-lines-and-arcs = { $lines ->
        [one] { $lines } отрезок
        [few] { $lines } отрезка
       *[many] { $lines } отрезков
    } и { $arcs ->
        [one] { $arcs } дуга
        [few] { $arcs } дуги
       *[many] { $arcs } дуг
    }
cli-teach-program = программа: { $curves } в пределах { $error } от обученной линии
cli-teach-program-of-raw = программа: { $curves } в пределах { $error } от обученной линии, { $raw } от каждой исходной точки
cli-teach-truth = на самом деле { $across } RMS вбок от шва, не больше { $across-max }; { $height } RMS выше или ниже, не больше { $height-max }
cli-teach-no-address = не адрес
cli-teach-address = tcp://HOST:PORT, порт от 1 до 65535
cli-teach-no-frames = нет кадров
cli-teach-not-a-camera = датчик { $sensor } не является камерой
cli-teach-not-three-numbers = не три числа
cli-teach-distortion = SHIFT,TURN,BEND в мм, градусах, мм
cli-teach-shift = сдвиг { $value }
cli-teach-turn = поворот { $value }
cli-teach-bend = изгиб { $value }
cli-teach-tack = FROM,TO в мм вдоль шва, FROM перед TO

# The server.
cli-serve-data = --data { $folder }: не удалось создать: { $why }
cli-serve-no-job = такого задания нет
cli-serve-jobs = файл, задание в { $folder } или пример: { $examples }
cli-serve-other-job = в папке данных есть другое задание с таким именем
cli-serve-other-name = файл с другим именем, или --job { $name } оттуда
cli-serve-no-token = в файле нет токена
cli-serve-tokens = одна строка не менее чем из { $min } букв, цифр и знаков

# Acceptance benchmarks.
cli-bench-not-shipped = станок { $machine } не поставляется
cli-bench-half-ring = не удалось спланировать полукольцо

# Drawings.
cli-draw-points-as-spans = Точки как отрезки и дуги
cli-draw-seen-along = Вид вдоль { $axis }
cli-draw-points = точки
cli-draw-lines = отрезки
cli-draw-arcs = дуги
cli-draw-ends = концы
cli-draw-spline = сплайн
cli-draw-taught-line = Обученная линия
cli-draw-from-nominal = От номинального шва
cli-draw-distance = расстояние
cli-draw-across = поперёк
cli-draw-above = выше
cli-draw-tolerance = допуск
cli-draw-raw-from-program = Исходные точки от программы
cli-draw-raw-points = исходные точки
cli-draw-frame-against-frame = Кадр относительно кадра
cli-draw-overlap = перекрытие
cli-draw-confidence-title = Уверенность
cli-draw-confidence = уверенность
cli-draw-interpolation = Методы интерполяции рядом
cli-draw-true-curve = истинная кривая
cli-draw-paths = Пути, вид вдоль z
cli-draw-close = Импульс за импульсом, вокруг середины пути
cli-draw-steps = Прямое расстояние за каждый период против скорость x период
cli-draw-angle = пройденный угол
cli-draw-deviation = отклонение
cli-draw-max-distance = Наибольшее расстояние точек от истинной кривой

# Results of recorded welds.
cli-result-running = идёт
cli-result-good = хорошо
cli-result-deviating = с отклонениями
cli-result-stopped = остановлено
cli-result-interrupted = прервано

# Units in the table of tuning.
cli-tune-hz = Гц
cli-tune-per-s = 1/с
cli-tune-ms = мс
cli-tune-db = дБ
cli-stopped = остановлено в цикле { $cycle }
cli-no-cell-runs = там ячейка не работает
cli-data-of-running-cell = папка данных работающей панели
cli-stop-unanswered = остановка не подтверждена: { $why }

# Machine files of arms.
cli-arm-note = замечание: { $note }
cli-arm-next = проверить: seamwright machine check { $file }
cli-arm-home = исходное положение оси `{ $axis }` вне её диапазона
cli-no-configurations = станок не является рукой, у конфигураций которой есть имена
cli-no-arm-angle = станок не является рукой с семью осями
# Программы роботов.
cli-not-for-robots = не для роботов
cli-options-of-robots = --tolerance-mm, --speed-percent, --retract-mm
cli-servo-not-here = поток заданных положений есть только в URScript
cli-servo-language = вместе с --dialect urscript
cli-servo-alone = параметр относится к потоку заданных положений, а --servo-ms отсутствует
cli-servo-with-period = вместе с --servo-ms
cli-servo-period = от { $step } до { $max } с шагом { $step }

# Search for placements of the work.
cli-progress-reach = поиск установок детали
cli-label-judged = проверено
cli-label-budget = бюджет
cli-label-present = сейчас
cli-label-best = лучшая
cli-label-entry = запись
cli-reach-judged = установки: { $placements }, пригодны: { $weldable }
cli-reach-cut-off = { $budget } завершили поиск: --budget даст больше
cli-reach-interrupted = Ctrl-C завершил поиск: результат — лучшая установка из найденных
cli-label-moved = перемещается
cli-reach-moves-work = деталь, в её системе координат
cli-reach-moves-base = основание станка, в его собственной системе координат
cli-reach-base-entry = { $file }: { $key } = { $entry }
cli-reach-supplied = станок входит в программу, файла для записи нет
cli-reach-own-machine = файл станка; его создаёт `seamwright machine show { $name } > machines/{ $name }.toml` рядом с заданием
cli-reach-at = x { $x }, y { $y }, z { $z } от нынешней установки, поворот { $turn }
cli-reach-margin = у оси { $axis } остаётся { $margin } диапазона (проход { $pass }, s = { $s })
cli-reach-free = пригодна; ни у одной оси нет диапазона
cli-reach-fails = непригодна: проход { $pass }, s = { $s }: { $reason }
cli-reach-not-planned = { $placement }: планировщик отклоняет: { $reason }
cli-reach-none = нет пригодной и запланированной установки
cli-reach-entry = { $key }: move_mm = { $vector }, угол { $angle }
cli-reach-form = ОТ,ДО или ОТ,ДО,ЯЧЕЙКИ, где ОТ не больше ДО и ячеек не меньше 1, например -300,300,9
cli-reach-ends = концы от { $min } до { $max }
cli-reach-reversed = диапазон начинается выше своего конца
cli-reach-too-many-cells = в сетке { $cells } мест
cli-reach-cells-allowed = всего до { $max } мест
cli-reach-no-file = нет такого файла для записи
cli-reach-job-file = файл задания или программы; его создаёт `seamwright examples NAME > job.toml`
cli-reach-changed = { $file } изменён во время поиска: ничего не записано
cli-label-planned = план
cli-reach-planned = в плане у оси { $axis } остаётся { $margin } диапазона
cli-allowed-spark = адрес Spark Connect, например sc://host:15002
