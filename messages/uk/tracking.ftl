# Settings.
tracking-value = { $key } = { $value }: дозволено: { $allowed }
tracking-ages = два значення віку в с: найменше, тоді більше найбільше, щонайбільше 10
tracking-scan-allowed = менше за період
tracking-speeds-allowed = дві швидкості понад 0, спершу менша
tracking-notice-allowed = більше за запізнення супортів, щонайбільше 0,02
tracking-correction-allowed = шлях, уздовж якого осі можуть зсувати пальник у всі боки
tracking-look-ahead-too-short = випередження { $distance } замале за { $speed }: відхилення має бути відоме за { $notice } до підходу пальника; дозволено { $min } або більше, чи { $max } або менше

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }: зварювання можна переривати щонайчастіше раз на { $min }; дозволено стільки або більше
tracking-frame-too-long = scan_s = { $scan }: зварювання можна переривати на { $max }; дозволено стільки або менше
tracking-zone-outside = за { $speed } стик треба бачити від { $from } до { $to } попереду, а кадр закінчується на { $reach }; дозволено від { $min } до { $max }
tracking-zone-outside-at-any-speed = за { $speed } стик треба бачити від { $from } до { $to } попереду, а кадр закінчується на { $reach }; із таким кадром не підходить жодна швидкість

# Stored deviations.
tracking-pass-not-covered = прохід іде від { $from } до { $to } збереженого шва, а відхилення збережено від { $first } до { $last }
tracking-stored-deviation-moved = дев’ять із десяти з { $points } точок відхиляються до { $within } (медіана { $median }), дозволено { $max }; натомість варіть цей прохід зі стеженням
tracking-stored-deviation-unseen = точок: { $points } у кадрах: { $frames }, дозволено від { $min }; перевіряйте лише кадри, де видно стик
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`: { $wrong }; дозволено: { $allowed }
tracking-record-no-column = у заголовку бракує цього стовпця
tracking-record-not-finite = не скінченне число
tracking-record-out-of-range = поза діапазоном
tracking-record-not-increasing = не більше, ніж у попередньому рядку
tracking-record-too-short = менше двох рядків
tracking-record-table = рядок заголовка s_mm,lateral_mm,height_mm,confidence, далі щонайменше два рядки скінченних чисел
tracking-record-path-lengths = зростаючі довжини шляху

# Faults of a sensor.
tracking-sensor-silent = давач не надсилає даних
tracking-sensor-contradictory = виміри давача суперечать один одному
tracking-sensor-confidence = достовірність давача не є числом від 0 до 1
tracking-sensor-faint = давач бачить стик надто слабко
tracking-sensor-out-of-field = стик поза полем зору давача
tracking-sensor-clock = позначки часу давача хибні
tracking-sensor-late = виміри давача надходять запізно
tracking-sensor-frozen = давач повторює той самий вимір

# Alarms of tracking.
tracking-near-stroke-end = корекція близька до межі
tracking-axes-carry = за межами відхилення променя: гармату ведуть осі
tracking-slowed = сповільнено через круте відхилення
tracking-blind = давач нічого не бачить
tracking-coasting = пальник за межами виміряної частини стику
tracking-beyond-history = пальник відійшов назад далі, ніж збережено вимірів
tracking-fading-out = корекція згасає до навченого шляху
tracking-stroke-end = корекція на межі: шов іде повз стик
tracking-joint-lost = стик втрачено
tracking-slide-stuck = супорт не йде за завданням
tracking-stored-deviation-misfit = збережене відхилення не підходить

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = виявлена лінія не продовжує знайдену раніше
tracking-crawl-frames-apart = два кадри показують стик із різницею { $distance }
tracking-crawl-not-seen = стику не видно
tracking-crawl-not-seen-further = далі стику не видно
tracking-crawl-end-or-tack = далі стику не видно: він тут закінчується, або його закриває прихватка, довша за найбільшу
