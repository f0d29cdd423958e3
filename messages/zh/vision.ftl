# Reasons for a low confidence of a detected joint.
vision-doubt-clutter = 许多检测点不在接缝轮廓线上：反光或飞溅
vision-doubt-short = 接缝的一部分只在不到 30 列中可见：将传感器移近或移到整个接缝上方
vision-doubt-uneven = 接缝的一部分不直：其点偏离直线数行
vision-doubt-light = 光条的起止与接缝各部分不一致：其上有暗点、端部之外有光，或端部被遮挡
vision-doubt-shape = 形状处于该接头类型的极限
vision-doubt-moved = 接缝远离预期位置
vision-doubt-unknown = 接缝的某个点或数值未知

# Reasons why no joint was detected.
vision-no-stripe = 图像中没有光条
vision-saturated = 图像过曝：缩短曝光或减弱光线
vision-short-stripe = 光条在 { $columns } 列中只有 { $found } 列可见；需要四分之一
vision-too-few-points = 轮廓有 { $found } 个可用点；需要 { $needed } 个
vision-no-corner = 轮廓中没有找到夹角为 60° 至 120° 的两面构成的角
vision-no-groove = 两侧表面之间没有找到该类型的坡口
vision-no-step = 两块平行板之间没有找到台阶
vision-no-seam = 两块共面板之间没有找到间隙、错边或暗线

# Reasons why a picture of a grid of dots gives no map.
vision-grid-pitch = 节距 { $pitch }：允许大于 0 的有限数
vision-grid-plain = 没有暗点：图像几乎均匀（最暗处仅比周围暗 { $contrast }）
vision-grid-few-dots = 找到网格点 { $found } 个；整个图像上至少需要 { $min } 个
vision-grid-tangled = 各点不构成同一网格：在 ({ $x }, { $y }) 附近行列不相交
vision-grid-corner = 各点只覆盖图像宽度或高度的 { $part }；至少需要一半
vision-grid-residual = 各点与最佳映射的均方根偏差为 { $rms }；最大允许 { $max }：图像不是该网格，或不清晰
vision-grid-map = 由各点拟合出的映射无效：{ $why }

# Frames.
vision-frame-size = { $width } x { $height } 像素的图像：边长允许 1 至 { $max } 像素
vision-frame-pixels = { $width } x { $height } 的图像给出 { $found } 个像素；需要 { $needed } 个
