# Errors of curves, surfaces and their intersections.
geometry-size = { $what }必须是大于 0 的有限数，而不是 { $value }
geometry-range = { $what }必须大于 { $min } 且小于 { $max }，而不是 { $value }
geometry-too-small = { $what }必须是大于 { $min } 的有限值，而不是 { $value }
geometry-direction = { $what }必须是长度大于 0 的有限向量
geometry-parallel = { $first }与{ $second }平行
geometry-tube-larger-than-body = 管子比壳体大：管壁在任何角度都碰不到壳体
geometry-tube-beside-body = 管子从壳体旁经过，没有相交
geometry-not-closed = 管壁在 phi = { $from } 与 { $to } 之间没有碰到壳体：曲线不封闭
geometry-beyond-head = 管壁在 phi = { $from } 与 { $to } 之间超出封头直边端部
geometry-tangent = 管壁在 phi = { $angle } 处与壳体相切：曲线在该处没有切线
geometry-beside-trimming-tube = 从 phi = { $angle } 起，管壁从修剪它的管子旁经过
geometry-never-leaves = 管子方向指向壳体内部：沿 +direction 管子不会离开壳体
geometry-arc-length = 在参数 { $parameter } 附近，曲线长度无法求到 { $accuracy } 的精度
geometry-sharp-turn = { $what }在相邻两点之间转过 90° 或更多
geometry-gap = 链中第 { $piece } 段的起点不在前一段的终点
geometry-knots = 样条各值的位置必须严格递增（第 { $index } 个值）
geometry-column = 一列有 { $values } 个值，而有 { $points } 个点
geometry-point = 点 { $index } 的值过大或不是有限数

# Errors of fits to touched points.
geometry-too-few-points = 点太少（{ $what }）：给出 { $given } 个，至少需要 { $min } 个
geometry-points-in-one-position = { $what }的各点几乎重合：无法确定它
geometry-points-on-one-line = { $what }的各点几乎在一条直线上：无法确定它
geometry-short-arc = 圆只触碰了 { $touched }；至少需要 { $min }
geometry-attitudes-alike = 各姿态最多相差 { $angle }：无法确定工具中心点
geometry-no-fit = 没有找到工件与各点相符的位姿

# Motions that touched points leave free.
geometry-motion-along = 沿 { $direction } 的移动
geometry-motion-about = 绕轴的转动：沿 { $direction }，过 { $point } mm
geometry-motion-screw = 绕轴的转动：沿 { $direction }，过 { $point } mm，每转沿轴 { $pitch }

# Maps between pixels and a plane.
geometry-map-scale = 每像素 { $scale }：允许 { $min } 至 { $max }
geometry-map-shear = 剪切 { $shear }：允许 { $min } 至 { $max }
geometry-map-rotation = 旋转 { $rotation }：允许半圈以内的有限数
geometry-map-centre = 中心 ({ $x }, { $y }) 超出画面的距离大于画面尺寸
geometry-map-barrel = 畸变 { $barrel }：允许不超过 { $max }，且画面内图像不得折叠
geometry-heights-empty = 高度表没有行
geometry-heights-order = 第 { $row } 行：高度 { $height } 不大于前一行的高度
geometry-heights-frame-size = 第 { $row } 行：画面尺寸与第一行不同
geometry-heights-between = 第 { $row } 行与第 { $next } 行之间：{ $why }
geometry-height-outside = 高度 { $height }：相机的表为 { $min } 至 { $max }
geometry-pixel-folded = 像素 ({ $x }, { $y }) 超出图像畸变的有效范围

# Names of sets of points.
geometry-points-chain = 链
geometry-points-spline = 样条
geometry-points-frame = 坐标系
geometry-points-nominal-frame = 名义坐标系
geometry-points-measured-frame = 实测坐标系
geometry-points-plane = 平面
geometry-points-line = 直线
geometry-points-point = 点
geometry-points-origin = 原点
geometry-points-direction = 方向
geometry-points-circle = 圆
geometry-points-tube = 管子
geometry-points-surfaces = 曲面
geometry-points-tip = 工具中心点
geometry-points-taught-line = 示教线

# Names of sizes and directions.
geometry-tube-radius = 管子半径
geometry-tube-direction = 管子方向
geometry-tube-zero-direction = 管子的零方向
geometry-zero-direction = 其零方向
geometry-tube-origin = 管子原点
geometry-sphere-radius = 球半径
geometry-cylinder-radius = 圆柱半径
geometry-cylinder-axis = 圆柱轴线
geometry-elliptic-cylinder-semi-axis = 椭圆柱半轴
geometry-elliptic-cylinder-axis = 椭圆柱轴线
geometry-elliptic-cylinder-x-direction = 椭圆柱的 x 方向
geometry-ellipsoid-semi-axis = 椭球半轴
geometry-ellipsoid-axis = 椭球轴线
geometry-ellipsoid-x-direction = 椭球的 x 方向
geometry-x-direction = 其 x 方向
geometry-cone-axis = 圆锥轴线
geometry-cone-half-angle = 圆锥半角
geometry-torus-ring-radius = 圆环的中心圆半径
geometry-torus-tube-radius = 圆环的管半径
geometry-torus-axis = 圆环轴线
geometry-torus-centre = 圆环中心
geometry-body-position = 壳体位置
geometry-plane-normal = 平面法线
geometry-head-radius = 封头半径
geometry-head-depth = 封头深度
geometry-head-flange = 封头直边
geometry-head-axis = 封头轴线
geometry-crown-radius = 球冠半径
geometry-knuckle-radius = 过渡圆弧半径
geometry-wall-of-ellipsoid = 壁厚
geometry-line-length = 直线长度
geometry-arc-axis = 圆弧轴线
geometry-arc-radius = 圆弧半径
geometry-arc-angle = 圆弧角度
geometry-chord-to-via-point = 到中间点的直线
geometry-chord-to-end = 到终点的直线
geometry-helix-pitch = 螺旋线导程
geometry-turns = 圈数
geometry-width = 宽度
geometry-height = 高度
geometry-corner-radius = 圆角半径
geometry-rectangle-normal = 矩形法线
geometry-width-direction = 宽度方向
geometry-semi-axis-a = 椭圆半轴 a
geometry-semi-axis-b = 椭圆半轴 b
geometry-ellipse-normal = 椭圆法线
geometry-semi-axis-a-direction = 半轴 a 的方向
geometry-curve = 曲线
geometry-curve-through-points = 过各点的曲线
geometry-normal = 法线
geometry-face-normal = 面法线
geometry-tolerance = 公差
geometry-column-tolerance = 其他列的公差
