
# Parts of every error in a file.
document-error = { $at }: { $message }
document-allowed = 允许：{ $allowed }
document-help = 提示：{ $help }

# Keys and names.
document-unknown-key = 这里没有键 `{ $key }`
document-unknown-name = 未知：`{ $name }`
document-missing-key = 缺少键 `{ $key }`
document-key-in-unit = `{ $key } = ...`，单位 { $unit }
document-missing-schema = 文件开头写：schema = 1
document-schema-version = 1，本版本程序读取的格式版本
document-none-given = 一个也没有给出
document-several-given = 给出了多个
document-exactly-one = 其中恰好一个
document-suggestion = 是否指 `{ $name }`？
document-suggestion-unit = 是否指 `{ $name }`？该值的单位是 { $unit }
document-own-name = 自己的名称
document-own-names = 各自的名称
document-nested = 表和列表嵌套过深
document-nesting = 最多 { $max } 层
document-no-such-entry = 文本中没有这个条目
document-unfit-change = 不能以这种方式更改该条目

# Values.
document-invalid-value = 值无效：{ $value }
document-invalid-type = 类型不对：{ $value }
document-number = 数字
document-positive-number = 大于 0 的有限数
document-non-negative-number = 不小于 0 的有限数
document-finite-number = 有限数
document-whole-number = { $min } 到 { $max } 的整数
document-table = 表 { $name }
document-number-without-unit = 只写数字：单位已在键名中
document-direction = 三个不全为 0 的数
document-direction-without-length = 方向没有长度
document-coordinates = 三个绝对值不超过 { $limit } 的数
document-coordinate-too-large = 坐标过大
document-too-large = 值过大
document-too-small = 值过小

# Allowed values; numbers come with their units.
document-at-least = 至少 { $min }
document-at-most = 不超过 { $max }
document-more-than = 大于 { $min }
document-less-than = 小于 { $max }
document-between = { $min } 至 { $max }
document-more-than-up-to = 大于 { $min }，不超过 { $max }
document-strictly-between = 大于 { $min } 且小于 { $max }
document-within = 至少 { $min }，不超过 { $max }（{ $reason }）
document-up-to = 不超过 { $max }（{ $reason }）

# Reasons of bounds.
document-bound-scanner-jerk = 最快振镜的加加速度
document-bound-scanner-acceleration = 最快振镜的加速度
document-bound-turns = 40 天一圈至每秒 280 圈
document-bound-gravity = 重力加速度的 10000 倍
document-bound-speed = 每小时 0.36 mm 至每秒 100 m
document-bound-wire-feeder = 最快送丝机的十倍
document-bound-square-metre = 一平方米
document-bound-many-turns = 2700 圈
document-bound-kilometre = 一公里
document-bound-10-km = 10 公里
document-bound-hour = 一小时
document-bound-pulses = 最快的脉冲发生器
document-bound-hundredfold = 一百倍
document-bound-process-source = 最大的焊接电源
document-bound-beam-generator = 最大的电子束发生器

# The code under which docs/reference/messages.md explains a message.
document-code = 代码：{ $code }
