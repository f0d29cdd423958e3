# Limits of axes and of the torch tip.
motion-limit-speed = межа швидкості
motion-limit-acceleration = межа прискорення
motion-limit-jerk = межа ривка

# Speed that the axes do not allow.
motion-speed-axis = вісь { $axis } не тримає { $asked }: її { $limit } { $value } дозволяє { $reached }
motion-speed-tip = вістря пальника не тримає { $asked }: його { $limit } { $value } дозволяє { $reached }
motion-speed-rounded-off = вістря йде { $reached } замість { $asked }: задана швидкість там змінюється, і профіль швидкості згладжує цю зміну
motion-speed-slowed = { $reason }; зварювання там сповільнюється, як задано
motion-too-short = шов надто короткий: між розгоном і гальмуванням досягає { $reached } з { $asked }
motion-too-short-between-stops = шлях між двома зупинками надто короткий: між розгоном і гальмуванням досягає { $reached } з { $asked }
motion-no-speed-profile = для осей { $machine } немає профілю швидкості: { $reason }
motion-profile-limit = { $limit } каналу { $channel } дорівнює { $value }; потрібне скінченне число, більше за 0 (межа ривка може бути нескінченною)
motion-profile-asked = задана швидкість у { $at } дорівнює { $value }; вона має бути більшою за 0
motion-profile-range = шлях іде від { $from } до { $to }; його кінець має бути скінченним числом, більшим за початок
motion-profile-not-smooth = канал { $channel } не гладкий у { $at }: похідна не є скінченним числом
motion-profile-still = між { $from } і { $to } ніщо не рухається: жодна межа не обмежує там швидкість

# Weave that is too fast.
motion-weave-frequency = коливання надто швидкі: { $reason }; при ширині { $width } найбільша частота { $frequency }
motion-weave-pitch = коливання надто швидкі: { $reason }; при ширині { $width } найменший крок { $pitch }

# Corners: stops and blends.
motion-stop = пальник зупиняється на s = { $s } з увімкненою дугою: швидкість чи прискорення осі { $axis } там стрибнули б
motion-stop-because = пальник зупиняється на s = { $s } з увімкненою дугою: швидкість чи прискорення осі { $axis } там стрибнули б; { $reason }
motion-blend = пальник заокруглює кут на s = { $s }: на { $over } вістря відходить від шва до { $deviation }
motion-blend-turned = пальник заокруглює кут на s = { $s }: на { $over } вістря відходить від шва до { $deviation }, а напрям — до { $turned }
motion-blend-no-room = для заокруглення немає місця: до наступного кута чи кінця { $distance }
motion-blend-turns-back = шлях там повертає назад, і заокруглення неможливе
motion-blend-too-far = найкоротше заокруглення, на { $over }, відводить вістря більш як на { $deviation } від шва або повертає пальник більш як на { $turned } від заданого напряму
motion-cure-stop-weave = задайте corner = "stop", щоб зупинитися там з дугою; або коливання за pitch_mm замість частоти; або заокругліть шов; або закінчіть там шов і почніть інший
motion-cure-stop-or-blend = задайте corner = "stop", щоб зупинитися там з дугою, або corner = {"{ blend_mm = 0.2 }"}, щоб обійти кут не далі цього від шва; або заокругліть шов; або закінчіть там шов і почніть інший
motion-cure-stop = задайте corner = "stop", щоб зупинятися на кутах; або заокругліть шов; або закінчіть там шов і почніть інший

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = вістря йде { $reached } на s = { $at } з увімкненою дугою, а мінімальна швидкість за технологією { $minimum }: там зупинка на куті
motion-least-speed-axis = вістря йде { $reached } на s = { $at } з увімкненою дугою, а мінімальна швидкість за технологією { $minimum }: { $limit } осі { $axis }, { $value }, не дозволяє більше
motion-least-speed-tip = вістря йде { $reached } на s = { $at } з увімкненою дугою, а мінімальна швидкість за технологією { $minimum }: { $limit } вістря пальника, { $value }, не дозволяє більше
motion-least-speed-short = вістря йде { $reached } на s = { $at } з увімкненою дугою, а мінімальна швидкість за технологією { $minimum }: шов надто короткий, щоб досягти більшої
motion-least-speed-start = пальник рушає з місця з увімкненою дугою: на { $over } він повільніший за мінімальну швидкість технології { $minimum }
motion-least-speed-end = пальник зупиняється з увімкненою дугою: на { $over } він повільніший за мінімальну швидкість технології { $minimum }
motion-cure-least-speed-blend = задайте corner = {"{ blend_mm = 0.2 }"}, щоб обходити кути не далі цього від шва; або закінчіть шов перед цим і почніть інший після; або зменште least_speed_mm_s, якщо технологія атестована для цього
motion-cure-least-speed-axis = поставте деталь чи поверніть пальник так, щоб вісь { $axis } рухалася там менше; або закінчіть шов перед цим і почніть інший після; або зменште least_speed_mm_s, якщо технологія атестована для цього
motion-cure-least-speed-tip = підвищте межі вістря у файлі верстата, якщо пальник це витримує; або закінчіть шов перед цим і почніть інший після; або зменште least_speed_mm_s, якщо технологія атестована для цього
motion-cure-least-speed-longer = зробіть шов довшим; або закінчіть шов перед цим і почніть інший після; або зменште least_speed_mm_s, якщо технологія атестована для цього

# Operator actions against a speed that the axes do not allow.
motion-cure-longer-change = розтягніть зміну швидкості на довший шлях або задайте weld.on_limit = "slow", щоб там сповільнитися
motion-cure-speed = задайте { $speed }, які всі осі тримають усюди, або weld.on_limit = "slow", щоб там сповільнитися
motion-cure-speed-or-blend = задайте { $speed }, які всі осі тримають усюди, або weld.on_limit = "slow", щоб там сповільнитися, або дозвольте довше заокруглення
motion-cure-speed-part = задайте { $part } швидкості, які всі осі тримають усюди, або weld.on_limit = "slow", щоб там сповільнитися
motion-cure-speed-part-or-blend = задайте { $part } швидкості, які всі осі тримають усюди, або weld.on_limit = "slow", щоб там сповільнитися, або дозвольте довше заокруглення
motion-cure-slow = задайте weld.on_limit = "slow", щоб там сповільнитися
motion-cure-slow-or-blend = задайте weld.on_limit = "slow", щоб там сповільнитися, або дозвольте довше заокруглення
motion-cure-speed-at-most = задайте { $speed } або менше, або weld.on_limit = "slow"
motion-cure-weave-frequency = задайте frequency_hz { $frequency } або меншу ширину, або weld.on_limit = "slow", щоб там сповільнитися
motion-cure-weave-pitch = задайте pitch_mm { $pitch }, меншу ширину чи меншу швидкість, або weld.on_limit = "slow", щоб там сповільнитися
motion-cure-limits = задайте осям верстата скінченні межі, більші за 0, а проходу — швидкість і довжину

# Times.
motion-time-too-long = { $key } = { $time }: прохід може тривати щонайбільше { $limit }
motion-cure-time = задайте { $key } не більше { $limit }
motion-travel-too-long = із заданою швидкістю рух триває { $time }: прохід може тривати щонайбільше { $limit }
motion-cure-travel = задайте більшу speed_mm_s або поділіть шов на кілька проходів
motion-travel-too-long-axes = з межами осей рух триває { $time }: прохід може тривати щонайбільше { $limit }
motion-cure-travel-axes = задайте осям верстата більші швидкості та прискорення або поділіть шов на кілька проходів

# Reach and ranges of the axes.
motion-unreachable = { $machine }: { $reason }
motion-cure-unreachable = змініть розміщення деталі, кути пальника або верстат
motion-no-solution = жодні положення осей не відповідають шляху
motion-no-positions = жодні положення осей не досягають його
motion-axis-beyond = вісь { $axis } мала б вийти на { $by } за свій діапазон
motion-unreachable-redundant = { $machine }, за будь-якого положення надлишкових осей: { $reason }
motion-cure-unreachable-redundant = змініть розміщення деталі, кути пальника або утримувані осі
motion-beyond-range = вісь { $axis } дійшла б до { $value }, на { $by } за межу { $limit }
motion-cure-range = поставте деталь так, щоб вісь лишалась у діапазоні
motion-attitude = { $machine } має замало осей для повної орієнтації пальника: відхилення від заданої до { $error } (допуск { $tolerance })
motion-arc-off-line = { $machine } не може тримати задану орієнтацію пальника, а пальник відведено на { $back } заради вильоту: дуга була б на { $off } збоку від лінії
motion-cure-attitude = змініть кути пальника, візьміть верстат з іще однією поворотною віссю або дозвольте більше в tolerance.attitude_deg
motion-cure-arc-off-line = зварюйте з вильотом верстата, змініть кути пальника або візьміть верстат з іще однією поворотною віссю
motion-not-smooth = осі { $machine } не можуть тут плавно йти за пальником: він проходить сингулярне положення
motion-not-smooth-redundant = за будь-якого положення надлишкових осей { $machine } решта осей не може плавно йти за пальником: він проходить сингулярне положення або виходить за їх досяжність
motion-jump = кожне положення досяжне, але не безперервно: між s = { $from } і { $to } вісь { $axis } мала б стрибнути на { $by }
motion-cure-jump = не випробувано: може допомогти зварювання частинами (start.end_phi_deg), інший початок або інше розміщення деталі
motion-near-singular = за { $distance } від сингулярного положення вісь { $axis } потребує { $used } своїх можливостей при { $asked }; тут можливі { $holds }
motion-cure-near-singular = щоб мати запас, нахиліть пальник чи деталь на кілька градусів

# Axes that are held.
motion-hold-unknown = між деталлю і пальником немає осі { $axis }
motion-hold-decided = вісь { $axis } не є надлишковою: поза пальника тут визначає всі осі
motion-hold-too-few = якщо утримувати { $held }, інші осі не досягають усіх поз пальника
motion-hold-range = вісь { $axis } утримувалася б на { $value }, поза її діапазоном
motion-hold-allowed-none = жодної осі
motion-hold-allowed-count = { $axes ->
    [1] одна вісь або інша
    [one] до { $axes } осі або інші
    [few] до { $axes } осей або інші
   *[many] до { $axes } осей або інші
}

# Changes of the job that were tried as cures.
motion-change-move = зсуньте деталь на { $x }; { $y }; { $z } уздовж x, y, z (placement.move_mm)
motion-change-work-angle = змініть torch.work_angle_deg на { $by }
motion-change-work-angles = змініть work_angle_deg у кожному [[torch.at]] на { $by }
motion-cure-range-weld = { $change }: перевірено, усі осі тоді лишаються в діапазонах
motion-cure-range-pass = { $change }: перевірено для цього проходу, усі осі тоді лишаються в діапазонах
motion-cure-range-none = не знайдено: випробувано зсув деталі та зміну робочого кута
motion-cure-range-none-moved = не знайдено: випробувано зсув деталі
motion-cure-range-none-angle = не знайдено: випробувано зміну робочого кута
motion-cure-range-none-stroke = { $tried }; осі { $axis } потрібно { $needed } уздовж шва, її діапазон { $stroke }
motion-cure-redundant = з надлишковими осями зміни не випробувано: поставте деталь ближче до середини діапазонів осей
motion-cure-range-no-time = у дозволений час змін не випробувано
motion-cure-range-stopped = { $changes ->
    [one] у дозволений час не знайдено: випробувано { $tried } з { $changes } зміни
    [few] у дозволений час не знайдено: випробувано { $tried } з { $changes } змін
   *[many] у дозволений час не знайдено: випробувано { $tried } з { $changes } змін
}
motion-cure-not-tried = не випробувано: можуть допомогти інші кути пальника або інше розміщення деталі

# Clearance.
motion-too-near = { $first } і { $second }: відстань { $distance } (потрібно щонайменше { $minimum })
motion-collision = { $first } і { $second }: зіткнення (потрібно щонайменше { $minimum })
motion-above-root = { $contact }, на { $height } вище кореня
motion-below-root = { $contact }, на { $height } нижче кореня
motion-no-torch-angle = жоден кут у межах { $work } від робочого і { $travel } від кута нахилу вздовж шва не лишає пальнику місця: { $reason }
motion-no-torch-angle-longer = жоден кут у межах { $work } від робочого і { $travel } від кута нахилу вздовж шва не лишає пальнику місця, навіть із вильотом на { $longer } більшим: { $reason }
motion-angle-none-allowed = поверхні з’єднання, технологія або хід осі не допускають жодного з них
motion-angle-turns-too-fast = вільні кути змінюються більше ніж на { $turn } на довжині { $way }
motion-cure-torch-angle = тонший пальник або більший виліт, ширша розробка, ширші межі в torch.search або менша відстань у clearance.least_mm
motion-cure-clearance = змініть кути пальника чи розміщення або дозвольте менше в clearance.least_mm, якщо форми правильні
motion-cure-clearance-weld = { $change }: перевірено, усі відстані тоді достатні; або дозвольте менше в clearance.least_mm, якщо форми правильні
motion-cure-clearance-pass = { $change }: перевірено для цього проходу, усі відстані тоді достатні; або дозвольте менше в clearance.least_mm, якщо форми правильні
motion-cure-clearance-none = не знайдено: робочі кути до { $angle } від цього не допомагають; приберіть перешкоду або дозвольте менше в clearance.least_mm, якщо форми правильні
motion-cure-clearance-stopped = { $angles ->
    [one] у дозволений час не знайдено: випробувано { $tried } з { $angles } робочого кута; приберіть перешкоду або дозвольте менше в clearance.least_mm, якщо форми правильні
    [few] у дозволений час не знайдено: випробувано { $tried } з { $angles } робочих кутів; приберіть перешкоду або дозвольте менше в clearance.least_mm, якщо форми правильні
   *[many] у дозволений час не знайдено: випробувано { $tried } з { $angles } робочих кутів; приберіть перешкоду або дозвольте менше в clearance.least_mm, якщо форми правильні
}
motion-cure-clearance-move = приберіть перешкоду або дозвольте менше в clearance.least_mm, якщо форми правильні
motion-no-shapes = { $machine } не має форм: зіткнення не перевіряються, холості ходи прямі
motion-cure-no-shapes = опишіть пальник і ланки через [[shapes.<link>]] у файлі верстата

# Transfer moves.
motion-transfer-from-home = холостий хід від вихідного положення до шва
motion-transfer-home = холостий хід від шва до вихідного положення
motion-transfer-between = холостий хід від проходу { $from } до проходу { $to }
motion-transfer-too-long = { $move }: триває { $time }, а може щонайбільше { $limit }
motion-cure-transfer-too-long = задайте осям верстата більші швидкості та прискорення або посуньте деталь ближче
motion-transfer-blocked = { $move }: { $reason }
motion-cure-transfer-blocked = не випробувано: може допомогти зсув деталі, оснащення чи вихідного положення або інший початок шва
motion-transfer-start = на його початку перешкода: { $obstacle }
motion-transfer-end = у його кінці перешкода: { $obstacle }
motion-transfer-retract = на шляху відведення перешкода: { $obstacle }
motion-transfer-approach = на шляху підведення перешкода: { $obstacle }
motion-transfer-none = вільного шляху не знайдено; на прямому шляху: { $obstacle }
motion-retract-short = { $move }: пальник може відійти лише на { $distance } з { $asked }
motion-retract-none = { $move }: жодна вісь не відведе пальник уздовж його осі, він відходить убік
motion-cure-retract = переконайтеся, що біля шва там нічого не стоїть, або задайте менше відведення
motion-unwind = { $move }: вісь { $axis } відмотується назад на { $by }

# Planning that was stopped.
motion-search-out-of-time = за { $limit } пошуку плану не знайдено: { $progress }
motion-search-cancelled = планування скасовано: { $progress }
motion-search-progress = { $positions ->
    [one] { $stage }, виконано { $part }, випробувано { $positions } положення
    [few] { $stage }, виконано { $part }, випробувано { $positions } положення
   *[many] { $stage }, виконано { $part }, випробувано { $positions } положень
}
motion-search-reach = розв’язання поз уздовж шва
motion-search-sampling = вибірка положень надлишкових осей
motion-search-joining = з’єднання вибраних положень
motion-search-refining = уточнення надлишкових осей
motion-search-speed = планування профілю швидкості
motion-search-weave = перебір частот коливань
motion-search-transfer = пошук холостого ходу
motion-search-cure = перевірка заходів
motion-search-torch-angles = перебір кутів пальника
motion-cure-search = дозвольте більше часу, зафіксуйте надлишкові осі (spare_axes.hold), звузьте їхні діапазони у файлі верстата або зваріть шов частинами
motion-cure-plan-again = сплануйте ще раз

# Comparison with the welding procedure specification.
motion-quantity-speed = швидкість вістря
motion-quantity-heat-input = тепловкладення
motion-quantity-travel-angle = кут уздовж шва
motion-quantity-work-angle = кут поперек шва
motion-quantity-stick-out = виліт дроту
motion-run-pass = прохід { $passes }
motion-run-passes = проходи { $passes }
motion-procedure-outside = { $quantity } становить { $found } на s = { $at }; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-procedure-unbounded = { $quantity } необмежене на s = { $at }, де пальник зупиняється з увімкненою дугою; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-procedure-no-power = прохід не задає { $keys }, тому його тепловкладення невідоме; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-procedure-no-faces = поверхні з’єднання невідомі, тому й кут поперек шва невідомий; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-procedure-no-stick-out = виліт дроту невідомий; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-procedure-missing = прохід не задає { $key }; { $procedure } дозволяє ({ $run }) від { $min } до { $max }
motion-implausible = { $key } = { $found } не пасує до { $current }: зазвичай { $expected } ± { $percent }
motion-cure-implausible = перевірте { $key }, струм і дріт; для особливої дуги збільште percent у [plausibility] процедури
motion-cooling-outside = шов охолоджується з 800 до 500 °C за { $found }; допустимо від { $min } до { $max }
motion-cooling-unbounded = пальник зупиняється з дугою: час охолодження не обмежений; допустимо від { $min } до { $max } (не більше { $found })
motion-cure-cooling-slow = зменште погонну енергію або міжшарову температуру
motion-cure-cooling-fast = збільште погонну енергію або підігрів
motion-preheat-low = процедура вимагає підігрів { $found }; EN 1011-2 (метод B) — { $needed }
motion-pool-too-large = валик має { $area } на s = { $s } у положенні { $position }; без коливань утримується до { $max }
motion-cure-preheat-low = підвищте мінімум preheat_c та interpass_c до { $needed }
motion-cure-pool = менші валики (вища швидкість, менше дроту) або коливання, чи повернути деталь ближче до нижнього положення
motion-preheat-range = підігрів екстрапольовано: метод B за EN 1011-2 — для CET 0,2–0,5 %, 10–90 мм, 1–20 мл водню на 100 г та 0,5–4 кДж/мм
motion-interpass-wait = очікування { $time }, доки шов охолоне
motion-interpass-thickness = для очікування міжшарової температури потрібна товщина деталей
motion-interpass-power = для очікування міжшарової температури потрібна погонна енергія
motion-interpass-never = шов не охолоджується нижче міжшарової температури за дві доби
motion-cure-interpass = доповніть [materials] і процедуру або задайте wait_s замість below_c в [interpass]
motion-procedure-no-run = жоден прохід технології { $procedure } не стосується проходу { $pass } ({ $name })
motion-procedure-position = шов у положенні { $position }; { $procedure } дозволяє ({ $run }) { $positions }
motion-procedure-inclination = шов у положенні { $position } (нахил від { $min_slope } до { $max_slope }, поворот від { $min_rotation } до { $max_rotation }); { $procedure } дозволяє ({ $run }) { $positions }
motion-cure-procedure-run = додайте [[runs]] з назвою чи номером проходу у файл технології або перейменуйте прохід; або візьміть технологію, атестовану для цього
motion-cure-procedure-power = задайте { $keys } у weld.process або вкажіть у `power` технології величини, що дають потужність; або візьміть технологію, атестовану для цього
motion-cure-procedure-work-angle = приберіть work_angle_deg із проходу технології; або візьміть технологію, атестовану для цього
motion-cure-procedure-stick-out = вкажіть stick_out_mm у [torch] файлу верстата
motion-cure-procedure-own-stick-out = змініть stick_out_mm проходу або в [torch]; або візьміть технологію, атестовану для цього
motion-cure-procedure-missing = задайте { $key } у weld.process або приберіть з [runs.ranges]; або візьміть технологію, атестовану для цього
motion-cure-procedure-slower = задайте там меншу швидкість; або візьміть технологію, атестовану для цього
motion-cure-procedure-faster = задайте там більшу швидкість або поставте деталь так, щоб осі її тримали; або візьміть технологію, атестовану для цього
motion-cure-procedure-less-heat = варіть там швидше або з меншою потужністю; або візьміть технологію, атестовану для цього
motion-cure-procedure-more-heat = варіть там повільніше або з більшою потужністю; або візьміть технологію, атестовану для цього
motion-cure-procedure-angles = змініть там кути пальника або візьміть верстат із достатньою кількістю осей; або візьміть технологію, атестовану для цього
motion-cure-procedure-lower = зменште там { $key } (weld.process завдання або ділянки програми); або візьміть технологію, атестовану для цього
motion-cure-procedure-raise = збільште там { $key } (weld.process завдання або ділянки програми); або візьміть технологію, атестовану для цього
motion-cure-procedure-position = поверніть чи нахиліть деталь інакше (placement, зсув нуля деталі, spare_axes) або варіть у зворотному напрямі, де це перетворює спуск на підйом; або візьміть технологію, атестовану для цього

# Simulated weld.
motion-simulated-path = вістря пальника в симуляції відходить від шва на { $deviation }; дозволено { $tolerance }
motion-cure-simulated-path = гляньте на похибки слідкування: налаштуйте контури положення або варіть повільніше
motion-cure-simulated-path-tracked = гляньте на результати стеження: давач, швидкість і досяжність корекцій
motion-cure-simulated-path-untracked = стежте за швом або поставте деталь, як заплановано
motion-simulated-speed = швидкість вістря в симуляції відрізняється від запланованої на { $deviation }; дозволено { $tolerance }
motion-cure-simulated-speed = візьміть точніші енкодери, м’якші контури положення, менше тертя або більшу швидкість
motion-simulated-stop = зварювання зупинено на { $at }: { $reason }; далі нічого не зварено
motion-simulated-other-head = зупинилася інша головка
motion-cure-simulated-stop = поставте деталь ближче до запланованого місця, полагодьте давач або варіть повільніше
motion-simulated-drive = привід осі { $axis } доходить до межі струму
motion-cure-simulated-drive = візьміть потужніший привід або менше max_acceleration у файлі верстата

# Playing a speed profile under an operator's commands.
motion-override = корекція подачі має бути від 0 до { $max }, а не { $value } (до 1,5 — з профілем, спланованим для такої швидкості)
motion-override-faster = корекція подачі має бути від 0 до { $max }, а не { $value }
motion-override-zero = корекція подачі 0: задайте більшу за 0, перш ніж продовжити
motion-period = період має бути від 0,00025 до 0,004 с, а не { $value }
motion-path-length = довжина шляху має бути від 0 до { $length }, а не { $value }
motion-faster-profile = швидший профіль має бути спланований для понад 1 і до 1,5 швидкості, а не { $value }
motion-step-end = крок має закінчитися за { $welded }, де кінець звареного, і щонайбільше на { $length }, а не на { $value }
motion-stuck = рух не може продовжитися на { $s }: профіль швидкості там виходить за межі осей

# Manual motion.
motion-jog-range = вісь { $axis } не може йти до { $value }: її діапазон від { $min } до { $max }
motion-jog-position = положення осі { $axis } не є скінченним числом
motion-jog-speed = швидкість осі { $axis } не є скінченним числом
motion-jog-tip = швидкість вістря не є скінченним числом
motion-jog-period = період { $value }; він має бути більшим за 0, щонайбільше 1 с
motion-jog-silence = час очікування сигналу { $value }; він має бути більшим за 0, щонайбільше 1 с
motion-jog-override = корекція подачі { $value }; вона має бути більшою за 0, щонайбільше 1
motion-jog-axis = { $axes ->
    [one] верстат має { $axes } вісь, осі { $axis } немає
    [few] верстат має { $axes } осі, осі { $axis } немає
   *[many] верстат має { $axes } осей, осі { $axis } немає
}
motion-jog-not-clear = на початку між { $first } і { $second } { $distance }; потрібно щонайменше { $minimum }
motion-jog-halted = ручний рух зупинено: спершу дайте команду спокою
motion-jog-no-motion = руху в межах від теперішнього стану до цілі не знайдено

# Pulses.
motion-pulses-too-fast = період потребує { $asked } імпульсів, можливо щонайбільше { $max }
motion-pulses-crowded = { $pulses ->
    [one] { $pulses } імпульс не вміщується між зміною напряму і кінцем періоду
    [few] { $pulses } імпульси не вміщуються між зміною напряму і кінцем періоду
   *[many] { $pulses } імпульсів не вміщується між зміною напряму і кінцем періоду
}
motion-pulses-position = положення { $steps } кроків задалеко від нуля для лічби; дозволено: до 1e11
motion-pulses-period = період { $ticks } тактів таймера; дозволено: від 1 до 2,7e11

# Textbook interpolators.
motion-value-not-positive = { $what }: потрібне скінченне число, більше за 0, а не { $value }
motion-value-not-finite = { $what }: потрібне скінченне число, а не { $value }
motion-value-semi-axis-a = піввісь a
motion-value-semi-axis-b = піввісь b
motion-value-x = x точки
motion-value-y = y точки
motion-value-nozzle-radius = радіус штуцера
motion-value-shell-radius = радіус обичайки
motion-value-start-angle = кут початку
motion-value-sweep = кут обходу
motion-value-speed = швидкість
motion-value-period = період
motion-value-step = швидкість, помножена на період
motion-value-pulse = імпульс
motion-start-off-ellipse = початкова точка ({ $x }; { $y }) лежить за { $distance } від еліпса; дозволено щонайбільше { $tolerance }, найближча точка на ньому ({ $near_x }; { $near_y })
motion-end-off-ellipse = кінцева точка ({ $x }; { $y }) лежить за { $distance } від еліпса; дозволено щонайбільше { $tolerance }, найближча точка на ньому ({ $near_x }; { $near_y })
motion-nozzle-too-large = радіус штуцера { $nozzle } має бути меншим за радіус обичайки { $shell }
motion-sweep = кут обходу має відрізнятися від 0 і бути щонайбільше { $limit } у кожен бік, а не { $sweep }
motion-step-too-long = крок { $step } (швидкість, помножена на період) задовгий для цього шляху: щонайбільше { $max } (довжина шляху або восьма частина повного оберту)
motion-pulse-too-large = імпульс { $pulse } завеликий для цієї форми: щонайбільше { $max }
motion-too-many-steps = для цього потрібно близько { $steps } кроків або імпульсів; межа { $max }
motion-not-verified = прохід { $pass }: заплановане переміщення невиконуване ({ $why })

# Reach of placements.
motion-reach-jump = немає неперервного руху осей уздовж шляху
motion-reach-speed = вісь { $axis } потребувала б { $used } своєї швидкості при { $asked }
motion-reach-position = положення зварювання на { $by } поза дозволеними процедурою
