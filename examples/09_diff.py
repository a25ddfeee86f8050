"""Compare two programs: what changes, and whether it matters."""

from motionlang import Source, diff, run

old = run(Source("old.mnt", "MOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"))
new = run(Source("new.mnt", "MOVER(0) = 300 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"))
print(diff(old, old).same)  # True
found = diff(old, new, "time=1ms")
print(found.same)  # False
print(*found.differences[0].a)  # axis 0 to 200 at 4472.14 '200.0000'
print(*found.differences[0].b)  # axis 0 to 300 at 5477.23 '300.0000'
