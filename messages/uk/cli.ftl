# Notes and errors of every command.
cli-more-time = { $cure }; більше часу: --time-limit S
cli-verb-renamed = примітка: `seamwright { $former }` тепер зветься `seamwright { $present }`
cli-unknown-language = примітка: мови `{ $language }` немає, тому англійською; доступні: { $known }
cli-error = помилка: { $error }
cli-option = { $option }: { $fault }
cli-not-allowed = недопустиме значення
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = від { $from } до { $to }
cli-plus = +{ $value }
cli-wrote = записано { $files }
cli-no-such-axis = такої осі немає
cli-cycle-ended-early = потік циклу завершився передчасно
cli-jobs-unreadable = не всі завдання вдалося прочитати
cli-no-notices = ліцензій сторонніх пакетів у цій програмі немає: { $why }
cli-at-least-two = щонайменше дві
cli-standard-input = стандартний ввід

# Progress.
cli-progress-planning = планування
cli-progress-rows = рядки
cli-schedule-done = { $weldable } із { $rows } рядків можна зварити, як задано; { $kept } не плановано знову
cli-progress-draws = вибірки
cli-study-done = { $draws } вибірок { $job } на { $machine }; { $kept } планів узято з попереднього запуску
cli-study-weldable = можна зварити: { $percent } % (95-%-й інтервал від { $low } до { $high } %)
cli-study-first-error = перша помилка: { $error }
cli-progress-pass = прохід { $pass } з { $passes }: { $stage }
cli-progress-simulating = зварювання в симуляції
cli-progress-machine = перевірка верстата
cli-progress-tuning = налаштування осей
cli-progress-cycles = цикли
cli-progress-pulses = імпульси
cli-progress-set-points = задані значення
cli-progress-teaching = навчання
cli-progress-faults = відмови
cli-progress-frames = змодельовані кадри
cli-progress-welds = змодельовані зварювання

# Labels of the summary of a weld.
cli-label-machine = верстат
cli-label-seam = шов
cli-label-speed = швидкість
cli-label-time = час
cli-label-energy = енергія
cli-label-clearance = зазор
cli-label-passes = проходи
cli-label-pass = прохід { $pass }
cli-label-takes = витрата
cli-label-waits = очікування
cli-label-duty = дуга
cli-label-cost = вартість
cli-label-transfers = холості ходи
cli-label-wrote = записано
cli-label-welded = зварено
cli-label-path-error = похибка шляху
cli-label-tip-speed = швидкість TCP
cli-label-axis = вісь { $axis }

# Summary of a weld.
cli-summary-seam = { $length }, зварюється { $weld }
cli-summary-takes-energy = { $energy } енергії дуги
cli-summary-takes-wire = { $wire } дроту
cli-summary-takes-metal = { $mass } металу шва
cli-summary-takes-gas = { $gas } газу
cli-summary-takes-flux = { $mass } флюсу
cli-summary-waits = { $time } між проходами, доки шов охолоне
cli-summary-duty = { $part } часу, { $duty } найгірших 10 хвилин
cli-summary-cost = { $total } { $currency }
cli-summary-cost-incomplete = { $total } { $currency }, без: { $without }
cli-summary-transfers = { $time }, від вихідного положення до вихідного { $total }
cli-summary-speed = від { $from } до { $to } заплановано, від { $asked-from } до { $asked-to } задано
cli-summary-time = { $travel } руху, { $arc } з дугою, { $total } загалом
cli-summary-passes = { $passes }, { $length } загалом
cli-summary-clearance = зазор { $clearance }
cli-summary-arc-energy = погонна енергія дуги { $energy }
cli-summary-heat-input = тепловкладення { $heat }
cli-clearance-between = { $distance }: { $first } і { $second }
cli-clearance-none = { $distance }: ніщо з контрольованого не підходить ближче
cli-summary-not-welded = нічого (симуляція)
cli-summary-path-error = { $max } найбільше, { $rms } RMS (симуляція)
cli-summary-tip-speed = від { $from } до { $to }, RMS-відхилення { $rms } (симуляція)
cli-summary-too-short = зварювання закоротке для оцінки
cli-summary-following-error = похибка стеження { $error }, RMS { $rms }
cli-summary-tracked = { $p99 } від стику на 99 % зварювання, найбільше { $max }; без стеження { $plain-p99 } і { $plain-max }
cli-summary-untracked = { $p99 } від стику на 99 % зварювання, найбільше { $max }; без стеження
cli-summary-stopped = зупинено на { $at }
cli-summary-alarm = на { $at }: { $alarm }
cli-summary-beam = відхилено до { $deflection } з { $range }, гармату переміщено на { $carried }; промінь відведено { $away } часу, найдовше { $longest }
cli-summary-beam-replayed = за записом: { $beam }
cli-summary-beam-fit = { $beam }; 90 % з { $points ->
        [one] { $points } точки
        [few] { $points } точок
       *[many] { $points } точок
    } у межах { $distance } від збережених відхилень

# Positions along the seam.
cli-no-such-angle = у цього шва немає такого кута
cli-angle-not-welded = цей кут не на зварюваній частині
cli-too-many-points = забагато точок
cli-at-least-step = щонайменше { $step }: { $points } точок
cli-section-no-joint = завдання не має стику, тож немає й перерізу
cli-section-joint = [joint] з його підготовкою

# Lists.
cli-list-machine = верстат
cli-list-axes = осі
cli-list-example = приклад
cli-list-procedure = WPS
cli-list-process = процес
cli-list-title = назва
cli-no-machine = { $name }: такого верстата немає
cli-no-example = { $name }: такого прикладу немає
cli-no-procedure = { $name }: такої WPS немає

# Lateness of the cycle.
cli-latency-cycles = { $cycles ->
        [one] { $cycles } цикл
        [few] { $cycles } цикли
       *[many] { $cycles } циклів
    } по { $period }, { $missed } пропущено
cli-latency-late = { $part } починаються із запізненням до { $late }

# Moves from point to point.
cli-motions-up-to-two-hours = рухи до двох годин
cli-move-set-points = { $count } заданих значень
cli-longer-period = до { $max }, з довшим періодом
cli-move-done = { $time }, { $count ->
        [one] { $count } задане значення
        [few] { $count } задані значення
       *[many] { $count } заданих значень
    }; { $clearance }
cli-axis-value-of = ВІСЬ=ЗНАЧЕННЯ з віссю { $axes }
cli-any-number-of = будь-яке число { $unit }
cli-axis-twice = вісь { $axis } задано двічі
cli-each-axis-once = кожна вісь один раз
cli-axis-position-not-a-number = положення осі { $axis } — не число
cli-axis-outside = поза діапазоном осі { $axis }
cli-move-no-shapes = без перевірки зіткнень: у файлі верстата немає тіл, що могли б зіткнутися
cli-move-min-distance = найменша відстань { $distance } на { $time }: { $first } і { $second }
cli-move-clear = ніщо не підходить ближче ніж на { $distance }
cli-move-impossible = рух неможливий, як задано: { $findings ->
        [one] { $findings } зауваження
        [few] { $findings } зауваження
       *[many] { $findings } зауважень
    }
cli-move-times = t = від { $from } до { $to }
cli-move-in-parts = обійдіть перешкоду кількома рухами

# Part programs.
cli-as-far-as-axes-reach = відстань, якої досягають осі
cli-post-differs = керувальна програма відрізняється від плану, її не записано:
cli-too-coarse = загрубо
cli-finer-than-decimals = дрібніше за шість десяткових знаків слів
cli-no-such-blocks = ця система керування не має таких кадрів
cli-interpolations = pvt, spline1, linear для PMAC; linear, poly для Sinumerik; linear для LinuxCNC і grblHAL
cli-too-far = задалеко
cli-up-to-pass-tolerance = до { $max }, допуск проходу
cli-import = { $file }: програма { $dialect }, { $moves ->
        [one] { $moves } рух
        [few] { $moves } рухи
       *[many] { $moves } рухів
    }, { $time } за її подачами; проходи: { $passes }
cli-import-left-out = пропущено: { $place }: { $words }: { $why }

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = виправте рядок або вилучіть із файлу стовпець, що не є віссю
cli-cure-line-in-mm = виправте рядок; координати в мм
cli-cure-line-per-point = один рядок чисел на точку, під рядком заголовків
cli-too-far-away = задалеко
cli-points-found = { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точок
    }
cli-reduced = { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точок
    }; відрізки: { $lines }, дуги: { $arcs }; найбільша похибка { $error }; найменше число ділянок: { $min }
cli-not-a-point = не точка
cli-point-form = x,y у мм, як-от { $example }
cli-too-many-to-draw = { $method } має понад { $max } точок для креслення
cli-coarser-or-no-drawing = грубіший імпульс чи довший період, або без креслення

# Edits of a program file.
cli-edit-no-operation = операцію не задано, або задано кілька
cli-edit-operations = одна операція, undo, redo, history або --script OPS.json; див. `seamwright edit --help`
cli-edit-new-history = примітка: { $file } змінено вручну після останньої правки: починається нова історія
cli-edit-of-operation = операція { $number }: { $why }
cli-edit-job = { $file }: це завдання; редагують програми
cli-edit-plan-first = спершу сплануйте: seamwright plan { $file }; потім редагуйте { $program }
cli-edit-by-hand = { $file }: файл змінено вручну після останньої правки
cli-edit-force = --force, наскільки можливо
cli-edit-nothing-to-undo = { $file }: немає чого скасувати
cli-edit-nothing-to-redo = { $file }: немає чого повторити
cli-edit-see-history = див. `history`
cli-edit-undone = скасовано: { $edit }
cli-edit-redone = повторено: { $edit }
cli-edit-unchanged = { $edit } (нічого не змінено)
cli-edit-undone-entry = { $edit } (скасовано)
cli-edit-by-hand-since = файл відтоді змінено вручну
cli-edit-none = правок немає
cli-edit-value = одне число, або два для лінійної зміни
cli-edit-see-schema = див. `seamwright schema operation`

# Records of welds.
cli-no-data-folder = немає теки даних
cli-data-folder = --data DIR або SEAMWRIGHT_DATA
cli-record-backup = { $file }: { $size } МБ
cli-record-restored = { $folder }: відновлено; перевірте: `seamwright records verify`
cli-recovered = зварювання { $weld } ({ $part }): відновлено { $rows ->
        [one] { $rows } рядок
        [few] { $rows } рядки
       *[many] { $rows } рядків
    }, { $result }
cli-recovered-unread = зварювання { $weld } ({ $part }): відновлено { $rows ->
        [one] { $rows } рядок
        [few] { $rows } рядки
       *[many] { $rows } рядків
    }, { $unread } у кінці не прочитано, { $result }
cli-nothing-to-recover = немає чого відновлювати
cli-recorded = записано: зварювання { $weld }
cli-record-weld-note = примітка: зварювання { $weld }: { $note }
cli-record-heading = зварювання { $weld }: { $title }
cli-label-part = деталь
cli-label-result = результат
cli-label-begun = початок
cli-label-ended = кінець
cli-label-welder = зварник
cli-label-procedure = WPS
cli-label-job = завдання
cli-label-program = програма
cli-label-heat-input = тепловкладення
cli-label-deviation = відхилення
cli-label-note = примітка
cli-label-alarm = тривога
cli-label-event = подія
cli-label-file = файл
cli-record-simulated = { $result }, симуляція
cli-record-version = { $name }, версія { $version }
cli-record-heat-input = від { $min } до { $max }, середнє { $mean }
cli-record-deviation = найбільше { $max }, на s = { $at }
cli-record-value = { $name } від { $from } до { $to }
cli-record-value-allowed = { $value } (дозволено від { $min } до { $max })
cli-record-value-outside = { $value } (дозволено від { $min } до { $max }, поза межами { $time })
cli-record-with-cause = { $alarm }: { $cause }
cli-record-at = { $alarm } на s = { $at }
cli-record-file = { $file }, { $size }, SHA-256 { $hash }
cli-record-table = { $file }, { $size }, { $rows ->
        [one] { $rows } рядок
        [few] { $rows } рядки
       *[many] { $rows } рядків
    }, SHA-256 { $hash }
cli-verified = { $welds ->
        [one] { $welds } зварювання
        [few] { $welds } зварювання
       *[many] { $welds } зварювань
    }, { $files ->
        [one] { $files } файл
        [few] { $files } файли
       *[many] { $files } файлів
    } як записано, { $entries ->
        [one] { $entries } запис аудиту
        [few] { $entries } записи аудиту
       *[many] { $entries } записів аудиту
    }: усе гаразд
cli-verified-problems = { $welds ->
        [one] { $welds } зварювання
        [few] { $welds } зварювання
       *[many] { $welds } зварювань
    }, { $files ->
        [one] { $files } файл
        [few] { $files } файли
       *[many] { $files } файлів
    } як записано, { $entries ->
        [one] { $entries } запис аудиту
        [few] { $entries } записи аудиту
       *[many] { $entries } записів аудиту
    }: є вади
cli-problem = вада: { $problem }

# Position of the work in the machine.
cli-place-more-points = більше точок, розподілених по виміряних елементах, або інший --method
cli-place-side-unknown = невідомо, з якого боку щуп торкнувся окремої точки
cli-place-radius-with-three-points = 0 для three-point, або інший --method
cli-place-undetermined = точки не визначають положення деталі
cli-place-no-seam = програма не має шва, поверхні якого могли бути виміряні
cli-place-no-nozzle = шов не має патрубка, тож не має й биття
cli-place-nozzle = [seam.nozzle], або інший --method
cli-place-no-redundancy = точок не більше, ніж невідомих: хибна точка не виявиться
cli-place-radius-unknown = точки не визначають радіус: взято номінальний
cli-place-radius-off = радіус відрізняється від номінального на { $deviation }: перевірте трубу і щуп
cli-place-no-rotary-axis = верстат не має поворотної осі навколо номінальної осі патрубка: биття відносне до номінальної осі
cli-place-unchangeable = { $file }: не вдалося змінити: { $why }
cli-place-touch-again = відхилення більше за { $max }: виміряйте точки знову; сторони показують, яка хибна. Якщо деталь не краща, дозвольте більше через --largest-mm
cli-place-touch-again-round = відхилення більше за { $max }: виміряйте знову точки з найбільшими відхиленнями і перевірте, чи труба кругла. Якщо деталь не краща, дозвольте більше через --largest-mm
cli-place-touch-again-features = відхилення більше за { $max }: виміряйте знову точки з найбільшими відхиленнями; перевірте їхні елементи, радіус щупа і приблизне положення деталі в завданні. Якщо деталь не краща, дозвольте більше через --largest-mm
cli-label-method = метод
cli-label-offset = зсув
cli-label-residuals = відхилення
cli-label-sides = сторони
cli-label-run-out = биття
cli-label-tilt = нахил
cli-label-uncertainty = невизначеність
cli-label-free = не визначено
cli-label-warning = увага
cli-place-method = { $method }, { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точок
    }
cli-place-offset = { $name }: { $offset }
cli-place-residuals = { $rms } RMS, найбільше { $max }
cli-place-sides = 1-2 { $first }, 2-3 { $second }, 3-1 { $third } довше за номінал
cli-place-run-out = { $eccentricity } { $vector } у { $at } мм
cli-place-run-out-radius = { $run-out }, радіус { $deviation }
cli-place-tilt = { $angle } у бік { $direction }
cli-place-uncertainty = { $xyz } мм, { $turn } градусів навколо x, y, z у { $at } мм
cli-place-free = { $motion }: залишено, як у завданні
cli-place-moved = зсунуто { $vector } мм
cli-place-turned = повернуто { $angle } навколо { $axis }, потім зсунуто { $vector } мм
cli-place-column-line = рядок
cli-place-column-feature = елемент
cli-place-column-residual = відхилення, мм
cli-place-outlier = викид
cli-place-not-accepted = не прийнято: { $cure }
cli-place-for-job = # для файлу завдання, `offset` на його початок
cli-at-line = { $file }:{ $line }: { $fault }
cli-no-column = у `{ $header }` немає стовпця `{ $column }`
cli-touched-header = рядок заголовків із { $columns }, або з осями верстата { $axes }
cli-touched-feature-column = стовпець feature з { $features }
cli-touched-nominal-columns = стовпці { $columns } з номінальним положенням кожної точки в системі деталі
cli-touched-unknown-feature = feature = `{ $feature }` невідоме цьому методу
cli-touched-not-a-number = { $column } = `{ $value }` не є числом, придатним тут
cli-finite-up-to = скінченне число до { $max }

# Tuning of the axes.
cli-tune-heading = налаштування { $machine }: розімкнений контур кожного контуру положення, виміряний під час руху осі
cli-tune-axis = вісь
cli-tune-velocity-loop = контур швидк.
cli-tune-notches = режекторні
cli-tune-resonance = резонанс
cli-tune-crossover = зріз
cli-tune-bandwidth = смуга
cli-tune-gain-margin = запас ампл.
cli-tune-phase-margin = запас фази
cli-tune-following = стеження
cli-tune-load = навантаження
cli-tune-counts = дискрети
cli-label-not-tuned = не налаштовано
cli-label-assumed = припущення
cli-tune-refused = { $axis }: { $why }
cli-tune-assumed = { $axis }: файл верстата не описує приводу
cli-tune-bode = Контур положення осі { $axis }, виміряно на { $speed }

# Registers of devices, kinematics.
cli-io-no-device = верстат `{ $machine }` не має пристрою з регістрами
cli-io-machine = файл верстата з [devices.NAME.modbus]
cli-no-such-head = такої головки немає
cli-pose-out-of-reach = жодні положення осей не досягають цієї пози

# The joint in images.
cli-image-whole-file = цілий файл PNG, JPEG або PNM
cli-image-size = { $width } x { $height } пікселів
cli-image-at-least = щонайменше { $min } пікселів на сторону
cli-image-saturated = зображення перенасичене, цілком біле
cli-image-exposure = експозиція, за якої метал сірий: менше світла, часу чи підсилення
cli-finite-numbers = { $n ->
        [one] { $n } скінченне число
        [few] { $n } скінченні числа
       *[many] { $n } скінченних чисел
    } через кому
cli-joint-zone = лівий край < правий у межах від 0 до { $right }, верхній < нижній у межах від 0 до { $bottom }
cli-outside-zone = поза зоною пошуку
cli-outside-image = поза зображенням
cli-joint-start = x від { $left } до { $right }, y від { $top } до { $bottom }
cli-joint-none-at-start = на початку немає стику: спробуйте інші --start, --direction-deg чи --width-px
cli-stripe-neither = ні зображення, ні текст
cli-stripe-formats = PNG, JPEG чи PNM, або CSV зі стовпцями y_mm,z_mm
cli-not-a-position = не положення
cli-stripe-position = число в межах 1e7 мм від 0, або нічого, де його бракує
cli-stripe-profile-in-mm = профіль уже в мм
cli-stripe-image-options = --machine, --mm-per-px і --overlay із зображенням
cli-stripe-sensor-size = { $width } x { $height }, як у давача
cli-stripe-no-sensors = верстат їх не має: [sensors.NAME]
cli-stripe-no-such-sensor = { $machine } не має такого давача
cli-stripe-sees-none = цей давач не бачить смуги
cli-stripe-kind = давач із kind = "stripe"
cli-stripe-hint = підказка: догори дном стик є: поверніть зображення на 180 градусів або віддзеркальте, щоб верх був від листів
cli-scan-at = при s = { $s }: { $why }
cli-scan-no-profile = немає профілю
cli-scan-kind = профілі не показують розмірів цієї розробки
cli-scan-needs-scale = зображенню потрібне перетворення пікселів у мм
cli-scan-scales = --machine і --sensor, або --mm-per-px
cli-scan-mirrored = профілі показують з’єднання дзеркально
cli-scan-with-mirrored = з --mirrored
cli-scan-without-mirrored = без --mirrored
cli-scan-same-position = інший рядок має це положення
cli-scan-one-profile = один профіль на положення
cli-scan-beside-seam = положення за { $distance } від шва
cli-scan-not-measured = жоден профіль не показує з’єднання від s = { $from } до { $to }: більше { $bridge }
cli-stripe-no-joint = стику немає: { $why }
cli-stripe-unsure = довіра { $confidence } нижча за { $min }, тож за стиком не слід іти
cli-stripe-unsure-because = довіра { $confidence } нижча за { $min }, тож за стиком не слід іти: { $why }

# Step and direction pulses.
cli-pulses-not-vcd = не value change dump
cli-pulses-vcd = ім’я, що закінчується на .vcd
cli-pulses-no-stepper = жодна вісь { $machine } не має крокового двигуна
cli-pulses-machine = верстат із [drives.<axis>.stepper] у файлі, як-от torch-5axis
cli-pulses-ticks = період { $period } — це { $ticks } тактів по { $tick }
cli-pulses-whole-ticks = ціле число тактів, до 1e11; див. --period-ms і --tick-ns
cli-pulses-lost-steps = двигун осі { $axis } втрачає { $steps ->
        [one] { $steps } повний крок
        [few] { $steps } повні кроки
       *[many] { $steps } повних кроків
    }, починаючи з t = { $time }
cli-cure-lost-steps = менша швидкість чи прискорення, або двигун із більшим моментом
cli-pulses-too-fast = потрібно { $asked } імпульсів за секунду при { $microsteps ->
        [one] { $microsteps } мікрокроці
        [few] { $microsteps } мікрокроках
       *[many] { $microsteps } мікрокроках
    }, найбільше { $max }
cli-cure-pulses-too-fast = менша швидкість, менше `microsteps` чи більше `max_pulse_hz` драйвера, або дрібніший --tick-ns
cli-cure-pulses-crowded = довший --period-ms, менше прискорення або менша швидкість
cli-cure-fewer-microsteps = менше мікрокроків
cli-pulses-crowded = вісь { $axis } на t = { $time }: { $fault }
cli-pulses-crowded-in-transfer = вісь { $axis } на t = { $time }, під час холостого ходу: { $fault }
cli-pulses-bound-frequency = для більшого потрібно понад { $max } імпульсів за секунду
cli-pulses-bound-driver = драйвер не має дрібнішого налаштування
cli-pulses-bound-none = навіть ці зашвидкі
cli-pulses-resolution = вісь { $axis } рухається на { $resolution } за імпульс при { $microsteps ->
        [one] { $microsteps } мікрокроці
        [few] { $microsteps } мікрокроках
       *[many] { $microsteps } мікрокроках
    }, потрібно { $wanted }: { $why }
cli-pulses-note = примітка (роздільність): { $note }
cli-pulses-by-resolution = роздільністю
cli-pulses-by-frequency = частотою
cli-pulses-by-driver = драйвером
cli-pulses-axis = { $axis }: мікрокроків { $microsteps }, визначено { $bound }, { $resolution } за імпульс (потрібно { $wanted }), імпульсів { $pulses }, від { $start } до { $end } кроків, до { $highest } з { $max }
cli-pulses-axis-loses = { $axis }, двигун втрачає { $steps ->
        [one] { $steps } повний крок
        [few] { $steps } повні кроки
       *[many] { $steps } повних кроків
    }
cli-pulses-heading = { $job }: { $time } з періодом { $period }, такти по { $tick }
cli-pulses-without-stepper = без крокового двигуна, тож без імпульсів: { $axes }

# Set-points under an operator's commands.
cli-command-time = число секунд від { $from } до { $to }: рядки впорядковано за часом
cli-not-a-command = не команда
cli-command-value = не пасує до { $command }
cli-command-without-speed = не може продовжити з корекцією подачі 0
cli-command-override-first = перед цим корекція подачі щонайменше { $min }
cli-command-percent = від 0 до 150 відсотків
cli-command-step = скінченне число мм, щонайменше 0,001
cli-command-nothing = нічого
cli-motion-coarse = { $parts } періодів по { $period }
cli-motion-whole-multiple = ціле кратне періоду, до 1e6 разів
cli-motion-period-with-commands = недопустимо з --commands
cli-motion-held = примітка (утримання): прохід { $pass } чекає на s = { $at }, а команд більше немає
cli-cure-commands-or-speed = змініть команди або швидкість завдання

# Points followed at constant speed.
cli-follow-too-few = менше двох різних точок
cli-follow-done = { $time }, { $way }, найшвидше { $speed }
cli-follow-slower = заданих { $speed } не досягнуто: не дають межі осей або довжина шляху
cli-follow-stops = { $stops ->
        [one] { $stops } зупинка
        [few] { $stops } зупинки
       *[many] { $stops } зупинок
    } для планування наперед: довший --window-s усуне їх
cli-no-length = не має довжини
cli-direction = напрям
cli-follow-too-near = { $first } надто близько до { $second }
cli-follow-something-too-near = щось надто близько
cli-follow-point = точка в рядку { $line }: { $why }
cli-cure-follow = змініть точки, розташування деталі або верстат; рух закінчується перед цією точкою

# A running cell.
cli-run-rights = примітка: цикл працює без прав реального часу: { $footing }
cli-run-missed = примітка: пропущено { $missed } з { $cycles ->
        [one] { $cycles } циклу
        [few] { $cycles } циклів
       *[many] { $cycles } циклів
    } по { $period }: найгірший почався з запізненням { $late }
cli-run-missed-cure = краще: довший servo_period_ms, або менше паралельних програм; `seamwright machine latency` вимірює це
cli-run-nothing-left = нема чого доварювати
cli-run-passes-up-to = проходи від 1 до { $passes }
cli-run-up-to-in-pass = до { $length } у цьому проході
cli-run-outputs-unsafe = пристрій `{ $device }`: безпечний стан його виходів не підтверджено: { $why }
cli-run-not-asked = його не опитано
cli-run-look-at-once = негайно перевірте, чи вимкнено дугу і газ
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = завершено через { $cause }, але цикл не закінчується за { $time }: перевірте, що дугу, газ і приводи вимкнено
cli-run-record-later = запис доповнить наступне `seamwright records recover`
cli-run-state = режим { $mode }, прохід { $pass }, s { $s }, входи { $inputs }
cli-run-cleared = { $alarm } минула
cli-run-refused = { $order }: { $why }
cli-run-alarm = { $alarm }: { $reaction }; { $action }
cli-run-alarm-at = { $alarm } на { $at }: { $reaction }; { $action }
cli-run-alarm-action = { $alarm }: { $action }
cli-run-stopped-by = програму зупинено через { $cause }; усе вимкнено
cli-run-stopped-by-alarm = програму зупинила тривога: { $alarm }
cli-run-trace-lost = не вдається записати трасу
cli-fault-never-came = примітка: { $fault } не настала: усе закінчилося на { $time }
cli-order-number = `{ $word }` у `{ $line }`; дозволено число від { $min } до { $max }
cli-order-mode = режиму `{ $mode }` немає; дозволено { $modes }, N s, N mm
cli-order-unknown = `{ $line }` не є наказом; дозволено { $orders }, override PERCENT, wait MODE, wait N s, wait N mm, ?

# Teaching by camera.
cli-teach-frames = тека, tcp://HOST:PORT, simulated
cli-teach-source = або --frames, або --semi-manual
cli-teach-not-here = тут недопустимо
cli-teach-only-with = лише з { $source }
cli-teach-new-frames = кадрами, яких ще немає в теці
cli-teach-beside = це ім’я файлу поруч із програмою
cli-teach-file = файл, як-от taught.toml
cli-teach-camera-machine = верстат із камерою: [sensors.<name>] із kind = "camera" у файлі
cli-teach-no-such-camera = { $machine } не має такої камери
cli-teach-no-camera = { $machine } не має камери
cli-teach-several-cameras = { $machine } має кілька камер: виберіть одну через --sensor
cli-teach-numbers = { $n ->
        [one] { $n } число
        [few] { $n } числа
       *[many] { $n } чисел
    }
cli-teach-three-numbers = три, X,Y,Z
cli-teach-start-off-seam = початок { $start } не поблизу номінального шва
cli-teach-start-near = --start у межах 15 мм від нього, у робочій системі координат верстата
cli-direction-without-length = напрям не має довжини
cli-three-finite-numbers = три скінченні числа, не всі 0
cli-teach-answers = X,Y,Z (мм, робоча система) або X,Y,Z,DX,DY,DZ, щоб іти далі звідти, у тому напрямі; end: стик тут закінчується; stop: припинити
cli-teach-lost = втрачено після { $way }, у { $point }: { $why }
cli-teach-seen = останній кадр: { $file }
cli-teach-bad-answer = не три чи шість чисел і не end чи stop
cli-teach-point-off-seam = точка не в межах 15 мм від номінального шва
cli-teach-by-points = номінальний шов, підведений до точок оператора
cli-teach-done = { $ended } після { $way }, { $frames ->
        [one] { $frames } кадр
        [few] { $frames } кадри
       *[many] { $frames } кадрів
    } за { $time }; { $points ->
        [one] { $points } точка
        [few] { $points } точки
       *[many] { $points } точок
    }
cli-teach-closes = замикається в межах { $gap }
cli-teach-asked = запит до оператора: { $why }
cli-teach-spline = сплайн із { $pieces ->
        [one] { $pieces } ділянки
        [few] { $pieces } ділянок
       *[many] { $pieces } ділянок
    }
cli-teach-lines-and-arcs = { $lines ->
        [one] { $lines } відрізок
        [few] { $lines } відрізки
       *[many] { $lines } відрізків
    } і { $arcs ->
        [one] { $arcs } дуга
        [few] { $arcs } дуги
       *[many] { $arcs } дуг
    }
cli-teach-program = програма: { $curves } у межах { $error } від вивченої лінії
cli-teach-program-of-raw = програма: { $curves } у межах { $error } від вивченої лінії, { $raw } від кожної вихідної точки
cli-teach-truth = насправді { $across } RMS убік від шва, найбільше { $across-max }; { $height } RMS вище чи нижче, найбільше { $height-max }
cli-teach-no-address = не адреса
cli-teach-address = tcp://HOST:PORT, порт від 1 до 65535
cli-teach-no-frames = немає кадрів
cli-teach-not-a-camera = давач { $sensor } не є камерою
cli-teach-not-three-numbers = не три числа
cli-teach-distortion = SHIFT,TURN,BEND у мм, градусах, мм
cli-teach-shift = зсув { $value }
cli-teach-turn = поворот { $value }
cli-teach-bend = вигин { $value }
cli-teach-tack = FROM,TO у мм уздовж шва, FROM перед TO

# The server.
cli-serve-data = --data { $folder }: не вдалося створити: { $why }
cli-serve-no-job = такого завдання немає
cli-serve-jobs = файл, завдання в { $folder } або приклад: { $examples }
cli-serve-other-job = у теці даних є інше завдання з таким іменем
cli-serve-other-name = файл з іншим іменем, або --job { $name } звідти
cli-serve-no-token = у файлі немає токена
cli-serve-tokens = один рядок щонайменше з { $min } літер, цифр і знаків

# Acceptance benchmarks.
cli-bench-not-shipped = верстат { $machine } не постачається
cli-bench-half-ring = не вдалося спланувати півкільце

# Drawings.
cli-draw-points-as-spans = Точки як відрізки і дуги
cli-draw-seen-along = Вигляд уздовж { $axis }
cli-draw-points = точки
cli-draw-lines = відрізки
cli-draw-arcs = дуги
cli-draw-ends = кінці
cli-draw-spline = сплайн
cli-draw-taught-line = Вивчена лінія
cli-draw-from-nominal = Від номінального шва
cli-draw-distance = відстань
cli-draw-across = упоперек
cli-draw-above = вище
cli-draw-tolerance = допуск
cli-draw-raw-from-program = Вихідні точки від програми
cli-draw-raw-points = вихідні точки
cli-draw-frame-against-frame = Кадр відносно кадру
cli-draw-overlap = перекриття
cli-draw-confidence-title = Довіра
cli-draw-confidence = довіра
cli-draw-interpolation = Методи інтерполяції поруч
cli-draw-true-curve = справжня крива
cli-draw-paths = Шляхи, вигляд уздовж z
cli-draw-close = Імпульс за імпульсом, навколо середини шляху
cli-draw-steps = Пряма відстань за кожен період проти швидкість x період
cli-draw-angle = пройдений кут
cli-draw-deviation = відхилення
cli-draw-max-distance = Найбільша відстань точок від справжньої кривої

# Results of recorded welds.
cli-result-running = триває
cli-result-good = добре
cli-result-deviating = з відхиленнями
cli-result-stopped = зупинено
cli-result-interrupted = перервано

# Units in the table of tuning.
cli-tune-hz = Гц
cli-tune-per-s = 1/с
cli-tune-ms = мс
cli-tune-db = дБ
cli-stopped = зупинено в циклі { $cycle }
cli-no-cell-runs = там комірка не працює
cli-data-of-running-cell = папка даних працюючої панелі
cli-stop-unanswered = зупинку не підтверджено: { $why }

# Machine files of arms.
cli-arm-note = примітка: { $note }
cli-arm-next = перевірити: seamwright machine check { $file }
cli-arm-home = вихідне положення осі `{ $axis }` поза її діапазоном
cli-no-configurations = верстат не є рукою, конфігурації якої мають імена
cli-no-arm-angle = верстат не є рукою із сімома осями
# Програми роботів.
cli-not-for-robots = не для роботів
cli-options-of-robots = --tolerance-mm, --speed-percent, --retract-mm
cli-servo-not-here = потік заданих положень є лише в URScript
cli-servo-language = разом із --dialect urscript
cli-servo-alone = параметр належить до потоку заданих положень, а --servo-ms немає
cli-servo-with-period = разом із --servo-ms
cli-servo-period = від { $step } до { $max } з кроком { $step }

# Search for placements of the work.
cli-progress-reach = пошук установлень деталі
cli-label-judged = перевірено
cli-label-budget = бюджет
cli-label-present = зараз
cli-label-best = найкраще
cli-label-entry = запис
cli-reach-judged = установлення: { $placements }, придатні: { $weldable }
cli-reach-cut-off = { $budget } завершили пошук: --budget дасть більше
cli-reach-interrupted = Ctrl-C завершив пошук: результат — найкраще установлення зі знайдених
cli-label-moved = переміщується
cli-reach-moves-work = деталь, у її системі координат
cli-reach-moves-base = основа верстата, у його власній системі координат
cli-reach-base-entry = { $file }: { $key } = { $entry }
cli-reach-supplied = верстат входить до програми, файлу для запису немає
cli-reach-own-machine = файл верстата; його створює `seamwright machine show { $name } > machines/{ $name }.toml` поруч із завданням
cli-reach-at = x { $x }, y { $y }, z { $z } від нинішнього установлення, поворот { $turn }
cli-reach-margin = у осі { $axis } лишається { $margin } діапазону (прохід { $pass }, s = { $s })
cli-reach-free = придатне; жодна вісь не має діапазону
cli-reach-fails = непридатне: прохід { $pass }, s = { $s }: { $reason }
cli-reach-not-planned = { $placement }: планувальник відхиляє: { $reason }
cli-reach-none = немає придатного і запланованого установлення
cli-reach-entry = { $key }: move_mm = { $vector }, кут { $angle }
cli-reach-form = ВІД,ДО або ВІД,ДО,КЛІТИНКИ, де ВІД не більше ДО і клітинок не менше 1, наприклад -300,300,9
cli-reach-ends = кінці від { $min } до { $max }
cli-reach-reversed = діапазон починається вище за свій кінець
cli-reach-too-many-cells = у сітці { $cells } місць
cli-reach-cells-allowed = загалом до { $max } місць
cli-reach-no-file = немає такого файла для запису
cli-reach-job-file = файл завдання або програми; його створює `seamwright examples NAME > job.toml`
cli-reach-changed = { $file } змінено під час пошуку: нічого не записано
cli-label-planned = план
cli-reach-planned = у плані в осі { $axis } лишається { $margin } діапазону
cli-allowed-spark = адреса Spark Connect, наприклад sc://host:15002
