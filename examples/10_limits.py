"""Certify the limits of a machine, and verify the motion.

The motion has violations among the diagnostics of the run if it breaks continuity, an end or an extreme.
"""

from motionlang import Source, certify, run

text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"
result = run(Source("feed.mnt", text), machine={"axis.0.limits.speed": 125.0})
for limit in certify(result):
    print(limit.name, limit.verdict, f"{limit.margin:.0%} left")  # speed within 20% left
print(result.diagnostics)  # []
