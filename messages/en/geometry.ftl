# Errors of curves, surfaces and their intersections.
geometry-size = { $what } must be a finite number greater than 0, not { $value }
geometry-range = { $what } must be more than { $min } and less than { $max }, not { $value }
geometry-too-small = { $what } must be finite and more than { $min }, not { $value }
geometry-direction = { $what } must be a finite vector with a length greater than 0
geometry-parallel = { $first } and { $second } are parallel
geometry-tube-larger-than-body = the tube is larger than the body: its wall misses the body at every angle
geometry-tube-beside-body = the tube passes beside the body and does not meet it
geometry-not-closed = the tube's wall misses the body between phi = { $from } and { $to }: the curve does not close
geometry-beyond-head = the tube's wall is beyond the end of the head's flange between phi = { $from } and { $to }
geometry-tangent = the tube's wall is tangent to the body at phi = { $angle }: the curve has no tangent there
geometry-beside-trimming-tube = from phi = { $angle } on, the tube's wall passes beside the tube that trims it
geometry-never-leaves = the tube's direction points into the body: the tube does not leave the body along +direction
geometry-arc-length = the curve's length could not be determined to { $accuracy } near parameter { $parameter }
geometry-sharp-turn = { $what } turns by 90° or more from one point to the next
geometry-gap = piece { $piece } of the chain does not start at the end of the piece before it
geometry-knots = positions of a spline's values must increase strictly (value { $index })
geometry-column = a column has { $values } values for { $points } points
geometry-point = point { $index } has a value that is too large or not finite

# Errors of fits to touched points.
geometry-too-few-points = too few points of { $what }: { $given } given, at least { $min } needed
geometry-points-in-one-position = the points of { $what } nearly coincide: they do not define it
geometry-points-on-one-line = the points of { $what } lie nearly on one line: they do not define it
geometry-short-arc = the circle was touched over { $touched } only; at least { $min } are needed
geometry-attitudes-alike = the attitudes differ by { $angle } at most: they do not determine the tool centre point
geometry-no-fit = no pose was found in which the part fits the points

# Motions that touched points leave free.
geometry-motion-along = moving along { $direction }
geometry-motion-about = turning about the axis along { $direction } through { $point } mm
geometry-motion-screw = turning about the axis along { $direction } through { $point } mm, { $pitch } along it per turn

# Maps between pixels and a plane.
geometry-map-scale = a pixel of { $scale }: allowed are { $min } to { $max }
geometry-map-shear = a shear of { $shear }: allowed is { $min } to { $max }
geometry-map-rotation = a rotation of { $rotation }: allowed is a finite number within half a turn
geometry-map-centre = the centre ({ $x }, { $y }) lies outside of the frame by more than the frame's size
geometry-map-barrel = a barrel of { $barrel }: allowed is at most { $max }, and no fold of the picture within the frame
geometry-heights-empty = the table of heights has no rows
geometry-heights-order = row { $row }: the height { $height } is not above the height of the row before
geometry-heights-frame-size = row { $row }: the frame's size differs from the first row
geometry-heights-between = between rows { $row } and { $next }: { $why }
geometry-height-outside = a height of { $height }: the camera's table goes from { $min } to { $max }
geometry-pixel-folded = the pixel ({ $x }, { $y }) is beyond the range of the picture's distortion

# Names of sets of points.
geometry-points-chain = the chain
geometry-points-spline = the spline
geometry-points-frame = the frame
geometry-points-nominal-frame = the nominal frame
geometry-points-measured-frame = the measured frame
geometry-points-plane = the plane
geometry-points-line = the line
geometry-points-point = the point
geometry-points-origin = the origin
geometry-points-direction = the direction
geometry-points-circle = the circle
geometry-points-tube = the tube
geometry-points-surfaces = the surfaces
geometry-points-tip = the tool centre point
geometry-points-taught-line = the taught line

# Names of sizes and directions.
geometry-tube-radius = the tube's radius
geometry-tube-direction = the tube's direction
geometry-tube-zero-direction = the tube's zero direction
geometry-zero-direction = its zero direction
geometry-tube-origin = the tube's origin
geometry-sphere-radius = the sphere's radius
geometry-cylinder-radius = the cylinder's radius
geometry-cylinder-axis = the cylinder's axis
geometry-elliptic-cylinder-semi-axis = the elliptic cylinder's semi-axis
geometry-elliptic-cylinder-axis = the elliptic cylinder's axis
geometry-elliptic-cylinder-x-direction = the elliptic cylinder's x direction
geometry-ellipsoid-semi-axis = the ellipsoid's semi-axis
geometry-ellipsoid-axis = the ellipsoid's axis
geometry-ellipsoid-x-direction = the ellipsoid's x direction
geometry-x-direction = its x direction
geometry-cone-axis = the cone's axis
geometry-cone-half-angle = the cone's half angle
geometry-torus-ring-radius = the torus' ring radius
geometry-torus-tube-radius = the torus' tube radius
geometry-torus-axis = the torus' axis
geometry-torus-centre = the torus' centre
geometry-body-position = the body's position
geometry-plane-normal = the plane's normal
geometry-head-radius = the head's radius
geometry-head-depth = the head's depth
geometry-head-flange = the head's flange
geometry-head-axis = the head's axis
geometry-crown-radius = the crown's radius
geometry-knuckle-radius = the knuckle's radius
geometry-line-length = the line's length
geometry-arc-axis = the arc's axis
geometry-arc-radius = the arc's radius
geometry-arc-angle = the arc's angle
geometry-chord-to-via-point = the line to the via point
geometry-chord-to-end = the line to the end
geometry-helix-pitch = the helix's pitch
geometry-turns = the number of turns
geometry-width = the width
geometry-height = the height
geometry-corner-radius = the corner's radius
geometry-rectangle-normal = the rectangle's normal
geometry-width-direction = the direction of the width
geometry-semi-axis-a = the ellipse's semi-axis a
geometry-semi-axis-b = the ellipse's semi-axis b
geometry-ellipse-normal = the ellipse's normal
geometry-semi-axis-a-direction = the direction of semi-axis a
geometry-curve = the curve
geometry-curve-through-points = the curve through the points
geometry-normal = the normal
geometry-face-normal = a face's normal
geometry-tolerance = the tolerance
geometry-column-tolerance = the tolerance of further columns
