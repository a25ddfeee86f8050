"""Sample the motion as a structured array of NumPy."""

import motionlang

text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"
rows = motionlang.run(motionlang.Source("feed.mnt", text)).trace(
    rate=100, quantities=["position", "velocity"]
)
print(rows.dtype.names)  # ('time_s', 'axis0_position_uu', 'axis0_velocity_uu_per_s')
print(f"{rows['axis0_position_uu'][-1]:.3f}")  # 200.000
print(f"{rows['axis0_velocity_uu_per_s'].max():.3f}")  # 100.000
