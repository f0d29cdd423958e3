# Reasons for a low confidence of a detected joint.
vision-doubt-clutter = много обнаруженных точек лежит вне линий стыка: блики или брызги
vision-doubt-short = часть стыка видна менее чем в 30 столбцах: подведите датчик ближе или над весь стык
vision-doubt-uneven = часть стыка не прямая: её точки на несколько строк отклоняются от линии
vision-doubt-light = полоса света не начинается и не кончается вместе с частями стыка: тёмные места на них, свет за их краями или закрытый край
vision-doubt-shape = форма на пределе этого типа соединения
vision-doubt-moved = стык далеко от ожидаемого положения
vision-doubt-unknown = точка или величина стыка неизвестна

# Reasons why no joint was detected.
vision-no-stripe = на изображении нет полосы света
vision-saturated = изображение пересвечено: уменьшите выдержку или свет
vision-short-stripe = полоса света видна в { $found } из { $columns } столбцов; нужна четверть
vision-too-few-points = в профиле пригодных точек: { $found }; нужно { $needed }
vision-no-corner = в профиле не найден угол двух поверхностей от 60° до 120°
vision-no-groove = разделка этого типа между двумя поверхностями не найдена
vision-no-step = ступенька между двумя параллельными листами не найдена
vision-no-seam = зазор, смещение кромок или тёмная линия между двумя пластинами в линию не найдены

# Reasons why a picture of a grid of dots gives no map.
vision-grid-pitch = шаг { $pitch }: допустимо конечное число больше 0
vision-grid-plain = тёмных точек нет: изображение почти однородно (самые тёмные места темнее окружения на { $contrast })
vision-grid-few-dots = найдено точек сетки: { $found }; нужно не меньше { $min }, по всему изображению
vision-grid-tangled = точки не образуют одной сетки: около ({ $x }, { $y }) строки и столбцы не сходятся
vision-grid-corner = точки занимают { $part } ширины или высоты изображения; нужно не меньше половины
vision-grid-residual = точки отклоняются от лучшего отображения на { $rms } (СКЗ); допустимо { $max }: на изображении другая сетка или оно нерезкое
vision-grid-map = подбор по точкам дал недопустимое отображение: { $why }

# Frames.
vision-frame-size = кадр { $width } x { $height } пикселей: допустимы стороны от 1 до { $max } пикселей
vision-frame-pixels = для кадра { $width } x { $height } задано пикселей: { $found }; нужно { $needed }
