# Allowed values.
program-less-than-key = 小于 { $key } = { $max }
program-up-to-key = 不超过 { $key } = { $max }
program-positive-up-to-key = 大于 0，不超过 { $key } = { $max }
program-up-to-in-all = 总共不超过 { $max }
program-either = { $first } 或 { $second } 之一
program-at-least-one = 至少一个
program-at-least-one-table = 至少一个 { $table }
program-at-least-one-pass = 程序至少有一个焊道
program-at-least-one-point = 至少一个区段，其中至少一个点
program-at-least-one-path-length = 至少一个路径长度
program-at-least-one-column = 至少一个 列 = 数
program-numbers = { $numbers } 个数
program-one-for-each = 每个一个
program-one-for-each-of = { $columns } 各一个
program-range-in-order = { $min } 至 { $max }，较小的在前
program-start-to-point = 0（起点）至 { $max }
program-after-start-to-point = after：0（起点）至 { $max }
program-start-to-last-point = 0（起点）至 { $max }（最后一点）
program-positions-within = 有限数，位置距原点不超过 { $max }
program-number-or-ramp = 有限数，或 { "{" } from = .., to = .. { "}" }
program-leave-out = 省略它们

# Programs and passes.
program-no-passes = 程序没有焊道
program-pass-without-seam = 焊道沿焊缝走，但程序没有焊缝
program-seam-or-points = 程序中的 [seam]，或 [passes.points]
program-pass-without-spans = 焊道没有区段
program-span-gap = 区段的起点不是前一段的终点
program-span-empty = 区段没有长度
program-span-other-values = 该区段的工艺参数与第一段不同
program-min-speed-not-below = 最低速度不低于设定速度
program-below-span-speed = 小于每个区段的 speed_mm_s = { $max }
program-too-many-passes = 到此焊道为止，程序的焊道过多
program-too-many-rows = 到此焊道为止，程序的点、焊道位置和区段的行数过多
program-corner-choice = "refuse"、"stop" 或 { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = 焊枪会超出焊缝公差
program-role-tack = 定位焊
program-role-root = 打底
program-role-fill = 填充
program-role-cap = 盖面
program-role-cosmetic = 修饰

# Copies of the seam and work offsets.
program-copies-and-placement = 副本有自己的安放
program-no-placement = 有 [[copies]] 时不写 [placement]
program-name-taken = { $other } 已有此名称
program-placement-taken = { $other } 已在此安放
program-own-placement = 自己的安放
program-no-such-copy = 没有这个副本
program-no-copies = 0：程序没有 [[copies]]
program-copy-index = 0 至 { $max }，[[copies]] 中的序号
program-offset-name-invalid = `{ $name }` 不是有效的工件偏置名称
program-offset-names = 字母、数字、- 和 _
program-offset-table = 本文件中表的名称，这里为 [offsets.{ $name }]

# Beads.
program-bead-empty = 焊道位置表没有行
program-bead-column-length = 该列有 { $rows } 行，s_mm 有 { $wanted } 行
program-path-lengths-increase = 路径长度必须递增
program-torch-behind-face = 焊枪会位于表面背后
program-weave-part-above-one = 大于 1 的比例会使摆动比该焊道的更宽
program-step-over-without-bead = 过渡需要一条起始焊道
program-step-over-misplaced = 从 { $from } 到 { $to } 的过渡不在前一过渡与焊道终点之间

# Joints.
program-root-face-too-high = 钝边没有给坡口留下厚度
program-groove-angle-too-large = 角度对坡口来说过大
program-radius-too-large = 对钝边以上的深度来说半径过大
program-root-gap-too-wide = 根部间隙大于壁厚，也大于坡口本身
program-mismatch-too-large = 两边缘不相对：错边量不小于壁厚
program-nothing-filled = 未填充深度没有留下可填充的部分
program-fillet-size-unclear = 角焊缝尺寸不明确
program-fillet-sizes = leg_mm、throat_mm 之一，或同时 first_leg_mm 和 second_leg_mm
program-bevel-angle-unclear = 坡口面角度不明确
program-bevel-angles = angle_deg（坡口）或 cut_deg（边缘）
program-positions-increase = 位置必须递增
program-depth-leaves-no-back = 正面坡口深度没有给背面留下余量
program-fillet-implausible = 没有这样大的角焊缝
program-cap-implausible = 没有这样高的余高
program-lap-leg-too-long = 焊脚比所在的板边还长
program-gouge-on-face = 只有背面才清根
program-side-back = side = "back"
program-back-without-groove = 背面没有坡口
program-groove-on-back = 双面坡口，或对接接头的 [joint.gouge]
program-gouge-through-wall = 清根穿透了板壁
program-gouge-angle-too-large = 清根侧壁太平缓
program-at-dihedral-without-edge = 此处坡口角度不随二面角变化
program-edge-on-face = 带 angle_deg 的 t_bevel、t_double_bevel 或 t_j
program-at-dihedral-unequal = 按二面角的各行给出的量不同
program-same-keys-in-rows = angle_deg、root_gap_mm 或两者，各行相同
program-dihedrals-increase = 二面角必须递增
program-flare-root-gap = 相接触的圆件没有根部间隙
program-layers-increase = 层数较少时的测量必须排在前面
program-fit-up-without-angle = 这类边缘没有坡口角度
program-allowed-bevelled-kinds = 不给 angle_deg，或用 single_v、bevel、u、j、t_bevel、t_j
program-fit-up-angle-invalid = 边缘不能形成这个角度的坡口
program-remaining-before-weld = 焊接前整个坡口都是敞开的
program-allowed-after-layer = after_layer 为 1 或更大
program-remaining-missing = 缺少尚未填充的面积
program-allowed-remaining = 同时给出 remaining_mm2

# Process values.
program-process-name-invalid = 这不是有效的工艺参数名称
program-process-names = 小写字母、数字和 _，以单位结尾，如 current_a
program-column-name-taken = 另一列已有此名称
program-process-value-negative = 工艺参数为负
program-process-value-too-large = `{ $name }` = { $value } 超出任何焊机的能力
program-same-quantity = `{ $other }` 是同一量的另一种单位：两者可能矛盾
program-no-such-process-value = 焊缝没有这个工艺参数
program-upslope-too-long = 缓升所需时间超过规定时间
program-downslope-too-long = 缓降所需时间超过规定时间

# Weaving and oscillation.
program-weave-at-blend = 焊枪摆动处不能对拐角过渡
program-corner-or-no-weave = "refuse" 或 "stop"，或不摆动
program-weave-pitch-unclear = 摆动的节距不明确
program-only-trapezoid-dwells = 只有梯形有停留
program-no-dwell-or-trapezoid = 0，或 figure = "trapezoid"
program-dwell-needs-frequency = 以秒计的停留需要频率
program-frequency-instead-of-pitch = 用 frequency_hz 代替 pitch_mm
program-dwells-too-long = 停留没有留出横摆的时间
program-dwells-together = 两者合计不超过 { $max }
program-weave-along-torch = 摆动会沿焊枪方向进行
program-figure-without-length = 此图形没有长度
program-figures-with-length = 不写此键，或 figure = "circle" 或 "eight"
program-sides-not-steady = 两侧须为恒定值，不能是斜坡
program-weave-period-short = 一个摆动周期只占焊缝 { $pitch }
program-frequency-at-speed = 在 { $speed } 时不超过 { $max }
program-weave-periods = 一个焊道中将有 { $periods } 个摆动周期
program-up-to-periods = 不超过 { $max } 个周期
program-weave-speed-jumps = 区段起点处速度跳变，按频率给出的摆动也随之跳变
program-span-speed-or-pitch = 以 { $speed } 开始的区段，或带 pitch_mm 的摆动
program-oscillation-gaps = 射束在一个振荡周期内前进 { $advance }，大于其束斑 { $spot }：会留下间隙
program-cure-oscillation-gaps = 将 frequency_hz 设为 { $frequency } 或更高，或降低焊接速度

# Passes through points.
program-pass-without-points = 焊道没有点
program-span-without-points = 区段没有点
program-value-out-of-bounds = { $column } = { $value } 超出界限
program-value-not-allowed = 此处不允许 { $column } = { $value }
program-column-twice = 列 `{ $column }` 出现两次
program-each-column-once = 每列一次
program-last-column = 只有最后一列给出点的时间或速度
program-time-or-speed-last = 最后为 time_s 或 speed_mm_s
program-columns-without-position = 各列没有给出位置，或给出两个
program-position-columns = x_mm、y_mm、z_mm，可带 ax、ay、az；或机床各轴的名称
program-arc-in-span = 圆弧需要 `via_mm`，并只有一个点
program-one-arc-per-span = 每段一个圆弧，中间为 `via_mm`
program-arc-of-axes = 轴位置只有包含 x、y、z 中的两个才能走圆弧
program-only-arcs = 只有圆弧有此键
program-arc-or-leave-out = `along = "arc"`，或省略
program-speed-rows = { $rows } 行速度
program-cubic-speeds = 三次曲线比点多一行，第一行在其起点；其他没有
program-cubic-needs-times = 三次曲线需要时间
program-time-last = 最后一列 `time_s`
program-speeds-for-columns = { $columns } 个位置列有 { $speeds } 个速度
program-numbers-for-columns = { $columns } 列有 { $numbers } 个数
program-pace-zero = 0：这是起点，或各轴能达到的最快
program-block-number = 整数，0（没有）或更大
program-direction-columns = 方向：ax、ay、az 不全为 0
program-key-of-seam-passes = 该焊道经过点：只有沿焊缝的焊道有此键
program-leave-out-key-or-points = 省略它，或省略 `points`
program-event-after-end = 焊道没有这么多点
program-event-several = 一个事件只做一件事
program-event-keys = gas、wire、output（带 on）、message、call 之一

# Procedures.
program-procedure-without-runs = 工艺没有条目
program-run-without-passes = 条目没有指明焊道
program-run-passes-twice = 条目两次指明焊道
program-run-names = name = "tack"、"root"、"fill" 或 "cap"，或 passes = "1"、"2-5" 等
program-run-without-position = 条目不允许任何焊接位置
program-run-positions = 一个或多个；没有此键则全部允许
program-toe-angle-too-large = 焊缝不可能比与母材齐平更平
program-insert-without-root-faces = 此接头不能放置熔化嵌条
program-allowed-insert = 对接接头中的嵌条，side = "face" 且无衬垫
program-insert-area-missing = 缺少嵌条的截面积
program-allowed-insert-area = area_mm2，或 kind = "ring" 或 "rectangular"
program-insert-too-high = 嵌条的高度不小于壁厚
program-insert-gap = 宽 { $width } 的嵌条不适合 { $gap } 的根部间隙
program-not-a-process-value = 这不是工艺参数
program-beside-ranges = { $key }，与 `ranges` 并列
program-ranges-in-table = 工艺参数范围写在 [runs.ranges]
program-part-above-one = 该比例大于 1
program-carbon-invalid = 碳含量 { $found } 不是钢
program-composition-sum = 各元素之和为 { $sum }
program-material-group-invalid = { $group } 不是材料组
program-material-groups = ISO/TR 15608 的材料组：1 至 11、21 至 26、31 至 38、41 至 48、51 至 54、61、62、71 至 76，可带子组，如 "1.2"
program-material-unknown = 该材料既无成分也无组别
program-composition-or-group = `composition` 或 `group`
program-interpass-one-of = 等待需要时间或温度之一
program-interpass-wait-or-below = `wait_s` 或 `below_c`
program-interpass-below-work = 工件永远不会冷却到 { $found }
program-heat-flow-2d = 二维
program-heat-flow-3d = 三维
program-one-run-per-name = 每个名称一个条目
program-pass-in-two-runs = 焊道 { $pass } 已由 { $other } 指明
program-named-pass-in-two-runs = 焊道 { $pass }（{ $name }）已在 { $other } 中
program-pass-in-one-run = 每个焊道只在一个条目中
program-no-pass-numbers = `{ $text }` 没有指明焊道
program-pass-named-twice = 焊道 { $pass } 被指明两次
program-pass-numbers = 从 1 起的数，如 "1"、"2-5" 或 "1, 3-4"，各一次
program-limits-increase = 限值必须递增
program-hysteresis-too-large = 没有坡度会超出 vertical_slope_deg 这么多
program-no-power = 这些值的乘积不是功率
program-power-values = ["current_a", "voltage_v"]、["laser_w"]：一个 W 或 kW 的值，或 A、mA、kA 的电流和 V、kV 的电压
program-window-order = 最小值 { $min } 大于最大值 { $max }
program-window-negative = 该范围的下限小于 0
program-window = [最小, 最大]
program-processes = { $processes }
program-process = { $number }（{ $name }）

# Jumps of the torch.
program-torch-direction-jumps = 焊枪方向将在拐角 s = { $s } 处跳变 { $jump }
program-torch-tip-jumps = 焊枪尖端将在拐角 s = { $s } 处跳变 { $jump }
program-cure-direction-jumps = 让一道在此结束、另一道在其后开始（任务中 order.parts = "at_corners"，定位焊移到别处）；或在焊缝中将拐角倒圆；对接时不用工作角和行走角
program-cure-tip-jumps = 让一道在此结束、另一道在其后开始（任务中 order.parts = "at_corners"，定位焊移到别处），或在焊缝中将拐角倒圆

# Variables and expressions.
program-expression = "= 表达式"
program-expression-lines = 表达式须在一行内
program-expression-grammar = 数、变量名、+ - * / 和括号
program-expression-rest = 无法理解 `{ $text }`
program-expression-ends = 表达式在应有数或名称处结束
program-unexpected-character = 应有数或名称处为 `{ $text }`
program-number-invalid = `{ $text }` 不是数
program-nesting-too-deep = 嵌套的括号或符号过多
program-parenthesis-missing = 缺少右括号
program-result-not-finite = 结果不是有限数
program-finite-result = 不除以 0，数不超过 1e308
program-not-a-number = 这不是数
program-variables-no-table = 变量不是一张表
program-variables-table = [variables]，名称 = 数
program-variable-name-invalid = `{ $name }` 不是有效的变量名
program-variable-names = 字母或 _，然后字母、数字和 _
program-no-variables = 没有给出变量：[variables]，名称 = 数

# Refused edits.
program-edit-refused = 编辑被拒绝：文档保持原样；行号是结果的行号
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = 此更改无法写入本文档的排版
program-usual-layout = 操作 `format` 产生的排版
program-history-of-other-text = 文档在该编辑之后被更改，不再包含其结果
program-text-of-last-edit = 最后一次编辑后的文档
program-history-line = 第 { $line } 行：{ $fault }
program-history-empty = 历史为空
program-history-head = 历史的首行与其编辑不符
program-history-format = `seamwright edit` 写出的历史，每行一个 JSON 对象
program-number-not-finite = 数值非有限或过大
program-no-pass = 没有焊道 { $pass }
program-pass-along-seam = 焊道 { $pass } 沿焊缝走
program-pass-has-points = 焊道 { $pass } 经过点
program-pass-through-points = 经过点的焊道
program-no-points = 没有可供此编辑的点 { $from } 至 { $to }
program-nothing-to-set = 没有给出要设置的内容
program-no-order-position = 顺序中没有位置 { $at }
program-only-pass = 这是唯一的焊道
program-no-event = 没有事件 { $event }
program-pass-with-events = 有事件的焊道
program-mirror-unclear = 没有给出镜像的平面或轴，或两者都给出
program-mirror-keys = 位姿用 `normal` 和 `at_mm`，轴位置用 `axis` 和 `about`
program-points-are-axes = 焊道 { $pass } 的点是轴位置
program-points-are-poses = 焊道 { $pass } 的点是位姿
program-no-points-pass = 没有经过点的焊道
program-with-points = 有 [passes.points] 的程序
program-offset-of-axes = 这些点是轴位置：只有机床知道焊枪的坐标系
program-points-with-poses = 作为位姿的点
program-no-torch-frame = 在点 { $point } 处焊枪沿路径方向，或路径没有方向
program-torch-across-path = 与路径横交的焊枪
program-no-point = 没有点 { $point }
program-no-number-given = 没有给出数
program-column-without-speed = `{ $column }` 不是位置列，没有速度
program-no-cubic-at-point = 没有三次曲线在点 { $point } 结束或开始
program-point-of-cubic = `cubic` 区段的点
program-no-next-point = 没有下一个点可取中点
program-no-point-left = 将没有点剩下
program-keep-a-point = 至少保留一个点，或删除焊道
program-points-without-xyz = 这些点没有用于直线和圆弧的 x、y、z
program-poses-or-xyz = 位姿，或轴 x、y、z 的位置
program-no-span = 没有可供此编辑的区段 { $span }
program-pass-of-more-spans = 有更多区段的焊道
program-rapid-with-arc = 本焊道有电弧：快速移动时不焊接
program-ways-or-no-arc = line、arc、spline；或 `arc = false` 的焊道
program-pass-with-times = 最后一列为 `time_s` 的焊道
program-arc-of-points = 圆弧需要 `via_mm` 和一个点；该区段有 { $points } 个
program-split-first = 先分割区段；给出 `via_mm`
program-via-of-arcs = `via_mm` 和 `normal` 属于圆弧，不属于 `{ $along }`
program-rapid-without-pace = 快速移动到达的点没有时间或速度
program-pace = `pace`：到每个点的时间或速度
program-pace-given = 这些点已有时间或速度
program-no-pace = 不写 `pace`
program-no-split-at-point = 在点 { $point } 处没有可分割的区段
program-point-within-span = 区段内的点，不是最后一个
program-no-split-at-length = 在 { $s } 处没有可分割的区段
program-length-within-span = 区段内的路径长度，不是其终点
program-split-unclear = 没有给出分割位置，或与焊道不符
program-split-keys = 经过点时用 `point`，沿焊缝时用 `s_mm`
program-spans-not-joined = 区段 { $first } 和 { $second } 不能接续
program-spans-that-join = 相同的走法（无圆弧）和停顿，速度相同的三次曲线；沿焊缝相同的值或接续的斜坡
program-points-without-seam = 该焊道经过点：没有焊缝
program-no-seam-length = 不写 `seam_length_mm`
program-pass-over-start = 焊道越过焊缝起点
program-seam-length = `seam_length_mm`：焊缝整圈焊接
program-start-point = `point`：闭合点列的起点
program-start-without-seam = 程序没有可作为起点的焊缝
program-start-unclear = 没有给出新的起点，或给出两次
program-start-keys = `pass` 和 `point`，或 `pass` 和 `begin_mm`，或仅 `phi_deg`
program-points-not-closed = 点列的终点不是起点
program-closed-points = 闭合点列：最后一点即起点
program-no-range = 焊道没有从 { $from } 到 { $to } 的范围
program-range-of-points = `points`，不写 `s_mm`
program-range-of-seam = `s_mm`，不写 `points`
program-range-without-pass = 范围需要指明焊道
program-pass-with-range = `pass` 和 `points` 或 `s_mm`
program-speed-not-positive = 速度将不是大于 0 的有限数
program-other-factor = 另一个系数

# Edits that were made.
program-edit-formatted = 已格式化
program-edit-offset = 生效的工件偏置：`{ $name }`
program-edit-no-offset = 没有生效的工件偏置
program-edit-variable = 变量 { $name } = { $value }
program-edit-variable-removed = 变量 { $name } 已删除
program-edit-pass = 焊道 { $pass }：{ $changes }
program-edit-pass-name = 名称 `{ $name }`
program-edit-pass-role = 用途：{ $role }
program-edit-arc-on = 有电弧
program-edit-arc-off = 无电弧
program-edit-repeat = 焊接 { $times } 次
program-edit-pass-added = 已添加焊道 `{ $name }`
program-edit-pass-deleted = 已删除焊道 { $pass } `{ $name }`
program-edit-pass-moved = 焊道 { $pass } 移到第 { $to } 位
program-edit-pass-copied = 已复制焊道 { $pass }
program-edit-event-added = 焊道 { $pass }：在点 { $point } 后添加事件
program-edit-event-deleted = 焊道 { $pass }：已删除事件 { $event }
program-edit-mirrored = 已镜像
program-edit-moved = 焊道 { $pass } 已移动
program-edit-point = 焊道 { $pass }，点 { $point }：已设置 { $columns }
program-edit-speed-of = { $column } 的速度
program-edit-point-inserted = 焊道 { $pass }：在 { $after } 后插入点
program-edit-points-deleted = 焊道 { $pass }：已删除点 { $from } 至 { $to }
program-edit-reduced = 焊道 { $pass }：{ $before } 个点减为 { $after } 个
program-edit-along = 焊道 { $pass }，区段 { $span }：{ $along }
program-edit-span-split = 焊道 { $pass }：已分割区段 { $span }
program-edit-spans-joined = 焊道 { $pass }：已合并区段 { $first } 和 { $second }
program-edit-reversed = 焊道 { $pass } 已反向
program-edit-pass-start = 焊道 { $pass } 从 { $s } 开始
program-edit-pass-start-point = 焊道 { $pass } 从点 { $point } 开始
program-edit-weld-start = 焊缝从 { $phi } 开始
program-edit-speed = 速度乘以 { $factor }
program-edit-process = 焊道 { $pass }：已设置 { $name }
program-edit-numbered = 点已编号
