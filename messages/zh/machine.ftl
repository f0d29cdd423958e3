# Steps and axes of the machine file.
machine-step-neither = 该步骤既不是轴，也不是固定位移
machine-step-kinds = `axis` 及其各键，或单独的 `fixed`
machine-step-fixed-axis = 该步骤同时有 `axis` 和 `fixed`
machine-step-fixed-apart = `fixed` 单独作为一个步骤
machine-axis-name-invalid = 轴名含有无效字符
machine-plain-letters = 小写字母、数字和 _
machine-axis-name-reserved = 该名称已保留给表格的另一列
machine-axis-turn-or-move = 轴要么旋转，要么直线移动
machine-turn-or-move = `turn` 和 `move` 中恰好一个
machine-axis-key-of-rotary = 直线轴没有此键
machine-only-with-turn = 仅与 `turn` 一起
machine-axis-lacks-key = 轴 `{ $axis }` 缺少 `{ $key }`
machine-key-positive = { $key } = 大于 0 的数
machine-home-outside-range = 原点位置超出行程
machine-letter-invalid = 不是轴字母
machine-linear-axis-in-mm = 直线轴以 mm 为单位
machine-rotary-axis-in-degrees = 旋转轴以度为单位
machine-range-of-continuous = 连续旋转轴没有行程范围
machine-continuous-or-range = `continuous` 或一个范围
machine-range-missing = 轴没有行程范围
machine-range-form = { $key } = [最小值, 最大值]
machine-range-form-or-continuous = { $key } = [最小值, 最大值]，或 continuous = true
machine-range-empty = 范围为空
machine-axis-name-taken = 另一个轴已有此名称
machine-axis-letter-taken = 另一个轴已有此字母
machine-own-letter = 自己的字母
machine-axes-count = 机床有 { $n } 个轴
machine-axes-allowed = [[tool]] 和 [[work]] 中共 1 至 { $max } 个轴
machine-home-order-twice = 该轴已在列表中
machine-each-axis-once = 每个轴一次

# Torch and heads.
machine-torch-and-heads = 机床同时有 `[torch]` 和 `[[heads]]`
machine-torch-or-heads = 一个焊头用 `[torch]`，两个用 `[[heads]]`
machine-torch-missing = 机床没有焊枪
machine-torch-form = 带 `direction` 的 `[torch]`，或两个 `[[heads]]`
machine-heads-many = 机床有 { $n } 个焊头
machine-head-without-steps = 焊头 `{ $head }` 没有自己的步骤：没有轴承载它
machine-head-steps = 每个焊头都有 `[[heads.steps]]`
machine-head-name-taken = 某个轴、另一个焊头或坐标系已有此名称
machine-frame-name = 名为“{ $name }”的用户坐标系
machine-frame-name-allowed = 最多 { $max } 个字符，不能是 { $names }

# Outputs and controls.
machine-output-taken = `{ $name }` 已占用此输出
machine-own-output = 自己的输出
machine-address-invalid = 地址无效
machine-address-form = 除 G 和 N 外的大写字母，后接大写字母、数字和 _，如 X 或 CW
machine-address-taken = 另一个轴或工艺量已有此地址
machine-own-address = 自己的地址
machine-code-invalid = G 代码或 M 代码无效
machine-code-form = G 或 M 加数字，如 M54
machine-event-invalid = 事件名称无效
machine-event-names = { $names }，或由小写字母、数字和 _ 组成的自己的名称
machine-kinematics-output = 只有 LinuxCNC 通过输出切换运动学

# Drives.
machine-drive-of-linear = 直线轴的驱动器用质量和力，长度以 mm 为单位
machine-drive-of-rotary = 旋转轴的驱动器用转动惯量和转矩，角度以度为单位
machine-drive-key-missing = 驱动器缺少一个键
machine-drive-limit-range = 限值不在摩擦与峰值之间
machine-drive-without-resonance = 没有谐振时，电机和负载是一个质量
machine-drive-resonance-alone = 谐振需要负载与电机的惯量比
machine-together-with = 与 `{ $key }` 一起
machine-fraction-too-large = 比例大于 1
machine-notches-many = 位置环的陷波滤波器过多
machine-notch-too-high = { $frequency } 不低于采样频率的一半
machine-notch-depth = 中心增益大于 1
machine-friction-smoothing-alone = 没有摩擦补偿
machine-backlash-time-alone = 没有反向间隙补偿

# Steppers and their pulses.
machine-full-steps = 两相电机的转子每个齿有 4 个整步
machine-multiple-of-4 = 4 的倍数，通常为 200
machine-microsteps-invalid = 驱动器的细分设置无效
machine-microsteps-allowed = 1 至 { $max } 的整数，递增，至少一个
machine-pulse-time = 高低电平各 { $time } 的脉冲对此频率过长
machine-stepper-lacks-key = 步进电机缺少 `{ $key }`
machine-motor-key-missing = 电机缺少一个键
machine-motor-keys = rotor_inertia_kg_m2、torque_rpm 和 torque_n_m 一起给出，或三者都不给
machine-torque-lengths = 转速：{ $speeds } 个，转矩：{ $torques } 个
machine-torque-equal-lengths = 转矩与转速数目相同，至少 2 个
machine-torque-speeds = 转矩曲线未从静止开始并按转速递增
machine-zero-then-increasing = 首个为 0，然后递增
machine-torque-holding = 电机没有保持转矩
machine-torque-first = 首个为大于 0 的保持转矩
machine-stepper-missing = 轴 `{ $axis }` 没有接收脉冲的步进电机
machine-stepper-or-other-drives = [drives.{ $axis }.stepper]，或不用 `steps` 的驱动
machine-resolution-too-fine = 驱动器最细的设置也达不到此分辨率
machine-pulse-rate = 轴 `{ $axis }` 在最高速度（{ $speed }，细分 { $microsteps }）需要 { $needed } 的脉冲；驱动器最高接受 { $possible }
machine-pulse-rate-allowed = 最高速度不超过 { $speed }、更粗的 `{ $resolution }`，或更快的驱动器（max_pulse_hz、min_pulse_us）
machine-pulses-after-reversal = 反向后 { $n } 个脉冲在周期内放不下
machine-direction-times-allowed = direction_setup_us 与 direction_hold_us 之和不超过 { $time }
machine-tick = 定时器的节拍为 { $tick }
machine-tick-allowed = 10 至 100000 ns，且周期 { $period } 是其整数倍
machine-stream-file = `{ $file }` 不是 VCD 文件
machine-stream-file-allowed = 以 .vcd 结尾的文件路径，或不写 `stream`

# Pitch errors.
machine-pitch-in-mm = 轴 `{ $axis }` 的螺距误差表以 mm 为单位
machine-pitch-in-degrees = 轴 `{ $axis }` 的螺距误差表以度为单位
machine-pitch-keys = { $positions } 和 { $errors }，两个等长的列表
machine-pitch-lengths = 位置：{ $positions } 个，误差：{ $errors } 个
machine-pitch-equal-lengths = 误差与位置数目相同，至少 2 个
machine-pitch-positions = 螺距误差表的位置无效
machine-increasing-positions = 递增的位置
machine-increasing-within-a-turn = 一圈以内递增的位置
machine-pitch-steep = 误差随位移的变化率为 { $slope }：对螺距误差而言过陡

# Sensors.
machine-image-width = 图像宽度无效
machine-image-height = 图像高度无效
machine-image-size = 1 至 { $max } 列和行
machine-frames-of-stripe = 线激光传感器没有图像流
machine-frames-invalid = 图像源无效
machine-frames-form = 相机用："tcp://HOST:PORT"
machine-stripe-map-missing = 线激光传感器需要 `map`：从像素到 mm
machine-stripe-maps = `map.camera`、`map.homography` 或 `map.scale`
machine-camera-angle = 相机看不到接缝
machine-map-of-camera = 此映射用于相机
machine-map-singular = 不同的像素会有相同的位置
machine-map-invertible = 可逆映射的数值
machine-map-horizon = 像素 ({ $column }, { $row }) 在地平线之外：看不到激光平面上的任何点
machine-map-every-pixel = 使图像中每个像素都有位置的映射
machine-camera-map-missing = 相机需要 `map.heights`
machine-heights-order = z 未逐行递增
machine-more-than-before = 大于上一行
machine-heights-rows = 同一相机的行，至少一行

# Shapes and zones.
machine-zone-watches-nothing = `{ $link }` 没有形体：区域将不监视任何物体
machine-shapes-first = 带 [[shapes.{ $link }]] 的连杆
machine-zone-empty = 区域没有体积
machine-zone-solids = 至少一个 [[zones.solids]]
machine-zone-shape = 允许区不能是此形状
machine-part = 工件
machine-fixtures = 夹具
machine-solid-of-part = { $name }（工件）
machine-solid-of-fixtures = { $name }（夹具）
machine-forbidden-zone = 禁区 { $zone }
machine-permitted-zone = 允许区 { $zone }

# Interlocks.
machine-interlocks-many = 机床有 { $n } 个联锁
machine-interlock-name-empty = 名称为空
machine-interlock-input-empty = 输入没有名称
machine-a-name = 一个名称
machine-interlock-name-taken = 另一个联锁已有此名称
machine-interlocks-contradict = `{ $first }` 要求输入 { $input } 为 { $first_value }，`{ $second }` 要求其为 { $second_value }：什么都无法运行
machine-value-or-other-input = { $value }，或另一个输入
machine-input-taken = `{ $interlock }` 已在监视输入 { $input }
machine-one-interlock-an-input = 每个输入一个联锁：for = "{ $level }" 更强

# Devices.
machine-out-of-range = 数值超出范围
machine-unit-reserved = 此单元地址已保留
machine-unit-allowed = 0 至 247，或 255
machine-device-without-registers = 设备没有寄存器
machine-device-without-role = 该设备既不是焊接电源，也没有输入
machine-device-roles = 用于输入的寄存器，或用于 outputs.on 和 reports.burning 的寄存器
machine-host-missing = 没有主机
machine-port-missing = 没有 1 至 65535 的端口
machine-host-and-port = 主机:端口，如 192.168.1.20:502 或 [fe80::1]:502
machine-fault-code-type = 故障代码是普通的 u16
machine-exactly-one-of = { $names } 中恰好一个
machine-register-tables = 未恰好指定一个表
machine-register-read-only = `{ $table }` 只能读取，而此处要写入
machine-register-single-bit = `{ $table }` 是单个位
machine-bit-with-register = `bit` 与 holding 或 input 一起
machine-register-bits = 寄存器有 16 位
machine-bit-allowed = 0（最低位）至 15
machine-bit-form = bit = 0（最低位）至 15
machine-safe-of-input = 只有输出有安全状态
machine-safe-with-outputs = `safe` 与 gas、on 和 set 一起
machine-safe-state-on = 电弧或束流的安全状态是关闭
machine-words-of-16-bits = 16 位是一个寄存器
machine-words-with-32-bits = `words` 与 u32、i32 和 f32 一起
machine-register-last = 32 位需要两个寄存器，而这是最后一个
machine-scale-zero = 每个数都会是同一个值
machine-not-zero = 除 0 以外的任何数
machine-safe-out-of-range = 寄存器容不下此值
machine-register-taken = `{ $register }` 已在 { $address }
machine-source-taken = 设备 `{ $device }` 已是焊接电源
machine-one-source = 一个焊接电源
machine-source-without-register = 焊接电源没有 `{ $key }` 的寄存器
machine-inputs-taken = 设备 `{ $device }` 已有输入
machine-inputs-on-one-device = 所有输入在同一设备上
machine-input-without-register = 联锁 `{ $interlock }` 的输入 `{ $input }` 没有寄存器
machine-register-for-every-input = 每个联锁的输入都有寄存器
machine-drives-taken = 另一个设备已控制驱动器
machine-one-device-of-drives = 一个带 `linuxcnc`、`steps`、`rtde`、`egm` 或 `rsi` 的设备
machine-robot-axis-twice = 轴 `{ $axis }` 写了两次
machine-robot-axis-missing = 轴 `{ $axis }` 没有对应的机器人控制器关节
machine-robot-axis-once = 机床的每个轴各一次，按控制器关节的顺序
machine-robot-axis-count = { $n } 个轴与机器人控制器的关节不符
machine-robot-axis-count-allowed = 手臂 { $arm } 个关节，外部关节最多 { $external } 个
machine-robot-axis-linear = 轴 `{ $axis }` 是直线轴，却是手臂的关节
machine-robot-axis-rotary = 前 { $arm } 个须为旋转轴
machine-robot-listen = 不是带端口的 IP 地址
machine-robot-listen-allowed = 本机的 IP 地址和端口，如 0.0.0.0:6510
machine-robot-from = 不是 IP 地址
machine-robot-from-allowed = 控制器的 IP 地址，如 192.168.125.1
machine-hal-file = `{ $file }` 不是 HAL 文件
machine-hal-file-allowed = 以 .hal 结尾的文件路径，或不写 `hal`
machine-base-period = 更快线程的周期无效：{ $base }
machine-base-period-allowed = 10 至 1000，周期 { $period } 是其整数倍，至少两倍
machine-axis-name-long = 轴名 `{ $axis }` 对 LinuxCNC 的 HAL 过长
machine-name-length = 不超过 { $max } 个字符

# Reasons why a pose is out of reach.
machine-unreachable-direction = 旋转轴无法如此转动焊枪；最近的方向相差 { $angle }
machine-unreachable-point = 各轴到不了该点；差 { $distance }
machine-unreachable-flat = 在旋转轴的这些位置，各直线轴平行于同一平面
machine-out-of-reach = 超出可达范围 { $distance }：轴 { $axis } 将位于 { $position }，超出限位 { $limit } 达 { $excess }
machine-axis-out-of-range = 轴 { $axis } 将位于 { $position }，超出限位 { $limit } 达 { $excess }
machine-pair-axes = 两个焊头同时工作需要三个直线轴和三个旋转轴共同承载，且相邻轴互不平行
machine-pair-same-point = 两把焊枪在同一点：没有公共坐标系
machine-pair-opposed = 两把焊枪相对而指：没有公共坐标系

# Check of a machine: inverse kinematics and failures.
machine-method-closed = 解析解
machine-method-plane-on-rotary = 解析解，旋转轴上的平面
machine-method-in-plane = 解析解，平面内
machine-method-numeric = 数值解（牛顿法）
machine-method-spherical-wrist = 解析解，球形手腕机械臂
machine-method-three-parallel = 解析解，三轴平行机械臂
machine-method-spherical-shoulder = 解析解，球形肩部和球形手腕机械臂
machine-free-roll = 绕焊枪的旋转
machine-linear-axes = { $n } 个直线轴（{ $axes }）
machine-rotary-axes = { $n } 个旋转轴（{ $axes }）
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }：{ $axes }
machine-structure-with-free = { $method }：{ $axes }；冗余：{ $free }
machine-check-head = 焊头 { $head }：{ $why }
machine-check-pair = 两个焊头同时：{ $why }
machine-check-round-trip = 往返误差 { $distance } mm、{ $angle }°、轴上 { $difference }；无解位姿：{ $unsolved }，缺少自身分支：{ $missed }
machine-check-jacobian = 雅可比矩阵相差轴 { $axis } 的列的 { $difference }

# Check of a machine: singular configurations.
machine-singular-linear = 直线轴 { $axes } 在同一平面内：枪尖无法离开该平面
machine-singular-along-axis = 焊枪沿轴 { $axis } 方向：此处 { $axis } 自由
machine-singular-undone = { $axes } 可以抵消轴 { $axis } 的运动：此处 { $axis } 自由
machine-singular-parallel = 轴 { $first } 与 { $second } 平行：互相抵消
machine-singular-tilt = 焊枪位于轴 { $first } 与 { $second } 的平面内：两者使其同向倾斜
machine-singular-undo = 轴 { $axes } 互相抵消
machine-singular-following = { $what }，{ $axes } 随动
machine-singular-wrist = 腕部奇异：轴 { $first } 与 { $second } 平行
machine-singular-elbow = 肘部奇异：手臂伸直或折叠
machine-singular-shoulder = 肩部奇异：腕部位于轴 { $axis } 上方
machine-singular-stretched = 手臂伸直或折叠：轴 { $first } 与 { $second } 使枪尖同向移动
machine-singular-tip-on-axis = 枪尖位于轴 { $axis } 上，该轴无法移动它
machine-singular-direction = 枪尖无法沿工件的 ({ $x }, { $y }, { $z }) 方向移动
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }，位于 { $positions }
machine-singular-for-example = { $what }，例如 { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = 位置环将每 { $period } 运行一次
machine-cure-period = 周期以 ms 给出；通常为 1
machine-remark-displacement = 位移超过 { $limit }
machine-cure-displacement = 长度以 mm 给出
machine-remark-no-shapes = 机床没有形体：不检查碰撞
machine-cure-no-shapes = 添加 [[shapes.torch]]，其他可能碰撞的物体同样添加
machine-remark-home-collision = 在原点位置，{ $first } 与 { $second } 相距 { $distance }，小于最小值 { $min }
machine-cure-home-collision = 更改某轴的 home_mm 或 home_deg，或更改形体
machine-remark-range-long = 轴 { $axis } 的行程将达 { $travel }
machine-cure-range-long = 行程以 mm 给出
machine-remark-range-short = 轴 { $axis } 总共只移动 { $travel }
machine-cure-range-short = 行程以 mm 给出；可能误用了 m
machine-remark-turns = 轴 { $axis } 将转 { $turns } 圈
machine-cure-turns = 行程以度给出，或设 continuous = true
machine-remark-range-narrow = 轴 { $axis } 总共只转 { $travel }
machine-cure-range-narrow = 行程以度给出
machine-remark-range-quarter-turns = 轴 { $axis } 总共只转 { $travel }；两端以 rad 计为四分之一圈的整数倍：{ $low } 至 { $high }
machine-remark-range-radians = 轴 { $axis } 总共只转 { $travel }；若以 rad 计则为 { $low } 至 { $high }
machine-cure-range-radians = 行程以度给出；若本意如此则保留
machine-remark-speed-high = { $speed } 比此类轴的速度快
machine-remark-speed-low = { $speed } 比此类轴的速度慢
machine-cure-linear-speed-high = 速度以 mm/s 给出；可能误用了 mm/min
machine-cure-rotary-speed-high = 速度以 °/s 给出；可能误用了 °/min
machine-cure-linear-speed-low = 速度以 mm/s 给出；可能误用了 m/s
machine-cure-rotary-speed-low = 速度以 °/s 给出；可能误用了 rad/s 或 r/min
machine-remark-speed-unreached = 轴 { $axis } 永远达不到该速度：加速与减速需要 { $needed }，而其行程为 { $travel }
machine-cure-linear-speed-unreached = 速度以 mm/s、加速度以 mm/s² 给出
machine-cure-rotary-speed-unreached = 速度以 °/s、加速度以 °/s² 给出
machine-remark-acceleration-low = 轴 { $axis } 需要 { $time } 才能达到最高速度
machine-remark-acceleration-high = 轴 { $axis } 在 { $time } 内达到最高速度
machine-remark-gravity = 重力加速度的 { $factor } 倍超出此类轴的承受能力
machine-cure-linear-acceleration = 加速度以 mm/s² 给出
machine-cure-rotary-acceleration = 加速度以 °/s² 给出
machine-cure-linear-acceleration-low = 加速度以 mm/s² 给出；可能误用了 m/s²
machine-cure-rotary-acceleration-low = 加速度以 °/s² 给出；可能误用了 rad/s²
machine-remark-jerk-missing = 轴 { $axis } 没有加加速度限值
machine-cure-jerk-missing = 添加 { $key }；通常为加速度的十倍
machine-remark-jerk-low = 加速度需要 { $time } 才能建立
machine-cure-linear-jerk = 加加速度以 mm/s³ 给出
machine-cure-rotary-jerk = 加加速度以 °/s³ 给出
machine-remark-drive-missing = 轴 { $axis } 没有驱动器：用假定的驱动器仿真
machine-cure-drive-missing = 添加 [drives.{ $axis }]
machine-remark-drive-weak = 轴 { $axis } 在最高速度加速需要 { $needed }（含摩擦）
machine-cure-drive-weak = 用更强的驱动器，或减小 max_acceleration
machine-remark-drive-strong = 驱动器的能力是负载所需的 { $factor } 倍
machine-cure-linear-drive-strong = 质量以 kg、力以 N 给出
machine-cure-rotary-drive-strong = 转动惯量以 kg·m²、转矩以 N·m 给出
machine-remark-encoder = 一个计数为 { $count }
machine-cure-linear-encoder = 给出轴上每 mm 的计数
machine-cure-rotary-encoder = 给出轴上每度的计数
machine-remark-velocity-loop = { $bandwidth } 对周期 { $period } 的位置环过快
machine-cure-velocity-loop = 带宽以 Hz 给出，或减小 servo_period_ms
machine-remark-pitch = 轴 { $axis } 的偏差将达 { $error }
machine-cure-linear-pitch = 误差以 mm 给出
machine-cure-rotary-pitch = 误差以度给出

# Import of arms.
machine-urdf-not-xml = 该文件不是 XML：{ $why }
machine-urdf-cure-xml = 请更正此处的 XML，或重新导出文件。
machine-urdf-attribute-missing = 元素缺少属性 `{ $name }`
machine-urdf-cure-attribute = 请在元素中添加 `{ $name }="…"`。
machine-urdf-element-missing = 元素缺少 `<{ $name }>`
machine-urdf-cure-element = 请在关节中添加 `<{ $name } link="…"/>`。
machine-urdf-not-numbers = 数字无效
machine-urdf-cure-numbers = 此处需要的数字个数：{ $n }，以空格分隔，例如 `0.1 0 0.25`。
machine-urdf-root = 根元素是 `{ $name }`，而不是 `robot`
machine-urdf-empty = 文件中没有连杆
machine-urdf-cure-root = 请给出 URDF 文件：其根为 `<robot>`，内含 `<link>` 和 `<joint>`。
machine-urdf-xacro = 文件中有 xacro 宏
machine-urdf-cure-xacro = 请先展开宏：`xacro robot.urdf.xacro > robot.urdf`。
machine-urdf-two-parents = 连杆 `{ $link }` 已由关节 `{ $joint }` 承载
machine-urdf-loop = 连杆 `{ $link }` 属于一个闭环
machine-urdf-cure-tree = 请删除其中一个关节：每个连杆只由一个关节承载。
machine-urdf-name-taken = 名称 `{ $name }` 使用了两次
machine-urdf-cure-name = 请重命名其中之一。
machine-urdf-link-unknown = 没有连杆 `{ $link }`
machine-urdf-cure-link = 请给出文件中的一个连杆。
machine-urdf-axis-zero = 该轴没有方向
machine-urdf-cure-axis = 请给出方向，例如 `xyz="0 0 1"`。
machine-urdf-size = 尺寸不大于 0
machine-urdf-cure-size = 请以米给出大于 0 的尺寸。
machine-urdf-roots = 文件有多个基座连杆：{ $links }
machine-urdf-cure-roots = 请选择基座：`--base LINK`。
machine-urdf-tips = 该树有 { $n } 个由轴带动的末端：{ $links }
machine-urdf-cure-tips = 请选择承载焊枪的连杆：`--tip LINK`。
machine-urdf-no-axes = 没有轴带动由 `{ $link }` 承载的连杆
machine-urdf-cure-no-axes = 请用 `--base LINK` 选择另一个基座，或将关节改为 `revolute` 或 `prismatic`。
machine-urdf-not-carried = 基座 `{ $base }` 不承载连杆 `{ $tip }`
machine-urdf-cure-not-carried = 请另选 `--base` 或 `--tip`。
machine-urdf-axes = 到连杆 `{ $link }` 的轴数：{ $n }
machine-urdf-cure-axes = 请选择 `--base` 和 `--tip`，使其间有 1 到 { $max } 个轴。
machine-urdf-too-long = 从基座到末端的链长 { $length }：以米计的机械臂没有这么长
machine-urdf-too-short = 从基座到末端的链长 { $length }：以米计的机械臂没有这么短
machine-urdf-cure-scale = URDF 以米为单位。请用 `--scale { $factor }` 导入，或以米导出文件。
machine-urdf-degrees = 关节 `{ $joint }` 的角度不是弧度
machine-urdf-cure-degrees = 请以 rad 和 rad/s 写出限值：度数除以 57.29578。
machine-urdf-joint-type = 关节 `{ $joint }` 的类型不是轴
machine-urdf-cure-joint-type = 基座与末端之间允许：`revolute`、`continuous`、`prismatic`、`fixed`。
machine-urdf-mimic = 关节 `{ $joint }` 跟随关节 `{ $other }`
machine-urdf-cure-mimic = 请选择此关节之前的 `--tip`，或将其改为 `fixed`；若它有自己的驱动，请删除 `<mimic>`。
machine-urdf-limit-missing = 关节 `{ $joint }` 没有限值
machine-urdf-limit-empty = 关节 `{ $joint }` 的范围为空
machine-urdf-cure-limit = 请按数据表写出 `<limit lower="…" upper="…" velocity="…" effort="…"/>`，单位为 rad、rad/s 和 N m，或 m、m/s 和 N。
machine-urdf-velocity = 关节 `{ $joint }` 没有最大速度
machine-urdf-cure-velocity = 请给出数据表中的 `velocity`，单位为 rad/s 或 m/s。
machine-urdf-mesh-missing = 没有网格 `{ $mesh }`
machine-urdf-mesh-tried = 以下位置之一的文件：{ $files }
machine-urdf-cure-mesh = 请用 `--package NAME=DIR` 给出其软件包的文件夹，或用 `--no-shapes` 不导入形体。
machine-import-rounded-angles = 来源中有 { $n } 个角度是 15 度的舍入倍数（如 1.5708），已按精确值读取
machine-import-flange = 在多个末端（{ $links }）中选择了法兰 `tool0`；可用 `--tip` 另选
machine-import-held = 链外的关节保持在零位：{ $joints }
machine-import-no-shapes = 没有形体：不检查间隙
machine-import-shape-kind = 连杆 { $link } 的一个形体已略去：`{ $kind }` 不是长方体、圆柱、球或网格
machine-import-mesh-format = 连杆 { $link } 的网格 { $file } 已略去：请转换为 STL
machine-import-mesh-unusable = 连杆 { $link } 的网格 { $file } 已略去：{ $why }
machine-import-mesh-stretched = 其沿 x、y、z 的比例不同
