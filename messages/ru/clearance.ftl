# Sizes and poses of solids.
clearance-size = { $what }: должно быть больше 0 и не больше { $max }, а не { $value }
clearance-short-capsule = длина капсулы { $length } меньше двух её круглых концов, { $min }
clearance-too-far = тело лежит в { $value } от начала координат; допустимо до { $max }
clearance-not-rigid = положение не является жёстким перемещением
clearance-box-side = сторона параллелепипеда
clearance-radius = радиус
clearance-length = длина
clearance-semi-axis = полуось
clearance-capsule-allowed = полная длина с круглыми концами: не меньше двух радиусов
clearance-cone-allowed = радиусы и длина до { $max }, один из радиусов больше 0
clearance-sizes-allowed = размеры до { $max }

# STL files and meshes.
clearance-file-unreadable = не удалось прочитать файл: { $why }
clearance-file-allowed = существующий файл, путь от файла, который его называет
clearance-not-stl = это не файл STL: { $why }
clearance-stl-no-header = он не начинается ни с `solid`, ни с двоичного заголовка
clearance-stl-corner = строка { $line }: у вершины должно быть три числа
clearance-stl-facet = строка { $line }: { $corners -> 
    [one] у грани { $corners } вершина; нужно три
    [few] у грани { $corners } вершины; нужно три
   *[other] у грани { $corners } вершин; нужно три
 }
clearance-stl-word = строка { $line }: неизвестное слово `{ $word }`
clearance-stl-cut-short = файл STL оборван: { $why }
clearance-stl-triangles-missing = есть { $found } из { $count } треугольников
clearance-stl-no-endsolid = не хватает `endsolid` после { $count -> 
    [one] { $count } треугольника
   *[other] { $count } треугольников
 }
clearance-corner-not-finite = у треугольника { $triangle } координата вершины не конечное число
clearance-corner-too-far = у треугольника { $triangle } вершина в { $distance } мм от начала координат
clearance-no-triangles = в сетке нет треугольников
clearance-open-surface = поверхность не замкнута: { $edges -> 
    [one] у { $edges } ребра не ровно два треугольника, в точке { $point } мм
   *[other] у { $edges } рёбер не ровно два треугольника, одно из них в точке { $point } мм
 }
clearance-stl-whole-allowed = целый файл STL: скопируйте или экспортируйте его ещё раз
clearance-stl-closed-allowed = замкнутая поверхность: закройте отверстия или экспортируйте тело ещё раз как одно; подойдёт и простой параллелепипед или цилиндр вокруг него
clearance-stl-corners-allowed = вершины не дальше { $max } от начала координат; `scale` переводит другие единицы в мм
clearance-stl-finite-allowed = конечные координаты: экспортируйте файл ещё раз
clearance-stl-triangles-allowed = файл не меньше чем с четырьмя треугольниками вокруг тела
clearance-stl-allowed = файл STL, ASCII или двоичный

# Watches of a scene.
clearance-no-such-group = наблюдение { $watch } называет группу { $group }, которой не существует
clearance-unbounded-group = наблюдение { $watch }: в группе `{ $group }` есть полупространство; здесь она должна быть ограниченной
clearance-zone-shape = наблюдение { $watch }: разрешённая зона — это параллелепипед, цилиндр, шар или полупространство
clearance-no-zone = у наблюдения { $watch } нет разрешённой зоны
clearance-minimum = наблюдение { $watch }: минимальное расстояние двух групп должно быть больше 0, а минимальный запас — конечным
clearance-limit = { $what }: должно быть больше 0
clearance-cutoff = предельное расстояние
clearance-precision = точность
clearance-smallest-cell = наименьшая ячейка
