# Findings at the command line.
project-weld-possible = шов можно сварить, как задано
project-weld-possible-with-remarks = шов можно сварить, есть замечания
project-weld-impossible = шов нельзя сварить, как задано: { $findings ->
        [one] { $findings } замечание
        [few] { $findings } замечания
       *[many] { $findings } замечаний
    }
project-finding = { $severity } ({ $kind }): { $finding }
project-severity-error = замечание
project-severity-warning = предупреждение
project-severity-note = примечание
project-where = где: { $places }
project-cure = что сделать: { $cure }
project-pass = проход { $pass }
project-passes = проходы от { $first } до { $last }
project-place = { $passes }, s = { $s }
project-place-range = { $passes }, s = от { $from } до { $to }
project-places = { $first }; { $then }
project-more-places = ещё { $places ->
        [one] { $places } место
        [few] { $places } места
       *[many] { $places } мест
    }

project-angles-of-another-plan = углы горелки относятся к другому плану
project-long-stick-out = горелка свободна только при вылете { $found }: свыше { $usual } ток падает при той же подаче проволоки, а защитный газ редеет
project-cure-long-stick-out = горелка, которая лучше входит в разделку, или технология, у которой stick_out_mm это допускает

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
project-with-hint =
    { $message }
    { "   " }{ $hint }
project-or = { $first } или { $second }
project-note = примечание: { $note }
project-planning-cancelled = планирование отменено
project-failed = не удалось
project-standard-input = стандартный ввод: { $why }
project-in-machine-file = файл станка: { $why }
project-in-file = { $file }: { $why }
project-document-fault = { $file }:{ $line }: { $key }: { $message }

# Files.
project-unreadable = { $file }: не читается: { $why }
project-not-writable = { $file }: не записывается: { $why }
project-writable = папка или файл, куда можно писать
project-no-such-folder = такой папки нет
project-permission-denied = нет разрешения
project-not-a-folder = это не папка
project-is-a-folder = это папка
project-file-too-large = { $file }: файл слишком велик
project-up-to-1-gib = до 1 ГиБ
project-other-file-there = { $file }: на месте копии { $from } уже есть другой файл
project-other-folder = другая папка вывода
project-files-written = { $files ->
        [one] { $files } файл
        [few] { $files } файла
       *[many] { $files } файлов
    } в { $folder }: { $names }
project-files-written-more = { $files ->
        [one] { $files } файл
        [few] { $files } файла
       *[many] { $files } файлов
    } в { $folder }: { $names } и ещё { $more }
project-file-outside = имя ведёт за пределы папки заданий
project-link-outside = ссылка ведёт за пределы папки заданий
project-not-a-plain-file = это не обычный файл
project-file-above = он больше { $max }

# Tables.
project-csv-value = { $file }:{ $line }: { $column } = `{ $value }`: { $fault }
project-not-a-finite-number = не конечное число
project-no-column = { $file }:1: нет столбца `{ $column }` в `{ $header }`
project-header-line = строка заголовка с { $columns }, затем числа
project-header-line-with-commas = строка заголовка с { $columns }, затем числа, через запятые
project-table-too-long = { $file }: таблица слишком длинная
project-up-to-points = точек: до { $max }
project-file-from-job = существующий файл, путь от папки задания

# Jobs and machines.
project-no-such-file = { $file }: такого файла нет
project-copy-example = есть пример `{ $name }`; чтобы скопировать: seamwright examples { $name } > { $name }.toml
project-job-or-example = файл задания или программы либо имя примера: { $names }
project-program-without-seam = в программе нет шва
project-job-or-seam = задание или программа с [seam]
project-no-machine = станка `{ $name }` нет
project-shipped-machine-or-file = станок из комплекта или путь к файлу станка
project-no-machine-or-file = нет такого станка и нет файла { $file }
project-no-such-machine = { $name }: нет такого станка и нет такого файла
project-machine-names = { $names } или путь к файлу станка
project-machine-refused = станок `{ $name }`: { $why }
project-machine-among-jobs = имя станка из комплекта или файл станка среди заданий
project-machine-without-file = у станка `{ $name }` нет файла
project-not-a-table = `{ $table }` — не таблица
project-process-value-is-axis = параметр процесса `{ $name }` называется как ось станка
project-one-head = у { $machine } одна головка: она не сварит оба угловых шва сразу
project-no-recording-machine = нет станка `{ $name }`, который мог бы их записать
project-machine-as-recorded = `machine`, каким он был при записи
project-positions-for-axes = { $positions ->
        [one] { $positions } положение
        [few] { $positions } положения
       *[many] { $positions } положений
    }, а у { $machine } { $axes ->
        [one] { $axes } ось
        [few] { $axes } оси
       *[many] { $axes } осей
    }
project-within-axis-ranges = положения в пределах осей
project-option-tolerance = --tolerance-mm { $value }: { $why }

# Planning.
project-part-not-checked = деталь не описана: столкновения проверяются только со станком и оснасткой
project-cure-describe-part = опишите деталь через [[part.solids]] или через [seam], из которого она создаётся
project-part-replaced = деталь, созданная из шва, заменена: столкновения проверяются только с телами из [part]
project-period-too-long = период { $period } длиннее хода прохода { $pass }
project-period-within-travel = до { $max }, времени хода
project-too-many-set-points = движение длится { $time }, заданных положений по { $period }: { $set-points }
project-up-to-set-points = заданных положений до { $max }; большая скорость, меньшие времена или больший период
project-tracking-with-devices = слежение за проходами идёт с симулируемыми датчиками, а у файла станка свои устройства
project-no-devices-or-tracking = файл станка без [devices] или без слежения

# Devices.
project-register-too-small = проход { $pass } задаёт { $value } для `{ $name }`, чего его регистр ({ $register }) устройства `{ $device }` не вмещает
project-register-range = от { $min } до { $max }, или другой масштаб либо тип в файле станка
project-register-or-no-value = регистр `{ $value }` в [devices.{ $device }.modbus.set] файла станка или задание без него
project-check-modbus = проверьте кабель, адрес, номер устройства и регистры; `seamwright machine io MACHINE` читает их по одному
project-check-robot = проверьте кабель, адреса с обеих сторон и что программа `seamwright machine robot-program { $protocol }` выполняется в системе управления
project-period-of-no-cell = станок `{ $machine }`: ни одна ячейка не работает с servo_period_ms { $period }
project-periods = от { $min } до { $max }, без ключа 1 мс; `seamwright machine latency` измеряет, что может этот компьютер
project-linuxcnc-needs-linux = приводы через LinuxCNC есть только в Linux
project-simulated = симулируются: { $devices }
project-drives = приводы
project-process-source = источник питания процесса
project-inputs = входы
project-pulses-end = { $file }: { $why }: импульсы здесь кончаются

# Welds that were interrupted.
project-journal-damaged = { $folder }: оба файла журнала положений повреждены: шов мог прерваться в неизвестном месте
project-look-and-choose = осмотрите деталь, затем --from PASS,MM, чтобы продолжить там, или --from 1,0, чтобы варить сначала
project-weld-left = шов { $weld } прервал сбой питания или программы: проход { $pass }, сварено до { $welded }, горелка на { $torch }
project-grind-and-continue = осмотрите конец валика, зачистите его, затем --from { $from }; или --from 1,0, чтобы варить сначала
project-journal-thread-failed = поток журнала дал сбой

# Teaching by camera.
project-no-taught-program = из найденной линии не выходит программа: { $why }
project-teach-machine-limit = станок не может идти дальше: { $why }
project-teach-joint-too-long = стык длиннее удвоенного номинального шва
project-teach-joint-lost = стык потерян
project-teach-no-joint = стык не найден
project-teach-no-more-frames = кадры кончились раньше стыка
project-cure-teach = продолжайте обучение оттуда с --start, разрешите больше --longest-tack-mm или возьмите точки вручную
project-goes-on = продолжено в проходе { $pass } с { $from }

# Search for placements.
project-reach-axes = проход { $pass } задан положениями осей: установка детали его не сдвигает
project-reach-axes-allowed = проходы вдоль шва или через точки горелки
