# Errors of files and of the library.
record-full =
    { $path }：{ $why }
       允许：释放磁盘空间，或使用其他数据文件夹；先前的数据已保留
record-disk-full = 磁盘已满
record-no-room = 可用 { $free }，焊接记录需要 { $needed }
record-read-only =
    { $path }：不可写：{ $why }
       允许：有写权限的文件夹
record-not-read =
    { $path }：无法读取：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-written =
    { $path }：无法写入：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-created =
    { $path }：无法创建：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-removed =
    { $path }：无法删除：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-moved =
    { $path }：无法移动：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-archived =
    { $path }：无法加入归档：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-not-unpacked =
    { $path }：无法解包归档：{ $why }
       允许：正常磁盘上已存在的文件或文件夹
record-damaged =
    { $path }：{ $why }
       允许：{ $allowed }
record-newer =
    { $path }：由更新的版本写入（模式 { $found }，本版本最高读取 { $known }）
       允许：该版本的 Seamwright；未做任何更改
record-busy =
    { $path }：正被其他程序使用
       允许：待该程序结束后重试
record-search-ended =
    { $path }：搜索时间过长
       允许：缩短时间范围或不带文本后重试
record-invalid =
    { $what }
       允许：{ $allowed }
record-database = { $path }：{ $why }
record-invalid-moment = 无效日期：{ $text }；允许：2026-11-21 或 "2026-11-21 14:05"，UTC

# The library.
record-library-damaged = 记录库已损坏（{ $why }）
record-library-from-copy = 用最近的副本替换，或移走：将新建记录库，轨迹记录保持不变
record-library-missing = { $path }：没有记录库
record-begin-library = 有焊接记录的数据文件夹：simulate JOB -o DIR --data DIR 会新建
record-schema-version = 其模式版本为 { $found }，本程序读取 { $known }
record-migrate = 任何写入命令都会将其更新：records recover
record-no-library = 不是 Seamwright 的记录库
record-other-folder = 其他数据文件夹
record-own-archive = 由 `records backup` 生成的归档
record-own-schema = 仅由 Seamwright 更改过的记录库归档；请先用 sqlite3 删除外来部分
record-schema-foreign = 记录库含有外来的 { $kind } `{ $name }`
record-schema-changed = 记录库的 { $kind } `{ $name }` 已被更改
record-schema-missing = 记录库缺少 { $kind } `{ $name }`
record-loose-row = 表 { $table } 中有一行引用了不存在的行
record-no-document = 文档 { $id } 不存在
record-no-alarm = 报警 { $id } 不存在
record-known-number = 记录库中的编号
record-no-weld = { $path }：焊接 { $id } 不存在
record-no-welds-yet = 暂无：尚无焊接记录
record-weld-damaged = 焊接 { $id }：{ $why }
record-whole-library = 未损坏的记录库
record-foreign-file = 它为焊接 { $id } 列出了 `{ $name }`，但这不是该焊接的文件
record-own-files = 焊接文件夹中的文件名
record-finite-numbers = 有限数

# Traces.
record-no-trace = 不是轨迹记录：{ $why }
record-own-parquet = 由 Seamwright 写入的 Parquet 文件
record-own-trace = 由 Seamwright 写入的轨迹记录
record-column-kind = 列 { $column } 的类型为 { $kind }
record-trace-groups = 行组超过 { $max } 行，或各列长度不一或为负
record-no-column = { $path }：列 { $column } 不存在
record-row-length = { $path }：一行有 { $n } 个值
record-value-per-column = { $n } 个，每列一个
record-trace-left = 此轨迹记录是崩溃后遗留的，或正在写入
record-recover-first = 请先恢复：seamwright records recover
record-trace-replaced = 写入时被删除或替换：其行已丢失
record-folder-untouched = 焊接结束前不要改动该文件夹
record-no-raw-trace = 不是原始轨迹记录，或其头部被截断
record-own-raw-trace = 由轨迹记录新建的文件

# Backup and restore.
record-folder-not-empty = { $path }：文件夹不为空
record-empty-folder = 空的或新的文件夹
record-archive-as-written = 未经更改的归档
record-manifest-missing = { $name }：缺失，而写入该归档的版本会写它
record-manifest-size = { $name }：{ $size }，过大
record-archive-changed = { $name }：备份后被更改、缺失或新增
record-archive-without-hashes = 归档没有哈希清单且有问题：{ $problem }
record-archive-problems = 内容有问题：{ $problem }（另有 { $more } 个问题）
record-restore-elsewhere = `seamwright records restore` 将其恢复到单独的文件夹
record-nothing-restored = 未恢复任何内容
record-checked-archive = 已检查的归档
record-archive-foreign = 其中的 { $name } 不属于备份
record-archive-outside = { $name } 指向归档之外
record-archive-entries = 文件和文件夹多于 { $max } 个
record-archive-fewer = 文件较少的数据文件夹
record-archive-name = 名称或其附加信息长于 { $max } KiB
record-archive-cut-off = 归档缺少末尾
record-archive-no-library = 归档中没有记录库

# Problems found by `records verify`.
record-problem-audit = 审计日志，条目 { $id }：{ $why }
record-audit-missing = 条目缺失
record-audit-hash = 哈希与该条目或前一条目不符
record-audit-cut-off = 此条目及其后的所有条目缺失
record-problem-lost = 焊接 { $id }：记录库丢失了其条目；文件在 { $folder }
record-problem-unfinished = 焊接 { $id }：其轨迹记录正在写入
record-problem-left = 焊接 { $id }：崩溃使其轨迹记录未完成；请运行 `records recover`
record-problem-program = 焊接 { $id }：其程序文本已被更改
record-problem-changed = { $path }：记录后被更改

# Notes of a weld.
record-notes = { $first }；{ $then }
record-interrupted = 中断：{ $cause }
record-log-damaged = 该焊接日志中有一行已损坏
record-rows-late = 磁盘太慢
record-rows-lost = 丢失 { $n } 行轨迹记录：{ $why }
record-incomplete = 记录不完整：{ $why }
record-no-figures = 没有统计值：{ $why }
record-heat-input-outside = 热输入在 { $length } 长度上超出焊接工艺规程
record-recovered = 已恢复 { $time }
record-recovered-without = 已恢复 { $time }，轨迹记录末尾 { $size } 不成完整的行，已舍弃
