# Sizes and poses of solids.
clearance-size = { $what }: має бути більше за 0 і щонайбільше { $max }, а не { $value }
clearance-short-capsule = довжина капсули { $length } менша за два її округлі кінці, { $min }
clearance-too-far = тіло лежить за { $value } від початку координат; дозволено до { $max }
clearance-not-rigid = положення не є жорстким переміщенням
clearance-box-side = сторона паралелепіпеда
clearance-radius = радіус
clearance-length = довжина
clearance-semi-axis = піввісь
clearance-capsule-allowed = повна довжина з округлими кінцями: щонайменше два радіуси
clearance-cone-allowed = радіуси й довжина до { $max }, один із радіусів більший за 0
clearance-sizes-allowed = розміри до { $max }

# STL files and meshes.
clearance-file-unreadable = не вдалося прочитати файл: { $why }
clearance-file-allowed = наявний файл, шлях від файлу, що його називає
clearance-not-stl = це не файл STL: { $why }
clearance-stl-no-header = він не починається ні з `solid`, ні з двійкового заголовка
clearance-stl-corner = рядок { $line }: вершина повинна мати три числа
clearance-stl-facet = рядок { $line }: { $corners -> 
    [one] грань має { $corners } вершину; потрібно три
    [few] грань має { $corners } вершини; потрібно три
   *[other] грань має { $corners } вершин; потрібно три
 }
clearance-stl-word = рядок { $line }: невідоме слово `{ $word }`
clearance-stl-cut-short = файл STL обірваний: { $why }
clearance-stl-triangles-missing = є { $found } з { $count } трикутників
clearance-stl-no-endsolid = бракує `endsolid` після { $count -> 
    [one] { $count } трикутника
   *[other] { $count } трикутників
 }
clearance-corner-not-finite = трикутник { $triangle } має вершину з нескінченною координатою
clearance-corner-too-far = трикутник { $triangle } має вершину за { $distance } мм від початку координат
clearance-no-triangles = сітка не має трикутників
clearance-open-surface = поверхня не замкнена: { $edges -> 
    [one] { $edges } ребро не має рівно двох трикутників, у точці { $point } мм
    [few] { $edges } ребра не мають рівно двох трикутників, одне з них у точці { $point } мм
   *[other] { $edges } ребер не мають рівно двох трикутників, одне з них у точці { $point } мм
 }
clearance-stl-whole-allowed = цілий файл STL: скопіюйте або експортуйте його ще раз
clearance-stl-closed-allowed = замкнена поверхня: закрийте отвори або експортуйте тіло ще раз як одне; підійде й простий паралелепіпед чи циліндр навколо нього
clearance-stl-corners-allowed = вершини не далі { $max } від початку координат; `scale` перетворює інші одиниці на мм
clearance-stl-finite-allowed = скінченні координати: експортуйте файл ще раз
clearance-stl-triangles-allowed = файл щонайменше з чотирма трикутниками навколо тіла
clearance-stl-allowed = файл STL, ASCII або двійковий

# Watches of a scene.
clearance-no-such-group = спостереження { $watch } називає групу { $group }, якої не існує
clearance-unbounded-group = спостереження { $watch }: група `{ $group }` має півпростір; тут вона має бути обмеженою
clearance-zone-shape = спостереження { $watch }: дозволена зона — це паралелепіпед, циліндр, куля або півпростір
clearance-no-zone = спостереження { $watch } не має дозволеної зони
clearance-minimum = спостереження { $watch }: мінімальна відстань двох груп має бути більшою за 0, а мінімальний запас — скінченним
clearance-limit = { $what }: має бути більше за 0
clearance-cutoff = гранична відстань
clearance-precision = точність
clearance-smallest-cell = найменша комірка
