# Errors of files and of the library.
record-full =
    { $path }: { $why }
       дозволено: звільніть місце на диску або візьміть іншу теку даних; записане раніше збережено
record-disk-full = диск повний
record-no-room = вільно { $free }, запис зварювання потребує { $needed }
record-read-only =
    { $path }: запис заборонено: { $why }
       дозволено: тека, у яку можна писати
record-not-read =
    { $path }: не вдалося прочитати: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-written =
    { $path }: не вдалося записати: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-created =
    { $path }: не вдалося створити: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-removed =
    { $path }: не вдалося вилучити: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-moved =
    { $path }: не вдалося перемістити: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-archived =
    { $path }: не вдалося додати до архіву: { $why }
       дозволено: наявний файл або тека на справному диску
record-not-unpacked =
    { $path }: не вдалося розпакувати архів: { $why }
       дозволено: наявний файл або тека на справному диску
record-damaged =
    { $path }: { $why }
       дозволено: { $allowed }
record-newer =
    { $path }: записано новішою версією (схема { $found }, ця версія читає до { $known })
       дозволено: та версія Seamwright; нічого не змінено
record-busy =
    { $path }: використовує інша програма
       дозволено: спробуйте знову, коли вона завершиться
record-search-ended =
    { $path }: пошук тривав надто довго
       дозволено: спробуйте з меншим проміжком часу або без тексту
record-invalid =
    { $what }
       дозволено: { $allowed }
record-database = { $path }: { $why }
record-invalid-moment = неправильна дата: { $text }; дозволено: 2026-11-21 або "2026-11-21 14:05", UTC

# The library.
record-library-damaged = бібліотека пошкоджена ({ $why })
record-library-from-copy = замініть її останньою копією або приберіть: буде створено нову бібліотеку, записи ходу залишаться
record-library-missing = { $path }: бібліотеки немає
record-begin-library = тека даних із записаними зварюваннями: simulate JOB -o DIR --data DIR створює її
record-schema-version = версія її схеми { $found }, ця програма читає { $known }
record-migrate = будь-яка команда, що пише в неї, оновить її: records recover
record-no-library = це не бібліотека Seamwright
record-other-folder = інша тека даних
record-own-archive = архів, створений `records backup`
record-own-schema = архів бібліотеки, яку змінювала лише Seamwright; спершу вилучіть стороннє за допомогою sqlite3
record-schema-foreign = у бібліотеці є сторонній об’єкт ({ $kind }) `{ $name }`
record-schema-changed = у бібліотеці змінено { $kind } `{ $name }`
record-schema-missing = у бібліотеці бракує { $kind } `{ $name }`
record-loose-row = рядок таблиці { $table } посилається на відсутній рядок
record-no-document = документа { $id } немає
record-no-alarm = тривоги { $id } немає
record-known-number = номер, що є в бібліотеці
record-no-weld = { $path }: зварювання { $id } немає
record-no-welds-yet = поки нічого: жодного зварювання не записано
record-weld-damaged = зварювання { $id }: { $why }
record-whole-library = неушкоджена бібліотека
record-foreign-file = вона називає `{ $name }` для зварювання { $id }, але це не його файл
record-own-files = імена файлів у теці зварювання
record-finite-numbers = скінченні числа

# Traces.
record-no-trace = це не запис ходу: { $why }
record-own-parquet = файл Parquet, записаний Seamwright
record-own-trace = запис ходу, створений Seamwright
record-column-kind = стовпець { $column } містить { $kind }
record-trace-groups = групи більш ніж із { $max } рядків або стовпці різної або від'ємної довжини
record-no-column = { $path }: стовпця { $column } немає
record-row-length =
    { $path }: рядок із { $n ->
        [one] { $n } значення
       *[other] { $n } значень
    }
record-value-per-column = { $n }, по одному на стовпець
record-trace-left = цей запис лишився після збою, або його зараз пишуть
record-recover-first = спершу відновіть її: seamwright records recover
record-trace-replaced = вилучено або замінено під час запису: рядки втрачено
record-folder-untouched = не змінюйте теку до кінця зварювання
record-no-raw-trace = це не сирий запис, або його обірвано в заголовку
record-own-raw-trace = файл, розпочатий записом ходу

# Backup and restore.
record-folder-not-empty = { $path }: тека не порожня
record-empty-folder = порожня або нова тека
record-archive-as-written = незмінений архів
record-manifest-missing = { $name }: відсутній, хоча версія, що записала архів, його пише
record-manifest-size = { $name }: { $size }, завеликий
record-archive-changed = { $name }: змінено, зникло або додано після резервного копіювання
record-archive-without-hashes = архів не має переліку хешів і не в порядку: { $problem }
record-archive-problems =
    вміст не в порядку: { $problem } ({ $more ->
        [0] інших вад немає
        [one] і ще { $more } вада
        [few] і ще { $more } вади
       *[other] і ще { $more } вад
    })
record-restore-elsewhere = `seamwright records restore` відновлює його в окрему теку
record-nothing-restored = нічого не відновлено
record-checked-archive = перевірений архів
record-archive-foreign = він містить { $name }, стороннє для резервної копії
record-archive-outside = { $name } веде за межі архіву
record-archive-entries = понад { $max } файлів і тек
record-archive-fewer = тека даних із меншою кількістю файлів
record-archive-name = ім'я або доповнення до нього довше за { $max } КіБ
record-archive-cut-off = бракує кінця архіву
record-archive-no-library = в архіві немає бібліотеки

# Problems found by `records verify`.
record-problem-audit = журнал дій, запис { $id }: { $why }
record-audit-missing = запису немає
record-audit-hash = хеш не відповідає запису або попередньому
record-audit-cut-off = цього запису й усіх після нього немає
record-problem-lost = зварювання { $id }: бібліотека втратила його запис; файли в { $folder }
record-problem-unfinished = зварювання { $id }: його запис ще пишуть
record-problem-left = зварювання { $id }: збій лишив його запис незавершеним; виконайте `records recover`
record-problem-program = зварювання { $id }: текст програми змінено
record-problem-changed = { $path }: змінено після запису

# Notes of a weld.
record-notes = { $first }; { $then }
record-interrupted = перервано: { $cause }
record-log-damaged = рядок журналу цього зварювання пошкоджено
record-rows-late = диск був надто повільним
record-rows-lost = втрачено рядків запису ходу: { $n }: { $why }
record-incomplete = запис неповний: { $why }
record-no-figures = показників немає: { $why }
record-heat-input-outside = тепловкладення поза межами технології на { $length }
record-recovered = відновлено { $time }
record-recovered-without = відновлено { $time } без останніх { $size } запису ходу, що не утворюють цілих рядків
