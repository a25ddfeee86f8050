"""Give a program the inputs and the answers that it waits for."""

import motionlang

program = motionlang.Source("wait.mnt", 'INPUT "Length ", x\nPAUSE INX(2)\nPRINT x, TIME\n')
run = motionlang.run(program, inputs={2: "1@0.5"}, answers=["120"])
print(run.status)  # ended
print(0.5 <= run.time < 0.501)  # True
