# Findings at the command line.
project-weld-possible = шов можна зварити, як задано
project-weld-possible-with-remarks = шов можна зварити, є зауваження
project-weld-impossible = шов неможливо зварити, як задано: { $findings ->
        [one] { $findings } зауваження
        [few] { $findings } зауваження
       *[many] { $findings } зауважень
    }
project-finding = { $severity } ({ $kind }): { $finding }
project-severity-error = зауваження
project-severity-warning = попередження
project-severity-note = примітка
project-where = де: { $places }
project-cure = що зробити: { $cure }
project-pass = прохід { $pass }
project-passes = проходи від { $first } до { $last }
project-place = { $passes }, s = { $s }
project-place-range = { $passes }, s = від { $from } до { $to }
project-places = { $first }; { $then }
project-more-places = ще { $places ->
        [one] { $places } місце
        [few] { $places } місця
       *[many] { $places } місць
    }

project-angles-of-another-plan = кути пальника належать до іншого плану
project-long-stick-out = пальник вільний лише за вильоту { $found }: понад { $usual } струм падає за тієї самої подачі дроту, а захисний газ рідшає
project-cure-long-stick-out = пальник, який краще входить у розробку, або технологія, у якій stick_out_mm це допускає

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
project-with-hint =
    { $message }
    { "   " }{ $hint }
project-or = { $first } або { $second }
project-note = примітка: { $note }
project-planning-cancelled = планування скасовано
project-failed = не вдалося
project-standard-input = стандартний ввід: { $why }
project-in-machine-file = файл верстата: { $why }
project-in-file = { $file }: { $why }
project-document-fault = { $file }:{ $line }: { $key }: { $message }

# Files.
project-unreadable = { $file }: не читається: { $why }
project-not-writable = { $file }: не записується: { $why }
project-writable = тека або файл, куди можна писати
project-no-such-folder = такої теки немає
project-permission-denied = немає дозволу
project-not-a-folder = це не тека
project-is-a-folder = це тека
project-file-too-large = { $file }: файл завеликий
project-up-to-1-gib = до 1 ГіБ
project-other-file-there = { $file }: на місці копії { $from } вже є інший файл
project-other-folder = інша тека виводу
project-files-written = { $files ->
        [one] { $files } файл
        [few] { $files } файли
       *[many] { $files } файлів
    } до { $folder }: { $names }
project-files-written-more = { $files ->
        [one] { $files } файл
        [few] { $files } файли
       *[many] { $files } файлів
    } до { $folder }: { $names } і ще { $more }
project-file-outside = назва веде за межі теки завдань
project-link-outside = посилання веде за межі теки завдань
project-not-a-plain-file = це не звичайний файл
project-file-above = він більший за { $max }

# Tables.
project-csv-value = { $file }:{ $line }: { $column } = `{ $value }`: { $fault }
project-not-a-finite-number = не скінченне число
project-no-column = { $file }:1: немає стовпця `{ $column }` у `{ $header }`
project-header-line = рядок заголовка з { $columns }, далі числа
project-header-line-with-commas = рядок заголовка з { $columns }, далі числа, через коми
project-table-too-long = { $file }: таблиця задовга
project-up-to-points = точок: до { $max }
project-file-from-job = наявний файл, шлях від теки завдання

# Jobs and machines.
project-no-such-file = { $file }: такого файлу немає
project-copy-example = є приклад `{ $name }`; щоб скопіювати: seamwright examples { $name } > { $name }.toml
project-job-or-example = файл завдання чи програми або назва прикладу: { $names }
project-program-without-seam = у програмі немає шва
project-job-or-seam = завдання або програма з [seam]
project-no-machine = верстата `{ $name }` немає
project-shipped-machine-or-file = верстат із комплекту або шлях до файлу верстата
project-no-machine-or-file = немає такого верстата і немає файлу { $file }
project-no-such-machine = { $name }: немає такого верстата і немає такого файлу
project-machine-names = { $names }, або шлях до файлу верстата
project-machine-refused = верстат `{ $name }`: { $why }
project-machine-among-jobs = назва верстата з комплекту або файл верстата серед завдань
project-machine-without-file = верстат `{ $name }` не має файлу
project-not-a-table = `{ $table }` — не таблиця
project-process-value-is-axis = параметр процесу `{ $name }` має назву осі верстата
project-one-head = { $machine } має одну головку: вона не зварить обидва кутові шви одночасно
project-no-recording-machine = немає верстата `{ $name }`, який міг би їх записати
project-machine-as-recorded = `machine`, яким він був під час запису
project-positions-for-axes = { $positions ->
        [one] { $positions } положення
        [few] { $positions } положення
       *[many] { $positions } положень
    }, а в { $machine } { $axes ->
        [one] { $axes } вісь
        [few] { $axes } осі
       *[many] { $axes } осей
    }
project-within-axis-ranges = положення в межах осей
project-option-tolerance = --tolerance-mm { $value }: { $why }

# Planning.
project-part-not-checked = деталь не описано: зіткнення перевіряються лише з верстатом та оснащенням
project-cure-describe-part = опишіть деталь через [[part.solids]] або через [seam], з якого її створюють
project-part-replaced = деталь, створену зі шва, замінено: зіткнення перевіряються лише з тілами з [part]
project-period-too-long = період { $period } довший за хід проходу { $pass }
project-period-within-travel = до { $max }, часу ходу
project-too-many-set-points = рух триває { $time }, заданих положень по { $period }: { $set-points }
project-up-to-set-points = заданих положень до { $max }; більша швидкість, коротші часи або довший період
project-tracking-with-devices = стеження за проходами йде із симульованими давачами, а файл верстата має власні пристрої
project-no-devices-or-tracking = файл верстата без [devices] або без стеження

# Devices.
project-register-too-small = прохід { $pass } задає { $value } для `{ $name }`, чого його регістр ({ $register }) пристрою `{ $device }` не вміщує
project-register-range = від { $min } до { $max }, або інший масштаб чи тип у файлі верстата
project-register-or-no-value = регістр `{ $value }` у [devices.{ $device }.modbus.set] файлу верстата або завдання без нього
project-check-modbus = перевірте кабель, адресу, номер пристрою й регістри; `seamwright machine io MACHINE` читає їх по одному
project-check-robot = перевірте кабель, адреси з обох боків і що програма `seamwright machine robot-program { $protocol }` виконується в системі керування
project-period-of-no-cell = верстат `{ $machine }`: жодна комірка не працює з servo_period_ms { $period }
project-periods = від { $min } до { $max }, без ключа 1 мс; `seamwright machine latency` вимірює, що може цей комп’ютер
project-linuxcnc-needs-linux = приводи через LinuxCNC бувають лише в Linux
project-simulated = симулюються: { $devices }
project-drives = приводи
project-process-source = джерело живлення процесу
project-inputs = входи
project-pulses-end = { $file }: { $why }: імпульси тут закінчуються

# Welds that were interrupted.
project-journal-damaged = { $folder }: обидва файли журналу положень пошкоджено: шов міг перерватися в невідомому місці
project-look-and-choose = огляньте деталь, потім --from PASS,MM, щоб продовжити там, або --from 1,0, щоб варити спочатку
project-weld-left = шов { $weld } перервав збій живлення або програми: прохід { $pass }, зварено до { $welded }, пальник на { $torch }
project-grind-and-continue = огляньте кінець валика, зачистьте його, потім --from { $from }; або --from 1,0, щоб варити спочатку
project-journal-thread-failed = потік журналу зазнав збою

# Teaching by camera.
project-no-taught-program = зі знайденої лінії не виходить програма: { $why }
project-teach-machine-limit = верстат не може йти далі: { $why }
project-teach-joint-too-long = стик довший за подвоєний номінальний шов
project-teach-joint-lost = стик загублено
project-teach-no-joint = стику не знайдено
project-teach-no-more-frames = кадри закінчилися раніше за стик
project-cure-teach = продовжуйте навчання звідти з --start, дозвольте більше --longest-tack-mm або візьміть точки вручну
project-goes-on = продовжує прохід { $pass } від { $from }

# Search for placements.
project-reach-axes = прохід { $pass } заданий положеннями осей: установлення деталі його не зсуває
project-reach-axes-allowed = проходи вздовж шва або через точки пальника
