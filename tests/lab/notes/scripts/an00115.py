"""Print the formulas of AN00115, and the moves of the note with the formula behind each figure.

`motionlang plan --plot FILE` draws the trapezoid of a move and the rectangle of the same area.
"""

from __future__ import annotations

from motionlang import plan
from motionlang.commands.plan.an00115 import FORMULAS, formulas

MOVES: dict[str, tuple[str | None, dict[str, float]]] = {
    "the first example": (None, {"distance": 12.0, "speed": 8.0, "accel": 16.0, "decel": 16.0}),
    "20 units in 600 ms by the third rule": ("third", {"distance": 20.0, "time": 0.6}),
    "20 units in 600 ms by the quarter rule": ("quarter", {"distance": 20.0, "time": 0.6}),
    "the exercise": (None, {"distance": 200.0, "time": 1.0, "accel_time": 0.2, "decel_time": 0.2}),
}

for formula in FORMULAS:
    print(f"{formula.figure.replace('_', ' '):<12}{formula.text}")
for title, (rule, given) in MOVES.items():
    move = plan(rule=rule, **given).figures()
    origins = formulas(move, given, rule)
    print(f"\n{title}")
    for name, value in move.items():
        print(f"{name.replace('_', ' '):<12}{value:<13.10g}{origins.get(name, 'given')}")
