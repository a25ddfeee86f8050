"""Run a program on a machine: settings by the keys of the machine file."""

import motionlang

program = motionlang.Source("two.mcl", "1TP\n2TP\n")
run = motionlang.run(program, machine={"controller.axes": 2})
print(list(run.controller.axes))  # [1, 2]
try:
    motionlang.run(program, machine={"controler.axes": 2})
except ValueError as error:
    print("controller.axes" in str(error))  # True
