"""Run a program and read its status, its output and its moves."""

import motionlang

run = motionlang.run(
    motionlang.Source("feed.mnt", "SPEED(0) = 100\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n")
)
print(run.status)  # ended
print(run.output)  # ['200.0000']
print(run.moves[0].line, run.moves[0].distance)  # 2 200.0
print(run.report["axes"][0]["position"])  # 200.0
