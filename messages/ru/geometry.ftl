# Errors of curves, surfaces and their intersections.
geometry-size = { $what }: нужно конечное число больше 0, а не { $value }
geometry-range = { $what }: должно быть больше { $min } и меньше { $max }, а не { $value }
geometry-too-small = { $what }: должно быть конечное число больше { $min }, а не { $value }
geometry-direction = { $what }: нужен конечный вектор с длиной больше 0
geometry-parallel = { $first } и { $second } параллельны
geometry-tube-larger-than-body = труба больше тела: её стенка не пересекает его ни при каком угле
geometry-tube-beside-body = труба проходит мимо тела и не пересекает его
geometry-not-closed = стенка трубы не пересекает тело между phi = { $from } и { $to }: кривая не замкнута
geometry-beyond-head = стенка трубы выходит за край отбортовки днища между phi = { $from } и { $to }
geometry-tangent = стенка трубы касается тела при phi = { $angle }: у кривой там нет касательной
geometry-beside-trimming-tube = от phi = { $angle } стенка трубы проходит мимо трубы, которая её обрезает
geometry-never-leaves = направление трубы указывает внутрь тела: вдоль +direction труба из него не выходит
geometry-arc-length = длину кривой не удалось определить с точностью { $accuracy } вблизи параметра { $parameter }
geometry-sharp-turn = { $what }: поворот на 90° или больше от точки к точке
geometry-gap = звено { $piece } цепи начинается не там, где кончается предыдущее
geometry-knots = положения значений сплайна должны строго возрастать (значение { $index })
geometry-column = в столбце значений: { $values }, а точек { $points }
geometry-point = у точки { $index } слишком большое или не конечное значение

# Errors of fits to touched points.
geometry-too-few-points = слишком мало точек ({ $what }): задано { $given }, нужно не меньше { $min }
geometry-points-in-one-position = точки ({ $what }) почти совпадают: они этого не определяют
geometry-points-on-one-line = точки ({ $what }) лежат почти на одной прямой: они этого не определяют
geometry-short-arc = окружности коснулись лишь на { $touched }; нужно не меньше { $min }
geometry-attitudes-alike = ориентации отличаются не больше чем на { $angle }: они не определяют центр инструмента (TCP)
geometry-no-fit = не найдено положения детали, которое соответствует точкам

# Motions that touched points leave free.
geometry-motion-along = сдвиг вдоль { $direction }
geometry-motion-about = поворот вокруг оси вдоль { $direction } через { $point } мм
geometry-motion-screw = поворот вокруг оси вдоль { $direction } через { $point } мм, { $pitch } вдоль неё на оборот

# Maps between pixels and a plane.
geometry-map-scale = пиксель { $scale }: допустимо от { $min } до { $max }
geometry-map-shear = сдвиг (скос) { $shear }: допустимо от { $min } до { $max }
geometry-map-rotation = поворот { $rotation }: допустимо конечное число в пределах пол-оборота
geometry-map-centre = центр ({ $x }, { $y }) лежит вне кадра дальше, чем на размер кадра
geometry-map-barrel = дисторсия { $barrel }: допустимо не больше { $max }, без складок изображения в кадре
geometry-heights-empty = в таблице высот нет строк
geometry-heights-order = строка { $row }: высота { $height } не больше высоты предыдущей строки
geometry-heights-frame-size = строка { $row }: размер кадра не такой, как в первой строке
geometry-heights-between = между строками { $row } и { $next }: { $why }
geometry-height-outside = высота { $height }: таблица камеры охватывает от { $min } до { $max }
geometry-pixel-folded = пиксель ({ $x }, { $y }) лежит за пределами дисторсии изображения

# Names of sets of points.
geometry-points-chain = цепь
geometry-points-spline = сплайн
geometry-points-frame = система координат
geometry-points-nominal-frame = номинальная система координат
geometry-points-measured-frame = измеренная система координат
geometry-points-plane = плоскость
geometry-points-line = прямая
geometry-points-point = точка
geometry-points-origin = начало координат
geometry-points-direction = направление
geometry-points-circle = окружность
geometry-points-tube = труба
geometry-points-surfaces = поверхности
geometry-points-tip = центр инструмента (TCP)
geometry-points-taught-line = обученная линия

# Names of sizes and directions.
geometry-tube-radius = радиус трубы
geometry-tube-direction = направление трубы
geometry-tube-zero-direction = нулевое направление трубы
geometry-zero-direction = её нулевое направление
geometry-tube-origin = начало координат трубы
geometry-sphere-radius = радиус шара
geometry-cylinder-radius = радиус цилиндра
geometry-cylinder-axis = ось цилиндра
geometry-elliptic-cylinder-semi-axis = полуось эллиптического цилиндра
geometry-elliptic-cylinder-axis = ось эллиптического цилиндра
geometry-elliptic-cylinder-x-direction = направление x эллиптического цилиндра
geometry-ellipsoid-semi-axis = полуось эллипсоида
geometry-ellipsoid-axis = ось эллипсоида
geometry-ellipsoid-x-direction = направление x эллипсоида
geometry-x-direction = направление x
geometry-cone-axis = ось конуса
geometry-cone-half-angle = половинный угол конуса
geometry-torus-ring-radius = радиус кольца тора
geometry-torus-tube-radius = радиус трубы тора
geometry-torus-axis = ось тора
geometry-torus-centre = центр тора
geometry-body-position = положение тела
geometry-plane-normal = нормаль плоскости
geometry-head-radius = радиус днища
geometry-head-depth = высота днища
geometry-head-flange = отбортовка днища
geometry-head-axis = ось днища
geometry-crown-radius = радиус сферической части
geometry-knuckle-radius = радиус торовой части
geometry-wall-of-ellipsoid = толщина стенки
geometry-line-length = длина прямой
geometry-arc-axis = ось дуги
geometry-arc-radius = радиус дуги
geometry-arc-angle = угол дуги
geometry-chord-to-via-point = прямая к промежуточной точке
geometry-chord-to-end = прямая к концу
geometry-helix-pitch = шаг винтовой линии
geometry-turns = число оборотов
geometry-width = ширина
geometry-height = высота
geometry-corner-radius = радиус угла
geometry-rectangle-normal = нормаль прямоугольника
geometry-width-direction = направление ширины
geometry-semi-axis-a = полуось a эллипса
geometry-semi-axis-b = полуось b эллипса
geometry-ellipse-normal = нормаль эллипса
geometry-semi-axis-a-direction = направление полуоси a
geometry-curve = кривая
geometry-curve-through-points = кривая через точки
geometry-normal = нормаль
geometry-face-normal = нормаль грани
geometry-tolerance = допуск
geometry-column-tolerance = допуск остальных столбцов
