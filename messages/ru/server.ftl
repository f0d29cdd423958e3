# Запуск и конец сервера.
server-syslog-receiver = не приёмник syslog: { $text }; допустимо: udp://HOST:PORT или tcp://HOST:PORT, порт от 1 до 65535 (по умолчанию 514), адреса IPv6 в скобках
server-bind = { $option }: { $why }
server-bind-free = адрес и свободный порт
server-bind-plain = этот адрес доступен другим компьютерам, а шифрования нет
server-bind-encrypted = с --tls, или --cert и --key; 127.0.0.1, [::1]
server-bind-no-admin = этот адрес доступен другим компьютерам, а пароля ещё ни у кого нет
server-bind-local-first = 127.0.0.1 или [::1], чтобы сначала создать там администратора с паролем
server-bind-no-name = не указано имя этого компьютера
server-bind-named = с --host NAME, или один адрес
server-certificate-failed = не удалось создать сертификат: { $why }
server-certificate-files = { $options }: { $why }
server-pem-files = файлы PEM сертификата и его закрытого ключа
server-panicked = сбой программы (panic): ячейка остановлена, её устройствам дана команда выключиться
server-library-open = не удалось закрыть библиотеку: ничего не восстановлено
server-look-at-once = немедленно проверьте, выключены ли дуга и газ

# Requests.
server-failed = не удалось; ничего не изменено
server-program-fault = прервано из-за ошибки программы: сообщите о ней, пожалуйста
server-no-thread = поток не запускается: { $why }
server-panel-ends = панель завершает работу
server-slow-down = слишком много таких запросов: повторите через мгновение
server-too-many-requests = слишком много запросов сразу: подождите немного
server-request-late = запрос поступал слишком долго
server-request-too-large = запрос слишком велик; допустимо: до { $max } КиБ
server-too-many-pages = открыто слишком много страниц: закройте одну
server-cell-ended = ячейка завершила работу
server-cell-silent = ячейка не отвечает: повторите
server-no-machine = нет станка
server-no-machine-named = станка «{ $name }» нет
server-no-axis = оси «{ $axis }» нет; допустимо: { $allowed }
server-no-language = языка «{ $language }» нет; { $allowed }
server-file-trouble = { $file }: { $why }
server-file-unreadable = { $file } не читается: { $why }

# Log-in and permissions.
server-unknown-host = эта панель неизвестна как «{ $host }»; допустимо: { $allowed }
server-other-origin = запросы со страниц другого происхождения отклоняются
server-not-logged-in = вход не выполнен или сеанс окончен: войдите
server-session-over = сеанс окончен: войдите
server-role = роль «{ $role }» этого не позволяет ({ $action })
server-role-from = роль «{ $role }» этого не позволяет ({ $action }); допустимо: от «{ $needed }» и выше
server-header = заголовок «{ $header }» должен быть «{ $value }»
server-token = в заголовке «{ $header }» должен быть токен сеанса
server-content-type = тип содержимого «{ $kind }» не принимается; допустимо: { $allowed }
server-wrong-passwords = слишком много неверных паролей: подождите { $wait }
server-login-too-long = имя или пароль слишком длинные; допустимо: до { $max }
server-login-wrong = неверные имя или пароль, или устаревшая ссылка
server-no-random = нет случайных чисел: { $why }

# Users.
server-own-password = для этого нужен ваш собственный пароль, а он неверен
server-user-exists = пользователь «{ $user }» уже есть
server-no-user = пользователя «{ $user }» нет
server-user-name = недопустимое имя; допустимо: буквы, цифры, - _ . и пробелы между ними, до { $max }
server-user-owner = «{ $user }» зарезервировано для стартовой ссылки: выберите другое имя
server-password-length = недопустимая длина пароля; допустимо: от { $min } до { $max } знаков
server-password-needed = новому пользователю нужен пароль
server-password-hash = пароль не хешируется: { $why }
server-too-many-users = слишком много пользователей; допустимо: { $max }
server-last-admin = не осталось бы администратора: сначала сделайте администратором другого разрешённого пользователя

# Jobs.
server-job-name = недопустимое имя задания: «{ $name }»; допустимо: буквы, цифры, - _ . ( ) + и пробелы, до { $max }, в конце .toml
server-no-job = задания «{ $job }» нет
server-no-own-job = своего задания «{ $job }» нет
server-jobs-unreadable = папка заданий не читается: { $why }
server-template-name = «{ $job }» – имя образца: сохраните задание под другим
server-other-text = под именем «{ $job }» сохранён другой текст
server-search-too-long = текст поиска слишком длинный; допустимо: до { $max } символов
server-too-many-jobs = слишком много заданий; допустимо: { $max }
server-job-not-deleted = { $job } не удаляется: { $why }
server-too-many-operations = слишком много действий; допустимо: до { $max } за раз
server-operation = действие { $n }: { $why }
server-at-key = { $key }: { $what }
server-at-value = { $key } = { $value }: { $what }
server-and-allowed = { $what }; допустимо: { $allowed }
server-and-help = { $what }; { $help }

# Planning.
server-superseded = отменено или заменено более новым запросом
server-planning-time = планирование длится дольше { $max }; уменьшите число проходов, валиков или точек
server-planning-memory = планирование требует больше { $max } ГиБ памяти; уменьшите число проходов, валиков или точек
server-plan-too-large = план слишком велик для показа; допустимо: до { $max }
server-no-process = процесс для планирования не запускается: { $why }
server-no-pipes = процесс для планирования не запускается: нет каналов
server-planning-failed = планирование не удалось; на ячейку это не влияет: { $why }
server-no-dialect = диалекта «{ $name }» нет; допустимо: { $allowed }

# Loading.
server-part-number = недопустимый номер детали; допустимо: до { $max } видимых знаков
server-machine-moves = станок движется или на паузе: сначала остановите его
server-other-devices = файл станка задания называет другие устройства, чем файл, с которым запущена панель; допустимо: те же [devices] или никаких
server-devices-held = устройства не освобождаются: перезапустите панель
server-devices-not-connected = устройства не соединяются
server-needs-other-devices = задание для другого станка: сначала выключите приводы
server-loading = загружается другая программа: подождите немного
server-load-announced = задание планируется для загрузки: подождите, пока оно будет в ячейке
server-overlap = недопустимое перекрытие { $value }; допустимо: до { $max }
server-nothing-to-weld = проход { $pass }, { $s }: варить больше нечего; допустимо: проход от 1 до { $passes }, в пределах его длины
server-finished-pass = деталь «{ $part }» сварена до прохода { $pass }, { $s }: этот пуск сварил бы её снова; продолжите оттуда или подтвердите
server-finished-part = деталь «{ $part }» сварена целиком (сварка { $weld }): этот пуск сварил бы её снова; подтвердите или назовите другую деталь

# Commands over the socket.
server-message-invalid = недопустимое сообщение: { $why }
server-unknown-command = неизвестная команда «{ $name }»; допустимо: { $allowed }
server-no-control = эта страница не управляет: сначала возьмите управление
server-control-jogs = управляющая страница двигает оси вручную: подождите, пока отпустят кнопку
server-control-held = управляет { $user }, страница { $page }
server-replayed = команда { $n } уже была; допустимо: больше { $last }
server-busy = слишком много команд сразу
server-at-rest = ничего не движется
server-override-range = коррекция { $value }; допустимо: от 0 до 1
server-no-alarm = тревоги { $number } нет; допустимо: от 1 до { $max }
server-step-range = шаг { $value }; допустимо: до { $max } в обе стороны
server-positions-unknown = положения осей неизвестны
server-no-such-axis = такой оси нет
server-tip-directions = остриё движется только вдоль x, y и z
server-axis-count = осей: { $n }; допустимо: { $allowed }
server-axes-moving = оси ещё движутся: подождите немного
server-not-homed = ось { $axis } не привязана: сначала выполните поиск нулей
server-shelve-time = { $minutes } мин; допустимо: до { $max }
server-alarm-not-listed = этой тревоги нет в списке
server-alarm-reacts = у «{ $alarm }» есть реакция ({ $reaction }); отложить можно лишь тревоги без реакции

# Set-up.
server-no-job-loaded = задание не загружено: сначала загрузите задание этого станка
server-axis-not-in-file = оси нет в её файле
server-no-parameter = параметра «{ $key }» нет; допустимо: { $allowed }
server-other-kind-of-axis = «{ $key }» относится к другому типу осей
server-no-head = головки { $head } нет; допустимо: от 0 до { $max }
server-too-many-touches = касаний: { $n }; допустимо: до { $max }
server-touch = недопустимое касание { $touch }; допустимо: положений { $n }, мм или градусы, до 1000000
server-more-touches = { $why }; коснитесь одной точки трижды или больше, наклоняя горелку на 20 градусов или больше
server-tip-far = tip_mm { $tip }; допустимо: до { $max }
server-no-camera = «{ $sensor }» не камера; допустимо: датчик с `map.heights`
server-grid = недопустимая сетка: шаг { $pitch }, высота { $z }; допустимо: шаг больше 0
server-no-sensor = датчика «{ $sensor }» нет; допустимо: { $allowed }
server-not-simulated = не симулируется; допустимо: симулированные устройства, до { $max } пикселей
server-scale-differs = масштаб отличается на { $difference }: проверьте шаг и высоту
server-picture-size = на изображении { $pixels } пикселей; допустимо: { $allowed }
server-no-sensor-key = «{ $key }» нет; допустимо: { $allowed }
server-number-count = у «{ $key }» чисел: { $n }; допустимо: { $allowed }
server-too-many-planes = плоскостей: { $n }; допустимо: до { $max }

# Placing the part by touching.
server-probe-radius = радиус щупа { $value }; допустимо: от 0 до { $max }
server-too-many-points = точек: { $n }; допустимо: до { $max }
server-feature = точка { $point }: неизвестный элемент «{ $feature }»; допустимо: { $allowed }
server-point-far = точка { $point } слишком далеко; допустимо: до { $max }
server-more-points = { $why }; возьмите больше точек, распределённых по поверхностям, или другой способ
server-more-points-round = { $why }; возьмите больше точек по торцу и вокруг
server-no-surfaces = у задания нет шва, поверхностей которого можно коснуться: возьмите задание со швом
server-not-determined = не определено: { $what }; без изменений
server-turn-about-axis = поворот вокруг оси
server-no-spare-points = точек не больше, чем неизвестных: плохую точку не заметить
server-three-points-plane = плоскость: только три точки; плохую не заметить
server-three-points-face = торец: только три точки; плохую не заметить
server-three-points-round = круг: только три точки; плохую не заметить
server-round-diameter = диаметр круга: { $diameter }
server-no-position = точки не определяют положения
server-offsets-no-table = `offsets` не таблица; допустимо: [offsets.NAME]

# Records and backup.
server-query = { $name }: { $why }
server-too-many-values = слишком много: столбцов { $columns } по { $rows } строк; допустимо: до { $max-columns } столбцов, { $max-values } значений
server-row-count = most={ $value }; допустимо: от { $min } до { $max }
server-no-column = столбца «{ $column }» нет; допустимо: { $allowed }
server-not-off = станок не выключен: сначала выключите приводы
server-archive-too-large = архив слишком велик; допустимо: до { $max }; большие берёт `seamwright records restore`
server-archive-broke-off = передача архива прервана
server-archive-no-admin = в архиве нет администратора: панелью никто не смог бы пользоваться
server-no-archive = ни один архив не проверен: сначала отправьте его
server-record-being-written = запись сварки ещё пишется: подождите
server-backup-runs = копия создаётся или проверяется: подождите до конца

# Teaching by camera.
server-no-image = изображения ещё нет
server-teach-point = пиксель и положение; допустимо: одно из них или ни одного
server-teach-no-work = на изображении там нет детали
server-teach-range = { $key } { $value }; допустимо: от { $min } до { $max }
server-teach-above = { $key } { $value }; допустимо: больше 0, до { $max }
server-teach-method = неизвестный способ «{ $method }»; допустимо: { $allowed }
server-teach-nothing = ещё ничего не обучено
server-teach-tack = недопустимая прихватка; допустимо: начало перед концом, оба конечные
server-teach-order = недопустимое указание
server-teach-real-devices = устройства станка настоящие, а его файл не называет `frames` камеры: обучайте вручную
server-teach-no-program = программа не загружена: её шов задаёт номинальный стык
server-teach-is-open = сеанс уже открыт: сначала остановите его
server-teach-not-open = сеанс не открыт
server-teach-not-asked = положение стыка сейчас не нужно
server-teach-not-paused = ничего не приостановлено
server-teach-far = положение не у номинального шва; допустимо: до 15 мм от него
server-teach-start-far = начало не у номинального шва
server-teach-other-machine = { $job } предназначено для { $machine }, а не для этой ячейки
server-teach-no-frames = устройства станка настоящие, а у sensors.{ $sensor } нет `frames`
server-teach-no-camera = у { $machine } нет камеры; допустимо: станок с [sensors.NAME] и kind = "camera" в файле
server-teach-sensor-no-camera = { $sensor } не камера
server-teach-blocked = ячейка остановила оси в пути: смотрите тревоги
server-camera-address = файл станка называет камеру { $address }, к которой эта ячейка не подключается; допустимо: этот компьютер; другие – `seamwright serve --camera HOST:PORT`
server-camera-address-list = файл станка называет камеру { $address }, к которой эта ячейка не подключается; допустимо: этот компьютер, { $allowed }; другие – `seamwright serve --camera HOST:PORT`

# Audit log: where from, what, and result.
server-audit-panel = панель
server-audit-panel-number = панель { $number }
server-audit-panel-at = панель на { $address }
server-audit-save-job = сохранить задание { $job }
server-audit-delete-job = удалить задание { $job }
server-audit-load = загрузить { $job }
server-audit-change-user = изменить пользователя { $user }
server-audit-delete-user = удалить пользователя { $user }
server-audit-own-password = собственный пароль
server-audit-log-in = войти
server-audit-log-out = выйти
server-audit-backup = скачать резервную копию
server-audit-restore = восстановить
server-audit-check-archive = проверить копию
server-audit-set-axis = изменить ось { $name } в { $file }
server-audit-set-tool = изменить инструмент { $name } в { $file }
server-audit-set-sensor = изменить датчик { $name } в { $file }
server-audit-shelve = отложить тревогу { $alarm } { $detail } на { $minutes } мин
server-audit-override = коррекция { $override }
server-audit-acknowledge = подтвердить: { $alarm }
server-audit-weld = сварка { $weld }, деталь «{ $part }»
server-audit-others = прочие
server-audit-teach = обучение: { $order }
server-audit-teach-open = включить камеру: шаг { $step }, пропуски до { $tacks }, зерно { $seed }
server-audit-teach-open-tack = включить камеру: шаг { $step }, пропуски до { $tacks }, зерно { $seed }, прихватка от { $from } до { $to }
server-audit-teach-pixel = стык здесь: пиксель { $x }, { $y }
server-audit-teach-point = стык здесь: X { $x } Y { $y } Z { $z }
server-audit-teach-middle = стык на кресте камеры
server-audit-teach-end = стык кончается здесь
server-audit-teach-pause = пауза
server-audit-teach-resume = продолжить
server-audit-teach-stop = остановить
server-audit-accepted = принято
server-audit-saved = сохранено
server-audit-deleted = удалено
server-audit-changed = изменено
server-audit-kept = сохранено
server-audit-begun = начато
server-audit-checked = проверено
server-audit-loaded = загружено
server-audit-logged-in = вход выполнен
server-audit-logged-out = выход выполнен
server-audit-refused = отказано
server-audit-refused-role = отказано: роль не позволяет
server-audit-reweld = завершённое можно варить снова
server-audit-raised-again = сработала снова
server-audit-several = несколько запросов
server-audit-kind = { $command }: { $result } ({ $n })
server-audit-refused-sum = отказано в запросах: { $n }, первый { $first }, последний { $last }: { $kinds }
server-audit-repeated-sum = повторных запросов: { $n }, первый { $first }, последний { $last }: { $kinds }
server-audit-left-out = пропущено записей: { $n }, между { $first } и { $last }

# Events.
server-event-left = проход { $pass } остановлен, сварено до { $s }
server-event-mode = { $from } -> { $to }
server-event-order = { $order }
server-event-refused = { $order }: { $reason }
server-event-alarm = { $alarm }: { $reaction }
server-event-alarm-of = { $alarm } ({ $object }): { $reaction }
server-event-alarm-before = { $alarm } от { $time }: не подтверждено до завершения
server-event-cleared = { $alarm }: больше нет
server-event-cleared-of = { $alarm } ({ $object }): больше нет
server-event-pass-ends = проход { $pass } заканчивается на { $s }
server-event-left-before = сварка { $weld } прервана сбоем питания или программы: перед продолжением осмотрите конец валика
server-event-stopped-by = ячейка остановлена: { $cause }
server-event-cycles-missed = пропущено тактов: { $cycles }, до { $longest } подряд
server-event-no-realtime = такт работает без прав реального времени: { $reason }
server-event-safe-by-panel = { $device }: панель сама записала безопасное состояние выходов, сначала дугу или луч, потому что ячейка молчит
server-event-safe-unconfirmed = { $device }: безопасное состояние выходов не подтверждено: { $reason }
server-event-journal-damaged = журнал положений повреждён: шов, прерванный отключением питания, был бы неизвестен; осмотрите деталь, затем выполните поиск референтных точек
server-event-weld-lost = у сварки { $weld } есть файлы, но её нет в библиотеке: библиотека повреждена, запись утрачена
server-event-recorded = сварка { $weld } записана: { $result }
server-event-record-not-whole = сварка { $weld }: запись неполная: { $reason }
server-event-record-interrupted = сварка { $weld } была прервана; её запись восстановлена
server-event-record-fails = не удаётся записать данные: { $reason }
server-event-not-recorded = эта сварка не записывается: { $reason }
server-event-audit-fails = не удаётся записать журнал действий: { $reason }; ожидают: { $n }
server-event-audit-hangs = диск журнала действий не отвечает; ожидают: { $n }
server-event-audit-stored = журнал действий снова записывается; ожидало записей: { $n }
server-event-audit-left-out = потеряно записей журнала действий: { $n }; ожидало слишком много
server-event-syslog-fails = приёмник syslog { $receiver } недоступен: { $reason }; ожидают: { $n }
server-event-syslog-sends = приёмник syslog { $receiver } снова доступен; не отправлено: { $n }
server-event-restored = все данные восстановлены; прежние лежат в { $folder }
server-event-control-taken = управление взято
server-event-control-taken-over = управление перехвачено
server-event-control-lost = управление потеряно: панель не отвечает
server-event-loaded = загружено: { $job }
server-event-not-loaded = ничего не загружено: { $reason }
server-event-teach-ended = обучение { $job } закончено: { $result }
server-event-shelved = { $alarm }: отложено на { $minutes } мин
server-event-unshelved = { $alarm }: больше не отложено
server-event-machine-changed = { $subject } изменено в { $file }: действует, когда задание этого станка загружено заново
server-event-tool-changed = остриё { $head } изменено в { $file }: действует, когда задание этого станка загружено заново
server-event-sensor-changed = датчик { $sensor } изменён в { $file }: действует, когда задание этого станка загружено заново
server-event-cell-lost = ячейка аварийно завершилась: { $reason }
server-event-cell-restarted = запущена новая ячейка: выключена, без программы; устройства подключены
server-event-cell-not-restarted = новую ячейку запустить не удалось: { $reason }
server-cell-dies-often = ячейка аварийно завершилась { $n } раза за десять минут
server-event-cell-found = найдена работающая ячейка с программой: { $job }

# Log.
server-log-starts = Seamwright { $version } работает по адресу { $address }
server-log-restores = все данные восстановлены: ячейка запускается заново
server-log-ends = сервер завершает работу
server-log-logged-in = { $user }: вход с адреса { $address }
server-log-refused = отказано за { $time }: { $kind }: { $n }
server-log-worker-starts = процесс { $pid } запущен: { $question }
server-log-worker-ended = процесс { $pid } завершён через { $time }: { $question }
server-log-worker-killed = процесс { $pid } остановлен через { $time }: { $question }: { $reason }
server-log-disk-slow = { $folder }: короткая запись заняла { $time }
server-log-ready = ячейка готова к работе
server-log-not-ready = ячейка не готова: { $reasons }
server-log-cycle-hangs = такт не завершается: проверьте, что дуга, газ и приводы выключены
server-log-record-open = запись последней сварки не закрыта: следующий запуск её восстановит
server-log-certificate-fails = сертификат не обновлён: { $reason }
server-log-authority = центр сертификации ячейки действует до { $until }: установите { $file } в браузерах
server-log-browsers-unknown = { $file }: { $reason }: браузеры запоминаются заново
server-log-browsers-not-kept = известные браузеры не сохранены: { $reason }
server-log-left-out = пропущено строк журнала: { $n }

# Readiness and monitoring.
server-not-ready-cell-starts = ячейка запускается
server-not-ready-cell = ячейка не отвечает уже { $age }
server-not-ready-disk-silent = диск папки { $folder } не отвечает уже { $age }
server-not-ready-disk-unknown = проверяется диск папки { $folder }
server-not-ready-disk-full = на диске папки { $folder } свободно только { $free }; нужно { $needed }
server-not-ready-library = библиотека записей недоступна для записи: { $reason }
server-monitor-login = войдите, передайте токен из `--monitor-token` или обратитесь с этого компьютера
server-log-cycle-failed = цикл ячейки отказал
server-log-entry-refused = библиотека отклоняет запись журнала аудита: { $reason }: { $entry }
server-log-waiting-file = ожидавшие записи журнала аудита сохранены, но их файл не очищается: { $reason }
