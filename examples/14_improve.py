"""Find a shorter cycle within the limits of the machine."""

import motionlang

text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"
limits = {"axis.0.limits.speed": 250.0, "axis.0.limits.acceleration": 2000.0}
found = motionlang.improve(motionlang.Source("feed.mnt", text), machine=limits, by=0.4)
print(f"{found.before:.1f} s, {found.after:.1f} s")  # 2.1 s, 1.1 s
for edit in found.edits:
    print(edit.literal.address, edit.value)  # SPEED[0]@1 250.0
