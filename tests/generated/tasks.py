"""Random programs of two to four tasks that poll, wait and exchange variables.

Each program has a machine, and runs twice: once with its loops skipped, and once with every iteration
executed. The reports must be equal byte for byte. A program ends by itself or at `UNTIL`. The machine's last
input comes later, so in neither run is it known that no further event will come.

`python -m tests.generated.tasks 2000 --seed 1` compares that many programs and prints the seeds of those that
differ.
"""

from __future__ import annotations

import sys
from random import Random

from motionlang import run
from motionlang.kernel import Source, report
from tests.generated.compared import compare, is_equal_without_skipping

# The latest end of a run, machine seconds.
UNTIL = 1.5
# Durations of a statement: one with multiples at whole milliseconds, and one without.
COSTS = (1e-5, 0.7310585e-5)

_HEAD = """\
Dim a As Integer, b As Integer, c As Integer, x As Float
Dim v(4) As Integer
TIME = 0
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
"""
_SUBS = """\
Sub Bump(ByRef n As Integer)
  n = n + 1
  If n > 6 Then n = 0
End Sub
Sub Slowly(ByVal k As Integer)
  Dim i As Integer
  For i = 1 To k
    WAIT(3)
  Next
End Sub
Function Late(ByVal k As Integer) As Integer
  WAIT(2)
  Late = k
End Function
Function Either() As Integer
  Either = a + INX(1)
End Function
"""
_SHARED = ("a", "b", "c", "v(1)", "v(2)")
_CONDITIONS = (
    "a = 0", "a = 1", "b = 0", "b <> a", "c < 3", "v(1) = 0", "v(2) > v(1)", "INX(0)", "INX(1) = 0", "INX(2) And a",
    "TIME < 300", "TIME > 40", "TIME > 700", "TIME Mod 100 < 50", "IDLE(0)", "POS(0) > 6", "OUTX(1) = 0",
    "COMMS(1) = 0", "Either()", "b + Late(1) > 1", "c = 0",
)  # fmt: skip


class _Task:
    """The statements of one task, whose number `k` is in the names of its variables."""

    def __init__(self, random: Random, k: int) -> None:
        self._random, self._k = random, k

    def loop(self) -> list[str]:
        """Return the body of the task: an endless loop, or one that ends after 0.5 s."""
        body = self._statements(0)
        end = self._random.choice(
            (f"n{self._k} > {self._random.randint(2, 30)}", "TIME > 900", "INX(3)", "0")
        )
        return [
            "Repeat",
            *_indented([f"n{self._k} = n{self._k} + 1", *body] if "n" in end else body),
            f"Until {end}",
        ]

    def exchange(self, role: int, flags: list[str]) -> list[str]:
        """Return the body of a task that takes or gives values and counts them."""
        random, k = self._random, self._k
        flag, other = random.choice(flags), random.choice(flags)
        wait = f"WAIT({random.choice((1, 5, 10, 50, 100, random.randint(1, 70)))})"
        take = random.choice(
            ([f"While {flag} = 0", "End While"], ["Repeat", f"Until {flag} <> 0"],
             [f"While {flag} = 0", "  WAIT(2)", "End While"], ["Repeat", f"Until {flag} Or INX(1)"],
             ["Repeat", f"Until {flag} Or TIME > {random.randint(100, 1200)}"],
             [f"PAUSE {flag} <> 0"])
        )  # fmt: skip
        count = [
            f"n{k} = n{k} + 1",
            random.choice(
                (f"{other} = n{k}", "x = x + 1", "OUTX(1) = 1", f"Bump({other})", f"s{k} = 1 - s{k}")
            ),
        ]
        body = (
            [*take, f"{flag} = 0", *count] if role else [wait, f"{flag} = 1", *count[: random.randint(0, 2)]]
        )
        if random.random() < 0.5:
            body.insert(random.randint(0, len(body)) if role == 0 else len(body), wait)
        end = f"n{k} >= {random.randint(3, 25)}" if role else "0"
        return ["Repeat", *_indented(body), f"Until {end}"]

    def _statements(self, depth: int) -> list[str]:
        count = self._random.randint(1, 4 if depth == 0 else 2)
        return [line for _ in range(count) for line in self._statement(depth)]

    def _statement(self, depth: int) -> list[str]:
        random, k = self._random, self._k
        one, other, condition = random.choice(_SHARED), random.choice(_SHARED), random.choice(_CONDITIONS)
        kind = random.randrange(20 if depth < 2 else 14)
        if kind == 0:
            return [f"{one} = {random.randint(0, 2)}"]
        if kind == 1:
            return [f"{one} = {other}"]
        if kind == 2:
            return [random.choice((f"{one} = 1 - {one}", f"Bump({one})", f"s{k} = s{k} + 1"))]
        if kind <= 6:
            return [
                random.choice(
                    (f"WAIT({random.choice((1, 2, 5, 10, 20, 50, 100))})", f"WAIT({random.randint(1, 60)})")
                )
            ]
        if kind == 7:
            return [
                random.choice(
                    (f"OUTX(1) = INX({random.randint(0, 2)})", "OUTX(2) = 1", "COMMS(1) = 4", "COMMS(2) = x")
                )
            ]
        if kind == 8:
            return [
                random.choice(
                    (f"s{k} = INX({random.randint(0, 3)})", "x = POS(0)", "x = TIME", f"s{k} = {one}")
                )
            ]
        if kind == 9:
            return [f"If {condition} Then {one} = {random.randint(0, 2)}"]
        if kind == 10:
            return [
                random.choice(
                    (f"Slowly({random.randint(1, 3)})", f"s{k} = {one} + Late(1)", f"{one} = Either()")
                )
            ]
        if kind == 11:
            return [
                f"If s{k} < {random.randint(1, 5)} And {condition} Then",
                f"  s{k} = s{k} + 1",
                f"  {self._act()}",
                "End If",
            ]
        if kind == 12:
            return [
                f"For i{k} = 1 To 4",
                f"  v(i{k}) = INX(i{k} - 1) + v(i{k}) * {random.randint(0, 1)}",
                "Next",
            ]
        if kind == 13:
            return [
                f"PAUSE {random.choice(('a = 0', 'b = 0', 'INX(1)', 'INX(0) = 0', 'IDLE(0)', 'TIME > 200'))}"
            ]
        if kind <= 17:
            body = self._statements(depth + 1) if random.random() < 0.4 else []
            return [f"While {condition}", *_indented(body), "End While"]
        return [f"If {condition} Then", *_indented(self._statements(depth + 1)), "End If"]

    def _act(self) -> str:
        return self._random.choice(
            ("OUTX(1) = 1", "OUTX(1) = 0", "COMMS(1) = 1", "COMMS(1) = 0", 'PRINT "act ", TIME', "MOVER(0) = 3 : GO(0)",
             "TIME = 0", "JOG(0) = 5", "STOP(0)")
        )  # fmt: skip


def program(seed: int) -> tuple[str, dict[str, object]]:
    """Return a program and its machine."""
    random = Random(seed)
    tasks = random.randint(2, 4)
    names = range(tasks)
    lines = [_HEAD, *(f"Dim n{k} As Integer, s{k} As Integer, i{k} As Integer" for k in names)]
    lines += [f"Run T{k}" for k in names if k]
    flags = random.sample(_SHARED, random.randint(1, 2))
    exchanges = random.random() < 0.5
    bodies = [
        _Task(random, k).exchange(1 - k % 2, flags) if exchanges else _Task(random, k).loop() for k in names
    ]
    lines += bodies[0]
    lines += [
        'PRINT "end ", TIME, " ", a, b, c, " ", v(1), v(2), v(3), v(4), " ", x, " ", n0, " ", s0',
        "End",
    ]
    for k in names[1:]:
        lines += [f"Task T{k}", *_indented(bodies[k]), f'  PRINT "T{k} ", TIME', "End Task"]
    inputs: list[dict[str, object]] = [{"channel": 7, "at": 2 * UNTIL}]
    inputs += [
        {
            "channel": random.randint(0, 3),
            "at": round(random.uniform(0, 1.2), 4),
            "for": round(random.uniform(0.001, 0.4), 4),
        }
        for _ in range(random.randint(0, 3))
    ]
    return "\n".join([*lines, _SUBS]), {"controller.instruction_time": random.choice(COSTS), "input": inputs}


def _indented(lines: list[str]) -> list[str]:
    return [f"  {line}" for line in lines]


def document(text: str, machine: dict[str, object]) -> str:
    """Return the report of a run."""
    return report.text(run(Source("a.mnt", text), machine=machine, until=UNTIL))


def is_equal(seed: int) -> bool:
    """True if a program has the same report with its loops skipped and without."""
    given = program(seed)
    return is_equal_without_skipping(lambda: document(*given))


if __name__ == "__main__":
    sys.exit(compare("tasks", is_equal, 2000))
