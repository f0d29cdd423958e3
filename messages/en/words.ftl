# Words by names in files: the part behind the first hyphen is the name.

# Process values, without their units.
value-heat-input = Heat input
value-tip-speed = Torch-tip speed
value-current = Current
value-voltage = Voltage
value-wire-feed = Wire feed
value-power = Power
value-beam-current = Beam current
value-accelerating = Accelerating voltage
value-beam = Beam current
value-frequency = Frequency
value-focus = Focus
value-gas = Gas
value-laser = Laser power
value-speed = Welding speed
value-travel-angle = Travel angle
value-work-angle = Work angle
value-stick-out = Stick-out
value-preheat = Preheat
value-interpass = Interpass temperature

# Deviations.
track-lateral = Lateral
track-height = Height

# Welding processes, by their numbers in ISO 4063.
process-111 = manual metal arc welding
process-114 = self-shielded tubular cored arc welding
process-121 = submerged arc welding with solid wire
process-131 = MIG welding with solid wire
process-135 = MAG welding with solid wire
process-136 = MAG welding with flux cored wire
process-138 = MAG welding with metal cored wire
process-141 = TIG welding with solid filler
process-142 = TIG welding without filler
process-15 = plasma arc welding
process-51 = electron beam welding
process-52 = laser beam welding
