# Запуск і кінець сервера.
server-syslog-receiver = не приймач syslog: { $text }; дозволено: udp://HOST:PORT або tcp://HOST:PORT, порт від 1 до 65535 (типово 514), адреси IPv6 у дужках
server-bind = { $option }: { $why }
server-bind-free = адреса і вільний порт
server-bind-plain = ця адреса доступна іншим комп’ютерам, а шифрування немає
server-bind-encrypted = з --tls, або --cert і --key; 127.0.0.1, [::1]
server-bind-no-admin = ця адреса доступна іншим комп’ютерам, а пароля ще ніхто не має
server-bind-local-first = 127.0.0.1 або [::1], щоб спершу створити там адміністратора з паролем
server-bind-no-name = бракує імені цього комп’ютера
server-bind-named = з --host NAME, або одна адреса
server-certificate-failed = не вдалося створити сертифікат: { $why }
server-certificate-files = { $options }: { $why }
server-pem-files = файли PEM сертифіката і його закритого ключа
server-panicked = збій програми (panic): комірку зупинено, її пристроям наказано вимкнутися
server-library-open = не вдалося закрити бібліотеку: нічого не відновлено
server-look-at-once = негайно перевірте, чи вимкнено дугу і газ

# Requests.
server-failed = не вдалося; нічого не змінено
server-program-fault = завершено через помилку програми: повідомте про неї, будь ласка
server-no-thread = потік не запускається: { $why }
server-panel-ends = панель завершує роботу
server-slow-down = забагато таких запитів: спробуйте за мить
server-too-many-requests = забагато запитів одразу: зачекайте трохи
server-request-late = запит надходив надто довго
server-request-too-large = запит завеликий; дозволено: до { $max } КіБ
server-too-many-pages = відкрито забагато сторінок: закрийте одну
server-cell-ended = комірка завершила роботу
server-cell-silent = комірка не відповідає: спробуйте ще раз
server-no-machine = немає верстата
server-no-machine-named = верстата «{ $name }» немає
server-no-axis = осі «{ $axis }» немає; дозволено: { $allowed }
server-no-language = мови «{ $language }» немає; { $allowed }
server-file-trouble = { $file }: { $why }
server-file-unreadable = { $file } не читається: { $why }

# Log-in and permissions.
server-unknown-host = ця панель невідома як «{ $host }»; дозволено: { $allowed }
server-other-origin = запити зі сторінок іншого походження відхиляються
server-not-logged-in = вхід не виконано або сеанс закінчено: увійдіть
server-session-over = сеанс закінчено: увійдіть
server-role = роль «{ $role }» цього не дозволяє ({ $action })
server-role-from = роль «{ $role }» цього не дозволяє ({ $action }); дозволено: від «{ $needed }» і вище
server-header = заголовок «{ $header }» має бути «{ $value }»
server-token = у заголовку «{ $header }» має бути токен сеансу
server-content-type = тип вмісту «{ $kind }» не приймається; дозволено: { $allowed }
server-wrong-passwords = забагато неправильних паролів: зачекайте { $wait }
server-login-too-long = ім’я або пароль задовгі; дозволено: до { $max }
server-login-wrong = неправильні ім’я чи пароль, або застаріле посилання
server-no-random = немає випадкових чисел: { $why }

# Users.
server-own-password = для цього потрібен ваш власний пароль, а він неправильний
server-user-exists = користувач «{ $user }» уже є
server-no-user = користувача «{ $user }» немає
server-user-name = недопустиме ім’я; дозволено: літери, цифри, - _ . і пробіли між ними, до { $max }
server-user-owner = «{ $user }» зарезервовано для початкового посилання: виберіть інше ім’я
server-password-length = недопустима довжина пароля; дозволено: від { $min } до { $max } знаків
server-password-needed = новому користувачеві потрібен пароль
server-password-hash = пароль не хешується: { $why }
server-too-many-users = забагато користувачів; дозволено: { $max }
server-last-admin = не лишилося б адміністратора: спершу зробіть адміністратором іншого дозволеного користувача

# Jobs.
server-job-name = недопустима назва завдання: «{ $name }»; дозволено: літери, цифри, - _ . ( ) + і пробіли, до { $max }, у кінці .toml
server-no-job = завдання «{ $job }» немає
server-no-own-job = власного завдання «{ $job }» немає
server-jobs-unreadable = тека завдань не читається: { $why }
server-template-name = «{ $job }» – назва зразка: збережіть завдання під іншою
server-other-text = під назвою «{ $job }» збережено інший текст
server-search-too-long = текст пошуку задовгий; дозволено: до { $max } символів
server-too-many-jobs = забагато завдань; дозволено: { $max }
server-job-not-deleted = { $job } не видаляється: { $why }
server-too-many-operations = забагато дій; дозволено: до { $max } за раз
server-operation = дія { $n }: { $why }
server-at-key = { $key }: { $what }
server-at-value = { $key } = { $value }: { $what }
server-and-allowed = { $what }; дозволено: { $allowed }
server-and-help = { $what }; { $help }

# Planning.
server-superseded = скасовано або замінено новішим запитом
server-planning-time = планування триває довше за { $max }; зменште кількість проходів, валиків чи точок
server-planning-memory = планування потребує понад { $max } ГіБ пам’яті; зменште кількість проходів, валиків чи точок
server-plan-too-large = план завеликий для показу; дозволено: до { $max }
server-no-process = процес для планування не запускається: { $why }
server-no-pipes = процес для планування не запускається: немає каналів
server-planning-failed = планування не вдалося; на комірку це не впливає: { $why }
server-no-dialect = діалекту «{ $name }» немає; дозволено: { $allowed }

# Loading.
server-part-number = недопустимий номер деталі; дозволено: до { $max } видимих знаків
server-machine-moves = верстат рухається або на паузі: спершу зупиніть його
server-other-devices = файл верстата завдання називає інші пристрої, ніж файл, з яким запущено панель; дозволено: ті самі [devices] або жодних
server-devices-held = пристрої не звільняються: перезапустіть панель
server-devices-not-connected = пристрої не з’єднуються
server-needs-other-devices = завдання для іншого верстата: спершу вимкніть приводи
server-loading = завантажується інша програма: зачекайте трохи
server-load-announced = завдання планується для завантаження: зачекайте, доки воно буде в комірці
server-overlap = недопустиме перекриття { $value }; дозволено: до { $max }
server-nothing-to-weld = прохід { $pass }, { $s }: варити більше нічого; дозволено: прохід від 1 до { $passes }, у межах його довжини
server-finished-pass = деталь «{ $part }» зварено до проходу { $pass }, { $s }: цей старт зварив би її знову; продовжте звідти або підтвердьте
server-finished-part = деталь «{ $part }» зварено повністю (зварювання { $weld }): цей старт зварив би її знову; підтвердьте або назвіть іншу деталь

# Commands over the socket.
server-message-invalid = недопустиме повідомлення: { $why }
server-unknown-command = невідома команда «{ $name }»; дозволено: { $allowed }
server-no-control = ця сторінка не керує: спершу візьміть керування
server-control-jogs = сторінка, що керує, рухає осі вручну: зачекайте, доки відпустять кнопку
server-control-held = керує { $user }, сторінка { $page }
server-replayed = команда { $n } вже була; дозволено: більше за { $last }
server-busy = забагато команд одразу
server-at-rest = ніщо не рухається
server-override-range = корекція { $value }; дозволено: від 0 до 1
server-no-alarm = тривоги { $number } немає; дозволено: від 1 до { $max }
server-step-range = крок { $value }; дозволено: до { $max } в обидва боки
server-positions-unknown = положення осей невідоме
server-no-such-axis = такої осі немає
server-tip-directions = вістря рухається лише вздовж x, y і z
server-axis-count = осей: { $n }; дозволено: { $allowed }
server-axes-moving = осі ще рухаються: зачекайте трохи
server-not-homed = опорна точка осі { $axis } невідома: спершу виконайте пошук опорних точок
server-shelve-time = { $minutes } хв; дозволено: до { $max }
server-alarm-not-listed = цієї тривоги немає в переліку
server-alarm-reacts = «{ $alarm }» має реакцію ({ $reaction }); відкласти можна лише тривоги без реакції

# Set-up.
server-no-job-loaded = завдання не завантажено: спершу завантажте завдання цього верстата
server-axis-not-in-file = осі немає в її файлі
server-no-parameter = параметра «{ $key }» немає; дозволено: { $allowed }
server-other-kind-of-axis = «{ $key }» належить іншому типу осей
server-no-head = головки { $head } немає; дозволено: від 0 до { $max }
server-too-many-touches = дотиків: { $n }; дозволено: до { $max }
server-touch = недопустимий дотик { $touch }; дозволено: положень { $n }, мм або градуси, до 1000000
server-more-touches = { $why }; торкніться однієї точки тричі або більше, нахиляючи пальник на 20 градусів або більше
server-tip-far = tip_mm { $tip }; дозволено: до { $max }
server-no-camera = «{ $sensor }» не камера; дозволено: давач із `map.heights`
server-grid = недопустима сітка: крок { $pitch }, висота { $z }; дозволено: крок, більший за 0
server-no-sensor = давача «{ $sensor }» немає; дозволено: { $allowed }
server-not-simulated = не симулюється; дозволено: симульовані пристрої, до { $max } пікселів
server-scale-differs = масштаб відрізняється на { $difference }: перевірте крок і висоту
server-picture-size = на зображенні { $pixels } пікселів; дозволено: { $allowed }
server-no-sensor-key = «{ $key }» немає; дозволено: { $allowed }
server-number-count = у «{ $key }» чисел: { $n }; дозволено: { $allowed }
server-too-many-planes = площин: { $n }; дозволено: до { $max }

# Placing the part by touching.
server-probe-radius = радіус щупа { $value }; дозволено: від 0 до { $max }
server-too-many-points = точок: { $n }; дозволено: до { $max }
server-feature = точка { $point }: невідомий елемент «{ $feature }»; дозволено: { $allowed }
server-point-far = точка { $point } задалеко; дозволено: до { $max }
server-more-points = { $why }; візьміть більше точок, розподілених по поверхнях, або інший спосіб
server-more-points-round = { $why }; візьміть більше точок по торцю й навколо
server-no-surfaces = у завдання немає шва, поверхонь якого можна торкнутися: візьміть завдання зі швом
server-not-determined = не визначено: { $what }; без змін
server-turn-about-axis = поворот навколо осі
server-no-spare-points = точок не більше, ніж невідомих: погану точку не помітити
server-three-points-plane = площина: лише три точки; погану не помітити
server-three-points-face = торець: лише три точки; погану не помітити
server-three-points-round = коло: лише три точки; погану не помітити
server-round-diameter = діаметр кола: { $diameter }
server-no-position = точки не визначають положення
server-offsets-no-table = `offsets` не є таблицею; дозволено: [offsets.NAME]

# Records and backup.
server-query = { $name }: { $why }
server-too-many-values = забагато: стовпців { $columns } по { $rows } рядків; дозволено: до { $max-columns } стовпців, { $max-values } значень
server-row-count = most={ $value }; дозволено: від { $min } до { $max }
server-no-column = стовпця «{ $column }» немає; дозволено: { $allowed }
server-not-off = верстат не вимкнено: спершу вимкніть приводи
server-archive-too-large = архів завеликий; дозволено: до { $max }; більші бере `seamwright records restore`
server-archive-broke-off = передавання архіву перервано
server-archive-no-admin = в архіві немає адміністратора: панеллю ніхто не зміг би користуватися
server-no-archive = жодного архіву не перевірено: спершу надішліть його
server-record-being-written = запис зварювання ще пишеться: зачекайте
server-backup-runs = копія створюється або перевіряється: зачекайте до кінця

# Teaching by camera.
server-no-image = зображення ще немає
server-teach-point = піксель і положення; дозволено: одне з них або жодного
server-teach-no-work = на зображенні там немає деталі
server-teach-range = { $key } { $value }; дозволено: від { $min } до { $max }
server-teach-above = { $key } { $value }; дозволено: більше за 0, до { $max }
server-teach-method = невідомий спосіб «{ $method }»; дозволено: { $allowed }
server-teach-nothing = ще нічого не навчено
server-teach-tack = недопустима прихватка; дозволено: початок перед кінцем, обидва скінченні
server-teach-order = недопустима вказівка
server-teach-real-devices = пристрої верстата справжні, а його файл не називає `frames` камери: навчайте вручну
server-teach-no-program = програму не завантажено: її шов задає номінальний стик
server-teach-is-open = сеанс уже відкрито: спершу зупиніть його
server-teach-not-open = сеанс не відкрито
server-teach-not-asked = положення стику зараз не потрібне
server-teach-not-paused = нічого не призупинено
server-teach-far = положення не біля номінального шва; дозволено: до 15 мм від нього
server-teach-start-far = початок не біля номінального шва
server-teach-other-machine = { $job } призначено для { $machine }, а не для цієї комірки
server-teach-no-frames = пристрої верстата справжні, а sensors.{ $sensor } не має `frames`
server-teach-no-camera = у { $machine } немає камери; дозволено: верстат із [sensors.NAME] і kind = "camera" у файлі
server-teach-sensor-no-camera = { $sensor } не камера
server-teach-blocked = комірка зупинила осі в дорозі: дивіться тривоги
server-camera-address = файл верстата називає камеру { $address }, до якої ця комірка не під’єднується; дозволено: цей комп’ютер; інші – `seamwright serve --camera HOST:PORT`
server-camera-address-list = файл верстата називає камеру { $address }, до якої ця комірка не під’єднується; дозволено: цей комп’ютер, { $allowed }; інші – `seamwright serve --camera HOST:PORT`

# Audit log: where from, what, and result.
server-audit-panel = панель
server-audit-panel-number = панель { $number }
server-audit-panel-at = панель на { $address }
server-audit-save-job = зберегти завдання { $job }
server-audit-delete-job = видалити завдання { $job }
server-audit-load = завантажити { $job }
server-audit-change-user = змінити користувача { $user }
server-audit-delete-user = видалити користувача { $user }
server-audit-own-password = власний пароль
server-audit-log-in = увійти
server-audit-log-out = вийти
server-audit-backup = завантажити резервну копію
server-audit-restore = відновити
server-audit-check-archive = перевірити копію
server-audit-set-axis = змінити вісь { $name } у { $file }
server-audit-set-tool = змінити інструмент { $name } у { $file }
server-audit-set-sensor = змінити давач { $name } у { $file }
server-audit-shelve = відкласти тривогу { $alarm } { $detail } на { $minutes } хв
server-audit-override = корекція { $override }
server-audit-acknowledge = підтвердити: { $alarm }
server-audit-weld = зварювання { $weld }, деталь «{ $part }»
server-audit-others = інші
server-audit-teach = навчання: { $order }
server-audit-teach-open = увімкнути камеру: крок { $step }, прогалини до { $tacks }, зерно { $seed }
server-audit-teach-open-tack = увімкнути камеру: крок { $step }, прогалини до { $tacks }, зерно { $seed }, прихватка від { $from } до { $to }
server-audit-teach-pixel = стик тут: піксель { $x }, { $y }
server-audit-teach-point = стик тут: X { $x } Y { $y } Z { $z }
server-audit-teach-middle = стик на хресті камери
server-audit-teach-end = стик закінчується тут
server-audit-teach-pause = пауза
server-audit-teach-resume = продовжити
server-audit-teach-stop = зупинити
server-audit-accepted = прийнято
server-audit-saved = збережено
server-audit-deleted = видалено
server-audit-changed = змінено
server-audit-kept = збережено
server-audit-begun = почато
server-audit-checked = перевірено
server-audit-loaded = завантажено
server-audit-logged-in = вхід виконано
server-audit-logged-out = вихід виконано
server-audit-refused = відмовлено
server-audit-refused-role = відмовлено: роль не дозволяє
server-audit-reweld = завершене можна варити знову
server-audit-raised-again = спрацювала знову
server-audit-several = кілька запитів
server-audit-kind = { $command }: { $result } ({ $n })
server-audit-refused-sum = відмовлено в запитах: { $n }, перший { $first }, останній { $last }: { $kinds }
server-audit-repeated-sum = повторних запитів: { $n }, перший { $first }, останній { $last }: { $kinds }
server-audit-left-out = пропущено записів: { $n }, між { $first } і { $last }

# Events.
server-event-left = прохід { $pass } зупинено, зварено до { $s }
server-event-mode = { $from } -> { $to }
server-event-order = { $order }
server-event-refused = { $order }: { $reason }
server-event-alarm = { $alarm }: { $reaction }
server-event-alarm-of = { $alarm } ({ $object }): { $reaction }
server-event-alarm-before = { $alarm } від { $time }: не підтверджено до завершення
server-event-cleared = { $alarm }: більше немає
server-event-cleared-of = { $alarm } ({ $object }): більше немає
server-event-pass-ends = прохід { $pass } закінчується на { $s }
server-event-left-before = зварювання { $weld } перервано збоєм живлення чи програми: перед продовженням огляньте кінець валика
server-event-stopped-by = комірку зупинено через { $cause }
server-event-cycles-missed = пропущено тактів: { $cycles }, до { $longest } поспіль
server-event-no-realtime = такт працює без прав реального часу: { $reason }
server-event-safe-by-panel = { $device }: панель сама записала безпечний стан виходів, спершу дугу або промінь, бо комірка мовчить
server-event-safe-unconfirmed = { $device }: безпечний стан виходів не підтверджено: { $reason }
server-event-journal-damaged = журнал положень пошкоджено: шов, перерваний зникненням живлення, був би невідомий; огляньте деталь, потім виконайте пошук баз
server-event-weld-lost = зварювання { $weld } має файли, але його немає в бібліотеці: вона пошкоджена, запис утрачено
server-event-recorded = зварювання { $weld } записано: { $result }
server-event-record-not-whole = зварювання { $weld }: запис неповний: { $reason }
server-event-record-interrupted = зварювання { $weld } було перервано; його запис відновлено
server-event-record-fails = не вдається записати дані: { $reason }
server-event-not-recorded = це зварювання не записується: { $reason }
server-event-audit-fails = не вдається записати журнал дій: { $reason }; очікують: { $n }
server-event-audit-hangs = диск журналу дій не відповідає; очікують: { $n }
server-event-audit-stored = журнал дій знову записується; очікувало записів: { $n }
server-event-audit-left-out = втрачено записів журналу дій: { $n }; очікувало забагато
server-event-syslog-fails = приймач syslog { $receiver } недоступний: { $reason }; очікують: { $n }
server-event-syslog-sends = приймач syslog { $receiver } знову доступний; не надіслано: { $n }
server-event-restored = усі дані відновлено; попередні лежать у { $folder }
server-event-control-taken = керування взято
server-event-control-taken-over = керування перехоплено
server-event-control-lost = керування втрачено: панель не відповідає
server-event-loaded = завантажено: { $job }
server-event-not-loaded = нічого не завантажено: { $reason }
server-event-teach-ended = навчання { $job } закінчено: { $result }
server-event-shelved = { $alarm }: відкладено на { $minutes } хв
server-event-unshelved = { $alarm }: більше не відкладено
server-event-machine-changed = { $subject } змінено в { $file }: діє, коли завдання цього верстата завантажено знову
server-event-tool-changed = вістря { $head } змінено в { $file }: діє, коли завдання цього верстата завантажено знову
server-event-sensor-changed = давач { $sensor } змінено в { $file }: діє, коли завдання цього верстата завантажено знову
server-event-cell-lost = комірка аварійно завершилася: { $reason }
server-event-cell-restarted = запущено нову комірку: вимкнена, без програми; пристрої під’єднано
server-event-cell-not-restarted = нову комірку запустити не вдалося: { $reason }
server-cell-dies-often = комірка аварійно завершилася { $n } рази за десять хвилин
server-event-cell-found = знайдено працюючу комірку з програмою: { $job }

# Log.
server-log-starts = Seamwright { $version } працює за адресою { $address }
server-log-restores = усі дані відновлено: комірка запускається знову
server-log-ends = сервер завершує роботу
server-log-logged-in = { $user }: вхід з адреси { $address }
server-log-refused = відмовлено за { $time }: { $kind }: { $n }
server-log-worker-starts = процес { $pid } запущено: { $question }
server-log-worker-ended = процес { $pid } завершено через { $time }: { $question }
server-log-worker-killed = процес { $pid } зупинено через { $time }: { $question }: { $reason }
server-log-disk-slow = { $folder }: короткий запис тривав { $time }
server-log-ready = комірка готова до роботи
server-log-not-ready = комірка не готова: { $reasons }
server-log-cycle-hangs = такт не завершується: перевірте, що дугу, газ і приводи вимкнено
server-log-record-open = запис останнього зварювання не закрито: наступний запуск його відновить
server-log-certificate-fails = сертифікат не оновлено: { $reason }
server-log-authority = центр сертифікації комірки дійсний до { $until }: установіть { $file } у браузерах
server-log-browsers-unknown = { $file }: { $reason }: браузери запам’ятовуються знову
server-log-browsers-not-kept = відомі браузери не збережено: { $reason }
server-log-left-out = пропущено рядків журналу: { $n }

# Readiness and monitoring.
server-not-ready-cell-starts = комірка запускається
server-not-ready-cell = комірка не відповідає вже { $age }
server-not-ready-disk-silent = диск теки { $folder } не відповідає вже { $age }
server-not-ready-disk-unknown = перевіряється диск теки { $folder }
server-not-ready-disk-full = на диску теки { $folder } вільно лише { $free }; потрібно { $needed }
server-not-ready-library = бібліотека записів недоступна для запису: { $reason }
server-monitor-login = увійдіть, передайте токен з `--monitor-token` або зверніться з цього комп’ютера
server-log-cycle-failed = цикл комірки відмовив
server-log-entry-refused = бібліотека відхиляє запис журналу аудиту: { $reason }: { $entry }
server-log-waiting-file = записи журналу аудиту, що чекали, збережено, але їхній файл не очищується: { $reason }
