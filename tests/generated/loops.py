"""Random loops of Mint over Integers near overflow, with identical iterations skipped and with none skipped.

Iterations in which a counter overflows must not be skipped. So the limits, steps and factors drawn here bring many
results near 2³¹.
"""

from __future__ import annotations

from random import Random
from typing import Any

from motionlang import run
from motionlang.kernel import Source
from tests.generated.compared import is_equal_without_skipping

INTEGERS, FLOATS = ("i", "j", "k", "m"), ("x", "y")
NEAR = (
    0, 1, 2, 3, 5, 7, 10, 100, 46_340, 46_341, 65_535, 65_536, 900_000_000, 1_073_741_823, 1_073_741_824,
    2_147_483_646, 2_147_483_647,
)  # fmt: skip
# The time limit of a program: more than any drawn loop needs, unless it never ends.
MAX_TIME = 0.02
DEPTH = 3


class Draw:
    """A random program from a seed."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        # Variables of the For loops around a statement, which it must not change, so that loops end.
        self.counters: list[str] = []

    def program(self) -> str:
        """Return a program that prints every variable at its end."""
        starts = [f"{name} = {self.number()}" for name in (*INTEGERS, *FLOATS) if self.random.random() < 0.4]
        body = [line for _ in range(self.random.randint(1, 3)) for line in self.statement(0)]
        names = (*INTEGERS, *FLOATS)
        lines = [
            "Dim i As Integer, j As Integer, k As Integer, m As Integer",
            "Dim x As Float, y As Float",
            *starts,
            *self.loop(0),
            *body,
            "PRINT " + ', " ", '.join(names),
        ]
        return "\n".join(lines) + "\n"

    def statement(self, depth: int) -> list[str]:
        """Return one statement, including nested ones."""
        kind = self.random.random()
        if depth < DEPTH and kind < 0.25:
            return self.loop(depth)
        if depth < DEPTH and kind < 0.45:
            return [
                f"If {self.condition()} Then",
                *self.block(depth),
                *(("Else", *self.block(depth)) if self.random.random() < 0.4 else ()),
                "End If",
            ]
        if kind < 0.5 and self.counters:
            return [f"If {self.condition()} Then Exit For"]
        return [f"{self.target()} = {self.value(2)}"]

    def block(self, depth: int) -> list[str]:
        """Return some statements, indented."""
        return [f"  {line}" for _ in range(self.random.randint(1, 3)) for line in self.statement(depth + 1)]

    def loop(self, depth: int) -> list[str]:
        """Return a For with few iterations, or a While or Repeat with a counter."""
        free = [name for name in INTEGERS if name not in self.counters]
        if len(free) < 2:
            return [f"{self.target()} = {self.value(2)}"]
        name, kind = self.random.choice(free), self.random.random()
        if kind < 0.7:
            start, step = self.number(), self.random.choice((1, 1, 1, 2, 3, -1, -1, -2, 65_536, 900_000_000))
            stop = start + step * self.random.randint(-1, 5) + self.random.choice((0, 0, 1, -1))
            spelled = f"{self.random.choice(free)}" if self.random.random() < 0.1 else f"{stop}"
            by = f" Step {step}" if step != 1 or self.random.random() < 0.2 else ""
            self.counters.append(name)
            body = self.block(depth)
            self.counters.pop()
            return [f"For {name} = {start} To {spelled}{by}", *body, "Next"]
        limit = self.random.randint(1, 6)
        self.counters.append(name)
        body = self.block(depth)
        self.counters.pop()
        body = [line.replace("Exit For", f"{name} = {limit}") for line in body]
        if kind < 0.85:
            return [f"{name} = 0", f"While {name} < {limit}", *body, f"  {name} = {name} + 1", "End While"]
        return [f"{name} = 0", "Repeat", *body, f"  {name} = {name} + 1", f"Until {name} >= {limit}"]

    def target(self) -> str:
        """Return a variable that may be written here."""
        free = [name for name in (*INTEGERS, *FLOATS) if name not in self.counters]
        return self.random.choice(free)

    def number(self) -> int:
        """Return an integer, often near the limits of Integer or of their square roots."""
        sign = -1 if self.random.random() < 0.3 else 1
        return sign * (self.random.choice(NEAR) if self.random.random() < 0.7 else self.random.randint(0, 20))

    def value(self, depth: int) -> str:
        """Return an expression."""
        kind = self.random.random()
        if depth == 0 or kind < 0.25:
            if self.random.random() < 0.6:
                return self.random.choice((*INTEGERS, *INTEGERS, *FLOATS))
            return str(self.number())
        if kind < 0.33:
            return f"{self.random.choice(('-', 'Abs', 'Int', '~'))}({self.value(depth - 1)})"
        operator = self.random.choice(("+", "+", "-", "-", "*", "*", "\\", "Mod", "&", "|", "/"))
        left, right = self.value(depth - 1), self.value(depth - 1)
        if operator in ("\\", "Mod", "/") and self.random.random() < 0.9:
            right = str(self.number() or 3)  # most programs should not end by a division by zero
        return f"({left} {operator} {right})"

    def condition(self) -> str:
        """Return one comparison, or two combined."""
        first = self.comparison()
        if self.random.random() < 0.25:
            return f"{first} {self.random.choice(('And', 'Or'))} {self.comparison()}"
        return f"Not ({first})" if self.random.random() < 0.1 else first

    def comparison(self) -> str:
        """Return a comparison of a variable with a number, or of two variables."""
        operator = self.random.choice(("=", "<>", "<", ">", "<=", ">="))
        return f"{self.random.choice(INTEGERS)} {operator} {self.value(self.random.choice((0, 0, 1)))}"


def outcome(text: str) -> dict[str, Any]:
    """Return a program's output, and how and where it ended."""
    result = run(Source("loop.mnt", text), machine={}, until=MAX_TIME)
    return {
        "output": result.output,
        "status": result.status,
        "time": result.time,
        "diagnostics": [(each.code, each.message, each.line, each.column) for each in result.diagnostics],
    }


def is_equal(seed: int) -> bool:
    """True if a program ends alike with its loops skipped and without."""
    text = Draw(seed).program()
    return is_equal_without_skipping(lambda: repr(outcome(text)))
