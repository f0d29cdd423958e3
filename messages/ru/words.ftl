# Words by names in files: the part behind the first hyphen is the name.

# Process values, without their units.
value-heat-input = Тепловложение
value-tip-speed = Скорость острия
value-current = Ток
value-voltage = Напряжение
value-wire-feed = Подача проволоки
value-power = Мощность
value-beam-current = Ток луча
value-accelerating = Ускоряющее напряжение
value-beam = Ток луча
value-frequency = Частота
value-focus = Фокус
value-gas = Газ
value-laser = Мощность лазера
value-speed = Скорость сварки
value-travel-angle = Продольный угол
value-work-angle = Поперечный угол
value-stick-out = Вылет проволоки
value-preheat = Подогрев
value-interpass = Температура между проходами

# Deviations.
track-lateral = В сторону
track-height = По высоте

# Welding processes, by their numbers in ISO 4063.
process-111 = ручная дуговая сварка покрытым электродом
process-114 = дуговая сварка самозащитной порошковой проволокой
process-121 = дуговая сварка под флюсом сплошной проволокой
process-131 = сварка MIG сплошной проволокой
process-135 = сварка MAG сплошной проволокой
process-136 = сварка MAG порошковой проволокой с флюсовым наполнителем
process-138 = сварка MAG порошковой проволокой с металлическим наполнителем
process-141 = сварка TIG со сплошным присадочным материалом
process-142 = сварка TIG без присадочного материала
process-15 = плазменная сварка
process-51 = электронно-лучевая сварка
process-52 = лазерная сварка
