# Numbered parts of a page, results and findings.
report-table = Таблиця { $number }.
report-figure = Рис. { $number }.
report-in-order = Відповідає
report-not-in-order = Не відповідає
report-severity-note = Примітка
report-severity-warning = Попередження
report-severity-error = Помилка
report-finding-place = Де: { $place }
report-finding-cure = Що зробити: { $cure }
report-no-findings = Зауважень немає.
report-heading-notes = Примітки
report-heading-findings = Зауваження
report-more-places = ще місць: { $n }

# Places, ranges and pairs of values.
report-range = { $from } … { $to }
report-at = s = { $s }
report-at-range = s = { $from } … { $to }
report-pass-at = прохід { $pass }, { $place }
report-passes-at = проходи { $first }–{ $last }, { $place }
report-pair = { $first } і { $second }
report-pass-named = прохід { $pass }: { $name }
report-curve-of-head = { $curve }, головка { $head }
report-part-of = { $value } з { $whole }
report-more-than = більше { $value }

# Charts.
report-no-data = немає даних
report-limit-above = { $limit }, вище
report-limit-below = { $limit }, нижче
report-limit-outside = { $limit }, поза рисунком
report-limit = межа
report-limit-at-least = не менше
report-limit-at-most = не більше
report-limit-min = найменша
report-limit-max = найбільша
report-label-path-length = довжина шляху s
report-label-distance = відстань
report-label-angle = кут
report-label-heat-input = тепловкладення
report-label-speed = швидкість
report-label-acceleration = прискорення
report-label-jerk = ривок
report-label-position = положення
report-label-curvature = кривина
report-label-deviation = відхилення
report-label-path-error = відхилення від шляху
report-label-following-error = похибка слідкування
report-label-attitude-error = похибка нахилу
report-label-along-seam = уздовж шва
report-label-across = поперек
report-label-torch-tip = вістря пальника

# Names of views.
report-view-front = Спереду
report-view-side = Збоку, зліва
report-view-top = Згори
report-view-pictorial = Наочно, не в масштабі
report-seen-from-above = вигляд згори
report-seen-from-below = вигляд знизу
report-seen-from-plus-x = вигляд з +x
report-seen-from-minus-x = вигляд з -x
report-seen-from-plus-y = вигляд з +y
report-seen-from-minus-y = вигляд з -y

# Columns of tables.
report-column-value = Величина
report-column-min = Найменше
report-column-mean = Середнє
report-column-max = Найбільше
report-column-allowed = Дозволено
report-column-outside-s = Поза, с
report-column-outside-mm = Поза, мм
report-column-pass = Прохід
report-column-name = Прізвище
report-column-date = Дата
report-column-signature = Підпис
report-column-alarm = Тривога
report-column-priority = Пріоритет
report-column-cause = Причина
report-column-position-mm = s, мм
report-column-time-s = t, с
report-column-first-out = Перша
report-column-acknowledged = Підтверджено
report-column-time = Час
report-column-event = Подія
report-column-text = Текст
report-column-version = Версія
report-column-file = Файл
report-column-rows = Рядки
report-column-bytes = Байти
report-column-transfer-before-s = Холостий хід перед тим, с
report-column-start-s = Початок, с
report-column-travel-s = Хід, с
report-column-arc-on-s = Дуга горить, с
report-column-total-s = Разом, с
report-column-speed-mm-s = Швидкість, мм/с
report-column-stick-out = Виліт, мм
report-column-arc-energy = Погонна енергія дуги, кДж/мм
report-column-heat-input = Тепловкладення, кДж/мм
report-column-length-mm = Довжина, мм
report-column-wire-m = Дріт, м
report-column-bead = Валик на перерізі
report-column-toe-deg = Кут переходу, °
report-column-weld-metal-kg = Наплавлено, кг
report-column-wait-before-s = Очікування перед, с
report-column-group = Група (ISO/TR 15608)
report-column-thickness = Товщина, мм
report-column-ce = CE (IIW), %
report-column-cet = CET, %
report-column-pcm = Pcm, %
report-column-preheat = Підігрів за EN 1011-2, °C
report-column-work = Деталь перед проходом, °C
report-column-t85 = t8/5, с
report-column-heat-flow = Тепловідвід
report-column-at-requested-speed = Із заданою швидкістю, %
report-column-attitude-error = Похибка нахилу, °
report-column-clearance = Найменша відстань, мм
report-column-between = між
report-column-path-error-mm = Відхилення від шляху, мм
report-column-rms-mm = СКВ, мм
report-column-rms = СКВ
report-column-speed-ripple = Нерівність швидкості, %
report-column-position = Положення
report-column-from = Від
report-column-to = До
report-column-slope = Нахил
report-column-rotation = Поворот
report-column-section = Ділянка
report-column-min-speed = Найменша швидкість
report-column-max-speed = Найбільша швидкість
report-column-binding = Що обмежує
report-column-head = Головка
report-column-untracked = без стеження, 99 % (мм)
report-column-tracked = зі стеженням, 99 % (мм)
report-column-correction-used = від дозволеної корекції
report-column-stopped-at = зупинено на (мм)
report-column-corrected-by = виправлено за
report-column-deflected = відхилено до (мм)
report-column-gun-carried = гармату зсунуто до (мм)
report-column-away = поза швом (% часу)
report-column-longest = найдовше (мс)
report-column-stored-within = дев’ять із десяти точок від збережених відхилень (мм)
report-column-peak-load = Пікове навантаження, %
report-column-axis = Вісь
report-column-unit = Одиниця
report-column-range = Діапазон
report-column-of = від
report-column-speed-used = Швидкість, %
report-column-acceleration-used = Прискорення, %
report-column-jerk-used = Ривок, %
report-column-tip-mm = Вістря, мм
report-column-linear-axis = Лінійна вісь
report-column-rotary-axis = Поворотна вісь
report-column-tip-speed = Швидкість вістря
report-column-process-value = Параметр процесу

# Title blocks of pages.
report-subtitle-plan = Звіт про шов: план
report-subtitle-simulation = Звіт про шов: план і симуляція
report-subtitle-record = Протокол зварювання { $id }
report-subtitle-record-simulated = Протокол зварювання { $id }, симуляція: метал не зварювали
report-meta-part = Деталь
report-meta-welder = Зварник
report-meta-machine = Верстат
report-meta-procedure = Технологія
report-meta-started = Початок
report-meta-ended = Кінець
report-not-yet = ще ні
report-none = немає
report-meta-page-made = Сторінку складено
report-meta-made-by = Складено програмою

# Headings.
report-heading-values = Технологія і фактичні значення
report-heading-deviations = Відхилення від шва
report-heading-alarms = Тривоги
report-heading-events = Події
report-heading-record = Запис
report-heading-procedure = Технологія
report-heading-program = Програма
report-heading-signatures = Підписи
report-heading-errors = Помилки
report-heading-map = Схема зварювання та графік
report-heading-process = Процес уздовж шва
report-heading-materials = Матеріали, підігрів та охолодження
report-heading-cut = Різ труби
report-heading-source = Текст завдання
report-heading-passes = Проходи
report-heading-checks = Перевірки
report-heading-curves = Додаток: криві
report-heading-seam = Шов і пальник
report-heading-joint = Стик
report-heading-taught = Навчені ділянки
report-heading-tracking = Стеження
report-heading-simulated = Симуляція зварювання
report-heading-axes = Осі
report-heading-programs = Програми ЧПК
report-heading-job = Початок і кінець проходів
report-heading-released = Затверджено
report-heading-pass-curves = Прохід { $pass } ({ $name }): криві

# Record of a weld: result.
report-result-good = Зварено до кінця, у межах допуску.
report-result-deviating = Зварено до кінця, але не все так, як задано.
report-result-stopped = Зупинено, не зварено до кінця.
report-result-interrupted = Перервано: збій програми або живлення.
report-result-running = Не закінчено: зварювання триває, або стався збій програми.
report-windows-without-procedure = Технології (WPS) для порівняння немає.
report-windows-within = Усі значення в межах технології.
report-windows-outside = Поза межами технології: { $values }.
report-value-outside-at = { $value } у проході { $pass }, s = { $from } – { $to }
report-value-outside = { $value } у проході { $pass }
report-record-note = Примітка: { $note }.
report-tile-arc-on = Час горіння дуги
report-tile-deviation = Відхилення
report-tile-mean = середня; { $from } … { $to }
report-tile-max-at = найбільше, на s = { $s }

# Record of a weld: tables.
report-caption-by-hand = Заповнюють від руки
report-inspector = Контролер
report-welding-engineer = Інженер-зварник
report-caption-actual-values = Фактичні значення під час руху по проходу, без зупинок, початків і закінчень, порівняно з межами технології
report-no-values = Значень не записано.
report-not-limited = не обмежено
report-outside = поза нормою
report-within = норма
report-allowed = дозволено
report-no-alarms = Тривог немає.
report-caption-alarms = Тривоги в порядку появи
report-first-out = перша
report-no = ні
report-caption-events = Події в порядку появи
report-caption-sources = Тексти, за якими зварено; вони в бібліотеці; SHA-256 програми { $sha256 }
report-caption-files = Файли запису

# Record of a weld: charts.
report-heat-input-unknown = Невідоме: без технології (WPS) потужність не визначено.
report-chart-heat-input = Тепловкладення вздовж шва
report-caption-heat-input-bins = Енергія на шлях вістря пальника, на кожних { $bin }.
report-chart-tip-off-path = Відхилення вістря пальника від запланованого шляху
report-caption-tip-off-path = Відстань справжнього вістря пальника від шва по нормалі до нього, на кожних { $bin } найбільша.
report-chart-weld-off-joint = Відхилення шва від стику
report-caption-weld-off-joint = Відхилення шва від стику вбік і за висотою, найбільше на кожних { $bin }.
report-curves-shown = Показано кривих: { $shown } з { $all }; у записі є всі.

# Plan: checks and verdict.
report-no-findings-plan = Немає: шов можна зварити на цьому верстаті, як задано.
report-checked = Перевірено: досяжність, діапазони, швидкості, прискорення і ривки осей; що вісь пальника не заходить у жодну з поверхонь; відстані між собою: { $objects }, уздовж проходів і в холостих ходах, наскільки файли дають їх форми. Не перевірено: об’єкти, яких немає в цьому переліку, деталі поза довжинами, які дає їм завдання, кабелі та шланги.
report-checked-without-shapes = Перевірено: досяжність, діапазони, швидкості, прискорення і ривки осей, а також що вісь пальника не заходить у жодну з поверхонь. Зіткнення не перевірено: у файлі верстата немає форм.
report-verdict-planned = Заплановано: усі осі в межах, задана швидкість від розгону до гальмування.
report-verdict-planned-slowed = Заплановано: усі осі в межах, сповільнено до { $speed } там, де цього потребує вісь.
report-verdict-within = У межах { $procedure }.
report-verdict-outside = Поза { $procedure }, зауважень: { $n }.
report-verdict-findings = Зауваження: виправити { $errors }, розглянути { $warnings }.
report-verdict-simulated = Симуляція: відхилення від шляху не більше { $error } з { $allowed } дозволених, швидкість у межах { $ripple } з { $ripple_allowed } дозволених.
report-verdict-simulated-short = Симуляція: відхилення від шляху не більше { $error } з { $allowed } дозволених, закороткий, щоб судити про швидкість.

# Plan: key figures.
report-tile-weld-length = Довжина зварювання
report-seam-length = шов { $length }
report-length-of-passes = { $of }; проходів: { $n }, разом { $length }
report-through-points = через точки
report-tile-weld-time = Час зварювання
report-travel = хід від спокою до спокою
report-travel-of-passes = хід усіх проходів ({ $n }) від спокою до спокою
report-tile-path-error = Відхилення від шляху, симуляція
report-path-error-rms = найбільше; СКВ { $rms }
report-tile-speed-ripple = Нерівність швидкості, симуляція
report-speed-range = { $from } … { $to }, СКВ { $rms }
report-too-short = шов закороткий, щоб судити
report-tile-attitude-error = Похибка нахилу
report-attitude-error-of-plan = найбільша, за планом
report-tile-arc-energy = Погонна енергія дуги
report-arc-energy-range = найбільша; найменша { $min }; U I / v
report-tile-wire = Дріт
report-wire-length = { $length } за час дуги
report-tile-weld-metal = Метал шва
report-tile-gas = Газ
report-gas-time = від попередньої до кінцевої подачі
report-tile-flux = Флюс
report-tile-energy = Енергія дуги
report-mains = { $energy } з мережі
report-tile-heat-input = Погонна енергія
report-heat-input-range = найбільша; найменша { $min }
report-tile-total = Загальний час
report-total-parts = від вихідної до вихідної; холості ходи { $transfer }
report-total-parts-waiting = від вихідної до вихідної; холості ходи { $transfer }, очікування { $wait }
report-duty = { $part } загального часу; ТВ { $duty } за 10 хвилин
report-tile-cost = Вартість
report-cost-labour = праця
report-cost-machine = верстат
report-cost-wire = дріт
report-cost-gas = газ
report-cost-flux = флюс
report-cost-energy = енергія
report-cost-incomplete = неповна: невідома кількість
report-wire-with-arc = поки горить дуга

# Plan: order of welding.
report-caption-order = Проходи занумеровано в порядку зварювання. Штрихом: холості ходи, прямо від кінця до початку.
report-chart-order = Порядок зварювання, проходів: { $n }, { $view }
report-order-key = Крапка: початок. Стрілка: напрям зварювання. Штрих: холості ходи, прямо.
report-order-key-tacks = Оранжеві, номери зовні: прихватки.
report-order-lines = { $title }: ліній за порядком: { $n }
report-caption-map = Схема зварювання: розгорнутий шов, рядок на кожен валик у порядку зварювання.
report-chart-map = Схема зварювання на розгорнутому шві
report-map-key = Крапка: початок. Риска: кінець. Стрілка: напрям зварювання. Номери: проходи.
report-map-copies = Перший зі швів, усього { $n }.
report-map-label = { $title }: рядків { $n }, { $length }
report-caption-order-table = Графік: проходи в порядку зварювання
report-all-from-home = усе, від вихідного положення до нього ж

# Plan: passes.
report-caption-passes = Значення кожного проходу за планом
report-all-passes = усі проходи
report-caption-checks = Перевірки кожного проходу
report-caption-materials = Основні матеріали та метал шва з вуглецевими еквівалентами: CE за IIW, CET за EN 1011-2, Pcm за Іто і Бессьо.
report-materials-decisive = Для підігріву: CET { $cet } і { $hydrogen } мл водню на 100 г.
report-caption-heat = Підігрів за методом B та час охолодження з 800 до 500 °C за EN 1011-2 для { $thickness }: від найменшої погонної енергії на найхолоднішій деталі до найбільшої на найгарячішій.
report-no-preheat = немає
report-weld-metal = метал шва
report-material-group = група { $group }
report-caption-simulated-passes = Результати кожного проходу в симуляції
report-about-curves = Криві по одному проходу кожного виду: з помилкою, інакше найдовшому. `plan --plots` записує криві всіх проходів.

# Plan: seam, torch and process.
report-caption-seam = Шов із заданою віссю пальника, у системі координат завдання, проєкція за методом першого кута.
report-curve-bead = валик
report-curve-seam = шов
report-curve-path = шлях
report-curve-torch-axis = вісь пальника
report-mark-start = початок
report-mark-end = кінець
report-mark-end-of-overlap = кінець перекриття
report-chart-torch-angles = Кути пальника і розробка
report-curve-work-angle = кут поперек (від бісектриси)
report-curve-travel-angle = кут уздовж (+ назад, − вперед)
report-curve-half-dihedral = половина двогранного кута
report-caption-torch-angles = Кут поперек від бісектриси поверхонь (додатний до першої деталі), кут уздовж і половина кута між поверхнями.
report-chart-process-values = Задані параметри процесу
report-caption-process-values = Параметри процесу вздовж проходу там, де вони змінюються; без наростання і спаду на кінцях.
report-chart-weave = Шлях вістря з коливаннями на перших { $length }
report-curve-tip = вістря
report-curve-beam = промінь
report-first-part = перша деталь
report-second-part = друга деталь
report-caption-weave = Заданий шлях із коливаннями, вигляд уздовж пальника, шов випрямлено, масштаб уздовж і поперек однаковий; пальник рухається праворуч.
report-chart-oscillation = Шлях променя на деталі за періоди ({ $n }): { $advance } за період при { $speed }
report-caption-oscillation = Шлях відхиленого променя на деталі, масштаб уздовж і поперек однаковий; oscillation.csv має один період відхилення.
report-caption-cut = Розгортка відрізаного кінця труби; cut.svg показує її в натуральну величину, вигляд ззовні, щоб обгорнути трубу, а cut.csv містить її точки.
report-chart-cut = Шаблон різу
report-cut-outside = зовні: радіус { $radius }, обвід { $around }, різ { $from } … { $to } уздовж осі, край на { $edge }
report-cut-inside = усередині: радіус { $radius }, обвід { $around }, різ { $from } … { $to } уздовж осі, край на { $edge }
report-sections = { $title }: перерізів: { $n }
report-section-note = кут { $dihedral }, площа { $area }
report-section-toes = , кути переходу { $second } і { $first }
report-area-with-cap = { $groove } + { $cap }
report-section-torch = пальник: кут поперек { $work }, кут уздовж { $travel }
report-caption-sections = Перерізи вздовж шва в одному масштабі, поверхня другої деталі горизонтальна або лице стикового шва вгору: валики в порядку зварювання і куди в кожному вказує дріт; площа: розробки і підсилення над нею.

# Plan: welding procedure.
report-caption-heat-input = Тепловкладення при запланованій швидкості між розгоном і гальмуванням, з його межами; затінено там, де воно поза ними.
report-caption-positions = Положення зварювання (ISO 6947) за нахилом ходу і поворотом лиця шва, як осі верстата повертають деталь.
report-too-high = завелика
report-too-low = замала
report-chart-positions = Положення зварювання
report-curve-slope = нахил (+ угору)
report-curve-rotation = поворот лиця (0 вгору, 180 вниз)
report-run = прохід технології { $run }
report-no-run = жоден її прохід не стосується цього
report-procedure = { $number } ({ $title }), { $run }. Процес { $process }: { $process_name }. Тепловкладення: { $efficiency } × потужність / запланована швидкість. Положення як для { $joint ->
        [fillet] кутового
       *[butt] стикового
    } шва.
report-caption-plan-values-of = План і технологія, прохід { $passes }
report-unbounded = без меж
report-to-be-measured = треба виміряти
report-unknown-see-findings = невідомо: див. зауваження
report-outside-at = поза нормою: s = { $from } … { $to }
report-outside-pass = поза межами: прохід { $passes }
report-outside-at-more = поза нормою: s = { $from } … { $to } та інші ділянки: { $n }
report-caption-positions-any = Положення зварювання (мм, градуси); технологія дозволяє будь-яке
report-caption-positions-allowed = Положення зварювання (мм, градуси); технологія дозволяє { $positions }
report-not-allowed = не дозволено

# Plan: taught spans.
report-chart-taught = Навчена ділянка { $number }
report-caption-taught = Шов, що вариться, і номінальний шов; на обох переходах збігаються положення, напрям і кривина.
report-taught = навчено
report-chart-off-nominal = Відстань від номінального шва
report-curve-as-welded = шов, що вариться
report-curve-nominal = номінальний шов
report-curve-taught-points = навчені точки
report-chart-direction-off-nominal = Напрям відносно номінального шва
report-chart-curvature = Кривина
report-chart-tip-speed = Швидкість вістря пальника
report-curve-planned = за планом
report-shorter = коротше
report-longer = довше
report-taught-span = Ділянка { $number }: s = { $from } … { $to } (на { $length } { $change }, ніж номінальний шов там), навчених точок: { $n }; до { $distance } від номінального шва і { $angle } від його напряму.

# Plan: clearance.
report-caption-clearance = Найменша відстань між пальником, ланками, деталлю, оснащенням і зонами та її нижня межа вздовж усього проходу.
report-chart-clearance = Найменша відстань (показано до { $limit })
report-curve-clearance = найменша відстань
report-curve-clearance-bound = доведена нижня межа між відліками

# Plan: speed.
report-speed-reached = Задано: { $requested }. Досягнуто між розгоном і гальмуванням: { $reached }. Задана швидкість на { $part } довжини.
report-caption-speed = Швидкість вістря вздовж шва відносно деталі; затінено там, де вона менша за задану, з межею, що обмежує.
report-chart-speed = Швидкість вістря пальника вздовж шва
report-curve-tip-simulated = справжнє вістря, симуляція
report-acceleration-phase = розгін
report-deceleration-phase = гальмування
report-section-weld = шов
report-axis = вісь { $axis }
report-torch-tip = вістря пальника
report-requested-speed = задана швидкість
report-binding = { $owner }: { $what }, { $limit }
report-no-binding = нічого: швидкість як задано
report-caption-binding = Що обмежує швидкість (мм, мм/с)
report-caption-binding-first = Що обмежує швидкість (мм, мм/с): перших ділянок { $n }, ще { $more } у report.json
report-caption-deviation = Відхилення швидкості в симуляції між розгоном і гальмуванням; на початку приводи встановлюються.
report-chart-deviation = Швидкість справжнього вістря відносно запланованої

# Plan: tracking.
report-part-displaced = Деталь лежить не там, де заплановано.
report-tracking-without-alarms = Стеження не подало тривог.
report-welded-as-planned = Зварено, як заплановано.
report-to-be-checked = Перевірте: { $alarms }.
report-alarm-at = { $head } на { $s }: { $alarm }
report-caption-tracking = Справжнє положення стику відносно запланованого шляху, відхилення шва від стику і невизначеність положення стику.
report-chart-tracking = Стик і шов
report-chart-joint = стик відносно запланованого шляху (відхилення шва без стеження)
report-chart-weld = шов відносно стику
report-chart-correction = корекція вбік: відхилення променя; штрихом рух гармати осями
report-chart-sigma = невизначеність положення стику (стандартне відхилення)
report-curve-lateral = убік
report-curve-height = за висотою
report-curve-deflection = відхилення променя
report-curve-gun = рух гармати осями
report-curve-sigma = сигма
report-not-welded = не зварено
report-not-tracked = без стеження
report-caption-tracked-lateral = Відстань шва від стику вбік: промінь не має висоти
report-caption-tracked = Відстань шва від стику, вбік і за висотою разом
report-stored-points = { $value } (точок: { $n })
report-stored-deviations = збережені відхилення
report-seen-by-beam = вимірювання променем
report-caption-beam = Корекції променя

# Plan: simulation.
report-simulation = Кожна вісь на своєму контурі положення з періодом сервоприводу, з інерцією, тертям, зубцевими пульсаціями, кроками енкодера і межею струму (зерно { $seed }). Деталь номінальна: без зміщення, деформації, похибок складання і викривлення дроту. Нерівність швидкості: найбільше відхилення швидкості вістря від запланованої, від пів секунди після розгону до гальмування.
report-highest-load = Найбільш навантажений привід: { $axis }, { $load } пікового.
report-assumed-drives = Файл верстата не описує приводу для { $axes }: симуляція бере припущений.
report-caption-path-error = Відстань справжнього вістря від шва по нормалі до нього.
report-chart-path-error = Відстань справжнього вістря пальника від шва
report-curve-normal-to-seam = по нормалі до шва
report-caption-following = Задане положення мінус справжнє для кожної осі.
report-chart-following = Похибка слідкування кожної осі
report-caption-following-table = Похибка слідкування, поки горить дуга
report-caption-attitude = Кут між справжнім напрямом пальника і заданим.
report-chart-attitude = Відхилення справжнього напряму пальника від заданого

# Plan: axes.
report-continuous = без меж
report-caption-axes = Заплановані положення, швидкість і прискорення кожної осі та їх межі.
report-caption-jerks = Запланований ривок кожної осі та його межа.
report-chart-axes = Осі та їх межі
report-chart-jerks = Ривок осей та його межі
report-caption-ranges = Положення осей та їх діапазони
report-caption-uses = Найбільше використання меж кожної осі

# Plan: part programs.
report-program = { $file } для { $dialect }: кадрів руху { $n }, прочитано назад, виконано за правилами інтерполяції та подач системи ЧПК, проведено через пряму кінематику верстата і порівняно з планом; дозволено { $tolerance }.
report-as-in-program = як у програмі
report-caption-program = Найбільші відхилення { $file }

# Plan: job data.
report-caption-job = Час і значення до та після руху
report-row-seam = Шов
report-row-seam-length = Довжина шва
report-row-acceleration-phase = Розгін
report-row-deceleration-phase = Гальмування
report-row-start-angle = Початковий кут
report-row-direction = Напрям зварювання
report-row-dihedral = Двогранний кут
report-row-preparation = Підготовка кромок
report-counter-clockwise = проти годинникової стрілки
report-clockwise = за годинниковою стрілкою
report-row-overlap = Перекриття
report-row-preflow = Газ до дуги
report-row-travel-delay = Дуга до початку ходу
report-row-upslope = Наростання від: { $value }
report-row-upslope-time = Наростання: час
report-row-downslope = Спад до: { $value }
report-row-downslope-time = Спад: час
report-row-crater = Заварювання кратера
report-row-postflow = Газ після дуги

# Check of a machine: page.
report-check-subtitle = Перевірка файлу верстата
report-check-made-by = Seamwright { $version }, зерно { $seed }
report-check-heading-failed = Непройдені перевірки
report-check-remarks = Зауваги
report-check-heading-kinematics = Кінематика
report-check-singular = Особливі положення
report-check-heading-reach = Досяжність
report-check-heading-file = Файл верстата
report-check-remark-count = зауваг: { $n }
report-check-passed = Кожну позу знайдено знову з її власних положень, і якобіан збігається з різницями; { $remarks }.
report-check-failed = { $failures }; { $remarks }.
report-check-axis-count = поворотних: { $rotary }, лінійних: { $linear }
report-check-tip-error = Похибка вістря туди й назад
report-check-tip-error-note = найбільша з випадкових поз ({ $n }) на головку
report-check-jacobian = Якобіан
report-check-jacobian-note = найбільша відносна різниця
report-check-singular-note = у межах діапазонів
report-check-remarks-note = незвичні значення
report-check-caption-machine = Верстат у вихідному положенні в базовій системі координат, проєкція за методом першого кута. Стрілки показують додатний напрям того, що рухає кожна вісь: пальник на боці інструмента, деталь на боці деталі; повороти за правилом правої руки. Символи, що закривали б один одного, показано поруч.
report-check-no-remarks = Немає: межі, діапазони і приводи звичайної величини і узгоджені між собою.
report-check-remark = { $key }: { $why }
report-check-remark-value = { $key } = { $value }: { $why }
report-check-line = { $file }, рядок { $line }
report-check-typical = Типовий шов іде зі швидкістю { $speed } по вигину радіуса { $radius }, де пальник повертається на { $rate }.
report-check-too-fast = На { $part } діапазонів типовий шов потребує від поворотної осі більшої швидкості, ніж вона має.
report-check-fast-enough = Кожен типовий шов у межах швидкості поворотних осей на всіх діапазонах.
report-check-no-singular = Головка { $head }: у межах діапазонів особливих положень немає. Найгірше обумовлене положення: { $position } (обумовленість { $worst }; у найкращому положенні { $best }).
report-check-reach = Головка { $head }: { $kind ->
        [volume] об’єм
        [area] площа
       *[length] довжина
    }, досяжні для вістря в системі деталі: { $size }, { $part } описаної коробки. Пальник нахиляється до { $tilt } від напряму у вихідному положенні, якщо дивитися від деталі.
report-check-no-volume = немає: вістря лишається на поверхні або лінії
report-check-point = точка
report-check-size = { $value } ± { $deviation }
report-check-position = { $axis } { $position }

# Check of a machine: tables.
report-check-column-letter = Літера
report-check-column-kind = Вид
report-check-column-moves = Рухає
report-check-column-home = Вихідне
report-check-column-speed = Швидкість, /с
report-check-column-acceleration = Прискорення, /с²
report-check-column-jerk = Ривок, /с³
report-check-column-time = До швидкості, с
report-check-caption-axes = Осі; лінійні в мм, поворотні в градусах. Останній стовпець: час від спокою до найбільшої швидкості.
report-check-linear = лінійна
report-check-rotary = поворотна
report-check-torch = пальник
report-check-work = деталь
report-check-no-end-stops = без упорів
report-check-column-result = Результат
report-check-column-poses = Пози
report-check-column-direction = Напрям, °
report-check-column-axes = Осі, мм або °
report-check-column-near-singular = Біля особливих
report-check-column-unsolved = Без розв’язку
report-check-column-branch-missing = Бракує власної гілки
report-check-both-heads = обидві головки
report-check-off-centre = { $unsolved } (і { $n } зі зсунутими супортами)
report-check-caption-results = Шлях туди й назад: випадкові положення, їх поза, усі положення для цієї пози і поза кожного з них. Найбільші різниці; для осей далеко від особливих положень.
report-check-result-passed = пройдено
report-check-result-failed = не пройдено
report-check-column-inverse = Обернена задача
report-check-column-difference = Різниця
report-check-column-worst-axis = Найгірша вісь
report-check-caption-structure = Метод, яким для пози знаходять положення, і якобіан порівняно з центральними різницями: найбільша різниця відносно свого стовпця.
report-check-margin = { $distance } (ближче { $axis } заповільна)
report-check-caption-singular = Особливі положення головки { $head } у межах діапазонів і відстань від них, потрібна типовому шву.
report-check-column-configuration = Положення
report-check-column-distance = Потрібна відстань
report-check-column-box = Коробка
report-check-tip-in-work = вістря в системі деталі
report-check-tip-in-base = вістря в базовій системі
report-check-caption-reach = Описана коробка всіх положень, досяжних для вістря, мм.

# Check of a machine: text.
report-check-text-result = результат
report-check-text-failure = помилка
report-check-text-head = головка
report-check-text-inverse = обернена
report-check-text-round-trip = туди й назад
report-check-text-errors = поз: { $n }: вістря { $tip }, напрям { $direction }, осі { $axes } (мм або °); біля особливих: { $near }
report-check-text-jacobian = різниця { $difference } відносно стовпця
report-check-text-singular = особливі
report-check-text-margin = { $place }; ближче за { $distance } вісь { $axis } заповільна для { $speed } на { $radius }
report-check-text-no-singular = у межах діапазонів немає
report-check-text-reach = досяжність
report-check-text-box = x { $x }, y { $y }, z { $z } мм у системі деталі
report-check-text-tilt = { $size }; до { $tilt } від вихідного положення
report-check-text-pair = поз: { $n }: вістря { $tip }, напрями { $direction }; без розв’язку зі зсунутими супортами: { $off }
report-check-text-remark = заувага
report-check-text-line = рядок { $line }: { $remark }
report-check-text-cure = що зробити: { $cure }

# Drawings without a title, for screen readers.
report-three-views = три вигляди
report-charts = графіки
report-machine = верстат

# Drawing of a machine.
report-machine-title = { $machine }: осі у вихідному положенні, у базовій системі
report-machine-moves-torch = додатний рух пальника
report-machine-moves-work = додатний рух деталі
report-machine-beam = промінь або дріт до вістря
report-machine-links = ланки і форми
report-machine-towards = додатний до вас
report-machine-away = додатний від вас
report-machine-stroke = хід, стрілка на найбільшому положенні
report-machine-cut = продовжується
report-machine-home = вихідне положення
report-machine-base = база
report-machine-work = деталь
report-machine-up = вгору

# Bode plots.
report-bode-frequency = частота
report-bode-magnitude = амплітуда розімкненого контуру
report-bode-phase = фаза розімкненого контуру
report-bode-crossover = зріз
report-bode-open-loop = розімкнений контур
report-bode-gain-margin = запас за амплітудою { $margin } на { $frequency }
report-bode-gain-unbounded = запас за амплітудою: необмежений
report-bode-phase-margin = запас за фазою { $margin } на { $frequency }
report-bode-phase-unbounded = запас за фазою: необмежений

# Search for placements.
report-reach-subtitle = Установлення деталі
report-reach-subtitle-base = Установлення основи верстата
report-reach-title = Досяжність верстата { $machine }
report-reach-key = Число: найменша відстань осі від кінця її діапазону, % діапазону
report-reach-label = { $title }: карта установлень
report-reach-shade = від { $from } до { $to } %
report-reach-shade-above = вище { $from } %
report-reach-fails = непридатне
report-reach-present = нинішнє установлення
report-reach-best = найкраще установлення
report-reach-judged = перевірено установлень
report-reach-weldable = придатні
report-reach-clearance = зазор у найкращого
report-reach-kind-reach = поза досяжністю
report-reach-kind-range = діапазон осі
report-reach-kind-jump = немає неперервного руху
report-reach-kind-speed = швидкість осі
report-reach-kind-position = положення зварювання
report-reach-found = найкраще установлення: x { $x }, y { $y }, z { $z }, поворот { $turn }; заплановано
report-reach-none = немає придатного і запланованого установлення
report-reach-heading-map = Карта
report-reach-heading-best = Найкращі установлення
report-reach-heading-reasons = Причини непридатності
report-reach-heading-method = Метод
report-reach-method = Зміщення подано в системі координат деталі від нинішнього установлення; поворот навколо вертикалі через середину шва. Кожна клітинка показує найкраще установлення сітки з цими x і y, а за непридатності вісь або вид причини. Найкраще установлення заплановано повністю, із зазорами та переходами; решту перевірено за діапазонами, швидкостями, положеннями зварювання і неперервністю руху.
report-reach-method-base = Зміщення основи верстата подано в системі координат основи від нинішнього установлення; поворот навколо вертикалі через її початок. Усе на основі переміщується з нею. Кожна клітинка показує найкраще установлення сітки з цими x і y, а за непридатності вісь або вид причини. Найкраще установлення заплановано повністю, із зазорами та переходами; решту перевірено за діапазонами, швидкостями, положеннями зварювання і неперервністю руху.
report-reach-caption-map = Установлення за x і y
report-reach-caption-best = Найкращі з перевірених установлень
report-reach-caption-reasons = Причини, кожна з найближчим до придатного установленням
report-reach-column-turn = поворот, °
report-reach-column-margin = запас, % діапазону
report-reach-column-axis = вісь
report-reach-column-singular = від сингулярного положення, %
report-reach-column-speed = використання швидкості осі, %
report-reach-column-kind = причина
report-reach-column-count = установлень
report-reach-column-pass = прохід
report-reach-column-s = s, мм
report-reach-column-reason = найближчий випадок
