# 服务器的启动和结束。
server-syslog-receiver = 不是 syslog 接收端：{ $text }；允许：udp://HOST:PORT 或 tcp://HOST:PORT，端口 1 至 65535（默认 514），IPv6 地址用方括号
server-bind = { $option }：{ $why }
server-bind-free = 一个地址和一个空闲端口
server-bind-plain = 其他计算机可以访问该地址，但没有加密
server-bind-encrypted = 使用 --tls，或 --cert 和 --key；127.0.0.1、[::1]
server-bind-no-admin = 其他计算机可以访问该地址，但还没有人设置密码
server-bind-local-first = 127.0.0.1 或 [::1]，先在那里创建有密码的管理员
server-bind-no-name = 缺少本计算机的名称
server-bind-named = 使用 --host NAME，或单个地址
server-certificate-failed = 无法生成证书：{ $why }
server-certificate-files = { $options }：{ $why }
server-pem-files = 证书及其私钥的 PEM 文件
server-panicked = 程序故障（panic）：单元已停止，已命令其设备关闭
server-library-open = 无法关闭记录库：没有恢复任何数据
server-look-at-once = 立即检查电弧和气体是否已关

# Requests.
server-failed = 失败；没有任何更改
server-program-fault = 因程序缺陷而终止：请报告
server-no-thread = 无法启动线程：{ $why }
server-panel-ends = 面板正在结束
server-slow-down = 此类请求过多：请稍后再试
server-too-many-requests = 请求过多：请稍候
server-request-late = 请求到达时间过长
server-request-too-large = 请求过大；允许：最多 { $max } KiB
server-too-many-pages = 打开的页面过多：请关闭一个
server-cell-ended = 单元程序已结束
server-cell-silent = 单元没有应答：请重试
server-no-machine = 没有机床
server-no-machine-named = 没有机床“{ $name }”
server-no-axis = 没有轴“{ $axis }”；允许：{ $allowed }
server-no-language = 没有语言“{ $language }”；{ $allowed }
server-file-trouble = { $file }：{ $why }
server-file-unreadable = { $file } 无法读取：{ $why }

# Log-in and permissions.
server-unknown-host = 本面板不使用名称“{ $host }”；允许：{ $allowed }
server-other-origin = 拒绝来自其他来源页面的请求
server-not-logged-in = 未登录或会话已结束：请登录
server-session-over = 会话已结束：请登录
server-role = 角色“{ $role }”不允许此操作（{ $action }）
server-role-from = 角色“{ $role }”不允许此操作（{ $action }）；允许：“{ $needed }”及以上
server-header = 请求头 `{ $header }` 必须是 `{ $value }`
server-token = 请求头 `{ $header }` 必须带有会话令牌
server-content-type = 不接受内容类型“{ $kind }”；允许：{ $allowed }
server-wrong-passwords = 密码错误次数过多：请等待 { $wait }
server-login-too-long = 名称或密码过长；允许：最多 { $max }
server-login-wrong = 名称或密码错误，或启动链接已过期
server-no-random = 没有随机数：{ $why }

# Users.
server-own-password = 此操作需要您自己的密码，而密码错误
server-user-exists = 用户“{ $user }”已存在
server-no-user = 没有用户“{ $user }”
server-user-name = 用户名无效；允许：字母、数字、- _ . 及其间的空格，最多 { $max } 个
server-user-owner = “{ $user }”保留给启动链接：请换一个名称
server-password-length = 密码长度无效；允许：{ $min } 到 { $max } 个字符
server-password-needed = 新用户需要密码
server-password-hash = 无法对密码做哈希：{ $why }
server-too-many-users = 用户过多；允许：{ $max }
server-last-admin = 将没有管理员：请先把另一个启用的用户设为管理员

# Jobs.
server-job-name = 任务名无效：“{ $name }”；允许：字母、数字、- _ . ( ) + 和空格，最多 { $max }，以 .toml 结尾
server-no-job = 没有任务“{ $job }”
server-no-own-job = 没有您自己的任务“{ $job }”
server-jobs-unreadable = 任务文件夹无法读取：{ $why }
server-template-name = “{ $job }”是模板名：请用别的名称保存
server-other-text = “{ $job }”下已保存另一文本
server-search-too-long = 搜索文本过长；最多 { $max } 个字符
server-too-many-jobs = 任务过多；允许：{ $max }
server-job-not-deleted = { $job } 无法删除：{ $why }
server-too-many-operations = 操作过多；允许：一次最多 { $max } 个
server-operation = 操作 { $n }：{ $why }
server-at-key = { $key }：{ $what }
server-at-value = { $key } = { $value }：{ $what }
server-and-allowed = { $what }；允许：{ $allowed }
server-and-help = { $what }；{ $help }

# Planning.
server-superseded = 已取消，或被更新的请求取代
server-planning-time = 规划超过 { $max }；请减少焊道、焊珠或点
server-planning-memory = 规划需要超过 { $max } GiB 内存；请减少焊道、焊珠或点
server-plan-too-large = 规划过大，无法显示；允许：最多 { $max }
server-no-process = 无法启动规划进程：{ $why }
server-no-pipes = 无法启动规划进程：没有管道
server-planning-failed = 规划失败；单元不受影响：{ $why }
server-no-dialect = 没有方言“{ $name }”；允许：{ $allowed }

# Loading.
server-part-number = 工件编号无效；允许：最多 { $max } 个可见字符
server-machine-moves = 机床正在运动或暂停：请先停止
server-other-devices = 任务的机床文件中的设备与面板启动时的机床文件不同；允许：相同的 [devices]，或没有
server-devices-held = 设备未释放：请重新启动面板
server-devices-not-connected = 设备无法连接
server-needs-other-devices = 任务用于另一台机床：请先将驱动器断电
server-loading = 正在装入另一个程序：请稍候
server-load-announced = 正在规划待装入的任务：请等待其进入单元
server-overlap = 搭接 { $value } 无效；允许：最多 { $max }
server-nothing-to-weld = 焊道 { $pass }，{ $s }：没有剩余可焊；允许：焊道 1 到 { $passes }，在其长度内
server-finished-pass = 工件“{ $part }”已焊至焊道 { $pass }，{ $s }：此次启动会重复焊接；请从该处继续，或确认
server-finished-part = 工件“{ $part }”已全部焊完（焊接 { $weld }）：此次启动会重复焊接；请确认，或指定另一工件

# Commands over the socket.
server-message-invalid = 消息无效：{ $why }
server-unknown-command = 未知命令“{ $name }”；允许：{ $allowed }
server-no-control = 此页面没有控制权：请先取得控制权
server-control-jogs = 有控制权的页面正在点动：请等待松开按键
server-control-held = { $user } 正在控制，页面 { $page }
server-replayed = 命令 { $n } 已收到过；允许：大于 { $last }
server-busy = 命令过多
server-at-rest = 没有任何运动
server-override-range = 倍率 { $value }；允许：0 到 1
server-no-alarm = 没有报警 { $number }；允许：1 到 { $max }
server-step-range = 步长 { $value }；允许：正负最多 { $max }
server-positions-unknown = 各轴位置未知
server-no-such-axis = 没有这个轴
server-tip-directions = 尖端只能沿 x、y、z 移动
server-axis-count = { $n } 个轴；允许：{ $allowed }
server-axes-moving = 轴仍在运动：请稍候
server-not-homed = 轴 { $axis } 未回参考点：请先回参考点
server-shelve-time = { $minutes } 分钟；允许：最多 { $max }
server-alarm-not-listed = 该报警不在列表中
server-alarm-reacts = “{ $alarm }”有反应（{ $reaction }）；只能搁置仅提示的报警

# Set-up.
server-no-job-loaded = 未装入任务：请先装入此机床的任务
server-axis-not-in-file = 轴不在其文件中
server-no-parameter = 没有参数“{ $key }”；允许：{ $allowed }
server-other-kind-of-axis = “{ $key }”属于另一类轴
server-no-head = 没有焊头 { $head }；允许：0 到 { $max }
server-too-many-touches = { $n } 次触碰；允许：最多 { $max }
server-touch = 触碰 { $touch } 无效；允许：{ $n } 个位置，mm 或度，最大 1000000
server-more-touches = { $why }；请触碰同一点三次以上，其间将焊枪倾斜 20 度以上
server-tip-far = tip_mm { $tip }；允许：最大 { $max }
server-no-camera = “{ $sensor }”不是相机；允许：带 `map.heights` 的传感器
server-grid = 网格无效：间距 { $pitch }，高度 { $z }；允许：间距大于 0
server-no-sensor = 没有传感器“{ $sensor }”；允许：{ $allowed }
server-not-simulated = 非仿真；允许：仿真设备，最多 { $max } 像素
server-scale-differs = 比例相差 { $difference }：请检查间距和高度
server-picture-size = 图像为 { $pixels } 像素；允许：{ $allowed }
server-no-sensor-key = 没有“{ $key }”；允许：{ $allowed }
server-number-count = “{ $key }”有 { $n } 个数；允许：{ $allowed }
server-too-many-planes = { $n } 个平面；允许：最多 { $max }

# Placing the part by touching.
server-probe-radius = 测头半径 { $value }；允许：0 到 { $max }
server-too-many-points = { $n } 个点；允许：最多 { $max }
server-feature = 点 { $point }：未知要素“{ $feature }”；允许：{ $allowed }
server-point-far = 点 { $point } 过远；允许：最远 { $max }
server-more-points = { $why }；请使用更多分布在各面上的点，或换一种方法
server-more-points-round = { $why }；请在端面上和圆周上使用更多的点
server-no-surfaces = 任务没有可供触碰的表面的焊缝：请使用任务
server-not-determined = 未确定：{ $what }；保持不变
server-turn-about-axis = 绕轴的转角
server-no-spare-points = 点数不多于未知数：坏点无法发现
server-three-points-plane = 平面：只有三个点；坏点无法发现
server-three-points-face = 端面：只有三个点；坏点无法发现
server-three-points-round = 圆：只有三个点；坏点无法发现
server-round-diameter = 圆的直径：{ $diameter }
server-no-position = 这些点无法确定位置
server-offsets-no-table = `offsets` 不是表；允许：[offsets.NAME]

# Records and backup.
server-query = { $name }：{ $why }
server-too-many-values = { $columns } 列、每列 { $rows } 行过多；允许：最多 { $max-columns } 列，{ $max-values } 个值
server-row-count = most={ $value }；允许：{ $min } 到 { $max }
server-no-column = 没有列“{ $column }”；允许：{ $allowed }
server-not-off = 机床未断电：请先将驱动器断电
server-archive-too-large = 归档过大；允许：最多 { $max }；更大的用 `seamwright records restore`
server-archive-broke-off = 归档传输中断
server-archive-no-admin = 归档中没有管理员：之后无人能使用面板
server-no-archive = 没有检查过的归档：请先发送
server-record-being-written = 焊接记录仍在写入：请等待
server-backup-runs = 正在制作或检查备份：请等待结束

# Teaching by camera.
server-no-image = 还没有图像
server-teach-point = 像素和位置；允许：其中之一，或都不给
server-teach-no-work = 图像该处没有工件
server-teach-range = { $key } { $value }；允许：{ $min } 到 { $max }
server-teach-above = { $key } { $value }；允许：大于 0，至 { $max }
server-teach-method = 未知方法“{ $method }”；允许：{ $allowed }
server-teach-nothing = 尚未示教任何内容
server-teach-tack = 定位焊无效；允许：起点在终点之前，均为有限值
server-teach-order = 指令无效
server-teach-real-devices = 机床设备是真实的，且其文件没有指定相机的 `frames`：请点动示教
server-teach-no-program = 未装入程序：其焊缝给出标称接缝
server-teach-is-open = 会话已打开：请先停止
server-teach-not-open = 没有打开的会话
server-teach-not-asked = 现在不需要接缝位置
server-teach-not-paused = 没有暂停的内容
server-teach-far = 该位置不在标称焊缝附近；允许：15 mm 以内
server-teach-start-far = 起点不在标称焊缝附近
server-teach-other-machine = { $job } 用于 { $machine }，不用于此单元
server-teach-no-frames = 机床设备是真实的，且 sensors.{ $sensor } 没有 `frames`
server-teach-no-camera = { $machine } 没有相机；允许：文件中有 [sensors.NAME] 和 kind = "camera" 的机床
server-teach-sensor-no-camera = { $sensor } 不是相机
server-teach-blocked = 单元在途中停止了各轴：请查看报警
server-camera-address = 机床文件指定的相机 { $address } 不允许本单元连接；允许：本机；其他用 `seamwright serve --camera HOST:PORT`
server-camera-address-list = 机床文件指定的相机 { $address } 不允许本单元连接；允许：本机、{ $allowed }；其他用 `seamwright serve --camera HOST:PORT`

# Audit log: where from, what, and result.
server-audit-panel = 面板
server-audit-panel-number = 面板 { $number }
server-audit-panel-at = { $address } 上的面板
server-audit-save-job = 保存任务 { $job }
server-audit-delete-job = 删除任务 { $job }
server-audit-load = 装入 { $job }
server-audit-change-user = 更改用户 { $user }
server-audit-delete-user = 删除用户 { $user }
server-audit-own-password = 自己的密码
server-audit-log-in = 登录
server-audit-log-out = 登出
server-audit-backup = 下载备份
server-audit-restore = 恢复
server-audit-check-archive = 检查备份
server-audit-set-axis = 更改轴 { $name }（{ $file }）
server-audit-set-tool = 更改工具 { $name }（{ $file }）
server-audit-set-sensor = 更改传感器 { $name }（{ $file }）
server-audit-shelve = 搁置报警 { $alarm } { $detail }，{ $minutes } 分钟
server-audit-override = 倍率 { $override }
server-audit-acknowledge = 确认：{ $alarm }
server-audit-weld = 焊接 { $weld }，工件“{ $part }”
server-audit-others = 其他
server-audit-teach = 示教：{ $order }
server-audit-teach-open = 启动相机：步长 { $step }，间断不超过 { $tacks }，种子 { $seed }
server-audit-teach-open-tack = 启动相机：步长 { $step }，间断不超过 { $tacks }，种子 { $seed }，定位焊从 { $from } 到 { $to }
server-audit-teach-pixel = 接缝在这里：像素 { $x }, { $y }
server-audit-teach-point = 接缝在这里：X { $x } Y { $y } Z { $z }
server-audit-teach-middle = 接缝在相机十字处
server-audit-teach-end = 接缝在此结束
server-audit-teach-pause = 暂停
server-audit-teach-resume = 继续
server-audit-teach-stop = 停止
server-audit-accepted = 已接受
server-audit-saved = 已保存
server-audit-deleted = 已删除
server-audit-changed = 已更改
server-audit-kept = 已保存
server-audit-begun = 已开始
server-audit-checked = 已检查
server-audit-loaded = 已装入
server-audit-logged-in = 已登录
server-audit-logged-out = 已登出
server-audit-refused = 已拒绝
server-audit-refused-role = 已拒绝：角色不允许
server-audit-reweld = 已完成的部分可再次焊接
server-audit-raised-again = 再次触发
server-audit-several = 多个请求
server-audit-kind = { $command }：{ $result }（{ $n }）
server-audit-refused-sum = { $n } 个请求被拒绝，首个 { $first }，最后 { $last }：{ $kinds }
server-audit-repeated-sum = { $n } 个重复请求，首个 { $first }，最后 { $last }：{ $kinds }
server-audit-left-out = { $first } 至 { $last } 之间漏记 { $n } 条

# Events.
server-event-left = 焊道 { $pass } 中断，已焊至 { $s }
server-event-mode = { $from } -> { $to }
server-event-order = { $order }
server-event-refused = { $order }: { $reason }
server-event-alarm = { $alarm }: { $reaction }
server-event-alarm-of = { $alarm } ({ $object }): { $reaction }
server-event-alarm-before = { $time } 的{ $alarm }在结束前未确认
server-event-cleared = { $alarm }已消失
server-event-cleared-of = { $alarm }（{ $object }）已消失
server-event-pass-ends = 焊道 { $pass } 结束于 { $s }
server-event-left-before = 焊接 { $weld } 因断电或程序故障中断：继续前请检查焊道末端
server-event-stopped-by = 单元被停止：{ $cause }
server-event-cycles-missed = 错过 { $cycles } 个周期，最长连续 { $longest }
server-event-no-realtime = 控制周期没有实时权限：{ $reason }
server-event-safe-by-panel = { $device }：单元无响应，面板已自行写入安全输出，先关电弧或束流
server-event-safe-unconfirmed = { $device }：未确认输出处于安全状态：{ $reason }
server-event-journal-damaged = 位置日志已损坏：无法得知因断电中断的焊接；请检查工件，然后回零
server-event-weld-lost = 焊接 { $weld } 有文件但不在记录库中：记录库已损坏，该条目已丢失
server-event-recorded = 焊接 { $weld } 已记录：{ $result }
server-event-record-not-whole = 焊接 { $weld }：记录不完整：{ $reason }
server-event-record-interrupted = 焊接 { $weld } 曾中断；其记录已恢复
server-event-record-fails = 无法写入记录：{ $reason }
server-event-not-recorded = 本次焊接未记录：{ $reason }
server-event-audit-fails = 无法写入操作日志：{ $reason }；等待：{ $n }
server-event-audit-hangs = 操作日志所在磁盘无响应；等待：{ $n }
server-event-audit-stored = 操作日志恢复写入；曾等待的条目：{ $n }
server-event-audit-left-out = 操作日志丢失 { $n } 条：等待的条目过多
server-event-syslog-fails = 无法连接 syslog 接收端 { $receiver }：{ $reason }；等待：{ $n }
server-event-syslog-sends = syslog 接收端 { $receiver } 已恢复；未发送：{ $n }
server-event-restored = 所有数据已恢复；之前的数据在 { $folder }
server-event-control-taken = 已取得控制权
server-event-control-taken-over = 已接管控制权
server-event-control-lost = 控制权丢失：面板无响应
server-event-loaded = 已装入：{ $job }
server-event-not-loaded = 未装入：{ $reason }
server-event-teach-ended = 示教 { $job } 结束：{ $result }
server-event-shelved = { $alarm } 已搁置 { $minutes } 分钟
server-event-unshelved = { $alarm } 不再搁置
server-event-machine-changed = { $subject } 已在 { $file } 中更改：重新装入该机床任务后生效
server-event-tool-changed = { $head } 的尖端已在 { $file } 中更改：重新装入该机床任务后生效
server-event-sensor-changed = 传感器 { $sensor } 已在 { $file } 中更改：重新装入该机床任务后生效
server-event-cell-lost = 单元已异常终止：{ $reason }
server-event-cell-restarted = 新单元已启动：关闭状态，无程序；其设备已连接
server-event-cell-not-restarted = 无法启动新单元：{ $reason }
server-cell-dies-often = 单元在十分钟内异常终止 { $n } 次
server-event-cell-found = 发现正在运行的单元及其程序：{ $job }

# Log.
server-log-starts = Seamwright { $version } 已在 { $address } 提供服务
server-log-restores = 所有数据已恢复：单元重新启动
server-log-ends = 服务器正在结束
server-log-logged-in = { $user } 已从 { $address } 登录
server-log-refused = { $time } 内拒绝：{ $kind }：{ $n }
server-log-worker-starts = 进程 { $pid } 启动：{ $question }
server-log-worker-ended = 进程 { $pid } 在 { $time } 后结束：{ $question }
server-log-worker-killed = 进程 { $pid } 在 { $time } 后被终止：{ $question }：{ $reason }
server-log-disk-slow = { $folder }：一次小的写入用了 { $time }
server-log-ready = 单元可以使用
server-log-not-ready = 单元不能使用：{ $reasons }
server-log-cycle-hangs = 控制周期没有结束：请检查电弧、气体和驱动器是否已关闭
server-log-record-open = 最近一次焊接的记录没有关闭：下次启动时会补全
server-log-certificate-fails = 证书没有更新：{ $reason }
server-log-authority = 单元的证书颁发机构有效期至 { $until }：请在浏览器中安装 { $file }
server-log-browsers-unknown = { $file }：{ $reason }：重新记住浏览器
server-log-browsers-not-kept = 没有保存已知浏览器：{ $reason }
server-log-left-out = 漏掉 { $n } 行日志

# Readiness and monitoring.
server-not-ready-cell-starts = 单元正在启动
server-not-ready-cell = 单元已 { $age } 没有响应
server-not-ready-disk-silent = { $folder } 所在的磁盘已 { $age } 没有响应
server-not-ready-disk-unknown = 正在检查 { $folder } 所在的磁盘
server-not-ready-disk-full = { $folder } 所在的磁盘只剩 { $free }；需要 { $needed }
server-not-ready-library = 记录库无法写入：{ $reason }
server-monitor-login = 请登录、发送 `--monitor-token` 的令牌，或从本机访问
server-log-cycle-failed = 单元的循环发生故障
server-log-entry-refused = 库拒绝审计日志的一条记录：{ $reason }：{ $entry }
server-log-waiting-file = 等待中的审计日志记录已保存，但其文件无法清空：{ $reason }
