# Words of the panel, in the order of its pages.

# Words for several pages.
panel-least = 最小
panel-mean = 平均
panel-greatest = 最大
panel-allowed = 允许
panel-program = 程序
panel-pass = 焊道
panel-alarm = 报警
panel-language = 语言
panel-tabs = 页面
panel-cancel = 取消
panel-close = 关闭
panel-search = 搜索
panel-all = 全部
panel-on = 开
panel-off = 关
panel-undo = 撤销
panel-redo = 重做
panel-set = 设定
panel-actual = 实际
panel-abort = 中止
panel-stop = STOP：软件停止
panel-mode = 状态
panel-armed = 已允许
panel-recording = 记录 { $weld }
panel-simulated = 仿真
panel-commands = 命令
panel-refused = 被拒绝：
panel-why = 为什么不能启动？
panel-passes = 焊道
panel-progress = 进度
panel-time-left = 剩余 { $time }
panel-readouts = 读数
panel-process = 工艺
panel-gas = 气体
panel-speed = 速度
panel-override = 倍率
panel-bottom = 报警和曲线
panel-scene = 三维单元
panel-clearance = 间距
panel-section = 接头截面
panel-axis = 轴
panel-conditions = 条件（联锁）
panel-condition = 条件

# Alarms.
panel-alarm-cause = 原因
panel-alarm-state = 状态
panel-alarm-consequence = 后果
panel-alarm-action = 处理
panel-alarm-reaction = 反应
panel-alarm-priority = 优先级
panel-alarm-severity = 严重程度
panel-alarm-response = 响应时间
panel-alarm-shelvable = 搁置
panel-alarm-chattering = 抖动
panel-alarm-first = 首发
panel-alarm-one = 确认此报警
panel-alarm-shelve = 搁置
panel-alarm-shelve-for = 搁置时间
panel-alarm-minutes = { $minutes } 分钟
panel-alarm-unshelve = 取回
panel-alarm-shelved = 已搁置：{ $alarm }
panel-alarm-until = 至 { $time }，{ $user }
panel-alarm-shelve-how = 只能搁置仅提示的报警；会停止或暂停的报警始终显示。

# Process values.
panel-value-tip-speed = 焊枪尖端速度
panel-value-speed = 尖端速度

# States.
panel-mode-off = 断电
panel-mode-idle = 未回零
panel-mode-homing = 回零中
panel-mode-ready = 就绪
panel-mode-jog = 点动
panel-mode-teach = 示教
panel-mode-dry-run = 空运行
panel-mode-weld = 焊接
panel-mode-hold = 暂停
panel-mode-fault = 故障

# Commands.
panel-do-hold = 暂停
panel-do-resume = 继续
panel-do-reverse = 后退
panel-do-stop = 停止
panel-do-switch-on = 上电
panel-do-switch-off = 断电
panel-do-home = 回零
panel-do-start-jog = 开始点动
panel-do-start-teach = 开始示教
panel-do-start-dry-run = 空运行
panel-do-arm = 允许起弧
panel-do-arm-beam = 允许束流
panel-do-start-weld = 开始焊接
panel-do-start-beam = 开始焊接
panel-do-reset = 复位故障
panel-do-acknowledge = 全部确认
panel-do-override = 倍率
panel-do-acknowledge-one = 确认一个报警
panel-do-home-axis = 单轴回零

# Interlocks of supplied machines.
panel-interlock-emergency-stop-chain = 急停回路
panel-interlock-light-curtain = 光幕
panel-interlock-shielding-gas = 保护气
panel-interlock-torch-coolant = 焊枪冷却液
panel-interlock-doors = 门
panel-interlock-cooling-water = 冷却水
panel-interlock-gun-pressure = 电子枪真空
panel-interlock-chamber-pressure = 真空室压力
panel-interlock-chamber-door = 真空室门
panel-interlock-laser-interlocks = 激光联锁
panel-interlock-cabin-doors = 防护房门

# Records.
panel-record-part = 工件
panel-record-begun = 开始
panel-record-machine = 机床
panel-record-procedure = 焊接工艺规程
panel-record-welder = 焊工
panel-record-list = 记录
panel-record-no-hit = 没有符合条件的记录。
panel-record-none = 还没有焊接记录。
panel-record-no = 编号
panel-record-result = 结果
panel-record-worst = 最大偏差
panel-record-outside = 超出范围 { $length } mm
panel-record-from = 起始日期
panel-record-compare = 比较
panel-record-report = 报告
panel-record-facts = 摘要
panel-record-trace = 曲线
panel-record-columns = 选择信号
panel-record-no-values = 此焊道中没有这些数值。

# Events.
panel-event-time = 时间
panel-event-text = 事件
panel-event-what = 类别
panel-event-mode = 状态
panel-event-order = 命令
panel-event-refused = 拒绝
panel-event-alarm = 报警
panel-event-cleared = 解除
panel-event-pass = 焊道
panel-event-left = 中断
panel-event-record = 记录
panel-event-control = 控制权
panel-event-work = 程序
panel-event-teach = 示教

# Bottom.
panel-bottom-alarms = 报警
panel-bottom-events = 事件
panel-bottom-plots = 曲线
panel-bottom-tracking = 跟踪

# Jobs.
panel-job-head = 任务
panel-job-list = 任务
panel-job-own = 我的任务
panel-job-examples = 模板
panel-job-example = 模板 – 请另存为自己的任务
panel-job-title = 标题
panel-job-name-how = 字母 A–Z、数字和 . _ -
panel-job-name = 名称
panel-job-open = 打开
panel-job-use = 由模板新建
panel-job-load = 装入
panel-job-loaded = 已装入
panel-job-part = 工件编号（用于记录）
panel-job-part-why = 程序将被规划、检查并装入单元。不会有任何运动。
panel-job-lies = 仿真工件错位
panel-job-lies-planned = 无
panel-job-lies-why = 有偏移时跟踪焊缝。
panel-job-delete = 删除
panel-job-delete-sure = 删除 { $job }？此操作无法撤销。
panel-job-save = 保存
panel-job-save-as = 另存为…
panel-job-unsaved = 未保存
panel-job-leave = 有未保存的修改。
panel-job-discard = 放弃修改
panel-job-replace = 替换
panel-job-other = { $job } 下已保存另一文本：属于其他任务，或此后被他人修改。要用此文本替换吗？
panel-job-edit = 编辑
panel-job-preview = 预览
panel-job-form = 表单
panel-job-parts = 工件和夹具
panel-job-points = 点表
panel-job-text = 文本
panel-job-post = G 代码
panel-job-findings = 检查结果
panel-job-section = 截面
panel-job-plots = 曲线
panel-job-limits = 限值

# Tracking.
panel-track-lateral = 横向
panel-track-height = 高度
panel-track-head = 焊头
panel-track-none = 未跟踪
panel-track-confidence = 置信度
panel-track-sigma = 标准差
panel-track-guessed = 未看到

# Pages.
panel-tab-weld = 焊接
panel-tab-teach = 点动 · 示教
panel-tab-jobs = 任务
panel-tab-records = 记录
panel-tab-setup = 设置

panel-theme-light = 浅色
panel-theme-dark = 深色

# Connection.
panel-link-opening = 正在连接…
panel-link-open = 已连接
panel-link-closed = 无连接
panel-link-stale = 数据已有 { $age } 秒

# Log-in.
panel-login-user = 用户
panel-login-password = 密码
panel-login-go = 登录
panel-login-out = 退出登录
panel-login-over = 会话已结束：被关闭、被更改或已过期。单元中正在运行的会继续运行；STOP 在此同样有效。请重新登录。
panel-login-runs = 单元中有程序正在运行，您退出后会继续运行。
panel-login-stopped = 已发送 STOP；当时状态：{ $state }。
panel-login-made = 现在请以此用户登录。启动链接已失效。
panel-login-wrong = 用户名或密码错误。
panel-login-key = 首次启动：请打开程序打印的启动链接。
panel-login-owner = 所有者

# Control.
panel-control-mine = 由您控制
panel-control-give = 交出控制权
panel-control-take = 取得控制权
panel-control-free = 无人控制
panel-control-unknown = 控制权未知
panel-control-theirs = 由 { $user } 控制（操作站 { $station }）
panel-control-over = { $user } 正在控制。要接管控制权吗？
panel-control-needed = 请先取得控制权，再操作此单元。

# Roles.
panel-role-viewer = 观察者
panel-role-operator = 操作员
panel-role-programmer = 编程员
panel-role-service = 维护
panel-role-admin = 管理员

# STOP.
panel-stop-failed = STOP 未到达单元
panel-stop-emergency = 请按下急停按钮。
panel-stop-late = STOP 延迟到达单元
panel-stop-check = 请确认机器已停止且焊接过程已关闭。
panel-stop-unanswered = 页面已连接，但未及时看到单元停止。
panel-stop-no-connection = 与单元没有连接。本页面会继续尝试连接。
panel-stop-read = 已阅

# Process.
panel-process-arc-on = 电弧已燃
panel-process-beam-on = 束流已开
panel-process-arc-off = 电弧关闭
panel-process-beam-off = 束流关闭
panel-process-ordered = 已命令开启

# Phases of a pass.
panel-phase-held = 静止
panel-phase-preflow = 提前送气
panel-phase-travel-delay = 行走延时
panel-phase-travel = 焊接
panel-phase-run-out = 收尾
panel-phase-crater = 填弧坑
panel-phase-postflow = 滞后送气
panel-phase-move = 空行程
panel-phase-ended = 结束

panel-timing-no-realtime = 没有实时权限
panel-timing-missed = 错过 { $cycles } 个周期，最长 { $longest } ms

# Program.
panel-work-none = 未装入程序
panel-work-part = 工件 { $part }
panel-work-load-again = 从此处重新规划
panel-work-load-first = 请在“任务”中装入程序。

# Why can't I start?.
panel-why-for = “{ $command }”还缺
panel-why-nothing = { $command }：可以开始。
panel-why-runs = 正在运行。

# Interlocks and permissives: why a command is refused.
panel-lack-moving = 各轴尚未停稳：请稍候。
panel-lack-lost = 连接中断。任何命令都不会自动重复。

# Roles of passes.
panel-pass-role-tack = 定位焊
panel-pass-role-root = 打底
panel-pass-role-fill = 填充
panel-pass-role-cap = 盖面
panel-pass-role-cosmetic = 修饰

# Unfinished welds.
panel-left-button = 从焊道 { $pass } 的 { $s } mm 继续…
panel-left-elsewhere = 焊接 { $weld }（{ $title }，工件 { $part }）未完成：焊道 { $pass }，{ $s } mm。装入其任务和工件以继续。
panel-left-title = 从中断处继续焊接
panel-left-of = 焊接 { $weld }：{ $title }，工件 { $part }。
panel-left-where = 中断于焊道 { $pass }，已焊至 { $s } mm。
panel-left-overlap = 搭接，mm
panel-left-from = 将从焊道 { $pass } 的 { $s } mm 处重新开始。
panel-left-ground = 弧坑已打磨并检查
panel-left-arm = 不会自动启动：之后照常允许并启动。
panel-left-go = 从该处装入

# Welding again.
panel-again-title = 再次焊接已完成的部分？
panel-again-left = 如需继续，请取消并按“继续焊道 { $pass }”（停在 { $s } mm）。
panel-again-go = 再次焊接

# Positions.
panel-position-tip = 工具尖端（工件坐标系）
panel-position-tip-in = 工具尖端（{ $frame }）
panel-position-machine = 机床各轴
panel-position-unreferenced = 未回零

panel-override-less = 减小倍率
panel-override-more = 增大倍率

# Plots.
panel-plot-path = 路径速度
panel-plot-greatest = 最大跟随误差
panel-plot-position = 位置
panel-plot-axis = 轴
panel-plot-choose = 选择曲线
panel-plot-speed = 速度
panel-plot-error = 跟随误差
panel-plot-deviation = 焊缝偏差
panel-plot-seen = 测得
panel-plot-done = 已修正

# State of tracking.
panel-sight-seen = 已找到接缝
panel-sight-bridged = 已找到接缝，跨越定位焊
panel-sight-coasted = 看不到，保持修正
panel-sight-fading = 看不到，回到规划
panel-sight-unseen = 尚未看到
panel-sight-lost = 接缝丢失

# Alarms.
panel-alarms-none = 无报警
panel-alarms-unknown = 报警未知：没有当前数据
panel-alarms-more = 另有 { $n } 条

# Alarm state.
panel-alarm-state-unacknowledged = 存在，未确认
panel-alarm-state-acknowledged = 存在，已确认
panel-alarm-state-returned = 已消除，未确认
panel-alarm-state-gone = 已消除，已搁置

# Reactions.
panel-reaction-told = 仅提示
panel-reaction-hold = 暂停
panel-reaction-process-off-hold = 停止焊接，暂停
panel-reaction-process-off-stop-power-off = 停止焊接，停止运动，断电
panel-reaction-process-and-power-off = 停止焊接并断电

# Devices.
panel-device-drives = 驱动器
panel-device-source = 焊接电源
panel-device-process-source = 焊接电源
panel-device-inputs = 输入

# 3D view.
panel-scene-fails = 此浏览器无法显示三维（WebGL 2）。
panel-scene-views = 视图
panel-scene-show = 显示
panel-scene-colour = 焊道着色依据
panel-scene-cut = 剖切面
panel-scene-measure = 测量
panel-scene-heat = 电弧能量
panel-scene-no-heat = 电弧能量未知：程序既没有给出电流和电压，也没有给出功率。
panel-scene-no-value = 此程序没有该数据。
panel-scene-off-beam = 束斑偏差
panel-scene-off-torch = 偏差
panel-scene-measure-how = 请选取两处。

panel-spot-span = 区段
panel-spot-pass = 整条焊道

panel-clearance-least = （最小 { $min } mm）

# Views.
panel-view-fit = 适合
panel-view-fit-how = 焊缝；再按一次：全部
panel-view-top = 俯视
panel-view-front = 前视
panel-view-side = 侧视
panel-view-torch = 焊枪

# Layers.
panel-layer-machine = 机床
panel-layer-part = 工件和夹具
panel-layer-zones = 区域
panel-layer-air = 空移
panel-layer-near = 最近距离
panel-layer-sensors = 传感器视场
panel-layer-trace = 尖端轨迹

# Jogging.
panel-jog-frame = 运动方式
panel-jog-joints = 各轴
panel-jog-tip = 焊枪尖端
panel-jog-turn = 绕尖端
panel-jog-turn-how = 尖端不动，焊枪转动。
panel-jog-speed = 点动速度
panel-jog-end = 结束点动
panel-jog-how = 按住时运动。方向键：前两行；翻页键：第三行。
panel-jog-step = 步长
panel-jog-held = 连续
panel-jog-step-how = 每次按下移动 { $step } mm 或度；松开则提前停止。

# Go to.
panel-go-title = 移动到
panel-go-begin = 焊道 { $pass } 起点
panel-go-spot = 选定点
panel-go-home = 原位
panel-go-how = 按住时所有轴同步移动到位。不规划无碰撞路径：遇障碍前单元会停止。
panel-frame-title = 坐标系
panel-frame-work = 工件
panel-frame-base = 基座
panel-frame-tool = 工具
panel-frame-flange = 法兰
panel-frames-kind-base = 基座
panel-frames-kind-mount = 中间件
panel-frames-kind-flange = 法兰
panel-frames-kind-adapter = 转接件
panel-frames-kind-tool = 工具
panel-frames-kind-tcp = 工具中心点 (TCP)
panel-frames-kind-table = 变位机
panel-frames-kind-work = 工件
panel-frames-within-base = 在基座中
panel-frames-within-flange = 在法兰中
panel-frames-within-work = 在工件坐标系中，各轴为零
panel-frames-within-before = 在前一坐标系中
panel-frames-how = 位置单位为 mm。尖端本身在“工具”页查找。更改保存在 { $file } 中；之前的内容保留在旁边。
panel-frames-change = 更改
panel-frames-keep = 保存
panel-frames-remove = 移除
panel-frames-was = 之前：{ $frame }
panel-frames-back = 恢复之前的
panel-frames-new = 新建用户坐标系
panel-frames-taken = 该名称已被占用。
panel-frames-teach = 用三点示教
panel-frames-teach-how = 在点动中将尖端移到每个点并在此记录。坐标系以基座为参照。
panel-frames-point-1 = 原点
panel-frames-point-2 = x 轴上的点
panel-frames-point-3 = y 一侧的点
panel-frames-record = 记录
panel-frames-jog = 开始点动后可记录点。
panel-frames-taught = 点间距 { $distance } mm，夹角 { $angle }°
panel-frames-large = 更改较大：{ $distance } mm，{ $angle }°。再次保存以确认。
panel-rotation-title = 姿态
panel-rotation-kept = 保持不变
panel-rotation-xyz = RX RY RZ（固定轴 X、Y、Z）
panel-rotation-abc = A B C（随动轴 Z、Y、X）
panel-rotation-quaternion = 四元数 Q1 至 Q4
panel-rotation-next = 用另一种方式显示姿态
panel-rotation-none = 这些数字不是姿态：四元数各数的平方和为 1。
panel-target-title = 输入目标
panel-target-present = 当前位置
panel-target-check = 检查
panel-target-go = 移动到此（按住）
panel-target-clear = 途中附近无物体
panel-target-missed = 焊枪偏离此方向 { $angle }°：机器缺少相应的轴。
panel-target-how = 检查会在移动之前以三维显示目标、路径和间距。工具坐标系中的数值为相对值。
panel-arm-title = 构型
panel-arm-shoulder-front = 前
panel-arm-shoulder-back = 后
panel-arm-elbow-up = 肘朝上
panel-arm-elbow-down = 肘朝下
panel-arm-wrist-no-flip = 腕不翻转
panel-arm-wrist-flip = 腕翻转
panel-arm-turns = 圈数 { $turns }
panel-arm-no-turns = 圈数 0
panel-arm-turns-how = 轴 1 至 6 超出 180 度的整圈数
panel-arm-near-shoulder = 接近肩部奇异
panel-arm-near-elbow = 接近肘部奇异
panel-arm-near-wrist = 接近腕部奇异
panel-job-reach = 可达性
panel-reach-moved = 移动对象
panel-reach-work = 工件
panel-reach-base = 机器底座
panel-reach-budget = 时间
panel-reach-search = 搜索最佳位置
panel-reach-from = 从
panel-reach-to = 到
panel-reach-cells = 位置数
panel-reach-how = 当前位置周围 { $n } 个位置。余量是轴到其行程端点的最小距离。
panel-reach-too-many = { $n } 个位置；最多 { $max }。
panel-reach-judged = 已评估 { $done } / { $total } 个位置
panel-reach-refines = 正在细化并规划最佳位置
panel-reach-best = 最佳位置
panel-reach-margin = 余量
panel-reach-apply = 写入任务
panel-reach-is-best = 当前位置就是最佳位置。
panel-reach-none = 这些范围内没有可焊接且可规划的位置。
panel-reach-base-how = 底座在机器文件中移动：{ $key } = { $move } mm，转动 { $angle }°。
panel-reach-changed = 搜索后任务已更改：请重新搜索。
panel-reach-cut-off = 评估完成之前时间已到：目前的最佳位置。
panel-reach-failed = 在 { $place } 无法规划：{ $reason }
panel-reach-weldable = 已评估的 { $total } 个位置中有 { $n } 个可焊接。
panel-reach-map = x 和 y 方向的余量
panel-reach-legend = 数字：余量（百分比）。阴影线：不可焊接，并标出原因轴。○ 当前位置，★ 最佳位置。
panel-arm-from = 自 { $s } mm 起
panel-schedule-title = 批量计划
panel-schedule-jobs = 任务
panel-schedule-import = 导入表格
panel-schedule-import-how = CSV 或 TOML，每条焊缝一行：模板、更改的值以及可以焊接它的机器。数据文件夹 jobs/schedules 中的文件也会列出。
panel-schedule-none = 还没有表格。
panel-schedule-open = 打开
panel-schedule-delete = 删除该表格及其结果？
panel-schedule-replace = { $name } 已存在。替换吗？未更改的行保留其结果。
panel-schedule-run = 规划所有行
panel-schedule-go-on = 规划缺少的行
panel-schedule-post = 零件程序
panel-schedule-no-post = 无
panel-schedule-limit = 每个规划的时间限制
panel-schedule-progress = { $done } / { $total } 行
panel-schedule-kept = 其中 { $kept } 行此前已规划
panel-schedule-rate = { $rate } 行/分钟
panel-schedule-counting = 正在读取表格
panel-schedule-other = 正在规划 { $name }；一次只规划一个表格。
panel-schedule-failed = 上次运行提前结束：{ $why }
panel-schedule-planned = 已规划
panel-schedule-new = 未规划
panel-schedule-filter = 显示
panel-schedule-all = 全部
panel-schedule-of = { $n } / { $total } 行
panel-schedule-more = 另有 { $n } 行在结果文件中。
panel-schedule-row = 行
panel-schedule-name = 焊缝
panel-schedule-status = 结果
panel-schedule-machine = 机器
panel-schedule-count = 件数
panel-schedule-passes = 焊道
panel-schedule-time = 时间，分
panel-schedule-arc = 电弧，分
panel-schedule-wire = 焊丝，kg
panel-schedule-clearance = 间距，mm
panel-schedule-reason = 检查结果
panel-schedule-job = 作为任务打开
panel-schedule-parts-of = 各机器上的零件
panel-schedule-gantt-how = 阴影线：装夹。点按零件可显示其所在行。
panel-schedule-total = { $parts } 件 · 焊接 { $weld } 小时 · 最后一件在 { $end } 小时后
panel-schedule-export = 导出
panel-schedule-export-how = 所有行规划完成后写入文件。
panel-schedule-report = 报告
panel-schedule-waiting = 等待
panel-schedule-weldable = 可以焊接
panel-schedule-not-weldable = 不能焊接
panel-schedule-out-of-time = 超时
panel-schedule-invalid = 无效
panel-schedule-invalid-table = 表格有错误：{ $why }

# Teaching by camera.
panel-teach-by = 示教
panel-teach-by-hand = 手动
panel-teach-by-eye = 用相机
panel-teach-open = 启动相机
panel-teach-pause = 暂停
panel-teach-resume = 继续示教
panel-teach-stop = 停止示教
panel-teach-here-spot = 接缝在三维所选位置
panel-teach-here-begin = 接缝从程序起点开始
panel-teach-here-eye = 接缝在十字处
panel-teach-here-how = 在图像中点击接缝，在三维中选取，或将十字移到接缝上。随后机床移动。
panel-teach-end-here = 接缝到此结束
panel-teach-picture = 相机图像
panel-teach-no-picture = 尚无图像
panel-teach-way = 已走 { $done } / { $length } mm
panel-teach-confidence = 置信度
panel-teach-least = 最低值
panel-teach-frames = 帧数
panel-teach-step = 步长，mm
panel-teach-tack = 跨越间断至，mm
panel-teach-seed = 仿真种子
panel-teach-points = 示教点
panel-teach-tolerance = 公差，mm
panel-teach-method = 曲线
panel-teach-greedy = 直线和圆弧
panel-teach-fewest = 最少直线和圆弧
panel-teach-spline = 样条
panel-teach-make = 拟合曲线
panel-teach-made = 直线 { $lines }，圆弧 { $arcs }，样条段 { $splines }；{ $length } mm
panel-teach-error = 拟合误差
panel-teach-from-nominal = 接缝偏离程序：横向 / 高度
panel-teach-truth = 与真实接缝（仿真）

# Teach phase.
panel-teach-phase-closed = 相机未启动
panel-teach-phase-plans = 正在读取焊缝…
panel-teach-phase-places = 请指出接缝的起点。机床将会移动。
panel-teach-phase-runs = 沿接缝移动
panel-teach-phase-paused = 已暂停
panel-teach-phase-asks = 接缝丢失。请指出从哪里继续。
panel-teach-phase-ended = 已结束

# Teach pause.
panel-teach-pause-operator = 由操作员
panel-teach-pause-hand = 轴已点动
panel-teach-pause-control = 此页面失去控制权
panel-teach-pause-mode = 单元不在点动或示教模式

# Teach end.
panel-teach-end-closed = 回到起点
panel-teach-end-joint-end = 到达接缝末端
panel-teach-end-operator = 由操作员结束
panel-teach-end-lost = 接缝丢失
panel-teach-end-limit = 机床无法继续
panel-teach-end-too-long = 超过标称焊缝允许的长度
panel-teach-end-out-of-frames = 没有更多图像
panel-teach-end-stopped = 已停止
panel-teach-end-failed = 失败

# Teaching by hand.
panel-taught-title = 手动示教
panel-taught-record = 记录点
panel-taught-clear = 清空
panel-taught-back = 找回 { $n } 个点
panel-taught-of = 这些点是在 { $machine } 上记录的，不能用于本机床。请清除，或载入那台机床的程序。
panel-taught-remove = 删除点 { $point }
panel-taught-save = 存为程序
panel-taught-saved = 已保存：{ $file }。见“任务”。

panel-lies-misplaced = 偏移 2 mm 和 0.5°，波浪形，两处定位焊
panel-lies-half-ring = 偏移 2 mm 和 0.5°，失圆，一处定位焊

# Form of a job.
panel-form-add-what = 添加部分
panel-form-add = 添加
panel-form-add-key = 添加数值
panel-form-values = { $n } 个数值
panel-form-in-text = 在文本中显示
panel-form-remove = 移除
panel-form-kind = 接头形式
panel-form-procedure = 焊接工艺 (WPS)
panel-form-ships = 此工艺随程序提供。可更改您自己的副本。
panel-form-copy = 制作副本
panel-form-whose = 所有引用此文件的任务都按它检查。
panel-form-allowed = 允许：{ $allowed }
panel-form-no-number = 不是数字。保持 { $value }。
panel-form-keep = 保存工艺

# Limits of the speed.
panel-bound-title = 速度受限于
panel-bound-at-asked = { $share } % 的长度上保持编程速度。
panel-bound-everywhere = 机床极限：{ $speed } mm/s。
panel-bound-asked = 编程速度
panel-bound-speed = 速度
panel-bound-acceleration = 加速度
panel-bound-jerk = 加加速度
panel-bound-tip = 焊枪尖端
panel-bound-ends = 加速或减速
panel-bound-more = 报告中还有 { $n } 段。
panel-bound-used = 各轴限值及其使用量
panel-bound-of = ≤ { $limit } 的 { $share } %

# Cross-section.
panel-section-where = 焊缝位置
panel-section-dihedral = 两面夹角
panel-section-gap = 根部间隙
panel-section-mismatch = 错边
panel-section-area = 面积
panel-section-beads = 焊道
panel-section-bead = 焊道
panel-section-role = 类型
panel-section-no-beads = 未规划焊道：沿焊缝一道。
panel-section-none = 任务未描述接头。

# Part and fixtures.
panel-parts-add = 添加实体
panel-parts-add-go = 添加
panel-parts-shape = 形状
panel-parts-as = 用途
panel-parts-fixture = 夹具
panel-parts-part = 工件
panel-parts-part-why = 工件的实体会添加到由焊缝生成的工件上。
panel-parts-replaced = 由焊缝生成的工件已被替换（part.replace）：仅检查与以下实体的碰撞。
panel-parts-none = 任务没有自己的实体：工件由焊缝生成。
panel-parts-fixed = 请在文本中修改。
panel-parts-unnamed = 未命名
panel-parts-at = 位置
panel-parts-turn = 绕轴旋转
panel-parts-tip = 移到焊枪尖端

# Shapes.
panel-shape-box = 长方体
panel-shape-cylinder = 圆柱
panel-shape-sphere = 球
panel-shape-cone = 圆锥
panel-shape-capsule = 胶囊体
panel-shape-ellipsoid = 椭球
panel-shape-half-space = 半空间

# Size.
panel-size-size = 尺寸
panel-size-radius = 半径
panel-size-top-radius = 顶部半径
panel-size-length = 长度
panel-size-semi-axes = 半轴

# Placing the part by touching.
panel-touch-title = 触碰定位工件
panel-touch-how = 在“点动 · 示教”中用尖端触碰工件并记录至少 { $n } 个点，之后会在此列出。
panel-touch-other = 任务用于另一台机床。
panel-touch-method = 方法
panel-touch-radius = 测头半径，mm
panel-touch-on = 点 { $point } 位于
panel-touch-go = 计算位置
panel-touch-moved = 工件偏移
panel-touch-rms = 点偏差（均方根）
panel-touch-use = 写入任务

# Touch method.
panel-touch-method-best-fit = 两工件最佳拟合
panel-touch-method-plane-line-point = 面、线、点
panel-touch-method-three-points = 平面、原点、方向
panel-touch-method-chuck = 卡盘轴线：端面与圆周

# Features.
panel-feature-nozzle = 接管 / 第一工件
panel-feature-body = 壳体 / 第二工件
panel-feature-plane = 平面 z = 0
panel-feature-line = 面 y = 0
panel-feature-point = 面 x = 0
panel-feature-origin = 原点
panel-feature-direction = x 轴上的点
panel-feature-face = 端面 z = 0
panel-feature-round = 绕 z 的圆周

# Plan.
panel-plan-plans = 规划中…
panel-plan-cancelled = 规划已取消。
panel-plan-again = 重新规划
panel-plan-wrong = 任务有错误
panel-plan-good = 可以焊接
panel-plan-report = 规划报告
panel-plan-report-with-appendix = 带附录的报告
panel-plan-before = 任务有错误。这是更改之前的规划。
panel-plan-none = 没有规划（见检查结果）。显示的是任务本身的几何形状。
panel-plan-line = 第 { $line } 行
panel-plan-whole = 完整消息
panel-plan-bad = 按此程序无法焊接
panel-plan-time = 共 { $time } s

# Kinds of findings.
panel-finding-access = 焊枪空间不足
panel-finding-air = 空移受阻
panel-finding-attitude = 焊枪角度超差
panel-finding-bead = 焊道尺寸不符
panel-finding-blend = 拐角已过渡
panel-finding-clearance = 碰撞或间隙过小
panel-finding-cooling = 冷却时间超出范围
panel-finding-drive = 驱动器达到电流极限
panel-finding-hold = 轴无法保持在该处
panel-finding-interpass = 焊道之间的等待
panel-finding-jump = 轴须跳变
panel-finding-joint = 接头超出标准
panel-finding-least-speed = 低于工艺最低速度
panel-finding-oscillation = 摆动留有间隙
panel-finding-plausible = 数值不合理
panel-finding-pool = 焊道对该位置过大
panel-finding-preheat = 预热温度过低
panel-finding-path = 偏离焊缝
panel-finding-procedure = 超出 WPS 范围
panel-finding-range = 轴超出行程
panel-finding-reach = 无法到达
panel-finding-retract = 焊枪回退
panel-finding-ripple = 速度不均匀
panel-finding-singular = 接近奇异位形
panel-finding-speed = 达不到编程速度
panel-finding-stop = 焊枪中途停止
panel-finding-stopped = 焊接被停止
panel-finding-time = 耗时过长
panel-finding-turn = 焊枪在拐角处跳变
panel-finding-search = 搜索结束，未得到计划
panel-finding-unchecked = 未检查碰撞
panel-finding-unwind = 焊道之间轴回转复位

# Part programs.
panel-post-dialect = 数控系统
panel-post-make = 生成零件程序
panel-post-save = 下载
panel-post-old = 这是任务另一状态的程序：请重新生成。
panel-post-proof = 验证

# Table of points.
panel-points-point = 点
panel-points-along = 移动
panel-points-column = 列
panel-points-value = 数值
panel-points-insert = 在其后插入
panel-points-delete = 删除（{ $n }）
panel-points-set = 应用到 { $n } 个点
panel-points-split = 在此分割
panel-points-several = 多选
panel-points-reduce = 精简
panel-points-tolerance = 精简公差，mm
panel-points-way = 插补
panel-points-way-set = 设定插补（{ $n }）
panel-points-why-row = 请选择相连的点，不含起点。
panel-points-why-two = 圆弧需要两个点：经过第一点到第二点。
panel-points-why-place = 这些点没有圆弧所需的 x、y、z 位置。
panel-points-start = 起点

# Interpolation.
panel-along-line = 直线
panel-along-arc = 圆弧
panel-along-spline = 样条
panel-along-taught = 示教
panel-along-rapid = 快速
panel-along-cubic = 三次曲线

# Columns.
panel-column-n = 程序段
panel-column-time = 时间
panel-column-speed = 速度

# Signals of a record.
panel-trace-welded = 已焊长度
panel-trace-tip-s = 枪尖位置
panel-trace-path-error = 路径偏差
panel-trace-attitude-error = 姿态误差
panel-trace-process-state = 工艺状态
panel-trace-burning = 电弧或束流接通
panel-trace-steady = 匀速行进
panel-trace-power = 驱动供电
panel-trace-inputs = 输入（位）
panel-trace-true = 真实位置
panel-trace-deviation = 焊缝偏差
panel-trace-correction = 修正
panel-trace-miss = 相对接缝的偏差
panel-trace-rows = 曲线已抽稀为 { $samples } 个采样中的 { $shown } 个；保留峰值。
panel-trace-move = 方向键移动光标。

# Results.
panel-result-good = 合格
panel-result-deviating = 超差
panel-result-stopped = 已停止
panel-result-interrupted = 被中断
panel-result-running = 进行中

# Set-up.
panel-setup-machine = 机床
panel-setup-devices = 输入和输出
panel-setup-tuning = 整定
panel-setup-alarms = 报警目录
panel-setup-users = 用户
panel-setup-audit = 操作日志
panel-setup-backup = 下载备份
panel-setup-data = 备份
panel-setup-timing = 时间和设备
panel-setup-period = 周期
panel-setup-missed = 错过的周期
panel-setup-lost = 未记录的周期
panel-setup-age = 数据时龄
panel-setup-status-age = 状态时龄
panel-setup-answers = 响应时间（{ $devices }）：中位 / 最大
panel-setup-station = 操作站
panel-setup-sensors = 传感器
panel-setup-parameters = 轴与驱动器
panel-setup-tool = 工具
panel-setup-frames = 坐标系
panel-setup-pages = 设置页面
panel-setup-diagnostics = 诊断

# Backup.
panel-data-backup-how = 所有焊接、任务、用户和日志合为一个文件。不含加密连接的密钥。
panel-data-restore = 恢复
panel-data-restore-how = 用备份替换所有数据。先检查文件；确认前不作任何更改。现有数据保留在旁边的文件夹中。
panel-data-off = 请先将机床断电。
panel-data-file = 备份文件 (.tar)
panel-data-check = 上传并检查
panel-data-checks = 正在上传并检查 …
panel-data-whole = 备份完整：
panel-data-welds = 焊接
panel-data-newest = 最新焊接
panel-data-jobs = 任务
panel-data-users = 用户
panel-data-audit = 操作日志条目
panel-data-replace = 替换所有数据
panel-data-sure = 本单元的所有数据将被备份替换。面板将重新启动，所有人须以备份中的用户登录。
panel-data-begins = 面板正以恢复的数据重新启动。请稍后重新登录。

# Inputs and outputs.
panel-io-signal = 信号
panel-io-kind = 类型
panel-io-safe = 安全值
panel-io-place = 寄存器
panel-io-unit = 站号
panel-io-watchdog = { $time } s 后输出置安全值
panel-io-polls = 轮询
panel-io-missed = 跳过
panel-io-failed = 失败
panel-io-connections = 连接次数
panel-io-away = 断开
panel-io-round = 轮询：中位 / 99.9 % / 最大
panel-io-trouble = 最近故障：
panel-io-wants = 应为 { $state }

# Io name.
panel-io-name-gas = 气阀
panel-io-name-on = 电弧或束流开
panel-io-name-watchdog = 单元心跳
panel-io-name-ready = 电源就绪
panel-io-name-burning = 电弧或束流接通
panel-io-name-stuck = 焊丝或电极粘住
panel-io-name-fault = 电源故障（代码；0 为无）
panel-io-name-heartbeat = 设备心跳

# Io kind.
panel-io-kind-input = 输入
panel-io-kind-output = 输出
panel-io-kind-set = 设定值
panel-io-kind-report = 报告
panel-io-kind-actual = 实际值

# Tuning.
panel-tune-go = 整定并测量
panel-tune-waits = 测量中 …
panel-tune-how = 仿真驱动器上的位置环；不运动，也不更改任何设置。
panel-tune-assumed = 机床文件未描述驱动器：使用了假定的驱动器。
panel-tune-gain = 开环增益
panel-tune-phase = 开环相位
panel-tune-gain-margin = 增益裕度
panel-tune-phase-margin = 相位裕度
panel-tune-take = 保存这些设置

# Audit log.
panel-audit-command = 命令
panel-audit-values = 数值
panel-audit-newest = 最新的 { $n } 条；还有更早的。
panel-audit-whole = 共 { $n } 条
panel-audit-none = 没有包含该文本的条目。
panel-audit-older = 显示更早的
panel-audit-english = 搜索范围为条目的代码、名称和值。

# Axes.
panel-axis-current = 电流
panel-axis-range = 行程
panel-axis-max-speed = 最高速度
panel-axis-fault = 故障
panel-axis-limit = 限位开关
panel-axis-referenced = 已回零
panel-axis-home = 轴 { $axis } 回零
panel-axis-home-how = 将单个轴移到原点。参考点由全部轴一起寻找。

# Condition.
panel-condition-for = 用于
panel-condition-met = 满足
panel-condition-unmet = 不满足

# Level.
panel-level-power = 上电
panel-level-motion = 运动
panel-level-process = 焊接

# Users.
panel-user-role = 角色
panel-user-enabled = 允许登录
panel-user-password = 新密码（至少 10 个字符）
panel-user-own-password = 您自己的密码
panel-user-first-run = 尚未设置密码。请创建管理员帐户。
panel-user-deleted = 已删除：{ $user }。
panel-user-saved = 已保存：{ $user }。
panel-user-password-again = 再次输入新密码
panel-user-password-differs = 两次输入的密码不一致。
panel-user-new = 新用户
panel-user-edits = 更改用户 { $user }
panel-user-exists = 用户 { $user } 已存在。
panel-user-over = 要更改吗？角色：{ $role }，可登录：{ $enabled }。密码不变。
panel-user-over-password = 要更改吗？角色：{ $role }，可登录：{ $enabled }。密码改为新密码。
panel-user-change = 更改

# Parameters.
panel-par-how = 机床文件中的数值。整体检查后保存到 { $file }；旧文件保留在旁边。灰色 = 默认值。
panel-par-pending = 已保存，重新装入后生效：请将驱动器断电并重新装入任务。
panel-par-reload = 重新装入任务
panel-par-keep = 保存
panel-par-kept = 已保存到 { $file }
panel-par-wild = 改动较大 – 请确认：
panel-par-wrong = 不是数字：{ $value }
panel-par-no-drive = 机床文件没有描述该轴的驱动器。
panel-par-notches = 陷波滤波器
panel-par-notch = { $frequency } Hz，宽度 { $width } Hz，增益 { $gain }
panel-par-group-axis = 轴
panel-par-group-loop = 位置环与驱动器
panel-par-group-feedforward = 补偿
panel-par-group-mechanics = 机械与比例
panel-par-group-pose = 安装位置
panel-par-group-map = 像素到 mm
panel-par-group-timing = 时间与噪声
panel-par-home = 原位
panel-par-max-speed = 最大速度
panel-par-max-acceleration = 最大加速度
panel-par-max-jerk = 最大加加速度
panel-par-velocity-bandwidth = 速度环带宽
panel-par-kp = 比例增益 (kp)
panel-par-ki = 积分增益 (ki)
panel-par-kd = 微分增益 (kd)
panel-par-kvff = 速度前馈
panel-par-kaff = 加速度前馈
panel-par-limit = 力或转矩限制
panel-par-current-time-constant = 电流环时间常数
panel-par-current-delay = 电流延迟
panel-par-friction-compensation = 摩擦补偿
panel-par-friction-smoothing = … 平滑速度
panel-par-backlash-compensation = 反向间隙补偿
panel-par-backlash-time = … 补偿时间
panel-par-encoder-counts = 每单位编码器脉冲
panel-par-inertia = 运动质量或惯量
panel-par-peak = 峰值力或转矩
panel-par-friction = 摩擦
panel-par-viscous = 粘性摩擦
panel-par-resonance = 共振
panel-par-load-ratio = 负载与电机惯量比
panel-par-bandwidth = 位置环带宽
panel-par-measured-at = 测量速度
panel-par-following-counts = 跟随误差（编码器计数）
panel-par-load-error = 负载侧误差
panel-par-notch-at = 陷波滤波器频率

# TCP calibration.
panel-tool-title = 通过触碰一点确定尖端
panel-tool-how = 夹紧一个尖针。用尖端触碰并记录；倾斜或旋转焊枪后再次触碰：至少 { $n } 个方向，相差 20°。
panel-tool-head = 焊头
panel-tool-record = 记录此触碰
panel-tool-jog = 在点动或示教中记录触碰。
panel-tool-touch = 触碰 { $touch }
panel-tool-remove = 删除触碰 { $touch }
panel-tool-find = 计算 TCP
panel-tool-was = 当前 TCP
panel-tool-found = 找到的 TCP
panel-tool-deviation = 标准差
panel-tool-rms = 触碰偏差（均方根）
panel-tool-apart = 姿态差
panel-tool-keep = 保存此 TCP
panel-tool-verdict-good = 触碰一致，尖端在所有方向上确定。
panel-tool-verdict-unseen = 触碰一致，但未能在所有方向上确定尖端。
panel-tool-verdict-far = 尖端将移动超过 20 mm：是否始终是同一点？
panel-tool-verdict-poor = 触碰误差超过 0.5 mm：请重新触碰。
panel-tool-unseen = 沿 ({ $direction }) 未确定：保持原值。
panel-tool-old = 恢复当前 TCP

# Sensors.
panel-sensor-none = 该机床没有传感器。
panel-sensor-title = 用网格标定相机
panel-sensor-how = 将带深色点阵的标定板正对相机放在已知高度，须占画面一半以上。
panel-sensor-pitch = 点距，mm
panel-sensor-z = 标定板高度 (z)，mm
panel-sensor-file = 网格图像
panel-sensor-simulated = 仿真图像
panel-sensor-find = 求解标定
panel-sensor-picture = 图像与已识别的点
panel-sensor-residuals = 网线：标定结果。红线：各点偏差，放大 { $factor } 倍。
panel-sensor-dots = 点数
panel-sensor-off = 点偏差（均方根 / 最大）
panel-sensor-was = 当前
panel-sensor-found = 求得
panel-sensor-scale = 比例 x / y，mm/像素
panel-sensor-rotation = 旋转
panel-sensor-shear = 剪切
panel-sensor-barrel = 畸变（负：桶形）
panel-sensor-centre = 光轴位置（列，行）
panel-sensor-middle = 中心
panel-sensor-aligned = 标定板与传感器坐标轴平行：采用其旋转
panel-sensor-in-place = 替换 z = { $z } mm 平面
panel-sensor-new = 新增 z = { $z } mm 平面
panel-sensor-keep = 保存标定
panel-sensor-planes = 相机平面
panel-sensor-remove = 删除 z = { $z } mm 平面
panel-sensor-verdict-good = 图像与网格相符。
panel-sensor-move = 在连杆上的位置 x, y, z
panel-sensor-turn = 绕方向 x, y, z 旋转
panel-sensor-angle = …角度
panel-sensor-distance = 相机到原点距离
panel-sensor-laser-angle = 相机轴与激光面夹角
panel-sensor-focal = 焦距
panel-sensor-homography = 单应矩阵 h1 … h8
panel-sensor-origin = 原点（列，行）
panel-sensor-period = 帧间隔
panel-sensor-latency = 曝光到结果延时
panel-sensor-noise = 接缝位置噪声

# Paused dry run.
panel-pause-jog = 从此处点动
panel-pause-where = 空运行暂停于焊道 { $pass } 的 { $s } mm。点动并记录；然后按“规划返回”和“空运行”。
panel-pause-begin = 空运行在第一焊道之前暂停。点动并记录；然后按“规划返回”和“空运行”。
panel-pause-back = 规划返回
panel-pause-forget = 取消空运行

# Tour.
panel-tour-title = 您的第一次焊接
panel-tour-close = 跳过
panel-tour-control = 按右上角“取得控制权”：同时只有一个面板操作。
panel-tour-on = 按“上电”：驱动器得电。
panel-tour-home = 按“回零”：各轴寻找零点。
panel-tour-load = 打开“任务”并装入“第一条焊缝”。它会被规划和检查；不会运动。
panel-tour-again = 各轴已移动。按“从此处重新规划”：进近将从当前位置开始。
panel-tour-dry = 空运行：同样的路径，不起弧。等它结束；右下角的 STOP 立即停止。
panel-tour-jog = 点动中。各轴到位后按“结束点动”。
panel-tour-fault = 故障。下方报警说明怎么办：确认后按“复位故障”。
panel-tour-arm = 按“允许起弧”：一分钟内允许启动一次。“为什么不能启动？”会说明还缺什么。
panel-tour-weld = 按“开始焊接”。STOP 始终在右下角。
panel-tour-watch = 观察焊枪。试试暂停和继续（需重新允许），以及三维视图。
panel-tour-hold = 已暂停，电弧已关。再按“允许起弧”，然后按“继续”。
panel-tour-left = 焊接中断。按左侧“从焊道…继续”：带搭接从该处继续。
panel-tour-record = 完成。打开“记录”：每次焊接都保存在那里。
panel-tour-end = 完成。下一步：任务 > 由模板新建。

# Kinds of refusals.
panel-trouble-login = 请重新登录
panel-trouble-password = 已拒绝
panel-trouble-role = 您的角色不允许
panel-trouble-origin = 页面地址不被允许
panel-trouble-token = 会话无效：请刷新页面
panel-trouble-size = 过大
panel-trouble-input = 输入错误
panel-trouble-not-found = 未找到
panel-trouble-busy = 现在不行
panel-trouble-other = 该处已有另一文本
panel-trouble-exists = 已存在
panel-trouble-slow-down = 请求过多：请稍候
panel-trouble-server = 服务器故障
panel-trouble-lost = 与单元无连接
panel-trouble-archive = 这不是完整的 Seamwright 备份
panel-trouble-archive-newer = 备份来自更新版本的 Seamwright
panel-trouble-archive-room = 磁盘空间不足

# Allowed values.
panel-allowed-not-negative = 数值，0 或更大
panel-allowed-positive = 大于 0 的数
panel-allowed-up-to = 大于 0，至 { $max }

# Actions that roles allow.
panel-action-take-control = 取得控制权
panel-action-watch = 查看
panel-action-jobs-read = 读取任务
panel-action-jobs-write = 更改任务
panel-action-plan = 规划
panel-action-edit = 编辑
panel-action-post = 生成加工程序
panel-action-load = 装入
panel-action-records-read = 读取记录
panel-action-tune = 整定
panel-action-set-up = 设置
panel-action-shelve = 搁置报警
panel-action-audit = 审计日志
panel-action-audit-read = 读取审计日志
panel-action-backup = 下载备份
panel-action-restore = 恢复
panel-action-users-read = 查看用户
panel-action-users-write = 更改用户
panel-action-diagnose = 查看诊断
panel-action-jog = 点动
panel-action-teach = 示教

# Diagnostics.
panel-diag-state = 状态
panel-diag-ready = 单元可以使用。
panel-diag-version = 版本
panel-diag-uptime = 已运行（分:秒）
panel-diag-latency = 控制周期的延迟
panel-diag-latency-how = 服务器启动以来的周期，按开始的延迟分类。高度为对数刻度。
panel-diag-most = 最大
panel-diag-gap = 最长间隔
panel-diag-cycles = 周期数
panel-diag-rights = 实时权限
panel-diag-granted = 已授予
panel-diag-missing = 缺少
panel-diag-right-priority = 实时优先级
panel-diag-right-memory = 锁定内存
panel-diag-right-cpu = 独占 CPU
panel-diag-grant-priority = 优先级：在服务中设置 LimitRTPRIO=80，或在 /etc/security/limits.conf 中将 rtprio 设为 80，然后重新启动。
panel-diag-grant-memory = 内存：在服务中设置 LimitMEMLOCK=infinity，或在 /etc/security/limits.conf 中将 memlock 设为 unlimited，然后重新启动。
panel-diag-grant-cpu = CPU：选择存在且允许使用的 CPU，然后重新启动。
panel-diag-devices = 设备报告的时间
panel-diag-devices-how = 各设备详情见“输入和输出”。
panel-diag-device-latency = 延迟
panel-diag-disk = 磁盘和内存
panel-diag-free = 可用 / 总量
panel-diag-write = 一次小的写入
panel-diag-look = 上次检查距今
panel-diag-resident = 面板内存
panel-diag-cell-resident = 单元内存
panel-diag-locked = 其中锁定
panel-diag-queues = 队列
panel-diag-waiting = 等待
panel-diag-room = 容量
panel-diag-queue-cycles = 周期
panel-diag-queue-notes = 事件
panel-diag-queue-commands = 命令
panel-diag-queue-audit = 操作日志
panel-diag-alarms = 按优先级的报警
panel-diag-priority = 优先级
panel-diag-active = 活动
panel-diag-unacknowledged = 未确认
panel-priority-critical = 紧急
panel-priority-high = 高
panel-priority-medium = 中
panel-priority-low = 低
panel-diag-workers = 规划进程
panel-diag-runs = 已运行
panel-question-draft = 草图
panel-question-plan = 规划
panel-question-recorded = 记录的规划
panel-question-report = 报告
panel-question-post = 零件程序
panel-question-load = 装入
panel-question-place = 工件偏置
panel-question-reach = 搜索最佳位置
panel-question-schedule = 批量计划
panel-worker-answered = 已回答
panel-worker-refused = 任务有错误
panel-worker-superseded = 因新请求而终止
panel-worker-late = 终止：时间过长
panel-worker-memory = 终止：内存过多
panel-worker-failed = 失败
panel-diag-since = 服务器启动以来
panel-diag-welds = 焊接
panel-diag-clients = 连接 / 页面 / 会话
panel-diag-logins = 登录 / 拒绝
panel-diag-answers = 按 HTTP 状态的回答
