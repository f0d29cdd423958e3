# Positions on the weld, and torch angles.
weld-position-beside-weld = ця позиція не на шві
weld-positions-must-increase = позиції мають зростати
weld-without-length = шов не має довжини
weld-angles-twice = кути задано і сталими, і в кількох позиціях
weld-travel-angle-too-large = пальник лежав би вздовж шва
weld-work-angle-too-large = пальник лежав би за поверхнею
weld-torch-search-too-wide = пошук кутів пальника виходить за межі можливого
weld-stick-out-range = з таким вильотом не варить жоден пальник
weld-stick-out-of-machine = виліт дроту пальника верстата невідомий, тому його не можна відвести для іншого
weld-stick-out-above-search = пошук не може збільшити виліт до цього значення: без нього вже { $own }
weld-allowed-stick-out = `stick_out_mm` у [torch] файлу верстата: дріт між наконечником і точкою пальника
weld-min-speed-too-high = мінімальна швидкість не нижча за швидкість зварювання
weld-speed-below-min = швидкість зварювання не вища за мінімальну
weld-value-ramps-already = це значення вже змінюється по всьому шву

# Allowed values of these.
weld-allowed-from-less-than = { $min } або більше, менше за { $max }
weld-allowed-positions-increasing = позиції, що зростають
weld-allowed-path-lengths-increasing = довжини шляху, що зростають
weld-allowed-seam-with-length = шов, що має довжину
weld-allowed-angles-once = або сталі кути, або [[torch.at]]
weld-allowed-travel-angle = від { $min } (кутом уперед) до { $max } (кутом назад)
weld-allowed-number-or-no-value = число в [weld.process] або тут без значення
weld-allowed-less-than-key = менше за { $key } = { $value }
weld-allowed-more-than-key = більше за { $key } = { $value }
weld-allowed-positive-less-than-key = більше за 0 і менше за { $key } = { $value }
weld-allowed-positive-less-than-half-key = більше за 0 і менше за половину { $key } = { $value }
weld-allowed-not-along = не вздовж `{ $key }`
weld-allowed-other-point = інша точка, ніж `{ $key }`
weld-allowed-schema = узгоджені між собою розміри (див. схему файлів завдань)

# Bodies that nozzles stand on.
weld-body-cylinder = циліндр, радіус { $radius }
weld-body-cone = конус, половинний кут { $angle }
weld-body-sphere = сфера, радіус { $radius }
weld-body-ellipsoid = еліпсоїд, півосі { $a }, { $b }, { $c }
weld-body-plane = площина, нормаль дивиться з пластини назовні
weld-body-torus = згин труби, радіус труби { $radius }
weld-body-torispherical-head = торосферичне днище, зовнішній діаметр { $diameter }
weld-body-ellipsoidal-head = еліптичне днище, зовнішній діаметр { $diameter }
weld-body-hemispherical-head = напівсферичне днище, зовнішній діаметр { $diameter }
weld-body-flat-head = плоске днище, зовнішній діаметр { $diameter }
weld-body-conical-head = конічне днище, зовнішній діаметр { $diameter }
weld-body-inside = внутрішня поверхня стінки; зовні: { $body }
weld-allowed-nozzle-fits = штуцер, що вміщується на тілі: { $body }
weld-allowed-nozzle-axis = вісь, що перетинає тіло: { $body }
weld-allowed-nozzle-on-body = радіус і вісь, за яких уся стінка (радіус { $radius }) лежить на тілі: { $body }
weld-allowed-nozzle-on-head = штуцер, уся стінка якого (радіус { $radius }) лежить на днищі з його циліндричним бортом: { $body }
weld-allowed-nozzle-smaller = штуцер, менший за тіло: { $body }
weld-allowed-nozzle-direction = напрям з тіла назовні: { $body }
weld-cone-angle-too-large = половинний кут конуса завеликий
weld-torus-meets-itself = труба зійшлася б сама з собою посередині згину
weld-set-in-wall-missing = штуцер вставлено: бракує товщини стінки тіла
weld-set-on-root-wall-missing = корінь приставного штуцера біля його отвору: бракує товщини стінки
weld-wall-leaves-no-room = стінка не лишає місця всередині
weld-wall-leaves-no-bore = стінка не лишає отвору
weld-knuckle-too-large = відбортовка з внутрішнім радіусом { $radius } не вміщується в циліндричний борт
weld-allowed-knuckle = внутрішній радіус відбортовки, менший за радіус борту { $max }
weld-head-radii-missing = бракує радіусів сфери й відбортовки
weld-allowed-head-radii = `standard` ("din_28011", "din_28013" або "asme_fd") чи разом `crown_radius_mm` і `knuckle_radius_mm`
weld-crown-too-curved = сфера не плоскіша за півсферу
weld-allowed-crown = більше за внутрішній радіус борту, { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = відгалуження лежить уздовж пояса
weld-branch-wider-than-chord = відгалуження таке ж широке, як пояс, або ширше
weld-branch-past-chord = стінка відгалуження виходить за пояс
weld-branches-do-not-part = два відгалуження паралельні або входять одне в одне
weld-branch-position-missing = бракує позиції другого відгалуження
weld-branch-position-twice = позицію другого відгалуження задано двічі
weld-allowed-tube = труба
weld-allowed-tubes-meet = труби, чиї стінки сходяться довкола: менше відгалуження або менше перекриття
weld-allowed-other-branch-angle = менше за { $max }, коли перше відгалуження під { $first }: осі мають розходитися
weld-allowed-gap-or-offset = рівно одне з `gap_mm` (між краями; від’ємне при перекритті) і `offset_mm` (між осями)
weld-allowed-branch-within-chord = відгалуження в межах пояса
weld-allowed-eccentricity = більше за { $min } і менше за { $max }: chord_radius_mm - radius_mm
weld-cut-along-tube = зріз іде вздовж труби: його нормаль відхилена на { $angle } від осі
weld-allowed-cut-angle = до { $max } від `direction`
weld-allowed-other-plane = інша площина

# Shapes of seams.
weld-seam-too-long = шов мав би довжину { $length }
weld-allowed-smooth-seam = плавний шов
weld-zero-direction-along-normal = нульовий напрям лежить уздовж нормалі
weld-arc-normal-off = площина трьох точок відхилена на { $angle } від цієї нормалі
weld-allowed-arc-normal = перпендикулярно до тієї площини: { $normal } або навпаки
weld-allowed-point-off-line-or-line-seam = точка поза прямою від початку до кінця; прямий шов — [seam.line]
weld-allowed-point-off-line = точка поза прямою від початку до кінця або без цього ключа
weld-corner-radius-too-large = радіус кута більший за половину меншої сторони
weld-point-count = шов має { $count ->
        [one] { $count } точку
        [few] { $count } точки
       *[many] { $count } точок
    }
weld-allowed-point-count = від { $min } до { $max } точок, тут або у файлі (`file`)
weld-point-above-plate = ця точка на { $height } вище пластини
weld-point-below-plate = ця точка на { $height } нижче пластини
weld-allowed-point-in-plane = точка в площині через першу з цією `normal`
weld-point-repeated = ця точка збігається з попередньою
weld-last-point-repeated = остання точка збігається з першою; шов замикається і без неї
weld-spline-point-repeated = точка { $point } збігається з попередньою
weld-spline-last-point-repeated = остання точка, { $point }, збігається з першою; шов замикається і без неї
weld-allowed-points-apart = точки в різних позиціях
weld-allowed-points-apart-by = точки не ближче { $min } одна до одної
weld-allowed-leave-point-out = без цієї точки
weld-allowed-other-points = інші точки
weld-normal-not-square = нормаль поверхні не перпендикулярна до шва
weld-allowed-square-to-line = перпендикулярно до end_mm - start_mm
weld-faces-opposed = поверхні дивляться одна на одну: з’єднання недосяжне
weld-spline-faces-opposed = точка { $point }: поверхні дивляться одна на одну, з’єднання недосяжне
weld-allowed-not-opposite = не протилежно до `{ $key }`
weld-helix-without-pitch = гвинтова лінія без кроку — це коло
weld-allowed-pitch = не 0; для шва навколо труби — [seam.girth]
weld-helix-too-long = гвинтова лінія має забагато обертів
weld-allowed-less-turn = менші повороти від точки до точки
weld-allowed-normals-less-turn = нормалі, що повертаються менш ніж на 90° від точки до точки
weld-normal-along-seam = нормаль поверхні десь лежить уздовж шва
weld-allowed-normals-across = нормалі впоперек шва
weld-closed-seam-has-no-ends = замкнений шов не має кінців
weld-allowed-no-key-closed = без цього ключа при `closed = true`
weld-tangent-backwards = дотична дивиться назад, від наступної точки шва
weld-allowed-welding-direction = напрям у бік зварювання
weld-normal-count = нормалей: { $normals }, точок: { $points }
weld-allowed-one-per-point = по одній на точку
weld-second-normals-alone = `second_normals` потребують `first_normals`
weld-allowed-first-normals-too = також `first_normals`
weld-normal-twice = кожна точка вже має власну нормаль
weld-allowed-one-or-all-normals = або одна нормаль, або по одній на точку
weld-allowed-other-normals = інші нормалі
weld-skin-normal-along-web = нормаль обшивки лежить уздовж стінки
weld-allowed-out-of-skin = напрям від обшивки
weld-allowed-thin-web = стінка, значно тонша за радіус дуги
weld-seam-without-surfaces = { $seam } не має поверхонь, до яких припасувати точки
weld-seam-curved-t-joint = криволінійне таврове з’єднання
weld-seam-arc = дуга
weld-seam-rectangle = прямокутник
weld-seam-helix = гвинтова лінія
weld-seam-inside-girth = кільцевий шов усередині труби
weld-seam-spline = сплайн
weld-seam-polyline = ламана
weld-allowed-fit-methods = методи three-point і plane-line-point

# Start and end of the weld.
weld-phi-too-large = кут більший за десять обертів
weld-overlap-with-end = шов до `end_phi_deg` не замикається і не має перекриття
weld-allowed-overlap-or-end = або `overlap_mm`, або `end_phi_deg`
weld-end-beside-turn = шов не мав би довжини або мав би понад оберт
weld-allowed-end-phi-more = більше за phi_deg = { $start }, щонайбільше на { $max }
weld-allowed-end-phi-less = менше за phi_deg = { $start }, щонайбільше на { $max }
weld-overlap-too-long = перекриття довше за шов
weld-start-at-first-point = цей шов починається в першій точці та йде до другої
weld-allowed-points-in-other-order = без цього ключа; задайте точки в іншому порядку
weld-start-of-open-seam = цей шов іде від одного кінця до другого і не замикається
weld-allowed-no-key-on-open-seam = без цього ключа на незамкненому шві

# Data outside the file.
weld-no-machine-here = тут немає верстата
weld-allowed-tip-coordinates = координати вістря x_mm, y_mm, z_mm
weld-no-files-here = тут немає файлів
weld-points-twice = точки задано двічі
weld-allowed-points-or-axes = або `points_mm`, або `axes`
weld-position-not-finite = позиція нескінченна
weld-allowed-finite-numbers = скінченні числа
weld-file-and-points = задано і файл, і `{ $key }`
weld-allowed-points-in-file-or-job = точки та їхні нормалі у файлі або в завданні
weld-table-point-not-finite = { $file }: точка { $point } нескінченна
weld-table-normal-without-length = { $file }: нормаль точки { $point } не має довжини
weld-allowed-coordinates-and-normals = скінченні координати й нормалі з довжиною
weld-procedure-unreadable = файл технології не читається: { $error }
weld-allowed-procedure = { $names } або шлях до файлу технології від теки завдання
weld-procedure-not-text = це не текстовий файл
weld-allowed-toml = файл TOML в UTF-8
weld-wrong-wire = за { $procedure } зварюють дротом { $wire }
weld-two-wires = `{ $other }` = { $wire }: у дроту один діаметр
weld-allowed-wire = { $wire } або інша технологія

# Taught spans.
weld-taught-spans-overlap = ця ділянка починається до кінця попередньої
weld-allowed-taught-from = { $min } або більше; ділянки в порядку зварювання
weld-taught-span-without-length = ділянка не має довжини
weld-taught-span-beyond-seam = ділянка кінчається за номінальним швом
weld-taught-span-without-points = між переходами немає точок
weld-allowed-taught-points = щонайменше одна, у `points_mm` або `axes`
weld-allowed-smooth-points = точки далі одна від одної або ближче до однієї плавної кривої
weld-taught-point-far = точка { $point } за { $distance } від номінального шва між переходами
weld-allowed-taught-within = { $key } = { $value }; або більше `{ $key }`, якщо деталь справді так далеко
weld-taught-point-out-of-order = точка { $point } лежить уздовж шва на s = { $s }
weld-allowed-taught-after-join = після першого переходу на { $min } і до другого переходу на { $max }
weld-allowed-taught-after-point = після попередньої точки на { $min } і до другого переходу на { $max }
weld-taught-point-repeated = точка { $point } збігається із сусідньою точкою або переходом
weld-allowed-taught-apart = точки й переходи не ближче { $min }
weld-taught-curve-turns = біля точки { $point } крива через точки відхиляється на { $angle } від шва
weld-allowed-taught-turn = до { $max }: точки далі одна від одної або ближче до однієї плавної кривої

# Passes.
weld-pass-begins-beyond-end = прохід починається за кінцем шва
weld-pass-round-more-than-twice = прохід обходить шов одним валиком більше двох разів
weld-pass-beyond-end = прохід іде за кінець шва
weld-pass-beyond-start = прохід іде назад за початок шва
weld-pass-without-seam = прохід не має шва, вздовж якого йти
weld-travel-too-long = { $pass }: рух тривав би { $time }
weld-allowed-travel-time = до { $max }: вища швидкість
weld-bead-rows-too-short = рядки не охоплюють увесь прохід
weld-pass-without-motion = у цьому проході ніщо не рухається
weld-allowed-point-elsewhere = точка деінде
weld-arc-points-in-line = початок дуги, `via_mm` і кінець лежать на прямій, або два з них збігаються
weld-allowed-arc-points = три точки не на прямій; повне коло — дві дуги

# Findings of passes.
weld-torch-inside-first-face = пальник увійшов би на { $angle } у поверхню першої деталі (двогранний кут { $dihedral })
weld-torch-inside-second-face = пальник увійшов би на { $angle } у поверхню другої деталі (двогранний кут { $dihedral })
weld-cure-smaller-work-angle = зробіть робочий кут меншим за половину двогранного кута
weld-bead-goes-back = валик (майже) стояв би або йшов назад: він лежить за центром вигину шва, або його рядки змінюються надто швидко
weld-cure-bead-nearer = покладіть валик там ближче до шва
weld-bead-area-out-of-range = щоб заповнити розробку, валик мав би { $area }: { $ratio } від { $run } його проходу; дозволено від { $min } до { $max }
weld-cure-thinner-layers = тонші шари, більші валики (площа, подача дроту, нижча швидкість), adapt = "passes" або більший most_percent
weld-cure-smaller-beads = менші валики (вища швидкість, менше дроту), adapt = "passes" або більший most_percent
weld-bead-width-out-of-window = валик мав би ширину { $width } і висоту { $height }; дозволена ширина: від { $min } до { $max }
weld-bead-height-out-of-window = валик мав би висоту { $height } і ширину { $width }; дозволена висота: від { $min } до { $max }
weld-bead-ratio-out-of-window = валик мав би ширину { $width } і висоту { $height }: відношення { $ratio }; дозволено від { $min } до { $max }
weld-bead-too-wide-without-weave = без коливань валик мав би ширину { $width } і висоту { $height }; дозволено до { $max }
weld-bead-toe-steep = кут переходу лицьового шару був би { $angle }; дозволено { $min } і більше
weld-layer-height-not-kept = шар мав би висоту { $height } замість { $wanted }: валики по { $area } заповнюють його інакше
weld-cure-bead-window = змінити layer_mm або площу проходу (швидкість, подача дроту), adapt = "passes" або вікно в технологічній карті
weld-cure-weave-or-smaller-beads = задати проходу коливання або менші валики (вища швидкість, менше дроту)
weld-cure-bead-toe = зменшити cap_mm, наблизити spacing_to_width до 2/3 або зробити валики лицьового шару пласкішими (коливання, менша площа)
weld-cure-layer-height = наблизити layer_mm до цієї висоти або змінити площу проходу (швидкість, подача дроту)

# Joints.
weld-groove-at = на s = { $s }: { $why }
weld-remaining-area-impossible = розробка не має такої відкритої площі
weld-scan-after-last-layer = до цього заплановано { $layers ->
        [one] { $layers } шар
        [few] { $layers } шари
       *[many] { $layers } шарів
    }: для цього вимірювання не лишилося жодного
weld-scan-too-few-points = точок лише { $found }; потрібно { $needed }
weld-scan-no-groove = розробки немає: на ній лежить { $share } % точок, із розкидом { $scatter } мм
weld-scan-other-angle = поверхні або кромки стоять під { $angle }; на кресленні { $drawn }
weld-scan-uncertain = відкрита площа відома з невизначеністю { $uncertainty }: кромку не видно
weld-groove-no-butt = поверхні під { $dihedral } одна до одної не утворюють стикового з’єднання
weld-groove-no-corner = поверхні під { $dihedral } одна до одної не утворюють кутового чи таврового з’єднання
weld-groove-no-outside-corner = поверхні під кутом { $dihedral } одна до одної не утворюють зовнішнього кута
weld-groove-edge-within-part = підготовлена кромка під { $angle } до поверхні іншої деталі лишається всередині своєї: двогранний кут { $dihedral }
weld-groove-edge-in-other-part = зріз лишає { $angle } до поверхні іншої деталі: кромка була б усередині неї
weld-groove-edges-cross = кромки перетинаються
weld-groove-empty = розробка не має площі
weld-standard-of-other-joints = { $standard } стосується інших з'єднань
weld-joint-beside-standard = { $size }: { $value } при s = { $s }; { $standard } задає для цього розкриття від { $min } до { $max }
weld-joint-below-standard = { $size }: { $value } при s = { $s }; { $standard } задає для цього з'єднання не менше { $min }
weld-joint-beside-standard-at-dihedral = { $size }: { $value } при s = { $s }; { $standard } задає від { $min } до { $max } за двогранного кута { $dihedral }
weld-size-thickness = товщина
weld-size-groove-angle = кут розкриття
weld-size-root-gap = зазор у корені
weld-size-root-face = притуплення
weld-size-cover-throat = товщина кутового шва
weld-cure-joint-standard = змініть розкриття або атестуйте зварювання з ним
weld-allowed-butt-dihedral = двогранний кут { $min } або більше чи кутовий шов
weld-allowed-corner-dihedral = двогранний кут до { $max } чи стикове з’єднання
weld-allowed-outside-corner = двогранний кут від { $min } до { $max } (joint = "corner" у шва)
weld-allowed-edge-cut = усюди більше за 90° мінус двогранний кут
weld-allowed-larger-gap = більший зазор або менше зміщення кромок
weld-allowed-room-to-weld = зазор або кут, що лишає місце для шва

# Beads.
weld-beads-without-joint = немає з’єднання, яке заповнювати
weld-allowed-joint = [joint] з підготовкою кромок
weld-stations-with-beads = разом із [beads] значення задають у [beads.root], [beads.fill] і [beads.cap]
weld-sector-position-unclear = положення сектора неясне
weld-sectors-unequal = сектори задають коефіцієнти для різних величин
weld-sectors-at-one-place = два сектори знаходяться при s = { $s }
weld-feed-follows-area = подача дроту йде за площею розкриття
weld-allowed-s-or-phi = або s_mm, або phi_deg
weld-allowed-same-factors = імена першого рядка
weld-allowed-sectors-apart = різні положення
weld-allowed-no-feed-factor = без коефіцієнта для неї, або інше adapt
weld-allowed-no-table-or-beads = без цієї таблиці або без [beads]
weld-ramp-with-beads = значення, що змінюється по шву, не поєднується з [beads]
weld-travel-angle-twice = кут уздовж задано тут і в кількох позиціях шва
weld-allowed-travel-angle-once = без цього ключа або без [[torch.at]]
weld-area-with-wire-feed = задана площа не змінюється з подачею дроту
weld-allowed-no-area-with-wire-feed = без цього ключа при adapt = "wire_feed"
weld-bead-area-missing = бракує площі валика
weld-insert-without-root = вставці потрібен кореневий прохід, який її розплавить
weld-allowed-insert-root = `root` у [beads] або без вставки
weld-allowed-bead-area = area_mm2 або beads.wire_mm і wire_feed_m_min
weld-bead-area-needs-steady-feed = площа валика потребує сталої подачі дроту
weld-allowed-steady-feed = wire_feed_m_min більше 0 в [weld.process] або тут, чи area_mm2
weld-deposition-too-large = валик мав би більше металу, ніж дріт
weld-bead-range-too-large = валики не тримають форми в такому діапазоні
weld-wall-tilt-too-large = дріт лежав би на стінці
weld-step-over-needs-closed-seam = перехід на наступний валик потребує шва, який зварюють по всьому колу
weld-wire-implausible = дроту завтовшки { $wire } не буває
weld-step-over-too-short = перехід такий короткий, що пальник ішов би впоперек шва
weld-step-over-too-long = перехід довший за половину шва
weld-step-over-with-alternate = валики, з’єднані переходами, йдуть в один бік
weld-step-over-with-passes = шари на частині шва не можна з’єднати переходами
weld-step-over-with-parts = прохід із переходами не можна зварювати частинами
weld-allowed-no-step-over = без переходу або шов по всьому колу
weld-station-distance-invalid = недопустима відстань між перерізами
weld-no-bead-weaves = жоден валик не з коливаннями
weld-allowed-weave = [weld.weave], `weave` у [beads.root], [beads.fill] чи [beads.cap], або інше значення
weld-bead-spacing-invalid = валики не можуть лежати так далеко або так близько
weld-layer-height-impossible = валики по { $area } не дають шарів такої висоти
weld-too-many-beads = розробка { $groove } потребує { $beads } валиків по { $bead }
weld-too-many-stations = валики розкладалися б у { $count ->
        [one] { $count } перерізі
        [few] { $count } перерізах
       *[many] { $count } перерізах
    }
weld-too-many-bead-positions = забагато: проходів { $passes }, рядків у кожному { $rows }
weld-allowed-larger-beads = більші валики: нижча швидкість або більше дроту; розробку заповнюють до { $max } валиків
weld-allowed-smaller-groove = до { $max } валиків: менша розробка або більші валики
weld-allowed-stations = до { $max } перерізів: більша відстань
weld-allowed-bead-positions = до { $max } позицій: більша відстань або більші валики

# Order of welding: copies, parts, tacks.
weld-order-without-rows = немає рядів, між якими ходити туди й назад
weld-allowed-two-rows = два ряди: [rows] або `row` у кожній з [[copies]]
weld-skip-invalid = так не пропускається жодна копія або пропускаються всі
weld-allowed-no-skip = без пропуску: у ряді замало копій
weld-allowed-skip = від 2 до { $max }: у найдовшому ряді { $copies ->
        [one] { $copies } копія
        [few] { $copies } копії
       *[many] { $copies } копій
    }
weld-copies-twice = копії задано двічі
weld-allowed-rows-or-copies = або [rows], або [[copies]]
weld-too-many-passes = { $passes ->
        [one] усього { $passes } прохід
        [few] усього { $passes } проходи
       *[many] усього { $passes } проходів
    }: забагато
weld-allowed-passes = до { $max }: менше копій чи прихваток, або менше чи довші частини
weld-too-many-rows = забагато: проходів { $passes }, усього рядків валиків і ділянок { $rows }
weld-allowed-row-count = до { $max } рядків: менше копій чи прихваток, менше чи довші частини або більше beads.station_mm
weld-copy-count-invalid = недопустима кількість копій
weld-too-many-copies = забагато копій
weld-allowed-columns = від 1 до { $max }: усього копій { $copies }
weld-copies-coincide = копії стояли б в одній позиції
weld-allowed-row-step = крок убік від лінії ряду або за її кінець
weld-copy-too-far = копія стояла б задалеко
weld-allowed-copies-within = копії в межах { $limit } від 0
weld-seam-without-corners = у шва немає кутів
weld-overlap-at-corners = частини від кута до кута не мають перекриття
weld-allowed-no-overlap-at-corners = 0 при order.parts = "at_corners"
weld-seam-without-quarters = шов, який варять не по всьому контуру, не має протилежних чвертей
weld-pieces-longer-than-weld = частини були б довші за шов
weld-too-many-pieces = забагато частин
weld-allowed-piece-length = щонайменше { $min }: до { $count } частин
weld-tie-in-too-long = перекриття частин не коротше за частину
weld-allowed-tie-in = менше за частину: { $max }
weld-all-round-has-one-end = шов, який варять по всьому контуру, кінчається там, де починається
weld-cosmetic-ramp = косметичний прохід має сталі значення
weld-cosmetic-beyond-end = косметичний прохід починається за кінцем шва
weld-tack-count-or-pitch = кількість прихваток задає рівно один із двох ключів
weld-allowed-count-or-pitch = або `count`, або `pitch_mm`
weld-tack-count-invalid = недопустима кількість прихваток
weld-tack-ramp = прихватка має сталі значення
weld-too-many-tacks = забагато прихваток
weld-allowed-tack-pitch = щонайменше { $min }: до { $count } прихваток
weld-tacks-meet = прихватки зійшлися б
weld-allowed-tack-length = менше за відстань від прихватки до прихватки: { $count } на { $length } шва
weld-tacks-near-start = прихватки почалися б за { $distance } від початку шва
weld-allowed-tack-clearance = до { $max } або менше прихваток

# The part as solids.
weld-part-replaced-by-nothing = деталь, створену зі шва, замінено, але тіл не задано
weld-allowed-part-solids = [[part.solids]] разом із ним або без цього ключа
weld-allowed-rigid-placement = жорстке розміщення
weld-body-too-short = тіло кінчалося б у межах шва
weld-part-from-seam = деталь, створена зі шва: { $why }
weld-allowed-part-sizes = розміри до { $max }, також у [part]; або [[part.solids]] з part.replace = true
weld-allowed-sphere = сфера
