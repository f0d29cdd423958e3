# Numbered parts of a page, results and findings.
report-table = 表 { $number }.
report-figure = 图 { $number }.
report-in-order = 合格
report-not-in-order = 不合格
report-severity-note = 提示
report-severity-warning = 警告
report-severity-error = 错误
report-finding-place = 位置：{ $place }
report-finding-cure = 处理：{ $cure }
report-no-findings = 无异常。
report-heading-notes = 提示
report-heading-findings = 检查结果
report-more-places = 另有 { $n } 处

# Places, ranges and pairs of values.
report-range = { $from } 至 { $to }
report-at = s = { $s }
report-at-range = s = { $from } 至 { $to }
report-pass-at = 焊道 { $pass }，{ $place }
report-passes-at = 焊道 { $first } 至 { $last }，{ $place }
report-pair = { $first } 和 { $second }
report-pass-named = 焊道 { $pass }：{ $name }
report-curve-of-head = { $curve }，焊头 { $head }
report-part-of = { $value } / { $whole }
report-more-than = 大于 { $value }

# Charts.
report-no-data = 无数据
report-limit-above = { $limit }，在图上方
report-limit-below = { $limit }，在图下方
report-limit-outside = { $limit }，在图外
report-limit = 限值
report-limit-at-least = 至少
report-limit-at-most = 至多
report-limit-min = 最小
report-limit-max = 最大
report-label-path-length = 路径长度 s
report-label-distance = 距离
report-label-angle = 角度
report-label-heat-input = 热输入
report-label-speed = 速度
report-label-acceleration = 加速度
report-label-jerk = 加加速度
report-label-position = 位置
report-label-curvature = 曲率
report-label-deviation = 偏差
report-label-path-error = 路径误差
report-label-following-error = 跟随误差
report-label-attitude-error = 姿态误差
report-label-along-seam = 沿焊缝
report-label-across = 横向
report-label-torch-tip = 焊枪尖端

# Names of views.
report-view-front = 主视图
report-view-side = 左视图
report-view-top = 俯视图
report-view-pictorial = 轴测图，不按比例
report-seen-from-above = 俯视
report-seen-from-below = 仰视
report-seen-from-plus-x = 从 +x 看
report-seen-from-minus-x = 从 -x 看
report-seen-from-plus-y = 从 +y 看
report-seen-from-minus-y = 从 -y 看

# Columns of tables.
report-column-value = 参数
report-column-min = 最小
report-column-mean = 平均
report-column-max = 最大
report-column-allowed = 允许
report-column-outside-s = 超出，s
report-column-outside-mm = 超出，mm
report-column-pass = 焊道
report-column-name = 姓名
report-column-date = 日期
report-column-signature = 签名
report-column-alarm = 报警
report-column-priority = 优先级
report-column-cause = 原因
report-column-position-mm = s, mm
report-column-time-s = t, s
report-column-first-out = 首发报警
report-column-acknowledged = 已确认
report-column-time = 时间
report-column-event = 事件
report-column-text = 文本
report-column-version = 版本
report-column-file = 文件
report-column-rows = 行数
report-column-bytes = 字节
report-column-transfer-before-s = 之前的空程，s
report-column-start-s = 开始时刻，s
report-column-travel-s = 行走，s
report-column-arc-on-s = 燃弧，s
report-column-total-s = 合计，s
report-column-speed-mm-s = 速度，mm/s
report-column-stick-out = 干伸长，mm
report-column-arc-energy = 电弧能量，kJ/mm
report-column-heat-input = 热输入，kJ/mm
report-column-length-mm = 长度，mm
report-column-wire-m = 焊丝，m
report-column-bead = 截面中的焊道号
report-column-toe-deg = 焊趾角，°
report-column-weld-metal-kg = 熔敷金属, kg
report-column-wait-before-s = 之前等待, s
report-column-group = 组别 (ISO/TR 15608)
report-column-thickness = 厚度, mm
report-column-ce = CE (IIW), %
report-column-cet = CET, %
report-column-pcm = Pcm, %
report-column-preheat = 按 EN 1011-2 预热, °C
report-column-work = 焊前工件, °C
report-column-t85 = t8/5, s
report-column-heat-flow = 导热
report-column-at-requested-speed = 达到要求速度，%
report-column-attitude-error = 姿态误差，°
report-column-clearance = 最小距离，mm
report-column-between = 之间
report-column-path-error-mm = 路径误差，mm
report-column-rms-mm = 均方根，mm
report-column-rms = 均方根
report-column-speed-ripple = 速度波动，%
report-column-position = 位置
report-column-from = 从
report-column-to = 至
report-column-slope = 倾角
report-column-rotation = 转角
report-column-section = 区段
report-column-min-speed = 最小速度
report-column-max-speed = 最大速度
report-column-binding = 限制因素
report-column-head = 焊头
report-column-untracked = 未跟踪，99 %（mm）
report-column-tracked = 跟踪，99 %（mm）
report-column-correction-used = 占允许修正量
report-column-stopped-at = 停止处（mm）
report-column-corrected-by = 修正依据
report-column-deflected = 最大偏转（mm）
report-column-gun-carried = 电子枪最大移动（mm）
report-column-away = 离开焊缝（时间的 %）
report-column-longest = 最长（ms）
report-column-stored-within = 十分之九的点与存储值之差（mm）
report-column-peak-load = 峰值负载，%
report-column-axis = 轴
report-column-unit = 单位
report-column-range = 行程
report-column-of = 限值
report-column-speed-used = 速度，%
report-column-acceleration-used = 加速度，%
report-column-jerk-used = 加加速度，%
report-column-tip-mm = 尖端，mm
report-column-linear-axis = 直线轴
report-column-rotary-axis = 旋转轴
report-column-tip-speed = 尖端速度
report-column-process-value = 工艺参数

# Title blocks of pages.
report-subtitle-plan = 焊接报告：规划
report-subtitle-simulation = 焊接报告：规划与仿真
report-subtitle-record = 焊接记录 { $id }
report-subtitle-record-simulated = 焊接记录 { $id }，仿真：未焊接金属
report-meta-part = 工件
report-meta-welder = 焊工
report-meta-machine = 机床
report-meta-procedure = 焊接工艺规程
report-meta-started = 开始
report-meta-ended = 结束
report-not-yet = 尚未结束
report-none = 无
report-meta-page-made = 页面生成时间
report-meta-made-by = 生成软件

# Headings.
report-heading-values = 工艺规程与实际值
report-heading-deviations = 偏差曲线
report-heading-alarms = 报警
report-heading-events = 事件
report-heading-record = 记录
report-heading-procedure = 焊接工艺规程
report-heading-program = 程序
report-heading-signatures = 签字
report-heading-errors = 错误
report-heading-map = 焊接图与时间表
report-heading-process = 沿焊缝的工艺
report-heading-materials = 材料、预热与冷却
report-heading-cut = 管端切口
report-heading-source = 任务文本
report-heading-passes = 焊道
report-heading-checks = 检查
report-heading-curves = 附录：曲线
report-heading-seam = 焊缝与焊枪
report-heading-joint = 接头
report-heading-taught = 示教区段
report-heading-tracking = 焊缝跟踪
report-heading-simulated = 仿真焊接
report-heading-axes = 各轴
report-heading-programs = 零件程序
report-heading-job = 焊道的开始与结束
report-heading-released = 批准
report-heading-pass-curves = 焊道 { $pass }（{ $name }）：曲线

# Record of a weld: result.
report-result-good = 已焊至终点，在公差内。
report-result-deviating = 已焊至终点，但并非全部符合要求。
report-result-stopped = 未到终点即停止。
report-result-interrupted = 被中断：程序故障或断电。
report-result-running = 未结束：正在焊接，或程序崩溃。
report-windows-without-procedure = 没有可供对照的焊接工艺规程。
report-windows-within = 所有数值都在工艺规程范围内。
report-windows-outside = 超出工艺规程范围：{ $values }。
report-value-outside-at = 焊道 { $pass } 的 { $value }，s = { $from } 至 { $to }
report-value-outside = 焊道 { $pass } 的 { $value }
report-record-note = 备注：{ $note }。
report-tile-arc-on = 燃弧时间
report-tile-deviation = 偏差
report-tile-mean = 平均；{ $from } 至 { $to }
report-tile-max-at = 最大，s = { $s } 处

# Record of a weld: tables.
report-caption-by-hand = 手工填写
report-inspector = 检验员
report-welding-engineer = 焊接工程师
report-caption-actual-values = 焊道行进时（不含暂停、起弧和收弧）的实际值与工艺规程范围
report-no-values = 没有记录的数值。
report-not-limited = 不限
report-outside = 超出
report-within = 在范围内
report-allowed = 允许
report-no-alarms = 无报警。
report-caption-alarms = 按出现顺序排列的报警
report-first-out = 首发
report-no = 否
report-caption-events = 按发生顺序排列的事件
report-caption-sources = 焊接所依据的文本，由记录库保存；程序的 SHA-256 { $sha256 }
report-caption-files = 记录的文件

# Record of a weld: charts.
report-heat-input-unknown = 未知：没有工艺规程，无法确定功率。
report-chart-heat-input = 沿焊缝的热输入
report-caption-heat-input-bins = 焊枪尖端每走 { $bin } 的能量除以行程。
report-chart-tip-off-path = 焊枪尖端偏离规划路径
report-caption-tip-off-path = 实际焊枪尖端到焊缝的法向距离，每 { $bin } 取最大值。
report-chart-weld-off-joint = 焊缝与接缝的偏差
report-caption-weld-off-joint = 焊缝偏离接缝的横向和高度距离，每 { $bin } 取最大值。
report-curves-shown = 显示 { $all } 条曲线中的 { $shown } 条；全部都在记录中。

# Plan: checks and verdict.
report-no-findings-plan = 无：此机床可按要求焊接。
report-checked = 已检查：各轴的可达性、行程、速度、加速度和加加速度；焊枪轴线不进入两个表面；下列各物相互之间的距离：{ $objects }，沿焊道和空程，以文件给出的形体为限。未检查：不在此列表中的物体、超出任务所给长度的工件部分、电缆和软管。
report-checked-without-shapes = 已检查：各轴的可达性、行程、速度、加速度和加加速度，以及焊枪轴线不进入两个表面。未检查碰撞：机床文件没有形体。
report-verdict-planned = 已规划：所有轴均在限值内，从加速段到减速段均为要求的速度。
report-verdict-planned-slowed = 已规划：所有轴均在限值内，在轴需要处减速至 { $speed }。
report-verdict-within = 符合 { $procedure }。
report-verdict-outside = 超出 { $procedure }：{ $n } 项。
report-verdict-findings = 检查结果：待改正 { $errors } 项，待复核 { $warnings } 项。
report-verdict-simulated = 仿真：路径误差最大 { $error }（允许 { $allowed }），速度偏差 { $ripple }（允许 { $ripple_allowed }）。
report-verdict-simulated-short = 仿真：路径误差最大 { $error }（允许 { $allowed }），太短，无法评价速度。

# Plan: key figures.
report-tile-weld-length = 焊接长度
report-seam-length = 焊缝 { $length }
report-length-of-passes = { $of }；{ $n } 道，合计 { $length }
report-through-points = 通过各点
report-tile-weld-time = 焊接时间
report-travel = 从静止到静止的行走
report-travel-of-passes = 全部 { $n } 道从静止到静止的行走
report-tile-path-error = 路径误差（仿真）
report-path-error-rms = 最大；RMS { $rms }
report-tile-speed-ripple = 速度波动（仿真）
report-speed-range = { $from } 至 { $to }，RMS { $rms }
report-too-short = 焊缝太短，无法评价
report-tile-attitude-error = 姿态误差
report-attitude-error-of-plan = 规划中的最大值
report-tile-arc-energy = 电弧能量
report-arc-energy-range = 最大；最小 { $min }；U I / v
report-tile-wire = 焊丝
report-wire-length = 燃弧期间 { $length }
report-tile-weld-metal = 焊缝金属
report-tile-gas = 保护气
report-gas-time = 从提前送气到滞后送气
report-tile-flux = 焊剂
report-tile-energy = 电弧能量
report-mains = 电网 { $energy }
report-tile-heat-input = 热输入
report-heat-input-range = 最大；最小 { $min }
report-tile-total = 总时间
report-total-parts = 从原位到原位；空程 { $transfer }
report-total-parts-waiting = 从原位到原位；空程 { $transfer }，等待 { $wait }
report-duty = 占总时间 { $part }；10 分钟负载持续率 { $duty }
report-tile-cost = 成本
report-cost-labour = 人工
report-cost-machine = 设备
report-cost-wire = 焊丝
report-cost-gas = 气体
report-cost-flux = 焊剂
report-cost-energy = 电能
report-cost-incomplete = 不完整：有数量未知
report-wire-with-arc = 燃弧期间

# Plan: order of welding.
report-caption-order = 焊道按焊接顺序编号。虚线：空程，从终点到起点画成直线。
report-chart-order = 焊接顺序：{ $n } 道，{ $view }
report-order-key = 圆点：起点。箭头：焊接方向。虚线：空程，画成直线。
report-order-key-tacks = 橙色、编号在外：定位焊。
report-order-lines = { $title }：{ $n } 条线，按顺序
report-caption-map = 焊接图：焊缝展开，每条焊道一行，按焊接顺序排列。
report-chart-map = 展开焊缝上的焊接图
report-map-key = 圆点：起点。短线：终点。箭头：焊接方向。编号：焊道。
report-map-copies = { $n } 条焊缝中的第一条。
report-map-label = { $title }：{ $n } 行，{ $length }
report-caption-order-table = 时间表：按焊接顺序排列的焊道
report-all-from-home = 全部，从原位回到原位

# Plan: passes.
report-caption-passes = 每道焊道的计划值
report-all-passes = 全部焊道
report-caption-checks = 各焊道的检查
report-caption-materials = 母材和焊缝金属的碳当量：IIW 的 CE、EN 1011-2 的 CET、伊藤和别所的 Pcm。
report-materials-decisive = 预热按 CET { $cet } 和每 100 g 氢 { $hydrogen } ml 计算。
report-caption-heat = 按 EN 1011-2 方法 B 的预热和 800 至 500 °C 冷却时间，厚度 { $thickness }：从最冷工件上的最小热输入到最热工件上的最大热输入。
report-no-preheat = 无
report-weld-metal = 焊缝金属
report-material-group = { $group } 组
report-caption-simulated-passes = 各仿真焊道的结果
report-about-curves = 每种焊道给出一道的曲线：有错误的一道，否则为最长的一道。`plan --plots` 写出所有焊道的曲线。

# Plan: seam, torch and process.
report-caption-seam = 焊缝与要求的焊枪轴线，任务坐标系，第一角画法。
report-curve-bead = 焊道
report-curve-seam = 焊缝
report-curve-path = 路径
report-curve-torch-axis = 焊枪轴线
report-mark-start = 起点
report-mark-end = 终点
report-mark-end-of-overlap = 搭接终点
report-chart-torch-angles = 焊枪角度与坡口
report-curve-work-angle = 工作角（偏离角平分线）
report-curve-travel-angle = 行走角（+ 后倾，− 前倾）
report-curve-half-dihedral = 二面角的一半
report-caption-torch-angles = 相对两面角平分线的工作角（朝第一件为正）、行走角和两面夹角的一半。
report-chart-process-values = 要求的工艺参数
report-caption-process-values = 沿焊道变化的工艺参数；不含两端的斜升和斜降。
report-chart-weave = 最初 { $length } 内尖端的摆动路径
report-curve-tip = 尖端
report-curve-beam = 束流
report-first-part = 第一件
report-second-part = 第二件
report-caption-weave = 要求的摆动路径，沿焊枪方向看，焊缝展直，纵横比例相同；向右行进。
report-chart-oscillation = { $n } 个周期内束流在工件上的路径：{ $speed } 时每周期 { $advance }
report-caption-oscillation = 偏转的束流在工件上的路径，纵横比例相同；oscillation.csv 含一个偏转周期。
report-caption-cut = 管端切口的展开图；cut.svg 为实际尺寸，从外侧看，可包在管子上；cut.csv 为其各点。
report-chart-cut = 切口样板
report-cut-outside = 外侧：半径 { $radius }，周长 { $around }，切口沿轴线 { $from } 至 { $to }，边缘在 { $edge }
report-cut-inside = 内侧：半径 { $radius }，周长 { $around }，切口沿轴线 { $from } 至 { $to }，边缘在 { $edge }
report-sections = { $title }：{ $n } 个截面
report-section-note = 二面角 { $dihedral }，面积 { $area }
report-section-toes = ，焊趾角 { $second } 和 { $first }
report-area-with-cap = { $groove } + { $cap }
report-section-torch = 焊枪：工作角 { $work }，行走角 { $travel }
report-caption-sections = 沿焊缝的截面，同一比例，第二件表面水平或对接焊缝正面朝上：按焊接顺序的焊道及各道焊丝指向；面积为坡口及其余高的面积。

# Plan: welding procedure.
report-caption-heat-input = 规划速度下加速段与减速段之间的热输入及其范围；超出处加阴影。
report-caption-positions = 按行走倾角和焊缝表面转角确定的焊接位置 (ISO 6947)，随机床各轴转动工件而变。
report-too-high = 过高
report-too-low = 过低
report-chart-positions = 焊接位置
report-curve-slope = 倾角（+ 上坡）
report-curve-rotation = 焊缝表面转角（0 朝上，180 朝下）
report-run = 工艺条目 { $run }
report-no-run = 其中没有适用于此焊道的条目
report-procedure = { $number }（{ $title }），{ $run }。焊接方法 { $process }：{ $process_name }。热输入为 { $efficiency } × 功率 / 规划速度。位置按{ $joint ->
        [fillet] 角
       *[butt] 对接
    }焊缝确定。
report-caption-plan-values-of = 规划与工艺规程对照，焊道 { $passes }
report-unbounded = 无上限
report-to-be-measured = 待测量
report-unknown-see-findings = 未知：见检查结果
report-outside-at = 超出：s = { $from } 至 { $to }
report-outside-pass = 超出：焊道 { $passes }
report-outside-at-more = 超出：s = { $from } 至 { $to } 及另外 { $n } 段
report-caption-positions-any = 焊接位置（mm，度）；工艺规程允许任意位置
report-caption-positions-allowed = 焊接位置（mm，度）；工艺规程允许 { $positions }
report-not-allowed = 不允许

# Plan: taught spans.
report-chart-taught = 示教区段 { $number }
report-caption-taught = 实焊焊缝与标称焊缝对比：两端衔接处位置、方向和曲率相同。
report-taught = 示教
report-chart-off-nominal = 与标称焊缝的距离
report-curve-as-welded = 实焊焊缝
report-curve-nominal = 标称焊缝
report-curve-taught-points = 示教点
report-chart-direction-off-nominal = 相对标称焊缝的方向
report-chart-curvature = 曲率
report-chart-tip-speed = 焊枪尖端速度
report-curve-planned = 规划
report-shorter = 短
report-longer = 长
report-taught-span = 区段 { $number }：s = { $from } 至 { $to }（比该处标称焊缝{ $change } { $length }），{ $n } 个示教点；偏离标称焊缝最多 { $distance }，方向偏差最多 { $angle }。

# Plan: clearance.
report-caption-clearance = 焊枪、连杆、工件、夹具和区域之间的最小距离及其沿整个焊道的下界。
report-chart-clearance = 最小距离（显示至 { $limit }）
report-curve-clearance = 最小距离
report-curve-clearance-bound = 采样点之间的已证下界

# Plan: speed.
report-speed-reached = 要求：{ $requested }。加速段与减速段之间达到：{ $reached }。{ $part } 的长度上达到所要求的速度。
report-caption-speed = 尖端沿焊缝相对工件的速度；低于要求处加阴影，并注明起限制作用的限值。
report-chart-speed = 焊枪尖端沿焊缝的速度
report-curve-tip-simulated = 实际尖端（仿真）
report-acceleration-phase = 加速段
report-deceleration-phase = 减速段
report-section-weld = 焊缝
report-axis = 轴 { $axis }
report-torch-tip = 焊枪尖端
report-requested-speed = 要求的速度
report-binding = { $owner }的{ $what }，{ $limit }
report-no-binding = 无：达到所要求的速度
report-caption-binding = 速度的限制因素（mm，mm/s）
report-caption-binding-first = 速度的限制因素（mm，mm/s）：前 { $n } 段，另有 { $more } 段见 report.json
report-caption-deviation = 加速段与减速段之间仿真速度的偏差；开始处驱动器趋于稳定。
report-chart-deviation = 实际尖端速度与规划速度之比较

# Plan: tracking.
report-part-displaced = 工件不在规划位置。
report-tracking-without-alarms = 跟踪未报警。
report-welded-as-planned = 已按规划焊接。
report-to-be-checked = 请检查：{ $alarms }。
report-alarm-at = { $head } 在 { $s } 处：{ $alarm }
report-caption-tracking = 接缝相对规划路径的实际位置、焊缝与接缝的偏差以及所跟踪接缝的不确定度。
report-chart-tracking = 接缝与焊缝
report-chart-joint = 接缝偏离规划路径（不跟踪时焊缝的偏差）
report-chart-weld = 焊缝偏离接缝
report-chart-correction = 横向修正：束流偏转；虚线为各轴带动电子枪
report-chart-sigma = 接缝位置的不确定度（标准差）
report-curve-lateral = 横向
report-curve-height = 高度
report-curve-deflection = 偏转
report-curve-gun = 各轴带动电子枪
report-curve-sigma = 标准差 σ
report-not-welded = 未焊接
report-not-tracked = 未跟踪
report-caption-tracked-lateral = 焊缝与接缝的横向距离：束流没有高度
report-caption-tracked = 焊缝与接缝的距离，横向与高度合计
report-stored-points = { $value }（{ $n } 点）
report-stored-deviations = 存储的偏差
report-seen-by-beam = 束流测量值
report-caption-beam = 束流修正

# Plan: simulation.
report-simulation = 每轴按伺服周期运行位置环，含惯量、摩擦、齿槽力、编码器步距和电流限值（种子 { $seed }）。工件为标称状态：无错位、无变形、无装配误差、焊丝无弯曲。速度波动是加速段结束半秒后至减速段之间尖端速度与规划速度的最大偏差。
report-highest-load = 负载最高的驱动器是 { $axis }：峰值的 { $load }。
report-assumed-drives = 机床文件没有描述 { $axes } 的驱动器：采用了假定值。
report-caption-path-error = 实际尖端到焊缝的法向距离。
report-chart-path-error = 实际焊枪尖端到焊缝的距离
report-curve-normal-to-seam = 焊缝法向
report-caption-following = 各轴设定位置减实际位置。
report-chart-following = 各轴的跟随误差
report-caption-following-table = 燃弧时的跟随误差
report-caption-attitude = 实际焊枪方向与要求方向之间的角度。
report-chart-attitude = 实际焊枪方向与要求方向的偏差

# Plan: axes.
report-continuous = 连续
report-caption-axes = 各轴的规划位置、速度和加速度及其限值。
report-caption-jerks = 各轴的规划加加速度及其限值。
report-chart-axes = 各轴及其限值
report-chart-jerks = 各轴加加速度及其限值
report-caption-ranges = 各轴位置及其行程
report-caption-uses = 各轴限值的最大使用量

# Plan: part programs.
report-program = { $file }，用于 { $dialect }：{ $n } 个运动段，重新读入，按控制器自身的插补和进给规则运行，经机床正运动学计算并与规划比较；允许 { $tolerance }。
report-as-in-program = 同程序
report-caption-program = { $file } 的最大偏差

# Plan: job data.
report-caption-job = 行走前后的时间与数值
report-row-seam = 焊缝
report-row-seam-length = 焊缝长度
report-row-acceleration-phase = 加速段
report-row-deceleration-phase = 减速段
report-row-start-angle = 起始角
report-row-direction = 焊接方向
report-row-dihedral = 二面角
report-row-preparation = 坡口
report-counter-clockwise = 逆时针
report-clockwise = 顺时针
report-row-overlap = 搭接
report-row-preflow = 提前送气
report-row-travel-delay = 起弧至行走
report-row-upslope = 斜升起始：{ $value }
report-row-upslope-time = 斜升：时间
report-row-downslope = 斜降终止：{ $value }
report-row-downslope-time = 斜降：时间
report-row-crater = 弧坑填充
report-row-postflow = 滞后送气

# Check of a machine: page.
report-check-subtitle = 机床文件检查
report-check-made-by = Seamwright { $version }，种子 { $seed }
report-check-heading-failed = 未通过的测试
report-check-remarks = 备注
report-check-heading-kinematics = 运动学
report-check-singular = 奇异位形
report-check-heading-reach = 可达范围
report-check-heading-file = 机床文件
report-check-remark-count = 备注：{ $n } 项
report-check-passed = 每个位姿都能由其自身的轴位置重新得到，雅可比矩阵与差分一致；{ $remarks }。
report-check-failed = { $failures }；{ $remarks }。
report-check-axis-count = 旋转轴 { $rotary }，直线轴 { $linear }
report-check-tip-error = 往返误差，尖端
report-check-tip-error-note = 每个焊头 { $n } 个随机位姿的最大值
report-check-jacobian = 雅可比矩阵
report-check-jacobian-note = 最大相对偏差
report-check-singular-note = 行程之内
report-check-remarks-note = 不寻常的值
report-check-caption-machine = 机床处于原位，基坐标系，第一角画法。箭头表示各轴所移动部分的正方向：刀具侧为焊枪，工件侧为工件；转动遵循右手定则。会相互遮挡的符号并排画出。
report-check-no-remarks = 无：限值、行程和驱动器大小正常且相互匹配。
report-check-remark = { $key }：{ $why }
report-check-remark-value = { $key } = { $value }：{ $why }
report-check-line = { $file }，第 { $line } 行
report-check-typical = 典型焊缝以 { $speed } 沿半径 { $radius } 的弯曲行进，焊枪转动 { $rate }。
report-check-too-fast = 在 { $part } 的行程内，典型焊缝要求的速度超过旋转轴的能力。
report-check-fast-enough = 在全部行程内，典型焊缝都在旋转轴的速度范围内。
report-check-no-singular = 焊头 { $head }：行程内没有奇异位形。条件最差的位置为 { $position }（条件数 { $worst }；最佳位置 { $best }）。
report-check-reach = 焊头 { $head }：尖端在工件坐标系中可达的{ $kind ->
        [volume] 体积
        [area] 面积
       *[length] 长度
    }：{ $size }，为包围盒的 { $part }。从工件看，焊枪相对原位方向最多倾斜 { $tilt }。
report-check-no-volume = 无：尖端停留在一个面或一条线上
report-check-point = 一个点
report-check-size = { $value } ± { $deviation }
report-check-position = { $axis } { $position }

# Check of a machine: tables.
report-check-column-letter = 字母
report-check-column-kind = 类型
report-check-column-moves = 移动
report-check-column-home = 原位
report-check-column-speed = 速度，/s
report-check-column-acceleration = 加速度，/s²
report-check-column-jerk = 加加速度，/s³
report-check-column-time = 加速时间，s
report-check-caption-axes = 各轴；直线轴以 mm 计，旋转轴以度计。最后一列为从静止到最大速度的时间。
report-check-linear = 直线
report-check-rotary = 旋转
report-check-torch = 焊枪
report-check-work = 工件
report-check-no-end-stops = 无限位
report-check-column-result = 结果
report-check-column-poses = 位姿数
report-check-column-direction = 方向，°
report-check-column-axes = 各轴，mm 或 °
report-check-column-near-singular = 近奇异
report-check-column-unsolved = 无解
report-check-column-branch-missing = 缺少自身分支
report-check-both-heads = 双焊头
report-check-off-centre = { $unsolved }（另有 { $n } 个滑台偏心）
report-check-caption-results = 往返检验：随机轴位置、其位姿、该位姿的所有轴位置及其各自的位姿。最大偏差；各轴的偏差在远离奇异位形处。
report-check-result-passed = 通过
report-check-result-failed = 未通过
report-check-column-inverse = 逆解
report-check-column-difference = 偏差
report-check-column-worst-axis = 最差轴
report-check-caption-structure = 由位姿求轴位置的方法，以及雅可比矩阵与中心差分的比较：相对其所在列的最大偏差。
report-check-margin = { $distance }（更近时 { $axis } 太慢）
report-check-caption-singular = 焊头 { $head } 在行程内的奇异位形，以及典型焊缝需要与其保持的距离。
report-check-column-configuration = 位形
report-check-column-distance = 所需距离
report-check-column-box = 包围盒
report-check-tip-in-work = 工件坐标系中的尖端
report-check-tip-in-base = 基坐标系中的尖端
report-check-caption-reach = 尖端可达的所有位置的包围盒，mm。

# Check of a machine: text.
report-check-text-result = 结果
report-check-text-failure = 错误
report-check-text-head = 焊头
report-check-text-inverse = 逆解
report-check-text-round-trip = 往返
report-check-text-errors = { $n } 个位姿：尖端 { $tip }，方向 { $direction }，各轴 { $axes }（mm 或 °）；{ $near } 个近奇异
report-check-text-jacobian = 相对列的偏差 { $difference }
report-check-text-singular = 奇异
report-check-text-margin = { $place }；距离小于 { $distance } 时，{ $axis } 对于 { $radius } 上的 { $speed } 太慢
report-check-text-no-singular = 行程内没有
report-check-text-reach = 可达范围
report-check-text-box = 工件坐标系中 x { $x }，y { $y }，z { $z } mm
report-check-text-tilt = { $size }；相对原位最多 { $tilt }
report-check-text-pair = { $n } 个位姿：尖端 { $tip }，方向 { $direction }；{ $off } 个滑台偏心，无解
report-check-text-remark = 备注
report-check-text-line = 第 { $line } 行：{ $remark }
report-check-text-cure = 处理：{ $cure }

# Drawings without a title, for screen readers.
report-three-views = 三视图
report-charts = 图表
report-machine = 机床

# Drawing of a machine.
report-machine-title = { $machine }：各轴处于原位，基坐标系
report-machine-moves-torch = 正方向移动焊枪
report-machine-moves-work = 正方向移动工件
report-machine-beam = 束流或焊丝，止于尖端
report-machine-links = 连杆和形体
report-machine-towards = 正方向朝向您
report-machine-away = 正方向背离您
report-machine-stroke = 行程，箭头在最大位置
report-machine-cut = 延续
report-machine-home = 原位
report-machine-base = 基座
report-machine-work = 工件
report-machine-up = 上

# Bode plots.
report-bode-frequency = 频率
report-bode-magnitude = 开环幅值
report-bode-phase = 开环相位
report-bode-crossover = 穿越
report-bode-open-loop = 开环
report-bode-gain-margin = 幅值裕度 { $margin }，{ $frequency } 处
report-bode-gain-unbounded = 幅值裕度：无界
report-bode-phase-margin = 相位裕度 { $margin }，{ $frequency } 处
report-bode-phase-unbounded = 相位裕度：无界

# Search for placements.
report-reach-subtitle = 工件摆放
report-reach-subtitle-base = 机床基座的摆放
report-reach-title = { $machine } 的可达性
report-reach-key = 数字：轴距行程端点的最小距离，行程的 %
report-reach-label = { $title }：摆放图
report-reach-shade = { $from } 到 { $to } %
report-reach-shade-above = 高于 { $from } %
report-reach-fails = 不可焊
report-reach-present = 当前摆放
report-reach-best = 最佳摆放
report-reach-judged = 已判定的摆放
report-reach-weldable = 可焊
report-reach-clearance = 最佳处的间隙
report-reach-kind-reach = 够不到
report-reach-kind-range = 轴行程
report-reach-kind-jump = 无连续运动
report-reach-kind-speed = 轴速度
report-reach-kind-position = 焊接位置
report-reach-found = 最佳摆放：x { $x }、y { $y }、z { $z }，转 { $turn }；已规划
report-reach-none = 没有可焊且已规划的摆放
report-reach-heading-map = 图
report-reach-heading-best = 最佳摆放
report-reach-heading-reasons = 失败原因
report-reach-heading-method = 方法
report-reach-method = 位移以工件坐标系表示，从当前摆放算起；绕通过焊缝中心的竖直线转动。每个单元显示网格中该 x、y 处的最佳摆放；不可焊时显示轴或原因种类。最佳摆放已完整规划，包括间隙和空行程；其余按行程、速度、焊接位置和连续运动判定。
report-reach-method-base = 位移是机床基座的位移，以基座坐标系表示，从当前摆放算起；绕通过其原点的竖直线转动。基座上的一切随之移动。每个单元显示网格中该 x、y 处的最佳摆放；不可焊时显示轴或原因种类。最佳摆放已完整规划，包括间隙和空行程；其余按行程、速度、焊接位置和连续运动判定。
report-reach-caption-map = 沿 x 和 y 的摆放
report-reach-caption-best = 已判定摆放中的最佳者
report-reach-caption-reasons = 原因，各附最接近可焊的摆放
report-reach-column-turn = 转动, °
report-reach-column-margin = 余量, 行程的 %
report-reach-column-axis = 轴
report-reach-column-singular = 距奇异姿态, %
report-reach-column-speed = 轴速度使用率, %
report-reach-column-kind = 原因
report-reach-column-count = 摆放数
report-reach-column-pass = 焊道
report-reach-column-s = s, mm
report-reach-column-reason = 最接近的情形
