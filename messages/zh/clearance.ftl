# Sizes and poses of solids.
clearance-size = { $what }必须大于 0 且不超过 { $max }，而不是 { $value }
clearance-short-capsule = 胶囊体长度 { $length } 小于两端圆头之和 { $min }
clearance-too-far = 实体距原点 { $value }；最大允许 { $max }
clearance-not-rigid = 该位姿不是刚体运动
clearance-box-side = 长方体边长
clearance-radius = 半径
clearance-length = 长度
clearance-semi-axis = 半轴
clearance-capsule-allowed = 含圆头的总长：至少为半径的两倍
clearance-cone-allowed = 半径和长度不超过 { $max }，且有一个半径大于 0
clearance-sizes-allowed = 尺寸不超过 { $max }

# STL files and meshes.
clearance-file-unreadable = 无法读取文件：{ $why }
clearance-file-allowed = 已有的文件，路径相对于引用它的文件
clearance-not-stl = 这不是 STL 文件：{ $why }
clearance-stl-no-header = 开头既不是 `solid` 也不是二进制文件头
clearance-stl-corner = 第 { $line } 行：顶点必须有三个数
clearance-stl-facet = 第 { $line } 行：面片有 { $corners } 个顶点；需要三个
clearance-stl-word = 第 { $line } 行：未知的词 `{ $word }`
clearance-stl-cut-short = STL 文件不完整：{ $why }
clearance-stl-triangles-missing = { $count } 个三角形中只有 { $found } 个
clearance-stl-no-endsolid = { $count } 个三角形之后缺少 `endsolid`
clearance-corner-not-finite = 三角形 { $triangle } 有顶点坐标不是有限数
clearance-corner-too-far = 三角形 { $triangle } 有顶点距原点 { $distance } mm
clearance-no-triangles = 网格没有三角形
clearance-open-surface = 表面不封闭：{ $edges } 条边不是恰好有两个三角形，其中一条位于 { $point } mm
clearance-stl-whole-allowed = 完整的 STL 文件：请重新复制或导出
clearance-stl-closed-allowed = 封闭表面：补上孔洞，或将该体重新导出为一个实体；用包住它的简单长方体或圆柱也可以
clearance-stl-corners-allowed = 顶点距原点不超过 { $max }；用 `scale` 将其他单位换算为 mm
clearance-stl-finite-allowed = 有限坐标：请重新导出文件
clearance-stl-triangles-allowed = 至少有四个三角形围成一个体的文件
clearance-stl-allowed = STL 文件，ASCII 或二进制

# Watches of a scene.
clearance-no-such-group = 监视 { $watch } 引用了不存在的组 { $group }
clearance-unbounded-group = 监视 { $watch }：组 `{ $group }` 含半空间；此处必须有界
clearance-zone-shape = 监视 { $watch }：允许区域为长方体、圆柱、球或半空间
clearance-no-zone = 监视 { $watch } 没有允许区域
clearance-minimum = 监视 { $watch }：两组之间的最小距离必须大于 0，最小余量必须为有限数
clearance-limit = { $what }必须大于 0
clearance-cutoff = 截止距离
clearance-precision = 精度
clearance-smallest-cell = 最小单元
