# Positions on the weld, and torch angles.
weld-position-beside-weld = эта позиция не на шве
weld-positions-must-increase = позиции должны возрастать
weld-without-length = шов не имеет длины
weld-angles-twice = углы заданы и постоянными, и в нескольких позициях
weld-travel-angle-too-large = горелка лежала бы вдоль шва
weld-work-angle-too-large = горелка лежала бы за поверхностью
weld-torch-search-too-wide = поиск углов горелки выходит за пределы возможного
weld-stick-out-range = с таким вылетом не варит ни одна горелка
weld-stick-out-of-machine = вылет проволоки у горелки станка неизвестен, поэтому её нельзя отвести для другого
weld-stick-out-above-search = поиск не может увеличить вылет до этого значения: без него уже { $own }
weld-allowed-stick-out = `stick_out_mm` в [torch] файла станка: проволока между наконечником и точкой горелки
weld-min-speed-too-high = минимальная скорость не ниже скорости сварки
weld-speed-below-min = скорость сварки не выше минимальной
weld-value-ramps-already = это значение уже меняется по всему шву

# Allowed values of these.
weld-allowed-from-less-than = { $min } или больше, меньше { $max }
weld-allowed-positions-increasing = возрастающие позиции
weld-allowed-path-lengths-increasing = возрастающие длины пути
weld-allowed-seam-with-length = шов, имеющий длину
weld-allowed-angles-once = либо постоянные углы, либо [[torch.at]]
weld-allowed-travel-angle = от { $min } (углом вперёд) до { $max } (углом назад)
weld-allowed-number-or-no-value = число в [weld.process] или здесь без значения
weld-allowed-less-than-key = меньше { $key } = { $value }
weld-allowed-more-than-key = больше { $key } = { $value }
weld-allowed-positive-less-than-key = больше 0 и меньше { $key } = { $value }
weld-allowed-positive-less-than-half-key = больше 0 и меньше половины { $key } = { $value }
weld-allowed-not-along = не вдоль `{ $key }`
weld-allowed-other-point = другая точка, чем `{ $key }`
weld-allowed-schema = согласованные между собой размеры (см. схему файлов заданий)

# Bodies that nozzles stand on.
weld-body-cylinder = цилиндр, радиус { $radius }
weld-body-cone = конус, половинный угол { $angle }
weld-body-sphere = сфера, радиус { $radius }
weld-body-ellipsoid = эллипсоид, полуоси { $a }, { $b }, { $c }
weld-body-plane = плоскость, нормаль смотрит из пластины наружу
weld-body-torus = отвод трубы, радиус трубы { $radius }
weld-body-torispherical-head = торосферическое днище, наружный диаметр { $diameter }
weld-body-ellipsoidal-head = эллиптическое днище, наружный диаметр { $diameter }
weld-body-hemispherical-head = полусферическое днище, наружный диаметр { $diameter }
weld-body-flat-head = плоское днище, наружный диаметр { $diameter }
weld-body-conical-head = коническое днище, наружный диаметр { $diameter }
weld-body-inside = внутренняя поверхность стенки; снаружи: { $body }
weld-allowed-nozzle-fits = штуцер, который умещается на теле: { $body }
weld-allowed-nozzle-axis = ось, пересекающая тело: { $body }
weld-allowed-nozzle-on-body = радиус и ось, при которых вся стенка (радиус { $radius }) лежит на теле: { $body }
weld-allowed-nozzle-on-head = штуцер, вся стенка которого (радиус { $radius }) лежит на днище с его цилиндрическим бортом: { $body }
weld-allowed-nozzle-smaller = штуцер меньше тела: { $body }
weld-allowed-nozzle-direction = направление из тела наружу: { $body }
weld-cone-angle-too-large = половинный угол конуса слишком велик
weld-torus-meets-itself = труба сошлась бы сама с собой в середине отвода
weld-set-in-wall-missing = штуцер вставлен: не хватает толщины стенки тела
weld-set-on-root-wall-missing = корень приставного штуцера у его отверстия: не хватает толщины стенки
weld-wall-leaves-no-room = стенка не оставляет места внутри
weld-wall-leaves-no-bore = стенка не оставляет отверстия
weld-knuckle-too-large = отбортовка с внутренним радиусом { $radius } не умещается в цилиндрическом борте
weld-allowed-knuckle = внутренний радиус отбортовки меньше радиуса борта { $max }
weld-head-radii-missing = не хватает радиусов сферы и отбортовки
weld-allowed-head-radii = `standard` ("din_28011", "din_28013" или "asme_fd") либо вместе `crown_radius_mm` и `knuckle_radius_mm`
weld-crown-too-curved = сфера не площе полусферы
weld-allowed-crown = больше внутреннего радиуса борта, { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = ответвление лежит вдоль пояса
weld-branch-wider-than-chord = ответвление такое же широкое, как пояс, или шире
weld-branch-past-chord = стенка ответвления выходит за пояс
weld-branches-do-not-part = два ответвления параллельны или входят друг в друга
weld-branch-position-missing = не хватает позиции второго ответвления
weld-branch-position-twice = позиция второго ответвления задана дважды
weld-allowed-tube = труба
weld-allowed-tubes-meet = трубы, стенки которых сходятся кругом: меньшее ответвление или меньшее перекрытие
weld-allowed-other-branch-angle = меньше { $max } при первом ответвлении под { $first }: оси должны расходиться
weld-allowed-gap-or-offset = ровно одно из `gap_mm` (между краями; отрицательное при перекрытии) и `offset_mm` (между осями)
weld-allowed-branch-within-chord = ответвление в пределах пояса
weld-allowed-eccentricity = больше { $min } и меньше { $max }: chord_radius_mm - radius_mm
weld-cut-along-tube = срез идёт вдоль трубы: его нормаль отклонена на { $angle } от оси
weld-allowed-cut-angle = до { $max } от `direction`
weld-allowed-other-plane = другая плоскость

# Shapes of seams.
weld-seam-too-long = шов имел бы длину { $length }
weld-allowed-smooth-seam = плавный шов
weld-zero-direction-along-normal = нулевое направление лежит вдоль нормали
weld-arc-normal-off = плоскость трёх точек отклонена на { $angle } от этой нормали
weld-allowed-arc-normal = перпендикулярно этой плоскости: { $normal } или наоборот
weld-allowed-point-off-line-or-line-seam = точка вне прямой от начала до конца; прямой шов — [seam.line]
weld-allowed-point-off-line = точка вне прямой от начала до конца или без этого ключа
weld-corner-radius-too-large = радиус угла больше половины меньшей стороны
weld-point-count = шов имеет { $count ->
        [one] { $count } точку
        [few] { $count } точки
       *[many] { $count } точек
    }
weld-allowed-point-count = от { $min } до { $max } точек, здесь или в файле (`file`)
weld-point-above-plate = эта точка на { $height } выше пластины
weld-point-below-plate = эта точка на { $height } ниже пластины
weld-allowed-point-in-plane = точка в плоскости через первую с этой `normal`
weld-point-repeated = эта точка совпадает с предыдущей
weld-last-point-repeated = последняя точка совпадает с первой; шов замыкается и без неё
weld-spline-point-repeated = точка { $point } совпадает с предыдущей
weld-spline-last-point-repeated = последняя точка, { $point }, совпадает с первой; шов замыкается и без неё
weld-allowed-points-apart = точки в разных позициях
weld-allowed-points-apart-by = точки не ближе { $min } друг к другу
weld-allowed-leave-point-out = без этой точки
weld-allowed-other-points = другие точки
weld-normal-not-square = нормаль поверхности не перпендикулярна шву
weld-allowed-square-to-line = перпендикулярно end_mm - start_mm
weld-faces-opposed = поверхности смотрят друг на друга: соединение недостижимо
weld-spline-faces-opposed = точка { $point }: поверхности смотрят друг на друга, соединение недостижимо
weld-allowed-not-opposite = не противоположно `{ $key }`
weld-helix-without-pitch = винтовая линия без шага — это окружность
weld-allowed-pitch = не 0; для шва вокруг трубы — [seam.girth]
weld-helix-too-long = у винтовой линии слишком много оборотов
weld-allowed-less-turn = меньшие повороты от точки к точке
weld-allowed-normals-less-turn = нормали, поворачивающиеся менее чем на 90° от точки к точке
weld-normal-along-seam = нормаль поверхности где-то лежит вдоль шва
weld-allowed-normals-across = нормали поперёк шва
weld-closed-seam-has-no-ends = замкнутый шов не имеет концов
weld-allowed-no-key-closed = без этого ключа при `closed = true`
weld-tangent-backwards = касательная смотрит назад, от следующей точки шва
weld-allowed-welding-direction = направление в сторону сварки
weld-normal-count = нормалей: { $normals }, точек: { $points }
weld-allowed-one-per-point = по одной на точку
weld-second-normals-alone = `second_normals` требуют `first_normals`
weld-allowed-first-normals-too = также `first_normals`
weld-normal-twice = у каждой точки уже есть своя нормаль
weld-allowed-one-or-all-normals = либо одна нормаль, либо по одной на точку
weld-allowed-other-normals = другие нормали
weld-skin-normal-along-web = нормаль обшивки лежит вдоль ребра
weld-allowed-out-of-skin = направление от обшивки
weld-allowed-thin-web = ребро, намного тоньше радиуса дуги
weld-seam-without-surfaces = { $seam } не имеет поверхностей, к которым можно подогнать точки
weld-seam-curved-t-joint = криволинейное тавровое соединение
weld-seam-arc = дуга
weld-seam-rectangle = прямоугольник
weld-seam-helix = винтовая линия
weld-seam-inside-girth = кольцевой шов внутри трубы
weld-seam-spline = сплайн
weld-seam-polyline = ломаная
weld-allowed-fit-methods = методы three-point и plane-line-point

# Start and end of the weld.
weld-phi-too-large = угол больше десяти оборотов
weld-overlap-with-end = шов до `end_phi_deg` не замыкается и не имеет перекрытия
weld-allowed-overlap-or-end = либо `overlap_mm`, либо `end_phi_deg`
weld-end-beside-turn = шов не имел бы длины или имел бы больше оборота
weld-allowed-end-phi-more = больше phi_deg = { $start }, самое большее на { $max }
weld-allowed-end-phi-less = меньше phi_deg = { $start }, самое большее на { $max }
weld-overlap-too-long = перекрытие длиннее шва
weld-start-at-first-point = этот шов начинается в первой точке и идёт ко второй
weld-allowed-points-in-other-order = без этого ключа; задайте точки в другом порядке
weld-start-of-open-seam = этот шов идёт от одного конца до другого и не замыкается
weld-allowed-no-key-on-open-seam = без этого ключа на незамкнутом шве

# Data outside the file.
weld-no-machine-here = здесь нет станка
weld-allowed-tip-coordinates = координаты острия x_mm, y_mm, z_mm
weld-no-files-here = здесь нет файлов
weld-points-twice = точки заданы дважды
weld-allowed-points-or-axes = либо `points_mm`, либо `axes`
weld-position-not-finite = позиция не конечна
weld-allowed-finite-numbers = конечные числа
weld-file-and-points = заданы и файл, и `{ $key }`
weld-allowed-points-in-file-or-job = точки и их нормали в файле или в задании
weld-table-point-not-finite = { $file }: точка { $point } не конечна
weld-table-normal-without-length = { $file }: нормаль точки { $point } не имеет длины
weld-allowed-coordinates-and-normals = конечные координаты и нормали с длиной
weld-procedure-unreadable = файл технологии не читается: { $error }
weld-allowed-procedure = { $names } или путь к файлу технологии от папки задания
weld-procedure-not-text = это не текстовый файл
weld-allowed-toml = файл TOML в UTF-8
weld-wrong-wire = по { $procedure } сваривают проволокой { $wire }
weld-two-wires = `{ $other }` = { $wire }: у проволоки один диаметр
weld-allowed-wire = { $wire } или другая технология

# Taught spans.
weld-taught-spans-overlap = этот участок начинается до конца предыдущего
weld-allowed-taught-from = { $min } или больше; участки в порядке сварки
weld-taught-span-without-length = участок не имеет длины
weld-taught-span-beyond-seam = участок кончается дальше конца номинального шва
weld-taught-span-without-points = между сопряжениями нет точек
weld-allowed-taught-points = не меньше одной, в `points_mm` или `axes`
weld-allowed-smooth-points = точки дальше друг от друга или ближе к одной плавной кривой
weld-taught-point-far = точка { $point } в { $distance } от номинального шва между сопряжениями
weld-allowed-taught-within = { $key } = { $value }; или большее `{ $key }`, если деталь действительно так далеко
weld-taught-point-out-of-order = точка { $point } лежит вдоль шва на s = { $s }
weld-allowed-taught-after-join = после первого сопряжения на { $min } и до второго сопряжения на { $max }
weld-allowed-taught-after-point = после предыдущей точки на { $min } и до второго сопряжения на { $max }
weld-taught-point-repeated = точка { $point } совпадает с соседней точкой или сопряжением
weld-allowed-taught-apart = точки и сопряжения не ближе { $min }
weld-taught-curve-turns = у точки { $point } кривая через точки отклоняется на { $angle } от шва
weld-allowed-taught-turn = до { $max }: точки дальше друг от друга или ближе к одной плавной кривой

# Passes.
weld-pass-begins-beyond-end = проход начинается за концом шва
weld-pass-round-more-than-twice = проход обходит шов одним валиком больше двух раз
weld-pass-beyond-end = проход идёт за конец шва
weld-pass-beyond-start = проход идёт назад за начало шва
weld-pass-without-seam = у прохода нет шва, вдоль которого идти
weld-travel-too-long = { $pass }: движение длилось бы { $time }
weld-allowed-travel-time = до { $max }: более высокая скорость
weld-bead-rows-too-short = строки не охватывают весь проход
weld-pass-without-motion = в этом проходе ничто не движется
weld-allowed-point-elsewhere = точка в другом месте
weld-arc-points-in-line = начало дуги, `via_mm` и конец лежат на прямой, или два из них совпадают
weld-allowed-arc-points = три точки не на прямой; полная окружность — две дуги

# Findings of passes.
weld-torch-inside-first-face = горелка вошла бы на { $angle } в поверхность первой детали (двугранный угол { $dihedral })
weld-torch-inside-second-face = горелка вошла бы на { $angle } в поверхность второй детали (двугранный угол { $dihedral })
weld-cure-smaller-work-angle = сделайте рабочий угол меньше половины двугранного угла
weld-bead-goes-back = валик (почти) стоял бы или шёл назад: он лежит за центром изгиба шва, или его строки меняются слишком быстро
weld-cure-bead-nearer = положите валик там ближе к шву
weld-bead-area-out-of-range = чтобы заполнить разделку, валик имел бы { $area }: { $ratio } от { $run } его прохода; разрешено от { $min } до { $max }
weld-cure-thinner-layers = более тонкие слои, более крупные валики (площадь, подача проволоки, меньшая скорость), adapt = "passes" или больший most_percent
weld-cure-smaller-beads = меньшие валики (выше скорость, меньше проволоки), adapt = "passes" или больший most_percent
weld-bead-width-out-of-window = валик имел бы ширину { $width } и высоту { $height }; разрешённая ширина: от { $min } до { $max }
weld-bead-height-out-of-window = валик имел бы высоту { $height } и ширину { $width }; разрешённая высота: от { $min } до { $max }
weld-bead-ratio-out-of-window = валик имел бы ширину { $width } и высоту { $height }: отношение { $ratio }; разрешено от { $min } до { $max }
weld-bead-too-wide-without-weave = без колебаний валик имел бы ширину { $width } и высоту { $height }; разрешено до { $max }
weld-bead-toe-steep = угол перехода облицовочного слоя был бы { $angle }; разрешено { $min } и больше
weld-layer-height-not-kept = слой имел бы высоту { $height } вместо { $wanted }: валики по { $area } заполняют его иначе
weld-cure-bead-window = изменить layer_mm или площадь прохода (скорость, подача проволоки), adapt = "passes" или окно в технологической карте
weld-cure-weave-or-smaller-beads = задать проходу колебания или меньшие валики (выше скорость, меньше проволоки)
weld-cure-bead-toe = уменьшить cap_mm, приблизить spacing_to_width к 2/3 или сделать валики облицовки площе (колебания, меньшая площадь)
weld-cure-layer-height = приблизить layer_mm к этой высоте или изменить площадь прохода (скорость, подача проволоки)

# Joints.
weld-groove-at = на s = { $s }: { $why }
weld-remaining-area-impossible = у разделки нет такой открытой площади
weld-scan-after-last-layer = до этого запланировано { $layers ->
        [one] { $layers } слой
        [few] { $layers } слоя
       *[many] { $layers } слоёв
    }: для этого измерения не осталось ни одного
weld-scan-too-few-points = точек всего { $found }; нужно { $needed }
weld-scan-no-groove = разделки нет: на ней лежит { $share } % точек, с разбросом { $scatter } мм
weld-scan-other-angle = поверхности или кромки стоят под { $angle }; на чертеже { $drawn }
weld-scan-uncertain = открытая площадь известна с неопределённостью { $uncertainty }: кромка не видна
weld-groove-no-butt = поверхности под { $dihedral } друг к другу не образуют стыкового соединения
weld-groove-no-corner = поверхности под { $dihedral } друг к другу не образуют углового или таврового соединения
weld-groove-no-outside-corner = поверхности под углом { $dihedral } друг к другу не образуют наружного угла
weld-groove-edge-within-part = подготовленная кромка под { $angle } к поверхности другой детали остаётся внутри своей: двугранный угол { $dihedral }
weld-groove-edge-in-other-part = срез оставляет { $angle } до поверхности другой детали: кромка была бы внутри неё
weld-groove-edges-cross = кромки пересекаются
weld-groove-empty = у разделки нет площади
weld-standard-of-other-joints = { $standard } относится к другим соединениям
weld-joint-beside-standard = { $size }: { $value } при s = { $s }; { $standard } задаёт для этой разделки от { $min } до { $max }
weld-joint-below-standard = { $size }: { $value } при s = { $s }; { $standard } задаёт для этого соединения не менее { $min }
weld-joint-beside-standard-at-dihedral = { $size }: { $value } при s = { $s }; { $standard } задаёт от { $min } до { $max } при двугранном угле { $dihedral }
weld-size-thickness = толщина
weld-size-groove-angle = угол разделки
weld-size-root-gap = зазор в корне
weld-size-root-face = притупление
weld-size-cover-throat = толщина углового шва
weld-cure-joint-standard = измените разделку или аттестуйте сварку с ней
weld-allowed-butt-dihedral = двугранный угол { $min } или больше либо угловой шов
weld-allowed-corner-dihedral = двугранный угол до { $max } либо стыковое соединение
weld-allowed-outside-corner = двугранный угол от { $min } до { $max } (joint = "corner" у шва)
weld-allowed-edge-cut = везде больше 90° минус двугранный угол
weld-allowed-larger-gap = больший зазор или меньшее смещение кромок
weld-allowed-room-to-weld = зазор или угол, оставляющий место для шва

# Beads.
weld-beads-without-joint = нет соединения, которое заполнять
weld-allowed-joint = [joint] с подготовкой кромок
weld-stations-with-beads = вместе с [beads] значения задают в [beads.root], [beads.fill] и [beads.cap]
weld-sector-position-unclear = положение сектора неясно
weld-sectors-unequal = секторы задают коэффициенты для разных величин
weld-sectors-at-one-place = два сектора находятся при s = { $s }
weld-feed-follows-area = подача проволоки следует площади разделки
weld-allowed-s-or-phi = либо s_mm, либо phi_deg
weld-allowed-same-factors = имена первой строки
weld-allowed-sectors-apart = разные положения
weld-allowed-no-feed-factor = без коэффициента для неё, или другое adapt
weld-allowed-no-table-or-beads = без этой таблицы или без [beads]
weld-ramp-with-beads = значение, меняющееся по шву, не сочетается с [beads]
weld-travel-angle-twice = угол хода задан здесь и в нескольких позициях шва
weld-allowed-travel-angle-once = без этого ключа или без [[torch.at]]
weld-area-with-wire-feed = заданная площадь не следует за подачей проволоки
weld-allowed-no-area-with-wire-feed = без этого ключа при adapt = "wire_feed"
weld-bead-area-missing = не хватает площади валика
weld-insert-without-root = вставке нужен корневой проход, который её расплавит
weld-allowed-insert-root = `root` в [beads] либо без вставки
weld-allowed-bead-area = area_mm2 или beads.wire_mm и wire_feed_m_min
weld-bead-area-needs-steady-feed = площадь валика требует постоянной подачи проволоки
weld-allowed-steady-feed = wire_feed_m_min больше 0 в [weld.process] или здесь, либо area_mm2
weld-deposition-too-large = в валике было бы больше металла, чем в проволоке
weld-bead-range-too-large = валики не держат форму в таком диапазоне
weld-wall-tilt-too-large = проволока лежала бы на стенке
weld-step-over-needs-closed-seam = переход на следующий валик требует шва, завариваемого по всей окружности
weld-wire-implausible = проволоки толщиной { $wire } не бывает
weld-step-over-too-short = переход так короток, что горелка шла бы поперёк шва
weld-step-over-too-long = переход длиннее половины шва
weld-step-over-with-alternate = валики, соединённые переходами, идут в одну сторону
weld-step-over-with-passes = слои на части шва нельзя соединить переходами
weld-step-over-with-parts = проход с переходами нельзя заваривать по частям
weld-allowed-no-step-over = без перехода или шов по всей окружности
weld-station-distance-invalid = недопустимое расстояние между сечениями
weld-no-bead-weaves = ни один валик не с колебаниями
weld-allowed-weave = [weld.weave], `weave` в [beads.root], [beads.fill] или [beads.cap], либо другое значение
weld-bead-spacing-invalid = валики не могут лежать так далеко или так близко
weld-layer-height-impossible = валики по { $area } не дают слоёв такой высоты
weld-too-many-beads = разделка { $groove } требует { $beads } валиков по { $bead }
weld-too-many-stations = валики раскладывались бы в { $count ->
        [one] { $count } сечении
        [few] { $count } сечениях
       *[many] { $count } сечениях
    }
weld-too-many-bead-positions = слишком много: проходов { $passes }, строк в каждом { $rows }
weld-allowed-larger-beads = более крупные валики: ниже скорость или больше проволоки; разделку заполняют до { $max } валиков
weld-allowed-smaller-groove = до { $max } валиков: меньшая разделка или более крупные валики
weld-allowed-stations = до { $max } сечений: большее расстояние
weld-allowed-bead-positions = до { $max } позиций: большее расстояние или более крупные валики

# Order of welding: copies, parts, tacks.
weld-order-without-rows = нет рядов, между которыми ходить туда и обратно
weld-allowed-two-rows = два ряда: [rows] или `row` в каждой из [[copies]]
weld-skip-invalid = так не пропускается ни одна копия или пропускаются все
weld-allowed-no-skip = без пропуска: в ряду слишком мало копий
weld-allowed-skip = от 2 до { $max }: в самом длинном ряду { $copies ->
        [one] { $copies } копия
        [few] { $copies } копии
       *[many] { $copies } копий
    }
weld-copies-twice = копии заданы дважды
weld-allowed-rows-or-copies = либо [rows], либо [[copies]]
weld-too-many-passes = { $passes ->
        [one] всего { $passes } проход
        [few] всего { $passes } прохода
       *[many] всего { $passes } проходов
    }: слишком много
weld-allowed-passes = до { $max }: меньше копий или прихваток, либо меньше или длиннее части
weld-too-many-rows = слишком много: проходов { $passes }, всего строк валиков и участков { $rows }
weld-allowed-row-count = до { $max } строк: меньше копий или прихваток, меньше или длиннее части либо большее beads.station_mm
weld-copy-count-invalid = недопустимое число копий
weld-too-many-copies = слишком много копий
weld-allowed-columns = от 1 до { $max }: всего копий { $copies }
weld-copies-coincide = копии стояли бы в одной позиции
weld-allowed-row-step = шаг в сторону от линии ряда или за её конец
weld-copy-too-far = копия стояла бы слишком далеко
weld-allowed-copies-within = копии в пределах { $limit } от 0
weld-seam-without-corners = у шва нет углов
weld-overlap-at-corners = части от угла до угла не имеют перекрытия
weld-allowed-no-overlap-at-corners = 0 при order.parts = "at_corners"
weld-seam-without-quarters = шов, который варят не по всему контуру, не имеет противоположных четвертей
weld-pieces-longer-than-weld = части были бы длиннее шва
weld-too-many-pieces = слишком много частей
weld-allowed-piece-length = не меньше { $min }: до { $count } частей
weld-tie-in-too-long = перекрытие частей не короче части
weld-allowed-tie-in = меньше части: { $max }
weld-all-round-has-one-end = шов, который варят по всему контуру, кончается там, где начинается
weld-cosmetic-ramp = косметический проход имеет постоянные значения
weld-cosmetic-beyond-end = косметический проход начинается за концом шва
weld-tack-count-or-pitch = число прихваток задаёт ровно один из двух ключей
weld-allowed-count-or-pitch = либо `count`, либо `pitch_mm`
weld-tack-count-invalid = недопустимое число прихваток
weld-tack-ramp = прихватка имеет постоянные значения
weld-too-many-tacks = слишком много прихваток
weld-allowed-tack-pitch = не меньше { $min }: до { $count } прихваток
weld-tacks-meet = прихватки сошлись бы
weld-allowed-tack-length = меньше расстояния от прихватки до прихватки: { $count } на { $length } шва
weld-tacks-near-start = прихватки начались бы в { $distance } от начала шва
weld-allowed-tack-clearance = до { $max } или меньше прихваток

# The part as solids.
weld-part-replaced-by-nothing = деталь, созданная по шву, заменена, но тела не заданы
weld-allowed-part-solids = [[part.solids]] вместе с ним или без этого ключа
weld-allowed-rigid-placement = жёсткое размещение
weld-body-too-short = тело кончалось бы в пределах шва
weld-part-from-seam = деталь, созданная по шву: { $why }
weld-allowed-part-sizes = размеры до { $max }, также в [part]; либо [[part.solids]] с part.replace = true
weld-allowed-sphere = сфера
