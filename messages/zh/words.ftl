# Words by names in files: the part behind the first hyphen is the name.

# Process values, without their units.
value-heat-input = 热输入
value-tip-speed = 焊枪尖端速度
value-current = 电流
value-voltage = 电压
value-wire-feed = 送丝
value-power = 功率
value-beam-current = 束流
value-accelerating = 加速电压
value-beam = 束流
value-frequency = 频率
value-focus = 焦点
value-gas = 气体
value-laser = 激光功率
value-speed = 焊接速度
value-travel-angle = 行走角
value-work-angle = 工作角
value-stick-out = 干伸长
value-preheat = 预热温度
value-interpass = 层间温度

# Deviations.
track-lateral = 横向
track-height = 高度

# Welding processes, by their numbers in ISO 4063.
process-111 = 焊条电弧焊
process-114 = 自保护药芯焊丝电弧焊
process-121 = 实心焊丝埋弧焊
process-131 = 实心焊丝 MIG 焊
process-135 = 实心焊丝 MAG 焊
process-136 = 药芯焊丝 MAG 焊
process-138 = 金属粉芯焊丝 MAG 焊
process-141 = 实心填充材料 TIG 焊
process-142 = 不填丝 TIG 焊
process-15 = 等离子弧焊
process-51 = 电子束焊
process-52 = 激光焊
