# Words of the panel, in the order of its pages.

# Words for several pages.
panel-least = Мин.
panel-mean = Среднее
panel-greatest = Макс.
panel-allowed = Допустимо
panel-program = Программа
panel-pass = Проход
panel-alarm = Тревога
panel-language = Язык
panel-tabs = Вкладки
panel-cancel = Отмена
panel-close = Закрыть
panel-search = Поиск
panel-all = Все
panel-on = вкл.
panel-off = выкл.
panel-undo = Отменить действие
panel-redo = Повторить действие
panel-set = Задано
panel-actual = Факт
panel-abort = Прервать
panel-stop = STOP: программный, не аварийный останов
panel-mode = Состояние
panel-armed = Разрешено
panel-recording = Запись { $weld }
panel-simulated = симуляция
panel-commands = Команды
panel-refused = Отказано:
panel-why = Почему нельзя начать?
panel-passes = Проходы
panel-progress = Выполнение
panel-time-left = осталось { $time }
panel-readouts = Показания
panel-process = Процесс
panel-gas = Газ
panel-speed = Скорость
panel-override = Коррекция подачи
panel-bottom = Тревоги и графики
panel-scene = Ячейка в 3D
panel-clearance = Просвет
panel-section = Сечение стыка
panel-axis = Ось
panel-conditions = Условия (блокировки)
panel-condition = Условие

# Alarms.
panel-alarm-cause = Причина
panel-alarm-state = Состояние
panel-alarm-consequence = Последствие
panel-alarm-action = Что делать
panel-alarm-reaction = Реакция
panel-alarm-priority = Приоритет
panel-alarm-severity = Тяжесть
panel-alarm-response = Время на реакцию
panel-alarm-shelvable = Откладывание
panel-alarm-chattering = ДРЕБЕЗЖИТ
panel-alarm-first = ПЕРВАЯ
panel-alarm-one = Подтвердить эту тревогу
panel-alarm-shelve = Отложить
panel-alarm-shelve-for = Отложить на
panel-alarm-minutes = { $minutes } мин
panel-alarm-unshelve = Вернуть
panel-alarm-shelved = Отложено: { $alarm }
panel-alarm-until = до { $time }, { $user }
panel-alarm-shelve-how = Отложить можно лишь сообщающие тревоги; те, что дают останов или паузу, видны всегда.

# Process values.
panel-value-tip-speed = Скорость острия
panel-value-speed = Скорость острия

# States.
panel-mode-off = Выключено
panel-mode-idle = Без нуля
panel-mode-homing = Поиск нуля
panel-mode-ready = Готово
panel-mode-jog = Ручное движение
panel-mode-teach = Обучение
panel-mode-dry-run = Холостой прогон
panel-mode-weld = Сварка
panel-mode-hold = Пауза
panel-mode-fault = Авария

# Commands.
panel-do-hold = Пауза
panel-do-resume = Дальше
panel-do-reverse = Реверс
panel-do-stop = Остановить
panel-do-switch-on = Включить
panel-do-switch-off = Выключить
panel-do-home = В ноль
panel-do-start-jog = Начать ручное движение
panel-do-start-teach = Начать обучение
panel-do-start-dry-run = Холостой прогон
panel-do-arm = Разрешить дугу
panel-do-arm-beam = Разрешить луч
panel-do-start-weld = Начать сварку
panel-do-start-beam = Начать сварку
panel-do-reset = Сбросить аварию
panel-do-acknowledge = Подтвердить все
panel-do-override = Изменить коррекцию подачи
panel-do-acknowledge-one = Подтвердить одну тревогу
panel-do-home-axis = Одну ось в исходное

# Interlocks of supplied machines.
panel-interlock-emergency-stop-chain = цепь аварийного останова
panel-interlock-light-curtain = световая завеса
panel-interlock-shielding-gas = защитный газ
panel-interlock-torch-coolant = охлаждение горелки
panel-interlock-doors = двери
panel-interlock-cooling-water = охлаждающая вода
panel-interlock-gun-pressure = давление в пушке
panel-interlock-chamber-pressure = давление в камере
panel-interlock-chamber-door = дверь камеры
panel-interlock-laser-interlocks = блокировки лазера
panel-interlock-cabin-doors = двери кабины

# Records.
panel-record-part = Деталь
panel-record-begun = Начало
panel-record-machine = Станок
panel-record-procedure = Технология
panel-record-welder = Сварщик
panel-record-list = Записи
panel-record-no-hit = Нет подходящих записей.
panel-record-none = Сварок ещё не было.
panel-record-no = №
panel-record-result = Результат
panel-record-worst = Макс. отклонение
panel-record-outside = вне пределов на { $length } мм
panel-record-from = От
panel-record-compare = Сравнить
panel-record-report = Отчёт
panel-record-facts = Сводка
panel-record-trace = Кривые
panel-record-columns = Выбрать сигналы
panel-record-no-values = В этом проходе таких значений нет.

# Events.
panel-event-time = Время
panel-event-text = Событие
panel-event-what = Что
panel-event-mode = Состояние
panel-event-order = Команда
panel-event-refused = Отказ
panel-event-alarm = Тревога
panel-event-cleared = Снято
panel-event-pass = Проход
panel-event-left = Остановлено
panel-event-record = Запись
panel-event-control = Управление
panel-event-work = Программа
panel-event-teach = Обучение

# Bottom.
panel-bottom-alarms = Тревоги
panel-bottom-events = События
panel-bottom-plots = Графики
panel-bottom-tracking = Слежение

# Jobs.
panel-job-head = Задание
panel-job-list = Задания
panel-job-own = Мои задания
panel-job-examples = Образцы
panel-job-example = Образец – сохраните как своё задание
panel-job-title = Заголовок
panel-job-name-how = Латинские буквы, цифры и . _ -
panel-job-name = Имя
panel-job-open = Открыть
panel-job-use = Новое из образца
panel-job-load = Загрузить
panel-job-loaded = загружено
panel-job-part = Номер детали (для записи)
panel-job-part-why = Программа будет спланирована, проверена и передана ячейке. Ничто не движется.
panel-job-lies = Смещение в симуляции
panel-job-lies-planned = нет
panel-job-lies-why = При смещении шов отслеживается.
panel-job-delete = Удалить
panel-job-delete-sure = Удалить { $job }? Вернуть нельзя.
panel-job-save = Сохранить
panel-job-save-as = Сохранить как …
panel-job-unsaved = не сохранено
panel-job-leave = Есть несохранённые изменения.
panel-job-discard = Отбросить изменения
panel-job-replace = Заменить
panel-job-other = Под именем { $job } уже сохранён другой текст: другого задания или изменённый кем-то с тех пор. Заменить его этим?
panel-job-edit = Изменить
panel-job-preview = Просмотр
panel-job-form = Форма
panel-job-parts = Деталь и оснастка
panel-job-points = Точки
panel-job-text = Текст
panel-job-post = G-код
panel-job-findings = Замечания
panel-job-section = Сечение
panel-job-plots = Графики
panel-job-limits = Пределы

# Tracking.
panel-track-lateral = Поперёк
panel-track-height = По высоте
panel-track-head = Головка
panel-track-none = Отслеживание выключено
panel-track-confidence = Достоверность
panel-track-sigma = Станд. отклонение
panel-track-guessed = не видно

# Pages.
panel-tab-weld = Сварка
panel-tab-teach = Движение · Обучение
panel-tab-jobs = Задания
panel-tab-records = Записи
panel-tab-setup = Наладка

panel-theme-light = Светлая
panel-theme-dark = Тёмная

# Connection.
panel-link-opening = Соединение …
panel-link-open = Связь есть
panel-link-closed = Нет связи
panel-link-stale = Данным { $age } с

# Log-in.
panel-login-user = Пользователь
panel-login-password = Пароль
panel-login-go = Войти
panel-login-out = Выйти
panel-login-over = Сеанс закончился: его закрыли, изменили или он устарел. Что работает в ячейке, работает дальше; STOP действует и здесь. Войдите снова.
panel-login-runs = В ячейке что-то работает и будет работать дальше без вас.
panel-login-stopped = STOP отправлен; состояние в тот миг: { $state }.
panel-login-made = Теперь войдите как этот пользователь. Стартовая ссылка больше не действует.
panel-login-wrong = Неверный пользователь или пароль.
panel-login-key = Первый запуск: откройте стартовую ссылку, которую вывела программа.
panel-login-owner = Владелец

# Control.
panel-control-mine = Управляете вы
panel-control-give = Отдать управление
panel-control-take = Взять управление
panel-control-free = Никто не управляет
panel-control-unknown = Управление неизвестно
panel-control-theirs = Управляет { $user } (станция { $station })
panel-control-over = Сейчас управляет { $user }. Забрать управление?
panel-control-needed = Возьмите управление, чтобы работать с ячейкой.

# Roles.
panel-role-viewer = Наблюдатель
panel-role-operator = Оператор
panel-role-programmer = Программист
panel-role-service = Сервис
panel-role-admin = Администратор

# STOP.
panel-stop-failed = STOP НЕ ДОШЁЛ ДО ЯЧЕЙКИ
panel-stop-emergency = Нажмите аварийный останов.
panel-stop-late = STOP дошёл до ячейки с опозданием
panel-stop-check = Проверьте, что машина стоит и процесс выключен.
panel-stop-unanswered = Страница на связи, но вовремя не видно, что ячейка остановилась.
panel-stop-no-connection = Нет связи с ячейкой. Страница продолжает попытки соединения.
panel-stop-read = Прочитано

# Process.
panel-process-arc-on = ДУГА ГОРИТ
panel-process-beam-on = ЛУЧ ВКЛЮЧЁН
panel-process-arc-off = Дуги нет
panel-process-beam-off = Луча нет
panel-process-ordered = Команда ВКЛ

# Phases of a pass.
panel-phase-held = в покое
panel-phase-preflow = предпродувка
panel-phase-travel-delay = задержка движения
panel-phase-travel = сварка
panel-phase-run-out = спад
panel-phase-crater = заварка кратера
panel-phase-postflow = газ после сварки
panel-phase-move = холостой ход
panel-phase-ended = конец

panel-timing-no-realtime = Нет прав реального времени
panel-timing-missed = пропущено тактов: { $cycles }, не дольше { $longest } мс

# Program.
panel-work-none = Программа не загружена
panel-work-part = Деталь { $part }
panel-work-load-again = Перепланировать отсюда
panel-work-load-first = Загрузите программу во вкладке «Задания».

# Why can't I start?.
panel-why-for = Не хватает для «{ $command }»
panel-why-nothing = { $command }: готово к пуску.
panel-why-runs = Программа выполняется.

# Interlocks and permissives: why a command is refused.
panel-lack-moving = Оси ещё движутся: подождите.
panel-lack-lost = Связь потеряна. Ни одна команда не повторяется автоматически.

# Roles of passes.
panel-pass-role-tack = Прихватка
panel-pass-role-root = Корень
panel-pass-role-fill = Заполнение
panel-pass-role-cap = Облицовка
panel-pass-role-cosmetic = Косметический

# Unfinished welds.
panel-left-button = Продолжить проход { $pass } с { $s } мм …
panel-left-elsewhere = Сварка { $weld } ({ $title }, деталь { $part }) не завершена: проход { $pass }, { $s } мм. Чтобы продолжить, загрузите её задание и деталь.
panel-left-title = Продолжить с места остановки
panel-left-of = Сварка { $weld }: { $title }, деталь { $part }.
panel-left-where = Остановлено в проходе { $pass }, сварено до { $s } мм.
panel-left-overlap = Перекрытие, мм
panel-left-from = Начнётся снова в проходе { $pass } на { $s } мм.
panel-left-ground = Кратер зачищен и осмотрен
panel-left-arm = Само ничего не начнётся: затем разрешите и пустите как обычно.
panel-left-go = Загрузить оттуда

# Welding again.
panel-again-title = Сварить готовое ещё раз?
panel-again-left = Чтобы продолжить, отмените и нажмите «Продолжить проход { $pass }» (остановлено на { $s } мм).
panel-again-go = Сварить ещё раз

# Positions.
panel-position-tip = Остриё (система детали)
panel-position-tip-in = Остриё инструмента ({ $frame })
panel-position-machine = Оси станка
panel-position-unreferenced = ноль неизвестен

panel-override-less = Меньше коррекция подачи
panel-override-more = Больше коррекция подачи

# Plots.
panel-plot-path = Скорость вдоль шва
panel-plot-greatest = Макс. рассогласование
panel-plot-position = Положение
panel-plot-axis = Ось
panel-plot-choose = Выбрать графики
panel-plot-speed = Скорость
panel-plot-error = Рассогласование
panel-plot-deviation = Отклонение стыка
panel-plot-seen = видно
panel-plot-done = исправлено

# State of tracking.
panel-sight-seen = Стык найден
panel-sight-bridged = Стык найден, прихватка перекрыта
panel-sight-coasted = Не видно, удержание
panel-sight-fading = Не видно, возврат к плану
panel-sight-unseen = Пока не видно
panel-sight-lost = Стык потерян

# Alarms.
panel-alarms-none = Тревог нет
panel-alarms-unknown = Тревоги неизвестны: нет текущих данных
panel-alarms-more = и ещё { $n }

# Alarm state.
panel-alarm-state-unacknowledged = активна
panel-alarm-state-acknowledged = активна, подтверждена
panel-alarm-state-returned = устранена, не подтверждена
panel-alarm-state-gone = устранена, отложена

# Reactions.
panel-reaction-told = только сообщение
panel-reaction-hold = пауза
panel-reaction-process-off-hold = процесс выкл., пауза
panel-reaction-process-off-stop-power-off = процесс выкл., останов, без питания
panel-reaction-process-and-power-off = процесс и питание выкл.

# Devices.
panel-device-drives = приводы
panel-device-source = сварочный источник
panel-device-process-source = сварочный источник
panel-device-inputs = входы

# 3D view.
panel-scene-fails = Этот браузер не показывает 3D (WebGL 2).
panel-scene-views = Виды
panel-scene-show = Показ
panel-scene-colour = Цвет проходов по
panel-scene-cut = Секущая плоскость
panel-scene-measure = Измерить
panel-scene-heat = Погонная энергия дуги
panel-scene-no-heat = Погонная энергия дуги неизвестна: в программе нет ни тока с напряжением, ни мощности.
panel-scene-no-value = Для этой программы это неизвестно.
panel-scene-off-beam = Отклонение луча
panel-scene-off-torch = Отклонение
panel-scene-measure-how = Выберите два места.

panel-spot-span = Участок
panel-spot-pass = Весь проход

panel-clearance-least = (мин. { $min } мм)

# Views.
panel-view-fit = Вписать
panel-view-fit-how = Шов; ещё раз: всё
panel-view-top = Сверху
panel-view-front = Спереди
panel-view-side = Сбоку
panel-view-torch = Горелка

# Layers.
panel-layer-machine = Станок
panel-layer-part = Деталь и оснастка
panel-layer-zones = Зоны
panel-layer-air = Холостые ходы
panel-layer-near = Ближайшее место
panel-layer-sensors = Поля датчиков
panel-layer-trace = След острия

# Jogging.
panel-jog-frame = Двигать
panel-jog-joints = Осями
panel-jog-tip = Горелкой
panel-jog-turn = Вокруг острия
panel-jog-turn-how = Поворачивает горелку, остриё на месте.
panel-jog-speed = Скорость ручного движения
panel-jog-end = Закончить ручное движение
panel-jog-how = Движется, пока удерживаете. Стрелки: первые две строки, Page Up/Down: третья.
panel-jog-step = Шаг
panel-jog-held = непрерывно
panel-jog-step-how = Один шаг { $step } мм или градусов за нажатие; отпустите — остановится раньше.

# Go to.
panel-go-title = Перейти
panel-go-begin = Начало прохода { $pass }
panel-go-spot = Выбранная точка
panel-go-home = Исходное положение
panel-go-how = Все оси движутся, пока удерживаете, и приходят вместе. Путь без столкновений не планируется: ячейка остановится перед препятствием.
panel-frame-title = Система координат
panel-frame-work = Деталь
panel-frame-base = База
panel-frame-tool = Инструмент
panel-frame-flange = Фланец
panel-frames-kind-base = База
panel-frames-kind-mount = Переходник
panel-frames-kind-flange = Фланец
panel-frames-kind-adapter = Адаптер
panel-frames-kind-tool = Инструмент
panel-frames-kind-tcp = Остриё инструмента (TCP)
panel-frames-kind-table = Позиционер
panel-frames-kind-work = Деталь
panel-frames-within-base = в базе
panel-frames-within-flange = во фланце
panel-frames-within-work = в системе детали, все оси в нуле
panel-frames-within-before = в предыдущей системе
panel-frames-how = Положения в мм. Само остриё находят на странице «Инструмент». Изменение хранится в { $file }; прежнее остаётся рядом.
panel-frames-change = Изменить
panel-frames-keep = Сохранить
panel-frames-remove = Удалить
panel-frames-was = было: { $frame }
panel-frames-back = Вернуть прежнюю
panel-frames-new = Новая система пользователя
panel-frames-taken = Это имя занято.
panel-frames-teach = Обучить по трём точкам
panel-frames-teach-how = В ручном движении подведите остриё к каждой точке и запишите её здесь. Система задаётся в базе.
panel-frames-point-1 = Начало
panel-frames-point-2 = Точка на оси x
panel-frames-point-3 = Точка со стороны y
panel-frames-record = Записать
panel-frames-jog = Чтобы записывать точки, начните ручное движение.
panel-frames-taught = Между точками { $distance } мм, угол { $angle }°
panel-frames-large = Большое изменение: { $distance } мм, { $angle }°. Сохраните ещё раз для подтверждения.
panel-rotation-title = Ориентация
panel-rotation-kept = как сейчас
panel-rotation-xyz = RX RY RZ (неподвижные оси X, Y, Z)
panel-rotation-abc = A B C (повёрнутые оси Z, Y, X)
panel-rotation-quaternion = Кватернион Q1–Q4
panel-rotation-next = Показать ориентацию в другой записи
panel-rotation-none = Числа не задают ориентацию: сумма квадратов чисел кватерниона равна 1.
panel-target-title = Ввести цель
panel-target-present = Текущее положение
panel-target-check = Проверить
panel-target-go = Двигаться туда (держать)
panel-target-clear = по пути ничего рядом
panel-target-missed = Горелка отклонится от этого направления на { $angle }°: у машины нет для него осей.
panel-target-how = Проверка показывает цель, путь и зазор в 3D до начала движения. В системе инструмента числа относительные.
panel-arm-title = Конфигурация
panel-arm-shoulder-front = Спереди
panel-arm-shoulder-back = Сзади
panel-arm-elbow-up = Локоть вверх
panel-arm-elbow-down = Локоть вниз
panel-arm-wrist-no-flip = Кисть не перевёрнута
panel-arm-wrist-flip = Кисть перевёрнута
panel-arm-turns = Обороты { $turns }
panel-arm-no-turns = Обороты 0
panel-arm-turns-how = Целые обороты осей 1–6 сверх 180 градусов
panel-arm-near-shoulder = близко к особенности плеча
panel-arm-near-elbow = близко к особенности локтя
panel-arm-near-wrist = близко к особенности кисти
panel-job-reach = Досягаемость
panel-reach-moved = Перемещается
panel-reach-work = Деталь
panel-reach-base = Основание машины
panel-reach-budget = Время
panel-reach-search = Найти лучшее место
panel-reach-from = от
panel-reach-to = до
panel-reach-cells = мест
panel-reach-how = Мест вокруг текущего: { $n }. Запас — наименьшее расстояние оси до конца её диапазона.
panel-reach-too-many = Мест: { $n }; не больше { $max }.
panel-reach-judged = Оценено мест: { $done } из { $total }
panel-reach-refines = Лучшее место уточняется и планируется
panel-reach-best = Лучшее место
panel-reach-margin = Запас
panel-reach-apply = Внести в задание
panel-reach-is-best = Текущее место — лучшее.
panel-reach-none = Ни на одном месте этих диапазонов сварка не планируется.
panel-reach-base-how = Основание перемещается в файле машины: { $key } = { $move } мм, поворот { $angle }°.
panel-reach-changed = Задание изменено после поиска: повторите поиск.
panel-reach-cut-off = Время истекло раньше, чем всё было оценено: лучшее из найденного.
panel-reach-failed = Не планируется в { $place }: { $reason }
panel-reach-weldable = Можно сварить на { $n } из { $total } оценённых мест.
panel-reach-map = Запас по x и y
panel-reach-legend = Числа: запас в процентах. Штриховка: сварить нельзя, указана ось-причина. ○ текущее место, ★ лучшее.
panel-arm-from = с { $s } мм
panel-schedule-title = Серии
panel-schedule-jobs = Задания
panel-schedule-import = Загрузить таблицу
panel-schedule-import-how = CSV или TOML, строка на каждый шов: шаблон, изменённые значения и машины, которые могут его варить. Файлы в jobs/schedules папки данных тоже в списке.
panel-schedule-none = Таблиц ещё нет.
panel-schedule-open = Открыть
panel-schedule-delete = Удалить таблицу и её результаты?
panel-schedule-replace = { $name } уже есть. Заменить? Неизменные строки сохранят результаты.
panel-schedule-run = Планировать все строки
panel-schedule-go-on = Планировать недостающие
panel-schedule-post = Управляющие программы
panel-schedule-no-post = нет
panel-schedule-limit = Предел времени на план
panel-schedule-progress = { $done } из { $total } строк
panel-schedule-kept = { $kept } были готовы раньше
panel-schedule-rate = { $rate } строк/мин
panel-schedule-counting = Таблица читается
panel-schedule-other = Планируется { $name }; одновременно — одна таблица.
panel-schedule-failed = Последний запуск прерван: { $why }
panel-schedule-planned = запланировано
panel-schedule-new = не запланировано
panel-schedule-filter = Показать
panel-schedule-all = все
panel-schedule-of = { $n } из { $total } строк
panel-schedule-more = Ещё строк в файлах результатов: { $n }.
panel-schedule-row = Строка
panel-schedule-name = Шов
panel-schedule-status = Результат
panel-schedule-machine = Машина
panel-schedule-count = Детали
panel-schedule-passes = Проходы
panel-schedule-time = Время, мин
panel-schedule-arc = Дуга, мин
panel-schedule-wire = Проволока, кг
panel-schedule-clearance = Зазор, мм
panel-schedule-reason = Замечания
panel-schedule-job = Открыть как задание
panel-schedule-parts-of = Детали на машинах
panel-schedule-gantt-how = Штриховка: наладка. Нажатие на деталь покажет её строку.
panel-schedule-total = Деталей: { $parts } · сварка { $weld } ч · последняя через { $end } ч
panel-schedule-export = Выгрузить
panel-schedule-export-how = Файлы пишутся, когда запланированы все строки.
panel-schedule-report = Отчёт
panel-schedule-waiting = ждёт
panel-schedule-weldable = можно сварить
panel-schedule-not-weldable = нельзя сварить
panel-schedule-out-of-time = не хватило времени
panel-schedule-invalid = недопустимо
panel-schedule-invalid-table = В таблице ошибка: { $why }

# Teaching by camera.
panel-teach-by = Обучение
panel-teach-by-hand = Вручную
panel-teach-by-eye = Камерой
panel-teach-open = Включить камеру
panel-teach-pause = Пауза
panel-teach-resume = Продолжить
panel-teach-stop = Закончить обучение
panel-teach-here-spot = Стык — в месте, выбранном в 3D
panel-teach-here-begin = Стык начинается там, где программа
panel-teach-here-eye = Стык — под крестом
panel-teach-here-how = Коснитесь стыка на изображении, выберите в 3D или наведите крест. После этого станок тронется.
panel-teach-end-here = Стык здесь кончается
panel-teach-picture = Изображение камеры
panel-teach-no-picture = Изображения ещё нет
panel-teach-way = { $done } из { $length } мм
panel-teach-confidence = Достоверность
panel-teach-least = Мин.
panel-teach-frames = Кадры
panel-teach-step = Шаг, мм
panel-teach-tack = Перекрывать пропуски до, мм
panel-teach-seed = Зерно симуляции
panel-teach-points = Обученные точки
panel-teach-tolerance = Допуск, мм
panel-teach-method = Кривые
panel-teach-greedy = прямые, дуги
panel-teach-fewest = меньше прямых, дуг
panel-teach-spline = сплайн
panel-teach-make = Подобрать кривые
panel-teach-made = прямых { $lines }, дуг { $arcs }, частей сплайна { $splines }; { $length } мм
panel-teach-error = Ошибка подбора
panel-teach-from-nominal = Стык от программы: вбок / вверх
panel-teach-truth = От истинного стыка (симуляция)

# Teach phase.
panel-teach-phase-closed = Камера выключена
panel-teach-phase-plans = Ищем шов …
panel-teach-phase-places = Покажите начало стыка. Машина придёт в движение.
panel-teach-phase-runs = Движение вдоль стыка
panel-teach-phase-paused = Пауза
panel-teach-phase-asks = Стык потерян. Покажите, где он продолжается.
panel-teach-phase-ended = Закончено

# Teach pause.
panel-teach-pause-operator = оператором
panel-teach-pause-hand = оси двигали вручную
panel-teach-pause-control = эта страница потеряла управление
panel-teach-pause-mode = ячейка не в ручном режиме

# Teach end.
panel-teach-end-closed = снова в начале
panel-teach-end-joint-end = в конце стыка
panel-teach-end-operator = завершил оператор
panel-teach-end-lost = стык потерян
panel-teach-end-limit = станок дальше не может
panel-teach-end-too-long = длиннее, чем допускает номинальный шов
panel-teach-end-out-of-frames = кадров больше нет
panel-teach-end-stopped = остановлено
panel-teach-end-failed = не удалось

# Teaching by hand.
panel-taught-title = Обучение вручную
panel-taught-record = Записать точку
panel-taught-clear = Очистить
panel-taught-back = Вернуть точки: { $n }
panel-taught-of = Эти точки записаны на { $machine }: для этого станка они не годятся. Очистите их или загрузите программу того станка.
panel-taught-remove = Убрать точку { $point }
panel-taught-save = Сохранить как программу
panel-taught-saved = Сохранено: { $file }. Ищите в «Заданиях».

panel-lies-misplaced = сдвиг 2 мм и полградуса, волнистая, две прихватки
panel-lies-half-ring = сдвиг 2 мм и полградуса, овальная, одна прихватка

# Form of a job.
panel-form-add-what = Добавить раздел
panel-form-add = Добавить
panel-form-add-key = Добавить значение
panel-form-values = Значений: { $n }
panel-form-in-text = Показать в тексте
panel-form-remove = Удалить
panel-form-kind = Вид соединения
panel-form-procedure = Технология (WPS)
panel-form-ships = Эта технология поставляется с программой. Свою копию можно менять.
panel-form-copy = Сделать копию
panel-form-whose = По этому файлу проверяется каждое задание, которое его называет.
panel-form-allowed = Допустимо: { $allowed }
panel-form-no-number = Не число. Остаётся { $value }.
panel-form-keep = Сохранить технологию

# Limits of the speed.
panel-bound-title = Скорость ограничена
panel-bound-at-asked = Заданная скорость выдержана на { $share } %.
panel-bound-everywhere = Предел машины: { $speed } мм/с.
panel-bound-asked = заданная скорость
panel-bound-speed = скорость
panel-bound-acceleration = ускорение
panel-bound-jerk = рывок
panel-bound-tip = остриё горелки
panel-bound-ends = разгон или торможение
panel-bound-more = Ещё участков в отчёте: { $n }.
panel-bound-used = Пределы осей и сколько из них занято
panel-bound-of = ≤ { $share } % от { $limit }

# Cross-section.
panel-section-where = Место вдоль шва
panel-section-dihedral = Между поверхностями
panel-section-gap = Зазор в корне
panel-section-mismatch = Смещение кромок
panel-section-area = Площадь
panel-section-beads = валиков
panel-section-bead = Валик
panel-section-role = Роль
panel-section-no-beads = Валики не спланированы: один проход вдоль шва.
panel-section-none = Задание не описывает стыка.

# Part and fixtures.
panel-parts-add = Добавить тело
panel-parts-add-go = Добавить
panel-parts-shape = Форма
panel-parts-as = Что это
panel-parts-fixture = Оснастка
panel-parts-part = Деталь
panel-parts-part-why = Тела детали добавляются к той, что создаётся из шва.
panel-parts-replaced = Деталь, созданная из шва, заменена (part.replace): столкновения проверяются только с телами ниже.
panel-parts-none = У задания нет своих тел: деталь строится по шву.
panel-parts-fixed = Изменяется в тексте.
panel-parts-unnamed = без названия
panel-parts-at = Место
panel-parts-turn = Поворот вокруг
panel-parts-tip = К острию горелки

# Shapes.
panel-shape-box = параллелепипед
panel-shape-cylinder = цилиндр
panel-shape-sphere = шар
panel-shape-cone = конус
panel-shape-capsule = капсула
panel-shape-ellipsoid = эллипсоид
panel-shape-half-space = полупространство

# Size.
panel-size-size = Размер
panel-size-radius = Радиус
panel-size-top-radius = Верхний радиус
panel-size-length = Длина
panel-size-semi-axes = Полуось

# Placing the part by touching.
panel-touch-title = Разместить деталь касанием
panel-touch-how = На вкладке «Движение · Обучение» коснитесь детали остриём и запишите не менее { $n } точек; тогда они появятся здесь.
panel-touch-other = Задание для другого станка, чем в этой ячейке.
panel-touch-method = Способ
panel-touch-radius = Радиус щупа, мм
panel-touch-on = Элемент для точки { $point }
panel-touch-go = Вычислить место
panel-touch-moved = Деталь смещена на
panel-touch-rms = Отклонение точек (СКЗ)
panel-touch-use = Внести в задание

# Touch method.
panel-touch-method-best-fit = Наилучшая подгонка
panel-touch-method-plane-line-point = Плоскость, линия, точка
panel-touch-method-three-points = Плоскость, начало, направление
panel-touch-method-chuck = Ось патрона: торец и круг

# Features.
panel-feature-nozzle = штуцер / первая деталь
panel-feature-body = корпус / вторая деталь
panel-feature-plane = плоскость z = 0
panel-feature-line = грань y = 0
panel-feature-point = грань x = 0
panel-feature-origin = начало координат
panel-feature-direction = место на оси x
panel-feature-face = торец z = 0
panel-feature-round = круг вокруг z

# Plan.
panel-plan-plans = Планирование …
panel-plan-cancelled = Планирование отменено.
panel-plan-again = Спланировать снова
panel-plan-wrong = В задании есть ошибки
panel-plan-good = Можно сварить
panel-plan-report = Отчёт о плане
panel-plan-report-with-appendix = Отчёт с приложением
panel-plan-before = В задании есть ошибки. Это план до изменения.
panel-plan-none = Плана нет (см. Замечания). Показана геометрия задания.
panel-plan-line = строка { $line }
panel-plan-whole = Полное сообщение
panel-plan-bad = Как запрограммировано, сварить нельзя
panel-plan-time = всего { $time } с

# Kinds of findings.
panel-finding-access = Горелке нет места
panel-finding-air = Холостой ход перекрыт
panel-finding-attitude = Угол горелки вне допуска
panel-finding-bead = Валик не подходит к проходу
panel-finding-blend = Угол скругляется
panel-finding-clearance = Столкновение или малый просвет
panel-finding-cooling = Время охлаждения вне пределов
panel-finding-drive = Привод на пределе тока
panel-finding-hold = Ось там нельзя удержать
panel-finding-interpass = Ожидание между проходами
panel-finding-jump = Оси пришлось бы прыгнуть
panel-finding-joint = Соединение вне стандарта
panel-finding-least-speed = Медленнее, чем допускает технология
panel-finding-oscillation = Колебания оставляют пропуски
panel-finding-plausible = Значение неправдоподобно
panel-finding-pool = Валик велик для положения
panel-finding-preheat = Подогрев слишком низкий
panel-finding-path = Отклонение от шва
panel-finding-procedure = Вне пределов WPS
panel-finding-range = Ось за пределом хода
panel-finding-reach = Недостижимо
panel-finding-retract = Горелка отводится
panel-finding-ripple = Скорость неравномерна
panel-finding-singular = Близко к сингулярности
panel-finding-speed = Заданная скорость не достигается
panel-finding-stop = Горелка останавливается в пути
panel-finding-stopped = Сварка остановлена
panel-finding-time = Длится слишком долго
panel-finding-turn = Горелка прыгнула бы в углу
panel-finding-search = Поиск закончен без плана
panel-finding-unchecked = Столкновения не проверены
panel-finding-unwind = Ось отматывается между проходами

# Part programs.
panel-post-dialect = Система ЧПУ
panel-post-make = Создать программу ЧПУ
panel-post-save = Сохранить файл
panel-post-old = Это программа другого состояния задания: сделайте её снова.
panel-post-proof = Проверка

# Table of points.
panel-points-point = Точка
panel-points-along = Движение
panel-points-column = Столбец
panel-points-value = Значение
panel-points-insert = Вставить после
panel-points-delete = Удалить ({ $n })
panel-points-set = Применить к точкам: { $n }
panel-points-split = Разделить здесь
panel-points-several = Выбор нескольких
panel-points-reduce = Упростить
panel-points-tolerance = Допуск упрощения, мм
panel-points-way = Интерполяция
panel-points-way-set = Задать интерполяцию ({ $n })
panel-points-why-row = Выберите точки подряд, не начало.
panel-points-why-two = Дугу делают две точки: она идёт через первую ко второй.
panel-points-why-place = У этих точек нет места в x, y, z, нужного дуге.
panel-points-start = начало

# Interpolation.
panel-along-line = прямая
panel-along-arc = дуга
panel-along-spline = сплайн
panel-along-taught = обученный
panel-along-rapid = быстрый ход
panel-along-cubic = кубический

# Columns.
panel-column-n = Кадр
panel-column-time = Время
panel-column-speed = Скорость

# Signals of a record.
panel-trace-welded = Сварено
panel-trace-tip-s = Место острия
panel-trace-path-error = Отклонение от траектории
panel-trace-attitude-error = Ошибка ориентации
panel-trace-process-state = Состояние процесса
panel-trace-burning = Дуга или луч включены
panel-trace-steady = Равномерное движение
panel-trace-power = Питание приводов
panel-trace-inputs = Входы (биты)
panel-trace-true = Истинное место
panel-trace-deviation = Отклонение стыка
panel-trace-correction = Коррекция
panel-trace-miss = Отклонение от стыка
panel-trace-rows = На графике { $shown } из { $samples } отсчётов; пики сохранены.
panel-trace-move = Стрелки двигают курсор.

# Results.
panel-result-good = хорошо
panel-result-deviating = вне допуска
panel-result-stopped = остановлено
panel-result-interrupted = прервано
panel-result-running = идёт

# Set-up.
panel-setup-machine = Станок
panel-setup-devices = Входы и выходы
panel-setup-tuning = Настройка приводов
panel-setup-alarms = Перечень тревог
panel-setup-users = Пользователи
panel-setup-audit = Журнал действий
panel-setup-backup = Резервная копия
panel-setup-data = Резервная копия
panel-setup-timing = Время и устройства
panel-setup-period = Цикл
panel-setup-missed = Пропущено циклов
panel-setup-lost = Не записано циклов
panel-setup-age = Возраст данных
panel-setup-status-age = Возраст состояния
panel-setup-answers = Время ответа ({ $devices }): медиана / макс.
panel-setup-station = Станция
panel-setup-sensors = Датчики
panel-setup-parameters = Оси и приводы
panel-setup-tool = Инструмент
panel-setup-frames = Системы координат
panel-setup-pages = Страницы наладки
panel-setup-diagnostics = Диагностика

# Backup.
panel-data-backup-how = Все сварки, задания, пользователи и журналы одним файлом. Ключей шифрованных соединений в нём нет.
panel-data-restore = Восстановление
panel-data-restore-how = Заменяет все данные резервной копией. Сначала файл проверяется; до подтверждения ничего не меняется. Нынешние данные остаются в папке рядом.
panel-data-off = Сначала выключите станок.
panel-data-file = Файл копии (.tar)
panel-data-check = Отправить и проверить
panel-data-checks = Отправка и проверка …
panel-data-whole = Копия цела:
panel-data-welds = Сварки
panel-data-newest = Последняя сварка
panel-data-jobs = Задания
panel-data-users = Пользователи
panel-data-audit = Записи журнала действий
panel-data-replace = Заменить все данные
panel-data-sure = Все данные этой ячейки заменяются копией. Панель перезапустится, и всем придётся войти под пользователями из копии.
panel-data-begins = Панель перезапускается с восстановленными данными. Войдите снова через несколько секунд.

# Inputs and outputs.
panel-io-signal = Сигнал
panel-io-kind = Вид
panel-io-safe = Безопасное
panel-io-place = Регистр
panel-io-unit = устройство
panel-io-watchdog = выходы безопасны через { $time } с
panel-io-polls = Опросов
panel-io-missed = пропущено
panel-io-failed = неудачных
panel-io-connections = Соединений
panel-io-away = Без связи
panel-io-round = Опрос: медиана / 99,9 % / макс.
panel-io-trouble = Последний сбой:
panel-io-wants = должно быть { $state }

# Io name.
panel-io-name-gas = Газовый клапан
panel-io-name-on = Дуга или луч включены
panel-io-name-watchdog = Признак жизни ячейки
panel-io-name-ready = Источник готов
panel-io-name-burning = Дуга или луч включены
panel-io-name-stuck = Проволока или электрод прилипли
panel-io-name-fault = Ошибка источника (код; 0 — нет)
panel-io-name-heartbeat = Признак жизни устройства

# Io kind.
panel-io-kind-input = вход
panel-io-kind-output = выход
panel-io-kind-set = заданное значение
panel-io-kind-report = сообщение
panel-io-kind-actual = фактическое значение

# Tuning.
panel-tune-go = Настроить и измерить
panel-tune-waits = Измерение …
panel-tune-how = Контур положения на приводе в симуляции; ничего не движется и не меняется.
panel-tune-assumed = Файл станка не описывает привода: настроен предполагаемый.
panel-tune-gain = Усиление разомкнутого контура
panel-tune-phase = Фаза разомкнутого контура
panel-tune-gain-margin = Запас по усилению
panel-tune-phase-margin = Запас по фазе
panel-tune-take = Принять эти настройки

# Audit log.
panel-audit-command = Команда
panel-audit-values = Значения
panel-audit-newest = Новейшие записи: { $n }; есть и более старые.
panel-audit-whole = { $n } { $n ->
    [one] запись
    [few] записи
   *[many] записей
 }
panel-audit-none = Ни в одной записи нет этого текста.
panel-audit-older = Показать более старые
panel-audit-english = Поиск охватывает коды, имена и значения записей.

# Axes.
panel-axis-current = Ток
panel-axis-range = Пределы
panel-axis-max-speed = Макс. скорость
panel-axis-fault = неисправность
panel-axis-limit = концевой выключатель
panel-axis-referenced = ноль известен
panel-axis-home = Ось { $axis } в исходное
panel-axis-home-how = Перемещает одну ось в исходное. Поиск нулей – для всех осей.

# Condition.
panel-condition-for = Нужно для
panel-condition-met = выполнено
panel-condition-unmet = не выполнено

# Level.
panel-level-power = питания
panel-level-motion = движения
panel-level-process = процесса

# Users.
panel-user-role = Роль
panel-user-enabled = Может входить
panel-user-password = Новый пароль (от 10 знаков)
panel-user-own-password = Ваш собственный пароль
panel-user-first-run = Пароля ещё нет. Создайте учётную запись администратора.
panel-user-deleted = Удалено: { $user }.
panel-user-saved = Сохранено: { $user }.
panel-user-password-again = Новый пароль ещё раз
panel-user-password-differs = Пароли различаются.
panel-user-new = Новый пользователь
panel-user-edits = Изменить пользователя { $user }
panel-user-exists = Пользователь { $user } уже есть.
panel-user-over = Изменить его? Роль: { $role }, вход разрешён: { $enabled }. Пароль остаётся.
panel-user-over-password = Изменить его? Роль: { $role }, вход разрешён: { $enabled }. Пароль станет новым.
panel-user-change = Изменить

# Parameters.
panel-par-how = Значения файла станка. Они проверяются вместе и сохраняются в { $file }; старый файл остаётся рядом. Серым – значение по умолчанию.
panel-par-pending = Сохранено, вступит в силу после перезагрузки: выключите приводы и загрузите задание заново.
panel-par-reload = Загрузить задание заново
panel-par-keep = Сохранить
panel-par-kept = Сохранено в { $file }
panel-par-wild = Большое изменение – подтвердите:
panel-par-wrong = Не число: { $value }
panel-par-no-drive = Файл станка не описывает привода этой оси.
panel-par-notches = Режекторные фильтры
panel-par-notch = { $frequency } Гц, ширина { $width } Гц, усиление { $gain }
panel-par-group-axis = Ось
panel-par-group-loop = Контур положения и привод
panel-par-group-feedforward = Компенсация
panel-par-group-mechanics = Механика и масштаб
panel-par-group-pose = Где стоит
panel-par-group-map = Пиксели в мм
panel-par-group-timing = Время и шум
panel-par-home = Исходное положение
panel-par-max-speed = Макс. скорость
panel-par-max-acceleration = Макс. ускорение
panel-par-max-jerk = Макс. рывок
panel-par-velocity-bandwidth = Полоса контура скорости
panel-par-kp = Пропорциональный коэффициент (kp)
panel-par-ki = Интегральный коэффициент (ki)
panel-par-kd = Дифференциальный коэффициент (kd)
panel-par-kvff = Упреждение по скорости
panel-par-kaff = Упреждение по ускорению
panel-par-limit = Предел силы или момента
panel-par-current-time-constant = Постоянная времени контура тока
panel-par-current-delay = Запаздывание тока
panel-par-friction-compensation = Компенсация трения
panel-par-friction-smoothing = … скорость сглаживания
panel-par-backlash-compensation = Компенсация люфта
panel-par-backlash-time = … время компенсации
panel-par-encoder-counts = Импульсов энкодера на единицу
panel-par-inertia = Движимая масса или инерция
panel-par-peak = Пиковая сила или момент
panel-par-friction = Трение
panel-par-viscous = Вязкое трение
panel-par-resonance = Резонанс
panel-par-load-ratio = Инерция нагрузки / двигателя
panel-par-bandwidth = Полоса контура положения
panel-par-measured-at = Измерено при
panel-par-following-counts = Рассогласование, импульсов
panel-par-load-error = Ошибка на нагрузке
panel-par-notch-at = Режекторный фильтр на

# TCP calibration.
panel-tool-title = Найти остриё касанием одной точки
panel-tool-how = Закрепите остриё-указатель. Коснитесь его и запишите; наклоните или поверните горелку и коснитесь снова: не менее { $n } направлений, через 20°.
panel-tool-head = Головка
panel-tool-record = Записать касание
panel-tool-jog = Касания записываются в ручном режиме или обучении.
panel-tool-touch = Касание { $touch }
panel-tool-remove = Удалить касание { $touch }
panel-tool-find = Вычислить TCP
panel-tool-was = Текущая TCP
panel-tool-found = Найденная TCP
panel-tool-deviation = Стандартное отклонение
panel-tool-rms = Отход касаний от точки (СКЗ)
panel-tool-apart = Разница наклонов
panel-tool-keep = Сохранить эту TCP
panel-tool-verdict-good = Касания согласуются, остриё определено во всех направлениях.
panel-tool-verdict-unseen = Касания согласуются, но определяют остриё не во всех направлениях.
panel-tool-verdict-far = Остриё сместилось бы больше чем на 20 мм: всегда ли это была та же точка?
panel-tool-verdict-poor = Касания расходятся больше чем на 0.5 мм: повторите.
panel-tool-unseen = Не определено вдоль ({ $direction }): там остаётся, как было.
panel-tool-old = Назад к текущей TCP

# Sensors.
panel-sensor-none = У станка нет датчиков.
panel-sensor-title = Калибровка камеры по сетке
panel-sensor-how = Положите пластину с сеткой тёмных точек прямо перед камерой на известной высоте: она должна занимать половину кадра или больше.
panel-sensor-pitch = Шаг точек, мм
panel-sensor-z = Высота пластины (z), мм
panel-sensor-file = Снимок сетки
panel-sensor-simulated = Снимок из симуляции
panel-sensor-find = Калибровать
panel-sensor-picture = Снимок с найденными точками
panel-sensor-residuals = Сетка: калибровка. Красные линии: отход каждой точки, ×{ $factor }.
panel-sensor-dots = Точки
panel-sensor-off = Отход точек (СКЗ / макс.)
panel-sensor-was = Текущая
panel-sensor-found = Найдено
panel-sensor-scale = Масштаб x / y, мм на пиксель
panel-sensor-rotation = Поворот
panel-sensor-shear = Скос осей
panel-sensor-barrel = Дисторсия (отрицательная: бочка)
panel-sensor-centre = Оптическая ось (столбец, строка)
panel-sensor-middle = середина
panel-sensor-aligned = Пластина лежит вдоль осей датчика: её поворот есть поворот камеры
panel-sensor-in-place = Вместо плоскости z = { $z } мм
panel-sensor-new = Как новую плоскость z = { $z } мм
panel-sensor-keep = Взять калибровку
panel-sensor-planes = Плоскости камеры
panel-sensor-remove = Удалить плоскость z = { $z } мм
panel-sensor-verdict-good = Снимок соответствует сетке.
panel-sensor-move = Место на звене x, y, z
panel-sensor-turn = Поворот вокруг направления x, y, z
panel-sensor-angle = … на угол
panel-sensor-distance = Камера от начала отсчёта
panel-sensor-laser-angle = Ось камеры к плоскости лазера
panel-sensor-focal = Фокусное расстояние
panel-sensor-homography = Гомография h1 … h8
panel-sensor-origin = Начало отсчёта (столбец, строка)
panel-sensor-period = От кадра до кадра
panel-sensor-latency = От снимка до результата
panel-sensor-noise = Шум положения стыка

# Paused dry run.
panel-pause-jog = Двигать отсюда вручную
panel-pause-where = Холостой прогон приостановлен в проходе { $pass } на { $s } мм. Двигайте вручную и записывайте; потом нажмите «Спланировать возврат» и «Холостой прогон».
panel-pause-begin = Холостой прогон приостановлен перед первым проходом. Двигайте вручную и записывайте; потом нажмите «Спланировать возврат» и «Холостой прогон».
panel-pause-back = Спланировать возврат
panel-pause-forget = Отменить холостой прогон

# Tour.
panel-tour-title = Ваша первая сварка
panel-tour-close = Пропустить
panel-tour-control = Нажмите «Взять управление» (вверху справа): управляет только одна панель.
panel-tour-on = Нажмите «Включить»: приводы получат питание.
panel-tour-home = Нажмите «В ноль»: оси найдут свои нули.
panel-tour-load = Откройте «Задания» и загрузите «Первый шов». Программа будет спланирована и проверена; ничто не движется.
panel-tour-again = Оси переместились. Нажмите «Перепланировать отсюда»: подход начнётся оттуда, где они есть.
panel-tour-dry = Холостой прогон: тот же путь без дуги. Дождитесь конца; STOP внизу справа останавливает сразу.
panel-tour-jog = Ручное движение. Когда оси там, где нужно, нажмите «Закончить ручное движение».
panel-tour-fault = Авария. Тревоги внизу говорят, что делать: подтвердите их и нажмите «Сбросить аварию».
panel-tour-arm = Нажмите «Разрешить»: это допуск одного пуска в течение минуты. «Почему нельзя начать?» скажет, чего не хватает.
panel-tour-weld = Нажмите «Начать сварку». STOP всегда внизу справа.
panel-tour-watch = Следите за горелкой. Попробуйте «Пауза» и «Дальше» (перед этим снова «Разрешить») и виды 3D.
panel-tour-hold = Пауза, дуга выключена. Снова нажмите «Разрешить», затем «Дальше».
panel-tour-left = Сварка остановлена. Нажмите слева «Продолжить проход …»: дальше оттуда, с перекрытием.
panel-tour-record = Готово. Откройте «Записи»: там хранится каждая сварка.
panel-tour-end = Готово. Дальше: Задания > Новое из образца.

# Kinds of refusals.
panel-trouble-login = Войдите снова
panel-trouble-password = Отклонено
panel-trouble-role = Ваша роль этого не позволяет
panel-trouble-origin = Адрес страницы не разрешён
panel-trouble-token = Сеанс недействителен: обновите страницу
panel-trouble-size = Слишком велико
panel-trouble-input = Неверные данные
panel-trouble-not-found = Не найдено
panel-trouble-busy = Не сейчас
panel-trouble-other = Там другой текст
panel-trouble-exists = Уже есть
panel-trouble-slow-down = Слишком много запросов: подождите
panel-trouble-server = Ошибка сервера
panel-trouble-lost = Нет связи с ячейкой
panel-trouble-archive = Это не полная резервная копия Seamwright
panel-trouble-archive-newer = Копия сделана более новой версией Seamwright
panel-trouble-archive-room = На диске нет места

# Allowed values.
panel-allowed-not-negative = число, 0 или больше
panel-allowed-positive = число больше 0
panel-allowed-up-to = больше 0, до { $max }

# Actions that roles allow.
panel-action-take-control = взять управление
panel-action-watch = смотреть
panel-action-jobs-read = читать задания
panel-action-jobs-write = изменять задания
panel-action-plan = планировать
panel-action-edit = редактировать
panel-action-post = создавать управляющие программы
panel-action-load = загружать
panel-action-records-read = читать записи
panel-action-tune = настраивать приводы
panel-action-set-up = налаживать
panel-action-shelve = откладывать тревоги
panel-action-audit = журнал действий
panel-action-audit-read = читать журнал действий
panel-action-backup = скачивать копии
panel-action-restore = восстанавливать
panel-action-users-read = просматривать пользователей
panel-action-users-write = изменять пользователей
panel-action-diagnose = смотреть диагностику
panel-action-jog = двигать вручную
panel-action-teach = обучать

# Diagnostics.
panel-diag-state = Состояние
panel-diag-ready = Ячейка готова к работе.
panel-diag-version = Версия
panel-diag-uptime = Работает (мин:с)
panel-diag-latency = Опоздание циклов
panel-diag-latency-how = Циклы с запуска сервера по опозданию их начала. Высоты логарифмические.
panel-diag-most = Максимум
panel-diag-gap = Наибольший пропуск
panel-diag-cycles = Циклы
panel-diag-rights = Права реального времени
panel-diag-granted = есть
panel-diag-missing = отсутствует
panel-diag-right-priority = Приоритет реального времени
panel-diag-right-memory = Закреплённая память
panel-diag-right-cpu = Отдельный процессор
panel-diag-grant-priority = Приоритет: задайте LimitRTPRIO=80 в службе или rtprio 80 в /etc/security/limits.conf и запустите снова.
panel-diag-grant-memory = Память: задайте LimitMEMLOCK=infinity в службе или memlock unlimited в /etc/security/limits.conf и запустите снова.
panel-diag-grant-cpu = Процессор: выберите существующий и разрешённый и запустите снова.
panel-diag-devices = Возраст сообщений устройств
panel-diag-devices-how = Подробнее об устройствах: «Входы и выходы».
panel-diag-device-latency = задержка
panel-diag-disk = Диск и память
panel-diag-free = Свободно / всего
panel-diag-write = Короткая запись
panel-diag-look = Проверено назад
panel-diag-resident = Память панели
panel-diag-cell-resident = Память ячейки
panel-diag-locked = из неё закреплено
panel-diag-queues = Очереди
panel-diag-waiting = Ждут
panel-diag-room = Мест
panel-diag-queue-cycles = Циклы
panel-diag-queue-notes = События
panel-diag-queue-commands = Команды
panel-diag-queue-audit = Журнал действий
panel-diag-alarms = Тревоги по приоритету
panel-diag-priority = Приоритет
panel-diag-active = Активны
panel-diag-unacknowledged = Не подтверждены
panel-priority-critical = критический
panel-priority-high = высокий
panel-priority-medium = средний
panel-priority-low = низкий
panel-diag-workers = Процессы планирования
panel-diag-runs = работает
panel-question-draft = Эскиз
panel-question-plan = План
panel-question-recorded = План записи
panel-question-report = Отчёт
panel-question-post = Управляющая программа
panel-question-load = Загрузка
panel-question-place = Привязка детали
panel-question-reach = Поиск лучшего места
panel-question-schedule = Серия
panel-worker-answered = С ответом
panel-worker-refused = Ошибки в задании
panel-worker-superseded = Прерваны новым запросом
panel-worker-late = Остановлены: слишком долго
panel-worker-memory = Остановлены: много памяти
panel-worker-failed = С ошибкой программы
panel-diag-since = С запуска сервера
panel-diag-welds = Сварки
panel-diag-clients = Соединения / страницы / сеансы
panel-diag-logins = Входы / отказано
panel-diag-answers = Ответы по статусу HTTP
