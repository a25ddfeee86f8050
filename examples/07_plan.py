"""Find the missing figures of a move, and get the program for it."""

from motionlang import plan

move = plan(distance=20, time=0.6, rule="third")
print(f"{move.speed:.6g} uu/s, {move.accel:.6g} uu/s²")  # 50 uu/s, 250 uu/s²
print(move.program("mccl").splitlines()[-1])  # 1MR20,1WS0
try:
    plan(distance=20, time=0.6, rule="half")
except ValueError as error:
    print(error)  # there is no rule called half: third, quarter or equal
