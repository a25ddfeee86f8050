"""Certify the limits of a machine, and verify the motion.

The proof compares the motion with the commanded limits.
"""

from motionlang import Source, certify, prove, run

text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"
result = run(Source("feed.mnt", text), machine={"axis.0.limits.speed": 125.0}, prove=True)
for limit in certify(result):
    print(limit.name, limit.verdict, f"{limit.margin:.0%} left")  # speed within 20% left
print(prove(result).holds)  # True
