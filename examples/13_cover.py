"""See which lines of a program no run reaches."""

import motionlang

text = "If INX(1) Then\n  OUTX(2) = 1\nEnd If\nPRINT OUTX(2)\n"
found = motionlang.cover(motionlang.Source("lamp.mnt", text))
print(f"{found.reached} of {found.total}")  # 3 of 5
for line, why in found.missed.items():
    print(line, why)  # 1 never true: INX(1)
    break
