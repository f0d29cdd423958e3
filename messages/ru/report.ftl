# Numbered parts of a page, results and findings.
report-table = Таблица { $number }.
report-figure = Рис. { $number }.
report-in-order = Соответствует
report-not-in-order = Не соответствует
report-severity-note = Примечание
report-severity-warning = Предупреждение
report-severity-error = Ошибка
report-finding-place = Где: { $place }
report-finding-cure = Что сделать: { $cure }
report-no-findings = Замечаний нет.
report-heading-notes = Примечания
report-heading-findings = Замечания
report-more-places = ещё мест: { $n }

# Places, ranges and pairs of values.
report-range = { $from } … { $to }
report-at = s = { $s }
report-at-range = s = { $from } … { $to }
report-pass-at = проход { $pass }, { $place }
report-passes-at = проходы { $first }–{ $last }, { $place }
report-pair = { $first } и { $second }
report-pass-named = проход { $pass }: { $name }
report-curve-of-head = { $curve }, головка { $head }
report-part-of = { $value } из { $whole }
report-more-than = более { $value }

# Charts.
report-no-data = нет данных
report-limit-above = { $limit }, выше
report-limit-below = { $limit }, ниже
report-limit-outside = { $limit }, вне рисунка
report-limit = предел
report-limit-at-least = не менее
report-limit-at-most = не более
report-limit-min = наименьшая
report-limit-max = наибольшая
report-label-path-length = длина пути s
report-label-distance = расстояние
report-label-angle = угол
report-label-heat-input = тепловложение
report-label-speed = скорость
report-label-acceleration = ускорение
report-label-jerk = рывок
report-label-position = положение
report-label-curvature = кривизна
report-label-deviation = отклонение
report-label-path-error = отклонение от пути
report-label-following-error = рассогласование
report-label-attitude-error = погрешность наклона
report-label-along-seam = вдоль шва
report-label-across = поперёк
report-label-torch-tip = остриё горелки

# Names of views.
report-view-front = Спереди
report-view-side = Сбоку, слева
report-view-top = Сверху
report-view-pictorial = Наглядно, не в масштабе
report-seen-from-above = вид сверху
report-seen-from-below = вид снизу
report-seen-from-plus-x = вид с +x
report-seen-from-minus-x = вид с -x
report-seen-from-plus-y = вид с +y
report-seen-from-minus-y = вид с -y

# Columns of tables.
report-column-value = Величина
report-column-min = Наименьшее
report-column-mean = Среднее
report-column-max = Наибольшее
report-column-allowed = Допустимо
report-column-outside-s = Вне, с
report-column-outside-mm = Вне, мм
report-column-pass = Проход
report-column-name = Фамилия
report-column-date = Дата
report-column-signature = Подпись
report-column-alarm = Тревога
report-column-priority = Приоритет
report-column-cause = Причина
report-column-position-mm = s, мм
report-column-time-s = t, с
report-column-first-out = Первая
report-column-acknowledged = Подтверждено
report-column-time = Время
report-column-event = Событие
report-column-text = Текст
report-column-version = Версия
report-column-file = Файл
report-column-rows = Строки
report-column-bytes = Байты
report-column-transfer-before-s = Холостой ход перед этим, с
report-column-start-s = Начало, с
report-column-travel-s = Ход, с
report-column-arc-on-s = Дуга горит, с
report-column-total-s = Всего, с
report-column-speed-mm-s = Скорость, мм/с
report-column-stick-out = Вылет, мм
report-column-arc-energy = Погонная энергия дуги, кДж/мм
report-column-heat-input = Тепловложение, кДж/мм
report-column-length-mm = Длина, мм
report-column-wire-m = Проволока, м
report-column-bead = Валик на сечении
report-column-toe-deg = Угол перехода, °
report-column-weld-metal-kg = Наплавлено, кг
report-column-wait-before-s = Ожидание перед, с
report-column-group = Группа (ISO/TR 15608)
report-column-thickness = Толщина, мм
report-column-ce = CE (IIW), %
report-column-cet = CET, %
report-column-pcm = Pcm, %
report-column-preheat = Подогрев по EN 1011-2, °C
report-column-work = Деталь перед проходом, °C
report-column-t85 = t8/5, с
report-column-heat-flow = Теплоотвод
report-column-at-requested-speed = С заданной скоростью, %
report-column-attitude-error = Погрешность наклона, °
report-column-clearance = Наименьшее расстояние, мм
report-column-between = между
report-column-path-error-mm = Отклонение от пути, мм
report-column-rms-mm = СКЗ, мм
report-column-rms = СКЗ
report-column-speed-ripple = Неравномерность скорости, %
report-column-position = Положение
report-column-from = От
report-column-to = До
report-column-slope = Наклон
report-column-rotation = Поворот
report-column-section = Участок
report-column-min-speed = Наименьшая скорость
report-column-max-speed = Наибольшая скорость
report-column-binding = Что ограничивает
report-column-head = Головка
report-column-untracked = без слежения, 99 % (мм)
report-column-tracked = со слежением, 99 % (мм)
report-column-correction-used = от разрешённой коррекции
report-column-stopped-at = остановлено на (мм)
report-column-corrected-by = исправлено по
report-column-deflected = отклонён до (мм)
report-column-gun-carried = пушка сдвинута до (мм)
report-column-away = вне шва (% времени)
report-column-longest = дольше всего (мс)
report-column-stored-within = девять из десяти точек от сохранённых отклонений (мм)
report-column-peak-load = Пиковая нагрузка, %
report-column-axis = Ось
report-column-unit = Единица
report-column-range = Диапазон
report-column-of = от
report-column-speed-used = Скорость, %
report-column-acceleration-used = Ускорение, %
report-column-jerk-used = Рывок, %
report-column-tip-mm = Остриё, мм
report-column-linear-axis = Линейная ось
report-column-rotary-axis = Поворотная ось
report-column-tip-speed = Скорость острия
report-column-process-value = Параметр процесса

# Title blocks of pages.
report-subtitle-plan = Отчёт о шве: план
report-subtitle-simulation = Отчёт о шве: план и симуляция
report-subtitle-record = Протокол сварки { $id }
report-subtitle-record-simulated = Протокол сварки { $id }, симуляция: металл не сваривали
report-meta-part = Деталь
report-meta-welder = Сварщик
report-meta-machine = Станок
report-meta-procedure = Технология
report-meta-started = Начало
report-meta-ended = Конец
report-not-yet = ещё нет
report-none = нет
report-meta-page-made = Страница составлена
report-meta-made-by = Составлено программой

# Headings.
report-heading-values = Технология и фактические значения
report-heading-deviations = Отклонения от шва
report-heading-alarms = Тревоги
report-heading-events = События
report-heading-record = Запись
report-heading-procedure = Технология
report-heading-program = Программа
report-heading-signatures = Подписи
report-heading-errors = Ошибки
report-heading-map = Схема сварки и график
report-heading-process = Процесс вдоль шва
report-heading-materials = Материалы, подогрев и остывание
report-heading-cut = Рез трубы
report-heading-source = Текст задания
report-heading-passes = Проходы
report-heading-checks = Проверки
report-heading-curves = Приложение: кривые
report-heading-seam = Шов и горелка
report-heading-joint = Стык
report-heading-taught = Обученные участки
report-heading-tracking = Слежение
report-heading-simulated = Симуляция сварки
report-heading-axes = Оси
report-heading-programs = Программы ЧПУ
report-heading-job = Начало и конец проходов
report-heading-released = Утверждено
report-heading-pass-curves = Проход { $pass } ({ $name }): кривые

# Record of a weld: result.
report-result-good = Сварено до конца, в пределах допуска.
report-result-deviating = Сварено до конца, но не всё так, как задано.
report-result-stopped = Остановлено, не сварено до конца.
report-result-interrupted = Прервано: сбой программы или питания.
report-result-running = Не закончено: сварка идёт, или произошёл сбой программы.
report-windows-without-procedure = Технологии (WPS) для сравнения нет.
report-windows-within = Все значения в пределах технологии.
report-windows-outside = Вне пределов технологии: { $values }.
report-value-outside-at = { $value } в проходе { $pass }, s = { $from } – { $to }
report-value-outside = { $value } в проходе { $pass }
report-record-note = Примечание: { $note }.
report-tile-arc-on = Время горения дуги
report-tile-deviation = Отклонение
report-tile-mean = средняя; { $from } … { $to }
report-tile-max-at = наибольшее, на s = { $s }

# Record of a weld: tables.
report-caption-by-hand = Заполняют от руки
report-inspector = Контролёр
report-welding-engineer = Инженер-сварщик
report-caption-actual-values = Фактические значения при движении по проходу, без остановок, начал и окончаний, в сравнении с пределами технологии
report-no-values = Значений не записано.
report-not-limited = не ограничено
report-outside = вне нормы
report-within = норма
report-allowed = разрешено
report-no-alarms = Тревог нет.
report-caption-alarms = Тревоги в порядке появления
report-first-out = первая
report-no = нет
report-caption-events = События в порядке появления
report-caption-sources = Тексты, по которым сварено; они в библиотеке; SHA-256 программы { $sha256 }
report-caption-files = Файлы записи

# Record of a weld: charts.
report-heat-input-unknown = Неизвестно: без технологии (WPS) мощность не определена.
report-chart-heat-input = Тепловложение вдоль шва
report-caption-heat-input-bins = Энергия на путь острия горелки, на каждых { $bin }.
report-chart-tip-off-path = Отклонение острия горелки от запланированного пути
report-caption-tip-off-path = Расстояние истинного острия горелки от шва по нормали к нему, на каждых { $bin } наибольшее.
report-chart-weld-off-joint = Отклонение шва от стыка
report-caption-weld-off-joint = Отклонение шва от стыка вбок и по высоте, наибольшее на каждых { $bin }.
report-curves-shown = Показано кривых: { $shown } из { $all }; в записи есть все.

# Plan: checks and verdict.
report-no-findings-plan = Нет: шов можно сварить на этом станке, как задано.
report-checked = Проверено: досягаемость, диапазоны, скорости, ускорения и рывки осей; что ось горелки не заходит ни в одну из поверхностей; расстояния между собой: { $objects }, вдоль проходов и в холостых ходах, насколько файлы дают их формы. Не проверено: объекты, которых нет в этом перечне, детали за пределами длин, которые даёт им задание, кабели и шланги.
report-checked-without-shapes = Проверено: досягаемость, диапазоны, скорости, ускорения и рывки осей, а также что ось горелки не заходит ни в одну из поверхностей. Столкновения не проверены: в файле станка нет форм.
report-verdict-planned = Запланировано: все оси в пределах, заданная скорость от разгона до торможения.
report-verdict-planned-slowed = Запланировано: все оси в пределах, замедлено до { $speed } там, где этого требует ось.
report-verdict-within = В пределах { $procedure }.
report-verdict-outside = Вне { $procedure }, замечаний: { $n }.
report-verdict-findings = Замечания: исправить { $errors }, рассмотреть { $warnings }.
report-verdict-simulated = Симуляция: отклонение от пути не более { $error } при допустимых { $allowed }, отклонение скорости не более { $ripple } при допустимых { $ripple_allowed }.
report-verdict-simulated-short = Симуляция: отклонение от пути не более { $error } при допустимых { $allowed }, слишком короткий, чтобы судить о скорости.

# Plan: key figures.
report-tile-weld-length = Длина сварки
report-seam-length = шов { $length }
report-length-of-passes = { $of }; проходов: { $n }, всего { $length }
report-through-points = через точки
report-tile-weld-time = Время сварки
report-travel = ход от покоя до покоя
report-travel-of-passes = ход всех проходов ({ $n }) от покоя до покоя
report-tile-path-error = Отклонение от пути, симуляция
report-path-error-rms = наибольшее; СКЗ { $rms }
report-tile-speed-ripple = Неравномерность скорости, симуляция
report-speed-range = { $from } … { $to }, СКЗ { $rms }
report-too-short = шов слишком короткий, чтобы судить
report-tile-attitude-error = Погрешность наклона
report-attitude-error-of-plan = наибольшая, по плану
report-tile-arc-energy = Погонная энергия дуги
report-arc-energy-range = наибольшая; наименьшая { $min }; U I / v
report-tile-wire = Проволока
report-wire-length = { $length } за время дуги
report-tile-weld-metal = Металл шва
report-tile-gas = Газ
report-gas-time = от предварительной до конечной подачи
report-tile-flux = Флюс
report-tile-energy = Энергия дуги
report-mains = { $energy } из сети
report-tile-heat-input = Погонная энергия
report-heat-input-range = наибольшая; наименьшая { $min }
report-tile-total = Общее время
report-total-parts = от исходной до исходной; холостые ходы { $transfer }
report-total-parts-waiting = от исходной до исходной; холостые ходы { $transfer }, ожидание { $wait }
report-duty = { $part } общего времени; ПВ { $duty } за 10 минут
report-tile-cost = Стоимость
report-cost-labour = труд
report-cost-machine = станок
report-cost-wire = проволока
report-cost-gas = газ
report-cost-flux = флюс
report-cost-energy = энергия
report-cost-incomplete = неполная: неизвестно количество
report-wire-with-arc = пока горит дуга

# Plan: order of welding.
report-caption-order = Проходы пронумерованы в порядке сварки. Штрихом: холостые ходы, прямо от конца к началу.
report-chart-order = Порядок сварки, проходов: { $n }, { $view }
report-order-key = Точка: начало. Стрелка: направление сварки. Штрих: холостые ходы, прямо.
report-order-key-tacks = Оранжевые, номера снаружи: прихватки.
report-order-lines = { $title }: линий по порядку: { $n }
report-caption-map = Схема сварки: развёрнутый шов, строка на каждый валик в порядке сварки.
report-chart-map = Схема сварки на развёрнутом шве
report-map-key = Точка: начало. Черта: конец. Стрелка: направление сварки. Номера: проходы.
report-map-copies = Первый из швов, всего { $n }.
report-map-label = { $title }: строк { $n }, { $length }
report-caption-order-table = График: проходы в порядке сварки
report-all-from-home = всё, от исходного положения до него же

# Plan: passes.
report-caption-passes = Значения каждого прохода по плану
report-all-passes = все проходы
report-caption-checks = Проверки каждого прохода
report-caption-materials = Основные материалы и металл шва с углеродными эквивалентами: CE по IIW, CET по EN 1011-2, Pcm по Ито и Бессё.
report-materials-decisive = Для подогрева: CET { $cet } и { $hydrogen } мл водорода на 100 г.
report-caption-heat = Подогрев по методу B и время остывания с 800 до 500 °C по EN 1011-2 для { $thickness }: от наименьшей погонной энергии на самой холодной детали до наибольшей на самой горячей.
report-no-preheat = нет
report-weld-metal = металл шва
report-material-group = группа { $group }
report-caption-simulated-passes = Результаты каждого прохода в симуляции
report-about-curves = Кривые по одному проходу каждого вида: с ошибкой, иначе самому длинному. `plan --plots` записывает кривые всех проходов.

# Plan: seam, torch and process.
report-caption-seam = Шов с заданной осью горелки, в системе координат задания, проекция по методу первого угла.
report-curve-bead = валик
report-curve-seam = шов
report-curve-path = путь
report-curve-torch-axis = ось горелки
report-mark-start = начало
report-mark-end = конец
report-mark-end-of-overlap = конец перекрытия
report-chart-torch-angles = Углы горелки и разделка
report-curve-work-angle = поперечный угол (от биссектрисы)
report-curve-travel-angle = продольный угол (+ углом назад, − углом вперёд)
report-curve-half-dihedral = половина двугранного угла
report-caption-torch-angles = Поперечный угол от биссектрисы поверхностей (положительный к первой детали), продольный угол и половина угла между поверхностями.
report-chart-process-values = Заданные параметры процесса
report-caption-process-values = Параметры процесса вдоль прохода там, где они меняются; без нарастания и спада на концах.
report-chart-weave = Путь острия с колебаниями на первых { $length }
report-curve-tip = остриё
report-curve-beam = луч
report-first-part = первая деталь
report-second-part = вторая деталь
report-caption-weave = Заданный путь с колебаниями, вид вдоль горелки, шов выпрямлен, масштаб вдоль и поперёк одинаков; горелка движется вправо.
report-chart-oscillation = Путь луча на детали за периоды ({ $n }): { $advance } за период при { $speed }
report-caption-oscillation = Путь отклонённого луча на детали, масштаб вдоль и поперёк одинаков; oscillation.csv содержит один период отклонения.
report-caption-cut = Развёртка отрезанного конца трубы; cut.svg показывает её в натуральную величину, вид снаружи, чтобы обернуть трубу, а cut.csv содержит её точки.
report-chart-cut = Шаблон реза
report-cut-outside = снаружи: радиус { $radius }, обвод { $around }, рез { $from } … { $to } вдоль оси, край на { $edge }
report-cut-inside = внутри: радиус { $radius }, обвод { $around }, рез { $from } … { $to } вдоль оси, край на { $edge }
report-sections = { $title }: сечений: { $n }
report-section-note = угол { $dihedral }, площадь { $area }
report-section-toes = , углы перехода { $second } и { $first }
report-area-with-cap = { $groove } + { $cap }
report-section-torch = горелка: поперечный угол { $work }, продольный угол { $travel }
report-caption-sections = Сечения вдоль шва в одном масштабе, поверхность второй детали горизонтальна или лицевая поверхность стыкового шва вверх: валики в порядке сварки и куда в каждом указывает проволока; площадь: разделки и усиления над ней.

# Plan: welding procedure.
report-caption-heat-input = Тепловложение при запланированной скорости между разгоном и торможением, с его пределами; затенено там, где оно вне их.
report-caption-positions = Положение сварки (ISO 6947) по наклону хода и повороту лицевой поверхности шва, как оси станка поворачивают деталь.
report-too-high = слишком велика
report-too-low = слишком мала
report-chart-positions = Положение сварки
report-curve-slope = наклон (+ вверх)
report-curve-rotation = поворот лицевой поверхности (0 вверх, 180 вниз)
report-run = проход технологии { $run }
report-no-run = ни один её проход не относится к этому
report-procedure = { $number } ({ $title }), { $run }. Процесс { $process }: { $process_name }. Тепловложение: { $efficiency } × мощность / запланированная скорость. Положения как для { $joint ->
        [fillet] углового
       *[butt] стыкового
    } шва.
report-caption-plan-values-of = План и технология, проход { $passes }
report-unbounded = без предела
report-to-be-measured = нужно измерить
report-unknown-see-findings = неизвестно: см. замечания
report-outside-at = вне нормы: s = { $from } … { $to }
report-outside-pass = вне пределов: проход { $passes }
report-outside-at-more = вне нормы: s = { $from } … { $to } и другие участки: { $n }
report-caption-positions-any = Положения сварки (мм, градусы); технология разрешает любое
report-caption-positions-allowed = Положения сварки (мм, градусы); технология разрешает { $positions }
report-not-allowed = не разрешено

# Plan: taught spans.
report-chart-taught = Обученный участок { $number }
report-caption-taught = Свариваемый и номинальный швы; на обоих сопряжениях совпадают положение, направление и кривизна.
report-taught = обучено
report-chart-off-nominal = Расстояние от номинального шва
report-curve-as-welded = свариваемый шов
report-curve-nominal = номинальный шов
report-curve-taught-points = обученные точки
report-chart-direction-off-nominal = Направление относительно номинального шва
report-chart-curvature = Кривизна
report-chart-tip-speed = Скорость острия горелки
report-curve-planned = по плану
report-shorter = короче
report-longer = длиннее
report-taught-span = Участок { $number }: s = { $from } … { $to } (на { $length } { $change }, чем номинальный шов там), обученных точек: { $n }; до { $distance } от номинального шва и { $angle } от его направления.

# Plan: clearance.
report-caption-clearance = Наименьшее расстояние между горелкой, звеньями, деталью, оснасткой и зонами и его нижняя граница вдоль всего прохода.
report-chart-clearance = Наименьшее расстояние (показано до { $limit })
report-curve-clearance = наименьшее расстояние
report-curve-clearance-bound = доказанная нижняя граница между отсчётами

# Plan: speed.
report-speed-reached = Задано: { $requested }. Достигнуто между разгоном и торможением: { $reached }. Заданная скорость на { $part } длины.
report-caption-speed = Скорость острия вдоль шва относительно детали; затенено там, где она меньше заданной, с пределом, который ограничивает.
report-chart-speed = Скорость острия горелки вдоль шва
report-curve-tip-simulated = истинное остриё, симуляция
report-acceleration-phase = разгон
report-deceleration-phase = торможение
report-section-weld = шов
report-axis = ось { $axis }
report-torch-tip = остриё горелки
report-requested-speed = заданная скорость
report-binding = { $owner }: { $what }, { $limit }
report-no-binding = ничего: скорость как задано
report-caption-binding = Что ограничивает скорость (мм, мм/с)
report-caption-binding-first = Что ограничивает скорость (мм, мм/с): первых участков { $n }, ещё { $more } в report.json
report-caption-deviation = Отклонение скорости в симуляции между разгоном и торможением; в начале у приводов идёт переходный процесс.
report-chart-deviation = Скорость истинного острия относительно запланированной

# Plan: tracking.
report-part-displaced = Деталь лежит не там, где запланировано.
report-tracking-without-alarms = Слежение не подало тревог.
report-welded-as-planned = Сварено, как запланировано.
report-to-be-checked = Проверьте: { $alarms }.
report-alarm-at = { $head } на { $s }: { $alarm }
report-caption-tracking = Истинное положение стыка относительно запланированного пути, отклонение шва от стыка и неопределённость положения стыка.
report-chart-tracking = Стык и шов
report-chart-joint = стык относительно запланированного пути (отклонение шва без слежения)
report-chart-weld = шов относительно стыка
report-chart-correction = коррекция вбок: отклонение луча; штрихом движение пушки осями
report-chart-sigma = неопределённость положения стыка (стандартное отклонение)
report-curve-lateral = вбок
report-curve-height = по высоте
report-curve-deflection = отклонение луча
report-curve-gun = движение пушки осями
report-curve-sigma = сигма
report-not-welded = не сварено
report-not-tracked = без слежения
report-caption-tracked-lateral = Расстояние шва от стыка вбок: у луча нет высоты
report-caption-tracked = Расстояние шва от стыка, вбок и по высоте вместе
report-stored-points = { $value } (точек: { $n })
report-stored-deviations = сохранённые отклонения
report-seen-by-beam = измерение лучом
report-caption-beam = Коррекции луча

# Plan: simulation.
report-simulation = Каждая ось на своём контуре положения с периодом сервопривода, с инерцией, трением, зубцовыми пульсациями, шагами энкодера и пределом тока (зерно { $seed }). Деталь номинальная: без смещения, деформации, погрешностей сборки и искривления проволоки. Неравномерность скорости: наибольшее отклонение скорости острия от запланированной, от полусекунды после разгона до торможения.
report-highest-load = Наиболее нагруженный привод: { $axis }, { $load } пикового.
report-assumed-drives = Файл станка не описывает привода для { $axes }: симуляция берёт предполагаемый.
report-caption-path-error = Расстояние истинного острия от шва по нормали к нему.
report-chart-path-error = Расстояние истинного острия горелки от шва
report-curve-normal-to-seam = по нормали к шву
report-caption-following = Заданное положение минус истинное для каждой оси.
report-chart-following = Рассогласование каждой оси
report-caption-following-table = Рассогласование осей, пока горит дуга
report-caption-attitude = Угол между истинным направлением горелки и заданным.
report-chart-attitude = Отклонение истинного направления горелки от заданного

# Plan: axes.
report-continuous = без пределов
report-caption-axes = Запланированные положение, скорость и ускорение каждой оси и их пределы.
report-caption-jerks = Запланированный рывок каждой оси и его предел.
report-chart-axes = Оси и их пределы
report-chart-jerks = Рывок осей и его пределы
report-caption-ranges = Положения осей и их диапазоны
report-caption-uses = Наибольшее использование пределов каждой оси

# Plan: part programs.
report-program = { $file } для { $dialect }: кадров движения { $n }, прочитано обратно, выполнено по правилам интерполяции и подач системы ЧПУ, проведено через прямую кинематику станка и сравнено с планом; разрешено { $tolerance }.
report-as-in-program = как в программе
report-caption-program = Наибольшие отклонения { $file }

# Plan: job data.
report-caption-job = Время и значения до и после движения
report-row-seam = Шов
report-row-seam-length = Длина шва
report-row-acceleration-phase = Разгон
report-row-deceleration-phase = Торможение
report-row-start-angle = Начальный угол
report-row-direction = Направление сварки
report-row-dihedral = Двугранный угол
report-row-preparation = Подготовка кромок
report-counter-clockwise = против часовой стрелки
report-clockwise = по часовой стрелке
report-row-overlap = Перекрытие
report-row-preflow = Газ до дуги
report-row-travel-delay = Дуга до начала хода
report-row-upslope = Нарастание от: { $value }
report-row-upslope-time = Нарастание: время
report-row-downslope = Спад до: { $value }
report-row-downslope-time = Спад: время
report-row-crater = Заварка кратера
report-row-postflow = Газ после дуги

# Check of a machine: page.
report-check-subtitle = Проверка файла станка
report-check-made-by = Seamwright { $version }, зерно { $seed }
report-check-heading-failed = Непройденные проверки
report-check-remarks = Замечания
report-check-heading-kinematics = Кинематика
report-check-singular = Особые положения
report-check-heading-reach = Досягаемость
report-check-heading-file = Файл станка
report-check-remark-count = замечаний: { $n }
report-check-passed = Каждая поза найдена снова из её собственных положений, и якобиан совпадает с разностями; { $remarks }.
report-check-failed = { $failures }; { $remarks }.
report-check-axis-count = поворотных: { $rotary }, линейных: { $linear }
report-check-tip-error = Погрешность острия туда и обратно
report-check-tip-error-note = наибольшая из случайных поз ({ $n }) на головку
report-check-jacobian = Якобиан
report-check-jacobian-note = наибольшая относительная разность
report-check-singular-note = в пределах диапазонов
report-check-remarks-note = необычные значения
report-check-caption-machine = Станок в исходном положении в базовой системе координат, проекция по методу первого угла. Стрелки показывают положительное направление того, что движет каждая ось: горелку на стороне инструмента, деталь на стороне детали; повороты по правилу правой руки. Символы, закрывавшие бы друг друга, показаны рядом.
report-check-no-remarks = Нет: пределы, диапазоны и приводы обычной величины и согласованы между собой.
report-check-remark = { $key }: { $why }
report-check-remark-value = { $key } = { $value }: { $why }
report-check-line = { $file }, строка { $line }
report-check-typical = Типовой шов идёт со скоростью { $speed } по изгибу радиуса { $radius }, где горелка поворачивается на { $rate }.
report-check-too-fast = На { $part } диапазонов типовой шов требует от поворотной оси большей скорости, чем она имеет.
report-check-fast-enough = Каждый типовой шов в пределах скорости поворотных осей на всех диапазонах.
report-check-no-singular = Головка { $head }: в пределах диапазонов особых положений нет. Хуже всего обусловлено положение: { $position } (обусловленность { $worst }; в лучшем положении { $best }).
report-check-reach = Головка { $head }: { $kind ->
        [volume] объём
        [area] площадь
       *[length] длина
    }, достижимые для острия в системе детали: { $size }, { $part } описанной коробки. Горелка наклоняется до { $tilt } от направления в исходном положении, если смотреть от детали.
report-check-no-volume = нет: остриё остаётся на поверхности или линии
report-check-point = точка
report-check-size = { $value } ± { $deviation }
report-check-position = { $axis } { $position }

# Check of a machine: tables.
report-check-column-letter = Буква
report-check-column-kind = Вид
report-check-column-moves = Движет
report-check-column-home = Исходное
report-check-column-speed = Скорость, /с
report-check-column-acceleration = Ускорение, /с²
report-check-column-jerk = Рывок, /с³
report-check-column-time = До скорости, с
report-check-caption-axes = Оси; линейные в мм, поворотные в градусах. Последний столбец: время от покоя до наибольшей скорости.
report-check-linear = линейная
report-check-rotary = поворотная
report-check-torch = горелку
report-check-work = деталь
report-check-no-end-stops = без упоров
report-check-column-result = Результат
report-check-column-poses = Позы
report-check-column-direction = Направление, °
report-check-column-axes = Оси, мм или °
report-check-column-near-singular = Около особых
report-check-column-unsolved = Без решения
report-check-column-branch-missing = Нет собственной ветви
report-check-both-heads = обе головки
report-check-off-centre = { $unsolved } (и { $n } со смещёнными суппортами)
report-check-caption-results = Путь туда и обратно: случайные положения, их поза, все положения для этой позы и поза каждого из них. Наибольшие разности; для осей вдали от особых положений.
report-check-result-passed = пройдено
report-check-result-failed = не пройдено
report-check-column-inverse = Обратная задача
report-check-column-difference = Разность
report-check-column-worst-axis = Худшая ось
report-check-caption-structure = Метод, которым для позы находят положения, и якобиан в сравнении с центральными разностями: наибольшая разность относительно своего столбца.
report-check-margin = { $distance } (ближе { $axis } слишком медленная)
report-check-caption-singular = Особые положения головки { $head } в пределах диапазонов и расстояние от них, нужное типовому шву.
report-check-column-configuration = Положение
report-check-column-distance = Нужное расстояние
report-check-column-box = Коробка
report-check-tip-in-work = остриё в системе детали
report-check-tip-in-base = остриё в базовой системе
report-check-caption-reach = Описанная коробка всех положений, достижимых для острия, мм.

# Check of a machine: text.
report-check-text-result = результат
report-check-text-failure = ошибка
report-check-text-head = головка
report-check-text-inverse = обратная
report-check-text-round-trip = туда-обратно
report-check-text-errors = поз: { $n }: остриё { $tip }, направление { $direction }, оси { $axes } (мм или °); около особых: { $near }
report-check-text-jacobian = разность { $difference } относительно столбца
report-check-text-singular = особые
report-check-text-margin = { $place }; ближе { $distance } ось { $axis } слишком медленная для { $speed } на { $radius }
report-check-text-no-singular = в пределах диапазонов нет
report-check-text-reach = досягаемость
report-check-text-box = x { $x }, y { $y }, z { $z } мм в системе детали
report-check-text-tilt = { $size }; до { $tilt } от исходного положения
report-check-text-pair = поз: { $n }: острия { $tip }, направления { $direction }; без решения со смещёнными суппортами: { $off }
report-check-text-remark = замечание
report-check-text-line = строка { $line }: { $remark }
report-check-text-cure = что сделать: { $cure }

# Drawings without a title, for screen readers.
report-three-views = три вида
report-charts = графики
report-machine = станок

# Drawing of a machine.
report-machine-title = { $machine }: оси в исходном положении, в базовой системе
report-machine-moves-torch = положительное движение горелки
report-machine-moves-work = положительное движение детали
report-machine-beam = луч или проволока до острия
report-machine-links = звенья и формы
report-machine-towards = положительное к вам
report-machine-away = положительное от вас
report-machine-stroke = ход, стрелка на наибольшем положении
report-machine-cut = продолжается
report-machine-home = исходное положение
report-machine-base = база
report-machine-work = деталь
report-machine-up = вверх

# Bode plots.
report-bode-frequency = частота
report-bode-magnitude = амплитуда разомкнутого контура
report-bode-phase = фаза разомкнутого контура
report-bode-crossover = срез
report-bode-open-loop = разомкнутый контур
report-bode-gain-margin = запас по амплитуде { $margin } на { $frequency }
report-bode-gain-unbounded = запас по амплитуде: неограничен
report-bode-phase-margin = запас по фазе { $margin } на { $frequency }
report-bode-phase-unbounded = запас по фазе: неограничен

# Search for placements.
report-reach-subtitle = Установки детали
report-reach-subtitle-base = Установки основания станка
report-reach-title = Досягаемость станка { $machine }
report-reach-key = Число: наименьшее расстояние оси от конца её диапазона, % диапазона
report-reach-label = { $title }: карта установок
report-reach-shade = от { $from } до { $to } %
report-reach-shade-above = выше { $from } %
report-reach-fails = непригодна
report-reach-present = нынешняя установка
report-reach-best = лучшая установка
report-reach-judged = проверено установок
report-reach-weldable = пригодны
report-reach-clearance = зазор у лучшей
report-reach-kind-reach = вне досягаемости
report-reach-kind-range = диапазон оси
report-reach-kind-jump = нет непрерывного движения
report-reach-kind-speed = скорость оси
report-reach-kind-position = положение сварки
report-reach-found = лучшая установка: x { $x }, y { $y }, z { $z }, поворот { $turn }; запланирована
report-reach-none = нет пригодной и запланированной установки
report-reach-heading-map = Карта
report-reach-heading-best = Лучшие установки
report-reach-heading-reasons = Причины непригодности
report-reach-heading-method = Метод
report-reach-method = Смещения даны в системе координат детали от нынешней установки; поворот вокруг вертикали через середину шва. Каждая ячейка показывает лучшую установку сетки с этими x и y, а при непригодности ось или вид причины. Лучшая установка запланирована полностью, с зазорами и переходами; прочие проверены по диапазонам, скоростям, положениям сварки и непрерывности движения.
report-reach-method-base = Смещения основания станка даны в системе координат основания от нынешней установки; поворот вокруг вертикали через её начало. Всё на основании перемещается с ним. Каждая ячейка показывает лучшую установку сетки с этими x и y, а при непригодности ось или вид причины. Лучшая установка запланирована полностью, с зазорами и переходами; прочие проверены по диапазонам, скоростям, положениям сварки и непрерывности движения.
report-reach-caption-map = Установки по x и y
report-reach-caption-best = Лучшие из проверенных установок
report-reach-caption-reasons = Причины, каждая с наиболее близкой к пригодной установкой
report-reach-column-turn = поворот, °
report-reach-column-margin = запас, % диапазона
report-reach-column-axis = ось
report-reach-column-singular = от сингулярного положения, %
report-reach-column-speed = использование скорости оси, %
report-reach-column-kind = причина
report-reach-column-count = установок
report-reach-column-pass = проход
report-reach-column-s = s, мм
report-reach-column-reason = ближайший случай
