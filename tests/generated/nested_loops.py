"""Random programs of loops in loops that poll, copy what they read, count and wait, alone or beside tasks.

Each runs with its identical iterations skipped and with none skipped; the reports must be equal.

`python -m tests.generated.nested_loops 2000 --seed 1` compares that many programs and prints the seeds of those that
differ.
"""

from __future__ import annotations

import sys
from random import Random

from motionlang.kernel import Source, report, run
from tests.generated.compared import compare, is_equal_without_skipping

MACHINE: dict[str, object] = {"input": [{"channel": 0, "at": 0.11, "for": 0.07, "every": 0.31}]}
UNTIL = 1.0
_NAMES = "abcxy"
_READINGS = ("POS(0)", "VEL(0)", "POS(1)", "POS(0) - 3", "Abs(POS(0))", "2 + VEL(0)")
_SHOWN = "PRINT a; b; c; x; y; n; TIME; COMMS(1); COMMS(2); COMMS(3)"
_HEAD = "SPEED(0, 1) = 100, 80\nACCEL(0, 1) = 500, 300\na = 0 : b = 1 : c = 2 : x = 0 : y = 3 : n = 0"
# The deepest loop within loops.
_MAX_DEPTH = 2


class Program:
    """A random program, drawn from `random`."""

    def __init__(self, random: Random) -> None:
        self.random = random
        lines = ["Dim a As Integer, b As Integer, c As Float"] * (random.random() < 0.3)
        tasks = random.choice((0, 0, 0, 1, 2))
        lines += [f"Run T{number}" for number in range(tasks)] + [_HEAD]
        for _ in range(random.randint(1, 3)):
            lines.append(f"MOVEA(0) = {random.randint(20, 100)} : GO(0)")
            if random.random() < 0.4:
                lines.append(f"MOVEA(1) = {random.randint(0, 100)} : GO(1)")
            lines += [*self.loop(0), _SHOWN]
        lines.append("End")
        for number in range(tasks):
            body = [line for _ in range(random.randint(1, 2)) for line in self.statement(_MAX_DEPTH)]
            body += ["WAIT(3)"] * (random.random() < 0.2)
            lines += [f"Task T{number}", "Loop", *body, "End Loop", "End Task"]
        if random.random() < 0.15:
            lines += ["Event IN0", "n = n + a", "PRINT x; y", "End Event"]
        self.text = "\n".join([*lines, ""])

    def loop(self, depth: int) -> list[str]:
        """Return a loop of one of four kinds."""
        random, count = self.random, f"k{depth}"
        body = [line for _ in range(random.randint(1, 3)) for line in self.statement(depth)]
        kind = random.random()
        if kind < 0.4:
            return [f"While POS(0) < {random.randint(5, 95)} And IDLE(0) = 0", *body, "End While"]
        if kind < 0.6:
            most = random.choice((3, 30, 900))
            return [f"{count} = 0", f"While {count} < {most}", f"{count} = {count} + 1", *body, "End While"]
        if kind < 0.8:
            return [f"For {count} = 1 To {random.choice((2, 40, 300))}", *body, "Next"]
        return [f"{count} = 0", "Repeat", *body, f"{count} = {count} + 1", f"Until {count} > 500 Or INX(0)"]

    def statement(self, depth: int) -> list[str]:
        """Return the lines of a statement, which may be another loop."""
        random, kind = self.random, self.random.random()
        if kind < 0.4:
            return [self.assignment()]
        if kind < 0.52:
            return [f"COMMS({random.randint(1, 3)}) = {self.value()}"]
        if kind < 0.58:
            return [f"OUTX({random.randint(0, 2)}) = {self.condition()}"]
        if kind < 0.78:
            other = f" Else {self.assignment()}" if random.random() < 0.4 else ""
            return [f"If {self.condition()} Then {self.assignment()}{other}"]
        if kind < 0.83:
            action = random.choice(("PRINT a; x; TIME", "n = n + 1", "n = n + 1"))
            return [f"If {self.condition()} Then {action}"]
        if kind < 0.88:
            return [f"WAIT({random.choice((1, 2, 5))})"]
        return self.loop(depth + 1) if depth < _MAX_DEPTH else [self.assignment()]

    def assignment(self) -> str:
        return f"{self.random.choice(_NAMES)} = {self.value()}"

    def value(self) -> str:
        random, kind = self.random, self.random.random()
        name = random.choice(_NAMES)
        if kind < 0.35:
            return random.choice(_READINGS)
        if kind < 0.6:
            return name
        if kind < 0.8:
            return f"{name} {random.choice('+-')} {random.choice(('1', '2', '0.5', random.choice(_NAMES)))}"
        return f"{name} Mod {random.choice((3, 5, 7))}" if kind < 0.9 else str(random.randint(0, 5))

    def condition(self) -> str:
        random, name = self.random, self.random.choice(_NAMES)
        return random.choice(
            (
                f"POS(0) > {random.randint(1, 60)}",
                f"POS(0) > {random.randint(1, 60)}",
                f"VEL(0) > {random.randint(1, 60)}",
                "INX(0)",
                f"{name} > {random.randint(0, 40)}",
                f"{name} Mod 7 = {random.randint(0, 6)}",
                f"COMMS({random.randint(1, 3)}) > {random.randint(0, 50)}",
                f"{name} < {random.choice(_NAMES)}",
            )
        )


def shown(text: str) -> str:
    """Return the report of a run."""
    return report.text(run(Source("a.mnt", text), machine=MACHINE, until=UNTIL), whole=False)


def is_equal(seed: int) -> bool:
    """True if skipping does not change the report of the program of a seed."""
    text = Program(Random(seed)).text
    return is_equal_without_skipping(lambda: shown(text))


if __name__ == "__main__":
    sys.exit(compare("nested_loops", is_equal, 2000))
