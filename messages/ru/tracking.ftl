# Settings.
tracking-value = { $key } = { $value }: допустимо: { $allowed }
tracking-ages = два значения возраста в с: наименьшее, затем большее наибольшее, не больше 10
tracking-scan-allowed = меньше периода
tracking-speeds-allowed = две скорости больше 0, сначала меньшая
tracking-notice-allowed = больше запаздывания суппортов, не больше 0,02
tracking-correction-allowed = путь, вдоль которого оси могут сдвигать горелку во все стороны
tracking-look-ahead-too-short = опережение { $distance } слишком мало при { $speed }: отклонение должно быть известно за { $notice } до подхода горелки; допустимо { $min } или больше, либо { $max } или меньше

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }: сварку можно прерывать не чаще раза в { $min }; допустимо столько или больше
tracking-frame-too-long = scan_s = { $scan }: сварку можно прерывать на { $max }; допустимо столько или меньше
tracking-zone-outside = при { $speed } стык нужно видеть от { $from } до { $to } впереди, а кадр кончается на { $reach }; допустимо от { $min } до { $max }
tracking-zone-outside-at-any-speed = при { $speed } стык нужно видеть от { $from } до { $to } впереди, а кадр кончается на { $reach }; с таким кадром не подходит никакая скорость

# Stored deviations.
tracking-pass-not-covered = проход идёт от { $from } до { $to } сохранённого шва, а отклонения сохранены от { $first } до { $last }
tracking-stored-deviation-moved = девять из десяти из { $points } точек отклоняются до { $within } (медиана { $median }), допустимо { $max }; вместо этого варите этот проход со слежением
tracking-stored-deviation-unseen = точек: { $points } в кадрах: { $frames }, допустимо от { $min }; проверяйте только кадры, где виден стык
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`: { $wrong }; допустимо: { $allowed }
tracking-record-no-column = в заголовке нет этого столбца
tracking-record-not-finite = не конечное число
tracking-record-out-of-range = вне диапазона
tracking-record-not-increasing = не больше, чем в предыдущей строке
tracking-record-too-short = меньше двух строк
tracking-record-table = строка заголовка s_mm,lateral_mm,height_mm,confidence, затем не меньше двух строк конечных чисел
tracking-record-path-lengths = возрастающие длины пути

# Faults of a sensor.
tracking-sensor-silent = датчик не посылает данных
tracking-sensor-contradictory = измерения датчика противоречат друг другу
tracking-sensor-confidence = достоверность датчика не число от 0 до 1
tracking-sensor-faint = датчик видит стык слишком слабо
tracking-sensor-out-of-field = стык вне поля зрения датчика
tracking-sensor-clock = метки времени датчика неверны
tracking-sensor-late = измерения датчика приходят слишком поздно
tracking-sensor-frozen = датчик повторяет одно и то же измерение

# Alarms of tracking.
tracking-near-stroke-end = коррекция близка к пределу
tracking-axes-carry = за пределами отклонения луча: пушку ведут оси
tracking-slowed = замедлено из-за крутого отклонения
tracking-blind = датчик ничего не видит
tracking-coasting = горелка за пределами измеренной части стыка
tracking-beyond-history = горелка отошла назад дальше, чем сохранено измерений
tracking-fading-out = коррекция затухает к обученному пути
tracking-stroke-end = коррекция на пределе: шов идёт мимо стыка
tracking-joint-lost = стык потерян
tracking-slide-stuck = суппорт не следует за заданием
tracking-stored-deviation-misfit = сохранённое отклонение не подходит

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = обнаруженная линия не продолжает найденную раньше
tracking-crawl-frames-apart = два кадра показывают стык с разницей { $distance }
tracking-crawl-not-seen = стык не виден
tracking-crawl-not-seen-further = дальше стык не виден
tracking-crawl-end-or-tack = дальше стык не виден: он здесь кончается, или его закрывает прихватка длиннее наибольшей
