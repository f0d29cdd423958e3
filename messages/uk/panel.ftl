# Words of the panel, in the order of its pages.

# Words for several pages.
panel-least = Мін.
panel-mean = Середнє
panel-greatest = Макс.
panel-allowed = Дозволено
panel-program = Програма
panel-pass = Прохід
panel-alarm = Тривога
panel-language = Мова
panel-tabs = Вкладки
panel-cancel = Скасувати
panel-close = Закрити
panel-search = Пошук
panel-all = Усі
panel-on = увімк.
panel-off = вимк.
panel-undo = Скасувати дію
panel-redo = Повторити дію
panel-set = Задано
panel-actual = Факт
panel-abort = Перервати
panel-stop = STOP: програмна зупинка
panel-mode = Стан
panel-armed = Дозволено
panel-recording = Запис { $weld }
panel-simulated = симуляція
panel-commands = Команди
panel-refused = Відмовлено:
panel-why = Чому не можна почати?
panel-passes = Проходи
panel-progress = Виконання
panel-time-left = лишилося { $time }
panel-readouts = Покази
panel-process = Процес
panel-gas = Газ
panel-speed = Швидкість
panel-override = Корекція
panel-bottom = Тривоги та графіки
panel-scene = Комірка у 3D
panel-clearance = Просвіт
panel-section = Переріз стику
panel-axis = Вісь
panel-conditions = Умови (блокування)
panel-condition = Умова

# Alarms.
panel-alarm-cause = Причина
panel-alarm-state = Стан
panel-alarm-consequence = Наслідок
panel-alarm-action = Що робити
panel-alarm-reaction = Реакція
panel-alarm-priority = Пріоритет
panel-alarm-severity = Тяжкість
panel-alarm-response = Час на реакцію
panel-alarm-shelvable = Відкладання
panel-alarm-chattering = ДЕРЕНЧИТЬ
panel-alarm-first = ПЕРША
panel-alarm-one = Підтвердити цю тривогу
panel-alarm-shelve = Відкласти
panel-alarm-shelve-for = Відкласти на
panel-alarm-minutes = { $minutes } хв
panel-alarm-unshelve = Повернути
panel-alarm-shelved = Відкладено: { $alarm }
panel-alarm-until = до { $time }, { $user }
panel-alarm-shelve-how = Відкласти можна лише сповіщення; те, що зупиняє або ставить на паузу, показується завжди.

# Process values.
panel-value-tip-speed = Швидкість вістря
panel-value-speed = Швидкість вістря

# States.
panel-mode-off = Вимкнено
panel-mode-idle = Без нуля
panel-mode-homing = Пошук нуля
panel-mode-ready = Готово
panel-mode-jog = Ручний рух
panel-mode-teach = Навчання
panel-mode-dry-run = Холостий прогін
panel-mode-weld = Зварювання
panel-mode-hold = Пауза
panel-mode-fault = Аварія

# Commands.
panel-do-hold = Пауза
panel-do-resume = Далі
panel-do-reverse = Назад
panel-do-stop = Зупинити
panel-do-switch-on = Увімкнути
panel-do-switch-off = Вимкнути
panel-do-home = У нуль
panel-do-start-jog = Почати ручний рух
panel-do-start-teach = Почати навчання
panel-do-start-dry-run = Холостий прогін
panel-do-arm = Дозволити дугу
panel-do-arm-beam = Дозволити промінь
panel-do-start-weld = Почати зварювання
panel-do-start-beam = Почати зварювання
panel-do-reset = Скинути аварію
panel-do-acknowledge = Підтвердити всі
panel-do-override = Змінити корекцію
panel-do-acknowledge-one = Підтвердити одну тривогу
panel-do-home-axis = Одну вісь у вихідне

# Interlocks of supplied machines.
panel-interlock-emergency-stop-chain = коло аварійної зупинки
panel-interlock-light-curtain = світлова завіса
panel-interlock-shielding-gas = захисний газ
panel-interlock-torch-coolant = охолодження пальника
panel-interlock-doors = двері
panel-interlock-cooling-water = охолоджувальна вода
panel-interlock-gun-pressure = тиск у гарматі
panel-interlock-chamber-pressure = тиск у камері
panel-interlock-chamber-door = двері камери
panel-interlock-laser-interlocks = блокування лазера
panel-interlock-cabin-doors = двері кабіни

# Records.
panel-record-part = Деталь
panel-record-begun = Початок
panel-record-machine = Верстат
panel-record-procedure = Технологія
panel-record-welder = Зварник
panel-record-list = Записи
panel-record-no-hit = Немає відповідних записів.
panel-record-none = Зварювань ще не було.
panel-record-no = №
panel-record-result = Результат
panel-record-worst = Макс. відхилення
panel-record-outside = поза межами на { $length } мм
panel-record-from = Від
panel-record-compare = Порівняти
panel-record-report = Звіт
panel-record-facts = Підсумок
panel-record-trace = Криві
panel-record-columns = Вибрати сигнали
panel-record-no-values = У цьому проході таких значень немає.

# Events.
panel-event-time = Час
panel-event-text = Подія
panel-event-what = Що
panel-event-mode = Стан
panel-event-order = Команда
panel-event-refused = Відмова
panel-event-alarm = Тривога
panel-event-cleared = Знято
panel-event-pass = Прохід
panel-event-left = Зупинено
panel-event-record = Запис
panel-event-control = Керування
panel-event-work = Програма
panel-event-teach = Навчання

# Bottom.
panel-bottom-alarms = Тривоги
panel-bottom-events = Події
panel-bottom-plots = Графіки
panel-bottom-tracking = Стеження

# Jobs.
panel-job-head = Завдання
panel-job-list = Завдання
panel-job-own = Мої завдання
panel-job-examples = Зразки
panel-job-example = Зразок – збережіть як своє завдання
panel-job-title = Заголовок
panel-job-name-how = Латинські літери, цифри та . _ -
panel-job-name = Назва
panel-job-open = Відкрити
panel-job-use = Нове зі зразка
panel-job-load = Завантажити
panel-job-loaded = завантажено
panel-job-part = Номер деталі (для запису)
panel-job-part-why = Програму буде сплановано, перевірено й передано комірці. Ніщо не рухається.
panel-job-lies = Зміщення симульованої деталі
panel-job-lies-planned = немає
panel-job-lies-why = Зі зміщенням шов відстежується.
panel-job-delete = Видалити
panel-job-delete-sure = Видалити { $job }? Повернути не можна.
panel-job-save = Зберегти
panel-job-save-as = Зберегти як …
panel-job-unsaved = не збережено
panel-job-leave = Є незбережені зміни.
panel-job-discard = Відкинути зміни
panel-job-replace = Замінити
panel-job-other = Під назвою { $job } уже збережено інший текст: іншого завдання або змінений кимось відтоді. Замінити його цим?
panel-job-edit = Змінити
panel-job-preview = Перегляд
panel-job-form = Форма
panel-job-parts = Деталь і оснащення
panel-job-points = Точки
panel-job-text = Текст
panel-job-post = G-код
panel-job-findings = Зауваження
panel-job-section = Переріз
panel-job-plots = Графіки
panel-job-limits = Межі

# Tracking.
panel-track-lateral = Поперек
panel-track-height = За висотою
panel-track-head = Головка
panel-track-none = Відстеження вимкнено
panel-track-confidence = Певність
panel-track-sigma = Станд. відхилення
panel-track-guessed = не видно

# Pages.
panel-tab-weld = Зварювання
panel-tab-teach = Рух · Навчання
panel-tab-jobs = Завдання
panel-tab-records = Записи
panel-tab-setup = Наладка

panel-theme-light = Світла
panel-theme-dark = Темна

# Connection.
panel-link-opening = З’єднання …
panel-link-open = Зв’язок є
panel-link-closed = Немає зв’язку
panel-link-stale = Дані давністю { $age } с

# Log-in.
panel-login-user = Користувач
panel-login-password = Пароль
panel-login-go = Увійти
panel-login-out = Вийти
panel-login-over = Сеанс закінчився: його закрито, змінено або він застарів. Що працює в комірці, працює далі; STOP діє й тут. Увійдіть знову.
panel-login-runs = У комірці щось працює й працюватиме далі без вас.
panel-login-stopped = STOP надіслано; стан у ту мить: { $state }.
panel-login-made = Тепер увійдіть як цей користувач. Початкове посилання більше не діє.
panel-login-wrong = Неправильний користувач або пароль.
panel-login-key = Перший запуск: відкрийте посилання, яке вивела програма.
panel-login-owner = Власник

# Control.
panel-control-mine = Керуєте ви
panel-control-give = Віддати керування
panel-control-take = Узяти керування
panel-control-free = Ніхто не керує
panel-control-unknown = Керування невідоме
panel-control-theirs = Керує { $user } (станція { $station })
panel-control-over = Зараз керує { $user }. Забрати керування?
panel-control-needed = Візьміть керування, щоб працювати з коміркою.

# Roles.
panel-role-viewer = Глядач
panel-role-operator = Оператор
panel-role-programmer = Програміст
panel-role-service = Сервіс
panel-role-admin = Адміністратор

# STOP.
panel-stop-failed = STOP НЕ ДІЙШОВ ДО КОМІРКИ
panel-stop-emergency = Натисніть аварійну зупинку.
panel-stop-late = STOP дійшов до комірки із запізненням
panel-stop-check = Перевірте, чи машина стоїть і процес вимкнено.
panel-stop-unanswered = Сторінка на зв’язку, але вчасно не видно, що комірка зупинилася.
panel-stop-no-connection = Немає зв’язку з коміркою. Сторінка далі намагається з’єднатися.
panel-stop-read = Прочитано

# Process.
panel-process-arc-on = ДУГА ГОРИТЬ
panel-process-beam-on = ПРОМІНЬ УВІМКНЕНО
panel-process-arc-off = Дуги немає
panel-process-beam-off = Променя немає
panel-process-ordered = Вмикається

# Phases of a pass.
panel-phase-held = у спокої
panel-phase-preflow = продування газом
panel-phase-travel-delay = затримка руху
panel-phase-travel = зварювання
panel-phase-run-out = спад
panel-phase-crater = заварювання кратера
panel-phase-postflow = газ після зварювання
panel-phase-move = холостий хід
panel-phase-ended = кінець

panel-timing-no-realtime = Немає прав реального часу
panel-timing-missed = пропущено тактів: { $cycles }, не довше { $longest } мс

# Program.
panel-work-none = Програму не завантажено
panel-work-part = Деталь { $part }
panel-work-load-again = Перепланувати звідси
panel-work-load-first = Завантажте програму у вкладці «Завдання».

# Why can't I start?.
panel-why-for = Бракує для «{ $command }»
panel-why-nothing = { $command }: готово до старту.
panel-why-runs = Програма виконується.

# Interlocks and permissives: why a command is refused.
panel-lack-moving = Осі ще рухаються: зачекайте.
panel-lack-lost = Зв’язок утрачено. Жодна команда не повторюється автоматично.

# Roles of passes.
panel-pass-role-tack = Прихватка
panel-pass-role-root = Корінь
panel-pass-role-fill = Заповнення
panel-pass-role-cap = Облицювання
panel-pass-role-cosmetic = Косметичний

# Unfinished welds.
panel-left-button = Продовжити прохід { $pass } з { $s } мм …
panel-left-elsewhere = Зварювання { $weld } ({ $title }, деталь { $part }) не завершене: прохід { $pass }, { $s } мм. Щоб продовжити, завантажте його завдання й деталь.
panel-left-title = Продовжити з місця зупинки
panel-left-of = Зварювання { $weld }: { $title }, деталь { $part }.
panel-left-where = Зупинено в проході { $pass }, зварено до { $s } мм.
panel-left-overlap = Перекриття, мм
panel-left-from = Почнеться знову в проході { $pass } на { $s } мм.
panel-left-ground = Кратер зачищено й оглянуто
panel-left-arm = Само нічого не почнеться: потім дозвольте й пустіть як завжди.
panel-left-go = Завантажити звідти

# Welding again.
panel-again-title = Зварити готове ще раз?
panel-again-left = Щоб продовжити, скасуйте й натисніть «Продовжити прохід { $pass }» (зупинено на { $s } мм).
panel-again-go = Зварити ще раз

# Positions.
panel-position-tip = Вістря (система деталі)
panel-position-tip-in = Вістря інструмента ({ $frame })
panel-position-machine = Осі верстата
panel-position-unreferenced = нуль невідомий

panel-override-less = Менша корекція
panel-override-more = Більша корекція

# Plots.
panel-plot-path = Швидкість уздовж шва
panel-plot-greatest = Макс. похибка слідкування
panel-plot-position = Положення
panel-plot-axis = Вісь
panel-plot-choose = Вибрати графіки
panel-plot-speed = Швидкість
panel-plot-error = Похибка слідкування
panel-plot-deviation = Відхилення стику
panel-plot-seen = видно
panel-plot-done = виправлено

# State of tracking.
panel-sight-seen = Стик знайдено
panel-sight-bridged = Стик знайдено, прихватку перекрито
panel-sight-coasted = Не видно, утримання
panel-sight-fading = Не видно, повернення до плану
panel-sight-unseen = Ще не видно
panel-sight-lost = Стик втрачено

# Alarms.
panel-alarms-none = Тривог немає
panel-alarms-unknown = Тривоги невідомі: немає поточних даних
panel-alarms-more = і ще { $n }

# Alarm state.
panel-alarm-state-unacknowledged = активна
panel-alarm-state-acknowledged = активна, підтверджена
panel-alarm-state-returned = зникла, не підтверджена
panel-alarm-state-gone = зникла, відкладена

# Reactions.
panel-reaction-told = лише повідомлення
panel-reaction-hold = пауза
panel-reaction-process-off-hold = процес вимк., пауза
panel-reaction-process-off-stop-power-off = процес вимк., зупинка, без живлення
panel-reaction-process-and-power-off = процес і живлення вимк.

# Devices.
panel-device-drives = приводи
panel-device-source = джерело процесу
panel-device-process-source = джерело процесу
panel-device-inputs = входи

# 3D view.
panel-scene-fails = Цей браузер не показує 3D (WebGL 2).
panel-scene-views = Види
panel-scene-show = Показ
panel-scene-colour = Колір проходів за
panel-scene-cut = Січна площина
panel-scene-measure = Виміряти
panel-scene-heat = Погонна енергія дуги
panel-scene-no-heat = Погонна енергія дуги невідома: у програмі немає ні струму й напруги, ні потужності.
panel-scene-no-value = Для цієї програми це невідомо.
panel-scene-off-beam = Відхилення променя
panel-scene-off-torch = Відхилення
panel-scene-measure-how = Виберіть два місця.

panel-spot-span = Ділянка
panel-spot-pass = Весь прохід

panel-clearance-least = (мін. { $min } мм)

# Views.
panel-view-fit = Вписати
panel-view-fit-how = Шов; ще раз: усе
panel-view-top = Згори
panel-view-front = Спереду
panel-view-side = Збоку
panel-view-torch = Пальник

# Layers.
panel-layer-machine = Верстат
panel-layer-part = Деталь і оснащення
panel-layer-zones = Зони
panel-layer-air = Холості ходи
panel-layer-near = Найближче місце
panel-layer-sensors = Поля давачів
panel-layer-trace = Слід вістря

# Jogging.
panel-jog-frame = Рухати
panel-jog-joints = Осями
panel-jog-tip = Вістрям
panel-jog-turn = Навколо вістря
panel-jog-turn-how = Повертає пальник, вістря на місці.
panel-jog-speed = Швидкість ручного руху
panel-jog-end = Закінчити ручний рух
panel-jog-how = Рухається, доки тримаєте. Стрілки: перші два рядки, Page Up/Down: третій.
panel-jog-step = Крок
panel-jog-held = безперервно
panel-jog-step-how = Один крок { $step } мм або градусів за натискання; відпустите — зупиниться раніше.

# Go to.
panel-go-title = Перейти
panel-go-begin = Початок проходу { $pass }
panel-go-spot = Вибрана точка
panel-go-home = Вихідне положення
panel-go-how = Усі осі рухаються, доки тримаєте кнопку, і прибувають разом. Шлях без зіткнень не планується: комірка зупиниться перед перешкодою.
panel-frame-title = Система координат
panel-frame-work = Деталь
panel-frame-base = База
panel-frame-tool = Інструмент
panel-frame-flange = Фланець
panel-frames-kind-base = База
panel-frames-kind-mount = Перехідник
panel-frames-kind-flange = Фланець
panel-frames-kind-adapter = Адаптер
panel-frames-kind-tool = Інструмент
panel-frames-kind-tcp = Вістря інструмента (TCP)
panel-frames-kind-table = Позиціонер
panel-frames-kind-work = Деталь
panel-frames-within-base = у базі
panel-frames-within-flange = у фланці
panel-frames-within-work = у системі деталі, усі осі в нулі
panel-frames-within-before = у попередній системі
panel-frames-how = Положення в мм. Саме вістря знаходять на сторінці «Інструмент». Зміна зберігається в { $file }; попереднє лишається поруч.
panel-frames-change = Змінити
panel-frames-keep = Зберегти
panel-frames-remove = Вилучити
panel-frames-was = було: { $frame }
panel-frames-back = Повернути попередню
panel-frames-new = Нова система користувача
panel-frames-taken = Цю назву зайнято.
panel-frames-teach = Навчити за трьома точками
panel-frames-teach-how = У ручному русі підведіть вістря до кожної точки й запишіть її тут. Система задається в базі.
panel-frames-point-1 = Початок
panel-frames-point-2 = Точка на осі x
panel-frames-point-3 = Точка з боку y
panel-frames-record = Записати
panel-frames-jog = Щоб записувати точки, почніть ручний рух.
panel-frames-taught = Між точками { $distance } мм, кут { $angle }°
panel-frames-large = Велика зміна: { $distance } мм, { $angle }°. Збережіть ще раз для підтвердження.
panel-rotation-title = Орієнтація
panel-rotation-kept = як зараз
panel-rotation-xyz = RX RY RZ (нерухомі осі X, Y, Z)
panel-rotation-abc = A B C (повернуті осі Z, Y, X)
panel-rotation-quaternion = Кватерніон Q1–Q4
panel-rotation-next = Показати орієнтацію в іншому записі
panel-rotation-none = Числа не задають орієнтації: сума квадратів чисел кватерніона дорівнює 1.
panel-target-title = Ввести ціль
panel-target-present = Поточне положення
panel-target-check = Перевірити
panel-target-go = Рухатися туди (тримати)
panel-target-clear = дорогою нічого поруч
panel-target-missed = Пальник відхилиться від цього напрямку на { $angle }°: машина не має для нього осей.
panel-target-how = Перевірка показує ціль, шлях і зазор у 3D до початку руху. У системі інструмента числа відносні.
panel-arm-title = Конфігурація
panel-arm-shoulder-front = Спереду
panel-arm-shoulder-back = Ззаду
panel-arm-elbow-up = Лікоть угорі
panel-arm-elbow-down = Лікоть унизу
panel-arm-wrist-no-flip = Кисть не перевернута
panel-arm-wrist-flip = Кисть перевернута
panel-arm-turns = Оберти { $turns }
panel-arm-no-turns = Оберти 0
panel-arm-turns-how = Цілі оберти осей 1–6 понад 180 градусів
panel-arm-near-shoulder = близько до особливості плеча
panel-arm-near-elbow = близько до особливості ліктя
panel-arm-near-wrist = близько до особливості кисті
panel-job-reach = Досяжність
panel-reach-moved = Переміщується
panel-reach-work = Деталь
panel-reach-base = Основа машини
panel-reach-budget = Час
panel-reach-search = Знайти найкраще місце
panel-reach-from = від
panel-reach-to = до
panel-reach-cells = місць
panel-reach-how = Місць навколо поточного: { $n }. Запас — найменша відстань осі до кінця її діапазону.
panel-reach-too-many = Місць: { $n }; щонайбільше { $max }.
panel-reach-judged = Оцінено місць: { $done } з { $total }
panel-reach-refines = Найкраще місце уточнюється й планується
panel-reach-best = Найкраще місце
panel-reach-margin = Запас
panel-reach-apply = Внести до завдання
panel-reach-is-best = Поточне місце — найкраще.
panel-reach-none = На жодному місці цих діапазонів зварювання не планується.
panel-reach-base-how = Основу переміщують у файлі машини: { $key } = { $move } мм, поворот { $angle }°.
panel-reach-changed = Завдання змінено після пошуку: шукайте ще раз.
panel-reach-cut-off = Час вичерпано раніше, ніж усе оцінено: найкраще зі знайденого.
panel-reach-failed = Не планується в { $place }: { $reason }
panel-reach-weldable = Можна зварити на { $n } з { $total } оцінених місць.
panel-reach-map = Запас за x і y
panel-reach-legend = Числа: запас у відсотках. Штрихування: зварити не можна, вказано вісь-причину. ○ поточне місце, ★ найкраще.
panel-arm-from = від { $s } мм
panel-schedule-title = Серії
panel-schedule-jobs = Завдання
panel-schedule-import = Завантажити таблицю
panel-schedule-import-how = CSV або TOML, рядок на кожен шов: шаблон, змінені значення й машини, що можуть його зварити. Файли в jobs/schedules теки даних теж у списку.
panel-schedule-none = Таблиць ще немає.
panel-schedule-open = Відкрити
panel-schedule-delete = Видалити таблицю та її результати?
panel-schedule-replace = { $name } уже є. Замінити? Незмінені рядки збережуть результати.
panel-schedule-run = Планувати всі рядки
panel-schedule-go-on = Планувати решту рядків
panel-schedule-post = Керуючі програми
panel-schedule-no-post = немає
panel-schedule-limit = Межа часу на план
panel-schedule-progress = { $done } з { $total } рядків
panel-schedule-kept = { $kept } були готові раніше
panel-schedule-rate = { $rate } рядків/хв
panel-schedule-counting = Таблиця читається
panel-schedule-other = Планується { $name }; одночасно — одна таблиця.
panel-schedule-failed = Останній запуск перервано: { $why }
panel-schedule-planned = заплановано
panel-schedule-new = не заплановано
panel-schedule-filter = Показати
panel-schedule-all = усі
panel-schedule-of = { $n } з { $total } рядків
panel-schedule-more = Ще рядків у файлах результатів: { $n }.
panel-schedule-row = Рядок
panel-schedule-name = Шов
panel-schedule-status = Результат
panel-schedule-machine = Машина
panel-schedule-count = Деталі
panel-schedule-passes = Проходи
panel-schedule-time = Час, хв
panel-schedule-arc = Дуга, хв
panel-schedule-wire = Дріт, кг
panel-schedule-clearance = Зазор, мм
panel-schedule-reason = Зауваження
panel-schedule-job = Відкрити як завдання
panel-schedule-parts-of = Деталі на машинах
panel-schedule-gantt-how = Штрихування: налагодження. Натискання на деталь покаже її рядок.
panel-schedule-total = Деталей: { $parts } · зварювання { $weld } год · остання через { $end } год
panel-schedule-export = Вивантажити
panel-schedule-export-how = Файли записуються, коли заплановано всі рядки.
panel-schedule-report = Звіт
panel-schedule-waiting = чекає
panel-schedule-weldable = можна зварити
panel-schedule-not-weldable = не можна зварити
panel-schedule-out-of-time = забракло часу
panel-schedule-invalid = неприпустимо
panel-schedule-invalid-table = У таблиці помилка: { $why }

# Teaching by camera.
panel-teach-by = Навчання
panel-teach-by-hand = Вручну
panel-teach-by-eye = Камерою
panel-teach-open = Увімкнути камеру
panel-teach-pause = Пауза
panel-teach-resume = Продовжити
panel-teach-stop = Закінчити навчання
panel-teach-here-spot = Стик — у місці, вибраному в 3D
panel-teach-here-begin = Стик починається там, де програма
panel-teach-here-eye = Стик — під хрестом
panel-teach-here-how = Торкніться стику на зображенні, виберіть у 3D або наведіть хрест. Після цього верстат рушить.
panel-teach-end-here = Стик тут закінчується
panel-teach-picture = Зображення камери
panel-teach-no-picture = Зображення ще немає
panel-teach-way = { $done } з { $length } мм
panel-teach-confidence = Певність
panel-teach-least = Мін.
panel-teach-frames = Кадри
panel-teach-step = Крок, мм
panel-teach-tack = Перекривати прогалини до, мм
panel-teach-seed = Зерно симуляції
panel-teach-points = Навчені точки
panel-teach-tolerance = Допуск, мм
panel-teach-method = Криві
panel-teach-greedy = прямі, дуги
panel-teach-fewest = найменше прямих, дуг
panel-teach-spline = сплайн
panel-teach-make = Підібрати криві
panel-teach-made = прямих { $lines }, дуг { $arcs }, частин сплайна { $splines }; { $length } мм
panel-teach-error = Похибка підбору
panel-teach-from-nominal = Стик від програми: убік / угору
panel-teach-truth = Від справжнього стику (симуляція)

# Teach phase.
panel-teach-phase-closed = Камеру вимкнено
panel-teach-phase-plans = Шукаємо шов …
panel-teach-phase-places = Покажіть початок стику. Машина рушить.
panel-teach-phase-runs = Рух уздовж стику
panel-teach-phase-paused = Пауза
panel-teach-phase-asks = Стик утрачено. Покажіть, де він продовжується.
panel-teach-phase-ended = Закінчено

# Teach pause.
panel-teach-pause-operator = оператором
panel-teach-pause-hand = осі рухали вручну
panel-teach-pause-control = ця сторінка втратила керування
panel-teach-pause-mode = комірка не в ручному режимі

# Teach end.
panel-teach-end-closed = знову на початку
panel-teach-end-joint-end = у кінці стику
panel-teach-end-operator = завершив оператор
panel-teach-end-lost = стик втрачено
panel-teach-end-limit = верстат далі не може
panel-teach-end-too-long = довше, ніж дозволяє номінальний шов
panel-teach-end-out-of-frames = кадрів більше немає
panel-teach-end-stopped = зупинено
panel-teach-end-failed = не вдалося

# Teaching by hand.
panel-taught-title = Навчання вручну
panel-taught-record = Записати точку
panel-taught-clear = Очистити
panel-taught-back = Повернути точки: { $n }
panel-taught-of = Ці точки записано на { $machine }: для цього верстата вони не годяться. Очистьте їх або завантажте програму того верстата.
panel-taught-remove = Вилучити точку { $point }
panel-taught-save = Зберегти як програму
panel-taught-saved = Збережено: { $file }. Шукайте в «Завданнях».

panel-lies-misplaced = зсув 2 мм і пів градуса, хвиляста, дві прихватки
panel-lies-half-ring = зсув 2 мм і пів градуса, овальна, одна прихватка

# Form of a job.
panel-form-add-what = Додати розділ
panel-form-add = Додати
panel-form-add-key = Додати значення
panel-form-values = Значень: { $n }
panel-form-in-text = Показати в тексті
panel-form-remove = Вилучити
panel-form-kind = Вид з’єднання
panel-form-procedure = Технологія (WPS)
panel-form-ships = Ця технологія постачається з програмою. Свою копію можна змінювати.
panel-form-copy = Зробити копію
panel-form-whose = За цим файлом перевіряється кожне завдання, що його називає.
panel-form-allowed = Дозволено: { $allowed }
panel-form-no-number = Не число. Лишається { $value }.
panel-form-keep = Зберегти технологію

# Limits of the speed.
panel-bound-title = Швидкість обмежена
panel-bound-at-asked = Запрограмована швидкість на { $share } % довжини.
panel-bound-everywhere = Межа машини: { $speed } мм/с.
panel-bound-asked = запрограмована швидкість
panel-bound-speed = швидкість
panel-bound-acceleration = прискорення
panel-bound-jerk = ривок
panel-bound-tip = вістря пальника
panel-bound-ends = розгін або гальмування
panel-bound-more = У звіті ще ділянок: { $n }.
panel-bound-used = Межі осей і скільки з них ужито
panel-bound-of = ≤ { $share } % від { $limit }

# Cross-section.
panel-section-where = Місце вздовж шва
panel-section-dihedral = Між поверхнями
panel-section-gap = Зазор у корені
panel-section-mismatch = Зміщення кромок
panel-section-area = Площа
panel-section-beads = валиків
panel-section-bead = Валик
panel-section-role = Роль
panel-section-no-beads = Валики не сплановано: один прохід уздовж шва.
panel-section-none = Завдання не описує стику.

# Part and fixtures.
panel-parts-add = Додати тіло
panel-parts-add-go = Додати
panel-parts-shape = Форма
panel-parts-as = Що це
panel-parts-fixture = Оснащення
panel-parts-part = Деталь
panel-parts-part-why = Тіла деталі додаються до тієї, що створюється зі шва.
panel-parts-replaced = Деталь, створену зі шва, замінено (part.replace): зіткнення перевіряються лише з тілами нижче.
panel-parts-none = Завдання не має власних тіл: деталь будується зі шва.
panel-parts-fixed = Змінюється в тексті.
panel-parts-unnamed = без назви
panel-parts-at = Місце
panel-parts-turn = Поворот навколо
panel-parts-tip = До вістря пальника

# Shapes.
panel-shape-box = паралелепіпед
panel-shape-cylinder = циліндр
panel-shape-sphere = куля
panel-shape-cone = конус
panel-shape-capsule = капсула
panel-shape-ellipsoid = еліпсоїд
panel-shape-half-space = півпростір

# Size.
panel-size-size = Розмір
panel-size-radius = Радіус
panel-size-top-radius = Верхній радіус
panel-size-length = Довжина
panel-size-semi-axes = Піввісь

# Placing the part by touching.
panel-touch-title = Розмістити деталь дотиком
panel-touch-how = На вкладці ручного руху торкніться деталі вістрям і запишіть точки (від { $n }); тоді вони з’являться тут.
panel-touch-other = Завдання для іншого верстата, ніж у цій комірці.
panel-touch-method = Спосіб
panel-touch-radius = Радіус щупа, мм
panel-touch-on = Елемент для точки { $point }
panel-touch-go = Обчислити місце
panel-touch-moved = Деталь зміщено на
panel-touch-rms = Відхилення точок (СКВ)
panel-touch-use = Внести до завдання

# Touch method.
panel-touch-method-best-fit = Найкраще припасування
panel-touch-method-plane-line-point = Площина, лінія, точка
panel-touch-method-three-points = Площина, початок, напрям
panel-touch-method-chuck = Вісь патрона: торець і коло

# Features.
panel-feature-nozzle = штуцер / перша деталь
panel-feature-body = корпус / друга деталь
panel-feature-plane = площина z = 0
panel-feature-line = грань y = 0
panel-feature-point = грань x = 0
panel-feature-origin = початок координат
panel-feature-direction = місце на осі x
panel-feature-face = торець z = 0
panel-feature-round = коло навколо z

# Plan.
panel-plan-plans = Планування …
panel-plan-cancelled = Планування скасовано.
panel-plan-again = Спланувати знову
panel-plan-wrong = Завдання має помилки
panel-plan-good = Можна зварити
panel-plan-report = Звіт про план
panel-plan-report-with-appendix = Звіт із додатком
panel-plan-before = Завдання має помилки. Це план до зміни.
panel-plan-none = Плану немає (див. Зауваження). Показано геометрію завдання.
panel-plan-line = рядок { $line }
panel-plan-whole = Повне повідомлення
panel-plan-bad = Як запрограмовано, зварити не можна
panel-plan-time = усього { $time } с

# Kinds of findings.
panel-finding-access = Пальнику немає місця
panel-finding-air = Холостий хід заблоковано
panel-finding-attitude = Кут пальника поза допуском
panel-finding-bead = Валик не відповідає проходу
panel-finding-blend = Кут заокруглюється
panel-finding-clearance = Зіткнення або замалий просвіт
panel-finding-cooling = Час охолодження поза межами
panel-finding-drive = Привід на межі струму
panel-finding-hold = Вісь не можна втримати там
panel-finding-interpass = Очікування між проходами
panel-finding-jump = Осі довелося б стрибнути
panel-finding-joint = З'єднання поза стандартом
panel-finding-least-speed = Повільніше, ніж дозволяє технологія
panel-finding-oscillation = Коливання лишають пропуски
panel-finding-plausible = Значення неправдоподібне
panel-finding-pool = Валик завеликий для положення
panel-finding-preheat = Підігрів занизький
panel-finding-path = Відхилення від шва
panel-finding-procedure = Поза межами WPS
panel-finding-range = Вісь за межами ходу
panel-finding-reach = Недосяжно
panel-finding-retract = Пальник відводиться
panel-finding-ripple = Швидкість нерівномірна
panel-finding-singular = Близько до сингулярності
panel-finding-speed = Запрограмована швидкість не досягається
panel-finding-stop = Пальник зупиняється на шляху
panel-finding-stopped = Зварювання зупинено
panel-finding-time = Триває надто довго
panel-finding-turn = Пальник стрибнув би в куті
panel-finding-search = Пошук закінчено без плану
panel-finding-unchecked = Зіткнення не перевірено
panel-finding-unwind = Вісь відмотується між проходами

# Part programs.
panel-post-dialect = Система ЧПК
panel-post-make = Створити програму ЧПК
panel-post-save = Зберегти файл
panel-post-old = Це програма іншого стану завдання: зробіть її знову.
panel-post-proof = Перевірка

# Table of points.
panel-points-point = Точка
panel-points-along = Рух
panel-points-column = Стовпець
panel-points-value = Значення
panel-points-insert = Вставити після
panel-points-delete = Вилучити ({ $n })
panel-points-set = Застосувати до точок: { $n }
panel-points-split = Поділити тут
panel-points-several = Вибір кількох
panel-points-reduce = Спростити
panel-points-tolerance = Допуск спрощення, мм
panel-points-way = Інтерполяція
panel-points-way-set = Задати інтерполяцію ({ $n })
panel-points-why-row = Виберіть точки підряд, не початок.
panel-points-why-two = Дугу роблять дві точки: вона йде через першу до другої.
panel-points-why-place = Ці точки не мають місця в x, y, z, як треба дузі.
panel-points-start = початок

# Interpolation.
panel-along-line = пряма
panel-along-arc = дуга
panel-along-spline = сплайн
panel-along-taught = навчений
panel-along-rapid = швидкий хід
panel-along-cubic = кубічний

# Columns.
panel-column-n = Кадр
panel-column-time = Час
panel-column-speed = Швидкість

# Signals of a record.
panel-trace-welded = Зварено
panel-trace-tip-s = Місце вістря
panel-trace-path-error = Відхилення від траєкторії
panel-trace-attitude-error = Похибка орієнтації
panel-trace-process-state = Стан процесу
panel-trace-burning = Дуга або промінь увімкнено
panel-trace-steady = Рівномірний рух
panel-trace-power = Живлення приводів
panel-trace-inputs = Входи (біти)
panel-trace-true = Істинне місце
panel-trace-deviation = Відхилення стику
panel-trace-correction = Корекція
panel-trace-miss = Відхилення від стику
panel-trace-rows = На графіку { $shown } з { $samples } відліків; піки збережено.
panel-trace-move = Стрілки рухають курсор.

# Results.
panel-result-good = добре
panel-result-deviating = поза допуском
panel-result-stopped = зупинено
panel-result-interrupted = перервано
panel-result-running = триває

# Set-up.
panel-setup-machine = Верстат
panel-setup-devices = Входи й виходи
panel-setup-tuning = Налаштування приводів
panel-setup-alarms = Перелік тривог
panel-setup-users = Користувачі
panel-setup-audit = Журнал дій
panel-setup-backup = Резервна копія
panel-setup-data = Резервна копія
panel-setup-timing = Час і пристрої
panel-setup-period = Цикл
panel-setup-missed = Пропущено циклів
panel-setup-lost = Не записано циклів
panel-setup-age = Вік даних
panel-setup-status-age = Вік стану
panel-setup-answers = Час відповіді ({ $devices }): медіана / макс.
panel-setup-station = Станція
panel-setup-sensors = Давачі
panel-setup-parameters = Осі та приводи
panel-setup-tool = Інструмент
panel-setup-frames = Системи координат
panel-setup-pages = Сторінки наладки
panel-setup-diagnostics = Діагностика

# Backup.
panel-data-backup-how = Усі зварювання, завдання, користувачі й журнали одним файлом. Ключів шифрованих з’єднань у ньому немає.
panel-data-restore = Відновлення
panel-data-restore-how = Замінює всі дані резервною копією. Спершу файл перевіряється; до підтвердження нічого не змінюється. Теперішні дані лишаються в теці поруч.
panel-data-off = Спершу вимкніть верстат.
panel-data-file = Файл копії (.tar)
panel-data-check = Надіслати й перевірити
panel-data-checks = Надсилання й перевірка …
panel-data-whole = Копія ціла:
panel-data-welds = Зварювання
panel-data-newest = Останнє зварювання
panel-data-jobs = Завдання
panel-data-users = Користувачі
panel-data-audit = Записи журналу дій
panel-data-replace = Замінити всі дані
panel-data-sure = Усі дані цієї комірки замінюються копією. Панель почне знову, і всім доведеться ввійти під її користувачами.
panel-data-begins = Панель починає знову з відновленими даними. Увійдіть знову за мить.

# Inputs and outputs.
panel-io-signal = Сигнал
panel-io-kind = Вид
panel-io-safe = Безпечне
panel-io-place = Регістр
panel-io-unit = пристрій
panel-io-watchdog = виходи безпечні через { $time } с
panel-io-polls = Опитувань
panel-io-missed = пропущено
panel-io-failed = невдалих
panel-io-connections = З’єднань
panel-io-away = Без зв’язку
panel-io-round = Опитування: медіана / 99,9 % / макс.
panel-io-trouble = Останній збій:
panel-io-wants = має бути { $state }

# Io name.
panel-io-name-gas = Газовий клапан
panel-io-name-on = Дуга або промінь увімкнено
panel-io-name-watchdog = Ознака життя комірки
panel-io-name-ready = Джерело готове
panel-io-name-burning = Дуга або промінь увімкнено
panel-io-name-stuck = Дріт або електрод прилип
panel-io-name-fault = Помилка джерела (код; 0 — немає)
panel-io-name-heartbeat = Ознака життя пристрою

# Io kind.
panel-io-kind-input = вхід
panel-io-kind-output = вихід
panel-io-kind-set = задане значення
panel-io-kind-report = повідомлення
panel-io-kind-actual = фактичне значення

# Tuning.
panel-tune-go = Налаштувати й виміряти
panel-tune-waits = Вимірювання …
panel-tune-how = Контур положення на приводі в моделі; нічого не рухається й не змінюється.
panel-tune-assumed = Файл верстата не описує приводу: налаштовано припущений.
panel-tune-gain = Підсилення розімкненого контуру
panel-tune-phase = Фаза розімкненого контуру
panel-tune-gain-margin = Запас за підсиленням
panel-tune-phase-margin = Запас за фазою
panel-tune-take = Зберегти ці налаштування

# Audit log.
panel-audit-command = Команда
panel-audit-values = Значення
panel-audit-newest = Найновіші записи: { $n }; є й давніші.
panel-audit-whole = { $n } { $n ->
    [one] запис
    [few] записи
   *[many] записів
 }
panel-audit-none = Жоден запис не має цього тексту.
panel-audit-older = Показати давніші
panel-audit-english = Пошук охоплює коди, назви та значення записів.

# Axes.
panel-axis-current = Струм
panel-axis-range = Межі
panel-axis-max-speed = Макс. швидкість
panel-axis-fault = несправність
panel-axis-limit = кінцевий вимикач
panel-axis-referenced = нуль відомий
panel-axis-home = Вісь { $axis } у вихідне
panel-axis-home-how = Переміщує одну вісь у вихідне. Пошук опорних точок – для всіх осей.

# Condition.
panel-condition-for = Потрібна для
panel-condition-met = виконано
panel-condition-unmet = не виконано

# Level.
panel-level-power = живлення
panel-level-motion = руху
panel-level-process = процесу

# Users.
panel-user-role = Роль
panel-user-enabled = Може входити
panel-user-password = Новий пароль (від 10 знаків)
panel-user-own-password = Ваш власний пароль
panel-user-first-run = Пароля ще немає. Створіть обліковий запис адміністратора.
panel-user-deleted = Видалено: { $user }.
panel-user-saved = Збережено: { $user }.
panel-user-password-again = Новий пароль ще раз
panel-user-password-differs = Паролі різні.
panel-user-new = Новий користувач
panel-user-edits = Змінити користувача { $user }
panel-user-exists = Користувач { $user } уже є.
panel-user-over = Змінити його? Роль: { $role }, вхід дозволено: { $enabled }. Пароль лишається.
panel-user-over-password = Змінити його? Роль: { $role }, вхід дозволено: { $enabled }. Пароль стане новим.
panel-user-change = Змінити

# Parameters.
panel-par-how = Значення файлу верстата. Вони перевіряються разом і зберігаються в { $file }; старий файл лишається поруч. Сірим – типове значення.
panel-par-pending = Збережено, діятиме після перезавантаження: вимкніть приводи та завантажте завдання знову.
panel-par-reload = Завантажити завдання знову
panel-par-keep = Зберегти
panel-par-kept = Збережено в { $file }
panel-par-wild = Значна зміна – підтвердьте:
panel-par-wrong = Не число: { $value }
panel-par-no-drive = Файл верстата не описує приводу цієї осі.
panel-par-notches = Режекторні фільтри
panel-par-notch = { $frequency } Гц, ширина { $width } Гц, підсилення { $gain }
panel-par-group-axis = Вісь
panel-par-group-loop = Контур положення і привід
panel-par-group-feedforward = Компенсація
panel-par-group-mechanics = Механіка та масштаб
panel-par-group-pose = Де стоїть
panel-par-group-map = Пікселі в мм
panel-par-group-timing = Час і шум
panel-par-home = Вихідне положення
panel-par-max-speed = Макс. швидкість
panel-par-max-acceleration = Макс. прискорення
panel-par-max-jerk = Макс. ривок
panel-par-velocity-bandwidth = Смуга контуру швидкості
panel-par-kp = Пропорційний коефіцієнт (kp)
panel-par-ki = Інтегральний коефіцієнт (ki)
panel-par-kd = Диференціальний коефіцієнт (kd)
panel-par-kvff = Випередження за швидкістю
panel-par-kaff = Випередження за прискоренням
panel-par-limit = Межа сили або моменту
panel-par-current-time-constant = Стала часу контуру струму
panel-par-current-delay = Запізнення струму
panel-par-friction-compensation = Компенсація тертя
panel-par-friction-smoothing = … швидкість згладжування
panel-par-backlash-compensation = Компенсація люфту
panel-par-backlash-time = … час компенсації
panel-par-encoder-counts = Імпульсів енкодера на одиницю
panel-par-inertia = Рухома маса або інерція
panel-par-peak = Пікова сила або момент
panel-par-friction = Тертя
panel-par-viscous = В’язке тертя
panel-par-resonance = Резонанс
panel-par-load-ratio = Інерція навантаження до двигуна
panel-par-bandwidth = Смуга контуру положення
panel-par-measured-at = Виміряно за
panel-par-following-counts = Похибка слідкування, імпульсів
panel-par-load-error = Похибка на навантаженні
panel-par-notch-at = Режекторний фільтр на

# TCP calibration.
panel-tool-title = Знайти вістря дотиком до однієї точки
panel-tool-how = Закріпіть вістря-покажчик. Торкніться його та запишіть; нахиліть чи поверніть пальник і торкніться знову: щонайменше { $n } напрямки, через 20°.
panel-tool-head = Головка
panel-tool-record = Записати дотик
panel-tool-jog = Дотики записуються в ручному режимі або навчанні.
panel-tool-touch = Дотик { $touch }
panel-tool-remove = Вилучити дотик { $touch }
panel-tool-find = Обчислити TCP
panel-tool-was = Поточна TCP
panel-tool-found = Знайдена TCP
panel-tool-deviation = Стандартне відхилення
panel-tool-rms = Відхід дотиків від точки (СКВ)
panel-tool-apart = Різниця нахилів
panel-tool-keep = Зберегти цю TCP
panel-tool-verdict-good = Дотики узгоджені, вістря визначене в усіх напрямках.
panel-tool-verdict-unseen = Дотики узгоджені, але визначають вістря не в усіх напрямках.
panel-tool-verdict-far = Вістря змістилося б понад 20 мм: чи завжди була та сама точка?
panel-tool-verdict-poor = Дотики не узгоджені в межах 0.5 мм: повторіть.
panel-tool-unseen = Не визначене вздовж ({ $direction }): там лишається, як було.
panel-tool-old = Назад до поточної TCP

# Sensors.
panel-sensor-none = У верстата немає давачів.
panel-sensor-title = Відкалібрувати камеру за сіткою
panel-sensor-how = Покладіть пластину з сіткою темних точок прямо перед камерою на відомій висоті: вона має займати половину кадру або більше.
panel-sensor-pitch = Крок точок, мм
panel-sensor-z = Висота пластини (z), мм
panel-sensor-file = Знімок сітки
panel-sensor-simulated = Симульований знімок
panel-sensor-find = Відкалібрувати
panel-sensor-picture = Знімок зі знайденими точками
panel-sensor-residuals = Сітка: калібрування. Червоні лінії: відхід кожної точки, ×{ $factor }.
panel-sensor-dots = Точки
panel-sensor-off = Відхід точок (СКВ / макс.)
panel-sensor-was = Поточна
panel-sensor-found = Знайдено
panel-sensor-scale = Масштаб x / y, мм на піксель
panel-sensor-rotation = Поворот
panel-sensor-shear = Скіс осей
panel-sensor-barrel = Дисторсія (від’ємна: бочка)
panel-sensor-centre = Оптична вісь (стовпець, рядок)
panel-sensor-middle = середина
panel-sensor-aligned = Пластина лежить уздовж осей давача: її поворот є поворотом камери
panel-sensor-in-place = Замість площини z = { $z } мм
panel-sensor-new = Як нову площину z = { $z } мм
panel-sensor-keep = Узяти калібрування
panel-sensor-planes = Площини камери
panel-sensor-remove = Вилучити площину z = { $z } мм
panel-sensor-verdict-good = Знімок відповідає сітці.
panel-sensor-move = Місце на ланці x, y, z
panel-sensor-turn = Поворот навколо напряму x, y, z
panel-sensor-angle = … на кут
panel-sensor-distance = Камера від початку відліку
panel-sensor-laser-angle = Вісь камери до площини лазера
panel-sensor-focal = Фокусна відстань
panel-sensor-homography = Гомографія h1 … h8
panel-sensor-origin = Початок відліку (стовпець, рядок)
panel-sensor-period = Від кадру до кадру
panel-sensor-latency = Від знімка до результату
panel-sensor-noise = Шум положення стику

# Paused dry run.
panel-pause-jog = Рухати звідси вручну
panel-pause-where = Холостий прогін призупинено в проході { $pass } на { $s } мм. Рухайте вручну й записуйте; потім натисніть «Спланувати повернення» і «Холостий прогін».
panel-pause-begin = Холостий прогін призупинено перед першим проходом. Рухайте вручну й записуйте; потім натисніть «Спланувати повернення» і «Холостий прогін».
panel-pause-back = Спланувати повернення
panel-pause-forget = Скасувати холостий прогін

# Tour.
panel-tour-title = Ваше перше зварювання
panel-tour-close = Пропустити
panel-tour-control = Натисніть «Узяти керування» (вгорі праворуч): керує лише одна панель.
panel-tour-on = Натисніть «Увімкнути»: приводи отримають живлення.
panel-tour-home = Натисніть «У нуль»: осі знайдуть свої нулі.
panel-tour-load = Відкрийте «Завдання» й завантажте «Перший шов: ...». Його буде сплановано й перевірено; ніщо не рухається.
panel-tour-again = Осі перемістилися. Натисніть «Перепланувати звідси»: підхід почнеться звідти, де вони є.
panel-tour-dry = Холостий прогін: той самий шлях без дуги. Хай закінчиться; STOP внизу праворуч спиняє одразу.
panel-tour-jog = Ручний рух. Коли осі там, де треба, натисніть «Закінчити ручний рух».
panel-tour-fault = Аварія. Тривоги внизу кажуть, що робити: підтвердьте їх і натисніть «Скинути аварію».
panel-tour-arm = Натисніть «Дозволити»: це дозвіл на один пуск протягом хвилини. «Чому не можна почати?» покаже, чого бракує.
panel-tour-weld = Натисніть «Почати зварювання». STOP завжди внизу праворуч.
panel-tour-watch = Стежте за пальником. Спробуйте паузу й продовження (знову дозвольте) та види 3D.
panel-tour-hold = Пауза, дуга вимкнена. Знову натисніть «Дозволити», потім «Далі».
panel-tour-left = Зварювання зупинено. Натисніть ліворуч «Продовжити прохід …»: далі звідти, з перекриттям.
panel-tour-record = Готово. Відкрийте «Записи»: там зберігається кожне зварювання.
panel-tour-end = Готово. Далі: Завдання > Нове зі зразка.

# Kinds of refusals.
panel-trouble-login = Увійдіть знову
panel-trouble-password = Відхилено
panel-trouble-role = Ваша роль цього не дозволяє
panel-trouble-origin = Адреса сторінки не дозволена
panel-trouble-token = Сеанс недійсний: оновіть сторінку
panel-trouble-size = Завелике
panel-trouble-input = Неправильні дані
panel-trouble-not-found = Не знайдено
panel-trouble-busy = Не зараз
panel-trouble-other = Там інший текст
panel-trouble-exists = Уже є
panel-trouble-slow-down = Забагато запитів: зачекайте
panel-trouble-server = Помилка сервера
panel-trouble-lost = Немає зв’язку з коміркою
panel-trouble-archive = Це не ціла резервна копія Seamwright
panel-trouble-archive-newer = Копію зроблено новішою версією Seamwright
panel-trouble-archive-room = На диску немає місця

# Allowed values.
panel-allowed-not-negative = число, 0 або більше
panel-allowed-positive = число, більше за 0
panel-allowed-up-to = більше за 0, до { $max }

# Actions that roles allow.
panel-action-take-control = узяти керування
panel-action-watch = дивитися
panel-action-jobs-read = читати завдання
panel-action-jobs-write = змінювати завдання
panel-action-plan = планувати
panel-action-edit = редагувати
panel-action-post = створювати керувальні програми
panel-action-load = завантажувати
panel-action-records-read = читати записи
panel-action-tune = налаштовувати приводи
panel-action-set-up = налагоджувати
panel-action-shelve = відкладати тривоги
panel-action-audit = журнал дій
panel-action-audit-read = читати журнал дій
panel-action-backup = завантажувати копії
panel-action-restore = відновлювати
panel-action-users-read = переглядати користувачів
panel-action-users-write = змінювати користувачів
panel-action-diagnose = дивитися діагностику
panel-action-jog = рухати вручну
panel-action-teach = навчати

# Diagnostics.
panel-diag-state = Стан
panel-diag-ready = Комірка готова до роботи.
panel-diag-version = Версія
panel-diag-uptime = Працює (хв:с)
panel-diag-latency = Запізнення циклів
panel-diag-latency-how = Цикли від запуску сервера за запізненням їх початку. Висоти логарифмічні.
panel-diag-most = Найбільше
panel-diag-gap = Найдовша пауза
panel-diag-cycles = Цикли
panel-diag-rights = Права реального часу
panel-diag-granted = надано
panel-diag-missing = бракує
panel-diag-right-priority = Пріоритет реального часу
panel-diag-right-memory = Закріплена пам’ять
panel-diag-right-cpu = Окремий процесор
panel-diag-grant-priority = Пріоритет: задайте LimitRTPRIO=80 у службі або rtprio 80 у /etc/security/limits.conf і запустіть знову.
panel-diag-grant-memory = Пам’ять: задайте LimitMEMLOCK=infinity у службі або memlock unlimited у /etc/security/limits.conf і запустіть знову.
panel-diag-grant-cpu = Процесор: виберіть наявний і дозволений і запустіть знову.
panel-diag-devices = Вік повідомлень пристроїв
panel-diag-devices-how = Докладніше про пристрої: «Входи й виходи».
panel-diag-device-latency = затримка
panel-diag-disk = Диск і пам’ять
panel-diag-free = Вільно / усього
panel-diag-write = Короткий запис
panel-diag-look = Перевірено тому
panel-diag-resident = Пам’ять панелі
panel-diag-cell-resident = Пам’ять комірки
panel-diag-locked = з неї закріплено
panel-diag-queues = Черги
panel-diag-waiting = Чекають
panel-diag-room = Місць
panel-diag-queue-cycles = Цикли
panel-diag-queue-notes = Події
panel-diag-queue-commands = Команди
panel-diag-queue-audit = Журнал дій
panel-diag-alarms = Тривоги за пріоритетом
panel-diag-priority = Пріоритет
panel-diag-active = Активні
panel-diag-unacknowledged = Не підтверджені
panel-priority-critical = критичний
panel-priority-high = високий
panel-priority-medium = середній
panel-priority-low = низький
panel-diag-workers = Процеси планування
panel-diag-runs = працює
panel-question-draft = Ескіз
panel-question-plan = План
panel-question-recorded = План запису
panel-question-report = Звіт
panel-question-post = Керівна програма
panel-question-load = Завантаження
panel-question-place = Прив’язка деталі
panel-question-reach = Пошук найкращого місця
panel-question-schedule = Серія
panel-worker-answered = З відповіддю
panel-worker-refused = Помилки в завданні
panel-worker-superseded = Перервані новим запитом
panel-worker-late = Зупинені: надто довго
panel-worker-memory = Зупинені: багато пам’яті
panel-worker-failed = Зі збоєм програми
panel-diag-since = Від запуску сервера
panel-diag-welds = Зварювання
panel-diag-clients = З’єднання / сторінки / сеанси
panel-diag-logins = Входи / відмовлено
panel-diag-answers = Відповіді за статусом HTTP
