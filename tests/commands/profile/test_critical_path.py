"""Complete critical paths: each link with its end, cause and line.

A statement takes 1 ms. At 100 units/s with rates of 1000 units/s² a move takes 0.1 s to speed up and 0.1 s to
slow down, 5 units each. The first line has three statements.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from motionlang import profile, run
from motionlang.kernel import Source
from tests.cases import blocks

RATES = "SPEED(0, 1) = 100, 100; : ACCEL(0, 1) = 1000; : DECEL(0, 1) = 1000;\n"
WORLD = {
    "controller.instruction_time": 0.001,
    "input": [{"channel": 1, "at": 1.0}, {"channel": 2, "at": 2.0}],
}

FILE = Path(__file__).with_name("critical_path.txt")
PROGRAMS = blocks(FILE)


def shown(title: str, block: str) -> str:
    """Return a program with the links of its path: the end, the cause and the line of each.

    Further, the line that waited, the axes, the lines of the calls, and the task unless it is the parent.
    """
    text = [line for line in block.splitlines() if line.startswith((": ", "; "))]
    program = "".join(line[2:] + "\n" for line in text if line.startswith(": "))
    made = profile(run(Source("path.mnt", RATES + program), machine=WORLD))
    last = 0.0
    for begin, end, (cause, at, task, axes, waited) in made.spans():
        assert begin == last
        last = end
        text.append(
            f"{round(end, 6):g} s  {cause}  line {at.line}"
            + f"  waited at {waited}" * bool(waited)
            + f"  axes {' '.join(map(str, axes))}" * bool(axes)
            + f"  called from {' '.join(map(str, at.callers))}" * bool(at.callers)
            + f"  task {task}" * (task != "ParentTask")
        )
    return f"== {title}\n" + "".join(line + "\n" for line in text)


def test_every_link_of_a_critical_path(golden: Callable[[Path, str], None]) -> None:
    golden(FILE, "".join(shown(title, block) for title, block in PROGRAMS.items()))
