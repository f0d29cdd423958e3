# Errors of files and of the library.
record-full =
    { $path }: { $why }
       разрешено: освободите место на диске или возьмите другую папку данных; записанное ранее сохранено
record-disk-full = диск полон
record-no-room = свободно { $free }, запись сварки требует { $needed }
record-read-only =
    { $path }: запись запрещена: { $why }
       разрешено: папка, в которую можно писать
record-not-read =
    { $path }: не удалось прочитать: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-written =
    { $path }: не удалось записать: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-created =
    { $path }: не удалось создать: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-removed =
    { $path }: не удалось удалить: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-moved =
    { $path }: не удалось переместить: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-archived =
    { $path }: не удалось добавить в архив: { $why }
       разрешено: существующий файл или папка на исправном диске
record-not-unpacked =
    { $path }: не удалось распаковать архив: { $why }
       разрешено: существующий файл или папка на исправном диске
record-damaged =
    { $path }: { $why }
       разрешено: { $allowed }
record-newer =
    { $path }: записано более новой версией (схема { $found }, эта версия читает до { $known })
       разрешено: та версия Seamwright; ничего не изменено
record-busy =
    { $path }: используется другой программой
       разрешено: повторите, когда она завершится
record-search-ended =
    { $path }: поиск занял слишком много времени
       разрешено: повторите с меньшим промежутком времени или без текста
record-invalid =
    { $what }
       разрешено: { $allowed }
record-database = { $path }: { $why }
record-invalid-moment = неверная дата: { $text }; разрешено: 2026-11-21 или "2026-11-21 14:05", UTC

# The library.
record-library-damaged = библиотека повреждена ({ $why })
record-library-from-copy = замените её последней копией или уберите: будет создана новая библиотека, записи хода останутся
record-library-missing = { $path }: библиотеки нет
record-begin-library = папка данных с записанными сварками: simulate JOB -o DIR --data DIR создаёт её
record-schema-version = версия её схемы { $found }, эта программа читает { $known }
record-migrate = любая команда, которая пишет в неё, обновит её: records recover
record-no-library = это не библиотека Seamwright
record-other-folder = другая папка данных
record-own-archive = архив, созданный `records backup`
record-own-schema = архив библиотеки, которую изменяла только Seamwright; сначала удалите постороннее с помощью sqlite3
record-schema-foreign = в библиотеке есть посторонний объект ({ $kind }) `{ $name }`
record-schema-changed = в библиотеке изменён { $kind } `{ $name }`
record-schema-missing = в библиотеке не хватает { $kind } `{ $name }`
record-loose-row = строка таблицы { $table } ссылается на отсутствующую строку
record-no-document = документа { $id } нет
record-no-alarm = тревоги { $id } нет
record-known-number = номер из библиотеки
record-no-weld = { $path }: сварки { $id } нет
record-no-welds-yet = пока ничего: ни одной сварки не записано
record-weld-damaged = сварка { $id }: { $why }
record-whole-library = неповреждённая библиотека
record-foreign-file = она называет `{ $name }` для сварки { $id }, но это не её файл
record-own-files = имена файлов в папке сварки
record-finite-numbers = конечные числа

# Traces.
record-no-trace = это не запись хода: { $why }
record-own-parquet = файл Parquet, записанный Seamwright
record-own-trace = запись хода, созданная Seamwright
record-column-kind = столбец { $column } содержит { $kind }
record-trace-groups = группы более чем из { $max } строк или столбцы разной или отрицательной длины
record-no-column = { $path }: столбца { $column } нет
record-row-length =
    { $path }: строка из { $n ->
        [one] { $n } значения
       *[other] { $n } значений
    }
record-value-per-column = { $n }, по одному на столбец
record-trace-left = эта запись осталась после сбоя, или её сейчас пишут
record-recover-first = сначала восстановите её: seamwright records recover
record-trace-replaced = удалено или заменено во время записи: строки потеряны
record-folder-untouched = не изменяйте папку до конца сварки
record-no-raw-trace = это не сырая запись, или она оборвана в заголовке
record-own-raw-trace = файл, начатый записью хода

# Backup and restore.
record-folder-not-empty = { $path }: папка не пуста
record-empty-folder = пустая или новая папка
record-archive-as-written = неизменённый архив
record-manifest-missing = { $name }: отсутствует, хотя версия, записавшая архив, его пишет
record-manifest-size = { $name }: { $size }, слишком велик
record-archive-changed = { $name }: изменено, пропало или добавлено после резервного копирования
record-archive-without-hashes = архив не имеет списка хешей и не в порядке: { $problem }
record-archive-problems =
    содержимое не в порядке: { $problem } ({ $more ->
        [0] других неполадок нет
        [one] и ещё { $more } неполадка
        [few] и ещё { $more } неполадки
       *[other] и ещё { $more } неполадок
    })
record-restore-elsewhere = `seamwright records restore` восстанавливает его в отдельную папку
record-nothing-restored = ничего не восстановлено
record-checked-archive = проверенный архив
record-archive-foreign = он содержит { $name }, постороннее для резервной копии
record-archive-outside = { $name } ведёт за пределы архива
record-archive-entries = более { $max } файлов и папок
record-archive-fewer = папка данных с меньшим числом файлов
record-archive-name = имя или дополнение к нему длиннее { $max } КиБ
record-archive-cut-off = нет конца архива
record-archive-no-library = в архиве нет библиотеки

# Problems found by `records verify`.
record-problem-audit = журнал действий, запись { $id }: { $why }
record-audit-missing = записи нет
record-audit-hash = хеш не соответствует записи или предыдущей
record-audit-cut-off = этой записи и всех после неё нет
record-problem-lost = сварка { $id }: библиотека потеряла её запись; файлы в { $folder }
record-problem-unfinished = сварка { $id }: её запись ещё пишется
record-problem-left = сварка { $id }: сбой оставил её запись незавершённой; выполните `records recover`
record-problem-program = сварка { $id }: текст её программы изменён
record-problem-changed = { $path }: изменено после записи

# Notes of a weld.
record-notes = { $first }; { $then }
record-interrupted = прервано: { $cause }
record-log-damaged = строка журнала этой сварки повреждена
record-rows-late = диск был слишком медленным
record-rows-lost = потеряно строк записи хода: { $n }: { $why }
record-incomplete = запись неполная: { $why }
record-no-figures = показателей нет: { $why }
record-heat-input-outside = тепловложение вне пределов технологии на { $length }
record-recovered = восстановлено { $time }
record-recovered-without = восстановлено { $time } без последних { $size } записи хода, которые не составляют целых строк
