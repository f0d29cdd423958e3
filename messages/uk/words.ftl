# Words by names in files: the part behind the first hyphen is the name.

# Process values, without their units.
value-heat-input = Тепловкладення
value-tip-speed = Швидкість вістря
value-current = Струм
value-voltage = Напруга
value-wire-feed = Подача дроту
value-power = Потужність
value-beam-current = Струм променя
value-accelerating = Прискорювальна напруга
value-beam = Струм променя
value-frequency = Частота
value-focus = Фокус
value-gas = Газ
value-laser = Потужність лазера
value-speed = Швидкість зварювання
value-travel-angle = Кут уздовж
value-work-angle = Кут поперек
value-stick-out = Виліт дроту
value-preheat = Підігрів
value-interpass = Температура між проходами

# Deviations.
track-lateral = Убік
track-height = За висотою

# Welding processes, by their numbers in ISO 4063.
process-111 = ручне дугове зварювання покритим електродом
process-114 = дугове зварювання самозахисним порошковим дротом
process-121 = дугове зварювання під флюсом суцільним дротом
process-131 = зварювання MIG суцільним дротом
process-135 = зварювання MAG суцільним дротом
process-136 = зварювання MAG порошковим дротом із флюсовим осердям
process-138 = зварювання MAG порошковим дротом із металевим осердям
process-141 = зварювання TIG із суцільним присадним матеріалом
process-142 = зварювання TIG без присадного матеріалу
process-15 = плазмове зварювання
process-51 = електронно-променеве зварювання
process-52 = лазерне зварювання
