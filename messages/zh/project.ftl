# Findings at the command line.
project-weld-possible = 可以按要求焊接
project-weld-possible-with-remarks = 可以焊接，但有提示
project-weld-impossible = 无法按要求焊接：{ $findings } 项问题
project-finding = { $severity }（{ $kind }）：{ $finding }
project-severity-error = 问题
project-severity-warning = 警告
project-severity-note = 提示
project-where = 位置：{ $places }
project-cure = 处理：{ $cure }
project-pass = 焊道 { $pass }
project-passes = 焊道 { $first } 至 { $last }
project-place = { $passes }，s = { $s }
project-place-range = { $passes }，s = { $from } 至 { $to }
project-places = { $first }；{ $then }
project-more-places = 另有 { $places } 处

project-angles-of-another-plan = 焊枪角度属于另一个计划
project-long-stick-out = 焊枪只有在干伸长为 { $found } 时才不碰撞：超过 { $usual } 时，送丝速度不变电流也会下降，保护气变稀
project-cure-long-stick-out = 使用更适合坡口的焊枪，或 stick_out_mm 允许该值的焊接工艺

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
project-with-hint =
    { $message }
    { "   " }{ $hint }
project-or = { $first } 或 { $second }
project-note = 提示：{ $note }
project-planning-cancelled = 规划已取消
project-failed = 失败
project-standard-input = 标准输入：{ $why }
project-in-machine-file = 机床文件：{ $why }
project-in-file = { $file }：{ $why }
project-document-fault = { $file }:{ $line }: { $key }: { $message }

# Files.
project-unreadable = { $file }：无法读取：{ $why }
project-not-writable = { $file }：无法写入：{ $why }
project-writable = 可写的文件夹或文件
project-no-such-folder = 没有这个文件夹
project-permission-denied = 没有权限
project-not-a-folder = 这不是文件夹
project-is-a-folder = 这是文件夹
project-file-too-large = { $file }：文件过大
project-up-to-1-gib = 不超过 1 GiB
project-other-file-there = { $file }：{ $from } 的副本位置已有另一个文件
project-other-folder = 另一个输出文件夹
project-files-written = { $files } 个文件写入 { $folder }：{ $names }
project-files-written-more = { $files } 个文件写入 { $folder }：{ $names } 及另外 { $more } 个
project-file-outside = 名称指向任务文件夹之外
project-link-outside = 链接指向任务文件夹之外
project-not-a-plain-file = 这不是普通文件
project-file-above = 大于 { $max }

# Tables.
project-csv-value = { $file }:{ $line }：{ $column } = `{ $value }`：{ $fault }
project-not-a-finite-number = 不是有限数
project-no-column = { $file }:1：`{ $header }` 中没有列 `{ $column }`
project-header-line = 含 { $columns } 的标题行，然后是数
project-header-line-with-commas = 含 { $columns } 的标题行，然后是数，以逗号分隔
project-table-too-long = { $file }：表过长
project-up-to-points = 不超过 { $max } 个点
project-file-from-job = 存在的文件，路径相对于任务文件夹

# Jobs and machines.
project-no-such-file = { $file }：没有这个文件
project-copy-example = 有示例 `{ $name }`；复制：seamwright examples { $name } > { $name }.toml
project-job-or-example = 任务或程序文件，或示例的名称：{ $names }
project-program-without-seam = 程序没有焊缝
project-job-or-seam = 任务，或有 [seam] 的程序
project-no-machine = 没有机床 `{ $name }`
project-shipped-machine-or-file = 随附的机床，或机床文件的路径
project-no-machine-or-file = 没有这台机床，也没有文件 { $file }
project-no-such-machine = { $name }：没有这台机床，也没有这个文件
project-machine-names = { $names }，或机床文件的路径
project-machine-refused = 机床 `{ $name }`：{ $why }
project-machine-among-jobs = 随附机床的名称，或任务中的机床文件
project-machine-without-file = 机床 `{ $name }` 没有文件
project-not-a-table = `{ $table }` 不是表
project-process-value-is-axis = 工艺参数 `{ $name }` 与机床的轴同名
project-one-head = { $machine } 只有一个焊头：不能同时焊两条角焊缝
project-no-recording-machine = 没有可能记录它们的机床 `{ $name }`
project-machine-as-recorded = 记录时的 `machine`
project-positions-for-axes = { $positions } 个位置，而 { $machine } 有 { $axes } 个轴
project-within-axis-ranges = 各轴范围内的位置
project-option-tolerance = --tolerance-mm { $value }：{ $why }

# Planning.
project-part-not-checked = 没有描述工件：仅检查与机床和夹具的碰撞
project-cure-describe-part = 用 [[part.solids]] 描述工件，或用生成它的 [seam]
project-part-replaced = 由焊缝生成的工件已被替换：仅检查与 [part] 中实体的碰撞
project-period-too-long = 周期 { $period } 比焊道 { $pass } 的行程时间更长
project-period-within-travel = 不超过行程时间 { $max }
project-too-many-set-points = 运动需 { $time }，即 { $set-points } 个设定值，每个 { $period }
project-up-to-set-points = 不超过 { $max } 个设定值；提高速度、缩短时间或加长周期
project-tracking-with-devices = 焊道用仿真传感器跟踪，而机床文件有自己的设备
project-no-devices-or-tracking = 没有 [devices] 的机床文件，或不跟踪

# Devices.
project-register-too-small = 焊道 { $pass } 要求 `{ $name }` 为 { $value }，设备 `{ $device }` 的寄存器（{ $register }）容纳不下
project-register-range = { $min } 至 { $max }，或机床文件中的其他比例或类型
project-register-or-no-value = 机床文件 [devices.{ $device }.modbus.set] 中的寄存器 `{ $value }`，或不含它的任务
project-check-modbus = 检查电缆、地址、站号和寄存器；`seamwright machine io MACHINE` 逐个读取
project-check-robot = 检查电缆、两端的地址，以及控制器上是否运行 `seamwright machine robot-program { $protocol }` 的程序
project-period-of-no-cell = 机床 `{ $machine }`：没有单元能以 servo_period_ms = { $period } 运行
project-periods = { $min } 至 { $max }，未写则为 1 ms；`seamwright machine latency` 测量本机的能力
project-linuxcnc-needs-linux = LinuxCNC 驱动只能用于 Linux
project-simulated = 仿真：{ $devices }
project-drives = 驱动
project-process-source = 焊接电源
project-inputs = 输入
project-pulses-end = { $file }：{ $why }：脉冲到此结束

# Welds that were interrupted.
project-journal-damaged = { $folder }：位置日志的两个文件都已损坏：可能有焊接在未知位置中断
project-look-and-choose = 查看工件，然后用 --from PASS,MM 从那里继续，或用 --from 1,0 重新焊接
project-weld-left = 焊接 { $weld } 因断电或程序故障中断：焊道 { $pass }，已焊至 { $welded }，焊枪在 { $torch }
project-grind-and-continue = 查看焊道末端并打磨，然后 --from { $from }；或 --from 1,0 重新焊接
project-journal-thread-failed = 日志线程失败

# Teaching by camera.
project-no-taught-program = 找到的线不能成为程序：{ $why }
project-teach-machine-limit = 机床无法再前进：{ $why }
project-teach-joint-too-long = 接头比标称焊缝的两倍还长
project-teach-joint-lost = 丢失接头
project-teach-no-joint = 没有找到接头
project-teach-no-more-frames = 图像帧先于接头结束
project-cure-teach = 从那里用 --start 继续示教，放宽 --longest-tack-mm，或手动取点
project-goes-on = 从焊道 { $pass } 的 { $from } 处继续

# Search for placements.
project-reach-axes = 焊道 { $pass } 由轴位置给出：摆放不会移动它
project-reach-axes-allowed = 沿焊缝或经过焊枪点的焊道
