# Errors of curves, surfaces and their intersections.
geometry-size = { $what }: потрібне скінченне число, більше за 0, а не { $value }
geometry-range = { $what }: має бути більше за { $min } і менше за { $max }, а не { $value }
geometry-too-small = { $what }: має бути скінченне число, більше за { $min }, а не { $value }
geometry-direction = { $what }: потрібен скінченний вектор із довжиною понад 0
geometry-parallel = { $first } і { $second } паралельні
geometry-tube-larger-than-body = труба більша за тіло: її стінка не перетинає його за жодного кута
geometry-tube-beside-body = труба проходить повз тіло і не перетинає його
geometry-not-closed = стінка труби не перетинає тіло між phi = { $from } і { $to }: крива не замкнена
geometry-beyond-head = стінка труби виходить за край відбортовки днища між phi = { $from } і { $to }
geometry-tangent = стінка труби дотикається до тіла при phi = { $angle }: крива не має там дотичної
geometry-beside-trimming-tube = від phi = { $angle } стінка труби проходить повз трубу, яка її обрізає
geometry-never-leaves = напрям труби вказує всередину тіла: уздовж +direction труба з нього не виходить
geometry-arc-length = довжину кривої не вдалося визначити з точністю { $accuracy } біля параметра { $parameter }
geometry-sharp-turn = { $what }: поворот на 90° або більше від точки до точки
geometry-gap = ланка { $piece } ланцюга починається не там, де закінчується попередня
geometry-knots = положення значень сплайна мають строго зростати (значення { $index })
geometry-column = стовпець має значень: { $values }, а точок { $points }
geometry-point = точка { $index } має завелике або нескінченне значення

# Errors of fits to touched points.
geometry-too-few-points = замало точок ({ $what }): задано { $given }, потрібно щонайменше { $min }
geometry-points-in-one-position = точки ({ $what }) майже збігаються: вони цього не визначають
geometry-points-on-one-line = точки ({ $what }) лежать майже на одній прямій: вони цього не визначають
geometry-short-arc = кола торкнулися лише на { $touched }; потрібно щонайменше { $min }
geometry-attitudes-alike = орієнтації відрізняються щонайбільше на { $angle }: вони не визначають центр інструмента (TCP)
geometry-no-fit = не знайдено положення деталі, що відповідає точкам

# Motions that touched points leave free.
geometry-motion-along = зсув уздовж { $direction }
geometry-motion-about = поворот навколо осі вздовж { $direction } через { $point } мм
geometry-motion-screw = поворот навколо осі вздовж { $direction } через { $point } мм, { $pitch } уздовж неї на оберт

# Maps between pixels and a plane.
geometry-map-scale = піксель { $scale }: дозволено від { $min } до { $max }
geometry-map-shear = скіс { $shear }: дозволено від { $min } до { $max }
geometry-map-rotation = поворот { $rotation }: дозволено скінченне число в межах пів оберту
geometry-map-centre = центр ({ $x }, { $y }) лежить поза кадром далі, ніж на розмір кадру
geometry-map-barrel = дисторсія { $barrel }: дозволено щонайбільше { $max }, без складок зображення в кадрі
geometry-heights-empty = таблиця висот не має рядків
geometry-heights-order = рядок { $row }: висота { $height } не більша за висоту попереднього рядка
geometry-heights-frame-size = рядок { $row }: розмір кадру інший, ніж у першому рядку
geometry-heights-between = між рядками { $row } і { $next }: { $why }
geometry-height-outside = висота { $height }: таблиця камери охоплює від { $min } до { $max }
geometry-pixel-folded = піксель ({ $x }, { $y }) лежить поза межами дисторсії зображення

# Names of sets of points.
geometry-points-chain = ланцюг
geometry-points-spline = сплайн
geometry-points-frame = система координат
geometry-points-nominal-frame = номінальна система координат
geometry-points-measured-frame = виміряна система координат
geometry-points-plane = площина
geometry-points-line = пряма
geometry-points-point = точка
geometry-points-origin = початок координат
geometry-points-direction = напрям
geometry-points-circle = коло
geometry-points-tube = труба
geometry-points-surfaces = поверхні
geometry-points-tip = центр інструмента (TCP)
geometry-points-taught-line = навчена лінія

# Names of sizes and directions.
geometry-tube-radius = радіус труби
geometry-tube-direction = напрям труби
geometry-tube-zero-direction = нульовий напрям труби
geometry-zero-direction = її нульовий напрям
geometry-tube-origin = початок координат труби
geometry-sphere-radius = радіус кулі
geometry-cylinder-radius = радіус циліндра
geometry-cylinder-axis = вісь циліндра
geometry-elliptic-cylinder-semi-axis = піввісь еліптичного циліндра
geometry-elliptic-cylinder-axis = вісь еліптичного циліндра
geometry-elliptic-cylinder-x-direction = напрям x еліптичного циліндра
geometry-ellipsoid-semi-axis = піввісь еліпсоїда
geometry-ellipsoid-axis = вісь еліпсоїда
geometry-ellipsoid-x-direction = напрям x еліпсоїда
geometry-x-direction = напрям x
geometry-cone-axis = вісь конуса
geometry-cone-half-angle = половинний кут конуса
geometry-torus-ring-radius = радіус кільця тора
geometry-torus-tube-radius = радіус труби тора
geometry-torus-axis = вісь тора
geometry-torus-centre = центр тора
geometry-body-position = положення тіла
geometry-plane-normal = нормаль площини
geometry-head-radius = радіус днища
geometry-head-depth = висота днища
geometry-head-flange = відбортовка днища
geometry-head-axis = вісь днища
geometry-crown-radius = радіус сферичної частини
geometry-knuckle-radius = радіус торової частини
geometry-wall-of-ellipsoid = товщина стінки
geometry-line-length = довжина прямої
geometry-arc-axis = вісь дуги
geometry-arc-radius = радіус дуги
geometry-arc-angle = кут дуги
geometry-chord-to-via-point = пряма до проміжної точки
geometry-chord-to-end = пряма до кінця
geometry-helix-pitch = крок гвинтової лінії
geometry-turns = кількість обертів
geometry-width = ширина
geometry-height = висота
geometry-corner-radius = радіус кута
geometry-rectangle-normal = нормаль прямокутника
geometry-width-direction = напрям ширини
geometry-semi-axis-a = піввісь a еліпса
geometry-semi-axis-b = піввісь b еліпса
geometry-ellipse-normal = нормаль еліпса
geometry-semi-axis-a-direction = напрям півосі a
geometry-curve = крива
geometry-curve-through-points = крива через точки
geometry-normal = нормаль
geometry-face-normal = нормаль грані
geometry-tolerance = допуск
geometry-column-tolerance = допуск інших стовпців
