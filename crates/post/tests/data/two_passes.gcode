(Seamwright {version} for grblHAL: Two passes by hand)
(machine: 5-axis machine with tilting rotary table [XYZAC])
(joint level: every word is an axis position, without transformations)
(axes: X = x [mm], Y = y [mm], Z = z [mm], A = a [degrees], C = c [degrees])
(units mm, degrees; absolute; inverse time feed G93)
(work offsets and tool offsets must be zero)
(to start again at pass N send the lines from N1000 times N on; the last pass is N2000)
(made by hand)
(MSG, clamp the part)
N1000 G21 G17 G90 G40 G49 G80 G94 (root)
G0 X10 Y0 Z50 A0 C0
G93
G1 Z0 F12
M64 P1 (gas on)
G4 P0.5 (preflow)
M67 E0 Q180.5 (current_a)
M62 P0 (arc on with the motion)
G17 G3 X0 Y10 C90 I-10 J0 F20
M67 E0 Q170 (current_a)
G18 G2 X5 Y12 Z5 I0 K5 F15
G4 P0 (exact stop)
G1 X6 C91 F48
M65 P0 (arc off)
M68 E0 Q0 (current_a off)
G4 P2
M65 P1 (gas off)
G1 Z50 F12
G94
N2000 G21 G17 G90 G40 G49 G80 G94 (cap [last])
G0 X10 Y-0.5 Z50 A0 C91
M64 P3
M63 P3
G93
G1 X20 F30
G1 X30 C0 F30
G94
M2
