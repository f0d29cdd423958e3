# Limits of axes and of the torch tip.
motion-limit-speed = предел скорости
motion-limit-acceleration = предел ускорения
motion-limit-jerk = предел рывка

# Speed that the axes do not allow.
motion-speed-axis = ось { $axis } не держит { $asked }: её { $limit } { $value } позволяет { $reached }
motion-speed-tip = остриё горелки не держит { $asked }: его { $limit } { $value } позволяет { $reached }
motion-speed-rounded-off = остриё идёт { $reached } вместо { $asked }: заданная скорость там меняется, и профиль скорости сглаживает это изменение
motion-speed-slowed = { $reason }; сварка там замедляется, как задано
motion-too-short = шов слишком короткий: между разгоном и торможением достигается { $reached } из { $asked }
motion-too-short-between-stops = путь между двумя остановками слишком короткий: между разгоном и торможением достигается { $reached } из { $asked }
motion-no-speed-profile = для осей { $machine } нет профиля скорости: { $reason }
motion-profile-limit = { $limit } канала { $channel } равен { $value }; нужно конечное число больше 0 (предел рывка может быть бесконечным)
motion-profile-asked = заданная скорость в { $at } равна { $value }; она должна быть больше 0
motion-profile-range = путь идёт от { $from } до { $to }; его конец должен быть конечным числом больше начала
motion-profile-not-smooth = канал { $channel } не гладкий в { $at }: производная не является конечным числом
motion-profile-still = между { $from } и { $to } ничто не движется: ни один предел не ограничивает там скорость

# Weave that is too fast.
motion-weave-frequency = колебания слишком быстрые: { $reason }; при ширине { $width } наибольшая частота { $frequency }
motion-weave-pitch = колебания слишком быстрые: { $reason }; при ширине { $width } наименьший шаг { $pitch }

# Corners: stops and blends.
motion-stop = горелка останавливается на s = { $s } с горящей дугой: скорость или ускорение оси { $axis } там изменились бы скачком
motion-stop-because = горелка останавливается на s = { $s } с горящей дугой: скорость или ускорение оси { $axis } там изменились бы скачком; { $reason }
motion-blend = горелка скругляет угол на s = { $s }: на { $over } остриё отходит от шва до { $deviation }
motion-blend-turned = горелка скругляет угол на s = { $s }: на { $over } остриё отходит от шва до { $deviation }, а направление — до { $turned }
motion-blend-no-room = для скругления нет места: до следующего угла или конца { $distance }
motion-blend-turns-back = путь там поворачивает назад, и скругление невозможно
motion-blend-too-far = кратчайшее скругление, на { $over }, отводит остриё больше чем на { $deviation } от шва или поворачивает горелку больше чем на { $turned } от заданного направления
motion-cure-stop-weave = задайте corner = "stop", чтобы остановиться там с дугой; или колебания по pitch_mm вместо частоты; или скруглите шов; или закончите там шов и начните другой
motion-cure-stop-or-blend = задайте corner = "stop", чтобы остановиться там с дугой, или corner = {"{ blend_mm = 0.2 }"}, чтобы обойти угол не дальше этого от шва; или скруглите шов; или закончите там шов и начните другой
motion-cure-stop = задайте corner = "stop", чтобы останавливаться на углах; или скруглите шов; или закончите там шов и начните другой

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = остриё идёт { $reached } на s = { $at } с горящей дугой, а минимальная скорость по технологии { $minimum }: там остановка на углу
motion-least-speed-axis = остриё идёт { $reached } на s = { $at } с горящей дугой, а минимальная скорость по технологии { $minimum }: { $limit } оси { $axis }, { $value }, не позволяет больше
motion-least-speed-tip = остриё идёт { $reached } на s = { $at } с горящей дугой, а минимальная скорость по технологии { $minimum }: { $limit } острия горелки, { $value }, не позволяет больше
motion-least-speed-short = остриё идёт { $reached } на s = { $at } с горящей дугой, а минимальная скорость по технологии { $minimum }: шов слишком короткий, чтобы достичь большей
motion-least-speed-start = горелка трогается с места с горящей дугой: на { $over } она медленнее минимальной скорости технологии { $minimum }
motion-least-speed-end = горелка останавливается с горящей дугой: на { $over } она медленнее минимальной скорости технологии { $minimum }
motion-cure-least-speed-blend = задайте corner = {"{ blend_mm = 0.2 }"}, чтобы обходить углы не дальше этого от шва; или закончите шов перед этим и начните другой после; или уменьшите least_speed_mm_s, если технология аттестована для этого
motion-cure-least-speed-axis = поставьте деталь или поверните горелку так, чтобы ось { $axis } двигалась там меньше; или закончите шов перед этим и начните другой после; или уменьшите least_speed_mm_s, если технология аттестована для этого
motion-cure-least-speed-tip = повысьте пределы острия в файле станка, если горелка это выдерживает; или закончите шов перед этим и начните другой после; или уменьшите least_speed_mm_s, если технология аттестована для этого
motion-cure-least-speed-longer = сделайте шов длиннее; или закончите шов перед этим и начните другой после; или уменьшите least_speed_mm_s, если технология аттестована для этого

# Operator actions against a speed that the axes do not allow.
motion-cure-longer-change = растяните изменение скорости на более длинный путь или задайте weld.on_limit = "slow", чтобы там замедлиться
motion-cure-speed = задайте { $speed }, которые все оси держат везде, или weld.on_limit = "slow", чтобы там замедлиться
motion-cure-speed-or-blend = задайте { $speed }, которые все оси держат везде, или weld.on_limit = "slow", чтобы там замедлиться, или разрешите более длинное скругление
motion-cure-speed-part = задайте { $part } скорости, которые все оси держат везде, или weld.on_limit = "slow", чтобы там замедлиться
motion-cure-speed-part-or-blend = задайте { $part } скорости, которые все оси держат везде, или weld.on_limit = "slow", чтобы там замедлиться, или разрешите более длинное скругление
motion-cure-slow = задайте weld.on_limit = "slow", чтобы там замедлиться
motion-cure-slow-or-blend = задайте weld.on_limit = "slow", чтобы там замедлиться, или разрешите более длинное скругление
motion-cure-speed-at-most = задайте { $speed } или меньше, или weld.on_limit = "slow"
motion-cure-weave-frequency = задайте frequency_hz = { $frequency } или меньшую ширину, или weld.on_limit = "slow", чтобы там замедлиться
motion-cure-weave-pitch = задайте pitch_mm = { $pitch }, меньшую ширину или меньшую скорость, или weld.on_limit = "slow", чтобы там замедлиться
motion-cure-limits = задайте осям станка конечные пределы больше 0, а проходу — скорость и длину

# Times.
motion-time-too-long = { $key } = { $time }: проход может длиться не дольше { $limit }
motion-cure-time = задайте { $key } не больше { $limit }
motion-travel-too-long = с заданной скоростью движение длится { $time }: проход может длиться не дольше { $limit }
motion-cure-travel = задайте большую speed_mm_s или разделите шов на несколько проходов
motion-travel-too-long-axes = с пределами осей движение длится { $time }: проход может длиться не дольше { $limit }
motion-cure-travel-axes = задайте осям станка большие скорости и ускорения или разделите шов на несколько проходов

# Reach and ranges of the axes.
motion-unreachable = { $machine }: { $reason }
motion-cure-unreachable = измените размещение детали, углы горелки или станок
motion-no-solution = никакие положения осей не следуют пути
motion-no-positions = никакие положения осей не достигают его
motion-axis-beyond = ось { $axis } должна была бы выйти на { $by } за свой диапазон
motion-unreachable-redundant = { $machine }, при любом положении избыточных осей: { $reason }
motion-cure-unreachable-redundant = измените размещение детали, углы горелки или удерживаемые оси
motion-beyond-range = ось { $axis } дошла бы до { $value }, на { $by } за предел { $limit }
motion-cure-range = поставьте деталь так, чтобы ось оставалась в диапазоне
motion-attitude = у { $machine } слишком мало осей для полной ориентации горелки: отклонение от заданной до { $error } (допуск { $tolerance })
motion-arc-off-line = { $machine } не может держать заданную ориентацию горелки, а горелка отведена на { $back } ради вылета: дуга была бы на { $off } в стороне от линии
motion-cure-attitude = измените углы горелки, возьмите станок с ещё одной поворотной осью или разрешите больше в tolerance.attitude_deg
motion-cure-arc-off-line = варите с вылетом станка, измените углы горелки или возьмите станок с ещё одной поворотной осью
motion-not-smooth = оси { $machine } не могут здесь плавно следовать за горелкой: она проходит сингулярное положение
motion-not-smooth-redundant = при любом положении избыточных осей { $machine } остальные оси не могут плавно следовать за горелкой: она проходит сингулярное положение или выходит за их досягаемость
motion-jump = каждое положение достижимо, но не непрерывно: между s = { $from } и { $to } ось { $axis } должна была бы скакнуть на { $by }
motion-cure-jump = не испытано: может помочь сварка частями (start.end_phi_deg), другое начало или другое размещение детали
motion-near-singular = в { $distance } от сингулярного положения ось { $axis } требует { $used } своих возможностей при { $asked }; здесь возможны { $holds }
motion-cure-near-singular = чтобы иметь запас, наклоните горелку или деталь на несколько градусов

# Axes that are held.
motion-hold-unknown = между деталью и горелкой нет оси { $axis }
motion-hold-decided = ось { $axis } не избыточна: поза горелки здесь определяет все оси
motion-hold-too-few = если удерживать { $held }, остальные оси не достигают всех поз горелки
motion-hold-range = ось { $axis } удерживалась бы на { $value }, вне её диапазона
motion-hold-allowed-none = ни одной оси
motion-hold-allowed-count = { $axes ->
    [1] одна ось или другая
    [one] до { $axes } оси или другие
    [few] до { $axes } осей или другие
   *[many] до { $axes } осей или другие
}

# Changes of the job that were tried as cures.
motion-change-move = сдвиньте деталь на { $x }; { $y }; { $z } вдоль x, y, z (placement.move_mm)
motion-change-work-angle = измените torch.work_angle_deg на { $by }
motion-change-work-angles = измените work_angle_deg в каждом [[torch.at]] на { $by }
motion-cure-range-weld = { $change }: проверено, все оси тогда остаются в диапазонах
motion-cure-range-pass = { $change }: проверено для этого прохода, все оси тогда остаются в диапазонах
motion-cure-range-none = не найдено: испытаны сдвиг детали и изменение рабочего угла
motion-cure-range-none-moved = не найдено: испытан сдвиг детали
motion-cure-range-none-angle = не найдено: испытано изменение рабочего угла
motion-cure-range-none-stroke = { $tried }; оси { $axis } нужно { $needed } вдоль шва, её диапазон { $stroke }
motion-cure-redundant = с избыточными осями изменения не испытаны: поставьте деталь ближе к середине диапазонов осей
motion-cure-range-no-time = в разрешённое время изменения не испытаны
motion-cure-range-stopped = { $changes ->
    [one] в разрешённое время не найдено: испытано { $tried } из { $changes } изменения
    [few] в разрешённое время не найдено: испытано { $tried } из { $changes } изменений
   *[many] в разрешённое время не найдено: испытано { $tried } из { $changes } изменений
}
motion-cure-not-tried = не испытано: могут помочь другие углы горелки или другое размещение детали

# Clearance.
motion-too-near = { $first } и { $second }: расстояние { $distance } (нужно не менее { $minimum })
motion-collision = { $first } и { $second }: столкновение (нужно не менее { $minimum })
motion-above-root = { $contact }, на { $height } выше корня
motion-below-root = { $contact }, на { $height } ниже корня
motion-no-torch-angle = ни один угол в пределах { $work } от рабочего и { $travel } от угла наклона вдоль шва не оставляет горелке места: { $reason }
motion-no-torch-angle-longer = ни один угол в пределах { $work } от рабочего и { $travel } от угла наклона вдоль шва не оставляет горелке места, даже с вылетом на { $longer } больше: { $reason }
motion-angle-none-allowed = поверхности соединения, технология или ход оси не допускают ни одного из них
motion-angle-turns-too-fast = свободные углы меняются больше чем на { $turn } на длине { $way }
motion-cure-torch-angle = более тонкая горелка или больший вылет, более широкая разделка, более широкие пределы в torch.search либо меньшее расстояние в clearance.least_mm
motion-cure-clearance = измените углы горелки или размещение либо разрешите меньше в clearance.least_mm, если формы верны
motion-cure-clearance-weld = { $change }: проверено, все расстояния тогда достаточны; или разрешите меньше в clearance.least_mm, если формы верны
motion-cure-clearance-pass = { $change }: проверено для этого прохода, все расстояния тогда достаточны; или разрешите меньше в clearance.least_mm, если формы верны
motion-cure-clearance-none = не найдено: рабочие углы до { $angle } от этого не помогают; уберите препятствие или разрешите меньше в clearance.least_mm, если формы верны
motion-cure-clearance-stopped = { $angles ->
    [one] в разрешённое время не найдено: испытано { $tried } из { $angles } рабочего угла; уберите препятствие или разрешите меньше в clearance.least_mm, если формы верны
    [few] в разрешённое время не найдено: испытано { $tried } из { $angles } рабочих углов; уберите препятствие или разрешите меньше в clearance.least_mm, если формы верны
   *[many] в разрешённое время не найдено: испытано { $tried } из { $angles } рабочих углов; уберите препятствие или разрешите меньше в clearance.least_mm, если формы верны
}
motion-cure-clearance-move = уберите препятствие или разрешите меньше в clearance.least_mm, если формы верны
motion-no-shapes = у { $machine } нет форм: столкновения не проверяются, холостые ходы прямые
motion-cure-no-shapes = опишите горелку и звенья через [[shapes.<link>]] в файле станка

# Transfer moves.
motion-transfer-from-home = холостой ход от исходного положения к шву
motion-transfer-home = холостой ход от шва в исходное положение
motion-transfer-between = холостой ход от прохода { $from } к проходу { $to }
motion-transfer-too-long = { $move }: длится { $time }, а может не дольше { $limit }
motion-cure-transfer-too-long = задайте осям станка большие скорости и ускорения или придвиньте деталь ближе
motion-transfer-blocked = { $move }: { $reason }
motion-cure-transfer-blocked = не испытано: может помочь сдвиг детали, оснастки или исходного положения либо другое начало шва
motion-transfer-start = в его начале препятствие: { $obstacle }
motion-transfer-end = в его конце препятствие: { $obstacle }
motion-transfer-retract = на пути отвода препятствие: { $obstacle }
motion-transfer-approach = на пути подвода препятствие: { $obstacle }
motion-transfer-none = свободного пути не найдено; на прямом пути: { $obstacle }
motion-retract-short = { $move }: горелка может отойти лишь на { $distance } из { $asked }
motion-retract-none = { $move }: ни одна ось не отведёт горелку вдоль её оси, она отходит вбок
motion-cure-retract = убедитесь, что возле шва там ничего не стоит, или задайте меньший отвод
motion-unwind = { $move }: ось { $axis } отматывается назад на { $by }

# Planning that was stopped.
motion-search-out-of-time = за { $limit } поиска план не найден: { $progress }
motion-search-cancelled = планирование отменено: { $progress }
motion-search-progress = { $positions ->
    [one] { $stage }, выполнено { $part }, испытано { $positions } положение
    [few] { $stage }, выполнено { $part }, испытано { $positions } положения
   *[many] { $stage }, выполнено { $part }, испытано { $positions } положений
}
motion-search-reach = решение поз вдоль шва
motion-search-sampling = выборка положений избыточных осей
motion-search-joining = соединение выбранных положений
motion-search-refining = уточнение избыточных осей
motion-search-speed = планирование профиля скорости
motion-search-weave = перебор частот колебаний
motion-search-transfer = поиск холостого хода
motion-search-cure = проверка мер
motion-search-torch-angles = перебор углов горелки
motion-cure-search = разрешите больше времени, зафиксируйте избыточные оси (spare_axes.hold), сузьте их диапазоны в файле станка или сварите шов частями
motion-cure-plan-again = спланируйте заново

# Comparison with the welding procedure specification.
motion-quantity-speed = скорость острия
motion-quantity-heat-input = тепловложение
motion-quantity-travel-angle = продольный угол
motion-quantity-work-angle = поперечный угол
motion-quantity-stick-out = вылет проволоки
motion-run-pass = проход { $passes }
motion-run-passes = проходы { $passes }
motion-procedure-outside = { $quantity } составляет { $found } на s = { $at }; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-procedure-unbounded = { $quantity } не ограничено на s = { $at }, где горелка останавливается с горящей дугой; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-procedure-no-power = проход не задаёт { $keys }, поэтому его тепловложение неизвестно; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-procedure-no-faces = поверхности соединения неизвестны, поэтому и поперечный угол неизвестен; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-procedure-no-stick-out = вылет проволоки неизвестен; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-procedure-missing = проход не задаёт { $key }; { $procedure } разрешает ({ $run }) от { $min } до { $max }
motion-implausible = { $key } = { $found } не подходит к { $current }: обычно { $expected } ± { $percent }
motion-cure-implausible = проверьте { $key }, ток и проволоку; для особой дуги увеличьте percent в [plausibility] процедуры
motion-cooling-outside = шов остывает с 800 до 500 °C за { $found }; допустимо от { $min } до { $max }
motion-cooling-unbounded = горелка останавливается с дугой: время остывания не ограничено; допустимо от { $min } до { $max } (не более { $found })
motion-cure-cooling-slow = уменьшите погонную энергию или межслойную температуру
motion-cure-cooling-fast = увеличьте погонную энергию или подогрев
motion-preheat-low = процедура требует подогрев { $found }; EN 1011-2 (метод B) — { $needed }
motion-pool-too-large = валик имеет { $area } на s = { $s } в положении { $position }; без колебаний удерживается до { $max }
motion-cure-preheat-low = повысьте минимум preheat_c и interpass_c до { $needed }
motion-cure-pool = меньшие валики (выше скорость, меньше проволоки) или колебания, либо повернуть деталь ближе к нижнему положению
motion-preheat-range = подогрев экстраполирован: метод B по EN 1011-2 — для CET 0,2–0,5 %, 10–90 мм, 1–20 мл водорода на 100 г и 0,5–4 кДж/мм
motion-interpass-wait = ожидание { $time }, пока шов остынет
motion-interpass-thickness = для ожидания межслойной температуры нужна толщина деталей
motion-interpass-power = для ожидания межслойной температуры нужна погонная энергия
motion-interpass-never = шов не остывает ниже межслойной температуры за двое суток
motion-cure-interpass = дополните [materials] и процедуру или задайте wait_s вместо below_c в [interpass]
motion-procedure-no-run = ни один проход технологии { $procedure } не относится к проходу { $pass } ({ $name })
motion-procedure-position = шов в положении { $position }; { $procedure } разрешает ({ $run }) { $positions }
motion-procedure-inclination = шов в положении { $position } (наклон от { $min_slope } до { $max_slope }, поворот от { $min_rotation } до { $max_rotation }); { $procedure } разрешает ({ $run }) { $positions }
motion-cure-procedure-run = добавьте [[runs]] с названием или номером прохода в файл технологии или переименуйте проход; или возьмите технологию, аттестованную для этого
motion-cure-procedure-power = задайте { $keys } в weld.process или укажите в `power` технологии величины, дающие мощность; или возьмите технологию, аттестованную для этого
motion-cure-procedure-work-angle = уберите work_angle_deg из прохода технологии; или возьмите технологию, аттестованную для этого
motion-cure-procedure-stick-out = укажите stick_out_mm в [torch] файла станка
motion-cure-procedure-own-stick-out = измените stick_out_mm прохода или в [torch]; или возьмите технологию, аттестованную для этого
motion-cure-procedure-missing = задайте { $key } в weld.process или уберите из [runs.ranges]; или возьмите технологию, аттестованную для этого
motion-cure-procedure-slower = задайте там меньшую скорость; или возьмите технологию, аттестованную для этого
motion-cure-procedure-faster = задайте там большую скорость или поставьте деталь так, чтобы оси её держали; или возьмите технологию, аттестованную для этого
motion-cure-procedure-less-heat = варите там быстрее или с меньшей мощностью; или возьмите технологию, аттестованную для этого
motion-cure-procedure-more-heat = варите там медленнее или с большей мощностью; или возьмите технологию, аттестованную для этого
motion-cure-procedure-angles = измените там углы горелки или возьмите станок с достаточным числом осей; или возьмите технологию, аттестованную для этого
motion-cure-procedure-lower = уменьшите там { $key } (weld.process задания или участки программы); или возьмите технологию, аттестованную для этого
motion-cure-procedure-raise = увеличьте там { $key } (weld.process задания или участки программы); или возьмите технологию, аттестованную для этого
motion-cure-procedure-position = поверните или наклоните деталь иначе (placement, смещение нуля детали, spare_axes) или варите в обратном направлении, где это превращает спуск в подъём; или возьмите технологию, аттестованную для этого

# Simulated weld.
motion-simulated-path = остриё горелки в симуляции отходит от шва на { $deviation }; разрешено { $tolerance }
motion-cure-simulated-path = посмотрите на рассогласование осей: настройте контуры положения или варите медленнее
motion-cure-simulated-path-tracked = посмотрите на результаты слежения: датчик, скорость и досягаемость коррекций
motion-cure-simulated-path-untracked = следите за швом или поставьте деталь, как запланировано
motion-simulated-speed = скорость острия в симуляции отличается от запланированной на { $deviation }; разрешено { $tolerance }
motion-cure-simulated-speed = возьмите более точные энкодеры, более мягкие контуры положения, меньше трения или большую скорость
motion-simulated-stop = сварка остановлена на { $at }: { $reason }; дальше ничего не сварено
motion-simulated-other-head = остановилась другая головка
motion-cure-simulated-stop = поставьте деталь ближе к запланированному месту, исправьте датчик или варите медленнее
motion-simulated-drive = привод оси { $axis } доходит до предела тока
motion-cure-simulated-drive = возьмите более мощный привод или меньшее max_acceleration в файле станка

# Playing a speed profile under an operator's commands.
motion-override = коррекция подачи должна быть от 0 до { $max }, а не { $value } (до 1,5 — с профилем, спланированным для такой скорости)
motion-override-faster = коррекция подачи должна быть от 0 до { $max }, а не { $value }
motion-override-zero = коррекция подачи 0: задайте больше 0, прежде чем продолжить
motion-period = период должен быть от 0,00025 до 0,004 с, а не { $value }
motion-path-length = длина пути должна быть от 0 до { $length }, а не { $value }
motion-faster-profile = более быстрый профиль должен быть спланирован для более чем 1 и до 1,5 скорости, а не { $value }
motion-step-end = шаг должен закончиться за { $welded }, где конец сваренного, и не дальше { $length }, а не на { $value }
motion-stuck = движение не может продолжиться на { $s }: профиль скорости там выходит за пределы осей

# Manual motion.
motion-jog-range = ось { $axis } не может идти к { $value }: её диапазон от { $min } до { $max }
motion-jog-position = положение оси { $axis } не является конечным числом
motion-jog-speed = скорость оси { $axis } не является конечным числом
motion-jog-tip = скорость острия не является конечным числом
motion-jog-period = период { $value }; он должен быть больше 0, не больше 1 с
motion-jog-silence = время ожидания сигнала { $value }; оно должно быть больше 0, не больше 1 с
motion-jog-override = коррекция подачи { $value }; она должна быть больше 0, не больше 1
motion-jog-axis = { $axes ->
    [one] у станка { $axes } ось, оси { $axis } нет
    [few] у станка { $axes } оси, оси { $axis } нет
   *[many] у станка { $axes } осей, оси { $axis } нет
}
motion-jog-not-clear = в начале между { $first } и { $second } { $distance }; нужно не менее { $minimum }
motion-jog-halted = ручное движение остановлено: сначала дайте команду покоя
motion-jog-no-motion = движение в пределах от текущего состояния к цели не найдено

# Pulses.
motion-pulses-too-fast = период требует { $asked } импульсов, возможно не больше { $max }
motion-pulses-crowded = { $pulses ->
    [one] { $pulses } импульс не помещается между сменой направления и концом периода
    [few] { $pulses } импульса не помещаются между сменой направления и концом периода
   *[many] { $pulses } импульсов не помещается между сменой направления и концом периода
}
motion-pulses-position = положение { $steps } шагов слишком далеко от нуля для счёта; разрешено: до 1e11
motion-pulses-period = период { $ticks } тактов таймера; разрешено: от 1 до 2,7e11

# Textbook interpolators.
motion-value-not-positive = { $what }: нужно конечное число больше 0, а не { $value }
motion-value-not-finite = { $what }: нужно конечное число, а не { $value }
motion-value-semi-axis-a = полуось a
motion-value-semi-axis-b = полуось b
motion-value-x = x точки
motion-value-y = y точки
motion-value-nozzle-radius = радиус штуцера
motion-value-shell-radius = радиус обечайки
motion-value-start-angle = угол начала
motion-value-sweep = угол обхода
motion-value-speed = скорость
motion-value-period = период
motion-value-step = скорость, умноженная на период
motion-value-pulse = импульс
motion-start-off-ellipse = начальная точка ({ $x }; { $y }) лежит в { $distance } от эллипса; разрешено не больше { $tolerance }, ближайшая точка на нём ({ $near_x }; { $near_y })
motion-end-off-ellipse = конечная точка ({ $x }; { $y }) лежит в { $distance } от эллипса; разрешено не больше { $tolerance }, ближайшая точка на нём ({ $near_x }; { $near_y })
motion-nozzle-too-large = радиус штуцера { $nozzle } должен быть меньше радиуса обечайки { $shell }
motion-sweep = угол обхода должен отличаться от 0 и быть не больше { $limit } в каждую сторону, а не { $sweep }
motion-step-too-long = шаг { $step } (скорость, умноженная на период) слишком длинный для этого пути: не больше { $max } (длина пути или восьмая часть полного оборота)
motion-pulse-too-large = импульс { $pulse } слишком велик для этой формы: не больше { $max }
motion-too-many-steps = для этого нужно около { $steps } шагов или импульсов; предел { $max }
motion-not-verified = проход { $pass }: запланированное движение невыполнимо ({ $why })

# Reach of placements.
motion-reach-jump = нет непрерывного движения осей вдоль пути
motion-reach-speed = ось { $axis } потребовала бы { $used } своей скорости при { $asked }
motion-reach-position = положение сварки на { $by } вне разрешённых процедурой
