# Modes.
cell-mode-off = 断电
cell-mode-idle = 未回零
cell-mode-homing = 回零中
cell-mode-ready = 就绪
cell-mode-jog = 点动
cell-mode-teach = 示教
cell-mode-dry-run = 空运行
cell-mode-weld = 焊接
cell-mode-hold = 暂停
cell-mode-fault = 故障

# Events that change the mode.
cell-trigger-switch-on = 上电
cell-trigger-switch-off = 断电
cell-trigger-home = 回零
cell-trigger-homed = 回零完成
cell-trigger-jog = 点动
cell-trigger-teach = 示教
cell-trigger-dry-run = 空运行
cell-trigger-weld = 焊接
cell-trigger-hold = 暂停
cell-trigger-finish = 完成
cell-trigger-abort = 中止
cell-trigger-trip = 故障跳闸
cell-trigger-reset = 复位
cell-refused = 在“{ $mode }”状态下不能“{ $event }”：允许的状态：{ $modes }

# Commands.
cell-ask-switch-on = 上电
cell-ask-switch-off = 断电
cell-ask-home = 回零
cell-ask-home-axis = 单轴回零
cell-ask-start-jog = 开始点动
cell-ask-start-teach = 开始示教
cell-ask-jog = 点动
cell-ask-start-dry-run = 开始空运行
cell-ask-arm = 允许起弧
cell-ask-start-weld = 开始焊接
cell-ask-hold = 暂停
cell-ask-resume = 继续
cell-ask-reverse = 后退
cell-ask-stop = 停止
cell-ask-override = 倍率 { $override }
cell-ask-reset = 复位故障
cell-ask-acknowledge = 确认全部报警
cell-ask-acknowledge-one = 确认一个报警
cell-ask-why = 为何不能
cell-ask-load = 装入程序
cell-ask-quit = 退出

# Missing permissives.
cell-missing-rest = 各轴尚未停稳：请稍候
cell-missing-references = { $axes } 的零点未知：请先回零
cell-missing-homes-first = 按机床文件，轴 { $axis } 须先回零
cell-missing-power = 驱动器尚未得电：请稍候
cell-missing-answer = { $device }无应答：请检查电缆和设备
cell-missing-interlock = 联锁“{ $interlock }”不满足
cell-missing-acknowledgement = 报警“{ $alarm }”：{ $action }，然后确认
cell-missing-arming = 未允许起弧：请先允许，并在一分钟内启动
cell-missing-source = 焊接电源未就绪
cell-missing-start = 轴 { $axis } 不在接近路径的起点
cell-missing-program = 未装入程序
cell-missing-value = 数值超出允许范围
cell-missing-motion = 现在无法这样运动
cell-device-drives = 驱动器
cell-device-inputs = 输入
cell-device-source = 焊接电源

# Events and notes of a weld.
cell-event-mode = { $from } → { $to }
cell-event-missed = 错过 { $n } 个周期，最长连续 { $gap }
cell-event-pass-ends = 焊道 { $pass } 在 { $at } 处结束
cell-event-pass-left = 焊道 { $pass } 中断，已焊至 { $at }
cell-event-without-rights = 没有实时权限：{ $rights }
cell-right-priority = 优先级
cell-right-memory = 锁定内存
cell-right-cpu = 处理器
cell-note-stopped = 停止原因：{ $cause }
cell-note-left = 在焊道 { $pass } 中断，已焊至 { $at }
cell-note-not-finished = 未焊至终点
cell-note-nothing-welded = 什么都没有焊
cell-shutdown-signal = 信号 { $signal }
cell-shutdown-panic = 程序缺陷（panic）
cell-shutdown-end = 程序结束
cell-shutdown-cycle-stopped = 周期停止且未恢复

# Real-time rights.
cell-realtime-granted = 实时优先级，内存已锁定
cell-realtime-degraded = 受限：{ $missing }
cell-realtime-no-priority = 无实时优先级（{ $why }；用 `ulimit -r` 或 CAP_SYS_NICE 授权）
cell-realtime-memory-not-locked = 内存未锁定（{ $why }；用 `ulimit -l` 或 CAP_IPC_LOCK 授权）
cell-realtime-no-cpu = 不在所要求的处理器上（{ $why }）
cell-no-such-cpu = 处理器 { $cpu } 不存在
cell-only-on-linux = 仅限 Linux
cell-cycle-failed = 周期失败（程序缺陷）；已命令设备关闭

# A cell that cannot run.
cell-invalid-drive = 轴 { $axis } 的驱动器：{ $why }
cell-too-many-process-values =
    程序有 { $n } 个工艺参数
       允许：不超过 { $max }
cell-no-stepper = 该轴没有步进电机
cell-microsteps-too-coarse = 驱动器的最细微步达不到分辨率

# Tracking.
cell-no-cross-slide = 机床 { $machine } 的焊头 { $head } 没有十字滑台：即两个自有的直线轴
cell-no-stripe-sensor = 机床 { $machine } 的焊头 { $head } 没有激光条纹传感器：跟踪需要在焊枪前方有一个；允许在机床文件中写 [sensors.<name>]，kind = "stripe"
cell-sensor-not-leading = { $machine } 的传感器 { $sensor } 在本焊道上不能稳定地引导焊头 { $head }：其前视距离在 { $min } 至 { $max } 间变化；允许变化不超过十分之一，如随焊缝转动的传感器
cell-off-line-two-torches = 焊道 `{ $pass }` 有两把焊枪摆动：仅当焊枪沿焊缝线行走时才能仿真移位的工件；允许无过渡圆角、至多一把焊枪摆动的焊道，或不用偏差文件
cell-off-line-beam = 焊道 `{ $pass }` 有束流摆动：仅当束流沿焊缝线行走时才能仿真移位的工件；允许无过渡圆角、无摆动的焊道，或不用偏差文件
cell-off-line-blends = 焊道 `{ $pass }` 有过渡圆角：仅当焊枪沿焊缝线行走时才能仿真移位的工件；允许无过渡圆角、至多一把焊枪摆动的焊道，或不用偏差文件
cell-slides-aside = 机床 { $machine } 焊头 { $head } 的十字滑台不能把焊枪移向此焊缝的各侧；允许两个 [[heads.steps]]，其 `move` 横跨焊缝且方向不同
cell-no-beam-camera = 机床 { $machine } 没有沿束流观察的相机；允许在机床文件中写 [sensors.<name>]，kind = "camera"
cell-no-replay = 机床 { $machine } 不能重放存储的偏差：它没有可偏转的束流；允许文件中有 torch.deflection 的机床
cell-gun-not-carried = 各轴无法把电子枪移向侧面：{ $why }
cell-alarm-with-cause = { $alarm }：{ $cause }
cell-alarm-of-head = { $alarm }，焊头 { $head }
cell-joint-not-seen = 焊前未看到接缝
cell-sighting-cut-short = 观察起点的移动被缩短
cell-sighting-length = { $wanted } 中的 { $clear }，{ $why }
cell-end-of-reach = 各轴已达行程极限
cell-too-close = { $a } 与 { $b } 过近
cell-something-too-close = 有两个物体过近

# Distortion file.
cell-empty-range = 空区间：{ $from } 至 { $to }
cell-allowed-range = `to` 大于 `from`
cell-no-head = 没有这个焊头
cell-allowed-heads = 1 或 2
cell-empty-displacement = 位移为空
cell-turn-missing = 缺少该角度的转轴
cell-allowed-turn = turn = [x, y, z]，即转轴

# Teaching.
cell-camera-out-of-reach = 各轴无法把相机带到该处：还差 { $remaining }
cell-no-points = 没有点；请至少给出接缝上的一个点
cell-point-off-seam = 点 { $point } 距标称焊缝超过 { $max }
cell-points-coincide = 点 { $first } 与 { $second } 在焊缝的同一位置

# Frames of cameras.
cell-frame-io = { $what }：{ $why }
cell-frames-missing =
    { $what }：{ $why }
       允许：含有 frames.csv 的现有帧文件夹
cell-frame-list =
    { $file }:{ $line }：{ $why }
       允许：{ $allowed }
cell-frame-header =
    帧 { $frame }：{ $field }无效：{ $found }
       允许：{ $allowed }
cell-frame-magic = 起始字节
cell-frame-version = 版本
cell-frame-depth = 像素深度
cell-frame-width = 宽度
cell-frame-height = 高度
cell-frame-axes = 轴数
cell-frame-reserved = 字节 18 至 23
cell-frame-work-height = 工件高度
cell-frame-position = 轴位置
cell-frame-depth-allowed = 每像素 8 或 16 位
cell-frame-position-allowed = 有限的毫米数或度数
cell-frame-work-height-allowed = 有限的毫米数，或 NaN
cell-frame-machine-axes = { $n }，即机床的轴数
cell-frame-header-truncated = 帧 { $frame }：数据流在文件头 { $wanted } 中的 { $found } 处结束
cell-frame-axes-truncated = 帧 { $frame }：数据流在轴位置 { $wanted } 中的 { $found } 处结束
cell-frame-pixels-truncated = 帧 { $frame }：数据流在像素 { $wanted } 中的 { $found } 处结束
cell-frame-time = 帧 { $frame }：时间 { $time } 无效；时间须为有限值且递增
cell-frame-time-order = 帧 { $frame }：在 { $before } 的帧之后，时间 { $time } 无效；时间须为有限值且递增
cell-frame-shape = 帧 { $frame }：{ $why }
cell-frame-late = 帧 { $frame } 未及时到达
cell-frame-size = 帧为 { $size } 像素；允许：传感器的 size_px，{ $allowed }
cell-camera-closed = 相机已关闭连接
cell-no-frame-in-time = 没有帧及时到达
cell-image-format = 未知的图像格式；允许：PNG、JPEG、PNM
cell-image-broken = 图像无法读取：{ $why }
cell-jpeg-truncated = JPEG 文件在图像结束前中断
cell-pixel-count = 像素数与图像不符
cell-file-too-large = 文件为 { $size }；允许不超过 { $max }
cell-list-no-text = 不是文本文件
cell-list-columns = 列为 { $columns }
cell-list-columns-allowed = { $columns }，可选 { $optional }
cell-list-cells = { $n } 个单元格
cell-list-cells-allowed = { $n } 个，每列一个
cell-list-file = 无效文件名 "{ $name }"
cell-list-file-allowed = 此文件夹中图像的名称
cell-list-number = { $column }："{ $value }" 不是数
cell-list-time = t_s：{ $time } 不在上一行的 { $before } 之后
cell-list-time-allowed = 递增的时间
cell-list-empty = 列表中没有帧
cell-list-empty-allowed = 每帧一行

# Devices on Modbus.
cell-modbus-unreachable = 设备 `{ $device }`（{ $address }）：{ $why }
cell-modbus-no-register = 设备 `{ $device }` 没有设定任务工艺参数 `{ $value }` 的寄存器
cell-modbus-refused = 设备拒绝 { $what }（{ $code }）
cell-modbus-registers = { $table } { $from } 至 { $to }
cell-modbus-named = { $registers }：{ $names }
cell-modbus-cells = { $table } { $at }：请求 { $asked } 个单元，收到 { $answered } 个
cell-modbus-no-connection = { $time } 内未能连接
cell-modbus-no-answer = { $time } 内无应答
cell-modbus-no-heartbeat = { $time } 无心跳信号
cell-modbus-closed = 连接已关闭
cell-modbus-not-connected = 未连接
cell-modbus-second-connection = { $why }，发生在第二个连接上；若设备只接受一个连接：connections = 1

# LinuxCNC's HAL.
cell-hal-not-installed =
    未安装 LinuxCNC：缺少程序 `{ $program }`
       允许：Debian 软件包 linuxcnc-uspace（apt install linuxcnc-uspace）
cell-hal-running =
    LinuxCNC 的 HAL 已在运行：{ $owner }
       允许：同时只能一个；结束另一个，或用 `halrun -U` 清除
cell-hal-of-seamwright = 属于 Seamwright，进程 { $process }
cell-hal-foreign = 属于其他程序
cell-hal-refused = LinuxCNC 拒绝 { $file }：{ $why }
cell-hal-own-commands = 我们自己的命令
cell-hal-too-slow = 耗时超过 { $time }；{ $said }
cell-hal-no-start = LinuxCNC 的 HAL 无法启动：{ $why }
cell-hal-no-samples = LinuxCNC 的 HAL 未运行，没有采样：{ $why }
cell-hal-output = { $sampler }；{ $keeper }
cell-hal-no-output = 无输出
cell-hal-not-run = LinuxCNC 的 HAL 无法运行：{ $why }
cell-hal-refuses-root = HAL 拒绝 root，且没有用户 `nobody`；请以其他用户运行
cell-hal-no-pipes = 其数据流没有管道
cell-hal-program-ended = { $program } 已结束
cell-hal-no-data = 其实时程序没有发送数据
cell-hal-ended = LinuxCNC 的 HAL 已结束：{ $why }；正在无电状态下重启
cell-hal-runs-again = LinuxCNC 的 HAL 已恢复运行：确认、复位、上电、回零
cell-hal-retried =
    { $error }
       每 { $time } 重试

# Fault injection.
cell-fault-form = 无效的故障；允许 DEVICE:KIND@TIME[+DURATION]，如 drives:silent@12.5 或 inputs:disconnect@3+0.5
cell-fault-no-device = 设备 `{ $name }` 不存在；允许 { $names }
cell-fault-no-kind = 故障 `{ $name }` 不存在；允许 { $names }
cell-fault-no-time = 无效时间 `{ $text }`；允许不小于 0 的秒数
cell-fault-injection-summary = { $all } 个用例中 { $kept } 个按要求结束（{ $faults } 个进入故障）；最多 { $cycles } 个周期后关闭焊接过程；最长停止距离 { $stop }，最多为其上限的 { $bound }
cell-violation = { $time }：{ $what }
cell-violation-no-restart = 工作单元无法再次上电
cell-violation-no-rest = 各轴未停稳
cell-violation-process-on = 在“{ $mode }”状态下焊接过程仍开启
cell-violation-process-after-alarm = 报警后焊接过程仍开启
cell-violation-stop = 停止距离为 { $length }；允许 { $max }
cell-violation-jump = 轴 { $axis }：设定值与实际位置相差 { $distance }
cell-violation-limits = 轴 { $axis }：速度 { $speed }、加速度 { $acceleration } 超限
cell-program-damaged = 程序在传送中损坏：{ $why }
cell-program-changed = { $job } 或其引用的文件在规划后已更改：请重新加载
cell-program-panicked = 单元的一个线程因程序错误而结束
cell-socket = 无法在 { $folder } 中建立套接字：{ $why }
cell-already-runs = 已有单元在运行，其套接字位于 { $folder }
cell-no-process = 无法启动单元进程：{ $why }
cell-process-ended-early = 单元进程未报告即结束
cell-process-silent = 单元进程无响应，已被终止
cell-process-signal = 其进程被信号 { $signal } 终止
cell-process-code = 其进程以代码 { $code } 结束
cell-safe-not-asked = 未曾询问
cell-outputs-unconfirmed = 设备 { $device }：其输出未确认处于安全状态：{ $why }
cell-record-not-saved = 焊接 { $weld } 的最后几行未及时写入
cell-does-not-end = 循环无法结束：请检查电弧、气体和驱动是否已关闭
cell-program-too-large = 规划的运动为 { $size }，超过单元可接受的 { $max }

# 接收设定点的机器人控制器。
cell-robot-unusable = 设备 `{ $device }`（{ $protocol }），地址 { $address }：{ $why }
cell-robot-lost = 无连接：{ $why }
cell-robot-port-in-use = 另一个程序正在监听此端口
cell-robot-not-listening = 本机无法在该地址监听：{ $why }
cell-robot-no-reports = 控制器没有发送任何数据；请启动控制器上的程序并检查其目标地址
cell-robot-closed = 控制器关闭了连接
cell-robot-malformed = 控制器发送的字节不是本协议的消息
cell-robot-version = 控制器拒绝 RTDE 第 2 版
cell-robot-unknown-fields = 控制器不认识 { $fields }
cell-robot-fields-in-use = 另一个程序正在使用 { $fields }
cell-robot-not-started = 控制器没有开始发送报告
cell-robot-joints = 控制器报告 { $reported } 个关节，机床文件需要 { $needed } 个
cell-robot-not-stopped = 机器人没有确认停止
cell-robot-motors-off = 机器人电机已关闭
cell-robot-protective-stop = 机器人保护性停止
cell-robot-safeguard-stop = 机器人防护装置停止
cell-robot-emergency-stop = 机器人急停
cell-robot-safety-fault = 机器人安全系统报告故障
cell-robot-program-stopped = 机器人控制器上的程序没有运行
cell-robot-other-program = 机器人控制器上运行的是另一个程序
cell-robot-control-error = 机器人控制器的运动接口报告错误
cell-robot-starved = 机器人缺少设定点
cell-robot-jump = 设定点离机器人当前位置太远
cell-robot-disconnected = 与机器人的连接已断开
