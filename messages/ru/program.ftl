# Allowed values.
program-less-than-key = меньше { $key } = { $max }
program-up-to-key = до { $key } = { $max }
program-positive-up-to-key = больше 0, до { $key } = { $max }
program-up-to-in-all = всего до { $max }
program-either = либо { $first }, либо { $second }
program-at-least-one = хотя бы одна
program-at-least-one-table = хотя бы одна { $table }
program-at-least-one-pass = в программе есть хотя бы один проход
program-at-least-one-point = хотя бы один участок хотя бы с одной точкой
program-at-least-one-path-length = хотя бы одна длина пути
program-at-least-one-column = хотя бы один столбец = число
program-numbers = { $numbers ->
        [one] { $numbers } число
        [few] { $numbers } числа
       *[many] { $numbers } чисел
    }
program-one-for-each = по одному на каждый
program-one-for-each-of = по одному на каждый из { $columns }
program-range-in-order = от { $min } до { $max }, сначала меньшее
program-start-to-point = от 0 (начало) до { $max }
program-after-start-to-point = after: от 0 (начало) до { $max }
program-start-to-last-point = от 0 (начало) до { $max } (последняя точка)
program-positions-within = конечные числа, положения в пределах { $max } от начала координат
program-number-or-ramp = конечное число или { "{" } from = .., to = .. { "}" }
program-leave-out = без них

# Programs and passes.
program-no-passes = в программе нет проходов
program-pass-without-seam = проход идёт вдоль шва, но в программе нет шва
program-seam-or-points = [seam] в программе или [passes.points]
program-pass-without-spans = в проходе нет участков
program-span-gap = участок не начинается там, где кончается предыдущий
program-span-empty = участок не имеет длины
program-span-other-values = участок задаёт не те параметры процесса, что первый
program-min-speed-not-below = минимальная скорость не ниже заданной
program-below-span-speed = меньше speed_mm_s = { $max } каждого участка
program-too-many-passes = по этот проход включительно в программе слишком много проходов
program-too-many-rows = по этот проход включительно в программе слишком много строк точек, валиков и участков
program-corner-choice = "refuse", "stop" или { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = горелка вышла бы за допуск шва
program-role-tack = прихватка
program-role-root = корень
program-role-fill = заполнение
program-role-cap = облицовка
program-role-cosmetic = косметический

# Copies of the seam and work offsets.
program-copies-and-placement = у копий свои размещения
program-no-placement = без [placement] рядом с [[copies]]
program-name-taken = { $other } уже имеет это имя
program-placement-taken = { $other } уже имеет это размещение
program-own-placement = своё размещение
program-no-such-copy = такой копии нет
program-no-copies = 0: в программе нет [[copies]]
program-copy-index = от 0 до { $max }, номер в [[copies]]
program-offset-name-invalid = `{ $name }` — недопустимое имя смещения нуля детали
program-offset-names = буквы, цифры, - и _
program-offset-table = имя таблицы в этом файле, здесь [offsets.{ $name }]

# Beads.
program-bead-empty = у валика нет строк
program-bead-column-length = в столбце { $rows ->
        [one] { $rows } строка
        [few] { $rows } строки
       *[many] { $rows } строк
    }, в s_mm { $wanted }
program-path-lengths-increase = длины пути должны возрастать
program-torch-behind-face = горелка оказалась бы за поверхностью
program-weave-part-above-one = доля больше 1 делает колебания шире, чем у прохода
program-step-over-without-bead = переходу нужен валик, от которого он идёт
program-step-over-misplaced = переход от { $from } до { $to } лежит не между предыдущим и концом прохода

# Joints.
program-root-face-too-high = притупление не оставляет толщины для скоса
program-groove-angle-too-large = угол слишком велик для разделки
program-radius-too-large = радиус слишком велик для глубины над притуплением
program-root-gap-too-wide = зазор в корне шире стенки и самой разделки
program-mismatch-too-large = кромки не стоят друг против друга: смещение не меньше толщины стенки
program-nothing-filled = незаполненная глубина не оставляет что заполнять
program-fillet-size-unclear = размер углового шва неясен
program-fillet-sizes = одно из leg_mm, throat_mm или вместе first_leg_mm и second_leg_mm
program-bevel-angle-unclear = угол скоса неясен
program-bevel-angles = либо angle_deg (разделки), либо cut_deg (кромки)
program-positions-increase = положения должны возрастать
program-depth-leaves-no-back = глубина с лицевой стороны не оставляет ничего для обратной
program-fillet-implausible = угловых швов такого размера не бывает
program-cap-implausible = такого высокого усиления не бывает
program-lap-leg-too-long = катет длиннее кромки, на которой он лежит
program-gouge-on-face = строжка выполняется только с обратной стороны
program-side-back = side = "back"
program-back-without-groove = с обратной стороны нет разделки
program-groove-on-back = двусторонняя разделка или [joint.gouge] стыкового соединения
program-gouge-through-wall = строжка проходит сквозь стенку
program-gouge-angle-too-large = стенки строжки слишком пологие
program-at-dihedral-without-edge = угол разделки здесь не следует двугранному углу
program-edge-on-face = t_bevel с angle_deg, t_double_bevel или t_j
program-at-dihedral-unequal = строки по двугранному углу задают разные величины
program-same-keys-in-rows = angle_deg, root_gap_mm или обе, одинаковые во всех строках
program-dihedrals-increase = двугранные углы должны возрастать
program-flare-root-gap = круглые детали, которые касаются, не имеют зазора в корне
program-layers-increase = измерения после меньшего числа слоёв должны идти первыми
program-fit-up-without-angle = у таких кромок нет угла разделки
program-allowed-bevelled-kinds = без angle_deg, или single_v, bevel, u, j, t_bevel, t_j
program-fit-up-angle-invalid = кромки не образуют разделку с таким углом
program-remaining-before-weld = до сварки открыта вся разделка
program-allowed-after-layer = after_layer от 1
program-remaining-missing = нет ещё открытой площади
program-allowed-remaining = с remaining_mm2

# Process values.
program-process-name-invalid = это недопустимое имя параметра процесса
program-process-names = строчные буквы, цифры и _, в конце единица, как current_a
program-column-name-taken = другой столбец имеет это имя
program-process-value-negative = параметр процесса отрицателен
program-process-value-too-large = `{ $name }` = { $value } — больше, чем у любого сварочного аппарата
program-same-quantity = `{ $other }` — та же величина в другой единице: они могли бы противоречить друг другу
program-no-such-process-value = у шва нет такого параметра процесса
program-upslope-too-long = нарастание длится дольше отведённого времени
program-downslope-too-long = спад длится дольше отведённого времени

# Weaving and oscillation.
program-weave-at-blend = углы не скругляются там, где горелка колеблется
program-corner-or-no-weave = "refuse" или "stop", либо без колебаний
program-weave-pitch-unclear = шаг колебаний неясен
program-only-trapezoid-dwells = задержки бывают только у трапеции
program-no-dwell-or-trapezoid = 0 или figure = "trapezoid"
program-dwell-needs-frequency = задержка в секундах требует частоты
program-frequency-instead-of-pitch = frequency_hz вместо pitch_mm
program-dwells-too-long = задержки не оставляют времени на ход поперёк
program-dwells-together = вместе до { $max }
program-weave-along-torch = колебания шли бы вдоль горелки
program-figure-without-length = у этой фигуры нет длины
program-figures-with-length = без этого ключа или figure = "circle" либо "eight"
program-sides-not-steady = на боках постоянные значения, а не рампы
program-weave-period-short = период колебаний занял бы лишь { $pitch } шва
program-frequency-at-speed = до { $max } при { $speed }
program-weave-periods = периодов колебаний за один проход было бы { $periods }
program-up-to-periods = периодов: до { $max }
program-weave-speed-jumps = скорость скачком меняется в начале участка, а с ней и колебания, заданные частотой
program-span-speed-or-pitch = участок, который начинается с { $speed }, или колебания с pitch_mm
program-oscillation-gaps = луч за период колебания проходит { $advance }, больше своего пятна { $spot }: остаются пропуски
program-cure-oscillation-gaps = задайте frequency_hz { $frequency } или больше, или варите медленнее

# Passes through points.
program-pass-without-points = в проходе нет точек
program-span-without-points = в участке нет точек
program-value-out-of-bounds = { $column } = { $value } за пределами
program-value-not-allowed = { $column } = { $value } здесь не разрешено
program-column-twice = столбец `{ $column }` есть дважды
program-each-column-once = каждый столбец один раз
program-last-column = последний столбец, и только он, задаёт время или скорость точки
program-time-or-speed-last = последним time_s или speed_mm_s
program-columns-without-position = столбцы не задают положения или задают два
program-position-columns = x_mm, y_mm, z_mm, с ax, ay, az или без них; или имена осей станка
program-arc-in-span = дуге нужно `via_mm`, и у неё одна точка
program-one-arc-per-span = одна дуга на участок, с `via_mm` посередине
program-arc-of-axes = положения осей идут по дуге, только если среди них есть две из x, y и z
program-only-arcs = этот ключ есть только у дуг
program-arc-or-leave-out = `along = "arc"` или без него
program-speed-rows = { $rows ->
        [one] { $rows } строка скоростей
        [few] { $rows } строки скоростей
       *[many] { $rows } строк скоростей
    }
program-cubic-speeds = для кубической кривой на одну больше, чем точек, первая в начале; иначе ни одной
program-cubic-needs-times = кубической кривой нужны времена
program-time-last = последний столбец `time_s`
program-speeds-for-columns = { $speeds ->
        [one] { $speeds } скорость
        [few] { $speeds } скорости
       *[many] { $speeds } скоростей
    }, а столбцов положения { $columns }
program-numbers-for-columns = { $numbers ->
        [one] { $numbers } число
        [few] { $numbers } числа
       *[many] { $numbers } чисел
    }, а столбцов { $columns }
program-pace-zero = 0: это начало или как можно быстрее для осей
program-block-number = целое число, 0 (без номера) или больше
program-direction-columns = направление: ax, ay, az не все 0
program-key-of-seam-passes = проход идёт через точки: этот ключ есть только у проходов вдоль шва
program-leave-out-key-or-points = без него или без `points`
program-event-after-end = в проходе меньше точек
program-event-several = событие делает ровно одно действие
program-event-keys = одно из gas, wire, output (с on), message, call

# Procedures.
program-procedure-without-runs = у технологии нет проходов
program-run-without-passes = проход технологии не указывает, к каким проходам он относится
program-run-passes-twice = проход технологии дважды указывает, к каким проходам он относится
program-run-names = либо name = "tack", "root", "fill" или "cap", либо passes = "1", "2-5" и так далее
program-run-without-position = проход технологии не разрешает ни одного положения сварки
program-run-positions = одно или несколько; без ключа разрешены все
program-toe-angle-too-large = шов не может быть площе, чем вровень с деталью
program-insert-without-root-faces = в это соединение вставка не ставится
program-allowed-insert = вставка в стыковом соединении с side = "face" и без подкладки
program-insert-area-missing = нет площади сечения вставки
program-allowed-insert-area = area_mm2 либо kind = "ring" или "rectangular"
program-insert-too-high = вставка была бы не ниже стенки
program-insert-gap = вставка шириной { $width } не подходит к зазору { $gap }
program-not-a-process-value = это не параметр процесса
program-beside-ranges = { $key } рядом с `ranges`
program-ranges-in-table = пределы параметров процесса пишите в [runs.ranges]
program-part-above-one = эта доля целого больше 1
program-carbon-invalid = углерод { $found }: это не сталь
program-composition-sum = сумма элементов { $sum }
program-material-group-invalid = { $group } не группа материалов
program-material-groups = группа по ISO/TR 15608: 1–11, 21–26, 31–38, 41–48, 51–54, 61, 62, 71–76, можно с подгруппой, например "1.2"
program-material-unknown = у материала нет ни состава, ни группы
program-composition-or-group = `composition` или `group`
program-interpass-one-of = для ожидания нужно время или температура, но не оба
program-interpass-wait-or-below = `wait_s` или `below_c`
program-interpass-below-work = деталь никогда не остынет до { $found }
program-heat-flow-2d = двумерный
program-heat-flow-3d = трёхмерный
program-one-run-per-name = по одному проходу технологии на имя
program-pass-in-two-runs = проход { $pass } уже назван в { $other }
program-named-pass-in-two-runs = проход { $pass } ({ $name }) уже есть в { $other }
program-pass-in-one-run = каждый проход лишь в одном проходе технологии
program-no-pass-numbers = `{ $text }` не называет проходов
program-pass-named-twice = проход { $pass } назван дважды
program-pass-numbers = числа от 1, например "1", "2-5" или "1, 3-4", каждое один раз
program-limits-increase = пределы должны возрастать
program-hysteresis-too-large = ни один наклон не превышает vertical_slope_deg настолько
program-no-power = произведение этих значений — не мощность
program-power-values = ["current_a", "voltage_v"], ["laser_w"]: одно в Вт или кВт, либо ток в А, мА или кА и напряжение в В или кВ
program-window-order = наименьшее значение, { $min }, больше наибольшего, { $max }
program-window-negative = этот диапазон начинается ниже 0
program-window = [наименьшее, наибольшее]
program-processes = { $processes }
program-process = { $number } ({ $name })

# Jumps of the torch.
program-torch-direction-jumps = направление горелки изменилось бы скачком на { $jump } на углу s = { $s }
program-torch-tip-jumps = остриё горелки сместилось бы скачком на { $jump } на углу s = { $s }
program-cure-direction-jumps = пусть один проход там закончится, а другой начнётся после (в задании order.parts = "at_corners", прихватки в другом месте); или скруглите угол в шве; стыковой шов варите без поперечного и продольного углов
program-cure-tip-jumps = пусть один проход там закончится, а другой начнётся после (в задании order.parts = "at_corners", прихватки в другом месте), или скруглите угол в шве

# Variables and expressions.
program-expression = "= выражение"
program-expression-lines = выражение остаётся в одной строке
program-expression-grammar = числа, имена переменных, + - * / и скобки
program-expression-rest = `{ $text }` непонятно
program-expression-ends = выражение кончается там, где должно быть число или имя
program-unexpected-character = `{ $text }` стоит там, где должно быть число или имя
program-number-invalid = `{ $text }` — не число
program-nesting-too-deep = слишком много вложенных скобок или знаков
program-parenthesis-missing = не хватает закрывающей скобки
program-result-not-finite = результат не конечен
program-finite-result = без деления на 0 и чисел больше 1e308
program-not-a-number = это не число
program-variables-no-table = переменные — не таблица
program-variables-table = [variables] с имя = число
program-variable-name-invalid = `{ $name }` — недопустимое имя переменной
program-variable-names = буква или _, затем буквы, цифры и _
program-no-variables = переменные не заданы: [variables] с имя = число

# Refused edits.
program-edit-refused = изменение отклонено: документ остаётся, как был; строка — из результата
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = изменение не вписать в строение этого документа
program-usual-layout = строение, которое делает действие `format`
program-history-of-other-text = документ изменён после правки, и её результата в нём больше нет
program-text-of-last-edit = документ, каким его оставила последняя правка
program-history-line = строка { $line }: { $fault }
program-history-empty = история пуста
program-history-head = заголовок истории не соответствует её правкам
program-history-format = история, какую пишет `seamwright edit`, один объект JSON на строку
program-number-not-finite = число не конечно или слишком велико
program-no-pass = прохода { $pass } нет
program-pass-along-seam = проход { $pass } идёт вдоль шва
program-pass-has-points = проход { $pass } идёт через точки
program-pass-through-points = проход через точки
program-no-points = для этой правки нет точек от { $from } до { $to }
program-nothing-to-set = не задано, что установить
program-no-order-position = в порядке нет места { $at }
program-only-pass = это единственный проход
program-no-event = события { $event } нет
program-pass-with-events = проход с событиями
program-mirror-unclear = плоскость или ось отражения не задана, или заданы обе
program-mirror-keys = `normal` с `at_mm` для поз, `axis` с `about` для положений осей
program-points-are-axes = точки прохода { $pass } — положения осей
program-points-are-poses = точки прохода { $pass } — позы
program-no-points-pass = ни один проход не идёт через точки
program-with-points = программа с [passes.points]
program-offset-of-axes = точки — положения осей: систему координат горелки знает только станок
program-points-with-poses = точки, заданные позами
program-no-torch-frame = в точке { $point } горелка лежит вдоль пути, или у пути нет направления
program-torch-across-path = горелка поперёк пути
program-no-point = точки { $point } нет
program-no-number-given = не задано ни одного числа
program-column-without-speed = `{ $column }` — не столбец положения и скорости не имеет
program-no-cubic-at-point = ни одна кубическая кривая не кончается и не начинается в точке { $point }
program-point-of-cubic = точка участка `cubic`
program-no-next-point = нет следующей точки, чтобы встать посередине
program-no-point-left = не осталось бы ни одной точки
program-keep-a-point = оставьте хотя бы одну точку или удалите проход
program-points-without-xyz = у точек нет x, y и z для прямых и дуг
program-poses-or-xyz = позы или положения осей x, y и z
program-no-span = для этой правки нет участка { $span }
program-pass-of-more-spans = проход, в котором больше участков
program-rapid-with-arc = в этом проходе горит дуга: на ускоренном ходу не варят
program-ways-or-no-arc = line, arc, spline; или проход с `arc = false`
program-pass-with-times = проход, последний столбец которого `time_s`
program-arc-of-points = дуге нужны `via_mm` и одна точка; у участка их { $points }
program-split-first = сначала разделите участок; задайте `via_mm`
program-via-of-arcs = `via_mm` и `normal` относятся к дугам, а не к `{ $along }`
program-rapid-without-pace = у точек ускоренного хода нет времени или скорости
program-pace = `pace`: время или скорость до каждой точки
program-pace-given = у точек уже есть время или скорость
program-no-pace = без `pace`
program-no-split-at-point = в точке { $point } ни один участок не разделить
program-point-within-span = точка внутри участка, не последняя
program-no-split-at-length = на { $s } ни один участок не разделить
program-length-within-span = длина пути внутри участка, не его конец
program-split-unclear = место разделения не задано или не подходит к проходу
program-split-keys = `point` через точки, `s_mm` вдоль шва
program-spans-not-joined = участки { $first } и { $second } не продолжают друг друга
program-spans-that-join = одинаковый ход (без дуг) и остановки, кубические кривые с одинаковыми скоростями; вдоль шва те же значения или продолжающиеся рампы
program-points-without-seam = проход идёт через точки: шва у него нет
program-no-seam-length = без `seam_length_mm`
program-pass-over-start = проход идёт через начало шва
program-seam-length = `seam_length_mm`: шов варят по кругу
program-start-point = `point`, с которой должны начинаться замкнутые точки
program-start-without-seam = в программе нет шва, на котором начинать
program-start-unclear = новое начало не задано или задано дважды
program-start-keys = `pass` с `point`, или `pass` с `begin_mm`, или только `phi_deg`
program-points-not-closed = точки не кончаются там, где начинаются
program-closed-points = замкнутые точки: последняя точка — это начало
program-no-range = в проходе нет диапазона от { $from } до { $to }
program-range-of-points = `points` без `s_mm`
program-range-of-seam = `s_mm` без `points`
program-range-without-pass = диапазону нужен проход
program-pass-with-range = `pass` с `points` или `s_mm`
program-speed-not-positive = скорость не была бы конечным числом больше 0
program-other-factor = другой множитель

# Edits that were made.
program-edit-formatted = отформатировано
program-edit-offset = действующее смещение нуля детали: `{ $name }`
program-edit-no-offset = смещение нуля детали не действует
program-edit-variable = переменная { $name } = { $value }
program-edit-variable-removed = переменная { $name } удалена
program-edit-pass = проход { $pass }: { $changes }
program-edit-pass-name = имя `{ $name }`
program-edit-pass-role = роль: { $role }
program-edit-arc-on = с дугой
program-edit-arc-off = без дуги
program-edit-repeat = сварить { $times ->
        [one] { $times } раз
        [few] { $times } раза
       *[many] { $times } раз
    }
program-edit-pass-added = проход `{ $name }` добавлен
program-edit-pass-deleted = проход { $pass } `{ $name }` удалён
program-edit-pass-moved = проход { $pass } перенесён на место { $to }
program-edit-pass-copied = проход { $pass } скопирован
program-edit-event-added = проход { $pass }: событие добавлено после точки { $point }
program-edit-event-deleted = проход { $pass }: событие { $event } удалено
program-edit-mirrored = отражено
program-edit-moved = проход { $pass } сдвинут
program-edit-point = проход { $pass }, точка { $point }: задано { $columns }
program-edit-speed-of = скорость { $column }
program-edit-point-inserted = проход { $pass }: точка вставлена после { $after }
program-edit-points-deleted = проход { $pass }: точки от { $from } до { $to } удалены
program-edit-reduced = проход { $pass }: { $before ->
        [one] { $before } точка сведена
        [few] { $before } точки сведены
       *[many] { $before } точек сведено
    } к { $after }
program-edit-along = проход { $pass }, участок { $span }: { $along }
program-edit-span-split = проход { $pass }: участок { $span } разделён
program-edit-spans-joined = проход { $pass }: участки { $first } и { $second } соединены
program-edit-reversed = проход { $pass } обращён
program-edit-pass-start = проход { $pass } начинается на { $s }
program-edit-pass-start-point = проход { $pass } начинается в точке { $point }
program-edit-weld-start = шов начинается на { $phi }
program-edit-speed = скорость умножена на { $factor }
program-edit-process = проход { $pass }: { $name } задано
program-edit-numbered = точки пронумерованы
