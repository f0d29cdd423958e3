# Settings.
tracking-value = { $key } = { $value }：允许：{ $allowed }
tracking-ages = 两个时效值（s）：先最小值，再更大的最大值，最多 10
tracking-scan-allowed = 小于周期
tracking-speeds-allowed = 两个大于 0 的速度，较慢者在前
tracking-notice-allowed = 大于滑台滞后，不超过 0.02
tracking-correction-allowed = 各轴可向各个方向移动焊枪的路径
tracking-look-ahead-too-short = 前视距离 { $distance } 在 { $speed } 时过短：偏差须在焊枪到达前 { $notice } 已知；允许 { $min } 或更大，或 { $max } 或更慢

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }：焊接最多每 { $min } 中断一次；允许该值或更大
tracking-frame-too-long = scan_s = { $scan }：焊接可中断 { $max }；允许该值或更小
tracking-zone-outside = 在 { $speed } 时须看到前方 { $from } 至 { $to } 的接缝，而画面止于 { $reach }；允许 { $min } 至 { $max }
tracking-zone-outside-at-any-speed = 在 { $speed } 时须看到前方 { $from } 至 { $to } 的接缝，而画面止于 { $reach }；这样的画面不适用于任何速度

# Stored deviations.
tracking-pass-not-covered = 焊道为存储焊缝的 { $from } 至 { $to }，而存储的偏差为 { $first } 至 { $last }
tracking-stored-deviation-moved = { $points } 个点中十分之九偏差达 { $within }（中位数 { $median }），允许 { $max }；请改为跟踪该焊道
tracking-stored-deviation-unseen = { $frames } 帧中有 { $points } 个点，须有 { $min } 个或更多；只检查能看到接缝的帧
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`：{ $wrong }；允许：{ $allowed }
tracking-record-no-column = 表头缺少该列
tracking-record-not-finite = 不是有限数
tracking-record-out-of-range = 超出范围
tracking-record-not-increasing = 不大于前一行
tracking-record-too-short = 少于两行
tracking-record-table = 表头行 s_mm,lateral_mm,height_mm,confidence，然后至少两行有限数
tracking-record-path-lengths = 递增的路径长度

# Faults of a sensor.
tracking-sensor-silent = 传感器没有数据
tracking-sensor-contradictory = 传感器的测量值自相矛盾
tracking-sensor-confidence = 传感器的置信度不是 0 到 1 之间的数
tracking-sensor-faint = 传感器看到的接缝太模糊
tracking-sensor-out-of-field = 接缝在传感器视野之外
tracking-sensor-clock = 传感器的时间戳有误
tracking-sensor-late = 传感器的测量值到得太晚
tracking-sensor-frozen = 传感器反复发送相同的测量值

# Alarms of tracking.
tracking-near-stroke-end = 修正接近极限
tracking-axes-carry = 超出束流偏转范围：由各轴带动电子枪
tracking-slowed = 因偏差变化过陡而减速
tracking-blind = 传感器什么也没看到
tracking-coasting = 焊枪超出接缝已测量的部分
tracking-beyond-history = 焊枪退回超出已存储测量值的范围
tracking-fading-out = 修正逐渐回到示教路径
tracking-stroke-end = 修正已到极限：焊缝偏离接缝
tracking-joint-lost = 接缝丢失
tracking-slide-stuck = 滑台未跟随设定值
tracking-stored-deviation-misfit = 存储的偏差不匹配

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = 检测到的线与之前找到的线不相接
tracking-crawl-frames-apart = 两帧中接缝的位置相差 { $distance }
tracking-crawl-not-seen = 看不到接缝
tracking-crawl-not-seen-further = 再往前看不到接缝
tracking-crawl-end-or-tack = 再往前看不到接缝：它在此结束，或被超过最大长度的定位焊遮住
