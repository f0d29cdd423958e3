# Notes and errors of every command.
cli-more-time = { $cure }；延长时间：--time-limit S
cli-verb-renamed = 注意：`seamwright { $former }` 现为 `seamwright { $present }`
cli-unknown-language = 注意：没有语言 `{ $language }`，改用英语；可用：{ $known }
cli-error = 错误：{ $error }
cli-option = { $option }：{ $fault }
cli-not-allowed = 不允许
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = { $from } 至 { $to }
cli-plus = +{ $value }
cli-wrote = 已写入 { $files }
cli-no-such-axis = 没有该轴
cli-cycle-ended-early = 循环线程提前结束
cli-jobs-unreadable = 有任务无法读取
cli-no-notices = 本程序不含第三方软件包的许可证：{ $why }
cli-at-least-two = 至少两个
cli-standard-input = 标准输入

# Progress.
cli-progress-planning = 规划
cli-progress-rows = 行
cli-schedule-done = { $rows } 行中有 { $weldable } 行可按要求焊接；{ $kept } 行未重新规划
cli-progress-draws = 抽样
cli-study-done = { $machine } 上 { $job } 的 { $draws } 次抽样；{ $kept } 个规划沿用先前的运行
cli-study-weldable = 可焊接：{ $percent } %（95 % 区间 { $low } 至 { $high } %）
cli-study-first-error = 首个错误：{ $error }
cli-progress-pass = 焊道 { $pass }/{ $passes }：{ $stage }
cli-progress-simulating = 仿真焊接
cli-progress-machine = 检查机床
cli-progress-tuning = 整定各轴
cli-progress-cycles = 周期
cli-progress-pulses = 脉冲
cli-progress-set-points = 设定值
cli-progress-teaching = 示教
cli-progress-faults = 故障
cli-progress-frames = 仿真图像
cli-progress-welds = 仿真焊接次数

# Labels of the summary of a weld.
cli-label-machine = 机床
cli-label-seam = 焊缝
cli-label-speed = 速度
cli-label-time = 时间
cli-label-energy = 能量
cli-label-clearance = 间隙
cli-label-passes = 焊道
cli-label-pass = 焊道 { $pass }
cli-label-takes = 消耗
cli-label-waits = 等待
cli-label-duty = 燃弧
cli-label-cost = 成本
cli-label-transfers = 空程
cli-label-wrote = 已写入
cli-label-welded = 已焊
cli-label-path-error = 路径误差
cli-label-tip-speed = TCP 速度
cli-label-axis = 轴 { $axis }

# Summary of a weld.
cli-summary-seam = { $length }，焊接 { $weld }
cli-summary-takes-energy = 电弧能量 { $energy }
cli-summary-takes-wire = 焊丝 { $wire }
cli-summary-takes-metal = 熔敷金属 { $mass }
cli-summary-takes-gas = 保护气 { $gas }
cli-summary-takes-flux = 焊剂 { $mass }
cli-summary-waits = 焊道间 { $time }，直到焊缝冷却
cli-summary-duty = 占时间 { $part }，最不利 10 分钟 { $duty }
cli-summary-cost = { $total } { $currency }
cli-summary-cost-incomplete = { $total } { $currency }，未计：{ $without }
cli-summary-transfers = { $time }，原位到原位 { $total }
cli-summary-speed = 规划 { $from } 至 { $to }，要求 { $asked-from } 至 { $asked-to }
cli-summary-time = 行走 { $travel }，燃弧 { $arc }，共 { $total }
cli-summary-passes = { $passes }，共 { $length }
cli-summary-clearance = 间隙 { $clearance }
cli-summary-arc-energy = 电弧能量 { $energy }
cli-summary-heat-input = 热输入 { $heat }
cli-clearance-between = { $distance }：{ $first } 与 { $second }
cli-clearance-none = { $distance }：受检物体均不更近
cli-summary-not-welded = 未焊（仿真）
cli-summary-path-error = 最大 { $max }，RMS { $rms }（仿真）
cli-summary-tip-speed = { $from } 至 { $to }，RMS 偏差 { $rms }（仿真）
cli-summary-too-short = 焊缝太短，无法评判
cli-summary-following-error = 跟随误差 { $error }，RMS { $rms }
cli-summary-tracked = 99 % 焊程距接缝 { $p99 }，最大 { $max }；不跟踪时为 { $plain-p99 } 和 { $plain-max }
cli-summary-untracked = 99 % 焊程距接缝 { $p99 }，最大 { $max }；未跟踪
cli-summary-stopped = 停于 { $at }
cli-summary-alarm = 在 { $at }：{ $alarm }
cli-summary-beam = 偏转最大 { $deflection }（范围 { $range }），电子枪随动 { $carried }；束流离开焊缝占时 { $away }，最长 { $longest }
cli-summary-beam-replayed = 回放：{ $beam }
cli-summary-beam-fit = { $beam }；{ $points } 个点中 90 % 与存储偏差相差不超过 { $distance }

# Positions along the seam.
cli-no-such-angle = 该焊缝没有此角度
cli-angle-not-welded = 该角度不在焊接段上
cli-too-many-points = 点过多
cli-at-least-step = 至少 { $step }：{ $points } 个点
cli-section-no-joint = 任务没有接头，无截面可取
cli-section-joint = 带坡口准备的 [joint]

# Lists.
cli-list-machine = 机床
cli-list-axes = 轴
cli-list-example = 示例
cli-list-procedure = 焊接工艺规程
cli-list-process = 焊接方法
cli-list-title = 标题
cli-no-machine = { $name }：没有该机床
cli-no-example = { $name }：没有该示例
cli-no-procedure = { $name }：没有该焊接工艺规程

# Lateness of the cycle.
cli-latency-cycles = { $cycles } 个 { $period } 的周期，错过 { $missed } 个
cli-latency-late = { $part } 的周期延迟不超过 { $late }

# Moves from point to point.
cli-motions-up-to-two-hours = 不超过两小时的运动
cli-move-set-points = { $count } 个设定值
cli-longer-period = 不超过 { $max }，请用更长的周期
cli-move-done = { $time }，{ $count } 个设定值；{ $clearance }
cli-axis-value-of = 轴=值，轴为 { $axes }
cli-any-number-of = 任意的 { $unit } 数
cli-axis-twice = 轴 { $axis } 给出了两次
cli-each-axis-once = 每个轴一次
cli-axis-position-not-a-number = 轴 { $axis } 的位置不是数
cli-axis-outside = 超出轴 { $axis } 的范围
cli-move-no-shapes = 未检查碰撞：机床文件中没有可能相碰的形体
cli-move-min-distance = 最小距离 { $distance }，在 { $time }：{ $first } 与 { $second }
cli-move-clear = 没有物体近于 { $distance }
cli-move-impossible = 无法按要求移动：{ $findings } 项问题
cli-move-times = t = { $from } 至 { $to }
cli-move-in-parts = 分几次移动，绕过障碍

# Part programs.
cli-as-far-as-axes-reach = 各轴可达的距离
cli-post-differs = 零件程序与规划不符，未写入：
cli-too-coarse = 过粗
cli-finer-than-decimals = 小于程序字的六位小数
cli-no-such-blocks = 该数控系统没有这类程序段
cli-interpolations = PMAC 用 pvt、spline1、linear；Sinumerik 用 linear、poly；LinuxCNC 和 grblHAL 用 linear
cli-too-far = 过远
cli-up-to-pass-tolerance = 不超过 { $max }，即焊道的公差
cli-import = { $file }：{ $dialect } 程序，{ $moves } 次移动，按其进给 { $time }；焊道：{ $passes }
cli-import-left-out = 略去：{ $place }：{ $words }：{ $why }

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = 改正该行，或从文件中删去不是轴的列
cli-cure-line-in-mm = 改正该行；坐标以 mm 为单位
cli-cure-line-per-point = 标题行之下，每点一行数
cli-too-far-away = 过远
cli-points-found = { $points } 个点
cli-reduced = { $points } 个点；直线 { $lines }，圆弧 { $arcs }；最大误差 { $error }；最少段数 { $min }
cli-not-a-point = 不是点
cli-point-form = 以 mm 计的 x,y，如 { $example }
cli-too-many-to-draw = { $method } 要画的点超过 { $max } 个
cli-coarser-or-no-drawing = 更粗的脉冲或更长的周期，或不画图

# Edits of a program file.
cli-edit-no-operation = 未给出操作，或给出多个
cli-edit-operations = 一个操作、undo、redo、history 或 --script OPS.json；见 `seamwright edit --help`
cli-edit-new-history = 注意：{ $file } 自上次编辑后被手工改过：开始新的历史
cli-edit-of-operation = 操作 { $number }：{ $why }
cli-edit-job = { $file }：这是任务；只能编辑程序
cli-edit-plan-first = 先规划：seamwright plan { $file }；再编辑 { $program }
cli-edit-by-hand = { $file }：文件自上次编辑后被手工改过
cli-edit-force = --force，尽可能执行
cli-edit-nothing-to-undo = { $file }：没有可撤销的编辑
cli-edit-nothing-to-redo = { $file }：没有可重做的编辑
cli-edit-see-history = 见 `history`
cli-edit-undone = 已撤销：{ $edit }
cli-edit-redone = 已重做：{ $edit }
cli-edit-unchanged = { $edit }（无变化）
cli-edit-undone-entry = { $edit }（已撤销）
cli-edit-by-hand-since = 此后文件被手工改过
cli-edit-none = 没有编辑
cli-edit-value = 一个数，斜坡为两个数
cli-edit-see-schema = 见 `seamwright schema operation`

# Records of welds.
cli-no-data-folder = 没有数据文件夹
cli-data-folder = --data DIR 或 SEAMWRIGHT_DATA
cli-record-backup = { $file }：{ $size } MB
cli-record-restored = { $folder }：已恢复；请用 `seamwright records verify` 检查
cli-recovered = 焊接 { $weld }（{ $part }）：恢复 { $rows } 行，{ $result }
cli-recovered-unread = 焊接 { $weld }（{ $part }）：恢复 { $rows } 行，末尾 { $unread } 未读，{ $result }
cli-nothing-to-recover = 没有可恢复的记录
cli-recorded = 已记录：焊接 { $weld }
cli-record-weld-note = 注意：焊接 { $weld }：{ $note }
cli-record-heading = 焊接 { $weld }：{ $title }
cli-label-part = 工件
cli-label-result = 结果
cli-label-begun = 开始
cli-label-ended = 结束
cli-label-welder = 焊工
cli-label-procedure = 焊接工艺规程
cli-label-job = 任务
cli-label-program = 程序
cli-label-heat-input = 热输入
cli-label-deviation = 偏差
cli-label-note = 备注
cli-label-alarm = 报警
cli-label-event = 事件
cli-label-file = 文件
cli-record-simulated = { $result }，仿真
cli-record-version = { $name }，版本 { $version }
cli-record-heat-input = { $min } 至 { $max }，平均 { $mean }
cli-record-deviation = 最大 { $max }，在 s = { $at }
cli-record-value = { $name } { $from } 至 { $to }
cli-record-value-allowed = { $value }（允许 { $min } 至 { $max }）
cli-record-value-outside = { $value }（允许 { $min } 至 { $max }，超出 { $time }）
cli-record-with-cause = { $alarm }：{ $cause }
cli-record-at = { $alarm }，在 s = { $at }
cli-record-file = { $file }，{ $size }，SHA-256 { $hash }
cli-record-table = { $file }，{ $size }，{ $rows } 行，SHA-256 { $hash }
cli-verified = { $welds } 次焊接，{ $files } 个文件与记录一致，{ $entries } 条审计记录：正常
cli-verified-problems = { $welds } 次焊接，{ $files } 个文件与记录一致，{ $entries } 条审计记录：不正常
cli-problem = 问题：{ $problem }

# Position of the work in the machine.
cli-place-more-points = 更多分布在所测要素上的点，或换一种 --method
cli-place-side-unknown = 不知测头从哪一侧触到单个点
cli-place-radius-with-three-points = three-point 时为 0，或换一种 --method
cli-place-undetermined = 这些点不能确定工件位置
cli-place-no-seam = 程序没有焊缝，无表面可测
cli-place-no-nozzle = 焊缝没有接管，无跳动可测
cli-place-nozzle = [seam.nozzle]，或换一种 --method
cli-place-no-redundancy = 点数不多于未知数：坏点不会显现
cli-place-radius-unknown = 这些点不能确定半径：采用名义半径
cli-place-radius-off = 半径与名义值相差 { $deviation }：检查管子和测头
cli-place-no-rotary-axis = 机床没有绕接管名义轴线的旋转轴：跳动相对于名义轴线
cli-place-unchangeable = { $file }：无法修改：{ $why }
cli-place-touch-again = 有残差大于 { $max }：重新测点；边长会显示哪一点有误。若工件本就如此，用 --largest-mm 放宽
cli-place-touch-again-round = 有残差大于 { $max }：重测残差最大的点，并检查管子是否圆。若工件本就如此，用 --largest-mm 放宽
cli-place-touch-again-features = 有残差大于 { $max }：重测残差最大的点；检查其要素、测头半径，以及工件是否在任务所述位置附近。若工件本就如此，用 --largest-mm 放宽
cli-label-method = 方法
cli-label-offset = 偏置
cli-label-residuals = 残差
cli-label-sides = 边长
cli-label-run-out = 跳动
cli-label-tilt = 倾斜
cli-label-uncertainty = 不确定度
cli-label-free = 未测定
cli-label-warning = 警告
cli-place-method = { $method }，{ $points } 个点
cli-place-offset = { $name }：{ $offset }
cli-place-residuals = RMS { $rms }，最大 { $max }
cli-place-sides = 1-2 { $first }，2-3 { $second }，3-1 { $third }，长于名义值
cli-place-run-out = { $eccentricity } { $vector }，在 { $at } mm
cli-place-run-out-radius = { $run-out }，半径 { $deviation }
cli-place-tilt = { $angle }，朝向 { $direction }
cli-place-uncertainty = { $xyz } mm，绕 x、y、z { $turn } 度，在 { $at } mm
cli-place-free = { $motion }：按任务保留
cli-place-moved = 平移 { $vector } mm
cli-place-turned = 绕 { $axis } 转 { $angle }，再平移 { $vector } mm
cli-place-column-line = 行
cli-place-column-feature = 要素
cli-place-column-residual = 残差，mm
cli-place-outlier = 离群
cli-place-not-accepted = 未接受：{ $cure }
cli-place-for-job = # 用于任务文件，`offset` 放在开头
cli-at-line = { $file }:{ $line }：{ $fault }
cli-no-column = `{ $header }` 中没有列 `{ $column }`
cli-touched-header = 含 { $columns } 的标题行，或机床各轴 { $axes }
cli-touched-feature-column = 含 { $features } 的列 feature
cli-touched-nominal-columns = 列 { $columns }，为各点在工件坐标系中的名义位置
cli-touched-unknown-feature = 此方法不认识 feature = `{ $feature }`
cli-touched-not-a-number = { $column } = `{ $value }` 不是此处可用的数
cli-finite-up-to = 不超过 { $max } 的有限数

# Tuning of the axes.
cli-tune-heading = { $machine } 的整定：各位置环的开环，在轴运动中测得
cli-tune-axis = 轴
cli-tune-velocity-loop = 速度环
cli-tune-notches = 陷波
cli-tune-resonance = 谐振
cli-tune-crossover = 穿越
cli-tune-bandwidth = 带宽
cli-tune-gain-margin = 幅值裕度
cli-tune-phase-margin = 相位裕度
cli-tune-following = 跟随误差
cli-tune-load = 负载
cli-tune-counts = 脉冲数
cli-label-not-tuned = 未整定
cli-label-assumed = 假定
cli-tune-refused = { $axis }：{ $why }
cli-tune-assumed = { $axis }：机床文件未描述驱动
cli-tune-bode = 轴 { $axis } 的位置环，在 { $speed } 下测得

# Registers of devices, kinematics.
cli-io-no-device = 机床 `{ $machine }` 没有带寄存器的设备
cli-io-machine = 含 [devices.NAME.modbus] 的机床文件
cli-no-such-head = 没有该焊头
cli-pose-out-of-reach = 没有轴位置能达到该位姿

# The joint in images.
cli-image-whole-file = 完整的 PNG、JPEG 或 PNM 文件
cli-image-size = { $width } x { $height } 像素
cli-image-at-least = 每边至少 { $min } 像素
cli-image-saturated = 图像饱和，全白
cli-image-exposure = 使金属呈灰色的曝光：减少光照、时间或增益
cli-finite-numbers = { $n } 个有限数，以逗号分隔
cli-joint-zone = 左 < 右，在 0 至 { $right } 内；上 < 下，在 0 至 { $bottom } 内
cli-outside-zone = 在检测区之外
cli-outside-image = 在图像之外
cli-joint-start = x 从 { $left } 至 { $right }，y 从 { $top } 至 { $bottom }
cli-joint-none-at-start = 起点处没有接缝：试用其他 --start、--direction-deg 或 --width-px
cli-stripe-neither = 既非图像也非文本
cli-stripe-formats = PNG、JPEG 或 PNM，或含列 y_mm,z_mm 的 CSV
cli-not-a-position = 不是位置
cli-stripe-position = 绝对值不超过 1e7 mm 的数，缺失处留空
cli-stripe-profile-in-mm = 轮廓已以 mm 为单位
cli-stripe-image-options = --machine、--mm-per-px 和 --overlay 用于图像
cli-stripe-sensor-size = { $width } x { $height }，即传感器的尺寸
cli-stripe-no-sensors = 该机床没有传感器：[sensors.NAME]
cli-stripe-no-such-sensor = { $machine } 没有该传感器
cli-stripe-sees-none = 该传感器看不到激光条纹
cli-stripe-kind = kind = "stripe" 的传感器
cli-stripe-hint = 提示：上下颠倒后有接缝：把图像转 180 度或镜像，使上方背离板材
cli-scan-at = 在 s = { $s }：{ $why }
cli-scan-no-profile = 没有轮廓
cli-scan-kind = 轮廓不显示这种坡口的尺寸
cli-scan-needs-scale = 图像需要从像素到 mm 的映射
cli-scan-scales = --machine 和 --sensor，或 --mm-per-px
cli-scan-mirrored = 轮廓中的接头左右相反
cli-scan-with-mirrored = 加上 --mirrored
cli-scan-without-mirrored = 去掉 --mirrored
cli-scan-same-position = 另一行已有此位置
cli-scan-one-profile = 每个位置一个轮廓
cli-scan-beside-seam = 该位置距焊缝 { $distance }
cli-scan-not-measured = 从 s = { $from } 到 { $to } 没有轮廓显示接头：超过 { $bridge }
cli-stripe-no-joint = 没有接缝：{ $why }
cli-stripe-unsure = 置信度 { $confidence } 低于 { $min }，不可跟踪
cli-stripe-unsure-because = 置信度 { $confidence } 低于 { $min }，不可跟踪：{ $why }

# Step and direction pulses.
cli-pulses-not-vcd = 不是 VCD 文件
cli-pulses-vcd = 以 .vcd 结尾的文件名
cli-pulses-no-stepper = { $machine } 没有带步进电机的轴
cli-pulses-machine = 文件中有 [drives.<axis>.stepper] 的机床，如 torch-5axis
cli-pulses-ticks = 周期 { $period } 为 { $ticks } 个 { $tick } 的节拍
cli-pulses-whole-ticks = 整数个节拍，不超过 1e11；见 --period-ms 和 --tick-ns
cli-pulses-lost-steps = 轴 { $axis } 的电机从 t = { $time } 起丢失 { $steps } 个整步
cli-cure-lost-steps = 降低速度或加速度，或用扭矩更大的电机
cli-pulses-too-fast = { $microsteps } 细分时需每秒 { $asked } 个脉冲，最大为 { $max }
cli-cure-pulses-too-fast = 降低速度，减小驱动器的 `microsteps` 或增大 `max_pulse_hz`，或用更细的 --tick-ns
cli-cure-pulses-crowded = 更长的 --period-ms、更低的加速度或速度
cli-cure-fewer-microsteps = 减小细分
cli-pulses-crowded = 轴 { $axis }，t = { $time }：{ $fault }
cli-pulses-crowded-in-transfer = 轴 { $axis }，t = { $time }，空程中：{ $fault }
cli-pulses-bound-frequency = 再细就要超过每秒 { $max } 个脉冲
cli-pulses-bound-driver = 驱动器没有更细的设置
cli-pulses-bound-none = 即使如此也过快
cli-pulses-resolution = 轴 { $axis } 在 { $microsteps } 细分时每脉冲移动 { $resolution }，要求 { $wanted }：{ $why }
cli-pulses-note = 注意（分辨率）：{ $note }
cli-pulses-by-resolution = 分辨率
cli-pulses-by-frequency = 频率
cli-pulses-by-driver = 驱动器
cli-pulses-axis = { $axis }：{ $microsteps } 细分，取决于{ $bound }，每脉冲 { $resolution }（要求 { $wanted }），{ $pulses } 个脉冲，从 { $start } 到 { $end } 步，最高 { $highest }（上限 { $max }）
cli-pulses-axis-loses = { $axis }，电机丢失 { $steps } 个整步
cli-pulses-heading = { $job }：{ $time }，周期 { $period }，节拍 { $tick }
cli-pulses-without-stepper = 没有步进电机，因此没有脉冲：{ $axes }

# Set-points under an operator's commands.
cli-command-time = 从 { $from } 至 { $to } 的秒数：各行按时间排列
cli-not-a-command = 不是命令
cli-command-value = 与 { $command } 不符
cli-command-without-speed = 倍率为 0 时无法继续
cli-command-override-first = 其前倍率至少为 { $min }
cli-command-percent = 百分之 0 至 150
cli-command-step = 有限的 mm 数，至少 0.001
cli-command-nothing = 留空
cli-motion-coarse = { $parts } 个 { $period } 的周期
cli-motion-whole-multiple = 周期的整数倍，不超过 1e6 倍
cli-motion-period-with-commands = 与 --commands 同用时不允许
cli-motion-held = 注意（保持）：焊道 { $pass } 停在 s = { $at }，且已无命令
cli-cure-commands-or-speed = 修改命令，或任务的速度

# Points followed at constant speed.
cli-follow-too-few = 不同的点少于两个
cli-follow-done = { $time }，{ $way }，最快 { $speed }
cli-follow-slower = 从未达到要求的 { $speed }：受各轴限值或路程长度所限
cli-follow-stops = 为前瞻规划停顿 { $stops } 次：加长 --window-s 可避免
cli-no-length = 没有长度
cli-direction = 方向
cli-follow-too-near = { $first } 离 { $second } 太近
cli-follow-something-too-near = 有物体过近
cli-follow-point = 第 { $line } 行的点：{ $why }
cli-cure-follow = 修改点、工件位置或机床；运动在此点之前结束

# A running cell.
cli-run-rights = 注意：循环在没有实时权限下运行：{ $footing }
cli-run-missed = 注意：{ $cycles } 个 { $period } 的周期错过 { $missed } 个：最差的延迟 { $late }
cli-run-missed-cure = 建议：加长 servo_period_ms，或减少同时运行的程序；用 `seamwright machine latency` 测量
cli-run-nothing-left = 没有剩余可焊
cli-run-passes-up-to = 焊道 1 至 { $passes }
cli-run-up-to-in-pass = 该焊道内不超过 { $length }
cli-run-outputs-unsafe = 设备 `{ $device }`：未确认其输出处于安全状态：{ $why }
cli-run-not-asked = 未询问
cli-run-look-at-once = 立即检查电弧和气体是否已关
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = 因{ $cause }结束，但循环在 { $time } 内未停止：请确认电弧、气体和驱动已关
cli-run-record-later = 下次 `seamwright records recover` 会补全记录
cli-run-state = 模式 { $mode }，焊道 { $pass }，s { $s }，输入 { $inputs }
cli-run-cleared = { $alarm } 已消失
cli-run-refused = { $order }：{ $why }
cli-run-alarm = { $alarm }：{ $reaction }；{ $action }
cli-run-alarm-at = { $alarm }，在 { $at }：{ $reaction }；{ $action }
cli-run-alarm-action = { $alarm }：{ $action }
cli-run-stopped-by = 程序因{ $cause }停止；一切已关
cli-run-stopped-by-alarm = 程序因报警停止：{ $alarm }
cli-run-trace-lost = 无法写入轨迹记录
cli-fault-never-came = 注意：{ $fault } 未发生：一切在 { $time } 已结束
cli-order-number = `{ $line }` 中的 `{ $word }`；允许 { $min } 至 { $max } 的数
cli-order-mode = 没有模式 `{ $mode }`；允许 { $modes }、N s、N mm
cli-order-unknown = `{ $line }` 不是指令；允许 { $orders }、override PERCENT、wait MODE、wait N s、wait N mm、?

# Teaching by camera.
cli-teach-frames = 文件夹、tcp://HOST:PORT、simulated
cli-teach-source = --frames 或 --semi-manual 之一
cli-teach-not-here = 此处不允许
cli-teach-only-with = 仅与 { $source } 同用
cli-teach-new-frames = 尚不在文件夹中的图像
cli-teach-beside = 这是程序旁另一文件的名称
cli-teach-file = 文件，如 taught.toml
cli-teach-camera-machine = 带相机的机床：文件中有 kind = "camera" 的 [sensors.<name>]
cli-teach-no-such-camera = { $machine } 没有该相机
cli-teach-no-camera = { $machine } 没有相机
cli-teach-several-cameras = { $machine } 有多台相机：用 --sensor 选择
cli-teach-numbers = { $n } 个数
cli-teach-three-numbers = 三个，X,Y,Z
cli-teach-start-off-seam = 起点 { $start } 不在名义焊缝附近
cli-teach-start-near = --start 距其 15 mm 以内，在机床的工件坐标系中
cli-direction-without-length = 方向没有长度
cli-three-finite-numbers = 三个不全为 0 的有限数
cli-teach-answers = X,Y,Z（mm，工件坐标系）或 X,Y,Z,DX,DY,DZ：由此按该方向继续；end：接缝到此为止；stop：放弃
cli-teach-lost = 行走 { $way } 后丢失，在 { $point }：{ $why }
cli-teach-seen = 最后图像：{ $file }
cli-teach-bad-answer = 不是三个或六个数，也不是 end 或 stop
cli-teach-point-off-seam = 该点不在名义焊缝 15 mm 以内
cli-teach-by-points = 名义焊缝已对到操作者的点
cli-teach-done = { $ended }，行走 { $way }，{ $time } 内 { $frames } 帧；{ $points } 个点
cli-teach-closes = 闭合误差 { $gap }
cli-teach-asked = 询问过：{ $why }
cli-teach-spline = { $pieces } 段的样条
cli-teach-lines-and-arcs = { $lines } 段直线和 { $arcs } 段圆弧
cli-teach-program = 程序：{ $curves }，距示教线不超过 { $error }
cli-teach-program-of-raw = 程序：{ $curves }，距示教线不超过 { $error }，距每个原始点不超过 { $raw }
cli-teach-truth = 真实偏差：横向 RMS { $across }，最大 { $across-max }；高度 RMS { $height }，最大 { $height-max }
cli-teach-no-address = 不是地址
cli-teach-address = tcp://HOST:PORT，端口 1 至 65535
cli-teach-no-frames = 没有图像
cli-teach-not-a-camera = 传感器 { $sensor } 不是相机
cli-teach-not-three-numbers = 不是三个数
cli-teach-distortion = SHIFT,TURN,BEND，单位 mm、度、mm
cli-teach-shift = 平移 { $value }
cli-teach-turn = 旋转 { $value }
cli-teach-bend = 弯曲 { $value }
cli-teach-tack = 沿焊缝以 mm 计的 FROM,TO，FROM 在 TO 之前

# The server.
cli-serve-data = --data { $folder }：无法创建：{ $why }
cli-serve-no-job = 没有该任务
cli-serve-jobs = 文件、{ $folder } 中的任务，或示例：{ $examples }
cli-serve-other-job = 数据文件夹中有同名的其他任务
cli-serve-other-name = 改用其他文件名，或用其中的 --job { $name }
cli-serve-no-token = 文件中没有令牌
cli-serve-tokens = 一行，至少 { $min } 个字母、数字或符号

# Acceptance benchmarks.
cli-bench-not-shipped = 机床 { $machine } 未随附
cli-bench-half-ring = 无法规划半环

# Drawings.
cli-draw-points-as-spans = 点化为直线和圆弧
cli-draw-seen-along = 沿 { $axis } 看
cli-draw-points = 点
cli-draw-lines = 直线
cli-draw-arcs = 圆弧
cli-draw-ends = 端点
cli-draw-spline = 样条
cli-draw-taught-line = 示教线
cli-draw-from-nominal = 相对名义焊缝
cli-draw-distance = 距离
cli-draw-across = 横向
cli-draw-above = 上方
cli-draw-tolerance = 公差
cli-draw-raw-from-program = 原始点相对程序
cli-draw-raw-points = 原始点
cli-draw-frame-against-frame = 帧间对比
cli-draw-overlap = 重叠
cli-draw-confidence-title = 置信度
cli-draw-confidence = 置信度
cli-draw-interpolation = 插补方法对比
cli-draw-true-curve = 真实曲线
cli-draw-paths = 路径，沿 z 看
cli-draw-close = 逐脉冲，路径中部附近
cli-draw-steps = 每周期直线行程与速度 x 周期之比
cli-draw-angle = 转过角度
cli-draw-deviation = 偏差
cli-draw-max-distance = 各点到真实曲线的最大距离

# Results of recorded welds.
cli-result-running = 进行中
cli-result-good = 合格
cli-result-deviating = 有偏差
cli-result-stopped = 已停止
cli-result-interrupted = 已中断

# Units in the table of tuning.
cli-tune-hz = Hz
cli-tune-per-s = 1/s
cli-tune-ms = ms
cli-tune-db = dB
cli-stopped = 已在循环 { $cycle } 中停止
cli-no-cell-runs = 该处没有运行的单元
cli-data-of-running-cell = 正在运行的面板的数据文件夹
cli-stop-unanswered = 停止未得到确认：{ $why }

# Machine files of arms.
cli-arm-note = 注意：{ $note }
cli-arm-next = 检查：seamwright machine check { $file }
cli-arm-home = 轴 `{ $axis }` 的原位超出其范围
cli-no-configurations = 该机床不是具有命名构型的机械臂
cli-no-arm-angle = 该机床不是七轴机械臂
# 机器人程序。
cli-not-for-robots = 不适用于机器人
cli-options-of-robots = --tolerance-mm、--speed-percent、--retract-mm
cli-servo-not-here = 只有 URScript 有设定点流
cli-servo-language = 与 --dialect urscript 一起使用
cli-servo-alone = 该选项属于设定点流，但缺少 --servo-ms
cli-servo-with-period = 与 --servo-ms 一起使用
cli-servo-period = { $step } 至 { $max }，步长 { $step }

# Search for placements of the work.
cli-progress-reach = 搜索摆放
cli-label-judged = 已判定
cli-label-budget = 时间预算
cli-label-present = 当前
cli-label-best = 最佳
cli-label-entry = 条目
cli-reach-judged = { $placements } 个摆放，{ $weldable } 个可焊
cli-reach-cut-off = { $budget } 到时结束搜索：--budget 可给更多时间
cli-reach-interrupted = Ctrl-C 结束了搜索：结果是目前最佳的摆放
cli-label-moved = 移动对象
cli-reach-moves-work = 工件，在工件坐标系中
cli-reach-moves-base = 机床基座，在其自身坐标系中
cli-reach-base-entry = { $file }：{ $key } = { $entry }
cli-reach-supplied = 机床属于程序自带，没有可写入的文件
cli-reach-own-machine = 机床文件；在任务文件旁用 `seamwright machine show { $name } > machines/{ $name }.toml` 可生成
cli-reach-at = 距当前摆放 x { $x }、y { $y }、z { $z }，转 { $turn }
cli-reach-margin = 轴 { $axis } 保留其行程的 { $margin }（焊道 { $pass }，s = { $s }）
cli-reach-free = 可焊；没有轴有行程限制
cli-reach-fails = 在焊道 { $pass }、s = { $s } 处不可焊：{ $reason }
cli-reach-not-planned = { $placement }：规划器拒绝：{ $reason }
cli-reach-none = 没有可焊且已规划的摆放
cli-reach-entry = { $key }：move_mm = { $vector }，角度 { $angle }
cli-reach-form = FROM,TO 或 FROM,TO,CELLS，FROM 不大于 TO，单元数不少于 1，例如 -300,300,9
cli-reach-ends = 两端在 { $min } 到 { $max } 之间
cli-reach-reversed = 范围的起点大于终点
cli-reach-too-many-cells = 网格有 { $cells } 个位置
cli-reach-cells-allowed = 总共最多 { $max } 个位置
cli-reach-no-file = 没有可写入的此文件
cli-reach-job-file = 作业或程序文件；`seamwright examples NAME > job.toml` 可生成一个
cli-reach-changed = { $file } 在搜索期间被修改：未写入任何内容
cli-label-planned = 已规划
cli-reach-planned = 在规划中，轴 { $axis } 保留其行程的 { $margin }
cli-allowed-spark = Spark Connect 的地址，例如 sc://host:15002
