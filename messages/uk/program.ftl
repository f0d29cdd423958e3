# Allowed values.
program-less-than-key = менше за { $key } = { $max }
program-up-to-key = до { $key } = { $max }
program-positive-up-to-key = більше за 0, до { $key } = { $max }
program-up-to-in-all = загалом до { $max }
program-either = або { $first }, або { $second }
program-at-least-one = щонайменше одна
program-at-least-one-table = щонайменше одна { $table }
program-at-least-one-pass = програма має щонайменше один прохід
program-at-least-one-point = щонайменше одна ділянка щонайменше з однією точкою
program-at-least-one-path-length = щонайменше одна довжина шляху
program-at-least-one-column = щонайменше один стовпець = число
program-numbers = { $numbers ->
        [one] { $numbers } число
        [few] { $numbers } числа
       *[many] { $numbers } чисел
    }
program-one-for-each = по одному на кожен
program-one-for-each-of = по одному на кожен з { $columns }
program-range-in-order = від { $min } до { $max }, спершу менше
program-start-to-point = від 0 (початок) до { $max }
program-after-start-to-point = after: від 0 (початок) до { $max }
program-start-to-last-point = від 0 (початок) до { $max } (остання точка)
program-positions-within = скінченні числа, положення в межах { $max } від початку координат
program-number-or-ramp = скінченне число або { "{" } from = .., to = .. { "}" }
program-leave-out = без них

# Programs and passes.
program-no-passes = у програмі немає проходів
program-pass-without-seam = прохід іде вздовж шва, але в програмі немає шва
program-seam-or-points = [seam] у програмі або [passes.points]
program-pass-without-spans = у проході немає ділянок
program-span-gap = ділянка не починається там, де закінчується попередня
program-span-empty = ділянка не має довжини
program-span-other-values = ділянка задає інші параметри процесу, ніж перша
program-min-speed-not-below = найменша швидкість не нижча за задану
program-below-span-speed = менше за speed_mm_s = { $max } кожної ділянки
program-too-many-passes = до цього проходу включно в програмі забагато проходів
program-too-many-rows = до цього проходу включно в програмі забагато рядків точок, валиків і ділянок
program-corner-choice = "refuse", "stop" або { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = пальник вийшов би за допуск шва
program-role-tack = прихватка
program-role-root = корінь
program-role-fill = заповнення
program-role-cap = лицювальний
program-role-cosmetic = косметичний

# Copies of the seam and work offsets.
program-copies-and-placement = копії мають власні розміщення
program-no-placement = без [placement] поруч із [[copies]]
program-name-taken = { $other } вже має цю назву
program-placement-taken = { $other } вже має це розміщення
program-own-placement = власне розміщення
program-no-such-copy = такої копії немає
program-no-copies = 0: у програмі немає [[copies]]
program-copy-index = від 0 до { $max }, номер у [[copies]]
program-offset-name-invalid = `{ $name }` — недопустима назва зсуву нуля деталі
program-offset-names = літери, цифри, - і _
program-offset-table = назва таблиці в цьому файлі, тут [offsets.{ $name }]

# Beads.
program-bead-empty = у валика немає рядків
program-bead-column-length = у стовпці { $rows ->
        [one] { $rows } рядок
        [few] { $rows } рядки
       *[many] { $rows } рядків
    }, у s_mm { $wanted }
program-path-lengths-increase = довжини шляху мають зростати
program-torch-behind-face = пальник опинився б за поверхнею
program-weave-part-above-one = частка понад 1 робить коливання ширшими, ніж у проходу
program-step-over-without-bead = переходу потрібен валик, від якого він іде
program-step-over-misplaced = перехід від { $from } до { $to } лежить не між попереднім і кінцем проходу

# Joints.
program-root-face-too-high = притуплення не лишає товщини для скосу
program-groove-angle-too-large = кут завеликий для розкриття
program-radius-too-large = радіус завеликий для глибини над притупленням
program-root-gap-too-wide = зазор у корені ширший за стінку і за саму розробку
program-mismatch-too-large = кромки не стоять одна навпроти одної: зміщення не менше за товщину стінки
program-nothing-filled = незаповнена глибина не лишає що заповнювати
program-fillet-size-unclear = розмір кутового шва незрозумілий
program-fillet-sizes = одне з leg_mm, throat_mm або разом first_leg_mm і second_leg_mm
program-bevel-angle-unclear = кут скосу незрозумілий
program-bevel-angles = або angle_deg (розкриття), або cut_deg (кромки)
program-positions-increase = положення мають зростати
program-depth-leaves-no-back = глибина з лицьового боку не залишає нічого для зворотного
program-fillet-implausible = кутових швів такого розміру не буває
program-cap-implausible = такого високого підсилення не буває
program-lap-leg-too-long = катет довший за кромку, на якій він лежить
program-gouge-on-face = стругання виконують лише зі зворотного боку
program-side-back = side = "back"
program-back-without-groove = зі зворотного боку немає розкриття
program-groove-on-back = двобічне розкриття або [joint.gouge] стикового з'єднання
program-gouge-through-wall = стругання проходить крізь стінку
program-gouge-angle-too-large = стінки стругання надто пологі
program-at-dihedral-without-edge = кут розкриття тут не йде за двогранним кутом
program-edge-on-face = t_bevel з angle_deg, t_double_bevel або t_j
program-at-dihedral-unequal = рядки за двогранним кутом задають різні величини
program-same-keys-in-rows = angle_deg, root_gap_mm або обидва, однакові в усіх рядках
program-dihedrals-increase = двогранні кути мають зростати
program-flare-root-gap = круглі деталі, що торкаються, не мають зазору в корені
program-layers-increase = вимірювання після меншої кількості шарів мають іти першими
program-fit-up-without-angle = такі кромки не мають кута розкриття
program-allowed-bevelled-kinds = без angle_deg, або single_v, bevel, u, j, t_bevel, t_j
program-fit-up-angle-invalid = кромки не утворюють розробку з таким кутом
program-remaining-before-weld = до зварювання відкрита вся розробка
program-allowed-after-layer = after_layer від 1
program-remaining-missing = бракує ще відкритої площі
program-allowed-remaining = з remaining_mm2

# Process values.
program-process-name-invalid = це недопустима назва параметра процесу
program-process-names = малі літери, цифри і _, у кінці одиниця, як current_a
program-column-name-taken = інший стовпець має цю назву
program-process-value-negative = параметр процесу від’ємний
program-process-value-too-large = `{ $name }` = { $value } — більше, ніж має будь-який зварювальний апарат
program-same-quantity = `{ $other }` — та сама величина в іншій одиниці: вони могли б суперечити одна одній
program-no-such-process-value = у шва немає такого параметра процесу
program-upslope-too-long = наростання триває довше, ніж на нього відведено часу
program-downslope-too-long = спад триває довше, ніж на нього відведено часу

# Weaving and oscillation.
program-weave-at-blend = кути не заокруглюються там, де пальник коливається
program-corner-or-no-weave = "refuse" чи "stop" або без коливань
program-weave-pitch-unclear = крок коливань незрозумілий
program-only-trapezoid-dwells = затримки бувають лише в трапеції
program-no-dwell-or-trapezoid = 0 або figure = "trapezoid"
program-dwell-needs-frequency = затримка в секундах потребує частоти
program-frequency-instead-of-pitch = frequency_hz замість pitch_mm
program-dwells-too-long = затримки не лишають часу на хід упоперек
program-dwells-together = разом до { $max }
program-weave-along-torch = коливання йшли б уздовж пальника
program-figure-without-length = ця фігура не має довжини
program-figures-with-length = без цього ключа або figure = "circle" чи "eight"
program-sides-not-steady = на боках сталі значення, а не рампи
program-weave-period-short = період коливань зайняв би лише { $pitch } шва
program-frequency-at-speed = до { $max } за { $speed }
program-weave-periods = коливання мали б періодів за один прохід: { $periods }
program-up-to-periods = періодів: до { $max }
program-weave-speed-jumps = швидкість стрибає на початку ділянки, а з нею й коливання, задані частотою
program-span-speed-or-pitch = ділянка, що починається з { $speed }, або коливання з pitch_mm
program-oscillation-gaps = промінь за період коливання проходить { $advance }, більше за свою пляму { $spot }: лишаються пропуски
program-cure-oscillation-gaps = задайте frequency_hz { $frequency } або більше, або варіть повільніше

# Passes through points.
program-pass-without-points = у проході немає точок
program-span-without-points = у ділянці немає точок
program-value-out-of-bounds = { $column } = { $value } поза межами
program-value-not-allowed = { $column } = { $value } тут не дозволено
program-column-twice = стовпець `{ $column }` є двічі
program-each-column-once = кожен стовпець один раз
program-last-column = останній стовпець, і лише він, задає час або швидкість точки
program-time-or-speed-last = останнім time_s або speed_mm_s
program-columns-without-position = стовпці не задають положення або задають два
program-position-columns = x_mm, y_mm, z_mm, з ax, ay, az або без них; або назви осей верстата
program-arc-in-span = дузі потрібне `via_mm`, і в неї одна точка
program-one-arc-per-span = одна дуга на ділянку, з `via_mm` посередині
program-arc-of-axes = положення осей ідуть дугою, лише якщо серед них є дві з x, y і z
program-only-arcs = цей ключ є лише в дуг
program-arc-or-leave-out = `along = "arc"` або без нього
program-speed-rows = { $rows ->
        [one] { $rows } рядок швидкостей
        [few] { $rows } рядки швидкостей
       *[many] { $rows } рядків швидкостей
    }
program-cubic-speeds = для кубічної кривої на один більше, ніж точок, перший на початку; інакше жодного
program-cubic-needs-times = кубічна крива потребує часів
program-time-last = останній стовпець `time_s`
program-speeds-for-columns = { $speeds ->
        [one] { $speeds } швидкість
        [few] { $speeds } швидкості
       *[many] { $speeds } швидкостей
    }, а стовпців положення { $columns }
program-numbers-for-columns = { $numbers ->
        [one] { $numbers } число
        [few] { $numbers } числа
       *[many] { $numbers } чисел
    }, а стовпців { $columns }
program-pace-zero = 0: це початок або якнайшвидше для осей
program-block-number = ціле число, 0 (без номера) або більше
program-direction-columns = напрям: ax, ay, az не всі 0
program-key-of-seam-passes = прохід іде через точки: цей ключ мають лише проходи вздовж шва
program-leave-out-key-or-points = без нього або без `points`
program-event-after-end = у проході менше точок
program-event-several = подія робить рівно одну дію
program-event-keys = одне з gas, wire, output (з on), message, call

# Procedures.
program-procedure-without-runs = у технології немає проходів
program-run-without-passes = прохід технології не вказує, яких проходів він стосується
program-run-passes-twice = прохід технології двічі вказує, яких проходів він стосується
program-run-names = або name = "tack", "root", "fill" чи "cap", або passes = "1", "2-5" і так далі
program-run-without-position = прохід технології не дозволяє жодного положення зварювання
program-run-positions = одне або кілька; без ключа дозволено всі
program-toe-angle-too-large = шов не може бути пласкішим, ніж урівень із деталлю
program-insert-without-root-faces = у це з'єднання вставка не ставиться
program-allowed-insert = вставка в стиковому з'єднанні з side = "face" і без підкладки
program-insert-area-missing = немає площі перерізу вставки
program-allowed-insert-area = area_mm2 або kind = "ring" чи "rectangular"
program-insert-too-high = вставка була б не нижчою за стінку
program-insert-gap = вставка завширшки { $width } не підходить до зазору { $gap }
program-not-a-process-value = це не параметр процесу
program-beside-ranges = { $key } поруч із `ranges`
program-ranges-in-table = межі параметрів процесу пишіть у [runs.ranges]
program-part-above-one = ця частка цілого більша за 1
program-carbon-invalid = вуглець { $found }: це не сталь
program-composition-sum = сума елементів { $sum }
program-material-group-invalid = { $group } не група матеріалів
program-material-groups = група за ISO/TR 15608: 1–11, 21–26, 31–38, 41–48, 51–54, 61, 62, 71–76, можна з підгрупою, наприклад "1.2"
program-material-unknown = у матеріалу немає ні складу, ні групи
program-composition-or-group = `composition` або `group`
program-interpass-one-of = для очікування потрібен час або температура, але не обидва
program-interpass-wait-or-below = `wait_s` або `below_c`
program-interpass-below-work = деталь ніколи не охолоне до { $found }
program-heat-flow-2d = двовимірний
program-heat-flow-3d = тривимірний
program-one-run-per-name = по одному проходу технології на назву
program-pass-in-two-runs = прохід { $pass } вже названо в { $other }
program-named-pass-in-two-runs = прохід { $pass } ({ $name }) вже є в { $other }
program-pass-in-one-run = кожен прохід лише в одному проході технології
program-no-pass-numbers = `{ $text }` не називає проходів
program-pass-named-twice = прохід { $pass } названо двічі
program-pass-numbers = числа від 1, як-от "1", "2-5" чи "1, 3-4", кожне один раз
program-limits-increase = межі мають зростати
program-hysteresis-too-large = жоден нахил не перевищує vertical_slope_deg настільки
program-no-power = добуток цих значень — не потужність
program-power-values = ["current_a", "voltage_v"], ["laser_w"]: одне у Вт чи кВт, або струм в А, мА чи кА і напруга у В чи кВ
program-window-order = найменше значення, { $min }, більше за найбільше, { $max }
program-window-negative = цей діапазон починається нижче 0
program-window = [найменше, найбільше]
program-processes = { $processes }
program-process = { $number } ({ $name })

# Jumps of the torch.
program-torch-direction-jumps = напрям пальника стрибнув би на { $jump } на куті s = { $s }
program-torch-tip-jumps = вістря пальника стрибнуло б на { $jump } на куті s = { $s }
program-cure-direction-jumps = нехай один прохід там закінчиться, а інший почнеться після (у завданні order.parts = "at_corners", прихватки деінде); або заокругліть кут у шві; стиковий шов варіть без кутів поперек і вздовж
program-cure-tip-jumps = нехай один прохід там закінчиться, а інший почнеться після (у завданні order.parts = "at_corners", прихватки деінде), або заокругліть кут у шві

# Variables and expressions.
program-expression = "= вираз"
program-expression-lines = вираз лишається в одному рядку
program-expression-grammar = числа, назви змінних, + - * / і дужки
program-expression-rest = `{ $text }` незрозуміле
program-expression-ends = вираз закінчується там, де мало б бути число або назва
program-unexpected-character = `{ $text }` стоїть там, де мало б бути число або назва
program-number-invalid = `{ $text }` — не число
program-nesting-too-deep = забагато вкладених дужок або знаків
program-parenthesis-missing = бракує закривної дужки
program-result-not-finite = результат нескінченний
program-finite-result = без ділення на 0 і чисел понад 1e308
program-not-a-number = це не число
program-variables-no-table = змінні — не таблиця
program-variables-table = [variables] з назва = число
program-variable-name-invalid = `{ $name }` — недопустима назва змінної
program-variable-names = літера або _, далі літери, цифри і _
program-no-variables = змінних не задано: [variables] з назва = число

# Refused edits.
program-edit-refused = зміну відхилено: документ лишається, як був; рядок — з результату
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = зміну не вписати в будову цього документа
program-usual-layout = будова, яку робить дія `format`
program-history-of-other-text = документ змінено після правки, і її результату в ньому вже немає
program-text-of-last-edit = документ, яким його лишила остання правка
program-history-line = рядок { $line }: { $fault }
program-history-empty = історія порожня
program-history-head = заголовок історії не відповідає її правкам
program-history-format = історія, яку пише `seamwright edit`, один об’єкт JSON на рядок
program-number-not-finite = число нескінченне або завелике
program-no-pass = проходу { $pass } немає
program-pass-along-seam = прохід { $pass } іде вздовж шва
program-pass-has-points = прохід { $pass } іде через точки
program-pass-through-points = прохід через точки
program-no-points = для цієї правки немає точок від { $from } до { $to }
program-nothing-to-set = не задано, що встановити
program-no-order-position = у порядку немає місця { $at }
program-only-pass = це єдиний прохід
program-no-event = події { $event } немає
program-pass-with-events = прохід із подіями
program-mirror-unclear = площини чи осі дзеркала не задано, або задано обидві
program-mirror-keys = `normal` з `at_mm` для поз, `axis` з `about` для положень осей
program-points-are-axes = точки проходу { $pass } — положення осей
program-points-are-poses = точки проходу { $pass } — пози
program-no-points-pass = жоден прохід не йде через точки
program-with-points = програма з [passes.points]
program-offset-of-axes = точки — положення осей: систему координат пальника знає лише верстат
program-points-with-poses = точки, що є позами
program-no-torch-frame = у точці { $point } пальник лежить уздовж шляху, або шлях не має напряму
program-torch-across-path = пальник поперек шляху
program-no-point = точки { $point } немає
program-no-number-given = не задано жодного числа
program-column-without-speed = `{ $column }` — не стовпець положення і швидкості не має
program-no-cubic-at-point = жодна кубічна крива не закінчується й не починається в точці { $point }
program-point-of-cubic = точка ділянки `cubic`
program-no-next-point = немає наступної точки, щоб стати посередині
program-no-point-left = не лишилося б жодної точки
program-keep-a-point = залиште щонайменше одну точку або видаліть прохід
program-points-without-xyz = у точок немає x, y і z для прямих і дуг
program-poses-or-xyz = пози або положення осей x, y і z
program-no-span = для цієї правки немає ділянки { $span }
program-pass-of-more-spans = прохід, у якому більше ділянок
program-rapid-with-arc = у цьому проході горить дуга: на швидкому ході не варять
program-ways-or-no-arc = line, arc, spline; або прохід з `arc = false`
program-pass-with-times = прохід, останній стовпець якого `time_s`
program-arc-of-points = дузі потрібні `via_mm` і одна точка; у ділянки їх { $points }
program-split-first = спершу поділіть ділянку; задайте `via_mm`
program-via-of-arcs = `via_mm` і `normal` належать дугам, а не `{ $along }`
program-rapid-without-pace = точки швидкого ходу не мають часу чи швидкості
program-pace = `pace`: час або швидкість до кожної точки
program-pace-given = точки вже мають час або швидкість
program-no-pace = без `pace`
program-no-split-at-point = у точці { $point } жодну ділянку не поділити
program-point-within-span = точка всередині ділянки, не остання
program-no-split-at-length = на { $s } жодну ділянку не поділити
program-length-within-span = довжина шляху всередині ділянки, не її кінець
program-split-unclear = місця поділу не задано, або воно не підходить до проходу
program-split-keys = `point` через точки, `s_mm` уздовж шва
program-spans-not-joined = ділянки { $first } і { $second } не продовжують одна одну
program-spans-that-join = однаковий хід (без дуг) і зупинки, кубічні криві з однаковими швидкостями; вздовж шва ті самі значення або рампи, що тривають
program-points-without-seam = прохід іде через точки: шва в нього немає
program-no-seam-length = без `seam_length_mm`
program-pass-over-start = прохід іде через початок шва
program-seam-length = `seam_length_mm`: шов варять по колу
program-start-point = `point`, з якої мають починатися замкнені точки
program-start-without-seam = у програмі немає шва, на якому починати
program-start-unclear = нового початку не задано, або задано двічі
program-start-keys = `pass` з `point`, або `pass` з `begin_mm`, або лише `phi_deg`
program-points-not-closed = точки не закінчуються там, де починаються
program-closed-points = замкнені точки: остання точка — це початок
program-no-range = у проході немає діапазону від { $from } до { $to }
program-range-of-points = `points` без `s_mm`
program-range-of-seam = `s_mm` без `points`
program-range-without-pass = діапазон потребує проходу
program-pass-with-range = `pass` з `points` або `s_mm`
program-speed-not-positive = швидкість не була б скінченним числом понад 0
program-other-factor = інший множник

# Edits that were made.
program-edit-formatted = відформатовано
program-edit-offset = чинний зсув нуля деталі: `{ $name }`
program-edit-no-offset = зсув нуля деталі не діє
program-edit-variable = змінна { $name } = { $value }
program-edit-variable-removed = змінну { $name } вилучено
program-edit-pass = прохід { $pass }: { $changes }
program-edit-pass-name = назва `{ $name }`
program-edit-pass-role = роль: { $role }
program-edit-arc-on = з дугою
program-edit-arc-off = без дуги
program-edit-repeat = зварити { $times ->
        [one] { $times } раз
        [few] { $times } рази
       *[many] { $times } разів
    }
program-edit-pass-added = прохід `{ $name }` додано
program-edit-pass-deleted = прохід { $pass } `{ $name }` видалено
program-edit-pass-moved = прохід { $pass } перенесено на місце { $to }
program-edit-pass-copied = прохід { $pass } скопійовано
program-edit-event-added = прохід { $pass }: подію додано після точки { $point }
program-edit-event-deleted = прохід { $pass }: подію { $event } видалено
program-edit-mirrored = віддзеркалено
program-edit-moved = прохід { $pass } зсунуто
program-edit-point = прохід { $pass }, точка { $point }: задано { $columns }
program-edit-speed-of = швидкість { $column }
program-edit-point-inserted = прохід { $pass }: точку вставлено після { $after }
program-edit-points-deleted = прохід { $pass }: точки від { $from } до { $to } видалено
program-edit-reduced = прохід { $pass }: { $before ->
        [one] { $before } точку
        [few] { $before } точки
       *[many] { $before } точок
    } зведено до { $after }
program-edit-along = прохід { $pass }, ділянка { $span }: { $along }
program-edit-span-split = прохід { $pass }: ділянку { $span } поділено
program-edit-spans-joined = прохід { $pass }: ділянки { $first } і { $second } з’єднано
program-edit-reversed = прохід { $pass } обернено
program-edit-pass-start = прохід { $pass } починається на { $s }
program-edit-pass-start-point = прохід { $pass } починається в точці { $point }
program-edit-weld-start = шов починається на { $phi }
program-edit-speed = швидкість помножено на { $factor }
program-edit-process = прохід { $pass }: { $name } задано
program-edit-numbered = точки пронумеровано
