# Reasons for a low confidence of a detected joint.
vision-doubt-clutter = many detected points are not on the joint's lines: reflections or spatter
vision-doubt-short = a part of the joint is seen in fewer than 30 columns: move the sensor nearer or across the whole joint
vision-doubt-uneven = a part of the joint is not straight: its points lie several rows off the line
vision-doubt-light = the stripe does not start and end with the joint's parts: dark places on them, light beyond their ends, or a hidden end
vision-doubt-shape = the shape is at the limit of this type of joint
vision-doubt-moved = the joint is far from its expected position
vision-doubt-unknown = a point or a value of the joint is unknown

# Reasons why no joint was detected.
vision-no-stripe = the image shows no stripe
vision-saturated = the image is saturated: shorten the exposure or reduce the light
vision-short-stripe = the stripe is seen in { $found } of { $columns } columns; a quarter is needed
vision-too-few-points = the profile has { $found } usable points; { $needed } are needed
vision-no-corner = no corner of two faces at 60° to 120° was found in the profile
vision-no-groove = no groove of this type was found between two shoulders
vision-no-step = no step was found between two parallel sheets
vision-no-seam = no gap, misalignment or dark line was found between two plates in line

# Reasons why a picture of a grid of dots gives no map.
vision-grid-pitch = a pitch of { $pitch }: allowed is a finite number greater than 0
vision-grid-plain = no dark dots: the picture is nearly uniform (the darkest spots are { $contrast } darker than their surroundings)
vision-grid-few-dots = dots of the grid found: { $found }; at least { $min } are needed, all over the picture
vision-grid-tangled = the dots do not form one grid: near ({ $x }, { $y }) rows and columns do not meet
vision-grid-corner = the dots cover { $part } of the picture's width or height; at least half is needed
vision-grid-residual = the dots deviate by { $rms } RMS from the best map; the maximum is { $max }: the picture shows another grid or is not sharp
vision-grid-map = the fit to the dots is an invalid map: { $why }

# Frames.
vision-frame-size = a frame of { $width } x { $height } pixels: allowed are sides of 1 to { $max } pixels
vision-frame-pixels = { $found } pixels for a frame of { $width } x { $height }; { $needed } are needed
