# Positions on the weld, and torch angles.
weld-position-beside-weld = 该位置不在焊缝上
weld-positions-must-increase = 位置必须递增
weld-without-length = 焊缝没有长度
weld-angles-twice = 角度既给了常数，又在多个位置给出
weld-travel-angle-too-large = 焊枪会沿焊缝平躺
weld-work-angle-too-large = 焊枪会位于表面背后
weld-torch-search-too-wide = 焊枪角度的搜索范围超出焊枪能力
weld-stick-out-range = 没有焊枪能以此干伸长焊接
weld-stick-out-of-machine = 机床焊枪的干伸长未知，因此无法为其他干伸长后移焊枪
weld-stick-out-above-search = 搜索无法把干伸长增加到该值：未搜索时已为 { $own }
weld-allowed-stick-out = 机床文件 [torch] 中的 `stick_out_mm`：导电嘴与焊枪尖端之间的焊丝长度
weld-min-speed-too-high = 最低速度不低于焊接速度
weld-speed-below-min = 焊接速度不高于最低速度
weld-value-ramps-already = 该值已在整条焊缝上渐变

# Allowed values of these.
weld-allowed-from-less-than = 不小于 { $min }，小于 { $max }
weld-allowed-positions-increasing = 递增的位置
weld-allowed-path-lengths-increasing = 递增的路径长度
weld-allowed-seam-with-length = 有长度的焊缝
weld-allowed-angles-once = 常数角度或 [[torch.at]]
weld-allowed-travel-angle = { $min }（推焊）至 { $max }（拖焊）
weld-allowed-number-or-no-value = [weld.process] 中的一个数，或此处不写
weld-allowed-less-than-key = 小于 { $key } = { $value }
weld-allowed-more-than-key = 大于 { $key } = { $value }
weld-allowed-positive-less-than-key = 大于 0 且小于 { $key } = { $value }
weld-allowed-positive-less-than-half-key = 大于 0 且小于 { $key } = { $value } 的一半
weld-allowed-not-along = 不沿 `{ $key }`
weld-allowed-other-point = 不同于 `{ $key }` 的点
weld-allowed-schema = 相互匹配的尺寸（见任务文件的格式说明）

# Bodies that nozzles stand on.
weld-body-cylinder = 圆柱，半径 { $radius }
weld-body-cone = 圆锥，半角 { $angle }
weld-body-sphere = 球，半径 { $radius }
weld-body-ellipsoid = 椭球，半轴 { $a }、{ $b }、{ $c }
weld-body-plane = 平面，法线指向板外
weld-body-torus = 弯管，管半径 { $radius }
weld-body-torispherical-head = 碟形封头，外径 { $diameter }
weld-body-ellipsoidal-head = 椭圆封头，外径 { $diameter }
weld-body-hemispherical-head = 半球形封头，外径 { $diameter }
weld-body-flat-head = 平封头，外径 { $diameter }
weld-body-conical-head = 锥形封头，外径 { $diameter }
weld-body-inside = 壁的内面；外面：{ $body }
weld-allowed-nozzle-fits = 能安放在壳体上的接管：{ $body }
weld-allowed-nozzle-axis = 与壳体相交的轴线：{ $body }
weld-allowed-nozzle-on-body = 半径和轴线应使整个管壁（半径 { $radius }）落在壳体上：{ $body }
weld-allowed-nozzle-on-head = 整个管壁（半径 { $radius }）落在封头及其直边上的接管：{ $body }
weld-allowed-nozzle-smaller = 比壳体小的接管：{ $body }
weld-allowed-nozzle-direction = 指向壳体外的方向：{ $body }
weld-cone-angle-too-large = 圆锥的半角太大
weld-torus-meets-itself = 管子会在弯头中部自相交
weld-set-in-wall-missing = 接管为插入式：缺少壳体壁厚
weld-set-on-root-wall-missing = 安放式接管的根部在其内孔处：缺少其壁厚
weld-wall-leaves-no-room = 壁厚没有留下内部空间
weld-wall-leaves-no-bore = 壁厚没有留下内孔
weld-knuckle-too-large = 内半径 { $radius } 的过渡段放不进直边
weld-allowed-knuckle = 过渡段内半径小于直边内半径 { $max }
weld-head-radii-missing = 缺少球冠和过渡段的半径
weld-allowed-head-radii = `standard`（"din_28011"、"din_28013" 或 "asme_fd"），或同时给出 `crown_radius_mm` 和 `knuckle_radius_mm`
weld-crown-too-curved = 球冠不比半球更平
weld-allowed-crown = 大于直边内半径 { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = 支管沿主管方向
weld-branch-wider-than-chord = 支管不比主管细
weld-branch-past-chord = 支管壁超出主管
weld-branches-do-not-part = 两支管平行或相撞
weld-branch-position-missing = 缺少另一支管的位置
weld-branch-position-twice = 另一支管的位置给出了两次
weld-allowed-tube = 管子
weld-allowed-tubes-meet = 管壁全周相接：更小的支管，或更小的搭接
weld-allowed-other-branch-angle = 第一支管为 { $first } 时小于 { $max }，使轴线分开
weld-allowed-gap-or-offset = `gap_mm`（两支管趾部之间，搭接时为负）和 `offset_mm`（轴线之间）恰好一个
weld-allowed-branch-within-chord = 支管在主管之内
weld-allowed-eccentricity = 大于 { $min } 且小于 { $max }：chord_radius_mm - radius_mm
weld-cut-along-tube = 切面沿管方向：其法线偏离轴线 { $angle }
weld-allowed-cut-angle = 偏离 `direction` 不超过 { $max }
weld-allowed-other-plane = 另一个平面

# Shapes of seams.
weld-seam-too-long = 焊缝长度将为 { $length }
weld-allowed-smooth-seam = 光滑焊缝
weld-zero-direction-along-normal = 零方向沿法线
weld-arc-normal-off = 三点所在平面偏离此法线 { $angle }
weld-allowed-arc-normal = 垂直于该平面：{ $normal } 或其反向
weld-allowed-point-off-line-or-line-seam = 偏离起点到终点直线的点；直焊缝用 [seam.line]
weld-allowed-point-off-line = 偏离起点到终点直线的点，或不写此键
weld-corner-radius-too-large = 圆角半径大于短边的一半
weld-point-count = 焊缝有 { $count } 个点
weld-allowed-point-count = { $min } 至 { $max } 个点，写在此处或 `file` 中
weld-point-above-plate = 该点高出板面 { $height }
weld-point-below-plate = 该点低于板面 { $height }
weld-allowed-point-in-plane = 过第一点、法线为 `normal` 的平面内的点
weld-point-repeated = 该点与前一点重合
weld-last-point-repeated = 最后一点与第一点重合；没有它焊缝也封闭
weld-spline-point-repeated = 点 { $point } 与前一点重合
weld-spline-last-point-repeated = 最后一点 { $point } 与第一点重合；没有它焊缝也封闭
weld-allowed-points-apart = 位置不同的点
weld-allowed-points-apart-by = 点间距至少 { $min }
weld-allowed-leave-point-out = 省略该点
weld-allowed-other-points = 其他点
weld-normal-not-square = 面的法线不垂直于焊缝
weld-allowed-square-to-line = 垂直于 end_mm - start_mm
weld-faces-opposed = 两面相对：没有可达的接头
weld-spline-faces-opposed = 点 { $point }：两面相对，没有可达的接头
weld-allowed-not-opposite = 不与 `{ $key }` 相反
weld-helix-without-pitch = 没有螺距的螺旋线是圆
weld-allowed-pitch = 不为 0；绕管的焊缝用 [seam.girth]
weld-helix-too-long = 螺旋线圈数太多
weld-allowed-less-turn = 相邻点之间更小的转角
weld-allowed-normals-less-turn = 相邻点之间转角小于 90° 的法线
weld-normal-along-seam = 某处面的法线沿焊缝方向
weld-allowed-normals-across = 横向于焊缝的法线
weld-closed-seam-has-no-ends = 封闭焊缝没有端点
weld-allowed-no-key-closed = `closed = true` 时没有此键
weld-tangent-backwards = 切线背向焊缝的下一点
weld-allowed-welding-direction = 沿焊接方向
weld-normal-count = { $points } 个点有 { $normals } 条法线
weld-allowed-one-per-point = 每个点一个
weld-second-normals-alone = `second_normals` 需要 `first_normals`
weld-allowed-first-normals-too = 同时给出 `first_normals`
weld-normal-twice = 每个点已有自己的法线
weld-allowed-one-or-all-normals = 一条法线，或每个点一条
weld-allowed-other-normals = 其他法线
weld-skin-normal-along-web = 蒙皮法线沿腹板方向
weld-allowed-out-of-skin = 指向蒙皮之外的方向
weld-allowed-thin-web = 厚度远小于圆弧半径的腹板
weld-seam-without-surfaces = { $seam }没有可拟合点的表面
weld-seam-curved-t-joint = 弯曲的 T 形接头
weld-seam-arc = 圆弧
weld-seam-rectangle = 矩形
weld-seam-helix = 螺旋线
weld-seam-inside-girth = 管内环缝
weld-seam-spline = 样条
weld-seam-polyline = 折线
weld-allowed-fit-methods = 方法 three-point 和 plane-line-point

# Start and end of the weld.
weld-phi-too-large = 角度超过十圈
weld-overlap-with-end = 在 `end_phi_deg` 结束的焊缝不封闭，没有搭接
weld-allowed-overlap-or-end = `overlap_mm` 或 `end_phi_deg`
weld-end-beside-turn = 焊缝会没有长度，或超过一圈
weld-allowed-end-phi-more = 大于 phi_deg = { $start }，最多大 { $max }
weld-allowed-end-phi-less = 小于 phi_deg = { $start }，最多小 { $max }
weld-overlap-too-long = 搭接比焊缝还长
weld-start-at-first-point = 此焊缝从第一点开始，走向第二点
weld-allowed-points-in-other-order = 没有此键；按另一顺序给出点
weld-start-of-open-seam = 此焊缝从一端到另一端，不封闭
weld-allowed-no-key-on-open-seam = 开放焊缝没有此键

# Data outside the file.
weld-no-machine-here = 此处没有可用的机床
weld-allowed-tip-coordinates = 尖端坐标 x_mm、y_mm、z_mm
weld-no-files-here = 此处没有可用的文件
weld-points-twice = 点给出了两次
weld-allowed-points-or-axes = `points_mm` 或 `axes`
weld-position-not-finite = 位置不是有限值
weld-allowed-finite-numbers = 有限数
weld-file-and-points = 同时给出了文件和 `{ $key }`
weld-allowed-points-in-file-or-job = 点及其法线在文件中，或在任务中
weld-table-point-not-finite = { $file }：点 { $point } 不是有限值
weld-table-normal-without-length = { $file }：点 { $point } 的法线没有长度
weld-allowed-coordinates-and-normals = 有限坐标，且法线有长度
weld-procedure-unreadable = 工艺文件无法读取：{ $error }
weld-allowed-procedure = { $names }，或相对任务文件夹的工艺文件路径
weld-procedure-not-text = 这不是文本文件
weld-allowed-toml = UTF-8 编码的 TOML 文件
weld-wrong-wire = { $procedure } 使用 { $wire } 的焊丝
weld-two-wires = `{ $other }` 为 { $wire }：焊丝只有一个直径
weld-allowed-wire = { $wire }，或另一份工艺规程

# Taught spans.
weld-taught-spans-overlap = 该区段在前一段结束之前开始
weld-allowed-taught-from = { $min } 或更大；区段按焊接顺序
weld-taught-span-without-length = 区段没有长度
weld-taught-span-beyond-seam = 区段在标称焊缝之外结束
weld-taught-span-without-points = 接点之间没有点
weld-allowed-taught-points = 至少一个，在 `points_mm` 或 `axes` 中
weld-allowed-smooth-points = 点间距更大，或更接近一条光滑曲线
weld-taught-point-far = 点 { $point } 距接点之间的标称焊缝 { $distance }
weld-allowed-taught-within = { $key } = { $value }；如果工件确实偏离这么远，则用更大的 `{ $key }`
weld-taught-point-out-of-order = 点 { $point } 沿焊缝位于 s = { $s }
weld-allowed-taught-after-join = 在第一个接点 { $min } 之后、第二个接点 { $max } 之前
weld-allowed-taught-after-point = 在前一点 { $min } 之后、第二个接点 { $max } 之前
weld-taught-point-repeated = 点 { $point } 与相邻的点或接点重合
weld-allowed-taught-apart = 点和接点间距至少 { $min }
weld-taught-curve-turns = 在点 { $point } 附近，过各点的曲线偏离焊缝 { $angle }
weld-allowed-taught-turn = 不超过 { $max }：点间距更大，或更接近一条光滑曲线

# Passes.
weld-pass-begins-beyond-end = 焊道从焊缝终点之后开始
weld-pass-round-more-than-twice = 焊道在同一位置绕焊缝超过两圈
weld-pass-beyond-end = 焊道越过焊缝终点
weld-pass-beyond-start = 焊道退到焊缝起点之前
weld-pass-without-seam = 焊道没有可沿行的焊缝
weld-travel-too-long = { $pass }：行走将持续 { $time }
weld-allowed-travel-time = 不超过 { $max }：更高的速度
weld-bead-rows-too-short = 各行没有覆盖整个焊道
weld-pass-without-motion = 此焊道中没有运动
weld-allowed-point-elsewhere = 别处的点
weld-arc-points-in-line = 圆弧起点、`via_mm` 和终点在一直线上，或其中两点重合
weld-allowed-arc-points = 不在一直线上的三点；整圆为两段圆弧

# Findings of passes.
weld-torch-inside-first-face = 焊枪会进入第一件表面 { $angle }（二面角 { $dihedral }）
weld-torch-inside-second-face = 焊枪会进入第二件表面 { $angle }（二面角 { $dihedral }）
weld-cure-smaller-work-angle = 使工作角小于二面角的一半
weld-bead-goes-back = 焊道会（几乎）停住或倒退：它在焊缝弯曲中心之外，或其各行变化太快
weld-cure-bead-nearer = 在此处将焊道靠近焊缝
weld-bead-area-out-of-range = 填满坡口时焊道需 { $area }，为其设定面积 { $run } 的 { $ratio }；允许 { $min } 至 { $max }
weld-cure-thinner-layers = 更薄的层、更大的焊道（面积、送丝、更低速度），adapt = "passes"，或更大的 most_percent
weld-cure-smaller-beads = 更小的焊道（更高速度、更少焊丝），adapt = "passes"，或更大的 most_percent
weld-bead-width-out-of-window = 焊道宽 { $width }、高 { $height }；允许宽度 { $min } 至 { $max }
weld-bead-height-out-of-window = 焊道高 { $height }、宽 { $width }；允许高度 { $min } 至 { $max }
weld-bead-ratio-out-of-window = 焊道宽 { $width }、高 { $height }，宽高比 { $ratio }；允许 { $min } 至 { $max }
weld-bead-too-wide-without-weave = 不摆动时焊道宽 { $width }、高 { $height }；允许不超过 { $max }
weld-bead-toe-steep = 盖面焊趾角为 { $angle }；允许 { $min } 或更大
weld-layer-height-not-kept = 层高 { $height }，而不是 { $wanted }：{ $area } 的焊道填充结果不同
weld-cure-bead-window = 改变 layer_mm 或该道的面积（速度、送丝），adapt = "passes"，或工艺规程中的范围
weld-cure-weave-or-smaller-beads = 给该道加摆动，或更小的焊道（更高速度、更少焊丝）
weld-cure-bead-toe = 减小 cap_mm，使 spacing_to_width 更接近 2/3，或采用更平的盖面焊道（摆动、更小面积）
weld-cure-layer-height = 使 layer_mm 接近此高度，或改变该道的面积（速度、送丝）

# Joints.
weld-groove-at = 在 s = { $s } 处：{ $why }
weld-remaining-area-impossible = 坡口没有这么大的敞开面积
weld-scan-after-last-layer = 到此只规划了 { $layers } 层：没有剩余的层可用于此测量
weld-scan-too-few-points = 只有 { $found } 个点；需要 { $needed } 个
weld-scan-no-groove = 没有坡口：{ $share } % 的点在其上，离散 { $scatter } mm
weld-scan-other-angle = 表面或边缘成 { $angle }；图纸上为 { $drawn }
weld-scan-uncertain = 敞开面积的不确定度为 { $uncertainty }：有一条边缘看不到
weld-groove-no-butt = 相互成 { $dihedral } 的两面不构成对接接头
weld-groove-no-corner = 相互成 { $dihedral } 的两面不构成角接或 T 形接头
weld-groove-no-outside-corner = 两面夹角 { $dihedral } 不构成外角接头
weld-groove-edge-within-part = 坡口面与另一件表面成 { $angle }，不会穿出本件：二面角为 { $dihedral }
weld-groove-edge-in-other-part = 切口与另一件表面成 { $angle }：边缘会进入该件内部
weld-groove-edges-cross = 两边相交
weld-groove-empty = 坡口没有面积
weld-standard-of-other-joints = { $standard } 规定的是其他接头
weld-joint-beside-standard = s = { $s } 处{ $size }为 { $value }：{ $standard } 对该坡口规定 { $min } 至 { $max }
weld-joint-below-standard = s = { $s } 处{ $size }为 { $value }：{ $standard } 对该接头规定不小于 { $min }
weld-joint-beside-standard-at-dihedral = s = { $s } 处{ $size }为 { $value }：二面角为 { $dihedral } 时 { $standard } 规定 { $min } 至 { $max }
weld-size-thickness = 板厚
weld-size-groove-angle = 坡口角度
weld-size-root-gap = 根部间隙
weld-size-root-face = 钝边
weld-size-cover-throat = 盖面角焊缝厚度
weld-cure-joint-standard = 修改坡口，或用该坡口做工艺评定
weld-allowed-butt-dihedral = 二面角 { $min } 或更大，或角焊缝
weld-allowed-corner-dihedral = 二面角不超过 { $max }，或对接接头
weld-allowed-outside-corner = 二面角在 { $min } 与 { $max } 之间（焊缝的 joint = "corner"）
weld-allowed-edge-cut = 处处大于 90° 减二面角
weld-allowed-larger-gap = 更大的间隙，或更小的错边
weld-allowed-room-to-weld = 留出焊接空间的间隙或角度

# Beads.
weld-beads-without-joint = 没有要填充的接头
weld-allowed-joint = 带坡口的 [joint]
weld-stations-with-beads = 有 [beads] 时，数值写在 [beads.root]、[beads.fill] 和 [beads.cap] 中
weld-sector-position-unclear = 扇区位置不明确
weld-sectors-unequal = 各扇区给出的系数不是同一些量
weld-sectors-at-one-place = s = { $s } 处有两个扇区
weld-feed-follows-area = 送丝速度随坡口面积变化
weld-allowed-s-or-phi = s_mm 或 phi_deg 之一
weld-allowed-same-factors = 与第一行相同的名称
weld-allowed-sectors-apart = 不同的位置
weld-allowed-no-feed-factor = 不给它系数，或用别的 adapt
weld-allowed-no-table-or-beads = 没有此表，或没有 [beads]
weld-ramp-with-beads = 沿焊缝渐变的值不能与 [beads] 并用
weld-travel-angle-twice = 行走角在此处和焊缝多个位置都已给出
weld-allowed-travel-angle-once = 没有此键，或没有 [[torch.at]]
weld-area-with-wire-feed = 给定的面积不随送丝变化
weld-allowed-no-area-with-wire-feed = adapt = "wire_feed" 时没有此键
weld-bead-area-missing = 缺少焊道面积
weld-insert-without-root = 嵌条需要一道将其熔化的打底焊道
weld-allowed-insert-root = [beads] 中的 `root`，或不用嵌条
weld-allowed-bead-area = area_mm2，或 beads.wire_mm 和 wire_feed_m_min
weld-bead-area-needs-steady-feed = 焊道面积需要恒定送丝
weld-allowed-steady-feed = [weld.process] 或此处 wire_feed_m_min 大于 0，或 area_mm2
weld-deposition-too-large = 焊道的金属会比焊丝还多
weld-bead-range-too-large = 焊道在这样的范围内不能保持形状
weld-wall-tilt-too-large = 焊丝会贴在壁上
weld-step-over-needs-closed-seam = 过渡到下一焊道需要整圈焊接的焊缝
weld-wire-implausible = 没有直径 { $wire } 的焊丝
weld-step-over-too-short = 过渡太短，焊枪会横穿焊缝
weld-step-over-too-long = 过渡长度超过焊缝的一半
weld-step-over-with-alternate = 由过渡连接的焊道方向必须相同
weld-step-over-with-passes = 只覆盖部分焊缝的焊层不能由过渡连接
weld-step-over-with-parts = 带过渡的焊道不能分段焊接
weld-allowed-no-step-over = 不用过渡，或整圈焊接的焊缝
weld-station-distance-invalid = 无效的截面间距
weld-no-bead-weaves = 没有摆动的焊道
weld-allowed-weave = [weld.weave]，[beads.root]、[beads.fill] 或 [beads.cap] 中的 `weave`，或其他值
weld-bead-spacing-invalid = 焊道不能相距这么远或这么近
weld-layer-height-impossible = { $area } 的焊道不能形成这样高的层
weld-too-many-beads = 面积 { $groove } 的坡口需要 { $beads } 道 { $bead } 的焊道
weld-too-many-stations = 焊道将在 { $count } 个截面上布置
weld-too-many-bead-positions = { $passes } 个焊道、每个 { $rows } 行，太多
weld-allowed-larger-beads = 更大的焊道：更低速度或更多焊丝；一个坡口最多 { $max } 道
weld-allowed-smaller-groove = 不超过 { $max } 道：更小的坡口，或更大的焊道
weld-allowed-stations = 不超过 { $max } 个截面：更大的间距
weld-allowed-bead-positions = 不超过 { $max } 个位置：更大的间距，或更大的焊道

# Order of welding: copies, parts, tacks.
weld-order-without-rows = 没有可在其间往返的行
weld-allowed-two-rows = 两行：[rows]，或每个 [[copies]] 中的 `row`
weld-skip-invalid = 这样不跳过任何副本，或跳过全部
weld-allowed-no-skip = 不跳过：一行中的副本太少
weld-allowed-skip = 2 至 { $max }：最长的一行有 { $copies } 个副本
weld-copies-twice = 副本给出了两次
weld-allowed-rows-or-copies = [rows] 或 [[copies]]
weld-too-many-passes = 共 { $passes } 个焊道，太多
weld-allowed-passes = 不超过 { $max }：更少的副本或定位焊，或更少或更长的分段
weld-too-many-rows = { $passes } 个焊道共 { $rows } 行焊道和区段数据，太多
weld-allowed-row-count = 不超过 { $max } 行：更少的副本或定位焊，更少或更长的分段，或更大的 beads.station_mm
weld-copy-count-invalid = 无效的副本数
weld-too-many-copies = 副本太多
weld-allowed-columns = 1 至 { $max }：共 { $copies } 个副本
weld-copies-coincide = 副本会在同一位置
weld-allowed-row-step = 偏离行线的步长，或超出其末端
weld-copy-too-far = 有副本离得太远
weld-allowed-copies-within = 距 0 不超过 { $limit } 的副本
weld-seam-without-corners = 焊缝没有拐角
weld-overlap-at-corners = 从拐角到拐角的分段没有搭接
weld-allowed-no-overlap-at-corners = order.parts = "at_corners" 时为 0
weld-seam-without-quarters = 不整圈焊的焊缝没有对置的四分段
weld-pieces-longer-than-weld = 各段会比焊缝还长
weld-too-many-pieces = 段数太多
weld-allowed-piece-length = 至少 { $min }：最多 { $count } 段
weld-tie-in-too-long = 搭接长度不小于分段长度
weld-allowed-tie-in = 小于一个分段：{ $max }
weld-all-round-has-one-end = 整圈焊的焊缝在起点结束
weld-cosmetic-ramp = 盖面修饰道为恒定值
weld-cosmetic-beyond-end = 盖面修饰道从焊缝终点之后开始
weld-tack-count-or-pitch = 定位焊数恰由两个键之一决定
weld-allowed-count-or-pitch = `count` 或 `pitch_mm`
weld-tack-count-invalid = 无效的定位焊数
weld-tack-ramp = 定位焊为恒定值
weld-too-many-tacks = 定位焊太多
weld-allowed-tack-pitch = 至少 { $min }：最多 { $count } 个定位焊
weld-tacks-meet = 定位焊会连在一起
weld-allowed-tack-length = 小于相邻定位焊的距离：{ $length } 焊缝上 { $count } 个
weld-tacks-near-start = 定位焊会从焊缝起点 { $distance } 处开始
weld-allowed-tack-clearance = 不超过 { $max }，或更少的定位焊

# The part as solids.
weld-part-replaced-by-nothing = 由焊缝生成的工件已被替换，但没有给出实体
weld-allowed-part-solids = 同时给出 [[part.solids]]，或不写此键
weld-allowed-rigid-placement = 刚性安放
weld-body-too-short = 壳体会在焊缝范围内结束
weld-part-from-seam = 由焊缝生成的工件：{ $why }
weld-allowed-part-sizes = 尺寸不超过 { $max }，[part] 中的也是；或 [[part.solids]] 并设 part.replace = true
weld-allowed-sphere = 球
