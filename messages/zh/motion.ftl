# Limits of axes and of the torch tip.
motion-limit-speed = 速度限值
motion-limit-acceleration = 加速度限值
motion-limit-jerk = 加加速度限值

# Speed that the axes do not allow.
motion-speed-axis = 轴 { $axis } 无法保持 { $asked }：其{ $limit } { $value } 只允许 { $reached }
motion-speed-tip = 焊枪尖端无法保持 { $asked }：其{ $limit } { $value } 只允许 { $reached }
motion-speed-rounded-off = 尖端速度为 { $reached }，而非 { $asked }：给定速度在此变化，速度曲线对该变化作了平滑
motion-speed-slowed = { $reason }；焊接按要求在此减速
motion-too-short = 焊缝太短：加速段与减速段之间只达到 { $reached }（要求 { $asked }）
motion-too-short-between-stops = 两停点间的路程太短：加速段与减速段之间只达到 { $reached }（要求 { $asked }）
motion-no-speed-profile = { $machine } 各轴没有可行的速度曲线：{ $reason }
motion-profile-limit = 通道 { $channel } 的{ $limit }为 { $value }；须为大于 0 的有限数（加加速度限值可为无穷大）
motion-profile-asked = { $at } 处的给定速度为 { $value }；须大于 0
motion-profile-range = 路径从 { $from } 到 { $to }；终点须为大于起点的有限数
motion-profile-not-smooth = 通道 { $channel } 在 { $at } 处不光滑：导数不是有限数
motion-profile-still = { $from } 与 { $to } 之间没有任何运动：没有限值约束该处速度

# Weave that is too fast.
motion-weave-frequency = 摆动过快：{ $reason }；摆宽 { $width } 时最高频率为 { $frequency }
motion-weave-pitch = 摆动过快：{ $reason }；摆宽 { $width } 时最小摆距为 { $pitch }

# Corners: stops and blends.
motion-stop = 焊枪在 s = { $s } 处带弧停止：轴 { $axis } 的速度或加速度会在此跳变
motion-stop-because = 焊枪在 s = { $s } 处带弧停止：轴 { $axis } 的速度或加速度会在此跳变；{ $reason }
motion-blend = 焊枪在 s = { $s } 处圆滑过渡拐角：{ $over } 内尖端偏离焊缝最多 { $deviation }
motion-blend-turned = 焊枪在 s = { $s } 处圆滑过渡拐角：{ $over } 内尖端偏离焊缝最多 { $deviation }，方向偏离最多 { $turned }
motion-blend-no-room = 没有过渡的余地：距下一拐角或端点仅 { $distance }
motion-blend-turns-back = 路径在此折返，无法过渡
motion-blend-too-far = 最短过渡（{ $over }）会使尖端偏离焊缝超过 { $deviation }，或使焊枪偏离给定方向超过 { $turned }
motion-cure-stop-weave = 设 corner = "stop" 在此带弧停止；或用 pitch_mm 代替频率设定摆动；或将焊缝倒圆；或在此结束焊缝并另起一道
motion-cure-stop-or-blend = 设 corner = "stop" 在此带弧停止，或 corner = {"{ blend_mm = 0.2 }"} 在距焊缝不超过该距离内过渡拐角；或将焊缝倒圆；或在此结束焊缝并另起一道
motion-cure-stop = 设 corner = "stop" 在拐角停止；或将焊缝倒圆；或在此结束焊缝并另起一道

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = 带弧时尖端在 s = { $at } 处速度为 { $reached }，而焊接工艺的最低速度为 { $minimum }：在此处拐角停止
motion-least-speed-axis = 带弧时尖端在 s = { $at } 处速度为 { $reached }，而焊接工艺的最低速度为 { $minimum }：轴 { $axis } 的{ $limit } { $value } 不允许更快
motion-least-speed-tip = 带弧时尖端在 s = { $at } 处速度为 { $reached }，而焊接工艺的最低速度为 { $minimum }：焊枪尖端的{ $limit } { $value } 不允许更快
motion-least-speed-short = 带弧时尖端在 s = { $at } 处速度为 { $reached }，而焊接工艺的最低速度为 { $minimum }：焊缝太短，达不到更高速度
motion-least-speed-start = 焊枪带弧从静止起步：{ $over } 内低于焊接工艺的最低速度 { $minimum }
motion-least-speed-end = 焊枪带弧减速停止：{ $over } 内低于焊接工艺的最低速度 { $minimum }
motion-cure-least-speed-blend = 设 corner = {"{ blend_mm = 0.2 }"} 在距焊缝不超过该距离内过渡拐角；或在此前结束焊缝并在其后另起一道；或在工艺评定允许时减小 least_speed_mm_s
motion-cure-least-speed-axis = 改变工件放置或焊枪转角，使轴 { $axis } 在此移动更少；或在此前结束焊缝并在其后另起一道；或在工艺评定允许时减小 least_speed_mm_s
motion-cure-least-speed-tip = 若焊枪允许，提高机床文件中的尖端限值；或在此前结束焊缝并在其后另起一道；或在工艺评定允许时减小 least_speed_mm_s
motion-cure-least-speed-longer = 加长焊缝；或在此前结束焊缝并在其后另起一道；或在工艺评定允许时减小 least_speed_mm_s

# Operator actions against a speed that the axes do not allow.
motion-cure-longer-change = 让速度在更长的路程上变化，或设 weld.on_limit = "slow" 在此减速
motion-cure-speed = 要求 { $speed }（各轴处处可保持），或设 weld.on_limit = "slow" 在此减速
motion-cure-speed-or-blend = 要求 { $speed }（各轴处处可保持），或设 weld.on_limit = "slow" 在此减速，或允许更长的过渡
motion-cure-speed-part = 要求 { $part } 的速度（各轴处处可保持），或设 weld.on_limit = "slow" 在此减速
motion-cure-speed-part-or-blend = 要求 { $part } 的速度（各轴处处可保持），或设 weld.on_limit = "slow" 在此减速，或允许更长的过渡
motion-cure-slow = 设 weld.on_limit = "slow" 在此减速
motion-cure-slow-or-blend = 设 weld.on_limit = "slow" 在此减速，或允许更长的过渡
motion-cure-speed-at-most = 要求不超过 { $speed }，或设 weld.on_limit = "slow"
motion-cure-weave-frequency = 将 frequency_hz 设为 { $frequency } 或减小摆宽，或设 weld.on_limit = "slow" 在此减速
motion-cure-weave-pitch = 将 pitch_mm 设为 { $pitch }、减小摆宽或降低速度，或设 weld.on_limit = "slow" 在此减速
motion-cure-limits = 给机床各轴设定大于 0 的有限限值，给焊道设定速度和长度

# Times.
motion-time-too-long = { $key } = { $time }：一道焊缝最长 { $limit }
motion-cure-time = 将 { $key } 设为不超过 { $limit }
motion-travel-too-long = 按给定速度行走需 { $time }：一道焊缝最长 { $limit }
motion-cure-travel = 提高 speed_mm_s，或将焊缝分为多道
motion-travel-too-long-axes = 在各轴限值下行走需 { $time }：一道焊缝最长 { $limit }
motion-cure-travel-axes = 提高机床各轴的速度和加速度，或将焊缝分为多道

# Reach and ranges of the axes.
motion-unreachable = { $machine }：{ $reason }
motion-cure-unreachable = 改变工件放置、焊枪角度或机床
motion-no-solution = 没有轴位置能跟随该路径
motion-no-positions = 没有轴位置能到达该处
motion-axis-beyond = 轴 { $axis } 须超出行程 { $by }
motion-unreachable-redundant = { $machine }，无论冗余轴处于何位置：{ $reason }
motion-cure-unreachable-redundant = 改变工件放置、焊枪角度或固定的轴
motion-beyond-range = 轴 { $axis } 将到 { $value }，超出限位 { $limit } 达 { $by }
motion-cure-range = 放置工件，使该轴保持在行程内
motion-attitude = { $machine } 的轴数不足以实现完整的焊枪姿态：与要求相差最多 { $error }（公差 { $tolerance }）
motion-arc-off-line = { $machine } 不能保持要求的焊枪姿态，而焊枪为其干伸长后移了 { $back }：电弧将偏离焊线 { $off }
motion-cure-attitude = 改变焊枪角度、使用多一个旋转轴的机床，或放宽 tolerance.attitude_deg
motion-cure-arc-off-line = 使用机床的干伸长焊接、改变焊枪角度，或使用多一个旋转轴的机床
motion-not-smooth = { $machine } 各轴在此无法平滑跟随焊枪：经过奇异姿态
motion-not-smooth-redundant = 无论 { $machine } 的冗余轴处于何位置，其余轴都无法平滑跟随焊枪：经过奇异姿态或超出可达范围
motion-jump = 每个位置都可达，但不连续：在 s = { $from } 与 { $to } 之间轴 { $axis } 须跳变 { $by }
motion-cure-jump = 未试：分段焊接 (start.end_phi_deg)、另选起点或改变工件放置可能有用
motion-near-singular = 距奇异姿态 { $distance } 处，轴 { $axis } 在 { $asked } 时用到其能力的 { $used }；此处最高可达 { $holds }
motion-cure-near-singular = 如需余量，将焊枪或工件倾斜几度

# Axes that are held.
motion-hold-unknown = 工件与焊枪之间没有轴 { $axis }
motion-hold-decided = 轴 { $axis } 不是冗余轴：此处焊枪位姿决定所有轴
motion-hold-too-few = 固定 { $held } 后，其余轴不能达到所有焊枪位姿
motion-hold-range = 轴 { $axis } 将固定在 { $value }，超出其行程
motion-hold-allowed-none = 无
motion-hold-allowed-count = { $axes ->
    [1] 一个轴，或换另一个轴
   *[other] 最多 { $axes } 个轴，或换其他轴
}

# Changes of the job that were tried as cures.
motion-change-move = 沿 x、y、z 移动工件 { $x }、{ $y }、{ $z } (placement.move_mm)
motion-change-work-angle = 将 torch.work_angle_deg 改变 { $by }
motion-change-work-angles = 将每个 [[torch.at]] 的 work_angle_deg 改变 { $by }
motion-cure-range-weld = { $change }：已试，各轴随之保持在行程内
motion-cure-range-pass = { $change }：已对本焊道试过，各轴随之保持在行程内
motion-cure-range-none = 未找到：已试移动工件和改变工作角
motion-cure-range-none-moved = 未找到：已试移动工件
motion-cure-range-none-angle = 未找到：已试改变工作角
motion-cure-range-none-stroke = { $tried }；轴 { $axis } 沿焊缝需要 { $needed }，其行程为 { $stroke }
motion-cure-redundant = 有冗余轴时未试任何改变：请将工件放得更靠近各轴行程中部
motion-cure-range-no-time = 允许的时间内未试任何改变
motion-cure-range-stopped = 允许的时间内未找到：已试 { $changes } 种改变中的 { $tried } 种
motion-cure-not-tried = 未试：改变焊枪角度或工件放置可能有用

# Clearance.
motion-too-near = { $first } 距 { $second } 仅 { $distance }（至少 { $minimum }）
motion-collision = { $first } 撞上 { $second }（至少 { $minimum }）
motion-above-root = { $contact }，根部以上 { $height }
motion-below-root = { $contact }，根部以下 { $height }
motion-no-torch-angle = 工作角 { $work }、行走角 { $travel } 范围内没有使焊枪不碰撞的角度：{ $reason }
motion-no-torch-angle-longer = 工作角 { $work }、行走角 { $travel } 范围内，即使干伸长增加至多 { $longer }，也没有使焊枪不碰撞的角度：{ $reason }
motion-angle-none-allowed = 接头两面、工艺或轴行程不允许其中任何一个
motion-angle-turns-too-fast = 不碰撞的角度在 { $way } 内变化超过 { $turn }
motion-cure-torch-angle = 换用更细的焊枪或更长的伸出长度、更宽的坡口、在 torch.search 中放宽范围，或减小 clearance.least_mm
motion-cure-clearance = 改变焊枪角度或工件放置；若形体正确也可减小 clearance.least_mm
motion-cure-clearance-weld = { $change }：已试，随之各处距离足够；若形体正确也可减小 clearance.least_mm
motion-cure-clearance-pass = { $change }：已对本焊道试过，随之各处距离足够；若形体正确也可减小 clearance.least_mm
motion-cure-clearance-none = 未找到：与此相差 { $angle } 以内的工作角均无效；移开障碍物，若形体正确也可减小 clearance.least_mm
motion-cure-clearance-stopped = 允许的时间内未找到：已试 { $angles } 个工作角中的 { $tried } 个；移开障碍物，若形体正确也可减小 clearance.least_mm
motion-cure-clearance-move = 移开障碍物，若形体正确也可减小 clearance.least_mm
motion-no-shapes = { $machine } 没有形体：不检查碰撞，空程走直线
motion-cure-no-shapes = 在机床文件中用 [[shapes.<link>]] 描述焊枪和连杆

# Transfer moves.
motion-transfer-from-home = 从原位到焊缝的空程
motion-transfer-home = 从焊缝回原位的空程
motion-transfer-between = 从焊道 { $from } 到焊道 { $to } 的空程
motion-transfer-too-long = { $move }：需 { $time }，最长允许 { $limit }
motion-cure-transfer-too-long = 提高机床各轴的速度和加速度，或将工件移近
motion-transfer-blocked = { $move }：{ $reason }
motion-cure-transfer-blocked = 未试：移动工件、夹具或原位，或另选焊缝起点可能有用
motion-transfer-start = 起点有干涉：{ $obstacle }
motion-transfer-end = 终点有干涉：{ $obstacle }
motion-transfer-retract = 退枪有干涉：{ $obstacle }
motion-transfer-approach = 进枪有干涉：{ $obstacle }
motion-transfer-none = 未找到无碰撞路径；直行时 { $obstacle }
motion-retract-short = { $move }：焊枪只能退 { $distance }（要求 { $asked }）
motion-retract-none = { $move }：没有轴能沿焊枪轴向退枪，焊枪从侧向离开
motion-cure-retract = 确认该处焊缝旁无障碍，或要求更小的退枪距离
motion-unwind = { $move }：轴 { $axis } 回转 { $by }

# Planning that was stopped.
motion-search-out-of-time = 搜索 { $limit } 内未得到计划：{ $progress }
motion-search-cancelled = 计划已取消：{ $progress }
motion-search-progress = { $stage }，完成 { $part }，已试 { $positions } 个位置
motion-search-reach = 求解沿焊缝的位姿
motion-search-sampling = 冗余轴采样
motion-search-joining = 连接采样位置
motion-search-refining = 细化冗余轴
motion-search-speed = 规划速度曲线
motion-search-weave = 试算摆动频率
motion-search-transfer = 搜索空程路径
motion-search-cure = 试算处理办法
motion-search-torch-angles = 试算焊枪角度
motion-cure-search = 允许更长时间、固定冗余轴 (spare_axes.hold)、在机床文件中缩小其行程，或分段焊接
motion-cure-plan-again = 请重新规划

# Comparison with the welding procedure specification.
motion-quantity-speed = 尖端速度
motion-quantity-heat-input = 热输入
motion-quantity-travel-angle = 行走角
motion-quantity-work-angle = 工作角
motion-quantity-stick-out = 干伸长
motion-run-pass = 焊道 { $passes }
motion-run-passes = 焊道 { $passes }
motion-procedure-outside = { $quantity }在 s = { $at } 处为 { $found }；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-procedure-unbounded = { $quantity }在 s = { $at } 处无上限：焊枪在此带弧停止；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-procedure-no-power = 焊道没有给出 { $keys }，因此其热输入未知；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-procedure-no-faces = 接头两面未知，因此工作角未知；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-procedure-no-stick-out = 干伸长未知；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-procedure-missing = 焊道没有给出 { $key }；{ $procedure } 允许（{ $run }）{ $min } 至 { $max }
motion-implausible = { $key } = { $found } 与 { $current } 不符：通常为 { $expected }，上下 { $percent }
motion-cure-implausible = 检查 { $key }、电流和焊丝；特殊电弧可放宽规程 [plausibility] 中的 percent
motion-cooling-outside = 焊缝从 800 冷却到 500 °C 用时 { $found }；允许 { $min } 至 { $max }
motion-cooling-unbounded = 焊枪带弧停住：冷却时间无上限；允许 { $min } 至 { $max }（最多 { $found }）
motion-cure-cooling-slow = 降低热输入或层间温度
motion-cure-cooling-fast = 提高热输入或预热温度
motion-preheat-low = 规程预热至 { $found }；EN 1011-2（方法 B）要求 { $needed }
motion-pool-too-large = 焊道在 s = { $s } 处面积为 { $area }，位置 { $position }；不摆动时最多能保持 { $max }
motion-cure-preheat-low = 将 preheat_c 和 interpass_c 的下限提高到 { $needed }
motion-cure-pool = 采用更小的焊道（更高速度、更少焊丝）或摆动，或将工件转到更接近平焊的位置
motion-preheat-range = 预热为外推值：EN 1011-2 方法 B 适用于 CET 0.2 至 0.5 %、10 至 90 mm、每 100 g 氢 1 至 20 ml、0.5 至 4 kJ/mm
motion-interpass-wait = 等待 { $time }，直到焊缝冷却
motion-interpass-thickness = 等待层间温度需要工件厚度
motion-interpass-power = 等待层间温度需要热输入
motion-interpass-never = 两天内焊缝不会冷却到层间温度以下
motion-cure-interpass = 补全 [materials] 和规程，或在 [interpass] 中用 wait_s 代替 below_c
motion-procedure-no-run = { $procedure } 中没有适用于焊道 { $pass }（{ $name }）的条目
motion-procedure-position = 焊缝处于 { $position } 位置；{ $procedure } 允许（{ $run }）{ $positions }
motion-procedure-inclination = 焊缝处于 { $position } 位置（倾角 { $min_slope } 至 { $max_slope }，转角 { $min_rotation } 至 { $max_rotation }）；{ $procedure } 允许（{ $run }）{ $positions }
motion-cure-procedure-run = 在工艺文件中加入带焊道名称或编号的 [[runs]]，或重命名焊道；或采用对此评定合格的工艺
motion-cure-procedure-power = 在 weld.process 中给出 { $keys }，或在工艺的 `power` 中写明构成功率的数值；或采用对此评定合格的工艺
motion-cure-procedure-work-angle = 从该工艺条目中去掉 work_angle_deg；或采用对此评定合格的工艺
motion-cure-procedure-stick-out = 在机床文件的 [torch] 中给出 stick_out_mm
motion-cure-procedure-own-stick-out = 修改该焊道或 [torch] 的 stick_out_mm；或采用对此评定合格的工艺
motion-cure-procedure-missing = 在 weld.process 中给出 { $key }，或从 [runs.ranges] 中去掉；或采用对此评定合格的工艺
motion-cure-procedure-slower = 在此要求较低速度；或采用对此评定合格的工艺
motion-cure-procedure-faster = 在此要求较高速度，或改变放置使各轴能保持；或采用对此评定合格的工艺
motion-cure-procedure-less-heat = 在此焊得更快或功率更小；或采用对此评定合格的工艺
motion-cure-procedure-more-heat = 在此焊得更慢或功率更大；或采用对此评定合格的工艺
motion-cure-procedure-angles = 改变此处焊枪角度，或使用轴数足够的机床；或采用对此评定合格的工艺
motion-cure-procedure-lower = 在此减小 { $key }（任务的 weld.process 或程序区段）；或采用对此评定合格的工艺
motion-cure-procedure-raise = 在此增大 { $key }（任务的 weld.process 或程序区段）；或采用对此评定合格的工艺
motion-cure-procedure-position = 改变工件转角或倾角 (placement、工件偏置、spare_axes)，或在可由下坡焊变上坡焊处反向焊接；或采用对此评定合格的工艺

# Simulated weld.
motion-simulated-path = 仿真的焊枪尖端偏离焊缝 { $deviation }；允许 { $tolerance }
motion-cure-simulated-path = 查看跟随误差：整定位置环，或焊得更慢
motion-cure-simulated-path-tracked = 查看跟踪结果：传感器、速度和修正范围
motion-cure-simulated-path-untracked = 跟踪焊缝，或按规划放置工件
motion-simulated-speed = 仿真的尖端速度偏离规划速度 { $deviation }；允许 { $tolerance }
motion-cure-simulated-speed = 采用更精细的编码器、更柔和的位置环、更小的摩擦或更高的速度
motion-simulated-stop = 焊接在 { $at } 处停止：{ $reason }；其后未再焊接
motion-simulated-other-head = 另一焊头停止
motion-cure-simulated-stop = 将工件放得更接近规划位置，修复传感器，或焊得更慢
motion-simulated-drive = 轴 { $axis } 的驱动器达到其电流限值
motion-cure-simulated-drive = 采用更强的驱动器，或在机床文件中减小 max_acceleration

# Playing a speed profile under an operator's commands.
motion-override = 倍率须为 0 至 { $max }，而非 { $value }（使用为该速度规划的速度曲线时可达 1.5）
motion-override-faster = 倍率须为 0 至 { $max }，而非 { $value }
motion-override-zero = 倍率为 0：继续前请设为大于 0
motion-period = 周期须为 0.00025 至 0.004 s，而非 { $value }
motion-path-length = 路径长度须为 0 至 { $length }，而非 { $value }
motion-faster-profile = 更快的速度曲线须按速度的 1 倍以上、至多 1.5 倍规划，而非 { $value }
motion-step-end = 步进终点须在已焊终点 { $welded } 之后且不超过 { $length }，而非 { $value }
motion-stuck = 运动无法在 { $s } 处继续：该处速度曲线超出各轴限值

# Manual motion.
motion-jog-range = 轴 { $axis } 不能到 { $value }：其行程为 { $min } 至 { $max }
motion-jog-position = 轴 { $axis } 的位置不是有限数
motion-jog-speed = 轴 { $axis } 的速度不是有限数
motion-jog-tip = 尖端速度不是有限数
motion-jog-period = 周期为 { $value }；须大于 0 且不超过 1 s
motion-jog-silence = 信号超时为 { $value }；须大于 0 且不超过 1 s
motion-jog-override = 倍率为 { $value }；须大于 0 且不超过 1
motion-jog-axis = 机床有 { $axes } 个轴，没有轴 { $axis }
motion-jog-not-clear = 起始处 { $first } 与 { $second } 相距 { $distance }；至少需要 { $minimum }
motion-jog-halted = 点动已停止：请先发出静止命令
motion-jog-no-motion = 未找到从当前状态到目标的限值内运动

# Pulses.
motion-pulses-too-fast = 一个周期需要 { $asked } 个脉冲，最多可产生 { $max } 个
motion-pulses-crowded = { $pulses } 个脉冲在换向与周期结束之间放不下
motion-pulses-position = 位置 { $steps } 步离零点太远，无法计数；允许：不超过 1e11
motion-pulses-period = 周期为 { $ticks } 个定时器计数；允许：1 至 2.7e11

# Textbook interpolators.
motion-value-not-positive = { $what }须为大于 0 的有限数，而非 { $value }
motion-value-not-finite = { $what }须为有限数，而非 { $value }
motion-value-semi-axis-a = 半轴 a
motion-value-semi-axis-b = 半轴 b
motion-value-x = 点的 x
motion-value-y = 点的 y
motion-value-nozzle-radius = 接管半径
motion-value-shell-radius = 壳体半径
motion-value-start-angle = 起始角
motion-value-sweep = 扫掠角
motion-value-speed = 速度
motion-value-period = 周期
motion-value-step = 速度与周期之积
motion-value-pulse = 脉冲当量
motion-start-off-ellipse = 起点 ({ $x }, { $y }) 偏离椭圆 { $distance }；最多允许 { $tolerance }，椭圆上最近点为 ({ $near_x }, { $near_y })
motion-end-off-ellipse = 终点 ({ $x }, { $y }) 偏离椭圆 { $distance }；最多允许 { $tolerance }，椭圆上最近点为 ({ $near_x }, { $near_y })
motion-nozzle-too-large = 接管半径 { $nozzle } 须小于壳体半径 { $shell }
motion-sweep = 扫掠角不得为 0，且任一方向不超过 { $limit }，而非 { $sweep }
motion-step-too-long = 步长 { $step }（速度与周期之积）对此路径太长：最多 { $max }（路径长度，或整圈长度的八分之一）
motion-pulse-too-large = 脉冲当量 { $pulse } 对此形状太大：最多 { $max }
motion-too-many-steps = 这需要约 { $steps } 个步或脉冲；上限为 { $max }
motion-not-verified = 焊道 { $pass }：规划的运动无法执行（{ $why }）

# Reach of placements.
motion-reach-jump = 没有沿路径的连续轴运动
motion-reach-speed = 轴 { $axis } 在 { $asked } 时需要其速度的 { $used }
motion-reach-position = 焊接位置超出工艺规程允许范围 { $by }
